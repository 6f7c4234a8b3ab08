//! Linear operators from tractions to displacements, on arrays that are read and written in place.

mod dense;
mod elastic;

pub(crate) use dense::{DenseMinimum, DenseOperator};
pub(crate) use elastic::{Convolution, TensorOperator};

use std::sync::{Arc, Mutex, PoisonError};

use numpy::{PyArrayDyn, PyArrayMethods, PyReadonlyArrayDyn, PyUntypedArrayMethods};
use pyo3::exceptions::{PyRuntimeError, PyTypeError, PyValueError};
use pyo3::prelude::*;
use stickslip::{EigenvalueBound, Operator, Scratch};

use crate::array::Array;
use crate::choice::Choice;
use crate::conversion::kind_of;
use crate::digits::counted;
use crate::error::OrRaise;
use crate::field::{Field, same_grid};
use crate::function::Function;
use crate::real::{Count, by_axis, in_axes, is_real, misshapen};
use crate::work::unobserved;

/// Operator with one component per cell, of any kind.
pub(crate) trait Product: Send + Sync {
    fn cells(&self) -> usize;

    fn lower_bound(&self) -> f64;

    fn eigenvalue_bound(&self) -> EigenvalueBound;

    fn apply(&self, x: &[f64], out: &mut [f64]);

    fn apply_f32(&self, x: &[f64], out: &mut [f64]);
}

/// Operator of the crate, with scratch memory for all products that run concurrently.
struct Kept<O: Operator> {
    operator: O,
    scratches: Mutex<Vec<Scratch>>,
}

impl<O: Operator> Kept<O> {
    fn new(operator: O) -> Arc<Self> {
        Arc::new(Self {
            operator,
            scratches: Mutex::new(Vec::new()),
        })
    }

    fn with_scratch(&self, work: impl FnOnce(&mut Scratch)) {
        let kept = || {
            self.scratches
                .lock()
                .unwrap_or_else(PoisonError::into_inner)
        };
        let free = kept().pop();
        let mut scratch =
            free.unwrap_or_else(|| self.operator.scratch().expect("memory for a product"));
        work(&mut scratch);
        kept().push(scratch);
    }
}

impl<O: Operator + Send> Product for Kept<O> {
    fn cells(&self) -> usize {
        self.operator.cells()
    }

    fn lower_bound(&self) -> f64 {
        self.operator.lower_bound()
    }

    fn eigenvalue_bound(&self) -> EigenvalueBound {
        self.operator.eigenvalue_bound()
    }

    fn apply(&self, x: &[f64], out: &mut [f64]) {
        self.with_scratch(|scratch| self.operator.apply([x], [out], scratch));
    }

    fn apply_f32(&self, x: &[f64], out: &mut [f64]) {
        self.with_scratch(|scratch| self.operator.apply_f32([x], [out], scratch));
    }
}

/// A linear operator from tractions to displacements, with one number per cell.
///
/// It is created by :meth:`HalfSpace.operator`, :meth:`HalfSpace.preconditioner`, :class:`stickslip.fft.Convolution`,
/// :class:`stickslip.dense.DenseOperator` or :func:`stickslip.cgm.identity`.
#[pyclass(frozen, subclass, module = "stickslip.cgm")]
pub(crate) struct LinearOperator {
    pub(crate) product: Arc<dyn Product>,
    kind: &'static str,
    /// Grid of the cells, unless the operator is independent of a grid.
    pub(crate) grid: Option<stickslip::Grid>,
}

impl LinearOperator {
    pub(crate) fn of<O>(kind: &'static str, operator: O) -> Self
    where
        O: Operator + Send + 'static,
    {
        let (product, grid) = (Kept::new(operator), None);
        Self {
            product,
            kind,
            grid,
        }
    }

    /// Creates an operator of the cells of a grid, which rejects fields on a different grid.
    pub(crate) fn on<O>(kind: &'static str, grid: stickslip::Grid, operator: O) -> Self
    where
        O: Operator + Send + 'static,
    {
        Self {
            grid: Some(grid),
            ..Self::of(kind, operator)
        }
    }
}

/// Returns the product with an operator of the package, or with a callable that receives arrays of this shape.
pub(crate) fn product_of(
    operator: &Bound<'_, PyAny>,
    shape: &[usize],
    lower_bound: f64,
) -> PyResult<Arc<dyn Product>> {
    if let Ok(known) = operator.cast::<LinearOperator>() {
        Ok(Arc::clone(&known.get().product))
    } else if operator.is_callable() {
        Ok(Kept::new(Function::new(operator, shape, lower_bound)))
    } else {
        Err(PyTypeError::new_err(format!(
            "operator must be a LinearOperator or a callable, got {}: convert a matrix by dense.DenseOperator(matrix)",
            kind_of(operator)
        )))
    }
}

/// Operator in the form of the crate, with N components per cell, which are stored consecutively.
#[derive(Clone)]
pub(crate) struct Shared(pub(crate) Arc<dyn Product>);

/// Buffers for all components of the tractions and of the displacements. The first product sets their lengths.
type Buffers = [Vec<f64>; 2];

impl Shared {
    /// Applies an operator through buffers, or in place if there is one component.
    fn product<const N: usize>(
        x: [&[f64]; N],
        mut out: [&mut [f64]; N],
        scratch: &mut Scratch,
        apply: impl FnOnce(&[f64], &mut [f64]),
    ) {
        if let ([x], [out]) = (&x[..], &mut out[..]) {
            return apply(x, out);
        }
        let [from, to]: &mut Buffers = scratch.get_mut().expect("the scratch of this operator");
        from.clear();
        for x in x {
            from.extend_from_slice(x);
        }
        to.resize(from.len(), 0.0);
        apply(from, to);
        let mut rest = &to[..];
        for out in out {
            let (own, others) = rest.split_at(out.len());
            out.copy_from_slice(own);
            rest = others;
        }
    }
}

impl<const N: usize> Operator<N> for Shared {
    fn cells(&self) -> usize {
        self.0.cells() / N
    }

    fn scratch(&self) -> stickslip::Result<Scratch> {
        Ok(Scratch::new(Buffers::default()))
    }

    fn apply(&self, x: [&[f64]; N], out: [&mut [f64]; N], scratch: &mut Scratch) {
        Self::product(x, out, scratch, |x, out| self.0.apply(x, out));
    }

    fn apply_f32(&self, x: [&[f64]; N], out: [&mut [f64]; N], scratch: &mut Scratch) {
        Self::product(x, out, scratch, |x, out| self.0.apply_f32(x, out));
    }

    fn lower_bound(&self) -> f64 {
        self.0.lower_bound()
    }

    fn eigenvalue_bound(&self) -> EigenvalueBound {
        self.0.eigenvalue_bound()
    }
}

/// Returns one number per cell as a contiguous array; an array of a different layout is copied. Named axes are brought into the
/// order (y, x).
pub(crate) fn numbers<'py>(
    object: &Bound<'py, PyAny>,
    cells: usize,
) -> PyResult<PyReadonlyArrayDyn<'py, f64>> {
    contiguous(&in_axes(object, "the array", None)?, cells)
}

/// Returns an error if an operand does not belong to the grid of the operator: a field on a different grid, or a plane of a
/// different shape, such as a transposed array. Flat arrays, rows and columns have no grid.
pub(crate) fn check_grid(object: &Bound<'_, PyAny>, grid: Option<stickslip::Grid>) -> PyResult<()> {
    let Some(grid) = grid else {
        return Ok(());
    };
    let py = object.py();
    if let Ok(field) = object.cast::<Field>() {
        return same_grid(grid, field.get().0.grid(), "the field").or_raise(py);
    }
    let shape = by_axis(object)?
        .getattr("shape")
        .and_then(|shape| shape.extract());
    match shape {
        Ok((rows, columns))
            if rows > 1 && columns > 1 && (rows, columns) != (grid.ny(), grid.nx()) =>
        {
            Err(misshapen(py, "the array", grid, &[rows, columns]))
        }
        _ => Ok(()),
    }
}

/// Returns the given count of numbers as a contiguous array; an array of a different layout is copied.
pub(crate) fn contiguous<'py>(
    object: &Bound<'py, PyAny>,
    cells: usize,
) -> PyResult<PyReadonlyArrayDyn<'py, f64>> {
    is_real(object, "the array")?;
    let numpy = object.py().import("numpy")?;
    let array = numpy.call_method1("ascontiguousarray", (object, "float64"))?;
    let array: PyReadonlyArrayDyn<'py, f64> = array.extract()?;
    if array.len() == cells {
        Ok(array)
    } else {
        let found = array.len();
        Err(PyValueError::new_err(format!(
            "the array has {found} numbers, expected {cells}"
        )))
    }
}

/// Returns the output of a product: the given array, or a new array of the shape of the input.
pub(super) fn target<'py>(
    like: &PyReadonlyArrayDyn<'py, f64>,
    out: Option<Bound<'py, PyAny>>,
) -> PyResult<Bound<'py, PyArrayDyn<f64>>> {
    match out {
        None => Ok(PyArrayDyn::zeros(like.py(), like.shape(), false)),
        Some(out) => {
            let out = out
                .cast_into::<PyArrayDyn<f64>>()
                .map_err(|_| PyTypeError::new_err("out must be a C-contiguous array of float64"))?;
            if out.len() == like.len() && out.is_c_contiguous() {
                Ok(out)
            } else {
                Err(PyValueError::new_err(
                    "out must be C-contiguous and have the size of x",
                ))
            }
        }
    }
}

#[pymethods]
impl LinearOperator {
    /// Number of unknowns.
    #[getter]
    fn cells(&self) -> usize {
        self.product.cells()
    }

    /// Lower bound on the smallest eigenvalue.
    #[getter]
    fn lower_bound(&self) -> f64 {
        self.product.lower_bound()
    }

    /// Origin of the lower bound: "proven", "stated" (by a user-defined operator), "estimated" (stiff coatings on long
    /// grids), or "unknown", in which case the bound is zero.
    #[getter]
    fn eigenvalue_bound(&self) -> Choice<EigenvalueBound> {
        Choice(self.product.eigenvalue_bound())
    }

    /// Applies the operator to an array with one number per cell, which is read in place.
    ///
    /// Parameters
    /// ----------
    /// x : array_like
    ///     Tractions (pressures), one number per cell. The axes of an array of xarray are brought into the order (y, x).
    /// out : ndarray, optional
    ///     Output array, C-contiguous, of type float64, not overlapping ``x``.
    ///
    /// Returns
    /// -------
    /// ndarray of the shape of ``x``
    ///     Displacements (lengths).
    #[pyo3(signature = (x, out=None))]
    fn apply<'py>(
        &self,
        py: Python<'py>,
        x: Bound<'py, PyAny>,
        out: Option<Bound<'py, PyAny>>,
    ) -> PyResult<Array<'py>> {
        check_grid(&x, self.grid)?;
        let x = numbers(&x, self.product.cells())?;
        let target = target(&x, out)?;
        {
            let refused = |_| PyValueError::new_err("out must be writable and must not overlap x");
            let mut writable = target.try_readwrite().map_err(refused)?;
            let (from, to) = (x.as_slice()?, writable.as_slice_mut()?);
            unobserved(py, from.len(), || {
                self.product.apply(from, to);
                Ok(())
            })?;
        }
        Ok(Array::of(target))
    }

    fn __call__<'py>(&self, py: Python<'py>, x: Bound<'py, PyAny>) -> PyResult<Array<'py>> {
        self.apply(py, x, None)
    }

    fn __repr__(&self) -> String {
        format!(
            "LinearOperator({}, {})",
            self.kind,
            counted(self.product.cells(), "cell")
        )
    }
}

/// Returns the identity operator.
#[pyfunction]
pub(crate) fn identity(cells: Count) -> PyResult<LinearOperator> {
    let cells = cells.0;
    if cells == 0 {
        return Err(PyRuntimeError::new_err(
            "the number of cells must be at least 1, got 0",
        ));
    }
    Ok(LinearOperator::of(
        "Identity",
        stickslip::Identity::new(cells),
    ))
}
