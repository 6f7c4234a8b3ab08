//! The sum over the loaded cells. Distant cells are summed in [blocks](BlockTree) if this is faster.

use std::array::from_fn;
use std::ops::Range;

use crate::error::Result;
use crate::grid::Grid;
use crate::half_space::HalfSpace;
use crate::memory::fallible;
use crate::observer::WorkObserver;
use crate::subsurface::blocks::{BlockTree, LANES};
use crate::subsurface::body::Constants;
use crate::subsurface::distances::{Distances, depth_in};
use crate::subsurface::kernel::{
    FieldComponent, Load, LoadedRectangle, PotentialIntegral, Weights, totals,
};
use crate::subsurface::points::PointResult;
use crate::subsurface::stress::Stress;
use crate::subsurface::strip::Strips;

/// Number of loaded cells up to which no blocks are used. In larger contacts a point costs about as much as
/// this number of cells.
const FEW_CELLS: usize = 2048;
/// Number of points up to which no blocks are used. The forces of the blocks cost as much as one or two points.
const FEW_POINTS: usize = 3;

/// Row and columns of consecutive cells.
pub(super) type Row = (usize, Range<usize>);

/// Sums of the integrals times each traction.
pub(super) type Sums = [[f64; PotentialIntegral::COUNT]; 3];

/// Cells that carry tractions.
pub(super) struct Loaded<'a> {
    grid: Grid,
    fields: [Option<&'a [f64]>; 3],
    cell: LoadedRectangle,
    /// Images along y, if the grid is periodic along y.
    strips: Option<Strips>,
    cells: Cells<'a>,
}

/// Loaded cells, in rows or in blocks.
enum Cells<'a> {
    /// All loaded cells. Rows without loaded cells are omitted.
    Rows(Vec<Row>),
    Blocks(Box<BlockTree<'a>>),
}

/// Returns the columns from the first to the last loaded cell of a part of a row, or `None` without a loaded cell.
pub(super) fn row(
    fields: &[Option<&[f64]>; 3],
    nx: usize,
    iy: usize,
    mut columns: Range<usize>,
) -> Option<Row> {
    let is_loaded = |ix: &usize| {
        let mut carried = fields.iter().flatten();
        carried.any(|field| field[iy * nx + ix] != 0.0)
    };
    let first = columns.clone().find(is_loaded)?;
    let last = columns.rfind(is_loaded)?;
    Some((iy, first..last + 1))
}

impl<'a> Loaded<'a> {
    /// Prepares the sum at the given number of points.
    pub(super) fn new(
        bodies: &HalfSpace,
        fields: [Option<&'a [f64]>; 3],
        points: usize,
        watch: &mut WorkObserver<'_>,
    ) -> Result<Self> {
        let grid = bodies.grid();
        let (nx, ny) = (grid.nx(), grid.ny());
        let rows = (0..ny).filter_map(|iy| row(&fields, nx, iy, 0..nx));
        let rows = fallible::collected(ny, rows)?;
        let strips = Strips::new(grid, bodies.boundary());
        let cells: usize = rows.iter().map(|(_, columns)| columns.len()).sum();
        let cells = if cells > FEW_CELLS && points > FEW_POINTS && strips.is_none() {
            Cells::Blocks(Box::new(BlockTree::new(grid, fields, &rows, watch)?))
        } else {
            Cells::Rows(rows)
        };
        Ok(Self {
            grid,
            fields,
            cell: LoadedRectangle::new(0.5 * grid.dx(), 0.5 * grid.dy()),
            strips,
            cells,
        })
    }

    /// Returns the number of cells that one point costs.
    pub(super) fn cells_per_point(&self) -> usize {
        match self.cells {
            Cells::Rows(_) => self.grid.cells(),
            Cells::Blocks(_) => FEW_CELLS,
        }
    }

    pub(super) fn response(
        &self,
        [x, y, depth]: [f64; 3],
        constants: &Constants,
    ) -> Result<PointResult> {
        let z = depth_in(self.grid, depth);
        let (sums, distant) = self.sums([x, y, z], constants)?;
        let weights = Weights::new(constants.poisson_ratio, z);
        let of = |component| {
            let mut sum = distant[component as usize];
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

    /// Returns the sums of the integrals of the cells times their tractions, and the components of the cells that are summed in
    /// blocks.
    fn sums(
        &self,
        point: [f64; 3],
        constants: &Constants,
    ) -> Result<(Sums, [f64; FieldComponent::COUNT])> {
        let mut sums = [[0.0; PotentialIntegral::COUNT]; 3];
        let mut distant = [[0.0; LANES]; FieldComponent::COUNT];
        match &self.cells {
            Cells::Rows(rows) => RowSum::new(self, point, self.grid.nx())?.add(&mut sums, rows),
            Cells::Blocks(tree) => {
                let mut near = RowSum::new(self, point, tree.longest_row())?;
                let e = 1.0 - 2.0 * constants.poisson_ratio;
                let factors = [e, constants.factor_in(Load::Qx)];
                let add_rows = |rows: &[Row]| near.add(&mut sums, rows);
                tree.add_to(&mut distant, point, factors, add_rows);
            }
        }
        Ok((sums, totals(&distant)))
    }
}

/// Sum over rows of cells at a point, with its buffers.
struct RowSum<'a> {
    loaded: &'a Loaded<'a>,
    along_x: Distances,
    along_y: Distances,
    z: f64,
    longest: usize,
    xs: Vec<f64>,
    values: Vec<f64>,
}

impl<'a> RowSum<'a> {
    fn new(loaded: &'a Loaded<'a>, [x, y, z]: [f64; 3], longest: usize) -> Result<Self> {
        let (grid, is_round) = (loaded.grid, loaded.strips.is_some());
        Ok(Self {
            loaded,
            along_x: Distances::new(x, grid.nx(), grid.dx(), false),
            along_y: Distances::new(y, grid.ny(), grid.dy(), is_round),
            z,
            longest,
            xs: fallible::with_room(longest)?,
            values: fallible::zeros(PotentialIntegral::COUNT * longest)?,
        })
    }

    /// Adds the integrals of the cells times their tractions, row by row.
    fn add(&mut self, sums: &mut Sums, rows: &[Row]) {
        let Loaded {
            grid,
            fields,
            cell,
            strips,
            ..
        } = self.loaded;
        let (xs, z) = (&mut self.xs, self.z);
        for (iy, columns) in rows {
            xs.clear();
            xs.extend(columns.clone().map(|ix| self.along_x.to(ix)));
            let mut lines = self.values.chunks_exact_mut(self.longest);
            let mut out = from_fn(|_| lines.next().unwrap_or_default());
            let y = self.along_y.to(*iy);
            if let Some(strips) = strips {
                for (k, &x) in xs.iter().enumerate() {
                    let integrals = strips.integrals(cell, [x, y, z]);
                    for (out, integral) in out.iter_mut().zip(integrals) {
                        out[k] = integral;
                    }
                }
            } else {
                cell.integrals_along_row(xs, y, z, &mut out);
            }
            let first = iy * grid.nx();
            for (sums, field) in sums.iter_mut().zip(fields) {
                let Some(field) = field else { continue };
                let tractions = &field[first + columns.start..first + columns.end];
                for (sum, values) in sums.iter_mut().zip(&out) {
                    for (value, traction) in values.iter().zip(tractions) {
                        *sum += value * traction;
                    }
                }
            }
        }
    }
}
