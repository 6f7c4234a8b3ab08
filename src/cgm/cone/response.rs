//! The laws of the cells of a contact at its last state, as the linear problem of a stiffness has them.

use crate::cgm::cone::cell_state::{ConeCellState, EntryLag};
use crate::cgm::cone::newton::NOTHING;
use crate::cgm::cone::{Cone, ConeProblem, ConeWorkspace, N};
use crate::cgm::linear::LinearWorkspace;
use crate::cgm::reduce;
use crate::error::Result;
use crate::numerics::cell_vector::at;

/// Where the cells stand: tractions, slip of the last step, and compliance of their own, of no cells where none has one.
#[derive(Debug, Clone, Copy)]
pub(crate) struct FrozenState<'a> {
    pub(crate) x: [&'a [f64]; N],
    pub(crate) slip: [&'a [f64]; 2],
    pub(crate) own: &'a [f64],
    /// Whether cells at their limits slip on; else they stick.
    pub(crate) slips: bool,
}

impl ConeWorkspace {
    /// The linear problem of the cells at this state, whose laws are held.
    ///
    /// # Errors
    /// [`Error::Memory`](crate::Error::Memory).
    pub(crate) fn hold(
        &mut self,
        problem: &ConeProblem<'_, impl Cone>,
        stand: FrozenState<'_>,
    ) -> Result<&mut LinearWorkspace<ConeCellState, N>> {
        let FrozenState {
            x,
            slip,
            own,
            slips,
        } = stand;
        let limit = |i: usize| problem.friction.limit(i, x[0][i].max(0.0));
        let least = NOTHING * reduce::max(problem.layout, limit);
        self.linear.hold(|i| {
            let (tractions, slope) = (at(&x, i), problem.friction.slope(i, x[0][i]));
            let mut law = ConeCellState::of(tractions, limit(i), problem.hardness.of(i));
            law.lag = EntryLag {
                own: own.get(i).copied().unwrap_or(0.0),
                deviator: [0.0; 2],
                ratio: problem.ratio(i, law, tractions),
            };
            let law = if slips { law } else { law.stuck() };
            law.measured(
                at(&slip, i),
                [limit(i), slope],
                least,
                problem.self_compliance,
            )
        })?;
        Ok(&mut self.linear)
    }
}
