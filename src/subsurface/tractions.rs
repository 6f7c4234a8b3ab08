//! The tractions on the surface of the bodies.

use std::borrow::Cow;
use std::fmt::Debug;

use crate::bodies::material::ElasticPair;
#[cfg(feature = "history")]
use crate::coupled::CoupledSolution;
use crate::error::{Result, all_finite, check_solved};
use crate::grid::boundary::Boundary;
use crate::grid::cell_value::CellValue;
use crate::grid::field::Field;
use crate::grid::neighbours::second_difference;
use crate::half_space::HalfSpace;
#[cfg(feature = "history")]
use crate::history::{History, State};
use crate::memory::fallible;
use crate::normal::NormalSolution;
use crate::report::{Report, Status};
use crate::subsurface::stress::Stress;
use crate::tangential::TangentialSolution;

/// Pressure and tractions on the surface (pressures). They can be created from fields, from a [`NormalSolution`], or
/// from a [`NormalSolution`] with a [`TangentialSolution`]. Further sources are a [`CoupledSolution`], a [`History`]
/// and a [`State`].
///
/// On bodies with [`CellValue::Centre`] the fields contain values at the cell centres. The sum uses uniform cells that
/// carry $`p - \Delta_h p/24`$. These uniform cells cause the same surface displacements as the values at the centres.
/// On a free grid this holds only if the outermost cells carry no traction.
///
/// The sign convention of the crate applies. A positive pressure is compression, and the tractions act on body 1 along
/// x and y. A negative pressure is tension, such as adhesion or the difference of two contacts, and is not an error. A field of
/// stresses, which are positive in tension, must change its sign.
///
/// ```
/// use stickslip::subsurface::{Body, Tractions, at_points};
/// use stickslip::*;
/// let grid = Grid::square(15, 1.0)?;
/// let rubber = Material::new(1.0, 0.5)?;
/// let bodies = HalfSpace::new(grid, ElasticPair::new(rubber, Material::rigid())?)?;
/// let (p, q, none) = (Field::constant(grid, 2.0), Field::constant(grid, 1.0), Field::zeros(grid));
/// let sliding = Tractions::new(&p).with_traction([&q, &none]);
/// // The surface under the load.
/// let stress = at_points(&bodies, Body::One, sliding, &[[0.0, 0.0, 0.0]])?[0].stress;
/// assert!((stress.zz + 2.0).abs() < 1e-14 && (stress.xz + 1.0).abs() < 1e-14);
/// # Ok::<(), Error>(())
/// ```
#[derive(Debug, Clone, Copy)]
pub struct Tractions<'a> {
    pressure: &'a Field,
    traction: Option<[&'a Field; 2]>,
    /// Uniform stress of the body whose stress is requested.
    uniform: Stress,
    /// Boundary, cell values and bodies of the solution that contains the tractions.
    host: Option<(Boundary, CellValue, &'a ElasticPair)>,
    /// Normal and tangential solutions that may belong to different problems.
    solutions: Option<(&'a NormalSolution, &'a TangentialSolution)>,
    /// Report of the solution that contains the tractions, or of the half that is not solved or has not converged.
    report: Option<&'a Report>,
}

impl<'a> Tractions<'a> {
    /// Creates tractions from a pressure (positive in compression), without shear.
    #[must_use]
    pub fn new(pressure: &'a Field) -> Self {
        Self {
            pressure,
            traction: None,
            uniform: Stress::default(),
            host: None,
            solutions: None,
            report: None,
        }
    }

    /// Sets the tractions along x and y (pressures) on body 1 and replaces previous tractions.
    #[must_use]
    pub fn with_traction(self, traction: [&'a Field; 2]) -> Self {
        Self {
            traction: Some(traction),
            solutions: None,
            ..self
        }
    }

    /// Sets a uniform stress (pressures, tensile positive), such as a bulk stress. The uniform stress is added
    /// everywhere, including the surface, to the stress that the tractions cause in the computed body. It replaces any
    /// uniform stress that was set earlier. Displacements are unaffected.
    ///
    /// ```
    /// use stickslip::subsurface::{Body, Planes, Stress, Tractions};
    /// use stickslip::*;
    /// let grid = Grid::line(64, 0.01)?;
    /// let titanium = Material::new(115e3, 0.32)?;
    /// let boundary = Boundary::PeriodicAlongY { datum: 50.0 };
    /// let bodies = HalfSpace::with_boundary(grid, ElasticPair::new(titanium, titanium)?, boundary)?;
    /// // A specimen under 150 MPa along x that is too wide to contract along y.
    /// let bulk = Stress { xx: 150.0, yy: 0.32 * 150.0, ..Stress::default() };
    /// let pressure = Field::from_fn(grid, |x, _| 300.0 * (1.0 - 25.0 * x * x).max(0.0).sqrt());
    /// let loads = Tractions::new(&pressure);
    /// let mut planes = Planes::new(&bodies, &[0.1])?;
    /// let alone = planes.solve(0, Body::One, loads)?;
    /// let both = planes.solve(0, Body::One, loads.with_uniform_stress(bulk))?;
    /// let sum = alone.get(20, 0).map(|stress| (stress + bulk).von_mises());
    /// assert_eq!(both.get(20, 0).map(|stress| stress.von_mises()), sum);
    /// # Ok::<(), Error>(())
    /// ```
    #[doc(alias = "bulk stress")]
    #[must_use]
    pub fn with_uniform_stress(self, stress: Stress) -> Self {
        Self {
            uniform: stress,
            ..self
        }
    }

    /// Returns whether the tractions belong to a solve that ended before it converged.
    pub(super) fn is_unconverged(&self) -> bool {
        self.report.is_some_and(|report| !report.is_converged())
    }

    /// Returns the properties of the tractions that must be equal on all ranks.
    pub(super) fn shown(&self) -> impl Debug {
        (self.traction.is_some(), self.uniform)
    }

    /// Returns the uniform stress, or an error if it is not finite.
    pub(super) fn checked_uniform(&self) -> Result<Stress> {
        all_finite("uniform stress", &self.uniform.components())?;
        Ok(self.uniform)
    }

    /// Returns the pressure and, if present, the tractions along x and y of uniform cells. Returns an error if they
    /// belong to different bodies or different pressures, are not finite, or belong to a solution that was not solved.
    pub(super) fn checked(&self, bodies: &HalfSpace) -> Result<[Option<Cow<'a, [f64]>>; 3]> {
        let (grid, quantity) = (bodies.grid(), "the contact of the requested stress");
        if let Some((boundary, cell_value, pair)) = self.host {
            bodies.check_host(quantity, self.pressure.grid(), boundary)?;
            bodies.check_values(quantity, cell_value)?;
            bodies.check_pair(quantity, pair)?;
        }
        self.report.map_or(Ok(()), check_solved)?;
        if let Some((normal, tangential)) = self.solutions {
            tangential.check_normal(normal, "requested stress")?;
        }
        self.pressure.check("pressure", grid)?;
        let mut fields = [Some(uniform(bodies, self.pressure)?), None, None];
        if let Some(traction) = self.traction {
            for (field, traction) in fields[1..].iter_mut().zip(traction) {
                traction.check("traction", grid)?;
                *field = Some(uniform(bodies, traction)?);
            }
        }
        Ok(fields)
    }
}

/// Returns the tractions of uniform cells that cause the same surface displacements as the given tractions.
fn uniform<'a>(bodies: &HalfSpace, traction: &'a Field) -> Result<Cow<'a, [f64]>> {
    let values = traction.as_slice();
    // On a periodic grid, tractions are sums of waves below the surface as well, so uniform cells are not required.
    let is_of_waves = bodies.boundary() == Boundary::Periodic;
    if is_of_waves || bodies.cell_value() == CellValue::Uniform {
        return Ok(Cow::Borrowed(values));
    }
    bodies.check_alone("the stress of tractions that are given at cell centres")?;
    let (size, repeats) = (bodies.grid().size(), bodies.boundary().repeats());
    let less = |i: usize| values[i] - second_difference(values, i, size, repeats) / 24.0;
    Ok(Cow::Owned(fallible::collected(
        values.len(),
        (0..values.len()).map(less),
    )?))
}

/// Creates tractions from the pressure of a contact.
impl<'a> From<&'a NormalSolution> for Tractions<'a> {
    fn from(normal: &'a NormalSolution) -> Self {
        let host = Some((normal.boundary(), normal.cell_value(), normal.pair()));
        Self {
            host,
            report: Some(normal.report()),
            ..Self::new(normal.pressure())
        }
    }
}

/// Creates tractions from the pressure and the tractions of a contact with one-way coupling. A stress computation with these
/// tractions returns an error if the tangential solution was computed for a different pressure.
impl<'a> From<(&'a NormalSolution, &'a TangentialSolution)> for Tractions<'a> {
    fn from((normal, tangential): (&'a NormalSolution, &'a TangentialSolution)) -> Self {
        let reports = [normal.report(), tangential.report()].into_iter();
        let is_unsolved = |report: &&Report| report.status == Status::Unsolved;
        let report = (reports.clone().find(is_unsolved))
            .or_else(|| reports.clone().find(|report| !report.is_converged()));
        Self {
            solutions: Some((normal, tangential)),
            report,
            ..Self::from(normal).with_traction(tangential.traction())
        }
    }
}

/// Creates tractions from a coupled contact of dissimilar bodies.
#[cfg(feature = "history")]
impl<'a> From<&'a CoupledSolution> for Tractions<'a> {
    fn from(solution: &'a CoupledSolution) -> Self {
        Self {
            report: Some(&solution.report().work),
            ..Self::from(solution.normal()).with_traction(solution.tangential().traction())
        }
    }
}

/// Creates tractions from a state of a history.
#[cfg(feature = "history")]
impl<'a> From<&'a State> for Tractions<'a> {
    fn from(state: &'a State) -> Self {
        // A state before the first step has no load, so its stress is zero.
        Self {
            report: None,
            ..Self::from(state.normal()).with_traction(state.traction())
        }
    }
}

/// Creates tractions from the current state of a history.
#[cfg(feature = "history")]
impl<'a> From<&'a History> for Tractions<'a> {
    fn from(history: &'a History) -> Self {
        Self {
            report: None,
            ..Self::from(history.normal()).with_traction(history.traction())
        }
    }
}
