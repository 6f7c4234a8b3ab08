//! Pressure of a tangential contact.

use std::sync::Arc;

use pyo3::prelude::*;
use stickslip::PressureSource;

use crate::argument::argument;
use crate::field::Field;
use crate::normal::NormalSolution;
use crate::samples::Samples;
use crate::unit::Unit;

argument! {
    /// Pressure argument: a solved normal contact, or a field.
    Pressure: NormalSolution | Field
}

/// Pressure on the grid of the bodies, with its owner.
pub(crate) enum PressureArgument<'a> {
    Solved(&'a stickslip::NormalSolution),
    Field(Arc<stickslip::Field>),
}

/// Pressure that is returned to Python.
#[derive(IntoPyObject)]
pub(crate) enum AsObject<'py> {
    Solved(Bound<'py, PyAny>),
    Field(Field),
}

impl PressureArgument<'_> {
    pub(crate) fn source(&self) -> PressureSource<'_> {
        match self {
            Self::Solved(solution) => PressureSource::Solved(solution),
            Self::Field(field) => PressureSource::Prescribed(field),
        }
    }

    /// Returns the pressure as an immutable object, with which a problem can be constructed again.
    pub(crate) fn object<'py>(&self, given: &Pressure<'py>) -> AsObject<'py> {
        match self {
            Self::Solved(_) => AsObject::Solved(given.0.clone()),
            Self::Field(field) => AsObject::Field(Arc::clone(field).into()),
        }
    }
}

impl Pressure<'_> {
    /// Returns the unit of the gap of a solved normal contact, if it is known.
    pub(crate) fn unit_of_gap(&self) -> Option<Unit> {
        let solution = self.0.cast::<NormalSolution>().ok()?;
        solution.get().unit_of_gap().cloned()
    }

    pub(crate) fn given(
        &self,
        py: Python<'_>,
        grid: stickslip::Grid,
    ) -> PyResult<PressureArgument<'_>> {
        if let Ok(solution) = self.0.cast::<NormalSolution>() {
            return Ok(PressureArgument::Solved(solution.get().get()));
        }
        let samples: Samples<'_> = self.0.extract()?;
        samples
            .per_cell(py, "pressure", grid)
            .map(PressureArgument::Field)
    }
}
