//! Friction limits of a contact, and the criterion for a cell at its limit.

use std::ops::RangeInclusive;

use crate::cgm::reduce;
use crate::error::{Error, Result, SLIDE, finite};
use crate::grid::window::Window;
use crate::half_space::{HalfSpace, Region};
use crate::memory::fallible::{self, try_clone};
use crate::parallel;
use crate::parallel::layout::Layout;
use crate::tangential::Friction;
use crate::warning::Warning;

/// Relative distance from the friction limit within which a force slides the contact, or a cell slips.
pub(crate) const SLIDING: f64 = 1e-12;

/// Range of the largest limit in which the squares of tractions neither overflow nor underflow.
const ORDINARY: RangeInclusive<f64> = 1e-100..=1e100;

/// Fraction of the largest limit below which a limit counts as zero.
pub(super) const NEGLIGIBLE: f64 = 1e-90;

/// Largest ratio of a limit to the largest pressure if the coefficient varies. No traction reaches a larger limit. The limits of
/// the other cells would be negligible compared with it.
const LARGEST_RATIO: f64 = 1e20;

/// Normal contact for the tangential solver: a window around the contact, with pressure and friction limits.
#[derive(Debug, Clone)]
pub(crate) struct PressureOnWindow {
    pub(crate) region: Region,
    /// Pressure of the cells of the region.
    pub(crate) pressure: Vec<f64>,
    pub(crate) limits: Limits,
}

impl PressureOnWindow {
    /// Creates a window without pressure.
    pub(crate) fn new(bodies: &HalfSpace, window: Window) -> Result<Self> {
        let region = Region::new(bodies, window);
        Ok(Self {
            pressure: fallible::zeros(region.cells())?,
            limits: Limits {
                layout: region.layout().clone(),
                cells: fallible::zeros(region.cells())?,
                sum: 0.0,
                remedy: SLIDE,
            },
            region,
        })
    }

    pub(crate) fn window(&self) -> Window {
        self.region.window()
    }

    /// Sets the pressure from the whole grid and computes the friction limits.
    pub(crate) fn set(&mut self, pressure: &[f64], friction: &Friction) {
        self.region.gather(pressure, &mut self.pressure);
        self.limits.set(friction, &self.region, &self.pressure);
    }

    /// Returns the warning about a pressure far below or above the contact modulus of these bodies.
    pub(crate) fn pressure_warning(&self, bodies: &HalfSpace) -> Option<Warning> {
        let largest = reduce::max(self.region.layout(), |i| self.pressure[i]);
        Warning::of_pressure(largest / bodies.pair().contact_modulus())
    }

    /// Changes the friction and recomputes the limits.
    pub(crate) fn set_friction(&mut self, friction: &Friction) {
        self.limits.set(friction, &self.region, &self.pressure);
    }

    /// Checks that friction can carry a force.
    ///
    /// # Errors
    /// - [`Error::EmptyContact`] if no cell carries pressure.
    /// - The errors of [`Limits::check`].
    pub(crate) fn check(&self, force: [f64; 2], cell_area: f64) -> Result<()> {
        let checked = self.limits.check(force, cell_area);
        let is_carried = || reduce::any(self.region.layout(), |i| self.pressure[i] > 0.0);
        if matches!(
            checked,
            Err(Error::BeyondFrictionCapacity { limit: 0.0, .. })
        ) && !is_carried()
        {
            return Err(Error::EmptyContact);
        }
        checked
    }
}

try_clone!(PressureOnWindow { pressure, limits } { region });

/// Friction limit of every cell of a window, and the sum of the limits.
#[derive(Debug, Clone)]
pub(crate) struct Limits {
    layout: Layout,
    pub(crate) cells: Vec<f64>,
    pub(crate) sum: f64,
    /// Remedy for a force beyond the sum of the limits, in words.
    pub(crate) remedy: &'static str,
}

try_clone!(Limits { cells } { layout, sum, remedy });

/// Returns whether a traction or force of this size reaches its limit.
#[inline]
pub(crate) fn is_at_limit(size: f64, limit: f64) -> bool {
    size >= limit * (1.0 - SLIDING)
}

impl Limits {
    fn set(&mut self, friction: &Friction, region: &Region, pressure: &[f64]) {
        self.remedy = friction.remedy();
        let most = if friction.is_uniform() {
            f64::INFINITY
        } else {
            LARGEST_RATIO * reduce::max(&self.layout, |i| pressure[i])
        };
        let friction = &friction.within(region);
        parallel::update(&mut self.cells, |first, chunk| {
            friction.write_limits(first, &pressure[first..], chunk);
            // An infinite limit remains infinite, so that the check of the sum rejects it.
            for limit in chunk.iter_mut().filter(|limit| limit.is_finite()) {
                *limit = limit.min(most);
            }
        });
        // Negligible limits carry no load, and their squares would underflow.
        let least = NEGLIGIBLE * self.largest();
        parallel::update(&mut self.cells, |_, chunk| {
            for limit in chunk {
                *limit = if *limit < least { 0.0 } else { *limit };
            }
        });
        self.sum = reduce::total(&self.layout, &self.cells);
    }

    fn largest(&self) -> f64 {
        reduce::max(&self.layout, |i| self.cells[i])
    }

    /// Returns a unit for tractions whose squares would otherwise overflow or underflow. The unit is a power of two
    /// near the largest limit. Returns `None` if no unit is needed.
    pub(crate) fn unit(&self) -> Option<f64> {
        let largest = self.largest();
        let is_extreme = largest > 0.0 && !ORDINARY.contains(&largest);
        is_extreme.then(|| largest.log2().clamp(-1000.0, 1000.0).floor().exp2())
    }

    /// Returns an error if friction cannot carry the force or if the limits overflow.
    pub(crate) fn check(&self, [x, y]: [f64; 2], cell_area: f64) -> Result<()> {
        finite("sum of the friction limits", self.sum)?;
        let (force, limit) = (x.hypot(y), self.sum * cell_area);
        if force > limit * (1.0 + SLIDING) {
            return Err(Error::BeyondFrictionCapacity {
                force,
                limit,
                remedy: self.remedy,
            });
        }
        Ok(())
    }

    /// Returns the sums of tractions for a force. They are exactly at the limit if the force is within round-off of the
    /// limit.
    pub(crate) fn sums(&self, force: [f64; 2], cell_area: f64) -> [f64; 2] {
        let sums = force.map(|force| force / cell_area);
        let size = sums[0].hypot(sums[1]);
        if size > 0.0 && is_at_limit(size, self.sum) {
            sums.map(|sum| sum * (self.sum / size))
        } else {
            sums
        }
    }
}
