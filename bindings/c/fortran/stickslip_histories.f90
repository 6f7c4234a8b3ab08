! Contacts that are loaded step by step, and their saved states.
module stickslip_histories
    use, intrinsic :: iso_c_binding
    use stickslip_bindings
    use stickslip_objects
    implicit none
    private

    public :: contact_history, contact_state, stiffness_workspace

    ! Contact that is loaded step by step, with memory of slip.
    type, extends(stickslip_object) :: contact_history
        type(stickslip_history) :: handle
        type(stickslip_grid) :: grid
    contains
        procedure :: new => history_new
        procedure :: clone => history_clone
        procedure :: step => history_step
        procedure :: press => history_press
        procedure :: set_gap => history_set_gap
        procedure :: set_friction => history_set_friction
        procedure :: set_settings => history_set_settings
        procedure :: set_relative_displacement => history_set_relative_displacement
        procedure :: set_state => history_set_state
        procedure :: result => history_result
        procedure :: normal_result => history_normal_result
        procedure :: friction_capacity => history_friction_capacity
        procedure :: reports => history_reports
        procedure :: warnings => history_warnings
        procedure :: stiffness => history_stiffness
        procedure :: next_stiffness => history_next_stiffness
        procedure :: stiffness_with => history_stiffness_with
        procedure :: field => history_field
        procedure :: zones => history_zones
        procedure :: spots => history_spots
        procedure :: to_bytes => history_to_bytes
        procedure :: from_bytes => history_from_bytes
        procedure, private :: wear_archard_uniform, wear_archard_of_cells, wear_energy_uniform, wear_energy_of_cells
        generic :: wear_archard => wear_archard_uniform, wear_archard_of_cells
        generic :: wear_energy => wear_energy_uniform, wear_energy_of_cells
        procedure :: address => history_address
        procedure :: free => history_free
        final :: history_final
    end type contact_history

    ! Saved state of a history; a history can return to it.
    type, extends(stickslip_object) :: contact_state
        type(stickslip_state) :: handle
    contains
        procedure :: keep => state_keep
        procedure :: address => state_address
        procedure :: free => state_free
        final :: state_final
    end type contact_state

    ! Buffers, options and report of stiffnesses that are computed repeatedly. Later stiffnesses allocate only for larger
    ! contacts.
    type, extends(stickslip_object) :: stiffness_workspace
        type(stickslip_stiffness_workspace) :: handle
    contains
        procedure :: new => workspace_new
        procedure :: set_options => workspace_set_options
        procedure :: report => workspace_report
        procedure :: address => workspace_address
        procedure :: free => workspace_free
        final :: workspace_final
    end type stiffness_workspace

contains

    subroutine history_new(this, bodies, gap, friction, options, status)
        class(contact_history), intent(inout) :: this
        class(half_space), intent(in) :: bodies
        real(c_double), intent(in), contiguous :: gap(:, :)
        type(stickslip_friction), intent(in) :: friction
        type(stickslip_history_options), intent(in), optional :: options
        integer(c_int32_t), intent(out), optional :: status
        type(stickslip_history) :: made
        integer(c_int32_t) :: code
        if (.not. fits('gap', shape(gap), bodies%grid, status)) return
        code = stickslip_history_new(bodies%handle, gap, size(gap, kind=c_size_t), friction, options, made)
        call history_take(this, made, bodies%grid, code, status)
    end subroutine history_new

    ! Makes copy an independent copy of this history.
    subroutine history_clone(this, copy, status)
        class(contact_history), intent(in) :: this
        class(contact_history), intent(inout) :: copy
        integer(c_int32_t), intent(out), optional :: status
        type(stickslip_history) :: made
        integer(c_int32_t) :: code
        code = stickslip_history_clone(this%handle, made)
        call history_take(copy, made, this%grid, code, status)
    end subroutine history_clone

    subroutine history_step(this, load, observer, status)
        class(contact_history), intent(in) :: this
        type(stickslip_load_step), intent(in) :: load
        type(stickslip_observer), intent(in), optional :: observer
        integer(c_int32_t), intent(out), optional :: status
        call report_status(stickslip_history_step(this%handle, load, observer), status)
    end subroutine history_step

    ! Applies a load in as many steps as a tolerance requires, and writes their number to taken. Contacts of dissimilar
    ! bodies must be pressed with this procedure.
    subroutine history_press(this, load, tolerance, taken, observer, status)
        class(contact_history), intent(in) :: this
        type(stickslip_load_step), intent(in) :: load
        real(c_double), intent(in) :: tolerance
        integer(c_size_t), intent(out), optional :: taken
        type(stickslip_observer), intent(in), optional :: observer
        integer(c_int32_t), intent(out), optional :: status
        call report_status(stickslip_history_press(this%handle, load, tolerance, observer, taken), status)
    end subroutine history_press

    subroutine history_set_gap(this, gap, status)
        class(contact_history), intent(in) :: this
        real(c_double), intent(in), contiguous :: gap(:, :)
        integer(c_int32_t), intent(out), optional :: status
        if (.not. fits('gap', shape(gap), this%grid, status)) return
        call report_status(stickslip_history_set_gap(this%handle, gap, size(gap, kind=c_size_t)), status)
    end subroutine history_set_gap

    subroutine history_set_friction(this, friction, status)
        class(contact_history), intent(in) :: this
        type(stickslip_friction), intent(in) :: friction
        integer(c_int32_t), intent(out), optional :: status
        call report_status(stickslip_history_set_friction(this%handle, friction), status)
    end subroutine history_set_friction

    subroutine history_set_settings(this, settings, status)
        class(contact_history), intent(in) :: this
        type(stickslip_settings), intent(in) :: settings
        integer(c_int32_t), intent(out), optional :: status
        call report_status(stickslip_history_set_settings(this%handle, settings), status)
    end subroutine history_set_settings

    ! Sets the pattern of a displacement of body 1 relative to body 2 that the contact does not cause, for example due to
    ! bulk strain.
    subroutine history_set_relative_displacement(this, x, y, status)
        class(contact_history), intent(in) :: this
        real(c_double), intent(in), target, contiguous :: x(:, :), y(:, :)
        integer(c_int32_t), intent(out), optional :: status
        type(stickslip_relative_displacement) :: pattern
        if (.not. fits('x', shape(x), this%grid, status)) return
        if (.not. fits('y', shape(y), this%grid, status)) return
        pattern = stickslip_relative_displacement(c_loc(x), c_loc(y), size(x, kind=c_size_t))
        call report_status(stickslip_history_set_relative_displacement(this%handle, pattern), status)
    end subroutine history_set_relative_displacement

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

    function history_normal_result(this, status) result(found)
        class(contact_history), intent(in) :: this
        integer(c_int32_t), intent(out), optional :: status
        type(stickslip_normal_result) :: found
        call report_status(stickslip_history_normal_result(this%handle, found), status)
    end function history_normal_result

    function history_friction_capacity(this, status) result(capacity)
        class(contact_history), intent(in) :: this
        integer(c_int32_t), intent(out), optional :: status
        real(c_double) :: capacity
        call report_status(stickslip_history_friction_capacity(this%handle, capacity), status)
    end function history_friction_capacity

    ! Returns the reports of the pressure and the traction of the last step; their status is STICKSLIP_UNSOLVED if the
    ! pressure was held.
    subroutine history_reports(this, normal, tangential, status)
        class(contact_history), intent(in) :: this
        type(stickslip_report), intent(out) :: normal, tangential
        integer(c_int32_t), intent(out), optional :: status
        call report_status(stickslip_history_reports(this%handle, normal, tangential), status)
    end subroutine history_reports

    ! Returns the warnings about the last step; warning_text returns the message of each.
    subroutine history_warnings(this, warnings, status)
        class(contact_history), intent(in) :: this
        type(stickslip_warning), allocatable, intent(out) :: warnings(:)
        integer(c_int32_t), intent(out), optional :: status
        integer(c_size_t) :: count
        integer(c_int32_t) :: code
        code = stickslip_history_warnings(this%handle, capacity=0_c_size_t, count=count)
        if (code == STICKSLIP_OK) then
            allocate (warnings(count))
            code = stickslip_history_warnings(this%handle, warnings, size(warnings, kind=c_size_t), count)
        end if
        call report_status(code, status)
    end subroutine history_warnings

    function history_stiffness(this, observer, status) result(stiffness)
        class(contact_history), intent(in) :: this
        type(stickslip_observer), intent(in), optional :: observer
        integer(c_int32_t), intent(out), optional :: status
        type(stickslip_stiffness) :: stiffness
        call report_status(stickslip_history_stiffness_observed(this%handle, observer, stiffness), status)
    end function history_stiffness

    ! Returns the stiffness of a next step from the current state: stick cells resist fully, including those that came into
    ! contact in the last step, and cells at their friction limit continue to slip.
    function history_next_stiffness(this, observer, status) result(stiffness)
        class(contact_history), intent(in) :: this
        type(stickslip_observer), intent(in), optional :: observer
        integer(c_int32_t), intent(out), optional :: status
        type(stickslip_stiffness) :: stiffness
        call report_status(stickslip_history_next_stiffness(this%handle, observer, stiffness), status)
    end function history_next_stiffness

    ! Returns the stiffness with the options and the buffers of a workspace.
    function history_stiffness_with(this, workspace, observer, status) result(stiffness)
        class(contact_history), intent(in) :: this
        class(stiffness_workspace), intent(in) :: workspace
        type(stickslip_observer), intent(in), optional :: observer
        integer(c_int32_t), intent(out), optional :: status
        type(stickslip_stiffness) :: stiffness
        call report_status(stickslip_history_stiffness_with(this%handle, workspace%handle, observer, stiffness), status)
    end function history_stiffness_with

    ! Returns a field, STICKSLIP_PRESSURE to STICKSLIP_YIELDED_DEPTH except displacements.
    function history_field(this, which, status) result(samples)
        class(contact_history), intent(in) :: this
        integer(c_int32_t), intent(in) :: which
        integer(c_int32_t), intent(out), optional :: status
        real(c_double), pointer :: samples(:, :)
        type(c_ptr) :: first
        integer(c_size_t) :: count
        first = stickslip_history_field(this%handle, which, count)
        samples => plane(first, count, this%grid, status)
    end function history_field

    ! Returns the zone of every cell: STICKSLIP_SEPARATED, STICKSLIP_STICK or STICKSLIP_SLIP.
    function history_zones(this, status) result(zones)
        class(contact_history), intent(in) :: this
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int8_t), pointer :: zones(:, :)
        type(c_ptr) :: first
        integer(c_size_t) :: count
        first = stickslip_history_zones(this%handle, count)
        zones => map_of_zones(first, count, this%grid, status)
    end function history_zones

    ! Returns the contact spots and, for every cell, the number of its spot: counted from one, zero outside the contact.
    subroutine history_spots(this, spots, labels, status)
        class(contact_history), intent(in) :: this
        type(stickslip_spot), allocatable, intent(out) :: spots(:)
        integer(c_int32_t), allocatable, intent(out), optional :: labels(:, :)
        integer(c_int32_t), intent(out), optional :: status
        integer(c_size_t) :: count
        integer(c_int32_t) :: code
        code = stickslip_history_spots(this%handle, capacity=0_c_size_t, count=count, cells=0_c_size_t)
        if (code == STICKSLIP_OK) then
            allocate (spots(count))
            if (present(labels)) then
                allocate (labels(this%grid%nx, this%grid%ny))
                code = stickslip_history_spots(this%handle, spots, &
                    size(spots, kind=c_size_t), count, labels, size(labels, kind=c_size_t))
            else
                code = stickslip_history_spots(this%handle, spots, &
                    size(spots, kind=c_size_t), count, cells=0_c_size_t)
            end if
        end if
        call report_status(code, status)
    end subroutine history_spots

    ! Adds to depth the depth that Archard's law removes in the last step; the coefficient is one value for all cells or a
    ! value for each cell.
    subroutine wear_archard_uniform(this, coefficient, depth, status)
        class(contact_history), intent(in) :: this
        real(c_double), intent(in) :: coefficient
        real(c_double), intent(inout), contiguous :: depth(:, :)
        integer(c_int32_t), intent(out), optional :: status
        if (.not. fits('depth', shape(depth), this%grid, status)) return
        call report_status(stickslip_wear_archard(this%handle, stickslip_per_cell(coefficient), depth, &
            size(depth, kind=c_size_t)), status)
    end subroutine wear_archard_uniform

    subroutine wear_archard_of_cells(this, coefficients, depth, status)
        class(contact_history), intent(in) :: this
        real(c_double), intent(in), target, contiguous :: coefficients(:, :)
        real(c_double), intent(inout), contiguous :: depth(:, :)
        integer(c_int32_t), intent(out), optional :: status
        if (.not. fits('coefficients', shape(coefficients), this%grid, status)) return
        if (.not. fits('depth', shape(depth), this%grid, status)) return
        call report_status(stickslip_wear_archard(this%handle, per_cell(coefficients), depth, size(depth, kind=c_size_t)), &
            status)
    end subroutine wear_archard_of_cells

    ! Adds to depth the depth that the energy law removes in the last step, with the same forms of the coefficient.
    subroutine wear_energy_uniform(this, coefficient, depth, status)
        class(contact_history), intent(in) :: this
        real(c_double), intent(in) :: coefficient
        real(c_double), intent(inout), contiguous :: depth(:, :)
        integer(c_int32_t), intent(out), optional :: status
        if (.not. fits('depth', shape(depth), this%grid, status)) return
        call report_status(stickslip_wear_energy(this%handle, stickslip_per_cell(coefficient), depth, &
            size(depth, kind=c_size_t)), status)
    end subroutine wear_energy_uniform

    subroutine wear_energy_of_cells(this, coefficients, depth, status)
        class(contact_history), intent(in) :: this
        real(c_double), intent(in), target, contiguous :: coefficients(:, :)
        real(c_double), intent(inout), contiguous :: depth(:, :)
        integer(c_int32_t), intent(out), optional :: status
        if (.not. fits('coefficients', shape(coefficients), this%grid, status)) return
        if (.not. fits('depth', shape(depth), this%grid, status)) return
        call report_status(stickslip_wear_energy(this%handle, per_cell(coefficients), depth, size(depth, kind=c_size_t)), &
            status)
    end subroutine wear_energy_of_cells

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
        type(stickslip_history) :: made
        integer(c_int32_t) :: code
        code = stickslip_history_from_bytes(bodies%handle, bytes, size(bytes, kind=c_size_t), made)
        call history_take(this, made, bodies%grid, code, status)
    end subroutine history_from_bytes

    ! Saves the current state of a history.
    subroutine state_keep(this, history, status)
        class(contact_state), intent(inout) :: this
        class(contact_history), intent(in) :: history
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        if (c_associated(this%address())) then
            code = stickslip_state_keep(this%handle, history%handle)
        else
            code = stickslip_state_new(history%handle, this%handle)
        end if
        call report_status(code, status)
    end subroutine state_keep

    ! Replaces the object by the new one. If made_with is a failure or the old object is in use, the old object remains.
    subroutine history_take(this, made, grid, made_with, status)
        class(contact_history), intent(inout) :: this
        type(stickslip_history), intent(in) :: made
        type(stickslip_grid), intent(in) :: grid
        integer(c_int32_t), intent(in) :: made_with
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code, given_up
        code = made_with
        if (code == STICKSLIP_OK) code = stickslip_history_free(this%handle)
        if (code == STICKSLIP_OK) then
            this%handle = made
            this%grid = grid
        else
            given_up = stickslip_history_free(made)
        end if
        call report_status(code, status)
    end subroutine history_take

    function history_address(this) result(address)
        class(contact_history), intent(in) :: this
        type(c_ptr) :: address
        address = this%handle%address
    end function history_address

    ! Frees the object unless another thread is using it.
    subroutine history_free(this)
        class(contact_history), intent(inout) :: this
        if (stickslip_history_free(this%handle) == STICKSLIP_OK) this%handle = stickslip_history()
    end subroutine history_free

    subroutine history_final(this)
        type(contact_history), intent(inout) :: this
        call this%free()
    end subroutine history_final

    function state_address(this) result(address)
        class(contact_state), intent(in) :: this
        type(c_ptr) :: address
        address = this%handle%address
    end function state_address

    ! Frees the object unless another thread is using it.
    subroutine state_free(this)
        class(contact_state), intent(inout) :: this
        if (stickslip_state_free(this%handle) == STICKSLIP_OK) this%handle = stickslip_state()
    end subroutine state_free

    subroutine state_final(this)
        type(contact_state), intent(inout) :: this
        call this%free()
    end subroutine state_final

    subroutine workspace_new(this, options, status)
        class(stiffness_workspace), intent(inout) :: this
        type(stickslip_stiffness_options), intent(in), optional :: options
        integer(c_int32_t), intent(out), optional :: status
        type(stickslip_stiffness_workspace) :: made
        integer(c_int32_t) :: code, given_up
        code = stickslip_stiffness_workspace_new(options, made)
        if (code == STICKSLIP_OK) code = stickslip_stiffness_workspace_free(this%handle)
        if (code == STICKSLIP_OK) then
            this%handle = made
        else
            given_up = stickslip_stiffness_workspace_free(made)
        end if
        call report_status(code, status)
    end subroutine workspace_new

    ! Sets the options of the next stiffness. The workspace keeps its buffers.
    subroutine workspace_set_options(this, options, status)
        class(stiffness_workspace), intent(in) :: this
        type(stickslip_stiffness_options), intent(in) :: options
        integer(c_int32_t), intent(out), optional :: status
        call report_status(stickslip_stiffness_workspace_set_options(this%handle, options), status)
    end subroutine workspace_set_options

    ! Returns the report of the last stiffness.
    function workspace_report(this, status) result(report)
        class(stiffness_workspace), intent(in) :: this
        integer(c_int32_t), intent(out), optional :: status
        type(stickslip_report) :: report
        call report_status(stickslip_stiffness_workspace_report(this%handle, report), status)
    end function workspace_report

    function workspace_address(this) result(address)
        class(stiffness_workspace), intent(in) :: this
        type(c_ptr) :: address
        address = this%handle%address
    end function workspace_address

    ! Frees the object unless another thread is using it.
    subroutine workspace_free(this)
        class(stiffness_workspace), intent(inout) :: this
        if (stickslip_stiffness_workspace_free(this%handle) == STICKSLIP_OK) this%handle = stickslip_stiffness_workspace()
    end subroutine workspace_free

    subroutine workspace_final(this)
        type(stiffness_workspace), intent(inout) :: this
        call this%free()
    end subroutine workspace_final
end module stickslip_histories
