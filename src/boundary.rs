//! What lies beyond the edge of the grid.

/// The surroundings of the grid.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Boundary {
    /// Unloaded half-space: the grid is a patch on bodies without end (default). Exact, whatever the
    /// size of the grid, as long as contact stays inside it.
    #[default]
    Free,
    /// The grid repeats along x and y, gap and tractions with it: for nominally flat surfaces, where
    /// free edges would sag and bias the contact.
    ///
    /// A mean traction moves a periodic half-space by an undefined amount; here by none. So a
    /// displacement has mean zero, the approach is the mean of the initial gap less that of the
    /// gap under load, and the shift is measured from the mean plane of the surface.
    Periodic,
}
