//! The square of cells about one at the edge: places, powers of them, weights.

use crate::grid::Grid;

/// Cells on each side of the middle.
pub(super) const REACH: usize = 3;
/// Cells of the square.
pub(super) const CELLS: usize = (2 * REACH + 1) * (2 * REACH + 1);
/// The same rounded up to whole [`LANES`].
pub(super) const PLACES: usize = CELLS.div_ceil(LANES) * LANES;
/// Sums that run side by side.
const LANES: usize = 8;
/// Powers of a quadratic: 1, x, y, x^2, x y, y^2.
pub(super) const POWERS: usize = 6;
/// Products of two of them, up to the fourth degree.
pub(super) const PRODUCTS: usize = 15;

/// Width of the Gaussian that weighs the cells, in cells.
const WIDTH: f64 = 1.8;

/// Exponents of x and y of the products; those of the powers come first.
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

/// Which product the powers of a row and a column have.
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

/// Lengths are in units of the root of the area of a cell, of a line of cells in units of their side along it.
pub(super) struct Stencil {
    size: [usize; 2],
    repeats: [bool; 2],
    /// The unit (a length), and the sides of a cell in it.
    pub(super) unit: f64,
    pub(super) sides: [f64; 2],
    /// Of all places, which are zero beyond the cells.
    pub(super) products: [[f64; PLACES]; PRODUCTS],
    pub(super) weights: [f64; PLACES],
}

impl Stencil {
    pub(super) fn new(grid: Grid, repeats: [bool; 2]) -> Self {
        // Across a line of cells nothing changes, and any side will do.
        let (unit, sides) = match grid.size() {
            [_, 1] => (grid.dx(), [1.0; 2]),
            [1, _] => (grid.dy(), [1.0; 2]),
            _ => {
                let unit = grid.cell_area().sqrt();
                (unit, [grid.dx() / unit, grid.dy() / unit])
            }
        };
        let place = |k: usize| {
            let k = k.min(CELLS - 1);
            let steps = [k % (2 * REACH + 1), k / (2 * REACH + 1)];
            [0, 1].map(|axis| (steps[axis] as f64 - REACH as f64) * sides[axis])
        };
        Self {
            size: grid.size(),
            repeats,
            unit,
            sides,
            products: EXPONENTS.map(|exponents| {
                std::array::from_fn(|k| {
                    if k < CELLS {
                        power(place(k), exponents)
                    } else {
                        0.0
                    }
                })
            }),
            weights: std::array::from_fn(|k| {
                let [x, y] = place(k);
                let weight = (-0.5 * (x * x + y * y) / (WIDTH * WIDTH)).exp();
                if k < CELLS { weight } else { 0.0 }
            }),
        }
    }

    /// The cells of the square about one, by index; none beyond an edge of the grid.
    pub(super) fn cells(&self, about: usize) -> [Option<usize>; CELLS] {
        let [nx, ny] = self.size;
        let columns = self.along(0, about % nx, nx);
        let rows = self.along(1, about / nx, ny);
        std::array::from_fn(|k| {
            let (column, row) = (columns[k % (2 * REACH + 1)], rows[k / (2 * REACH + 1)]);
            column.zip(row).map(|(column, row)| row * nx + column)
        })
    }

    fn along(&self, axis: usize, place: usize, count: usize) -> [Option<usize>; 2 * REACH + 1] {
        std::array::from_fn(|step| {
            let place = place + step;
            if self.repeats[axis] {
                // As many periods more as make it positive.
                Some((place + REACH * count - REACH) % count)
            } else {
                place.checked_sub(REACH).filter(|place| *place < count)
            }
        })
    }
}

fn power([x, y]: [f64; 2], [i, j]: [usize; 2]) -> f64 {
    let of = |z: f64, exponent: usize| (0..exponent).fold(1.0, |product, _| product * z);
    of(x, i) * of(y, j)
}

/// The sum of products of two lists.
pub(super) fn dot(a: &[f64; PLACES], b: &[f64; PLACES]) -> f64 {
    let mut sums = [0.0; LANES];
    for (a, b) in a.chunks_exact(LANES).zip(b.chunks_exact(LANES)) {
        for (sum, (a, b)) in sums.iter_mut().zip(a.iter().zip(b)) {
            *sum += a * b;
        }
    }
    sums.iter().sum()
}
