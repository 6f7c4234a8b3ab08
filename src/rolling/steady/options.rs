//! Options of rolling problems, all with defaults.

use crate::cgm::Settings;
use crate::rolling::{LeadingEdge, RollingControl, SpinControl};
use crate::tangential::EntryRule;

/// Prescribed motion, steps and settings of a problem of steady rolling.
#[derive(Debug, Clone, Copy)]
pub(in crate::rolling) struct RollingOptions {
    pub(in crate::rolling) edge: LeadingEdge,
    /// Number of cells per step.
    pub(in crate::rolling) cells: usize,
    pub(in crate::rolling) controls: [RollingControl; 2],
    pub(in crate::rolling) spin: SpinControl,
    pub(in crate::rolling) entry_rule: EntryRule,
    /// Number of solves that correct the direction of slip.
    pub(in crate::rolling) slip_corrections: usize,
    pub(in crate::rolling) settings: Settings,
}

impl Default for RollingOptions {
    fn default() -> Self {
        Self {
            edge: LeadingEdge::default(),
            cells: 1,
            controls: [RollingControl::Creepage(0.0); 2],
            spin: SpinControl::Spin(0.0),
            entry_rule: EntryRule::default(),
            slip_corrections: 0,
            settings: Settings::default(),
        }
    }
}

impl RollingOptions {
    /// Sets the prescribed motion, and returns whether it has changed.
    pub(in crate::rolling) fn set_load(
        &mut self,
        controls: [RollingControl; 2],
        spin: SpinControl,
    ) -> bool {
        let before = (self.controls, self.spin);
        (self.controls, self.spin) = (controls, spin);
        before != (controls, spin)
    }
}

/// Setters of the options, which are identical for both builders. The builder stores the options in `$($path).+`.
macro_rules! rolling_methods {
    ($($path:ident).+) => {
        crate::cgm::settings_methods!($($path).+.settings);

        /// Sets the side at which particles enter the contact (default [`LeadingEdge::PlusX`]).
        pub fn leading_edge(mut self, edge: LeadingEdge) -> Self {
            self.$($path).+.edge = edge;
            self
        }

        /// Sets the number of cells that a particle passes per step (default 1). Longer steps cost less and are less accurate.
        pub fn step(mut self, cells: usize) -> Self {
            self.$($path).+.cells = cells;
            self
        }

        /// Sets both creepages `[x, y]` (dimensionless, default zero).
        pub fn creepage(mut self, creepage: [f64; 2]) -> Self {
            self.$($path).+.controls = creepage.map(RollingControl::Creepage);
            self
        }

        /// Sets the force or creepage along an axis (default: zero creepage).
        pub fn control(mut self, axis: Axis, control: RollingControl) -> Self {
            self.$($path).+.controls[axis.index()] = control;
            self
        }

        /// Sets the [spin](SpinControl::Spin) (one over a length, default zero) or the moment from which the spin follows.
        pub fn spin(mut self, spin: impl Into<SpinControl>) -> Self {
            self.$($path).+.spin = spin.into();
            self
        }

        /// Sets the number of corrections of the direction of slip (default 0).
        ///
        /// If the slip turns within the contact, as under spin or oblique creepage, the forces converge with first order in the
        /// step. With two corrections the order is 1.5 to 2 ([measurements](crate::rolling#slip-that-turns)). The corrections
        /// cost two more solves, each of which starts from the last tractions. The slip of the solution remains the mean over the
        /// step. Corrected tractions are not exactly opposite to this mean.
        pub fn slip_corrections(mut self, corrections: usize) -> Self {
            self.$($path).+.slip_corrections = corrections;
            self
        }

        /// Sets the entry rule, the displacement law of cells that enter the contact (default [`EntryRule::SinceTouch`]).
        pub fn entry_rule(mut self, entry_rule: EntryRule) -> Self {
            self.$($path).+.entry_rule = entry_rule;
            self
        }
    };
}

pub(in crate::rolling) use rolling_methods;
