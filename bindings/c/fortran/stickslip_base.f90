! Common parts of all objects. The module stickslip re-exports the parts that programs need.
module stickslip_base
    use, intrinsic :: iso_c_binding
    use stickslip_bindings
    implicit none

    ! Message of the last failure that these modules detected themselves, and the message of C that marks it.
    character(len=160), private, save :: own_message = ''
    character(len=*), parameter, private :: mark = 'error is NULL or misaligned'
    !$omp threadprivate(own_message)

    ! Owner of a C object, which frees it. A copy of the owner has another address and does not free the object.
    type :: stickslip_owner
        private
        type(c_ptr) :: object = c_null_ptr
        procedure(free_object), pointer, nopass :: free => null()
        type(c_ptr) :: origin = c_null_ptr
    contains
        final :: owner_final
    end type stickslip_owner

    ! Base type of all objects: the address shows whether the object has been created. Each type declares its own
    ! assignment, because gfortran does not call an inherited one for components. The owner is allocatable, because
    ! gfortran 12 finalizes components that are arrays only if they are allocatable.
    type, abstract :: stickslip_object
        type(stickslip_owner), allocatable, private :: owner
    contains
        procedure(address_of), deferred :: address
        procedure, non_overridable :: own
        procedure, non_overridable :: disown
    end type stickslip_object

    abstract interface
        function free_object(object) result(code) bind(c)
            import
            type(c_ptr), value :: object
            integer(c_int32_t) :: code
        end function free_object

        ! Returns the address of the C object; NULL before it is created.
        function address_of(this) result(address)
            import
            class(stickslip_object), intent(in) :: this
            type(c_ptr) :: address
        end function address_of
    end interface

contains

    ! Returns the message of the last failure on this thread.
    function stickslip_message() result(message)
        character(len=:), allocatable :: message
        message = text_of(stickslip_last_error_message())
        if (message == mark .and. own_message /= '') message = trim(own_message)
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

    ! Reports an error that C does not detect. Without status the message is shown and the program stops. A call of C that
    ! fails marks the message as the last one, so that a later failure of C replaces it.
    subroutine refuse(code, message, status)
        integer(c_int32_t), intent(in) :: code
        character(len=*), intent(in) :: message
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: failed
        if (.not. present(status)) error stop 'stickslip: ' // message
        status = code
        own_message = message
        failed = stickslip_last_error()
    end subroutine refuse

    ! Makes the object responsible for its C object, which it frees with a function of C.
    subroutine own(this, free)
        class(stickslip_object), intent(inout) :: this
        type(c_funptr), value :: free
        call this%disown()
        allocate (this%owner)
        call set_owner(this%owner, this%address(), free)
    end subroutine own

    subroutine set_owner(owner, object, free)
        type(stickslip_owner), intent(inout), target :: owner
        type(c_ptr), intent(in) :: object
        type(c_funptr), value :: free
        owner%object = object
        owner%origin = c_loc(owner)
        call c_f_procpointer(free, owner%free)
    end subroutine set_owner

    ! Ends the responsibility for a C object that has been freed.
    subroutine disown(this)
        class(stickslip_object), intent(inout) :: this
        if (.not. allocated(this%owner)) return
        this%owner%origin = c_null_ptr
        deallocate (this%owner)
    end subroutine disown

    ! Frees the object unless another thread is using it.
    impure elemental subroutine owner_final(owner)
        type(stickslip_owner), intent(inout), target :: owner
        integer(c_int32_t) :: code
        if (c_associated(owner%origin, c_loc(owner))) code = owner%free(owner%object)
        owner%origin = c_null_ptr
    end subroutine owner_final

    subroutine refuse_copy(this, other)
        class(stickslip_object), intent(in) :: this, other
        logical :: is_copy
        ! The left side is tested last, because a program may assign to an object that is not allocated.
        is_copy = c_associated(other%address())
        if (.not. is_copy) is_copy = c_associated(this%address())
        if (is_copy) error stop 'stickslip: an object cannot be assigned to another object'
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
    ! copied: the array needs the attribute target and must remain valid until the call that uses the quantity. After
    ! STICKSLIP_LENGTH every use of the quantity fails.
    function per_cell(values, grid, status) result(quantity)
        real(c_double), intent(in), target, contiguous :: values(:, :)
        type(stickslip_grid), intent(in) :: grid
        integer(c_int32_t), intent(out), optional :: status
        type(stickslip_per_cell) :: quantity
        quantity = stickslip_per_cell(count=grid%nx * grid%ny)
        if (.not. fits('the quantity per cell', shape(values), grid, status)) return
        quantity = stickslip_per_cell(cells=c_loc(values), count=size(values, kind=c_size_t))
        call report_status(STICKSLIP_OK, status)
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

    ! Returns pointers to the arrays. They are valid within one call only, because the compiler may have passed a copy.
    function tractions_of(pressure, x, y) result(tractions)
        real(c_double), intent(in), target, contiguous :: pressure(:, :)
        real(c_double), intent(in), target, contiguous, optional :: x(:, :), y(:, :)
        type(stickslip_tractions) :: tractions
        tractions = stickslip_tractions(pressure=c_loc(pressure), count=size(pressure, kind=c_size_t))
        if (present(x)) tractions%x = c_loc(x)
        if (present(y)) tractions%y = c_loc(y)
    end function tractions_of

    ! Returns whether all arrays have the shape of the grid, and reports an error if one does not.
    function all_fit(grid, pressure, x, y, status) result(all_do)
        type(stickslip_grid), intent(in) :: grid
        real(c_double), intent(in) :: pressure(:, :)
        real(c_double), intent(in), optional :: x(:, :), y(:, :)
        integer(c_int32_t), intent(inout), optional :: status
        logical :: all_do
        all_do = fits('pressure', shape(pressure), grid, status)
        if (all_do .and. present(x)) all_do = fits('x', shape(x), grid, status)
        if (all_do .and. present(y)) all_do = fits('y', shape(y), grid, status)
    end function all_fit
end module stickslip_base
