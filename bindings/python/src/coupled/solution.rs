//! Solutions of coupled contacts.

use std::sync::{Arc, OnceLock};

use pyo3::prelude::*;

use crate::argument::Object;
use crate::array::{Array, contact, view};
use crate::coupled::CoupledReport;
use crate::digits::{short, tuple};
use crate::friction::AnyFriction;
use crate::half_space::HalfSpace;
use crate::normal::NormalSolution;
use crate::pickle::{Reduced, Stored, reduced};
use crate::readers::readers;
use crate::report::{Warning, ending};
use crate::stiffness::ContactStiffness;
use crate::tangential::TangentialSolution;
use crate::unit::{GapUnit, Unit, agree};
use crate::work::{observed_on, watch};

/// Normal and tangential solution of a coupled contact, with the displacements that they cause together. Both solutions
/// and the arrays share the memory of this object. Two objects are equal if their solutions are equal and their units do
/// not differ, even if the iterations differed.
#[pyclass(frozen, module = "stickslip")]
pub(crate) struct CoupledSolution(
    pub(crate) Arc<stickslip::CoupledSolution>,
    /// Unit of the gap. Solves set it in the finished object.
    OnceLock<Unit>,
);

impl CoupledSolution {
    pub(crate) fn get(&self) -> &stickslip::CoupledSolution {
        &self.0
    }
}

impl From<Arc<stickslip::CoupledSolution>> for CoupledSolution {
    fn from(solution: Arc<stickslip::CoupledSolution>) -> Self {
        Self(solution, OnceLock::new())
    }
}

impl GapUnit for CoupledSolution {
    fn unit_cell(&self) -> &OnceLock<Unit> {
        &self.1
    }
}

impl Stored for CoupledSolution {
    type Content = (stickslip::CoupledSolution, Option<String>);

    const KIND: &'static str = "CoupledSolution";

    fn of_content((solution, unit): Self::Content) -> Self {
        let unit = unit.map_or_else(OnceLock::new, |unit| OnceLock::from(Unit::from(unit)));
        Self(Arc::new(solution), unit)
    }
}

readers! { CoupledSolution.0:
    /// Elastic energy of both bodies.
    elastic_energy(): f64,
    /// Termination, cost and error bounds of the solve.
    report(): CoupledReport => CoupledReport::of,
    /// Warnings about a result that might mislead; empty if there are none.
    warnings(): Vec<Warning> => Warning::all,
}

#[pymethods]
impl CoupledSolution {
    /// The normal solution.
    #[getter]
    fn normal(&self) -> NormalSolution {
        NormalSolution::of_coupled(&self.0, self.1.get().cloned())
    }

    /// The tangential solution.
    #[getter]
    fn tangential(&self) -> TangentialSolution {
        TangentialSolution::of_coupled(&self.0)
    }

    /// Mask of the cells in contact, booleans of shape (ny, nx): cells with positive pressure. A read-only copy.
    #[getter]
    fn contact<'py>(&self, py: Python<'py>) -> Array<'py, bool> {
        contact(py, self.0.normal().pressure())
    }

    /// Displacements of all cells along x, y and z (lengths).
    #[getter]
    fn displacement<'py>(slf: &Bound<'py, Self>) -> (Array<'py>, Array<'py>, Array<'py>) {
        (
            view(slf, |solution| solution.0.displacement()[0]),
            view(slf, |solution| solution.0.displacement()[1]),
            view(slf, |solution| solution.0.displacement()[2]),
        )
    }

    /// Returns the derivatives of the forces and the moment with respect to approach, shift and twist, with the friction
    /// of the problem.
    fn stiffness(
        &self,
        py: Python<'_>,
        bodies: Object<HalfSpace>,
        friction: AnyFriction<'_>,
    ) -> PyResult<ContactStiffness> {
        let (solution, bodies) = (&self.0, &bodies.0);
        let friction = friction.on(py, bodies.grid())?;
        let found = observed_on(py, bodies.grid(), |observer| {
            solution.stiffness_observed(bodies, &friction, watch(observer))
        });
        found.map(ContactStiffness)
    }

    fn __eq__(&self, other: &Self) -> bool {
        self.0 == other.0 && agree(self.1.get(), other.1.get())
    }

    fn __reduce__<'py>(&self, py: Python<'py>) -> PyResult<Reduced<'py>> {
        let unit = self.1.get().map(ToString::to_string);
        reduced::<Self>(py, &((*self.0).clone(), unit))
    }

    fn __repr__(&self) -> String {
        let (normal, tangential) = (self.0.normal(), self.0.tangential());
        format!(
            "CoupledSolution(normal_force={}, force={}, stick_ratio={}, {})",
            short(normal.force()),
            tuple(&tangential.force()),
            short(tangential.stick_ratio()),
            ending(&self.0.report().work, &self.0.warnings())
        )
    }
}
