! Fortran interface of stickslip.h, generated from it by make_bindings.py: do not edit. The rules at the head of
! stickslip.h apply here too. Each kind of object has a type that contains the C pointer. An omitted optional
! argument is passed as NULL. A matrix has its column index first. Members of structs have default values. The module
! stickslip has types that free themselves.
module stickslip_bindings
    use, intrinsic :: iso_c_binding
    implicit none
    private

    public :: stickslip_adaptive_steps_new
    public :: stickslip_adaptive_steps_free
    public :: stickslip_adaptive_steps_step
    public :: stickslip_adaptive_steps_stepwise
    public :: stickslip_adaptive_steps_error
    public :: stickslip_hertz_sphere
    public :: stickslip_cattaneo_mindlin_sphere
    public :: stickslip_carter_cylinder
    public :: stickslip_bentall_johnson_cylinder
    public :: stickslip_kalker_coefficients
    public :: stickslip_vermeulen_johnson_ellipse
    public :: stickslip_history_step_all
    public :: stickslip_bulk_strain
    public :: stickslip_coupled_solver_new
    public :: stickslip_coupled_solver_free
    public :: stickslip_coupled_solver_set_loads
    public :: stickslip_coupled_solver_set_gap
    public :: stickslip_coupled_solver_set_friction
    public :: stickslip_coupled_solver_set_settings
    public :: stickslip_coupled_solver_reset
    public :: stickslip_coupled_solver_solve
    public :: stickslip_coupled_solution_new
    public :: stickslip_coupled_solution_free
    public :: stickslip_coupled_solution_field
    public :: stickslip_coupled_solution_zones
    public :: stickslip_coupled_solution_results
    public :: stickslip_coupled_solution_report
    public :: stickslip_coupled_solution_warnings
    public :: stickslip_coupled_solution_stiffness
    public :: stickslip_coupled_solution_stiffness_observed
    public :: stickslip_coupled_rolling_solver_new
    public :: stickslip_coupled_rolling_solver_free
    public :: stickslip_coupled_rolling_solver_set_normal_load
    public :: stickslip_coupled_rolling_solver_set_load
    public :: stickslip_coupled_rolling_solver_set_gap
    public :: stickslip_coupled_rolling_solver_set_friction
    public :: stickslip_coupled_rolling_solver_set_settings
    public :: stickslip_coupled_rolling_solver_reset
    public :: stickslip_coupled_rolling_solver_solve
    public :: stickslip_coupled_rolling_solver_stiffness
    public :: stickslip_coupled_rolling_solution_new
    public :: stickslip_coupled_rolling_solution_free
    public :: stickslip_coupled_rolling_solution_field
    public :: stickslip_coupled_rolling_solution_zones
    public :: stickslip_coupled_rolling_solution_results
    public :: stickslip_coupled_rolling_solution_report
    public :: stickslip_coupled_rolling_solution_warnings
    public :: stickslip_rolling_solver_creep_forces
    public :: stickslip_rolling_solver_creep_forces_observed
    public :: stickslip_rolling_solver_creep_warnings
    public :: stickslip_cycle_new
    public :: stickslip_cycle_free
    public :: stickslip_cycle_begin
    public :: stickslip_cycle_add
    public :: stickslip_cycle_result_of
    public :: stickslip_cycle_field
    public :: stickslip_normal_solution_edges
    public :: stickslip_tangential_solution_edges
    public :: stickslip_coupled_solution_edges
    public :: stickslip_coupled_solution_pressure_edges
    public :: stickslip_normal_solution_discretisation_estimate
    public :: stickslip_tangential_solution_discretisation_estimate
    public :: stickslip_coupled_solution_discretisation_estimates
    public :: stickslip_last_error_message
    public :: stickslip_last_error_copy
    public :: stickslip_last_error
    public :: stickslip_last_error_report
    public :: stickslip_half_space_new
    public :: stickslip_half_space_new_coated
    public :: stickslip_half_space_new_distributed
    public :: stickslip_half_space_first_row
    public :: stickslip_half_space_set_cell_value
    public :: stickslip_half_space_cell_value
    public :: stickslip_half_space_free
    public :: stickslip_half_space_grid
    public :: stickslip_half_space_pair
    public :: stickslip_history_options_default
    public :: stickslip_history_new
    public :: stickslip_history_clone
    public :: stickslip_history_free
    public :: stickslip_history_step
    public :: stickslip_history_press
    public :: stickslip_history_press_stepwise
    public :: stickslip_history_set_gap
    public :: stickslip_history_set_friction
    public :: stickslip_history_set_settings
    public :: stickslip_history_set_relative_displacement
    public :: stickslip_history_stiffness
    public :: stickslip_history_stiffness_observed
    public :: stickslip_history_next_stiffness
    public :: stickslip_history_result
    public :: stickslip_history_normal_result
    public :: stickslip_history_grid
    public :: stickslip_history_friction_capacity
    public :: stickslip_history_reports
    public :: stickslip_history_warnings
    public :: stickslip_history_field
    public :: stickslip_history_zones
    public :: stickslip_settings_default
    public :: stickslip_coulomb
    public :: stickslip_jump_limits_default
    public :: stickslip_cycle_jump
    public :: stickslip_max_stable_cycles
    public :: stickslip_normal_solver_new
    public :: stickslip_normal_solver_free
    public :: stickslip_normal_solver_set_load
    public :: stickslip_normal_solver_set_gap
    public :: stickslip_normal_solver_set_settings
    public :: stickslip_normal_solver_reset
    public :: stickslip_normal_solver_solve
    public :: stickslip_normal_solution_new
    public :: stickslip_normal_solution_free
    public :: stickslip_normal_solution_field
    public :: stickslip_normal_solution_result
    public :: stickslip_normal_solution_report
    public :: stickslip_normal_solution_warnings
    public :: stickslip_normal_solution_stiffness
    public :: stickslip_normal_solution_stiffness_observed
    public :: stickslip_planes_new
    public :: stickslip_planes_free
    public :: stickslip_planes_solve
    public :: stickslip_planes_solve_observed
    public :: stickslip_planes_field
    public :: stickslip_planes_warnings
    public :: stickslip_planes_measure
    public :: stickslip_block_room
    public :: stickslip_rolling_options_default
    public :: stickslip_rolling_solver_new
    public :: stickslip_rolling_solver_free
    public :: stickslip_rolling_solver_set_load
    public :: stickslip_rolling_solver_set_friction
    public :: stickslip_rolling_solver_set_normal
    public :: stickslip_rolling_solver_set_pressure
    public :: stickslip_rolling_solver_set_normal_solver
    public :: stickslip_rolling_solver_set_normal_load
    public :: stickslip_rolling_solver_normal
    public :: stickslip_rolling_solver_friction_capacity
    public :: stickslip_rolling_solver_reset
    public :: stickslip_rolling_solver_set_settings
    public :: stickslip_rolling_solver_solve
    public :: stickslip_rolling_solver_stiffness
    public :: stickslip_rolling_solver_stiffness_observed
    public :: stickslip_rolling_solution_new
    public :: stickslip_rolling_solution_free
    public :: stickslip_rolling_solution_field
    public :: stickslip_rolling_solution_zones
    public :: stickslip_rolling_solution_dissipation_per_area
    public :: stickslip_rolling_solution_result
    public :: stickslip_rolling_solution_report
    public :: stickslip_rolling_solution_warnings
    public :: stickslip_self_affine_default
    public :: stickslip_surface_self_affine
    public :: stickslip_surface_self_affine_observed
    public :: stickslip_surface_statistics
    public :: stickslip_normal_solution_spots
    public :: stickslip_tangential_solution_spots
    public :: stickslip_history_spots
    public :: stickslip_state_new
    public :: stickslip_state_free
    public :: stickslip_state_keep
    public :: stickslip_history_set_state
    public :: stickslip_history_to_bytes
    public :: stickslip_history_from_bytes
    public :: stickslip_stiffness_options_default
    public :: stickslip_stiffness_workspace_new
    public :: stickslip_stiffness_workspace_free
    public :: stickslip_stiffness_workspace_set_options
    public :: stickslip_stiffness_workspace_report
    public :: stickslip_history_stiffness_with
    public :: stickslip_stress_at_points
    public :: stickslip_stress_at_points_observed
    public :: stickslip_surface_sphere
    public :: stickslip_surface_ellipsoid
    public :: stickslip_surface_cylinder
    public :: stickslip_tangential_options_default
    public :: stickslip_tangential_solver_new
    public :: stickslip_tangential_solver_new_under
    public :: stickslip_tangential_solver_free
    public :: stickslip_tangential_solver_set_load
    public :: stickslip_tangential_solver_set_friction
    public :: stickslip_tangential_solver_set_normal
    public :: stickslip_tangential_solver_set_pressure
    public :: stickslip_tangential_solver_set_relative_displacement
    public :: stickslip_tangential_solver_set_settings
    public :: stickslip_tangential_solver_reset
    public :: stickslip_tangential_solver_friction_capacity
    public :: stickslip_tangential_solver_solve
    public :: stickslip_tangential_solution_new
    public :: stickslip_tangential_solution_free
    public :: stickslip_tangential_solution_field
    public :: stickslip_tangential_solution_zones
    public :: stickslip_tangential_solution_result
    public :: stickslip_tangential_solution_report
    public :: stickslip_tangential_solution_warnings
    public :: stickslip_tangential_solution_stiffness
    public :: stickslip_tangential_solution_stiffness_observed
    public :: stickslip_set_num_threads
    public :: stickslip_version
    public :: stickslip_abi_version
    public :: stickslip_wear_archard
    public :: stickslip_wear_energy
    public :: stickslip_wear_threshold_energy

    ! Regime in which no cell slipped.
    integer(c_int32_t), parameter, public :: STICKSLIP_FULL_STICK = 0
    ! Regime in which some cells slipped, but some cells stuck at the end of each step.
    integer(c_int32_t), parameter, public :: STICKSLIP_PARTIAL_SLIP = 1
    ! Regime in which the whole contact was at its friction limit at the end of a step.
    integer(c_int32_t), parameter, public :: STICKSLIP_GROSS_SLIP = 2
    ! Pressure, zero outside the contact.
    integer(c_int32_t), parameter, public :: STICKSLIP_PRESSURE = 0
    ! Gap under load (lengths).
    integer(c_int32_t), parameter, public :: STICKSLIP_GAP = 1
    ! Shear traction along x that body 2 exerts on body 1 (pressures).
    integer(c_int32_t), parameter, public :: STICKSLIP_TRACTION_X = 2
    ! Shear traction along y.
    integer(c_int32_t), parameter, public :: STICKSLIP_TRACTION_Y = 3
    ! Slip along x (lengths): the motion of the surface of body 1 relative to body 2. The slip of a history is the sum over
    ! all steps.
    integer(c_int32_t), parameter, public :: STICKSLIP_SLIP_X = 4
    ! Slip along y.
    integer(c_int32_t), parameter, public :: STICKSLIP_SLIP_Y = 5
    ! Displacement along x due to pressure and tractions (lengths). For coupled solutions it is the displacement of body 1
    ! relative to body 2, and for planes below the surface the displacement of the body.
    integer(c_int32_t), parameter, public :: STICKSLIP_DISPLACEMENT_X = 6
    ! Displacement along y due to pressure and tractions (lengths).
    integer(c_int32_t), parameter, public :: STICKSLIP_DISPLACEMENT_Y = 7
    ! Displacement along z due to pressure and tractions (lengths); for coupled solutions the sum over both bodies.
    integer(c_int32_t), parameter, public :: STICKSLIP_DISPLACEMENT_Z = 8
    ! Length of the slip path over all steps of a history or of a cycle (lengths).
    integer(c_int32_t), parameter, public :: STICKSLIP_SLIP_DISTANCE = 9
    ! Energy dissipated in each cell over all steps of a history or of a cycle.
    integer(c_int32_t), parameter, public :: STICKSLIP_DISSIPATED_ENERGY = 10
    ! Gap of a history before loading: the last gap that was set, plus STICKSLIP_YIELDED_DEPTH (lengths). Subtract this depth before
    ! the gap is set again, because the history adds it.
    integer(c_int32_t), parameter, public :: STICKSLIP_INITIAL_GAP = 11
    ! Slip along x of the last step of a history (lengths).
    integer(c_int32_t), parameter, public :: STICKSLIP_STEP_SLIP_X = 12
    ! Slip along y of the last step.
    integer(c_int32_t), parameter, public :: STICKSLIP_STEP_SLIP_Y = 13
    ! Length of the slip of the last step.
    integer(c_int32_t), parameter, public :: STICKSLIP_STEP_SLIP_DISTANCE = 14
    ! Energy dissipated in each cell in the last step, computed with the traction at the end of the step.
    integer(c_int32_t), parameter, public :: STICKSLIP_STEP_DISSIPATED_ENERGY = 15
    ! Energy dissipated in each cell in the last step, computed with the mean traction of the step; this value closes the
    ! energy balance.
    integer(c_int32_t), parameter, public :: STICKSLIP_STEP_MID_DISSIPATED_ENERGY = 16
    ! Permanent set added to the gap (lengths); only for histories with a permanent set.
    integer(c_int32_t), parameter, public :: STICKSLIP_YIELDED_DEPTH = 17
    ! Mean pressure during slip, weighted by the slip; only for cycles.
    integer(c_int32_t), parameter, public :: STICKSLIP_SLIP_PRESSURE = 18
    ! Amplitude of the slip along x (lengths); only for cycles.
    integer(c_int32_t), parameter, public :: STICKSLIP_SLIP_AMPLITUDE_X = 19
    ! Amplitude of the slip along y (lengths); only for cycles.
    integer(c_int32_t), parameter, public :: STICKSLIP_SLIP_AMPLITUDE_Y = 20
    ! Stress xx on a plane below the surface (pressures, positive in tension).
    integer(c_int32_t), parameter, public :: STICKSLIP_STRESS_XX = 21
    ! Stress yy on a plane.
    integer(c_int32_t), parameter, public :: STICKSLIP_STRESS_YY = 22
    ! Stress zz on a plane.
    integer(c_int32_t), parameter, public :: STICKSLIP_STRESS_ZZ = 23
    ! Stress xy on a plane.
    integer(c_int32_t), parameter, public :: STICKSLIP_STRESS_XY = 24
    ! Stress xz on a plane.
    integer(c_int32_t), parameter, public :: STICKSLIP_STRESS_XZ = 25
    ! Stress yz on a plane.
    integer(c_int32_t), parameter, public :: STICKSLIP_STRESS_YZ = 26
    ! Von Mises equivalent stress (pressures), for stickslip_planes_measure.
    integer(c_int32_t), parameter, public :: STICKSLIP_VON_MISES = 27
    ! Largest shear stress (pressures), for stickslip_planes_measure: half the difference between the largest and the smallest
    ! principal stress.
    integer(c_int32_t), parameter, public :: STICKSLIP_MAX_SHEAR = 28
    ! Mean of the normal stresses (pressures, positive in tension), for stickslip_planes_measure.
    integer(c_int32_t), parameter, public :: STICKSLIP_HYDROSTATIC = 29
    ! Zone of a cell out of contact.
    integer(c_int8_t), parameter, public :: STICKSLIP_SEPARATED = 0
    ! Zone of a cell in contact, below the friction limit.
    integer(c_int8_t), parameter, public :: STICKSLIP_STICK = 1
    ! Zone of a cell in contact, at the friction limit.
    integer(c_int8_t), parameter, public :: STICKSLIP_SLIP = 2
    ! Axis x.
    integer(c_int32_t), parameter, public :: STICKSLIP_X = 0
    ! Axis y.
    integer(c_int32_t), parameter, public :: STICKSLIP_Y = 1
    ! Entry rule: a cell that comes into contact within a step follows the motion from its first touch, proportionally to
    ! the growth of its own pressure (default).
    integer(c_int32_t), parameter, public :: STICKSLIP_SINCE_TOUCH = 0
    ! Entry rule: a cell that comes into contact within a step follows the whole motion of the step.
    integer(c_int32_t), parameter, public :: STICKSLIP_WHOLE_STEP = 1
    ! Boundary of a grid that is a patch on infinite bodies.
    integer(c_int32_t), parameter, public :: STICKSLIP_NON_PERIODIC = 0
    ! Boundary of a grid that is periodic along x and y.
    integer(c_int32_t), parameter, public :: STICKSLIP_PERIODIC = 1
    ! Boundary of a grid that is periodic along y only.
    integer(c_int32_t), parameter, public :: STICKSLIP_PERIODIC_ALONG_Y = 2
    ! Cell value: the traction is uniform over the cell.
    integer(c_int32_t), parameter, public :: STICKSLIP_UNIFORM = 0
    ! Cell value: the traction at the centre of the cell; the traction is smooth between the centres.
    integer(c_int32_t), parameter, public :: STICKSLIP_CENTRE = 1
    ! Active-set method (default).
    integer(c_int32_t), parameter, public :: STICKSLIP_ACTIVE_SET = 0
    ! Polonsky-Keer iteration, for the pressure or for one traction.
    integer(c_int32_t), parameter, public :: STICKSLIP_POLONSKY_KEER = 1
    ! Holds the pressure or the shift. A held shift does not hold the tangential force.
    integer(c_int32_t), parameter, public :: STICKSLIP_HOLD = 0
    ! Prescribes a force.
    integer(c_int32_t), parameter, public :: STICKSLIP_FORCE = 1
    ! Prescribes the approach of the bodies (a length), measured from the datum of the gap.
    integer(c_int32_t), parameter, public :: STICKSLIP_APPROACH = 2
    ! Prescribes the shift, the rigid motion of body 2 relative to body 1 far from the contact since the unloaded state (a
    ! length): the relative rigid tangential displacement.
    integer(c_int32_t), parameter, public :: STICKSLIP_SHIFT = 3
    ! Prescribes a spring that drags body 2: the force is stiffness * (value - shift). The stretch, value - shift, must not exceed a
    ! million sides of the grid.
    integer(c_int32_t), parameter, public :: STICKSLIP_SPRING = 4
    ! Model with the traction along the load only (default).
    integer(c_int32_t), parameter, public :: STICKSLIP_SCALAR = 0
    ! Model with both tractions, for loads in any direction.
    integer(c_int32_t), parameter, public :: STICKSLIP_VECTOR = 1
    ! Full coupling of pressure and traction; only for coupled solvers and histories.
    integer(c_int32_t), parameter, public :: STICKSLIP_FULL = 0
    ! One-way coupling: the pressure causes tangential displacements, but the tractions do not change the pressure.
    integer(c_int32_t), parameter, public :: STICKSLIP_ONE_WAY = 1
    ! No coupling in either direction.
    integer(c_int32_t), parameter, public :: STICKSLIP_NEGLECTED = 2
    ! Status: nothing has been solved yet.
    integer(c_int32_t), parameter, public :: STICKSLIP_UNSOLVED = 0
    ! Status: the residual and the certified error, both computed from a new product, are at or below the tolerance.
    integer(c_int32_t), parameter, public :: STICKSLIP_CONVERGED = 1
    ! Status: the iteration limit was reached first.
    integer(c_int32_t), parameter, public :: STICKSLIP_AT_ITERATION_LIMIT = 2
    ! Status: the time limit was reached first.
    integer(c_int32_t), parameter, public :: STICKSLIP_AT_TIME_LIMIT = 3
    ! Status: the residual no longer decreases because the tolerance is below round-off.
    integer(c_int32_t), parameter, public :: STICKSLIP_STALLED = 4
    ! Status: the observer ended the solve.
    integer(c_int32_t), parameter, public :: STICKSLIP_CANCELLED = 5
    ! No bound on the smallest eigenvalue of the operator, on which certified errors rely, is available. The error bound
    ! is then the square root of the duality gap of the problem, and decreases only with the square root of the residual.
    integer(c_int32_t), parameter, public :: STICKSLIP_EIGENVALUE_UNKNOWN = 0
    ! The eigenvalue bound is an estimate on the safe side, used for stiff coatings on long grids.
    integer(c_int32_t), parameter, public :: STICKSLIP_EIGENVALUE_ESTIMATED = 1
    ! The eigenvalue bound is a computed lower bound.
    integer(c_int32_t), parameter, public :: STICKSLIP_EIGENVALUE_PROVEN = 2
    ! The eigenvalue bound is a lower bound stated by a user-defined operator. The library does not check it.
    integer(c_int32_t), parameter, public :: STICKSLIP_EIGENVALUE_STATED = 3
    ! Warning: there is no contact.
    integer(c_int32_t), parameter, public :: STICKSLIP_WARNING_NO_CONTACT = 1
    ! Warning: contact cells (number in cells) lie on the edge of the grid.
    integer(c_int32_t), parameter, public :: STICKSLIP_WARNING_CONTACT_AT_EDGE = 2
    ! Warning: some contact spots (number in cells, out of the total in of) are smaller than five cells and together contain a
    ! tenth of the contact cells or more.
    integer(c_int32_t), parameter, public :: STICKSLIP_WARNING_UNRESOLVED_SPOTS = 3
    ! Warning: the grid is a line of cells and not periodic.
    integer(c_int32_t), parameter, public :: STICKSLIP_WARNING_SINGLE_ROW_OF_CELLS = 4
    ! Warning: a contact spot extends across the whole grid.
    integer(c_int32_t), parameter, public :: STICKSLIP_WARNING_CONTACT_SPANS_GRID = 5
    ! Warning: the pressure of some cells (number in cells) exceeds the hardness of a material.
    integer(c_int32_t), parameter, public :: STICKSLIP_WARNING_BEYOND_HARDNESS = 6
    ! Warning: the pressure was held although the gap had changed.
    integer(c_int32_t), parameter, public :: STICKSLIP_WARNING_STALE_PRESSURE = 7
    ! Warning: the contact has too few cells (number in cells).
    integer(c_int32_t), parameter, public :: STICKSLIP_WARNING_UNDERRESOLVED_CONTACT = 8
    ! Warning: too few cells (number in cells) stick.
    integer(c_int32_t), parameter, public :: STICKSLIP_WARNING_UNDERRESOLVED_STICK_ZONE = 9
    ! Warning: the slip zone is narrower than two cells, or than one cell in a step with rolling.
    integer(c_int32_t), parameter, public :: STICKSLIP_WARNING_UNDERRESOLVED_SLIP_ZONE = 10
    ! Warning: a coupled problem was pressed in one step.
    integer(c_int32_t), parameter, public :: STICKSLIP_WARNING_SINGLE_LOAD_STEP = 11
    ! Warning: the estimated discretisation error of the pressure or the traction exceeds 5 %. An error of 1 % requires a
    ! larger number of cells (number in cells) along the radius of a contact spot.
    integer(c_int32_t), parameter, public :: STICKSLIP_WARNING_DISCRETISATION_ERROR = 12
    ! Warning: the approach exceeds the longest side of the grid.
    integer(c_int32_t), parameter, public :: STICKSLIP_WARNING_APPROACH_BEYOND_GRID = 13
    ! Warning: the contact radius exceeds 0.3 of the radius of curvature.
    integer(c_int32_t), parameter, public :: STICKSLIP_WARNING_LARGE_CONTACT_RADIUS = 14
    ! Warning: the rms slope of the surface within the contact exceeds 0.5.
    integer(c_int32_t), parameter, public :: STICKSLIP_WARNING_STEEP_SURFACE = 15
    ! Warning: a step of a history held the shift, and the tangential force decreased by more than half.
    integer(c_int32_t), parameter, public :: STICKSLIP_WARNING_HELD_SHIFT_LOST_FORCE = 16
    ! Warning: tractions of dissimilar rolling bodies change the pressure, and this change is neglected.
    integer(c_int32_t), parameter, public :: STICKSLIP_WARNING_NEGLECTED_LIFT = 17
    ! Warning: a layer is more than ten times as thick as the longest side of the grid, so that the material below it has almost no effect.
    integer(c_int32_t), parameter, public :: STICKSLIP_WARNING_COATING_BEYOND_GRID = 18
    ! Warning: a layer is too thin to have an effect on the cells.
    integer(c_int32_t), parameter, public :: STICKSLIP_WARNING_COATING_BELOW_CELL = 19
    ! Warning: the shift or relative displacement of a step, or the range of the shift over steps, exceeds the side of the grid.
    integer(c_int32_t), parameter, public :: STICKSLIP_WARNING_SHIFT_BEYOND_GRID = 20
    ! Warning: the twist of a step, or the range of the twist over steps, exceeds 0.2 rad.
    integer(c_int32_t), parameter, public :: STICKSLIP_WARNING_LARGE_TWIST = 21
    ! Warning: the creepage of rolling bodies is 0.1 or more.
    integer(c_int32_t), parameter, public :: STICKSLIP_WARNING_LARGE_CREEPAGE = 22
    ! Warning: a relative displacement of the amount zero has no effect on a step with a tangential load.
    integer(c_int32_t), parameter, public :: STICKSLIP_WARNING_UNUSED_RELATIVE_DISPLACEMENT = 23
    ! Warning: a cycle repeats a closed loop, so that its energies are sums over several loops.
    integer(c_int32_t), parameter, public :: STICKSLIP_WARNING_REPEATED_LOOP = 24
    ! Warning: the largest pressure exceeds half of the contact modulus.
    integer(c_int32_t), parameter, public :: STICKSLIP_WARNING_PRESSURE_BEYOND_MODULUS = 25
    ! Warning: the solve ended before it converged.
    integer(c_int32_t), parameter, public :: STICKSLIP_WARNING_NOT_CONVERGED = 26
    ! Warning: the largest coefficient of friction exceeds 5, as a coefficient in per cent.
    integer(c_int32_t), parameter, public :: STICKSLIP_WARNING_LARGE_FRICTION = 27
    ! Warning: the gap of contact cells changed by more than the largest normal displacement of the last contact.
    integer(c_int32_t), parameter, public :: STICKSLIP_WARNING_LARGE_GAP_CHANGE = 28
    ! Warning: almost all contact cells are at a hardness far below the contact modulus.
    integer(c_int32_t), parameter, public :: STICKSLIP_WARNING_LOW_HARDNESS = 29
    ! Warning: the largest shear stress lowers the friction capacity to less than 1 %.
    integer(c_int32_t), parameter, public :: STICKSLIP_WARNING_LOW_SHEAR_STRESS = 30
    ! Warning: the loads of a cycle turn back, but the cycle does not close.
    integer(c_int32_t), parameter, public :: STICKSLIP_WARNING_OPEN_CYCLE = 31
    ! Warning: the largest prescribed pressure is below 1e-7 of the contact modulus.
    integer(c_int32_t), parameter, public :: STICKSLIP_WARNING_LOW_PRESSURE = 32
    ! Warning: the gap jumps across the border of a periodic grid, as a tilted surface.
    integer(c_int32_t), parameter, public :: STICKSLIP_WARNING_PERIODIC_SEAM = 33
    ! Warning: a component of a bulk strain exceeds 0.02, as a strain in per cent.
    integer(c_int32_t), parameter, public :: STICKSLIP_WARNING_LARGE_BULK_STRAIN = 34
    ! Warning: the scalar model with one-way coupling neglects large tractions across its axis.
    integer(c_int32_t), parameter, public :: STICKSLIP_WARNING_NEGLECTED_TRACTION = 35
    ! Warning: the hardness exceeds the modulus of the body and has no effect.
    integer(c_int32_t), parameter, public :: STICKSLIP_WARNING_HARDNESS_BEYOND_MODULUS = 36
    ! Warning: the largest shear stress of the friction exceeds the modulus of the bodies.
    integer(c_int32_t), parameter, public :: STICKSLIP_WARNING_SHEAR_STRESS_BEYOND_MODULUS = 37
    ! Warning: the gap before loading resembles the gap under load of an earlier solution.
    integer(c_int32_t), parameter, public :: STICKSLIP_WARNING_CLOSED_GAP = 38
    ! Warning: the gap decreased in cells that have slipped, and increased in none.
    integer(c_int32_t), parameter, public :: STICKSLIP_WARNING_NEGATIVE_WEAR = 39
    ! Warning: the depth of a plane is less than a side of a cell, and shear tractions above it end at the edge of a contact.
    integer(c_int32_t), parameter, public :: STICKSLIP_WARNING_STRESS_AT_EDGE = 40
    ! Any other warning, described by its message.
    integer(c_int32_t), parameter, public :: STICKSLIP_WARNING_OTHER = 127
    ! Size of the message of a warning in bytes.
    integer(c_int32_t), parameter, public :: STICKSLIP_WARNING_LENGTH = 384
    ! Prescribes a creepage, the motion of body 2 over body 1 per unit length rolled (dimensionless). A positive creepage
    ! causes a positive force. Kalker and CONTACT define creepage and spin with the opposite sign.
    integer(c_int32_t), parameter, public :: STICKSLIP_CREEPAGE = 6
    ! Prescribes the spin, the rotation of body 2 relative to body 1 about the origin of the grid per unit length rolled (one
    ! over a length, positive from x to y).
    integer(c_int32_t), parameter, public :: STICKSLIP_SPIN = 7
    ! Prescribes the moment on body 1 about the origin of the grid (a force times a length, positive from x to y).
    integer(c_int32_t), parameter, public :: STICKSLIP_MOMENT = 5
    ! Leading edge at the largest x, where particles enter the contact (default).
    integer(c_int32_t), parameter, public :: STICKSLIP_PLUS_X = 0
    ! Leading edge at the smallest x.
    integer(c_int32_t), parameter, public :: STICKSLIP_MINUS_X = 1
    ! Leading edge at the largest y.
    integer(c_int32_t), parameter, public :: STICKSLIP_PLUS_Y = 2
    ! Leading edge at the smallest y.
    integer(c_int32_t), parameter, public :: STICKSLIP_MINUS_Y = 3
    ! Amplitudes: each wave has the amplitude of the spectrum and a random phase (default).
    integer(c_int32_t), parameter, public :: STICKSLIP_EXACT = 0
    ! Amplitudes: amplitudes and phases are random, like those of filtered white noise.
    integer(c_int32_t), parameter, public :: STICKSLIP_GAUSSIAN = 1
    ! Success.
    integer(c_int32_t), parameter, public :: STICKSLIP_OK = 0
    ! The tolerance was not reached, or the observer or a limit ended the solve. The solution contains the last feasible
    ! iterate and its report. A history is unchanged, and stickslip_last_error_report writes the report.
    integer(c_int32_t), parameter, public :: STICKSLIP_NOT_CONVERGED = 1
    ! The tangential force exceeds the friction capacity, or the moment about the normal is at or beyond an end of the range that
    ! friction can carry (value and limit): no equilibrium exists.
    integer(c_int32_t), parameter, public :: STICKSLIP_BEYOND_FRICTION_CAPACITY = 2
    ! The normal force (value) exceeds the largest force that the cells can carry at their hardness (limit).
    integer(c_int32_t), parameter, public :: STICKSLIP_BEYOND_HARDNESS = 3
    ! The bodies do not touch: a tangential load requires a contact.
    integer(c_int32_t), parameter, public :: STICKSLIP_EMPTY_CONTACT = 4
    ! The approach (value) is not below the mean gap (limit) of a periodic contact.
    integer(c_int32_t), parameter, public :: STICKSLIP_APPROACH_BEYOND_MEAN_GAP = 5
    ! The materials couple pressure and traction (value: Dundurs' beta), and the requested model does not include the
    ! coupling.
    integer(c_int32_t), parameter, public :: STICKSLIP_COUPLED_MATERIALS = 6
    ! The model does not include this load (value).
    integer(c_int32_t), parameter, public :: STICKSLIP_UNSUPPORTED_BY_MODEL = 7
    ! The load has components along both axes, which the scalar model does not allow (value: along x, limit: along y).
    integer(c_int32_t), parameter, public :: STICKSLIP_OBLIQUE_LOAD = 8
    ! The load was divided into the shortest steps allowed, and the error of a step (value) still exceeds its tolerance
    ! (limit).
    integer(c_int32_t), parameter, public :: STICKSLIP_STEP_TOO_LONG = 9
    ! Some cells (index: their number) are at their hardness, but the requested operation requires an elastic contact.
    integer(c_int32_t), parameter, public :: STICKSLIP_YIELDED = 10
    ! The history has taken no step since the last step of the cycle.
    integer(c_int32_t), parameter, public :: STICKSLIP_STEP_OUT_OF_ORDER = 11
    ! The cycle does not close: its cyclic residual (value) exceeds the limit (limit) for a cycle that represents the
    ! following cycles.
    integer(c_int32_t), parameter, public :: STICKSLIP_CYCLE_NOT_CLOSED = 12
    ! The history has no last step: it took no step since it was created or its state was set. Make a step after
    ! stickslip_history_set_state or stickslip_history_from_bytes.
    integer(c_int32_t), parameter, public :: STICKSLIP_NO_LAST_STEP = 13
    ! A stiffness was requested after a change of friction, gap, pressure or load, to which the last solution does not belong. Solve
    ! again, or take a step, before you compute the stiffness. Or a rolling solver does not have the pressure of a normal load: set a
    ! normal load before you copy its normal contact.
    integer(c_int32_t), parameter, public :: STICKSLIP_OUTDATED_SOLUTION = 14
    ! A new gap is the gap under load of the last solution. Add the wear to the gap before loading.
    integer(c_int32_t), parameter, public :: STICKSLIP_GAP_UNDER_LOAD = 15
    ! A required handle or another required pointer is NULL or misaligned.
    integer(c_int32_t), parameter, public :: STICKSLIP_BAD_POINTER = 32
    ! Another thread is using the handle, or a batch contains it twice; nothing was done with it.
    integer(c_int32_t), parameter, public :: STICKSLIP_BUSY = 33
    ! The number (value) is not a constant of the required kind, or a struct has a member that this library does not support:
    ! reserved is not zero.
    integer(c_int32_t), parameter, public :: STICKSLIP_UNKNOWN_OPTION = 34
    ! The capacity of the buffer (found) is smaller than the number of entries (expected).
    integer(c_int32_t), parameter, public :: STICKSLIP_BUFFER_TOO_SMALL = 35
    ! Some histories of a batch failed: codes has the reason for each, and the last error belongs to the first failure
    ! (index).
    integer(c_int32_t), parameter, public :: STICKSLIP_SOME_FAILED = 36
    ! The threads cannot be created.
    integer(c_int32_t), parameter, public :: STICKSLIP_NO_THREADS = 37
    ! The library has a defect. The objects of the call can be freed but should not be used otherwise.
    integer(c_int32_t), parameter, public :: STICKSLIP_PANIC = 38
    ! A grid needs at least one cell along each axis.
    integer(c_int32_t), parameter, public :: STICKSLIP_GRID_SIZE = 64
    ! Memory cannot be allocated, and none was allocated.
    integer(c_int32_t), parameter, public :: STICKSLIP_MEMORY = 65
    ! A quantity (value) that must be positive and finite is not.
    integer(c_int32_t), parameter, public :: STICKSLIP_NOT_POSITIVE = 66
    ! A quantity (value) that must be zero or positive, and finite, is not.
    integer(c_int32_t), parameter, public :: STICKSLIP_NEGATIVE_OR_NOT_FINITE = 67
    ! A quantity (value) that must be finite is not.
    integer(c_int32_t), parameter, public :: STICKSLIP_NOT_FINITE = 68
    ! A sample (value, at index) of a field violates a rule for that field.
    integer(c_int32_t), parameter, public :: STICKSLIP_SAMPLE = 69
    ! Poisson's ratio (value) lies outside (-1, 1/2].
    integer(c_int32_t), parameter, public :: STICKSLIP_POISSON_RATIO = 70
    ! Both bodies are rigid: nothing deforms.
    integer(c_int32_t), parameter, public :: STICKSLIP_BOTH_RIGID = 71
    ! The cells are too long: double precision does not resolve the compliance of their shortest waves.
    integer(c_int32_t), parameter, public :: STICKSLIP_CELLS_TOO_LONG = 72
    ! An array has the wrong number of entries (found instead of expected).
    integer(c_int32_t), parameter, public :: STICKSLIP_LENGTH = 73
    ! Two objects have different grids.
    integer(c_int32_t), parameter, public :: STICKSLIP_GRID_MISMATCH = 74
    ! Two objects belong to bodies with different boundaries.
    integer(c_int32_t), parameter, public :: STICKSLIP_BOUNDARY_MISMATCH = 75
    ! Two objects belong to bodies of different materials.
    integer(c_int32_t), parameter, public :: STICKSLIP_MATERIAL_MISMATCH = 76
    ! The tolerance (value) lies outside (0, 1).
    integer(c_int32_t), parameter, public :: STICKSLIP_TOLERANCE = 77
    ! The iteration limit is zero.
    integer(c_int32_t), parameter, public :: STICKSLIP_ITERATION_LIMIT = 78
    ! A solver cannot hold a pressure, which only a history can: prescribe a force or an approach.
    integer(c_int32_t), parameter, public :: STICKSLIP_NO_PRESSURE_TO_HOLD = 79
    ! The method does not solve this kind of problem.
    integer(c_int32_t), parameter, public :: STICKSLIP_METHOD = 80
    ! A quantity (value) is below its lower limit (limit).
    integer(c_int32_t), parameter, public :: STICKSLIP_BELOW_MINIMUM = 81
    ! The bytes are not a saved history, have a different version, or are damaged.
    integer(c_int32_t), parameter, public :: STICKSLIP_FORMAT = 82
    ! The body is rigid: its stress is not determined.
    integer(c_int32_t), parameter, public :: STICKSLIP_RIGID_BODY = 83
    ! A sum over images does not converge on a grid that is periodic along both axes.
    integer(c_int32_t), parameter, public :: STICKSLIP_DIVERGENT_PERIODIC_SUM = 84
    ! The Hurst exponent (value) lies outside [0, 1].
    integer(c_int32_t), parameter, public :: STICKSLIP_HURST = 85
    ! No wave of the surface has a wavelength between the longest (value) and the shortest (limit).
    integer(c_int32_t), parameter, public :: STICKSLIP_NO_WAVE_IN_BAND = 86
    ! No heights of this skewness (value) and kurtosis (limit) were found.
    integer(c_int32_t), parameter, public :: STICKSLIP_HEIGHT_MOMENTS_NOT_REACHED = 87
    ! Two objects belong to bodies with different meanings of the cell values.
    integer(c_int32_t), parameter, public :: STICKSLIP_CELL_VALUE_MISMATCH = 88
    ! The ranks cannot continue together: a rank (index) is lost, makes different calls or has rejected its part, or the ranks
    ! have different inputs, which the message names.
    integer(c_int32_t), parameter, public :: STICKSLIP_RANK_FAILURE = 89
    ! A step with rolling requires more cells (expected) ahead of the contact or behind it than the grid has there (found).
    integer(c_int32_t), parameter, public :: STICKSLIP_GRID_TOO_SHORT = 90
    ! A quantity (value) is beyond a limit (limit) outside which its square overflows or underflows: choose other units.
    integer(c_int32_t), parameter, public :: STICKSLIP_EXTREME_NUMBER = 91
    ! Any other error, described by its message.
    integer(c_int32_t), parameter, public :: STICKSLIP_INVALID_ARGUMENT = 127
    ! Body 1; z points into it.
    integer(c_int32_t), parameter, public :: STICKSLIP_BODY_1 = 1
    ! Body 2, above body 1.
    integer(c_int32_t), parameter, public :: STICKSLIP_BODY_2 = 2
    ! Major version of the library.
    integer(c_int32_t), parameter, public :: STICKSLIP_VERSION_MAJOR = 0
    ! Minor version of the library.
    integer(c_int32_t), parameter, public :: STICKSLIP_VERSION_MINOR = 1
    ! Patch version of the library.
    integer(c_int32_t), parameter, public :: STICKSLIP_VERSION_PATCH = 0
    ! Version of the binary interface: functions, layouts of structs and meanings of constants.
    !
    ! This version increases whenever a program compiled with an older header could malfunction, and it is part of the SONAME.
    ! A patch release never changes it; before 1.0, a minor release may change it. New functions, new constants and members
    ! that replace reserved bytes do not change it. A program that loads the library at run time should first compare this
    ! constant with stickslip_abi_version().
    integer(c_int32_t), parameter, public :: STICKSLIP_ABI_VERSION_COMPILED = 2

    ! Adaptive load stepper, which applies loads in steps that are short enough for a tolerance on the tractions. The
    ! error of a step is the difference between its result and the result of two half steps. The object can be used for
    ! every history on the same grid.
    type, bind(c), public :: stickslip_adaptive_steps
        type(c_ptr) :: address = c_null_ptr
    end type stickslip_adaptive_steps

    ! Block that this rank receives.
    type, bind(c), public :: stickslip_block
        type(c_ptr) :: address = c_null_ptr
    end type stickslip_block

    ! Pressure, traction, slip and creepage of coupled steady rolling. Fields are read without a copy and remain valid until
    ! the next solve into the solution or until it is freed.
    type, bind(c), public :: stickslip_coupled_rolling_solution
        type(c_ptr) :: address = c_null_ptr
    end type stickslip_coupled_rolling_solution

    ! Solver for coupled steady rolling under a sequence of loads. Each solve starts from the last solution.
    type, bind(c), public :: stickslip_coupled_rolling_solver
        type(c_ptr) :: address = c_null_ptr
    end type stickslip_coupled_rolling_solver

    ! Pressure, tractions and displacements of a coupled contact. Fields are read without a copy and remain valid until the
    ! next solve into the solution or until it is freed.
    type, bind(c), public :: stickslip_coupled_solution
        type(c_ptr) :: address = c_null_ptr
    end type stickslip_coupled_solution

    ! Solver for repeated coupled contacts, each loaded from rest in one step. Each solve starts from the last solution.
    type, bind(c), public :: stickslip_coupled_solver
        type(c_ptr) :: address = c_null_ptr
    end type stickslip_coupled_solver

    ! Sums over the steps of a history since the start of the cycle.
    type, bind(c), public :: stickslip_cycle
        type(c_ptr) :: address = c_null_ptr
    end type stickslip_cycle

    ! Two elastic half-spaces on a grid, with the operators that all contacts on them share. Solvers and histories keep the
    ! parts they need, so the half-spaces may be freed first. Many threads may use the same object simultaneously.
    type, bind(c), public :: stickslip_half_space
        type(c_ptr) :: address = c_null_ptr
    end type stickslip_half_space

    ! Contact that is loaded step by step, with memory of slip. A failed step leaves the history bitwise unchanged. Fields are
    ! read without a copy and remain valid until the next call that changes the history.
    type, bind(c), public :: stickslip_history
        type(c_ptr) :: address = c_null_ptr
    end type stickslip_history

    ! Pressure, gap and approach of a normal contact. Fields are read without a copy and remain valid until the next solve
    ! into the solution or until it is freed.
    type, bind(c), public :: stickslip_normal_solution
        type(c_ptr) :: address = c_null_ptr
    end type stickslip_normal_solution

    ! Solver for repeated normal contacts of two bodies. Each solve starts from the last solution.
    type, bind(c), public :: stickslip_normal_solver
        type(c_ptr) :: address = c_null_ptr
    end type stickslip_normal_solver

    ! Planes at chosen depths below each body, and the last solved plane. Fields are read without a copy and remain valid
    ! until the next solve or until the planes are freed.
    type, bind(c), public :: stickslip_planes
        type(c_ptr) :: address = c_null_ptr
    end type stickslip_planes

    ! Traction, slip and creepage of steady rolling. Fields are read without a copy and remain valid until the next solve into
    ! the solution or until it is freed.
    type, bind(c), public :: stickslip_rolling_solution
        type(c_ptr) :: address = c_null_ptr
    end type stickslip_rolling_solution

    ! Solver for steady rolling with a sequence of creepages, forces or spins. Each solve starts from the last solution.
    type, bind(c), public :: stickslip_rolling_solver
        type(c_ptr) :: address = c_null_ptr
    end type stickslip_rolling_solver

    ! Saved state of a history, including gap, friction and settings. A history can return to this state.
    type, bind(c), public :: stickslip_state
        type(c_ptr) :: address = c_null_ptr
    end type stickslip_state

    ! Buffers, options and report of stiffnesses that are computed repeatedly, for example in a Newton iteration. The first
    ! stiffness allocates. Later stiffnesses allocate only for other bodies, another size of the window, or more cells or steps
    ! than before.
    type, bind(c), public :: stickslip_stiffness_workspace
        type(c_ptr) :: address = c_null_ptr
    end type stickslip_stiffness_workspace

    ! Traction, slip and shift of a tangential contact. Fields are read without a copy and remain valid until the next solve
    ! into the solution or until it is freed.
    type, bind(c), public :: stickslip_tangential_solution
        type(c_ptr) :: address = c_null_ptr
    end type stickslip_tangential_solution

    ! Solver for repeated tangential contacts, each loaded from rest. Each solve starts from the last solution.
    type, bind(c), public :: stickslip_tangential_solver
        type(c_ptr) :: address = c_null_ptr
    end type stickslip_tangential_solver

    ! Normal load.
    type, bind(c), public :: stickslip_normal_load
        ! Kind of load: STICKSLIP_HOLD, STICKSLIP_FORCE or STICKSLIP_APPROACH.
        integer(c_int32_t) :: kind = 0
        ! Force (zero or positive) or approach (a length, positive if the bodies move towards each other); zero for
        ! STICKSLIP_HOLD.
        real(c_double) :: value = 0
    end type stickslip_normal_load

    ! Prescribed tangential load along one axis.
    type, bind(c), public :: stickslip_control
        ! Kind of load: STICKSLIP_HOLD, STICKSLIP_FORCE, STICKSLIP_SHIFT or STICKSLIP_SPRING.
        integer(c_int32_t) :: kind = 0
        ! Force that body 2 exerts on body 1, shift (a length), or position of the far end of the spring (a length). In a
        ! history, shift and position are measured since its start, and a later step without a spring holds the shift. Zero
        ! for STICKSLIP_HOLD.
        real(c_double) :: value = 0
        ! Stiffness of the spring (a force over a length); zero for all other kinds.
        real(c_double) :: stiffness = 0
    end type stickslip_control

    ! Rolling in a step of a history: the memory of the particles moves through the contact while body 2 creeps over body 1.
    ! All members are zero if the bodies do not roll. A step with rolling must not prescribe a shift, a spring or a twist.
    ! Along an axis with a prescribed force, the creepage is a result and must be zero here.
    type, bind(c), public :: stickslip_roll
        ! Number of cells by which the particles of both surfaces move through the contact, one or more. The grid must
        ! extend by this number of cells ahead of and behind the contact; otherwise the step returns
        ! STICKSLIP_GRID_TOO_SHORT. The entry rule needs the slope of the gap two cells further ahead. If the grid ends
        ! before, this slope is one-sided.
        integer(c_int32_t) :: cells = 0
        ! Edge at which particles enter the contact: STICKSLIP_PLUS_X, STICKSLIP_MINUS_X, STICKSLIP_PLUS_Y or
        ! STICKSLIP_MINUS_Y.
        integer(c_int32_t) :: leading_edge = 0
        ! Creepages along x and y: motion of body 2 over body 1 per unit length rolled (dimensionless). A positive creepage
        ! causes a positive force. Kalker and CONTACT define creepage and spin with the opposite sign.
        real(c_double) :: creepage(2) = 0
        ! Spin: rotation of body 2 relative to body 1 about the origin of the grid per unit length rolled (one over a length,
        ! positive from x to y); only for the vector model.
        real(c_double) :: spin = 0
    end type stickslip_roll

    ! Step of a history: the load prescribed at its end. A step whose members are all zero holds pressure, shift, twist and
    ! relative displacement. A nonzero number without effect, such as a twist without has_twist, returns
    ! STICKSLIP_INVALID_ARGUMENT.
    !
    ! A held shift does not hold the tangential force, which decreases if a lower pressure or less friction cannot carry it.
    ! To keep the force constant, prescribe it in every step. If pressure and traction are coupled, a step without a normal
    ! load holds the normal force instead of the pressure. After a change of the gap, prescribe the normal load in every
    ! step; otherwise the pressure of the old gap is held.
    type, bind(c), public :: stickslip_load_step
        ! Normal load.
        type(stickslip_normal_load) :: normal
        ! Tangential load along x.
        type(stickslip_control) :: x
        ! Tangential load along y.
        type(stickslip_control) :: y
        ! Nonzero to prescribe the twist; zero holds it.
        integer(c_int32_t) :: has_twist = 0
        ! Rotation of body 2 relative to body 1 since the start (radians, from x to y); zero without has_twist.
        real(c_double) :: twist = 0
        ! Nonzero to prescribe the amount of the relative displacement; zero holds it.
        integer(c_int32_t) :: has_relative_displacement = 0
        ! Amount of the relative displacement, as a multiple of the pattern of the history; zero without
        ! has_relative_displacement.
        real(c_double) :: relative_displacement = 0
        ! Rolling of the bodies; all zero if they do not roll.
        type(stickslip_roll) :: roll
        ! Reserved for future members: zero.
        integer(c_int64_t) :: reserved(4) = 0
    end type stickslip_load_step

    ! Work, elastic energy and dissipation of a step or a cycle.
    type, bind(c), public :: stickslip_energy
        ! Work of the tangential load: mean force times change of the shift, plus mean moment times change of the twist.
        ! Cells that come into contact contribute only the part of the motion that they follow. The work of a changing
        ! relative displacement is included, and so is the work of the normal load if pressure and traction are coupled.
        real(c_double) :: work = 0
        ! Elastic energy of shear before the step or the cycle; energy of pressure and traction if both are coupled.
        real(c_double) :: elastic_before = 0
        ! Elastic energy of shear after the step or the cycle; energy of pressure and traction if both are coupled.
        real(c_double) :: elastic_after = 0
        ! Dissipated energy, computed from the tractions at the ends of steps; not negative. If pressure and friction do not
        ! change and the load does not turn within a step, this value is exact for any length of the step.
        real(c_double) :: dissipated_energy = 0
        ! Dissipated energy, computed from the mean of the tractions before and after each step. This value closes the
        ! energy balance. It is not negative if pressure and friction do not change.
        real(c_double) :: dissipated_energy_midpoint = 0
        ! Energy released by the tractions of cells that leave the contact.
        real(c_double) :: released = 0
        ! Work on the residual motion that the tolerance permits in stick cells.
        real(c_double) :: residual = 0
        ! Imbalance of the energies, which is due to round-off.
        real(c_double) :: imbalance = 0
        ! Reserved for future members: zero.
        integer(c_int64_t) :: reserved(8) = 0
    end type stickslip_energy

    ! Scalar results of a history. The members that describe the last step are NaN if the history has none, that is, if
    ! has_last_step is zero.
    type, bind(c), public :: stickslip_step_result
        ! Normal force.
        real(c_double) :: normal_force = 0
        ! Approach of the bodies (a length).
        real(c_double) :: approach = 0
        ! Tangential force that body 2 exerts on body 1.
        real(c_double) :: force(2) = 0
        ! Shift since the start (lengths): the rigid motion of body 2 relative to body 1.
        real(c_double) :: shift(2) = 0
        ! Moment about z at the origin of the grid that the tractions exert on body 1 (a force times a length, positive from
        ! x to y).
        real(c_double) :: moment = 0
        ! Rotation of body 2 relative to body 1 since the start (radians).
        real(c_double) :: twist = 0
        ! Ratio of stick cells to contact cells after the last step; zero without contact, NaN without a last step.
        real(c_double) :: stick_ratio = 0
        ! Nonzero if the whole contact is at its friction limit after the last step; zero without a last step.
        integer(c_int32_t) :: is_gross_slip = 0
        ! Nonzero if a step led to the present state. Zero before the first step, and after stickslip_history_set_state and
        ! stickslip_history_from_bytes.
        integer(c_int32_t) :: has_last_step = 0
        ! Number of steps since the start.
        integer(c_int64_t) :: steps = 0
        ! Energies of the last step; NaN without a last step.
        type(stickslip_energy) :: energy
        ! Creepages along x and y of the last step, prescribed or caused by the force (dimensionless); zero if the bodies did
        ! not roll, NaN without a last step.
        real(c_double) :: creepage(2) = 0
        ! Reserved for future members: zero.
        integer(c_int64_t) :: reserved(6) = 0
    end type stickslip_step_result

    ! Observer of the accepted steps of a load: a function with data of the caller.
    type, bind(c), public :: stickslip_step_observer
        ! Function; NULL for no observer.
        type(c_funptr) :: observe = c_null_funptr
        ! Data passed unchanged to the function.
        type(c_ptr) :: user = c_null_ptr
    end type stickslip_step_observer

    ! Error of one load step: the difference between its result and the result of the same load in two half steps.
    type, bind(c), public :: stickslip_step_error
        ! Relative error of the traction, to which the tolerance applies.
        real(c_double) :: traction = 0
        ! Error of the tangential force.
        real(c_double) :: force(2) = 0
        ! Error of the shift (lengths).
        real(c_double) :: shift(2) = 0
        ! Error of the dissipated energy.
        real(c_double) :: dissipated_energy = 0
        ! Reserved for future members: zero.
        integer(c_int64_t) :: reserved(8) = 0
    end type stickslip_step_error

    ! Hertz solution for the frictionless contact of a sphere and a plane.
    type, bind(c), public :: stickslip_hertz
        ! Radius of the contact (a length): a = (3 W R/(4 E*))^(1/3), with the force W and the radius R of the sphere.
        real(c_double) :: contact_radius = 0
        ! Pressure at the centre: p0 = 3 W/(2 pi a^2). At the distance r from the centre, the pressure is p0 (1 -
        ! r^2/a^2)^(1/2).
        real(c_double) :: max_pressure = 0
        ! Approach of the bodies (a length): a^2/R.
        real(c_double) :: approach = 0
        ! Reserved for future members: zero.
        integer(c_int64_t) :: reserved(8) = 0
    end type stickslip_hertz

    ! Cattaneo-Mindlin solution for a sphere and a plane that are pressed together and then loaded tangentially.
    type, bind(c), public :: stickslip_cattaneo_mindlin
        ! Normal contact.
        type(stickslip_hertz) :: hertz
        ! Radius of the circular stick zone (a length): c = a (1 - |Q|/(mu W))^(1/3), with the tangential force Q; 0 without
        ! friction.
        real(c_double) :: stick_radius = 0
        ! Shift (a length), with the sign of the force: 3 mu W/(16 a G*) (1 - c^2/a^2), with G* of
        ! stickslip_pair.
        real(c_double) :: shift = 0
        ! Energy dissipated while the force grows from zero (a force times a length), zero or positive.
        real(c_double) :: dissipated_energy = 0
        ! Reserved for future members: zero.
        integer(c_int64_t) :: reserved(8) = 0
    end type stickslip_cattaneo_mindlin

    ! Carter solution for a cylinder that rolls steadily on a plane with longitudinal creepage, in plane strain.
    type, bind(c), public :: stickslip_carter
        ! Half-width of the contact (a length): a = (4 P R/(pi E*))^(1/2), with the force P per length and the radius R.
        real(c_double) :: half_width = 0
        ! Pressure at the centre: p0 = 2 P/(pi a).
        real(c_double) :: max_pressure = 0
        ! Smallest creepage at which the whole contact slips (dimensionless): 2 mu p0/E*.
        real(c_double) :: sliding_creepage = 0
        ! Half-width of the stick strip at the leading edge x = a (a length): c = a (1 - |creepage|/sliding_creepage).
        real(c_double) :: stick_half_width = 0
        ! Tangential force on body 1 (a force per length), with the sign of the creepage: mu P (1 - c^2/a^2).
        real(c_double) :: force = 0
        ! Reserved for future members: zero.
        integer(c_int64_t) :: reserved(8) = 0
    end type stickslip_carter

    ! Bentall-Johnson solution for cylinders of different materials that roll freely, in plane strain. The solution is the
    ! limit for a friction coefficient much smaller than the magnitude of Dundurs' beta. The leading edge is at the largest x;
    ! with the leading edge at the smallest x, the creepage has the opposite sign.
    type, bind(c), public :: stickslip_bentall_johnson
        ! Half-width of the contact (a length): a = (4 P R/(pi E*))^(1/2), with the force P per length and the radius R.
        real(c_double) :: half_width = 0
        ! Pressure at the centre: p0 = 2 P/(pi a).
        real(c_double) :: max_pressure = 0
        ! Creepage without a tangential force (dimensionless): 0.9148 beta a/R.
        real(c_double) :: creepage = 0
        ! Half-width of the middle strip (a length): 0.4040 a. The slip changes its sign at the ends of this strip.
        real(c_double) :: reversal = 0
        ! Energy dissipated by slip per unit length rolled (a force per length): 0.1239 mu |beta| P a/R.
        real(c_double) :: dissipation = 0
        ! Reserved for future members: zero.
        integer(c_int64_t) :: reserved(8) = 0
    end type stickslip_bentall_johnson

    ! Kalker's coefficients, which determine the forces and the moment of an elliptic contact that rolls along x. The
    ! creepages are so small that the contact sticks except at its trailing edge. Here a and b are the semi-axes along x
    ! and y, c = (a b)^(1/2), and G is the shear modulus of both bodies. The creepages xi along x and eta along y and the
    ! spin phi cause F_x = G c^2 c11 xi, F_y = G c^2 (c22 eta + c c23 phi) and the moment G c^3 (-c23 eta + c c33 phi) on
    ! body 1.
    type, bind(c), public :: stickslip_kalker
        ! Coefficient of the force along x due to the creepage along x.
        real(c_double) :: c11 = 0
        ! Coefficient of the force along y due to the creepage along y.
        real(c_double) :: c22 = 0
        ! Coefficient of the force along y due to the spin, and of the negated moment due to the creepage along y.
        real(c_double) :: c23 = 0
        ! Coefficient of the moment due to the spin.
        real(c_double) :: c33 = 0
        ! Reserved for future members: zero.
        integer(c_int64_t) :: reserved(8) = 0
    end type stickslip_kalker

    ! Vermeulen-Johnson solution for an elliptic contact that rolls along x with creepages and without spin. The solution
    ! has the initial slope of Kalker's theory, and its forces are a few per cent smaller than those of numerical
    ! solutions.
    type, bind(c), public :: stickslip_vermeulen_johnson
        ! Semi-axes of the contact along x and y (lengths).
        real(c_double) :: semi_axes(2) = 0
        ! Pressure at the centre.
        real(c_double) :: max_pressure = 0
        ! Kalker's coefficients of the contact.
        type(stickslip_kalker) :: coefficients
        ! Force that the creepages would cause without slip, divided by the friction limit (dimensionless). The whole
        ! contact slips if this ratio x is 3 or more.
        real(c_double) :: relative_creepage = 0
        ! Tangential force on body 1 along x and y: mu W (1 - (1 - x/3)^3) in the direction of the force without slip, with
        ! the normal force W.
        real(c_double) :: force(2) = 0
        ! Reserved for future members: zero.
        integer(c_int64_t) :: reserved(8) = 0
    end type stickslip_vermeulen_johnson

    ! Quantity with one value for all cells or a value for each cell.
    type, bind(c), public :: stickslip_per_cell
        ! Value of all cells; used if cells is NULL.
        real(c_double) :: value = 0
        ! Value of each cell, copied by the call, or NULL.
        type(c_ptr) :: cells = c_null_ptr
        ! Number of cells; zero if cells is NULL.
        integer(c_size_t) :: count = 0
    end type stickslip_per_cell

    ! Coulomb friction.
    type, bind(c), public :: stickslip_friction
        ! Coefficient of friction, zero or positive.
        type(stickslip_per_cell) :: coefficient
        ! Largest shear traction (a pressure); 0 or infinite if only the coefficient limits the traction.
        real(c_double) :: max_shear_stress = transfer(int(z'7FF0000000000000', c_int64_t), 0.0_c_double)
        ! Reserved for future members: zero.
        integer(c_int64_t) :: reserved(8) = 0
    end type stickslip_friction

    ! Tangential load from rest.
    type, bind(c), public :: stickslip_tangential_load
        ! Load along x.
        type(stickslip_control) :: x
        ! Load along y.
        type(stickslip_control) :: y
        ! Rotation of body 2 relative to body 1 about the origin of the grid (radians, from x to y); only for the vector
        ! model.
        real(c_double) :: twist = 0
        ! Reserved for future members: zero.
        integer(c_int64_t) :: reserved(8) = 0
    end type stickslip_tangential_load

    ! Tangential displacement of body 1 relative to body 2 that the contact does not cause, for example bulk strain. The
    ! call copies the values of the cells.
    type, bind(c), public :: stickslip_relative_displacement
        ! Displacement along x of each cell (lengths).
        type(c_ptr) :: x = c_null_ptr
        ! Displacement along y of each cell (lengths).
        type(c_ptr) :: y = c_null_ptr
        ! Number of cells.
        integer(c_size_t) :: count = 0
    end type stickslip_relative_displacement

    ! Method, tolerance and limits of a solve; stickslip_settings_default() returns the defaults.
    type, bind(c), public :: stickslip_settings
        ! Method: STICKSLIP_ACTIVE_SET (default) or STICKSLIP_POLONSKY_KEER.
        integer(c_int32_t) :: method = 0
        ! Largest accepted error, in (0, 1) (default 1e-8). It limits the certified error in the energy norm, and the residual
        ! relative to the largest displacement.
        real(c_double) :: tolerance = 1e-8_c_double
        ! Largest number of conjugate-gradient iterations (default 10000).
        integer(c_size_t) :: max_iterations = 10000
        ! Largest wall time of a solve (seconds); infinite (default) for no limit. A step of a history has two solves, one for
        ! the pressure and one for the traction.
        real(c_double) :: time_limit = transfer(int(z'7FF0000000000000', c_int64_t), 0.0_c_double)
        ! Reserved for future members: zero.
        integer(c_int64_t) :: reserved(8) = 0
    end type stickslip_settings

    ! Progress of an iteration.
    type, bind(c), public :: stickslip_iteration
        ! Number of conjugate-gradient iterations so far.
        integer(c_size_t) :: iteration = 0
        ! Number of products in double precision so far.
        integer(c_size_t) :: double_precision_products = 0
        ! Number of products in single precision so far.
        integer(c_size_t) :: single_precision_products = 0
        ! Last measured value of the largest complementarity residual, relative to the largest displacement.
        real(c_double) :: residual = 0
        ! Number of contact cells of a normal problem, or of stick cells of a tangential problem.
        integer(c_size_t) :: free = 0
        ! Reserved for future members: zero.
        integer(c_int64_t) :: reserved(8) = 0
    end type stickslip_iteration

    ! Observer of a solve: a function with data of the caller.
    type, bind(c), public :: stickslip_observer
        ! Function; NULL for no observer.
        type(c_funptr) :: observe = c_null_funptr
        ! Data passed unchanged to the function.
        type(c_ptr) :: user = c_null_ptr
    end type stickslip_observer

    ! Scalar results of a normal contact.
    type, bind(c), public :: stickslip_normal_result
        ! Approach of the bodies from the datum of the gap (a length).
        real(c_double) :: approach = 0
        ! Normal force.
        real(c_double) :: force = 0
        ! Total area of the contact cells.
        real(c_double) :: contact_area = 0
        ! Contact area corrected for the staircase shape of its perimeter.
        real(c_double) :: contact_area_corrected = 0
        ! Ratio of force to contact area; zero without contact.
        real(c_double) :: mean_pressure = 0
        ! Moments of the pressure about x and y at the origin of the grid (forces times lengths).
        real(c_double) :: moments(2) = 0
        ! Centre of pressure (lengths); NaN without contact.
        real(c_double) :: centre_of_pressure(2) = 0
        ! Number of contact cells.
        integer(c_size_t) :: contact_cells = 0
        ! Number of cells whose pressure equals their hardness.
        integer(c_size_t) :: yielded_cells = 0
        ! Reserved for future members: zero.
        integer(c_int64_t) :: reserved(8) = 0
    end type stickslip_normal_result

    ! Scalar results of a tangential contact.
    type, bind(c), public :: stickslip_tangential_result
        ! Shift (lengths): the rigid motion of body 2 relative to body 1 far from the contact, with the sign of the force.
        real(c_double) :: shift(2) = 0
        ! Tangential force that body 2 exerts on body 1.
        real(c_double) :: force(2) = 0
        ! Rotation of body 2 relative to body 1 (radians).
        real(c_double) :: twist = 0
        ! Moment about z at the origin of the grid that the tractions exert on body 1 (a force times a length, positive from
        ! x to y).
        real(c_double) :: moment = 0
        ! Ratio of stick cells to contact cells.
        real(c_double) :: stick_ratio = 0
        ! Area of the stick zone.
        real(c_double) :: stick_area = 0
        ! Area of the slip zone.
        real(c_double) :: slip_area = 0
        ! Energy dissipated by slip (a force times a length).
        real(c_double) :: dissipated_energy = 0
        ! Nonzero if the whole contact is at its friction limit.
        integer(c_int32_t) :: is_gross_slip = 0
        ! Reserved for future members: zero.
        integer(c_int64_t) :: reserved(8) = 0
    end type stickslip_tangential_result

    ! Status, cost and error bounds of a solve.
    type, bind(c), public :: stickslip_report
        ! STICKSLIP_CONVERGED, the reason why the solve did not converge, or STICKSLIP_UNSOLVED.
        integer(c_int32_t) :: status = 0
        ! Origin of the eigenvalue bound behind duality_gap and all other certified errors: STICKSLIP_EIGENVALUE_PROVEN,
        ! STICKSLIP_EIGENVALUE_STATED, STICKSLIP_EIGENVALUE_ESTIMATED or STICKSLIP_EIGENVALUE_UNKNOWN.
        integer(c_int32_t) :: eigenvalue_bound = 0
        ! Number of conjugate-gradient iterations.
        integer(c_size_t) :: iterations = 0
        ! Number of products with the operator in double precision.
        integer(c_size_t) :: double_precision_products = 0
        ! Number of products with the operator in single precision.
        integer(c_size_t) :: single_precision_products = 0
        ! Largest complementarity residual, relative to the largest displacement.
        real(c_double) :: residual = 0
        ! Certified bound on the squared relative error in the energy norm.
        real(c_double) :: duality_gap = 0
        ! Certified bound on the relative error in the energy norm, the square root of duality_gap. On a periodic grid under
        ! a prescribed approach or shift, the bound excludes the error of the computed force.
        real(c_double) :: energy_error_bound = 0
        ! Relative error of the prescribed total force.
        real(c_double) :: load_error = 0
        ! Wall time of the solve (seconds).
        real(c_double) :: seconds = 0
        ! Reserved for future members: zero.
        integer(c_int64_t) :: reserved(8) = 0
    end type stickslip_report

    ! Report of a coupled solve. The total errors of pressure and traction have bounds if friction is weak; otherwise only
    ! the error of the pressure for the computed tractions, and the error of the tractions for the computed pressure, are
    ! certified.
    type, bind(c), public :: stickslip_coupled_report
        ! Report of the whole solve; its duality gap is infinite.
        type(stickslip_report) :: work
        ! Bound on the error of the pressure in the energy norm, for the tractions of the solution.
        real(c_double) :: pressure_error_bound = 0
        ! Bound on the error of the tractions, for the pressure of the solution.
        real(c_double) :: traction_error_bound = 0
        ! Bounds on the total errors of pressure and traction; NaN if no bounds exist.
        real(c_double) :: error_bounds(2) = 0
        ! Estimates of the total errors of pressure and traction; NaN if no estimates exist.
        real(c_double) :: error_estimate(2) = 0
        ! Reserved for future members: zero.
        integer(c_int64_t) :: reserved(8) = 0
    end type stickslip_coupled_report

    ! Warning about a converged solution that may be misleading.
    type, bind(c), public :: stickslip_warning
        ! Kind of warning: STICKSLIP_WARNING_NO_CONTACT or another constant of this group.
        integer(c_int32_t) :: kind = 0
        ! Number of cells or spots concerned; zero if the warning has no such number.
        integer(c_size_t) :: cells = 0
        ! Total number of spots; zero if the warning has no such number.
        integer(c_size_t) :: of = 0
        ! Meaning of the warning and suggested remedy, in English; ends with a zero byte.
        character(kind=c_char) :: message(STICKSLIP_WARNING_LENGTH) = c_null_char
        ! Reserved for future members: zero.
        integer(c_int64_t) :: reserved(8) = 0
    end type stickslip_warning

    ! Derivative of the normal force with respect to the approach.
    type, bind(c), public :: stickslip_normal_stiffness
        ! Stiffness (a force over a length); zero without contact. The set of contact cells is fixed. On a sphere the
        ! stiffness is 2 E* a (Hertz).
        real(c_double) :: value = 0
        ! Bound on the relative error of the linear solve; infinite if pressure and traction are coupled. It excludes the
        ! effect of errors of the pressure.
        real(c_double) :: bound = 0
        ! Reserved for future members: zero.
        integer(c_int64_t) :: reserved(8) = 0
    end type stickslip_normal_stiffness

    ! Derivatives of the forces along x and y and of the moment with respect to the shifts along x and y and the twist. The
    ! sets of stick and slip cells are fixed, and the pressure is constant unless it is coupled. Rows are loads, and columns
    ! are motions. In C, the order of the indices is loading[row][column]. The first two rows and columns are forces over
    ! lengths; the last diagonal entry is a moment over radians, and the other entries are forces over radians. Loads and
    ! motions that are not part of the model are NaN. These are the direction across the axis and the twist in the scalar
    ! model, and the twist on periodic grids.
    type, bind(c), public :: stickslip_tangential_stiffness
        ! Derivative with respect to the motion at the end of the step, if the motion continues in its direction. Stick
        ! cells follow the motion, and slip cells stay at their friction limit. In the vector model the traction of slip
        ! cells turns with the slip. On a ball under a constant normal load, the derivative is 8 G* a (1 - F/(mu W))^(1/3)
        ! (Cattaneo and Mindlin).
        !
        ! Cells that came into contact in the step follow the motion only partially. After a step that presses a ball from
        ! zero load, the derivative is about two thirds of Mindlin's stiffness 8 G* a, although all cells stick.
        ! stickslip_history_next_stiffness computes the derivative for the next step, in which these cells resist fully.
        real(c_double) :: loading(3, 3) = 0
        ! Derivative for a reversal of the motion, at which all contact cells stick. For a circular contact it is Mindlin's
        ! stiffness 8 G* a.
        real(c_double) :: reversal(3, 3) = 0
        ! Bound on the errors: the error of an entry is at most bound times the square root of the product of the diagonal
        ! entries of its row and its column, for the twist about the centre of the contact. The bound is infinite if
        ! pressure and traction are coupled. It excludes the effect of errors of pressure and traction.
        real(c_double) :: bound = 0
        ! Reserved for future members: zero.
        integer(c_int64_t) :: reserved(8) = 0
    end type stickslip_tangential_stiffness

    ! Tangent stiffness of a contact.
    type, bind(c), public :: stickslip_stiffness
        ! Derivative of the normal force with respect to the approach.
        type(stickslip_normal_stiffness) :: normal
        ! Derivatives of the tangential forces and the moment with respect to shift and twist.
        type(stickslip_tangential_stiffness) :: tangential
        ! Derivatives of the tangential forces (forces over lengths) and the moment (a force) with respect to the approach
        ! while slip continues: the friction limit of slip cells follows the pressure. They are valid if the shift grows in
        ! the same step, or if the approach decreases. If the bodies are pressed further at a constant shift, the slip cells
        ! stick and the derivatives are zero. The derivatives have no error bound. NaN for loads that are not part of the
        ! model.
        real(c_double) :: by_approach(3) = 0
        ! Derivatives of the normal force with respect to the shifts along x and y (forces over lengths) and the twist (a
        ! force). They are zero unless pressure and traction are coupled, and NaN for motions that are not part of the
        ! model.
        real(c_double) :: normal_by_motion(3) = 0
        ! Reserved for future members: zero.
        integer(c_int64_t) :: reserved(5) = 0
    end type stickslip_stiffness

    ! Prescribed load of rolling bodies along an axis, or of their rotation.
    type, bind(c), public :: stickslip_rolling_control
        ! Kind of load: STICKSLIP_CREEPAGE or STICKSLIP_FORCE along an axis, STICKSLIP_SPIN or STICKSLIP_MOMENT for the
        ! rotation. Zero with the value zero means no creepage or no spin.
        integer(c_int32_t) :: kind = 0
        ! Value along an axis: the creepage, or the force that body 2 exerts on body 1, which must be less than friction can
        ! carry. Value for the rotation: the spin or the moment.
        real(c_double) :: value = 0
    end type stickslip_rolling_control

    ! Prescribed loads of rolling bodies. A load whose members are all zero has no creepage and no spin.
    type, bind(c), public :: stickslip_rolling_load
        ! Load along x.
        type(stickslip_rolling_control) :: x
        ! Load along y.
        type(stickslip_rolling_control) :: y
        ! Spin or moment.
        type(stickslip_rolling_control) :: spin
        ! Reserved for future members: zero.
        integer(c_int64_t) :: reserved(8) = 0
    end type stickslip_rolling_load

    ! Options of a rolling solver; stickslip_rolling_options_default() returns the defaults.
    type, bind(c), public :: stickslip_rolling_options
        ! Leading edge: STICKSLIP_PLUS_X (default), STICKSLIP_MINUS_X, STICKSLIP_PLUS_Y or STICKSLIP_MINUS_Y.
        integer(c_int32_t) :: leading_edge = 0
        ! Entry rule of cells that come into contact: STICKSLIP_SINCE_TOUCH (default) or STICKSLIP_WHOLE_STEP.
        integer(c_int32_t) :: entry_rule = 0
        ! Number of cells that a particle passes in a step (default 1). Longer steps cost less and are less accurate.
        integer(c_size_t) :: step = 1
        ! Number of corrections of the direction of slip (default 0). Two corrections raise the order of convergence of the
        ! forces under spin from 1 to between 1.5 and 2.
        integer(c_size_t) :: slip_corrections = 0
        ! Method, tolerance and limits of the solves.
        type(stickslip_settings) :: settings
        ! Reserved for future members: zero.
        integer(c_int64_t) :: reserved(7) = 0
    end type stickslip_rolling_options

    ! Derivatives of the forces and the moment with respect to the creepages and the spin.
    type, bind(c), public :: stickslip_rolling_stiffness
        ! Derivatives of the forces along x and y and of the moment (rows) with respect to the creepages along x and y and the
        ! spin (columns). In C, the order of the indices is slopes[row][column]. The entries are forces. Entries for the spin
        ! have an additional factor of a length, and so do entries for the moment.
        real(c_double) :: slopes(3, 3) = 0
        ! Reserved for future members: zero.
        integer(c_int64_t) :: reserved(8) = 0
    end type stickslip_rolling_stiffness

    ! Scalar results of a rolling contact.
    type, bind(c), public :: stickslip_rolling_result
        ! Creepages along x and y, prescribed or caused by the forces (dimensionless).
        real(c_double) :: creepage(2) = 0
        ! Spin, prescribed or caused by the moment (one over a length).
        real(c_double) :: spin = 0
        ! Tangential force that body 2 exerts on body 1.
        real(c_double) :: force(2) = 0
        ! Moment about z at the origin of the grid that the tractions exert on body 1 (a force times a length).
        real(c_double) :: moment = 0
        ! Work of creepages and spin per unit length rolled (a force). Between bodies of the same material all work is
        ! dissipated. Between different materials the pressure also does work, which is not included.
        real(c_double) :: work = 0
        ! Ratio of stick cells to contact cells.
        real(c_double) :: stick_ratio = 0
        ! Reserved for future members: zero.
        integer(c_int64_t) :: reserved(8) = 0
    end type stickslip_rolling_result

    ! Report of a coupled rolling solve: status, cost, passes and certified errors.
    type, bind(c), public :: stickslip_coupled_rolling_report
        ! Report of all passes together; its duality gap is infinite for coupled bodies.
        type(stickslip_report) :: work
        ! Number of passes: solves of the pressure, each followed by a solve of the tractions.
        integer(c_size_t) :: passes = 0
        ! Residual of the coupling: the lift within the contact that the last pass added, relative to the largest normal
        ! displacement.
        real(c_double) :: coupling_residual = 0
        ! Change of the pressure in the last pass relative to the pressure (root mean squares).
        real(c_double) :: pressure_change = 0
        ! Bound on the relative error of the pressure in the energy norm, for the tractions of the solution.
        real(c_double) :: pressure_error_bound = 0
        ! Bound on the relative error of the tractions, for the pressure of the solution.
        real(c_double) :: traction_error_bound = 0
        ! Estimate of the total relative error of the pressure; NaN if no estimate exists.
        real(c_double) :: error_estimate = 0
        ! Reserved for future members: zero.
        integer(c_int64_t) :: reserved(8) = 0
    end type stickslip_coupled_rolling_report

    ! Creepages and spin: a point of a creep curve or a creep surface.
    type, bind(c), public :: stickslip_creep_point
        ! Creepages along x and y (dimensionless).
        real(c_double) :: creepage(2) = 0
        ! Spin (one over a length).
        real(c_double) :: spin = 0
    end type stickslip_creep_point

    ! Loads due to creepages and spin.
    type, bind(c), public :: stickslip_creep_force
        ! Tangential force on body 1 along x and y.
        real(c_double) :: force(2) = 0
        ! Moment on body 1 about the origin of the grid (a force times a length).
        real(c_double) :: moment = 0
        ! Ratio of stick cells to contact cells.
        real(c_double) :: stick_ratio = 0
    end type stickslip_creep_force

    ! Scalar results of a cycle.
    type, bind(c), public :: stickslip_cycle_result
        ! Number of steps since the start of the cycle.
        integer(c_size_t) :: steps = 0
        ! Regime: STICKSLIP_FULL_STICK, STICKSLIP_PARTIAL_SLIP or STICKSLIP_GROSS_SLIP.
        integer(c_int32_t) :: regime = 0
        ! Ratio of the dissipated energy to the area of the rectangle around the loop of force and shift.
        real(c_double) :: energy_ratio = 0
        ! Difference between the tractions at the end and at the start of the cycle, relative to the largest traction; zero if
        ! the loop closes.
        real(c_double) :: cyclic_residual = 0
        ! Amplitude of the tangential force.
        real(c_double) :: force_amplitude(2) = 0
        ! Amplitude of the shift (lengths).
        real(c_double) :: shift_amplitude(2) = 0
        ! Smallest and largest stick ratio at the end of a step.
        real(c_double) :: stick_ratios(2) = 0
        ! Energies of all steps of the cycle.
        type(stickslip_energy) :: energy
        ! Reserved for future members: zero.
        integer(c_int64_t) :: reserved(8) = 0
    end type stickslip_cycle_result

    ! Edges of a contact and of its stick zone, located inside the cells. The members for the stick zone and the traction are
    ! NaN for a contact without a tangential load.
    type, bind(c), public :: stickslip_edges
        ! Area of the contact, including the covered parts of the edge cells (a length squared).
        real(c_double) :: contact_area = 0
        ! Fraction of the cells at the edge of the contact whose fit was rejected. Such a cell contributes a mean fraction of
        ! its area and keeps its own pressure.
        real(c_double) :: unfitted_fraction = 0
        ! Largest pressure at the centre of a cell (a pressure).
        real(c_double) :: peak_pressure = 0
        ! Area of the stick zone (a length squared).
        real(c_double) :: stick_area = 0
        ! Area of the slip zone (a length squared).
        real(c_double) :: slip_area = 0
        ! Ratio of stick area to contact area; zero without contact.
        real(c_double) :: stick_ratio = 0
        ! Fraction of the cells at the edge of the stick zone whose fit was rejected.
        real(c_double) :: stick_unfitted_fraction = 0
        ! Largest magnitude of the traction at the centre of a cell (a pressure).
        real(c_double) :: peak_traction = 0
        ! Reserved for future members: zero.
        integer(c_int64_t) :: reserved(8) = 0
    end type stickslip_edges

    ! Numbers that describe the last failure on this thread; members without a meaning for the failure are zero.
    type, bind(c), public :: stickslip_error
        ! Return value of the function; STICKSLIP_OK before any failure.
        integer(c_int32_t) :: code = 0
        ! Invalid value.
        real(c_double) :: value = 0
        ! Limit that the value violates.
        real(c_double) :: limit = 0
        ! Index of the invalid sample, or position in a batch.
        integer(c_size_t) :: index = 0
        ! Number of entries required.
        integer(c_size_t) :: expected = 0
        ! Number of entries supplied.
        integer(c_size_t) :: found = 0
        ! Reserved for future members: zero.
        integer(c_int64_t) :: reserved(4) = 0
    end type stickslip_error

    ! Grid of nx by ny rectangular cells of sides dx and dy (lengths), centred on the origin. An array of samples has nx * ny
    ! entries, row by row with x fastest; the sample of cell (ix, iy) is at iy * nx + ix.
    type, bind(c), public :: stickslip_grid
        ! Number of cells along x.
        integer(c_size_t) :: nx = 0
        ! Number of cells along y.
        integer(c_size_t) :: ny = 0
        ! Side of a cell along x (a length).
        real(c_double) :: dx = 0
        ! Side of a cell along y (a length).
        real(c_double) :: dy = 0
    end type stickslip_grid

    ! Material of a body.
    type, bind(c), public :: stickslip_material
        ! Young's modulus (a pressure); infinite for a rigid body.
        real(c_double) :: youngs_modulus = 0
        ! Poisson's ratio, in (-1, 1/2]; without meaning for a rigid body.
        real(c_double) :: poisson_ratio = 0
        ! Indentation hardness (a pressure), used only for warnings; 0 or infinite if unknown.
        real(c_double) :: hardness = 0
    end type stickslip_material

    ! Boundary condition at the edge of the grid.
    type, bind(c), public :: stickslip_boundary
        ! Kind of boundary: STICKSLIP_NON_PERIODIC, STICKSLIP_PERIODIC or STICKSLIP_PERIODIC_ALONG_Y.
        integer(c_int32_t) :: kind = 0
        ! Distance along x at which a line load causes no displacement (a length); zero for all kinds except
        ! STICKSLIP_PERIODIC_ALONG_Y.
        real(c_double) :: datum = 0
    end type stickslip_boundary

    ! Elastic layer bonded to the layer or body below it.
    type, bind(c), public :: stickslip_layer
        ! Young's modulus (a pressure).
        real(c_double) :: youngs_modulus = 0
        ! Poisson's ratio, in (-1, 1/2].
        real(c_double) :: poisson_ratio = 0
        ! Thickness (a length).
        real(c_double) :: thickness = 0
    end type stickslip_layer

    ! Rank: one of several processes that solve together. stickslip_mpi.h creates this struct from an MPI communicator.
    ! The function and the data must remain valid until all objects created from the bodies are freed.
    type, bind(c), public :: stickslip_ranks
        ! Number of this rank, counted from zero.
        integer(c_size_t) :: rank = 0
        ! Number of ranks.
        integer(c_size_t) :: size = 0
        ! Function that exchanges blocks with other ranks; not called if there is only one rank.
        type(c_funptr) :: swap = c_null_funptr
        ! Data passed unchanged to the function.
        type(c_ptr) :: user = c_null_ptr
    end type stickslip_ranks

    ! Constants of a pair of materials.
    type, bind(c), public :: stickslip_pair
        ! Contact modulus E* (a pressure): 1/E* = (1 - nu_1^2)/E_1 + (1 - nu_2^2)/E_2.
        real(c_double) :: contact_modulus = 0
        ! Mindlin's tangential modulus G* (a pressure): 1/G* = (2 - nu_1)/G_1 + (2 - nu_2)/G_2. The tangential stiffness of a
        ! circular stick contact of radius a is 8 G* a.
        real(c_double) :: tangential_modulus = 0
        ! Dundurs' second parameter beta; zero if pressure and traction are not coupled: beta = ((1 - 2 nu_1)/G_1 - (1 - 2
        ! nu_2)/G_2) / (2 ((1 - nu_1)/G_1 + (1 - nu_2)/G_2)). It is positive if body 1 has the larger value of (1 - 2 nu)/G,
        ! and an exchange of the bodies reverses its sign.
        real(c_double) :: dundurs_beta = 0
        ! Nonzero if pressure and traction are coupled.
        integer(c_int32_t) :: is_coupled = 0
        ! Reserved for future members: zero.
        integer(c_int64_t) :: reserved(8) = 0
    end type stickslip_pair

    ! Options of a history; stickslip_history_options_default() returns the defaults.
    type, bind(c), public :: stickslip_history_options
        ! Axis of load and traction in the scalar model: STICKSLIP_X (default) or STICKSLIP_Y.
        integer(c_int32_t) :: axis = 0
        ! Model of the traction: STICKSLIP_SCALAR (default) or STICKSLIP_VECTOR.
        integer(c_int32_t) :: model = 0
        ! Coupling of pressure and traction: STICKSLIP_FULL (default), STICKSLIP_ONE_WAY or STICKSLIP_NEGLECTED; relevant only
        ! for dissimilar bodies.
        integer(c_int32_t) :: coupling = 0
        ! Entry rule: STICKSLIP_SINCE_TOUCH (default) or STICKSLIP_WHOLE_STEP.
        integer(c_int32_t) :: entry_rule = 0
        ! Largest pressure that the cells can carry, or NULL (default, no limit).
        type(c_ptr) :: hardness = c_null_ptr
        ! Nonzero if yielding leaves a permanent set (default 0); zero without a hardness.
        integer(c_int32_t) :: permanent_set = 0
        ! Pattern of a displacement that the contact does not cause, or NULL (default). Each step prescribes a multiple of the
        ! pattern.
        type(c_ptr) :: relative_displacement = c_null_ptr
        ! Method, tolerance and limits of the solves.
        type(stickslip_settings) :: settings
        ! Reserved for future members: zero.
        integer(c_int64_t) :: reserved(8) = 0
    end type stickslip_history_options

    ! Limits of a jump in addition to the stability limit of the pressure. Start from stickslip_jump_limits_default(), which
    ! returns the defaults: a struct of zeros permits no depth, no cycles and no residual.
    type, bind(c), public :: stickslip_jump_limits
        ! Largest depth removed in one jump (a length); infinite (default) for no limit. A hundredth of the approach preserves
        ! the shape of a ball.
        real(c_double) :: largest_depth = transfer(int(z'7FF0000000000000', c_int64_t), 0.0_c_double)
        ! Number of cycles left to simulate; infinite (default) for no limit.
        real(c_double) :: cycles_left = transfer(int(z'7FF0000000000000', c_int64_t), 0.0_c_double)
        ! Largest cyclic_residual of a cycle that may represent the following cycles (default 0.25).
        real(c_double) :: max_residual = 0.25_c_double
        ! Reserved for future members: zero.
        integer(c_int64_t) :: reserved(8) = 0
    end type stickslip_jump_limits

    ! Tractions on the surface: fields of a solution or a history, or other arrays. The caller must ensure that all fields
    ! belong to the same bodies.
    type, bind(c), public :: stickslip_tractions
        ! Pressure of each cell, positive in compression.
        type(c_ptr) :: pressure = c_null_ptr
        ! Traction along x on body 1 (pressures). Without shear, this pointer and the pointer to the traction along y are
        ! NULL.
        type(c_ptr) :: x = c_null_ptr
        ! Traction along y on body 1.
        type(c_ptr) :: y = c_null_ptr
        ! Number of cells.
        integer(c_size_t) :: count = 0
    end type stickslip_tractions

    ! Random surface with a self-affine power spectrum; stickslip_self_affine_default() returns the defaults. Wavelengths are
    ! lengths. The spectrum is constant from the longest wavelength to the roll-off. From there to the cut-off it decreases
    ! with the wave number q as q^(-2 - 2 H).
    type, bind(c), public :: stickslip_self_affine
        ! Root-mean-square height (a length); 0 if the slope is prescribed.
        real(c_double) :: rms_height = 0
        ! Root-mean-square slope; 0 if the height is prescribed.
        real(c_double) :: rms_slope = 0
        ! Hurst exponent H, in [0, 1] (default 0.8).
        real(c_double) :: hurst = 0.8_c_double
        ! Longest wavelength, at which the spectrum starts; 0 (default) for the longer side of the grid.
        real(c_double) :: longest_wavelength = 0
        ! Roll-off wavelength, at which the spectrum starts to decrease; 0 (default) for the longest wavelength.
        real(c_double) :: roll_off_wavelength = 0
        ! Cut-off wavelength, at which the spectrum ends, at least two cells; 0 (default) for eight times the longer side of a
        ! cell.
        real(c_double) :: cut_off_wavelength = 0
        ! Amplitudes of the waves: STICKSLIP_EXACT (default) or STICKSLIP_GAUSSIAN.
        integer(c_int32_t) :: amplitudes = 0
        ! Nonzero to crop the middle of a larger surface, which is not periodic; zero (default) for a surface that is periodic
        ! along x and y.
        integer(c_int32_t) :: cropped = 0
        ! Skewness of the heights; NaN (default) for the value that results from the phases, or for 0 if a kurtosis is given.
        real(c_double) :: skewness = transfer(int(z'7FF8000000000000', c_int64_t), 0.0_c_double)
        ! Kurtosis of the heights; NaN (default) for the value that results from the phases, or for 3 if a skewness is given.
        real(c_double) :: kurtosis = transfer(int(z'7FF8000000000000', c_int64_t), 0.0_c_double)
        ! Seed of the random numbers (default 0); different seeds give different surfaces.
        integer(c_int64_t) :: seed = 0
        ! Reserved for future members: zero.
        integer(c_int64_t) :: reserved(8) = 0
    end type stickslip_self_affine

    ! Statistics of heights about their mean, according to ISO 25178-2.
    type, bind(c), public :: stickslip_statistics
        ! Mean height (a length), the reference of all other heights.
        real(c_double) :: mean_height = 0
        ! Arithmetic mean height Sa (a length).
        real(c_double) :: arithmetic_mean_height = 0
        ! Root-mean-square height Sq (a length).
        real(c_double) :: rms_height = 0
        ! Skewness Ssk; NaN for a flat surface.
        real(c_double) :: skewness = 0
        ! Kurtosis Sku, 3 for a Gaussian surface; NaN for a flat surface.
        real(c_double) :: kurtosis = 0
        ! Height of the highest peak Sp (a length).
        real(c_double) :: highest_peak = 0
        ! Depth of the deepest valley Sv (a length, positive).
        real(c_double) :: deepest_valley = 0
        ! Root-mean-square slope Sdq from finite differences, without differences across the edge.
        real(c_double) :: finite_difference_rms_slope = 0
        ! Root-mean-square slope from the waves of the periodically continued surface.
        real(c_double) :: spectral_rms_slope = 0
        ! Developed area ratio Sdr: excess of the surface area over its projection, relative to the projection.
        real(c_double) :: developed_area_ratio = 0
        ! Reserved for future members: zero.
        integer(c_int64_t) :: reserved(8) = 0
    end type stickslip_statistics

    ! Contact spot: contact cells connected through their sides, also across the edges of a periodic grid.
    type, bind(c), public :: stickslip_spot
        ! Number of cells.
        integer(c_size_t) :: cells = 0
        ! Total area of the cells (a length squared).
        real(c_double) :: area = 0
        ! Normal force on the spot.
        real(c_double) :: load = 0
        ! Ratio of load to area (a pressure).
        real(c_double) :: mean_pressure = 0
        ! Largest pressure of a cell (a pressure).
        real(c_double) :: max_pressure = 0
        ! Centroid of the area (lengths), inside the grid; without meaning for a spot that spans the whole period.
        real(c_double) :: centroid(2) = 0
        ! Length of the edge along the sides of the cells (a length). For a round spot, this length exceeds the perimeter of
        ! the circle by a factor of 4/pi.
        real(c_double) :: perimeter = 0
        ! Ratio of stick cells to all cells of the spot; NaN for a contact without a tangential load.
        real(c_double) :: stick_ratio = 0
        ! Reserved for future members: zero.
        integer(c_int64_t) :: reserved(8) = 0
    end type stickslip_spot

    ! Options of a stiffness; stickslip_stiffness_options_default() returns the defaults.
    type, bind(c), public :: stickslip_stiffness_options
        ! Relative residual at which the linear problems count as solved, between 0 and 1 (default 1e-11). The error of a
        ! stiffness is of the order of the square of this residual.
        real(c_double) :: tolerance = 1e-11_c_double
        ! Nonzero (default 1) to compute the stiffness at reversal. Zero halves the cost, and the entries at reversal are NaN.
        integer(c_int32_t) :: reversal = 1
        ! Nonzero for the stiffness of the next step, like stickslip_history_next_stiffness; zero (default) for the last step.
        integer(c_int32_t) :: next_step = 0
        ! Reserved for future members: zero.
        integer(c_int64_t) :: reserved(8) = 0
    end type stickslip_stiffness_options

    ! Point in a body.
    type, bind(c), public :: stickslip_point
        ! Position along x in the coordinates of the grid (a length).
        real(c_double) :: x = 0
        ! Position along y (a length).
        real(c_double) :: y = 0
        ! Depth below the surface of the body (a length), zero or positive in both bodies.
        real(c_double) :: depth = 0
    end type stickslip_point

    ! Displacement and stress at a point, with components along x, y and z; z points into body 1.
    type, bind(c), public :: stickslip_response
        ! Displacement of the body itself along x, y and z (lengths), not relative to the other body; zero at infinity.
        real(c_double) :: displacement(3) = 0
        ! Stresses xx, yy and zz (pressures, positive in tension).
        real(c_double) :: normal_stress(3) = 0
        ! Stresses xy, xz and yz (pressures).
        real(c_double) :: shear_stress(3) = 0
        ! Principal stresses in descending order (pressures, positive in tension).
        real(c_double) :: principal_stress(3) = 0
        ! Von Mises equivalent stress (a pressure).
        real(c_double) :: von_mises = 0
    end type stickslip_response

    ! Options of a tangential solver; stickslip_tangential_options_default() returns the defaults.
    type, bind(c), public :: stickslip_tangential_options
        ! Model of the traction: STICKSLIP_SCALAR (default) or STICKSLIP_VECTOR.
        integer(c_int32_t) :: model = 0
        ! Coupling of pressure and traction: STICKSLIP_ONE_WAY (default) or STICKSLIP_NEGLECTED; relevant only for dissimilar
        ! bodies.
        integer(c_int32_t) :: coupling = STICKSLIP_ONE_WAY
        ! Displacement of body 1 relative to body 2 that the contact does not cause, or NULL (default).
        type(c_ptr) :: relative_displacement = c_null_ptr
        ! Method, tolerance and limits of the solves.
        type(stickslip_settings) :: settings
        ! Reserved for future members: zero.
        integer(c_int64_t) :: reserved(8) = 0
    end type stickslip_tangential_options

    interface
        ! Creates a load stepper for histories on the grid of the given history, with a tolerance in (0, 1) for a whole load.
        function stickslip_adaptive_steps_new(history, tolerance, steps) result(answer) bind(c)
            import
            type(stickslip_history), value :: history
            real(c_double), value :: tolerance
            type(stickslip_adaptive_steps), intent(out) :: steps
            integer(c_int32_t) :: answer
        end function stickslip_adaptive_steps_new

        ! Frees a load stepper; does nothing if steps is NULL.
        function stickslip_adaptive_steps_free(steps) result(answer) bind(c)
            import
            type(stickslip_adaptive_steps), value :: steps
            integer(c_int32_t) :: answer
        end function stickslip_adaptive_steps_free

        ! Applies a load in as many steps as the tolerance requires, and writes their number to taken (may be NULL). A
        ! failure, for example STICKSLIP_STEP_TOO_LONG, leaves the state of the history unchanged. If the call has undone steps, the
        ! history has no last step until its next step. After several steps, the result and the wear of the last step are those of the
        ! last one alone; the field STICKSLIP_DISSIPATED_ENERGY contains the energy of all steps.
        function stickslip_adaptive_steps_step(steps, history, load, taken) result(answer) bind(c)
            import
            type(stickslip_adaptive_steps), value :: steps
            type(stickslip_history), value :: history
            type(stickslip_load_step), intent(in), optional :: load
            integer(c_size_t), intent(out), optional :: taken
            integer(c_int32_t) :: answer
        end function stickslip_adaptive_steps_step

        ! Applies a load in steps like stickslip_adaptive_steps_step, and writes their number to taken (may be NULL). Every accepted
        ! step is added to cycle (may be NULL), and observer (may be NULL) receives its results. Sums over all steps, such as energies
        ! and the slip for wear, are then results of the cycle. The cycle must start or end at the current state. After a failure the
        ! state of the history is unchanged, but the cycle may contain undone steps: begin it again. Returns STICKSLIP_NOT_CONVERGED if
        ! the observer ends the call.
        function stickslip_adaptive_steps_stepwise(steps, history, load, cycle, observer, taken) result(answer) bind(c)
            import
            type(stickslip_adaptive_steps), value :: steps
            type(stickslip_history), value :: history
            type(stickslip_load_step), intent(in), optional :: load
            type(stickslip_cycle), value :: cycle
            type(stickslip_step_observer), intent(in), optional :: observer
            integer(c_size_t), intent(out), optional :: taken
            integer(c_int32_t) :: answer
        end function stickslip_adaptive_steps_stepwise

        ! Computes the error that stickslip_history_step would make with a load. The state of the history is unchanged. The history
        ! then has no last step until its next step.
        function stickslip_adaptive_steps_error(steps, history, load, error) result(answer) bind(c)
            import
            type(stickslip_adaptive_steps), value :: steps
            type(stickslip_history), value :: history
            type(stickslip_load_step), intent(in), optional :: load
            type(stickslip_step_error), intent(out), optional :: error
            integer(c_int32_t) :: answer
        end function stickslip_adaptive_steps_error

        ! Computes the Hertz contact of a sphere with the given radius (a length) under a normal force, for the materials of the
        ! bodies. Returns STICKSLIP_NOT_POSITIVE if the radius, the force or a result is not positive and finite.
        function stickslip_hertz_sphere(half_space, radius, force, hertz) result(answer) bind(c)
            import
            type(stickslip_half_space), value :: half_space
            real(c_double), value :: radius
            real(c_double), value :: force
            type(stickslip_hertz), intent(out), optional :: hertz
            integer(c_int32_t) :: answer
        end function stickslip_hertz_sphere

        ! Computes the Cattaneo-Mindlin contact of a sphere under a normal force and a tangential force of either sign, with a
        ! coefficient of friction. Returns STICKSLIP_BEYOND_FRICTION_CAPACITY if friction cannot carry the tangential force. The
        ! coupling of pressure and traction between dissimilar bodies is neglected.
        function stickslip_cattaneo_mindlin_sphere(half_space, radius, force, friction, tangential_force, &
            found) result(answer) bind(c)
            import
            type(stickslip_half_space), value :: half_space
            real(c_double), value :: radius
            real(c_double), value :: force
            real(c_double), value :: friction
            real(c_double), value :: tangential_force
            type(stickslip_cattaneo_mindlin), intent(out), optional :: found
            integer(c_int32_t) :: answer
        end function stickslip_cattaneo_mindlin_sphere

        ! Computes the Carter contact of a cylinder with the given radius under a force per length, with a coefficient of friction
        ! and a creepage of either sign. Returns STICKSLIP_COUPLED_MATERIALS if Dundurs' beta of the bodies is not zero.
        function stickslip_carter_cylinder(half_space, radius, force, friction, creepage, found) result(answer) bind(c)
            import
            type(stickslip_half_space), value :: half_space
            real(c_double), value :: radius
            real(c_double), value :: force
            real(c_double), value :: friction
            real(c_double), value :: creepage
            type(stickslip_carter), intent(out), optional :: found
            integer(c_int32_t) :: answer
        end function stickslip_carter_cylinder

        ! Computes the Bentall-Johnson contact of a cylinder with the given radius that rolls freely under a force per length,
        ! with a coefficient of friction. Bodies whose Dundurs' beta is zero do not slip.
        function stickslip_bentall_johnson_cylinder(half_space, radius, force, friction, found) result(answer) bind(c)
            import
            type(stickslip_half_space), value :: half_space
            real(c_double), value :: radius
            real(c_double), value :: force
            real(c_double), value :: friction
            type(stickslip_bentall_johnson), intent(out), optional :: found
            integer(c_int32_t) :: answer
        end function stickslip_bentall_johnson_cylinder

        ! Computes Kalker's coefficients for an ellipse with the ratio a/b of the semi-axes along and across the rolling
        ! direction, from 1/16 to 16, and a Poisson's ratio from 0 to 1/2. Returns STICKSLIP_NOT_POSITIVE if the ratio a/b is not
        ! positive and finite. Returns STICKSLIP_BELOW_MINIMUM for another ratio outside this range or a negative Poisson's ratio, and
        ! STICKSLIP_POISSON_RATIO for a Poisson's ratio above 1/2.
        function stickslip_kalker_coefficients(ratio, poisson_ratio, found) result(answer) bind(c)
            import
            real(c_double), value :: ratio
            real(c_double), value :: poisson_ratio
            type(stickslip_kalker), intent(out), optional :: found
            integer(c_int32_t) :: answer
        end function stickslip_kalker_coefficients

        ! Computes the Vermeulen-Johnson contact of a body with the radii of curvature radius_x and radius_y (lengths) under a
        ! normal force, with a coefficient of friction and creepages of either sign. Returns STICKSLIP_COUPLED_MATERIALS if
        ! Dundurs' beta of the bodies is not zero. Returns STICKSLIP_BELOW_MINIMUM if one semi-axis of the contact exceeds 16 times the
        ! other.
        function stickslip_vermeulen_johnson_ellipse(half_space, radius_x, radius_y, force, friction, creepage_x, &
            creepage_y, found) result(answer) bind(c)
            import
            type(stickslip_half_space), value :: half_space
            real(c_double), value :: radius_x
            real(c_double), value :: radius_y
            real(c_double), value :: force
            real(c_double), value :: friction
            real(c_double), value :: creepage_x
            real(c_double), value :: creepage_y
            type(stickslip_vermeulen_johnson), intent(out), optional :: found
            integer(c_int32_t) :: answer
        end function stickslip_vermeulen_johnson_ellipse

        ! Takes a step of each of count histories on the threads of stickslip_set_num_threads; the i-th load belongs to the i-th
        ! history. A contact of at most 4096 cells is solved on one thread. Results are bitwise identical to separate steps.
        !
        ! codes (may be NULL) receives the code that stickslip_history_step would return for each history. The call returns
        ! STICKSLIP_SOME_FAILED if any step failed. The last error belongs to the first history whose step failed. Histories whose
        ! step failed are unchanged, and all other histories have taken their step. If a history occurs twice, the second
        ! occurrence fails with STICKSLIP_BUSY, and the message names both positions.
        function stickslip_history_step_all(histories, loads, count, codes) result(answer) bind(c)
            import
            type(stickslip_history), intent(in) :: histories(*)
            type(stickslip_load_step), intent(in), optional :: loads(*)
            integer(c_size_t), value :: count
            integer(c_int32_t), intent(inout), optional :: codes(*)
            integer(c_int32_t) :: answer
        end function stickslip_history_step_all

        ! Fills along_x and along_y (lengths, count entries) with the displacement of body 1 relative to body 2 due to a uniform bulk
        ! strain, a pattern for stickslip_relative_displacement. The strain is that of body 1 minus that of body 2, positive if body 1
        ! is stretched; xy is half of the engineering shear strain. The displacement is zero at the origin of the grid: along_x
        ! contains xx x + xy y and along_y contains xy x + yy y for a cell with the centre (x, y). Returns STICKSLIP_NOT_FINITE if a
        ! component is not finite, and STICKSLIP_INVALID_ARGUMENT for a component along a periodic axis, where the displacement would
        ! jump. A failure leaves both arrays unchanged.
        function stickslip_bulk_strain(half_space, xx, xy, yy, along_x, along_y, count) result(answer) bind(c)
            import
            type(stickslip_half_space), value :: half_space
            real(c_double), value :: xx
            real(c_double), value :: xy
            real(c_double), value :: yy
            real(c_double), intent(inout) :: along_x(*)
            real(c_double), intent(inout) :: along_y(*)
            integer(c_size_t), value :: count
            integer(c_int32_t) :: answer
        end function stickslip_bulk_strain

        ! Creates a solver for a gap before loading (lengths, count entries, copied). hardness, relative and settings may be NULL.
        ! A NULL hardness means no limit of the pressure, a NULL relative means no relative displacement, and NULL settings mean
        ! the defaults.
        function stickslip_coupled_solver_new(half_space, gap, count, friction, normal, tangential, hardness, &
            relative, settings, solver) result(answer) bind(c)
            import
            type(stickslip_half_space), value :: half_space
            real(c_double), intent(in) :: gap(*)
            integer(c_size_t), value :: count
            type(stickslip_friction), intent(in), optional :: friction
            type(stickslip_normal_load), intent(in), optional :: normal
            type(stickslip_tangential_load), intent(in), optional :: tangential
            type(stickslip_per_cell), intent(in), optional :: hardness
            type(stickslip_relative_displacement), intent(in), optional :: relative
            type(stickslip_settings), intent(in), optional :: settings
            type(stickslip_coupled_solver), intent(out) :: solver
            integer(c_int32_t) :: answer
        end function stickslip_coupled_solver_new

        ! Frees a solver; does nothing if it is NULL.
        function stickslip_coupled_solver_free(solver) result(answer) bind(c)
            import
            type(stickslip_coupled_solver), value :: solver
            integer(c_int32_t) :: answer
        end function stickslip_coupled_solver_free

        ! Sets the normal and the tangential load of the next solve.
        function stickslip_coupled_solver_set_loads(solver, normal, tangential) result(answer) bind(c)
            import
            type(stickslip_coupled_solver), value :: solver
            type(stickslip_normal_load), intent(in), optional :: normal
            type(stickslip_tangential_load), intent(in), optional :: tangential
            integer(c_int32_t) :: answer
        end function stickslip_coupled_solver_set_loads

        ! Sets the gap before loading of the next solve (lengths, count entries, copied). Returns STICKSLIP_GAP_UNDER_LOAD for the gap
        ! of the last solution, which is the gap under load.
        function stickslip_coupled_solver_set_gap(solver, gap, count) result(answer) bind(c)
            import
            type(stickslip_coupled_solver), value :: solver
            real(c_double), intent(in) :: gap(*)
            integer(c_size_t), value :: count
            integer(c_int32_t) :: answer
        end function stickslip_coupled_solver_set_gap

        ! Sets the friction of the next solve.
        function stickslip_coupled_solver_set_friction(solver, friction) result(answer) bind(c)
            import
            type(stickslip_coupled_solver), value :: solver
            type(stickslip_friction), intent(in), optional :: friction
            integer(c_int32_t) :: answer
        end function stickslip_coupled_solver_set_friction

        ! Sets the method, the tolerance and the limits of the next solve.
        function stickslip_coupled_solver_set_settings(solver, settings) result(answer) bind(c)
            import
            type(stickslip_coupled_solver), value :: solver
            type(stickslip_settings), intent(in), optional :: settings
            integer(c_int32_t) :: answer
        end function stickslip_coupled_solver_set_settings

        ! Discards the last solution: the next solve starts as the first solve did.
        function stickslip_coupled_solver_reset(solver) result(answer) bind(c)
            import
            type(stickslip_coupled_solver), value :: solver
            integer(c_int32_t) :: answer
        end function stickslip_coupled_solver_reset

        ! Solves into a solution of stickslip_coupled_solution_new for the same bodies. observer may be NULL. After
        ! STICKSLIP_NOT_CONVERGED the solution contains the last iterate and its report. Any other failure leaves the solution
        ! unchanged.
        function stickslip_coupled_solver_solve(solver, solution, observer) result(answer) bind(c)
            import
            type(stickslip_coupled_solver), value :: solver
            type(stickslip_coupled_solution), value :: solution
            type(stickslip_observer), intent(in), optional :: observer
            integer(c_int32_t) :: answer
        end function stickslip_coupled_solver_solve

        ! Creates an empty solution of the right size for a solver.
        function stickslip_coupled_solution_new(solver, solution) result(answer) bind(c)
            import
            type(stickslip_coupled_solver), value :: solver
            type(stickslip_coupled_solution), intent(out) :: solution
            integer(c_int32_t) :: answer
        end function stickslip_coupled_solution_new

        ! Frees a solution; does nothing if it is NULL.
        function stickslip_coupled_solution_free(solution) result(answer) bind(c)
            import
            type(stickslip_coupled_solution), value :: solution
            integer(c_int32_t) :: answer
        end function stickslip_coupled_solution_free

        ! Returns a field, STICKSLIP_PRESSURE to STICKSLIP_DISPLACEMENT_Z, and writes its number of cells to count (may be NULL);
        ! returns NULL on failure.
        function stickslip_coupled_solution_field(solution, which, count) result(answer) bind(c)
            import
            type(stickslip_coupled_solution), value :: solution
            integer(c_int32_t), value :: which
            integer(c_size_t), intent(out), optional :: count
            type(c_ptr) :: answer
        end function stickslip_coupled_solution_field

        ! Returns the zone of every cell, or NULL on failure.
        function stickslip_coupled_solution_zones(solution, count) result(answer) bind(c)
            import
            type(stickslip_coupled_solution), value :: solution
            integer(c_size_t), intent(out), optional :: count
            type(c_ptr) :: answer
        end function stickslip_coupled_solution_zones

        ! Writes the scalar results of the normal and the tangential part; either pointer may be NULL.
        function stickslip_coupled_solution_results(solution, normal, tangential) result(answer) bind(c)
            import
            type(stickslip_coupled_solution), value :: solution
            type(stickslip_normal_result), intent(out), optional :: normal
            type(stickslip_tangential_result), intent(out), optional :: tangential
            integer(c_int32_t) :: answer
        end function stickslip_coupled_solution_results

        ! Writes the report of the solve.
        function stickslip_coupled_solution_report(solution, report) result(answer) bind(c)
            import
            type(stickslip_coupled_solution), value :: solution
            type(stickslip_coupled_report), intent(out), optional :: report
            integer(c_int32_t) :: answer
        end function stickslip_coupled_solution_report

        ! Writes the warnings about the solution, like stickslip_normal_solution_warnings.
        function stickslip_coupled_solution_warnings(solution, buffer, capacity, count) result(answer) bind(c)
            import
            type(stickslip_coupled_solution), value :: solution
            type(stickslip_warning), intent(inout), optional :: buffer(*)
            integer(c_size_t), value :: capacity
            integer(c_size_t), intent(out), optional :: count
            integer(c_int32_t) :: answer
        end function stickslip_coupled_solution_warnings

        ! Computes the stiffness of a coupled contact. Bodies and friction must be those of the solve.
        function stickslip_coupled_solution_stiffness(solution, half_space, friction, stiffness) result(answer) bind(c)
            import
            type(stickslip_coupled_solution), value :: solution
            type(stickslip_half_space), value :: half_space
            type(stickslip_friction), intent(in), optional :: friction
            type(stickslip_stiffness), intent(out), optional :: stiffness
            integer(c_int32_t) :: answer
        end function stickslip_coupled_solution_stiffness

        ! Computes the stiffness with an observer (may be NULL). The observer is called before every product with the operator and
        ! may end the call: the function then returns STICKSLIP_NOT_CONVERGED and leaves stiffness unchanged.
        function stickslip_coupled_solution_stiffness_observed(solution, half_space, friction, observer, &
            stiffness) result(answer) bind(c)
            import
            type(stickslip_coupled_solution), value :: solution
            type(stickslip_half_space), value :: half_space
            type(stickslip_friction), intent(in), optional :: friction
            type(stickslip_observer), intent(in), optional :: observer
            type(stickslip_stiffness), intent(out), optional :: stiffness
            integer(c_int32_t) :: answer
        end function stickslip_coupled_solution_stiffness_observed

        ! Creates a solver for a gap before loading (lengths, count entries, copied) under a normal load. load and options may
        ! be NULL. A NULL load means no creepage and no spin, and NULL options mean the defaults. For the extent of the grid
        ! ahead of the contact, see stickslip_rolling_solver_new; here the solve returns STICKSLIP_GRID_TOO_SHORT.
        function stickslip_coupled_rolling_solver_new(half_space, gap, count, friction, normal, load, options, &
            solver) result(answer) bind(c)
            import
            type(stickslip_half_space), value :: half_space
            real(c_double), intent(in) :: gap(*)
            integer(c_size_t), value :: count
            type(stickslip_friction), intent(in), optional :: friction
            type(stickslip_normal_load), intent(in), optional :: normal
            type(stickslip_rolling_load), intent(in), optional :: load
            type(stickslip_rolling_options), intent(in), optional :: options
            type(stickslip_coupled_rolling_solver), intent(out) :: solver
            integer(c_int32_t) :: answer
        end function stickslip_coupled_rolling_solver_new

        ! Frees a solver; does nothing if it is NULL.
        function stickslip_coupled_rolling_solver_free(solver) result(answer) bind(c)
            import
            type(stickslip_coupled_rolling_solver), value :: solver
            integer(c_int32_t) :: answer
        end function stickslip_coupled_rolling_solver_free

        ! Sets the normal load of the next solve.
        function stickslip_coupled_rolling_solver_set_normal_load(solver, normal) result(answer) bind(c)
            import
            type(stickslip_coupled_rolling_solver), value :: solver
            type(stickslip_normal_load), intent(in), optional :: normal
            integer(c_int32_t) :: answer
        end function stickslip_coupled_rolling_solver_set_normal_load

        ! Sets the creepages, forces, spin or moment of the next solve.
        function stickslip_coupled_rolling_solver_set_load(solver, load) result(answer) bind(c)
            import
            type(stickslip_coupled_rolling_solver), value :: solver
            type(stickslip_rolling_load), intent(in), optional :: load
            integer(c_int32_t) :: answer
        end function stickslip_coupled_rolling_solver_set_load

        ! Sets the gap before loading of the next solve (lengths, count entries, copied). Returns STICKSLIP_GAP_UNDER_LOAD for the gap
        ! of the last solution, which is the gap under load.
        function stickslip_coupled_rolling_solver_set_gap(solver, gap, count) result(answer) bind(c)
            import
            type(stickslip_coupled_rolling_solver), value :: solver
            real(c_double), intent(in) :: gap(*)
            integer(c_size_t), value :: count
            integer(c_int32_t) :: answer
        end function stickslip_coupled_rolling_solver_set_gap

        ! Sets the friction of the next solve.
        function stickslip_coupled_rolling_solver_set_friction(solver, friction) result(answer) bind(c)
            import
            type(stickslip_coupled_rolling_solver), value :: solver
            type(stickslip_friction), intent(in), optional :: friction
            integer(c_int32_t) :: answer
        end function stickslip_coupled_rolling_solver_set_friction

        ! Sets the method, the tolerance and the limits of the next solve.
        function stickslip_coupled_rolling_solver_set_settings(solver, settings) result(answer) bind(c)
            import
            type(stickslip_coupled_rolling_solver), value :: solver
            type(stickslip_settings), intent(in), optional :: settings
            integer(c_int32_t) :: answer
        end function stickslip_coupled_rolling_solver_set_settings

        ! Discards the last solution: the next solve starts as the first solve did.
        function stickslip_coupled_rolling_solver_reset(solver) result(answer) bind(c)
            import
            type(stickslip_coupled_rolling_solver), value :: solver
            integer(c_int32_t) :: answer
        end function stickslip_coupled_rolling_solver_reset

        ! Solves into a solution of stickslip_coupled_rolling_solution_new for the same bodies. observer may be NULL. After
        ! STICKSLIP_NOT_CONVERGED the solution contains the last iterate and its report.
        function stickslip_coupled_rolling_solver_solve(solver, solution, observer) result(answer) bind(c)
            import
            type(stickslip_coupled_rolling_solver), value :: solver
            type(stickslip_coupled_rolling_solution), value :: solution
            type(stickslip_observer), intent(in), optional :: observer
            integer(c_int32_t) :: answer
        end function stickslip_coupled_rolling_solver_solve

        ! Computes the derivatives of the loads at the last solution, including the change of the pressure with the tractions.
        ! observer may be NULL. Returns STICKSLIP_NOT_CONVERGED before the first solve or after a solve that has not converged, and
        ! STICKSLIP_OUTDATED_SOLUTION if a load, the gap or the friction has changed since the last solve.
        function stickslip_coupled_rolling_solver_stiffness(solver, observer, stiffness) result(answer) bind(c)
            import
            type(stickslip_coupled_rolling_solver), value :: solver
            type(stickslip_observer), intent(in), optional :: observer
            type(stickslip_rolling_stiffness), intent(out), optional :: stiffness
            integer(c_int32_t) :: answer
        end function stickslip_coupled_rolling_solver_stiffness

        ! Creates an empty solution of the right size for a solver.
        function stickslip_coupled_rolling_solution_new(solver, solution) result(answer) bind(c)
            import
            type(stickslip_coupled_rolling_solver), value :: solver
            type(stickslip_coupled_rolling_solution), intent(out) :: solution
            integer(c_int32_t) :: answer
        end function stickslip_coupled_rolling_solution_new

        ! Frees a solution; does nothing if it is NULL.
        function stickslip_coupled_rolling_solution_free(solution) result(answer) bind(c)
            import
            type(stickslip_coupled_rolling_solution), value :: solution
            integer(c_int32_t) :: answer
        end function stickslip_coupled_rolling_solution_free

        ! Returns a field, STICKSLIP_PRESSURE, STICKSLIP_GAP, STICKSLIP_TRACTION_X, STICKSLIP_TRACTION_Y, STICKSLIP_SLIP_X or
        ! STICKSLIP_SLIP_Y, and writes its number of cells to count (may be NULL); returns NULL on failure. The slip is given per
        ! unit length rolled (dimensionless).
        function stickslip_coupled_rolling_solution_field(solution, which, count) result(answer) bind(c)
            import
            type(stickslip_coupled_rolling_solution), value :: solution
            integer(c_int32_t), value :: which
            integer(c_size_t), intent(out), optional :: count
            type(c_ptr) :: answer
        end function stickslip_coupled_rolling_solution_field

        ! Returns the zone of every cell, STICKSLIP_SEPARATED, STICKSLIP_STICK or STICKSLIP_SLIP; returns NULL on failure.
        function stickslip_coupled_rolling_solution_zones(solution, count) result(answer) bind(c)
            import
            type(stickslip_coupled_rolling_solution), value :: solution
            integer(c_size_t), intent(out), optional :: count
            type(c_ptr) :: answer
        end function stickslip_coupled_rolling_solution_zones

        ! Writes the scalar results of the normal and the rolling part; either pointer may be NULL.
        function stickslip_coupled_rolling_solution_results(solution, normal, rolling) result(answer) bind(c)
            import
            type(stickslip_coupled_rolling_solution), value :: solution
            type(stickslip_normal_result), intent(out), optional :: normal
            type(stickslip_rolling_result), intent(out), optional :: rolling
            integer(c_int32_t) :: answer
        end function stickslip_coupled_rolling_solution_results

        ! Writes the report of the solve.
        function stickslip_coupled_rolling_solution_report(solution, report) result(answer) bind(c)
            import
            type(stickslip_coupled_rolling_solution), value :: solution
            type(stickslip_coupled_rolling_report), intent(out), optional :: report
            integer(c_int32_t) :: answer
        end function stickslip_coupled_rolling_solution_report

        ! Writes the warnings about the solution, like stickslip_normal_solution_warnings.
        function stickslip_coupled_rolling_solution_warnings(solution, buffer, capacity, count) result(answer) bind(c)
            import
            type(stickslip_coupled_rolling_solution), value :: solution
            type(stickslip_warning), intent(inout), optional :: buffer(*)
            integer(c_size_t), value :: capacity
            integer(c_size_t), intent(out), optional :: count
            integer(c_int32_t) :: answer
        end function stickslip_coupled_rolling_solution_warnings

        ! Computes the loads at count points and writes them to forces. Each solve starts from the solution of the previous point,
        ! so consecutive points should be close to each other. All points are checked before the first solve. Afterwards the last
        ! point is the prescribed load. After STICKSLIP_NOT_CONVERGED the failed point is the prescribed load. forces then contains the
        ! points solved before, whose number is the member found of stickslip_last_error; its other entries are unchanged.
        function stickslip_rolling_solver_creep_forces(solver, points, count, forces) result(answer) bind(c)
            import
            type(stickslip_rolling_solver), value :: solver
            type(stickslip_creep_point), intent(in), optional :: points(*)
            integer(c_size_t), value :: count
            type(stickslip_creep_force), intent(inout), optional :: forces(*)
            integer(c_int32_t) :: answer
        end function stickslip_rolling_solver_creep_forces

        ! Computes the loads at count points with an observer (may be NULL), like stickslip_rolling_solver_creep_forces. The
        ! observer is called before every product with an operator and may end the call. The call then returns
        ! STICKSLIP_NOT_CONVERGED and leaves forces as after a point that does not converge.
        function stickslip_rolling_solver_creep_forces_observed(solver, points, count, observer, &
            forces) result(answer) bind(c)
            import
            type(stickslip_rolling_solver), value :: solver
            type(stickslip_creep_point), intent(in), optional :: points(*)
            integer(c_size_t), value :: count
            type(stickslip_observer), intent(in), optional :: observer
            type(stickslip_creep_force), intent(inout), optional :: forces(*)
            integer(c_int32_t) :: answer
        end function stickslip_rolling_solver_creep_forces_observed

        ! Writes the warnings about the loads of the points that the last call of stickslip_rolling_solver_creep_forces has solved,
        ! like stickslip_normal_solution_warnings. They include a creepage that may be in per cent. Each kind is listed once, for the
        ! first point that has it. The list is empty before the first call. stickslip_rolling_solution_warnings also contains the
        ! warnings about the contact, which is the same at all points.
        function stickslip_rolling_solver_creep_warnings(solver, buffer, capacity, count) result(answer) bind(c)
            import
            type(stickslip_rolling_solver), value :: solver
            type(stickslip_warning), intent(inout), optional :: buffer(*)
            integer(c_size_t), value :: capacity
            integer(c_size_t), intent(out), optional :: count
            integer(c_int32_t) :: answer
        end function stickslip_rolling_solver_creep_warnings

        ! Starts a cycle at the current state of a history.
        function stickslip_cycle_new(history, cycle) result(answer) bind(c)
            import
            type(stickslip_history), value :: history
            type(stickslip_cycle), intent(out) :: cycle
            integer(c_int32_t) :: answer
        end function stickslip_cycle_new

        ! Frees a cycle; does nothing if it is NULL.
        function stickslip_cycle_free(cycle) result(answer) bind(c)
            import
            type(stickslip_cycle), value :: cycle
            integer(c_int32_t) :: answer
        end function stickslip_cycle_free

        ! Restarts the cycle at the current state of a history.
        function stickslip_cycle_begin(cycle, history) result(answer) bind(c)
            import
            type(stickslip_cycle), value :: cycle
            type(stickslip_history), value :: history
            integer(c_int32_t) :: answer
        end function stickslip_cycle_begin

        ! Adds the last step of the history. Returns STICKSLIP_STEP_OUT_OF_ORDER unless this step is the step after the
        ! last added one, or after the start of the cycle. Returns STICKSLIP_NO_LAST_STEP if the state of the history was
        ! set since its last step.
        function stickslip_cycle_add(cycle, history) result(answer) bind(c)
            import
            type(stickslip_cycle), value :: cycle
            type(stickslip_history), value :: history
            integer(c_int32_t) :: answer
        end function stickslip_cycle_add

        ! Writes the scalar results of the cycle.
        function stickslip_cycle_result_of(cycle, result) result(answer) bind(c)
            import
            type(stickslip_cycle), value :: cycle
            type(stickslip_cycle_result), intent(out), optional :: result
            integer(c_int32_t) :: answer
        end function stickslip_cycle_result_of

        ! Returns a field of the cycle: STICKSLIP_SLIP_DISTANCE, STICKSLIP_DISSIPATED_ENERGY, STICKSLIP_SLIP_PRESSURE,
        ! STICKSLIP_SLIP_AMPLITUDE_X or _Y; returns NULL on failure. The field is valid until the next call that changes the
        ! cycle.
        function stickslip_cycle_field(cycle, which, count) result(answer) bind(c)
            import
            type(stickslip_cycle), value :: cycle
            integer(c_int32_t), value :: which
            integer(c_size_t), intent(out), optional :: count
            type(c_ptr) :: answer
        end function stickslip_cycle_field

        ! Computes the edge of the contact inside the cells, and the pressure corrected for this edge.
        !
        ! The arrays centres and means (of length cells) receive the pressure at the centres of the cells and its means over the
        ! cells. Either array may be NULL. The results are most accurate with STICKSLIP_CENTRE.
        function stickslip_normal_solution_edges(solution, edges, centres, means, cells) result(answer) bind(c)
            import
            type(stickslip_normal_solution), value :: solution
            type(stickslip_edges), intent(out), optional :: edges
            real(c_double), intent(inout), optional :: centres(*)
            real(c_double), intent(inout), optional :: means(*)
            integer(c_size_t), value :: cells
            integer(c_int32_t) :: answer
        end function stickslip_normal_solution_edges

        ! Computes the edges of the contact and of the stick zone inside the cells. The normal solution and the friction must be
        ! those of the problem. The method assumes a contact that is loaded once.
        !
        ! The arrays centres and means (of length cells) receive the magnitude of the traction at the centres of the cells and its
        ! means over the cells. Either array may be NULL.
        function stickslip_tangential_solution_edges(solution, normal, friction, edges, centres, means, &
            cells) result(answer) bind(c)
            import
            type(stickslip_tangential_solution), value :: solution
            type(stickslip_normal_solution), value :: normal
            type(stickslip_friction), intent(in), optional :: friction
            type(stickslip_edges), intent(out), optional :: edges
            real(c_double), intent(inout), optional :: centres(*)
            real(c_double), intent(inout), optional :: means(*)
            integer(c_size_t), value :: cells
            integer(c_int32_t) :: answer
        end function stickslip_tangential_solution_edges

        ! Computes the edges of a coupled contact, like stickslip_tangential_solution_edges. The corresponding pressure comes from
        ! stickslip_coupled_solution_pressure_edges.
        function stickslip_coupled_solution_edges(solution, friction, edges, centres, means, &
            cells) result(answer) bind(c)
            import
            type(stickslip_coupled_solution), value :: solution
            type(stickslip_friction), intent(in), optional :: friction
            type(stickslip_edges), intent(out), optional :: edges
            real(c_double), intent(inout), optional :: centres(*)
            real(c_double), intent(inout), optional :: means(*)
            integer(c_size_t), value :: cells
            integer(c_int32_t) :: answer
        end function stickslip_coupled_solution_edges

        ! Computes the edge of a coupled contact with its pressure, like stickslip_normal_solution_edges.
        function stickslip_coupled_solution_pressure_edges(solution, edges, centres, means, &
            cells) result(answer) bind(c)
            import
            type(stickslip_coupled_solution), value :: solution
            type(stickslip_edges), intent(out), optional :: edges
            real(c_double), intent(inout), optional :: centres(*)
            real(c_double), intent(inout), optional :: means(*)
            integer(c_size_t), value :: cells
            integer(c_int32_t) :: answer
        end function stickslip_coupled_solution_pressure_edges

        ! Estimates the relative discretisation error of the pressure: the sum of the absolute errors of the cell means,
        ! relative to the sum of the pressure. The estimate is NaN without contact.
        function stickslip_normal_solution_discretisation_estimate(solution, estimate) result(answer) bind(c)
            import
            type(stickslip_normal_solution), value :: solution
            real(c_double), intent(out), optional :: estimate
            integer(c_int32_t) :: answer
        end function stickslip_normal_solution_discretisation_estimate

        ! Estimates the relative discretisation error of the traction, like stickslip_normal_solution_discretisation_estimate.
        ! The estimate is NaN without traction.
        function stickslip_tangential_solution_discretisation_estimate(solution, estimate) result(answer) bind(c)
            import
            type(stickslip_tangential_solution), value :: solution
            real(c_double), intent(out), optional :: estimate
            integer(c_int32_t) :: answer
        end function stickslip_tangential_solution_discretisation_estimate

        ! Estimates the relative discretisation errors of the pressure and the traction of a coupled contact. An estimate is NaN
        ! without contact or without traction.
        function stickslip_coupled_solution_discretisation_estimates(solution, of_pressure, &
            of_traction) result(answer) bind(c)
            import
            type(stickslip_coupled_solution), value :: solution
            real(c_double), intent(out), optional :: of_pressure
            real(c_double), intent(out), optional :: of_traction
            integer(c_int32_t) :: answer
        end function stickslip_coupled_solution_discretisation_estimates

        ! Returns the message of the last failure on this thread, in English and UTF-8; the message is empty before any failure.
        ! The pointer is the same for all failures of a thread and valid until the thread ends. The text remains until the next
        ! failing call of the same thread overwrites it. Successful calls and the calls of other threads do not change it.
        function stickslip_last_error_message() result(answer) bind(c)
            import
            type(c_ptr) :: answer
        end function stickslip_last_error_message

        ! Copies the message of the last failure on this thread to buffer, which has room for capacity bytes, and returns the length
        ! of the message without the zero at its end. A message that does not fit is truncated to whole characters. The copy ends
        ! with a zero unless the capacity is 0. With a NULL buffer or a capacity of 0 only the length is returned. The call does not
        ! fail and does not change the last failure.
        function stickslip_last_error_copy(buffer, capacity) result(answer) bind(c)
            import
            character(kind=c_char), intent(inout), optional :: buffer(*)
            integer(c_size_t), value :: capacity
            integer(c_size_t) :: answer
        end function stickslip_last_error_copy

        ! Writes the numbers that describe the last failure on this thread.
        function stickslip_last_error(error) result(answer) bind(c)
            import
            type(stickslip_error), intent(out), optional :: error
            integer(c_int32_t) :: answer
        end function stickslip_last_error

        ! Writes the report of the last failure on this thread if its code was STICKSLIP_NOT_CONVERGED, and returns
        ! STICKSLIP_INVALID_ARGUMENT otherwise.
        function stickslip_last_error_report(report) result(answer) bind(c)
            import
            type(stickslip_report), intent(out), optional :: report
            integer(c_int32_t) :: answer
        end function stickslip_last_error_report

        ! Creates the half-spaces; nothing is computed yet. A NULL boundary means STICKSLIP_NON_PERIODIC.
        function stickslip_half_space_new(grid, body_1, body_2, boundary, half_space) result(answer) bind(c)
            import
            type(stickslip_grid), intent(in), optional :: grid
            type(stickslip_material), intent(in), optional :: body_1
            type(stickslip_material), intent(in), optional :: body_2
            type(stickslip_boundary), intent(in), optional :: boundary
            type(stickslip_half_space), intent(out) :: half_space
            integer(c_int32_t) :: answer
        end function stickslip_half_space_new

        ! Creates coated half-spaces. Each body has at most eight layers, listed from the outermost inwards. A body without layers
        ! is uncoated.
        function stickslip_half_space_new_coated(grid, body_1, layers_1, layers_1_count, body_2, layers_2, &
            layers_2_count, boundary, half_space) result(answer) bind(c)
            import
            type(stickslip_grid), intent(in), optional :: grid
            type(stickslip_material), intent(in), optional :: body_1
            type(stickslip_layer), intent(in), optional :: layers_1(*)
            integer(c_size_t), value :: layers_1_count
            type(stickslip_material), intent(in), optional :: body_2
            type(stickslip_layer), intent(in), optional :: layers_2(*)
            integer(c_size_t), value :: layers_2_count
            type(stickslip_boundary), intent(in), optional :: boundary
            type(stickslip_half_space), intent(out) :: half_space
            integer(c_int32_t) :: answer
        end function stickslip_half_space_new_coated

        ! Creates half-spaces whose rows are distributed over ranks, which solve contacts together. Results are bitwise identical
        ! to the results of one process. Every rank passes the whole grid, and all ranks then make the same calls in the same
        ! order. The grid of the object contains only the local rows, starting at the row that stickslip_half_space_first_row
        ! returns. Arrays and labels contain the local cells; sums, reports and spots describe the whole contact.
        !
        ! Functions that return or accept only a grid do not account for the distribution, so the program must compute the local
        ! gap itself. If the ranks are threads of one process, the program must call stickslip_set_num_threads(1), which keeps the
        ! work of each rank on its own thread. Otherwise the ranks wait for the same threads forever.
        function stickslip_half_space_new_distributed(grid, body_1, layers_1, layers_1_count, body_2, layers_2, &
            layers_2_count, boundary, ranks, half_space) result(answer) bind(c)
            import
            type(stickslip_grid), intent(in), optional :: grid
            type(stickslip_material), intent(in), optional :: body_1
            type(stickslip_layer), intent(in), optional :: layers_1(*)
            integer(c_size_t), value :: layers_1_count
            type(stickslip_material), intent(in), optional :: body_2
            type(stickslip_layer), intent(in), optional :: layers_2(*)
            integer(c_size_t), value :: layers_2_count
            type(stickslip_boundary), intent(in), optional :: boundary
            type(stickslip_ranks), intent(in), optional :: ranks
            type(stickslip_half_space), intent(out) :: half_space
            integer(c_int32_t) :: answer
        end function stickslip_half_space_new_distributed

        ! Writes the number of the first local row in the whole grid; this number is zero without ranks.
        function stickslip_half_space_first_row(half_space, row) result(answer) bind(c)
            import
            type(stickslip_half_space), value :: half_space
            integer(c_size_t), intent(out), optional :: row
            integer(c_int32_t) :: answer
        end function stickslip_half_space_first_row

        ! Sets the meaning of the pressure and the traction of a cell, STICKSLIP_UNIFORM (default) or STICKSLIP_CENTRE, for
        ! objects that are created afterwards. On a grid with STICKSLIP_PERIODIC the values are always those at the centres.
        function stickslip_half_space_set_cell_value(half_space, value) result(answer) bind(c)
            import
            type(stickslip_half_space), value :: half_space
            integer(c_int32_t), value :: value
            integer(c_int32_t) :: answer
        end function stickslip_half_space_set_cell_value

        ! Writes the meaning of the pressure and the traction of a cell: STICKSLIP_UNIFORM or STICKSLIP_CENTRE.
        function stickslip_half_space_cell_value(half_space, value) result(answer) bind(c)
            import
            type(stickslip_half_space), value :: half_space
            integer(c_int32_t), intent(out), optional :: value
            integer(c_int32_t) :: answer
        end function stickslip_half_space_cell_value

        ! Frees the half-spaces; does nothing if the pointer is NULL.
        function stickslip_half_space_free(half_space) result(answer) bind(c)
            import
            type(stickslip_half_space), value :: half_space
            integer(c_int32_t) :: answer
        end function stickslip_half_space_free

        ! Writes the grid.
        function stickslip_half_space_grid(half_space, grid) result(answer) bind(c)
            import
            type(stickslip_half_space), value :: half_space
            type(stickslip_grid), intent(out), optional :: grid
            integer(c_int32_t) :: answer
        end function stickslip_half_space_grid

        ! Writes the constants of the pair of materials.
        function stickslip_half_space_pair(half_space, pair) result(answer) bind(c)
            import
            type(stickslip_half_space), value :: half_space
            type(stickslip_pair), intent(out), optional :: pair
            integer(c_int32_t) :: answer
        end function stickslip_half_space_pair

        ! Returns the default options of a history.
        function stickslip_history_options_default() result(answer) bind(c)
            import
            type(stickslip_history_options) :: answer
        end function stickslip_history_options_default

        ! Creates a history for a gap before loading (lengths, count entries, copied); the bodies do not touch before the first
        ! step. options may be NULL (the defaults).
        function stickslip_history_new(half_space, gap, count, friction, options, history) result(answer) bind(c)
            import
            type(stickslip_half_space), value :: half_space
            real(c_double), intent(in) :: gap(*)
            integer(c_size_t), value :: count
            type(stickslip_friction), intent(in), optional :: friction
            type(stickslip_history_options), intent(in), optional :: options
            type(stickslip_history), intent(out) :: history
            integer(c_int32_t) :: answer
        end function stickslip_history_new

        ! Creates an independent copy of a history.
        function stickslip_history_clone(history, copy) result(answer) bind(c)
            import
            type(stickslip_history), value :: history
            type(stickslip_history), intent(out) :: copy
            integer(c_int32_t) :: answer
        end function stickslip_history_clone

        ! Frees a history; does nothing if it is NULL.
        function stickslip_history_free(history) result(answer) bind(c)
            import
            type(stickslip_history), value :: history
            integer(c_int32_t) :: answer
        end function stickslip_history_free

        ! Takes a step. observer may be NULL. A failure leaves the history unchanged; after STICKSLIP_NOT_CONVERGED,
        ! stickslip_last_error_report writes the report.
        function stickslip_history_step(history, load, observer) result(answer) bind(c)
            import
            type(stickslip_history), value :: history
            type(stickslip_load_step), intent(in), optional :: load
            type(stickslip_observer), intent(in), optional :: observer
            integer(c_int32_t) :: answer
        end function stickslip_history_step

        ! Applies a load in steps with equal growth of the contact, as many as a tolerance in (0, 1) requires, and writes
        ! their number to taken (may be NULL). Press contacts of dissimilar bodies with this function or in several steps: a
        ! single step issues a warning. The function applies the load in 1, 2, 4, 8, ... steps from the current state until
        ! the change of the tractions is at most the tolerance times the friction limits. A tolerance of 0.01 is a good
        ! choice. The argument observer may be NULL; it receives the iterations of all steps. After a failure, for example
        ! STICKSLIP_STEP_TOO_LONG, the state of the history is unchanged. If the call has undone steps, the history has no
        ! last step until its next step. After several steps, the result and the wear of the last step are those of the last one
        ! alone; the field STICKSLIP_DISSIPATED_ENERGY contains the energy of all steps.
        function stickslip_history_press(history, load, tolerance, observer, taken) result(answer) bind(c)
            import
            type(stickslip_history), value :: history
            type(stickslip_load_step), intent(in), optional :: load
            real(c_double), value :: tolerance
            type(stickslip_observer), intent(in), optional :: observer
            integer(c_size_t), intent(out), optional :: taken
            integer(c_int32_t) :: answer
        end function stickslip_history_press

        ! Applies a load in steps like stickslip_history_press, and writes their number to taken (may be NULL). Every accepted step is
        ! added to cycle (may be NULL), and observer (may be NULL) receives its results. For this purpose the accepted steps are taken a
        ! second time, with identical results. The cycle must start or end at the current state. After a failure the state of the
        ! history is unchanged, but the cycle may contain undone steps: begin it again. Returns STICKSLIP_NOT_CONVERGED if the observer
        ! ends the call.
        function stickslip_history_press_stepwise(history, load, tolerance, cycle, observer, &
            taken) result(answer) bind(c)
            import
            type(stickslip_history), value :: history
            type(stickslip_load_step), intent(in), optional :: load
            real(c_double), value :: tolerance
            type(stickslip_cycle), value :: cycle
            type(stickslip_step_observer), intent(in), optional :: observer
            integer(c_size_t), intent(out), optional :: taken
            integer(c_int32_t) :: answer
        end function stickslip_history_press_stepwise

        ! Sets the gap before loading (lengths, count entries, copied), for example after wear. The pressure does not change until
        ! a step prescribes a normal load. Returns STICKSLIP_GAP_UNDER_LOAD for the gap under load of the present contact.
        function stickslip_history_set_gap(history, gap, count) result(answer) bind(c)
            import
            type(stickslip_history), value :: history
            real(c_double), intent(in) :: gap(*)
            integer(c_size_t), value :: count
            integer(c_int32_t) :: answer
        end function stickslip_history_set_gap

        ! Sets the friction of the following steps.
        function stickslip_history_set_friction(history, friction) result(answer) bind(c)
            import
            type(stickslip_history), value :: history
            type(stickslip_friction), intent(in), optional :: friction
            integer(c_int32_t) :: answer
        end function stickslip_history_set_friction

        ! Sets the method, the tolerance and the limits of the following steps.
        function stickslip_history_set_settings(history, settings) result(answer) bind(c)
            import
            type(stickslip_history), value :: history
            type(stickslip_settings), intent(in), optional :: settings
            integer(c_int32_t) :: answer
        end function stickslip_history_set_settings

        ! Sets the pattern of the relative displacement of the following steps.
        function stickslip_history_set_relative_displacement(history, pattern) result(answer) bind(c)
            import
            type(stickslip_history), value :: history
            type(stickslip_relative_displacement), intent(in), optional :: pattern
            integer(c_int32_t) :: answer
        end function stickslip_history_set_relative_displacement

        ! Computes the stiffness of the contact after the last step: normal stiffness, and tangential stiffness on loading and
        ! at reversal. It is the derivative of the last step with respect to the motions at its end. Returns
        ! STICKSLIP_OUTDATED_SOLUTION if the friction limits or the gap have changed since the last step.
        function stickslip_history_stiffness(history, stiffness) result(answer) bind(c)
            import
            type(stickslip_history), value :: history
            type(stickslip_stiffness), intent(out), optional :: stiffness
            integer(c_int32_t) :: answer
        end function stickslip_history_stiffness

        ! Computes the stiffness with an observer (may be NULL). The observer is called before every product with an operator and
        ! may end the call: the function then returns STICKSLIP_NOT_CONVERGED and leaves stiffness unchanged.
        function stickslip_history_stiffness_observed(history, observer, stiffness) result(answer) bind(c)
            import
            type(stickslip_history), value :: history
            type(stickslip_observer), intent(in), optional :: observer
            type(stickslip_stiffness), intent(out), optional :: stiffness
            integer(c_int32_t) :: answer
        end function stickslip_history_stiffness_observed

        ! Computes the stiffness of the next step from the current state. In the members loading and by_approach, stick cells
        ! resist fully, including those that came into contact in the last step, and cells at their friction limit continue to
        ! slip. Use this stiffness to shear the contact further under the same normal load. observer may be NULL.
        function stickslip_history_next_stiffness(history, observer, stiffness) result(answer) bind(c)
            import
            type(stickslip_history), value :: history
            type(stickslip_observer), intent(in), optional :: observer
            type(stickslip_stiffness), intent(out), optional :: stiffness
            integer(c_int32_t) :: answer
        end function stickslip_history_next_stiffness

        ! Writes the scalar results. Stick ratio, gross slip, energies and creepages describe the last step. Without a last step,
        ! has_last_step is zero and these numbers are NaN.
        function stickslip_history_result(history, result) result(answer) bind(c)
            import
            type(stickslip_history), value :: history
            type(stickslip_step_result), intent(out), optional :: result
            integer(c_int32_t) :: answer
        end function stickslip_history_result

        ! Writes the scalar results of the normal contact.
        function stickslip_history_normal_result(history, result) result(answer) bind(c)
            import
            type(stickslip_history), value :: history
            type(stickslip_normal_result), intent(out), optional :: result
            integer(c_int32_t) :: answer
        end function stickslip_history_normal_result

        ! Writes the grid of all fields.
        function stickslip_history_grid(history, grid) result(answer) bind(c)
            import
            type(stickslip_history), value :: history
            type(stickslip_grid), intent(out), optional :: grid
            integer(c_int32_t) :: answer
        end function stickslip_history_grid

        ! Writes the largest tangential force that friction can carry at the current pressure.
        function stickslip_history_friction_capacity(history, capacity) result(answer) bind(c)
            import
            type(stickslip_history), value :: history
            real(c_double), intent(out), optional :: capacity
            integer(c_int32_t) :: answer
        end function stickslip_history_friction_capacity

        ! Writes the reports of the pressure and the traction of the last step. Their status is STICKSLIP_UNSOLVED if the pressure
        ! was held, or before the first contact. Returns STICKSLIP_NO_LAST_STEP without a last step.
        function stickslip_history_reports(history, normal, tangential) result(answer) bind(c)
            import
            type(stickslip_history), value :: history
            type(stickslip_report), intent(out), optional :: normal
            type(stickslip_report), intent(out), optional :: tangential
            integer(c_int32_t) :: answer
        end function stickslip_history_reports

        ! Writes the warnings about the last step, like stickslip_normal_solution_warnings. Returns STICKSLIP_NO_LAST_STEP without a
        ! last step.
        function stickslip_history_warnings(history, buffer, capacity, count) result(answer) bind(c)
            import
            type(stickslip_history), value :: history
            type(stickslip_warning), intent(inout), optional :: buffer(*)
            integer(c_size_t), value :: capacity
            integer(c_size_t), intent(out), optional :: count
            integer(c_int32_t) :: answer
        end function stickslip_history_warnings

        ! Returns a field, STICKSLIP_PRESSURE to STICKSLIP_YIELDED_DEPTH except displacements, and writes its number of cells to
        ! count (may be NULL); returns NULL on failure. The fields of the last step, STICKSLIP_STEP_SLIP_X to
        ! STICKSLIP_STEP_MID_DISSIPATED_ENERGY, fail with STICKSLIP_NO_LAST_STEP without a last step.
        function stickslip_history_field(history, which, count) result(answer) bind(c)
            import
            type(stickslip_history), value :: history
            integer(c_int32_t), value :: which
            integer(c_size_t), intent(out), optional :: count
            type(c_ptr) :: answer
        end function stickslip_history_field

        ! Returns the zone of every cell after the last step, or NULL on failure.
        function stickslip_history_zones(history, count) result(answer) bind(c)
            import
            type(stickslip_history), value :: history
            integer(c_size_t), intent(out), optional :: count
            type(c_ptr) :: answer
        end function stickslip_history_zones

        ! Returns the default settings of solvers and histories.
        function stickslip_settings_default() result(answer) bind(c)
            import
            type(stickslip_settings) :: answer
        end function stickslip_settings_default

        ! Returns a friction with one coefficient for all cells.
        function stickslip_coulomb(coefficient) result(answer) bind(c)
            import
            real(c_double), value :: coefficient
            type(stickslip_friction) :: answer
        end function stickslip_coulomb

        ! Returns the default limits of a jump.
        function stickslip_jump_limits_default() result(answer) bind(c)
            import
            type(stickslip_jump_limits) :: answer
        end function stickslip_jump_limits_default

        ! Writes to cycles the number of cycles like this one that a jump may skip, not rounded. Up to this number, removing the
        ! wear in one step does not make the pressure oscillate, and the limits are met. limits may be NULL (the defaults). The
        ! number is infinite if nothing limits it, as in full stick: set cycles_left or largest_depth before using the number.
        !
        ! depth (lengths, count entries) is the depth that the cycle removed from both bodies together. Returns
        ! STICKSLIP_CYCLE_NOT_CLOSED if the cycle does not close, like the first cycle from rest. Returns
        ! STICKSLIP_NEGATIVE_OR_NOT_FINITE for an invalid limit, and STICKSLIP_SAMPLE for an invalid depth.
        function stickslip_cycle_jump(half_space, cycle, depth, count, limits, cycles) result(answer) bind(c)
            import
            type(stickslip_half_space), value :: half_space
            type(stickslip_cycle), value :: cycle
            real(c_double), intent(in) :: depth(*)
            integer(c_size_t), value :: count
            type(stickslip_jump_limits), intent(in), optional :: limits
            real(c_double), intent(out), optional :: cycles
            integer(c_int32_t) :: answer
        end function stickslip_cycle_jump

        ! Writes to cycles the number of cycles whose wear may be removed in one step without growing oscillations of the
        ! pressure. Explicit integration of Archard's law is stable below this number. coefficient (one over a pressure) is the
        ! sum of the wear coefficients of both bodies, and slip_distance (lengths, count entries) is the slip distance of one
        ! cycle. For the energy law, coefficient is the wear coefficient times the coefficient of friction. The number is infinite
        ! if no cell slips.
        function stickslip_max_stable_cycles(half_space, coefficient, slip_distance, count, &
            cycles) result(answer) bind(c)
            import
            type(stickslip_half_space), value :: half_space
            type(stickslip_per_cell), intent(in), optional :: coefficient
            real(c_double), intent(in) :: slip_distance(*)
            integer(c_size_t), value :: count
            real(c_double), intent(out), optional :: cycles
            integer(c_int32_t) :: answer
        end function stickslip_max_stable_cycles

        ! Creates a solver for a gap before loading (lengths, count entries, copied) under a load.
        !
        ! hardness is the largest pressure that the cells can carry. It may be NULL if there is no limit, and settings may be
        ! NULL for the defaults.
        function stickslip_normal_solver_new(half_space, gap, count, load, hardness, settings, &
            solver) result(answer) bind(c)
            import
            type(stickslip_half_space), value :: half_space
            real(c_double), intent(in) :: gap(*)
            integer(c_size_t), value :: count
            type(stickslip_normal_load), intent(in), optional :: load
            type(stickslip_per_cell), intent(in), optional :: hardness
            type(stickslip_settings), intent(in), optional :: settings
            type(stickslip_normal_solver), intent(out) :: solver
            integer(c_int32_t) :: answer
        end function stickslip_normal_solver_new

        ! Frees a solver; does nothing if it is NULL.
        function stickslip_normal_solver_free(solver) result(answer) bind(c)
            import
            type(stickslip_normal_solver), value :: solver
            integer(c_int32_t) :: answer
        end function stickslip_normal_solver_free

        ! Sets the load of the next solve.
        function stickslip_normal_solver_set_load(solver, load) result(answer) bind(c)
            import
            type(stickslip_normal_solver), value :: solver
            type(stickslip_normal_load), intent(in), optional :: load
            integer(c_int32_t) :: answer
        end function stickslip_normal_solver_set_load

        ! Sets the gap before loading of the next solve (lengths, count entries, copied). Returns STICKSLIP_GAP_UNDER_LOAD for the gap
        ! of the last solution, which is the gap under load.
        function stickslip_normal_solver_set_gap(solver, gap, count) result(answer) bind(c)
            import
            type(stickslip_normal_solver), value :: solver
            real(c_double), intent(in) :: gap(*)
            integer(c_size_t), value :: count
            integer(c_int32_t) :: answer
        end function stickslip_normal_solver_set_gap

        ! Sets the method, the tolerance and the limits of the next solve.
        function stickslip_normal_solver_set_settings(solver, settings) result(answer) bind(c)
            import
            type(stickslip_normal_solver), value :: solver
            type(stickslip_settings), intent(in), optional :: settings
            integer(c_int32_t) :: answer
        end function stickslip_normal_solver_set_settings

        ! Discards the last solution: the next solve starts as the first solve did.
        function stickslip_normal_solver_reset(solver) result(answer) bind(c)
            import
            type(stickslip_normal_solver), value :: solver
            integer(c_int32_t) :: answer
        end function stickslip_normal_solver_reset

        ! Solves into a solution of stickslip_normal_solution_new for the same bodies. observer may be NULL.
        !
        ! After STICKSLIP_NOT_CONVERGED the solution contains the last feasible iterate and its report. Any other failure leaves
        ! the solution unchanged.
        function stickslip_normal_solver_solve(solver, solution, observer) result(answer) bind(c)
            import
            type(stickslip_normal_solver), value :: solver
            type(stickslip_normal_solution), value :: solution
            type(stickslip_observer), intent(in), optional :: observer
            integer(c_int32_t) :: answer
        end function stickslip_normal_solver_solve

        ! Creates an empty solution of the right size for a solver.
        function stickslip_normal_solution_new(solver, solution) result(answer) bind(c)
            import
            type(stickslip_normal_solver), value :: solver
            type(stickslip_normal_solution), intent(out) :: solution
            integer(c_int32_t) :: answer
        end function stickslip_normal_solution_new

        ! Frees a solution; does nothing if it is NULL.
        function stickslip_normal_solution_free(solution) result(answer) bind(c)
            import
            type(stickslip_normal_solution), value :: solution
            integer(c_int32_t) :: answer
        end function stickslip_normal_solution_free

        ! Returns a field, STICKSLIP_PRESSURE or STICKSLIP_GAP, and writes its number of cells to count (may be NULL); returns
        ! NULL on failure.
        function stickslip_normal_solution_field(solution, which, count) result(answer) bind(c)
            import
            type(stickslip_normal_solution), value :: solution
            integer(c_int32_t), value :: which
            integer(c_size_t), intent(out), optional :: count
            type(c_ptr) :: answer
        end function stickslip_normal_solution_field

        ! Writes the scalar results of the contact.
        function stickslip_normal_solution_result(solution, result) result(answer) bind(c)
            import
            type(stickslip_normal_solution), value :: solution
            type(stickslip_normal_result), intent(out), optional :: result
            integer(c_int32_t) :: answer
        end function stickslip_normal_solution_result

        ! Writes the report of the solve.
        function stickslip_normal_solution_report(solution, report) result(answer) bind(c)
            import
            type(stickslip_normal_solution), value :: solution
            type(stickslip_report), intent(out), optional :: report
            integer(c_int32_t) :: answer
        end function stickslip_normal_solution_report

        ! Writes the warnings about the solution to a buffer of capacity entries, and their number to count. With a capacity of 0
        ! it writes only the number.
        function stickslip_normal_solution_warnings(solution, buffer, capacity, count) result(answer) bind(c)
            import
            type(stickslip_normal_solution), value :: solution
            type(stickslip_warning), intent(inout), optional :: buffer(*)
            integer(c_size_t), value :: capacity
            integer(c_size_t), intent(out), optional :: count
            integer(c_int32_t) :: answer
        end function stickslip_normal_solution_warnings

        ! Computes the stiffness of a normal contact. The bodies must be those of the solve.
        function stickslip_normal_solution_stiffness(solution, half_space, stiffness) result(answer) bind(c)
            import
            type(stickslip_normal_solution), value :: solution
            type(stickslip_half_space), value :: half_space
            type(stickslip_normal_stiffness), intent(out), optional :: stiffness
            integer(c_int32_t) :: answer
        end function stickslip_normal_solution_stiffness

        ! Computes the stiffness with an observer (may be NULL). The observer is called before every product with the operator and
        ! may end the call: the function then returns STICKSLIP_NOT_CONVERGED and leaves stiffness unchanged.
        function stickslip_normal_solution_stiffness_observed(solution, half_space, observer, &
            stiffness) result(answer) bind(c)
            import
            type(stickslip_normal_solution), value :: solution
            type(stickslip_half_space), value :: half_space
            type(stickslip_observer), intent(in), optional :: observer
            type(stickslip_normal_stiffness), intent(out), optional :: stiffness
            integer(c_int32_t) :: answer
        end function stickslip_normal_solution_stiffness_observed

        ! Creates planes at count depths (lengths, zero or positive, copied) below the surface of either body. In coated bodies
        ! the planes may lie in the layers or below them. Displacements are also computed if with_displacements is nonzero. The
        ! kernels of a depth are computed at the first solve at that depth and kept. They need 112 bytes for each cell (152 with
        ! displacements), and in coated bodies 144 bytes (216 with displacements).
        function stickslip_planes_new(half_space, depths, count, with_displacements, planes) result(answer) bind(c)
            import
            type(stickslip_half_space), value :: half_space
            real(c_double), intent(in) :: depths(*)
            integer(c_size_t), value :: count
            integer(c_int32_t), value :: with_displacements
            type(stickslip_planes), intent(out) :: planes
            integer(c_int32_t) :: answer
        end function stickslip_planes_new

        ! Frees planes; does nothing if the pointer is NULL.
        function stickslip_planes_free(planes) result(answer) bind(c)
            import
            type(stickslip_planes), value :: planes
            integer(c_int32_t) :: answer
        end function stickslip_planes_free

        ! Solves the plane at the depth with number index, counted from zero, in body STICKSLIP_BODY_1 or STICKSLIP_BODY_2, by
        ! fast Fourier transforms. Returns STICKSLIP_LENGTH if index is not less than the number of depths, and
        ! STICKSLIP_RIGID_BODY for a rigid body. A failure leaves the last solved plane unchanged.
        function stickslip_planes_solve(planes, index, which, tractions) result(answer) bind(c)
            import
            type(stickslip_planes), value :: planes
            integer(c_size_t), value :: index
            integer(c_int32_t), value :: which
            type(stickslip_tractions), intent(in), optional :: tractions
            integer(c_int32_t) :: answer
        end function stickslip_planes_solve

        ! Solves a plane with an observer (may be NULL), like stickslip_planes_solve. The observer is called before the
        ! kernels are sampled, and before each transform of a kernel or of three components. It may end the call, which then
        ! returns STICKSLIP_NOT_CONVERGED. An observed call needs memory for an additional plane.
        function stickslip_planes_solve_observed(planes, index, which, tractions, observer) result(answer) bind(c)
            import
            type(stickslip_planes), value :: planes
            integer(c_size_t), value :: index
            integer(c_int32_t), value :: which
            type(stickslip_tractions), intent(in), optional :: tractions
            type(stickslip_observer), intent(in), optional :: observer
            integer(c_int32_t) :: answer
        end function stickslip_planes_solve_observed

        ! Returns a field of the last solved plane and writes its number of cells to count (may be NULL); returns NULL on failure.
        ! The field is STICKSLIP_STRESS_XX to STICKSLIP_STRESS_YZ or, for planes with displacements, STICKSLIP_DISPLACEMENT_X to
        ! STICKSLIP_DISPLACEMENT_Z.
        function stickslip_planes_field(planes, which, count) result(answer) bind(c)
            import
            type(stickslip_planes), value :: planes
            integer(c_int32_t), value :: which
            integer(c_size_t), intent(out), optional :: count
            type(c_ptr) :: answer
        end function stickslip_planes_field

        ! Writes the warnings about the last solved plane, like stickslip_normal_solution_warnings. Pointers to tractions contain no
        ! status, so a plane cannot warn of a solution that has not converged.
        function stickslip_planes_warnings(planes, buffer, capacity, count) result(answer) bind(c)
            import
            type(stickslip_planes), value :: planes
            type(stickslip_warning), intent(inout), optional :: buffer(*)
            integer(c_size_t), value :: capacity
            integer(c_size_t), intent(out), optional :: count
            integer(c_int32_t) :: answer
        end function stickslip_planes_warnings

        ! Writes STICKSLIP_VON_MISES, STICKSLIP_MAX_SHEAR or STICKSLIP_HYDROSTATIC of each cell of the last solved plane to
        ! values, which has count entries.
        function stickslip_planes_measure(planes, which, values, count) result(answer) bind(c)
            import
            type(stickslip_planes), value :: planes
            integer(c_int32_t), value :: which
            real(c_double), intent(inout) :: values(*)
            integer(c_size_t), value :: count
            integer(c_int32_t) :: answer
        end function stickslip_planes_measure

        ! Returns memory for a given number of words of a received block, or NULL if memory is exhausted. The swap function
        ! must fill this memory before it returns. Only a stickslip_swap may call this function, with the block that it was
        ! given.
        function stickslip_block_room(block, words) result(answer) bind(c)
            import
            type(stickslip_block), value :: block
            integer(c_size_t), value :: words
            type(c_ptr) :: answer
        end function stickslip_block_room

        ! Returns the default options of a rolling solver.
        function stickslip_rolling_options_default() result(answer) bind(c)
            import
            type(stickslip_rolling_options) :: answer
        end function stickslip_rolling_options_default

        ! Creates a solver under the pressure of a solved normal contact on the same bodies. The grid must extend beyond the
        ! leading edge of the contact by the cells of one step; otherwise the call returns STICKSLIP_GRID_TOO_SHORT. The entry rule
        ! uses two more cells; if they are missing, its slopes of the gap are one-sided. load and options may be NULL. A NULL load
        ! means no creepage and no spin, and NULL options mean the defaults.
        function stickslip_rolling_solver_new(half_space, normal, friction, load, options, &
            solver) result(answer) bind(c)
            import
            type(stickslip_half_space), value :: half_space
            type(stickslip_normal_solution), value :: normal
            type(stickslip_friction), intent(in), optional :: friction
            type(stickslip_rolling_load), intent(in), optional :: load
            type(stickslip_rolling_options), intent(in), optional :: options
            type(stickslip_rolling_solver), intent(out) :: solver
            integer(c_int32_t) :: answer
        end function stickslip_rolling_solver_new

        ! Frees a solver; does nothing if it is NULL.
        function stickslip_rolling_solver_free(solver) result(answer) bind(c)
            import
            type(stickslip_rolling_solver), value :: solver
            integer(c_int32_t) :: answer
        end function stickslip_rolling_solver_free

        ! Sets the load of the next solve. Returns STICKSLIP_BEYOND_FRICTION_CAPACITY for a force or a moment that friction cannot
        ! carry, or can carry only by sliding.
        function stickslip_rolling_solver_set_load(solver, load) result(answer) bind(c)
            import
            type(stickslip_rolling_solver), value :: solver
            type(stickslip_rolling_load), intent(in), optional :: load
            integer(c_int32_t) :: answer
        end function stickslip_rolling_solver_set_load

        ! Sets the friction of the next solve. Returns STICKSLIP_BEYOND_FRICTION_CAPACITY if the new friction cannot carry the
        ! current load, or can carry it only by sliding. Until that solve, the stiffness returns STICKSLIP_OUTDATED_SOLUTION.
        function stickslip_rolling_solver_set_friction(solver, friction) result(answer) bind(c)
            import
            type(stickslip_rolling_solver), value :: solver
            type(stickslip_friction), intent(in), optional :: friction
            integer(c_int32_t) :: answer
        end function stickslip_rolling_solver_set_friction

        ! Sets the pressure of the next solve to that of a solved normal contact on the same bodies. The call allocates
        ! nothing if the contact lies within the largest window so far. Returns STICKSLIP_BEYOND_FRICTION_CAPACITY if friction
        ! can no longer carry the prescribed force.
        function stickslip_rolling_solver_set_normal(solver, normal) result(answer) bind(c)
            import
            type(stickslip_rolling_solver), value :: solver
            type(stickslip_normal_solution), value :: normal
            integer(c_int32_t) :: answer
        end function stickslip_rolling_solver_set_normal

        ! Sets the pressure of the next solve to the given values (count entries, copied). No gap belongs to these values, so
        ! the call returns STICKSLIP_UNSUPPORTED_BY_MODEL unless the solver uses STICKSLIP_WHOLE_STEP.
        function stickslip_rolling_solver_set_pressure(solver, pressure, count) result(answer) bind(c)
            import
            type(stickslip_rolling_solver), value :: solver
            real(c_double), intent(in) :: pressure(*)
            integer(c_size_t), value :: count
            integer(c_int32_t) :: answer
        end function stickslip_rolling_solver_set_pressure

        ! Sets the normal solver that computes the pressure of a new normal load. The solver is copied with its gap, hardness and
        ! settings: call this function again after each change of its gap. This call does not change the pressure.
        ! stickslip_rolling_solver_set_normal_load solves for the pressure over the gap of the normal solver, which may differ from the
        ! gap of the present pressure. Grid, boundary, cell values and materials must be equal. The normal solver need not have solved
        ! before.
        function stickslip_rolling_solver_set_normal_solver(solver, normal) result(answer) bind(c)
            import
            type(stickslip_rolling_solver), value :: solver
            type(stickslip_normal_solver), value :: normal
            integer(c_int32_t) :: answer
        end function stickslip_rolling_solver_set_normal_solver

        ! Sets the normal load of the next solve and solves for its pressure. Returns STICKSLIP_UNSUPPORTED_BY_MODEL if
        ! stickslip_rolling_solver_set_normal_solver has set no normal solver. The gap is that of the normal solver, not that of the
        ! last stickslip_rolling_solver_set_normal: after wear, set the normal solver again. After a failure the solver is unchanged.
        function stickslip_rolling_solver_set_normal_load(solver, load) result(answer) bind(c)
            import
            type(stickslip_rolling_solver), value :: solver
            type(stickslip_normal_load), intent(in), optional :: load
            integer(c_int32_t) :: answer
        end function stickslip_rolling_solver_set_normal_load

        ! Copies the normal contact that stickslip_rolling_solver_set_normal_load has computed to a normal solution on the same grid.
        ! Returns STICKSLIP_OUTDATED_SOLUTION before the first load and after another pressure was set. Returns STICKSLIP_GRID_MISMATCH for a solution on another grid. After a failure
        ! the solution is unchanged.
        function stickslip_rolling_solver_normal(solver, solution) result(answer) bind(c)
            import
            type(stickslip_rolling_solver), value :: solver
            type(stickslip_normal_solution), value :: solution
            integer(c_int32_t) :: answer
        end function stickslip_rolling_solver_normal

        ! Writes the largest tangential force that friction can carry.
        function stickslip_rolling_solver_friction_capacity(solver, capacity) result(answer) bind(c)
            import
            type(stickslip_rolling_solver), value :: solver
            real(c_double), intent(out), optional :: capacity
            integer(c_int32_t) :: answer
        end function stickslip_rolling_solver_friction_capacity

        ! Discards the last solution: the next solve starts as the first solve did, and the stiffness is that of a contact in full
        ! stick.
        function stickslip_rolling_solver_reset(solver) result(answer) bind(c)
            import
            type(stickslip_rolling_solver), value :: solver
            integer(c_int32_t) :: answer
        end function stickslip_rolling_solver_reset

        ! Sets the method, the tolerance and the limits of the next solve.
        function stickslip_rolling_solver_set_settings(solver, settings) result(answer) bind(c)
            import
            type(stickslip_rolling_solver), value :: solver
            type(stickslip_settings), intent(in), optional :: settings
            integer(c_int32_t) :: answer
        end function stickslip_rolling_solver_set_settings

        ! Solves into a solution of stickslip_rolling_solution_new for the same bodies. observer may be NULL.
        !
        ! After STICKSLIP_NOT_CONVERGED the solution contains the last feasible iterate and its report. Any other failure
        ! leaves the solution unchanged, with one exception: after STICKSLIP_MEMORY in the search for the spin of a prescribed
        ! moment, the solution is that of a different spin.
        function stickslip_rolling_solver_solve(solver, solution, observer) result(answer) bind(c)
            import
            type(stickslip_rolling_solver), value :: solver
            type(stickslip_rolling_solution), value :: solution
            type(stickslip_observer), intent(in), optional :: observer
            integer(c_int32_t) :: answer
        end function stickslip_rolling_solver_solve

        ! Computes the derivatives of the loads at the last solution. Stick cells follow the motion, and slip cells remain at
        ! their friction limits. Before the first solve all cells stick, and the derivatives are Kalker's coefficients times G
        ! a b and powers of the length (a b)^(1/2). Returns STICKSLIP_OUTDATED_SOLUTION if a load, the pressure or the friction has
        ! changed since the last solve, and STICKSLIP_NOT_CONVERGED if that solve has not converged.
        function stickslip_rolling_solver_stiffness(solver, stiffness) result(answer) bind(c)
            import
            type(stickslip_rolling_solver), value :: solver
            type(stickslip_rolling_stiffness), intent(out), optional :: stiffness
            integer(c_int32_t) :: answer
        end function stickslip_rolling_solver_stiffness

        ! Computes the stiffness with an observer (may be NULL). The observer is called before every product with an operator and
        ! may end the call: the function then returns STICKSLIP_NOT_CONVERGED and leaves stiffness unchanged.
        function stickslip_rolling_solver_stiffness_observed(solver, observer, stiffness) result(answer) bind(c)
            import
            type(stickslip_rolling_solver), value :: solver
            type(stickslip_observer), intent(in), optional :: observer
            type(stickslip_rolling_stiffness), intent(out), optional :: stiffness
            integer(c_int32_t) :: answer
        end function stickslip_rolling_solver_stiffness_observed

        ! Creates an empty solution of the right size for a solver.
        function stickslip_rolling_solution_new(solver, solution) result(answer) bind(c)
            import
            type(stickslip_rolling_solver), value :: solver
            type(stickslip_rolling_solution), intent(out) :: solution
            integer(c_int32_t) :: answer
        end function stickslip_rolling_solution_new

        ! Frees a solution; does nothing if it is NULL.
        function stickslip_rolling_solution_free(solution) result(answer) bind(c)
            import
            type(stickslip_rolling_solution), value :: solution
            integer(c_int32_t) :: answer
        end function stickslip_rolling_solution_free

        ! Returns a field, STICKSLIP_TRACTION_X, STICKSLIP_TRACTION_Y, STICKSLIP_SLIP_X or STICKSLIP_SLIP_Y, and writes its number
        ! of cells to count (may be NULL); returns NULL on failure. The slip is given per unit length rolled (dimensionless),
        ! averaged over the step that moved the particles to their cells.
        function stickslip_rolling_solution_field(solution, which, count) result(answer) bind(c)
            import
            type(stickslip_rolling_solution), value :: solution
            integer(c_int32_t), value :: which
            integer(c_size_t), intent(out), optional :: count
            type(c_ptr) :: answer
        end function stickslip_rolling_solution_field

        ! Returns the zone of every cell, STICKSLIP_SEPARATED, STICKSLIP_STICK or STICKSLIP_SLIP; returns NULL on failure.
        function stickslip_rolling_solution_zones(solution, count) result(answer) bind(c)
            import
            type(stickslip_rolling_solution), value :: solution
            integer(c_size_t), intent(out), optional :: count
            type(c_ptr) :: answer
        end function stickslip_rolling_solution_zones

        ! Writes the energy that slip dissipates in each cell per area and per length rolled (a pressure) to values, which has count
        ! entries. The cells are fixed in the contact, and the particles of both surfaces pass through them. The value of a cell is
        ! therefore not the wear of a particle. In each passage, a particle loses the wear coefficient times the sum of the values
        ! over the cells of its line along the rolling direction, times their side along this line. Add this depth to whole lines of
        ! the gap. A wheel with the circumference U makes L/U passages over the length L. Between bodies of the same material, the
        ! integral of this energy is smaller than the work of creepages and spin; the difference decreases with the cell size.
        function stickslip_rolling_solution_dissipation_per_area(solution, values, count) result(answer) bind(c)
            import
            type(stickslip_rolling_solution), value :: solution
            real(c_double), intent(inout) :: values(*)
            integer(c_size_t), value :: count
            integer(c_int32_t) :: answer
        end function stickslip_rolling_solution_dissipation_per_area

        ! Writes the scalar results of the contact.
        function stickslip_rolling_solution_result(solution, result) result(answer) bind(c)
            import
            type(stickslip_rolling_solution), value :: solution
            type(stickslip_rolling_result), intent(out), optional :: result
            integer(c_int32_t) :: answer
        end function stickslip_rolling_solution_result

        ! Writes the report of the solve.
        function stickslip_rolling_solution_report(solution, report) result(answer) bind(c)
            import
            type(stickslip_rolling_solution), value :: solution
            type(stickslip_report), intent(out), optional :: report
            integer(c_int32_t) :: answer
        end function stickslip_rolling_solution_report

        ! Writes the warnings about the solution, like stickslip_normal_solution_warnings.
        function stickslip_rolling_solution_warnings(solution, buffer, capacity, count) result(answer) bind(c)
            import
            type(stickslip_rolling_solution), value :: solution
            type(stickslip_warning), intent(inout), optional :: buffer(*)
            integer(c_size_t), value :: capacity
            integer(c_size_t), intent(out), optional :: count
            integer(c_int32_t) :: answer
        end function stickslip_rolling_solution_warnings

        ! Returns the default options of a self-affine surface; the caller must set the height or the slope.
        function stickslip_self_affine_default() result(answer) bind(c)
            import
            type(stickslip_self_affine) :: answer
        end function stickslip_self_affine_default

        ! Writes the heights of a random surface (lengths, positive out of the body, with zero mean) to heights, which has count
        ! entries. The gap between the surface and a plane is a constant minus the height.
        !
        ! Returns STICKSLIP_INVALID_ARGUMENT if both height and slope are given. Returns STICKSLIP_NOT_POSITIVE for an invalid
        ! height, slope or wavelength, STICKSLIP_HURST for an invalid exponent, and STICKSLIP_NOT_FINITE for an invalid skewness
        ! or kurtosis. Returns STICKSLIP_BELOW_MINIMUM if the cut-off is less than two cells, the longest wavelength is less than
        ! the roll-off, the roll-off is less than the cut-off, or the kurtosis is less than the squared skewness plus one. Returns
        ! STICKSLIP_NO_WAVE_IN_BAND if no wave has a wavelength within the limits, STICKSLIP_HEIGHT_MOMENTS_NOT_REACHED if no
        ! heights with this skewness and kurtosis are found, and STICKSLIP_SAMPLE for the first height that overflows. A failure
        ! leaves heights unchanged.
        function stickslip_surface_self_affine(grid, surface, heights, count) result(answer) bind(c)
            import
            type(stickslip_grid), intent(in), optional :: grid
            type(stickslip_self_affine), intent(in), optional :: surface
            real(c_double), intent(inout) :: heights(*)
            integer(c_size_t), value :: count
            integer(c_int32_t) :: answer
        end function stickslip_surface_self_affine

        ! Writes the heights of a random surface with an observer (may be NULL), like stickslip_surface_self_affine. The observer
        ! is called before each transform of the surface, including those of the iterations for skewness and kurtosis. It may end
        ! the call, which then returns STICKSLIP_NOT_CONVERGED.
        function stickslip_surface_self_affine_observed(grid, surface, observer, heights, count) result(answer) bind(c)
            import
            type(stickslip_grid), intent(in), optional :: grid
            type(stickslip_self_affine), intent(in), optional :: surface
            type(stickslip_observer), intent(in), optional :: observer
            real(c_double), intent(inout) :: heights(*)
            integer(c_size_t), value :: count
            integer(c_int32_t) :: answer
        end function stickslip_surface_self_affine_observed

        ! Computes the statistics of count heights (lengths) on a grid. Missing heights (NaN) have no weight; the spectral slope is
        ! then NaN. Returns STICKSLIP_SAMPLE for the first infinite height, STICKSLIP_INVALID_ARGUMENT if all heights are missing, and
        ! STICKSLIP_NOT_FINITE if the range of heights or the square of the slopes overflows.
        function stickslip_surface_statistics(grid, heights, count, statistics) result(answer) bind(c)
            import
            type(stickslip_grid), intent(in), optional :: grid
            real(c_double), intent(in) :: heights(*)
            integer(c_size_t), value :: count
            type(stickslip_statistics), intent(out), optional :: statistics
            integer(c_int32_t) :: answer
        end function stickslip_surface_statistics

        ! Writes the contact spots, in the order of their first cells, to buffer, and their number to count. With a NULL buffer
        ! and a capacity of 0 it writes only the number. If the buffer is too small, the call returns STICKSLIP_BUFFER_TOO_SMALL
        ! and writes nothing to it.
        !
        ! The array labels (of length cells) receives the number of the spot of every cell, counted from one, and zero outside the
        ! contact. This array may be NULL.
        function stickslip_normal_solution_spots(solution, buffer, capacity, count, labels, &
            cells) result(answer) bind(c)
            import
            type(stickslip_normal_solution), value :: solution
            type(stickslip_spot), intent(inout), optional :: buffer(*)
            integer(c_size_t), value :: capacity
            integer(c_size_t), intent(out), optional :: count
            integer(c_int32_t), intent(inout), optional :: labels(*)
            integer(c_size_t), value :: cells
            integer(c_int32_t) :: answer
        end function stickslip_normal_solution_spots

        ! Writes the contact spots under the pressure of a normal contact with the stick ratio of each, like
        ! stickslip_normal_solution_spots.
        function stickslip_tangential_solution_spots(solution, normal, buffer, capacity, count, labels, &
            cells) result(answer) bind(c)
            import
            type(stickslip_tangential_solution), value :: solution
            type(stickslip_normal_solution), value :: normal
            type(stickslip_spot), intent(inout), optional :: buffer(*)
            integer(c_size_t), value :: capacity
            integer(c_size_t), intent(out), optional :: count
            integer(c_int32_t), intent(inout), optional :: labels(*)
            integer(c_size_t), value :: cells
            integer(c_int32_t) :: answer
        end function stickslip_tangential_solution_spots

        ! Writes the contact spots after the last step with the stick ratio of each, like stickslip_normal_solution_spots.
        function stickslip_history_spots(history, buffer, capacity, count, labels, cells) result(answer) bind(c)
            import
            type(stickslip_history), value :: history
            type(stickslip_spot), intent(inout), optional :: buffer(*)
            integer(c_size_t), value :: capacity
            integer(c_size_t), intent(out), optional :: count
            integer(c_int32_t), intent(inout), optional :: labels(*)
            integer(c_size_t), value :: cells
            integer(c_int32_t) :: answer
        end function stickslip_history_spots

        ! Creates a copy of the state of a history. The guide page embedding states its number of bytes per cell.
        function stickslip_state_new(history, state) result(answer) bind(c)
            import
            type(stickslip_history), value :: history
            type(stickslip_state), intent(out) :: state
            integer(c_int32_t) :: answer
        end function stickslip_state_new

        ! Frees a state; does nothing if it is NULL.
        function stickslip_state_free(state) result(answer) bind(c)
            import
            type(stickslip_state), value :: state
            integer(c_int32_t) :: answer
        end function stickslip_state_free

        ! Overwrites a saved state with the current state of a history; the memory is reused.
        function stickslip_state_keep(state, history) result(answer) bind(c)
            import
            type(stickslip_state), value :: state
            type(stickslip_history), value :: history
            integer(c_int32_t) :: answer
        end function stickslip_state_keep

        ! Returns a history to a saved state of this history or of another history on equal bodies. The history then has no last
        ! step until its next step: functions that use the last step return STICKSLIP_NO_LAST_STEP. In a retry, restore the state,
        ! take a smaller step, and add this step to the cycle and to the wear.
        function stickslip_history_set_state(history, state) result(answer) bind(c)
            import
            type(stickslip_history), value :: history
            type(stickslip_state), value :: state
            integer(c_int32_t) :: answer
        end function stickslip_history_set_state

        ! Writes the state of a history as bytes. A history created from these bytes by stickslip_history_from_bytes takes
        ! further steps with bitwise identical results. The number of bytes for each cell is 57 (small contact, scalar model) to
        ! 137 (contact on the whole grid, vector model). Changes of the contact or the gap, values for each cell and a relative
        ! displacement add up to 80.
        !
        ! length receives the number of bytes. With a NULL buffer and a capacity of 0 only the number is written. If the buffer
        ! is too small, the call returns STICKSLIP_BUFFER_TOO_SMALL and writes nothing to it. A call without a buffer also
        ! creates the bytes.
        function stickslip_history_to_bytes(history, buffer, capacity, length) result(answer) bind(c)
            import
            type(stickslip_history), value :: history
            integer(c_int8_t), intent(inout), optional :: buffer(*)
            integer(c_size_t), value :: capacity
            integer(c_size_t), intent(out), optional :: length
            integer(c_int32_t) :: answer
        end function stickslip_history_to_bytes

        ! Creates a history from bytes of stickslip_history_to_bytes, on the bodies of the original history. Returns
        ! STICKSLIP_FORMAT for damaged bytes.
        function stickslip_history_from_bytes(half_space, bytes, length, history) result(answer) bind(c)
            import
            type(stickslip_half_space), value :: half_space
            integer(c_int8_t), intent(in), optional :: bytes(*)
            integer(c_size_t), value :: length
            type(stickslip_history), intent(out) :: history
            integer(c_int32_t) :: answer
        end function stickslip_history_from_bytes

        ! Returns the default options of a stiffness.
        function stickslip_stiffness_options_default() result(answer) bind(c)
            import
            type(stickslip_stiffness_options) :: answer
        end function stickslip_stiffness_options_default

        ! Creates a workspace without buffers, for histories on any grid. options may be NULL (the defaults).
        function stickslip_stiffness_workspace_new(options, workspace) result(answer) bind(c)
            import
            type(stickslip_stiffness_options), intent(in), optional :: options
            type(stickslip_stiffness_workspace), intent(out) :: workspace
            integer(c_int32_t) :: answer
        end function stickslip_stiffness_workspace_new

        ! Frees a workspace; does nothing if it is NULL.
        function stickslip_stiffness_workspace_free(workspace) result(answer) bind(c)
            import
            type(stickslip_stiffness_workspace), value :: workspace
            integer(c_int32_t) :: answer
        end function stickslip_stiffness_workspace_free

        ! Sets the options of the next stiffness. The workspace keeps its buffers.
        function stickslip_stiffness_workspace_set_options(workspace, options) result(answer) bind(c)
            import
            type(stickslip_stiffness_workspace), value :: workspace
            type(stickslip_stiffness_options), intent(in), optional :: options
            integer(c_int32_t) :: answer
        end function stickslip_stiffness_workspace_set_options

        ! Writes the report of the last stiffness. Iterations and products are the sums over all linear problems. Residual and
        ! status belong to the last problem. The time is not measured.
        function stickslip_stiffness_workspace_report(workspace, report) result(answer) bind(c)
            import
            type(stickslip_stiffness_workspace), value :: workspace
            type(stickslip_report), intent(out), optional :: report
            integer(c_int32_t) :: answer
        end function stickslip_stiffness_workspace_report

        ! Computes the stiffness like stickslip_history_stiffness_observed, with the options and the buffers of a workspace. A call
        ! that needs no larger buffers than the last one allocates nothing. observer may be NULL.
        function stickslip_history_stiffness_with(history, workspace, observer, stiffness) result(answer) bind(c)
            import
            type(stickslip_history), value :: history
            type(stickslip_stiffness_workspace), value :: workspace
            type(stickslip_observer), intent(in), optional :: observer
            type(stickslip_stiffness), intent(out), optional :: stiffness
            integer(c_int32_t) :: answer
        end function stickslip_history_stiffness_with

        ! Computes displacement and stress of body STICKSLIP_BODY_1 or STICKSLIP_BODY_2 at count points and writes them to
        ! responses. The body must not be coated. The sums over all loaded cells are exact for a uniform traction on each cell.
        ! Returns STICKSLIP_RIGID_BODY for a rigid body, STICKSLIP_INVALID_ARGUMENT for a coated body, and
        ! STICKSLIP_DIVERGENT_PERIODIC_SUM on a grid that is periodic along both axes. Use stickslip_planes_solve for coated
        ! bodies, for periodic grids and for whole planes.
        function stickslip_stress_at_points(half_space, which, tractions, points, count, &
            responses) result(answer) bind(c)
            import
            type(stickslip_half_space), value :: half_space
            integer(c_int32_t), value :: which
            type(stickslip_tractions), intent(in), optional :: tractions
            type(stickslip_point), intent(in), optional :: points(*)
            integer(c_size_t), value :: count
            type(stickslip_response), intent(inout), optional :: responses(*)
            integer(c_int32_t) :: answer
        end function stickslip_stress_at_points

        ! Computes displacement and stress at points with an observer (may be NULL), like stickslip_stress_at_points. The observer
        ! is called before each portion of the points and may end the call: the function then returns STICKSLIP_NOT_CONVERGED and
        ! leaves responses unchanged.
        function stickslip_stress_at_points_observed(half_space, which, tractions, points, count, observer, &
            responses) result(answer) bind(c)
            import
            type(stickslip_half_space), value :: half_space
            integer(c_int32_t), value :: which
            type(stickslip_tractions), intent(in), optional :: tractions
            type(stickslip_point), intent(in), optional :: points(*)
            integer(c_size_t), value :: count
            type(stickslip_observer), intent(in), optional :: observer
            type(stickslip_response), intent(inout), optional :: responses(*)
            integer(c_int32_t) :: answer
        end function stickslip_stress_at_points_observed

        ! Writes the gap between a sphere and a plane that touch at the origin (lengths) to gap, which has count entries.
        function stickslip_surface_sphere(grid, radius, gap, count) result(answer) bind(c)
            import
            type(stickslip_grid), intent(in), optional :: grid
            real(c_double), value :: radius
            real(c_double), intent(inout) :: gap(*)
            integer(c_size_t), value :: count
            integer(c_int32_t) :: answer
        end function stickslip_surface_sphere

        ! Writes the gap between an ellipsoid with the radii of curvature radius_x and radius_y at the origin, and a plane.
        function stickslip_surface_ellipsoid(grid, radius_x, radius_y, gap, count) result(answer) bind(c)
            import
            type(stickslip_grid), intent(in), optional :: grid
            real(c_double), value :: radius_x
            real(c_double), value :: radius_y
            real(c_double), intent(inout) :: gap(*)
            integer(c_size_t), value :: count
            integer(c_int32_t) :: answer
        end function stickslip_surface_ellipsoid

        ! Writes the gap between a cylinder along y and a plane.
        function stickslip_surface_cylinder(grid, radius, gap, count) result(answer) bind(c)
            import
            type(stickslip_grid), intent(in), optional :: grid
            real(c_double), value :: radius
            real(c_double), intent(inout) :: gap(*)
            integer(c_size_t), value :: count
            integer(c_int32_t) :: answer
        end function stickslip_surface_cylinder

        ! Returns the default options of a tangential solver.
        function stickslip_tangential_options_default() result(answer) bind(c)
            import
            type(stickslip_tangential_options) :: answer
        end function stickslip_tangential_options_default

        ! Creates a solver under the pressure of a solved normal contact on the same bodies. options may be NULL (the defaults).
        function stickslip_tangential_solver_new(half_space, normal, friction, load, options, &
            solver) result(answer) bind(c)
            import
            type(stickslip_half_space), value :: half_space
            type(stickslip_normal_solution), value :: normal
            type(stickslip_friction), intent(in), optional :: friction
            type(stickslip_tangential_load), intent(in), optional :: load
            type(stickslip_tangential_options), intent(in), optional :: options
            type(stickslip_tangential_solver), intent(out) :: solver
            integer(c_int32_t) :: answer
        end function stickslip_tangential_solver_new

        ! Creates a solver under a given pressure (count entries, zero or positive, copied). options may be NULL (the defaults).
        function stickslip_tangential_solver_new_under(half_space, pressure, count, friction, load, options, &
            solver) result(answer) bind(c)
            import
            type(stickslip_half_space), value :: half_space
            real(c_double), intent(in) :: pressure(*)
            integer(c_size_t), value :: count
            type(stickslip_friction), intent(in), optional :: friction
            type(stickslip_tangential_load), intent(in), optional :: load
            type(stickslip_tangential_options), intent(in), optional :: options
            type(stickslip_tangential_solver), intent(out) :: solver
            integer(c_int32_t) :: answer
        end function stickslip_tangential_solver_new_under

        ! Frees a solver; does nothing if it is NULL.
        function stickslip_tangential_solver_free(solver) result(answer) bind(c)
            import
            type(stickslip_tangential_solver), value :: solver
            integer(c_int32_t) :: answer
        end function stickslip_tangential_solver_free

        ! Sets the load of the next solve.
        function stickslip_tangential_solver_set_load(solver, load) result(answer) bind(c)
            import
            type(stickslip_tangential_solver), value :: solver
            type(stickslip_tangential_load), intent(in), optional :: load
            integer(c_int32_t) :: answer
        end function stickslip_tangential_solver_set_load

        ! Sets the friction of the next solve.
        function stickslip_tangential_solver_set_friction(solver, friction) result(answer) bind(c)
            import
            type(stickslip_tangential_solver), value :: solver
            type(stickslip_friction), intent(in), optional :: friction
            integer(c_int32_t) :: answer
        end function stickslip_tangential_solver_set_friction

        ! Sets the pressure of the next solve to the pressure of a solved normal contact.
        function stickslip_tangential_solver_set_normal(solver, normal) result(answer) bind(c)
            import
            type(stickslip_tangential_solver), value :: solver
            type(stickslip_normal_solution), value :: normal
            integer(c_int32_t) :: answer
        end function stickslip_tangential_solver_set_normal

        ! Sets the pressure of the next solve to the given values (count entries, copied).
        function stickslip_tangential_solver_set_pressure(solver, pressure, count) result(answer) bind(c)
            import
            type(stickslip_tangential_solver), value :: solver
            real(c_double), intent(in) :: pressure(*)
            integer(c_size_t), value :: count
            integer(c_int32_t) :: answer
        end function stickslip_tangential_solver_set_pressure

        ! Sets the relative displacement of the next solve.
        function stickslip_tangential_solver_set_relative_displacement(solver, relative) result(answer) bind(c)
            import
            type(stickslip_tangential_solver), value :: solver
            type(stickslip_relative_displacement), intent(in), optional :: relative
            integer(c_int32_t) :: answer
        end function stickslip_tangential_solver_set_relative_displacement

        ! Sets the method, the tolerance and the limits of the next solve.
        function stickslip_tangential_solver_set_settings(solver, settings) result(answer) bind(c)
            import
            type(stickslip_tangential_solver), value :: solver
            type(stickslip_settings), intent(in), optional :: settings
            integer(c_int32_t) :: answer
        end function stickslip_tangential_solver_set_settings

        ! Discards the last solution: the next solve starts as the first solve did.
        function stickslip_tangential_solver_reset(solver) result(answer) bind(c)
            import
            type(stickslip_tangential_solver), value :: solver
            integer(c_int32_t) :: answer
        end function stickslip_tangential_solver_reset

        ! Writes the largest tangential force that friction can carry.
        function stickslip_tangential_solver_friction_capacity(solver, capacity) result(answer) bind(c)
            import
            type(stickslip_tangential_solver), value :: solver
            real(c_double), intent(out), optional :: capacity
            integer(c_int32_t) :: answer
        end function stickslip_tangential_solver_friction_capacity

        ! Solves into a solution of stickslip_tangential_solution_new for the same bodies. observer may be NULL.
        !
        ! After STICKSLIP_NOT_CONVERGED the solution contains the last feasible iterate and its report. Any other failure leaves
        ! the solution unchanged.
        function stickslip_tangential_solver_solve(solver, solution, observer) result(answer) bind(c)
            import
            type(stickslip_tangential_solver), value :: solver
            type(stickslip_tangential_solution), value :: solution
            type(stickslip_observer), intent(in), optional :: observer
            integer(c_int32_t) :: answer
        end function stickslip_tangential_solver_solve

        ! Creates an empty solution of the right size for a solver.
        function stickslip_tangential_solution_new(solver, solution) result(answer) bind(c)
            import
            type(stickslip_tangential_solver), value :: solver
            type(stickslip_tangential_solution), intent(out) :: solution
            integer(c_int32_t) :: answer
        end function stickslip_tangential_solution_new

        ! Frees a solution; does nothing if it is NULL.
        function stickslip_tangential_solution_free(solution) result(answer) bind(c)
            import
            type(stickslip_tangential_solution), value :: solution
            integer(c_int32_t) :: answer
        end function stickslip_tangential_solution_free

        ! Returns a field, STICKSLIP_TRACTION_X, STICKSLIP_TRACTION_Y, STICKSLIP_SLIP_X or STICKSLIP_SLIP_Y, and writes its number
        ! of cells to count (may be NULL); returns NULL on failure.
        function stickslip_tangential_solution_field(solution, which, count) result(answer) bind(c)
            import
            type(stickslip_tangential_solution), value :: solution
            integer(c_int32_t), value :: which
            integer(c_size_t), intent(out), optional :: count
            type(c_ptr) :: answer
        end function stickslip_tangential_solution_field

        ! Returns the zone of every cell, STICKSLIP_SEPARATED, STICKSLIP_STICK or STICKSLIP_SLIP; returns NULL on failure.
        function stickslip_tangential_solution_zones(solution, count) result(answer) bind(c)
            import
            type(stickslip_tangential_solution), value :: solution
            integer(c_size_t), intent(out), optional :: count
            type(c_ptr) :: answer
        end function stickslip_tangential_solution_zones

        ! Writes the scalar results of the contact.
        function stickslip_tangential_solution_result(solution, result) result(answer) bind(c)
            import
            type(stickslip_tangential_solution), value :: solution
            type(stickslip_tangential_result), intent(out), optional :: result
            integer(c_int32_t) :: answer
        end function stickslip_tangential_solution_result

        ! Writes the report of the solve.
        function stickslip_tangential_solution_report(solution, report) result(answer) bind(c)
            import
            type(stickslip_tangential_solution), value :: solution
            type(stickslip_report), intent(out), optional :: report
            integer(c_int32_t) :: answer
        end function stickslip_tangential_solution_report

        ! Writes the warnings about the solution, like stickslip_normal_solution_warnings.
        function stickslip_tangential_solution_warnings(solution, buffer, capacity, count) result(answer) bind(c)
            import
            type(stickslip_tangential_solution), value :: solution
            type(stickslip_warning), intent(inout), optional :: buffer(*)
            integer(c_size_t), value :: capacity
            integer(c_size_t), intent(out), optional :: count
            integer(c_int32_t) :: answer
        end function stickslip_tangential_solution_warnings

        ! Computes the stiffness of a tangential contact. The bodies must be those of the solve.
        function stickslip_tangential_solution_stiffness(solution, half_space, stiffness) result(answer) bind(c)
            import
            type(stickslip_tangential_solution), value :: solution
            type(stickslip_half_space), value :: half_space
            type(stickslip_tangential_stiffness), intent(out), optional :: stiffness
            integer(c_int32_t) :: answer
        end function stickslip_tangential_solution_stiffness

        ! Computes the stiffness with an observer (may be NULL). The observer is called before every product with the operator and
        ! may end the call: the function then returns STICKSLIP_NOT_CONVERGED and leaves stiffness unchanged.
        function stickslip_tangential_solution_stiffness_observed(solution, half_space, observer, &
            stiffness) result(answer) bind(c)
            import
            type(stickslip_tangential_solution), value :: solution
            type(stickslip_half_space), value :: half_space
            type(stickslip_observer), intent(in), optional :: observer
            type(stickslip_tangential_stiffness), intent(out), optional :: stiffness
            integer(c_int32_t) :: answer
        end function stickslip_tangential_solution_stiffness_observed

        ! Sets the number of threads, at most 1024, that solve batches and contacts of more than 4096 cells, starting with the next call. A count
        ! of 0 means the default: the value of RAYON_NUM_THREADS at its first use, or one thread for each processor if it is not set. With a count
        ! of 1, the calling thread does all work, and no other thread is ever started. Running calls keep their threads. Results
        ! are bitwise identical for any number of threads.
        !
        ! Threads do not survive a fork: a child process creates the same number of threads at its first call that uses them.
        function stickslip_set_num_threads(count) result(answer) bind(c)
            import
            integer(c_size_t), value :: count
            integer(c_int32_t) :: answer
        end function stickslip_set_num_threads

        ! Returns the version of the running library as "major.minor.patch"; the string is valid as long as the program runs.
        function stickslip_version() result(answer) bind(c)
            import
            type(c_ptr) :: answer
        end function stickslip_version

        ! Returns STICKSLIP_ABI_VERSION of the running library.
        function stickslip_abi_version() result(answer) bind(c)
            import
            integer(c_int32_t) :: answer
        end function stickslip_abi_version

        ! Adds to depth (lengths, count entries) the depth that Archard's law removes in the last step: coefficient (one over a
        ! pressure) times pressure times slip. A failure leaves depth unchanged, for example STICKSLIP_NO_LAST_STEP after
        ! stickslip_history_set_state.
        function stickslip_wear_archard(history, coefficient, depth, count) result(answer) bind(c)
            import
            type(stickslip_history), value :: history
            type(stickslip_per_cell), intent(in), optional :: coefficient
            real(c_double), intent(inout) :: depth(*)
            integer(c_size_t), value :: count
            integer(c_int32_t) :: answer
        end function stickslip_wear_archard

        ! Adds to depth the depth that the energy law removes in the last step: coefficient (one over a pressure) times the
        ! dissipated energy per area. Fails like stickslip_wear_archard.
        function stickslip_wear_energy(history, coefficient, depth, count) result(answer) bind(c)
            import
            type(stickslip_history), value :: history
            type(stickslip_per_cell), intent(in), optional :: coefficient
            real(c_double), intent(inout) :: depth(*)
            integer(c_size_t), value :: count
            integer(c_int32_t) :: answer
        end function stickslip_wear_energy

        ! Adds to depth the depth that the energy law with a threshold removes in the last step. Only the part of the energy
        ! dissipated per area since the start that exceeds the threshold (an energy per area) causes wear. Fails like
        ! stickslip_wear_archard.
        function stickslip_wear_threshold_energy(history, coefficient, threshold, depth, count) result(answer) bind(c)
            import
            type(stickslip_history), value :: history
            type(stickslip_per_cell), intent(in), optional :: coefficient
            real(c_double), value :: threshold
            real(c_double), intent(inout) :: depth(*)
            integer(c_size_t), value :: count
            integer(c_int32_t) :: answer
        end function stickslip_wear_threshold_energy
    end interface
end module stickslip_bindings
