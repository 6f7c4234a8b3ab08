//! Warnings about limits above the modulus, long springs, motions of many small steps, and gaps under load.

use stickslip::history::{Cycle, FrettingLoop, LoadPath, Rolling};
use stickslip::layers::Layer;
use stickslip::normal::Hardness;
use stickslip::rolling::RollingProblem;
use stickslip::{
    CoupledProblem, ElasticPair, Field, Friction, Grid, HalfSpace, History, LoadStep, Material,
    NormalLoad, NormalProblem, NormalSolution, TangentialLoad, TangentialModel, TangentialProblem,
    Warning, surface,
};

const RADIUS: f64 = 20.0;

/// Side of the grid.
const SIDE: f64 = 2.8;

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

fn spring_warning(warnings: Vec<Warning>) -> Option<Warning> {
    kit::first_of(warnings, |w| matches!(w, Warning::SpringBeyondGrid { .. }))
}

fn closed_warning(warnings: Vec<Warning>) -> Option<Warning> {
    kit::first_of(warnings, |w| matches!(w, Warning::ClosedGap { .. }))
}

/// Limits in contact moduli, and the values that the warnings state.
const LIMITS: [(f64, Option<usize>); 3] =
    [(0.9, None), (1.5, Some(1_500)), (1e6, Some(1_000_000_000))];

#[test]
fn hardness_above_modulus_gives_warning_in_every_solution() {
    let bodies = bodies();
    let ball = ball(&bodies);
    for (limit, per_mille) in LIMITS {
        let expected = per_mille.map(|per_mille| Warning::HardnessBeyondModulus { per_mille });
        let hardness = Hardness::uniform(limit).unwrap();
        let normal = NormalProblem::builder(&bodies, &ball, load());
        let limited = kit::solve(normal.clone().hardness(hardness.clone()));
        assert_eq!(hardness_warning(limited.warnings()), expected);
        // Cells that carry no pressure do not count, and the smallest other limit counts.
        let mut limits = Field::constant(bodies.grid(), 10.0 * limit);
        limits.as_mut_slice()[0] = 0.0;
        limits.as_mut_slice()[9] = limit;
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

        let [body, _] = bodies.pair().bodies();
        let stated = body.with_hardness(limit).unwrap();
        let of_material =
            HalfSpace::new(bodies.grid(), ElasticPair::new(stated, body).unwrap()).unwrap();
        assert_eq!(
            hardness_warning(pressed(&of_material, &ball).warnings()),
            expected
        );
    }
}

/// A hardness that cells have reached has an effect. The modulus of a soft layer does not bound the pressure of a coated body.
#[test]
fn hardness_with_effect_gives_no_warning() {
    let hardness = Hardness::uniform(1.5).unwrap();
    let bodies = bodies();
    let deep = NormalProblem::builder(&bodies, ball(&bodies), NormalLoad::Approach(20.0));
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
        let friction = friction().max_shear_stress(cap).unwrap();
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
    // A large coefficient with a cap models a constant limit, and the cap has an effect.
    let constant = Friction::coulomb(1e3).unwrap();
    let constant = constant.max_shear_stress(1.5).unwrap();
    let tangential = TangentialProblem::builder(&bodies, &normal, constant, dragged);
    assert_eq!(cap_warning(kit::solve(tangential).warnings()), None);
}

/// Exchanged values of position and stiffness prescribe almost the same force, with a spring a million grids long.
#[test]
fn long_spring_gives_warning() {
    let bodies = bodies();
    let ball = ball(&bodies);
    let normal = pressed(&bodies, &ball);
    let force = 0.2 * normal.force();
    for (sides, has_warning) in [(900.0, false), (2_000.0, true), (3e9, true)] {
        let position = sides * SIDE;
        let stiffness = force / position;
        let is_expected = |found: Option<Warning>| match found {
            Some(Warning::SpringBeyondGrid { sides: stated }) => {
                has_warning && (stated as f64 / sides - 1.0).abs() < 1e-3
            }
            _ => !has_warning,
        };
        let dragged = TangentialLoad::spring([0.0, -position], stiffness);
        let tangential = TangentialProblem::builder(&bodies, &normal, friction(), dragged);
        let tangential = kit::solve(tangential.model(TangentialModel::Vector));
        let [_, along_y] = tangential.force();
        assert!((along_y / -force - 1.0).abs() < 1e-5);
        assert!(is_expected(spring_warning(tangential.warnings())));
        let coupled = CoupledProblem::builder(&bodies, &ball, friction(), load(), dragged);
        assert!(is_expected(spring_warning(kit::solve(coupled).warnings())));

        let mut history = new_history(&bodies, friction());
        history.step(&press()).unwrap();
        let mut cycle = Cycle::new(&history);
        let step = LoadStep::spring([0.0, -position], stiffness);
        let first = history.step(&step).unwrap();
        assert!(is_expected(spring_warning(first.warnings())));
        cycle.add(&history).unwrap();
        let back = history.step(&LoadStep::force([0.0; 2])).unwrap();
        assert_eq!(spring_warning(back.warnings()), None);
        cycle.add(&history).unwrap();
        assert!(is_expected(spring_warning(cycle.warnings())));
    }
}

/// Each step of the cycle is smaller than the grid.
#[test]
fn range_of_shift_in_cycle_gives_warning() {
    let bodies = bodies();
    let is_beyond = |w: &Warning| matches!(w, Warning::ShiftBeyondGrid { .. });
    for (amplitude, tenths) in [(0.45, None), (1.5, Some(30))] {
        let expected = tenths.map(|tenths| Warning::ShiftBeyondGrid { tenths });
        let mut history = new_history(&bodies, friction());
        history.step(&press()).unwrap();
        let mut cycle = Cycle::new(&history);
        let path = LoadPath::sine([amplitude * SIDE, 0.0], 40).unwrap();
        for &shift in path.steps() {
            let step = history.step(&LoadStep::shift(shift)).unwrap();
            assert_eq!(kit::first_of(step.warnings(), is_beyond), None);
            cycle.add(&history).unwrap();
        }
        assert_eq!(kit::first_of(cycle.warnings(), is_beyond), expected);
        cycle.begin(&history).unwrap();
        assert_eq!(kit::first_of(cycle.warnings(), is_beyond), None);
        let fretting = FrettingLoop::new(path, LoadStep::shift);
        fretting.cycle(&mut history, &mut cycle).unwrap();
        assert_eq!(kit::first_of(cycle.warnings(), is_beyond), expected);
    }
}

#[test]
fn range_of_twist_in_cycle_gives_warning() {
    let bodies = bodies();
    let is_large = |w: &Warning| matches!(w, Warning::LargeTwist { .. });
    for (twist, tenths) in [(0.09, None), (0.15, Some(3))] {
        let mut history = new_history(&bodies, friction());
        history.step(&press()).unwrap();
        let mut cycle = Cycle::new(&history);
        for part in [0.5, 1.0, 0.0, -1.0] {
            let step = LoadStep::hold().twist(part * twist);
            let step = history.step(&step).unwrap();
            assert_eq!(kit::first_of(step.warnings(), is_large), None);
            cycle.add(&history).unwrap();
        }
        let expected = tenths.map(|tenths| Warning::LargeTwist { tenths });
        assert_eq!(kit::first_of(cycle.warnings(), is_large), expected);
    }
}

/// Bodies that roll move further than the grid.
#[test]
fn cycle_with_rolled_steps_has_no_warning_of_shift() {
    let bodies = bodies();
    let mut history = new_history(&bodies, friction());
    history.step(&press()).unwrap();
    let mut cycle = Cycle::new(&history);
    let roll = LoadStep::hold().roll(Rolling::new(1).creepage([0.09, 0.0]));
    while 2.0 * cycle.shift_amplitude()[0] <= 1.1 * SIDE {
        history.step(&roll).unwrap();
        cycle.add(&history).unwrap();
    }
    let warnings = cycle.warnings();
    assert_eq!(
        kit::first_of(warnings, |w| matches!(w, Warning::ShiftBeyondGrid { .. })),
        None
    );
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
