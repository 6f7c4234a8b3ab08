//! Two elastic half-spaces on a grid, with the operators that all problems on the grid share.

mod cache;
mod coarser;
mod coefficients;
mod compliance;
mod operator;
mod ranks;
mod region;

use std::sync::{Arc, OnceLock};

use crate::bodies::component::{Component, Direction};
use crate::bodies::kernel;
use crate::bodies::material::{ElasticPair, Material};
use crate::error::{Error, Result, at_least, finite, has_squares, memory};
use crate::fft::samples;
use crate::grid::Grid;
use crate::grid::boundary::Boundary;
use crate::grid::cell_value::CellValue;
use crate::grid::window::Window;
use crate::influence::{InfluenceKernel, KernelCorrection};
use crate::parallel::ranks::RankGroup;
use crate::parallel::ranks::partition::RowPartition;
use crate::support::debug::shown;

use cache::Cache;
use coefficients::CellKernels;
pub(crate) use compliance::Compliance;
use compliance::tensor;
pub use operator::{ElasticOperator, ElasticPreconditioner};
pub(crate) use region::Region;

/// Pair of half-spaces on a grid, with the operators of the components in use.
///
/// Each component is sampled and transformed once, on first use by a problem, and shared by all clones. Contacts on windows of
/// equal size share operators as long as any of these contacts exists. Contacts that are not solved concurrently share the
/// buffers of a solve. The type is `Send + Sync`, so several solvers on different threads may use the same `HalfSpace`.
///
/// # Memory
///
/// The samples for `XX`, `YY` and `ZZ` together take 16 bytes per cell. Each of `XY`, `XZ` and `YZ` takes 8 bytes per cell for
/// its samples. The coarser grids of nested starts use the same samples. On a grid that is periodic along y only, the coarser
/// grids have separate samples. On grids of more than 1024 x 1024 cells the samples are recomputed for each operator and not
/// kept. Each operator takes 12 bytes per cell, and its preconditioner one byte per cell. The operators of coarser grids add a
/// third. Compared with an operator of one direction, an operator of two directions takes three times as much memory. An
/// operator of all three directions takes six times as much. With a periodic boundary there are no samples, and an operator
/// takes three bytes per cell.
///
/// ```
/// use stickslip::{ElasticPair, Grid, HalfSpace, Material};
/// let steel = Material::new(213e9, 0.29)?;
/// let bodies = HalfSpace::new(Grid::square(64, 0.4e-3)?, ElasticPair::new(steel, steel)?)?;
/// assert_eq!(bodies.grid().cells(), 4096);
/// # Ok::<(), stickslip::Error>(())
/// ```
#[derive(Clone)]
pub struct HalfSpace {
    shared: Arc<Shared>,
}

shown!(HalfSpace: grid(), pair(), boundary(), cell_value());

/// Two bodies are equal if grid, boundary, cell value and materials or kernel are equal. For [distributed](Self::distributed)
/// bodies the grid is the slab of the rank. Operators in memory and ranks are not compared. All values are free of NaN, so
/// bodies equal themselves.
impl PartialEq for HalfSpace {
    fn eq(&self, other: &Self) -> bool {
        self.grid() == other.grid()
            && self.boundary() == other.boundary()
            && self.cell_value() == other.cell_value()
            && self.kernel() == other.kernel()
    }
}

#[derive(Debug)]
struct Shared {
    grid: Grid,
    /// Cached kernels. Only the kernels of small grids are cached.
    kernels: CellKernels,
    /// Ranks that share the grid, or that each store the whole grid and perform the same work.
    team: Option<Arc<RankGroup>>,
    /// Distribution of the grid over ranks, if any.
    share: Option<Arc<RowPartition>>,
    /// Operators and preconditioners. The cache keeps the entries of the whole grid for the lifetime of the cache. It keeps
    /// the entries of windows as long as these entries have an owner.
    made: Cache,
    /// Bodies on cells of twice the sides.
    coarser: OnceLock<HalfSpace>,
}

/// Largest number of cells of a grid whose kernels are kept for other operators.
const KEPT_CELLS: usize = 1 << 20;

/// Minimum number of bytes per cell for a normal contact on all cells: operators, buffers and solution.
const BYTES_PER_CELL: usize = 90;

const _: () = {
    const fn assert_send_sync<T: Send + Sync>() {}
    assert_send_sync::<HalfSpace>();
};

impl HalfSpace {
    /// Creates the bodies, an [`ElasticPair`] or a [`kernel::Kernel`], on `grid` with the boundary
    /// [`Boundary::NonPeriodic`]. No operator is computed yet.
    ///
    /// # Errors
    /// - [`Error::NotPositive`] if the ratio of the sides of a cell over- or underflows.
    /// - [`Error::ExtremeNumber`] if the side of a cell divided by the contact modulus lies outside 1e-130 to 1e130.
    /// - [`Error::Memory`] if the memory for a contact of all cells is not available.
    /// - [`Error::BelowMinimum`] if a layer is thinner than 1e-25 of the diagonal of the grid.
    /// - [`Error::IncompleteKernel`] if the pair represents a kernel.
    ///
    /// For a kernel, also:
    /// - [`Error::UnsupportedForCoatings`] if the kernel does not support the grid.
    /// - [`Error::BelowMinimum`] if an isotropic kernel does not agree with its half-space for short waves.
    /// - [`Error::GridMismatch`] if a table has different cells or too few cells, or if operators belong to another
    ///   [grid](kernel::Operators::on).
    /// - [`Error::Length`] if operators have a different number of cells.
    /// - [`Error::UnsupportedByModel`] on a grid that is periodic along both axes, if operators do not map constants to zero.
    /// - [`Error::NotPositive`] or [`Error::NotFinite`] if a response is not positive or not finite for a wave of a
    ///   periodic grid.
    pub fn new(grid: Grid, bodies: impl Into<kernel::Kernel>) -> Result<Self> {
        Self::with_boundary(grid, bodies, Boundary::NonPeriodic)
    }

    /// Creates the bodies on `grid` with the given boundary. No operator is computed yet.
    ///
    /// ```
    /// use std::f64::consts::TAU;
    /// use stickslip::{Boundary, ElasticPair, Grid, HalfSpace, Material, NormalLoad, NormalProblem, surface};
    /// // A wavy surface pressed flat: the pressure p* = pi E* amplitude / wavelength is just sufficient.
    /// let grid = Grid::square(32, 1.0)?;
    /// let pair = ElasticPair::new(Material::new(1.0, 0.5)?, Material::rigid())?;
    /// let bodies = HalfSpace::with_boundary(grid, pair, Boundary::Periodic)?;
    /// let wavy = stickslip::Field::from_fn(grid, |x, _| 0.01 * (1.0 - (TAU * x).cos()));
    /// let flattening = 0.5 * TAU * pair.contact_modulus() * 0.01;
    /// let load = NormalLoad::Force(1.001 * flattening * grid.area());
    /// let contact = NormalProblem::builder(&bodies, &wavy, load).build()?.solve()?;
    /// assert_eq!(contact.contact_cells(), grid.cells());
    /// assert!((contact.approach() - 0.01).abs() < 1e-10); // the mean gap is closed
    /// # Ok::<(), stickslip::Error>(())
    /// ```
    ///
    /// # Errors
    /// - All errors of [`HalfSpace::new`].
    /// - [`Error::BelowMinimum`] if the [datum](Boundary::PeriodicAlongY) is less than the length of the grid.
    pub fn with_boundary(
        grid: Grid,
        bodies: impl Into<kernel::Kernel>,
        boundary: Boundary,
    ) -> Result<Self> {
        let bodies = bodies.into();
        check(grid, &bodies, boundary, grid.size())?;
        let (cell_value, added) = (CellValue::default(), KernelCorrection::of(&bodies));
        let dealt = (None, added.as_ref());
        let samples = samples(grid, boundary, cell_value, grid.size(), dealt)?.map(Arc::new);
        let kernels = CellKernels::new(grid, &bodies, boundary, cell_value, (samples, added));
        Ok(Self::of_kernels(kernels, (None, None)))
    }

    /// Sets the interpretation of cell values (default: [`CellValue::Uniform`]). No operator is computed yet. The call
    /// is collective on ranks. On a grid with [`Boundary::Periodic`], values always refer to the centres. The symbols on such
    /// a grid belong to waves and are not averaged over cells.
    ///
    /// Values at the centres with [`edges`](crate::edges) need fewer cells than uniform cells. The page on
    /// [accuracy](crate::guide::accuracy#recommendation) lists the cells per contact radius for 5, 1 and 0.1 %, and the
    /// times. [Narrow slip rings](crate::edges#narrow-slip-rings) need more cells.
    ///
    /// # Cost
    ///
    /// The computation of the kernels takes 4 % more time than with uniform cells. Solves do not take more time.
    ///
    /// ```
    /// use stickslip::*;
    /// let grid = Grid::square(32, 3.0)?;
    /// let pair = ElasticPair::new(Material::new(1.0, 0.0)?, Material::rigid())?;
    /// let ball = surface::sphere(grid, 1.0)?;
    /// let hertz = analytical::HertzSphere::new(&pair, 1.0, 4.0 / 3.0)?; // of radius 1
    /// // The error of a cell that is not at the edge.
    /// let error = |cell_value| -> Result<f64> {
    ///     let bodies = HalfSpace::new(grid, pair)?.with_cell_value(cell_value)?;
    ///     let load = NormalLoad::Force(hertz.load());
    ///     let contact = NormalProblem::builder(&bodies, &ball, load).build()?.solve()?;
    ///     let found = contact.pressure().get(20, 18).unwrap_or(0.0);
    ///     Ok((found / hertz.pressure(grid.x(20).hypot(grid.y(18))) - 1.0).abs())
    /// };
    /// assert!(error(CellValue::Uniform)? > 7e-4);
    /// assert!(error(CellValue::Centre)? < 3e-5);
    /// # Ok::<(), Error>(())
    /// ```
    ///
    /// # Errors
    /// - [`Error::NotPositive`] and [`Error::Memory`] as for [`HalfSpace::new`].
    /// - [`Error::Ranks`] if the ranks fail or their arguments differ.
    pub fn with_cell_value(self, cell_value: CellValue) -> Result<Self> {
        self.collective_result_checked(Ok(()), &[("cell value", &cell_value)])?;
        let boundary = self.boundary();
        if cell_value == self.cell_value() || boundary == Boundary::Periodic {
            return Ok(self);
        }
        let Shared {
            grid, team, share, ..
        } = &*self.shared;
        let grid = grid.whole();
        let added = self.shared.kernels.added();
        let samples = match share {
            Some(_) => None,
            None => samples(grid, boundary, cell_value, grid.size(), (None, added))?.map(Arc::new),
        };
        let made = (samples, added.cloned());
        let kernels = CellKernels::new(grid, self.kernel(), boundary, cell_value, made);
        Ok(Self::of_kernels(kernels, (team.clone(), share.clone())))
    }

    fn of_kernels(
        kernels: CellKernels,
        (team, share): (Option<Arc<RankGroup>>, Option<Arc<RowPartition>>),
    ) -> Self {
        let grid = kernels.grid();
        let slab = share
            .as_ref()
            .map_or(grid, |share| grid.slab(share.local_rows()));
        Self {
            shared: Arc::new(Shared {
                grid: slab,
                team,
                share,
                kernels,
                made: Cache::default(),
                coarser: OnceLock::new(),
            }),
        }
    }

    /// Returns the grid. For [distributed](Self::distributed) bodies, returns the slab that this rank stores.
    #[must_use]
    pub fn grid(&self) -> Grid {
        self.shared.grid
    }

    /// Returns the two bodies. For a [`kernel::Kernel`], returns the [pair](kernel::Kernel::pair) that represents it.
    #[must_use]
    pub fn pair(&self) -> &ElasticPair {
        self.shared.kernels.pair()
    }

    pub(crate) fn kernel(&self) -> &kernel::Kernel {
        self.shared.kernels.bodies()
    }

    /// Returns the boundary of the grid.
    #[must_use]
    pub fn boundary(&self) -> Boundary {
        self.shared.kernels.boundary()
    }

    /// Returns the interpretation of cell values. On a grid with [`Boundary::Periodic`] it is always [`CellValue::Centre`].
    #[must_use]
    pub fn cell_value(&self) -> CellValue {
        self.shared.kernels.cell_value()
    }

    /// Returns the operator of one component on the whole grid, which the first call creates.
    ///
    /// # Errors
    /// - All errors of [`Table::sample`](crate::influence::Table::sample).
    /// - [`Error::Ranks`] if the ranks of [distributed](Self::distributed) bodies fail.
    /// - [`Error::IncompleteKernel`] if a table or user-defined operators do not have the directions.
    pub fn operator(&self, component: Component) -> Result<ElasticOperator> {
        self.operator_of([[component]], self.size())
    }

    /// Returns the circulant preconditioner of one component on the whole grid. Returns `None` for components other than `XX`,
    /// `YY` and `ZZ`, because they are not compliances.
    ///
    /// # Errors
    /// Returns the errors of [`HalfSpace::operator`].
    pub fn preconditioner(&self, component: Component) -> Result<Option<ElasticPreconditioner>> {
        let direction = match component {
            Component::XX => Direction::X,
            Component::YY => Direction::Y,
            Component::ZZ => Direction::Z,
            _ => return Ok(None),
        };
        self.tensor_preconditioner([direction]).map(Some)
    }

    /// Returns the operator of several directions on the whole grid, which the first call creates. The operator maps tractions
    /// along all of these directions to displacements along the same directions,
    ///
    /// ```math
    /// u_i = \sum_j C_{ij} * t_j .
    /// ```
    ///
    /// By Betti's reciprocity the operator is symmetric. The odd coefficients satisfy $`C_{xz}(x) = C_{zx}(-x)`$. One product
    /// costs N forward and N inverse transforms. The documentation of [`HalfSpace`] states the memory.
    ///
    /// ```
    /// use stickslip::influence::Direction::{X, Y, Z};
    /// use stickslip::{ElasticPair, Grid, HalfSpace, Material, Operator};
    /// let pair = ElasticPair::new(Material::new(1.0, 0.2)?, Material::rigid())?;
    /// let bodies = HalfSpace::new(Grid::new(7, 5, 1.0, 1.0)?, pair)?;
    /// let compliance = bodies.tensor_operator([X, Y, Z])?;
    ///
    /// // The displacement along z due to a force along x equals the displacement along x due to a force along z.
    /// let mut scratch = compliance.scratch()?;
    /// let mut moved = |cell: usize, pulled: usize, seen: usize, at: usize| {
    ///     let (mut t, mut u) = ([[0.0; 35]; 3], [[0.0; 35]; 3]);
    ///     t[pulled][cell] = 1.0;
    ///     let out = u.each_mut().map(|u| &mut u[..]);
    ///     compliance.apply(t.each_ref().map(|t| &t[..]), out, &mut scratch);
    ///     u[seen][at]
    /// };
    /// let (there, back) = (moved(8, 0, 2, 26), moved(26, 2, 0, 8));
    /// assert!(there.abs() > 0.01 && (there - back).abs() < 1e-15);
    /// # Ok::<(), stickslip::Error>(())
    /// ```
    ///
    /// # Errors
    /// - [`Error::RepeatedDirection`] if a direction occurs twice.
    /// - All errors of [`HalfSpace::operator`].
    pub fn tensor_operator<const N: usize>(
        &self,
        directions: [Direction; N],
    ) -> Result<ElasticOperator<N>> {
        check_distinct(&directions)?;
        self.operator_of(tensor(directions), self.size())
    }

    /// Returns the circulant preconditioner of the [operator](Self::tensor_operator) of several directions.
    ///
    /// # Errors
    /// Returns the errors of [`HalfSpace::tensor_operator`].
    pub fn tensor_preconditioner<const N: usize>(
        &self,
        directions: [Direction; N],
    ) -> Result<ElasticPreconditioner<N>> {
        check_distinct(&directions)?;
        let Compliance { inverse, .. } = self.compliance(directions, self.size())?;
        Ok(inverse)
    }

    /// Returns whether the kernels are kept for other operators. The kernels of a large grid would take too much memory
    /// for the time that they save.
    fn keeps_kernels(&self) -> bool {
        self.shared.share.is_none() && self.grid().cells() <= KEPT_CELLS
    }

    /// Applies `make` to the kernels of these components on `size` cells. Returns an error if this fails on any rank.
    fn with_kernels<T, const N: usize>(
        &self,
        components: [[Component; N]; N],
        size: [usize; 2],
        make: impl FnOnce([[&InfluenceKernel; N]; N]) -> Result<T>,
    ) -> Result<T> {
        let Shared { grid, kernels, .. } = &*self.shared;
        let (boundary, cell_value) = (self.boundary(), self.cell_value());
        self.run_collectively(|| {
            if self.keeps_kernels() || boundary == Boundary::Periodic {
                return make(self.collective_result(kernels.of(components))?);
            }
            let grid = grid.whole();
            let (sharing, added) = (self.sharing(), kernels.added());
            let samples = samples(grid, boundary, cell_value, size, (sharing, added));
            let made = (
                self.collective_result(samples)?.map(Arc::new),
                added.cloned(),
            );
            let kernels = CellKernels::new(grid, self.kernel(), boundary, cell_value, made);
            make(self.collective_result(kernels.of(components))?)
        })
    }

    /// Returns the approximate displacement of a cell under a unit pressure on it.
    pub(crate) fn cell_compliance(&self) -> f64 {
        cell_compliance(self.grid(), self.pair())
    }

    /// Checks that a quantity has the same interpretation of cell values as these bodies.
    pub(crate) fn check_values(&self, quantity: &'static str, cell_value: CellValue) -> Result<()> {
        if cell_value == self.cell_value() {
            Ok(())
        } else {
            Err(Error::CellValueMismatch { quantity })
        }
    }

    /// Returns an error if a solution was computed for another pair of bodies.
    pub(crate) fn check_pair(&self, quantity: &'static str, pair: &ElasticPair) -> Result<()> {
        if pair == self.pair() {
            Ok(())
        } else {
            Err(Error::MaterialMismatch { quantity })
        }
    }

    /// Checks that a quantity belongs to the grid and boundary of these bodies.
    pub(crate) fn check_host(
        &self,
        quantity: &'static str,
        grid: Grid,
        boundary: Boundary,
    ) -> Result<()> {
        self.grid().check_equal(quantity, grid)?;
        if boundary == self.boundary() {
            Ok(())
        } else {
            Err(Error::BoundaryMismatch { quantity })
        }
    }

    /// Returns the axes along which contacts are solved on the whole grid. These are the periodic axes. User-defined operators
    /// are defined only on all cells, so the result for them is both axes.
    fn spanned(&self) -> [bool; 2] {
        match self.kernel().user_operators() {
            Some(_) => [true; 2],
            None => self.boundary().repeats(),
        }
    }

    /// Extends the window to the whole grid along axes that are not cut. The contact of the window is solved on the
    /// result.
    pub(crate) fn restrict_to_window(&self, window: Window) -> Window {
        window.spanning(self.grid(), self.spanned())
    }

    /// Returns the window in which a contact is solved before a check on the whole grid. The result is the whole grid if the
    /// window would save too little work.
    pub(crate) fn place(&self, window: Window) -> Window {
        let (window, whole) = (self.restrict_to_window(window), Window::whole(self.grid()));
        let saves_little = 5 * window.cells() > 4 * whole.cells();
        if saves_little { whole } else { window }
    }

    pub(crate) fn size(&self) -> [usize; 2] {
        self.shared.grid.whole().size()
    }
}

/// Returns the approximate displacement of a cell under a unit pressure on it.
fn cell_compliance(grid: Grid, pair: &ElasticPair) -> f64 {
    grid.cell_area().sqrt() / pair.contact_modulus()
}

/// Checks that a grid may have this boundary. Also checks that the memory for a contact of the given number of cells is
/// available.
fn check(grid: Grid, kernel: &kernel::Kernel, boundary: Boundary, cells: [usize; 2]) -> Result<()> {
    memory("a contact of all cells", cells, BYTES_PER_CELL)?;
    let pair = kernel.pair();
    has_squares(
        "the cell side divided by the contact modulus",
        cell_compliance(grid, pair),
        "choose different units of length or pressure",
    )?;
    let bodies = pair.bodies();
    for layer in bodies.iter().flat_map(Material::layers) {
        kernel::check_thickness(layer.thickness(), grid)?;
    }
    if let Boundary::PeriodicAlongY { datum } = boundary {
        let length = grid.dx() * grid.nx() as f64;
        finite("distance of the datum", datum)?;
        at_least(
            "the length of the grid along x",
            length,
            "distance of the datum",
            datum,
        )?;
    }
    kernel.check_on(grid, boundary)
}

/// Checks that no direction occurs twice.
fn check_distinct(directions: &[Direction]) -> Result<()> {
    let occurs_before = |k: usize| directions[..k].contains(&directions[k]);
    if (0..directions.len()).any(occurs_before) {
        return Err(Error::RepeatedDirection);
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::bodies::material::Material;
    use crate::operator::Operator;

    /// The product of both tractions is the sum of the products of each traction alone. The inverse is exact if nothing
    /// is cut.
    #[test]
    fn products_in_the_plane_are_sums_of_products_along_the_axes() {
        let body = Material::new(1.0, 0.4).unwrap();
        let pair = ElasticPair::new(body, Material::rigid()).unwrap();
        for (nx, ny) in [(12, 9), (7, 16), (1, 5), (8, 8)] {
            for boundary in [Boundary::NonPeriodic, Boundary::Periodic] {
                let grid = Grid::new(nx, ny, 0.5, 0.7).unwrap();
                let bodies = HalfSpace::with_boundary(grid, pair, boundary).unwrap();
                let cells = nx * ny;
                let sample = |i: usize| ((7 * i * i + 3 * i) % 11) as f64 - 5.0;
                let traction: Vec<f64> = (0..2 * cells).map(sample).collect();
                let operator = bodies
                    .tensor_operator([Direction::X, Direction::Y])
                    .unwrap();
                let (mut exact, mut rough) = (vec![0.0; 2 * cells], vec![0.0; 2 * cells]);
                let mut scratch = operator.scratch().unwrap();
                let both = || traction.split_at(cells).into();
                operator.apply(both(), exact.split_at_mut(cells).into(), &mut scratch);
                operator.apply_f32(both(), rough.split_at_mut(cells).into(), &mut scratch);
                let alone = |component: Component, q: &[f64]| {
                    let operator = bodies.operator(component).unwrap();
                    let mut u = vec![0.0; cells];
                    operator.apply([q], [&mut u], &mut operator.scratch().unwrap());
                    u
                };
                let (x, y) = traction.split_at(cells);
                let parts = [
                    [alone(Component::XX, x), alone(Component::XY, y)],
                    [alone(Component::YX, x), alone(Component::YY, y)],
                ];
                let largest = exact.iter().fold(0.0, |a: f64, u| a.max(u.abs()));
                for i in 0..2 * cells {
                    let [a, b] = &parts[i / cells];
                    let expected = a[i % cells] + b[i % cells];
                    assert!((exact[i] - expected).abs() <= 1e-14 * largest);
                    assert!((rough[i] - expected).abs() <= 2e-6 * largest);
                }
                // x'Cx is at least the bound times x'x. The mean of x is subtracted if a uniform traction causes no
                // displacement.
                let mean = |q: &[f64]| q.iter().sum::<f64>() / cells as f64;
                let means = [mean(x), mean(y)];
                let is_free = boundary == Boundary::NonPeriodic;
                let squares: f64 = (0..2 * cells)
                    .map(|i| (traction[i] - if is_free { 0.0 } else { means[i / cells] }).powi(2))
                    .sum();
                let energy: f64 = exact.iter().zip(&traction).map(|(u, q)| u * q).sum();
                assert!(energy >= operator.lower_bound() * squares * (1.0 - 1e-12));
                assert!(operator.lower_bound() > 0.0);
            }
        }
    }
}
