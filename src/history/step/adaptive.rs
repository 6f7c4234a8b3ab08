//! Error estimate of a step, and adaptive step sizes for a tolerance.

use crate::cgm::reduce;
use crate::error::{Error, Result};
use crate::grid::field::Field;
use crate::history::step::diagnostics::GapDiagnostics;
use crate::history::{History, LoadStep, State, StepResult};
use crate::memory::fallible::{TryClone, try_each};
use crate::support::debug::shown;

/// Shortest step as a fraction of the load.
const SHORTEST: f64 = 1.0 / 4096.0;

/// Difference between one step and two half steps of the same load.
///
/// For an error of second order in the length of the step, the error of the two half steps is a third of this
/// difference. For an error of first order, it is equal to the difference.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub struct StepErrorEstimate {
    /// Sum of the magnitudes of the traction differences, divided by the sum of the friction limits. Zero without
    /// contact.
    pub traction: f64,
    /// Difference of the tangential force `[x, y]`.
    pub force: [f64; 2],
    /// Difference of the shift `[x, y]` (lengths).
    pub shift: [f64; 2],
    /// Difference of the dissipated energy, computed from the tractions at the ends of the steps.
    pub dissipated_energy: f64,
}

/// Adaptive step control, which divides a load into steps that are short enough for a tolerance. It also estimates the
/// error of a step.
///
/// The state after a step belongs to a load that varied linearly during the step. The section on the [entry
/// rule](crate::history#entry-rule) gives the order of the error of a step. Each step is compared with two half steps of
/// the same load, and the result of the half steps is used. A step covers a fraction of the load. The half steps are
/// accepted if [`StepErrorEstimate::traction`] is at most the tolerance times the square root of this fraction.
/// Otherwise the step is shortened. This criterion uses an estimate and not a bound. For a ball whose shift turned while
/// the contact grew, the error after the load was up to 2.5 times the tolerance.
///
/// For dissimilar bodies that are pressed from zero load, use [`History::press`]. For any length of the first step, its
/// error is large compared with the friction limits in this step. This type would therefore return
/// [`Error::StepTooLong`]. The error of the whole load depends less on the first step, because the contact grows far
/// beyond its size in that step.
///
/// The tolerance applies to the tractions. If cells slip while the contact grows or shrinks, their dissipated energy converges
/// more slowly. Its error can be many times the tolerance
/// ([measured](crate::guide::accuracy#energies-of-adaptive-steps)). Take more steps for energies.
///
/// All prescribed quantities change proportionally from their previous values to their values in the load.
///
/// # Memory
/// The buffers need the memory of four states. If the contact outgrows its bounding box, each attempt of a step
/// allocates memory.
///
/// # Examples
///
/// ```
/// use stickslip::history::AdaptiveSteps;
/// use stickslip::*;
/// let grid = Grid::square(48, 0.30e-3)?;
/// let steel = Material::new(213e9, 0.29)?;
/// let bodies = HalfSpace::new(grid, ElasticPair::new(steel, steel)?)?;
/// let ball = surface::sphere(grid, 3.5e-3)?;
/// let builder = History::builder(&bodies, &ball, Friction::coulomb(0.5)?);
/// let mut history = builder.model(TangentialModel::Vector).build()?;
/// history.step(&LoadStep::hold().normal(NormalLoad::Force(50.0)))?;
///
/// // The force turns while the contact grows, so that the direction of slip changes during the load.
/// history.step(&LoadStep::force([20.0, 0.0]))?;
/// let load = LoadStep::force([0.0, 20.0]).normal(NormalLoad::Force(100.0));
/// let mut steps = AdaptiveSteps::new(&history, 0.003)?;
/// let whole = steps.error(&mut history, &load)?;
/// let taken = steps.step(&mut history, &load)?;
/// assert!(whole.traction > 0.003 && taken > 2);
/// assert!((history.tangential_force()[1] - 20.0).abs() < 1e-9);
/// # Ok::<(), Error>(())
/// ```
#[derive(Clone)]
pub struct AdaptiveSteps {
    tolerance: f64,
    /// State at the start of the load.
    beginning: State,
    /// State at the start of the present step.
    kept: State,
    /// State and result after the first half of the step.
    middle: (State, StepResult),
    /// Tractions after a single step over both halves.
    whole: [Field; 2],
}

shown!(AdaptiveSteps: tolerance);

impl AdaptiveSteps {
    /// Creates the step control for histories on the grid of `history`. `tolerance` is the limit of
    /// [`StepErrorEstimate::traction`] for a whole load, in `(0, 1)`.
    ///
    /// The tolerance must exceed about a hundred times the tolerance of the [settings](History::settings) of the
    /// history. Otherwise the error of the solves dominates for any length of the steps.
    ///
    /// # Errors
    /// - [`Error::Tolerance`] if the tolerance is not in `(0, 1)`.
    /// - [`Error::Memory`] if memory runs out.
    pub fn new(history: &History, tolerance: f64) -> Result<Self> {
        if !(tolerance > 0.0 && tolerance < 1.0) {
            return Err(Error::Tolerance(tolerance));
        }
        let state = history.state();
        Ok(Self {
            tolerance,
            beginning: state.try_clone()?,
            kept: state.try_clone()?,
            middle: (state.try_clone()?, history.step.try_clone()?),
            whole: try_each(|axis| state.traction()[axis].try_clone())?,
        })
    }

    /// Estimates the error of [`History::step`] for this load. The state of the history is unchanged afterwards. The
    /// history then has no [last step](History::last_step), as after [`History::set_state`].
    ///
    /// # Errors
    /// - [`Error::GridMismatch`] if the grid of the history differs.
    /// - Errors of [`History::step`].
    pub fn error(&mut self, history: &mut History, load: &LoadStep) -> Result<StepErrorEstimate> {
        self.begin(history, load)?;
        let outcome = self.compare(history, load, [0.0, 1.0]);
        history.go_back(&mut self.beginning)?;
        outcome
    }

    /// Takes a load in as many steps as needed and returns their number.
    ///
    /// The [last step](History::last_step) is the last of these steps, with the slip and energy of this step alone. For wear,
    /// use an observer ([`step_observed`](Self::step_observed)), or the increase of [`History::accumulated_dissipation`].
    ///
    /// # Errors
    /// - [`Error::GridMismatch`] if the grid of the history differs.
    /// - [`Error::StepTooLong`] if steps of 1/4096 of the load are not short enough.
    /// - [`Error::UnsupportedByModel`] if the load rolls.
    /// - Errors of [`History::step`].
    ///
    /// The state is unchanged after an error. If the call has undone steps, the history has no [last
    /// step](History::last_step), as after [`History::set_state`].
    pub fn step(&mut self, history: &mut History, load: &LoadStep) -> Result<usize> {
        self.step_observed(history, load, |_| Ok(()))
    }

    /// Takes a load as [`AdaptiveSteps::step`] does and calls an observer with the history after every accepted step.
    /// The observer can, for example, [add](crate::history::Cycle::add) the step to a cycle. If the call returns an
    /// error, all observed steps have been undone.
    ///
    /// # Errors
    /// - Errors of [`AdaptiveSteps::step`].
    /// - Errors of the observer.
    pub fn step_observed(
        &mut self,
        history: &mut History,
        load: &LoadStep,
        mut observer: impl FnMut(&History) -> Result<()>,
    ) -> Result<usize> {
        self.begin(history, load)?;
        let outcome = self.advance(history, load, &mut observer);
        if outcome.is_err() {
            history.go_back(&mut self.beginning)?;
        }
        outcome
    }

    fn begin(&mut self, history: &History, load: &LoadStep) -> Result<()> {
        let grid = self.whole[0].grid();
        let checked = grid.check_equal("history of adaptive steps", history.grid());
        let checked = checked.and_then(|()| load.check_still());
        history.bodies.collective_result_checked(
            checked,
            &[
                ("load", load),
                ("tolerance of adaptive steps", &self.tolerance),
            ],
        )?;
        self.beginning.try_clone_from(history.state())?;
        self.kept.try_clone_from(history.state())
    }

    fn advance(
        &mut self,
        history: &mut History,
        load: &LoadStep,
        observer: &mut impl FnMut(&History) -> Result<()>,
    ) -> Result<usize> {
        let (mut start, mut part, mut steps) = (0.0, 1.0_f64, 0);
        let mut change = GapDiagnostics::default();
        while start < 1.0 {
            // Fractions are powers of two, so that the last step ends exactly at the end of the load.
            let end = start + part;
            let error = self.compare(history, load, [start, end])?.traction;
            // The limit decreases more slowly than the fraction, because later slip erases much of the error of earlier
            // steps.
            let allowed = part.sqrt() * self.tolerance;
            if error <= allowed {
                // The error estimate replaces the criterion for the growth of the contact.
                for step in [&mut self.middle.1, &mut history.step] {
                    step.remarks.is_pressed_at_once = false;
                    change = change.max(step.remarks.gap_change);
                }
                self.show(history, observer)?;
                (start, steps) = (end, steps + 2);
                let may_double = error <= 0.25 * allowed && (start / part) % 2.0 == 0.0;
                if may_double && start + 2.0 * part <= 1.0 {
                    part *= 2.0;
                }
            } else if part > SHORTEST {
                history.set_state(&self.kept)?;
                part *= 0.5;
            } else {
                return Err(Error::StepTooLong {
                    part,
                    error,
                    tolerance: self.tolerance,
                });
            }
        }
        // The gap changed before the first step.
        history.step.remarks.gap_change = change;
        Ok(steps)
    }

    /// Takes the step between two fractions of the load as a single step, then again as two half steps. The history
    /// remains at the result of the half steps.
    fn compare(
        &mut self,
        history: &mut History,
        load: &LoadStep,
        [start, end]: [f64; 2],
    ) -> Result<StepErrorEstimate> {
        let part = |part| load.part(&self.beginning, part);
        let whole = history.step(&part(end))?;
        let (force, shift) = (whole.tangential_force(), whole.shift());
        let dissipated = whole.energy().dissipated_energy;
        for (kept, traction) in self.whole.iter_mut().zip(history.traction()) {
            kept.clone_from(traction);
        }
        history.set_state(&self.kept)?;
        history.step(&part(0.5 * (start + end)))?;
        let (state, step) = &mut self.middle;
        state.try_clone_from(history.state())?;
        step.try_clone_from(&history.step)?;
        let second = history.step(&part(end))?;
        let halves = step.energy().dissipated_energy + second.energy().dissipated_energy;
        let difference = |a: [f64; 2], b: [f64; 2]| [a[0] - b[0], a[1] - b[1]];
        Ok(StepErrorEstimate {
            force: difference(force, second.tangential_force()),
            shift: difference(shift, second.shift()),
            dissipated_energy: dissipated - halves,
            traction: traction_distance(history, self.whole.each_ref()),
        })
    }

    /// Calls the observer with the history after the first half of the step and after the second half. The history
    /// remains at the second half.
    fn show(
        &mut self,
        history: &mut History,
        observer: &mut impl FnMut(&History) -> Result<()>,
    ) -> Result<()> {
        let (state, step) = &mut self.middle;
        self.kept.try_clone_from(history.state())?;
        history.set_state(state)?;
        std::mem::swap(&mut history.step, step);
        history.has_last_step = true;
        let outcome = history.bodies.run_collectively(|| observer(history));
        std::mem::swap(&mut history.step, step);
        history.set_state(&self.kept)?;
        // The result of the second half belongs to the restored state.
        history.has_last_step = true;
        outcome?;
        history.bodies.run_collectively(|| observer(history))
    }
}

/// Returns the sum of the magnitudes of the traction differences from a history, divided by the sum of its friction
/// limits.
pub(in crate::history) fn traction_distance(history: &History, [x, y]: [&Field; 2]) -> f64 {
    let [u, v] = history.traction();
    let sum = reduce::sum(&history.bodies.grid_layout(), |i| {
        (x.as_slice()[i] - u.as_slice()[i]).hypot(y.as_slice()[i] - v.as_slice()[i])
    });
    let capacity = history.friction_capacity();
    if capacity > 0.0 {
        sum * history.grid().cell_area() / capacity
    } else {
        0.0
    }
}
