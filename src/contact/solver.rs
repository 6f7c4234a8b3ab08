//! What the reusable solvers of all contacts have, word for word.

/// Solutions of the right size, and the ways to solve, of a solver that has `try_new_solution` and `solve_checked` and keeps
/// its bodies in `$($bodies).+`; the grid of a solution is that of its `$half`, if it has halves.
macro_rules! solver_methods {
    ($Solution:ident $(.$half:ident())?, $($bodies:ident).+) => {
        /// An empty solution of the right size for [`Self::solve_into`].
        #[must_use]
        pub fn new_solution(&self) -> $Solution {
            crate::memory::fallible::unwrap_or_abort(self.try_new_solution())
        }

        /// Solves into `solution`, whose last content does not matter.
        ///
        /// # Errors
        /// [`Error::GridMismatch`](crate::Error::GridMismatch) or [`Error::BoundaryMismatch`](crate::Error::BoundaryMismatch)
        /// if the solution is of another grid or boundary, nothing changed; as
        /// [`HalfSpace::operator`](crate::HalfSpace::operator);
        /// [`Error::BeyondFrictionCapacity`](crate::Error::BeyondFrictionCapacity) where the solve shows that a force slides
        /// the contact; [`Error::NotConverged`](crate::Error::NotConverged) with the last feasible iterate in `solution`;
        /// [`Error::Ranks`](crate::Error::Ranks).
        pub fn solve_into(&mut self, solution: &mut $Solution) -> Result<()> {
            self.solve_observed(solution, |_| std::ops::ControlFlow::Continue(()))
        }

        /// [`Self::solve_into`] with an observer that sees every step and may cancel. Once it has cancelled, the solve
        /// returns [`Error::NotConverged`](crate::Error::NotConverged) with
        /// [`Status::Cancelled`](crate::Status::Cancelled), even if the iterate is within the tolerance.
        ///
        /// # Errors
        /// As [`Self::solve_into`].
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
