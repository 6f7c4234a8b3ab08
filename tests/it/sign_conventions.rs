//! Tests of the sign conventions, with the displacement of each body computed from the coefficients of a single body.

use stickslip::influence::Rectangle;
use stickslip::{
    ElasticPair, Field, Grid, HalfSpace, Material, NormalLoad, NormalProblem, TangentialLoad,
    TangentialProblem, Zone,
};

/// Returns the displacement along x or z of the surface of one body under a traction along x or z on this body.
fn displacement(body: &Material, traction: &Field, along_z: bool) -> Vec<f64> {
    let grid = traction.grid();
    let cell = Rectangle::new(0.5 * grid.dx(), 0.5 * grid.dy()).unwrap();
    let centres: Vec<[f64; 2]> = (0..grid.cells())
        .map(|i| grid.position(i % grid.nx(), i / grid.nx()))
        .collect();
    let at = |field: &[f64; 2]| {
        let sources = centres
            .iter()
            .zip(traction.as_slice())
            .filter(|(_, t)| **t != 0.0);
        sources
            .map(|(source, t)| {
                let tensor = cell.tensor(body, field[0] - source[0], field[1] - source[1]);
                t * if along_z { tensor.zz } else { tensor.xx }
            })
            .sum()
    };
    centres.iter().map(at).collect()
}

#[test]
fn signs_are_consistent_for_two_different_bodies() {
    // The moduli differ, but the bodies are uncoupled, because (1 - 2 nu)/G is the same for both.
    let soft = Material::from_shear_modulus(1.0, 0.4).unwrap();
    let stiff = Material::from_shear_modulus(4.0, 0.1).unwrap();
    let grid = Grid::new(20, 18, 1.0, 1.1).unwrap();
    let bodies = HalfSpace::new(grid, ElasticPair::new(soft, stiff).unwrap()).unwrap();
    assert!(bodies.pair().dundurs_beta().abs() < 1e-15);
    let ball = kit::sphere(grid, 40.0);
    let press = NormalProblem::builder(&bodies, &ball, NormalLoad::Force(3.0)).tolerance(1e-12);
    let normal = kit::solve(press);

    // Each surface moves into its own body. The sum of both displacements compensates for the approach.
    let sinks = [soft, stiff].map(|body| displacement(&body, normal.pressure(), true));
    for (i, p) in normal.pressure().as_slice().iter().enumerate() {
        let room = ball.as_slice()[i] + sinks[0][i] + sinks[1][i] - normal.approach();
        assert!(if *p > 0.0 {
            room.abs() < 1e-10
        } else {
            room > -1e-10
        });
    }

    // Body 2 is moved by `shift` along +x and body 1 is fixed. Friction then drags the surface of body 1 along +x.
    let load = TangentialLoad::shift([0.05, 0.0]);
    let shear = TangentialProblem::builder(&bodies, &normal, kit::coulomb(0.4), load);
    let shear = kit::solve(shear.tolerance(1e-12));
    assert!(shear.force()[0] > 0.0 && shear.stick_ratio() > 0.1 && shear.stick_ratio() < 0.9);
    let on_one = shear.traction()[0].clone();
    let mut on_two = on_one.clone();
    for q in on_two.as_mut_slice() {
        *q = -*q;
    }
    let one = displacement(&soft, &on_one, false);
    let two = displacement(&stiff, &on_two, false);
    for (i, zone) in shear.zones().iter().enumerate() {
        let position_of_one = one[i];
        let position_of_two = shear.shift()[0] + two[i];
        let slip = position_of_one - position_of_two;
        match zone {
            Zone::Stick => assert!(slip.abs() < 1e-10, "sticking points must move together"),
            Zone::Slip => {
                assert!((slip - shear.slip()[0].as_slice()[i]).abs() < 1e-10);
                // Body 2 moves ahead of body 1 and pulls it forward.
                assert!(slip <= 1e-12 && on_one.as_slice()[i] > 0.0);
            }
            Zone::Separated => assert_eq!(on_one.as_slice()[i], 0.0),
        }
    }
}
