//! The choice of the body whose interior is computed, and its half-space.

use crate::bodies::material::{ElasticPair, Material};
use crate::error::{Error, Result};
use crate::subsurface::kernel::{FieldComponent, Load};

/// One of the two bodies of a contact.
///
/// In both bodies, depths are measured from the surface into the body and are never negative. A depth of `d` corresponds to the
/// plane `z = d` in body 1 and to the plane `z = -d` in body 2. Components refer to the common axes x, y and z in both bodies,
/// with z into body 1. Body 1 receives the pressure along +z and the tractions along +x and +y. Body 2 receives the opposite
/// tractions. Therefore both bodies have `szz = -p`, `sxz = -qx` and `syz = -qy` on their surfaces.
///
/// ```
/// use stickslip::subsurface::{Body, Tractions, at_points};
/// use stickslip::*;
/// let body = |shear_modulus| Material::from_shear_modulus(shear_modulus, 0.3);
/// let pair = ElasticPair::new(body(1.0)?, body(4.0)?)?;
/// let bodies = HalfSpace::new(Grid::square(8, 1.0)?, pair)?;
/// let pressure = Field::constant(bodies.grid(), 0.1);
/// let at = |body| at_points(&bodies, body, Tractions::new(&pressure), &[[0.1, 0.2, 0.3]]);
/// let (one, two) = (at(Body::One)?[0], at(Body::Two)?[0]);
/// // Both bodies have the same stress and move away from the contact. The stiffer body moves less.
/// assert!((one.displacement[2] / two.displacement[2] + 4.0).abs() < 1e-12);
/// assert!((one.stress.zz / two.stress.zz - 1.0).abs() < 1e-12);
/// # Ok::<(), Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Body {
    /// Body 1, into which z points.
    One,
    /// Body 2, from which z points away.
    Two,
}

/// Material of the half-space `z >= 0` that represents a body, and signs of its tractions.
#[derive(Debug, Clone, Copy)]
pub(super) struct Constants {
    pub(super) shear_modulus: f64,
    pub(super) poisson_ratio: f64,
    is_second: bool,
    coated: Option<Material>,
}

/// Returns an error if the bodies are defined by a kernel, which does not describe their interior.
pub(super) fn check_described(pair: &ElasticPair) -> Result<()> {
    if pair.stands_for_kernel() {
        return Err(Error::UnsupportedForCoatings {
            quantity: "the stress below the surface",
            bodies: "kernels",
            remedy: "describe the bodies by materials and layers",
        });
    }
    Ok(())
}

impl Body {
    pub(super) fn constants(self, pair: &ElasticPair) -> Result<Constants> {
        let [one, two] = pair.bodies();
        let (material, name) = match self {
            Self::One => (one, "body 1"),
            Self::Two => (two, "body 2"),
        };
        check_described(pair)?;
        if material.is_rigid() {
            return Err(Error::RigidBody(name));
        }
        let is_coated = material.is_coated();
        Ok(Constants {
            // The kernels of a coated body include its moduli.
            shear_modulus: if is_coated {
                1.0
            } else {
                material.shear_modulus()
            },
            poisson_ratio: material.poisson_ratio(),
            is_second: self == Self::Two,
            coated: is_coated.then_some(material),
        })
    }
}

/// Body 2 is represented by the half-space `z >= 0` mirrored in z. Its tractions along x and y have the opposite sign.
impl Constants {
    /// Returns the material if the body is coated.
    pub(super) fn coated(&self) -> Option<&Material> {
        self.coated.as_ref()
    }

    /// Returns the index of the kernels of this body at a depth. The index is 0 for homogeneous bodies, 1 for a coated
    /// body 1 and 2 for a coated body 2.
    pub(super) fn place(&self) -> usize {
        match (&self.coated, self.is_second) {
            (None, _) => 0,
            (Some(_), false) => 1,
            (Some(_), true) => 2,
        }
    }

    /// Returns an error if one of the depths is in a rigid base.
    pub(super) fn check_depths(&self, depths: &[f64]) -> Result<()> {
        let Some(body) = self
            .coated
            .filter(|body| body.youngs_modulus().is_infinite())
        else {
            return Ok(());
        };
        let name = if self.is_second {
            "the base of body 2"
        } else {
            "the base of body 1"
        };
        let is_in_base = |depth: &f64| body.waves().place(*depth).0.is_none();
        if depths.iter().any(is_in_base) {
            return Err(Error::RigidBody(name));
        }
        Ok(())
    }

    /// Returns the factor by which a traction is multiplied before it acts on the half-space.
    pub(super) fn factor_in(&self, load: Load) -> f64 {
        if self.is_second && load != Load::P {
            -1.0
        } else {
            1.0
        }
    }

    /// Returns the factor that converts a component composed of the integrals to the component of the body.
    pub(super) fn factor_out(&self, component: FieldComponent) -> f64 {
        let sign = if self.is_second && component.is_odd_in_z() {
            -1.0
        } else {
            1.0
        };
        if component.is_displacement() {
            sign / self.shear_modulus
        } else {
            sign
        }
    }
}
