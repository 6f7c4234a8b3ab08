! A mass on a contact with friction under an alternating force. Time integration uses Newmark's rule of average
! acceleration. Each time step uses Newton's iteration with the tangent stiffness of the contact. The energy balance closes
! to the tolerance of Newton's iteration. SI units.
!   fretting_newmark_f [cells along a side, default 48] [time steps, default 160]
program fretting_newmark
    use stickslip
    implicit none
    real(c_double), parameter :: mass = 1, load = 100, amplitude = 20
    integer, parameter :: steps_per_cycle = 40
    type(stickslip_material), parameter :: steel = stickslip_material(213d9, 0.29d0)
    character(len=16) :: argument
    integer(c_size_t) :: n = 48
    integer :: steps = 160
    logical :: good

    call get_command_argument(1, argument)
    if (argument /= '') read (argument, *) n
    call get_command_argument(2, argument)
    if (argument /= '') read (argument, *) steps
    good = .false.
    call run()
    if (.not. good) error stop 1

contains

    subroutine run()
        type(stickslip_grid) :: grid
        type(half_space) :: bodies
        type(contact_history) :: history
        type(contact_state) :: before
        type(contact_cycle) :: cycle
        type(stickslip_history_options) :: options
        type(stickslip_stiffness) :: slope
        type(stickslip_step_result) :: now
        type(stickslip_cycle_result) :: loop
        real(c_double), allocatable :: ball(:, :)
        real(c_double) :: pulsation, dt, x, v, a, pull, new_x, new_a, new_pull, missing, given, dissipated, moving, stored
        real(c_double) :: imbalance
        integer :: step, iteration, most_iterations

        grid = stickslip_grid(n, n, 0.30d-3 / real(n, c_double), 0.30d-3 / real(n, c_double))
        call bodies%new(grid, steel, steel)
        allocate (ball(n, n))
        if (stickslip_surface_sphere(grid, 3.5d-3, ball, size(ball, kind=c_size_t)) /= STICKSLIP_OK) error stop 1
        options%settings%tolerance = 1d-10
        call history%new(bodies, ball, stickslip_coulomb(0.5d0), options)
        call history%step(stickslip_load_step(normal=stickslip_normal_load(STICKSLIP_FORCE, load)))

        ! The mass is driven at half of the natural frequency of the sticking contact.
        slope = history%stiffness()
        pulsation = 0.5d0 * sqrt(slope%tangential%reversal(1, 1) / mass)
        dt = 2 * acos(-1d0) / pulsation / steps_per_cycle
        x = 0; v = 0; a = 0; pull = 0; given = 0; dissipated = 0; most_iterations = 0
        do step = 1, steps
            if (mod(step - 1, steps_per_cycle) == 0) call cycle%begin(history)
            new_pull = min(1d0, real(step, c_double) / steps_per_cycle) * amplitude * sin(pulsation * dt * step)
            call before%keep(history)
            new_x = x + dt * v + 0.25d0 * dt**2 * a
            do iteration = 0, 30
                ! Each iteration starts from the state before the time step.
                call history%set_state(before)
                call history%step(stickslip_load_step(x=stickslip_control(STICKSLIP_SHIFT, new_x)))
                now = history%result()
                new_a = 4 / dt**2 * (new_x - x) - 4 / dt * v - a
                missing = new_pull - now%force(1) - mass * new_a
                if (abs(missing) <= 1d-9 * amplitude) exit
                slope = history%stiffness()
                new_x = new_x + missing / (4 / dt**2 * mass + slope%tangential%loading(1, 1))
            end do
            if (iteration > 30) error stop 'Newton does not converge'
            most_iterations = max(most_iterations, iteration)
            call cycle%add(history)
            given = given + 0.5d0 * (pull + new_pull) * (new_x - x)
            dissipated = dissipated + now%energy%dissipated_energy_midpoint
            v = v + 0.5d0 * dt * (a + new_a)
            x = new_x; a = new_a; pull = new_pull
        end do

        moving = 0.5d0 * mass * v**2
        stored = now%energy%elastic_after
        imbalance = (moving + stored + dissipated) / given - 1
        loop = cycle%result()
        print '(i0, a, i0, a)', steps, ' time steps, at most ', most_iterations, ' iterations of Newton'
        print '(4(a, es12.5), a, es9.1)', 'given ', given, ' J = moving ', moving, ' + stored ', stored, ' + dissipated ', &
            dissipated, ', imbalance ', imbalance
        print '(a, f6.2, a, f7.4, a)', 'last cycle: force +-', loop%force_amplitude(1), ' N, shift +-', &
            1d6 * loop%shift_amplitude(1), ' um'
        good = abs(imbalance) < 1d-6 .and. dissipated > 0 .and. loop%regime == STICKSLIP_PARTIAL_SLIP
    end subroutine run
end program fretting_newmark
