//! Counts and sums of a state over all ranks, stored with the slab of each rank.

use crate::cgm::reduce;
use crate::half_space::HalfSpace;
use crate::history::state::State;
use crate::normal::{GapChange, PressedGap};
use crate::parallel::layout::Layout;
use crate::tangential::{Friction, Zone};

impl State {
    /// Computes the counts and sums over all ranks, which the fields of a slab do not contain.
    pub(in crate::history) fn gather_whole(&mut self, bodies: &HalfSpace) {
        self.normal.gather_whole(bodies);
        self.normal.compare_with(bodies, self.hardness.as_ref());
        self.normal.measure_scale(bodies, &self.pressed_gap);
        self.gather_capacity(bodies);
        self.zone_cells = self.cells_of_zones(&bodies.grid_layout());
    }

    /// Returns the numbers of cells of a layout that stick and that slip.
    pub(in crate::history) fn cells_of_zones(&self, layout: &Layout) -> [usize; 2] {
        [Zone::Stick, Zone::Slip]
            .map(|zone| reduce::sum(layout, |i| usize::from(self.zones[i] == zone)))
    }

    /// Computes the friction capacity over all ranks after a change of the pressure.
    pub(in crate::history) fn gather_capacity(&mut self, bodies: &HalfSpace) {
        self.capacity = self.capacity_on_ranks(bodies, &self.friction);
    }

    /// Returns [`Self::capacity_with`] for distributed bodies. Returns `None` for other bodies, whose capacity is
    /// computed on request.
    pub(in crate::history) fn capacity_on_ranks(
        &self,
        bodies: &HalfSpace,
        friction: &Friction,
    ) -> Option<f64> {
        let is_shared = bodies.is_shared();
        is_shared.then(|| self.capacity_with(bodies, friction))
    }

    /// Returns whether this friction has different limits in the contact than the present friction.
    pub(in crate::history) fn friction_differs(
        &self,
        bodies: &HalfSpace,
        friction: &Friction,
    ) -> bool {
        let pressure = self.pressure().as_slice();
        let differs = |of: &dyn Fn(&Friction) -> f64| of(&self.friction) - of(friction) != 0.0;
        reduce::any(&bodies.grid_layout(), |i| {
            let p = pressure[i];
            p > 0.0 && (differs(&|of| of.limit(i, p)) || differs(&|of| of.slope(i, p)))
        })
    }

    /// Returns the largest tangential force that this friction can carry at the present pressure.
    pub(in crate::history) fn capacity_with(&self, bodies: &HalfSpace, friction: &Friction) -> f64 {
        let pressure = self.pressure().as_slice();
        let sum = reduce::sum(&bodies.grid_layout(), |i| friction.limit(i, pressure[i]));
        sum * self.grid().cell_area()
    }

    /// Returns the change of the gap since the last pressure, and the number of cells in which it resembles wear of the wrong sign.
    pub(in crate::history) fn measure_wear(&self, bodies: &HalfSpace) -> (GapChange, usize) {
        let pressed = self.pressed(bodies);
        let negative_cells = pressed.negative_wear(&self.gap, &self.accumulated_slip);
        (pressed.change_to(&self.gap), negative_cells)
    }

    /// Returns the last pressed contact with its gap before loading.
    pub(in crate::history) fn pressed<'a>(&'a self, bodies: &'a HalfSpace) -> PressedGap<'a> {
        PressedGap {
            bodies,
            gap: &self.pressed_gap,
            pressure: self.pressure().as_slice(),
            approach: self.normal.approach(),
        }
    }
}
