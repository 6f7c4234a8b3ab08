//! Contacts solved by CONTACT satisfy the laws of contact with the influence coefficients of this crate.
//!
//! Displacements are sums over the cells in contact. The tests use no solver of this crate.

use kit::contact::{Case, Cell, Normal, ReferenceStep, Tangential};
use stickslip::influence::{Component, Table};

/// Tolerance relative to the approach, to the tangential displacement, or to the friction limit at the largest
/// pressure.
const TOLERANCE: f64 = 2e-8;

/// Influence coefficients for displacements that are sums over the cells in contact.
struct Displacements {
    zz: Table,
    xx: Table,
    xy: Table,
    yy: Table,
}

impl Displacements {
    fn of(case: &Case) -> Self {
        let table = |component| Table::sample(case.grid, &case.pair, component).unwrap();
        Self {
            zz: table(Component::ZZ),
            xx: table(Component::XX),
            xy: table(Component::XY),
            yy: table(Component::YY),
        }
    }

    /// Returns the displacement along z, summed over the bodies.
    fn normal(&self, cells: &[Cell], [ix, iy]: [usize; 2]) -> f64 {
        let term = |cell: &Cell| coefficient(&self.zz, cell, [ix, iy]) * cell.pressure;
        cells.iter().map(term).sum()
    }

    /// Returns the displacement along x and y of body 1 minus body 2.
    fn tangential(&self, cells: &[Cell], place: [usize; 2]) -> [f64; 2] {
        cells.iter().fold([0.0, 0.0], |[x, y], cell| {
            let [q_x, q_y] = cell.traction;
            let lateral = coefficient(&self.xy, cell, place);
            [
                x + coefficient(&self.xx, cell, place) * q_x + lateral * q_y,
                y + lateral * q_x + coefficient(&self.yy, cell, place) * q_y,
            ]
        })
    }
}

/// Returns the coefficient for the traction of a cell and the displacement at a position.
fn coefficient(table: &Table, from: &Cell, [ix, iy]: [usize; 2]) -> f64 {
    let distance = [(ix, from.ix), (iy, from.iy)].map(|(to, from)| to as isize - from as isize);
    table.get(distance[0], distance[1]).unwrap()
}

/// Checks that two numbers agree within the tolerance relative to a scale.
#[track_caller]
fn assert_near(found: f64, expected: f64, scale: f64) {
    let error = (found - expected).abs() / scale;
    assert!(error <= TOLERANCE, "{found:e} for {expected:e}: {error:e}");
}

/// Checks that the pressure is positive only where the gap is closed, that it is zero where the gap is open, and
/// that the load is the prescribed load.
fn assert_normal_contact(case: &Case, step: &ReferenceStep, displacements: &Displacements) {
    let load: f64 = step.cells.iter().map(|cell| cell.pressure).sum();
    assert_near(load * case.grid.cell_area(), step.load, step.load);
    match step.normal {
        Normal::Force(force) => assert_near(step.load, force, force),
        Normal::Approach(approach) => assert_near(step.approach, approach, approach),
        Normal::Pressure => return,
    }
    let (gap, pressure) = (case.gap(step), case.field(step, |cell| cell.pressure));
    for iy in 0..case.grid.ny() {
        for ix in 0..case.grid.nx() {
            let displacement = displacements.normal(&step.cells, [ix, iy]);
            let open = gap.get(ix, iy).unwrap() + displacement - step.approach;
            if pressure.get(ix, iy).unwrap() > 0.0 {
                assert_near(open, 0.0, step.approach);
            } else {
                assert!(open >= -TOLERANCE * step.approach, "{open:e}");
            }
        }
    }
}

/// Checks Coulomb's law cell by cell, the forces, and the energies.
fn assert_friction(
    case: &Case,
    step: &ReferenceStep,
    before: &[Cell],
    displacements: &Displacements,
) {
    let area = case.grid.cell_area();
    let limit = |cell: &Cell| case.friction * cell.pressure;
    let largest_limit = step.cells.iter().map(limit).fold(0.0, f64::max);
    let now: Vec<[f64; 2]> = step
        .cells
        .iter()
        .map(|cell| displacements.tangential(&step.cells, [cell.ix, cell.iy]))
        .collect();
    let scale = now.iter().fold(0.0_f64, |m, u| m.max(u[0].hypot(u[1])));
    let (mut force, mut work, mut energy) = ([0.0, 0.0], 0.0, 0.0);
    for (cell, now) in step.cells.iter().zip(now) {
        let then = displacements.tangential(before, [cell.ix, cell.iy]);
        let slip = [0, 1].map(|axis| now[axis] - then[axis] - step.shift[axis]);
        let traction = cell.traction[0].hypot(cell.traction[1]);
        if cell.sticks {
            assert_near(slip[0].hypot(slip[1]), 0.0, scale);
            assert!(traction <= limit(cell) + TOLERANCE * largest_limit);
        } else {
            assert_near(traction, limit(cell), largest_limit);
            let length = slip[0].hypot(slip[1]);
            for (slip, q) in slip.into_iter().zip(cell.traction) {
                assert_near(slip, -length * q / traction, scale);
            }
        }
        let normal = displacements.normal(&step.cells, [cell.ix, cell.iy]);
        for axis in [0, 1] {
            force[axis] += area * cell.traction[axis];
            work -= area * cell.traction[axis] * slip[axis];
            energy += 0.5 * area * cell.traction[axis] * now[axis];
        }
        energy += 0.5 * area * cell.pressure * normal;
    }
    let sliding = case.friction * step.load;
    for (axis, found) in force.into_iter().enumerate() {
        assert_near(found, step.force[axis], sliding);
        match step.tangential[axis] {
            Tangential::Force(wanted) => assert_near(found, wanted, sliding),
            Tangential::Shift(wanted) => assert_near(step.shift[axis], wanted, scale),
        }
    }
    assert_near(work, step.dissipated_energy, sliding * scale);
    if let Some(expected) = step.elastic_energy {
        assert_near(energy, expected, expected);
    }
}

/// Name, number of steps, and number of cells of each case with similar bodies.
const CASES: [(&str, usize, usize); 6] = [
    ("cattaneo_pe_ball", 1, 177),
    ("tb01_cattaneo_disp", 1, 177),
    ("tb10_tb11_mindlin_steps", 2, 177),
    ("tb13_cattaneo_hertz_bound", 1, 973),
    ("catt_to_cart_start", 1, 621),
    ("catt_to_cart_shift_history", 21, 621),
];

/// Checks the first steps of each file, or all steps in the campaign. In the last file, cells come into contact at the
/// leading edge and leave the contact at the trailing edge.
#[test]
fn cases_satisfy_contact_laws() {
    for (name, steps, cells) in CASES {
        let case = Case::read(name, steps);
        let displacements = Displacements::of(&case);
        let mut before: &[Cell] = &[];
        for step in case.steps.iter().take(kit::thorough(2, steps)) {
            assert_eq!(step.cells.len(), cells);
            assert_normal_contact(&case, step, &displacements);
            let from = if step.continues { before } else { &[] };
            assert_friction(&case, step, from, &displacements);
            before = &step.cells;
        }
    }
}
