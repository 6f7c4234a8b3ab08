! A steel ball on steel, pressed and sheared, compared with the solutions of Hertz and of Cattaneo and Mindlin. SI units.
!   press_and_shear_f [cells along a side, default 128]
program press_and_shear
    use stickslip
    implicit none
    real(c_double), parameter :: radius = 3.5d-3, load = 100, drag = 20, mu = 0.5d0, side = 0.40d-3
    type(stickslip_material), parameter :: steel = stickslip_material(213d9, 0.29d0)
    character(len=16) :: argument
    integer(c_size_t) :: n = 128
    logical :: good

    if (stickslip_abi_version() /= STICKSLIP_ABI_VERSION_COMPILED) error stop 'the library is of another version'
    call get_command_argument(1, argument)
    if (argument /= '') read (argument, *) n
    good = .true.
    call run()
    if (.not. good) error stop 1

contains

    subroutine run()
        type(stickslip_grid) :: grid
        type(half_space) :: bodies
        type(normal_solver) :: presser
        type(normal_solution) :: pressed
        type(tangential_solver) :: shearer
        type(tangential_solution) :: sheared
        type(stickslip_normal_result) :: normal
        type(stickslip_tangential_result) :: shear
        type(stickslip_report) :: report
        type(stickslip_pair) :: pair
        type(stickslip_error) :: error
        real(c_double), allocatable :: ball(:, :)
        real(c_double), pointer :: pressure(:, :)
        real(c_double) :: a, peak, stick, shift, cells
        integer(c_int32_t) :: status, told

        grid = stickslip_grid(n, n, side / real(n, c_double), side / real(n, c_double))
        call bodies%new(grid, steel, steel)
        allocate (ball(n, n))
        if (stickslip_surface_sphere(grid, radius, ball, size(ball, kind=c_size_t)) /= STICKSLIP_OK) error stop 1

        call presser%new(bodies, ball, stickslip_normal_load(STICKSLIP_FORCE, load))
        call presser%solve(pressed)
        call shearer%new(bodies, pressed, stickslip_coulomb(mu), pull_of(drag))
        call shearer%solve(sheared)

        pressure => pressed%field(STICKSLIP_PRESSURE) ! a pointer into the solution, not a copy
        normal = pressed%result()
        shear = sheared%result()
        report = sheared%report()
        pair = bodies%pair()
        a = (0.75d0 * load * radius / pair%contact_modulus)**(1 / 3d0)
        peak = 1.5d0 * load / (acos(-1d0) * a**2)
        stick = (1 - drag / (mu * load))**(1 / 3d0)
        shift = 3 * mu * load / (16 * pair%tangential_modulus * a) * (1 - stick**2)
        ! The grid resolves pressure and shift to a fraction of a cell, and the stick zone to whole cells.
        cells = a / grid%dx
        call compare('approach', normal%approach, a**2 / radius, 0.3d0 / cells**2)
        call compare('largest pressure', maxval(pressure), peak, 3 / cells**2)
        call compare('shift', shear%shift(1), shift, 1 / cells**2)
        call compare('stick ratio', shear%stick_ratio, stick**2, 0.6d0 / cells)
        good = good .and. report%energy_error_bound <= 1d-8

        ! A force above the friction capacity is rejected; the message contains the limit.
        call shearer%set_load(pull_of(60d0), status)
        told = stickslip_last_error(error)
        print '(a)', 'refused: ' // stickslip_message()
        good = good .and. status == STICKSLIP_BEYOND_FRICTION_CAPACITY .and. abs(error%limit - mu * load) < 1d-6
    end subroutine run

    function pull_of(force) result(pull)
        real(c_double), intent(in) :: force
        type(stickslip_tangential_load) :: pull
        pull = stickslip_tangential_load(x=stickslip_control(STICKSLIP_FORCE, force))
    end function pull_of

    ! Prints a number and its closed-form value, and records a disagreement.
    subroutine compare(name, found, exact, tolerance)
        character(len=*), intent(in) :: name
        real(c_double), intent(in) :: found, exact, tolerance
        print '(a16, 1x, es13.6, a, es13.6, a, es9.1)', name, found, '  closed form', exact, '  difference', found / exact - 1
        good = good .and. abs(found / exact - 1) <= tolerance
    end subroutine compare
end program press_and_shear
