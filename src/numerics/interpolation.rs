//! Interpolation by the polynomial through the nearest samples.

/// Number of samples that determine an interpolating cubic.
pub(crate) const CUBIC: usize = 4;

/// Samples and weights of an interpolated value.
pub(crate) struct LagrangeStencil {
    first: usize,
    width: usize,
    weights: [f64; CUBIC],
}

impl LagrangeStencil {
    /// Computes the Lagrange weights of the samples nearest to the position `t`, in units of the sample spacing.
    pub(crate) fn at(t: f64, count: usize, width: usize) -> Self {
        let width = width.min(count);
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "an integer within the samples"
        )]
        let first =
            (t.floor() - (width / 2) as f64 + 1.0).clamp(0.0, (count - width) as f64) as usize;
        let t = t - first as f64;
        let mut weights = [0.0; CUBIC];
        for (k, weight) in weights[..width].iter_mut().enumerate() {
            let others = (0..width).filter(|&m| m != k).map(|m| m as f64);
            *weight = others.map(|m| (t - m) / (k as f64 - m)).product();
        }
        Self {
            first,
            width,
            weights,
        }
    }

    /// Returns the value that the samples interpolate. `sample` returns the sample of an index.
    pub(crate) fn apply(&self, sample: impl Fn(usize) -> f64) -> f64 {
        let terms = self.weights[..self.width].iter().enumerate();
        terms
            .map(|(k, weight)| weight * sample(self.first + k))
            .sum()
    }
}
