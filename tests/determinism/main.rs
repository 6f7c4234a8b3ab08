//! Results are bitwise identical with and without threads. For each build configuration of the crate, the program
//! writes the solutions of two rough contacts to a file. `.ci/run` compares the files. The test is a separate program,
//! so that each configuration compiles little code.

#![allow(clippy::unwrap_used, reason = "tests panic on failure")]

use kit::{rough, unit_bodies};
use stickslip::{
    Field, Friction, Grid, NormalLoad, NormalProblem, Result, TangentialLoad, TangentialModel,
    TangentialProblem,
};

/// Returns pressure, gap, tractions, approach and shifts under a force as bytes.
fn bits_of_a_contact(force: f64) -> Result<Vec<u8>> {
    let grid = Grid::new(150, 133, 1.0, 1.1)?;
    let (bodies, gap) = (unit_bodies(grid, 0.3), rough(grid, 21));
    let normal = NormalProblem::builder(&bodies, &gap, NormalLoad::Force(force));
    let normal = normal.build()?.solve()?;
    let mut fields = vec![normal.pressure().clone(), normal.gap().clone()];
    let mut numbers = vec![normal.approach()];
    for model in [TangentialModel::Scalar, TangentialModel::Vector] {
        let load = TangentialLoad::force([0.2 * force, 0.0]);
        let shear = TangentialProblem::builder(&bodies, &normal, Friction::coulomb(0.4)?, load);
        let shear = shear.model(model).build()?.solve()?;
        fields.extend(shear.traction().into_iter().cloned());
        numbers.push(shear.shift()[0]);
    }
    let samples = fields.iter().flat_map(Field::as_slice);
    Ok(samples
        .chain(&numbers)
        .flat_map(|value| value.to_bits().to_le_bytes())
        .collect())
}

/// Solves a large contact, and a contact of scattered spots, which has a different preconditioner.
fn bits_of_contacts() -> Result<Vec<u8>> {
    Ok([bits_of_a_contact(60.0)?, bits_of_a_contact(6.0)?].concat())
}

#[test]
fn contact_is_bitwise_identical_in_every_build() {
    let bits = bits_of_contacts().unwrap();
    let way = if cfg!(feature = "parallel") {
        "bits_with_threads"
    } else {
        "bits_without_threads"
    };
    let folder = std::path::Path::new(env!("CARGO_TARGET_TMPDIR"));
    std::fs::write(folder.join(way), &bits).unwrap();
    // A second solve of this configuration must give the same bits.
    assert!(bits == bits_of_contacts().unwrap());
}
