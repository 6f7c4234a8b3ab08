//! Power spectrum of a self-affine surface on a given grid.

use std::f64::consts::TAU;

use super::SelfAffine;
use crate::error::{Error, Result, at_least, positive};
use crate::grid::Grid;
use crate::surface::waves::Mode;

/// Self-affine law with all wavelengths set.
#[derive(Debug, Clone, Copy)]
pub(super) struct SpectrumLaw {
    hurst: f64,
    longest: f64,
    roll_off: f64,
    cut_off: f64,
}

/// Fraction of a wavelength by which a wave may lie outside the band. This tolerance prevents round-off from excluding
/// waves on the edge of the band.
const ROUND_OFF: f64 = 1e-9;

/// Default cut-off, in cells.
const CUT_OFF_CELLS: f64 = 8.0;
/// Smallest cut-off, in cells.
const LEAST_CUT_OFF_CELLS: f64 = 2.0;

impl SpectrumLaw {
    /// Creates the requested law on the grid of the periodic surface.
    pub(super) fn new(asked: &SelfAffine, grid: Grid) -> Result<Self> {
        if !(0.0..=1.0).contains(&asked.hurst) {
            return Err(Error::Hurst(asked.hurst));
        }
        let side = (grid.nx() as f64 * grid.dx()).max(grid.ny() as f64 * grid.dy());
        let cell = grid.dx().max(grid.dy());
        let longest = asked.longest_wavelength.unwrap_or(side);
        let roll_off = asked.roll_off_wavelength.unwrap_or(longest);
        let cut_off = asked.cut_off_wavelength.unwrap_or(CUT_OFF_CELLS * cell);
        positive("longest wavelength", longest)?;
        positive("roll-off wavelength", roll_off)?;
        positive("cut-off wavelength", cut_off)?;
        let limit = LEAST_CUT_OFF_CELLS * cell;
        at_least("two cells", limit, "cut-off wavelength", cut_off)?;
        // Without a roll-off, the message names the length that replaces it.
        let roll_off_is = match (asked.roll_off_wavelength, asked.longest_wavelength) {
            (Some(_), _) => "roll-off wavelength",
            (None, Some(_)) => "longest wavelength",
            (None, None) => "longest side of the surface",
        };
        at_least("the cut-off wavelength", cut_off, roll_off_is, roll_off)?;
        at_least(
            "the roll-off wavelength",
            roll_off,
            "longest wavelength",
            longest,
        )?;
        Ok(Self {
            hurst: asked.hurst,
            longest,
            roll_off,
            cut_off,
        })
    }

    /// Returns the power of a wave relative to the plateau.
    pub(super) fn power(&self, mode: &Mode) -> f64 {
        let number = mode.wave_number();
        let wavelength = if number > 0.0 {
            TAU / number
        } else {
            f64::INFINITY
        };
        let is_short = wavelength < self.cut_off * (1.0 - ROUND_OFF);
        // In this form the product cannot overflow. The mean has an infinite wavelength and always counts as too long.
        let is_long = wavelength * (1.0 - ROUND_OFF) > self.longest;
        if is_short || is_long || mode.is_at_limit {
            0.0
        } else {
            let excess = (self.roll_off / wavelength).max(1.0);
            excess.powf(-2.0 * (1.0 + self.hurst))
        }
    }

    /// Returns the total power of the waves of a field, each weighted by a function of its mode.
    pub(super) fn total(&self, grid: Grid, weight: impl Fn(&Mode) -> f64) -> Result<f64> {
        let power = |mode: Mode| mode.copies * self.power(&mode) * weight(&mode);
        let total = Mode::all(grid).map(power).sum();
        if total == 0.0 {
            return Err(Error::NoWaveInBand {
                longest: self.longest,
                shortest: self.cut_off,
            });
        }
        positive("power of the waves", total)
    }
}
