//! How what lies on the grid, or on windows of it, is dealt out to ranks; without ranks all of it is here.

use std::ops::ControlFlow;
use std::sync::Arc;

use crate::bodies::kernel::Kernel;
use crate::error::Result;
use crate::grid::Grid;
use crate::grid::boundary::Boundary;
use crate::grid::cell_value::CellValue;
use crate::grid::field::Field;
use crate::grid::window::Window;
use crate::half_space::coefficients::Kernels;
use crate::half_space::{HalfSpace, check};
use crate::influence::KernelCorrection;
use crate::parallel::layout::Layout;
use crate::parallel::ranks::partition::RowPartition;
use crate::parallel::ranks::{CommunicationStats, Input, RankGroup, Ranks, WireFormat};

impl HalfSpace {
    /// The pair meshed by `grid`, whose rows are dealt out to ranks: every rank calls this alike, and holds a slab of the
    /// rows. [`HalfSpace::grid`] is that slab; fields, problems and solutions are those of its cells, and all ranks solve
    /// together what each poses for its own. The answers have the bits of those of one process. The page of
    /// [`ranks`](crate::ranks) tells more.
    ///
    /// # Errors
    /// As [`HalfSpace::with_boundary`]; [`Error::Ranks`](crate::Error::Ranks); [`Error::UnsupportedForCoatings`](crate::Error::UnsupportedForCoatings) for
    /// operators of a user.
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
        let checked = bodies.check_no_operators("a grid that ranks share");
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
        let kernels = Kernels::new(grid, &bodies, boundary, CellValue::default(), made);
        Ok(Self::of_kernels(kernels, dealt))
    }

    /// What this rank has sent to others, all solves together; nothing of bodies that are not
    /// [distributed](Self::distributed).
    #[must_use]
    pub fn traffic(&self) -> CommunicationStats {
        self.team().map(|team| team.traffic()).unwrap_or_default()
    }

    /// The ranks that share the grid, or that all have the whole of it and do the same.
    pub(crate) fn team(&self) -> Option<&Arc<RankGroup>> {
        self.shared.team.as_ref()
    }

    /// The ranks that share the grid, if any do.
    pub(crate) fn sharing(&self) -> Option<&Arc<RankGroup>> {
        self.shared.share.as_ref().map(|share| share.team())
    }

    /// Whether ranks share the grid.
    pub(crate) fn is_shared(&self) -> bool {
        self.shared.share.is_some()
    }

    /// How `[nx, ny]` cells are dealt out, if they are.
    pub(crate) fn share(&self, size: [usize; 2]) -> Option<Arc<RowPartition>> {
        let whole = self.shared.share.as_ref()?;
        Some(if whole.size() == size {
            Arc::clone(whole)
        } else {
            Arc::new(RowPartition::new(whole.team(), size))
        })
    }

    /// How the cells of a rectangle of `[nx, ny]` lie.
    pub(crate) fn layout(&self, size: [usize; 2]) -> Layout {
        match self.share(size) {
            Some(share) => Layout::shared(share),
            None => Layout::of(size),
        }
    }

    /// How the cells of the grid lie.
    pub(crate) fn grid_layout(&self) -> Layout {
        self.layout(self.size())
    }

    /// The result of a step that every rank takes by itself; an error if it failed on any.
    pub(crate) fn collective_result<T>(&self, result: Result<T>) -> Result<T> {
        RankGroup::agreed_of(self.team().map(|team| &**team), result)
    }

    /// The same of work that may agree on the way.
    pub(crate) fn run_collectively<T>(&self, work: impl FnOnce() -> Result<T>) -> Result<T> {
        match self.team() {
            Some(team) => team.run_collectively(work),
            None => work(),
        }
    }

    /// The same at the door of a call, of inputs that must be the same on all ranks; an error if any is not.
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

    /// What the first rank says of going on, for all; an error if any has one.
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

    /// The result of a step that all ranks take together: why they could not, if they have lost each other.
    pub(crate) fn joint<T>(&self, result: Result<T>) -> Result<T> {
        match self.team() {
            Some(team) => team.check().and(result),
            None => result,
        }
    }

    /// The least sample of a field of the grid.
    pub(crate) fn least(&self, field: &Field) -> f64 {
        self.over_ranks(field.min(), f64::min)
    }

    /// The largest.
    pub(crate) fn largest(&self, field: &Field) -> f64 {
        self.over_ranks(field.max(), f64::max)
    }

    pub(super) fn over_ranks<T: WireFormat>(&self, own: T, combine: impl Fn(T, T) -> T) -> T {
        RankGroup::combined_of(self.sharing().map(|team| &**team), own, combine)
    }

    /// Around all cells of the grid that are in a set, of the cells held here; `None` if none is.
    pub(crate) fn around(&self, contains: impl Fn(usize) -> bool + Sync) -> Option<Window> {
        let own = Window::around(self.grid(), contains);
        self.over_ranks(own, Window::union_of)
    }

    /// The integral of a field over the whole grid.
    pub(crate) fn integral(&self, field: &Field) -> f64 {
        field.integral_over(&self.grid_layout())
    }

    /// `Ok` for bodies that are not shared, of what ranks cannot do together.
    pub(crate) fn check_alone(&self, quantity: &'static str) -> Result<()> {
        RankGroup::check_alone(self.team().map(|team| &**team), quantity)
    }

    /// Index in the whole grid of the first cell held here.
    pub(crate) fn first_cell(&self) -> usize {
        self.grid().rows().start * self.grid().nx()
    }
}

/// Collective reductions of a field: each rank passes its slab, and all receive the same number, bitwise identical to that
/// of one process. Without ranks they equal [`Field::max`], [`Field::min`], [`Field::integral`] and [`Field::mean`].
impl HalfSpace {
    /// Largest sample of a field of the whole grid, in its units; NaN samples are ignored. See [`Field::max`].
    ///
    /// ```
    /// use std::sync::Arc;
    /// use std::time::Duration;
    /// use stickslip::ranks::Threads;
    /// use stickslip::surface::SelfAffine;
    /// use stickslip::{Boundary, ElasticPair, Grid, HalfSpace, Material};
    /// // Heights to a gap that just closes, on slabs.
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
    /// [`Error::GridMismatch`](crate::Error::GridMismatch); [`Error::Ranks`](crate::Error::Ranks).
    pub fn max_of(&self, field: &Field) -> Result<f64> {
        self.checked(field)?;
        let largest = self.largest(field);
        self.joint(Ok(largest))
    }

    /// Smallest sample of a field of the whole grid, in its units; NaN samples are ignored. See [`Field::min`].
    ///
    /// # Errors
    /// As [`HalfSpace::max_of`].
    pub fn min_of(&self, field: &Field) -> Result<f64> {
        self.checked(field)?;
        let least = self.least(field);
        self.joint(Ok(least))
    }

    /// Integral of a field over the whole grid, in its units times a length squared. See [`Field::integral`].
    ///
    /// # Errors
    /// As [`HalfSpace::max_of`].
    pub fn integral_of(&self, field: &Field) -> Result<f64> {
        self.checked(field)?;
        let integral = self.integral(field);
        self.joint(Ok(integral))
    }

    /// Mean of a field over the whole grid, in its units: its [integral](Self::integral_of) over the area.
    ///
    /// # Errors
    /// As [`HalfSpace::max_of`].
    pub fn mean_of(&self, field: &Field) -> Result<f64> {
        let integral = self.integral_of(field)?;
        Ok(integral / self.grid().whole().area())
    }

    pub(crate) fn checked(&self, field: &Field) -> Result<()> {
        self.collective_result(self.grid().expect("the field", field.grid()))
    }
}
