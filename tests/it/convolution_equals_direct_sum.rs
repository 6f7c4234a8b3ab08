//! The fast product equals the direct sum, for all nine components on any grid.

use kit::{max_abs, max_difference};
use proptest::prelude::*;
use stickslip::dense::DenseOperator;
use stickslip::influence::Component;
use stickslip::{Boundary, ElasticPair, Grid, HalfSpace, Material, Operator};

/// Odd and even, square and not, one row, one column, one cell.
fn grid() -> impl Strategy<Value = Grid> {
    let side = prop_oneof![Just(1_usize), 2..12_usize, 12..24_usize];
    (side.clone(), side, -9.0..3.0_f64, -1.0..1.0_f64).prop_map(|(nx, ny, size, aspect)| {
        let dx = 10_f64.powf(size);
        Grid::new(nx, ny, dx, dx * 10_f64.powf(aspect)).unwrap()
    })
}

fn pair() -> impl Strategy<Value = ElasticPair> {
    (0.0..12.0_f64, -0.5..0.5_f64, 0.0..12.0_f64, -0.5..0.5_f64).prop_map(|(e1, nu1, e2, nu2)| {
        let body = |decade, nu| Material::new(10_f64.powf(decade), nu).unwrap();
        ElasticPair::new(body(e1, nu1), body(e2, nu2)).unwrap()
    })
}

fn boundary() -> impl Strategy<Value = Boundary> {
    prop_oneof![Just(Boundary::Free), Just(Boundary::Periodic)]
}

proptest! {
    #[test]
    fn all_nine_components(
        (grid, pair, boundary, seed) in (grid(), pair(), boundary(), any::<u64>())
    ) {
        let bodies = HalfSpace::with_boundary(grid, pair, boundary).unwrap();
        let mut random = kit::Random(seed);
        let mut traction: Vec<f64> = (0..grid.cells()).map(|_| random.uniform(-1.0, 1.0)).collect();
        // Rows without traction take a shorter way.
        for row in traction.chunks_exact_mut(grid.nx()).step_by(3) {
            row.fill(0.0);
        }
        for component in Component::ALL {
            let fast = bodies.operator(component).unwrap();
            let dense = DenseOperator::of_half_space(&bodies, component).unwrap();
            let (mut u, mut expected) = (vec![0.0; grid.cells()], vec![0.0; grid.cells()]);
            fast.apply(&traction, &mut u, &mut fast.workspace());
            dense.apply(&traction, &mut expected, &mut ());
            // The scale of a product, not of its cancelled remainder: row sum times traction.
            let row_sum = (0..grid.cells())
                .map(|i| (0..grid.cells()).map(|j| dense.get(i, j).unwrap().abs()).sum::<f64>())
                .fold(0.0, f64::max);
            let scale = row_sum * max_abs(&traction);
            prop_assert!(
                max_difference(&u, &expected) <= 1e-13 * scale,
                "{:?}: {:e}", component, max_difference(&u, &expected) / scale
            );
        }
    }

    /// On a periodic grid the bound is that of fields of mean zero: with a mean that counts, of all.
    #[test]
    fn the_smallest_periodic_eigenvalue_is_bounded((grid, pair) in (grid(), pair())) {
        let bodies = HalfSpace::with_boundary(grid, pair, Boundary::Periodic).unwrap();
        let cells = grid.cells();
        for component in [Component::XX, Component::YY, Component::ZZ] {
            let bound = bodies.operator(component).unwrap().lower_bound();
            let dense = DenseOperator::of_half_space(&bodies, component).unwrap();
            let own = dense.get(0, 0).unwrap();
            let entry = |n: usize| dense.get(n / cells, n % cells).unwrap() + own;
            let raised = DenseOperator::from_rows(cells, (0..cells * cells).map(entry).collect()).unwrap();
            // The mean has become the largest eigenvalue; round-off is a part of that.
            let round_off = 1e-13 * own * cells as f64;
            prop_assert!((bound - raised.lower_bound()).abs() <= round_off + 1e-9 * bound);
            prop_assert!(cells == 1 || bound > 0.0);
        }
    }

    /// The bound that certificates rest on is below the true smallest eigenvalue, and not far.
    #[test]
    fn the_smallest_eigenvalue_is_bounded((grid, pair) in (grid(), pair())) {
        let bodies = HalfSpace::new(grid, pair).unwrap();
        for component in [Component::XX, Component::YY, Component::ZZ] {
            let dense = DenseOperator::of_half_space(&bodies, component).unwrap();
            let bound = bodies.operator(component).unwrap().lower_bound();
            prop_assert!(bound > 0.0, "{:?} {:?} {}", grid, component, bound);
            prop_assert!(bound <= dense.lower_bound() * (1.0 + 1e-12));
        }
    }
}

#[test]
fn a_larger_grid_equals_the_direct_sum_too() {
    let grid = Grid::new(61, 40, 0.3, 0.2).unwrap();
    let bodies = kit::unit_bodies(grid, 0.3);
    let mut random = kit::Random(7);
    let traction: Vec<f64> = (0..grid.cells())
        .map(|_| random.uniform(-1.0, 1.0))
        .collect();
    for component in [Component::XX, Component::XY, Component::ZZ] {
        let fast = bodies.operator(component).unwrap();
        let dense = DenseOperator::of_half_space(&bodies, component).unwrap();
        let (mut u, mut expected) = (vec![0.0; grid.cells()], vec![0.0; grid.cells()]);
        fast.apply(&traction, &mut u, &mut fast.workspace());
        dense.apply(&traction, &mut expected, &mut ());
        let error = max_difference(&u, &expected) / max_abs(&expected);
        assert!(error <= 1e-13, "{component:?}: {error:e}");
    }
}
