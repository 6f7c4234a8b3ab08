//! Friction: the limit of the shear traction in a contact cell.

use std::borrow::Cow;

use crate::cgm::reduce;
use crate::error::{
    ROLL, ROLL_UNDER_CAP, Result, SLIDE, SLIDE_UNDER_CAP, all_non_negative, non_negative, positive,
};
use crate::grid::Grid;
use crate::grid::field::{Field, clone_in_place};
use crate::grid::per_cell::PerCell;
use crate::grid::window::Window;
use crate::half_space::{HalfSpace, Region};
use crate::memory::fallible::try_clone;
use crate::parallel::layout::Layout;

/// Coulomb friction with a uniform coefficient or a coefficient per cell, and an optional cap.
///
/// The friction limit of a cell is `m = min(mu p, tau_max)`, a pressure. The cap is part of the friction. A function `set_friction`
/// therefore keeps a cap only if the new friction has the same cap.
///
/// ```
/// use stickslip::Friction;
/// let capped = Friction::coulomb(0.5)?.max_shear_stress(300e6)?;
/// assert_eq!(capped.limit(0, 400e6), 200e6);
/// assert_eq!(capped.limit(0, 900e6), 300e6);
/// assert_eq!(capped.cap(), Some(300e6));
/// # Ok::<(), stickslip::Error>(())
/// ```
#[derive(Debug, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(try_from = "RawFriction")
)]
pub struct Friction {
    coefficient: PerCell<Field>,
    /// Cap of the limit, or `None` without a cap.
    max_shear_stress: Option<f64>,
}

/// Deserialised value before validation.
#[cfg(feature = "serde")]
#[derive(serde::Deserialize)]
#[serde(deny_unknown_fields)]
struct RawFriction {
    coefficient: PerCell<Field>,
    max_shear_stress: Option<f64>,
}

#[cfg(feature = "serde")]
impl TryFrom<RawFriction> for Friction {
    type Error = crate::error::Error;

    fn try_from(read: RawFriction) -> Result<Self> {
        let friction = match read.coefficient {
            PerCell::Uniform(coefficient) => Self::coulomb(coefficient)?,
            PerCell::Cells(coefficients) => Self::per_cell(coefficients)?,
        };
        match read.max_shear_stress {
            Some(tau_max) => friction.max_shear_stress(tau_max),
            None => Ok(friction),
        }
    }
}

clone_in_place!(Friction {
    coefficient,
    max_shear_stress
});

try_clone!(Friction { coefficient } { max_shear_stress });

impl Friction {
    /// Creates friction with a uniform coefficient mu >= 0 (dimensionless).
    ///
    /// # Errors
    /// - [`Error::NegativeOrNotFinite`](crate::Error::NegativeOrNotFinite) if the coefficient is negative or not finite.
    pub fn coulomb(coefficient: f64) -> Result<Self> {
        Ok(Self {
            coefficient: PerCell::Uniform(non_negative("coefficient of friction", coefficient)?),
            max_shear_stress: None,
        })
    }

    /// Creates friction with a coefficient mu >= 0 for each cell. Cells with a large coefficient, such as 1e6, stick under any load.
    /// A solve limits their tractions to 1e20 of the largest pressure.
    ///
    /// # Errors
    /// - [`Error::Sample`](crate::Error::Sample) at the first coefficient that is negative or not finite.
    pub fn per_cell(coefficients: Field) -> Result<Self> {
        all_non_negative("coefficient of friction", coefficients.as_slice())?;
        Ok(Self {
            coefficient: PerCell::Cells(coefficients),
            max_shear_stress: None,
        })
    }

    /// Caps the limit at `tau_max` (a pressure), the shear strength of the weaker body.
    ///
    /// # Errors
    /// - [`Error::NotPositive`](crate::Error::NotPositive) if `tau_max` is not positive and finite.
    pub fn max_shear_stress(mut self, tau_max: f64) -> Result<Self> {
        self.max_shear_stress = Some(positive("largest shear stress", tau_max)?);
        Ok(self)
    }

    /// Returns the cap of the limit (a pressure), or `None` without a cap.
    #[must_use]
    pub fn cap(&self) -> Option<f64> {
        self.max_shear_stress
    }

    /// Returns the owned field of coefficients, or `None` if the coefficient is uniform. A loop that changes the
    /// friction from step to step can thus reuse one array for all steps.
    ///
    /// ```
    /// use stickslip::{Field, Friction, Grid};
    /// let mut coefficients = Field::constant(Grid::square(32, 1.0)?, 0.3);
    /// for _ in 0..3 {
    ///     let friction = Friction::per_cell(coefficients)?;
    ///     // `history.set_friction(&friction)?`, a step, and the change of friction by wear ...
    ///     coefficients = friction.into_coefficients().expect("friction per cell");
    ///     coefficients.as_mut_slice()[0] += 0.1;
    /// }
    /// assert!((Friction::per_cell(coefficients)?.limit(0, 2.0) - 1.2).abs() < 1e-12);
    /// # Ok::<(), stickslip::Error>(())
    /// ```
    #[must_use]
    pub fn into_coefficients(self) -> Option<Field> {
        match self.coefficient {
            PerCell::Cells(coefficients) => Some(coefficients),
            PerCell::Uniform(_) => None,
        }
    }

    /// Returns the friction limit of cell `index` (row-major) under `pressure`, or NaN for a cell outside the field of
    /// coefficients.
    #[must_use]
    pub fn limit(&self, index: usize, pressure: f64) -> f64 {
        limited(
            self.coefficient_at(index) * pressure,
            self.cap_or_infinity(),
        )
    }

    /// Returns the friction of the cells of a region.
    pub(crate) fn within(&self, region: &Region) -> FrictionWithin<'_> {
        let borrowed = |window| FrictionWithin {
            friction: Cow::Borrowed(self),
            window,
        };
        let PerCell::Cells(field) = &self.coefficient else {
            return borrowed(None);
        };
        if !region.is_shared() {
            return borrowed(Some(region.own()));
        }
        let mut cells = Field::zeros(field.grid().of_size(region.own().size));
        region.gather(field.as_slice(), cells.as_mut_slice());
        FrictionWithin {
            friction: Cow::Owned(Self {
                coefficient: PerCell::Cells(cells),
                max_shear_stress: self.max_shear_stress,
            }),
            window: None,
        }
    }

    /// Restricts the friction to the cells of `coarser`, which have twice the side length of the cells of `bodies`.
    pub(crate) fn coarsened(&self, bodies: &HalfSpace, coarser: &HalfSpace) -> Result<Self> {
        let coarsened = |cells: &Field| bodies.coarsened_field(coarser, cells);
        Ok(Self {
            coefficient: self.coefficient.try_map(coarsened)?,
            max_shear_stress: self.max_shear_stress,
        })
    }

    /// Returns the largest coefficient of all cells of the grid.
    pub(crate) fn largest_coefficient(&self, bodies: &HalfSpace) -> f64 {
        match &self.coefficient {
            PerCell::Uniform(coefficient) => *coefficient,
            PerCell::Cells(field) => bodies.largest(field),
        }
    }

    /// Returns whether all cells have the same coefficient.
    pub(super) fn is_uniform(&self) -> bool {
        matches!(self.coefficient, PerCell::Uniform(_))
    }

    /// Returns whether the sum of the limits is a fixed multiple of the normal force for any distribution of the
    /// pressure.
    pub(crate) fn is_proportional(&self) -> bool {
        self.is_uniform() && self.max_shear_stress.is_none()
    }

    /// Returns the remedy for a force beyond the sum of the limits.
    pub(crate) fn remedy(&self) -> &'static str {
        if self.max_shear_stress.is_some() {
            SLIDE_UNDER_CAP
        } else {
            SLIDE
        }
    }

    /// Returns the remedy for a force of rolling bodies beyond the sum of the limits.
    pub(crate) fn rolling_remedy(&self) -> &'static str {
        if self.max_shear_stress.is_some() {
            ROLL_UNDER_CAP
        } else {
            ROLL
        }
    }

    fn coefficient_at(&self, index: usize) -> f64 {
        self.coefficients().of(index)
    }

    pub(crate) fn coefficients(&self) -> PerCell<&[f64]> {
        self.coefficient.map(Field::as_slice)
    }

    fn cap_or_infinity(&self) -> f64 {
        self.max_shear_stress.unwrap_or(f64::INFINITY)
    }

    /// Returns the derivative of the friction limit of a cell with respect to its pressure.
    pub(crate) fn slope(&self, index: usize, pressure: f64) -> f64 {
        let coefficient = self.coefficient_at(index);
        if self.is_capped(index, pressure) {
            0.0
        } else {
            coefficient
        }
    }

    /// Returns the derivative of the friction limit of a cell with respect to its coefficient.
    fn slope_by_coefficient(&self, index: usize, pressure: f64) -> f64 {
        if self.is_capped(index, pressure) {
            0.0
        } else {
            pressure
        }
    }

    fn is_capped(&self, index: usize, pressure: f64) -> bool {
        self.coefficient_at(index) * pressure >= self.cap_or_infinity()
    }

    /// Returns the coefficient and the cap (`None` without a cap) for restoring a saved state. A change must satisfy
    /// the conditions of the constructors.
    pub(crate) fn parts_mut(&mut self) -> (&mut PerCell<Field>, &mut Option<f64>) {
        (&mut self.coefficient, &mut self.max_shear_stress)
    }

    /// Checks on all ranks that the coefficients fit the local cells and that all other properties agree.
    pub(crate) fn check_on(&self, bodies: &HalfSpace) -> Result<()> {
        bodies.collective_result_checked(self.check(bodies.grid()), &[("friction", &self.common())])
    }

    /// Returns the properties that must agree on all ranks. These are the cap and a uniform coefficient.
    pub(crate) fn common(&self) -> (PerCell<()>, Option<f64>) {
        (self.coefficient.map(|_| ()), self.max_shear_stress)
    }

    /// Returns an error if the coefficients do not fit the grid.
    pub(crate) fn check(&self, grid: Grid) -> Result<()> {
        self.coefficient.check("coefficient of friction", grid)
    }
}

/// Returns the smaller value, or NaN if the limit is NaN. `f64::min` would discard NaN.
#[inline]
fn limited(limit: f64, cap: f64) -> f64 {
    if limit > cap { cap } else { limit }
}

/// Friction of the cells of a region, in the order of the region.
#[derive(Debug)]
pub(crate) struct FrictionWithin<'a> {
    friction: Cow<'a, Friction>,
    /// Window of the region in the cells of the friction. `None` if the friction is uniform or has coefficients for
    /// exactly the region.
    window: Option<Window>,
}

impl FrictionWithin<'_> {
    fn place(&self, cell: usize) -> usize {
        self.window.map_or(cell, |window| window.index(cell))
    }

    /// Writes the limits of consecutive cells under these pressures. The first cell has the index `first`.
    pub(crate) fn write_limits(&self, first: usize, pressure: &[f64], limits: &mut [f64]) {
        let (coefficients, cap) = (
            self.friction.coefficients(),
            self.friction.cap_or_infinity(),
        );
        for (cell, (limit, pressure)) in limits.iter_mut().zip(pressure).enumerate() {
            *limit = if *pressure > 0.0 {
                limited(coefficients.of(self.place(first + cell)) * pressure, cap)
            } else {
                0.0
            };
        }
    }

    /// Returns the friction capacities without and with the cap, or `None` without a cap. The function is collective.
    pub(crate) fn capacities(&self, layout: &Layout, pressure: &[f64]) -> Option<[f64; 2]> {
        let cap = self.friction.max_shear_stress?;
        let coefficients = self.friction.coefficients();
        Some(reduce::sum(layout, |cell| {
            let limit = coefficients.of(self.place(cell)) * pressure[cell];
            [limit, limited(limit, cap)]
        }))
    }

    /// Returns the limit of a cell under a pressure.
    pub(crate) fn limit(&self, cell: usize, pressure: f64) -> f64 {
        self.friction.limit(self.place(cell), pressure)
    }

    /// Returns the derivative of the limit with respect to the pressure.
    pub(crate) fn slope(&self, cell: usize, pressure: f64) -> f64 {
        self.friction.slope(self.place(cell), pressure)
    }

    /// Returns the derivative of the limit with respect to the coefficient.
    pub(crate) fn slope_by_coefficient(&self, cell: usize, pressure: f64) -> f64 {
        self.friction
            .slope_by_coefficient(self.place(cell), pressure)
    }
}
