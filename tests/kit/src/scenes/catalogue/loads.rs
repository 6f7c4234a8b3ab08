//! Scenes with difficult requests: loads, friction, tolerances and previous solves.

use std::f64::consts::FRAC_PI_4;

use stickslip::{Field, Friction, NormalLoad, Result};

use super::super::{Demand, Expected, RandomScene, Shear, gaps};
use super::{free, periodic, press, suffix};
use crate::Random;

/// Returns loads from zero to far beyond the range of elastic bodies, and tangential forces from zero to sliding.
pub(crate) fn loads() -> Result<Vec<RandomScene>> {
    let mut scenes = Vec::new();
    for part in [1e-14, 1e-9, 1.0, 1e3] {
        for bodies in [free(20, 20)?, periodic(20, 20)?] {
            let mut random = Random(3);
            let gap = gaps::white_noise(bodies.grid(), 1.0, &mut random);
            let name = format!("load {part:e} of E*{}", suffix(bodies.boundary()));
            scenes.push(
                RandomScene::new(name, &bodies, gap, press(&bodies, part)).sheared(0.5, 0.6)?,
            );
        }
    }
    for (parts, bodies) in [(0.6, free(20, 20)?), (0.03, periodic(20, 20)?)] {
        let gap = gaps::waves(bodies.grid(), [0.3, 0.3]);
        let load = NormalLoad::Approach(parts);
        let name = format!("prescribed approach{}", suffix(bodies.boundary()));
        scenes.push(RandomScene::new(name, &bodies, gap, load).sheared(0.5, 0.6)?);
    }
    for bodies in [free(16, 16)?, periodic(16, 16)?] {
        let gap = gaps::bowl(bodies.grid(), 40.0);
        let name = format!("bowl{}", suffix(bodies.boundary()));
        let mut scene = RandomScene::new(name, &bodies, gap, press(&bodies, 0.01));
        for (part, name) in [
            (0.0, "F = 0"),
            (1e-12, "F = 1e-12 of sliding"),
            (0.99, "F = 0.99 of sliding"),
            (0.999999, "F = 0.999999 of sliding"),
            (1.0 - 1e-12, "F = 1 - 1e-12 of sliding"),
            (1.0, "F = sliding"),
            // Half of the tolerance within which a force counts as the limit.
            (1.0 + 5e-13, "F = 1 + 5e-13 of sliding"),
            (1.0 + 2e-12, "F = 1 + 2e-12 of sliding"),
        ] {
            for is_in_plane in [false, true] {
                let friction = Friction::coulomb(0.5)?;
                let mut shear = Shear::new(name, friction, Demand::Force([0.0, part]));
                if is_in_plane {
                    shear = shear.in_plane();
                }
                if part > 1.0 + 1e-12 {
                    shear = shear.expect(Expected::Refused("BeyondFrictionCapacity"));
                } else if is_in_plane && part > 0.9999999 {
                    shear = shear.expect(Expected::AnswerOrRoundOff);
                }
                scene = scene.shear(shear);
            }
        }
        for part in [1e-6, 0.5, 3.0] {
            for angle in [0.0, FRAC_PI_4] {
                let shift = [part * angle.cos(), part * angle.sin()];
                let name = format!("shift {part} of the largest displacement");
                let mut shear = Shear::new(name, Friction::coulomb(0.5)?, Demand::Shift(shift));
                if angle > 0.0 {
                    shear = shear.in_plane();
                }
                scene = scene.shear(shear);
            }
        }
        scenes.push(scene);
    }
    Ok(scenes)
}

pub(crate) fn frictions() -> Result<Vec<RandomScene>> {
    let bodies = free(20, 20)?;
    let grid = bodies.grid();
    let gap = gaps::bowl(grid, 40.0);
    let mut scene = RandomScene::new("friction", &bodies, gap, press(&bodies, 0.01));
    let nowhere = Shear::new("0", Friction::coulomb(0.0)?, Demand::Shift([1e-3, 0.0]));
    let halved = Field::from_fn(grid, |x, _| if x < 0.0 { 0.0 } else { 0.5 });
    let jumping = Field::from_indices(grid, |ix, iy| if (ix + iy) % 2 == 0 { 1e-3 } else { 1e3 });
    for (name, friction) in [
        ("1e-9", Friction::coulomb(1e-9)?),
        ("1e3", Friction::coulomb(1e3)?),
        ("zero on half the contact", Friction::per_cell(halved)?),
        (
            "a jump of 1e6 between neighbours",
            Friction::per_cell(jumping)?,
        ),
        ("capped", Friction::coulomb(0.5)?.max_shear_stress(1e-2)?),
    ] {
        for part in [0.5, 0.97] {
            let demand = Demand::Force([part, 0.0]);
            let oblique = Demand::Force([-0.6 * part, 0.8 * part]);
            scene = scene
                .shear(Shear::new(name, friction.clone(), demand))
                .shear(Shear::new(name, friction.clone(), oblique).in_plane());
        }
    }
    // Without friction no force can be prescribed, and any shift slides.
    Ok(vec![scene.shear(nowhere)])
}

pub(crate) fn tolerances() -> Result<Vec<RandomScene>> {
    let bodies = free(20, 20)?;
    let scene = || {
        RandomScene::new(
            "tolerance",
            &bodies,
            gaps::bowl(bodies.grid(), 40.0),
            press(&bodies, 0.01),
        )
    };
    let mut scenes = Vec::new();
    for (tolerance, expected) in [
        (1e-14, Expected::AnswerOrRoundOff),
        (1e-17, Expected::AnswerOrRoundOff),
        (0.999, Expected::Answer),
        (1.0, Expected::Refused("Tolerance")),
        (0.0, Expected::Refused("Tolerance")),
        (-1e-8, Expected::Refused("Tolerance")),
        (f64::NAN, Expected::Refused("Tolerance")),
    ] {
        let mut scene = scene()
            .tolerance(tolerance)
            .expect(expected)
            .sheared(0.5, 0.6)?;
        scene.name = format!("tolerance {tolerance:e}");
        for shear in &mut scene.shears {
            shear.expected = expected;
        }
        scenes.push(scene);
    }
    Ok(scenes)
}

/// Returns scenes whose solver has solved a different scene before, which must not affect the solution.
pub(crate) fn warm_starts() -> Result<Vec<RandomScene>> {
    let mut scenes = Vec::new();
    for bodies in [free(20, 20)?, periodic(20, 20)?, free(60, 60)?] {
        let grid = bodies.grid();
        let noise = gaps::white_noise(grid, 5.0, &mut Random(6));
        let name = format!("after another scene, {} cells", grid.cells());
        let name = name + suffix(bodies.boundary());
        let scene = RandomScene::new(name, &bodies, gaps::bowl(grid, 40.0), press(&bodies, 0.01));
        scenes.push(scene.after(noise, press(&bodies, 1.0)));
    }
    Ok(scenes)
}
