//! Operators of coated bodies on every type of grid are positive definite. They equal sums over images and direct sums.

use kit::{Random, max_abs, max_difference};
#[cfg(feature = "dense")]
use stickslip::dense::DenseOperator;
use stickslip::influence::Direction::{X, Y, Z};
use stickslip::influence::{Component, Rectangle};
use stickslip::{
    Boundary, CellValue, EigenvalueBound, ElasticPair, Field, Grid, HalfSpace, Material,
    NormalLoad, NormalProblem, Operator, Scratch,
};

use super::{against_rigid, layer, parse_body};

/// The symbol is positive for pressure, traction and coupled problems, on cells that are small or large compared with
/// the layer.
#[test]
fn symbol_is_positive() {
    for m in [1e-3, 0.1, 10.0, 1e3] {
        for nu in [0.0, 0.5] {
            let base = Material::from_shear_modulus(1.0, 0.3).unwrap();
            let body = base.coated(&[layer(m, nu, 1.0)]).unwrap();
            for sides in [[0.02, 0.02], [0.2, 0.5], [2.0, 1.0], [10.0, 10.0]] {
                let grid = Grid::new(24, 20, sides[0], sides[1]).unwrap();
                let boundary = Boundary::Periodic;
                let bodies = HalfSpace::with_boundary(grid, against_rigid(body), boundary).unwrap();
                let bounds = [
                    bodies.tensor_operator([Z]).unwrap().lower_bound(),
                    bodies.tensor_operator([X, Y]).unwrap().lower_bound(),
                    bodies.tensor_operator([Z, X, Y]).unwrap().lower_bound(),
                ];
                assert!(
                    bounds.iter().all(|bound| *bound > 0.0),
                    "{m} {nu} {sides:?}"
                );
            }
        }
    }
}

/// If the rows of a grid that is periodic along y have equal loads, they agree with a line of cells. Sums over the
/// images of the rows agree with a free grid of many periods.
#[test]
fn periodic_rows_sum_their_images() {
    let body = parse_body("4/0.3/0.4;0.5/0.45/0.2", "1/0.2");
    let boundary = Boundary::PeriodicAlongY { datum: 20.0 };
    for [dx, dy] in [[0.3, 0.2], [0.3, 2.0]] {
        let rows = Grid::new(10, 6, dx, dy).unwrap();
        let line = Grid::new(10, 1, dx, 6.0 * dy).unwrap();
        let [rows, line] = [rows, line]
            .map(|grid| HalfSpace::with_boundary(grid, against_rigid(body), boundary).unwrap());
        let moved =
            |bodies: &HalfSpace, component: Component, loaded: &dyn Fn(usize, usize) -> f64| {
                let field = Field::from_indices(bodies.grid(), loaded);
                let operator = bodies.operator(component).unwrap();
                let mut out = Field::zeros(bodies.grid());
                operator.apply(
                    [field.as_slice()],
                    [out.as_mut_slice()],
                    &mut operator.scratch().unwrap(),
                );
                out
            };
        let loaded = |ix: usize, _: usize| ((3 * ix) % 5) as f64;
        for component in [Component::ZZ, Component::XX, Component::YY, Component::ZX] {
            let (of_rows, of_line) = (
                moved(&rows, component, &loaded),
                moved(&line, component, &loaded),
            );
            let unit = max_abs(of_line.as_slice());
            for iy in 0..6 {
                for ix in 0..10 {
                    let difference = of_rows.get(ix, iy).unwrap() - of_line.get(ix, 0).unwrap();
                    assert!(
                        difference.abs() < 1e-11 * unit,
                        "{component:?} {dx} {dy}: {difference:e}"
                    );
                }
            }
        }
        // The load on the rows alternates and has no uniform part. The displacements are compared with the
        // displacements on 41 periods of a free grid.
        let many = Grid::new(10, 6 * 41, dx, dy).unwrap();
        let many = HalfSpace::new(many, against_rigid(body)).unwrap();
        for component in [Component::ZZ, Component::XY, Component::ZY] {
            let alternating = |ix: usize, iy: usize| {
                if ix == 4 {
                    [1.0, -2.0, 0.5, 1.5, -1.5, 0.5][iy % 6]
                } else {
                    0.0
                }
            };
            let (of_rows, of_many) = (
                moved(&rows, component, &alternating),
                moved(&many, component, &alternating),
            );
            let unit = max_abs(of_rows.as_slice());
            for iy in 0..6 {
                for ix in 0..10 {
                    let difference =
                        of_rows.get(ix, iy).unwrap() - of_many.get(ix, 120 + iy).unwrap();
                    assert!(
                        difference.abs() < 1e-3 * unit,
                        "{component:?} {dx} {dy}: {difference:e}"
                    );
                }
            }
        }
    }
}

/// If the periodic continuation of a free grid gives no bound, the infinite lattice of its cells gives a bound. This
/// bound is below the smallest eigenvalue of the matrix.
#[cfg(feature = "dense")]
#[test]
fn stiff_coating_on_long_grid_has_an_eigenvalue_bound() {
    let base = Material::from_shear_modulus(1.0, 0.3).unwrap();
    let mut estimated = 0;
    for (m, nu, sides) in [
        (10.0, 0.5, [2.0, 1.0]),
        (1e3, 0.3, [2.0, 2.0]),
        (1e3, 0.3, [0.25, 0.25]),
        (100.0, 0.45, [3.0, 1.0]),
    ] {
        let body = base.coated(&[layer(m, nu, 1.0)]).unwrap();
        let [nx, ny] = kit::thorough([8, 7], [24, 20]);
        let grid = Grid::new(nx, ny, sides[0], sides[1]).unwrap();
        for cell_value in [CellValue::Uniform, CellValue::Centre] {
            let bodies = HalfSpace::new(grid, against_rigid(body)).unwrap();
            let bodies = bodies.with_cell_value(cell_value).unwrap();
            for direction in [Z, X, Y] {
                let component = Component::of(direction, direction);
                let least = DenseOperator::of_half_space(&bodies, component)
                    .unwrap()
                    .lower_bound();
                let bound = bodies.tensor_operator([direction]).unwrap().lower_bound();
                assert!(bound <= least && bound > 0.0);
            }
            if cell_value == CellValue::Centre {
                continue;
            }
            let parts = [X, Y].map(|u| {
                [X, Y].map(|t| DenseOperator::of_half_space(&bodies, Component::of(u, t)).unwrap())
            });
            let (cells, len) = (grid.cells(), 2 * grid.cells());
            let entry = |k: usize| {
                let (row, column) = (k / len, k % len);
                let part = &parts[row / cells][column / cells];
                part.get(row % cells, column % cells).unwrap()
            };
            let matrix =
                DenseOperator::from_rows(len, (0..len * len).map(entry).collect()).unwrap();
            let least = matrix.lower_bound();
            let bound = bodies.tensor_operator([X, Y]).unwrap().lower_bound();
            assert!(bound <= least && bound > 0.0);
            bodies.tensor_preconditioner([X, Y]).unwrap();
            // A certificate that rests on an estimate is marked as estimated.
            let known = bodies.tensor_operator([Z]).unwrap().eigenvalue_bound();
            let load = NormalLoad::Approach(0.05);
            let contact = NormalProblem::builder(&bodies, kit::sphere(grid, 50.0), load).build();
            let contact = contact.unwrap().solve().unwrap();
            assert_eq!(contact.report().eigenvalue_bound, known);
            let is_estimated = known == EigenvalueBound::Estimated;
            let line = contact.report().to_string();
            assert_eq!(line.contains("by an estimate"), is_estimated);
            estimated += usize::from(is_estimated);
        }
    }
    assert!(estimated > 0);
}

/// Covers the coupled tensor of pressure and traction on a free grid, as a matrix.
#[cfg(feature = "dense")]
#[test]
fn coupled_tensor_is_positive_definite() {
    for (m, nu, side) in [
        (1e-3, 0.5, 2.0),
        (0.1, 0.0, 0.02),
        (10.0, 0.0, 0.3),
        (1e3, 0.3, 10.0),
    ] {
        let below = Material::from_shear_modulus(1.0, 0.3).unwrap();
        let body = below.coated(&[layer(m, nu, 1.0)]).unwrap();
        let grid = Grid::new(8, 6, side, 1.5 * side).unwrap();
        let bodies = HalfSpace::new(grid, against_rigid(body)).unwrap();
        let parts = [X, Y, Z].map(|u| {
            [X, Y, Z].map(|t| DenseOperator::of_half_space(&bodies, Component::of(u, t)).unwrap())
        });
        let (cells, len) = (grid.cells(), 3 * grid.cells());
        let entry = |k: usize| {
            let (row, column) = (k / len, k % len);
            let part = &parts[row / cells][column / cells];
            part.get(row % cells, column % cells).unwrap()
        };
        let matrix = DenseOperator::from_rows(len, (0..len * len).map(entry).collect()).unwrap();
        assert!(matrix.lower_bound() > 0.0, "{m} {nu} {side}");
    }
}

#[cfg(feature = "dense")]
#[test]
fn fast_product_equals_direct_sum() {
    let one = parse_body("2/0.3/0.5;0.5/0.45/0.2", "1/0.2");
    let two = parse_body("0.3/0.4/1.5", "rigid");
    let pair = ElasticPair::new(one, two).unwrap();
    let line = Boundary::PeriodicAlongY { datum: 50.0 };
    for (nx, ny, boundary) in [
        (11, 8, Boundary::NonPeriodic),
        (7, 10, Boundary::Periodic),
        (31, 1, line),
    ] {
        for value in [CellValue::Uniform, CellValue::Centre] {
            let grid = Grid::new(nx, ny, 0.3, 0.2).unwrap();
            let bodies = HalfSpace::with_boundary(grid, pair, boundary).unwrap();
            let bodies = bodies.with_cell_value(value).unwrap();
            let mut random = Random(7);
            let traction: Vec<f64> = (0..nx * ny).map(|_| random.uniform(-1.0, 1.0)).collect();
            for component in Component::ALL {
                let slow = DenseOperator::of_half_space(&bodies, component).unwrap();
                let fast = bodies.operator(component).unwrap();
                let (mut a, mut b) = (vec![0.0; nx * ny], vec![0.0; nx * ny]);
                slow.apply([&traction], [&mut a], &mut Scratch::none());
                fast.apply([&traction], [&mut b], &mut fast.scratch().unwrap());
                let unit = max_abs(&a).max(0.1);
                assert!(
                    max_difference(&a, &b) < 1e-13 * unit,
                    "{component:?} {boundary:?}"
                );
            }
        }
    }
}

/// The displacements of a line of cells agree with the displacements at the middle of a long row of cells. Far from the
/// load they agree with the displacements of the substrate with its datum.
#[test]
fn line_matches_plane_strain() {
    let body = Material::from_shear_modulus(1.0, 0.2).unwrap();
    let coated = body.coated(&[layer(4.0, 0.4, 0.5)]).unwrap();
    let datum = 4e4;
    let operators = |body: Material, dy: f64| {
        let grid = Grid::new(20_000, 1, 0.5, dy).unwrap();
        let boundary = Boundary::PeriodicAlongY { datum };
        HalfSpace::with_boundary(grid, against_rigid(body), boundary).unwrap()
    };
    let (layered, plain) = (operators(coated, 1.0), operators(body, 1.0));
    let all = [Component::ZZ, Component::ZX, Component::XX, Component::YY];
    for &component in &all[..kit::thorough(2, 4)] {
        let moved = |bodies: &HalfSpace| {
            let operator = bodies.operator(component).unwrap();
            let mut load = vec![0.0; 20_000];
            load[0] = 1.0;
            let mut u = vec![0.0; 20_000];
            operator.apply([&load], [&mut u], &mut operator.scratch().unwrap());
            u
        };
        let (layered, plain) = (moved(&layered), moved(&plain));
        assert!(
            (layered[19_999] - plain[19_999]).abs() < 1e-4,
            "{component:?}"
        );
        // The reference is a cell that is long compared with the distances. The contribution of its ends is the same at
        // all distances and cancels in the difference.
        let cell = Rectangle::new(0.25, 4e6).unwrap();
        let of = |x: f64| {
            let all = cell.tensor(&coated, x, 0.0);
            match component {
                Component::XX => all.xx,
                Component::YY => all.yy,
                Component::ZZ => all.zz,
                _ => all.zx,
            }
        };
        for i in [1_usize, 2, 7] {
            let [near, own] = [i, 0].map(|i| of(0.5 * i as f64));
            let difference = (layered[i] - layered[0]) - (near - own);
            assert!(difference.abs() < 1e-6, "{component:?} {i}: {difference:e}");
        }
    }
}
