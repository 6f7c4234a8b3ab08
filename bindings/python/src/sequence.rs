//! Vectors as tuples, and entries of sequences.

use pyo3::PyClass;
use pyo3::exceptions::PyIndexError;
use pyo3::prelude::*;
use pyo3::types::{PyIterator, PyList};
#[cfg(feature = "stubs")]
use pyo3::{inspect::PyStaticExpr, type_hint_identifier, type_hint_subscript};

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

/// The entries of a sequence, one after another.
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
