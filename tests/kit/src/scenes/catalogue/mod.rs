//! Catalogue of named difficult scenes.

mod bodies;
mod engine;
mod loads;

use stickslip::cgm::Method;
use stickslip::{Boundary, ElasticPair, Grid, HalfSpace, Material, NormalLoad, Result};

use super::judge::Verifier;
use super::row::Row;
use super::{closed_forms, steps};

const JUDGE: Verifier = Verifier { dense_limit: 450 };

/// Solves every `stride`-th scene, and all rows that are not scenes.
pub fn rows(stride: usize) -> Result<Vec<Row>> {
    let groups = [
        bodies::contacts()?,
        bodies::grids()?,
        bodies::materials()?,
        bodies::scales()?,
        bodies::surfaces()?,
        loads::loads()?,
        loads::frictions()?,
        loads::tolerances()?,
        loads::warm_starts()?,
    ];
    let mut rows: Vec<Row> = groups
        .iter()
        .flatten()
        .step_by(stride)
        .flat_map(|scene| JUDGE.rows(scene, Method::ActiveSet))
        .collect();
    rows.extend(engine::starts()?);
    rows.extend(engine::broken_operators());
    rows.extend(closed_forms::rows()?);
    rows.extend(steps::rows()?);
    Ok(rows)
}

/// Returns two equal bodies with a contact modulus near one.
pub(crate) fn pair(poisson_ratio: f64) -> Result<ElasticPair> {
    let body = Material::new(2.0, poisson_ratio)?;
    ElasticPair::new(body, body)
}

pub(crate) fn free(nx: usize, ny: usize) -> Result<HalfSpace> {
    HalfSpace::new(Grid::new(nx, ny, 1.0, 1.0)?, pair(0.3)?)
}

pub(crate) fn periodic(nx: usize, ny: usize) -> Result<HalfSpace> {
    HalfSpace::with_boundary(Grid::new(nx, ny, 1.0, 1.0)?, pair(0.3)?, Boundary::Periodic)
}

/// Returns a force with this mean pressure over the whole grid, as a fraction of the contact modulus.
pub(crate) fn press(bodies: &HalfSpace, part: f64) -> NormalLoad {
    NormalLoad::Force(part * bodies.pair().contact_modulus() * bodies.grid().area())
}

/// Returns the part of a name that describes the boundary.
pub(crate) fn suffix(boundary: Boundary) -> &'static str {
    match boundary {
        Boundary::Periodic => ", periodic",
        Boundary::PeriodicAlongY { .. } => ", periodic along y",
        _ => "",
    }
}
