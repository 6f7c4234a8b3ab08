//! Methods that the reusable solvers of all contacts have in common.

/// Methods of a solver that create solutions of the right size and solve. The solver must have `try_new_solution` and
/// `solve_checked`, and must store its bodies in `$($bodies).+`. The grid of a solution is the grid of its `$half`, if it has
/// halves.
macro_rules! solver_methods {
    ($Solution:ident $(.$half:ident())?, $($bodies:ident).+) => {
        /// Creates an empty solution of the right size for [`Self::solve_into`].
        #[must_use]
        pub fn new_solution(&self) -> $Solution {
            crate::memory::fallible::unwrap_or_abort(self.try_new_solution())
        }

        /// Solves into `solution` and overwrites its previous content.
        ///
        /// # Errors
        /// - [`Error::GridMismatch`](crate::Error::GridMismatch) or [`Error::BoundaryMismatch`](crate::Error::BoundaryMismatch)
        ///   if the solution has a different grid or boundary. Nothing is then changed.
        /// - The errors of [`HalfSpace::operator`](crate::HalfSpace::operator).
        /// - [`Error::BeyondFrictionCapacity`](crate::Error::BeyondFrictionCapacity) if the solve shows that a force slides the
        ///   contact.
        /// - [`Error::NotConverged`](crate::Error::NotConverged), with the last feasible iterate in `solution`.
        /// - [`Error::Ranks`](crate::Error::Ranks) if ranks fail or pass different input.
        pub fn solve_into(&mut self, solution: &mut $Solution) -> Result<()> {
            self.solve_observed(solution, |_| std::ops::ControlFlow::Continue(()))
        }

        /// Solves like [`Self::solve_into`] with an observer that is called at every step and may cancel. After a cancellation
        /// the solve returns [`Error::NotConverged`](crate::Error::NotConverged) with
        /// [`Status::Cancelled`](crate::Status::Cancelled), even if the iterate satisfies the tolerance.
        ///
        /// # Errors
        /// The errors of [`Self::solve_into`].
        pub fn solve_observed(
            &mut self,
            solution: &mut $Solution,
            mut observer: impl FnMut(&crate::Iteration) -> std::ops::ControlFlow<()> + Send,
        ) -> Result<()> {
            let bodies = self.$($bodies).+.clone();
            let (grid, boundary) = {
                let half = &*solution $(.$half())?;
                (half.grid(), half.boundary())
            };
            bodies.collective_result(bodies.check_host("solution", grid, boundary))?;
            bodies.joint(crate::parallel::enter_with(grid.cells(), || {
                self.solve_checked(solution, &mut observer)
            }))
        }
    };
}

pub(crate) use solver_methods;
