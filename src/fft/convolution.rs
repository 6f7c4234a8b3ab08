//! The free half-space as an operator: zero-padded convolution with one influence coefficient.

use crate::error::Result;
use crate::fft::length::smooth_length;
use crate::fft::plan::{Buffers, Plan};
use crate::fft::single::{SingleProduct, SingleWorkspace};
use crate::fft::spectrum::Spectrum;
use crate::grid::Grid;
use crate::influence::{Component, Samples, Table};
use crate::material::ElasticPair;
use crate::operator::Operator;

/// `u_i = C_ij * t_j` on a grid: displacement component `i` of every cell from the tractions `j`
/// of all cells, by fast transforms and without periodic images.
///
/// Tractions are pressures, displacements lengths. Equal to the direct sum up to round-off
/// (1e-15 of the largest displacement, typically). Immutable and shared; memory 12 bytes per cell,
/// and 24 per cell in each workspace.
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

    /// The integrals of all coefficients at every distance the padded transform of `grid` reaches.
    pub(crate) fn samples(grid: Grid) -> Result<Samples> {
        let reach = padded([grid.nx(), grid.ny()]).map(|m| m / 2 + 1);
        Samples::new(grid, reach)
    }

    /// On `[nx, ny]` cells, from a table of the [`Self::samples`] of these or more cells.
    pub(crate) fn of_table(size: [usize; 2], table: &Table) -> Self {
        let torus = padded(size);
        let component = table.component();
        let spectrum = Spectrum::of_table(table, torus);
        // The matrix is a principal part of the torus's, whose eigenvalues are the spectrum; what
        // the transform itself rounds off is taken from the bound.
        let lower_bound = match component {
            Component::XX | Component::YY | Component::ZZ => {
                let [low, high] = spectrum.extremes();
                (low - 1e-14 * high).max(0.0)
            }
            _ => 0.0,
        };
        let normalisation = 1.0 / (torus[0] * torus[1]) as f64;
        Self {
            plan: Plan::new(size, torus),
            single: SingleProduct::new(size, torus, &spectrum, |value| value),
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
fn padded(size: [usize; 2]) -> [usize; 2] {
    size.map(|n| smooth_length(2 * n - 1))
}

/// Buffers of products: 16 bytes per cell, 8 more from the first product in single precision on, and
/// a little for each task.
#[derive(Debug)]
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

    /// The smallest eigenvalue of the periodic continuation, a bound for the cells cut out of it;
    /// zero for the components that are not a compliance of their own.
    fn lower_bound(&self) -> f64 {
        self.lower_bound
    }
}
