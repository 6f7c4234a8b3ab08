//! Load paths of a cycle.

use std::f64::consts::FRAC_PI_2;

use crate::error::{Error, Result, all_finite, finite, memory};

/// Cycle of a tangential load in the plane, stored as the values `[x, y]` at the ends of its steps.
///
/// The values are forces or shifts: [`LoadStep::force`](crate::history::LoadStep::force) and
/// [`LoadStep::shift`](crate::history::LoadStep::shift) turn a value into a step. Each cycle starts where the previous
/// cycle ends. If a formula defines the `n` steps, the k-th step ends at $`t = k/n`$. The paths [`sine`](Self::sine)
/// and [`triangle`](Self::triangle) therefore start and end without load.
///
/// ```
/// use stickslip::history::LoadPath;
/// let path = LoadPath::sine([20.0, 0.0], 40)?;
/// assert_eq!(path.steps().len(), 40);
/// // The values have no round-off: amplitude after a quarter, zero after a half and after the whole cycle.
/// assert_eq!(path.steps()[9], [20.0, 0.0]);
/// assert_eq!(path.steps()[19], [0.0, 0.0]);
/// assert_eq!(path.steps()[29], [-20.0, 0.0]);
/// assert_eq!(path.end(), [0.0, 0.0]);
/// // Three cycles in succession.
/// let largest = path.cycles(3).map(|[x, _]| x).fold(0.0, f64::max);
/// assert_eq!(largest, 20.0);
/// assert_eq!(path.cycles(3).count(), 120);
/// # Ok::<(), stickslip::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(try_from = "RawLoadPath")
)]
pub struct LoadPath {
    steps: Vec<[f64; 2]>,
}

/// Deserialised value before validation.
#[cfg(feature = "serde")]
#[derive(serde::Deserialize)]
struct RawLoadPath {
    steps: Vec<[f64; 2]>,
}

#[cfg(feature = "serde")]
impl TryFrom<RawLoadPath> for LoadPath {
    type Error = Error;

    fn try_from(read: RawLoadPath) -> Result<Self> {
        Self::table(read.steps)
    }
}

impl LoadPath {
    /// Creates a cycle back and forth along a line, $`A\sin 2\pi t`$ with the amplitude $`A`$ along x and along y.
    ///
    /// # Errors
    /// - [`Error::NotFinite`] if the amplitude is not finite.
    /// - [`Error::StepsPerCycle`] if `steps` is not a positive multiple of 4.
    /// - [`Error::Memory`] if memory does not suffice for the steps.
    pub fn sine(amplitude: [f64; 2], steps: usize) -> Result<Self> {
        Self::wave(amplitude, steps, |quarter| [quarter.sine(), quarter.sine()])
    }

    /// Creates a cycle back and forth along a line at a constant rate. The load reaches the amplitude $`A`$ after a
    /// quarter of the cycle.
    ///
    /// # Errors
    /// Errors of [`sine`](Self::sine).
    pub fn triangle(amplitude: [f64; 2], steps: usize) -> Result<Self> {
        Self::wave(amplitude, steps, |quarter| {
            [quarter.triangle(), quarter.triangle()]
        })
    }

    /// Creates a cycle around an ellipse, with $`A_x\sin 2\pi t`$ along x and $`A_y\sin(2\pi t+\varphi)`$ along y. The
    /// phase $`\varphi`$ is in radians.
    ///
    /// A phase of $`\pi/2`$ with equal amplitudes gives a circle. No value exceeds its amplitude. The cycle starts and
    /// ends at $`[0, A_y\sin\varphi]`$, so the first step from an unloaded contact is longer by this load. The error of
    /// energies is of first order in the length of a step ([`history`](crate::history)), and is large for few steps. On a
    /// circle of shifts of two thirds of the limit of sliding, 4, 8, 16 and 32 steps give 42, 62, 79 and 90 % of the energy
    /// of 128 steps.
    ///
    /// # Errors
    /// - [`Error::NotFinite`] if the phase is not finite.
    /// - [`Error::UnsupportedByModel`] if the magnitude of the phase exceeds a full turn, as a phase in degrees.
    /// - Errors of [`sine`](Self::sine).
    pub fn ellipse(amplitudes: [f64; 2], phase: f64, steps: usize) -> Result<Self> {
        if finite("phase", phase)?.abs() > std::f64::consts::TAU {
            return Err(Error::UnsupportedByModel {
                model: "an ellipse",
                quantity: "a phase of more than 6.283 (2 pi)",
                value: phase,
                remedy: "give the phase in radians",
            });
        }
        let (ahead, along) = phase.sin_cos();
        Self::wave(amplitudes, steps, |quarter| {
            let turned = quarter.sine() * along + quarter.cosine() * ahead;
            [quarter.sine(), turned.clamp(-1.0, 1.0)]
        })
    }

    /// Creates a path from a table of values, each at the end of a step.
    ///
    /// A closed path ends with its initial value. When a path is repeated, its first value follows its last.
    ///
    /// # Errors
    /// - [`Error::EmptyPath`] if the table is empty.
    /// - [`Error::Sample`] at the first value that is not finite. The index of the error counts x and y in turn.
    pub fn table(steps: Vec<[f64; 2]>) -> Result<Self> {
        if steps.is_empty() {
            return Err(Error::EmptyPath);
        }
        all_finite("load path", steps.as_flattened())?;
        Ok(Self { steps })
    }

    /// Returns the values at the ends of the steps of one cycle.
    #[must_use]
    pub fn steps(&self) -> &[[f64; 2]] {
        &self.steps
    }

    /// Returns the value at the end of a cycle, where the next cycle starts.
    #[must_use]
    pub fn end(&self) -> [f64; 2] {
        self.steps[self.steps.len() - 1]
    }

    /// Returns the values of `count` consecutive cycles.
    pub fn cycles(&self, count: usize) -> impl Iterator<Item = [f64; 2]> {
        (0..count).flat_map(|_| self.steps.iter().copied())
    }

    /// Creates a cycle of `steps` values, which are the amplitudes times the values of `shape`.
    fn wave(
        amplitudes: [f64; 2],
        steps: usize,
        shape: impl Fn(Quarter) -> [f64; 2],
    ) -> Result<Self> {
        finite("amplitude along x", amplitudes[0])?;
        finite("amplitude along y", amplitudes[1])?;
        if steps == 0 || steps % 4 != 0 {
            return Err(Error::StepsPerCycle(steps));
        }
        memory("the load path", [steps, 2], size_of::<f64>())?;
        let value = |step| {
            let [x, y] = shape(Quarter::of(step, steps / 4));
            [amplitudes[0] * x, amplitudes[1] * y]
        };
        Ok(Self {
            steps: (1..=steps).map(value).collect(),
        })
    }
}

/// Position within a quarter of a cycle, used so that all quarters are bitwise identical.
#[derive(Clone, Copy)]
struct Quarter {
    /// Number of earlier quarters.
    number: usize,
    /// Number of steps since the start of the quarter, out of `steps` per quarter.
    step: usize,
    steps: usize,
}

impl Quarter {
    fn of(step: usize, steps: usize) -> Self {
        Self {
            number: step / steps,
            step: step % steps,
            steps,
        }
    }

    /// Returns $`\sin 2\pi t`$.
    fn sine(self) -> f64 {
        self.fold(|part| (FRAC_PI_2 * part).sin())
    }

    /// Returns $`\cos 2\pi t`$.
    fn cosine(self) -> f64 {
        Self {
            number: self.number + 1,
            ..self
        }
        .sine()
    }

    /// Returns the triangle wave with the zeros and extremes of the sine.
    fn triangle(self) -> f64 {
        self.fold(|part| part)
    }

    /// Extends `rise` by symmetry to the whole cycle. In the first quarter `rise` grows from zero to one.
    fn fold(self, rise: impl Fn(f64) -> f64) -> f64 {
        let part = |step: usize| step as f64 / self.steps as f64;
        match self.number % 4 {
            0 => rise(part(self.step)),
            1 => rise(part(self.steps - self.step)),
            2 => -rise(part(self.step)),
            _ => -rise(part(self.steps - self.step)),
        }
    }
}
