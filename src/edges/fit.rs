//! The quadratic that is zero at the edge, fitted to the cells about one.

use crate::edges::stencil::{CELLS, PLACES, POWERS, PRODUCT_OF, Stencil, dot};

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
pub(super) struct Values {
    /// Inside the square of the pressure, outside minus the power 2/3 of the gap times 3/4 over the unit of length and the
    /// largest pressure, without the modulus.
    pub(super) lifted: [f64; PLACES],
    pub(super) is_inside: [bool; PLACES],
    /// Whether all four neighbours of a cell are inside too.
    pub(super) is_core: [bool; PLACES],
    pub(super) is_known: [bool; PLACES],
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
        let largest = values.lifted.iter().copied().fold(0.0, f64::max);
        let gradient = first_gradient(stencil, values)?;
        let mut fit = Self {
            coefficients: [0.0; POWERS],
            square: length(gradient).max(1e-3 * largest),
            gradient,
            missed: f64::INFINITY,
            count: 0,
        };
        for round in 0..ROUNDS {
            fit.refine(stencil, values, modulus(fit.normal()), round > 0)?;
            // The edge is in none of the further rounds in this cell.
            if fit.distance([0.0; 2]) < -FAR_OUTSIDE {
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

    /// A round: the fit with the slope known so far, and the slope at its edge.
    fn refine(
        &mut self,
        stencil: &Stencil,
        values: &Values,
        modulus: f64,
        has_edge: bool,
    ) -> Option<()> {
        // Values next to nothing, or none, leave nothing to measure by.
        if !(self.square > 0.0 && self.square.is_finite()) {
            return None;
        }
        let slope = (self.square * modulus).cbrt().powi(2);
        let inverse = 1.0 / self.square;
        let fitted = self.distances(stencil);
        let (mut weights, mut trusted) = ([0.0; PLACES], [0.0; PLACES]);
        let (mut distances, mut squares) = ([0.0; PLACES], [0.0; PLACES]);
        for k in (0..CELLS).filter(|k| values.is_known[*k]) {
            let is_inside = values.is_inside[k];
            let level = values.lifted[k] * if is_inside { 1.0 } else { slope };
            let distance = level * inverse;
            let far = (distance.abs() - NEAR).max(0.0) * (1.0 / FADE);
            if far > NOTHING {
                continue;
            }
            let is_trusted = match (is_inside, has_edge) {
                (true, false) => values.is_core[k] || distance > BLURRED_INSIDE,
                (false, false) => distance < -BLURRED_OUTSIDE,
                (true, true) => fitted[k] > BLURRED_INSIDE,
                (false, true) => distance < -BLURRED_OUTSIDE && fitted[k] < -0.5 * BLURRED_OUTSIDE,
            };
            let fade = if far > 0.0 { (-far * far).exp() } else { 1.0 };
            let weight = stencil.weights[k] * fade;
            weights[k] = weight * if is_trusted { 1.0 } else { DISTRUSTED };
            trusted[k] = if is_trusted { weight } else { 0.0 };
            distances[k] = distance;
            squares[k] = if is_inside { 0.0 } else { distance * distance };
        }
        let solution = least_squares(stencil, &weights, &distances, &squares)?;
        if !solution.iter().all(|part| part.is_finite()) {
            return None;
        }
        self.count = trusted.iter().filter(|weight| **weight > 0.0).count();
        self.missed = missed(stencil, &solution, &trusted, [distances, squares]);
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

    /// Those of all places inside the edge, as far as it is known.
    fn distances(&self, stencil: &Stencil) -> [f64; PLACES] {
        let mut distances = [0.0; PLACES];
        for (coefficient, power) in self.coefficients.iter().zip(&stencil.products) {
            let coefficient = coefficient / self.square;
            for (distance, power) in distances.iter_mut().zip(power) {
                *distance += coefficient * power;
            }
        }
        distances
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
fn first_gradient(stencil: &Stencil, values: &Values) -> Option<[f64; 2]> {
    let is_inside = |k: usize| {
        if values.is_inside[k] {
            stencil.weights[k]
        } else {
            0.0
        }
    };
    let weights: [f64; PLACES] = std::array::from_fn(is_inside);
    let weighted = product(&weights, &values.lifted);
    let products = &stencil.products;
    let mut matrix = [[0.0; 3]; 3];
    for i in 0..3 {
        for j in 0..=i {
            matrix[i][j] = dot(&weights, &products[PRODUCT_OF[i][j]]);
        }
        matrix[i][i] += 1e-9;
    }
    let [_, x, y] = solved(matrix, [0, 1, 2].map(|i| dot(&weighted, &products[i])))?;
    Some([x, y])
}

fn least_squares(
    stencil: &Stencil,
    weights: &[f64; PLACES],
    distances: &[f64; PLACES],
    squares: &[f64; PLACES],
) -> Option<[f64; UNKNOWNS]> {
    let products = &stencil.products;
    let sums = products.each_ref().map(|power| dot(weights, power));
    let (right, outside) = (product(weights, distances), product(weights, squares));
    let mut matrix = [[0.0; UNKNOWNS]; UNKNOWNS];
    for i in 0..POWERS {
        for j in 0..=i {
            matrix[i][j] = sums[PRODUCT_OF[i][j]];
        }
        matrix[POWERS][i] = dot(&outside, &products[i]);
    }
    matrix[POWERS][POWERS] = dot(&outside, squares);
    for (i, row) in matrix.iter_mut().enumerate() {
        row[i] += 1e-12 + if i < 3 { 0.0 } else { STRAIGHT };
    }
    let of_unknown = |i: usize| dot(&right, if i < POWERS { &products[i] } else { squares });
    solved(matrix, std::array::from_fn(of_unknown))
}

/// Root mean square of what a solution misses, in cells.
fn missed(
    stencil: &Stencil,
    solution: &[f64; UNKNOWNS],
    trusted: &[f64; PLACES],
    [distances, squares]: [[f64; PLACES]; 2],
) -> f64 {
    let mut missed = distances;
    for (missed, square) in missed.iter_mut().zip(&squares) {
        *missed -= solution[POWERS] * square;
    }
    for (part, power) in solution.iter().zip(&stencil.products[..POWERS]) {
        for (missed, power) in missed.iter_mut().zip(power) {
            *missed -= part * power;
        }
    }
    let sum = dot(trusted, &stencil.products[0]);
    if sum > 0.0 {
        (dot(&product(trusted, &missed), &missed) / sum).sqrt()
    } else {
        f64::INFINITY
    }
}

fn product(a: &[f64; PLACES], b: &[f64; PLACES]) -> [f64; PLACES] {
    let mut products = *a;
    for (product, b) in products.iter_mut().zip(b) {
        *product *= b;
    }
    products
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grid::Grid;

    /// Pressures whose squares underflow, everywhere about a cell, give nothing to fit.
    #[test]
    fn values_next_to_nothing_have_no_fit() {
        let stencil = Stencil::new(Grid::square(8, 8.0).unwrap(), [false; 2]);
        for lifted in [0.0, f64::INFINITY] {
            let values = Values {
                lifted: [lifted; PLACES],
                is_inside: [true; PLACES],
                is_core: [true; PLACES],
                is_known: [true; PLACES],
            };
            assert!(Fit::new(&stencil, &values, |_| 1.0).is_none(), "{lifted}");
        }
    }
}
