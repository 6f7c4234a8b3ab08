//! Rows of the transposed linear problem, which determine the multipliers of a functional.

use crate::cgm::cone::N;
use crate::cgm::cone::cell_state::{CellKind, ConeCellState, EntryLag};
use crate::cgm::law::state::Row;
use crate::numerics::cell_vector::{dot, plus};

/// State of a cell whose row is the transpose of the row of a [`ConeCellState`]. Its [`extend`](Row::extend) is the
/// transpose of [`restrict`](Row::restrict) of that state, and the reverse.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct TransposedState(pub(crate) ConeCellState);

impl Row<N> for TransposedState {
    const HAS_LAG: bool = true;
    const FREE: Self = Self(ConeCellState::FREE);
    const FIXED: Self = Self(ConeCellState::FIXED);

    fn moves(self) -> bool {
        self.0.moves()
    }

    fn is_free(self) -> bool {
        self.0.is_free()
    }

    fn extend(self, v: [f64; N]) -> [f64; N] {
        match self.0.kind {
            CellKind::Slip(slip) => {
                let [x, y] = slip.tangent().map(|t| v[1] * t);
                [self.0.pressed(v[0]), x, y]
            }
            // The other maps are projections.
            _ => self.0.restrict(v),
        }
    }

    fn restrict(self, w: [f64; N]) -> [f64; N] {
        match self.0.kind {
            CellKind::Slip(slip) => {
                let grown = slip.slope * dot(slip.normal, [w[1], w[2]]);
                let along = dot(slip.tangent(), [w[1], w[2]]);
                [self.0.pressed(w[0] + grown), along, 0.0]
            }
            _ => self.0.restrict(w),
        }
    }

    fn bend(self, v: [f64; N]) -> [f64; N] {
        self.0.bend(v)
    }

    fn lag(self, [_, x, y]: [f64; N]) -> [f64; N] {
        let EntryLag {
            own,
            deviator: [a, b],
            ratio,
        } = self.0.lag;
        let lag = plus([own * x, own * y], 1.0, [a * x + b * y, b * x - a * y]);
        [-dot(ratio, lag), lag[0], lag[1]]
    }

    fn weighted(self, r: [f64; N]) -> [f64; N] {
        self.0.weighted(r)
    }

    fn preconditioned(self, answer: [f64; N], r: [f64; N]) -> [f64; N] {
        self.0.preconditioned(answer, r)
    }
}
