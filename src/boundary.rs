//! What lies beyond the edge of the grid.

/// The surroundings of the grid.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Boundary {
    /// Unloaded half-space: the grid is a patch on infinite bodies (default). Exact, whatever the
    /// size of the grid, as long as contact stays inside it.
    #[default]
    NonPeriodic,
    /// The grid repeats along x and y, with its gap and tractions: for nominally flat surfaces, where
    /// free edges would sag and bias the contact.
    ///
    /// The displacement of a periodic half-space under a mean traction is undefined; here it is set to
    /// zero. A displacement therefore has zero mean, the approach is the mean of the initial gap minus
    /// that of the gap under load, and the shift is measured from the mean plane of the surface.
    Periodic,
}
