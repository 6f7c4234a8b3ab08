//! Growth of a contact in one step.

use crate::cgm::reduce;
use crate::parallel::layout::Layout;

/// Largest fraction of the contact cells that can be new in a step without a warning. About 20 steps of equal growth of
/// the radius satisfy this limit.
const LARGEST_GROWTH: f64 = 0.1;

/// Contact whose pressure has changed in one step.
pub(crate) struct SensitivityInput<'a> {
    /// Gap before loading.
    pub(crate) gap: &'a [f64],
    /// Pressure before the step, or `None` for separated bodies.
    pub(crate) before: Option<&'a [f64]>,
    pub(crate) pressure: &'a [f64],
    pub(crate) traction: [&'a [f64]; 2],
}

impl SensitivityInput<'_> {
    /// Returns whether a large fraction of the cells of a contact with friction came into contact in this step. Under a
    /// growing load these cells would close at different loads. Cells with the least gap of the contact do not count,
    /// because they also close simultaneously under a growing load.
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
