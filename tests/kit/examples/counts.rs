//! Work for counting instructions. `counts SCENE TIMES` repeats the work of a scene the given number of times on one
//! thread. The difference of two runs is the work alone, without the start of the program. The script `.ci/counts` runs
//! this example.

use std::error::Error;
use std::hint::black_box;

use kit::benchmark::{BenchmarkCase, FRICTION, LOADING, ball, rough};
use stickslip::cgm::Method;
use stickslip::influence::Component;
use stickslip::{Field, Friction, History, LoadStep, NormalLoad, Operator, TangentialModel};

const TOLERANCE: f64 = 1e-8;

fn main() -> Result<(), Box<dyn Error>> {
    let mut arguments = std::env::args().skip(1);
    let usage = "counts SCENE TIMES, of the scenes product, sphere, rough, step and plane";
    let (scene, times) = arguments.next().zip(arguments.next()).ok_or(usage)?;
    let times = times.parse()?;
    match scene.as_str() {
        "product" => product(times)?,
        "sphere" => press_and_shear(&ball(128)?, times)?,
        "rough" => {
            let [_, at_ten_per_cent, _] = rough(256)?;
            press_and_shear(&at_ten_per_cent, times)?;
        }
        "step" => steps(TangentialModel::Scalar, [1.0, 0.0], times)?,
        "plane" => steps(TangentialModel::Vector, [0.8, 0.6], times)?,
        _ => return Err(usage.into()),
    }
    Ok(())
}

/// Computes products of the normal compliance with pressures on 128 x 128 cells, one in double and one in single
/// precision.
fn product(times: usize) -> stickslip::Result<()> {
    let BenchmarkCase { bodies, .. } = ball(128)?;
    let operator = bodies.operator(Component::ZZ)?;
    let pressure = Field::from_fn(bodies.grid(), |x, y| (1e4 * x).sin() + (2e4 * y).cos());
    let mut out = vec![0.0; operator.cells()];
    let mut workspace = operator.scratch()?;
    for _ in 0..times {
        let pressure = black_box(pressure.as_slice());
        operator.apply([pressure], [&mut out], &mut workspace);
        operator.apply_f32([pressure], [&mut out], &mut workspace);
    }
    Ok(())
}

/// Presses and shears the bodies from the undeformed state.
fn press_and_shear(scene: &BenchmarkCase, times: usize) -> stickslip::Result<()> {
    for _ in 0..times {
        let normal = scene.normal(Method::ActiveSet, TOLERANCE)?.solve()?;
        let shear = scene.tangential(&normal, Method::ActiveSet, TOLERANCE)?;
        black_box(shear.solve()?);
    }
    Ok(())
}

/// Moves back and forth on 64 x 64 cells, in two further steps of a history of two steps.
fn steps(model: TangentialModel, direction: [f64; 2], times: usize) -> stickslip::Result<()> {
    let scene = ball(64)?;
    let friction = Friction::coulomb(FRICTION)?;
    let mut history = History::builder(&scene.bodies, &scene.gap, friction)
        .model(model)
        .tolerance(TOLERANCE)
        .build()?;
    let force = LOADING * FRICTION * scene.force;
    history.step(&LoadStep::hold().normal(NormalLoad::Force(scene.force)))?;
    for _ in 0..=times {
        history.step(&LoadStep::force(direction.map(|n| force * n)))?;
        history.step(&LoadStep::force(direction.map(|n| -force * n)))?;
    }
    Ok(())
}
