//! Classification of cells: outside, next to the set, at its border, or in its core.

use crate::error::Result;
use crate::grid::Grid;
use crate::memory::fallible;
use crate::parallel;

/// State of a cell: the number of the following conditions that hold.
/// - The cell or one of the eight cells around it is in the set.
/// - The cell itself is in the set.
/// - The cell and its four neighbours are in the set.
type State = u8;

/// State of a cell outside the set that touches the set at a side or a corner.
const BESIDE: State = 1;
/// State of a cell in the set with a neighbour outside.
const BORDER: State = 2;
/// State of a cell in the set with all its neighbours in the set.
const CORE: State = 3;

/// Number of cells that are tested together in the search for cells at the edge.
const AT_ONCE: usize = 64;

/// States of all cells of a grid.
pub(super) struct States {
    nx: usize,
    states: Vec<State>,
}

impl States {
    /// Classifies the cells for the set of cells with a positive value.
    pub(super) fn new(grid: Grid, repeats: [bool; 2], inside: &[f64]) -> Result<Self> {
        let [nx, ny] = grid.size();
        let mut is_in = fallible::filled(0, grid.cells())?;
        parallel::rows(&mut is_in, nx, |row, out| {
            for (out, value) in out.iter_mut().zip(&inside[row * nx..]) {
                *out = u8::from(*value > 0.0);
            }
        });
        let beyond = fallible::filled(0, nx)?;
        let mut states = fallible::filled(0, grid.cells())?;
        parallel::rows(&mut states, nx, |row, states| {
            let [below, above] = beside(row, ny, repeats[1]);
            let rows = [below, Some(row), above]
                .map(|row| row.map_or(&beyond[..], |row| &is_in[row * nx..][..nx]));
            let [below, middle, above] = rows.map(|row| row.windows(3));
            let inner = states.iter_mut().skip(1);
            for (((state, below), middle), above) in inner.zip(below).zip(middle).zip(above) {
                *state = state_of([below, middle, above]);
            }
            for column in [0, nx - 1] {
                let [left, right] = beside(column, nx, repeats[0]);
                let columns = [left, Some(column), right];
                let around = rows.map(|row| columns.map(|next| next.map_or(0, |next| row[next])));
                states[column] = state_of(around.each_ref().map(|row| &row[..]));
            }
        });
        Ok(Self { nx, states })
    }

    pub(super) fn is_core(&self, cell: usize) -> bool {
        self.states[cell] == CORE
    }

    /// Returns for each cell of a row whether it is a core cell.
    pub(super) fn are_core(&self, row: usize) -> impl Iterator<Item = bool> + '_ {
        let states = &self.states[row * self.nx..][..self.nx];
        states.iter().map(|state| *state == CORE)
    }

    pub(super) fn core_cells(&self) -> usize {
        let is_core = self.states.iter().map(|state| *state == CORE);
        is_core.map(usize::from).sum()
    }

    /// Returns the cells at the edge of the set, sorted by index.
    pub(super) fn at_edge(&self) -> impl Iterator<Item = usize> + '_ {
        let is_at_edge = |state: State| matches!(state, BESIDE | BORDER);
        let parts = self.states.chunks(AT_ONCE).enumerate();
        let parts = parts.filter(move |(_, part)| {
            part.iter()
                .fold(false, |any, state| any | is_at_edge(*state))
        });
        parts.flat_map(move |(part, states)| {
            let cells = (part * AT_ONCE..).zip(states);
            cells.filter_map(move |(cell, state)| is_at_edge(*state).then_some(cell))
        })
    }
}

/// Returns the state of the middle cell of 3 x 3 cells. The values are 1 for cells in the set and 0 for other cells.
fn state_of([below, middle, above]: [&[u8]; 3]) -> State {
    let any = |row: &[u8]| row[0] | row[1] | row[2];
    let is_core = middle[0] & middle[1] & middle[2] & below[1] & above[1];
    (any(below) | any(middle) | any(above)) + middle[1] + is_core
}

/// Returns the indices before and after an index along an axis. The periodic image replaces an index beyond an edge of
/// the grid. If the axis is not periodic, such an index is `None`.
pub(super) fn beside(place: usize, count: usize, repeats: bool) -> [Option<usize>; 2] {
    let before = place.checked_sub(1);
    let after = Some(place + 1).filter(|next| *next < count);
    [
        before.or(repeats.then_some(count - 1)),
        after.or(repeats.then_some(0)),
    ]
}
