//! The reusable solver of steady rolling.

use std::ops::ControlFlow;
use std::sync::Arc;

use crate::buffer::{collected, or_abort, try_each, zeros};
use crate::cgm::{self, Disc, Magnitude, Problem, Total, WorkspaceOf};
use crate::contact::has_iterate;
use crate::error::Result;
use crate::half_space::Compliance;
use crate::influence::Direction;
use crate::operator::Operator;
use crate::report::{Iteration, Report};
use crate::rolling::inverse::SteadyInverse;
use crate::rolling::operator::SteadyOperator;
use crate::rolling::step::Step;
use crate::rolling::{RollingControl, RollingProblem, RollingSolution};
use crate::shown::shown;
use crate::tangential::centre;

/// Solves for one creepage, force or spin after the other, each from the answer of the last.
///
/// ```
/// use stickslip::rolling::{RollingControl, RollingProblem};
/// use stickslip::*;
/// let grid = Grid::square(24, 3.0)?;
/// let bodies = HalfSpace::new(grid, ElasticPair::new(Material::new(1.0, 0.0)?, Material::rigid())?)?;
/// let (ball, load) = (surface::sphere(grid, 1.0)?, NormalControl::Force(4.0 / 3.0));
/// let normal = NormalProblem::builder(&bodies, &ball, load).build()?.solve()?;
/// let mut solver = RollingProblem::builder(&bodies, &normal, Friction::coulomb(0.3)?)
///     .build()?
///     .into_solver()?;
/// let mut rolling = solver.new_solution();
/// for force in [0.1, 0.2, 0.3, 0.39] {
///     solver.set_control([RollingControl::Force(force), RollingControl::Creepage(0.0)], 0.0)?;
///     let before = rolling.creepage()[0];
///     solver.solve_into(&mut rolling)?;
///     assert!((rolling.force()[0] - force).abs() < 1e-9 && rolling.creepage()[0] > before);
/// }
/// # Ok::<(), Error>(())
/// ```
pub struct RollingSolver {
    problem: RollingProblem,
    operator: Arc<SteadyOperator>,
    inverse: Arc<SteadyInverse>,
    workspace: WorkspaceOf<Arc<SteadyOperator>, Arc<SteadyInverse>, Disc, 2>,
    /// What tractions and displacements are measured in: one, or a power of two where their squares would leave the range
    /// of numbers.
    unit: f64,
    limits: Vec<f64>,
    traction: [Vec<f64>; 2],
    /// What a solve asks of each cell.
    linear: [Vec<f64>; 2],
}

shown!(RollingSolver: problem);

impl RollingSolver {
    pub(super) fn new(mut problem: RollingProblem) -> Result<Self> {
        let step = problem.step;
        let Compliance { operator, inverse } = problem
            .bodies
            .compliance([Direction::X, Direction::Y], step.size)?;
        let own = std::mem::take(&mut problem.own);
        let elastic = elastic_part(&*operator, step)?;
        let operator = SteadyOperator::new(operator, step, own, problem.chain);
        let inverse = SteadyInverse::new(inverse, step, elastic, operator.own());
        let (operator, inverse) = (Arc::new(operator), Arc::new(inverse));
        let cells = operator.cells();
        let unit = problem.pressed.limits.unit().unwrap_or(1.0);
        let limits = problem.pressed.limits.cells.iter();
        Ok(Self {
            limits: collected(cells, limits.map(|limit| limit / unit))?,
            unit,
            workspace: Problem::new(Arc::clone(&operator), [&[]; 2], Magnitude(&[]))
                .preconditioner(Arc::clone(&inverse))
                .try_workspace()?,
            traction: try_each(|_| zeros(cells))?,
            linear: try_each(|_| zeros(cells))?,
            operator,
            inverse,
            problem,
        })
    }

    /// Changes what is prescribed of the next solve: along x and along y, and the spin.
    ///
    /// # Errors
    /// [`Error::NotFinite`](crate::Error::NotFinite), [`Error::NotModelled`](crate::Error::NotModelled) or
    /// [`Error::BeyondFrictionCapacity`](crate::Error::BeyondFrictionCapacity); all is then as it was.
    pub fn set_control(&mut self, controls: [RollingControl; 2], spin: f64) -> Result<()> {
        self.problem.check(controls, spin)?;
        (self.problem.controls, self.problem.spin) = (controls, spin);
        Ok(())
    }

    /// An empty solution of the right size for [`Self::solve_into`].
    #[must_use]
    pub fn new_solution(&self) -> RollingSolution {
        or_abort(self.try_new_solution())
    }

    /// [`Self::new_solution`] where memory may run out.
    ///
    /// # Errors
    /// [`Error::Memory`](crate::Error::Memory).
    pub fn try_new_solution(&self) -> Result<RollingSolution> {
        RollingSolution::empty(self.problem.bodies.grid())
    }

    /// Solves into `solution`, whose last content does not matter.
    ///
    /// # Errors
    /// [`Error::GridMismatch`](crate::Error::GridMismatch), nothing changed;
    /// [`Error::NotConverged`](crate::Error::NotConverged) with the last feasible iterate in `solution`.
    pub fn solve_into(&mut self, solution: &mut RollingSolution) -> Result<()> {
        self.solve_observed(solution, |_| ControlFlow::Continue(()))
    }

    /// [`Self::solve_into`] with an observer that sees every step and may cancel.
    ///
    /// # Errors
    /// As [`Self::solve_into`].
    pub fn solve_observed(
        &mut self,
        solution: &mut RollingSolution,
        mut observer: impl FnMut(&Iteration) -> ControlFlow<()> + Send,
    ) -> Result<()> {
        self.problem
            .bodies
            .grid()
            .expect("solution", solution.grid())?;
        let totals = self.prescribe();
        let problem = &self.problem;
        let linear = self.linear.each_ref().map(Vec::as_slice);
        let task = Problem::new(Arc::clone(&self.operator), linear, Magnitude(&self.limits))
            .preconditioner(Arc::clone(&self.inverse))
            .totals(totals);
        let traction = self.traction.each_mut().map(Vec::as_mut_slice);
        let (settings, workspace) = (&problem.settings, &mut self.workspace);
        let outcome = cgm::minimise_with(&task, settings, traction, workspace, &mut observer);
        if has_iterate(&outcome) {
            let unit = self.unit;
            let multiplier = self.workspace.multiplier().map(|shift| shift * unit);
            let creepage = [0, 1].map(|axis| match problem.controls[axis] {
                RollingControl::Creepage(creepage) => creepage,
                RollingControl::Force(_) => multiplier[axis] / problem.length,
            });
            let product = self.workspace.product();
            let slip = |axis: usize, cell: usize| {
                unit * (product[axis][cell] + self.linear[axis][cell]) - multiplier[axis]
            };
            let traction = |axis: usize, cell: usize| unit * self.traction[axis][cell];
            let answer = solution.of(problem, traction, slip);
            answer.set_motion(creepage, problem.spin, self.workspace.report());
        }
        outcome
    }

    /// Writes what each cell is to follow, and returns what is prescribed of the sums.
    fn prescribe(&mut self) -> [Total; 2] {
        let problem = &self.problem;
        let (grid, window) = (problem.bodies.grid(), problem.pressed.window());
        let given = problem.controls.map(|control| match control {
            RollingControl::Creepage(creepage) => creepage,
            RollingControl::Force(_) => 0.0,
        });
        let edge = problem.step.edge;
        let half = if edge.is_positive() { 0.5 } else { -0.5 } * problem.length;
        for (cell, index) in window.indices().enumerate() {
            let mut middle = centre(grid, index);
            middle[edge.axis().index()] += half;
            let turned = [-problem.spin * middle[1], problem.spin * middle[0]];
            for axis in 0..2 {
                let moved = problem.length * (given[axis] + turned[axis]);
                self.linear[axis][cell] = (problem.drawn[axis][cell] - moved) / self.unit;
            }
        }
        let area = grid.cell_area();
        problem.controls.map(|control| match control {
            RollingControl::Creepage(_) => Total::Free,
            RollingControl::Force(force) => Total::Sum(force / area / self.unit),
        })
    }

    /// The report of the last solve.
    #[must_use]
    pub fn report(&self) -> &Report {
        self.workspace.report()
    }
}

/// What a cell slips over a step by a traction of its own.
fn elastic_part(compliance: &impl Operator<2>, step: Step) -> Result<f64> {
    let cells = compliance.cells();
    let (mut unit, mut image): ([Vec<f64>; 2], [Vec<f64>; 2]) =
        (try_each(|_| zeros(cells))?, try_each(|_| zeros(cells))?);
    let last = step.trailing_cell();
    unit[0][last] = 1.0;
    compliance.apply(
        unit.each_ref().map(Vec::as_slice),
        image.each_mut().map(Vec::as_mut_slice),
        &mut compliance.try_workspace()?,
    );
    step.difference(&mut image[0]);
    Ok(image[0][last])
}
