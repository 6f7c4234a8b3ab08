//! The loads of a cycle.

use std::f64::consts::FRAC_PI_2;

use crate::error::{Error, Result, all_finite, finite, memory};

/// A cycle of a tangential load in the plane, as the values `[x, y]` at the ends of its steps.
///
/// Forces or shifts, as the caller means them: [`LoadStep::force`](crate::history::LoadStep::force) and
/// [`LoadStep::shift`](crate::history::LoadStep::shift) make a step of a value. Where a cycle ends the next
/// begins. Of `n` steps made by formula the k-th ends at $`t = k/n`$, so that [`sine`](Self::sine) and
/// [`triangle`](Self::triangle) begin and end without load.
///
/// ```
/// use stickslip::history::LoadPath;
/// let path = LoadPath::sine([20.0, 0.0], 40)?;
/// assert_eq!(path.steps().len(), 40);
/// // Without rounding: a quarter reaches the amplitude, a half and the whole are at zero.
/// assert_eq!(path.steps()[9], [20.0, 0.0]);
/// assert_eq!(path.steps()[19], [0.0, 0.0]);
/// assert_eq!(path.steps()[29], [-20.0, 0.0]);
/// assert_eq!(path.end(), [0.0, 0.0]);
/// // Three cycles in one go.
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

/// What was read, before it is checked.
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
    /// To and fro along a line, $`A\sin 2\pi t`$ with the amplitude $`A`$ along x and along y.
    ///
    /// # Errors
    /// [`Error::NotFinite`] for the amplitude, [`Error::StepsPerCycle`] if `steps` is not a positive
    /// multiple of 4, [`Error::Memory`] if there are too many.
    pub fn sine(amplitude: [f64; 2], steps: usize) -> Result<Self> {
        Self::wave(amplitude, steps, |quarter| [quarter.sine(), quarter.sine()])
    }

    /// To and fro along a line at a constant rate, from zero to the amplitude $`A`$ in a quarter of
    /// the cycle.
    ///
    /// # Errors
    /// As [`sine`](Self::sine).
    pub fn triangle(amplitude: [f64; 2], steps: usize) -> Result<Self> {
        Self::wave(amplitude, steps, |quarter| {
            [quarter.triangle(), quarter.triangle()]
        })
    }

    /// Around an ellipse, $`A_x\sin 2\pi t`$ along x and $`A_y\sin(2\pi t+\varphi)`$ along y, with the
    /// phase $`\varphi`$ in radians.
    ///
    /// A phase of $`\pi/2`$ and equal amplitudes make a circle. Neither amplitude is exceeded. The
    /// cycle begins and ends at $`[0, A_y\sin\varphi]`$: from an unloaded contact its first step is
    /// that much longer. Energies are of first order in the length of a step here, see [`history`](crate::history).
    ///
    /// # Errors
    /// As [`sine`](Self::sine); [`Error::NotFinite`] for the phase.
    pub fn ellipse(amplitudes: [f64; 2], phase: f64, steps: usize) -> Result<Self> {
        let (ahead, along) = finite("phase", phase)?.sin_cos();
        Self::wave(amplitudes, steps, |quarter| {
            let turned = quarter.sine() * along + quarter.cosine() * ahead;
            [quarter.sine(), turned.clamp(-1.0, 1.0)]
        })
    }

    /// A path through a table of values, each the end of a step.
    ///
    /// A closed path ends with the value it began with. When a path is repeated, its first value follows its last.
    ///
    /// # Errors
    /// [`Error::EmptyPath`] if there is no step, [`Error::Sample`] for a value that is not finite;
    /// its index counts x and y in turn.
    pub fn table(steps: Vec<[f64; 2]>) -> Result<Self> {
        if steps.is_empty() {
            return Err(Error::EmptyPath);
        }
        all_finite("load path", steps.as_flattened())?;
        Ok(Self { steps })
    }

    /// The values at the ends of the steps of one cycle.
    #[must_use]
    pub fn steps(&self) -> &[[f64; 2]] {
        &self.steps
    }

    /// The value where a cycle ends, and the next begins.
    #[must_use]
    pub fn end(&self) -> [f64; 2] {
        self.steps[self.steps.len() - 1]
    }

    /// The values of `count` cycles, one after the other.
    pub fn cycles(&self, count: usize) -> impl Iterator<Item = [f64; 2]> {
        (0..count).flat_map(|_| self.steps.iter().copied())
    }

    /// A cycle of `steps` values: the amplitudes times what `shape` has there.
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
        memory("load path", [steps, 2], size_of::<f64>())?;
        let value = |step| {
            let [x, y] = shape(Quarter::of(step, steps / 4));
            [amplitudes[0] * x, amplitudes[1] * y]
        };
        Ok(Self {
            steps: (1..=steps).map(value).collect(),
        })
    }
}

/// A step within a quarter of a cycle, so that all quarters are the same to the last bit.
#[derive(Clone, Copy)]
struct Quarter {
    /// Quarters before this one.
    number: usize,
    /// Steps since, of how many a quarter has.
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

    /// $`\sin 2\pi t`$.
    fn sine(self) -> f64 {
        self.fold(|part| (FRAC_PI_2 * part).sin())
    }

    /// $`\cos 2\pi t`$.
    fn cosine(self) -> f64 {
        Self {
            number: self.number + 1,
            ..self
        }
        .sine()
    }

    /// The triangle of the same zeros and extremes.
    fn triangle(self) -> f64 {
        self.fold(|part| part)
    }

    /// Continues a rise from zero to one over the first quarter.
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
