//! Reading and writing of surfaces in files.

use std::path::PathBuf;
use std::sync::Arc;

use pyo3::exceptions::{PyTypeError, PyValueError};
use pyo3::prelude::*;
use pyo3::types::{PyBytes, PyTuple};
use stickslip::io::{self, Sides};

use crate::content::Content;
use crate::conversion;
use crate::error::OrRaise;
use crate::field::Field;
use crate::grid::Grid;
use crate::load;
use crate::real::{Count, Real};
use crate::samples::Samples;
use crate::unit::{Unit, factor, known, one_of};
use crate::xyz_header::Stated;

/// Returns the sides of a cell or of the grid, for files that do not state them.
fn sides(
    function: &str,
    positional: &Bound<'_, PyTuple>,
    cell: Option<conversion::CellSides>,
    size: Option<conversion::GridSides>,
) -> PyResult<Sides> {
    let words = format!("io.{function} takes the sides");
    load::none_by_position(&words, positional, "cell=(dx, dy) or size=(x, y)")?;
    match (cell, size) {
        (Some(cell), None) => Ok(Sides::OfCell(cell.0)),
        (None, Some(size)) => Ok(Sides::OfGrid(size.0)),
        _ => Err(PyTypeError::new_err(
            "give either the sides of a cell, cell=(dx, dy), or the sides of the grid, size=(x, y)",
        )),
    }
}

/// Units of a file that does not state them.
struct Units {
    lengths: Option<Unit>,
    factor: Option<f64>,
}

impl Units {
    /// Reads the unit of all lengths and the unit of the heights, if it differs.
    fn of(unit: Option<&str>, height_unit: Option<&str>) -> PyResult<Self> {
        let lengths = unit.map(known).transpose()?;
        let factor = match (&lengths, height_unit) {
            (_, None) => None,
            (Some(unit), Some(height)) => Some(factor(height, unit)?),
            (None, Some(_)) => {
                return Err(PyTypeError::new_err(
                    "height_unit= converts the heights to the unit of the lengths: give unit= too",
                ));
            }
        };
        Ok(Self { lengths, factor })
    }

    /// Returns the surface with its unit, and with its heights in this unit.
    fn of_surface(self, field: stickslip::Field) -> Field {
        let field = match self.factor {
            None => field,
            Some(factor) => field.scaled(factor),
        };
        Field::made(field, self.lengths)
    }
}

/// Reads a surface from a file whose format is given by its extension: ASC, SDF, SUR, X3P or XYZ. Lengths are in metres,
/// except for XYZ, where they are in the unit of the file; :func:`stickslip.io.xyz.read` accepts this unit.
#[pyfunction]
pub(crate) fn read(py: Python<'_>, path: PathBuf) -> PyResult<Field> {
    let field = py.detach(|| io::read(&path)).or_raise(py)?;
    let is_xyz = path
        .extension()
        .is_some_and(|ending| ending.eq_ignore_ascii_case("xyz"));
    Ok(Field::made(
        field,
        if is_xyz { None } else { Some(METRE.into()) },
    ))
}

/// Unit of the lengths in files that state a unit.
const METRE: &str = "m";

/// Returns a surface for a file in metres, or an error if the surface states a different unit, or if its unit is not known.
fn in_metres(field: &Samples<'_>, unit: Option<&str>) -> PyResult<Arc<stickslip::Field>> {
    let given = unit.map(known).transpose()?;
    let unit = one_of([field.unit()?, given])?;
    match unit.as_deref() {
        Some(METRE) => field.alone("field"),
        Some(unit) => Err(PyValueError::new_err(format!(
            "the unit of the file is the metre, but the unit of the surface is {unit}: convert it by surface.to_unit('m')"
        ))),
        None => {
            field.alone("field")?;
            Err(PyValueError::new_err(
                "the unit of the file is the metre, but the surface has no unit: give unit='m' if its lengths are metres, \
                 or convert it by Field(grid, samples, unit=...).to_unit('m')",
            ))
        }
    }
}

/// Declares the readers of formats that contain their grid.
macro_rules! formats {
    ($($format:ident: $read:ident, $parse:ident, $doc:literal, $unit:literal, $short:expr;)+) => {$(
        #[doc = concat!("Reads a surface from ", $doc, " file (lengths in ", $unit, ").")]
        #[pyfunction]
        pub(crate) fn $read(py: Python<'_>, path: PathBuf) -> PyResult<Field> {
            let field = py.detach(|| io::$format::read(&path)).or_raise(py)?;
            Ok(Field::made(field, $short))
        }

        #[doc = concat!("Reads a surface from the bytes of ", $doc, " file (lengths in ", $unit, ").")]
        #[pyfunction]
        pub(crate) fn $parse(py: Python<'_>, bytes: Content<'_>) -> PyResult<Field> {
            let bytes: &[u8] = &bytes;
            let field = py.detach(|| io::$format::parse(bytes)).or_raise(py)?;
            Ok(Field::made(field, $short))
        }
    )+};
}

formats! {
    asc: asc_read, asc_parse, "an ASC", "metres", Some(METRE.into());
    sdf: sdf_read, sdf_parse, "an SDF", "metres", Some(METRE.into());
    sur: sur_read, sur_parse, "a SUR", "metres", Some(METRE.into());
    x3p: x3p_read, x3p_parse, "an X3P", "metres", Some(METRE.into());
}

fn points(missing: Option<Real>, skip_rows: Count) -> io::xyz::Options {
    let options = io::xyz::Options::default().skip_rows(skip_rows.0);
    match missing {
        None => options,
        Some(Real(value)) => options.missing(value),
    }
}

/// Reads a surface from an XYZ file (lengths in the unit of the file).
///
/// Parameters
/// ----------
/// path : path_like
///     The file.
/// missing : float, optional
///     The height that marks a missing point (default: the value that a comment states, or none). Other heights that may be
///     such marks, as -9999, are rejected by the rule of :func:`stickslip.io.csv.read`. NaN states that all numbers are heights.
/// skip_rows : int, default 0
///     Number of lines before the points.
/// unit : str, optional
///     The unit of the lengths of the file, which the surface keeps, such as ``"um"``.
/// height_unit : str, optional
///     The unit of the heights of the file, if it differs; the heights are converted to ``unit``.
///
/// Raises
/// ------
/// File, Format
/// ValueError
///     If a name is not a unit of length, or if the header of the file states another unit, as ``# X[um] Y[um] Z[nm]``.
/// TypeError
///     If ``height_unit`` is given without ``unit``.
#[pyfunction]
#[pyo3(signature = (path, *, missing=None, skip_rows=Count(0), unit=None, height_unit=None),
    text_signature = "(path, *, missing=None, skip_rows=0, unit=None, height_unit=None)")]
pub(crate) fn xyz_read(
    py: Python<'_>,
    path: PathBuf,
    missing: Option<Real>,
    skip_rows: Count,
    unit: Option<&str>,
    height_unit: Option<&str>,
) -> PyResult<Field> {
    let units = Units::of(unit, height_unit)?;
    if let Some(unit) = unit {
        Stated { unit, height_unit }.check_file(&path)?;
    }
    let options = points(missing, skip_rows);
    py.detach(|| options.read(&path))
        .or_raise(py)
        .map(|field| units.of_surface(field))
}

/// Reads a surface from the bytes of an XYZ file (lengths in the unit of the file); see :func:`read`.
#[pyfunction]
#[pyo3(signature = (bytes, *, missing=None, skip_rows=Count(0), unit=None, height_unit=None),
    text_signature = "(bytes, *, missing=None, skip_rows=0, unit=None, height_unit=None)")]
pub(crate) fn xyz_parse(
    py: Python<'_>,
    bytes: Content<'_>,
    missing: Option<Real>,
    skip_rows: Count,
    unit: Option<&str>,
    height_unit: Option<&str>,
) -> PyResult<Field> {
    let units = Units::of(unit, height_unit)?;
    let bytes: &[u8] = &bytes;
    if let Some(unit) = unit {
        Stated { unit, height_unit }.check(bytes, "")?;
    }
    let options = points(missing, skip_rows);
    py.detach(|| options.parse(bytes))
        .or_raise(py)
        .map(|field| units.of_surface(field))
}

/// Writes a surface to an SDF file (lengths in metres).
///
/// Parameters
/// ----------
/// path : path_like
///     The file.
/// field : Field or topography
///     The surface, in metres.
/// unit : str, optional
///     The unit of a surface that states none: ``"m"``.
///
/// Raises
/// ------
/// File
/// ValueError
///     If the unit of the surface is not known or is not the metre.
#[pyfunction]
#[pyo3(signature = (path, field, *, unit=None))]
pub(crate) fn sdf_write(
    py: Python<'_>,
    path: PathBuf,
    field: Samples<'_>,
    unit: Option<&str>,
) -> PyResult<()> {
    let field = in_metres(&field, unit)?;
    py.detach(|| io::sdf::write(&path, &field)).or_raise(py)
}

/// Returns a surface as the bytes of an SDF file (lengths in metres); see :func:`write`.
#[pyfunction]
#[pyo3(signature = (field, *, unit=None))]
pub(crate) fn sdf_to_bytes<'py>(
    py: Python<'py>,
    field: Samples<'py>,
    unit: Option<&str>,
) -> PyResult<Bound<'py, PyBytes>> {
    let field = in_metres(&field, unit)?;
    let bytes = py.detach(|| io::sdf::to_bytes(&field)).or_raise(py)?;
    Ok(PyBytes::new(py, &bytes))
}

fn options(
    missing: Option<Real>,
    skip_rows: Count,
    skip_columns: Count,
    without_labels: bool,
) -> io::csv::Options {
    let mut options = io::csv::Options::default()
        .skip_rows(skip_rows.0)
        .skip_columns(skip_columns.0);
    if without_labels {
        options = options.without_labels();
    }
    match missing {
        None => options,
        Some(Real(value)) => options.missing(value),
    }
}

/// Reads a field from a text file that contains a matrix.
///
/// A cell is missing (NaN) if it is empty, consists of stars, or is one of these words in upper or lower case: ``nan``,
/// ``BAD``, ``No Data``, ``no_data``, ``no-data``, ``N/A``, ``#N/A``, ``NA``, ``null``, ``none``, ``void``, ``invalid``,
/// ``missing`` and ``--``. Any other text is rejected with its line and column. Numbers may be in quotes.
/// Numbers that may be labels are also rejected: a first row or column 0, 1, 2, ..., also as 0.0, 1.0, 2.0, ... next to
/// other decimals, and evenly spaced coordinates in the first row and column. Nine or more coordinates in the first row or
/// column alone are also rejected, unless another row or column is evenly spaced, as on an inclined surface. Fewer
/// coordinates are read as heights: skip them by ``skip_rows=1`` or ``skip_columns=1``.
///
/// Parameters
/// ----------
/// path : path_like
///     The file.
/// cell, size : pair of float
///     Side lengths of a cell or of the grid; exactly one of the two is required.
/// missing : float, optional
///     The value that marks a missing point (default: the value that a comment states, or none). Other values that may be
///     such marks, as -9999 or any magnitude from 1e30, are rejected; NaN states that all numbers are heights. Read a file with
///     several marks in this way, and replace the marks in its array. The comment consists of
///     a name, then ``=``, ``:`` or a space, and a number, as ``# NODATA_value -9999``. The name is ``missing``, ``missing
///     value``, ``no data``, ``no data value``, ``bad value``, ``invalid value``, ``void`` or ``void value``, in upper or
///     lower case, with any separators between words or none.
/// skip_rows : int, default 0
///     Number of rows before the matrix.
/// skip_columns : int, default 0
///     Number of columns to skip at the start of each row, such as names or row numbers.
/// without_labels : bool, default False
///     Whether a first row or column with numbers that may be labels contains heights; if not, it is rejected.
/// unit : str, optional
///     The unit of the lengths of the file, which the surface keeps, such as ``"um"``.
/// height_unit : str, optional
///     The unit of the heights of the file, if it differs; the heights are converted to ``unit``.
///
/// Raises
/// ------
/// File, Format, NotPositive
/// ValueError
///     If a name is not a unit of length, or if the header of the file states another unit, as ``# Z[nm]``.
/// TypeError
///     If ``height_unit`` is given without ``unit``.
#[pyfunction]
#[pyo3(signature = (path, *positional, cell=None, size=None, missing=None, skip_rows=Count(0), skip_columns=Count(0),
    without_labels=false, unit=None, height_unit=None),
    text_signature = "(path, *, cell=None, size=None, missing=None, skip_rows=0, skip_columns=0, without_labels=False, \
        unit=None, height_unit=None)")]
pub(crate) fn csv_read(
    py: Python<'_>,
    path: PathBuf,
    positional: &Bound<'_, PyTuple>,
    cell: Option<conversion::CellSides>,
    size: Option<conversion::GridSides>,
    missing: Option<Real>,
    skip_rows: Count,
    skip_columns: Count,
    #[pyo3(from_py_with = crate::real::flag)] without_labels: bool,
    unit: Option<&str>,
    height_unit: Option<&str>,
) -> PyResult<Field> {
    let units = Units::of(unit, height_unit)?;
    let sides = sides("csv.read", positional, cell, size)?;
    if let Some(unit) = unit {
        Stated { unit, height_unit }.check_file(&path)?;
    }
    let options = options(missing, skip_rows, skip_columns, without_labels);
    py.detach(|| options.read(&path, sides))
        .or_raise(py)
        .map(|field| units.of_surface(field))
}

/// Reads a field from the bytes of a text file that contains a matrix; see :func:`read`. The bytes of a compressed file are
/// ``gzip.open(path).read()``.
#[pyfunction]
#[pyo3(signature = (bytes, *positional, cell=None, size=None, missing=None, skip_rows=Count(0), skip_columns=Count(0),
    without_labels=false, unit=None, height_unit=None),
    text_signature = "(bytes, *, cell=None, size=None, missing=None, skip_rows=0, skip_columns=0, without_labels=False, \
        unit=None, height_unit=None)")]
pub(crate) fn csv_parse(
    py: Python<'_>,
    bytes: Content<'_>,
    positional: &Bound<'_, PyTuple>,
    cell: Option<conversion::CellSides>,
    size: Option<conversion::GridSides>,
    missing: Option<Real>,
    skip_rows: Count,
    skip_columns: Count,
    #[pyo3(from_py_with = crate::real::flag)] without_labels: bool,
    unit: Option<&str>,
    height_unit: Option<&str>,
) -> PyResult<Field> {
    let units = Units::of(unit, height_unit)?;
    let sides = sides("csv.parse", positional, cell, size)?;
    let bytes: &[u8] = &bytes;
    if let Some(unit) = unit {
        Stated { unit, height_unit }.check(bytes, "")?;
    }
    let options = options(missing, skip_rows, skip_columns, without_labels);
    py.detach(|| options.parse(bytes, sides))
        .or_raise(py)
        .map(|field| units.of_surface(field))
}

/// Writes a field to a text file as a matrix. The file contains neither the unit nor the cell sides: give them again on reading
/// by ``unit=`` and ``cell=``.
#[pyfunction]
pub(crate) fn csv_write(py: Python<'_>, path: PathBuf, field: Samples<'_>) -> PyResult<()> {
    let field = field.alone("field")?;
    py.detach(|| io::csv::write(&path, &field)).or_raise(py)
}

/// Returns a field as the text of a matrix, without its unit and cell sides.
#[pyfunction]
pub(crate) fn csv_to_bytes<'py>(
    py: Python<'py>,
    field: Samples<'py>,
) -> PyResult<Bound<'py, PyBytes>> {
    let field = field.alone("field")?;
    Ok(PyBytes::new(py, &io::csv::to_bytes(&field)))
}

fn array_options(missing: Option<Real>) -> io::npy::Options {
    let options = io::npy::Options::default();
    missing.map_or(options, |Real(value)| options.missing(value))
}

/// Reads a field from an NPY file.
///
/// Parameters
/// ----------
/// path : path_like
///     The file.
/// cell, size : pair of float
///     Side lengths of a cell or of the grid; exactly one of the two is required.
/// missing : float, optional
///     The value that marks a missing point (default: none). Other values that may be such marks, as -9999, are rejected by the
///     rule of :func:`stickslip.io.csv.read`. NaN states that all numbers are heights.
/// unit : str, optional
///     The unit of the lengths of the file, which the surface keeps, such as ``"um"``.
/// height_unit : str, optional
///     The unit of the heights of the file, if it differs; the heights are converted to ``unit``.
///
/// Raises
/// ------
/// File, Format, NotPositive
/// ValueError
///     If a name is not a unit of length.
/// TypeError
///     If ``height_unit`` is given without ``unit``.
#[pyfunction]
#[pyo3(signature = (path, *positional, cell=None, size=None, missing=None, unit=None, height_unit=None),
    text_signature = "(path, *, cell=None, size=None, missing=None, unit=None, height_unit=None)")]
pub(crate) fn npy_read(
    py: Python<'_>,
    path: PathBuf,
    positional: &Bound<'_, PyTuple>,
    cell: Option<conversion::CellSides>,
    size: Option<conversion::GridSides>,
    missing: Option<Real>,
    unit: Option<&str>,
    height_unit: Option<&str>,
) -> PyResult<Field> {
    let units = Units::of(unit, height_unit)?;
    let sides = sides("npy.read", positional, cell, size)?;
    let options = array_options(missing);
    py.detach(|| options.read(&path, sides))
        .or_raise(py)
        .map(|field| units.of_surface(field))
}

/// Reads a field from the bytes of an NPY file; see :func:`read`.
#[pyfunction]
#[pyo3(signature = (bytes, *positional, cell=None, size=None, missing=None, unit=None, height_unit=None),
    text_signature = "(bytes, *, cell=None, size=None, missing=None, unit=None, height_unit=None)")]
pub(crate) fn npy_parse(
    py: Python<'_>,
    bytes: Content<'_>,
    positional: &Bound<'_, PyTuple>,
    cell: Option<conversion::CellSides>,
    size: Option<conversion::GridSides>,
    missing: Option<Real>,
    unit: Option<&str>,
    height_unit: Option<&str>,
) -> PyResult<Field> {
    let units = Units::of(unit, height_unit)?;
    let sides = sides("npy.parse", positional, cell, size)?;
    let options = array_options(missing);
    let bytes: &[u8] = &bytes;
    py.detach(|| options.parse(bytes, sides))
        .or_raise(py)
        .map(|field| units.of_surface(field))
}

/// Returns the grid of an NPY file without reading its samples.
#[pyfunction]
#[pyo3(signature = (path, *positional, cell=None, size=None),
    text_signature = "(path, *, cell=None, size=None)")]
pub(crate) fn npy_grid(
    py: Python<'_>,
    path: PathBuf,
    positional: &Bound<'_, PyTuple>,
    cell: Option<conversion::CellSides>,
    size: Option<conversion::GridSides>,
) -> PyResult<Grid> {
    io::npy::grid(&path, sides("npy.grid", positional, cell, size)?)
        .or_raise(py)
        .map(Grid)
}

/// Writes a field to an NPY file.
#[pyfunction]
pub(crate) fn npy_write(py: Python<'_>, path: PathBuf, field: Samples<'_>) -> PyResult<()> {
    let field = field.alone("field")?;
    py.detach(|| io::npy::write(&path, &field)).or_raise(py)
}

/// Returns a field as the bytes of an NPY file.
#[pyfunction]
pub(crate) fn npy_to_bytes<'py>(
    py: Python<'py>,
    field: Samples<'py>,
) -> PyResult<Bound<'py, PyBytes>> {
    let field = field.alone("field")?;
    Ok(PyBytes::new(py, &io::npy::to_bytes(&field)))
}
