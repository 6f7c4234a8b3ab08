//! Tests of user-defined operators. Operators of known bodies give the results of these bodies in every supported
//! problem. Heterogeneous bodies agree with a dense matrix. Unsupported uses are rejected.

use std::sync::Arc;
use std::time::Duration;

use kit::{l2_difference, max_abs, max_difference, press};
use stickslip::cgm::{Method, NonNegative};
use stickslip::dense::DenseOperator;
use stickslip::history::{Rolling, wear};
use stickslip::influence::Component;
use stickslip::influence::Direction::{self, X, Y, Z};
use stickslip::kernel::Operators;
use stickslip::ranks::Threads;
use stickslip::rolling::RollingProblem;
use stickslip::stiffness::StiffnessWorkspace;
use stickslip::{
    Axis, Boundary, CoupledProblem, Coupling, EigenvalueBound, ElasticPair, Error, Field, Grid,
    HalfSpace, History, Kernel, LoadStep, Material, NormalLoad, NormalProblem, NormalSolution,
    Operator, Scratch, Status, TangentialControl, TangentialLoad, TangentialModel,
    TangentialProblem,
};

/// Operator of elastic bodies with an additional local compliance, with or without an eigenvalue bound.
struct ModifiedOperator<const N: usize> {
    of: stickslip::ElasticOperator<N>,
    /// Additional compliance of each cell.
    springs: Vec<f64>,
    is_bounded: bool,
}

impl<const N: usize> Operator<N> for ModifiedOperator<N> {
    fn cells(&self) -> usize {
        self.of.cells()
    }

    fn scratch(&self) -> stickslip::Result<Scratch> {
        self.of.scratch()
    }

    fn apply(&self, x: [&[f64]; N], mut out: [&mut [f64]; N], scratch: &mut Scratch) {
        self.of
            .apply(x, out.each_mut().map(|out| &mut **out), scratch);
        for (out, x) in out.into_iter().zip(x) {
            for ((out, x), spring) in out.iter_mut().zip(x).zip(&self.springs) {
                *out += spring * x;
            }
        }
    }

    fn lower_bound(&self) -> f64 {
        if self.is_bounded {
            self.of.lower_bound()
        } else {
            0.0
        }
    }

    fn eigenvalue_bound(&self) -> EigenvalueBound {
        if self.is_bounded {
            self.of.eigenvalue_bound()
        } else {
            EigenvalueBound::Unknown
        }
    }
}

/// Operator whose displacements are modified, with a different lower bound.
struct AsymmetricOperator<F> {
    of: ModifiedOperator<1>,
    modify: F,
    bound: f64,
}

fn asymmetric<F: Fn(&[f64], &mut [f64])>(
    of: ModifiedOperator<1>,
    modify: F,
    bound: f64,
) -> AsymmetricOperator<F> {
    AsymmetricOperator { of, modify, bound }
}

impl<F: Fn(&[f64], &mut [f64]) + Sync> Operator for AsymmetricOperator<F> {
    fn cells(&self) -> usize {
        self.of.cells()
    }

    fn scratch(&self) -> stickslip::Result<Scratch> {
        self.of.scratch()
    }

    fn apply(&self, [x]: [&[f64]; 1], [out]: [&mut [f64]; 1], scratch: &mut Scratch) {
        self.of.apply([x], [&mut *out], scratch);
        (self.modify)(x, out);
    }

    fn lower_bound(&self) -> f64 {
        self.bound
    }
}

/// Operator that adds its displacements to the output.
struct AccumulatingOperator(ModifiedOperator<1>);

impl Operator for AccumulatingOperator {
    fn cells(&self) -> usize {
        self.0.cells()
    }

    fn scratch(&self) -> stickslip::Result<Scratch> {
        self.0.scratch()
    }

    fn apply(&self, x: [&[f64]; 1], [out]: [&mut [f64]; 1], scratch: &mut Scratch) {
        let before = out.to_vec();
        self.0.apply(x, [&mut *out], scratch);
        for (out, before) in out.iter_mut().zip(before) {
            *out += before;
        }
    }
}

fn pair(coupled: bool) -> ElasticPair {
    let body = Material::new(1.0, 0.2).unwrap();
    let other = if coupled { Material::rigid() } else { body };
    ElasticPair::new(body, other).unwrap()
}

fn of<const N: usize>(
    bodies: &HalfSpace,
    directions: [Direction; N],
    spring: impl Fn(usize) -> f64,
) -> ModifiedOperator<N> {
    ModifiedOperator {
        of: bodies.tensor_operator(directions).unwrap(),
        springs: (0..bodies.grid().cells()).map(spring).collect(),
        is_bounded: true,
    }
}

/// Returns the same bodies as two operators: one for the pressure and one for the tractions.
fn with_separate_operators(bodies: &HalfSpace) -> HalfSpace {
    let operators = Operators::new()
        .with([Z], of(bodies, [Z], |_| 0.0))
        .with([X, Y], of(bodies, [X, Y], |_| 0.0));
    with_operators(bodies, operators)
}

/// Returns the same bodies as one operator of all directions, in a different order.
fn with_joint_operator(bodies: &HalfSpace) -> HalfSpace {
    with_operators(
        bodies,
        Operators::new().with([Y, Z, X], of(bodies, [Y, Z, X], |_| 0.0)),
    )
}

fn with_operators(like: &HalfSpace, operators: Operators) -> HalfSpace {
    let kernel = Kernel::operators(*like.pair(), operators).unwrap();
    HalfSpace::with_boundary(like.grid(), kernel, like.boundary()).unwrap()
}

fn close(found: &Field, expected: &Field, tolerance: f64) {
    let error = max_difference(found.as_slice(), expected.as_slice());
    let unit = max_abs(expected.as_slice());
    assert!(error <= tolerance * unit, "{:e}", error / unit);
}

fn gap(bodies: &HalfSpace) -> Field {
    kit::sphere(bodies.grid(), 3.0)
}

/// Compares the pressure, and the traction along x and in both models, on every type of grid.
#[test]
fn user_operator_contacts_match_bodies() {
    for (grid, boundary) in [
        (
            kit::thorough(Grid::new(26, 22, 0.15, 0.18), Grid::new(40, 34, 0.1, 0.12)).unwrap(),
            Boundary::NonPeriodic,
        ),
        (
            kit::thorough(Grid::new(18, 20, 0.2, 0.18), Grid::new(24, 30, 0.15, 0.12)).unwrap(),
            Boundary::Periodic,
        ),
        (
            Grid::new(60, 1, 0.05, 1.0).unwrap(),
            Boundary::PeriodicAlongY { datum: 40.0 },
        ),
    ] {
        let bodies = HalfSpace::with_boundary(grid, pair(false), boundary).unwrap();
        let solved = |bodies: &HalfSpace| {
            let load = NormalLoad::Force(0.05);
            let normal = press(bodies, &gap(bodies), load, 1e-12);
            let friction = kit::coulomb(0.3);
            let problem = |load: TangentialLoad, model| {
                kit::solve(
                    TangentialProblem::builder(bodies, &normal, friction.clone(), load)
                        .model(model)
                        .tolerance(1e-12),
                )
            };
            let along = problem(
                TangentialLoad::force([0.01, 0.0]),
                TangentialModel::default(),
            );
            let plane = problem(
                TangentialLoad::force([0.006, 0.005]),
                TangentialModel::Vector,
            );
            (normal, along, plane)
        };
        let (normal, along, plane) = solved(&bodies);
        for other in [
            with_separate_operators(&bodies),
            with_joint_operator(&bodies),
        ] {
            let (other_normal, other_along, other_plane) = solved(&other);
            let report = other_normal.report();
            assert_eq!(report.eigenvalue_bound, EigenvalueBound::Proven);
            close(other_normal.pressure(), normal.pressure(), 1e-9);
            assert!((other_normal.approach() / normal.approach() - 1.0).abs() < 1e-9);
            close(other_along.traction()[0], along.traction()[0], 1e-9);
            for axis in [0, 1] {
                close(other_plane.traction()[axis], plane.traction()[axis], 1e-9);
            }
            // The operator has the same preconditioner as the bodies, but no start from coarser cells.
            let most = 2 * normal.report().products() + 20;
            assert!(report.products() <= most, "{}", report.products());
        }
    }
}

/// Compares the coupled solution and its report.
#[test]
fn user_operator_coupled_contacts_match_bodies() {
    let bodies = HalfSpace::new(kit::square(32, 3.0), pair(true)).unwrap();
    let solved = |bodies: &HalfSpace| {
        let (load, still) = (NormalLoad::Force(0.05), TangentialLoad::force([0.006, 0.0]));
        let problem = CoupledProblem::builder(bodies, gap(bodies), kit::coulomb(0.4), load, still);
        kit::solve(problem.tolerance(1e-11))
    };
    let (expected, found) = (solved(&bodies), solved(&with_joint_operator(&bodies)));
    assert_eq!(
        found.report().work.eigenvalue_bound,
        EigenvalueBound::Proven
    );
    close(
        found.normal().pressure(),
        expected.normal().pressure(),
        1e-8,
    );
    close(
        found.tangential().traction()[0],
        expected.tangential().traction()[0],
        1e-8,
    );
    // A bound of the total error by its normal and tangential parts requires the largest eigenvalue.
    assert!(found.report().error_bounds.is_none());

    // The coupled problem requires one operator of all directions.
    let (separate, friction) = (with_separate_operators(&bodies), kit::coulomb(0.4));
    let (load, still) = (NormalLoad::Force(0.05), TangentialLoad::force([0.006, 0.0]));
    let gap = gap(&bodies);
    let refused = CoupledProblem::builder(&separate, &gap, friction, load, still).build();
    assert!(matches!(refused, Err(Error::IncompleteKernel(_))));
}

/// Compares a history with load reversal that continues after a restart, and its stiffness.
#[test]
fn user_operator_histories_match_bodies() {
    let bodies = HalfSpace::new(kit::square(kit::thorough(26, 36), 3.0), pair(false)).unwrap();
    let friction = kit::coulomb(0.3);
    let step = |normal: f64, force: f64| {
        LoadStep::hold()
            .normal(NormalLoad::Force(normal))
            .tangential(Axis::X, TangentialControl::Force(force))
    };
    let path = [(0.05, 0.0), (0.05, 0.01), (0.06, -0.008), (0.055, 0.0)];
    let followed = |bodies: &HalfSpace| {
        let mut history = History::builder(bodies, gap(bodies), friction.clone())
            .tolerance(1e-12)
            .build()
            .unwrap();
        for (normal, force) in path {
            history.step(&step(normal, force)).unwrap();
        }
        history
    };
    let expected = followed(&bodies);
    let others = with_separate_operators(&bodies);
    let mut found = followed(&others);
    close(
        found.state().traction()[0],
        expected.state().traction()[0],
        1e-8,
    );
    let [own, other] = [&expected, &found].map(|of| of.stiffness().unwrap());
    assert!((other.normal.value / own.normal.value - 1.0).abs() < 1e-7);

    // Operators that are created again describe the same bodies. Different operators describe different bodies.
    let bytes = found.to_bytes();
    let mut again = History::from_bytes(&with_separate_operators(&bodies), &bytes).unwrap();
    for history in [&mut found, &mut again] {
        history.step(&step(0.05, 0.009)).unwrap();
    }
    assert_eq!(found.to_bytes(), again.to_bytes());
    let softer = Operators::new()
        .with([Z], of(&bodies, [Z], |_| 1e-6))
        .with([X, Y], of(&bodies, [X, Y], |_| 0.0));
    for others in [bodies.clone(), with_operators(&bodies, softer)] {
        kit::assert_refused! { History::from_bytes(&others, &bytes) => Error::MaterialMismatch { .. } }
    }
}

/// One half of the body is softer, which no convolution can represent. The reference is the active set of a dense
/// matrix. Operators are used with and without an eigenvalue bound.
#[test]
fn heterogeneous_bodies_match_dense_matrix() {
    let grid = Grid::new(14, 12, 0.25, 0.25).unwrap();
    let bodies = HalfSpace::new(grid, pair(false)).unwrap();
    let soft = |cell: usize| if cell % 14 < 7 { 0.6 } else { 0.0 };
    let cells = grid.cells();
    let matrix = DenseOperator::of_half_space(&bodies, Component::ZZ).unwrap();
    let entries = (0..cells * cells)
        .map(|n| {
            let (row, column) = (n / cells, n % cells);
            let spring = if row == column { soft(row) } else { 0.0 };
            matrix.get(row, column).unwrap() + spring
        })
        .collect();
    let matrix = DenseOperator::from_rows(cells, entries).unwrap();
    let load = 0.4;
    let gap = gap(&bodies);
    let exact = matrix
        .minimise(gap.as_slice(), &NonNegative, Some(load / grid.cell_area()))
        .unwrap()
        .x;
    for is_bounded in [true, false] {
        let mut operator = of(&bodies, [Z], soft);
        operator.is_bounded = is_bounded;
        let soft = with_operators(&bodies, Operators::new().with([Z], operator));
        for method in [Method::ActiveSet, Method::PolonskyKeer] {
            let found = kit::press_by(&soft, &gap, NormalLoad::Force(load), 1e-11, method);
            let error = l2_difference(found.pressure().as_slice(), &exact);
            assert!(error < 1e-9, "{error:e}");
            let report = found.report();
            let expected = if is_bounded {
                EigenvalueBound::Proven
            } else {
                EigenvalueBound::Unknown
            };
            assert_eq!(report.eigenvalue_bound, expected);
            // The duality gap bounds the error in both cases.
            let product = |p: &[f64]| {
                let (operator, mut u) = (soft.operator(Component::ZZ).unwrap(), vec![0.0; cells]);
                operator.apply([p], [&mut u], &mut operator.scratch().unwrap());
                p.iter().zip(u).map(|(p, u)| p * u).sum::<f64>()
            };
            let difference: Vec<f64> = found
                .pressure()
                .as_slice()
                .iter()
                .zip(&exact)
                .map(|(a, b)| a - b)
                .collect();
            let squared = product(&difference) / product(found.pressure().as_slice());
            assert!(
                squared <= report.duality_gap + 1e-18,
                "{squared:e} {:e}",
                report.duality_gap
            );
        }
    }
}

fn solved(bodies: &HalfSpace) -> NormalSolution {
    let load = NormalLoad::Force(0.05);
    press(bodies, &gap(bodies), load, 1e-8)
}

/// The errors name the requirement before any work is done.
#[test]
fn problems_requiring_half_spaces_are_rejected() {
    let grid = kit::square(20, 3.0);
    let bodies = HalfSpace::new(grid, pair(false)).unwrap();
    let near = pair(false);
    let operators = || {
        Operators::new()
            .with([Z], of(&bodies, [Z], |_| 0.0))
            .with([X], of(&bodies, [X], |_| 0.0))
    };
    let kernel = Kernel::operators(near, operators()).unwrap();
    let other = HalfSpace::new(grid, &kernel).unwrap();
    kit::assert_refused! { DenseOperator::of_half_space(&other, Component::ZZ) => Error::UnsupportedForCoatings { .. } }
    let friction = kit::coulomb(0.3);
    let normal = solved(&other);
    // The operators allow tractions along x only.
    let [along, across] = [[0.01, 0.0], [0.0, 0.01]].map(|force| {
        let load = TangentialLoad::force(force);
        let problem = TangentialProblem::builder(&other, &normal, friction.clone(), load);
        problem.build().map(|problem| problem.solve().unwrap())
    });
    assert!(along.is_ok());
    assert!(matches!(across, Err(Error::IncompleteKernel(_))));
    let rolling = RollingProblem::builder(&other, &normal, friction.clone()).build();
    assert!(matches!(rolling, Err(Error::UnsupportedForCoatings { .. })));
    let ranks = Threads::run(2, Duration::from_secs(60), |rank| {
        HalfSpace::distributed(grid, &kernel, Boundary::NonPeriodic, Arc::new(rank)).map(|_| ())
    });
    for refused in ranks {
        kit::assert_refused! { refused => Error::UnsupportedForCoatings { .. } | Error::Ranks(_) }
    }
    let mut history = History::builder(&other, gap(&other), friction)
        .build()
        .unwrap();
    let press = || LoadStep::hold().normal(NormalLoad::Force(0.05));
    history.step(&press()).unwrap();
    kit::assert_refused! {
        history.step(&press().roll(Rolling::new(1))) => Error::UnsupportedForCoatings { .. },
        normal.edges() => Error::UnsupportedForCoatings { .. },
        HalfSpace::new(kit::square(21, 3.0), &kernel) => Error::Length { .. },
    }
    // The operators of a grid are rejected on a grid of other cells.
    let on_grid = Operators::on(grid).with([Z], of(&bodies, [Z], |_| 0.0));
    let kernel = Kernel::operators(near, on_grid).unwrap();
    assert!(HalfSpace::new(grid, &kernel).is_ok());
    kit::assert_refused! { HalfSpace::new(kit::square(20, 4.0), &kernel) => Error::GridMismatch { .. } }
}

/// An operator that is not a compliance of bodies is rejected when the kernel is created.
#[test]
fn operator_that_is_not_a_compliance_is_rejected() {
    let grid = kit::square(8, 1.0);
    let coupled = HalfSpace::new(grid, pair(true)).unwrap();
    let bodies = HalfSpace::new(grid, pair(false)).unwrap();
    let with = |operators| Kernel::operators(pair(false), operators).map(|_| ());
    let one = || of(&bodies, [Z], |_| 0.0);
    kit::assert_refused! { with(Operators::new()) => Error::IncompleteKernel(_) }
    let twice = Operators::new().with([X, X], of(&bodies, [X, Y], |_| 0.0));
    assert!(matches!(with(twice), Err(Error::RepeatedDirection)));
    let negative = Operators::new().with([Z], of(&bodies, [Z], |_| -2.0));
    assert!(matches!(with(negative), Err(Error::NotPositive { .. })));
    let infinite = Operators::new().with(
        [Z],
        of(&bodies, [Z], |i| if i == 5 { f64::NAN } else { 0.0 }),
    );
    kit::assert_refused! { with(infinite) => Error::NotPositive { .. } | Error::NotFinite { .. } }
    let adding = Operators::new().with([Z], AccumulatingOperator(one()));
    let found = with(adding);
    assert!(
        matches!(found, Err(Error::UnsupportedByModel { value, .. }) if (value - 1.0).abs() < 1e-12)
    );
    // One cell is displaced by twice the displacement that Betti's reciprocity allows.
    let skew = asymmetric(one(), |_, out| out[0] *= 2.0, 0.0);
    let skew = Operators::new().with([Z], skew);
    assert!(matches!(with(skew), Err(Error::UnsupportedByModel { value, .. }) if value > 1e-3));
    let directions = |axes: [Direction; 2]| {
        let operators = Operators::new().with([axes[0]], of(&bodies, [X], |_| 0.0));
        let operators = operators.with([axes[1]], of(&bodies, [X], |_| 0.1));
        *Kernel::operators(pair(false), operators).unwrap().pair()
    };
    // Exchanging the axes of the operators gives different bodies.
    assert!(directions([X, Y]) != directions([Y, X]));
    let all = Operators::new().with([X, Y, Z], of(&coupled, [X, Y, Z], |_| 0.0));
    assert!(matches!(with(all), Err(Error::UnsupportedByModel { .. })));
    let boast = Operators::new().with([Z], asymmetric(one(), |_, _| (), 1e3));
    assert!(matches!(with(boast), Err(Error::BelowMinimum { .. })));
    let sizes = Operators::new().with([Z], one()).with(
        [X],
        of(
            &HalfSpace::new(kit::square(9, 1.0), pair(false)).unwrap(),
            [X],
            |_| 0.0,
        ),
    );
    assert!(matches!(with(sizes), Err(Error::Length { .. })));
}

/// A product that fails after the initial check ends the solve with the status `Stalled`.
#[test]
fn operator_failing_later_stalls_solve() {
    let bodies = HalfSpace::new(kit::square(12, 2.0), pair(false)).unwrap();
    // The probes of the initial check have tractions of both signs.
    let fail = |x: &[f64], out: &mut [f64]| {
        if x.iter().all(|x| *x >= 0.0) {
            out[3] = f64::NAN;
        }
    };
    let late = asymmetric(of(&bodies, [Z], |_| 0.0), fail, 0.0);
    let late = with_operators(&bodies, Operators::new().with([Z], late));
    let outcome = NormalProblem::builder(&late, gap(&late), NormalLoad::Force(0.05))
        .build()
        .unwrap()
        .solve();
    match outcome {
        Err(Error::NotConverged(report)) => assert_eq!(report.status, Status::Stalled),
        other => panic!("{other:?}"),
    }
}

/// Operators without an eigenvalue bound allow only problems that need no bound. These are the pressure problem
/// followed by the traction problem, also with entering cells in a history.
#[test]
fn operator_without_bound_solves_problems_that_need_none() {
    let grid = kit::square(24, 3.0);
    let friction = || kit::coulomb(0.4);
    let without = |coupled: bool| {
        let bodies = HalfSpace::new(grid, pair(coupled)).unwrap();
        let mut all = of(&bodies, [X, Y, Z], |_| 0.0);
        all.is_bounded = false;
        let unbounded = with_operators(&bodies, Operators::new().with([X, Y, Z], all));
        (bodies, unbounded)
    };
    let (bodies, unbounded) = without(false);
    let followed = |bodies: &HalfSpace| {
        let history = History::builder(bodies, gap(bodies), friction());
        let mut history = history.tolerance(1e-11).build().unwrap();
        for (normal, force) in [(0.03, 0.004), (0.05, 0.01), (0.04, -0.006)] {
            let step = LoadStep::hold()
                .normal(NormalLoad::Force(normal))
                .tangential(Axis::X, TangentialControl::Force(force));
            history.step(&step).unwrap();
        }
        history
    };
    let (expected, found) = (followed(&bodies), followed(&unbounded));
    close(found.pressure(), expected.pressure(), 1e-7);
    close(found.traction()[0], expected.traction()[0], 1e-7);
    let known = found.normal().report().eigenvalue_bound;
    assert_eq!(known, EigenvalueBound::Unknown);

    let is_unbounded = |error: Error| matches!(error, Error::NotPositive { quantity, value: 0.0 } if quantity.contains("lower bound"));
    assert!(is_unbounded(found.stiffness().unwrap_err()));
    let slip = Field::constant(grid, 1.0);
    let cycles = wear::max_stable_cycles(&unbounded, 1.0, &slip);
    assert!(is_unbounded(cycles.unwrap_err()));

    let (_, unbounded) = without(true);
    let (load, still) = (NormalLoad::Force(0.05), TangentialLoad::force([0.006, 0.0]));
    let refused = CoupledProblem::builder(&unbounded, gap(&unbounded), friction(), load, still);
    assert!(is_unbounded(refused.build().unwrap_err()));
    let refused = History::builder(&unbounded, gap(&unbounded), friction()).build();
    assert!(is_unbounded(refused.unwrap_err()));
}

/// Compares user operators with built-in bodies: the traction under one-way coupling, and the stiffness computed in
/// buffers previously used by other bodies.
#[test]
fn user_operator_one_way_coupling_matches_bodies() {
    let bodies = HalfSpace::new(kit::square(kit::thorough(18, 28), 3.0), pair(true)).unwrap();
    let mut workspace = StiffnessWorkspace::new();
    let mut solved = |bodies: &HalfSpace| {
        let history = History::builder(bodies, gap(bodies), kit::coulomb(0.4));
        let history = history.coupling(Coupling::OneWay).tolerance(1e-12);
        let mut history = history.model(TangentialModel::Vector).build().unwrap();
        for force in [0.0, 0.01] {
            let step = LoadStep::hold().normal(NormalLoad::Force(0.05));
            let step = step.tangential(Axis::X, TangentialControl::Force(force));
            history.step(&step).unwrap();
        }
        let keep_on = |_: &stickslip::Iteration| std::ops::ControlFlow::Continue(());
        let stiffness = history.stiffness_with(&mut workspace, keep_on).unwrap();
        let [x, y] = history.traction();
        ([x.clone(), y.clone()], stiffness)
    };
    let ([x, y], expected) = solved(&bodies);
    let same = with_joint_operator(&bodies);
    let ([other_x, other_y], found) = solved(&same);
    let unit = x.max().max(y.max());
    for (found, expected) in [(other_x, x), (other_y, y)] {
        assert!(max_difference(found.as_slice(), expected.as_slice()) < 1e-8 * unit);
    }
    let [own, other] = [&expected, &found].map(|of| of.tangential.loading[0][0].unwrap());
    assert!((other / own - 1.0).abs() < 1e-7);

    // Operators with the same tractions but a different displacement due to pressure.
    let plane = Operators::new().with([Z, X, Y], of(&bodies, [Z, X, Y], |_| 0.0));
    let soft = Operators::new().with([Z, X, Y], of(&bodies, [Z, X, Y], |_| 0.05));
    let again = solved(&with_operators(&bodies, plane)).1;
    let softer = solved(&with_operators(&bodies, soft)).1;
    assert!((again.normal.value / found.normal.value - 1.0).abs() < 1e-7);
    assert!(softer.normal.value < 0.99 * found.normal.value);
}

/// On a periodic grid a uniform traction causes no displacement, so an operator with springs is rejected.
#[test]
fn operator_with_mean_is_rejected_on_periodic_grid() {
    let grid = kit::square(16, 3.0);
    let bodies = HalfSpace::with_boundary(grid, pair(false), Boundary::Periodic).unwrap();
    let on = |spring: f64, boundary: Boundary| {
        let operators = Operators::new().with([Z], of(&bodies, [Z], |_| spring));
        let kernel = Kernel::operators(pair(false), operators).unwrap();
        HalfSpace::with_boundary(grid, kernel, boundary)
    };
    assert!(on(0.0, Boundary::Periodic).is_ok() && on(0.3, Boundary::NonPeriodic).is_ok());
    kit::assert_refused! { on(0.3, Boundary::Periodic) => Error::UnsupportedByModel { value, .. } if value > 0.1 }
}

/// The report names the origin of a bound that the operator states and that the crate has not computed.
#[test]
fn bound_of_user_operator_is_stated() {
    let grid = Grid::square(16, 3.0).unwrap();
    let bodies = HalfSpace::new(grid, pair(false)).unwrap();
    let least = of(&bodies, [Z], |_| 0.0).lower_bound();
    let stated = asymmetric(of(&bodies, [Z], |_| 0.0), |_, _| {}, 0.5 * least);
    let stated = with_operators(&bodies, Operators::new().with([Z], stated));
    let press = |bodies: &HalfSpace| {
        let problem = NormalProblem::builder(bodies, gap(bodies), NormalLoad::Force(0.05));
        kit::solve(problem)
    };
    let (own, user) = (press(&bodies), press(&stated));
    assert_eq!(own.report().eigenvalue_bound, EigenvalueBound::Proven);
    assert_eq!(user.report().eigenvalue_bound, EigenvalueBound::Stated);
    let text = user.report().to_string();
    assert!(
        text.contains("by the stated bound of the smallest eigenvalue"),
        "{text}"
    );
    assert!(EigenvalueBound::Estimated < EigenvalueBound::Stated);
}
