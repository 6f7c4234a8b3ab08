//! State of a distributed contact, assembled from the slabs of any number of ranks.

use crate::error::{Error, RankFailure, Result};
use crate::grid::Grid;
use crate::grid::window::Window;
use crate::half_space::HalfSpace;
use crate::history::saved::codec::Writer;
use crate::history::state::State;
use crate::memory::fallible::unwrap_or_abort;
use crate::parallel::ranks::WireFormat;
use crate::support::checksum;

impl State {
    /// Assembles the state of the local cells of these bodies from slabs. The slabs are the states of any number of
    /// ranks, in any order, or the state of the whole grid. Slabs without local rows may be omitted. The call is
    /// collective.
    ///
    /// # Errors
    /// - The first error among the slabs.
    /// - [`Error::GridMismatch`], [`Error::BoundaryMismatch`] or [`Error::MaterialMismatch`] if a slab belongs to other
    ///   bodies.
    /// - [`Error::Ranks`] with [`RankFailure::MissingSlab`] if a row is missing, or with [`RankFailure::InconsistentSlabs`] if
    ///   the slabs were not saved together.
    ///
    /// ```
    /// use std::{sync::Arc, time::Duration};
    /// use stickslip::{*, history::State, ranks::Threads};
    /// let grid = Grid::square(32, 8.0)?;
    /// let pair = ElasticPair::new(Material::new(1.0, 0.5)?, Material::rigid())?;
    /// let boundary = Boundary::NonPeriodic;
    /// let press = LoadStep::hold().normal(NormalLoad::Force(0.5));
    /// let slide = LoadStep::force([0.1, 0.0]);
    /// let patience = Duration::from_secs(60);
    ///
    /// // Three ranks start and save their slabs.
    /// let slabs = Threads::run(3, patience, |rank| {
    ///     let bodies = HalfSpace::distributed(grid, pair, boundary, Arc::new(rank))?;
    ///     let ball = surface::sphere(bodies.grid(), 10.0)?;
    ///     let mut history = History::builder(&bodies, &ball, Friction::coulomb(0.3)?).build()?;
    ///     history.step(&press)?;
    ///     Ok::<_, Error>(history.to_bytes())
    /// });
    /// let slabs = slabs.into_iter().collect::<Result<Vec<_>, _>>()?;
    ///
    /// // Two ranks continue, and so does a single process, with bitwise identical results.
    /// let states = || slabs.iter().map(|bytes| State::from_bytes(bytes));
    /// let shifts = Threads::run(2, patience, |rank| {
    ///     let bodies = HalfSpace::distributed(grid, pair, boundary, Arc::new(rank))?;
    ///     let mut history = History::from_state(&bodies, State::from_slabs(&bodies, states())?)?;
    ///     Ok::<_, Error>(history.step(&slide)?.shift())
    /// });
    /// let bodies = HalfSpace::new(grid, pair)?;
    /// let mut history = History::from_state(&bodies, State::from_slabs(&bodies, states())?)?;
    /// let alone = history.step(&slide)?.shift();
    /// for shift in shifts {
    ///     assert_eq!(shift?, alone);
    /// }
    /// # Ok::<(), Error>(())
    /// ```
    pub fn from_slabs(
        bodies: &HalfSpace,
        slabs: impl IntoIterator<Item = Result<Self>>,
    ) -> Result<Self> {
        let mut state = bodies.collective_result(assemble(bodies, slabs))?;
        state.gather_whole(bodies);
        bodies.joint(Ok(state))
    }

    /// Copies the local rows of a slab.
    fn take_rows(&mut self, slab: &Self) {
        let (grid, from) = (self.grid(), slab.grid());
        for quantity in slab.cell_quantities(true) {
            let window = slab.window_of(quantity);
            let (own, found) = (self.values_mut(quantity), slab.values(quantity));
            copy_rows(window, (grid, own), (from, found));
        }
        let whole = Window::whole(grid);
        copy_rows(whole, (grid, &mut self.zones), (from, &slab.zones));
    }

    /// Returns a checksum of all values outside the cells, which the slabs of one state have in common. Returns zero if the
    /// bodies are not distributed.
    pub(in crate::history) fn digest_on(&self, bodies: &HalfSpace) -> u64 {
        if bodies.is_shared() { self.digest() } else { 0 }
    }

    /// Returns a checksum of the numbers that distinguish the states of one history. Returns zero if the bodies are not
    /// distributed.
    pub(in crate::history) fn numbers_on(&self, bodies: &HalfSpace) -> u64 {
        if !bodies.is_shared() {
            return 0;
        }
        let mut words = vec![self.steps];
        (self.force, self.moment).write(&mut words);
        (self.motion.shift, self.motion.twist).write(&mut words);
        (self.approach(), self.settings.tolerance).write(&mut words);
        let window = self.contact.as_ref().map(|memory| memory.window);
        (self.press_window, window).write(&mut words);
        let bytes = words.into_iter().flat_map(u64::to_le_bytes);
        checksum::of_bytes(&bytes.collect::<Vec<_>>())
    }

    fn digest(&self) -> u64 {
        let mut writer = Writer::default();
        let outline = self.outline_on(self.grid().whole().slab(0..0));
        // Slabs of one state may differ in this mark.
        unwrap_or_abort(outline.and_then(|mut outline| outline.visit(&mut writer, &mut false)));
        checksum::of_bytes(&writer.0)
    }
}

fn assemble(bodies: &HalfSpace, slabs: impl IntoIterator<Item = Result<State>>) -> Result<State> {
    let grid = bodies.grid();
    let mut found: Option<(State, u64)> = None;
    let mut is_missing = vec![true; grid.ny()];
    for slab in slabs {
        let slab = slab?;
        slab.check_origin(bodies)?;
        let rows = slab.grid().rows();
        let state = match &mut found {
            Some((_, digest)) if *digest != slab.digest() => {
                return Err(Error::Ranks(RankFailure::InconsistentSlabs {
                    row: rows.start,
                }));
            }
            Some((state, _)) => state,
            none => {
                let digest = slab.digest();
                &mut none.insert((slab.outline_on(grid)?, digest)).0
            }
        };
        state.take_rows(&slab);
        for (row, is_missing) in grid.rows().zip(&mut is_missing) {
            *is_missing &= !rows.contains(&row);
        }
    }
    let first = grid.rows().start;
    let missing = is_missing.iter().position(|is_missing| *is_missing);
    let missing = missing.map(|row| RankFailure::MissingSlab { row: first + row });
    match (found, missing) {
        (Some((state, _)), None) => Ok(state),
        (_, missing) => Err(Error::Ranks(
            missing.unwrap_or(RankFailure::MissingSlab { row: first }),
        )),
    }
}

/// Copies the rows of a window that both slabs contain.
fn copy_rows<T: Copy>(
    window: Window,
    (to_grid, to): (Grid, &mut [T]),
    (from_grid, from): (Grid, &[T]),
) {
    let rows = |grid: Grid| {
        let [columns, rows] = window.held(grid).ranges();
        let first = grid.rows().start;
        (columns.len(), first + rows.start..first + rows.end)
    };
    let ((columns, own), (_, others)) = (rows(to_grid), rows(from_grid));
    let (start, end) = (own.start.max(others.start), own.end.min(others.end));
    if start < end {
        let place = |row: usize, first: usize| (row - first) * columns;
        let source = &from[place(start, others.start)..place(end, others.start)];
        to[place(start, own.start)..place(end, own.start)].copy_from_slice(source);
    }
}
