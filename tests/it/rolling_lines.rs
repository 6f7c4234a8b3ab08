//! Tests of lines and rows of cells that roll under prescribed forces.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use kit::Random;
use rayon::prelude::*;
use stickslip::analytical::HertzLine;
use stickslip::history::EntryRule;
use stickslip::rolling::{LeadingEdge, RollingControl, RollingProblem, RollingSolution};
use stickslip::{
    Axis, Boundary, ElasticPair, Error, Field, Friction, Grid, HalfSpace, Material, NormalLoad,
    NormalProblem, NormalSolution, surface,
};

const RADIUS: f64 = 80.0;

/// Maximum number of products of a solve, in single and double precision together.
const PRODUCTS: usize = 300;

fn pressed(bodies: &HalfSpace, gap: &Field, force: f64) -> NormalSolution {
    let problem = NormalProblem::builder(bodies, gap, NormalLoad::Force(force));
    kit::solve(problem.tolerance(1e-10))
}

/// The datum changes the displacements by a constant, which cancels in the difference over a step.
#[test]
fn cylinder_under_force_has_creepage_of_carter_for_any_datum() {
    let (force, friction, width) = (0.0054, 0.3, 2.2);
    for &cells in kit::thorough(&[64, 128][..], &[64, 128, 256, 512]) {
        let grid = Grid::line(cells, width / cells as f64).unwrap();
        let gap = surface::cylinder(grid, RADIUS).unwrap();
        for datum in [2.2, 5.0, 22.0, 1e4] {
            let boundary = Boundary::PeriodicAlongY { datum };
            let bodies = HalfSpace::with_boundary(grid, kit::alike(1.0, 0.3), boundary).unwrap();
            let normal = pressed(&bodies, &gap, force);
            let hertz = HertzLine::new(bodies.pair(), RADIUS, force).unwrap();
            for part in [0.1, 0.3, 0.5, 0.7, 0.8, 0.95] {
                let rolling = kit::solve(
                    RollingProblem::builder(&bodies, &normal, kit::coulomb(friction))
                        .control(Axis::X, RollingControl::Force(part * friction * force)),
                );
                let products = rolling.report().products();
                assert!(products <= PRODUCTS, "{cells}, {datum}, {part}: {products}");
                let carter = friction * hertz.half_width() / RADIUS * (1.0 - (1.0 - part).sqrt());
                let error = (rolling.creepage()[0] / carter - 1.0).abs();
                assert!(error < 5e-4, "{cells}, {datum}, {part}: {error}");
            }
        }
    }
}

/// If the length of the cells is much larger than the width of the contact, a row on a free grid has the large uniform
/// displacement of a line.
#[test]
fn row_of_long_cells_converges_for_any_force_and_material() {
    let grid = Grid::new(216, 1, 0.001, 1000.0).unwrap();
    let body = |modulus, ratio| Material::from_shear_modulus(modulus, ratio).unwrap();
    let (aluminium, steel) = (body(23_000.0, 0.31), body(82_000.0, 0.28));
    let (gap, load) = (Field::from_fn(grid, |x, _| 0.02 * x * x), 8_000.0);
    for other in [steel, aluminium] {
        let bodies = HalfSpace::new(grid, ElasticPair::new(aluminium, other).unwrap()).unwrap();
        let normal = pressed(&bodies, &gap, load);
        for part in [-0.9, -0.5, 0.3, 0.6, 0.75, 0.9] {
            let rolling = kit::solve(
                RollingProblem::builder(&bodies, &normal, kit::coulomb(0.3))
                    .leading_edge(LeadingEdge::MinusX)
                    .entry_rule(EntryRule::WholeStep)
                    .control(Axis::X, RollingControl::Force(part * 0.3 * load)),
            );
            let products = rolling.report().products();
            assert!(products <= 100, "{part}: {products}");
            if !bodies.pair().is_coupled() {
                let hertz = HertzLine::new(bodies.pair(), 25.0, load / 1000.0).unwrap();
                let slid = 1.0 - f64::sqrt(1.0 - f64::abs(part));
                let carter = (0.3 * hertz.half_width() / 25.0 * slid).copysign(part);
                let error = (rolling.creepage()[0] / carter - 1.0).abs();
                assert!(error < 0.01, "{part}: {error}");
            }
        }
    }
}

/// Rolls a smooth line or wavy rows under a force in a random direction.
fn rolled(index: u64) -> Result<RollingSolution, Error> {
    let mut random = Random(0x524f_4c4c_0000 + index);
    let columns = random.integer(10, 200);
    let rows = if random.chance(0.5) {
        1
    } else {
        random.integer(2, 12)
    };
    let dx = random.uniform(2.4, 3.0) / (columns as f64 - 4.0);
    let grid = if rows == 1 {
        Grid::line(columns, dx)?
    } else {
        Grid::new(columns, rows, dx, dx * random.decade(-0.5, 0.5))?
    };
    let period = rows as f64 * grid.dy();
    let width = columns as f64 * dx;
    let boundary = Boundary::PeriodicAlongY {
        datum: width * random.decade(0.0, 4.0),
    };
    let bodies =
        HalfSpace::with_boundary(grid, kit::alike(1.0, random.uniform(0.0, 0.49)), boundary)?;
    // The half-width of the contact is at most one.
    let per_length = PI * bodies.pair().contact_modulus() / (4.0 * RADIUS);
    let force = per_length * period * random.uniform(0.3, 1.0);
    let depth = if rows == 1 {
        0.0
    } else {
        random.uniform(0.0, 0.002)
    };
    let gap = Field::from_fn(grid, |x, y| {
        let wave = (7.0 * x).cos() * (TAU * y / period).cos();
        0.5 * x * x / RADIUS + depth * (1.0 + wave)
    });
    let normal = pressed(&bodies, &gap, force);
    let friction = random.uniform(0.05, 0.8);
    let angle = random.pick(&[0.0, 0.5, 1.0, 1.3]) * FRAC_PI_2;
    let shear = random.uniform(0.02, 0.98) * friction * force;
    let along = |part: f64| RollingControl::Force(shear * part);
    let builder = RollingProblem::builder(&bodies, &normal, Friction::coulomb(friction)?)
        .control(Axis::X, along(angle.cos()));
    let builder = if random.chance(0.8) {
        builder.control(Axis::Y, along(angle.sin()))
    } else {
        builder
    };
    builder.build()?.solve()
}

#[test]
fn random_lines_and_rows_under_forces_converge() {
    let count = kit::thorough(60, 2000);
    let outcomes: Vec<(u64, Result<RollingSolution, Error>)> = (0..count)
        .into_par_iter()
        .map(|index| (index, rolled(index)))
        .collect();
    let mut long = 0;
    for (index, outcome) in outcomes {
        let rolling = outcome.unwrap_or_else(|error| panic!("{index}: {error}"));
        long += usize::from(rolling.report().products() > PRODUCTS);
    }
    assert!(long as u64 <= count / 500, "{long} of {count}");
}
