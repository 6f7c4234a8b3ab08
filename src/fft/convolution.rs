//! The half-space as an operator: convolution with influence coefficients, zero-padded or periodic along each axis.

use std::sync::Arc;

use crate::bodies::component::Component;
use crate::bodies::kernel;
use crate::bodies::material::ElasticPair;
use crate::error::Result;
use crate::fft::length::torus;
use crate::fft::plan::{Plan, TaskScratch};
use crate::fft::single_precision::SingleProduct;
use crate::fft::symbol::Symbol;
use crate::fft::tiles::Tiles;
use crate::fft::torus::TorusLayout;
use crate::fft::uniform_wave::UniformWave;
use crate::grid::Grid;
use crate::grid::boundary::Boundary;
use crate::grid::cell_value::CellValue;
use crate::influence::{InfluenceKernel, KernelCorrection, Samples, Symbols};
use crate::memory::fallible::unwrap_or_abort;
use crate::operator::{LowerBound, MeanBound, Operator, SELF_COMPLIANCE, Scratch};
use crate::parallel;
use crate::parallel::layout::Layout;
use crate::parallel::ranks::RankGroup;
use crate::parallel::ranks::partition::RowPartition;
use crate::report::EigenvalueBound;
use crate::support::debug::shown;

/// Operator `u_i = sum_j C_ij * t_j` on a grid. It computes N displacement components of every cell from N traction components of
/// all cells. A product takes one forward and one inverse fast transform per component.
///
/// The operator has no periodic images ([`Self::new`]) or is periodic along both axes ([`Self::periodic`]). For grids that are
/// periodic along y alone use [`HalfSpace::operator`](crate::HalfSpace::operator). For several components use
/// [`HalfSpace::tensor_operator`](crate::HalfSpace::tensor_operator).
///
/// Tractions are pressures, displacements are lengths. The result equals the direct sum up to round-off (typically 1e-15 of
/// the largest displacement). The operator is immutable, so threads can share it. Each thread needs its own workspace.
///
/// # Memory
///
/// The operator takes 12 bytes per cell for each of the N (N + 1)/2 coefficients. Each workspace takes 16 N bytes per cell. If
/// the grid is periodic along y alone, each coefficient takes 6 bytes instead of 12. If it is periodic along both axes, each
/// coefficient takes 3 bytes and each workspace 8 N bytes.
///
/// ```
/// use stickslip::{ElasticPair, Grid, Material, Operator, fft::Convolution, influence::Component};
/// let steel = Material::new(210e9, 0.3)?;
/// let pair = ElasticPair::new(steel, steel)?;
/// let grid = Grid::new(16, 9, 1e-6, 1e-6)?;
/// let normal = Convolution::new(grid, &pair, Component::ZZ)?;
///
/// let mut workspace = normal.scratch()?;
/// let mut displacement = vec![0.0; grid.cells()];
/// normal.apply([&vec![1e9; grid.cells()]], [&mut displacement], &mut workspace);
/// // A uniform load sags most in the middle.
/// assert!(displacement[4 * 16 + 8] > displacement[0]);
/// # Ok::<(), stickslip::Error>(())
/// ```
#[derive(Clone)]
pub struct Convolution<const N: usize = 1> {
    plan: Plan<f64>,
    symbol: Symbol<f64, N>,
    single: SingleProduct<N>,
    /// Smallest eigenvalue of the periodic continuation, and lower bound of the eigenvalues of the operator. On periodic grids
    /// both apply to tractions without a mean.
    least: f64,
    lower_bound_without_mean: f64,
    /// Lower bound of all eigenvalues. It excludes the eigenvalue of the mean on a grid that is periodic along both axes.
    lower_bound: f64,
    upper_bound: f64,
    /// Energy of a uniform traction along each direction, if the periodic continuation does not bound it.
    uniform_waves: Option<[UniformWave; N]>,
    /// Whether the lower bound is an estimate.
    is_estimate: bool,
    /// Whether single precision resolves the smallest eigenvalue relative to the largest.
    is_single_enough: bool,
}

shown!(Convolution<const N: usize>: lower_bound, upper_bound);

/// Ratio of the smallest to the largest eigenvalue below which single precision does not resolve the smallest. Grids with long
/// cells fall below this ratio, as do square grids of about 50 000 cells along a side.
const SINGLE_RANGE: f64 = 2e-6;

impl Convolution {
    /// Creates the operator of the coefficient `component` of the pair on the cells of `grid`.
    ///
    /// # Errors
    /// The errors of [`Table::sample`](crate::influence::Table::sample).
    pub fn new(grid: Grid, pair: &ElasticPair, component: Component) -> Result<Self> {
        let reach = reach(grid.size(), Boundary::NonPeriodic);
        pair.check_no_kernel()?;
        let added = KernelCorrection::of(&kernel::Kernel::from(*pair));
        let samples = Samples::new(grid, reach)?.coated(added);
        parallel::enter_with(grid.cells(), || {
            let table = InfluenceKernel::Table(samples.table(grid, pair, component)?);
            Self::of_kernels(grid.size(), None, [[&table]])
        })
    }

    /// Creates the operator on a grid that is periodic along x and y. The operator uses the symbols of the
    /// [`influence`](crate::influence) page and no padding. It is exact for tractions that consist of waves that fit the grid,
    /// down to two cells per period. A mean traction causes no displacement, so displacements have mean zero.
    ///
    /// ```
    /// use std::f64::consts::TAU;
    /// use stickslip::{ElasticPair, Field, Grid, Material, Operator};
    /// use stickslip::{fft::Convolution, influence::Component};
    /// let pair = ElasticPair::new(Material::new(1.0, 0.5)?, Material::rigid())?;
    /// let grid = Grid::square(9, 1.0)?;
    /// let normal = Convolution::periodic(grid, &pair, Component::ZZ);
    ///
    /// let wave = Field::from_fn(grid, |x, _| 3.0 + (TAU * x).cos());
    /// let mut displacement = Field::zeros(grid);
    /// normal.apply([wave.as_slice()], [displacement.as_mut_slice()], &mut normal.scratch()?);
    /// // The result is 2/(E* k) times the wave, and zero for its mean.
    /// let expected = 2.0 / (pair.contact_modulus() * TAU);
    /// assert!((displacement.get(4, 0).unwrap() - expected).abs() < 1e-15);
    /// # Ok::<(), stickslip::Error>(())
    /// ```
    ///
    /// For a pair that [represents a kernel](ElasticPair::stands_for_kernel), the result is the operator of the half-spaces of
    /// the pair, not of the kernel.
    #[must_use]
    pub fn periodic(grid: Grid, pair: &ElasticPair, component: Component) -> Self {
        let symbols = InfluenceKernel::Symbols(Symbols::new(grid, &(*pair).into(), component));
        unwrap_or_abort(parallel::enter_with(grid.cells(), || {
            Self::of_kernels(grid.size(), None, [[&symbols]])
        }))
    }
}

impl<const N: usize> Convolution<N> {
    /// Creates the operator on `[nx, ny]` cells. The kernels are a symmetric tensor (indexed by displacement, then traction) or
    /// one kernel of any parity. Tables must contain the [`samples`] of at least these cells. Symbols must belong to exactly
    /// these cells.
    ///
    /// # Errors
    /// - [`Error::Memory`](crate::Error::Memory) if memory runs out.
    pub(crate) fn of_kernels(
        size: [usize; 2],
        share: Option<Arc<RowPartition>>,
        kernels: [[&InfluenceKernel; N]; N],
    ) -> Result<Self> {
        let repeats = kernels[0][0].repeats();
        let frame = TorusLayout {
            size,
            torus: torus(size, repeats),
            share,
        };
        let symbol = Symbol::new(&frame, kernels)?;
        let plan = Plan::new(frame.clone());
        let normalisation = 1.0 / plan.cells_of_torus();
        // The matrix of a free half-space is a principal submatrix of the matrix on the torus. The symbol contains the
        // eigenvalues of the matrix on the torus. The mean on a periodic grid has the eigenvalue zero.
        let range = symbol.extremes(repeats == [true; 2]);
        // On a grid that is periodic along y, waves on the torus have the period of the grid. A traction without a mean
        // therefore has no mean on the torus.
        let least = match symbol.extremes(true) {
            [least, _] if repeats == [false, true] && least.is_finite() => least,
            _ => range[0],
        };
        Ok(Self {
            plan,
            single: SingleProduct::new(frame, &symbol)?,
            least,
            lower_bound_without_mean: lower_bound([least, range[1]], kernels),
            lower_bound: lower_bound(range, kernels),
            upper_bound: range[1],
            uniform_waves: None,
            is_estimate: false,
            is_single_enough: least > SINGLE_RANGE * range[1],
            symbol: symbol.scaled(normalisation),
        })
    }
}

impl<const N: usize> Convolution<N> {
    /// Replaces the smallest eigenvalue of the periodic continuation by a given value, and sets the origin of this value. On a
    /// grid that is periodic along y, the value applies to tractions without a mean. [`Self::with_uniform_waves`] completes the
    /// bound.
    pub(crate) fn bounded(self, least: f64, known: EigenvalueBound) -> Self {
        let lower_bound = (least - 1e-14 * self.upper_bound).max(0.0);
        Self {
            least,
            lower_bound_without_mean: lower_bound,
            lower_bound,
            is_estimate: known == EigenvalueBound::Estimated,
            is_single_enough: least > SINGLE_RANGE * self.upper_bound,
            ..self
        }
    }

    /// Uses the bounds of an operator of which this operator is a principal submatrix.
    pub(crate) fn bounded_as(self, whole: &Self) -> Self {
        Self {
            lower_bound: whole.lower_bound,
            uniform_waves: whole.uniform_waves,
            ..self.bounded(whole.least, whole.known())
        }
    }

    /// Sets the energy of uniform tractions. Together with the bound for tractions without a mean it bounds all eigenvalues.
    pub(crate) fn with_uniform_waves(self, waves: [UniformWave; N]) -> Self {
        let bound = |wave: &UniformWave| wave.bound(self.lower_bound_without_mean, 0.0);
        let least = waves.iter().map(bound).fold(f64::INFINITY, f64::min);
        Self {
            lower_bound: least.max(0.0),
            uniform_waves: Some(waves),
            ..self
        }
    }

    /// Returns the smallest eigenvalue of the periodic continuation, which can be negative. On a periodic grid the mean is
    /// excluded.
    pub(crate) fn least_eigenvalue(&self) -> f64 {
        self.least
    }

    /// Returns a lower bound of the eigenvalues. The bound applies to tractions without a mean on a periodic grid and to all
    /// tractions on a free grid.
    pub(crate) fn lower_bound_without_mean(&self) -> f64 {
        self.lower_bound_without_mean
    }

    /// Returns a lower bound of the eigenvalues for the tractions that a problem allows. A component with a prescribed sum
    /// (`None`) has no mean. For the other components the value is the compliance that is added for a uniform traction. It is
    /// zero or the compliance of a spring.
    ///
    /// # Errors
    /// - [`Error::DatumTooNear`](crate::Error::DatumTooNear) if the compliance of these tractions is not positive definite.
    pub(crate) fn lower_bound_of(&self, added: [Option<f64>; N]) -> Result<LowerBound> {
        let least = self.lower_bound_without_mean;
        let (mut value, mut mean) = (least, MeanBound::Operator);
        if let Some(waves) = &self.uniform_waves {
            mean = MeanBound::OperatorWithSprings;
            for (wave, added) in waves.iter().zip(added) {
                let Some(added) = added else { continue };
                let bound = wave.bound(least, added);
                if bound <= 0.0 {
                    return Err(wave.too_near(least, added));
                }
                value = value.min(bound);
            }
        } else if added != [None; N] {
            value = self.lower_bound;
        }
        let of_all = if self.lower_bound > 0.0 {
            value.min(self.lower_bound)
        } else {
            value
        };
        Ok(LowerBound {
            value,
            of_all,
            known: self.known(),
            mean,
        })
    }

    /// Returns the origin of the bound for tractions without a mean.
    pub(crate) fn known(&self) -> EigenvalueBound {
        match (self.lower_bound_without_mean > 0.0, self.is_estimate) {
            (false, _) => EigenvalueBound::Unknown,
            (true, true) => EigenvalueBound::Estimated,
            (true, false) => EigenvalueBound::Proven,
        }
    }

    /// Returns the largest eigenvalue of the periodic continuation, an upper bound for the operator on the grid.
    pub(crate) fn upper_bound(&self) -> f64 {
        self.upper_bound
    }
}

impl Convolution<3> {
    /// Returns a bound on $`|p' B q| / (|p|\,|q|)`$ in the energy norms of the first component and of the other two. B contains
    /// the displacements that the first component causes along the others.
    pub(crate) fn coupling(&self) -> f64 {
        self.symbol.coupling()
    }
}

/// Returns a lower bound of the eigenvalues of the operator from the range of the eigenvalues on the torus.
fn lower_bound<const N: usize>([low, high]: [f64; 2], kernels: [[&InfluenceKernel; N]; N]) -> f64 {
    // A coefficient between two different directions is not a compliance.
    let is_compliance = (0..N).all(|i| kernels[i][i].is_odd() == [false; 2]);
    if !is_compliance {
        0.0
    } else if low.is_finite() {
        // The round-off of the transform is subtracted from the bound.
        (low - 1e-14 * high).max(0.0)
    } else {
        // A single periodic cell has no field of mean zero, so every number is a bound. Residuals require a bound in units of
        // the compliance.
        let waves = (0..N).map(|i| kernels[i][i].least_of_one_period());
        waves.fold(f64::INFINITY, f64::min).max(0.0)
    }
}

/// Returns the integrals of all coefficients at every distance within the transform of `size` cells of `grid`. Returns `None` for
/// a grid that is periodic along both axes, because such a grid uses symbols. The distances along y are distributed over the
/// ranks, and coated bodies add a correction.
pub(crate) fn samples(
    grid: Grid,
    boundary: Boundary,
    cell_value: CellValue,
    size: [usize; 2],
    (team, added): (Option<&Arc<RankGroup>>, Option<&Arc<KernelCorrection>>),
) -> Result<Option<Samples>> {
    let reach = reach(size, boundary);
    let samples = match boundary {
        Boundary::NonPeriodic => Samples::new(grid, reach)?,
        Boundary::PeriodicAlongY { datum } => Samples::repeating_along_y(grid, reach, datum)?,
        Boundary::Periodic => return Ok(None),
    };
    let share = team.map(|team| Arc::new(RowPartition::new(team, reach)));
    Ok(Some(
        samples.of(cell_value).shared(share).coated(added.cloned()),
    ))
}

/// Returns the number of distances along each axis, from zero to half the torus.
fn reach(size: [usize; 2], boundary: Boundary) -> [usize; 2] {
    torus(size, boundary.repeats()).map(|m| m / 2 + 1)
}

/// Buffers of products: 16 bytes per cell for each component, and a small amount per task.
#[derive(Debug, Clone)]
struct ConvolutionScratch<const N: usize> {
    tiles: Tiles<N>,
    double: TaskScratch<f64, N>,
    /// Buffers for single precision, created by the first product in single precision. Many callers compute no such product.
    single: Option<TaskScratch<f32, N>>,
}

impl<const N: usize> Operator<N> for Convolution<N> {
    fn cells(&self) -> usize {
        self.plan.cells()
    }

    fn layout(&self) -> Layout {
        self.plan.layout()
    }

    fn scratch(&self) -> Result<Scratch> {
        Ok(Scratch::new(ConvolutionScratch::<N> {
            tiles: self.plan.tiles_of_products()?,
            double: self.plan.scratch()?,
            single: None,
        }))
    }

    fn apply(&self, x: [&[f64]; N], out: [&mut [f64]; N], scratch: &mut Scratch) {
        let ConvolutionScratch { tiles, double, .. } = scratch.buffers();
        self.plan
            .convolve(&self.symbol, x, out, [1.0; 2], tiles, double);
    }

    /// Computes the product in single precision. The error is about 3e-7 of the largest displacement. The cost is two thirds of
    /// the cost of a product in double precision. Double precision is used if single precision does not resolve the smallest
    /// eigenvalue relative to the largest eigenvalue.
    fn apply_f32(&self, x: [&[f64]; N], out: [&mut [f64]; N], scratch: &mut Scratch) {
        if !self.is_single_enough {
            return self.apply(x, out, scratch);
        }
        let ConvolutionScratch { tiles, single, .. } = scratch.buffers();
        if single.is_none() {
            *single = self.single.scratch().ok();
        }
        match single {
            Some(tasks) => self.single.apply(x, out, tiles, tasks),
            // Without memory for single precision, the product is computed in double precision.
            None => self.apply(x, out, scratch),
        }
    }

    /// Returns the smallest eigenvalue of the periodic continuation, a lower bound for the operator on the grid.
    ///
    /// - For a periodic grid it is the smallest eigenvalue on fields of mean zero. For a single periodic cell, which has no such
    ///   field, the bound is the symbol of a wave of one period over the cell.
    /// - It is zero for a single component between two different directions.
    /// - It is zero for pressure with shear on some grids if Poisson's ratios are negative. The continuation is then not positive
    ///   definite although the operator is.
    /// - For stiff layers on soft bodies the continuation can also be indefinite. The bound is then a conservative estimate
    ///   of the smallest eigenvalue of the infinite lattice of these cells.
    /// - It is zero for a grid that is periodic along y if the datum is so near that the operator is indefinite.
    fn lower_bound(&self) -> f64 {
        self.lower_bound
    }

    fn eigenvalue_bound(&self) -> EigenvalueBound {
        if self.lower_bound > 0.0 {
            self.known()
        } else {
            EigenvalueBound::Unknown
        }
    }

    fn self_compliance(&self) -> f64 {
        SELF_COMPLIANCE * self.lower_bound_without_mean
    }
}
