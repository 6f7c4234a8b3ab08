//! Invalid input is reported, before any work is done, by an error that states the input. No input causes a panic.

use kit::refusal::Rule::Positive;
use kit::refusal::assert_checked;
use stickslip::cgm::{self, AbsBound, Bounds, Method, NonNegative, Problem, Settings, Total};
use stickslip::influence::Rectangle;
use stickslip::{
    ElasticPair, Error, Field, Friction, Grid, HalfSpace, Identity, Material, Operator, Scratch,
    surface,
};

const NOT_POSITIVE: [f64; 5] = [0.0, -1.0, f64::NAN, f64::INFINITY, f64::NEG_INFINITY];
const NEGATIVE: [f64; 4] = [-1e-300, f64::NAN, f64::INFINITY, f64::NEG_INFINITY];

/// Returns whether two numbers are bitwise identical, NaN included.
fn is_identical(a: f64, b: f64) -> bool {
    a.to_bits() == b.to_bits()
}

fn grid() -> Grid {
    Grid::new(8, 6, 1.0, 1.0).unwrap()
}

#[test]
fn grids_with_invalid_sizes_are_rejected() {
    for (nx, ny) in [(0, 5), (5, 0), (0, usize::MAX)] {
        assert_eq!(Grid::new(nx, ny, 1.0, 1.0), Err(Error::GridSize { nx, ny }));
    }
    for value in NOT_POSITIVE {
        for grid in [
            Grid::new(2, 2, value, 1.0),
            Grid::new(2, 2, 1.0, value),
            Grid::square(2, value),
        ] {
            kit::assert_refused! { grid => Error::NotPositive { value: v, .. } if is_identical(v, value) }
        }
        assert!(
            matches!(Rectangle::new(value, 1.0), Err(Error::NotPositive { value: v, .. }) if is_identical(v, value))
        );
    }
    kit::assert_refused! {
        Grid::square(0, 1.0) => Error::GridSize { nx: 0, ny: 0 },
        // The cell area underflows.
        Grid::new(2, 2, 1e-200, 1e-200) => Error::NotPositive { .. },
        Rectangle::new(1e-300, 1e300) => Error::CellsTooLong { .. },
    }
    let slender = Grid::new(2, 2, 1e-200, 1e200).unwrap();
    kit::assert_refused! { HalfSpace::new(slender, kit::on_rigid(1.0, 0.3)) => Error::CellsTooLong { .. } }
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
fn materials_with_invalid_constants_are_rejected() {
    for value in NOT_POSITIVE {
        for material in [
            Material::new(value, 0.3),
            Material::from_shear_modulus(value, 0.3),
        ] {
            kit::assert_refused! { material => Error::NotPositive { value: v, .. } if is_identical(v, value) }
        }
    }
    assert!(Material::new(1e-320, 0.3).is_err(), "compliance overflows");
    for nu in [-1.0, 0.500001, -2.0, 0.9, f64::NAN, f64::INFINITY] {
        kit::assert_refused! { Material::new(1.0, nu) => Error::PoissonRatio(v) if is_identical(v, nu) }
    }
    kit::assert_refused! { ElasticPair::new(Material::rigid(), Material::rigid()) => Error::BothRigid }
    for radius in NOT_POSITIVE {
        kit::assert_refused! {
            surface::sphere(grid(), radius) => Error::NotPositive { value: v, .. } if is_identical(v, radius),
        }
    }
}

#[test]
fn directions_that_repeat_are_rejected() {
    use stickslip::influence::Direction::{X, Y};
    let bodies = HalfSpace::new(grid(), kit::on_rigid(1.0, 0.3)).unwrap();
    let error = bodies.tensor_operator([X, Y, X]).err();
    assert_eq!(error, Some(Error::RepeatedDirection));
    let error = bodies.tensor_preconditioner([Y, Y]).err();
    assert_eq!(error, Some(Error::RepeatedDirection));
}

#[test]
fn friction_with_invalid_coefficient_is_rejected() {
    for value in NEGATIVE {
        assert!(
            matches!(Friction::coulomb(value), Err(Error::NegativeOrNotFinite { value: v, .. }) if is_identical(v, value))
        );
        let mut field = Field::constant(grid(), 0.5);
        field.as_mut_slice()[3] = value;
        kit::assert_refused! {
            Friction::per_cell(field) => Error::Sample { index: 3, value: v, .. } if is_identical(v, value),
        }
    }
    let friction = kit::coulomb(0.5);
    for value in NOT_POSITIVE {
        kit::assert_refused! {
            friction.clone().max_shear_stress(value) => Error::NotPositive { value: v, .. } if is_identical(v, value),
        }
    }
}

#[test]
fn engine_rejects_invalid_arguments_before_any_work() {
    let solve = |linear: &[f64], x: &mut [f64]| {
        cgm::minimise(
            &Problem::new(Identity::new(2), [linear], NonNegative),
            &Settings::default(),
            [x],
        )
        .err()
    };
    let mut x = [1.0, 2.0];
    kit::assert_refused! {
        solve(&[0.0], &mut x) => Error::Length { expected: 2, found: 1, .. },
        solve(&[0.0, f64::NAN], &mut x) => Error::Sample { index: 1, .. },
        solve(&[0.0; 2], &mut [f64::NAN, 0.0]) => Error::Sample { index: 0, .. },
        solve(&[0.0; 2], &mut [0.0; 3]) => Error::Length { expected: 2, found: 3, .. },
    }

    let linear = [0.0; 2];
    let settings = Settings::default();
    for (lower, upper) in [
        ([0.0, 1.0], [1.0, 0.0]),
        ([0.0, f64::NAN], [1.0, 1.0]),
        ([0.0, f64::INFINITY], [1.0, f64::INFINITY]),
    ] {
        let interval = Bounds {
            lower: &lower,
            upper: &upper,
        };
        kit::assert_refused! {
            cgm::minimise(&Problem::new(Identity::new(2), [&linear], interval), &settings, [&mut x])
                => Error::Bounds { index: 1, .. },
        }
    }
    let uneven = Bounds {
        lower: &[0.0],
        upper: &[1.0; 2],
    };
    kit::assert_refused! {
        cgm::minimise(&Problem::new(Identity::new(2), [&linear], uneven), &settings, [&mut x])
            => Error::Length { expected: 2, .. },
    }
    for total in [3.1, -3.1, f64::NAN, f64::INFINITY] {
        let problem = Problem::new(Identity::new(2), [&linear], AbsBound(&[1.0, 2.0])).total(total);
        let error = cgm::minimise(&problem, &settings, [&mut x]).err();
        assert!(
            matches!(error, Some(Error::Total { total: t, lower: -3.0, upper: 3.0, .. }) if is_identical(t, total))
        );
    }
    let problem =
        Problem::new(Identity::new(2), [&linear], NonNegative).preconditioner(Identity::new(3));
    kit::assert_refused! { cgm::minimise(&problem, &settings, [&mut x]) => Error::Length { .. } }
    let problem = Problem::new(Identity::new(2), [&linear], NonNegative);
    let mut small = Problem::new(Identity::new(1), [&linear[..1]], NonNegative)
        .workspace()
        .unwrap();
    kit::assert_refused! {
        cgm::minimise_with(&problem, &settings, [&mut x], &mut small, &mut |_| { std::ops::ControlFlow::Continue(()) })
            => Error::Length { expected: 2, found: 1, .. },
    }
    for tolerance in [0.0, 1.0, f64::NAN, f64::INFINITY, -1e300] {
        let settings = settings.tolerance(tolerance);
        let outcome = cgm::minimise(&problem, &settings, [&mut x]);
        assert!(matches!(outcome, Err(Error::Tolerance(t)) if is_identical(t, tolerance)));
    }
    kit::assert_refused! { cgm::minimise(&problem, &settings.max_iterations(0), [&mut x]) => Error::IterationLimit }
    assert_eq!(x, [1.0, 2.0], "rejected before any work");
}

/// The map `u = (x + y, y - x)` of two cells.
struct RotationOperator;

impl Operator for RotationOperator {
    fn cells(&self) -> usize {
        2
    }

    fn apply(&self, [x]: [&[f64]; 1], [u]: [&mut [f64]; 1], _: &mut Scratch) {
        (u[0], u[1]) = (x[0] + x[1], x[1] - x[0]);
    }

    fn is_symmetric(&self) -> bool {
        false
    }
}

#[test]
fn polonsky_keer_rejects_unsupported_problems() {
    let settings = Settings::default().method(Method::PolonskyKeer);
    let (linear, mut x, mut y) = ([0.0; 2], [1.0, 2.0], [0.0; 2]);
    let refused = |outcome: Option<Error>, what: &str| matches!(outcome, Some(Error::Method { quantity, .. }) if quantity == what);
    let spring = Total::Spring {
        far_end: 1.0,
        compliance: 1.0,
    };
    let problem = Problem::new(Identity::new(2), [&linear], NonNegative).totals([spring]);
    let outcome = cgm::minimise(&problem, &settings, [&mut x]);
    assert!(refused(outcome.err(), "springs"));
    let discs = Problem::new(Identity::new(2), [&linear; 2], AbsBound(&[1.0, 2.0]));
    let outcome = cgm::minimise(&discs, &settings, [&mut x, &mut y]);
    assert!(refused(outcome.err(), "several components per cell"));
    let turning = Problem::new(RotationOperator, [&linear], NonNegative);
    let outcome = cgm::minimise(&turning, &settings, [&mut x]);
    assert!(refused(outcome.err(), "non-symmetric operators"));
    assert_eq!(x, [1.0, 2.0], "rejected before any work");
}

/// Each modulus is finite, and so is every modulus of the pair.
#[test]
fn pairs_of_extreme_materials_are_finite_or_rejected() {
    let pair = |modulus, nu| {
        let body = Material::from_shear_modulus(modulus, nu)?;
        let pair = ElasticPair::new(body, body)?;
        Ok(pair.contact_modulus() + pair.equivalent_shear_modulus() + pair.dundurs_beta())
    };
    for nu in [-0.999, -0.5, 0.0, 0.3, 0.5] {
        assert_checked("modulus", Positive, |modulus| pair(modulus, nu));
        for modulus in [6e-309, 1e-308, 3e-308, 1e307, 4e307] {
            assert!(
                pair(modulus, nu).map_or(true, f64::is_finite),
                "{modulus:e} {nu}"
            );
        }
    }
    let soft = Material::new(2.3e-308, 0.5).unwrap();
    kit::assert_refused! { ElasticPair::new(soft, soft) => Error::NotPositive { value: 0.0, .. } }
}

/// A cell without a coefficient has no limit, not even the limit of the cap.
#[test]
fn friction_limit_without_coefficient_or_pressure_is_nan() {
    let uneven = Friction::per_cell(Field::constant(grid(), 0.5)).unwrap();
    let capped = uneven.clone().max_shear_stress(2.0).unwrap();
    for friction in [uneven, capped] {
        assert!(friction.limit(48, 1.0).is_nan());
        assert!(friction.limit(3, f64::NAN).is_nan());
        assert_eq!(friction.limit(47, 1.0), 0.5);
    }
}

#[test]
fn messages_contain_the_invalid_number() {
    let message = Material::new(-7.5, 0.3).unwrap_err().to_string();
    assert_eq!(
        message,
        "Young's modulus must be positive and finite, got -7.5"
    );
    let message = Friction::coulomb(-0.25).unwrap_err().to_string();
    assert!(message.contains("coefficient of friction") && message.contains("-0.25"));
    let message = surface::sum(&[]).unwrap_err().to_string();
    assert_eq!(message, "list of fields has 0 entries, expected 1");
    let message = Error::EmptyContact.to_string();
    assert!(
        message.contains("first prescribe a positive normal force")
            && message.contains("smallest gap")
    );
}

/// Fields are added, subtracted, multiplied and scaled cell by cell on one grid. Indexing by column and row outside the
/// grid returns no value, even if the linear index is in range.
#[test]
fn fields_support_cellwise_arithmetic_and_checked_indexing() {
    let grid = grid();
    let one = Field::from_fn(grid, |x, y| 1.0 + x + 10.0 * y);
    let two = Field::from_fn(grid, |x, y| 2.0 - x * y);
    let sum = (&one + &two).unwrap();
    let difference = (&one - &two).unwrap();
    let product = (&sum * &difference).unwrap();
    let squares = (&(&one * &one).unwrap() - &(&two * &two).unwrap()).unwrap();
    for (a, b) in product.iter().zip(&squares) {
        assert!((a - b).abs() < 1e-10 * (1.0 + b.abs()));
    }
    assert_eq!(&one * 3.0, one.scaled(3.0));
    assert!((sum.mean() * grid.area() - sum.integral()).abs() < 1e-9);
    let mut changed = one.clone();
    changed[(7, 5)] = -1.0;
    assert_eq!((changed[(7, 5)], changed[(6, 5)]), (-1.0, one[(6, 5)]));
    assert_eq!(one.get(8, 0), None);
    let outside = std::panic::catch_unwind(|| one[(8, 0)]);
    assert!(outside.is_err());

    let other = Field::zeros(Grid::new(6, 8, 1.0, 1.0).unwrap());
    for refused in [&one + &other, &one - &other, &one * &other] {
        assert!(matches!(refused, Err(Error::GridMismatch { .. })));
    }
}
