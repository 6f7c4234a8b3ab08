//! Pressure and shear in one solve: Coulomb's cone in every cell, by Newton's method on all three tractions.
//!
//! Bodies of different materials move tangentially where they are pressed and normally where they are sheared. The
//! unknowns of a cell are its pressure and its traction, `x = (p, q)`; with the gap `g` and the slip `s` of the cell,
//!
//! ```math
//! \begin{pmatrix} g \\ s \end{pmatrix} = C x + b - \delta, \qquad
//! p \ge 0,\; g \ge 0,\; p\,g = 0, \qquad
//! |q| \le m(p), \quad s = 0 \text{ where } |q| < m, \quad s = -|s|\,q/m \text{ where } |q| = m .
//! ```
//!
//! `C` is symmetric and positive definite, but the law is not the condition of a minimum: the limit `m` grows with the pressure
//! that is sought. Newton's method linearises both at once, `dq = m'(p) n dp + t dtau` where a cell slips along `n`,
//! which leaves a system that is not symmetric: right-preconditioned GMRES solves it, on the cells in contact.
//!
//! A cell may have a hardness, `p <= H`: while its pressure stays there the bodies may overlap, and its equation of the gap
//! is left out.
//!
//! A cell that newly touches slips against its slip unless that is less than what its overlap would hold,
//! `|s| <= m' |g|`. Were it to stick, the method would circle at the edge of every contact that grows.

mod border;
mod cell_state;
mod lag;
mod newton;
mod response;
mod workspace;

use crate::cgm::cone::newton::NewtonProgress;
use crate::cgm::linear::Border;
use crate::cgm::monitor::Monitor;
use crate::cgm::newton::newton;
use crate::cgm::{CellCompliance, Settings, Total, reduce};
use crate::error::Result;
use crate::grid::per_cell::PerCell;
use crate::observer::Observer;
use crate::operator::{LowerBound, Operator};
use crate::parallel::layout::Layout;
use crate::report::Status;

pub(crate) use response::FrozenState;
pub(crate) use workspace::ConeWorkspace;

/// Components of a vector: along z, x and y.
const N: usize = 3;

/// How much shear a cell carries under a pressure.
pub(crate) trait Cone: Sync {
    /// The limit, non-negative and growing with the pressure.
    fn limit(&self, cell: usize, pressure: f64) -> f64;

    /// How it grows there.
    fn slope(&self, cell: usize, pressure: f64) -> f64;
}

/// What to solve: pressures and tractions, z first, from the displacements of `operator`.
#[derive(Clone, Copy)]
pub(crate) struct ConeProblem<'a, F> {
    pub(crate) operator: &'a dyn Operator<N>,
    pub(crate) preconditioner: &'a dyn Operator<N>,
    pub(crate) layout: &'a Layout,
    /// The gap before loading, and minus what the cells are asked to follow along x and y.
    pub(crate) linear: [&'a [f64]; N],
    /// $`\kappa g`$ of the cells that would enter the contact from a gap g, a tensor: they lag behind their motion by
    /// $`\kappa g\,q/p`$. Zero elsewhere; `None` where no cell of any rank does.
    pub(crate) closing: Option<CellCompliance<'a>>,
    /// The largest pressure of each cell.
    pub(crate) hardness: PerCell<&'a [f64]>,
    pub(crate) friction: F,
    pub(crate) totals: [Total; N],
    /// Lower bounds of the eigenvalues of the normal and of the tangential part of the operator.
    pub(crate) lower_bounds: [LowerBound; 2],
    /// How far a unit tangential traction displaces its own cell.
    pub(crate) self_compliance: f64,
    /// Tangential displacement by pressure, over the normal one: tangential residuals are relative to that at least.
    pub(crate) coupling: f64,
}

/// What an iterate shows, from one product.
#[derive(Debug, Clone, Copy)]
pub(crate) struct ConeMeasures {
    /// Residual of gap and of slip, over the largest displacements.
    pub(crate) residual: f64,
    /// What is missing of the prescribed sums.
    pub(crate) load_error: f64,
    /// Bounds of the errors of pressure and of traction in the energy norm, each with the other as it is, over the root
    /// of `x' C x`.
    pub(crate) bounds: [f64; 2],
    /// Cells that stick.
    free: usize,
}

impl ConeMeasures {
    /// What has to fall to the tolerance.
    pub(crate) fn merit(&self) -> f64 {
        let [normal, tangential] = self.bounds;
        let parts = [self.residual, self.load_error, normal, tangential];
        parts.into_iter().fold(0.0, reduce::larger)
    }
}

/// What is known of a start.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum ConeStart {
    /// Its sets come from coarser cells: a deep first solve would be wasted on them.
    Coarse,
    /// Its sets are good.
    Trusted,
    /// It is to be refused if its residual is larger.
    Tentative(f64),
}

impl ConeStart {
    fn refuses(self, residual: f64) -> bool {
        matches!(self, Self::Tentative(worst) if residual > worst)
    }
}

/// One solve under way.
pub(crate) struct ConeRun<'a, 'b, F> {
    problem: &'a ConeProblem<'b, F>,
    monitor: Monitor<'a>,
    x: [&'a mut [f64]; N],
    workspace: &'a mut ConeWorkspace,
    /// Whether the product is that of the tractions, in double precision.
    is_fresh: bool,
    /// Times that all cells slipped the same way.
    times_held: usize,
    opening: ConeStart,
    course: NewtonProgress,
    border: Border<N>,
}

/// Solves from the tractions `x` into them, at multipliers that the workspace begins and ends with; `None` where the
/// start is refused, or where the sets cycle, which another start may cure. The findings are those of what is
/// left in `x`.
///
/// # Errors
/// [`Error::Memory`](crate::Error::Memory).
pub(crate) fn solve<F: Cone>(
    problem: &ConeProblem<'_, F>,
    settings: &Settings,
    opening: ConeStart,
    x: [&mut [f64]; N],
    workspace: &mut ConeWorkspace,
    observer: Observer<'_>,
) -> Result<(Option<Status>, ConeMeasures)> {
    let mut run = ConeRun {
        problem,
        monitor: Monitor::new(
            settings,
            problem.layout,
            observer,
            &mut workspace.linear.report,
        ),
        x,
        workspace,
        is_fresh: false,
        times_held: 0,
        opening,
        course: NewtonProgress::BEGIN,
        border: Border::NONE,
    };
    let status = newton(&mut run);
    if !run.is_fresh && status.is_some() {
        // It may have ended within a linear system, which lets cells leave their cones.
        run.set_laws();
    }
    run.refresh();
    let findings = run.findings();
    run.add_entry_compliance(-1.0);
    let report = &mut run.workspace.linear.report;
    let ended = status.unwrap_or(Status::Stalled);
    run.monitor.finish(ended, findings.merit(), report);
    run.monitor
        .allocation_error
        .map_or(Ok((status, findings)), Err)
}
