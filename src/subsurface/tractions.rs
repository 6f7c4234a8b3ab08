//! What acts on the surface of the bodies.

use crate::boundary::Boundary;
use crate::coupled::CoupledSolution;
use crate::error::{Error, Result};
use crate::field::Field;
use crate::half_space::HalfSpace;
use crate::history::{History, State};
use crate::material::ElasticPair;
use crate::normal::NormalSolution;
use crate::tangential::TangentialSolution;

/// Pressure and tractions on the surface (pressures), from fields or from a solution: those of a [`NormalSolution`], of a
/// pair of one and a [`TangentialSolution`], of a [`CoupledSolution`], a [`History`] or a [`State`].
///
/// Signs as everywhere: a positive pressure is compression, the tractions are those on body 1 along x and y.
///
/// ```
/// use stickslip::subsurface::{Body, Tractions, at_points};
/// use stickslip::*;
/// let grid = Grid::square(15, 1.0)?;
/// let rubber = Material::new(1.0, 0.5)?;
/// let bodies = HalfSpace::new(grid, ElasticPair::new(rubber, Material::rigid())?)?;
/// let (p, q, none) = (Field::constant(grid, 2.0), Field::constant(grid, 1.0), Field::zeros(grid));
/// let sliding = Tractions::new(&p).with_shear([&q, &none]);
/// // The surface under the load.
/// let stress = at_points(&bodies, Body::One, sliding, &[[0.0, 0.0, 0.0]])?[0].stress;
/// assert!((stress.zz + 2.0).abs() < 1e-14 && (stress.xz + 1.0).abs() < 1e-14);
/// # Ok::<(), Error>(())
/// ```
#[derive(Debug, Clone, Copy)]
pub struct Tractions<'a> {
    pressure: &'a Field,
    shear: Option<[&'a Field; 2]>,
    /// Surroundings and bodies of the solution that they come from.
    host: Option<(Boundary, &'a ElasticPair)>,
}

impl<'a> Tractions<'a> {
    /// A pressure (positive in compression), without shear.
    #[must_use]
    pub fn new(pressure: &'a Field) -> Self {
        Self {
            pressure,
            shear: None,
            host: None,
        }
    }

    /// With tractions along x and y (pressures) on body 1, in place of those it had.
    #[must_use]
    pub fn with_shear(self, traction: [&'a Field; 2]) -> Self {
        Self {
            shear: Some(traction),
            ..self
        }
    }

    /// Pressure and tractions along x and y, if any, once they are those of these bodies and finite.
    pub(super) fn checked(&self, bodies: &HalfSpace) -> Result<[Option<&'a [f64]>; 3]> {
        let (grid, quantity) = (bodies.grid(), "the contact whose stress is asked for");
        if let Some((boundary, pair)) = self.host {
            bodies.check_host(quantity, self.pressure.grid(), boundary)?;
            if pair != bodies.pair() {
                return Err(Error::MaterialMismatch { quantity });
            }
        }
        self.pressure.check("pressure", grid)?;
        let mut fields = [Some(self.pressure.as_slice()), None, None];
        if let Some(shear) = self.shear {
            for (field, traction) in fields[1..].iter_mut().zip(shear) {
                traction.check("traction", grid)?;
                *field = Some(traction.as_slice());
            }
        }
        Ok(fields)
    }
}

/// The pressure of a contact.
impl<'a> From<&'a NormalSolution> for Tractions<'a> {
    fn from(normal: &'a NormalSolution) -> Self {
        let host = Some((normal.boundary(), normal.pair()));
        Self {
            host,
            ..Self::new(normal.pressure())
        }
    }
}

/// The pressure and the tractions of a contact that was solved one after the other.
impl<'a> From<(&'a NormalSolution, &'a TangentialSolution)> for Tractions<'a> {
    fn from((normal, shear): (&'a NormalSolution, &'a TangentialSolution)) -> Self {
        Self::from(normal).with_shear(shear.traction())
    }
}

/// Those of a contact of dissimilar bodies.
impl<'a> From<&'a CoupledSolution> for Tractions<'a> {
    fn from(solution: &'a CoupledSolution) -> Self {
        Self::from((solution.normal(), solution.shear()))
    }
}

/// Those of a state of a history.
impl<'a> From<&'a State> for Tractions<'a> {
    fn from(state: &'a State) -> Self {
        Self::from(state.normal()).with_shear(state.traction())
    }
}

/// Those of a history as it stands.
impl<'a> From<&'a History> for Tractions<'a> {
    fn from(history: &'a History) -> Self {
        Self::from(history.normal()).with_shear(history.traction())
    }
}
