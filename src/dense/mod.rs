//! Dense reference implementation: operators as explicit matrices, and exact solutions of small problems.
//!
//! [`DenseOperator`] computes the same products as [`Convolution`](crate::fft::Convolution), in `n^2` operations and
//! without a transform. [`DenseOperator::minimise`] computes the solutions that [`crate::cgm`] approximates, by
//! Cholesky factorisation on active sets. Both are references for tests of the fast methods. They solve problems of a
//! few hundred cells without a tolerance.

mod active_set;
mod wave_sum;

pub use active_set::DenseMinimum;

use std::sync::OnceLock;

use faer::{MatRef, Side};

use crate::bodies::component::Component;
use crate::error::{Error, Result, all_finite, length};
use crate::grid::boundary::Boundary;
use crate::grid::field::Field;
use crate::half_space::HalfSpace;
use crate::influence::{KernelCorrection, Samples};
use crate::operator::{Operator, Scratch};
use crate::report::EigenvalueBound;
use crate::support::debug::shown;

/// Largest accepted number of unknowns, which corresponds to a matrix of 128 MiB.
const LIMIT: usize = 4096;

/// Allowed difference of mirrored entries of a symmetric matrix, divided by the largest entry. It admits the round-off of the
/// compliance matrix of a finite-element code, like the check of reciprocity of user-defined operators.
const ASYMMETRY: f64 = 1e-9;
/// Allowed difference for the direct solution, which uses only half of the matrix.
const DIRECT_ASYMMETRY: f64 = 1e-13;

/// Square matrix as an [`Operator`].
///
/// ```
/// use stickslip::dense::DenseOperator;
/// use stickslip::{ElasticPair, Grid, HalfSpace, Material, Operator, influence::Component};
/// let grid = Grid::new(5, 3, 1.0, 1.0)?;
/// let bodies = HalfSpace::new(grid, ElasticPair::new(Material::new(1.0, 0.3)?, Material::rigid())?)?;
/// let twin = DenseOperator::of_half_space(&bodies, Component::ZZ)?;
/// let fast = bodies.operator(Component::ZZ)?;
/// let traction: Vec<f64> = (0..15).map(f64::from).collect();
/// let (mut slow_u, mut fast_u) = (vec![0.0; 15], vec![0.0; 15]);
/// twin.apply([&traction], [&mut slow_u], &mut twin.scratch()?);
/// fast.apply([&traction], [&mut fast_u], &mut fast.scratch()?);
/// assert!(slow_u.iter().zip(&fast_u).all(|(a, b)| (a - b).abs() < 1e-12));
/// # Ok::<(), stickslip::Error>(())
/// ```
#[derive(Clone)]
pub struct DenseOperator {
    len: usize,
    /// Entries of the matrix, row-major.
    entries: Vec<f64>,
    lower_bound: OnceLock<f64>,
    is_symmetric: OnceLock<bool>,
}

shown!(DenseOperator: len);

impl DenseOperator {
    /// Creates a matrix of `len` x `len` entries, row-major.
    ///
    /// # Errors
    /// - [`Error::TooManyCells`] above 4096 unknowns.
    /// - [`Error::Length`] if the number of entries is not `len * len`.
    /// - [`Error::Sample`] if an entry is not finite.
    pub fn from_rows(len: usize, entries: Vec<f64>) -> Result<Self> {
        check_size(len)?;
        length("matrix", len * len, entries.len())?;
        all_finite("matrix", &entries)?;
        Ok(Self {
            len,
            entries,
            lower_bound: OnceLock::new(),
            is_symmetric: OnceLock::new(),
        })
    }

    /// Creates the matrix of influence coefficients of one component between all cells of a half-space (lengths over
    /// pressures). The matrix of a periodic grid maps constants to zero. [`minimise`](Self::minimise) therefore
    /// requires that a positive constant is added to every entry. The constant does not change solutions with a
    /// prescribed total.
    ///
    /// # Errors
    /// - [`Error::TooManyCells`] above 4096 cells.
    /// - [`Error::UnsupportedForCoatings`] for user-defined operators.
    /// - The errors of [`HalfSpace::operator`].
    /// - [`Error::Ranks`] if the bodies are distributed over ranks.
    pub fn of_half_space(bodies: &HalfSpace, component: Component) -> Result<Self> {
        bodies.check_alone("a dense matrix")?;
        bodies.kernel().check_no_operators("a dense matrix")?;
        let grid = bodies.grid();
        check_size(grid.cells())?;
        let [odd_x, odd_y] = component.is_odd();
        let added = || KernelCorrection::of(bodies.kernel());
        let coefficients = match bodies.boundary() {
            Boundary::NonPeriodic => {
                let samples = Samples::new(grid, grid.size())?
                    .of(bodies.cell_value())
                    .coated(added());
                let table = samples.table(grid, bodies.pair(), component)?;
                Field::from_indices(grid, |i, j| table.at(i, j))
            }
            Boundary::PeriodicAlongY { datum } => {
                let samples = Samples::repeating_along_y(grid, grid.size(), datum)?;
                let samples = samples.of(bodies.cell_value()).coated(added());
                let table = samples.table(grid, bodies.pair(), component)?;
                Field::from_indices(grid, |i, j| match grid.ny() - j {
                    back if back < j && odd_y => -table.at(i, back),
                    back => table.at(i, j.min(back)),
                })
            }
            Boundary::Periodic => wave_sum::coefficients(grid, bodies.kernel(), component),
        };
        let (nx, cells) = (grid.nx(), grid.cells());
        let entry = |field: usize, source: usize| {
            let ((i, k), (j, l)) = ((field % nx, source % nx), (field / nx, source / nx));
            let value = coefficients.as_slice()[j.abs_diff(l) * nx + i.abs_diff(k)];
            if (odd_x && i < k) == (odd_y && j < l) {
                value
            } else {
                -value
            }
        };
        let entries = (0..cells * cells)
            .map(|n| entry(n / cells, n % cells))
            .collect();
        Self::from_rows(cells, entries)
    }

    /// Returns the entry of a row and a column, or `None` outside the matrix.
    #[must_use]
    pub fn get(&self, row: usize, column: usize) -> Option<f64> {
        (row < self.len && column < self.len).then(|| self.row(row)[column])
    }

    fn row(&self, row: usize) -> &[f64] {
        &self.entries[row * self.len..(row + 1) * self.len]
    }

    /// Returns the first row in which mirrored entries differ by more than `tolerance` times the largest entry.
    fn first_asymmetric_row(&self, tolerance: f64) -> Option<usize> {
        let limit = tolerance * self.entries.iter().fold(0.0, |a: f64, b| a.max(b.abs()));
        let differ = |i: usize, j: usize| (self.row(i)[j] - self.row(j)[i]).abs() > limit;
        (0..self.len).find(|&i| (0..i).any(|j| differ(i, j)))
    }

    /// Returns the smallest eigenvalue minus round-off, or zero if the matrix is not symmetric positive definite.
    fn smallest_eigenvalue(&self) -> f64 {
        if self.first_asymmetric_row(DIRECT_ASYMMETRY).is_some() {
            return 0.0;
        }
        let matrix = MatRef::from_row_major_slice(&self.entries, self.len, self.len);
        match matrix.self_adjoint_eigenvalues(Side::Lower) {
            Ok(values) => {
                let largest = values.last().copied().unwrap_or(0.0);
                let smallest = values.first().copied().unwrap_or(0.0);
                (smallest - 1e-14 * largest).max(0.0)
            }
            Err(_) => 0.0,
        }
    }
}

fn check_size(cells: usize) -> Result<()> {
    if cells > LIMIT {
        Err(Error::TooManyCells {
            cells,
            limit: LIMIT,
        })
    } else {
        Ok(())
    }
}

impl Operator for DenseOperator {
    fn cells(&self) -> usize {
        self.len
    }

    fn apply(&self, [x]: [&[f64]; 1], [out]: [&mut [f64]; 1], _: &mut Scratch) {
        for (row, out) in out.iter_mut().enumerate() {
            *out = self.row(row).iter().zip(x).map(|(c, x)| c * x).sum();
        }
    }

    /// Returns the smallest eigenvalue, or zero if the matrix is not symmetric positive definite. The value is
    /// computed at the first call.
    fn lower_bound(&self) -> f64 {
        *self.lower_bound.get_or_init(|| self.smallest_eigenvalue())
    }

    fn eigenvalue_bound(&self) -> EigenvalueBound {
        if self.lower_bound() > 0.0 {
            EigenvalueBound::Proven
        } else {
            EigenvalueBound::Unknown
        }
    }

    /// Returns whether mirrored entries differ by at most 1e-9 of the largest entry. The value is computed at the first call.
    fn is_symmetric(&self) -> bool {
        *(self.is_symmetric).get_or_init(|| self.first_asymmetric_row(ASYMMETRY).is_none())
    }
}
