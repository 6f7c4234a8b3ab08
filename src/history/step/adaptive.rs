//! The error of a step, and steps short enough for a tolerance.

use crate::cgm::reduce;
use crate::error::{Error, Result};
use crate::grid::field::Field;
use crate::history::{History, LoadStep, State, StepResult};
use crate::memory::fallible::{TryClone, try_each};
use crate::support::debug::shown;

/// Shortest step, as a part of the load.
const SHORTEST: f64 = 1.0 / 4096.0;

/// What one step differs by from the same load in two.
///
/// If the error is of second order in the length of the step, the two halves have a third of this difference as their
/// error; if it is of first order, all of it.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub struct StepErrorEstimate {
    /// Sum of the lengths of the differences of the tractions, over the sum of the friction limits; zero without
    /// contact.
    pub traction: f64,
    /// Difference of the tangential force `[x, y]`.
    pub force: [f64; 2],
    /// Difference of the shift `[x, y]` (lengths).
    pub shift: [f64; 2],
    /// Difference of the energy dissipated, by the tractions at the ends of the steps.
    pub dissipated_energy: f64,
}

/// Takes a load in steps short enough for a tolerance, and tells the error of a step.
///
/// The state after a step is that of a load that went straight from beginning to end, up to an error whose order is
/// told by [growing contacts](crate::guide::load_steps). A step is compared with the same load in two halves,
/// and the halves count. They are taken if [`StepErrorEstimate::traction`] is at most the tolerance times the root of the
/// step's part of the load, else the step is shortened: an estimate, no bound. On a ball that turns its shift while
/// it grows, the error after the load was up to 2.5 times the tolerance.
///
/// Dissimilar bodies that are pressed from zero load need [`History::press`]. Their first step has an error that is large
/// for the friction limits it has then, however short it is, and ends here as [`Error::StepTooLong`]. The error of the whole
/// load does not depend on it as strongly, since the contact outgrows it.
///
/// The tolerance is that of tractions. Where cells slip while the contact grows, the energy they dissipate converges
/// more slowly: compare [`StepErrorEstimate::dissipated_energy`] with the energy of the step.
///
/// All that is prescribed goes from its value before to that of the load in proportion. The buffers take the memory of
/// four states. A step allocates where the contact outgrows its box, each time that the step is tried.
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
/// history.step(&LoadStep::hold().normal(NormalControl::Force(50.0)))?;
///
/// // The force turns while the contact grows: the direction of slip changes on the way.
/// history.step(&LoadStep::force([20.0, 0.0]))?;
/// let load = LoadStep::force([0.0, 20.0]).normal(NormalControl::Force(100.0));
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
    /// The state that the load began from.
    beginning: State,
    /// The state that the step under way began from.
    kept: State,
    /// State and result after the first half of the step.
    middle: (State, StepResult),
    /// Tractions after the step as a whole.
    whole: [Field; 2],
}

shown!(AdaptiveSteps: tolerance);

impl AdaptiveSteps {
    /// For histories on the grid of this one, with the tolerance of [`StepErrorEstimate::traction`] for a whole load, in `(0,
    /// 1)`.
    ///
    /// A tolerance below about a hundred times that of the history's [settings](History::settings) cannot be met: the
    /// error of the solves then dominates, however short the steps.
    ///
    /// # Errors
    /// [`Error::Tolerance`], [`Error::Memory`].
    pub fn new(history: &History, tolerance: f64) -> Result<Self> {
        if !(tolerance > 0.0 && tolerance < 1.0) {
            return Err(Error::Tolerance(tolerance));
        }
        let state = history.state();
        Ok(Self {
            tolerance,
            beginning: state.try_clone()?,
            kept: state.try_clone()?,
            middle: (state.try_clone()?, history.last_step().try_clone()?),
            whole: try_each(|axis| state.traction()[axis].try_clone())?,
        })
    }

    /// The error that [`History::step`] makes with this load. The history is then as it was; its
    /// [last step](History::last_step) is the second half of this one.
    ///
    /// # Errors
    /// As [`History::step`], and [`Error::GridMismatch`] for a history on another grid.
    pub fn error(&mut self, history: &mut History, load: &LoadStep) -> Result<StepErrorEstimate> {
        self.begin(history, load)?;
        let outcome = self.compare(history, load, [0.0, 1.0]);
        history.go_back(&mut self.beginning)?;
        outcome
    }

    /// Takes a load, in as many steps as it needs, and returns how many.
    ///
    /// # Errors
    /// As [`History::step`]; [`Error::GridMismatch`] for a history on another grid; [`Error::StepTooLong`] if steps of
    /// 1/4096 of the load are not short enough; [`Error::UnsupportedByModel`] for a load that rolls. The state is then as it
    /// was; the [last step](History::last_step) is that of the last attempt.
    pub fn step(&mut self, history: &mut History, load: &LoadStep) -> Result<usize> {
        self.step_observed(history, load, |_| Ok(()))
    }

    /// [`AdaptiveSteps::step`] with an observer that sees the history after every step taken, for example to
    /// [add](crate::history::Cycle::add) it to a cycle. What it gathered before an error belongs to no load.
    ///
    /// # Errors
    /// As [`AdaptiveSteps::step`], and those of the observer.
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
        let checked = self.whole[0].check("buffers of adaptive steps", history.grid());
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
        while start < 1.0 {
            // Parts are powers of two, and never pass the end.
            let end = start + part;
            let error = self.compare(history, load, [start, end])?.traction;
            // Less than in proportion to the part: later slip covers much of what early steps did wrong.
            let allowed = part.sqrt() * self.tolerance;
            if error <= allowed {
                // The error replaces the growth as the measure of the steps.
                for step in [&mut self.middle.1, &mut history.step] {
                    step.remarks.is_pressed_at_once = false;
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
        Ok(steps)
    }

    /// Takes the step from one part of the load to another as a whole, then again in two halves, and stays there.
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
        step.try_clone_from(history.last_step())?;
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

    /// Shows the observer the history after the first half of the step, then after the second, and stays there.
    fn show(
        &mut self,
        history: &mut History,
        observer: &mut impl FnMut(&History) -> Result<()>,
    ) -> Result<()> {
        let (state, step) = &mut self.middle;
        self.kept.try_clone_from(history.state())?;
        history.set_state(state)?;
        std::mem::swap(&mut history.step, step);
        let outcome = history.bodies.run_collectively(|| observer(history));
        std::mem::swap(&mut history.step, step);
        history.set_state(&self.kept)?;
        outcome?;
        history.bodies.run_collectively(|| observer(history))
    }
}

/// Returns the difference between other tractions and the tractions of a history, over the sum of its friction limits.
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
