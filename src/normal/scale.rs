//! Lengths and slopes of a contact compared with the limits of the small-slope theory.

use crate::cgm::reduce::{self, Reduction};
use crate::grid::Grid;
use crate::half_space::HalfSpace;
use crate::normal::closed_gap::{CLOSED, closed_cells};
use crate::normal::seam::mean_jumps;
use crate::warning::{LARGEST_SEAM, Warning};

/// Approach, contact radius, slope and pressure, stored as integers for warnings.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub(crate) struct Scale {
    /// Approach from the first touch divided by the longest side of the grid, in tenths.
    approach_tenths: usize,
    /// Contact radius divided by the radius of curvature, in thousandths.
    radius_per_mille: usize,
    /// Rms slope within the contact, or around it if it is at most two cells wide, in thousandths.
    slope_per_mille: usize,
    /// Largest pressure divided by the contact modulus, in thousandths.
    #[cfg_attr(feature = "serde", serde(default))]
    pressure_per_mille: usize,
    /// Contact modulus divided by the largest pressure.
    #[cfg_attr(feature = "serde", serde(default))]
    modulus_parts: usize,
    /// Mean jump of the gap across the border of a periodic grid along x and along y, over the largest mean step between
    /// neighbouring columns or rows.
    #[cfg_attr(feature = "serde", serde(default))]
    seam_times: [usize; 2],
    /// Number of contact cells whose gap is almost zero, if the gap resembles a gap under load.
    #[cfg_attr(feature = "serde", serde(default))]
    closed_cells: usize,
    /// Change of the gap before this solve like wear, divided by the largest displacement before and after it, in tenths.
    /// `None` for a small change.
    #[cfg_attr(feature = "serde", serde(default))]
    pub(super) gap_change_tenths: Option<usize>,
}

/// Largest value of each quantity for which no warning is given.
const LARGEST_APPROACH: usize = 10;
const LARGEST_RADIUS: usize = 300;
const LARGEST_SLOPE: usize = 500;

/// Sums over pairs of neighbours along an axis that are both in contact. The summands are 1, x, x^2, s, x s and s^2.
/// Here x is the middle of the pair, and s is the slope of the gap between the two cells.
type Slopes = [f64; 6];

/// Number of contact cells between two contact neighbours along an axis, number of pairs of a contact cell and a separated
/// neighbour, and sum of the squared slopes of these pairs.
type Surroundings = [f64; 3];

impl Scale {
    /// Measures the contact of a pressure over a gap before loading. Pairs of rows on different ranks do not count.
    pub(super) fn of(bodies: &HalfSpace, gap: &[f64], pressure: &[f64], approach: f64) -> Self {
        let grid = bodies.grid();
        let ([nx, ny], sides) = (grid.size(), [grid.dx(), grid.dy()]);
        let possibly_closed = CLOSED * grid.whole().longest_side();
        let (slopes, outer, [least, most], cells) = reduce::fold(
            &bodies.grid_layout(),
            |cells| {
                let (mut slopes, mut outer) =
                    ([Slopes::default(); 2], [Surroundings::default(); 2]);
                let (mut least, mut most) = (f64::INFINITY, 0.0_f64);
                let mut counts = [0, 0];
                for cell in cells.filter(|cell| pressure[*cell] > 0.0) {
                    (least, most) = (least.min(gap[cell]), most.max(pressure[cell]));
                    counts[0] += 1;
                    counts[1] += usize::from(gap[cell].abs() < possibly_closed);
                    let (column, row) = (cell % nx, cell / nx);
                    let next = [
                        (column + 1 < nx).then_some(cell + 1),
                        (row + 1 < ny).then_some(cell + nx),
                    ];
                    let last = [(column > 0).then(|| cell - 1), (row > 0).then(|| cell - nx)];
                    for (axis, pair) in next.into_iter().zip(last).enumerate() {
                        for outside in [pair.0, pair.1].into_iter().flatten() {
                            if pressure[outside] <= 0.0 {
                                let s = (gap[outside] - gap[cell]) / sides[axis];
                                outer[axis] = outer[axis].plus([0.0, 1.0, s * s]);
                            }
                        }
                        let is_in_contact =
                            |next: Option<usize>| next.is_some_and(|i| pressure[i] > 0.0);
                        if is_in_contact(pair.0) && is_in_contact(pair.1) {
                            outer[axis][0] += 1.0;
                        }
                        let Some(next) = pair.0.filter(|next| pressure[*next] > 0.0) else {
                            continue;
                        };
                        let x = grid.position(column, row)[axis] + 0.5 * sides[axis];
                        let s = (gap[next] - gap[cell]) / sides[axis];
                        slopes[axis] = slopes[axis].plus([1.0, x, x * x, s, x * s, s * s]);
                    }
                }
                (slopes, outer, [least, most], counts)
            },
            |(a, outer, [least, most], cells), (b, also, [lower, higher], more)| {
                let range = [least.min(lower), most.max(higher)];
                (a.plus(b), outer.plus(also), range, cells.plus(more))
            },
        );
        let grid = grid.whole();
        let radius = slopes.map(|slopes| radius_over_curvature(grid, slopes));
        let mean = |count: f64, squares: f64| squares / count.max(1.0);
        // Two cells next to a summit have equal heights, so that their slope is zero.
        let is_narrow = outer.iter().all(|[between, ..]| *between == 0.0);
        let squared = if is_narrow {
            outer.map(|[_, count, squares]| mean(count, squares))
        } else {
            slopes.map(|[count, .., squares]| mean(count, squares))
        };
        Self {
            approach_tenths: whole(10.0 * (approach - least) / grid.reference_side()),
            radius_per_mille: whole(1e3 * radius[0].max(radius[1])),
            slope_per_mille: whole(1e3 * (squared[0] + squared[1]).sqrt()),
            pressure_per_mille: whole(1e3 * most / bodies.pair().contact_modulus()),
            modulus_parts: whole(bodies.pair().contact_modulus() / most),
            seam_times: mean_jumps(bodies, gap, pressure).map(whole),
            closed_cells: closed_cells(bodies, (gap, pressure), most, cells),
            gap_change_tenths: None,
        }
    }

    /// Returns the larger value of each quantity.
    pub(crate) fn max(self, other: Self) -> Self {
        Self {
            approach_tenths: self.approach_tenths.max(other.approach_tenths),
            radius_per_mille: self.radius_per_mille.max(other.radius_per_mille),
            slope_per_mille: self.slope_per_mille.max(other.slope_per_mille),
            pressure_per_mille: self.pressure_per_mille.max(other.pressure_per_mille),
            modulus_parts: self.modulus_parts.max(other.modulus_parts),
            seam_times: [0, 1].map(|axis| self.seam_times[axis].max(other.seam_times[axis])),
            closed_cells: self.closed_cells.max(other.closed_cells),
            gap_change_tenths: self.gap_change_tenths.max(other.gap_change_tenths),
        }
    }

    /// Returns the contact modulus divided by the largest pressure, or zero without contact.
    pub(super) fn modulus_parts(self) -> usize {
        self.modulus_parts
    }

    /// Returns a warning for each value that is too large.
    pub(crate) fn warnings(self) -> impl Iterator<Item = Warning> {
        let Self {
            approach_tenths,
            radius_per_mille,
            slope_per_mille,
            pressure_per_mille,
            seam_times,
            closed_cells: cells,
            gap_change_tenths,
            ..
        } = self;
        let approach = Warning::ApproachBeyondGrid {
            tenths: approach_tenths,
        };
        let radius = Warning::LargeContactRadius {
            per_mille: radius_per_mille,
        };
        let slope = Warning::SteepSurface {
            per_mille: slope_per_mille,
        };
        let [along_x, along_y] = seam_times.map(|times| times > LARGEST_SEAM);
        let seam = Warning::PeriodicSeam {
            along_x,
            along_y,
            times: seam_times[0].max(seam_times[1]),
        };
        [
            (approach_tenths > LARGEST_APPROACH).then_some(approach),
            (radius_per_mille > LARGEST_RADIUS).then_some(radius),
            (slope_per_mille > LARGEST_SLOPE).then_some(slope),
            Warning::pressure_beyond(pressure_per_mille),
            (along_x || along_y).then_some(seam),
            (cells > 0).then_some(Warning::ClosedGap { cells }),
            gap_change_tenths.map(|tenths| Warning::LargeGapChange { tenths }),
        ]
        .into_iter()
        .flatten()
    }
}

/// Least fraction of the variance of the slope that the position must explain. A rough surface has slopes but no
/// curvature.
const EXPLAINED: f64 = 0.5;

/// Returns the contact radius times the regression coefficient of the slope on the position. Returns zero if the
/// position does not explain the slope. The radius follows from the standard deviation of the position. For a disc it
/// is twice the deviation, and for a line it is the square root of three times the deviation.
fn radius_over_curvature(grid: Grid, [count, x, xx, s, xs, ss]: Slopes) -> f64 {
    let [x, xx, s, xs, ss] = [x, xx, s, xs, ss].map(|sum| sum / count);
    let (deviation, spread) = ((xx - x * x).sqrt(), (ss - s * s).sqrt());
    let correlation = (xs - x * s) / deviation / spread;
    if correlation * correlation < EXPLAINED {
        return 0.0;
    }
    let is_line = grid.size().contains(&1);
    let reach = if is_line { 3.0_f64.sqrt() } else { 2.0 };
    reach * correlation * spread
}

/// Returns the nearest integer, or zero for a negative number. Also returns zero for a number that is not finite, which
/// occurs without contact.
#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "a negative number becomes zero, and a large one saturates"
)]
fn whole(value: f64) -> usize {
    if value.is_finite() {
        value.round() as usize
    } else {
        0
    }
}
