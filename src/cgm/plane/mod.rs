//! The minimum over discs: two unknowns a cell, as many as friction holds together.
//!
//! ```math
//! \min_q \; \tfrac12 q' C q + b' q
//! \quad\text{over}\quad |q_i| \le m_i, \qquad q_i = (q_{x,i}, q_{y,i}),
//! \quad\text{optionally}\quad \textstyle\sum_i q_{x,i} = S_x, \; \sum_i q_{y,i} = S_y .
//! ```
//!
//! With `g = C q + b - delta` the slip, a cell sticks (`g = 0`, `|q| < m`) or slips (`|q| = m`, `g` against
//! `q`). Semi-smooth Newton outside: at the limit a cell keeps one unknown, the angle of its traction, whose
//! stiffness is the operator's along the circle and `|g|/m` more, the curvature of the circle; without that
//! term iterations of clipped gradients stall (Zhao, Vollebregt & Oosterlee 2015). Preconditioned conjugate
//! gradients inside, as for one unknown a cell. If the sets cycle, projected gradients lead past.
//!
//! The certificate is that of [`crate::cgm`]: of the slip of a cell at its limit the part against the traction
//! is allowed, and only the rest counts. A limit is meant to 1e-12 of it.
//!
//! Vectors hold all x components, then all y components.

mod border;
mod cell;
mod certificate;
mod disc;
mod inner;
mod newton;
mod projected_gradient;
mod run;

use std::ops::ControlFlow;

use crate::cgm::Settings;
use crate::cgm::free_set::FreeSet;
use crate::error::{Error, Result, all_finite, length};
use crate::operator::Operator;
use crate::parallel;
use crate::report::{Iteration, Report, Status};

use cell::Cell;
pub(crate) use certificate::examine;
pub(crate) use disc::{Disc, both, dot, norm, update_cells};
use run::Run;

/// What to minimise. `linear` holds two numbers a cell, `limits` one, finite and not negative.
#[derive(Debug, Clone)]
pub(crate) struct Problem<'a, C, P> {
    pub(crate) operator: C,
    pub(crate) preconditioner: P,
    pub(crate) linear: &'a [f64],
    pub(crate) limits: &'a [f64],
    /// Prescribed sums of the components.
    pub(crate) totals: [Option<f64>; 2],
}

/// Everything an iteration writes to besides `q`.
#[derive(Debug, Clone)]
pub(crate) struct Workspace<C: Operator<2>, P: Operator<2>> {
    operator: C::Workspace,
    preconditioner: P::Workspace,
    product: Vec<f64>,
    gradient: Vec<f64>,
    direction: Vec<f64>,
    image: Vec<f64>,
    inner: Inner,
    /// The cells that can carry a traction.
    loaded: FreeSet,
    report: Report,
    multiplier: [f64; 2],
}

/// What the inner iteration keeps, compressed to the loaded cells.
#[derive(Debug, Clone)]
struct Inner {
    cells: Vec<Cell>,
    residual: Vec<[f64; 2]>,
    last_residual: Vec<[f64; 2]>,
    correction: Vec<[f64; 2]>,
    direction: Vec<[f64; 2]>,
    /// How a change of each total spreads.
    spread: Vec<[[f64; 2]; 2]>,
}

impl<C: Operator<2>, P: Operator<2>> Workspace<C, P> {
    pub(crate) fn new(operator: &C, preconditioner: &P) -> Self {
        let len = 2 * operator.cells();
        let zeros = || vec![0.0; len];
        let vectors = || vec![[0.0; 2]; len / 2];
        Self {
            operator: operator.workspace(),
            preconditioner: preconditioner.workspace(),
            product: zeros(),
            gradient: zeros(),
            direction: zeros(),
            image: zeros(),
            inner: Inner {
                cells: vec![Cell::Stick; len / 2],
                residual: vectors(),
                last_residual: vectors(),
                correction: vectors(),
                direction: vectors(),
                spread: vec![[[0.0; 2]; 2]; len / 2],
            },
            loaded: FreeSet::with_capacity(len / 2),
            report: Report::with_room(),
            multiplier: [0.0; 2],
        }
    }

    /// The product `C q` with the iterate last returned.
    pub(crate) fn product(&self) -> &[f64] {
        &self.product
    }

    pub(crate) fn report(&self) -> &Report {
        &self.report
    }

    /// The multipliers of the totals, zero for those not prescribed.
    pub(crate) fn multiplier(&self) -> [f64; 2] {
        self.multiplier
    }
}

/// Finds the minimum from the start `q` and leaves it there.
///
/// # Errors
/// [`Error::Length`], [`Error::Sample`], [`Error::BeyondSliding`], or what is wrong with the settings, before
/// any work; [`Error::NotConverged`] with the last feasible iterate in `q`.
pub(crate) fn minimise<C: Operator<2>, P: Operator<2>>(
    problem: &Problem<'_, C, P>,
    settings: &Settings,
    q: &mut [f64],
    workspace: &mut Workspace<C, P>,
    observer: &mut (dyn FnMut(&Iteration) -> ControlFlow<()> + Send),
) -> Result<()> {
    settings.check()?;
    length("start", 2 * problem.operator.cells(), q.len())?;
    all_finite("start", q)?;
    let sum = crate::cgm::reduce::total(problem.limits);
    let reach = disc::reach(problem.totals, sum)?;
    let solve = || {
        let mut run = Run::new(problem, settings, q, workspace, observer);
        let status = if let Some(multiplier) = run.multiplier_at_zero() {
            run.at_zero(multiplier)
        } else if let disc::Reach::AtLimit(direction) = reach {
            run.at_limit(direction)
        } else {
            iterate(&mut run)
        };
        run.finish(status)
    };
    if parallel::enter(solve) == Status::Converged {
        Ok(())
    } else {
        Err(Error::NotConverged(Box::new(workspace.report.clone())))
    }
}

/// Newton's method; each time its sets cycle, twice as many steps of a method that has none, until that does
/// not help any more.
fn iterate<C: Operator<2>, P: Operator<2>>(run: &mut Run<'_, '_, C, P>) -> Status {
    let (mut detour, mut in_vain) = (32, 0);
    loop {
        let before = run.watch.best;
        if let Some(status) = newton::iterate(run) {
            return status;
        }
        in_vain = if run.watch.best < 0.5 * before {
            0
        } else {
            in_vain + 1
        };
        if in_vain > crate::cgm::DETOURS_IN_VAIN {
            return Status::Stalled;
        }
        match projected_gradient::iterate(run, detour) {
            ControlFlow::Break(status) => return status,
            ControlFlow::Continue(true) => in_vain = crate::cgm::DETOURS_IN_VAIN,
            ControlFlow::Continue(false) => {}
        }
        detour = (2 * detour).min(run.watch.settings.max_iterations);
    }
}
