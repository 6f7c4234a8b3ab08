//! The range of moments that spins of any size can cause.

use std::iter::successors;

use crate::error::{Error, Result, finite};
use crate::numerics::cell_vector::dot;
use crate::parallel::reduce;
use crate::rolling::{RollingControl, RollingProblem};
use crate::tangential::{SLIDING, centre};

/// Maximum number of Newton steps, and maximum number of halvings of each step. The result is a bound after any number
/// of steps.
const STEPS: usize = 60;
/// Successive rounding lengths for the kinks of the bound, as fractions of the mean lever of the limits.
const ROUNDINGS: [f64; 6] = [1e-1, 1e-3, 1e-5, 1e-7, 1e-9, 1e-11];
/// Sum of the tractions, relative to the sum of the limits, that counts as zero.
const BALANCED: f64 = 1e-13;
/// Fraction of the expected decrease that a Newton step must achieve.
const DECREASE: f64 = 1e-4;
/// Motion of a path per unit rotation, relative to the shorter side of a cell, that counts as rest.
const AT_REST: f64 = 1e-9;

/// Width of the range of moments, relative to the integral of the limits times their distances, that counts as zero. In a
/// narrower range round-off would dominate.
const NARROW: f64 = 1e-8;

/// Tractions of the magnitude of their limits m in the direction of $`v = t + c`$. Here t is the motion due to a
/// rotation, and c is the motion due to a shift. The length of v is rounded to $`\sqrt{v^2 + \epsilon^2}`$.
#[derive(Debug, Default)]
pub(in crate::rolling) struct Sliding {
    /// Sum of m times the rounded length.
    bound: f64,
    /// Sums of the tractions.
    pub(in crate::rolling) sums: [f64; 2],
    /// Derivatives of the sums with respect to c: `[xx, xy, yy]`.
    stiffness: [f64; 3],
}

/// Motion of a contact in which all cells slide: a rotation about the origin and a shift.
#[derive(Debug, Clone, Copy)]
pub(in crate::rolling) struct SlidingMotion {
    pub(in crate::rolling) turn: f64,
    pub(in crate::rolling) shift: [f64; 2],
}

/// Prescribed sums of tractions or creepages along both axes.
#[derive(Debug, Clone, Copy)]
pub(in crate::rolling) struct Prescribed {
    /// Sums of the tractions along the axes with a prescribed force.
    pub(in crate::rolling) sums: [Option<f64>; 2],
    /// Creepages, with zero along an axis with a prescribed force.
    pub(in crate::rolling) creepage: [f64; 2],
}

impl Prescribed {
    pub(in crate::rolling) fn of(controls: [RollingControl; 2], cell_area: f64) -> Self {
        Self {
            sums: controls.map(|control| match control {
                RollingControl::Force(force) => Some(force / cell_area),
                RollingControl::Creepage(_) => None,
            }),
            creepage: controls.map(|control| match control {
                RollingControl::Force(_) => 0.0,
                RollingControl::Creepage(creepage) => creepage,
            }),
        }
    }

    /// Returns the work of the prescribed sums on a shift.
    fn work(&self, shift: [f64; 2]) -> f64 {
        dot(shift, self.sums.map(|sum| sum.unwrap_or(0.0)))
    }
}

impl RollingProblem {
    /// Returns the limits of the moment about the origin of the grid as the spin tends to minus and plus infinity. The
    /// moment is continuous in the spin, so a spin exists for each moment between these limits.
    ///
    /// At a large spin each traction is at its limit m along the motion of the middle of its path. The exception is a cell whose
    /// path has a middle without motion. Let f be the sums, along some axes, of tractions within their limits. Then
    /// $`\sum q \cdot t \le \sum m |t + c| - c \cdot f`$ for every shift c along these axes. The smallest of these bounds is the
    /// moment about the middles of the paths when the whole contact slides.
    ///
    /// # Errors
    /// - The errors of [`HalfSpace::operator`](crate::HalfSpace::operator) if the middle of a path is at rest.
    pub(in crate::rolling) fn moment_ends(
        &self,
        controls: [RollingControl; 2],
    ) -> Result<[f64; 2]> {
        let area = self.bodies.grid().cell_area();
        let prescribed = Prescribed::of(controls, area);
        let mut ends = [0.0; 2];
        for (end, sign) in ends.iter_mut().zip([-1.0, 1.0]) {
            *end = area * self.moment_of_sliding(&prescribed, sign)?;
        }
        Ok(ends)
    }

    /// Checks that a moment is between the moments of large spins of both signs.
    pub(in crate::rolling) fn check_moment(
        &self,
        controls: [RollingControl; 2],
        moment: f64,
    ) -> Result<()> {
        let ends = self.moment_ends(controls)?;
        for end in ends {
            finite("moment that friction can carry", end)?;
        }
        let range = [ends[0].min(ends[1]), ends[0].max(ends[1])];
        let margin = SLIDING * ends[0].abs().max(ends[1].abs());
        let is_point = range[1] - range[0] <= NARROW * self.moment_scale();
        if moment >= range[1] - margin || is_point && moment >= 0.5 * (range[0] + range[1]) {
            return Err(Error::BeyondFrictionMoment {
                moment,
                limit: range[1],
                range,
            });
        }
        if moment <= range[0] + margin || is_point {
            return Err(Error::BeyondFrictionMoment {
                moment,
                limit: range[0],
                range,
            });
        }
        Ok(())
    }

    /// Returns the integral of the limits times the sum of the distance from the origin and half a path. This integral
    /// bounds all moments.
    fn moment_scale(&self) -> f64 {
        let (window, limits) = (self.pressed.window(), &self.pressed.limits.cells);
        let sum = reduce::sum(self.pressed.region.layout(), |cell| {
            let [x, y] = centre(self.bodies.grid(), window.index(cell));
            limits[cell] * (x.hypot(y) + 0.5 * self.length)
        });
        sum * self.bodies.grid().cell_area()
    }

    /// Returns the limit of the moment for large spins of the given sign, divided by the cell area.
    fn moment_of_sliding(&self, prescribed: &Prescribed, sign: f64) -> Result<f64> {
        let turn = SlidingMotion {
            turn: sign,
            shift: [0.0; 2],
        };
        let motion = self.shifted(turn, prescribed);
        let about_middles = self.sliding(motion, 0.0).bound - prescribed.work(motion.shift);
        let across = self.axis_across();
        let sum = match prescribed.sums[across] {
            Some(sum) => sum,
            None => self.sum_across(prescribed, motion)?,
        };
        // Only this sum distinguishes the moments about the middles of paths from the moments about the cell centres.
        let [x, y] = self.halfway();
        let lever = if across == 1 { x } else { -y };
        Ok(sign * about_middles - lever * sum)
    }

    /// Returns the sum of the tractions across the rolling direction if no force is prescribed across it.
    fn sum_across(&self, prescribed: &Prescribed, motion: SlidingMotion) -> Result<f64> {
        let across = self.axis_across();
        match self.resting_cell(prescribed, motion) {
            Some(rest) => {
                let sum = self.sums_except(rest.cell, rest.motion)[across];
                Ok(sum + self.traction_at_rest(prescribed, &rest)?[across])
            }
            None => Ok(self.sliding(motion, 0.0).sums[across]),
        }
    }

    /// Returns a motion shifted along the axes with prescribed sums. Tractions along the shifted motion have these
    /// sums.
    pub(in crate::rolling) fn shifted(
        &self,
        motion: SlidingMotion,
        prescribed: &Prescribed,
    ) -> SlidingMotion {
        if prescribed.sums == [None; 2] {
            return motion;
        }
        let turn = motion.turn;
        let least = |shift: [f64; 2], rounding: f64| {
            let sliding = self.sliding(SlidingMotion { turn, shift }, rounding);
            (sliding.bound - prescribed.work(shift), sliding)
        };
        let (mut shift, total) = (motion.shift, self.pressed.limits.sum);
        let lever = least(shift, 0.0).0 / total;
        for rounding in ROUNDINGS.map(|part| part * lever) {
            let (mut bound, mut sliding) = least(shift, rounding);
            for _ in 0..STEPS {
                let slope = [0, 1]
                    .map(|axis| prescribed.sums[axis].map_or(0.0, |sum| sliding.sums[axis] - sum));
                if slope[0].hypot(slope[1]) <= BALANCED * total {
                    break;
                }
                let step = descent(prescribed.sums, slope, sliding.stiffness);
                let expected = DECREASE * dot(slope, step);
                let mut parts = successors(Some(1.0), |part| Some(0.5 * part)).take(STEPS);
                let found = parts.find_map(|part: f64| {
                    let next = [0, 1].map(|axis| shift[axis] + part * step[axis]);
                    let (less, sliding) = least(next, rounding);
                    (less < bound + part * expected).then_some((next, less, sliding))
                });
                let Some((next, less, at_next)) = found else {
                    break;
                };
                (shift, bound, sliding) = (next, less, at_next);
            }
        }
        let round_off = BALANCED * lever * total;
        // The bound has a kink where the middle of a path does not move. The rounding smooths out this kink.
        let motion = SlidingMotion { turn, shift };
        let snapped = self.slowest_cell(motion).map(|(_, index)| {
            let moved = self.moved(motion, index);
            [0, 1].map(|axis| {
                prescribed.sums[axis].map_or(shift[axis], |_| shift[axis] - moved[axis])
            })
        });
        match snapped {
            Some(snapped) if least(snapped, 0.0).0 <= least(shift, 0.0).0 + round_off => {
                SlidingMotion {
                    turn,
                    shift: snapped,
                }
            }
            _ => motion,
        }
    }

    /// Returns the slowest of the cells that can carry traction, as its indices in the window and in the grid. The middle
    /// of the path of this cell has the least motion.
    pub(in crate::rolling) fn slowest_cell(&self, motion: SlidingMotion) -> Option<(usize, usize)> {
        let speed = |index: usize| {
            let [x, y] = self.moved(motion, index);
            x.hypot(y)
        };
        let cells = self.pressed.window().indices().enumerate();
        cells
            .filter(|(cell, _)| self.pressed.limits.cells[*cell] > 0.0)
            .min_by(|(_, a), (_, b)| speed(*a).total_cmp(&speed(*b)))
    }

    pub(in crate::rolling) fn sliding(&self, motion: SlidingMotion, rounding: f64) -> Sliding {
        let mut sliding = Sliding::default();
        let limits = self.pressed.limits.cells.iter();
        for (index, limit) in self.pressed.window().indices().zip(limits) {
            let moved = self.moved(motion, index);
            let size = moved[0].hypot(moved[1]).hypot(rounding);
            if *limit > 0.0 && size > 0.0 {
                let [dx, dy] = moved.map(|part| part / size);
                let stiffness = limit / size;
                sliding.bound += limit * size;
                for (sum, part) in sliding.sums.iter_mut().zip([dx, dy]) {
                    *sum += limit * part;
                }
                let parts = [1.0 - dx * dx, -dx * dy, 1.0 - dy * dy];
                for (sum, part) in sliding.stiffness.iter_mut().zip(parts) {
                    *sum += stiffness * part;
                }
            }
        }
        sliding
    }

    /// Returns the sums of the tractions at their limits over all cells of the window except `except`.
    pub(in crate::rolling) fn sums_except(&self, except: usize, motion: SlidingMotion) -> [f64; 2] {
        let limits = self.pressed.limits.cells.iter();
        let cells = self.pressed.window().indices().zip(limits).enumerate();
        let mut sums = [0.0; 2];
        for (_, (index, limit)) in cells.filter(|(cell, _)| *cell != except) {
            let moved = self.moved(motion, index);
            let size = moved[0].hypot(moved[1]);
            if *limit > 0.0 && size > 0.0 {
                for (sum, moved) in sums.iter_mut().zip(moved) {
                    *sum += limit * moved / size;
                }
            }
        }
        sums
    }

    /// Returns the motion of the middle of the path of a cell of the grid.
    pub(in crate::rolling) fn moved(&self, motion: SlidingMotion, index: usize) -> [f64; 2] {
        let (at, [x, y]) = (centre(self.bodies.grid(), index), self.halfway());
        let turn = [-motion.turn * (at[1] + y), motion.turn * (at[0] + x)];
        [turn[0] + motion.shift[0], turn[1] + motion.shift[1]]
    }

    /// Returns whether a motion per unit rotation counts as rest.
    pub(in crate::rolling) fn is_at_rest(&self, size: f64) -> bool {
        let grid = self.bodies.grid();
        size <= AT_REST * grid.dx().min(grid.dy())
    }

    /// Returns the axis across the rolling direction.
    fn axis_across(&self) -> usize {
        1 - self.step.edge.axis().index()
    }
}

/// Returns the Newton step down a gradient along the axes with prescribed sums.
fn descent(sums: [Option<f64>; 2], [x, y]: [f64; 2], [xx, xy, yy]: [f64; 3]) -> [f64; 2] {
    match sums {
        [Some(_), Some(_)] => {
            let determinant = xx * yy - xy * xy;
            [
                (xy * y - yy * x) / determinant,
                (xy * x - xx * y) / determinant,
            ]
        }
        _ => [
            sums[0].map_or(0.0, |_| -x / xx),
            sums[1].map_or(0.0, |_| -y / yy),
        ],
    }
}
