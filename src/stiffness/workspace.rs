//! What a stiffness is found in, again and again.

use std::ops::ControlFlow;

use crate::cgm::{Disc, FixedSetSystem, Interval, LinearWorkspace, LinearisedSet, Row};
use crate::contact::with_counts_of;
use crate::error::{Error, Result, positive};
use crate::half_space::HalfSpace;
use crate::observer::Observer;
use crate::parallel::layout::Layout;
use crate::report::{EigenvalueBound, Iteration, Report, Status};
#[cfg(feature = "history")]
use crate::stiffness::coupled::CoupledBuffers;
use crate::stiffness::system::System;
use crate::stiffness::tangential::ApproachSensitivity;

/// The system of a kind of set.
pub(super) type SystemOf<S, const N: usize> = System<<S as LinearisedSet<N>>::CellMotion, N>;

/// Buffers, tolerance and report of stiffnesses that are found one after the other.
///
/// The first stiffness allocates; further ones of contacts on the same bodies, found in a window of the same size, do not once
/// one has had as many cells and steps, and their operators are made once. A Newton iteration around a
/// [`History`](crate::History) holds one.
///
/// ```
/// use stickslip::stiffness::StiffnessWorkspace;
/// use stickslip::*;
/// let grid = Grid::square(48, 12.0)?;
/// let steel = Material::new(1.0, 0.3)?;
/// let bodies = HalfSpace::new(grid, ElasticPair::new(steel, steel)?)?;
/// let ball = surface::sphere(grid, 20.0)?;
/// let mut history = History::builder(&bodies, &ball, Friction::coulomb(0.4)?).build()?;
/// history.step(&LoadStep::hold().normal(NormalControl::Approach(0.5)))?;
/// // What a step that presses on needs: without the second set of cells.
/// let mut workspace = StiffnessWorkspace::new().reversal(false);
/// let slope = history.stiffness_with(&mut workspace, |_| std::ops::ControlFlow::Continue(()))?;
/// assert_eq!(slope.tangential.reversal[0][0], None);
/// assert!(workspace.report().is_converged() && workspace.report().products() > 0);
/// let force = history.normal().force();
/// history.step(&LoadStep::hold().normal(NormalControl::Approach(0.501)))?;
/// let expected = 0.001 * slope.normal.value;
/// assert!(((history.normal().force() - force) / expected - 1.0).abs() < 0.01);
/// # Ok::<(), Error>(())
/// ```
#[derive(Debug)]
pub struct StiffnessWorkspace {
    tolerance: f64,
    has_reversal: bool,
    is_of_next_step: bool,
    report: Report,
    buffers: Buffers,
}

/// The buffers of each kind of contact, from its first stiffness on.
#[derive(Debug, Default)]
pub(super) struct Buffers {
    pub(super) normal: Option<SystemOf<Interval, 1>>,
    pub(super) along: Option<SystemOf<Interval, 1>>,
    pub(super) plane: Option<SystemOf<Disc, 2>>,
    #[cfg(feature = "history")]
    pub(super) joint: Option<CoupledBuffers>,
    pub(super) growth: ApproachSensitivity,
}

impl Default for StiffnessWorkspace {
    fn default() -> Self {
        Self {
            tolerance: 1e-11,
            has_reversal: true,
            is_of_next_step: false,
            report: Report::unsolved(),
            buffers: Buffers::default(),
        }
    }
}

impl StiffnessWorkspace {
    /// Without buffers yet.
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// With a relative residual at which the linear problems count as solved (default: 1e-11). The error of a stiffness is
    /// of the order of its square.
    ///
    /// # Errors
    /// [`Error::NotPositive`].
    pub fn tolerance(mut self, tolerance: f64) -> Result<Self> {
        self.tolerance = positive("tolerance", tolerance)?;
        Ok(self)
    }

    /// With or without the stiffness at reversal, which is half of the cost (default: with); without it its entries are
    /// `None`.
    #[must_use]
    pub fn reversal(mut self, has_reversal: bool) -> Self {
        self.has_reversal = has_reversal;
        self
    }

    /// Sets whether a history returns the stiffness of its next step instead of the stiffness of its last step (default:
    /// the last step).
    ///
    /// [`loading`](crate::stiffness::TangentialStiffness::loading) is then the derivative of the force with respect to the
    /// motion of a next step that starts from the present state. Cells that stick resist fully, also cells that came into
    /// contact in the last step. Cells at their limit continue to slip: in the scalar model they keep their traction, in the
    /// vector model it can turn freely. [`by_approach`](crate::stiffness::ContactStiffness::by_approach) follows from the
    /// same cells.
    ///
    /// A host that shears the contact in its next step under the same normal load needs this stiffness. Where [pressure and
    /// shear are coupled](crate::coupled), `loading` is the stiffness at a constant approach: subtract
    /// `by_approach` times `normal_by_motion` over the normal stiffness for a constant normal force.
    ///
    /// ```
    /// use std::ops::ControlFlow;
    /// use stickslip::stiffness::StiffnessWorkspace;
    /// use stickslip::*;
    /// let grid = Grid::square(32, 0.30e-3)?;
    /// let steel = Material::new(213e9, 0.29)?;
    /// let bodies = HalfSpace::new(grid, ElasticPair::new(steel, steel)?)?;
    /// let ball = surface::sphere(grid, 3.5e-3)?;
    /// let mut history = History::builder(&bodies, &ball, Friction::coulomb(0.5)?).build()?;
    /// history.step(&LoadStep::hold().normal(NormalControl::Force(100.0)))?;
    ///
    /// let mut workspace = StiffnessWorkspace::new().next_step(true);
    /// let next = history.stiffness_with(&mut workspace, |_| ControlFlow::Continue(()))?.tangential;
    /// // All cells stick. In the step that pressed they entered the contact, and followed its motion in part.
    /// let [loading, reversal] = [next.loading, next.reversal].map(|matrix| matrix[0][0].unwrap_or(0.0));
    /// assert!((loading / reversal - 1.0).abs() < 1e-9);
    /// assert!(history.stiffness()?.tangential.loading[0][0] < Some(0.8 * loading));
    /// # Ok::<(), Error>(())
    /// ```
    #[must_use]
    pub fn next_step(mut self, is_of_next_step: bool) -> Self {
        self.is_of_next_step = is_of_next_step;
        self
    }

    /// Returns whether the stiffness is that of the next step.
    pub(crate) fn is_of_next_step(&self) -> bool {
        self.is_of_next_step
    }

    /// How the last stiffness was found: steps and products of all linear problems together, residual and status of the
    /// last; the time is not taken.
    #[must_use]
    pub fn report(&self) -> &Report {
        &self.report
    }

    /// `Ok` if all ranks ask for the same.
    pub(super) fn check_alike(&self, bodies: &HalfSpace) -> Result<()> {
        let settings = (self.tolerance, self.has_reversal, self.is_of_next_step);
        bodies.collective_result_checked(Ok(()), &[("settings of the stiffness", &settings)])
    }

    /// Begins another stiffness.
    pub(super) fn begin<'a>(
        &'a mut self,
        observer: Observer<'a>,
    ) -> (LinearSolveContext<'a>, &'a mut Buffers) {
        self.report.clear();
        let course = LinearSolveContext {
            tolerance: self.tolerance,
            has_reversal: self.has_reversal,
            report: &mut self.report,
            observer,
        };
        (course, &mut self.buffers)
    }
}

/// What is in a slot, if it is the one that is asked for, else what `make` makes.
pub(super) fn get_or_create<T>(
    slot: &mut Option<T>,
    is_own: impl Fn(&T) -> bool,
    make: impl FnOnce() -> Result<T>,
) -> Result<&mut T> {
    let own = slot.take().filter(is_own).map_or_else(make, Ok)?;
    Ok(slot.insert(own))
}

/// What is asked of the solves, and their report.
pub(super) struct LinearSolveContext<'a> {
    pub(super) tolerance: f64,
    /// Whether the stiffness at reversal is asked for too.
    pub(super) has_reversal: bool,
    pub(super) report: &'a mut Report,
    pub(super) observer: Observer<'a>,
}

impl LinearSolveContext<'_> {
    /// Finds the unknowns that answer a right side, to the tolerance or to where round-off leaves them.
    pub(super) fn respond<R: Row<N>, const N: usize>(
        &mut self,
        held: &FixedSetSystem<'_, N>,
        right: &[[f64; N]],
        unknowns: &mut Vec<[f64; N]>,
        workspace: &mut LinearWorkspace<R, N>,
    ) -> Result<()> {
        let mut observer = with_counts_of(self.report, &mut *self.observer);
        let outcome = held.respond(right, unknowns, workspace, self.tolerance, &mut observer);
        drop(observer);
        let bound = self.report.eigenvalue_bound;
        self.report.add_pass(workspace.report());
        self.report.eigenvalue_bound = bound;
        outcome.map_err(|error| match error {
            Error::NotConverged(_) => Error::NotConverged(Box::new(self.report.clone())),
            other => other,
        })
    }

    /// A bound rests on an eigenvalue known so, beside those found before.
    pub(super) fn require_eigenvalue_bound(&mut self, known: EigenvalueBound) {
        let report = &mut *self.report;
        report.eigenvalue_bound = match report.eigenvalue_bound {
            EigenvalueBound::Unknown => known,
            before => before.min(known),
        };
    }

    /// `Ok` if the last solve has come to the tolerance, and not only to where round-off leaves it.
    pub(super) fn check_solved(&self) -> Result<()> {
        if self.report.is_converged() {
            Ok(())
        } else {
            Err(Error::NotConverged(Box::new(self.report.clone())))
        }
    }

    /// Nothing is to be solved.
    pub(super) fn finish_at_once(&mut self) {
        self.report.status = Status::Converged;
        self.report.residual = 0.0;
    }

    /// Asks the observer, the same of all ranks, before a product beside the solves, and counts it.
    pub(super) fn notify_observer(&mut self, layout: &Layout) -> Result<()> {
        let report = &mut *self.report;
        let shown = Iteration {
            iteration: report.iterations,
            double_precision_products: report.double_precision_products,
            single_precision_products: report.single_precision_products,
            residual: report.residual,
            free: 0,
        };
        let own = (self.observer)(&shown).map_break(|()| Status::Cancelled);
        if let ControlFlow::Break(status) = layout.decided(own) {
            report.status = status;
            return Err(Error::NotConverged(Box::new(report.clone())));
        }
        report.double_precision_products += 1;
        Ok(())
    }
}
