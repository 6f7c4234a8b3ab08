//! The cells at the edge of a set, each with its fit or without.

use crate::buffer;
use crate::edges::fit::{Fit, Values};
use crate::edges::outline::{Corners, outline};
use crate::edges::stencil::{CELLS, Stencil};
use crate::edges::{EdgeCell, Edges};
use crate::error::Result;
use crate::field::Field;
use crate::grid::Grid;
use crate::neighbours::{neighbours, second_difference};
use crate::parallel::{self, Blocks};

/// Largest root mean square by which a fit may miss the values, in cells.
const LARGEST_MISS: f64 = 0.05;
/// Fewest values of a fit.
const FEWEST: usize = 10;
/// Distances of a centre from the edge, in cells, that contradict the state of the cell, and from which on its own value is
/// right.
const LEAST_INSIDE: f64 = -0.45;
const MOST_OUTSIDE: f64 = 0.15;
const UNDISTURBED: f64 = 1.2;

/// Cells that a task fits.
const PER_TASK: usize = 64;

/// A set of cells, those with a positive value inside, and what is known beside it.
pub(super) struct Search<'a> {
    pub(super) grid: Grid,
    pub(super) repeats: [bool; 2],
    /// The pressure, or the like.
    pub(super) inside: &'a [f64],
    /// The gap, or the like.
    pub(super) outside: &'a [f64],
    /// Whether a cell outside has one that obeys the law of the edge.
    pub(super) is_outside_known: &'a (dyn Fn(usize) -> bool + Sync),
    /// The modulus at a cell for a normal of the edge.
    pub(super) modulus: &'a (dyn Fn(usize, [f64; 2]) -> f64 + Sync),
    /// Part of a cell that a count takes too much for each side at the edge.
    pub(super) excess: f64,
}

/// A cell at the edge, and the distances of its corners from it if it has been fitted.
#[derive(Clone, Copy, Default)]
struct Found {
    cell: EdgeCell,
    corners: Option<Corners>,
}

impl Search<'_> {
    pub(super) fn edges(&self) -> Result<Edges> {
        let cells = self.inside.len();
        let largest = self.inside.iter().copied().fold(0.0, f64::max);
        let stencil = Stencil::new(self.grid, self.repeats);
        let indices = (0..cells)
            .filter(|i| self.is_at_edge(*i))
            .map(|index| Found {
                cell: EdgeCell {
                    index,
                    ..EdgeCell::default()
                },
                corners: None,
            });
        let mut found = Vec::new();
        for cell in indices {
            buffer::push(&mut found, cell)?;
        }
        parallel::enter_with(cells, || {
            let tasks = found.len().div_ceil(PER_TASK);
            let data = Blocks {
                items: &mut found,
                width: PER_TASK,
            };
            let work = |_, block: Blocks<'_, Found>| {
                for found in block.items {
                    *found = self.examine(&stencil, found.cell.index, largest);
                }
            };
            parallel::sweep(0..tasks, data, &work, &|(), ()| ());
        });
        self.gathered(&found)
    }

    fn gathered(&self, found: &[Found]) -> Result<Edges> {
        let mut centres = Field::try_zeros(self.grid)?;
        centres.as_mut_slice().copy_from_slice(self.inside);
        let mut means = Field::try_zeros(self.grid)?;
        parallel::update(means.as_mut_slice(), |first, chunk| {
            for (mean, i) in chunk.iter_mut().zip(first..) {
                *mean = if self.contains(i) {
                    self.raw_mean(i)
                } else {
                    0.0
                };
            }
        });
        let all = self.inside.iter().filter(|value| **value > 0.0).count();
        let counted = found.iter().filter(|found| self.contains(found.cell.index));
        let mut covered = (all - counted.count()) as f64;
        for Found { cell, .. } in found {
            centres.as_mut_slice()[cell.index] = cell.centre;
            means.as_mut_slice()[cell.index] = cell.mean;
            covered += cell.covered;
        }
        let corners = found.iter().map(|found| (found.cell.index, found.corners));
        Ok(Edges {
            outline: outline(self.grid, self.repeats, corners, |i| self.contains(i))?,
            cells: buffer::collected(found.len(), found.iter().map(|found| found.cell))?,
            centres,
            means,
            area: covered * self.grid.cell_area(),
        })
    }

    fn contains(&self, cell: usize) -> bool {
        self.inside[cell] > 0.0
    }

    fn neighbours(&self, cell: usize) -> [Option<usize>; 4] {
        neighbours(cell, self.grid.size(), self.repeats)
    }

    /// Sides of a cell beyond which the set ends.
    fn open_sides(&self, cell: usize) -> usize {
        let is_open = |next: &Option<usize>| next.is_none_or(|next| !self.contains(next));
        self.neighbours(cell)
            .iter()
            .filter(|next| is_open(next))
            .count()
    }

    fn is_core(&self, cell: usize) -> bool {
        self.contains(cell) && self.open_sides(cell) == 0
    }

    fn is_at_edge(&self, cell: usize) -> bool {
        if self.contains(cell) {
            return self.open_sides(cell) > 0;
        }
        let [left, below, right, above] = self.neighbours(cell);
        let is_in = |next: Option<usize>| next.is_some_and(|next| self.contains(next));
        // Diagonally: to the left and to the right of those below and above.
        let is_beside = |next: Option<usize>| {
            next.is_some_and(|next| {
                let [left, _, right, _] = self.neighbours(next);
                is_in(left) || is_in(right)
            })
        };
        [left, below, right, above].into_iter().any(is_in) || is_beside(below) || is_beside(above)
    }

    fn examine(&self, stencil: &Stencil, index: usize, largest: f64) -> Found {
        let values = self.values(stencil, index, largest);
        let fit = Fit::new(stencil, &values, |normal| (self.modulus)(index, normal));
        let fit = fit.filter(|fit| {
            let centre = fit.distance([0.0; 2]);
            let agrees = if self.contains(index) {
                centre >= LEAST_INSIDE
            } else {
                centre <= MOST_OUTSIDE
            };
            agrees && fit.missed <= LARGEST_MISS && fit.count >= FEWEST
        });
        let Some(fit) = fit else {
            return self.refused(index);
        };
        let [half_x, half_y] = stencil.sides.map(|side| 0.5 * side);
        let [covered, mean] = fit.covered_and_mean(stencil.sides);
        let is_undisturbed = self.contains(index) && fit.distance([0.0; 2]) > UNDISTURBED;
        let corners = [
            [-half_x, -half_y],
            [half_x, -half_y],
            [half_x, half_y],
            [-half_x, half_y],
        ];
        Found {
            cell: EdgeCell {
                index,
                covered,
                centre: if is_undisturbed {
                    self.inside[index]
                } else {
                    largest * fit.centre()
                },
                mean: largest * mean,
                is_fitted: true,
            },
            corners: Some(corners.map(|place| fit.distance(place))),
        }
    }

    /// The raw cell.
    fn refused(&self, index: usize) -> Found {
        let cell = if self.contains(index) {
            EdgeCell {
                index,
                covered: 1.0 - self.excess * self.open_sides(index) as f64,
                centre: self.inside[index],
                mean: self.raw_mean(index),
                is_fitted: false,
            }
        } else {
            EdgeCell {
                index,
                ..EdgeCell::default()
            }
        };
        Found {
            cell,
            corners: None,
        }
    }

    /// The mean over a cell of a smooth pressure with these values at the centres.
    fn raw_mean(&self, cell: usize) -> f64 {
        let difference = second_difference(self.inside, cell, self.grid.size(), self.repeats);
        (self.inside[cell] + difference / 24.0).max(0.0)
    }

    fn values(&self, stencil: &Stencil, index: usize, largest: f64) -> Values {
        let mut values = Values {
            inside: [0.0; CELLS],
            is_inside: [false; CELLS],
            is_core: [false; CELLS],
            outside: [0.0; CELLS],
            is_known: [false; CELLS],
        };
        let scale = 0.75 / (largest * stencil.unit);
        for (k, cell) in stencil.cells(index).into_iter().enumerate() {
            let Some(cell) = cell else { continue };
            values.is_inside[k] = self.contains(cell);
            if values.is_inside[k] {
                values.inside[k] = self.inside[cell] / largest;
                values.is_core[k] = self.is_core(cell);
                values.is_known[k] = true;
            } else {
                values.outside[k] = scale * self.outside[cell].max(0.0);
                values.is_known[k] = (self.is_outside_known)(cell);
            }
        }
        values
    }
}
