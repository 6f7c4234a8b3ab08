//! Scenes with difficult bodies: few cells or all in contact, slender grids, extreme materials, units and surfaces.

use stickslip::{Boundary, ElasticPair, Field, Grid, HalfSpace, Material, Result};

use super::super::{RandomScene, gaps};
use super::{free, pair, periodic, press, suffix};
use crate::Random;

/// Returns contacts from a single cell to all cells.
pub(crate) fn contacts() -> Result<Vec<RandomScene>> {
    let mut scenes = Vec::new();
    let places = [[10, 10], [10, 11], [3, 17], [0, 0], [19, 2]];
    for count in [1, 2, 5] {
        let bodies = free(20, 20)?;
        let gap = gaps::nails(bodies.grid(), 0.5, &places[..count]);
        let name = format!("contact of {count} cells");
        scenes.push(RandomScene::new(name, &bodies, gap, press(&bodies, 1e-5)).sheared(0.5, 0.6)?);
    }
    let corners = [[0, 0], [199, 0], [0, 199], [199, 199], [100, 100]];
    let bodies = free(200, 200)?;
    let gap = gaps::nails(bodies.grid(), 0.5, &corners);
    scenes.push(
        RandomScene::new(
            "isolated cells far apart",
            &bodies,
            gap,
            press(&bodies, 1e-8),
        )
        .sheared(0.5, 0.6)?,
    );
    for (name, bodies) in [
        ("flat on flat", free(20, 20)?),
        ("flat on flat, periodic", periodic(20, 20)?),
    ] {
        let gap = Field::zeros(bodies.grid());
        scenes.push(RandomScene::new(name, &bodies, gap, press(&bodies, 1e-2)).sheared(0.5, 0.6)?);
    }
    for (name, bodies, amplitude, part) in [
        ("full contact", free(20, 20)?, 0.01, 0.1),
        ("full contact, periodic", periodic(20, 20)?, 0.1, 0.1),
        ("nearly full contact", free(20, 20)?, 0.3, 0.1),
        (
            "nearly full contact, periodic",
            periodic(20, 20)?,
            0.1,
            0.0313,
        ),
    ] {
        let gap = gaps::waves(bodies.grid(), [amplitude, amplitude]);
        scenes.push(RandomScene::new(name, &bodies, gap, press(&bodies, part)).sheared(0.5, 0.6)?);
    }
    let bodies = free(20, 20)?;
    let gap = gaps::punch(bodies.grid(), 6.3, 1.0);
    scenes.push(
        RandomScene::new("flat punch, sharp edge", &bodies, gap, press(&bodies, 1e-2))
            .sheared(0.5, 0.6)?,
    );
    let gap = Field::from_fn(bodies.grid(), |x, y| {
        ((x - 8.0).powi(2) + (y + 9.0).powi(2)) / 80.0
    });
    scenes.push(
        RandomScene::new(
            "contact across the edge of the grid",
            &bodies,
            gap,
            press(&bodies, 0.02),
        )
        .sheared(0.5, 0.6)?,
    );
    Ok(scenes)
}

/// Returns slender grids, prime sizes and slender cells.
pub(crate) fn grids() -> Result<Vec<RandomScene>> {
    let mut scenes = Vec::new();
    for (nx, ny) in [
        (1, 1),
        (1, 7),
        (401, 1),
        (1, 2000),
        (4097, 3),
        (19, 23),
        (97, 101),
        (2, 2),
    ] {
        for boundary in [Boundary::NonPeriodic, Boundary::Periodic] {
            let grid = Grid::new(nx, ny, 1.0, 1.0)?;
            let bodies = HalfSpace::with_boundary(grid, pair(0.3)?, boundary)?;
            let gap = gaps::bowl(grid, 2.0 * nx.max(ny) as f64);
            let name = format!("{nx} x {ny} cells{}", suffix(boundary));
            scenes.push(
                RandomScene::new(name, &bodies, gap, press(&bodies, 3e-3)).sheared(0.5, 0.6)?,
            );
        }
    }
    for (dx, dy) in [(1.0, 100.0), (100.0, 1.0)] {
        for boundary in [Boundary::NonPeriodic, Boundary::Periodic] {
            let grid = Grid::new(20, 20, dx, dy)?;
            let bodies = HalfSpace::with_boundary(grid, pair(0.3)?, boundary)?;
            let gap = gaps::bowl(grid, 1e4);
            let name = format!("cells {dx} : {dy}{}", suffix(boundary));
            scenes.push(
                RandomScene::new(name, &bodies, gap, press(&bodies, 0.03)).sheared(0.5, 0.6)?,
            );
        }
    }
    Ok(scenes)
}

pub(crate) fn materials() -> Result<Vec<RandomScene>> {
    let grid = Grid::square(20, 20.0)?;
    let mut scenes = Vec::new();
    for poisson_ratio in [0.0, 0.499999, 0.5, -0.5] {
        let bodies = HalfSpace::new(grid, pair(poisson_ratio)?)?;
        let name = format!("Poisson's ratio {poisson_ratio}");
        let scene = RandomScene::new(name, &bodies, gaps::bowl(grid, 40.0), press(&bodies, 0.01));
        scenes.push(scene.sheared(0.5, 0.6)?);
    }
    let body = Material::new(1.0, 0.3)?;
    let rigid = Material::rigid();
    let stiff = Material::new(1e12, 0.2)?;
    for (name, pair) in [
        ("body 2 rigid", ElasticPair::new(body, rigid)?),
        ("body 1 rigid", ElasticPair::new(rigid, body)?),
        ("moduli 1 : 1e12", ElasticPair::new(body, stiff)?),
    ] {
        let bodies = HalfSpace::new(grid, pair)?;
        let scene = RandomScene::new(name, &bodies, gaps::bowl(grid, 40.0), press(&bodies, 0.01));
        scenes.push(scene.sheared(0.5, 0.6)?);
    }
    Ok(scenes)
}

/// Returns scenes in extreme units.
pub(crate) fn scales() -> Result<Vec<RandomScene>> {
    let mut scenes = Vec::new();
    for modulus in [1e-3, 1e15] {
        for length in [1e-12, 1e6] {
            let body = Material::new(modulus, 0.3)?;
            let grid = Grid::square(20, 20.0 * length)?;
            let bodies = HalfSpace::new(grid, ElasticPair::new(body, body)?)?;
            let gap = gaps::bowl(grid, 40.0 * length);
            let name = format!("modulus {modulus:e}, length {length:e}");
            scenes.push(
                RandomScene::new(name, &bodies, gap, press(&bodies, 0.01)).sheared(0.5, 0.6)?,
            );
        }
    }
    Ok(scenes)
}

pub(crate) fn surfaces() -> Result<Vec<RandomScene>> {
    let mut scenes = Vec::new();
    for bodies in [free(20, 20)?, periodic(20, 20)?, free(64, 60)?] {
        for (height, name) in [
            (0.01, "white noise"),
            (5.0, "white noise, rms slope above 1"),
        ] {
            let gap = gaps::white_noise(bodies.grid(), height, &mut Random(5));
            let cells = bodies.grid().cells();
            let name = format!("{name}, {cells} cells{}", suffix(bodies.boundary()));
            scenes.push(
                RandomScene::new(name, &bodies, gap, press(&bodies, 0.02)).sheared(0.5, 0.6)?,
            );
        }
    }
    let bodies = free(64, 64)?;
    let gap = gaps::two_bowls(bodies.grid(), [3e3, 3.0], 30.0);
    scenes.push(
        RandomScene::new(
            "two contacts of very different size",
            &bodies,
            gap,
            press(&bodies, 1e-3),
        )
        .sheared(0.5, 0.6)?,
    );
    Ok(scenes)
}
