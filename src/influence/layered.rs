//! Correction that coated bodies add to the coefficients of their outermost layers.

use std::sync::OnceLock;

use crate::bodies::component::Component;
use crate::bodies::kernel::{Isotropic, Kernel};
use crate::bodies::layers::{Layer, Response};
use crate::bodies::material::{Compliances, ElasticPair, Material};
use crate::influence::hankel::{
    PIECES, RULES, TERMS, bessel, chebyshev, ends_of, nodes, piece_of, rule, tabulated,
    wave_numbers,
};
use crate::influence::periodic_images::{FAR, pieces};

/// Kernels of the response of a pair minus the response of its outermost layers as half-spaces, times two pi. The kernels of a
/// point force depend on the distance r, the kernels of a line load on the distance x. Both are smooth on the scale of the
/// outermost layer.
///
/// The term $`\Delta\,e^{-kH}/k`$ of the response corresponds to a force at the depth H. It contains the pole of the base at
/// `k = 0`. The remainder is R(k), which is negligible beyond [`GONE`]. The tabulated kernels of points are
///
/// ```math
/// \int k R_n J_0 \,\mathrm{d}k, \quad \int k \tfrac{R_l + R_t}{2} J_0 \,\mathrm{d}k, \quad
/// \int k \tfrac{R_l - R_t}{2} \frac{J_2}{r^2}\,\mathrm{d}k, \quad \int k R_c \frac{J_1}{r}\,\mathrm{d}k,
/// ```
///
/// plus the contributions of the forces at depths. The kernels of lines are $`2 \int R_{n,l,t} \cos kx\,\mathrm{d}k`$ and
/// $`2 \int R_c \sin(kx)/x\,\mathrm{d}k`$ without these contributions. All kernels are even functions of the distance.
#[derive(Debug)]
pub(crate) struct LayerCorrection {
    kernel: Kernel,
    near: Response,
    /// Values for each coated body or for a kernel: the depth H, and the difference between the responses of the base and of the
    /// outermost layer. The response of the pair includes the sum over both bodies.
    images: Vec<(f64, Response)>,
    /// Smallest depth H.
    scale: f64,
    /// End of the first interval of wave numbers, on which the response hardly varies.
    least: f64,
    points: [OnceLock<ChebyshevPiece>; PIECES],
    lines: [OnceLock<ChebyshevPiece>; PIECES],
}

/// Product k H beyond which R(k) is negligible.
const GONE: f64 = 40.0;
/// Thickness of a kernel times the wave number below which its response is assumed constant.
const LEAST: f64 = 1e-7;

/// Chebyshev coefficients of four functions of the distance on a piece.
type ChebyshevPiece = [[f64; TERMS]; 4];

/// Number of points at which a function is evaluated together.
const LANES: usize = 8;
type Lanes = [f64; LANES];

impl LayerCorrection {
    /// Creates the correction of a pair. Returns `None` for homogeneous bodies, which require no correction.
    pub(crate) fn of(pair: &ElasticPair) -> Option<Self> {
        if !pair.is_coated() {
            return None;
        }
        let bodies = pair.bodies();
        let [one, two] = bodies.each_ref().map(|body| {
            let less = |a: f64, b: f64| a - b;
            let added = times_k(body.base_compliances()).with(times_k(body.compliances()), less);
            let layers = body.layers();
            layers.first().map(|top| (2.0 * top.thickness(), added))
        });
        let two = two.map(|(depth, added)| {
            let coupling = -added.coupling;
            (depth, Response { coupling, ..added })
        });
        let images: Vec<_> = [one, two].into_iter().flatten().collect();
        let depths = images.iter().map(|&(depth, _)| depth);
        let longest = bodies.iter().map(slowest).fold(0.0, f64::max);
        Some(Self {
            kernel: Kernel::from(*pair),
            near: times_k(pair.compliances()),
            scale: depths.fold(f64::INFINITY, f64::min),
            least: 0.025 / longest,
            images,
            points: std::array::from_fn(|_| OnceLock::new()),
            lines: std::array::from_fn(|_| OnceLock::new()),
        })
    }

    /// Creates the correction of a kernel that tends to its pair for short waves.
    pub(crate) fn of_kernel(kernel: &Kernel, isotropic: &Isotropic) -> Self {
        let near = times_k(kernel.pair().compliances());
        let depth = 2.0 * isotropic.thickness;
        let added = isotropic.far.with(near, |far, near| far - near);
        Self {
            kernel: kernel.clone(),
            near,
            images: vec![(depth, added)],
            scale: depth,
            least: LEAST / isotropic.thickness,
            points: std::array::from_fn(|_| OnceLock::new()),
            lines: std::array::from_fn(|_| OnceLock::new()),
        }
    }

    /// Returns two pi times the integral of a component over a cell of half sides `[a, b]`. The point is at `(x, y)` from the
    /// centre of the cell.
    pub(crate) fn over_cell(&self, component: Component, sides: [f64; 2], x: f64, y: f64) -> f64 {
        let mut value = [0.0];
        self.at_each(component, sides, &[x], y, &mut value);
        value[0]
    }

    /// Computes the integral of [`Self::over_cell`] at the points `(x, y)` of a row, with ascending `x >= 0`. The values
    /// are as smooth along x as the kernels. If a piece of the row is many cells long, the values at its points are interpolated.
    /// The choice does not depend on the end of the row, so that rows of all lengths have the same values.
    pub(crate) fn along_row(
        &self,
        component: Component,
        sides: [f64; 2],
        xs: &[f64],
        y: f64,
        out: &mut [f64],
    ) {
        let width = 2.0 * sides[0];
        let (mut done, mut ends) = (0, [0.0, 0.5 * self.scale.hypot(y)]);
        while done < xs.len() {
            let count = xs[done..].partition_point(|x| *x < ends[1]);
            let (xs, out) = (&xs[done..done + count], &mut out[done..done + count]);
            if ends[1] - ends[0] > (2 * TERMS) as f64 * width {
                let nodes = nodes(ends);
                let mut values = [0.0; TERMS];
                self.at_each(component, sides, &nodes, y, &mut values);
                let terms = chebyshev(|node| values[node]);
                for (xs, out) in xs.chunks(LANES).zip(out.chunks_mut(LANES)) {
                    let t = std::array::from_fn(|n| scaled(ends, xs[n.min(xs.len() - 1)]));
                    let found: Lanes = clenshaw(&terms, t);
                    out.copy_from_slice(&found[..xs.len()]);
                }
            } else {
                self.at_each(component, sides, xs, y, out);
            }
            done += count;
            ends = [ends[1], 2.0 * ends[1]];
        }
    }

    fn at_each(&self, component: Component, sides: [f64; 2], xs: &[f64], y: f64, out: &mut [f64]) {
        let mut done = 0;
        while let Some(&x) = xs.get(done) {
            let rules = self.rules(sides, x, y);
            if rules.iter().all(Option::is_some) {
                let alike = |x: &&f64| self.rules(sides, **x, y) == rules;
                let count = xs[done..].iter().take(LANES).take_while(alike).count();
                let end = done + count;
                let own = (&xs[done..end], &mut out[done..end]);
                self.by_rules(
                    component,
                    sides,
                    rules.map(Option::unwrap_or_default),
                    own,
                    y,
                );
                done = end;
            } else {
                out[done] = self.halved(component, sides, rules, [x, y]);
                done += 1;
            }
        }
    }

    /// Returns the sum over the two halves of a cell. The side that is too long is halved. If both sides are too long, the
    /// longer side is halved.
    fn halved(
        &self,
        component: Component,
        [a, b]: [f64; 2],
        rules: [Option<usize>; 2],
        [x, y]: [f64; 2],
    ) -> f64 {
        let halves_x = rules[1].is_some() || (rules[0].is_none() && a >= b);
        let (half, [step_x, step_y]) = if halves_x {
            ([0.5 * a, b], [0.5 * a, 0.0])
        } else {
            ([a, 0.5 * b], [0.0, 0.5 * b])
        };
        let part =
            |sign: f64| self.over_cell(component, half, x + sign * step_x, y + sign * step_y);
        part(1.0) + part(-1.0)
    }

    /// Computes the integrals at up to `LANES` points that share their rules.
    fn by_rules(
        &self,
        component: Component,
        [a, b]: [f64; 2],
        [along_x, along_y]: [usize; 2],
        (xs, out): (&[f64], &mut [f64]),
        y: f64,
    ) {
        let centres: Lanes = std::array::from_fn(|n| xs[n.min(xs.len() - 1)]);
        let mut sums = [0.0; LANES];
        for &[node_y, weight_y] in RULES[along_y].1 {
            let y = y + b * node_y;
            for &[node_x, weight_x] in RULES[along_x].1 {
                let weight = weight_x * weight_y;
                let values = self.at_points(component, centres.map(|x| x + a * node_x), y);
                for (sum, value) in sums.iter_mut().zip(values) {
                    *sum += weight * value;
                }
            }
        }
        for (out, sum) in out.iter_mut().zip(sums) {
            *out = sum * a * b;
        }
    }

    /// Returns the integral over a cell and all its images along y. The distance `y` from the nearest image is between zero and
    /// `period/2`. Displacements are relative to the datum, [as](crate::influence::periodic_images) for the closed forms.
    pub(crate) fn over_rows(
        &self,
        component: Component,
        [a, b]: [f64; 2],
        [x, y]: [f64; 2],
        [period, datum]: [f64; 2],
    ) -> f64 {
        // At these y the images on both sides are symmetric, so odd components vanish.
        if component.is_odd()[1] && (y == 0.0 || 2.0 * y >= period) {
            return 0.0;
        }
        let share = 2.0 * b / period;
        let uniform = share * self.over_strip(component, a, x, datum);
        // A cell as long as the period is a strip, and far away every row of images acts like a strip.
        if share >= 1.0 || x >= a + FAR * period {
            return uniform;
        }
        let images = pieces(b, period).map(|piece| {
            piece.weight * self.over_cell(component, [a, piece.half], x, y + piece.offset)
        });
        uniform + images.sum::<f64>()
    }

    /// Returns the integral over an infinitely long strip of half width `a` along y, with displacements relative to the datum.
    pub(crate) fn over_strip(&self, component: Component, a: f64, x: f64, datum: f64) -> f64 {
        let Some(rule) = self.rule(a, x, 0.0) else {
            let part = |x: f64| self.over_strip(component, 0.5 * a, x, datum);
            return part(x + 0.5 * a) + part(x - 0.5 * a);
        };
        let at = |&[node, weight]: &[f64; 2]| weight * self.at_line(component, x + a * node, datum);
        a * RULES[rule].1.iter().map(at).sum::<f64>()
    }

    fn rules(&self, [a, b]: [f64; 2], x: f64, y: f64) -> [Option<usize>; 2] {
        [self.rule(a, x, y), self.rule(b, y, x)]
    }

    /// Returns the cheapest rule along a side of half length `a`. The cell is at the distance `x` along this side and at the
    /// distance `y` perpendicular to this side. The nearest singularity of the kernels is at the imaginary distance i H. Returns
    /// `None` if the side is too long.
    fn rule(&self, a: f64, x: f64, y: f64) -> Option<usize> {
        rule(a, x.hypot(y), self.scale)
    }

    fn at_points(&self, component: Component, x: Lanes, y: f64) -> Lanes {
        let distances = x.map(|x| (x * x + y * y).sqrt());
        let of = |function: usize| {
            let make = |ends| self.point_piece(ends);
            sample(&self.points, self.scale, distances, function, make)
        };
        let times = |values: Lanes, factor: &dyn Fn(f64) -> f64| -> Lanes {
            std::array::from_fn(|n| factor(x[n]) * values[n])
        };
        match component {
            Component::ZZ => of(0),
            Component::XX | Component::YY => {
                let sign = if component == Component::XX {
                    -1.0
                } else {
                    1.0
                };
                let (mean, turned) = (of(1), of(2));
                let turned = times(turned, &|x| sign * (x * x - y * y));
                std::array::from_fn(|n| mean[n] + turned[n])
            }
            Component::XY | Component::YX => times(of(2), &|x| -2.0 * x * y),
            Component::ZX => times(of(3), &|x| x),
            Component::XZ => times(of(3), &|x| -x),
            Component::ZY => times(of(3), &|_| y),
            Component::YZ => times(of(3), &|_| -y),
        }
    }

    fn at_line(&self, component: Component, x: f64, datum: f64) -> f64 {
        let of = |function: usize| {
            let make = |ends| self.line_piece(ends);
            sample(&self.lines, self.scale, [x.abs()], function, make)[0]
        };
        let images = self.images.iter();
        let image = |of: fn(&Response) -> f64| {
            let log = |depth: f64| -2.0 * (x / datum).hypot(depth / datum).ln();
            images
                .clone()
                .map(|(depth, part)| of(part) * log(*depth))
                .sum::<f64>()
        };
        let turned = || {
            let images = images.clone();
            let image = images.map(|(depth, part)| 2.0 * part.coupling * (x / depth).atan());
            image.sum::<f64>() + x * of(3)
        };
        match component {
            Component::ZZ => image(|part| part.normal) + of(0),
            Component::XX => image(|part| part.along) + of(1),
            Component::YY => image(|part| part.across) + of(2),
            Component::ZX => turned(),
            Component::XZ => -turned(),
            _ => 0.0,
        }
    }

    /// Returns k R(k).
    fn remainder(&self, k: f64) -> Response {
        let less = |a: f64, b: f64| a - b;
        let images = self.images.iter();
        images.fold(
            self.kernel.short_times_k(k).with(self.near, less),
            |rest, (depth, part)| {
                let decay = (-k * depth).exp();
                rest.with(*part, |rest, part| rest - decay * part)
            },
        )
    }

    fn point_piece(&self, ends: [f64; 2]) -> ChebyshevPiece {
        let waves = self.waves(ends, |rest| {
            let [mean, half] = [rest.along + rest.across, rest.along - rest.across];
            [rest.normal, 0.5 * mean, 0.5 * half, rest.coupling]
        });
        tabulated(ends, |r| {
            let mut sum = self.point_images(r);
            for (k, [normal, mean, half, coupling]) in &waves {
                let x = k * r;
                let [zero, one, two, _] = bessel(x);
                sum[0] += normal * zero;
                sum[1] += mean * zero;
                sum[2] += half * two * k * k;
                sum[3] += coupling * one * k;
            }
            sum
        })
    }

    /// Returns the contributions of the forces at depths z: the integrals of $`e^{-kz}/k`$ with the kernels $`J_0`$, $`J_1/r`$
    /// and $`J_2/r^2`$.
    fn point_images(&self, r: f64) -> [f64; 4] {
        let mut sum = [0.0; 4];
        for (depth, part) in &self.images {
            let distance = r.hypot(*depth);
            let below = distance + depth;
            sum[0] += part.normal / distance;
            sum[1] += 0.5 * (part.along + part.across) / distance;
            sum[2] += 0.5 * (part.along - part.across) / (below * below * distance);
            sum[3] += part.coupling / (below * distance);
        }
        sum
    }

    fn line_piece(&self, ends: [f64; 2]) -> ChebyshevPiece {
        let waves = self.waves(ends, |rest| {
            [rest.normal, rest.along, rest.across, rest.coupling]
        });
        tabulated(ends, |x| {
            let mut sum = [0.0; 4];
            for (k, [normal, along, across, coupling]) in &waves {
                let (sine, cosine) = (k * x).sin_cos();
                let turned = if x > 0.0 { sine / x } else { *k };
                sum[0] += 2.0 * normal * cosine / k;
                sum[1] += 2.0 * along * cosine / k;
                sum[2] += 2.0 * across * cosine / k;
                sum[3] += 2.0 * coupling * turned / k;
            }
            sum
        })
    }

    /// Returns wave numbers, and parts of k R(k) times the weights of a quadrature, for distances between the ends of a piece.
    fn waves(
        &self,
        [near, far]: [f64; 2],
        of: impl Fn(Response) -> [f64; 4],
    ) -> Vec<(f64, [f64; 4])> {
        let numbers = wave_numbers([near, far], GONE / self.scale, self.least).into_iter();
        let weighted =
            |(k, weight): (f64, f64)| (k, of(self.remainder(k)).map(|value| weight * value));
        numbers.map(weighted).collect()
    }
}

fn times_k(compliances: Compliances) -> Response {
    Response {
        normal: compliances.normal,
        along: compliances.normal,
        across: compliances.normal + compliances.lateral,
        coupling: 0.5 * compliances.coupling,
    }
}

/// Returns a length beyond which a body responds like its base. The length is the total thickness of the layers times the
/// contrast of their moduli.
pub(crate) fn slowest(body: &Material) -> f64 {
    let layers = body.layers().iter();
    let thickness: f64 = layers.clone().map(Layer::thickness).sum();
    let base = (!body.youngs_modulus().is_infinite()).then(|| body.shear_modulus());
    let moduli = || layers.clone().map(Layer::shear_modulus).chain(base);
    let (most, least) = (
        moduli().fold(0.0, f64::max),
        moduli().fold(f64::INFINITY, f64::min),
    );
    thickness * (most / least)
}

/// Returns the values of one of the tabulated functions at some distances. The table of a piece is created at its first
/// use.
fn sample<const N: usize>(
    table: &[OnceLock<ChebyshevPiece>; PIECES],
    scale: f64,
    distances: [f64; N],
    function: usize,
    make: impl Fn([f64; 2]) -> ChebyshevPiece,
) -> [f64; N] {
    let octave = |distance: f64| piece_of(distance, scale);
    let on_piece = |piece: usize| {
        let ends = ends_of(piece, scale);
        let terms = &table[piece].get_or_init(|| make(ends))[function];
        (terms, ends)
    };
    let first = octave(distances[0]);
    if distances.iter().all(|&distance| octave(distance) == first) {
        let (terms, ends) = on_piece(first);
        return clenshaw(terms, distances.map(|distance| scaled(ends, distance)));
    }
    distances.map(|distance| {
        let (terms, ends) = on_piece(octave(distance));
        clenshaw(terms, [scaled(ends, distance)])[0]
    })
}

/// Returns a sum of Chebyshev polynomials at half of the given arguments.
fn clenshaw<const N: usize>(terms: &[f64; TERMS], t: [f64; N]) -> [f64; N] {
    let (mut next, mut after) = ([0.0; N], [0.0; N]);
    for term in terms[1..].iter().rev() {
        for n in 0..N {
            let value = t[n] * next[n] - after[n] + term;
            after[n] = next[n];
            next[n] = value;
        }
    }
    std::array::from_fn(|n| 0.5 * t[n] * next[n] - after[n] + terms[0])
}

/// Returns twice the relative position of a number between two ends. The relative position is -1 at the start and 1 at
/// the end.
fn scaled([start, end]: [f64; 2], x: f64) -> f64 {
    4.0 * (x - 0.5 * (start + end)) / (end - start)
}
