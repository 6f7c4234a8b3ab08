//! Properties of a map of contact: area, edge, spots.

use std::array::from_fn;

use crate::buffer;
use crate::error::Result;
use crate::grid::Grid;
use crate::neighbours::neighbours;
use crate::warning::{RESOLVED, Resolution, Warning};

/// The cells of a whole grid that belong to a set, as every rank knows them.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Bits {
    /// A bit for each cell; every row begins with a word of its own.
    words: Vec<u64>,
    columns: usize,
}

impl Bits {
    pub(crate) fn new(words: Vec<u64>, columns: usize) -> Self {
        Self { words, columns }
    }

    /// Whether a cell belongs to it.
    pub(crate) fn contain(&self, cell: usize) -> bool {
        let (column, row) = (cell % self.columns, cell / self.columns);
        let word = self.words[row * self.columns.div_ceil(64) + column / 64];
        (word >> (column % 64)) & 1 != 0
    }
}

/// A map of the cells that belong to a set.
pub(crate) struct ContactMap<F> {
    pub(crate) grid: Grid,
    /// Whether it repeats along x and along y.
    pub(crate) repeats: [bool; 2],
    pub(crate) contains: F,
}

impl<F: Fn(usize) -> bool> ContactMap<F> {
    /// Cells in the set.
    pub(crate) fn cells(&self) -> usize {
        (0..self.grid.cells())
            .filter(|&i| (self.contains)(i))
            .count()
    }

    /// Area by counting cells.
    pub(crate) fn area(&self) -> f64 {
        self.cells() as f64 * self.grid.cell_area()
    }

    /// Area minus the excess from counting cells along the perimeter: `(pi - 1 + ln 2)/24` of a cell for
    /// each pair of neighbours of which one is in the set (Yastrebov, Anciaux & Molinari, Tribology
    /// International 114 (2017) 161, <https://doi.org/10.1016/j.triboint.2017.04.023>).
    pub(crate) fn corrected_area(&self) -> f64 {
        let share = (std::f64::consts::PI - 1.0 + std::f64::consts::LN_2) / 24.0;
        let cells = self.cells() as f64 - share * self.switches() as f64;
        cells.max(0.0) * self.grid.cell_area()
    }

    /// Columns and rows spanned by the set, from its first to its last cell; on a periodic grid, the smallest span that
    /// holds all of it, across the edges too. `None` if the set is empty.
    pub(crate) fn extent(&self) -> Option<[usize; 2]> {
        let (nx, ny) = (self.grid.nx(), self.grid.ny());
        let (mut columns, mut rows) = (vec![false; nx], vec![false; ny]);
        for i in (0..self.grid.cells()).filter(|&i| (self.contains)(i)) {
            (columns[i % nx], rows[i / nx]) = (true, true);
        }
        let [along_x, along_y] = self.repeats;
        Some([span(&columns, along_x)?, span(&rows, along_y)?])
    }

    /// Pairs of neighbours, along x or y, of which exactly one is in the set.
    pub(crate) fn switches(&self) -> usize {
        let contains = &self.contains;
        (0..self.grid.cells())
            .map(|i| {
                let [left, below, ..] = self.neighbours(i);
                let others = [left, below].into_iter().flatten();
                others.filter(|&j| contains(i) != contains(j)).count()
            })
            .sum()
    }

    /// All warnings, or the error of memory that cannot be had.
    pub(crate) fn warnings(&self) -> Result<Vec<Warning>> {
        if self.cells() == 0 {
            return Ok(vec![Warning::NoContact]);
        }
        let mut warnings = Vec::new();
        let cells = self.cells_on_edge();
        if cells > 0 {
            warnings.push(Warning::ContactAtEdge { cells });
        }
        let spots = self.survey_spots()?;
        let [columns, rows] = self.grid.size();
        let repeats = self.repeats;
        let across = |axis: usize| spots.iter().any(|spot| spot.edges[axis] == [true; 2]);
        let [along_x, along_y] = from_fn(|axis| !repeats[axis] && across(axis));
        if repeats == [false; 2] && columns.min(rows) == 1 && columns.max(rows) > 1 {
            warnings.push(Warning::LineOfCells);
        } else if along_x || along_y {
            warnings.push(Warning::ContactAcross { along_x, along_y });
        }
        let unresolved = spots.iter().filter(|spot| spot.cells < RESOLVED).count();
        if unresolved == 0 {
            let contact = Resolution::of_contact(self.grid, self.cells());
            warnings.extend(contact.contact_warning());
        } else {
            warnings.push(Warning::UnresolvedSpots {
                unresolved,
                spots: spots.len(),
            });
        }
        Ok(warnings)
    }

    /// Cells on the radius of a spot of mean size, of a line on half its width; zero without spots.
    pub(crate) fn cells_per_radius(&self) -> Result<f64> {
        let spots = self.survey_spots()?.len().max(1);
        let cells = self.cells() as f64 / spots as f64;
        let is_line = self.grid.size().contains(&1);
        Ok(if is_line {
            0.5 * cells
        } else {
            (cells / std::f64::consts::PI).sqrt()
        })
    }

    /// Size and place of each spot.
    fn survey_spots(&self) -> Result<Vec<Surveyed>> {
        let mut spots: Vec<Surveyed> = Vec::new();
        let last = self.grid.size().map(|count| signed(count) - 1);
        self.walk_spots(|spot, _, place| {
            if spots.len() <= spot {
                buffer::push(&mut spots, Surveyed::default())?;
            }
            let Surveyed { cells, edges } = &mut spots[spot];
            *cells += 1;
            for axis in 0..2 {
                edges[axis][0] |= place[axis] == 0;
                edges[axis][1] |= place[axis] == last[axis];
            }
            Ok(())
        })?;
        Ok(spots)
    }

    fn neighbours(&self, i: usize) -> [Option<usize>; 4] {
        neighbours(i, self.grid.size(), self.repeats)
    }

    /// Contact cells on the edge of a grid that has edges.
    pub(crate) fn cells_on_edge(&self) -> usize {
        let ([along_x, along_y], [nx, ny]) = (self.repeats, self.grid.size());
        let edge = (0..ny).flat_map(|iy| {
            let is_end = !along_y && (iy == 0 || iy + 1 == ny);
            let inner = if along_x { nx } else { (nx - 1).max(1) };
            let stride = if is_end { 1 } else { inner };
            let first = if is_end || !along_x { 0 } else { nx };
            (first..nx).step_by(stride).map(move |ix| iy * nx + ix)
        });
        edge.filter(|&i| (self.contains)(i)).count()
    }

    /// Calls `show` once for every cell of every spot (a set connected through cell sides): number of the spot, cell, and
    /// its column and row; on a periodic grid these continue beyond the edges from the spot's first cell. Ends with the first
    /// error of `show`, and where memory cannot be had.
    pub(crate) fn walk_spots(
        &self,
        mut show: impl FnMut(usize, usize, [isize; 2]) -> Result<()>,
    ) -> Result<()> {
        let mut visited = buffer::filled(false, self.grid.cells())?;
        let (mut spot, mut stack) = (0, Vec::new());
        let nx = self.grid.nx();
        for seed in 0..visited.len() {
            if visited[seed] || !(self.contains)(seed) {
                continue;
            }
            visited[seed] = true;
            let place = [signed(seed % nx), signed(seed / nx)];
            buffer::push(&mut stack, (seed, place))?;
            while let Some((cell, [column, row])) = stack.pop() {
                show(spot, cell, [column, row])?;
                let places = [[-1, 0], [0, -1], [1, 0], [0, 1]];
                for (next, [x, y]) in self.neighbours(cell).into_iter().zip(places) {
                    let Some(next) = next else { continue };
                    if !visited[next] && (self.contains)(next) {
                        visited[next] = true;
                        buffer::push(&mut stack, (next, [column + x, row + y]))?;
                    }
                }
            }
            spot += 1;
        }
        Ok(())
    }

    /// The sides of a cell along y and along x beyond which the set ends.
    pub(crate) fn open_sides(&self, cell: usize) -> [usize; 2] {
        let [left, below, right, above] = self
            .neighbours(cell)
            .map(|next| usize::from(next.is_none_or(|next| !(self.contains)(next))));
        [left + right, below + above]
    }
}

/// A spot as the warnings need it.
#[derive(Debug, Clone, Copy, Default)]
struct Surveyed {
    cells: usize,
    /// Whether it touches the first column and the last, the first row and the last.
    edges: [[bool; 2]; 2],
}

/// Places from the first taken one to the last; where they repeat, all places except the longest run of free ones.
fn span(taken: &[bool], repeats: bool) -> Option<usize> {
    let first = taken.iter().position(|taken| *taken)?;
    let last = taken.iter().rposition(|taken| *taken)?;
    let within = last + 1 - first;
    if !repeats {
        return Some(within);
    }
    let runs = taken[first..=last].split(|taken| *taken).map(<[bool]>::len);
    let longest = runs.max().unwrap_or(0).max(taken.len() - within);
    Some(taken.len() - longest)
}

/// A place in memory as a signed one: no slice is longer than `isize::MAX`.
fn signed(place: usize) -> isize {
    isize::try_from(place).unwrap_or(isize::MAX)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn sizes(map: &ContactMap<impl Fn(usize) -> bool>) -> Vec<usize> {
        let spots = map.survey_spots().unwrap();
        spots.iter().map(|spot| spot.cells).collect()
    }

    #[test]
    fn spots_edges_and_switches_of_a_drawn_map() {
        let drawing = "..##....\
                       ..#...#.\
                       ......#.\
                       ####....";
        let cells: Vec<bool> = drawing.chars().map(|c| c == '#').collect();
        let mut map = ContactMap {
            grid: Grid::new(8, 4, 0.5, 0.5).unwrap(),
            repeats: [false; 2],
            contains: |i: usize| cells[i],
        };
        assert_eq!(map.cells(), 9);
        assert_eq!(sizes(&map), [3, 2, 4]);
        assert_eq!(map.cells_on_edge(), 2 + 4);
        assert_eq!(map.extent(), Some([7, 4]));
        // 3 + 2 around the L within the grid, 6 around the bar, 5 beside the row at the bottom.
        assert_eq!(map.switches(), 6 + 6 + 5);
        let unresolved = Warning::UnresolvedSpots {
            unresolved: 3,
            spots: 3,
        };
        assert_eq!(
            map.warnings().unwrap(),
            [Warning::ContactAtEdge { cells: 6 }, unresolved]
        );

        // On the periodic grid the row at the bottom meets the L at the top; two of its cells and one end do not.
        map.repeats = [true; 2];
        assert_eq!(sizes(&map), [7, 2]);
        // Columns 4, 5 and 7 are free, and no row is.
        assert_eq!(map.extent(), Some([6, 4]));
        assert_eq!(map.switches(), 6 + 6 + 5 + 3);
        let unresolved = Warning::UnresolvedSpots {
            unresolved: 1,
            spots: 2,
        };
        assert_eq!(map.warnings().unwrap(), [unresolved]);
    }

    #[test]
    fn a_grid_of_one_row_wraps_onto_itself() {
        let map = ContactMap {
            grid: Grid::new(4, 1, 1.0, 1.0).unwrap(),
            repeats: [true; 2],
            contains: |i: usize| i == 0 || i == 3,
        };
        assert_eq!(sizes(&map), [2]);
        assert_eq!(map.switches(), 2);
        assert_eq!(map.extent(), Some([2, 1]));
    }
}
