//! What a history starts from, checked once.

use crate::cgm::{Settings, settings_methods};
use crate::error::Result;
use crate::field::Field;
use crate::half_space::HalfSpace;
use crate::history::History;
use crate::tangential::{Axis, Friction, Lateral, check_coupling};

/// Options of a [`History`]; each has a default.
#[derive(Debug, Clone)]
#[must_use = "a builder does nothing until build() is called"]
pub struct HistoryBuilder<'a> {
    bodies: &'a HalfSpace,
    gap: &'a Field,
    friction: Friction,
    axis: Axis,
    lateral: Lateral,
    settings: Settings,
    neglect_coupling: bool,
}

impl<'a> HistoryBuilder<'a> {
    pub(super) fn new(bodies: &'a HalfSpace, gap: &'a Field, friction: Friction) -> Self {
        Self {
            bodies,
            gap,
            friction,
            axis: Axis::X,
            lateral: Lateral::default(),
            settings: Settings::default(),
            neglect_coupling: false,
        }
    }
}

impl HistoryBuilder<'_> {
    settings_methods!();

    /// The axis of tangential load and tractions (default [`Axis::X`]); the plane model has none.
    pub fn axis(mut self, axis: Axis) -> Self {
        self.axis = axis;
        self
    }

    /// What becomes of the traction across the load (default [`Lateral::Neglected`]). With
    /// [`Lateral::Coupled`] a history takes loads of any direction and twist, but no springs, and the tangential
    /// [`method`](Self::method) is always the active-set one.
    pub fn lateral(mut self, lateral: Lateral) -> Self {
        self.lateral = lateral;
        self
    }

    /// Accepts a pair of materials whose pressure and shear are coupled, and neglects that: an
    /// error of order beta and mu beta in the tractions (default: such a pair is refused).
    pub fn neglect_coupling(mut self) -> Self {
        self.neglect_coupling = true;
        self
    }

    /// Checks everything and copies the gap; nothing is solved yet.
    ///
    /// # Errors
    /// [`Error::GridMismatch`](crate::Error::GridMismatch) for gap or friction,
    /// [`Error::Sample`](crate::Error::Sample) for the gap,
    /// [`Error::CoupledMaterials`](crate::Error::CoupledMaterials),
    /// [`Error::Tolerance`](crate::Error::Tolerance), [`Error::IterationLimit`](crate::Error::IterationLimit).
    pub fn build(self) -> Result<History> {
        check_coupling(self.bodies, self.neglect_coupling)?;
        let axis = match self.lateral {
            Lateral::Neglected => Some(self.axis),
            Lateral::Coupled => None,
        };
        History::new(self.bodies, self.gap, self.friction, axis, self.settings)
    }
}
