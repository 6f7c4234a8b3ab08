//! Intervals: one unknown per cell between two bounds, with the updates of the primal-dual active-set method.

use crate::cgm::law::state::{LinearisedSet, Row, TotalFeasibility};
use crate::cgm::{Constraint, ConstraintSet, reduce};
use crate::error::{Error, Result};
use crate::numerics::cell_vector::update_cells;
use crate::parallel::layout::Layout;

/// The interval from `lower` to `upper`. Equal bounds fix the cell.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Interval {
    /// Lower bound, finite or minus infinity.
    pub lower: f64,
    /// Upper bound, finite or infinity.
    pub upper: f64,
}

/// State of a cell in its interval.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum IntervalMotion {
    /// Between the bounds, or released from a bound.
    Free,
    /// Fixed at the lower bound.
    Lower,
    /// Fixed at the upper bound.
    Upper,
    /// Fixed by equal bounds.
    Fixed,
}

impl Row<1> for IntervalMotion {
    const IS_CURVED: bool = false;
    const FREE: Self = Self::Free;
    const FIXED: Self = Self::Fixed;

    #[inline]
    fn moves(self) -> bool {
        self == Self::Free
    }

    fn is_free(self) -> bool {
        self == Self::Free
    }

    fn released_from_bound(self, [g]: [f64; 1]) -> Self {
        match self {
            Self::Lower if g < 0.0 => Self::Free,
            Self::Upper if g > 0.0 => Self::Free,
            other => other,
        }
    }
}

impl ConstraintSet<1> for Interval {
    #[inline]
    fn project(self, [x]: [f64; 1]) -> [f64; 1] {
        // Unlike `max` and `min`, each selection is one instruction. NaN becomes the lower bound.
        let raised = if x > self.lower { x } else { self.lower };
        [if raised < self.upper {
            raised
        } else {
            self.upper
        }]
    }
}

impl LinearisedSet<1> for Interval {
    type CellMotion = IntervalMotion;

    fn check(self, index: usize) -> Result<()> {
        let Self { lower, upper } = self;
        if lower <= upper && lower < f64::INFINITY && upper > f64::NEG_INFINITY {
            return Ok(());
        }
        Err(Error::Bounds {
            index,
            lower,
            upper,
        })
    }

    #[inline]
    fn can_move(self) -> bool {
        self.lower < self.upper
    }

    #[inline]
    fn is_inside(self, [x]: [f64; 1]) -> bool {
        x > self.lower && x < self.upper
    }

    #[inline]
    fn forbidden(self, [x]: [f64; 1], [g]: [f64; 1]) -> [f64; 1] {
        // Points of equal bounds satisfy one of these conditions for every number, and no comparison with NaN is true.
        let is_allowed = (x <= self.lower && g >= 0.0) || (x >= self.upper && g <= 0.0);
        [if is_allowed { 0.0 } else { g }]
    }

    #[inline]
    fn duality_gap(self, [x]: [f64; 1], [g]: [f64; 1]) -> f64 {
        // Near the solution the signs of the gradients alternate irregularly, so selecting a value costs less than a
        // branch.
        let bound = if g > 0.0 { self.lower } else { self.upper };
        let least = if g == 0.0 { 0.0 } else { bound * g };
        g * x - least
    }

    #[inline]
    fn excess(self, x: [f64; 1]) -> f64 {
        (self.project(x)[0] - x[0]).abs()
    }

    fn extreme(self, [direction]: [f64; 1]) -> [f64; 1] {
        [if direction < 0.0 {
            self.lower
        } else {
            self.upper
        }]
    }

    fn arrive(self, [x]: [f64; 1], [d]: [f64; 1]) -> [f64; 1] {
        let (next, noise) = (x + d, 2.0 * f64::EPSILON * (x.abs() + d.abs()));
        [if next <= self.lower + noise {
            self.lower
        } else if next >= self.upper - noise {
            self.upper
        } else {
            next
        }]
    }

    #[inline]
    fn motion(self, [x]: [f64; 1]) -> IntervalMotion {
        if self.lower >= self.upper {
            IntervalMotion::Fixed
        } else if x <= self.lower {
            IntervalMotion::Lower
        } else if x >= self.upper {
            IntervalMotion::Upper
        } else {
            IntervalMotion::Free
        }
    }

    #[inline]
    fn next(
        self,
        was: IntervalMotion,
        [x]: [f64; 1],
        [g]: [f64; 1],
        noise: f64,
        _: [f64; 2],
    ) -> (IntervalMotion, [f64; 1]) {
        let next = match was {
            IntervalMotion::Free if x < self.lower => IntervalMotion::Lower,
            IntervalMotion::Free if x > self.upper => IntervalMotion::Upper,
            IntervalMotion::Lower if g < -noise => IntervalMotion::Free,
            IntervalMotion::Upper if g > noise => IntervalMotion::Free,
            other => other,
        };
        (next, self.project([x]))
    }

    fn reach(
        layout: &Layout,
        constraint: &impl Constraint<1, Set = Self>,
        [sum]: [Option<f64>; 1],
    ) -> Result<TotalFeasibility<1>> {
        let Some(total) = sum else {
            return Ok(TotalFeasibility::Inside);
        };
        let [lower, upper, lower_size, upper_size] = reduce::sum(layout, |i| {
            let Self { lower, upper } = constraint.of(i);
            [lower, upper, lower.abs(), upper.abs()]
        });
        // The margin covers the round-off of the two sums. An infinite bound is never reached.
        let edge = |size: f64| if size.is_finite() { EDGE * size } else { 0.0 };
        let (low_edge, high_edge) = (edge(lower_size), edge(upper_size));
        if !total.is_finite() || total < lower - low_edge || total > upper + high_edge {
            Err(Error::Total {
                total,
                lower,
                upper,
            })
        } else if total <= lower + low_edge {
            Ok(TotalFeasibility::Extreme([-1.0]))
        } else if total >= upper - high_edge {
            Ok(TotalFeasibility::Extreme([1.0]))
        } else {
            Ok(TotalFeasibility::Inside)
        }
    }

    fn restore(
        layout: &Layout,
        [x]: [&mut [f64]; 1],
        constraint: &impl Constraint<1, Set = Self>,
        preferred: impl Fn(usize) -> bool + Sync,
        [sum]: [Option<f64>; 1],
    ) -> bool {
        let Some(total) = sum else { return true };
        let suffices = shift_to_total(layout, x, constraint, preferred, total);
        if !suffices {
            shift_to_total(layout, x, constraint, |_| true, total);
        }
        suffices
    }
}

/// Relative distance from an extreme total within which a total counts as the extreme.
pub(in crate::cgm) const EDGE: f64 = 1e-12;

/// Moves the selected cells to the nearest points of their intervals at which the total is met. The new values are
/// `x_i = P_i(x_i + t)` with the same `t` for all cells. Returns whether the total was reached.
fn shift_to_total(
    layout: &Layout,
    x: &mut [f64],
    constraint: &impl Constraint<1, Set = Interval>,
    selected: impl Fn(usize) -> bool + Sync,
    total: f64,
) -> bool {
    // If the shift `t` is much larger than the resulting values, these values lose their accuracy to round-off. A second pass
    // needs only a small shift and restores the accuracy.
    (0..2).any(|_| shift(layout, x, constraint, &selected, total))
}

/// Performs one shift. The total is piecewise linear and non-decreasing in `t`, so Newton's method with bracketing ends after a
/// few passes.
fn shift(
    layout: &Layout,
    x: &mut [f64],
    constraint: &impl Constraint<1, Set = Interval>,
    selected: impl Fn(usize) -> bool + Sync,
    total: f64,
) -> bool {
    let (mut low, mut high) = (f64::NEG_INFINITY, f64::INFINITY);
    let mut shift = 0.0;
    for _ in 0..200 {
        let [sum, moving, magnitude, may_rise, may_fall] = reduce::sum(layout, |i| {
            if !selected(i) {
                return [x[i], 0.0, x[i].abs(), 0.0, 0.0];
            }
            let interval = constraint.of(i);
            let [value] = interval.project([x[i] + shift]);
            let one_if = |condition: bool| f64::from(u8::from(condition));
            let is_moving = interval.is_inside([value]);
            let (rises, falls) = (
                one_if(value < interval.upper),
                one_if(value > interval.lower),
            );
            [value, one_if(is_moving), value.abs(), rises, falls]
        });
        let missing = total - sum;
        let has_room = if missing > 0.0 { may_rise } else { may_fall };
        if missing.abs() <= 1e-14 * magnitude || has_room == 0.0 {
            break;
        }
        if missing > 0.0 {
            low = shift;
        } else {
            high = shift;
        }
        let newton = shift + missing / moving;
        let next = if newton > low && newton < high {
            newton
        } else if low.is_finite() && high.is_finite() {
            0.5 * (low + high)
        } else {
            // No cell moves and one side of the bracket is open: increase the step until a cell moves.
            let step = magnitude.max(missing.abs()).max(shift.abs());
            shift + step.copysign(missing)
        };
        if !next.is_finite() || (next - shift).abs() <= f64::EPSILON * shift.abs() {
            break;
        }
        shift = next;
    }
    update_cells(&mut [&mut *x], |i, [value]| {
        if selected(i) {
            constraint.of(i).project([value + shift])
        } else {
            [value]
        }
    });
    let [sum, magnitude] = reduce::sum(layout, |i| [x[i], x[i].abs()]);
    (total - sum).abs() <= 1e-12 * magnitude
}
