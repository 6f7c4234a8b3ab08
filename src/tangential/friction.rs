//! How much shear a cell in contact can carry.

use crate::error::{Result, all_non_negative, non_negative, positive};
use crate::field::{Field, clone_in_place};
use crate::grid::Grid;
use crate::window::coarsened;

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
    serde(try_from = "Unchecked")
)]
pub struct Friction {
    coefficient: Coefficient,
    /// `None` without a cap.
    max_shear_stress: Option<f64>,
}

/// What was read, before it is checked.
#[cfg(feature = "serde")]
#[derive(serde::Deserialize)]
#[serde(deny_unknown_fields)]
struct Unchecked {
    coefficient: Coefficient,
    max_shear_stress: Option<f64>,
}

#[cfg(feature = "serde")]
impl TryFrom<Unchecked> for Friction {
    type Error = crate::error::Error;

    fn try_from(read: Unchecked) -> Result<Self> {
        let friction = match read.coefficient {
            Coefficient::Uniform(coefficient) => Self::coulomb(coefficient)?,
            Coefficient::PerCell(coefficients) => Self::per_cell(coefficients)?,
        };
        match read.max_shear_stress {
            Some(tau_max) => friction.max_shear_stress(tau_max),
            None => Ok(friction),
        }
    }
}

/// The coefficient of friction.
#[derive(Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub(crate) enum Coefficient {
    Uniform(f64),
    PerCell(Field),
}

clone_in_place!(Friction {
    coefficient,
    max_shear_stress
});

impl Clone for Coefficient {
    fn clone(&self) -> Self {
        match self {
            Self::Uniform(coefficient) => Self::Uniform(*coefficient),
            Self::PerCell(field) => Self::PerCell(field.clone()),
        }
    }

    fn clone_from(&mut self, source: &Self) {
        match (self, source) {
            (Self::PerCell(own), Self::PerCell(field)) => own.clone_from(field),
            (own, source) => *own = source.clone(),
        }
    }
}

impl Friction {
    /// One coefficient of friction mu >= 0 for all cells (dimensionless).
    ///
    /// # Errors
    /// [`Error::Negative`](crate::Error::Negative).
    pub fn coulomb(coefficient: f64) -> Result<Self> {
        Ok(Self {
            coefficient: Coefficient::Uniform(non_negative(
                "coefficient of friction",
                coefficient,
            )?),
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
            coefficient: Coefficient::PerCell(coefficients),
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

    /// The friction limit of cell `index` (row-major) under pressure `pressure`; NaN for a cell
    /// beyond the field of coefficients.
    #[must_use]
    pub fn limit(&self, index: usize, pressure: f64) -> f64 {
        let (limit, cap) = (self.coefficient_at(index) * pressure, self.cap());
        // A minimum would pass over NaN.
        if limit > cap { cap } else { limit }
    }

    /// The friction of cells twice as large.
    pub(crate) fn coarsened(&self, size: [usize; 2], grid: Grid) -> Result<Self> {
        let coefficient = match &self.coefficient {
            Coefficient::Uniform(coefficient) => Coefficient::Uniform(*coefficient),
            Coefficient::PerCell(field) => {
                Coefficient::PerCell(Field::from_vec(grid, coarsened(size, field.as_slice()))?)
            }
        };
        Ok(Self {
            coefficient,
            max_shear_stress: self.max_shear_stress,
        })
    }

    /// The largest coefficient of all cells.
    pub(crate) fn largest_coefficient(&self) -> f64 {
        match &self.coefficient {
            Coefficient::Uniform(coefficient) => *coefficient,
            Coefficient::PerCell(field) => field.max(),
        }
    }

    fn coefficient_at(&self, index: usize) -> f64 {
        match &self.coefficient {
            Coefficient::Uniform(coefficient) => *coefficient,
            Coefficient::PerCell(field) => field.as_slice().get(index).copied().unwrap_or(f64::NAN),
        }
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
    pub(crate) fn parts_mut(&mut self) -> (&mut Coefficient, &mut Option<f64>) {
        (&mut self.coefficient, &mut self.max_shear_stress)
    }

    /// `Ok` if the coefficients fit the grid.
    pub(crate) fn check(&self, grid: Grid) -> Result<()> {
        match &self.coefficient {
            Coefficient::PerCell(field) => grid.expect("coefficient of friction", field.grid()),
            Coefficient::Uniform(_) => Ok(()),
        }
    }
}
