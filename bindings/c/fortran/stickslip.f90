! Contacts of elastic half-spaces for Fortran 2008: types that free themselves, on the interface of stickslip_bindings, which
! this module passes on.
!
! An object is made by its procedure new, and freed when it leaves its scope, or by free. A further new puts another in its
! place; one that fails leaves it, as does STICKSLIP_BUSY, where a thread uses it. An object cannot be assigned; a history has
! clone. Every procedure has an optional last argument status, STICKSLIP_OK or the kind of failure; without it a failure stops
! the program with its message. Solves, stiffnesses and stresses have an optional observer before it. Fields are pointers to
! what the object holds: valid until the object is changed or freed. Arrays have x first, field(ix, iy), and the shape (nx, ny)
! of the grid, else they are STICKSLIP_LENGTH. Structs begin with their defaults:
! stickslip_load_step(x=stickslip_control(STICKSLIP_SHIFT, 1d-6)) holds all else. Surfaces and closed forms are called through
! stickslip_bindings, with the handles of objects: stickslip_hertz_sphere(bodies%handle, ...).
module stickslip
    use, intrinsic :: iso_c_binding
    use stickslip_bindings
    use stickslip_objects, only: stickslip_object, half_space, stickslip_message, stickslip_version_text, per_cell, &
        warning_text
    use stickslip_normal
    use stickslip_tangential
    use stickslip_coupled
    use stickslip_rolling
    use stickslip_histories
    use stickslip_cycles
    use stickslip_stresses
    implicit none
    public
end module stickslip
