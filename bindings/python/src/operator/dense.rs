//! Operators with an explicit matrix.

use std::sync::Arc;

use pyo3::prelude::*;
use stickslip::Operator;
use stickslip::influence::Component;

use crate::argument::Object;
use crate::array::{Array, view_slice};
use crate::cgm::{bounds, check_grids};
use crate::choice::Choice;
use crate::digits::{counted, short};
use crate::error::OrRaise;
use crate::half_space::HalfSpace;
use crate::operator::{LinearOperator, contiguous, numbers};
use crate::real::Real;
use crate::work::{unobserved, unobserved_on};

/// An explicit square matrix with at most 4096 unknowns.
///
/// Parameters
/// ----------
/// rows : array_like of shape (n, n)
///     The entries of the symmetric matrix.
///
/// Raises
/// ------
/// TooManyCells, Sample
#[pyclass(frozen, extends = LinearOperator, module = "stickslip.dense")]
pub(crate) struct DenseOperator(Arc<stickslip::dense::DenseOperator>);

#[pymethods]
impl DenseOperator {
    #[new]
    fn new(py: Python<'_>, rows: Bound<'_, PyAny>) -> PyResult<PyClassInitializer<Self>> {
        let len = rows.len()?;
        let entries = contiguous(&rows, len.saturating_mul(len))?;
        let matrix = stickslip::dense::DenseOperator::from_rows(len, entries.as_slice()?.to_vec());
        Ok(Self::of(matrix.or_raise(py)?, None))
    }

    /// Creates the matrix of one influence coefficient between all cells of a half-space.
    #[staticmethod]
    fn of_half_space(
        py: Python<'_>,
        bodies: Object<HalfSpace>,
        component: Choice<Component>,
    ) -> PyResult<Py<Self>> {
        let grid = bodies.0.grid();
        let matrix = unobserved_on(py, grid, || {
            stickslip::dense::DenseOperator::of_half_space(&bodies.0, component.0)
        })?;
        Py::new(py, Self::of(matrix, Some(grid)))
    }

    /// Returns the entry of a row and a column, or ``None`` outside the matrix.
    fn get(&self, row: usize, column: usize) -> Option<f64> {
        self.0.get(row, column)
    }

    /// Minimises ``x'Cx/2 + linear'x`` within bounds, with ``sum(x) = total`` if given, by a direct method.
    ///
    /// Parameters
    /// ----------
    /// linear : array_like
    ///     The linear term, one number per unknown.
    /// lower, upper : float or array_like, optional
    ///     Bounds of the unknowns; zero and infinity by default.
    /// total : float, optional
    ///     Sum of the unknowns; free by default.
    ///
    /// Returns
    /// -------
    /// DenseMinimum
    ///
    /// Raises
    /// ------
    /// Sample, Bounds, Total, NotPositiveDefinite, NotConverged
    /// GridMismatch, Shape
    ///     See :func:`stickslip.cgm.minimise`.
    #[pyo3(signature = (linear, *, lower=None, upper=None, total=None))]
    fn minimise(
        slf: &Bound<'_, Self>,
        py: Python<'_>,
        linear: Bound<'_, PyAny>,
        lower: Option<Bound<'_, PyAny>>,
        upper: Option<Bound<'_, PyAny>>,
        total: Option<Real>,
    ) -> PyResult<DenseMinimum> {
        let (matrix, grid) = (&slf.get().0, slf.as_super().get().grid);
        check_grids([Some(&linear), lower.as_ref(), upper.as_ref()], grid)?;
        let cells = Operator::cells(&**matrix);
        let linear = numbers(&linear, cells)?;
        let linear = linear.as_slice()?;
        let bounds = bounds(lower, upper, cells)?;
        let found = unobserved(py, cells.saturating_mul(cells), || {
            let [lower, upper] = bounds.each_ref().map(|bound| &bound[..]);
            matrix.minimise(
                linear,
                &stickslip::cgm::Bounds { lower, upper },
                total.map(f64::from),
            )
        })?;
        Ok(DenseMinimum(found))
    }
}

impl DenseOperator {
    /// Creates an operator of a matrix, whose unknowns are the cells of a grid if it is given.
    fn of(
        matrix: stickslip::dense::DenseOperator,
        grid: Option<stickslip::Grid>,
    ) -> PyClassInitializer<Self> {
        let matrix = Arc::new(matrix);
        let operator = LinearOperator {
            grid,
            ..LinearOperator::of("DenseOperator", Arc::clone(&matrix))
        };
        PyClassInitializer::from(operator).add_subclass(Self(matrix))
    }
}

/// Result of a direct minimisation.
#[pyclass(frozen, module = "stickslip.dense")]
pub(crate) struct DenseMinimum(stickslip::dense::DenseMinimum);

#[pymethods]
impl DenseMinimum {
    /// The unknowns.
    #[getter]
    fn x<'py>(slf: &Bound<'py, Self>) -> Array<'py> {
        view_slice(slf, |minimum| &minimum.0.x)
    }

    /// Multiplier of the prescribed total; zero without a total.
    #[getter]
    fn multiplier(&self) -> f64 {
        self.0.multiplier
    }

    fn __repr__(&self) -> String {
        format!(
            "DenseMinimum({}, multiplier={})",
            counted(self.0.x.len(), "unknown"),
            short(self.0.multiplier)
        )
    }
}
