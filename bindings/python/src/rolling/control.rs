//! Controls of rolling bodies given by keywords.

use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;
use stickslip::rolling::{RollingControl, SpinControl};

use crate::conversion;
use crate::load::one_along;
use crate::pickle::Recipe;
use crate::real::Real;

/// Creepages or forces along both axes.
pub(super) type Both = (Option<conversion::Creepages>, Option<conversion::Force>);

/// Keywords of the controls along each axis and of the rotation.
pub(super) struct Keywords {
    controls: [Option<RollingControl>; 2],
    spin: Option<SpinControl>,
}

impl Keywords {
    pub(super) fn new(
        (creepage, force): Both,
        creepages: [Option<Real>; 2],
        forces: [Option<Real>; 2],
        (spin, moment): (Option<Real>, Option<Real>),
    ) -> PyResult<Self> {
        let along = |axis: usize| {
            let creepage = creepage.as_ref().map(|creepage| creepage.0[axis]);
            let force = force.as_ref().map(|force| force.0[axis]);
            let given = [
                creepage.map(RollingControl::Creepage),
                force.map(RollingControl::Force),
                creepages[axis].map(|Real(creepage)| RollingControl::Creepage(creepage)),
                forces[axis].map(|Real(force)| RollingControl::Force(force)),
            ];
            one_along(axis, given, "creepage and force")
        };
        let spin = match (spin, moment) {
            (None, None) => None,
            (Some(Real(spin)), None) => Some(SpinControl::Spin(spin)),
            (None, Some(Real(moment))) => Some(SpinControl::Moment(moment)),
            _ => {
                return Err(PyTypeError::new_err(
                    "give either a spin or a moment, not both",
                ));
            }
        };
        Ok(Self {
            controls: [along(0)?, along(1)?],
            spin,
        })
    }

    pub(super) fn is_empty(&self) -> bool {
        self.controls == [None; 2] && self.spin.is_none()
    }

    /// Returns the controls along x and y; zero creepage along an axis without a keyword.
    pub(super) fn controls(&self) -> [RollingControl; 2] {
        let still = RollingControl::Creepage(0.0);
        self.controls.map(|control| control.unwrap_or(still))
    }

    /// Returns the control of the rotation; zero spin without a keyword.
    pub(super) fn spin(&self) -> SpinControl {
        self.spin.unwrap_or(SpinControl::Spin(0.0))
    }

    /// Adds the keywords to a recipe.
    pub(super) fn recorded(&self, py: Python<'_>, mut recipe: Recipe) -> PyResult<Recipe> {
        let names = [("creepage_x", "force_x"), ("creepage_y", "force_y")];
        for ((creepage, force), control) in names.into_iter().zip(self.controls) {
            recipe = match control {
                Some(RollingControl::Creepage(value)) => recipe.with(py, creepage, Some(value))?,
                Some(RollingControl::Force(value)) => recipe.with(py, force, Some(value))?,
                _ => recipe,
            };
        }
        match self.spin {
            Some(SpinControl::Spin(value)) => recipe.with(py, "spin", Some(value)),
            Some(SpinControl::Moment(value)) => recipe.with(py, "moment", Some(value)),
            _ => Ok(recipe),
        }
    }
}
