//! A history: its state, and how it takes a step.

use std::ops::ControlFlow;

use crate::cascade::Conditions;
use crate::cgm::{Iteration, Settings};
use crate::clock::Instant;
use crate::coupled::CoupledIncrement;
use crate::elastic::Observer;
use crate::error::Result;
use crate::field::Field;
use crate::half_space::HalfSpace;
use crate::history::builder::HistoryBuilder;
use crate::history::commit::commit;
use crate::history::joint::new_joint;
use crate::history::memory::Memory;
use crate::history::remarks::Remarks;
use crate::history::state::State;
use crate::history::touch;
use crate::history::{EnergyBalance, LoadStep, StepResult};
use crate::normal::{NormalControl, NormalProblem, NormalSolution, NormalSolver};
use crate::parallel;
use crate::passes::with_memory;
use crate::report::{Report, Status};
use crate::tangential::{Friction, Increment, Motion, Pressed, Start, TangentialModel};
use crate::window::Window;

/// Two bodies in contact that remember their load: pressure, traction, slip and energy, step by step.
///
/// Vectors are `[x, y]`; the scalar model leaves the component across its axis at zero.
///
/// Beside its bodies it takes 180 bytes per cell of the grid and 395 per cell of the contact's bounding box,
/// in the vector model ([`HistoryBuilder::model`]) 670 there, operators included. For bodies of different materials it
/// takes several times that. A contact that outgrows the box takes
/// a wider one for good, and in that step a quarter more in all, in the plane two fifths. After the first steps, a step
/// within it allocates nothing.
///
/// Its [`state`](Self::state) is a value: a clone of it keeps what to return to ([`set_state`](Self::set_state)) or to
/// continue from ([`from_state`](Self::from_state)), and [`to_bytes`](Self::to_bytes) saves it.
/// Many histories may share one [`HalfSpace`] on many threads: each comes to the bits it has alone.
///
/// ```
/// use stickslip::*;
/// let grid = Grid::square(48, 0.30e-3)?;
/// let steel = Material::new(213e9, 0.29)?;
/// let bodies = HalfSpace::new(grid, ElasticPair::new(steel, steel)?)?;
/// let ball = surface::sphere(grid, 3.5e-3)?;
/// let mut history = History::builder(&bodies, &ball, Friction::coulomb(0.5)?).build()?;
///
/// // Press, then shear to and fro.
/// history.step(&LoadStep::hold().normal(NormalControl::Force(100.0)))?;
/// let shear = |force| LoadStep::hold().tangential(Axis::X, TangentialControl::Force(force));
/// history.step(&shear(30.0))?;
/// let mut cycle = 0.0;
/// for force in [-30.0, 30.0] {
///     cycle += history.step(&shear(force))?.energy().dissipated_energy;
/// }
/// // A full cycle dissipates four times what the first quarter did.
/// let hertz = analytical::HertzSphere::new(bodies.pair(), 3.5e-3, 100.0)?;
/// let quarter = analytical::CattaneoMindlin::new(hertz, 0.5, 30.0)?.dissipated_energy();
/// assert!((cycle / (4.0 * quarter) - 1.0).abs() < 0.01);
///
/// // Without force the contact is not without shear.
/// history.step(&shear(0.0))?;
/// assert!(history.shift()[0] > 0.0 && history.traction()[0].max() > 0.0);
/// # Ok::<(), Error>(())
/// ```
#[derive(Debug, Clone)]
pub struct History {
    pub(super) bodies: HalfSpace,
    pub(super) state: State,
    pub(super) press: NormalSolver,
    /// The normal contact of the step under way.
    pub(super) candidate: NormalSolution,
    /// The tangential contact, on the window of the [`Memory`] in the state, if there is one; where pressure and shear are
    /// found together it serves the touch rule alone.
    pub(super) increment: Option<Increment>,
    /// Pressure and shear found together, instead of the above; none where they are not coupled.
    joint: Option<Box<CoupledIncrement>>,
    /// What takes the place of both if the step under way, which needs a wider window, succeeds.
    wider: Option<(Increment, Memory)>,
    pub(super) step: StepResult,
    /// Where the fields of the step are not all zero, if anywhere.
    written: Option<Window>,
}

const _: () = {
    const fn assert_send<T: Send>() {}
    assert_send::<History>();
};

impl History {
    /// Starts from what is required: bodies, gap before loading (lengths, on the grid of the bodies) and
    /// friction. Nothing touches and nothing is sheared before the first step.
    pub fn builder<'a>(
        bodies: &'a HalfSpace,
        gap: &'a Field,
        friction: Friction,
    ) -> HistoryBuilder<'a> {
        HistoryBuilder::new(bodies, gap, friction)
    }

    /// Starts from a state on the bodies it belongs to, to the same bits as the history that had it. Its
    /// [last step](Self::last_step) is empty.
    ///
    /// # Errors
    /// [`Error::GridMismatch`](crate::Error::GridMismatch),
    /// [`Error::BoundaryMismatch`](crate::Error::BoundaryMismatch) or
    /// [`Error::MaterialMismatch`](crate::Error::MaterialMismatch) for other bodies;
    /// [`Error::Memory`](crate::Error::Memory).
    pub fn from_state(bodies: &HalfSpace, state: State) -> Result<Self> {
        state.check_bodies(bodies)?;
        let mut press = NormalProblem::builder(bodies, &state.gap, NormalControl::Force(0.0))
            .settings(state.settings)
            .build()?
            .into_solver()?;
        state.resume(&mut press)?;
        Ok(Self {
            bodies: bodies.clone(),
            candidate: press.new_solution(),
            press,
            increment: new_increment(bodies, &state)?,
            joint: new_joint(bodies, &state)?,
            wider: None,
            step: StepResult::new(state.grid()),
            written: None,
            state,
        })
    }

    /// The state after the last step, without a copy.
    #[must_use]
    pub fn state(&self) -> &State {
        &self.state
    }

    /// Returns to a state, one of this history or of another on equal bodies: gap, friction and settings are those
    /// of the state too. It copies into the buffers that are there, and allocates only if the contact has outgrown
    /// its box since. [`last_step`](Self::last_step) still is the step taken last.
    ///
    /// # Errors
    /// As [`History::from_state`]; the history is then as it was.
    pub fn set_state(&mut self, state: &State) -> Result<()> {
        state.check_bodies(&self.bodies)?;
        if let Err(error) = state
            .resume(&mut self.press)
            .and_then(|()| self.resume(state))
        {
            self.take_back()?;
            return Err(error);
        }
        self.press.set_load(NormalControl::Force(0.0))?;
        self.press.set_gap(&state.gap)?;
        self.press.set_settings(state.settings)?;
        self.state.clone_from(state);
        Ok(())
    }

    /// Makes the increment fit another state: in the buffers there are, if they are of its window and model.
    fn resume(&mut self, state: &State) -> Result<()> {
        let is_alike = |own: &State| own.coupling == state.coupling && own.axes == state.axes;
        let fits = match (&self.increment, &state.contact) {
            (None, None) => true,
            // Made anew when the touch rule asks for another.
            _ if state.is_joint() => true,
            (Some(increment), Some(memory)) => increment.pressed.window == memory.window,
            _ => false,
        };
        if !(fits && is_alike(&self.state)) {
            self.increment = new_increment(&self.bodies, state)?;
        }
        match &mut self.joint {
            Some(joint) if state.is_joint() => joint.resume(state.press_window),
            joint => {
                *joint = new_joint(&self.bodies, state)?;
                Ok(())
            }
        }
    }

    /// Makes the solver of the pressure start from the state again.
    fn take_back(&mut self) -> Result<()> {
        let state = &self.state;
        if let Some(joint) = &mut self.joint {
            return joint.resume(state.press_window);
        }
        state.resume(&mut self.press)
    }

    /// Takes a step, and returns what it did; also [`History::last_step`] afterwards.
    ///
    /// # Errors
    /// [`Error::NotFinite`](crate::Error::NotFinite), [`Error::Negative`](crate::Error::Negative),
    /// [`Error::NotPositive`](crate::Error::NotPositive),
    /// [`Error::ApproachBeyondMeanGap`](crate::Error::ApproachBeyondMeanGap) or
    /// [`Error::NotModelled`](crate::Error::NotModelled) for the load;
    /// [`Error::BeyondFrictionCapacity`](crate::Error::BeyondFrictionCapacity) if friction does not hold the force;
    /// [`Error::NotConverged`](crate::Error::NotConverged). The history is then as it was, bit for bit.
    pub fn step(&mut self, load: &LoadStep) -> Result<&StepResult> {
        self.step_observed(load, |_| ControlFlow::Continue(()))
    }

    /// [`History::step`] with an observer that sees every iteration and may cancel.
    ///
    /// # Errors
    /// As [`History::step`].
    pub fn step_observed(
        &mut self,
        load: &LoadStep,
        mut observer: impl FnMut(&Iteration) -> ControlFlow<()> + Send,
    ) -> Result<&StepResult> {
        let demand = load.demand(self.twist());
        demand.check(self.state.axes, self.boundary())?;
        parallel::enter_with(self.grid().cells(), || {
            let outcome = self.take(load, &mut observer);
            if let Some(increment) = &mut self.increment {
                increment.rest();
            }
            outcome
        })?;
        Ok(&self.step)
    }

    /// Takes a step that has been checked.
    fn take(&mut self, load: &LoadStep, observer: Observer<'_>) -> Result<()> {
        let motion = match self.attempt(load, &mut with_memory(observer)) {
            Ok(motion) => motion,
            Err(error) => {
                self.take_back()?;
                self.wider = None;
                return Err(error);
            }
        };
        let Self { state, step, .. } = self;
        let mut pressing = EnergyBalance::default();
        let control = load.normal_control();
        if control == NormalControl::Hold && self.joint.is_none() {
            step.normal_report.clone_from(&Report::unsolved());
        } else if state.is_pressed_by(control) {
            step.normal_report.recall(state.normal.report());
        } else {
            if self.joint.is_some() {
                let before = (&state.normal, &state.pressed_gap);
                pressing = EnergyBalance::of_pressing(before, (&self.candidate, &state.gap));
            }
            std::mem::swap(&mut state.normal, &mut self.candidate);
            state.pressed_gap.clone_from(&state.gap);
            state.is_pressure_stale = false;
            state.pressed_by = control;
            let joint = self.joint.as_ref();
            state.press_window = joint.map_or_else(|| self.press.window(), |joint| joint.window());
            if let Some(trend) = self.press.trend().filter(|_| joint.is_none()) {
                state.trend.clone_from(trend);
            }
            step.normal_report.clone_from(state.normal.report());
        }
        step.remarks = Remarks {
            is_pressure_stale: state.is_pressure_stale,
            edge_cells: state.normal.cells_on_edge(),
            is_apart: state.normal.force() <= 0.0,
        };
        step.normal_force = state.normal.force();
        step.approach = state.approach();
        if let Some((increment, memory)) = self.wider.take() {
            (self.increment, state.contact) = (Some(increment), Some(memory));
        }
        let (joint, increment) = (self.joint.as_ref(), self.increment.as_ref());
        let sheared = joint.map(|joint| (joint.answer(), joint.report()));
        let sheared = sheared.or_else(|| increment.map(|part| (part.answer(), part.report())));
        let (answer, report) = sheared.unzip();
        step.tangential_report
            .clone_from(report.unwrap_or(&Report::unsolved()));
        commit(answer.as_ref(), motion, state, step, &mut self.written);
        step.energy = step.energy.plus(&pressing);
        Ok(())
    }

    /// Solves both halves of a step without a trace in the state; returns the motion of body 2 at its end.
    fn attempt(&mut self, load: &LoadStep, observer: Observer<'_>) -> Result<Motion> {
        if let Some(mut joint) = self.joint.take() {
            let motion = self.attempt_joint(&mut joint, load, observer);
            self.joint = Some(joint);
            return motion;
        }
        let control = load.normal_control();
        let is_held = control == NormalControl::Hold || self.state.is_pressed_by(control);
        let pressed = if is_held {
            &self.state.normal
        } else {
            self.press.set_load(control)?;
            self.press
                .solve_observed(&mut self.candidate, &mut *observer)?;
            &self.candidate
        };
        let (state, demand) = (&self.state, load.demand(self.state.motion.twist));
        self.wider = wider(&self.bodies, pressed.pressure(), state)?;
        let under_way = match &mut self.wider {
            Some((increment, memory)) => Some((increment, &*memory)),
            None => self.increment.as_mut().zip(state.contact.as_ref()),
        };
        let Some((increment, memory)) = under_way else {
            return demand.without_contact(state.axes, state.motion);
        };
        let pressure = pressed.pressure().as_slice();
        increment.pressed.set(pressure, &state.friction);
        increment.set_offset(&memory.offset);
        if !is_held {
            increment.draw_from(state.pressure().as_slice());
            touch::follow_growth(increment, state, pressed, load, &demand);
        }
        increment.set_traction(state.traction.each_ref().map(Field::as_slice));
        let mut conditions = Conditions {
            settings: &state.settings,
            start: Instant::now(),
            observer,
        };
        let start = match memory.parts_ahead(state, &demand) {
            Some(parts) => {
                increment.extrapolate(&memory.trend, parts);
                Start::Near
            }
            None => Start::Present(state.shift()),
        };
        increment.solve(&demand, state.motion, start, &mut conditions)?;
        Ok(increment.motion())
    }

    /// Changes the gap before loading, as wear does; all else stays, the pressure too until a step that does not
    /// hold it: give the normal load in the next step again. One that holds it carries
    /// [`Warning::StalePressure`](crate::Warning::StalePressure). Copies without allocating.
    ///
    /// # Errors
    /// [`Error::GridMismatch`](crate::Error::GridMismatch) or [`Error::Sample`](crate::Error::Sample); the gap
    /// is then as it was.
    pub fn set_gap(&mut self, gap: &Field) -> Result<()> {
        // The load of the last step has no say: the next brings its own.
        self.press.set_load(NormalControl::Force(0.0))?;
        self.press.set_gap(gap)?;
        let state = &mut self.state;
        let is_pressed = state.normal.report().status != Status::Unsolved;
        let differs = state.pressed_gap.as_slice() != gap.as_slice();
        state.is_pressure_stale = is_pressed && differs;
        state.gap.as_mut_slice().copy_from_slice(gap.as_slice());
        Ok(())
    }

    /// Changes the friction from the next step on; all else stays.
    ///
    /// # Errors
    /// [`Error::GridMismatch`](crate::Error::GridMismatch); the friction is then as it was.
    pub fn set_friction(&mut self, friction: &Friction) -> Result<()> {
        friction.check(self.grid())?;
        self.state.friction.clone_from(friction);
        Ok(())
    }

    /// Changes tolerance, method and limits from the next step on, as after a restart; the state stays. A tolerance
    /// that is tightened bounds what is still to come, not the errors of steps done.
    ///
    /// # Errors
    /// As [`Settings::check`], and [`Error::Method`](crate::Error::Method) for a method that the tangential model does
    /// not have; the settings are then as they were.
    pub fn set_settings(&mut self, settings: Settings) -> Result<()> {
        settings.check()?;
        TangentialModel::of(self.state.axes).check(&settings)?;
        self.press.set_settings(settings)?;
        self.state.settings = settings;
        Ok(())
    }
}

/// The increment on the window of a state's contact, if there is one.
fn new_increment(bodies: &HalfSpace, state: &State) -> Result<Option<Increment>> {
    let make = |memory: &Memory| {
        let pressed = Pressed::new(memory.window);
        Increment::new(bodies, state.axes, pressed, state.coupling)
    };
    let apart = state.contact.as_ref().filter(|_| !state.is_joint());
    apart.map(make).transpose()
}

/// Increment and memory that a pressure needs where the contact has left its window, or is the first.
fn wider(
    bodies: &HalfSpace,
    pressure: &Field,
    state: &State,
) -> Result<Option<(Increment, Memory)>> {
    let samples = pressure.as_slice();
    let Some(contact) = Window::around(bodies.grid(), |i| samples[i] > 0.0) else {
        return Ok(None);
    };
    let contact = bodies.confined(contact);
    match &state.contact {
        Some(memory) if memory.window.covers(contact) => Ok(None),
        Some(memory) => memory.widened(bodies, contact, state).map(Some),
        None => {
            let pressed = Pressed::new(contact);
            let increment = Increment::new(bodies, state.axes, pressed, state.coupling)?;
            let memory = Memory::first(bodies.grid(), state.axes, contact, state.motion);
            Ok(Some((increment, memory)))
        }
    }
}
