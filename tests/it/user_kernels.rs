//! A closure or a table with the response of a coating gives the results of the built-in coating in every problem.
//! Invalid kernels are rejected.

use kit::{max_abs, max_difference, press, shear};
use stickslip::history::{Rolling, wear};
use stickslip::influence::Direction::{X, Y, Z};
use stickslip::influence::{Component, Table};
use stickslip::kernel::{CoefficientTable, ResponseTensor};
use stickslip::layers::{Layer, Response};
use stickslip::rolling::RollingProblem;
use stickslip::subsurface::{Body, Planes, Tractions, at_points};
use stickslip::{
    Axis, Boundary, CellValue, CoupledProblem, ElasticPair, Error, Field, Grid, HalfSpace, History,
    Kernel, LoadStep, Material, NormalLoad, Operator, TangentialControl, TangentialLoad,
    TangentialModel, analytical,
};

const THICKNESS: f64 = 0.4;

/// Returns a coated pair, and its outermost layer as a half-space.
fn coating(second: bool) -> [ElasticPair; 2] {
    let top = Material::new(4.0, 0.2).unwrap();
    let coated = Material::new(1.0, 0.3).unwrap();
    let coated = coated.coated(&[Layer::new(4.0, 0.2, THICKNESS).unwrap()]);
    let of = |body: Material| {
        let other = if second { body } else { Material::rigid() };
        ElasticPair::new(body, other).unwrap()
    };
    [of(coated.unwrap()), of(top)]
}

fn closure(second: bool) -> Kernel {
    let [coated, near] = coating(second);
    Kernel::isotropic(near, THICKNESS, move |k| coated.response(k).unwrap()).unwrap()
}

fn table(second: bool, grid: Grid, distances: [usize; 2]) -> Kernel {
    let [coated, near] = coating(second);
    let [nx, ny] = distances;
    let larger = Grid::new(nx, ny, grid.dx(), grid.dy()).unwrap();
    let mut table = CoefficientTable::new([grid.dx(), grid.dy()], distances).unwrap();
    for component in [
        Component::XX,
        Component::YY,
        Component::ZZ,
        Component::YX,
        Component::XZ,
        Component::ZY,
    ] {
        let sampled = Table::sample(larger, &coated, component).unwrap();
        let at = |n: usize| sampled.get((n % nx) as isize, (n / nx) as isize);
        let values = (0..nx * ny).map(|n| at(n).unwrap()).collect();
        table = table.with(component, values).unwrap();
    }
    Kernel::tabulated(near, table).unwrap()
}

fn size(grid: Grid) -> [usize; 2] {
    [grid.nx(), grid.ny()]
}

/// Returns bodies with the built-in coating, a closure of its response and a table of its coefficients, on a free grid.
fn coated_half_spaces(grid: Grid, second: bool) -> [HalfSpace; 3] {
    let [coated, _] = coating(second);
    [
        HalfSpace::new(grid, coated).unwrap(),
        HalfSpace::new(grid, closure(second)).unwrap(),
        HalfSpace::new(grid, table(second, grid, size(grid))).unwrap(),
    ]
}

fn product(bodies: &HalfSpace, component: Component, load: &[f64]) -> Vec<f64> {
    let operator = bodies.operator(component).unwrap();
    let mut u = vec![0.0; load.len()];
    operator.apply([load], [&mut u], &mut operator.scratch().unwrap());
    u
}

/// The tolerance is 1e-11 of the normal self-influence coefficient.
#[test]
fn user_kernel_coefficients_match_coating() {
    let line = Boundary::PeriodicAlongY { datum: 50.0 };
    for (nx, ny, dx, boundary) in [
        (24, 17, 0.15, Boundary::NonPeriodic),
        (9, 12, 2.0, Boundary::NonPeriodic),
        (16, 18, 0.15, Boundary::Periodic),
        (40, 1, 0.2, line),
    ] {
        for value in [CellValue::Uniform, CellValue::Centre] {
            let grid = Grid::new(nx, ny, dx, 0.2).unwrap();
            let [coated, _] = coating(false);
            let of = |kernel: Kernel| {
                let bodies = HalfSpace::with_boundary(grid, kernel, boundary).unwrap();
                bodies.with_cell_value(value).unwrap()
            };
            let mut others = vec![of(closure(false))];
            if boundary == Boundary::NonPeriodic {
                others.push(of(table(false, grid, [nx + 3, ny + 3])));
            }
            let built_in = of(coated.into());
            let mut load = vec![0.0; nx * ny];
            load[0] = 1.0;
            let own = max_abs(&product(&built_in, Component::ZZ, &load));
            for component in Component::ALL {
                let expected = product(&built_in, component, &load);
                for other in &others {
                    let found = product(other, component, &load);
                    let error = max_difference(&found, &expected) / own;
                    assert!(
                        error < 1e-11,
                        "{component:?} {boundary:?} {value:?}: {error:e}"
                    );
                }
            }
        }
    }
}

/// Solves pressure, tangential traction, the coupled problem and a history with load reversal. The solves use starts from
/// coarser cells, windows and rolling active sets. Their tolerances are far below the tolerance of the comparison.
#[test]
fn user_kernel_solves_match_coating() {
    let grid = kit::square(72, 7.2);
    let load = NormalLoad::Force(0.6);
    let friction = kit::coulomb(0.4);
    let close = |found: &Field, expected: &Field| {
        let error = max_difference(found.as_slice(), expected.as_slice());
        assert!(error < 1e-10 * max_abs(expected.as_slice()), "{error:e}");
    };
    // Both bodies are equal, so pressure and shear are uncoupled.
    let solved = coated_half_spaces(grid, true).map(|bodies| {
        let gap = kit::sphere(grid, 4.0);
        let normal = press(&bodies, &gap, load, 1e-13);
        let sheared = TangentialLoad::force([0.1, 0.05]);
        let problem =
            stickslip::TangentialProblem::builder(&bodies, &normal, friction.clone(), sheared)
                .model(TangentialModel::Vector)
                .tolerance(1e-13);
        let sheared = kit::solve(problem);
        let mut history = History::builder(&bodies, &gap, friction.clone())
            .tolerance(1e-13)
            .build()
            .unwrap();
        for (normal, force) in [(0.6, 0.0), (0.6, 0.12), (0.7, -0.05)] {
            let step = LoadStep::hold()
                .normal(NormalLoad::Force(normal))
                .tangential(Axis::X, TangentialControl::Force(force));
            history.step(&step).unwrap();
        }
        (normal, sheared, history.state().traction()[0].clone())
    });
    let [(normal, sheared, traction), others @ ..] = &solved;
    for (other_normal, other_sheared, other_traction) in others {
        close(other_normal.pressure(), normal.pressure());
        assert!((other_normal.approach() / normal.approach() - 1.0).abs() < 1e-10);
        close(other_sheared.traction()[0], sheared.traction()[0]);
        close(other_sheared.traction()[1], sheared.traction()[1]);
        close(other_traction, traction);
    }

    let grid = kit::square(40, 6.0);
    let solved = coated_half_spaces(grid, false).map(|bodies| {
        assert!(bodies.pair().is_coupled());
        let still = TangentialLoad::force([0.05, 0.0]);
        let problem = CoupledProblem::builder(
            &bodies,
            kit::sphere(grid, 4.0),
            friction.clone(),
            load,
            still,
        );
        kit::solve(problem.tolerance(1e-12))
    });
    let [expected, others @ ..] = &solved;
    for other in others {
        let scale = max_abs(expected.normal().pressure().as_slice());
        let near = |a: &Field, b: &Field| {
            let error = max_difference(a.as_slice(), b.as_slice());
            assert!(error < 1e-10 * scale, "{error:e}");
        };
        near(other.normal().pressure(), expected.normal().pressure());
        let traction = |of: &stickslip::CoupledSolution| of.tangential().traction()[0].clone();
        near(&traction(other), &traction(expected));
    }
}

/// Checks stiffness, steady rolling, a history with rolling and wear, and lines of cells.
#[test]
fn user_kernel_stiffness_rolling_wear_and_lines_match_coating() {
    let grid = kit::square(36, 6.0);
    let friction = kit::coulomb(0.4);
    let solved = coated_half_spaces(grid, true).map(|bodies| {
        let mut gap = kit::sphere(grid, 4.0);
        let load = NormalLoad::Force(0.4);
        let normal = press(&bodies, &gap, load, 1e-13);
        let rolling = kit::solve(
            RollingProblem::builder(&bodies, &normal, friction.clone())
                .creepage([0.01, 0.005])
                .tolerance(1e-13),
        );
        let mut history = History::builder(&bodies, &gap, friction.clone())
            .model(TangentialModel::Vector)
            .tolerance(1e-13)
            .build()
            .unwrap();
        let held = || LoadStep::hold().normal(load);
        history.step(&held()).unwrap();
        let rolled = held().roll(Rolling::new(1).creepage([0.02, 0.01]));
        history.step(&rolled).unwrap();
        let slip = history.last_step().unwrap().slip_distance().clone();
        wear::archard(0.5, history.pressure(), &slip, &mut gap).unwrap();
        history.set_gap(&gap).unwrap();
        history.step(&held()).unwrap();
        let stiffness = history.stiffness().unwrap();
        let traction = history.traction().map(Clone::clone);
        let numbers = [
            normal.stiffness(&bodies).unwrap().value,
            stiffness.normal.value,
            stiffness.tangential.loading[0][0].unwrap(),
        ];
        (rolling, history.pressure().clone(), traction, numbers)
    });
    let [(rolling, pressure, traction, numbers), others @ ..] = &solved;
    for (other_rolling, other_pressure, other_traction, other_numbers) in others {
        // For a kernel, the entry rule uses the ratio of compliances of `near`. For the coating, it uses the ratio for
        // waves with a period of two cells.
        let close = |found: &Field, expected: &Field| {
            let error = max_difference(found.as_slice(), expected.as_slice());
            assert!(error < 2e-5 * max_abs(expected.as_slice()), "{error:e}");
        };
        for axis in [0, 1] {
            close(other_rolling.traction()[axis], rolling.traction()[axis]);
            close(&other_traction[axis], &traction[axis]);
        }
        close(other_pressure, pressure);
        for (found, expected) in other_numbers.iter().zip(numbers) {
            assert!((found / expected - 1.0).abs() < 1e-8);
        }
    }

    // Compares cylinders on a periodic row of cells.
    let grid = Grid::new(80, 1, 0.08, 1.0).unwrap();
    let boundary = Boundary::PeriodicAlongY { datum: 40.0 };
    let [coated, _] = coating(true);
    let [own, other] = [coated.into(), closure(true)].map(|bodies: Kernel| {
        let bodies = HalfSpace::with_boundary(grid, bodies, boundary).unwrap();
        let gap = Field::from_fn(grid, |x, _| 0.1 * x * x);
        let load = NormalLoad::Force(0.2);
        let normal = press(&bodies, &gap, load, 1e-13);
        let along = TangentialLoad::force([0.05, 0.0]);
        let traction = shear(&bodies, &normal, &friction, along, 1e-13);
        (normal, traction)
    });
    let difference = |found: &Field, expected: &Field| {
        max_difference(found.as_slice(), expected.as_slice()) / expected.max()
    };
    assert!(difference(other.0.pressure(), own.0.pressure()) < 1e-9);
    assert!(difference(other.1.traction()[0], own.1.traction()[0]) < 1e-9);
}

/// States of histories store the kernel, also in files and across processes. A history with a different kernel cannot
/// be continued from these states.
#[test]
fn history_continues_only_with_same_kernel() {
    let grid = kit::square(24, 6.0);
    let bodies = HalfSpace::new(grid, closure(true)).unwrap();
    let mut history = History::builder(&bodies, kit::sphere(grid, 4.0), kit::coulomb(0.4))
        .build()
        .unwrap();
    let step = |force: f64| {
        LoadStep::hold()
            .normal(NormalLoad::Force(0.6))
            .tangential(Axis::X, TangentialControl::Force(force))
    };
    history.step(&step(0.1)).unwrap();
    let bytes = history.to_bytes();
    let [coated, near] = coating(true);
    let softer = move |k| {
        let Response { normal, .. } = coated.response(k).unwrap();
        let along = 1.0001 * normal;
        Response {
            normal,
            along,
            across: along,
            coupling: 0.0,
        }
    };
    let softer = Kernel::isotropic(near, THICKNESS, softer).unwrap();
    let softer = HalfSpace::with_boundary(grid, softer, Boundary::Periodic).unwrap();
    for other in [
        HalfSpace::new(grid, near).unwrap(),
        HalfSpace::new(grid, coated).unwrap(),
        HalfSpace::new(grid, table(true, grid, size(grid))).unwrap(),
    ] {
        kit::assert_refused! { History::from_bytes(&other, &bytes) => Error::MaterialMismatch { .. } }
    }
    assert!(softer.pair() != bodies.pair());
}

/// An isotropic response equals the same response given as orthotropic. Different axes follow a rotation of the grid.
#[test]
fn orthotropic_response_follows_axes() {
    let [coated, near] = coating(false);
    let tensor = move |[x, y]: [f64; 2], soft: f64| {
        let k = x.hypot(y);
        let of = coated.response(k).unwrap();
        let (c, s) = (x / k, y / k);
        ResponseTensor {
            xx: soft * (of.along * c * c + of.across * s * s),
            yy: of.along * s * s + of.across * c * c,
            zz: of.normal,
            xy: (of.along - of.across) * c * s,
            zx: -of.coupling * c,
            zy: -of.coupling * s,
        }
    };
    let grid = Grid::new(20, 24, 0.15, 0.2).unwrap();
    let on = |kernel: Kernel| HalfSpace::with_boundary(grid, kernel, Boundary::Periodic).unwrap();
    let same = on(Kernel::orthotropic(near, 1.0, move |k| tensor(k, 1.0)).unwrap());
    let built_in = on(coated.into());
    let mut load = vec![0.0; grid.cells()];
    load[0] = 1.0;
    for component in Component::ALL {
        let [found, expected] = [&same, &built_in].map(|bodies| product(bodies, component, &load));
        assert!(max_difference(&found, &expected) < 1e-13);
    }
    let softer = on(Kernel::orthotropic(near, 1.0, move |k| tensor(k, 1.5)).unwrap());
    let gap = kit::sphere(grid, 4.0);
    let shift = |bodies: &HalfSpace, force: [f64; 2]| {
        let normal = press(bodies, &gap, NormalLoad::Force(0.2), 1e-8);
        let load = TangentialLoad::force(force);
        shear(bodies, &normal, &kit::coulomb(1.0), load, 1e-8).shift()
    };
    assert!(shift(&softer, [0.05, 0.0])[0] > 1.2 * shift(&same, [0.05, 0.0])[0]);
}

/// An operator that is indefinite on a grid is detected by its eigenvalue bound.
#[test]
fn kernel_without_eigenvalue_bound_is_rejected() {
    let [_, near] = coating(false);
    let grid = kit::square(16, 4.0);
    let mut values = vec![0.0; 16 * 16];
    (values[0], values[1], values[16]) = (1.0, 0.6, 0.6);
    let sides = [grid.dx(), grid.dy()];
    let table = CoefficientTable::new(sides, [16; 2]).unwrap();
    let table = table.with(Component::ZZ, values).unwrap();
    let bodies = HalfSpace::new(grid, Kernel::tabulated(near, table).unwrap()).unwrap();
    let refused = bodies.tensor_preconditioner([Z]).unwrap_err();
    assert!(matches!(refused, Error::NotDefinite { eigenvalue, .. } if eigenvalue < 0.0));
    // The table has no coefficients of tractions.
    let missing = bodies.tensor_operator([X, Y]).unwrap_err();
    assert!(matches!(missing, Error::IncompleteKernel(_)));
}

/// Failures are also detected in the long-wave limit, and at waves between the waves sampled by the first check. The
/// sum over all waves for a free grid includes these waves.
#[test]
fn response_failing_after_first_check_is_rejected() {
    let [coated, near] = coating(false);
    let hole = move |k: f64| {
        let found = coated.response(k).unwrap();
        let along = if (1.05..1.35).contains(&(0.4 * k)) {
            f64::NAN
        } else {
            found.along
        };
        Response { along, ..found }
    };
    let bodies = HalfSpace::new(
        kit::square(16, 3.0),
        Kernel::isotropic(near, 0.4, hole).unwrap(),
    )
    .unwrap();
    kit::assert_refused! { bodies.operator(Component::XX) => Error::Sample { .. } }

    let kernel = Kernel::isotropic(near, 0.4, move |k| coated.response(k).unwrap()).unwrap();
    let softer = Response {
        normal: 9.0,
        along: 1.0,
        across: 1.0,
        coupling: 0.0,
    };
    kit::assert_refused! { kernel.with_long_wave_limit(softer) => Error::BelowMinimum { .. } }
}

#[test]
fn invalid_kernels_are_rejected() {
    let [coated, near] = coating(false);
    let response = move |k| coated.response(k).unwrap();
    let grid = kit::square(16, 4.0);

    // A near field that is not a half-space is rejected, and so is a response that does not tend to the near field.
    kit::assert_refused! {
        Kernel::isotropic(coated, 0.4, response) => Error::UnsupportedForCoatings { .. },
        Kernel::isotropic(near, 0.0, response) => Error::NotPositive { value: 0.0, .. },
    }
    let astray = Kernel::isotropic(kit::on_rigid(3.9, 0.2), 0.4, response).unwrap();
    kit::assert_refused! { HalfSpace::new(grid, &astray) => Error::BelowMinimum { .. } }
    assert!(HalfSpace::with_boundary(grid, &astray, Boundary::Periodic).is_ok());
    // A thickness greater than the thickness of the layer is rejected for the same reason.
    let thick = Kernel::isotropic(near, 0.9, response).unwrap();
    kit::assert_refused! { HalfSpace::new(grid, &thick) => Error::BelowMinimum { .. } }

    // Responses that are indefinite, NaN or infinite are rejected.
    let with = |change: fn(&mut Response, f64)| {
        Kernel::isotropic(near, 0.4, move |k| {
            let mut of = response(k);
            change(&mut of, k);
            of
        })
    };
    kit::assert_refused! {
        with(|of, _| of.normal = -1.0) => Error::NotPositive { value: -1.0, .. },
        with(|of, _| of.along = f64::NAN) => Error::NotPositive { .. },
        with(|of, _| of.coupling = 2.0 * of.normal) => Error::NotPositive { .. },
        with(|of, _| of.coupling = f64::INFINITY) => Error::NotFinite { .. },
    }
    // The wave number is beyond the first check, but among the waves of this grid.
    let late = with(|of, k| {
        if k > 200.0 {
            of.normal = f64::NAN;
        }
    })
    .unwrap();
    kit::assert_refused! { HalfSpace::with_boundary(kit::square(16, 0.1), &late, Boundary::Periodic) => Error::NotPositive { .. } }

    // Axes that are not aligned with the grid, and free grids, are rejected.
    let oblique = |[x, y]: [f64; 2]| {
        let c = 1.0 / (x * x + x * y + y * y).sqrt();
        ResponseTensor {
            xx: c,
            yy: c,
            zz: c,
            xy: 0.0,
            zx: 0.0,
            zy: 0.0,
        }
    };
    kit::assert_refused! { Kernel::orthotropic(near, 1.0, oblique) => Error::BelowMinimum { .. } }
    let straight = |[x, y]: [f64; 2]| {
        let c = 1.0 / x.hypot(y);
        ResponseTensor {
            xx: c,
            yy: c,
            zz: c,
            xy: 0.0,
            zx: 0.0,
            zy: 0.0,
        }
    };
    let straight = Kernel::orthotropic(near, 1.0, straight).unwrap();
    kit::assert_refused! { HalfSpace::new(grid, &straight) => Error::UnsupportedForCoatings { .. } }
}

#[test]
fn invalid_tables_are_rejected() {
    let [_, near] = coating(false);
    let grid = kit::square(16, 4.0);
    let tabulated = table(false, grid, size(grid));
    for other in [kit::square(17, 4.25), kit::square(16, 4.1)] {
        kit::assert_refused! { HalfSpace::new(other, &tabulated) => Error::GridMismatch { .. } }
    }
    let refused = HalfSpace::with_boundary(grid, &tabulated, Boundary::Periodic);
    assert!(matches!(refused, Err(Error::UnsupportedForCoatings { .. })));
    let empty = || CoefficientTable::new([1.0; 2], [2, 1]).unwrap();
    let not_odd = empty().with(Component::ZX, vec![1.0, 0.0]).unwrap();
    kit::assert_refused! {
        Kernel::tabulated(near, not_odd) => Error::Sample { index: 0, value: 1.0, .. },
        empty().with(Component::ZZ, vec![1.0]) => Error::Length { .. },
        CoefficientTable::new([1.0; 2], [0, 1]) => Error::Length { .. },
        CoefficientTable::new([1.0, -1.0], [1, 1]) => Error::NotPositive { value: -1.0, .. },
    }
}

/// The pair of a kernel does not define bodies. Functions that require a single modulus reject it.
#[test]
fn pair_of_kernel_is_rejected_without_kernel() {
    let kernel = closure(false);
    let pair = *kernel.pair();
    let grid = kit::square(16, 4.0);
    kit::assert_refused! {
        HalfSpace::new(grid, pair) => Error::IncompleteKernel(_),
        pair.response(1.0) => Error::IncompleteKernel(_),
        Table::sample(grid, &pair, Component::ZZ) => Error::IncompleteKernel(_),
        analytical::HertzSphere::new(&pair, 1.0, 1.0) => Error::UnsupportedForCoatings { .. },
    }
    let bodies = HalfSpace::new(grid, &kernel).unwrap();
    let pressure = Field::constant(grid, 0.1);
    let tractions = Tractions::new(&pressure);
    let asked = at_points(&bodies, Body::One, tractions, &[[0.0, 0.0, 0.1]]);
    assert!(matches!(asked, Err(Error::UnsupportedForCoatings { .. })));
    let asked = Planes::new(&bodies, &[0.1]);
    assert!(matches!(asked, Err(Error::UnsupportedForCoatings { .. })));
    let gap = kit::sphere(grid, 5.0);
    let contact = press(&bodies, &gap, NormalLoad::Force(0.3), 1e-6);
    kit::assert_refused! { contact.edges() => Error::UnsupportedForCoatings { .. } }
}
