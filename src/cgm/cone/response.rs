//! How tractions answer motions of the bodies, while each cell goes on to move as it does.

use std::ops::ControlFlow;

use crate::buffer;
use crate::cgm::cone::border::Border;
use crate::cgm::cone::law::Law;
use crate::cgm::cone::{Cone, ConeProblem, ConeRun, ConeWorkspace, N};
use crate::cgm::monitor::Monitor;
use crate::cgm::run::Precision;
use crate::cgm::vector::{at, slices, slices_mut, within};
use crate::cgm::{Settings, reduce};
use crate::error::{Error, Result};
use crate::operator::Operator;
use crate::report::{Iteration, Status};

/// Residual of a response, over that without one.
const SOLVED: f64 = 1e-11;
/// What one basis is to reduce a residual to: its products are of single precision.
const REDUCTION: f64 = 1e-5;
/// Bases after which a response counts as not found.
const LIMIT: usize = 100;

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
        monitor: Monitor::new(settings, problem.layout, observer, &mut workspace.report),
        x: slices_mut(&mut tractions),
        workspace,
        free: 0,
        is_fresh: false,
        lack: None,
        times_held: 0,
    };
    run.stand(stand)?;
    let found = motions.iter().map(|motion| run.respond(motion));
    found.collect()
}

impl<C: Operator<N>, P: Operator<N>, F: Cone> ConeRun<'_, '_, C, P, F> {
    /// The law of every cell as it stands.
    fn stand(&mut self, stand: Stand<'_>) -> Result<()> {
        self.make_own(stand.own.len())?;
        let (problem, w) = (self.problem, &mut *self.workspace);
        w.own.copy_from_slice(stand.own);
        let x = slices(&self.x);
        let limit = |i: usize| problem.friction.limit(i, x[0][i].max(0.0));
        let least = super::newton::NOTHING * reduce::max(problem.layout, limit);
        for (i, law) in w.laws.iter_mut().enumerate() {
            let (tractions, slope) = (at(&x, i), problem.friction.slope(i, x[0][i]));
            let now = Law::of(tractions, limit(i), problem.hardness.of(i));
            let own = [
                problem.lower_bounds[1],
                stand.own.get(i).copied().unwrap_or(0.0),
            ];
            *law = if stand.slips {
                now.measured(at(&stand.slip, i), [limit(i), slope], least, own)
            } else {
                now.stuck()
            };
        }
        let laws = &w.laws;
        w.contact.update(|i| laws[i].touches());
        w.make_room()?;
        self.set_ratios();
        let w = &mut *self.workspace;
        for part in &mut w.direction {
            part.fill(0.0);
        }
        self.free = reduce::sum(problem.layout, |i| {
            usize::from(self.workspace.laws[i].sticks())
        });
        Ok(())
    }

    /// The tractions that a motion of the cells causes.
    fn respond(&mut self, motion: &[Vec<f64>; N]) -> Result<[Vec<f64>; N]> {
        let mut response = Vec::new();
        buffer::resize(&mut response, self.workspace.residual.len(), [0.0; N])?;
        let status = match self.solve_response(motion, &mut response) {
            ControlFlow::Break(Status::Converged) => None,
            ControlFlow::Break(status) => Some(status),
            ControlFlow::Continue(()) => Some(Status::Stalled),
        };
        if let Some(lack) = self.lack.take() {
            return Err(lack);
        }
        if let Some(status) = status {
            self.workspace.report.status = status;
            return Err(Error::NotConverged(Box::new(self.workspace.report.clone())));
        }
        let mut tractions: [Vec<f64>; N] = buffer::vector(motion[0].len())?;
        for (part, direction) in tractions.iter_mut().zip(&self.workspace.direction) {
            part.copy_from_slice(direction);
        }
        Ok(tractions)
    }

    /// Refines the response, of the unknowns of the cells in contact, by bases that begin at its exact residual.
    fn solve_response(
        &mut self,
        motion: &[Vec<f64>; N],
        response: &mut [[f64; N]],
    ) -> ControlFlow<Status> {
        let border = Border::none();
        let mut first = None;
        for _ in 0..LIMIT {
            self.proceed()?;
            self.workspace.correction.copy_from_slice(response);
            self.apply_to_correction(Precision::Double);
            self.set_residual_of_response(motion);
            let left = self.residual_size();
            let start = *first.get_or_insert(left);
            self.workspace.report.residual = if start > 0.0 { left / start } else { 0.0 };
            if left <= SOLVED * start {
                return ControlFlow::Break(Status::Converged);
            }
            if left.is_nan() {
                break;
            }
            let parts = self.arnoldi(&border, left, REDUCTION * left)?;
            self.combine(&parts);
            self.invert(&border);
            for (whole, part) in response.iter_mut().zip(&self.workspace.correction) {
                *whole = std::array::from_fn(|c| whole[c] + part[c]);
            }
        }
        ControlFlow::Continue(())
    }

    /// What the response in the correction, with its displacements in the image, leaves of a motion.
    fn set_residual_of_response(&mut self, motion: &[Vec<f64>; N]) {
        let w = &mut *self.workspace;
        let (laws, correction) = (&w.laws, &w.correction);
        let (image, motion) = (slices(&w.image), slices(motion));
        let residual = w.contact.compressed(&mut w.residual);
        w.contact.sweep(residual, |entries, residual| {
            let [image, motion] = [&image, &motion].map(|vector| within(vector, &entries.chunk));
            for (k, place) in entries.places().enumerate() {
                let law = laws[entries.chunk.start + place];
                let left: [f64; N] = std::array::from_fn(|c| motion[c][place] - image[c][place]);
                let bend = law.bend(correction[entries.range.start + k]);
                let row = law.restrict(left);
                residual.items[k] = std::array::from_fn(|c| row[c] - bend[c]);
            }
        });
    }
}
