//! A solve that its observer has cancelled once reports the cancellation, regardless of later return values of the
//! observer. A cancelled step leaves the history unchanged.

use std::ops::ControlFlow;

use kit::{Random, rough, thorough, unit_bodies};
use stickslip::Iteration;
use stickslip::cgm::{self, AbsBound, Method, NonNegative, Problem};
use stickslip::influence::Component;
use stickslip::{
    Axis, Boundary, Coupling, Error, Field, Grid, HalfSpace, History, LoadStep, NormalLoad,
    NormalProblem, Status, TangentialControl, TangentialModel,
};

type Observer<'a> = &'a mut (dyn FnMut(&Iteration) -> ControlFlow<()> + Send);

/// Cancels the solve at selected calls of the observer, lets it continue at all other calls, and checks that the solve
/// returns the error. Returns the number of calls of a solve that is not cancelled.
fn assert_cancelled<T>(
    stride: usize,
    mut solve: impl FnMut(Observer<'_>) -> Result<T, Error>,
) -> usize {
    let mut last = 1;
    loop {
        let mut calls = 0;
        let outcome = solve(&mut |_| {
            calls += 1;
            if calls == last {
                ControlFlow::Break(())
            } else {
                ControlFlow::Continue(())
            }
        });
        if calls < last {
            assert!(outcome.is_ok(), "{:?}", outcome.err());
            return calls;
        }
        let place = format!("cancelled at call {last} of {calls}");
        match outcome {
            Err(Error::NotConverged(report)) => {
                assert_eq!(report.status, Status::Cancelled, "{place}");
            }
            Err(error) => panic!("{place}: {error}"),
            Ok(_) => panic!("{place}: solved"),
        }
        last += stride;
    }
}

/// Takes the steps in sequence. Each step is first cancelled at every call of the observer.
fn assert_steps_cancelled(history: &mut History, steps: &[LoadStep]) -> usize {
    let mut twin = history.clone();
    let mut calls = 0;
    for step in steps {
        let bytes = history.to_bytes();
        let stride = thorough(3, 1);
        let mut disturbed = history.clone();
        let take = |observer: Observer<'_>| {
            let outcome = disturbed.step_observed(step, &mut *observer);
            outcome.map(drop).inspect_err(|_| {
                assert_eq!(disturbed.to_bytes(), bytes, "{step:?}");
            })
        };
        calls += assert_cancelled(stride, take);
        twin.step(step).unwrap();
        assert_eq!(disturbed.to_bytes(), twin.to_bytes(), "{step:?}");
        *history = disturbed;
    }
    calls
}

fn press_step(force: f64) -> LoadStep {
    LoadStep::hold().normal(NormalLoad::Force(force))
}

fn with_tangential_force(load: LoadStep, force: f64) -> LoadStep {
    load.tangential(Axis::X, TangentialControl::Force(force))
}

fn coupled_bodies(grid: Grid) -> HalfSpace {
    HalfSpace::new(grid, kit::on_rigid(1.0, 0.1)).unwrap()
}

/// Returns a sphere on a grid. The grid can be so large that the solve starts on coarser grids.
fn sphere_gap(cells: usize) -> (Grid, Field) {
    let grid = kit::square(cells, 3.0);
    (grid, kit::sphere(grid, 2.0))
}

/// The tractions of a cancelled solve have no stiffness.
#[test]
fn cancelled_solution_has_no_stiffness() {
    let (grid, gap) = sphere_gap(24);
    let bodies = unit_bodies(grid, 0.3);
    let problem = NormalProblem::builder(&bodies, &gap, NormalLoad::Force(1.0));
    let mut solver = problem.build().unwrap().into_solver().unwrap();
    let mut contact = solver.new_solution();
    let cancelled = solver.solve_observed(&mut contact, |_| ControlFlow::Break(()));
    assert!(cancelled.is_err() && contact.report().status == Status::Cancelled);
    kit::assert_refused! { contact.stiffness(&bodies) => Error::NotConverged(_) }
}

/// Covers steps in which the starts from coarser grids take most of the calls, and steps on a line of cells.
#[test]
fn history_cancelled_step_with_nested_start_is_not_taken() {
    let (grid, gap) = sphere_gap(48);
    let bodies = unit_bodies(grid, 0.3);
    let mut history = History::builder(&bodies, &gap, kit::coulomb(0.3))
        .build()
        .unwrap();
    let first = with_tangential_force(press_step(0.2), 0.04);
    assert_steps_cancelled(&mut history, &[first]);

    let line = Grid::line(200, 0.02).unwrap();
    let boundary = Boundary::PeriodicAlongY { datum: 10.0 };
    let bodies = HalfSpace::with_boundary(line, kit::on_rigid(1.0, 0.3), boundary).unwrap();
    let gap = rough(line, 3);
    let builder = History::builder(&bodies, &gap, kit::coulomb(0.3)).coupling(Coupling::Neglected);
    let mut history = builder.build().unwrap();
    assert_steps_cancelled(
        &mut history,
        &[
            with_tangential_force(press_step(0.02), 0.003),
            press_step(0.1),
        ],
    );
}

/// Covers random loads, because a step can end in many ways.
#[test]
fn history_cancelled_step_of_random_loads_is_not_taken() {
    let mut random = Random(17);
    for case in 0..thorough(3, 300) {
        let (grid, ball) = sphere_gap(12);
        let bodies = if random.chance(0.5) {
            unit_bodies(grid, 0.3)
        } else {
            coupled_bodies(grid)
        };
        let gap = if random.chance(0.5) {
            rough(grid, case)
        } else {
            ball
        };
        let model = random.pick(&[TangentialModel::Scalar, TangentialModel::Vector]);
        let builder = History::builder(&bodies, &gap, kit::coulomb(0.3)).model(model);
        let tolerance = random.decade(-9.0, -0.3);
        let mut history = builder.tolerance(tolerance).build().unwrap();
        for _ in 0..4 {
            let force = random.decade(-3.0, 1.0);
            let step = match random.integer(0, 3) {
                0 => press_step(force),
                1 => LoadStep::hold()
                    .tangential(Axis::X, TangentialControl::Shift(random.uniform(-0.5, 0.5))),
                2 => with_tangential_force(
                    press_step(force),
                    0.3 * force * random.uniform(-1.0, 1.0),
                ),
                _ => press_step(force).tangential(
                    Axis::X,
                    TangentialControl::Spring {
                        position: random.uniform(-2.0, 2.0),
                        stiffness: random.decade(-3.0, 3.0),
                    },
                ),
            };
            if history.clone().step(&step).is_ok() {
                assert_steps_cancelled(&mut history, &[step]);
            }
        }
    }
}

/// Covers minima of a custom problem, and the stiffness of a step.
#[test]
fn minimiser_and_stiffness_cancelled_report_cancellation() {
    let (grid, gap) = sphere_gap(12);
    let bodies = unit_bodies(grid, 0.3);
    let operator = bodies.operator(Component::ZZ).unwrap();
    let limits = vec![0.1; grid.cells()];
    for method in [Method::ActiveSet, Method::PolonskyKeer] {
        let settings = cgm::Settings::default().method(method);
        let pressed = Problem::new(&operator, [gap.as_slice()], NonNegative).total(3.0);
        let bounded = Problem::new(&operator, [gap.as_slice()], AbsBound(&limits)).total(3.0);
        let solve = |observer: Observer<'_>| {
            let mut x = vec![0.0; grid.cells()];
            let mut workspace = pressed.workspace()?;
            cgm::minimise_with(&pressed, &settings, [&mut x], &mut workspace, observer)
        };
        assert_cancelled(1, solve);
        let solve = |observer: Observer<'_>| {
            let mut x = vec![0.0; grid.cells()];
            let mut workspace = bounded.workspace()?;
            cgm::minimise_with(&bounded, &settings, [&mut x], &mut workspace, observer)
        };
        assert_cancelled(1, solve);
    }
    for model in [TangentialModel::Scalar, TangentialModel::Vector] {
        let builder = History::builder(&bodies, &gap, kit::coulomb(0.3)).model(model);
        let mut history = builder.build().unwrap();
        history
            .step(&with_tangential_force(press_step(0.2), 0.03))
            .unwrap();
        let solve = |observer: Observer<'_>| history.stiffness_observed(observer);
        assert_cancelled(1, solve);
    }
}
