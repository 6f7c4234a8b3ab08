! Contacts of elastic half-spaces for Fortran 2008: types that free themselves, on the interface of stickslip_bindings, which
! this module passes on.
!
! An object is made by its procedure new, and freed when it leaves its scope, or by free. A further new puts another in its
! place; one that fails leaves it, as does STICKSLIP_BUSY, where a thread uses it. An object cannot be assigned. Every
! procedure has an optional last argument status, STICKSLIP_OK or the kind of failure; without it a failure stops the program
! with its message. Fields are pointers to what the object holds: valid until the object is changed or freed. Fields
! have x first: field(ix, iy). Adaptive steps, coupled problems, surfaces and closed forms
! are called through stickslip_bindings.
module stickslip
    use, intrinsic :: iso_c_binding
    use stickslip_bindings
    use stickslip_objects, only: stickslip_object, half_space, stickslip_message, stickslip_version_text
    use stickslip_contacts
    use stickslip_histories
    use stickslip_stresses
    implicit none
    public
end module stickslip
