//! Warnings about limits above the modulus, motions of many small steps and gaps under load, and the rejection of long springs.

use stickslip::adaptive::{AdaptiveProblem, Quantity, Region};
use stickslip::history::{Cycle, FrettingLoop, LoadPath, Rolling};
use stickslip::layers::Layer;
use stickslip::normal::Hardness;
use stickslip::rolling::RollingProblem;
use stickslip::{
    Boundary, CoupledProblem, ElasticPair, Error, Field, Friction, Grid, HalfSpace, History,
    LoadStep, Material, NormalLoad, NormalProblem, NormalSolution, Result, TangentialLoad,
    TangentialModel, TangentialProblem, Warning, surface,
};

const RADIUS: f64 = 20.0;

/// Side of the grid.
const SIDE: f64 = 2.8;

/// Plane-strain modulus of a body. The contact modulus of both is 1.
const MODULUS: f64 = 2.0;

/// Bodies with the contact modulus 1.
fn bodies() -> HalfSpace {
    HalfSpace::new(Grid::square(16, SIDE).unwrap(), kit::unit_pair(0.3)).unwrap()
}

fn ball(bodies: &HalfSpace) -> Field {
    surface::sphere(bodies.grid(), RADIUS).unwrap()
}

/// Load with the contact radius 1.
fn load() -> NormalLoad {
    NormalLoad::Force(4.0 / 3.0 / RADIUS)
}

fn friction() -> Friction {
    Friction::coulomb(0.5).unwrap()
}

fn pressed(bodies: &HalfSpace, gap: &Field) -> NormalSolution {
    kit::solve(NormalProblem::builder(bodies, gap, load()))
}

fn new_history(bodies: &HalfSpace, friction: Friction) -> History {
    let builder = History::builder(bodies, ball(bodies), friction);
    builder.model(TangentialModel::Vector).build().unwrap()
}

fn press() -> LoadStep {
    LoadStep::hold().normal(load())
}

fn hardness_warning(warnings: Vec<Warning>) -> Option<Warning> {
    kit::first_of(warnings, |w| {
        matches!(w, Warning::HardnessBeyondModulus { .. })
    })
}

fn cap_warning(warnings: Vec<Warning>) -> Option<Warning> {
    kit::first_of(warnings, |w| {
        matches!(w, Warning::ShearStressBeyondModulus { .. })
    })
}

fn shift_warning(warnings: Vec<Warning>) -> Option<Warning> {
    kit::first_of(warnings, |w| matches!(w, Warning::ShiftBeyondGrid { .. }))
}

fn closed_warning(warnings: Vec<Warning>) -> Option<Warning> {
    kit::first_of(warnings, |w| matches!(w, Warning::ClosedGap { .. }))
}

/// Limits in plane-strain moduli of a body, and the values that the warnings state.
const LIMITS: [(f64, Option<usize>); 3] =
    [(0.9, None), (1.5, Some(1_500)), (1e6, Some(1_000_000_000))];

#[test]
fn hardness_above_modulus_gives_warning_in_every_solution() {
    let bodies = bodies();
    let ball = ball(&bodies);
    for (limit, per_mille) in LIMITS {
        let expected = per_mille.map(|per_mille| Warning::HardnessBeyondModulus { per_mille });
        let limit = limit * MODULUS;
        let hardness = Hardness::uniform(limit).unwrap();
        let normal = NormalProblem::builder(&bodies, &ball, load());
        let limited = kit::solve(normal.clone().hardness(hardness.clone()));
        assert_eq!(hardness_warning(limited.warnings()), expected);
        // The smallest limit of the contact cells counts.
        let mut limits = Field::constant(bodies.grid(), 10.0 * limit);
        limits.as_mut_slice()[0] = 0.0;
        limits.as_mut_slice()[9] = 1e-3;
        limits.as_mut_slice()[8 * 16 + 8] = limit;
        let per_cell = normal.clone().hardness(Hardness::per_cell(limits).unwrap());
        assert_eq!(hardness_warning(kit::solve(per_cell).warnings()), expected);

        let mut solver = kit::solver(normal);
        assert_eq!(hardness_warning(kit::solved(&mut solver).warnings()), None);
        solver.set_hardness(&hardness).unwrap();
        assert_eq!(
            hardness_warning(kit::solved(&mut solver).warnings()),
            expected
        );

        let at_rest = TangentialLoad::shift([0.0; 2]);
        let coupled = CoupledProblem::builder(&bodies, &ball, friction(), load(), at_rest);
        let coupled = kit::solve(coupled.hardness(hardness.clone()));
        assert_eq!(hardness_warning(coupled.warnings()), expected);

        let builder = History::builder(&bodies, &ball, friction()).hardness(hardness);
        let mut history = builder.build().unwrap();
        let mut cycle = Cycle::new(&history);
        let step = history.step(&press()).unwrap();
        assert_eq!(hardness_warning(step.warnings()), expected);
        assert_eq!(hardness_warning(history.normal().warnings()), expected);
        cycle.add(&history).unwrap();
        assert_eq!(hardness_warning(cycle.warnings()), expected);

        // The hardness of a material is compared with the modulus of its body.
        let [body, _] = bodies.pair().bodies();
        let stated = body.with_hardness(limit).unwrap();
        let soft = Material::new(1e-2, 0.3).unwrap();
        for other in [body, soft, Material::rigid()] {
            let pair = ElasticPair::new(stated, other).unwrap();
            let bodies = HalfSpace::new(bodies.grid(), pair).unwrap();
            let contact = NormalProblem::builder(&bodies, &ball, NormalLoad::Force(1e-3));
            let warnings = kit::solve(contact).warnings();
            assert_eq!(hardness_warning(warnings), expected);
        }
    }
}

/// A hardness that cells have reached has an effect. The modulus of a soft layer does not bound the pressure of a coated body.
#[test]
fn hardness_with_effect_gives_no_warning() {
    let hardness = Hardness::uniform(1.5 * MODULUS).unwrap();
    let bodies = bodies();
    let deep = NormalProblem::builder(&bodies, ball(&bodies), NormalLoad::Approach(40.0));
    let deep = kit::solve(deep.hardness(hardness.clone()));
    assert!(deep.yielded_cells() > 0);
    assert_eq!(hardness_warning(deep.warnings()), None);

    let layer = Layer::new(2.0, 0.3, 0.05).unwrap();
    let base = Material::new(1e3, 0.3).unwrap();
    let pair = ElasticPair::new(base.coated(&[layer]).unwrap(), Material::rigid()).unwrap();
    let coated = HalfSpace::new(bodies.grid(), pair).unwrap();
    let contact = NormalProblem::builder(&coated, ball(&coated), load()).hardness(hardness);
    assert_eq!(hardness_warning(kit::solve(contact).warnings()), None);
}

#[test]
fn cap_above_modulus_gives_warning_in_every_solution() {
    let bodies = bodies();
    let ball = ball(&bodies);
    let normal = pressed(&bodies, &ball);
    let dragged = TangentialLoad::shift([1e-3, 0.0]);
    for (cap, per_mille) in LIMITS {
        let expected = per_mille.map(|per_mille| Warning::ShearStressBeyondModulus { per_mille });
        let friction = friction().max_shear_stress(cap * MODULUS).unwrap();
        let tangential = TangentialProblem::builder(&bodies, &normal, friction.clone(), dragged);
        assert_eq!(cap_warning(kit::solve(tangential).warnings()), expected);
        let coupled = CoupledProblem::builder(&bodies, &ball, friction.clone(), load(), dragged);
        assert_eq!(cap_warning(kit::solve(coupled).warnings()), expected);
        let rolling = RollingProblem::builder(&bodies, &normal, friction.clone());
        let rolling = rolling.creepage([1e-3, 0.0]).build().unwrap();
        assert_eq!(cap_warning(rolling.solve().unwrap().warnings()), expected);
        let mut solver = rolling.into_solver().unwrap();
        let points = solver.creep_forces([[1e-3, 0.0, 0.0]]).unwrap();
        assert_eq!(cap_warning(points[0].warnings()), expected);

        let mut history = new_history(&bodies, friction);
        let mut cycle = Cycle::new(&history);
        let step = LoadStep::shift([1e-3, 0.0]).normal(load());
        let first = history.step(&step).unwrap();
        assert_eq!(cap_warning(first.warnings()), expected);
        cycle.add(&history).unwrap();
        history.set_friction(&self::friction()).unwrap();
        assert_eq!(cap_warning(history.step(&step).unwrap().warnings()), None);
        cycle.add(&history).unwrap();
        assert_eq!(cap_warning(cycle.warnings()), expected);
    }
    // A large coefficient with a cap models a constant limit, and the warning about the coefficient does not hide a high cap.
    for (cap, per_mille) in LIMITS {
        let constant = Friction::coulomb(1e9).unwrap();
        let constant = constant.max_shear_stress(cap * MODULUS).unwrap();
        let tangential = TangentialProblem::builder(&bodies, &normal, constant, dragged);
        let expected = per_mille.map(|per_mille| Warning::ShearStressBeyondModulus { per_mille });
        assert_eq!(cap_warning(kit::solve(tangential).warnings()), expected);
    }
    // A body without friction, and a strong interface of a soft body on a stiff one.
    let smooth = Friction::coulomb(0.0).unwrap();
    let smooth = smooth.max_shear_stress(1e6).unwrap();
    let tangential = TangentialProblem::builder(&bodies, &normal, smooth, dragged);
    assert_eq!(cap_warning(kit::solve(tangential).warnings()), None);
    let stiff = Material::new(1e4, 0.3).unwrap();
    let pair = ElasticPair::new(Material::new(1.0, 0.3).unwrap(), stiff).unwrap();
    let bodies = HalfSpace::new(bodies.grid(), pair).unwrap();
    let normal = pressed(&bodies, &ball);
    let strong = friction().max_shear_stress(100.0).unwrap();
    let tangential = TangentialProblem::builder(&bodies, &normal, strong, dragged);
    assert_eq!(cap_warning(kit::solve(tangential).warnings()), None);
}

/// An effect in one step of a cycle removes the warnings of the cycle.
#[test]
fn limits_reached_in_one_step_give_no_warning_of_the_cycle() {
    let bodies = bodies();
    let limit = 1.5 * MODULUS;
    let friction = friction().max_shear_stress(limit).unwrap();
    let builder = History::builder(&bodies, ball(&bodies), friction);
    let builder = builder.hardness(Hardness::uniform(limit).unwrap());
    let mut history = builder.build().unwrap();
    let mut cycle = Cycle::new(&history);
    let is_warned = |warnings: Vec<Warning>| {
        hardness_warning(warnings.clone()).is_some() && cap_warning(warnings).is_some()
    };
    history.step(&press()).unwrap();
    cycle.add(&history).unwrap();
    assert!(is_warned(cycle.warnings()));
    history
        .set_friction(
            &Friction::coulomb(2.0)
                .unwrap()
                .max_shear_stress(limit)
                .unwrap(),
        )
        .unwrap();
    let deep = LoadStep::shift([0.1, 0.0]).normal(NormalLoad::Approach(40.0));
    history.step(&deep).unwrap();
    cycle.add(&history).unwrap();
    assert_eq!(hardness_warning(cycle.warnings()), None);
    assert_eq!(cap_warning(cycle.warnings()), None);
}

/// Exchanged values of position and stiffness prescribe almost the same force, with a very long and soft spring.
#[test]
fn very_long_spring_is_rejected_before_any_work() {
    let bodies = bodies();
    let ball = ball(&bodies);
    let normal = pressed(&bodies, &ball);
    let force = 0.2 * normal.force();
    for (sides, is_rejected) in [(9e5, false), (2e6, true), (3e10, true)] {
        let dragged = TangentialLoad::spring([0.0, -sides * SIDE], force / sides / SIDE);
        let is_expected = |outcome: Result<()>| match outcome {
            Ok(()) => !is_rejected,
            Err(Error::UnsupportedByModel { model, value, .. }) => {
                model == "a spring" && (value / -sides - 1.0).abs() < 1e-9
            }
            Err(_) => false,
        };
        let tangential = TangentialProblem::builder(&bodies, &normal, friction(), dragged);
        let tangential = tangential.model(TangentialModel::Vector).build();
        assert!(is_expected(tangential.map(|_| ())));
        let rest = TangentialLoad::force([0.0; 2]);
        let tangential = TangentialProblem::builder(&bodies, &normal, friction(), rest);
        let mut solver = kit::solver(tangential.model(TangentialModel::Vector));
        assert!(is_expected(solver.set_load(dragged)));
        let coupled = CoupledProblem::builder(&bodies, &ball, friction(), load(), dragged).build();
        assert!(is_expected(coupled.map(|_| ())));
        let coupled = CoupledProblem::builder(&bodies, &ball, friction(), load(), rest);
        let mut solver = kit::solver(coupled);
        assert!(is_expected(solver.set_loads(load(), dragged)));

        let mut history = new_history(&bodies, friction());
        history.step(&press()).unwrap();
        let before = history.state().clone();
        let step = LoadStep::spring([0.0, -sides * SIDE], force / sides / SIDE);
        assert!(is_expected(history.step(&step).map(|_| ())));
        assert_eq!(is_rejected, *history.state() == before);
    }
}

/// The other side of a line contact is an arbitrary period.
#[test]
fn lengths_of_line_contact_are_compared_with_its_row() {
    let grid = Grid::line(64, SIDE / 64.0).unwrap();
    let boundary = Boundary::PeriodicAlongY { datum: 2.0 * SIDE };
    let bodies = HalfSpace::with_boundary(grid, kit::unit_pair(0.3), boundary).unwrap();
    let roller = surface::cylinder(grid, RADIUS).unwrap();
    let press = NormalLoad::Force(0.01 * grid.dy());
    let normal = kit::solve(NormalProblem::builder(&bodies, &roller, press));
    for (shift, tenths) in [(0.9, None), (1.2, Some(12))] {
        let dragged = TangentialLoad::shift([shift * SIDE, 0.0]);
        let tangential = TangentialProblem::builder(&bodies, &normal, friction(), dragged);
        assert_eq!(
            shift_warning(kit::solve(tangential).warnings()),
            tenths.map(|tenths| Warning::ShiftBeyondGrid { tenths })
        );
    }
}

/// Each step of the cycle is smaller than the grid. The history has one warning, in the first step beyond the range.
#[test]
fn range_of_shift_gives_warning() {
    let bodies = bodies();
    for (amplitude, tenths) in [(0.45, None), (1.5, Some(30))] {
        let expected = tenths.map(|tenths| Warning::ShiftBeyondGrid { tenths });
        let mut history = new_history(&bodies, friction());
        history.step(&press()).unwrap();
        let mut cycle = Cycle::new(&history);
        let path = LoadPath::sine([amplitude * SIDE, 0.0], 40).unwrap();
        let mut warned = 0;
        for &shift in path.steps() {
            let step = history.step(&LoadStep::shift(shift)).unwrap();
            warned += usize::from(shift_warning(step.warnings()).is_some());
            cycle.add(&history).unwrap();
        }
        assert_eq!(warned, usize::from(tenths.is_some()));
        assert_eq!(shift_warning(cycle.warnings()), expected);
        cycle.begin(&history).unwrap();
        assert_eq!(shift_warning(cycle.warnings()), None);
        let fretting = FrettingLoop::new(path, LoadStep::shift);
        fretting.cycle(&mut history, &mut cycle).unwrap();
        assert_eq!(shift_warning(cycle.warnings()), expected);
    }
}

#[test]
fn range_of_twist_gives_warning() {
    let bodies = bodies();
    let twisted = |warnings: Vec<Warning>| {
        kit::first_of(warnings, |w| matches!(w, Warning::LargeTwist { .. }))
    };
    for (twist, tenths) in [(0.09, None), (0.15, Some(3))] {
        let expected = tenths.map(|tenths| Warning::LargeTwist { tenths });
        let mut history = new_history(&bodies, friction());
        history.step(&press()).unwrap();
        let mut cycle = Cycle::new(&history);
        for part in [0.5, 1.0, 0.0, -1.0] {
            let step = LoadStep::hold().twist(part * twist);
            let step = history.step(&step).unwrap();
            let is_last = part < 0.0;
            assert_eq!(twisted(step.warnings()), expected.filter(|_| is_last));
            cycle.add(&history).unwrap();
        }
        assert_eq!(twisted(cycle.warnings()), expected);
    }
}

/// Bodies that roll or are apart may move further than the grid. Other steps of the cycle count.
#[test]
fn motion_without_contact_or_with_rolling_gives_no_warning() {
    let bodies = bodies();
    let mut history = new_history(&bodies, friction());
    let mut cycle = Cycle::new(&history);
    let mut add = |history: &mut History, step: LoadStep| {
        let warnings = history.step(&step).unwrap().warnings();
        assert_eq!(shift_warning(warnings), None);
        cycle.add(history).unwrap();
        shift_warning(cycle.warnings())
    };
    let lift = LoadStep::shift([3.0 * SIDE, 0.0]).normal(NormalLoad::Force(0.0));
    assert_eq!(add(&mut history, lift), None);
    assert_eq!(add(&mut history, press()), None);
    let roll = LoadStep::hold().roll(Rolling::new(1).creepage([0.09, 0.0]));
    let start = history.shift()[0];
    while history.shift()[0] - start <= 1.1 * SIDE {
        assert_eq!(add(&mut history, roll), None);
    }
    let shift = history.shift()[0];
    let away = LoadStep::shift([shift + 0.9 * SIDE, 0.0]);
    assert_eq!(add(&mut history, away), None);
    let further = LoadStep::shift([shift + 1.5 * SIDE, 0.0]);
    let step = history.step(&further).unwrap();
    let expected = Some(Warning::ShiftBeyondGrid { tenths: 15 });
    assert_eq!(shift_warning(step.warnings()), expected);
    cycle.add(&history).unwrap();
    assert_eq!(shift_warning(cycle.warnings()), expected);
}

/// The bodies of the second problem would be deformed twice.
#[test]
fn gap_under_load_of_another_problem_gives_warning() {
    let bodies = bodies();
    let contact = pressed(&bodies, &ball(&bodies));
    let again = pressed(&bodies, contact.gap());
    let cells = contact.contact_cells();
    assert_eq!(
        closed_warning(again.warnings()),
        Some(Warning::ClosedGap { cells })
    );
    let history = History::builder(&bodies, contact.gap(), friction());
    let mut history = history.build().unwrap();
    let step = history.step(&press()).unwrap();
    assert_eq!(
        closed_warning(step.warnings()),
        Some(Warning::ClosedGap { cells })
    );
    assert_eq!(closed_warning(contact.warnings()), None);
    // The gap of a smooth surface that is flat in its middle has one sign, and the gap of a flat punch is exactly zero.
    let flat = Field::from_fn(bodies.grid(), |x, y| 0.1 * x.hypot(y).powi(40));
    assert_eq!(closed_warning(pressed(&bodies, &flat).warnings()), None);
    let punch = Field::from_fn(
        bodies.grid(),
        |x, y| {
            if x.hypot(y) < 1.0 { 0.0 } else { 1.0 }
        },
    );
    assert_eq!(closed_warning(pressed(&bodies, &punch).warnings()), None);
}

/// The noise of the gap under load depends on the tolerance, and the displacement on a periodic grid differs from the approach.
#[test]
fn gap_under_load_of_periodic_and_adaptive_contacts_gives_warning() {
    let grid = Grid::square(48, SIDE).unwrap();
    let bodies = HalfSpace::with_boundary(grid, kit::unit_pair(0.3), Boundary::Periodic).unwrap();
    let waves = surface::bisinusoidal(grid, 0.01, [SIDE; 2]).unwrap();
    // The larger load closes the whole gap.
    for (part, is_whole) in [(0.004, false), (0.05, true)] {
        let press = NormalLoad::Force(part * SIDE * SIDE);
        for tolerance in [1e-5, 1e-8] {
            let contact = kit::press(&bodies, &waves, press, tolerance);
            assert_eq!(contact.contact_cells() == grid.cells(), is_whole);
            assert_eq!(closed_warning(contact.warnings()), None);
            let again = kit::press(&bodies, contact.gap(), press, tolerance);
            assert!(
                closed_warning(again.warnings()).is_some(),
                "{part} {tolerance}"
            );
        }
    }
    let region = Region::rectangle([-1.5, 1.5], [-1.5, 1.5]).unwrap();
    let ball = |x: f64, y: f64| (x * x + y * y) / (2.0 * RADIUS);
    let problem = AdaptiveProblem::builder(kit::unit_pair(0.3), &ball, load(), region);
    let problem = problem.target(Quantity::Area, 1e-2).build().unwrap();
    let found = problem.solve().unwrap();
    let contact = found.normal();
    assert_eq!(closed_warning(contact.warnings()), None);
    let again = NormalProblem::builder(found.bodies(), contact.gap(), load());
    assert!(closed_warning(kit::solve(again).warnings()).is_some());
}

#[test]
fn gap_under_load_of_line_contact_gives_warning() {
    for period in [1e-3, 1.0, 1e3] {
        let grid = Grid::new(64, 1, SIDE / 64.0, period).unwrap();
        let boundary = Boundary::PeriodicAlongY { datum: 2.0 * SIDE };
        let bodies = HalfSpace::with_boundary(grid, kit::unit_pair(0.3), boundary).unwrap();
        let press = NormalLoad::Force(0.01 * period);
        let solved = |gap: &Field| kit::solve(NormalProblem::builder(&bodies, gap, press));
        let contact = solved(&surface::cylinder(grid, RADIUS).unwrap());
        assert_eq!(closed_warning(contact.warnings()), None);
        let cells = contact.contact_cells();
        let expected = Some(Warning::ClosedGap { cells });
        assert_eq!(closed_warning(solved(contact.gap()).warnings()), expected);
        // A crowned roller with a flat middle.
        let crowned = Field::from_fn(grid, |x, _| 0.1 * x.abs().powi(12));
        assert_eq!(closed_warning(solved(&crowned).warnings()), None);
    }
}

/// Flat surfaces with round-off, and surfaces that are far smoother than the displacement.
#[test]
fn almost_flat_surfaces_give_no_warning_of_closed_gap() {
    let bodies = HalfSpace::new(Grid::square(48, SIDE).unwrap(), kit::unit_pair(0.3)).unwrap();
    let noise = |size: f64| kit::rough(bodies.grid(), 3).scaled(size);
    let punch = |jump: f64| {
        let mut gap = noise(1e-9);
        let edge = Field::from_fn(
            bodies.grid(),
            |x, y| if x.hypot(y) < 1.0 { 0.0 } else { jump },
        );
        gap.add_scaled(1.0, &edge).unwrap();
        gap
    };
    for gap in [
        noise(1e-17),
        noise(1e-9),
        noise(1e-6),
        punch(1.0),
        punch(0.02),
    ] {
        assert_eq!(closed_warning(pressed(&bodies, &gap).warnings()), None);
    }
}
