//! What lies beyond the edge of the grid.

/// The surroundings of the grid.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
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
    /// The grid repeats along y alone, and unloaded half-space lies beyond its ends along x: for cylinders, rollers and
    /// pads. A [line of cells](crate::Grid::line) is a line contact in plane strain, and carries forces per length; a grid
    /// of more rows is the same with roughness or texture along y, and carries the forces of one period.
    ///
    /// Under a load that extends along y without end, a body moves infinitely far from its own depth, so that displacements
    /// are those relative to a datum: a point of the surface at the distance `datum` (a length) along x from a line load is
    /// not moved by it. Per unit length of a line load P, both bodies together,
    ///
    /// ```math
    /// u_z(x) = -\frac{2 P}{\pi E^*} \ln\frac{|x|}{d} .
    /// ```
    ///
    /// Approach and shift are those of this datum. Another one changes them by a multiple of the force, and nothing
    /// else. For one body the point at the depth h below the load moves as the surface does at the distance
    /// $`d = h \exp(-1/2(1-\nu))`$ from it. The datum is at least the length of the grid along x.
    ///
    /// A prescribed force has one solution at any datum. A prescribed approach or shift, and a spring, need a datum at which
    /// a flat punch as wide as the grid sinks in under its load. Homogeneous bodies always have it. Under a stiff coating the
    /// datum must be larger; [`Error::DatumTooNear`](crate::Error::DatumTooNear) reports the least one.
    ///
    /// Source: K. L. Johnson, Contact Mechanics (1985), sections 2.2 and 5.6.
    PeriodicAlongY {
        /// Distance along x at which a line load moves nothing (a length).
        datum: f64,
    },
}

impl Boundary {
    /// Whether the grid repeats along x and along y.
    pub(crate) fn repeats(self) -> [bool; 2] {
        match self {
            Self::NonPeriodic => [false; 2],
            Self::Periodic => [true; 2],
            Self::PeriodicAlongY { .. } => [false, true],
        }
    }

    /// Whether the bodies may turn about z: not where their gap repeats.
    pub(crate) fn may_turn(self) -> bool {
        self.repeats() == [false; 2]
    }
}
