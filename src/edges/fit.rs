//! The quadratic that is zero at the edge, fitted to the cells about one.

use crate::edges::stencil::{CELLS, POWERS, PRODUCT_OF, PRODUCTS, Stencil};

/// Unknowns: the quadratic, and a square of the distance outside.
const UNKNOWNS: usize = POWERS + 1;

/// Rounds in which the slope at the edge is found.
const ROUNDS: usize = 3;

/// Distance from the edge, in cells, within which values are not trusted: inside and outside.
const BLURRED_INSIDE: f64 = 0.8;
const BLURRED_OUTSIDE: f64 = 0.5;

/// Weight of values that are not trusted, beside those that are.
const DISTRUSTED: f64 = 2e-3;

/// Distance from the edge, in cells, from which on values count less, and how fast.
const NEAR: f64 = 2.5;
const FADE: f64 = 1.5;

/// Pull of the squares to zero: an edge without evidence is straight.
const STRAIGHT: f64 = 1e-3;

/// Subdivisions of a cell, along each axis, over which it is averaged.
const PARTS: usize = 8;

/// What is known of the cells about one; values relative to the largest of the grid.
pub(super) struct Values {
    /// Pressures, zero outside.
    pub(super) inside: [f64; CELLS],
    pub(super) is_inside: [bool; CELLS],
    /// Whether all four neighbours of a cell are inside too.
    pub(super) is_core: [bool; CELLS],
    /// Gaps times 3/4 over the unit of length and the largest pressure, without the modulus.
    pub(super) outside: [f64; CELLS],
    pub(super) is_known: [bool; CELLS],
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
}

impl Fit {
    /// With the modulus for a direction of the normal of the edge; `None` where nothing is determined.
    pub(super) fn new(
        stencil: &Stencil,
        values: &Values,
        modulus: impl Fn([f64; 2]) -> f64,
    ) -> Option<Self> {
        let largest = values.inside.iter().copied().fold(0.0, f64::max);
        let gradient = first_gradient(stencil, values)?;
        let mut fit = Self {
            coefficients: [0.0; POWERS],
            square: length(gradient).max(1e-3 * largest * largest),
            gradient,
            missed: f64::INFINITY,
            count: 0,
        };
        for round in 0..ROUNDS {
            fit.refine(stencil, values, modulus(fit.normal()), round > 0)?;
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

    /// A round: the fit with the slope known so far, and the slope at its edge.
    fn refine(
        &mut self,
        stencil: &Stencil,
        values: &Values,
        modulus: f64,
        has_edge: bool,
    ) -> Option<()> {
        let slope = self.square.cbrt().powi(2);
        let (mut weights, mut trusted) = ([0.0; CELLS], [false; CELLS]);
        let (mut levels, mut beyond) = ([0.0; CELLS], [0.0; CELLS]);
        for k in (0..CELLS).filter(|k| values.is_known[*k]) {
            let is_inside = values.is_inside[k];
            let level = if is_inside {
                values.inside[k] * values.inside[k]
            } else {
                -slope * (modulus * values.outside[k]).cbrt().powi(2)
            };
            let distance = level / self.square;
            let fitted = self.at_products(&stencil.products[k]) / self.square;
            trusted[k] = match (is_inside, has_edge) {
                (true, false) => values.is_core[k] || distance > BLURRED_INSIDE,
                (false, false) => distance < -BLURRED_OUTSIDE,
                (true, true) => fitted > BLURRED_INSIDE,
                (false, true) => distance < -BLURRED_OUTSIDE && fitted < -0.5 * BLURRED_OUTSIDE,
            };
            let far = ((distance.abs() - NEAR).max(0.0) / FADE).powi(2);
            let trust = if trusted[k] { 1.0 } else { DISTRUSTED };
            weights[k] = stencil.weights[k] * trust * (-far).exp();
            levels[k] = distance;
            beyond[k] = if is_inside { 0.0 } else { distance * distance };
        }
        let solution = least_squares(stencil, &weights, &levels, &beyond)?;
        let (mut squares, mut sum) = (0.0, 0.0);
        self.count = 0;
        for k in (0..CELLS).filter(|k| trusted[*k]) {
            let products = &stencil.products[k];
            let fitted: f64 = (0..POWERS).map(|i| solution[i] * products[i]).sum();
            let missed = levels[k] - fitted - solution[POWERS] * beyond[k];
            squares += weights[k] * missed * missed;
            sum += weights[k];
            self.count += 1;
        }
        self.missed = if sum > 0.0 {
            (squares / sum).sqrt()
        } else {
            f64::INFINITY
        };
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
        Some(())
    }

    fn at_products(&self, products: &[f64; PRODUCTS]) -> f64 {
        let terms = self.coefficients.iter().zip(products);
        terms.map(|(coefficient, power)| coefficient * power).sum()
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
        let (mut covered, mut sum) = (0.0, 0.0);
        for j in 0..PARTS {
            for i in 0..PARTS {
                let level = self.at([part(i, sides[0]), part(j, sides[1])]);
                covered += (0.5 + level / across).clamp(0.0, 1.0);
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
fn first_gradient(stencil: &Stencil, values: &Values) -> Option<[f64; 2]> {
    let (mut matrix, mut right) = ([[0.0; 3]; 3], [0.0; 3]);
    for k in (0..CELLS).filter(|k| values.is_inside[*k]) {
        let (weight, products) = (stencil.weights[k], &stencil.products[k]);
        let level = weight * values.inside[k] * values.inside[k];
        for i in 0..3 {
            right[i] += level * products[i];
            for j in 0..=i {
                matrix[i][j] += weight * products[PRODUCT_OF[i][j]];
            }
        }
    }
    for (i, row) in matrix.iter_mut().enumerate() {
        row[i] += 1e-9;
    }
    let [_, x, y] = solved(matrix, right)?;
    Some([x, y])
}

fn least_squares(
    stencil: &Stencil,
    weights: &[f64; CELLS],
    levels: &[f64; CELLS],
    beyond: &[f64; CELLS],
) -> Option<[f64; UNKNOWNS]> {
    let mut products = [0.0; PRODUCTS];
    let (mut right, mut outside, mut last) = ([0.0; POWERS], [0.0; POWERS], [0.0; 2]);
    for k in (0..CELLS).filter(|k| weights[*k] > 0.0) {
        let (weight, powers) = (weights[k], &stencil.products[k]);
        let (level, square) = (weight * levels[k], weight * beyond[k]);
        for (sum, power) in products.iter_mut().zip(powers) {
            *sum += weight * power;
        }
        for i in 0..POWERS {
            right[i] += level * powers[i];
            outside[i] += square * powers[i];
        }
        last[0] += square * beyond[k];
        last[1] += square * levels[k];
    }
    let mut matrix = [[0.0; UNKNOWNS]; UNKNOWNS];
    for i in 0..POWERS {
        for j in 0..=i {
            matrix[i][j] = products[PRODUCT_OF[i][j]];
        }
        matrix[POWERS][i] = outside[i];
    }
    matrix[POWERS][POWERS] = last[0];
    for (i, row) in matrix.iter_mut().enumerate() {
        row[i] += 1e-12 + if i < 3 { 0.0 } else { STRAIGHT };
    }
    let [c, x, y, xx, xy, yy] = right;
    solved(matrix, [c, x, y, xx, xy, yy, last[1]])
}

/// The solution of a positive definite system of which the lower triangle is given, by Cholesky; `None` for another.
fn solved<const N: usize>(mut matrix: [[f64; N]; N], mut right: [f64; N]) -> Option<[f64; N]> {
    for i in 0..N {
        for j in 0..=i {
            let done: f64 = (0..j).map(|k| matrix[i][k] * matrix[j][k]).sum();
            let rest = matrix[i][j] - done;
            matrix[i][j] = if i > j {
                rest / matrix[j][j]
            } else if rest > 0.0 {
                rest.sqrt()
            } else {
                return None;
            };
        }
        let done: f64 = (0..i).map(|k| matrix[i][k] * right[k]).sum();
        right[i] = (right[i] - done) / matrix[i][i];
    }
    for i in (0..N).rev() {
        let done: f64 = (i + 1..N).map(|k| matrix[k][i] * right[k]).sum();
        right[i] = (right[i] - done) / matrix[i][i];
    }
    Some(right)
}
