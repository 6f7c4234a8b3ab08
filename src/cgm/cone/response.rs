//! States of the cells at the end of a step, fixed for the linear problem of a stiffness.

use crate::cgm::cone::cell_state::{ConeCellState, EntryLag};
use crate::cgm::cone::newton::NOTHING;
use crate::cgm::cone::{ConeProblem, ConeWorkspace, FrictionCone, N};
use crate::cgm::linear::LinearWorkspace;
use crate::cgm::reduce;
use crate::error::Result;
use crate::numerics::cell_vector::at;

/// State of the cells: tractions, slip of the last step, and entry compliance. The entry compliance is empty if it is zero in all
/// cells.
#[derive(Debug, Clone, Copy)]
pub(crate) struct FrozenState<'a> {
    pub(crate) x: [&'a [f64]; N],
    pub(crate) slip: [&'a [f64]; 2],
    pub(crate) own: &'a [f64],
    /// Whether cells at their limits continue to slip. If not, these cells stick.
    pub(crate) slips: bool,
}

impl ConeWorkspace {
    /// Sets up the linear problem with the cells fixed in this state.
    ///
    /// # Errors
    /// - [`Error::Memory`](crate::Error::Memory) if the memory does not suffice.
    pub(crate) fn hold(
        &mut self,
        problem: &ConeProblem<'_, impl FrictionCone>,
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
