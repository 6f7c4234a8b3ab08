//! Which cells lie in a set, and which of these have all their neighbours in it.

use crate::buffer;
use crate::error::Result;
use crate::grid::Grid;
use crate::neighbours::neighbours;
use crate::parallel;

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum State {
    Outside,
    /// Outside, with a cell of the set beside it or at a corner.
    Beside,
    /// In the set, with a neighbour that is not.
    Border,
    /// In the set with all its neighbours.
    Core,
}

/// The states of all cells of a grid.
pub(super) struct States(Vec<State>);

impl States {
    pub(super) fn new(
        grid: Grid,
        repeats: [bool; 2],
        contains: impl Fn(usize) -> bool + Sync,
    ) -> Result<Self> {
        let size @ [nx, ny] = grid.size();
        let mut states = buffer::filled(State::Outside, grid.cells())?;
        let count = |next: [Option<usize>; 4]| {
            let is_in = |next: &Option<usize>| next.is_some_and(&contains);
            next.iter().filter(|next| is_in(next)).count()
        };
        // Of a cell at an edge of the grid.
        let beside_rim = |i: usize| {
            let [left, below, right, above] = neighbours(i, size, repeats);
            let of = |next: Option<usize>| {
                next.map_or([None; 4], |next| neighbours(next, size, repeats))
            };
            let ([a, _, b, _], [c, _, d, _]) = (of(below), of(above));
            [count([left, below, right, above]), count([a, b, c, d])]
        };
        parallel::rows(&mut states, nx, |row, states| {
            let first = row * nx;
            for (column, state) in states.iter_mut().enumerate() {
                let i = first + column;
                let is_inner = column > 0 && column + 1 < nx && row > 0 && row + 1 < ny;
                let next = |step: usize, back: usize| Some(i + step - back);
                let sides = || {
                    if is_inner {
                        count([next(0, 1), next(0, nx), next(1, 0), next(nx, 0)])
                    } else {
                        beside_rim(i)[0]
                    }
                };
                let corners = || {
                    if is_inner {
                        count([next(0, nx + 1), next(1, nx), next(nx, 1), next(nx + 1, 0)])
                    } else {
                        beside_rim(i)[1]
                    }
                };
                *state = match (contains(i), sides()) {
                    (true, 4) => State::Core,
                    (true, _) => State::Border,
                    (false, 0) if corners() == 0 => State::Outside,
                    (false, _) => State::Beside,
                };
            }
        });
        Ok(Self(states))
    }

    pub(super) fn is_core(&self, cell: usize) -> bool {
        self.0[cell] == State::Core
    }

    pub(super) fn core_cells(&self) -> usize {
        self.0.iter().filter(|state| **state == State::Core).count()
    }

    /// The cells at the edge of the set, by rising index.
    pub(super) fn at_edge(&self) -> impl Iterator<Item = usize> + '_ {
        let states = self.0.iter().enumerate();
        states.filter_map(|(cell, state)| {
            matches!(state, State::Beside | State::Border).then_some(cell)
        })
    }
}
