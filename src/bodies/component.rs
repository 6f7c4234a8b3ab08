//! Directions of displacements and tractions, and the nine pairs of them.

/// Direction of a displacement or a traction on the surface.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Direction {
    /// Direction along the rows of the grid.
    X,
    /// Direction along the columns of the grid.
    Y,
    /// Direction into body 1, of pressures and normal displacements.
    Z,
}

/// Component of the influence coefficients: displacement direction, then traction direction.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Component {
    /// Displacement along x from traction along x.
    XX,
    /// Displacement along x from traction along y.
    XY,
    /// Displacement along x from pressure.
    XZ,
    /// Displacement along y from traction along x.
    YX,
    /// Displacement along y from traction along y.
    YY,
    /// Displacement along y from pressure.
    YZ,
    /// Displacement along z from traction along x.
    ZX,
    /// Displacement along z from traction along y.
    ZY,
    /// Displacement along z from pressure.
    ZZ,
}

impl Component {
    /// All nine components, row by row.
    pub const ALL: [Self; 9] = [
        Self::XX,
        Self::XY,
        Self::XZ,
        Self::YX,
        Self::YY,
        Self::YZ,
        Self::ZX,
        Self::ZY,
        Self::ZZ,
    ];

    /// Returns the component for a direction of displacement and a direction of traction.
    ///
    /// ```
    /// use stickslip::influence::{Component, Direction};
    /// assert_eq!(Component::of(Direction::Z, Direction::X), Component::ZX);
    /// ```
    #[must_use]
    pub const fn of(displacement: Direction, traction: Direction) -> Self {
        Self::ALL[3 * displacement as usize + traction as usize]
    }

    /// Returns the directions of displacement and of traction.
    pub(crate) const fn directions(self) -> [Direction; 2] {
        const DIRECTIONS: [Direction; 3] = [Direction::X, Direction::Y, Direction::Z];
        [DIRECTIONS[self as usize / 3], DIRECTIONS[self as usize % 3]]
    }

    /// Returns whether the coefficient is odd in x, and whether it is odd in y. Otherwise it is even.
    ///
    /// ```
    /// use stickslip::influence::Component;
    /// assert_eq!(Component::ZZ.is_odd(), [false, false]);
    /// assert_eq!(Component::ZX.is_odd(), [true, false]);
    /// assert_eq!(Component::XY.is_odd(), [true, true]);
    /// ```
    #[must_use]
    pub const fn is_odd(self) -> [bool; 2] {
        match self {
            Self::XX | Self::YY | Self::ZZ => [false, false],
            Self::XY | Self::YX => [true, true],
            Self::XZ | Self::ZX => [true, false],
            Self::YZ | Self::ZY => [false, true],
        }
    }
}
