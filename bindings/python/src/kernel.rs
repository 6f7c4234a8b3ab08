//! Bodies by their response to waves, by influence coefficients, or by operators.

use std::sync::Arc;

use numpy::{AllowTypeChange, PyArrayLike2};
use pyo3::exceptions::{PyKeyboardInterrupt, PyTypeError, PyValueError};
use pyo3::prelude::*;
use pyo3::types::PyDict;
use stickslip::influence::{Component, Direction};
use stickslip::kernel::{CoefficientTable, Operators};
use stickslip::layers::Response;

use crate::choice::Choice;
use crate::error::OrRaise;
use crate::function::raising;
use crate::grid::Grid;
use crate::material::ElasticPair;
use crate::operator::{LinearOperator, Product, Shared, product_of};
use crate::real::{Real, is_real};

/// Two bodies by a response of your own, in place of the pair of a :class:`HalfSpace`: made by :meth:`isotropic`,
/// :meth:`tabulated` or :meth:`operators`. It is not pickled, nor are the bodies made of it.
///
/// Examples
/// --------
/// >>> import stickslip as ss
/// >>> rigid, steel = ss.Material.rigid(), ss.Material(210e9, 0.3)
/// >>> coated = ss.ElasticPair(steel.coated([ss.layers.Layer(400e9, 0.25, 2e-6)]), rigid)
/// >>> def response(k):
/// ...     found = coated.response(k)
/// ...     return found.normal, found.along, found.across, found.coupling
/// >>> outermost = ss.ElasticPair(ss.Material(400e9, 0.25), rigid)
/// >>> kernel = ss.Kernel.isotropic(outermost, 2e-6, response)
/// >>> grid = ss.Grid.square(32, 20e-6)
/// >>> ball = ss.surface.sphere(grid, 1e-3)
/// >>> contact, same = (
/// ...     ss.NormalProblem(ss.HalfSpace(grid, bodies), ball, force=0.01).solve() for bodies in (kernel, coated)
/// ... )
/// >>> abs(contact.approach / same.approach - 1) < 1e-6
/// True
#[pyclass(frozen, module = "stickslip", from_py_object)]
#[derive(Clone)]
pub(crate) struct Kernel(pub(crate) stickslip::Kernel);

#[pymethods]
impl Kernel {
    /// Bodies without a direction in their plane.
    ///
    /// Parameters
    /// ----------
    /// near : ElasticPair
    ///     The homogeneous half-spaces that waves much shorter than the thickness see, to 1e-10 for k > 20 / thickness; they
    ///     lend hardness and moduli. Grids that repeat along both axes take the response as it is.
    /// thickness : float
    ///     Of the outermost layer (a length), positive.
    /// response : callable
    ///     Of a wave number k > 0 (one over a length), as a float: the displacements by waves of traction of that number
    ///     (lengths over pressures, not times k): normal by pressure, along and across the wave by traction, and the coupling.
    ///     It is called many times, under the GIL, on many threads; where it raises an exception, it counts as not a number,
    ///     which is refused, and the exception goes to `sys.unraisablehook`; Ctrl-C there interrupts the main thread.
    ///
    /// Raises
    /// ------
    /// NotPositive, NotFinite, UnsupportedForCoatings
    #[staticmethod]
    fn isotropic(
        py: Python<'_>,
        near: &ElasticPair,
        thickness: Real,
        response: Bound<'_, PyAny>,
    ) -> PyResult<Self> {
        // What it raises at first is told; a thickness that is no length is refused below.
        if thickness.0 > 0.0 && thickness.0.is_finite() {
            let first = response.call1((1.0 / thickness.0,))?;
            let _: (f64, f64, f64, f64) = first.extract().map_err(|_| {
                PyTypeError::new_err(
                    "response must return four numbers: normal, along, across, coupling",
                )
            })?;
        }
        let response = response.unbind();
        let at = move |k: f64| {
            let (normal, along, across, coupling) = Python::attach(|py| {
                let response = response.bind(py);
                let asked = response.call1((k,)).and_then(|found| found.extract());
                asked.unwrap_or_else(|error| {
                    tell(py, error, response);
                    [f64::NAN; 4].into()
                })
            });
            Response {
                normal,
                along,
                across,
                coupling,
            }
        };
        stickslip::Kernel::isotropic(near.0, thickness.0, at)
            .or_raise(py)
            .map(Self)
    }

    /// Bodies by their influence coefficients, for grids that do not repeat.
    ///
    /// Parameters
    /// ----------
    /// near : ElasticPair
    ///     Homogeneous bodies that lend hardness and moduli.
    /// sides : (float, float)
    ///     Sides of a cell along x and y (lengths): those of the grids.
    /// coefficients : dict
    ///     By the name of a component, "zz" and others, an array of shape (ny, nx): the displacement at the centre of a cell,
    ///     j cells further along y and i along x, by a unit traction on one (lengths over pressures). Distances of the other
    ///     sign follow from the parity. "xy", "zx" and "zy" are zero where they are not given, and "yx", "xz" and "yz" are
    ///     theirs.
    ///
    /// Raises
    /// ------
    /// NotPositive, Length, Sample, UnsupportedForCoatings
    #[staticmethod]
    fn tabulated(
        py: Python<'_>,
        near: &ElasticPair,
        sides: [f64; 2],
        coefficients: Bound<'_, PyDict>,
    ) -> PyResult<Self> {
        let mut table: Option<CoefficientTable> = None;
        for (name, values) in coefficients {
            is_real(&values, "coefficients")?;
            let component: Choice<Component> = name.extract()?;
            let values: PyArrayLike2<'_, f64, AllowTypeChange> = values.extract()?;
            let values = values.as_array();
            let (ny, nx) = values.dim();
            let so_far = match table {
                None => CoefficientTable::new(sides, [nx, ny]).or_raise(py)?,
                Some(table) if table.size() == [nx, ny] => table,
                Some(_) => return Err(PyValueError::new_err("coefficients differ in their shape")),
            };
            let values = values.iter().copied().collect();
            table = Some(so_far.with(component.0, values).or_raise(py)?);
        }
        let table = table.ok_or_else(|| PyValueError::new_err("coefficients has no component"))?;
        stickslip::Kernel::tabulated(near.0, table)
            .or_raise(py)
            .map(Self)
    }

    /// Bodies by operators on the cells of a grid, of any boundary: whatever displacements they compute from tractions.
    ///
    /// A contact is solved on all cells of the grid: no window, no coarser grids. A problem takes the operator that has all
    /// directions it asks for and the fewest others: normal problems ask for "z", tangential ones for "x", "y" or both, and
    /// all three are found together where ``near`` is coupled. Rolling, ranks, dense matrices, edges inside the cells and
    /// stresses refuse such bodies.
    ///
    /// Parameters
    /// ----------
    /// near : ElasticPair
    ///     The homogeneous half-spaces that they resemble for waves of a few cells, whose inverse preconditions the solves: they
    ///     converge the faster the better it fits, to the same answer. It lends hardness and moduli, and says whether pressure
    ///     and traction are coupled.
    /// grid : Grid
    ///     The cells.
    /// operators : dict
    ///     By the directions that it couples, as "z", "xy" or "xyz", a callable or a :class:`~stickslip.cgm.LinearOperator`,
    ///     symmetric and positive. A callable is given an array of tractions of shape (directions, ny, nx), pressures in the
    ///     direction z, and returns as many displacements of body 1 relative to body 2 in the same order (lengths). A
    ///     LinearOperator has as many unknowns: :class:`~stickslip.dense.DenseOperator` takes the compliance matrix of a
    ///     finite-element code. On a grid that repeats along both axes uniform tractions must displace nothing.
    /// lower_bounds : dict, optional
    ///     By the names of callables, lower bounds of their smallest eigenvalues, by which errors are certified; 0 by default.
    ///     Without one pressure and traction are not found together, nor stiffness. A LinearOperator has its own.
    ///
    /// Raises
    /// ------
    /// UnsupportedForCoatings, IncompleteKernel, RepeatedDirection, NotPositive, NotFinite, UnsupportedByModel, BelowMinimum, Memory
    ///
    /// Notes
    /// -----
    /// A callable runs under the GIL, on a thread of the package where a grid is large. An exception in it ends the solve, which
    /// raises it and leaves solvers and histories as they were.
    ///
    /// Examples
    /// --------
    /// A bed of springs, of which each cell yields by 0.5 under a unit of pressure:
    ///
    /// >>> import math, stickslip as ss
    /// >>> near = ss.ElasticPair(ss.Material(1.0, 0.5), ss.Material.rigid())
    /// >>> grid = ss.Grid.square(32, 1.0)
    /// >>> bed = ss.Kernel.operators(near, grid, {"z": lambda p: 0.5 * p}, lower_bounds={"z": 0.5})
    /// >>> ball, depth = ss.surface.sphere(grid, 1.0), 0.06
    /// >>> contact = ss.NormalProblem(ss.HalfSpace(grid, bed), ball, approach=depth).solve()
    /// >>> abs(contact.force / (math.pi * depth**2 / 0.5) - 1) < 0.02  # p = (d - r^2 / 2 R) / c
    /// True
    #[staticmethod]
    #[pyo3(signature = (near, grid, operators, *, lower_bounds=None))]
    fn operators(
        py: Python<'_>,
        near: &ElasticPair,
        grid: &Grid,
        operators: Bound<'_, PyDict>,
        lower_bounds: Option<Bound<'_, PyDict>>,
    ) -> PyResult<Self> {
        let lower_bounds = lower_bounds.unwrap_or_else(|| PyDict::new(py));
        for name in lower_bounds.keys() {
            let of = operators.get_item(&name)?;
            if of.is_none_or(|of| of.is_instance_of::<LinearOperator>()) {
                return Err(PyValueError::new_err(format!(
                    "lower_bounds has {}, which is no callable of operators",
                    name.repr()?
                )));
            }
        }
        let mut given = Operators::new();
        for (name, operator) in operators {
            let directions = directions(&name)?;
            let shape = [directions.len(), grid.0.ny(), grid.0.nx()];
            let bound: Option<Real> = lower_bounds
                .get_item(&name)?
                .map(|bound| bound.extract())
                .transpose()?;
            let product = product_of(&operator, &shape, bound.map_or(0.0, |bound| bound.0))?;
            let (found, due): (usize, usize) = (product.cells(), shape.iter().product());
            if found != due {
                return Err(PyValueError::new_err(format!(
                    "the operator {} has {found} unknowns, expected {due}",
                    name.repr()?
                )));
            }
            given = with(given, &directions, product);
        }
        let kernel = raising(|| stickslip::Kernel::operators(near.0, given))?;
        kernel.or_raise(py).map(Self)
    }

    /// The pair that lends hardness and moduli, marked as that of this kernel.
    #[getter]
    fn pair(&self) -> ElasticPair {
        self.0.pair().into()
    }

    fn __repr__(&self) -> String {
        format!("Kernel({})", self.pair().__repr__())
    }
}

/// The directions of an operator, by their letters: up to three.
fn directions(name: &Bound<'_, PyAny>) -> PyResult<Vec<Direction>> {
    let letters: Option<String> = name.extract().ok();
    let known = letters.into_iter().flat_map(|letters| {
        let of = |letter| match letter {
            'x' => Some(Direction::X),
            'y' => Some(Direction::Y),
            'z' => Some(Direction::Z),
            _ => None,
        };
        letters.chars().map(of).collect::<Vec<_>>()
    });
    match known.collect::<Option<Vec<_>>>() {
        Some(directions) if (1..=3).contains(&directions.len()) => Ok(directions),
        _ => Err(PyValueError::new_err(format!(
            "directions of an operator are one to three of the letters x, y and z, got {}",
            name.repr()?
        ))),
    }
}

fn with(given: Operators, directions: &[Direction], product: Arc<dyn Product>) -> Operators {
    let operator = Shared(product);
    match *directions {
        [one] => given.with([one], operator),
        [one, two] => given.with([one, two], operator),
        [one, two, three] => given.with([one, two, three], operator),
        _ => given,
    }
}

/// Tells of an exception that no caller can be given.
pub(crate) fn tell(py: Python<'_>, error: PyErr, callback: &Bound<'_, PyAny>) {
    let interrupts = error.is_instance_of::<PyKeyboardInterrupt>(py)
        && py
            .import("_thread")
            .and_then(|thread| thread.call_method0("interrupt_main"))
            .is_ok();
    if !interrupts {
        error.write_unraisable(py, Some(callback));
    }
}
