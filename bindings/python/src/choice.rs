//! Options selected by name: a string or a member of an enumeration of ``stickslip``, whose members are also strings.

use pyo3::prelude::*;
#[cfg(feature = "stubs")]
use pyo3::{inspect::PyStaticExpr, type_hint_identifier, type_hint_union};

use crate::conversion::kind_of;
use crate::real::unnamed;

/// Enumeration of the crate whose variants have names.
pub(crate) trait Named: Copy + PartialEq + 'static {
    const ENUMERATION: &'static str;
    /// Python module that exports the enumeration.
    const MODULE: &'static str;
    const ALL: &'static [(&'static str, Self)];
    #[cfg(feature = "stubs")]
    const HINT: PyStaticExpr;
}

/// Variant of an enumeration whose variants have names.
#[derive(Clone, Copy, PartialEq)]
pub(crate) struct Choice<T>(pub(crate) T);

impl<T: Named> Choice<T> {
    pub(crate) fn name(self) -> &'static str {
        let named = T::ALL.iter().find(|(_, variant)| *variant == self.0);
        named.map_or("other", |(name, _)| name)
    }
}

impl<T: Named> FromPyObject<'_, '_> for Choice<T> {
    type Error = PyErr;

    #[cfg(feature = "stubs")]
    const INPUT_TYPE: PyStaticExpr =
        type_hint_union!(T::HINT, type_hint_identifier!("builtins", "str"));

    fn extract(object: Borrowed<'_, '_, PyAny>) -> PyResult<Self> {
        let names = || {
            let names: Vec<_> = T::ALL.iter().map(|(name, _)| format!("'{name}'")).collect();
            names.join(", ")
        };
        let refused = |class: &str, found: &str| {
            let (names, module, enumeration) = (names(), T::MODULE, T::ENUMERATION);
            let message = format!(
                "must be one of {names}, or a member of {module}.{enumeration}, got {found}"
            );
            unnamed(object.py(), class, &message)
        };
        let given: String = object
            .extract()
            .map_err(|_| refused("ArgumentType", &kind_of(&object)))?;
        let named = T::ALL.iter().find(|(name, _)| *name == given);
        named
            .map(|(_, variant)| Self(*variant))
            .ok_or_else(|| refused("ArgumentRange", &format!("'{given}'")))
    }
}

impl<'py, T: Named> IntoPyObject<'py> for Choice<T> {
    type Target = PyAny;
    type Output = Bound<'py, PyAny>;
    type Error = PyErr;

    #[cfg(feature = "stubs")]
    const OUTPUT_TYPE: PyStaticExpr = T::HINT;

    fn into_pyobject(self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let enumeration = py.import("stickslip._enums")?.getattr(T::ENUMERATION)?;
        enumeration.call1((self.name(),))
    }
}

macro_rules! named {
    ($($module:literal $enumeration:literal: $type:ty { $($name:literal = $variant:ident),+ })+) => {$(
        impl Named for $type {
            const ENUMERATION: &'static str = $enumeration;
            const MODULE: &'static str = $module;
            const ALL: &'static [(&'static str, Self)] = &[$(($name, <$type>::$variant)),+];
            #[cfg(feature = "stubs")]
            const HINT: PyStaticExpr = type_hint_identifier!("stickslip._enums", $enumeration);
        }
    )+};
}

named! {
    "stickslip" "Axis": stickslip::Axis { "x" = X, "y" = Y }
    "stickslip" "TangentialModel": stickslip::TangentialModel { "scalar" = Scalar, "vector" = Vector }
    "stickslip" "Coupling": stickslip::Coupling { "full" = Full, "one_way" = OneWay, "neglected" = Neglected }
    "stickslip" "CellValue": stickslip::CellValue { "uniform" = Uniform, "centre" = Centre }
    "stickslip.history" "EntryRule": stickslip::history::EntryRule { "since_touch" = SinceTouch, "whole_step" = WholeStep }
    "stickslip.rolling" "LeadingEdge": stickslip::rolling::LeadingEdge {
        "plus_x" = PlusX, "minus_x" = MinusX, "plus_y" = PlusY, "minus_y" = MinusY
    }
    "stickslip" "Method": stickslip::cgm::Method { "active_set" = ActiveSet, "polonsky_keer" = PolonskyKeer }
    "stickslip" "Status": stickslip::Status {
        "unsolved" = Unsolved, "converged" = Converged, "iteration_limit" = IterationLimit,
        "time_limit" = TimeLimit, "stalled" = Stalled, "cancelled" = Cancelled
    }
    "stickslip" "EigenvalueBound": stickslip::EigenvalueBound {
        "unknown" = Unknown, "estimated" = Estimated, "stated" = Stated, "proven" = Proven
    }
    "stickslip.history" "Regime": stickslip::history::Regime {
        "full_stick" = FullStick, "partial_slip" = PartialSlip, "gross_slip" = GrossSlip
    }
    "stickslip.history" "StopReason": stickslip::history::StopReason {
        "steady" = Steady, "cycle_limit" = CycleLimit, "stopped" = Stopped
    }
    "stickslip.subsurface" "Body": stickslip::subsurface::Body { "one" = One, "two" = Two }
    "stickslip.surface" "Amplitudes": stickslip::surface::Amplitudes { "exact" = Exact, "gaussian" = Gaussian }
    "stickslip.surface" "Interpolation": stickslip::surface::Interpolation { "cubic" = Cubic, "linear" = Linear }
    "stickslip.adaptive" "Quantity": stickslip::adaptive::Quantity {
        "pressure" = Pressure, "area" = Area, "approach" = Approach, "force" = Force, "traction" = Traction,
        "stick_ratio" = StickRatio, "shift" = Shift
    }
    "stickslip.adaptive" "AdaptiveStatus": stickslip::adaptive::AdaptiveStatus {
        "reached" = Reached, "cell_limit" = CellLimit, "time_limit" = TimeLimit, "sample_spacing" = SampleSpacing,
        "cancelled" = Cancelled
    }
    "stickslip.influence" "Direction": stickslip::influence::Direction { "x" = X, "y" = Y, "z" = Z }
    "stickslip.influence" "Component": stickslip::influence::Component {
        "xx" = XX, "xy" = XY, "xz" = XZ, "yx" = YX, "yy" = YY, "yz" = YZ, "zx" = ZX, "zy" = ZY, "zz" = ZZ
    }
}
