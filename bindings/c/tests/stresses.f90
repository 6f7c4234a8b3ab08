! Surfaces, stresses and closed-form solutions in Fortran.
program stresses
    use stickslip
    implicit none
    integer(c_size_t), parameter :: n = 48
    logical :: good = .true.

    call below_a_sphere()
    call rough()
    if (.not. good) error stop 1

contains

    subroutine check(condition, what)
        logical, intent(in) :: condition
        character(len=*), intent(in) :: what
        if (.not. condition) print '(a)', what
        good = good .and. condition
    end subroutine check

    ! Johnson (1985), section 4.2: the largest shear stress is 0.310 p0, at the depth 0.481 a.
    subroutine below_a_sphere()
        type(stickslip_grid) :: grid
        type(stickslip_material), parameter :: steel = stickslip_material(210d3, 0.3d0, 0)
        type(half_space) :: bodies
        type(normal_solver) :: presser
        type(normal_solution) :: pressed
        type(stress_planes) :: planes
        type(stickslip_hertz) :: hertz
        type(stickslip_cattaneo_mindlin) :: sheared
        type(stickslip_response), allocatable :: at(:)
        real(c_double), allocatable :: ball(:, :), shear(:, :)
        real(c_double), pointer :: pressure(:, :), szz(:, :)
        real(c_double) :: depth
        integer(c_int32_t) :: status

        grid = stickslip_grid(n, n, 0.4d0 / n, 0.4d0 / n)
        call bodies%new(grid, steel, steel)
        allocate (ball(n, n), shear(n, n))
        status = stickslip_surface_sphere(grid, 5d0, ball, size(ball, kind=c_size_t))
        call check(status == STICKSLIP_OK, 'sphere')
        call presser%new(bodies, ball, stickslip_normal_load(STICKSLIP_FORCE, 100))
        call presser%solve(pressed)
        status = stickslip_hertz_sphere(bodies%handle, 5d0, 100d0, hertz)
        call check(status == STICKSLIP_OK, 'Hertz')
        status = stickslip_cattaneo_mindlin_sphere(bodies%handle, 5d0, 100d0, 0.5d0, 0d0, sheared)
        call check(status == STICKSLIP_OK .and. sheared%stick_radius == hertz%contact_radius, 'Cattaneo and Mindlin')

        depth = 0.481d0 * hertz%contact_radius
        pressure => pressed%field(STICKSLIP_PRESSURE)
        call planes%new(bodies, [depth])
        szz => planes%field(STICKSLIP_STRESS_ZZ, status)
        call check(status == STICKSLIP_INVALID_ARGUMENT .and. .not. associated(szz), 'field before the first solve')
        call planes%solve(1, STICKSLIP_BODY_1, pressure)
        call planes%measure(STICKSLIP_MAX_SHEAR, shear)
        call check(abs(maxval(shear) / hertz%max_pressure - 0.310d0) < 2d-3, 'largest shear stress')
        szz => planes%field(STICKSLIP_STRESS_ZZ)
        call stress_at_points(bodies, STICKSLIP_BODY_1, &
            [stickslip_point(grid%dx / 2, grid%dy / 2, depth), stickslip_point(0, 0, depth)], at, pressure, 0 * pressure, &
            0 * pressure)
        call check(abs(szz(n / 2 + 1, n / 2 + 1) / at(1)%normal_stress(3) - 1) < 1d-9, 'szz')
        ! On the surface sxz = -qx and syz = -qy.
        call stress_at_points(bodies, STICKSLIP_BODY_1, [stickslip_point(grid%dx / 2, grid%dy / 2, 0)], at, pressure, pressure, &
            pressure / 2)
        associate (peak => pressure(n / 2 + 1, n / 2 + 1))
            call check(maxval(abs(at(1)%shear_stress(2:) / [peak, peak / 2] + 1)) < 1d-9, 'sxz and syz')
        end associate
        call planes%solve(2, STICKSLIP_BODY_1, pressure, status=status)
        call check(status == STICKSLIP_LENGTH, 'index without a depth')
        call planes%solve(1, STICKSLIP_BODY_1, pressure, pressure, status=status)
        call check(status == STICKSLIP_BAD_POINTER, 'traction along one axis only')
        call planes%solve(1, STICKSLIP_BODY_1, pressure, pressure(:, 2:), pressure, status=status)
        call check(status == STICKSLIP_LENGTH, 'traction of the wrong size')
    end subroutine below_a_sphere

    subroutine rough()
        type(stickslip_grid) :: grid
        type(stickslip_self_affine) :: recipe
        type(stickslip_statistics) :: statistics
        real(c_double) :: heights(n, n)
        integer(c_int32_t) :: status

        grid = stickslip_grid(n, n, 1d0, 1d0)
        recipe%rms_slope = 0.1d0
        status = stickslip_surface_self_affine(grid, recipe, heights, size(heights, kind=c_size_t))
        call check(status == STICKSLIP_OK, 'self-affine surface')
        status = stickslip_surface_statistics(grid, heights, size(heights, kind=c_size_t), statistics)
        call check(status == STICKSLIP_OK .and. abs(statistics%spectral_rms_slope / 0.1d0 - 1) < 1d-9, 'rms slope')
        recipe%rms_height = 1
        status = stickslip_surface_self_affine(grid, recipe, heights, size(heights, kind=c_size_t))
        call check(status == STICKSLIP_INVALID_ARGUMENT, 'both height and slope given')
    end subroutine rough
end program stresses
