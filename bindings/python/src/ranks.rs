//! Communication between ranks through Python: a communicator of mpi4py, or any object with the required methods.

use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::types::{IntoPyDict, PyBytes};
use stickslip::ranks::{RankFailure, Ranks};

use crate::kernel::tell;
use crate::pool;

/// Communicator object. Its methods are called under the GIL, on any thread that performs the work, one call at a time.
#[derive(Debug)]
pub(crate) struct Communicator {
    object: Py<PyAny>,
    rank: usize,
    size: usize,
}

impl Communicator {
    pub(crate) fn of(object: &Bound<'_, PyAny>) -> PyResult<Self> {
        let size = object.call_method0("Get_size")?.extract()?;
        if size > 1 {
            pool::keep_apart();
        }
        Ok(Self {
            object: object.clone().unbind(),
            rank: object.call_method0("Get_rank")?.extract()?,
            size,
        })
    }
}

const WORD: usize = size_of::<u64>();

impl Ranks for Communicator {
    fn rank(&self) -> usize {
        self.rank
    }

    fn size(&self) -> usize {
        self.size
    }

    /// An exception counts as the loss of a rank and is reported like the exceptions of other callbacks.
    fn swap(&self, block: Vec<u64>, to: usize, from: usize) -> Result<Vec<u64>, RankFailure> {
        Python::attach(|py| {
            let object = self.object.bind(py);
            let swapped = || {
                let sent = PyBytes::new_with(py, block.len() * WORD, |bytes| {
                    for (bytes, word) in bytes.chunks_exact_mut(WORD).zip(&block) {
                        bytes.copy_from_slice(&word.to_ne_bytes());
                    }
                    Ok(())
                })?;
                let ends = [("dest", to), ("source", from)].into_py_dict(py)?;
                let received = object.call_method("sendrecv", (sent,), Some(&ends))?;
                let bytes = received.cast::<PyBytes>()?.as_bytes();
                if bytes.len() % WORD != 0 {
                    let length = bytes.len();
                    let told = format!(
                        "sendrecv returned {length} bytes, expected a multiple of {WORD} bytes"
                    );
                    return Err(PyValueError::new_err(told));
                }
                let words = bytes.chunks_exact(WORD);
                Ok(words
                    .filter_map(|word| Some(u64::from_ne_bytes(word.try_into().ok()?)))
                    .collect())
            };
            swapped().map_err(|error| {
                tell(py, error, object);
                RankFailure::Disconnected { rank: from }
            })
        })
    }
}
