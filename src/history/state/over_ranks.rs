//! What all ranks together know of a state, kept with the slab of each.

use crate::cgm::reduce;
use crate::half_space::HalfSpace;
use crate::history::state::State;
use crate::tangential::Friction;

impl State {
    /// Takes note of what all ranks know together, which is not among the fields of a slab.
    pub(in crate::history) fn gather_whole(&mut self, bodies: &HalfSpace) {
        self.normal.gather_whole(bodies);
        if let Some(hardness) = &self.hardness {
            let yielded = hardness.reached_cells(bodies, self.pressure().as_slice());
            self.normal.set_yielded_cells(yielded);
        }
        self.normal.measure_scale(bodies, &self.pressed_gap);
        self.gather_capacity(bodies);
    }

    /// The same of what friction holds, under another pressure than before.
    pub(in crate::history) fn gather_capacity(&mut self, bodies: &HalfSpace) {
        self.capacity = self.capacity_on_ranks(bodies, &self.friction);
    }

    /// [`Self::capacity_with`], of bodies that ranks share: without, it is found when it is asked for.
    pub(in crate::history) fn capacity_on_ranks(
        &self,
        bodies: &HalfSpace,
        friction: &Friction,
    ) -> Option<f64> {
        let is_shared = bodies.is_shared();
        is_shared.then(|| self.capacity_with(bodies, friction))
    }

    /// Largest tangential force that this friction holds at the present pressure.
    pub(in crate::history) fn capacity_with(&self, bodies: &HalfSpace, friction: &Friction) -> f64 {
        let pressure = self.pressure().as_slice();
        let sum = reduce::sum(&bodies.grid_layout(), |i| friction.limit(i, pressure[i]));
        sum * self.grid().cell_area()
    }
}
