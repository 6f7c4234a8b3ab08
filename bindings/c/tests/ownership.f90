! Objects in arrays and in derived types are freed exactly once, which valgrind checks. With an argument, the program assigns
! objects: alone, in arrays or in derived types. It must then stop with a message.
module ownership_types
    use stickslip
    implicit none

    type :: joint
        type(contact_history) :: history
    end type joint
    type, extends(joint) :: damped_joint
        real(c_double) :: damping = 0
    end type damped_joint
    type :: pair
        type(contact_history) :: histories(2)
    end type pair
    type :: machine
        type(joint) :: joint
        type(contact_history), allocatable :: histories(:)
        type(contact_state), allocatable :: state
    end type machine

contains

    subroutine create(history)
        type(contact_history), intent(inout) :: history
        type(stickslip_grid), parameter :: grid = stickslip_grid(8, 8, 0.05d0, 0.05d0)
        type(stickslip_material), parameter :: steel = stickslip_material(210d3, 0.3d0)
        type(half_space) :: bodies
        real(c_double) :: gap(8, 8)
        call bodies%new(grid, steel, steel)
        gap = 0
        call history%new(bodies, gap, stickslip_coulomb(0.5d0))
    end subroutine create

    subroutine create_all(histories)
        type(contact_history), intent(inout) :: histories(:)
        integer :: i
        do i = 1, size(histories)
            call create(histories(i))
        end do
    end subroutine create_all
end module ownership_types

program ownership
    use ownership_types
    implicit none
    character(len=32) :: mode

    call get_command_argument(1, mode)
    if (mode == '') then
        call arrays()
        call components()
        call copies()
    else
        call assign(trim(mode))
        print '(a)', 'the assignment did not stop the program'
    end if

contains

    subroutine check(condition, what)
        logical, intent(in) :: condition
        character(len=*), intent(in) :: what
        if (.not. condition) error stop what
    end subroutine check

    subroutine arrays()
        type(contact_history) :: fixed(3), plane(2, 2), empty(3)
        type(contact_history), allocatable :: histories(:), moved(:), alone
        class(contact_history), allocatable :: polymorphic(:)
        integer(c_int32_t) :: status
        integer :: i
        call create_all(fixed)
        do i = 1, 2
            call create_all(plane(:, i))
        end do
        allocate (histories(4), polymorphic(2), alone)
        call create_all(histories)
        call create_all(polymorphic)
        call create(alone)
        call move_alloc(histories, moved)
        call moved(2)%free()
        call moved%free()
        call moved(1)%step(stickslip_load_step(), status=status)
        call check(status == STICKSLIP_BAD_POINTER, 'a history of an array was not freed')
        call create_all(moved(1:3:2))
        deallocate (moved)
        ! A new object replaces the old one.
        call create_all(fixed)
        ! Objects that have not been created can be assigned.
        empty = empty
    end subroutine arrays

    subroutine components()
        type(joint) :: one, several(2)
        type(damped_joint) :: damped
        type(pair) :: both, pairs(2)
        type(pair), allocatable :: allocated_pairs(:)
        type(machine) :: whole
        integer :: i
        call create(one%history)
        call create(damped%history)
        call create_all(both%histories)
        allocate (allocated_pairs(2), whole%histories(2), whole%state)
        do i = 1, 2
            call create(several(i)%history)
            call create_all(pairs(i)%histories)
            call create_all(allocated_pairs(i)%histories)
        end do
        call create(whole%joint%history)
        call create_all(whole%histories)
        call whole%state%keep(whole%histories(1))
    end subroutine components

    ! Copies without an assignment do not free the object of the original.
    subroutine copies()
        type(contact_history) :: original
        type(contact_history), allocatable :: copy, several(:)
        type(stickslip_step_result) :: result
        call create(original)
        allocate (copy, source=original)
        allocate (several(2), source=original)
        deallocate (copy, several)
        result = original%result()
        call check(result%steps == 0, 'a copy freed the object of the original')
    end subroutine copies

    subroutine assign(mode)
        character(len=*), intent(in) :: mode
        type(contact_history) :: history, other, histories(2), others(2)
        type(contact_history), allocatable :: allocated_histories(:), absent_histories(:), absent
        type(joint) :: one, other_one, several(2), other_several(2)
        type(damped_joint) :: damped, other_damped
        type(pair) :: both, other_both
        type(machine) :: whole, other_whole
        select case (mode)
        case ('scalar')
            call create(history)
            other = history
        case ('array')
            call create_all(histories)
            others = histories
        case ('allocatable')
            allocate (allocated_histories(2))
            call create_all(allocated_histories)
            others = allocated_histories
        case ('unallocated')
            call create(history)
            absent = history
        case ('unallocated_array')
            call create_all(histories)
            absent_histories = histories
        case ('component')
            call create(one%history)
            other_one = one
        case ('constructor')
            call create(history)
            other_one = joint(history)
        case ('extension')
            call create(damped%history)
            other_damped = damped
        case ('array_of_components')
            call create(several(2)%history)
            other_several = several
        case ('component_array')
            call create_all(both%histories)
            other_both = both
        case ('nested')
            call create(whole%joint%history)
            other_whole = whole
        case default
            error stop 'unknown mode'
        end select
    end subroutine assign
end program ownership
