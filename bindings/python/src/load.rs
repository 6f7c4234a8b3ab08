//! Loads by keywords: what is prescribed along each axis.

use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;
use stickslip::{Axis, LoadStep as Step, NormalControl, TangentialControl, TangentialLoad as Load};

use crate::choice::Choice;
use crate::pickle::picklable;

/// The normal half: a force or an approach, or neither.
pub(crate) fn normal(force: Option<f64>, approach: Option<f64>) -> PyResult<Option<NormalControl>> {
    match (force, approach) {
        (Some(force), None) => Ok(Some(NormalControl::Force(force))),
        (None, Some(approach)) => Ok(Some(NormalControl::Approach(approach))),
        (None, None) => Ok(None),
        _ => Err(PyTypeError::new_err(
            "give a normal force or an approach, not both",
        )),
    }
}

/// The normal half of a problem, which needs one.
pub(crate) fn needed(force: Option<f64>, approach: Option<f64>) -> PyResult<NormalControl> {
    normal(force, approach)?
        .ok_or_else(|| PyTypeError::new_err("give the normal load: force= or approach="))
}

/// The tangential half as it is given.
#[derive(Default)]
pub(crate) struct Tangential {
    pub(crate) force: Option<[f64; 2]>,
    pub(crate) shift: Option<[f64; 2]>,
    pub(crate) spring: Option<([f64; 2], f64)>,
    pub(crate) force_x: Option<f64>,
    pub(crate) force_y: Option<f64>,
    pub(crate) shift_x: Option<f64>,
    pub(crate) shift_y: Option<f64>,
    pub(crate) spring_x: Option<(f64, f64)>,
    pub(crate) spring_y: Option<(f64, f64)>,
}

impl Tangential {
    pub(crate) fn is_empty(&self) -> bool {
        matches!(self.controls(), Ok([None, None]))
    }

    /// What is prescribed along x and y, if anything.
    fn controls(&self) -> PyResult<[Option<TangentialControl>; 2]> {
        let along =
            |axis: usize, force: Option<f64>, shift: Option<f64>, spring: Option<(f64, f64)>| {
                let both = [
                    self.force
                        .map(|force| TangentialControl::Force(force[axis])),
                    self.shift
                        .map(|shift| TangentialControl::Shift(shift[axis])),
                    self.spring
                        .map(|(position, stiffness)| TangentialControl::Spring {
                            position: position[axis],
                            stiffness,
                        }),
                    force.map(TangentialControl::Force),
                    shift.map(TangentialControl::Shift),
                    spring.map(|(position, stiffness)| TangentialControl::Spring {
                        position,
                        stiffness,
                    }),
                ];
                let mut given = both.into_iter().flatten();
                let first = given.next();
                match given.next() {
                    None => Ok(first),
                    Some(_) => Err(PyTypeError::new_err(format!(
                        "give one of force, shift and spring along {}",
                        ["x", "y"][axis]
                    ))),
                }
            };
        Ok([
            along(0, self.force_x, self.shift_x, self.spring_x)?,
            along(1, self.force_y, self.shift_y, self.spring_y)?,
        ])
    }

    /// A load from rest: along an axis of which nothing is said, the other's kind with the value zero.
    pub(crate) fn load(&self, twist: Option<f64>) -> PyResult<Load> {
        let zero = |control| match control {
            TangentialControl::Shift(_) => TangentialControl::Shift(0.0),
            TangentialControl::Spring { stiffness, .. } => TangentialControl::Spring {
                position: 0.0,
                stiffness,
            },
            _ => TangentialControl::Force(0.0),
        };
        let [x, y] = match self.controls()? {
            [Some(x), Some(y)] => [x, y],
            [Some(x), None] => [x, zero(x)],
            [None, Some(y)] => [zero(y), y],
            [None, None] => [TangentialControl::Force(0.0); 2],
        };
        let load = Load::force([0.0; 2]).along(Axis::X, x).along(Axis::Y, y);
        Ok(load.twist(twist.unwrap_or(0.0)))
    }

    /// A step: what is not given is held.
    pub(crate) fn step(
        &self,
        normal: Option<NormalControl>,
        twist: Option<f64>,
        relative_displacement: Option<f64>,
    ) -> PyResult<Step> {
        let mut step = Step::hold().normal(normal.unwrap_or(NormalControl::Hold));
        for (axis, control) in [Axis::X, Axis::Y].into_iter().zip(self.controls()?) {
            if let Some(control) = control {
                step = step.tangential(axis, control);
            }
        }
        if let Some(twist) = twist {
            step = step.twist(twist);
        }
        if let Some(amount) = relative_displacement {
            step = step.relative_displacement(amount);
        }
        Ok(step)
    }
}

/// A tangential load from rest.
///
/// Along an axis of which nothing is said, it is zero, of the kind of the other. The scalar model takes a load along one
/// axis, the vector model any.
///
/// Parameters
/// ----------
/// force, shift : pair of float, optional
///     Along x and y: the force that body 2 exerts on body 1; the shift of body 2 relative to body 1 (lengths).
/// spring : ((x, y), stiffness), optional
///     Springs along both axes, by the position of their far ends.
/// force_x, force_y, shift_x, shift_y : float, optional
///     The same along one axis.
/// spring_x, spring_y : (position, stiffness), optional
/// twist : float, default 0
///     Rotation of body 2 about the origin of the grid (radians). The vector model alone has it.
#[pyclass(frozen, eq, module = "stickslip", from_py_object)]
#[derive(Clone, Copy, PartialEq)]
pub(crate) struct TangentialLoad(pub(crate) Load);

#[pymethods]
impl TangentialLoad {
    #[new]
    #[pyo3(signature = (*, force=None, shift=None, spring=None, force_x=None, force_y=None, shift_x=None,
        shift_y=None, spring_x=None, spring_y=None, twist=None))]
    fn new(
        force: Option<[f64; 2]>,
        shift: Option<[f64; 2]>,
        spring: Option<([f64; 2], f64)>,
        force_x: Option<f64>,
        force_y: Option<f64>,
        shift_x: Option<f64>,
        shift_y: Option<f64>,
        spring_x: Option<(f64, f64)>,
        spring_y: Option<(f64, f64)>,
        twist: Option<f64>,
    ) -> PyResult<Self> {
        let given = Tangential {
            force,
            shift,
            spring,
            force_x,
            force_y,
            shift_x,
            shift_y,
            spring_x,
            spring_y,
        };
        given.load(twist).map(Self)
    }

    /// What is prescribed along an axis: ``("force", value)``, ``("shift", value)`` or
    /// ``("spring", (position, stiffness))``.
    fn control<'py>(
        &self,
        py: Python<'py>,
        axis: Choice<Axis>,
    ) -> PyResult<(&'static str, Bound<'py, PyAny>)> {
        let object = |value: f64| value.into_pyobject(py).map(Bound::into_any);
        Ok(match self.0.control(axis.0) {
            TangentialControl::Force(force) => ("force", object(force)?),
            TangentialControl::Shift(shift) => ("shift", object(shift)?),
            TangentialControl::Spring {
                position,
                stiffness,
            } => (
                "spring",
                (position, stiffness).into_pyobject(py)?.into_any(),
            ),
            _ => ("hold", py.None().into_bound(py)),
        })
    }

    fn __repr__(&self) -> String {
        format!("{:?}", self.0)
    }
}

picklable!(TangentialLoad: Load);

/// What a step of a history prescribes at its end; all that is not named is held.
///
/// Parameters
/// ----------
/// normal_force, approach : float, optional
///     One of the two; without either the pressure is held.
/// force, shift : pair of float, optional
///     Along x and y, as totals since the start of the history: force that body 2 exerts on body 1, shift of body 2
///     relative to body 1.
/// spring : ((x, y), stiffness), optional
///     Springs along both axes, by the position of their far ends.
/// force_x, force_y, shift_x, shift_y : float, optional
///     The same along one axis.
/// spring_x, spring_y : (position, stiffness), optional
/// twist : float, optional
///     Rotation since the start (radians). The vector model alone has it.
/// relative_displacement : float, optional
///     Amount of the relative displacement of the history.
///
/// Examples
/// --------
/// >>> import stickslip
/// >>> press = stickslip.LoadStep(normal_force=100.0)
/// >>> drag = stickslip.LoadStep(shift_x=1e-6)
#[pyclass(frozen, eq, module = "stickslip", from_py_object)]
#[derive(Clone, PartialEq)]
pub(crate) struct LoadStep(pub(crate) Step);

#[pymethods]
impl LoadStep {
    #[new]
    #[pyo3(signature = (*, normal_force=None, approach=None, force=None, shift=None, spring=None, force_x=None,
        force_y=None, shift_x=None, shift_y=None, spring_x=None, spring_y=None, twist=None, relative_displacement=None))]
    fn new(
        normal_force: Option<f64>,
        approach: Option<f64>,
        force: Option<[f64; 2]>,
        shift: Option<[f64; 2]>,
        spring: Option<([f64; 2], f64)>,
        force_x: Option<f64>,
        force_y: Option<f64>,
        shift_x: Option<f64>,
        shift_y: Option<f64>,
        spring_x: Option<(f64, f64)>,
        spring_y: Option<(f64, f64)>,
        twist: Option<f64>,
        relative_displacement: Option<f64>,
    ) -> PyResult<Self> {
        let given = Tangential {
            force,
            shift,
            spring,
            force_x,
            force_y,
            shift_x,
            shift_y,
            spring_x,
            spring_y,
        };
        let normal = normal(normal_force, approach)?;
        given.step(normal, twist, relative_displacement).map(Self)
    }

    /// The tangential half alone, with the twist of the load; the pressure is held.
    #[staticmethod]
    fn of(load: TangentialLoad) -> Self {
        Self(load.0.into())
    }

    fn __repr__(&self) -> String {
        format!("{:?}", self.0)
    }
}

picklable!(LoadStep: Step);
