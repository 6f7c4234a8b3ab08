//! Other codes on the same cells.

use kit::contact::{Case, ReferenceStep};
use stickslip::history::EntryRule;
use stickslip::normal::Hardness;
use stickslip::rolling::{CoupledRollingProblem, LeadingEdge, RollingControl, RollingProblem};
use stickslip::subsurface::{Body, Tractions, at_points};
use stickslip::{
    Axis, ElasticPair, Field, Friction, Grid, HalfSpace, History, Material, NormalLoad,
    NormalProblem, Result, TangentialModel, TangentialProblem,
};

use crate::Group;
use crate::row::{Row, alike, data_lines, largest_difference, numbers, press, relative, rows};

const CONTACT: &str = "CONTACT";
const TOLERANCE: f64 = 1e-10;

macro_rules! data {
    ($name:literal) => {
        include_str!(concat!("../../../data/", $name))
    };
}

pub(crate) fn group() -> Result<Group> {
    let mut rows = hertz()?;
    rows.extend(prescribed_pressure()?);
    rows.extend(histories()?);
    rows.extend(rolling()?);
    rows.extend(rolled_pair()?);
    rows.extend(stresses()?);
    rows.extend(hardness()?);
    Ok(Group {
        heading: "Other codes",
        caption: "CONTACT (Vollebregt and Kalker, open source, revision 2707) uses the same cells and the same uniform tractions. The\n\
                  remaining difference is due to tolerances and to the printed digits. Errors of fields are the largest of all\n\
                  components and steps, relative to the largest pressure. The creepage of aluminium on steel is printed with four\n\
                  digits. The stresses are closed forms, summed over the cells below tractions of CONTACT.",
        rows,
    })
}

fn hertz() -> Result<Vec<Row>> {
    let side = 0.133_333_684_210_526_3;
    let grid = Grid::new(19, 19, side, side)?;
    let bodies = HalfSpace::new(grid, alike(Material::from_shear_modulus(200.0, 0.42)?)?)?;
    let gap = Field::from_fn(grid, |x, y| 0.01 * (x * x + y * y));
    let found = press(&bodies, &gap, 9.1954);
    let mut expected = Field::zeros(grid);
    for line in data_lines(data!("hertz_contact.csv")) {
        let mut columns = line.split(',');
        let mut index = || {
            let text = columns.next()?;
            Some(text.parse::<usize>().ok()? - 1)
        };
        let place = index().zip(index());
        if let Some((ix, iy)) = place {
            expected.as_mut_slice()[iy * 19 + ix] = numbers(line)[2];
        }
    }
    let error = largest_difference(found.pressure().as_slice(), expected.as_slice());
    Ok(rows(
        CONTACT,
        "19 x 19",
        "contact_reference_normal::hertz_contact_on_nineteen_cells_matches",
        [("pressure of a sphere", error)],
    )
    .collect())
}

/// Returns the largest difference of both components of the traction, relative to the largest pressure.
fn traction_error(case: &Case, step: &ReferenceStep, traction: [&Field; 2]) -> f64 {
    let largest = case.field(step, |cell| cell.pressure).max();
    let errors = [0, 1].map(|axis| {
        let expected = case.field(step, |cell| cell.traction[axis]);
        kit::max_difference(traction[axis].as_slice(), expected.as_slice())
    });
    errors[0].max(errors[1]) / largest
}

fn cells(case: &Case) -> String {
    format!("{} x {}", case.grid.nx(), case.grid.ny())
}

fn prescribed_pressure() -> Result<Vec<Row>> {
    let case = Case::read("tb13_cattaneo_hertz_bound", 1);
    let step = &case.steps[0];
    let bodies = HalfSpace::new(case.grid, case.pair)?;
    let pressure = case.field(step, |cell| cell.pressure);
    let (friction, load) = (Friction::coulomb(case.friction)?, step.tangential_load());
    let found = TangentialProblem::builder(&bodies, &pressure, friction, load)
        .model(TangentialModel::Vector)
        .tolerance(TOLERANCE)
        .build()?
        .solve()?;
    let error = traction_error(&case, step, found.traction());
    Ok(rows(
        CONTACT,
        &cells(&case),
        "contact_reference_tangential::ball_with_prescribed_pressure_matches",
        [("traction under Hertz's pressure", error)],
    )
    .collect())
}

/// Follows the steps of a case. Returns its cells and the largest error of pressure and traction.
fn history_error(name: &str, steps: usize) -> Result<(String, f64)> {
    let case = Case::read(name, steps);
    let bodies = HalfSpace::new(case.grid, case.pair)?;
    let friction = Friction::coulomb(case.friction)?;
    let mut history = History::builder(&bodies, case.gap(&case.steps[0]), friction)
        .model(TangentialModel::Vector)
        .entry_rule(EntryRule::WholeStep)
        .tolerance(TOLERANCE)
        .build()?;
    let mut largest = 0.0_f64;
    for step in &case.steps {
        history.set_gap(&case.gap(step))?;
        history.step(&step.load_step(history.shift()))?;
        if step.cells.is_empty() {
            continue;
        }
        let pressure = case.field(step, |cell| cell.pressure);
        let error = largest_difference(history.pressure().as_slice(), pressure.as_slice());
        largest = largest.max(error);
        largest = largest.max(traction_error(&case, step, history.traction()));
    }
    Ok((cells(&case), largest))
}

fn histories() -> Result<Vec<Row>> {
    let cases = [
        (
            ("cattaneo_pe_ball", 1),
            "sheared ball, one step",
            "contact_reference_histories::ball_under_force_matches",
        ),
        (
            ("tb01_cattaneo_disp", 1),
            "ball under approach and shift, one step",
            "contact_reference_histories::ball_under_shift_matches",
        ),
        (
            ("tb10_tb11_mindlin_steps", 2),
            "ball partly unloaded, 2 steps",
            "contact_reference_histories::ball_partly_unloaded_matches",
        ),
        (
            ("catt_to_cart_shift_history", 21),
            "ball moved over a surface, 21 steps",
            "contact_reference_histories::ball_with_shift_history_matches",
        ),
        (
            ("spence35_dissimilar", 35),
            "ball pressed on a rigid plane, 35 steps",
            "coupled_histories::pressed_sphere_matches_contact_code",
        ),
        (
            ("tb25_tb26_flat_2d_dissimilar", 2),
            "punch on a soft body, pressed and tilted, 2 steps",
            "coupled_histories::tilted_punch_matches_contact_code",
        ),
    ];
    let mut all = Vec::new();
    for ((name, steps), quantity, test) in cases {
        let (cells, error) = history_error(name, steps)?;
        all.extend(rows(CONTACT, &cells, test, [(quantity, error)]));
    }
    Ok(all)
}

/// The expected forces and moment are values of the test.
fn rolling() -> Result<Vec<Row>> {
    let grid = Grid::new(41, 37, 0.0116, 0.0116)?;
    let bodies = HalfSpace::new(grid, alike(Material::from_shear_modulus(80_000.0, 0.25)?)?)?;
    let gap = Field::from_fn(grid, |x, y| 0.05 * (x * x + y * y));
    let normal = press(&bodies, &gap, 100.0);
    let found = RollingProblem::builder(&bodies, &normal, Friction::coulomb(0.3)?)
        .creepage([0.0016, -0.001])
        .spin(0.012)
        .entry_rule(EntryRule::WholeStep)
        .tolerance(TOLERANCE)
        .build()?
        .solve()?;
    let [x, y] = found.force();
    let expected = [13.68673121789, 0.837369325419, 1.331743198635];
    let error = largest_difference(&[x, y, found.moment()], &expected);
    Ok(rows(
        CONTACT,
        "41 x 37",
        "steady_rolling::steady_rolling_without_entry_law_matches_contact",
        [("forces and moment of a rolling ball", error)],
    )
    .collect())
}

/// The expected creepage is a value of the test. It has the opposite sign in CONTACT.
fn rolled_pair() -> Result<Vec<Row>> {
    let grid = Grid::new(216, 1, 0.001, 1000.0)?;
    let aluminium = Material::from_shear_modulus(23_000.0, 0.31)?;
    let steel = Material::from_shear_modulus(82_000.0, 0.28)?;
    let bodies = HalfSpace::new(grid, ElasticPair::new(aluminium, steel)?)?;
    let gap = Field::from_fn(grid, |x, _| 0.02 * x * x);
    let (friction, load) = (0.05, 16_201.9);
    let coulomb = Friction::coulomb(friction)?;
    let force = NormalLoad::Force(load);
    let found = CoupledRollingProblem::builder(&bodies, &gap, coulomb, force)
        .leading_edge(LeadingEdge::MinusX)
        .control(Axis::X, RollingControl::Force(0.75 * friction * load))
        .entry_rule(EntryRule::WholeStep)
        .tolerance(1e-7)
        .build()?
        .solve()?;
    let error = relative(-found.rolling().creepage()[0], 2.108e-4);
    Ok(rows(
        CONTACT,
        "216 x 1",
        "coupled_rolling::coupled_rollers_match_printed_digits_of_contact",
        [("creepage of aluminium on steel", error)],
    )
    .collect())
}

/// Compares displacements and stresses in both bodies below tractions that CONTACT computed.
fn stresses() -> Result<Vec<Row>> {
    let tractions = data!("subsurface/s02_partial_slip_ball.tractions.csv");
    let points = data!("subsurface/s02_partial_slip_ball.points.csv");
    let header = numbers(tractions.lines().nth(1).unwrap_or_default());
    let mut sizes = tractions
        .lines()
        .nth(1)
        .unwrap_or_default()
        .trim_start_matches("# ")
        .split(',')
        .filter_map(|text| text.parse::<usize>().ok());
    let (nx, ny) = sizes.next().zip(sizes.next()).unwrap_or_default();
    let grid = Grid::new(nx, ny, header[2], header[3])?;
    let body = |n: usize| Material::from_shear_modulus(header[n], header[n + 1]);
    let bodies = HalfSpace::new(grid, ElasticPair::new(body(4)?, body(6)?)?)?;
    let mut fields = [0, 1, 2].map(|_| Field::zeros(grid));
    for line in data_lines(tractions) {
        let mut places = line
            .split(',')
            .filter_map(|text| text.parse::<usize>().ok());
        let (column, row) = places.next().zip(places.next()).unwrap_or((1, 1));
        for (field, value) in fields.iter_mut().zip(&numbers(line)[2..]) {
            field.as_mut_slice()[(row - 1) * nx + column - 1] = *value;
        }
    }
    let [p, x, y] = &fields;
    let tractions = Tractions::new(p).with_traction([x, y]);
    let mut largest = 0.0_f64;
    for line in data_lines(points) {
        let row = numbers(line);
        let body = if row[2] < 0.0 { Body::Two } else { Body::One };
        let place = [row[0], row[1], row[2].abs()];
        let found = at_points(&bodies, body, tractions, &[place])?[0];
        let s = found.stress;
        let stresses = [s.xx, s.yy, s.zz, s.xy, s.xz, s.yz];
        largest = largest.max(largest_difference(&found.displacement, &row[4..7]));
        largest = largest.max(largest_difference(&stresses, &row[7..13]));
    }
    Ok(rows(
        "closed forms summed in 80-bit arithmetic",
        "40 x 40",
        "subsurface_points::point_stresses_match_reference_code",
        [("displacements and stresses at 63 points", largest)],
    )
    .collect())
}

fn hardness() -> Result<Vec<Row>> {
    let table = data!("hardness/rough_cap.csv");
    let lines = table.lines().filter(|line| !line.starts_with('#'));
    let column = |k: usize| -> Vec<f64> {
        let lines = lines.clone();
        lines
            .map(|line| numbers(line).get(k).copied().unwrap_or(0.0))
            .collect()
    };
    let grid = Grid::square(64, 0.64)?;
    let body = Material::new(115_384.615_384_615_39, 0.0)?;
    let bodies = HalfSpace::new(grid, ElasticPair::new(body, Material::rigid())?)?;
    let gap = Field::from_vec(grid, column(0))?;
    let found = NormalProblem::builder(&bodies, &gap, NormalLoad::Force(60.0))
        .hardness(Hardness::uniform(1800.0)?)
        .tolerance(1e-12)
        .build()?
        .solve()?;
    let error = largest_difference(found.pressure().as_slice(), &column(1));
    Ok(rows(
        "active-set Newton method, Tamaas 2.9",
        "64 x 64",
        "hardness::rough_cap_at_hardness_matches_reference",
        [("pressure limited to the hardness", error)],
    )
    .collect())
}
