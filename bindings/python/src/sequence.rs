//! Vectors as tuples, and entries of sequences.

use pyo3::exceptions::PyIndexError;
use pyo3::prelude::*;

/// The components of a vector.
pub(crate) fn pair([x, y]: [f64; 2]) -> (f64, f64) {
    (x, y)
}

/// The place of an index, which counts from the end if it is negative; `name` is what an entry is called.
pub(crate) fn place<T>(entries: &[T], index: isize, name: &str) -> PyResult<usize> {
    let from_end = if index < 0 { entries.len() } else { 0 };
    let place = from_end.checked_add_signed(index);
    place.filter(|&place| place < entries.len()).ok_or_else(|| {
        PyIndexError::new_err(format!(
            "no {name} of index {index} among {}, whose indices begin at 0",
            entries.len()
        ))
    })
}

/// The entry of an index.
pub(crate) fn entry<'a, T>(entries: &'a [T], index: isize, name: &str) -> PyResult<&'a T> {
    place(entries, index, name).map(|place| &entries[place])
}
