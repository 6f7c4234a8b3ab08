//! The smooth part of the components below a cell, from functions of the distance.

use std::f64::consts::TAU;
use std::sync::OnceLock;

use crate::bodies::layers::SubsurfaceResponse;
use crate::bodies::material::Material;
use crate::influence::hankel::{
    PIECES, RULES, TERMS, bessel, chebyshev, ends_of, nodes, piece_of, rule, wave_numbers,
};
use crate::influence::periodic_images::{FAR, pieces};
use crate::influence::slowest;
use crate::subsurface::layered::{Entries, StressEntry, TractionColumn, exchanged, joined};

/// Number of functions of the distance, both for points on the surface and for lines.
const FUNCTIONS: usize = 15;
/// Number of functions for displacements, which come first.
const DISPLACEMENTS: usize = 5;
/// Order of the Bessel function of each function.
const ORDERS: [usize; FUNCTIONS] = [0, 1, 1, 0, 2, 0, 1, 0, 2, 1, 0, 2, 1, 1, 3];
/// Number of functions for lines that are even in the distance. The first three even functions and the first two odd functions
/// are displacements.
const EVEN: usize = 8;

/// Product of wave number and scale above which the response is negligible.
const GONE: f64 = 40.0;

/// Chebyshev coefficients of the functions on a piece, by polynomial.
type RadialPiece = Box<[[f64; FUNCTIONS]; TERMS]>;

/// Tables of Hankel integrals of a response, and their sums over cells. The response must be negligible for wave numbers k above
/// 40 divided by the scale.
pub(super) struct Radial {
    scale: f64,
    /// End of the first interval of wave numbers, on which the response hardly varies.
    least: f64,
    points: [OnceLock<RadialPiece>; PIECES],
    lines: [OnceLock<RadialPiece>; PIECES],
    /// Limits of k times the displacements for infinitely long waves, in the normal direction and parallel and perpendicular to
    /// the wave vector.
    pole: [f64; 3],
}

impl Radial {
    pub(super) fn new(body: &Material, scale: f64, pole: [f64; 3]) -> Self {
        Self {
            scale,
            least: 0.025 / slowest(body).max(scale),
            points: std::array::from_fn(|_| OnceLock::new()),
            lines: std::array::from_fn(|_| OnceLock::new()),
            pole,
        }
    }

    /// Returns the components under a loaded cell of half sides `[a, b]` at an offset from its centre.
    pub(super) fn over_cell(
        &self,
        response: &impl Fn(f64) -> SubsurfaceResponse,
        [a, b]: [f64; 2],
        [x, y]: [f64; 2],
    ) -> Entries {
        let distance = x.hypot(y);
        let rules = [a, b].map(|side| rule(side, distance, self.scale));
        let [Some(along_x), Some(along_y)] = rules else {
            // The side that is too long is halved. If both sides are too long, the longer side is halved.
            let halves_x = rules[1].is_some() || (rules[0].is_none() && a >= b);
            let (half, step) = if halves_x {
                ([0.5 * a, b], [0.5 * a, 0.0])
            } else {
                ([a, 0.5 * b], [0.0, 0.5 * b])
            };
            let part = |sign: f64| {
                self.over_cell(response, half, [x + sign * step[0], y + sign * step[1]])
            };
            let (one, other) = (part(1.0), part(-1.0));
            return std::array::from_fn(|n| one[n] + other[n]);
        };
        let mut sum = [0.0; StressEntry::COUNT];
        for &[node_y, weight_y] in RULES[along_y].1 {
            for &[node_x, weight_x] in RULES[along_x].1 {
                let weight = weight_x * weight_y * a * b / TAU;
                let at = [x + a * node_x, y + b * node_y];
                for (sum, value) in sum.iter_mut().zip(self.at_point(response, at)) {
                    *sum += weight * value;
                }
            }
        }
        sum
    }

    /// Returns the components under a cell and all its images along y. The distance `y` from the nearest image is between zero
    /// and `period/2`. Displacements are relative to the datum, [as on the surface](crate::influence::periodic_images).
    pub(super) fn over_rows(
        &self,
        response: &impl Fn(f64) -> SubsurfaceResponse,
        [a, b]: [f64; 2],
        [x, y]: [f64; 2],
        [period, datum]: [f64; 2],
    ) -> Entries {
        let share = 2.0 * b / period;
        let mut sum = self
            .over_strip(response, a, x, datum)
            .map(|value| share * value);
        // A cell as long as the period is a strip, and far away every row of images acts like a strip.
        if share >= 1.0 || x >= a + FAR * period {
            return sum;
        }
        for piece in pieces(b, period) {
            let values = self.over_cell(response, [a, piece.half], [x, y + piece.offset]);
            for (sum, value) in sum.iter_mut().zip(values) {
                *sum += piece.weight * value;
            }
        }
        // At these y the images on both sides are symmetric, so odd components vanish.
        if y == 0.0 || 2.0 * y >= period {
            for (n, sum) in sum.iter_mut().enumerate() {
                if StressEntry::of(n).is_odd()[1] {
                    *sum = 0.0;
                }
            }
        }
        sum
    }

    /// Returns the components under an infinitely long strip of half width `a` along y, with displacements relative to the
    /// datum.
    fn over_strip(
        &self,
        response: &impl Fn(f64) -> SubsurfaceResponse,
        a: f64,
        x: f64,
        datum: f64,
    ) -> Entries {
        let Some(rule) = rule(a, x.abs(), self.scale) else {
            let part = |x: f64| self.over_strip(response, 0.5 * a, x, datum);
            let (one, other) = (part(x + 0.5 * a), part(x - 0.5 * a));
            return std::array::from_fn(|n| one[n] + other[n]);
        };
        let mut sum = [0.0; StressEntry::COUNT];
        for &[node, weight] in RULES[rule].1 {
            let values = self.at_line(response, x + a * node, datum);
            for (sum, value) in sum.iter_mut().zip(values) {
                *sum += a * weight / TAU * value;
            }
        }
        sum
    }

    fn at_point(&self, response: &impl Fn(f64) -> SubsurfaceResponse, [x, y]: [f64; 2]) -> Entries {
        let functions = sample(&self.points, self.scale, x.hypot(y), |ends| {
            self.point_piece(response, ends)
        });
        joined(
            pressed(&functions, [x, y]),
            sheared(&functions, [x, y]),
            exchanged(sheared(&functions, [y, x])),
        )
    }

    fn point_piece(
        &self,
        response: &impl Fn(f64) -> SubsurfaceResponse,
        ends: [f64; 2],
    ) -> RadialPiece {
        let numbers = wave_numbers(ends, GONE / self.scale, self.least);
        let waves: Vec<_> = numbers
            .into_iter()
            .map(|(k, weight)| {
                let mut functions = harmonics(&response(k));
                for (n, function) in functions.iter_mut().enumerate() {
                    let order = i32::try_from(ORDERS[n]).unwrap_or(0);
                    let power = order + i32::from(n >= DISPLACEMENTS);
                    *function *= weight * k.powi(power);
                }
                (k, functions)
            })
            .collect();
        tabulated(ends, |r| {
            let mut sum = [0.0; FUNCTIONS];
            for (k, functions) in &waves {
                let of_order = bessel(k * r);
                for ((sum, function), order) in sum.iter_mut().zip(functions).zip(ORDERS) {
                    *sum += function * of_order[order];
                }
            }
            sum
        })
    }

    fn at_line(
        &self,
        response: &impl Fn(f64) -> SubsurfaceResponse,
        x: f64,
        datum: f64,
    ) -> Entries {
        let functions = sample(&self.lines, self.scale, x.abs(), |ends| {
            self.line_piece(response, ends)
        });
        let log = -2.0 * (x / datum).hypot(self.scale / datum).ln();
        let pole = self.pole.map(|pole| pole * log);
        let [
            normal,
            along,
            across,
            p,
            stress_along,
            stress_across,
            q,
            passed,
        ] = std::array::from_fn(|n| functions[n]);
        let [
            along_p,
            normal_q,
            q_p,
            p_q,
            stress_along_q,
            stress_across_q,
            shear,
        ] = std::array::from_fn(|n| x * functions[EVEN + n]);
        let pressure = [
            -along_p,
            0.0,
            normal + pole[0],
            stress_along,
            stress_across,
            -p,
            0.0,
            q_p,
            0.0,
        ];
        let along_x = [
            along + pole[1],
            0.0,
            normal_q,
            stress_along_q,
            stress_across_q,
            -p_q,
            0.0,
            -q,
            0.0,
        ];
        let along_y = [
            0.0,
            across + pole[2],
            0.0,
            0.0,
            0.0,
            0.0,
            -shear,
            0.0,
            -passed,
        ];
        joined(pressure, along_x, along_y)
    }

    fn line_piece(
        &self,
        response: &impl Fn(f64) -> SubsurfaceResponse,
        ends: [f64; 2],
    ) -> RadialPiece {
        let pole = self.pole;
        let numbers = wave_numbers(ends, GONE / self.scale, self.least);
        let waves: Vec<_> = numbers
            .into_iter()
            .map(|(k, weight)| {
                let SubsurfaceResponse {
                    by_pressure: [normal, along_p, p, q_p, stress_along, stress_across],
                    by_traction: [normal_q, along, p_q, q, stress_along_q, stress_across_q],
                    across: [across, passed, shear],
                } = response(k);
                let decay = (-k * self.scale).exp();
                let without = |value: f64, pole: f64| (value - pole * decay) / k;
                let functions = [
                    without(normal, pole[0]),
                    without(along, pole[1]),
                    without(across, pole[2]),
                    p,
                    stress_along,
                    stress_across,
                    q,
                    passed,
                    along_p / k,
                    normal_q / k,
                    q_p,
                    p_q,
                    stress_along_q,
                    stress_across_q,
                    shear,
                ];
                (k, functions.map(|value| 2.0 * weight * value))
            })
            .collect();
        tabulated(ends, |x| {
            let mut sum = [0.0; FUNCTIONS];
            for (k, functions) in &waves {
                let (sine, cosine) = (k * x).sin_cos();
                let turned = if x > 0.0 { sine / x } else { *k };
                for (n, (sum, function)) in sum.iter_mut().zip(functions).enumerate() {
                    *sum += function * if n < EVEN { cosine } else { turned };
                }
            }
            sum
        })
    }
}

/// Returns the functions under the Hankel integrals: k times the displacements, and the stresses.
fn harmonics(below: &SubsurfaceResponse) -> [f64; FUNCTIONS] {
    let [normal, along, p, q, stress_along, stress_across] = below.by_pressure;
    let [normal_q, along_q, p_q, q_q, l, t] = below.by_traction;
    let [across, passed, shear] = below.across;
    [
        normal,
        along,
        normal_q,
        0.5 * (along_q + across),
        0.5 * (along_q - across),
        p,
        q,
        0.5 * (stress_along + stress_across),
        0.5 * (stress_along - stress_across),
        p_q,
        0.5 * (q_q + passed),
        0.5 * (q_q - passed),
        0.25 * (3.0 * l + t - 2.0 * shear),
        0.25 * (l + 3.0 * t + 2.0 * shear),
        0.25 * (l - t + 2.0 * shear),
    ]
}

/// Returns the components under a normal point force at an offset, from the [functions](harmonics).
fn pressed(of: &[f64; FUNCTIONS], [x, y]: [f64; 2]) -> TractionColumn {
    let turned = (x * x - y * y) * of[8];
    [
        -x * of[1],
        -y * of[1],
        of[0],
        of[7] - turned,
        of[7] + turned,
        -of[5],
        -2.0 * x * y * of[8],
        x * of[6],
        y * of[6],
    ]
}

/// Returns the components under a point force along x.
fn sheared(of: &[f64; FUNCTIONS], [x, y]: [f64; 2]) -> TractionColumn {
    let (square, product) = (x * x - y * y, 2.0 * x * y);
    let cubes = [x * (x * x - 3.0 * y * y), y * (3.0 * x * x - y * y)].map(|cube| cube * of[14]);
    [
        of[3] - square * of[4],
        -product * of[4],
        x * of[2],
        x * of[12] - cubes[0],
        x * of[13] + cubes[0],
        -x * of[9],
        0.5 * y * (of[12] - of[13]) - cubes[1],
        square * of[11] - of[10],
        product * of[11],
    ]
}

/// Returns the values of all functions at a distance. The table of a piece is created when it is first used.
fn sample(
    table: &[OnceLock<RadialPiece>; PIECES],
    scale: f64,
    distance: f64,
    make: impl Fn([f64; 2]) -> RadialPiece,
) -> [f64; FUNCTIONS] {
    let piece = piece_of(distance, scale);
    let ends @ [start, end] = ends_of(piece, scale);
    let terms = table[piece].get_or_init(|| make(ends));
    let t = 4.0 * (distance - 0.5 * (start + end)) / (end - start);
    let (mut next, mut after) = ([0.0; FUNCTIONS], [0.0; FUNCTIONS]);
    for term in terms[1..].iter().rev() {
        for n in 0..FUNCTIONS {
            let value = t * next[n] - after[n] + term[n];
            after[n] = next[n];
            next[n] = value;
        }
    }
    std::array::from_fn(|n| 0.5 * t * next[n] - after[n] + terms[0][n])
}

fn tabulated(ends: [f64; 2], at: impl Fn(f64) -> [f64; FUNCTIONS]) -> RadialPiece {
    let values = nodes(ends).map(at);
    let by_function: [[f64; TERMS]; FUNCTIONS] =
        std::array::from_fn(|function| chebyshev(|node| values[node][function]));
    Box::new(std::array::from_fn(|term| {
        std::array::from_fn(|function| by_function[function][term])
    }))
}
