//! What each unknown is allowed to be.

use crate::error::{Error, Result, length};

/// The set one unknown must stay in: an interval, one per entry.
///
/// The engine asks a constraint for three things only, each of one entry: its [`bounds`], the
/// nearest point of the set ([`project`]) and the least product with a gradient over the set
/// ([`least_product`]). The last two mean the same for a disc of two components.
///
/// [`bounds`]: Constraint::bounds
/// [`project`]: Constraint::project
/// [`least_product`]: Constraint::least_product
pub trait Constraint: Sync {
    /// The number of entries the constraint is for; `None` if it fits any.
    fn entries(&self) -> Option<usize>;

    /// Lower and upper bound of an entry; either may be infinite. Equal bounds fix the entry.
    fn bounds(&self, index: usize) -> [f64; 2];

    /// The nearest allowed value.
    fn project(&self, index: usize, value: f64) -> f64 {
        let [lower, upper] = self.bounds(index);
        value.max(lower).min(upper)
    }

    /// The least product `g y` over the allowed values `y`; minus infinity if unbounded.
    fn least_product(&self, index: usize, gradient: f64) -> f64 {
        let [lower, upper] = self.bounds(index);
        if gradient > 0.0 {
            lower * gradient
        } else if gradient < 0.0 {
            upper * gradient
        } else {
            0.0
        }
    }

    /// `Ok` if the constraint fits `len` entries and leaves each a value.
    ///
    /// # Errors
    /// [`Error::Length`], or [`Error::Bounds`] at the first entry without a finite value.
    fn check(&self, len: usize) -> Result<()> {
        if let Some(own) = self.entries() {
            length("constraint", len, own)?;
        }
        for index in 0..len {
            let [lower, upper] = self.bounds(index);
            if !(lower <= upper && lower < f64::INFINITY && upper > f64::NEG_INFINITY) {
                return Err(Error::Bounds {
                    index,
                    lower,
                    upper,
                });
            }
        }
        Ok(())
    }
}

/// `x >= 0`: pressure under unilateral contact.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct NonNegative;

impl Constraint for NonNegative {
    fn entries(&self) -> Option<usize> {
        None
    }

    fn bounds(&self, _: usize) -> [f64; 2] {
        [0.0, f64::INFINITY]
    }
}

/// `|x_i| <= m_i`: shear under a friction limit of each cell.
#[derive(Debug, Clone, PartialEq)]
pub struct Magnitude<'a>(pub &'a [f64]);

impl Constraint for Magnitude<'_> {
    fn entries(&self) -> Option<usize> {
        Some(self.0.len())
    }

    fn bounds(&self, index: usize) -> [f64; 2] {
        let limit = self.0[index];
        [-limit, limit]
    }
}

/// `lower_i <= x_i <= upper_i`.
///
/// ```
/// use stickslip::cgm::{Constraint, Interval};
/// let interval = Interval { lower: &[0.0, -1.0], upper: &[f64::INFINITY, 1.0] };
/// assert_eq!(interval.project(1, 3.0), 1.0);
/// assert_eq!(interval.least_product(1, 2.0), -2.0);
/// assert!(interval.check(3).is_err());
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Interval<'a> {
    /// Lower bounds; minus infinity allowed.
    pub lower: &'a [f64],
    /// Upper bounds; infinity allowed.
    pub upper: &'a [f64],
}

impl Constraint for Interval<'_> {
    fn entries(&self) -> Option<usize> {
        // Slices of different length fit no number of entries.
        Some(if self.lower.len() == self.upper.len() {
            self.lower.len()
        } else {
            usize::MAX
        })
    }

    fn bounds(&self, index: usize) -> [f64; 2] {
        [self.lower[index], self.upper[index]]
    }
}
