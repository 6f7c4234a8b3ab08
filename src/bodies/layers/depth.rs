//! Displacements and stresses at a depth caused by waves of traction on the surface of a layered body.

use crate::bodies::layers::Layer;
use crate::bodies::layers::response::{Base, LayerWaves, Surface};

/// Fields at a depth due to a wave of unit amplitude on the surface, for pressure and for traction along the wave vector
/// k. Entries with the other parity in x are defined up to a factor i. The six entries are k times the displacements
/// normal and along k, the pressure and the traction that the plane transmits, and the normal stresses along and across
/// k.
///
/// With $`U = G k u, W = G k w`$ and $`\zeta = kz`$ they obey
///
/// ```math
/// U' = -q - W, \quad W' = \frac{\nu}{1 - \nu} U - \frac{1 - 2\nu}{2(1 - \nu)} p, \quad p' = q, \quad
/// q' = \sigma_l = -\frac{2}{1 - \nu} U - \frac{\nu}{1 - \nu} p, \quad \sigma_t = \nu (\sigma_l - p) .
/// ```
///
/// Growing waves are not propagated. The bodies below a depth have a surface compliance C, computed from the minors on the
/// [page](crate::layers). The surface of these bodies moves by C times the load that it carries. The load at the top of a layer
/// is X times the load at its bottom. The load at the bottom is therefore adj X / det X times the load at the top. The
/// determinant det X is the ratio of the first minors, a sum of positive terms. It grows as exp(2kh), and X grows as exp(kh).
#[derive(Debug, Clone, Copy)]
pub(crate) struct SubsurfaceResponse {
    pub(crate) by_pressure: [f64; 6],
    pub(crate) by_traction: [f64; 6],
    /// Fields due to traction across k: k times the displacement across k, the transmitted traction, and the shear
    /// stress in the plane, up to a factor i.
    pub(crate) across: [f64; 3],
}

impl SubsurfaceResponse {
    pub(crate) fn less(self, other: &Self) -> Self {
        fn less<const N: usize>(one: [f64; N], other: &[f64; N]) -> [f64; N] {
            std::array::from_fn(|n| one[n] - other[n])
        }
        Self {
            by_pressure: less(self.by_pressure, &other.by_pressure),
            by_traction: less(self.by_traction, &other.by_traction),
            across: less(self.across, &other.across),
        }
    }
}

impl LayerWaves<'_> {
    /// Returns the index of the layer at a depth, and the distance from its top. At an interface, returns the outer
    /// layer. In the base, the index is `None` and the distance is measured from the top of the base.
    pub(crate) fn place(&self, depth: f64) -> (Option<usize>, f64) {
        let mut top = 0.0;
        for (number, layer) in self.layers.iter().enumerate() {
            let bottom = top + layer.thickness();
            if depth <= bottom {
                return (Some(number), depth - top);
            }
            top = bottom;
        }
        (None, depth - top)
    }

    /// Returns Poisson's ratio at a depth.
    pub(crate) fn poisson_ratio_at(&self, depth: f64) -> f64 {
        match (self.place(depth).0, self.base) {
            (Some(number), _) => self.layers[number].poisson_ratio(),
            (None, Base::Elastic([_, nu])) => nu,
            (None, Base::Rigid) => 0.0,
        }
    }

    /// Returns the fields at a depth due to waves of the wave number k > 0. The fields are zero in a rigid base.
    pub(crate) fn at_depth(&self, k: f64, depth: f64) -> SubsurfaceResponse {
        let (number, from_top) = self.place(depth);
        let number_of = number.unwrap_or(self.layers.len());
        let (above, below) = self.layers.split_at(number_of);
        let host = match (below.first(), self.base) {
            (Some(layer), _) => *layer,
            (None, Base::Elastic([modulus, nu])) => Layer::of_shear(modulus, nu, from_top),
            (None, Base::Rigid) => Layer::of_shear(1.0, 0.0, from_top),
        };
        let part = |thickness: f64| host.of_thickness(thickness.max(0.0));

        // The surface compliance is computed from the base upwards: for the bodies below the depth, then for each layer
        // above it.
        let mut surface = Surface::of(self.base);
        for layer in below.iter().skip(1).rev() {
            surface = surface.under(layer, k);
        }
        let left = if number.is_some() {
            host.thickness() - from_top
        } else {
            0.0
        };
        let here = surface.under(&part(left), k);
        let mut carried = TransferRatio::ALL;
        let mut surface = here;
        for layer in [part(from_top)].iter().chain(above.iter().rev()) {
            let top = surface.under(layer, k);
            carried = carried.through(&surface, &top, layer, k);
            surface = top;
        }
        here.moved_by(carried, host.poisson_ratio())
    }
}

/// Load that a plane carries due to a unit load on the surface. Pressure and traction along k depend on both loads along
/// these directions. Traction across k is independent of them.
#[derive(Debug, Clone, Copy)]
struct TransferRatio {
    along: [[f64; 2]; 2],
    across: f64,
}

impl TransferRatio {
    const ALL: Self = Self {
        along: [[1.0, 0.0], [0.0, 1.0]],
        across: 1.0,
    };

    /// Converts the load of a plane relative to the bottom of a layer above it into the load relative to the top of the
    /// layer. The result is `self` times the ratio of bottom to top load.
    fn through(self, below: &Surface, top: &Surface, layer: &Layer, k: f64) -> Self {
        let nu = layer.poisson_ratio();
        let a = k * layer.thickness();
        let delta = 0.5 / (1.0 - nu);
        let t = (-2.0 * a).exp();
        // All values contain the factor exp(-a): cosh, sinh, a sinh, a cosh - sinh.
        let (cosh, sinh) = (0.5 * (1.0 + t), -0.5 * (-2.0 * a).exp_m1());
        let by_sinh = if a < 700.0 { a * sinh } else { 350.0 };
        let rest = if a < 1.0 {
            rest_of_sinh(a) * (-a).exp()
        } else {
            a.min(700.0) * cosh - sinh
        };
        let [s, n, l, c, _] = below.minors;
        let ratio = layer.shear_modulus() / below.unit / s;
        let [n, l, c] = [n * ratio, l * ratio, c * ratio];
        let (steep, long) = (2.0 * delta * by_sinh, 2.0 * delta * (2.0 * sinh + rest));
        let pressures = [
            cosh - 0.5 * steep - steep * c - 2.0 * delta * rest * n,
            -sinh - delta * rest - steep * l - 2.0 * delta * rest * c,
        ];
        let tractions = [
            nu / (1.0 - nu) * sinh + delta * rest + long * c + steep * n,
            cosh + 0.5 * steep + long * l + steep * c,
        ];
        let decay = (-a).exp() / top.determinant;
        let inverse = [
            [tractions[1] * decay, -pressures[1] * decay],
            [-tractions[0] * decay, pressures[0] * decay],
        ];
        let product = |i: usize, j: usize| {
            self.along[i][0] * inverse[0][j] + self.along[i][1] * inverse[1][j]
        };
        let x = layer.shear_modulus() / below.unit * below.across;
        Self {
            along: [
                [product(0, 0), product(0, 1)],
                [product(1, 0), product(1, 1)],
            ],
            across: self.across * (-a).exp() / (cosh + x * sinh),
        }
    }
}

impl Surface {
    /// Returns motion and stress of the surface under the load that it carries.
    fn moved_by(&self, carried: TransferRatio, nu: f64) -> SubsurfaceResponse {
        let [s, n, l, c, _] = self.minors;
        let [n, l, c] = [n / s, l / s, c / s];
        let of = |load: usize| {
            let [p, q] = [carried.along[0][load], carried.along[1][load]];
            let (along, normal) = (l * q + c * p, c * q + n * p);
            let stress = -(2.0 * along + nu * p) / (1.0 - nu);
            [
                normal / self.unit,
                along / self.unit,
                p,
                q,
                stress,
                nu * (stress - p),
            ]
        };
        let across = self.across * carried.across;
        SubsurfaceResponse {
            by_pressure: of(0),
            by_traction: of(1),
            across: [across / self.unit, carried.across, across],
        }
    }
}

/// Returns `a cosh a - sinh a` for a below 1.
fn rest_of_sinh(a: f64) -> f64 {
    let square = a * a;
    let mut term = a;
    let mut sum = 0.0;
    for j in 1..12_i32 {
        let n = f64::from(2 * j);
        term *= square / (n * (n + 1.0));
        sum += n * term;
    }
    sum
}
