//! Driver of a fretting loop.

use std::ops::ControlFlow;

use crate::error::{Error, Result};
use crate::history::{Cycle, History, LoadPath, LoadStep};

/// Load path that is repeated for a number of cycles.
///
/// `load` turns each value of the path into a [`LoadStep`]. Pass [`LoadStep::force`] or [`LoadStep::shift`] as `load`. A
/// closure can also return a [`LoadStep::spring`], or add a normal load or a twist. A history along one axis accepts a path
/// along this axis.
///
/// If the loop changes the gap, prescribe the normal load in every step with `.normal(NormalLoad::Force(w))`. Otherwise
/// the step holds the pressure of the old gap and returns a [warning](crate::history::StepResult::warnings).
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
/// // Back and forth by 2 um under 100 N, for at most ten cycles.
/// let path = LoadPath::sine([2e-6, 0.0], 20)?;
/// let load = |shift| LoadStep::shift(shift).normal(NormalLoad::Force(100.0));
/// let outcome = FrettingLoop::new(path, load)
///     .until_steady(1e-4)
///     .run(&mut history, 10)?;
///
/// // The first cycle includes the first loading; the second is a closed loop.
/// assert_eq!((outcome.ending, outcome.cycles), (StopReason::Steady, 2));
/// assert_eq!(outcome.last.regime()?, Regime::PartialSlip);
/// assert!(outcome.last.energy_ratio()? < 0.2);
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
    /// Creates a loop along this path. The step for each value `[x, y]` of the path is the result of `load`.
    pub fn new(path: LoadPath, load: F) -> Self {
        Self {
            path,
            load,
            tolerance: None,
        }
    }

    /// Stops after the first cycle whose [residual](Cycle::cyclic_residual) is at most `tolerance`, in `(0, 1)`
    /// (default: never). The residual includes the largest change of traction over all cells. Energies become steady several
    /// cycles before the tractions do.
    pub fn until_steady(mut self, tolerance: f64) -> Self {
        self.tolerance = Some(tolerance);
        self
    }

    /// Restarts `cycle`, takes the steps of one cycle and accumulates their results in `cycle`. If a step fails, the history
    /// and `cycle` remain in the state after the last successful step.
    ///
    /// # Errors
    /// - [`Error::GridMismatch`] if the grid of `cycle` differs.
    /// - [`Error::UnsupportedByModel`] if the load is equal for different values of the path.
    /// - Errors of [`History::step`].
    pub fn cycle(&self, history: &mut History, cycle: &mut Cycle) -> Result<()> {
        self.check_load()?;
        let mut unobserved = |_: &mut History, _: &Cycle| Ok(ControlFlow::Continue(()));
        self.pass(history, cycle, &mut unobserved).map(|_| ())
    }

    /// Takes `cycles` cycles, or fewer if a cycle is steady.
    ///
    /// # Errors
    /// - [`Error::Tolerance`] before any step if the tolerance is not in `(0, 1)`.
    /// - [`Error::UnsupportedByModel`] before any step if the load is equal for different values of the path.
    /// - Errors of [`History::step`]. The history then remains in its state after the last successful step.
    pub fn run(&self, history: &mut History, cycles: usize) -> Result<FrettingResult> {
        self.run_observed(history, cycles, |_, _| Ok(ControlFlow::Continue(())))
    }

    /// Takes cycles as [`FrettingLoop::run`] does and calls an observer after every step. The observer receives the history
    /// and the present cycle. The observer may apply wear to the gap, change the friction, write output, or stop the loop. It
    /// may take a step only after the last step of a cycle. This step does not count in any cycle.
    ///
    /// The [dissipation](Cycle::dissipation) of the present cycle is the sum over its steps so far. An observer that wears the gap
    /// after each step therefore requires the dissipation of the [last step](History::last_step).
    ///
    /// # Errors
    /// - [`Error::StepOutOfOrder`] if the observer has taken a step within a cycle.
    /// - Errors of [`FrettingLoop::run`].
    /// - Errors of the observer.
    pub fn run_observed(
        &self,
        history: &mut History,
        cycles: usize,
        mut observer: impl FnMut(&mut History, &Cycle) -> Result<ControlFlow<()>>,
    ) -> Result<FrettingResult> {
        if let Some(tolerance) = self.tolerance {
            // This form also rejects NaN.
            if !(tolerance > 0.0 && tolerance < 1.0) {
                return Err(Error::Tolerance(tolerance));
            }
        }
        self.check_load()?;
        let mut last = Cycle::new(history);
        let mut done = 0;
        let mut ending = StopReason::CycleLimit;
        while ending == StopReason::CycleLimit && done < cycles {
            if self.pass(history, &mut last, &mut observer)?.is_break() {
                ending = StopReason::Stopped;
            } else {
                done += 1;
                let residual = last.cyclic_residual()?;
                if self.tolerance.is_some_and(|most| residual <= most) {
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

    /// Rejects a load that does not depend on the value of the path.
    fn check_load(&self) -> Result<()> {
        let pairs = || self.path.steps().windows(2);
        let path_varies = pairs().any(|pair| pair[0].iter().ne(&pair[1]));
        let load_varies = || pairs().any(|pair| (self.load)(pair[0]) != (self.load)(pair[1]));
        if path_varies && !load_varies() {
            return Err(Error::UnsupportedByModel {
                model: "a fretting loop",
                quantity: "a load that is equal for all values of its path",
                value: 0.0,
                remedy: "compute the load from the value of the path, for example as the shift",
            });
        }
        Ok(())
    }

    /// Takes the steps of one cycle until the observer stops the loop.
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

/// Reason why a fretting loop ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub enum StopReason {
    /// The last cycle closed to the requested tolerance.
    Steady,
    /// All cycles were taken, because no cycle was steady or no tolerance was set.
    CycleLimit,
    /// The observer stopped the loop.
    Stopped,
}

/// Result of a fretting loop.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub struct FrettingResult {
    /// Number of whole cycles taken.
    pub cycles: usize,
    /// Reason for the end of the loop.
    pub ending: StopReason,
    /// Last cycle, with the [warnings](Cycle::warnings) of its steps. The cycle is incomplete if the observer stopped the
    /// loop. It is empty if no cycles were requested.
    pub last: Cycle,
}
