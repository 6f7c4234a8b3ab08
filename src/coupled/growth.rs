//! The growth of a contact in one step.

use crate::cgm::reduce;
use crate::parallel::layout::Layout;

/// Largest part of the contact that comes into contact in a step without a warning. In steps of equal growth of the
/// radius, 20 steps meet it.
const LARGEST_GROWTH: f64 = 0.1;

/// A contact whose pressure has changed in one step.
pub(crate) struct SensitivityInput<'a> {
    /// The gap before loading.
    pub(crate) gap: &'a [f64],
    /// The pressure before the step; `None` of bodies apart.
    pub(crate) before: Option<&'a [f64]>,
    pub(crate) pressure: &'a [f64],
    pub(crate) traction: [&'a [f64]; 2],
}

impl SensitivityInput<'_> {
    /// Returns whether friction has held a contact that a growing load brings into contact cell after cell, but that came
    /// in this step. Cells of the least gap of the contact come at once under a growing load too.
    pub(crate) fn is_at_once(&self, layout: &Layout) -> bool {
        let Self { gap, pressure, .. } = *self;
        let [qx, qy] = self.traction;
        let is_held = reduce::any(layout, |i| qx[i] != 0.0 || qy[i] != 0.0);
        let first = reduce::least(layout, |i| (pressure[i] > 0.0).then_some((gap[i], i)));
        let Some((first, _)) = first.filter(|_| is_held) else {
            return false;
        };
        let is_new = |i: usize| self.before.is_none_or(|before| before[i] <= 0.0);
        let [contact, later] = reduce::sum(layout, |i| {
            let touches = pressure[i] > 0.0;
            [touches, touches && gap[i] > first && is_new(i)].map(f64::from)
        });
        later > LARGEST_GROWTH * contact
    }
}
