//! Changes of the gap between two solves, relative to the displacement of the first contact.

use crate::cgm::reduce;
use crate::grid::field::Field;
use crate::half_space::HalfSpace;

/// Fraction of the largest change below which a change counts as none. Wear can be interpolated or smoothed before it is added.
const NEGLIGIBLE: f64 = 1e-3;
/// Number of cells outside the contact for each of them whose gap must be unchanged in wear.
const OUTSIDE_PER_UNCHANGED: usize = 10;

/// Pressure and approach of the last solve, to which changes of the gap refer.
#[derive(Clone, Copy)]
pub(crate) struct LastContact<'a> {
    pub(crate) bodies: &'a HalfSpace,
    pub(crate) pressure: &'a [f64],
    pub(crate) approach: f64,
}

impl LastContact<'_> {
    /// Returns the largest change of the gap of a contact cell, divided by the largest normal displacement due to the
    /// pressure. The ratio is zero without contact.
    pub(crate) fn gap_change(&self, [before, now]: [&Field; 2]) -> f64 {
        let Self {
            bodies, approach, ..
        } = *self;
        let layout = bodies.grid_layout();
        let [before, now] = [before, now].map(Field::as_slice);
        let largest = |of: &(dyn Fn(usize) -> f64 + Sync)| {
            let of_contact = |i: usize| if self.is_contact(i) { of(i) } else { 0.0 };
            reduce::max(&layout, of_contact)
        };
        let displacement = largest(&|i| (approach - before[i]).max(0.0));
        let change = largest(&|i| (now[i] - before[i]).abs());
        if displacement > 0.0 {
            change / displacement
        } else {
            0.0
        }
    }

    /// Returns [`Self::gap_change`] for a change like wear, and zero for a change to another surface or another part of a
    /// surface. Wear has one sign and leaves cells outside the contact unchanged.
    pub(crate) fn wear(&self, gaps: [&Field; 2]) -> f64 {
        let ratio = self.gap_change(gaps);
        if ratio > 1.0 && self.resembles_wear(gaps) {
            ratio
        } else {
            0.0
        }
    }

    fn resembles_wear(&self, [before, now]: [&Field; 2]) -> bool {
        let layout = self.bodies.grid_layout();
        let [before, now] = [before, now].map(Field::as_slice);
        let change = |i: usize| now[i] - before[i];
        let rise = reduce::max(&layout, |i| change(i).max(0.0));
        let fall = reduce::max(&layout, |i| (-change(i)).max(0.0));
        let least = NEGLIGIBLE * rise.max(fall);
        let [outside, unchanged] = reduce::sum(&layout, |i| {
            let is_outside = !self.is_contact(i);
            let is_unchanged = is_outside && change(i).abs() <= least;
            [is_outside, is_unchanged].map(usize::from)
        });
        rise.min(fall) <= least && OUTSIDE_PER_UNCHANGED * unchanged >= outside
    }

    fn is_contact(&self, cell: usize) -> bool {
        self.pressure[cell] > 0.0
    }
}
