//! Boundary conditions at the edge of the grid.

/// Surroundings of the grid.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub enum Boundary {
    /// Unloaded half-space around the grid, which is a patch on infinite bodies (default). The model is exact for any
    /// size of the grid if the contact stays inside the grid.
    #[default]
    NonPeriodic,
    /// Periodic surroundings: grid, gap and tractions are periodic along x and y. This boundary is intended for
    /// nominally flat surfaces, whose free edges would sag and bias the contact.
    ///
    /// The displacement of a periodic half-space under a mean traction is undefined. In this crate it is zero, so a
    /// displacement has zero mean. The approach is the mean of the initial gap minus the mean of the gap under load.
    /// The shift is measured from the mean plane of the surface.
    Periodic,
    /// Surroundings that are periodic along y only. Beyond the ends of the grid along x the half-space is unloaded.
    /// This boundary is intended for cylinders, rollers and pads. A [line of cells](crate::Grid::line) is a line
    /// contact in plane strain with forces per length. A grid of more rows represents the same contact with roughness
    /// or texture along y. Forces then refer to one period.
    ///
    /// Under a load that is infinitely long in y, the surface moves infinitely far relative to points deep inside the
    /// body. Displacements are therefore relative to a datum. At the distance `datum` (a length) along x from a line
    /// load, the load does not move the surface. The displacement of both bodies together under a line load P per unit
    /// length is
    ///
    /// ```math
    /// u_z(x) = -\frac{2 P}{\pi E^*} \ln\frac{|x|}{d} .
    /// ```
    ///
    /// Approach and shift are relative to this datum. A different datum changes only approach and shift, by a multiple
    /// of the force. In one body, the point at the depth h below the load moves as far as the surface at the distance
    /// $`d = h \exp(-1/2(1-\nu))`$ from the load. The datum must be at least the length of the grid along x.
    ///
    /// A prescribed force has one solution for any datum. A prescribed approach or shift, and a spring, require a
    /// suitable datum. With this datum, a flat punch as wide as the grid must sink in under its load. Homogeneous
    /// bodies always satisfy this condition. Under a stiff coating the datum must be larger.
    /// [`Error::DatumTooNear`](crate::Error::DatumTooNear) reports the smallest valid datum.
    ///
    /// Source: K. L. Johnson, Contact Mechanics (1985), sections 2.2 and 5.6.
    PeriodicAlongY {
        /// Distance along x at which a line load causes no displacement (a length).
        datum: f64,
    },
}

impl Boundary {
    /// Returns whether the grid is periodic along x and along y.
    pub(crate) fn repeats(self) -> [bool; 2] {
        match self {
            Self::NonPeriodic => [false; 2],
            Self::Periodic => [true; 2],
            Self::PeriodicAlongY { .. } => [false, true],
        }
    }

    /// Returns whether the bodies can rotate about z, which a periodic gap does not allow.
    pub(crate) fn may_turn(self) -> bool {
        self.repeats() == [false; 2]
    }
}
