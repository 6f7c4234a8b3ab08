//! Reusable buffers for computing stiffnesses.

use std::ops::ControlFlow;

#[cfg(feature = "history")]
use crate::cgm::cone::ConeCellState;
#[cfg(all(feature = "history", feature = "sensitivity"))]
use crate::cgm::cone::TransposedState;
use crate::cgm::{Disc, Interval, LinearisedSet};
use crate::contact::ResponseContext;
use crate::error::{Error, Result};
use crate::half_space::HalfSpace;
use crate::observer::Observer;
use crate::parallel::layout::Layout;
use crate::report::{EigenvalueBound, Iteration, Report, Status};
use crate::stiffness::contact::ContactCells;
use crate::stiffness::system::System;

/// System for one type of constraint set.
pub(crate) type SystemOf<S, const N: usize> = System<<S as LinearisedSet<N>>::CellMotion, N>;

/// Buffers, tolerance and report of stiffnesses that are computed repeatedly.
///
/// Create one workspace for a Newton iteration around a [`History`](crate::History). The first stiffness allocates and creates
/// the operators. Later stiffnesses reuse buffers and operators if the contact has the same bodies and a window of the same size.
/// They allocate only for more cells or steps than before.
///
/// ```
/// use stickslip::stiffness::StiffnessWorkspace;
/// use stickslip::*;
/// let grid = Grid::square(48, 12.0)?;
/// let steel = Material::new(1.0, 0.3)?;
/// let bodies = HalfSpace::new(grid, ElasticPair::new(steel, steel)?)?;
/// let ball = surface::sphere(grid, 20.0)?;
/// let mut history = History::builder(&bodies, &ball, Friction::coulomb(0.4)?).build()?;
/// history.step(&LoadStep::hold().normal(NormalLoad::Approach(0.5)))?;
/// // A step that presses further does not need the second set of cells.
/// let mut workspace = StiffnessWorkspace::new().reversal(false);
/// let slope = history.stiffness_with(&mut workspace, |_| std::ops::ControlFlow::Continue(()))?;
/// assert_eq!(slope.tangential.reversal[0][0], None);
/// assert!(workspace.report().is_converged() && workspace.report().products() > 0);
/// let force = history.normal().force();
/// history.step(&LoadStep::hold().normal(NormalLoad::Approach(0.501)))?;
/// let expected = 0.001 * slope.normal.value;
/// assert!(((history.normal().force() - force) / expected - 1.0).abs() < 0.01);
/// # Ok::<(), Error>(())
/// ```
#[derive(Debug)]
pub struct StiffnessWorkspace {
    tolerance: f64,
    is_of_next_step: bool,
    has_poisson_ratio: bool,
    report: Report,
    buffers: SystemBuffers,
}

/// Linear systems of each type of contact, created with the first stiffness of this type.
#[derive(Debug)]
pub(crate) struct SystemBuffers {
    /// Whether to compute the stiffness at reversal.
    pub(super) has_reversal: bool,
    pub(crate) normal: Option<SystemOf<Interval, 1>>,
    pub(crate) along: Option<SystemOf<Interval, 1>>,
    pub(crate) plane: Option<SystemOf<Disc, 2>>,
    #[cfg(feature = "history")]
    pub(crate) joint: Option<System<ConeCellState, 3>>,
    /// Transposed system, for sensitivities.
    #[cfg(all(feature = "history", feature = "sensitivity"))]
    pub(crate) transposed: Option<System<TransposedState, 3>>,
    pub(crate) cells: ContactCells,
}

impl Default for StiffnessWorkspace {
    fn default() -> Self {
        Self {
            tolerance: 1e-11,
            is_of_next_step: false,
            has_poisson_ratio: false,
            report: Report::unsolved(),
            buffers: SystemBuffers {
                has_reversal: true,
                normal: None,
                along: None,
                plane: None,
                #[cfg(feature = "history")]
                joint: None,
                #[cfg(all(feature = "history", feature = "sensitivity"))]
                transposed: None,
                cells: ContactCells::default(),
            },
        }
    }
}

impl StiffnessWorkspace {
    /// Creates a workspace without buffers.
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// Sets the relative residual at which the linear problems count as solved (default: 1e-11). The error of a stiffness is of
    /// the order of the square of this residual.
    ///
    /// # Errors
    /// - [`Error::Tolerance`] if the tolerance is not between 0 and 1.
    pub fn tolerance(mut self, tolerance: f64) -> Result<Self> {
        if !(tolerance > 0.0 && tolerance < 1.0) {
            return Err(Error::Tolerance(tolerance));
        }
        self.tolerance = tolerance;
        Ok(self)
    }

    /// Sets whether to compute the stiffness at reversal (default: yes). Without this stiffness the cost is half as large, and
    /// the entries at reversal are `None`.
    #[must_use]
    pub fn reversal(mut self, has_reversal: bool) -> Self {
        self.buffers.has_reversal = has_reversal;
        self
    }

    /// Sets whether a history returns the stiffness of its next step instead of its last step (default: the last step).
    ///
    /// [`loading`](crate::stiffness::TangentialStiffness::loading) is then the derivative of the force with respect to the motion
    /// of the next step, which starts from the current state. Sticking cells have no entry compliance, even if they came into
    /// contact in the last step. Cells at their limit continue to slip. Their traction is constant in the scalar model and can
    /// turn freely in the vector model. [`by_approach`](crate::stiffness::ContactStiffness::by_approach) refers to the same
    /// cells.
    ///
    /// A simulation that shears the contact in its next step under the same normal load needs this stiffness. If [pressure and
    /// shear are coupled](crate::coupled), `loading` is the stiffness at a constant approach. For a constant normal force,
    /// subtract `by_approach` times `normal_by_motion`, divided by the normal stiffness.
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
    /// history.step(&LoadStep::hold().normal(NormalLoad::Force(100.0)))?;
    ///
    /// let mut workspace = StiffnessWorkspace::new().next_step(true);
    /// let next = history.stiffness_with(&mut workspace, |_| ControlFlow::Continue(()))?.tangential;
    /// // All cells stick. In the pressing step they came into contact and followed its motion only in part.
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

    /// Sets whether the [sensitivities](crate::sensitivity) of tangential and coupled contacts contain the derivatives with respect
    /// to Poisson's ratios (default: no). The derivatives require further operators, whose creation takes longer than a linear
    /// solve. They have no effect on stiffnesses. Normal contacts always have these derivatives.
    #[cfg(feature = "sensitivity")]
    #[must_use]
    pub fn poisson_ratio(mut self, has_poisson_ratio: bool) -> Self {
        self.has_poisson_ratio = has_poisson_ratio;
        self
    }

    /// Returns whether sensitivities contain the derivatives with respect to Poisson's ratios.
    #[cfg(feature = "sensitivity")]
    pub(crate) fn has_poisson_ratio(&self) -> bool {
        self.has_poisson_ratio
    }

    /// Returns whether the workspace computes the stiffness of the next step.
    pub(crate) fn is_of_next_step(&self) -> bool {
        self.is_of_next_step
    }

    /// Returns the report of the last stiffness. Steps and products are the sums over all linear problems. Residual and status
    /// belong to the last problem. The time is not measured.
    #[must_use]
    pub fn report(&self) -> &Report {
        &self.report
    }

    /// Checks that all ranks use the same settings.
    pub(crate) fn check_alike(&self, bodies: &HalfSpace) -> Result<()> {
        let settings = (
            self.tolerance,
            self.buffers.has_reversal,
            self.is_of_next_step,
            self.has_poisson_ratio,
        );
        bodies.collective_result_checked(Ok(()), &[("settings of the stiffness", &settings)])
    }

    /// Starts a new stiffness.
    pub(crate) fn begin<'a>(
        &'a mut self,
        observer: Observer<'a>,
    ) -> (ResponseContext<'a>, &'a mut SystemBuffers) {
        self.report.clear();
        let context = ResponseContext {
            tolerance: self.tolerance,
            report: &mut self.report,
            observer,
        };
        (context, &mut self.buffers)
    }
}

/// Returns the value in a slot if it is the required value. Otherwise stores and returns the value of `make`.
pub(super) fn get_or_create<T>(
    slot: &mut Option<T>,
    is_own: impl Fn(&T) -> bool,
    make: impl FnOnce() -> Result<T>,
) -> Result<&mut T> {
    let own = slot.take().filter(is_own).map_or_else(make, Ok)?;
    Ok(slot.insert(own))
}

impl ResponseContext<'_> {
    /// Records the origin of the eigenvalue behind a bound. Keeps the least reliable origin so far.
    pub(super) fn require_eigenvalue_bound(&mut self, known: EigenvalueBound) {
        let report = &mut *self.report;
        report.eigenvalue_bound = match report.eigenvalue_bound {
            EigenvalueBound::Unknown => known,
            before => before.min(known),
        };
    }

    /// Marks the report as converged without a solve.
    pub(crate) fn finish_at_once(&mut self) {
        self.report.status = Status::Converged;
        self.report.residual = 0.0;
    }

    /// Calls the observer, with the same decision on all ranks, before a product outside the solves, and counts the product.
    pub(crate) fn notify_observer(&mut self, layout: &Layout) -> Result<()> {
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
