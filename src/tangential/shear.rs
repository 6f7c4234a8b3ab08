//! The engine of a tangential contact: one traction along an axis, or both in the plane.

use crate::cgm::{Magnitude, Method};
use crate::clock::Instant;
use crate::error::Result;
use crate::influence::Direction;
use crate::report::Report;
use crate::stage::{Nested, Observer, PlaneStage, Stage, nested_start, with_time_left};
use crate::tangential::nested::{FrictionScene, PlaneScene};
use crate::tangential::problem::Limits;
use crate::tangential::{Axis, Lateral, TangentialProblem};

/// Set up on the window of the contact, with the last tractions there, the start of the next solve.
#[derive(Debug, Clone)]
#[expect(
    clippy::large_enum_variant,
    reason = "there is one per solver, beside megabytes of fields"
)]
pub(super) enum Shear {
    /// The scalar model.
    Along(Axis, Stage),
    /// The plane model.
    InPlane(PlaneStage),
}

/// What is asked of a solve, as `[x, y]`.
#[derive(Debug, Clone, Copy)]
pub(super) struct Demand {
    /// Sums of the tractions, where a force is prescribed.
    pub(super) totals: [Option<f64>; 2],
    /// Motion of the whole, where that is; zero where a force is.
    pub(super) shift: [f64; 2],
}

impl Shear {
    pub(super) fn new(problem: &TangentialProblem) -> Result<Self> {
        let axis = match problem.lateral {
            Lateral::Neglected => Some(problem.load.along()?.0),
            Lateral::Coupled => None,
        };
        Self::of_axis(problem, axis)
    }

    /// For the axis of the scalar model, or for the plane: no load at all has no axis of its own.
    pub(super) fn of_axis(problem: &TangentialProblem, axis: Option<Axis>) -> Result<Self> {
        let TangentialProblem { bodies, window, .. } = problem;
        Ok(match axis {
            Some(axis) => Self::Along(axis, Stage::new(bodies, direction(axis), window.size)?),
            None => Self::InPlane(PlaneStage::new(bodies, window.size)?),
        })
    }

    /// The axis of the scalar model.
    pub(super) fn axis(&self) -> Option<Axis> {
        match self {
            Self::Along(axis, _) => Some(*axis),
            Self::InPlane(_) => None,
        }
    }

    /// Tractions along x and y, where they are part of the model.
    pub(super) fn tractions(&self) -> [Option<&[f64]>; 2] {
        self.components(|stage| &stage.x, |stage| &stage.q)
    }

    /// Displacements along x and y, where they are part of the model.
    pub(super) fn displacements(&self) -> [Option<&[f64]>; 2] {
        self.components(Stage::product, PlaneStage::product)
    }

    fn components<'a>(
        &'a self,
        along: impl Fn(&'a Stage) -> &'a [f64],
        in_plane: impl Fn(&'a PlaneStage) -> &'a [f64],
    ) -> [Option<&'a [f64]>; 2] {
        match self {
            Self::Along(Axis::X, stage) => [Some(along(stage)), None],
            Self::Along(Axis::Y, stage) => [None, Some(along(stage))],
            Self::InPlane(stage) => {
                let both = in_plane(stage);
                let (x, y) = both.split_at(both.len() / 2);
                [Some(x), Some(y)]
            }
        }
    }

    /// Tractions to start from.
    pub(super) fn tractions_mut(&mut self) -> [Option<&mut [f64]>; 2] {
        match self {
            Self::Along(Axis::X, stage) => [Some(&mut stage.x), None],
            Self::Along(Axis::Y, stage) => [None, Some(&mut stage.x)],
            Self::InPlane(stage) => {
                let (x, y) = stage.q.split_at_mut(stage.linear.len() / 2);
                [Some(x), Some(y)]
            }
        }
    }

    /// The motion of the whole that the prescribed forces cause.
    pub(super) fn multiplier(&self) -> [f64; 2] {
        match self {
            Self::Along(Axis::X, stage) => [stage.multiplier(), 0.0],
            Self::Along(Axis::Y, stage) => [0.0, stage.multiplier()],
            Self::InPlane(stage) => stage.multiplier(),
        }
    }

    pub(super) fn report(&self) -> &Report {
        match self {
            Self::Along(_, stage) => stage.report(),
            Self::InPlane(stage) => stage.report(),
        }
    }

    /// Prescribes the motion of the whole.
    pub(super) fn set_shift(&mut self, shift: [f64; 2]) {
        match self {
            Self::Along(axis, stage) => stage.linear.fill(-shift[axis.index()]),
            Self::InPlane(stage) => {
                let cells = stage.linear.len() / 2;
                for (linear, shift) in stage.linear.chunks_exact_mut(cells).zip(shift) {
                    linear.fill(-shift);
                }
            }
        }
    }

    /// Solves from the present tractions.
    pub(super) fn minimise(
        &mut self,
        problem: &TangentialProblem,
        demand: Demand,
        start: Instant,
        observer: Observer<'_>,
    ) -> Result<()> {
        let settings = with_time_left(&problem.settings, start);
        let limits = &problem.limits.cells;
        match self {
            Self::Along(axis, stage) => {
                let total = demand.totals[axis.index()];
                stage.minimise(Magnitude(limits), total, &settings, observer)
            }
            Self::InPlane(stage) => stage.minimise(limits, demand.totals, &settings, observer),
        }
    }

    /// A start from nothing: the answer on coarser cells, unless it is known or another method is asked for.
    pub(super) fn start_cold(
        &mut self,
        problem: &TangentialProblem,
        demand: Demand,
        start: Instant,
        observer: Observer<'_>,
    ) -> Result<()> {
        let TangentialProblem {
            bodies,
            window,
            limits,
            settings,
            ..
        } = problem;
        let Demand { totals, shift } = demand;
        let demanded = totals.into_iter().flatten().chain(shift);
        let is_idle = demanded.into_iter().all(|value| value == 0.0);
        if is_idle || limits.sum <= 0.0 {
            for traction in self.tractions_mut().into_iter().flatten() {
                traction.fill(0.0);
            }
            return Ok(());
        }
        let size = window.size;
        let is_sliding = limits.is_sliding(totals);
        match self {
            Self::Along(axis, stage) => {
                let scene = FrictionScene {
                    direction: direction(*axis),
                    limits: limits.cells.clone(),
                    linear: stage.linear.clone(),
                };
                let total = totals[axis.index()];
                stage.x = if is_sliding || settings.method == Method::PolonskyKeer {
                    scene.plain_start(total)
                } else {
                    nested_start(bodies, size, &scene, total, settings, start, observer)?
                };
            }
            Self::InPlane(stage) => {
                let scene = PlaneScene {
                    limits: limits.cells.clone(),
                    linear: stage.linear.clone(),
                };
                stage.q = if is_sliding {
                    scene.plain_start(totals)
                } else {
                    nested_start(bodies, size, &scene, totals, settings, start, observer)?
                };
            }
        }
        Ok(())
    }
}

/// The direction of an axis.
pub(crate) fn direction(axis: Axis) -> Direction {
    match axis {
        Axis::X => Direction::X,
        Axis::Y => Direction::Y,
    }
}

impl Limits {
    /// Whether prescribed sums use up all that friction holds.
    fn is_sliding(&self, totals: [Option<f64>; 2]) -> bool {
        let [x, y] = totals.map(|total| total.unwrap_or(0.0));
        totals != [None, None] && x.hypot(y) >= self.sum
    }
}
