//! Linear operators from tractions to displacements, on arrays whose memory is read and written in place.

use std::sync::{Arc, Mutex, PoisonError};

use numpy::{PyArrayDyn, PyArrayMethods, PyReadonlyArrayDyn, PyUntypedArrayMethods};
use pyo3::exceptions::{PyRuntimeError, PyTypeError, PyValueError};
use pyo3::prelude::*;
use stickslip::influence::{Component, Direction};
use stickslip::{Operator, fft};

use crate::array::Array;
use crate::choice::Choice;
use crate::error::OrRaise;
use crate::grid::Grid;
use crate::half_space::HalfSpace;
use crate::held::lock;
use crate::material::ElasticPair;
use crate::work::unobserved;

/// An operator of one component a cell, whatever its kind.
pub(crate) trait Product: Send + Sync {
    fn cells(&self) -> usize;

    fn lower_bound(&self) -> f64;

    fn apply(&self, x: &[f64], out: &mut [f64]);

    fn apply_f32(&self, x: &[f64], out: &mut [f64]);
}

/// One of the crate, with workspaces for as many products as run at once.
struct Kept<O: Operator> {
    operator: O,
    workspaces: Mutex<Vec<O::Workspace>>,
}

impl<O: Operator> Kept<O> {
    fn with_workspace(&self, work: impl FnOnce(&mut O::Workspace)) {
        let kept = || {
            self.workspaces
                .lock()
                .unwrap_or_else(PoisonError::into_inner)
        };
        let free = kept().pop();
        let mut workspace = free.unwrap_or_else(|| self.operator.workspace());
        work(&mut workspace);
        kept().push(workspace);
    }
}

impl<O: Operator + Send> Product for Kept<O>
where
    O::Workspace: Send,
{
    fn cells(&self) -> usize {
        self.operator.cells()
    }

    fn lower_bound(&self) -> f64 {
        self.operator.lower_bound()
    }

    fn apply(&self, x: &[f64], out: &mut [f64]) {
        self.with_workspace(|workspace| self.operator.apply([x], [out], workspace));
    }

    fn apply_f32(&self, x: &[f64], out: &mut [f64]) {
        self.with_workspace(|workspace| self.operator.apply_f32([x], [out], workspace));
    }
}

/// A linear operator from tractions to displacements, one number a cell.
///
/// Made by :meth:`HalfSpace.operator`, :meth:`HalfSpace.preconditioner`, :class:`stickslip.fft.Convolution`,
/// :class:`stickslip.dense.DenseOperator` or :func:`stickslip.cgm.identity`.
#[pyclass(frozen, subclass, module = "stickslip.cgm")]
pub(crate) struct LinearOperator {
    pub(crate) product: Arc<dyn Product>,
    kind: &'static str,
}

impl LinearOperator {
    pub(crate) fn of<O>(kind: &'static str, operator: O) -> Self
    where
        O: Operator + Send + 'static,
        O::Workspace: Send,
    {
        let workspaces = Mutex::new(Vec::new());
        let product = Arc::new(Kept {
            operator,
            workspaces,
        });
        Self { product, kind }
    }
}

/// An array of so many numbers that lie one behind the other; another is copied.
pub(crate) fn numbers<'py>(
    object: &Bound<'py, PyAny>,
    cells: usize,
) -> PyResult<PyReadonlyArrayDyn<'py, f64>> {
    let numpy = object.py().import("numpy")?;
    let array = numpy.call_method1("ascontiguousarray", (object, "float64"))?;
    let array: PyReadonlyArrayDyn<'py, f64> = array.extract()?;
    if array.len() == cells {
        Ok(array)
    } else {
        let found = array.len();
        Err(PyValueError::new_err(format!(
            "an array of {found} numbers, expected {cells}"
        )))
    }
}

/// Where a product goes: an array that is given, or a new one of the shape of another.
fn target<'py>(
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
                    "out must be C-contiguous and of the size of x",
                ))
            }
        }
    }
}

#[pymethods]
impl LinearOperator {
    /// Unknowns.
    #[getter]
    fn cells(&self) -> usize {
        self.product.cells()
    }

    /// A lower bound of the smallest eigenvalue.
    #[getter]
    fn lower_bound(&self) -> f64 {
        self.product.lower_bound()
    }

    /// The product with an array of as many numbers as there are cells, which is read where it lies.
    ///
    /// Parameters
    /// ----------
    /// x : array_like
    /// out : ndarray, optional
    ///     Where the result goes: C-contiguous, of float64, not overlapping ``x``.
    ///
    /// Returns
    /// -------
    /// ndarray of the shape of ``x``
    #[pyo3(signature = (x, out=None))]
    fn apply<'py>(
        &self,
        py: Python<'py>,
        x: Bound<'py, PyAny>,
        out: Option<Bound<'py, PyAny>>,
    ) -> PyResult<Array<'py>> {
        let x = numbers(&x, self.product.cells())?;
        let target = target(&x, out)?;
        {
            let refused = |_| PyValueError::new_err("out overlaps x, or is read-only");
            let mut writable = target.try_readwrite().map_err(refused)?;
            let (from, to) = (x.as_slice()?, writable.as_slice_mut()?);
            unobserved(py, from.len(), || {
                self.product.apply(from, to);
                Ok(())
            })?;
        }
        Ok(Array(target.into_any()))
    }

    fn __call__<'py>(&self, py: Python<'py>, x: Bound<'py, PyAny>) -> PyResult<Array<'py>> {
        self.apply(py, x, None)
    }

    fn __repr__(&self) -> String {
        format!(
            "LinearOperator({}, {} cells)",
            self.kind,
            self.product.cells()
        )
    }
}

#[pymethods]
impl HalfSpace {
    /// The operator of one component on the whole grid, made at the first call: displacement first, traction second.
    ///
    /// Examples
    /// --------
    /// >>> import numpy as np, stickslip
    /// >>> grid = stickslip.Grid(5, 3, 1.0, 1.0)
    /// >>> bodies = stickslip.HalfSpace(grid, (stickslip.Material(1.0, 0.3), stickslip.Material.rigid()))
    /// >>> bodies.operator("zz")(np.ones(grid.shape)).shape
    /// (3, 5)
    fn operator(&self, py: Python<'_>, component: Choice<Component>) -> PyResult<LinearOperator> {
        let cells = self.0.grid().cells();
        let operator = unobserved(py, cells, || self.0.operator(component.0))?;
        Ok(LinearOperator::of("ElasticOperator", operator))
    }

    /// The circulant preconditioner of one component; ``None`` for all but xx, yy and zz.
    fn preconditioner(
        &self,
        py: Python<'_>,
        component: Choice<Component>,
    ) -> PyResult<Option<LinearOperator>> {
        let cells = self.0.grid().cells();
        let made = unobserved(py, cells, || self.0.preconditioner(component.0))?;
        Ok(made.map(|operator| LinearOperator::of("ElasticPreconditioner", operator)))
    }

    /// The operator of all three directions: displacements along x, y and z from tractions along x, y and z.
    fn tensor_operator(&self, py: Python<'_>) -> PyResult<TensorOperator> {
        let cells = self.0.grid().cells();
        let directions = [Direction::X, Direction::Y, Direction::Z];
        let operator = unobserved(py, cells, || self.0.tensor_operator(directions))?;
        let workspace = Mutex::new(operator.workspace());
        Ok(TensorOperator {
            operator,
            workspace,
        })
    }
}

type Three = stickslip::ElasticOperator<3>;

/// Displacements along x, y and z from tractions along x, y and z; made by :meth:`HalfSpace.tensor_operator`. One thread
/// at a time may use it.
#[pyclass(frozen, module = "stickslip.cgm")]
pub(crate) struct TensorOperator {
    operator: Three,
    workspace: Mutex<<Three as Operator<3>>::Workspace>,
}

#[pymethods]
impl TensorOperator {
    /// Cells of each component.
    #[getter]
    fn cells(&self) -> usize {
        self.operator.cells()
    }

    /// The product with three arrays, which are read where they lie.
    fn apply<'py>(
        &self,
        py: Python<'py>,
        tractions: [Bound<'py, PyAny>; 3],
    ) -> PyResult<(Array<'py>, Array<'py>, Array<'py>)> {
        let cells = self.operator.cells();
        let [x, y, z] = tractions;
        let from = [
            numbers(&x, cells)?,
            numbers(&y, cells)?,
            numbers(&z, cells)?,
        ];
        let to = [
            target(&from[0], None)?,
            target(&from[1], None)?,
            target(&from[2], None)?,
        ];
        {
            let [mut u, mut v, mut w] = to.each_ref().map(PyArrayMethods::readwrite);
            let from = [
                from[0].as_slice()?,
                from[1].as_slice()?,
                from[2].as_slice()?,
            ];
            let into = [u.as_slice_mut()?, v.as_slice_mut()?, w.as_slice_mut()?];
            let mut workspace = lock(&self.workspace, "operator")?;
            let workspace = &mut *workspace;
            unobserved(py, cells, || {
                self.operator.apply(from, into, workspace);
                Ok(())
            })?;
        }
        Ok(to.map(|array| Array(array.into_any())).into())
    }

    fn __repr__(&self) -> String {
        format!("TensorOperator({} cells)", self.operator.cells())
    }
}

/// The convolution with an influence coefficient by fast transforms.
///
/// Parameters
/// ----------
/// grid : Grid
/// pair : ElasticPair
/// component : Component or str
///     Displacement first, traction second.
/// periodic : bool, default False
///     Whether the grid repeats along x and y.
#[pyclass(frozen, extends = LinearOperator, module = "stickslip.fft")]
pub(crate) struct Convolution;

#[pymethods]
impl Convolution {
    #[new]
    #[pyo3(signature = (grid, pair, component, *, periodic=false))]
    fn new(
        py: Python<'_>,
        grid: &Grid,
        pair: &ElasticPair,
        component: Choice<Component>,
        periodic: bool,
    ) -> PyResult<PyClassInitializer<Self>> {
        let made = unobserved(py, grid.0.cells(), || {
            if periodic {
                Ok(fft::Convolution::periodic(grid.0, &pair.0, component.0))
            } else {
                fft::Convolution::new(grid.0, &pair.0, component.0)
            }
        })?;
        let operator = LinearOperator::of("Convolution", made);
        Ok(PyClassInitializer::from(operator).add_subclass(Self))
    }
}

/// An explicit square matrix, of at most 4096 unknowns.
///
/// Parameters
/// ----------
/// rows : array_like of shape (n, n)
#[pyclass(frozen, extends = LinearOperator, module = "stickslip.dense")]
pub(crate) struct DenseOperator(Arc<stickslip::dense::DenseOperator>);

#[pymethods]
impl DenseOperator {
    #[new]
    fn new(py: Python<'_>, rows: Bound<'_, PyAny>) -> PyResult<PyClassInitializer<Self>> {
        let len = rows.len()?;
        let entries = numbers(&rows, len.saturating_mul(len))?;
        let matrix = stickslip::dense::DenseOperator::from_rows(len, entries.as_slice()?.to_vec());
        Ok(Self::of(matrix.or_raise(py)?))
    }

    /// The matrix of one influence coefficient between all cells of a half-space.
    #[staticmethod]
    fn of_half_space(
        py: Python<'_>,
        bodies: &HalfSpace,
        component: Choice<Component>,
    ) -> PyResult<Py<Self>> {
        let matrix = unobserved(py, bodies.0.grid().cells(), || {
            stickslip::dense::DenseOperator::of_half_space(&bodies.0, component.0)
        })?;
        Py::new(py, Self::of(matrix))
    }

    /// The entry of a row and a column; ``None`` outside the matrix.
    fn get(&self, row: usize, column: usize) -> Option<f64> {
        self.0.get(row, column)
    }

    /// Minimises ``x'Cx/2 + linear'x`` within bounds, with ``sum(x) = total`` if given, directly.
    ///
    /// Returns
    /// -------
    /// DenseMinimum
    #[pyo3(signature = (linear, *, lower=None, upper=None, total=None))]
    fn minimise(
        &self,
        py: Python<'_>,
        linear: Bound<'_, PyAny>,
        lower: Option<Bound<'_, PyAny>>,
        upper: Option<Bound<'_, PyAny>>,
        total: Option<f64>,
    ) -> PyResult<DenseMinimum> {
        let cells = Operator::cells(&*self.0);
        let linear = numbers(&linear, cells)?;
        let linear = linear.as_slice()?;
        let bounds = crate::cgm::bounds(lower, upper, cells)?;
        let found = unobserved(py, cells.saturating_mul(cells), || {
            let [lower, upper] = bounds.each_ref().map(|bound| &bound[..]);
            self.0
                .minimise(linear, &stickslip::cgm::Bounds { lower, upper }, total)
        })?;
        Ok(DenseMinimum(found))
    }
}

impl DenseOperator {
    fn of(matrix: stickslip::dense::DenseOperator) -> PyClassInitializer<Self> {
        let matrix = Arc::new(matrix);
        let operator = LinearOperator::of("DenseOperator", Arc::clone(&matrix));
        PyClassInitializer::from(operator).add_subclass(Self(matrix))
    }
}

/// What a direct minimisation found.
#[pyclass(frozen, module = "stickslip.dense")]
pub(crate) struct DenseMinimum(stickslip::dense::DenseMinimum);

#[pymethods]
impl DenseMinimum {
    /// The unknowns.
    #[getter]
    fn x<'py>(slf: &Bound<'py, Self>) -> Array<'py> {
        crate::array::view_slice(slf, |minimum| &minimum.0.x)
    }

    /// The multiplier of the total; zero without one.
    #[getter]
    fn multiplier(&self) -> f64 {
        self.0.multiplier
    }

    fn __repr__(&self) -> String {
        format!(
            "DenseMinimum({} unknowns, multiplier={:.6e})",
            self.0.x.len(),
            self.0.multiplier
        )
    }
}

/// The operator that changes nothing.
#[pyfunction]
pub(crate) fn identity(cells: usize) -> PyResult<LinearOperator> {
    if cells == 0 {
        return Err(PyRuntimeError::new_err("no cells"));
    }
    Ok(LinearOperator::of(
        "Identity",
        stickslip::Identity::new(cells),
    ))
}
