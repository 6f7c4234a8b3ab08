//! Solvers for constrained minima of quadratic forms with any linear operator.

use std::ops::ControlFlow;
use std::sync::Arc;

use pyo3::exceptions::{PyTypeError, PyValueError};
use pyo3::prelude::*;
use serde::{Deserialize, Serialize};
use stickslip::cgm::{self, Bounds, Problem, Total};
use stickslip::{Iteration, Operator};

use crate::argument::Object;
use crate::array::{Array, view_slice};
use crate::choice::Choice;
use crate::conversion;
use crate::digits::{in_python, short};
use crate::error::{OrRaise, with_iterate};
use crate::field::{Field, same_grid};
use crate::operator::{LinearOperator, Shared, check_grid, numbers, product_of};
use crate::pickle::picklable;
use crate::progress::Progress;
use crate::real::{Count, Real};
use crate::report::Report;
use crate::settings::{Settings, chosen};
use crate::work::{solve, watch};

/// Returns one number per unknown, from an array of this length or from a single number.
fn for_each(given: &Bound<'_, PyAny>, cells: usize) -> PyResult<Vec<f64>> {
    match given.extract::<Real>() {
        Ok(Real(value)) => Ok(vec![value; cells]),
        Err(_) => Ok(numbers(given, cells)?.as_slice()?.to_vec()),
    }
}

/// Returns lower and upper bounds of the unknowns; zero and infinity by default.
pub(crate) fn bounds(
    lower: Option<Bound<'_, PyAny>>,
    upper: Option<Bound<'_, PyAny>>,
    cells: usize,
) -> PyResult<[Vec<f64>; 2]> {
    let bound = |given: Option<Bound<'_, PyAny>>, default: f64| match given {
        None => Ok(vec![default; cells]),
        Some(object) => for_each(&object, cells),
    };
    Ok([bound(lower, 0.0)?, bound(upper, f64::INFINITY)?])
}

/// Returns an error unless all operands belong to the grid of the operator. Without it, they must belong to the grid of the first
/// field.
pub(crate) fn check_grids<const N: usize>(
    operands: [Option<&Bound<'_, PyAny>>; N],
    grid: Option<stickslip::Grid>,
) -> PyResult<()> {
    let mut given = operands.into_iter().flatten();
    let of_field = |operand: &Bound<'_, PyAny>| Some(operand.cast::<Field>().ok()?.get().0.grid());
    let grid = grid.or_else(|| given.clone().find_map(of_field));
    given.try_for_each(|operand| check_grid(operand, grid))
}

/// Constrained minimum of a quadratic form.
#[pyclass(frozen, module = "stickslip.cgm")]
pub(crate) struct Minimum(Found);

/// Serialised content of a minimum.
#[derive(Serialize, Deserialize)]
pub(crate) struct Found {
    x: Vec<f64>,
    multiplier: f64,
    report: stickslip::Report,
}

#[pymethods]
impl Minimum {
    /// The unknowns, as a read-only view.
    #[getter]
    fn x<'py>(slf: &Bound<'py, Self>) -> Array<'py> {
        view_slice(slf, |minimum| &minimum.0.x)
    }

    /// Multiplier of the prescribed total; zero without a total.
    #[getter]
    fn multiplier(&self) -> f64 {
        self.0.multiplier
    }

    /// Report of the solve.
    #[getter]
    fn report(&self) -> Report {
        Report::of(&self.0.report)
    }

    fn __repr__(&self, py: Python<'_>) -> PyResult<String> {
        let report = in_python(py, &self.0.report.to_string())?;
        let multiplier = short(self.0.multiplier);
        Ok(format!("Minimum(multiplier={multiplier}, {report})"))
    }
}

picklable!(Minimum: Found);

/// Minimises ``x'Cx/2 + linear'x`` within bounds, with ``sum(x) = total`` if given.
///
/// Parameters
/// ----------
/// operator : LinearOperator or callable
///     The symmetric operator C; a callable receives an array of the unknowns and returns its product with C.
/// linear : array_like
///     The linear term, one number per unknown: a flat array, or a Field or an array of shape (ny, nx) on the grid of the operator.
/// lower, upper : float or array_like, optional
///     Bounds of the unknowns; zero and infinity by default.
/// total : float, optional
///     Sum of the unknowns; free by default.
/// spring : (far_end, compliance), optional
///     A spring that replaces the total: the multiplier is ``far_end - compliance * sum(x)``.
/// diagonal : float or array_like, optional
///     Non-negative numbers that are added to the diagonal of C; none by default.
/// preconditioner : LinearOperator, optional
///     An approximation of the inverse of C without ``diagonal``; none by default.
/// lower_bound : float, default 0
///     A lower bound on the smallest eigenvalue of the operator, if the operator is a callable. The error bound is
///     computed from it.
/// start : array_like, optional
///     Initial iterate; zero by default.
/// settings : Settings, optional
///     Method, tolerance and limits; ``Settings()`` by default.
/// tolerance, method, max_iterations, time_limit : optional
///     See :class:`Settings`; these arguments take precedence over ``settings``.
/// progress : callable or bool, optional
///     See :meth:`NormalProblem.solve`.
///
/// Returns
/// -------
/// Minimum
///
/// Raises
/// ------
/// Length, Sample, Bounds, Total, Method, Tolerance, IterationLimit, NotConverged
/// GridMismatch
///     If a field or the preconditioner is on a grid that differs from that of the operator, or if the grids of two fields differ.
/// Shape
///     If an array does not have the shape of this grid, for example because the array is transposed.
///
/// Examples
/// --------
/// >>> import numpy as np
/// >>> from stickslip import cgm
/// >>> bed = np.array([1.0, 2.0, 4.0])  # independent springs
/// >>> minimum = cgm.minimise(lambda x: bed * x, [-1.0, -1.0, 1.0], lower_bound=1.0)
/// >>> minimum.x.round(6)
/// array([1. , 0.5, 0. ])
#[pyfunction]
#[pyo3(signature = (operator, linear, *, lower=None, upper=None, total=None, spring=None, diagonal=None,
    preconditioner=None, lower_bound=Real(0.0), start=None, settings=None, tolerance=None, method=None,
    max_iterations=None, time_limit=None, progress=None))]
pub(crate) fn minimise<'py>(
    py: Python<'py>,
    operator: Bound<'py, PyAny>,
    linear: Bound<'py, PyAny>,
    lower: Option<Bound<'py, PyAny>>,
    upper: Option<Bound<'py, PyAny>>,
    total: Option<Real>,
    spring: Option<conversion::FarEnd>,
    diagonal: Option<Bound<'py, PyAny>>,
    preconditioner: Option<Object<LinearOperator>>,
    lower_bound: Real,
    start: Option<Bound<'py, PyAny>>,
    settings: Option<Settings>,
    tolerance: Option<Real>,
    method: Option<Choice<cgm::Method>>,
    max_iterations: Option<Count>,
    time_limit: Option<Real>,
    progress: Option<Bound<'py, PyAny>>,
) -> PyResult<Minimum> {
    let settings = chosen(settings, tolerance, method, max_iterations, time_limit)?;
    let progress = Progress::of(progress.as_ref())?;
    let total = match (total, spring) {
        (None, None) => Total::Free,
        (Some(Real(total)), None) => Total::Sum(total),
        (None, Some(conversion::FarEnd((far_end, compliance)))) => Total::Spring {
            far_end,
            compliance,
        },
        _ => {
            return Err(PyTypeError::new_err(
                "give either a total or a spring, not both",
            ));
        }
    };
    let known = operator.cast::<LinearOperator>().ok();
    let is_function = known.is_none();
    let grid = known.and_then(|operator| operator.get().grid);
    let arrays = [
        Some(&linear),
        lower.as_ref(),
        upper.as_ref(),
        diagonal.as_ref(),
        start.as_ref(),
    ];
    check_grids(arrays, grid)?;
    let of_inverse = preconditioner.as_ref().and_then(|given| given.grid);
    if let Some((grid, found)) = grid.zip(of_inverse) {
        same_grid(grid, found, "the preconditioner").or_raise(py)?;
    }
    let unknowns: usize = py
        .import("numpy")?
        .call_method1("size", (&linear,))?
        .extract()?;
    let product = product_of(&operator, &[unknowns], lower_bound.0)?;
    let cells = product.cells();
    if cells == 0 {
        return Err(PyValueError::new_err(
            "the problem must have at least one unknown, got 0",
        ));
    }
    let linear = numbers(&linear, cells)?;
    let linear = linear.as_slice()?;
    let bounds = bounds(lower, upper, cells)?;
    let diagonal = diagonal.map(|given| for_each(&given, cells));
    let diagonal = diagonal.transpose()?.unwrap_or_default();
    let mut x = match start {
        None => vec![0.0; cells],
        Some(start) => numbers(&start, cells)?.as_slice()?.to_vec(),
    };
    // A Python function must be called on the thread that called this function.
    let size = if is_function { 0 } else { cells };
    let preconditioner = preconditioner.map(|given| Shared(Arc::clone(&given.product)));
    let outcome = solve(py, size, progress, |observer| {
        let [lower, upper] = bounds.each_ref().map(|bound| &bound[..]);
        let constraint = Bounds { lower, upper };
        let problem = Problem::new(Shared(product), [linear], constraint)
            .diagonal(&diagonal)
            .totals([total]);
        let stop = watch(observer);
        match preconditioner {
            None => minimum(&problem, &settings, &mut x, stop),
            Some(given) => minimum(&problem.preconditioner(given), &settings, &mut x, stop),
        }
    })?;
    let (multiplier, report, error) = match outcome {
        Ok((multiplier, report)) => (multiplier, report, None),
        Err(stickslip::Error::NotConverged(report)) => {
            let kept = (*report).clone();
            (f64::NAN, kept, Some(stickslip::Error::NotConverged(report)))
        }
        Err(error) => return Err(crate::error::raised(py, error)),
    };
    let found = Minimum(Found {
        x,
        multiplier,
        report,
    });
    match error {
        None => Ok(found),
        Some(error) => {
            let object = || Bound::new(py, found).map(Bound::into_any);
            Err(with_iterate(py, error, object))
        }
    }
}

fn minimum<P: Operator>(
    problem: &Problem<'_, Shared, Bounds<'_>, P>,
    settings: &cgm::Settings,
    x: &mut [f64],
    mut stop: impl FnMut(&Iteration) -> ControlFlow<()> + Send,
) -> stickslip::Result<(f64, stickslip::Report)> {
    let mut workspace = problem.workspace()?;
    cgm::minimise_with(problem, settings, [x], &mut workspace, &mut stop)?;
    Ok((workspace.multiplier()[0], workspace.report().clone()))
}
