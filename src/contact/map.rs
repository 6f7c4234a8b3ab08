//! Properties of a contact map: area, edge and spots.

use std::array::from_fn;

use crate::contact::contact_counts::ContactCounts;
use crate::error::Result;
use crate::grid::Grid;
use crate::grid::boundary::Boundary;
use crate::half_space::HalfSpace;
use crate::memory::fallible::unwrap_or_abort;
use crate::warning::{Resolution, Warning};

/// A map of the cells that belong to a set.
pub(crate) struct ContactMap<'a, F> {
    pub(crate) grid: Grid,
    /// Whether the grid is periodic along x and along y.
    pub(crate) repeats: [bool; 2],
    pub(crate) contains: F,
    /// Counts over all ranks if each rank stores a slab. The map itself is then not evaluated.
    pub(crate) counted: Option<&'a ContactCounts>,
}

impl<'a, F: Fn(usize) -> bool + Sync> ContactMap<'a, F> {
    /// Creates the map of a solution. Without `counted`, as before a solve, the map contains only the local rows.
    pub(crate) fn of(
        grid: Grid,
        boundary: Boundary,
        contains: F,
        counted: Option<&'a ContactCounts>,
    ) -> Self {
        Self {
            grid: counted.map_or(grid, |_| grid.whole()),
            repeats: boundary.repeats(),
            contains,
            counted,
        }
    }
}

impl<F: Fn(usize) -> bool + Sync> ContactMap<'_, F> {
    /// Returns all counts.
    pub(crate) fn counts(&self) -> Result<ContactCounts> {
        self.counted
            .map_or_else(|| self.survey(None), |counted| Ok(*counted))
    }

    /// Returns the number of cells in the set.
    pub(crate) fn cells(&self) -> usize {
        if let Some(counted) = self.counted {
            return counted.cells;
        }
        (0..self.grid.cells())
            .filter(|&i| (self.contains)(i))
            .count()
    }

    /// Returns the area by counting cells.
    pub(crate) fn area(&self) -> f64 {
        self.cells() as f64 * self.grid.cell_area()
    }

    /// Returns the area minus the excess from counting cells along the perimeter. The excess is `(pi - 1 + ln 2)/24` of a cell
    /// for each pair of neighbours with exactly one cell in the set (Yastrebov, Anciaux & Molinari, Tribology International 114
    /// (2017) 161, <https://doi.org/10.1016/j.triboint.2017.04.023>).
    pub(crate) fn corrected_area(&self) -> f64 {
        let share = (std::f64::consts::PI - 1.0 + std::f64::consts::LN_2) / 24.0;
        let cells = self.cells() as f64 - share * self.switches() as f64;
        cells.max(0.0) * self.grid.cell_area()
    }

    /// Returns the number of pairs of neighbours along x or y with exactly one cell in the set.
    pub(crate) fn switches(&self) -> usize {
        if let Some(counted) = self.counted {
            return counted.switches;
        }
        let ([columns, rows], repeats) = (self.grid.size(), self.repeats);
        let switch = |i: usize, j: usize| usize::from((self.contains)(i) != (self.contains)(j));
        // Whole rows take fewer instructions than the neighbours of single cells.
        let switches_of = |row: usize| {
            let (first, last) = (row * columns, (row + 1) * columns - 1);
            let along: usize = (first..last).map(|i| switch(i, i + 1)).sum();
            let across_edge = if repeats[0] { switch(first, last) } else { 0 };
            let below = match row.checked_sub(1) {
                None => repeats[1].then(|| (rows - 1) * columns),
                Some(below) => Some(below * columns),
            };
            let across: usize = below.map_or(0, |below| {
                (0..columns).map(|i| switch(below + i, first + i)).sum()
            });
            along + across_edge + across
        };
        (0..rows).map(switches_of).sum()
    }

    /// Returns all warnings.
    pub(crate) fn warnings(&self) -> Result<Vec<Warning>> {
        let ContactCounts {
            cells,
            cells_on_edge,
            spots,
            ..
        } = self.counts()?;
        if cells == 0 {
            return Ok(vec![Warning::NoContact]);
        }
        let mut warnings = Vec::new();
        if cells_on_edge > 0 {
            warnings.push(Warning::ContactAtEdge {
                cells: cells_on_edge,
            });
        }
        let ([columns, rows], repeats) = (self.grid.size(), self.repeats);
        let [along_x, along_y] = from_fn(|axis| !repeats[axis] && spots.is_across[axis]);
        if repeats == [false; 2] && columns.min(rows) == 1 && columns.max(rows) > 1 {
            warnings.push(Warning::SingleRowOfCells);
        } else if along_x || along_y {
            warnings.push(Warning::ContactSpansGrid { along_x, along_y });
        }
        if spots.unresolved == 0 || 10 * spots.unresolved_cells < cells {
            let contact = Resolution::of_contact(self.grid, cells);
            warnings.extend(contact.contact_warning());
        } else {
            warnings.push(Warning::UnresolvedSpots {
                unresolved: spots.unresolved,
                spots: spots.all,
            });
        }
        Ok(warnings)
    }

    /// Returns the radius of a spot of mean size in cells, and the number of spots. For a line, half the width replaces the
    /// radius. The radius is zero without spots.
    pub(crate) fn mean_spot(&self) -> Result<(f64, usize)> {
        let counts = self.counts()?;
        let cells = counts.cells as f64 / counts.spots.all.max(1) as f64;
        let is_line = self.grid.size().contains(&1);
        let radius = if is_line {
            0.5 * cells
        } else {
            (cells / std::f64::consts::PI).sqrt()
        };
        Ok((radius, counts.spots.all))
    }

    /// Returns the number of contact cells on the edges across which the grid is not periodic.
    pub(crate) fn cells_on_edge(&self) -> usize {
        if let Some(counted) = self.counted {
            return counted.cells_on_edge;
        }
        let ([along_x, along_y], nx) = (self.repeats, self.grid.nx());
        let (first, rows) = (self.grid.rows().start, self.grid.whole().ny());
        let edge = self.grid.rows().flat_map(|row| {
            let is_end = !along_y && (row == 0 || row + 1 == rows);
            let inner = if along_x { nx } else { (nx - 1).max(1) };
            let stride = if is_end { 1 } else { inner };
            let start = if is_end || !along_x { 0 } else { nx };
            (start..nx)
                .step_by(stride)
                .map(move |column| (row - first) * nx + column)
        });
        edge.filter(|&i| (self.contains)(i)).count()
    }
}

impl HalfSpace {
    /// Counts the cells of the whole grid that are in a set. `contains` returns whether a local cell is in the set. Returns
    /// `None` without ranks.
    pub(crate) fn survey(&self, contains: impl Fn(usize) -> bool + Sync) -> Option<ContactCounts> {
        let map = ContactMap {
            grid: self.grid(),
            repeats: self.boundary().repeats(),
            contains,
            counted: None,
        };
        self.share(self.size())
            .map(|share| unwrap_or_abort(map.survey(Some(&share))))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::contact::fragments::{Fragments, SpotSums};

    /// Returns the numbers of cells of the spots, in the order of their first cells.
    fn sizes(map: &ContactMap<'_, impl Fn(usize) -> bool + Sync>) -> Vec<usize> {
        let fragments = Fragments::of(map, None, |_| SpotSums::default()).unwrap();
        let (_, spots) = fragments.joined().unwrap();
        let counts = map.survey(None).unwrap();
        assert_eq!(counts.spots.all, spots.len());
        assert_eq!(counts.switches, map.switches());
        assert_eq!(counts.cells_on_edge, map.cells_on_edge());
        assert_eq!(counts.cells, map.cells());
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
            counted: None,
        };
        assert_eq!(map.cells(), 9);
        assert_eq!(sizes(&map), [3, 2, 4]);
        assert_eq!(map.cells_on_edge(), 2 + 4);
        assert_eq!(map.survey(None).unwrap().extent, Some([7, 4]));
        // The L has 6 switches within the grid, the bar has 6, and the row at the bottom has 5.
        assert_eq!(map.switches(), 6 + 6 + 5);
        let unresolved = Warning::UnresolvedSpots {
            unresolved: 3,
            spots: 3,
        };
        assert_eq!(
            map.warnings().unwrap(),
            [Warning::ContactAtEdge { cells: 6 }, unresolved]
        );

        // On the periodic grid the row at the bottom touches the L at the top. Two cells of the row and its left end do not
        // touch the L, which adds three switches.
        map.repeats = [true; 2];
        assert_eq!(sizes(&map), [7, 2]);
        // Columns 4, 5 and 7 are free, and no row is free.
        assert_eq!(map.survey(None).unwrap().extent, Some([6, 4]));
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
            counted: None,
        };
        assert_eq!(sizes(&map), [2]);
        assert_eq!(map.switches(), 2);
        assert_eq!(map.survey(None).unwrap().extent, Some([2, 1]));
    }
}
