//! Window: the bounding box of a contact.

use std::ops::Range;

use crate::grid::Grid;
use crate::parallel::ranks::WireFormat;
use crate::parallel::{self, Blocks};

/// Rectangle of cells of a grid.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Window {
    columns: usize,
    corner: [usize; 2],
    pub(crate) size: [usize; 2],
}

impl Window {
    /// Returns the window of the whole grid.
    pub(crate) fn whole(grid: Grid) -> Self {
        Self {
            columns: grid.nx(),
            corner: [0, 0],
            size: grid.whole().size(),
        }
    }

    /// Returns the smallest window around all local cells in a set, or `None` if no local cell is in the set.
    pub(crate) fn around(grid: Grid, contains: impl Fn(usize) -> bool + Sync) -> Option<Self> {
        let (nx, first_row) = (grid.nx(), grid.rows().start);
        let of_row = |iy: usize| {
            let mut columns = 0..nx;
            let contains = |ix: &usize| contains(iy * nx + ix);
            let first = columns.find(contains)?;
            let last = columns.rev().find(contains).unwrap_or(first);
            Some(Self {
                columns: nx,
                corner: [first, first_row + iy],
                size: [last - first + 1, 1],
            })
        };
        parallel::fold_rows(
            grid.ny(),
            nx,
            |rows| rows.map(of_row).fold(None, Self::union_of),
            Self::union_of,
        )
    }

    /// Returns the window of `size` cells with the first cell `corner`, or `None` if the window is empty or exceeds the
    /// grid.
    pub(crate) fn at(grid: Grid, corner: [usize; 2], size: [usize; 2]) -> Option<Self> {
        let cells = grid.whole().size();
        let fits = |axis: usize| {
            let end = corner[axis].checked_add(size[axis]);
            size[axis] > 0 && end.is_some_and(|end| end <= cells[axis])
        };
        (fits(0) && fits(1)).then_some(Self {
            columns: grid.nx(),
            corner,
            size,
        })
    }

    /// Returns the ranges of columns and rows.
    pub(crate) fn ranges(&self) -> [Range<usize>; 2] {
        [0, 1].map(|axis| self.corner[axis]..self.corner[axis] + self.size[axis])
    }

    /// Returns the window of some rows of this window.
    pub(crate) fn rows(self, rows: Range<usize>) -> Self {
        let ([x, y], [nx, _]) = (self.corner, self.size);
        Self {
            corner: [x, y + rows.start],
            size: [nx, rows.len()],
            ..self
        }
    }

    /// Returns the local part of the window, in local row numbers. This part may have no rows.
    pub(crate) fn held(self, grid: Grid) -> Self {
        let (slab, [_, rows]) = (grid.rows(), self.ranges());
        let start = rows.start.clamp(slab.start, slab.end);
        let end = rows.end.clamp(start, slab.end);
        let ([x, _], [nx, _]) = (self.corner, self.size);
        Self {
            corner: [x, start - slab.start],
            size: [nx, end - start],
            ..self
        }
    }

    /// Returns column and row of the first cell.
    pub(crate) fn corner(&self) -> [usize; 2] {
        self.corner
    }

    /// Returns the smallest window around two windows, or `None` if both windows are absent.
    pub(crate) fn union_of(one: Option<Self>, other: Option<Self>) -> Option<Self> {
        match (one, other) {
            (Some(one), Some(other)) => Some(one.union(other)),
            (one, other) => one.or(other),
        }
    }

    /// Returns the smallest window around two windows.
    pub(crate) fn union(self, other: Self) -> Self {
        let mut both = self;
        for axis in [0, 1] {
            let end = |window: Self| window.corner[axis] + window.size[axis];
            both.corner[axis] = self.corner[axis].min(other.corner[axis]);
            both.size[axis] = end(self).max(end(other)) - both.corner[axis];
        }
        both
    }

    /// Returns the intersection with another window, or `None` if the intersection is empty.
    pub(crate) fn intersection(self, other: Self) -> Option<Self> {
        let mut common = self;
        for axis in [0, 1] {
            let end = |window: Self| window.corner[axis] + window.size[axis];
            common.corner[axis] = self.corner[axis].max(other.corner[axis]);
            common.size[axis] = end(self).min(end(other)).checked_sub(common.corner[axis])?;
        }
        (common.cells() > 0).then_some(common)
    }

    /// Returns whether the other window lies entirely inside this window.
    pub(crate) fn covers(self, other: Self) -> bool {
        self.union(other) == self
    }

    /// Returns whether a cell of the whole grid lies inside the window.
    pub(crate) fn contains(&self, index: usize) -> bool {
        let cell = [index % self.columns, index / self.columns];
        (0..2).all(|axis| {
            (self.corner[axis]..self.corner[axis] + self.size[axis]).contains(&cell[axis])
        })
    }

    /// Widens the window by four cells plus a thirty-second of its size on each side, within the grid.
    pub(crate) fn widened(self, grid: Grid) -> Self {
        self.with_margins(grid, self.size.map(|size| 4 + size / 32))
    }

    /// Widens the window by the given numbers of cells on each side along x and along y, within the grid.
    pub(crate) fn with_margins(self, grid: Grid, margins: [usize; 2]) -> Self {
        let mut wide = self;
        for (axis, cells) in grid.whole().size().into_iter().enumerate() {
            let margin = margins[axis];
            let end = (self.corner[axis] + self.size[axis] + margin).min(cells);
            wide.corner[axis] = self.corner[axis].saturating_sub(margin);
            wide.size[axis] = end - wide.corner[axis];
        }
        wide
    }

    /// Extends the window to both edges of the grid along each axis whose entry in `axes` is set.
    pub(crate) fn spanning(self, grid: Grid, axes: [bool; 2]) -> Self {
        let mut wide = self;
        for (axis, cells) in grid.whole().size().into_iter().enumerate() {
            if axes[axis] {
                (wide.corner[axis], wide.size[axis]) = (0, cells);
            }
        }
        wide
    }

    pub(crate) fn cells(&self) -> usize {
        self.size[0] * self.size[1]
    }

    /// Returns the index in the whole grid of the first cell of a row of the window.
    fn row_start(&self, row: usize) -> usize {
        (self.corner[1] + row) * self.columns + self.corner[0]
    }

    /// Returns the index in the whole grid of a cell of the window.
    pub(crate) fn index(&self, cell: usize) -> usize {
        self.row_start(cell / self.size[0]) + cell % self.size[0]
    }

    /// Returns the index in the window of a cell of the whole grid, or `None` if the cell lies outside the window.
    pub(crate) fn place(&self, index: usize) -> Option<usize> {
        let [column, row] = [index % self.columns, index / self.columns];
        let [first, start] = self.corner;
        self.contains(index)
            .then(|| (row - start) * self.size[0] + column - first)
    }

    /// Iterates over the indices in the whole grid, in the order of the window.
    pub(crate) fn indices(&self) -> impl Iterator<Item = usize> + use<> {
        let window = *self;
        (0..window.size[1]).flat_map(move |row| {
            let start = window.row_start(row);
            start..start + window.size[0]
        })
    }

    /// Splits a field of the window into its rows.
    pub(crate) fn lines<'a, T>(&self, part: &'a mut [T]) -> Blocks<'a, T> {
        Blocks {
            items: part,
            width: self.size[0],
        }
    }

    /// Splits the rows of a field of the whole grid that contain the window.
    pub(crate) fn lines_of<'a, T>(&self, whole: &'a mut [T]) -> Blocks<'a, T> {
        let rows = self.corner[1]..self.corner[1] + self.size[1];
        Blocks {
            items: &mut whole[rows.start * self.columns..rows.end * self.columns],
            width: self.columns,
        }
    }

    /// Returns the window relative to a window around it.
    fn within(self, outer: Self) -> Self {
        Self {
            columns: outer.size[0],
            corner: [0, 1].map(|axis| self.corner[axis] - outer.corner[axis]),
            size: self.size,
        }
    }

    /// Crops a field of the window `outer` to this window, in place.
    pub(crate) fn cut(self, outer: Self, field: &mut Vec<f64>) {
        let ([nx, ny], own) = (self.size, self.within(outer));
        for row in 0..ny {
            let start = own.row_start(row);
            field.copy_within(start..start + nx, row * nx);
        }
        field.truncate(self.cells());
    }

    /// Extends a field of the window `inner` to this window, in place, with zeros around it.
    pub(crate) fn spread(self, inner: Self, field: &mut Vec<f64>) {
        let ([nx, ny], place) = (inner.size, inner.within(self));
        field.resize(self.cells(), 0.0);
        let mut end = field.len();
        for row in (0..ny).rev() {
            let start = place.row_start(row);
            field.copy_within(row * nx..(row + 1) * nx, start);
            field[start + nx..end].fill(0.0);
            end = start;
        }
        field[..end].fill(0.0);
    }

    /// Copies the window from a field of the whole grid.
    pub(crate) fn gather(&self, whole: &[f64], part: &mut [f64]) {
        let nx = self.size[0];
        parallel::rows(part, nx, |row, part| {
            part.copy_from_slice(&whole[self.row_start(row)..][..nx]);
        });
    }

    /// Copies the window into a field of the whole grid.
    pub(crate) fn scatter(&self, part: &[f64], whole: &mut [f64]) {
        let [first, nx] = [self.corner[0], self.size[0]];
        parallel::rows(self.lines_of(whole).items, self.columns, |row, target| {
            target[first..first + nx].copy_from_slice(&part[row * nx..(row + 1) * nx]);
        });
    }
}

impl WireFormat for Window {
    const COUNT: usize = 5;
    const ZERO: Self = Self {
        columns: 0,
        corner: [0; 2],
        size: [0; 2],
    };

    fn write(self, words: &mut Vec<u64>) {
        (self.columns, self.corner, self.size).write(words);
    }

    fn read(words: &mut &[u64]) -> Self {
        let (columns, corner, size) = WireFormat::read(words);
        Self {
            columns,
            corner,
            size,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_field_that_is_spread_and_cut_is_as_it_was() {
        let grid = Grid::new(9, 7, 1.0, 1.0).unwrap();
        let window = |corner, size| Window::at(grid, corner, size).unwrap();
        let outer = window([1, 1], [7, 5]);
        for inner in [
            outer,
            window([1, 1], [1, 1]),
            window([2, 3], [5, 2]),
            window([7, 1], [1, 5]),
            window([1, 5], [7, 1]),
        ] {
            let mut whole = vec![0.0; grid.cells()];
            for i in inner.indices() {
                whole[i] = 1.0 + i as f64;
                assert_eq!(inner.place(i).map(|place| inner.index(place)), Some(i));
            }
            let of = |window: Window| {
                let mut part = vec![0.0; window.cells()];
                window.gather(&whole, &mut part);
                part
            };
            let mut field = of(inner);
            outer.spread(inner, &mut field);
            assert_eq!(field, of(outer));
            inner.cut(outer, &mut field);
            assert_eq!(field, of(inner));
        }
    }

    #[test]
    fn windows_that_only_touch_have_nothing_in_common() {
        let grid = Grid::new(9, 7, 1.0, 1.0).unwrap();
        let window = |corner, size| Window::at(grid, corner, size).unwrap();
        let one = window([1, 1], [3, 4]);
        assert_eq!(one.intersection(window([4, 1], [2, 2])), None);
        assert_eq!(one.intersection(window([7, 6], [2, 1])), None);
        let other = window([2, 3], [6, 4]);
        assert_eq!(one.intersection(other), Some(window([2, 3], [2, 2])));
    }
}
