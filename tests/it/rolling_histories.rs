//! Rolling steps of a history move the memory of the particles. The tests compare with results of CONTACT without the
//! entry rule, with histories under a moving gap, and with steady rolling. They also check the energy balance.

use stickslip::analytical::{Carter, HertzLine};
use stickslip::history::{AdaptiveSteps, EntryRule, LeadingEdge, Rolling};
use stickslip::normal::Hardness;
use stickslip::rolling::RollingProblem;
use stickslip::tangential::RelativeDisplacement;
use stickslip::{
    Axis, Boundary, Coupling, ElasticPair, Error, Field, Grid, HalfSpace, History, LoadStep,
    Material, NormalLoad, TangentialControl, TangentialModel, Warning, Zone, surface,
};

fn similar_bodies(grid: Grid, shear_modulus: f64, poisson: f64) -> HalfSpace {
    HalfSpace::new(grid, kit::alike_in_shear(shear_modulus, poisson)).unwrap()
}

/// Returns a history in the vector model with friction 0.3.
fn history(bodies: &HalfSpace, gap: &Field, entry_rule: EntryRule, tolerance: f64) -> History {
    History::builder(bodies, gap, kit::coulomb(0.3))
        .model(TangentialModel::Vector)
        .entry_rule(entry_rule)
        .tolerance(tolerance)
        .build()
        .unwrap()
}

fn press(force: f64) -> LoadStep {
    LoadStep::hold().normal(NormalLoad::Force(force))
}

/// Returns the bodies, the gap and the normal load of a sphere of radius one on a grid of 16 cells across.
fn small_sphere(poisson: f64) -> (HalfSpace, Field, f64) {
    let grid = kit::square(20, 2.5);
    let bodies = similar_bodies(grid, 1.0, poisson);
    let load = 4.0 / 3.0 * bodies.pair().contact_modulus();
    (bodies, kit::sphere(grid, 1.0), load)
}

/// The reference is CONTACT (E. A. H. Vollebregt, revision 2707, Apache-2.0) on the same cells. It gives the forces on
/// the other body and the number of sticking cells. Both apply after the given number of steps from rest, each over one
/// cell.
#[test]
fn rolling_without_entry_law_matches_contact() {
    let sphere = Grid::new(41, 37, 0.0116, 0.0116).unwrap();
    let bodies = similar_bodies(sphere, 80_000.0, 0.25);
    let gap = Field::from_fn(sphere, |x, y| 0.05 * (x * x + y * y));
    let along = [
        (1, [1.011520765666, 0.0, 0.0], 853),
        (2, [1.999433830613, 0.0, 0.0], 841),
        (10, [8.967895721807, 0.0, 0.0], 753),
        (30, [18.77013031574, 0.0, 0.0], 530),
    ];
    let turning = [
        (1, [0.0, 0.5217922252027, 0.334057090307], 815),
        (2, [0.0, 1.091884495153, 0.6295499673925], 786),
        (10, [0.0, 6.698987330120, 1.970993285083], 586),
        (30, [0.0, 19.27538860109, 1.581549547379], 317),
    ];
    for (creepage, spin, expected) in [([0.0025, 0.0], 0.0, along), ([0.0, 0.0012], 0.02, turning)]
    {
        let mut history = history(&bodies, &gap, EntryRule::WholeStep, 1e-11);
        let load = press(100.0).roll(Rolling::new(1).creepage(creepage).spin(spin));
        for n in 1..=30 {
            history.step(&load).unwrap();
            let Some((_, forces, stick)) = expected.iter().find(|(step, ..)| *step == n) else {
                continue;
            };
            let [x, y] = history.tangential_force();
            for (found, expected) in [x, y, history.moment()].into_iter().zip(forces) {
                assert!(
                    (found - expected).abs() < 1e-9,
                    "{n}: {found} for {expected}"
                );
            }
            let sticking = history.zones().iter().filter(|z| **z == Zone::Stick);
            assert_eq!(sticking.count(), *stick, "{n}");
        }
    }

    // A line of cells of length 200. The creepage reverses in the 25th step.
    let line = Grid::new(70, 1, 0.03125, 200.0).unwrap();
    let bodies = similar_bodies(line, 82_000.0, 0.28);
    let gap = Field::from_fn(line, |x, _| 0.001 * x * x);
    let mut history = history(&bodies, &gap, EntryRule::WholeStep, 1e-11);
    let expected = [
        (1, 350.1825319509, 64),
        (2, 698.8757052674, 63),
        (24, 7970.392965104, 47),
        (25, 7776.795212566, 48),
        (39, 5087.623468915, 50),
        (40, 4896.974998456, 51),
    ];
    for n in 1..=40 {
        let creepage = if n < 25 { 0.002 } else { -0.001 };
        let rolling = Rolling::new(1).creepage([creepage, 0.0]);
        history.step(&press(35_780.0).roll(rolling)).unwrap();
        if let Some((_, force, stick)) = expected.iter().find(|(step, ..)| *step == n) {
            // The tolerance is 1e-10 of mu P.
            assert!((history.tangential_force()[0] - force).abs() < 1e-6, "{n}");
            let sticking = history.zones().iter().filter(|z| **z == Zone::Stick);
            assert_eq!(sticking.count(), *stick, "{n}");
        }
    }
}

/// In the frame of the particles the contact moves over the surfaces. The apex of the gap moves by one cell in each
/// step, and the shift increases by the creepage.
#[test]
fn rolling_step_matches_shift_in_frame_of_particles() {
    let soft = Material::from_shear_modulus(1.0, 0.3).unwrap();
    assert_same_in_both_frames(&ElasticPair::new(soft, soft).unwrap(), Coupling::OneWay);
}

/// While the bodies roll, the pressure changes and displaces the surfaces of dissimilar bodies tangentially.
#[test]
fn dissimilar_rolling_under_changing_load_matches_frame_of_particles() {
    let [soft, hard] = [1.0, 4.0].map(|modulus| Material::from_shear_modulus(modulus, 0.2));
    let pair = ElasticPair::new(soft.unwrap(), hard.unwrap()).unwrap();
    assert_same_in_both_frames(&pair, Coupling::OneWay);
    assert_same_in_both_frames(&pair, Coupling::Full);
}

fn assert_same_in_both_frames(pair: &ElasticPair, coupling: Coupling) {
    let steps = if coupling == Coupling::Full { 6 } else { 12 };
    let (moving, still) = (
        Grid::new(20 + steps, 20, 0.125, 0.125).unwrap(),
        kit::square(20, 2.5),
    );
    let form =
        |x: f64, y: f64| 0.5 * (x * x + y * y) + 0.01 * (5.0 * x + 1.0).cos() * (4.0 * y).cos();
    let (load, creepage) = (0.8, [0.12, -0.07]);
    let start = |grid: Grid, gap: &Field| {
        let bodies = HalfSpace::new(grid, *pair).unwrap();
        History::builder(&bodies, gap, kit::coulomb(0.3))
            .model(TangentialModel::Vector)
            .coupling(coupling)
            .entry_rule(EntryRule::WholeStep)
            .tolerance(1e-12)
            .build()
            .unwrap()
    };
    let mut rolled = start(still, &Field::from_fn(still, form));
    // Distance covered by the contact of the narrow grid, in cells of the wide grid.
    let at = |n: usize| {
        let place = (n as f64 - 0.5 * steps as f64) * 0.125;
        Field::from_fn(moving, move |x, y| form(x - place, y))
    };
    let mut shifted = start(moving, &at(0));
    rolled.step(&press(load)).unwrap();
    shifted.step(&press(load)).unwrap();
    for n in 1..=steps {
        let load = press(load + 0.02 * n as f64);
        rolled
            .step(&load.roll(Rolling::new(1).creepage(creepage)))
            .unwrap();
        shifted.set_gap(&at(n)).unwrap();
        let shift = creepage.map(|creepage| TangentialControl::Shift(n as f64 * 0.125 * creepage));
        let load = load
            .tangential(Axis::X, shift[0])
            .tangential(Axis::Y, shift[1]);
        shifted.step(&load).unwrap();
        let most = 0.3 * rolled.pressure().max();
        for axis in 0..2 {
            let quantities = [
                (rolled.traction()[axis], shifted.traction()[axis], most),
                (
                    rolled.last_step().unwrap().slip()[axis],
                    shifted.last_step().unwrap().slip()[axis],
                    0.015,
                ),
                (rolled.slip()[axis], shifted.slip()[axis], 0.015),
            ];
            for (rolled, shifted, unit) in quantities {
                for (i, value) in rolled.as_slice().iter().enumerate() {
                    let (ix, iy) = (i % 20, i / 20);
                    let other = shifted.get(ix + n, iy).unwrap();
                    assert!(
                        (value - other).abs() < 1e-10 * unit,
                        "{n}: {value:e} {other:e}"
                    );
                }
            }
        }
    }
}

/// The texture of rough rollers moves with the particles, and the gap is set before each step.
#[test]
fn texture_moves_with_particles() {
    let grid = Grid::new(26, 22, 0.12, 0.14).unwrap();
    let bodies = similar_bodies(grid, 1.0, 0.3);
    let gap = |rolled: usize| {
        let way = 0.12 * rolled as f64;
        Field::from_fn(grid, move |x, y| {
            0.5 * (x * x + y * y) + 0.01 * (6.0 * (x + way)).cos() * (5.0 * y + 1.0).cos()
        })
    };
    let rolling = Rolling::new(1).creepage([0.1, -0.05]);
    for entry_rule in [EntryRule::SinceTouch, EntryRule::WholeStep] {
        let mut moved = history(&bodies, &gap(0), entry_rule, 1e-10);
        moved.step(&press(1.5)).unwrap();
        let mut touched = 0;
        for n in 1..=12 {
            let before = moved.pressure().as_slice().to_vec();
            moved.set_gap(&gap(n)).unwrap();
            moved.step(&press(1.5).roll(rolling)).unwrap();
            let energy = moved.last_step().unwrap().energy();
            assert!(energy.imbalance().abs() < 1e-12 * energy.elastic_after);
            assert!(energy.dissipated_energy_midpoint > 0.0);
            assert!(energy.residual.abs() < 1e-7 * energy.elastic_after);
            let now = moved.pressure().as_slice().iter().zip(before);
            touched += now
                .filter(|(now, before)| **now > 0.0 && *before == 0.0)
                .count();
            let [qx, qy] = moved.traction().map(Field::as_slice);
            for (i, p) in moved.pressure().as_slice().iter().enumerate() {
                assert!(qx[i].hypot(qy[i]) <= 0.3 * p * (1.0 + 1e-12));
            }
        }
        assert!(touched > 0);
        // Setting the current gap again changes nothing, and a new gap changes the traction.
        let (mut kept, mut given) = (moved.clone(), moved.clone());
        given.set_gap(&gap(12)).unwrap();
        for history in [&mut kept, &mut given] {
            history.step(&press(1.5).roll(rolling)).unwrap();
        }
        assert_eq!(kept.traction(), given.traction());
        moved.set_gap(&gap(13)).unwrap();
        moved.step(&press(1.5).roll(rolling)).unwrap();
        assert_ne!(kept.traction(), moved.traction());
    }
}

/// A smooth roller rolls on a rough roller whose texture does not move, like the shape of a worn roller. The history converges to
/// steady rolling.
#[test]
fn rough_form_converges_to_steady_rolling() {
    let grid = Grid::new(24, 20, 0.14, 0.16).unwrap();
    let bodies = similar_bodies(grid, 1.0, 0.3);
    let gap = Field::from_fn(grid, |x, y| {
        0.5 * (x * x + y * y) + 0.02 * (9.0 * x).cos() * (7.0 * y + 1.0).cos()
    });
    let mut history = history(&bodies, &gap, EntryRule::SinceTouch, 1e-9);
    history.step(&press(1.0)).unwrap();
    let rolling = Rolling::new(1).creepage([0.08, 0.03]).spin(0.05);
    // The distance is thirty times the half-width of about 0.9.
    for _ in 0..200 {
        history.step(&LoadStep::hold().roll(rolling)).unwrap();
    }
    let problem = RollingProblem::builder(&bodies, history.normal(), kit::coulomb(0.3));
    let problem = problem.creepage([0.08, 0.03]).spin(0.05).tolerance(1e-10);
    let steady = kit::solve(problem);
    for (found, expected) in history.tangential_force().into_iter().zip(steady.force()) {
        assert!((found - expected).abs() < 1e-5 * 0.3, "{found} {expected}");
    }
    assert!((history.moment() - steady.moment()).abs() < 1e-5 * 0.3);
}

/// Returns the error of the force relative to the friction limit, after rolling over 30 half-widths from rest. The
/// contact has the given number of cells across.
fn error_of_carter(cells: usize, ratio: f64, entry_rule: EntryRule) -> f64 {
    let pair = kit::alike(1.0, 0.0);
    let hertz = HertzLine::new(
        &pair,
        1.0,
        std::f64::consts::PI * pair.contact_modulus() / 4.0,
    )
    .unwrap();
    let dx = 2.0 / cells as f64;
    let grid = Grid::line(cells + 8, dx).unwrap();
    let boundary = Boundary::PeriodicAlongY { datum: 4.0 };
    let bodies = HalfSpace::with_boundary(grid, pair, boundary).unwrap();
    let slides_at = Carter::new(hertz, 0.3, 0.0).unwrap().sliding_creepage();
    let creepage = (1.0 - ratio) * slides_at;
    let exact = Carter::new(hertz, 0.3, creepage).unwrap().force();
    let offsets = [0.1, 0.37, 0.77];
    let errors = offsets.map(|offset| {
        let gap = Field::from_fn(grid, |x, _| 0.5 * (x + offset * dx).powi(2));
        let builder = History::builder(&bodies, &gap, kit::coulomb(0.3));
        let mut history = builder
            .entry_rule(entry_rule)
            .tolerance(1e-9)
            .build()
            .unwrap();
        let rolling = Rolling::new(1).creepage([creepage, 0.0]);
        for _ in 0..15 * cells {
            history.step(&press(hertz.load()).roll(rolling)).unwrap();
        }
        (history.tangential_force()[0] - exact).abs() / (0.3 * hertz.load())
    });
    errors.iter().sum::<f64>() / 3.0
}

#[test]
fn entry_law_reduces_error_of_carter_force() {
    let law = error_of_carter(128, 0.2, EntryRule::SinceTouch);
    assert!(law < 2.1e-5, "{law:e}");
    let whole = error_of_carter(128, 0.2, EntryRule::WholeStep);
    assert!(whole > 60.0 * law && whole < 3e-3, "{whole:e} {law:e}");
}

/// The entry rule has a compliance that depends on the direction for this Poisson's ratio.
#[test]
fn rolling_history_converges_to_steady_rolling() {
    let (bodies, ball, load) = small_sphere(0.25);
    let (creepage, spin) = ([0.12, 0.06], 0.1);
    let mut history = history(&bodies, &ball, EntryRule::SinceTouch, 1e-9);
    let rolling = Rolling::new(1).creepage(creepage).spin(spin);
    for _ in 0..240 {
        history.step(&press(load).roll(rolling)).unwrap();
    }
    let problem = RollingProblem::builder(&bodies, history.normal(), kit::coulomb(0.3));
    let steady = problem
        .creepage(creepage)
        .spin(spin)
        .tolerance(1e-10)
        .build();
    let steady = steady.unwrap().solve().unwrap();
    let most = 0.3 * history.pressure().max();
    for axis in 0..2 {
        let [found, expected] = [history.tangential_force(), steady.force()].map(|f| f[axis]);
        assert!(
            (found - expected).abs() < 1e-6 * 0.3 * load,
            "{found} {expected}"
        );
        let cells = history.traction()[axis].as_slice().iter();
        for (found, expected) in cells.zip(steady.traction()[axis].as_slice()) {
            assert!((found - expected).abs() < 1e-6 * most, "{found} {expected}");
        }
    }
    assert_eq!(history.zones(), steady.zones());
    let (found, expected) = (history.moment(), steady.moment());
    assert!(
        (found - expected).abs() < 1e-6 * 0.3 * load,
        "{found} {expected}"
    );
}

#[test]
fn prescribed_force_gives_creepage_that_causes_it() {
    let (bodies, ball, load) = small_sphere(0.25);
    let mut given = history(&bodies, &ball, EntryRule::SinceTouch, 1e-12);
    let mut found = history(&bodies, &ball, EntryRule::SinceTouch, 1e-12);
    let rolling = Rolling::new(1).spin(0.05);
    for creepage in [[0.05, 0.02], [0.1, 0.02], [-0.04, 0.03], [0.0, -0.1]] {
        let step = given
            .step(&press(load).roll(rolling.creepage(creepage)))
            .unwrap();
        assert_eq!(step.creepage(), Some(creepage));
        let [x, y] = step.tangential_force().map(TangentialControl::Force);
        let drag = press(load).tangential(Axis::X, x).tangential(Axis::Y, y);
        let step = found.step(&drag.roll(rolling)).unwrap();
        let [xi, eta] = step.creepage().unwrap();
        assert!(
            (xi - creepage[0]).hypot(eta - creepage[1]) < 1e-7,
            "{xi} {eta}"
        );
    }
    // A step that does not roll reports no creepage.
    let step = given.step(&press(load)).unwrap();
    assert_eq!(step.creepage(), None);
}

/// Bodies roll along an axis across which the grid is periodic, and along y with tractions along x only.
#[test]
fn scalar_model_rolls_as_vector_model() {
    let grid = Grid::line(40, 0.06).unwrap();
    let boundary = Boundary::PeriodicAlongY { datum: 4.0 };
    let bodies = HalfSpace::with_boundary(grid, kit::alike_in_shear(1.0, 0.3), boundary).unwrap();
    let roller = surface::cylinder(grid, 1.0).unwrap();
    let rolling = Rolling::new(1).creepage([0.05, 0.0]);
    let forces = [TangentialModel::Scalar, TangentialModel::Vector].map(|model| {
        let builder = History::builder(&bodies, &roller, kit::coulomb(0.3));
        let mut history = builder.model(model).tolerance(1e-11).build().unwrap();
        for _ in 0..20 {
            history.step(&press(1.0).roll(rolling)).unwrap();
        }
        history.tangential_force()[0]
    });
    assert!((forces[0] / forces[1] - 1.0).abs() < 1e-9, "{forces:?}");
    // Without lateral contraction a traction displaces the surfaces along its own axis only.
    let (bodies, ball, load) = small_sphere(0.0);
    let rolling = rolling.leading_edge(LeadingEdge::PlusY);
    let forces = [TangentialModel::Scalar, TangentialModel::Vector].map(|model| {
        let builder = History::builder(&bodies, &ball, kit::coulomb(0.3));
        let mut history = builder.model(model).tolerance(1e-11).build().unwrap();
        for _ in 0..6 {
            history.step(&press(load).roll(rolling)).unwrap();
        }
        history.tangential_force()[0]
    });
    assert!((forces[0] / forces[1] - 1.0).abs() < 1e-8, "{forces:?}");
}

/// With one-way coupling the pressure of dissimilar bodies displaces the surfaces tangentially. Rolling converges to
/// the steady state under the same pressure.
#[test]
fn one_way_rolling_converges_to_steady_rolling() {
    let grid = kit::square(20, 2.5);
    let (soft, hard) = (
        Material::from_shear_modulus(1.0, 0.25).unwrap(),
        Material::rigid(),
    );
    let bodies = HalfSpace::new(grid, ElasticPair::new(soft, hard).unwrap()).unwrap();
    let builder = History::builder(&bodies, kit::sphere(grid, 1.0), kit::coulomb(0.3));
    let builder = builder
        .model(TangentialModel::Vector)
        .coupling(Coupling::OneWay);
    let mut history = builder.tolerance(1e-9).build().unwrap();
    for _ in 0..200 {
        history
            .step(&press(1.7).roll(Rolling::new(1).creepage([0.02, 0.0])))
            .unwrap();
    }
    let problem = RollingProblem::builder(&bodies, history.normal(), kit::coulomb(0.3));
    let steady = kit::solve(problem.creepage([0.02, 0.0]).tolerance(1e-10));
    let (found, expected) = (history.tangential_force()[0], steady.force()[0]);
    assert!((found - expected).abs() < 1e-6 * 0.51, "{found} {expected}");
}

#[test]
fn rolled_step_without_contact_has_no_lift_warning() {
    let grid = kit::square(20, 2.5);
    let soft = Material::from_shear_modulus(1.0, 0.25).unwrap();
    let pair = ElasticPair::new(soft, Material::rigid()).unwrap();
    let bodies = HalfSpace::new(grid, pair).unwrap();
    let builder = History::builder(&bodies, kit::sphere(grid, 1.0), kit::coulomb(0.3));
    let builder = builder.model(TangentialModel::Vector);
    let mut history = builder.coupling(Coupling::OneWay).build().unwrap();
    let unloaded = history.state().clone();
    history.step(&press(1.7)).unwrap();
    let rolled = LoadStep::hold().roll(Rolling::new(1).creepage([0.05, 0.0]));
    let is_lift = |warning: &Warning| matches!(warning, Warning::NeglectedLift { .. });
    let in_contact = history.step(&rolled).unwrap().warnings();
    assert!(in_contact.iter().any(is_lift));
    history.set_state(&unloaded).unwrap();
    let apart = history.step(&rolled).unwrap().warnings();
    assert!(!apart.iter().any(is_lift));
}

#[test]
fn rejected_rolling_step_leaves_state_unchanged() {
    let (bodies, ball, load) = small_sphere(0.25);
    let mut history = history(&bodies, &ball, EntryRule::SinceTouch, 1e-8);
    history.step(&press(load)).unwrap();
    let before = history.state().to_bytes();
    let too_much = press(load).tangential(Axis::X, TangentialControl::Force(load));
    // In the second step, the contact would grow beyond the room that the grid leaves ahead of it.
    kit::assert_refused! {
        history.step(&too_much.roll(Rolling::new(1))) => Error::BeyondFrictionCapacity { .. },
        history.step(&press(1.35 * load).roll(Rolling::new(2))) => Error::GridTooShort { needed: 2, .. },
    }
    assert_eq!(history.state().to_bytes(), before);
}

#[test]
fn invalid_rolling_is_rejected() {
    let (bodies, ball, load) = small_sphere(0.25);
    let mut rolled = history(&bodies, &ball, EntryRule::SinceTouch, 1e-8);
    rolled.step(&press(load)).unwrap();
    let before = rolled.state().to_bytes();
    let one = Rolling::new(1);
    let force = TangentialControl::Force(0.01);
    let spring = TangentialControl::Spring {
        position: 0.1,
        stiffness: 1.0,
    };
    let along = |control| LoadStep::hold().tangential(Axis::X, control);
    for load in [
        LoadStep::hold().roll(one.creepage([f64::NAN, 0.0])),
        LoadStep::hold().roll(one.spin(f64::INFINITY)),
    ] {
        kit::assert_refused! { rolled.step(&load) => Error::NotFinite { .. } }
    }
    kit::assert_refused! { rolled.step(&LoadStep::hold().roll(Rolling::new(0))) => Error::NotPositive { .. } }
    for cells in [9, usize::MAX] {
        kit::assert_refused! {
            rolled.step(&LoadStep::hold().roll(Rolling::new(cells)))
                => Error::GridTooShort { needed, found, .. } if needed == cells && found < 5,
        }
    }
    for load in [
        along(force).roll(one.creepage([0.1, 0.0])),
        along(TangentialControl::Shift(0.1)).roll(one),
        along(spring).roll(one),
        LoadStep::hold().twist(0.1).roll(one),
    ] {
        kit::assert_refused! { rolled.step(&load) => Error::UnsupportedByModel { .. } }
    }
    let mut adaptive = AdaptiveSteps::new(&rolled, 1e-3).unwrap();
    let refused = adaptive.step(&mut rolled, &LoadStep::hold().roll(one));
    assert!(matches!(refused, Err(Error::UnsupportedByModel { value, .. }) if value == 1.0));
    assert_eq!(rolled.state().to_bytes(), before);

    let is_refused = |history: Result<History, Error>, rolling: Rolling| {
        let mut history = history.unwrap();
        kit::assert_refused! { history.step(&press(1e-3).roll(rolling)) => Error::UnsupportedByModel { .. } }
    };
    let builder = |bodies| History::builder(bodies, &ball, kit::coulomb(0.3));
    // The scalar model supports neither creepage across its axis nor spin.
    is_refused(builder(&bodies).build(), one.creepage([0.0, 0.1]));
    is_refused(builder(&bodies).build(), one.spin(0.1));
    let apart = RelativeDisplacement::bulk_strain(bodies.grid(), [[0.0; 2]; 2]).unwrap();
    is_refused(builder(&bodies).relative_displacement(apart).build(), one);
    let yielding = builder(&bodies).hardness(Hardness::uniform(1e3).unwrap());
    is_refused(yielding.permanent_set(true).build(), one);
    kit::assert_refused! { builder(&bodies).permanent_set(true).build() => Error::UnsupportedByModel { .. } }
    let waves =
        HalfSpace::with_boundary(bodies.grid(), *bodies.pair(), Boundary::Periodic).unwrap();
    is_refused(builder(&waves).build(), one);
}
