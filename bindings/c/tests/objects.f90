! Objects of Fortran: a new one takes the place of another only if it is made and the other is not in use, and fields have the
! cells that their objects have.
module within_a_step
    use stickslip
    implicit none
    integer(c_size_t), parameter :: n = 16
    type(stickslip_material), parameter :: steel = stickslip_material(210d3, 0.3d0, 0)

    ! What an observer is told, and what it saw.
    type :: told_and_seen
        type(c_ptr) :: history, bodies
        logical :: is_kept
        integer(c_int32_t) :: status
    end type told_and_seen

contains

    ! Makes a history anew while it takes a step.
    function make_anew(iteration, user) result(go_on) bind(c)
        type(stickslip_iteration), intent(in) :: iteration
        type(c_ptr), value :: user
        integer(c_int32_t) :: go_on
        type(told_and_seen), pointer :: seen
        type(contact_history) :: history
        type(half_space) :: bodies
        real(c_double) :: flat(n, n)
        call c_f_pointer(user, seen)
        history%handle = seen%history
        bodies%handle = seen%bodies
        flat = 0
        call history%new(bodies, flat, stickslip_coulomb(0.5d0), status=seen%status)
        seen%is_kept = c_associated(history%handle, seen%history)
        ! They are freed by the program.
        history%handle = c_null_ptr
        bodies%handle = c_null_ptr
        go_on = merge(1_c_int32_t, 0_c_int32_t, iteration%iteration >= 0)
    end function make_anew
end module within_a_step

program objects
    use within_a_step
    implicit none
    logical :: good = .true.

    call run()
    if (.not. good) error stop 1

contains

    subroutine check(condition, what)
        logical, intent(in) :: condition
        character(len=*), intent(in) :: what
        if (.not. condition) print '(a)', what
        good = good .and. condition
    end subroutine check

    subroutine run()
        type(stickslip_grid) :: grid, wrong
        type(half_space) :: bodies, larger
        type(normal_solver) :: presser
        type(normal_solution) :: pressed
        type(tangential_solver) :: shearer
        type(tangential_solution) :: sheared
        type(contact_history) :: history
        type(stress_planes) :: planes
        type(stickslip_friction) :: friction
        type(stickslip_control) :: held
        type(stickslip_step_result) :: result
        ! Changed through the pointer that the observer has, which compilers may not see.
        type(told_and_seen), target, volatile :: seen
        type(c_ptr) :: before
        real(c_double) :: ball(n, n)
        real(c_double), pointer :: samples(:, :)
        integer(c_int8_t), allocatable :: bytes(:)
        integer(c_int32_t) :: status

        grid = stickslip_grid(n, n, 0.4d0 / n, 0.4d0 / n)
        held = stickslip_control(STICKSLIP_HOLD, 0, 0)
        friction = stickslip_coulomb(0.5d0)
        call bodies%new(grid, steel, steel)
        call larger%new(stickslip_grid(4 * n, n, 0.1d0, 0.1d0), steel, steel)
        if (stickslip_surface_sphere(grid, 5d0, ball, size(ball, kind=c_size_t)) /= STICKSLIP_OK) error stop 1
        call presser%new(bodies, ball, stickslip_normal_load(STICKSLIP_FORCE, 100))
        call presser%solve(pressed)
        call shearer%new(bodies, pressed, friction, &
            stickslip_tangential_load(stickslip_control(STICKSLIP_FORCE, 20, 0), held, 0))
        call shearer%solve(sheared)
        call planes%new(bodies, [0.01d0])
        samples => pressed%field(STICKSLIP_PRESSURE, bodies)
        call planes%solve(1, STICKSLIP_BODY_1, samples)
        call history%new(bodies, ball, friction)
        call history%step(stickslip_load_step(stickslip_normal_load(STICKSLIP_FORCE, 100), held, held, 0, 0, 0, 0))

        ! Fields on other bodies, and depths that are none.
        samples => pressed%field(STICKSLIP_PRESSURE, larger, status)
        call check(status == STICKSLIP_LENGTH .and. .not. associated(samples), 'a pressure on a larger grid')
        samples => sheared%field(STICKSLIP_TRACTION_X, larger, status)
        call check(status == STICKSLIP_LENGTH .and. .not. associated(samples), 'a traction on a larger grid')
        samples => planes%field(STICKSLIP_STRESS_ZZ, larger, status)
        call check(status == STICKSLIP_LENGTH .and. .not. associated(samples), 'a stress on a larger grid')
        samples => planes%field(STICKSLIP_STRESS_ZZ, bodies, status)
        call check(status == STICKSLIP_OK .and. size(samples) == n * n, 'a stress on its own grid')
        call planes%solve(0, STICKSLIP_BODY_1, ball, status=status)
        call check(status == STICKSLIP_LENGTH, 'depth 0')
        call planes%solve(-huge(1) - 1, STICKSLIP_BODY_1, ball, status=status)
        call check(status == STICKSLIP_LENGTH, 'a negative depth')

        ! What cannot be made leaves the object that was there.
        wrong = grid
        wrong%dx = -1
        before = bodies%handle
        call bodies%new(wrong, steel, steel, status=status)
        call check(status == STICKSLIP_NOT_POSITIVE .and. c_associated(bodies%handle, before), 'no other bodies')
        before = presser%handle
        call presser%new(bodies, ball(:, 2:), stickslip_normal_load(STICKSLIP_FORCE, 100), status=status)
        call check(status == STICKSLIP_LENGTH .and. c_associated(presser%handle, before), 'no other normal solver')
        before = shearer%handle
        call shearer%new(bodies, pressed, stickslip_coulomb(-1d0), stickslip_tangential_load(held, held, 0), status=status)
        call check(status /= STICKSLIP_OK .and. c_associated(shearer%handle, before), 'no other tangential solver')
        before = planes%handle
        call planes%new(bodies, [-1d0], status=status)
        call check(status == STICKSLIP_SAMPLE .and. c_associated(planes%handle, before), 'no other planes')
        before = history%handle
        call history%new(bodies, ball(:, 2:), friction, status=status)
        call check(status == STICKSLIP_LENGTH .and. c_associated(history%handle, before), 'no other history')
        call history%to_bytes(bytes)
        call history%from_bytes(bodies, bytes(2:), status)
        call check(status == STICKSLIP_FORMAT .and. c_associated(history%handle, before), 'no other history from bytes')
        call presser%solve(pressed)
        result = history%result()
        call check(abs(result%normal_force / 100 - 1) < 1d-9, 'the history that was there')

        ! Nor does what is in use give way.
        seen = told_and_seen(history%handle, bodies%handle, .false., STICKSLIP_OK)
        call history%step(stickslip_load_step(stickslip_normal_load(STICKSLIP_FORCE, 150), held, held, 0, 0, 0, 0), &
            stickslip_observer(c_funloc(make_anew), c_loc(seen)))
        call check(seen%status == STICKSLIP_BUSY .and. seen%is_kept, 'no other history within a step')

        ! What can be made takes the place.
        call history%from_bytes(bodies, bytes)
        result = history%result()
        call check(abs(result%normal_force / 100 - 1) < 1d-9, 'another history from bytes')
        call planes%new(bodies, [0.02d0])
        samples => planes%field(STICKSLIP_STRESS_ZZ, bodies, status)
        call check(status == STICKSLIP_REFUSED, 'other planes')
    end subroutine run
end program objects
