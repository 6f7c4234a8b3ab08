//! Stresses and displacements on planes.

use std::path::PathBuf;
use std::sync::Mutex;

use pyo3::prelude::*;
use stickslip::subsurface::{self, Body, Tractions};

use crate::array::{Array, copy, view};
use crate::choice::Choice;
use crate::conversion;
use crate::digits::{counted, short};
use crate::error::OrRaise;
use crate::grid::{Grid, size};
use crate::half_space::HalfSpace;
use crate::readers::readers;
use crate::real::Count;
use crate::report::{Warning, warn};
use crate::sequence::place;
use crate::solution_pool::lock;
use crate::subsurface::{Loaded, Stress};
use crate::work::{observed_on, unobserved_on, watch};

/// Stress, and displacement if requested, at the cell centres of a plane below the surface. Arrays are views, except for
/// derived stresses, which are new arrays.
#[pyclass(frozen, module = "stickslip.subsurface")]
pub(crate) struct Plane(subsurface::Plane);

impl Plane {
    fn derived<'py>(
        &self,
        py: Python<'py>,
        of: impl Fn(subsurface::Stress) -> f64 + Send + Sync,
    ) -> PyResult<Array<'py>> {
        let field = unobserved_on(py, self.0.grid(), || Ok(self.0.map(of)))?;
        Ok(copy(py, &field))
    }
}

readers! { Plane.0:
    /// Grid of the plane.
    grid(): Grid => Grid,
    /// The body that contains the plane.
    body(): Choice<Body> => Choice,
    /// Depth below the surface of the body (a length).
    depth(): f64,
    /// Position along z (a length), negative in body two.
    z(): f64,
    /// Warnings about values that might mislead; empty if there are none. A plane nearer to the surface than a cell
    /// side has a warning if shear tractions end at the edge of a contact.
    warnings(): Vec<Warning> => Warning::all,
}

#[pymethods]
impl Plane {
    /// Components xx, yy and zz (pressures, tensile positive).
    #[getter]
    fn normal_stress<'py>(slf: &Bound<'py, Self>) -> (Array<'py>, Array<'py>, Array<'py>) {
        (
            view(slf, |plane| plane.0.normal_stress()[0]),
            view(slf, |plane| plane.0.normal_stress()[1]),
            view(slf, |plane| plane.0.normal_stress()[2]),
        )
    }

    /// Components xy, xz and yz (pressures).
    #[getter]
    fn shear_stress<'py>(slf: &Bound<'py, Self>) -> (Array<'py>, Array<'py>, Array<'py>) {
        (
            view(slf, |plane| plane.0.shear_stress()[0]),
            view(slf, |plane| plane.0.shear_stress()[1]),
            view(slf, |plane| plane.0.shear_stress()[2]),
        )
    }

    /// Displacement along x, y and z (lengths); ``None`` if it was not requested.
    #[getter]
    fn displacement<'py>(&self, py: Python<'py>) -> Option<(Array<'py>, Array<'py>, Array<'py>)> {
        let fields = self.0.displacement()?;
        Some(fields.map(|field| copy(py, field)).into())
    }

    /// Returns the stress of a cell, given by column and row, or ``None`` outside the grid.
    fn get(&self, ix: Count, iy: Count) -> Option<Stress> {
        self.0.get(ix.0, iy.0).map(Stress)
    }

    /// Von Mises' equivalent stress (pressures), of shape (ny, nx).
    #[getter]
    fn von_mises<'py>(&self, py: Python<'py>) -> PyResult<Array<'py>> {
        self.derived(py, |stress| stress.von_mises())
    }

    /// Mean of the normal stresses (pressures, tensile positive).
    #[getter]
    fn hydrostatic<'py>(&self, py: Python<'py>) -> PyResult<Array<'py>> {
        self.derived(py, |stress| stress.hydrostatic())
    }

    /// Largest shear stress (pressures).
    #[getter]
    fn max_shear<'py>(&self, py: Python<'py>) -> PyResult<Array<'py>> {
        self.derived(py, |stress| stress.max_shear())
    }

    fn __repr__(&self) -> String {
        format!("Plane({}, z={})", size(self.0.grid()), short(self.0.z()))
    }
}

/// Stresses on planes at chosen depths below the surface of each body, computed by fast Fourier transforms. In
/// coated bodies the planes may lie in the layers or below them. The kernels of a depth are created at its first
/// solve and kept.
///
/// Parameters
/// ----------
/// bodies : HalfSpace
///     The two bodies and the grid.
/// depths : array_like
///     Depths below the surface of each body (lengths), not negative.
/// displacements : bool, default False
///     Whether displacements are also computed.
///
/// Raises
/// ------
/// Sample, Memory
///
/// Examples
/// --------
/// >>> import stickslip
/// >>> grid = stickslip.Grid.square(64, 0.4)
/// >>> steel = stickslip.Material(210e3, 0.3)
/// >>> bodies = stickslip.HalfSpace(grid, (steel, steel))
/// >>> contact = stickslip.NormalProblem(bodies, stickslip.surface.sphere(grid, 5.0), force=100.0).solve()
/// >>> hertz = stickslip.analytical.HertzSphere(bodies.pair, radius=5.0, load=100.0)
/// >>> planes = stickslip.subsurface.Planes(bodies, [0.481 * hertz.contact_radius])
/// >>> plane = planes.solve(0, "one", contact)
/// >>> round(float(plane.max_shear.max()) / hertz.max_pressure, 3)
/// 0.31
#[pyclass(frozen, module = "stickslip.subsurface")]
pub(crate) struct Planes {
    planes: Mutex<subsurface::Planes>,
    bodies: HalfSpace,
}

impl Planes {
    fn grid(&self) -> stickslip::Grid {
        self.bodies.0.grid()
    }

    /// Runs work with the planes and the tractions on their grid.
    fn with<T>(
        &self,
        py: Python<'_>,
        tractions: &Loaded<'_>,
        uniform_stress: Option<Stress>,
        work: impl FnOnce(&mut subsurface::Planes, Tractions<'_>) -> PyResult<T>,
    ) -> PyResult<T> {
        let held = tractions.held(py, self.grid())?;
        work(
            &mut *lock(&self.planes, "planes")?,
            held.tractions(uniform_stress),
        )
    }
}

#[pymethods]
impl Planes {
    #[new]
    #[pyo3(signature = (bodies, depths, *, displacements=false))]
    fn new(
        py: Python<'_>,
        bodies: HalfSpace,
        depths: conversion::Depths,
        #[pyo3(from_py_with = crate::real::flag)] displacements: bool,
    ) -> PyResult<Self> {
        let planes = subsurface::Planes::new(&bodies.0, &depths.0).or_raise(py)?;
        let planes = if displacements {
            planes.with_displacements()
        } else {
            planes
        };
        Ok(Self {
            planes: Mutex::new(planes),
            bodies,
        })
    }

    /// Depths of the planes (lengths).
    #[getter]
    fn depths<'py>(&self, py: Python<'py>) -> PyResult<Array<'py>> {
        let depths = lock(&self.planes, "planes")?.depths().to_vec();
        Ok(Array::new(py, depths))
    }

    /// Computes the plane at the depth with this index in a body. A negative index counts from the end. For the
    /// tractions, see :func:`at_points`.
    ///
    /// Parameters
    /// ----------
    /// uniform_stress : Stress, optional
    ///     Bulk stress that is added; see :func:`at_points`.
    /// warn : bool, default True
    ///     Whether :attr:`Plane.warnings` are also issued through ``warnings``, each kind once per location.
    ///
    /// Raises
    /// ------
    /// IndexError
    ///     If the index is out of range.
    /// RigidBody, Memory, GridMismatch, BoundaryMismatch, MaterialMismatch, Sample
    #[pyo3(signature = (index, body, tractions, *, uniform_stress=None, warn=true))]
    fn solve(
        &self,
        py: Python<'_>,
        index: isize,
        body: Choice<Body>,
        tractions: Loaded<'_>,
        uniform_stress: Option<Stress>,
        #[pyo3(from_py_with = crate::real::flag)] warn: bool,
    ) -> PyResult<Plane> {
        let plane = self.with(py, &tractions, uniform_stress, |planes, tractions| {
            let index = place(planes.depths(), index, "depth")?;
            observed_on(py, self.grid(), |observer| {
                planes.solve_observed(index, body.0, tractions, watch(observer))
            })
        })?;
        self::warn(py, warn, || plane.warnings())?;
        Ok(Plane(plane))
    }

    /// Computes the planes of all depths in a body; see :meth:`solve`.
    #[pyo3(signature = (body, tractions, *, uniform_stress=None, warn=true))]
    fn solve_all(
        &self,
        py: Python<'_>,
        body: Choice<Body>,
        tractions: Loaded<'_>,
        uniform_stress: Option<Stress>,
        #[pyo3(from_py_with = crate::real::flag)] warn: bool,
    ) -> PyResult<Vec<Plane>> {
        let found = self.with(py, &tractions, uniform_stress, |planes, tractions| {
            let depths = planes.depths().len();
            observed_on(py, self.grid(), |observer| {
                let solve =
                    |index| planes.solve_observed(index, body.0, tractions, watch(&mut *observer));
                (0..depths).map(solve).collect::<Result<Vec<_>, _>>()
            })
        })?;
        for plane in &found {
            self::warn(py, warn, || plane.warnings())?;
        }
        Ok(found.into_iter().map(Plane).collect())
    }

    /// Writes the stresses of all depths in a body as a volume for ParaView; see :meth:`solve`.
    #[pyo3(signature = (path, body, tractions, *, uniform_stress=None))]
    fn write_vti(
        &self,
        py: Python<'_>,
        path: PathBuf,
        body: Choice<Body>,
        tractions: Loaded<'_>,
        uniform_stress: Option<Stress>,
    ) -> PyResult<()> {
        self.with(py, &tractions, uniform_stress, |planes, tractions| {
            observed_on(py, self.grid(), |observer| {
                planes.write_vti_observed(&path, body.0, tractions, watch(observer))
            })
        })
    }

    fn __repr__(&self) -> PyResult<String> {
        let planes = lock(&self.planes, "planes")?;
        Ok(format!(
            "Planes({})",
            counted(planes.depths().len(), "depth")
        ))
    }
}
