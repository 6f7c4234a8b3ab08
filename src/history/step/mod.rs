//! A history: its state, and how it takes a step.

pub(super) mod adaptive;
pub(super) mod batch;
pub(super) mod closing_gaps;
pub(super) mod commit;
pub(super) mod coupled_steps;
pub(super) mod diagnostics;
pub(super) mod neglected;
pub(super) mod pool;
pub(super) mod pressing;
pub(super) mod result;
pub(super) mod rolled;
pub(super) mod solve;

use std::ops::ControlFlow;
use std::sync::Arc;

use crate::cgm::{Iteration, Settings, reduce};
use crate::coupled::CoupledIncrement;
use crate::error::{Error, Result};
use crate::grid::field::Field;
use crate::grid::window::Window;
use crate::half_space::HalfSpace;
use crate::history::builder::HistoryBuilder;
use crate::history::state::State;
use crate::history::state::permanent_set::{add_yielded, update_permanent_set};
use crate::history::state::window_shrinking::narrow;
use crate::history::step::commit::commit;
use crate::history::step::coupled_steps::new_joint;
use crate::history::step::diagnostics::StepDiagnostics;
use crate::history::step::neglected::NeglectedLift;
use crate::history::step::pool::IncrementPool;
use crate::history::{EnergyBalance, LoadStep, StepResult};
use crate::memory::fallible::TryClone;
use crate::memory::pool::PooledBuffer;
use crate::normal::{NormalControl, NormalSolution, PressureSolver};
use crate::observer::Observer;
use crate::parallel;
use crate::report::{Report, Status};
use crate::support::debug::shown;
use crate::tangential::{Friction, RigidMotion, TangentialIncrement, TangentialModel};
use crate::warning::Resolution;

/// Two bodies in contact that remember their load: pressure, traction, slip and energy, step by step.
///
/// Vectors are `[x, y]`; the scalar model leaves the component across its axis at zero.
///
/// Beside its bodies it takes 168 bytes per cell of the grid and 350 per cell of the contact's bounding box,
/// in the vector model ([`HistoryBuilder::model`]) 590 there, operators included. Most of it is borrowed for a step at a
/// time: further histories of the same bodies, with boxes of the same size, take 121 and 51 (91) each, as long as they
/// are not stepped at once. A relative displacement adds 32 bytes per cell of the grid. For bodies of different materials
/// it takes several times that.
///
/// A contact that outgrows the box takes a wider one; one that needs at most half its cells, before a step and after it,
/// takes a smaller one. What was made for other boxes is kept for 256 steps, while it serves no more than twice the cells
/// of the largest: a contact that goes to and fro between such boxes allocates nothing after the first cycles. Its state
/// keeps room for the largest; a clone of it does not.
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
/// let quarter = analytical::CattaneoMindlin::new(hertz, 0.5, 30.0)?.energy_of_first_quarter();
/// assert!((cycle / (4.0 * quarter) - 1.0).abs() < 0.01);
///
/// // Without force the contact is not without shear.
/// history.step(&shear(0.0))?;
/// assert!(history.shift()[0] > 0.0 && history.traction()[0].max() > 0.0);
/// # Ok::<(), Error>(())
/// ```
#[derive(Clone)]
pub struct History {
    pub(crate) bodies: HalfSpace,
    pub(crate) state: State,
    pub(super) press: PressureSolver,
    /// The normal contact of the step under way.
    pub(super) candidate: PooledBuffer<NormalSolution>,
    pub(super) increments: IncrementPool,
    /// The tangential contact of the step under way.
    pub(super) increment: Option<TangentialIncrement>,
    /// Pressure and traction found together, instead of the above; none where they are not coupled.
    pub(super) joint: Option<Box<CoupledIncrement>>,
    pub(super) step: StepResult,
    /// Lift by the tractions of rolled steps with one-way coupling; `None` before the first such step.
    pub(super) lifting: Option<NeglectedLift>,
    /// Where the fields of the step are not all zero, if anywhere.
    written: Option<Window>,
}

shown!(History: bodies, state);

/// How the parts of a state that slabs have in common are called.
const ALL_BUT_FIELDS: &str = "state but for its fields";

const _: () = {
    const fn assert_send<T: Send>() {}
    assert_send::<History>();
};

impl History {
    /// Starts from what is required: bodies, gap before loading (lengths, on the grid of the bodies) and
    /// friction. The gap is copied from a reference, and from an [`Arc`] that others hold; given by value it is not. Nothing
    /// touches and no traction acts before the first step.
    pub fn builder(
        bodies: &HalfSpace,
        gap: impl Into<Arc<Field>>,
        friction: Friction,
    ) -> HistoryBuilder<'_> {
        HistoryBuilder::new(bodies, gap.into(), friction)
    }

    /// Starts from a state on the bodies it belongs to, to the same bits as the history that had it. Its
    /// [last step](Self::last_step) is empty.
    ///
    /// # Errors
    /// [`Error::GridMismatch`],
    /// [`Error::BoundaryMismatch`] or
    /// [`Error::MaterialMismatch`] for other bodies;
    /// [`Error::Memory`]; [`Error::Ranks`].
    pub fn from_state(bodies: &HalfSpace, mut state: State) -> Result<Self> {
        bodies.collective_result_checked(
            state.check_bodies(bodies),
            &[(ALL_BUT_FIELDS, &state.digest_on(bodies))],
        )?;
        state.gather_whole(bodies);
        let mut press = PressureSolver::new();
        state.resume(bodies, &mut press)?;
        bodies.joint(Ok(()))?;
        Ok(Self {
            bodies: bodies.clone(),
            candidate: PooledBuffer::new(bodies.pool(&[], bodies.grid().size())?),
            press,
            increments: IncrementPool::default(),
            increment: None,
            joint: new_joint(bodies, &state)?,
            step: StepResult::new(state.grid())?,
            lifting: None,
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
    /// of the state too. It copies into the buffers that are there, and allocates only if the contact has had
    /// another box since, or where only one of the two states has a relative displacement.
    /// [`last_step`](Self::last_step) still is the step taken last.
    ///
    /// # Errors
    /// As [`History::from_state`]; the history is then as it was.
    pub fn set_state(&mut self, state: &State) -> Result<()> {
        self.bodies.collective_result_checked(
            state.check_bodies(&self.bodies),
            &[(ALL_BUT_FIELDS, &state.numbers_on(&self.bodies))],
        )?;
        // Ranks that lose each other on the way keep what they have.
        let is_copied = self.bodies.is_shared() || !self.state.has_room_for(state);
        let mut whole = is_copied.then(|| state.try_clone()).transpose()?;
        if let Some(whole) = &mut whole {
            whole.gather_whole(&self.bodies);
        }
        let Self { press, joint, .. } = self;
        let resumed = resume(&self.bodies, state, press, joint);
        if let Err(error) = self.bodies.joint(resumed) {
            self.take_back()?;
            return Err(error);
        }
        if let Some(whole) = whole {
            self.state = whole;
        } else {
            self.state.clone_from(state);
            // A state that was read from bytes has no scale.
            let State {
                normal,
                pressed_gap,
                ..
            } = &mut self.state;
            normal.measure_scale(&self.bodies, pressed_gap);
        }
        Ok(())
    }

    /// Returns to a state that this history had, also where ranks have lost each other.
    pub(super) fn go_back(&mut self, state: &mut State) -> Result<()> {
        if self.state.has_room_for(state) {
            self.state.clone_from(state);
        } else {
            std::mem::swap(&mut self.state, state);
        }
        self.bodies.joint(Ok(()))?;
        self.take_back()
    }

    /// Makes what finds the pressure start from the state again.
    pub(super) fn take_back(&mut self) -> Result<()> {
        let Self { press, joint, .. } = self;
        resume(&self.bodies, &self.state, press, joint)
    }

    /// Takes a step, and returns what it did; also [`History::last_step`] afterwards.
    ///
    /// # Errors
    /// [`Error::NotFinite`], [`Error::NegativeOrNotFinite`],
    /// [`Error::NotPositive`],
    /// [`Error::ApproachBeyondMeanGap`] or
    /// [`Error::UnsupportedByModel`] for the load; [`Error::GridTooShort`] if the grid ends less than a rolled step ahead of
    /// the contact or behind it; [`Error::BeyondFrictionCapacity`] if friction does not hold the force;
    /// [`Error::EmptyContact`] for a tangential force while no cell carries pressure;
    /// [`Error::NotConverged`]; [`Error::Ranks`]. The history is then as it was, bit for bit.
    pub fn step(&mut self, load: &LoadStep) -> Result<&StepResult> {
        self.step_observed(load, |_| ControlFlow::Continue(()))
    }

    /// [`History::step`] with an observer that sees every iteration and may cancel. Should it panic, the history is as it
    /// was too, for a caller that catches that.
    ///
    /// Once the observer has cancelled a step, the step returns [`Error::NotConverged`] with [`Status::Cancelled`], even if
    /// the tractions are within the tolerance. The history is then unchanged. If ranks share a history, the observer of the
    /// first rank decides.
    ///
    /// # Errors
    /// As [`History::step`].
    pub fn step_observed(
        &mut self,
        load: &LoadStep,
        mut observer: impl FnMut(&Iteration) -> ControlFlow<()> + Send,
    ) -> Result<&StepResult> {
        let demand = self.state.demand(load, &self.bodies);
        let checked = self.state.check_rolling(load, &self.bodies);
        let checked = checked.and_then(|()| demand.check(self.state.axes, self.boundary()));
        let checked = checked.and_then(|()| self.state.check_relative(load));
        self.bodies
            .collective_result_checked(checked, &[("load", load)])?;
        let outcome = parallel::enter_with(self.grid().cells(), || {
            let outcome = self.take(load, &mut observer);
            if let Some(increment) = self.increment.take() {
                self.increments.give_back(increment);
            }
            self.candidate.give_back();
            outcome
        });
        self.bodies.joint(outcome)?;
        Ok(&self.step)
    }

    /// Takes a step that has been checked.
    fn take(&mut self, load: &LoadStep, observer: Observer<'_>) -> Result<()> {
        let remembered = self.state.contact.as_ref().map(|memory| memory.window);
        let motion = self.attempt(load, observer)?;
        // Ranks that lose each other on the way into the state go back.
        let is_shared = self.bodies.is_shared();
        let keep = || Ok::<_, Error>((self.state.try_clone()?, self.step.try_clone()?));
        let kept = is_shared.then(keep).transpose()?;
        self.enter(load, motion);
        let entered = self.bodies.joint(Ok(()));
        if let (Err(_), Some(kept)) = (&entered, kept) {
            (self.state, self.step) = kept;
            self.state.crop_memory(remembered);
        }
        entered
    }

    /// Makes a step that was solved part of the state.
    fn enter(&mut self, load: &LoadStep, motion: RigidMotion) {
        let Self { state, step, .. } = self;
        let (mut pressing, press_window) = (EnergyBalance::default(), state.press_window);
        let (control, is_pressed) = (load.normal_control(), self.candidate.held().is_some());
        let travel = load.rolling().map(|rolling| rolling.travel(&self.bodies));
        match self.candidate.held_mut() {
            None if control == NormalControl::Hold => {
                step.normal_report.clone_from(&Report::unsolved());
            }
            None => step.normal_report.recall(state.normal.report()),
            Some(candidate) => {
                let joint = self.joint.as_ref();
                if joint.is_some() {
                    let before = (&state.normal, &state.pressed_gap);
                    let (layout, after) = (self.bodies.grid_layout(), (&*candidate, &state.gap));
                    let place = |i: usize| travel.map_or(Some(i), |travel| travel.before(i));
                    pressing = EnergyBalance::of_pressing(&layout, before, after, place);
                }
                std::mem::swap(&mut state.normal, candidate);
                state.pressed_gap.clone_from(&state.gap);
                state.is_pressure_stale = false;
                state.pressed_by = control;
                let alone = || self.press.window();
                state.press_window = joint.map_or_else(alone, |joint| joint.window());
                if joint.is_none() {
                    self.press.write_trend(&mut state.trend);
                }
                step.normal_report.clone_from(state.normal.report());
            }
        }
        step.remarks = StepDiagnostics {
            is_pressed_at_once: false,
            is_pressure_stale: state.is_pressure_stale,
            edge_cells: state.normal.cells_on_edge(),
            is_apart: state.normal.force() <= 0.0,
            overloaded_cells: state.normal.overloaded_cells(),
            neglected_lift: load
                .rolling()
                .and(self.lifting.as_ref())
                .and_then(|lifting| lifting.found),
            ..StepDiagnostics::default()
        };
        step.normal_force = state.normal.force();
        step.approach = state.approach();
        let (joint, increment) = (self.joint.as_ref(), self.increment.as_ref());
        let solved = joint.map(|joint| (joint.answer(), joint.report()));
        let solved = solved.or_else(|| increment.map(|part| (part.answer(), part.report())));
        let (answer, report) = solved.unzip();
        step.tangential_report
            .clone_from(report.unwrap_or(&Report::unsolved()));
        let moved = motion.since(state.motion).shift;
        let [x, y] = state.force;
        let force_before = x.hypot(y);
        let before = self.candidate.held().map(NormalSolution::pressure);
        commit(
            answer.as_ref(),
            motion,
            travel.as_ref(),
            before,
            state,
            step,
            &mut self.written,
        );
        let rolled = load.rolling().zip(travel);
        step.creepage = rolled.map(|(rolling, travel)| rolling.reached(load, moved, travel.length));
        if let Some(memory) = &mut state.contact {
            match (joint, increment) {
                (Some(joint), _) => {
                    memory.has_entered = joint.write_entered(&mut memory.entered);
                }
                (None, Some(increment)) => {
                    memory.has_entered = increment.write_entered(&mut memory.entered);
                }
                (None, None) => memory.forget_step(),
            }
        }
        let zones = [step.stick_cells, step.slip_cells];
        step.remarks.resolution = Resolution::of_contact(state.grid().whole(), zones[0] + zones[1])
            .with_zones(zones, || state.normal.edge_sides());
        if travel.is_some() {
            step.remarks.resolution = step.remarks.resolution.of_rolling();
        }
        if let (Some(before), None) = (before, travel) {
            let layout = self.bodies.grid_layout();
            step.remarks.is_pressed_at_once = state.has_grown_at_once(before, &layout);
        }
        state.reach(load);
        if is_pressed {
            update_permanent_set(state);
            state.gather_capacity(&self.bodies);
            state.normal.measure_scale(&self.bodies, &state.pressed_gap);
        }
        step.remarks.scale = state.normal.scale();
        if load.holds_shift() && !step.remarks.is_apart {
            step.remarks.lost_per_cent = lost_per_cent(force_before, step);
        }
        step.energy = step.energy.plus(&pressing);
        let margins = travel.map_or([0; 2], |travel| travel.margins());
        narrow(&self.bodies, state, before, press_window, margins);
    }

    /// Changes the gap before loading, as wear does; all else stays, the pressure too until a step that does not
    /// hold it: give the normal load in the next step again. Before a step that [rolls](crate::history#rolling) it is the
    /// gap of that step, with a texture moved on. What has [yielded](State::yielded) is added to it. A step that holds the
    /// pressure carries [`Warning::StalePressure`](crate::Warning::StalePressure). Copies without allocating.
    ///
    /// # Errors
    /// [`Error::GridMismatch`] or [`Error::Sample`];
    /// [`Error::Ranks`]; the gap is then as it was.
    pub fn set_gap(&mut self, gap: &Field) -> Result<()> {
        self.bodies
            .collective_result(gap.check("gap", self.grid()))?;
        let state = &mut self.state;
        let is_pressed = state.normal.report().status != Status::Unsolved;
        let (pressed, new) = (state.pressed_gap.as_slice(), gap.as_slice());
        let yielded = state.yielded.as_ref().map(Field::as_slice);
        let differs = reduce::any(&self.bodies.grid_layout(), |i| {
            let set = yielded.map_or(0.0, |yielded| yielded[i]);
            pressed[i] - (new[i] + set) != 0.0
        });
        self.bodies.joint(Ok(()))?;
        state.gap.as_mut_slice().copy_from_slice(new);
        add_yielded(state);
        state.is_pressure_stale = is_pressed && differs;
        Ok(())
    }

    /// Changes the friction from the next step on; all else stays.
    ///
    /// # Errors
    /// [`Error::GridMismatch`]; [`Error::Ranks`]; the friction is then as
    /// it was.
    pub fn set_friction(&mut self, friction: &Friction) -> Result<()> {
        friction.check_on(&self.bodies)?;
        let capacity = self.state.capacity_on_ranks(&self.bodies, friction);
        self.bodies.joint(Ok(()))?;
        self.state.friction.try_clone_from(friction)?;
        self.state.capacity = capacity;
        Ok(())
    }

    /// Changes tolerance, method and limits from the next step on, as after a restart; the state stays. A tolerance
    /// that is tightened bounds what is still to come, not the errors of steps done.
    ///
    /// # Errors
    /// As [`Settings::check`], and [`Error::Method`] for a method that the tangential model does
    /// not have; [`Error::Ranks`]; the settings are then as they were.
    pub fn set_settings(&mut self, settings: Settings) -> Result<()> {
        let model = TangentialModel::of(self.state.axes);
        let checked = settings.check().and_then(|()| model.check(&settings));
        self.bodies
            .collective_result_checked(checked, &[("settings", &settings.common())])?;
        self.state.settings = settings;
        Ok(())
    }
}

/// The clone takes the same steps, bit for bit. Its first step allocates the buffers that it works in.
impl TryClone for History {
    fn try_clone(&self) -> Result<Self> {
        let (bodies, state) = (&self.bodies, self.state.try_clone()?);
        let (mut press, mut joint) = (PressureSolver::new(), None);
        resume(bodies, &state, &mut press, &mut joint)?;
        Ok(Self {
            bodies: bodies.clone(),
            candidate: self.candidate.clone(),
            press,
            increments: IncrementPool::default(),
            increment: None,
            joint,
            step: self.step.try_clone()?,
            lifting: None,
            written: self.written,
            state,
        })
    }

    fn has_room_for(&self, _: &Self) -> bool {
        false
    }
}

/// Returns the part of the tangential force that a step lost, in per cent; zero for a force that is round-off of the normal
/// force.
#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "the number lies between 0 and 100"
)]
fn lost_per_cent(before: f64, step: &StepResult) -> usize {
    const ROUND_OFF: f64 = 1e-3;
    let [x, y] = step.force;
    let lost = 1.0 - x.hypot(y) / before;
    if before > ROUND_OFF * step.normal_force && lost > 0.0 {
        (100.0 * lost).round() as usize
    } else {
        0
    }
}

/// Makes what finds the pressure continue from a state, in the buffers there are if they are of its window.
fn resume(
    bodies: &HalfSpace,
    state: &State,
    press: &mut PressureSolver,
    joint: &mut Option<Box<CoupledIncrement>>,
) -> Result<()> {
    state.resume(bodies, press)?;
    match joint {
        Some(joint) if state.is_joint() => joint.resume(state.press_window),
        joint => {
            *joint = new_joint(bodies, state)?;
            Ok(())
        }
    }
}
