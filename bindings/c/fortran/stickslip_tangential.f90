! Tangential contacts under a given pressure.
module stickslip_tangential
    use, intrinsic :: iso_c_binding
    use stickslip_bindings
    use stickslip_objects
    use stickslip_normal, only: normal_solution
    implicit none
    private

    public :: tangential_solver, tangential_solution

    ! Solver for repeated tangential contacts.
    type, extends(stickslip_object) :: tangential_solver
        type(stickslip_tangential_solver) :: handle
        type(stickslip_grid) :: grid
    contains
        procedure :: new => tangential_solver_new
        procedure :: new_under => tangential_solver_new_under
        procedure :: set_load => tangential_solver_set_load
        procedure :: set_friction => tangential_solver_set_friction
        procedure :: set_normal => tangential_solver_set_normal
        procedure :: set_pressure => tangential_solver_set_pressure
        procedure :: set_relative_displacement => tangential_solver_set_relative_displacement
        procedure :: set_settings => tangential_solver_set_settings
        procedure :: reset => tangential_solver_reset
        procedure :: friction_capacity => tangential_solver_friction_capacity
        procedure :: solve => tangential_solver_solve
        procedure :: address => tangential_solver_address
        procedure :: free => tangential_solver_free
        final :: tangential_solver_final
    end type tangential_solver

    ! Solution of a tangential contact; the first solve into it creates it.
    type, extends(stickslip_object) :: tangential_solution
        type(stickslip_tangential_solution) :: handle
        type(stickslip_grid) :: grid
    contains
        procedure :: field => tangential_solution_field
        procedure :: zones => tangential_solution_zones
        procedure :: result => tangential_solution_result
        procedure :: report => tangential_solution_report
        procedure :: warnings => tangential_solution_warnings
        procedure :: stiffness => tangential_solution_stiffness
        procedure :: spots => tangential_solution_spots
        procedure :: edges => tangential_solution_edges
        procedure :: discretisation_estimate => tangential_solution_discretisation_estimate
        procedure :: address => tangential_solution_address
        procedure :: free => tangential_solution_free
        final :: tangential_solution_final
    end type tangential_solution

contains

    ! Creates a solver under the pressure of a solved normal contact.
    subroutine tangential_solver_new(this, bodies, normal, friction, load, options, status)
        class(tangential_solver), intent(inout) :: this
        class(half_space), intent(in) :: bodies
        class(normal_solution), intent(in) :: normal
        type(stickslip_friction), intent(in) :: friction
        type(stickslip_tangential_load), intent(in) :: load
        type(stickslip_tangential_options), intent(in), optional :: options
        integer(c_int32_t), intent(out), optional :: status
        type(stickslip_tangential_solver) :: made
        integer(c_int32_t) :: code
        code = stickslip_tangential_solver_new(bodies%handle, normal%handle, friction, load, options, made)
        call tangential_solver_take(this, made, bodies%grid, code, status)
    end subroutine tangential_solver_new

    ! Creates a solver under a given pressure.
    subroutine tangential_solver_new_under(this, bodies, pressure, friction, load, options, status)
        class(tangential_solver), intent(inout) :: this
        class(half_space), intent(in) :: bodies
        real(c_double), intent(in), contiguous :: pressure(:, :)
        type(stickslip_friction), intent(in) :: friction
        type(stickslip_tangential_load), intent(in) :: load
        type(stickslip_tangential_options), intent(in), optional :: options
        integer(c_int32_t), intent(out), optional :: status
        type(stickslip_tangential_solver) :: made
        integer(c_int32_t) :: code
        if (.not. fits('pressure', shape(pressure), bodies%grid, status)) return
        code = stickslip_tangential_solver_new_under(bodies%handle, pressure, size(pressure, kind=c_size_t), friction, load, &
            options, made)
        call tangential_solver_take(this, made, bodies%grid, code, status)
    end subroutine tangential_solver_new_under

    subroutine tangential_solver_set_load(this, load, status)
        class(tangential_solver), intent(in) :: this
        type(stickslip_tangential_load), intent(in) :: load
        integer(c_int32_t), intent(out), optional :: status
        call report_status(stickslip_tangential_solver_set_load(this%handle, load), status)
    end subroutine tangential_solver_set_load

    subroutine tangential_solver_set_friction(this, friction, status)
        class(tangential_solver), intent(in) :: this
        type(stickslip_friction), intent(in) :: friction
        integer(c_int32_t), intent(out), optional :: status
        call report_status(stickslip_tangential_solver_set_friction(this%handle, friction), status)
    end subroutine tangential_solver_set_friction

    subroutine tangential_solver_set_normal(this, normal, status)
        class(tangential_solver), intent(in) :: this
        class(normal_solution), intent(in) :: normal
        integer(c_int32_t), intent(out), optional :: status
        call report_status(stickslip_tangential_solver_set_normal(this%handle, normal%handle), status)
    end subroutine tangential_solver_set_normal

    subroutine tangential_solver_set_pressure(this, pressure, status)
        class(tangential_solver), intent(in) :: this
        real(c_double), intent(in), contiguous :: pressure(:, :)
        integer(c_int32_t), intent(out), optional :: status
        if (.not. fits('pressure', shape(pressure), this%grid, status)) return
        call report_status(stickslip_tangential_solver_set_pressure(this%handle, pressure, size(pressure, kind=c_size_t)), status)
    end subroutine tangential_solver_set_pressure

    ! Sets a displacement of body 1 relative to body 2 that the contact does not cause, for example due to bulk strain.
    subroutine tangential_solver_set_relative_displacement(this, x, y, status)
        class(tangential_solver), intent(in) :: this
        real(c_double), intent(in), target, contiguous :: x(:, :), y(:, :)
        integer(c_int32_t), intent(out), optional :: status
        type(stickslip_relative_displacement) :: pattern
        if (.not. fits('x', shape(x), this%grid, status)) return
        if (.not. fits('y', shape(y), this%grid, status)) return
        pattern = stickslip_relative_displacement(c_loc(x), c_loc(y), size(x, kind=c_size_t))
        call report_status(stickslip_tangential_solver_set_relative_displacement(this%handle, pattern), status)
    end subroutine tangential_solver_set_relative_displacement

    subroutine tangential_solver_set_settings(this, settings, status)
        class(tangential_solver), intent(in) :: this
        type(stickslip_settings), intent(in) :: settings
        integer(c_int32_t), intent(out), optional :: status
        call report_status(stickslip_tangential_solver_set_settings(this%handle, settings), status)
    end subroutine tangential_solver_set_settings

    ! Discards the last solution: the next solve starts as the first solve did.
    subroutine tangential_solver_reset(this, status)
        class(tangential_solver), intent(in) :: this
        integer(c_int32_t), intent(out), optional :: status
        call report_status(stickslip_tangential_solver_reset(this%handle), status)
    end subroutine tangential_solver_reset

    function tangential_solver_friction_capacity(this, status) result(capacity)
        class(tangential_solver), intent(in) :: this
        integer(c_int32_t), intent(out), optional :: status
        real(c_double) :: capacity
        call report_status(stickslip_tangential_solver_friction_capacity(this%handle, capacity), status)
    end function tangential_solver_friction_capacity

    subroutine tangential_solver_solve(this, solution, observer, status)
        class(tangential_solver), intent(in) :: this
        class(tangential_solution), intent(inout) :: solution
        type(stickslip_observer), intent(in), optional :: observer
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        code = STICKSLIP_OK
        if (.not. c_associated(solution%address())) then
            code = stickslip_tangential_solution_new(this%handle, solution%handle)
            solution%grid = this%grid
        end if
        if (code == STICKSLIP_OK) code = stickslip_tangential_solver_solve(this%handle, solution%handle, observer)
        call report_status(code, status)
    end subroutine tangential_solver_solve

    ! Returns STICKSLIP_TRACTION_X, STICKSLIP_TRACTION_Y, STICKSLIP_SLIP_X or STICKSLIP_SLIP_Y.
    function tangential_solution_field(this, which, status) result(samples)
        class(tangential_solution), intent(in) :: this
        integer(c_int32_t), intent(in) :: which
        integer(c_int32_t), intent(out), optional :: status
        real(c_double), pointer :: samples(:, :)
        type(c_ptr) :: first
        integer(c_size_t) :: count
        first = stickslip_tangential_solution_field(this%handle, which, count)
        samples => plane(first, count, this%grid, status)
    end function tangential_solution_field

    ! Returns the zone of every cell: STICKSLIP_SEPARATED, STICKSLIP_STICK or STICKSLIP_SLIP.
    function tangential_solution_zones(this, status) result(zones)
        class(tangential_solution), intent(in) :: this
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int8_t), pointer :: zones(:, :)
        type(c_ptr) :: first
        integer(c_size_t) :: count
        first = stickslip_tangential_solution_zones(this%handle, count)
        zones => map_of_zones(first, count, this%grid, status)
    end function tangential_solution_zones

    function tangential_solution_result(this, status) result(found)
        class(tangential_solution), intent(in) :: this
        integer(c_int32_t), intent(out), optional :: status
        type(stickslip_tangential_result) :: found
        call report_status(stickslip_tangential_solution_result(this%handle, found), status)
    end function tangential_solution_result

    function tangential_solution_report(this, status) result(report)
        class(tangential_solution), intent(in) :: this
        integer(c_int32_t), intent(out), optional :: status
        type(stickslip_report) :: report
        call report_status(stickslip_tangential_solution_report(this%handle, report), status)
    end function tangential_solution_report

    ! Returns the warnings about the solution; warning_text returns the message of each.
    subroutine tangential_solution_warnings(this, warnings, status)
        class(tangential_solution), intent(in) :: this
        type(stickslip_warning), allocatable, intent(out) :: warnings(:)
        integer(c_int32_t), intent(out), optional :: status
        integer(c_size_t) :: count
        integer(c_int32_t) :: code
        code = stickslip_tangential_solution_warnings(this%handle, capacity=0_c_size_t, count=count)
        if (code == STICKSLIP_OK) then
            allocate (warnings(count))
            code = stickslip_tangential_solution_warnings(this%handle, warnings, size(warnings, kind=c_size_t), count)
        end if
        call report_status(code, status)
    end subroutine tangential_solution_warnings

    function tangential_solution_stiffness(this, bodies, observer, status) result(stiffness)
        class(tangential_solution), intent(in) :: this
        class(half_space), intent(in) :: bodies
        type(stickslip_observer), intent(in), optional :: observer
        integer(c_int32_t), intent(out), optional :: status
        type(stickslip_tangential_stiffness) :: stiffness
        call report_status(stickslip_tangential_solution_stiffness_observed(this%handle, bodies%handle, observer, &
            stiffness), status)
    end function tangential_solution_stiffness

    ! Returns the contact spots and, for every cell, the number of its spot: counted from one, zero outside the contact.
    subroutine tangential_solution_spots(this, normal, spots, labels, status)
        class(tangential_solution), intent(in) :: this
        class(normal_solution), intent(in) :: normal
        type(stickslip_spot), allocatable, intent(out) :: spots(:)
        integer(c_int32_t), allocatable, intent(out), optional :: labels(:, :)
        integer(c_int32_t), intent(out), optional :: status
        integer(c_size_t) :: count
        integer(c_int32_t) :: code
        code = stickslip_tangential_solution_spots(this%handle, normal%handle, capacity=0_c_size_t, count=count, cells=0_c_size_t)
        if (code == STICKSLIP_OK) then
            allocate (spots(count))
            if (present(labels)) then
                allocate (labels(this%grid%nx, this%grid%ny))
                code = stickslip_tangential_solution_spots(this%handle, normal%handle, spots, &
                    size(spots, kind=c_size_t), count, labels, size(labels, kind=c_size_t))
            else
                code = stickslip_tangential_solution_spots(this%handle, normal%handle, spots, &
                    size(spots, kind=c_size_t), count, cells=0_c_size_t)
            end if
        end if
        call report_status(code, status)
    end subroutine tangential_solution_spots

    ! Returns the edges inside the cells, the magnitude of the traction at the centres of the cells, and its means over the
    ! cells.
    subroutine tangential_solution_edges(this, normal, friction, edges, centres, means, status)
        class(tangential_solution), intent(in) :: this
        class(normal_solution), intent(in) :: normal
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
        code = stickslip_tangential_solution_edges(this%handle, normal%handle, friction, edges, at_centres, over_cells, cells)
        if (present(centres)) call move_alloc(at_centres, centres)
        if (present(means)) call move_alloc(over_cells, means)
        call report_status(code, status)
    end subroutine tangential_solution_edges

    ! Returns the estimate of the discretisation error, or NaN without contact.
    function tangential_solution_discretisation_estimate(this, status) result(estimate)
        class(tangential_solution), intent(in) :: this
        integer(c_int32_t), intent(out), optional :: status
        real(c_double) :: estimate
        call report_status(stickslip_tangential_solution_discretisation_estimate(this%handle, estimate), status)
    end function tangential_solution_discretisation_estimate

    ! Replaces the object by the new one. If made_with is a failure or the old object is in use, the old object remains.
    subroutine tangential_solver_take(this, made, grid, made_with, status)
        class(tangential_solver), intent(inout) :: this
        type(stickslip_tangential_solver), intent(in) :: made
        type(stickslip_grid), intent(in) :: grid
        integer(c_int32_t), intent(in) :: made_with
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code, given_up
        code = made_with
        if (code == STICKSLIP_OK) code = stickslip_tangential_solver_free(this%handle)
        if (code == STICKSLIP_OK) then
            this%handle = made
            this%grid = grid
        else
            given_up = stickslip_tangential_solver_free(made)
        end if
        call report_status(code, status)
    end subroutine tangential_solver_take

    function tangential_solver_address(this) result(address)
        class(tangential_solver), intent(in) :: this
        type(c_ptr) :: address
        address = this%handle%address
    end function tangential_solver_address

    ! Frees the object unless another thread is using it.
    subroutine tangential_solver_free(this)
        class(tangential_solver), intent(inout) :: this
        if (stickslip_tangential_solver_free(this%handle) == STICKSLIP_OK) this%handle = stickslip_tangential_solver()
    end subroutine tangential_solver_free

    subroutine tangential_solver_final(this)
        type(tangential_solver), intent(inout) :: this
        call this%free()
    end subroutine tangential_solver_final

    function tangential_solution_address(this) result(address)
        class(tangential_solution), intent(in) :: this
        type(c_ptr) :: address
        address = this%handle%address
    end function tangential_solution_address

    ! Frees the object unless another thread is using it.
    subroutine tangential_solution_free(this)
        class(tangential_solution), intent(inout) :: this
        if (stickslip_tangential_solution_free(this%handle) == STICKSLIP_OK) this%handle = stickslip_tangential_solution()
    end subroutine tangential_solution_free

    subroutine tangential_solution_final(this)
        type(tangential_solution), intent(inout) :: this
        call this%free()
    end subroutine tangential_solution_final
end module stickslip_tangential
