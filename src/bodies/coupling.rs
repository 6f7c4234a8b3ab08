//! Degree to which the coupling between pressure and traction is modelled.

use crate::bodies::material::ElasticPair;

/// Degree to which the coupling between pressure and traction is modelled for bodies of different materials.
///
/// For pairs that [are not coupled](ElasticPair::is_coupled) every choice gives the same solution with the same work.
///
/// The table lists the loss of accuracy with [`OneWay`](Self::OneWay) and the vector model. It is measured on a sphere
/// that is pressed in 16 steps of equal growth of the radius with the whole-step rule. The grid has 93 x 93 cells over 2.4
/// contact radii. The values are differences from [`Full`](Self::Full). The differences of pressure and traction are root
/// mean squares relative to the root mean square of the field. The pressure is the same as with
/// [`Neglected`](Self::Neglected). With the default entry rule no cell slips in these steps for the first pair at a
/// friction coefficient of 0.3 or 1.
///
/// | $`\beta`$ | $`\mu`$ | pressure | traction | dissipated energy | stick radius / contact radius, in brackets with full coupling |
/// |---|---|---|---|---|---|
/// | 0.117 | 0.1 | 1.0 % | 1.5 % | -2 % | 0.816 (0.815) |
/// | 0.117 | 0.3 | 1.3 % | 7.2 % | -1 % | 0.965 (0.964) |
/// | 0.117 | 1 | 1.4 % | 15 % | -11 % | 0.993 (0.992) |
/// | 0.286 | 0.1 | 3.3 % | 3.8 % | -5 % | 0.218 (0.194) |
/// | 0.286 | 0.3 | 6.4 % | 10 % | -9 % | 0.891 (0.865) |
/// | 0.286 | 1 | 7.5 % | 46 % | -7 % | 0.974 (0.970) |
/// | 0.5 | 0.1 | 5.7 % | 5.7 % | -6 % | 0.033 (0.015) |
/// | 0.5 | 0.3 | 15 % | 20 % | -30 % | 0.610 (0.492) |
/// | 0.5 | 1 | 20 % | 36 % | -13 % | 0.953 (0.936) |
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub enum Coupling {
    /// Pressure and traction are solved simultaneously ([`coupled`](crate::coupled)).
    #[default]
    Full,
    /// Shear does not change the pressure, but pressure moves the surfaces tangentially (Goodman's assumption, J. Appl. Mech. 29
    /// (1962) 515, <https://doi.org/10.1115/1.3640599>). The pressure is solved first, then the traction. Each solution is the
    /// minimum of a convex energy and has a certified error.
    OneWay,
    /// Pressure and traction do not affect each other. Pressing alone then causes neither traction nor slip.
    ///
    /// The following errors are root mean square differences from [`Full`](Self::Full), relative to the root mean square of
    /// the pressure. The contact is a sphere on 48 x 48 cells.
    ///
    /// - Under pressing alone, the error of the pressure is of the order of $`\beta^2`$. If friction is so weak that most of the
    ///   contact slips, it is of the order of $`\mu\beta`$. The error is $`0.8\,\beta^2`$ for $`\mu = \beta`$ or more, and
    ///   $`1.1\,\mu\beta`$ for $`\mu = 0.1\,\beta`$.
    /// - The neglected tractions due to pressing are of the order of $`\beta`$: $`0.66\,\beta`$ for $`\mu = 3\beta`$ or more.
    /// - Under shear, the error of the pressure is of the order of $`\mu\beta`$. At 0.6 of the sliding force and
    ///   $`\beta = 0.1`$ it is 1.9 % for $`\mu = 0.3`$ and 5.8 % for $`\mu = 1`$.
    /// - The shift under a force has an error of the order of $`(\beta/\mu)^2`$. At 0.6 of the sliding force and
    ///   $`\beta = 0.1`$ it is 8 % for $`\mu = 0.1`$ and 1 % for $`\mu = 0.3`$.
    Neglected,
}

impl Coupling {
    /// Returns whether pressure and traction of these bodies must be solved simultaneously.
    pub(crate) fn is_joint(self, pair: &ElasticPair) -> bool {
        self == Self::Full && pair.is_coupled()
    }

    /// Returns whether pressure moves the surfaces of these bodies tangentially, without an effect of shear on the
    /// pressure.
    pub(crate) fn is_one_way(self, pair: &ElasticPair) -> bool {
        self == Self::OneWay && pair.is_coupled()
    }
}
