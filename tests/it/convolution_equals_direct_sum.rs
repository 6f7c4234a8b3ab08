//! The fast product equals the direct sum for all nine components, and for tensors composed of them, on any grid.

use kit::{max_abs, max_difference};
use proptest::prelude::*;
use stickslip::dense::DenseOperator;
use stickslip::influence::Component;
use stickslip::influence::Direction::{self, X, Y, Z};
use stickslip::{Boundary, ElasticPair, Grid, HalfSpace, Material, Operator, Scratch};

/// Generates odd and even grids, square and oblong grids, and grids with one row, one column or one cell.
fn any_grid() -> impl Strategy<Value = Grid> {
    let side = prop_oneof![Just(1_usize), 2..12_usize, 12..24_usize];
    (side.clone(), side, -9.0..3.0_f64, -1.0..1.0_f64).prop_map(|(nx, ny, size, aspect)| {
        let dx = 10_f64.powf(size);
        Grid::new(nx, ny, dx, dx * 10_f64.powf(aspect)).unwrap()
    })
}

fn any_pair() -> impl Strategy<Value = ElasticPair> {
    (0.0..12.0_f64, -0.5..0.5_f64, 0.0..12.0_f64, -0.5..0.5_f64).prop_map(|(e1, nu1, e2, nu2)| {
        let body = |decade, nu| Material::new(10_f64.powf(decade), nu).unwrap();
        ElasticPair::new(body(e1, nu1), body(e2, nu2)).unwrap()
    })
}

/// Operator, preconditioner and explicit matrix of a tensor on one grid.
struct Tensor<const N: usize> {
    bodies: HalfSpace,
    directions: [Direction; N],
    cells: usize,
    /// Matrix of all components, stored in consecutive blocks.
    matrix: DenseOperator,
}

type Vectors<const N: usize> = [Vec<f64>; N];

impl<const N: usize> Tensor<N> {
    fn new(bodies: &HalfSpace, directions: [Direction; N]) -> Self {
        let (bodies, cells) = (bodies.clone(), bodies.grid().cells());
        let parts = directions.map(|u| {
            directions.map(|t| DenseOperator::of_half_space(&bodies, Component::of(u, t)).unwrap())
        });
        // A mean causes no displacement on a periodic grid, so its eigenvalue is raised above all others.
        let raised = match bodies.boundary() {
            Boundary::Periodic => (0..N)
                .map(|n| parts[n][n].get(0, 0).unwrap())
                .fold(0.0, f64::max),
            _ => 0.0,
        };
        let entry = |row: usize, column: usize| {
            let (u, t) = (row / cells, column / cells);
            let entry = parts[u][t].get(row % cells, column % cells).unwrap();
            if u == t { entry + raised } else { entry }
        };
        let len = N * cells;
        let entries = (0..len * len).map(|k| entry(k / len, k % len)).collect();
        let matrix = DenseOperator::from_rows(len, entries).unwrap();
        Self {
            bodies,
            directions,
            cells,
            matrix,
        }
    }

    /// Returns the largest row sum of magnitudes, the scale of the round-off in products of numbers up to one.
    fn scale(&self) -> f64 {
        let len = N * self.cells;
        let entry = |i, j| self.matrix.get(i, j).unwrap().abs();
        (0..len)
            .map(|i| (0..len).map(|j| entry(i, j)).sum())
            .fold(0.0, f64::max)
    }

    /// Returns random numbers up to one, with zero mean if a mean causes no displacement.
    fn traction(&self, random: &mut kit::Random) -> Vectors<N> {
        std::array::from_fn(|_| {
            let mut values: Vec<f64> = (0..self.cells).map(|_| random.uniform(-1.0, 1.0)).collect();
            if self.bodies.boundary() == Boundary::Periodic {
                let mean = values.iter().sum::<f64>() / self.cells as f64;
                for value in &mut values {
                    *value = 0.5 * (*value - mean);
                }
            }
            values
        })
    }

    /// Computes the products by the operator in double and in single precision, and by the matrix.
    fn products(&self, x: &Vectors<N>) -> [Vectors<N>; 3] {
        let fast = self.bodies.tensor_operator(self.directions).unwrap();
        let mut workspace = fast.scratch().unwrap();
        let zeros = || x.each_ref().map(|x| vec![0.0; x.len()]);
        let (mut double, mut single) = (zeros(), zeros());
        let x = x.each_ref().map(|x| &x[..]);
        fast.apply(x, double.each_mut().map(|u| &mut u[..]), &mut workspace);
        fast.apply_f32(x, single.each_mut().map(|u| &mut u[..]), &mut workspace);
        let mut direct = vec![0.0; N * self.cells];
        self.matrix
            .apply([&x.concat()], [&mut direct], &mut Scratch::none());
        let direct = std::array::from_fn(|n| direct[n * self.cells..][..self.cells].to_vec());
        [double, single, direct]
    }

    fn check(&self, seed: u64) -> Result<(), TestCaseError> {
        let mut random = kit::Random(seed);
        let (x, y) = (self.traction(&mut random), self.traction(&mut random));
        let ([cx, single, direct], [cy, ..]) = (self.products(&x), self.products(&y));
        let scale = self.scale();
        for n in 0..N {
            let error = max_difference(&cx[n], &direct[n]);
            prop_assert!(error <= 1e-13 * scale, "double, field {}: {:e}", n, error);
            let error = max_difference(&single[n], &direct[n]);
            prop_assert!(error <= 2e-6 * scale, "single, field {}: {:e}", n, error);
        }
        let dot = |a: &Vectors<N>, b: &Vectors<N>| -> f64 {
            a.iter()
                .flatten()
                .zip(b.iter().flatten())
                .map(|(a, b)| a * b)
                .sum()
        };
        let asymmetry = (dot(&x, &cy) - dot(&y, &cx)).abs() / (N * self.cells) as f64;
        prop_assert!(asymmetry <= 1e-15 * scale, "asymmetry {:e}", asymmetry);
        self.check_bound(scale)?;
        self.check_inverse(&x)
    }

    fn check_bound(&self, scale: f64) -> Result<(), TestCaseError> {
        let bound = self
            .bodies
            .tensor_operator(self.directions)
            .unwrap()
            .lower_bound();
        if self.cells == 1 && self.bodies.boundary() == Boundary::Periodic {
            // The space of fields with zero mean is empty.
            prop_assert!(bound > 0.0);
            return Ok(());
        }
        let smallest = self.matrix.lower_bound();
        // The round-off of the matrix grows with its largest eigenvalue.
        prop_assert!(
            bound <= smallest + 1e-13 * scale,
            "{} above {}",
            bound,
            smallest
        );
        let has_wave = self.bodies.boundary() != Boundary::Periodic || self.cells > 1;
        // Strong coupling of auxetic bodies makes some periodic continuations indefinite.
        let is_definite = N == 1 || self.bodies.pair().dundurs_beta().abs() <= 0.5;
        prop_assert!(!has_wave || !is_definite || bound > 0.0);
        Ok(())
    }

    /// On a periodic grid the preconditioner equals the inverse to single precision.
    fn check_inverse(&self, x: &Vectors<N>) -> Result<(), TestCaseError> {
        if self.bodies.boundary() != Boundary::Periodic {
            return Ok(());
        }
        let inverse = self.bodies.tensor_preconditioner(self.directions).unwrap();
        let mut solved = x.each_ref().map(|x| vec![0.0; x.len()]);
        let fields = x.each_ref().map(|x| &x[..]);
        let out = solved.each_mut().map(|u| &mut u[..]);
        inverse.apply(fields, out, &mut inverse.scratch().unwrap());
        let [back, ..] = self.products(&solved);
        let magnitude = max_abs(&x.concat());
        let error = max_difference(&back.concat(), &x.concat()) / magnitude;
        prop_assert!(magnitude == 0.0 || error <= 1e-4, "inverse {:e}", error);
        Ok(())
    }
}

/// Generates grids that are small enough for three unknowns per cell.
fn small_grid() -> impl Strategy<Value = Grid> {
    let side = prop_oneof![Just(1_usize), 2..11_usize];
    (side.clone(), side, -9.0..3.0_f64, -1.0..1.0_f64).prop_map(|(nx, ny, size, aspect)| {
        let dx = 10_f64.powf(size);
        Grid::new(nx, ny, dx, dx * 10_f64.powf(aspect)).unwrap()
    })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(kit::thorough(14, 256)))]

    #[test]
    fn convolution_of_all_nine_components_equals_direct_sum(
        (grid, pair, boundary, seed) in (any_grid(), any_pair(), 0..3_usize, any::<u64>())
    ) {
        let boundary = kit::boundaries(grid)[boundary];
        let bodies = HalfSpace::with_boundary(grid, pair, boundary).unwrap();
        let mut random = kit::Random(seed);
        let mut traction: Vec<f64> = (0..grid.cells()).map(|_| random.uniform(-1.0, 1.0)).collect();
        // Rows without traction take a shorter code path.
        for row in traction.chunks_exact_mut(grid.nx()).step_by(3) {
            row.fill(0.0);
        }
        for component in Component::ALL {
            let fast = bodies.operator(component).unwrap();
            let dense = DenseOperator::of_half_space(&bodies, component).unwrap();
            let (mut u, mut expected) = (vec![0.0; grid.cells()], vec![0.0; grid.cells()]);
            fast.apply([&traction], [&mut u], &mut fast.scratch().unwrap());
            dense.apply([&traction], [&mut expected], &mut Scratch::none());
            // The error is relative to the product of row sum and traction, because the result itself may cancel.
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

    /// Checks products, symmetry, bound and inverse for one, two and three directions in any order.
    #[test]
    fn tensors_of_all_directions_satisfy_their_properties(
        (grid, pair, boundary, seed) in (small_grid(), any_pair(), 0..3_usize, any::<u64>())
    ) {
        let boundary = kit::boundaries(grid)[boundary];
        let bodies = HalfSpace::with_boundary(grid, pair, boundary).unwrap();
        for directions in [[X, Y, Z], [Z, X, Y]] {
            Tensor::new(&bodies, directions).check(seed)?;
        }
        for directions in [[X, Y], [X, Z], [Z, Y]] {
            Tensor::new(&bodies, directions).check(seed)?;
        }
        for direction in [X, Y, Z] {
            Tensor::new(&bodies, [direction]).check(seed)?;
        }
    }

    /// On a periodic grid the bound applies to fields of zero mean. If the eigenvalue of the mean is raised, the bound
    /// applies to all fields.
    #[test]
    fn smallest_periodic_eigenvalue_is_bounded((grid, pair) in (any_grid(), any_pair())) {
        let bodies = HalfSpace::with_boundary(grid, pair, Boundary::Periodic).unwrap();
        let cells = grid.cells();
        for component in [Component::XX, Component::YY, Component::ZZ] {
            let bound = bodies.operator(component).unwrap().lower_bound();
            prop_assert!(bound > 0.0);
            if cells == 1 {
                // The space of fields with zero mean is empty.
                continue;
            }
            let dense = DenseOperator::of_half_space(&bodies, component).unwrap();
            let own = dense.get(0, 0).unwrap();
            let entry = |n: usize| dense.get(n / cells, n % cells).unwrap() + own;
            let raised = DenseOperator::from_rows(cells, (0..cells * cells).map(entry).collect()).unwrap();
            // The raised mean has the largest eigenvalue, which determines the round-off.
            let round_off = 1e-13 * own * cells as f64;
            prop_assert!((bound - raised.lower_bound()).abs() <= round_off + 1e-9 * bound);
        }
    }

    /// The bound of the certificates is slightly smaller than the smallest eigenvalue.
    #[test]
    fn smallest_eigenvalue_is_bounded((grid, pair) in (any_grid(), any_pair())) {
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
fn convolution_on_larger_grid_equals_direct_sum() {
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
        fast.apply([&traction], [&mut u], &mut fast.scratch().unwrap());
        dense.apply([&traction], [&mut expected], &mut Scratch::none());
        let error = max_difference(&u, &expected) / max_abs(&expected);
        assert!(error <= 1e-13, "{component:?}: {error:e}");
    }
}
