//! Arguments of a prescribed form; the error message states the expected form.

use numpy::{AllowTypeChange, PyArrayLike2};
use pyo3::exceptions::{PyOverflowError, PyTypeError, PyValueError};
use pyo3::prelude::*;
use pyo3::types::{PyList, PyTuple};
#[cfg(feature = "stubs")]
use pyo3::{inspect::PyStaticExpr, type_hint_identifier};

use crate::layers::Layer;
use crate::real::{Real, filled, is_no_mask, is_real, numbers, unnamed};

/// Declares the class of an argument of a prescribed form: the content, the expected form (starting with the name of the
/// argument) and, if helpful, an alternative.
macro_rules! due {
    ($($(#[$doc:meta])* $name:ident($type:ty): $due:literal $(, $instead:literal)?;)+) => {$(
        $(#[$doc])*
        #[derive(Clone)]
        pub(crate) struct $name(pub(crate) $type);

        impl FromPyObject<'_, '_> for $name {
            type Error = PyErr;

            #[cfg(feature = "stubs")]
            const INPUT_TYPE: PyStaticExpr = <$type as FromPyObject<'_, '_>>::INPUT_TYPE;

            fn extract(object: Borrowed<'_, '_, PyAny>) -> PyResult<Self> {
                let instead = concat!("" $(, ": ", $instead)?);
                is_real(&object, named_in($due))?;
                is_no_mask(&object, named_in($due))?;
                let ordered = in_order(&object, $due)?;
                as_due(&ordered)
                    .map(Self)
                    .map_err(|error: PyErr| refused(&object, &ordered, &error, $due, instead))
            }
        }
    )+};
}

due! {
    /// Force along both axes.
    Force([f64; 2]): "force must be a pair (x, y)", "for a force along one axis give force_x= or force_y=";
    /// Creepages along both axes.
    Creepages([f64; 2]): "creepage must be a pair (x, y)", "for a creepage along x give (creepage, 0.0)";
    /// Shift along both axes.
    Shift([f64; 2]): "shift must be a pair (x, y)", "for a shift along one axis give shift_x= or shift_y=";
    /// Weights of the shifts along both axes.
    ShiftWeights([f64; 2]): "shift must be a pair (x, y) of weights";
    /// Spring of a minimum.
    FarEnd((f64, f64)): "spring must be a pair (far_end, compliance)";
    /// Springs given by their stiffnesses only.
    Stiffnesses([f64; 2]): "springs must be a pair of stiffnesses (x, y)";
    /// Amplitude of a reciprocating load.
    Amplitude([f64; 2]): "amplitude must be a pair (x, y)", "for a load along x give (amplitude, 0.0)";
    /// Amplitudes of an elliptical load path.
    EllipseAmplitudes([f64; 2]): "amplitudes must be a pair (x, y)";
    /// Values of a load path.
    PathSteps(Vec<[f64; 2]>): "steps must be a sequence of pairs (x, y)";
    /// Forces of a load path along one axis.
    ForcePath(Vec<f64>): "path must be a sequence of forces";
    /// Wavelengths along both axes.
    Wavelengths([f64; 2]): "wavelengths must be a pair (x, y)";
    /// Curvatures of a paraboloid.
    Curvatures([f64; 3]): "curvatures must be (k_xx, k_xy, k_yy)";
    /// In-plane strain.
    Strain([[f64; 2]; 2]): "strain must be [[xx, xy], [yx, yy]]";
    /// Bulk stresses of both bodies.
    BulkStress([f64; 2]): "stress must be a pair (body_1, body_2)", "for a bulk stress of body 1 give (stress, 0.0)";
    /// Columns of a part of a grid.
    Columns((usize, usize)): "columns must be a pair (first, end) of whole numbers";
    /// Rows of a part of a grid.
    Rows((usize, usize)): "rows must be a pair (first, end) of whole numbers";
    /// Depths below the surface.
    Depths(Vec<f64>): "depths must be a sequence of numbers", "for a single depth give [depth]";
    /// Side lengths of a cell.
    CellSides([f64; 2]): "cell must be a pair (dx, dy)";
    /// Ends of a region along x.
    RegionX([f64; 2]): "x must be a pair (start, end)";
    /// Ends of a region along y.
    RegionY([f64; 2]): "y must be a pair (start, end)";
    /// Side lengths of a grid.
    GridSides([f64; 2]): "size must be a pair (x, y)";
}

/// Declares the class of an argument that is a ``Spring``, with the type and the form of its position.
macro_rules! springs {
    ($($(#[$doc:meta])* $name:ident($type:ty): $keyword:literal, $position:literal;)+) => {$(
        $(#[$doc])*
        #[derive(Clone, Copy)]
        pub(crate) struct $name(pub(crate) ($type, f64));

        impl FromPyObject<'_, '_> for $name {
            type Error = PyErr;

            #[cfg(feature = "stubs")]
            const INPUT_TYPE: PyStaticExpr = type_hint_identifier!("stickslip._spring", "Spring");

            fn extract(object: Borrowed<'_, '_, PyAny>) -> PyResult<Self> {
                let part = |name: &str| object.getattr(name).map_err(|_| PyTypeError::new_err(format!(
                    concat!($keyword, " must be a Spring, got {}: give Spring(position=..., stiffness=...)"),
                    kind_of(&object)
                )));
                let (position, stiffness) = (part("position")?, part("stiffness")?);
                let due = concat!("the position of ", $keyword, " must be ", $position);
                is_real(&position, named_in(due))?;
                is_no_mask(&position, named_in(due))?;
                let ordered = in_order(&position, due)?;
                let position = as_due(&ordered)
                    .map_err(|error: PyErr| refused(&position, &ordered, &error, due, ""))?;
                let stiffness: Real = stiffness.extract()?;
                Ok(Self((position, stiffness.0)))
            }
        }
    )+};
}

springs! {
    /// Springs along both axes.
    Springs([f64; 2]): "spring", "a pair (x, y)";
    /// Spring along one axis.
    Spring(f64): "spring_x or spring_y", "a number";
}

/// Sequence of layers, outermost first.
pub(crate) struct Layers(pub(crate) Vec<stickslip::layers::Layer>);

impl FromPyObject<'_, '_> for Layers {
    type Error = PyErr;

    #[cfg(feature = "stubs")]
    const INPUT_TYPE: PyStaticExpr = <Vec<Layer> as FromPyObject<'_, '_>>::INPUT_TYPE;

    fn extract(object: Borrowed<'_, '_, PyAny>) -> PyResult<Self> {
        if let Ok(layers) = object.extract::<Vec<Layer>>() {
            return Ok(Self(layers.into_iter().map(|layer| layer.0).collect()));
        }
        let is_layer = |entry: &Bound<'_, PyAny>| entry.is_instance_of::<Layer>();
        let mut entries = object
            .try_iter()
            .into_iter()
            .flatten()
            .map_while(Result::ok);
        let found = match entries.find(|entry| !is_layer(entry)) {
            Some(entry) => format!("{} with the entry {}", kind_of(&object), entry.repr()?),
            None => kind_of(&object),
        };
        let remedy = if is_layer(&object) {
            "give [layer]"
        } else {
            "create layers by Layer(...)"
        };
        let message = format!("must be a sequence of Layer, got {found}: {remedy}");
        Err(unnamed(object.py(), "ArgumentType", &message))
    }
}

/// Returns the name of the argument, which precedes the verb in the description of the expected form.
fn named_in(due: &str) -> &str {
    let verb = due.find(" must be ");
    verb.map_or(due, |verb| &due[..verb])
}

/// Returns the entries of a labelled object, such as a table of pandas, in the order of the expected form, such as (x, y). Other
/// objects are returned unchanged.
fn in_order<'py>(object: &Bound<'py, PyAny>, due: &str) -> PyResult<Bound<'py, PyAny>> {
    if due.ends_with("[[xx, xy], [yx, yy]]") {
        let module = object.py().import("stickslip._tables")?;
        return module.call_method1("tensor_in_order", (object, named_in(due)));
    }
    let form = due.split_once('(').and_then(|(_, end)| end.split_once(')'));
    let Some((names, _)) = form else {
        return Ok(object.clone());
    };
    if object.is_exact_instance_of::<PyTuple>() || object.is_exact_instance_of::<PyList>() {
        return Ok(object.clone());
    }
    let names: Vec<_> = names.split(", ").collect();
    let module = object.py().import("stickslip._tables")?;
    let is_sequence = due.contains("a sequence of");
    module.call_method1("in_order", (object, named_in(due), names, is_sequence))
}

/// Returns the entries of a tuple or a list; `None` for other objects.
pub(crate) fn entries<'py>(object: &Bound<'py, PyAny>) -> Option<Bound<'py, PyTuple>> {
    match object.cast::<PyList>() {
        Ok(list) => Some(list.to_tuple()),
        Err(_) => object.cast::<PyTuple>().ok().cloned(),
    }
}

/// Converts an object to the expected type. A pair can be a tuple, a list or an array.
fn as_due<'py, T>(object: &Bound<'py, PyAny>) -> PyResult<T>
where
    T: for<'a> FromPyObject<'a, 'py, Error = PyErr>,
{
    object.extract().or_else(|error: PyErr| {
        // PyO3 extracts entries of different types from a tuple only.
        let listed = if object.hasattr("__array__")? {
            let numpy = object.py().import("numpy")?;
            numpy
                .call_method1("asarray", (filled(object)?,))?
                .call_method0("tolist")?
        } else {
            object.clone()
        };
        entries(&listed).map_or(Err(error), |tuple| tuple.extract())
    })
}

/// Declares the class of a sequence of triples of numbers, with the expected form (starting with the name of the
/// argument) and the form of a single triple.
macro_rules! triples {
    ($($(#[$doc:meta])* $name:ident: $due:literal, $single:literal;)+) => {$(
        $(#[$doc])*
        pub(crate) struct $name(pub(crate) Vec<[f64; 3]>);

        impl FromPyObject<'_, '_> for $name {
            type Error = PyErr;

            #[cfg(feature = "stubs")]
            const INPUT_TYPE: PyStaticExpr = type_hint_identifier!("numpy.typing", "ArrayLike");

            fn extract(object: Borrowed<'_, '_, PyAny>) -> PyResult<Self> {
                triples(&object, $due, concat!(": ", $single)).map(Self)
            }
        }
    )+};
}

triples! {
    /// Points below the surface.
    Points: "points must be a sequence of (x, y, depth)", "for a single point give [(x, y, depth)]";
    /// Creepages and spins.
    CreepPoints: "points must be a sequence of (creepage_x, creepage_y, spin)",
        "for a single point give [(creepage_x, creepage_y, spin)]";
}

fn triples(object: &Bound<'_, PyAny>, due: &str, instead: &str) -> PyResult<Vec<[f64; 3]>> {
    is_real(object, named_in(due))?;
    if object.len().is_ok_and(|length| length == 0) {
        return Ok(Vec::new());
    }
    let ordered = in_order(object, due)?;
    let refused = |error: &PyErr| refused(object, &ordered, error, due, instead);
    let rows: PyArrayLike2<'_, f64, AllowTypeChange> =
        numbers(&ordered).map_err(|error: PyErr| refused(&error))?;
    let rows = rows.as_array();
    if rows.ncols() != 3 {
        return Err(refused(&PyTypeError::new_err(due.to_owned())));
    }
    let rows = rows.rows().into_iter();
    Ok(rows.map(|row| [row[0], row[1], row[2]]).collect())
}

/// Returns the exception that states the expected form, or that names the number out of range if the form is right. The entries
/// are those of the object in the expected order: iteration over a table would give its labels.
fn refused(
    object: &Bound<'_, PyAny>,
    entries: &Bound<'_, PyAny>,
    error: &PyErr,
    due: &str,
    instead: &str,
) -> PyErr {
    if error.is_instance_of::<PyOverflowError>(object.py()) {
        let number = overflowing::<f64>(entries).or_else(|| overflowing::<usize>(entries));
        if let Some(number) = number {
            let range = if number.lt(0).unwrap_or(false) {
                "negative"
            } else {
                "too large"
            };
            return PyValueError::new_err(format!("{due}, got {number}, which is {range}"));
        }
    }
    let is_whole = due.ends_with("whole numbers");
    let nested = entries.try_iter().into_iter().flatten();
    let mut nested = nested.map_while(Result::ok);
    let wrong = wrong_entry(entries, is_whole)
        .or_else(|| nested.find_map(|entry| wrong_entry(&entry, is_whole)));
    if let Some(wrong) = wrong {
        return PyTypeError::new_err(format!("{due}, got {wrong}"));
    }
    let length = object
        .len()
        .map_or_else(|_| String::new(), |len| format!(" of length {len}"));
    let kind = kind_of(object);
    PyTypeError::new_err(format!("{due}, got {kind}{length}{instead}"))
}

/// Returns the first number of a sequence that does not fit into the type.
fn overflowing<'py, T>(object: &Bound<'py, PyAny>) -> Option<Bound<'py, PyAny>>
where
    T: for<'a> FromPyObject<'a, 'py, Error = PyErr>,
{
    object.try_iter().ok()?.map_while(Result::ok).find(|entry| {
        let error = entry.extract::<T>().err();
        error.is_some_and(|error| error.is_instance_of::<PyOverflowError>(object.py()))
    })
}

/// Returns the name of the type of an object, or the words for a missing value.
pub(crate) fn kind_of(object: &Bound<'_, PyAny>) -> String {
    if let Some(missing) = missing_value(object) {
        return missing.into();
    }
    let name = object.get_type().name();
    name.map_or_else(
        |_| "an object of unknown type".into(),
        |name| name.to_string(),
    )
}

/// Returns the words for a missing value of pandas. Returns `None` for other objects.
pub(crate) fn missing_value(object: &Bound<'_, PyAny>) -> Option<&'static str> {
    let name = object.get_type().name().ok()?;
    match name.to_str().ok()? {
        "NAType" => Some("the missing value <NA> (replace or remove missing values)"),
        "NaTType" => Some("the missing value NaT (replace or remove missing values)"),
        _ => None,
    }
}

/// Describes the first entry of a sequence with a wrong type, for the message of a wrong form. Entries must be numbers, or whole
/// numbers if `is_whole` is true. Returns `None` if all entries are numbers or sequences.
fn wrong_entry(object: &Bound<'_, PyAny>, is_whole: bool) -> Option<String> {
    let entry = object
        .try_iter()
        .ok()?
        .map_while(Result::ok)
        .find(|entry| {
            let is_number = if is_whole {
                entry.extract::<usize>().is_ok()
            } else {
                entry.extract::<f64>().is_ok()
            };
            !is_number && entry.len().is_err()
        })?;
    Some(if let Some(missing) = missing_value(&entry) {
        missing.into()
    } else if is_whole && entry.extract::<f64>().is_ok() {
        format!("{entry}: give a number of cells as an int, not a length")
    } else if entry.is_none() {
        "None as an entry".into()
    } else {
        format!("an entry of the type {}", kind_of(&entry))
    })
}
