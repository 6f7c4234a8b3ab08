//! The stiffness of a contact agrees with differences of solves and with closed forms.

use std::ops::ControlFlow;

use stickslip::analytical::{CattaneoMindlin, HertzSphere};
use stickslip::history::HistoryBuilder;
use stickslip::normal::Hardness;
use stickslip::stiffness::{ContactStiffness, StiffnessWorkspace};
use stickslip::{
    Axis, Boundary, CoupledProblem, CoupledSolution, Coupling, ElasticPair, Error, Field, Friction,
    Grid, HalfSpace, History, LoadStep, Material, NormalLoad, NormalProblem, NormalSolution,
    TangentialControl, TangentialLoad, TangentialModel, TangentialProblem, TangentialSolution,
};

const FRICTION: f64 = 0.4;
const SOLVE: f64 = 1e-12;

struct StiffnessCase {
    bodies: HalfSpace,
    gap: Field,
    friction: Friction,
    model: TangentialModel,
}

impl StiffnessCase {
    fn ball(cells: usize, poisson_ratio: f64, model: TangentialModel) -> Self {
        let grid = kit::square(cells, 12.0);
        Self {
            bodies: kit::unit_bodies(grid, poisson_ratio),
            gap: kit::sphere(grid, 20.0),
            friction: kit::coulomb(FRICTION),
            model,
        }
    }

    fn rough(boundary: Boundary, model: TangentialModel) -> Self {
        let grid = Grid::new(48, 40, 2.0, 2.5).unwrap();
        let bodies = HalfSpace::with_boundary(grid, kit::unit_pair(0.3), boundary).unwrap();
        let mut gap = kit::rough(kit::square(48, 96.0), 4);
        let heights = gap.as_mut_slice()[..grid.cells()].to_vec();
        gap = Field::from_vec(grid, heights).unwrap();
        Self {
            bodies,
            gap,
            friction: kit::coulomb(FRICTION),
            model,
        }
    }

    fn press(&self, control: NormalLoad) -> NormalSolution {
        let problem = NormalProblem::builder(&self.bodies, &self.gap, control).tolerance(SOLVE);
        kit::solve(problem)
    }

    fn shear(&self, normal: &NormalSolution, load: TangentialLoad) -> TangentialSolution {
        kit::solve(
            TangentialProblem::builder(&self.bodies, normal, self.friction.clone(), load)
                .model(self.model)
                .tolerance(SOLVE),
        )
    }
}

fn moment(solution: &TangentialSolution) -> f64 {
    let [qx, qy] = solution.traction();
    let grid = solution.grid();
    let arm = |i: usize| [grid.x(i % grid.nx()), grid.y(i / grid.nx())];
    let turn = |i: usize| arm(i)[0] * qy.as_slice()[i] - arm(i)[1] * qx.as_slice()[i];
    (0..grid.cells()).map(turn).sum::<f64>() * grid.cell_area()
}

fn loads(solution: &TangentialSolution) -> [f64; 3] {
    let [x, y] = solution.force();
    [x, y, moment(solution)]
}

/// Replaces entries that the model does not have by NaN.
fn numbers(matrix: [[Option<f64>; 3]; 3]) -> [[f64; 3]; 3] {
    matrix.map(|row| row.map(|entry| entry.unwrap_or(f64::NAN)))
}

fn close(found: f64, expected: f64, scale: f64, what: &str) {
    let error = (found - expected).abs() / scale;
    assert!(
        error < 1e-8,
        "{what}: {found:e} for {expected:e}, {error:e}"
    );
}

#[test]
fn normal_stiffness_matches_difference_of_forces() {
    for scene in [
        StiffnessCase::ball(48, 0.3, TangentialModel::Scalar),
        StiffnessCase::rough(Boundary::NonPeriodic, TangentialModel::Scalar),
        StiffnessCase::rough(Boundary::Periodic, TangentialModel::Scalar),
    ] {
        let contact = scene.press(NormalLoad::Force(6.0));
        let stiffness = contact.stiffness(&scene.bodies).unwrap();
        assert!(stiffness.bound <= 1e-10);
        let step = 1e-6 * contact.approach().abs();
        let [more, less] = [step, -step].map(|step| {
            let solution = scene.press(NormalLoad::Approach(contact.approach() + step));
            assert_eq!(solution.contact_cells(), contact.contact_cells());
            solution.force()
        });
        // The remaining error is the round-off of the difference.
        let slope = (more - less) / (2.0 * step);
        assert!((slope / stiffness.value - 1.0).abs() < 1e-6, "{slope:e}");
        // A larger step within the same active set has less round-off.
        let step = 100.0 * step;
        let [more, less] = [step, -step].map(|step| {
            let solution = scene.press(NormalLoad::Approach(contact.approach() + step));
            (solution.contact_cells(), solution.force())
        });
        if more.0 == contact.contact_cells() && less.0 == more.0 {
            let slope = (more.1 - less.1) / (2.0 * step);
            close(slope, stiffness.value, stiffness.value, "slope");
        }
    }
}

/// The normal stiffness of Hertz is 2 E* a. The tangential stiffness of Mindlin is this value times the ratio of the
/// compliances. Averaged over several loads, the error due to the staircase-shaped edge decreases with the cell size.
#[test]
fn stiffness_converges_to_hertz_and_mindlin() {
    let poisson = 0.3;
    let mean_errors = |cells: usize| {
        let scene = StiffnessCase::ball(cells, poisson, TangentialModel::Scalar);
        let loads = [5.0, 5.3, 5.6, 5.9, 6.2, 6.5, 6.8, 7.1];
        let errors = loads.map(|load| {
            let normal = scene.press(NormalLoad::Force(load));
            let hertz = HertzSphere::new(scene.bodies.pair(), 20.0, load).unwrap();
            let exact = 2.0 * scene.bodies.pair().contact_modulus() * hertz.contact_radius();
            let shear = scene.shear(&normal, TangentialLoad::force([0.1, 0.0]));
            let mindlin = exact * 2.0 * (1.0 - poisson) / (2.0 - poisson);
            let sheared = shear.stiffness(&scene.bodies).unwrap();
            [
                normal.stiffness(&scene.bodies).unwrap().value / exact - 1.0,
                numbers(sheared.reversal)[0][0] / mindlin - 1.0,
            ]
        });
        [0, 1].map(|kind| errors.iter().map(|error| error[kind].abs()).sum::<f64>() / 8.0)
    };
    let (coarse, fine) = (mean_errors(24), mean_errors(96));
    for kind in [0, 1] {
        assert!(coarse[kind] < 0.02, "{coarse:?}");
        assert!(fine[kind] < 0.3 * coarse[kind], "{coarse:?} {fine:?}");
    }
}

/// Without Poisson's effect the stiffness under the tangential force F equals the stiffness under the normal force W -
/// F/mu. This holds for any surface and also on the grid.
#[test]
fn partial_slip_stiffness_is_that_of_lighter_contact() {
    for model in [TangentialModel::Scalar, TangentialModel::Vector] {
        let scene = StiffnessCase::ball(64, 0.0, model);
        let load = 6.0;
        let normal = scene.press(NormalLoad::Force(load));
        let full = normal.stiffness(&scene.bodies).unwrap();
        let pair = scene.bodies.pair();
        let hertz = HertzSphere::new(pair, 20.0, load).unwrap();
        for part in [0.1, 0.3, 0.5, 0.7, 0.9] {
            let force = part * FRICTION * load;
            let shear = scene.shear(&normal, TangentialLoad::force([force, 0.0]));
            let found =
                ContactStiffness::new(&scene.bodies, &normal, &scene.friction, &shear).unwrap();
            let lighter = scene.press(NormalLoad::Force(load - force / FRICTION));
            let stick = lighter.stiffness(&scene.bodies).unwrap();
            let [loading, reversal] = [found.tangential.loading, found.tangential.reversal]
                .map(|matrix| numbers(matrix)[0][0]);
            let relative = loading / stick.value - 1.0;
            // Cells at the edge of the stick zone may be counted on either side.
            assert!(relative.abs() < 1e-8, "{part}: {relative:e}");
            assert!((reversal / full.value - 1.0).abs() < 1e-9);
            assert!((found.normal.value / full.value - 1.0).abs() < 1e-12);
            // The force is F = mu (W - W'), where the approach of W' is reduced by the shift divided by mu. Its
            // derivative is taken for a fixed shift.
            let exact = FRICTION * (full.value - stick.value);
            assert!((found.by_approach[0].unwrap() / exact - 1.0).abs() < 1e-8);
            let closed = CattaneoMindlin::new(hertz, FRICTION, force).unwrap();
            let slope = 2.0 * pair.contact_modulus() * closed.stick_radius();
            assert!((loading / slope - 1.0).abs() < 0.05);
        }
    }
}

#[test]
fn loading_stiffness_matches_differences_in_vector_model() {
    for (scene, twist) in [
        (StiffnessCase::ball(40, 0.3, TangentialModel::Vector), 4e-3),
        (
            StiffnessCase::rough(Boundary::NonPeriodic, TangentialModel::Vector),
            1e-3,
        ),
        (
            StiffnessCase::rough(Boundary::Periodic, TangentialModel::Vector),
            0.0,
        ),
    ] {
        let normal = scene.press(NormalLoad::Force(6.0));
        let along = scene.shear(&normal, TangentialLoad::force([1.2, 0.6]));
        let shift = along.shift();
        let load =
            |motion: [f64; 3]| TangentialLoad::shift([motion[0], motion[1]]).twist(motion[2]);
        let motion = [shift[0], shift[1], twist];
        let shear = scene.shear(&normal, load(motion));
        let found = shear.stiffness(&scene.bodies).unwrap();
        assert!(found.bound <= 1e-10);
        let loading = numbers(found.loading);
        let modes = if twist > 0.0 { 3 } else { 2 };
        for column in 0..modes {
            let scale = if column < 2 { shift[0].abs() } else { twist };
            // The difference is accurate to second order in the step, and is then extrapolated.
            let slope = |part: f64| {
                let at = |sign: f64| {
                    let mut moved = motion;
                    moved[column] += sign * part * scale;
                    loads(&scene.shear(&normal, load(moved)))
                };
                let (more, less) = (at(1.0), at(-1.0));
                [0, 1, 2].map(|row| (more[row] - less[row]) / (2.0 * part * scale))
            };
            let (wide, narrow) = (slope(4e-4), slope(2e-4));
            for row in 0..modes {
                let extrapolated = (4.0 * narrow[row] - wide[row]) / 3.0;
                let size = (loading[row][row] * loading[column][column]).sqrt();
                let error = (extrapolated - loading[row][column]).abs() / size;
                assert!(error < 1e-8, "{row} {column}: {error:e}");
                let mirrored = loading[column][row];
                assert!((loading[row][column] - mirrored).abs() < 1e-9 * size);
            }
        }
    }
}

#[test]
fn pressing_increases_force_by_limit_of_slipping_cells() {
    let mut scene = StiffnessCase::ball(40, 0.3, TangentialModel::Vector);
    for cap in [f64::INFINITY, 0.08] {
        if cap.is_finite() {
            scene.friction = Friction::coulomb(FRICTION)
                .unwrap()
                .max_shear_stress(cap)
                .unwrap();
        }
        let normal = scene.press(NormalLoad::Force(6.0));
        let shift = scene
            .shear(&normal, TangentialLoad::force([0.9, 0.4]))
            .shift();
        let load = TangentialLoad::shift(shift).twist(2e-3);
        let shear = scene.shear(&normal, load);
        let found = ContactStiffness::new(&scene.bodies, &normal, &scene.friction, &shear).unwrap();
        let slope = |part: f64| {
            let at = |sign: f64| {
                let approach = normal.approach() * (1.0 + sign * part);
                loads(&scene.shear(&scene.press(NormalLoad::Approach(approach)), load))
            };
            let (more, less) = (at(1.0), at(-1.0));
            [0, 1, 2].map(|row| (more[row] - less[row]) / (2.0 * part * normal.approach()))
        };
        let (wide, narrow) = (slope(4e-4), slope(2e-4));
        let by_approach = found.by_approach.map(Option::unwrap);
        let scale = by_approach[0].abs() + numbers(found.tangential.loading)[0][0] * 1e-3;
        for row in 0..3 {
            let error = ((4.0 * narrow[row] - wide[row]) / 3.0 - by_approach[row]).abs() / scale;
            assert!(error < 1e-8, "{row}: {error:e} of {by_approach:?}");
        }
    }
}

/// The loading stiffness of a history is the difference quotient of a further step. The reversal stiffness is the
/// difference quotient of a step back.
#[test]
fn history_stiffness_matches_steps_forward_and_back() {
    let scene = StiffnessCase::ball(48, 0.3, TangentialModel::Scalar);
    let builder = History::builder(&scene.bodies, &scene.gap, scene.friction.clone());
    let mut history = builder.axis(Axis::Y).tolerance(SOLVE).build().unwrap();
    assert_eq!(history.stiffness().unwrap().normal.value, 0.0);
    let press = LoadStep::hold().normal(NormalLoad::Force(6.0));
    history.step(&press).unwrap();
    let shear = |force| LoadStep::hold().tangential(Axis::Y, TangentialControl::Force(force));
    history.step(&shear(1.3)).unwrap();
    history.step(&shear(0.4)).unwrap();
    let (found, start) = (history.stiffness().unwrap(), history.state().clone());
    let (shift, force) = (history.shift()[1], history.tangential_force()[1]);
    let mut slope = |step: f64| {
        history.set_state(&start).unwrap();
        let moved = TangentialControl::Shift(shift + step);
        history
            .step(&LoadStep::hold().tangential(Axis::Y, moved))
            .unwrap();
        (history.tangential_force()[1] - force) / step
    };
    let step = 1e-6 * shift.abs();
    let [loading, own] =
        [found.tangential.loading, found.tangential.reversal].map(|matrix| numbers(matrix)[1][1]);
    assert!((slope(-step) / loading - 1.0).abs() < 1e-6);
    assert!((slope(step) / own - 1.0).abs() < 1e-6);
    assert!(loading < own);

    // In series with a spring of the same stiffness, half of the stiffness remains.
    let felt = found.tangential.in_series_with([own, own]).unwrap();
    assert!((numbers(felt.reversal)[1][1] / own - 0.5).abs() < 1e-12);
    assert_eq!(felt.reversal[0], [None; 3]);
    kit::assert_refused! { found.tangential.in_series_with([1.0, -1.0]) => Error::NotPositive { .. } }
}

/// A fully sliding contact has no stiffness along the direction of slip in either model.
#[test]
fn sliding_contact_has_no_stiffness_along_slip() {
    for model in [TangentialModel::Scalar, TangentialModel::Vector] {
        let scene = StiffnessCase::ball(32, 0.0, model);
        let normal = scene.press(NormalLoad::Force(6.0));
        let stuck = scene.shear(&normal, TangentialLoad::force([0.1, 0.0]));
        let shear = scene.shear(&normal, TangentialLoad::shift([5.0, 0.0]));
        assert!(shear.is_gross_slip());
        let found = ContactStiffness::new(&scene.bodies, &normal, &scene.friction, &shear).unwrap();
        let full = numbers(stuck.stiffness(&scene.bodies).unwrap().reversal)[0][0];
        assert!(numbers(found.tangential.loading)[0][0].abs() < 1e-6 * full);
        assert!((numbers(found.tangential.reversal)[0][0] / full - 1.0).abs() < 1e-9);
        // The friction force increases proportionally to the normal force.
        let expected = FRICTION * found.normal.value;
        assert!((found.by_approach[0].unwrap() / expected - 1.0).abs() < 1e-6);
    }
}

/// If all cells slip in the same oblique direction, their tractions rotate in the same way. Two motions then have a
/// single response, and the twist of a single cell has no response.
#[test]
fn dependent_motions_of_sliding_cells_are_handled() {
    let scene = StiffnessCase::ball(32, 0.0, TangentialModel::Vector);
    let normal = scene.press(NormalLoad::Force(6.0));
    let straight = scene.shear(&normal, TangentialLoad::shift([5.0, 0.0]));
    let across = numbers(straight.stiffness(&scene.bodies).unwrap().loading)[1][1];
    let oblique = scene.shear(&normal, TangentialLoad::shift([3.0, 4.0]));
    assert!(oblique.is_gross_slip());
    let found = oblique.stiffness(&scene.bodies).unwrap();
    assert!((0.0..=1e-10).contains(&found.bound));
    let loading = numbers(found.loading);
    // The stiffness across the slip is the same, rotated.
    let normal_to_slip = [-0.8, 0.6];
    for (row, x) in normal_to_slip.into_iter().enumerate() {
        for (column, y) in normal_to_slip.into_iter().enumerate() {
            let error = loading[row][column] - across * x * y;
            assert!(error.abs() < 1e-2 * across, "{row} {column}: {error:e}");
        }
    }
    let mut single = Field::zeros(normal.grid());
    single.as_mut_slice()[7 * 32 + 9] = 1.0;
    let friction = scene.friction.clone();
    let load = TangentialLoad::shift([3.0, 4.0]);
    let problem = TangentialProblem::builder(&scene.bodies, &single, friction, load);
    let shear = kit::solve(problem.model(TangentialModel::Vector));
    let found = shear.stiffness(&scene.bodies).unwrap();
    let [loading, reversal] = [found.loading, found.reversal].map(numbers);
    let mut entries = loading.iter().chain(&reversal).flatten();
    assert!(entries.all(|entry| entry.is_finite()));
    let [a, b] = [loading[0][0] * loading[1][1], loading[0][1].powi(2)];
    assert!((a / b - 1.0).abs() < 1e-9 && reversal[0][0] > loading[0][0]);
}

/// The scalar model includes neither the motion across its axis nor the twist, so their entries are `None` instead of
/// zero.
#[test]
fn scalar_model_has_stiffness_of_one_motion() {
    let scene = StiffnessCase::ball(24, 0.3, TangentialModel::Scalar);
    let normal = scene.press(NormalLoad::Force(6.0));
    for axis in [0, 1] {
        let mut force = [0.0; 2];
        force[axis] = 0.5;
        let shear = scene.shear(&normal, TangentialLoad::force(force));
        let found = ContactStiffness::new(&scene.bodies, &normal, &scene.friction, &shear).unwrap();
        for matrix in [found.tangential.loading, found.tangential.reversal] {
            for (load, row) in matrix.iter().enumerate() {
                for (motion, entry) in row.iter().enumerate() {
                    assert_eq!(entry.is_some(), load == axis && motion == axis);
                }
            }
            assert!(matrix[axis][axis] > Some(0.0));
        }
        let present = found.by_approach.map(|slope| slope.is_some());
        assert_eq!(present, [axis == 0, axis == 1, false]);
    }
    // Without contact the entries of the model are zero.
    let builder = History::builder(&scene.bodies, &scene.gap, scene.friction.clone());
    let apart = builder.build().unwrap().stiffness().unwrap();
    assert_eq!(apart.tangential.loading[0], [Some(0.0), None, None]);
    assert_eq!(apart.by_approach, [Some(0.0), None, None]);
}

/// The normal and tangential parts of a coupled solution depend on each other, so neither part has its own stiffness.
#[test]
fn parts_of_coupled_solution_are_rejected() {
    let grid = kit::square(16, 3.0);
    let gap = kit::sphere(grid, 10.0);
    let friction = kit::coulomb(FRICTION);
    let press = NormalLoad::Force(0.1);
    let load = TangentialLoad::force([0.01, 0.0]);
    let solve = |pair: ElasticPair| {
        let bodies = HalfSpace::new(grid, pair).unwrap();
        let problem = CoupledProblem::builder(&bodies, &gap, friction.clone(), press, load);
        let contact = kit::solve(problem);
        (bodies, contact)
    };
    let dissimilar = kit::on_rigid(1.0, 0.0);
    let (bodies, contact) = solve(dissimilar);
    let (normal, shear) = (contact.normal(), contact.tangential());
    let beta = dissimilar.dundurs_beta();
    let is_refused = |error: Option<Error>| matches!(error, Some(Error::CoupledMaterials { beta: found, .. }) if found == beta);
    let both = ContactStiffness::new(&bodies, normal, &friction, shear);
    assert!(is_refused(both.err()));
    assert!(is_refused(normal.stiffness(&bodies).err()));
    assert!(is_refused(shear.stiffness(&bodies).err()));
    // A coupled solution with one part replaced by a solution without coupling is rejected as well.
    let alone = NormalProblem::builder(&bodies, &gap, press);
    let alone = kit::solve(alone);
    assert!(alone.stiffness(&bodies).is_ok());
    let mixed = ContactStiffness::new(&bodies, &alone, &friction, shear);
    assert!(is_refused(mixed.err()));
    // For uncoupled bodies the two parts are independent solutions.
    let (bodies, contact) = solve(kit::unit_pair(0.3));
    let both = ContactStiffness::new(&bodies, contact.normal(), &friction, contact.tangential());
    assert!(both.is_ok());
}

/// The stiffness of a coupled solution agrees with differences of solves from rest, with partial slip and with more
/// slip.
#[test]
fn coupled_stiffness_matches_differences_of_solves() {
    let grid = kit::square(24, 3.0);
    let gap = kit::sphere(grid, 10.0);
    let friction = kit::coulomb(FRICTION);
    let bodies = HalfSpace::new(grid, kit::on_rigid(1.0, 0.2)).unwrap();
    let solve = |approach: f64, shift: [f64; 2]| {
        let (press, load) = (NormalLoad::Approach(approach), TangentialLoad::shift(shift));
        let problem = CoupledProblem::builder(&bodies, &gap, friction.clone(), press, load);
        kit::solve(problem.tolerance(SOLVE))
    };
    let loads = |contact: &CoupledSolution| {
        let [x, y] = contact.tangential().force();
        [contact.normal().force(), x, y]
    };
    for shift in [0.004, 0.015] {
        let contact = solve(0.1, [shift, 0.5 * shift]);
        let stiffness = contact.stiffness(&bodies, &friction).unwrap();
        let loading = numbers(stiffness.tangential.loading);
        let scale = stiffness.normal.value;
        let step = 1e-7;
        let slope = |more: CoupledSolution, less: CoupledSolution| {
            let (more, less) = (loads(&more), loads(&less));
            [0, 1, 2].map(|load| (more[load] - less[load]) / (2.0 * step))
        };
        let moved = |step: f64| solve(0.1, [shift + step, 0.5 * shift]);
        let along = slope(moved(step), moved(-step));
        let expected = [
            stiffness.normal_by_motion[0].unwrap(),
            loading[0][0],
            loading[1][0],
        ];
        let pressed = |step: f64| solve(0.1 + step, [shift, 0.5 * shift]);
        let press = slope(pressed(step), pressed(-step));
        let by_press = [
            scale,
            stiffness.by_approach[0].unwrap(),
            stiffness.by_approach[1].unwrap(),
        ];
        for (found, expected) in along
            .into_iter()
            .zip(expected)
            .chain(press.into_iter().zip(by_press))
        {
            let error = (found - expected).abs() / scale;
            assert!(
                error < 1e-6,
                "{shift}: {found:e} for {expected:e}, {error:e}"
            );
        }
    }
}

/// A periodic grid cannot rotate, so the row and the column of the twist are empty.
#[test]
fn periodic_grid_has_no_twist_stiffness() {
    let scene = StiffnessCase::rough(Boundary::Periodic, TangentialModel::Vector);
    let normal = scene.press(NormalLoad::Force(6.0));
    let shear = scene.shear(&normal, TangentialLoad::force([0.5, 0.2]));
    let found = ContactStiffness::new(&scene.bodies, &normal, &scene.friction, &shear).unwrap();
    for matrix in [found.tangential.loading, found.tangential.reversal] {
        assert!(matrix[2] == [None; 3] && matrix.iter().all(|row| row[2].is_none()));
        assert!(matrix[0][0] > Some(0.0) && matrix[1][1] > Some(0.0));
    }
    assert_eq!(found.by_approach[2], None);
}

#[test]
fn different_bodies_and_closed_gaps_are_rejected() {
    let scene = StiffnessCase::ball(32, 0.3, TangentialModel::Scalar);
    let normal = scene.press(NormalLoad::Force(6.0));
    let shear = scene.shear(&normal, TangentialLoad::force([1.0, 0.0]));
    let other = StiffnessCase::ball(31, 0.3, TangentialModel::Scalar);
    let refused = normal.stiffness(&other.bodies);
    assert!(matches!(refused, Err(Error::GridMismatch { .. })));
    let refused = shear.stiffness(&other.bodies);
    assert!(matches!(refused, Err(Error::GridMismatch { .. })));
    let softer = Material::new(0.5, 0.3).unwrap();
    let pair = ElasticPair::new(softer, softer).unwrap();
    let softer = HalfSpace::new(normal.grid(), pair).unwrap();
    kit::assert_refused! { normal.stiffness(&softer) => Error::MaterialMismatch { .. } }

    // A flat periodic contact has an infinite stiffness.
    let grid = kit::square(8, 1.0);
    let bodies = HalfSpace::with_boundary(grid, *scene.bodies.pair(), Boundary::Periodic).unwrap();
    let flat = Field::zeros(grid);
    let contact = NormalProblem::builder(&bodies, &flat, NormalLoad::Force(1.0));
    let contact = kit::solve(contact);
    kit::assert_refused! { contact.stiffness(&bodies) => Error::NotFinite { .. } }
}

/// Covers steps in which the contact grows, with and without slip. The test compares the derivatives of the loads with
/// respect to the motion and the approach at the end of the step.
#[test]
fn growing_contact_stiffness_matches_whole_steps() {
    use TangentialModel::{Scalar, Vector};
    for scene in [
        StiffnessCase::ball(48, 0.0, Scalar),
        StiffnessCase::ball(48, 0.3, Vector),
        StiffnessCase::rough(Boundary::NonPeriodic, Vector),
        StiffnessCase::rough(Boundary::Periodic, Vector),
    ] {
        let builder = History::builder(&scene.bodies, &scene.gap, scene.friction.clone());
        assert_stiffness_matches_steps(&scene, builder.model(scene.model));
    }
}

/// The pressure of cells at the hardness does not increase with the approach.
#[test]
fn yielding_contact_stiffness_matches_steps() {
    let mut coupled = StiffnessCase::ball(32, 0.3, TangentialModel::Vector);
    coupled.bodies = HalfSpace::new(coupled.gap.grid(), kit::on_rigid(1.0, 0.2)).unwrap();
    for scene in [
        StiffnessCase::ball(48, 0.3, TangentialModel::Scalar),
        StiffnessCase::ball(48, 0.3, TangentialModel::Vector),
        coupled,
    ] {
        let elastic = scene.press(NormalLoad::Force(6.0));
        let hardness = Hardness::uniform(0.7 * elastic.pressure().max()).unwrap();
        let builder = History::builder(&scene.bodies, &scene.gap, scene.friction.clone());
        let builder = builder.model(scene.model).hardness(hardness);
        assert_stiffness_matches_steps(&scene, builder);
    }
}

/// With one-way coupling, pressing causes tractions because the pressure displaces the surfaces tangentially.
#[test]
fn one_way_coupled_stiffness_matches_steps() {
    let mut scene = StiffnessCase::ball(48, 0.3, TangentialModel::Vector);
    scene.bodies = HalfSpace::new(scene.gap.grid(), kit::on_rigid(1.0, 0.2)).unwrap();
    let builder = History::builder(&scene.bodies, &scene.gap, scene.friction.clone());
    let builder = builder.model(scene.model).coupling(Coupling::OneWay);
    assert_stiffness_matches_steps(&scene, builder);
}

/// With full coupling, all loads are differentiated with respect to all motions for a ball, a rough surface and a
/// periodic surface.
#[test]
fn fully_coupled_stiffness_matches_steps() {
    for &poisson_ratio in kit::thorough(&[0.3][..], &[0.45, 0.3, 0.0]) {
        let mut scenes = vec![StiffnessCase::ball(32, 0.3, TangentialModel::Vector)];
        if poisson_ratio == 0.3 {
            scenes.push(StiffnessCase::rough(
                Boundary::NonPeriodic,
                TangentialModel::Vector,
            ));
            scenes.push(StiffnessCase::rough(
                Boundary::Periodic,
                TangentialModel::Vector,
            ));
        }
        for mut scene in scenes {
            let (grid, boundary) = (scene.gap.grid(), scene.bodies.boundary());
            scene.bodies =
                HalfSpace::with_boundary(grid, kit::on_rigid(1.0, poisson_ratio), boundary)
                    .unwrap();
            let builder = History::builder(&scene.bodies, &scene.gap, scene.friction.clone());
            assert_stiffness_matches_steps(&scene, builder);
        }
    }
}

/// Asserts that central differences of whole steps, from a contact to a larger one, agree with the stiffness at the
/// end.
fn assert_stiffness_matches_steps(scene: &StiffnessCase, builder: HistoryBuilder<'_>) {
    let [low, deep] = [3.0, 6.0].map(|force| scene.press(NormalLoad::Force(force)).approach());
    let growth = deep - low;
    let first = builder.tolerance(SOLVE).build().unwrap();
    let axes = if scene.model == TangentialModel::Vector {
        2
    } else {
        1
    };
    for part in [0.1, 0.35] {
        let across = if axes == 2 { 0.4 } else { 0.0 };
        let shift = [part * growth, across * part * growth];
        let load = |approach: f64, shift: [f64; 2]| {
            LoadStep::shift(shift).normal(NormalLoad::Approach(approach))
        };
        let mut start = first.clone();
        start.step(&load(low, [0.0; 2])).unwrap();
        start.step(&load(low, shift.map(|s| 0.5 * s))).unwrap();
        let taken = |approach: f64, shift: [f64; 2]| {
            let mut history = start.clone();
            history.step(&load(approach, shift)).unwrap();
            history
        };
        let end = taken(deep, shift);
        let stiffness = end.stiffness().unwrap();
        let small = 1e-5 * growth;
        let slope = |change: [f64; 3]| {
            let [more, less] = [small, -small].map(|h| {
                let [z, x, y] = change.map(|part| h * part);
                let moved = taken(deep + z, [shift[0] + x, shift[1] + y]);
                assert_eq!(moved.zones(), end.zones());
                let [fx, fy] = moved.tangential_force();
                [moved.normal().force(), fx, fy]
            });
            [0, 1, 2].map(|load| (more[load] - less[load]) / (2.0 * small))
        };
        let scale = numbers(stiffness.tangential.reversal)[0][0];
        let loading = numbers(stiffness.tangential.loading);
        let by_approach = stiffness.by_approach.map(|load| load.unwrap_or(f64::NAN));
        let (along_x, by_press) = (slope([0.0, 1.0, 0.0]), slope([1.0, 0.0, 0.0]));
        let pressed = stiffness.normal_by_motion[0].unwrap();
        let mut errors = vec![by_press[0] - stiffness.normal.value, along_x[0] - pressed];
        for axis in 0..axes {
            errors.push(along_x[1 + axis] - loading[axis][0]);
            errors.push(by_press[1 + axis] - by_approach[axis]);
        }
        for error in &errors {
            assert!((error / scale).abs() < 1e-6, "{part}: {errors:?}");
        }
    }
}

/// A stiffness computed in reused buffers, including buffers of other contacts, is bitwise identical. Without the
/// reversal matrix all other entries are identical.
#[test]
fn reused_buffers_do_not_change_stiffness() {
    let go_on = |_: &_| ControlFlow::Continue(());
    let mut workspace = StiffnessWorkspace::new();
    let mut half = StiffnessWorkspace::new().reversal(false);
    for (poisson_ratio, model) in [
        (0.0, TangentialModel::Scalar),
        (0.3, TangentialModel::Vector),
        (0.3, TangentialModel::Scalar),
    ] {
        let scene = StiffnessCase::ball(32, poisson_ratio, model);
        let mut history = History::builder(&scene.bodies, &scene.gap, scene.friction.clone())
            .model(model)
            .build()
            .unwrap();
        for approach in [0.2, 0.4, 0.3] {
            let press = LoadStep::shift([0.02, 0.0]).normal(NormalLoad::Approach(approach));
            history.step(&press).unwrap();
            let fresh = history.stiffness().unwrap();
            assert_eq!(
                history.stiffness_with(&mut workspace, go_on).unwrap(),
                fresh
            );
            let mut without = history.stiffness_with(&mut half, go_on).unwrap();
            assert_eq!(without.tangential.reversal, [[None; 3]; 3]);
            assert!(without.tangential.bound <= fresh.tangential.bound);
            assert!(half.report().products() < workspace.report().products());
            without.tangential.reversal = fresh.tangential.reversal;
            without.tangential.bound = fresh.tangential.bound;
            assert_eq!(without, fresh);
        }
    }
}

/// The error is of second order in the residual.
#[test]
fn larger_tolerance_costs_less() {
    let scene = StiffnessCase::ball(48, 0.3, TangentialModel::Vector);
    let mut history = History::builder(&scene.bodies, &scene.gap, scene.friction.clone())
        .model(scene.model)
        .build()
        .unwrap();
    let load = LoadStep::shift([0.02, 0.01]).normal(NormalLoad::Approach(0.3));
    history.step(&load).unwrap();
    let found = |tolerance: f64| {
        let mut workspace = StiffnessWorkspace::new().tolerance(tolerance).unwrap();
        let stiffness = history.stiffness_with(&mut workspace, |_| ControlFlow::Continue(()));
        (stiffness.unwrap(), workspace.report().products())
    };
    let ((fine, dear), (rough, cheap)) = (found(1e-11), found(1e-4));
    assert!(cheap < dear);
    assert!((rough.normal.value / fine.normal.value - 1.0).abs() <= rough.normal.bound);
    assert!(rough.normal.bound < 1e-6);
    let along = |stiffness: &ContactStiffness| stiffness.tangential.loading[0][0].unwrap();
    let error = (along(&rough) / along(&fine) - 1.0).abs();
    let bound = rough.tangential.bound;
    assert!(error <= bound && bound < 1e-5, "{error:e} for {bound:e}");
    for outside in [0.0, 1.0, 2.0, -1.0, f64::NAN, f64::INFINITY] {
        let error = StiffnessWorkspace::new().tolerance(outside).unwrap_err();
        assert!(matches!(error, Error::Tolerance(value) if value.to_bits() == outside.to_bits()));
    }
}
