//! Surface response of a layered body to waves of traction, in four functions.

use crate::bodies::layers::Layer;

/// Response of a surface to a wave of traction, in lengths over pressures. The documentation of [`layers`](crate::layers)
/// defines the directions and signs.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Response {
    /// Normal displacement due to pressure.
    pub normal: f64,
    /// Tangential displacement along the wave vector due to traction along it.
    pub along: f64,
    /// Tangential displacement across the wave vector due to traction across it.
    pub across: f64,
    /// Normal displacement due to traction along the wave vector, and displacement along it due to pressure, up to a
    /// factor i.
    pub coupling: f64,
}

impl Response {
    /// Combines each function with the same function of a different response.
    pub(crate) fn with(self, other: Self, combine: impl Fn(f64, f64) -> f64) -> Self {
        Self {
            normal: combine(self.normal, other.normal),
            along: combine(self.along, other.along),
            across: combine(self.across, other.across),
            coupling: combine(self.coupling, other.coupling),
        }
    }

    pub(crate) fn map(self, f: impl Fn(f64) -> f64) -> Self {
        self.with(self, |value, _| f(value))
    }

    /// Returns the response of two bodies in contact. The functions of both bodies are added. For the coupling, the
    /// value of body 2 is subtracted from the value of body 1.
    pub(crate) fn and_second(self, other: Self) -> Self {
        Self {
            coupling: self.coupling - other.coupling,
            ..self.with(other, |one, two| one + two)
        }
    }
}

/// Base below all layers: a rigid body, or a half-space with its shear modulus and Poisson's ratio.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Base {
    Rigid,
    Elastic([f64; 2]),
}

/// Layers on a base, the outermost first.
#[derive(Debug, Clone, Copy)]
pub(crate) struct LayerWaves<'a> {
    pub(crate) layers: &'a [Layer],
    pub(crate) base: Base,
}

/// Minors `s (1, n, l, c, n l - c^2)` of a surface compliance, up to a common factor, and the compliance across k. The
/// unit is `1/(G k)` for a modulus G.
#[derive(Debug, Clone, Copy)]
pub(super) struct Surface {
    pub(super) unit: f64,
    pub(super) minors: [f64; 5],
    pub(super) across: f64,
    /// First minor divided by the first minor of the bodies below the outermost layer, times exp(-2kh) of that layer.
    pub(super) determinant: f64,
}

impl LayerWaves<'_> {
    /// Returns the wave number k > 0 times the response to waves of this wave number.
    pub(crate) fn times_k(&self, k: f64) -> Response {
        let mut surface = Surface::of(self.base);
        for layer in self.layers.iter().rev() {
            surface = surface.under(layer, k);
        }
        let [s, n, l, c, _] = surface.minors;
        let of = |minor: f64| minor / s / surface.unit;
        Response {
            normal: of(n),
            along: of(l),
            across: surface.across / surface.unit,
            coupling: of(c),
        }
    }
}

impl Surface {
    pub(super) fn of(base: Base) -> Self {
        match base {
            Base::Rigid => Self {
                unit: 1.0,
                minors: [1.0, 0.0, 0.0, 0.0, 0.0],
                across: 0.0,
                determinant: 1.0,
            },
            Base::Elastic([unit, nu]) => Self {
                unit,
                minors: [
                    1.0,
                    1.0 - nu,
                    1.0 - nu,
                    0.5 * (1.0 - 2.0 * nu),
                    0.25 * (3.0 - 4.0 * nu),
                ],
                across: 1.0,
                determinant: 1.0,
            },
        }
    }

    /// Returns the surface of a layer on top of this surface.
    pub(super) fn under(self, layer: &Layer, k: f64) -> Self {
        let (modulus, nu) = (layer.shear_modulus(), layer.poisson_ratio());
        let ratio = modulus / self.unit;
        let [s, n, l, c, d] = self.minors;
        let [n, l, c, d] = [n * ratio, l * ratio, c * ratio, d * ratio * ratio];

        // Beyond this limit the layer acts as a half-space, and squares would overflow.
        let a = (k * layer.thickness()).min(1e3);
        let (g, e, f) = (1.0 - nu, 1.0 - 2.0 * nu, 3.0 - 4.0 * nu);
        // All values contain the factor t = exp(-2a): sinh^2, sinh cosh, and these minus a^2 and minus a.
        let t = (-2.0 * a).exp();
        let (at, aat, less) = (a * t, a * a * t, -(-2.0 * a).exp_m1());
        let (s2, sc) = (0.25 * less * less, 0.25 * less * (1.0 + t));
        let (p, q) = if a < 1.0 {
            (0.5 * t * tail(a, 4), 0.5 * t * tail(a, 3))
        } else {
            (s2 - aat, sc - at)
        };
        let g2 = g * g;
        let diagonal = t + (aat + f * s2) / (4.0 * g2);
        let outer = (aat + e * s2) / g2;
        let w = (e * f * s2 - aat) / (8.0 * g2);
        let (big, small) = ((sc + at) / g, q / g);
        let (less_c, more_c) = ((e * sc - at) / g, (e * sc + at) / g);
        let (by_n, by_l) = ((q + 2.0 * e * sc) / (4.0 * g), (at + f * sc) / (4.0 * g));
        let minors = [
            diagonal * s + small * n + big * l + outer * c + p / g2 * d,
            by_n * s + (t + s2) * n + s2 * l + less_c * c + big * d,
            by_l * s + s2 * n + (t + s2) * l + more_c * c + small * d,
            w * s
                + 0.5 * more_c * n
                + 0.5 * less_c * l
                + (t + (e * e * s2 - aat) / (2.0 * g2)) * c
                + 0.5 * outer * d,
            (p + 8.0 * e * g * s2) / (16.0 * g2) * s
                + by_l * n
                + by_n * l
                + 2.0 * w * c
                + diagonal * d,
        ];
        let largest = minors.iter().fold(0.0, |a: f64, b| a.max(b.abs()));
        let (x, tanh) = (ratio * self.across, a.tanh());
        Self {
            unit: modulus,
            minors: minors.map(|minor| minor / largest),
            across: (x + tanh) / (1.0 + x * tanh),
            determinant: minors[0] / s,
        }
    }
}

/// Returns the series of `cosh 2a` (even) or `sinh 2a` (odd) from the given power, for a below 1.
fn tail(a: f64, first: i32) -> f64 {
    let x = 2.0 * a;
    let mut sum = 0.0;
    let mut power = first + 24;
    while power >= first + 2 {
        sum = (sum + 1.0) * x * x / f64::from(power * (power - 1));
        power -= 2;
    }
    let factorial: i32 = (1..=first).product();
    (1.0 + sum) * x.powi(first) / f64::from(factorial)
}
