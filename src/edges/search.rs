//! The cells at the edge of a set, with or without a fit.

use crate::edges::fit::{Fit, FitValues};
use crate::edges::outline::{Corners, outline};
use crate::edges::states::{States, beside};
use crate::edges::stencil::{FitStencil, LANES, SIDE};
use crate::edges::{EdgeCell, Edges};
use crate::error::Result;
use crate::grid::Grid;
use crate::grid::field::Field;
use crate::grid::neighbours::neighbours;
use crate::memory::fallible;
use crate::parallel::{self, Blocks};

/// Largest residual of a fit (root mean square, in cells), for a contact and for a stick zone of a first loading.
pub(super) const LARGEST_MISS: f64 = 0.05;
/// Largest residual of a fit that uses only values inside (root mean square, in cells). Such a fit is extrapolated to the edge.
/// The extrapolation is reliable only if the values inside are nearly a quadratic, as under a sphere.
const LARGEST_MISS_INSIDE: f64 = 0.01;
/// Smallest number of values in a fit.
const FEWEST: usize = 10;
/// Smallest signed distance of the centre of a cell in the set from the edge (positive inside), in cells.
const LEAST_INSIDE: f64 = -0.45;
/// Largest signed distance of the centre of a cell outside the set from the edge (positive inside), in cells.
const MOST_OUTSIDE: f64 = 0.15;
/// Signed distance of a cell centre from the edge, in cells, beyond which a cell keeps its raw value.
const UNDISTURBED: f64 = 1.2;

/// Number of cells per task.
const PER_TASK: usize = 64;

/// Set of the cells with a positive value, and values inside and outside.
pub(super) struct Search<'a> {
    pub(super) grid: Grid,
    pub(super) repeats: [bool; 2],
    /// Pressure, or friction reserve of a stick zone.
    pub(super) inside: &'a [f64],
    /// Gap, or slip of a stick zone.
    pub(super) outside: &'a [f64],
    /// Whether a cell outside has a value that obeys the asymptotics of the edge.
    pub(super) is_outside_known: &'a (dyn Fn(usize) -> bool + Sync),
    /// Modulus at a cell for a normal of the edge.
    pub(super) modulus: &'a (dyn Fn(usize, [f64; 2]) -> f64 + Sync),
    /// Overestimate of the covered area by counting, per side of a cell at the edge. The unit is the area of a cell.
    pub(super) excess: f64,
    /// Largest residual of a fit (root mean square, in cells).
    pub(super) largest_miss: f64,
}

/// Cell at the edge. If it has been fitted, the distances of its corners from the edge are included.
#[derive(Clone, Copy, Default)]
struct EdgeCandidate {
    cell: EdgeCell,
    corners: Option<Corners>,
}

impl Search<'_> {
    pub(super) fn edges(&self) -> Result<Edges> {
        let largest = largest(self.inside);
        let states = States::new(self.grid, self.repeats, self.inside)?;
        let stencil = FitStencil::new(self.grid, self.repeats);
        let mut found = Vec::new();
        for index in states.at_edge() {
            let cell = EdgeCell {
                index,
                ..EdgeCell::default()
            };
            fallible::push(
                &mut found,
                EdgeCandidate {
                    cell,
                    corners: None,
                },
            )?;
        }
        let cells = self.inside.len();
        let lifted = self.lifted(&stencil, &found, largest)?;
        parallel::enter_with(cells, || {
            let tasks = found.len().div_ceil(PER_TASK);
            let data = Blocks {
                items: &mut found,
                width: PER_TASK,
            };
            let work = |_, block: Blocks<'_, EdgeCandidate>| {
                for found in block.items {
                    let values = self.values(&states, &stencil, found.cell.index, &lifted);
                    *found = self.examine(&stencil, &values, found.cell.index, largest);
                }
            };
            parallel::sweep(0..tasks, data, &work, &|(), ()| ());
        });
        self.gathered(&states, &found)
    }

    fn gathered(&self, states: &States, found: &[EdgeCandidate]) -> Result<Edges> {
        let mut centres = Field::try_zeros(self.grid)?;
        centres.as_mut_slice().copy_from_slice(self.inside);
        let mut means = Field::try_zeros(self.grid)?;
        parallel::rows(means.as_mut_slice(), self.grid.nx(), |row, means| {
            self.raw_means(states, row, means);
        });
        let mut covered = states.core_cells() as f64;
        for EdgeCandidate { cell, .. } in found {
            centres.as_mut_slice()[cell.index] = cell.centre;
            means.as_mut_slice()[cell.index] = cell.mean;
            covered += cell.covered;
        }
        let corners = found.iter().map(|found| (found.cell.index, found.corners));
        let corners = fallible::collected(found.len(), corners)?;
        Ok(Edges {
            outline: outline(self.grid, self.repeats, &corners, |i| self.contains(i))?,
            cells: fallible::collected(found.len(), found.iter().map(|found| found.cell))?,
            centres,
            means,
            repeats: self.repeats,
            area: covered * self.grid.cell_area(),
        })
    }

    fn contains(&self, cell: usize) -> bool {
        self.inside[cell] > 0.0
    }

    /// Returns the number of sides of a cell at which the set ends.
    fn open_sides(&self, cell: usize) -> usize {
        let is_open = |next: &Option<usize>| next.is_none_or(|next| !self.contains(next));
        let neighbours = neighbours(cell, self.grid.size(), self.repeats);
        neighbours.iter().filter(|next| is_open(next)).count()
    }

    fn examine(
        &self,
        stencil: &FitStencil,
        values: &FitValues,
        index: usize,
        largest: f64,
    ) -> EdgeCandidate {
        let fit = Fit::new(stencil, values, |normal| (self.modulus)(index, normal));
        let fit = fit.filter(|fit| {
            let centre = fit.distance([0.0; 2]);
            let agrees = if self.contains(index) {
                centre >= LEAST_INSIDE
            } else {
                centre <= MOST_OUTSIDE
            };
            // A strip that is two cells wide contains two edges.
            let is_wide = values.is_core.as_flattened().contains(&true);
            let largest_miss = if fit.has_outside {
                self.largest_miss
            } else {
                LARGEST_MISS_INSIDE.min(self.largest_miss)
            };
            agrees && is_wide && fit.missed <= largest_miss && fit.count >= FEWEST
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
        EdgeCandidate {
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

    /// Returns the raw value of a cell without a fit.
    fn refused(&self, index: usize) -> EdgeCandidate {
        let cell = if self.contains(index) {
            EdgeCell {
                index,
                covered: 1.0 - self.excess * self.open_sides(index) as f64,
                centre: self.inside[index],
                mean: self.inside[index],
                is_fitted: false,
            }
        } else {
            EdgeCell {
                index,
                ..EdgeCell::default()
            }
        };
        EdgeCandidate {
            cell,
            corners: None,
        }
    }

    /// Writes the means of a smooth pressure over the core cells of a row, given the values at the centres.
    fn raw_means(&self, states: &States, row: usize, means: &mut [f64]) {
        let [nx, ny] = self.grid.size();
        // Core cells have all their neighbours, so rows at a free edge of the grid contain no core cells.
        let [Some(below), Some(above)] = beside(row, ny, self.repeats[1]) else {
            return;
        };
        let [below, middle, above] = [below, row, above].map(|row| &self.inside[row * nx..][..nx]);
        let cells = means.iter_mut().zip(states.are_core(row)).enumerate();
        for (column, (mean, _)) in cells.filter(|(_, (_, is_core))| *is_core) {
            if let [Some(left), Some(right)] = beside(column, nx, self.repeats[0]) {
                let around = (middle[left] + middle[right]) + (below[column] + above[column]);
                let difference = around - 4.0 * middle[column];
                *mean = (middle[column] + difference / 24.0).max(0.0);
            }
        }
    }

    /// Returns the quantity with a uniform slope at the edge, for all cells around the found cells. The quantity is the square of
    /// the pressure inside and the negated 2/3 power of the gap outside, as in [`FitValues`]. It is zero for all other cells.
    fn lifted(
        &self,
        stencil: &FitStencil,
        found: &[EdgeCandidate],
        largest: f64,
    ) -> Result<Vec<f64>> {
        let mut lifted = fallible::zeros(self.inside.len())?;
        let scale = 0.75 / (largest * stencil.unit);
        for found in found {
            let [rows, columns] = stencil.about(found.cell.index);
            for row in rows.into_iter().flatten() {
                for column in columns.into_iter().flatten() {
                    let cell = row * self.grid.nx() + column;
                    if lifted[cell] == 0.0 {
                        lifted[cell] = if self.contains(cell) {
                            (self.inside[cell] / largest).powi(2)
                        } else {
                            -(scale * self.outside[cell].max(0.0)).cbrt().powi(2)
                        };
                    }
                }
            }
        }
        Ok(lifted)
    }

    fn values(
        &self,
        states: &States,
        stencil: &FitStencil,
        index: usize,
        lifted: &[f64],
    ) -> FitValues {
        let mut values = FitValues {
            lifted: [[0.0; LANES]; SIDE],
            is_inside: [[false; LANES]; SIDE],
            is_core: [[false; LANES]; SIDE],
            weights: [[0.0; LANES]; SIDE],
        };
        let [rows, columns] = stencil.about(index);
        for (j, row) in rows.into_iter().enumerate() {
            let Some(row) = row else { continue };
            for (i, column) in columns.into_iter().enumerate() {
                let Some(column) = column else { continue };
                let cell = row * self.grid.nx() + column;
                let is_inside = self.contains(cell);
                values.lifted[j][i] = lifted[cell];
                values.is_inside[j][i] = is_inside;
                values.is_core[j][i] = is_inside && states.is_core(cell);
                if is_inside || (self.is_outside_known)(cell) {
                    values.weights[j][i] = stencil.weights[j][i];
                }
            }
        }
        values
    }
}

/// Returns the largest value, or zero. Several lanes are compared in parallel.
fn largest(values: &[f64]) -> f64 {
    let mut most = [0.0_f64; LANES];
    for values in values.chunks(LANES) {
        for (most, value) in most.iter_mut().zip(values) {
            *most = most.max(*value);
        }
    }
    most.into_iter().fold(0.0, f64::max)
}
