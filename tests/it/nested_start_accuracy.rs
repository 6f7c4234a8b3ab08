//! Starts are interpolated from coarser grids and include the contact edges of the coarse solution. Fine grids
//! therefore need few iterations.

use stickslip::surface::SelfAffine;
use stickslip::*;

/// Returns the number of iterations of the vector model for a periodic rough surface on `n` x `n` cells. A tenth of the
/// cells are in contact.
fn iterations(n: usize, seed: u64) -> usize {
    let grid = kit::square(n, 1.0);
    let pair = kit::on_rigid(1.0, 0.3);
    let bodies = HalfSpace::with_boundary(grid, pair, Boundary::Periodic).unwrap();
    let rough = SelfAffine::with_rms_slope(0.1)
        .cut_off_wavelength(8.0 * grid.dx())
        .seed(seed);
    let gap = rough.generate(grid).unwrap().heights().map(|z| -z);
    let load = NormalLoad::Force(0.005 * pair.contact_modulus());
    let normal = NormalProblem::builder(&bodies, &gap, load);
    let normal = kit::solve(normal);

    let (friction, force) = (0.4, 0.24 * normal.force());
    let (friction, load) = (
        kit::coulomb(friction),
        TangentialLoad::force([0.8 * force, 0.6 * force]),
    );
    let shear = TangentialProblem::builder(&bodies, &normal, friction, load);
    let shear = shear.model(TangentialModel::Vector).build().unwrap();
    let shear = shear.solve().unwrap();
    let stick = shear.stick_ratio();
    assert!(stick > 0.15 && stick < 0.3, "{stick}");
    shear.report().iterations
}

/// The measured numbers of iterations are 32, 30 and 30. They would be 44, 39 and 42 if the deficits of the coarse
/// totals were also distributed over slipping cells.
#[test]
fn nested_start_of_rough_vector_problem_needs_few_iterations() {
    for &seed in kit::thorough(&[0][..], &[0, 4, 5]) {
        let iterations = iterations(512, seed);
        assert!(iterations <= 36, "seed {seed}: {iterations}");
    }
}

/// Measured numbers of products in single precision, for tolerances of 1e-3 and 1e-6: 4 and 8 for the pressure, and 7
/// and 12 for the shear. If only the tractions are interpolated, the numbers are 10 and 14 for the pressure, and 9 and
/// 16 for the shear.
#[test]
fn nested_start_of_sphere_needs_few_products() {
    let grid = kit::square(256, 3.0);
    let pair = kit::on_rigid(1.0, 0.3);
    let bodies = HalfSpace::new(grid, pair).unwrap();
    let force = 4.0 / 3.0 * pair.contact_modulus() / 20.0;
    for (tolerance, most) in [(1e-3, [5, 8]), (1e-6, [9, 13])] {
        let normal =
            NormalProblem::builder(&bodies, kit::sphere(grid, 20.0), NormalLoad::Force(force));
        let normal = normal.tolerance(tolerance).build().unwrap();
        let normal = normal.solve().unwrap();
        let load = TangentialLoad::force([0.2 * force, 0.0]);
        let shear = TangentialProblem::builder(&bodies, &normal, kit::coulomb(0.5), load);
        let shear = kit::solve(shear.tolerance(tolerance));
        for (report, most) in [normal.report(), shear.report()].into_iter().zip(most) {
            assert!(report.single_precision_products <= most, "{report}");
        }
    }
}
