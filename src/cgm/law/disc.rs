//! Discs, with the updates of the semismooth Newton method. The two unknowns of a cell are a vector whose length is at most a
//! limit.
//!
//! A cell at its limit keeps one unknown, the angle of its traction `q`. Let `g = C q + b - delta` be the gradient (the slip).
//! Let $`t`$ be the tangent and $`n = q/m`$ the outward normal of the circle. The derivative of the condition $`t \cdot g = 0`$
//! is
//!
//! ```math
//! t' \frac{\partial g}{\partial q}\, t - \frac{n \cdot g}{m} ,
//! ```
//!
//! the stiffness of the operator along the circle plus $`|g|/m`$. The second term results from the rotation of the tangent with
//! the traction. Without this term, iterations of clipped gradients stall (Zhao, Vollebregt & Oosterlee, report 14-02 of the
//! Delft Institute of Applied Mathematics, 2014).

use crate::cgm::law::disc_motion::DiscMotion;
use crate::cgm::law::interval::EDGE;
use crate::cgm::law::state::{LinearisedSet, Row, TotalFeasibility};
use crate::cgm::{Constraint, ConstraintSet, reduce};
use crate::error::{Error, Result, SLIDE, non_negative};
use crate::numerics::cell_vector::{at, dot, norm, plus, slices, update_cells};
use crate::numerics::small_matrix::Small;
use crate::parallel::layout::Layout;

/// Vectors whose length is at most `radius`. The radius must be finite and not negative. A zero radius fixes the cell.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Disc {
    /// Maximum length.
    pub radius: f64,
}

/// Relative distance from the circle within which a traction counts as on the circle.
const RIM: f64 = 1e-12;

impl Disc {
    /// Returns whether a vector is at the limit.
    pub(crate) fn is_at_limit(self, q: [f64; 2]) -> bool {
        norm(q) >= self.radius * (1.0 - RIM)
    }

    /// Returns the vector of maximum length in the direction of `q`, which must not be zero.
    pub(crate) fn rim_along(self, q: [f64; 2]) -> [f64; 2] {
        let scale = self.radius / norm(q);
        q.map(|q| q * scale)
    }
}

impl ConstraintSet<2> for Disc {
    #[inline]
    fn project(self, q: [f64; 2]) -> [f64; 2] {
        let size = norm(q);
        if size > self.radius {
            q.map(|q| q * (self.radius / size))
        } else {
            q
        }
    }
}

impl LinearisedSet<2> for Disc {
    type CellMotion = DiscMotion;

    fn check(self, _: usize) -> Result<()> {
        non_negative("radius of a disc", self.radius).map(|_| ())
    }

    #[inline]
    fn can_move(self) -> bool {
        self.radius > 0.0
    }

    #[inline]
    fn is_inside(self, q: [f64; 2]) -> bool {
        !self.is_at_limit(q)
    }

    #[inline]
    fn forbidden(self, q: [f64; 2], g: [f64; 2]) -> [f64; 2] {
        if self.radius <= 0.0 {
            [0.0; 2]
        } else if dot(g, q) < 0.0 && self.is_at_limit(q) {
            let across = (g[0] * q[1] - g[1] * q[0]) / dot(q, q);
            [across * q[1], -across * q[0]]
        } else {
            g
        }
    }

    #[inline]
    fn duality_gap(self, q: [f64; 2], g: [f64; 2]) -> f64 {
        let (size, slip) = (norm(q), norm(g));
        let (along, across) = (dot(g, q), g[0] * q[1] - g[1] * q[0]);
        // This form of `g.q + |g| |q|` is accurate to round-off if the two vectors are opposite, as in every slipping cell.
        let turned = if along < 0.0 {
            across * across / (slip * size - along)
        } else {
            slip * size + along
        };
        slip * (self.radius - size).max(0.0) + turned
    }

    fn excess(self, q: [f64; 2]) -> f64 {
        // A vector scaled to its circle may lie outside by a rounding error.
        (norm(q) - self.radius - 4.0 * f64::EPSILON * self.radius).max(0.0)
    }

    fn extreme(self, direction: [f64; 2]) -> [f64; 2] {
        direction.map(|n| n * self.radius)
    }

    fn arrive(self, q: [f64; 2], d: [f64; 2]) -> [f64; 2] {
        plus(q, 1.0, d)
    }

    #[inline]
    fn motion(self, q: [f64; 2]) -> DiscMotion {
        if self.radius <= 0.0 {
            DiscMotion::Fixed
        } else if self.is_at_limit(q) {
            DiscMotion::along(q, 0.0)
        } else {
            DiscMotion::Free
        }
    }

    #[inline]
    fn measured(self, mut motion: DiscMotion, g: [f64; 2]) -> DiscMotion {
        if let DiscMotion::Tangential {
            tangent, stiffness, ..
        } = &mut motion
        {
            let outwards = [tangent[1], -tangent[0]];
            *stiffness = (-dot(g, outwards)).max(0.0) / self.radius;
        }
        motion
    }

    #[inline]
    fn next(
        self,
        was: DiscMotion,
        q: [f64; 2],
        g: [f64; 2],
        noise: f64,
        [self_compliance, diagonal]: [f64; 2],
    ) -> (DiscMotion, [f64; 2]) {
        let size = norm(q);
        match was {
            DiscMotion::Fixed => (was, self.project(q)),
            DiscMotion::Free if size <= self.radius => (was, self.project(q)),
            // A cell that starts to slip receives a stiffness as if its own compliance alone carried the excess over the limit.
            // Without this stiffness, distributing a total before the slip is measured could reverse the traction of the cell.
            DiscMotion::Free => {
                let excess = self_compliance * (1.0 - self.radius / size);
                let held = self.measured(DiscMotion::along(q, 0.0), q.map(|q| -excess * q));
                (
                    held.with_preconditioner_weight(self_compliance, diagonal),
                    self.rim_along(q),
                )
            }
            DiscMotion::Tangential { .. } if dot(g, q) > noise * size => {
                (DiscMotion::Free, self.project(q))
            }
            DiscMotion::Tangential { stiffness, .. } => {
                let turned = DiscMotion::along(q, stiffness)
                    .with_preconditioner_weight(self_compliance, diagonal);
                (turned, self.rim_along(q))
            }
        }
    }

    fn reach(
        layout: &Layout,
        constraint: &impl Constraint<2, Set = Self>,
        sums: [Option<f64>; 2],
    ) -> Result<TotalFeasibility<2>> {
        let limit = reduce::total_of(layout, |i| constraint.of(i).radius);
        let total = sums.map(|sum| sum.unwrap_or(0.0));
        let size = norm(total);
        if size.is_nan() || size > limit * (1.0 + EDGE) {
            return Err(Error::BeyondFrictionCapacity {
                force: size,
                limit,
                remedy: SLIDE,
            });
        }
        Ok(if size > 0.0 && size >= limit * (1.0 - EDGE) {
            TotalFeasibility::Extreme(total.map(|total| total / size))
        } else {
            TotalFeasibility::Inside
        })
    }

    /// Cells at their limits are not moved if the other cells suffice. A cell that is moved slightly off its circle would count
    /// as sticking.
    fn restore(
        layout: &Layout,
        mut q: [&mut [f64]; 2],
        constraint: &impl Constraint<2, Set = Self>,
        preferred: impl Fn(usize) -> bool + Sync,
        sums: [Option<f64>; 2],
    ) -> bool {
        let old = slices(&q);
        let inside = |i: usize, q| preferred(i) || !constraint.of(i).is_at_limit(q);
        let (mut shift, suffices) = shift_to_sums(layout, &old, constraint, sums, inside);
        if !suffices {
            (shift, _) = shift_to_sums(layout, &old, constraint, sums, |_, _| true);
        }
        update_cells(&mut q, |i, q| {
            let shift = if suffices && !inside(i, q) {
                [0.0; 2]
            } else {
                shift
            };
            constraint.of(i).project(plus(q, 1.0, shift))
        });
        // Every cell keeps its previous motion.
        true
    }
}

/// Returns the shift `t` that moves the selected cells to `P_i(q_i + t)` such that all cells together have the sums. Also returns
/// whether the sums are met, because the selected cells might not suffice. The sums are the gradient of a convex function of `t`.
/// The method is a damped Newton iteration.
fn shift_to_sums(
    layout: &Layout,
    q: &[&[f64]; 2],
    constraint: &impl Constraint<2, Set = Disc>,
    sums: [Option<f64>; 2],
    selected: impl Fn(usize, [f64; 2]) -> bool + Sync,
) -> ([f64; 2], bool) {
    let moved = |t: [f64; 2]| shifted(layout, q, constraint, sums, &selected, t);
    let mut t = [0.0; 2];
    if sums == [None, None] {
        return (t, true);
    }
    let mut best = moved(t);
    for _ in 0..100 {
        if norm(best.missing) <= 1e-14 * best.size {
            break;
        }
        let step = best.step(sums);
        // Halve the step until the deficit of the sums decreases.
        let parts = std::iter::successors(Some(1.0), |part| Some(0.5 * part));
        let nearer = parts.take_while(|part| *part >= 1e-9).find_map(|part| {
            let next = plus(t, part, step);
            let found = moved(next);
            (norm(found.missing) < norm(best.missing)).then_some((next, found))
        });
        match nearer {
            Some(found) => (t, best) = found,
            None => break,
        }
    }
    (t, norm(best.missing) <= 1e-12 * best.size)
}

/// Sums after shifting the selected vectors by the same amount and projecting them.
struct ShiftedSums {
    /// Deficit of the prescribed sums.
    missing: [f64; 2],
    /// Derivative of the sums with respect to the shift.
    slope: Small<2>,
    /// Sum of the lengths.
    size: f64,
}

fn shifted(
    layout: &Layout,
    q: &[&[f64]; 2],
    constraint: &impl Constraint<2, Set = Disc>,
    sums: [Option<f64>; 2],
    selected: impl Fn(usize, [f64; 2]) -> bool + Sync,
    t: [f64; 2],
) -> ShiftedSums {
    let (found, slope, size) = reduce::sum(layout, |i| {
        let held = at(q, i);
        if !selected(i, held) {
            return (held, [[0.0; 2]; 2], norm(held));
        }
        let moved = plus(held, 1.0, t);
        let (disc, length) = (constraint.of(i), norm(moved));
        let nearest = disc.project(moved);
        // Outside the circle, the derivative of the projection is the tangential part, scaled by the radius over the length.
        let slope = if disc.radius <= 0.0 {
            [[0.0; 2]; 2]
        } else if length > disc.radius {
            let [nx, ny] = moved.map(|q| q / length);
            let shrunk = disc.radius / length;
            let across = -nx * ny * shrunk;
            [[ny * ny * shrunk, across], [across, nx * nx * shrunk]]
        } else {
            [[1.0, 0.0], [0.0, 1.0]]
        };
        (nearest, slope, norm(nearest))
    });
    ShiftedSums {
        missing: [0, 1].map(|c| sums[c].map_or(0.0, |sum| sum - found[c])),
        slope: Small(slope),
        size,
    }
}

impl ShiftedSums {
    /// Returns the Newton step in the components whose sum is prescribed.
    fn step(&self, sums: [Option<f64>; 2]) -> [f64; 2] {
        let prescribed = sums.map(|sum| sum.is_some());
        let trace = self.slope.trace();
        if self.slope.least(prescribed) > f64::EPSILON * trace {
            self.slope.solve(self.missing, prescribed)
        } else {
            self.missing
                .map(|missing| missing / trace.max(f64::MIN_POSITIVE))
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cgm::AbsBound;

    /// Restores the sums of three cells with limit one. Two of the cells are at their limits, as at the end of a solve.
    fn restored(sums: [f64; 2]) -> [[f64; 3]; 2] {
        let [mut x, mut y] = [[1.0, 0.0, 0.2], [0.0, 1.0, 0.3]];
        let layout = Layout::of([3, 1]);
        let limits = AbsBound(&[1.0; 3]);
        Disc::restore(
            &layout,
            [&mut x, &mut y],
            &limits,
            |_| false,
            sums.map(Some),
        );
        [x, y]
    }

    #[test]
    fn cells_at_their_limits_stay_there_if_others_suffice() {
        let [x, y] = restored([1.1, 1.4]);
        assert!(x[..2] == [1.0, 0.0] && y[..2] == [0.0, 1.0]);
        assert!((x[2] - 0.1).abs() < 1e-12 && (y[2] - 0.4).abs() < 1e-12);
    }

    #[test]
    fn all_cells_move_where_they_must() {
        let sums = [-0.5, 0.5];
        let found = restored(sums);
        for (part, sum) in found.iter().zip(sums) {
            assert!((part.iter().sum::<f64>() - sum).abs() < 1e-12);
        }
        assert!(found[0][0] < 0.9);
    }
}
