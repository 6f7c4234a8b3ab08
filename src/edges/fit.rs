//! The quadratic that is zero at the edge, fitted to the cells around a cell.

use crate::edges::stencil::{
    FOURTH, FitStencil, LANES, POWERS, PRODUCT_OF, PRODUCTS, SECOND, SIDE, Square, dot, product,
};

/// Number of unknowns: the coefficients of the quadratic and the coefficient of the squared distance outside.
const UNKNOWNS: usize = POWERS + 1;

/// Number of rounds in which the slope at the edge is determined.
const ROUNDS: usize = 3;

/// Distance from the edge, in cells, within which the values of cells inside are unreliable.
const BLURRED_INSIDE: f64 = 0.8;
/// Distance from the edge, in cells, within which the values of cells outside are unreliable.
const BLURRED_OUTSIDE: f64 = 0.5;

/// Distance of a cell centre outside the edge, in cells, beyond which the edge is in a different cell.
const FAR_OUTSIDE: f64 = 1.2;

/// Weight of unreliable values, relative to reliable values.
const DISTRUSTED: f64 = 2e-3;

/// Distance from the edge, in cells, beyond which weights decrease.
const NEAR: f64 = 2.5;
/// Length scale of the decrease of the weights, in cells.
const FADE: f64 = 1.5;

/// Distance beyond `NEAR`, in units of `FADE`, at which the weight becomes zero.
const NOTHING: f64 = 5.5;

/// Regularisation of the second-degree terms. It makes the edge straight if the values do not determine its curvature.
const STRAIGHT: f64 = 1e-3;

/// Number of subdivisions of a cell along each axis for averages over the cell.
const PARTS: usize = 8;

/// Values in the cells around a cell, relative to the largest value of the grid.
pub(super) struct FitValues {
    /// Square of the pressure for cells inside. For cells outside the value is `-x^(2/3)`. Here `x` is 3/4 of the gap, divided by
    /// the unit of length and by the largest pressure. The modulus is not included.
    pub(super) lifted: Square<f64>,
    pub(super) is_inside: Square<bool>,
    /// Whether all four neighbours of a cell are also inside.
    pub(super) is_core: Square<bool>,
    /// Weights of the stencil, or zero for cells without a valid value.
    pub(super) weights: Square<f64>,
}

/// Quantities of a round at each position of the stencil. These are the weights, the weights of reliable values, the signed
/// distances from the edge (positive inside), and the squared distances of the cells outside.
struct Sample {
    weights: Square<f64>,
    trusted: Square<f64>,
    distances: Square<f64>,
    squares: Square<f64>,
}

/// Fit around a cell, in units of the largest pressure and of a cell.
pub(super) struct Fit {
    coefficients: [f64; POWERS],
    /// Square of the slope factor K at the edge.
    square: f64,
    gradient: [f64; 2],
    /// Root mean square of the residual, in cells.
    pub(super) missed: f64,
    /// Number of values in the fit.
    pub(super) count: usize,
    /// Whether any value in the fit belongs to a cell outside the set.
    pub(super) has_outside: bool,
}

impl Fit {
    /// Fits with a modulus that depends on the normal of the edge. Returns `None` if the values do not determine the fit.
    pub(super) fn new(
        stencil: &FitStencil,
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
            // Additional rounds would not move the edge into this cell.
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

    /// Returns the values scaled with the current slope.
    fn sample(
        &self,
        stencil: &FitStencil,
        values: &FitValues,
        modulus: f64,
        has_edge: bool,
    ) -> Option<Sample> {
        // If all values underflow or vanish, the scale of the distances is undefined.
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

    /// Performs a round: fits the sample and updates the slope at the edge.
    fn refine(&mut self, stencil: &FitStencil, sample: &Sample) -> Option<[f64; UNKNOWNS]> {
        let solution = sample.least_squares(stencil)?;
        if !solution.iter().all(|part| part.is_finite()) {
            return None;
        }
        for (coefficient, part) in self.coefficients.iter_mut().zip(solution) {
            *coefficient = part * self.square;
        }
        let [c, x, y, xx, xy, yy] = self.coefficients;
        // The slope is evaluated at the nearest point of the edge. The tangent plane gives an estimate of this point.
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

    /// Returns the squared pressure at a position relative to the centre of the cell.
    fn at(&self, [x, y]: [f64; 2]) -> f64 {
        let [c, cx, cy, cxx, cxy, cyy] = self.coefficients;
        c + x * (cx + cxx * x + cxy * y) + y * (cy + cyy * y)
    }

    /// Returns the signed distance of a position from the edge (positive inside), in cells. The estimate uses the slope at the
    /// edge.
    pub(super) fn distance(&self, place: [f64; 2]) -> f64 {
        self.at(place) / self.square
    }

    pub(super) fn centre(&self) -> f64 {
        self.at([0.0; 2]).max(0.0).sqrt()
    }

    /// Returns the covered fraction of the cell and the mean of the pressure over the cell.
    pub(super) fn covered_and_mean(&self, sides: [f64; 2]) -> [f64; 2] {
        let part = |k: usize, side: f64| ((k as f64 + 0.5) / PARTS as f64 - 0.5) * side;
        // Estimate of the change of the value across a subdivision of the cell.
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

/// Returns the slope of the squared pressure from a plane that is fitted to the cells inside.
fn first_gradient(stencil: &FitStencil, values: &FitValues) -> Option<[f64; 2]> {
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
    fn least_squares(&self, stencil: &FitStencil) -> Option<[f64; UNKNOWNS]> {
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

    /// Returns the root mean square of the residual of a solution, in cells.
    fn misfit(&self, stencil: &FitStencil, [c, x, y, xx, xy, yy, outside]: [f64; UNKNOWNS]) -> f64 {
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

/// Solves a positive definite system, given its lower triangle, by Cholesky factorisation. Returns `None` if the matrix is
/// not positive definite.
fn solved<const N: usize>(mut matrix: [[f64; N]; N], mut right: [f64; N]) -> Option<[f64; N]> {
    // The diagonal contains reciprocals.
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

    /// Checks that there is no fit if all squared pressures around a cell underflow.
    #[test]
    fn values_next_to_nothing_have_no_fit() {
        let stencil = FitStencil::new(Grid::square(8, 8.0).unwrap(), [false; 2]);
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
