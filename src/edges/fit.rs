//! The quadratic that is zero at the edge, fitted to the cells about one.

use crate::edges::stencil::{
    FOURTH, LANES, POWERS, PRODUCT_OF, PRODUCTS, SECOND, SIDE, Square, Stencil, dot, product,
};

/// Unknowns: the quadratic, and a square of the distance outside.
const UNKNOWNS: usize = POWERS + 1;

/// Rounds in which the slope at the edge is found.
const ROUNDS: usize = 3;

/// Distance from the edge, in cells, within which values are not trusted: inside and outside.
const BLURRED_INSIDE: f64 = 0.8;
const BLURRED_OUTSIDE: f64 = 0.5;

/// Distance outside, in cells, from which the edge is in another cell.
const FAR_OUTSIDE: f64 = 1.2;

/// Weight of values that are not trusted, beside those that are.
const DISTRUSTED: f64 = 2e-3;

/// Distance from the edge, in cells, from which on values count less, and how fast.
const NEAR: f64 = 2.5;
const FADE: f64 = 1.5;

/// How far beyond that a value counts as nothing, in the same.
const NOTHING: f64 = 5.5;

/// Pull of the squares to zero: an edge without evidence is straight.
const STRAIGHT: f64 = 1e-3;

/// Subdivisions of a cell, along each axis, over which it is averaged.
const PARTS: usize = 8;

/// What is known of the cells about one, relative to the largest value of the grid.
pub(super) struct FitValues {
    /// Inside the square of the pressure, outside minus the power 2/3 of the gap times 3/4 over the unit of length and the
    /// largest pressure, without the modulus.
    pub(super) lifted: Square<f64>,
    pub(super) is_inside: Square<bool>,
    /// Whether all four neighbours of a cell are inside too.
    pub(super) is_core: Square<bool>,
    /// Those of the stencil, and none of the cells that are not known.
    pub(super) weights: Square<f64>,
}

/// What a round fits, by places: weights, those of values that are trusted, distances inside the edge, and squares of those
/// outside.
struct Sample {
    weights: Square<f64>,
    trusted: Square<f64>,
    distances: Square<f64>,
    squares: Square<f64>,
}

/// The fit about one cell, in units of the largest pressure and of a cell.
pub(super) struct Fit {
    coefficients: [f64; POWERS],
    /// Square of the slope factor K at the edge.
    square: f64,
    gradient: [f64; 2],
    /// Root mean square of what is missed, in cells.
    pub(super) missed: f64,
    /// Values that it is made of.
    pub(super) count: usize,
    /// Whether any of them lies outside the set.
    pub(super) has_outside: bool,
}

impl Fit {
    /// With the modulus for a direction of the normal of the edge; `None` where nothing is determined.
    pub(super) fn new(
        stencil: &Stencil,
        values: &FitValues,
        modulus: impl Fn([f64; 2]) -> f64,
    ) -> Option<Self> {
        let largest = values.lifted.iter().flatten().copied().fold(0.0, f64::max);
        let gradient = first_gradient(stencil, values)?;
        let mut fit = Self {
            coefficients: [0.0; POWERS],
            square: length(gradient).max(1e-3 * largest),
            gradient,
            missed: f64::INFINITY,
            count: 0,
            has_outside: false,
        };
        for round in 1..=ROUNDS {
            let sample = fit.sample(stencil, values, modulus(fit.normal()), round > 1)?;
            let solution = fit.refine(stencil, &sample)?;
            // The edge is in none of the further rounds in this cell.
            if round == ROUNDS || fit.distance([0.0; 2]) < -FAR_OUTSIDE {
                let counts = sample.trusted.iter().flatten();
                fit.count = counts.filter(|weight| **weight > 0.0).count();
                fit.has_outside = dot(&sample.trusted, &sample.squares) > 0.0;
                fit.missed = sample.misfit(stencil, solution);
                break;
            }
        }
        Some(fit)
    }

    fn normal(&self) -> [f64; 2] {
        let length = length(self.gradient);
        if length > 0.0 {
            self.gradient.map(|part| part / length)
        } else {
            [0.0; 2]
        }
    }

    /// The values with the slope known so far.
    fn sample(
        &self,
        stencil: &Stencil,
        values: &FitValues,
        modulus: f64,
        has_edge: bool,
    ) -> Option<Sample> {
        // Values next to nothing, or none, leave nothing to measure by.
        if !(self.square > 0.0 && self.square.is_finite()) {
            return None;
        }
        let inverse = 1.0 / self.square;
        let slope = (self.square * modulus).cbrt().powi(2) * inverse;
        let fitted = stencil.quadratic(self.coefficients.map(|part| part * inverse));
        let mut sample = Sample {
            weights: [[0.0; LANES]; SIDE],
            trusted: [[0.0; LANES]; SIDE],
            distances: [[0.0; LANES]; SIDE],
            squares: [[0.0; LANES]; SIDE],
        };
        for row in 0..SIDE {
            for k in 0..LANES {
                let is_inside = values.is_inside[row][k];
                let distance = values.lifted[row][k] * if is_inside { inverse } else { slope };
                let far = (distance.abs() - NEAR).max(0.0) * (1.0 / FADE);
                if far > NOTHING {
                    continue;
                }
                let fitted = fitted[row][k];
                let is_trusted = match (is_inside, has_edge) {
                    (true, false) => values.is_core[row][k] || distance > BLURRED_INSIDE,
                    (false, false) => distance < -BLURRED_OUTSIDE,
                    (true, true) => fitted > BLURRED_INSIDE,
                    (false, true) => distance < -BLURRED_OUTSIDE && fitted < -0.5 * BLURRED_OUTSIDE,
                };
                let fade = if far > 0.0 { (-far * far).exp() } else { 1.0 };
                let weight = values.weights[row][k] * fade;
                sample.weights[row][k] = weight * if is_trusted { 1.0 } else { DISTRUSTED };
                sample.trusted[row][k] = if is_trusted { weight } else { 0.0 };
                sample.distances[row][k] = distance;
                sample.squares[row][k] = if is_inside { 0.0 } else { distance * distance };
            }
        }
        Some(sample)
    }

    /// A round: the fit to a sample, and the slope at its edge.
    fn refine(&mut self, stencil: &Stencil, sample: &Sample) -> Option<[f64; UNKNOWNS]> {
        let solution = sample.least_squares(stencil)?;
        if !solution.iter().all(|part| part.is_finite()) {
            return None;
        }
        for (coefficient, part) in self.coefficients.iter_mut().zip(solution) {
            *coefficient = part * self.square;
        }
        let [c, x, y, xx, xy, yy] = self.coefficients;
        // The slope where the edge is nearest, by the tangent plane.
        let steepness = x * x + y * y;
        let step = |part: f64| {
            if steepness > 0.0 {
                (-c * part / steepness).clamp(-1.5, 1.5)
            } else {
                0.0
            }
        };
        let (u, v) = (step(x), step(y));
        self.gradient = [x + 2.0 * xx * u + xy * v, y + 2.0 * yy * v + xy * u];
        self.square = length(self.gradient).clamp(0.2 * self.square, 5.0 * self.square);
        Some(solution)
    }

    /// The squared pressure at a place from the middle of the cell.
    fn at(&self, [x, y]: [f64; 2]) -> f64 {
        let [c, cx, cy, cxx, cxy, cyy] = self.coefficients;
        c + x * (cx + cxx * x + cxy * y) + y * (cy + cyy * y)
    }

    /// Distance of a place inside the edge, in cells, as far as the slope there tells.
    pub(super) fn distance(&self, place: [f64; 2]) -> f64 {
        self.at(place) / self.square
    }

    pub(super) fn centre(&self) -> f64 {
        self.at([0.0; 2]).max(0.0).sqrt()
    }

    /// The part of the cell that is covered, and the mean of the pressure over the cell.
    pub(super) fn covered_and_mean(&self, sides: [f64; 2]) -> [f64; 2] {
        let part = |k: usize, side: f64| ((k as f64 + 0.5) / PARTS as f64 - 0.5) * side;
        // How much a part of the cell differs from its one side to the other.
        let across =
            (self.gradient[0].abs() * sides[0] + self.gradient[1].abs() * sides[1]) / PARTS as f64;
        let steepness = 1.0 / across.max(f64::MIN_POSITIVE);
        let (mut covered, mut sum) = (0.0, 0.0);
        for j in 0..PARTS {
            for i in 0..PARTS {
                let level = self.at([part(i, sides[0]), part(j, sides[1])]);
                covered += (0.5 + level * steepness).clamp(0.0, 1.0);
                sum += level.max(0.0).sqrt();
            }
        }
        [covered, sum].map(|total| total / (PARTS * PARTS) as f64)
    }
}

fn length([x, y]: [f64; 2]) -> f64 {
    x.hypot(y)
}

/// Slope of the squared pressure, by a plane through the cells inside.
fn first_gradient(stencil: &Stencil, values: &FitValues) -> Option<[f64; 2]> {
    let mut weights = values.weights;
    for (weight, is_inside) in weights
        .as_flattened_mut()
        .iter_mut()
        .zip(values.is_inside.as_flattened())
    {
        *weight *= f64::from(u8::from(*is_inside));
    }
    let sums: [f64; POWERS] = stencil.moments::<SECOND, POWERS>(&weights);
    let mut matrix = [[0.0; 3]; 3];
    for i in 0..3 {
        for j in 0..=i {
            matrix[i][j] = sums[PRODUCT_OF[i][j]];
        }
        matrix[i][i] += 1e-9;
    }
    let right = stencil.moments::<2, 3>(&product(&weights, &values.lifted));
    let [_, x, y] = solved(matrix, right)?;
    Some([x, y])
}

impl Sample {
    fn least_squares(&self, stencil: &Stencil) -> Option<[f64; UNKNOWNS]> {
        let right = product(&self.weights, &self.distances);
        let outside = product(&self.weights, &self.squares);
        let sums: [f64; PRODUCTS] = stencil.moments::<FOURTH, PRODUCTS>(&self.weights);
        let mut matrix = [[0.0; UNKNOWNS]; UNKNOWNS];
        for i in 0..POWERS {
            for j in 0..=i {
                matrix[i][j] = sums[PRODUCT_OF[i][j]];
            }
        }
        matrix[POWERS][..POWERS].copy_from_slice(&stencil.moments::<SECOND, POWERS>(&outside));
        matrix[POWERS][POWERS] = dot(&outside, &self.squares);
        for (i, row) in matrix.iter_mut().enumerate() {
            row[i] += 1e-12 + if i < 3 { 0.0 } else { STRAIGHT };
        }
        let [c, x, y, xx, xy, yy] = stencil.moments::<SECOND, POWERS>(&right);
        solved(matrix, [c, x, y, xx, xy, yy, dot(&right, &self.squares)])
    }

    /// Root mean square of what a solution misses, in cells.
    fn misfit(&self, stencil: &Stencil, [c, x, y, xx, xy, yy, outside]: [f64; UNKNOWNS]) -> f64 {
        let mut missed = stencil.quadratic([c, x, y, xx, xy, yy]);
        let places = self
            .distances
            .as_flattened()
            .iter()
            .zip(self.squares.as_flattened());
        for (missed, (distance, square)) in missed.as_flattened_mut().iter_mut().zip(places) {
            *missed += outside * square - distance;
        }
        let [sum] = stencil.moments::<1, 1>(&self.trusted);
        if sum > 0.0 {
            (dot(&product(&self.trusted, &missed), &missed) / sum).sqrt()
        } else {
            f64::INFINITY
        }
    }
}

/// The solution of a positive definite system of which the lower triangle is given, by Cholesky; `None` for another.
fn solved<const N: usize>(mut matrix: [[f64; N]; N], mut right: [f64; N]) -> Option<[f64; N]> {
    // The diagonal holds reciprocals.
    for i in 0..N {
        for j in 0..=i {
            let done: f64 = (0..j).map(|k| matrix[i][k] * matrix[j][k]).sum();
            let rest = matrix[i][j] - done;
            matrix[i][j] = if i > j {
                rest * matrix[j][j]
            } else if rest > 0.0 {
                1.0 / rest.sqrt()
            } else {
                return None;
            };
        }
        let done: f64 = (0..i).map(|k| matrix[i][k] * right[k]).sum();
        right[i] = (right[i] - done) * matrix[i][i];
    }
    for i in (0..N).rev() {
        let done: f64 = (i + 1..N).map(|k| matrix[k][i] * right[k]).sum();
        right[i] = (right[i] - done) * matrix[i][i];
    }
    Some(right)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grid::Grid;

    /// Pressures whose squares underflow, everywhere about a cell, give nothing to fit.
    #[test]
    fn values_next_to_nothing_have_no_fit() {
        let stencil = Stencil::new(Grid::square(8, 8.0).unwrap(), [false; 2]);
        for lifted in [0.0, f64::INFINITY] {
            let values = FitValues {
                lifted: [[lifted; LANES]; SIDE],
                is_inside: [[true; LANES]; SIDE],
                is_core: [[true; LANES]; SIDE],
                weights: stencil.weights,
            };
            assert!(Fit::new(&stencil, &values, |_| 1.0).is_none(), "{lifted}");
        }
    }
}
