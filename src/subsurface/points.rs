//! Stress and displacement at scattered points, by direct sum over the loaded cells.

use std::array::from_fn;
use std::ops::Range;

use crate::boundary::Boundary;
use crate::error::{Error, Result};
use crate::grid::Grid;
use crate::half_space::HalfSpace;
use crate::parallel::{self, Blocks};
use crate::subsurface::body::{Body, Constants};
use crate::subsurface::kernel::{Component, Integral, Load, LoadedRectangle, Weights};
use crate::subsurface::stress::Stress;
use crate::subsurface::strip::Strips;
use crate::subsurface::tractions::Tractions;

/// Displacement and stress of a body at a point.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Response {
    /// Along x, y and z (lengths), of the body itself, not relative to the other; zero at infinity,
    /// relative to the datum where the grid repeats along y.
    pub displacement: [f64; 3],
    /// The stress (pressures, tensile positive).
    pub stress: Stress,
}

/// Displacement and stress of a body at any points `[x, y, depth]` (lengths), by direct sum over the loaded cells: the
/// uniform traction on each cell and nothing elsewhere, exact to 1e-13 of the largest component at the point, at any
/// place and depth.
///
/// x and y are those of the grid, the depth counts from the surface into the [`Body`]. Depth zero is the limit from
/// inside the body. Between cells of different tractions sxx, syy and sxy are there logarithmically infinite or jump:
/// on a common edge their finite part, and the mean of both sides, is returned ([the page of the
/// module](crate::subsurface#on-the-surface)).
///
/// On a grid that repeats along y all images of the cells count too, and displacements are relative to the datum.
///
/// The cost of a point is about 0.3 microseconds for each loaded cell (some fifty times that where several rows repeat along y).
/// For a whole plane use [`Planes`](crate::subsurface::Planes). The points are shared by the threads of the caller's
/// pool; the bits do not depend on their number.
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
/// // Far below it is a point force: szz = -3 P/(2 pi z^2).
/// let far = -1.5 * pressure.integral() / (std::f64::consts::PI * 1600.0);
/// assert!((below[1].stress.zz / far - 1.0).abs() < 1e-3);
/// # Ok::<(), Error>(())
/// ```
///
/// # Errors
/// [`Error::Sample`] for a depth that is negative, or a coordinate or traction that is not finite;
/// [`Error::GridMismatch`], [`Error::BoundaryMismatch`] and [`Error::MaterialMismatch`] if the tractions are not
/// those of these bodies; [`Error::RigidBody`]; [`Error::Repeats`] if the grid
/// repeats along both axes: use [`Planes`](crate::subsurface::Planes); [`Error::Ranks`].
pub fn at_points<'a>(
    bodies: &HalfSpace,
    body: Body,
    tractions: impl Into<Tractions<'a>>,
    points: &[[f64; 3]],
) -> Result<Vec<Response>> {
    bodies.check_alone("stresses at points")?;
    let constants = body.constants(bodies.pair())?;
    let fields = tractions.into().checked(bodies)?;
    if bodies.boundary() == Boundary::Periodic {
        return Err(Error::Repeats("the sum over loaded cells"));
    }
    for (index, &[x, y, depth]) in points.iter().enumerate() {
        let refused = |value, rule| {
            let quantity = "points";
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
    }
    let loaded = Loaded::new(bodies, fields);
    let mut responses = vec![Response::default(); points.len()];
    let data = Blocks {
        items: &mut responses,
        width: 1,
    };
    let work = |point: usize, response: Blocks<'_, Response>| {
        for response in response.items {
            *response = loaded.response(points[point], &constants);
        }
    };
    parallel::sweep(0..points.len(), data, &work, &|(), ()| ());
    Ok(responses)
}

/// The cells that carry tractions.
struct Loaded<'a> {
    grid: Grid,
    fields: [Option<&'a [f64]>; 3],
    cell: LoadedRectangle,
    /// Where the grid repeats along y.
    strips: Option<Strips>,
    /// The columns of each row between which they lie; rows without any are left out.
    rows: Vec<(usize, Range<usize>)>,
}

impl<'a> Loaded<'a> {
    fn new(bodies: &HalfSpace, fields: [Option<&'a [f64]>; 3]) -> Self {
        let grid = bodies.grid();
        let row = |iy: usize| {
            let is_loaded = |ix: &usize| {
                let mut carried = fields.iter().flatten();
                carried.any(|field| field[iy * grid.nx() + ix] != 0.0)
            };
            let first = (0..grid.nx()).find(is_loaded)?;
            let last = (0..grid.nx()).rfind(is_loaded)?;
            Some((iy, first..last + 1))
        };
        Self {
            grid,
            fields,
            cell: LoadedRectangle::new(0.5 * grid.dx(), 0.5 * grid.dy()),
            strips: Strips::new(grid, bodies.boundary()),
            rows: (0..grid.ny()).filter_map(row).collect(),
        }
    }

    fn response(&self, point: [f64; 3], constants: &Constants) -> Response {
        let sums = self.sums(point);
        let weights = Weights::new(constants.poisson_ratio, point[2]);
        let of = |component| {
            let mut sum = 0.0;
            for (load, sums) in Load::ALL.into_iter().zip(&sums) {
                let mut part = 0.0;
                for (weight, value) in weights.of(load, component).iter().zip(sums) {
                    part += weight * value;
                }
                sum += constants.factor_in(load) * part;
            }
            constants.factor_out(component) * sum
        };
        Response {
            displacement: [Component::Ux, Component::Uy, Component::Uz].map(of),
            stress: Stress {
                xx: of(Component::Sxx),
                yy: of(Component::Syy),
                zz: of(Component::Szz),
                xy: of(Component::Sxy),
                xz: of(Component::Sxz),
                yz: of(Component::Syz),
            },
        }
    }

    /// The integrals of all cells times the tractions they carry, summed row by row.
    fn sums(&self, [x, y, z]: [f64; 3]) -> [[f64; Integral::COUNT]; 3] {
        let mut sums = [[0.0; Integral::COUNT]; 3];
        let nx = self.grid.nx();
        let along_x = Distances::new(x, nx, self.grid.dx(), false);
        let is_round = self.strips.is_some();
        let along_y = Distances::new(y, self.grid.ny(), self.grid.dy(), is_round);
        let mut xs = Vec::with_capacity(nx);
        let mut values = vec![0.0; Integral::COUNT * nx];
        for (iy, columns) in &self.rows {
            xs.clear();
            xs.extend(columns.clone().map(|ix| along_x.to(ix)));
            let mut lines = values.chunks_exact_mut(nx);
            let mut out = from_fn(|_| lines.next().unwrap_or_default());
            let y = along_y.to(*iy);
            if let Some(strips) = &self.strips {
                for (k, &x) in xs.iter().enumerate() {
                    let integrals = strips.integrals(&self.cell, [x, y, z]);
                    for (out, integral) in out.iter_mut().zip(integrals) {
                        out[k] = integral;
                    }
                }
            } else {
                self.cell.integrals_along_row(&xs, y, z, &mut out);
            }
            let first = iy * nx;
            for (sums, field) in sums.iter_mut().zip(self.fields) {
                let Some(field) = field else { continue };
                let tractions = &field[first + columns.start..first + columns.end];
                for (sum, values) in sums.iter_mut().zip(&out) {
                    for (value, traction) in values.iter().zip(tractions) {
                        *sum += value * traction;
                    }
                }
            }
        }
        sums
    }
}

/// The distances of a point from the cells along one axis, from their nearest images if they repeat. A point on an
/// edge is there for the cells on both sides: one that were beside it by a rounding would see logarithms that do not
/// cancel.
struct Distances {
    at: f64,
    cells: usize,
    side: f64,
    repeats: bool,
    /// Half sides from the middle of the grid, if they are whole.
    steps: Option<f64>,
}

impl Distances {
    fn new(at: f64, cells: usize, side: f64, repeats: bool) -> Self {
        let steps = 2.0 * (at / side);
        let error = 8.0 * f64::EPSILON * (1.0 + steps.abs());
        let steps = Some(steps.round()).filter(|whole| (steps - whole).abs() <= error);
        Self {
            at,
            cells,
            side,
            repeats,
            steps,
        }
    }

    fn to(&self, cell: usize) -> f64 {
        // The centre in half sides.
        let centre = 2.0 * cell as f64 - (self.cells - 1) as f64;
        let half = 0.5 * self.side;
        let (distance, period, unit) = match self.steps {
            Some(steps) => (steps - centre, 2.0 * self.cells as f64, half),
            None => (self.at - centre * half, self.side * self.cells as f64, 1.0),
        };
        let periods = if self.repeats {
            (distance / period).round()
        } else {
            0.0
        };
        (distance - period * periods) * unit
    }
}
