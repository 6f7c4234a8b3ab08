//! Stress and displacement on planes below the surface.

use stickslip_rs::subsurface::{Plane, Planes, Stress};
use stickslip_rs::{Field, Grid};

use crate::call::{Outcome, call, call_on};
use crate::error::Failure;
use crate::fields::*;
use crate::half_space::stickslip_half_space;
use crate::handle::{Handle, changing, free, give, opaque, reading};
use crate::observer::{stickslip_observer, watch};
use crate::pointer::{Place, cells_mut, entries, input, optional};
use crate::results::{put_warnings, stickslip_warning};
use crate::status::{STICKSLIP_INVALID_ARGUMENT, STICKSLIP_UNKNOWN_OPTION, stickslip_status};
use crate::stress::{body, stickslip_tractions};
use crate::text_fields::show;

/// Planes at chosen depths below each body, and the last solved plane. Fields are read without a copy and remain valid
/// until the next solve or until the planes are freed.
pub struct stickslip_planes(Handle<Solved>);

opaque!(stickslip_planes holds Solved, named "planes");

/// Planes and the last solved plane.
#[derive(Debug)]
pub struct Solved {
    own: Planes,
    grid: Grid,
    last: Option<Plane>,
}

impl Solved {
    fn last(&self) -> Outcome<&Plane> {
        let unsolved = || {
            Failure::new(
                STICKSLIP_INVALID_ARGUMENT,
                "no plane has been solved yet: solve one first".into(),
            )
        };
        self.last.as_ref().ok_or_else(unsolved)
    }
}

/// Creates planes at count depths (lengths, zero or positive, copied) below the surface of either body. In coated bodies
/// the planes may lie in the layers or below them. Displacements are also computed if with_displacements is nonzero. The
/// kernels of a depth are computed at the first solve at that depth and kept. They need 112 bytes for each cell (152 with
/// displacements), and in coated bodies 144 bytes (216 with displacements).
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_planes_new(
    half_space: *const stickslip_half_space,
    depths: *const f64,
    count: usize,
    with_displacements: i32,
    planes: *mut *mut stickslip_planes,
) -> stickslip_status {
    // SAFETY: the caller follows the rule for pointers.
    call_on(half_space, || unsafe {
        let place = Place::of_object("planes", planes)?;
        let (depths, bodies) = (entries("depths", depths, count)?, reading(half_space)?);
        let grid = bodies.grid();
        let mut own = Planes::new(&bodies, depths)?;
        if with_displacements != 0 {
            own = own.with_displacements();
        }
        let last = None;
        give(place, Solved { own, grid, last }, grid.cells())
    })
}

/// Frees planes; does nothing if the pointer is NULL.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_planes_free(planes: *mut stickslip_planes) -> stickslip_status {
    // SAFETY: the caller follows the rule for pointers.
    call(|| unsafe { free(planes) })
}

/// Solves the plane at the depth with number index, counted from zero, in body STICKSLIP_BODY_1 or STICKSLIP_BODY_2, by
/// fast Fourier transforms. Returns STICKSLIP_LENGTH if index is not less than the number of depths, and
/// STICKSLIP_RIGID_BODY for a rigid body. A failure leaves the last solved plane unchanged.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_planes_solve(
    planes: *mut stickslip_planes,
    index: usize,
    which: i32,
    tractions: *const stickslip_tractions,
) -> stickslip_status {
    let nobody = std::ptr::null();
    // SAFETY: the caller follows the rule for pointers.
    unsafe { stickslip_planes_solve_observed(planes, index, which, tractions, nobody) }
}

/// Solves a plane with an observer (may be NULL), like stickslip_planes_solve. The observer is called before the
/// kernels are sampled, and before each transform of a kernel or of three components. It may end the call, which then
/// returns STICKSLIP_NOT_CONVERGED. An observed call needs memory for an additional plane.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_planes_solve_observed(
    planes: *mut stickslip_planes,
    index: usize,
    which: i32,
    tractions: *const stickslip_tractions,
    observer: *const stickslip_observer,
) -> stickslip_status {
    // SAFETY: the caller follows the rule for pointers.
    call_on(planes, || unsafe {
        let (body, tractions) = (body(which)?, input("tractions", tractions)?);
        let observer = optional("observer", observer)?;
        let mut planes = changing(planes)?;
        let spare = planes.spare();
        let Solved { own, grid, last } = &mut *planes;
        if index >= own.depths().len() {
            return Err(Failure::depth(index, own.depths().len()));
        }
        tractions.with(*grid, spare, |tractions| {
            match (last, observer) {
                (Some(plane), None) => own.solve_into(index, body, tractions, plane)?,
                (last, observer) => {
                    let plane = own.solve_observed(index, body, tractions, watch(observer))?;
                    *last = Some(plane);
                }
            }
            Ok(())
        })
    })
}

/// Returns a field of the last solved plane and writes its number of cells to count (may be NULL); returns NULL on failure.
/// The field is STICKSLIP_STRESS_XX to STICKSLIP_STRESS_YZ or, for planes with displacements, STICKSLIP_DISPLACEMENT_X to
/// STICKSLIP_DISPLACEMENT_Z.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_planes_field(
    planes: *const stickslip_planes,
    which: i32,
    count: *mut usize,
) -> *const f64 {
    // SAFETY: the caller follows the rule for pointers.
    unsafe { show(planes, count, |of| Ok(field(of.last()?, which)?.as_slice())) }
}

fn field(plane: &Plane, which: i32) -> Outcome<&Field> {
    let displacement = || {
        plane
            .displacement()
            .ok_or_else(|| without_displacements(which))
    };
    Ok(match which {
        STICKSLIP_STRESS_XX => plane.normal_stress()[0],
        STICKSLIP_STRESS_YY => plane.normal_stress()[1],
        STICKSLIP_STRESS_ZZ => plane.normal_stress()[2],
        STICKSLIP_STRESS_XY => plane.shear_stress()[0],
        STICKSLIP_STRESS_XZ => plane.shear_stress()[1],
        STICKSLIP_STRESS_YZ => plane.shear_stress()[2],
        STICKSLIP_DISPLACEMENT_X => displacement()?[0],
        STICKSLIP_DISPLACEMENT_Y => displacement()?[1],
        STICKSLIP_DISPLACEMENT_Z => displacement()?[2],
        STICKSLIP_VON_MISES..=STICKSLIP_HYDROSTATIC => {
            return Err(none(
                "planes",
                which,
                "the function measure of planes for STICKSLIP_VON_MISES to STICKSLIP_HYDROSTATIC",
            ));
        }
        other => {
            return Err(none(
                "planes",
                other,
                "STICKSLIP_STRESS_XX to STICKSLIP_STRESS_YZ, or STICKSLIP_DISPLACEMENT_X to STICKSLIP_DISPLACEMENT_Z of planes with displacements",
            ));
        }
    })
}

/// Creates the failure for a displacement of planes without displacements.
fn without_displacements(field: i32) -> Failure {
    Failure::at_value(
        STICKSLIP_UNKNOWN_OPTION,
        f64::from(field),
        format!(
            "the field {field} is a displacement, which exists only in planes with displacements: create the planes with with_displacements"
        ),
    )
}

/// Writes the warnings about the last solved plane, like stickslip_normal_solution_warnings. Pointers to tractions contain no
/// status, so a plane cannot warn of a solution that has not converged.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_planes_warnings(
    planes: *const stickslip_planes,
    buffer: *mut stickslip_warning,
    capacity: usize,
    count: *mut usize,
) -> stickslip_status {
    // SAFETY: the caller follows the rule for pointers.
    call_on(planes, || unsafe {
        put_warnings(buffer, capacity, count, || {
            Ok(reading(planes)?.last()?.warnings())
        })
    })
}

/// Writes STICKSLIP_VON_MISES, STICKSLIP_MAX_SHEAR or STICKSLIP_HYDROSTATIC of each cell of the last solved plane to
/// values, which has count entries.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_planes_measure(
    planes: *const stickslip_planes,
    which: i32,
    values: *mut f64,
    count: usize,
) -> stickslip_status {
    // SAFETY: the caller follows the rule for pointers.
    call_on(planes, || unsafe {
        let planes = reading(planes)?;
        let values = cells_mut("values", planes.grid, values, count)?;
        let measure = match which {
            STICKSLIP_VON_MISES => Stress::von_mises,
            STICKSLIP_MAX_SHEAR => Stress::max_shear,
            STICKSLIP_HYDROSTATIC => Stress::hydrostatic,
            other => {
                return Err(Failure::option(
                    "measure of planes",
                    other,
                    "STICKSLIP_VON_MISES, STICKSLIP_MAX_SHEAR or STICKSLIP_HYDROSTATIC",
                ));
            }
        };
        for (value, stress) in values.iter_mut().zip(planes.last()?.stresses()) {
            *value = measure(&stress);
        }
        Ok(())
    })
}
