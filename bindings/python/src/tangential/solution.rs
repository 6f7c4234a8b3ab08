//! Solutions of tangential contacts.

use std::sync::Arc;

use pyo3::prelude::*;

use crate::argument::Object;
use crate::array::{Array, copy, view, zones};
use crate::boundary::Boundary;
use crate::choice::Choice;
use crate::digits::{short, tuple};
use crate::edges::TangentialEdges;
use crate::friction::AnyFriction;
use crate::grid::Grid;
use crate::half_space::HalfSpace;
use crate::normal::NormalSolution;
use crate::pickle::{Reduced, Stored, reduced};
use crate::readers::readers;
use crate::report::{Report, Warning, ending};
use crate::sequence::pair;
use crate::spots::ContactSpots;
use crate::stiffness::TangentialStiffness;
use crate::work::{observed_on, unobserved_on, watch};

/// Owner of a tangential solution.
enum Source {
    Own(Arc<stickslip::TangentialSolution>),
    OfCoupled(Arc<stickslip::CoupledSolution>),
}

/// Traction, slip, zones and shift of a tangential contact. Vectors are (x, y); in the scalar model, the component across
/// the load is zero. Arrays are read-only views of the memory of this object, except for the zones, which are read-only copies. Two
/// objects are equal if their solutions are equal, even if the iterations differed.
#[pyclass(frozen, module = "stickslip")]
pub(crate) struct TangentialSolution(Source);

impl TangentialSolution {
    pub(crate) fn of_coupled(solution: &Arc<stickslip::CoupledSolution>) -> Self {
        Self(Source::OfCoupled(Arc::clone(solution)))
    }

    pub(crate) fn get(&self) -> &stickslip::TangentialSolution {
        match &self.0 {
            Source::Own(solution) => solution,
            Source::OfCoupled(solution) => solution.tangential(),
        }
    }
}

impl From<Arc<stickslip::TangentialSolution>> for TangentialSolution {
    fn from(solution: Arc<stickslip::TangentialSolution>) -> Self {
        Self(Source::Own(solution))
    }
}

impl Stored for TangentialSolution {
    type Content = stickslip::TangentialSolution;

    const KIND: &'static str = "TangentialSolution";

    fn of_content(content: Self::Content) -> Self {
        Arc::new(content).into()
    }
}

readers! { TangentialSolution.get():
    /// Grid of the fields.
    grid(): Grid => Grid,
    /// Shift along x and y (lengths): the rigid motion of body 2 relative to body 1 far from the contact, with the sign
    /// of the force.
    shift(): (f64, f64) => pair,
    /// Rotation of body 2 relative to body 1 about the origin of the grid (radians, positive from x to y).
    twist(): f64,
    /// Tangential force that body 2 exerts on body 1 along x and y.
    force(): (f64, f64) => pair,
    /// Moment about z, at the origin of the grid, on body 1 (a force times a length, positive from x to y).
    moment(): f64,
    /// Whether the whole contact slips.
    is_gross_slip(): bool,
    /// Ratio of stick area to contact area, from counting cells.
    stick_ratio(): f64,
    /// Area of the stick zone, from counting cells.
    stick_area(): f64,
    /// Area of the slip zone, from counting cells.
    slip_area(): f64,
    /// Energy dissipated by the step (a force times a length), not negative.
    dissipated_energy(): f64,
    /// Boundary condition at the edge of the grid.
    boundary(): Boundary => Boundary,
    /// Meaning of the value of a cell.
    cell_value(): Choice<stickslip::CellValue> => Choice,
    /// Estimate of the discretisation error of the tractions: the sum over the cells of the magnitudes of the differences
    /// from the exact means, relative to the sum of the magnitudes of the tractions; ``None`` without traction, or for
    /// one slab of a distributed grid.
    discretisation_estimate(): Option<f64>,
    /// Termination, cost and error bound of the solve.
    report(): Report => Report::of,
    /// Warnings about a result that might mislead; empty if there are none.
    warnings(): Vec<Warning> => Warning::all,
}

#[pymethods]
impl TangentialSolution {
    /// Shear traction on body 1 along x and y (pressures); exactly zero outside the contact.
    #[getter]
    fn traction<'py>(slf: &Bound<'py, Self>) -> (Array<'py>, Array<'py>) {
        (
            view(slf, |solution| solution.get().traction()[0]),
            view(slf, |solution| solution.get().traction()[1]),
        )
    }

    /// Slip of the surface of body 1 over the surface of body 2 along x and y (lengths); exactly zero in stick cells.
    #[getter]
    fn slip<'py>(slf: &Bound<'py, Self>) -> (Array<'py>, Array<'py>) {
        (
            view(slf, |solution| solution.get().slip()[0]),
            view(slf, |solution| solution.get().slip()[1]),
        )
    }

    /// Zone of each cell, a uint8 array of shape (ny, nx) with the values of :class:`Zone`: 0 separated, 1 stick, 2 slip.
    ///
    /// The array compares equal to these numbers, to members of :class:`Zone` and to their names: ``zones == "stick"`` is the
    /// mask of the stick zone.
    #[getter]
    fn zones<'py>(&self, py: Python<'py>) -> PyResult<Array<'py, u8>> {
        zones(py, self.get().grid(), self.get().zones())
    }

    /// The axis of the load in the scalar model; ``None`` in the vector model.
    #[getter]
    fn axis(&self) -> Option<Choice<stickslip::Axis>> {
        self.get().axis().map(Choice)
    }

    /// Returns the edges of the contact and of the stick zone inside the cells, for the pressure and the friction of the
    /// problem.
    ///
    /// Raises
    /// ------
    /// OutdatedSolution
    ///     If this solution was computed for a different pressure or friction.
    /// MaterialMismatch
    ///     If the materials differ.
    fn edges(
        &self,
        py: Python<'_>,
        normal: Object<NormalSolution>,
        friction: AnyFriction<'_>,
    ) -> PyResult<TangentialEdges> {
        let (solution, normal) = (self.get(), normal.get());
        let friction = friction.on(py, solution.grid())?;
        let found = unobserved_on(py, solution.grid(), || solution.edges(normal, &friction));
        found.map(TangentialEdges)
    }

    /// Returns the contact spots of the underlying normal contact, with their stick ratios.
    ///
    /// Raises
    /// ------
    /// OutdatedSolution
    ///     If this solution was computed for a different pressure.
    /// MaterialMismatch
    ///     If the materials differ.
    fn spots(&self, py: Python<'_>, normal: Object<NormalSolution>) -> PyResult<ContactSpots> {
        let (solution, normal) = (self.get(), normal.get());
        unobserved_on(py, solution.grid(), || solution.spots(normal)).map(ContactSpots::of)
    }

    /// Computes the displacement of body 1 relative to body 2 due to the tractions along x and y, for all cells
    /// (lengths). The cost is one product.
    fn displacement<'py>(
        &self,
        py: Python<'py>,
        bodies: Object<HalfSpace>,
    ) -> PyResult<(Array<'py>, Array<'py>)> {
        let solution = self.get();
        let moved = unobserved_on(py, solution.grid(), || solution.displacement(&bodies.0))?;
        Ok(moved.each_ref().map(|field| copy(py, field)).into())
    }

    /// Computes the elastic energy of shear (a force times a length). The cost is one product.
    fn elastic_energy(&self, py: Python<'_>, bodies: Object<HalfSpace>) -> PyResult<f64> {
        let solution = self.get();
        unobserved_on(py, solution.grid(), || solution.elastic_energy(&bodies.0))
    }

    /// Computes the tangential stiffness, for continued loading and at reversal.
    fn stiffness(
        &self,
        py: Python<'_>,
        bodies: Object<HalfSpace>,
    ) -> PyResult<TangentialStiffness> {
        let solution = self.get();
        let found = observed_on(py, solution.grid(), |observer| {
            solution.stiffness_observed(&bodies.0, watch(observer))
        });
        found.map(TangentialStiffness)
    }

    fn __eq__(&self, other: &Self) -> bool {
        self.get() == other.get()
    }

    fn __reduce__<'py>(&self, py: Python<'py>) -> PyResult<Reduced<'py>> {
        reduced::<Self>(py, self.get())
    }

    fn __repr__(&self) -> String {
        let solution = self.get();
        format!(
            "TangentialSolution(force={}, shift={}, stick_ratio={}, {})",
            tuple(&solution.force()),
            tuple(&solution.shift()),
            short(solution.stick_ratio()),
            ending(solution.report(), &solution.warnings())
        )
    }
}
