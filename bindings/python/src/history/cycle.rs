//! Sums over the steps of a cycle.

use std::sync::{Mutex, MutexGuard};

use pyo3::prelude::*;

use crate::argument::Object;
use crate::array::{Array, energies, snapshot};
use crate::choice::Choice;
use crate::digits::{counted, rough, short, tuple};
use crate::error::OrRaise;
use crate::history::{EnergyBalance, History};
use crate::pickle::{Reduced, Stored, picklable, reduced};
use crate::readers::{frame, readers};
use crate::report::{Warning, remarks, warn};
use crate::sequence::{Entries, entry, pair};
use crate::solution_pool::lock;

/// Point of the force-shift loop.
#[pyclass(frozen, eq, module = "stickslip.history")]
#[derive(Clone, Copy, PartialEq)]
pub(crate) struct LoopPoint(stickslip::history::LoopPoint);

readers! { LoopPoint.0:
    /// Tangential force on body 1 along x and y.
    force: (f64, f64) => pair,
    /// Shift since the start of the history, along x and y (lengths).
    shift: (f64, f64) => pair,
    /// Moment about z (a force times a length, positive from x to y).
    moment: f64,
    /// Rotation since the start of the history (radians, positive from x to y).
    twist: f64,
}

#[pymethods]
impl LoopPoint {
    fn __repr__(&self) -> String {
        format!(
            "LoopPoint(force={}, shift={})",
            tuple(&self.0.force),
            tuple(&self.0.shift)
        )
    }
}

picklable!(LoopPoint: stickslip::history::LoopPoint);

/// The force-shift loop of a cycle, from its start to the end of each step: a sequence of :class:`LoopPoint`, and arrays
/// with one number per point. Vectors are (x, y).
#[pyclass(frozen, eq, module = "stickslip.history", sequence)]
#[derive(Clone, PartialEq)]
pub(crate) struct LoopPoints(Vec<stickslip::history::LoopPoint>);

impl LoopPoints {
    fn numbers<'py>(
        &self,
        py: Python<'py>,
        of: impl Fn(&stickslip::history::LoopPoint) -> f64,
    ) -> Array<'py> {
        Array::new(py, self.0.iter().map(of))
    }
}

#[pymethods]
impl LoopPoints {
    /// Tangential force on body 1 along x and y.
    #[getter]
    fn force<'py>(&self, py: Python<'py>) -> (Array<'py>, Array<'py>) {
        (
            self.numbers(py, |point| point.force[0]),
            self.numbers(py, |point| point.force[1]),
        )
    }

    /// Shift since the start of the history, along x and y (lengths).
    #[getter]
    fn shift<'py>(&self, py: Python<'py>) -> (Array<'py>, Array<'py>) {
        (
            self.numbers(py, |point| point.shift[0]),
            self.numbers(py, |point| point.shift[1]),
        )
    }

    /// Moment about z (a force times a length, positive from x to y).
    #[getter]
    fn moment<'py>(&self, py: Python<'py>) -> Array<'py> {
        self.numbers(py, |point| point.moment)
    }

    /// Rotation since the start of the history (radians, positive from x to y).
    #[getter]
    fn twist<'py>(&self, py: Python<'py>) -> Array<'py> {
        self.numbers(py, |point| point.twist)
    }

    fn __len__(&self) -> usize {
        self.0.len()
    }

    fn __iter__(&self) -> Entries<LoopPoint> {
        Entries::of(&self.0, LoopPoint)
    }

    fn __getitem__(&self, index: isize) -> PyResult<LoopPoint> {
        entry(&self.0, index, "point").copied().map(LoopPoint)
    }

    fn __repr__(&self) -> String {
        format!("LoopPoints({})", counted(self.0.len(), "point"))
    }
}

picklable!(LoopPoints: Vec<stickslip::history::LoopPoint>);

frame!(LoopPoints, record: force, shift, moment, twist);

/// Slip, energy and the force-shift loop, accumulated over the steps of a cycle from the present state of the history.
/// The arrays are read-only copies.
///
/// Parameters
/// ----------
/// history : History
///     The history in whose present state the cycle starts.
#[pyclass(frozen, module = "stickslip.history")]
pub(crate) struct Cycle(Mutex<stickslip::history::Cycle>);

impl Stored for Cycle {
    type Content = stickslip::history::Cycle;

    const KIND: &'static str = "Cycle";

    fn of_content(content: Self::Content) -> Self {
        Self(Mutex::new(content))
    }
}

impl Cycle {
    pub(crate) fn lock(&self) -> PyResult<MutexGuard<'_, stickslip::history::Cycle>> {
        lock(&self.0, "cycle")
    }
}

#[pymethods]
impl Cycle {
    #[new]
    fn new(history: Object<History>) -> PyResult<Self> {
        let cycle = history.read(stickslip::history::Cycle::new)?;
        Ok(Self(Mutex::new(cycle)))
    }

    /// Discards all steps and restarts the cycle in the present state of the history.
    ///
    /// Raises
    /// ------
    /// GridMismatch, BoundaryMismatch, MaterialMismatch
    ///     If the history has other bodies than the history of the cycle.
    fn begin(&self, py: Python<'_>, history: Object<History>) -> PyResult<()> {
        let mut cycle = self.lock()?;
        history.read(|history| cycle.begin(history))?.or_raise(py)
    }

    /// Adds the last step of the history; call it once after each step.
    ///
    /// Add a step only after it is accepted. :meth:`History.set_state` does not remove an added step from the cycle. Copy the
    /// cycle by ``copy.copy`` before a step that may be rejected after it is added.
    ///
    /// Raises
    /// ------
    /// NoLastStep
    ///     If the history has taken no step since it was created or since :meth:`History.set_state`.
    /// StepOutOfOrder
    ///     If the last step of the history is not the next step of the cycle: skipped, already added, or not later than its start.
    ///     A step of another history is rejected too, unless both histories had equal forces and motions before it.
    /// GridMismatch, BoundaryMismatch, MaterialMismatch
    ///     If the history has other bodies than the history of the cycle.
    fn add(&self, py: Python<'_>, history: Object<History>) -> PyResult<()> {
        let mut cycle = self.lock()?;
        history.read(|history| cycle.add(history))?.or_raise(py)
    }

    /// Number of steps added.
    #[getter]
    fn steps(&self) -> PyResult<usize> {
        Ok(self.lock()?.steps())
    }

    /// Length of the path that each cell slipped in the cycle (lengths, not negative).
    #[getter]
    fn slip_distance<'py>(&self, py: Python<'py>) -> PyResult<Array<'py>> {
        Ok(snapshot(py, self.lock()?.slip_distance()))
    }

    /// Pressure under which each cell slipped, averaged over its slip path; zero for cells without slip.
    #[getter]
    fn slip_pressure<'py>(&self, py: Python<'py>) -> PyResult<Array<'py>> {
        Ok(snapshot(py, self.lock()?.slip_pressure()))
    }

    /// Half the range of the slip of each cell along x and y (lengths, not negative).
    #[getter]
    fn slip_amplitude<'py>(&self, py: Python<'py>) -> PyResult<(Array<'py>, Array<'py>)> {
        Ok(self
            .lock()?
            .slip_amplitude()
            .map(|field| snapshot(py, field))
            .into())
    }

    /// Energy that each cell dissipated in the cycle (forces times lengths, not negative). The array contains its grid, as the
    /// attribute ``grid``. The sum of the array is ``energy.dissipated_energy``.
    #[getter]
    fn dissipation<'py>(&self, py: Python<'py>) -> PyResult<Array<'py>> {
        let cycle = self.lock()?;
        let (array, grid) = (
            snapshot(py, cycle.dissipation()),
            cycle.dissipation().grid(),
        );
        drop(cycle);
        energies(py, &array, grid)
    }

    /// Work, elastic energy and dissipation of the cycle.
    #[getter]
    fn energy(&self) -> PyResult<EnergyBalance> {
        Ok(EnergyBalance(*self.lock()?.energy()))
    }

    /// The force-shift loop: the start, and the end of each step. A copy.
    #[getter]
    fn points(&self) -> PyResult<LoopPoints> {
        Ok(LoopPoints(self.lock()?.points().to_vec()))
    }

    /// Work of the tangential force and of the moment (a force times a length), equal to the area enclosed by the loop if
    /// it is closed. In contrast, the ``work`` of :attr:`energy` includes the work of a changing relative displacement,
    /// such as bulk strain.
    #[getter]
    fn work_of_loads(&self) -> PyResult<f64> {
        Ok(self.lock()?.work_of_loads())
    }

    /// Returns the loop as CSV.
    fn points_as_csv(&self) -> PyResult<String> {
        Ok(self.lock()?.points_as_csv())
    }

    /// Header line of :meth:`summary_as_csv`.
    #[classattr]
    const SUMMARY_NAMES: &str = stickslip::history::Cycle::SUMMARY_NAMES;

    /// Returns the cycle as a line of CSV.
    ///
    /// Raises
    /// ------
    /// EmptyPath
    ///     If the cycle has no steps.
    fn summary_as_csv(&self, py: Python<'_>) -> PyResult<String> {
        self.lock()?.summary_as_csv().or_raise(py)
    }

    /// Half the range of the force along x and y.
    #[getter]
    fn force_amplitude(&self) -> PyResult<(f64, f64)> {
        Ok(pair(self.lock()?.force_amplitude()))
    }

    /// Half the range of the shift along x and y (lengths).
    #[getter]
    fn shift_amplitude(&self) -> PyResult<(f64, f64)> {
        Ok(pair(self.lock()?.shift_amplitude()))
    }

    /// Smallest and largest stick ratio.
    ///
    /// Raises
    /// ------
    /// EmptyPath
    ///     If the cycle has no steps.
    #[getter]
    fn stick_ratios(&self, py: Python<'_>) -> PyResult<(f64, f64)> {
        Ok(pair(self.lock()?.stick_ratios().or_raise(py)?))
    }

    /// Regime of the cycle: stick, partial slip or sliding.
    ///
    /// Raises
    /// ------
    /// EmptyPath
    ///     If the cycle has no steps.
    #[getter]
    fn regime(&self, py: Python<'_>) -> PyResult<Choice<stickslip::history::Regime>> {
        Ok(Choice(self.lock()?.regime().or_raise(py)?))
    }

    /// Ratio of the dissipated energy to the area of a rectangle around the force-shift loop.
    ///
    /// The ratio has no meaning for a path that does not return to its start. The warnings ``open_cycle`` and ``repeated_loop``
    /// of the cycle are also issued by ``warnings.warn`` when the ratio is read.
    ///
    /// Raises
    /// ------
    /// EmptyPath
    ///     If the cycle has no steps.
    #[getter]
    fn energy_ratio(&self, py: Python<'_>) -> PyResult<f64> {
        let cycle = self.lock()?;
        let (ratio, mut warnings) = (cycle.energy_ratio(), cycle.warnings());
        drop(cycle);
        warnings.retain(|warning| {
            matches!(
                warning,
                stickslip::Warning::OpenCycle { .. } | stickslip::Warning::RepeatedLoop
            )
        });
        warn(py, true, || warnings)?;
        ratio.or_raise(py)
    }

    /// Measure of how far the cycle is from closing: the larger of two ratios. The first is the ratio of the largest
    /// change of a traction between start and end to the largest traction. The second is the ratio of the change of the
    /// shift to half the range of the shift.
    ///
    /// Raises
    /// ------
    /// EmptyPath
    ///     If the cycle has no steps.
    #[getter]
    fn cyclic_residual(&self, py: Python<'_>) -> PyResult<f64> {
        self.lock()?.cyclic_residual().or_raise(py)
    }

    /// Warnings of the steps.
    #[getter]
    fn warnings(&self) -> PyResult<Vec<Warning>> {
        Ok(Warning::all(self.lock()?.warnings()))
    }

    fn __reduce__<'py>(&self, py: Python<'py>) -> PyResult<Reduced<'py>> {
        reduced::<Self>(py, &*self.lock()?)
    }

    fn __repr__(&self) -> PyResult<String> {
        let cycle = self.lock()?;
        let (Ok(regime), Ok(ratio), Ok(residual)) = (
            cycle.regime(),
            cycle.energy_ratio(),
            cycle.cyclic_residual(),
        ) else {
            return Ok("Cycle(steps=0)".into());
        };
        Ok(format!(
            "Cycle(steps={}, regime='{}', energy.dissipated_energy={}, energy_ratio={}, cyclic_residual={}{})",
            cycle.steps(),
            Choice(regime).name(),
            short(cycle.energy().dissipated_energy),
            short(ratio),
            rough(residual),
            remarks(&cycle.warnings())
        ))
    }
}
