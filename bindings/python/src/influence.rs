//! Influence coefficients.

use pyo3::prelude::*;
use stickslip::influence;

use crate::argument::Object;
use crate::choice::Choice;
use crate::digits::short;
use crate::error::OrRaise;
use crate::grid::Grid;
use crate::material::{Material, Pair};
use crate::real::Real;
use crate::work::unobserved_on;

/// The nine influence coefficients at a point, with the direction of the displacement first and that of the traction
/// second (lengths over pressures).
#[pyclass(frozen, eq, module = "stickslip.influence")]
#[derive(Clone, Copy, PartialEq)]
pub(crate) struct Tensor(influence::Tensor);

macro_rules! components {
    ($($component:ident),+) => {
        #[pymethods]
        impl Tensor {
            $(
                #[doc = concat!("Coefficient ", stringify!($component), ".")]
                #[getter]
                fn $component(&self) -> f64 {
                    self.0.$component
                }
            )+

            /// The coefficients as rows; the row is the direction of the displacement.
            #[getter]
            fn rows(&self) -> [[f64; 3]; 3] {
                let tensor = self.0;
                [
                    [tensor.xx, tensor.xy, tensor.xz],
                    [tensor.yx, tensor.yy, tensor.yz],
                    [tensor.zx, tensor.zy, tensor.zz],
                ]
            }

            fn __repr__(&self) -> String {
                let parts = [$(format!("{}={}", stringify!($component), short(self.0.$component))),+];
                format!("Tensor({})", parts.join(", "))
            }
        }
    };
}

components!(xx, xy, xz, yx, yy, yz, zx, zy, zz);

/// A rectangle under uniform traction.
///
/// Parameters
/// ----------
/// a, b : float
///     Half-sides along x and y (lengths), positive.
///
/// Raises
/// ------
/// NotPositive
#[pyclass(frozen, module = "stickslip.influence")]
pub(crate) struct Rectangle {
    cell: influence::Rectangle,
    /// Half-sides of the rectangle.
    half: [f64; 2],
}

#[pymethods]
impl Rectangle {
    #[new]
    fn new(py: Python<'_>, a: Real, b: Real) -> PyResult<Self> {
        let cell = influence::Rectangle::new(a.0, b.0).or_raise(py)?;
        let half = [a.0, b.0];
        Ok(Self { cell, half })
    }

    /// Returns the coefficients of a body at a position relative to the centre (lengths).
    fn tensor(&self, material: Object<Material>, x: Real, y: Real) -> Tensor {
        Tensor(self.cell.tensor(&material.0, x.0, y.0))
    }

    /// Returns the coefficients of a pair at a position relative to the centre (lengths).
    fn pair_tensor(&self, pair: Pair, x: Real, y: Real) -> Tensor {
        Tensor(self.cell.pair_tensor(&pair.0, x.0, y.0))
    }

    fn __repr__(&self) -> String {
        let [a, b] = self.half.map(short);
        format!("Rectangle(a={a}, b={b})")
    }
}

/// One influence coefficient for all distances between cells of a grid.
///
/// Parameters
/// ----------
/// grid : Grid
///     The cells.
/// pair : ElasticPair or two Materials
///     The two bodies.
/// component : Component or str
///     Direction of the displacement first, direction of the traction second.
#[pyclass(frozen, module = "stickslip.influence")]
pub(crate) struct Table(influence::Table);

#[pymethods]
impl Table {
    #[new]
    fn new(
        py: Python<'_>,
        grid: Object<Grid>,
        pair: Pair,
        component: Choice<influence::Component>,
    ) -> PyResult<Self> {
        let sample = || influence::Table::sample(grid.0, &pair.0, component.0);
        unobserved_on(py, grid.0, sample).map(Self)
    }

    /// Component of the table.
    #[getter]
    fn component(&self) -> Choice<influence::Component> {
        Choice(self.0.component())
    }

    /// Number of distances along x and y, of one sign.
    #[getter]
    fn size(&self) -> (usize, usize) {
        self.0.size().into()
    }

    /// Returns the coefficient at a distance in cells along x and y, of either sign, or ``None`` outside the table.
    fn get(&self, i: isize, j: isize) -> Option<f64> {
        self.0.get(i, j)
    }

    fn __repr__(&self) -> String {
        let [nx, ny] = self.0.size();
        format!("Table('{}', {nx} x {ny})", self.component().name())
    }
}
