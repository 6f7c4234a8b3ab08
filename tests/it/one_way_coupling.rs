//! Tests of one-way coupling (Goodman's approximation) in problems and in histories. Tractions are computed under a
//! given pressure.

use kit::{l2_difference, max_difference};
use stickslip::analytical::SpencePressing;
use stickslip::{
    Axis, Boundary, CoupledProblem, Coupling, ElasticPair, Field, Grid, HalfSpace, History,
    LoadStep, NormalLoad, NormalProblem, TangentialControl, TangentialLoad, TangentialModel,
    TangentialProblem, TangentialSolution, Warning, surface,
};

fn on_rigid(beta: f64) -> ElasticPair {
    let poisson_ratio = (1.0 - 2.0 * beta) / (2.0 - 2.0 * beta);
    kit::on_rigid(1.0, poisson_ratio)
}

/// Presses and holds a flat punch of radius one on `cells` cells along a side.
fn punch(cells: usize, beta: f64, coefficient: f64) -> TangentialSolution {
    let grid = kit::square(cells, 2.4);
    let bodies = HalfSpace::new(grid, on_rigid(beta)).unwrap();
    let gap = Field::from_fn(grid, |x, y| if x.hypot(y) < 1.0 { 0.0 } else { 1e3 });
    let press = NormalLoad::Force(1.0);
    let normal = kit::solve(NormalProblem::builder(&bodies, &gap, press));
    kit::solve(
        TangentialProblem::builder(
            &bodies,
            &normal,
            kit::coulomb(coefficient),
            TangentialLoad::shift([0.0; 2]),
        )
        .model(TangentialModel::Vector),
    )
}

/// The stick zone of a punch agrees with Spence's solution for any beta, because both solutions neglect the change of
/// the pressure due to shear.
#[test]
fn one_way_punch_sticks_as_in_spence() {
    for &beta in kit::thorough(&[0.5][..], &[0.5, 0.2]) {
        let coefficients = [0.35, 0.5, 0.7, 0.9].map(|ratio| ratio * beta);
        let error = |cells: usize| {
            let errors = coefficients.map(|mu| {
                let exact = SpencePressing::round(&on_rigid(beta), mu).unwrap();
                (punch(cells, beta, mu).stick_ratio().sqrt() - exact.stick_radius()).abs()
            });
            errors.iter().sum::<f64>() / 4.0
        };
        let (coarse, fine) = (error(33), error(129));
        assert!(
            fine < 5e-3 && fine < 0.4 * coarse,
            "{beta}: {coarse} {fine}"
        );
    }
}

/// Rows of equal cells that are pressed all over slide inwards on both sides of the middle. The tractions of the two
/// halves are at opposite limits and sum to zero, so that hardly any cell sticks.
#[test]
fn pressed_flat_surface_slides_in_both_halves() {
    let mut sliding = 0;
    for cells in [4, 6, 8, 12, 16] {
        for coefficient in [0.02, 0.04, 0.1, 0.18] {
            let grid = kit::square(cells, cells as f64);
            let datum = 10.0 * cells as f64;
            let boundary = Boundary::PeriodicAlongY { datum };
            let bodies = HalfSpace::with_boundary(grid, on_rigid(0.5), boundary).unwrap();
            let press = NormalLoad::Force(1e-3 * grid.area());
            let flat = Field::zeros(grid);
            let normal = NormalProblem::builder(&bodies, &flat, press)
                .build()
                .unwrap();
            let normal = normal.solve().unwrap();
            let shear = kit::solve(
                TangentialProblem::builder(
                    &bodies,
                    &normal,
                    kit::coulomb(coefficient),
                    TangentialLoad::force([0.0; 2]),
                )
                .model(TangentialModel::Vector)
                .coupling(Coupling::OneWay),
            );
            // Only one or two cells, which compensate the round-off between the halves, may stick.
            sliding += usize::from(shear.stick_ratio() < 0.13);
            let [x, _] = shear.traction();
            let scale = coefficient * normal.pressure().max();
            for iy in 0..cells {
                for ix in 0..cells / 2 {
                    let pair = x.get(ix, iy).unwrap() + x.get(cells - 1 - ix, iy).unwrap();
                    assert!(pair.abs() < 1e-6 * scale, "{cells} {coefficient}: {pair:e}");
                }
            }
        }
    }
    assert!(sliding >= 8, "{sliding} of 20 cases slide");
}

/// If the cells of a row slide towards its middle on both sides, their tractions point away from it. Rotations of these
/// tractions are too small to carry a small force along the row. One cell must therefore stick.
#[test]
fn small_force_along_diverging_row_leaves_a_cell_sticking() {
    for cells in [2, 4, 7] {
        let grid = Grid::new(cells, 1, 1.8, 1.0).unwrap();
        let bodies = HalfSpace::new(grid, kit::on_rigid(1.0, 0.05)).unwrap();
        let gap = Field::zeros(grid);
        let press = NormalLoad::Force(1e-3);
        let normal = NormalProblem::builder(&bodies, &gap, press)
            .build()
            .unwrap();
        let normal = normal.solve().unwrap();
        let coefficient = 0.02;
        for part in [1e-9, 1e-7, 1e-5, 1e-3, 0.1] {
            for angle in [0.1_f64, -0.5, 1.2, 2.7] {
                let force = [angle.cos(), angle.sin()].map(|n| n * part * coefficient * 1e-3);
                let load = TangentialLoad::force(force);
                let shear =
                    TangentialProblem::builder(&bodies, &normal, kit::coulomb(coefficient), load)
                        .model(TangentialModel::Vector)
                        .build()
                        .unwrap();
                let shear = shear.solve().unwrap();
                assert!(shear.stick_ratio() > 0.0, "{cells} {part:e} {angle}");
                assert!(
                    shear.report().iterations < 100,
                    "{cells} {part:e} {angle}: {}",
                    shear.report()
                );
                for (found, asked) in shear.force().into_iter().zip(force) {
                    assert!((found - asked).abs() < 1e-14 * 1e-3, "{found:e} {asked:e}");
                }
            }
        }
    }
}

/// Under the pressure of the fully coupled solution, one-way coupling gives the tractions of the fully coupled
/// solution.
#[test]
fn tractions_match_full_coupling_under_its_pressure() {
    let grid = Grid::new(26, 22, 0.1, 0.12).unwrap();
    for boundary in kit::boundaries(grid) {
        let bodies = HalfSpace::with_boundary(grid, on_rigid(0.4), boundary).unwrap();
        let gap = surface::ellipsoid(grid, 9.0, 7.0).unwrap();
        let friction = || kit::coulomb(0.4);
        let load =
            TangentialLoad::force([0.01, 0.0]).along(Axis::Y, TangentialControl::Shift(0.002));
        let press = NormalLoad::Force(0.08);
        let full = CoupledProblem::builder(&bodies, &gap, friction(), press, load);
        let full = kit::solve(full.tolerance(1e-12));
        let given = TangentialProblem::builder(&bodies, full.normal().pressure(), friction(), load);
        let found = given
            .model(TangentialModel::Vector)
            .tolerance(1e-12)
            .build()
            .unwrap();
        let found = found.solve().unwrap();
        assert!(full.tangential().stick_ratio() > 0.1 && full.tangential().stick_ratio() < 0.95);
        let largest = full.tangential().traction()[0].max();
        for axis in 0..2 {
            let [a, b] =
                [full.tangential().traction(), found.traction()].map(|q| q[axis].as_slice());
            assert!(
                max_difference(a, b) < 1e-9 * largest,
                "{:e}",
                max_difference(a, b) / largest
            );
            let (a, b) = (full.tangential().shift()[axis], found.shift()[axis]);
            assert!((a - b).abs() < 1e-9, "{a} {b}");
            let [a, b] = [full.tangential().slip(), found.slip()].map(|slip| slip[axis].as_slice());
            assert!(max_difference(a, b) < 1e-9, "{:e}", max_difference(a, b));
        }
        assert!(found.report().duality_gap < 1e-12);
    }
}

fn ball(beta: f64) -> (HalfSpace, Field) {
    let grid = kit::square(33, 2.6);
    let bodies = HalfSpace::new(grid, on_rigid(beta)).unwrap();
    (bodies, kit::sphere(grid, 10.0))
}

fn history(bodies: &HalfSpace, gap: &Field, coupling: Coupling) -> History {
    History::builder(bodies, gap, kit::coulomb(0.3))
        .coupling(coupling)
        .model(TangentialModel::Vector)
        .entry_rule(stickslip::history::EntryRule::WholeStep)
        .tolerance(1e-9)
        .build()
        .unwrap()
}

/// Takes steps of all types: pressing, shear, twist, unloading, wear, separation, and renewed pressing.
fn steps(history: &mut History, mut seen: impl FnMut(usize, &History)) {
    let press = |force| LoadStep::hold().normal(NormalLoad::Force(force));
    let path = [
        press(0.05),
        press(0.1),
        press(0.1).tangential(Axis::X, TangentialControl::Force(0.01)),
        press(0.12).tangential(Axis::Y, TangentialControl::Shift(0.01)),
        LoadStep::hold().twist(0.02),
        press(0.03).tangential(Axis::X, TangentialControl::Force(-0.005)),
        press(0.0).tangential(Axis::X, TangentialControl::Hold),
        LoadStep::hold().normal(NormalLoad::Approach(0.05)),
        press(0.06).tangential(Axis::Y, TangentialControl::Force(0.005)),
    ];
    for (number, load) in path.iter().enumerate() {
        if number == 5 {
            let worn = Field::from_fn(history.grid(), |x, y| 1e-3 * (0.5 - x * x - y * y).max(0.0));
            let mut gap = history.unloaded_gap().clone();
            gap.add_scaled(1.0, &worn).unwrap();
            history.set_gap(&gap).unwrap();
        }
        history.step(load).unwrap();
        seen(number, history);
    }
}

/// The error of the tractions with one-way coupling is of the order of beta: in all steps they approach the tractions of
/// full coupling.
#[test]
fn one_way_error_vanishes_with_beta() {
    let differences = [0.2, 0.1, 0.05].map(|beta| {
        let (bodies, gap) = ball(beta);
        let mut full = history(&bodies, &gap, Coupling::Full);
        let mut fields = Vec::new();
        steps(&mut full, |_, history| {
            fields.push(history.traction().map(Field::clone));
        });
        let mut one_way = history(&bodies, &gap, Coupling::OneWay);
        let mut largest = 0.0_f64;
        steps(&mut one_way, |number, history| {
            let [x, y] = [0, 1].map(|axis| {
                let (full, found) = (&fields[number][axis], history.traction()[axis]);
                l2_difference(found.as_slice(), full.as_slice())
            });
            if history.pressure().max() > 0.0 {
                largest = largest.max(x.max(y));
            }
        });
        largest
    });
    // The error is proportional to beta for this friction.
    assert!(differences[0] < 0.1, "{differences:?}");
    for pair in differences.windows(2) {
        assert!(pair[1] < 0.55 * pair[0], "{differences:?}");
    }
}

/// A history that returns to a state with a different coupling continues with the coupling of that state.
#[test]
fn set_state_takes_coupling_of_state() {
    let (bodies, gap) = ball(0.4);
    let all = [Coupling::Full, Coupling::OneWay, Coupling::Neglected];
    let press = |force| LoadStep::hold().normal(NormalLoad::Force(force));
    let started = all.map(|coupling| {
        let mut history = history(&bodies, &gap, coupling);
        history.step(&press(0.1)).unwrap();
        history
    });
    let next = press(0.12).tangential(Axis::X, TangentialControl::Force(0.01));
    for from in &started {
        for to in &started {
            let (mut returned, mut expected) = (from.clone(), to.clone());
            returned.set_state(to.state()).unwrap();
            returned.step(&next).unwrap();
            expected.step(&next).unwrap();
            assert!(returned.to_bytes() == expected.to_bytes());
        }
    }
}

/// The scalar model with one-way coupling warns if the tractions across its axis are not small compared with the friction
/// limit. Other models, stronger friction, frictionless contacts and contacts that do not vary across the axis do not warn.
#[test]
fn scalar_model_warns_of_neglected_tractions() {
    let warned = |coefficient, coupling, model| {
        let (bodies, gap) = ball(0.2);
        let builder = History::builder(&bodies, &gap, kit::coulomb(coefficient));
        let mut history = builder.coupling(coupling).model(model).build().unwrap();
        let press = LoadStep::hold().normal(NormalLoad::Force(0.1));
        history.step(&press).unwrap();
        neglected(&history.last_step().unwrap().warnings())
    };
    let (scalar, vector) = (TangentialModel::Scalar, TangentialModel::Vector);
    assert_eq!(warned(0.25, Coupling::OneWay, scalar), Some(80));
    assert_eq!(warned(0.5, Coupling::OneWay, scalar), None);
    assert_eq!(warned(0.0, Coupling::OneWay, scalar), None);
    assert_eq!(warned(0.25, Coupling::OneWay, vector), None);
    assert_eq!(warned(0.25, Coupling::Full, scalar), None);
    assert_eq!(warned(0.25, Coupling::Neglected, scalar), None);

    let cylinder = |rows: usize, axis: Axis| {
        let grid = Grid::new(32, rows, 0.075, 0.1).unwrap();
        let boundary = Boundary::PeriodicAlongY { datum: 10.0 };
        let bodies = HalfSpace::with_boundary(grid, on_rigid(0.2), boundary).unwrap();
        let gap = Field::from_fn(grid, |x, _| 0.05 * x * x);
        let force = NormalLoad::Force(2e-3 * rows as f64);
        let normal = kit::solve(NormalProblem::builder(&bodies, &gap, force));
        let mut shift = [0.0; 2];
        shift[axis.index()] = 1e-6;
        let load = TangentialLoad::shift(shift);
        let builder = TangentialProblem::builder(&bodies, &normal, kit::coulomb(0.2), load);
        neglected(&kit::solve(builder).warnings())
    };
    assert_eq!(cylinder(1, Axis::X), None);
    assert_eq!(cylinder(4, Axis::X), None);
    assert_eq!(cylinder(4, Axis::Y), Some(100));
}

/// Returns the ratio of a warning about neglected tractions in per cent.
fn neglected(warnings: &[Warning]) -> Option<usize> {
    warnings.iter().find_map(|warning| match *warning {
        Warning::NeglectedTraction { per_cent } => Some(per_cent),
        _ => None,
    })
}
