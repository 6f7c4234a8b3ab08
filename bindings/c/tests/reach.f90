! Fortran interface apart from loads and fields. Shapes are checked, and types have the defaults of the library. Zones,
! warnings, reports, copies, settings, bulk strain, wear, spots and jumps agree with the library.
program reach
    use, intrinsic :: ieee_arithmetic, only: ieee_value, ieee_positive_inf
    use stickslip
    implicit none
    integer(c_size_t), parameter :: nx = 24, ny = 20
    real(c_double), parameter :: side = 0.02d0, radius = 5
    type(stickslip_material), parameter :: steel = stickslip_material(210d3, 0.3d0)
    type(stickslip_grid), parameter :: grid = stickslip_grid(nx, ny, side, side)
    logical :: good = .true.

    call defaults()
    call shapes()
    call contacts()
    call rolling()
    call rolled_steps()
    call dissimilar()
    call histories()
    if (.not. good) error stop 1

contains

    subroutine check(condition, what)
        logical, intent(in) :: condition
        character(len=*), intent(in) :: what
        if (.not. condition) print '(a)', what
        good = good .and. condition
    end subroutine check

    function ball() result(gap)
        real(c_double) :: gap(nx, ny)
        if (stickslip_surface_sphere(grid, radius, gap, size(gap, kind=c_size_t)) /= STICKSLIP_OK) error stop 1
    end function ball

    function press(force) result(load)
        real(c_double), intent(in) :: force
        type(stickslip_load_step) :: load
        load = stickslip_load_step(normal=stickslip_normal_load(STICKSLIP_FORCE, force))
    end function press

    function drag(shift) result(load)
        real(c_double), intent(in) :: shift
        type(stickslip_load_step) :: load
        load = stickslip_load_step(x=stickslip_control(STICKSLIP_SHIFT, shift))
    end function drag

    ! Defaults must agree bit for bit, except in the padding between members.
    subroutine defaults()
        type(stickslip_settings) :: settings
        type(stickslip_history_options) :: history
        type(stickslip_tangential_options) :: tangential
        type(stickslip_rolling_options) :: rolling
        type(stickslip_self_affine) :: surface
        type(stickslip_jump_limits) :: limits
        type(stickslip_stiffness_options) :: stiffness
        integer(c_int8_t), parameter :: mold(1) = 0
        associate (other => stickslip_settings_default())
            call check(settings%method == other%method .and. settings%tolerance == other%tolerance .and. &
                settings%max_iterations == other%max_iterations .and. settings%time_limit == other%time_limit, 'settings')
        end associate
        call check(all(transfer(stiffness, mold) == transfer(stickslip_stiffness_options_default(), mold)), 'stiffness')
        call check(all(transfer(limits, mold) == transfer(stickslip_jump_limits_default(), mold)), 'limits of jumps')
        associate (other => stickslip_history_options_default())
            call check(all([history%axis, history%model, history%coupling, history%entry_rule, history%permanent_set] == &
                [other%axis, other%model, other%coupling, other%entry_rule, other%permanent_set]), 'options of histories')
        end associate
        associate (other => stickslip_tangential_options_default())
            call check(all([tangential%model, tangential%coupling] == [other%model, other%coupling]), 'options')
        end associate
        associate (other => stickslip_rolling_options_default())
            call check(all([rolling%leading_edge, rolling%entry_rule] == [other%leading_edge, other%entry_rule]) .and. &
                rolling%step == other%step, 'options of rolling')
        end associate
        call check(all(transfer(surface, mold) == transfer(stickslip_self_affine_default(), mold)), 'surface')
        associate (none => stickslip_friction(coefficient=stickslip_per_cell(0.5d0)), other => stickslip_coulomb(0.5d0))
            call check(none%coefficient%value == other%coefficient%value .and. &
                none%max_shear_stress == other%max_shear_stress, 'friction')
        end associate
    end subroutine defaults

    subroutine shapes()
        type(half_space) :: bodies
        type(normal_solver) :: presser
        type(normal_solution) :: pressed
        type(contact_history) :: history
        type(stress_planes) :: planes
        type(stickslip_per_cell) :: hardness
        real(c_double), target :: gap(nx, ny), turned(ny, nx)
        integer(c_int32_t) :: status
        gap = ball()
        turned = transpose(gap)
        call bodies%new(grid, steel, steel)
        ! The number of cells agrees, but the shape does not.
        call presser%new(bodies, turned, stickslip_normal_load(STICKSLIP_FORCE, 100), status=status)
        call check(status == STICKSLIP_LENGTH, 'a gap of shape (ny, nx)')
        call presser%new(bodies, gap, stickslip_normal_load(STICKSLIP_FORCE, 100))
        call presser%set_gap(turned, status)
        call check(status == STICKSLIP_LENGTH, 'new gap of shape (ny, nx)')
        call presser%solve(pressed)
        call check(all(shape(pressed%field(STICKSLIP_PRESSURE)) == [nx, ny]), 'shape of a field')
        call history%new(bodies, turned, stickslip_coulomb(0.5d0), status=status)
        call check(status == STICKSLIP_LENGTH .and. .not. c_associated(history%address()), 'a history of shape (ny, nx)')
        call history%new(bodies, gap, stickslip_coulomb(0.5d0))
        call history%set_gap(reshape(gap, [int(nx * ny), 1]), status)
        call check(status == STICKSLIP_LENGTH, 'a gap of shape (nx ny, 1)')
        call history%wear_archard(1d-9, turned, status)
        call check(status == STICKSLIP_LENGTH, 'a depth of shape (ny, nx)')
        call planes%new(bodies, [0.01d0])
        call planes%solve(1, STICKSLIP_BODY_1, turned, status=status)
        call check(status == STICKSLIP_LENGTH, 'a pressure of shape (ny, nx)')
        call planes%solve(1, STICKSLIP_BODY_1, gap, gap, turned, status=status)
        call check(status == STICKSLIP_LENGTH, 'a traction of shape (ny, nx)')
        hardness = per_cell(turned, grid, status)
        call check(status == STICKSLIP_LENGTH, 'a hardness of shape (ny, nx)')
        call check(stickslip_message() == 'the quantity per cell has the shape (20, 24), expected the shape of the grid (24, 20)', &
            'message of a shape')
        call presser%new(bodies, gap, stickslip_normal_load(STICKSLIP_FORCE, 100), hardness=hardness, status=status)
        call check(status == STICKSLIP_BAD_POINTER, 'use of a hardness of the wrong shape')
        call check(index(stickslip_message(), 'the member cells of the hardness is NULL') == 1, 'message of C after a shape')
        call planes%solve(0, STICKSLIP_BODY_1, gap, status=status)
        call check(stickslip_message() == 'the index must be at least 1', 'message of an index')
        status = stickslip_surface_sphere(grid, -1d0, gap, size(gap, kind=c_size_t))
        call check(status == STICKSLIP_NOT_POSITIVE .and. index(stickslip_message(), 'radius') > 0, 'message of C')
        hardness = per_cell(gap, grid, status)
        call check(status == STICKSLIP_OK .and. c_associated(hardness%cells), 'a hardness of the right shape')
    end subroutine shapes

    subroutine contacts()
        type(half_space) :: bodies
        type(normal_solver) :: presser
        type(normal_solution) :: pressed
        type(tangential_solver) :: shearer
        type(tangential_solution) :: sheared
        type(stickslip_warning), allocatable :: warnings(:)
        type(stickslip_spot), allocatable :: spots(:)
        type(stickslip_edges) :: edges
        real(c_double), allocatable :: centres(:, :), means(:, :)
        type(stickslip_normal_result) :: normal
        type(stickslip_tangential_result) :: shear
        type(stickslip_report) :: report
        type(stickslip_normal_stiffness) :: slope
        real(c_double), target :: mu(nx, ny)
        real(c_double) :: gap(nx, ny), stretched(nx, ny), across(nx, ny)
        real(c_double), pointer :: pressure(:, :)
        integer(c_int8_t), pointer :: zones(:, :)
        integer(c_int32_t), allocatable :: labels(:, :)
        integer(c_int32_t) :: status
        integer :: i
        real(c_double) :: capacity

        gap = ball()
        call bodies%new(grid, steel, steel)
        call bodies%set_cell_value(STICKSLIP_CENTRE)
        call check(bodies%cell_value() == STICKSLIP_CENTRE .and. bodies%first_row() == 0, 'value of a cell and first row')
        call bodies%set_cell_value(STICKSLIP_UNIFORM)
        call presser%new(bodies, gap, stickslip_normal_load(STICKSLIP_FORCE, 100), settings=stickslip_settings(tolerance=1d-6))
        call presser%solve(pressed)
        report = pressed%report()
        call check(report%status == STICKSLIP_CONVERGED .and. report%residual > 1d-12, 'a report')
        call check(report%eigenvalue_bound == STICKSLIP_EIGENVALUE_PROVEN, 'proven eigenvalue bound')
        call presser%set_settings(stickslip_settings(tolerance=1d-12))
        call presser%solve(pressed)
        report = pressed%report()
        call check(report%residual <= 1d-12, 'settings')
        normal = pressed%result()
        slope = pressed%stiffness(bodies)
        ! The derivative of the force of a Hertz contact is 3/2 of its secant.
        call check(abs(slope%value * normal%approach / normal%force / 1.5d0 - 1) < 0.02d0, 'stiffness')
        pressure => pressed%field(STICKSLIP_PRESSURE)
        call pressed%spots(spots, labels)
        call check(size(spots) == 1 .and. spots(1)%cells == normal%contact_cells, 'one spot')
        call check(abs(spots(1)%load / 100 - 1) < 1d-9 .and. spots(1)%stick_ratio /= spots(1)%stick_ratio, 'load of the spot')
        call check(all((labels == 1) .eqv. (pressure > 0)) .and. all(labels >= 0 .and. labels <= 1), 'cells of the spot')
        call pressed%edges(edges, centres)
        call check(edges%unfitted_fraction < 1 .and. abs(edges%contact_area / normal%contact_area - 1) < 0.05d0 .and. &
            abs(maxval(centres) - edges%peak_pressure) <= 0, 'edge of the contact')
        call check(pressed%discretisation_estimate() > 0, 'error estimate of the pressure')
        call pressed%warnings(warnings)
        call check(size(warnings) == 0, 'no warning')

        ! The coefficient is doubled in half of the cells.
        mu = 0.3d0
        mu(:, ny / 2 + 1:) = 0.6d0
        call shearer%new(bodies, pressed, stickslip_friction(per_cell(mu, grid)), &
            stickslip_tangential_load(x=stickslip_control(STICKSLIP_FORCE, 20)))
        capacity = shearer%friction_capacity()
        call check(abs(capacity / 45 - 1) < 1d-6, 'friction for each cell')
        call shearer%solve(sheared)
        shear = sheared%result()
        zones => sheared%zones()
        call check(count(zones == STICKSLIP_STICK) > 0 .and. &
            all((zones == STICKSLIP_SEPARATED) .eqv. (pressure <= 0)), 'zones')
        call check(abs(count(zones == STICKSLIP_STICK) / real(count(pressure > 0), c_double) - shear%stick_ratio) < 1d-12, &
            'stick ratio')
        call sheared%edges(pressed, stickslip_friction(per_cell(mu, grid)), edges, means=means)
        call check(abs(edges%stick_ratio - shear%stick_ratio) < 0.05d0 .and. &
            abs(sum(means) * grid%dx * grid%dy / 20 - 1) < 0.02d0, 'the edges of the zones')
        call check(sheared%discretisation_estimate() > 0, 'error estimate of the traction')
        call sheared%spots(pressed, spots)
        call check(abs(spots(1)%stick_ratio - shear%stick_ratio) < 1d-12, 'stick ratio of the spot')

        ! Bulk strain alone causes no force, but makes cells slip.
        call bodies%bulk_strain(1d-3, 0d0, 0d0, stretched, across)
        do i = 1, int(nx)
            call check(all(abs(stretched(i, :) - 1d-3 * side * (i - 0.5d0 * (nx + 1))) < 1d-15), 'displacement of a strain')
        end do
        call bodies%bulk_strain(1d-3, 0d0, 0d0, stretched, across(2:, :), status)
        call check(status == STICKSLIP_LENGTH, 'array of another shape')
        call shearer%set_load(stickslip_tangential_load(x=stickslip_control(STICKSLIP_FORCE, 0)))
        call shearer%set_relative_displacement(stretched, across)
        call shearer%solve(sheared)
        shear = sheared%result()
        call check(abs(shear%force(1)) < 1d-6 .and. shear%stick_ratio < 1, 'bulk strain')

        ! The contact is larger than the grid.
        call presser%set_load(stickslip_normal_load(STICKSLIP_FORCE, 4d4))
        call presser%solve(pressed)
        call pressed%warnings(warnings)
        call check(any(warnings%kind == STICKSLIP_WARNING_CONTACT_AT_EDGE), 'a warning')
        if (size(warnings) > 0) call check(index(warning_text(warnings(1)), 'edge') > 0, 'text of the warning')
        call presser%reset()
        call presser%set_load(stickslip_normal_load(STICKSLIP_HOLD), status)
        if (status == STICKSLIP_OK) call presser%solve(pressed, status=status)
        call check(status == STICKSLIP_NO_PRESSURE_TO_HOLD, 'hold after reset is an error')
    end subroutine contacts

    ! Rolling ball with prescribed creepages and with prescribed loads, and Carter's cylinder.
    subroutine rolling()
        type(half_space) :: bodies
        type(normal_solver) :: presser
        type(normal_solution) :: pressed, lighter
        type(rolling_solver) :: roller
        type(rolling_solution) :: rolled
        type(stickslip_normal_result) :: normal
        type(stickslip_hertz) :: hertz
        type(stickslip_carter) :: carter
        type(stickslip_kalker) :: kalker
        type(stickslip_vermeulen_johnson) :: curve
        type(stickslip_bentall_johnson) :: free_rolling
        type(stickslip_report) :: report
        type(stickslip_rolling_stiffness) :: stiffness
        type(stickslip_rolling_result) :: by_motion, by_load
        type(stickslip_creep_point) :: points(3)
        type(stickslip_creep_force), allocatable :: forces(:)
        type(c_ptr) :: before
        type(stickslip_warning), allocatable :: remarks(:)
        real(c_double) :: lost(nx, ny), turned(ny, nx), unit, capacity
        real(c_double), pointer :: traction(:, :)
        integer(c_int8_t), pointer :: zones(:, :)
        integer(c_int32_t) :: status
        call bodies%new(grid, steel, steel)
        status = stickslip_carter_cylinder(bodies%handle, 10d0, 100d0, 0.3d0, 0d0, carter)
        unit = carter%sliding_creepage
        if (status == STICKSLIP_OK) status = stickslip_carter_cylinder(bodies%handle, 10d0, 100d0, 0.3d0, -0.4d0 * unit, &
            carter)
        call check(status == STICKSLIP_OK .and. abs(carter%force + 0.64d0 * 30) < 1d-10, "Carter's force")

        call presser%new(bodies, ball(), stickslip_normal_load(STICKSLIP_FORCE, 100))
        call presser%solve(pressed)
        call roller%new(bodies, pressed, stickslip_coulomb(0.3d0))
        stiffness = roller%stiffness()
        status = stickslip_hertz_sphere(bodies%handle, radius, 100d0, hertz)
        unit = steel%youngs_modulus / (2 + 2 * steel%poisson_ratio) * hertz%contact_radius**2
        call check(abs(stiffness%slopes(1, 1) / unit / 4.31d0 - 1) < 0.03d0, 'coefficient C11 of Kalker')
        ! These entries are the lateral force due to the spin, and the moment due to the lateral creepage.
        call check(stiffness%slopes(3, 2) * stiffness%slopes(2, 3) < 0, 'forces under spin')

        call roller%set_load(stickslip_rolling_load(x=stickslip_rolling_control(STICKSLIP_CREEPAGE, 1d-3), &
            spin=stickslip_rolling_control(STICKSLIP_SPIN, 1d-3)))
        call roller%solve(rolled)
        by_motion = rolled%result()
        report = rolled%report()
        call check(report%status == STICKSLIP_CONVERGED .and. abs(by_motion%spin - 1d-3) <= 0, 'rolling by creepage')
        call roller%set_load(stickslip_rolling_load(stickslip_rolling_control(STICKSLIP_FORCE, by_motion%force(1)), &
            spin=stickslip_rolling_control(STICKSLIP_MOMENT, by_motion%moment)))
        call roller%solve(rolled)
        by_load = rolled%result()
        call check(abs(by_load%force(1) / by_motion%force(1) - 1) < 1d-8, 'rolling by force')
        call check(abs(by_load%creepage(1) / 1d-3 - 1) < 1d-4 .and. abs(by_load%spin / 1d-3 - 1) < 1d-4, 'motion under loads')
        zones => rolled%zones()
        traction => rolled%field(STICKSLIP_TRACTION_X)
        call rolled%dissipation_per_area(lost)
        call check(all((lost > 0) .eqv. (lost > 0 .and. zones == STICKSLIP_SLIP)) .and. maxval(lost) > 0, 'dissipation')
        call check(abs(sum(traction) * grid%dx * grid%dy / by_load%force(1) - 1) < 1d-12, 'sum of the traction')
        call rolled%dissipation_per_area(turned, status)
        call check(status == STICKSLIP_LENGTH, 'a dissipation of shape (ny, nx)')

        points(2)%creepage(1) = 1d-3
        points(3)%creepage(1) = 1d-1
        call roller%creep_forces(points, forces)
        call check(size(forces) == 3 .and. abs(forces(1)%force(1)) <= 0 .and. abs(forces(3)%force(1) / 30 - 1) < 1d-3, &
            'a creep curve')
        call roller%creep_warnings(remarks)
        call check(size(remarks) == 1, 'warning of a creepage of 10 per cent')
        if (size(remarks) == 1) call check(remarks(1)%kind == STICKSLIP_WARNING_LARGE_CREEPAGE, 'kind of this warning')
        call roller%set_load(stickslip_rolling_load(x=stickslip_rolling_control(STICKSLIP_FORCE, 31)), status)
        call check(status == STICKSLIP_BEYOND_FRICTION_CAPACITY, 'force above the friction capacity')
        before = roller%address()
        call roller%new(bodies, pressed, stickslip_coulomb(0.3d0), options=stickslip_rolling_options(step=0), status=status)
        call check(status == STICKSLIP_NOT_POSITIVE .and. c_associated(roller%address(), before), 'rolling solver is kept')
        call roller%set_settings(stickslip_settings(method=STICKSLIP_POLONSKY_KEER), status)
        call check(status == STICKSLIP_METHOD, 'method for one traction')

        call roller%set_friction(stickslip_coulomb(0.6d0))
        call roller%set_load(stickslip_rolling_load(x=stickslip_rolling_control(STICKSLIP_FORCE, 31)))
        call roller%solve(rolled)
        call roller%set_normal_solver(presser)
        call presser%solve(lighter)
        call roller%normal(lighter, status)
        call check(status == STICKSLIP_OUTDATED_SOLUTION, 'normal contact before a new load')
        call roller%set_normal_load(stickslip_normal_load(STICKSLIP_FORCE, 90))
        call roller%normal(lighter)
        normal = lighter%result()
        call check(abs(normal%force / 90 - 1) < 1d-8, 'normal contact of a rolling solver')
        capacity = roller%friction_capacity()
        call check(abs(capacity - 54) < 1d-6, 'friction capacity under a new load')
        call roller%solve(rolled)
        call rolled%warnings(remarks)
        call check(size(remarks) >= 0, 'warnings of rolling')
        traction => pressed%field(STICKSLIP_PRESSURE)
        call roller%set_pressure(traction, status)
        call check(status == STICKSLIP_UNSUPPORTED_BY_MODEL, 'pressure without a gap')
        call roller%set_normal(pressed)
        call roller%reset()
        stiffness = roller%stiffness()
        status = stickslip_kalker_coefficients(1d0, steel%poisson_ratio, kalker)
        call check(abs(stiffness%slopes(1, 1) / unit / kalker%c11 - 1) < 0.02d0, 'coefficient C11 of the table')
        status = stickslip_vermeulen_johnson_ellipse(bodies%handle, radius, radius, 100d0, 0.3d0, 0d0, 1d0, curve)
        call check(status == STICKSLIP_OK .and. abs(curve%force(2) / 30 - 1) < 1d-12, 'force of Vermeulen and Johnson')
        status = stickslip_bentall_johnson_cylinder(bodies%handle, 10d0, 100d0, 0.01d0, free_rolling)
        call check(status == STICKSLIP_OK .and. abs(free_rolling%creepage) <= 0, 'creepage of Bentall and Johnson')
    end subroutine rolling

    ! History whose bodies roll in each step.
    subroutine rolled_steps()
        type(half_space) :: bodies
        type(contact_history) :: history
        type(stickslip_step_result) :: once, again
        integer(c_int32_t) :: status
        call bodies%new(grid, steel, steel)
        call history%new(bodies, ball(), stickslip_coulomb(0.3d0), stickslip_history_options(model=STICKSLIP_VECTOR))
        call history%step(stickslip_load_step(stickslip_normal_load(STICKSLIP_FORCE, 100)))
        call history%step(stickslip_load_step(roll=stickslip_roll(1, creepage=[1d-4, 0d0])))
        once = history%result()
        call history%step(stickslip_load_step(roll=stickslip_roll(1, creepage=[1d-4, 0d0])))
        again = history%result()
        call check(once%force(1) > 0 .and. again%force(1) > once%force(1), 'force grows during rolling')
        call check(abs(again%creepage(1) - 1d-4) <= 0, 'creepage of a step')
        call history%step(stickslip_load_step(x=stickslip_control(STICKSLIP_FORCE, once%force(1)), roll=stickslip_roll(1)))
        again = history%result()
        call check(abs(again%force(1) / once%force(1) - 1) < 1d-8 .and. again%creepage(1) < 1d-4, 'creepage due to a force')
        call history%step(stickslip_load_step(roll=stickslip_roll(0, spin=1d0)), status=status)
        call check(status == STICKSLIP_NOT_POSITIVE, 'spin without cells')
        once = history%result()
        call history%step(stickslip_load_step(y=stickslip_control(STICKSLIP_FORCE, 2), &
            roll=stickslip_roll(2, STICKSLIP_MINUS_Y, [1d-4, 0d0], 1d-3)))
        again = history%result()
        call check(abs(again%force(2) / 2 - 1) < 1d-8 .and. abs(again%creepage(1) - 1d-4) <= 0, 'force and creepage')
        call check(abs((again%twist - once%twist) / (2 * side * 1d-3) - 1) < 1d-12, 'spin over two cells')
        call check(abs((again%shift(1) - once%shift(1)) / (2 * side * 1d-4) - 1) < 1d-9, 'travel of two cells')
    end subroutine rolled_steps

    ! Coupled pressure and traction.
    subroutine dissimilar()
        type(half_space) :: bodies
        type(coupled_solver) :: solver
        type(coupled_solution) :: solution, other
        type(contact_history) :: history
        type(stickslip_stiffness) :: slope, same
        type(stiffness_workspace) :: workspace
        type(coupled_rolling_solver) :: roller
        type(coupled_rolling_solution) :: rolled
        type(stickslip_rolling_result) :: first, second
        type(stickslip_rolling_stiffness) :: slopes
        type(stickslip_report) :: work
        type(stickslip_coupled_report) :: report
        type(stickslip_normal_result) :: normal
        type(stickslip_tangential_result) :: shear
        type(stickslip_warning), allocatable :: warnings(:)
        type(stickslip_normal_load) :: press
        type(stickslip_tangential_load) :: still, drag
        type(c_ptr) :: before
        real(c_double), target :: stretched(nx, ny), none(nx, ny)
        real(c_double), pointer :: pressure(:, :), x(:, :), y(:, :), gap(:, :), lift(:, :), alike(:, :)
        integer(c_int8_t), pointer :: zones(:, :)
        real(c_double) :: heights(nx, ny), force, of_pressure, of_traction
        type(stickslip_edges) :: edges, alone
        real(c_double), allocatable :: centres(:, :), means(:, :)
        integer(c_int32_t) :: status
        integer :: i

        heights = ball()
        press = stickslip_normal_load(STICKSLIP_FORCE, 100)
        still = stickslip_tangential_load(x=stickslip_control(STICKSLIP_FORCE, 0), y=stickslip_control(STICKSLIP_FORCE, 0))
        drag = stickslip_tangential_load(x=stickslip_control(STICKSLIP_FORCE, 20), y=stickslip_control(STICKSLIP_FORCE, 0))
        call bodies%new(grid, steel, stickslip_material(ieee_value(0d0, ieee_positive_inf), 0))
        call solver%new(bodies, heights, stickslip_coulomb(0.3d0), press, still)
        call solver%solve(solution)
        report = solution%report()
        call check(report%work%status == STICKSLIP_CONVERGED, 'a coupled report')
        call solution%results(normal, shear)
        call check(abs(normal%force / 100 - 1) < 1d-6, 'the normal force')
        call check(shear%stick_ratio > 0 .and. shear%stick_ratio < 1, 'dissimilar bodies slip when pressed')
        call solution%warnings(warnings)
        call check(any(warnings%kind == STICKSLIP_WARNING_SINGLE_LOAD_STEP), 'warning about one pressing step')

        ! The fields and the zones satisfy Coulomb's law, and the sums of the fields are the forces.
        call solver%set_loads(press, drag)
        call solver%solve(solution)
        call solution%results(tangential=shear)
        pressure => solution%field(STICKSLIP_PRESSURE)
        x => solution%field(STICKSLIP_TRACTION_X)
        y => solution%field(STICKSLIP_TRACTION_Y)
        gap => solution%field(STICKSLIP_GAP)
        lift => solution%field(STICKSLIP_DISPLACEMENT_Z)
        zones => solution%zones()
        force = sum(x) * side**2
        call check(abs(force / 20 - 1) < 1d-6 .and. abs(force / shear%force(1) - 1) < 1d-12, 'tangential force')
        call check(all(hypot(x, y) <= 0.3d0 * pressure * (1 + 1d-9)), "Coulomb's law")
        call check(all((zones == STICKSLIP_SEPARATED) .eqv. (pressure <= 0)), 'coupled zones')
        call check(all(pressure == 0 .or. abs(gap) < 1d-6 * maxval(lift)), 'zero gap in contact cells')
        call solution%edges(stickslip_coulomb(0.3d0), edges, centres, means)
        call solution%pressure_edges(alone, status=status)
        call check(status == STICKSLIP_OK .and. abs(edges%contact_area - alone%contact_area) <= 0 .and. &
            abs(maxval(centres) - edges%peak_traction) <= 0 .and. all(means >= 0), 'edges of a coupled contact')
        call solution%discretisation_estimates(of_pressure, of_traction)
        call check(of_pressure > 0 .and. of_traction > 0, 'error estimates of a coupled contact')

        ! A history with the same first step has the same stiffness.
        call history%new(bodies, heights, stickslip_coulomb(0.3d0), &
            stickslip_history_options(model=STICKSLIP_VECTOR, entry_rule=STICKSLIP_WHOLE_STEP))
        call history%step(stickslip_load_step(press, drag%x, drag%y))
        slope = solution%stiffness(bodies, stickslip_coulomb(0.3d0))
        same = history%stiffness()
        call check(abs(slope%normal%value / same%normal%value - 1) < 1d-6, 'a coupled stiffness')
        call check(abs(slope%tangential%loading(1, 1) / same%tangential%loading(1, 1) - 1) < 1d-6, 'coupled stiffness along x')

        ! A workspace gives the same stiffness, also after a change of its options.
        call workspace%new()
        slope = history%stiffness_with(workspace)
        call check(slope%normal%value == same%normal%value, 'stiffness with a workspace')
        work = workspace%report()
        call check(work%status == STICKSLIP_CONVERGED, 'report of the stiffness')
        call workspace%set_options(stickslip_stiffness_options(reversal=0, next_step=1))
        slope = history%stiffness_with(workspace)
        same = history%next_stiffness()
        call check(slope%tangential%loading(1, 1) == same%tangential%loading(1, 1), 'stiffness of the next step')
        call check(slope%tangential%reversal(1, 1) /= slope%tangential%reversal(1, 1), 'no stiffness at reversal')
        call workspace%new(stickslip_stiffness_options(tolerance=0), status)
        call check(status == STICKSLIP_TOLERANCE .and. c_associated(workspace%address()), 'workspace is kept')

        ! Setters of the coupled solver.
        call solver%set_loads(stickslip_normal_load(STICKSLIP_FORCE, 150), drag)
        call solver%set_gap(2 * heights)
        call solver%set_friction(stickslip_coulomb(0.6d0))
        call solver%set_settings(stickslip_settings(tolerance=1d-9))
        call solver%solve(solution)
        report = solution%report()
        call check(report%work%residual <= 1d-9, 'settings of a coupled solver')
        call solver%new(bodies, 2 * heights, stickslip_coulomb(0.6d0), stickslip_normal_load(STICKSLIP_FORCE, 150), drag, &
            settings=stickslip_settings(tolerance=1d-9))
        call solver%solve(other)
        alike => other%field(STICKSLIP_PRESSURE)
        call check(maxval(abs(alike - pressure)) < 1d-6 * maxval(alike), 'setters agree with a new solver')
        call solver%reset()
        call solver%set_loads(stickslip_normal_load(STICKSLIP_HOLD), drag, status)
        if (status == STICKSLIP_OK) call solver%solve(other, status=status)
        call check(status == STICKSLIP_NO_PRESSURE_TO_HOLD, 'hold after reset is an error')

        ! Bulk strain displaces the stick zone.
        none = 0
        do i = 1, int(nx)
            stretched(i, :) = 1d-3 * side * (i - 0.5d0 * (nx + 1))
        end do
        call solver%new(bodies, heights, stickslip_coulomb(0.3d0), press, drag, &
            relative=stickslip_relative_displacement(c_loc(stretched), c_loc(none), size(none, kind=c_size_t)))
        call solver%solve(other)
        call other%results(tangential=shear)
        call check(abs(shear%force(1) / 20 - 1) < 1d-6 .and. shear%stick_ratio < 1, 'bulk strain of coupled bodies')

        ! Rolling: the stiffness predicts the force at a slightly larger creepage.
        call roller%new(bodies, heights, stickslip_coulomb(0.3d0), press, &
            stickslip_rolling_load(x=stickslip_rolling_control(STICKSLIP_CREEPAGE, 1d-3)))
        call roller%solve(rolled)
        call rolled%results(normal, first)
        call rolled%warnings(warnings)
        call check(abs(normal%force / 100 - 1) < 1d-6 .and. all(warnings%kind /= STICKSLIP_WARNING_NO_CONTACT), &
            'coupled rolling')
        zones => rolled%zones()
        call check(all(shape(zones) == [nx, ny]), 'zones of coupled rolling')
        slopes = roller%stiffness()
        call roller%set_load(stickslip_rolling_load(x=stickslip_rolling_control(STICKSLIP_CREEPAGE, 1.001d-3)))
        call roller%solve(rolled)
        call rolled%results(rolling=second)
        call check(abs((second%force(1) - first%force(1)) / (1d-6 * slopes%slopes(1, 1)) - 1) < 0.02d0, &
            'stiffness of coupled rolling')

        ! An object remains if its replacement cannot be created.
        before = solver%address()
        call solver%new(bodies, heights(:, 2:), stickslip_coulomb(0.3d0), press, drag, status=status)
        call check(status == STICKSLIP_LENGTH .and. c_associated(solver%address(), before), 'coupled solver is kept')
        call solver%set_gap(heights(2:, :), status)
        call check(status == STICKSLIP_LENGTH, 'shape of a gap')
        call solver%new(bodies, heights, stickslip_coulomb(-1d0), press, drag, status=status)
        call check(status /= STICKSLIP_OK .and. c_associated(solver%address(), before), 'negative friction is an error')
        call solution%free()
        call check(.not. c_associated(solution%address()), 'freed coupled solution')
        pressure => solution%field(STICKSLIP_PRESSURE, status)
        call check(status == STICKSLIP_BAD_POINTER .and. .not. associated(pressure), 'field of a freed solution')
    end subroutine dissimilar

    subroutine histories()
        type(half_space) :: bodies
        type(contact_history) :: history, copy
        type(contact_cycle) :: cycle
        type(adaptive_steps) :: steps
        type(stickslip_history_options) :: options
        type(stickslip_step_result) :: now, then
        type(stickslip_report) :: normal, tangential
        type(stickslip_warning), allocatable :: warnings(:)
        type(stickslip_spot), allocatable :: spots(:)
        type(stickslip_cycle_result) :: loop
        real(c_double) :: gap(nx, ny), depth(nx, ny), amplitude, jump, cycles
        real(c_double), target :: k(nx, ny)
        real(c_double), allocatable :: worn(:, :)
        real(c_double), pointer :: slip(:, :), pressure(:, :)
        integer(c_int8_t), pointer :: zones(:, :)
        integer(c_size_t) :: taken
        integer(c_int32_t) :: status
        integer :: quarter, turn

        gap = ball()
        call bodies%new(grid, steel, steel)
        options%settings%tolerance = 1d-9
        call history%new(bodies, gap, stickslip_coulomb(0.3d0), options)
        call history%step(press(100d0))
        call history%reports(normal, tangential)
        call check(normal%status == STICKSLIP_CONVERGED, 'report of the pressure')
        then = history%result()
        amplitude = 0.2d0 * then%approach

        ! A copy takes the same step with bitwise identical results, and the original history does not change.
        call history%clone(copy)
        call copy%step(drag(amplitude))
        now = history%result()
        call check(now%steps == then%steps, 'original history is unchanged')
        call history%step(drag(amplitude))
        now = history%result()
        then = copy%result()
        call check(now%force(1) == then%force(1) .and. now%force(1) > 0, 'force of the copy')
        call history%reports(normal, tangential)
        call check(normal%status == STICKSLIP_UNSOLVED .and. tangential%status == STICKSLIP_CONVERGED, 'reports')
        zones => history%zones()
        pressure => history%field(STICKSLIP_PRESSURE)
        call check(count(zones == STICKSLIP_SLIP) > 0 .and. count(zones /= STICKSLIP_SEPARATED) == count(pressure > 0), 'zones')
        call history%warnings(warnings)
        call check(size(warnings) == 0, 'no warning')
        call history%spots(spots)
        call check(size(spots) == 1 .and. abs(spots(1)%stick_ratio - now%stick_ratio) < 1d-12, 'a spot')
        call history%set_settings(stickslip_settings(tolerance=2d0), status)
        call check(status == STICKSLIP_TOLERANCE, 'settings')
        call check(abs(history%friction_capacity() / 30 - 1) < 1d-6, 'capacity')

        ! Archard's law: coefficient times pressure times slip, with one coefficient and with a coefficient for each cell.
        depth = 0
        call history%wear_archard(1d-6, depth)
        slip => history%field(STICKSLIP_STEP_SLIP_DISTANCE)
        call check(maxval(abs(depth - 1d-6 * pressure * slip)) <= 1d-15 * maxval(depth) .and. maxval(depth) > 0, 'Archard')
        k = 1d-6
        call history%wear_archard(k, depth)
        call check(maxval(abs(depth - 2d-6 * pressure * slip)) <= 1d-15 * maxval(depth), 'Archard for each cell')
        worn = depth
        call history%wear_energy(1d-6, worn)
        call check(all(worn >= depth), 'energy law')
        depth = 0
        call history%wear_threshold_energy(1d-6, 0d0, depth)
        worn = 0
        call history%wear_energy(1d-6, worn)
        call check(maxval(abs(depth - worn)) <= 1d-12 * maxval(worn) .and. maxval(worn) > 0, 'energy law without a threshold')
        call history%wear_threshold_energy(k, 1d9, depth)
        call check(maxval(abs(depth - worn)) <= 1d-12 * maxval(worn), 'energy below the threshold')

        ! A closed cycle may be skipped by a jump, but the first cycle may not.
        do turn = 1, 2
            call cycle%begin(copy)
            if (turn == 2) depth = 0
            do quarter = 1, 2
                call copy%step(drag(merge(-amplitude, amplitude, quarter == 1)))
                call cycle%add(copy)
                if (turn == 2) call copy%wear_archard(1d-6, depth)
            end do
        end do
        loop = cycle%result()
        jump = cycle%jump(bodies, depth, stickslip_jump_limits(largest_depth=0.5d0 * maxval(depth)))
        call check(abs(jump - 0.5d0) < 1d-12, 'half a cycle')
        jump = cycle%jump(bodies, depth)
        slip => cycle%field(STICKSLIP_SLIP_DISTANCE)
        status = stickslip_max_stable_cycles(bodies%handle, stickslip_per_cell(1d-6), slip, size(slip, kind=c_size_t), cycles)
        call check(status == STICKSLIP_OK .and. abs(cycles / jump - 2) < 1d-6, 'half of the stable number of cycles')
        jump = cycle%jump(bodies, depth, stickslip_jump_limits(max_residual=-1d0), status)
        call check(status == STICKSLIP_NEGATIVE_OR_NOT_FINITE, 'a negative limit')
        call check(loop%cyclic_residual < 0.25d0, 'a closed loop')

        ! Bulk strain alone makes cells slip.
        do quarter = 1, int(nx)
            worn(quarter, :) = 1d-3 * side * (quarter - 0.5d0 * (nx + 1))
        end do
        call history%clone(copy)
        call copy%set_relative_displacement(worn, 0 * worn)
        call copy%step(stickslip_load_step(has_relative_displacement=1, relative_displacement=1d0))
        now = copy%result()
        call check(now%energy%dissipated_energy_midpoint > 0 .and. now%stick_ratio < 1, 'bulk strain in a step')
        call copy%set_relative_displacement(worn, transpose(worn), status)
        call check(status == STICKSLIP_LENGTH, 'a pattern of shape (ny, nx)')

        call steps%new(history, 0.01d0)
        call steps%step(history, drag(0d0), taken)
        call check(taken >= 1, 'short steps')
    end subroutine histories
end program reach
