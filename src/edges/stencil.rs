//! The square of cells around a cell at the edge: positions, their powers, and weights.

use std::array::from_fn;

use crate::grid::Grid;

/// Number of cells on each side of the middle.
const REACH: usize = 3;
/// Side of the square in cells.
pub(super) const SIDE: usize = 2 * REACH + 1;
/// Length of a padded row. The additional positions have zero weight and let sums over rows use vector registers.
pub(super) const LANES: usize = 8;
/// Values at all positions of the square, row by row.
pub(super) type Square<T> = [[T; LANES]; SIDE];
/// Number of terms of a quadratic: 1, x, y, x^2, x y, y^2.
pub(super) const POWERS: usize = 6;
/// Number of products of two terms, up to the fourth degree.
pub(super) const PRODUCTS: usize = 15;
/// Number of powers of x or of y in the products of two terms.
pub(super) const FOURTH: usize = 5;
/// Number of powers of x or of y up to the second degree.
pub(super) const SECOND: usize = 3;

/// Width of the Gaussian that weighs the cells, in cells.
const WIDTH: f64 = 1.8;

/// Exponents of x and y in the products. The terms of the quadratic come first.
const EXPONENTS: [[usize; 2]; PRODUCTS] = [
    [0, 0],
    [1, 0],
    [0, 1],
    [2, 0],
    [1, 1],
    [0, 2],
    [3, 0],
    [2, 1],
    [1, 2],
    [0, 3],
    [4, 0],
    [3, 1],
    [2, 2],
    [1, 3],
    [0, 4],
];

/// Index of the product of the terms of a row and a column.
pub(super) const PRODUCT_OF: [[usize; POWERS]; POWERS] = product_of();

const fn product_of() -> [[usize; POWERS]; POWERS] {
    let mut table = [[0; POWERS]; POWERS];
    let mut i = 0;
    while i < POWERS {
        let mut j = 0;
        while j < POWERS {
            let x = EXPONENTS[i][0] + EXPONENTS[j][0];
            let y = EXPONENTS[i][1] + EXPONENTS[j][1];
            let mut k = 0;
            while k < PRODUCTS {
                if EXPONENTS[k][0] == x && EXPONENTS[k][1] == y {
                    table[i][j] = k;
                }
                k += 1;
            }
            j += 1;
        }
        i += 1;
    }
    table
}

/// Square of cells around a cell. The unit of length is the square root of the cell area. On a line of cells the unit is the cell
/// side along the line.
pub(super) struct FitStencil {
    size: [usize; 2],
    repeats: [bool; 2],
    /// Unit of length, and the sides of a cell in this unit.
    pub(super) unit: f64,
    pub(super) sides: [f64; 2],
    /// Powers of x along a row for each exponent, and powers of y for each row.
    columns: [[f64; LANES]; FOURTH],
    rows: [[f64; FOURTH]; SIDE],
    pub(super) weights: Square<f64>,
}

impl FitStencil {
    pub(super) fn new(grid: Grid, repeats: [bool; 2]) -> Self {
        // The values do not vary perpendicular to a line of cells, so any side is valid in this direction.
        let (unit, sides) = match grid.size() {
            [_, 1] => (grid.dx(), [1.0; 2]),
            [1, _] => (grid.dy(), [1.0; 2]),
            _ => {
                let unit = grid.cell_area().sqrt();
                (unit, [grid.dx() / unit, grid.dy() / unit])
            }
        };
        let place = |axis: usize, step: usize| (step as f64 - REACH as f64) * sides[axis];
        let weight = |row: usize, column: usize| {
            let [x, y] = [place(0, column), place(1, row)];
            if column < SIDE {
                (-0.5 * (x * x + y * y) / (WIDTH * WIDTH)).exp()
            } else {
                0.0
            }
        };
        Self {
            size: grid.size(),
            repeats,
            unit,
            sides,
            columns: from_fn(|exponent| from_fn(|column| power(place(0, column), exponent))),
            rows: from_fn(|row| from_fn(|exponent| power(place(1, row), exponent))),
            weights: from_fn(|row| from_fn(|column| weight(row, column))),
        }
    }

    /// Returns the rows and the columns of the square around a cell, or `None` for rows and columns beyond an edge of the grid.
    pub(super) fn about(&self, cell: usize) -> [[Option<usize>; SIDE]; 2] {
        let [nx, ny] = self.size;
        [self.along(1, cell / nx, ny), self.along(0, cell % nx, nx)]
    }

    fn along(&self, axis: usize, place: usize, count: usize) -> [Option<usize>; SIDE] {
        from_fn(|step| {
            let place = place + step;
            if self.repeats[axis] {
                // Additional periods make the index positive.
                Some((place + REACH * count - REACH) % count)
            } else {
                place.checked_sub(REACH).filter(|place| *place < count)
            }
        })
    }

    /// Returns the sums of the values times the products, in their order, over the square. `POWERS_OF` is the number of
    /// powers of x and of y. The sums over the rows come first.
    pub(super) fn moments<const POWERS_OF: usize, const SUMS: usize>(
        &self,
        values: &Square<f64>,
    ) -> [f64; SUMS] {
        let mut sums = [[0.0; LANES]; POWERS_OF];
        for (values, powers) in values.iter().zip(&self.rows) {
            for (sums, power) in sums.iter_mut().zip(powers) {
                for (sum, value) in sums.iter_mut().zip(values) {
                    *sum += power * value;
                }
            }
        }
        from_fn(|k| {
            let [i, j] = EXPONENTS[k];
            total(from_fn(|lane| sums[j][lane] * self.columns[i][lane]))
        })
    }

    /// Evaluates a quadratic at all positions.
    pub(super) fn quadratic(&self, [c, cx, cy, cxx, cxy, cyy]: [f64; POWERS]) -> Square<f64> {
        let [_, columns, ..] = &self.columns;
        self.rows.map(|[_, y, yy, ..]| {
            let (constant, linear) = (c + cy * y + cyy * yy, cx + cxy * y);
            columns.map(|x| constant + x * (linear + cxx * x))
        })
    }
}

fn power(place: f64, exponent: usize) -> f64 {
    (0..exponent).fold(1.0, |product, _| product * place)
}

/// Returns the products at all positions.
pub(super) fn product(a: &Square<f64>, b: &Square<f64>) -> Square<f64> {
    let mut products = *a;
    for (products, b) in products.iter_mut().zip(b) {
        for (product, b) in products.iter_mut().zip(b) {
            *product *= b;
        }
    }
    products
}

/// Returns the sum of the products of two squares.
pub(super) fn dot(a: &Square<f64>, b: &Square<f64>) -> f64 {
    let mut sums = [0.0; LANES];
    for products in product(a, b) {
        for (sum, product) in sums.iter_mut().zip(products) {
            *sum += product;
        }
    }
    total(sums)
}

/// Returns the sum of a row by pairwise summation.
fn total([a, b, c, d, e, f, g, h]: [f64; LANES]) -> f64 {
    ((a + e) + (c + g)) + ((b + f) + (d + h))
}
