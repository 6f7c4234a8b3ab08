//! A state is stored and restored in existing buffers. If damaged bytes declare many cells, no memory is allocated
//! for these cells.

use kit::unit_bodies;
use stickslip::history::State;
use stickslip::{
    Axis, Friction, Grid, History, LoadStep, NormalLoad, TangentialControl, TangentialModel,
    surface,
};

fn start(model: TangentialModel) -> History {
    let grid = Grid::square(48, 12.0).unwrap();
    let gap = surface::sphere(grid, 20.0).unwrap();
    let friction = Friction::coulomb(0.5).unwrap();
    let bodies = unit_bodies(grid, 0.3);
    let builder = History::builder(&bodies, &gap, friction).model(model);
    let mut history = builder.tolerance(1e-7).build().unwrap();
    for force in [0.0, 0.5, -0.5] {
        history.step(&load(force)).unwrap();
    }
    history
}

fn load(shear: f64) -> LoadStep {
    let step = LoadStep::hold().normal(NormalLoad::Force(4.0));
    step.tangential(Axis::X, TangentialControl::Force(shear))
}

#[test]
fn returning_to_state_allocates_nothing() {
    for model in [TangentialModel::Scalar, TangentialModel::Vector] {
        let mut history = start(model);
        let mut kept = history.state().clone();
        // Later reports may be longer than the first report.
        kept.clone_from(history.state());
        history.step(&load(0.8)).unwrap();
        history.set_state(&kept).unwrap();
        let allocations = allocation_counter::measure(|| {
            kept.clone_from(history.state());
            history.set_state(&kept).unwrap();
        });
        assert_eq!(allocations.count_total, 0);
    }
}

/// The bytes of a state are written into one buffer of their size. The remaining allocations do not depend on the grid.
#[test]
fn saving_allocates_only_the_bytes() {
    for model in [TangentialModel::Scalar, TangentialModel::Vector] {
        let history = start(model);
        let mut bytes = Vec::new();
        let work = || bytes = history.to_bytes();
        let most = allocation_counter::measure(work).bytes_max;
        let beside = most - bytes.len() as u64;
        assert!(beside < 8000, "{model:?}: {most} of {}", bytes.len());
    }
}

/// Appends the 64-bit FNV-1a checksum as the last eight bytes of a saved state.
fn sealed(mut bytes: Vec<u8>) -> Vec<u8> {
    let end = bytes.len() - 8;
    let step = |sum: u64, &byte: &u8| (sum ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3);
    let sum = bytes[..end].iter().fold(0xcbf2_9ce4_8422_2325, step);
    bytes[end..].copy_from_slice(&sum.to_le_bytes());
    bytes
}

#[test]
fn claim_of_many_cells_allocates_no_memory() {
    let mut bytes = start(TangentialModel::Scalar).to_bytes();
    bytes[20..28].copy_from_slice(&(1_u64 << 40).to_le_bytes());
    let bytes = sealed(bytes);
    let mut refused = None;
    let work = || refused = State::from_bytes(&bytes).err();
    let memory = allocation_counter::measure(work).bytes_max;
    let message = refused.unwrap().to_string();
    assert!(
        message.contains("the file ends within the cells"),
        "{message}"
    );
    assert!(memory < 1000, "{memory}");
}
