//! Bodies by their response to waves, or by influence coefficients.

use numpy::{AllowTypeChange, PyArrayLike2};
use pyo3::exceptions::{PyKeyboardInterrupt, PyTypeError, PyValueError};
use pyo3::prelude::*;
use pyo3::types::PyDict;
use stickslip::influence::Component;
use stickslip::kernel::CoefficientTable;
use stickslip::layers::Response;

use crate::choice::Choice;
use crate::error::OrRaise;
use crate::material::ElasticPair;
use crate::real::{Real, is_real};

/// Two bodies by a response of your own, in place of the pair of a :class:`HalfSpace`: made by :meth:`isotropic` or
/// :meth:`tabulated`. It is not pickled, nor are the bodies made of it.
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
    /// NotPositive, NotFinite, Coated
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
    /// NotPositive, Length, Sample, Coated
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

    /// The pair that lends hardness and moduli, marked as that of this kernel.
    #[getter]
    fn pair(&self) -> ElasticPair {
        self.0.pair().into()
    }

    fn __repr__(&self) -> String {
        format!("Kernel({})", self.pair().__repr__())
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
