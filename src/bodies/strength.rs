//! Limits of pressure and traction compared with the moduli of the bodies.

use crate::bodies::material::{ElasticPair, Material};

/// Returns $`E / (1 - \nu^2)`$ (a pressure), the contact modulus of the body on a rigid body.
fn plane_strain_modulus(body: &Material) -> f64 {
    let poisson_ratio = body.poisson_ratio();
    body.youngs_modulus() / (1.0 - poisson_ratio * poisson_ratio)
}

impl ElasticPair {
    /// Returns a limit of the pressure or of the traction divided by the plane-strain modulus of the stiffer deformable body. Returns
    /// `None` without a limit, or if the bodies are not homogeneous, so that this modulus does not bound the stress.
    pub(crate) fn limit_over_modulus(&self, limit: f64) -> Option<f64> {
        let moduli = self
            .bodies()
            .map(|body| plane_strain_modulus(&body))
            .into_iter();
        let largest = moduli
            .filter(|modulus| modulus.is_finite())
            .reduce(f64::max);
        let largest = largest.filter(|_| self.is_homogeneous() && limit.is_finite());
        largest.map(|modulus| limit / modulus)
    }

    /// Returns the larger ratio of the stated hardness of a body to its plane-strain modulus. Returns `None` if no homogeneous body
    /// has a hardness, or if a kernel represents the bodies.
    pub(crate) fn hardness_over_modulus(&self) -> Option<f64> {
        let of_body = |body: &Material| {
            let is_comparable =
                body.hardness().is_finite() && !body.is_coated() && !body.is_rigid();
            is_comparable.then(|| body.hardness() / plane_strain_modulus(body))
        };
        let ratios = self.bodies().iter().filter_map(of_body).reduce(f64::max);
        ratios.filter(|_| self.check_no_kernel().is_ok())
    }
}
