//! Gaps of the cells that come into contact within a step.

use crate::cgm::reduce;
use crate::grid::field::Field;
use crate::half_space::HalfSpace;
use crate::history::state::State;
use crate::normal::NormalControl;
use crate::report::Status;
use crate::tangential::EntryRule;

impl State {
    /// Returns the gap that each cell closes when it comes into contact in a step under this load, as a function of the
    /// cell. The gap is zero for a cell in contact. Returns `None` if cells follow the motion of the whole step.
    ///
    /// The new gap of a rolled step belongs to other particles. A change of the gap then counts only before the first
    /// step.
    pub(crate) fn closing(
        &self,
        bodies: &HalfSpace,
        control: NormalControl,
        is_rolled: bool,
    ) -> Option<impl Fn(usize) -> f64 + use<'_>> {
        if self.entry_rule == EntryRule::WholeStep {
            return None;
        }
        let [gap, pressed_gap] = [&self.gap, &self.pressed_gap].map(Field::as_slice);
        let (apart, pressure) = (self.normal.gap().as_slice(), self.pressure().as_slice());
        let is_first = self.normal.report().status == Status::Unsolved;
        let keeps_gap = is_rolled && !is_first;
        let worn = move |i: usize| {
            if keeps_gap {
                apart[i]
            } else {
                apart[i] + (gap[i] - pressed_gap[i])
            }
        };
        // Bodies that a force brings together move freely until they touch.
        let until_touch = match control {
            NormalControl::Force(_) => {
                reduce::least(&bodies.grid_layout(), |i| Some((worn(i), ())))
                    .map_or(0.0, |(least, ())| least.max(0.0))
            }
            NormalControl::Approach(_) | NormalControl::Hold => 0.0,
        };
        Some(move |i: usize| {
            if pressure[i] > 0.0 {
                0.0
            } else {
                (worn(i) - until_touch).max(0.0)
            }
        })
    }
}
