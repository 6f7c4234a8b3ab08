//! Blocks of cells, whose tractions act on a distant point like forces at a few nodes.
//!
//! The functions under the integrals are interpolated at the Chebyshev nodes of the block, so the sum over its cells becomes a
//! sum over its nodes. The force at a node is the integral of the traction times the cardinal function of the node. It does not
//! depend on the point.
//!
//! # Error
//!
//! Along one axis of the block, the functions are analytic except where the distance to the point vanishes. Let `x` and `d` be
//! the distances of the point from the middle of the block along and across the axis. The distance vanishes at the positions
//! `x ± i d`. For a half side `h` these positions lie on the ellipse around the side with the parameter
//!
//! ```math
//! \rho + \frac1\rho = \frac{1}{h} \left[\sqrt{(x - h)^2 + d^2} + \sqrt{(x + h)^2 + d^2}\right] .
//! ```
//!
//! The error of interpolation at `n` nodes decreases like `rho^-n` (Trefethen, Approximation Theory and Approximation Practice,
//! 2013, theorem 8.2). The largest error of the derivatives of the potentials in the stresses is about `0.6 n^2 rho^-n`, relative
//! to the stress `1/(2 pi r^2)` of a unit force at the distance `r`. With `rho >= 4` along both axes and 24 nodes it is 1.2e-12.

use std::ops::Range;

use crate::error::Result;
use crate::grid::Grid;
use crate::memory::fallible;
use crate::observer::WorkObserver;
use crate::parallel::{self, Blocks};
use crate::subsurface::cardinal::{self, NODES, PerNode};
use crate::subsurface::direct_sum::{Row, row};
use crate::subsurface::kernel::{PointForceSums, add_point_forces};

/// Number of cells in the smallest blocks.
const CELLS: usize = 64;
/// Number of cells up to which a sum over the cells costs no more than a sum over the nodes of their block.
const FEW: usize = 12;
/// Smallest sum of the distances from a point to both ends of a side, in sides. It belongs to `rho = 4`.
const FAR: f64 = 2.125;
/// Number of blocks whose forces are computed between two calls of an observer.
const PORTION: usize = 256;
/// Number of nodes that are evaluated together in vector registers.
pub(super) const LANES: usize = 4;
const SQUARE: usize = NODES * NODES;

/// Block of cells.
#[derive(Debug)]
struct Block {
    /// The sides are the sides of the smallest blocks times two to this power.
    level: usize,
    /// First column and row.
    first: [usize; 2],
    /// Index of the first block after the parts of this block, which follow it.
    next: usize,
    /// Rows of loaded cells, in a block without parts.
    rows: Range<usize>,
    /// Number of cells in the rows of the block and its parts.
    cells: usize,
    /// Index of the forces, unless the block has few cells.
    forces: Option<usize>,
}

/// Integrals over each cell of a block along x and y, for one level.
type Level = [Vec<PerNode>; 2];

/// All blocks with loaded cells, each before its parts.
pub(super) struct BlockTree<'a> {
    grid: Grid,
    fields: [Option<&'a [f64]>; 3],
    /// Sides of the smallest blocks, in cells.
    sides: [usize; 2],
    nodes: PerNode,
    blocks: Vec<Block>,
    rows: Vec<Row>,
    /// Forces along each loaded axis at the nodes, by block, traction, row and column of nodes.
    forces: Vec<f64>,
}

impl<'a> BlockTree<'a> {
    /// Divides the cells of the given rows into blocks. The list of rows must not be empty.
    pub(super) fn new(
        grid: Grid,
        fields: [Option<&'a [f64]>; 3],
        rows: &[Row],
        watch: &mut WorkObserver<'_>,
    ) -> Result<Self> {
        let mut tree = Self {
            grid,
            fields,
            sides: sides(grid),
            nodes: cardinal::nodes(),
            blocks: Vec::new(),
            rows: Vec::new(),
            forces: Vec::new(),
        };
        let mut first = [usize::MAX; 2];
        let mut end = [0; 2];
        for (iy, columns) in rows {
            first = [first[0].min(columns.start), first[1].min(*iy)];
            end = [end[0].max(columns.end), end[1].max(iy + 1)];
        }
        let extent = [0, 1].map(|axis| end[axis] - first[axis]);
        let mut top = 0;
        while (0..2).any(|axis| tree.sides[axis] << top < extent[axis]) {
            top += 1;
        }
        tree.add(top, first)?;
        tree.set_forces(top, watch)?;
        Ok(tree)
    }

    /// Adds a block and its parts, unless they have no loaded cells.
    fn add(&mut self, level: usize, first: [usize; 2]) -> Result<()> {
        let [nx, ny] = self.grid.size();
        if first[0] >= nx || first[1] >= ny {
            return Ok(());
        }
        let (index, start) = (self.blocks.len(), self.rows.len());
        let block = Block {
            level,
            first,
            next: index + 1,
            rows: start..start,
            cells: 0,
            forces: None,
        };
        fallible::push(&mut self.blocks, block)?;
        if level == 0 {
            let [width, height] = self.sides;
            let columns = first[0]..nx.min(first[0] + width);
            for iy in first[1]..ny.min(first[1] + height) {
                if let Some(row) = row(&self.fields, nx, iy, columns.clone()) {
                    fallible::push(&mut self.rows, row)?;
                }
            }
        } else {
            let [width, height] = self.sides.map(|side| side << (level - 1));
            for y in [first[1], first[1] + height] {
                for x in [first[0], first[0] + width] {
                    self.add(level - 1, [x, y])?;
                }
            }
        }
        let cells = self.rows[start..].iter().map(|(_, columns)| columns.len());
        let cells: usize = cells.sum();
        if cells == 0 {
            self.blocks.truncate(index);
            return Ok(());
        }
        let next = self.blocks.len();
        let block = &mut self.blocks[index];
        block.next = next;
        block.cells = cells;
        if level == 0 {
            block.rows.end = self.rows.len();
        }
        Ok(())
    }

    /// Computes the forces at the nodes of all blocks that have more than a few cells.
    fn set_forces(&mut self, top: usize, watch: &mut WorkObserver<'_>) -> Result<()> {
        let (dx, dy) = (self.grid.dx(), self.grid.dy());
        let mut levels = fallible::with_room::<Level>(top + 1)?;
        for level in 0..=top {
            let [width, height] = self.sides.map(|side| side << level);
            levels.push([
                cardinal::integrals(width, 0.5 * dx)?,
                cardinal::integrals(height, 0.5 * dy)?,
            ]);
        }
        let mut large = fallible::with_room(self.blocks.len())?;
        for (index, block) in self.blocks.iter_mut().enumerate() {
            if block.cells > FEW {
                block.forces = Some(large.len());
                large.push(index);
            }
        }
        let width = self.width();
        let mut forces = fallible::zeros(width * large.len())?;
        let tree = &*self;
        for (large, items) in large
            .chunks(PORTION)
            .zip(forces.chunks_mut(PORTION * width))
        {
            watch.notify_observer()?;
            let work = |task: usize, forces: Blocks<'_, f64>| {
                let block = &tree.blocks[large[task]];
                tree.set_forces_of(block, &levels[block.level], forces.items);
            };
            parallel::sweep(0..large.len(), Blocks { items, width }, &work, &|(), ()| ());
        }
        self.forces = forces;
        Ok(())
    }

    /// Returns the number of forces of a block.
    fn width(&self) -> usize {
        SQUARE * self.fields.iter().flatten().count()
    }

    fn set_forces_of(&self, block: &Block, [along_x, along_y]: &Level, forces: &mut [f64]) {
        let ([first_x, first_y], nx) = (block.first, self.grid.nx());
        let columns = first_x..nx.min(first_x + along_x.len());
        for (field, forces) in self.fields.iter().flatten().zip(forces.chunks_mut(SQUARE)) {
            let rows = field.chunks(nx).skip(first_y);
            for (row, factors_y) in rows.zip(along_y) {
                let mut sums = [0.0; NODES];
                let mut is_loaded = false;
                for (&traction, factors_x) in row[columns.clone()].iter().zip(along_x) {
                    if traction != 0.0 {
                        is_loaded = true;
                        for (sum, factor) in sums.iter_mut().zip(factors_x) {
                            *sum += factor * traction;
                        }
                    }
                }
                if is_loaded {
                    for (forces, factor) in forces.chunks_mut(NODES).zip(factors_y) {
                        for (force, sum) in forces.iter_mut().zip(&sums) {
                            *force += factor * sum;
                        }
                    }
                }
            }
        }
    }

    /// Returns the largest number of cells in a row of a near block.
    pub(super) fn longest_row(&self) -> usize {
        self.sides[0]
    }

    /// Adds the effects of all distant blocks, and passes the rows of each near block to a function. The tractions along x and y
    /// are multiplied by `sign`.
    pub(super) fn add_to(
        &self,
        sums: &mut PointForceSums<LANES>,
        [x, y, z]: [f64; 3],
        [e, sign]: [f64; 2],
        mut add_rows: impl FnMut(&[Row]),
    ) {
        let half_cell = [0.5 * self.grid.dx(), 0.5 * self.grid.dy()];
        let mut index = 0;
        while let Some(block) = self.blocks.get(index) {
            let sides = self.sides.map(|side| side << block.level);
            let half = [0, 1].map(|axis| half_cell[axis] * sides[axis] as f64);
            // Twice the distance from the middle of the grid to the middle of the block, in cells.
            let doubled = [0, 1].map(|axis| 2 * block.first[axis] + sides[axis]);
            let middle = [0, 1].map(|axis| {
                half_cell[axis] * (doubled[axis] as f64 - self.grid.size()[axis] as f64)
            });
            let point = [x - middle[0], y - middle[1], z];
            index = match block.forces {
                Some(forces) if is_far(point, half) => {
                    let width = self.width();
                    let forces = &self.forces[forces * width..(forces + 1) * width];
                    self.add_block(sums, point, half, [e, sign], forces);
                    block.next
                }
                _ => {
                    add_rows(&self.rows[block.rows.clone()]);
                    index + 1
                }
            };
        }
    }

    fn add_block(
        &self,
        sums: &mut PointForceSums<LANES>,
        [x, y, z]: [f64; 3],
        half: [f64; 2],
        [e, sign]: [f64; 2],
        forces: &[f64],
    ) {
        let xs = self.nodes.map(|node| x - half[0] * node);
        let (pressing, shearing) = forces.split_at(SQUARE);
        for (iy, node) in self.nodes.iter().enumerate() {
            let y = y - half[1] * node;
            for (ix, xs) in (0..NODES).step_by(LANES).zip(xs.chunks(LANES)) {
                let at = iy * NODES + ix;
                let lanes = |forces: &[f64]| match forces.get(at..) {
                    Some(forces) => forces.first_chunk().copied().unwrap_or_default(),
                    None => [0.0; LANES],
                };
                let [qx, qy] = [0, SQUARE].map(|start| shearing.get(start..));
                let [qx, qy] = [qx, qy].map(|q| lanes(q.unwrap_or_default()).map(|q| sign * q));
                let Some(xs) = xs.first_chunk() else { continue };
                add_point_forces(sums, [&lanes(pressing), &qx, &qy], xs, [y, z], e);
            }
        }
    }
}

/// Returns the sides of the smallest blocks in cells, powers of two, so that the blocks are as square as possible.
fn sides(grid: Grid) -> [usize; 2] {
    let mut sides = [CELLS, 1];
    while sides[0] > 1 && grid.dx() * sides[0] as f64 > 1.5 * grid.dy() * sides[1] as f64 {
        sides = [sides[0] / 2, 2 * sides[1]];
    }
    sides
}

/// Returns whether the sum over the nodes of a block of these half sides is accurate at a point relative to its middle.
fn is_far([x, y, z]: [f64; 3], [a, b]: [f64; 2]) -> bool {
    let along = |x: f64, a: f64, y: f64, b: f64| {
        // Smallest distance from the point across the axis.
        let across = (y.abs() - b).max(0.0);
        let squares = across * across + z * z;
        let [near, far] = [x - a, x + a].map(|end| (end * end + squares).sqrt());
        near + far >= FAR * (2.0 * a)
    };
    along(x, a, y, b) && along(y, b, x, a)
}
