! Contacts of elastic half-spaces for Fortran 2008: types that free themselves, on the interface of stickslip_bindings, which
! this module passes on.
!
! An object is made by its procedure new, and freed when it leaves its scope, or by free. It cannot be assigned. Every
! procedure has an optional last argument status, STICKSLIP_OK or the kind of failure; without it a failure stops the program
! with its message. Fields are pointers to what the object holds: valid until the object is changed or freed. Fields
! have x first: field(ix, iy). Adaptive steps and coupled problems are called through stickslip_bindings.
module stickslip
    use, intrinsic :: iso_c_binding
    use stickslip_bindings
    implicit none
    public

    private :: report_status, text_of, plane, freed, refuse_copy

    ! What all objects have: a pointer of C.
    type, abstract :: stickslip_object
        type(c_ptr) :: handle = c_null_ptr
    contains
        procedure, private :: refuse_copy
        generic :: assignment(=) => refuse_copy
    end type stickslip_object

    ! Two bodies on a grid.
    type, extends(stickslip_object) :: half_space
    contains
        procedure :: new => half_space_new
        procedure :: pair => half_space_pair
        procedure :: free => half_space_free
        final :: half_space_final
    end type half_space

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

    ! A contact that is loaded step by step.
    type, extends(stickslip_object) :: contact_history
    contains
        procedure :: new => history_new
        procedure :: step => history_step
        procedure :: set_gap => history_set_gap
        procedure :: set_friction => history_set_friction
        procedure :: set_state => history_set_state
        procedure :: result => history_result
        procedure :: stiffness => history_stiffness
        procedure :: field => history_field
        procedure :: wear_energy => history_wear_energy
        procedure :: to_bytes => history_to_bytes
        procedure :: from_bytes => history_from_bytes
        procedure :: free => history_free
        final :: history_final
    end type contact_history

    ! A state that a history may return to.
    type, extends(stickslip_object) :: contact_state
    contains
        procedure :: keep => state_keep
        procedure :: free => state_free
        final :: state_final
    end type contact_state

    ! What the steps of a history add up to.
    type, extends(stickslip_object) :: contact_cycle
    contains
        procedure :: begin => cycle_begin
        procedure :: add => cycle_add
        procedure :: result => cycle_result
        procedure :: free => cycle_free
        final :: cycle_final
    end type contact_cycle

contains

    ! The message of the last failure on this thread.
    function stickslip_message() result(message)
        character(len=:), allocatable :: message
        message = text_of(stickslip_last_error_message())
    end function stickslip_message

    ! The version of the library.
    function stickslip_version_text() result(version)
        character(len=:), allocatable :: version
        version = text_of(stickslip_version())
    end function stickslip_version_text

    function text_of(bytes) result(text)
        type(c_ptr), intent(in) :: bytes
        character(len=:), allocatable :: text
        character(kind=c_char), pointer :: characters(:)
        integer :: length
        integer, parameter :: longest = 65536
        call c_f_pointer(bytes, characters, [longest])
        text = ''
        do length = 1, longest
            if (characters(length) == c_null_char) exit
            text = text // characters(length)
        end do
    end function text_of

    subroutine report_status(code, status)
        integer(c_int32_t), intent(in) :: code
        integer(c_int32_t), intent(out), optional :: status
        if (present(status)) then
            status = code
        else if (code /= STICKSLIP_OK) then
            error stop stickslip_message()
        end if
    end subroutine report_status

    subroutine refuse_copy(this, other)
        class(stickslip_object), intent(inout) :: this
        class(stickslip_object), intent(in) :: other
        if (c_associated(this%handle) .or. c_associated(other%handle)) error stop 'stickslip: an object cannot be assigned'
    end subroutine refuse_copy

    ! A field of nx by ny cells, not associated on failure.
    function plane(first, grid, code, status) result(samples)
        type(c_ptr), intent(in) :: first
        type(stickslip_grid), intent(in) :: grid
        integer(c_int32_t), intent(in) :: code
        integer(c_int32_t), intent(out), optional :: status
        real(c_double), pointer :: samples(:, :)
        type(stickslip_error) :: error
        integer(c_int32_t) :: told
        nullify (samples)
        if (code /= STICKSLIP_OK .or. .not. c_associated(first)) then
            told = stickslip_last_error(error)
            call report_status(error%code, status)
        else
            call c_f_pointer(first, samples, [grid%nx, grid%ny])
            call report_status(STICKSLIP_OK, status)
        end if
    end function plane

    ! Forgets an object that was freed; one in use stays.
    subroutine freed(this, code)
        class(stickslip_object), intent(inout) :: this
        integer(c_int32_t), intent(in) :: code
        if (code == STICKSLIP_OK) this%handle = c_null_ptr
    end subroutine freed

    ! Without a boundary the surroundings are unloaded half-space.
    subroutine half_space_new(this, grid, body_1, body_2, boundary, status)
        class(half_space), intent(inout) :: this
        type(stickslip_grid), intent(in) :: grid
        type(stickslip_material), intent(in) :: body_1, body_2
        type(stickslip_boundary), intent(in), optional :: boundary
        integer(c_int32_t), intent(out), optional :: status
        call this%free()
        call report_status(stickslip_half_space_new(grid, body_1, body_2, boundary, this%handle), status)
    end subroutine half_space_new

    function half_space_pair(this, status) result(pair)
        class(half_space), intent(in) :: this
        integer(c_int32_t), intent(out), optional :: status
        type(stickslip_pair) :: pair
        call report_status(stickslip_half_space_pair(this%handle, pair), status)
    end function half_space_pair

    subroutine normal_solver_new(this, bodies, gap, load, hardness, settings, status)
        class(normal_solver), intent(inout) :: this
        class(half_space), intent(in) :: bodies
        real(c_double), intent(in), contiguous :: gap(:, :)
        type(stickslip_normal_load), intent(in) :: load
        type(stickslip_per_cell), intent(in), optional :: hardness
        type(stickslip_settings), intent(in), optional :: settings
        integer(c_int32_t), intent(out), optional :: status
        call this%free()
        call report_status(stickslip_normal_solver_new(bodies%handle, gap, size(gap, kind=c_size_t), load, hardness, &
            settings, this%handle), status)
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

    ! STICKSLIP_PRESSURE or STICKSLIP_GAP, on the grid of the bodies.
    function normal_solution_field(this, which, bodies, status) result(samples)
        class(normal_solution), intent(in) :: this
        integer(c_int32_t), intent(in) :: which
        class(half_space), intent(in) :: bodies
        integer(c_int32_t), intent(out), optional :: status
        real(c_double), pointer :: samples(:, :)
        type(stickslip_grid) :: grid
        integer(c_int32_t) :: code
        code = stickslip_half_space_grid(bodies%handle, grid)
        samples => plane(stickslip_normal_solution_field(this%handle, which), grid, code, status)
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
        call this%free()
        call report_status(stickslip_tangential_solver_new(bodies%handle, normal%handle, friction, load, options, &
            this%handle), status)
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

    ! STICKSLIP_TRACTION_X, STICKSLIP_SLIP_X or those along y, on the grid of the bodies.
    function tangential_solution_field(this, which, bodies, status) result(samples)
        class(tangential_solution), intent(in) :: this
        integer(c_int32_t), intent(in) :: which
        class(half_space), intent(in) :: bodies
        integer(c_int32_t), intent(out), optional :: status
        real(c_double), pointer :: samples(:, :)
        type(stickslip_grid) :: grid
        integer(c_int32_t) :: code
        code = stickslip_half_space_grid(bodies%handle, grid)
        samples => plane(stickslip_tangential_solution_field(this%handle, which), grid, code, status)
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

    subroutine history_new(this, bodies, gap, friction, options, status)
        class(contact_history), intent(inout) :: this
        class(half_space), intent(in) :: bodies
        real(c_double), intent(in), contiguous :: gap(:, :)
        type(stickslip_friction), intent(in) :: friction
        type(stickslip_history_options), intent(in), optional :: options
        integer(c_int32_t), intent(out), optional :: status
        call this%free()
        call report_status(stickslip_history_new(bodies%handle, gap, size(gap, kind=c_size_t), friction, options, &
            this%handle), status)
    end subroutine history_new

    subroutine history_step(this, load, observer, status)
        class(contact_history), intent(in) :: this
        type(stickslip_load_step), intent(in) :: load
        type(stickslip_observer), intent(in), optional :: observer
        integer(c_int32_t), intent(out), optional :: status
        call report_status(stickslip_history_step(this%handle, load, observer), status)
    end subroutine history_step

    subroutine history_set_gap(this, gap, status)
        class(contact_history), intent(in) :: this
        real(c_double), intent(in), contiguous :: gap(:, :)
        integer(c_int32_t), intent(out), optional :: status
        call report_status(stickslip_history_set_gap(this%handle, gap, size(gap, kind=c_size_t)), status)
    end subroutine history_set_gap

    subroutine history_set_friction(this, friction, status)
        class(contact_history), intent(in) :: this
        type(stickslip_friction), intent(in) :: friction
        integer(c_int32_t), intent(out), optional :: status
        call report_status(stickslip_history_set_friction(this%handle, friction), status)
    end subroutine history_set_friction

    subroutine history_set_state(this, state, status)
        class(contact_history), intent(in) :: this
        class(contact_state), intent(in) :: state
        integer(c_int32_t), intent(out), optional :: status
        call report_status(stickslip_history_set_state(this%handle, state%handle), status)
    end subroutine history_set_state

    function history_result(this, status) result(found)
        class(contact_history), intent(in) :: this
        integer(c_int32_t), intent(out), optional :: status
        type(stickslip_step_result) :: found
        call report_status(stickslip_history_result(this%handle, found), status)
    end function history_result

    function history_stiffness(this, status) result(stiffness)
        class(contact_history), intent(in) :: this
        integer(c_int32_t), intent(out), optional :: status
        type(stickslip_stiffness) :: stiffness
        call report_status(stickslip_history_stiffness(this%handle, stiffness), status)
    end function history_stiffness

    ! A field by its number, STICKSLIP_PRESSURE to STICKSLIP_YIELDED_DEPTH but displacements.
    function history_field(this, which, status) result(samples)
        class(contact_history), intent(in) :: this
        integer(c_int32_t), intent(in) :: which
        integer(c_int32_t), intent(out), optional :: status
        real(c_double), pointer :: samples(:, :)
        type(stickslip_grid) :: grid
        integer(c_int32_t) :: code
        code = stickslip_history_grid(this%handle, grid)
        samples => plane(stickslip_history_field(this%handle, which), grid, code, status)
    end function history_field

    ! Adds to depth what the energy law removes in the last step.
    subroutine history_wear_energy(this, coefficient, depth, status)
        class(contact_history), intent(in) :: this
        real(c_double), intent(in) :: coefficient
        real(c_double), intent(inout), contiguous :: depth(:, :)
        integer(c_int32_t), intent(out), optional :: status
        type(stickslip_per_cell) :: uniform
        uniform = stickslip_per_cell(coefficient, c_null_ptr, 0)
        call report_status(stickslip_wear_energy(this%handle, uniform, depth, size(depth, kind=c_size_t)), status)
    end subroutine history_wear_energy

    subroutine history_to_bytes(this, bytes, status)
        class(contact_history), intent(in) :: this
        integer(c_int8_t), allocatable, intent(out) :: bytes(:)
        integer(c_int32_t), intent(out), optional :: status
        integer(c_size_t) :: length
        integer(c_int32_t) :: code
        code = stickslip_history_to_bytes(this%handle, capacity=0_c_size_t, length=length)
        if (code == STICKSLIP_OK) then
            allocate (bytes(length))
            code = stickslip_history_to_bytes(this%handle, bytes, size(bytes, kind=c_size_t), length)
        end if
        call report_status(code, status)
    end subroutine history_to_bytes

    subroutine history_from_bytes(this, bodies, bytes, status)
        class(contact_history), intent(inout) :: this
        class(half_space), intent(in) :: bodies
        integer(c_int8_t), intent(in), contiguous :: bytes(:)
        integer(c_int32_t), intent(out), optional :: status
        call this%free()
        call report_status(stickslip_history_from_bytes(bodies%handle, bytes, size(bytes, kind=c_size_t), &
            this%handle), status)
    end subroutine history_from_bytes

    ! Keeps the present state of a history.
    subroutine state_keep(this, history, status)
        class(contact_state), intent(inout) :: this
        class(contact_history), intent(in) :: history
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        if (c_associated(this%handle)) then
            code = stickslip_state_keep(this%handle, history%handle)
        else
            code = stickslip_state_new(history%handle, this%handle)
        end if
        call report_status(code, status)
    end subroutine state_keep

    ! Begins at the present state of a history.
    subroutine cycle_begin(this, history, status)
        class(contact_cycle), intent(inout) :: this
        class(contact_history), intent(in) :: history
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        if (c_associated(this%handle)) then
            code = stickslip_cycle_begin(this%handle, history%handle)
        else
            code = stickslip_cycle_new(history%handle, this%handle)
        end if
        call report_status(code, status)
    end subroutine cycle_begin

    ! Adds the last step of the history.
    subroutine cycle_add(this, history, status)
        class(contact_cycle), intent(in) :: this
        class(contact_history), intent(in) :: history
        integer(c_int32_t), intent(out), optional :: status
        call report_status(stickslip_cycle_add(this%handle, history%handle), status)
    end subroutine cycle_add

    function cycle_result(this, status) result(found)
        class(contact_cycle), intent(in) :: this
        integer(c_int32_t), intent(out), optional :: status
        type(stickslip_cycle_result) :: found
        call report_status(stickslip_cycle_result_of(this%handle, found), status)
    end function cycle_result

    subroutine half_space_free(this)
        class(half_space), intent(inout) :: this
        call freed(this, stickslip_half_space_free(this%handle))
    end subroutine half_space_free

    subroutine half_space_final(this)
        type(half_space), intent(inout) :: this
        call this%free()
    end subroutine half_space_final

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

    subroutine history_free(this)
        class(contact_history), intent(inout) :: this
        call freed(this, stickslip_history_free(this%handle))
    end subroutine history_free

    subroutine history_final(this)
        type(contact_history), intent(inout) :: this
        call this%free()
    end subroutine history_final

    subroutine state_free(this)
        class(contact_state), intent(inout) :: this
        call freed(this, stickslip_state_free(this%handle))
    end subroutine state_free

    subroutine state_final(this)
        type(contact_state), intent(inout) :: this
        call this%free()
    end subroutine state_final

    subroutine cycle_free(this)
        class(contact_cycle), intent(inout) :: this
        call freed(this, stickslip_cycle_free(this%handle))
    end subroutine cycle_free

    subroutine cycle_final(this)
        type(contact_cycle), intent(inout) :: this
        call this%free()
    end subroutine cycle_final
end module stickslip
