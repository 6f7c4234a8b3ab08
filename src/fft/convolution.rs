//! The half-space as an operator: convolution with one influence coefficient, zero-padded or periodic.

use crate::error::{Result, memory};
use crate::fft::length::smooth_length;
use crate::fft::plan::{Buffers, Plan};
use crate::fft::single::{SingleProduct, SingleWorkspace};
use crate::fft::spectrum::Spectrum;
use crate::grid::Grid;
use crate::influence::{Component, Samples, Symbols, Table};
use crate::material::ElasticPair;
use crate::operator::Operator;

/// `u_i = C_ij * t_j` on a grid: displacement component `i` of every cell from the tractions `j`
/// of all cells, by fast transforms: without periodic images ([`Self::new`]) or on a grid that repeats
/// ([`Self::periodic`]).
///
/// Tractions are pressures, displacements lengths. Equal to the direct sum up to round-off
/// (1e-15 of the largest displacement, typically). Immutable and shared; memory 12 bytes per cell,
/// and 24 per cell in each workspace; a periodic one takes 3, and 12.
///
/// ```
/// use stickslip::{ElasticPair, Grid, Material, Operator, fft::Convolution, influence::Component};
/// let steel = Material::new(210e9, 0.3)?;
/// let pair = ElasticPair::new(steel, steel)?;
/// let grid = Grid::new(16, 9, 1e-6, 1e-6)?;
/// let normal = Convolution::new(grid, &pair, Component::ZZ)?;
///
/// let mut workspace = normal.workspace();
/// let mut displacement = vec![0.0; grid.cells()];
/// normal.apply(&vec![1e9; grid.cells()], &mut displacement, &mut workspace);
/// // A uniform load sags most in the middle.
/// assert!(displacement[4 * 16 + 8] > displacement[0]);
/// # Ok::<(), stickslip::Error>(())
/// ```
#[derive(Debug, Clone)]
pub struct Convolution {
    plan: Plan<f64>,
    spectrum: Spectrum<f64>,
    single: SingleProduct,
    component: Component,
    lower_bound: f64,
}

impl Convolution {
    /// The coefficient `component` of the pair, on the cells of `grid`.
    ///
    /// # Errors
    /// As [`Table::sample`].
    pub fn new(grid: Grid, pair: &ElasticPair, component: Component) -> Result<Self> {
        let table = Self::samples(grid)?.table(grid, pair, component)?;
        Ok(Self::of_table([grid.nx(), grid.ny()], &table))
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
    /// normal.apply(wave.as_slice(), displacement.as_mut_slice(), &mut normal.workspace());
    /// // 2/(E* k) times the wave, nothing for its mean.
    /// let expected = 2.0 / (pair.contact_modulus() * TAU);
    /// assert!((displacement.get(4, 0).unwrap() - expected).abs() < 1e-15);
    /// # Ok::<(), stickslip::Error>(())
    /// ```
    #[must_use]
    pub fn periodic(grid: Grid, pair: &ElasticPair, component: Component) -> Self {
        Self::of_symbols(&Symbols::new(grid, pair, component))
    }

    pub(crate) fn of_symbols(symbols: &Symbols) -> Self {
        let spectrum = Spectrum::of_symbols(symbols);
        let eigenvalues = spectrum.extremes_without_mean();
        let size = symbols.size();
        Self::of_spectrum(size, size, symbols.component(), &spectrum, eigenvalues)
    }

    /// The integrals of all coefficients at every distance the padded transform of `grid` reaches.
    pub(crate) fn samples(grid: Grid) -> Result<Samples> {
        memory("influence coefficients", grid.size(), size_of::<f64>())?;
        let reach = padded([grid.nx(), grid.ny()]).map(|m| m / 2 + 1);
        Samples::new(grid, reach)
    }

    /// On `[nx, ny]` cells, from a table of the [`Self::samples`] of these or more cells.
    pub(crate) fn of_table(size: [usize; 2], table: &Table) -> Self {
        let torus = padded(size);
        let spectrum = Spectrum::of_table(table, torus);
        // The matrix is a principal part of the torus's, whose eigenvalues are the spectrum.
        let eigenvalues = spectrum.extremes();
        Self::of_spectrum(size, torus, table.component(), &spectrum, eigenvalues)
    }

    fn of_spectrum(
        size: [usize; 2],
        torus: [usize; 2],
        component: Component,
        spectrum: &Spectrum<f64>,
        [low, high]: [f64; 2],
    ) -> Self {
        // What the transform itself rounds off is taken from the bound.
        let lower_bound = match component {
            Component::XX | Component::YY | Component::ZZ if low.is_finite() => {
                (low - 1e-14 * high).max(0.0)
            }
            _ => 0.0,
        };
        let normalisation = 1.0 / (torus[0] * torus[1]) as f64;
        Self {
            plan: Plan::new(size, torus),
            single: SingleProduct::new(size, torus, spectrum, |value| value),
            spectrum: spectrum.map(|value| value * normalisation),
            component,
            lower_bound,
        }
    }

    /// Which influence coefficient is applied.
    #[must_use]
    pub fn component(&self) -> Component {
        self.component
    }
}

/// Cells of the torus: no image of `n` cells reaches back into them.
pub(super) fn padded(size: [usize; 2]) -> [usize; 2] {
    size.map(|n| smooth_length(2 * n - 1))
}

/// Buffers of products: 16 bytes per cell, 8 more from the first product in single precision on, and
/// a little for each task.
#[derive(Debug, Clone)]
pub struct ConvolutionWorkspace {
    double: Buffers<f64>,
    /// Made by the first product in single precision: many users never ask for one.
    single: Option<SingleWorkspace>,
}

impl Operator for Convolution {
    type Workspace = ConvolutionWorkspace;

    fn len(&self) -> usize {
        self.plan.nx * self.plan.ny
    }

    fn workspace(&self) -> ConvolutionWorkspace {
        ConvolutionWorkspace {
            double: self.plan.workspace(),
            single: None,
        }
    }

    fn apply(&self, x: &[f64], out: &mut [f64], workspace: &mut ConvolutionWorkspace) {
        let buffers = &mut workspace.double;
        self.plan
            .convolve(&self.spectrum, x, out, [1.0; 2], buffers);
    }

    /// In single precision: about 3e-7 of the largest displacement, at two thirds of the cost.
    fn apply_roughly(&self, x: &[f64], out: &mut [f64], workspace: &mut ConvolutionWorkspace) {
        let buffers = workspace
            .single
            .get_or_insert_with(|| self.single.workspace());
        self.single.apply(x, out, buffers);
    }

    /// The smallest eigenvalue of the periodic continuation, a bound for the cells cut out of it; for a
    /// periodic grid that on fields of mean zero. Zero for the components that are not a compliance of
    /// their own.
    fn lower_bound(&self) -> f64 {
        self.lower_bound
    }
}
