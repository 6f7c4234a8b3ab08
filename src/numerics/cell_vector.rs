//! Vectors with N components per cell, stored as one slice per component.

use std::ops::{Deref, DerefMut, Range};

use crate::parallel::layout::Layout;
use crate::parallel::{Blocks, CHUNK, blocks};

/// Returns the scalar product of the components of two cells.
#[inline]
pub(crate) fn dot<const N: usize>(a: [f64; N], b: [f64; N]) -> f64 {
    let mut sum = a[0] * b[0];
    for c in 1..N {
        sum += a[c] * b[c];
    }
    sum
}

/// Returns the length of a vector. With two or more components the result is infinite above 1e150 because squares
/// overflow. It is zero below 1e-160 because squares underflow.
#[inline]
pub(crate) fn norm<const N: usize>(v: [f64; N]) -> f64 {
    if N == 1 { v[0].abs() } else { dot(v, v).sqrt() }
}

/// Returns the length of a vector in the plane without overflow or underflow. Vectors along x, as in the scalar model, take only
/// a few instructions.
#[inline]
pub(crate) fn length([x, y]: [f64; 2]) -> f64 {
    if y == 0.0 { x.abs() } else { x.hypot(y) }
}

/// Returns `a + scale b`.
#[inline]
pub(crate) fn plus<const N: usize>(a: [f64; N], scale: f64, b: [f64; N]) -> [f64; N] {
    std::array::from_fn(|c| a[c] + scale * b[c])
}

/// Returns `a - b`.
#[inline]
pub(crate) fn minus<const N: usize>(a: [f64; N], b: [f64; N]) -> [f64; N] {
    std::array::from_fn(|c| a[c] - b[c])
}

/// Returns the components of a cell.
#[inline]
pub(crate) fn at<const N: usize>(vector: &[&[f64]; N], cell: usize) -> [f64; N] {
    std::array::from_fn(|c| vector[c][cell])
}

/// Writes the components of a cell into the chunk of a vector that a task owns.
#[inline]
pub(crate) fn put<const N: usize>(parts: &mut [Blocks<'_, f64>; N], place: usize, value: [f64; N]) {
    for (part, value) in parts.iter_mut().zip(value) {
        part.items[place] = value;
    }
}

/// Returns the components of a cell in the chunk of a vector that a task owns.
#[inline]
pub(crate) fn held<const N: usize>(parts: &[Blocks<'_, f64>; N], place: usize) -> [f64; N] {
    std::array::from_fn(|c| parts[c].items[place])
}

/// Returns the values of `W` adjacent items. A constant number of items is processed with one bounds check.
#[inline]
pub(crate) fn run<T: Copy, const W: usize>(items: &[T], first: usize) -> [T; W] {
    let items = &items[first..first + W];
    std::array::from_fn(|k| items[k])
}

/// Positions of `W` cells in a vector.
pub(crate) trait Places<const W: usize>: Copy {
    /// Returns the positions.
    fn all(self) -> [usize; W];

    /// Returns the values at the positions.
    fn values<T: Copy>(self, items: &[T]) -> [T; W];

    /// Writes the values to the positions.
    fn put<T: Copy>(self, items: &mut [T], values: [T; W]);
}

/// Adjacent cells. The field is the position of the first cell.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Adjacent(pub(crate) usize);

impl<const W: usize> Places<W> for Adjacent {
    #[inline]
    fn all(self) -> [usize; W] {
        std::array::from_fn(|k| self.0 + k)
    }

    #[inline]
    fn values<T: Copy>(self, items: &[T]) -> [T; W] {
        run(items, self.0)
    }

    #[inline]
    fn put<T: Copy>(self, items: &mut [T], values: [T; W]) {
        put_run(items, self.0, values);
    }
}

/// Cells anywhere in the vector.
impl<const W: usize> Places<W> for [usize; W] {
    #[inline]
    fn all(self) -> [usize; W] {
        self
    }

    #[inline]
    fn values<T: Copy>(self, items: &[T]) -> [T; W] {
        self.map(|place| items[place])
    }

    #[inline]
    fn put<T: Copy>(self, items: &mut [T], values: [T; W]) {
        for (place, value) in self.into_iter().zip(values) {
            items[place] = value;
        }
    }
}

/// Returns the components of `W` cells.
#[inline]
pub(crate) fn at_places<V: Deref<Target = [f64]>, const N: usize, const W: usize>(
    vector: &[V; N],
    places: impl Places<W>,
) -> [[f64; N]; W] {
    let parts: [[f64; W]; N] = std::array::from_fn(|c| places.values(&vector[c]));
    std::array::from_fn(|k| std::array::from_fn(|c| parts[c][k]))
}

/// Writes the values of `W` adjacent items.
#[inline]
pub(crate) fn put_run<T: Copy, const W: usize>(items: &mut [T], first: usize, values: [T; W]) {
    items[first..first + W].copy_from_slice(&values);
}

/// Writes the components of `W` cells into the chunk of a vector that a task owns.
#[inline]
pub(crate) fn put_at_places<const N: usize, const W: usize>(
    parts: &mut [&mut [f64]; N],
    places: impl Places<W>,
    values: [[f64; N]; W],
) {
    for (c, part) in parts.iter_mut().enumerate() {
        places.put(part, values.map(|value| value[c]));
    }
}

/// Returns the components as slices for reading.
#[inline]
pub(crate) fn slices<V: Deref<Target = [f64]>, const N: usize>(vector: &[V; N]) -> [&[f64]; N] {
    vector.each_ref().map(|part| &**part)
}

/// Returns the components as slices for writing.
pub(crate) fn slices_mut<V: DerefMut<Target = [f64]>, const N: usize>(
    vector: &mut [V; N],
) -> [&mut [f64]; N] {
    vector.each_mut().map(|part| &mut **part)
}

/// Returns the components of a range of cells.
#[inline]
pub(crate) fn within<'a, const N: usize>(
    vector: &[&'a [f64]; N],
    range: &Range<usize>,
) -> [&'a [f64]; N] {
    vector.map(|part| &part[range.clone()])
}

/// Splits a vector into chunks for writing.
pub(crate) fn chunks<'a, V: DerefMut<Target = [f64]>, const N: usize>(
    layout: &Layout,
    vector: &'a mut [V; N],
) -> [Blocks<'a, f64>; N] {
    vector.each_mut().map(|part| layout.blocks(part))
}

/// Replaces the components of every cell by `f(cell, components)`.
pub(crate) fn update_cells<V: DerefMut<Target = [f64]>, const N: usize>(
    vector: &mut [V; N],
    f: impl Fn(usize, [f64; N]) -> [f64; N] + Sync,
) {
    let tasks = vector[0].len().div_ceil(CHUNK);
    let work = |task: usize, mut parts: [Blocks<'_, f64>; N]| {
        for place in 0..parts[0].items.len() {
            let value = f(task * CHUNK + place, held(&parts, place));
            put(&mut parts, place, value);
        }
    };
    crate::parallel::sweep(
        0..tasks,
        vector.each_mut().map(|part| blocks(part)),
        &work,
        &|(), ()| (),
    );
}
