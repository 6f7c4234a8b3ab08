//! How much shear a cell in contact can carry.

use std::borrow::Cow;

use crate::error::{Result, all_non_negative, non_negative, positive};
use crate::grid::Grid;
use crate::grid::field::{Field, clone_in_place};
use crate::grid::per_cell::PerCell;
use crate::grid::window::Window;
use crate::half_space::{HalfSpace, Region};
use crate::memory::fallible::try_clone;

/// Coulomb friction, uniform or one coefficient per cell, optionally capped.
///
/// The friction limit of a cell is `m = min(mu p, tau_max)`, a pressure.
///
/// ```
/// use stickslip::Friction;
/// let capped = Friction::coulomb(0.5)?.max_shear_stress(300e6)?;
/// assert_eq!(capped.limit(0, 400e6), 200e6);
/// assert_eq!(capped.limit(0, 900e6), 300e6);
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
    /// `None` without a cap.
    max_shear_stress: Option<f64>,
}

/// What was read, before it is checked.
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
    /// One coefficient of friction mu >= 0 for all cells (dimensionless).
    ///
    /// # Errors
    /// [`Error::NegativeOrNotFinite`](crate::Error::NegativeOrNotFinite).
    pub fn coulomb(coefficient: f64) -> Result<Self> {
        Ok(Self {
            coefficient: PerCell::Uniform(non_negative("coefficient of friction", coefficient)?),
            max_shear_stress: None,
        })
    }

    /// One coefficient of friction mu >= 0 per cell.
    ///
    /// # Errors
    /// [`Error::Sample`](crate::Error::Sample) at the first coefficient that is negative or not finite.
    pub fn per_cell(coefficients: Field) -> Result<Self> {
        all_non_negative("coefficient of friction", coefficients.as_slice())?;
        Ok(Self {
            coefficient: PerCell::Cells(coefficients),
            max_shear_stress: None,
        })
    }

    /// With the limit capped at `tau_max` (a pressure), the shear strength of the weaker body.
    ///
    /// # Errors
    /// [`Error::NotPositive`](crate::Error::NotPositive).
    pub fn max_shear_stress(mut self, tau_max: f64) -> Result<Self> {
        self.max_shear_stress = Some(positive("shear cap", tau_max)?);
        Ok(self)
    }

    /// The coefficients of the cells, given back; `None` where one holds for all. A loop in which friction changes from
    /// step to step so needs one array for all steps.
    ///
    /// ```
    /// use stickslip::{Field, Friction, Grid};
    /// let mut coefficients = Field::constant(Grid::square(32, 1.0)?, 0.3);
    /// for _ in 0..3 {
    ///     let friction = Friction::per_cell(coefficients)?;
    ///     // `history.set_friction(&friction)?`, a step, and what it wears ...
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

    /// The friction limit of cell `index` (row-major) under pressure `pressure`; NaN for a cell
    /// beyond the field of coefficients.
    #[must_use]
    pub fn limit(&self, index: usize, pressure: f64) -> f64 {
        let (limit, cap) = (self.coefficient_at(index) * pressure, self.cap());
        // A minimum would pass over NaN.
        if limit > cap { cap } else { limit }
    }

    /// That of the cells of a region.
    pub(crate) fn within(&self, region: &Region) -> FrictionWithin<'_> {
        let PerCell::Cells(field) = &self.coefficient else {
            return FrictionWithin::of(self, region);
        };
        if !region.is_shared() {
            return FrictionWithin::of(self, region);
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

    /// The friction of the cells of `coarser`, twice as large as those of the bodies that this is on.
    pub(crate) fn coarsened(&self, bodies: &HalfSpace, coarser: &HalfSpace) -> Result<Self> {
        let coarsened = |cells: &Field| bodies.coarsened_field(coarser, cells);
        Ok(Self {
            coefficient: self.coefficient.try_map(coarsened)?,
            max_shear_stress: self.max_shear_stress,
        })
    }

    /// The largest coefficient of all cells of the grid.
    pub(crate) fn largest_coefficient(&self, bodies: &HalfSpace) -> f64 {
        match &self.coefficient {
            PerCell::Uniform(coefficient) => *coefficient,
            PerCell::Cells(field) => bodies.largest(field),
        }
    }

    /// Whether the limits add up to a multiple of the normal force however that is distributed.
    pub(crate) fn is_proportional(&self) -> bool {
        matches!(self.coefficient, PerCell::Uniform(_)) && self.max_shear_stress.is_none()
    }

    fn coefficient_at(&self, index: usize) -> f64 {
        self.coefficient.map(Field::as_slice).of(index)
    }

    fn cap(&self) -> f64 {
        self.max_shear_stress.unwrap_or(f64::INFINITY)
    }

    /// How the limit of a cell grows with its pressure.
    pub(crate) fn slope(&self, index: usize, pressure: f64) -> f64 {
        let coefficient = self.coefficient_at(index);
        if coefficient * pressure < self.cap() {
            coefficient
        } else {
            0.0
        }
    }

    /// The coefficient and the cap (`None` without a cap). A change must keep the rules of the
    /// constructors.
    pub(crate) fn parts_mut(&mut self) -> (&mut PerCell<Field>, &mut Option<f64>) {
        (&mut self.coefficient, &mut self.max_shear_stress)
    }

    /// `Ok` if the coefficients fit the cells held here, on all ranks, which must have the same but for these.
    pub(crate) fn check_on(&self, bodies: &HalfSpace) -> Result<()> {
        bodies.collective_result_checked(self.check(bodies.grid()), &[("friction", &self.common())])
    }

    /// That of it which is the same on all ranks: coefficient, unless it is one per cell, and cap.
    pub(crate) fn common(&self) -> (PerCell<()>, Option<f64>) {
        (self.coefficient.map(|_| ()), self.max_shear_stress)
    }

    /// `Ok` if the coefficients fit the grid.
    pub(crate) fn check(&self, grid: Grid) -> Result<()> {
        self.coefficient.check("coefficient of friction", grid)
    }
}

/// The friction of the cells of a region, in its own order.
#[derive(Debug)]
pub(crate) struct FrictionWithin<'a> {
    friction: Cow<'a, Friction>,
    /// The cells of the friction that are those of the region; `None` if they all are.
    window: Option<Window>,
}

impl<'a> FrictionWithin<'a> {
    /// Of a friction that is uniform, or has the coefficients of all cells.
    fn of(friction: &'a Friction, region: &Region) -> Self {
        Self {
            friction: Cow::Borrowed(friction),
            window: Some(region.own()),
        }
    }

    fn place(&self, cell: usize) -> usize {
        self.window.map_or(cell, |window| window.index(cell))
    }

    /// Returns the limit of a cell under a pressure.
    pub(crate) fn limit(&self, cell: usize, pressure: f64) -> f64 {
        self.friction.limit(self.place(cell), pressure)
    }

    /// Returns the derivative of the limit with respect to the pressure.
    pub(crate) fn slope(&self, cell: usize, pressure: f64) -> f64 {
        self.friction.slope(self.place(cell), pressure)
    }
}
