//! The reusable solver of a normal contact.

use std::ops::ControlFlow;
use std::sync::Arc;

use crate::cgm::{self, Iteration, NonNegative, Problem, Workspace};
use crate::error::{Error, Result};
use crate::fft::{CirculantInverse, Convolution};
use crate::field::Field;
use crate::half_space::Compliance;
use crate::influence::Component;
use crate::normal::problem::check_gap;
use crate::normal::{NormalLoad, NormalProblem, NormalSolution};
use crate::parallel;

/// Solves normal contacts on one grid again and again, each time from the last answer.
///
/// Owns plans, buffers and the last pressure; the load and the gap may change between calls.
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
#[derive(Debug)]
pub struct NormalSolver {
    problem: NormalProblem,
    compliance: Compliance,
    workspace: Workspace<Arc<Convolution>, Arc<CirculantInverse>>,
    /// The last pressure, the start of the next solve.
    pressure: Vec<f64>,
    is_warm: bool,
    /// The gap from its least value, or from the approach where that is prescribed.
    linear: Vec<f64>,
}

impl NormalSolver {
    pub(super) fn new(problem: NormalProblem) -> Result<Self> {
        let compliance = problem.bodies.compliance(Component::ZZ)?;
        let workspace = Workspace::new(&compliance.operator, &compliance.inverse);
        let cells = problem.gap.grid().cells();
        Ok(Self {
            problem,
            compliance,
            workspace,
            pressure: vec![0.0; cells],
            is_warm: false,
            linear: vec![0.0; cells],
        })
    }

    /// Changes the load of the next solve.
    ///
    /// # Errors
    /// [`Error::Negative`] or [`Error::NotFinite`]; the load is then as it was.
    pub fn set_load(&mut self, load: NormalLoad) -> Result<()> {
        load.check()?;
        self.problem.load = load;
        Ok(())
    }

    /// Changes the gap of the next solve, as wear does; copies it without allocating.
    ///
    /// # Errors
    /// [`Error::GridMismatch`] or [`Error::Sample`]; the gap is then as it was.
    pub fn set_gap(&mut self, gap: &Field) -> Result<()> {
        check_gap(&self.problem.bodies, gap)?;
        self.problem
            .gap
            .as_mut_slice()
            .copy_from_slice(gap.as_slice());
        Ok(())
    }

    /// Forgets the last answer: the next solve starts as the first did.
    pub fn reset(&mut self) {
        self.is_warm = false;
    }

    /// An empty solution of the right size for [`NormalSolver::solve_into`].
    #[must_use]
    pub fn new_solution(&self) -> NormalSolution {
        NormalSolution::empty(&self.problem.gap)
    }

    /// Solves into `solution`, whose last content does not matter.
    ///
    /// # Errors
    /// [`Error::GridMismatch`] if the solution is of another grid, nothing changed;
    /// [`Error::NotConverged`] with the last feasible iterate in `solution`.
    pub fn solve_into(&mut self, solution: &mut NormalSolution) -> Result<()> {
        self.solve_observed(solution, |_| ControlFlow::Continue(()))
    }

    /// [`NormalSolver::solve_into`] with an observer that sees every step and may cancel.
    ///
    /// # Errors
    /// As [`NormalSolver::solve_into`].
    pub fn solve_observed(
        &mut self,
        solution: &mut NormalSolution,
        mut observer: impl FnMut(&Iteration) -> ControlFlow<()>,
    ) -> Result<()> {
        let gap = &self.problem.gap;
        if solution.pressure().grid() != gap.grid() {
            return Err(Error::GridMismatch {
                quantity: "solution",
            });
        }
        let area = gap.grid().cell_area();
        // Without a datum far from the contact the sums keep their last digits.
        let datum = match self.problem.load {
            NormalLoad::Force(_) => gap.min(),
            NormalLoad::Approach(approach) => approach,
        };
        let samples = gap.as_slice();
        parallel::update(&mut self.linear, |first, chunk| {
            for (linear, gap) in chunk.iter_mut().zip(&samples[first..]) {
                *linear = gap - datum;
            }
        });

        let problem = Problem::new(
            Arc::clone(&self.compliance.operator),
            &self.linear,
            NonNegative,
        )
        .preconditioner(Arc::clone(&self.compliance.inverse));
        let problem = match self.problem.load {
            NormalLoad::Force(force) => problem.total(force / area),
            NormalLoad::Approach(_) => problem,
        };
        if !self.is_warm {
            let start = match self.problem.load {
                NormalLoad::Force(force) => force / gap.grid().area(),
                NormalLoad::Approach(_) => 0.0,
            };
            self.pressure.fill(start);
        }
        self.is_warm = true;
        let outcome = cgm::minimise_with(
            &problem,
            &self.problem.settings,
            &mut self.pressure,
            &mut self.workspace,
            &mut observer,
        );
        if matches!(outcome, Ok(()) | Err(Error::NotConverged(_))) {
            solution.fill(
                gap,
                &self.pressure,
                self.workspace.product(),
                datum + self.workspace.multiplier(),
                self.workspace.report(),
            );
        }
        outcome
    }
}
