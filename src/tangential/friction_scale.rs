//! Coefficient of friction and largest shear stress compared with common values.

use crate::half_space::HalfSpace;
use crate::tangential::Friction;
use crate::warning::Warning;

/// Coefficient and cap of the friction that are not common, stored as integers for warnings.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(default)
)]
pub(crate) struct FrictionScale {
    /// Largest coefficient of friction that is not common, in tenths.
    coefficient_tenths: Option<usize>,
    /// Friction capacity without the cap divided by the capacity, if the cap is low.
    cap_parts: Option<usize>,
    /// Cap divided by the plane-strain modulus in thousandths, if the cap exceeds this modulus.
    cap_per_mille: Option<usize>,
    /// Whether the cap has lowered the limit of a cell.
    has_effect: bool,
}

impl FrictionScale {
    /// Compares the friction of a contact with common values. `capacities` are the capacities without and with the cap, or `None` if
    /// the friction has no cap or nothing was solved. The function is collective.
    pub(crate) fn of(
        bodies: &HalfSpace,
        friction: &Friction,
        capacities: Option<[f64; 2]>,
    ) -> Self {
        let [without, capacity] = capacities.unwrap_or([0.0; 2]);
        let cap = friction.cap().filter(|_| without > 0.0);
        let of_cap = cap.and_then(|cap| bodies.pair().limit_over_modulus(cap));
        Self {
            coefficient_tenths: Warning::friction_beyond(friction.largest_coefficient(bodies)),
            cap_parts: Warning::cap_below(without / capacity),
            cap_per_mille: of_cap.and_then(Warning::limit_beyond),
            has_effect: without > capacity,
        }
    }

    /// Returns whether the coefficient is common.
    pub(crate) fn is_common(self) -> bool {
        self.coefficient_tenths.is_none()
    }

    /// Returns the larger value of each quantity.
    #[cfg(feature = "history")]
    pub(crate) fn max(self, other: Self) -> Self {
        Self {
            coefficient_tenths: self.coefficient_tenths.max(other.coefficient_tenths),
            cap_parts: self.cap_parts.max(other.cap_parts),
            cap_per_mille: self.cap_per_mille.max(other.cap_per_mille),
            has_effect: self.has_effect || other.has_effect,
        }
    }

    /// Returns the warnings about a large coefficient or a low cap, and about a high cap. A large coefficient with a cap models a
    /// constant limit, so that it does not hide a high cap.
    pub(crate) fn warnings(self) -> [Option<Warning>; 2] {
        let large = self.coefficient_tenths;
        let large = large.map(|tenths| Warning::LargeFriction { tenths });
        let low = self
            .cap_parts
            .map(|parts| Warning::LowShearStress { parts });
        let is_ineffective = !self.has_effect || large.is_some();
        let high = self.cap_per_mille.filter(|_| is_ineffective);
        let high = high.map(|per_mille| Warning::ShearStressBeyondModulus { per_mille });
        [large.or(low), high]
    }
}
