//! Solver of a coupled contact on a window: Newton's method for pressure and tractions together. Alternating normal and
//! tangential solves (halves) are its start and safeguard.

use crate::bodies::component::Direction;
use crate::cgm::cone::{self, ConeMeasures, ConeProblem, ConeStart, ConeWorkspace, FrictionCone};
use crate::cgm::{
    AbsBound, BoundedPressure, CellCompliance, Constraint, ConstraintSet, Disc, InitialGuess,
    Interval, Total, UNLIMITED, reduce,
};
use crate::contact::{
    ElasticProblem, ElasticSolver, SolveContext, WindowEngine, interrupted_status, with_counts_of,
};
use crate::coupled::error_bound::Contraction;
use crate::coupled::increment::CoupledTarget;
use crate::coupled::{CoupledReport, N};
use crate::error::Result;
use crate::grid::boundary::Boundary;
use crate::grid::per_cell::PerCell;
use crate::grid::window::Window;
use crate::half_space::{Compliance, ElasticOperator, HalfSpace, Region};
use crate::memory::fallible;
use crate::normal::Hardness;
use crate::numerics::cell_vector::{slices, slices_mut};
use crate::operator::{LowerBound, MeanBound, Operator, Scratch};
use crate::parallel::layout::Layout;
use crate::report::{Report, Status};
use crate::tangential::{FrictionWithin, entry_compliance};

/// Relative tolerance of the alternating solves at the start.
const START: f64 = 1e-2;
/// Number of rounds after which cycling active sets end the solve. Each round takes more sweeps than the previous
/// round.
const ROUNDS: usize = 12;
/// Largest fraction of the friction capacity that a tangential half may use. The fraction is below one because the pressure is
/// not final.
const HELD: f64 = 0.999;

impl FrictionCone for &FrictionWithin<'_> {
    fn limit(&self, cell: usize, pressure: f64) -> f64 {
        FrictionWithin::limit(self, cell, pressure)
    }

    fn slope(&self, cell: usize, pressure: f64) -> f64 {
        FrictionWithin::slope(self, cell, pressure)
    }
}

/// Input of a coupled solve.
#[derive(Debug, Clone, Copy)]
pub(super) struct CoupledRequest<'a> {
    pub(super) demand: CoupledTarget<'a>,
    /// Datum of the gap.
    pub(super) datum: f64,
    /// Prescribed totals of pressure and tractions.
    pub(super) totals: [Total; N],
    /// Initial values of approach and shift relative to the prescribed values.
    pub(super) multiplier: [f64; N],
    /// Largest coefficient of friction of the whole grid.
    pub(super) largest_coefficient: f64,
    /// Whether the solve stops with the status `Stalled` as soon as the force exceeds the friction capacity of the
    /// present pressure.
    pub(super) is_doubtful: bool,
}

impl CoupledRequest<'_> {
    /// Returns whether neither a tangential force nor a spring acts.
    fn is_driven_by_shift(&self) -> bool {
        self.totals[1..].iter().all(|total| *total == Total::Free)
    }

    /// Returns the magnitude of the prescribed total of the tractions.
    fn force(&self) -> f64 {
        let [x, y] = [1, 2].map(|c| self.totals[c].sum().unwrap_or(0.0));
        x.hypot(y)
    }
}

/// Pressure and tractions of a window, with the solvers that compute them.
#[derive(Debug, Clone)]
pub(super) struct CoupledEngine {
    /// Window in the local part of the grid.
    region: Region,
    layout: Layout,
    /// Operator and buffer for the whole grid, or `None` if the window is the whole grid.
    whole: Option<GridOperator>,
    compliance: Compliance<N>,
    workspace: ConeWorkspace,
    normal: ElasticSolver<Interval, 1>,
    plane: ElasticSolver<Disc, 2>,
    /// Operators of the whole grid, along z and in the plane, for the bounds of their eigenvalues.
    normal_operator: ElasticOperator<1>,
    plane_operator: ElasticOperator<2>,
    /// Self-influence coefficient of the tangential operator.
    self_compliance: f64,
    contraction: Contraction,
    /// Whether the bounds of the halves can bound the whole error. On a grid that is periodic along both axes the mean
    /// has no norm.
    is_bounded: bool,
    /// Pressure and tractions, the start and the solution.
    x: [Vec<f64>; N],
    /// Linear term in the cells of the window.
    asked: [Vec<f64>; N],
    /// Tractions after the last alternating solves. The vectors are empty before the first of these solves.
    kept: [Vec<f64>; N],
    /// Linear term of a half, including the displacements due to the other half.
    linear: [Vec<f64>; N],
    /// `kappa g` of the cells that would come into contact. The vectors are empty if no cell lags.
    closing: CellTensors,
    enters: bool,
    /// Entry compliance `kappa g / p` for the pressure of a half. The vectors are empty if no cell comes into contact.
    own: CellTensors,
    image: [Vec<f64>; N],
    limits: Vec<f64>,
    /// Largest pressure if the limit is uniform. Otherwise `hardness_of_cells` contains the limit of each cell.
    hardness: PerCell<()>,
    hardness_of_cells: Vec<f64>,
}

/// Symmetric tensor of each cell, with a deviator for rolling bodies.
#[derive(Debug, Clone, Default)]
struct CellTensors {
    /// Mean over all directions.
    mean: Vec<f64>,
    deviator: Vec<[f64; 2]>,
}

impl CellTensors {
    fn view(&self) -> CellCompliance<'_> {
        CellCompliance::new(&self.mean, &self.deviator)
    }
}

/// Operator and buffer for products on the whole grid.
#[derive(Debug, Clone)]
struct GridOperator {
    operator: ElasticOperator<N>,
    scratch: Scratch,
}

impl WindowEngine for CoupledEngine {
    fn new(bodies: &HalfSpace, window: Window) -> Result<Self> {
        let (window, whole) = (bodies.place(window), Window::whole(bodies.grid()));
        let (size, region) = (window.size, Region::new(bodies, window));
        let [x, y, z] = [Direction::X, Direction::Y, Direction::Z];
        let compliance = bodies.compliance([z, x, y], size)?;
        // The certificate must be valid for the whole grid, not only for the window.
        let tensor = bodies.compliance([z, x, y], whole.size)?.operator;
        let normal = bodies.compliance([z], whole.size)?.operator;
        let plane = bodies.compliance([x, y], whole.size)?.operator;
        let cells = region.cells();
        let whole = if window == whole {
            None
        } else {
            Some(GridOperator {
                scratch: tensor.scratch()?,
                operator: tensor.clone(),
            })
        };
        Ok(Self {
            workspace: ConeWorkspace::new(&compliance.operator, &compliance.inverse)?,
            normal: ElasticSolver::new(bodies, [z], size)?,
            plane: ElasticSolver::new(bodies, [x, y], size)?,
            is_bounded: bodies.boundary() != Boundary::Periodic,
            contraction: Contraction {
                beta: bodies.pair().coupling_strength().abs(),
                coupling: tensor.coupling(),
                spread: (plane.upper_bound() / normal.bound_without_mean().0).sqrt(),
            },
            whole,
            layout: region.layout().clone().alike(bodies.team()),
            region,
            compliance,
            self_compliance: plane.self_compliance(),
            normal_operator: normal,
            plane_operator: plane,
            x: fallible::vector(cells)?,
            asked: fallible::vector(cells)?,
            kept: Default::default(),
            linear: fallible::vector(cells)?,
            closing: CellTensors::default(),
            enters: false,
            own: CellTensors::default(),
            image: fallible::vector(cells)?,
            limits: fallible::zeros(cells)?,
            hardness: PerCell::Uniform(f64::INFINITY),
            hardness_of_cells: Vec::new(),
        })
    }

    fn window(&self) -> Window {
        self.region.window()
    }

    fn move_to(&mut self, bodies: &HalfSpace, window: Window) {
        if window != self.window() {
            self.region = Region::new(bodies, window);
        }
    }
}

impl CoupledEngine {
    /// Sets the start from tractions of the whole grid.
    pub(super) fn take(&mut self, tractions: &[Vec<f64>; N]) {
        for (x, whole) in self.x.iter_mut().zip(tractions) {
            self.region.gather(whole, x);
        }
    }

    /// Writes the tractions of the solution and the displacements of the whole grid.
    pub(super) fn write(
        &mut self,
        tractions: &mut [Vec<f64>; N],
        displacement: &mut [Vec<f64>; N],
    ) {
        for (x, whole) in self.x.iter().zip(&mut *tractions) {
            whole.fill(0.0);
            self.region.scatter(x, whole);
        }
        match &mut self.whole {
            Some(GridOperator { operator, scratch }) => {
                operator.apply(slices(tractions), slices_mut(displacement), scratch);
            }
            None => {
                for (whole, product) in displacement.iter_mut().zip(self.workspace.product()) {
                    whole.copy_from_slice(product);
                }
            }
        }
    }

    /// Returns approach and shift relative to the prescribed values.
    pub(super) fn multiplier(&self) -> [f64; N] {
        self.workspace.multiplier
    }

    /// Solves in place from the gap and the linear term of every cell, and writes the outcome to the report.
    pub(super) fn solve(
        &mut self,
        (linear, closing): ([&[f64]; N], Option<CellCompliance<'_>>),
        task: CoupledRequest<'_>,
        mut start: ConeStart,
        conditions: &mut SolveContext<'_, '_>,
        report: &mut CoupledReport,
    ) -> Result<()> {
        self.workspace.multiplier = task.multiplier;
        for (asked, whole) in self.asked.iter_mut().zip(linear) {
            self.region.gather(whole, asked);
        }
        self.enters = closing.is_some();
        if let Some(closing) = closing {
            let (cells, own) = (self.region.cells(), &mut self.closing);
            fallible::resize(&mut own.mean, cells, 0.0)?;
            let (mean, deviator) = closing.parts();
            self.region.gather(mean, &mut own.mean);
            own.deviator.clear();
            if !deviator.is_empty() {
                // Rolling bodies are not distributed, so the cells have their global numbers.
                fallible::make_room(&mut own.deviator, cells)?;
                let values = self.region.own().indices().map(|i| deviator[i]);
                own.deviator.extend(values);
            }
        }
        let limits = task.demand.hardness.map_or(UNLIMITED, Hardness::limits);
        self.hardness = limits.map(|_| ());
        if let PerCell::Cells(cells) = limits {
            fallible::resize(&mut self.hardness_of_cells, self.region.cells(), 0.0)?;
            self.region.gather(cells, &mut self.hardness_of_cells);
        }
        let cells = self.normal_operator.layout().of_all_ranks();
        let added = task.totals.map(|total| total.uniform_compliance(cells));
        let [z, x, y] = added;
        let mut normal = self.normal_operator.lower_bound_of([z])?;
        // Without friction all tractions are zero, so the compliance of uniform tractions has no effect.
        let tangential = if task.largest_coefficient > 0.0 {
            [x, y]
        } else {
            [None; 2]
        };
        let mut in_plane = self.plane_operator.lower_bound_of(tangential)?;
        if !self.is_bounded {
            (normal.mean, in_plane.mean) = (MeanBound::Springs, MeanBound::Springs);
        }
        let (lower_bounds, known) = ([normal, in_plane], normal.known.min(in_plane.known));
        let friction = &task.demand.friction.within(&self.region);
        let mut sweeps = usize::from(start == ConeStart::Halves);
        let (least, mut tolerance) = (conditions.settings.tolerance.min(START), START);
        let mut stopped = None;
        for round in 1..=ROUNDS {
            for _ in 0..sweeps {
                stopped = self.sweep(task, friction, tolerance, conditions, report)?;
                if stopped.is_some() {
                    break;
                }
            }
            // A stopped half leaves tractions beyond the friction limits of its pressure. The Newton solver projects
            // these tractions, measures their residual, and then stops as well.
            let multiplier = self.workspace.multiplier;
            let has_halves = sweeps > 0;
            if has_halves {
                self.keep_halves()?;
            }
            let (status, findings) =
                self.newton((task, friction), (start, lower_bounds), conditions, report)?;
            let status = status.or(stopped);
            report.take(&findings);
            report.work.eigenvalue_bound = known;
            let (contraction, coefficient) = (self.contraction, task.largest_coefficient);
            report.error_estimate = contraction.estimate(coefficient, &findings);
            let may_bound = self.is_bounded && task.is_driven_by_shift();
            let bounds = || contraction.bounds(coefficient, &findings);
            report.error_bounds = may_bound.then(bounds).flatten();
            if let Some(status) = status {
                return report.end(status);
            }
            if findings.merit().is_nan()
                || task.is_doubtful && task.force() >= self.set_limits(friction)
            {
                break;
            }
            if has_halves && round < ROUNDS {
                // After cycling of the active sets, the result of the alternating solves is the better start.
                std::mem::swap(&mut self.x, &mut self.kept);
                self.workspace.multiplier = multiplier;
            }
            (sweeps, start) = (sweeps + 1, ConeStart::Halves);
            tolerance = (0.1 * findings.merit().min(tolerance)).clamp(least, START);
        }
        report.end(Status::Stalled)
    }

    /// Stores the tractions after the alternating solves.
    fn keep_halves(&mut self) -> Result<()> {
        for (kept, x) in self.kept.iter_mut().zip(&self.x) {
            fallible::resize(kept, x.len(), 0.0)?;
            kept.copy_from_slice(x);
        }
        Ok(())
    }

    /// Solves for pressure and tractions together by semismooth Newton steps.
    fn newton(
        &mut self,
        (task, friction): (CoupledRequest<'_>, &FrictionWithin<'_>),
        (start, lower_bounds): (ConeStart, [LowerBound; 2]),
        conditions: &mut SolveContext<'_, '_>,
        report: &mut CoupledReport,
    ) -> Result<(Option<Status>, ConeMeasures)> {
        let problem = ConeProblem {
            operator: &self.compliance.operator,
            preconditioner: &self.compliance.inverse,
            layout: &self.layout,
            linear: slices(&self.asked),
            closing: self.enters.then(|| self.closing.view()),
            hardness: self.hardness.map(|()| &*self.hardness_of_cells),
            friction,
            totals: task.totals,
            lower_bounds,
            self_compliance: self.self_compliance,
            coupling: self.contraction.beta,
        };
        let settings = conditions.with_remaining_limits(&report.work);
        let mut observer = with_counts_of(&report.work, &mut *conditions.observer);
        let x = slices_mut(&mut self.x);
        let ended = cone::solve(
            &problem,
            &settings,
            start,
            x,
            &mut self.workspace,
            &mut observer,
        );
        drop(observer);
        report.work.add_pass(self.workspace.linear.report());
        ended
    }

    /// Solves for the pressure under the present tractions, then for the tractions under that pressure. Returns a
    /// status if the observer or the time limit ended the sweep.
    fn sweep(
        &mut self,
        task: CoupledRequest<'_>,
        friction: &FrictionWithin<'_>,
        tolerance: f64,
        conditions: &mut SolveContext<'_, '_>,
        report: &mut CoupledReport,
    ) -> Result<Option<Status>> {
        let mut multiplier = [0.0; N];
        let ended = self.solve_normal_half(task, tolerance, conditions, report)?;
        [multiplier[0]] = self.normal.multiplier();
        if ended.is_some() {
            return Ok(ended);
        }
        let ended = self.solve_tangential_half(task, friction, tolerance, conditions, report)?;
        [multiplier[1], multiplier[2]] = self.plane.multiplier();
        self.workspace.multiplier = multiplier;
        Ok(ended)
    }

    fn solve_normal_half(
        &mut self,
        task: CoupledRequest<'_>,
        tolerance: f64,
        conditions: &mut SolveContext<'_, '_>,
        report: &mut CoupledReport,
    ) -> Result<Option<Status>> {
        self.add_displacements_of(&[1, 2]);
        let limits = self.hardness.map(|()| &*self.hardness_of_cells);
        let problem = self
            .normal
            .problem([&self.linear[0]], BoundedPressure(limits));
        let problem = problem.totals([task.totals[0]]);
        let reports = (&report.work, &mut report.normal);
        let half = (&mut self.normal, [&mut *self.x[0]]);
        minimise_half(half, &problem, tolerance, conditions, reports)
    }

    fn solve_tangential_half(
        &mut self,
        task: CoupledRequest<'_>,
        friction: &FrictionWithin<'_>,
        tolerance: f64,
        conditions: &mut SolveContext<'_, '_>,
        report: &mut CoupledReport,
    ) -> Result<Option<Status>> {
        self.add_displacements_of(&[0]);
        let capacity = self.set_limits(friction);
        let [_, along_x, along_y] = task.totals;
        let part = (HELD * capacity / task.force()).min(1.0);
        let totals = [along_x, along_y].map(|total| match total {
            Total::Sum(sum) if part < 1.0 => Total::Sum(part * sum),
            other => other,
        });
        if capacity <= 0.0 {
            self.x[1].fill(0.0);
            self.x[2].fill(0.0);
            return Ok(None);
        }
        self.set_own()?;
        let ([_, x, y], [_, asked_x, asked_y]) = (&mut self.x, &self.linear);
        let problem = self
            .plane
            .problem([asked_x.as_slice(), asked_y], AbsBound(&self.limits))
            .own(self.own.view())
            .totals(totals);
        let reports = (&report.work, &mut report.tangential);
        let half = (&mut self.plane, [&mut **x, &mut **y]);
        minimise_half(half, &problem, tolerance, conditions, reports)
    }

    /// Computes the entry compliances at the present pressure.
    fn set_own(&mut self) -> Result<()> {
        let (closing, own) = (&self.closing, &mut self.own);
        let has = |values: usize| if self.enters { values } else { 0 };
        fallible::resize(&mut own.mean, has(closing.mean.len()), 0.0)?;
        fallible::resize(&mut own.deviator, has(closing.deviator.len()), [0.0; 2])?;
        let pressures = &self.x[0];
        for ((own, closing), p) in own.mean.iter_mut().zip(&closing.mean).zip(pressures) {
            *own = entry_compliance(*closing, *p);
        }
        for ((own, closing), p) in own
            .deviator
            .iter_mut()
            .zip(&closing.deviator)
            .zip(pressures)
        {
            *own = closing.map(|part| if *p > 0.0 { part / p } else { 0.0 });
        }
        Ok(())
    }

    /// Computes the friction limits at the present pressure and returns their sum.
    fn set_limits(&mut self, friction: &FrictionWithin<'_>) -> f64 {
        for (i, limit) in self.limits.iter_mut().enumerate() {
            *limit = friction.limit(i, self.x[0][i]);
        }
        reduce::total(&self.layout, &self.limits)
    }

    /// Computes the linear term including the displacements due to these components of the tractions.
    fn add_displacements_of(&mut self, components: &[usize]) {
        for c in 0..N {
            if components.contains(&c) {
                self.linear[c].copy_from_slice(&self.x[c]);
            } else {
                self.linear[c].fill(0.0);
            }
        }
        let Compliance { operator, .. } = &self.compliance;
        let (tractions, image) = (slices(&self.linear), slices_mut(&mut self.image));
        let linear = &mut self.workspace.linear;
        linear.displace(operator, tractions, image);
        for (c, image) in self.image.iter().enumerate() {
            for (i, sum) in self.linear[c].iter_mut().enumerate() {
                *sum = self.asked[c][i] + image[i];
            }
        }
    }
}

/// Solves a half and adds the pass to its report. Returns the status if the observer or the time limit ended the solve. The
/// result of an unfinished half is also used.
fn minimise_half<S: ConstraintSet<M>, const M: usize>(
    (solver, x): (&mut ElasticSolver<S, M>, [&mut [f64]; M]),
    problem: &ElasticProblem<'_, impl Constraint<M, Set = S>, M>,
    tolerance: f64,
    conditions: &mut SolveContext<'_, '_>,
    (done, report): (&Report, &mut Report),
) -> Result<Option<Status>> {
    let settings = conditions.with_remaining_limits(done).tolerance(tolerance);
    let mut observer = with_counts_of(done, &mut *conditions.observer);
    let start = (x, InitialGuess::Nothing);
    let ended = interrupted_status(solver.minimise(problem, start, &settings, &mut observer));
    solver.rest();
    report.add_pass(solver.report());
    ended
}
