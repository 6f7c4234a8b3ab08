//! Contact on a periodic grid. Full contact is exact, and partial contact agrees with the closed form within the
//! discretisation error. Contacts far from their images agree with contacts on a free half-space.

use std::f64::consts::{PI, TAU};

use kit::{l2_difference, max_abs, max_difference, press, rough, shear, unit_bodies, unit_pair};
use proptest::prelude::*;
use stickslip::Scratch;
use stickslip::cgm::Method;
use stickslip::surface::{Form, SelfAffine};
use stickslip::tangential::JaegerSuperposition;
use stickslip::{
    Boundary, Error, Field, Grid, HalfSpace, NormalLoad, NormalProblem, NormalSolution,
    TangentialLoad, TangentialModel, TangentialProblem, TangentialSolution, Warning, surface,
};

const METHODS: [Method; 2] = [Method::ActiveSet, Method::PolonskyKeer];

fn periodic_bodies(grid: Grid, poisson_ratio: f64) -> HalfSpace {
    HalfSpace::with_boundary(grid, unit_pair(poisson_ratio), Boundary::Periodic).unwrap()
}

/// Amplitude of a wave along x with one period on the unit square.
const DEPTH: f64 = 1e-3;
/// Mean pressure that just closes the wave, `pi E* DEPTH / wavelength`, for a contact modulus of one.
const CLOSING: f64 = PI * DEPTH;

fn wavy_gap(grid: Grid) -> Field {
    Field::from_fn(grid, |x, _| DEPTH * (1.0 - (TAU * x).cos()))
}

/// The pressure in full contact is Westergaard's solution, a cosine wave about the mean pressure.
#[test]
fn full_contact_matches_westergaard() {
    for (cells, method) in [(32, METHODS[0]), (33, METHODS[0]), (48, METHODS[1])] {
        let grid = kit::square(cells, 1.0);
        let load = NormalLoad::Force(1.25 * CLOSING);
        let full = kit::press_by(
            &periodic_bodies(grid, 0.3),
            &wavy_gap(grid),
            load,
            1e-12,
            method,
        );
        assert_eq!(full.contact_cells(), grid.cells());
        let expected = Field::from_fn(grid, |x, _| CLOSING * (1.25 + (TAU * x).cos()));
        let error = max_difference(full.pressure().as_slice(), expected.as_slice());
        assert!(error < 1e-10 * CLOSING, "{cells} {error:e}");
        assert!((full.approach() - DEPTH).abs() < 1e-10 * DEPTH);
        assert!(max_abs(full.gap().as_slice()) < 1e-10 * DEPTH);
        assert!(full.warnings().is_empty());
        assert_eq!(spot_sizes(&full), [grid.cells()]);
    }
}

/// In Westergaard's solution the half-width of the contact is `asin(sqrt(p/p*))/pi` wavelengths. The cells resolve it
/// to about half a cell at either edge. The pressure at the crest, `2 sqrt(p p*)`, converges with second order.
#[test]
fn partial_contact_matches_westergaard() {
    for cells in [64, 128, 256, 512] {
        for fraction in [0.1, 0.3, 0.5, 0.8, 0.95_f64] {
            let grid = Grid::new(cells, 4, 1.0 / cells as f64, 0.25).unwrap();
            let load = NormalLoad::Force(fraction * CLOSING);
            let contact = press(&periodic_bodies(grid, 0.3), &wavy_gap(grid), load, 1e-10);
            let width = 2.0 * fraction.sqrt().asin() / PI;
            let missed = (contact.contact_area() - width) * cells as f64;
            assert!(missed.abs() <= 1.25, "{cells} {fraction}: {missed} cells");
            let peak = 2.0 * CLOSING * fraction.sqrt();
            let error = (contact.pressure().max() / peak - 1.0).abs();
            assert!(
                error <= 4e-3 * (64.0 / cells as f64).powi(2),
                "{cells} {fraction} {error:e}"
            );
        }
    }
}

/// The remaining difference is due to the discretisation. A cell of the free half-space carries a uniform pressure,
/// whereas the periodic grid represents only the waves that fit.
#[test]
fn small_contact_far_from_images_matches_free_half_space() {
    let cells = 256;
    let grid = kit::square(cells, 256.0);
    let ball = kit::sphere(grid, 4000.0);
    let (load, limit) = (NormalLoad::Force(1.35), 0.4 * 1.35);
    let halfway = TangentialLoad::force([0.0, 0.5 * limit]);
    let [free, repeated] = [unit_bodies(grid, 0.3), periodic_bodies(grid, 0.3)].map(|bodies| {
        let normal = press(&bodies, &ball, load, 1e-8);
        let shear = shear(&bodies, &normal, &kit::coulomb(0.4), halfway, 1e-8);
        (normal, shear)
    });
    // The contact radius spans sixteen cells.
    assert!(free.0.contact_cells() > 700);
    let pressures = [&repeated.0, &free.0].map(|normal| normal.pressure().as_slice());
    assert!(l2_difference(pressures[0], pressures[1]) < 5e-3);
    let tractions = [&repeated.1, &free.1].map(|shear| shear.traction()[1].as_slice());
    assert!(l2_difference(tractions[0], tractions[1]) < 1e-2);
    let peak = repeated.0.pressure().max() / free.0.pressure().max() - 1.0;
    assert!(peak.abs() < 1e-3, "{peak:e}");
    let area = repeated.0.contact_area_corrected() / free.0.contact_area_corrected() - 1.0;
    assert!(area.abs() < 0.01, "{area:e}");
    assert!((repeated.1.stick_ratio() - free.1.stick_ratio()).abs() < 0.01);
}

/// Uniform pressure and traction do not displace flat surfaces, so the residual can only be measured relative to the
/// traction itself.
#[test]
fn flat_bodies_carry_uniform_tractions() {
    let grid = Grid::new(30, 21, 1.0, 0.5).unwrap();
    let bodies = periodic_bodies(grid, 0.3);
    let friction = kit::coulomb(0.5);
    for method in METHODS {
        let load = NormalLoad::Force(2.0);
        let normal = kit::press_by(&bodies, &Field::zeros(grid), load, 1e-10, method);
        let even = vec![2.0 / grid.area(); grid.cells()];
        assert!(max_difference(normal.pressure().as_slice(), &even) < 1e-12 * even[0]);
        for (force, stick) in [(0.3, 1.0), (1.0, 0.0)] {
            let load = TangentialLoad::force([force, 0.0]);
            let shear = kit::shear_by(&bodies, &normal, &friction, load, 1e-10, method);
            let even = vec![force / grid.area(); grid.cells()];
            assert!(max_difference(shear.traction()[0].as_slice(), &even) < 1e-12 * even[0]);
            assert_eq!(shear.stick_ratio(), stick);
            assert!(shear.shift()[0].abs() < 1e-12 * even[0]);
        }
        // No wave resists the shift, so any shift causes gross slip.
        for shift in [1e-12, -1.0] {
            let load = TangentialLoad::shift([0.0, shift]);
            let shear = kit::shear_by(&bodies, &normal, &friction, load, 1e-10, method);
            assert!(shear.is_gross_slip());
            assert!((shear.force()[1] - 1.0_f64.copysign(shift)).abs() < 1e-12);
        }
    }
}

/// A single periodic cell is not displaced by its own traction and carries the prescribed loads.
#[test]
fn single_cell_carries_the_prescribed_loads() {
    let grid = Grid::new(1, 1, 2.0, 3.0).unwrap();
    let bodies = periodic_bodies(grid, 0.3);
    let gap = Field::zeros(grid);
    let normal = press(&bodies, &gap, NormalLoad::Force(6.0), 1e-8);
    for lateral in [TangentialModel::Scalar, TangentialModel::Vector] {
        let load = TangentialLoad::force([0.0, -0.5]);
        let shear = kit::solve(
            TangentialProblem::builder(&bodies, &normal, kit::coulomb(0.5), load).model(lateral),
        );
        assert!((shear.traction()[1].max() + 0.5 / 6.0).abs() < 1e-15);
        assert_eq!(shear.stick_ratio(), 1.0);
    }
}

/// A spring or a force moves a single cell up to the friction limit. The solve ends when the error bound that it
/// reports is below the tolerance.
#[test]
fn single_periodic_cell_under_a_spring_converges_within_its_bound() {
    let grid = Grid::new(1, 1, 1.0, 1.0).unwrap();
    let bodies = periodic_bodies(grid, 0.3);
    let force = NormalLoad::Force(1.0);
    let normal = press(&bodies, &Field::zeros(grid), force, 1e-8);
    let friction = kit::coulomb(0.3);
    for i in 1..kit::thorough(200, 2000) {
        let spread = |step: f64| (f64::from(i) * step).fract();
        let stiffness = 10.0_f64.powf(8.0 * spread(0.618_034) - 4.0);
        let (far_end, angle) = (2.0 * spread(0.414_214), TAU * spread(0.732_051));
        let pull = far_end / stiffness.min(1.0);
        let far_end = [pull * angle.cos(), pull * angle.sin()];
        let free = stiffness * pull;
        let dragged = TangentialLoad::spring(far_end, stiffness);
        let part = 0.3 * spread(0.236_068);
        let pushed = TangentialLoad::force([part * angle.cos(), part * angle.sin()]);
        for (load, expected) in [(dragged, free.min(0.3)), (pushed, part)] {
            let shear = kit::solve(
                TangentialProblem::builder(&bodies, &normal, friction.clone(), load)
                    .model(TangentialModel::Vector),
            );
            let report = shear.report();
            assert!(report.is_converged(), "{report}");
            assert!(report.energy_error_bound() <= 1e-8, "{report}");
            let found = shear.force()[0].hypot(shear.force()[1]);
            assert!(
                (found - expected).abs() <= 1e-8 * expected,
                "{found} for {expected}"
            );
        }
    }
}

/// Returns the problem of a rough surface, for contacts from a few spots to nearly full contact. Grids of odd size have
/// no coarser grid.
fn rough_problem(cells: usize, pressure: f64) -> (HalfSpace, Field, NormalLoad) {
    let grid = kit::square(cells, 128.0);
    let load = NormalLoad::Force(pressure * grid.area());
    (periodic_bodies(grid, 0.0), rough(grid, 3), load)
}

const ROUGH_CASES: [(usize, f64); 5] = [
    (128, 1e-3),
    (128, 0.03),
    (101, 0.05),
    (128, 0.1),
    (64, 0.12),
];

#[test]
fn superposition_without_lateral_contraction_is_exact() {
    for (cells, pressure) in ROUGH_CASES {
        let (bodies, gap, load) = rough_problem(cells, pressure);
        let normal = press(&bodies, &gap, load, 1e-11);
        let f = 0.4;
        let lighter = NormalLoad::Force((1.0 - f) * normal.force());
        let stick = press(&bodies, &gap, lighter, 1e-11);
        let load = TangentialLoad::force([f * 0.5 * normal.force(), 0.0]);
        let shear = shear(&bodies, &normal, &kit::coulomb(0.5), load, 1e-11);
        let exact = JaegerSuperposition::new(&normal, &stick, bodies.pair(), 0.5).unwrap();
        let error = l2_difference(shear.traction()[0].as_slice(), exact.traction().as_slice());
        assert!(error < 1e-9, "{cells} {pressure} {error:e}");
        assert_eq!(shear.zones(), exact.zones());
        assert!((shear.shift()[0] / exact.shift() - 1.0).abs() < 1e-9);
    }
}

#[test]
fn displacement_control_inverts_force_control() {
    let friction = kit::coulomb(0.5);
    let most = kit::thorough(101, 128);
    for (cells, pressure) in ROUGH_CASES.into_iter().filter(|scene| scene.0 <= most) {
        let (bodies, gap, load) = rough_problem(cells, pressure);
        for method in METHODS {
            let normal = kit::press_by(&bodies, &gap, load, 1e-10, method);
            let approach = NormalLoad::Approach(normal.approach());
            let back = kit::press_by(&bodies, &gap, approach, 1e-10, method);
            assert!((back.force() / normal.force() - 1.0).abs() < 1e-8);
            assert!(back.report().energy_error_bound() <= 1e-10);

            let force = TangentialLoad::force([0.0, 0.6 * 0.5 * normal.force()]);
            let sheared = kit::shear_by(&bodies, &normal, &friction, force, 1e-10, method);
            let shift = TangentialLoad::shift(sheared.shift());
            let back = kit::shear_by(&bodies, &normal, &friction, shift, 1e-10, method);
            assert!((back.force()[1] / sheared.force()[1] - 1.0).abs() < 1e-8);
        }
    }
}

/// In full contact only the waves of the traction resist a shift, so any shift causes slip.
#[test]
fn force_in_full_contact_grows_with_shift() {
    let grid = kit::square(64, 1.0);
    let bodies = periodic_bodies(grid, 0.3);
    let load = NormalLoad::Force(1.5 * CLOSING);
    let normal = press(&bodies, &wavy_gap(grid), load, 1e-10);
    for method in METHODS {
        let mut last: Option<TangentialSolution> = None;
        for shift in [1e-12, 1e-6, 1e-5, 1e-4, 1e-2] {
            let load = TangentialLoad::shift([shift, 0.0]);
            let next = kit::shear_by(&bodies, &normal, &kit::coulomb(0.5), load, 1e-8, method);
            if let Some(last) = last {
                assert!(next.force()[0] >= last.force()[0]);
                assert!(next.stick_ratio() <= last.stick_ratio());
            }
            last = Some(next);
        }
        assert!(last.unwrap().is_gross_slip());
    }
}

#[test]
fn approach_beyond_mean_gap_is_rejected() {
    let (bodies, gap, load) = rough_problem(32, 0.01);
    let mean = gap.integral() / gap.grid().area();
    let refused = |error: Error, approach: f64| {
        let Error::ApproachBeyondMeanGap {
            approach: found,
            mean_gap,
            ..
        } = error
        else {
            panic!("{error}");
        };
        assert_eq!(found, approach);
        assert!((mean_gap / mean - 1.0).abs() < 1e-12);
    };
    for approach in [mean * (1.0 + 1e-12), gap.max()] {
        let builder = NormalProblem::builder(&bodies, &gap, NormalLoad::Approach(approach));
        refused(builder.build().unwrap_err(), approach);
        let problem = NormalProblem::builder(&bodies, &gap, load).build().unwrap();
        let error = problem
            .into_solver()
            .unwrap()
            .set_load(NormalLoad::Approach(approach));
        refused(error.unwrap_err(), approach);
    }
    let approach = 0.9 * mean;
    let problem = NormalProblem::builder(&bodies, &gap, NormalLoad::Approach(approach)).build();
    let mut solver = problem.unwrap().into_solver().unwrap();
    let flatter = Field::from_vec(gap.grid(), gap.as_slice().iter().map(|h| 0.5 * h).collect());
    kit::assert_refused! { solver.set_gap(&flatter.unwrap()) => Error::ApproachBeyondMeanGap { .. } }
    let contact = kit::solved(&mut solver);
    assert!(contact.force() > 0.0);
}

#[test]
fn solution_with_different_boundary_is_rejected() {
    let (bodies, gap, load) = rough_problem(32, 0.01);
    let free = unit_bodies(gap.grid(), 0.0);
    let normal = press(&free, &gap, load, 1e-6);
    let shear = TangentialLoad::force([0.0, 0.0]);
    let mismatch = TangentialProblem::builder(&bodies, &normal, kit::coulomb(0.5), shear).build();
    assert!(matches!(mismatch, Err(Error::BoundaryMismatch { .. })));
    let problem = NormalProblem::builder(&bodies, &gap, load).build().unwrap();
    kit::assert_refused! {
        problem.into_solver().unwrap().solve_into(&mut normal.clone()) => Error::BoundaryMismatch { .. },
    }
}

/// Shifts a field periodically by whole cells.
fn shift_periodically(field: &Field, [dx, dy]: [usize; 2]) -> Field {
    let (nx, ny) = (field.grid().nx(), field.grid().ny());
    let at = |ix, iy| field.as_slice()[((iy + dy) % ny) * nx + (ix + dx) % nx];
    Field::from_indices(field.grid(), at)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(kit::thorough(8, 24)))]

    /// A shift of the surface shifts the contact, because all positions on a torus are equivalent.
    #[test]
    fn shifted_surface_shifts_the_contact(
        (nx, ny, dx, dy, seed) in (8..40_usize, 8..40_usize, 0..40_usize, 0..40_usize, any::<u64>())
    ) {
        let grid = Grid::new(nx, ny, 1.0, 0.7).unwrap();
        let gap = rough(grid, seed);
        let bodies = periodic_bodies(grid, 0.3);
        let load = NormalLoad::Force(0.05 * grid.area());
        let halfway = TangentialLoad::force([0.25 * 0.05 * grid.area(), 0.0]);
        let solve = |gap: &Field| {
            let normal = press(&bodies, gap, load, 1e-11);
            let sheared = shear(&bodies, &normal, &kit::coulomb(0.5), halfway, 1e-11);
            (normal, sheared)
        };
        let (normal, sheared) = solve(&gap);
        let by = [dx, dy];
        let (normal_there, sheared_there) = solve(&shift_periodically(&gap, by));
        let error = l2_difference(normal_there.pressure().as_slice(), shift_periodically(normal.pressure(), by).as_slice());
        prop_assert!(error < 1e-8, "{error:e}");
        let error = l2_difference(
            sheared_there.traction()[0].as_slice(),
            shift_periodically(sheared.traction()[0], by).as_slice(),
        );
        prop_assert!(error < 1e-8, "{error:e}");
        prop_assert_eq!(spot_sizes(&normal), spot_sizes(&normal_there));
    }
}

#[cfg(feature = "dense")]
mod dense_reference {
    use super::*;
    use stickslip::Operator;
    use stickslip::cgm::{AbsBound, NonNegative};
    use stickslip::dense::DenseOperator;
    use stickslip::influence::Component;

    /// Adds a multiple of the mean to the matrix, so that the matrix is definite. The minimisers under a given total
    /// are unchanged.
    fn with_definite_mean(bodies: &HalfSpace, component: Component) -> DenseOperator {
        let dense = DenseOperator::of_half_space(bodies, component).unwrap();
        let cells = bodies.grid().cells();
        let own = dense.get(0, 0).unwrap();
        let entry = |n: usize| dense.get(n / cells, n % cells).unwrap() + own;
        DenseOperator::from_rows(cells, (0..cells * cells).map(entry).collect()).unwrap()
    }

    /// Computes `|a - b|_C / |b|_C`. A uniform field has no energy, so the norm of `b` is replaced by the bound from
    /// the smallest eigenvalue if this bound is larger.
    fn energy_error(matrix: &DenseOperator, smallest: f64, a: &[f64], b: &[f64]) -> f64 {
        let energy = |x: &[f64]| {
            let mean = x.iter().sum::<f64>() / x.len() as f64;
            let x: Vec<f64> = x.iter().map(|x| x - mean).collect();
            let mut product = vec![0.0; x.len()];
            matrix.apply([&x], [&mut product], &mut Scratch::none());
            x.iter().zip(&product).map(|(x, u)| x * u).sum::<f64>()
        };
        let difference: Vec<f64> = a.iter().zip(b).map(|(a, b)| a - b).collect();
        let least = smallest * b.iter().map(|b| b * b).sum::<f64>();
        (energy(&difference).max(0.0) / energy(b).max(least)).sqrt()
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(kit::thorough(16, 48)))]

        #[test]
        fn error_is_within_certificate(
            (nx, ny, pressure, f, tolerance, seed) in (
                8..18_usize, 6..16_usize, -2.5..0.5_f64, 0.05..0.95_f64, -10.0..-1.0_f64, any::<u64>(),
            )
        ) {
            let grid = Grid::new(nx, ny, 1.0, 0.8).unwrap();
            let (bodies, gap) = (periodic_bodies(grid, 0.3), rough(grid, seed));
            let smallest = |component| bodies.operator(component).unwrap().lower_bound();
            let tolerance = 10_f64.powf(tolerance);
            let force = 10_f64.powf(pressure) * grid.area();
            let normal =
                press(&bodies, &gap, NormalLoad::Force(force), tolerance);
            let matrix = with_definite_mean(&bodies, Component::ZZ);
            let total = Some(force / grid.cell_area());
            let exact = matrix.minimise(gap.as_slice(), &NonNegative, total).unwrap();
            let error = energy_error(&matrix, smallest(Component::ZZ), normal.pressure().as_slice(), &exact.x);
            let bound = normal.report().energy_error_bound();
            prop_assert!(bound <= tolerance && error <= bound * (1.0 + 1e-6) + 1e-12, "{error:e} {bound:e}");

            let load = TangentialLoad::force([f * 0.5 * normal.force(), 0.0]);
            let sheared = shear(&bodies, &normal, &kit::coulomb(0.5), load, tolerance);
            let limits: Vec<f64> = normal.pressure().as_slice().iter().map(|p| 0.5 * p).collect();
            let matrix = with_definite_mean(&bodies, Component::XX);
            let total = Some(sheared.force()[0] / grid.cell_area());
            let zeros = vec![0.0; grid.cells()];
            let exact = matrix.minimise(&zeros, &AbsBound(&limits), total).unwrap();
            let error = energy_error(&matrix, smallest(Component::XX), sheared.traction()[0].as_slice(), &exact.x);
            let bound = sheared.report().energy_error_bound();
            prop_assert!(bound <= tolerance && error <= bound * (1.0 + 1e-6) + 1e-12, "{error:e} {bound:e}");
        }
    }
}

/// Returns the number of cells of each contact spot, largest first.
fn spot_sizes(contact: &NormalSolution) -> Vec<usize> {
    let spots = contact.spots().unwrap();
    let mut sizes: Vec<_> = spots.as_slice().iter().map(|spot| spot.cells).collect();
    sizes.sort_unstable_by(|a, b| b.cmp(a));
    sizes
}

/// Returns the warning of a seam of a gap under a light load on a periodic grid.
fn seam(gap: &Field) -> Option<Warning> {
    let bodies = periodic_bodies(gap.grid(), 0.3);
    let (grid, range) = (gap.grid(), gap.max() - gap.min());
    let load = NormalLoad::Force(0.02 * range * grid.dx() * grid.nx() as f64);
    let contact = kit::solve(NormalProblem::builder(&bodies, gap, load));
    let is_seam = |warning: &Warning| matches!(warning, Warning::PeriodicSeam { .. });
    contact.warnings().into_iter().find(is_seam)
}

/// Returns a gap plus a tilt along x and along y, by these heights over the sides of the grid.
fn tilted(gap: &Field, [x, y]: [f64; 2]) -> Field {
    let grid = gap.grid();
    let plane = Field::from_fn(grid, |along, across| x * along + y * across);
    surface::sum(&[gap, &plane]).unwrap()
}

/// A tilt of a periodic surface is a jump at the border. Surfaces without a tilt do not have the warning, even if they are not
/// periodic.
#[test]
fn tilted_periodic_surface_gives_warning() {
    let grid = kit::square(64, 1.0);
    for seed in 0..kit::thorough(6, 100) {
        let rough = SelfAffine::with_rms_height(1e-3).seed(seed);
        let rough = rough.cut_off_wavelength(8.0 / 64.0);
        let periodic = rough.generate(grid).unwrap();
        let gap = surface::gap_from_heights(periodic.heights()).unwrap();
        assert_eq!(seam(&gap), None, "{seed}");
        let measured = rough.cropped().generate(grid).unwrap();
        let measured = surface::level(measured.heights(), Form::Plane).unwrap();
        let measured = surface::gap_from_heights(measured.heights()).unwrap();
        assert_eq!(seam(&measured), None, "{seed}");
        for tilt in [[0.02, 0.0], [0.0, -0.02], [0.02, 0.02]] {
            let found = seam(&tilted(&gap, tilt));
            let Some(Warning::PeriodicSeam {
                along_x, along_y, ..
            }) = found
            else {
                panic!("{seed} {tilt:?}: {found:?}");
            };
            assert_eq!([along_x, along_y], tilt.map(|tilt| tilt != 0.0), "{seed}");
        }
    }
}

/// Symmetric shapes, off-centre balls, waves and grooves have no seam. A tilted flat body has one.
#[test]
fn periodic_shapes_without_tilt_give_no_warning() {
    let grid = kit::square(64, 1.0);
    let ball = |x: f64, y: f64| x * x + y * y;
    let shapes = [
        Field::from_fn(grid, ball),
        Field::from_fn(grid, |x, y| ball(x - 0.2, y + 0.1)),
        Field::from_fn(grid, |x, _| 0.01 * (TAU * x).sin()),
        Field::from_fn(grid, |x, _| if x < 0.0 { 0.0 } else { 0.01 }),
        Field::zeros(grid),
    ];
    for (index, shape) in shapes.iter().enumerate() {
        assert_eq!(seam(shape), None, "{index}");
    }
    let flat = tilted(&Field::zeros(grid), [0.01, 0.0]);
    let (along_x, along_y, times) = (true, false, 63);
    assert_eq!(
        seam(&flat),
        Some(Warning::PeriodicSeam {
            along_x,
            along_y,
            times
        })
    );
    // A free boundary has no seam.
    let bodies = HalfSpace::new(grid, unit_pair(0.3)).unwrap();
    let contact = kit::solve(NormalProblem::builder(
        &bodies,
        &flat,
        NormalLoad::Force(1e-4),
    ));
    let is_seam = |warning: &Warning| matches!(warning, Warning::PeriodicSeam { .. });
    assert!(!contact.warnings().iter().any(is_seam));
}
