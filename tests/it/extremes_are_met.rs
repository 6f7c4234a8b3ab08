//! What lies at the edge of numbers and grids is solved, or refused with a number: never returned wrong.

use std::f64::consts::{FRAC_PI_2, TAU};

use kit::{Random, unit_bodies, unit_pair};
use stickslip::analytical::{HertzSphere, LubkinTorsion};
use stickslip::influence::Rectangle;
use stickslip::{
    Boundary, Error, Field, Friction, Grid, HalfSpace, History, LoadStep, Material, NormalControl,
    NormalProblem, TangentialLoad, TangentialModel, TangentialProblem, surface,
};

const MODELS: [TangentialModel; 2] = [TangentialModel::Scalar, TangentialModel::Vector];

fn periodic(grid: Grid) -> HalfSpace {
    HalfSpace::with_boundary(grid, unit_pair(0.3), Boundary::Periodic).unwrap()
}

/// Its displacement has mean zero, so that nothing resists a shift but friction.
#[test]
fn one_cell_that_repeats_slides() {
    let grid = Grid::new(1, 1, 2.0, 0.5).unwrap();
    let (bodies, gap) = (periodic(grid), Field::zeros(grid));
    let (load, coefficient) = (2.0, 0.3);
    let friction = Friction::coulomb(coefficient).unwrap();
    let press = NormalControl::Force(load);
    let pressed = NormalProblem::builder(&bodies, &gap, press)
        .build()
        .unwrap();
    let pressed = pressed.solve().unwrap();
    for model in MODELS {
        for shift in [1e-9, -0.1, 1e6] {
            let load_case = TangentialLoad::shift([shift, 0.0]);
            let problem =
                TangentialProblem::builder(&bodies, &pressed, friction.clone(), load_case);
            let sheared = problem.model(model).build().unwrap().solve().unwrap();
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

/// The same along no axis, where no direction is exact.
#[test]
fn one_cell_that_repeats_slides_in_any_direction() {
    let mut random = Random(6);
    for _ in 0..200 {
        let grid = Grid::new(1, 1, 1.0, random.uniform(0.5, 2.0)).unwrap();
        let (bodies, gap) = (periodic(grid), Field::zeros(grid));
        let (load, coefficient) = (random.decade(-6.0, 0.0), random.uniform(0.1, 1.0));
        let friction = Friction::coulomb(coefficient).unwrap();
        let press = NormalControl::Force(load);
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

/// White noise on cells of any shape, pressed and sheared.
#[test]
fn long_cells_that_repeat_converge() {
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
        let bodies = periodic(grid);
        let heights = Field::from_fn(grid, |_, _| random.uniform(0.0, 1.0));
        let gap = surface::gap_from_heights(&heights).unwrap();
        let force = 10_f64.powf(random.uniform(-3.0, 0.0)) * grid.area();
        let problem = NormalProblem::builder(&bodies, &gap, NormalControl::Force(force));
        let pressed = problem.build().unwrap().solve();
        let pressed =
            pressed.unwrap_or_else(|error| panic!("{scene}: {nx} x {ny}, {sides:?}: {error}"));
        let friction = Friction::coulomb(0.3).unwrap();
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

/// Where rounding hides the stiffness of the shortest waves nothing can be certified.
#[test]
fn cells_too_long_to_certify_are_refused() {
    let grid = Grid::new(14, 14, 1e15, 1.0).unwrap();
    let gap = Field::from_fn(grid, |x, y| (x * 1e-15 + y).sin() + 1.0);
    let force = NormalControl::Force(0.1 * grid.area());
    let problem = NormalProblem::builder(&periodic(grid), &gap, force).build();
    let refused = problem.and_then(|problem| problem.solve());
    assert!(
        matches!(refused, Err(Error::CellsTooLong { sides }) if sides == [1e15, 1.0]),
        "{refused:?}"
    );
}

/// The squares of the tractions leave the range of numbers long before the tractions do.
#[test]
fn tractions_of_any_size() {
    let grid = Grid::square(24, 8.0).unwrap();
    let (bodies, ball) = (unit_bodies(grid, 0.3), surface::sphere(grid, 20.0).unwrap());
    let pressed = NormalProblem::builder(&bodies, &ball, NormalControl::Force(1.0));
    let pressed = pressed.build().unwrap().solve().unwrap();
    for model in MODELS {
        let solve = |coefficient: f64| {
            let load = TangentialLoad::force([0.5 * coefficient, 0.0]);
            let friction = Friction::coulomb(coefficient).unwrap();
            let problem = TangentialProblem::builder(&bodies, &pressed, friction, load);
            problem.model(model).build().unwrap().solve().unwrap()
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
fn the_least_twist_sticks() {
    let hertz = HertzSphere::new(&unit_pair(0.3), 10.0, 1.0).unwrap();
    let torsion = LubkinTorsion::new(hertz, 1.0, 5e-324).unwrap();
    assert!(torsion.stick_ratio() == 1.0 && torsion.moment() < 1e-300);
    // The next sizes have digits.
    let small = LubkinTorsion::new(hertz, 1.0, 1e-300).unwrap();
    let stick =
        2.0 * hertz.pair().equivalent_shear_modulus() / hertz.max_pressure() * 1e-300 / FRAC_PI_2;
    assert!((-small.stick_ratio().ln()).abs() <= 2.0 * stick);
}

/// Up to a ratio of 1e100 the influence coefficients are numbers; beyond it cells are refused.
#[test]
fn slender_cells_have_coefficients_or_are_refused() {
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
        let refused = Rectangle::new(1.0, ratio);
        assert!(matches!(refused, Err(Error::CellsTooLong { .. })));
        let grid = Grid::new(4, 4, 1.0, ratio).unwrap();
        let gap = Field::zeros(grid);
        let bodies = HalfSpace::new(grid, unit_pair(0.3));
        let refused = bodies.and_then(|bodies| {
            let problem = NormalProblem::builder(&bodies, &gap, NormalControl::Force(1.0));
            problem.build()?.solve()
        });
        assert!(refused.is_err());
    }
}

#[test]
fn heights_near_the_largest_number_are_filled_and_resampled() {
    let grid = Grid::square(6, 6.0).unwrap();
    let tall = Field::from_fn(grid, |x, y| 1.7e308 * (x + y).signum());
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
    // A cubic overshoots; where that is no number it is refused.
    let finer = Grid::square(12, 6.0).unwrap();
    let refused = surface::resample(&tall, finer);
    assert!(matches!(refused, Err(Error::Sample { .. })), "{refused:?}");
    assert!(surface::resample(&scaled(&tall), finer).is_ok());
}

/// Just below sliding the slip of a cell is as small as the residual; it still dissipates nothing negative.
#[test]
fn next_to_sliding_nothing_is_gained() {
    let mut random = Random(8);
    for _ in 0..20 {
        let grid = Grid::new(12, 14, 1.0, random.uniform(0.5, 2.0)).unwrap();
        let bodies = periodic(grid);
        let gap = Field::from_fn(grid, |_, _| random.uniform(0.0, 1.0));
        let normal = NormalProblem::builder(&bodies, &gap, NormalControl::Force(20.0));
        let normal = normal.build().unwrap().solve().unwrap();
        for model in MODELS {
            // Closer to sliding the vector model may stall, as its page tells.
            let missing = match model {
                TangentialModel::Scalar => [1e-6, 1e-9, 1e-11],
                _ => [1e-3, 1e-5, 1e-6],
            };
            for missing in missing {
                let force = 0.4 * normal.force() * (1.0 - missing);
                let friction = Friction::coulomb(0.4).unwrap();
                let load = TangentialLoad::force([force, 0.0]);
                let shear = TangentialProblem::builder(&bodies, &normal, friction, load);
                let shear = shear.model(model).build().unwrap().solve().unwrap();
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
