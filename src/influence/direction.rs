//! The three directions of a displacement or a traction.

/// A direction of a displacement or a traction on the surface.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Direction {
    /// Along the rows of the grid.
    X,
    /// Along the columns of the grid.
    Y,
    /// Into body 1: the direction of pressures and normal displacements.
    Z,
}
