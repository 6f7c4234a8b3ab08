! What all objects have, and two bodies on a grid. The module stickslip passes on what programs need of it.
module stickslip_objects
    use, intrinsic :: iso_c_binding
    use stickslip_bindings
    implicit none

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

    abstract interface
        ! One of the functions of C that free an object.
        function freeing(object) result(answer) bind(c)
            import
            type(c_ptr), value :: object
            integer(c_int32_t) :: answer
        end function freeing
    end interface

contains

    ! The message of the last failure in C on this thread; the refusals of these modules have their code alone.
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

    ! Refuses what C does not see; the message is shown where there is no status.
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
        if (c_associated(this%handle) .or. c_associated(other%handle)) error stop 'stickslip: an object cannot be assigned'
    end subroutine refuse_copy

    ! A field of count cells, nx by ny of the grid; not associated on failure.
    function plane(first, count, grid, code, status) result(samples)
        type(c_ptr), intent(in) :: first
        integer(c_size_t), intent(in) :: count
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
        else if (count /= grid%nx * grid%ny) then
            call refuse(STICKSLIP_LENGTH, 'the field has another number of cells than the half_space', status)
        else
            call c_f_pointer(first, samples, [grid%nx, grid%ny])
            call report_status(STICKSLIP_OK, status)
        end if
    end function plane

    ! Puts an object that was made in the place of the one that was there, which stays if code is a failure or it is in use.
    subroutine take_over(this, code, made, free, status)
        class(stickslip_object), intent(inout) :: this
        integer(c_int32_t), intent(in) :: code
        type(c_ptr), intent(in) :: made
        procedure(freeing) :: free
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: told, given_up
        told = code
        if (code == STICKSLIP_OK) then
            told = free(this%handle)
            if (told == STICKSLIP_OK) then
                this%handle = made
            else
                given_up = free(made)
            end if
        end if
        call report_status(told, status)
    end subroutine take_over

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
        type(c_ptr) :: made
        integer(c_int32_t) :: code
        code = stickslip_half_space_new(grid, body_1, body_2, boundary, made)
        call take_over(this, code, made, stickslip_half_space_free, status)
    end subroutine half_space_new

    function half_space_pair(this, status) result(pair)
        class(half_space), intent(in) :: this
        integer(c_int32_t), intent(out), optional :: status
        type(stickslip_pair) :: pair
        call report_status(stickslip_half_space_pair(this%handle, pair), status)
    end function half_space_pair

    subroutine half_space_free(this)
        class(half_space), intent(inout) :: this
        call freed(this, stickslip_half_space_free(this%handle))
    end subroutine half_space_free

    subroutine half_space_final(this)
        type(half_space), intent(inout) :: this
        call this%free()
    end subroutine half_space_final
end module stickslip_objects
