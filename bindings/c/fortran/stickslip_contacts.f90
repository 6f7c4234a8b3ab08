! Normal contacts, and tangential ones under their pressure.
module stickslip_contacts
    use, intrinsic :: iso_c_binding
    use stickslip_bindings
    use stickslip_objects
    implicit none
    private

    public :: normal_solver, normal_solution, tangential_solver, tangential_solution

    ! Solves normal contacts again and again.
    type, extends(stickslip_object) :: normal_solver
    contains
        procedure :: new => normal_solver_new
        procedure :: set_load => normal_solver_set_load
        procedure :: set_gap => normal_solver_set_gap
        procedure :: solve => normal_solver_solve
        procedure :: free => normal_solver_free
        final :: normal_solver_final
    end type normal_solver

    ! A solved normal contact; made by the first solve into it.
    type, extends(stickslip_object) :: normal_solution
    contains
        procedure :: field => normal_solution_field
        procedure :: result => normal_solution_result
        procedure :: report => normal_solution_report
        procedure :: free => normal_solution_free
        final :: normal_solution_final
    end type normal_solution

    ! Solves tangential contacts again and again.
    type, extends(stickslip_object) :: tangential_solver
    contains
        procedure :: new => tangential_solver_new
        procedure :: set_load => tangential_solver_set_load
        procedure :: set_friction => tangential_solver_set_friction
        procedure :: set_normal => tangential_solver_set_normal
        procedure :: solve => tangential_solver_solve
        procedure :: free => tangential_solver_free
        final :: tangential_solver_final
    end type tangential_solver

    ! A solved tangential contact; made by the first solve into it.
    type, extends(stickslip_object) :: tangential_solution
    contains
        procedure :: field => tangential_solution_field
        procedure :: result => tangential_solution_result
        procedure :: report => tangential_solution_report
        procedure :: free => tangential_solution_free
        final :: tangential_solution_final
    end type tangential_solution

contains

    subroutine normal_solver_new(this, bodies, gap, load, hardness, settings, status)
        class(normal_solver), intent(inout) :: this
        class(half_space), intent(in) :: bodies
        real(c_double), intent(in), contiguous :: gap(:, :)
        type(stickslip_normal_load), intent(in) :: load
        type(stickslip_per_cell), intent(in), optional :: hardness
        type(stickslip_settings), intent(in), optional :: settings
        integer(c_int32_t), intent(out), optional :: status
        type(c_ptr) :: made
        integer(c_int32_t) :: code
        code = stickslip_normal_solver_new(bodies%handle, gap, size(gap, kind=c_size_t), load, hardness, &
            settings, made)
        call take_over(this, code, made, stickslip_normal_solver_free, status)
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
        call report_status(stickslip_normal_solver_set_gap(this%handle, gap, size(gap, kind=c_size_t)), status)
    end subroutine normal_solver_set_gap

    subroutine normal_solver_solve(this, solution, observer, status)
        class(normal_solver), intent(in) :: this
        class(normal_solution), intent(inout) :: solution
        type(stickslip_observer), intent(in), optional :: observer
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        code = STICKSLIP_OK
        if (.not. c_associated(solution%handle)) code = stickslip_normal_solution_new(this%handle, solution%handle)
        if (code == STICKSLIP_OK) code = stickslip_normal_solver_solve(this%handle, solution%handle, observer)
        call report_status(code, status)
    end subroutine normal_solver_solve

    ! STICKSLIP_PRESSURE or STICKSLIP_GAP, on the grid of the bodies; STICKSLIP_LENGTH for bodies with another number of cells.
    function normal_solution_field(this, which, bodies, status) result(samples)
        class(normal_solution), intent(in) :: this
        integer(c_int32_t), intent(in) :: which
        class(half_space), intent(in) :: bodies
        integer(c_int32_t), intent(out), optional :: status
        real(c_double), pointer :: samples(:, :)
        type(stickslip_grid) :: grid
        type(c_ptr) :: first
        integer(c_size_t) :: count
        integer(c_int32_t) :: code
        code = stickslip_half_space_grid(bodies%handle, grid)
        first = stickslip_normal_solution_field(this%handle, which, count)
        samples => plane(first, count, grid, code, status)
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

    subroutine tangential_solver_new(this, bodies, normal, friction, load, options, status)
        class(tangential_solver), intent(inout) :: this
        class(half_space), intent(in) :: bodies
        class(normal_solution), intent(in) :: normal
        type(stickslip_friction), intent(in) :: friction
        type(stickslip_tangential_load), intent(in) :: load
        type(stickslip_tangential_options), intent(in), optional :: options
        integer(c_int32_t), intent(out), optional :: status
        type(c_ptr) :: made
        integer(c_int32_t) :: code
        code = stickslip_tangential_solver_new(bodies%handle, normal%handle, friction, load, options, made)
        call take_over(this, code, made, stickslip_tangential_solver_free, status)
    end subroutine tangential_solver_new

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

    subroutine tangential_solver_solve(this, solution, observer, status)
        class(tangential_solver), intent(in) :: this
        class(tangential_solution), intent(inout) :: solution
        type(stickslip_observer), intent(in), optional :: observer
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        code = STICKSLIP_OK
        if (.not. c_associated(solution%handle)) code = stickslip_tangential_solution_new(this%handle, solution%handle)
        if (code == STICKSLIP_OK) code = stickslip_tangential_solver_solve(this%handle, solution%handle, observer)
        call report_status(code, status)
    end subroutine tangential_solver_solve

    ! STICKSLIP_TRACTION_X, STICKSLIP_SLIP_X or those along y, on the grid of the bodies; STICKSLIP_LENGTH for bodies with
    ! another number of cells.
    function tangential_solution_field(this, which, bodies, status) result(samples)
        class(tangential_solution), intent(in) :: this
        integer(c_int32_t), intent(in) :: which
        class(half_space), intent(in) :: bodies
        integer(c_int32_t), intent(out), optional :: status
        real(c_double), pointer :: samples(:, :)
        type(stickslip_grid) :: grid
        type(c_ptr) :: first
        integer(c_size_t) :: count
        integer(c_int32_t) :: code
        code = stickslip_half_space_grid(bodies%handle, grid)
        first = stickslip_tangential_solution_field(this%handle, which, count)
        samples => plane(first, count, grid, code, status)
    end function tangential_solution_field

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

    subroutine normal_solver_free(this)
        class(normal_solver), intent(inout) :: this
        call freed(this, stickslip_normal_solver_free(this%handle))
    end subroutine normal_solver_free

    subroutine normal_solver_final(this)
        type(normal_solver), intent(inout) :: this
        call this%free()
    end subroutine normal_solver_final

    subroutine normal_solution_free(this)
        class(normal_solution), intent(inout) :: this
        call freed(this, stickslip_normal_solution_free(this%handle))
    end subroutine normal_solution_free

    subroutine normal_solution_final(this)
        type(normal_solution), intent(inout) :: this
        call this%free()
    end subroutine normal_solution_final

    subroutine tangential_solver_free(this)
        class(tangential_solver), intent(inout) :: this
        call freed(this, stickslip_tangential_solver_free(this%handle))
    end subroutine tangential_solver_free

    subroutine tangential_solver_final(this)
        type(tangential_solver), intent(inout) :: this
        call this%free()
    end subroutine tangential_solver_final

    subroutine tangential_solution_free(this)
        class(tangential_solution), intent(inout) :: this
        call freed(this, stickslip_tangential_solution_free(this%handle))
    end subroutine tangential_solution_free

    subroutine tangential_solution_final(this)
        type(tangential_solution), intent(inout) :: this
        call this%free()
    end subroutine tangential_solution_final
end module stickslip_contacts
