//! Difficult scenes with a closed form, compared to the accuracy that cells of this size resolve.

use stickslip::analytical::{FlatPunch, HertzSphere, Westergaard};
use stickslip::{
    Boundary, ElasticPair, Field, Grid, HalfSpace, Material, NormalLoad, NormalProblem,
    NormalSolution, Result, surface,
};

use super::gaps;
use super::row::{Measured, Row};

pub(crate) fn rows() -> Result<Vec<Row>> {
    Ok(vec![flat_punch()?, small_sphere()?, closed_wave()?])
}

fn pair() -> Result<ElasticPair> {
    ElasticPair::new(Material::new(1.0, 0.3)?, Material::rigid())
}

/// Compares the approach of a punch whose edge lies between cells. The error is a fraction of the cell size divided
/// by the radius.
fn flat_punch() -> Result<Row> {
    let grid = Grid::square(128, 2.5)?;
    let bodies = HalfSpace::new(grid, pair()?)?;
    let punch = FlatPunch::new(bodies.pair(), 1.0, 1.0)?;
    let gap = gaps::punch(grid, 1.0, 10.0);
    row(
        "flat punch, 128 x 128 cells",
        &bodies,
        &gap,
        NormalLoad::Force(1.0),
        |solution| (solution.approach() / punch.approach() - 1.0, 0.01),
    )
}

/// Compares with Hertz for a contact five cells wide.
fn small_sphere() -> Result<Row> {
    let grid = Grid::square(33, 33.0)?;
    let bodies = HalfSpace::new(grid, pair()?)?;
    let radius = 100.0;
    // The load has a contact radius of two and a half cells.
    let force = 4.0 / 3.0 * bodies.pair().contact_modulus() * 2.5_f64.powi(3) / radius;
    let hertz = HertzSphere::new(bodies.pair(), radius, force)?;
    let gap = surface::sphere(grid, radius)?;
    row(
        "sphere, five cells across",
        &bodies,
        &gap,
        NormalLoad::Force(force),
        |solution| (solution.approach() / hertz.approach() - 1.0, 0.02),
    )
}

/// Compares a wave that is flattened by exactly the pressure required for full contact.
fn closed_wave() -> Result<Row> {
    let grid = Grid::square(64, 1.0)?;
    let bodies = HalfSpace::with_boundary(grid, pair()?, Boundary::Periodic)?;
    let gap = surface::sinusoidal(grid, 0.01, 1.0)?;
    let amplitude = 0.5 * (gap.max() - gap.min());
    let pressure =
        1.0001 * Westergaard::new(bodies.pair(), amplitude, 1.0, 1e-6)?.full_contact_pressure();
    let load = NormalLoad::Force(pressure * grid.area());
    row("wave just pressed flat", &bodies, &gap, load, |solution| {
        let mean_gap = gap.integral() / grid.area();
        (solution.approach() / mean_gap - 1.0, 1e-9)
    })
}

/// Solves a problem and compares the error of one number with its bound.
fn row(
    name: &str,
    bodies: &HalfSpace,
    gap: &Field,
    load: NormalLoad,
    error: impl Fn(&NormalSolution) -> (f64, f64),
) -> Result<Row> {
    let solution = NormalProblem::builder(bodies, gap, load).build()?.solve()?;
    let mut row = Row::new(name, "pressure");
    row.ending = solution.report().status.to_string();
    row.time = solution.report().time;
    let (error, bound) = error(&solution);
    row.report = Some(solution.report().clone());
    row.error = Some(Measured {
        value: error.abs(),
        slack: bound,
        against: "closed form",
    });
    row.blame(error.is_nan() || error.abs() > bound, || {
        format!("{error:.2e} from the closed form, more than {bound:.0e}")
    });
    Ok(row)
}
