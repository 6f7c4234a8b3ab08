//! The engine set up on a rectangle of cells: one scene of one size, solved again and again.

use std::ops::ControlFlow;
use std::sync::Arc;

use crate::cgm::{self, Constraint, Iteration, Problem, Settings, Workspace, plane};
use crate::clock::Instant;
use crate::error::{Error, Result};
use crate::fft::{CirculantInverse, Convolution, ConvolutionWorkspace};
use crate::half_space::{Compliance, HalfSpace};
use crate::influence::Direction;
use crate::operator::Operator;
use crate::report::{Report, Status};
use crate::window::halved;

/// Who watches a solve and may cancel it.
pub(crate) type Observer<'a> = &'a mut (dyn FnMut(&Iteration) -> ControlFlow<()> + Send);

/// Operator, buffers, linear term and unknowns on `size` cells.
#[derive(Debug, Clone)]
pub(crate) struct Stage<C: Operator<Workspace = ConvolutionWorkspace> = Arc<Convolution>> {
    pub(crate) operator: C,
    inverse: Arc<CirculantInverse>,
    workspace: Workspace<C, Arc<CirculantInverse>>,
    /// The start of the next solve, and the answer of the last.
    pub(crate) x: Vec<f64>,
    pub(crate) linear: Vec<f64>,
}

impl Stage {
    pub(crate) fn new(bodies: &HalfSpace, direction: Direction, size: [usize; 2]) -> Result<Self> {
        Self::with(bodies, direction, size, |operator| operator)
    }

    /// With a linear term and a start.
    pub(crate) fn with_start(
        bodies: &HalfSpace,
        direction: Direction,
        size: [usize; 2],
        linear: &[f64],
        start: Vec<f64>,
    ) -> Result<Self> {
        let mut stage = Self::new(bodies, direction, size)?;
        stage.linear.copy_from_slice(linear);
        stage.x = start;
        Ok(stage)
    }
}

impl<C: Operator<Workspace = ConvolutionWorkspace> + Clone> Stage<C> {
    /// With what `wrap` makes of the operator.
    pub(crate) fn with(
        bodies: &HalfSpace,
        direction: Direction,
        size: [usize; 2],
        wrap: impl FnOnce(Arc<Convolution>) -> C,
    ) -> Result<Self> {
        let Compliance { operator, inverse } = bodies.compliance([direction], size)?;
        let operator = wrap(operator);
        let workspace = Workspace::new(&operator, &inverse);
        let cells = size[0] * size[1];
        Ok(Self {
            operator,
            inverse,
            workspace,
            x: vec![0.0; cells],
            linear: vec![0.0; cells],
        })
    }

    /// Minimises from `x` into `x`; the rest is in the accessors, converged or not.
    pub(crate) fn minimise(
        &mut self,
        constraint: impl Constraint,
        total: Option<f64>,
        settings: &Settings,
        observer: Observer<'_>,
    ) -> Result<()> {
        let mut problem = Problem::new(self.operator.clone(), &self.linear, constraint)
            .preconditioner(Arc::clone(&self.inverse));
        if let Some(total) = total {
            problem = problem.total(total);
        }
        cgm::minimise_with(
            &problem,
            settings,
            &mut self.x,
            &mut self.workspace,
            observer,
        )
    }

    /// `C x` of the answer.
    pub(crate) fn product(&self) -> &[f64] {
        self.workspace.product()
    }

    pub(crate) fn multiplier(&self) -> f64 {
        self.workspace.multiplier()
    }

    pub(crate) fn report(&self) -> &Report {
        self.workspace.report()
    }
}

/// The same with two unknowns a cell: all along x, then all along y.
#[derive(Debug, Clone)]
pub(crate) struct PlaneStage<
    C: Operator<2, Workspace = ConvolutionWorkspace<2>> = Arc<Convolution<2>>,
> {
    pub(crate) operator: C,
    inverse: Arc<CirculantInverse<2>>,
    workspace: plane::Workspace<C, Arc<CirculantInverse<2>>>,
    /// The start of the next solve, and the answer of the last.
    pub(crate) q: Vec<f64>,
    pub(crate) linear: Vec<f64>,
}

impl PlaneStage {
    pub(crate) fn new(bodies: &HalfSpace, size: [usize; 2]) -> Result<Self> {
        Self::with(bodies, size, |operator| operator)
    }
}

impl<C: Operator<2, Workspace = ConvolutionWorkspace<2>> + Clone> PlaneStage<C> {
    /// With what `wrap` makes of the operator.
    pub(crate) fn with(
        bodies: &HalfSpace,
        size: [usize; 2],
        wrap: impl FnOnce(Arc<Convolution<2>>) -> C,
    ) -> Result<Self> {
        let Compliance { operator, inverse } =
            bodies.compliance([Direction::X, Direction::Y], size)?;
        let operator = wrap(operator);
        let workspace = plane::Workspace::new(&operator, &inverse);
        let len = 2 * size[0] * size[1];
        Ok(Self {
            operator,
            inverse,
            workspace,
            q: vec![0.0; len],
            linear: vec![0.0; len],
        })
    }

    /// Minimises from `q` into `q`; the rest is in the accessors, converged or not.
    pub(crate) fn minimise(
        &mut self,
        limits: &[f64],
        totals: [Option<f64>; 2],
        settings: &Settings,
        observer: Observer<'_>,
    ) -> Result<()> {
        let problem = plane::Problem {
            operator: self.operator.clone(),
            preconditioner: Arc::clone(&self.inverse),
            linear: &self.linear,
            limits,
            totals,
        };
        plane::minimise(
            &problem,
            settings,
            &mut self.q,
            &mut self.workspace,
            observer,
        )
    }

    /// `C q` of the answer.
    pub(crate) fn product(&self) -> &[f64] {
        self.workspace.product()
    }

    pub(crate) fn multiplier(&self) -> [f64; 2] {
        self.workspace.multiplier()
    }

    pub(crate) fn report(&self) -> &Report {
        self.workspace.report()
    }
}

/// Relative accuracy of a coarse answer: its own discretisation error is not smaller.
const COARSE_TOLERANCE: f64 = 1e-2;
/// Steps a coarse answer may take: one that is hard to find is not worth more.
const COARSE_STEPS: usize = 100;
/// Cells at or below which a grid is solved from a plain start.
const COARSEST: usize = 40 * 40;

/// A scene that can be posed on cells twice as large, whose answer is a start for its own.
pub(crate) trait Nested: Sized {
    /// The engine that solves it.
    type Stage;
    /// What may be prescribed of the sum of the unknowns.
    type Total: Copy;

    /// The scene on coarser cells.
    fn coarse_scene(&self, size: [usize; 2]) -> Self;

    /// The total that asks of the coarser scene what `total` asks of this one.
    fn coarse_total(&self, coarse: &Self, total: Self::Total) -> Self::Total;

    /// A start from nothing.
    fn plain_start(&self, total: Self::Total) -> Vec<f64>;

    /// A start from the coarser scene's answer.
    fn refined_start(&self, size: [usize; 2], coarse: &Self, answer: &[f64]) -> Vec<f64>;

    /// The engine, at a start.
    fn stage(&self, bodies: &HalfSpace, size: [usize; 2], start: Vec<f64>) -> Result<Self::Stage>;

    /// Solves; the answer is in [`Self::answer`], finished or not.
    fn minimise(
        &self,
        stage: &mut Self::Stage,
        total: Self::Total,
        settings: &Settings,
        observer: Observer<'_>,
    ) -> Result<()>;

    fn answer(stage: &Self::Stage) -> &[f64];
}

/// A start from the answer on cells twice as large, itself found so: far fewer steps are then left
/// to do on the finest cells (Bornemann & Deuflhard's cascade, Numer. Math. 75 (1996) 135,
/// <https://doi.org/10.1007/s002110050234>).
pub(crate) fn nested_start<N: Nested>(
    bodies: &HalfSpace,
    size: [usize; 2],
    scene: &N,
    total: N::Total,
    settings: &Settings,
    start: Instant,
    observer: Observer<'_>,
) -> Result<Vec<f64>> {
    descend(bodies, size, scene, total, settings, start, observer).map(|(found, _)| found)
}

/// The same, and whether it was ended on the way, by observer or clock: then nothing more is solved.
fn descend<N: Nested>(
    bodies: &HalfSpace,
    size: [usize; 2],
    scene: &N,
    total: N::Total,
    settings: &Settings,
    start: Instant,
    observer: Observer<'_>,
) -> Result<(Vec<f64>, bool)> {
    let is_small = size[0] * size[1] <= COARSEST || size[0].min(size[1]) < 8;
    if is_small || !bodies.can_be_coarser() {
        return Ok((scene.plain_start(total), false));
    }
    let coarse = scene.coarse_scene(size);
    let coarse_total = scene.coarse_total(&coarse, total);
    let (bodies, coarse_size) = (bodies.coarser()?, halved(size));
    let (coarse_start, is_over) = descend(
        bodies,
        coarse_size,
        &coarse,
        coarse_total,
        settings,
        start,
        observer,
    )?;
    if is_over {
        return Ok((scene.refined_start(size, &coarse, &coarse_start), true));
    }

    let mut stage = coarse.stage(bodies, coarse_size, coarse_start)?;
    let rough = with_time_left(settings, start)
        .tolerance(settings.tolerance.max(COARSE_TOLERANCE))
        .max_iterations(settings.max_iterations.min(COARSE_STEPS));
    let is_over = match coarse.minimise(&mut stage, coarse_total, &rough, observer) {
        Ok(()) => false,
        // As a start an unfinished answer serves too.
        Err(Error::NotConverged(report)) => {
            matches!(report.status, Status::Cancelled | Status::TimeLimit)
        }
        Err(error) => return Err(error),
    };
    let found = scene.refined_start(size, &coarse, N::answer(&stage));
    Ok((found, is_over))
}

/// An observer that goes on refusing once it has refused.
pub(crate) fn with_memory(
    observer: Observer<'_>,
) -> impl FnMut(&Iteration) -> ControlFlow<()> + Send {
    let mut cancelled = false;
    move |iteration| {
        if cancelled || observer(iteration).is_break() {
            cancelled = true;
            return ControlFlow::Break(());
        }
        ControlFlow::Continue(())
    }
}

/// An observer of a further pass, whose counts go on from those before it.
pub(crate) fn with_counts_of(
    earlier: &Report,
    observer: Observer<'_>,
) -> impl FnMut(&Iteration) -> ControlFlow<()> + Send {
    let before = earlier.counts();
    move |step| observer(&step.after(before))
}

/// `Ok` if a limit of iterations leaves some for a further pass, else the report of a solve that it ends.
pub(crate) fn may_go_on(settings: &Settings, report: &mut Report) -> Result<()> {
    if report.iterations < settings.max_iterations {
        return Ok(());
    }
    report.status = Status::IterationLimit;
    Err(Error::NotConverged(Box::new(report.clone())))
}

/// The settings with what earlier passes have left of their limits, of which [`may_go_on`] has seen that there is
/// some.
pub(crate) fn with_limits_left(settings: &Settings, start: Instant, earlier: &Report) -> Settings {
    let left = settings.max_iterations - earlier.iterations;
    with_time_left(settings, start).max_iterations(left)
}

/// The settings with what is left of their time limit.
pub(crate) fn with_time_left(settings: &Settings, start: Instant) -> Settings {
    Settings {
        time_limit: settings
            .time_limit
            .map(|limit| limit.saturating_sub(start.elapsed())),
        ..*settings
    }
}
