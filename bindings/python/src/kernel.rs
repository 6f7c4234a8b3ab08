//! Bodies described by their response to waves, by influence coefficients, or by operators.

use std::sync::Arc;

use numpy::{AllowTypeChange, PyArrayLike2};
use pyo3::exceptions::{PyKeyboardInterrupt, PyTypeError, PyValueError};
use pyo3::prelude::*;
use pyo3::types::PyDict;
use stickslip::influence::{Component, Direction};
use stickslip::kernel::{CoefficientTable, Operators};
use stickslip::layers::Response;

use crate::argument::{Object, by_value};
use crate::choice::Choice;
use crate::conversion::kind_of;
use crate::error::OrRaise;
use crate::function::raising;
use crate::grid::Grid;
use crate::material::ElasticPair;
use crate::operator::{LinearOperator, Product, Shared, product_of};
use crate::real::{Real, in_axes, is_real, named_by, wrong_type};

/// Two bodies with a user-defined response, in place of the material pair of a :class:`HalfSpace`. A kernel is created by
/// :meth:`isotropic`, :meth:`tabulated` or :meth:`operators`. Kernels cannot be pickled, nor can bodies that use them.
///
/// Examples
/// --------
/// >>> import stickslip as ss
/// >>> rigid, steel = ss.Material.rigid(), ss.Material(210e9, 0.3)
/// >>> coated = ss.ElasticPair(steel.coated([ss.layers.Layer(400e9, 0.25, thickness=2e-6)]), rigid)
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
#[pyclass(frozen, eq, module = "stickslip")]
#[derive(Clone, PartialEq)]
pub(crate) struct Kernel(pub(crate) stickslip::Kernel);

by_value!(Kernel);

#[pymethods]
impl Kernel {
    /// Creates bodies whose response is isotropic in the plane of the surface.
    ///
    /// Parameters
    /// ----------
    /// near : ElasticPair
    ///     The homogeneous half-spaces that give the response to waves much shorter than the thickness. Their response
    ///     must agree with ``response`` to 1e-10 for k > 20 / thickness. Hardness and moduli are taken from this pair.
    ///     Grids that are periodic along both axes use ``response`` unchanged.
    /// thickness : float
    ///     Thickness of the outermost layer (a length), positive.
    /// response : callable
    ///     A function of the wave number k > 0 (one over a length, a float). It returns the displacements under waves of
    ///     traction of that wave number (lengths over pressures, not multiplied by k): normal due to pressure, along and
    ///     across the wave due to traction, and the coupling. It is called many times, under the GIL, on many threads. If
    ///     the function raises an exception, its value counts as NaN, which is rejected, and the exception is passed to
    ///     `sys.unraisablehook`; Ctrl-C there interrupts the main thread.
    ///
    /// Raises
    /// ------
    /// NotPositive, NotFinite, UnsupportedForCoatings
    #[staticmethod]
    fn isotropic(
        py: Python<'_>,
        near: Object<ElasticPair>,
        thickness: Real,
        response: Bound<'_, PyAny>,
    ) -> PyResult<Self> {
        if !response.is_callable() {
            let message = format!("must be a callable, got {}", kind_of(&response));
            return Err(wrong_type(py, "response", &message));
        }
        // An exception in this first call is raised to the caller; a thickness that is not a valid length is rejected
        // below.
        if thickness.0 > 0.0 && thickness.0.is_finite() {
            let first = response.call1((1.0 / thickness.0,))?;
            let _: (f64, f64, f64, f64) = first.extract().map_err(|_| {
                PyTypeError::new_err(
                    "response must return four numbers: normal, along, across and coupling",
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

    /// Creates bodies from their influence coefficients, for non-periodic grids.
    ///
    /// Parameters
    /// ----------
    /// near : ElasticPair
    ///     Homogeneous bodies from which hardness and moduli are taken.
    /// sides : (float, float)
    ///     Sides of a cell along x and y (lengths), equal to those of the grids.
    /// coefficients : dict
    ///     Arrays of shape (ny, nx) by the name of a component, such as "zz". An entry is the displacement at the centre
    ///     of a cell that is j cells further along y and i cells further along x than a cell with unit traction (lengths
    ///     over pressures). The displacements at distances of the other sign follow from the parity. The components "xy",
    ///     "zx" and "zy" are zero by default; "yx", "xz" and "yz" follow from them.
    ///
    /// Raises
    /// ------
    /// NotPositive, Length, Sample, UnsupportedForCoatings
    #[staticmethod]
    fn tabulated(
        py: Python<'_>,
        near: Object<ElasticPair>,
        sides: [f64; 2],
        coefficients: Bound<'_, PyDict>,
    ) -> PyResult<Self> {
        let mut table: Option<CoefficientTable> = None;
        for (name, values) in coefficients {
            is_real(&values, "coefficients")?;
            let component: Choice<Component> = name
                .extract()
                .map_err(|error: PyErr| named_by(py, error, "a key of coefficients"))?;
            let values: PyArrayLike2<'_, f64, AllowTypeChange> =
                in_axes(&values, "the array of coefficients", Some(sides))?.extract()?;
            let values = values.as_array();
            let (ny, nx) = values.dim();
            let so_far = match table {
                None => CoefficientTable::new(sides, [nx, ny]).or_raise(py)?,
                Some(table) if table.size() == [nx, ny] => table,
                Some(_) => {
                    return Err(PyValueError::new_err(
                        "the arrays of coefficients must have the same shape",
                    ));
                }
            };
            let values = values.iter().copied().collect();
            table = Some(so_far.with(component.0, values).or_raise(py)?);
        }
        let table = table.ok_or_else(|| {
            PyValueError::new_err("coefficients must contain at least one component")
        })?;
        stickslip::Kernel::tabulated(near.0, table)
            .or_raise(py)
            .map(Self)
    }

    /// Creates bodies from operators on the cells of a grid, which compute displacements from tractions, for any
    /// boundary.
    ///
    /// A contact is solved on all cells of the grid, without a window or coarser grids. A problem uses the operator with
    /// the fewest directions among those that have all required directions. Normal problems require "z"; tangential
    /// problems require "x", "y" or both. If ``near`` is coupled, all three directions are solved simultaneously.
    /// Rolling, ranks, dense matrices, edges inside the cells and stresses are not available for such bodies.
    ///
    /// Parameters
    /// ----------
    /// near : ElasticPair
    ///     Homogeneous half-spaces that approximate the bodies for wavelengths of a few cells. Their inverse
    ///     preconditions the solves: a better approximation gives faster convergence to the same solution. The pair also
    ///     provides hardness and moduli, and determines whether pressure and traction are coupled.
    /// grid : Grid
    ///     The cells.
    /// operators : dict
    ///     Callables or :class:`~stickslip.cgm.LinearOperator` objects, symmetric and positive, by the directions that
    ///     they couple, such as "z", "xy" or "xyz". A callable receives an array of tractions of shape (directions, ny,
    ///     nx), where the z direction is the pressure. It returns the displacements of body 1 relative to body 2 in the
    ///     same shape and order (lengths). A LinearOperator has the same number of unknowns;
    ///     :class:`~stickslip.dense.DenseOperator` accepts the compliance matrix of a finite-element code. On a grid that
    ///     is periodic along both axes, uniform tractions must cause no displacement. An operator is rejected as not
    ///     symmetric if the work of each of two test fields on the displacements of the other differs by more than 1e-9 of
    ///     the energies. The mean of a matrix and its transpose, ``(matrix + matrix.T) / 2``, is symmetric to round-off.
    /// lower_bounds : dict, optional
    ///     Lower bounds on the smallest eigenvalues of the callables, by name; 0 by default. Errors are certified with
    ///     these bounds. Without a bound, coupled contacts cannot be solved and the stiffness is not available. A
    ///     LinearOperator provides its own bound.
    ///
    /// Raises
    /// ------
    /// UnsupportedForCoatings, IncompleteKernel, RepeatedDirection, NotPositive, NotFinite, UnsupportedByModel, BelowMinimum, Memory
    ///
    /// Notes
    /// -----
    /// A callable runs under the GIL, for a large grid on a thread of the package. An exception in it ends the solve,
    /// which raises the exception again; solvers and histories remain unchanged.
    ///
    /// Examples
    /// --------
    /// A bed of springs, in which each cell deforms by 0.5 under unit pressure:
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
        near: Object<ElasticPair>,
        grid: Object<Grid>,
        operators: Bound<'_, PyDict>,
        lower_bounds: Option<Bound<'_, PyDict>>,
    ) -> PyResult<Self> {
        let lower_bounds = lower_bounds.unwrap_or_else(|| PyDict::new(py));
        for name in lower_bounds.keys() {
            let of = operators.get_item(&name)?;
            if of.is_none_or(|of| of.is_instance_of::<LinearOperator>()) {
                return Err(PyValueError::new_err(format!(
                    "lower_bounds contains {}, but operators contains no callable of this name",
                    name.repr()?
                )));
            }
        }
        let mut given = Operators::on(grid.0);
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

    /// The pair from which hardness and moduli are taken, marked as the pair of this kernel.
    #[getter]
    fn pair(&self) -> ElasticPair {
        self.0.pair().into()
    }

    fn __repr__(&self) -> String {
        format!("Kernel({})", self.pair().__repr__())
    }
}

/// Returns the directions of an operator from their letters, up to three.
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
            "the directions of an operator must be one to three of the letters x, y and z, got {}",
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

/// Reports an exception that cannot be raised to a caller.
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
