//! Vectors as tuples, and entries of sequences.

use pyo3::exceptions::PyIndexError;
use pyo3::prelude::*;

/// The components of a vector.
pub(crate) fn pair([x, y]: [f64; 2]) -> (f64, f64) {
    (x, y)
}

/// The entry of an index, which counts from the end if it is negative; `name` is what an entry is called.
pub(crate) fn entry<'a, T>(entries: &'a [T], index: isize, name: &str) -> PyResult<&'a T> {
    let from_end = if index < 0 { entries.len() } else { 0 };
    let place = from_end.checked_add_signed(index);
    place
        .and_then(|place| entries.get(place))
        .ok_or_else(|| PyIndexError::new_err(format!("no {name} {index} of {}", entries.len())))
}
