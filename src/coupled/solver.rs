//! Reusable solver of a coupled contact.

use crate::cgm::solver_settings;
use crate::contact::{Cancellation, SolveContext, has_iterate, solver_methods};
use crate::coupled::increment::{CoupledIncrement, CoupledTarget};
use crate::coupled::{CoupledProblem, CoupledSolution};
use crate::error::{Error, Result};
use crate::grid::field::{self, Field};
use crate::memory::fallible::TryClone;
use crate::normal::NormalControl;
use crate::observer::Observer;
use crate::support::debug::shown;
use crate::tangential::{Axis, Friction, RigidMotion, TangentialLoad, TangentialModel};

/// Solver of a sequence of coupled contacts, each from rest in one step. Each solve starts from the last solution.
///
/// The solver has no memory of slip. Use a [`History`](crate::History) for steps that depend on earlier slip. Gap,
/// friction and loads may change between calls. A solve on the window of the last contact does not allocate.
///
/// ```
/// use stickslip::*;
/// let grid = Grid::square(32, 3.0)?;
/// let bodies = HalfSpace::new(grid, ElasticPair::new(Material::new(1.0, 0.0)?, Material::rigid())?)?;
/// let (ball, friction) = (surface::sphere(grid, 10.0)?, Friction::coulomb(0.3)?);
/// let (press, still) = (NormalControl::Force(0.1), TangentialLoad::shift([0.0, 0.0]));
/// let mut solver =
///     CoupledProblem::builder(&bodies, &ball, friction, press, still).build()?.into_solver()?;
/// let mut contact = solver.new_solution();
/// let mut shifts = Vec::new();
/// for force in [0.0, 0.01, 0.02] {
///     solver.set_load(press, TangentialLoad::force([force, 0.0]))?;
///     solver.solve_into(&mut contact)?;
///     shifts.push(contact.tangential().shift()[0]);
/// }
/// assert!(shifts.is_sorted() && shifts[2] > 2.0 * shifts[1]);
/// # Ok::<(), Error>(())
/// ```
#[derive(Clone)]
pub struct CoupledSolver {
    problem: CoupledProblem,
    increment: CoupledIncrement,
}

shown!(CoupledSolver: problem);

impl CoupledSolver {
    pub(super) fn new(problem: CoupledProblem) -> Result<Self> {
        let mut increment = CoupledIncrement::new(&problem.bodies)?;
        if let Some(relative) = &problem.relative {
            let of = |axis: usize, cell: usize| relative.at(axis, cell);
            let CoupledIncrement {
                offsets, pressed, ..
            } = &mut increment;
            offsets.displace(&pressed.region, of);
        }
        Ok(Self { problem, increment })
    }

    /// Changes the normal and the tangential load of the next solve.
    ///
    /// # Errors
    /// Errors of [`CoupledProblemBuilder::build`](super::CoupledProblemBuilder::build) that concern the loads. The
    /// loads are unchanged after an error.
    pub fn set_load(&mut self, normal: NormalControl, tangential: TangentialLoad) -> Result<()> {
        let CoupledProblem {
            bodies,
            gap,
            hardness,
            ..
        } = &self.problem;
        bodies.collective_result_checked(
            tangential.demand().check(Axis::BOTH, bodies.boundary()),
            &[("normal load", &normal), ("tangential load", &tangential)],
        )?;
        normal.check(bodies, gap, hardness.as_ref())?;
        (self.problem.normal, self.problem.tangential) = (normal, tangential);
        Ok(())
    }

    /// Changes the gap before loading for the next solve.
    ///
    /// # Errors
    /// - [`Error::GridMismatch`] if the grid differs.
    /// - [`Error::Sample`] if the gap is not finite.
    /// - [`Error::ApproachBeyondMeanGap`] if the prescribed approach is not less than the mean gap on a periodic grid.
    /// - [`Error::Ranks`] if ranks fail.
    ///
    /// The gap is unchanged after an error.
    pub fn set_gap(&mut self, gap: &Field) -> Result<()> {
        let bodies = &self.problem.bodies;
        bodies.collective_result(gap.check("gap", bodies.grid()))?;
        self.problem.normal.check(bodies, gap, None)?;
        field::replace(&mut self.problem.gap, gap)
    }

    /// Changes the friction of the next solve.
    ///
    /// # Errors
    /// - [`Error::GridMismatch`] if the grid differs.
    /// - [`Error::Ranks`] if ranks fail or pass different friction.
    ///
    /// The friction is unchanged after an error.
    pub fn set_friction(&mut self, friction: &Friction) -> Result<()> {
        friction.check_on(&self.problem.bodies)?;
        self.problem.friction.try_clone_from(friction)?;
        Ok(())
    }

    solver_settings!(problem.settings, problem.bodies, |_, settings| {
        TangentialModel::Vector.check(settings)
    });

    /// Discards the last solution. The next solve starts in the same way as the first.
    pub fn reset(&mut self) {
        self.increment.forget();
    }

    solver_methods!(CoupledSolution.normal(), problem.bodies);

    /// Creates a solution like [`Self::new_solution`], but returns an error if memory runs out.
    ///
    /// # Errors
    /// - [`Error::Memory`] if memory runs out.
    pub fn try_new_solution(&self) -> Result<CoupledSolution> {
        CoupledSolution::empty(&self.problem.bodies, &self.problem.gap)
    }

    fn solve_checked(
        &mut self,
        solution: &mut CoupledSolution,
        observer: Observer<'_>,
    ) -> Result<()> {
        let problem = &self.problem;
        let cancellation = Cancellation::default();
        let mut observer = cancellation.watch(observer);
        let mut conditions = SolveContext::new(&problem.settings, &mut observer);
        let demand = CoupledTarget {
            gap: &problem.gap,
            friction: &problem.friction,
            hardness: problem.hardness.as_ref(),
            normal: problem.normal,
            tangential: problem.tangential.demand(),
        };
        let outcome = self
            .increment
            .solve(demand, RigidMotion::default(), &mut conditions);
        let report = self.increment.report_mut();
        let outcome = cancellation.applied(&problem.bodies, outcome, || report.cancelled());
        if has_iterate(&outcome) {
            solution.fill(problem, &self.increment);
        }
        // The next solve must not start from NaN. If memory ran out, it must not start from the incomplete state
        // either.
        let is_broken = outcome.is_err() && !self.increment.report().residual.is_finite();
        if is_broken || matches!(outcome, Err(Error::Memory { .. })) {
            self.increment.forget();
        }
        outcome
    }
}
