//! Search for the part of the region where the bodies touch.

use super::gap::evaluate;
use super::problem::AdaptiveProblem;
use super::refine::bodies;
use super::region::Extent;
use crate::bodies::component::Component;
use crate::error::{Error, Result};
use crate::grid::Grid;
use crate::grid::field::Field;
use crate::memory::fallible;
use crate::normal::{NormalProblem, NormalSolution};
use crate::numerics::interpolation::{CUBIC, LagrangeStencil};
use crate::operator::Operator;

/// Number of cells along a side of the grids of the search.
const SEARCH_CELLS: usize = 24;
/// Number of cells of the grids of the search along a line.
const SEARCH_LINE_CELLS: usize = 96;
/// Number of parts of a search cell along each axis at which the gap is evaluated.
const SEARCH_PARTS: usize = 8;
/// Ratio of a side of the next extent to this side of the current extent below which the search continues.
const LARGE_SHRINKAGE: f64 = 0.7;
/// Free border around the contact, as a fraction of its width.
const BORDER: f64 = 0.12;
/// Largest ratio of the sides of an extent.
const MOST_ELONGATED: f64 = 8.0;
/// Largest number of grids of a search. Each grid shrinks a side by at least the factor [`LARGE_SHRINKAGE`], or widens a side by
/// half at one end, within the region.
const MOST_GRIDS: usize = 200;
/// Tolerance of the solves of the search.
const TOLERANCE: f64 = 1e-3;
/// Least overlap outside the extent that widens the extent, as a fraction of the approach.
const LEAST_OVERLAP: f64 = 0.02;

/// Box of cells around the contact: for each axis the first cell and the cell after the last.
pub(super) struct ContactBox([[usize; 2]; 2]);

impl ContactBox {
    /// Returns the box of the cells with pressure, or `None` without contact.
    pub(super) fn of(normal: &NormalSolution) -> Option<Self> {
        let nx = normal.grid().nx();
        let mut found = [[usize::MAX, 0]; 2];
        for (i, pressure) in normal.pressure().iter().enumerate() {
            if *pressure > 0.0 {
                for (ends, at) in found.iter_mut().zip([i % nx, i / nx]) {
                    *ends = [ends[0].min(at), ends[1].max(at + 1)];
                }
            }
        }
        (found[0][1] > 0).then_some(Self(found))
    }

    /// Returns a wider extent if the contact reaches an end of the extent that is not an end of the region.
    pub(super) fn widened(
        &self,
        problem: &AdaptiveProblem<'_>,
        extent: Extent,
        grid: Grid,
    ) -> Option<Extent> {
        let whole = problem.region.whole.ends;
        let mut wider = extent;
        for (axis, is_free) in problem.region.is_free().into_iter().enumerate() {
            let [first, last] = self.0[axis];
            let [start, end] = extent.ends[axis];
            let half = 0.5 * (end - start);
            if is_free && first == 0 {
                wider.ends[axis][0] = (start - half).max(whole[axis][0]);
            }
            if is_free && last == grid.size()[axis] {
                wider.ends[axis][1] = (end + half).min(whole[axis][1]);
            }
        }
        (wider != extent).then_some(wider)
    }

    /// Returns the extent of the contact with a free border, and whether this extent covers too small a part of the grid.
    fn bordered(
        &self,
        problem: &AdaptiveProblem<'_>,
        extent: Extent,
        grid: Grid,
    ) -> (Extent, bool) {
        let whole = problem.region.whole.ends;
        let mut smaller = extent;
        let mut is_sparse = false;
        let longest = (0..2)
            .map(|axis| self.width(axis) * [grid.dx(), grid.dy()][axis])
            .fold(0.0, f64::max);
        for (axis, is_free) in problem.region.is_free().into_iter().enumerate() {
            if !is_free {
                continue;
            }
            let side = [grid.dx(), grid.dy()][axis];
            let [first, last] = self.0[axis];
            let width = (self.width(axis) * side).max(longest / MOST_ELONGATED);
            let middle = extent.ends[axis][0] + 0.5 * (first + last) as f64 * side;
            // The edge of the contact is uncertain by a cell.
            let half = (0.5 + BORDER) * (width + 2.0 * side);
            smaller.ends[axis] = [
                (middle - half).max(whole[axis][0]),
                (middle + half).min(whole[axis][1]),
            ];
            let [start, end] = smaller.ends[axis];
            is_sparse |= end - start < LARGE_SHRINKAGE * extent.sides()[axis];
        }
        (smaller, is_sparse)
    }

    fn width(&self, axis: usize) -> f64 {
        let [first, last] = self.0[axis];
        (last - first) as f64
    }
}

/// Finds the extent of the contact on coarse grids, starting from the given extent.
pub(super) fn locate(problem: &AdaptiveProblem<'_>, start: Extent) -> Result<Extent> {
    if problem.region.is_free() == [false; 2] {
        return Ok(start);
    }
    let cells = search_cells(problem);
    let mut extent = start;
    for _ in 0..MOST_GRIDS {
        let gap = least_gaps(problem, extent, cells)?;
        let bodies = bodies(problem, extent, cells)?;
        let builder = NormalProblem::builder(&bodies, gap, problem.load).tolerance(TOLERANCE);
        let normal = builder.build()?.solve()?;
        let contact = ContactBox::of(&normal).ok_or(Error::EmptyContact)?;
        if let Some(wider) = contact.widened(problem, extent, bodies.grid()) {
            extent = wider;
            continue;
        }
        let (smaller, is_sparse) = contact.bordered(problem, extent, bodies.grid());
        extent = smaller;
        if !is_sparse {
            break;
        }
    }
    Ok(extent)
}

fn search_cells(problem: &AdaptiveProblem<'_>) -> [usize; 2] {
    if problem.region.is_line {
        [SEARCH_LINE_CELLS, 1]
    } else {
        [SEARCH_CELLS; 2]
    }
}

/// Returns the least gap in each cell of a grid, among points inside the cell.
fn least_gaps(problem: &AdaptiveProblem<'_>, extent: Extent, cells: [usize; 2]) -> Result<Field> {
    let parts = cells.map(|count| if count == 1 { 1 } else { SEARCH_PARTS });
    let gaps = evaluate(problem.gap, &extent.positions(cells, parts)?)?;
    let of_cell = gaps.chunks(parts[0] * parts[1]);
    let least = of_cell.map(|gaps| gaps.iter().copied().fold(f64::INFINITY, f64::min));
    Field::from_vec(extent.grid(cells)?, least.collect())
}

/// Returns the given extent, widened to the cells outside it where the bodies overlap. Returns `None` without such cells. The
/// displacements are computed on a coarse grid over the whole region.
pub(super) fn overlap_outside(
    problem: &AdaptiveProblem<'_>,
    extent: Extent,
    normal: &NormalSolution,
) -> Result<Option<Extent>> {
    let whole = problem.region.whole;
    if extent == whole {
        return Ok(None);
    }
    let cells = search_cells(problem);
    let bodies = bodies(problem, whole, cells)?;
    let grid = bodies.grid();
    let gap = least_gaps(problem, whole, cells)?;
    let [nx, ny] = cells;
    let place = |axis: usize, at: f64| {
        let side = [grid.dx(), grid.dy()][axis];
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "an index within the grid"
        )]
        let index = ((at - whole.ends[axis][0]) / side).max(0.0) as usize;
        index.min(cells[axis] - 1)
    };
    let mut pressure = Field::zeros(grid);
    let (fine, centre) = (normal.grid(), extent.centre());
    let share = fine.cell_area() / grid.cell_area();
    for (i, p) in normal
        .pressure()
        .iter()
        .enumerate()
        .filter(|(_, p)| **p > 0.0)
    {
        let [x, y] = fine.position(i % fine.nx(), i / fine.nx());
        let (ix, iy) = (place(0, centre[0] + x), place(1, centre[1] + y));
        pressure.as_mut_slice()[iy * nx + ix] += share * p;
    }
    let operator = bodies.operator(Component::ZZ)?;
    let mut displacement = Field::zeros(grid);
    let mut scratch = operator.scratch()?;
    let out = [displacement.as_mut_slice()];
    operator.apply([pressure.as_slice()], out, &mut scratch);
    let least = gap.min();
    let limit = LEAST_OVERLAP * (normal.approach() - least);
    let mut wider = extent;
    for iy in 0..ny {
        for ix in 0..nx {
            let i = iy * nx + ix;
            let overlap = normal.approach() - gap.as_slice()[i] - displacement.as_slice()[i];
            let ends = [(0, ix), (1, iy)].map(|(axis, index)| {
                let side = [grid.dx(), grid.dy()][axis];
                let start = whole.ends[axis][0] + index as f64 * side;
                [start, start + side]
            });
            let is_outside = (0..2).any(|axis| {
                ends[axis][1] <= extent.ends[axis][0] || ends[axis][0] >= extent.ends[axis][1]
            });
            if is_outside && overlap > limit {
                for (wider, ends) in wider.ends.iter_mut().zip(ends) {
                    *wider = [wider[0].min(ends[0]), wider[1].max(ends[1])];
                }
            }
        }
    }
    Ok((wider != extent).then_some(wider))
}

/// Returns for each cell the difference between the gap at a point inside the cell and the cubic interpolation of the gaps at
/// the centres. The points vary from cell to cell, so that no periodic gap has the same phase at all points.
pub(super) fn gap_inside_cells(
    problem: &AdaptiveProblem<'_>,
    extent: Extent,
    gap: &Field,
) -> Result<Vec<f64>> {
    let grid = gap.grid();
    let [nx, ny] = grid.size();
    let centre = extent.centre();
    let offset = |i: usize, axis: usize| match grid.size()[axis] {
        1 => 0.0,
        _ => golden(i, axis),
    };
    let position = |i: usize| {
        let [x, y] = grid.position(i % nx, i / nx);
        let (ox, oy) = (offset(i, 0) * grid.dx(), offset(i, 1) * grid.dy());
        [centre[0] + x + ox, centre[1] + y + oy]
    };
    let positions = fallible::collected(grid.cells(), (0..grid.cells()).map(position))?;
    let mut found = evaluate(problem.gap, &positions)?;
    let values = gap.as_slice();
    for (i, found) in found.iter_mut().enumerate() {
        let column = LagrangeStencil::at((i % nx) as f64 + offset(i, 0), nx, CUBIC);
        let row = LagrangeStencil::at((i / nx) as f64 + offset(i, 1), ny, CUBIC);
        *found -= row.apply(|iy| column.apply(|ix| values[iy * nx + ix]));
    }
    Ok(found)
}

/// Returns the largest height in each separated cell by which the gap is below its cubic interpolation between the centres. The
/// points have the distances of the points of the search, or less. The height is zero in contact cells, in cells whose gap exceeds
/// the approach, and in cells that are smaller than these distances.
pub(super) fn bumps_inside_cells(
    problem: &AdaptiveProblem<'_>,
    extent: Extent,
    gap: &Field,
    normal: &NormalSolution,
) -> Result<Vec<f64>> {
    let (grid, whole) = (gap.grid(), problem.region.whole.sides());
    let [nx, ny] = grid.size();
    let (sides, searched) = ([grid.dx(), grid.dy()], search_cells(problem));
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "a number of points, at most that of the search"
    )]
    let parts = [0, 1].map(|axis| match searched[axis] {
        1 => 1,
        cells => (sides[axis] * (cells * SEARCH_PARTS) as f64 / whole[axis]).ceil() as usize,
    });
    let mut bumps = fallible::zeros(grid.cells())?;
    if parts == [1; 2] {
        return Ok(bumps);
    }
    let positions = extent.positions([nx, ny], parts)?;
    let found = evaluate(problem.gap, &positions)?;
    let (values, count) = (gap.as_slice(), parts[0] * parts[1]);
    let stencil = |axis: usize, cells: usize, position: [f64; 2]| {
        let place = (position[axis] - extent.ends[axis][0]) / sides[axis] - 0.5;
        LagrangeStencil::at(place, cells, CUBIC)
    };
    let pressure = normal.pressure().as_slice();
    for (point, (position, found)) in positions.iter().zip(&found).enumerate() {
        if pressure[point / count] > 0.0 || *found >= normal.approach() {
            continue;
        }
        let (column, row) = (stencil(0, nx, *position), stencil(1, ny, *position));
        let expected = row.apply(|iy| column.apply(|ix| values[iy * nx + ix]));
        let bump = &mut bumps[point / count];
        *bump = bump.max(expected - found);
    }
    Ok(bumps)
}

/// Returns a number between -0.5 and 0.5 for each cell and axis, from a sequence that fills the interval evenly.
fn golden(i: usize, axis: usize) -> f64 {
    // The fractional parts of multiples of these numbers are evenly distributed over the square.
    let step = [0.754_877_666_246_692_7, 0.569_840_290_998_053_3][axis];
    (step * i as f64).fract() - 0.5
}
