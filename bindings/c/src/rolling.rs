//! Steady rolling; steps of histories that roll are in `loads`.

use stickslip_rs::rolling::{
    CreepForce, LeadingEdge, RollingControl, RollingProblem, RollingSolution, RollingSolver,
    SpinControl,
};
use stickslip_rs::{Axis, Field};

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
use crate::pointer::{Place, cells_mut, collected, entries, entries_mut, input, optional};
use crate::reserved::known;
use crate::results::{stickslip_report, stickslip_warning};
use crate::solver::{self, Solver};
use crate::status::stickslip_status;
use crate::text_fields::{show, tell, warn};

/// A creepage, what body 2 moves over body 1 for each length rolled (dimensionless).
pub const STICKSLIP_CREEPAGE: i32 = 0;
/// A spin, the rotation of body 2 relative to body 1 about the origin of the grid for each length rolled (one over a
/// length, positive from x to y).
pub const STICKSLIP_SPIN: i32 = 0;
/// The moment on body 1 about the origin of the grid (a force times a length, positive from x to y).
pub const STICKSLIP_MOMENT: i32 = 5;

/// What is prescribed of rolling bodies along an axis, or of their rotation.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct stickslip_rolling_control {
    /// Along an axis STICKSLIP_CREEPAGE or STICKSLIP_FORCE, of the rotation STICKSLIP_SPIN or STICKSLIP_MOMENT.
    pub kind: i32,
    /// The creepage or the force that body 2 exerts on body 1, less than friction holds; the spin or the moment.
    pub value: f64,
}

impl stickslip_rolling_control {
    fn along(&self) -> Outcome<RollingControl> {
        match self.kind {
            STICKSLIP_CREEPAGE => Ok(RollingControl::Creepage(self.value)),
            STICKSLIP_FORCE => Ok(RollingControl::Force(self.value)),
            other => Err(Failure::option("rolling control", other)),
        }
    }

    fn about(&self) -> Outcome<SpinControl> {
        match self.kind {
            STICKSLIP_SPIN => Ok(SpinControl::Spin(self.value)),
            STICKSLIP_MOMENT => Ok(SpinControl::Moment(self.value)),
            other => Err(Failure::option("spin control", other)),
        }
    }
}

/// What is prescribed of rolling bodies. All zero: no creepage and no spin.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct stickslip_rolling_load {
    /// Along x.
    pub x: stickslip_rolling_control,
    /// Along y.
    pub y: stickslip_rolling_control,
    /// The spin or the moment.
    pub spin: stickslip_rolling_control,
    /// Room for members to come: zero.
    pub reserved: [u64; 8],
}

impl stickslip_rolling_load {
    pub(crate) fn checked(&self) -> Outcome<([RollingControl; 2], SpinControl)> {
        known("the rolling load", &self.reserved)?;
        Ok(([self.x.along()?, self.y.along()?], self.spin.about()?))
    }
}

/// Particles enter the contact at the largest x (default).
pub const STICKSLIP_PLUS_X: i32 = 0;
/// At the smallest x.
pub const STICKSLIP_MINUS_X: i32 = 1;
/// At the largest y.
pub const STICKSLIP_PLUS_Y: i32 = 2;
/// At the smallest y.
pub const STICKSLIP_MINUS_Y: i32 = 3;

pub(crate) fn leading_edge(value: i32) -> Outcome<LeadingEdge> {
    match value {
        STICKSLIP_PLUS_X => Ok(LeadingEdge::PlusX),
        STICKSLIP_MINUS_X => Ok(LeadingEdge::MinusX),
        STICKSLIP_PLUS_Y => Ok(LeadingEdge::PlusY),
        STICKSLIP_MINUS_Y => Ok(LeadingEdge::MinusY),
        other => Err(Failure::option("leading edge", other)),
    }
}

/// Options of a rolling solver; stickslip_rolling_options_default() has the defaults.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct stickslip_rolling_options {
    /// STICKSLIP_PLUS_X (default), STICKSLIP_MINUS_X, STICKSLIP_PLUS_Y or STICKSLIP_MINUS_Y.
    pub leading_edge: i32,
    /// How cells that enter the contact follow the motion: STICKSLIP_SINCE_TOUCH (default) or STICKSLIP_WHOLE_STEP.
    pub entry_rule: i32,
    /// Cells that a particle passes in a step (default 1). Longer steps cost less and are less accurate.
    pub step: usize,
    /// Number of corrections of the direction of slip (default 0). Two raise the order of the forces under spin from 1 to
    /// between 1.5 and 2.
    pub slip_corrections: usize,
    /// Method, tolerance and limits.
    pub settings: stickslip_settings,
    /// Room for members to come: zero.
    pub reserved: [u64; 7],
}

/// The options that rolling solvers have by default.
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

/// Solves steady rolling for one creepage, force or spin after the other, each from the last answer.
pub struct stickslip_rolling_solver(Handle<Solver<RollingSolver>>);

opaque!(stickslip_rolling_solver holds Solver<RollingSolver>, named "rolling solver");

/// Traction, slip and creepage of steady rolling. Its fields are read without a copy, and are valid until the next solve
/// into it, or until it is freed.
pub struct stickslip_rolling_solution(Handle<RollingSolution>);

opaque!(stickslip_rolling_solution holds RollingSolution, named "rolling solution");

/// Makes a solver under the pressure of a solved normal contact on the same bodies, with room of a step of cells ahead of
/// the contact, else STICKSLIP_GRID_TOO_SHORT. load (no creepage, no spin) and options (the defaults) may be NULL.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_rolling_solver_new(
    half_space: *const stickslip_half_space,
    normal: *const stickslip_normal_solution,
    friction: *const stickslip_friction,
    load: *const stickslip_rolling_load,
    options: *const stickslip_rolling_options,
    solver: *mut *mut stickslip_rolling_solver,
) -> stickslip_status {
    // SAFETY: the rule for pointers.
    call_on(half_space, || unsafe {
        let place = Place::new("solver", solver)?;
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
        give(place, Solver { own, grid }, grid.cells())
    })
}

/// Frees a solver; nothing for NULL.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_rolling_solver_free(
    solver: *mut stickslip_rolling_solver,
) -> stickslip_status {
    // SAFETY: the rule for pointers.
    call(|| unsafe { free(solver) })
}

/// Changes what is prescribed of the next solve. STICKSLIP_BEYOND_FRICTION_CAPACITY for a force or a moment that friction
/// does not hold, or holds only by sliding.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_rolling_solver_set_load(
    solver: *mut stickslip_rolling_solver,
    load: *const stickslip_rolling_load,
) -> stickslip_status {
    let set = |own: &mut RollingSolver, (controls, spin)| own.set_control(controls, spin);
    // SAFETY: the rule for pointers.
    unsafe { solver::change(solver, ("load", load), stickslip_rolling_load::checked, set) }
}

/// Changes the friction of the next solve. STICKSLIP_BEYOND_FRICTION_CAPACITY if it does not hold the present load, or holds
/// it only by sliding. The stiffness is about the last answer, if there is one, until that solve.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_rolling_solver_set_friction(
    solver: *mut stickslip_rolling_solver,
    friction: *const stickslip_friction,
) -> stickslip_status {
    // SAFETY: the rule for pointers.
    unsafe { solver::set_friction(solver, friction, RollingSolver::set_friction) }
}

/// Sets the pressure of the next solve to that of a solved normal contact on the same bodies. A contact within the largest
/// window so far allocates nothing. STICKSLIP_BEYOND_FRICTION_CAPACITY if friction no longer holds the prescribed force.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_rolling_solver_set_normal(
    solver: *mut stickslip_rolling_solver,
    normal: *const stickslip_normal_solution,
) -> stickslip_status {
    // SAFETY: the rule for pointers.
    call_on(solver, || unsafe {
        let (mut solver, normal) = (changing(solver)?, reading(normal)?);
        Ok(solver.own.set_pressure(&*normal)?)
    })
}

/// Sets the pressure of the next solve to one from elsewhere (count entries, copied). It has no gap:
/// STICKSLIP_UNSUPPORTED_BY_MODEL unless the solver has STICKSLIP_WHOLE_STEP.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_rolling_solver_set_pressure(
    solver: *mut stickslip_rolling_solver,
    pressure: *const f64,
    count: usize,
) -> stickslip_status {
    // SAFETY: the rule for pointers.
    unsafe {
        solver::change_cells(solver, ("pressure", pressure, count), |own, field| {
            own.set_pressure(field)
        })
    }
}

/// Sets the solver that finds the pressure of a new normal load; copied, with its gap, hardness and settings.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_rolling_solver_set_normal_solver(
    solver: *mut stickslip_rolling_solver,
    normal: *const stickslip_normal_solver,
) -> stickslip_status {
    // SAFETY: the rule for pointers.
    call_on(solver, || unsafe {
        let (mut solver, normal) = (changing(solver)?, reading(normal)?);
        Ok(solver.own.set_normal_solver(normal.own.clone())?)
    })
}

/// Sets the normal load of the next solve, and solves for its pressure. STICKSLIP_UNSUPPORTED_BY_MODEL without a normal solver of
/// stickslip_rolling_solver_set_normal_solver. After a failure the solver is unchanged.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_rolling_solver_set_normal_load(
    solver: *mut stickslip_rolling_solver,
    load: *const stickslip_normal_load,
) -> stickslip_status {
    // SAFETY: the rule for pointers.
    unsafe {
        let check = stickslip_normal_load::checked;
        solver::change(solver, ("load", load), check, RollingSolver::set_load)
    }
}

/// The largest tangential force that friction holds.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_rolling_solver_friction_capacity(
    solver: *const stickslip_rolling_solver,
    capacity: *mut f64,
) -> stickslip_status {
    // SAFETY: the rule for pointers.
    unsafe {
        tell(solver, ("capacity", capacity), |of| {
            Ok(of.own.friction_capacity())
        })
    }
}

/// Forgets the last answer: the next solve starts as the first did, and the stiffness is that of a contact that sticks.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_rolling_solver_reset(
    solver: *mut stickslip_rolling_solver,
) -> stickslip_status {
    // SAFETY: the rule for pointers.
    unsafe { solver::reset(solver, RollingSolver::reset) }
}

/// Changes method, tolerance and limits of the next solve.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_rolling_solver_set_settings(
    solver: *mut stickslip_rolling_solver,
    settings: *const stickslip_settings,
) -> stickslip_status {
    // SAFETY: the rule for pointers.
    unsafe { solver::set_settings(solver, settings) }
}

/// Solves into a solution of stickslip_rolling_solution_new for the same bodies. observer may be NULL.
///
/// With STICKSLIP_NOT_CONVERGED the solution holds the last feasible iterate and its report; after any other failure it is
/// as it was, except that STICKSLIP_MEMORY in the search for the spin of a moment leaves the answer at another spin.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_rolling_solver_solve(
    solver: *mut stickslip_rolling_solver,
    solution: *mut stickslip_rolling_solution,
    observer: *const stickslip_observer,
) -> stickslip_status {
    // SAFETY: the rule for pointers.
    unsafe { solver::solve(solver, solution, observer) }
}

/// How forces and moment follow creepages and spin.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct stickslip_rolling_stiffness {
    /// Slopes of the forces along x and y and of the moment (rows) by the creepages along x and y and the spin (columns).
    /// In C slopes[row, column]. Forces; with the spin forces times lengths, in the row of the moment once more times a
    /// length.
    pub slopes: [[f64; 3]; 3],
    /// Room for members to come: zero.
    pub reserved: [u64; 8],
}

/// The slopes of the loads about the last answer. Cells that stick follow, cells that slip stay at their limits; before the
/// first solve all cells stick: these are Kalker's coefficients, times G a b and lengths.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_rolling_solver_stiffness(
    solver: *mut stickslip_rolling_solver,
    stiffness: *mut stickslip_rolling_stiffness,
) -> stickslip_status {
    // SAFETY: the rule for pointers.
    unsafe { stickslip_rolling_solver_stiffness_observed(solver, std::ptr::null(), stiffness) }
}

/// The same with an observer (may be NULL), which is called before every product with an operator and may end it:
/// STICKSLIP_NOT_CONVERGED, and stiffness is as it was.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_rolling_solver_stiffness_observed(
    solver: *mut stickslip_rolling_solver,
    observer: *const stickslip_observer,
    stiffness: *mut stickslip_rolling_stiffness,
) -> stickslip_status {
    // SAFETY: the rule for pointers.
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

/// Creepages and spin: a point of a creep curve or a creep surface.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct stickslip_creep_point {
    /// The creepages along x and y (dimensionless).
    pub creepage: [f64; 2],
    /// The spin (one over a length).
    pub spin: f64,
}

/// The loads that creepages and spin cause.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct stickslip_creep_force {
    /// Tangential force on body 1 along x and y.
    pub force: [f64; 2],
    /// Moment on body 1 about the origin of the grid (a force times a length).
    pub moment: f64,
    /// Stick cells over contact cells.
    pub stick_ratio: f64,
}

impl From<CreepForce> for stickslip_creep_force {
    fn from(at: CreepForce) -> Self {
        Self {
            force: at.force,
            moment: at.moment,
            stick_ratio: at.stick_ratio,
        }
    }
}

/// The loads at count points, written to forces, each solved from the answer of the one before: neighbours in the order
/// should be neighbours in the plane. The last point stays prescribed. All are checked before the first is solved. With
/// STICKSLIP_NOT_CONVERGED the point that failed stays prescribed, and forces are as they were.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_rolling_solver_creep_forces(
    solver: *mut stickslip_rolling_solver,
    points: *const stickslip_creep_point,
    count: usize,
    forces: *mut stickslip_creep_force,
) -> stickslip_status {
    let none = std::ptr::null();
    // SAFETY: the rule for pointers.
    unsafe { stickslip_rolling_solver_creep_forces_observed(solver, points, count, none, forces) }
}

/// The same with an observer (may be NULL), which is called before every product with an operator and may end it:
/// STICKSLIP_NOT_CONVERGED, the point under way stays prescribed, and forces are as they were.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_rolling_solver_creep_forces_observed(
    solver: *mut stickslip_rolling_solver,
    points: *const stickslip_creep_point,
    count: usize,
    observer: *const stickslip_observer,
    forces: *mut stickslip_creep_force,
) -> stickslip_status {
    // SAFETY: the rule for pointers.
    call_on(solver, || unsafe {
        let observer = watch(optional("observer", observer)?);
        let places = entries_mut("forces", forces, count)?;
        let points = entries("points", points, count)?;
        let points = points
            .iter()
            .map(|at| [at.creepage[0], at.creepage[1], at.spin]);
        let points = collected(Vec::new(), points)?;
        let mut solver = changing(solver)?;
        let found = solver.own.creep_forces_observed(points, observer)?;
        for (place, force) in places.iter_mut().zip(found) {
            *place = force.into();
        }
        Ok(())
    })
}

/// Makes an empty solution of the right size for a solver.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_rolling_solution_new(
    solver: *const stickslip_rolling_solver,
    solution: *mut *mut stickslip_rolling_solution,
) -> stickslip_status {
    // SAFETY: the rule for pointers.
    unsafe { solver::new_solution(solver, solution) }
}

/// Frees a solution; nothing for NULL.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_rolling_solution_free(
    solution: *mut stickslip_rolling_solution,
) -> stickslip_status {
    // SAFETY: the rule for pointers.
    call(|| unsafe { free(solution) })
}

pub(crate) fn of_rolling(solution: &RollingSolution, field: i32) -> Outcome<&Field> {
    match field {
        STICKSLIP_TRACTION_X => Ok(solution.traction()[0]),
        STICKSLIP_TRACTION_Y => Ok(solution.traction()[1]),
        STICKSLIP_SLIP_X => Ok(solution.slip()[0]),
        STICKSLIP_SLIP_Y => Ok(solution.slip()[1]),
        other => Err(none(other)),
    }
}

/// STICKSLIP_TRACTION_X, STICKSLIP_SLIP_X or those along y, and how many cells it has (count may be NULL); NULL on failure.
/// The slip is that for each length rolled (dimensionless), over the step that brought the particles to their cells.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_rolling_solution_field(
    solution: *const stickslip_rolling_solution,
    which: i32,
    count: *mut usize,
) -> *const f64 {
    // SAFETY: the rule for pointers.
    unsafe { show(solution, count, |of| Ok(of_rolling(of, which)?.as_slice())) }
}

/// The zone of every cell, STICKSLIP_SEPARATED, STICKSLIP_STICK or STICKSLIP_SLIP; NULL on failure.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_rolling_solution_zones(
    solution: *const stickslip_rolling_solution,
    count: *mut usize,
) -> *const u8 {
    // SAFETY: the rule for pointers.
    unsafe { show(solution, count, |of| Ok(of.zones())).cast() }
}

/// Energy that slip dissipates in each cell for each length rolled (a pressure), written to values, which has count
/// entries: what wear follows. Between bodies of the same material its integral is less than the work by a part that falls
/// with the size of the cells.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_rolling_solution_dissipation(
    solution: *const stickslip_rolling_solution,
    values: *mut f64,
    count: usize,
) -> stickslip_status {
    // SAFETY: the rule for pointers.
    call_on(solution, || unsafe {
        let solution = reading(solution)?;
        let values = cells_mut("values", solution.grid(), values, count)?;
        values.copy_from_slice(solution.dissipation()?.as_slice());
        Ok(())
    })
}

/// Numbers of a rolling contact.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct stickslip_rolling_result {
    /// The creepages along x and y, prescribed or caused by the forces (dimensionless).
    pub creepage: [f64; 2],
    /// The spin, prescribed or caused by the moment (one over a length).
    pub spin: f64,
    /// Tangential force that body 2 exerts on body 1.
    pub force: [f64; 2],
    /// Moment about z at the origin of the grid that the tractions exert on body 1 (a force times a length).
    pub moment: f64,
    /// Work that creepages and spin do for each length rolled (a force). Between bodies of the same material all of it is
    /// dissipated; between others the pressure does work as well, which is not in it.
    pub work: f64,
    /// Stick cells over contact cells.
    pub stick_ratio: f64,
    /// Room for members to come: zero.
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

/// The numbers of the contact.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_rolling_solution_result(
    solution: *const stickslip_rolling_solution,
    result: *mut stickslip_rolling_result,
) -> stickslip_status {
    // SAFETY: the rule for pointers.
    unsafe { tell(solution, ("result", result), |of| Ok(of.into())) }
}

/// How it was solved.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_rolling_solution_report(
    solution: *const stickslip_rolling_solution,
    report: *mut stickslip_report,
) -> stickslip_status {
    // SAFETY: the rule for pointers.
    unsafe { tell(solution, ("report", report), |of| Ok(of.report().into())) }
}

/// Diagnostics that may mislead: as stickslip_normal_solution_warnings.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_rolling_solution_warnings(
    solution: *const stickslip_rolling_solution,
    buffer: *mut stickslip_warning,
    capacity: usize,
    count: *mut usize,
) -> stickslip_status {
    // SAFETY: the rule for pointers.
    unsafe { warn(solution, (buffer, capacity, count), |of| Ok(of.warnings())) }
}
