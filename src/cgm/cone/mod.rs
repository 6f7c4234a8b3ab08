//! Pressure and shear in one solve: Coulomb's friction cone in every cell, solved by a semismooth Newton method on all three
//! tractions.
//!
//! Bodies of different materials move tangentially under pressure and normally under shear. The unknowns of a cell are its
//! pressure and its traction, `x = (p, q)`. With the gap `g` and the slip `s` of the cell, the cone complementarity problem is
//! ```math
//! \begin{pmatrix} g \\ s \end{pmatrix} = C x + b - \delta, \qquad
//! p \ge 0,\; g \ge 0,\; p\,g = 0, \qquad
//! |q| \le m(p), \quad s = 0 \text{ where } |q| < m, \quad s = -|s|\,q/m \text{ where } |q| = m .
//! ```
//!
//! `C` is symmetric and positive definite. The conditions are nevertheless not the optimality conditions of a minimum, because
//! the limit `m` grows with the unknown pressure. The semismooth Newton method linearises limit and tractions together:
//! `dq = m'(p) n dp + t dtau` in a cell that slips along `n`. Right-preconditioned GMRES solves the resulting non-symmetric
//! system on the cells in contact.
//!
//! A cell may have a hardness, `p <= H`. While its pressure is at the hardness, the bodies may overlap and the equation of the
//! gap is omitted.
//!
//! A cell that newly touches is set to slip, with its traction against the slip. The cell is set to stick only if its overlap
//! could prevent the slip: `|s| <= m' |g|`. If every new cell were set to stick, the method would cycle at the edge of every
//! growing contact.

mod border;
mod cell_state;
mod lag;
mod newton;
mod response;
#[cfg(feature = "sensitivity")]
mod transposed;
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

pub(crate) use cell_state::ConeCellState;
pub(crate) use response::FrozenState;
#[cfg(feature = "sensitivity")]
pub(crate) use transposed::TransposedState;
pub(crate) use workspace::ConeWorkspace;

/// Number of components of a vector (z, x and y).
const N: usize = 3;

/// Friction limit of a cell as a function of its pressure.
pub(crate) trait FrictionCone: Sync {
    /// Returns the friction limit, which must be non-negative and must not decrease with the pressure.
    fn limit(&self, cell: usize, pressure: f64) -> f64;

    /// Returns the derivative of the limit with respect to the pressure.
    fn slope(&self, cell: usize, pressure: f64) -> f64;
}

/// The cone complementarity problem for pressures and tractions, z first, given the displacements of `operator`.
#[derive(Clone, Copy)]
pub(crate) struct ConeProblem<'a, F> {
    pub(crate) operator: &'a dyn Operator<N>,
    pub(crate) preconditioner: &'a dyn Operator<N>,
    pub(crate) layout: &'a Layout,
    /// Gap before loading, then the negated prescribed displacements of the cells along x and y.
    pub(crate) linear: [&'a [f64]; N],
    /// The tensor $`\kappa g`$ of cells that would come into contact from a gap g. The displacement of such a cell lags behind
    /// the prescribed motion by $`\kappa g\,q/p`$. The tensor is zero in the other cells. The value is `None` if no rank has such
    /// a cell.
    pub(crate) closing: Option<CellCompliance<'a>>,
    /// Maximum pressure of each cell.
    pub(crate) hardness: PerCell<&'a [f64]>,
    pub(crate) friction: F,
    pub(crate) totals: [Total; N],
    /// Lower bounds of the eigenvalues of the normal and of the tangential part of the operator.
    pub(crate) lower_bounds: [LowerBound; 2],
    /// Tangential displacement of a cell under a unit tangential traction on this cell.
    pub(crate) self_compliance: f64,
    /// Ratio of tangential to normal displacement under pressure, for the minimum scale of the tangential residuals.
    pub(crate) coupling: f64,
}

/// Measures of an iterate from one product.
#[derive(Debug, Clone, Copy)]
pub(crate) struct ConeMeasures {
    /// Residual of gap and of slip, relative to the largest displacements.
    pub(crate) residual: f64,
    /// Relative deficit of the prescribed sums.
    pub(crate) load_error: f64,
    /// Error bounds of the pressure and of the traction in the energy norm, relative to the square root of `x' C x`. The bound of
    /// the pressure is valid for a fixed traction, and the bound of the traction for a fixed pressure.
    pub(crate) bounds: [f64; 2],
    /// Number of sticking cells.
    free: usize,
}

impl ConeMeasures {
    /// Returns the quantity that must fall to the tolerance.
    pub(crate) fn merit(&self) -> f64 {
        let [normal, tangential] = self.bounds;
        let parts = [self.residual, self.load_error, normal, tangential];
        parts.into_iter().fold(0.0, reduce::larger)
    }
}

/// Origin of a start.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum ConeStart {
    /// The tractions come from separate solves for pressure and traction. Their sets are reliable.
    Halves,
    /// The tractions were interpolated from coarser cells. Their sets do not justify an accurate first solve.
    Coarse,
    /// The tractions are the present tractions. They are rejected if they are far from the solution.
    Present,
}

/// State of one solve.
pub(crate) struct ConeRun<'a, 'b, F> {
    problem: &'a ConeProblem<'b, F>,
    monitor: Monitor<'a>,
    x: [&'a mut [f64]; N],
    workspace: &'a mut ConeWorkspace,
    /// Whether the product is the product with the current tractions in double precision.
    is_fresh: bool,
    /// Number of times that all cells slipped in the same direction.
    times_held: usize,
    start: ConeStart,
    course: NewtonProgress,
    border: Border<N>,
}

/// Solves from the tractions `x` and the multipliers of the workspace, and overwrites both with the solution. The status is
/// `None` if the start is rejected or if the sets cycle. A different start might then succeed. The returned measures belong to
/// the returned `x`.
///
/// # Errors
/// - [`Error::Memory`](crate::Error::Memory) if the memory does not suffice.
pub(crate) fn solve<F: FrictionCone>(
    problem: &ConeProblem<'_, F>,
    settings: &Settings,
    start: ConeStart,
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
        start,
        course: NewtonProgress::BEGIN,
        border: Border::NONE,
    };
    let status = newton(&mut run);
    if !run.is_fresh && status.is_some() {
        // The solve may have ended during a linear solve, which lets cells leave their cones.
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
