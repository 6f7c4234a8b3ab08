! Contacts of elastic half-spaces for Fortran 2008: types that free themselves. The module is based on stickslip_bindings
! and re-exports it.
!
! The procedure new creates an object. A cycle is created by begin, a saved state by keep, and a solution by the first
! solve into it. The object is freed at the end of its scope, or by free; this includes the elements of arrays and the
! components of types. Another call of new replaces the object. If new fails, the old object remains; this includes
! STICKSLIP_BUSY, which means that a thread is using the object. Objects cannot be assigned; a history has clone. Every
! procedure has an optional last argument status, which receives STICKSLIP_OK or the kind of failure. Without this
! argument, a failure stops the program with its message. stickslip_message returns the message of the last failure.
! Procedures for solves, stiffnesses and stresses have an optional argument observer before status. Fields are pointers
! into an object and remain valid until the object is changed or freed. Arrays have x first, field(ix, iy), and the
! shape (nx, ny) of the grid; any other shape gives STICKSLIP_LENGTH. Members of structs have default values:
! stickslip_load_step(x=stickslip_control(STICKSLIP_SHIFT, 1d-6)) holds everything else. Surfaces and closed-form
! solutions are called through stickslip_bindings, with the handles of objects: stickslip_hertz_sphere(bodies%handle,
! ...).
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
