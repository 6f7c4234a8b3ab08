//! Solutions with estimated errors, and records of their grids.

use std::sync::Arc;

use pyo3::prelude::*;
use pyo3::sync::PyOnceLock;
use stickslip::adaptive::{AdaptiveSolution as Solution, AdaptiveStatus, Estimate, Quantity};
use stickslip::{Error, TryClone};

use crate::adaptive::target::OfQuantities;
use crate::array::{Array, view};
use crate::choice::Choice;
use crate::digits::{counted, rough, short, tuple};
use crate::edges::TangentialEdges;
use crate::error::OrRaise;
use crate::grid::{Grid, size};
use crate::half_space::HalfSpace;
use crate::history::History;
use crate::normal::NormalSolution;
use crate::report::Warning;
use crate::sequence::pair;
use crate::tangential::TangentialSolution;
use crate::unit::Unit;
use crate::work::{Stage, unobserved_on};

/// Returns the estimated errors by quantity.
fn errors(estimates: &[Estimate]) -> OfQuantities {
    let error = |estimate: &Estimate| (estimate.quantity, estimate.error);
    OfQuantities(estimates.iter().map(error).collect())
}

/// Formats the estimated errors that have a target.
fn shown(estimates: &[Estimate]) -> String {
    let required = estimates
        .iter()
        .filter(|estimate| estimate.target.is_some());
    let error = |estimate: &Estimate| {
        let name = Choice(estimate.quantity).name();
        format!("'{name}': {}", rough(estimate.error))
    };
    format!("{{{}}}", required.map(error).collect::<Vec<_>>().join(", "))
}

/// Grid of a solve and the estimated errors after it.
#[pyclass(frozen, eq, module = "stickslip.adaptive")]
#[derive(Clone, PartialEq)]
pub(crate) struct GridRecord(stickslip::adaptive::GridRecord);

#[pymethods]
impl GridRecord {
    /// Grid of the solve.
    #[getter]
    fn grid(&self) -> Grid {
        Grid(self.0.grid)
    }

    /// Centre of the grid in the coordinates of the gap, (x, y) (lengths).
    #[getter]
    fn centre(&self) -> (f64, f64) {
        pair(self.0.centre)
    }

    /// Estimated errors of all quantities, by name; empty after the first solve of a part of the region.
    #[getter]
    fn estimates(&self) -> OfQuantities {
        errors(&self.0.estimates)
    }

    fn __repr__(&self) -> String {
        format!(
            "GridRecord({}, centre={}, estimates={})",
            size(self.0.grid),
            tuple(&self.0.centre),
            shown(&self.0.estimates)
        )
    }
}

impl Stage for stickslip::adaptive::GridRecord {
    fn object(self, py: Python<'_>) -> PyResult<Bound<'_, PyAny>> {
        Bound::new(py, GridRecord(self)).map(Bound::into_any)
    }
}

/// Contact with estimated errors, on the finest grid of a solve. It cannot be pickled; its parts, such as ``normal`` and
/// ``history``, can.
#[pyclass(frozen, module = "stickslip.adaptive")]
pub(crate) struct AdaptiveSolution {
    solution: Arc<Solution>,
    targets: Vec<(Quantity, f64)>,
    /// Unit of the gap.
    unit: Option<Unit>,
    tangential: PyOnceLock<Option<Py<TangentialSolution>>>,
    history: PyOnceLock<Option<Py<History>>>,
}

impl AdaptiveSolution {
    pub(super) fn new(
        solution: Solution,
        targets: Vec<(Quantity, f64)>,
        unit: Option<Unit>,
    ) -> Self {
        Self {
            solution: Arc::new(solution),
            targets,
            unit,
            tangential: PyOnceLock::new(),
            history: PyOnceLock::new(),
        }
    }

    /// Returns the edges with sub-cell resolution, if the contact has friction.
    fn tangential_edges(
        &self,
        py: Python<'_>,
    ) -> PyResult<stickslip::Result<Option<stickslip::edges::TangentialEdges>>> {
        // The inner result is returned, because coated bodies have no edges.
        unobserved_on(py, self.solution.grid(), || Ok(self.solution.edges()))
    }
}

#[pymethods]
impl AdaptiveSolution {
    /// The grid, whose coordinates are relative to :attr:`centre`.
    #[getter]
    fn grid(&self) -> Grid {
        Grid(self.solution.grid())
    }

    /// Centre of the grid in the coordinates of the gap, (x, y) (lengths).
    #[getter]
    fn centre(&self) -> (f64, f64) {
        pair(self.solution.centre())
    }

    /// Coordinates x of the cell centres, in the coordinates of the gap (lengths), shape (nx,).
    #[getter]
    fn x<'py>(&self, py: Python<'py>) -> Array<'py> {
        let columns = 0..self.solution.grid().nx();
        Array::new(py, columns.map(|ix| self.solution.position(ix, 0)[0]))
    }

    /// Coordinates y of the cell centres, in the coordinates of the gap (lengths), shape (ny,).
    #[getter]
    fn y<'py>(&self, py: Python<'py>) -> Array<'py> {
        let rows = 0..self.solution.grid().ny();
        Array::new(py, rows.map(|iy| self.solution.position(0, iy)[1]))
    }

    /// The bodies on the grid, for instance for a further problem.
    #[getter]
    fn bodies(&self) -> HalfSpace {
        HalfSpace(self.solution.bodies().clone())
    }

    /// The gap before loading at the centres of the cells (lengths), shape (ny, nx).
    #[getter]
    fn gap<'py>(slf: &Bound<'py, Self>) -> Array<'py> {
        view(slf, |solution| solution.solution.gap())
    }

    /// The normal contact.
    #[getter]
    fn normal(&self) -> NormalSolution {
        NormalSolution::of_adaptive(&self.solution, self.unit.clone())
    }

    /// The tangential contact; ``None`` without a tangential load.
    #[getter]
    fn tangential(&self, py: Python<'_>) -> PyResult<Option<Py<TangentialSolution>>> {
        let made = self.tangential.get_or_try_init(py, || {
            let solution = self.solution.tangential().cloned();
            let made =
                solution.map(|solution| Py::new(py, TangentialSolution::from(Arc::new(solution))));
            made.transpose()
        })?;
        Ok(made.as_ref().map(|made| made.clone_ref(py)))
    }

    /// The history after its first step, for further steps on the same grid; ``None`` without ``first_step``. Further steps
    /// do not change the other attributes of this solution. The tolerance of the history is 2 % of the smallest target (2e-4
    /// for the default targets); call ``set_settings`` for a smaller tolerance. Its grid is centred on ``centre``: add the
    /// centre to positions.
    #[getter]
    fn history(&self, py: Python<'_>) -> PyResult<Option<Py<History>>> {
        let made = self.history.get_or_try_init(py, || {
            let Some(history) = self.solution.history() else {
                return Ok::<_, PyErr>(None);
            };
            let history = history.try_clone().or_raise(py)?;
            Py::new(py, History::of(history, &self.bodies(), self.unit.clone())).map(Some)
        })?;
        Ok(made.as_ref().map(|made| made.clone_ref(py)))
    }

    /// Contact area from the edges inside the cells (a length squared).
    #[getter]
    fn area(&self) -> f64 {
        self.solution.area()
    }

    /// Approach of the bodies from the datum of the gap (a length). On a grid that is periodic along x and y, it is the mean
    /// initial gap minus the mean gap under load.
    #[getter]
    fn approach(&self) -> f64 {
        self.solution.normal().approach()
    }

    /// Normal force, the integral of the pressure.
    #[getter]
    fn force(&self) -> f64 {
        self.solution.normal().force()
    }

    /// Ratio of stick area to contact area from the edges inside the cells; ``None`` without friction.
    #[getter]
    fn stick_ratio(&self, py: Python<'_>) -> PyResult<Option<f64>> {
        match self.tangential_edges(py)? {
            Ok(edges) => Ok(edges.map(|edges| edges.stick_ratio())),
            // Edges inside the cells are not computed for coated bodies.
            Err(Error::UnsupportedForCoatings { .. }) => {
                let solution = &self.solution;
                let of_load = solution
                    .tangential()
                    .map(stickslip::TangentialSolution::stick_ratio);
                let of_step = || {
                    solution
                        .history()
                        .and_then(|history| history.last_step().ok())
                        .map(stickslip::history::StepResult::stick_ratio)
                };
                Ok(of_load.or_else(of_step))
            }
            Err(error) => Err(error).or_raise(py),
        }
    }

    /// Returns the edges of contact and stick zone inside the cells; ``None`` without friction. Without friction,
    /// ``normal.edges()`` returns the edge of the contact.
    ///
    /// Raises
    /// ------
    /// UnsupportedForCoatings
    fn edges(&self, py: Python<'_>) -> PyResult<Option<TangentialEdges>> {
        let edges = self.tangential_edges(py)?.or_raise(py)?;
        Ok(edges.map(TangentialEdges))
    }

    /// Reason why the refinement ended.
    #[getter]
    fn status(&self) -> Choice<AdaptiveStatus> {
        Choice(self.solution.status())
    }

    /// Whether all estimated errors are at most their targets.
    #[getter]
    fn is_reached(&self) -> bool {
        self.solution.status() == AdaptiveStatus::Reached
    }

    /// Estimated errors of all quantities, by name. The dictionary is empty if only one grid was solved.
    #[getter]
    fn estimates(&self) -> OfQuantities {
        errors(self.solution.estimates())
    }

    /// Targets of the estimated errors, by the names of the quantities.
    #[getter]
    fn targets(&self) -> OfQuantities {
        OfQuantities(self.targets.clone())
    }

    /// The grids of all solves after the search for the contact, in order.
    #[getter]
    fn grids(&self) -> Vec<GridRecord> {
        self.solution
            .grids()
            .iter()
            .cloned()
            .map(GridRecord)
            .collect()
    }

    /// Returns the difference of a quantity from a solution on a finer grid, in the definition of :class:`Quantity`. The
    /// difference is zero for a tangential quantity without friction.
    fn difference(
        &self,
        py: Python<'_>,
        finer: &Self,
        quantity: Choice<Quantity>,
    ) -> PyResult<f64> {
        let found = self.solution.difference(&finer.solution, quantity.0);
        found.or_raise(py)
    }

    /// Warnings of the normal contact and of the tangential contact or first step, each kind once, and the warning
    /// ``accuracy_not_reached`` if a limit ended the refinement.
    #[getter]
    fn warnings(&self, py: Python<'_>) -> PyResult<Vec<Warning>> {
        self.solution.warnings().or_raise(py).map(Warning::all)
    }

    fn __repr__(&self) -> String {
        let solution = &self.solution;
        format!(
            "AdaptiveSolution({}, {} after {}, force={}, approach={}, area={}, estimates={})",
            self.status().name(),
            size(solution.grid()),
            counted(solution.grids().len(), "grid"),
            short(self.force()),
            short(self.approach()),
            short(self.area()),
            shown(solution.estimates())
        )
    }
}
