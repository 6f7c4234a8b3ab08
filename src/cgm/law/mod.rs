//! Constraints of the minimisation: the closed convex set of values that each cell may take.

pub(super) mod disc;
pub(super) mod disc_motion;
pub(super) mod interval;
pub(super) mod state;

use crate::cgm::law::state::LinearisedSet;
use crate::cgm::{Disc, Interval};
use crate::error::{Result, length};
use crate::grid::per_cell::PerCell;

/// The sets of all cells: one closed convex set per cell, of a type that implements [`ConstraintSet`].
///
/// The solver requires that [`of`](Self::of) returns the same set at every call. `N` is the number of components per cell, one by
/// default.
///
/// ```
/// use stickslip::cgm::{self, Constraint, Interval, Problem, Settings};
/// use stickslip::Identity;
///
/// /// Cell `i` may carry `-i` to `i`.
/// struct Growing;
///
/// impl Constraint for Growing {
///     type Set = Interval;
///     fn of(&self, cell: usize) -> Interval {
///         Interval { lower: -(cell as f64), upper: cell as f64 }
///     }
/// }
///
/// let linear = [-5.0; 3];
/// let problem = Problem::new(Identity::new(3), [&linear], Growing);
/// let mut x = [0.0; 3];
/// cgm::minimise(&problem, &Settings::default(), [&mut x])?;
/// assert_eq!(x, [0.0, 1.0, 2.0]);
/// # Ok::<(), stickslip::Error>(())
/// ```
pub trait Constraint<const N: usize = 1>: Sync {
    /// Type of the set of a cell.
    type Set: ConstraintSet<N>;

    /// Returns the number of cells of the constraint, or `None` (the default) if the constraint fits any number of
    /// cells.
    fn cells(&self) -> Option<usize> {
        None
    }

    /// Returns the set of a cell.
    fn of(&self, cell: usize) -> Self::Set;
}

/// A closed convex set: an [`Interval`] for one component, a [`Disc`] for two components.
///
/// The trait is sealed because the solver linearises each type of set in a different way.
#[expect(private_bounds, reason = "the bound seals the trait")]
pub trait ConstraintSet<const N: usize>: LinearisedSet<N> {
    /// Returns the nearest point of the set.
    #[must_use]
    fn project(self, x: [f64; N]) -> [f64; N];
}

/// Checks that a constraint fits this number of cells and that no set is empty.
pub(crate) fn check<const N: usize>(constraint: &impl Constraint<N>, cells: usize) -> Result<()> {
    if let Some(own) = constraint.cells() {
        length("constraint", cells, own)?;
    }
    (0..cells).try_for_each(|cell| constraint.of(cell).check(cell))
}

/// `x >= 0`: pressure under unilateral contact.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct NonNegative;

impl Constraint for NonNegative {
    type Set = Interval;

    #[inline]
    fn of(&self, _: usize) -> Interval {
        Interval {
            lower: 0.0,
            upper: f64::INFINITY,
        }
    }
}

/// `0 <= p <= H`, with a finite or an infinite limit `H`.
#[derive(Debug, Clone, Copy)]
pub(crate) struct BoundedPressure<'a>(pub(crate) PerCell<&'a [f64]>);

impl Constraint for BoundedPressure<'_> {
    type Set = Interval;

    fn cells(&self) -> Option<usize> {
        match self.0 {
            PerCell::Uniform(_) => None,
            PerCell::Cells(cells) => Some(cells.len()),
        }
    }

    #[inline]
    fn of(&self, cell: usize) -> Interval {
        Interval {
            lower: 0.0,
            upper: self.0.of(cell),
        }
    }
}

/// Hardness of cells whose pressure is unlimited.
pub(crate) const UNLIMITED: PerCell<&[f64]> = PerCell::Uniform(f64::INFINITY);

/// The bounds `lower_i <= x_i <= upper_i`.
///
/// ```
/// use stickslip::cgm::{ConstraintSet, Bounds, Constraint};
/// let bounds = Bounds { lower: &[0.0, -1.0], upper: &[f64::INFINITY, 1.0] };
/// assert_eq!(bounds.of(1).project([3.0]), [1.0]);
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Bounds<'a> {
    /// Lower bounds, each finite or minus infinity.
    pub lower: &'a [f64],
    /// Upper bounds, each finite or infinity.
    pub upper: &'a [f64],
}

impl Constraint for Bounds<'_> {
    type Set = Interval;

    fn cells(&self) -> Option<usize> {
        // Slices of different lengths do not fit any number of cells.
        Some(if self.lower.len() == self.upper.len() {
            self.lower.len()
        } else {
            usize::MAX
        })
    }

    #[inline]
    fn of(&self, cell: usize) -> Interval {
        Interval {
            lower: self.lower[cell],
            upper: self.upper[cell],
        }
    }
}

/// The limits `|x_i| <= m_i`, for a traction within the friction limit of each cell. The traction is along an axis (`N = 1`) or
/// in the plane (`N = 2`). In the plane, `|x_i|` is the length of the vector.
///
/// ```
/// use stickslip::cgm::{self, AbsBound, Problem, Settings};
/// use stickslip::Identity;
///
/// // The points of two discs nearest to (3, 4).
/// let (x, y) = ([-3.0; 2], [-4.0; 2]);
/// let problem = Problem::new(Identity::new(2), [&x, &y], AbsBound(&[10.0, 1.0]));
/// let (mut qx, mut qy) = ([0.0; 2], [0.0; 2]);
/// cgm::minimise(&problem, &Settings::default(), [&mut qx, &mut qy])?;
/// assert!((qx[0] - 3.0).abs() < 1e-8 && (qy[0] - 4.0).abs() < 1e-8);
/// assert!((qx[1] - 0.6).abs() < 1e-8 && (qy[1] - 0.8).abs() < 1e-8);
/// # Ok::<(), stickslip::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct AbsBound<'a>(pub &'a [f64]);

impl<const N: usize> Constraint<N> for AbsBound<'_>
where
    NormBound: Ball<N>,
{
    type Set = <NormBound as Ball<N>>::Set;

    fn cells(&self) -> Option<usize> {
        Some(self.0.len())
    }

    #[inline]
    fn of(&self, cell: usize) -> Self::Set {
        NormBound::of_radius(self.0[cell])
    }
}

/// Set of the vectors within a radius, which [`Ball`] defines for each number of components.
#[derive(Debug, Clone, Copy)]
pub struct NormBound;

/// The set of all vectors of `N` components whose length is at most a radius.
pub trait Ball<const N: usize> {
    /// Type of the set: [`Interval`] for one component, [`Disc`] for two.
    type Set: ConstraintSet<N>;

    /// Returns the ball with this radius.
    fn of_radius(radius: f64) -> Self::Set;
}

impl Ball<1> for NormBound {
    type Set = Interval;

    #[inline]
    fn of_radius(radius: f64) -> Interval {
        Interval {
            lower: -radius,
            upper: radius,
        }
    }
}

impl Ball<2> for NormBound {
    type Set = Disc;

    #[inline]
    fn of_radius(radius: f64) -> Disc {
        Disc { radius }
    }
}
