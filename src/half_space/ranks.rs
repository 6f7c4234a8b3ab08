//! Distribution of fields on the grid, or on windows of it, over ranks. Without ranks every field is local.

use std::ops::ControlFlow;
use std::sync::Arc;

use crate::bodies::kernel::Kernel;
use crate::error::Result;
use crate::grid::Grid;
use crate::grid::boundary::Boundary;
use crate::grid::cell_value::CellValue;
use crate::grid::field::Field;
use crate::grid::window::Window;
use crate::half_space::coefficients::CellKernels;
use crate::half_space::{HalfSpace, check};
use crate::influence::KernelCorrection;
use crate::parallel::layout::Layout;
use crate::parallel::ranks::partition::RowPartition;
use crate::parallel::ranks::{CommunicationStats, Input, RankGroup, Ranks, WireFormat};

impl HalfSpace {
    /// Creates the bodies on `grid` with its rows distributed over ranks. The call is collective and requires the same
    /// arguments on every rank. Each rank stores one slab of rows. [`HalfSpace::grid`] returns this slab. Fields,
    /// problems and solutions contain the cells of this slab. Each rank states the problem for its slab, and all ranks
    /// solve it together. Results are bitwise identical to the results of one process. The documentation of
    /// [`ranks`](crate::ranks) has the details.
    ///
    /// # Errors
    /// - All errors of [`HalfSpace::with_boundary`].
    /// - [`Error::Ranks`](crate::Error::Ranks) if the ranks fail or their arguments differ.
    /// - [`Error::UnsupportedForCoatings`](crate::Error::UnsupportedForCoatings) for user-defined operators.
    pub fn distributed(
        grid: Grid,
        bodies: impl Into<Kernel>,
        boundary: Boundary,
        ranks: Arc<dyn Ranks>,
    ) -> Result<Self> {
        let bodies = bodies.into();
        if ranks.size() == 1 {
            return Self::with_boundary(grid, bodies, boundary);
        }
        let team = Arc::new(RankGroup::new(ranks));
        let share = Arc::new(RowPartition::new(&team, grid.size()));
        let own = [grid.nx(), share.local_rows().len()];
        let checked = bodies.check_no_operators("a grid that is distributed over ranks");
        team.collective_result_checked(
            checked.and_then(|()| check(grid, &bodies, boundary, own)),
            &[
                ("grid", &grid),
                ("pair of bodies", bodies.pair()),
                ("boundary", &boundary),
            ],
        )?;
        let dealt = (Some(team), Some(share));
        let made = (None, KernelCorrection::of(&bodies));
        let kernels = CellKernels::new(grid, &bodies, boundary, CellValue::default(), made);
        Ok(Self::of_kernels(kernels, dealt))
    }

    /// Returns the amount of data that this rank has sent to other ranks in all solves. The amount is zero for bodies
    /// that are not [distributed](Self::distributed).
    #[must_use]
    pub fn traffic(&self) -> CommunicationStats {
        self.team().map(|team| team.traffic()).unwrap_or_default()
    }

    /// Returns the ranks that share the grid, or that each store the whole grid and perform the same work.
    pub(crate) fn team(&self) -> Option<&Arc<RankGroup>> {
        self.shared.team.as_ref()
    }

    /// Returns the ranks that share the grid, or `None` if the grid is not shared.
    pub(crate) fn sharing(&self) -> Option<&Arc<RankGroup>> {
        self.shared.share.as_ref().map(|share| share.team())
    }

    /// Returns whether ranks share the grid.
    pub(crate) fn is_shared(&self) -> bool {
        self.shared.share.is_some()
    }

    /// Returns the distribution of `[nx, ny]` cells over ranks, or `None` if the grid is not shared.
    pub(crate) fn share(&self, size: [usize; 2]) -> Option<Arc<RowPartition>> {
        let whole = self.shared.share.as_ref()?;
        Some(if whole.size() == size {
            Arc::clone(whole)
        } else {
            Arc::new(RowPartition::new(whole.team(), size))
        })
    }

    /// Returns the layout of the cells of a rectangle of `[nx, ny]` cells.
    pub(crate) fn layout(&self, size: [usize; 2]) -> Layout {
        match self.share(size) {
            Some(share) => Layout::shared(share),
            None => Layout::of(size),
        }
    }

    /// Returns the layout of the cells of the grid.
    pub(crate) fn grid_layout(&self) -> Layout {
        self.layout(self.size())
    }

    /// Returns the result of a step that every rank takes separately. If the step failed on any rank, returns an error
    /// on all ranks. This call is collective.
    pub(crate) fn collective_result<T>(&self, result: Result<T>) -> Result<T> {
        RankGroup::agreed_of(self.team().map(|team| &**team), result)
    }

    /// Returns a result like [`Self::collective_result`], for work that may contain collective calls.
    pub(crate) fn run_collectively<T>(&self, work: impl FnOnce() -> Result<T>) -> Result<T> {
        match self.team() {
            Some(team) => team.run_collectively(work),
            None => work(),
        }
    }

    /// Returns a result like [`Self::collective_result`] at the start of a call whose inputs must be equal on all ranks.
    /// Returns an error if an input differs.
    pub(crate) fn collective_result_checked<T>(
        &self,
        result: Result<T>,
        inputs: &[Input<'_>],
    ) -> Result<T> {
        match self.team() {
            Some(team) => team.collective_result_checked(result, inputs),
            None => result,
        }
    }

    /// Returns the decision of the first rank whether to continue. Returns an error if any rank has an error.
    pub(crate) fn decided(
        &self,
        ask: impl FnOnce() -> Result<ControlFlow<()>>,
    ) -> Result<ControlFlow<()>> {
        let own = self.run_collectively(ask)?;
        let Some(team) = self.team() else {
            return Ok(own);
        };
        let is_over = team.decided(own.is_break().into());
        team.check()?;
        Ok(if is_over == Some(0) {
            ControlFlow::Continue(())
        } else {
            ControlFlow::Break(())
        })
    }

    /// Returns the result of a collective step. If the ranks have lost their connection, returns this failure.
    pub(crate) fn joint<T>(&self, result: Result<T>) -> Result<T> {
        match self.team() {
            Some(team) => team.check().and(result),
            None => result,
        }
    }

    /// Returns the smallest sample of a field of the whole grid.
    pub(crate) fn least(&self, field: &Field) -> f64 {
        self.least_of(field.min())
    }

    /// Returns the smallest of the values of all ranks.
    pub(crate) fn least_of(&self, local: f64) -> f64 {
        self.over_ranks(local, f64::min)
    }

    /// Returns the largest sample of a field of the whole grid.
    pub(crate) fn largest(&self, field: &Field) -> f64 {
        self.over_ranks(field.max(), f64::max)
    }

    pub(super) fn over_ranks<T: WireFormat>(&self, own: T, combine: impl Fn(T, T) -> T) -> T {
        RankGroup::combined_of(self.sharing().map(|team| &**team), own, combine)
    }

    /// Returns the smallest window around all cells of the whole grid in a set, or `None` if the set is empty. Each
    /// rank tests its local cells.
    pub(crate) fn around(&self, contains: impl Fn(usize) -> bool + Sync) -> Option<Window> {
        let own = Window::around(self.grid(), contains);
        self.over_ranks(own, Window::union_of)
    }

    /// Returns the integral of a field over the whole grid.
    pub(crate) fn integral(&self, field: &Field) -> f64 {
        field.integral_over(&self.grid_layout())
    }

    /// Checks that no ranks share the bodies, for work that does not support ranks.
    pub(crate) fn check_alone(&self, quantity: &'static str) -> Result<()> {
        RankGroup::check_alone(self.team().map(|team| &**team), quantity)
    }

    /// Returns the index in the whole grid of the first local cell.
    pub(crate) fn first_cell(&self) -> usize {
        self.grid().rows().start * self.grid().nx()
    }
}

/// Collective reductions of a field. Each rank passes its slab, and all ranks receive the same number, bitwise
/// identical to the result of one process. Without ranks the results equal [`Field::max`], [`Field::min`],
/// [`Field::integral`] and [`Field::mean`].
impl HalfSpace {
    /// Returns the largest sample of a field of the whole grid, in the units of the field. NaN samples are ignored. See
    /// [`Field::max`].
    ///
    /// ```
    /// use std::sync::Arc;
    /// use std::time::Duration;
    /// use stickslip::ranks::Threads;
    /// use stickslip::surface::SelfAffine;
    /// use stickslip::{Boundary, ElasticPair, Grid, HalfSpace, Material};
    /// // Conversion of heights to a gap that just closes, on slabs.
    /// let pair = ElasticPair::new(Material::new(1.0, 0.3)?, Material::rigid())?;
    /// let grid = Grid::new(64, 256, 0.5, 0.5)?;
    /// let statistics = Threads::run(3, Duration::from_secs(60), |rank| {
    ///     let bodies = HalfSpace::distributed(grid, pair, Boundary::Periodic, Arc::new(rank))?;
    ///     let heights = SelfAffine::with_rms_height(0.1).generate_on(&bodies)?;
    ///     let highest = bodies.max_of(&heights)?;
    ///     let gap = heights.map(|z| highest - z);
    ///     assert_eq!(bodies.min_of(&gap)?, 0.0);
    ///     bodies.statistics(&heights)
    /// });
    /// for statistics in statistics {
    ///     assert!((statistics?.rms_height() - 0.1).abs() < 1e-12);
    /// }
    /// # Ok::<(), stickslip::Error>(())
    /// ```
    ///
    /// # Errors
    /// - [`Error::GridMismatch`](crate::Error::GridMismatch) if the field is not on the slab of this rank.
    /// - [`Error::Ranks`](crate::Error::Ranks) if the ranks fail.
    pub fn max_of(&self, field: &Field) -> Result<f64> {
        self.checked(field)?;
        let largest = self.largest(field);
        self.joint(Ok(largest))
    }

    /// Returns the smallest sample of a field of the whole grid, in the units of the field. NaN samples are ignored. See
    /// [`Field::min`].
    ///
    /// # Errors
    /// Returns the errors of [`HalfSpace::max_of`].
    pub fn min_of(&self, field: &Field) -> Result<f64> {
        self.checked(field)?;
        let least = self.least(field);
        self.joint(Ok(least))
    }

    /// Returns the integral of a field over the whole grid, in the units of the field times a length squared. See
    /// [`Field::integral`].
    ///
    /// # Errors
    /// Returns the errors of [`HalfSpace::max_of`].
    pub fn integral_of(&self, field: &Field) -> Result<f64> {
        self.checked(field)?;
        let integral = self.integral(field);
        self.joint(Ok(integral))
    }

    /// Returns the mean of a field over the whole grid, in the units of the field: its [integral](Self::integral_of)
    /// divided by the area.
    ///
    /// # Errors
    /// Returns the errors of [`HalfSpace::max_of`].
    pub fn mean_of(&self, field: &Field) -> Result<f64> {
        let integral = self.integral_of(field)?;
        Ok(integral / self.grid().whole().area())
    }

    pub(crate) fn checked(&self, field: &Field) -> Result<()> {
        self.collective_result(self.grid().check_equal("the field", field.grid()))
    }
}
