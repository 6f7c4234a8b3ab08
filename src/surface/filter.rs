//! Gaussian filters of measured surfaces.

use std::f64::consts::TAU;
use std::ops::Range;

use super::heights::finite_or_missing;
use super::slab::Slab;
use super::waves::{Mode, Waves};
use crate::error::{Error, Result, at_least, finite, memory, positive};
use crate::fft::smooth_length;
use crate::grid::Grid;
use crate::grid::field::Field;
use crate::grid::record::checked_struct;
use crate::parallel;

/// Memory in bytes per cell of the torus, for a field, its waves, their transform, and the weights of the points.
const BYTES: usize = 32;

/// Distance in nesting indices beyond which the weight of the Gaussian is below round-off.
const REACH: f64 = 1.7;

/// Gaussian filter of heights: areal filters after ISO 16610-61, profile filters after ISO 16610-21.
///
/// An *S filter* removes the waves that are short compared with its nesting index $`\lambda_s`$. An example is the noise of the
/// instrument. An *L filter* removes the waviness: the waves that are long compared with its nesting index $`\lambda_c`$. Both
/// filters together leave the S-L surface. Nesting indices are cut-off wavelengths (lengths, in the unit of the cell sides). The
/// weighted mean
///
/// ```math
/// \bar z(x, y) = \int s(\xi)\, s(\eta)\, z(x - \xi, y - \eta)\, \mathrm d\xi\, \mathrm d\eta , \qquad
/// s(\xi) = \frac{1}{\alpha \lambda_c}\, e^{-\pi (\xi/\alpha\lambda_c)^2} , \qquad
/// \alpha = \sqrt{\ln 2/\pi}
/// ```
///
/// transmits the fraction $`2^{-(\lambda_c/\lambda)^2}`$ of a wave of length $`\lambda`$. The fraction is one half at
/// $`\lambda = \lambda_c`$. An S filter returns $`\bar z`$, an L filter $`z - \bar z`$. The discrete weights have exactly this
/// transmission for every wave of the grid. For an index of eight cells or more the weights equal samples of $`s`$ to 3e-6 of the
/// largest weight. For an index of two cells the weights alternate in sign far from the middle. The cells are then too wide to
/// resolve a Gaussian.
///
/// | option | default |
/// |---|---|
/// | [`periodic`](Self::periodic) | no: the surface ends at its edges |
/// | [`along_x`](Self::along_x), [`along_y`](Self::along_y) | areal; a grid of one row or column is a profile |
///
/// # End effects
/// A periodic surface has no end effects. Otherwise the mean at a point is the weighted sum of the existing heights, divided by
/// the sum of the weights. This method is called zero-order regression. The mean is exact up to the edge for a constant, but not
/// for a tilt or a curvature. Therefore [`level`](super::level()) the surface first.
///
/// On a profile, 0.4 % of the weight lies beyond half a nesting index on either side. The fraction beyond a whole index is 5e-8.
/// Edges and holes affect the heights that are closer than half a nesting index. If both filters are set, the index of the L
/// filter applies. [`valid_range`](Self::valid_range) returns the remaining columns and rows, for use with
/// [`crop`](super::crop()).
///
/// Missing heights (NaN) have no weight and stay missing, so filter before [`fill_missing`](super::fill_missing).
///
/// # References
/// - ISO 16610-61 (areal), ISO 16610-21 (profiles), and ISO 25178-3 for the usual nesting indices.
/// - H. Knutsson and C.-F. Westin, Normalized and differential convolution, *Proc. IEEE Conf. Computer
///   Vision and Pattern Recognition* (1993) 515-523,
///   [doi:10.1109/CVPR.1993.341081](https://doi.org/10.1109/CVPR.1993.341081), for edges and missing heights.
///
/// ```
/// use std::f64::consts::TAU;
/// use stickslip::{Field, Grid, surface::GaussianFilter};
/// // Two waves, of 8 and of 64 micrometres.
/// let grid = Grid::square(128, 128.0)?;
/// let wave = |length: f64| Field::from_fn(grid, |x, _| (TAU * x / length).sin());
/// let measured = (&wave(8.0) + &wave(64.0))?;
/// let filtered = GaussianFilter::s(8.0).periodic().apply(&measured)?;
/// // Half of the short wave remains, and nearly all of the long wave.
/// let expected = (&wave(8.0).scaled(0.5) + &wave(64.0).scaled(0.5f64.powf(1.0 / 64.0)))?;
/// let pairs = filtered.heights().iter().zip(expected.iter());
/// assert!(pairs.into_iter().all(|(a, b)| (a - b).abs() < 1e-13));
/// # Ok::<(), stickslip::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(deny_unknown_fields)
)]
pub struct GaussianFilter {
    s: Option<f64>,
    l: Option<f64>,
    is_periodic: bool,
    /// Whether heights along x and along y are averaged.
    along: [bool; 2],
}

checked_struct! {
    /// A filtered surface and the waves that the filter has removed. Their sum is the original surface, to round-off.
    #[derive(Debug, Clone, PartialEq)]
    pub struct Filtered {
        heights: Field,
        short_waves: Option<Field>,
        long_waves: Option<Field>,
    }
    #[serde(remote = "Filtered", deny_unknown_fields)]
    check(read) {
        let grid = read.heights.grid();
        let mut waves = read.short_waves.iter().chain(&read.long_waves);
        waves.try_for_each(|waves| grid.check_equal("waves", waves.grid()))
    }
}

impl Filtered {
    /// Returns the filtered heights (lengths). Missing heights stay missing.
    #[must_use]
    pub fn heights(&self) -> &Field {
        &self.heights
    }

    /// Returns the short waves that the S filter has removed (lengths), such as noise, or `None` without an S filter.
    #[must_use]
    pub fn short_waves(&self) -> Option<&Field> {
        self.short_waves.as_ref()
    }

    /// Returns the long waves that the L filter has removed (lengths): the waviness. These waves do not include the waves that an
    /// S filter has removed. Returns `None` without an L filter.
    #[must_use]
    pub fn long_waves(&self) -> Option<&Field> {
        self.long_waves.as_ref()
    }

    /// Returns the filtered heights without the removed waves.
    #[must_use]
    pub fn into_heights(self) -> Field {
        self.heights
    }
}

impl GaussianFilter {
    /// Creates an S filter, which removes short waves. `nesting_index` is the cut-off wavelength (a length).
    #[must_use]
    pub fn s(nesting_index: f64) -> Self {
        Self::new(Some(nesting_index), None)
    }

    /// Creates an L filter, which removes long waves. `nesting_index` is the cut-off wavelength (a length).
    #[must_use]
    pub fn l(nesting_index: f64) -> Self {
        Self::new(None, Some(nesting_index))
    }

    /// Creates a filter that leaves the S-L surface. The filter first removes the waves that are short compared with `s`, then
    /// the waves that are long compared with `l` (lengths).
    #[must_use]
    pub fn sl(s: f64, l: f64) -> Self {
        Self::new(Some(s), Some(l))
    }

    fn new(s: Option<f64>, l: Option<f64>) -> Self {
        Self {
            s,
            l,
            is_periodic: false,
            along: [true; 2],
        }
    }

    /// Treats the surface as periodic (default no), so that its edges have no effect.
    #[must_use]
    pub fn periodic(mut self) -> Self {
        self.is_periodic = true;
        self
    }

    /// Filters each row separately, as a profile along x.
    #[must_use]
    pub fn along_x(mut self) -> Self {
        self.along = [true, false];
        self
    }

    /// Filters each column separately, as a profile along y.
    #[must_use]
    pub fn along_y(mut self) -> Self {
        self.along = [false, true];
        self
    }

    /// Returns the columns and rows farther than half a nesting index from every edge, where no edge affects the
    /// result. The ranges can be passed to [`crop`](super::crop()).
    ///
    /// If both filters are set, the index of the L filter is used. A range is empty if the surface is shorter than the
    /// index.
    #[must_use]
    pub fn valid_range(&self, grid: Grid) -> [Range<usize>; 2] {
        let [nx, ny] = grid.size();
        let range = |axis: usize, cells: usize, side: f64| {
            let has_edges = cells > 1 && self.along[axis] && !self.is_periodic;
            let length = if has_edges { 0.5 * self.longest() } else { 0.0 };
            let margin = cells_in(length, side).min(cells);
            margin..(cells - margin).max(margin)
        };
        [range(0, nx, grid.dx()), range(1, ny, grid.dy())]
    }

    /// Filters a surface. A slab of a distributed surface is treated as a separate surface.
    ///
    /// # Errors
    /// - [`Error::NotPositive`] if a nesting index is not positive and finite.
    /// - [`Error::BelowMinimum`] if a nesting index is shorter than two cells, or longer than the side of the surface along a
    ///   filtered axis. The error is also returned if the index of the S filter exceeds the index of the L filter.
    /// - [`Error::Sample`] with the first infinite height.
    /// - [`Error::Undetermined`] if all heights are missing.
    /// - [`Error::NotFinite`] if the range of the heights overflows.
    /// - [`Error::Memory`] if the memory for the filtered surface cannot be allocated.
    pub fn apply(&self, heights: &Field) -> Result<Filtered> {
        let grid = Slab::alone(heights)?.whole();
        self.check(grid)?;
        finite_or_missing(heights)?;
        let cells = grid.cells();
        let known = heights.iter().filter(|z| !z.is_nan()).count();
        if known == 0 {
            return Err(Error::Undetermined {
                quantity: "surface",
                unknowns: cells,
                known,
            });
        }
        memory(
            "the filtered surface",
            self.torus(grid, self.longest()),
            BYTES,
        )?;
        // Heights are relative to the lowest height, so that a flat surface is exactly zero. The unit is the range, so that no
        // sum overflows.
        let datum = heights.min();
        let range = finite("range of the heights", heights.max() - datum)?;
        let unit = if range > 0.0 { range } else { 1.0 };
        let mut rest = heights.map(|z| (z - datum) / unit);
        let lengths = |field: &Field, datum: f64| field.map(|z| datum + unit * z);
        let mut short_waves = None;
        if let Some(index) = self.s {
            let mean = self.mean(&rest, grid, index);
            short_waves = Some(lengths(&rest.minus(&mean)?, 0.0));
            rest = mean;
        }
        let mut long_waves = None;
        let mut datum_left = datum;
        if let Some(index) = self.l {
            let mean = self.mean(&rest, grid, index);
            long_waves = Some(lengths(&mean, datum));
            rest = rest.minus(&mean)?;
            datum_left = 0.0;
        }
        Ok(Filtered {
            heights: lengths(&rest, datum_left),
            short_waves,
            long_waves,
        })
    }

    /// Returns the longer nesting index.
    fn longest(&self) -> f64 {
        self.l.or(self.s).unwrap_or_default()
    }

    fn check(&self, grid: Grid) -> Result<()> {
        let indices = [
            ("nesting index of the S filter", self.s),
            ("nesting index of the L filter", self.l),
        ];
        let sides = [
            ("side of the surface along x", grid.nx(), grid.dx()),
            ("side of the surface along y", grid.ny(), grid.dy()),
        ];
        for (name, index) in indices {
            let Some(index) = index else { continue };
            positive(name, index)?;
            for (axis, (side, cells, cell)) in sides.into_iter().enumerate() {
                if cells > 1 && self.along[axis] {
                    at_least("two cells", 2.0 * cell, name, index)?;
                    at_least(name, index, side, cells as f64 * cell)?;
                }
            }
        }
        if let [(s_filter, Some(s)), (l_filter, Some(l))] = indices {
            at_least(s_filter, s, l_filter, l)?;
        }
        Ok(())
    }

    /// Returns the size of the periodic grid of the transform. The surface is padded with enough cells that opposite ends do not
    /// interact.
    fn torus(&self, grid: Grid, index: f64) -> [usize; 2] {
        let sides = [grid.dx(), grid.dy()];
        let mut torus = grid.size();
        for (axis, cells) in torus.iter_mut().enumerate() {
            if *cells > 1 && self.along[axis] && !self.is_periodic {
                *cells = smooth_length(*cells + cells_in(REACH * index, sides[axis]));
            }
        }
        torus
    }

    /// Computes the weighted mean around every known height.
    fn mean(&self, z: &Field, grid: Grid, index: f64) -> Field {
        let has_holes = z.iter().any(|z| z.is_nan());
        let torus = grid.of_size(self.torus(grid, index));
        let passed = |of: &(dyn Fn(f64) -> f64 + Sync)| {
            let mut waves = Waves::of(&placed(z, torus, of));
            waves.update(|mode, amplitude| amplitude * self.transmission(mode, index));
            waves.into_field()
        };
        parallel::enter_with(torus.cells(), || {
            let sums = passed(&|z| if z.is_nan() { 0.0 } else { z });
            let weights = (has_holes || !self.is_periodic)
                .then(|| passed(&|z| if z.is_nan() { 0.0 } else { 1.0 }));
            let mut mean = z.clone();
            let (nx, width) = (grid.nx(), torus.nx());
            for (row, out) in mean.as_mut_slice().chunks_exact_mut(nx).enumerate() {
                for (column, z) in out.iter_mut().enumerate().filter(|(_, z)| !z.is_nan()) {
                    let cell = row * width + column;
                    let weight = weights.as_ref().map_or(1.0, |field| field.as_slice()[cell]);
                    *z = sums.as_slice()[cell] / weight;
                }
            }
            mean
        })
    }

    /// Returns the fraction of a wave that the weighted mean transmits.
    fn transmission(&self, mode: Mode, index: f64) -> f64 {
        let component = |axis: usize| {
            if self.along[axis] {
                mode.wave_vector[axis]
            } else {
                0.0
            }
        };
        let over_cut_off = component(0).hypot(component(1)) * index / TAU;
        (-over_cut_off * over_cut_off).exp2()
    }
}

/// Returns the number of cells that a length covers, partly or fully.
fn cells_in(length: f64, side: f64) -> usize {
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "a length beyond all numbers covers as many cells as there are"
    )]
    let cells = (length / side).ceil() as usize;
    cells
}

/// Evaluates a function of the heights in the first columns and rows of a larger grid. The other cells are zero.
fn placed(z: &Field, torus: Grid, f: &(dyn Fn(f64) -> f64 + Sync)) -> Field {
    let mut placed = Field::zeros(torus);
    let rows = placed.as_mut_slice().chunks_exact_mut(torus.nx());
    for (out, row) in rows.zip(z.rows()) {
        for (out, &z) in out.iter_mut().zip(row) {
            *out = f(z);
        }
    }
    placed
}
