//! Saved states that are then modified, with the checksum of the modified bytes.

use std::hash::Hasher;
use std::sync::LazyLock;

use stickslip::{
    Axis, Coupling, ElasticPair, Friction, Grid, HalfSpace, History, LoadStep, Material,
    NormalLoad, Result, TangentialControl, TangentialModel, surface,
};

/// Number of bytes of the checksum at the end.
const SUM: usize = 8;

/// Bodies of all states.
pub static BODIES: LazyLock<HalfSpace> = LazyLock::new(|| bodies().expect("valid bodies"));

static STATES: LazyLock<[Vec<u8>; 3]> = LazyLock::new(|| {
    [
        (TangentialModel::Scalar, Coupling::OneWay),
        (TangentialModel::Vector, Coupling::OneWay),
        (TangentialModel::Vector, Coupling::Full),
    ]
    .map(|(model, coupling)| state(model, coupling).expect("a history of two steps"))
});

fn bodies() -> Result<HalfSpace> {
    let grid = Grid::new(5, 4, 1.0, 1.0)?;
    HalfSpace::new(
        grid,
        ElasticPair::new(Material::new(1.0, 0.3)?, Material::rigid())?,
    )
}

fn state(model: TangentialModel, coupling: Coupling) -> Result<Vec<u8>> {
    let ball = surface::sphere(BODIES.grid(), 10.0)?;
    let mut history = History::builder(&BODIES, &ball, Friction::coulomb(0.3)?)
        .model(model)
        .coupling(coupling)
        .build()?;
    history.step(&LoadStep::hold().normal(NormalLoad::Force(0.5)))?;
    history.step(&LoadStep::hold().tangential(Axis::X, TangentialControl::Force(0.05)))?;
    Ok(history.to_bytes())
}

/// Returns one of the states with bytes replaced. The first byte of the input selects the state. Each further group of
/// three bytes is a position and its new value.
pub fn changed(input: &[u8]) -> Vec<u8> {
    let (&selector, changes) = input.split_first().unwrap_or((&0, &[]));
    let mut bytes = STATES[usize::from(selector) % STATES.len()].clone();
    let contents = bytes.len() - SUM;
    for change in changes.chunks_exact(3) {
        let place = usize::from(u16::from_le_bytes([change[0], change[1]]));
        bytes[place % contents] = change[2];
    }
    let mut sum = fnv::FnvHasher::default();
    sum.write(&bytes[..contents]);
    bytes[contents..].copy_from_slice(&sum.finish().to_le_bytes());
    bytes
}
