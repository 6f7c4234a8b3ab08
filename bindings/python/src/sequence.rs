//! Vectors as tuples, and access to entries of sequences.

use pyo3::PyClass;
use pyo3::exceptions::PyIndexError;
use pyo3::prelude::*;
use pyo3::types::{PyIterator, PyList};
#[cfg(feature = "stubs")]
use pyo3::{inspect::PyStaticExpr, type_hint_identifier, type_hint_subscript};

/// Returns the components of a vector as a tuple.
pub(crate) fn pair([x, y]: [f64; 2]) -> (f64, f64) {
    (x, y)
}

/// Converts a Python index to a position; a negative index counts from the end. The parameter `name` is the noun for an
/// entry in the error message.
pub(crate) fn place<T>(entries: &[T], index: isize, name: &str) -> PyResult<usize> {
    let from_end = if index < 0 { entries.len() } else { 0 };
    let place = from_end.checked_add_signed(index);
    place.filter(|&place| place < entries.len()).ok_or_else(|| {
        PyIndexError::new_err(format!(
            "there is no {name} with index {index}: the sequence has length {}, and its indices start at 0",
            entries.len()
        ))
    })
}

/// Returns the entry at an index.
pub(crate) fn entry<'a, T>(entries: &'a [T], index: isize, name: &str) -> PyResult<&'a T> {
    place(entries, index, name).map(|place| &entries[place])
}

/// Iterator over the entries of a sequence.
pub(crate) struct Entries<T>(Vec<T>);

impl<T> Entries<T> {
    pub(crate) fn of<C: Copy>(entries: &[C], object: impl Fn(C) -> T) -> Self {
        Self(entries.iter().copied().map(object).collect())
    }
}

impl<'py, T: PyClass + Into<PyClassInitializer<T>>> IntoPyObject<'py> for Entries<T> {
    type Target = PyIterator;
    type Output = Bound<'py, PyIterator>;
    type Error = PyErr;

    #[cfg(feature = "stubs")]
    const OUTPUT_TYPE: PyStaticExpr = type_hint_subscript!(
        type_hint_identifier!("collections.abc", "Iterator"),
        T::TYPE_HINT
    );

    fn into_pyobject(self, py: Python<'py>) -> PyResult<Bound<'py, PyIterator>> {
        let objects = self.0.into_iter().map(|entry| Bound::new(py, entry));
        PyList::new(py, objects.collect::<PyResult<Vec<_>>>()?)?.try_iter()
    }
}
