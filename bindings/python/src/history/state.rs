//! Immutable states of a history.

use std::sync::Arc;

use pyo3::prelude::*;
use pyo3::types::{PyBytes, PyType};

use crate::array::{Array, contact, energies, snapshot, view, zones};
use crate::boundary::Boundary;
use crate::choice::Choice;
use crate::content::Content;
use crate::digits::{short, tuple};
use crate::error::OrRaise;
use crate::friction::Friction;
use crate::grid::Grid;
use crate::material::ElasticPair;
use crate::normal::{Hardness, NormalSolution};
use crate::pickle::{Standalone, by_itself};
use crate::readers::readers;
use crate::sequence::pair;
use crate::settings::Settings;
use crate::unit::{Unit, agree};

/// Class and bytes of a state.
type Saved<'py> = (Bound<'py, PyType>, Bound<'py, PyBytes>);

/// A state of a history, which can be restored, continued or saved. It contains gap, friction and settings, but not
/// the bodies. Arrays are read-only views of the memory of this object, except for the zones, which are read-only copies.
/// Vectors are (x, y). The guide page ``embedding`` states the number of bytes per cell.
#[pyclass(frozen, eq, module = "stickslip.history")]
pub(crate) struct State(
    pub(crate) Arc<stickslip::history::State>,
    /// Unit of the gap.
    pub(super) Option<Unit>,
);

impl PartialEq for State {
    fn eq(&self, other: &Self) -> bool {
        self.0 == other.0 && agree(self.1.as_ref(), other.1.as_ref())
    }
}

readers! { State.0:
    /// Grid of the fields.
    grid(): Grid => Grid,
    /// Boundary condition at the edge of the grid.
    boundary(): Boundary => Boundary,
    /// Rule for the part of the motion of a step that a cell follows if it comes into contact within the step.
    entry_rule(): Choice<stickslip::history::EntryRule> => Choice,
    /// Coupling between pressure and traction in the model.
    coupling(): Choice<stickslip::Coupling> => Choice,
    /// Whether the friction limits in the contact have changed since the last step.
    is_friction_new(): bool,
    /// Whether the pressure was computed for an earlier gap.
    is_pressure_stale(): bool,
    /// Approach of the bodies from the datum of the gap (a length).
    approach(): f64,
    /// Shift of body 2 relative to body 1 since the start, along x and y (lengths).
    shift(): (f64, f64) => pair,
    /// Rotation of body 2 relative to body 1 since the start (radians, positive from x to y).
    twist(): f64,
    /// Tangential force that body 2 exerts on body 1 along x and y.
    tangential_force(): (f64, f64) => pair,
    /// Moment about z, at the origin of the grid, on body 1 (a force times a length, positive from x to y).
    moment(): f64,
    /// Ratio of stick cells to contact cells after the last step, zero without contact.
    stick_ratio(): f64,
    /// Number of steps since the start.
    steps(): u64,
}

#[pymethods]
impl State {
    /// Unit of the gap of the history; ``None`` if it is not known. Bytes, files and pickles do not contain it.
    #[getter]
    fn unit(&self) -> Option<&str> {
        self.1.as_deref()
    }

    /// Returns the state as bytes, which later versions of the same minor series (such as 0.1) can read.
    fn to_bytes<'py>(&self, py: Python<'py>) -> Bound<'py, PyBytes> {
        let bytes = py.detach(|| self.0.to_bytes());
        PyBytes::new(py, &bytes)
    }

    /// Restores a state from its bytes.
    #[staticmethod]
    fn from_bytes(py: Python<'_>, bytes: Content<'_>) -> PyResult<Self> {
        let state = stickslip::history::State::from_bytes(&bytes).or_raise(py)?;
        Ok(Self(Arc::new(state), None))
    }

    /// The two bodies.
    #[getter]
    fn pair(&self) -> ElasticPair {
        self.0.pair().into()
    }

    /// The axis of the scalar model; ``None`` in the vector model.
    #[getter]
    fn axis(&self) -> Option<Choice<stickslip::Axis>> {
        self.0.axis().map(Choice)
    }

    /// Method, tolerance and limits.
    #[getter]
    fn settings(&self) -> Settings {
        Settings(*self.0.settings())
    }

    /// The friction of the history.
    #[getter]
    fn friction(&self) -> Friction {
        Friction(self.0.friction().clone())
    }

    /// The largest pressure of the cells; ``None`` if it is not limited.
    #[getter]
    fn hardness(&self) -> Option<Hardness> {
        self.0.hardness().cloned().map(Hardness)
    }

    /// The relative displacement along x and y after the last step (lengths); ``None`` unless the history has one.
    #[getter]
    fn relative_displacement<'py>(slf: &Bound<'py, Self>) -> Option<(Array<'py>, Array<'py>)> {
        let fields = slf.get().0.relative_displacement()?;
        Some(fields.map(|field| snapshot(slf.py(), field)).into())
    }

    /// Yielded depth of the surfaces since the start (lengths, not negative); ``None`` without a permanent set.
    #[getter]
    fn yielded<'py>(slf: &Bound<'py, Self>) -> Option<Array<'py>> {
        let field = slf.get().0.yielded()?;
        Some(snapshot(slf.py(), field))
    }

    /// The gap before loading (lengths), as last set, plus the yielded depth.
    #[getter]
    fn unloaded_gap<'py>(slf: &Bound<'py, Self>) -> Array<'py> {
        view(slf, |state| state.0.unloaded_gap())
    }

    /// The gap before loading (lengths), as last set, without the yielded depth; a read-only copy.
    #[getter]
    fn gap_as_set<'py>(slf: &Bound<'py, Self>) -> PyResult<Array<'py>> {
        let py = slf.py();
        Ok(snapshot(py, &slf.get().0.gap_as_set().or_raise(py)?))
    }

    /// The normal solution, which shares the memory of the state.
    #[getter]
    fn normal(&self) -> NormalSolution {
        NormalSolution::of_state(&self.0, self.1.clone())
    }

    /// Pressure, not negative; exactly zero outside the contact.
    #[getter]
    fn pressure<'py>(slf: &Bound<'py, Self>) -> Array<'py> {
        view(slf, |state| state.0.pressure())
    }

    /// Mask of the cells in contact, booleans of shape (ny, nx): cells with positive pressure. A read-only copy.
    #[getter]
    fn contact<'py>(&self, py: Python<'py>) -> Array<'py, bool> {
        contact(py, self.0.pressure())
    }

    /// Shear traction on body 1 along x and y (pressures).
    #[getter]
    fn traction<'py>(slf: &Bound<'py, Self>) -> (Array<'py>, Array<'py>) {
        (
            view(slf, |state| state.0.traction()[0]),
            view(slf, |state| state.0.traction()[1]),
        )
    }

    /// Slip since the start along x and y (lengths).
    #[getter]
    fn slip<'py>(slf: &Bound<'py, Self>) -> (Array<'py>, Array<'py>) {
        (
            view(slf, |state| state.0.slip()[0]),
            view(slf, |state| state.0.slip()[1]),
        )
    }

    /// Length of the path that each cell slipped since the start (lengths, not negative).
    #[getter]
    fn accumulated_slip<'py>(slf: &Bound<'py, Self>) -> Array<'py> {
        view(slf, |state| state.0.accumulated_slip())
    }

    /// Energy that each cell dissipated in the steps since the start (not negative). The array contains its grid.
    #[getter]
    fn accumulated_dissipation<'py>(slf: &Bound<'py, Self>) -> PyResult<Array<'py>> {
        let array = view(slf, |state| state.0.accumulated_dissipation());
        energies(
            slf.py(),
            &array,
            slf.get().0.accumulated_dissipation().grid(),
        )
    }

    /// Zone of each cell: 0 separated, 1 stick, 2 slip.
    ///
    /// The array also compares equal to the names of the zones; see :attr:`TangentialSolution.zones`.
    #[getter]
    fn zones<'py>(&self, py: Python<'py>) -> PyResult<Array<'py, u8>> {
        zones(py, self.0.grid(), self.0.zones())
    }

    fn __reduce__<'py>(slf: &Bound<'py, Self>) -> PyResult<Standalone<'py, Saved<'py>>> {
        let py = slf.py();
        by_itself(py, (slf.get_type(), slf.get().to_bytes(py)))
    }

    fn __repr__(&self) -> String {
        format!(
            "State(steps={}, normal_force={}, force={}, shift={})",
            self.0.steps(),
            short(self.0.normal().force()),
            tuple(&self.0.tangential_force()),
            tuple(&self.0.shift())
        )
    }
}
