//! How far an iterate can be from the minimum, from one product.
//!
//! The page of the module [`cgm`](crate::cgm) derives the bound.

use std::ops::RangeInclusive;

use crate::cgm::law::state::LinearisedSet;
use crate::cgm::reduce::{self, Reduction, larger};
use crate::cgm::totals::Total;
use crate::cgm::{Constraint, ConstraintSet};
use crate::numerics::cell_vector::{at, dot, norm, within};
use crate::operator::{LowerBound, MeanBound};
use crate::parallel::layout::Layout;
use crate::parallel::ranks::WireFormat;
use crate::report::Report;

/// What one recomputed product says about an iterate.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Certificate {
    /// Largest displacement among the cells that can move, what all residuals are measured by.
    pub(crate) displacement: f64,
    /// Largest complementarity residual over that.
    pub(super) residual: f64,
    /// Bound on `E^2 / (x' C x)`.
    pub(super) gap: f64,
    /// What is missing of the prescribed sums, over `sum |x|`.
    pub(super) load_error: f64,
    /// Cells inside their bounds.
    pub(super) free: usize,
}

impl Certificate {
    /// What has to fall to the tolerance: residual, load error and, where the operator knows its smallest
    /// eigenvalue, the certified error. Without that the duality gap alone is left, whose root falls only
    /// with the root of the residual.
    pub(super) fn merit(&self, lower_bound: f64) -> f64 {
        let error = if lower_bound > 0.0 {
            self.gap.sqrt()
        } else {
            0.0
        };
        let parts = [self.residual, self.load_error, error];
        if parts.iter().any(|part| part.is_nan()) {
            return f64::NAN;
        }
        parts.into_iter().fold(0.0, f64::max)
    }

    pub(crate) fn write_to(&self, report: &mut Report) {
        report.residual = self.residual;
        report.duality_gap = self.gap;
        report.load_error = self.load_error;
    }
}

/// An iterate and the product that belongs to it.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Iterate<'a, const N: usize> {
    pub(crate) layout: &'a Layout,
    /// The unknowns, each in its set.
    pub(crate) x: [&'a [f64]; N],
    /// `C x`.
    pub(crate) product: [&'a [f64]; N],
    /// `b`, from the datum.
    pub(crate) linear: [&'a [f64]; N],
    pub(crate) datum: [f64; N],
    pub(crate) totals: [Total; N],
    pub(crate) multiplier: [f64; N],
}

/// Examines a feasible iterate with its recomputed product.
pub(crate) fn examine<const N: usize>(
    iterate: &Iterate<'_, N>,
    constraint: &impl Constraint<N>,
    lower_bound: LowerBound,
) -> Certificate {
    let shown = measure(iterate, constraint, lower_bound);
    let displacement = shown.measure();
    Certificate {
        displacement,
        residual: ratio(shown.forbidden, displacement),
        gap: shown.gap(),
        load_error: shown.load_error,
        free: shown.free,
    }
}

/// Sizes of unknowns and displacements whose squares, and those of small parts, neither overflow nor vanish in a sum over
/// all cells.
const ORDINARY: RangeInclusive<f64> = 1e-140..=1e140;

/// What a feasible iterate shows, in the units of its problem.
#[derive(Debug, Clone, Copy)]
pub(crate) struct IterateMeasures {
    /// Largest gradient that complementarity does not allow.
    pub(crate) forbidden: f64,
    /// Largest displacement among the cells that can move, and what replaces it where it is less.
    displacement: f64,
    least_displacement: f64,
    /// Largest components among the same cells: of the unknowns, displacements and gradients that complementarity does not
    /// allow.
    sizes: [f64; 3],
    /// Bound `E` of the error in the energy norm.
    pub(crate) bound: f64,
    /// `x' C x`, and what replaces it where it is less.
    energy: f64,
    least_energy: f64,
    /// What is missing of the prescribed sums, over `sum |x|`.
    pub(crate) load_error: f64,
    /// Cells inside their bounds.
    pub(crate) free: usize,
}

impl IterateMeasures {
    /// The displacement that residuals are relative to.
    pub(crate) fn measure(&self) -> f64 {
        larger(self.displacement, self.least_displacement)
    }

    /// The energy that the square of the bound is relative to.
    pub(crate) fn measured_energy(&self) -> f64 {
        larger(self.energy, self.least_energy)
    }

    /// Returns the square of the bound over the energy, or infinity if sums of squares have left the range of numbers.
    fn gap(&self) -> f64 {
        if self.has_squares() {
            ratio(self.bound * self.bound, self.measured_energy())
        } else {
            f64::INFINITY
        }
    }

    /// Returns whether the squares of unknowns and displacements, and of small parts of them, are numbers. A NaN
    /// counts as such a number, because it reaches the result as NaN.
    pub(crate) fn has_squares(&self) -> bool {
        let [unknown, displacement, gradient] = self.sizes;
        // A gradient that is small compared with the displacements is a small residual.
        let moved = larger(displacement, gradient);
        let is_ordinary = |size: f64| size == 0.0 || size.is_nan() || ORDINARY.contains(&size);
        is_ordinary(unknown) && is_ordinary(moved)
    }
}

/// Measures a feasible iterate with its recomputed product.
pub(crate) fn measure<const N: usize>(
    iterate: &Iterate<'_, N>,
    constraint: &impl Constraint<N>,
    LowerBound {
        value: lower_bound,
        mean,
        ..
    }: LowerBound,
) -> IterateMeasures {
    let Iterate {
        layout,
        x,
        product,
        linear,
        datum,
        totals,
        multiplier,
    } = *iterate;
    let (sums, found) = reduce::fold(
        layout,
        |range| {
            let [x, product] = [&x, &product].map(|vector| within(vector, &range));
            let linear = within(&linear, &range);
            let mut found = CertificateMeasures::<N>::ZERO;
            for (k, cell) in range.enumerate() {
                let (u, b) = (at(&product, k), at(&linear, k));
                let g = std::array::from_fn(|c| u[c] + (b[c] - datum[c]) - multiplier[c]);
                found.add(at(&x, k), u, g, constraint.of(cell), lower_bound);
            }
            (CertificateSums::of(&x, &product), found)
        },
        |a, b| (a.0.plus(b.0), a.1.merge(b.1)),
    );
    let missing: [f64; N] =
        std::array::from_fn(|c| totals[c].sum().map_or(0.0, |total| sums.sum[c] - total));
    let cells = layout.of_all_ranks() as f64;
    let squares = (0..N).fold(found.squares, |squares, c| match totals[c] {
        Total::Spring { compliance, .. } => {
            squares + by_spring(found.pushed[c], cells, compliance, (lower_bound, mean))
        }
        Total::Free | Total::Sum(_) => squares,
    });
    let bound = 0.5 * squares.sqrt() + (0.25 * squares + found.dual).sqrt();
    // An operator that maps constants to zero leaves a uniform answer neither displacement nor energy to measure by.
    // What a spring stretches, or what the smallest eigenvalue would make of the answer, takes their place.
    let springs = totals.iter().filter_map(|total| match total {
        Total::Spring { compliance, .. } => Some(*compliance),
        Total::Free | Total::Sum(_) => None,
    });
    let stretch = springs
        .reduce(f64::min)
        .map(|compliance| compliance * sums.magnitude);
    let least_displacement = stretch.unwrap_or(lower_bound * found.largest);
    // A single cell that repeats does not deform at all: there the gradient itself is the measure.
    let is_rigid = found.displacement == 0.0 && least_displacement == 0.0 && found.largest > 0.0;
    let slope = if is_rigid {
        let gradient = |i| {
            let (u, b) = (at(&product, i), at(&linear, i));
            std::array::from_fn(|c| u[c] + (b[c] - datum[c]) - multiplier[c])
        };
        let can_move = |i| constraint.of(i).can_move();
        reduce::max(layout, |i| {
            if can_move(i) {
                norm::<N>(gradient(i))
            } else {
                0.0
            }
        })
    } else {
        0.0
    };
    IterateMeasures {
        forbidden: found.forbidden,
        displacement: found.displacement,
        sizes: found.sizes,
        least_displacement: larger(least_displacement, slope),
        bound,
        energy: sums.energy,
        least_energy: larger(lower_bound * sums.squares, slope * sums.magnitude),
        load_error: ratio(norm(missing), sums.magnitude),
        free: found.free,
    }
}

/// Returns how a spring changes the bound `B^2` of gradients whose sum is `pushed`. Their mean counts by the compliance
/// `n c` of a uniform unknown instead of the smallest eigenvalue: if that is less, or if the operator maps constants to zero.
fn by_spring(
    pushed: f64,
    cells: f64,
    compliance: f64,
    (lower_bound, mean): (f64, MeanBound),
) -> f64 {
    if pushed == 0.0 {
        return 0.0;
    }
    let change = 1.0 / (cells * compliance) - 1.0 / lower_bound;
    let change = match mean {
        MeanBound::Operator => change.min(0.0),
        MeanBound::OperatorWithSprings => 0.0,
        MeanBound::Springs => change,
    };
    // All parts are a little more than their mean.
    (1.0 - 1e-12_f64.copysign(change)) * (pushed * pushed / cells * change)
}

/// What all cells add up to.
#[derive(Clone, Copy)]
struct CertificateSums<const N: usize> {
    /// `x' C x`.
    energy: f64,
    squares: f64,
    sum: [f64; N],
    /// `sum |x|`.
    magnitude: f64,
}

impl<const N: usize> Reduction for CertificateSums<N> {
    #[inline]
    fn plus(self, other: Self) -> Self {
        Self {
            energy: self.energy + other.energy,
            squares: self.squares + other.squares,
            sum: self.sum.plus(other.sum),
            magnitude: self.magnitude + other.magnitude,
        }
    }
}

impl<const N: usize> CertificateSums<N> {
    /// In lanes, so that many are added at a time.
    fn of(x: &[&[f64]; N], product: &[&[f64]; N]) -> Self {
        const LANES: usize = 4;
        let of = |x: [f64; N], u: [f64; N]| Self {
            energy: dot(x, u),
            squares: dot(x, x),
            sum: x,
            magnitude: norm(x),
        };
        let cells = x[0].len();
        let whole = cells - cells % LANES;
        let mut lanes = [Self::ZERO; LANES];
        for first in (0..whole).step_by(LANES) {
            // One look at the length of a slice serves all cells of the group.
            let group = first..first + LANES;
            let [x, product] = [x, product].map(|vector| within(vector, &group));
            for (k, lane) in lanes.iter_mut().enumerate() {
                *lane = lane.plus(of(at(&x, k), at(&product, k)));
            }
        }
        for (k, lane) in (whole..cells).zip(&mut lanes) {
            *lane = lane.plus(of(at(x, k), at(product, k)));
        }
        lanes.into_iter().fold(Self::ZERO, Self::plus)
    }
}

impl<const N: usize> WireFormat for CertificateSums<N> {
    const COUNT: usize = 3 + N;
    const ZERO: Self = Self {
        energy: 0.0,
        squares: 0.0,
        sum: [0.0; N],
        magnitude: 0.0,
    };

    fn write(self, words: &mut Vec<u64>) {
        (self.energy, self.squares, self.sum, self.magnitude).write(words);
    }

    fn read(words: &mut &[u64]) -> Self {
        let (energy, squares, sum, magnitude) = WireFormat::read(words);
        Self {
            energy,
            squares,
            sum,
            magnitude,
        }
    }
}

/// What the cells that can move show.
#[derive(Clone, Copy)]
struct CertificateMeasures<const N: usize> {
    /// Largest displacement, forbidden gradient and unknown.
    displacement: f64,
    forbidden: f64,
    largest: f64,
    free: usize,
    /// Largest components of the unknowns, displacements and forbidden gradients.
    sizes: [f64; 3],
    /// The two shares of the bound, `A` and `B^2`.
    dual: f64,
    squares: f64,
    /// Sum of the forbidden gradients that the second share is made of.
    pushed: [f64; N],
}

impl<const N: usize> WireFormat for CertificateMeasures<N> {
    const COUNT: usize = 9 + N;
    const ZERO: Self = Self {
        displacement: 0.0,
        forbidden: 0.0,
        largest: 0.0,
        free: 0,
        sizes: [0.0; 3],
        dual: 0.0,
        squares: 0.0,
        pushed: [0.0; N],
    };

    fn write(self, words: &mut Vec<u64>) {
        (self.displacement, self.forbidden, self.largest, self.free).write(words);
        (self.sizes, self.dual, self.squares, self.pushed).write(words);
    }

    fn read(words: &mut &[u64]) -> Self {
        let (displacement, forbidden, largest, free) = WireFormat::read(words);
        let (sizes, dual, squares, pushed) = WireFormat::read(words);
        Self {
            displacement,
            forbidden,
            largest,
            free,
            sizes,
            dual,
            squares,
            pushed,
        }
    }
}

impl<const N: usize> CertificateMeasures<N> {
    #[inline]
    fn add<S: ConstraintSet<N>>(
        &mut self,
        x: [f64; N],
        u: [f64; N],
        g: [f64; N],
        set: S,
        lower_bound: f64,
    ) {
        if !set.can_move() {
            return;
        }
        let pushing = set.forbidden(x, g);
        let forbidden = norm(pushing);
        self.displacement = larger(self.displacement, norm(u));
        self.forbidden = larger(self.forbidden, forbidden);
        self.largest = larger(self.largest, norm(x));
        for (size, of) in self.sizes.iter_mut().zip([x, u, pushing]) {
            *size = of.iter().fold(*size, |size, part| larger(size, part.abs()));
        }
        self.free += usize::from(set.is_inside(x));
        if forbidden != 0.0 {
            // Either share is valid; each is taken where it is the smaller.
            let dual = set.duality_gap(x, g);
            let square = if lower_bound > 0.0 {
                forbidden * forbidden / lower_bound
            } else {
                f64::INFINITY
            };
            if dual <= square {
                self.dual += dual.max(0.0);
            } else {
                self.squares += square;
                self.pushed = self.pushed.plus(pushing);
            }
        }
    }

    fn merge(self, other: Self) -> Self {
        Self {
            displacement: larger(self.displacement, other.displacement),
            forbidden: larger(self.forbidden, other.forbidden),
            largest: larger(self.largest, other.largest),
            free: self.free + other.free,
            sizes: [0, 1, 2].map(|k| larger(self.sizes[k], other.sizes[k])),
            dual: self.dual + other.dual,
            squares: self.squares + other.squares,
            pushed: self.pushed.plus(other.pushed),
        }
    }
}

/// `a / b`, zero when `a` is, infinite where `b` is not positive; NaN if either is, so that a broken product is seen.
fn ratio(a: f64, b: f64) -> f64 {
    if a == 0.0 && !b.is_nan() {
        0.0
    } else if b <= 0.0 && !a.is_nan() {
        f64::INFINITY
    } else {
        a / b
    }
}
