//! Changes of the gap between two solves, relative to the displacements of the contacts before and after.

use crate::cgm::reduce;
use crate::error::{Error, Result};
use crate::grid::Grid;
use crate::grid::boundary::Boundary;
use crate::grid::field::Field;
use crate::half_space::HalfSpace;
use crate::normal::NormalSolution;
use crate::parallel;
use crate::report::Status;

/// Fraction of the largest change below which a change counts as none. Wear can be interpolated or smoothed before it is added.
const NEGLIGIBLE: f64 = 1e-3;
/// Number of cells outside the contact for each of them whose gap must be unchanged in wear.
const OUTSIDE_PER_UNCHANGED: usize = 10;
/// Least fraction of the cells with a smaller gap that have slipped in wear of the wrong sign. The other cells can result from
/// smoothing.
const SLIPPED: f64 = 0.9;
/// Largest change of the gap that counts as round-off, relative to the largest gap.
const ROUND_OFF: f64 = 8.0 * f64::EPSILON;

/// Gap before loading, pressure and approach of a contact.
#[derive(Clone, Copy)]
pub(crate) struct PressedGap<'a> {
    pub(crate) bodies: &'a HalfSpace,
    pub(crate) gap: &'a Field,
    pub(crate) pressure: &'a [f64],
    pub(crate) approach: f64,
}

/// Change of the gap of contact cells after a contact.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct GapChange {
    /// Largest change of a contact cell.
    change: f64,
    /// Largest normal displacement of the contact before the change.
    displacement: f64,
}

impl GapChange {
    /// Returns the change divided by the larger displacement of the contacts before and after it. Wear can be added during an
    /// unloading, when the displacement is small.
    pub(crate) fn relative_to(self, after: PressedGap<'_>) -> f64 {
        let displacement = self.displacement.max(after.displacement());
        if displacement > 0.0 {
            self.change / displacement
        } else {
            0.0
        }
    }
}

impl PressedGap<'_> {
    /// Returns the change to another gap. A uniform change of all cells only shifts the datum of the gap and does not count.
    pub(crate) fn change_to(&self, gap: &Field) -> GapChange {
        let shift = self.shift_to(gap);
        let [plain, shifted] = [0.0, shift].map(|shift| {
            self.largest_in_contact(|i| (gap.as_slice()[i] - self.gap.as_slice()[i] - shift).abs())
        });
        GapChange {
            change: plain.min(shifted),
            displacement: self.displacement(),
        }
    }

    /// Returns the largest normal displacement due to the pressure.
    ///
    /// On a grid that is periodic along y, the displacement depends on the arbitrary datum. The force per length divided by the
    /// contact modulus then replaces it. It is 1.6 times the depth of a Hertzian contact below its edge.
    fn displacement(&self) -> f64 {
        let grid = self.bodies.grid().whole();
        if matches!(self.bodies.boundary(), Boundary::PeriodicAlongY { .. }) {
            let sum = reduce::total(&self.bodies.grid_layout(), self.pressure);
            let length = grid.ny() as f64 * grid.dy();
            return sum * grid.cell_area() / length / self.bodies.pair().contact_modulus();
        }
        self.largest_in_contact(|i| (self.approach - self.gap.as_slice()[i]).max(0.0))
    }

    /// Returns whether a change to another gap resembles wear: it has one sign and leaves cells outside the contact unchanged. A
    /// change to another surface or to another part of a surface does not. A closed contact has no cells outside.
    pub(crate) fn resembles_wear(&self, gap: &Field) -> bool {
        let layout = self.bodies.grid_layout();
        let shift = self.shift_to(gap);
        let change = |i: usize| gap.as_slice()[i] - self.gap.as_slice()[i] - shift;
        let [rise, fall] = self.rise_and_fall(gap, shift);
        let least = NEGLIGIBLE * rise.max(fall);
        let [outside, unchanged] = reduce::sum(&layout, |i| {
            let is_outside = self.pressure[i] <= 0.0;
            let is_unchanged = is_outside && change(i).abs() <= least;
            [is_outside, is_unchanged].map(usize::from)
        });
        let has_one_sign = rise.min(fall) <= least;
        outside == 0 || has_one_sign && OUTSIDE_PER_UNCHANGED * unchanged >= outside
    }

    /// Returns the number of cells whose gap decreases, if the change to another gap resembles wear of the wrong sign. Otherwise
    /// returns zero. Such a change increases the gap in no cell, and decreases it in cells that have slipped. `slip` is the length
    /// of the slip path of each cell.
    pub(crate) fn negative_wear(&self, gap: &Field, slip: &Field) -> usize {
        let layout = self.bodies.grid_layout();
        let shift = self.shift_to(gap);
        let [rise, fall] = self.rise_and_fall(gap, shift);
        let round_off = ROUND_OFF * reduce::max(&layout, |i| gap.as_slice()[i].abs());
        if rise > NEGLIGIBLE * fall || fall <= round_off {
            return 0;
        }
        let change = |i: usize| gap.as_slice()[i] - self.gap.as_slice()[i] - shift;
        let [cells, slipped] = reduce::sum(&layout, |i| {
            let decreases = change(i) < -NEGLIGIBLE * fall;
            [decreases, decreases && slip.as_slice()[i] > 0.0].map(usize::from)
        });
        if slipped as f64 >= SLIPPED * cells as f64 {
            cells
        } else {
            0
        }
    }

    /// Returns the largest increase and the largest decrease of the gap to another gap, apart from a uniform shift.
    fn rise_and_fall(&self, gap: &Field, shift: f64) -> [f64; 2] {
        let layout = self.bodies.grid_layout();
        let change = |i: usize| gap.as_slice()[i] - self.gap.as_slice()[i] - shift;
        [1.0, -1.0].map(|sign: f64| reduce::max(&layout, |i| (sign * change(i)).max(0.0)))
    }

    /// Returns the change of the gap of the first cell outside the contact, or the mean change of a closed contact.
    fn shift_to(&self, gap: &Field) -> f64 {
        let layout = self.bodies.grid_layout();
        let change = |i: usize| gap.as_slice()[i] - self.gap.as_slice()[i];
        let outside = |i: usize| (self.pressure[i] <= 0.0).then(|| change(i));
        reduce::first(&layout, outside).unwrap_or_else(|| {
            let [sum, cells] = reduce::sum(&layout, |i| [change(i), 1.0]);
            sum / cells
        })
    }

    fn largest_in_contact(&self, of: impl Fn(usize) -> f64 + Sync) -> f64 {
        reduce::max(&self.bodies.grid_layout(), |i| {
            if self.pressure[i] > 0.0 { of(i) } else { 0.0 }
        })
    }
}

/// Cell whose gap under load differs from its gap before loading.
#[derive(Debug, Clone, Copy)]
pub(crate) struct LoadedCell {
    cell: usize,
    gap: f64,
}

impl LoadedCell {
    /// Finds such a cell outside the contact among the local cells. Returns `None` without contact.
    pub(crate) fn of(solution: &NormalSolution, initial: &Field) -> Option<Self> {
        let [pressure, loaded] = [solution.pressure(), solution.gap()].map(Field::as_slice);
        if solution.force() <= 0.0 {
            return None;
        }
        let is_loaded =
            |i: &usize| pressure[*i] <= 0.0 && (loaded[*i] - initial.as_slice()[*i]) != 0.0;
        let cell = (0..loaded.len()).find(is_loaded)?;
        let gap = loaded[cell];
        Some(Self { cell, gap })
    }

    /// Returns an error if a gap is equal to the gap under load.
    pub(crate) fn check_differs(self, gap: &Field) -> Result<()> {
        let difference = gap.as_slice()[self.cell] - self.gap;
        if difference == 0.0 {
            return Err(Error::GapUnderLoad);
        }
        Ok(())
    }
}

/// Gap of the last solve of a solver whose gap can change.
#[derive(Debug, Clone)]
pub(crate) struct LastGap {
    /// Gap of the last solve, if the gap has changed since. Otherwise a buffer.
    gap: Field,
    has_changed: bool,
    /// Change before a solve that did not converge.
    pending: GapChange,
    loaded: Option<LoadedCell>,
}

impl LastGap {
    /// Allocates the buffer.
    pub(crate) fn new(grid: Grid) -> Result<Self> {
        Ok(Self {
            gap: Field::try_zeros(grid)?,
            has_changed: false,
            pending: GapChange::default(),
            loaded: None,
        })
    }

    /// Returns an error if a new gap is the gap under load of the last solution.
    pub(crate) fn check(&self, gap: &Field) -> Result<()> {
        self.loaded.map_or(Ok(()), |cell| cell.check_differs(gap))
    }

    /// Stores the gap of the last solve before it changes. Later changes before the next solve do not replace it.
    pub(crate) fn store(&mut self, gap: &Field) {
        if !self.has_changed {
            parallel::copy(gap.as_slice(), self.gap.as_mut_slice());
            self.has_changed = true;
        }
    }

    /// Returns the change of the gap since the last solve if it resembles wear, or a larger change before a solve that did not
    /// converge. The pressure and the approach are those of the last solve, or `None` if there was none. The next change is
    /// relative to the present gap.
    pub(crate) fn take_wear(
        &mut self,
        bodies: &HalfSpace,
        present: &Field,
        last: Option<(&[f64], f64)>,
    ) -> GapChange {
        self.loaded = None;
        let has_changed = std::mem::take(&mut self.has_changed);
        let pending = std::mem::take(&mut self.pending);
        let Some((pressure, approach)) = last.filter(|_| has_changed) else {
            return pending;
        };
        let last = PressedGap {
            bodies,
            gap: &self.gap,
            pressure,
            approach,
        };
        if !last.resembles_wear(present) {
            return pending;
        }
        let change = last.change_to(present);
        if change.change > pending.change {
            change
        } else {
            pending
        }
    }

    /// Keeps a change for the next solve, because this solve ended without an iterate.
    pub(crate) fn postpone(&mut self, change: GapChange) {
        self.pending = change;
    }

    /// Writes the change to the solution of the next solve. A solution that has not converged also leaves it to the next solve.
    pub(crate) fn finish(
        &mut self,
        (bodies, gap): (&HalfSpace, &Field),
        change: GapChange,
        solution: &mut NormalSolution,
    ) {
        if solution.report().status != Status::Converged {
            self.postpone(change);
        }
        self.loaded = LoadedCell::of(solution, gap);
        let after = PressedGap {
            bodies,
            gap,
            pressure: solution.pressure().as_slice(),
            approach: solution.approach(),
        };
        solution.set_wear(change.relative_to(after));
    }
}
