//! After a cancellation or a time limit a solve takes at most one more product. It then returns a feasible iterate with
//! its status. An iteration limit applies to all passes of a solve on its grid.

use std::ops::ControlFlow;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::Duration;

use kit::{rough, unit_bodies};
use stickslip::Iteration;
use stickslip::cgm::{self, AbsBound, Method, NonNegative, Problem, Settings};
use stickslip::influence::Component;
use stickslip::{
    Axis, CoupledProblem, ElasticOperator, Error, HalfSpace, History, LoadStep, NormalLoad,
    NormalProblem, Operator, Report, Scratch, Status, TangentialControl, TangentialLoad,
    TangentialModel,
};

/// Operator that counts its products.
struct Counting {
    inner: ElasticOperator,
    products: AtomicUsize,
}

impl Counting {
    fn of(bodies: &HalfSpace, component: Component) -> Self {
        Self {
            inner: bodies.operator(component).unwrap(),
            products: AtomicUsize::new(0),
        }
    }

    fn count(&self) -> usize {
        self.products.load(Ordering::Relaxed)
    }
}

impl Operator for Counting {
    fn cells(&self) -> usize {
        self.inner.cells()
    }

    fn scratch(&self) -> stickslip::Result<Scratch> {
        self.inner.scratch()
    }

    fn apply(&self, x: [&[f64]; 1], out: [&mut [f64]; 1], scratch: &mut Scratch) {
        self.products.fetch_add(1, Ordering::Relaxed);
        self.inner.apply(x, out, scratch);
    }

    fn apply_f32(&self, x: [&[f64]; 1], out: [&mut [f64]; 1], scratch: &mut Scratch) {
        self.products.fetch_add(1, Ordering::Relaxed);
        self.inner.apply_f32(x, out, scratch);
    }

    fn lower_bound(&self) -> f64 {
        self.inner.lower_bound()
    }
}

/// Returns the report of a solve that ended with the given status.
fn ended(outcome: Result<(), Error>, status: Status) -> Report {
    let Err(Error::NotConverged(report)) = outcome else {
        panic!("{outcome:?}");
    };
    assert_eq!(report.status, status);
    // The residual and the gap are infinite if no displacement exists yet as their scale.
    assert!(report.residual >= 0.0 && report.duality_gap >= 0.0);
    *report
}

/// Returns the number of products in both precisions.
fn products(report: &Report) -> usize {
    report.double_precision_products + report.single_precision_products
}

#[test]
fn observer_is_called_before_every_product() {
    let bodies = unit_bodies(kit::square(kit::thorough(32, 48), 100.0), 0.3);
    let gap = rough(bodies.grid(), 3);
    let limits: Vec<f64> = gap.as_slice().iter().map(|h| (1.5 - h).max(0.0)).collect();
    let shifted = vec![-1.0; limits.len()];
    let inverse = bodies.preconditioner(Component::ZZ).unwrap().unwrap();
    for method in [Method::ActiveSet, Method::PolonskyKeer] {
        let settings = Settings::default().method(method).tolerance(1e-11);
        for total in [None, Some(kit::thorough(25.0, 80.0))] {
            // The start is the least value of the gap, or an approach that closes the gap in a part of the cells.
            let datum = if total.is_some() { 0.0 } else { 1.0 };
            let linear: Vec<f64> = gap.as_slice().iter().map(|h| h - datum).collect();
            let normal = |x: &mut [f64], observer: &mut Observer<'_>, settings: &Settings| {
                let operator = Counting::of(&bodies, Component::ZZ);
                let problem = Problem::new(&operator, [&linear], NonNegative);
                let problem = problem.preconditioner(inverse.clone());
                let problem = total.into_iter().fold(problem, Problem::total);
                let outcome = cgm::minimise_with(
                    &problem,
                    settings,
                    [x],
                    &mut problem.workspace().unwrap(),
                    &mut |iteration| observer(iteration, operator.count()),
                );
                assert!(x.iter().all(|p| *p >= 0.0));
                (outcome, operator.count())
            };
            let shear = |x: &mut [f64], observer: &mut Observer<'_>, settings: &Settings| {
                let operator = Counting::of(&bodies, Component::XX);
                let problem = Problem::new(&operator, [&shifted], AbsBound(&limits));
                let problem = problem.preconditioner(inverse.clone());
                let problem = total.into_iter().fold(problem, Problem::total);
                let outcome = cgm::minimise_with(
                    &problem,
                    settings,
                    [x],
                    &mut problem.workspace().unwrap(),
                    &mut |iteration| observer(iteration, operator.count()),
                );
                assert!(x.iter().zip(&limits).all(|(q, m)| q.abs() <= *m));
                (outcome, operator.count())
            };
            for solve in [&normal as &Solve<'_>, &shear] {
                assert_stops(solve, &settings, limits.len(), total);
            }
        }
    }
}

type Observer<'a> = dyn FnMut(&Iteration, usize) -> ControlFlow<()> + Send + 'a;
type Solve<'a> =
    dyn Fn(&mut [f64], &mut Observer<'_>, &Settings) -> (Result<(), Error>, usize) + 'a;

fn assert_stops(solve: &Solve<'_>, settings: &Settings, len: usize, total: Option<f64>) {
    let sum = |x: &[f64]| x.iter().sum::<f64>();
    let keeps_total = |x: &[f64]| total.is_none_or(|total| (sum(x) / total - 1.0).abs() < 1e-12);
    // Without cancellation there are never two products between calls of the observer.
    let (mut calls, mut last) = (0, 0);
    let mut watch = |_: &Iteration, count: usize| {
        calls += 1;
        assert!(
            count <= last + 1,
            "{count} products, {last} at the last call of the observer"
        );
        last = count;
        ControlFlow::Continue(())
    };
    let mut x = vec![0.0; len];
    let (outcome, count) = solve(&mut x, &mut watch, settings);
    outcome.unwrap();
    assert!(count <= last + 1 && calls > 20);
    for stop in (0..calls).step_by(kit::thorough(17, 3)) {
        let (mut left, mut at_stop) = (stop, 0);
        let mut cancel = |_: &Iteration, count: usize| {
            if left == 0 {
                at_stop = count;
                return ControlFlow::Break(());
            }
            left -= 1;
            ControlFlow::Continue(())
        };
        let mut x = vec![0.0; len];
        let (outcome, count) = solve(&mut x, &mut cancel, settings);
        let report = ended(outcome, Status::Cancelled);
        assert!(
            count <= at_stop + 1,
            "{count} products, cancelled at {at_stop}"
        );
        assert!(count == products(&report) && keeps_total(&x));
    }
    let timed = settings.time_limit(Duration::ZERO);
    let mut x = vec![0.0; len];
    let (outcome, count) = solve(&mut x, &mut |_, _| ControlFlow::Continue(()), &timed);
    ended(outcome, Status::TimeLimit);
    assert!(count <= 1 && keeps_total(&x));
}

/// Result of a solve of several passes, with the iterations that its observer received.
struct PassLog {
    report: Report,
    seen: Vec<Iteration>,
}

impl PassLog {
    fn new(outcome: Result<Report, Error>, seen: Vec<Iteration>) -> Self {
        let report = outcome.unwrap_or_else(|error| match error {
            Error::NotConverged(report) => *report,
            other => panic!("{other}"),
        });
        Self { report, seen }
    }

    /// Asserts that the counts increase from pass to pass. The last entry of the history must not exceed the counts of
    /// the report.
    fn assert_counted_once(&self) {
        let Self { report, seen } = self;
        for steps in [seen, &report.history] {
            assert!(steps.is_sorted_by_key(|step| step.iteration));
            assert!(steps.is_sorted_by_key(|step| step.double_precision_products));
            assert!(steps.last().is_some_and(|last| {
                last.iteration <= report.iterations
                    && last.double_precision_products <= report.double_precision_products
            }));
        }
    }
}

/// Solves with every iteration limit and asserts that the limit is kept.
fn assert_limited(least: usize, solve: impl Fn(usize) -> PassLog) {
    let whole = solve(10_000);
    assert_eq!(whole.report.status, Status::Converged);
    whole.assert_counted_once();
    let free = whole.report.iterations;
    assert!(least < free, "{least}, {}", whole.report);
    for limit in least..free {
        let PassLog { report, .. } = &solve(limit);
        assert_eq!(
            (report.status, report.iterations),
            (Status::IterationLimit, limit)
        );
    }
    assert_eq!(solve(free + 1).report.status, Status::Converged);
}

/// If the contact outgrows its window, the load is solved again in a larger window.
#[test]
fn enlarged_window_has_remaining_iterations() {
    let grid = kit::square(64, 100.0);
    let bodies = unit_bodies(grid, 0.3);
    let light = NormalLoad::Force(0.02);
    let builder =
        || NormalProblem::builder(&bodies, kit::sphere(grid, 300.0), light).tolerance(1e-10);
    let alone = kit::solve(builder());
    assert_limited(alone.report().iterations.max(1), |limit| {
        let problem = builder().max_iterations(limit).build().unwrap();
        let mut solver = problem.into_solver().unwrap();
        let mut solution = kit::solved(&mut solver);
        solver.set_load(NormalLoad::Force(50.0)).unwrap();
        let mut seen = Vec::new();
        let outcome = solver.solve_observed(&mut solution, |step| {
            seen.push(*step);
            ControlFlow::Continue(())
        });
        assert!((solution.force() / 50.0 - 1.0).abs() < 1e-11 && solution.pressure().min() >= 0.0);
        PassLog::new(outcome.map(|()| solution.report().clone()), seen)
    });
}

/// If a spring is much softer than the contact, a step is solved again with a smaller tolerance.
#[test]
fn finer_pass_with_soft_spring_has_remaining_iterations() {
    let grid = kit::square(48, 8.0);
    let bodies = unit_bodies(grid, 0.3);
    let press = LoadStep::hold().normal(NormalLoad::Force(0.5));
    let stiffness = 1e-4;
    let drag = LoadStep::hold().tangential(
        Axis::X,
        TangentialControl::Spring {
            position: 0.1 / stiffness,
            stiffness,
        },
    );
    for lateral in [TangentialModel::Scalar, TangentialModel::Vector] {
        // The limit applies to the second step only. The first step would otherwise start from coarser cells with fewer
        // iterations.
        let pressed = || {
            let builder = History::builder(&bodies, kit::sphere(grid, 10.0), kit::coulomb(0.3))
                .model(lateral);
            let mut history = builder.tolerance(1e-6).build().unwrap();
            history.step(&press).unwrap();
            history
        };
        assert_limited(1, |limit| {
            let mut history = pressed();
            let settings = history.settings().max_iterations(limit);
            history.set_settings(settings).unwrap();
            let mut seen = Vec::new();
            let outcome = history.step_observed(&drag, |step| {
                seen.push(*step);
                ControlFlow::Continue(())
            });
            let report = outcome.map(|step| step.tangential_report().unwrap().clone());
            PassLog::new(report, seen)
        });
    }
}

/// A solve of several grids and passes ends each of them separately. No pass calls the observer after the time limit.
#[test]
fn observer_is_not_called_after_the_time_limit() {
    let bodies = HalfSpace::new(kit::square(64, 3.0), kit::on_rigid(1.0, 0.0)).unwrap();
    let (gap, friction) = (kit::sphere(bodies.grid(), 1.0), kit::coulomb(0.3));
    let limit = Duration::from_millis(20);
    let (press, drag) = (NormalLoad::Force(0.5), TangentialLoad::force([0.05, 0.0]));
    for is_over_at_start in [true, false] {
        let mut late = 0;
        let start = std::time::Instant::now();
        let mut observer = |_: &Iteration| {
            late += usize::from(start.elapsed() >= limit);
            if !is_over_at_start {
                std::thread::sleep(limit);
            }
            ControlFlow::Continue(())
        };
        let limit = if is_over_at_start {
            Duration::ZERO
        } else {
            limit
        };
        let problem = CoupledProblem::builder(&bodies, &gap, friction.clone(), press, drag);
        let mut solver = kit::solver(problem.time_limit(limit));
        let mut contact = solver.new_solution();
        let outcome = solver.solve_observed(&mut contact, &mut observer);
        let Err(Error::NotConverged(report)) = outcome else {
            panic!("{outcome:?}")
        };
        assert_eq!((report.status, late), (Status::TimeLimit, 0));
    }
}

/// No pass and no grid calls the observer after it has cancelled.
#[test]
fn observer_is_not_called_after_it_has_cancelled() {
    let bodies = HalfSpace::new(kit::square(64, 3.0), kit::on_rigid(1.0, 0.0)).unwrap();
    let (gap, friction) = (kit::sphere(bodies.grid(), 1.0), kit::coulomb(0.3));
    let (press, drag) = (NormalLoad::Force(0.5), TangentialLoad::force([0.05, 0.0]));
    for last in [1, 2, 5] {
        let problem = CoupledProblem::builder(&bodies, &gap, friction.clone(), press, drag);
        let mut solver = kit::solver(problem);
        let (mut contact, mut calls) = (solver.new_solution(), 0);
        let outcome = solver.solve_observed(&mut contact, |_| {
            calls += 1;
            if calls == last {
                return ControlFlow::Break(());
            }
            ControlFlow::Continue(())
        });
        assert!(
            matches!(outcome, Err(Error::NotConverged(report)) if report.status == Status::Cancelled)
        );
        assert_eq!(calls, last);
    }
}
