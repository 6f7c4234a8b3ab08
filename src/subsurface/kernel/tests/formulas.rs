//! Closed forms compared with quadrature, the equations of elasticity and the point force.

use super::{Numbers, at, error};
use crate::subsurface::kernel::{LoadedRectangle, PotentialIntegral};
use std::f64::consts::PI;

/// Computes the nodes and weights of the Gauss-Legendre rule with `n` points by Newton's method.
fn gauss(n: u32) -> Vec<[f64; 2]> {
    let legendre = |x: f64| {
        let (mut last, mut value) = (1.0, x);
        for k in 2..=n {
            let k = f64::from(k);
            (last, value) = (value, ((2.0 * k - 1.0) * x * value - (k - 1.0) * last) / k);
        }
        (value, f64::from(n) * (x * value - last) / (x * x - 1.0))
    };
    let node = |k: u32| {
        let mut x = (PI * (f64::from(k) + 0.75) / (f64::from(n) + 0.5)).cos();
        for _ in 0..8 {
            let (value, slope) = legendre(x);
            x -= value / slope;
        }
        let (_, slope) = legendre(x);
        [x, 2.0 / ((1.0 - x * x) * slope * slope)]
    };
    (0..n).map(node).collect()
}

/// Returns the integrands, obtained by differentiation.
fn integrands([x, y, z]: [f64; 3]) -> [f64; PotentialIntegral::COUNT] {
    let r = (x * x + y * y + z * z).sqrt();
    let s = r + z;
    let t = |a: f64, b: f64, c: f64| 3.0 * a * b * c / r.powi(5);
    let of = |integral| match integral {
        PotentialIntegral::V => 1.0 / r,
        PotentialIntegral::Lx => x / (r * s),
        PotentialIntegral::Ly => y / (r * s),
        PotentialIntegral::Wxx => -1.0 / s + x * x / (r * s * s),
        PotentialIntegral::Wxy => x * y / (r * s * s),
        PotentialIntegral::Lxx => 1.0 / (r * s) - x * x * (s + r) / (r.powi(3) * s * s),
        PotentialIntegral::Lxy => -x * y * (s + r) / (r.powi(3) * s * s),
        PotentialIntegral::Wxxy => y / (r * s * s) - x * x * y * (s + 2.0 * r) / (r * s).powi(3),
        PotentialIntegral::Wxyy => x / (r * s * s) - x * y * y * (s + 2.0 * r) / (r * s).powi(3),
        PotentialIntegral::Txxx => t(x, x, x),
        PotentialIntegral::Txxy => t(x, x, y),
        PotentialIntegral::Txyy => t(x, y, y),
        PotentialIntegral::Tyyy => t(y, y, y),
        PotentialIntegral::Txxz => t(x, x, z),
        PotentialIntegral::Txyz => t(x, y, z),
        PotentialIntegral::Tyyz => t(y, y, z),
        PotentialIntegral::Txzz => t(x, z, z),
        PotentialIntegral::Tyzz => t(y, z, z),
        PotentialIntegral::Tzzz => t(z, z, z),
    };
    PotentialIntegral::ALL.map(of)
}

/// Checks that each integrand is the derivative of a function with a simpler formula.
#[test]
fn integrands_are_derivatives() {
    let mut numbers = Numbers::new();
    for _ in 0..100 {
        let point = [(); 3].map(|()| numbers.between(0.2, 1.5));
        let derivative = |axis: usize, of: &dyn Fn([f64; 3]) -> f64| {
            let at = |k: f64| {
                let mut moved = point;
                moved[axis] += k * 1e-3;
                of(moved)
            };
            (45.0 * (at(1.0) - at(-1.0)) - 9.0 * (at(2.0) - at(-2.0)) + at(3.0) - at(-3.0)) / 0.06
        };
        let r = |[x, y, z]: [f64; 3]| (x * x + y * y + z * z).sqrt();
        let logarithm = |p: [f64; 3]| (r(p) + p[2]).ln();
        let w = |p: [f64; 3]| p[2] * logarithm(p) - r(p);
        let wx = |p: [f64; 3]| -p[0] / (r(p) + p[2]);
        assert!((derivative(2, &w) - logarithm(point)).abs() < 1e-10);
        assert!((derivative(2, &logarithm) - 1.0 / r(point)).abs() < 1e-10);
        assert!((derivative(0, &w) - wx(point)).abs() < 1e-10);

        let of = |integral: PotentialIntegral| move |p| integrands(p)[integral.index()];
        let is = |integral: PotentialIntegral, axis, of: &dyn Fn([f64; 3]) -> f64| {
            let [found, expected] = [integrands(point)[integral.index()], derivative(axis, of)];
            assert!(
                (found - expected).abs() < 1e-10 * (1.0 + found.abs()),
                "{integral:?}"
            );
        };
        is(PotentialIntegral::Lx, 0, &logarithm);
        is(PotentialIntegral::Ly, 1, &logarithm);
        is(PotentialIntegral::Wxx, 0, &wx);
        is(PotentialIntegral::Wxy, 1, &wx);
        is(PotentialIntegral::Lxx, 0, &of(PotentialIntegral::Lx));
        is(PotentialIntegral::Lxy, 1, &of(PotentialIntegral::Lx));
        is(PotentialIntegral::Wxxy, 0, &of(PotentialIntegral::Wxy));
        is(PotentialIntegral::Wxyy, 1, &of(PotentialIntegral::Wxy));
    }
}

#[test]
fn integrals_by_quadrature() {
    let rule = gauss(20);
    let mut numbers = Numbers::new();
    for sides in [[0.5, 0.5], [1.5, 0.5], [0.25, 1.0]] {
        let cell = LoadedRectangle::new(sides[0], sides[1]);
        for _ in 0..30 {
            let point = [2.0, 2.0].map(|reach| numbers.between(-reach, reach));
            let z = numbers.between(0.2, 2.0);
            let mut sums = [0.0; PotentialIntegral::COUNT];
            let parts = 8;
            for [k, l] in (0..parts * parts).map(|k| [k / parts, k % parts]) {
                let small = sides.map(|side| side / f64::from(parts));
                let centre = [k, l].map(|k| f64::from(2 * k + 1 - parts));
                for &[node_x, weight_x] in &rule {
                    for &[node_y, weight_y] in &rule {
                        let x = point[0] - small[0] * (centre[0] + node_x);
                        let y = point[1] - small[1] * (centre[1] + node_y);
                        let weight = small[0] * small[1] * weight_x * weight_y;
                        for (sum, value) in sums.iter_mut().zip(integrands([x, y, z])) {
                            *sum += weight * value;
                        }
                    }
                }
            }
            let found = cell.integrals([point[0], point[1], z]);
            for ((found, expected), integral) in found.iter().zip(sums).zip(PotentialIntegral::ALL)
            {
                let error = (found - expected).abs();
                assert!(
                    error < 1e-14 * (1.0 + expected.abs()),
                    "{integral:?} {error:e}"
                );
            }
        }
    }
}

/// Returns sixth-order differences along x, y and z of all components.
fn gradients(cell: &LoadedRectangle, point: [f64; 3], step: f64, nu: f64) -> [[[f64; 9]; 3]; 3] {
    [0, 1, 2].map(|axis| {
        let at = |k: f64| {
            let mut moved = point;
            moved[axis] += k * step;
            at(cell, moved, nu)
        };
        let steps = [1.0, 2.0, 3.0].map(|k| [at(k), at(-k)]);
        [0, 1, 2].map(|load| {
            [0, 1, 2, 3, 4, 5, 6, 7, 8].map(|k| {
                let [one, two, three] = steps.map(|[up, down]| up[load][k] - down[load][k]);
                (45.0 * one - 9.0 * two + three) / (60.0 * step)
            })
        })
    })
}

#[test]
fn equilibrium_and_the_law_of_hooke() {
    let mut numbers = Numbers::new();
    for sides in [[0.5, 0.5], [1.5, 0.5], [0.5, 20.0]] {
        let cell = LoadedRectangle::new(sides[0], sides[1]);
        for _ in 0..60 {
            let [x, y] = sides.map(|side| side * numbers.between(-3.0, 3.0));
            let (z, nu) = (numbers.between(0.4, 4.0), numbers.between(0.0, 0.49));
            let point = [x, y, z];
            let stresses = at(&cell, point, nu);
            let gradients = gradients(&cell, point, 0.006, nu);
            for (load, stress) in stresses.iter().enumerate() {
                let [along_x, along_y, along_z] = gradients.map(|gradient| gradient[load]);
                let forces = [[3, 6, 7], [6, 4, 8], [7, 8, 5]];
                for force in forces.map(|[i, j, k]| along_x[i] + along_y[j] + along_z[k]) {
                    assert!(force.abs() < 1e-9, "{force:e} {sides:?} {point:?}");
                }
                // With G = 1, sij = ui,j + uj,i, plus 2 nu/(1 - 2 nu) times the dilatation on the diagonal.
                let dilatation = along_x[0] + along_y[1] + along_z[2];
                let mean = 2.0 * nu / (1.0 - 2.0 * nu) * dilatation;
                let expected = [
                    2.0 * along_x[0] + mean,
                    2.0 * along_y[1] + mean,
                    2.0 * along_z[2] + mean,
                    along_x[1] + along_y[0],
                    along_x[2] + along_z[0],
                    along_y[2] + along_z[1],
                ];
                for (found, expected) in stress[3..].iter().zip(expected) {
                    let error = (found - expected).abs();
                    assert!(error < 2e-9, "{error:e} {sides:?} {point:?}");
                }
            }
        }
    }
}

/// Returns the displacements (G = 1) and stresses of a unit force on the surface, after Boussinesq and
/// Cerruti.
fn point_force([x, y, z]: [f64; 3], nu: f64) -> [[f64; 9]; 2] {
    let r = (x * x + y * y + z * z).sqrt();
    let (s, e) = (r + z, 1.0 - 2.0 * nu);
    let [s2, r3, r5, flat] = [s * s, r.powi(3), r.powi(5), x * x + y * y];
    let normal = [
        (z * x / r3 - e * x / (r * s)) / (4.0 * PI),
        (z * y / r3 - e * y / (r * s)) / (4.0 * PI),
        (z * z / r3 + 2.0 * (1.0 - nu) / r) / (4.0 * PI),
        e / flat * ((1.0 - z / r) * (x * x - y * y) / flat + z * y * y / r3) / (2.0 * PI),
        e / flat * ((1.0 - z / r) * (y * y - x * x) / flat + z * x * x / r3) / (2.0 * PI),
        0.0,
        e * x * y * (2.0 * r + z) / (r3 * s2) / (2.0 * PI),
        0.0,
        0.0,
    ];
    // These are 1/(r s^2) and the factor of the products of three coordinates.
    let (one, three) = (1.0 / (r * s2), 1.0 / (r3 * s2) + 2.0 / (r * r * s2 * s));
    let tangential = [
        (1.0 / r + x * x / r3 + e * (1.0 / s - x * x * one)) / (4.0 * PI),
        (x * y / r3 - e * x * y * one) / (4.0 * PI),
        (x * z / r3 + e * x / (r * s)) / (4.0 * PI),
        e * x * (1.0 / r3 - 3.0 * one + x * x * three) / (2.0 * PI),
        e * x * (1.0 / r3 - one + y * y * three) / (2.0 * PI),
        0.0,
        e * y * (x * x * three - one) / (2.0 * PI),
        0.0,
        0.0,
    ];
    // These terms remain for nu = 1/2.
    let pairs = [x * x, y * y, z * z, x * y, x * z, y * z];
    let add = |mut of: [f64; 9], along: f64| {
        for (stress, pair) in of[3..].iter_mut().zip(pairs) {
            *stress -= 3.0 * along * pair / (2.0 * PI * r5);
        }
        of
    };
    [add(normal, z), add(tangential, x)]
}

#[test]
fn far_away_a_point_force() {
    let mut numbers = Numbers::new();
    let cell = LoadedRectangle::new(0.5, 0.25);
    for distance in [1e3, 1e5, 1e7, 1e9] {
        for _ in 0..100 {
            let direction = [0.3, -1.0, 0.0].map(|low| numbers.between(low, 1.0));
            let length = direction.iter().map(|c| c * c).sum::<f64>().sqrt();
            let point = direction.map(|c| c / length * distance);
            let nu = numbers.between(0.0, 0.5);
            let found = at(&cell, point, nu);
            let tolerance = (10.0 / (distance * distance)).max(3e-14);
            for (found, expected) in found.iter().zip(point_force(point, nu)) {
                let error = error(found, &expected.map(|value| 0.5 * value));
                assert!(error < tolerance, "{error:e} {point:?} {nu}");
            }
        }
    }
}

/// Checks that distances of tiny and huge cells neither underflow nor overflow.
#[test]
fn any_unit_of_length() {
    let point = [0.3, -1.2, 0.7];
    let expected = at(&LoadedRectangle::new(0.5, 0.25), point, 0.3);
    for unit in [2_f64.powi(-600), 2_f64.powi(600)] {
        let found = at(
            &LoadedRectangle::new(0.5 * unit, 0.25 * unit),
            point.map(|c| c * unit),
            0.3,
        );
        for (found, expected) in found.iter().zip(expected) {
            let (displacements, stresses) = found.split_at(3);
            assert_eq!(
                displacements,
                expected[..3].iter().map(|u| u * unit).collect::<Vec<_>>()
            );
            assert_eq!(stresses, expected[3..].to_vec());
        }
    }
}
