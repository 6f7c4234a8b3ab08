//! How tractions answer motions of the bodies, while each cell goes on to move as it does.

use std::ops::ControlFlow;

use crate::buffer;
use crate::cgm::cone::law::{Lag, Law};
use crate::cgm::cone::{Cone, ConeProblem, ConeRun, ConeWorkspace, N};
use crate::cgm::monitor::Monitor;
use crate::cgm::motion::Row;
use crate::cgm::vector::{at, slices, slices_mut};
use crate::cgm::{Settings, reduce};
use crate::error::Result;
use crate::operator::Operator;
use crate::report::Iteration;

/// Where the cells stand: tractions, slip of the last step, and compliance of their own, of no cells where none has one.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Stand<'a> {
    pub(crate) x: [&'a [f64]; N],
    pub(crate) slip: [&'a [f64]; 2],
    pub(crate) own: &'a [f64],
    /// Whether cells at their limits slip on; else they stick.
    pub(crate) slips: bool,
}

/// The tractions that a unit of each motion of the cells causes.
///
/// # Errors
/// [`Error::NotConverged`]; [`Error::Memory`].
pub(crate) fn responses<C: Operator<N>, P: Operator<N>, F: Cone>(
    problem: &ConeProblem<'_, C, P, F>,
    settings: &Settings,
    stand: Stand<'_>,
    motions: &[[Vec<f64>; N]],
    workspace: &mut ConeWorkspace<C, P>,
    observer: &mut (dyn FnMut(&Iteration) -> ControlFlow<()> + Send),
) -> Result<Vec<[Vec<f64>; N]>> {
    let mut tractions: [Vec<f64>; N] = buffer::vector(stand.x[0].len())?;
    for (own, x) in tractions.iter_mut().zip(stand.x) {
        own.copy_from_slice(x);
    }
    let mut run = ConeRun {
        problem,
        monitor: Monitor::new(
            settings,
            problem.layout,
            observer,
            &mut workspace.linear.report,
        ),
        x: slices_mut(&mut tractions),
        workspace,
        is_fresh: false,
        times_held: 0,
    };
    run.stand(stand)?;
    let found = motions.iter().map(|motion| run.respond(motion));
    found.collect()
}

impl<C: Operator<N>, P: Operator<N>, F: Cone> ConeRun<'_, '_, C, P, F> {
    /// The law of every cell as it stands.
    fn stand(&mut self, stand: Stand<'_>) -> Result<()> {
        let (problem, w) = (self.problem, &mut *self.workspace);
        let x = slices(&self.x);
        let limit = |i: usize| problem.friction.limit(i, x[0][i].max(0.0));
        let least = super::newton::NOTHING * reduce::max(problem.layout, limit);
        for (i, law) in w.linear.rows.iter_mut().enumerate() {
            let (tractions, slope) = (at(&x, i), problem.friction.slope(i, x[0][i]));
            *law = Law::of(tractions, limit(i), problem.hardness.of(i));
            law.lag = Lag {
                own: stand.own.get(i).copied().unwrap_or(0.0),
                ratio: problem.ratio(i, *law, tractions),
            };
            if !stand.slips {
                *law = law.stuck();
            }
            let slip = at(&stand.slip, i);
            *law = law.measured(slip, [limit(i), slope], least, problem.lower_bounds[1]);
        }
        w.list_contact()?;
        let laws = &w.linear.rows;
        let sticks = |i: usize| usize::from(laws[i].is_free());
        self.monitor.free = reduce::sum(problem.layout, sticks);
        Ok(())
    }

    /// The tractions that a motion of the cells causes.
    fn respond(&mut self, motion: &[Vec<f64>; N]) -> Result<[Vec<f64>; N]> {
        let mut unknowns = Vec::new();
        self.linear().respond(slices(motion), &mut unknowns)?;
        let mut tractions: [Vec<f64>; N] = buffer::vector(motion[0].len())?;
        for (part, direction) in tractions.iter_mut().zip(&self.workspace.linear.direction) {
            part.copy_from_slice(direction);
        }
        Ok(tractions)
    }
}
