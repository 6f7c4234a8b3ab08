//! Python functions as operators, and their exceptions: an exception ends the work that calls the function and is raised
//! again there.

use std::cell::RefCell;

use numpy::{PyArray1, PyArrayMethods};
use pyo3::prelude::*;
use stickslip::Operator;
use stickslip::Scratch;

use crate::kernel::tell;
use crate::operator::numbers;

/// Exceptions raised by Python functions in the current work of a thread.
#[derive(Default)]
enum Raised {
    /// No work is running that could raise the exception again.
    #[default]
    Untold,
    Nothing,
    First(PyErr),
}

thread_local! {
    static RAISED: RefCell<Raised> = const { RefCell::new(Raised::Untold) };
}

/// Guard that restores the previous state on drop, even if the work panics.
struct Before(Raised);

impl Drop for Before {
    fn drop(&mut self) {
        RAISED.set(std::mem::take(&mut self.0));
    }
}

/// Runs work whose products are computed on this thread. The first exception of a Python function in one of the products
/// takes precedence over the result. Calls can be nested when threads of a pool take up other work; each level then has
/// its own exceptions.
pub(crate) fn raising<T>(work: impl FnOnce() -> T) -> PyResult<T> {
    let before = Before(RAISED.replace(Raised::Nothing));
    let outcome = work();
    let raised = RAISED.take();
    drop(before);
    match raised {
        Raised::First(exception) => Err(exception),
        Raised::Nothing | Raised::Untold => Ok(outcome),
    }
}

/// Returns whether the current work of this thread must end because of an exception.
pub(crate) fn has_raised() -> bool {
    RAISED.with_borrow(|raised| matches!(raised, Raised::First(_)))
}

/// Stores an exception of a Python function, which ends the current work of this thread and is raised at its end.
pub(crate) fn raise(py: Python<'_>, exception: PyErr, function: &Bound<'_, PyAny>) {
    RAISED.with_borrow_mut(|raised| match raised {
        Raised::Untold => tell(py, exception, function),
        Raised::Nothing => *raised = Raised::First(exception),
        Raised::First(_) => {}
    });
}

/// A Python function as an operator of one component: it receives an array of the unknowns and returns an array of the
/// same size.
pub(crate) struct Function {
    call: Py<PyAny>,
    shape: Vec<usize>,
    lower_bound: f64,
}

impl Function {
    pub(crate) fn new(call: &Bound<'_, PyAny>, shape: &[usize], lower_bound: f64) -> Self {
        Self {
            call: call.clone().unbind(),
            shape: shape.to_vec(),
            lower_bound,
        }
    }

    fn product(&self, py: Python<'_>, x: &[f64], out: &mut [f64]) -> PyResult<()> {
        let given = PyArray1::from_slice(py, x).reshape(&self.shape[..])?;
        let product = numbers(&self.call.bind(py).call1((given,))?, x.len())?;
        out.copy_from_slice(product.as_slice()?);
        Ok(())
    }
}

impl Operator for Function {
    fn cells(&self) -> usize {
        self.shape.iter().product()
    }

    /// If the function raises an exception, the product is filled with NaN, with which no iteration converges.
    fn apply(&self, [x]: [&[f64]; 1], [out]: [&mut [f64]; 1], _: &mut Scratch) {
        Python::attach(|py| {
            if let Err(exception) = self.product(py, x, out) {
                out.fill(f64::NAN);
                raise(py, exception, self.call.bind(py));
            }
        });
    }

    fn lower_bound(&self) -> f64 {
        self.lower_bound
    }
}
