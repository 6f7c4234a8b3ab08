//! Common functions of all solvers.

use std::ops::ControlFlow;

use stickslip_rs::cgm::Settings;
use stickslip_rs::rolling::{
    CoupledRollingSolution, CoupledRollingSolver, RollingSolution, RollingSolver,
};
use stickslip_rs::{
    CoupledSolution, CoupledSolver, Field, Friction, Grid, Iteration, NormalSolution, NormalSolver,
    Result, TangentialSolution, TangentialSolver, Warning,
};

use crate::call::{Outcome, call_on};
use crate::handle::{Opaque, changing, give, reading};
use crate::inputs::{stickslip_friction, stickslip_settings};
use crate::observer::{stickslip_observer, watch};
use crate::pointer::{Place, cells, input, optional};
use crate::status::stickslip_status;

/// Solver with its grid, which the solvers of the crate do not expose.
#[derive(Debug)]
pub struct Solver<S> {
    pub(crate) own: S,
    pub(crate) grid: Grid,
    /// Warnings of the last call that returned several results, each kind once.
    pub(crate) remarks: Vec<Warning>,
}

impl<S> Solver<S> {
    pub(crate) fn new(own: S, grid: Grid) -> Self {
        let remarks = Vec::new();
        Self { own, grid, remarks }
    }
}

/// Solver of the crate.
pub(crate) trait Solve {
    type Solution;

    fn set_settings(&mut self, settings: Settings) -> Result<()>;
    fn new_solution(&self) -> Result<Self::Solution>;
    fn solve_observed(
        &mut self,
        solution: &mut Self::Solution,
        observer: impl FnMut(&Iteration) -> ControlFlow<()> + Send,
    ) -> Result<()>;
}

macro_rules! solve {
    ($($solver:ty => $solution:ty),* $(,)?) => {$(
        impl Solve for $solver {
            type Solution = $solution;

            fn set_settings(&mut self, settings: Settings) -> Result<()> {
                self.set_settings(settings)
            }

            fn new_solution(&self) -> Result<$solution> {
                self.try_new_solution()
            }

            fn solve_observed(
                &mut self,
                solution: &mut $solution,
                observer: impl FnMut(&Iteration) -> ControlFlow<()> + Send,
            ) -> Result<()> {
                self.solve_observed(solution, observer)
            }
        }
    )*};
}

solve! {
    NormalSolver => NormalSolution,
    TangentialSolver => TangentialSolution,
    CoupledSolver => CoupledSolution,
    RollingSolver => RollingSolution,
    CoupledRollingSolver => CoupledRollingSolution,
}

/// Changes a solver with a struct of the caller, which is checked first.
///
/// # Safety
/// The caller must follow the rule for pointers in [`crate::pointer`].
pub(crate) unsafe fn change<T: Opaque<Value = Solver<S>>, S, A, B>(
    solver: *mut T,
    (name, given): (&str, *const A),
    check: impl FnOnce(&A) -> Outcome<B>,
    set: impl FnOnce(&mut S, B) -> Result<()>,
) -> stickslip_status {
    // SAFETY: the caller follows the safety contract of this function.
    call_on(solver, || unsafe {
        let given = check(input(name, given)?)?;
        Ok(set(&mut changing(solver)?.own, given)?)
    })
}

/// Sets the friction of a solver.
///
/// # Safety
/// The caller must follow the rule for pointers in [`crate::pointer`].
pub(crate) unsafe fn set_friction<T: Opaque<Value = Solver<S>>, S>(
    solver: *mut T,
    friction: *const stickslip_friction,
    set: impl FnOnce(&mut S, &Friction) -> Result<()>,
) -> stickslip_status {
    // SAFETY: the caller follows the safety contract of this function.
    call_on(solver, || unsafe {
        let mut solver = changing(solver)?;
        let (grid, spare) = (solver.grid, solver.spare());
        let set = |friction: &_| set(&mut solver.own, friction);
        input("friction", friction)?.lend(grid, spare, set)
    })
}

/// Changes a solver with an array that has a number for each cell.
///
/// # Safety
/// The caller must follow the rule for pointers in [`crate::pointer`].
pub(crate) unsafe fn change_cells<T: Opaque<Value = Solver<S>>, S>(
    solver: *mut T,
    (name, pointer, count): (&str, *const f64, usize),
    set: impl FnOnce(&mut S, &Field) -> Result<()>,
) -> stickslip_status {
    // SAFETY: the caller follows the safety contract of this function.
    call_on(solver, || unsafe {
        let mut solver = changing(solver)?;
        let samples = cells(name, solver.grid, pointer, count)?;
        solver.spare().with_copy(solver.grid, samples, |field| {
            Ok(set(&mut solver.own, field)?)
        })
    })
}

/// Sets the settings of a solver.
///
/// # Safety
/// The caller must follow the rule for pointers in [`crate::pointer`].
pub(crate) unsafe fn set_settings<T: Opaque<Value = Solver<S>>, S: Solve>(
    solver: *mut T,
    settings: *const stickslip_settings,
) -> stickslip_status {
    let check = stickslip_settings::checked;
    // SAFETY: the caller follows the safety contract of this function.
    unsafe { change(solver, ("settings", settings), check, S::set_settings) }
}

/// Discards the last solution of a solver.
///
/// # Safety
/// The caller must follow the rule for pointers in [`crate::pointer`].
pub(crate) unsafe fn reset<T: Opaque<Value = Solver<S>>, S>(
    solver: *mut T,
    forget: impl FnOnce(&mut S),
) -> stickslip_status {
    // SAFETY: the caller follows the safety contract of this function.
    call_on(solver, || unsafe {
        forget(&mut changing(solver)?.own);
        Ok(())
    })
}

/// Creates an empty solution.
///
/// # Safety
/// The caller must follow the rule for pointers in [`crate::pointer`].
pub(crate) unsafe fn new_solution<T, S, U>(
    solver: *const T,
    solution: *mut *mut U,
) -> stickslip_status
where
    T: Opaque<Value = Solver<S>>,
    S: Solve,
    U: Opaque<Value = S::Solution>,
{
    // SAFETY: the caller follows the safety contract of this function.
    call_on(solver, || unsafe {
        let place = Place::of_object("solution", solution)?;
        let solver = reading(solver)?;
        give(place, solver.own.new_solution()?, solver.grid.cells())
    })
}

/// Solves into a solution.
///
/// # Safety
/// The caller must follow the rule for pointers in [`crate::pointer`].
pub(crate) unsafe fn solve<T, S, U>(
    solver: *mut T,
    solution: *mut U,
    observer: *const stickslip_observer,
) -> stickslip_status
where
    T: Opaque<Value = Solver<S>>,
    S: Solve,
    U: Opaque<Value = S::Solution>,
{
    // SAFETY: the caller follows the safety contract of this function.
    call_on(solver, || unsafe {
        let observer = optional("observer", observer)?;
        let mut solver = changing(solver)?;
        let mut solution = changing(solution)?;
        Ok(solver.own.solve_observed(&mut solution, watch(observer))?)
    })
}
