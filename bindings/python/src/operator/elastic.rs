//! Operators of elastic bodies, applied by fast Fourier transforms.

use std::sync::Mutex;

use numpy::PyArrayMethods;
use pyo3::prelude::*;
use stickslip::influence::{Component, Direction};
use stickslip::{Operator, Scratch, fft};

use crate::argument::Object;
use crate::array::Array;
use crate::choice::Choice;
use crate::grid::Grid;
use crate::half_space::HalfSpace;
use crate::material::Pair;
use crate::operator::{LinearOperator, check_grid, numbers, target};
use crate::solution_pool::lock;
use crate::work::{unobserved, unobserved_on};

#[pymethods]
impl HalfSpace {
    /// Returns the operator of one component on the whole grid, created at the first call. The component names the
    /// direction of the displacement first and that of the traction second.
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
        let grid = self.0.grid();
        Ok(LinearOperator::on("ElasticOperator", grid, operator))
    }

    /// Returns the circulant preconditioner of one component; ``None`` for all components except xx, yy and zz.
    fn preconditioner(
        &self,
        py: Python<'_>,
        component: Choice<Component>,
    ) -> PyResult<Option<LinearOperator>> {
        let cells = self.0.grid().cells();
        let made = unobserved(py, cells, || self.0.preconditioner(component.0))?;
        let grid = self.0.grid();
        Ok(made.map(|operator| LinearOperator::on("ElasticPreconditioner", grid, operator)))
    }

    /// Returns the operator of all three directions: displacements along x, y and z due to tractions along x, y and z.
    fn tensor_operator(&self, py: Python<'_>) -> PyResult<TensorOperator> {
        let cells = self.0.grid().cells();
        let directions = [Direction::X, Direction::Y, Direction::Z];
        let operator = unobserved(py, cells, || self.0.tensor_operator(directions))?;
        let scratch = Mutex::new(operator.scratch().expect("memory for a product"));
        let grid = self.0.grid();
        Ok(TensorOperator {
            operator,
            scratch,
            grid,
        })
    }
}

type Three = stickslip::ElasticOperator<3>;

/// Operator that computes displacements along x, y and z from tractions along x, y and z; created by
/// :meth:`HalfSpace.tensor_operator`. One thread at a time may use it.
#[pyclass(frozen, module = "stickslip.cgm")]
pub(crate) struct TensorOperator {
    operator: Three,
    scratch: Mutex<Scratch>,
    grid: stickslip::Grid,
}

#[pymethods]
impl TensorOperator {
    /// Number of cells of each component.
    #[getter]
    fn cells(&self) -> usize {
        self.operator.cells()
    }

    /// Applies the operator to three arrays that are read in place: tractions along x, y and z (pressures). Returns the
    /// displacements along x, y and z (lengths).
    fn apply<'py>(
        &self,
        py: Python<'py>,
        tractions: [Bound<'py, PyAny>; 3],
    ) -> PyResult<(Array<'py>, Array<'py>, Array<'py>)> {
        let cells = self.operator.cells();
        tractions
            .iter()
            .try_for_each(|traction| check_grid(traction, Some(self.grid)))?;
        let [x, y, z] = tractions;
        let [x, y, z] = [
            numbers(&x, cells)?,
            numbers(&y, cells)?,
            numbers(&z, cells)?,
        ];
        let to = [target(&x, None)?, target(&y, None)?, target(&z, None)?];
        {
            let [mut u, mut v, mut w] = to.each_ref().map(PyArrayMethods::readwrite);
            let from = [x.as_slice()?, y.as_slice()?, z.as_slice()?];
            let into = [u.as_slice_mut()?, v.as_slice_mut()?, w.as_slice_mut()?];
            let mut scratch = lock(&self.scratch, "operator")?;
            let scratch = &mut *scratch;
            unobserved(py, cells, || {
                self.operator.apply(from, into, scratch);
                Ok(())
            })?;
        }
        Ok(to.map(Array::of).into())
    }

    fn __repr__(&self) -> String {
        format!("TensorOperator({} cells)", self.operator.cells())
    }
}

/// The convolution with an influence coefficient by fast Fourier transforms.
///
/// Parameters
/// ----------
/// grid : Grid
///     The cells.
/// pair : ElasticPair or two Materials
///     The two bodies.
/// component : Component or str
///     Direction of the displacement first, direction of the traction second.
/// periodic : bool, default False
///     Whether the grid is periodic along x and y.
#[pyclass(frozen, extends = LinearOperator, module = "stickslip.fft")]
pub(crate) struct Convolution;

#[pymethods]
impl Convolution {
    #[new]
    #[pyo3(signature = (grid, pair, component, *, periodic=false))]
    fn new(
        py: Python<'_>,
        grid: Object<Grid>,
        pair: Pair,
        component: Choice<Component>,
        #[pyo3(from_py_with = crate::real::flag)] periodic: bool,
    ) -> PyResult<PyClassInitializer<Self>> {
        let made = unobserved_on(py, grid.0, || {
            if periodic {
                Ok(fft::Convolution::periodic(grid.0, &pair.0, component.0))
            } else {
                fft::Convolution::new(grid.0, &pair.0, component.0)
            }
        })?;
        let operator = LinearOperator::on("Convolution", grid.0, made);
        Ok(PyClassInitializer::from(operator).add_subclass(Self))
    }
}
