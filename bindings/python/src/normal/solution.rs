//! Solutions of normal contacts.

use std::sync::{Arc, OnceLock};

use pyo3::prelude::*;

use crate::argument::Object;
use crate::array::{Array, contact, copy, view};
use crate::boundary::Boundary;
use crate::choice::Choice;
use crate::digits::short;
use crate::edges::Edges;
use crate::grid::Grid;
use crate::half_space::HalfSpace;
use crate::material::ElasticPair;
use crate::pickle::{Reduced, Stored, reduced};
use crate::readers::readers;
use crate::report::{Report, Warning, ending};
use crate::sequence::pair;
use crate::spots::ContactSpots;
use crate::stiffness::NormalStiffness;
use crate::unit::{GapUnit, Unit, agree};
use crate::work::{observed_on, unobserved_on, watch};

/// Owner of a normal solution.
enum Source {
    Own(Arc<stickslip::NormalSolution>),
    OfCoupled(Arc<stickslip::CoupledSolution>),
    OfState(Arc<stickslip::history::State>),
    OfAdaptive(Arc<stickslip::adaptive::AdaptiveSolution>),
}

/// Pressure, gap and approach of a normal contact. Arrays are read-only views of the memory of this object. Two objects
/// are equal if their solutions are equal and their units do not differ, even if the iterations differed.
#[pyclass(frozen, module = "stickslip")]
pub(crate) struct NormalSolution {
    source: Source,
    /// Unit of the gap. Solves set it in the finished object.
    unit: OnceLock<Unit>,
}

impl NormalSolution {
    pub(crate) fn of(solution: Arc<stickslip::NormalSolution>, unit: Option<Unit>) -> Self {
        Self::from_source(Source::Own(solution), unit)
    }

    fn from_source(source: Source, unit: Option<Unit>) -> Self {
        let unit = unit.map_or_else(OnceLock::new, OnceLock::from);
        Self { source, unit }
    }

    /// Returns the unit of the gap, if it is known.
    pub(crate) fn unit_of_gap(&self) -> Option<&Unit> {
        self.unit.get()
    }

    pub(crate) fn of_coupled(
        solution: &Arc<stickslip::CoupledSolution>,
        unit: Option<Unit>,
    ) -> Self {
        Self::from_source(Source::OfCoupled(Arc::clone(solution)), unit)
    }

    pub(crate) fn of_state(state: &Arc<stickslip::history::State>, unit: Option<Unit>) -> Self {
        Self::from_source(Source::OfState(Arc::clone(state)), unit)
    }

    pub(crate) fn of_adaptive(
        solution: &Arc<stickslip::adaptive::AdaptiveSolution>,
        unit: Option<Unit>,
    ) -> Self {
        Self::from_source(Source::OfAdaptive(Arc::clone(solution)), unit)
    }

    pub(crate) fn get(&self) -> &stickslip::NormalSolution {
        match &self.source {
            Source::Own(solution) => solution,
            Source::OfCoupled(solution) => solution.normal(),
            Source::OfState(state) => state.normal(),
            Source::OfAdaptive(solution) => solution.normal(),
        }
    }
}

impl GapUnit for NormalSolution {
    fn unit_cell(&self) -> &OnceLock<Unit> {
        &self.unit
    }
}

impl From<Arc<stickslip::NormalSolution>> for NormalSolution {
    fn from(solution: Arc<stickslip::NormalSolution>) -> Self {
        Self::of(solution, None)
    }
}

impl Stored for NormalSolution {
    type Content = (stickslip::NormalSolution, Option<String>);

    const KIND: &'static str = "NormalSolution";

    fn of_content((solution, unit): Self::Content) -> Self {
        Self::of(Arc::new(solution), unit.map(Unit::from))
    }
}

readers! { NormalSolution.get():
    /// Grid of the fields.
    grid(): Grid => Grid,
    /// Approach of the bodies from the datum of the initial gap (a length). On a grid that is periodic along x and y, it
    /// is the mean initial gap minus the mean gap under load.
    approach(): f64,
    /// Normal force, the integral of the pressure.
    force(): f64,
    /// Moments about x and y, at the origin of the grid, that the pressure exerts on body 1 (forces times lengths).
    moments(): (f64, f64) => pair,
    /// Number of contact cells.
    contact_cells(): usize,
    /// Contact area from counting cells. The property ``mean_pressure``, the stick ratio and the areas of spots are
    /// based on this area of the discrete contact. Its relative excess is about 0.3 times the ratio of cell side to
    /// contact radius.
    contact_area(): f64,
    /// Contact area minus the excess of cell counting along the perimeter. This area should be compared with theory and
    /// with other grids; its error is smaller than the error of ``contact_area`` by a factor of about four (Yastrebov,
    /// Anciaux & Molinari 2017).
    contact_area_corrected(): f64,
    /// Ratio of normal force to contact area; zero without contact.
    mean_pressure(): f64,
    /// Number of cells at their hardness.
    yielded_cells(): usize,
    /// Boundary condition at the edge of the grid.
    boundary(): Boundary => Boundary,
    /// Meaning of the value of a cell.
    cell_value(): Choice<stickslip::CellValue> => Choice,
    /// Estimate of the discretisation error of the pressure: the sum of the absolute differences from the exact cell
    /// means, relative to the sum of the pressure; ``None`` without contact, or for one slab of a distributed grid.
    discretisation_estimate(): Option<f64>,
    /// Termination, cost and error bound of the solve.
    report(): Report => Report::of,
    /// Warnings about a result that might mislead; empty if there are none.
    warnings(): Vec<Warning> => Warning::all,
}

#[pymethods]
impl NormalSolution {
    /// Unit of the gap from which the solution was computed; ``None`` if it is not known, as in the parts of coupled and adaptive
    /// solutions.
    #[getter]
    fn unit(&self) -> Option<&str> {
        self.unit_of_gap().map(|unit| &**unit)
    }

    /// Pressure p >= 0, shape (ny, nx); exactly zero outside the contact.
    #[getter]
    fn pressure<'py>(slf: &Bound<'py, Self>) -> Array<'py> {
        view(slf, |solution| solution.get().pressure())
    }

    /// Gap under load (lengths), shape (ny, nx): zero in the contact up to the residual, negative in cells that yield.
    #[getter]
    fn gap<'py>(slf: &Bound<'py, Self>) -> Array<'py> {
        view(slf, |solution| solution.get().gap())
    }

    /// Point where the normal force acts (lengths); ``None`` without contact.
    #[getter]
    fn centre_of_pressure(&self) -> Option<(f64, f64)> {
        self.get().centre_of_pressure().map(pair)
    }

    /// Mask of the cells in contact, booleans of shape (ny, nx): cells with positive pressure. The properties
    /// ``contact_cells`` and ``contact_area`` count these cells. A read-only copy.
    #[getter]
    fn contact<'py>(&self, py: Python<'py>) -> Array<'py, bool> {
        contact(py, self.get().pressure())
    }

    /// Sides of the bounding box of the contact along x and y (lengths); ``None`` without contact.
    #[getter]
    fn contact_extent(&self) -> Option<(f64, f64)> {
        self.get().contact_extent().map(pair)
    }

    /// Returns the edge of the contact inside the cells, and the pressure there.
    fn edges(&self, py: Python<'_>) -> PyResult<Edges> {
        let solution = self.get();
        unobserved_on(py, solution.grid(), || solution.edges()).map(Edges)
    }

    /// The two bodies.
    #[getter]
    fn pair(&self) -> ElasticPair {
        self.get().pair().into()
    }

    /// The individual contact spots. With distributed bodies, the call is collective.
    #[getter]
    fn spots(&self, py: Python<'_>) -> PyResult<ContactSpots> {
        let solution = self.get();
        unobserved_on(py, solution.grid(), || solution.spots()).map(ContactSpots::of)
    }

    /// Computes the normal displacement of all cells due to the pressure, summed over both bodies (lengths, positive into
    /// each body), shape (ny, nx). The cost is one product.
    fn displacement<'py>(
        &self,
        py: Python<'py>,
        bodies: Object<HalfSpace>,
    ) -> PyResult<Array<'py>> {
        let solution = self.get();
        let moved = unobserved_on(py, solution.grid(), || solution.displacement(&bodies.0))?;
        Ok(copy(py, &moved))
    }

    /// Computes the elastic energy of the normal contact (a force times a length). The cost is one product.
    fn elastic_energy(&self, py: Python<'_>, bodies: Object<HalfSpace>) -> PyResult<f64> {
        let solution = self.get();
        unobserved_on(py, solution.grid(), || solution.elastic_energy(&bodies.0))
    }

    /// Computes the normal stiffness, the derivative of the force with respect to the approach (a force over a length).
    /// The cost is one solve on the contact cells.
    fn stiffness(&self, py: Python<'_>, bodies: Object<HalfSpace>) -> PyResult<NormalStiffness> {
        let solution = self.get();
        let found = observed_on(py, solution.grid(), |observer| {
            solution.stiffness_observed(&bodies.0, watch(observer))
        });
        found.map(NormalStiffness)
    }

    fn __eq__(&self, other: &Self) -> bool {
        self.get() == other.get() && agree(self.unit_of_gap(), other.unit_of_gap())
    }

    fn __reduce__<'py>(&self, py: Python<'py>) -> PyResult<Reduced<'py>> {
        let unit = self.unit().map(String::from);
        reduced::<Self>(py, &(self.get().clone(), unit))
    }

    fn __repr__(&self) -> String {
        let solution = self.get();
        format!(
            "NormalSolution(force={}, approach={}, contact_cells={} of {}, {})",
            short(solution.force()),
            short(solution.approach()),
            solution.contact_cells(),
            solution.grid().cells(),
            ending(solution.report(), &solution.warnings())
        )
    }
}
