//! Fields as NumPy arrays of shape (ny, nx): read-only views of the data of a frozen object, read-only copies of the data of an
//! object that changes, or new arrays.

use std::convert::Infallible;
use std::marker::PhantomData;

use numpy::ndarray::{ArrayView, Dimension};
use numpy::{
    Element, IntoPyArray, PyArray, PyArray1, PyArray2, PyArrayDyn, PyArrayMethods, PyUntypedArray,
};
use pyo3::PyClass;
use pyo3::prelude::*;
use pyo3::pyclass::boolean_struct::True;
#[cfg(feature = "stubs")]
use pyo3::{inspect::PyStaticExpr, type_hint_identifier, type_hint_subscript};

use crate::field::Field;
use crate::grid::Grid;

/// Element type of an array.
pub(crate) trait Entry: Element {
    #[cfg(feature = "stubs")]
    const HINT: PyStaticExpr;
}

macro_rules! entries {
    ($($entry:ty = $name:literal),+) => {$(
        impl Entry for $entry {
            #[cfg(feature = "stubs")]
            const HINT: PyStaticExpr = type_hint_identifier!("numpy", $name);
        }
    )+};
}

entries!(
    f64 = "float64",
    bool = "bool_",
    u8 = "uint8",
    u32 = "uint32",
    u64 = "uint64"
);

/// Array that is returned to Python.
pub(crate) struct Array<'py, E = f64>(pub(crate) Bound<'py, PyAny>, PhantomData<E>);

impl<'py, E: Entry> Array<'py, E> {
    pub(crate) fn of<D>(array: Bound<'py, PyArray<E, D>>) -> Self {
        Self(array.into_any(), PhantomData)
    }

    /// Creates a one-dimensional array.
    pub(crate) fn new(py: Python<'py>, entries: impl IntoIterator<Item = E>) -> Self {
        let entries: Vec<_> = entries.into_iter().collect();
        Self::of(entries.into_pyarray(py))
    }

    /// Makes a new array read-only. A change in place then raises an error, because it would have no effect on the object from
    /// which the array is copied.
    pub(crate) fn read_only(self) -> Self {
        if let Ok(array) = self.0.cast::<PyArrayDyn<E>>() {
            drop(array.readwrite().make_nonwriteable());
        }
        self
    }
}

impl<'py, E: Entry> IntoPyObject<'py> for Array<'py, E> {
    type Target = PyAny;
    type Output = Bound<'py, PyAny>;
    type Error = Infallible;

    #[cfg(feature = "stubs")]
    const OUTPUT_TYPE: PyStaticExpr =
        type_hint_subscript!(type_hint_identifier!("numpy.typing", "NDArray"), E::HINT);

    fn into_pyobject(self, _py: Python<'py>) -> Result<Self::Output, Infallible> {
        Ok(self.0)
    }
}

/// Returns a read-only array over memory of a frozen object, which neither changes nor frees it during its lifetime. The
/// array keeps the object alive.
fn view_of<'py, T, E: Entry, D: Dimension>(
    owner: &Bound<'py, T>,
    samples: ArrayView<'_, E, D>,
) -> Array<'py, E>
where
    T: PyClass<Frozen = True>,
{
    #[allow(
        unsafe_code,
        reason = "an array that shares the memory of a Rust object cannot be made otherwise"
    )]
    // SAFETY: the callers take `samples` from a shared reference to the contents of `owner`, by a function that can
    // return nothing shorter-lived (`for<'a> Fn(&'a T) -> &'a _`). A frozen class hands out shared references only, its
    // fields have no interior mutability, and the array keeps `owner` alive. The memory is never written: the array is
    // made read-only here, and NumPy allows that flag to be reset only if the base is a writable buffer, which `owner` is
    // not.
    let array = unsafe { PyArray::borrow_from_array(&samples, owner.clone().into_any()) };
    let read_only = array.readwrite().make_nonwriteable();
    drop(read_only);
    Array::of(array)
}

/// Returns a view of a field of a frozen object, without a copy.
pub(crate) fn view<'py, T>(
    owner: &Bound<'py, T>,
    field: impl for<'a> Fn(&'a T) -> &'a stickslip::Field,
) -> Array<'py>
where
    T: PyClass<Frozen = True> + Sync,
{
    let field = field(owner.get());
    let shape = (field.grid().ny(), field.grid().nx());
    // A field has as many samples as its grid has cells.
    match ArrayView::from_shape(shape, field.as_slice()) {
        Ok(samples) => view_of(owner, samples),
        Err(_) => copy(owner.py(), field),
    }
}

/// Returns a view of a slice of numbers of a frozen object, without a copy.
pub(crate) fn view_slice<'py, T, E: Entry>(
    owner: &Bound<'py, T>,
    numbers: impl for<'a> Fn(&'a T) -> &'a [E],
) -> Array<'py, E>
where
    T: PyClass<Frozen = True> + Sync,
{
    view_of(owner, ArrayView::from(numbers(owner.get())))
}

/// Memory of an array that is copied from an object that changes. It contains the grid of the array.
#[pyclass(frozen, module = "stickslip")]
struct CopiedField(stickslip::Field);

#[pymethods]
impl CopiedField {
    /// Grid of the field.
    #[getter]
    fn grid(&self) -> Grid {
        Grid(self.0.grid())
    }
}

/// Copies a field of an object that changes into a read-only array.
pub(crate) fn snapshot<'py>(py: Python<'py>, field: &stickslip::Field) -> Array<'py> {
    match Bound::new(py, CopiedField(field.clone())) {
        Ok(memory) => view(&memory, |memory| &memory.0),
        Err(_) => copy(py, field).read_only(),
    }
}

/// Returns the grid of an array that is the memory of a solution, a state or a copied field, from its base. The memory of a
/// `Field` has no grid in this sense, because `field.array` is the way to use its numbers on another grid.
pub(crate) fn grid_of_memory(array: &Bound<'_, PyUntypedArray>) -> Option<stickslip::Grid> {
    let owner = array.getattr("base").ok()?;
    if owner.is_none() || owner.cast::<PyUntypedArray>().is_ok() || owner.cast::<Field>().is_ok() {
        return None;
    }
    let grid = owner
        .getattr("grid")
        .ok()?
        .cast_into::<Grid>()
        .ok()?
        .get()
        .0;
    let shape: (usize, usize) = array.getattr("shape").ok()?.extract().ok()?;
    (shape == (grid.ny(), grid.nx())).then_some(grid)
}

/// Copies a field into a new array.
pub(crate) fn copy<'py>(py: Python<'py>, field: &stickslip::Field) -> Array<'py> {
    let array = PyArray1::from_slice(py, field.as_slice());
    shaped(&array, field.grid())
}

/// Returns an array of the energies of cells that also contains its grid, from which the wear laws take the area of a cell.
pub(crate) fn energies<'py>(
    py: Python<'py>,
    array: &Array<'py>,
    grid: stickslip::Grid,
) -> PyResult<Array<'py>> {
    with_grid(py, "CellEnergies", array, grid)
}

/// Returns an array of energies per area, which the wear laws reject, because they divide energies by the area of a cell.
pub(crate) fn energies_per_area<'py>(
    py: Python<'py>,
    array: &Array<'py>,
    grid: stickslip::Grid,
) -> PyResult<Array<'py>> {
    with_grid(py, "EnergiesPerArea", array, grid)
}

/// Returns a view of an array as an array of this class, which contains its grid.
fn with_grid<'py>(
    py: Python<'py>,
    class: &str,
    array: &Array<'py>,
    grid: stickslip::Grid,
) -> PyResult<Array<'py>> {
    let class = py.import("stickslip._arrays")?.getattr(class)?;
    let view = class.call_method1("of", (&array.0, Grid(grid)))?;
    Ok(Array(view, PhantomData))
}

/// Returns one byte per cell as an array of shape (ny, nx).
pub(crate) fn bytes(
    py: Python<'_>,
    grid: stickslip::Grid,
    of_cells: impl Iterator<Item = u8>,
) -> Array<'_, u8> {
    let array = of_cells.collect::<Vec<_>>().into_pyarray(py);
    shaped(&array, grid)
}

/// Returns the mask of the cells that carry pressure, as a read-only array. The crate counts the same cells in the contact area.
pub(crate) fn contact<'py>(py: Python<'py>, pressure: &stickslip::Field) -> Array<'py, bool> {
    let touching = pressure.as_slice().iter().map(|&pressure| pressure > 0.0);
    mask(py, pressure.grid(), touching).read_only()
}

/// Returns one boolean per cell as an array of shape (ny, nx).
pub(crate) fn mask(
    py: Python<'_>,
    grid: stickslip::Grid,
    of_cells: impl Iterator<Item = bool>,
) -> Array<'_, bool> {
    let array = of_cells.collect::<Vec<_>>().into_pyarray(py);
    shaped(&array, grid)
}

/// Returns one label per cell as an array of shape (ny, nx).
pub(crate) fn labels<'py>(
    py: Python<'py>,
    grid: stickslip::Grid,
    labels: &[u32],
) -> Array<'py, u32> {
    shaped(&PyArray1::from_slice(py, labels), grid)
}

fn shaped<'py, E: Entry>(flat: &Bound<'py, PyArray1<E>>, grid: stickslip::Grid) -> Array<'py, E> {
    let shaped: PyResult<Bound<'py, PyArray2<E>>> = flat.reshape([grid.ny(), grid.nx()]);
    shaped.map_or_else(|_| Array::of(flat.clone()), Array::of)
}

/// Returns the zones of the cells as numbers in a read-only array, which also compares equal to their names.
pub(crate) fn zones<'py>(
    py: Python<'py>,
    grid: stickslip::Grid,
    zones: &[stickslip::Zone],
) -> PyResult<Array<'py, u8>> {
    use stickslip::Zone;
    let number = |zone: &Zone| match zone {
        Zone::Separated => 0,
        Zone::Stick => 1,
        Zone::Slip => 2,
    };
    let numbers = bytes(py, grid, zones.iter().map(number)).read_only();
    let class = py.import("stickslip._enums")?.getattr("Zones")?;
    let zones = numbers.0.call_method1("view", (class,))?;
    Ok(Array(zones, PhantomData))
}
