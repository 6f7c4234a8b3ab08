//! The start of a solve whose forces make the whole contact slide.

use crate::rolling::RollingSolver;
use crate::rolling::steady::capacity::{Prescribed, SlidingMotion};

/// Slip above which the whole contact slides, relative to the largest slip that tractions cause.
const SLIDES: f64 = 3.0;

impl RollingSolver {
    /// Starts from the tractions of gross sliding if spin and forces require creepages that make the whole contact
    /// slide.
    ///
    /// Near the friction limit the force hardly changes with the creepage. If Newton's method then starts from other
    /// tractions, the creepages of its iterates grow without limit.
    pub(in crate::rolling) fn start_sliding(&mut self) {
        let problem = &self.problem;
        let prescribed =
            Prescribed::of(problem.options.controls, problem.bodies.grid().cell_area());
        let turn = SlidingMotion {
            turn: self.engine.spin,
            shift: prescribed.creepage,
        };
        let motion = problem.shifted(turn, &prescribed);
        let speed = |[x, y]: [f64; 2]| x.hypot(y);
        let slowest = problem.slowest_cell(motion);
        let slowest = slowest.map_or(0.0, |(_, index)| speed(problem.moved(motion, index)));
        let slides = slowest * problem.length > SLIDES * self.largest_slip();
        if !slides {
            return;
        }
        for (cell, index) in problem.pressed.window().indices().enumerate() {
            let moved = problem.moved(motion, index);
            let size = speed(moved);
            for (part, moved) in self.engine.traction.iter_mut().zip(moved) {
                part[cell] = if size > 0.0 {
                    self.engine.limits[cell] * (moved / size)
                } else {
                    0.0
                };
            }
        }
    }
}
