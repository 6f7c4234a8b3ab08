! Steady rolling.
module stickslip_rolling
    use, intrinsic :: iso_c_binding
    use stickslip_bindings
    use stickslip_objects
    use stickslip_normal, only: normal_solution, normal_solver
    implicit none
    private

    public :: rolling_solver, rolling_solution, coupled_rolling_solver, coupled_rolling_solution

    ! Solver for steady rolling with a sequence of creepages, forces or spins.
    type, extends(stickslip_object) :: rolling_solver
        type(stickslip_rolling_solver) :: handle
        type(stickslip_grid) :: grid
    contains
        procedure :: new => rolling_solver_new
        procedure :: set_load => rolling_solver_set_load
        procedure :: set_friction => rolling_solver_set_friction
        procedure :: set_normal => rolling_solver_set_normal
        procedure :: set_pressure => rolling_solver_set_pressure
        procedure :: set_normal_solver => rolling_solver_set_normal_solver
        procedure :: set_normal_load => rolling_solver_set_normal_load
        procedure :: friction_capacity => rolling_solver_friction_capacity
        procedure :: set_settings => rolling_solver_set_settings
        procedure :: reset => rolling_solver_reset
        procedure :: solve => rolling_solver_solve
        procedure :: stiffness => rolling_solver_stiffness
        procedure :: creep_forces => rolling_solver_creep_forces
        procedure :: address => rolling_solver_address
        procedure :: free => rolling_solver_free
        final :: rolling_solver_final
    end type rolling_solver

    ! Solution of a rolling contact; the first solve into it creates it.
    type, extends(stickslip_object) :: rolling_solution
        type(stickslip_rolling_solution) :: handle
        type(stickslip_grid) :: grid
    contains
        procedure :: field => rolling_solution_field
        procedure :: zones => rolling_solution_zones
        procedure :: dissipation => rolling_solution_dissipation
        procedure :: result => rolling_solution_result
        procedure :: report => rolling_solution_report
        procedure :: warnings => rolling_solution_warnings
        procedure :: address => rolling_solution_address
        procedure :: free => rolling_solution_free
        final :: rolling_solution_final
    end type rolling_solution

    ! Solver for rolling of dissimilar bodies with full coupling of pressure and traction.
    type, extends(stickslip_object) :: coupled_rolling_solver
        type(stickslip_coupled_rolling_solver) :: handle
        type(stickslip_grid) :: grid
    contains
        procedure :: new => coupled_rolling_solver_new
        procedure :: set_normal_load => coupled_rolling_solver_set_normal_load
        procedure :: set_load => coupled_rolling_solver_set_load
        procedure :: set_gap => coupled_rolling_solver_set_gap
        procedure :: set_friction => coupled_rolling_solver_set_friction
        procedure :: set_settings => coupled_rolling_solver_set_settings
        procedure :: reset => coupled_rolling_solver_reset
        procedure :: solve => coupled_rolling_solver_solve
        procedure :: stiffness => coupled_rolling_solver_stiffness
        procedure :: address => coupled_rolling_solver_address
        procedure :: free => coupled_rolling_solver_free
        final :: coupled_rolling_solver_final
    end type coupled_rolling_solver

    ! Solution of a rolling contact of dissimilar bodies; the first solve into it creates it.
    type, extends(stickslip_object) :: coupled_rolling_solution
        type(stickslip_coupled_rolling_solution) :: handle
        type(stickslip_grid) :: grid
    contains
        procedure :: field => coupled_rolling_solution_field
        procedure :: zones => coupled_rolling_solution_zones
        procedure :: results => coupled_rolling_solution_results
        procedure :: report => coupled_rolling_solution_report
        procedure :: address => coupled_rolling_solution_address
        procedure :: free => coupled_rolling_solution_free
        final :: coupled_rolling_solution_final
    end type coupled_rolling_solution

contains

    ! Creates a solver under the pressure of a solved normal contact; without a load there is no creepage and no spin.
    subroutine rolling_solver_new(this, bodies, normal, friction, load, options, status)
        class(rolling_solver), intent(inout) :: this
        class(half_space), intent(in) :: bodies
        class(normal_solution), intent(in) :: normal
        type(stickslip_friction), intent(in) :: friction
        type(stickslip_rolling_load), intent(in), optional :: load
        type(stickslip_rolling_options), intent(in), optional :: options
        integer(c_int32_t), intent(out), optional :: status
        type(stickslip_rolling_solver) :: made
        integer(c_int32_t) :: code, given_up
        code = stickslip_rolling_solver_new(bodies%handle, normal%handle, friction, load, options, made)
        if (code == STICKSLIP_OK) code = stickslip_rolling_solver_free(this%handle)
        if (code == STICKSLIP_OK) then
            this%handle = made
            this%grid = bodies%grid
        else
            given_up = stickslip_rolling_solver_free(made)
        end if
        call report_status(code, status)
    end subroutine rolling_solver_new

    subroutine rolling_solver_set_load(this, load, status)
        class(rolling_solver), intent(in) :: this
        type(stickslip_rolling_load), intent(in) :: load
        integer(c_int32_t), intent(out), optional :: status
        call report_status(stickslip_rolling_solver_set_load(this%handle, load), status)
    end subroutine rolling_solver_set_load

    subroutine rolling_solver_set_friction(this, friction, status)
        class(rolling_solver), intent(in) :: this
        type(stickslip_friction), intent(in) :: friction
        integer(c_int32_t), intent(out), optional :: status
        call report_status(stickslip_rolling_solver_set_friction(this%handle, friction), status)
    end subroutine rolling_solver_set_friction

    subroutine rolling_solver_set_normal(this, normal, status)
        class(rolling_solver), intent(in) :: this
        class(normal_solution), intent(in) :: normal
        integer(c_int32_t), intent(out), optional :: status
        call report_status(stickslip_rolling_solver_set_normal(this%handle, normal%handle), status)
    end subroutine rolling_solver_set_normal

    ! Sets the pressure of the next solve; requires STICKSLIP_WHOLE_STEP.
    subroutine rolling_solver_set_pressure(this, pressure, status)
        class(rolling_solver), intent(in) :: this
        real(c_double), intent(in), contiguous :: pressure(:, :)
        integer(c_int32_t), intent(out), optional :: status
        if (.not. fits('pressure', shape(pressure), this%grid, status)) return
        call report_status(stickslip_rolling_solver_set_pressure(this%handle, pressure, size(pressure, kind=c_size_t)), status)
    end subroutine rolling_solver_set_pressure

    ! Copies the solver that computes the pressure of a new normal load.
    subroutine rolling_solver_set_normal_solver(this, normal, status)
        class(rolling_solver), intent(in) :: this
        class(normal_solver), intent(in) :: normal
        integer(c_int32_t), intent(out), optional :: status
        call report_status(stickslip_rolling_solver_set_normal_solver(this%handle, normal%handle), status)
    end subroutine rolling_solver_set_normal_solver

    ! Solves for the pressure of a normal load; requires a normal solver.
    subroutine rolling_solver_set_normal_load(this, load, status)
        class(rolling_solver), intent(in) :: this
        type(stickslip_normal_load), intent(in) :: load
        integer(c_int32_t), intent(out), optional :: status
        call report_status(stickslip_rolling_solver_set_normal_load(this%handle, load), status)
    end subroutine rolling_solver_set_normal_load

    function rolling_solver_friction_capacity(this, status) result(capacity)
        class(rolling_solver), intent(in) :: this
        integer(c_int32_t), intent(out), optional :: status
        real(c_double) :: capacity
        call report_status(stickslip_rolling_solver_friction_capacity(this%handle, capacity), status)
    end function rolling_solver_friction_capacity

    ! Discards the last solution: the next solve starts as the first solve did.
    subroutine rolling_solver_reset(this, status)
        class(rolling_solver), intent(in) :: this
        integer(c_int32_t), intent(out), optional :: status
        call report_status(stickslip_rolling_solver_reset(this%handle), status)
    end subroutine rolling_solver_reset

    subroutine rolling_solver_set_settings(this, settings, status)
        class(rolling_solver), intent(in) :: this
        type(stickslip_settings), intent(in) :: settings
        integer(c_int32_t), intent(out), optional :: status
        call report_status(stickslip_rolling_solver_set_settings(this%handle, settings), status)
    end subroutine rolling_solver_set_settings

    subroutine rolling_solver_solve(this, solution, observer, status)
        class(rolling_solver), intent(in) :: this
        class(rolling_solution), intent(inout) :: solution
        type(stickslip_observer), intent(in), optional :: observer
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        code = STICKSLIP_OK
        if (.not. c_associated(solution%address())) then
            code = stickslip_rolling_solution_new(this%handle, solution%handle)
            solution%grid = this%grid
        end if
        if (code == STICKSLIP_OK) code = stickslip_rolling_solver_solve(this%handle, solution%handle, observer)
        call report_status(code, status)
    end subroutine rolling_solver_solve

    ! Returns the derivatives of the forces and the moment with respect to creepages and spin at the last solution. The
    ! indices are slopes(column, row): rows are loads.
    function rolling_solver_stiffness(this, observer, status) result(stiffness)
        class(rolling_solver), intent(in) :: this
        type(stickslip_observer), intent(in), optional :: observer
        integer(c_int32_t), intent(out), optional :: status
        type(stickslip_rolling_stiffness) :: stiffness
        call report_status(stickslip_rolling_solver_stiffness_observed(this%handle, observer, stiffness), status)
    end function rolling_solver_stiffness

    ! Returns the loads at the points of a creep curve or a creep surface; afterwards the last point is the prescribed load.
    subroutine rolling_solver_creep_forces(this, points, forces, observer, status)
        class(rolling_solver), intent(in) :: this
        type(stickslip_creep_point), intent(in), contiguous :: points(:)
        type(stickslip_creep_force), allocatable, intent(out) :: forces(:)
        type(stickslip_observer), intent(in), optional :: observer
        integer(c_int32_t), intent(out), optional :: status
        allocate (forces(size(points)))
        call report_status(stickslip_rolling_solver_creep_forces_observed(this%handle, points, &
            size(points, kind=c_size_t), observer, forces), status)
    end subroutine rolling_solver_creep_forces

    ! Returns STICKSLIP_TRACTION_X, STICKSLIP_TRACTION_Y, STICKSLIP_SLIP_X or STICKSLIP_SLIP_Y.
    function rolling_solution_field(this, which, status) result(samples)
        class(rolling_solution), intent(in) :: this
        integer(c_int32_t), intent(in) :: which
        integer(c_int32_t), intent(out), optional :: status
        real(c_double), pointer :: samples(:, :)
        type(c_ptr) :: first
        integer(c_size_t) :: count
        first = stickslip_rolling_solution_field(this%handle, which, count)
        samples => plane(first, count, this%grid, status)
    end function rolling_solution_field

    ! Returns the zone of every cell: STICKSLIP_SEPARATED, STICKSLIP_STICK or STICKSLIP_SLIP.
    function rolling_solution_zones(this, status) result(zones)
        class(rolling_solution), intent(in) :: this
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int8_t), pointer :: zones(:, :)
        type(c_ptr) :: first
        integer(c_size_t) :: count
        first = stickslip_rolling_solution_zones(this%handle, count)
        zones => map_of_zones(first, count, this%grid, status)
    end function rolling_solution_zones

    ! Returns the energy that slip dissipates in each cell for each length rolled.
    subroutine rolling_solution_dissipation(this, values, status)
        class(rolling_solution), intent(in) :: this
        real(c_double), intent(inout), contiguous :: values(:, :)
        integer(c_int32_t), intent(out), optional :: status
        if (.not. fits('values', shape(values), this%grid, status)) return
        call report_status(stickslip_rolling_solution_dissipation(this%handle, values, size(values, kind=c_size_t)), status)
    end subroutine rolling_solution_dissipation

    function rolling_solution_result(this, status) result(found)
        class(rolling_solution), intent(in) :: this
        integer(c_int32_t), intent(out), optional :: status
        type(stickslip_rolling_result) :: found
        call report_status(stickslip_rolling_solution_result(this%handle, found), status)
    end function rolling_solution_result

    function rolling_solution_report(this, status) result(report)
        class(rolling_solution), intent(in) :: this
        integer(c_int32_t), intent(out), optional :: status
        type(stickslip_report) :: report
        call report_status(stickslip_rolling_solution_report(this%handle, report), status)
    end function rolling_solution_report

    ! Returns the warnings about the solution; warning_text returns the message of each.
    subroutine rolling_solution_warnings(this, warnings, status)
        class(rolling_solution), intent(in) :: this
        type(stickslip_warning), allocatable, intent(out) :: warnings(:)
        integer(c_int32_t), intent(out), optional :: status
        integer(c_size_t) :: count
        integer(c_int32_t) :: code
        code = stickslip_rolling_solution_warnings(this%handle, capacity=0_c_size_t, count=count)
        if (code == STICKSLIP_OK) then
            allocate (warnings(count))
            code = stickslip_rolling_solution_warnings(this%handle, warnings, size(warnings, kind=c_size_t), count)
        end if
        call report_status(code, status)
    end subroutine rolling_solution_warnings

    function rolling_solver_address(this) result(address)
        class(rolling_solver), intent(in) :: this
        type(c_ptr) :: address
        address = this%handle%address
    end function rolling_solver_address

    ! Frees the object unless another thread is using it.
    subroutine rolling_solver_free(this)
        class(rolling_solver), intent(inout) :: this
        if (stickslip_rolling_solver_free(this%handle) == STICKSLIP_OK) this%handle = stickslip_rolling_solver()
    end subroutine rolling_solver_free

    subroutine rolling_solver_final(this)
        type(rolling_solver), intent(inout) :: this
        call this%free()
    end subroutine rolling_solver_final

    function rolling_solution_address(this) result(address)
        class(rolling_solution), intent(in) :: this
        type(c_ptr) :: address
        address = this%handle%address
    end function rolling_solution_address

    ! Frees the object unless another thread is using it.
    subroutine rolling_solution_free(this)
        class(rolling_solution), intent(inout) :: this
        if (stickslip_rolling_solution_free(this%handle) == STICKSLIP_OK) this%handle = stickslip_rolling_solution()
    end subroutine rolling_solution_free

    subroutine rolling_solution_final(this)
        type(rolling_solution), intent(inout) :: this
        call this%free()
    end subroutine rolling_solution_final

    ! Creates a solver; without a load there is no creepage and no spin.
    subroutine coupled_rolling_solver_new(this, bodies, gap, friction, normal, load, options, status)
        class(coupled_rolling_solver), intent(inout) :: this
        class(half_space), intent(in) :: bodies
        real(c_double), intent(in), contiguous :: gap(:, :)
        type(stickslip_friction), intent(in) :: friction
        type(stickslip_normal_load), intent(in) :: normal
        type(stickslip_rolling_load), intent(in), optional :: load
        type(stickslip_rolling_options), intent(in), optional :: options
        integer(c_int32_t), intent(out), optional :: status
        type(stickslip_coupled_rolling_solver) :: made
        integer(c_int32_t) :: code, given_up
        if (.not. fits('gap', shape(gap), bodies%grid, status)) return
        code = stickslip_coupled_rolling_solver_new(bodies%handle, gap, size(gap, kind=c_size_t), friction, normal, load, &
            options, made)
        if (code == STICKSLIP_OK) code = stickslip_coupled_rolling_solver_free(this%handle)
        if (code == STICKSLIP_OK) then
            this%handle = made
            this%grid = bodies%grid
        else
            given_up = stickslip_coupled_rolling_solver_free(made)
        end if
        call report_status(code, status)
    end subroutine coupled_rolling_solver_new

    subroutine coupled_rolling_solver_set_normal_load(this, normal, status)
        class(coupled_rolling_solver), intent(in) :: this
        type(stickslip_normal_load), intent(in) :: normal
        integer(c_int32_t), intent(out), optional :: status
        call report_status(stickslip_coupled_rolling_solver_set_normal_load(this%handle, normal), status)
    end subroutine coupled_rolling_solver_set_normal_load

    subroutine coupled_rolling_solver_set_load(this, load, status)
        class(coupled_rolling_solver), intent(in) :: this
        type(stickslip_rolling_load), intent(in) :: load
        integer(c_int32_t), intent(out), optional :: status
        call report_status(stickslip_coupled_rolling_solver_set_load(this%handle, load), status)
    end subroutine coupled_rolling_solver_set_load

    subroutine coupled_rolling_solver_set_gap(this, gap, status)
        class(coupled_rolling_solver), intent(in) :: this
        real(c_double), intent(in), contiguous :: gap(:, :)
        integer(c_int32_t), intent(out), optional :: status
        if (.not. fits('gap', shape(gap), this%grid, status)) return
        call report_status(stickslip_coupled_rolling_solver_set_gap(this%handle, gap, size(gap, kind=c_size_t)), status)
    end subroutine coupled_rolling_solver_set_gap

    subroutine coupled_rolling_solver_set_friction(this, friction, status)
        class(coupled_rolling_solver), intent(in) :: this
        type(stickslip_friction), intent(in) :: friction
        integer(c_int32_t), intent(out), optional :: status
        call report_status(stickslip_coupled_rolling_solver_set_friction(this%handle, friction), status)
    end subroutine coupled_rolling_solver_set_friction

    subroutine coupled_rolling_solver_set_settings(this, settings, status)
        class(coupled_rolling_solver), intent(in) :: this
        type(stickslip_settings), intent(in) :: settings
        integer(c_int32_t), intent(out), optional :: status
        call report_status(stickslip_coupled_rolling_solver_set_settings(this%handle, settings), status)
    end subroutine coupled_rolling_solver_set_settings

    ! Discards the last solution: the next solve starts as the first solve did.
    subroutine coupled_rolling_solver_reset(this, status)
        class(coupled_rolling_solver), intent(in) :: this
        integer(c_int32_t), intent(out), optional :: status
        call report_status(stickslip_coupled_rolling_solver_reset(this%handle), status)
    end subroutine coupled_rolling_solver_reset

    subroutine coupled_rolling_solver_solve(this, solution, observer, status)
        class(coupled_rolling_solver), intent(in) :: this
        class(coupled_rolling_solution), intent(inout) :: solution
        type(stickslip_observer), intent(in), optional :: observer
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        code = STICKSLIP_OK
        if (.not. c_associated(solution%address())) then
            code = stickslip_coupled_rolling_solution_new(this%handle, solution%handle)
            solution%grid = this%grid
        end if
        if (code == STICKSLIP_OK) code = stickslip_coupled_rolling_solver_solve(this%handle, solution%handle, observer)
        call report_status(code, status)
    end subroutine coupled_rolling_solver_solve

    ! Returns the derivatives of the forces and the moment with respect to creepages and spin at the last solution,
    ! including the change of the pressure with the tractions. The indices are slopes(column, row): rows are loads.
    function coupled_rolling_solver_stiffness(this, observer, status) result(stiffness)
        class(coupled_rolling_solver), intent(in) :: this
        type(stickslip_observer), intent(in), optional :: observer
        integer(c_int32_t), intent(out), optional :: status
        type(stickslip_rolling_stiffness) :: stiffness
        call report_status(stickslip_coupled_rolling_solver_stiffness(this%handle, observer, stiffness), status)
    end function coupled_rolling_solver_stiffness

    ! Returns STICKSLIP_PRESSURE, STICKSLIP_GAP, STICKSLIP_TRACTION_X, STICKSLIP_TRACTION_Y, STICKSLIP_SLIP_X or
    ! STICKSLIP_SLIP_Y.
    function coupled_rolling_solution_field(this, which, status) result(samples)
        class(coupled_rolling_solution), intent(in) :: this
        integer(c_int32_t), intent(in) :: which
        integer(c_int32_t), intent(out), optional :: status
        real(c_double), pointer :: samples(:, :)
        type(c_ptr) :: first
        integer(c_size_t) :: count
        first = stickslip_coupled_rolling_solution_field(this%handle, which, count)
        samples => plane(first, count, this%grid, status)
    end function coupled_rolling_solution_field

    ! Returns the zone of every cell: STICKSLIP_SEPARATED, STICKSLIP_STICK or STICKSLIP_SLIP.
    function coupled_rolling_solution_zones(this, status) result(zones)
        class(coupled_rolling_solution), intent(in) :: this
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int8_t), pointer :: zones(:, :)
        type(c_ptr) :: first
        integer(c_size_t) :: count
        first = stickslip_coupled_rolling_solution_zones(this%handle, count)
        zones => map_of_zones(first, count, this%grid, status)
    end function coupled_rolling_solution_zones

    ! Returns the scalar results of the normal and the rolling part.
    subroutine coupled_rolling_solution_results(this, normal, rolling, status)
        class(coupled_rolling_solution), intent(in) :: this
        type(stickslip_normal_result), intent(out), optional :: normal
        type(stickslip_rolling_result), intent(out), optional :: rolling
        integer(c_int32_t), intent(out), optional :: status
        call report_status(stickslip_coupled_rolling_solution_results(this%handle, normal, rolling), status)
    end subroutine coupled_rolling_solution_results

    function coupled_rolling_solution_report(this, status) result(report)
        class(coupled_rolling_solution), intent(in) :: this
        integer(c_int32_t), intent(out), optional :: status
        type(stickslip_coupled_rolling_report) :: report
        call report_status(stickslip_coupled_rolling_solution_report(this%handle, report), status)
    end function coupled_rolling_solution_report

    function coupled_rolling_solver_address(this) result(address)
        class(coupled_rolling_solver), intent(in) :: this
        type(c_ptr) :: address
        address = this%handle%address
    end function coupled_rolling_solver_address

    ! Frees the object unless another thread is using it.
    subroutine coupled_rolling_solver_free(this)
        class(coupled_rolling_solver), intent(inout) :: this
        if (stickslip_coupled_rolling_solver_free(this%handle) == STICKSLIP_OK) then
            this%handle = stickslip_coupled_rolling_solver()
        end if
    end subroutine coupled_rolling_solver_free

    subroutine coupled_rolling_solver_final(this)
        type(coupled_rolling_solver), intent(inout) :: this
        call this%free()
    end subroutine coupled_rolling_solver_final

    function coupled_rolling_solution_address(this) result(address)
        class(coupled_rolling_solution), intent(in) :: this
        type(c_ptr) :: address
        address = this%handle%address
    end function coupled_rolling_solution_address

    ! Frees the object unless another thread is using it.
    subroutine coupled_rolling_solution_free(this)
        class(coupled_rolling_solution), intent(inout) :: this
        if (stickslip_coupled_rolling_solution_free(this%handle) == STICKSLIP_OK) then
            this%handle = stickslip_coupled_rolling_solution()
        end if
    end subroutine coupled_rolling_solution_free

    subroutine coupled_rolling_solution_final(this)
        type(coupled_rolling_solution), intent(inout) :: this
        call this%free()
    end subroutine coupled_rolling_solution_final
end module stickslip_rolling
