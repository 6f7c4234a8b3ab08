//! Stress and displacement at points below the surface.

use stickslip_rs::Grid;
use stickslip_rs::subsurface::{self, Body, PointResult, Stress, Tractions};

use crate::call::{Outcome, call};
use crate::error::Failure;
use crate::half_space::stickslip_half_space;
use crate::handle::reading;
use crate::observer::{stickslip_observer, watch};
use crate::pointer::{cells, collected, entries, entries_mut, input, optional};
use crate::scratch::Spare;
use crate::status::stickslip_status;
use crate::threads::enter;

/// Body 1; z points into it.
pub const STICKSLIP_BODY_1: i32 = 1;
/// Body 2, above body 1.
pub const STICKSLIP_BODY_2: i32 = 2;

pub(crate) fn body(value: i32) -> Outcome<Body> {
    match value {
        STICKSLIP_BODY_1 => Ok(Body::One),
        STICKSLIP_BODY_2 => Ok(Body::Two),
        other => Err(Failure::option(
            "body",
            other,
            "STICKSLIP_BODY_1 or STICKSLIP_BODY_2",
        )),
    }
}

/// Tractions on the surface: fields of a solution or a history, or other arrays. The caller must ensure that all fields
/// belong to the same bodies.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct stickslip_tractions {
    /// Pressure of each cell, positive in compression.
    pub pressure: *const f64,
    /// Traction along x on body 1 (pressures). Without shear, this pointer and the pointer to the traction along y are
    /// NULL.
    pub x: *const f64,
    /// Traction along y on body 1.
    pub y: *const f64,
    /// Number of cells.
    pub count: usize,
}

impl stickslip_tractions {
    /// Runs work on the tractions.
    ///
    /// # Safety
    /// The caller must follow the rule for pointers in [`crate::pointer`].
    pub(crate) unsafe fn with<T>(
        &self,
        grid: Grid,
        spare: &Spare,
        work: impl FnOnce(Tractions<'_>) -> Outcome<T>,
    ) -> Outcome<T> {
        let has_shear = !self.x.is_null() || !self.y.is_null();
        // SAFETY: the caller follows the safety contract of this function.
        let field = |name, pointer| unsafe { cells(name, grid, pointer, self.count) };
        let pressure = field("pressure", self.pressure)?;
        if !has_shear {
            return spare.with_copy(grid, pressure, |pressure| work(Tractions::new(pressure)));
        }
        let (x, y) = (
            field("traction along x", self.x)?,
            field("traction along y", self.y)?,
        );
        spare.with_copy(grid, pressure, |pressure| {
            spare.with_copy(grid, x, |x| {
                spare.with_copy(grid, y, |y| {
                    work(Tractions::new(pressure).with_traction([x, y]))
                })
            })
        })
    }
}

/// Point in a body.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct stickslip_point {
    /// Position along x in the coordinates of the grid (a length).
    pub x: f64,
    /// Position along y (a length).
    pub y: f64,
    /// Depth below the surface of the body (a length), zero or positive in both bodies.
    pub depth: f64,
}

/// Displacement and stress at a point, with components along x, y and z; z points into body 1.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct stickslip_response {
    /// Displacement of the body itself along x, y and z (lengths), not relative to the other body; zero at infinity.
    pub displacement: [f64; 3],
    /// Stresses xx, yy and zz (pressures, positive in tension).
    pub normal_stress: [f64; 3],
    /// Stresses xy, xz and yz (pressures).
    pub shear_stress: [f64; 3],
    /// Principal stresses in descending order (pressures, positive in tension).
    pub principal_stress: [f64; 3],
    /// Von Mises equivalent stress (a pressure).
    pub von_mises: f64,
}

impl From<PointResult> for stickslip_response {
    fn from(at: PointResult) -> Self {
        let stress: Stress = at.stress;
        Self {
            displacement: at.displacement,
            normal_stress: [stress.xx, stress.yy, stress.zz],
            shear_stress: [stress.xy, stress.xz, stress.yz],
            principal_stress: stress.principal().values,
            von_mises: stress.von_mises(),
        }
    }
}

/// Computes displacement and stress of body STICKSLIP_BODY_1 or STICKSLIP_BODY_2 at count points and writes them to
/// responses. The body must not be coated. The sums over all loaded cells are exact for a uniform traction on each cell.
/// Returns STICKSLIP_RIGID_BODY for a rigid body, STICKSLIP_INVALID_ARGUMENT for a coated body, and
/// STICKSLIP_DIVERGENT_PERIODIC_SUM on a grid that is periodic along both axes. Use stickslip_planes_solve for coated
/// bodies, for periodic grids and for whole planes.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_stress_at_points(
    half_space: *const stickslip_half_space,
    which: i32,
    tractions: *const stickslip_tractions,
    points: *const stickslip_point,
    count: usize,
    responses: *mut stickslip_response,
) -> stickslip_status {
    let nobody = std::ptr::null();
    // SAFETY: the caller follows the rule for pointers.
    unsafe {
        stickslip_stress_at_points_observed(
            half_space, which, tractions, points, count, nobody, responses,
        )
    }
}

/// Computes displacement and stress at points with an observer (may be NULL), like stickslip_stress_at_points. The observer
/// is called before each portion of the points and may end the call: the function then returns STICKSLIP_NOT_CONVERGED and
/// leaves responses unchanged.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_stress_at_points_observed(
    half_space: *const stickslip_half_space,
    which: i32,
    tractions: *const stickslip_tractions,
    points: *const stickslip_point,
    count: usize,
    observer: *const stickslip_observer,
    responses: *mut stickslip_response,
) -> stickslip_status {
    // SAFETY: the caller follows the rule for pointers.
    call(|| unsafe {
        let observer = optional("observer", observer)?;
        let places = entries_mut("responses", responses, count)?;
        let points = entries("points", points, count)?;
        let points = points.iter().map(|at| [at.x, at.y, at.depth]);
        let points = collected(Vec::new(), points)?;
        let (body, tractions) = (body(which)?, input("tractions", tractions)?);
        let bodies = reading(half_space)?;
        let bodies = &*bodies;
        let grid = bodies.grid();
        let found = tractions.with(grid, &Spare::default(), |tractions| {
            let watch = watch(observer);
            let sum = || subsurface::at_points_observed(bodies, body, tractions, &points, watch);
            Ok(enter(grid.cells().saturating_mul(points.len()), sum)?)
        })?;
        for (place, response) in places.iter_mut().zip(found) {
            *place = response.into();
        }
        Ok(())
    })
}
