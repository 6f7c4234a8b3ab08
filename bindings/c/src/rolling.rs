//! Steady rolling; for history steps with rolling see `loads`.

use stickslip_rs::rolling::{
    LeadingEdge, RollingControl, RollingProblem, RollingSolution, RollingSolver, SpinControl,
};
use stickslip_rs::{Axis, Error, Field};

use crate::call::{Outcome, call, call_on};
use crate::error::Failure;
use crate::fields::*;
use crate::half_space::stickslip_half_space;
use crate::handle::{Handle, changing, free, give, opaque, reading};
use crate::history::{STICKSLIP_SINCE_TOUCH, entry_rule};
use crate::inputs::{stickslip_friction, stickslip_settings, stickslip_settings_default};
use crate::loads::{STICKSLIP_FORCE, stickslip_normal_load};
use crate::normal::{stickslip_normal_solution, stickslip_normal_solver};
use crate::observer::{stickslip_observer, watch};
use crate::pointer::{Place, cells_mut, input, optional};
use crate::reserved::known;
use crate::results::{stickslip_report, stickslip_warning};
use crate::solver::{self, Solver};
use crate::status::{STICKSLIP_OUTDATED_SOLUTION, stickslip_status};
use crate::text_fields::{show, tell, warn};

/// Prescribes a creepage, the motion of body 2 over body 1 per unit length rolled (dimensionless). A positive creepage
/// causes a positive force. Kalker and CONTACT define creepage and spin with the opposite sign.
pub const STICKSLIP_CREEPAGE: i32 = 6;
/// Prescribes the spin, the rotation of body 2 relative to body 1 about the origin of the grid per unit length rolled (one
/// over a length, positive from x to y).
pub const STICKSLIP_SPIN: i32 = 7;
/// Prescribes the moment on body 1 about the origin of the grid (a force times a length, positive from x to y).
pub const STICKSLIP_MOMENT: i32 = 5;

/// Prescribed load of rolling bodies along an axis, or of their rotation.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct stickslip_rolling_control {
    /// Kind of load: STICKSLIP_CREEPAGE or STICKSLIP_FORCE along an axis, STICKSLIP_SPIN or STICKSLIP_MOMENT for the
    /// rotation. Zero with the value zero means no creepage or no spin.
    pub kind: i32,
    /// Value along an axis: the creepage, or the force that body 2 exerts on body 1, which must be less than friction can
    /// carry. Value for the rotation: the spin or the moment.
    pub value: f64,
}

impl stickslip_rolling_control {
    fn along(&self) -> Outcome<RollingControl> {
        match self.kind {
            0 if self.value == 0.0 => Ok(RollingControl::Creepage(0.0)),
            STICKSLIP_CREEPAGE => Ok(RollingControl::Creepage(self.value)),
            STICKSLIP_FORCE => Ok(RollingControl::Force(self.value)),
            other => Err(Failure::option(
                "kind of rolling load along an axis",
                other,
                "STICKSLIP_CREEPAGE or STICKSLIP_FORCE",
            )),
        }
    }

    fn about(&self) -> Outcome<SpinControl> {
        match self.kind {
            0 if self.value == 0.0 => Ok(SpinControl::Spin(0.0)),
            STICKSLIP_SPIN => Ok(SpinControl::Spin(self.value)),
            STICKSLIP_MOMENT => Ok(SpinControl::Moment(self.value)),
            other => Err(Failure::option(
                "kind of rolling load of the rotation",
                other,
                "STICKSLIP_SPIN or STICKSLIP_MOMENT",
            )),
        }
    }
}

/// Prescribed loads of rolling bodies. A load whose members are all zero has no creepage and no spin.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct stickslip_rolling_load {
    /// Load along x.
    pub x: stickslip_rolling_control,
    /// Load along y.
    pub y: stickslip_rolling_control,
    /// Spin or moment.
    pub spin: stickslip_rolling_control,
    /// Reserved for future members: zero.
    pub reserved: [u64; 8],
}

impl stickslip_rolling_load {
    pub(crate) fn checked(&self) -> Outcome<([RollingControl; 2], SpinControl)> {
        known("the rolling load", &self.reserved)?;
        Ok(([self.x.along()?, self.y.along()?], self.spin.about()?))
    }
}

/// Leading edge at the largest x, where particles enter the contact (default).
pub const STICKSLIP_PLUS_X: i32 = 0;
/// Leading edge at the smallest x.
pub const STICKSLIP_MINUS_X: i32 = 1;
/// Leading edge at the largest y.
pub const STICKSLIP_PLUS_Y: i32 = 2;
/// Leading edge at the smallest y.
pub const STICKSLIP_MINUS_Y: i32 = 3;

pub(crate) fn leading_edge(value: i32) -> Outcome<LeadingEdge> {
    match value {
        STICKSLIP_PLUS_X => Ok(LeadingEdge::PlusX),
        STICKSLIP_MINUS_X => Ok(LeadingEdge::MinusX),
        STICKSLIP_PLUS_Y => Ok(LeadingEdge::PlusY),
        STICKSLIP_MINUS_Y => Ok(LeadingEdge::MinusY),
        other => Err(Failure::option(
            "leading edge",
            other,
            "STICKSLIP_PLUS_X, STICKSLIP_MINUS_X, STICKSLIP_PLUS_Y or STICKSLIP_MINUS_Y",
        )),
    }
}

/// Options of a rolling solver; stickslip_rolling_options_default() returns the defaults.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct stickslip_rolling_options {
    /// Leading edge: STICKSLIP_PLUS_X (default), STICKSLIP_MINUS_X, STICKSLIP_PLUS_Y or STICKSLIP_MINUS_Y.
    pub leading_edge: i32,
    /// Entry rule of cells that come into contact: STICKSLIP_SINCE_TOUCH (default) or STICKSLIP_WHOLE_STEP.
    pub entry_rule: i32,
    /// Number of cells that a particle passes in a step (default 1). Longer steps cost less and are less accurate.
    pub step: usize,
    /// Number of corrections of the direction of slip (default 0). Two corrections raise the order of convergence of the
    /// forces under spin from 1 to between 1.5 and 2.
    pub slip_corrections: usize,
    /// Method, tolerance and limits of the solves.
    pub settings: stickslip_settings,
    /// Reserved for future members: zero.
    pub reserved: [u64; 7],
}

/// Returns the default options of a rolling solver.
#[unsafe(no_mangle)]
pub extern "C" fn stickslip_rolling_options_default() -> stickslip_rolling_options {
    stickslip_rolling_options {
        leading_edge: STICKSLIP_PLUS_X,
        entry_rule: STICKSLIP_SINCE_TOUCH,
        step: 1,
        slip_corrections: 0,
        settings: stickslip_settings_default(),
        reserved: [0; 7],
    }
}

/// Solver for steady rolling with a sequence of creepages, forces or spins. Each solve starts from the last solution.
pub struct stickslip_rolling_solver(Handle<Solver<RollingSolver>>);

opaque!(stickslip_rolling_solver holds Solver<RollingSolver>, named "rolling solver");

/// Traction, slip and creepage of steady rolling. Fields are read without a copy and remain valid until the next solve into
/// the solution or until it is freed.
pub struct stickslip_rolling_solution(Handle<RollingSolution>);

opaque!(stickslip_rolling_solution holds RollingSolution, named "rolling solution");

/// Creates a solver under the pressure of a solved normal contact on the same bodies. The grid must extend beyond the
/// leading edge of the contact by the cells of one step; otherwise the call returns STICKSLIP_GRID_TOO_SHORT. The entry rule
/// uses two more cells; if they are missing, its slopes of the gap are one-sided. load and options may be NULL. A NULL load
/// means no creepage and no spin, and NULL options mean the defaults.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_rolling_solver_new(
    half_space: *const stickslip_half_space,
    normal: *const stickslip_normal_solution,
    friction: *const stickslip_friction,
    load: *const stickslip_rolling_load,
    options: *const stickslip_rolling_options,
    solver: *mut *mut stickslip_rolling_solver,
) -> stickslip_status {
    // SAFETY: the caller follows the rule for pointers.
    call_on(half_space, || unsafe {
        let place = Place::of_object("solver", solver)?;
        let (bodies, normal) = (reading(half_space)?, reading(normal)?);
        let grid = bodies.grid();
        let friction = input("friction", friction)?.checked(grid)?;
        let mut problem = RollingProblem::builder(&bodies, &normal, friction);
        if let Some(load) = optional("load", load)? {
            let ([x, y], spin) = load.checked()?;
            problem = problem.control(Axis::X, x).control(Axis::Y, y).spin(spin);
        }
        if let Some(options) = optional("options", options)? {
            known("the options", &options.reserved)?;
            problem = problem
                .leading_edge(leading_edge(options.leading_edge)?)
                .entry_rule(entry_rule(options.entry_rule)?)
                .step(options.step)
                .slip_corrections(options.slip_corrections)
                .settings(options.settings.checked()?);
        }
        let own = problem.build()?.into_solver()?;
        give(place, Solver::new(own, grid), grid.cells())
    })
}

/// Frees a solver; does nothing if it is NULL.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_rolling_solver_free(
    solver: *mut stickslip_rolling_solver,
) -> stickslip_status {
    // SAFETY: the caller follows the rule for pointers.
    call(|| unsafe { free(solver) })
}

/// Sets the load of the next solve. Returns STICKSLIP_BEYOND_FRICTION_CAPACITY for a force or a moment that friction cannot
/// carry, or can carry only by sliding.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_rolling_solver_set_load(
    solver: *mut stickslip_rolling_solver,
    load: *const stickslip_rolling_load,
) -> stickslip_status {
    let set = |own: &mut RollingSolver, (controls, spin)| own.set_load(controls, spin);
    // SAFETY: the caller follows the rule for pointers.
    unsafe { solver::change(solver, ("load", load), stickslip_rolling_load::checked, set) }
}

/// Sets the friction of the next solve. Returns STICKSLIP_BEYOND_FRICTION_CAPACITY if the new friction cannot carry the
/// current load, or can carry it only by sliding. Until that solve, the stiffness returns STICKSLIP_OUTDATED_SOLUTION.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_rolling_solver_set_friction(
    solver: *mut stickslip_rolling_solver,
    friction: *const stickslip_friction,
) -> stickslip_status {
    // SAFETY: the caller follows the rule for pointers.
    unsafe { solver::set_friction(solver, friction, RollingSolver::set_friction) }
}

/// Sets the pressure of the next solve to that of a solved normal contact on the same bodies. The call allocates
/// nothing if the contact lies within the largest window so far. Returns STICKSLIP_BEYOND_FRICTION_CAPACITY if friction
/// can no longer carry the prescribed force.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_rolling_solver_set_normal(
    solver: *mut stickslip_rolling_solver,
    normal: *const stickslip_normal_solution,
) -> stickslip_status {
    // SAFETY: the caller follows the rule for pointers.
    call_on(solver, || unsafe {
        let (mut solver, normal) = (changing(solver)?, reading(normal)?);
        Ok(solver.own.set_pressure(&*normal)?)
    })
}

/// Sets the pressure of the next solve to the given values (count entries, copied). No gap belongs to these values, so
/// the call returns STICKSLIP_UNSUPPORTED_BY_MODEL unless the solver uses STICKSLIP_WHOLE_STEP.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_rolling_solver_set_pressure(
    solver: *mut stickslip_rolling_solver,
    pressure: *const f64,
    count: usize,
) -> stickslip_status {
    // SAFETY: the caller follows the rule for pointers.
    unsafe {
        solver::change_cells(solver, ("pressure", pressure, count), |own, field| {
            own.set_pressure(field)
        })
    }
}

/// Sets the normal solver that computes the pressure of a new normal load. The solver is copied with its gap, hardness and
/// settings: call this function again after each change of its gap. This call does not change the pressure.
/// stickslip_rolling_solver_set_normal_load solves for the pressure over the gap of the normal solver, which may differ from the
/// gap of the present pressure. Grid, boundary, cell values and materials must be equal. The normal solver need not have solved
/// before.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_rolling_solver_set_normal_solver(
    solver: *mut stickslip_rolling_solver,
    normal: *const stickslip_normal_solver,
) -> stickslip_status {
    // SAFETY: the caller follows the rule for pointers.
    call_on(solver, || unsafe {
        let (mut solver, normal) = (changing(solver)?, reading(normal)?);
        Ok(solver.own.set_normal_solver(normal.own.clone())?)
    })
}

/// Sets the normal load of the next solve and solves for its pressure. Returns STICKSLIP_UNSUPPORTED_BY_MODEL if
/// stickslip_rolling_solver_set_normal_solver has set no normal solver. The gap is that of the normal solver, not that of the
/// last stickslip_rolling_solver_set_normal: after wear, set the normal solver again. After a failure the solver is unchanged.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_rolling_solver_set_normal_load(
    solver: *mut stickslip_rolling_solver,
    load: *const stickslip_normal_load,
) -> stickslip_status {
    // SAFETY: the caller follows the rule for pointers.
    unsafe {
        let check = stickslip_normal_load::of_problem;
        solver::change(
            solver,
            ("load", load),
            check,
            RollingSolver::set_normal_load,
        )
    }
}

/// Copies the normal contact that stickslip_rolling_solver_set_normal_load has computed to a normal solution on the same grid.
/// Returns STICKSLIP_OUTDATED_SOLUTION before the first load and after another pressure was set. Returns STICKSLIP_GRID_MISMATCH for a solution on another grid. After a failure
/// the solution is unchanged.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_rolling_solver_normal(
    solver: *const stickslip_rolling_solver,
    solution: *mut stickslip_normal_solution,
) -> stickslip_status {
    // SAFETY: the caller follows the rule for pointers.
    call_on(solver, || unsafe {
        let (solver, mut solution) = (reading(solver)?, changing(solution)?);
        let normal = (solver.own.normal()).ok_or_else(|| {
            let message = "the rolling solver has no normal contact of its own: set a normal solver and a normal load first";
            Failure::new(STICKSLIP_OUTDATED_SOLUTION, message.into())
        })?;
        let [expected, found] = [normal.grid(), solution.grid()];
        if expected != found {
            return Err(Failure::from(Error::GridMismatch {
                quantity: "the normal solution",
                expected_cells: [expected.nx(), expected.ny()],
                expected_sides: [expected.dx(), expected.dy()],
                found_cells: [found.nx(), found.ny()],
                found_sides: [found.dx(), found.dy()],
            }));
        }
        solution.clone_from(normal);
        Ok(())
    })
}

/// Writes the largest tangential force that friction can carry.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_rolling_solver_friction_capacity(
    solver: *const stickslip_rolling_solver,
    capacity: *mut f64,
) -> stickslip_status {
    // SAFETY: the caller follows the rule for pointers.
    unsafe {
        tell(solver, ("capacity", capacity), |of| {
            Ok(of.own.friction_capacity())
        })
    }
}

/// Discards the last solution: the next solve starts as the first solve did, and the stiffness is that of a contact in full
/// stick.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_rolling_solver_reset(
    solver: *mut stickslip_rolling_solver,
) -> stickslip_status {
    // SAFETY: the caller follows the rule for pointers.
    unsafe { solver::reset(solver, RollingSolver::reset) }
}

/// Sets the method, the tolerance and the limits of the next solve.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_rolling_solver_set_settings(
    solver: *mut stickslip_rolling_solver,
    settings: *const stickslip_settings,
) -> stickslip_status {
    // SAFETY: the caller follows the rule for pointers.
    unsafe { solver::set_settings(solver, settings) }
}

/// Solves into a solution of stickslip_rolling_solution_new for the same bodies. observer may be NULL.
///
/// After STICKSLIP_NOT_CONVERGED the solution contains the last feasible iterate and its report. Any other failure
/// leaves the solution unchanged, with one exception: after STICKSLIP_MEMORY in the search for the spin of a prescribed
/// moment, the solution is that of a different spin.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_rolling_solver_solve(
    solver: *mut stickslip_rolling_solver,
    solution: *mut stickslip_rolling_solution,
    observer: *const stickslip_observer,
) -> stickslip_status {
    // SAFETY: the caller follows the rule for pointers.
    unsafe { solver::solve(solver, solution, observer) }
}

/// Derivatives of the forces and the moment with respect to the creepages and the spin.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct stickslip_rolling_stiffness {
    /// Derivatives of the forces along x and y and of the moment (rows) with respect to the creepages along x and y and the
    /// spin (columns). In C, the order of the indices is slopes[row][column]. The entries are forces. Entries for the spin
    /// have an additional factor of a length, and so do entries for the moment.
    pub slopes: [[f64; 3]; 3],
    /// Reserved for future members: zero.
    pub reserved: [u64; 8],
}

/// Computes the derivatives of the loads at the last solution. Stick cells follow the motion, and slip cells remain at
/// their friction limits. Before the first solve all cells stick, and the derivatives are Kalker's coefficients times G
/// a b and powers of the length (a b)^(1/2). Returns STICKSLIP_OUTDATED_SOLUTION if a load, the pressure or the friction has
/// changed since the last solve, and STICKSLIP_NOT_CONVERGED if that solve has not converged.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_rolling_solver_stiffness(
    solver: *mut stickslip_rolling_solver,
    stiffness: *mut stickslip_rolling_stiffness,
) -> stickslip_status {
    // SAFETY: the caller follows the rule for pointers.
    unsafe { stickslip_rolling_solver_stiffness_observed(solver, std::ptr::null(), stiffness) }
}

/// Computes the stiffness with an observer (may be NULL). The observer is called before every product with an operator and
/// may end the call: the function then returns STICKSLIP_NOT_CONVERGED and leaves stiffness unchanged.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_rolling_solver_stiffness_observed(
    solver: *mut stickslip_rolling_solver,
    observer: *const stickslip_observer,
    stiffness: *mut stickslip_rolling_stiffness,
) -> stickslip_status {
    // SAFETY: the caller follows the rule for pointers.
    call_on(solver, || unsafe {
        let place = Place::new("stiffness", stiffness)?;
        let observer = optional("observer", observer)?;
        let slopes = changing(solver)?.own.stiffness_observed(watch(observer))?;
        place.put(stickslip_rolling_stiffness {
            slopes,
            reserved: [0; 8],
        });
        Ok(())
    })
}

/// Creates an empty solution of the right size for a solver.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_rolling_solution_new(
    solver: *const stickslip_rolling_solver,
    solution: *mut *mut stickslip_rolling_solution,
) -> stickslip_status {
    // SAFETY: the caller follows the rule for pointers.
    unsafe { solver::new_solution(solver, solution) }
}

/// Frees a solution; does nothing if it is NULL.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_rolling_solution_free(
    solution: *mut stickslip_rolling_solution,
) -> stickslip_status {
    // SAFETY: the caller follows the rule for pointers.
    call(|| unsafe { free(solution) })
}

pub(crate) fn of_rolling(solution: &RollingSolution, field: i32) -> Outcome<&Field> {
    match field {
        STICKSLIP_TRACTION_X => Ok(solution.traction()[0]),
        STICKSLIP_TRACTION_Y => Ok(solution.traction()[1]),
        STICKSLIP_SLIP_X => Ok(solution.slip()[0]),
        STICKSLIP_SLIP_Y => Ok(solution.slip()[1]),
        other => Err(none("a rolling solution", other, TRACTION_AND_SLIP)),
    }
}

/// Returns a field, STICKSLIP_TRACTION_X, STICKSLIP_TRACTION_Y, STICKSLIP_SLIP_X or STICKSLIP_SLIP_Y, and writes its number
/// of cells to count (may be NULL); returns NULL on failure. The slip is given per unit length rolled (dimensionless),
/// averaged over the step that moved the particles to their cells.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_rolling_solution_field(
    solution: *const stickslip_rolling_solution,
    which: i32,
    count: *mut usize,
) -> *const f64 {
    // SAFETY: the caller follows the rule for pointers.
    unsafe { show(solution, count, |of| Ok(of_rolling(of, which)?.as_slice())) }
}

/// Returns the zone of every cell, STICKSLIP_SEPARATED, STICKSLIP_STICK or STICKSLIP_SLIP; returns NULL on failure.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_rolling_solution_zones(
    solution: *const stickslip_rolling_solution,
    count: *mut usize,
) -> *const u8 {
    // SAFETY: the caller follows the rule for pointers.
    unsafe { show(solution, count, |of| Ok(of.zones())).cast() }
}

/// Writes the energy that slip dissipates in each cell per area and per length rolled (a pressure) to values, which has count
/// entries. The cells are fixed in the contact, and the particles of both surfaces pass through them. The value of a cell is
/// therefore not the wear of a particle. In each passage, a particle loses the wear coefficient times the sum of the values
/// over the cells of its line along the rolling direction, times their side along this line. Add this depth to whole lines of
/// the gap. A wheel with the circumference U makes L/U passages over the length L. Between bodies of the same material, the
/// integral of this energy is smaller than the work of creepages and spin; the difference decreases with the cell size.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_rolling_solution_dissipation_per_area(
    solution: *const stickslip_rolling_solution,
    values: *mut f64,
    count: usize,
) -> stickslip_status {
    // SAFETY: the caller follows the rule for pointers.
    call_on(solution, || unsafe {
        let solution = reading(solution)?;
        let values = cells_mut("values", solution.grid(), values, count)?;
        values.copy_from_slice(solution.dissipation_per_area()?.as_slice());
        Ok(())
    })
}

/// Scalar results of a rolling contact.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct stickslip_rolling_result {
    /// Creepages along x and y, prescribed or caused by the forces (dimensionless).
    pub creepage: [f64; 2],
    /// Spin, prescribed or caused by the moment (one over a length).
    pub spin: f64,
    /// Tangential force that body 2 exerts on body 1.
    pub force: [f64; 2],
    /// Moment about z at the origin of the grid that the tractions exert on body 1 (a force times a length).
    pub moment: f64,
    /// Work of creepages and spin per unit length rolled (a force). Between bodies of the same material all work is
    /// dissipated. Between different materials the pressure also does work, which is not included.
    pub work: f64,
    /// Ratio of stick cells to contact cells.
    pub stick_ratio: f64,
    /// Reserved for future members: zero.
    pub reserved: [u64; 8],
}

impl From<&RollingSolution> for stickslip_rolling_result {
    fn from(solution: &RollingSolution) -> Self {
        Self {
            creepage: solution.creepage(),
            spin: solution.spin(),
            force: solution.force(),
            moment: solution.moment(),
            work: solution.work(),
            stick_ratio: solution.stick_ratio(),
            reserved: [0; 8],
        }
    }
}

/// Writes the scalar results of the contact.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_rolling_solution_result(
    solution: *const stickslip_rolling_solution,
    result: *mut stickslip_rolling_result,
) -> stickslip_status {
    // SAFETY: the caller follows the rule for pointers.
    unsafe { tell(solution, ("result", result), |of| Ok(of.into())) }
}

/// Writes the report of the solve.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_rolling_solution_report(
    solution: *const stickslip_rolling_solution,
    report: *mut stickslip_report,
) -> stickslip_status {
    // SAFETY: the caller follows the rule for pointers.
    unsafe { tell(solution, ("report", report), |of| Ok(of.report().into())) }
}

/// Writes the warnings about the solution, like stickslip_normal_solution_warnings.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_rolling_solution_warnings(
    solution: *const stickslip_rolling_solution,
    buffer: *mut stickslip_warning,
    capacity: usize,
    count: *mut usize,
) -> stickslip_status {
    // SAFETY: the caller follows the rule for pointers.
    unsafe { warn(solution, (buffer, capacity, count), |of| Ok(of.warnings())) }
}
