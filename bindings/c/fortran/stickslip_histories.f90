! Contacts that are loaded step by step, their states and their cycles.
module stickslip_histories
    use, intrinsic :: iso_c_binding
    use stickslip_bindings
    use stickslip_objects
    implicit none
    private

    public :: contact_history, contact_state, contact_cycle

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

    subroutine history_new(this, bodies, gap, friction, options, status)
        class(contact_history), intent(inout) :: this
        class(half_space), intent(in) :: bodies
        real(c_double), intent(in), contiguous :: gap(:, :)
        type(stickslip_friction), intent(in) :: friction
        type(stickslip_history_options), intent(in), optional :: options
        integer(c_int32_t), intent(out), optional :: status
        type(c_ptr) :: made
        integer(c_int32_t) :: code
        code = stickslip_history_new(bodies%handle, gap, size(gap, kind=c_size_t), friction, options, made)
        call take_over(this, code, made, stickslip_history_free, status)
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
        type(c_ptr) :: first
        integer(c_size_t) :: count
        integer(c_int32_t) :: code
        code = stickslip_history_grid(this%handle, grid)
        first = stickslip_history_field(this%handle, which, count)
        samples => plane(first, count, grid, code, status)
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
        type(c_ptr) :: made
        integer(c_int32_t) :: code
        code = stickslip_history_from_bytes(bodies%handle, bytes, size(bytes, kind=c_size_t), made)
        call take_over(this, code, made, stickslip_history_free, status)
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
end module stickslip_histories
