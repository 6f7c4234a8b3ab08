//! How what lies on the grid, or on windows of it, is dealt out to ranks; without ranks all of it is here.

use std::ops::Range;
use std::sync::Arc;

use crate::contact_map::Bits;
use crate::error::{Error, Result};
use crate::field::Field;
use crate::half_space::HalfSpace;
use crate::layout::Layout;
use crate::ranks::{Team, Traffic, Words};
use crate::share::Share;
use crate::window::{Window, coarsened, halved, inherited, refined};

/// Coarser grids of no more cells than this every rank solves by itself: messages would take longer.
const ALONE: usize = 1 << 16;

impl HalfSpace {
    /// What this rank has sent to others, all solves together; nothing of bodies that are not
    /// [distributed](Self::distributed).
    #[must_use]
    pub fn traffic(&self) -> Traffic {
        self.team().map(|team| team.traffic()).unwrap_or_default()
    }

    /// The ranks that share the grid, if any do.
    pub(super) fn team(&self) -> Option<&Arc<Team>> {
        self.shared.share.as_ref().map(|share| share.team())
    }

    /// Those that share a coarser grid.
    pub(super) fn team_of_coarser(&self, [nx, ny]: [usize; 2]) -> Option<Arc<Team>> {
        self.team().filter(|_| nx * ny > ALONE).cloned()
    }

    /// How `[nx, ny]` cells are dealt out, if they are.
    pub(crate) fn share(&self, size: [usize; 2]) -> Option<Arc<Share>> {
        let whole = self.shared.share.as_ref()?;
        Some(if whole.size() == size {
            Arc::clone(whole)
        } else {
            Arc::new(Share::new(whole.team(), size))
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
    pub(crate) fn agreed<T>(&self, result: Result<T>) -> Result<T> {
        match self.team() {
            Some(team) => team.agreed(result),
            None => result,
        }
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

    fn over_ranks<T: Words>(&self, own: T, combine: impl Fn(T, T) -> T) -> T {
        match self.team() {
            Some(team) => team.combined(own, combine),
            None => own,
        }
    }

    /// Around all cells of the grid that are in a set, of the cells held here; `None` if none is.
    pub(crate) fn around(&self, contains: impl Fn(usize) -> bool + Sync) -> Option<Window> {
        let own = Window::around(self.grid(), contains);
        self.over_ranks(own, Window::union_of)
    }

    /// The cells of the whole grid that are in a set, of the cells held here; `None` without ranks.
    pub(crate) fn bits_of_all(&self, contains: impl Fn(usize) -> bool) -> Option<Bits> {
        let share = self.shared.share.as_ref()?;
        let nx = self.grid().nx();
        let own = (0..self.grid().ny()).flat_map(|row| {
            let contains = &contains;
            (0..nx).step_by(64).map(move |first| {
                let columns = (first..nx.min(first + 64)).rev();
                columns.fold(0, |word, column| {
                    (word << 1) | u64::from(contains(row * nx + column))
                })
            })
        });
        let own: Vec<u64> = own.collect();
        let words = |rank: usize| share.rows_of(rank).len() * nx.div_ceil(64);
        let counts: Vec<usize> = (0..share.team().size()).map(words).collect();
        let all = share.team().gather(&own, &counts);
        let all = all.unwrap_or_else(|| vec![0; counts.iter().sum()]);
        Some(Bits::new(all, nx))
    }

    /// The integral of a field over the whole grid.
    pub(crate) fn integral(&self, field: &Field) -> f64 {
        let samples = field.as_slice();
        let leaf = |range: Range<usize>| samples[range].iter().fold(0.0, |sum, x| sum + x);
        self.grid().cell_area() * self.grid_layout().fold(leaf, |a, b| a + b)
    }

    /// `Ok` for bodies that are not shared, of what ranks cannot do together.
    pub(crate) fn check_alone(&self, quantity: &'static str) -> Result<()> {
        match self.team() {
            Some(_) => Err(Error::Distributed { quantity }),
            None => Ok(()),
        }
    }

    /// Index in the whole grid of the first cell held here.
    pub(crate) fn first_cell(&self) -> usize {
        self.grid().rows().start * self.grid().nx()
    }

    /// A field of `[nx, ny]` cells on the cells of [`Self::coarser`].
    pub(crate) fn coarsened(
        &self,
        coarser: &Self,
        [nx, ny]: [usize; 2],
        field: &[f64],
    ) -> Vec<f64> {
        let Some(fine) = self.share([nx, ny]) else {
            return coarsened([nx, ny], field);
        };
        let size = halved([nx, ny]);
        let coarse = coarser.share(size);
        let rows = |rank: usize| {
            let all = 0..size[1];
            let coarse = coarse.as_ref().map_or(all, |coarse| coarse.rows_of(rank));
            (2 * coarse.start).min(ny)..(2 * coarse.end).min(ny)
        };
        let own = rows(fine.team().rank());
        let found = fine.fetch(field, nx, |rank| [0..nx, rows(rank)]);
        coarsened([nx, own.len()], &found)
    }

    /// A field of the cells of [`Self::coarser`] on `[nx, ny]` cells, interpolated.
    pub(crate) fn refined(&self, coarser: &Self, size: [usize; 2], field: &[f64]) -> Vec<f64> {
        self.on_finer(coarser, size, field, refined)
    }

    /// A field of the cells of [`Self::coarser`] on `[nx, ny]` cells, each with the value of the cell that it lies in.
    pub(crate) fn inherited(&self, coarser: &Self, size: [usize; 2], field: &[f64]) -> Vec<f64> {
        self.on_finer(coarser, size, field, inherited)
    }

    /// The rows held here that a function makes of those of the coarser cells, the first of which it is told.
    fn on_finer(
        &self,
        coarser: &Self,
        [nx, ny]: [usize; 2],
        field: &[f64],
        make: impl Fn([usize; 2], Range<usize>, &[f64], usize) -> Vec<f64>,
    ) -> Vec<f64> {
        let Some(fine) = self.share([nx, ny]) else {
            return make([nx, ny], 0..ny, field, 0);
        };
        let [width, height] = halved([nx, ny]);
        // The coarse cells next to those of the rows too.
        let rows = |rank: usize| {
            let fine = fine.rows_of(rank);
            if fine.is_empty() {
                return 0..0;
            }
            (fine.start / 2).saturating_sub(1)..(fine.end / 2 + 1).min(height)
        };
        let own = fine.own_rows();
        match coarser.share([width, height]) {
            Some(coarse) => {
                let found = coarse.fetch(field, width, |rank| [0..width, rows(rank)]);
                make(
                    [nx, ny],
                    own.clone(),
                    &found,
                    rows(fine.team().rank()).start,
                )
            }
            None => make([nx, ny], own, field, 0),
        }
    }
}
