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

/// Prescribed creepages or forces along x and y, and the prescribed spin or moment.
#[derive(Clone, Copy)]
pub(super) struct Controls {
    pub(super) along: [RollingControl; 2],
    pub(super) spin: SpinControl,
}

impl Controls {
    /// Returns the controls of a point `(creepage_x, creepage_y, spin)` of a creep curve.
    pub(super) fn creepage([x, y, spin]: [f64; 3]) -> Self {
        Self {
            along: [x, y].map(RollingControl::Creepage),
            spin: SpinControl::Spin(spin),
        }
    }
}

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

    /// Returns an error if no keyword is given.
    pub(super) fn needed(&self) -> PyResult<()> {
        if self.is_empty() {
            return Err(PyTypeError::new_err(
                "give a creepage, a force, a spin or a moment, such as creepage_x= or force_x=: creepage_x=0.0 for free rolling",
            ));
        }
        Ok(())
    }

    pub(super) fn is_empty(&self) -> bool {
        self.controls == [None; 2] && self.spin.is_none()
    }

    /// Returns the controls of a solve: those of the keywords, and the last ones where no keyword is given.
    pub(super) fn after(&self, last: Controls) -> Controls {
        let [x, y] = self.controls;
        Controls {
            along: [x.unwrap_or(last.along[0]), y.unwrap_or(last.along[1])],
            spin: self.spin.unwrap_or(last.spin),
        }
    }

    /// Returns the controls of a new problem: zero creepage and spin where no keyword is given.
    pub(super) fn controls(&self) -> Controls {
        self.after(Controls::creepage([0.0; 3]))
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
