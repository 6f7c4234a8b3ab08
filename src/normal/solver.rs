//! Reusable solver of a normal contact.

use std::ops::ControlFlow;

use crate::bodies::component::Direction;
use crate::cgm::Settings;
use crate::contact::{Contact, Model, Solver, has_iterate, model_fields};
use crate::error::Result;
use crate::grid::field::{self, Field};
use crate::grid::window::Window;
use crate::memory::fallible;
use crate::normal::pressure_solver::PressureSolver;
use crate::normal::problem::check_gap;
use crate::normal::{Hardness, LastGap, NormalLoad, NormalProblem, NormalSolution};
use crate::observer::Observer;
use crate::parallel;
use crate::report::Report;

/// Solver of a sequence of normal contacts on one grid.
///
/// Each solve starts from the last solution, which is extrapolated along its trend if the load has changed. If the
/// contact will outgrow the window of the last solution, the solve starts on coarser cells, like the first solve.
///
/// The solver owns plans, buffers and the last pressure. The load and the gap may change between calls.
///
/// ```
/// use stickslip::{ElasticPair, Grid, HalfSpace, Material, NormalLoad, NormalProblem, surface};
/// let grid = Grid::square(32, 8.0)?;
/// let bodies = HalfSpace::new(grid, ElasticPair::new(Material::new(1.0, 0.3)?, Material::rigid())?)?;
/// let ball = surface::sphere(grid, 10.0)?;
/// let mut solver = NormalProblem::builder(&bodies, &ball, NormalLoad::Force(0.5)).build()?.into_solver()?;
/// let mut contact = solver.new_solution();
/// for force in [0.5, 1.0, 0.7] {
///     solver.set_load(NormalLoad::Force(force))?;
///     solver.solve_into(&mut contact)?;
///     assert!((contact.force() - force).abs() < 1e-12);
/// }
/// # Ok::<(), stickslip::Error>(())
/// ```
pub type NormalSolver = Solver<NormalProblem>;

#[derive(Clone)]
pub(crate) struct NormalBuffers {
    press: PressureSolver,
    /// Last pressure on the whole grid, the start of the next solve.
    pressure: Vec<f64>,
    last_gap: LastGap,
}

/// Returns the last pressure and its approach, or `None` before the first solve.
fn last_contact<'a>(press: &PressureSolver, pressure: &'a [f64]) -> Option<(&'a [f64], f64)> {
    press.window().map(|_| (pressure, press.approach()))
}

impl NormalSolver {
    /// Returns the load of the next solve.
    pub(crate) fn load(&self) -> NormalLoad {
        self.problem.load
    }

    /// Changes the load of the next solve.
    ///
    /// # Errors
    /// Errors of [`NormalProblemBuilder::build`](crate::normal::NormalProblemBuilder::build) that concern the load. The
    /// load is unchanged after an error.
    pub fn set_load(&mut self, load: NormalLoad) -> Result<()> {
        let NormalProblem {
            bodies,
            gap,
            hardness,
            ..
        } = &self.problem;
        bodies.collective_result_checked(Ok(()), &[("normal load", &load)])?;
        load.check(bodies, gap, hardness.as_ref())?;
        self.problem.load = load;
        Ok(())
    }

    /// Returns the gap before loading of the next solve: the last gap that was given or [set](Self::set_gap). The gap of a
    /// [solution](NormalSolution::gap) is a different field, the gap under load.
    #[must_use]
    pub fn gap(&self) -> &Field {
        &self.problem.gap
    }

    /// Returns the window of the last solve, or `None` before the first solve.
    pub(crate) fn window(&self) -> Option<Window> {
        self.engine.press.window()
    }

    /// Restores a load that was set earlier.
    pub(crate) fn restore_load(&mut self, load: NormalLoad) {
        self.problem.load = load;
    }

    /// Changes the gap of the next solve, for instance after wear. The gap is copied without allocation unless the
    /// previous gap is shared with other owners.
    ///
    /// The next solution has the warning [`LargeGapChange`](crate::Warning::LargeGapChange) after wear much deeper than the
    /// displacements.
    ///
    /// # Errors
    /// - [`Error::GapUnderLoad`](crate::Error::GapUnderLoad) if the gap is the gap under load of the last solution.
    /// - Errors of [`NormalProblemBuilder::build`](crate::normal::NormalProblemBuilder::build) that concern the gap.
    ///
    /// The gap is unchanged after an error.
    pub fn set_gap(&mut self, gap: &Field) -> Result<()> {
        let bodies = &self.problem.bodies;
        let last = &self.engine.last_gap;
        bodies.collective_result(check_gap(bodies, gap).and_then(|()| last.check(gap)))?;
        self.problem.load.check(bodies, gap, None)?;
        self.engine.last_gap.store(&self.problem.gap);
        field::replace(&mut self.problem.gap, gap)
    }

    /// Replaces the gap of the next solve without a check. The solver does not compare the gap with earlier gaps.
    #[cfg(feature = "rolling")]
    pub(crate) fn replace_gap(&mut self, gap: &Field) -> Result<()> {
        field::replace(&mut self.problem.gap, gap)
    }

    /// Returns the last pressure and its approach, or `None` before the first solve.
    pub(crate) fn last_contact(&self) -> Option<(&[f64], f64)> {
        last_contact(&self.engine.press, &self.engine.pressure)
    }

    /// Changes the largest pressure that the cells can carry in the next solve.
    ///
    /// # Errors
    /// - [`Error::GridMismatch`](crate::Error::GridMismatch) if the grid differs.
    /// - [`Error::BeyondHardness`](crate::Error::BeyondHardness) if the present force exceeds the capacity of the cells.
    /// - [`Error::Memory`](crate::Error::Memory) if memory runs out.
    /// - [`Error::Ranks`](crate::Error::Ranks) if ranks fail or pass different hardness.
    ///
    /// The hardness is unchanged after an error.
    pub fn set_hardness(&mut self, hardness: &Hardness) -> Result<()> {
        let NormalProblem { bodies, load, .. } = &self.problem;
        hardness.check_on(bodies, *load)?;
        fallible::replace(&mut self.problem.hardness, hardness)
    }

    /// Solves once and keeps only the solution.
    pub(super) fn into_solution(self) -> Result<NormalSolution> {
        let Self {
            problem,
            mut engine,
        } = self;
        let (bodies, of) = (&problem.bodies, problem.pressing());
        bodies.joint(parallel::enter_with(bodies.grid().cells(), || {
            let unwatched = &mut |_: &_| ControlFlow::Continue(());
            engine.press.solve(&of, &mut engine.pressure, unwatched)?;
            engine.press.into_solution(&of, engine.pressure)
        }))
    }
}

impl Contact for NormalProblem {
    type Solution = NormalSolution;
    type Report = Report;
}

impl Model<NormalSolution> for NormalProblem {
    type Engine = NormalBuffers;

    model_fields!(settings);

    fn check_settings(&self, _: &Settings) -> Result<()> {
        Ok(())
    }

    fn engine(&self) -> Result<NormalBuffers> {
        let (bodies, grid) = (&self.bodies, self.bodies.grid());
        // An error of the kernel is returned here rather than by the first solve.
        bodies.compliance([Direction::Z], grid.whole().size())?;
        Ok(NormalBuffers {
            press: PressureSolver::new(),
            pressure: bodies.collective_result(fallible::zeros(grid.cells()))?,
            last_gap: bodies.collective_result(LastGap::new(grid))?,
        })
    }

    fn empty_solution(&self) -> Result<NormalSolution> {
        let surface = (self.bodies.boundary(), self.bodies.cell_value());
        NormalSolution::empty(&self.gap, surface, self.bodies.pair())
    }

    fn check_solution(&self, solution: &NormalSolution) -> Result<()> {
        let (grid, boundary) = (solution.grid(), solution.boundary());
        self.bodies.check_host("solution", grid, boundary)
    }

    fn solve(
        solver: &mut NormalSolver,
        solution: &mut NormalSolution,
        observer: Observer<'_>,
    ) -> Result<()> {
        let of = solver.problem.pressing();
        let NormalBuffers {
            press,
            pressure,
            last_gap,
        } = &mut solver.engine;
        let wear = last_gap.take_wear(of.bodies, of.gap, last_contact(press, pressure));
        press.discard_costly_start(&of, pressure);
        let outcome = press.solve(&of, pressure, observer);
        if has_iterate(&outcome) {
            parallel::copy(pressure, solution.pressure_mut());
            press.finish(&of, solution);
            solution.measure_scale(of.bodies, of.gap);
            last_gap.finish((of.bodies, of.gap), wear, solution);
        } else {
            last_gap.postpone(wear);
        }
        outcome
    }

    fn report(solver: &NormalSolver) -> &Report {
        solver.engine.press.report()
    }

    fn reset(solver: &mut NormalSolver) {
        solver.engine.press.reset();
    }
}
