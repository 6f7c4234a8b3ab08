//! Random scenes over the whole range of the catalogue, each determined by its index.

use std::time::Duration;

use stickslip::cgm::Settings;
use stickslip::layers::Layer;
use stickslip::{
    Boundary, ElasticPair, Field, Friction, Grid, HalfSpace, Material, NormalLoad, Result,
};

use super::{Demand, Expected, RandomScene, Shear, gaps};
use crate::Random;

/// Time limit after which a solve counts as hanging.
pub(crate) const PATIENCE: Duration = Duration::from_secs(60);

/// Returns the generator of a scene. The scenes of adjacent indices are unrelated.
pub(crate) fn random_of(index: u64) -> Random {
    let mut seed = Random(index);
    Random(seed.bits())
}

/// Returns the scene of an index.
pub(crate) fn scene(index: u64) -> Result<RandomScene> {
    scene_of(index, |pair, _| Ok(pair))
}

/// Returns the scene of an index with a layer on body 1, in three of ten cases also on body 2. The thickness of the
/// layer is between a hundredth of a cell and the size of the grid. The modulus of the layer differs from the modulus
/// of the body by a factor of up to a thousand.
pub(crate) fn coated_scene(index: u64) -> Result<RandomScene> {
    let mut random = random_of(index ^ 0x0063_6f61_7465_6400);
    scene_of(index, |pair, grid| {
        let [body, other] = pair.bodies();
        let body = if body.is_rigid() { other } else { body };
        let most = grid.nx().max(grid.ny()) as f64;
        let thickness = grid.dx().min(grid.dy()) * random.decade(-2.0, most.log10().max(0.1));
        let modulus = body.shear_modulus() * random.decade(-3.0, 3.0);
        let ratio = random.uniform(0.0, 0.5);
        let coated = body.coated(&[Layer::new(modulus, ratio, thickness)?])?;
        if random.chance(0.3) {
            ElasticPair::new(coated, coated)
        } else {
            ElasticPair::new(coated, Material::rigid())
        }
    })
}

fn scene_of(
    index: u64,
    bodies: impl FnOnce(ElasticPair, Grid) -> Result<ElasticPair>,
) -> Result<RandomScene> {
    let mut random = random_of(index);
    let pair = pair(&mut random)?;
    let grid = grid(&mut random)?;
    let pair = bodies(pair, grid)?;
    let boundary = random.pick(&[
        Boundary::NonPeriodic,
        along_y(grid, index),
        Boundary::Periodic,
    ]);
    let bodies = HalfSpace::with_boundary(grid, pair, boundary)?;
    let gap = gap(grid, &mut random);
    let (load, expected) = load(&bodies, &gap, &mut random);

    let tolerance = random.decade(-10.0, -2.0);
    let (tolerance, expected) = match random.integer(0, 19) {
        0 => (0.9, expected),
        1 if expected == Expected::Answer => (1e-14, Expected::AnswerOrRoundOff),
        _ => (tolerance, expected),
    };
    let settings = Settings::default()
        .tolerance(tolerance)
        .time_limit(PATIENCE);
    let mut scene = RandomScene {
        settings,
        ..RandomScene::new(format!("scene {index}"), &bodies, gap, load).expect(expected)
    };
    if random.chance(0.2) {
        let before = self::gap(grid, &mut random);
        let pressure = pair.contact_modulus() * random.decade(-6.0, 0.0);
        scene = scene.after(before, NormalLoad::Force(pressure * grid.area()));
    }
    for _ in 0..random.integer(1, 2) {
        let mut shear = shear(grid, &mut random)?;
        if shear.expected == Expected::Answer {
            shear.expected = expected;
        }
        scene = scene.shear(shear);
    }
    Ok(scene)
}

/// Returns a boundary that is periodic along y with a random datum, or the boundary of a free grid.
fn along_y(grid: Grid, index: u64) -> Boundary {
    let length = grid.dx() * grid.nx() as f64;
    let far = [1.0, 10.0, 1e6].get((index % 4) as usize);
    far.map_or(Boundary::NonPeriodic, |far| Boundary::PeriodicAlongY {
        datum: far * length,
    })
}

pub(crate) fn pair(random: &mut Random) -> Result<ElasticPair> {
    let modulus = if random.chance(0.5) {
        1.0
    } else {
        random.decade(-3.0, 15.0)
    };
    let poisson_ratio = match random.integer(0, 7) {
        0 => 0.0,
        1 => 0.499999,
        2 => 0.5,
        3 => -0.5,
        4 => random.uniform(-0.99, 0.0),
        _ => random.uniform(0.0, 0.5),
    };
    let body = Material::new(modulus, poisson_ratio)?;
    if random.chance(0.3) {
        ElasticPair::new(body, Material::rigid())
    } else if random.chance(0.2) {
        ElasticPair::new(
            Material::new(random.decade(-2.0, 2.0) * modulus, 0.2)?,
            body,
        )
    } else {
        ElasticPair::new(body, body)
    }
}

pub(crate) fn grid(random: &mut Random) -> Result<Grid> {
    const PRIMES: [usize; 8] = [1, 2, 3, 5, 7, 11, 13, 31];
    let [nx, ny] = match random.integer(0, 19) {
        0..=8 => [random.integer(1, 12), random.integer(1, 12)],
        9..=11 => [random.integer(1, 140), 1],
        12 => [1, random.integer(1, 140)],
        13..=15 => [random.pick(&PRIMES), random.pick(&PRIMES)],
        16..=17 => [random.integer(12, 48), random.integer(12, 48)],
        18 => [random.integer(48, 96), random.integer(40, 80)],
        _ => [random.integer(100, 700), random.integer(1, 5)],
    };
    let dx = if random.chance(0.5) {
        1.0
    } else {
        random.decade(-12.0, 6.0)
    };
    let aspect = match random.integer(0, 9) {
        0 => random.decade(-2.0, 2.0),
        1..=3 => random.uniform(0.5, 2.0),
        _ => 1.0,
    };
    Grid::new(nx, ny, dx, dx * aspect)
}

fn gap(grid: Grid, random: &mut Random) -> Field {
    let sides = [grid.dx() * grid.nx() as f64, grid.dy() * grid.ny() as f64];
    let size = sides[0].max(sides[1]);
    let mut gap = match random.integer(0, 9) {
        0 => Field::zeros(grid),
        1 => gaps::white_noise(grid, size * random.decade(-6.0, 0.5), random),
        2 => {
            let cells: Vec<[usize; 2]> = (0..random.integer(1, 5))
                .map(|_| [grid.nx(), grid.ny()].map(|n| random.integer(0, n - 1)))
                .collect();
            gaps::nails(grid, size * random.decade(-6.0, 1.0), &cells)
        }
        3 => gaps::punch(
            grid,
            size * random.uniform(0.1, 0.6),
            size * random.decade(-4.0, 1.0),
        ),
        4 => {
            let large = size * random.decade(-0.5, 2.0);
            let small = large * random.decade(-3.0, 0.0);
            gaps::two_bowls(grid, [large, small], 0.4 * size)
        }
        5 => gaps::waves(
            grid,
            [
                size * random.decade(-5.0, -1.0),
                size * random.decade(-5.0, -1.0),
            ],
        ),
        _ => gaps::bowl(grid, size * random.decade(-0.5, 2.0)),
    };
    if random.chance(0.3) {
        let tilt = random.uniform(-0.05, 0.05);
        let noise = size * random.decade(-6.0, -2.0);
        let tilted = Field::from_fn(grid, |x, _| tilt * x + noise * random.uniform(0.0, 1.0));
        for (gap, tilted) in gap.as_mut_slice().iter_mut().zip(tilted.as_slice()) {
            *gap += tilted;
        }
    }
    if random.chance(0.1) {
        let datum = size * random.uniform(-1.0, 1.0);
        for gap in gap.as_mut_slice() {
            *gap += datum;
        }
    }
    gap
}

fn load(bodies: &HalfSpace, gap: &Field, random: &mut Random) -> (NormalLoad, Expected) {
    let grid = bodies.grid();
    let span = gap.max() - gap.min();
    let mean = gap.integral() / grid.area();
    if random.chance(0.25) {
        let side = (grid.dx() * grid.nx() as f64).max(grid.dy() * grid.ny() as f64);
        let approach = if bodies.boundary() == Boundary::Periodic {
            gap.min() + random.uniform(-0.1, 0.95) * (mean - gap.min())
        } else if span > 0.0 {
            gap.min() + span * random.pick(&[1e-6, 1e-2, 0.3, 1.0, 3.0]) * random.uniform(-0.1, 1.0)
        } else {
            gap.min() + side * random.decade(-6.0, -1.0)
        };
        let is_open = bodies.boundary() != Boundary::Periodic || approach < mean;
        let expected = if is_open {
            Expected::Answer
        } else {
            Expected::Refused("ApproachBeyondMeanGap")
        };
        return (NormalLoad::Approach(approach), expected);
    }
    let pressure = match random.integer(0, 3) {
        0 => random.decade(-14.0, 3.0),
        _ => random.decade(-6.0, 0.0),
    };
    let force = pressure * bodies.pair().contact_modulus() * grid.area();
    (NormalLoad::Force(force), Expected::Answer)
}

pub(crate) fn friction(grid: Grid, random: &mut Random) -> Result<Friction> {
    let coefficient = random.pick(&[1e-9, 0.1, 0.5, 1.0, 1e3]);
    match random.integer(0, 9) {
        0 => Friction::coulomb(0.0),
        1 => {
            let edge = random.uniform(-0.3, 0.3) * grid.dx() * grid.nx() as f64;
            let rough = |x: f64, _| if x < edge { 0.0 } else { coefficient };
            Friction::per_cell(Field::from_fn(grid, rough))
        }
        2 => {
            let jump = random.decade(-6.0, 6.0);
            let edge = grid.dy() * random.uniform(-3.0, 3.0);
            let rough = |_, y: f64| {
                if y < edge {
                    coefficient
                } else {
                    coefficient * jump
                }
            };
            Friction::per_cell(Field::from_fn(grid, rough))
        }
        3 => {
            let rough = |_, _| coefficient * random.uniform(-0.2, 1.0).max(0.0);
            Friction::per_cell(Field::from_fn(grid, rough))
        }
        _ => Friction::coulomb(coefficient),
    }
}

fn shear(grid: Grid, random: &mut Random) -> Result<Shear> {
    let friction = friction(grid, random)?;
    let angle = random.uniform(0.0, std::f64::consts::TAU);
    let is_in_plane = random.chance(0.4);
    let direction = match random.integer(0, 3) {
        0 => [1.0, 0.0],
        1 => [0.0, -1.0],
        _ if is_in_plane => [angle.cos(), angle.sin()],
        _ => [-1.0, 0.0],
    };
    let part = match random.integer(0, 11) {
        0 => 0.0,
        1 => 1e-12,
        2 => 0.99,
        3 => 0.999999,
        4 => 1.0 - 1e-12,
        5 => 1.0,
        6 => 1.0 + 1e-9,
        _ => random.uniform(0.0, 1.0),
    };
    let (demand, expected) = if random.chance(0.3) {
        let shift = part * random.decade(-3.0, 1.0);
        (
            Demand::Shift(direction.map(|n| n * shift)),
            Expected::Answer,
        )
    } else if part > 1.0 {
        let demand = Demand::Force(direction.map(|n| n * part));
        (demand, Expected::Refused("BeyondFrictionCapacity"))
    } else {
        (Demand::Force(direction.map(|n| n * part)), Expected::Answer)
    };
    // In the vector model the last digits before the limit are lost to round-off.
    let expected =
        if is_in_plane && (0.9999999..1.0).contains(&part) && expected == Expected::Answer {
            Expected::AnswerOrRoundOff
        } else {
            expected
        };
    let shear = Shear::new(format!("{demand:?}"), friction, demand).expect(expected);
    Ok(if is_in_plane { shear.in_plane() } else { shear })
}
