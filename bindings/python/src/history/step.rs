//! What a step of a history did.

use std::sync::Arc;

use pyo3::exceptions::PyRuntimeError;
use pyo3::prelude::*;
use stickslip::Field;

use crate::array::{Array, copy, view};
use crate::digits::{short, tuple};
use crate::history::{EnergyBalance, History};
use crate::pickle::{Reduced, Stored, reduced};
use crate::report::{Report, Warning, remarks};
use crate::sequence::pair;

/// The numbers of a step.
#[derive(PartialEq)]
pub(super) struct Numbers {
    energy: stickslip::history::EnergyBalance,
    normal_force: f64,
    approach: f64,
    force: [f64; 2],
    moment: f64,
    shift: [f64; 2],
    twist: f64,
    creepage: Option<[f64; 2]>,
    stick_ratio: f64,
    is_gross_slip: bool,
    normal_report: Option<stickslip::Report>,
    tangential_report: Option<stickslip::Report>,
    warnings: Vec<stickslip::Warning>,
}

impl Numbers {
    pub(super) fn of(step: &stickslip::history::StepResult) -> Self {
        Self {
            energy: *step.energy(),
            normal_force: step.normal_force(),
            approach: step.approach(),
            force: step.tangential_force(),
            moment: step.moment(),
            shift: step.shift(),
            twist: step.twist(),
            creepage: step.creepage(),
            stick_ratio: step.stick_ratio(),
            is_gross_slip: step.is_gross_slip(),
            normal_report: step.normal_report().cloned(),
            tangential_report: step.tangential_report().cloned(),
            warnings: step.warnings(),
        }
    }
}

/// Where its fields are.
enum Fields {
    /// With the history, until it takes another step.
    Last {
        history: Py<History>,
        number: u64,
    },
    Kept(Arc<stickslip::history::StepResult>),
}

/// What a step of a history did: its numbers, and its fields for as long as it is the last one, also after a step that
/// failed; after an attempt of :class:`AdaptiveSteps` that failed, the last step is that of the attempt. :meth:`keep` copies
/// them, for good. Vectors are (x, y).
#[pyclass(frozen, module = "stickslip.history")]
pub(crate) struct StepResult {
    numbers: Numbers,
    fields: Fields,
}

impl StepResult {
    /// The last step of a history, under the number by which that knows it.
    pub(crate) fn last(
        step: &stickslip::history::StepResult,
        history: Py<History>,
        number: u64,
    ) -> Self {
        Self::of(step, Fields::Last { history, number })
    }

    fn of(step: &stickslip::history::StepResult, fields: Fields) -> Self {
        let numbers = Numbers::of(step);
        Self { numbers, fields }
    }

    pub(crate) fn warnings_of(&self) -> Vec<stickslip::Warning> {
        self.numbers.warnings.clone()
    }

    /// Its fields read, wherever they are.
    fn read<T>(
        &self,
        py: Python<'_>,
        read: impl FnOnce(&stickslip::history::StepResult) -> T,
    ) -> PyResult<T> {
        match &self.fields {
            Fields::Kept(step) => Ok(read(step)),
            Fields::Last { history, number } => history.bind(py).get().read_step(*number, read)?.ok_or_else(|| {
                PyRuntimeError::new_err(
                    "the history has taken another step since: keep() its fields before the next one",
                )
            }),
        }
    }

    fn field<'py>(
        slf: &Bound<'py, Self>,
        of: impl for<'a> Fn(&'a stickslip::history::StepResult) -> &'a Field,
    ) -> PyResult<Array<'py>> {
        if let Fields::Kept(_) = &slf.get().fields {
            return Ok(view(slf, |result| match &result.fields {
                Fields::Kept(step) => of(step),
                Fields::Last { .. } => unreachable!("a frozen object stays what it is"),
            }));
        }
        slf.get().read(slf.py(), |step| copy(slf.py(), of(step)))
    }
}

impl Stored for StepResult {
    type Content = stickslip::history::StepResult;

    const KIND: &'static str = "StepResult";

    fn of_content(content: Self::Content) -> Self {
        let step = Arc::new(content);
        Self::of(&step.clone(), Fields::Kept(step))
    }
}

#[pymethods]
impl StepResult {
    /// The same with a copy of the fields, which stay when the history goes on.
    fn keep(&self, py: Python<'_>) -> PyResult<Self> {
        let step = match &self.fields {
            Fields::Kept(step) => Arc::clone(step),
            Fields::Last { .. } => Arc::new(self.read(py, Clone::clone)?),
        };
        Ok(Self::of(&step.clone(), Fields::Kept(step)))
    }

    /// Slip of the step along x and y (lengths).
    #[getter]
    fn slip<'py>(slf: &Bound<'py, Self>) -> PyResult<(Array<'py>, Array<'py>)> {
        Ok((
            Self::field(slf, |step| step.slip()[0])?,
            Self::field(slf, |step| step.slip()[1])?,
        ))
    }

    /// Length of the slip of the step (lengths, not negative).
    #[getter]
    fn slip_distance<'py>(slf: &Bound<'py, Self>) -> PyResult<Array<'py>> {
        Self::field(slf, |step| step.slip_distance())
    }

    /// Energy that each cell dissipates, by its traction at the end (forces times lengths, not negative).
    #[getter]
    fn dissipated_energy<'py>(slf: &Bound<'py, Self>) -> PyResult<Array<'py>> {
        Self::field(slf, |step| step.dissipated_energy())
    }

    /// Energy that each cell dissipates, by the mean of its tractions before and after (forces times lengths).
    #[getter]
    fn dissipated_energy_midpoint<'py>(slf: &Bound<'py, Self>) -> PyResult<Array<'py>> {
        Self::field(slf, |step| step.dissipated_energy_midpoint())
    }

    /// Work, elastic energy and dissipation.
    #[getter]
    fn energy(&self) -> EnergyBalance {
        EnergyBalance(self.numbers.energy)
    }

    /// Normal force at its end.
    #[getter]
    fn normal_force(&self) -> f64 {
        self.numbers.normal_force
    }

    /// Approach at its end (a length).
    #[getter]
    fn approach(&self) -> f64 {
        self.numbers.approach
    }

    /// Tangential force on body 1 along x and y at its end.
    #[getter]
    fn tangential_force(&self) -> (f64, f64) {
        pair(self.numbers.force)
    }

    /// Moment about z at its end (a force times a length, positive from x to y).
    #[getter]
    fn moment(&self) -> f64 {
        self.numbers.moment
    }

    /// Shift of body 2 relative to body 1 along x and y at its end (lengths).
    #[getter]
    fn shift(&self) -> (f64, f64) {
        pair(self.numbers.shift)
    }

    /// Rotation at its end (radians, positive from x to y).
    #[getter]
    fn twist(&self) -> f64 {
        self.numbers.twist
    }

    /// The creepages along x and y of a step that rolled, prescribed or caused by the force (dimensionless); ``None`` if it
    /// did not roll.
    #[getter]
    fn creepage(&self) -> Option<(f64, f64)> {
        self.numbers.creepage.map(pair)
    }

    /// Stick cells over contact cells at its end.
    #[getter]
    fn stick_ratio(&self) -> f64 {
        self.numbers.stick_ratio
    }

    /// Whether the whole contact is at its friction limit.
    #[getter]
    fn is_gross_slip(&self) -> bool {
        self.numbers.is_gross_slip
    }

    /// How the normal contact was solved; ``None`` if the pressure was held.
    #[getter]
    fn normal_report(&self) -> Option<Report> {
        self.numbers.normal_report.clone().map(Report)
    }

    /// How the tangential contact was solved; ``None`` before anything has touched.
    #[getter]
    fn tangential_report(&self) -> Option<Report> {
        self.numbers.tangential_report.clone().map(Report)
    }

    /// Remarks on the step: ``no_contact``, ``contact_at_edge``, ``beyond_hardness``, ``stale_pressure``,
    /// ``single_load_step`` and those on contacts and zones of too few cells. Warnings of
    /// contact spots are in ``history.normal.warnings``: a step does not search for spots.
    #[getter]
    fn warnings(&self) -> Vec<Warning> {
        Warning::all(self.warnings_of())
    }

    fn __reduce__<'py>(&self, py: Python<'py>) -> PyResult<Reduced<'py>> {
        self.read(py, |step| reduced::<Self>(py, step))?
    }

    fn __repr__(&self) -> String {
        let Numbers {
            normal_force,
            force,
            shift,
            stick_ratio,
            warnings,
            ..
        } = &self.numbers;
        format!(
            "StepResult(normal_force={}, force={}, shift={}, stick_ratio={}{})",
            short(*normal_force),
            tuple(force),
            tuple(shift),
            short(*stick_ratio),
            remarks(warnings)
        )
    }
}
