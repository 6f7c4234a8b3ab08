//! How far an iterate can be from the minimum, from one product.
//!
//! The page of the module [`cgm`](crate::cgm) derives the bound.

use std::ops::Range;

use crate::cgm::constraint::Constraint;
use crate::parallel;
use crate::report::Report;

/// What one fresh product says about an iterate.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Certificate {
    /// Largest displacement among the entries that can move, what all residuals are measured by.
    pub(crate) displacement: f64,
    /// Largest complementarity residual over that.
    pub(super) residual: f64,
    /// Bound on `E^2 / (x' C x)`.
    pub(super) gap: f64,
    /// `|sum x - total| / sum |x|`.
    pub(super) load_error: f64,
    /// Entries strictly between their bounds.
    pub(super) free: usize,
}

impl Certificate {
    /// From the largest displacement, violation and unknown; the sums `x'Cx`, `x'x` and `|x|`; the bound of
    /// the error `E`; what is missing of the total; the smallest eigenvalue known; and the free entries.
    pub(super) fn new(
        [displacement, violated, largest]: [f64; 3],
        [energy, squares, magnitude]: [f64; 3],
        bound: f64,
        missing: f64,
        lower_bound: f64,
        free: usize,
    ) -> Self {
        // An operator that maps constants to zero leaves a uniform answer neither displacement nor energy
        // to measure by; what its smallest eigenvalue would make of it takes their place.
        let displacement = larger(displacement, lower_bound * largest);
        let energy = larger(energy, lower_bound * squares);
        Self {
            displacement,
            residual: ratio(violated, displacement),
            gap: ratio(bound * bound, energy),
            load_error: ratio(missing, magnitude),
            free,
        }
    }

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

    /// The residual measured by another displacement.
    pub(crate) fn residual_over(&self, displacement: f64) -> f64 {
        ratio(self.residual * self.displacement, displacement)
    }

    pub(crate) fn write_to(&self, report: &mut Report) {
        report.residual = self.residual;
        report.certified_gap = self.gap;
        report.load_error = self.load_error;
    }
}

/// The part of a gradient that complementarity forbids at this value.
pub(super) fn violation(value: f64, [lower, upper]: [f64; 2], gradient: f64) -> f64 {
    if lower >= upper {
        0.0
    } else if value <= lower {
        gradient.min(0.0)
    } else if value >= upper {
        gradient.max(0.0)
    } else {
        gradient
    }
}

/// Examines a feasible `x` with its fresh product `C x`.
pub(crate) fn examine(
    x: &[f64],
    product: &[f64],
    linear: &[f64],
    constraint: &impl Constraint,
    total: Option<f64>,
    multiplier: f64,
    lower_bound: f64,
) -> Certificate {
    let leaf = |range: Range<usize>| {
        let sums = Sums::of(&x[range.clone()], &product[range.clone()]);
        let cells = x[range.clone()]
            .iter()
            .zip(&product[range.clone()])
            .zip(&linear[range.clone()]);
        let mut found = Findings::default();
        for (i, ((&x, &u), &b)) in range.zip(cells) {
            found.add(i, x, u, u + b - multiplier, constraint, lower_bound);
        }
        (sums, found)
    };
    let (sums, found) = parallel::fold(x.len(), leaf, |a, b| (a.0.merge(b.0), a.1.merge(b.1)));
    let load = total.map_or(0.0, |total| (sums.sum - total).abs());
    let bound = 0.5 * found.squares.sqrt() + (0.25 * found.squares + found.dual).sqrt();
    Certificate::new(
        [found.displacement, found.violated, found.largest],
        [sums.energy, sums.squares, sums.magnitude],
        bound,
        load,
        lower_bound,
        found.free,
    )
}

/// What all entries add up to.
#[derive(Clone, Copy)]
struct Sums {
    /// `x' C x`.
    energy: f64,
    squares: f64,
    sum: f64,
    magnitude: f64,
}

impl Sums {
    /// In lanes, so that many are added at a time.
    fn of(x: &[f64], product: &[f64]) -> Self {
        const LANES: usize = 4;
        let (mut energy, mut squares) = ([0.0; LANES], [0.0; LANES]);
        let (mut sum, mut magnitude) = ([0.0; LANES], [0.0; LANES]);
        for (xs, us) in x.chunks(LANES).zip(product.chunks(LANES)) {
            for (lane, (x, u)) in xs.iter().zip(us).enumerate() {
                energy[lane] += x * u;
                squares[lane] += x * x;
                sum[lane] += x;
                magnitude[lane] += x.abs();
            }
        }
        Self {
            energy: energy.iter().sum(),
            squares: squares.iter().sum(),
            sum: sum.iter().sum(),
            magnitude: magnitude.iter().sum(),
        }
    }

    fn merge(self, other: Self) -> Self {
        Self {
            energy: self.energy + other.energy,
            squares: self.squares + other.squares,
            sum: self.sum + other.sum,
            magnitude: self.magnitude + other.magnitude,
        }
    }
}

/// What the entries that can move show.
#[derive(Clone, Copy, Default)]
struct Findings {
    /// Largest displacement, largest violation and largest unknown.
    displacement: f64,
    violated: f64,
    largest: f64,
    free: usize,
    /// The two shares of the bound, `A` and `B^2`.
    dual: f64,
    squares: f64,
}

impl Findings {
    fn add(
        &mut self,
        i: usize,
        x: f64,
        u: f64,
        g: f64,
        constraint: &impl Constraint,
        lower_bound: f64,
    ) {
        let bounds = constraint.bounds(i);
        if bounds[0] < bounds[1] {
            // The minimum or maximum of a NaN and a number is the number: pass it on by hand.
            let violated = if g.is_nan() {
                g
            } else {
                violation(x, bounds, g)
            };
            self.displacement = larger(self.displacement, u.abs());
            self.violated = larger(self.violated, violated.abs());
            self.largest = larger(self.largest, x.abs());
            self.free += usize::from(x > bounds[0] && x < bounds[1]);
            if violated != 0.0 {
                // Either share is valid; each is taken where it is the smaller.
                let dual = g * x - constraint.least_product(i, g);
                let square = violated * violated / lower_bound;
                if dual <= square {
                    self.dual += dual.max(0.0);
                } else {
                    self.squares += square;
                }
            }
        }
    }

    fn merge(self, other: Self) -> Self {
        Self {
            displacement: larger(self.displacement, other.displacement),
            violated: larger(self.violated, other.violated),
            largest: larger(self.largest, other.largest),
            free: self.free + other.free,
            dual: self.dual + other.dual,
            squares: self.squares + other.squares,
        }
    }
}

/// The larger of two numbers; NaN if either is.
fn larger(a: f64, b: f64) -> f64 {
    if b > a || b.is_nan() { b } else { a }
}

/// `a / b`, zero when `a` is; NaN if either is, so that a broken product is seen.
fn ratio(a: f64, b: f64) -> f64 {
    if a == 0.0 && !b.is_nan() {
        0.0
    } else if b < 0.0 {
        f64::INFINITY
    } else {
        a / b
    }
}
