//! Error certificate of an iterate: a bound on its distance from the minimum. The bound is computed from one product, with the
//! duality (Frank-Wolfe) gap and the smallest eigenvalue.
//!
//! The documentation of the module [`cgm`](crate::cgm) derives the bound.

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

/// Certificate of an iterate from one recomputed product.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Certificate {
    /// Largest displacement among the cells that can move. It is the scale of all residuals.
    pub(crate) displacement: f64,
    /// Largest complementarity residual, relative to the displacement.
    pub(super) residual: f64,
    /// Bound on `E^2 / (x' C x)`.
    pub(super) gap: f64,
    /// Deviation from the prescribed sums, relative to `sum |x|`.
    pub(super) load_error: f64,
    /// Number of cells inside their bounds.
    pub(super) free: usize,
}

impl Certificate {
    /// Returns the quantity that must fall to the tolerance: the largest of residual, load error and certified error. The
    /// certified error is included only if the operator provides a bound on its smallest eigenvalue. Without this bound only the
    /// duality gap would be available. Its square root falls only with the square root of the residual.
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

/// An iterate and its product.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Iterate<'a, const N: usize> {
    pub(crate) layout: &'a Layout,
    /// The unknowns, each in its set.
    pub(crate) x: [&'a [f64]; N],
    /// `C x`.
    pub(crate) product: [&'a [f64]; N],
    /// `b`, before the datum is subtracted.
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

/// Range of unknowns and displacements whose squares neither overflow nor underflow in a sum over all cells. The range leaves a
/// margin for squares of small fractions of these values.
const ORDINARY: RangeInclusive<f64> = 1e-140..=1e140;

/// Measures of a feasible iterate, in the units of its problem.
#[derive(Debug, Clone, Copy)]
pub(crate) struct IterateMeasures {
    /// Largest gradient that complementarity does not allow.
    pub(crate) forbidden: f64,
    /// Largest displacement among the cells that can move. `least_displacement` replaces a smaller value.
    displacement: f64,
    least_displacement: f64,
    /// Largest components of the unknowns, of the displacements and of the forbidden gradients among the cells that can move.
    sizes: [f64; 3],
    /// Bound `E` of the error in the energy norm.
    pub(crate) bound: f64,
    /// Energy `x' C x`. `least_energy` replaces a smaller value.
    energy: f64,
    least_energy: f64,
    /// Deviation from the prescribed sums, relative to `sum |x|`.
    pub(crate) load_error: f64,
    /// Number of cells inside their bounds.
    pub(crate) free: usize,
}

impl IterateMeasures {
    /// Returns the displacement to which residuals are relative.
    pub(crate) fn measure(&self) -> f64 {
        larger(self.displacement, self.least_displacement)
    }

    /// Returns the energy to which the square of the bound is relative.
    pub(crate) fn measured_energy(&self) -> f64 {
        larger(self.energy, self.least_energy)
    }

    /// Returns the square of the bound divided by the energy, or infinity if sums of squares leave the range of `f64`.
    fn gap(&self) -> f64 {
        if self.has_squares() {
            ratio(self.bound * self.bound, self.measured_energy())
        } else {
            f64::INFINITY
        }
    }

    /// Returns whether the squares of unknowns and displacements are in the range of `f64`. The test includes the squares of
    /// small fractions of these values. A NaN counts as in range because it propagates to the result.
    pub(crate) fn has_squares(&self) -> bool {
        let [unknown, displacement, gradient] = self.sizes;
        // Gradients far below the displacements may underflow, because their residuals are negligible.
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
        of_all,
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
    let ((energy, squares_of_all, sum, magnitude), found) = reduce::fold(
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
            (sums_in_lanes(&x, &product), found)
        },
        |a, b| (a.0.plus(b.0), a.1.merge(b.1)),
    );
    let missing: [f64; N] =
        std::array::from_fn(|c| totals[c].sum().map_or(0.0, |total| sum[c] - total));
    let cells = layout.of_all_ranks() as f64;
    let squares = (0..N).fold(found.squares, |squares, c| {
        totals[c].compliance().map_or(squares, |compliance| {
            squares + by_spring(found.pushed[c], cells, compliance, (lower_bound, mean))
        })
    });
    let bound = 0.5 * squares.sqrt() + (0.25 * squares + found.dual).sqrt();
    // If an operator maps constants to zero, uniform unknowns have no displacement and no energy that could be the scale. The
    // stretch of a spring, or the displacement computed from the smallest eigenvalue, then serves as the scale.
    let springs = totals.into_iter().filter_map(Total::compliance);
    let stretch = springs
        .reduce(f64::min)
        .map(|compliance| compliance * magnitude);
    let least_displacement = stretch.unwrap_or(lower_bound * found.largest);
    // A single periodic cell does not deform at all. The gradient itself is then the scale.
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
        // The magnitude of a single component is the component itself, so the other measures contain its size.
        sizes: if N == 1 {
            [found.largest, found.displacement, found.forbidden]
        } else {
            found.sizes
        },
        least_displacement: larger(least_displacement, slope),
        bound,
        energy,
        least_energy: larger(of_all * squares_of_all, slope * magnitude),
        load_error: ratio(norm(missing), magnitude),
        free: found.free,
    }
}

/// Returns the change of the bound `B^2` caused by a spring, for gradients whose sum is `pushed`. The mean of these gradients is
/// divided by the smallest eigenvalue or by the compliance `n c` of uniform unknowns. The function uses `n c` if this reduces the
/// bound or if the operator maps constants to zero.
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
    // The factor increases the bound by more than the round-off of the sums.
    (1.0 + 1e-12_f64.copysign(change)) * (pushed * pushed / cells * change)
}

/// Sums over all cells: `x' C x`, the squares, each component and the magnitudes.
type CertificateSums<const N: usize> = (f64, f64, [f64; N], f64);

/// Computes the sums in lanes, so that several additions overlap.
fn sums_in_lanes<const N: usize>(x: &[&[f64]; N], product: &[&[f64]; N]) -> CertificateSums<N> {
    const LANES: usize = 4;
    let of = |x: [f64; N], u: [f64; N]| (dot(x, u), dot(x, x), x, norm(x));
    let cells = x[0].len();
    let whole = cells - cells % LANES;
    let mut lanes = [CertificateSums::ZERO; LANES];
    for first in (0..whole).step_by(LANES) {
        // Slicing once avoids a bounds check for every cell of the group.
        let group = first..first + LANES;
        let [x, product] = [x, product].map(|vector| within(vector, &group));
        for (k, lane) in lanes.iter_mut().enumerate() {
            *lane = lane.plus(of(at(&x, k), at(&product, k)));
        }
    }
    for (k, lane) in (whole..cells).zip(&mut lanes) {
        *lane = lane.plus(of(at(x, k), at(product, k)));
    }
    lanes
        .into_iter()
        .fold(CertificateSums::ZERO, Reduction::plus)
}

/// Measures of the cells that can move.
#[derive(Clone, Copy)]
struct CertificateMeasures<const N: usize> {
    /// Largest displacement, forbidden gradient and unknown.
    displacement: f64,
    forbidden: f64,
    largest: f64,
    free: usize,
    /// Largest components of the unknowns, displacements and forbidden gradients, or zero for a single component.
    sizes: [f64; 3],
    /// The two contributions to the bound, `A` and `B^2`.
    dual: f64,
    squares: f64,
    /// Sum of the forbidden gradients in the second contribution.
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
        // NaN in the displacement is also in the gradient, and NaN in the unknown is also in the energy.
        self.displacement = larger_number(self.displacement, norm(u));
        self.forbidden = larger_size(self.forbidden, forbidden);
        self.largest = larger_number(self.largest, norm(x));
        if N > 1 {
            for (size, of) in self.sizes.iter_mut().zip([x, u, pushing]) {
                *size = of
                    .iter()
                    .fold(*size, |size, part| larger_size(size, part.abs()));
            }
        }
        self.free += usize::from(set.is_inside(x));
        if forbidden != 0.0 {
            // Both contributions are valid, and the smaller contribution is used.
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

/// Returns the larger of two magnitudes, or NaN if either is NaN. The bit patterns of magnitudes have the order of their values,
/// and their comparison takes fewer instructions than a comparison that detects NaN.
#[inline]
fn larger_size(a: f64, b: f64) -> f64 {
    f64::from_bits(a.to_bits().max(b.to_bits()))
}

/// Returns the larger of two numbers, or `a` if `b` is NaN. The selection is one instruction.
#[inline]
fn larger_number(a: f64, b: f64) -> f64 {
    if b > a { b } else { a }
}

/// Returns `a / b`, zero if `a` is zero, or infinity if `b` is not positive. Returns NaN if `a` or `b` is NaN, so that an invalid
/// product is detected.
fn ratio(a: f64, b: f64) -> f64 {
    if a == 0.0 && !b.is_nan() {
        0.0
    } else if b <= 0.0 && !a.is_nan() {
        f64::INFINITY
    } else {
        a / b
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn merit_with_nan_in_any_vector_is_nan() {
        use crate::cgm::AbsBound;
        use crate::report::EigenvalueBound;
        let layout = Layout::flat(3);
        let values = [0.5, 0.25, 0.125];
        let with_nan = [0.5, f64::NAN, 0.125];
        for place in 0..4 {
            let vector = |k: usize| if k == place { &with_nan } else { &values };
            let iterate = Iterate {
                layout: &layout,
                x: [vector(0)],
                product: [vector(1)],
                linear: [vector(2)],
                datum: [0.0],
                totals: [Total::Free],
                multiplier: [0.0],
            };
            for value in [0.0, 1.0] {
                let lower_bound = LowerBound {
                    value,
                    of_all: value,
                    known: EigenvalueBound::Stated,
                    mean: MeanBound::Operator,
                };
                let found = examine(&iterate, &AbsBound(&[1.0; 3]), lower_bound);
                assert_eq!(found.merit(value).is_nan(), place < 3, "{place} {value}");
            }
        }
    }

    /// Uniform gradients behind a spring of compliance c have the exact value `B^2 = 1 / c`. A computed value below the exact
    /// value would not bound the error, and a negative value has no square root.
    #[test]
    fn spring_bound_of_uniform_gradients_is_not_below_exact_bound() {
        let (cells, lower_bound) = (64.0, 1.0);
        for mean in [MeanBound::Operator, MeanBound::Springs] {
            for decade in -6..=20 {
                let compliance = 10_f64.powi(decade);
                if matches!(mean, MeanBound::Operator) && cells * compliance < lower_bound {
                    continue;
                }
                let square =
                    cells / lower_bound + by_spring(cells, cells, compliance, (lower_bound, mean));
                assert!(
                    square >= 1.0 / compliance,
                    "{mean:?} {compliance:e}: {square:e}"
                );
            }
        }
    }
}
