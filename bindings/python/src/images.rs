//! Images of fields for ParaView.

use std::ffi::OsStr;
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex};

use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;
use pyo3::types::{PyBytes, PyDict, PyTuple};
use stickslip::io::{pvd, vti};

use crate::argument::Object;
use crate::conversion::{entries, kind_of};
use crate::digits::counted;
use crate::error::OrRaise;
use crate::field::same_grid;
use crate::grid::Grid;
use crate::real::{Real, is_plane, out_of_range};
use crate::samples::Samples;
use crate::solution_pool::lock;
use crate::unit::one_of;

/// Scalar and vector fields by name.
struct Arrays(Vec<(String, Vec<Arc<stickslip::Field>>)>);

impl Arrays {
    /// Reads a dictionary of fields, or the fields of a solution or a surface.
    fn of(py: Python<'_>, given: &Bound<'_, PyAny>, grid: Option<&Grid>) -> PyResult<Self> {
        if let Ok(fields) = given.cast::<PyDict>() {
            return Self::by_name(py, fields, grid);
        }
        let module = py.import("stickslip.io._datasets")?;
        let found = module.call_method1("fields_of", (given,))?;
        let (fields, own): (Bound<'_, PyDict>, Bound<'_, Grid>) = found.extract()?;
        if let Some(grid) = grid {
            same_grid(grid.0, own.get().0, "solution").or_raise(py)?;
        }
        Self::by_name(py, &fields, Some(own.get()))
    }

    fn by_name(py: Python<'_>, fields: &Bound<'_, PyDict>, grid: Option<&Grid>) -> PyResult<Self> {
        let mut arrays = Vec::with_capacity(fields.len());
        let mut unit = None;
        let mut one = |object: &Bound<'_, PyAny>| {
            let samples: Samples<'_> = object.extract()?;
            unit = one_of([unit.take(), samples.unit()?])?;
            match grid {
                Some(grid) => samples.only_on(py, "field", grid.0),
                None => samples.alone_or(
                    "field",
                    ": give grid= (such as history.grid or solution.grid), or create a Field by Field(grid, array)",
                ),
            }
        };
        for (name, value) in fields {
            // A list can also represent one array with two rows.
            let vector = entries(&value).filter(|parts| {
                value.is_instance_of::<PyTuple>() || parts.iter().all(|part| is_plane(&part))
            });
            let parts = match vector {
                Some(vector) if vector.len() == 2 => vector
                    .iter()
                    .map(|part| one(&part))
                    .collect::<PyResult<_>>()?,
                Some(vector) => {
                    return Err(PyTypeError::new_err(format!(
                        "a vector must have two components, got {}",
                        vector.len()
                    )));
                }
                None => vec![one(&value)?],
            };
            let name = name.extract().map_err(|_| {
                PyTypeError::new_err(format!(
                    "the names of the fields must be text, got {}",
                    kind_of(&name)
                ))
            })?;
            arrays.push((name, parts));
        }
        Ok(Self(arrays))
    }

    fn named<'a>(&'a self) -> Vec<(&'a str, vti::Array<'a>)> {
        let array = |parts: &'a [Arc<stickslip::Field>]| match parts {
            [x, y] => vti::Array::Vector([x, y]),
            parts => vti::Array::Scalar(&parts[0]),
        };
        self.0
            .iter()
            .map(|(name, parts)| (name.as_str(), array(parts)))
            .collect()
    }
}

/// Returns an error unless a path ends in the extension by which ParaView chooses its reader.
fn with_ending(py: Python<'_>, path: &Path, ending: &str) -> PyResult<()> {
    let given = path.extension();
    if given.is_some_and(|given| given.eq_ignore_ascii_case(ending)) {
        return Ok(());
    }
    // A number in the name, such as 0.5, may contain a point too.
    let is_extension = |given: &OsStr| {
        let text = given.to_string_lossy();
        text.starts_with(|first: char| first.is_ascii_alphabetic())
    };
    let own = format!(".{ending}");
    let is_ending = |name: Option<&OsStr>| {
        name.is_some_and(|name| name.to_string_lossy().eq_ignore_ascii_case(&own))
    };
    let stem = path.with_extension("");
    let proposed = if is_ending(path.file_name()) {
        // A name that starts with a point has no extension.
        path.with_file_name(format!("fields{own}"))
    } else if stem
        .extension()
        .is_some_and(|inner| inner.eq_ignore_ascii_case(ending))
    {
        // An image is not compressed.
        stem
    } else if given.is_some_and(is_extension) {
        path.with_extension(ending)
    } else {
        let mut name = path.as_os_str().to_owned();
        name.push(&own);
        name.into()
    };
    let message = format!(
        "must end in .{ending}, by which ParaView recognises the format, got \"{}\": give \"{}\"",
        path.display(),
        proposed.display()
    );
    Err(out_of_range(py, "path", &message))
}

/// Writes fields to a VTI file (image data) for ParaView.
///
/// Parameters
/// ----------
/// path : path_like
///     The file, whose name ends in ``.vti``; an existing file is replaced.
/// fields : dict, solution, State, History, Field or surface
///     Fields by name; a pair of fields is a vector. For other objects, all their fields are written: ``gap`` is the gap under
///     load, and ``unloaded_gap`` the gap before loading. ``zones`` contains the numbers 0 separated, 1 stick and 2 slip,
///     because a VTI file stores no names.
/// grid : Grid, optional
///     Grid of the fields of a dictionary; required if they are arrays.
///
/// Raises
/// ------
/// ArgumentRange
///     If the path does not end in ``.vti``. :func:`to_bytes` returns the content for other paths.
/// ValueError
///     If the fields have different units.
#[pyfunction]
#[pyo3(signature = (path, fields, *, grid=None))]
pub(crate) fn vti_write(
    py: Python<'_>,
    path: PathBuf,
    fields: &Bound<'_, PyAny>,
    grid: Option<Object<Grid>>,
) -> PyResult<()> {
    with_ending(py, &path, "vti")?;
    let arrays = Arrays::of(py, fields, grid.as_deref())?;
    py.detach(|| vti::write(&path, &arrays.named()))
        .or_raise(py)
}

/// Returns fields as the bytes of a VTI file for ParaView; see :func:`write`.
#[pyfunction]
#[pyo3(signature = (fields, *, grid=None))]
pub(crate) fn vti_to_bytes<'py>(
    py: Python<'py>,
    fields: &Bound<'py, PyAny>,
    grid: Option<Object<Grid>>,
) -> PyResult<Bound<'py, PyBytes>> {
    let arrays = Arrays::of(py, fields, grid.as_deref())?;
    let bytes = py.detach(|| vti::to_bytes(&arrays.named())).or_raise(py)?;
    Ok(PyBytes::new(py, &bytes))
}

/// A time series of images for ParaView, listed in a PVD file. An existing file is replaced.
///
/// Parameters
/// ----------
/// path : path_like
///     The PVD file, whose name ends in ``.pvd``. The images are written to the same folder. Both are complete after each call of
///     :meth:`write`, so that the writer needs no ``with`` and no ``close``.
///
/// Raises
/// ------
/// ArgumentRange
///     If the path does not end in ``.pvd``.
#[pyclass(frozen, module = "stickslip.io.pvd")]
pub(crate) struct PvdWriter(Mutex<pvd::PvdWriter>);

#[pymethods]
impl PvdWriter {
    #[new]
    fn new(py: Python<'_>, path: PathBuf) -> PyResult<Self> {
        with_ending(py, &path, "pvd")?;
        let series = pvd::PvdWriter::new(&path).or_raise(py)?;
        Ok(Self(Mutex::new(series)))
    }

    /// Writes fields and vectors at a given time as :func:`stickslip.io.vti.write` does, and adds them to the list.
    #[pyo3(signature = (time, fields, *, grid=None))]
    fn write(
        &self,
        py: Python<'_>,
        time: Real,
        fields: &Bound<'_, PyAny>,
        grid: Option<Object<Grid>>,
    ) -> PyResult<()> {
        let arrays = Arrays::of(py, fields, grid.as_deref())?;
        let mut series = lock(&self.0, "series")?;
        let series = &mut *series;
        py.detach(|| series.write(time.0, &arrays.named()))
            .or_raise(py)
    }

    fn __len__(&self) -> PyResult<usize> {
        Ok(lock(&self.0, "series")?.len())
    }

    fn __repr__(&self) -> PyResult<String> {
        let images = counted(lock(&self.0, "series")?.len(), "image");
        Ok(format!("Series({images})"))
    }
}
