! Common parts of all objects, and two bodies on a grid. The module stickslip re-exports the parts that programs need.
module stickslip_objects
    use, intrinsic :: iso_c_binding
    use stickslip_bindings
    implicit none

    ! Base type of all objects: the address shows whether the object has been created.
    type, abstract :: stickslip_object
    contains
        procedure(address_of), deferred :: address
        procedure, private :: refuse_copy
        generic :: assignment(=) => refuse_copy
    end type stickslip_object

    abstract interface
        ! Returns the address of the C object; NULL before it is created.
        function address_of(this) result(address)
            import
            class(stickslip_object), intent(in) :: this
            type(c_ptr) :: address
        end function address_of
    end interface

    ! Two elastic half-spaces on a grid.
    type, extends(stickslip_object) :: half_space
        type(stickslip_half_space) :: handle
        type(stickslip_grid) :: grid
    contains
        procedure :: new => half_space_new
        procedure :: new_coated => half_space_new_coated
        procedure :: set_cell_value => half_space_set_cell_value
        procedure :: pair => half_space_pair
        procedure :: address => half_space_address
        procedure :: free => half_space_free
        final :: half_space_final
    end type half_space

contains

    ! Returns the message of the last failure in C on this thread. Errors that these modules detect themselves have only a
    ! code.
    function stickslip_message() result(message)
        character(len=:), allocatable :: message
        message = text_of(stickslip_last_error_message())
    end function stickslip_message

    ! Returns the version of the library.
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

    ! Reports an error that C does not detect. Without status the message is shown and the program stops.
    subroutine refuse(code, message, status)
        integer(c_int32_t), intent(in) :: code
        character(len=*), intent(in) :: message
        integer(c_int32_t), intent(out), optional :: status
        if (.not. present(status)) error stop 'stickslip: ' // message
        status = code
    end subroutine refuse

    subroutine refuse_copy(this, other)
        class(stickslip_object), intent(inout) :: this
        class(stickslip_object), intent(in) :: other
        if (c_associated(this%address()) .or. c_associated(other%address())) &
            error stop 'stickslip: an object cannot be assigned to another object'
    end subroutine refuse_copy

    ! Returns whether an array has the shape of the grid, and reports an error if it does not. C rejects an object without a
    ! grid.
    function fits(name, found, grid, status) result(does)
        character(len=*), intent(in) :: name
        integer, intent(in) :: found(2)
        type(stickslip_grid), intent(in) :: grid
        integer(c_int32_t), intent(inout), optional :: status
        logical :: does
        character(len=160) :: message
        does = grid%nx == 0 .or. all(found == [grid%nx, grid%ny])
        if (does) return
        write (message, '(a, 2(a, i0, a, i0, a))') name, ' has the shape (', found(1), ', ', found(2), ')', &
            ', expected the shape of the grid (', grid%nx, ', ', grid%ny, ')'
        call refuse(STICKSLIP_LENGTH, trim(message), status)
    end function fits

    ! Returns a quantity with a value for each cell, for example a coefficient of friction or a hardness. The values are not
    ! copied: the array needs the attribute target and must remain valid until the call that uses the quantity.
    function per_cell(values) result(quantity)
        real(c_double), intent(in), target, contiguous :: values(:, :)
        type(stickslip_per_cell) :: quantity
        quantity = stickslip_per_cell(cells=c_loc(values), count=size(values, kind=c_size_t))
    end function per_cell

    ! Returns the message of a warning.
    function warning_text(warning) result(text)
        type(stickslip_warning), intent(in) :: warning
        character(len=:), allocatable :: text
        integer :: i
        text = ''
        do i = 1, size(warning%message)
            if (warning%message(i) == c_null_char) exit
            text = text // warning%message(i)
        end do
    end function warning_text

    ! Returns a pointer to a field on the grid; the pointer is not associated on failure.
    function plane(first, count, grid, status) result(samples)
        type(c_ptr), intent(in) :: first
        integer(c_size_t), intent(in) :: count
        type(stickslip_grid), intent(in) :: grid
        integer(c_int32_t), intent(out), optional :: status
        real(c_double), pointer :: samples(:, :)
        nullify (samples)
        if (is_field(first, count, grid, status)) call c_f_pointer(first, samples, [grid%nx, grid%ny])
    end function plane

    ! Returns the zones of all cells, STICKSLIP_SEPARATED, STICKSLIP_STICK or STICKSLIP_SLIP; the pointer is not
    ! associated on failure.
    function map_of_zones(first, count, grid, status) result(zones)
        type(c_ptr), intent(in) :: first
        integer(c_size_t), intent(in) :: count
        type(stickslip_grid), intent(in) :: grid
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int8_t), pointer :: zones(:, :)
        nullify (zones)
        if (is_field(first, count, grid, status)) call c_f_pointer(first, zones, [grid%nx, grid%ny])
    end function map_of_zones

    ! Returns whether C has returned a field with all cells of the grid, and reports an error if it has not.
    function is_field(first, count, grid, status) result(is)
        type(c_ptr), intent(in) :: first
        integer(c_size_t), intent(in) :: count
        type(stickslip_grid), intent(in) :: grid
        integer(c_int32_t), intent(out), optional :: status
        type(stickslip_error) :: error
        integer(c_int32_t) :: told
        logical :: is
        is = c_associated(first)
        if (.not. is) then
            told = stickslip_last_error(error)
            call report_status(error%code, status)
        else if (count /= grid%nx * grid%ny) then
            is = .false.
            call refuse(STICKSLIP_LENGTH, 'the field must have as many cells as the grid of its object', status)
        else
            call report_status(STICKSLIP_OK, status)
        end if
    end function is_field

    ! Creates the half-spaces; without the argument boundary, the half-space around the grid is unloaded.
    subroutine half_space_new(this, grid, body_1, body_2, boundary, status)
        class(half_space), intent(inout) :: this
        type(stickslip_grid), intent(in) :: grid
        type(stickslip_material), intent(in) :: body_1, body_2
        type(stickslip_boundary), intent(in), optional :: boundary
        integer(c_int32_t), intent(out), optional :: status
        type(stickslip_half_space) :: made
        integer(c_int32_t) :: code
        code = stickslip_half_space_new(grid, body_1, body_2, boundary, made)
        call half_space_take(this, grid, made, code, status)
    end subroutine half_space_new

    ! Creates coated half-spaces. The layers of each body are listed from the outermost inwards, eight at most; an uncoated
    ! body has an array of size zero.
    subroutine half_space_new_coated(this, grid, body_1, layers_1, body_2, layers_2, boundary, status)
        class(half_space), intent(inout) :: this
        type(stickslip_grid), intent(in) :: grid
        type(stickslip_material), intent(in) :: body_1, body_2
        type(stickslip_layer), intent(in) :: layers_1(:), layers_2(:)
        type(stickslip_boundary), intent(in), optional :: boundary
        integer(c_int32_t), intent(out), optional :: status
        type(stickslip_half_space) :: made
        integer(c_int32_t) :: code
        code = stickslip_half_space_new_coated(grid, body_1, layers_1, size(layers_1, kind=c_size_t), body_2, layers_2, &
            size(layers_2, kind=c_size_t), boundary, made)
        call half_space_take(this, grid, made, code, status)
    end subroutine half_space_new_coated

    ! Replaces the object by the new one. If made_code is a failure or the old object is in use, the old object remains.
    subroutine half_space_take(this, grid, made, made_code, status)
        class(half_space), intent(inout) :: this
        type(stickslip_grid), intent(in) :: grid
        type(stickslip_half_space), intent(in) :: made
        integer(c_int32_t), intent(in) :: made_code
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code, given_up
        code = made_code
        if (code == STICKSLIP_OK) code = stickslip_half_space_free(this%handle)
        if (code == STICKSLIP_OK) then
            this%handle = made
            this%grid = grid
        else
            given_up = stickslip_half_space_free(made)
        end if
        call report_status(code, status)
    end subroutine half_space_take

    ! Sets the meaning of cell values, STICKSLIP_UNIFORM (default) or STICKSLIP_CENTRE, for objects that are created
    ! afterwards.
    subroutine half_space_set_cell_value(this, value, status)
        class(half_space), intent(inout) :: this
        integer(c_int32_t), intent(in) :: value
        integer(c_int32_t), intent(out), optional :: status
        call report_status(stickslip_half_space_set_cell_value(this%handle, value), status)
    end subroutine half_space_set_cell_value

    function half_space_pair(this, status) result(pair)
        class(half_space), intent(in) :: this
        integer(c_int32_t), intent(out), optional :: status
        type(stickslip_pair) :: pair
        call report_status(stickslip_half_space_pair(this%handle, pair), status)
    end function half_space_pair

    function half_space_address(this) result(address)
        class(half_space), intent(in) :: this
        type(c_ptr) :: address
        address = this%handle%address
    end function half_space_address

    ! Frees the object unless another thread is using it.
    subroutine half_space_free(this)
        class(half_space), intent(inout) :: this
        if (stickslip_half_space_free(this%handle) == STICKSLIP_OK) this%handle = stickslip_half_space()
    end subroutine half_space_free

    subroutine half_space_final(this)
        type(half_space), intent(inout) :: this
        call this%free()
    end subroutine half_space_final
end module stickslip_objects
