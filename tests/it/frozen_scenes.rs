//! Costs and results of small scenes, which must not change when the engine is rewritten. They are recorded in
//! `tests/data/frozen_scenes.csv`.
//!
//! `FREEZE=write cargo test --test it frozen_scenes` writes that file. Without the variable the test recomputes the
//! scenes and compares the results with the file. For `Exact` scenes, counts must be equal, and numbers must agree to
//! 1e-13 of their scale. For `Rounded` scenes, the order of sums has changed since the file was written. Counts may then differ
//! by a few, and numbers must agree to 1e-9 of their scale. For `Solver` scenes, counts are not compared, and numbers must
//! agree to 1e-9 of their scale.
//!
//! The iterations amplify rounding. If the last bits of the gaps change, numbers of more than half of the scenes change by more
//! than 1e-13. For solves with a tolerance of 1e-8 the change is up to 2e-9. Counts of a few solves change by one to five.
//! `Exact` therefore requires the same sums in the same order. It also requires the same vector units as on the processor that
//! wrote the file.
//!
//! The test also writes a hash of all bits of every scene to `frozen_bits`. This file is in the folder for temporary files of
//! the target directory. The hashes of two versions of the code can be compared on one machine.

use std::fmt::Write;

use kit::{Random, rough, unit_bodies, unit_pair};
use stickslip::Report;
use stickslip::cgm::Method;
use stickslip::history::{EntryRule, LoadPath, wear};
use stickslip::{
    Axis, Boundary, Field, Friction, Grid, HalfSpace, History, LoadStep, NormalLoad, NormalProblem,
    NormalSolution, NormalSolver, PressureSource, TangentialControl, TangentialLoad,
    TangentialModel, TangentialProblem, TangentialSolution, TangentialSolver, Zone, surface,
};

/// Required agreement of a recomputed scene with the file.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Agreement {
    Exact,
    Rounded,
    Solver,
}
use Agreement::{Exact, Rounded, Solver};

impl Agreement {
    fn tolerance(self) -> f64 {
        match self {
            Exact => 1e-13,
            Rounded | Solver => 1e-9,
        }
    }
}

/// Whether all scenes are compiled. A scene whose feature is disabled is left out, and the file of frozen results is
/// then not written.
const HAS_ALL_SCENES: bool = cfg!(feature = "dense");

/// Largest permitted change of counts of iterations and products due to rounding. Changes of up to 6 were measured.
const ROUNDED_COUNTS: i64 = 8;

/// Returns whether the transforms use the same code as on the processor that wrote the file. Transforms depend on the
/// vector units of the processor, which affects the rounding of all scenes.
fn has_the_same_transforms() -> bool {
    #[cfg(target_arch = "x86_64")]
    {
        std::arch::is_x86_feature_detected!("avx") && std::arch::is_x86_feature_detected!("fma")
    }
    #[cfg(not(target_arch = "x86_64"))]
    {
        false
    }
}

type FrozenScene = (&'static str, Agreement, fn(&mut Record));

const SCENES: &[FrozenScene] = &[
    ("sphere_by_force", Exact, sphere_by_force),
    ("sphere_by_approach", Exact, sphere_by_approach),
    ("rough_tenth_in_contact", Exact, rough_tenth_in_contact),
    ("rough_two_fifths", Exact, rough_two_fifths),
    ("periodic_rough", Exact, periodic_rough),
    ("periodic_wavy", Exact, periodic_wavy),
    ("oblong_odd_grid", Exact, oblong_odd_grid),
    ("warm_normal_loads", Exact, warm_normal_loads),
    ("contact_leaves_window", Exact, contact_leaves_window),
    ("large_nested", Rounded, large_nested),
    ("shear_x_by_force", Exact, shear_x_by_force),
    ("shear_y_by_shift", Exact, shear_y_by_shift),
    ("friction_per_cell_capped", Exact, friction_per_cell_capped),
    ("gross_sliding", Exact, gross_sliding),
    ("shear_polonsky_keer", Exact, shear_polonsky_keer),
    ("warm_shear", Rounded, warm_shear),
    ("plane_oblique_force", Rounded, plane_oblique_force),
    ("plane_oblique_shift", Rounded, plane_oblique_shift),
    ("plane_near_sliding", Rounded, plane_near_sliding),
    ("plane_periodic", Rounded, plane_periodic),
    ("plane_prescribed", Rounded, plane_prescribed),
    ("plane_warm", Rounded, plane_warm),
    ("history_wear", Exact, history_wear),
    ("history_plane_growth", Rounded, history_plane_growth),
    ("history_shifts_holds", Rounded, history_shifts_holds),
    ("history_restored", Rounded, history_restored),
    ("springs_scalar", Solver, springs_scalar),
    ("springs_plane", Solver, springs_plane),
    #[cfg(feature = "dense")]
    ("dense_intervals", Exact, dense_intervals),
];

// ---------------------------------------------------------------------------------------------------------------------
// Record of a scene.

/// Line of the file: the quantity, its value, and its scale or the type of count.
struct FrozenRow {
    quantity: String,
    value: String,
    scale: String,
}

/// Kinds of counts: counts that every scene must reproduce, and counts of the work of the solver.
const CELLS: &str = "cells";
const COSTS: &str = "costs";

struct Record {
    rows: Vec<FrozenRow>,
    /// FNV-1a hash of all bits.
    hash: u64,
    /// Prefix of the quantities of a solve.
    solve: String,
}

impl Record {
    fn of(scene: fn(&mut Self)) -> Self {
        let (hash, solve) = (0xcbf2_9ce4_8422_2325, String::new());
        let rows = Vec::new();
        let mut record = Self { rows, hash, solve };
        scene(&mut record);
        record
    }

    fn row(&mut self, quantity: &str, value: String, scale: &str) {
        let quantity = format!("{}{quantity}", self.solve);
        let scale = scale.to_owned();
        self.rows.push(FrozenRow {
            quantity,
            value,
            scale,
        });
    }

    fn bits(&mut self, values: &[f64]) {
        for byte in values
            .iter()
            .flat_map(|value| value.to_bits().to_le_bytes())
        {
            self.hash = (self.hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3);
        }
    }

    fn counts(&mut self, quantity: &str, counts: &[usize], kind: &str) {
        let words: Vec<String> = counts.iter().map(usize::to_string).collect();
        self.row(quantity, words.join(" "), kind);
        let counts: Vec<f64> = counts.iter().map(|&count| count as f64).collect();
        self.bits(&counts);
    }

    /// Records iterations and products in double and in single precision.
    fn costs(&mut self, quantity: &str, report: &Report) {
        let (double, single) = (
            report.double_precision_products,
            report.single_precision_products,
        );
        self.counts(quantity, &[report.iterations, double, single], COSTS);
        self.bits(&[report.residual, report.duality_gap, report.load_error]);
    }

    fn number(&mut self, quantity: &str, value: f64, scale: f64) {
        self.bits(&[value]);
        self.row(quantity, format!("{value:.16e}"), &format!("{scale:.3e}"));
    }

    /// Records three weighted sums of each list, with weights that never change. The lists have a common scale, the
    /// largest possible value of the sum.
    fn sums(&mut self, lists: &[(&str, &[f64])]) {
        for draw in 0..3 {
            let weights = |i: usize| Random(3 * i as u64 + draw).uniform(-1.0, 1.0);
            let sum = |list: &[f64], part: fn(f64) -> f64| -> f64 {
                let products = list.iter().enumerate().map(|(i, f)| weights(i) * f);
                products.map(part).sum()
            };
            let scale = lists.iter().map(|(_, list)| sum(list, f64::abs)).sum();
            for (name, list) in lists {
                self.number(&format!("{name} sum {draw}"), sum(list, |f| f), scale);
            }
        }
        for (_, list) in lists {
            self.bits(list);
        }
    }

    fn plane(&mut self, name: &str, fields: [&Field; 2]) {
        let [x, y] = [format!("{name} x"), format!("{name} y")];
        let [along_x, along_y] = fields.map(Field::as_slice);
        self.sums(&[(&x, along_x), (&y, along_y)]);
    }

    fn zones(&mut self, zones: &[Zone]) {
        let cells =
            [Zone::Stick, Zone::Slip].map(|zone| zones.iter().filter(|z| **z == zone).count());
        self.counts("stick and slip cells", &cells, CELLS);
        let zones: Vec<f64> = zones.iter().map(|zone| f64::from(*zone as u8)).collect();
        self.bits(&zones);
    }

    fn record_normal(&mut self, solve: &str, answer: &NormalSolution) {
        self.solve = format!("{solve}: ");
        self.costs("costs", answer.report());
        self.counts("contact cells", &[answer.contact_cells()], CELLS);
        self.number("force", answer.force(), answer.force());
        self.number("approach", answer.approach(), answer.approach().abs());
        self.sums(&[("pressure", answer.pressure().as_slice())]);
        self.sums(&[("gap", answer.gap().as_slice())]);
    }

    fn record_tangential(&mut self, solve: &str, answer: &TangentialSolution) {
        self.solve = format!("{solve}: ");
        self.costs("costs", answer.report());
        self.zones(answer.zones());
        let (force, shift, dissipated) =
            (answer.force(), answer.shift(), answer.dissipated_energy());
        let size = |[x, y]: [f64; 2]| x.hypot(y);
        for axis in 0..2 {
            self.number(["force x", "force y"][axis], force[axis], size(force));
            self.number(["shift x", "shift y"][axis], shift[axis], size(shift));
        }
        self.number("dissipated", dissipated, dissipated);
        self.plane("traction", answer.traction());
        self.plane("slip", answer.slip());
    }
}

/// A history and the numbers of its steps.
struct Steps<'a> {
    record: &'a mut Record,
    /// Prefix that distinguishes the histories of a scene.
    name: &'a str,
    numbers: [Vec<f64>; 12],
}

const STEP_NUMBERS: [&str; 12] = [
    "normal force",
    "force x",
    "force y",
    "moment", // Lengths are about ten: a moment has the scale of a force.
    "approach",
    "shift x",
    "shift y",
    "twist",
    "work",
    "elastic",
    "dissipated",
    "released",
];

impl<'a> Steps<'a> {
    fn new(record: &'a mut Record, name: &'a str) -> Self {
        let numbers = Default::default();
        Self {
            record,
            name,
            numbers,
        }
    }

    fn step(&mut self, history: &mut History, load: &LoadStep) {
        let step = history.step(load).unwrap();
        self.record.solve = format!("{}step {:02}: ", self.name, self.numbers[0].len());
        for (name, report) in [
            ("press costs", step.normal_report()),
            ("shear costs", step.tangential_report()),
        ] {
            if let Some(report) = report {
                self.record.costs(name, report);
            }
        }
        let (force, shift, energy) = (step.tangential_force(), step.shift(), step.energy());
        let numbers = [
            step.normal_force(),
            force[0],
            force[1],
            step.moment(),
            step.approach(),
            shift[0],
            shift[1],
            step.twist(),
            energy.work,
            energy.elastic_after,
            energy.dissipated_energy,
            energy.released,
        ];
        self.record.bits(step.slip_distance().as_slice());
        self.record.bits(step.dissipation_midpoint().as_slice());
        for (list, number) in self.numbers.iter_mut().zip(numbers) {
            list.push(number);
        }
    }

    /// Records the sums over the steps and the final state.
    fn end(self, history: &History) {
        let record = self.record;
        record.solve = format!("{}steps: ", self.name);
        for (names, numbers) in STEP_NUMBERS.chunks(4).zip(self.numbers.chunks(4)) {
            let lists = names.iter().zip(numbers);
            let lists: Vec<_> = lists.map(|(name, list)| (*name, &list[..])).collect();
            record.sums(&lists);
        }
        record.solve = format!("{}end: ", self.name);
        record.zones(history.zones());
        record.sums(&[("pressure", history.pressure().as_slice())]);
        record.sums(&[("slip path", history.accumulated_slip().as_slice())]);
        record.sums(&[("dissipation", history.accumulated_dissipation().as_slice())]);
        record.plane("traction", history.traction());
        record.plane("slip", history.slip());
    }
}

// ---------------------------------------------------------------------------------------------------------------------
// Helper functions around the API of the crate.

const FRICTION: f64 = 0.4;
const LOAD: f64 = 4.0;
const LIMIT: f64 = FRICTION * LOAD;

/// Returns a ball with a contact radius of 3.9 under [`LOAD`], on a square with a side of 12.
fn ball_problem(cells: usize) -> (HalfSpace, Field) {
    let grid = kit::square(cells, 12.0);
    (unit_bodies(grid, 0.3), kit::sphere(grid, 20.0))
}

fn periodic_bodies(grid: Grid) -> HalfSpace {
    HalfSpace::with_boundary(grid, unit_pair(0.3), Boundary::Periodic).unwrap()
}

fn rough_plate(cells: usize, seed: u64) -> (HalfSpace, Field) {
    let grid = kit::square(cells, 64.0);
    (unit_bodies(grid, 0.3), rough(grid, seed))
}

fn normal_solver(
    bodies: &HalfSpace,
    gap: &Field,
    load: NormalLoad,
    method: Method,
    tolerance: f64,
) -> NormalSolver {
    let builder = NormalProblem::builder(bodies, gap, load)
        .method(method)
        .tolerance(tolerance);
    kit::solver(builder)
}

fn press(bodies: &HalfSpace, gap: &Field, force: f64) -> NormalSolution {
    kit::press(bodies, gap, NormalLoad::Force(force), 1e-8)
}

fn shear_solver<'a>(
    bodies: &'a HalfSpace,
    pressure: impl Into<PressureSource<'a>>,
    friction: Friction,
    load: TangentialLoad,
    (lateral, method, tolerance): (TangentialModel, Method, f64),
) -> TangentialSolver {
    let builder = TangentialProblem::builder(bodies, pressure, friction, load).model(lateral);
    let problem = builder.method(method).tolerance(tolerance).build().unwrap();
    problem.into_solver().unwrap()
}

fn force_load(force: [f64; 2]) -> TangentialLoad {
    TangentialLoad::force(force)
}

fn shift_load(shift: [f64; 2]) -> TangentialLoad {
    TangentialLoad::shift(shift)
}

const SCALAR: (TangentialModel, Method, f64) = (TangentialModel::Scalar, Method::ActiveSet, 1e-8);
const PLANE: (TangentialModel, Method, f64) = (TangentialModel::Vector, Method::ActiveSet, 1e-8);

/// Solves once and records the solution.
fn solve_and_record<'a>(
    record: &mut Record,
    solve: &str,
    bodies: &'a HalfSpace,
    pressure: impl Into<PressureSource<'a>>,
    load: TangentialLoad,
    how: (TangentialModel, Method, f64),
) {
    let answer = kit::solved(&mut shear_solver(
        bodies,
        pressure,
        kit::coulomb(FRICTION),
        load,
        how,
    ));
    record.record_tangential(solve, &answer);
}

fn new_history(
    bodies: &HalfSpace,
    gap: &Field,
    axis: Option<Axis>,
    friction: Friction,
    tolerance: f64,
) -> History {
    // The old engine used this rule.
    let builder = History::builder(bodies, gap, friction)
        .tolerance(tolerance)
        .entry_rule(EntryRule::WholeStep);
    let builder = match axis {
        Some(axis) => builder.axis(axis),
        None => builder.model(TangentialModel::Vector),
    };
    builder.build().unwrap()
}

fn press_step(force: f64) -> LoadStep {
    LoadStep::hold().normal(NormalLoad::Force(force))
}

// ---------------------------------------------------------------------------------------------------------------------
// Normal contacts.

fn press_by_both_methods(record: &mut Record, bodies: &HalfSpace, gap: &Field, load: NormalLoad) {
    for (solve, method) in [
        ("active set", Method::ActiveSet),
        ("polonsky keer", Method::PolonskyKeer),
    ] {
        record.record_normal(solve, &kit::press_by(bodies, gap, load, 1e-8, method));
    }
}

fn sphere_by_force(record: &mut Record) {
    let (bodies, gap) = ball_problem(64);
    press_by_both_methods(record, &bodies, &gap, NormalLoad::Force(LOAD));
}

fn sphere_by_approach(record: &mut Record) {
    let (bodies, gap) = ball_problem(65);
    press_by_both_methods(record, &bodies, &gap, NormalLoad::Approach(0.7));
}

fn rough_tenth_in_contact(record: &mut Record) {
    let (bodies, gap) = rough_plate(96, 1);
    press_by_both_methods(record, &bodies, &gap, NormalLoad::Force(ROUGH_TENTH));
}

fn rough_two_fifths(record: &mut Record) {
    let (bodies, gap) = rough_plate(96, 2);
    press_by_both_methods(record, &bodies, &gap, NormalLoad::Force(ROUGH_TWO_FIFTHS));
}

/// Normal force under which a tenth of a rough surface of 96 x 96 cells is in contact.
const ROUGH_TENTH: f64 = 70.0;
/// Force for which two fifths of this surface are in contact.
const ROUGH_TWO_FIFTHS: f64 = 300.0;

fn periodic_rough(record: &mut Record) {
    let grid = Grid::new(64, 48, 1.0, 1.0).unwrap();
    let (bodies, gap) = (periodic_bodies(grid), rough(grid, 3));
    press_by_both_methods(record, &bodies, &gap, NormalLoad::Force(0.03 * grid.area()));
    record.record_normal(
        "approach",
        &kit::press(&bodies, &gap, NormalLoad::Approach(2.0), 1e-8),
    );
}

fn periodic_wavy(record: &mut Record) {
    let grid = kit::square(48, 12.0);
    let (bodies, gap) = (
        periodic_bodies(grid),
        surface::bisinusoidal(grid, 0.3, [6.0, 12.0]).unwrap(),
    );
    press_by_both_methods(record, &bodies, &gap, NormalLoad::Force(0.03 * grid.area()));
}

fn oblong_odd_grid(record: &mut Record) {
    let grid = Grid::new(71, 37, 0.5, 0.8).unwrap();
    let (bodies, mut gap) = (
        unit_bodies(grid, 0.2),
        surface::ellipsoid(grid, 150.0, 70.0).unwrap(),
    );
    gap.add_scaled(0.1, &rough(grid, 4)).unwrap();
    press_by_both_methods(record, &bodies, &gap, NormalLoad::Force(20.0));
}

fn warm_normal_loads(record: &mut Record) {
    let (bodies, gap) = rough_plate(64, 5);
    let first = NormalLoad::Force(60.0);
    let mut solver = normal_solver(&bodies, &gap, first, Method::ActiveSet, 1e-8);
    record.record_normal("first", &kit::solved(&mut solver));
    for (solve, load) in [
        ("more", NormalLoad::Force(66.0)),
        ("less", NormalLoad::Force(30.0)),
        ("approach", NormalLoad::Approach(2.0)),
    ] {
        solver.set_load(load).unwrap();
        record.record_normal(solve, &kit::solved(&mut solver));
    }
    solver.set_gap(&rough(bodies.grid(), 6)).unwrap();
    record.record_normal("other gap", &kit::solved(&mut solver));
    solver.reset();
    record.record_normal("cold", &kit::solved(&mut solver));
}

fn contact_leaves_window(record: &mut Record) {
    let (bodies, gap) = ball_problem(72);
    let first = NormalLoad::Force(0.01 * LOAD);
    let mut solver = normal_solver(&bodies, &gap, first, Method::ActiveSet, 1e-8);
    record.record_normal("small", &kit::solved(&mut solver));
    for (solve, force) in [("big", 1.5 * LOAD), ("small again", 0.02 * LOAD)] {
        solver.set_load(NormalLoad::Force(force)).unwrap();
        record.record_normal(solve, &kit::solved(&mut solver));
    }
}

/// Covers nested starts, windows and single precision, for pressure and shear.
fn large_nested(record: &mut Record) {
    let (bodies, mut gap) = ball_problem(256);
    gap.add_scaled(0.02, &rough(bodies.grid(), 7)).unwrap();
    let load = NormalLoad::Force(LOAD);
    let normal = kit::press(&bodies, &gap, load, 1e-6);
    record.record_normal("press", &normal);
    for (solve, lateral) in [
        ("shear", TangentialModel::Scalar),
        ("plane", TangentialModel::Vector),
    ] {
        let load = force_load([0.6 * LIMIT, 0.0]);
        solve_and_record(
            record,
            solve,
            &bodies,
            &normal,
            load,
            (lateral, Method::ActiveSet, 1e-6),
        );
    }
}

// ---------------------------------------------------------------------------------------------------------------------
// Shear along an axis.

fn shear_x_by_force(record: &mut Record) {
    let (bodies, gap) = ball_problem(64);
    let normal = press(&bodies, &gap, LOAD);
    for (solve, part) in [("little", 0.1), ("back", -0.5), ("much", 0.95)] {
        let load = force_load([part * LIMIT, 0.0]);
        solve_and_record(record, solve, &bodies, &normal, load, SCALAR);
    }
}

fn shear_y_by_shift(record: &mut Record) {
    let (bodies, gap) = rough_plate(96, 1);
    let normal = press(&bodies, &gap, ROUGH_TENTH);
    for (solve, shift) in [("little", 0.1), ("more", -0.4)] {
        let load = shift_load([0.0, shift]);
        solve_and_record(record, solve, &bodies, &normal, load, SCALAR);
    }
}

fn friction_per_cell_capped(record: &mut Record) {
    let (bodies, gap) = rough_plate(64, 8);
    let normal = press(&bodies, &gap, 100.0);
    let coefficients = Field::from_indices(bodies.grid(), |ix, iy| {
        0.2 + 0.05 * ((ix + 3 * iy) % 7) as f64
    });
    let friction = Friction::per_cell(coefficients).unwrap();
    let friction = friction
        .max_shear_stress(0.2 * normal.pressure().max())
        .unwrap();
    for (solve, load) in [
        ("force", force_load([15.0, 0.0])),
        ("shift", shift_load([0.0, 0.3])),
    ] {
        let mut solver = shear_solver(&bodies, &normal, friction.clone(), load, SCALAR);
        record.record_tangential(solve, &kit::solved(&mut solver));
    }
}

fn gross_sliding(record: &mut Record) {
    let (bodies, gap) = ball_problem(48);
    let normal = press(&bodies, &gap, LOAD);
    let limit = FRICTION * normal.force();
    for (solve, load, how) in [
        ("scalar force", force_load([-limit, 0.0]), SCALAR),
        ("scalar shift", shift_load([0.0, 5.0]), SCALAR),
        (
            "plane force",
            force_load([0.6 * limit, -0.8 * limit]),
            PLANE,
        ),
        ("plane shift", shift_load([5.0, 2.0]), PLANE),
    ] {
        solve_and_record(record, solve, &bodies, &normal, load, how);
    }
}

fn shear_polonsky_keer(record: &mut Record) {
    let (bodies, gap) = rough_plate(48, 9);
    let normal = press(&bodies, &gap, 60.0);
    let how = (TangentialModel::Scalar, Method::PolonskyKeer, 1e-8);
    solve_and_record(
        record,
        "force",
        &bodies,
        &normal,
        force_load([0.5 * FRICTION * 60.0, 0.0]),
        how,
    );
    solve_and_record(
        record,
        "shift",
        &bodies,
        &normal,
        shift_load([0.0, 0.2]),
        how,
    );
}

fn warm_shears(record: &mut Record, how: (TangentialModel, Method, f64), across: f64) {
    let (bodies, gap) = ball_problem(60);
    let normals = [1.0, 1.2, 0.7].map(|part| press(&bodies, &gap, part * LOAD));
    let load = |part: f64| force_load([part * LIMIT, across * part * LIMIT]);
    let mut solver = shear_solver(&bodies, &normals[0], kit::coulomb(FRICTION), load(0.4), how);
    record.record_tangential("first", &kit::solved(&mut solver));
    solver.set_load(load(0.5)).unwrap();
    record.record_tangential("more", &kit::solved(&mut solver));
    solver.set_pressure(&normals[1]).unwrap();
    record.record_tangential("pressed more", &kit::solved(&mut solver));
    solver.set_pressure(&normals[2]).unwrap();
    solver.set_load(load(-0.3)).unwrap();
    record.record_tangential("pressed less and back", &kit::solved(&mut solver));
    solver.set_friction(&kit::coulomb(0.3)).unwrap();
    solver.set_load(shift_load([0.1, across * 0.1])).unwrap();
    record.record_tangential("other friction and shift", &kit::solved(&mut solver));
}

fn warm_shear(record: &mut Record) {
    warm_shears(record, SCALAR, 0.0);
}

// ---------------------------------------------------------------------------------------------------------------------
// Shear in the plane.

fn plane_oblique_force(record: &mut Record) {
    let (bodies, gap) = ball_problem(64);
    let normal = press(&bodies, &gap, LOAD);
    let load = force_load([0.5 * LIMIT, -0.3 * LIMIT]);
    solve_and_record(record, "ball", &bodies, &normal, load, PLANE);
    let (bodies, gap) = rough_plate(64, 1);
    let normal = press(&bodies, &gap, 100.0);
    solve_and_record(
        record,
        "rough",
        &bodies,
        &normal,
        force_load([-8.0, 20.0]),
        PLANE,
    );
}

fn plane_oblique_shift(record: &mut Record) {
    let (bodies, gap) = rough_plate(72, 10);
    let normal = press(&bodies, &gap, 80.0);
    solve_and_record(
        record,
        "shift",
        &bodies,
        &normal,
        shift_load([0.15, 0.1]),
        PLANE,
    );
}

fn plane_near_sliding(record: &mut Record) {
    let (bodies, gap) = ball_problem(48);
    let normal = press(&bodies, &gap, LOAD);
    let force = 0.999 * FRICTION * normal.force();
    solve_and_record(
        record,
        "ball",
        &bodies,
        &normal,
        force_load([0.8 * force, 0.6 * force]),
        PLANE,
    );
}

fn plane_periodic(record: &mut Record) {
    let grid = Grid::new(48, 45, 1.0, 1.1).unwrap();
    let bodies = periodic_bodies(grid);
    let normal = press(&bodies, &rough(grid, 11), 0.03 * grid.area());
    let force = FRICTION * normal.force();
    solve_and_record(
        record,
        "force",
        &bodies,
        &normal,
        force_load([0.3 * force, 0.4 * force]),
        PLANE,
    );
    solve_and_record(
        record,
        "shift",
        &bodies,
        &normal,
        shift_load([-0.1, 0.2]),
        PLANE,
    );
}

fn plane_prescribed(record: &mut Record) {
    let grid = Grid::new(50, 41, 0.3, 0.25).unwrap();
    let bodies = unit_bodies(grid, 0.25);
    let pressure = Field::from_fn(grid, |x, y| {
        (1.0 - (x / 5.0).powi(2) - (y / 4.0).powi(2))
            .max(0.0)
            .sqrt()
    });
    let force = FRICTION * pressure.integral();
    for (solve, how) in [("plane", PLANE), ("scalar", SCALAR)] {
        let across = if how == PLANE { 0.5 * force } else { 0.0 };
        solve_and_record(
            record,
            solve,
            &bodies,
            &pressure,
            force_load([0.4 * force, across]),
            how,
        );
    }
}

fn plane_warm(record: &mut Record) {
    warm_shears(record, PLANE, 0.7);
}

// ---------------------------------------------------------------------------------------------------------------------
// Histories.

/// The normal load and the gap change under a force that oscillates.
fn history_wear(record: &mut Record) {
    let (bodies, gap) = ball_problem(48);
    let mut history = new_history(&bodies, &gap, Some(Axis::X), kit::coulomb(FRICTION), 1e-8);
    let mut steps = Steps::new(record, "");
    steps.step(&mut history, &press_step(LOAD));
    let path = LoadPath::sine([0.7 * LIMIT, 0.0], 8).unwrap();
    for (number, force) in path.cycles(2).enumerate() {
        let normal = LOAD * [1.0, 1.1, 1.3, 0.9][number % 4];
        let load = LoadStep::force(force).normal(NormalLoad::Force(normal));
        steps.step(&mut history, &load);
        let mut worn = history.unloaded_gap().clone();
        wear::archard(
            0.02,
            history.pressure(),
            history.last_step().unwrap().slip_distance(),
            &mut worn,
        )
        .unwrap();
        history.set_gap(&worn).unwrap();
    }
    steps.end(&history);
    record.sums(&[("gap", history.unloaded_gap().as_slice())]);
}

/// The force rotates under a twist, and the window of the contact grows.
fn history_plane_growth(record: &mut Record) {
    let (bodies, gap) = ball_problem(48);
    let mut history = new_history(&bodies, &gap, None, kit::coulomb(FRICTION), 1e-8);
    let mut steps = Steps::new(record, "");
    steps.step(&mut history, &press_step(0.05 * LOAD));
    steps.step(&mut history, &LoadStep::force([0.03 * LIMIT, 0.0]));
    let circle = LoadPath::ellipse([0.6 * LIMIT; 2], std::f64::consts::FRAC_PI_2, 8).unwrap();
    for (number, force) in circle.cycles(1).enumerate() {
        let twist = 0.01 * [1.0, 2.0, -1.0][number % 3];
        let load = LoadStep::force(force).twist(twist);
        steps.step(
            &mut history,
            &load.normal(NormalLoad::Force(LOAD * (1.0 + 0.1 * number as f64))),
        );
    }
    steps.step(&mut history, &LoadStep::hold().twist(0.03));
    steps.end(&history);
}

fn history_shifts_holds(record: &mut Record) {
    let grid = Grid::new(40, 47, 0.3, 0.25).unwrap();
    let coefficients = Field::from_fn(grid, |x, _| 0.4 + 0.01 * x);
    let friction = Friction::per_cell(coefficients)
        .unwrap()
        .max_shear_stress(0.08)
        .unwrap();
    let (bodies, mut gap) = (unit_bodies(grid, 0.3), kit::sphere(grid, 20.0));
    gap.add_scaled(0.03, &rough(grid, 12)).unwrap();
    for (name, axis, periodic) in [
        ("along y ", Some(Axis::Y), false),
        ("plane ", None, false),
        ("periodic ", None, true),
    ] {
        let bodies = if periodic {
            periodic_bodies(grid)
        } else {
            bodies.clone()
        };
        let mut history = new_history(&bodies, &gap, axis, friction.clone(), 1e-8);
        let across = if axis.is_none() { 0.1 } else { 0.0 };
        let mut steps = Steps::new(record, name);
        for load in [
            LoadStep::hold().normal(NormalLoad::Approach(0.5)),
            LoadStep::shift([across, 0.1]),
            LoadStep::shift([-across, 0.25]).normal(NormalLoad::Force(LOAD)),
            press_step(0.6 * LOAD),
            LoadStep::hold(),
            LoadStep::hold().tangential(Axis::Y, TangentialControl::Shift(-0.2)),
            press_step(0.0),
            press_step(0.8 * LOAD),
            LoadStep::hold().tangential(Axis::Y, TangentialControl::Force(0.1)),
        ] {
            steps.step(&mut history, &load);
        }
        steps.end(&history);
    }
}

fn history_restored(record: &mut Record) {
    let (bodies, gap) = ball_problem(40);
    for (name, axis) in [("along y ", Some(Axis::Y)), ("plane ", None)] {
        let mut history = new_history(&bodies, &gap, axis, kit::coulomb(FRICTION), 1e-8);
        let across = if axis.is_none() { 0.3 } else { 0.0 };
        let load = |part: f64| LoadStep::force([across * part * LIMIT, part * LIMIT]);
        let mut steps = Steps::new(record, name);
        for load in [press_step(LOAD), load(0.7), load(-0.2)] {
            steps.step(&mut history, &load);
        }
        let mut restored = History::from_bytes(&bodies, &history.to_bytes()).unwrap();
        for load in [
            load(0.4),
            load(0.1).normal(NormalLoad::Force(1.4 * LOAD)),
            load(-0.8),
        ] {
            steps.step(&mut restored, &load);
        }
        steps.end(&restored);
    }
}

fn springs_scalar(record: &mut Record) {
    let (bodies, gap) = ball_problem(48);
    for (name, stiffness) in [("soft ", 0.1), ("equal ", 4.0), ("stiff ", 1e3)] {
        let mut history = new_history(&bodies, &gap, Some(Axis::Y), kit::coulomb(FRICTION), 1e-12);
        let mut steps = Steps::new(record, name);
        steps.step(&mut history, &press_step(LOAD));
        for part in [0.5, 0.9, -0.4, 3.0, 0.2] {
            let position = part * LIMIT * (0.25 + 1.0 / stiffness);
            let load = LoadStep::hold().tangential(Axis::Y, kit::spring(position, stiffness));
            steps.step(&mut history, &load);
        }
        steps.end(&history);
    }
}

fn springs_plane(record: &mut Record) {
    let (bodies, gap) = ball_problem(48);
    let mut history = new_history(&bodies, &gap, None, kit::coulomb(FRICTION), 1e-12);
    let mut steps = Steps::new(record, "");
    steps.step(&mut history, &press_step(LOAD));
    for (x, y, twist) in [
        (kit::spring(0.4, 4.0), kit::spring(-0.2, 1.0), 0.0),
        (
            kit::spring(0.6, 4.0),
            TangentialControl::Force(0.4 * LIMIT),
            0.02,
        ),
        (TangentialControl::Shift(-0.1), kit::spring(0.4, 8.0), 0.02),
        (TangentialControl::Hold, kit::spring(-0.5, 8.0), -0.01),
        (kit::spring(-0.5, 4.0), kit::spring(0.5, 4.0), 0.0),
    ] {
        let load = LoadStep::hold()
            .tangential(Axis::X, x)
            .tangential(Axis::Y, y);
        steps.step(&mut history, &load.twist(twist));
    }
    steps.end(&history);
}

// ---------------------------------------------------------------------------------------------------------------------
// The engine on a matrix.

#[cfg(feature = "dense")]
fn dense_intervals(record: &mut Record) {
    use stickslip::cgm::{Bounds, Problem, Settings, minimise};
    use stickslip::dense::DenseOperator;
    use stickslip::influence::Component;

    let bodies = unit_bodies(Grid::new(13, 11, 1.0, 1.2).unwrap(), 0.3);
    let matrix = DenseOperator::of_half_space(&bodies, Component::XX).unwrap();
    let mut random = Random(13);
    let mut draws =
        |low, high| -> Vec<f64> { (0..143).map(|_| random.uniform(low, high)).collect() };
    let (mut lower, mut upper, linear) = (draws(-1.0, 0.0), draws(0.0, 1.0), draws(-2.0, 2.0));
    (lower[3], upper[70], upper[5]) = (f64::NEG_INFINITY, f64::INFINITY, 0.0);
    for (solve, method) in [
        ("active set", Method::ActiveSet),
        ("polonsky keer", Method::PolonskyKeer),
    ] {
        for (with, total) in [("", None), (" with total", Some(7.0))] {
            let bounds = Bounds {
                lower: &lower,
                upper: &upper,
            };
            let mut problem = Problem::new(&matrix, [&linear], bounds);
            if let Some(total) = total {
                problem = problem.total(total);
            }
            let settings = Settings::default().tolerance(1e-10).method(method);
            let mut x = vec![0.0; 143];
            let minimum = minimise(&problem, &settings, [&mut x]).unwrap();
            record.solve = format!("{solve}{with}: ");
            record.costs("costs", &minimum.report);
            let [multiplier] = minimum.multiplier;
            record.number("multiplier", multiplier, multiplier.abs());
            record.sums(&[("x", &x)]);
        }
    }
}

// ---------------------------------------------------------------------------------------------------------------------
// Writing and comparison.

const HEADING: &str = "# Costs and answers of small scenes, computed by this crate itself: see tests/it/frozen_scenes.rs.\n\
    # Written by FREEZE=write cargo test --test it frozen_scenes. Costs: iterations, products in double and single precision.\n\
    scene,quantity,value,scale\n";

#[test]
fn frozen_scenes_are_unchanged() {
    let (mut text, mut hashes, mut faults) = (HEADING.to_owned(), String::new(), String::new());
    let file = concat!(env!("CARGO_MANIFEST_DIR"), "/../data/frozen_scenes.csv");
    let is_writing = std::env::var("FREEZE").is_ok_and(|word| word == "write");
    let frozen = if is_writing {
        String::new()
    } else {
        std::fs::read_to_string(file).unwrap()
    };
    for &(scene, agreement, run) in SCENES {
        let agreement = match agreement {
            Exact if !has_the_same_transforms() => Rounded,
            other => other,
        };
        let record = Record::of(run);
        writeln!(hashes, "{scene} {:016x}", record.hash).unwrap();
        let prefix = format!("{scene},");
        let mut lines = frozen.lines().filter_map(|line| line.strip_prefix(&prefix));
        for FrozenRow {
            quantity,
            value,
            scale,
        } in &record.rows
        {
            writeln!(text, "{scene},{quantity},{value},{scale}").unwrap();
            let line = lines.next().unwrap_or("nothing");
            if !is_writing && !agrees(line, [quantity, value, scale], agreement) {
                writeln!(faults, "{scene}: {quantity},{value},{scale}; was {line}").unwrap();
            }
        }
        if let Some(line) = lines.next() {
            writeln!(faults, "{scene}: nothing; was {line}").unwrap();
        }
    }
    std::fs::write(concat!(env!("CARGO_TARGET_TMPDIR"), "/frozen_bits"), hashes).unwrap();
    if is_writing && HAS_ALL_SCENES {
        std::fs::write(file, &text).unwrap();
    }
    assert!(
        faults.is_empty(),
        "{} quantities differ:\n{faults}",
        faults.lines().count()
    );
    if !is_writing && HAS_ALL_SCENES {
        let (found, frozen) = (text.lines().count(), frozen.lines().count());
        assert_eq!(
            found, frozen,
            "the file contains scenes that are not computed"
        );
    }
}

/// Returns whether a frozen line contains this quantity with this value.
fn agrees(line: &str, [quantity, value, scale]: [&String; 3], agreement: Agreement) -> bool {
    let words: Vec<&str> = line.split(',').collect();
    let [old_quantity, old_value, old_scale] = words[..] else {
        return false;
    };
    let number = |word: &str| word.parse::<f64>().unwrap();
    old_quantity == quantity
        && match scale.as_str() {
            COSTS if agreement == Solver => true,
            COSTS if agreement == Rounded => {
                let counts = |word: &str| -> Vec<i64> {
                    word.split(' ')
                        .map(|count| count.parse().unwrap())
                        .collect()
                };
                let pairs = counts(value).into_iter().zip(counts(old_value));
                pairs
                    .into_iter()
                    .all(|(new, old)| (new - old).abs() <= ROUNDED_COUNTS)
            }
            CELLS | COSTS | "" => old_value == value,
            _ => {
                (number(value) - number(old_value)).abs()
                    <= agreement.tolerance() * number(old_scale)
            }
        }
}
