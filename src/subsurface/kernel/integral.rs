//! The integrals that compose all components.

/// Integral over the loaded rectangle. It is a potential `V`, `L` or `W` of the [module](super), a derivative of a
/// potential, or a component of the tensor `T`.
///
/// The first five integrals are lengths. The other integrals are dimensionless.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum PotentialIntegral {
    V,
    Lx,
    Ly,
    Wxx,
    Wxy,
    Lxx,
    Lxy,
    Wxxy,
    Wxyy,
    Txxx,
    Txxy,
    Txyy,
    Tyyy,
    Txxz,
    Txyz,
    Tyyz,
    Txzz,
    Tyzz,
    Tzzz,
}

impl PotentialIntegral {
    /// Number of integrals.
    pub(crate) const COUNT: usize = 19;

    /// Number of integrals that are lengths, which come first.
    pub(crate) const LENGTHS: usize = 5;

    /// All integrals, each at its own index.
    pub(crate) const ALL: [Self; Self::COUNT] = [
        Self::V,
        Self::Lx,
        Self::Ly,
        Self::Wxx,
        Self::Wxy,
        Self::Lxx,
        Self::Lxy,
        Self::Wxxy,
        Self::Wxyy,
        Self::Txxx,
        Self::Txxy,
        Self::Txyy,
        Self::Tyyy,
        Self::Txxz,
        Self::Txyz,
        Self::Tyyz,
        Self::Txzz,
        Self::Tyzz,
        Self::Tzzz,
    ];

    /// Returns the index of the integral in an array of all integrals.
    pub(crate) const fn index(self) -> usize {
        self as usize
    }

    /// Returns whether the integral is a length.
    pub(crate) fn is_length(self) -> bool {
        self.index() < Self::LENGTHS
    }

    /// Returns whether the integral is odd in x and whether it is odd in y. An integral that is not odd is even.
    pub(crate) const fn is_odd(self) -> [bool; 2] {
        match self {
            Self::V | Self::Wxx | Self::Lxx | Self::Txxz | Self::Tyyz | Self::Tzzz => {
                [false, false]
            }
            Self::Lx | Self::Wxyy | Self::Txxx | Self::Txyy | Self::Txzz => [true, false],
            Self::Ly | Self::Wxxy | Self::Txxy | Self::Tyyy | Self::Tyzz => [false, true],
            Self::Wxy | Self::Lxy | Self::Txyz => [true, true],
        }
    }
}

/// Value of each integral.
pub(super) type Values = [f64; PotentialIntegral::COUNT];

/// Returns the sign of an integral relative to the quadrant of positive x and y. Returns zero if the integral vanishes
/// by parity.
pub(super) fn sign(integral: PotentialIntegral, [x, y]: [f64; 2]) -> f64 {
    let [odd_x, odd_y] = integral.is_odd();
    let along = |is_odd: bool, x: f64| match x {
        _ if !is_odd || x > 0.0 => 1.0,
        x if x < 0.0 => -1.0,
        _ => x,
    };
    along(odd_x, x) * along(odd_y, y)
}
