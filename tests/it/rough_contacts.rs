//! Rough contacts agree with theory on surfaces that the cells resolve. The tests compare the area of rough balls and
//! the dependence of the area on slope and load. They also compare the dependence of the stick ratio on the tangential
//! load.

use rayon::prelude::*;
use stickslip::analytical::{HertzSphere, RoughSphere};
use stickslip::surface::{self, SelfAffine};
use stickslip::{
    Boundary, ElasticPair, Field, HalfSpace, NormalLoad, NormalSolution, TangentialLoad,
    TangentialProblem,
};

/// The discretisation error is much larger than this tolerance.
const TOLERANCE: f64 = 1e-5;

/// Returns the rubber of the paper on a rigid plane. The contact modulus is 25 MPa, and lengths are in micrometres.
fn rubber() -> ElasticPair {
    kit::on_rigid(18.75, 0.5)
}

fn press(bodies: &HalfSpace, gap: &Field, force: f64) -> NormalSolution {
    let load = NormalLoad::Force(force);
    let method = stickslip::cgm::Method::ActiveSet;
    kit::press_by(bodies, gap, load, TOLERANCE, method)
}

/// Returns the real area, counted and corrected, divided by Mueser's area, as a mean over two surfaces (Fig. 14).
fn ball_over_mueser(bodies: &HalfSpace, roll_off: f64, force: f64) -> [f64; 2] {
    const SLOPE: f64 = 0.7518;
    let grid = bodies.grid();
    let ratios = [0, 1].map(|seed| {
        let rough = SelfAffine::with_rms_slope(SLOPE)
            .roll_off_wavelength(roll_off)
            .cut_off_wavelength(6.4)
            .seed(seed)
            .generate(grid)
            .unwrap();
        let ball = kit::sphere(grid, 3500.0);
        let gap = surface::sum(&[&ball, &surface::inverted(rough.heights())]).unwrap();
        let contact = press(bodies, &gap, force);
        assert!(contact.contact_cells() > 500);
        let hertz = HertzSphere::new(bodies.pair(), 3500.0, force).unwrap();
        let mueser = RoughSphere::new(hertz, SLOPE).unwrap().contact_area();
        [contact.contact_area(), contact.contact_area_corrected()].map(|area| area / mueser)
    });
    [0, 1].map(|i| 0.5 * (ratios[0][i] + ratios[1][i]))
}

#[test]
fn rough_ball_area_matches_mueser_for_any_rms_height() {
    let bodies = HalfSpace::new(kit::square(640, 640.0), rubber()).unwrap();
    for &force in kit::thorough(&[15e3][..], &[15e3, 50e3]) {
        let roll_offs = kit::thorough(&[192.0, 64.0][..], &[192.0, 112.0, 64.0]);
        let ratios: Vec<[f64; 2]> = roll_offs
            .par_iter()
            .map(|&roll_off| ball_over_mueser(&bodies, roll_off, force))
            .collect();
        for [counted, corrected] in &ratios {
            assert!((counted - 1.0).abs() < 0.25, "{force} {ratios:?}");
            assert!((corrected - 1.0).abs() < 0.10, "{force} {ratios:?}");
        }
        // The rms heights differ by a factor of two.
        let [first, .., last] = &ratios[..] else {
            panic!("two roll-offs");
        };
        assert!((first[1] - last[1]).abs() < 0.08, "{ratios:?}");
    }
}

/// Returns a nominally flat contact without edges, on a square of 100 micrometres.
fn flat_bodies(cells: usize) -> HalfSpace {
    HalfSpace::with_boundary(kit::square(cells, 100.0), rubber(), Boundary::Periodic).unwrap()
}

/// Returns the slope of the least-squares line through the logarithms of the points.
fn exponent(points: &[[f64; 2]]) -> f64 {
    let n = points.len() as f64;
    let mean = |axis: usize| points.iter().map(|point| point[axis].ln()).sum::<f64>() / n;
    let centre = [mean(0), mean(1)];
    let from_centre = |point: &[f64; 2]| [0, 1].map(|axis| point[axis].ln() - centre[axis]);
    let sums = points.iter().map(from_centre);
    let [xy, xx] = sums.fold([0.0; 2], |sum, [x, y]| [sum[0] + x * y, sum[1] + x * x]);
    xy / xx
}

/// At a fixed rms height and load the roll-off wavelength, and therefore the slope, varies. The area is proportional to
/// 1 / slope.
#[test]
fn area_is_inversely_proportional_to_rms_slope() {
    let bodies = flat_bodies(512);
    let force = 5e-3 * 25.0 * bodies.grid().area();
    let points: Vec<[f64; 2]> = kit::thorough(&[30.0, 7.5, 2.5][..], &[30.0, 15.0, 7.5, 4.0, 2.5])
        .par_iter()
        .map(|&roll_off| {
            let rough = SelfAffine::with_rms_height(0.1)
                .roll_off_wavelength(roll_off)
                .seed(2)
                .generate(bodies.grid())
                .unwrap();
            let gap = surface::gap_from_heights(rough.heights()).unwrap();
            let contact = press(&bodies, &gap, force);
            [rough.rms_slope(), contact.contact_area_corrected()]
        })
        .collect();
    let exponent = exponent(&points);
    assert!((exponent + 1.0).abs() < 0.15, "{exponent} {points:?}");
}

#[test]
fn area_is_proportional_to_load() {
    let bodies = flat_bodies(256);
    let rough = SelfAffine::with_rms_slope(0.3)
        .roll_off_wavelength(25.0)
        .seed(4);
    let rough = rough.generate(bodies.grid()).unwrap();
    let gap = surface::gap_from_heights(rough.heights()).unwrap();
    let points = [2e-3, 4e-3, 8e-3, 16e-3, 32e-3].map(|pressure| {
        let contact = press(&bodies, &gap, pressure * 25.0 * bodies.grid().area());
        [pressure, contact.contact_area_corrected()]
    });
    let exponent = exponent(&points);
    assert!((exponent - 1.0).abs() < 0.1, "{exponent} {points:?}");
}

/// Compares with Figs. 24 to 26 for four surfaces and loads, with at least 2000 cells in contact.
#[test]
fn stick_ratio_falls_linearly_with_tangential_load() {
    let bodies = flat_bodies(kit::thorough(256, 512));
    let scenes = [
        (0, 0.1, 50.0, 1e-3),
        (1, 0.2, 25.0, 5e-3),
        (2, 0.4, 12.5, 20e-3),
        (3, 0.8, 6.25, 10e-3),
    ];
    // The other surfaces have too few contact cells on the coarser grid.
    scenes[kit::thorough(2..3, 0..4)]
        .par_iter()
        .for_each(|&(seed, slope, roll_off, pressure)| {
            let rough = SelfAffine::with_rms_slope(slope)
                .roll_off_wavelength(roll_off)
                .seed(seed)
                .generate(bodies.grid())
                .unwrap();
            let gap = surface::gap_from_heights(rough.heights()).unwrap();
            let normal = press(&bodies, &gap, pressure * 25.0 * bodies.grid().area());
            assert!(normal.contact_cells() >= 2000);
            let none = TangentialLoad::force([0.0, 0.0]);
            let problem = TangentialProblem::builder(&bodies, &normal, kit::coulomb(0.5), none)
                .tolerance(TOLERANCE)
                .build()
                .unwrap();
            let mut solver = problem.into_solver().unwrap();
            let mut shear = solver.new_solution();
            let mut deviations = Vec::new();
            for step in 0..=10 {
                let f = f64::from(step) / 10.0;
                let load = TangentialLoad::force([f * solver.friction_capacity(), 0.0]);
                solver.set_load(load).unwrap();
                solver.solve_into(&mut shear).unwrap();
                let stick = shear.stick_ratio();
                match step {
                    0 => assert_eq!(stick, 1.0),
                    10 => assert_eq!(stick, 0.0),
                    _ => assert!(
                        stick < (1.0 - f).powf(2.0 / 3.0),
                        "the stick ratio must be below that of a smooth ball"
                    ),
                }
                deviations.push((stick - (1.0 - f)).abs());
            }
            let mean = deviations.iter().sum::<f64>() / deviations.len() as f64;
            assert!(
                deviations.iter().all(|&d| d <= 0.05) && mean <= 0.03,
                "{deviations:?}"
            );
        });
}

/// With free edges the outer cells carry more pressure than on a periodic grid. The nominally flat surfaces of the
/// paper have free edges.
#[test]
fn free_edges_bias_nominally_flat_contact() {
    let grid = kit::square(128, 100.0);
    let free = HalfSpace::new(grid, rubber()).unwrap();
    let repeated = flat_bodies(128);
    let rough = SelfAffine::with_rms_height(0.3)
        .roll_off_wavelength(25.0)
        .seed(1);
    let gap = surface::gap_from_heights(rough.generate(grid).unwrap().heights()).unwrap();
    let outer_fraction = |bodies: &HalfSpace| {
        let contact = press(bodies, &gap, 0.02 * 25.0 * grid.area());
        let is_outer = |i: usize| {
            let cell = [i % 128, i / 128];
            cell.iter().any(|&c| !(19..109).contains(&c))
        };
        let pressure = contact.pressure().as_slice();
        let outer: f64 = (0..pressure.len())
            .filter(|&i| is_outer(i))
            .map(|i| pressure[i])
            .sum();
        outer * grid.cell_area() / contact.force()
    };
    let [free, repeated] = [outer_fraction(&free), outer_fraction(&repeated)];
    assert!(free > 1.05 * repeated, "{free} {repeated}");
}
