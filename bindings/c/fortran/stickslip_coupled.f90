! Contacts of dissimilar bodies with coupled pressure and traction.
module stickslip_coupled
    use, intrinsic :: iso_c_binding
    use stickslip_bindings
    use stickslip_objects
    implicit none
    private

    public :: coupled_solver, coupled_solution

    ! Solver for repeated coupled contacts, each loaded from rest in one step.
    type, extends(stickslip_object) :: coupled_solver
        type(stickslip_coupled_solver) :: handle
        type(stickslip_grid) :: grid
    contains
        procedure :: new => coupled_solver_new
        procedure :: set_load => coupled_solver_set_load
        procedure :: set_gap => coupled_solver_set_gap
        procedure :: set_friction => coupled_solver_set_friction
        procedure :: set_settings => coupled_solver_set_settings
        procedure :: reset => coupled_solver_reset
        procedure :: solve => coupled_solver_solve
        procedure :: address => coupled_solver_address
        procedure :: free => coupled_solver_free
        final :: coupled_solver_final
    end type coupled_solver

    ! Solution of a coupled contact; the first solve into it creates it.
    type, extends(stickslip_object) :: coupled_solution
        type(stickslip_coupled_solution) :: handle
        type(stickslip_grid) :: grid
    contains
        procedure :: field => coupled_solution_field
        procedure :: zones => coupled_solution_zones
        procedure :: results => coupled_solution_results
        procedure :: report => coupled_solution_report
        procedure :: warnings => coupled_solution_warnings
        procedure :: stiffness => coupled_solution_stiffness
        procedure :: edges => coupled_solution_edges
        procedure :: pressure_edges => coupled_solution_pressure_edges
        procedure :: discretisation_estimates => coupled_solution_discretisation_estimates
        procedure :: address => coupled_solution_address
        procedure :: free => coupled_solution_free
        final :: coupled_solution_final
    end type coupled_solution

contains

    ! Creates a solver. relative is a displacement of body 1 relative to body 2 that the contact does not cause, for example
    ! due to bulk strain.
    subroutine coupled_solver_new(this, bodies, gap, friction, normal, tangential, hardness, settings, relative, &
            status)
        class(coupled_solver), intent(inout) :: this
        class(half_space), intent(in) :: bodies
        real(c_double), intent(in), contiguous :: gap(:, :)
        type(stickslip_friction), intent(in) :: friction
        type(stickslip_normal_load), intent(in) :: normal
        type(stickslip_tangential_load), intent(in) :: tangential
        type(stickslip_per_cell), intent(in), optional :: hardness
        type(stickslip_settings), intent(in), optional :: settings
        type(stickslip_relative_displacement), intent(in), optional :: relative
        integer(c_int32_t), intent(out), optional :: status
        type(stickslip_coupled_solver) :: made
        integer(c_int32_t) :: code
        if (.not. fits('gap', shape(gap), bodies%grid, status)) return
        code = stickslip_coupled_solver_new(bodies%handle, gap, size(gap, kind=c_size_t), friction, normal, &
            tangential, hardness, relative, settings, made)
        call coupled_solver_take(this, made, bodies%grid, code, status)
    end subroutine coupled_solver_new

    subroutine coupled_solver_set_load(this, normal, tangential, status)
        class(coupled_solver), intent(in) :: this
        type(stickslip_normal_load), intent(in) :: normal
        type(stickslip_tangential_load), intent(in) :: tangential
        integer(c_int32_t), intent(out), optional :: status
        call report_status(stickslip_coupled_solver_set_load(this%handle, normal, tangential), status)
    end subroutine coupled_solver_set_load

    subroutine coupled_solver_set_gap(this, gap, status)
        class(coupled_solver), intent(in) :: this
        real(c_double), intent(in), contiguous :: gap(:, :)
        integer(c_int32_t), intent(out), optional :: status
        if (.not. fits('gap', shape(gap), this%grid, status)) return
        call report_status(stickslip_coupled_solver_set_gap(this%handle, gap, size(gap, kind=c_size_t)), status)
    end subroutine coupled_solver_set_gap

    subroutine coupled_solver_set_friction(this, friction, status)
        class(coupled_solver), intent(in) :: this
        type(stickslip_friction), intent(in) :: friction
        integer(c_int32_t), intent(out), optional :: status
        call report_status(stickslip_coupled_solver_set_friction(this%handle, friction), status)
    end subroutine coupled_solver_set_friction

    subroutine coupled_solver_set_settings(this, settings, status)
        class(coupled_solver), intent(in) :: this
        type(stickslip_settings), intent(in) :: settings
        integer(c_int32_t), intent(out), optional :: status
        call report_status(stickslip_coupled_solver_set_settings(this%handle, settings), status)
    end subroutine coupled_solver_set_settings

    ! Discards the last solution: the next solve starts as the first solve did.
    subroutine coupled_solver_reset(this, status)
        class(coupled_solver), intent(in) :: this
        integer(c_int32_t), intent(out), optional :: status
        call report_status(stickslip_coupled_solver_reset(this%handle), status)
    end subroutine coupled_solver_reset

    subroutine coupled_solver_solve(this, solution, observer, status)
        class(coupled_solver), intent(in) :: this
        class(coupled_solution), intent(inout) :: solution
        type(stickslip_observer), intent(in), optional :: observer
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        code = STICKSLIP_OK
        if (.not. c_associated(solution%address())) then
            code = stickslip_coupled_solution_new(this%handle, solution%handle)
            solution%grid = this%grid
        end if
        if (code == STICKSLIP_OK) code = stickslip_coupled_solver_solve(this%handle, solution%handle, observer)
        call report_status(code, status)
    end subroutine coupled_solver_solve

    ! Returns a field, STICKSLIP_PRESSURE to STICKSLIP_DISPLACEMENT_Z.
    function coupled_solution_field(this, which, status) result(samples)
        class(coupled_solution), intent(in) :: this
        integer(c_int32_t), intent(in) :: which
        integer(c_int32_t), intent(out), optional :: status
        real(c_double), pointer :: samples(:, :)
        type(c_ptr) :: first
        integer(c_size_t) :: count
        first = stickslip_coupled_solution_field(this%handle, which, count)
        samples => plane(first, count, this%grid, status)
    end function coupled_solution_field

    ! Returns the zone of every cell: STICKSLIP_SEPARATED, STICKSLIP_STICK or STICKSLIP_SLIP.
    function coupled_solution_zones(this, status) result(zones)
        class(coupled_solution), intent(in) :: this
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int8_t), pointer :: zones(:, :)
        type(c_ptr) :: first
        integer(c_size_t) :: count
        first = stickslip_coupled_solution_zones(this%handle, count)
        zones => map_of_zones(first, count, this%grid, status)
    end function coupled_solution_zones

    ! Returns the scalar results of the normal and the tangential part.
    subroutine coupled_solution_results(this, normal, tangential, status)
        class(coupled_solution), intent(in) :: this
        type(stickslip_normal_result), intent(out), optional :: normal
        type(stickslip_tangential_result), intent(out), optional :: tangential
        integer(c_int32_t), intent(out), optional :: status
        call report_status(stickslip_coupled_solution_results(this%handle, normal, tangential), status)
    end subroutine coupled_solution_results

    function coupled_solution_report(this, status) result(report)
        class(coupled_solution), intent(in) :: this
        integer(c_int32_t), intent(out), optional :: status
        type(stickslip_coupled_report) :: report
        call report_status(stickslip_coupled_solution_report(this%handle, report), status)
    end function coupled_solution_report

    ! Returns the warnings about the solution; warning_text returns the message of each.
    subroutine coupled_solution_warnings(this, warnings, status)
        class(coupled_solution), intent(in) :: this
        type(stickslip_warning), allocatable, intent(out) :: warnings(:)
        integer(c_int32_t), intent(out), optional :: status
        integer(c_size_t) :: count
        integer(c_int32_t) :: code
        code = stickslip_coupled_solution_warnings(this%handle, capacity=0_c_size_t, count=count)
        if (code == STICKSLIP_OK) then
            allocate (warnings(count))
            code = stickslip_coupled_solution_warnings(this%handle, warnings, size(warnings, kind=c_size_t), count)
        end if
        call report_status(code, status)
    end subroutine coupled_solution_warnings

    ! Returns the stiffness; bodies and friction must be those of the solve.
    function coupled_solution_stiffness(this, bodies, friction, observer, status) result(stiffness)
        class(coupled_solution), intent(in) :: this
        class(half_space), intent(in) :: bodies
        type(stickslip_friction), intent(in) :: friction
        type(stickslip_observer), intent(in), optional :: observer
        integer(c_int32_t), intent(out), optional :: status
        type(stickslip_stiffness) :: stiffness
        call report_status(stickslip_coupled_solution_stiffness_observed(this%handle, bodies%handle, friction, &
            observer, stiffness), status)
    end function coupled_solution_stiffness

    ! Returns the edges inside the cells, the magnitude of the traction at the centres of the cells, and its means over the
    ! cells.
    subroutine coupled_solution_edges(this, friction, edges, centres, means, status)
        class(coupled_solution), intent(in) :: this
        type(stickslip_friction), intent(in) :: friction
        type(stickslip_edges), intent(out) :: edges
        real(c_double), allocatable, intent(out), optional :: centres(:, :), means(:, :)
        integer(c_int32_t), intent(out), optional :: status
        ! Local arrays replace the arguments, because gfortran does not pass on an absent allocatable argument.
        real(c_double), allocatable :: at_centres(:, :), over_cells(:, :)
        integer(c_size_t) :: cells
        integer(c_int32_t) :: code
        cells = this%grid%nx * this%grid%ny
        if (present(centres)) allocate (at_centres(this%grid%nx, this%grid%ny))
        if (present(means)) allocate (over_cells(this%grid%nx, this%grid%ny))
        code = stickslip_coupled_solution_edges(this%handle, friction, edges, at_centres, over_cells, cells)
        if (present(centres)) call move_alloc(at_centres, centres)
        if (present(means)) call move_alloc(over_cells, means)
        call report_status(code, status)
    end subroutine coupled_solution_edges

    ! Returns the edge of the contact, the pressure at the centres of the cells, and its means over the cells.
    subroutine coupled_solution_pressure_edges(this, edges, centres, means, status)
        class(coupled_solution), intent(in) :: this
        type(stickslip_edges), intent(out) :: edges
        real(c_double), allocatable, intent(out), optional :: centres(:, :), means(:, :)
        integer(c_int32_t), intent(out), optional :: status
        ! Local arrays replace the arguments, because gfortran does not pass on an absent allocatable argument.
        real(c_double), allocatable :: at_centres(:, :), over_cells(:, :)
        integer(c_size_t) :: cells
        integer(c_int32_t) :: code
        cells = this%grid%nx * this%grid%ny
        if (present(centres)) allocate (at_centres(this%grid%nx, this%grid%ny))
        if (present(means)) allocate (over_cells(this%grid%nx, this%grid%ny))
        code = stickslip_coupled_solution_pressure_edges(this%handle, edges, at_centres, over_cells, cells)
        if (present(centres)) call move_alloc(at_centres, centres)
        if (present(means)) call move_alloc(over_cells, means)
        call report_status(code, status)
    end subroutine coupled_solution_pressure_edges

    ! Returns the estimates of the discretisation errors of pressure and traction, or NaN without contact or without
    ! traction.
    subroutine coupled_solution_discretisation_estimates(this, pressure, traction, status)
        class(coupled_solution), intent(in) :: this
        real(c_double), intent(out) :: pressure, traction
        integer(c_int32_t), intent(out), optional :: status
        call report_status(stickslip_coupled_solution_discretisation_estimates(this%handle, pressure, traction), status)
    end subroutine coupled_solution_discretisation_estimates

    ! Replaces the object by the new one. If made_with is a failure or the old object is in use, the old object remains.
    subroutine coupled_solver_take(this, made, grid, made_with, status)
        class(coupled_solver), intent(inout) :: this
        type(stickslip_coupled_solver), intent(in) :: made
        type(stickslip_grid), intent(in) :: grid
        integer(c_int32_t), intent(in) :: made_with
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code, given_up
        code = made_with
        if (code == STICKSLIP_OK) code = stickslip_coupled_solver_free(this%handle)
        if (code == STICKSLIP_OK) then
            this%handle = made
            this%grid = grid
        else
            given_up = stickslip_coupled_solver_free(made)
        end if
        call report_status(code, status)
    end subroutine coupled_solver_take

    function coupled_solver_address(this) result(address)
        class(coupled_solver), intent(in) :: this
        type(c_ptr) :: address
        address = this%handle%address
    end function coupled_solver_address

    ! Frees the object unless another thread is using it.
    subroutine coupled_solver_free(this)
        class(coupled_solver), intent(inout) :: this
        if (stickslip_coupled_solver_free(this%handle) == STICKSLIP_OK) this%handle = stickslip_coupled_solver()
    end subroutine coupled_solver_free

    subroutine coupled_solver_final(this)
        type(coupled_solver), intent(inout) :: this
        call this%free()
    end subroutine coupled_solver_final

    function coupled_solution_address(this) result(address)
        class(coupled_solution), intent(in) :: this
        type(c_ptr) :: address
        address = this%handle%address
    end function coupled_solution_address

    ! Frees the object unless another thread is using it.
    subroutine coupled_solution_free(this)
        class(coupled_solution), intent(inout) :: this
        if (stickslip_coupled_solution_free(this%handle) == STICKSLIP_OK) this%handle = stickslip_coupled_solution()
    end subroutine coupled_solution_free

    subroutine coupled_solution_final(this)
        type(coupled_solution), intent(inout) :: this
        call this%free()
    end subroutine coupled_solution_final
end module stickslip_coupled
