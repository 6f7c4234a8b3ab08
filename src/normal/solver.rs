//! Reusable solver of a normal contact.

use std::ops::ControlFlow;

use crate::bodies::component::Direction;
use crate::cgm::solver_settings;
use crate::contact::{has_iterate, solver_methods};
use crate::error::Result;
use crate::grid::field::{self, Field};
use crate::memory::fallible;
use crate::normal::pressure_solver::PressureSolver;
use crate::normal::problem::check_gap;
use crate::normal::{NormalControl, NormalProblem, NormalSolution};
use crate::observer::Observer;
use crate::parallel;
use crate::support::debug::shown;

/// Solver of a sequence of normal contacts on one grid.
///
/// Each solve starts from the last solution, which is extrapolated along its trend if the load has changed. If the
/// contact will outgrow the window of the last solution, the solve starts on coarser cells, like the first solve.
///
/// The solver owns plans, buffers and the last pressure. The load and the gap may change between calls.
///
/// ```
/// use stickslip::{ElasticPair, Grid, HalfSpace, Material, NormalControl, NormalProblem, surface};
/// let grid = Grid::square(32, 8.0)?;
/// let bodies = HalfSpace::new(grid, ElasticPair::new(Material::new(1.0, 0.3)?, Material::rigid())?)?;
/// let ball = surface::sphere(grid, 10.0)?;
/// let mut solver = NormalProblem::builder(&bodies, &ball, NormalControl::Force(0.5)).build()?.into_solver()?;
/// let mut contact = solver.new_solution();
/// for force in [0.5, 1.0, 0.7] {
///     solver.set_load(NormalControl::Force(force))?;
///     solver.solve_into(&mut contact)?;
///     assert!((contact.force() - force).abs() < 1e-12);
/// }
/// # Ok::<(), stickslip::Error>(())
/// ```
#[derive(Clone)]
pub struct NormalSolver {
    problem: NormalProblem,
    press: PressureSolver,
    /// Last pressure on the whole grid, the start of the next solve.
    pressure: Vec<f64>,
}

shown!(NormalSolver: problem);

impl NormalSolver {
    pub(super) fn new(problem: NormalProblem) -> Result<Self> {
        let (bodies, grid) = (&problem.bodies, problem.bodies.grid());
        // An error of the kernel is returned here rather than by the first solve.
        bodies.compliance([Direction::Z], grid.whole().size())?;
        let pressure = bodies.collective_result(fallible::zeros(grid.cells()))?;
        Ok(Self {
            problem,
            press: PressureSolver::new(),
            pressure,
        })
    }

    /// Returns the load of the next solve.
    pub(crate) fn load(&self) -> NormalControl {
        self.problem.load
    }

    /// Changes the load of the next solve.
    ///
    /// # Errors
    /// Errors of [`NormalProblemBuilder::build`](crate::normal::NormalProblemBuilder::build) that concern the load. The
    /// load is unchanged after an error.
    pub fn set_load(&mut self, load: NormalControl) -> Result<()> {
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

    /// Restores a load that was set earlier.
    pub(crate) fn restore_load(&mut self, load: NormalControl) {
        self.problem.load = load;
    }

    /// Changes the gap of the next solve, for instance after wear. The gap is copied without allocation unless the
    /// previous gap is shared with other owners.
    ///
    /// # Errors
    /// Errors of [`NormalProblemBuilder::build`](crate::normal::NormalProblemBuilder::build) that concern the gap. The
    /// gap is unchanged after an error.
    pub fn set_gap(&mut self, gap: &Field) -> Result<()> {
        let bodies = &self.problem.bodies;
        bodies.collective_result(check_gap(bodies, gap))?;
        self.problem.load.check(bodies, gap, None)?;
        field::replace(&mut self.problem.gap, gap)
    }

    solver_settings!(problem.settings, problem.bodies, |_, _| Ok(()));

    /// Discards the last solution. The next solve starts in the same way as the first.
    pub fn reset(&mut self) {
        self.press.reset();
    }

    solver_methods!(NormalSolution, problem.bodies);

    /// Creates a solution like [`Self::new_solution`], but returns an error if memory runs out.
    ///
    /// # Errors
    /// - [`Error::Memory`](crate::Error::Memory) if memory runs out.
    pub fn try_new_solution(&self) -> Result<NormalSolution> {
        let bodies = &self.problem.bodies;
        let surface = (bodies.boundary(), bodies.cell_value());
        NormalSolution::empty(&self.problem.gap, surface, bodies.pair())
    }

    fn solve_checked(
        &mut self,
        solution: &mut NormalSolution,
        observer: Observer<'_>,
    ) -> Result<()> {
        let of = self.problem.pressing();
        self.press
            .discard_if_window_too_small(&of, &self.pressure)?;
        let outcome = self.press.solve(&of, &mut self.pressure, observer);
        if has_iterate(&outcome) {
            parallel::copy(&self.pressure, solution.pressure_mut());
            self.press.finish(&of, solution);
            solution.measure_scale(of.bodies, of.gap);
        }
        outcome
    }

    /// Solves once and keeps only the solution.
    pub(super) fn into_solution(mut self) -> Result<NormalSolution> {
        let bodies = self.problem.bodies.clone();
        bodies.joint(parallel::enter_with(bodies.grid().cells(), || {
            let of = self.problem.pressing();
            let unwatched = &mut |_: &_| ControlFlow::Continue(());
            self.press.solve(&of, &mut self.pressure, unwatched)?;
            self.press.into_solution(&of, self.pressure)
        }))
    }
}
