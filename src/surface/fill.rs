//! Filling of holes in a measured surface.

use crate::error::{Error, Result, not_converged};
use crate::grid::Grid;
use crate::grid::field::Field;
use crate::parallel::layout::Layout;
use crate::parallel::reduce;
use crate::surface::heights::finite_or_missing;

/// Reduction of the error in the energy norm at which the iteration ends.
const TOLERANCE: f64 = 1e-15;

/// Number of iterations allowed in addition to one per missing height.
const LEAST_LIMIT: usize = 100;

/// Height above which differences might overflow.
const TALL: f64 = 1e300;

/// Fraction of the fill-in that the factorisation moves to the diagonal.
const MODIFIED: f64 = 0.97;

/// A surface without holes.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Filled {
    heights: Field,
    cells: usize,
}

impl Filled {
    /// Returns the heights (lengths) without missing values. The known heights are unchanged.
    #[must_use]
    pub fn heights(&self) -> &Field {
        &self.heights
    }

    /// Returns the number of heights that were missing.
    #[must_use]
    pub fn filled_cells(&self) -> usize {
        self.cells
    }

    /// Returns the heights without the count.
    #[must_use]
    pub fn into_heights(self) -> Field {
        self.heights
    }
}

/// Fills missing heights (NaN) by harmonic interpolation, with the smoothest surface through the rim of each hole.
///
/// The filled heights solve the five-point Laplace equation with the known heights around them as boundary values,
///
/// ```math
/// \frac{z_{i+1,j} - 2 z_{ij} + z_{i-1,j}}{\Delta x^2} + \frac{z_{i,j+1} - 2 z_{ij} + z_{i,j-1}}{\Delta y^2} = 0 ,
/// ```
///
/// The filled heights therefore lie between the lowest and the highest height of the rim. A hole in a plane is filled
/// with the same plane. At the edge of the grid the slope normal to the edge is zero. A tilted surface should therefore
/// be levelled before holes at the edge are filled.
///
/// The solver is the conjugate gradient method with a modified incomplete factorisation (Gustafsson 1978). The initial
/// guess is the mean height. The iteration ends when the error, in the norm of the mean-square slope, has fallen to
/// 1e-15 of its initial value. In a plane with holes of up to 1000 cells across, the error of the filled heights is
/// then 1e-14 of the range of the plane. If the sides of the cells differ, the round-off is multiplied by the square of
/// their ratio.
///
/// # Errors
/// - [`Error::Sample`] with the first infinite height.
/// - [`Error::Undetermined`] if all heights are missing.
/// - [`Error::NotConverged`] if the cells are so slender that round-off hides the coupling along one axis.
///
/// # References
/// - I. Gustafsson, *BIT* 18 (1978) 142-156,
///   [doi:10.1007/BF01931691](https://doi.org/10.1007/BF01931691).
///
/// ```
/// use stickslip::{Field, Grid, surface};
/// let plane = Field::from_fn(Grid::new(6, 5, 1.0, 2.0)?, |x, y| 1.0 + 0.3 * x - 0.2 * y);
/// let mut measured = plane.clone();
/// for cell in [8, 9, 14, 15] {
///     measured.as_mut_slice()[cell] = f64::NAN;
/// }
/// let filled = surface::fill_missing(&measured)?;
/// assert_eq!(filled.filled_cells(), 4);
/// let pairs = filled.heights().as_slice().iter().zip(plane.as_slice());
/// assert!(pairs.into_iter().all(|(a, b)| (a - b).abs() < 1e-14));
/// # Ok::<(), stickslip::Error>(())
/// ```
pub fn fill_missing(heights: &Field) -> Result<Filled> {
    finite_or_missing(heights)?;
    let holes = Holes::of(heights);
    let cells = holes.unknowns.len();
    let known = heights.grid().cells() - cells;
    if known == 0 {
        return Err(Error::Undetermined {
            quantity: "surface",
            unknowns: cells,
            known,
        });
    }
    let mut heights = heights.clone();
    let z = heights.as_mut_slice();
    // Heights near the largest floating-point number are scaled down, because their differences would overflow.
    let tall = z.iter().any(|z| z.abs() > TALL);
    let down = if tall { 1.0 / 1024.0 } else { 1.0 };
    let known_heights = || z.iter().filter(|z| !z.is_nan()).map(|z| z * down);
    let mean = known_heights().map(|z| z / known as f64).sum::<f64>();
    // Squares of heights in units of the largest deviation neither overflow nor underflow.
    let largest = known_heights().fold(0.0, |unit: f64, z| unit.max((z - mean).abs()));
    let unit = if largest > 0.0 { largest } else { 1.0 };
    let pull = holes.pull_of_known(z, |z| (z * down - mean) / unit);
    let solution = holes.solve(pull)?;
    for (unknown, value) in holes.unknowns.iter().zip(solution) {
        z[unknown.cell] = (mean + unit * value) / down;
    }
    Ok(Filled { heights, cells })
}

/// Discrete Laplace equation in the holes, `K z = b`. The matrix is symmetric, positive definite and diagonally
/// dominant.
struct Holes {
    grid: Grid,
    /// Unknowns in the order of their cells.
    unknowns: Vec<Unknown>,
    /// Weights of neighbours along x and along y.
    weights: [f64; 2],
}

/// A missing height.
struct Unknown {
    cell: usize,
    /// Indices of the left and the lower neighbour, if their heights are unknown.
    lower: [Option<usize>; 2],
    /// Indices of the right and the upper neighbour, if their heights are unknown.
    upper: [Option<usize>; 2],
    /// Sum of the weights of all neighbours on the grid.
    diagonal: f64,
}

impl Holes {
    fn of(heights: &Field) -> Self {
        let grid = heights.grid();
        let z = heights.as_slice();
        let aspect = grid.dy() / grid.dx();
        // The weights are 1/dx^2 and 1/dy^2, divided by their sum.
        let weights = [1.0 / (1.0 + aspect.powi(-2)), 1.0 / (1.0 + aspect.powi(2))];
        let cells: Vec<usize> = (0..z.len()).filter(|&cell| z[cell].is_nan()).collect();
        let number = |cell: Option<usize>| cell.and_then(|cell| cells.binary_search(&cell).ok());
        let unknowns = cells
            .iter()
            .map(|&cell| {
                let [below, above] = neighbours(grid, cell);
                let count = |axis: usize| {
                    usize::from(below[axis].is_some()) + usize::from(above[axis].is_some())
                };
                Unknown {
                    cell,
                    lower: below.map(number),
                    upper: above.map(number),
                    diagonal: weights[0] * count(0) as f64 + weights[1] * count(1) as f64,
                }
            })
            .collect();
        Self {
            grid,
            unknowns,
            weights,
        }
    }

    /// Computes the right-hand side `b`: the weight of each known neighbour times its height, in units above a datum.
    fn pull_of_known(&self, z: &[f64], in_units: impl Fn(f64) -> f64) -> Vec<f64> {
        let pull = |unknown: &Unknown| {
            let [below, above] = neighbours(self.grid, unknown.cell);
            let pull = |axis: usize| {
                let cells = [below[axis], above[axis]].into_iter().flatten();
                let known = cells.map(|cell| z[cell]).filter(|z| !z.is_nan());
                self.weights[axis] * known.map(&in_units).sum::<f64>()
            };
            pull(0) + pull(1)
        };
        self.unknowns.iter().map(pull).collect()
    }

    /// Computes the weighted sum of the linked unknowns.
    fn linked(&self, links: [Option<usize>; 2], values: &[f64]) -> f64 {
        let at = |axis: usize| links[axis].map_or(0.0, |k| self.weights[axis] * values[k]);
        at(0) + at(1)
    }

    /// Computes `K z`.
    fn product(&self, z: &[f64], product: &mut [f64]) {
        for (k, unknown) in self.unknowns.iter().enumerate() {
            product[k] = unknown.diagonal * z[k]
                - self.linked(unknown.lower, z)
                - self.linked(unknown.upper, z);
        }
    }

    /// Computes `D` of the incomplete factorisation `K = (D - L) D^-1 (D - L')`. `L` contains the weights below the
    /// diagonal.
    fn pivots(&self) -> Vec<f64> {
        let mut pivots = Vec::<f64>::with_capacity(self.unknowns.len());
        for unknown in &self.unknowns {
            let mut pivot = unknown.diagonal;
            for axis in 0..2 {
                if let Some(lower) = unknown.lower[axis] {
                    let other = 1 - axis;
                    let is_filled_in = self.unknowns[lower].upper[other].is_some();
                    let fill_in = if is_filled_in {
                        self.weights[other]
                    } else {
                        0.0
                    };
                    let weight = self.weights[axis];
                    pivot -= weight * (weight + MODIFIED * fill_in) / pivots[lower];
                }
            }
            pivots.push(pivot);
        }
        pivots
    }

    /// Applies the preconditioner, `z = (D - L')^-1 D (D - L)^-1 r`.
    fn precondition(&self, pivots: &[f64], residual: &[f64], z: &mut [f64]) {
        for (k, unknown) in self.unknowns.iter().enumerate() {
            z[k] = (residual[k] + self.linked(unknown.lower, z)) / pivots[k];
        }
        for (k, unknown) in self.unknowns.iter().enumerate().rev() {
            z[k] += self.linked(unknown.upper, z) / pivots[k];
        }
    }

    /// Solves `K z = b` by preconditioned conjugate gradients.
    fn solve(&self, b: Vec<f64>) -> Result<Vec<f64>> {
        let pivots = self.pivots();
        let mut z = vec![0.0; b.len()];
        let mut image = z.clone();
        let mut preconditioned = z.clone();
        let mut residual = b;
        self.precondition(&pivots, &residual, &mut preconditioned);
        let mut direction = preconditioned.clone();
        let start = dot(&residual, &preconditioned);
        let mut energy = start;
        let limit = LEAST_LIMIT + z.len();
        for _ in 0..limit {
            if energy <= TOLERANCE * TOLERANCE * start {
                return Ok(z);
            }
            self.product(&direction, &mut image);
            let step = energy / dot(&direction, &image);
            add(&mut z, step, &direction);
            add(&mut residual, -step, &image);
            self.precondition(&pivots, &residual, &mut preconditioned);
            let before = energy;
            energy = dot(&residual, &preconditioned);
            let theta = energy / before;
            for (t, z) in direction.iter_mut().zip(&preconditioned) {
                *t = z + theta * *t;
            }
        }
        Err(not_converged(limit, (energy / start).sqrt()))
    }
}

/// Returns the neighbours on the grid, `[[left, below], [right, above]]`.
fn neighbours(grid: Grid, cell: usize) -> [[Option<usize>; 2]; 2] {
    let nx = grid.nx();
    let ix = cell % nx;
    [
        [(ix > 0).then(|| cell - 1), cell.checked_sub(nx)],
        [
            (ix + 1 < nx).then(|| cell + 1),
            (cell + nx < grid.cells()).then(|| cell + nx),
        ],
    ]
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    reduce::sum(&Layout::flat(a.len()), |k| a[k] * b[k])
}

/// Computes `y += a x`.
fn add(y: &mut [f64], a: f64, x: &[f64]) {
    for (y, x) in y.iter_mut().zip(x) {
        *y += a * x;
    }
}
