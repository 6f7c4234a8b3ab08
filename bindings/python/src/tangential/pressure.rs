//! The pressure that a tangential contact is under.

use std::sync::Arc;

use pyo3::prelude::*;
use stickslip::PressureSource;

use crate::argument::argument;
use crate::field::{Field, Samples};
use crate::normal::NormalSolution;

argument! {
    /// A pressure: a solved normal contact, or a field.
    Pressure: NormalSolution | Field
}

/// The pressure on the grid of the bodies, with what owns it.
pub(crate) enum PressureArgument<'a> {
    Solved(&'a stickslip::NormalSolution),
    Field(Arc<stickslip::Field>),
}

/// A pressure on its way to Python.
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

    /// As an object that nobody changes, by which it is given again.
    pub(crate) fn object<'py>(&self, given: &Pressure<'py>) -> AsObject<'py> {
        match self {
            Self::Solved(_) => AsObject::Solved(given.0.clone()),
            Self::Field(field) => AsObject::Field(Arc::clone(field).into()),
        }
    }
}

impl Pressure<'_> {
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
            .on(py, "pressure", grid)
            .map(PressureArgument::Field)
    }
}
