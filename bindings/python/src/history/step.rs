//! Results of a step of a history.

use std::sync::Arc;

use pyo3::exceptions::PyRuntimeError;
use pyo3::prelude::*;
use stickslip::Field;

use crate::array::{Array, energies, snapshot, view};
use crate::digits::{short, tuple};
use crate::grid::Grid;
use crate::history::{EnergyBalance, History};
use crate::pickle::{Reduced, Stored, reduced};
use crate::report::{Report, Warning, remarks};
use crate::sequence::pair;

/// Scalar results of a step.
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

/// Location of the fields of a step.
enum Fields {
    /// Fields stored in the history, valid until its next step.
    Last {
        history: Py<History>,
        number: u64,
    },
    Kept(Arc<stickslip::history::StepResult>),
}

/// Results of a step of a history: numbers and fields. The fields are available as long as the step is the last step of
/// the history, even if a later step fails. A restored state and a failed attempt of :class:`AdaptiveSteps` end this time.
/// The method :meth:`keep` copies the fields permanently. Vectors are (x, y).
#[pyclass(frozen, module = "stickslip.history")]
pub(crate) struct StepResult {
    numbers: Numbers,
    fields: Fields,
}

impl StepResult {
    /// Returns the last step of a history, with the number under which the history counts it.
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

    /// Reads the fields, wherever they are stored.
    fn read<T>(
        &self,
        py: Python<'_>,
        read: impl FnOnce(&stickslip::history::StepResult) -> T,
    ) -> PyResult<T> {
        match &self.fields {
            Fields::Kept(step) => Ok(read(step)),
            Fields::Last { history, number } => history.bind(py).get().read_step(*number, read)?.ok_or_else(|| {
                PyRuntimeError::new_err(
                    "the history has taken a further step, or its state was set: call keep() before that to keep the fields",
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
        slf.get()
            .read(slf.py(), |step| snapshot(slf.py(), of(step)))
    }

    /// Returns an array of energies together with its grid.
    fn of_energies<'py>(slf: &Bound<'py, Self>, array: &Array<'py>) -> PyResult<Array<'py>> {
        let py = slf.py();
        energies(py, array, slf.get().grid(py)?.0)
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
    /// Returns the same result with a copy of the fields, which remain available when the history continues.
    fn keep(&self, py: Python<'_>) -> PyResult<Self> {
        let step = match &self.fields {
            Fields::Kept(step) => Arc::clone(step),
            Fields::Last { .. } => Arc::new(self.read(py, Clone::clone)?),
        };
        Ok(Self::of(&step.clone(), Fields::Kept(step)))
    }

    /// Grid of the fields.
    #[getter]
    fn grid(&self, py: Python<'_>) -> PyResult<Grid> {
        self.read(py, |step| Grid(step.dissipation().grid()))
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

    /// Energy dissipated in each cell, from its traction at the end of the step (forces times lengths, not negative).
    #[getter]
    fn dissipation<'py>(slf: &Bound<'py, Self>) -> PyResult<Array<'py>> {
        let array = Self::field(slf, |step| step.dissipation())?;
        Self::of_energies(slf, &array)
    }

    /// Energy dissipated in each cell, computed from the mean of its tractions before and after the step (forces times
    /// lengths). Its sum closes the energy balance; see :attr:`EnergyBalance.dissipated_energy_midpoint`.
    #[getter]
    fn dissipation_midpoint<'py>(slf: &Bound<'py, Self>) -> PyResult<Array<'py>> {
        let array = Self::field(slf, |step| step.dissipation_midpoint())?;
        Self::of_energies(slf, &array)
    }

    /// Work, elastic energy and dissipation of the step.
    #[getter]
    fn energy(&self) -> EnergyBalance {
        EnergyBalance(self.numbers.energy)
    }

    /// Normal force at the end of the step.
    #[getter]
    fn normal_force(&self) -> f64 {
        self.numbers.normal_force
    }

    /// Approach at the end of the step (a length).
    #[getter]
    fn approach(&self) -> f64 {
        self.numbers.approach
    }

    /// Tangential force on body 1 along x and y at the end of the step.
    #[getter]
    fn tangential_force(&self) -> (f64, f64) {
        pair(self.numbers.force)
    }

    /// Moment about z at the end of the step (a force times a length, positive from x to y).
    #[getter]
    fn moment(&self) -> f64 {
        self.numbers.moment
    }

    /// Shift at the end of the step since the start, along x and y (lengths): the rigid motion of body 2 relative to
    /// body 1.
    #[getter]
    fn shift(&self) -> (f64, f64) {
        pair(self.numbers.shift)
    }

    /// Rotation at the end of the step (radians, positive from x to y).
    #[getter]
    fn twist(&self) -> f64 {
        self.numbers.twist
    }

    /// The creepages along x and y of a rolling step, prescribed or caused by the force (dimensionless); ``None`` without
    /// rolling.
    #[getter]
    fn creepage(&self) -> Option<(f64, f64)> {
        self.numbers.creepage.map(pair)
    }

    /// Ratio of stick cells to contact cells at the end of the step.
    #[getter]
    fn stick_ratio(&self) -> f64 {
        self.numbers.stick_ratio
    }

    /// Whether the whole contact is at its friction limit.
    #[getter]
    fn is_gross_slip(&self) -> bool {
        self.numbers.is_gross_slip
    }

    /// Report of the normal solve; ``None`` if the pressure was held constant.
    #[getter]
    fn normal_report(&self) -> Option<Report> {
        self.numbers.normal_report.clone().map(Report)
    }

    /// Report of the tangential solve; ``None`` before the first contact.
    #[getter]
    fn tangential_report(&self) -> Option<Report> {
        self.numbers.tangential_report.clone().map(Report)
    }

    /// Warnings of the step: ``no_contact``, ``contact_at_edge``, ``beyond_hardness``, ``stale_pressure``,
    /// ``single_load_step``, ``held_shift_lost_force``, and the warnings about contacts and zones of too few cells. Warnings about contact spots
    /// are in ``history.normal.warnings``, because a step does not search for spots.
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
