//! Results of a history.

use std::sync::Arc;

use pyo3::prelude::*;
use stickslip::Axis;
use stickslip::stiffness::StiffnessWorkspace;

use crate::array::{Array, contact, copy, energies, snapshot, zones};
use crate::boundary::Boundary;
use crate::choice::Choice;
use crate::digits::{short, tuple};
use crate::edges::TangentialEdges;
use crate::error::OrRaise;
use crate::friction::Friction;
use crate::grid::Grid;
use crate::half_space::HalfSpace;
use crate::history::History;
use crate::history::builder::NAME;
use crate::normal::NormalSolution;
use crate::sequence::pair;
use crate::solution_pool::lock;
use crate::spots::ContactSpots;
use crate::stiffness::ContactStiffness;
use crate::work::{observed_on, unobserved_on, watch};

#[pymethods]
impl History {
    /// The two bodies and the grid.
    #[getter]
    pub(super) fn bodies(&self) -> HalfSpace {
        self.bodies.clone()
    }

    /// The grid.
    #[getter(grid)]
    fn own_grid(&self) -> Grid {
        Grid(self.grid())
    }

    /// Boundary condition at the edge of the grid.
    #[getter]
    fn boundary(&self) -> Boundary {
        Boundary(self.bodies.0.boundary())
    }

    /// The axis of the scalar model; ``None`` in the vector model.
    #[getter]
    fn axis(&self) -> PyResult<Option<Choice<Axis>>> {
        self.read(|history| history.axis().map(Choice))
    }

    /// Unit of the lengths of the gap, if one of the gaps or relative displacements stated it. Later ones must have the same unit or
    /// none. A history that was restored from bytes, a file or a pickle has no unit; a state in memory keeps it.
    #[getter]
    fn unit(&self) -> PyResult<Option<String>> {
        let unit = lock(&self.work, NAME)?.unit.clone();
        Ok(unit.map(|unit| unit.to_string()))
    }

    /// The friction of later steps.
    #[getter]
    fn friction(&self) -> PyResult<Friction> {
        self.read(|history| Friction(history.friction().clone()))
    }

    /// The gap before loading (lengths), as last set, plus the yielded depth; a read-only copy.
    #[getter]
    fn unloaded_gap<'py>(&self, py: Python<'py>) -> PyResult<Array<'py>> {
        self.read(|history| snapshot(py, history.unloaded_gap()))
    }

    /// The gap before loading (lengths), as last set, without the yielded depth; a read-only copy. Pass a
    /// changed array to :meth:`set_gap`, as in ``history.set_gap(history.gap_as_set + depth)``. The yielded depth in :attr:`unloaded_gap`
    /// would count twice.
    #[getter]
    fn gap_as_set<'py>(&self, py: Python<'py>) -> PyResult<Array<'py>> {
        self.read(|history| {
            history
                .gap_as_set()
                .or_raise(py)
                .map(|gap| snapshot(py, &gap))
        })?
    }

    /// The normal solution, a copy.
    #[getter]
    fn normal(&self) -> PyResult<NormalSolution> {
        let work = lock(&self.work, NAME)?;
        let solution = Arc::new(work.history.normal().clone());
        Ok(NormalSolution::of(solution, work.unit.clone()))
    }

    /// Pressure, not negative; exactly zero outside the contact. A read-only copy.
    #[getter]
    fn pressure<'py>(&self, py: Python<'py>) -> PyResult<Array<'py>> {
        self.read(|history| snapshot(py, history.pressure()))
    }

    /// Mask of the cells in contact, booleans of shape (ny, nx): cells with positive pressure. A read-only copy.
    #[getter]
    fn contact<'py>(&self, py: Python<'py>) -> PyResult<Array<'py, bool>> {
        self.read(|history| contact(py, history.pressure()))
    }

    /// Approach of the bodies from the datum of the gap (a length).
    #[getter]
    fn approach(&self) -> PyResult<f64> {
        self.read(stickslip::History::approach)
    }

    /// Shear traction on body 1 along x and y (pressures), read-only copies.
    #[getter]
    fn traction<'py>(&self, py: Python<'py>) -> PyResult<(Array<'py>, Array<'py>)> {
        self.read(|history| history.traction().map(|field| snapshot(py, field)).into())
    }

    /// Slip since the start along x and y (lengths), read-only copies.
    #[getter]
    fn slip<'py>(&self, py: Python<'py>) -> PyResult<(Array<'py>, Array<'py>)> {
        self.read(|history| history.slip().map(|field| snapshot(py, field)).into())
    }

    /// Length of the path that each cell slipped since the start (lengths, not negative), a read-only copy.
    #[getter]
    fn accumulated_slip<'py>(&self, py: Python<'py>) -> PyResult<Array<'py>> {
        self.read(|history| snapshot(py, history.accumulated_slip()))
    }

    /// Energy that each cell dissipated in the steps since the start (not negative), a read-only copy that contains its grid.
    /// Cycles that :func:`stickslip.wear.run` jumps over are not steps. The result of the run contains their energy.
    #[getter]
    fn accumulated_dissipation<'py>(&self, py: Python<'py>) -> PyResult<Array<'py>> {
        let array = self.read(|history| snapshot(py, history.accumulated_dissipation()))?;
        energies(py, &array, self.grid())
    }

    /// Computes the displacement of body 1 relative to body 2 due to the tractions along x and y (lengths). The cost is
    /// one product.
    fn displacement<'py>(&self, py: Python<'py>) -> PyResult<(Array<'py>, Array<'py>)> {
        let mut work = lock(&self.work, NAME)?;
        let history = &mut work.history;
        let moved = unobserved_on(py, self.grid(), || history.displacement())?;
        Ok(moved.each_ref().map(|field| copy(py, field)).into())
    }

    /// Zone of each cell: 0 separated, 1 stick, 2 slip. A read-only copy.
    ///
    /// The array also compares equal to the names of the zones; see :attr:`TangentialSolution.zones`.
    #[getter]
    fn zones<'py>(&self, py: Python<'py>) -> PyResult<Array<'py, u8>> {
        self.read(|history| zones(py, history.grid(), history.zones()))?
    }

    /// Shift of body 2 relative to body 1 since the start, along x and y (lengths).
    #[getter]
    fn shift(&self) -> PyResult<(f64, f64)> {
        self.read(|history| pair(history.shift()))
    }

    /// Rotation of body 2 relative to body 1 since the start (radians, positive from x to y).
    #[getter]
    fn twist(&self) -> PyResult<f64> {
        self.read(stickslip::History::twist)
    }

    /// Tangential force that body 2 exerts on body 1 along x and y.
    #[getter]
    fn tangential_force(&self) -> PyResult<(f64, f64)> {
        self.read(|history| pair(history.tangential_force()))
    }

    /// Moment about z, at the origin of the grid, on body 1 (a force times a length, positive from x to y).
    #[getter]
    fn moment(&self) -> PyResult<f64> {
        self.read(stickslip::History::moment)
    }

    /// Ratio of stick cells to contact cells after the last step, zero without contact.
    #[getter]
    fn stick_ratio(&self) -> PyResult<f64> {
        self.read(stickslip::History::stick_ratio)
    }

    /// Largest tangential force that friction can carry.
    #[getter]
    fn friction_capacity(&self) -> PyResult<f64> {
        self.read(stickslip::History::friction_capacity)
    }

    /// Number of steps since the start.
    #[getter]
    fn steps(&self) -> PyResult<u64> {
        self.read(stickslip::History::steps)
    }

    /// Returns the edges of the contact and of the stick zone inside the cells after the last step.
    ///
    /// Raises
    /// ------
    /// OutdatedSolution
    ///     If the friction has changed since the last step.
    fn edges(&self, py: Python<'_>) -> PyResult<TangentialEdges> {
        let work = lock(&self.work, NAME)?;
        let history = &work.history;
        unobserved_on(py, self.grid(), || history.edges()).map(TangentialEdges)
    }

    /// The contact spots, with their stick ratios. With distributed bodies, the call is collective.
    #[getter]
    fn spots(&self, py: Python<'_>) -> PyResult<ContactSpots> {
        let work = lock(&self.work, NAME)?;
        let history = &work.history;
        unobserved_on(py, self.grid(), || history.spots()).map(ContactSpots::of)
    }

    /// Returns the derivatives of the forces and the moment with respect to approach, shift and twist.
    ///
    /// Parameters
    /// ----------
    /// next_step : bool, default False
    ///     If true, ``tangential.loading`` and ``by_approach`` are derivatives of the next step, which starts from the
    ///     present state. Otherwise they are derivatives of the last step. In the next step, all stick cells resist
    ///     fully, including cells that came into contact in the last step, and cells at their limit continue to slip. A
    ///     simulation that continues to shear the contact under the same normal load needs these derivatives.
    ///
    /// Raises
    /// ------
    /// OutdatedSolution
    ///     If the friction limits, the gap or the relative displacement have changed since the last step. Take a step first,
    ///     with a normal load after a change of the gap.
    /// NotConverged
    #[pyo3(signature = (*, next_step=false))]
    fn stiffness(
        &self,
        py: Python<'_>,
        #[pyo3(from_py_with = crate::real::flag)] next_step: bool,
    ) -> PyResult<ContactStiffness> {
        let mut work = lock(&self.work, NAME)?;
        let history = &mut work.history;
        let mut workspace = StiffnessWorkspace::new().next_step(next_step);
        let found = observed_on(py, self.grid(), |observer| {
            history.stiffness_with(&mut workspace, watch(observer))
        });
        found.map(ContactStiffness)
    }

    fn __repr__(&self) -> PyResult<String> {
        self.read(|history| {
            format!(
                "History(steps={}, normal_force={}, force={}, shift={})",
                history.steps(),
                short(history.normal().force()),
                tuple(&history.tangential_force()),
                tuple(&history.shift())
            )
        })
    }
}
