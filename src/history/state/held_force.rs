//! Tangential force that a held shift is expected to keep.

use crate::history::LoadStep;
use crate::history::state::State;
use crate::history::step::diagnostics::LARGEST_LOSS;

impl State {
    /// Updates the expected force after a step, and returns the lost fraction of this force in per cent. The expected
    /// force of an axis is the force after the last step that prescribed its load. A larger force after a later step
    /// replaces it, and so does the force after a step with a warning.
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "the number lies between 0 and 100"
    )]
    pub(in crate::history) fn lose_held_force(&mut self, load: &LoadStep) -> usize {
        const ROUND_OFF: f64 = 1e-3;
        let (is_held, force, normal_force) = (load.held_axes(), self.force, self.normal.force());
        let size = |[x, y]: [f64; 2]| x.hypot(y);
        let held =
            |force: [f64; 2]| [0, 1].map(|axis| if is_held[axis] { force[axis] } else { 0.0 });
        let (expected, found) = (size(held(self.held_force)), size(held(force)));
        let is_compared = normal_force > 0.0 && found < expected;
        let lost = if is_compared && expected > ROUND_OFF * normal_force {
            (100.0 * (1.0 - found / expected)).round() as usize
        } else {
            0
        };
        let is_reset = !is_compared || lost > LARGEST_LOSS;
        for axis in 0..2 {
            if is_reset || !is_held[axis] {
                self.held_force[axis] = force[axis];
            }
        }
        lost
    }
}
