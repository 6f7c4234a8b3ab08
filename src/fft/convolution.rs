//! The half-space as an operator: convolution with influence coefficients, along each axis zero-padded or periodic.

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
use crate::influence::{Kernel, KernelCorrection, Samples, Symbols};
use crate::memory::fallible::unwrap_or_abort;
use crate::operator::{LowerBound, MeanBound, Operator, SELF_COMPLIANCE, Scratch};
use crate::parallel;
use crate::parallel::layout::Layout;
use crate::parallel::ranks::RankGroup;
use crate::parallel::ranks::partition::RowPartition;
use crate::report::EigenvalueBound;
use crate::support::debug::shown;

/// `u_i = sum_j C_ij * t_j` on a grid: N displacement components of every cell from N traction components
/// of all cells, by fast transforms: one each way for each component. Without periodic images
/// ([`Self::new`]) or on a grid that repeats along both axes ([`Self::periodic`]); those on a grid that repeats along y
/// alone are obtained from [`HalfSpace::operator`](crate::HalfSpace::operator), those of several components from
/// [`HalfSpace::tensor_operator`](crate::HalfSpace::tensor_operator).
///
/// Tractions are pressures, displacements lengths. Equal to the direct sum up to round-off
/// (1e-15 of the largest displacement, typically). Immutable and shared; memory 12 bytes per cell for each
/// of the N (N + 1)/2 coefficients, and 16 N per cell in each workspace; on a grid that repeats along y alone 6
/// instead of 12, on one that repeats along both axes 3, and 8 N in each workspace.
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
    /// The least eigenvalue of the periodic continuation, and a bound from below of those of the operator: without the mean
    /// where the grid repeats.
    least: f64,
    lower_bound_without_mean: f64,
    /// A bound of all eigenvalues; without the mean on a grid that repeats along both axes.
    lower_bound: f64,
    upper_bound: f64,
    /// The energy of a uniform traction along each direction, where the periodic continuation does not bound it.
    uniform_waves: Option<[UniformWave; N]>,
    /// Whether the lower bound is an estimate.
    is_estimate: bool,
    /// Whether single precision resolves the smallest eigenvalue beside the largest.
    is_single_enough: bool,
}

shown!(Convolution<const N: usize>: lower_bound, upper_bound);

/// Ratio of the eigenvalues below which the smallest is lost in the error of single precision: that of long cells,
/// and of squares of some 50 000 cells along a side.
const SINGLE_RANGE: f64 = 2e-6;

impl Convolution {
    /// The coefficient `component` of the pair, on the cells of `grid`.
    ///
    /// # Errors
    /// As [`Table::sample`](crate::influence::Table::sample).
    pub fn new(grid: Grid, pair: &ElasticPair, component: Component) -> Result<Self> {
        let reach = reach(grid.size(), Boundary::NonPeriodic);
        pair.check_no_kernel()?;
        let added = KernelCorrection::of(&kernel::Kernel::from(*pair));
        let samples = Samples::new(grid, reach)?.coated(added);
        parallel::enter_with(grid.cells(), || {
            let table = Kernel::Table(samples.table(grid, pair, component)?);
            Self::of_kernels(grid.size(), None, [[&table]])
        })
    }

    /// The same on a grid that repeats along x and y, with the symbols of the [`influence`](crate::influence)
    /// page and no padding: exact for tractions made of waves that fit the grid, down to two cells a
    /// period. A mean traction causes none of it, so that displacements have mean zero.
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
    /// // 2/(E* k) times the wave, nothing for its mean.
    /// let expected = 2.0 / (pair.contact_modulus() * TAU);
    /// assert!((displacement.get(4, 0).unwrap() - expected).abs() < 1e-15);
    /// # Ok::<(), stickslip::Error>(())
    /// ```
    ///
    /// Of a pair that [stands for a kernel](ElasticPair::stands_for_kernel) it is that of its half-spaces, not of the kernel.
    #[must_use]
    pub fn periodic(grid: Grid, pair: &ElasticPair, component: Component) -> Self {
        let symbols = Kernel::Symbols(Symbols::new(grid, &(*pair).into(), component));
        unwrap_or_abort(parallel::enter_with(grid.cells(), || {
            Self::of_kernels(grid.size(), None, [[&symbols]])
        }))
    }
}

impl<const N: usize> Convolution<N> {
    /// On `[nx, ny]` cells, from a symmetric tensor of kernels (displacement, then traction) or from one
    /// kernel of any parity. Tables must hold the [`samples`] of these or more cells, symbols are those of
    /// these cells.
    ///
    /// # Errors
    /// [`Error::Memory`](crate::Error::Memory).
    pub(crate) fn of_kernels(
        size: [usize; 2],
        share: Option<Arc<RowPartition>>,
        kernels: [[&Kernel; N]; N],
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
        // The matrix of a free half-space is a principal part of the torus's, whose eigenvalues are those of the
        // symbol. A mean on a grid that repeats has the eigenvalue zero.
        let range = symbol.extremes(repeats == [true; 2]);
        // The waves of a grid that repeats along y have that period, so that a traction without a mean has none on the torus.
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
    /// With a least eigenvalue that is known so in place of that of the periodic continuation. On a grid that repeats along y
    /// it is that of tractions without a mean, and [`Self::with_uniform_waves`] completes the bound.
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

    /// With the bounds of an operator that this one is a principal part of.
    pub(crate) fn bounded_as(self, whole: &Self) -> Self {
        Self {
            lower_bound: whole.lower_bound,
            uniform_waves: whole.uniform_waves,
            ..self.bounded(whole.least, whole.known())
        }
    }

    /// With the energy of uniform tractions, which bounds all eigenvalues together with those of tractions without a mean.
    pub(crate) fn with_uniform_waves(self, waves: [UniformWave; N]) -> Self {
        let bound = |wave: &UniformWave| wave.bound(self.lower_bound_without_mean, 0.0);
        let least = waves.iter().map(bound).fold(f64::INFINITY, f64::min);
        Self {
            lower_bound: least.max(0.0),
            uniform_waves: Some(waves),
            ..self
        }
    }

    /// The least eigenvalue of the periodic continuation, of whatever sign; without the mean on a grid that repeats.
    pub(crate) fn least_eigenvalue(&self) -> f64 {
        self.least
    }

    /// A lower bound of the eigenvalues of tractions without a mean on a grid that repeats, of all tractions on another grid.
    pub(crate) fn lower_bound_without_mean(&self) -> f64 {
        self.lower_bound_without_mean
    }

    /// A lower bound of the eigenvalues of the tractions that a problem allows. A component has no mean if its sum is
    /// prescribed (`None`). To others a uniform traction adds such a compliance: zero, or that of a spring.
    ///
    /// # Errors
    /// [`Error::DatumTooNear`](crate::Error::DatumTooNear) if the compliance of these tractions is not definite.
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
        let known = self.known();
        Ok(LowerBound { value, known, mean })
    }

    /// How the bound of tractions without a mean is known.
    pub(crate) fn known(&self) -> EigenvalueBound {
        match (self.lower_bound_without_mean > 0.0, self.is_estimate) {
            (false, _) => EigenvalueBound::Unknown,
            (true, true) => EigenvalueBound::Estimated,
            (true, false) => EigenvalueBound::Proven,
        }
    }

    /// The largest eigenvalue of the periodic continuation, a bound for the cells cut out of it.
    pub(crate) fn upper_bound(&self) -> f64 {
        self.upper_bound
    }
}

impl Convolution<3> {
    /// A bound of $`|p' B q| / (|p|\,|q|)`$, in the energy norms of the first component and of the other two, of what the
    /// first causes along the others.
    pub(crate) fn coupling(&self) -> f64 {
        self.symbol.coupling()
    }
}

/// Of the eigenvalues of the operator, from the range of those of the torus.
fn lower_bound<const N: usize>([low, high]: [f64; 2], kernels: [[&Kernel; N]; N]) -> f64 {
    // A coefficient between two directions is not a compliance.
    let is_compliance = (0..N).all(|i| kernels[i][i].is_odd() == [false; 2]);
    if !is_compliance {
        0.0
    } else if low.is_finite() {
        // What the transform itself rounds off is taken from the bound.
        (low - 1e-14 * high).max(0.0)
    } else {
        // A single periodic cell has no field of mean zero, so that any number is a bound. Residuals need one in its units.
        let waves = (0..N).map(|i| kernels[i][i].least_of_one_period());
        waves.fold(f64::INFINITY, f64::min).max(0.0)
    }
}

/// The integrals of all coefficients at every distance that the transform of `size` cells of `grid` reaches; none for
/// a grid that repeats along both axes, which has symbols. Ranks deal out the distances along y; coated bodies add a rest.
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

/// Distances along each axis from nothing to half around the torus.
fn reach(size: [usize; 2], boundary: Boundary) -> [usize; 2] {
    torus(size, boundary.repeats()).map(|m| m / 2 + 1)
}

/// Buffers of products: for each component 16 bytes per cell, and a little for each task.
#[derive(Debug, Clone)]
struct ConvolutionScratch<const N: usize> {
    tiles: Tiles<N>,
    double: TaskScratch<f64, N>,
    /// Made by the first product in single precision: many users never ask for one.
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

    /// In single precision: about 3e-7 of the largest displacement, at two thirds of the cost. In double precision where
    /// the smallest eigenvalue is too small a part of the largest to be seen beside that error.
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
            // There is no memory for it: the product in double precision is as good.
            None => self.apply(x, out, scratch),
        }
    }

    /// The smallest eigenvalue of the periodic continuation, a bound for the cells cut out of it; for a
    /// periodic grid that on fields of mean zero. One periodic cell has no such field: its bound is the symbol of a wave of
    /// one period over the cell. Zero for a single component between two directions; and
    /// for pressure with shear of bodies whose Poisson's ratios are negative, on some grids, where the
    /// continuation is not definite though the operator is. Where that of stiff layers on soft bodies is not, an
    /// estimate, on the safe side, of the least eigenvalue of the infinite lattice of these cells. Zero for a grid that
    /// repeats along y if a datum that is too near makes the operator indefinite.
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
