//! Every error is a value that names what was wrong, before any work; nothing panics.

#![cfg(feature = "dense")]
#![allow(
    clippy::unwrap_used,
    clippy::float_cmp,
    clippy::cast_possible_truncation,
    clippy::cast_possible_wrap,
    reason = "a test fails loudly, compares exact results, and counts small things"
)]

mod common;

use common::unit_bodies;
use stickslip::cgm::{self, Interval, Magnitude, NonNegative, Problem, Settings};
use stickslip::dense::DenseOperator;
use stickslip::influence::{Component, Rectangle};
use stickslip::tangential::JaegerSuperposition;
use stickslip::{
    ElasticPair, Error, Field, Friction, Grid, HalfSpace, Identity, Material, NormalLoad,
    NormalProblem, NormalSolution, TangentialLoad, TangentialProblem, surface,
};

const NOT_POSITIVE: [f64; 5] = [0.0, -1.0, f64::NAN, f64::INFINITY, f64::NEG_INFINITY];
const NEGATIVE: [f64; 4] = [-1e-300, f64::NAN, f64::INFINITY, f64::NEG_INFINITY];
const NOT_FINITE: [f64; 3] = [f64::NAN, f64::INFINITY, f64::NEG_INFINITY];

/// The same number, NaN included.
fn same(a: f64, b: f64) -> bool {
    a.to_bits() == b.to_bits()
}

fn bodies() -> HalfSpace {
    unit_bodies(Grid::new(8, 6, 1.0, 1.0).unwrap(), 0.3)
}

fn ball(bodies: &HalfSpace) -> Field {
    surface::sphere(bodies.grid(), 20.0).unwrap()
}

fn pressed(bodies: &HalfSpace) -> NormalSolution {
    NormalProblem::builder(bodies, &ball(bodies), NormalLoad::Force(1.0))
        .build()
        .unwrap()
        .solve()
        .unwrap()
}

#[test]
fn grids() {
    for (nx, ny) in [(0, 5), (5, 0), (usize::MAX, 2), (1 << 40, 1 << 30)] {
        assert_eq!(Grid::new(nx, ny, 1.0, 1.0), Err(Error::GridSize { nx, ny }));
    }
    for value in NOT_POSITIVE {
        for grid in [
            Grid::new(2, 2, value, 1.0),
            Grid::new(2, 2, 1.0, value),
            Grid::square(2, value),
        ] {
            assert!(matches!(grid, Err(Error::NotPositive { value: v, .. }) if same(v, value)));
        }
        assert!(
            matches!(Rectangle::new(value, 1.0), Err(Error::NotPositive { value: v, .. }) if same(v, value))
        );
    }
    assert_eq!(Grid::square(0, 1.0), Err(Error::GridSize { nx: 0, ny: 0 }));
    assert!(
        matches!(
            Grid::new(2, 2, 1e-200, 1e-200),
            Err(Error::NotPositive { .. })
        ),
        "the cell area underflows"
    );
    assert!(matches!(
        Rectangle::new(1e-300, 1e300),
        Err(Error::NotPositive { .. })
    ));
    let slender = Grid::new(2, 2, 1e-200, 1e200).unwrap();
    let pair = ElasticPair::new(Material::new(1.0, 0.3).unwrap(), Material::rigid()).unwrap();
    assert!(matches!(
        HalfSpace::new(slender, pair),
        Err(Error::NotPositive { .. })
    ));
    let grid = Grid::new(3, 2, 1.0, 1.0).unwrap();
    let short = Field::from_vec(grid, vec![0.0; 5]);
    assert_eq!(
        short,
        Err(Error::Length {
            quantity: "field",
            expected: 6,
            found: 5
        })
    );
}

#[test]
fn materials() {
    for value in NOT_POSITIVE {
        for material in [
            Material::new(value, 0.3),
            Material::from_shear_modulus(value, 0.3),
        ] {
            assert!(matches!(material, Err(Error::NotPositive { value: v, .. }) if same(v, value)));
        }
    }
    assert!(
        Material::new(1e-320, 0.3).is_err(),
        "its compliance overflows"
    );
    for nu in [-1.0, 0.500001, -2.0, 0.9, f64::NAN, f64::INFINITY] {
        assert!(matches!(Material::new(1.0, nu), Err(Error::PoissonRatio(v)) if same(v, nu)));
    }
    assert_eq!(
        ElasticPair::new(Material::rigid(), Material::rigid()),
        Err(Error::BothRigid)
    );
    for radius in NOT_POSITIVE {
        let sphere = surface::sphere(bodies().grid(), radius);
        assert!(matches!(sphere, Err(Error::NotPositive { value: v, .. }) if same(v, radius)));
    }
}

#[test]
fn normal_problems() {
    let bodies = bodies();
    let gap = ball(&bodies);
    let build = |gap: &Field, load| NormalProblem::builder(&bodies, gap, load).build();
    for value in NEGATIVE {
        let error = build(&gap, NormalLoad::Force(value)).err();
        assert!(matches!(error, Some(Error::Negative { value: v, .. }) if same(v, value)));
    }
    for value in NOT_FINITE {
        let error = build(&gap, NormalLoad::Approach(value)).err();
        assert!(matches!(error, Some(Error::NotFinite { value: v, .. }) if same(v, value)));
        let mut broken = gap.clone();
        broken.as_mut_slice()[7] = value;
        let error = build(&broken, NormalLoad::Force(1.0)).err();
        assert!(matches!(error, Some(Error::Sample { index: 7, value: v, .. }) if same(v, value)));
    }
    let other = Field::zeros(Grid::new(6, 8, 1.0, 1.0).unwrap());
    assert_eq!(
        build(&other, NormalLoad::Force(1.0)).err(),
        Some(Error::GridMismatch { quantity: "gap" })
    );
    for tolerance in [0.0, 1.0, -1e-6, f64::NAN] {
        let error = NormalProblem::builder(&bodies, &gap, NormalLoad::Force(1.0))
            .tolerance(tolerance)
            .build()
            .err();
        assert!(matches!(error, Some(Error::Tolerance(t)) if same(t, tolerance)));
    }
    let error = NormalProblem::builder(&bodies, &gap, NormalLoad::Force(1.0))
        .max_iterations(0)
        .build()
        .err();
    assert_eq!(error, Some(Error::IterationLimit));
}

#[test]
fn a_refused_change_leaves_the_solver_as_it_was() {
    let bodies = bodies();
    let gap = ball(&bodies);
    let problem = NormalProblem::builder(&bodies, &gap, NormalLoad::Force(1.0))
        .build()
        .unwrap();
    let expected = problem.solve().unwrap();
    let mut solver = problem.into_solver().unwrap();
    assert!(solver.set_load(NormalLoad::Force(-1.0)).is_err());
    assert!(
        solver
            .set_gap(&Field::constant(bodies.grid(), f64::NAN))
            .is_err()
    );
    let other = Grid::new(6, 8, 1.0, 1.0).unwrap();
    assert!(solver.set_gap(&Field::zeros(other)).is_err());
    let mut foreign = NormalProblem::builder(
        &unit_bodies(other, 0.3),
        &Field::zeros(other),
        NormalLoad::Force(1.0),
    )
    .build()
    .unwrap()
    .solve()
    .unwrap();
    let before = foreign.clone();
    assert_eq!(
        solver.solve_into(&mut foreign),
        Err(Error::GridMismatch {
            quantity: "solution"
        })
    );
    assert_eq!(foreign, before);
    let mut solution = solver.new_solution();
    solver.solve_into(&mut solution).unwrap();
    assert_eq!(solution.pressure(), expected.pressure());

    let load = TangentialLoad::Force([0.1, 0.0]);
    let friction = Friction::coulomb(0.5).unwrap();
    let problem = TangentialProblem::builder(&bodies, &expected, friction, load)
        .build()
        .unwrap();
    let expected = problem.solve().unwrap();
    let mut solver = problem.into_solver().unwrap();
    assert!(solver.set_load(TangentialLoad::Force([0.6, 0.0])).is_err());
    assert!(solver.set_load(TangentialLoad::Shift([1.0, 1.0])).is_err());
    let slippery = Friction::coulomb(0.05).unwrap();
    assert!(matches!(
        solver.set_friction(&slippery),
        Err(Error::BeyondSliding { .. })
    ));
    let foreign = Friction::per_cell(Field::zeros(other)).unwrap();
    assert!(matches!(
        solver.set_friction(&foreign),
        Err(Error::GridMismatch { .. })
    ));
    let mut solution = solver.new_solution();
    solver.solve_into(&mut solution).unwrap();
    assert_eq!(solution.traction(), expected.traction());
}

#[test]
fn friction() {
    let bodies = bodies();
    for value in NEGATIVE {
        assert!(
            matches!(Friction::coulomb(value), Err(Error::Negative { value: v, .. }) if same(v, value))
        );
        let mut field = Field::constant(bodies.grid(), 0.5);
        field.as_mut_slice()[3] = value;
        let error = Friction::per_cell(field).err();
        assert!(matches!(error, Some(Error::Sample { index: 3, value: v, .. }) if same(v, value)));
    }
    let friction = Friction::coulomb(0.5).unwrap();
    for value in NOT_POSITIVE {
        let error = friction.clone().shear_cap(value).err();
        assert!(matches!(error, Some(Error::NotPositive { value: v, .. }) if same(v, value)));
    }
}

#[test]
fn tangential_loads() {
    let bodies = bodies();
    let normal = pressed(&bodies);
    let friction = Friction::coulomb(0.5).unwrap();
    let build = |load| {
        TangentialProblem::builder(&bodies, &normal, friction.clone(), load)
            .build()
            .err()
    };
    for value in NOT_FINITE {
        for load in [
            TangentialLoad::Force([value, 0.0]),
            TangentialLoad::Shift([0.0, value]),
        ] {
            assert!(
                matches!(build(load), Some(Error::NotFinite { value: v, .. }) if same(v, value))
            );
        }
    }
    assert_eq!(
        build(TangentialLoad::Force([0.1, 0.2])),
        Some(Error::ObliqueLoad { x: 0.1, y: 0.2 })
    );
    let Some(Error::BeyondSliding { force, limit }) = build(TangentialLoad::Force([0.0, -0.51]))
    else {
        panic!("more than friction holds");
    };
    assert!(same(force, 0.51) && (limit - 0.5).abs() < 1e-12);
    let error = TangentialProblem::builder(
        &bodies,
        &normal,
        friction.clone(),
        TangentialLoad::Force([0.1, 0.0]),
    )
    .tolerance(2.0)
    .build()
    .err();
    assert_eq!(error, Some(Error::Tolerance(2.0)));
}

#[test]
fn what_a_tangential_problem_stands_on() {
    let bodies = bodies();
    let normal = pressed(&bodies);
    let friction = Friction::coulomb(0.5).unwrap();
    let other = unit_bodies(Grid::new(8, 6, 1.0, 1.1).unwrap(), 0.3);
    let error = TangentialProblem::builder(
        &other,
        &normal,
        friction.clone(),
        TangentialLoad::Force([0.1, 0.0]),
    )
    .build()
    .err();
    assert_eq!(
        error,
        Some(Error::GridMismatch {
            quantity: "normal solution"
        })
    );

    let apart = NormalProblem::builder(&bodies, &ball(&bodies), NormalLoad::Force(0.0))
        .build()
        .unwrap()
        .solve()
        .unwrap();
    let error = TangentialProblem::builder(
        &bodies,
        &apart,
        friction.clone(),
        TangentialLoad::Force([0.0, 0.0]),
    )
    .build()
    .err();
    assert_eq!(error, Some(Error::EmptyContact));
    assert_eq!(
        JaegerSuperposition::new(&apart, &apart, bodies.pair(), 0.5).err(),
        Some(Error::EmptyContact)
    );
    assert!(matches!(
        JaegerSuperposition::new(&normal, &apart, bodies.pair(), -0.5),
        Err(Error::Negative { .. })
    ));

    // Steel on rubber: pressure causes shear displacement, which the model does not see.
    let pair = ElasticPair::new(
        Material::new(200.0, 0.3).unwrap(),
        Material::new(1.0, 0.3).unwrap(),
    )
    .unwrap();
    let coupled = HalfSpace::new(bodies.grid(), pair).unwrap();
    let normal = pressed(&coupled);
    let builder = || {
        TangentialProblem::builder(
            &coupled,
            &normal,
            friction.clone(),
            TangentialLoad::Force([0.1, 0.0]),
        )
    };
    let Some(Error::CoupledMaterials { beta }) = builder().build().err() else {
        panic!("coupled materials");
    };
    assert!((beta - pair.dundurs_beta()).abs() < 1e-15 && beta.abs() > 0.2);
    assert!(
        builder()
            .neglect_coupling()
            .build()
            .unwrap()
            .solve()
            .is_ok()
    );
}

#[test]
fn engine() {
    let solve = |linear: &[f64], x: &mut [f64]| {
        cgm::minimise(
            &Problem::new(Identity::new(2), linear, NonNegative),
            &Settings::default(),
            x,
        )
        .err()
    };
    let mut x = [1.0, 2.0];
    assert!(matches!(
        solve(&[0.0], &mut x),
        Some(Error::Length {
            expected: 2,
            found: 1,
            ..
        })
    ));
    assert!(matches!(
        solve(&[0.0, f64::NAN], &mut x),
        Some(Error::Sample { index: 1, .. })
    ));
    assert!(matches!(
        solve(&[0.0; 2], &mut [f64::NAN, 0.0]),
        Some(Error::Sample { index: 0, .. })
    ));
    assert!(matches!(
        solve(&[0.0; 2], &mut [0.0; 3]),
        Some(Error::Length {
            expected: 2,
            found: 3,
            ..
        })
    ));

    let linear = [0.0; 2];
    let settings = Settings::default();
    for (lower, upper) in [
        ([0.0, 1.0], [1.0, 0.0]),
        ([0.0, f64::NAN], [1.0, 1.0]),
        ([0.0, f64::INFINITY], [1.0, f64::INFINITY]),
    ] {
        let interval = Interval {
            lower: &lower,
            upper: &upper,
        };
        let error = cgm::minimise(
            &Problem::new(Identity::new(2), &linear, interval),
            &settings,
            &mut x,
        )
        .err();
        assert!(matches!(error, Some(Error::Bounds { index: 1, .. })));
    }
    let uneven = Interval {
        lower: &[0.0],
        upper: &[1.0; 2],
    };
    let error = cgm::minimise(
        &Problem::new(Identity::new(2), &linear, uneven),
        &settings,
        &mut x,
    )
    .err();
    assert!(matches!(error, Some(Error::Length { expected: 2, .. })));
    for total in [3.1, -3.1, f64::NAN, f64::INFINITY] {
        let problem = Problem::new(Identity::new(2), &linear, Magnitude(&[1.0, 2.0])).total(total);
        let error = cgm::minimise(&problem, &settings, &mut x).err();
        assert!(
            matches!(error, Some(Error::Total { total: t, lower: -3.0, upper: 3.0 }) if same(t, total))
        );
    }
    let problem =
        Problem::new(Identity::new(2), &linear, NonNegative).preconditioner(Identity::new(3));
    assert!(matches!(
        cgm::minimise(&problem, &settings, &mut x),
        Err(Error::Length { .. })
    ));
    assert_eq!(x, [1.0, 2.0], "refused before any work");
}

#[test]
fn matrices() {
    assert!(matches!(
        DenseOperator::from_rows(2, vec![0.0; 3]),
        Err(Error::Length { .. })
    ));
    assert!(matches!(
        DenseOperator::from_rows(1, vec![f64::NAN]),
        Err(Error::Sample { .. })
    ));
    let large = unit_bodies(Grid::new(65, 64, 1.0, 1.0).unwrap(), 0.3);
    let error = DenseOperator::of_half_space(&large, Component::ZZ).err();
    assert_eq!(
        error,
        Some(Error::TooManyCells {
            cells: 4160,
            limit: 4096
        })
    );
    let indefinite = DenseOperator::from_rows(2, vec![1.0, 2.0, 2.0, 1.0]).unwrap();
    let error = indefinite.minimise(&[-1.0, -1.0], &NonNegative, None).err();
    assert_eq!(error, Some(Error::NotPositiveDefinite { row: 1 }));
    let matrix = DenseOperator::from_rows(1, vec![1.0]).unwrap();
    assert!(matches!(
        matrix.minimise(&[0.0], &NonNegative, Some(-1.0)),
        Err(Error::Total { .. })
    ));
}

#[test]
fn messages_name_the_number() {
    let message = Material::new(-7.5, 0.3).unwrap_err().to_string();
    assert_eq!(
        message,
        "Young's modulus must be positive and finite, got -7.5"
    );
    let message = Friction::coulomb(-0.25).unwrap_err().to_string();
    assert!(message.contains("coefficient of friction") && message.contains("-0.25"));
}
