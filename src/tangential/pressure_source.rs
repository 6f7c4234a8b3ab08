//! Pressure of a tangential contact.

use crate::error::{Error, Result, all_non_negative, check_converged};
use crate::grid::field::Field;
use crate::grid::window::Window;
use crate::half_space::HalfSpace;
use crate::normal::NormalSolution;

/// Pressure of a tangential contact, from a solved normal contact or from another source.
///
/// A prescribed pressure (pressures, zero outside the contact) may come from a closed form or a measurement. It may
/// also come from a code whose model of the normal contact includes more than elasticity.
///
/// ```
/// use stickslip::analytical::{CattaneoMindlin, HertzSphere};
/// use stickslip::*;
/// let grid = Grid::square(64, 0.30e-3)?;
/// let steel = Material::new(213e9, 0.29)?;
/// let bodies = HalfSpace::new(grid, ElasticPair::new(steel, steel)?)?;
/// let hertz = HertzSphere::new(bodies.pair(), 3.5e-3, 100.0)?;
/// let pressure = Field::from_fn(grid, |x, y| hertz.pressure(x.hypot(y)));
/// let load = TangentialLoad::force([20.0, 0.0]);
/// let tangential = TangentialProblem::builder(&bodies, &pressure, Friction::coulomb(0.5)?, load)
///     .build()?
///     .solve()?;
/// let exact = CattaneoMindlin::new(hertz, 0.5, 20.0)?;
/// assert!((tangential.shift()[0] / exact.shift() - 1.0).abs() < 1e-3);
/// # Ok::<(), stickslip::Error>(())
/// ```
#[derive(Debug, Clone, Copy)]
#[non_exhaustive]
pub enum PressureSource<'a> {
    /// Pressure of a converged normal contact on the same bodies and materials.
    Solved(&'a NormalSolution),
    /// Pressure of each cell, non-negative and finite. The pressure may belong to any bodies. Its unit must be the unit of their
    /// moduli. A pressure far below the contact modulus has the warning [`LowPressure`](crate::Warning::LowPressure). A pressure
    /// above half of this modulus has the warning [`PressureBeyondModulus`](crate::Warning::PressureBeyondModulus).
    Prescribed(&'a Field),
}

impl<'a> From<&'a NormalSolution> for PressureSource<'a> {
    fn from(solution: &'a NormalSolution) -> Self {
        Self::Solved(solution)
    }
}

impl<'a> From<&'a Field> for PressureSource<'a> {
    fn from(pressure: &'a Field) -> Self {
        Self::Prescribed(pressure)
    }
}

impl<'a> PressureSource<'a> {
    /// Returns whether the pressure is a field.
    pub(crate) fn is_prescribed(self) -> bool {
        matches!(self, Self::Prescribed(_))
    }

    /// Returns the pressure of every cell, or an error if the pressure is not valid on these bodies.
    pub(crate) fn checked(self, bodies: &HalfSpace) -> Result<&'a [f64]> {
        match self {
            Self::Solved(normal) => {
                check_bodies(normal, bodies)?;
                check_converged(normal.report())?;
                Ok(normal.pressure().as_slice())
            }
            Self::Prescribed(pressure) => {
                bodies.grid().check_equal("pressure", pressure.grid())?;
                all_non_negative("pressure", pressure.as_slice())?;
                Ok(pressure.as_slice())
            }
        }
    }
}

/// Returns an error if a normal solution, converged or not, does not belong to these bodies.
pub(crate) fn check_bodies(normal: &NormalSolution, bodies: &HalfSpace) -> Result<()> {
    let quantity = "normal solution";
    bodies.check_host(quantity, normal.grid(), normal.boundary())?;
    bodies.check_values(quantity, normal.cell_value())?;
    bodies.check_pair(quantity, normal.pair())
}

/// Returns the smallest window that contains all cells with pressure. It covers the whole grid along a periodic axis.
pub(crate) fn contact_window(bodies: &HalfSpace, pressure: &[f64]) -> Result<Window> {
    let contact = bodies.around(|i| pressure[i] > 0.0);
    contact
        .map(|window| bodies.restrict_to_window(window))
        .ok_or(Error::EmptyContact)
}
