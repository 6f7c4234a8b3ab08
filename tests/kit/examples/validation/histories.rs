//! Load histories of bodies of the same material.

use kit::{Table2, l2_difference, rough, unit_bodies, unit_pair};
use stickslip::analytical::{
    CattaneoMindlinLine, HertzLine, HertzSphere, LubkinTorsion, MindlinDeresiewicz,
    PopovLimitingShape,
};
use stickslip::tangential::{JaegerSuperposition, RelativeDisplacement};
use stickslip::{
    Axis, Field, Friction, Grid, HalfSpace, History, LoadStep, Material, NormalLoad, Result,
    TangentialControl, TangentialModel, surface,
};

use crate::Group;
use crate::row::{Row, alike, largest_difference, line, press, relative, rows};

const TOLERANCE: f64 = 1e-10;

pub(crate) fn group() -> Result<Group> {
    let mut rows = oscillating_force()?;
    rows.extend(line_cycle()?);
    rows.extend(bulk_cycle()?);
    rows.extend(twist()?);
    rows.extend(oblique_load()?);
    rows.extend(worn_ball()?);
    Ok(Group {
        heading: "Load histories",
        caption: "The contact is centred on the grid. The force oscillates between 0.8 of the sliding force and its opposite for the\n\
                  sphere, 0.7 for the cylinder and 0.6 under bulk stress. The unloaded state is at -0.5 of the sliding force, and the\n\
                  error of its shift is relative to the shift at sliding. The twist is 1.5 times the friction limit at the largest\n\
                  pressure over twice the shear modulus. The rough ball is pressed, sheared, and then pressed and sheared further in\n\
                  proportion. The ball in Popov's limiting shape is worn outside 0.6 of its contact radius, and the test verifies the\n\
                  closed form by quadrature.",
        rows,
    })
}

fn pressed(bodies: &HalfSpace, gap: &Field, coefficient: f64, force: f64) -> Result<History> {
    let builder = History::builder(bodies, gap, Friction::coulomb(coefficient)?);
    let mut history = builder.tolerance(TOLERANCE).build()?;
    history.step(&LoadStep::hold().normal(NormalLoad::Force(force)))?;
    Ok(history)
}

fn shear_to(history: &mut History, force: f64) -> Result<f64> {
    let load = LoadStep::hold().tangential(Axis::X, TangentialControl::Force(force));
    Ok(history.step(&load)?.energy().dissipated_energy)
}

fn oscillating_force() -> Result<Vec<Row>> {
    let hertz = HertzSphere::new(&Table2::pair(), Table2::RADIUS, Table2::FORCE)?;
    let limit = Table2::FRICTION * Table2::FORCE;
    let grid = Grid::square(192, 2.6 * hertz.contact_radius())?;
    let bodies = HalfSpace::new(grid, Table2::pair())?;
    let gap = surface::sphere(grid, Table2::RADIUS)?;
    let mut history = pressed(&bodies, &gap, Table2::FRICTION, Table2::FORCE)?;
    shear_to(&mut history, 0.8 * limit)?;
    let mut cycled = history.clone();
    for part in [0.4, 0.0, -0.5] {
        shear_to(&mut history, part * limit)?;
    }
    let path = [0.8 * limit, -0.5 * limit];
    let exact = MindlinDeresiewicz::new(hertz, Table2::FRICTION, &path)?;
    let traction = Field::from_fn(grid, |x, y| exact.traction(x.hypot(y)));
    let unloaded = [
        (
            "shift after unloading",
            (history.shift()[0] - exact.shift()).abs() / exact.sliding_shift(),
        ),
        (
            "traction after unloading, L2",
            l2_difference(history.traction()[0].as_slice(), traction.as_slice()),
        ),
    ];
    let mut energy = 0.0;
    for part in [0.0, -0.8, 0.0, 0.8] {
        energy += shear_to(&mut cycled, part * limit)?;
    }
    let cycle = [(
        "dissipated energy of a cycle",
        relative(energy, exact.energy_per_cycle()),
    )];
    let sphere = "sphere, Mindlin and Deresiewicz (1953)";
    let test = "history_mindlin_deresiewicz::unloading_traction_and_shift_converge";
    let unloaded = rows(sphere, "192 x 192", test, unloaded);
    let test = "history_mindlin_deresiewicz::energy_of_a_cycle_converges";
    Ok(unloaded
        .chain(rows(sphere, "192 x 192", test, cycle))
        .collect())
}

fn line_cycle() -> Result<Vec<Row>> {
    let (pair, radius, load) = (unit_pair(0.3), 50.0, 0.02);
    let hertz = HertzLine::new(&pair, radius, load)?;
    let force = 0.7 * 0.5 * load;
    let exact = CattaneoMindlinLine::new(hertz, 0.5, force)?;
    let bodies = line(512, 2.4 * hertz.half_width(), &pair)?;
    let gap = surface::cylinder(bodies.grid(), radius)?;
    let mut history = pressed(&bodies, &gap, 0.5, load)?;
    shear_to(&mut history, force)?;
    let energy = shear_to(&mut history, -force)? + shear_to(&mut history, force)?;
    let error = relative(energy, exact.energy_per_cycle());
    Ok(rows(
        "cylinder, Cattaneo (1938); Johnson (1985), 7.4",
        "512 x 1",
        "plane_strain_lines::cycle_dissipates_area_of_its_loop",
        [("dissipated energy of a cycle", error)],
    )
    .collect())
}

/// The bulk stress is in phase with the force.
fn bulk_cycle() -> Result<Vec<Row>> {
    let (steel, stress) = (Material::new(210e3, 0.3)?, 150.0);
    let pair = alike(steel)?;
    let hertz = HertzLine::new(&pair, 10.0, 100.0)?;
    let force = 0.6 * 0.5 * 100.0;
    let exact = CattaneoMindlinLine::new(hertz, 0.5, force)?.with_bulk_stress([stress, 0.0])?;
    let bodies = line(512, 2.4 * hertz.half_width(), &pair)?;
    let gap = surface::cylinder(bodies.grid(), 10.0)?;
    let strain = [[steel.plane_strain_under(1.0), 0.0], [0.0; 2]];
    let bulk = RelativeDisplacement::bulk_strain(bodies.grid(), strain)?;
    let builder = History::builder(&bodies, &gap, Friction::coulomb(0.5)?);
    let builder = builder.relative_displacement(bulk).tolerance(TOLERANCE);
    let mut history = builder.build()?;
    history.step(&LoadStep::hold().normal(NormalLoad::Force(100.0)))?;
    let load = LoadStep::force([force, 0.0]).relative_displacement(stress);
    let first = history.step(&load)?.energy().dissipated_energy;
    let error = relative(first, exact.energy_of_first_quarter());
    Ok(rows(
        "cylinder under bulk stress, Nowell and Hills (1987)",
        "512 x 1",
        "bulk_strain::loop_of_force_and_shift_encloses_work_of_force",
        [("dissipated energy of first loading", error)],
    )
    .collect())
}

fn twist() -> Result<Vec<Row>> {
    let (friction, load) = (0.4, 4.0);
    let grid = Grid::square(96, 12.0)?;
    let (bodies, gap) = (unit_bodies(grid, 0.3), surface::sphere(grid, 20.0)?);
    let hertz = HertzSphere::new(bodies.pair(), 20.0, load)?;
    let shear_modulus = bodies.pair().equivalent_shear_modulus();
    let angle = 1.5 * friction * hertz.max_pressure() / (2.0 * shear_modulus);
    let exact = LubkinTorsion::new(hertz, friction, angle)?;
    let builder = History::builder(&bodies, &gap, Friction::coulomb(friction)?);
    let builder = builder.model(TangentialModel::Vector).tolerance(TOLERANCE);
    let mut history = builder.build()?;
    history.step(&LoadStep::hold().normal(NormalLoad::Force(load)))?;
    history.step(&LoadStep::hold().twist(angle))?;
    let quantities = [
        ("moment", relative(history.moment(), exact.moment())),
        (
            "stick ratio",
            relative(history.last_step()?.stick_ratio(), exact.stick_ratio()),
        ),
    ];
    let test = "history_vector_model::twist_matches_lubkin";
    Ok(rows("twisted sphere, Lubkin (1951)", "96 x 96", test, quantities).collect())
}

/// The closed form is a sum of three normal contacts on the same grid, so the error is the tolerance of the solves.
fn oblique_load() -> Result<Vec<Row>> {
    let friction = 0.5;
    let grid = Grid::square(64, 64.0)?;
    let bodies = unit_bodies(grid, 0.0);
    let waves = rough(grid, 3);
    let ball = surface::sphere(grid, 576.0)?;
    let gap = surface::sum(&[&ball, &waves.scaled(0.02)])?;
    let whole = 32.0;
    let [before, after, stick] = [0.5, 0.9, 0.2].map(|part| press(&bodies, &gap, part * whole));
    let sheared = JaegerSuperposition::new(&before, &stick, bodies.pair(), friction)?;
    let force = friction * 0.3 * whole;
    let ratio = 0.3;
    let mut history = pressed(&bodies, &gap, friction, 0.5 * whole)?;
    history.step(&LoadStep::force([force, 0.0]))?;
    let load = LoadStep::force([force + ratio * 0.4 * whole, 0.0]);
    history.step(&load.normal(NormalLoad::Force(0.9 * whole)))?;
    let pressures = [&before, &after].map(|contact| contact.pressure().as_slice());
    let expected: Vec<f64> = (sheared.traction().iter().zip(pressures[0]))
        .zip(pressures[1])
        .map(|((q, before), after)| q + ratio * (after - before))
        .collect();
    let error = largest_difference(history.traction()[0].as_slice(), &expected);
    Ok(rows(
        "rough ball with nu = 0 under oblique load, superposition of Jaeger (1998)",
        "64 x 64",
        "growing_contact_step_size::growing_contact_matches_jaeger_superposition",
        [("traction, largest", error)],
    )
    .collect())
}

/// Presses a ball in the shape to which fretting wear leads.
fn worn_ball() -> Result<Vec<Row>> {
    let hertz = HertzSphere::new(&Table2::pair(), Table2::RADIUS, Table2::FORCE)?;
    let (a, approach) = (hertz.contact_radius(), hertz.approach());
    let shape = PopovLimitingShape::new(&Table2::pair(), Table2::RADIUS, approach, 0.6 * a)?;
    let grid = Grid::square(192, 2.6 * a)?;
    let bodies = HalfSpace::new(grid, Table2::pair())?;
    let gap = Field::from_fn(grid, |x, y| shape.profile(x.hypot(y)));
    let control = NormalLoad::Approach(approach);
    let found = kit::press(&bodies, &gap, control, TOLERANCE);
    Ok(rows(
        "worn ball, Popov (2014)",
        "192 x 192",
        "closed_forms::worn::worn_surfaces_just_touch_in_the_slip_ring",
        [("load", relative(found.force(), shape.load()))],
    )
    .collect())
}
