//! How a pressure changed with its load: where the next solve starts.

use crate::cgm::Total;
use crate::field::clone_in_place;
use crate::normal::engine::Load;
use crate::parallel;
use crate::window::Window;

/// Change of a load, as part of it, below which it is round-off.
const NO_CHANGE: f64 = 1e-12;

/// Beyond so many times the last change nothing is extrapolated.
const FARTHEST: f64 = 3.0;

/// The change of the pressure on a window in the last solve in which the load changed, and what changed it.
#[derive(Debug, Default)]
pub(crate) struct Trend {
    /// Empty before there is one; the pressure before a solve while that is under way.
    pub(crate) change: Vec<f64>,
    /// Change of the sum of the pressures, and of the approach; zero if nothing can be told from it.
    pub(crate) by: [f64; 2],
}

clone_in_place!(Trend { change, by });

/// Sum of the pressures and approach of an answer.
pub(super) type Reached = [f64; 2];

/// How far another load lies from an answer.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Distance {
    /// It is the same, but for round-off.
    None,
    /// So many times as far as the trend leads, zero if nothing can be told.
    Parts(f64),
}

impl Trend {
    /// How far the load lies from what was reached.
    pub(super) fn distance(&self, load: Load, reached: Reached) -> Distance {
        let (wanted, [before, by]) = match load.total {
            Total::Sum(sum) => (sum, [reached[0], self.by[0]]),
            _ => (load.datum, [reached[1], self.by[1]]),
        };
        let ahead = wanted - before;
        if ahead.abs() <= NO_CHANGE * wanted.abs() {
            return Distance::None;
        }
        let parts = ahead / by;
        Distance::Parts(if parts.abs() <= FARTHEST { parts } else { 0.0 })
    }

    /// Moves the pressure of the whole grid on by so many times the trend, and keeps what it was.
    pub(super) fn extrapolate(&mut self, parts: f64, window: Window, pressure: &mut [f64]) {
        self.change.resize(window.cells(), 0.0);
        self.by = [0.0; 2];
        let data = (window.bands_of(pressure), window.bands(&mut self.change));
        window.sweep(
            data,
            &|rows, (pressure, change)| {
                for (_, own, i) in window.places(rows) {
                    let (p, change) = (&mut pressure.items[i], &mut change.items[own]);
                    let before = *p;
                    *p = (before + parts * *change).max(0.0);
                    *change = before;
                }
            },
            &|(), ()| (),
        );
    }

    /// Takes note of the pressure that a solve has led to from where [`Self::extrapolate`] began.
    pub(super) fn note(&mut self, pressure: &[f64], from: Reached, to: Reached) {
        if self.change.len() == pressure.len() {
            parallel::update(&mut self.change, |first, chunk| {
                for (change, pressure) in chunk.iter_mut().zip(&pressure[first..]) {
                    *change = pressure - *change;
                }
            });
            self.by = [to[0] - from[0], to[1] - from[1]];
        }
    }
}
