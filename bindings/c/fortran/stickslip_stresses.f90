! Stress and displacement below the surface.
module stickslip_stresses
    use, intrinsic :: iso_c_binding
    use stickslip_bindings
    use stickslip_objects
    implicit none
    private

    public :: stress_planes, stress_at_points

    ! Planes at chosen depths below each body; the fields are those of the last solved plane.
    type, extends(stickslip_object) :: stress_planes
        type(stickslip_planes) :: handle
        type(stickslip_grid) :: grid
    contains
        procedure :: new => planes_new
        procedure :: solve => planes_solve
        procedure :: field => planes_field
        procedure :: measure => planes_measure
        procedure :: address => planes_address
        procedure :: free => planes_free
        final :: planes_final
    end type stress_planes

contains

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

    ! Computes displacement and stress of STICKSLIP_BODY_1 or STICKSLIP_BODY_2 at points, one response for each point, under
    ! a pressure with optional tractions x and y. The body must not be coated.
    subroutine stress_at_points(bodies, body, points, responses, pressure, x, y, observer, status)
        class(half_space), intent(in) :: bodies
        integer(c_int32_t), intent(in) :: body
        type(stickslip_point), intent(in), contiguous :: points(:)
        type(stickslip_response), allocatable, intent(out) :: responses(:)
        real(c_double), intent(in), target, contiguous :: pressure(:, :)
        real(c_double), intent(in), target, contiguous, optional :: x(:, :), y(:, :)
        type(stickslip_observer), intent(in), optional :: observer
        integer(c_int32_t), intent(out), optional :: status
        allocate (responses(size(points)))
        if (.not. all_fit(bodies%grid, pressure, x, y, status)) return
        call report_status(stickslip_stress_at_points_observed(bodies%handle, body, tractions_of(pressure, x, y), points, &
            size(points, kind=c_size_t), observer, responses), status)
    end subroutine stress_at_points

    subroutine planes_new(this, bodies, depths, with_displacements, status)
        class(stress_planes), intent(inout) :: this
        class(half_space), intent(in) :: bodies
        real(c_double), intent(in), contiguous :: depths(:)
        logical, intent(in), optional :: with_displacements
        integer(c_int32_t), intent(out), optional :: status
        type(stickslip_planes) :: made
        integer(c_int32_t) :: code, asked, given_up
        asked = 0
        if (present(with_displacements)) asked = merge(1_c_int32_t, 0_c_int32_t, with_displacements)
        code = stickslip_planes_new(bodies%handle, depths, size(depths, kind=c_size_t), asked, made)
        if (code == STICKSLIP_OK) code = stickslip_planes_free(this%handle)
        if (code == STICKSLIP_OK) then
            this%handle = made
            this%grid = bodies%grid
        else
            given_up = stickslip_planes_free(made)
        end if
        call report_status(code, status)
    end subroutine planes_new

    ! Solves the plane at the depth with number index, counted from one, under a pressure with optional tractions x and y.
    ! Returns STICKSLIP_LENGTH if no depth has this number.
    subroutine planes_solve(this, index, body, pressure, x, y, observer, status)
        class(stress_planes), intent(in) :: this
        integer, intent(in) :: index
        integer(c_int32_t), intent(in) :: body
        real(c_double), intent(in), target, contiguous :: pressure(:, :)
        real(c_double), intent(in), target, contiguous, optional :: x(:, :), y(:, :)
        type(stickslip_observer), intent(in), optional :: observer
        integer(c_int32_t), intent(out), optional :: status
        if (index < 1) then
            call refuse(STICKSLIP_LENGTH, 'the index of a depth must be at least 1', status)
            return
        end if
        if (.not. all_fit(this%grid, pressure, x, y, status)) return
        call report_status(stickslip_planes_solve_observed(this%handle, int(index - 1, c_size_t), body, &
            tractions_of(pressure, x, y), observer), status)
    end subroutine planes_solve

    ! Returns STICKSLIP_STRESS_XX to STICKSLIP_STRESS_YZ, or a displacement.
    function planes_field(this, which, status) result(samples)
        class(stress_planes), intent(in) :: this
        integer(c_int32_t), intent(in) :: which
        integer(c_int32_t), intent(out), optional :: status
        real(c_double), pointer :: samples(:, :)
        type(c_ptr) :: first
        integer(c_size_t) :: count
        first = stickslip_planes_field(this%handle, which, count)
        samples => plane(first, count, this%grid, status)
    end function planes_field

    ! Returns STICKSLIP_VON_MISES, STICKSLIP_MAX_SHEAR or STICKSLIP_HYDROSTATIC of each cell.
    subroutine planes_measure(this, which, values, status)
        class(stress_planes), intent(in) :: this
        integer(c_int32_t), intent(in) :: which
        real(c_double), intent(inout), contiguous :: values(:, :)
        integer(c_int32_t), intent(out), optional :: status
        if (.not. fits('values', shape(values), this%grid, status)) return
        call report_status(stickslip_planes_measure(this%handle, which, values, size(values, kind=c_size_t)), status)
    end subroutine planes_measure

    function planes_address(this) result(address)
        class(stress_planes), intent(in) :: this
        type(c_ptr) :: address
        address = this%handle%address
    end function planes_address

    ! Frees the object unless another thread is using it.
    subroutine planes_free(this)
        class(stress_planes), intent(inout) :: this
        if (stickslip_planes_free(this%handle) == STICKSLIP_OK) this%handle = stickslip_planes()
    end subroutine planes_free

    subroutine planes_final(this)
        type(stress_planes), intent(inout) :: this
        call this%free()
    end subroutine planes_final
end module stickslip_stresses
