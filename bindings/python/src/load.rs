//! Loads given by keywords: the control along each axis.

use pyo3::exceptions::PyTypeError;
#[cfg(feature = "stubs")]
use pyo3::inspect::PyStaticExpr;
use pyo3::prelude::*;
use pyo3::types::{IntoPyDict, PyTuple};
use stickslip::{
    Axis, LoadStep as Step, NormalControl, NormalLoad, TangentialControl, TangentialLoad as Load,
};

use crate::argument::by_value;
use crate::choice::Choice;
use crate::conversion::{self, kind_of};
use crate::digits::short;
use crate::history::{Rolling, as_keywords};
use crate::pickle::{parts, picklable};
use crate::real::Real;

/// Returns the normal load: a force, an approach, or neither.
pub(crate) fn normal(force: Option<Real>, approach: Option<Real>) -> PyResult<Option<NormalLoad>> {
    match (force, approach) {
        (Some(Real(force)), None) => Ok(Some(NormalLoad::Force(force))),
        (None, Some(Real(approach))) => Ok(Some(NormalLoad::Approach(approach))),
        (None, None) => Ok(None),
        _ => Err(PyTypeError::new_err(
            "give either a normal force or an approach, not both",
        )),
    }
}

/// Returns the normal load of a problem, which requires a force or an approach.
pub(crate) fn needed(force: Option<Real>, approach: Option<Real>) -> PyResult<NormalLoad> {
    needed_as("force", force, approach)
}

/// Returns the normal load of a problem whose keyword of the force is `keyword`.
pub(crate) fn needed_as(
    keyword: &str,
    force: Option<Real>,
    approach: Option<Real>,
) -> PyResult<NormalLoad> {
    normal(force, approach)?.ok_or_else(|| {
        PyTypeError::new_err(format!("give the normal load by {keyword}= or approach="))
    })
}

/// Declares the argument of a load that is given as an object; the message for other objects names the keywords.
macro_rules! loads {
    ($($(#[$doc:meta])* $name:ident($class:ident): $keywords:literal;)+) => {$(
        $(#[$doc])*
        pub(crate) struct $name(pub(crate) $class);

        impl FromPyObject<'_, '_> for $name {
            type Error = PyErr;

            #[cfg(feature = "stubs")]
            const INPUT_TYPE: PyStaticExpr = <$class as FromPyObject<'_, '_>>::INPUT_TYPE;

            fn extract(object: Borrowed<'_, '_, PyAny>) -> PyResult<Self> {
                object.extract().map(Self).map_err(|_| {
                    PyTypeError::new_err(format!(
                        concat!("load must be a ", stringify!($class), ", got {}: ", $keywords),
                        kind_of(&object)
                    ))
                })
            }
        }
    )+};
}

loads! {
    /// Load of a step.
    StepArgument(LoadStep): "give a normal force by normal_force=, a tangential force by force_x=";
    /// Tangential load from rest.
    TangentialArgument(TangentialLoad): "give a tangential force by force_x=, a shift by shift_x=";
}

/// Returns an error if a load is given by position, with the keywords of loads.
pub(crate) fn by_keyword(class: &str, given: &Bound<'_, PyTuple>, keywords: &str) -> PyResult<()> {
    none_by_position(&format!("{class} takes its load"), given, keywords)
}

/// Returns an error if arguments are given by position that are accepted by keyword only. The first words name the function and
/// the argument.
pub(crate) fn none_by_position(
    words: &str,
    given: &Bound<'_, PyTuple>,
    keywords: &str,
) -> PyResult<()> {
    if given.is_empty() {
        return Ok(());
    }
    let found = given.get_item(0)?;
    Err(PyTypeError::new_err(format!(
        "{words} by keyword, got {} by position: give {keywords}",
        found.repr()?
    )))
}

/// Returns the one control that is given along an axis, if any; the parameters are the possible kinds.
pub(crate) fn one_along<T>(
    axis: usize,
    given: impl IntoIterator<Item = Option<T>>,
    kinds: &str,
) -> PyResult<Option<T>> {
    let mut given = given.into_iter().flatten();
    let first = given.next();
    match given.next() {
        None => Ok(first),
        Some(_) => Err(PyTypeError::new_err(format!(
            "give at most one of {kinds} along {}",
            ["x", "y"][axis]
        ))),
    }
}

/// Keywords of the tangential load, shared by all functions that accept one.
#[derive(Default)]
pub(crate) struct Keywords {
    /// Force, shift and spring along both axes.
    pub(crate) both: (
        Option<conversion::Force>,
        Option<conversion::Shift>,
        Option<conversion::Springs>,
    ),
    pub(crate) force: [Option<Real>; 2],
    pub(crate) shift: [Option<Real>; 2],
    pub(crate) spring: [Option<conversion::Spring>; 2],
    pub(crate) twist: Option<Real>,
}

/// Collects the arguments of a function in the order of the signatures. PyO3 requires each argument as a parameter.
macro_rules! keywords {
    [$force:expr, $shift:ident, $spring:ident, $force_x:ident, $force_y:ident, $shift_x:ident, $shift_y:ident,
     $spring_x:ident, $spring_y:ident, $twist:ident] => {
        $crate::load::Keywords {
            both: ($force, $shift, $spring),
            force: [$force_x, $force_y],
            shift: [$shift_x, $shift_y],
            spring: [$spring_x, $spring_y],
            twist: $twist,
        }
    };
}

pub(crate) use keywords;

impl Keywords {
    pub(crate) fn is_empty(&self) -> bool {
        matches!(self.controls(), Ok([None, None])) && self.twist.is_none()
    }

    /// Returns the controls along x and y; `None` for an axis without a keyword.
    fn controls(&self) -> PyResult<[Option<TangentialControl>; 2]> {
        let (force, shift, spring) = &self.both;
        let spring_to = |(position, stiffness)| TangentialControl::Spring {
            position,
            stiffness,
        };
        let along = |axis: usize| {
            let given = [
                force
                    .as_ref()
                    .map(|force| TangentialControl::Force(force.0[axis])),
                shift
                    .as_ref()
                    .map(|shift| TangentialControl::Shift(shift.0[axis])),
                spring
                    .as_ref()
                    .map(|conversion::Springs((position, stiffness))| {
                        spring_to((position[axis], *stiffness))
                    }),
                self.force[axis].map(|Real(force)| TangentialControl::Force(force)),
                self.shift[axis].map(|Real(shift)| TangentialControl::Shift(shift)),
                self.spring[axis].map(|conversion::Spring(spring)| spring_to(spring)),
            ];
            one_along(axis, given, "force, shift and spring")
        };
        Ok([along(0)?, along(1)?])
    }

    /// Returns a load from rest. An axis without a keyword uses the same type of control as the other axis, with the
    /// value zero.
    pub(crate) fn load(&self) -> PyResult<Load> {
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
        Ok(load.twist(self.twist.map_or(0.0, f64::from)))
    }

    /// Returns the load from rest given as an object or by these keywords. The message for neither of them names the keywords.
    pub(crate) fn needed_or(&self, object: Option<TangentialArgument>) -> PyResult<Load> {
        if object.is_none() && self.is_empty() {
            return Err(PyTypeError::new_err(
                "give the tangential load by force_x=, shift_x=, spring_x=, twist= or other keywords of TangentialLoad: \
                 force_x=0.0 for no force",
            ));
        }
        self.load_or(object)
    }

    /// Returns the load of the next solve: the object, or the last load with the axes and the twist that have keywords replaced.
    pub(crate) fn load_after(
        &self,
        object: Option<TangentialArgument>,
        last: Load,
    ) -> PyResult<Load> {
        let mut load = last;
        for (axis, control) in [Axis::X, Axis::Y].into_iter().zip(self.controls()?) {
            if let Some(control) = control {
                load = load.along(axis, control);
            }
        }
        if let Some(Real(twist)) = self.twist {
            load = load.twist(twist);
        }
        one_of(object.map(|load| load.0.0), self.is_empty(), load)
    }

    /// Returns the load from rest given as an object or by these keywords.
    pub(crate) fn load_or(&self, object: Option<TangentialArgument>) -> PyResult<Load> {
        one_of(object.map(|load| load.0.0), self.is_empty(), self.load()?)
    }

    /// Returns a step in which every quantity without a keyword is held constant.
    pub(crate) fn step(
        &self,
        normal: Option<NormalLoad>,
        relative_displacement: Option<Real>,
        roll: Option<Rolling>,
    ) -> PyResult<Step> {
        let mut step = Step::hold().normal(normal.map_or(NormalControl::Hold, Into::into));
        for (axis, control) in [Axis::X, Axis::Y].into_iter().zip(self.controls()?) {
            if let Some(control) = control {
                step = step.tangential(axis, control);
            }
        }
        if let Some(Real(twist)) = self.twist {
            step = step.twist(twist);
        }
        if let Some(Real(amount)) = relative_displacement {
            step = step.relative_displacement(amount);
        }
        if let Some(Rolling(rolling)) = roll {
            step = step.roll(rolling);
        }
        Ok(step)
    }

    /// Returns the step given as an object, or by these keywords and three other arguments.
    pub(crate) fn step_or(
        &self,
        object: Option<StepArgument>,
        normal: Option<NormalLoad>,
        relative_displacement: Option<Real>,
        roll: Option<Rolling>,
    ) -> PyResult<Step> {
        let others_are_empty =
            normal.is_none() && relative_displacement.is_none() && roll.is_none();
        let is_empty = self.is_empty() && others_are_empty;
        let by_keywords = self.step(normal, relative_displacement, roll)?;
        one_of(object.map(|load| load.0.0), is_empty, by_keywords)
    }
}

/// Returns a load given as an object, or by its keywords if there is no object.
fn one_of<T>(object: Option<T>, is_without_keywords: bool, by_keywords: T) -> PyResult<T> {
    match object {
        None => Ok(by_keywords),
        Some(load) if is_without_keywords => Ok(load),
        Some(_) => Err(PyTypeError::new_err(
            "give either a load or its keywords, not both",
        )),
    }
}

/// A tangential load from rest, given by at least one keyword.
///
/// An axis without a keyword uses the same type of control as the other axis, with the value zero. The scalar model
/// supports a load along one axis only; the vector model supports any load.
///
/// Parameters
/// ----------
/// force, shift : pair of float, optional
///     Components along x and y, of either sign: the force that body 2 exerts on body 1, or the shift (lengths).
///     The shift is the rigid motion of body 2 relative to body 1 far from the contact, the relative rigid
///     tangential displacement.
/// spring : Spring, optional
///     Springs along both axes that drag body 2: ``Spring(position=(x, y), stiffness=...)``, with the position of their far
///     ends (lengths) and their stiffness (a force over a length, positive). The force is stiffness (position - shift).
/// force_x, force_y, shift_x, shift_y : float, optional
///     Force or shift along one axis.
/// spring_x, spring_y : Spring, optional
///     Spring along one axis: ``Spring(position=..., stiffness=...)``, with a length and a force over a length.
/// twist : float, default 0
///     Rotation of body 2 relative to body 1 about the origin of the grid (radians, positive from x to y). Only the
///     vector model supports a twist.
#[pyclass(frozen, eq, module = "stickslip")]
#[derive(Clone, Copy, PartialEq)]
pub(crate) struct TangentialLoad(pub(crate) Load);

by_value!(TangentialLoad, LoadStep);

#[pymethods]
impl TangentialLoad {
    #[new]
    #[pyo3(signature = (*positional, force=None, shift=None, spring=None, force_x=None, force_y=None, shift_x=None,
        shift_y=None, spring_x=None, spring_y=None, twist=None),
        text_signature = "(*, force=None, shift=None, spring=None, force_x=None, force_y=None, shift_x=None, shift_y=None, \
            spring_x=None, spring_y=None, twist=None)")]
    fn new(
        positional: &Bound<'_, PyTuple>,
        force: Option<conversion::Force>,
        shift: Option<conversion::Shift>,
        spring: Option<conversion::Springs>,
        force_x: Option<Real>,
        force_y: Option<Real>,
        shift_x: Option<Real>,
        shift_y: Option<Real>,
        spring_x: Option<conversion::Spring>,
        spring_y: Option<conversion::Spring>,
        twist: Option<Real>,
    ) -> PyResult<Self> {
        by_keyword("TangentialLoad", positional, "force_x= or shift_x=")?;
        let keywords = keywords![
            force, shift, spring, force_x, force_y, shift_x, shift_y, spring_x, spring_y, twist
        ];
        keywords.needed_or(None).map(Self)
    }

    /// Returns the control along an axis: ``("force", value)``, ``("shift", value)`` or
    /// ``("spring", Spring(position=..., stiffness=...))``.
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
                py.import("stickslip._spring")?.getattr("Spring")?.call(
                    (),
                    Some(&[("position", position), ("stiffness", stiffness)].into_py_dict(py)?),
                )?,
            ),
            _ => ("hold", py.None().into_bound(py)),
        })
    }

    fn __repr__(&self) -> PyResult<String> {
        #[derive(serde::Deserialize)]
        struct Parts {
            controls: [TangentialControl; 2],
            twist: f64,
        }
        let Parts { controls, twist } = parts(&self.0)?;
        let twist = (twist != 0.0).then_some(twist);
        Ok(format!(
            "TangentialLoad({})",
            shown_keywords(NormalControl::Hold, controls, twist, None).join(", ")
        ))
    }
}

picklable!(TangentialLoad: Load);

/// Returns the keywords of a load as text.
fn shown_keywords(
    normal: NormalControl,
    tangential: [TangentialControl; 2],
    twist: Option<f64>,
    relative_displacement: Option<f64>,
) -> Vec<String> {
    let mut shown = Vec::new();
    match normal {
        NormalControl::Force(force) => shown.push(format!("normal_force={}", short(force))),
        NormalControl::Approach(approach) => shown.push(format!("approach={}", short(approach))),
        _ => {}
    }
    for (axis, control) in ["x", "y"].into_iter().zip(tangential) {
        match control {
            TangentialControl::Force(force) => {
                shown.push(format!("force_{axis}={}", short(force)));
            }
            TangentialControl::Shift(shift) => {
                shown.push(format!("shift_{axis}={}", short(shift)));
            }
            TangentialControl::Spring {
                position,
                stiffness,
            } => shown.push(format!(
                "spring_{axis}=Spring(position={}, stiffness={})",
                short(position),
                short(stiffness)
            )),
            _ => {}
        }
    }
    shown.extend(twist.map(|twist| format!("twist={}", short(twist))));
    shown.extend(
        relative_displacement.map(|amount| format!("relative_displacement={}", short(amount))),
    );
    shown
}

/// Load prescribed at the end of a step of a history. A quantity without a keyword is held: the pressure, the
/// shift, the twist and the relative displacement.
///
/// A held shift does not hold the tangential force, which decreases if a lower pressure or less friction cannot
/// carry it. If pressure and traction are solved simultaneously, a step without a normal load holds the normal
/// force instead of the pressure. After a change of the gap, prescribe the normal load again in every step;
/// otherwise the pressure of the old gap is held.
///
/// Parameters
/// ----------
/// normal_force, approach : float, optional
///     The normal force (not negative) or the approach of the bodies from the datum of the gap (a length, positive
///     when they move together). At most one of the two may be given; without either, the pressure is held.
/// force, shift : pair of float, optional
///     Components along x and y, of either sign, as totals since the start of the history: the force that body 2
///     exerts on body 1, or the shift (lengths). The shift is the rigid motion of body 2 relative to body 1 far
///     from the contact, the relative rigid tangential displacement.
/// spring : Spring, optional
///     Springs along both axes that drag body 2: ``Spring(position=(x, y), stiffness=...)``, with the position of their far
///     ends (lengths since the start of the history) and their stiffness (a force over a length, positive). The force is
///     stiffness (position - shift). A later step without a spring holds the shift, not the far end.
/// force_x, force_y, shift_x, shift_y : float, optional
///     Force or shift along one axis.
/// spring_x, spring_y : Spring, optional
///     Spring along one axis: ``Spring(position=..., stiffness=...)``, with a length and a force over a length.
/// twist : float, optional
///     Rotation of body 2 relative to body 1 since the start (radians, positive from x to y). Only the vector model
///     supports a twist.
/// relative_displacement : float, optional
///     Factor by which the pattern of the relative displacement of the history is multiplied; held by default.
/// roll : stickslip.history.Rolling, optional
///     Rolling during the step: the memory of the particles moves through the contact while body 2 creeps over body 1.
///     Along an axis with a prescribed force, the creepage follows from the force. A shift, a spring or a twist is not
///     allowed in such a step. Normal load, gap and friction may change in the same step.
///
/// Examples
/// --------
/// >>> import stickslip
/// >>> press = stickslip.LoadStep(normal_force=100.0)
/// >>> drag = stickslip.LoadStep(shift_x=1e-6)
#[pyclass(frozen, eq, module = "stickslip")]
#[derive(Clone, PartialEq)]
pub(crate) struct LoadStep(pub(crate) Step);

#[pymethods]
impl LoadStep {
    #[new]
    #[pyo3(signature = (*positional, normal_force=None, approach=None, force=None, shift=None, spring=None, force_x=None,
        force_y=None, shift_x=None, shift_y=None, spring_x=None, spring_y=None, twist=None, relative_displacement=None,
        roll=None),
        text_signature = "(*, normal_force=None, approach=None, force=None, shift=None, spring=None, force_x=None, \
            force_y=None, shift_x=None, shift_y=None, spring_x=None, spring_y=None, twist=None, \
            relative_displacement=None, roll=None)")]
    fn new(
        positional: &Bound<'_, PyTuple>,
        normal_force: Option<Real>,
        approach: Option<Real>,
        force: Option<conversion::Force>,
        shift: Option<conversion::Shift>,
        spring: Option<conversion::Springs>,
        force_x: Option<Real>,
        force_y: Option<Real>,
        shift_x: Option<Real>,
        shift_y: Option<Real>,
        spring_x: Option<conversion::Spring>,
        spring_y: Option<conversion::Spring>,
        twist: Option<Real>,
        relative_displacement: Option<Real>,
        roll: Option<Rolling>,
    ) -> PyResult<Self> {
        by_keyword(
            "LoadStep",
            positional,
            "normal_force=, force_x= or shift_x=",
        )?;
        let keywords = keywords![
            force, shift, spring, force_x, force_y, shift_x, shift_y, spring_x, spring_y, twist
        ];
        let normal = normal(normal_force, approach)?;
        keywords.step(normal, relative_displacement, roll).map(Self)
    }

    /// Returns a step with the tangential load and its twist only; the pressure is held.
    #[staticmethod]
    fn of(load: TangentialLoad) -> Self {
        Self(load.0.into())
    }

    fn __repr__(&self) -> PyResult<String> {
        #[derive(serde::Deserialize)]
        struct Parts {
            normal: NormalControl,
            tangential: [TangentialControl; 2],
            twist: Option<f64>,
            relative_displacement: Option<f64>,
            rolling: Option<stickslip::history::Rolling>,
        }
        let Parts {
            normal,
            tangential,
            twist,
            relative_displacement,
            rolling,
        } = parts(&self.0)?;
        let mut shown = shown_keywords(normal, tangential, twist, relative_displacement);
        if let Some(rolling) = rolling {
            shown.push(format!("roll={}", as_keywords(&rolling)?));
        }
        Ok(format!("LoadStep({})", shown.join(", ")))
    }
}

picklable!(LoadStep: Step);
