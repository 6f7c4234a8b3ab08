//! Functions of Python as operators, and what they raise: it ends the work that calls them, and is raised again there.

use std::cell::RefCell;

use numpy::{PyArray1, PyArrayMethods};
use pyo3::prelude::*;
use stickslip::Operator;
use stickslip::Scratch;

use crate::kernel::tell;
use crate::operator::numbers;

/// What functions have raised in the work that a thread is at.
#[derive(Default)]
enum Raised {
    /// There is no work that raises it again.
    #[default]
    Untold,
    Nothing,
    First(PyErr),
}

thread_local! {
    static RAISED: RefCell<Raised> = const { RefCell::new(Raised::Untold) };
}

/// Puts back what stood there before, also where the work panics.
struct Before(Raised);

impl Drop for Before {
    fn drop(&mut self) {
        RAISED.set(std::mem::take(&mut self.0));
    }
}

/// Does work whose products run on this thread; an exception of a function of Python in one of them comes first. Work may
/// begin within other work, as the threads of a pool take it: each has its own exceptions.
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

/// Whether the work that this thread is at is to end.
pub(crate) fn has_raised() -> bool {
    RAISED.with_borrow(|raised| matches!(raised, Raised::First(_)))
}

/// A function of Python as an operator of one component: it is given an array of the unknowns, and returns as many numbers.
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

    /// Where it raises an exception the product is no number, with which nothing converges.
    fn apply(&self, [x]: [&[f64]; 1], [out]: [&mut [f64]; 1], _: &mut Scratch) {
        Python::attach(|py| {
            let Err(exception) = self.product(py, x, out) else {
                return;
            };
            out.fill(f64::NAN);
            RAISED.with_borrow_mut(|raised| match raised {
                Raised::Untold => tell(py, exception, self.call.bind(py)),
                Raised::Nothing => *raised = Raised::First(exception),
                Raised::First(_) => {}
            });
        });
    }

    fn lower_bound(&self) -> f64 {
        self.lower_bound
    }
}
