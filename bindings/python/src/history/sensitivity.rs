//! Sensitivities of the last step of a history.

use pyo3::prelude::*;

use crate::history::History;
use crate::history::builder::NAME;
use crate::load::StepArgument;
use crate::real::Real;
use crate::sensitivity::{Functional, Sensitivity, contents, objects, workspace};
use crate::solution_pool::lock;
use crate::work::{observed_on, watch};

#[pymethods]
impl History {
    /// Computes the derivatives of a functional of the last step with respect to the input of this step: its load, its
    /// friction and its gap.
    ///
    /// The state before the step is fixed. It includes the offsets of the cells, and the gaps that cells close when they come
    /// into contact. A program that differentiates several steps adds the effects of earlier steps itself. The elastic energy
    /// is the energy of shear.
    ///
    /// Parameters
    /// ----------
    /// load : LoadStep
    ///     The load of the last step.
    /// functional : Functional
    ///     The functional; see :class:`stickslip.sensitivity.Functional`.
    /// tolerance : float, optional
    ///     Relative residual at which a linear problem counts as solved; 1e-11 by default.
    ///
    /// Returns
    /// -------
    /// Sensitivity
    ///
    /// Raises
    /// ------
    /// EmptyContact
    ///     If the bodies do not touch.
    /// UnsupportedByModel
    ///     For a step that rolls, for full coupling of dissimilar bodies, or if the history has not taken the step itself.
    /// BelowMinimum, GridMismatch, NotConverged, NotFinite, NotPositive, Sample, Tolerance
    ///     See :meth:`TangentialSolver.sensitivity`.
    ///
    /// Examples
    /// --------
    /// >>> import stickslip as ss
    /// >>> grid = ss.Grid.square(32, 0.3e-3)
    /// >>> steel = ss.Material(213e9, 0.29)
    /// >>> history = ss.History(ss.HalfSpace(grid, (steel, steel)), ss.surface.sphere(grid, 3.5e-3), 0.5)
    /// >>> done = history.step(normal_force=100.0)
    /// >>> drag = ss.LoadStep(force_x=30.0)
    /// >>> done = history.step(drag)
    /// >>> found = history.sensitivity(drag, ss.sensitivity.Functional.shift("x"))
    /// >>> found.tangential_load[0] > 0.0 > found.friction_coefficient
    /// True
    #[pyo3(signature = (load, functional, *, tolerance=None))]
    fn sensitivity(
        &self,
        py: Python<'_>,
        load: StepArgument,
        functional: Functional,
        tolerance: Option<Real>,
    ) -> PyResult<Sensitivity> {
        let mut found = self.sensitivities(py, load, vec![functional], tolerance)?;
        // One functional has one sensitivity.
        Ok(found.remove(0))
    }

    /// Computes the sensitivities of several functionals of the last step, in their order. The options and the exceptions
    /// are those of :meth:`sensitivity`.
    #[pyo3(signature = (load, functionals, *, tolerance=None))]
    fn sensitivities(
        &self,
        py: Python<'_>,
        load: StepArgument,
        functionals: Vec<Functional>,
        tolerance: Option<Real>,
    ) -> PyResult<Vec<Sensitivity>> {
        let mut workspace = workspace(py, tolerance, false)?;
        let functionals = contents(functionals);
        let work = lock(&self.work, NAME)?;
        let history = &work.history;
        let found = observed_on(py, self.grid(), |observer| {
            history.sensitivities_with(&load.0.0, &functionals, &mut workspace, watch(observer))
        });
        found.map(objects)
    }
}
