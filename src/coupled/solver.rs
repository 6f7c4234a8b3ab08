//! Reusable solver of a coupled contact.

use crate::cgm::Settings;
use crate::contact::{
    Cancellation, Contact, Model, SolveContext, Solver, has_iterate, model_fields,
};
use crate::coupled::increment::{CoupledIncrement, CoupledTarget};
use crate::coupled::{CoupledProblem, CoupledReport, CoupledSolution};
use crate::error::{Error, Result};
use crate::grid::field::{self, Field};
use crate::memory::fallible::{self, TryClone};
use crate::normal::{Hardness, LastGap, NormalLoad};
use crate::observer::Observer;
use crate::tangential::{
    Axis, Friction, RelativeDisplacement, RigidMotion, TangentialLoad, TangentialModel,
};

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
/// let (press, still) = (NormalLoad::Force(0.1), TangentialLoad::shift([0.0, 0.0]));
/// let mut solver =
///     CoupledProblem::builder(&bodies, &ball, friction, press, still).build()?.into_solver()?;
/// let mut contact = solver.new_solution();
/// let mut shifts = Vec::new();
/// for force in [0.0, 0.01, 0.02] {
///     solver.set_loads(press, TangentialLoad::force([force, 0.0]))?;
///     solver.solve_into(&mut contact)?;
///     shifts.push(contact.tangential().shift()[0]);
/// }
/// assert!(shifts.is_sorted() && shifts[2] > 2.0 * shifts[1]);
/// # Ok::<(), Error>(())
/// ```
pub type CoupledSolver = Solver<CoupledProblem>;

impl CoupledSolver {
    /// Changes the normal and the tangential load of the next solve.
    ///
    /// # Errors
    /// Errors of [`CoupledProblemBuilder::build`](super::CoupledProblemBuilder::build) that concern the loads. The
    /// loads are unchanged after an error.
    pub fn set_loads(&mut self, normal: NormalLoad, tangential: TangentialLoad) -> Result<()> {
        let CoupledProblem {
            bodies,
            gap,
            hardness,
            ..
        } = &self.problem;
        bodies.collective_result_checked(
            tangential.demand().check(Axis::BOTH, bodies, [0.0; 2]),
            &[("normal load", &normal), ("tangential load", &tangential)],
        )?;
        normal.check(bodies, gap, hardness.as_ref())?;
        (self.problem.normal, self.problem.tangential) = (normal, tangential);
        Ok(())
    }

    /// Returns the gap before loading of the next solve: the last gap that was given or [set](Self::set_gap). The gap of a
    /// [solution](crate::NormalSolution::gap) is a different field, the gap under load.
    #[must_use]
    pub fn gap(&self) -> &Field {
        &self.problem.gap
    }

    /// Changes the gap before loading for the next solve.
    ///
    /// The next solution has the warning [`LargeGapChange`](crate::Warning::LargeGapChange) after wear much deeper than the
    /// displacements.
    ///
    /// # Errors
    /// - [`Error::GridMismatch`] if the grid differs.
    /// - [`Error::Sample`] if the gap is not finite.
    /// - [`Error::GapUnderLoad`] if the gap is the gap under load of the last solution.
    /// - [`Error::ApproachBeyondMeanGap`] if the prescribed approach is not less than the mean gap on a periodic grid.
    /// - [`Error::Ranks`] if ranks fail.
    ///
    /// The gap is unchanged after an error.
    pub fn set_gap(&mut self, gap: &Field) -> Result<()> {
        let bodies = &self.problem.bodies;
        let checked = gap.check("gap", bodies.grid()).and_then(|()| {
            let last = self.engine.last_gap.as_ref();
            last.map_or(Ok(()), |last| last.check(gap))
        });
        bodies.collective_result(checked)?;
        self.problem.normal.check(bodies, gap, None)?;
        if let Some(last) = &mut self.engine.last_gap {
            last.store(&self.problem.gap);
        }
        field::replace(&mut self.problem.gap, gap)
    }

    /// Returns the friction of the next solve, with its cap: the last friction that was given or [set](Self::set_friction).
    #[must_use]
    pub fn friction(&self) -> &Friction {
        &self.problem.friction
    }

    /// Changes the friction of the next solve. The new friction replaces the earlier coefficient and the earlier cap.
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

    /// Changes the largest pressure that the cells can carry in the next solve.
    ///
    /// # Errors
    /// - [`Error::GridMismatch`] if the grid differs.
    /// - [`Error::BeyondHardness`] if the present force exceeds the capacity of the cells.
    /// - [`Error::Memory`] if memory runs out.
    /// - [`Error::Ranks`] if ranks fail or pass different hardness.
    ///
    /// The hardness is unchanged after an error.
    pub fn set_hardness(&mut self, hardness: &Hardness) -> Result<()> {
        let CoupledProblem { bodies, normal, .. } = &self.problem;
        hardness.check_on(bodies, *normal)?;
        fallible::replace(&mut self.problem.hardness, hardness)
    }

    /// Changes the relative displacement of the next solve, which the contact does not cause. The function allocates
    /// memory only if no such displacement was set earlier.
    ///
    /// # Errors
    /// - [`Error::GridMismatch`] if the grid differs.
    /// - [`Error::Sample`] for a bulk strain along an axis in which the grid is periodic.
    /// - [`Error::Memory`] if memory runs out.
    /// - [`Error::Ranks`] if ranks fail.
    ///
    /// The displacement is unchanged after an error.
    pub fn set_relative_displacement(&mut self, relative: &RelativeDisplacement) -> Result<()> {
        let CoupledProblem {
            bodies,
            relative: own,
            ..
        } = &mut self.problem;
        bodies.collective_result(relative.check(bodies, Axis::BOTH))?;
        fallible::replace(own, relative)?;
        self.engine.set_relative_displacement(relative);
        Ok(())
    }
}

impl Contact for CoupledProblem {
    type Solution = CoupledSolution;
    type Report = CoupledReport;
}

impl Model<CoupledSolution> for CoupledProblem {
    type Engine = CoupledIncrement;

    model_fields!(settings);

    fn check_settings(&self, settings: &Settings) -> Result<()> {
        TangentialModel::Vector.check(settings)
    }

    fn engine(&self) -> Result<CoupledIncrement> {
        let mut increment = CoupledIncrement::new(&self.bodies)?;
        increment.last_gap = Some(LastGap::new(self.bodies.grid())?);
        if let Some(relative) = &self.relative {
            increment.set_relative_displacement(relative);
        }
        Ok(increment)
    }

    fn empty_solution(&self) -> Result<CoupledSolution> {
        CoupledSolution::empty(&self.bodies, &self.gap)
    }

    fn check_solution(&self, solution: &CoupledSolution) -> Result<()> {
        let (grid, boundary) = (solution.normal().grid(), solution.normal().boundary());
        self.bodies.check_host("solution", grid, boundary)
    }

    fn solve(
        solver: &mut CoupledSolver,
        solution: &mut CoupledSolution,
        observer: Observer<'_>,
    ) -> Result<()> {
        let (problem, increment) = (&solver.problem, &mut solver.engine);
        let cancellation = Cancellation::default();
        let mut observer = cancellation.watch(&problem.settings, observer);
        let mut conditions = SolveContext::new(&problem.settings, &mut observer);
        let demand = CoupledTarget {
            gap: &problem.gap,
            friction: &problem.friction,
            hardness: problem.hardness.as_ref(),
            normal: problem.normal,
            tangential: problem.tangential.demand(),
        };
        let wear = increment.take_wear(&problem.gap);
        let outcome = increment.solve(demand, RigidMotion::default(), &mut conditions);
        let report = increment.report_mut();
        let outcome = cancellation.applied(&problem.bodies, outcome, || report.cancelled());
        if has_iterate(&outcome) {
            solution.fill(problem, increment);
            increment.finish_gap(&problem.gap, wear, solution.normal_mut());
        } else if let Some(last) = &mut increment.last_gap {
            last.postpone(wear);
        }
        // The next solve must not start from NaN. If memory ran out, it must not start from the incomplete state
        // either.
        let is_broken = outcome.is_err() && !increment.report().residual.is_finite();
        if is_broken || matches!(outcome, Err(Error::Memory { .. })) {
            increment.forget();
        }
        outcome
    }

    fn report(solver: &CoupledSolver) -> &CoupledReport {
        solver.engine.full_report()
    }

    fn reset(solver: &mut CoupledSolver) {
        solver.engine.forget();
    }
}
