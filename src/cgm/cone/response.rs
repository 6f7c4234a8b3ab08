//! States of the cells at the end of a step, fixed for the linear problem of a stiffness.

use crate::cgm::cone::cell_state::{ConeCellState, EntryLag};
use crate::cgm::cone::newton::NOTHING;
use crate::cgm::cone::{FrictionCone, N};
use crate::cgm::reduce;
use crate::grid::per_cell::PerCell;
use crate::numerics::cell_vector::at;
use crate::parallel::layout::Layout;

/// State of the cells: tractions, slip of the last step, and entry compliance. The entry compliance is empty if it is zero in all
/// cells.
#[derive(Debug, Clone, Copy)]
pub(crate) struct FrozenState<'a> {
    pub(crate) x: [&'a [f64]; N],
    pub(crate) slip: [&'a [f64]; 2],
    pub(crate) own: &'a [f64],
    /// Maximum pressure of each cell.
    pub(crate) hardness: PerCell<&'a [f64]>,
    /// Whether cells at their limits continue to slip. If not, these cells stick.
    pub(crate) slips: bool,
}

impl<'a> FrozenState<'a> {
    /// Returns the row of each cell. `self_compliance` is the displacement of a cell under a unit traction on this cell.
    pub(crate) fn rows(
        self,
        layout: &Layout,
        friction: &'a (impl FrictionCone + 'a),
        self_compliance: f64,
    ) -> impl Fn(usize) -> ConeCellState + Sync + 'a {
        let limit = move |i: usize, p: f64| friction.limit(i, p.max(0.0));
        let least = NOTHING * reduce::max(layout, |i| limit(i, self.x[0][i]));
        move |i| {
            let tractions @ [p, qx, qy] = at(&self.x, i);
            let (limit, slope) = (limit(i, p), friction.slope(i, p));
            let mut law = ConeCellState::of(tractions, limit, self.hardness.of(i));
            law.lag = EntryLag {
                own: self.own.get(i).copied().unwrap_or(0.0),
                deviator: [0.0; 2],
                ratio: [qx, qy].map(|q| if p > 0.0 { q / p } else { 0.0 }),
            };
            let law = if self.slips { law } else { law.stuck() };
            law.measured(at(&self.slip, i), [limit, slope], least, self_compliance)
        }
    }
}
