! Cycles of histories, and adaptive load steps.
module stickslip_cycles
    use, intrinsic :: iso_c_binding
    use stickslip_bindings
    use stickslip_objects
    use stickslip_histories, only: contact_history
    implicit none
    private

    public :: contact_cycle, adaptive_steps

    ! Sums over the steps of a history.
    type, extends(stickslip_object) :: contact_cycle
        type(stickslip_cycle) :: handle
        type(stickslip_grid) :: grid
    contains
        procedure :: begin => cycle_begin
        procedure :: add => cycle_add
        procedure :: result => cycle_result
        procedure :: field => cycle_field
        procedure :: jump => cycle_jump
        procedure :: address => cycle_address
        procedure :: free => cycle_free
        final :: cycle_final
    end type contact_cycle

    ! Adaptive load stepper, which applies loads in steps that are short enough for a tolerance on the tractions.
    type, extends(stickslip_object) :: adaptive_steps
        type(stickslip_adaptive_steps) :: handle
    contains
        procedure :: new => steps_new
        procedure :: step => steps_step
        procedure :: error => steps_error
        procedure :: address => steps_address
        procedure :: free => steps_free
        final :: steps_final
    end type adaptive_steps

contains

    ! Starts the cycle at the current state of a history.
    subroutine cycle_begin(this, history, status)
        class(contact_cycle), intent(inout) :: this
        class(contact_history), intent(in) :: history
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        if (c_associated(this%address())) then
            code = stickslip_cycle_begin(this%handle, history%handle)
        else
            code = stickslip_cycle_new(history%handle, this%handle)
            this%grid = history%grid
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

    ! Returns a field: STICKSLIP_SLIP_DISTANCE, STICKSLIP_DISSIPATED_ENERGY, STICKSLIP_SLIP_PRESSURE or a
    ! STICKSLIP_SLIP_AMPLITUDE.
    function cycle_field(this, which, status) result(samples)
        class(contact_cycle), intent(in) :: this
        integer(c_int32_t), intent(in) :: which
        integer(c_int32_t), intent(out), optional :: status
        real(c_double), pointer :: samples(:, :)
        type(c_ptr) :: first
        integer(c_size_t) :: count
        first = stickslip_cycle_field(this%handle, which, count)
        samples => plane(first, count, this%grid, status)
    end function cycle_field

    ! Returns the number of cycles like this one that a jump may skip, not rounded; depth is the depth that the cycle
    ! removed.
    function cycle_jump(this, bodies, depth, limits, status) result(cycles)
        class(contact_cycle), intent(in) :: this
        class(half_space), intent(in) :: bodies
        real(c_double), intent(in), contiguous :: depth(:, :)
        type(stickslip_jump_limits), intent(in), optional :: limits
        integer(c_int32_t), intent(out), optional :: status
        real(c_double) :: cycles
        cycles = 0
        if (.not. fits('depth', shape(depth), this%grid, status)) return
        call report_status(stickslip_cycle_jump(bodies%handle, this%handle, depth, size(depth, kind=c_size_t), limits, &
            cycles), status)
    end function cycle_jump

    ! Creates the buffers for histories on the grid of this history, with a tolerance in (0, 1) for a whole load.
    subroutine steps_new(this, history, tolerance, status)
        class(adaptive_steps), intent(inout) :: this
        class(contact_history), intent(in) :: history
        real(c_double), intent(in) :: tolerance
        integer(c_int32_t), intent(out), optional :: status
        type(stickslip_adaptive_steps) :: made
        integer(c_int32_t) :: code
        code = stickslip_adaptive_steps_new(history%handle, tolerance, made)
        call steps_take(this, made, code, status)
    end subroutine steps_new

    ! Applies a load; taken is the number of steps.
    subroutine steps_step(this, history, load, taken, status)
        class(adaptive_steps), intent(in) :: this
        class(contact_history), intent(in) :: history
        type(stickslip_load_step), intent(in) :: load
        integer(c_size_t), intent(out), optional :: taken
        integer(c_int32_t), intent(out), optional :: status
        call report_status(stickslip_adaptive_steps_step(this%handle, history%handle, load, taken), status)
    end subroutine steps_step

    ! Returns the error that one step would make with a load.
    function steps_error(this, history, load, status) result(error)
        class(adaptive_steps), intent(in) :: this
        class(contact_history), intent(in) :: history
        type(stickslip_load_step), intent(in) :: load
        integer(c_int32_t), intent(out), optional :: status
        type(stickslip_step_error) :: error
        call report_status(stickslip_adaptive_steps_error(this%handle, history%handle, load, error), status)
    end function steps_error

    function cycle_address(this) result(address)
        class(contact_cycle), intent(in) :: this
        type(c_ptr) :: address
        address = this%handle%address
    end function cycle_address

    ! Frees the object unless another thread is using it.
    subroutine cycle_free(this)
        class(contact_cycle), intent(inout) :: this
        if (stickslip_cycle_free(this%handle) == STICKSLIP_OK) this%handle = stickslip_cycle()
    end subroutine cycle_free

    subroutine cycle_final(this)
        type(contact_cycle), intent(inout) :: this
        call this%free()
    end subroutine cycle_final

    ! Replaces the object by the new one. If made_with is a failure or the old object is in use, the old object remains.
    subroutine steps_take(this, made, made_with, status)
        class(adaptive_steps), intent(inout) :: this
        type(stickslip_adaptive_steps), intent(in) :: made
        integer(c_int32_t), intent(in) :: made_with
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code, given_up
        code = made_with
        if (code == STICKSLIP_OK) code = stickslip_adaptive_steps_free(this%handle)
        if (code == STICKSLIP_OK) then
            this%handle = made
        else
            given_up = stickslip_adaptive_steps_free(made)
        end if
        call report_status(code, status)
    end subroutine steps_take

    function steps_address(this) result(address)
        class(adaptive_steps), intent(in) :: this
        type(c_ptr) :: address
        address = this%handle%address
    end function steps_address

    ! Frees the object unless another thread is using it.
    subroutine steps_free(this)
        class(adaptive_steps), intent(inout) :: this
        if (stickslip_adaptive_steps_free(this%handle) == STICKSLIP_OK) this%handle = stickslip_adaptive_steps()
    end subroutine steps_free

    subroutine steps_final(this)
        type(adaptive_steps), intent(inout) :: this
        call this%free()
    end subroutine steps_final
end module stickslip_cycles
