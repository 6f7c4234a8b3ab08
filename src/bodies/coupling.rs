//! How much of the coupling between pressure and traction is modelled.

use crate::bodies::material::ElasticPair;

/// How much is modelled of the coupling between pressure and traction in bodies of different materials.
///
/// Pairs that [are not coupled](ElasticPair::is_coupled) have the same answer whatever the choice, by the same work.
///
/// What [`OneWay`](Self::OneWay) costs in accuracy, measured on a sphere that is pressed in 16 steps on 93 x 93 cells: differences
/// from [`Full`](Self::Full), those of pressure and traction as root mean squares relative to those of the field. The pressure
/// is the same as with [`Neglected`](Self::Neglected).
///
/// | $`\beta`$ | $`\mu`$ | pressure | traction | dissipated energy | stick radius of the contact's, for that of full coupling |
/// |---|---|---|---|---|---|
/// | 0.117 | 0.1 | 1.0 % | 1.5 % | -2 % | 0.816 for 0.815 |
/// | 0.117 | 0.3 | 1.3 % | 7.2 % | -1 % | 0.965 for 0.964 |
/// | 0.117 | 1 | 1.4 % | 15 % | -11 % | 0.993 for 0.992 |
/// | 0.286 | 0.1 | 3.3 % | 3.8 % | -5 % | 0.218 for 0.194 |
/// | 0.286 | 0.3 | 6.4 % | 10 % | -9 % | 0.891 for 0.865 |
/// | 0.286 | 1 | 7.5 % | 46 % | -7 % | 0.974 for 0.970 |
/// | 0.5 | 0.1 | 5.7 % | 5.7 % | -6 % | 0.033 for 0.015 |
/// | 0.5 | 0.3 | 15 % | 20 % | -30 % | 0.610 for 0.492 |
/// | 0.5 | 1 | 20 % | 36 % | -13 % | 0.953 for 0.936 |
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub enum Coupling {
    /// Pressure and traction are found together ([`coupled`](crate::coupled)).
    #[default]
    Full,
    /// Shear does not change the pressure, but pressure moves the surfaces tangentially (Goodman's assumption, J. Appl.
    /// Mech. 29 (1962) 515, <https://doi.org/10.1115/1.3640599>). The two are found one after the other; each is the
    /// minimum of a convex energy, with a certified error.
    OneWay,
    /// Neither moves the other: an error of order beta in the pressure. Pressing alone then causes no traction.
    Neglected,
}

impl Coupling {
    /// Whether pressure and traction of these bodies are to be found together.
    pub(crate) fn is_joint(self, pair: &ElasticPair) -> bool {
        self == Self::Full && pair.is_coupled()
    }

    /// Whether pressure alone is to move the surfaces of these bodies tangentially.
    pub(crate) fn is_one_way(self, pair: &ElasticPair) -> bool {
        self == Self::OneWay && pair.is_coupled()
    }
}
