! Objects in Fortran. A new object replaces an existing one only if it has been created and the old one is not in use.
! Fields have the cells of their objects.
module within_a_step
    use stickslip
    implicit none
    integer(c_size_t), parameter :: n = 16
    type(stickslip_material), parameter :: steel = stickslip_material(210d3, 0.3d0, 0)

    ! Input of an observer, and its findings.
    type :: told_and_seen
        type(stickslip_history) :: history
        type(stickslip_half_space) :: bodies
        logical :: is_kept
        integer(c_int32_t) :: status
    end type told_and_seen

contains

    ! Ends the observed call immediately.
    function stop_at_once(iteration, user) result(go_on) bind(c)
        type(stickslip_iteration), intent(in) :: iteration
        type(c_ptr), value :: user
        integer(c_int32_t) :: go_on
        go_on = merge(0_c_int32_t, 1_c_int32_t, iteration%iteration >= 0 .and. .not. c_associated(user))
    end function stop_at_once

    ! Tries to replace a history during its own step. Objects of foreign handles do not free them.
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
        bodies%grid = stickslip_grid(n, n, 0.4d0 / n, 0.4d0 / n)
        flat = 0
        call history%new(bodies, flat, stickslip_coulomb(0.5d0), status=seen%status)
        seen%is_kept = c_associated(history%address(), seen%history%address)
        go_on = merge(1_c_int32_t, 0_c_int32_t, iteration%iteration >= 0)
    end function make_anew

    ! Counts the steps of a load. Ends the call when the count reaches zero.
    function count_steps(step, user) result(go_on) bind(c)
        type(stickslip_step_result), intent(in) :: step
        type(c_ptr), value :: user
        integer(c_int32_t) :: go_on
        integer(c_size_t), pointer :: seen
        call c_f_pointer(user, seen)
        seen = seen + merge(1, 0, step%has_last_step /= 0)
        go_on = merge(0_c_int32_t, 1_c_int32_t, seen == 0)
    end function count_steps
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
        type(half_space) :: bodies, layered
        type(stickslip_layer) :: no_layers(0)
        type(normal_solver) :: presser, coated_presser
        type(normal_solution) :: pressed, coated_pressed
        type(stickslip_normal_result) :: of_layers, of_none
        type(tangential_solver) :: shearer
        type(tangential_solution) :: sheared
        type(contact_history) :: history
        type(stress_planes) :: planes
        type(stickslip_friction) :: friction
        type(stickslip_step_result) :: result
        type(stickslip_observer) :: observer
        type(stickslip_normal_stiffness) :: normal
        type(stickslip_tangential_stiffness) :: tangential
        type(stickslip_stiffness) :: both
        type(stickslip_response), allocatable :: at(:)
        ! The observer changes this variable through a pointer, which the compiler may not detect.
        type(told_and_seen), target, volatile :: seen
        type(c_ptr) :: before
        real(c_double) :: ball(n, n), worn(n, n)
        real(c_double), pointer :: samples(:, :)
        integer(c_int8_t), allocatable :: bytes(:)
        integer(c_int32_t) :: status

        grid = stickslip_grid(n, n, 0.4d0 / n, 0.4d0 / n)
        friction = stickslip_coulomb(0.5d0)
        call bodies%new(grid, steel, steel)
        if (stickslip_surface_sphere(grid, 5d0, ball, size(ball, kind=c_size_t)) /= STICKSLIP_OK) error stop 1
        call presser%new(bodies, ball, stickslip_normal_load(STICKSLIP_FORCE, 100))
        call presser%solve(pressed)
        call shearer%new(bodies, pressed, friction, &
            stickslip_tangential_load(x=stickslip_control(STICKSLIP_FORCE, 20)))
        call shearer%solve(sheared)
        call planes%new(bodies, [0.01d0])
        samples => pressed%field(STICKSLIP_PRESSURE)
        call planes%solve(1, STICKSLIP_BODY_1, samples)
        call history%new(bodies, ball, friction)
        call history%step(stickslip_load_step(stickslip_normal_load(STICKSLIP_FORCE, 100)))

        ! Invalid fields and depths.
        samples => pressed%field(STICKSLIP_TRACTION_X, status)
        call check(status == STICKSLIP_UNKNOWN_OPTION .and. .not. associated(samples), 'traction of a normal solution')
        samples => planes%field(STICKSLIP_STRESS_ZZ, status)
        call check(status == STICKSLIP_OK .and. size(samples) == n * n, 'size of the stress field')
        call planes%solve(0, STICKSLIP_BODY_1, ball, status=status)
        call check(status == STICKSLIP_LENGTH, 'depth with index 0')
        call planes%solve(-huge(1) - 1, STICKSLIP_BODY_1, ball, status=status)
        call check(status == STICKSLIP_LENGTH, 'depth with a negative index')

        ! An object remains if its replacement cannot be created.
        wrong = grid
        wrong%dx = -1
        before = bodies%address()
        call bodies%new(wrong, steel, steel, status=status)
        call check(status == STICKSLIP_NOT_POSITIVE .and. c_associated(bodies%address(), before), 'bodies are kept')
        call bodies%new_coated(grid, steel, [stickslip_layer(420d3, 0.3d0, -1d0)], steel, no_layers, status=status)
        call check(status == STICKSLIP_NOT_POSITIVE .and. c_associated(bodies%address(), before), 'bodies are kept (layers)')
        call layered%new_coated(grid, steel, [stickslip_layer(420d3, 0.3d0, 0.02d0)], steel, no_layers)
        call coated_presser%new(layered, ball, stickslip_normal_load(STICKSLIP_FORCE, 100))
        call coated_presser%solve(coated_pressed)
        of_layers = coated_pressed%result()
        of_none = pressed%result()
        call check(of_layers%approach < of_none%approach, 'a hard layer reduces the approach')
        before = presser%address()
        call presser%new(bodies, ball(:, 2:), stickslip_normal_load(STICKSLIP_FORCE, 100), status=status)
        call check(status == STICKSLIP_LENGTH .and. c_associated(presser%address(), before), 'normal solver is kept')
        before = shearer%address()
        call shearer%new(bodies, pressed, stickslip_coulomb(-1d0), stickslip_tangential_load(), status=status)
        call check(status /= STICKSLIP_OK .and. c_associated(shearer%address(), before), 'tangential solver is kept')
        before = planes%address()
        call planes%new(bodies, [-1d0], status=status)
        call check(status == STICKSLIP_SAMPLE .and. c_associated(planes%address(), before), 'planes are kept')
        before = history%address()
        call history%new(bodies, ball(:, 2:), friction, status=status)
        call check(status == STICKSLIP_LENGTH .and. c_associated(history%address(), before), 'history is kept')
        call history%to_bytes(bytes)
        call history%from_bytes(bodies, bytes(2:), status)
        call check(status == STICKSLIP_FORMAT .and. c_associated(history%address(), before), 'history is kept (bytes)')
        call presser%solve(pressed)
        result = history%result()
        call check(abs(result%normal_force / 100 - 1) < 1d-9, 'force of the remaining history')

        ! An object in use remains as well.
        seen = told_and_seen(history%handle, bodies%handle, .false., STICKSLIP_OK)
        call history%step(stickslip_load_step(stickslip_normal_load(STICKSLIP_FORCE, 150)), &
            stickslip_observer(c_funloc(make_anew), c_loc(seen)))
        call check(seen%status == STICKSLIP_BUSY .and. seen%is_kept, 'history is kept during its step')

        ! A valid new object replaces the old one.
        call history%from_bytes(bodies, bytes)
        result = history%result()
        call check(abs(result%normal_force / 100 - 1) < 1d-9, 'force of the history from bytes')
        call check(result%has_last_step == 0 .and. result%stick_ratio /= result%stick_ratio, 'no last step after a restart')
        worn = 0
        call history%wear_archard(1d-9, worn, status)
        call check(status == STICKSLIP_NO_LAST_STEP .and. all(abs(worn) <= 0), 'no wear by a step that was not taken')
        call planes%new(bodies, [0.02d0])
        samples => planes%field(STICKSLIP_STRESS_ZZ, status)
        call check(status == STICKSLIP_INVALID_ARGUMENT, 'new planes have no field')

        ! An observer ends the computation of stiffnesses and stresses.
        observer = stickslip_observer(c_funloc(stop_at_once), c_null_ptr)
        normal = pressed%stiffness(bodies, observer, status)
        call check(status == STICKSLIP_NOT_CONVERGED, 'stopped stiffness of the normal contact')
        tangential = sheared%stiffness(bodies, observer, status)
        call check(status == STICKSLIP_NOT_CONVERGED, 'stopped stiffness of the tangential contact')
        both = history%stiffness(observer, status)
        call check(status == STICKSLIP_NOT_CONVERGED, 'stopped stiffness of a history')
        call planes%solve(1, STICKSLIP_BODY_1, ball, observer=observer, status=status)
        call check(status == STICKSLIP_NOT_CONVERGED, 'stopped plane')
        call stress_at_points(bodies, STICKSLIP_BODY_1, [stickslip_point(0, 0, 0.01d0)], at, ball, observer=observer, &
            status=status)
        call check(status == STICKSLIP_NOT_CONVERGED, 'stopped stresses at points')
        call planes%solve(1, STICKSLIP_BODY_1, ball)
        both = history%stiffness()
        call check(both%normal%value > 0, 'stiffness without an observer')
        call observed_steps(history)
    end subroutine run

    ! An observer and a cycle receive every step of a load.
    subroutine observed_steps(history)
        type(contact_history), intent(in) :: history
        type(adaptive_steps) :: steps
        type(contact_cycle) :: sums
        type(stickslip_cycle_result) :: loop
        type(stickslip_step_result) :: result
        type(stickslip_load_step) :: load
        type(stickslip_step_observer) :: observer
        ! The observer changes this variable through a pointer, which the compiler may not detect.
        integer(c_size_t), target, volatile :: seen
        integer(c_size_t) :: taken
        integer(c_int32_t) :: status
        integer :: turn

        call steps%new(history, 0.05d0)
        observer = stickslip_step_observer(c_funloc(count_steps), c_loc(seen))
        do turn = 1, 2
            call sums%begin(history)
            seen = 0
            load = stickslip_load_step(x=stickslip_control(STICKSLIP_FORCE, 30))
            if (turn == 1) call steps%stepwise(history, load, sums, taken, observer)
            load = stickslip_load_step(normal=stickslip_normal_load(STICKSLIP_FORCE, 200))
            if (turn == 2) call press_stepwise(history, load, 0.05d0, sums, taken, observer)
            loop = sums%result()
            call check(taken >= 2 .and. seen == taken .and. loop%steps == taken, 'observed steps of a load')
        end do

        ! Without a cycle and a number of steps. The observer ends the calls at their first step.
        load = stickslip_load_step(normal=stickslip_normal_load(STICKSLIP_FORCE, 250))
        seen = -1
        call steps%stepwise(history, load, observer=observer, status=status)
        call check(status == STICKSLIP_NOT_CONVERGED, 'stopped adaptive steps')
        seen = -1
        call press_stepwise(history, load, 0.05d0, observer=observer, status=status)
        result = history%result()
        call check(status == STICKSLIP_NOT_CONVERGED .and. abs(result%normal_force / 200 - 1) < 1d-9, 'stopped pressing')
        call press_stepwise(history, load, 0.05d0)
        result = history%result()
        call check(abs(result%normal_force / 250 - 1) < 1d-9, 'steps without an observer')
    end subroutine observed_steps
end program objects
