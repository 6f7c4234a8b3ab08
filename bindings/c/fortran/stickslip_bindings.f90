! The interface of stickslip.h for Fortran, made from it by make_bindings.py: do not edit. The rules at the head of
! stickslip.h hold here too. Each kind of object has a type, the pointer of C; an optional argument that is left out is
! NULL; a matrix has its column first. Members of structs begin with their defaults. The module stickslip has types that
! free themselves.
module stickslip_bindings
    use, intrinsic :: iso_c_binding
    implicit none
    private

    public :: stickslip_adaptive_steps_new
    public :: stickslip_adaptive_steps_free
    public :: stickslip_adaptive_steps_step
    public :: stickslip_adaptive_steps_error
    public :: stickslip_hertz_sphere
    public :: stickslip_cattaneo_mindlin_sphere
    public :: stickslip_carter_cylinder
    public :: stickslip_bentall_johnson_cylinder
    public :: stickslip_kalker_coefficients
    public :: stickslip_vermeulen_johnson_ellipse
    public :: stickslip_history_step_all
    public :: stickslip_coupled_solver_new
    public :: stickslip_coupled_solver_free
    public :: stickslip_coupled_solver_set_load
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
    public :: stickslip_rolling_solver_friction_capacity
    public :: stickslip_rolling_solver_reset
    public :: stickslip_rolling_solver_set_settings
    public :: stickslip_rolling_solver_solve
    public :: stickslip_rolling_solver_stiffness
    public :: stickslip_rolling_solver_stiffness_observed
    public :: stickslip_rolling_solver_creep_forces
    public :: stickslip_rolling_solver_creep_forces_observed
    public :: stickslip_rolling_solution_new
    public :: stickslip_rolling_solution_free
    public :: stickslip_rolling_solution_field
    public :: stickslip_rolling_solution_zones
    public :: stickslip_rolling_solution_dissipation
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

    ! No cell slipped.
    integer(c_int32_t), parameter, public :: STICKSLIP_FULL_STICK = 0
    ! Some cells slipped, but some stuck at the end of each step.
    integer(c_int32_t), parameter, public :: STICKSLIP_PARTIAL_SLIP = 1
    ! The whole contact was at its friction limit at the end of a step.
    integer(c_int32_t), parameter, public :: STICKSLIP_GROSS_SLIP = 2
    ! Pressure, zero outside the contact.
    integer(c_int32_t), parameter, public :: STICKSLIP_PRESSURE = 0
    ! Gap under load (lengths).
    integer(c_int32_t), parameter, public :: STICKSLIP_GAP = 1
    ! Shear traction along x that body 2 exerts on body 1 (pressures).
    integer(c_int32_t), parameter, public :: STICKSLIP_TRACTION_X = 2
    ! Shear traction along y.
    integer(c_int32_t), parameter, public :: STICKSLIP_TRACTION_Y = 3
    ! Slip along x (lengths), the motion of the surface of body 1 over that of body 2; of a history the sum of all steps.
    integer(c_int32_t), parameter, public :: STICKSLIP_SLIP_X = 4
    ! Slip along y.
    integer(c_int32_t), parameter, public :: STICKSLIP_SLIP_Y = 5
    ! Displacement by pressure and tractions together along x (lengths): of coupled solutions that of body 1 relative to body 2,
    ! of planes below the surface that of the body.
    integer(c_int32_t), parameter, public :: STICKSLIP_DISPLACEMENT_X = 6
    ! The same along y.
    integer(c_int32_t), parameter, public :: STICKSLIP_DISPLACEMENT_Y = 7
    ! The same along z; of coupled solutions the sum of both bodies.
    integer(c_int32_t), parameter, public :: STICKSLIP_DISPLACEMENT_Z = 8
    ! Length of the path slipped, in all steps of a history or in those of a cycle (lengths).
    integer(c_int32_t), parameter, public :: STICKSLIP_SLIP_DISTANCE = 9
    ! Energy that each cell has dissipated, in all steps of a history or in those of a cycle.
    integer(c_int32_t), parameter, public :: STICKSLIP_DISSIPATED_ENERGY = 10
    ! Gap of a history before loading, as last set (lengths).
    integer(c_int32_t), parameter, public :: STICKSLIP_INITIAL_GAP = 11
    ! Slip along x of the last step of a history (lengths).
    integer(c_int32_t), parameter, public :: STICKSLIP_STEP_SLIP_X = 12
    ! Slip along y of the last step.
    integer(c_int32_t), parameter, public :: STICKSLIP_STEP_SLIP_Y = 13
    ! Length of the slip of the last step.
    integer(c_int32_t), parameter, public :: STICKSLIP_STEP_SLIP_DISTANCE = 14
    ! Energy that each cell dissipated in the last step, by its traction at the end.
    integer(c_int32_t), parameter, public :: STICKSLIP_STEP_DISSIPATED_ENERGY = 15
    ! Energy that each cell dissipated in the last step, by the mean of its tractions: the measure that closes the balance.
    integer(c_int32_t), parameter, public :: STICKSLIP_STEP_MID_DISSIPATED_ENERGY = 16
    ! What has yielded for good, added to the gap (lengths); histories with a permanent set only.
    integer(c_int32_t), parameter, public :: STICKSLIP_YIELDED_DEPTH = 17
    ! Mean pressure while slipping, weighted by the slip; cycles only.
    integer(c_int32_t), parameter, public :: STICKSLIP_SLIP_PRESSURE = 18
    ! Amplitude of the slip along x; cycles only (lengths).
    integer(c_int32_t), parameter, public :: STICKSLIP_SLIP_AMPLITUDE_X = 19
    ! Amplitude of the slip along y; cycles only.
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
    ! Von Mises' equivalent stress (pressures), for stickslip_planes_measure.
    integer(c_int32_t), parameter, public :: STICKSLIP_VON_MISES = 27
    ! Largest shear stress (pressures), for stickslip_planes_measure: half the difference of the largest and the smallest principal stress.
    integer(c_int32_t), parameter, public :: STICKSLIP_MAX_SHEAR = 28
    ! Mean of the normal stresses (pressures, positive in tension), for stickslip_planes_measure.
    integer(c_int32_t), parameter, public :: STICKSLIP_HYDROSTATIC = 29
    ! Zone of a cell out of contact.
    integer(c_int8_t), parameter, public :: STICKSLIP_SEPARATED = 0
    ! Zone of a cell in contact, below the friction limit.
    integer(c_int8_t), parameter, public :: STICKSLIP_STICK = 1
    ! Zone of a cell in contact, at the friction limit.
    integer(c_int8_t), parameter, public :: STICKSLIP_SLIP = 2
    ! Along x.
    integer(c_int32_t), parameter, public :: STICKSLIP_X = 0
    ! Along y.
    integer(c_int32_t), parameter, public :: STICKSLIP_Y = 1
    ! A cell that touches within a step follows its motion as far as it would if all that grows stuck (default).
    integer(c_int32_t), parameter, public :: STICKSLIP_SINCE_TOUCH = 0
    ! It follows all of the motion of the step.
    integer(c_int32_t), parameter, public :: STICKSLIP_WHOLE_STEP = 1
    ! The grid is a patch on infinite bodies.
    integer(c_int32_t), parameter, public :: STICKSLIP_NON_PERIODIC = 0
    ! The grid repeats along x and y.
    integer(c_int32_t), parameter, public :: STICKSLIP_PERIODIC = 1
    ! The grid repeats along y alone.
    integer(c_int32_t), parameter, public :: STICKSLIP_PERIODIC_ALONG_Y = 2
    ! The traction of a cell is uniform over it.
    integer(c_int32_t), parameter, public :: STICKSLIP_UNIFORM = 0
    ! The traction of a cell is that at its centre, and smooth between the centres.
    integer(c_int32_t), parameter, public :: STICKSLIP_CENTRE = 1
    ! Active sets, the default.
    integer(c_int32_t), parameter, public :: STICKSLIP_ACTIVE_SET = 0
    ! The loop of Polonsky and Keer, for pressure or for one traction.
    integer(c_int32_t), parameter, public :: STICKSLIP_POLONSKY_KEER = 1
    ! Hold: the pressure, the shift as it is.
    integer(c_int32_t), parameter, public :: STICKSLIP_HOLD = 0
    ! A force.
    integer(c_int32_t), parameter, public :: STICKSLIP_FORCE = 1
    ! The approach of the bodies (a length), from the datum of the gap.
    integer(c_int32_t), parameter, public :: STICKSLIP_APPROACH = 2
    ! The shift, the rigid motion of body 2 relative to body 1 (a length), since the unloaded state.
    integer(c_int32_t), parameter, public :: STICKSLIP_SHIFT = 3
    ! A spring that drags body 2: the force is stiffness * (value - shift).
    integer(c_int32_t), parameter, public :: STICKSLIP_SPRING = 4
    ! The traction along the load alone (default).
    integer(c_int32_t), parameter, public :: STICKSLIP_SCALAR = 0
    ! Both tractions, under loads of any direction.
    integer(c_int32_t), parameter, public :: STICKSLIP_VECTOR = 1
    ! Pressure and traction are found together: coupled solvers and histories only.
    integer(c_int32_t), parameter, public :: STICKSLIP_FULL = 0
    ! Shear does not change the pressure, but pressure moves the surfaces tangentially.
    integer(c_int32_t), parameter, public :: STICKSLIP_ONE_WAY = 1
    ! Neither moves the other.
    integer(c_int32_t), parameter, public :: STICKSLIP_NEGLECTED = 2
    ! Nothing has been solved yet.
    integer(c_int32_t), parameter, public :: STICKSLIP_UNSOLVED = 0
    ! A fresh product shows residual and certified error at or below the tolerance.
    integer(c_int32_t), parameter, public :: STICKSLIP_CONVERGED = 1
    ! The iteration limit was reached first.
    integer(c_int32_t), parameter, public :: STICKSLIP_AT_ITERATION_LIMIT = 2
    ! The time limit was reached first.
    integer(c_int32_t), parameter, public :: STICKSLIP_AT_TIME_LIMIT = 3
    ! The residual no longer falls: the tolerance is below round-off.
    integer(c_int32_t), parameter, public :: STICKSLIP_STALLED = 4
    ! The observer asked to stop.
    integer(c_int32_t), parameter, public :: STICKSLIP_CANCELLED = 5
    ! The smallest eigenvalue of an operator, on which a certified error rests, is not known. The bound of the error is then the
    ! root of the duality gap of the problem, and falls only with the root of the residual.
    integer(c_int32_t), parameter, public :: STICKSLIP_EIGENVALUE_UNKNOWN = 0
    ! It is known by an estimate on the safe side: of stiff coatings on long grids.
    integer(c_int32_t), parameter, public :: STICKSLIP_EIGENVALUE_ESTIMATED = 1
    ! It has a bound from below, which was computed.
    integer(c_int32_t), parameter, public :: STICKSLIP_EIGENVALUE_PROVEN = 2
    ! There is no contact.
    integer(c_int32_t), parameter, public :: STICKSLIP_WARNING_NO_CONTACT = 1
    ! Contact cells (cells) lie on the edge of the grid.
    integer(c_int32_t), parameter, public :: STICKSLIP_WARNING_CONTACT_AT_EDGE = 2
    ! Contact spots (cells) of all (of) are smaller than five cells, and have a tenth of the contact cells or more.
    integer(c_int32_t), parameter, public :: STICKSLIP_WARNING_UNRESOLVED_SPOTS = 3
    ! The grid is a line of cells that does not repeat.
    integer(c_int32_t), parameter, public :: STICKSLIP_WARNING_SINGLE_ROW_OF_CELLS = 4
    ! A contact spot runs across the whole grid.
    integer(c_int32_t), parameter, public :: STICKSLIP_WARNING_CONTACT_SPANS_GRID = 5
    ! Cells (cells) are pressed beyond the hardness that a material states.
    integer(c_int32_t), parameter, public :: STICKSLIP_WARNING_BEYOND_HARDNESS = 6
    ! The pressure was held although the gap had changed.
    integer(c_int32_t), parameter, public :: STICKSLIP_WARNING_STALE_PRESSURE = 7
    ! The contact has too few cells (cells).
    integer(c_int32_t), parameter, public :: STICKSLIP_WARNING_UNDERRESOLVED_CONTACT = 8
    ! Too few cells (cells) stick.
    integer(c_int32_t), parameter, public :: STICKSLIP_WARNING_UNDERRESOLVED_STICK_ZONE = 9
    ! The zone that slips is narrower than two cells, or than one cell in a step that rolls.
    integer(c_int32_t), parameter, public :: STICKSLIP_WARNING_UNDERRESOLVED_SLIP_ZONE = 10
    ! A coupled problem was pressed in one step.
    integer(c_int32_t), parameter, public :: STICKSLIP_WARNING_SINGLE_LOAD_STEP = 11
    ! The cells leave an error of more than 5 % in the pressure or the traction, by an estimate; 1 % needs so many (cells) on the
    ! radius of a contact spot.
    integer(c_int32_t), parameter, public :: STICKSLIP_WARNING_DISCRETISATION_ERROR = 12
    ! The approach exceeds the longest side of the grid.
    integer(c_int32_t), parameter, public :: STICKSLIP_WARNING_APPROACH_BEYOND_GRID = 13
    ! The contact radius exceeds 0.3 of the radius of curvature.
    integer(c_int32_t), parameter, public :: STICKSLIP_WARNING_LARGE_CONTACT_RADIUS = 14
    ! The rms slope of the surface within the contact exceeds 0.5.
    integer(c_int32_t), parameter, public :: STICKSLIP_WARNING_STEEP_SURFACE = 15
    ! A step of a history held the shift, and the tangential force fell by more than half.
    integer(c_int32_t), parameter, public :: STICKSLIP_WARNING_HELD_SHIFT_LOST_FORCE = 16
    ! Tractions of dissimilar bodies that roll change the pressure, and the change is neglected.
    integer(c_int32_t), parameter, public :: STICKSLIP_WARNING_NEGLECTED_LIFT = 17
    ! Any other: the message says which.
    integer(c_int32_t), parameter, public :: STICKSLIP_WARNING_OTHER = 127
    ! Bytes of the message of a warning.
    integer(c_int32_t), parameter, public :: STICKSLIP_WARNING_LENGTH = 384
    ! A creepage, what body 2 moves over body 1 for each length rolled (dimensionless).
    integer(c_int32_t), parameter, public :: STICKSLIP_CREEPAGE = 0
    ! A spin, the rotation of body 2 relative to body 1 about the origin of the grid for each length rolled (one over a
    ! length, positive from x to y).
    integer(c_int32_t), parameter, public :: STICKSLIP_SPIN = 0
    ! The moment on body 1 about the origin of the grid (a force times a length, positive from x to y).
    integer(c_int32_t), parameter, public :: STICKSLIP_MOMENT = 5
    ! Particles enter the contact at the largest x (default).
    integer(c_int32_t), parameter, public :: STICKSLIP_PLUS_X = 0
    ! At the smallest x.
    integer(c_int32_t), parameter, public :: STICKSLIP_MINUS_X = 1
    ! At the largest y.
    integer(c_int32_t), parameter, public :: STICKSLIP_PLUS_Y = 2
    ! At the smallest y.
    integer(c_int32_t), parameter, public :: STICKSLIP_MINUS_Y = 3
    ! Each wave has the amplitude of the spectrum, and only its phase is random (default).
    integer(c_int32_t), parameter, public :: STICKSLIP_EXACT = 0
    ! The amplitudes are random too, as of filtered white noise.
    integer(c_int32_t), parameter, public :: STICKSLIP_GAUSSIAN = 1
    ! Done.
    integer(c_int32_t), parameter, public :: STICKSLIP_OK = 0
    ! The tolerance was not reached, or the observer or a limit ended the solve. The solution holds the last feasible iterate
    ! and its report; a history is as it was, and stickslip_last_error_report has the report.
    integer(c_int32_t), parameter, public :: STICKSLIP_NOT_CONVERGED = 1
    ! The tangential force or moment (value) exceeds what friction can carry (limit): no equilibrium exists.
    integer(c_int32_t), parameter, public :: STICKSLIP_BEYOND_FRICTION_CAPACITY = 2
    ! The normal force (value) exceeds what the hardness lets the cells carry (limit).
    integer(c_int32_t), parameter, public :: STICKSLIP_BEYOND_HARDNESS = 3
    ! The bodies do not touch: there is nothing to load tangentially.
    integer(c_int32_t), parameter, public :: STICKSLIP_EMPTY_CONTACT = 4
    ! The approach (value) is not below the mean gap (limit) of a periodic contact.
    integer(c_int32_t), parameter, public :: STICKSLIP_APPROACH_BEYOND_MEAN_GAP = 5
    ! The materials couple pressure and traction (value: Dundurs' beta), and what was asked for does not model that.
    integer(c_int32_t), parameter, public :: STICKSLIP_COUPLED_MATERIALS = 6
    ! The model does not include this load (value).
    integer(c_int32_t), parameter, public :: STICKSLIP_UNSUPPORTED_BY_MODEL = 7
    ! The load has components along both axes, which the scalar model does not allow (value: along x, limit: along y).
    integer(c_int32_t), parameter, public :: STICKSLIP_OBLIQUE_LOAD = 8
    ! A load was cut into the shortest steps allowed, and the error of one (value) is still beyond its tolerance (limit).
    integer(c_int32_t), parameter, public :: STICKSLIP_STEP_TOO_LONG = 9
    ! Cells (index: how many) are at their hardness, where only elastic contacts have what was asked for.
    integer(c_int32_t), parameter, public :: STICKSLIP_YIELDED = 10
    ! A history that a cycle already counts, or of another step.
    integer(c_int32_t), parameter, public :: STICKSLIP_STEP_ALREADY_COUNTED = 11
    ! The cycle does not close: the residual of its loop (value) is more than what stands for those that follow (limit).
    integer(c_int32_t), parameter, public :: STICKSLIP_CYCLE_NOT_CLOSED = 12
    ! A handle or another pointer that is needed is NULL, or misaligned.
    integer(c_int32_t), parameter, public :: STICKSLIP_BAD_POINTER = 32
    ! The handle is in use by another thread; nothing was done.
    integer(c_int32_t), parameter, public :: STICKSLIP_BUSY = 33
    ! The number (value) is no constant of the kind that is needed there, or a struct has a member that this library does not
    ! know: reserved is not zero.
    integer(c_int32_t), parameter, public :: STICKSLIP_UNKNOWN_OPTION = 34
    ! The buffer has room for fewer entries (found) than there are (expected).
    integer(c_int32_t), parameter, public :: STICKSLIP_BUFFER_TOO_SMALL = 35
    ! Some contacts of a batch failed: the codes of each say why, the last error is that of the first (index).
    integer(c_int32_t), parameter, public :: STICKSLIP_SOME_FAILED = 36
    ! The threads cannot be made.
    integer(c_int32_t), parameter, public :: STICKSLIP_NO_THREADS = 37
    ! A defect of the library. The objects of the call can be freed, and should not be used otherwise.
    integer(c_int32_t), parameter, public :: STICKSLIP_PANIC = 38
    ! A grid needs at least one cell along each axis.
    integer(c_int32_t), parameter, public :: STICKSLIP_GRID_SIZE = 64
    ! Memory cannot be allocated, and none was.
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
    ! The cells are too long: double precision does not resolve the compliance of their short waves.
    integer(c_int32_t), parameter, public :: STICKSLIP_CELLS_TOO_LONG = 72
    ! An array has the wrong number of entries (found for expected).
    integer(c_int32_t), parameter, public :: STICKSLIP_LENGTH = 73
    ! Two objects live on different grids.
    integer(c_int32_t), parameter, public :: STICKSLIP_GRID_MISMATCH = 74
    ! Two objects belong to bodies with different boundaries.
    integer(c_int32_t), parameter, public :: STICKSLIP_BOUNDARY_MISMATCH = 75
    ! Two objects belong to bodies of different materials.
    integer(c_int32_t), parameter, public :: STICKSLIP_MATERIAL_MISMATCH = 76
    ! The tolerance (value) lies outside (0, 1).
    integer(c_int32_t), parameter, public :: STICKSLIP_TOLERANCE = 77
    ! The iteration limit is zero.
    integer(c_int32_t), parameter, public :: STICKSLIP_ITERATION_LIMIT = 78
    ! A solver that is to hold its pressure has none yet: give it a force or an approach.
    integer(c_int32_t), parameter, public :: STICKSLIP_NO_PRESSURE_TO_HOLD = 79
    ! The method does not solve this kind of problem.
    integer(c_int32_t), parameter, public :: STICKSLIP_METHOD = 80
    ! A quantity (value) is below its lower limit (limit).
    integer(c_int32_t), parameter, public :: STICKSLIP_BELOW_MINIMUM = 81
    ! The bytes are no saved history, of another version, or damaged.
    integer(c_int32_t), parameter, public :: STICKSLIP_FORMAT = 82
    ! The body is rigid: nothing determines its stress.
    integer(c_int32_t), parameter, public :: STICKSLIP_RIGID_BODY = 83
    ! A sum over images that does not converge on a grid that repeats along both axes.
    integer(c_int32_t), parameter, public :: STICKSLIP_DIVERGENT_PERIODIC_SUM = 84
    ! The Hurst exponent (value) lies outside [0, 1].
    integer(c_int32_t), parameter, public :: STICKSLIP_HURST = 85
    ! No wave of the surface has a wavelength between the longest (value) and the shortest (limit).
    integer(c_int32_t), parameter, public :: STICKSLIP_NO_WAVE_IN_BAND = 86
    ! No heights of this skewness (value) and kurtosis (limit) were found.
    integer(c_int32_t), parameter, public :: STICKSLIP_HEIGHT_MOMENTS_NOT_REACHED = 87
    ! Two objects belong to bodies whose cells have values of another meaning.
    integer(c_int32_t), parameter, public :: STICKSLIP_CELL_VALUE_MISMATCH = 88
    ! Ranks cannot go on together: one of them (index) is lost, makes other calls or has refused its part, or they came with
    ! different inputs, which the message names.
    integer(c_int32_t), parameter, public :: STICKSLIP_RANK_FAILURE = 89
    ! A rolled step needs more cells (expected) next to the contact than the grid has there (found): ahead of it or behind it.
    integer(c_int32_t), parameter, public :: STICKSLIP_GRID_TOO_SHORT = 90
    ! A quantity (value) is beyond a limit (limit) outside which its squares leave the range of numbers: choose other units.
    integer(c_int32_t), parameter, public :: STICKSLIP_EXTREME_NUMBER = 91
    ! Any other refusal: the message says which.
    integer(c_int32_t), parameter, public :: STICKSLIP_INVALID_ARGUMENT = 127
    ! Body 1, into which z points.
    integer(c_int32_t), parameter, public :: STICKSLIP_BODY_1 = 1
    ! Body 2, above it.
    integer(c_int32_t), parameter, public :: STICKSLIP_BODY_2 = 2
    ! Major version of the library.
    integer(c_int32_t), parameter, public :: STICKSLIP_VERSION_MAJOR = 0
    ! Minor version of the library.
    integer(c_int32_t), parameter, public :: STICKSLIP_VERSION_MINOR = 1
    ! Patch version of the library.
    integer(c_int32_t), parameter, public :: STICKSLIP_VERSION_PATCH = 0
    ! Version of the binary interface: of functions, layouts of structs and meanings of constants.
    !
    ! It goes up whenever a program compiled with an older header could go wrong, and is part of the SONAME. A patch never
    ! changes it, a minor version may before 1.0; functions, constants and members in the place of reserved ones may be added
    ! without. A host that loads the library at run time compares it with stickslip_abi_version() first.
    integer(c_int32_t), parameter, public :: STICKSLIP_ABI_VERSION_COMPILED = 2

    ! Takes loads in steps short enough for a tolerance of the tractions: a step is compared with the same in two halves. For
    ! histories on one grid.
    type, bind(c), public :: stickslip_adaptive_steps
        type(c_ptr) :: address = c_null_ptr
    end type stickslip_adaptive_steps

    ! A block on its way to this rank.
    type, bind(c), public :: stickslip_block
        type(c_ptr) :: address = c_null_ptr
    end type stickslip_block

    ! Pressure, traction, slip and creepage of coupled steady rolling. Its fields are read without a copy, and are valid until
    ! the next solve into it, or until it is freed.
    type, bind(c), public :: stickslip_coupled_rolling_solution
        type(c_ptr) :: address = c_null_ptr
    end type stickslip_coupled_rolling_solution

    ! Solves coupled steady rolling for one load after the other, each from the last answer.
    type, bind(c), public :: stickslip_coupled_rolling_solver
        type(c_ptr) :: address = c_null_ptr
    end type stickslip_coupled_rolling_solver

    ! Pressure, tractions and displacements of a coupled contact. Its fields are read without a copy, and are valid until the
    ! next solve into it, or until it is freed.
    type, bind(c), public :: stickslip_coupled_solution
        type(c_ptr) :: address = c_null_ptr
    end type stickslip_coupled_solution

    ! Solves coupled contacts again and again, each from rest in one step, beginning with the last answer.
    type, bind(c), public :: stickslip_coupled_solver
        type(c_ptr) :: address = c_null_ptr
    end type stickslip_coupled_solver

    ! What the steps of a history add up to since the cycle began.
    type, bind(c), public :: stickslip_cycle
        type(c_ptr) :: address = c_null_ptr
    end type stickslip_cycle

    ! Two elastic half-spaces on a grid, with the operators that all contacts on them share. Solvers and histories keep what
    ! they need of it: it may be freed before them. Many threads may use one at once.
    type, bind(c), public :: stickslip_half_space
        type(c_ptr) :: address = c_null_ptr
    end type stickslip_half_space

    ! A contact that is loaded step by step, with memory of slip. A step that fails leaves it bit for bit as it was. Its
    ! fields are read without a copy, and are valid until the next call that changes it.
    type, bind(c), public :: stickslip_history
        type(c_ptr) :: address = c_null_ptr
    end type stickslip_history

    ! Pressure, gap and approach of a normal contact. Its fields are read without a copy, and are valid until the next solve
    ! into it, or until it is freed.
    type, bind(c), public :: stickslip_normal_solution
        type(c_ptr) :: address = c_null_ptr
    end type stickslip_normal_solution

    ! Solves normal contacts of two bodies again and again, each solve beginning with the last answer.
    type, bind(c), public :: stickslip_normal_solver
        type(c_ptr) :: address = c_null_ptr
    end type stickslip_normal_solver

    ! Planes at chosen depths below each body, and the one that was solved last. Its fields are read without a copy, and are
    ! valid until the next solve, or until it is freed.
    type, bind(c), public :: stickslip_planes
        type(c_ptr) :: address = c_null_ptr
    end type stickslip_planes

    ! Traction, slip and creepage of steady rolling. Its fields are read without a copy, and are valid until the next solve
    ! into it, or until it is freed.
    type, bind(c), public :: stickslip_rolling_solution
        type(c_ptr) :: address = c_null_ptr
    end type stickslip_rolling_solution

    ! Solves steady rolling for one creepage, force or spin after the other, each from the last answer.
    type, bind(c), public :: stickslip_rolling_solver
        type(c_ptr) :: address = c_null_ptr
    end type stickslip_rolling_solver

    ! A state of a history, to which it may return: gap, friction and settings are part of it.
    type, bind(c), public :: stickslip_state
        type(c_ptr) :: address = c_null_ptr
    end type stickslip_state

    ! Traction, slip and shift of a tangential contact. Its fields are read without a copy, and are valid until the next solve
    ! into it, or until it is freed.
    type, bind(c), public :: stickslip_tangential_solution
        type(c_ptr) :: address = c_null_ptr
    end type stickslip_tangential_solution

    ! Solves tangential contacts again and again, each from rest, beginning with the last answer.
    type, bind(c), public :: stickslip_tangential_solver
        type(c_ptr) :: address = c_null_ptr
    end type stickslip_tangential_solver

    ! A normal load.
    type, bind(c), public :: stickslip_normal_load
        ! STICKSLIP_HOLD, STICKSLIP_FORCE or STICKSLIP_APPROACH.
        integer(c_int32_t) :: kind = 0
        ! The force (zero or positive) or the approach (a length, positive when the bodies come together).
        real(c_double) :: value = 0
    end type stickslip_normal_load

    ! What is prescribed along one axis.
    type, bind(c), public :: stickslip_control
        ! STICKSLIP_HOLD, STICKSLIP_FORCE, STICKSLIP_SHIFT or STICKSLIP_SPRING.
        integer(c_int32_t) :: kind = 0
        ! The force that body 2 exerts on body 1, the shift, or the position of the far end of the spring.
        real(c_double) :: value = 0
        ! Stiffness of the spring (a force over a length).
        real(c_double) :: stiffness = 0
    end type stickslip_control

    ! How the bodies roll in a step of a history: the memory of the particles moves through the contact, and body 2 creeps over
    ! body 1 on the way. All zero: they do not roll. A step that rolls names no shift, no spring and no twist; along an axis on
    ! which it names a force the creepage follows, and is zero here.
    type, bind(c), public :: stickslip_roll
        ! Cells by which the particles of both surfaces move through the contact, one or more.
        integer(c_int32_t) :: cells = 0
        ! Where particles enter the contact: STICKSLIP_PLUS_X, STICKSLIP_MINUS_X, STICKSLIP_PLUS_Y or STICKSLIP_MINUS_Y.
        integer(c_int32_t) :: leading_edge = 0
        ! The creepages along x and y, what body 2 moves over body 1 for each length rolled (dimensionless).
        real(c_double) :: creepage(2) = 0
        ! The spin, the rotation of body 2 relative to body 1 about the origin of the grid for each length rolled (one over a
        ! length, positive from x to y); the vector model only.
        real(c_double) :: spin = 0
    end type stickslip_roll

    ! A step of a history: what it prescribes at its end. All zero holds everything.
    type, bind(c), public :: stickslip_load_step
        ! Normal load.
        type(stickslip_normal_load) :: normal
        ! Tangential load along x.
        type(stickslip_control) :: x
        ! Tangential load along y.
        type(stickslip_control) :: y
        ! Not zero: to this twist; else the twist is held.
        integer(c_int32_t) :: has_twist = 0
        ! Rotation of body 2 relative to body 1 since the start (radians, from x to y).
        real(c_double) :: twist = 0
        ! Not zero: to this amount of the relative displacement; else it is held.
        integer(c_int32_t) :: has_relative_displacement = 0
        ! Amount of the relative displacement, as a multiple of the pattern of the history.
        real(c_double) :: relative_displacement = 0
        ! How the bodies roll; all zero: they do not.
        type(stickslip_roll) :: roll
        ! Room for members to come: zero.
        integer(c_int64_t) :: reserved(4) = 0
    end type stickslip_load_step

    ! The error that one step makes with a load: its difference from the same in two halves.
    type, bind(c), public :: stickslip_step_error
        ! That of the traction, relative; what the tolerance is for.
        real(c_double) :: traction = 0
        ! That of the tangential force.
        real(c_double) :: force(2) = 0
        ! That of the shift (lengths).
        real(c_double) :: shift(2) = 0
        ! That of the energy dissipated.
        real(c_double) :: dissipated_energy = 0
        ! Room for members to come: zero.
        integer(c_int64_t) :: reserved(8) = 0
    end type stickslip_step_error

    ! The contact of a sphere and a plane without friction, by Hertz.
    type, bind(c), public :: stickslip_hertz
        ! Radius of the contact (a length): a = (3 W R/(4 E*))^(1/3), with the force W and the radius R of the sphere.
        real(c_double) :: contact_radius = 0
        ! Pressure at the centre: p0 = 3 W/(2 pi a^2). At the distance r from it the pressure is p0 (1 - r^2/a^2)^(1/2).
        real(c_double) :: max_pressure = 0
        ! Approach of the bodies (a length): a^2/R.
        real(c_double) :: approach = 0
        ! Room for members to come: zero.
        integer(c_int64_t) :: reserved(8) = 0
    end type stickslip_hertz

    ! The contact of a sphere and a plane that is pressed and then loaded tangentially, by Cattaneo and Mindlin.
    type, bind(c), public :: stickslip_cattaneo_mindlin
        ! The normal contact.
        type(stickslip_hertz) :: hertz
        ! Radius of the circle that sticks (a length): c = a (1 - |Q|/(mu W))^(1/3), with the tangential force Q; 0 without
        ! friction.
        real(c_double) :: stick_radius = 0
        ! Shift (a length), with the sign of the force: 3 mu W/(16 a G*) (1 - c^2/a^2), with G* of
        ! stickslip_pair.
        real(c_double) :: shift = 0
        ! Energy dissipated as the force grows from zero (a force times a length), zero or positive.
        real(c_double) :: dissipated_energy = 0
        ! Room for members to come: zero.
        integer(c_int64_t) :: reserved(8) = 0
    end type stickslip_cattaneo_mindlin

    ! A cylinder that rolls steadily on a plane with longitudinal creepage, in plane strain, by Carter.
    type, bind(c), public :: stickslip_carter
        ! Half-width of the contact (a length): a = (4 P R/(pi E*))^(1/2), with the force P per length and the radius R.
        real(c_double) :: half_width = 0
        ! Pressure at the centre: p0 = 2 P/(pi a).
        real(c_double) :: max_pressure = 0
        ! The creepage from which on the whole contact slips (dimensionless): 2 mu p0/E*.
        real(c_double) :: sliding_creepage = 0
        ! Half-width of the strip that sticks, at the leading edge x = a (a length): c = a (1 - |creepage|/sliding_creepage).
        real(c_double) :: stick_half_width = 0
        ! Tangential force on body 1 (a force per length), with the sign of the creepage: mu P (1 - c^2/a^2).
        real(c_double) :: force = 0
        ! Room for members to come: zero.
        integer(c_int64_t) :: reserved(8) = 0
    end type stickslip_carter

    ! Cylinders of different materials that roll freely, in plane strain and with little friction, by Bentall and Johnson: the
    ! limit of a friction much less than the size of Dundurs' beta. The leading edge is at the largest x; with that at the
    ! smallest the creepage has the other sign.
    type, bind(c), public :: stickslip_bentall_johnson
        ! Half-width of the contact (a length): a = (4 P R/(pi E*))^(1/2), with the force P per length and the radius R.
        real(c_double) :: half_width = 0
        ! Pressure at the centre: p0 = 2 P/(pi a).
        real(c_double) :: max_pressure = 0
        ! The creepage without a tangential force (dimensionless): 0.9148 beta a/R.
        real(c_double) :: creepage = 0
        ! Half-width of the middle strip, at whose ends the slip reverses (a length): 0.4040 a.
        real(c_double) :: reversal = 0
        ! Energy that slip dissipates for each length rolled (a force per length): 0.1239 mu |beta| P a/R.
        real(c_double) :: dissipation = 0
        ! Room for members to come: zero.
        integer(c_int64_t) :: reserved(8) = 0
    end type stickslip_bentall_johnson

    ! Kalker's coefficients: forces and moment of an elliptic contact that rolls along x with creepages so small that it sticks,
    ! but at its trailing edge. With semi-axes a along x and b along y, c = (a b)^(1/2) and the shear modulus G of two equal
    ! bodies the creepages xi along x and eta along y and the spin phi cause F_x = G c^2 c11 xi,
    ! F_y = G c^2 (c22 eta + c c23 phi) and the moment G c^3 (-c23 eta + c c33 phi) on body 1.
    type, bind(c), public :: stickslip_kalker
        ! Force along x by the creepage along x.
        real(c_double) :: c11 = 0
        ! Force along y by the creepage along y.
        real(c_double) :: c22 = 0
        ! Force along y by the spin; minus the moment by the creepage along y.
        real(c_double) :: c23 = 0
        ! Moment by the spin.
        real(c_double) :: c33 = 0
        ! Room for members to come: zero.
        integer(c_int64_t) :: reserved(8) = 0
    end type stickslip_kalker

    ! An elliptic contact that rolls along x with creepages, without spin, by Vermeulen and Johnson with Kalker's slope: a few
    ! percent less than what is solved.
    type, bind(c), public :: stickslip_vermeulen_johnson
        ! Semi-axes of the contact along x and y (lengths).
        real(c_double) :: semi_axes(2) = 0
        ! Pressure at the centre.
        real(c_double) :: max_pressure = 0
        ! The coefficients of the contact without slip.
        type(stickslip_kalker) :: coefficients
        ! The force that the creepages would cause without slip, over the friction limit (dimensionless): x, from 3 on all
        ! slips.
        real(c_double) :: relative_creepage = 0
        ! Tangential force on body 1 along x and y: mu W (1 - (1 - x/3)^3) along that without slip, with the normal force W.
        real(c_double) :: force(2) = 0
        ! Room for members to come: zero.
        integer(c_int64_t) :: reserved(8) = 0
    end type stickslip_vermeulen_johnson

    ! A quantity of all cells: one value, or one for each.
    type, bind(c), public :: stickslip_per_cell
        ! The value of all cells, if cells is NULL.
        real(c_double) :: value = 0
        ! A value for each cell, copied by the call; or NULL.
        type(c_ptr) :: cells = c_null_ptr
        ! Number of cells, if cells is not NULL.
        integer(c_size_t) :: count = 0
    end type stickslip_per_cell

    ! Coulomb friction.
    type, bind(c), public :: stickslip_friction
        ! Coefficient of friction, zero or positive.
        type(stickslip_per_cell) :: coefficient
        ! Largest shear traction (a pressure); 0 or infinite: no limit but that of the coefficient.
        real(c_double) :: max_shear_stress = transfer(int(z'7FF0000000000000', c_int64_t), 0.0_c_double)
        ! Room for members to come: zero.
        integer(c_int64_t) :: reserved(8) = 0
    end type stickslip_friction

    ! A tangential load from rest.
    type, bind(c), public :: stickslip_tangential_load
        ! Along x.
        type(stickslip_control) :: x
        ! Along y.
        type(stickslip_control) :: y
        ! Rotation of body 2 relative to body 1 about the origin of the grid (radians, from x to y); the vector model only.
        real(c_double) :: twist = 0
        ! Room for members to come: zero.
        integer(c_int64_t) :: reserved(8) = 0
    end type stickslip_tangential_load

    ! A tangential displacement of body 1 relative to body 2 in each cell that the contact does not cause, such as that of
    ! bulk strain; copied by the call.
    type, bind(c), public :: stickslip_relative_displacement
        ! That along x (lengths), for each cell.
        type(c_ptr) :: x = c_null_ptr
        ! That along y (lengths), for each cell.
        type(c_ptr) :: y = c_null_ptr
        ! Number of cells.
        integer(c_size_t) :: count = 0
    end type stickslip_relative_displacement

    ! Method, tolerance and limits of a solve; stickslip_settings_default() has the defaults.
    type, bind(c), public :: stickslip_settings
        ! STICKSLIP_ACTIVE_SET (default) or STICKSLIP_POLONSKY_KEER.
        integer(c_int32_t) :: method = 0
        ! The error accepted, in (0, 1) (default 1e-8): certified in the energy norm, and as a residual relative to the largest
        ! displacement.
        real(c_double) :: tolerance = 1e-8_c_double
        ! Conjugate-gradient steps allowed (default 10000).
        integer(c_size_t) :: max_iterations = 10000
        ! Wall time allowed for a solve (seconds); infinite (default): any. A step of a history has two solves, pressure and
        ! traction.
        real(c_double) :: time_limit = transfer(int(z'7FF0000000000000', c_int64_t), 0.0_c_double)
        ! Room for members to come: zero.
        integer(c_int64_t) :: reserved(8) = 0
    end type stickslip_settings

    ! One step of an iteration.
    type, bind(c), public :: stickslip_iteration
        ! Conjugate-gradient steps so far.
        integer(c_size_t) :: iteration = 0
        ! Products in double precision so far.
        integer(c_size_t) :: double_precision_products = 0
        ! Products in single precision so far.
        integer(c_size_t) :: single_precision_products = 0
        ! Largest complementarity residual, relative to the largest displacement, as last measured.
        real(c_double) :: residual = 0
        ! Contact cells of a normal problem, sticking cells of a tangential one.
        integer(c_size_t) :: free = 0
        ! Room for members to come: zero.
        integer(c_int64_t) :: reserved(8) = 0
    end type stickslip_iteration

    ! A function that watches a solve, with data of yours.
    type, bind(c), public :: stickslip_observer
        ! The function; NULL watches nothing.
        type(c_funptr) :: observe = c_null_funptr
        ! Passed to the function as it is.
        type(c_ptr) :: user = c_null_ptr
    end type stickslip_observer

    ! Numbers of a normal contact.
    type, bind(c), public :: stickslip_normal_result
        ! Approach of the bodies from the datum of the gap (a length).
        real(c_double) :: approach = 0
        ! Normal force.
        real(c_double) :: force = 0
        ! Area of the cells in contact.
        real(c_double) :: contact_area = 0
        ! The same, corrected for the steps of its perimeter.
        real(c_double) :: contact_area_corrected = 0
        ! Force over contact area; zero without contact.
        real(c_double) :: mean_pressure = 0
        ! Moments of the pressure about x and y at the origin of the grid (forces times lengths).
        real(c_double) :: moments(2) = 0
        ! Centre of pressure (lengths); NaN without contact.
        real(c_double) :: centre_of_pressure(2) = 0
        ! Cells in contact.
        integer(c_size_t) :: contact_cells = 0
        ! Cells at their hardness.
        integer(c_size_t) :: yielded_cells = 0
        ! Room for members to come: zero.
        integer(c_int64_t) :: reserved(8) = 0
    end type stickslip_normal_result

    ! Numbers of a tangential contact.
    type, bind(c), public :: stickslip_tangential_result
        ! Shift of body 2 relative to body 1 (lengths).
        real(c_double) :: shift(2) = 0
        ! Tangential force that body 2 exerts on body 1.
        real(c_double) :: force(2) = 0
        ! Rotation of body 2 relative to body 1 (radians).
        real(c_double) :: twist = 0
        ! Moment about z that the tractions exert on body 1 (a force times a length).
        real(c_double) :: moment = 0
        ! Stick cells over contact cells.
        real(c_double) :: stick_ratio = 0
        ! Area that sticks.
        real(c_double) :: stick_area = 0
        ! Area that slips.
        real(c_double) :: slip_area = 0
        ! Energy dissipated by slip.
        real(c_double) :: dissipated_energy = 0
        ! Not zero if the whole contact is at its friction limit.
        integer(c_int32_t) :: is_gross_slip = 0
        ! Room for members to come: zero.
        integer(c_int64_t) :: reserved(8) = 0
    end type stickslip_tangential_result

    ! How a solve ended, what it cost and how large its error can be.
    type, bind(c), public :: stickslip_report
        ! STICKSLIP_CONVERGED or why not, or STICKSLIP_UNSOLVED.
        integer(c_int32_t) :: status = 0
        ! How the smallest eigenvalue is known that duality_gap, and what else is certified beside it, rests on:
        ! STICKSLIP_EIGENVALUE_PROVEN, STICKSLIP_EIGENVALUE_ESTIMATED or STICKSLIP_EIGENVALUE_UNKNOWN.
        integer(c_int32_t) :: eigenvalue_bound = 0
        ! Conjugate-gradient steps.
        integer(c_size_t) :: iterations = 0
        ! Products with the operator in double precision.
        integer(c_size_t) :: double_precision_products = 0
        ! Products in single precision.
        integer(c_size_t) :: single_precision_products = 0
        ! Largest complementarity residual, relative to the largest displacement.
        real(c_double) :: residual = 0
        ! Certified bound on the squared relative error in the energy norm.
        real(c_double) :: duality_gap = 0
        ! Certified bound on the relative error in the energy norm, the root of the above.
        real(c_double) :: energy_error_bound = 0
        ! Relative error of the prescribed total force.
        real(c_double) :: load_error = 0
        ! Wall time of the solve (seconds).
        real(c_double) :: seconds = 0
        ! Room for members to come: zero.
        integer(c_int64_t) :: reserved(8) = 0
    end type stickslip_report

    ! How a coupled solve ended. The whole error is bounded where friction is weak; else its halves are certified.
    type, bind(c), public :: stickslip_coupled_report
        ! The work; its duality gap is infinite.
        type(stickslip_report) :: work
        ! Bound of the error of the pressure in the energy norm, at tractions as they are.
        real(c_double) :: pressure_error_bound = 0
        ! Bound of the error of the tractions, at the pressure as it is.
        real(c_double) :: traction_error_bound = 0
        ! Bounds of the errors of pressure and traction as a whole; NaN where there are none.
        real(c_double) :: error_bounds(2) = 0
        ! What the errors of pressure and traction as a whole are likely to be; NaN where that is not known.
        real(c_double) :: error_estimate(2) = 0
        ! Room for members to come: zero.
        integer(c_int64_t) :: reserved(8) = 0
    end type stickslip_coupled_report

    ! Report of coupled rolling: ending, cost, passes and certified errors.
    type, bind(c), public :: stickslip_coupled_rolling_report
        ! The work of all passes; its duality gap is infinite for coupled bodies.
        type(stickslip_report) :: work
        ! Number of passes: solves of the pressure, each followed by a solve of the tractions.
        integer(c_size_t) :: passes = 0
        ! Residual of the coupling: lift within the contact that the last pass has added, over the largest normal displacement.
        real(c_double) :: coupling_residual = 0
        ! Change of the pressure in the last pass, over the pressure (root mean squares).
        real(c_double) :: pressure_change = 0
        ! Bound of the relative error of the pressure in the energy norm, for the tractions of the solution.
        real(c_double) :: pressure_error_bound = 0
        ! Bound of the relative error of the tractions, for the pressure of the solution.
        real(c_double) :: traction_error_bound = 0
        ! Estimate of the relative error of the pressure as a whole; NaN if there is none.
        real(c_double) :: error_estimate = 0
        ! Room for members to come: zero.
        integer(c_int64_t) :: reserved(8) = 0
    end type stickslip_coupled_rolling_report

    ! A diagnostic on a converged solution that may mislead.
    type, bind(c), public :: stickslip_warning
        ! One of STICKSLIP_WARNING_NO_CONTACT and the others.
        integer(c_int32_t) :: kind = 0
        ! Cells or spots that it is about; else zero.
        integer(c_size_t) :: cells = 0
        ! Spots in all; else zero.
        integer(c_size_t) :: of = 0
        ! What it means and what to do, in English; ends with a zero byte.
        character(kind=c_char) :: message(STICKSLIP_WARNING_LENGTH) = c_null_char
        ! Room for members to come: zero.
        integer(c_int64_t) :: reserved(8) = 0
    end type stickslip_warning

    ! Normal force by approach.
    type, bind(c), public :: stickslip_normal_stiffness
        ! A force over a length; zero without contact.
        real(c_double) :: value = 0
        ! Bound of its relative error; infinite where pressure and traction are found together.
        real(c_double) :: bound = 0
        ! Room for members to come: zero.
        integer(c_int64_t) :: reserved(8) = 0
    end type stickslip_normal_stiffness

    ! Forces along x and y and the moment, by shifts along x and y and the twist: rows are loads, columns motions. In C
    ! loading[row, column]. NaN for loads and motions that the model does not have: in the scalar model what is across its axis
    ! and the twist, on grids that repeat the twist.
    type, bind(c), public :: stickslip_tangential_stiffness
        ! Derivative with respect to the motion at the end of the step, if the motion continues in its direction. Cells that came
        ! into contact in the step follow the motion only in part. After a step that presses a ball the derivative is about
        ! two thirds of Mindlin's stiffness, although all cells stick. stickslip_history_next_stiffness has the derivative of the
        ! next step, in which they resist fully.
        real(c_double) :: loading(3, 3) = 0
        ! If the motion reverses: all cells of the contact stick.
        real(c_double) :: reversal(3, 3) = 0
        ! Bound of the errors: none is larger than this times the root of the product of the two entries on the diagonal;
        ! infinite where pressure and traction are found together.
        real(c_double) :: bound = 0
        ! Room for members to come: zero.
        integer(c_int64_t) :: reserved(8) = 0
    end type stickslip_tangential_stiffness

    ! The stiffness of a contact.
    type, bind(c), public :: stickslip_stiffness
        ! Normal force by approach.
        type(stickslip_normal_stiffness) :: normal
        ! Tangential forces and moment by shift and twist.
        type(stickslip_tangential_stiffness) :: tangential
        ! Tangential forces and moment by the approach while slip continues; NaN for those that the model does not have.
        real(c_double) :: by_approach(3) = 0
        ! Normal force by shifts along x and y and the twist: zero but where pressure and traction are found together. NaN for
        ! motions that the model does not have.
        real(c_double) :: normal_by_motion(3) = 0
        ! Room for members to come: zero.
        integer(c_int64_t) :: reserved(5) = 0
    end type stickslip_stiffness

    ! Work, elastic energy and dissipation of a step or a cycle.
    type, bind(c), public :: stickslip_energy
        ! Work of the tangential load.
        real(c_double) :: work = 0
        ! Elastic energy of shear before.
        real(c_double) :: elastic_before = 0
        ! Elastic energy of shear after.
        real(c_double) :: elastic_after = 0
        ! Energy dissipated, by the tractions at the ends of steps.
        real(c_double) :: dissipated_energy = 0
        ! Energy dissipated, by the mean tractions of steps, which closes the balance.
        real(c_double) :: dissipated_energy_midpoint = 0
        ! Energy that cells let go as they leave the contact.
        real(c_double) :: released = 0
        ! Work on the motion that the tolerance leaves in stick cells.
        real(c_double) :: residual = 0
        ! What is missing in the balance: round-off.
        real(c_double) :: imbalance = 0
        ! Room for members to come: zero.
        integer(c_int64_t) :: reserved(8) = 0
    end type stickslip_energy

    ! Numbers of a cycle.
    type, bind(c), public :: stickslip_cycle_result
        ! Steps since it began.
        integer(c_size_t) :: steps = 0
        ! STICKSLIP_FULL_STICK, STICKSLIP_PARTIAL_SLIP or STICKSLIP_GROSS_SLIP.
        integer(c_int32_t) :: regime = 0
        ! Energy dissipated over the area of the rectangle around the loop of force and shift.
        real(c_double) :: energy_ratio = 0
        ! How far the traction at the end is from that at the beginning, relative to the largest: zero if the loop repeats.
        real(c_double) :: cyclic_residual = 0
        ! Amplitude of the tangential force.
        real(c_double) :: force_amplitude(2) = 0
        ! Amplitude of the shift (lengths).
        real(c_double) :: shift_amplitude(2) = 0
        ! Least and largest stick ratio at the end of a step.
        real(c_double) :: stick_ratios(2) = 0
        ! Energies of all its steps.
        type(stickslip_energy) :: energy
        ! Room for members to come: zero.
        integer(c_int64_t) :: reserved(8) = 0
    end type stickslip_cycle_result

    ! The edges of a contact and of its stick zone, found inside the cells. Numbers of the stick zone and of the traction are NaN
    ! for a contact that is pressed only.
    type, bind(c), public :: stickslip_edges
        ! Area of the contact, with the parts of the cells at its edge (a length squared).
        real(c_double) :: contact_area = 0
        ! The part of the cells at the edge of the contact whose fit was refused: these count as a mean part, and have their own
        ! pressure.
        real(c_double) :: unfitted_fraction = 0
        ! Largest pressure at the centre of a cell (a pressure).
        real(c_double) :: peak_pressure = 0
        ! Area of the stick zone (a length squared).
        real(c_double) :: stick_area = 0
        ! Area of the slip zone (a length squared).
        real(c_double) :: slip_area = 0
        ! Stick area over contact area; zero without contact.
        real(c_double) :: stick_ratio = 0
        ! The part of the cells at the edge of the stick zone whose fit was refused.
        real(c_double) :: stick_unfitted_fraction = 0
        ! Largest magnitude of the traction at the centre of a cell (a pressure).
        real(c_double) :: peak_traction = 0
        ! Room for members to come: zero.
        integer(c_int64_t) :: reserved(8) = 0
    end type stickslip_edges

    ! The numbers of the last failure on this thread; zero where they have no meaning.
    type, bind(c), public :: stickslip_error
        ! What the function returned, STICKSLIP_OK before any failure.
        integer(c_int32_t) :: code = 0
        ! The offending value.
        real(c_double) :: value = 0
        ! The limit that it violates.
        real(c_double) :: limit = 0
        ! The index of the offending sample, or the place in a batch.
        integer(c_size_t) :: index = 0
        ! Entries needed.
        integer(c_size_t) :: expected = 0
        ! Entries given.
        integer(c_size_t) :: found = 0
        ! Room for members to come: zero.
        integer(c_int64_t) :: reserved(4) = 0
    end type stickslip_error

    ! A grid of nx by ny rectangular cells of sides dx and dy (lengths), centred on the origin. An array of samples has
    ! nx * ny entries, row by row with x fastest: that of cell (ix, iy) is at iy * nx + ix.
    type, bind(c), public :: stickslip_grid
        ! Cells along x.
        integer(c_size_t) :: nx = 0
        ! Cells along y.
        integer(c_size_t) :: ny = 0
        ! Side of a cell along x (a length).
        real(c_double) :: dx = 0
        ! Side of a cell along y (a length).
        real(c_double) :: dy = 0
    end type stickslip_grid

    ! The material of a body.
    type, bind(c), public :: stickslip_material
        ! Young's modulus (a pressure); infinite for a rigid body.
        real(c_double) :: youngs_modulus = 0
        ! Poisson's ratio, in (-1, 1/2]; of no meaning for a rigid body.
        real(c_double) :: poisson_ratio = 0
        ! Indentation hardness (a pressure), for warnings only; 0 or infinite: not known.
        real(c_double) :: hardness = 0
    end type stickslip_material

    ! What lies beyond the edge of the grid.
    type, bind(c), public :: stickslip_boundary
        ! STICKSLIP_NON_PERIODIC, STICKSLIP_PERIODIC or STICKSLIP_PERIODIC_ALONG_Y.
        integer(c_int32_t) :: kind = 0
        ! With STICKSLIP_PERIODIC_ALONG_Y: distance along x at which a line load moves nothing (a length).
        real(c_double) :: datum = 0
    end type stickslip_boundary

    ! An elastic layer bonded to what lies below it.
    type, bind(c), public :: stickslip_layer
        ! Young's modulus (a pressure).
        real(c_double) :: youngs_modulus = 0
        ! Poisson's ratio, in (-1, 1/2].
        real(c_double) :: poisson_ratio = 0
        ! Thickness (a length).
        real(c_double) :: thickness = 0
    end type stickslip_layer

    ! One of several processes that solve together; stickslip_mpi.h makes it of an MPI communicator. Function and data are
    ! needed until all that was made of the bodies is freed.
    type, bind(c), public :: stickslip_ranks
        ! The number of this one, from zero.
        integer(c_size_t) :: rank = 0
        ! How many there are.
        integer(c_size_t) :: size = 0
        ! Swaps blocks with others; not called where there are none.
        type(c_funptr) :: swap = c_null_funptr
        ! Passed to the function as it is.
        type(c_ptr) :: user = c_null_ptr
    end type stickslip_ranks

    ! Constants of a pair of materials.
    type, bind(c), public :: stickslip_pair
        ! E* (a pressure): 1/E* = (1 - nu_1^2)/E_1 + (1 - nu_2^2)/E_2.
        real(c_double) :: contact_modulus = 0
        ! G* of Mindlin (a pressure): 1/G* = (2 - nu_1)/G_1 + (2 - nu_2)/G_2; a circle of radius a that sticks has 8 G* a.
        real(c_double) :: tangential_modulus = 0
        ! Dundurs' second parameter; zero where pressure and traction are not coupled.
        real(c_double) :: dundurs_beta = 0
        ! Not zero if pressure and traction are coupled.
        integer(c_int32_t) :: is_coupled = 0
        ! Room for members to come: zero.
        integer(c_int64_t) :: reserved(8) = 0
    end type stickslip_pair

    ! Options of a history; stickslip_history_options_default() has the defaults.
    type, bind(c), public :: stickslip_history_options
        ! Axis of load and traction in the scalar model: STICKSLIP_X (default) or STICKSLIP_Y.
        integer(c_int32_t) :: axis = 0
        ! STICKSLIP_SCALAR (default) or STICKSLIP_VECTOR.
        integer(c_int32_t) :: model = 0
        ! STICKSLIP_FULL (default), STICKSLIP_ONE_WAY or STICKSLIP_NEGLECTED; of meaning for dissimilar bodies only.
        integer(c_int32_t) :: coupling = 0
        ! STICKSLIP_SINCE_TOUCH (default) or STICKSLIP_WHOLE_STEP.
        integer(c_int32_t) :: entry_rule = 0
        ! Largest pressure that the cells carry, or NULL (default).
        type(c_ptr) :: hardness = c_null_ptr
        ! Not zero if what yields stays (default 0).
        integer(c_int32_t) :: permanent_set = 0
        ! Pattern of a displacement that the contact does not cause, or NULL (default); steps reach an amount of it.
        type(c_ptr) :: relative_displacement = c_null_ptr
        ! Method, tolerance and limits.
        type(stickslip_settings) :: settings
        ! Room for members to come: zero.
        integer(c_int64_t) :: reserved(8) = 0
    end type stickslip_history_options

    ! Numbers of a history after its last step.
    type, bind(c), public :: stickslip_step_result
        ! Normal force.
        real(c_double) :: normal_force = 0
        ! Approach of the bodies (a length).
        real(c_double) :: approach = 0
        ! Tangential force that body 2 exerts on body 1.
        real(c_double) :: force(2) = 0
        ! Shift of body 2 relative to body 1 since the start (lengths).
        real(c_double) :: shift(2) = 0
        ! Moment about z that the tractions exert on body 1.
        real(c_double) :: moment = 0
        ! Rotation of body 2 relative to body 1 since the start (radians).
        real(c_double) :: twist = 0
        ! Stick cells over contact cells after the last step; zero without contact.
        real(c_double) :: stick_ratio = 0
        ! Not zero if the whole contact is at its friction limit after the last step.
        integer(c_int32_t) :: is_gross_slip = 0
        ! Steps taken since the start.
        integer(c_int64_t) :: steps = 0
        ! Energies of the last step.
        type(stickslip_energy) :: energy
        ! The creepages along x and y of the last step, given or caused by the force (dimensionless); zero if it did not roll.
        real(c_double) :: creepage(2) = 0
        ! Room for members to come: zero.
        integer(c_int64_t) :: reserved(6) = 0
    end type stickslip_step_result

    ! What limits a jump besides the pressure; stickslip_jump_limits_default() has the defaults.
    type, bind(c), public :: stickslip_jump_limits
        ! Most depth that is worn off at once (a length); infinite (default): any. A hundredth of the approach keeps the shape
        ! of a ball.
        real(c_double) :: largest_depth = transfer(int(z'7FF0000000000000', c_int64_t), 0.0_c_double)
        ! Cycles left to simulate; infinite (default): any number.
        real(c_double) :: cycles_left = transfer(int(z'7FF0000000000000', c_int64_t), 0.0_c_double)
        ! Largest cyclic_residual of a cycle that stands for those that follow (default 0.25).
        real(c_double) :: max_residual = 0.25_c_double
        ! Room for members to come: zero.
        integer(c_int64_t) :: reserved(8) = 0
    end type stickslip_jump_limits

    ! What acts on the surface: the fields of a solution or a history, or any others. It is up to the caller that they belong
    ! to the same bodies.
    type, bind(c), public :: stickslip_tractions
        ! Pressure of each cell, positive in compression.
        type(c_ptr) :: pressure = c_null_ptr
        ! Traction along x on body 1 (pressures); NULL, like that along y, without shear.
        type(c_ptr) :: x = c_null_ptr
        ! Traction along y on body 1.
        type(c_ptr) :: y = c_null_ptr
        ! Number of cells.
        integer(c_size_t) :: count = 0
    end type stickslip_tractions

    ! Options of a rolling solver; stickslip_rolling_options_default() has the defaults.
    type, bind(c), public :: stickslip_rolling_options
        ! STICKSLIP_PLUS_X (default), STICKSLIP_MINUS_X, STICKSLIP_PLUS_Y or STICKSLIP_MINUS_Y.
        integer(c_int32_t) :: leading_edge = 0
        ! How cells that enter the contact follow the motion: STICKSLIP_SINCE_TOUCH (default) or STICKSLIP_WHOLE_STEP.
        integer(c_int32_t) :: entry_rule = 0
        ! Cells that a particle passes in a step (default 1). Longer steps cost less and are less accurate.
        integer(c_size_t) :: step = 1
        ! Number of corrections of the direction of slip (default 0). Two raise the order of the forces under spin from 1 to
        ! between 1.5 and 2.
        integer(c_size_t) :: slip_corrections = 0
        ! Method, tolerance and limits.
        type(stickslip_settings) :: settings
        ! Room for members to come: zero.
        integer(c_int64_t) :: reserved(7) = 0
    end type stickslip_rolling_options

    ! What is prescribed of rolling bodies along an axis, or of their rotation.
    type, bind(c), public :: stickslip_rolling_control
        ! Along an axis STICKSLIP_CREEPAGE or STICKSLIP_FORCE, of the rotation STICKSLIP_SPIN or STICKSLIP_MOMENT.
        integer(c_int32_t) :: kind = 0
        ! The creepage or the force that body 2 exerts on body 1, less than friction holds; the spin or the moment.
        real(c_double) :: value = 0
    end type stickslip_rolling_control

    ! What is prescribed of rolling bodies. All zero: no creepage and no spin.
    type, bind(c), public :: stickslip_rolling_load
        ! Along x.
        type(stickslip_rolling_control) :: x
        ! Along y.
        type(stickslip_rolling_control) :: y
        ! The spin or the moment.
        type(stickslip_rolling_control) :: spin
        ! Room for members to come: zero.
        integer(c_int64_t) :: reserved(8) = 0
    end type stickslip_rolling_load

    ! How forces and moment follow creepages and spin.
    type, bind(c), public :: stickslip_rolling_stiffness
        ! Slopes of the forces along x and y and of the moment (rows) by the creepages along x and y and the spin (columns).
        ! In C slopes[row, column]. Forces; with the spin forces times lengths, in the row of the moment once more times a
        ! length.
        real(c_double) :: slopes(3, 3) = 0
        ! Room for members to come: zero.
        integer(c_int64_t) :: reserved(8) = 0
    end type stickslip_rolling_stiffness

    ! Creepages and spin: a point of a creep curve or a creep surface.
    type, bind(c), public :: stickslip_creep_point
        ! The creepages along x and y (dimensionless).
        real(c_double) :: creepage(2) = 0
        ! The spin (one over a length).
        real(c_double) :: spin = 0
    end type stickslip_creep_point

    ! The loads that creepages and spin cause.
    type, bind(c), public :: stickslip_creep_force
        ! Tangential force on body 1 along x and y.
        real(c_double) :: force(2) = 0
        ! Moment on body 1 about the origin of the grid (a force times a length).
        real(c_double) :: moment = 0
        ! Stick cells over contact cells.
        real(c_double) :: stick_ratio = 0
    end type stickslip_creep_force

    ! Numbers of a rolling contact.
    type, bind(c), public :: stickslip_rolling_result
        ! The creepages along x and y, prescribed or caused by the forces (dimensionless).
        real(c_double) :: creepage(2) = 0
        ! The spin, prescribed or caused by the moment (one over a length).
        real(c_double) :: spin = 0
        ! Tangential force that body 2 exerts on body 1.
        real(c_double) :: force(2) = 0
        ! Moment about z at the origin of the grid that the tractions exert on body 1 (a force times a length).
        real(c_double) :: moment = 0
        ! Work that creepages and spin do for each length rolled (a force). Between bodies of the same material all of it is
        ! dissipated; between others the pressure does work as well, which is not in it.
        real(c_double) :: work = 0
        ! Stick cells over contact cells.
        real(c_double) :: stick_ratio = 0
        ! Room for members to come: zero.
        integer(c_int64_t) :: reserved(8) = 0
    end type stickslip_rolling_result

    ! A random surface with a self-affine power spectrum; stickslip_self_affine_default() has the defaults. Wavelengths are
    ! lengths. A spectrum constant from the longest wavelength to the roll-off falls with the wave number q as q^(-2 - 2 H) from
    ! there to the cut-off.
    type, bind(c), public :: stickslip_self_affine
        ! Root-mean-square height (a length); 0 if the slope is given.
        real(c_double) :: rms_height = 0
        ! Root-mean-square slope; 0 if the height is given.
        real(c_double) :: rms_slope = 0
        ! Hurst exponent H, in [0, 1] (default 0.8).
        real(c_double) :: hurst = 0.8_c_double
        ! Longest wavelength, where the spectrum begins; 0 (default): the longer side of the grid.
        real(c_double) :: longest_wavelength = 0
        ! Roll-off wavelength, where the spectrum begins to fall; 0 (default): the longest wavelength.
        real(c_double) :: roll_off_wavelength = 0
        ! Cut-off wavelength, where the spectrum ends, at least two cells; 0 (default): eight cells, of their longer side.
        real(c_double) :: cut_off_wavelength = 0
        ! STICKSLIP_EXACT (default) or STICKSLIP_GAUSSIAN.
        integer(c_int32_t) :: amplitudes = 0
        ! Not zero: the middle of a larger surface, which does not repeat; else (default) the surface repeats along x and y.
        integer(c_int32_t) :: cropped = 0
        ! Skewness of the heights; NaN (default): as it follows from the phases, or 0 if a kurtosis is given.
        real(c_double) :: skewness = transfer(int(z'7FF8000000000000', c_int64_t), 0.0_c_double)
        ! Kurtosis of the heights; NaN (default): as it follows from the phases, or 3 if a skewness is given.
        real(c_double) :: kurtosis = transfer(int(z'7FF8000000000000', c_int64_t), 0.0_c_double)
        ! Another seed is another surface (default 0).
        integer(c_int64_t) :: seed = 0
        ! Room for members to come: zero.
        integer(c_int64_t) :: reserved(8) = 0
    end type stickslip_self_affine

    ! Statistics of heights about their mean, as in ISO 25178-2.
    type, bind(c), public :: stickslip_statistics
        ! Mean height (a length), from which all other heights count.
        real(c_double) :: mean_height = 0
        ! Arithmetic mean height Sa (a length).
        real(c_double) :: arithmetic_mean_height = 0
        ! Root-mean-square height Sq (a length).
        real(c_double) :: rms_height = 0
        ! Skewness Ssk; NaN for a flat surface.
        real(c_double) :: skewness = 0
        ! Kurtosis Sku, 3 for a Gaussian surface; NaN for a flat one.
        real(c_double) :: kurtosis = 0
        ! Height of the highest peak Sp (a length).
        real(c_double) :: highest_peak = 0
        ! Depth of the deepest valley Sv (a length, positive).
        real(c_double) :: deepest_valley = 0
        ! Root-mean-square slope Sdq by finite differences, without those across the edge.
        real(c_double) :: finite_difference_rms_slope = 0
        ! Root-mean-square slope of the waves of the surface, continued periodically.
        real(c_double) :: spectral_rms_slope = 0
        ! Excess of the area over its projection, relative to the projection, Sdr.
        real(c_double) :: developed_area_ratio = 0
        ! Room for members to come: zero.
        integer(c_int64_t) :: reserved(8) = 0
    end type stickslip_statistics

    ! A contact spot: contact cells connected through their sides, across the edges of a grid that repeats too.
    type, bind(c), public :: stickslip_spot
        ! Its cells.
        integer(c_size_t) :: cells = 0
        ! Area, by counting cells (a length squared).
        real(c_double) :: area = 0
        ! Normal force that it carries.
        real(c_double) :: load = 0
        ! Load over area (a pressure).
        real(c_double) :: mean_pressure = 0
        ! Largest pressure of its cells (a pressure).
        real(c_double) :: max_pressure = 0
        ! Centre of the area (lengths), inside the grid; of no meaning for a spot that spans the whole period.
        real(c_double) :: centroid(2) = 0
        ! Length of its edge along the sides of its cells (a length): longer than that of a round spot by a factor of 4/pi.
        real(c_double) :: perimeter = 0
        ! Stick cells over all its cells; NaN for a contact that is pressed only.
        real(c_double) :: stick_ratio = 0
        ! Room for members to come: zero.
        integer(c_int64_t) :: reserved(8) = 0
    end type stickslip_spot

    ! A point in a body.
    type, bind(c), public :: stickslip_point
        ! Position along x, that of the grid (a length).
        real(c_double) :: x = 0
        ! Position along y (a length).
        real(c_double) :: y = 0
        ! Depth below the surface of the body (a length), zero or positive in both bodies.
        real(c_double) :: depth = 0
    end type stickslip_point

    ! Displacement and stress at a point, along x, y and z, with z into body 1.
    type, bind(c), public :: stickslip_response
        ! Displacement of the body along x, y and z (lengths), zero at infinity.
        real(c_double) :: displacement(3) = 0
        ! Stresses xx, yy and zz (pressures, positive in tension).
        real(c_double) :: normal_stress(3) = 0
        ! Stresses xy, xz and yz (pressures).
        real(c_double) :: shear_stress(3) = 0
        ! Principal stresses (pressures, positive in tension), the largest first.
        real(c_double) :: principal_stress(3) = 0
        ! Von Mises' equivalent stress (a pressure).
        real(c_double) :: von_mises = 0
    end type stickslip_response

    ! Options of a tangential solver; stickslip_tangential_options_default() has the defaults.
    type, bind(c), public :: stickslip_tangential_options
        ! STICKSLIP_SCALAR (default) or STICKSLIP_VECTOR.
        integer(c_int32_t) :: model = 0
        ! STICKSLIP_ONE_WAY (default) or STICKSLIP_NEGLECTED; of meaning for dissimilar bodies only.
        integer(c_int32_t) :: coupling = STICKSLIP_ONE_WAY
        ! A displacement of body 1 relative to body 2 that the contact does not cause, or NULL (default).
        type(c_ptr) :: relative_displacement = c_null_ptr
        ! Method, tolerance and limits.
        type(stickslip_settings) :: settings
        ! Room for members to come: zero.
        integer(c_int64_t) :: reserved(8) = 0
    end type stickslip_tangential_options

    interface
        ! Makes the buffers for histories on the grid of this one, with a tolerance in (0, 1) for a whole load.
        function stickslip_adaptive_steps_new(history, tolerance, steps) result(answer) bind(c)
            import
            type(stickslip_history), value :: history
            real(c_double), value :: tolerance
            type(stickslip_adaptive_steps), intent(out) :: steps
            integer(c_int32_t) :: answer
        end function stickslip_adaptive_steps_new

        ! Frees the buffers; nothing for NULL.
        function stickslip_adaptive_steps_free(steps) result(answer) bind(c)
            import
            type(stickslip_adaptive_steps), value :: steps
            integer(c_int32_t) :: answer
        end function stickslip_adaptive_steps_free

        ! Takes a load in as many steps as it needs, and writes how many to taken (may be NULL). After a failure, which may be
        ! STICKSLIP_STEP_TOO_LONG, the state of the history is as it was; its last step is that of the last attempt.
        function stickslip_adaptive_steps_step(steps, history, load, taken) result(answer) bind(c)
            import
            type(stickslip_adaptive_steps), value :: steps
            type(stickslip_history), value :: history
            type(stickslip_load_step), intent(in), optional :: load
            integer(c_size_t), intent(out), optional :: taken
            integer(c_int32_t) :: answer
        end function stickslip_adaptive_steps_step

        ! The error that stickslip_history_step would make with a load. The state of the history is as it was; its last step is
        ! the second half of this one.
        function stickslip_adaptive_steps_error(steps, history, load, error) result(answer) bind(c)
            import
            type(stickslip_adaptive_steps), value :: steps
            type(stickslip_history), value :: history
            type(stickslip_load_step), intent(in), optional :: load
            type(stickslip_step_error), intent(out), optional :: error
            integer(c_int32_t) :: answer
        end function stickslip_adaptive_steps_error

        ! Hertz' contact of a sphere of this radius (a length) under this normal force on the materials of the bodies.
        ! STICKSLIP_NOT_POSITIVE if radius, force or a result is not positive and finite.
        function stickslip_hertz_sphere(half_space, radius, force, hertz) result(answer) bind(c)
            import
            type(stickslip_half_space), value :: half_space
            real(c_double), value :: radius
            real(c_double), value :: force
            type(stickslip_hertz), intent(out), optional :: hertz
            integer(c_int32_t) :: answer
        end function stickslip_hertz_sphere

        ! Cattaneo and Mindlin's contact of a sphere under a normal force, with a coefficient of friction, under a tangential force
        ! of either sign; STICKSLIP_BEYOND_FRICTION_CAPACITY if friction does not carry it. The coupling of pressure and traction of
        ! dissimilar bodies is neglected.
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

        ! Carter's contact of a cylinder of this radius under this force per length, with a coefficient of friction, at a creepage
        ! of either sign. STICKSLIP_COUPLED_MATERIALS for bodies whose Dundurs' beta is not zero.
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

        ! Bentall and Johnson's contact of a cylinder of this radius that rolls freely under this force per length, with a
        ! coefficient of friction. Between bodies whose Dundurs' beta is zero nothing slips.
        function stickslip_bentall_johnson_cylinder(half_space, radius, force, friction, found) result(answer) bind(c)
            import
            type(stickslip_half_space), value :: half_space
            real(c_double), value :: radius
            real(c_double), value :: force
            real(c_double), value :: friction
            type(stickslip_bentall_johnson), intent(out), optional :: found
            integer(c_int32_t) :: answer
        end function stickslip_bentall_johnson_cylinder

        ! Kalker's coefficients of an ellipse of this ratio a/b of its semi-axes, along the rolling direction and across it, from
        ! 1/16 to 16, and of this Poisson's ratio, from 0 to 1/2. STICKSLIP_BELOW_MINIMUM for a ratio beyond the table or a negative
        ! Poisson's ratio, STICKSLIP_POISSON_RATIO for one above 1/2.
        function stickslip_kalker_coefficients(ratio, poisson_ratio, found) result(answer) bind(c)
            import
            real(c_double), value :: ratio
            real(c_double), value :: poisson_ratio
            type(stickslip_kalker), intent(out), optional :: found
            integer(c_int32_t) :: answer
        end function stickslip_kalker_coefficients

        ! Vermeulen and Johnson's contact of a body with the radii of curvature radius_x and radius_y (lengths) under this normal
        ! force, with a coefficient of friction, at creepages of either sign. STICKSLIP_COUPLED_MATERIALS for bodies whose Dundurs'
        ! beta is not zero, STICKSLIP_BELOW_MINIMUM for a contact longer than 16 times its width or the other way about.
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

        ! Takes a step of each of count histories, the i-th load for the i-th history, on the threads of stickslip_set_num_threads.
        ! Contacts of at most 4096 cells are solved on one thread each. Each comes to the bits that it has alone.
        !
        ! codes (may be NULL) gets what stickslip_history_step would return for each. STICKSLIP_SOME_FAILED if any failed: these
        ! are as they were, and the last error is that of the first of them; the others have taken their step. A history that
        ! occurs twice is STICKSLIP_BUSY the second time.
        function stickslip_history_step_all(histories, loads, count, codes) result(answer) bind(c)
            import
            type(stickslip_history), intent(in) :: histories(*)
            type(stickslip_load_step), intent(in), optional :: loads(*)
            integer(c_size_t), value :: count
            integer(c_int32_t), intent(inout), optional :: codes(*)
            integer(c_int32_t) :: answer
        end function stickslip_history_step_all

        ! Makes a solver of a gap before loading (lengths, count entries, copied). hardness (no limit), relative (none) and settings
        ! (the defaults) may be NULL.
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

        ! Frees a solver; nothing for NULL.
        function stickslip_coupled_solver_free(solver) result(answer) bind(c)
            import
            type(stickslip_coupled_solver), value :: solver
            integer(c_int32_t) :: answer
        end function stickslip_coupled_solver_free

        ! Changes the normal and the tangential load of the next solve.
        function stickslip_coupled_solver_set_load(solver, normal, tangential) result(answer) bind(c)
            import
            type(stickslip_coupled_solver), value :: solver
            type(stickslip_normal_load), intent(in), optional :: normal
            type(stickslip_tangential_load), intent(in), optional :: tangential
            integer(c_int32_t) :: answer
        end function stickslip_coupled_solver_set_load

        ! Changes the gap before loading of the next solve (lengths, count entries, copied).
        function stickslip_coupled_solver_set_gap(solver, gap, count) result(answer) bind(c)
            import
            type(stickslip_coupled_solver), value :: solver
            real(c_double), intent(in) :: gap(*)
            integer(c_size_t), value :: count
            integer(c_int32_t) :: answer
        end function stickslip_coupled_solver_set_gap

        ! Changes the friction of the next solve.
        function stickslip_coupled_solver_set_friction(solver, friction) result(answer) bind(c)
            import
            type(stickslip_coupled_solver), value :: solver
            type(stickslip_friction), intent(in), optional :: friction
            integer(c_int32_t) :: answer
        end function stickslip_coupled_solver_set_friction

        ! Changes method, tolerance and limits of the next solve.
        function stickslip_coupled_solver_set_settings(solver, settings) result(answer) bind(c)
            import
            type(stickslip_coupled_solver), value :: solver
            type(stickslip_settings), intent(in), optional :: settings
            integer(c_int32_t) :: answer
        end function stickslip_coupled_solver_set_settings

        ! Forgets the last answer: the next solve starts as the first did.
        function stickslip_coupled_solver_reset(solver) result(answer) bind(c)
            import
            type(stickslip_coupled_solver), value :: solver
            integer(c_int32_t) :: answer
        end function stickslip_coupled_solver_reset

        ! Solves into a solution of stickslip_coupled_solution_new for the same bodies. observer may be NULL. With
        ! STICKSLIP_NOT_CONVERGED the solution holds the last iterate and its report; after any other failure it is as it was.
        function stickslip_coupled_solver_solve(solver, solution, observer) result(answer) bind(c)
            import
            type(stickslip_coupled_solver), value :: solver
            type(stickslip_coupled_solution), value :: solution
            type(stickslip_observer), intent(in), optional :: observer
            integer(c_int32_t) :: answer
        end function stickslip_coupled_solver_solve

        ! Makes an empty solution of the right size for a solver.
        function stickslip_coupled_solution_new(solver, solution) result(answer) bind(c)
            import
            type(stickslip_coupled_solver), value :: solver
            type(stickslip_coupled_solution), intent(out) :: solution
            integer(c_int32_t) :: answer
        end function stickslip_coupled_solution_new

        ! Frees a solution; nothing for NULL.
        function stickslip_coupled_solution_free(solution) result(answer) bind(c)
            import
            type(stickslip_coupled_solution), value :: solution
            integer(c_int32_t) :: answer
        end function stickslip_coupled_solution_free

        ! A field, STICKSLIP_PRESSURE to STICKSLIP_DISPLACEMENT_Z, and how many cells it has (count may be NULL); NULL on failure.
        function stickslip_coupled_solution_field(solution, which, count) result(answer) bind(c)
            import
            type(stickslip_coupled_solution), value :: solution
            integer(c_int32_t), value :: which
            integer(c_size_t), intent(out), optional :: count
            type(c_ptr) :: answer
        end function stickslip_coupled_solution_field

        ! The zone of every cell; NULL on failure.
        function stickslip_coupled_solution_zones(solution, count) result(answer) bind(c)
            import
            type(stickslip_coupled_solution), value :: solution
            integer(c_size_t), intent(out), optional :: count
            type(c_ptr) :: answer
        end function stickslip_coupled_solution_zones

        ! The numbers of both halves; either may be NULL.
        function stickslip_coupled_solution_results(solution, normal, tangential) result(answer) bind(c)
            import
            type(stickslip_coupled_solution), value :: solution
            type(stickslip_normal_result), intent(out), optional :: normal
            type(stickslip_tangential_result), intent(out), optional :: tangential
            integer(c_int32_t) :: answer
        end function stickslip_coupled_solution_results

        ! How it was solved.
        function stickslip_coupled_solution_report(solution, report) result(answer) bind(c)
            import
            type(stickslip_coupled_solution), value :: solution
            type(stickslip_coupled_report), intent(out), optional :: report
            integer(c_int32_t) :: answer
        end function stickslip_coupled_solution_report

        ! Diagnostics that may mislead: as stickslip_normal_solution_warnings.
        function stickslip_coupled_solution_warnings(solution, buffer, capacity, count) result(answer) bind(c)
            import
            type(stickslip_coupled_solution), value :: solution
            type(stickslip_warning), intent(inout), optional :: buffer(*)
            integer(c_size_t), value :: capacity
            integer(c_size_t), intent(out), optional :: count
            integer(c_int32_t) :: answer
        end function stickslip_coupled_solution_warnings

        ! The stiffness of a coupled contact on the bodies and with the friction it was solved for.
        function stickslip_coupled_solution_stiffness(solution, half_space, friction, stiffness) result(answer) bind(c)
            import
            type(stickslip_coupled_solution), value :: solution
            type(stickslip_half_space), value :: half_space
            type(stickslip_friction), intent(in), optional :: friction
            type(stickslip_stiffness), intent(out), optional :: stiffness
            integer(c_int32_t) :: answer
        end function stickslip_coupled_solution_stiffness

        ! The same with an observer (may be NULL), which is called before every product with the operator and may end it:
        ! STICKSLIP_NOT_CONVERGED, and stiffness is as it was.
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

        ! Makes a solver of a gap before loading (lengths, count entries, copied) under a normal load. load (no creepage, no spin)
        ! and options (the defaults) may be NULL.
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

        ! Frees a solver; nothing for NULL.
        function stickslip_coupled_rolling_solver_free(solver) result(answer) bind(c)
            import
            type(stickslip_coupled_rolling_solver), value :: solver
            integer(c_int32_t) :: answer
        end function stickslip_coupled_rolling_solver_free

        ! Changes the normal load of the next solve.
        function stickslip_coupled_rolling_solver_set_normal_load(solver, normal) result(answer) bind(c)
            import
            type(stickslip_coupled_rolling_solver), value :: solver
            type(stickslip_normal_load), intent(in), optional :: normal
            integer(c_int32_t) :: answer
        end function stickslip_coupled_rolling_solver_set_normal_load

        ! Changes creepages, forces, spin or moment of the next solve.
        function stickslip_coupled_rolling_solver_set_load(solver, load) result(answer) bind(c)
            import
            type(stickslip_coupled_rolling_solver), value :: solver
            type(stickslip_rolling_load), intent(in), optional :: load
            integer(c_int32_t) :: answer
        end function stickslip_coupled_rolling_solver_set_load

        ! Changes the gap before loading of the next solve (lengths, count entries, copied).
        function stickslip_coupled_rolling_solver_set_gap(solver, gap, count) result(answer) bind(c)
            import
            type(stickslip_coupled_rolling_solver), value :: solver
            real(c_double), intent(in) :: gap(*)
            integer(c_size_t), value :: count
            integer(c_int32_t) :: answer
        end function stickslip_coupled_rolling_solver_set_gap

        ! Changes the friction of the next solve.
        function stickslip_coupled_rolling_solver_set_friction(solver, friction) result(answer) bind(c)
            import
            type(stickslip_coupled_rolling_solver), value :: solver
            type(stickslip_friction), intent(in), optional :: friction
            integer(c_int32_t) :: answer
        end function stickslip_coupled_rolling_solver_set_friction

        ! Changes method, tolerance and limits of the next solve.
        function stickslip_coupled_rolling_solver_set_settings(solver, settings) result(answer) bind(c)
            import
            type(stickslip_coupled_rolling_solver), value :: solver
            type(stickslip_settings), intent(in), optional :: settings
            integer(c_int32_t) :: answer
        end function stickslip_coupled_rolling_solver_set_settings

        ! Forgets the last answer: the next solve starts as the first did.
        function stickslip_coupled_rolling_solver_reset(solver) result(answer) bind(c)
            import
            type(stickslip_coupled_rolling_solver), value :: solver
            integer(c_int32_t) :: answer
        end function stickslip_coupled_rolling_solver_reset

        ! Solves into a solution of stickslip_coupled_rolling_solution_new for the same bodies. observer may be NULL. With
        ! STICKSLIP_NOT_CONVERGED the solution holds the last iterate and its report.
        function stickslip_coupled_rolling_solver_solve(solver, solution, observer) result(answer) bind(c)
            import
            type(stickslip_coupled_rolling_solver), value :: solver
            type(stickslip_coupled_rolling_solution), value :: solution
            type(stickslip_observer), intent(in), optional :: observer
            integer(c_int32_t) :: answer
        end function stickslip_coupled_rolling_solver_solve

        ! The slopes of the loads about the last answer, with the pressure that follows the tractions. observer may be NULL.
        ! STICKSLIP_NOT_CONVERGED before the first solve.
        function stickslip_coupled_rolling_solver_stiffness(solver, observer, stiffness) result(answer) bind(c)
            import
            type(stickslip_coupled_rolling_solver), value :: solver
            type(stickslip_observer), intent(in), optional :: observer
            type(stickslip_rolling_stiffness), intent(out), optional :: stiffness
            integer(c_int32_t) :: answer
        end function stickslip_coupled_rolling_solver_stiffness

        ! Makes an empty solution of the right size for a solver.
        function stickslip_coupled_rolling_solution_new(solver, solution) result(answer) bind(c)
            import
            type(stickslip_coupled_rolling_solver), value :: solver
            type(stickslip_coupled_rolling_solution), intent(out) :: solution
            integer(c_int32_t) :: answer
        end function stickslip_coupled_rolling_solution_new

        ! Frees a solution; nothing for NULL.
        function stickslip_coupled_rolling_solution_free(solution) result(answer) bind(c)
            import
            type(stickslip_coupled_rolling_solution), value :: solution
            integer(c_int32_t) :: answer
        end function stickslip_coupled_rolling_solution_free

        ! STICKSLIP_PRESSURE, STICKSLIP_GAP, STICKSLIP_TRACTION_X, STICKSLIP_SLIP_X or those along y, and how many cells it has (count
        ! may be NULL); NULL on failure. The slip is the slip for each length rolled (dimensionless).
        function stickslip_coupled_rolling_solution_field(solution, which, count) result(answer) bind(c)
            import
            type(stickslip_coupled_rolling_solution), value :: solution
            integer(c_int32_t), value :: which
            integer(c_size_t), intent(out), optional :: count
            type(c_ptr) :: answer
        end function stickslip_coupled_rolling_solution_field

        ! The zone of every cell, STICKSLIP_SEPARATED, STICKSLIP_STICK or STICKSLIP_SLIP; NULL on failure.
        function stickslip_coupled_rolling_solution_zones(solution, count) result(answer) bind(c)
            import
            type(stickslip_coupled_rolling_solution), value :: solution
            integer(c_size_t), intent(out), optional :: count
            type(c_ptr) :: answer
        end function stickslip_coupled_rolling_solution_zones

        ! The numbers of both halves; either may be NULL.
        function stickslip_coupled_rolling_solution_results(solution, normal, rolling) result(answer) bind(c)
            import
            type(stickslip_coupled_rolling_solution), value :: solution
            type(stickslip_normal_result), intent(out), optional :: normal
            type(stickslip_rolling_result), intent(out), optional :: rolling
            integer(c_int32_t) :: answer
        end function stickslip_coupled_rolling_solution_results

        ! Report of the solve.
        function stickslip_coupled_rolling_solution_report(solution, report) result(answer) bind(c)
            import
            type(stickslip_coupled_rolling_solution), value :: solution
            type(stickslip_coupled_rolling_report), intent(out), optional :: report
            integer(c_int32_t) :: answer
        end function stickslip_coupled_rolling_solution_report

        ! Diagnostics that may mislead: as stickslip_normal_solution_warnings.
        function stickslip_coupled_rolling_solution_warnings(solution, buffer, capacity, count) result(answer) bind(c)
            import
            type(stickslip_coupled_rolling_solution), value :: solution
            type(stickslip_warning), intent(inout), optional :: buffer(*)
            integer(c_size_t), value :: capacity
            integer(c_size_t), intent(out), optional :: count
            integer(c_int32_t) :: answer
        end function stickslip_coupled_rolling_solution_warnings

        ! Begins a cycle at the present state of a history.
        function stickslip_cycle_new(history, cycle) result(answer) bind(c)
            import
            type(stickslip_history), value :: history
            type(stickslip_cycle), intent(out) :: cycle
            integer(c_int32_t) :: answer
        end function stickslip_cycle_new

        ! Frees a cycle; nothing for NULL.
        function stickslip_cycle_free(cycle) result(answer) bind(c)
            import
            type(stickslip_cycle), value :: cycle
            integer(c_int32_t) :: answer
        end function stickslip_cycle_free

        ! Begins the cycle anew, at the present state of a history.
        function stickslip_cycle_begin(cycle, history) result(answer) bind(c)
            import
            type(stickslip_cycle), value :: cycle
            type(stickslip_history), value :: history
            integer(c_int32_t) :: answer
        end function stickslip_cycle_begin

        ! Adds the last step of the history, which must be new (else STICKSLIP_STEP_ALREADY_COUNTED).
        function stickslip_cycle_add(cycle, history) result(answer) bind(c)
            import
            type(stickslip_cycle), value :: cycle
            type(stickslip_history), value :: history
            integer(c_int32_t) :: answer
        end function stickslip_cycle_add

        ! The numbers of the cycle.
        function stickslip_cycle_result_of(cycle, result) result(answer) bind(c)
            import
            type(stickslip_cycle), value :: cycle
            type(stickslip_cycle_result), intent(out), optional :: result
            integer(c_int32_t) :: answer
        end function stickslip_cycle_result_of

        ! A field of the cycle: STICKSLIP_SLIP_DISTANCE, STICKSLIP_DISSIPATED_ENERGY, STICKSLIP_SLIP_PRESSURE,
        ! STICKSLIP_SLIP_AMPLITUDE_X or _Y; NULL on failure. It is valid until the next call that changes the cycle.
        function stickslip_cycle_field(cycle, which, count) result(answer) bind(c)
            import
            type(stickslip_cycle), value :: cycle
            integer(c_int32_t), value :: which
            integer(c_size_t), intent(out), optional :: count
            type(c_ptr) :: answer
        end function stickslip_cycle_field

        ! The edge of the contact inside the cells, and the pressure there.
        !
        ! centres and means, which have cells entries, get the pressure at the centres of the cells and its means over the cells; each
        ! may be NULL. Most accurate with STICKSLIP_CENTRE.
        function stickslip_normal_solution_edges(solution, edges, centres, means, cells) result(answer) bind(c)
            import
            type(stickslip_normal_solution), value :: solution
            type(stickslip_edges), intent(out), optional :: edges
            real(c_double), intent(inout) :: centres(*)
            real(c_double), intent(inout) :: means(*)
            integer(c_size_t), value :: cells
            integer(c_int32_t) :: answer
        end function stickslip_normal_solution_edges

        ! The edges of the contact and of the stick zone inside the cells, under the pressure and the friction of the problem. They are
        ! those of a contact loaded once.
        !
        ! centres and means, which have cells entries, get the magnitude of the traction at the centres of the cells and its means over
        ! the cells; each may be NULL.
        function stickslip_tangential_solution_edges(solution, normal, friction, edges, centres, means, &
            cells) result(answer) bind(c)
            import
            type(stickslip_tangential_solution), value :: solution
            type(stickslip_normal_solution), value :: normal
            type(stickslip_friction), intent(in), optional :: friction
            type(stickslip_edges), intent(out), optional :: edges
            real(c_double), intent(inout) :: centres(*)
            real(c_double), intent(inout) :: means(*)
            integer(c_size_t), value :: cells
            integer(c_int32_t) :: answer
        end function stickslip_tangential_solution_edges

        ! The edges of a contact whose pressure and traction were found together: as stickslip_tangential_solution_edges. The pressure
        ! comes from stickslip_coupled_solution_pressure_edges.
        function stickslip_coupled_solution_edges(solution, friction, edges, centres, means, &
            cells) result(answer) bind(c)
            import
            type(stickslip_coupled_solution), value :: solution
            type(stickslip_friction), intent(in), optional :: friction
            type(stickslip_edges), intent(out), optional :: edges
            real(c_double), intent(inout) :: centres(*)
            real(c_double), intent(inout) :: means(*)
            integer(c_size_t), value :: cells
            integer(c_int32_t) :: answer
        end function stickslip_coupled_solution_edges

        ! The edge of the contact alone, with its pressure: as stickslip_normal_solution_edges.
        function stickslip_coupled_solution_pressure_edges(solution, edges, centres, means, &
            cells) result(answer) bind(c)
            import
            type(stickslip_coupled_solution), value :: solution
            type(stickslip_edges), intent(out), optional :: edges
            real(c_double), intent(inout) :: centres(*)
            real(c_double), intent(inout) :: means(*)
            integer(c_size_t), value :: cells
            integer(c_int32_t) :: answer
        end function stickslip_coupled_solution_pressure_edges

        ! An estimate of the relative error that the cells leave in the pressure: the sum over cells of the error of its means. NaN
        ! without contact.
        function stickslip_normal_solution_discretisation_estimate(solution, estimate) result(answer) bind(c)
            import
            type(stickslip_normal_solution), value :: solution
            real(c_double), intent(out), optional :: estimate
            integer(c_int32_t) :: answer
        end function stickslip_normal_solution_discretisation_estimate

        ! The same of the traction; NaN without any.
        function stickslip_tangential_solution_discretisation_estimate(solution, estimate) result(answer) bind(c)
            import
            type(stickslip_tangential_solution), value :: solution
            real(c_double), intent(out), optional :: estimate
            integer(c_int32_t) :: answer
        end function stickslip_tangential_solution_discretisation_estimate

        ! The same of pressure and traction that were found together; NaN of what there is not.
        function stickslip_coupled_solution_discretisation_estimates(solution, of_pressure, &
            of_traction) result(answer) bind(c)
            import
            type(stickslip_coupled_solution), value :: solution
            real(c_double), intent(out), optional :: of_pressure
            real(c_double), intent(out), optional :: of_traction
            integer(c_int32_t) :: answer
        end function stickslip_coupled_solution_discretisation_estimates

        ! The message of the last failure on this thread, in English, UTF-8; empty before any. The pointer is the same for every
        ! failure of a thread, and valid until the thread ends.
        function stickslip_last_error_message() result(answer) bind(c)
            import
            type(c_ptr) :: answer
        end function stickslip_last_error_message

        ! The numbers of the last failure on this thread.
        function stickslip_last_error(error) result(answer) bind(c)
            import
            type(stickslip_error), intent(out), optional :: error
            integer(c_int32_t) :: answer
        end function stickslip_last_error

        ! The report of the last failure on this thread, if that was STICKSLIP_NOT_CONVERGED; else STICKSLIP_INVALID_ARGUMENT.
        function stickslip_last_error_report(report) result(answer) bind(c)
            import
            type(stickslip_report), intent(out), optional :: report
            integer(c_int32_t) :: answer
        end function stickslip_last_error_report

        ! Makes the bodies: nothing is computed yet. A NULL boundary is STICKSLIP_NON_PERIODIC.
        function stickslip_half_space_new(grid, body_1, body_2, boundary, half_space) result(answer) bind(c)
            import
            type(stickslip_grid), intent(in), optional :: grid
            type(stickslip_material), intent(in), optional :: body_1
            type(stickslip_material), intent(in), optional :: body_2
            type(stickslip_boundary), intent(in), optional :: boundary
            type(stickslip_half_space), intent(out) :: half_space
            integer(c_int32_t) :: answer
        end function stickslip_half_space_new

        ! The same of bodies under layers, each the outermost first, at most eight; no layers leave a body as it is.
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

        ! The same of bodies whose rows are dealt out to ranks, which solve together to the bits of one: every rank makes them of the
        ! whole grid, and then the same calls in the same order. The grid of the bodies is that of the rows of this rank, from
        ! stickslip_half_space_first_row on, as are all arrays and labels; sums, reports and spots are those of the whole contact.
        !
        ! Of the functions that return or take a grid alone none knows that it is a part: gaps are made by the program. Where ranks are
        ! threads of one process, stickslip_set_num_threads(1) must keep each in its own: else they wait for the same threads for ever.
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

        ! The first row of the whole grid that this rank has; zero where no ranks share it.
        function stickslip_half_space_first_row(half_space, row) result(answer) bind(c)
            import
            type(stickslip_half_space), value :: half_space
            integer(c_size_t), intent(out), optional :: row
            integer(c_int32_t) :: answer
        end function stickslip_half_space_first_row

        ! Chooses the meaning of the pressure and the traction of a cell, STICKSLIP_UNIFORM (at first) or STICKSLIP_CENTRE, for what is
        ! made of the bodies from now on. On a grid with STICKSLIP_PERIODIC values are those at the centres in any case.
        function stickslip_half_space_set_cell_value(half_space, value) result(answer) bind(c)
            import
            type(stickslip_half_space), value :: half_space
            integer(c_int32_t), value :: value
            integer(c_int32_t) :: answer
        end function stickslip_half_space_set_cell_value

        ! The meaning of the pressure and the traction of a cell: STICKSLIP_UNIFORM or STICKSLIP_CENTRE.
        function stickslip_half_space_cell_value(half_space, value) result(answer) bind(c)
            import
            type(stickslip_half_space), value :: half_space
            integer(c_int32_t), intent(out), optional :: value
            integer(c_int32_t) :: answer
        end function stickslip_half_space_cell_value

        ! Frees the bodies; nothing for NULL.
        function stickslip_half_space_free(half_space) result(answer) bind(c)
            import
            type(stickslip_half_space), value :: half_space
            integer(c_int32_t) :: answer
        end function stickslip_half_space_free

        ! The grid.
        function stickslip_half_space_grid(half_space, grid) result(answer) bind(c)
            import
            type(stickslip_half_space), value :: half_space
            type(stickslip_grid), intent(out), optional :: grid
            integer(c_int32_t) :: answer
        end function stickslip_half_space_grid

        ! The constants of the pair.
        function stickslip_half_space_pair(half_space, pair) result(answer) bind(c)
            import
            type(stickslip_half_space), value :: half_space
            type(stickslip_pair), intent(out), optional :: pair
            integer(c_int32_t) :: answer
        end function stickslip_half_space_pair

        ! The options that histories have by default.
        function stickslip_history_options_default() result(answer) bind(c)
            import
            type(stickslip_history_options) :: answer
        end function stickslip_history_options_default

        ! Makes a history of a gap before loading (lengths, count entries, copied); nothing touches before the first step. options
        ! may be NULL (the defaults).
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

        ! Makes a copy of a history, independent of it: steps of one do not change the other.
        function stickslip_history_clone(history, copy) result(answer) bind(c)
            import
            type(stickslip_history), value :: history
            type(stickslip_history), intent(out) :: copy
            integer(c_int32_t) :: answer
        end function stickslip_history_clone

        ! Frees a history; nothing for NULL.
        function stickslip_history_free(history) result(answer) bind(c)
            import
            type(stickslip_history), value :: history
            integer(c_int32_t) :: answer
        end function stickslip_history_free

        ! Takes a step. observer may be NULL. After a failure the history is as it was; after STICKSLIP_NOT_CONVERGED
        ! stickslip_last_error_report has the report.
        function stickslip_history_step(history, load, observer) result(answer) bind(c)
            import
            type(stickslip_history), value :: history
            type(stickslip_load_step), intent(in), optional :: load
            type(stickslip_observer), intent(in), optional :: observer
            integer(c_int32_t) :: answer
        end function stickslip_history_step

        ! Takes a load in as many steps of equal growth of the contact as a tolerance in (0, 1) needs, and writes their number to
        ! taken (may be NULL). A contact of dissimilar bodies must be pressed so. It takes the load in 1, 2, 4, 8, ... steps from the
        ! present state, until the tractions change by no more than the tolerance times the friction limits: 0.01 is a good choice.
        ! observer may be NULL; it receives the iterations of all steps. After a failure, which may be STICKSLIP_STEP_TOO_LONG, the
        ! state of the history is unchanged; its last step is the last one that succeeded.
        function stickslip_history_press(history, load, tolerance, observer, taken) result(answer) bind(c)
            import
            type(stickslip_history), value :: history
            type(stickslip_load_step), intent(in), optional :: load
            real(c_double), value :: tolerance
            type(stickslip_observer), intent(in), optional :: observer
            integer(c_size_t), intent(out), optional :: taken
            integer(c_int32_t) :: answer
        end function stickslip_history_press

        ! Changes the gap before loading (lengths, count entries, copied), as wear does. The pressure stays until a step that
        ! gives a normal load again.
        function stickslip_history_set_gap(history, gap, count) result(answer) bind(c)
            import
            type(stickslip_history), value :: history
            real(c_double), intent(in) :: gap(*)
            integer(c_size_t), value :: count
            integer(c_int32_t) :: answer
        end function stickslip_history_set_gap

        ! Changes the friction from the next step on.
        function stickslip_history_set_friction(history, friction) result(answer) bind(c)
            import
            type(stickslip_history), value :: history
            type(stickslip_friction), intent(in), optional :: friction
            integer(c_int32_t) :: answer
        end function stickslip_history_set_friction

        ! Changes method, tolerance and limits from the next step on.
        function stickslip_history_set_settings(history, settings) result(answer) bind(c)
            import
            type(stickslip_history), value :: history
            type(stickslip_settings), intent(in), optional :: settings
            integer(c_int32_t) :: answer
        end function stickslip_history_set_settings

        ! Changes the pattern of the relative displacement from the next step on.
        function stickslip_history_set_relative_displacement(history, pattern) result(answer) bind(c)
            import
            type(stickslip_history), value :: history
            type(stickslip_relative_displacement), intent(in), optional :: pattern
            integer(c_int32_t) :: answer
        end function stickslip_history_set_relative_displacement

        ! The stiffness of the contact after the last step: normal, tangential on loading and at reversal.
        function stickslip_history_stiffness(history, stiffness) result(answer) bind(c)
            import
            type(stickslip_history), value :: history
            type(stickslip_stiffness), intent(out), optional :: stiffness
            integer(c_int32_t) :: answer
        end function stickslip_history_stiffness

        ! The same with an observer (may be NULL), which is called before every product with an operator and may end it:
        ! STICKSLIP_NOT_CONVERGED, and stiffness is as it was.
        function stickslip_history_stiffness_observed(history, observer, stiffness) result(answer) bind(c)
            import
            type(stickslip_history), value :: history
            type(stickslip_observer), intent(in), optional :: observer
            type(stickslip_stiffness), intent(out), optional :: stiffness
            integer(c_int32_t) :: answer
        end function stickslip_history_stiffness_observed

        ! The stiffness of a next step that starts from the present state. In loading and by_approach cells that stick resist fully,
        ! also those that came into contact in the last step, and cells at their limit continue to slip. A host that shears the contact
        ! further under the same normal load needs this. observer may be NULL.
        function stickslip_history_next_stiffness(history, observer, stiffness) result(answer) bind(c)
            import
            type(stickslip_history), value :: history
            type(stickslip_observer), intent(in), optional :: observer
            type(stickslip_stiffness), intent(out), optional :: stiffness
            integer(c_int32_t) :: answer
        end function stickslip_history_next_stiffness

        ! The numbers of the state. Stick ratio, gross slip, energies and creepages are those of the last step taken, zero before
        ! any and after the history was made from bytes.
        function stickslip_history_result(history, result) result(answer) bind(c)
            import
            type(stickslip_history), value :: history
            type(stickslip_step_result), intent(out), optional :: result
            integer(c_int32_t) :: answer
        end function stickslip_history_result

        ! The numbers of the normal contact.
        function stickslip_history_normal_result(history, result) result(answer) bind(c)
            import
            type(stickslip_history), value :: history
            type(stickslip_normal_result), intent(out), optional :: result
            integer(c_int32_t) :: answer
        end function stickslip_history_normal_result

        ! The grid of all fields.
        function stickslip_history_grid(history, grid) result(answer) bind(c)
            import
            type(stickslip_history), value :: history
            type(stickslip_grid), intent(out), optional :: grid
            integer(c_int32_t) :: answer
        end function stickslip_history_grid

        ! The largest tangential force that friction holds at the present pressure.
        function stickslip_history_friction_capacity(history, capacity) result(answer) bind(c)
            import
            type(stickslip_history), value :: history
            real(c_double), intent(out), optional :: capacity
            integer(c_int32_t) :: answer
        end function stickslip_history_friction_capacity

        ! How pressure and traction of the last step were solved; STICKSLIP_UNSOLVED if the pressure was held, or before anything
        ! has touched.
        function stickslip_history_reports(history, normal, tangential) result(answer) bind(c)
            import
            type(stickslip_history), value :: history
            type(stickslip_report), intent(out), optional :: normal
            type(stickslip_report), intent(out), optional :: tangential
            integer(c_int32_t) :: answer
        end function stickslip_history_reports

        ! Diagnostics on the last step: as stickslip_normal_solution_warnings.
        function stickslip_history_warnings(history, buffer, capacity, count) result(answer) bind(c)
            import
            type(stickslip_history), value :: history
            type(stickslip_warning), intent(inout), optional :: buffer(*)
            integer(c_size_t), value :: capacity
            integer(c_size_t), intent(out), optional :: count
            integer(c_int32_t) :: answer
        end function stickslip_history_warnings

        ! A field by its number, STICKSLIP_PRESSURE to STICKSLIP_YIELDED_DEPTH but displacements, and how many cells it has (count
        ! may be NULL); NULL on failure.
        function stickslip_history_field(history, which, count) result(answer) bind(c)
            import
            type(stickslip_history), value :: history
            integer(c_int32_t), value :: which
            integer(c_size_t), intent(out), optional :: count
            type(c_ptr) :: answer
        end function stickslip_history_field

        ! The zone of every cell after the last step; NULL on failure.
        function stickslip_history_zones(history, count) result(answer) bind(c)
            import
            type(stickslip_history), value :: history
            integer(c_size_t), intent(out), optional :: count
            type(c_ptr) :: answer
        end function stickslip_history_zones

        ! The settings that solvers and histories have by default.
        function stickslip_settings_default() result(answer) bind(c)
            import
            type(stickslip_settings) :: answer
        end function stickslip_settings_default

        ! Friction with one coefficient for all cells.
        function stickslip_coulomb(coefficient) result(answer) bind(c)
            import
            real(c_double), value :: coefficient
            type(stickslip_friction) :: answer
        end function stickslip_coulomb

        ! The limits that jumps have by default.
        function stickslip_jump_limits_default() result(answer) bind(c)
            import
            type(stickslip_jump_limits) :: answer
        end function stickslip_jump_limits_default

        ! Writes how many cycles like this one may be jumped over to cycles, not rounded: as many as their wear may be taken off at
        ! once without the pressure swinging, and no more than the limits (may be NULL: the defaults) allow; infinite if nothing
        ! limits them.
        !
        ! depth (lengths, count entries) is what the cycle removed, of both bodies together. STICKSLIP_CYCLE_NOT_CLOSED for a cycle
        ! that does not close, as the first from rest; STICKSLIP_NEGATIVE_OR_NOT_FINITE for a limit, STICKSLIP_SAMPLE for a depth.
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

        ! Writes to cycles how many cycles of wear may be taken off at once without the pressure swinging up: explicit wear by
        ! Archard's law is stable below. coefficient (one over a pressure) is the sum of both bodies, slip_distance (lengths, count
        ! entries) that of one cycle; for the energy law the coefficient is that of the law times that of friction. Infinite if
        ! nothing slips.
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

        ! Makes a solver of a gap before loading (lengths, count entries, copied) under a load.
        !
        ! settings may be NULL (the defaults), as may hardness, the largest pressure that the cells carry (no limit).
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

        ! Frees a solver; nothing for NULL.
        function stickslip_normal_solver_free(solver) result(answer) bind(c)
            import
            type(stickslip_normal_solver), value :: solver
            integer(c_int32_t) :: answer
        end function stickslip_normal_solver_free

        ! Changes the load of the next solve.
        function stickslip_normal_solver_set_load(solver, load) result(answer) bind(c)
            import
            type(stickslip_normal_solver), value :: solver
            type(stickslip_normal_load), intent(in), optional :: load
            integer(c_int32_t) :: answer
        end function stickslip_normal_solver_set_load

        ! Changes the gap before loading of the next solve (lengths, count entries, copied).
        function stickslip_normal_solver_set_gap(solver, gap, count) result(answer) bind(c)
            import
            type(stickslip_normal_solver), value :: solver
            real(c_double), intent(in) :: gap(*)
            integer(c_size_t), value :: count
            integer(c_int32_t) :: answer
        end function stickslip_normal_solver_set_gap

        ! Changes method, tolerance and limits of the next solve.
        function stickslip_normal_solver_set_settings(solver, settings) result(answer) bind(c)
            import
            type(stickslip_normal_solver), value :: solver
            type(stickslip_settings), intent(in), optional :: settings
            integer(c_int32_t) :: answer
        end function stickslip_normal_solver_set_settings

        ! Forgets the last answer: the next solve starts as the first did.
        function stickslip_normal_solver_reset(solver) result(answer) bind(c)
            import
            type(stickslip_normal_solver), value :: solver
            integer(c_int32_t) :: answer
        end function stickslip_normal_solver_reset

        ! Solves into a solution of stickslip_normal_solution_new for the same bodies. observer may be NULL.
        !
        ! With STICKSLIP_NOT_CONVERGED the solution holds the last feasible iterate and its report; after any other failure it is
        ! as it was.
        function stickslip_normal_solver_solve(solver, solution, observer) result(answer) bind(c)
            import
            type(stickslip_normal_solver), value :: solver
            type(stickslip_normal_solution), value :: solution
            type(stickslip_observer), intent(in), optional :: observer
            integer(c_int32_t) :: answer
        end function stickslip_normal_solver_solve

        ! Makes an empty solution of the right size for a solver.
        function stickslip_normal_solution_new(solver, solution) result(answer) bind(c)
            import
            type(stickslip_normal_solver), value :: solver
            type(stickslip_normal_solution), intent(out) :: solution
            integer(c_int32_t) :: answer
        end function stickslip_normal_solution_new

        ! Frees a solution; nothing for NULL.
        function stickslip_normal_solution_free(solution) result(answer) bind(c)
            import
            type(stickslip_normal_solution), value :: solution
            integer(c_int32_t) :: answer
        end function stickslip_normal_solution_free

        ! STICKSLIP_PRESSURE or STICKSLIP_GAP, and how many cells it has (count may be NULL); NULL on failure.
        function stickslip_normal_solution_field(solution, which, count) result(answer) bind(c)
            import
            type(stickslip_normal_solution), value :: solution
            integer(c_int32_t), value :: which
            integer(c_size_t), intent(out), optional :: count
            type(c_ptr) :: answer
        end function stickslip_normal_solution_field

        ! The numbers of the contact.
        function stickslip_normal_solution_result(solution, result) result(answer) bind(c)
            import
            type(stickslip_normal_solution), value :: solution
            type(stickslip_normal_result), intent(out), optional :: result
            integer(c_int32_t) :: answer
        end function stickslip_normal_solution_result

        ! How it was solved.
        function stickslip_normal_solution_report(solution, report) result(answer) bind(c)
            import
            type(stickslip_normal_solution), value :: solution
            type(stickslip_report), intent(out), optional :: report
            integer(c_int32_t) :: answer
        end function stickslip_normal_solution_report

        ! Diagnostics that may mislead: writes them to a buffer of capacity entries, and how many there are to count. With
        ! capacity 0 only the number.
        function stickslip_normal_solution_warnings(solution, buffer, capacity, count) result(answer) bind(c)
            import
            type(stickslip_normal_solution), value :: solution
            type(stickslip_warning), intent(inout), optional :: buffer(*)
            integer(c_size_t), value :: capacity
            integer(c_size_t), intent(out), optional :: count
            integer(c_int32_t) :: answer
        end function stickslip_normal_solution_warnings

        ! The stiffness of a normal contact on the bodies it was solved for.
        function stickslip_normal_solution_stiffness(solution, half_space, stiffness) result(answer) bind(c)
            import
            type(stickslip_normal_solution), value :: solution
            type(stickslip_half_space), value :: half_space
            type(stickslip_normal_stiffness), intent(out), optional :: stiffness
            integer(c_int32_t) :: answer
        end function stickslip_normal_solution_stiffness

        ! The same with an observer (may be NULL), which is called before every product with the operator and may end it:
        ! STICKSLIP_NOT_CONVERGED, and stiffness is as it was.
        function stickslip_normal_solution_stiffness_observed(solution, half_space, observer, &
            stiffness) result(answer) bind(c)
            import
            type(stickslip_normal_solution), value :: solution
            type(stickslip_half_space), value :: half_space
            type(stickslip_observer), intent(in), optional :: observer
            type(stickslip_normal_stiffness), intent(out), optional :: stiffness
            integer(c_int32_t) :: answer
        end function stickslip_normal_solution_stiffness_observed

        ! Makes planes at count depths (lengths, zero or positive, copied) below the surface of either body; with displacements
        ! if that is not zero. The kernels of a depth, 112 bytes for each cell (152 with displacements), are made when it is first
        ! solved, and kept.
        function stickslip_planes_new(half_space, depths, count, with_displacements, planes) result(answer) bind(c)
            import
            type(stickslip_half_space), value :: half_space
            real(c_double), intent(in) :: depths(*)
            integer(c_size_t), value :: count
            integer(c_int32_t), value :: with_displacements
            type(stickslip_planes), intent(out) :: planes
            integer(c_int32_t) :: answer
        end function stickslip_planes_new

        ! Frees planes; nothing for NULL.
        function stickslip_planes_free(planes) result(answer) bind(c)
            import
            type(stickslip_planes), value :: planes
            integer(c_int32_t) :: answer
        end function stickslip_planes_free

        ! Solves the plane at the depth of number index, counted from zero, in body STICKSLIP_BODY_1 or STICKSLIP_BODY_2, by fast
        ! transforms. STICKSLIP_LENGTH for an index that is not less than the number of depths, STICKSLIP_RIGID_BODY for a rigid
        ! body. After a failure the plane solved last is as it was.
        function stickslip_planes_solve(planes, index, which, tractions) result(answer) bind(c)
            import
            type(stickslip_planes), value :: planes
            integer(c_size_t), value :: index
            integer(c_int32_t), value :: which
            type(stickslip_tractions), intent(in), optional :: tractions
            integer(c_int32_t) :: answer
        end function stickslip_planes_solve

        ! The same with an observer (may be NULL), which is called before the kernels are sampled and before each transform of a
        ! kernel and of three components, and may end it: STICKSLIP_NOT_CONVERGED. Watched, it takes memory for another plane.
        function stickslip_planes_solve_observed(planes, index, which, tractions, observer) result(answer) bind(c)
            import
            type(stickslip_planes), value :: planes
            integer(c_size_t), value :: index
            integer(c_int32_t), value :: which
            type(stickslip_tractions), intent(in), optional :: tractions
            type(stickslip_observer), intent(in), optional :: observer
            integer(c_int32_t) :: answer
        end function stickslip_planes_solve_observed

        ! A field of the plane solved last, STICKSLIP_STRESS_XX to STICKSLIP_STRESS_YZ or, of planes made with displacements,
        ! STICKSLIP_DISPLACEMENT_X to STICKSLIP_DISPLACEMENT_Z, and how many cells it has (count may be NULL); NULL on failure.
        function stickslip_planes_field(planes, which, count) result(answer) bind(c)
            import
            type(stickslip_planes), value :: planes
            integer(c_int32_t), value :: which
            integer(c_size_t), intent(out), optional :: count
            type(c_ptr) :: answer
        end function stickslip_planes_field

        ! Writes STICKSLIP_VON_MISES, STICKSLIP_MAX_SHEAR or STICKSLIP_HYDROSTATIC of each cell of the plane solved last to
        ! values, which has count entries.
        function stickslip_planes_measure(planes, which, values, count) result(answer) bind(c)
            import
            type(stickslip_planes), value :: planes
            integer(c_int32_t), value :: which
            real(c_double), intent(inout) :: values(*)
            integer(c_size_t), value :: count
            integer(c_int32_t) :: answer
        end function stickslip_planes_measure

        ! Room for so many words of a block that is received, to be filled before the swap returns; NULL if there is no memory.
        ! Called by a stickslip_swap alone, on the block that it was given.
        function stickslip_block_room(block, words) result(answer) bind(c)
            import
            type(stickslip_block), value :: block
            integer(c_size_t), value :: words
            type(c_ptr) :: answer
        end function stickslip_block_room

        ! The options that rolling solvers have by default.
        function stickslip_rolling_options_default() result(answer) bind(c)
            import
            type(stickslip_rolling_options) :: answer
        end function stickslip_rolling_options_default

        ! Makes a solver under the pressure of a solved normal contact on the same bodies, with room of a step of cells ahead of
        ! the contact, else STICKSLIP_GRID_TOO_SHORT. load (no creepage, no spin) and options (the defaults) may be NULL.
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

        ! Frees a solver; nothing for NULL.
        function stickslip_rolling_solver_free(solver) result(answer) bind(c)
            import
            type(stickslip_rolling_solver), value :: solver
            integer(c_int32_t) :: answer
        end function stickslip_rolling_solver_free

        ! Changes what is prescribed of the next solve. STICKSLIP_BEYOND_FRICTION_CAPACITY for a force or a moment that friction
        ! does not hold, or holds only by sliding.
        function stickslip_rolling_solver_set_load(solver, load) result(answer) bind(c)
            import
            type(stickslip_rolling_solver), value :: solver
            type(stickslip_rolling_load), intent(in), optional :: load
            integer(c_int32_t) :: answer
        end function stickslip_rolling_solver_set_load

        ! Changes the friction of the next solve. STICKSLIP_BEYOND_FRICTION_CAPACITY if it does not hold the present load, or holds
        ! it only by sliding. The stiffness is about the last answer, if there is one, until that solve.
        function stickslip_rolling_solver_set_friction(solver, friction) result(answer) bind(c)
            import
            type(stickslip_rolling_solver), value :: solver
            type(stickslip_friction), intent(in), optional :: friction
            integer(c_int32_t) :: answer
        end function stickslip_rolling_solver_set_friction

        ! Sets the pressure of the next solve to that of a solved normal contact on the same bodies. A contact within the largest
        ! window so far allocates nothing. STICKSLIP_BEYOND_FRICTION_CAPACITY if friction no longer holds the prescribed force.
        function stickslip_rolling_solver_set_normal(solver, normal) result(answer) bind(c)
            import
            type(stickslip_rolling_solver), value :: solver
            type(stickslip_normal_solution), value :: normal
            integer(c_int32_t) :: answer
        end function stickslip_rolling_solver_set_normal

        ! Sets the pressure of the next solve to one from elsewhere (count entries, copied). It has no gap:
        ! STICKSLIP_UNSUPPORTED_BY_MODEL unless the solver has STICKSLIP_WHOLE_STEP.
        function stickslip_rolling_solver_set_pressure(solver, pressure, count) result(answer) bind(c)
            import
            type(stickslip_rolling_solver), value :: solver
            real(c_double), intent(in) :: pressure(*)
            integer(c_size_t), value :: count
            integer(c_int32_t) :: answer
        end function stickslip_rolling_solver_set_pressure

        ! Sets the solver that finds the pressure of a new normal load; copied, with its gap, hardness and settings.
        function stickslip_rolling_solver_set_normal_solver(solver, normal) result(answer) bind(c)
            import
            type(stickslip_rolling_solver), value :: solver
            type(stickslip_normal_solver), value :: normal
            integer(c_int32_t) :: answer
        end function stickslip_rolling_solver_set_normal_solver

        ! Sets the normal load of the next solve, and solves for its pressure. STICKSLIP_UNSUPPORTED_BY_MODEL without a normal solver of
        ! stickslip_rolling_solver_set_normal_solver. After a failure the solver is unchanged.
        function stickslip_rolling_solver_set_normal_load(solver, load) result(answer) bind(c)
            import
            type(stickslip_rolling_solver), value :: solver
            type(stickslip_normal_load), intent(in), optional :: load
            integer(c_int32_t) :: answer
        end function stickslip_rolling_solver_set_normal_load

        ! The largest tangential force that friction holds.
        function stickslip_rolling_solver_friction_capacity(solver, capacity) result(answer) bind(c)
            import
            type(stickslip_rolling_solver), value :: solver
            real(c_double), intent(out), optional :: capacity
            integer(c_int32_t) :: answer
        end function stickslip_rolling_solver_friction_capacity

        ! Forgets the last answer: the next solve starts as the first did, and the stiffness is that of a contact that sticks.
        function stickslip_rolling_solver_reset(solver) result(answer) bind(c)
            import
            type(stickslip_rolling_solver), value :: solver
            integer(c_int32_t) :: answer
        end function stickslip_rolling_solver_reset

        ! Changes method, tolerance and limits of the next solve.
        function stickslip_rolling_solver_set_settings(solver, settings) result(answer) bind(c)
            import
            type(stickslip_rolling_solver), value :: solver
            type(stickslip_settings), intent(in), optional :: settings
            integer(c_int32_t) :: answer
        end function stickslip_rolling_solver_set_settings

        ! Solves into a solution of stickslip_rolling_solution_new for the same bodies. observer may be NULL.
        !
        ! With STICKSLIP_NOT_CONVERGED the solution holds the last feasible iterate and its report; after any other failure it is
        ! as it was, except that STICKSLIP_MEMORY in the search for the spin of a moment leaves the answer at another spin.
        function stickslip_rolling_solver_solve(solver, solution, observer) result(answer) bind(c)
            import
            type(stickslip_rolling_solver), value :: solver
            type(stickslip_rolling_solution), value :: solution
            type(stickslip_observer), intent(in), optional :: observer
            integer(c_int32_t) :: answer
        end function stickslip_rolling_solver_solve

        ! The slopes of the loads about the last answer. Cells that stick follow, cells that slip stay at their limits; before the
        ! first solve all cells stick: these are Kalker's coefficients, times G a b and lengths.
        function stickslip_rolling_solver_stiffness(solver, stiffness) result(answer) bind(c)
            import
            type(stickslip_rolling_solver), value :: solver
            type(stickslip_rolling_stiffness), intent(out), optional :: stiffness
            integer(c_int32_t) :: answer
        end function stickslip_rolling_solver_stiffness

        ! The same with an observer (may be NULL), which is called before every product with an operator and may end it:
        ! STICKSLIP_NOT_CONVERGED, and stiffness is as it was.
        function stickslip_rolling_solver_stiffness_observed(solver, observer, stiffness) result(answer) bind(c)
            import
            type(stickslip_rolling_solver), value :: solver
            type(stickslip_observer), intent(in), optional :: observer
            type(stickslip_rolling_stiffness), intent(out), optional :: stiffness
            integer(c_int32_t) :: answer
        end function stickslip_rolling_solver_stiffness_observed

        ! The loads at count points, written to forces, each solved from the answer of the one before: neighbours in the order
        ! should be neighbours in the plane. The last point stays prescribed. All are checked before the first is solved. With
        ! STICKSLIP_NOT_CONVERGED the point that failed stays prescribed, and forces are as they were.
        function stickslip_rolling_solver_creep_forces(solver, points, count, forces) result(answer) bind(c)
            import
            type(stickslip_rolling_solver), value :: solver
            type(stickslip_creep_point), intent(in), optional :: points(*)
            integer(c_size_t), value :: count
            type(stickslip_creep_force), intent(inout), optional :: forces(*)
            integer(c_int32_t) :: answer
        end function stickslip_rolling_solver_creep_forces

        ! The same with an observer (may be NULL), which is called before every product with an operator and may end it:
        ! STICKSLIP_NOT_CONVERGED, the point under way stays prescribed, and forces are as they were.
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

        ! Makes an empty solution of the right size for a solver.
        function stickslip_rolling_solution_new(solver, solution) result(answer) bind(c)
            import
            type(stickslip_rolling_solver), value :: solver
            type(stickslip_rolling_solution), intent(out) :: solution
            integer(c_int32_t) :: answer
        end function stickslip_rolling_solution_new

        ! Frees a solution; nothing for NULL.
        function stickslip_rolling_solution_free(solution) result(answer) bind(c)
            import
            type(stickslip_rolling_solution), value :: solution
            integer(c_int32_t) :: answer
        end function stickslip_rolling_solution_free

        ! STICKSLIP_TRACTION_X, STICKSLIP_SLIP_X or those along y, and how many cells it has (count may be NULL); NULL on failure.
        ! The slip is that for each length rolled (dimensionless), over the step that brought the particles to their cells.
        function stickslip_rolling_solution_field(solution, which, count) result(answer) bind(c)
            import
            type(stickslip_rolling_solution), value :: solution
            integer(c_int32_t), value :: which
            integer(c_size_t), intent(out), optional :: count
            type(c_ptr) :: answer
        end function stickslip_rolling_solution_field

        ! The zone of every cell, STICKSLIP_SEPARATED, STICKSLIP_STICK or STICKSLIP_SLIP; NULL on failure.
        function stickslip_rolling_solution_zones(solution, count) result(answer) bind(c)
            import
            type(stickslip_rolling_solution), value :: solution
            integer(c_size_t), intent(out), optional :: count
            type(c_ptr) :: answer
        end function stickslip_rolling_solution_zones

        ! Energy that slip dissipates in each cell for each length rolled (a pressure), written to values, which has count
        ! entries: what wear follows. Between bodies of the same material its integral is less than the work by a part that falls
        ! with the size of the cells.
        function stickslip_rolling_solution_dissipation(solution, values, count) result(answer) bind(c)
            import
            type(stickslip_rolling_solution), value :: solution
            real(c_double), intent(inout) :: values(*)
            integer(c_size_t), value :: count
            integer(c_int32_t) :: answer
        end function stickslip_rolling_solution_dissipation

        ! The numbers of the contact.
        function stickslip_rolling_solution_result(solution, result) result(answer) bind(c)
            import
            type(stickslip_rolling_solution), value :: solution
            type(stickslip_rolling_result), intent(out), optional :: result
            integer(c_int32_t) :: answer
        end function stickslip_rolling_solution_result

        ! How it was solved.
        function stickslip_rolling_solution_report(solution, report) result(answer) bind(c)
            import
            type(stickslip_rolling_solution), value :: solution
            type(stickslip_report), intent(out), optional :: report
            integer(c_int32_t) :: answer
        end function stickslip_rolling_solution_report

        ! Diagnostics that may mislead: as stickslip_normal_solution_warnings.
        function stickslip_rolling_solution_warnings(solution, buffer, capacity, count) result(answer) bind(c)
            import
            type(stickslip_rolling_solution), value :: solution
            type(stickslip_warning), intent(inout), optional :: buffer(*)
            integer(c_size_t), value :: capacity
            integer(c_size_t), intent(out), optional :: count
            integer(c_int32_t) :: answer
        end function stickslip_rolling_solution_warnings

        ! The options of a self-affine surface by default; height or slope is to be given.
        function stickslip_self_affine_default() result(answer) bind(c)
            import
            type(stickslip_self_affine) :: answer
        end function stickslip_self_affine_default

        ! Writes the heights of a random surface (lengths, positive out of the body, of zero mean) to heights, which has count
        ! entries. The gap of this surface to a plane is any constant less the height.
        !
        ! STICKSLIP_INVALID_ARGUMENT if height and slope are both given, STICKSLIP_NOT_POSITIVE for height, slope or a wavelength,
        ! STICKSLIP_HURST for the exponent, STICKSLIP_NOT_FINITE for skewness or kurtosis; STICKSLIP_BELOW_MINIMUM for a cut-off of less
        ! than two cells, a wavelength less than the next shorter one or a kurtosis less than the squared skewness plus one;
        ! STICKSLIP_NO_WAVE_IN_BAND if no wave fits the wavelengths, STICKSLIP_HEIGHT_MOMENTS_NOT_REACHED if no heights of such skewness and
        ! kurtosis are found; STICKSLIP_SAMPLE for the first height that overflows. heights is then as it was.
        function stickslip_surface_self_affine(grid, surface, heights, count) result(answer) bind(c)
            import
            type(stickslip_grid), intent(in), optional :: grid
            type(stickslip_self_affine), intent(in), optional :: surface
            real(c_double), intent(inout) :: heights(*)
            integer(c_size_t), value :: count
            integer(c_int32_t) :: answer
        end function stickslip_surface_self_affine

        ! The same with an observer (may be NULL), which is called before each transform of the surface, also of the iterations for
        ! skewness and kurtosis, and may end it: STICKSLIP_NOT_CONVERGED.
        function stickslip_surface_self_affine_observed(grid, surface, observer, heights, count) result(answer) bind(c)
            import
            type(stickslip_grid), intent(in), optional :: grid
            type(stickslip_self_affine), intent(in), optional :: surface
            type(stickslip_observer), intent(in), optional :: observer
            real(c_double), intent(inout) :: heights(*)
            integer(c_size_t), value :: count
            integer(c_int32_t) :: answer
        end function stickslip_surface_self_affine_observed

        ! The statistics of count heights (lengths) on a grid. STICKSLIP_SAMPLE for the first height that is NaN or infinite,
        ! STICKSLIP_NOT_FINITE if their range or the square of their slopes overflows.
        function stickslip_surface_statistics(grid, heights, count, statistics) result(answer) bind(c)
            import
            type(stickslip_grid), intent(in), optional :: grid
            real(c_double), intent(in) :: heights(*)
            integer(c_size_t), value :: count
            type(stickslip_statistics), intent(out), optional :: statistics
            integer(c_int32_t) :: answer
        end function stickslip_surface_statistics

        ! The contact spots, in the order of their first cells, and how many there are. With a NULL buffer and capacity 0 only
        ! that; STICKSLIP_BUFFER_TOO_SMALL for a buffer that is too small, to which nothing is written.
        !
        ! labels, which has cells entries, gets the number of the spot of every cell, counted from one, and zero outside the
        ! contact; it may be NULL.
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

        ! The contact spots under the pressure of a normal contact, with the part of each that sticks: as
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

        ! The contact spots after the last step, with the part of each that sticks: as stickslip_normal_solution_spots.
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

        ! Keeps a copy of the state of a history.
        function stickslip_state_new(history, state) result(answer) bind(c)
            import
            type(stickslip_history), value :: history
            type(stickslip_state), intent(out) :: state
            integer(c_int32_t) :: answer
        end function stickslip_state_new

        ! Frees a state; nothing for NULL.
        function stickslip_state_free(state) result(answer) bind(c)
            import
            type(stickslip_state), value :: state
            integer(c_int32_t) :: answer
        end function stickslip_state_free

        ! Keeps the present state of a history in the place of an older one, whose memory it uses.
        function stickslip_state_keep(state, history) result(answer) bind(c)
            import
            type(stickslip_state), value :: state
            type(stickslip_history), value :: history
            integer(c_int32_t) :: answer
        end function stickslip_state_keep

        ! Returns a history to a state, one of its own or of another on equal bodies.
        function stickslip_history_set_state(history, state) result(answer) bind(c)
            import
            type(stickslip_history), value :: history
            type(stickslip_state), value :: state
            integer(c_int32_t) :: answer
        end function stickslip_history_set_state

        ! The state of a history as bytes, some 60 to 130 for each cell. A history made from them by stickslip_history_from_bytes
        ! takes further steps with the same results, bit for bit.
        !
        ! length gets how many there are. With a NULL buffer and capacity 0 only that; a buffer that is too small is
        ! STICKSLIP_BUFFER_TOO_SMALL, and nothing is written to it. Each call takes about as long as a warm step.
        function stickslip_history_to_bytes(history, buffer, capacity, length) result(answer) bind(c)
            import
            type(stickslip_history), value :: history
            integer(c_int8_t), intent(inout), optional :: buffer(*)
            integer(c_size_t), value :: capacity
            integer(c_size_t), intent(out), optional :: length
            integer(c_int32_t) :: answer
        end function stickslip_history_to_bytes

        ! Makes a history from bytes of stickslip_history_to_bytes, on the bodies it had. Damaged bytes are STICKSLIP_FORMAT.
        function stickslip_history_from_bytes(half_space, bytes, length, history) result(answer) bind(c)
            import
            type(stickslip_half_space), value :: half_space
            integer(c_int8_t), intent(in), optional :: bytes(*)
            integer(c_size_t), value :: length
            type(stickslip_history), intent(out) :: history
            integer(c_int32_t) :: answer
        end function stickslip_history_from_bytes

        ! Displacement and stress of body STICKSLIP_BODY_1 or STICKSLIP_BODY_2 at count points, written to responses, by sums over
        ! all loaded cells: exact for a uniform traction on each. STICKSLIP_RIGID_BODY for a rigid body, STICKSLIP_DIVERGENT_PERIODIC_SUM on a grid
        ! that repeats along both axes. For whole planes stickslip_planes_solve is faster.
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

        ! The same with an observer (may be NULL), which is called before each portion of the points and may end it:
        ! STICKSLIP_NOT_CONVERGED, and responses is as it was.
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

        ! The gap between a sphere and a plane that touch at the origin (lengths), written to gap, which has count entries.
        function stickslip_surface_sphere(grid, radius, gap, count) result(answer) bind(c)
            import
            type(stickslip_grid), intent(in), optional :: grid
            real(c_double), value :: radius
            real(c_double), intent(inout) :: gap(*)
            integer(c_size_t), value :: count
            integer(c_int32_t) :: answer
        end function stickslip_surface_sphere

        ! The gap between an ellipsoid, of the radii of curvature radius_x and radius_y at the origin, and a plane.
        function stickslip_surface_ellipsoid(grid, radius_x, radius_y, gap, count) result(answer) bind(c)
            import
            type(stickslip_grid), intent(in), optional :: grid
            real(c_double), value :: radius_x
            real(c_double), value :: radius_y
            real(c_double), intent(inout) :: gap(*)
            integer(c_size_t), value :: count
            integer(c_int32_t) :: answer
        end function stickslip_surface_ellipsoid

        ! The gap between a cylinder along y and a plane.
        function stickslip_surface_cylinder(grid, radius, gap, count) result(answer) bind(c)
            import
            type(stickslip_grid), intent(in), optional :: grid
            real(c_double), value :: radius
            real(c_double), intent(inout) :: gap(*)
            integer(c_size_t), value :: count
            integer(c_int32_t) :: answer
        end function stickslip_surface_cylinder

        ! The options that tangential solvers have by default.
        function stickslip_tangential_options_default() result(answer) bind(c)
            import
            type(stickslip_tangential_options) :: answer
        end function stickslip_tangential_options_default

        ! Makes a solver under the pressure of a solved normal contact on the same bodies. options may be NULL (the defaults).
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

        ! Makes a solver under a pressure from elsewhere (count entries, zero or positive, copied). options may be NULL (the
        ! defaults).
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

        ! Frees a solver; nothing for NULL.
        function stickslip_tangential_solver_free(solver) result(answer) bind(c)
            import
            type(stickslip_tangential_solver), value :: solver
            integer(c_int32_t) :: answer
        end function stickslip_tangential_solver_free

        ! Changes the load of the next solve.
        function stickslip_tangential_solver_set_load(solver, load) result(answer) bind(c)
            import
            type(stickslip_tangential_solver), value :: solver
            type(stickslip_tangential_load), intent(in), optional :: load
            integer(c_int32_t) :: answer
        end function stickslip_tangential_solver_set_load

        ! Changes the friction of the next solve.
        function stickslip_tangential_solver_set_friction(solver, friction) result(answer) bind(c)
            import
            type(stickslip_tangential_solver), value :: solver
            type(stickslip_friction), intent(in), optional :: friction
            integer(c_int32_t) :: answer
        end function stickslip_tangential_solver_set_friction

        ! Changes the pressure of the next solve to that of a solved normal contact.
        function stickslip_tangential_solver_set_normal(solver, normal) result(answer) bind(c)
            import
            type(stickslip_tangential_solver), value :: solver
            type(stickslip_normal_solution), value :: normal
            integer(c_int32_t) :: answer
        end function stickslip_tangential_solver_set_normal

        ! Changes the pressure of the next solve to one from elsewhere (count entries, copied).
        function stickslip_tangential_solver_set_pressure(solver, pressure, count) result(answer) bind(c)
            import
            type(stickslip_tangential_solver), value :: solver
            real(c_double), intent(in) :: pressure(*)
            integer(c_size_t), value :: count
            integer(c_int32_t) :: answer
        end function stickslip_tangential_solver_set_pressure

        ! Changes the relative displacement of the next solve.
        function stickslip_tangential_solver_set_relative_displacement(solver, relative) result(answer) bind(c)
            import
            type(stickslip_tangential_solver), value :: solver
            type(stickslip_relative_displacement), intent(in), optional :: relative
            integer(c_int32_t) :: answer
        end function stickslip_tangential_solver_set_relative_displacement

        ! Changes method, tolerance and limits of the next solve.
        function stickslip_tangential_solver_set_settings(solver, settings) result(answer) bind(c)
            import
            type(stickslip_tangential_solver), value :: solver
            type(stickslip_settings), intent(in), optional :: settings
            integer(c_int32_t) :: answer
        end function stickslip_tangential_solver_set_settings

        ! Forgets the last answer: the next solve starts as the first did.
        function stickslip_tangential_solver_reset(solver) result(answer) bind(c)
            import
            type(stickslip_tangential_solver), value :: solver
            integer(c_int32_t) :: answer
        end function stickslip_tangential_solver_reset

        ! The largest tangential force that friction holds.
        function stickslip_tangential_solver_friction_capacity(solver, capacity) result(answer) bind(c)
            import
            type(stickslip_tangential_solver), value :: solver
            real(c_double), intent(out), optional :: capacity
            integer(c_int32_t) :: answer
        end function stickslip_tangential_solver_friction_capacity

        ! Solves into a solution of stickslip_tangential_solution_new for the same bodies. observer may be NULL.
        !
        ! With STICKSLIP_NOT_CONVERGED the solution holds the last feasible iterate and its report; after any other failure it is
        ! as it was.
        function stickslip_tangential_solver_solve(solver, solution, observer) result(answer) bind(c)
            import
            type(stickslip_tangential_solver), value :: solver
            type(stickslip_tangential_solution), value :: solution
            type(stickslip_observer), intent(in), optional :: observer
            integer(c_int32_t) :: answer
        end function stickslip_tangential_solver_solve

        ! Makes an empty solution of the right size for a solver.
        function stickslip_tangential_solution_new(solver, solution) result(answer) bind(c)
            import
            type(stickslip_tangential_solver), value :: solver
            type(stickslip_tangential_solution), intent(out) :: solution
            integer(c_int32_t) :: answer
        end function stickslip_tangential_solution_new

        ! Frees a solution; nothing for NULL.
        function stickslip_tangential_solution_free(solution) result(answer) bind(c)
            import
            type(stickslip_tangential_solution), value :: solution
            integer(c_int32_t) :: answer
        end function stickslip_tangential_solution_free

        ! STICKSLIP_TRACTION_X, STICKSLIP_SLIP_X or those along y, and how many cells it has (count may be NULL); NULL on failure.
        function stickslip_tangential_solution_field(solution, which, count) result(answer) bind(c)
            import
            type(stickslip_tangential_solution), value :: solution
            integer(c_int32_t), value :: which
            integer(c_size_t), intent(out), optional :: count
            type(c_ptr) :: answer
        end function stickslip_tangential_solution_field

        ! The zone of every cell, STICKSLIP_SEPARATED, STICKSLIP_STICK or STICKSLIP_SLIP; NULL on failure.
        function stickslip_tangential_solution_zones(solution, count) result(answer) bind(c)
            import
            type(stickslip_tangential_solution), value :: solution
            integer(c_size_t), intent(out), optional :: count
            type(c_ptr) :: answer
        end function stickslip_tangential_solution_zones

        ! The numbers of the contact.
        function stickslip_tangential_solution_result(solution, result) result(answer) bind(c)
            import
            type(stickslip_tangential_solution), value :: solution
            type(stickslip_tangential_result), intent(out), optional :: result
            integer(c_int32_t) :: answer
        end function stickslip_tangential_solution_result

        ! How it was solved.
        function stickslip_tangential_solution_report(solution, report) result(answer) bind(c)
            import
            type(stickslip_tangential_solution), value :: solution
            type(stickslip_report), intent(out), optional :: report
            integer(c_int32_t) :: answer
        end function stickslip_tangential_solution_report

        ! Diagnostics that may mislead: as stickslip_normal_solution_warnings.
        function stickslip_tangential_solution_warnings(solution, buffer, capacity, count) result(answer) bind(c)
            import
            type(stickslip_tangential_solution), value :: solution
            type(stickslip_warning), intent(inout), optional :: buffer(*)
            integer(c_size_t), value :: capacity
            integer(c_size_t), intent(out), optional :: count
            integer(c_int32_t) :: answer
        end function stickslip_tangential_solution_warnings

        ! The stiffness of a tangential contact on the bodies it was solved for.
        function stickslip_tangential_solution_stiffness(solution, half_space, stiffness) result(answer) bind(c)
            import
            type(stickslip_tangential_solution), value :: solution
            type(stickslip_half_space), value :: half_space
            type(stickslip_tangential_stiffness), intent(out), optional :: stiffness
            integer(c_int32_t) :: answer
        end function stickslip_tangential_solution_stiffness

        ! The same with an observer (may be NULL), which is called before every product with the operator and may end it:
        ! STICKSLIP_NOT_CONVERGED, and stiffness is as it was.
        function stickslip_tangential_solution_stiffness_observed(solution, half_space, observer, &
            stiffness) result(answer) bind(c)
            import
            type(stickslip_tangential_solution), value :: solution
            type(stickslip_half_space), value :: half_space
            type(stickslip_observer), intent(in), optional :: observer
            type(stickslip_tangential_stiffness), intent(out), optional :: stiffness
            integer(c_int32_t) :: answer
        end function stickslip_tangential_solution_stiffness_observed

        ! Sets how many threads solve contacts of more than 4096 cells and batches, from the next call on; 0 for the default, one
        ! for each processor (or RAYON_NUM_THREADS). With 1 all is done by the thread that calls, and no other is ever started.
        ! Calls under way keep the threads they have. Results have the same bits on any number of threads.
        !
        ! Threads do not survive a fork: a child process makes as many of its own at its first such call.
        function stickslip_set_num_threads(count) result(answer) bind(c)
            import
            integer(c_size_t), value :: count
            integer(c_int32_t) :: answer
        end function stickslip_set_num_threads

        ! The version of the library that is running, as "major.minor.patch"; it lives as long as the program.
        function stickslip_version() result(answer) bind(c)
            import
            type(c_ptr) :: answer
        end function stickslip_version

        ! STICKSLIP_ABI_VERSION of the library that is running.
        function stickslip_abi_version() result(answer) bind(c)
            import
            integer(c_int32_t) :: answer
        end function stickslip_abi_version

        ! Adds to depth (lengths, count entries) what Archard's law removes in the last step: coefficient (one over a pressure)
        ! times pressure times slip. After a failure depth is as it was.
        function stickslip_wear_archard(history, coefficient, depth, count) result(answer) bind(c)
            import
            type(stickslip_history), value :: history
            type(stickslip_per_cell), intent(in), optional :: coefficient
            real(c_double), intent(inout) :: depth(*)
            integer(c_size_t), value :: count
            integer(c_int32_t) :: answer
        end function stickslip_wear_archard

        ! Adds to depth what the energy law removes in the last step: coefficient (one over a pressure) times the energy dissipated
        ! per area.
        function stickslip_wear_energy(history, coefficient, depth, count) result(answer) bind(c)
            import
            type(stickslip_history), value :: history
            type(stickslip_per_cell), intent(in), optional :: coefficient
            real(c_double), intent(inout) :: depth(*)
            integer(c_size_t), value :: count
            integer(c_int32_t) :: answer
        end function stickslip_wear_energy

        ! The same beyond a threshold, an energy per area that wears nothing, of the energy dissipated since the start.
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
