//! Resting cell of a sliding contact: the middle of its path does not move.

use crate::bodies::component::Direction;
use crate::error::Result;
use crate::memory::fallible::{try_each, zeros};
use crate::numerics::small_matrix::Small;
use crate::operator::Operator;
use crate::rolling::RollingProblem;
use crate::rolling::steady::capacity::{Prescribed, SlidingMotion};

/// Number of bisections for the stiffness that keeps a traction within its limit.
const HALVINGS: usize = 100;

/// Cell whose path has a middle that does not move, and the sliding motion of the contact.
#[derive(Debug)]
pub(in crate::rolling) struct RestingCell {
    pub(in crate::rolling) cell: usize,
    pub(in crate::rolling) motion: SlidingMotion,
    /// Traction of the cell along the axes on which the prescribed sum determines it.
    traction: [Option<f64>; 2],
}

impl RollingProblem {
    /// Returns the cell whose path has a middle that does not move under a motion. Returns `None` if no such cell can carry traction.
    pub(in crate::rolling) fn resting_cell(
        &self,
        prescribed: &Prescribed,
        motion: SlidingMotion,
    ) -> Option<RestingCell> {
        let (cell, index) = self.slowest_cell(motion)?;
        let [x, y] = self.moved(motion, index);
        if !self.is_at_rest(x.hypot(y)) {
            return None;
        }
        let others = self.sums_except(cell, motion);
        let traction = [0, 1].map(|axis| prescribed.sums[axis].map(|sum| sum - others[axis]));
        let known = traction.map(|part| part.unwrap_or(0.0));
        (known[0].hypot(known[1]) <= self.pressed.limits.cells[cell]).then_some(RestingCell {
            cell,
            motion,
            traction,
        })
    }

    /// Returns the traction of a resting cell. It follows from the displacements, because large spins do not move the cell.
    ///
    /// # Errors
    /// - The errors of [`HalfSpace::operator`](crate::HalfSpace::operator).
    pub(in crate::rolling) fn traction_at_rest(
        &self,
        prescribed: &Prescribed,
        rest: &RestingCell,
    ) -> Result<[f64; 2]> {
        let (cell, limits) = (rest.cell, &self.pressed.limits.cells);
        let directions = [Direction::X, Direction::Y];
        let operator = self.bodies.compliance(directions, self.step.size)?.operator;
        let mut scratch = operator.scratch()?;
        let mut image: [Vec<f64>; 2] = try_each(|_| zeros(operator.cells()))?;
        let mut slip = |traction: &[Vec<f64>; 2]| {
            let traction = traction.each_ref().map(Vec::as_slice);
            operator.apply(
                traction,
                image.each_mut().map(Vec::as_mut_slice),
                &mut scratch,
            );
            let before = self.step.before(cell);
            [0, 1].map(|axis| image[axis][cell] - before.map_or(0.0, |before| image[axis][before]))
        };
        let mut traction: [Vec<f64>; 2] = try_each(|_| zeros(operator.cells()))?;
        for (other, index) in self.pressed.window().indices().enumerate() {
            let moved = self.moved(rest.motion, index);
            let size = moved[0].hypot(moved[1]);
            if other != cell && limits[other] > 0.0 && size > 0.0 {
                for (part, moved) in traction.iter_mut().zip(moved) {
                    part[other] = limits[other] * moved / size;
                }
            }
        }
        let others = slip(&traction);
        let given = [0, 1].map(|axis| {
            let crept = self.length * prescribed.creepage[axis];
            others[axis] + self.drawn[axis][cell] - crept
        });
        for part in &mut traction {
            part.fill(0.0);
        }
        let own = self.own[cell];
        let mut compliance = Small([[own.xx, own.xy], [own.xy, own.yy]]);
        for axis in 0..2 {
            traction[axis][cell] = 1.0;
            compliance.0[axis][axis] += slip(&traction)[axis];
            traction[axis][cell] = 0.0;
        }
        Ok(stick_or_slip(
            compliance,
            given,
            rest.traction,
            limits[cell],
        ))
    }
}

/// Returns the traction of a cell that sticks, or that slips against its traction. `given` is the slip of the cell
/// without traction, and `known` contains the components that the sums prescribe.
fn stick_or_slip(
    compliance: Small<2>,
    given: [f64; 2],
    known: [Option<f64>; 2],
    limit: f64,
) -> [f64; 2] {
    let held = known.map(|part| part.unwrap_or(0.0));
    let is_free = known.map(|part| part.is_none());
    let size = held[0].hypot(held[1]);
    // The squares of the limits can overflow or underflow, so the root of each factor is taken.
    let room = (limit - size).max(0.0).sqrt() * (limit + size).sqrt();
    let pushed = [0, 1].map(|axis| {
        let [x, y] = compliance.0[axis];
        -given[axis] - x * held[0] - y * held[1]
    });
    // An additional stiffness keeps the traction within its limit.
    let at = |resistance: f64| {
        let mut matrix = compliance;
        matrix.0[0][0] += resistance;
        matrix.0[1][1] += resistance;
        matrix.solve(pushed, is_free)
    };
    let is_within = |[x, y]: [f64; 2]| x.hypot(y) <= room;
    let mut free = at(0.0);
    if !is_within(free) {
        let (mut low, mut high) = (0.0, pushed[0].hypot(pushed[1]) / room);
        for _ in 0..HALVINGS {
            let middle = 0.5 * (low + high);
            if is_within(at(middle)) {
                high = middle;
            } else {
                low = middle;
            }
        }
        free = if room > 0.0 { at(high) } else { [0.0; 2] };
    }
    [0, 1].map(|axis| known[axis].unwrap_or(free[axis]))
}

#[cfg(test)]
mod tests {
    use super::*;

    const COMPLIANCE: Small<2> = Small([[2.0, 0.5], [0.5, 1.0]]);

    #[test]
    fn small_push_sticks() {
        let [x, y] = stick_or_slip(COMPLIANCE, [-1.0, 0.2], [None; 2], 3.0);
        assert!((2.0 * x + 0.5 * y - 1.0).abs() < 1e-14);
        assert!((0.5 * x + y + 0.2).abs() < 1e-14);
    }

    #[test]
    fn large_push_slips_against_traction_at_limit() {
        let q = stick_or_slip(COMPLIANCE, [-10.0, 4.0], [None; 2], 3.0);
        assert!((q[0].hypot(q[1]) - 3.0).abs() < 1e-12);
        let slip = [2.0 * q[0] + 0.5 * q[1] - 10.0, 0.5 * q[0] + q[1] + 4.0];
        assert!((q[0] * slip[1] - q[1] * slip[0]).abs() < 1e-11);
        assert!(q[0] * slip[0] + q[1] * slip[1] < 0.0);
    }

    #[test]
    fn known_part_leaves_less_to_the_other() {
        let q = stick_or_slip(COMPLIANCE, [0.0, -10.0], [Some(1.8), None], 3.0);
        assert!((q[0] - 1.8).abs() < 1e-15 && (q[1] - 2.4).abs() < 1e-12);
        let q = stick_or_slip(COMPLIANCE, [0.0, -1.0], [Some(1.8), None], 3.0);
        assert!((0.5 * q[0] + q[1] - 1.0).abs() < 1e-14);
    }
}
