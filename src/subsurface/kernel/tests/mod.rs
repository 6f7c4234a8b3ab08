//! Tests of the formulas against quadrature and the equations of elasticity, and tests of limits, symmetries and rows.

mod formulas;
mod surface_and_symmetry;

use super::{FieldComponent, Load, LoadedRectangle, Weights};

/// Returns all components at a point under unit `p`, `qx` and `qy`, with `G = 1`.
fn at(cell: &LoadedRectangle, point: [f64; 3], nu: f64) -> [[f64; FieldComponent::COUNT]; 3] {
    let (integrals, weights) = (cell.integrals(point), Weights::new(nu, point[2]));
    Load::ALL.map(|load| {
        FieldComponent::ALL.map(|component| {
            let products = weights.of(load, component).iter().zip(integrals);
            products.map(|(weight, integral)| weight * integral).sum()
        })
    })
}

/// Returns the largest error, relative to the largest displacement or the largest stress.
fn error(found: &[f64; 9], expected: &[f64; 9]) -> f64 {
    let mut worst: f64 = 0.0;
    for range in [0..3, 3..9] {
        let (found, expected) = (&found[range.clone()], &expected[range]);
        let scale = expected
            .iter()
            .fold(0.0_f64, |scale, value| scale.max(value.abs()));
        for (found, expected) in found.iter().zip(expected) {
            let difference = (found - expected).abs();
            assert!(!difference.is_nan(), "{found} {expected}");
            if difference > 0.0 {
                worst = worst.max(difference / scale);
            }
        }
    }
    worst
}

/// Deterministic sequence of numbers between 0 and 1.
struct Numbers(u64);

impl Numbers {
    fn new() -> Self {
        Self(0x9e37_79b9_7f4a_7c15)
    }

    fn next(&mut self) -> f64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }

    fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.next()
    }
}
