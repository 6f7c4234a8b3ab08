//! Distribution of the mean square of the heights over wavelengths.

use std::f64::consts::TAU;

use super::heights::{about_mean, complete};
use super::slab::Slab;
use super::waves::{Mode, Waves};
#[cfg(feature = "serde")]
use crate::error::length;
use crate::error::{Result, all_finite};
use crate::grid::Grid;
use crate::grid::field::Field;
use crate::grid::record::checked_struct;
use crate::parallel;

checked_struct! {
    /// Radial power spectrum of a periodic surface, with its spectral moments.
    ///
    /// The heights relative to their mean are a sum of waves $`a_q e^{\mathrm{i} q \cdot x}`$ over the wave vectors $`q`$
    /// of the grid. Let $`A`$ be the area of the grid. Each wave then occupies the area $`4\pi^2/A`$ of the plane of wave
    /// vectors, and
    ///
    /// ```math
    /// C(q) = \frac{A}{4\pi^2}\,\langle |a_q|^2 \rangle_\text{ring}, \qquad
    /// \sum |a_q|^2 = \sum_\text{rings} \frac{4\pi^2}{A}\, n\, C(q) = S_q^2 ,
    /// ```
    ///
    /// where the average is over the $`n`$ waves of a ring $`(k - \tfrac12)\Delta q \le |q| < (k + \tfrac12)\Delta q`$. The
    /// width $`\Delta q`$ is $`2\pi`$ divided by the longer side of the grid. In the limit of an infinite grid,
    /// $`\int C\,\mathrm{d}^2q = 2\pi \int C\, q\,\mathrm{d}q = S_q^2`$. Jacobs, Junge and Pastewka (2017) use the
    /// convention $`S_q^2 = \frac{1}{2\pi}\int C\,q\,\mathrm{d}q`$. Their values are $`4\pi^2`$ times the values of this
    /// type.
    ///
    /// # Spectral moments
    /// The spectral moments are the moments of a profile, averaged over all directions $`\theta`$ of the profile:
    ///
    /// ```math
    /// m_n = \langle \cos^n\theta \rangle \sum |a_q|^2\, |q|^n, \qquad
    /// m_0 = \langle z^2 \rangle, \quad m_2 = \tfrac12 \langle |\nabla z|^2 \rangle, \quad
    /// m_4 = \tfrac38 \langle (\nabla^2 z)^2 \rangle .
    /// ```
    ///
    /// On an isotropic surface the averages are the moments of any profile, as in Longuet-Higgins (1957) and Nayak (1971).
    /// The sums include all waves of the grid without tapering. Waves of two cells per period contribute their full mean
    /// square. If the heights are not periodic, the step at the edge of the grid increases $`m_2`$ and $`m_4`$.
    ///
    /// # References
    /// - T. D. B. Jacobs, T. Junge, L. Pastewka, *Surf. Topogr.: Metrol. Prop.* 5 (2017) 013001,
    ///   [doi:10.1088/2051-672X/aa51f8](https://doi.org/10.1088/2051-672X/aa51f8).
    /// - M. S. Longuet-Higgins, *Phil. Trans. R. Soc. A* 249 (1957) 321-387,
    ///   [doi:10.1098/rsta.1957.0002](https://doi.org/10.1098/rsta.1957.0002).
    /// - P. R. Nayak, *J. Lubr. Technol.* 93 (1971) 398-407,
    ///   [doi:10.1115/1.3451608](https://doi.org/10.1115/1.3451608).
    ///
    /// ```
    /// use std::f64::consts::TAU;
    /// use stickslip::{Field, Grid, surface::PowerSpectrum};
    /// // One wave of amplitude 2 and wavelength 8: mean square 2, wave number 2 pi/8.
    /// let grid = Grid::square(32, 32.0)?;
    /// let wave = Field::from_fn(grid, |x, _| 2.0 * (TAU * x / 8.0).cos());
    /// let spectrum = PowerSpectrum::of(&wave)?;
    /// let [m0, m2, _] = spectrum.moments();
    /// assert!((m0 - 2.0).abs() < 1e-12);
    /// assert!((2.0 * m2 - 2.0 * (TAU / 8.0).powi(2)).abs() < 1e-12);
    /// let largest = spectrum.values().iter().copied().fold(0.0, f64::max);
    /// let ring = spectrum.values().iter().position(|&c| c == largest);
    /// assert_eq!(ring, Some(3), "four periods: the fourth ring");
    /// # Ok::<(), stickslip::Error>(())
    /// ```
    #[derive(Debug, Clone, PartialEq)]
    pub struct PowerSpectrum {
        wave_numbers: Vec<f64>,
        values: Vec<f64>,
        modes: Vec<usize>,
        moments: [f64; 3],
    }
    #[serde(remote = "PowerSpectrum")]
    check(read) {
        let rings = read.wave_numbers.len();
        length("list of values", rings, read.values.len())?;
        length("list of modes", rings, read.modes.len())
    }
}

impl PowerSpectrum {
    /// Computes the spectrum of a surface that continues periodically beyond its grid. For a distributed surface use
    /// [`HalfSpace::power_spectrum`](crate::HalfSpace::power_spectrum).
    ///
    /// # Errors
    /// - [`Error::Sample`](crate::Error::Sample) with the first height that is missing or infinite, or with the first
    ///   value or moment that overflows.
    pub fn of(heights: &Field) -> Result<Self> {
        Self::of_slab(heights, &Slab::alone(heights)?)
    }

    /// Computes the spectrum of a surface from its local slab. The surface may be distributed over ranks.
    pub(crate) fn of_slab(heights: &Field, slab: &Slab) -> Result<Self> {
        slab.layout()
            .collective_result(complete("height", heights))?;
        let waves = parallel::enter_with(heights.grid().cells(), || {
            let (deviations, _) = about_mean(heights, slab, slab.whole().cells());
            Waves::of_slab(&deviations, slab)
        })?;
        let grid = slab.whole();
        let rings = rings(&waves, slab);
        let density = grid.area() / (TAU * TAU);
        let values: Vec<f64> = rings.iter().map(|ring| density * ring.power()).collect();
        let moments = moments(&waves);
        slab.layout().check()?;
        all_finite("power spectrum", &values)?;
        all_finite("moment of the spectrum", &moments)?;
        Ok(Self {
            wave_numbers: rings.iter().map(Ring::wave_number).collect(),
            values,
            modes: rings.iter().map(|ring| ring.modes).collect(),
            moments,
        })
    }

    /// Returns the mean wave number $`|q| = 2\pi/\lambda`$ of the waves of each ring (one over a length), in ascending
    /// order. Rings without a wave are omitted.
    #[must_use]
    pub fn wave_numbers(&self) -> &[f64] {
        &self.wave_numbers
    }

    /// Returns the mean $`C(q)`$ of the waves of each ring (a length to the fourth power).
    #[must_use]
    pub fn values(&self) -> &[f64] {
        &self.values
    }

    /// Returns the number of wave vectors in each ring. The wave vectors $`q`$ and $`-q`$ are counted separately.
    #[must_use]
    pub fn modes(&self) -> &[usize] {
        &self.modes
    }

    /// Returns the spectral moments $`[m_0, m_2, m_4]`$ (a length squared, dimensionless, one over a length squared).
    #[must_use]
    pub fn moments(&self) -> [f64; 3] {
        self.moments
    }

    /// Returns Nayak's bandwidth parameter $`\alpha = m_0 m_4/m_2^2`$. Its value is 3/2 for isotropic waves of a single
    /// length, larger for a broader spectrum, and NaN for a flat surface.
    #[must_use]
    pub fn nayak_parameter(&self) -> f64 {
        let [m0, m2, m4] = self.moments;
        (m0 / m2) * (m4 / m2)
    }

    /// Returns the root mean square $`\sqrt{\tfrac23 m_4}`$ of the mean curvature $`\tfrac12 \nabla^2 z`$ (one over a
    /// length). The formula is valid for small slopes.
    #[must_use]
    pub fn rms_mean_curvature(&self) -> f64 {
        (2.0 / 3.0 * self.moments[2]).sqrt()
    }
}

/// Computes `[m_0, m_2, m_4]` of a surface.
pub(super) fn moments(waves: &Waves) -> [f64; 3] {
    let [zeroth, second, fourth] = waves.sums(|mode, amplitude| {
        let power = mode.copies * amplitude.norm_sqr();
        let q2 = mode.wave_number().powi(2);
        [power, power * q2, power * q2 * q2]
    });
    [zeroth, 0.5 * second, 0.375 * fourth]
}

/// Group of waves of nearly the same length.
#[derive(Debug)]
struct Ring {
    modes: usize,
    sum_of_wave_numbers: f64,
    sum_of_powers: f64,
}

impl Ring {
    fn wave_number(&self) -> f64 {
        self.sum_of_wave_numbers / self.modes as f64
    }

    fn power(&self) -> f64 {
        self.sum_of_powers / self.modes as f64
    }
}

/// Returns the rings that contain a wave, from the longest waves to the shortest. The mean is excluded.
fn rings(waves: &Waves, slab: &Slab) -> Vec<Ring> {
    let width = ring_width(slab.whole());
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "a rounded positive number"
    )]
    let ring = |mode: Mode| (mode.wave_number() / width).round() as usize;
    // Rounding can move a wave by at most one ring.
    let count = ring(waves.shortest()).saturating_add(2);
    // If the cells are much longer than wide, most rings are empty. Only the rings that contain a wave are then
    // numbered.
    let held = (count > slab.whole().cells() + 2).then(|| {
        let mut held: Vec<usize> = Mode::all(slab.whole()).map(ring).collect();
        held.sort_unstable();
        held.dedup();
        held
    });
    let place = |mode: Mode| match &held {
        Some(held) => held.partition_point(|other| *other < ring(mode)),
        None => ring(mode),
    };
    let count = held.as_ref().map_or(count, Vec::len);
    let sums = waves.grouped(count, |mode, amplitude| {
        let modes = if mode.copies > 1.0 { 2 } else { 1 };
        let [number, power] = [mode.wave_number(), amplitude.norm_sqr()];
        let sums = (modes, mode.copies * number, mode.copies * power);
        (mode.numbers != [0, 0]).then(|| (place(mode), sums))
    });
    let held = sums.into_iter().filter(|(modes, ..)| *modes > 0);
    held.map(|(modes, sum_of_wave_numbers, sum_of_powers)| Ring {
        modes,
        sum_of_wave_numbers,
        sum_of_powers,
    })
    .collect()
}

/// Returns `2 pi` divided by the longest wavelength on the grid.
fn ring_width(grid: Grid) -> f64 {
    let side = |cells: usize, cell: f64| if cells > 1 { cells as f64 * cell } else { 0.0 };
    TAU / side(grid.nx(), grid.dx()).max(side(grid.ny(), grid.dy()))
}
