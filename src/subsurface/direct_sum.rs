//! The sum over the loaded cells.

use std::array::from_fn;
use std::ops::Range;

use crate::error::Result;
use crate::grid::Grid;
use crate::half_space::HalfSpace;
use crate::memory::fallible;
use crate::subsurface::body::Constants;
use crate::subsurface::distances::{Distances, depth_in};
use crate::subsurface::kernel::{
    FieldComponent, Load, LoadedRectangle, PotentialIntegral, Weights,
};
use crate::subsurface::points::PointResult;
use crate::subsurface::stress::Stress;
use crate::subsurface::strip::Strips;

/// Cells that carry tractions.
pub(super) struct Loaded<'a> {
    grid: Grid,
    fields: [Option<&'a [f64]>; 3],
    cell: LoadedRectangle,
    /// Images along y, if the grid is periodic along y.
    strips: Option<Strips>,
    /// Range of columns with loaded cells for each row. Rows without loaded cells are omitted.
    rows: Vec<(usize, Range<usize>)>,
}

impl<'a> Loaded<'a> {
    pub(super) fn new(bodies: &HalfSpace, fields: [Option<&'a [f64]>; 3]) -> Self {
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

    pub(super) fn response(
        &self,
        [x, y, depth]: [f64; 3],
        constants: &Constants,
    ) -> Result<PointResult> {
        let z = depth_in(self.grid, depth);
        let sums = self.sums([x, y, z])?;
        let weights = Weights::new(constants.poisson_ratio, z);
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
        Ok(PointResult {
            displacement: [FieldComponent::Ux, FieldComponent::Uy, FieldComponent::Uz].map(of),
            stress: Stress {
                xx: of(FieldComponent::Sxx),
                yy: of(FieldComponent::Syy),
                zz: of(FieldComponent::Szz),
                xy: of(FieldComponent::Sxy),
                xz: of(FieldComponent::Sxz),
                yz: of(FieldComponent::Syz),
            },
        })
    }

    /// Returns the sums of the integrals of all cells times their tractions, row by row.
    fn sums(&self, [x, y, z]: [f64; 3]) -> Result<[[f64; PotentialIntegral::COUNT]; 3]> {
        let mut sums = [[0.0; PotentialIntegral::COUNT]; 3];
        let nx = self.grid.nx();
        let along_x = Distances::new(x, nx, self.grid.dx(), false);
        let is_round = self.strips.is_some();
        let along_y = Distances::new(y, self.grid.ny(), self.grid.dy(), is_round);
        let mut xs = fallible::with_room(nx)?;
        let mut values = fallible::zeros(PotentialIntegral::COUNT * nx)?;
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
        Ok(sums)
    }
}
