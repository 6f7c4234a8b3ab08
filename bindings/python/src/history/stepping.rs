//! Steps of histories.

use std::ops::ControlFlow;
use std::sync::Mutex;

use pyo3::exceptions::{PyTypeError, PyValueError};
use pyo3::prelude::*;
use rayon::prelude::*;
use stickslip::Error;

use crate::argument::{Listed, Object};
use crate::conversion;
use crate::error::{OrRaise, raised};
use crate::history::builder::{NAME, Work};
use crate::history::{Cycle, History, Rolling, StepResult};
use crate::load::{self, Keywords, LoadStep, StepArgument, keywords};
use crate::progress::Progress;
use crate::real::Real;
use crate::report::warn;
use crate::solution_pool::lock;
use crate::work::{solve, watch};

#[pymethods]
impl History {
    /// Takes a step, given as a :class:`LoadStep` or by its keywords. A quantity without a keyword is held: the
    /// pressure, the shift, the twist and the relative displacement. A step without arguments holds all of them, for example
    /// after a change of friction. Any history can be pressed by a step. For dissimilar
    /// bodies, whose stick zone depends on the growth of the contact, :meth:`press` is more accurate than a single step.
    ///
    /// A step without a tangential load holds the shift, not the tangential force. The force decreases if a lower
    /// pressure or less friction cannot carry it. To keep the force constant, prescribe it in each step.
    ///
    /// Parameters
    /// ----------
    /// load : LoadStep, optional
    ///     The step as an object, instead of by keywords.
    /// normal_force, approach, force, shift, spring, force_x, ..., roll : optional
    ///     See :class:`LoadStep`.
    /// progress : callable or bool, optional
    ///     See :meth:`NormalProblem.solve`.
    /// warn : bool, default True
    ///     Whether the warnings of the step are also issued through ``warnings``, each kind once per location.
    ///
    /// Returns
    /// -------
    /// StepResult
    ///     The result, whose fields are available until the next step; see :meth:`StepResult.keep`.
    ///
    /// Raises
    /// ------
    /// NotFinite, NegativeOrNotFinite, NotPositive, ApproachBeyondMeanGap, UnsupportedByModel, BeyondFrictionCapacity, EmptyContact,
    /// GridTooShort, NotConverged
    #[pyo3(signature = (load=None, *, normal_force=None, approach=None, force=None, shift=None, spring=None,
        force_x=None, force_y=None, shift_x=None, shift_y=None, spring_x=None, spring_y=None, twist=None,
        relative_displacement=None, roll=None, progress=None, warn=true))]
    fn step<'py>(
        slf: &Bound<'py, Self>,
        load: Option<StepArgument>,
        normal_force: Option<Real>,
        approach: Option<Real>,
        force: Option<conversion::Force>,
        shift: Option<conversion::Shift>,
        spring: Option<conversion::Springs>,
        force_x: Option<Real>,
        force_y: Option<Real>,
        shift_x: Option<Real>,
        shift_y: Option<Real>,
        spring_x: Option<conversion::Spring>,
        spring_y: Option<conversion::Spring>,
        twist: Option<Real>,
        relative_displacement: Option<Real>,
        roll: Option<Rolling>,
        progress: Option<Bound<'py, PyAny>>,
        #[pyo3(from_py_with = crate::real::flag)] warn: bool,
    ) -> PyResult<StepResult> {
        let py = slf.py();
        let keywords = keywords![
            force, shift, spring, force_x, force_y, shift_x, shift_y, spring_x, spring_y, twist
        ];
        let normal = load::normal(normal_force, approach)?;
        let load = keywords.step_or(load, normal, relative_displacement, roll)?;
        let progress = Progress::of(progress.as_ref())?;
        let own = slf.get();
        let mut work = lock(&own.work, NAME)?;
        let Work { history, taken, .. } = &mut *work;
        let outcome = solve(py, own.cells(), progress, |observer| {
            let seen = |iteration: &_| observer(Some(iteration));
            history.step_observed(&load, seen)?;
            *taken += 1;
            Ok(())
        })?;
        outcome.or_raise(py)?;
        let step = work.history.last_step().or_raise(py)?;
        let step = StepResult::last(step, slf.clone().unbind(), work.taken);
        drop(work);
        self::warn(py, warn, || step.warnings_of())?;
        Ok(step)
    }

    /// Applies a load in steps with equal growth of the contact, as many as a tolerance requires. Press a contact of
    /// dissimilar bodies in this way or in several steps, because the stick and slip zones depend on the growth of the
    /// contact. A single step issues a warning. A history with the coupling "one_way" needs the model "vector", because the scalar
    /// model omits the tractions across its axis. Its stick radius is too large, several times for a small friction
    /// coefficient.
    ///
    /// The load is applied in 1, 2, 4, 8, ... steps from the present state, until the tractions differ from the tractions
    /// for half the number of steps by no more than the tolerance. A call that fails, or that is interrupted by Ctrl-C,
    /// leaves the state unchanged. The history then has no last step until its next step.
    ///
    /// :attr:`last_step` is the last of these steps, with its slip and energy alone. For the wear of the load, give
    /// ``cycle``, or take the increase of :attr:`accumulated_dissipation`.
    ///
    /// Parameters
    /// ----------
    /// load : LoadStep, optional
    ///     The load as an object, instead of by keywords. All prescribed quantities change proportionally from their
    ///     previous values.
    /// tolerance : float
    ///     Largest sum of the magnitudes of the traction differences, relative to the sum of the friction limits, in (0,
    ///     1). A value of 0.01 is a good choice. The value must be at least about a hundred times the tolerance of the
    ///     settings.
    /// normal_force, approach : optional
    ///     See :class:`LoadStep`.
    /// cycle : Cycle, optional
    ///     A cycle to which each of these steps is added. It must start or end in the present state. The steps are taken a
    ///     second time for this purpose, with identical results. After an exception, restart the cycle by :meth:`Cycle.begin`.
    /// progress : callable or bool, optional
    ///     See :meth:`NormalProblem.solve`.
    /// warn : bool, default True
    ///     Whether the warnings of the last step are also issued through ``warnings``.
    ///
    /// Returns
    /// -------
    /// int
    ///     The number of steps.
    ///
    /// Raises
    /// ------
    /// Tolerance, StepTooLong
    ///     In addition to the exceptions of :meth:`step`.
    /// StepOutOfOrder
    ///     If the cycle does not start or end in the present state of this history.
    #[pyo3(signature = (load=None, *, tolerance=None, normal_force=None, approach=None, cycle=None, progress=None, warn=true),
        text_signature = "($self, load=None, *, tolerance, normal_force=None, approach=None, cycle=None, progress=None, warn=True)")]
    fn press<'py>(
        slf: &Bound<'py, Self>,
        load: Option<StepArgument>,
        tolerance: Option<Real>,
        normal_force: Option<Real>,
        approach: Option<Real>,
        cycle: Option<Object<Cycle>>,
        progress: Option<Bound<'py, PyAny>>,
        #[pyo3(from_py_with = crate::real::flag)] warn: bool,
    ) -> PyResult<usize> {
        let py = slf.py();
        let tolerance = tolerance.ok_or_else(|| {
            let message = "give the largest relative difference of the tractions by tolerance=, such as tolerance=0.01";
            PyTypeError::new_err(message)
        })?;
        let normal = match &load {
            None => Some(load::needed_as("normal_force", normal_force, approach)?),
            Some(_) => load::normal(normal_force, approach)?,
        };
        let load = Keywords::default().step_or(load, normal, None, None)?;
        let progress = Progress::of(progress.as_ref())?;
        let own = slf.get();
        let mut work = lock(&own.work, NAME)?;
        let tried = &mut *work;
        let mut locked = cycle.as_deref().map(Cycle::lock).transpose()?;
        let mut cycle = locked.as_deref_mut();
        let outcome = solve(py, own.cells(), progress, |observer| {
            tried.tried(|history| {
                let seen = watch(observer);
                match &mut cycle {
                    None => history.press_observed(&load, tolerance.0, seen),
                    Some(cycle) => {
                        let add = |history: &_| cycle.add(history);
                        history.press_steps_observed(&load, tolerance.0, seen, add)
                    }
                }
            })
        })?;
        let steps = outcome.or_raise(py)?;
        let warnings = work.history.last_step().or_raise(py)?.warnings();
        drop((work, locked));
        self::warn(py, warn, || warnings)?;
        Ok(steps)
    }

    /// Takes one step of each of several histories in parallel. A history whose step fails is unchanged, and the others take
    /// their steps.
    ///
    /// Parameters
    /// ----------
    /// histories : sequence of History
    ///     The histories, each listed once.
    /// loads : sequence of LoadStep
    ///     One load per history.
    /// return_exceptions : bool, default False
    ///     Whether the errors of failed steps are returned instead of raised.
    /// warn : bool, default True
    ///     Whether the warnings of the steps are also issued through ``warnings``, each kind once per location.
    ///
    /// Returns
    /// -------
    /// list of (int, StickslipError)
    ///     Indices and errors of the histories whose step failed; empty unless ``return_exceptions`` is true.
    ///
    /// Raises
    /// ------
    /// ArgumentType, Length
    /// ValueError
    ///     If a history is listed twice.
    /// StickslipError
    ///     If steps failed, after all steps: the error of the first failed history. Its message contains the index of this history
    ///     and the number of failed steps, and its attribute ``failures`` is the list of all indices and errors.
    #[staticmethod]
    #[pyo3(signature = (histories, loads, *, return_exceptions=false, warn=true))]
    fn step_all<'py>(
        py: Python<'py>,
        histories: Listed<'py, Self>,
        loads: Listed<'py, LoadStep>,
        #[pyo3(from_py_with = crate::real::flag)] return_exceptions: bool,
        #[pyo3(from_py_with = crate::real::flag)] warn: bool,
    ) -> PyResult<Vec<(usize, Bound<'py, PyAny>)>> {
        let (histories, loads) = (histories.objects, loads.objects);
        let (expected, found) = (histories.len(), loads.len());
        if expected != found {
            let quantity = "list of loads";
            return Err(raised(
                py,
                Error::Length {
                    quantity,
                    expected,
                    found,
                },
            ));
        }
        let loads: Vec<_> = loads.iter().map(|load| load.get().0).collect();
        let mut places = Vec::with_capacity(histories.len());
        for (index, history) in histories.iter().enumerate() {
            let first = histories[..index]
                .iter()
                .position(|other| other.is(history));
            if let Some(first) = first {
                return Err(PyValueError::new_err(format!(
                    "histories[{index}] is the same object as histories[{first}]: list each history once"
                )));
            }
            places.push(lock(&history.get().work, NAME)?);
        }
        let cells = histories.iter().map(|history| history.get().cells()).sum();
        let contacts = places.iter_mut().map(|place| &mut **place);
        let mut contacts: Vec<_> = contacts.zip(&loads).enumerate().collect();
        let failed = solve(py, cells, Progress::none(), |observer| {
            let observer = Mutex::new(observer);
            let step = |(index, (Work { history, taken, .. }, load)): &mut (
                usize,
                (&mut Work, &stickslip::LoadStep),
            )| {
                let seen = |_: &_| {
                    observer
                        .lock()
                        .map_or(ControlFlow::Continue(()), |mut seen| seen(None))
                };
                let outcome = history.step_observed(load, seen);
                *taken += u64::from(outcome.is_ok());
                outcome.err().map(|error| (*index, error))
            };
            Ok(contacts.par_iter_mut().filter_map(step).collect::<Vec<_>>())
        })?;
        let failed = failed.or_raise(py)?;
        drop(contacts);
        for (index, place) in places.into_iter().enumerate() {
            let has_failed = failed.iter().any(|(failed, _)| *failed == index);
            if !has_failed {
                let step = place.history.last_step().or_raise(py)?;
                self::warn(py, warn, || step.warnings())?;
            }
        }
        let first = failed.first().map(|(_, error)| error.clone());
        let exception = |error| raised(py, error).into_value(py).into_bound(py).into_any();
        let failures: Vec<_> = failed
            .into_iter()
            .map(|(index, error)| (index, exception(error)))
            .collect();
        match first.filter(|_| !return_exceptions) {
            None => Ok(failures),
            Some(first) => Err(first_of(py, first, expected, failures)?),
        }
    }

    /// Result of the last step, which led to the present state. Raises ``NoLastStep`` before the first step, after
    /// :meth:`set_state`, and after a restart.
    #[getter]
    fn last_step(slf: &Bound<'_, Self>) -> PyResult<StepResult> {
        let work = lock(&slf.get().work, NAME)?;
        let step = work.history.last_step().or_raise(slf.py())?;
        Ok(StepResult::last(step, slf.clone().unbind(), work.taken))
    }
}

/// Returns the error of the first failed history, whose message contains its index and the number of failed steps.
fn first_of<'py>(
    py: Python<'py>,
    error: Error,
    count: usize,
    failures: Vec<(usize, Bound<'py, PyAny>)>,
) -> PyResult<PyErr> {
    let exception = raised(py, error).into_value(py).into_bound(py);
    let message = format!(
        "histories[{}]: {exception} ({} of {count} steps failed: give return_exceptions=True for the list of errors)",
        failures[0].0,
        failures.len()
    );
    exception.setattr("args", (message,))?;
    exception.setattr("failures", failures)?;
    Ok(PyErr::from_value(exception.into_any()))
}
