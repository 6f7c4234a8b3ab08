//! The driver of a fretting loop.

use std::ops::ControlFlow;

use crate::error::{Error, Result};
use crate::history::{Cycle, History, LoadPath, LoadStep};

/// A path of load, taken again and again.
///
/// `load` turns each value of the path into a [`LoadStep`]: [`LoadStep::force`] and [`LoadStep::shift`] do, a
/// closure makes a [`LoadStep::spring`], or adds normal load or twist. A history along an axis takes a path along
/// that axis. In a loop that changes the gap, give the normal load in every step, `.normal(NormalControl::Force(w))`:
/// else the pressure stays that of the old gap, and the [step](crate::history::StepResult::warnings) says so.
///
/// ```
/// use stickslip::history::{FrettingLoop, LoadPath, StopReason, Regime};
/// use stickslip::*;
/// let grid = Grid::square(48, 0.30e-3)?;
/// let steel = Material::new(213e9, 0.29)?;
/// let bodies = HalfSpace::new(grid, ElasticPair::new(steel, steel)?)?;
/// let ball = surface::sphere(grid, 3.5e-3)?;
/// let mut history = History::builder(&bodies, &ball, Friction::coulomb(0.5)?).build()?;
///
/// // To and fro by 2 um under 100 N, for as many as ten cycles.
/// let path = LoadPath::sine([2e-6, 0.0], 20)?;
/// let load = |shift| LoadStep::shift(shift).normal(NormalControl::Force(100.0));
/// let outcome = FrettingLoop::new(path, load)
///     .until_steady(1e-4)
///     .run(&mut history, 10)?;
///
/// // The first cycle holds the first loading, the second is a loop that closes.
/// assert_eq!((outcome.ending, outcome.cycles), (StopReason::Steady, 2));
/// assert_eq!(outcome.last.regime(), Regime::PartialSlip);
/// assert!(outcome.last.energy_ratio() < 0.2);
/// # Ok::<(), Error>(())
/// ```
#[derive(Debug, Clone)]
#[must_use = "a loop does nothing until it is run"]
pub struct FrettingLoop<F> {
    path: LoadPath,
    load: F,
    tolerance: Option<f64>,
}

impl<F: Fn([f64; 2]) -> LoadStep> FrettingLoop<F> {
    /// A loop along this path, by the step that `load` makes of each value `[x, y]` of it.
    pub fn new(path: LoadPath, load: F) -> Self {
        Self {
            path,
            load,
            tolerance: None,
        }
    }

    /// Stops after the first cycle whose [closure](Cycle::cyclic_residual) is no more than `tolerance`, in `(0, 1)`
    /// (default: never). That is the largest of all cells: energies stand still cycles earlier.
    pub fn until_steady(mut self, tolerance: f64) -> Self {
        self.tolerance = Some(tolerance);
        self
    }

    /// Takes one cycle and adds it up in `cycle`, which begins anew. After a step that fails, history
    /// and `cycle` are as they were after the last good one.
    ///
    /// # Errors
    /// As [`History::step`]; [`Error::GridMismatch`] for the cycle.
    pub fn cycle(&self, history: &mut History, cycle: &mut Cycle) -> Result<()> {
        let mut unobserved = |_: &mut History, _: &Cycle| Ok(ControlFlow::Continue(()));
        self.pass(history, cycle, &mut unobserved).map(|_| ())
    }

    /// Takes `cycles` cycles, or fewer if one is steady before.
    ///
    /// # Errors
    /// [`Error::Tolerance`] before any step; as [`History::step`], with the history as it was after the last
    /// good one.
    pub fn run(&self, history: &mut History, cycles: usize) -> Result<FrettingResult> {
        self.run_observed(history, cycles, |_, _| Ok(ControlFlow::Continue(())))
    }

    /// [`FrettingLoop::run`] with an observer that is called after every step, with the history and the cycle so
    /// far. It may wear the gap, change friction, write, or break off. Steps that it takes itself enter no
    /// cycle.
    ///
    /// # Errors
    /// As [`FrettingLoop::run`], and what the observer returns.
    pub fn run_observed(
        &self,
        history: &mut History,
        cycles: usize,
        mut observer: impl FnMut(&mut History, &Cycle) -> Result<ControlFlow<()>>,
    ) -> Result<FrettingResult> {
        if let Some(tolerance) = self.tolerance {
            // Not a number is refused too.
            if !(tolerance > 0.0 && tolerance < 1.0) {
                return Err(Error::Tolerance(tolerance));
            }
        }
        let mut last = Cycle::new(history);
        let mut done = 0;
        let mut ending = StopReason::CycleLimit;
        while ending == StopReason::CycleLimit && done < cycles {
            if self.pass(history, &mut last, &mut observer)?.is_break() {
                ending = StopReason::Stopped;
            } else {
                done += 1;
                if self
                    .tolerance
                    .is_some_and(|most| last.cyclic_residual() <= most)
                {
                    ending = StopReason::Steady;
                }
            }
        }
        Ok(FrettingResult {
            cycles: done,
            ending,
            last,
        })
    }

    /// One cycle, as far as the observer lets it go.
    fn pass(
        &self,
        history: &mut History,
        cycle: &mut Cycle,
        observer: &mut dyn FnMut(&mut History, &Cycle) -> Result<ControlFlow<()>>,
    ) -> Result<ControlFlow<()>> {
        cycle.begin(history)?;
        cycle.reserve(self.path.steps().len());
        for &value in self.path.steps() {
            history.step(&(self.load)(value))?;
            cycle.add(history)?;
            let bodies = history.bodies.clone();
            if bodies.decided(|| observer(history, cycle))?.is_break() {
                return Ok(ControlFlow::Break(()));
            }
        }
        Ok(ControlFlow::Continue(()))
    }
}

/// Why a fretting loop ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub enum StopReason {
    /// The last cycle closed, to the tolerance asked for.
    Steady,
    /// All cycles were taken, and none was steady, or none had to be.
    CycleLimit,
    /// The observer broke off.
    Stopped,
}

/// What a fretting loop came to.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub struct FrettingResult {
    /// Whole cycles taken.
    pub cycles: usize,
    /// Why there were no more.
    pub ending: StopReason,
    /// The last cycle, with the [warnings](Cycle::warnings) of its steps. It is incomplete if the observer broke off,
    /// and has no steps if none were asked for.
    pub last: Cycle,
}
