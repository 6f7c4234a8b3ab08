! Normal contacts.
module stickslip_normal
    use, intrinsic :: iso_c_binding
    use stickslip_bindings
    use stickslip_objects
    implicit none
    private

    public :: normal_solver, normal_solution

    ! Solver for repeated normal contacts.
    type, extends(stickslip_object) :: normal_solver
        type(stickslip_normal_solver) :: handle
        type(stickslip_grid) :: grid
    contains
        procedure :: new => normal_solver_new
        procedure :: set_load => normal_solver_set_load
        procedure :: set_gap => normal_solver_set_gap
        procedure :: set_settings => normal_solver_set_settings
        procedure :: reset => normal_solver_reset
        procedure :: solve => normal_solver_solve
        procedure :: address => normal_solver_address
        procedure :: free => normal_solver_free
        final :: normal_solver_final
    end type normal_solver

    ! Solution of a normal contact; the first solve into it creates it.
    type, extends(stickslip_object) :: normal_solution
        type(stickslip_normal_solution) :: handle
        type(stickslip_grid) :: grid
    contains
        procedure :: field => normal_solution_field
        procedure :: result => normal_solution_result
        procedure :: report => normal_solution_report
        procedure :: warnings => normal_solution_warnings
        procedure :: stiffness => normal_solution_stiffness
        procedure :: spots => normal_solution_spots
        procedure :: edges => normal_solution_edges
        procedure :: discretisation_estimate => normal_solution_discretisation_estimate
        procedure :: address => normal_solution_address
        procedure :: free => normal_solution_free
        final :: normal_solution_final
    end type normal_solution

contains

    subroutine normal_solver_new(this, bodies, gap, load, hardness, settings, status)
        class(normal_solver), intent(inout) :: this
        class(half_space), intent(in) :: bodies
        real(c_double), intent(in), contiguous :: gap(:, :)
        type(stickslip_normal_load), intent(in) :: load
        type(stickslip_per_cell), intent(in), optional :: hardness
        type(stickslip_settings), intent(in), optional :: settings
        integer(c_int32_t), intent(out), optional :: status
        type(stickslip_normal_solver) :: made
        integer(c_int32_t) :: code
        if (.not. fits('gap', shape(gap), bodies%grid, status)) return
        code = stickslip_normal_solver_new(bodies%handle, gap, size(gap, kind=c_size_t), load, hardness, settings, made)
        call normal_solver_take(this, made, bodies%grid, code, status)
    end subroutine normal_solver_new

    subroutine normal_solver_set_load(this, load, status)
        class(normal_solver), intent(in) :: this
        type(stickslip_normal_load), intent(in) :: load
        integer(c_int32_t), intent(out), optional :: status
        call report_status(stickslip_normal_solver_set_load(this%handle, load), status)
    end subroutine normal_solver_set_load

    subroutine normal_solver_set_gap(this, gap, status)
        class(normal_solver), intent(in) :: this
        real(c_double), intent(in), contiguous :: gap(:, :)
        integer(c_int32_t), intent(out), optional :: status
        if (.not. fits('gap', shape(gap), this%grid, status)) return
        call report_status(stickslip_normal_solver_set_gap(this%handle, gap, size(gap, kind=c_size_t)), status)
    end subroutine normal_solver_set_gap

    subroutine normal_solver_set_settings(this, settings, status)
        class(normal_solver), intent(in) :: this
        type(stickslip_settings), intent(in) :: settings
        integer(c_int32_t), intent(out), optional :: status
        call report_status(stickslip_normal_solver_set_settings(this%handle, settings), status)
    end subroutine normal_solver_set_settings

    ! Discards the last solution: the next solve starts as the first solve did.
    subroutine normal_solver_reset(this, status)
        class(normal_solver), intent(in) :: this
        integer(c_int32_t), intent(out), optional :: status
        call report_status(stickslip_normal_solver_reset(this%handle), status)
    end subroutine normal_solver_reset

    subroutine normal_solver_solve(this, solution, observer, status)
        class(normal_solver), intent(in) :: this
        class(normal_solution), intent(inout) :: solution
        type(stickslip_observer), intent(in), optional :: observer
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        code = STICKSLIP_OK
        if (.not. c_associated(solution%address())) then
            code = stickslip_normal_solution_new(this%handle, solution%handle)
            solution%grid = this%grid
        end if
        if (code == STICKSLIP_OK) code = stickslip_normal_solver_solve(this%handle, solution%handle, observer)
        call report_status(code, status)
    end subroutine normal_solver_solve

    ! Returns STICKSLIP_PRESSURE or STICKSLIP_GAP.
    function normal_solution_field(this, which, status) result(samples)
        class(normal_solution), intent(in) :: this
        integer(c_int32_t), intent(in) :: which
        integer(c_int32_t), intent(out), optional :: status
        real(c_double), pointer :: samples(:, :)
        type(c_ptr) :: first
        integer(c_size_t) :: count
        first = stickslip_normal_solution_field(this%handle, which, count)
        samples => plane(first, count, this%grid, status)
    end function normal_solution_field

    function normal_solution_result(this, status) result(found)
        class(normal_solution), intent(in) :: this
        integer(c_int32_t), intent(out), optional :: status
        type(stickslip_normal_result) :: found
        call report_status(stickslip_normal_solution_result(this%handle, found), status)
    end function normal_solution_result

    function normal_solution_report(this, status) result(report)
        class(normal_solution), intent(in) :: this
        integer(c_int32_t), intent(out), optional :: status
        type(stickslip_report) :: report
        call report_status(stickslip_normal_solution_report(this%handle, report), status)
    end function normal_solution_report

    ! Returns the warnings about the solution; warning_text returns the message of each.
    subroutine normal_solution_warnings(this, warnings, status)
        class(normal_solution), intent(in) :: this
        type(stickslip_warning), allocatable, intent(out) :: warnings(:)
        integer(c_int32_t), intent(out), optional :: status
        integer(c_size_t) :: count
        integer(c_int32_t) :: code
        code = stickslip_normal_solution_warnings(this%handle, capacity=0_c_size_t, count=count)
        if (code == STICKSLIP_OK) then
            allocate (warnings(count))
            code = stickslip_normal_solution_warnings(this%handle, warnings, size(warnings, kind=c_size_t), count)
        end if
        call report_status(code, status)
    end subroutine normal_solution_warnings

    function normal_solution_stiffness(this, bodies, observer, status) result(stiffness)
        class(normal_solution), intent(in) :: this
        class(half_space), intent(in) :: bodies
        type(stickslip_observer), intent(in), optional :: observer
        integer(c_int32_t), intent(out), optional :: status
        type(stickslip_normal_stiffness) :: stiffness
        call report_status(stickslip_normal_solution_stiffness_observed(this%handle, bodies%handle, observer, stiffness), status)
    end function normal_solution_stiffness

    ! Returns the contact spots and, for every cell, the number of its spot: counted from one, zero outside the contact.
    subroutine normal_solution_spots(this, spots, labels, status)
        class(normal_solution), intent(in) :: this
        type(stickslip_spot), allocatable, intent(out) :: spots(:)
        integer(c_int32_t), allocatable, intent(out), optional :: labels(:, :)
        integer(c_int32_t), intent(out), optional :: status
        integer(c_size_t) :: count
        integer(c_int32_t) :: code
        code = stickslip_normal_solution_spots(this%handle, capacity=0_c_size_t, count=count, cells=0_c_size_t)
        if (code == STICKSLIP_OK) then
            allocate (spots(count))
            if (present(labels)) then
                allocate (labels(this%grid%nx, this%grid%ny))
                code = stickslip_normal_solution_spots(this%handle, spots, &
                    size(spots, kind=c_size_t), count, labels, size(labels, kind=c_size_t))
            else
                code = stickslip_normal_solution_spots(this%handle, spots, &
                    size(spots, kind=c_size_t), count, cells=0_c_size_t)
            end if
        end if
        call report_status(code, status)
    end subroutine normal_solution_spots

    ! Returns the edge of the contact inside the cells, the pressure at the centres of the cells, and its means over the
    ! cells.
    subroutine normal_solution_edges(this, edges, centres, means, status)
        class(normal_solution), intent(in) :: this
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
        code = stickslip_normal_solution_edges(this%handle, edges, at_centres, over_cells, cells)
        if (present(centres)) call move_alloc(at_centres, centres)
        if (present(means)) call move_alloc(over_cells, means)
        call report_status(code, status)
    end subroutine normal_solution_edges

    ! Returns the estimate of the discretisation error, or NaN without contact.
    function normal_solution_discretisation_estimate(this, status) result(estimate)
        class(normal_solution), intent(in) :: this
        integer(c_int32_t), intent(out), optional :: status
        real(c_double) :: estimate
        call report_status(stickslip_normal_solution_discretisation_estimate(this%handle, estimate), status)
    end function normal_solution_discretisation_estimate

    ! Replaces the object by the new one. If made_with is a failure or the old object is in use, the old object remains.
    subroutine normal_solver_take(this, made, grid, made_with, status)
        class(normal_solver), intent(inout) :: this
        type(stickslip_normal_solver), intent(in) :: made
        type(stickslip_grid), intent(in) :: grid
        integer(c_int32_t), intent(in) :: made_with
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code, given_up
        code = made_with
        if (code == STICKSLIP_OK) code = stickslip_normal_solver_free(this%handle)
        if (code == STICKSLIP_OK) then
            this%handle = made
            this%grid = grid
        else
            given_up = stickslip_normal_solver_free(made)
        end if
        call report_status(code, status)
    end subroutine normal_solver_take

    function normal_solver_address(this) result(address)
        class(normal_solver), intent(in) :: this
        type(c_ptr) :: address
        address = this%handle%address
    end function normal_solver_address

    ! Frees the object unless another thread is using it.
    subroutine normal_solver_free(this)
        class(normal_solver), intent(inout) :: this
        if (stickslip_normal_solver_free(this%handle) == STICKSLIP_OK) this%handle = stickslip_normal_solver()
    end subroutine normal_solver_free

    subroutine normal_solver_final(this)
        type(normal_solver), intent(inout) :: this
        call this%free()
    end subroutine normal_solver_final

    function normal_solution_address(this) result(address)
        class(normal_solution), intent(in) :: this
        type(c_ptr) :: address
        address = this%handle%address
    end function normal_solution_address

    ! Frees the object unless another thread is using it.
    subroutine normal_solution_free(this)
        class(normal_solution), intent(inout) :: this
        if (stickslip_normal_solution_free(this%handle) == STICKSLIP_OK) this%handle = stickslip_normal_solution()
    end subroutine normal_solution_free

    subroutine normal_solution_final(this)
        type(normal_solution), intent(inout) :: this
        call this%free()
    end subroutine normal_solution_final
end module stickslip_normal
