//! A saved history is restored completely, and bytes that do not contain a history are rejected.

use kit::unit_bodies;
use stickslip::history::State;
use stickslip::io::Place;
use stickslip::layers::Layer;
use stickslip::{
    Boundary, ElasticPair, Error, Field, Friction, Grid, HalfSpace, History, LoadStep, Material,
    NormalLoad, TangentialControl, TangentialModel, Warning,
};

fn take_steps(history: &mut History, forces: &[[f64; 2]]) {
    let axis = history.axis().unwrap();
    for &[normal, tangential] in forces {
        let step = LoadStep::hold()
            .normal(NormalLoad::Force(normal))
            .tangential(axis, TangentialControl::Force(tangential));
        history.step(&step).unwrap();
    }
}

const FIRST: [[f64; 2]; 3] = [[4.0, 0.0], [6.0, 2.0], [6.0, -2.0]];
const THEN: [[f64; 2]; 4] = [[6.0, 0.0], [9.0, 3.0], [2.0, 0.5], [40.0, -3.0]];

fn new_problem() -> (HalfSpace, Field, Friction) {
    let grid = Grid::new(60, 49, 0.5, 0.7).unwrap();
    let friction = kit::coulomb(0.45);
    let friction = friction.max_shear_stress(0.3).unwrap();
    (unit_bodies(grid, 0.3), kit::sphere(grid, 40.0), friction)
}

fn saved_history() -> (HalfSpace, Vec<u8>) {
    let (bodies, gap, friction) = new_problem();
    let mut history = History::builder(&bodies, &gap, friction).build().unwrap();
    take_steps(&mut history, &FIRST);
    let bytes = history.to_bytes();
    (bodies, bytes)
}

#[test]
fn damaged_bytes_are_rejected() {
    let (bodies, bytes) = saved_history();
    let problem = |bytes: &[u8]| match History::from_bytes(&bodies, bytes) {
        Err(Error::Format { problem, .. }) => problem,
        Err(other) => panic!("{other}"),
        Ok(_) => panic!("damaged bytes were accepted"),
    };
    assert!(problem(b"").contains("magic"));
    assert!(problem(b"nothing of the kind").contains("do not start"));
    let mut newer = bytes.clone();
    for version in [0, 2] {
        newer[8] = version;
        assert!(
            problem(&newer).contains(&format!("version {version} of the format is not supported"))
        );
    }
    for length in [9, 15, 20, 27, 100, bytes.len() / 2, bytes.len() - 1] {
        problem(&bytes[..length]);
    }
    problem(&[&bytes[..], &[0]].concat());
    for place in (12..bytes.len()).step_by(bytes.len() / 97) {
        let mut damaged = bytes.clone();
        damaged[place] ^= 0x10;
        problem(&damaged);
    }
}

/// Replaces the FNV-1a checksum by the checksum of the damaged bytes, so that the damaged bytes pass the test of the
/// checksum.
fn with_checksum(mut bytes: Vec<u8>) -> Vec<u8> {
    let end = bytes.len() - 8;
    let sum = bytes[..end]
        .iter()
        .fold(0xcbf2_9ce4_8422_2325_u64, |sum, &byte| {
            (sum ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3)
        });
    bytes[end..].copy_from_slice(&sum.to_le_bytes());
    bytes
}

#[test]
fn contents_with_valid_checksum_are_checked() {
    let (bodies, bytes) = saved_history();
    assert!(History::from_bytes(&bodies, &with_checksum(bytes.clone())).is_ok());
    // NaN is detected at any position in scalars, windows and fields.
    let mut accepted = 0;
    // The fields take up nearly all bytes.
    let places = (20..600).step_by(61);
    for place in places.chain((600..bytes.len() - 24).step_by(kit::thorough(607, 61))) {
        let mut damaged = bytes.clone();
        damaged[place..place + 16].copy_from_slice(&[0xff; 16]);
        match State::from_bytes(&with_checksum(damaged)) {
            Ok(_) => accepted += 1,
            Err(Error::Format {
                place: Place::Byte(byte),
                ..
            }) => assert!((20..place as u64 + 16).contains(&byte), "{byte}, {place}"),
            Err(error) => panic!("{error}"),
        }
    }
    // Only the iteration limit has no invalid values.
    assert!(accepted <= 1, "{accepted}");
    let mut longer = bytes.clone();
    longer.splice(bytes.len() - 8..bytes.len() - 8, [0; 8]);
    let length = (longer.len() as u64).to_le_bytes();
    longer[12..20].copy_from_slice(&length);
    kit::assert_refused! { History::from_bytes(&bodies, &with_checksum(longer)) => Error::Format { .. } }
}

/// Position of the number of steps, after the bodies, the kernel flag, the options and a uniform friction with a cap.
const STEPS: usize = 20 + (48 + 1 + 1 + 48 + 16 + 1) + (1 + 1 + 8 + 8 + 1) + (1 + 8 + 1 + 8);

#[test]
fn number_of_steps_cannot_overflow() {
    let (bodies, bytes) = saved_history();
    let with_steps = |steps: u64| {
        let mut bytes = bytes.clone();
        assert_eq!(bytes[STEPS..][..8], 3_u64.to_le_bytes());
        bytes[STEPS..][..8].copy_from_slice(&steps.to_le_bytes());
        History::from_bytes(&bodies, &with_checksum(bytes))
    };
    for steps in [u64::MAX, (1 << 53) + 1] {
        let Err(Error::Format { place, problem, .. }) = with_steps(steps) else {
            panic!("{steps} steps are accepted")
        };
        assert_eq!(place, Place::Byte(STEPS as u64));
        assert!(problem.contains(&steps.to_string()), "{problem}");
    }
    let mut history = with_steps(1 << 53).unwrap();
    take_steps(&mut history, &THEN[..1]);
    assert_eq!(history.steps(), (1 << 53) + 1);
}

#[test]
fn stale_pressure_is_reported_after_restart() {
    let (bodies, gap, friction) = new_problem();
    let mut history = History::builder(&bodies, &gap, friction).build().unwrap();
    take_steps(&mut history, &FIRST);
    let mut worn = gap;
    worn.as_mut_slice()[0] += 1.0;
    history.set_gap(&worn).unwrap();
    let mut restored = History::from_bytes(&bodies, &history.to_bytes()).unwrap();
    for history in [&mut history, &mut restored] {
        assert!(history.state().is_pressure_stale());
        let step = history.step(&LoadStep::hold()).unwrap();
        assert_eq!(step.warnings(), [Warning::StalePressure]);
    }
}

#[test]
fn restart_on_different_bodies_is_rejected() {
    let (bodies, bytes) = saved_history();
    let grid = bodies.grid();
    for other in [
        Grid::new(49, 60, 0.5, 0.7).unwrap(),
        Grid::new(60, 49, 0.7, 0.5).unwrap(),
    ] {
        kit::assert_refused! { History::from_bytes(&unit_bodies(other, 0.3), &bytes) => Error::GridMismatch { .. } }
    }
    kit::assert_refused! { History::from_bytes(&unit_bodies(grid, 0.31), &bytes) => Error::MaterialMismatch { .. } }
    let layer = Layer::new(2.0, 0.3, 0.5).unwrap();
    let coated = Material::new(1.82, 0.3).unwrap().coated(&[layer]).unwrap();
    let coated = HalfSpace::new(grid, ElasticPair::new(coated, coated).unwrap()).unwrap();
    kit::assert_refused! { History::from_bytes(&coated, &bytes) => Error::MaterialMismatch { .. } }
    let periodic = HalfSpace::with_boundary(grid, *bodies.pair(), Boundary::Periodic).unwrap();
    kit::assert_refused! { History::from_bytes(&periodic, &bytes) => Error::BoundaryMismatch { .. } }
}

/// Checks the sizes stated in the docs of `State::to_bytes`, with less than a kilobyte in addition to the cells.
#[test]
fn saved_state_has_the_documented_size() {
    let grid = kit::square(48, 8.0);
    let friction = Friction::per_cell(Field::from_fn(grid, |_, _| 0.5)).unwrap();
    let uniform = kit::coulomb(0.5);
    let ball = kit::sphere(grid, 20.0);
    let flat = Field::zeros(grid);
    let joint = kit::on_rigid(1.0, 0.2);
    let joint = HalfSpace::new(grid, joint).unwrap();
    let bodies = unit_bodies(grid, 0.3);
    // The sizes are bytes per cell of the grid, after pressing twice and after a change of the gap. The flat contact
    // fills its window.
    for (bodies, gap, friction, model, sizes) in [
        (&bodies, &flat, &uniform, TangentialModel::Scalar, [89, 97]),
        (
            &bodies,
            &flat,
            &friction,
            TangentialModel::Scalar,
            [97, 105],
        ),
        (
            &bodies,
            &flat,
            &uniform,
            TangentialModel::Vector,
            [145, 153],
        ),
        (
            &bodies,
            &flat,
            &friction,
            TangentialModel::Vector,
            [153, 161],
        ),
        (&joint, &ball, &uniform, TangentialModel::Vector, [129, 137]),
    ] {
        let builder = History::builder(bodies, gap, friction.clone()).model(model);
        let mut history = builder.build().unwrap();
        for force in [1.0, 1.1, 1.2] {
            let press = LoadStep::hold().normal(NormalLoad::Force(force));
            history.step(&press).unwrap();
        }
        let mut changed = gap.clone();
        for gap in changed.as_mut_slice() {
            *gap += 1.0;
        }
        let before = history.to_bytes().len();
        history.set_gap(&changed).unwrap();
        let found = [before, history.to_bytes().len()];
        for (found, expected) in found.into_iter().zip(sizes) {
            let beside = found.checked_sub(expected * grid.cells());
            assert!(
                beside.is_some_and(|beside| beside < 1000),
                "{model:?}: {found}"
            );
        }
    }
}
