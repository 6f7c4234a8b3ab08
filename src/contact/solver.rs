//! The reusable solver of all kinds of contacts.

use std::fmt;
use std::ops::ControlFlow;

use crate::cgm::Settings;
use crate::error::Result;
use crate::half_space::HalfSpace;
use crate::memory::fallible::{TryClone, unwrap_or_abort};
use crate::observer::Observer;
use crate::parallel;
use crate::report::Iteration;

/// Problem of a contact, the input of a [`Solver`].
///
/// The problems of the crate implement this trait, for example [`NormalProblem`](crate::NormalProblem). The trait is sealed,
/// because each kind of contact has its own engine.
#[expect(private_bounds, reason = "the trait is sealed")]
pub trait Contact: Model<<Self as Contact>::Solution> {
    /// Solution of the problem.
    type Solution: TryClone + PartialEq + fmt::Debug + Send;
    /// Report of a solve.
    type Report: Clone + PartialEq + fmt::Debug;
}

/// Engine of a kind of contact, which the solver of this contact runs.
pub(crate) trait Model<S>: Sized + Send {
    /// Operators, buffers and the last solution.
    type Engine: Send;

    fn bodies(&self) -> &HalfSpace;

    fn settings(&self) -> &Settings;

    fn settings_mut(&mut self) -> &mut Settings;

    /// Returns an error if the model does not support the settings.
    fn check_settings(&self, settings: &Settings) -> Result<()>;

    /// Creates the operators and buffers.
    fn engine(&self) -> Result<Self::Engine>;

    /// Creates an empty solution.
    fn empty_solution(&self) -> Result<S>;

    /// Returns an error if the solution has a different grid or boundary.
    fn check_solution(&self, solution: &S) -> Result<()>;

    /// Solves into a checked solution.
    fn solve(solver: &mut Solver<Self>, solution: &mut S, observer: Observer<'_>) -> Result<()>
    where
        Self: Contact<Solution = S>;

    /// Returns the report of the last solve.
    fn report(solver: &Solver<Self>) -> &Self::Report
    where
        Self: Contact<Solution = S>;

    /// Discards the last solution.
    fn reset(solver: &mut Solver<Self>)
    where
        Self: Contact<Solution = S>;
}

/// Accessors of a [`Model`], which are identical for all problems. The problem stores its settings in `$($path).+`.
macro_rules! model_fields {
    ($($path:ident).+) => {
        fn bodies(&self) -> &crate::half_space::HalfSpace {
            &self.bodies
        }

        fn settings(&self) -> &crate::cgm::Settings {
            &self.$($path).+
        }

        fn settings_mut(&mut self) -> &mut crate::cgm::Settings {
            &mut self.$($path).+
        }
    };
}

pub(crate) use model_fields;

/// Solver of a sequence of problems of one kind. Each solve starts from the last solution.
///
/// Each kind of contact has an alias: [`NormalSolver`](crate::NormalSolver),
/// [`TangentialSolver`](crate::TangentialSolver) and others. The setters of loads and fields are methods of these solvers. A
/// function with a [`Contact`] as its parameter accepts solvers of any kind:
///
/// ```
/// use stickslip::*;
/// fn solve_to<P: Contact>(solver: &mut Solver<P>, tolerance: f64) -> Result<P::Solution> {
///     let settings = solver.settings().tolerance(tolerance);
///     solver.set_settings(settings)?;
///     let mut solution = solver.try_new_solution()?;
///     solver.solve_into(&mut solution)?;
///     Ok(solution)
/// }
///
/// let grid = Grid::square(32, 3.0)?;
/// let bodies = HalfSpace::new(grid, ElasticPair::new(Material::new(1.0, 0.5)?, Material::rigid())?)?;
/// let (ball, press) = (surface::sphere(grid, 10.0)?, NormalLoad::Force(0.1));
/// let normal = NormalProblem::builder(&bodies, &ball, press).build()?;
/// let normal = solve_to(&mut normal.into_solver()?, 1e-10)?;
/// let (friction, load) = (Friction::coulomb(0.3)?, TangentialLoad::force([0.02, 0.0]));
/// let tangential = TangentialProblem::builder(&bodies, &normal, friction, load).build()?;
/// let tangential = solve_to(&mut tangential.into_solver()?, 1e-10)?;
/// assert!((tangential.force()[0] - 0.02).abs() < 1e-11);
/// # Ok::<(), Error>(())
/// ```
///
/// # Methods of each kind
///
/// A load or field that is not part of the problem has no setter.
///
/// | method | normal | tangential | coupled | rolling | coupled rolling |
/// |---|---|---|---|---|---|
/// | `set_load` | force or approach | force or motion | both loads | creepages, forces, spin | creepages, forces, spin |
/// | `set_normal_load` | | | | with `set_normal_solver` | yes |
/// | `set_loads` | | | | | all loads |
/// | `gap`, `set_gap` | yes | | yes | | yes |
/// | `set_pressure` | | yes | | yes | |
/// | `friction`, `set_friction` | | yes | yes | yes | yes |
/// | `set_hardness` | yes | | yes | | |
/// | `set_relative_displacement` | | yes | yes | | |
/// | `friction_capacity` | | yes | | yes | |
/// | `sensitivity` | yes | yes | yes | | |
/// | `stiffness` | of the solution | of the solution | of the solution | yes | yes |
///
/// A stiffness belongs to a solution. The solvers of rolling return [`Error::OutdatedSolution`](crate::Error::OutdatedSolution) if a
/// load or a field has changed since the last solve. The solutions of the other solvers do not change with their solver.
/// A sensitivity combines a solution with the present problem, and returns this error for a solution of an earlier problem.
#[derive(Clone)]
pub struct Solver<P: Contact> {
    pub(crate) problem: P,
    pub(crate) engine: P::Engine,
}

impl<P: Contact + fmt::Debug> fmt::Debug for Solver<P> {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut shown = formatter.debug_struct("Solver");
        shown
            .field("problem", &self.problem)
            .finish_non_exhaustive()
    }
}

impl<P: Contact> Solver<P> {
    pub(crate) fn new(problem: P) -> Result<Self> {
        let engine = problem.engine()?;
        Ok(Self { problem, engine })
    }

    /// Returns the settings of the next solve.
    #[must_use]
    pub fn settings(&self) -> &Settings {
        self.problem.settings()
    }

    /// Changes tolerance, method and limits of the next solve. This solve still starts from the last solution.
    ///
    /// # Errors
    /// The settings remain unchanged after an error:
    /// - The errors of [`Settings::check`].
    /// - [`Error::Method`](crate::Error::Method) if the model does not support the method.
    /// - [`Error::Ranks`](crate::Error::Ranks) if the settings differ between ranks or if one of the ranks fails.
    pub fn set_settings(&mut self, settings: Settings) -> Result<()> {
        let problem = &mut self.problem;
        let checked = settings
            .check()
            .and_then(|()| problem.check_settings(&settings));
        let bodies = problem.bodies();
        bodies.collective_result_checked(checked, &[("settings", &settings.common())])?;
        *problem.settings_mut() = settings;
        Ok(())
    }

    /// Returns the report of the last solve: its status, cost and error bounds.
    #[must_use]
    pub fn report(&self) -> &P::Report {
        P::report(self)
    }

    /// Discards the last solution. The next solve starts in the same way as the first.
    pub fn reset(&mut self) {
        P::reset(self);
    }

    /// Creates an empty solution of the right size for [`Self::solve_into`].
    #[must_use]
    pub fn new_solution(&self) -> P::Solution {
        unwrap_or_abort(self.try_new_solution())
    }

    /// Creates a solution like [`Self::new_solution`], but returns an error if memory runs out.
    ///
    /// # Errors
    /// - [`Error::Memory`](crate::Error::Memory) if memory runs out.
    pub fn try_new_solution(&self) -> Result<P::Solution> {
        self.problem.empty_solution()
    }

    /// Solves into `solution` and overwrites its previous content.
    ///
    /// # Errors
    /// - [`Error::GridMismatch`](crate::Error::GridMismatch) or [`Error::BoundaryMismatch`](crate::Error::BoundaryMismatch)
    ///   if the solution has a different grid or boundary. Nothing is then changed.
    /// - The errors of [`HalfSpace::operator`].
    /// - [`Error::BeyondFrictionCapacity`](crate::Error::BeyondFrictionCapacity) or
    ///   [`Error::BeyondFrictionMoment`](crate::Error::BeyondFrictionMoment) if the solve shows that a force or moment slides
    ///   the contact.
    /// - [`Error::EmptyContact`](crate::Error::EmptyContact) or [`Error::GridTooShort`](crate::Error::GridTooShort) if no cell
    ///   carries pressure in coupled rolling, or if the grid ends less than a step ahead of the contact.
    /// - [`Error::NotConverged`](crate::Error::NotConverged), with the last feasible iterate in `solution`.
    /// - [`Error::Memory`](crate::Error::Memory) if memory runs out.
    /// - [`Error::Ranks`](crate::Error::Ranks) if ranks fail or pass different input.
    pub fn solve_into(&mut self, solution: &mut P::Solution) -> Result<()> {
        self.solve_observed(solution, |_| ControlFlow::Continue(()))
    }

    /// Solves like [`Self::solve_into`] with an observer that is called at every step and may cancel. After a cancellation or the
    /// time limit the observer is not called again. After a cancellation the solve returns
    /// [`Error::NotConverged`](crate::Error::NotConverged) with [`Status::Cancelled`](crate::Status::Cancelled), even if the
    /// iterate satisfies the tolerance.
    ///
    /// # Errors
    /// The errors of [`Self::solve_into`].
    pub fn solve_observed(
        &mut self,
        solution: &mut P::Solution,
        mut observer: impl FnMut(&Iteration) -> ControlFlow<()> + Send,
    ) -> Result<()> {
        let bodies = self.problem.bodies().clone();
        bodies.collective_result(self.problem.check_solution(solution))?;
        bodies.joint(parallel::enter_with(bodies.grid().cells(), || {
            P::solve(self, solution, &mut observer)
        }))
    }

    /// Solves once with temporary buffers.
    pub(crate) fn solve_once(problem: &P) -> Result<P::Solution>
    where
        P: TryClone,
    {
        let mut solver = Self::new(problem.try_clone()?)?;
        let mut solution = solver.try_new_solution()?;
        solver.solve_into(&mut solution)?;
        Ok(solution)
    }
}
