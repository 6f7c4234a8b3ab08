//! Two elastic half-spaces on a grid.

use pyo3::prelude::*;
use stickslip::Operator;
use stickslip::influence::{Component, Direction};

use crate::array::{Array, copy};
use crate::choice::Choice;
use crate::error::OrRaise;
use crate::field::Samples;
use crate::grid::{Bodies, Boundary, ElasticPair, Grid, Surroundings};
use crate::work::unobserved;

/// A pair of half-spaces on a grid. What problems need of it is made when first needed, and shared.
///
/// Parameters
/// ----------
/// grid : Grid
/// pair : ElasticPair, or two Materials
/// boundary : Boundary or str, default "non_periodic"
///     "non_periodic", "periodic" or ("periodic_along_y", datum).
///
/// Raises
/// ------
/// NotPositive, Memory, Below
///
/// Examples
/// --------
/// >>> import stickslip
/// >>> steel = stickslip.Material(213e9, 0.29)
/// >>> bodies = stickslip.HalfSpace(stickslip.Grid.square(64, 0.4e-3), (steel, steel))
/// >>> bodies.grid.cells
/// 4096
#[pyclass(frozen, module = "stickslip", from_py_object)]
#[derive(Clone)]
pub(crate) struct HalfSpace(pub(crate) stickslip::HalfSpace);

#[pymethods]
impl HalfSpace {
    #[new]
    #[pyo3(signature = (grid, pair, boundary=None))]
    fn new(py: Python<'_>, grid: &Grid, pair: Bodies, boundary: Option<Surroundings>) -> PyResult<Self> {
        let boundary = boundary.map(|boundary| boundary.0).unwrap_or_default();
        let bodies = stickslip::HalfSpace::with_boundary(grid.0, pair.0, boundary);
        bodies.or_raise(py).map(Self)
    }

    /// The grid.
    #[getter]
    fn grid(&self) -> Grid {
        Grid(self.0.grid())
    }

    /// The two bodies.
    #[getter]
    fn pair(&self) -> ElasticPair {
        ElasticPair(*self.0.pair())
    }

    /// What lies beyond the edge of the grid.
    #[getter]
    fn boundary(&self) -> Boundary {
        Boundary(self.0.boundary())
    }

    /// Displacements of all cells by tractions along one axis: one product with the operator of a component.
    ///
    /// Parameters
    /// ----------
    /// traction : array_like of shape (ny, nx)
    ///     Pressures.
    /// component : Component or str, default "zz"
    ///     Displacement first, traction second.
    ///
    /// Returns
    /// -------
    /// ndarray of shape (ny, nx)
    ///     Lengths.
    #[pyo3(signature = (traction, component=None))]
    fn displacement<'py>(
        &self,
        py: Python<'py>,
        traction: Samples<'py>,
        component: Option<Choice<Component>>,
    ) -> PyResult<Array<'py>> {
        let component = component.map_or(Component::ZZ, |component| component.0);
        let grid = self.0.grid();
        let traction = traction.on(py, "traction", grid)?;
        if traction.grid() != grid {
            // A product of no meaning: the check of a solve says what is wrong.
            let pressed = stickslip::NormalControl::Force(0.0);
            let problem = stickslip::NormalProblem::builder(&self.0, traction, pressed).build();
            problem.or_raise(py)?;
            return Ok(copy(py, &stickslip::Field::zeros(grid)));
        }
        let moved = unobserved(py, grid.cells(), || {
            let operator = self.0.operator(component)?;
            let mut moved = stickslip::Field::zeros(grid);
            let (from, to) = ([traction.as_slice()], [moved.as_mut_slice()]);
            operator.apply(from, to, &mut operator.workspace());
            Ok(moved)
        })?;
        Ok(copy(py, &moved))
    }

    /// Displacements along x, y and z of all cells by tractions along x, y and z together.
    ///
    /// Parameters
    /// ----------
    /// tractions : sequence of three array_like of shape (ny, nx)
    ///
    /// Returns
    /// -------
    /// tuple of three ndarray of shape (ny, nx)
    fn displacements<'py>(
        &self,
        py: Python<'py>,
        tractions: [Samples<'py>; 3],
    ) -> PyResult<(Array<'py>, Array<'py>, Array<'py>)> {
        let grid = self.0.grid();
        let mut fields = Vec::with_capacity(3);
        for samples in &tractions {
            let field = samples.on(py, "traction", grid)?;
            // As every field of a contact.
            stickslip::NormalProblem::builder(
                &self.0,
                field.clone(),
                stickslip::NormalControl::Force(0.0),
            )
            .build()
            .or_raise(py)?;
            fields.push(field);
        }
        let moved = unobserved(py, grid.cells(), || {
            let operator = self.0.tensor_operator([Direction::X, Direction::Y, Direction::Z])?;
            let mut moved = [0; 3].map(|_| stickslip::Field::zeros(grid));
            let from = [0, 1, 2].map(|axis: usize| fields[axis].as_slice());
            let to = moved.each_mut().map(stickslip::Field::as_mut_slice);
            operator.apply(from, to, &mut operator.workspace());
            Ok(moved)
        })?;
        Ok(moved.each_ref().map(|field| copy(py, field)).into())
    }

    fn __reduce__<'py>(
        slf: &Bound<'py, Self>,
    ) -> (Bound<'py, pyo3::types::PyType>, (Grid, ElasticPair, Boundary)) {
        let bodies = slf.get();
        (slf.get_type(), (bodies.grid(), bodies.pair(), bodies.boundary()))
    }

    fn __repr__(&self) -> String {
        let grid = self.0.grid();
        format!(
            "HalfSpace({} x {} cells of {} x {}, {:?}, E* = {})",
            grid.nx(),
            grid.ny(),
            grid.dx(),
            grid.dy(),
            self.0.boundary(),
            self.0.pair().contact_modulus()
        )
    }
}
