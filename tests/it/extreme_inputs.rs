//! Inputs near the limits of floating-point numbers and grids are solved correctly, or rejected with an error that
//! contains the value.

use std::f64::consts::{FRAC_PI_2, TAU};

use kit::{Random, unit_bodies, unit_pair};
use stickslip::analytical::{HertzSphere, LubkinTorsion};
use stickslip::cgm::{self, NonNegative, Problem, Settings};
use stickslip::influence::Rectangle;
use stickslip::layers::Layer;
use stickslip::{
    Boundary, CoupledProblem, ElasticPair, Error, Field, Grid, HalfSpace, History, Identity,
    LoadStep, Material, NormalLoad, NormalProblem, TangentialLoad, TangentialModel,
    TangentialProblem, surface,
};

const MODELS: [TangentialModel; 2] = [TangentialModel::Scalar, TangentialModel::Vector];

fn periodic_bodies(grid: Grid) -> HalfSpace {
    HalfSpace::with_boundary(grid, unit_pair(0.3), Boundary::Periodic).unwrap()
}

/// The displacement has zero mean, so only friction resists a shift.
#[test]
fn single_periodic_cell_slides() {
    let grid = Grid::new(1, 1, 2.0, 0.5).unwrap();
    let (bodies, gap) = (periodic_bodies(grid), Field::zeros(grid));
    let (load, coefficient) = (2.0, 0.3);
    let friction = kit::coulomb(coefficient);
    let press = NormalLoad::Force(load);
    let pressed = NormalProblem::builder(&bodies, &gap, press)
        .build()
        .unwrap();
    let pressed = pressed.solve().unwrap();
    for model in MODELS {
        for shift in [1e-9, -0.1, 1e6] {
            let load_case = TangentialLoad::shift([shift, 0.0]);
            let problem =
                TangentialProblem::builder(&bodies, &pressed, friction.clone(), load_case);
            let sheared = kit::solve(problem.model(model));
            let mut history = History::builder(&bodies, &gap, friction.clone())
                .model(model)
                .build()
                .unwrap();
            history.step(&LoadStep::hold().normal(press)).unwrap();
            history.step(&LoadStep::shift([shift, 0.0])).unwrap();
            for force in [sheared.force(), history.tangential_force()] {
                let expected = coefficient * load * shift.signum();
                assert!(
                    (force[0] - expected).abs() < 1e-15 && force[1] == 0.0,
                    "{force:?}"
                );
            }
            assert!(sheared.is_gross_slip() && sheared.report().duality_gap == 0.0);
        }
    }
}

/// Covers random directions, whose components are not exactly representable.
#[test]
fn single_periodic_cell_slides_in_any_direction() {
    let mut random = Random(6);
    for _ in 0..200 {
        let grid = Grid::new(1, 1, 1.0, random.uniform(0.5, 2.0)).unwrap();
        let (bodies, gap) = (periodic_bodies(grid), Field::zeros(grid));
        let (load, coefficient) = (random.decade(-6.0, 0.0), random.uniform(0.1, 1.0));
        let friction = kit::coulomb(coefficient);
        let press = NormalLoad::Force(load);
        let pressed = NormalProblem::builder(&bodies, &gap, press)
            .build()
            .unwrap();
        let pressed = pressed.solve().unwrap();
        let angle = random.uniform(0.0, TAU);
        let direction = [angle.cos(), angle.sin()];
        let shift = load * random.decade(-9.0, 3.0);
        let load_case = TangentialLoad::shift(direction.map(|n| n * shift));
        let problem = TangentialProblem::builder(&bodies, &pressed, friction.clone(), load_case);
        let problem = problem.model(TangentialModel::Vector).build().unwrap();
        let sheared = problem.solve().unwrap();
        let history = History::builder(&bodies, &gap, friction).model(TangentialModel::Vector);
        let mut history = history.build().unwrap();
        history.step(&LoadStep::hold().normal(press)).unwrap();
        history
            .step(&LoadStep::shift(direction.map(|n| n * shift)))
            .unwrap();
        for force in [sheared.force(), history.tangential_force()] {
            for (force, n) in force.into_iter().zip(direction) {
                assert!((force - coefficient * load * n).abs() < 1e-7 * coefficient * load);
            }
        }
        assert!(sheared.is_gross_slip() && sheared.report().energy_error_bound() < 1e-7);
    }
}

/// White noise on cells of any aspect ratio is pressed and sheared.
#[test]
fn long_periodic_cells_converge() {
    let mut random = Random(5);
    for scene in 0..kit::thorough(100, 1000) {
        let length = 10_f64.powf(random.uniform(0.0, 6.0));
        let sides = if scene % 2 == 0 {
            [length, 1.0]
        } else {
            [1.0, length]
        };
        let (nx, ny) = (random.integer(2, 15), random.integer(2, 15));
        let grid = Grid::new(nx, ny, sides[0], sides[1]).unwrap();
        let bodies = periodic_bodies(grid);
        let heights = Field::from_fn(grid, |_, _| random.uniform(0.0, 1.0));
        let gap = surface::gap_from_heights(&heights).unwrap();
        let force = 10_f64.powf(random.uniform(-3.0, 0.0)) * grid.area();
        let problem = NormalProblem::builder(&bodies, &gap, NormalLoad::Force(force));
        let pressed = problem.build().unwrap().solve();
        let pressed =
            pressed.unwrap_or_else(|error| panic!("{scene}: {nx} x {ny}, {sides:?}: {error}"));
        let friction = kit::coulomb(0.3);
        let (size, angle) = (random.uniform(0.0, 0.28) * force, random.uniform(0.0, TAU));
        for model in MODELS {
            let oblique = match model {
                TangentialModel::Vector => angle,
                _ => 0.0,
            };
            let load = TangentialLoad::force([size * oblique.cos(), size * oblique.sin()]);
            let problem = TangentialProblem::builder(&bodies, &pressed, friction.clone(), load);
            let sheared = problem.model(model).build().unwrap().solve();
            sheared.unwrap_or_else(|error| {
                panic!("{scene}: {nx} x {ny}, {sides:?}, {model:?}: {error}")
            });
        }
    }
}

/// If rounding exceeds the stiffness of the shortest waves, no result can be certified.
#[test]
fn cells_too_long_to_certify_are_rejected() {
    let grid = Grid::new(14, 14, 1e15, 1.0).unwrap();
    let gap = Field::from_fn(grid, |x, y| (x * 1e-15 + y).sin() + 1.0);
    let force = NormalLoad::Force(0.1 * grid.area());
    let problem = NormalProblem::builder(&periodic_bodies(grid), &gap, force).build();
    kit::assert_refused! {
        problem.and_then(|problem| problem.solve()) => Error::CellsTooLong { sides } if sides == [1e15, 1.0],
    }
}

/// The squares of the tractions underflow or overflow long before the tractions themselves.
#[test]
fn tractions_of_any_size_scale() {
    let grid = kit::square(24, 8.0);
    let (bodies, ball) = (unit_bodies(grid, 0.3), kit::sphere(grid, 20.0));
    let pressed = NormalProblem::builder(&bodies, &ball, NormalLoad::Force(1.0));
    let pressed = kit::solve(pressed);
    for model in MODELS {
        let solve = |coefficient: f64| {
            let load = TangentialLoad::force([0.5 * coefficient, 0.0]);
            let problem =
                TangentialProblem::builder(&bodies, &pressed, kit::coulomb(coefficient), load);
            kit::solve(problem.model(model))
        };
        let ordinary = solve(0.5);
        for coefficient in [1e-290, 1e-160, 1e-90, 1e120, 1e155, 1e290] {
            let found = solve(coefficient);
            let ratio = found.shift()[0] / coefficient / (ordinary.shift()[0] / 0.5);
            assert!(
                (ratio - 1.0).abs() < 1e-8,
                "{model:?} {coefficient:e}: {ratio}"
            );
            assert!(
                found.zones() == ordinary.zones(),
                "{model:?} {coefficient:e}"
            );
            assert!(found.report().energy_error_bound() > 0.0);
        }
    }
}

#[test]
fn smallest_twist_sticks() {
    let hertz = HertzSphere::new(&unit_pair(0.3), 10.0, 1.0).unwrap();
    let torsion = LubkinTorsion::new(hertz, 1.0, 5e-324).unwrap();
    assert!(torsion.stick_ratio() == 1.0 && torsion.moment() < 1e-300);
    // Slightly larger twists have full precision.
    let small = LubkinTorsion::new(hertz, 1.0, 1e-300).unwrap();
    let stick =
        2.0 * hertz.pair().equivalent_shear_modulus() / hertz.max_pressure() * 1e-300 / FRAC_PI_2;
    assert!((-small.stick_ratio().ln()).abs() <= 2.0 * stick);
}

/// The influence coefficients are finite up to an aspect ratio of 1e100. More slender cells are rejected.
#[test]
fn slender_cells_have_finite_coefficients_or_are_rejected() {
    let steel = Material::new(210e9, 0.3).unwrap();
    for ratio in [1e-20, 1e-60, 1e-99] {
        for [a, b] in [[1.0, ratio], [ratio, 1.0]] {
            let cell = Rectangle::new(a, b).unwrap();
            for [x, y] in [
                [0.0, 0.0],
                [0.3, 0.0],
                [2.0, 1.0],
                [ratio, 3.0 * ratio],
                [5.0, ratio],
            ] {
                let c = cell.tensor(&steel, x, y);
                let entries = [c.xx, c.xy, c.xz, c.yx, c.yy, c.yz, c.zx, c.zy, c.zz];
                assert!(entries.iter().all(|entry| entry.is_finite()), "{c:?}");
                assert!(c.zz > 0.0 && c.xx > 0.0 && c.yy > 0.0);
            }
        }
    }
    for ratio in [1e-101, 1e-128, 1e-200] {
        kit::assert_refused! { Rectangle::new(1.0, ratio) => Error::CellsTooLong { .. } }
        let grid = Grid::new(4, 4, 1.0, ratio).unwrap();
        let gap = Field::zeros(grid);
        let bodies = HalfSpace::new(grid, unit_pair(0.3));
        let refused = bodies.and_then(|bodies| {
            let problem = NormalProblem::builder(&bodies, &gap, NormalLoad::Force(1.0));
            problem.build()?.solve()
        });
        assert!(refused.is_err());
    }
}

#[test]
fn heights_near_the_largest_double_are_filled_and_resampled() {
    let tall = Field::from_fn(kit::square(6, 6.0), |x, y| 1.7e308 * (x + y).signum());
    let mut holed = tall.clone();
    for cell in [14, 15, 20, 21, 0] {
        holed.as_mut_slice()[cell] = f64::NAN;
    }
    let filled = surface::fill_missing(&holed).unwrap();
    let scaled = |field: &Field| {
        let mut field = field.clone();
        field.as_mut_slice().iter_mut().for_each(|z| *z *= 1e-300);
        field
    };
    let expected = surface::fill_missing(&scaled(&holed)).unwrap();
    for (found, expected) in filled
        .heights()
        .as_slice()
        .iter()
        .zip(expected.heights().as_slice())
    {
        assert!((found * 1e-300 - expected).abs() < 1e-12 * 1.7e8);
    }
    // Cubic interpolation overshoots, and a resulting overflow is rejected.
    let finer = kit::square(12, 6.0);
    kit::assert_refused! { surface::resample(&tall, finer) => Error::Sample { .. } }
    assert!(surface::resample(&scaled(&tall), finer).is_ok());
}

/// Close to sliding the slip of a cell is as small as the residual. The dissipation is still not negative.
#[test]
fn dissipation_close_to_sliding_is_not_negative() {
    let mut random = Random(8);
    for _ in 0..20 {
        let grid = Grid::new(12, 14, 1.0, random.uniform(0.5, 2.0)).unwrap();
        let bodies = periodic_bodies(grid);
        let gap = Field::from_fn(grid, |_, _| random.uniform(0.0, 1.0));
        let normal = NormalProblem::builder(&bodies, &gap, NormalLoad::Force(20.0));
        let normal = kit::solve(normal);
        for model in MODELS {
            // Closer to sliding the vector model may stall, as documented.
            let missing = match model {
                TangentialModel::Scalar => [1e-6, 1e-9, 1e-11],
                _ => [1e-3, 1e-5, 1e-6],
            };
            for missing in missing {
                let force = 0.4 * normal.force() * (1.0 - missing);
                let load = TangentialLoad::force([force, 0.0]);
                let shear = TangentialProblem::builder(&bodies, &normal, kit::coulomb(0.4), load);
                let shear = kit::solve(shear.model(model));
                assert!(shear.dissipated_energy() >= 0.0);
                let [slip, traction] = [shear.slip(), shear.traction()].map(|v| v[0].as_slice());
                assert!(
                    slip.iter()
                        .zip(traction)
                        .all(|(s, q)| model == TangentialModel::Vector || s * q <= 0.0)
                );
            }
        }
    }
}

fn extreme_number(outcome: Result<impl Sized, Error>) -> Option<(&'static str, f64)> {
    match outcome.map(drop) {
        Err(Error::ExtremeNumber {
            quantity,
            value,
            least,
            most,
            ..
        }) => {
            assert!(!(least..=most).contains(&value), "{quantity} {value:e}");
            Some((quantity, value))
        }
        _ => None,
    }
}

/// Scales bodies, loads and tangential loads by the same unit. Solutions scale with the unit if squares are
/// representable. Otherwise an error reports the value.
#[test]
fn units_with_squares_out_of_range_are_rejected_before_any_work() {
    let grid = kit::square(16, 8.0);
    let ball = kit::sphere(grid, 20.0);
    let scaled = |unit: f64| Field::from_fn(grid, |x, y| unit * (x * x + y * y) / 40.0);
    let press = |bodies: &HalfSpace, gap: &Field, load| {
        NormalProblem::builder(bodies, gap, load).build()?.solve()
    };
    let bodies = |modulus: f64| HalfSpace::new(grid, kit::alike(modulus, 0.3));
    let ordinary = bodies(1.0).unwrap();
    let expected = press(&ordinary, &ball, NormalLoad::Force(1.0)).unwrap();
    let relative = |found: f64, unit: f64, expected: f64| found / unit / expected - 1.0;
    for unit in [1e-120, 1e120] {
        let stiff = bodies(unit).unwrap();
        let found = press(&stiff, &ball, NormalLoad::Force(unit)).unwrap();
        assert!(relative(found.approach(), 1.0, expected.approach()).abs() < 1e-8);
        let found = press(&ordinary, &scaled(unit), NormalLoad::Force(unit)).unwrap();
        assert!(relative(found.approach(), unit, expected.approach()).abs() < 1e-8);
        let energy_error = found.report().energy_error_bound();
        assert!(energy_error > 0.0 && energy_error < 1e-7, "{energy_error}");
    }
    for unit in [1e-300, 1e-200, 1e-140, 1e140, 1e200, 1e300] {
        let (_, value) = extreme_number(bodies(unit)).unwrap();
        assert!(
            (value * unit / (0.5 * 2.0 * 0.91) - 1.0).abs() < 1e-12,
            "{value:e}"
        );
        for load in [NormalLoad::Force(unit), NormalLoad::Approach(unit)] {
            let refused = extreme_number(press(&ordinary, &scaled(unit), load));
            let (_, value) = refused.unwrap_or_else(|| panic!("{load:?}"));
            assert!(
                value / unit > 1e-3 && value / unit < 1e3,
                "{load:?} {value:e}"
            );
        }
        let friction = kit::coulomb(0.5);
        for model in MODELS {
            for load in [
                TangentialLoad::force([unit, 0.0]),
                TangentialLoad::shift([unit, 0.0]),
            ] {
                let builder =
                    TangentialProblem::builder(&ordinary, &expected, friction.clone(), load);
                let sheared = builder.model(model).build().and_then(|of| of.solve());
                let is_beyond = matches!(sheared, Err(Error::BeyondFrictionCapacity { .. }));
                assert!(
                    is_beyond || extreme_number(sheared).is_some(),
                    "{model:?} {unit:e}"
                );
            }
        }
        let mut history = History::builder(&ordinary, &ball, friction)
            .build()
            .unwrap();
        let step = LoadStep::hold().normal(NormalLoad::Force(unit));
        assert!(extreme_number(history.step(&step)).is_some(), "{unit:e}");
    }
    // A load of zero is accepted.
    let none = press(&ordinary, &ball, NormalLoad::Force(0.0)).unwrap();
    assert_eq!(none.contact_cells(), 0);
}

/// Coupled pressure and traction have the same limits.
#[test]
fn coupled_loads_with_squares_out_of_range_are_rejected() {
    let grid = kit::square(12, 8.0);
    let bodies = HalfSpace::new(grid, kit::on_rigid(1.0, 0.2)).unwrap();
    for force in [1e-300, 1e-140, 1e140, 1e300] {
        let still = TangentialLoad::shift([0.0; 2]);
        let press = NormalLoad::Force(force);
        let problem = CoupledProblem::builder(
            &bodies,
            kit::sphere(grid, 20.0),
            kit::coulomb(0.5),
            press,
            still,
        );
        assert!(extreme_number(problem.build()).is_some(), "{force:e}");
    }
}

/// If squares underflow or overflow, the engine certifies no error.
#[test]
fn squares_out_of_range_certify_no_error() {
    for unit in [1e-300, 1e-180, 1.0, 1e-100, 1e100, 1e180, 1e300] {
        let operator = Identity::new(2);
        let linear = [-2.0 * unit, unit];
        let problem = Problem::new(operator, [&linear], NonNegative);
        let mut x = [0.0; 2];
        let found = cgm::minimise(&problem, &Settings::default(), [&mut x]);
        if (1e-100..=1e100).contains(&unit) {
            assert!(found.unwrap().report.duality_gap < 1e-16);
            assert!((x[0] / unit - 2.0).abs() < 1e-8 && x[1] == 0.0);
        } else {
            let Err(Error::NotConverged(report)) = found else {
                panic!("{unit:e}: {found:?}")
            };
            assert!(report.energy_error_bound().is_infinite(), "{report}");
        }
    }
}

/// The responses of any pair at any wave number are positive and finite, or the call returns an error.
#[test]
fn responses_out_of_range_are_rejected() {
    let moduli = [1e-300, 1e-150, 1.0, 1e150, 1e300];
    let numbers = [5e-324, 1e-310, 1e-200, 1e-10, 1.0, 1e10, 1e200, 1e308];
    let mut rejected = 0;
    for modulus in moduli {
        let body = Material::new(modulus, 0.3).unwrap();
        let layer = Layer::new(2.0 * modulus, 0.2, 1.0).unwrap();
        let coated = body.coated(&[layer]).unwrap();
        for body in [body, coated] {
            let pair = ElasticPair::new(body, Material::rigid()).unwrap();
            for k in numbers {
                match pair.response(k) {
                    Ok(response) => {
                        let parts = [response.normal, response.along, response.across];
                        assert!(parts.iter().all(|part| *part > 0.0 && part.is_finite()));
                        assert!(response.coupling.is_finite(), "{modulus:e} {k:e}");
                    }
                    Err(Error::NotPositive { value, .. } | Error::NotFinite { value, .. }) => {
                        assert!(value == 0.0 || !value.is_finite(), "{value:e}");
                        rejected += 1;
                    }
                    Err(error) => panic!("{modulus:e} {k:e}: {error}"),
                }
            }
        }
    }
    assert!(rejected > 20, "{rejected}");
    kit::assert_refused! { kit::on_rigid(1e-300, 0.3).response(1e-200) => Error::NotPositive { value, .. } if value == f64::INFINITY }
}
