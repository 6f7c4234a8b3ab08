//! History of a contact: its state and its steps.

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
pub(super) mod scheme;
pub(super) mod sequential;
pub(super) mod solve;

use std::ops::ControlFlow;
use std::sync::Arc;

use crate::cgm::{Settings, reduce};
use crate::error::{Error, Result};
use crate::grid::field::Field;
use crate::grid::window::Window;
use crate::half_space::HalfSpace;
use crate::history::builder::HistoryBuilder;
use crate::history::state::State;
use crate::history::state::permanent_set::{add_yielded, check_without_set};
use crate::history::step::scheme::Scheme;
use crate::history::step::solve::StepInput;
use crate::history::{LoadStep, StepResult};
use crate::memory::fallible::TryClone;
use crate::memory::pool::PooledBuffer;
use crate::normal::{LoadedCell, NormalSolution};
use crate::observer::Observer;
use crate::parallel;
use crate::report::Iteration;
use crate::report::Status;
use crate::support::debug::shown;
use crate::tangential::{Friction, TangentialModel};

/// Two bodies in contact with a load history: pressure, traction, slip and energy after each step.
///
/// Vectors are `[x, y]`. In the scalar model the component across the axis of the tractions is zero.
///
/// # Memory
/// In addition to its bodies, a history needs 168 bytes per cell of the grid. It also needs 350 bytes per cell of the bounding
/// box of the contact, or 590 in the vector model ([`HistoryBuilder::model`]). These numbers include the operators. Most of this
/// memory is borrowed for the duration of a step. Further histories of the same bodies with boxes of the same size need less
/// memory if they are not stepped concurrently. Each needs 121 bytes per cell of the grid and 51 bytes per cell of the box (91
/// in the vector model). A relative displacement adds 32 bytes per cell of the grid. Histories of bodies of different materials
/// need several times as much memory.
///
/// A contact that outgrows its box moves to a wider box. A contact moves to a smaller box if it needs at most half of the cells
/// of its box before and after a step. Buffers for other boxes are kept for 256 steps, if these boxes cover at most twice the
/// cells of the largest box. A contact that alternates between these boxes allocates no memory after the first cycles. The state
/// of the history keeps memory for the largest box, but a clone of the state does not.
///
/// # State and threads
/// The [`state`](Self::state) is a value. A clone of it can be restored ([`set_state`](Self::set_state)) or continued
/// ([`from_state`](Self::from_state)), and [`to_bytes`](Self::to_bytes) saves it. Many histories may share one [`HalfSpace`] on
/// many threads. The result of each history is bitwise identical to its result alone.
///
/// # Examples
///
/// ```
/// use stickslip::*;
/// let grid = Grid::square(48, 0.30e-3)?;
/// let steel = Material::new(213e9, 0.29)?;
/// let bodies = HalfSpace::new(grid, ElasticPair::new(steel, steel)?)?;
/// let ball = surface::sphere(grid, 3.5e-3)?;
/// let mut history = History::builder(&bodies, &ball, Friction::coulomb(0.5)?).build()?;
///
/// // Press, then shear back and forth.
/// history.step(&LoadStep::hold().normal(NormalControl::Force(100.0)))?;
/// let shear = |force| LoadStep::hold().tangential(Axis::X, TangentialControl::Force(force));
/// history.step(&shear(30.0))?;
/// let mut cycle = 0.0;
/// for force in [-30.0, 30.0] {
///     cycle += history.step(&shear(force))?.energy().dissipated_energy;
/// }
/// // A full cycle dissipates four times as much as the first quarter.
/// let hertz = analytical::HertzSphere::new(bodies.pair(), 3.5e-3, 100.0)?;
/// let quarter = analytical::CattaneoMindlin::new(hertz, 0.5, 30.0)?.energy_of_first_quarter();
/// assert!((cycle / (4.0 * quarter) - 1.0).abs() < 0.01);
///
/// // The contact retains traction without a force.
/// history.step(&shear(0.0))?;
/// assert!(history.shift()[0] > 0.0 && history.traction()[0].max() > 0.0);
/// # Ok::<(), Error>(())
/// ```
#[derive(Clone)]
pub struct History {
    pub(crate) bodies: HalfSpace,
    pub(crate) state: State,
    scheme: Scheme,
    /// Normal contact of the present step.
    candidate: PooledBuffer<NormalSolution>,
    pub(super) step: StepResult,
    /// Whether `step` led to the present state.
    pub(super) has_last_step: bool,
    /// Window in which the fields of the step may be non-zero, or `None` if all fields are zero.
    written: Option<Window>,
}

shown!(History: bodies, state);

/// Name of the values that all slabs of a state have in common, for error messages.
const ALL_BUT_FIELDS: &str = "state (except for its fields)";

const _: () = {
    const fn assert_send<T: Send>() {}
    assert_send::<History>();
};

impl History {
    /// Starts a builder from the required input: bodies, gap before loading (lengths, on the grid of the bodies) and
    /// friction. A gap passed by reference or in an [`Arc`] with other owners is copied. A gap passed by value is not copied.
    /// Before the first step there is neither contact nor traction.
    pub fn builder(
        bodies: &HalfSpace,
        gap: impl Into<Arc<Field>>,
        friction: Friction,
    ) -> HistoryBuilder<'_> {
        HistoryBuilder::new(bodies, gap.into(), friction)
    }

    /// Creates a history from a state, on the bodies that the state belongs to. The history continues with results
    /// bitwise identical to the results of the original history. It has no [last step](Self::last_step) before its next step.
    ///
    /// # Errors
    /// - [`Error::GridMismatch`], [`Error::BoundaryMismatch`] or [`Error::MaterialMismatch`] if the state belongs to
    ///   other bodies.
    /// - [`Error::Memory`] if memory runs out.
    /// - [`Error::Ranks`] if ranks fail or pass different states.
    pub fn from_state(bodies: &HalfSpace, mut state: State) -> Result<Self> {
        bodies.collective_result_checked(
            state.check_bodies(bodies),
            &[(ALL_BUT_FIELDS, &state.digest_on(bodies))],
        )?;
        state.gather_whole(bodies);
        let mut scheme = Scheme::default();
        scheme.continue_from(bodies, &state)?;
        bodies.joint(Ok(()))?;
        Ok(Self {
            bodies: bodies.clone(),
            candidate: PooledBuffer::new(bodies.pool(&[], bodies.grid().size())?),
            scheme,
            step: StepResult::new(state.grid())?,
            has_last_step: false,
            written: None,
            state,
        })
    }

    /// Returns a reference to the state after the last step.
    #[must_use]
    pub fn state(&self) -> &State {
        &self.state
    }

    /// Restores a state of this history, or of another history on equal bodies. The state is copied into the existing
    /// buffers. The function allocates memory if the contact has moved to a different window since the state was saved. It
    /// also allocates memory if only one of the two states has a relative displacement.
    ///
    /// The state replaces everything except for the bodies:
    ///
    /// - the gap ([`set_gap`](Self::set_gap)), with its plastic depth,
    /// - the friction ([`set_friction`](Self::set_friction)),
    /// - the pattern of the relative displacement ([`set_relative_displacement`](Self::set_relative_displacement)) and its
    ///   amount,
    /// - the settings ([`set_settings`](Self::set_settings)),
    /// - hardness, model, coupling and entry rule of the [builder](crate::history::HistoryBuilder).
    ///
    /// A setter that was called after the state was saved therefore has no effect. Call it again after `set_state`. A setter that
    /// was called before the state was saved acts in the next step, also after [`from_state`](Self::from_state) and
    /// [`from_bytes`](Self::from_bytes).
    ///
    /// The history then has no [last step](Self::last_step) until its next step, because a state does not contain the result of
    /// the step that led to it. [`Cycle::add`](crate::history::Cycle::add) returns [`Error::NoLastStep`] until then. In a retry,
    /// restore the state, take a smaller step, and add this step to the cycle. A rejected step that was added stays in the
    /// cycle.
    ///
    /// # Errors
    /// Errors of [`History::from_state`]. The history is unchanged after an error.
    pub fn set_state(&mut self, state: &State) -> Result<()> {
        self.bodies.collective_result_checked(
            state.check_bodies(&self.bodies),
            &[(ALL_BUT_FIELDS, &state.numbers_on(&self.bodies))],
        )?;
        // On distributed bodies the function restores a copy, so that a rank failure leaves the present state unchanged.
        let is_copied = self.bodies.is_shared() || !self.state.has_room_for(state);
        let mut whole = is_copied.then(|| state.try_clone()).transpose()?;
        if let Some(whole) = &mut whole {
            whole.gather_whole(&self.bodies);
        }
        let resumed = self.scheme.continue_from(&self.bodies, state);
        if let Err(error) = self.bodies.joint(resumed) {
            self.take_back()?;
            return Err(error);
        }
        if let Some(whole) = whole {
            self.state = whole;
        } else {
            self.state.clone_from(state);
            // A state that was read from bytes does not contain the scale.
            let State {
                normal,
                pressed_gap,
                ..
            } = &mut self.state;
            normal.measure_scale(&self.bodies, pressed_gap);
        }
        self.has_last_step = false;
        Ok(())
    }

    /// Restores an earlier state of this history, even after a rank failure.
    pub(super) fn go_back(&mut self, state: &mut State) -> Result<()> {
        // Without a step since then, the last step is still the step that led to the state.
        self.has_last_step &= self.state.steps == state.steps;
        if self.state.has_room_for(state) {
            self.state.clone_from(state);
        } else {
            std::mem::swap(&mut self.state, state);
        }
        self.bodies.joint(Ok(()))?;
        self.take_back()
    }

    /// Makes the solvers of the pressure start from the state again.
    pub(super) fn take_back(&mut self) -> Result<()> {
        self.scheme.continue_from(&self.bodies, &self.state)
    }

    /// Takes a step and returns its result. [`History::last_step`] returns this result later.
    ///
    /// # Errors
    /// - [`Error::NotFinite`], [`Error::NegativeOrNotFinite`], [`Error::NotPositive`] or [`Error::ApproachBeyondMeanGap`] if a
    ///   number of the load is invalid.
    /// - [`Error::UnsupportedByModel`] if the model does not support the load, or if a spring is too long.
    /// - [`Error::GridTooShort`] if the grid ends less than a rolled step in front of or behind the contact.
    /// - [`Error::BeyondFrictionCapacity`] if the force exceeds the friction capacity.
    /// - [`Error::EmptyContact`] for a tangential force while no cell carries pressure.
    /// - [`Error::NotConverged`] if a solve does not converge.
    /// - [`Error::Ranks`] if ranks fail or pass different loads.
    ///
    /// After an error the history is bitwise unchanged.
    ///
    /// The result borrows the history. Copy its numbers before the next call that needs the history, or clone the result.
    /// [`History::last_step`] returns it again, together with the state.
    ///
    /// ```
    /// use stickslip::*;
    /// # let grid = Grid::square(16, 4.0)?;
    /// # let rubber = Material::new(1.0, 0.5)?;
    /// # let bodies = HalfSpace::new(grid, ElasticPair::new(rubber, Material::rigid())?)?;
    /// # let ball = surface::sphere(grid, 10.0)?;
    /// let mut history = History::builder(&bodies, &ball, Friction::coulomb(0.3)?).build()?;
    /// history.step(&LoadStep::hold().normal(NormalControl::Force(0.1)))?;
    ///
    /// let shift = history.step(&LoadStep::force([0.01, 0.0]))?.shift(); // a copy of two numbers
    /// let pressure = history.pressure().max(); // the history is free again
    /// let first = history.step(&LoadStep::force([0.02, 0.0]))?.clone(); // a copy with all fields
    /// let second = history.step(&LoadStep::force([0.0, 0.0]))?;
    /// assert!(second.shift()[0] < first.shift()[0] && shift[0] < first.shift()[0]);
    ///
    /// // Both references are shared, so step and state can be used together.
    /// let (step, state) = (history.last_step()?, history.state());
    /// assert!(step.shift() == state.shift() && state.normal().pressure().max() == pressure);
    /// # Ok::<(), Error>(())
    /// ```
    pub fn step(&mut self, load: &LoadStep) -> Result<&StepResult> {
        self.step_observed(load, |_| ControlFlow::Continue(()))
    }

    /// Takes a step as [`History::step`] does, with an observer that receives every iteration and may cancel. If the
    /// observer panics and the caller catches the panic, the history is unchanged.
    ///
    /// Once the observer has cancelled a step, the step returns [`Error::NotConverged`] with [`Status::Cancelled`],
    /// even if the tractions are within the tolerance. The history is then unchanged. On distributed bodies the
    /// observer of the first rank decides.
    ///
    /// # Errors
    /// Errors of [`History::step`].
    pub fn step_observed(
        &mut self,
        load: &LoadStep,
        mut observer: impl FnMut(&Iteration) -> ControlFlow<()> + Send,
    ) -> Result<&StepResult> {
        let input = self.state.input(load, &self.bodies);
        let checked = self.state.check_rolling(load, &self.bodies);
        let (axes, shift) = (self.state.axes, self.state.shift());
        let checked = checked.and_then(|()| input.target.check(axes, &self.bodies, shift));
        let checked = checked.and_then(|()| self.state.check_relative(load));
        self.bodies
            .collective_result_checked(checked, &[("load", load)])?;
        let outcome = parallel::enter_with(self.grid().cells(), || {
            let outcome = self.take(&input, &mut observer);
            self.scheme.release();
            self.candidate.give_back();
            outcome
        });
        self.bodies.joint(outcome)?;
        Ok(&self.step)
    }

    /// Takes a step whose load has been checked.
    fn take(&mut self, step: &StepInput<'_>, observer: Observer<'_>) -> Result<()> {
        let remembered = self.state.contact.as_ref().map(|memory| memory.window);
        let motion = self.attempt(step, observer)?;
        // On distributed bodies a copy of the state is kept, which is restored if a rank fails during the commit.
        let is_shared = self.bodies.is_shared();
        let keep = || Ok::<_, Error>((self.state.try_clone()?, self.step.try_clone()?));
        let kept = is_shared.then(keep).transpose()?;
        let had_last_step = std::mem::replace(&mut self.has_last_step, true);
        self.commit(step, motion);
        let entered = self.bodies.joint(Ok(()));
        if let (Err(_), Some(kept)) = (&entered, kept) {
            (self.state, self.step) = kept;
            self.has_last_step = had_last_step;
            self.state.crop_memory(remembered);
        }
        entered
    }

    /// Changes the gap before loading, for instance after wear. All other quantities are kept. The pressure changes in the
    /// first step that does not hold it. Prescribe the normal load again in the next step. A step that holds the pressure has
    /// the warning [`StalePressure`](crate::Warning::StalePressure). A step that solves for the pressure has the warning
    /// [`LargeGapChange`](crate::Warning::LargeGapChange) if the change is larger than the displacements before and after it.
    /// The [plastic depth](State::yielded) is added to the gap. With a permanent set, [`History::unloaded_gap`] contains this
    /// depth already: change [`History::gap_as_set`] instead.
    ///
    /// Before a step that [rolls](crate::history#rolling), pass the gap at the end of that step. In this gap the texture has
    /// moved with the particles. The gap is copied without allocation.
    ///
    /// # Errors
    /// - [`Error::GridMismatch`] if the grid differs.
    /// - [`Error::Sample`] if the gap is not finite.
    /// - [`Error::UnsupportedByModel`] if the history has a permanent set of ten cells or more, and the gap already contains it, as
    ///   [`unloaded_gap`](Self::unloaded_gap) does. Other changes of up to a twentieth of the set do not matter.
    /// - [`Error::GapUnderLoad`] if the gap is the [gap under load](crate::NormalSolution::gap) of the present contact.
    /// - [`Error::Ranks`] if ranks fail.
    ///
    /// The gap is unchanged after an error.
    pub fn set_gap(&mut self, gap: &Field) -> Result<()> {
        let is_pressed = self.state.normal.report().status != Status::Unsolved;
        let checked = gap.check("gap", self.grid()).and_then(|()| {
            let loaded = LoadedCell::of(&self.state.normal, &self.state.pressed_gap);
            let loaded = loaded.filter(|_| is_pressed);
            loaded.map_or(Ok(()), |cell| cell.check_differs(gap))
        });
        self.bodies.collective_result(checked)?;
        check_without_set(&self.state, &self.bodies.grid_layout(), gap)?;
        let state = &mut self.state;
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

    /// Changes the friction of the following steps. The new friction replaces the earlier coefficient and the earlier cap. All other
    /// quantities are kept. The tractions follow in the next step. Until then, [`stiffness`](Self::stiffness) and
    /// [`edges`](Self::edges) return an error.
    ///
    /// # Errors
    /// - [`Error::GridMismatch`] if the grid differs.
    /// - [`Error::Ranks`] if ranks fail or pass different friction.
    ///
    /// The friction is unchanged after an error.
    pub fn set_friction(&mut self, friction: &Friction) -> Result<()> {
        friction.check_on(&self.bodies)?;
        let capacity = self.state.capacity_on_ranks(&self.bodies, friction);
        let differs = self.state.friction_differs(&self.bodies, friction);
        self.bodies.joint(Ok(()))?;
        self.state.friction.try_clone_from(friction)?;
        self.state.is_friction_new |= differs;
        self.state.capacity = capacity;
        Ok(())
    }

    /// Changes tolerance, method and limits of the following steps, for instance after a restart. The state is kept. A tighter
    /// tolerance bounds the errors of later steps only.
    ///
    /// # Errors
    /// - Errors of [`Settings::check`].
    /// - [`Error::Method`] if the tangential model does not support the method.
    /// - [`Error::Ranks`] if ranks fail or pass different settings.
    ///
    /// The settings are unchanged after an error.
    pub fn set_settings(&mut self, settings: Settings) -> Result<()> {
        let model = TangentialModel::of(self.state.axes);
        let checked = settings.check().and_then(|()| model.check(&settings));
        self.bodies
            .collective_result_checked(checked, &[("settings", &settings.common())])?;
        self.state.settings = settings;
        Ok(())
    }
}

/// The clone takes the same steps with bitwise identical results. Its first step allocates its buffers.
impl TryClone for History {
    fn try_clone(&self) -> Result<Self> {
        let (bodies, state) = (&self.bodies, self.state.try_clone()?);
        let mut scheme = Scheme::default();
        scheme.continue_from(bodies, &state)?;
        Ok(Self {
            bodies: bodies.clone(),
            candidate: self.candidate.clone(),
            scheme,
            step: self.step.try_clone()?,
            has_last_step: self.has_last_step,
            written: self.written,
            state,
        })
    }

    fn has_room_for(&self, _: &Self) -> bool {
        false
    }
}
