//! Checked input of a contact with a required accuracy.

use std::ops::ControlFlow;
use std::time::Duration;

use super::gap::GapFunction;
use super::measures::Quantity;
use super::region::Region;
use super::solution::{AdaptiveSolution, GridRecord};
use crate::bodies::coupling::Coupling;
use crate::bodies::kernel::Kernel;
use crate::error::{Error, Result};
use crate::grid::per_cell::PerCell;
#[cfg(feature = "history")]
use crate::history::LoadStep;
use crate::normal::NormalLoad;
use crate::tangential::{Friction, TangentialLoad, TangentialModel};

/// Name of the model in messages.
const MODEL: &str = "a contact whose grid is chosen by its accuracy";
/// Default target of the pressure.
const DEFAULT_TARGET: f64 = 1e-2;
/// Default limit of the number of cells of a grid.
const DEFAULT_CELLS: usize = 1 << 20;
/// Smallest permitted limit of the number of cells of a grid.
const LEAST_CELLS: usize = 1024;

/// Contact of bodies with a given gap and load, and the required accuracy.
///
/// The solve chooses the grid. See the [module](crate::adaptive) for the method and for the accuracy of the estimates.
#[derive(Clone)]
pub struct AdaptiveProblem<'a> {
    pub(super) bodies: Kernel,
    pub(super) gap: &'a (dyn GapFunction + Sync),
    pub(super) load: NormalLoad,
    pub(super) region: Region,
    pub(super) friction: Option<Shear>,
    pub(super) model: TangentialModel,
    pub(super) coupling: Option<Coupling>,
    pub(super) targets: Vec<(Quantity, f64)>,
    pub(super) cell_limit: usize,
    pub(super) time_limit: Option<Duration>,
}

/// Friction of a contact and the load that shears it.
#[derive(Debug, Clone)]
pub(super) struct Shear {
    pub(super) friction: Friction,
    pub(super) load: ShearLoad,
}

#[derive(Debug, Clone)]
pub(super) enum ShearLoad {
    /// Tangential load on the contact under its final pressure.
    AfterPressing(TangentialLoad),
    /// First step of a history.
    #[cfg(feature = "history")]
    Step(Box<LoadStep>),
}

impl ShearLoad {
    /// Returns an error for a load that depends on the grid.
    fn check(&self) -> Result<()> {
        let twist = match self {
            Self::AfterPressing(load) => load.demand().twist,
            #[cfg(feature = "history")]
            Self::Step(step) => {
                if let Some(rolling) = step.rolling() {
                    return Err(Error::UnsupportedByModel {
                        model: MODEL,
                        quantity: "rolling steps (value: the number of cells of the step)",
                        value: rolling.cells as f64,
                        remedy: "take the first step without rolling, and roll the history of its solution",
                    });
                }
                step.demand(0.0).twist
            }
        };
        if twist == 0.0 {
            return Ok(());
        }
        Err(Error::UnsupportedByModel {
            model: MODEL,
            quantity: "twist about the centre of the grid",
            value: twist,
            remedy: "choose a grid whose centre is on the axis of the rotation",
        })
    }
}

/// Options of an [`AdaptiveProblem`], all with defaults.
#[derive(Clone)]
#[must_use = "a builder does nothing until build() is called"]
pub struct AdaptiveProblemBuilder<'a> {
    problem: AdaptiveProblem<'a>,
}

impl<'a> AdaptiveProblem<'a> {
    /// Starts a builder from the required input: bodies (an [`ElasticPair`](crate::ElasticPair) or a [`Kernel`]), gap, normal
    /// load, and the region where contact may occur.
    pub fn builder(
        bodies: impl Into<Kernel>,
        gap: &'a (dyn GapFunction + Sync),
        load: NormalLoad,
        region: Region,
    ) -> AdaptiveProblemBuilder<'a> {
        AdaptiveProblemBuilder {
            problem: Self {
                bodies: bodies.into(),
                gap,
                load,
                region,
                friction: None,
                model: TangentialModel::default(),
                coupling: None,
                targets: Vec::new(),
                cell_limit: DEFAULT_CELLS,
                time_limit: None,
            },
        }
    }

    /// Returns whether the normal load prescribes a quantity.
    fn prescribes(&self, quantity: Quantity) -> bool {
        matches!(
            (self.load, quantity),
            (NormalLoad::Force(_), Quantity::Force) | (NormalLoad::Approach(_), Quantity::Approach)
        )
    }

    /// Solves the contact on successively finer grids until all estimates are at most their targets or a limit is reached.
    ///
    /// A limit is not an error. The solution then belongs to the finest grid. Its [status](AdaptiveSolution::status) states
    /// the limit, and its [warnings](AdaptiveSolution::warnings) contain
    /// [`Warning::AccuracyNotReached`](crate::Warning::AccuracyNotReached).
    ///
    /// # Errors
    /// - [`Error::EmptyContact`] if the bodies do not touch.
    /// - [`Error::Sample`] if the gap is not finite.
    /// - Errors of the gap function.
    /// - Errors of [`NormalProblem`](crate::NormalProblem), [`TangentialProblem`](crate::TangentialProblem) and
    ///   [`History::step`](crate::History::step), such as [`Error::BeyondFrictionCapacity`].
    pub fn solve(&self) -> Result<AdaptiveSolution> {
        self.solve_observed(|_| ControlFlow::Continue(()))
    }

    /// Solves like [`Self::solve`] with an observer that is called after the solve on each grid. If the observer cancels, the
    /// solution on this grid is returned.
    ///
    /// # Errors
    /// The errors of [`Self::solve`].
    pub fn solve_observed(
        &self,
        mut observer: impl FnMut(&GridRecord) -> ControlFlow<()>,
    ) -> Result<AdaptiveSolution> {
        super::refine::solve(self, &mut observer)
    }
}

impl std::fmt::Debug for AdaptiveProblem<'_> {
    fn fmt(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        formatter
            .debug_struct("AdaptiveProblem")
            .field("bodies", &self.bodies)
            .field("load", &self.load)
            .field("region", &self.region)
            .field("friction", &self.friction)
            .field("targets", &self.targets)
            .finish_non_exhaustive()
    }
}

impl std::fmt::Debug for AdaptiveProblemBuilder<'_> {
    fn fmt(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        self.problem.fmt(formatter)
    }
}

impl AdaptiveProblemBuilder<'_> {
    /// Sets the largest estimated error of a quantity (default: 1e-2 for the pressure, or for pressure and traction with
    /// friction). Each call adds a quantity. [`Quantity`] defines the errors.
    pub fn target(mut self, quantity: Quantity, target: f64) -> Self {
        let targets = &mut self.problem.targets;
        targets.retain(|(other, _)| *other != quantity);
        targets.push((quantity, target));
        self
    }

    /// Adds friction and a tangential load, which acts on the contact under its final pressure as in a
    /// [`TangentialProblem`](crate::TangentialProblem). The load replaces an earlier load or first step.
    pub fn shear(mut self, friction: Friction, load: TangentialLoad) -> Self {
        let load = ShearLoad::AfterPressing(load);
        self.problem.friction = Some(Shear { friction, load });
        self
    }

    /// Adds friction and a first step of a [`History`](crate::History). The normal load of the problem replaces the normal
    /// load of the step. [`AdaptiveSolution::into_history`] returns the history for further steps on the same grid. The step
    /// replaces an earlier step or tangential load.
    #[cfg(feature = "history")]
    #[cfg_attr(docsrs, doc(cfg(feature = "history")))]
    pub fn first_step(mut self, friction: Friction, step: LoadStep) -> Self {
        let load = ShearLoad::Step(Box::new(step));
        self.problem.friction = Some(Shear { friction, load });
        self
    }

    /// Sets the model of the tractions (default [`TangentialModel::Scalar`]).
    pub fn model(mut self, model: TangentialModel) -> Self {
        self.problem.model = model;
        self
    }

    /// Sets the coupling of pressure and traction for dissimilar bodies (default: the default of a
    /// [`TangentialProblem`](crate::TangentialProblem) or of a [`History`](crate::History)).
    pub fn coupling(mut self, coupling: Coupling) -> Self {
        self.problem.coupling = Some(coupling);
        self
    }

    /// Sets the largest number of cells of a grid (default: 2^20, a grid of 1024 x 1024 cells).
    pub fn cell_limit(mut self, cells: usize) -> Self {
        self.problem.cell_limit = cells;
        self
    }

    /// Sets the wall time after which no further grid is solved (default: no limit).
    pub fn time_limit(mut self, time: Duration) -> Self {
        self.problem.time_limit = Some(time);
        self
    }
}

impl<'a> AdaptiveProblemBuilder<'a> {
    /// Checks the input and creates the problem.
    ///
    /// # Errors
    /// - [`Error::Tolerance`] if a target is not between 0 and 1.
    /// - [`Error::UnsupportedByModel`] if a target of the traction, stick ratio or shift is set without friction, or if the
    ///   friction varies over cells.
    /// - [`Error::UnsupportedByModel`] if a target belongs to the prescribed force or approach, which has no error.
    /// - [`Error::UnsupportedByModel`] for a twist, which acts about the centre of the grid, and for a rolling step, whose length is a
    ///   number of cells.
    /// - [`Error::BelowMinimum`] if the limit of the number of cells is less than 1024.
    pub fn build(mut self) -> Result<AdaptiveProblem<'a>> {
        let problem = &mut self.problem;
        let has_friction = problem.friction.is_some();
        if problem.targets.is_empty() {
            problem.targets.push((Quantity::Pressure, DEFAULT_TARGET));
            if has_friction {
                problem.targets.push((Quantity::Traction, DEFAULT_TARGET));
            }
        }
        for &(quantity, target) in &problem.targets {
            // This form of the comparison rejects NaN.
            if !(target > 0.0 && target < 1.0) {
                return Err(Error::Tolerance(target));
            }
            if quantity.is_tangential() && !has_friction {
                return Err(Error::UnsupportedByModel {
                    model: "a contact without friction",
                    quantity: quantity.name(),
                    value: target,
                    remedy: "add friction and a tangential load",
                });
            }
            if problem.prescribes(quantity) {
                return Err(Error::UnsupportedByModel {
                    model: "the load of this contact, which prescribes the quantity,",
                    quantity: quantity.name(),
                    value: target,
                    remedy: "set a target for the pressure or another quantity",
                });
            }
        }
        if let Some(Shear { friction, load }) = &problem.friction {
            load.check()?;
            if !matches!(friction.common().0, PerCell::Uniform(_)) {
                return Err(Error::UnsupportedByModel {
                    model: MODEL,
                    quantity: "friction that varies over cells",
                    value: 1.0,
                    remedy: "use a friction coefficient",
                });
            }
        }
        if problem.cell_limit < LEAST_CELLS {
            return Err(Error::BelowMinimum {
                quantity: "limit of the cells",
                value: problem.cell_limit as f64,
                least: LEAST_CELLS as f64,
                least_is: "the cells of a first grid",
            });
        }
        Ok(self.problem)
    }
}
