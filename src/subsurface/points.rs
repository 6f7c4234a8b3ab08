//! Stress and displacement at arbitrary points, by summation over the loaded cells.

use std::ops::ControlFlow;

use crate::error::{Error, Result};
use crate::grid::boundary::Boundary;
use crate::half_space::HalfSpace;
use crate::memory::fallible;
use crate::observer::{WorkObserver, unwatched};
use crate::parallel::{self, Blocks};
use crate::report::Iteration;
use crate::subsurface::body::Body;
use crate::subsurface::direct_sum::Loaded;
use crate::subsurface::distances::{TOO_FAR, reach};
use crate::subsurface::stress::Stress;
use crate::subsurface::tractions::Tractions;

/// Number of pairs of a point and a cell, or their equivalent, between two calls of an observer.
const PORTION: usize = 100_000;

/// Displacement and stress of a body at a point.
///
/// ```
/// use std::f64::consts::PI;
/// use stickslip::subsurface::{Body, PointResult, Tractions, at_points};
/// use stickslip::*;
/// let body = Material::from_shear_modulus(1.0, 0.25)?;
/// let pair = ElasticPair::new(body, Material::rigid())?;
/// let bodies = HalfSpace::new(Grid::square(2, 0.02)?, pair)?;
/// let pressure = Field::constant(bodies.grid(), 1e4);
/// // Far away the load acts like Boussinesq's point force P: uz = (1 - nu) P/(2 pi G r) on the surface, which is free.
/// let far = at_points(&bodies, Body::One, Tractions::new(&pressure), &[[3.0, 4.0, 0.0]])?;
/// let PointResult { displacement: [_, _, uz], stress, .. } = far[0];
/// let force = pressure.integral();
/// assert!((uz / (0.75 * force / (2.0 * PI * 5.0)) - 1.0).abs() < 1e-5);
/// assert!(stress.zz.abs() < 1e-12 && stress.xx.abs() > 1e-3);
/// # Ok::<(), Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub struct PointResult {
    /// Displacement along x, y and z (lengths) of the body itself, not relative to the other body. The displacement is
    /// zero at infinity. If the grid is periodic along y, it is measured relative to the datum.
    pub displacement: [f64; 3],
    /// Stress (pressures, tensile positive).
    pub stress: Stress,
}

/// Returns the displacement and stress of a body at any points `[x, y, depth]` (lengths), by summation over the loaded cells.
///
/// Each cell carries a uniform traction. The traction outside the grid is zero. A depth of less than 1e-150 of the longer side of
/// a cell counts as the surface.
///
/// The coordinates x and y are coordinates of the grid, and the depth is measured from the surface into the [`Body`]. The values
/// at depth zero are the limits from inside the body. On the surface sxx, syy and sxy are logarithmically infinite or jump
/// between cells of different tractions. On a common edge the function returns the mean of the finite parts on both sides (see
/// [the page of the module](crate::subsurface#on-the-surface)).
///
/// If the grid is periodic along y, the sum includes all images of the cells, and displacements are relative to the datum.
///
/// # Accuracy and cost
///
/// With at most 2048 loaded cells, or at most three points, the sum is computed cell by cell. The effect of a cell is accurate to
/// 1e-13 of its largest component at the point, at any position and depth up to 1e60 cells away. Below 512 x 512 cells, the
/// round-off of the sum is at most 2e-12 of the largest stress. A point takes about 0.3 microseconds per loaded cell. On a grid
/// of several rows that is periodic along y, a point takes about fifty times as long.
///
/// If there are more cells and points, and the grid is not periodic along y, distant cells are summed in blocks. Interpolation at
/// 24 x 24 nodes of a block adds an error of at most 1e-12 of the stress that each cell causes alone. The sum over tractions of a
/// contact is accurate to 1e-13 of its largest stress. If tractions of opposite signs cancel at a point, the error is larger
/// relative to the remaining stress. A point takes about 0.6 milliseconds below 65 536 loaded cells.
///
/// The forces of the blocks need about 100 bytes per cell under a pressure, and 300 bytes with tractions along x and y. Their
/// computation takes as long as the sum over all cells at one to two points.
///
/// For a whole plane use [`Planes`](crate::subsurface::Planes). The threads of the caller's pool share the work if the number of
/// points or of cells exceeds [`SERIAL_CELL_LIMIT`](crate::SERIAL_CELL_LIMIT). The results are bitwise identical for any number
/// of threads.
///
/// ```
/// use stickslip::subsurface::{self, Body};
/// use stickslip::*;
/// let grid = Grid::square(32, 3.0)?;
/// let rubber = Material::new(1.0, 0.5)?;
/// let bodies = HalfSpace::new(grid, ElasticPair::new(rubber, Material::rigid())?)?;
/// // A ball pressed with a contact radius of one.
/// let hertz = analytical::HertzSphere::new(bodies.pair(), 10.0, 4.0 / 3.0 * 4.0 / 3.0 / 10.0)?;
/// let pressure = Field::from_fn(grid, |x, y| hertz.pressure(x.hypot(y)));
/// let below = subsurface::at_points(
///     &bodies, Body::One, subsurface::Tractions::new(&pressure), &[[0.0, 0.0, 0.0], [0.0, 0.0, 40.0]],
/// )?;
/// // Far below, the load acts like a point force: szz = -3 P/(2 pi z^2).
/// let far = -1.5 * pressure.integral() / (std::f64::consts::PI * 1600.0);
/// assert!((below[1].stress.zz / far - 1.0).abs() < 1e-3);
/// # Ok::<(), Error>(())
/// ```
///
/// # Errors
/// - [`Error::Sample`] for a negative depth, or for a coordinate, traction or uniform stress that is not finite. The error is
///   also returned for a point farther away than 1e60 times the shorter side of a cell.
/// - [`Error::GridMismatch`], [`Error::BoundaryMismatch`], [`Error::CellValueMismatch`] or [`Error::MaterialMismatch`] if the
///   tractions belong to different bodies.
/// - [`Error::NotConverged`] for a solution that no solve has filled.
/// - [`Error::OutdatedSolution`] for a tangential solution that was computed for a different pressure than the normal solution.
/// - [`Error::RigidBody`] for a rigid body.
/// - [`Error::UnsupportedForCoatings`] for a coated body. Use [`Planes`](crate::subsurface::Planes) instead.
/// - [`Error::DivergentPeriodicSum`] if the grid is periodic along both axes. Use [`Planes`](crate::subsurface::Planes) instead.
/// - [`Error::Memory`] if memory runs out.
/// - [`Error::Ranks`] if the bodies are distributed over ranks.
pub fn at_points<'a>(
    bodies: &HalfSpace,
    body: Body,
    tractions: impl Into<Tractions<'a>>,
    points: &[[f64; 3]],
) -> Result<Vec<PointResult>> {
    at_points_observed(bodies, body, tractions, points, unwatched)
}

/// Calls [`at_points`] with an observer that may cancel. The observer is called before each portion of the points, and before the
/// forces of each 256 blocks. A portion contains a few points per thread, or more points if a portion would take less than about
/// 30 milliseconds. Portions count as products.
///
/// # Errors
/// - The errors of [`at_points`].
/// - [`Error::NotConverged`] if the observer cancels.
pub fn at_points_observed<'a>(
    bodies: &HalfSpace,
    body: Body,
    tractions: impl Into<Tractions<'a>>,
    points: &[[f64; 3]],
    mut observer: impl FnMut(&Iteration) -> ControlFlow<()> + Send,
) -> Result<Vec<PointResult>> {
    bodies.check_alone("the stress at points")?;
    let constants = body.constants(bodies.pair())?;
    if constants.coated().is_some() {
        return Err(Error::UnsupportedForCoatings {
            quantity: "the stress at points",
            bodies: "coated bodies",
            remedy: "compute the stress on planes instead",
        });
    }
    let tractions = tractions.into();
    let fields = tractions.checked(bodies)?;
    let fields = fields.each_ref().map(Option::as_deref);
    let uniform = tractions.checked_uniform()?;
    if bodies.boundary() == Boundary::Periodic {
        return Err(Error::DivergentPeriodicSum("the sum over loaded cells"));
    }
    for (index, &[x, y, depth]) in points.iter().enumerate() {
        let refused = |value, rule| {
            let quantity = "point";
            Err(Error::Sample {
                quantity,
                index,
                value,
                rule,
            })
        };
        if let Some(&value) = [x, y].iter().find(|value| !value.is_finite()) {
            return refused(value, "x and y must be finite");
        }
        if !(depth >= 0.0 && depth.is_finite()) {
            return refused(depth, "the depth must be non-negative and finite");
        }
        let mut coordinates = [x, y, depth].into_iter();
        if let Some(far) = coordinates.find(|&value| !reach(bodies.grid(), value)) {
            return refused(far, TOO_FAR);
        }
    }
    let mut responses = fallible::filled(PointResult::default(), points.len())?;
    let cells = bodies.grid().cells();
    let watch = &mut WorkObserver::new(&mut observer);
    parallel::enter_with(cells.max(points.len()), || {
        let loaded = Loaded::new(bodies, fields, points.len(), watch)?;
        let portion = (PORTION / loaded.cells_per_point()).max(parallel::lanes());
        for (first, items) in (0..).step_by(portion).zip(responses.chunks_mut(portion)) {
            watch.notify_observer()?;
            let work = |point: usize, response: Blocks<'_, PointResult>| {
                for response in response.items {
                    *response = loaded.response(points[first + point], &constants)?;
                    response.stress += uniform;
                }
                Ok(())
            };
            let (count, width) = (items.len(), 1);
            parallel::sweep(0..count, Blocks { items, width }, &work, &Result::and)?;
        }
        Ok(())
    })?;
    Ok(responses)
}
