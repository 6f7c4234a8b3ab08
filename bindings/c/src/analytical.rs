//! Closed forms, to check results by.

use stickslip_rs::analytical::{Carter, CattaneoMindlin, HertzLine, HertzSphere};

use crate::half_space::stickslip_half_space;
use crate::reading::tell;
use crate::status::stickslip_status;

/// The contact of a sphere and a plane without friction, by Hertz.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct stickslip_hertz {
    /// Radius of the contact (a length): a = (3 W R/(4 E*))^(1/3), with the force W and the radius R of the sphere.
    pub contact_radius: f64,
    /// Pressure at the centre: p0 = 3 W/(2 pi a^2). At the distance r from it the pressure is p0 (1 - r^2/a^2)^(1/2).
    pub max_pressure: f64,
    /// Approach of the bodies (a length): a^2/R.
    pub approach: f64,
    /// Room for members to come: zero.
    pub reserved: [u64; 8],
}

impl From<&HertzSphere> for stickslip_hertz {
    fn from(hertz: &HertzSphere) -> Self {
        Self {
            contact_radius: hertz.contact_radius(),
            max_pressure: hertz.max_pressure(),
            approach: hertz.approach(),
            reserved: [0; 8],
        }
    }
}

/// Hertz' contact of a sphere of this radius (a length) under this normal force on the materials of the bodies.
/// STICKSLIP_NOT_POSITIVE if radius, force or a result is not positive and finite.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_hertz_sphere(
    half_space: *const stickslip_half_space,
    radius: f64,
    force: f64,
    hertz: *mut stickslip_hertz,
) -> stickslip_status {
    // SAFETY: the rule for pointers.
    unsafe {
        tell(half_space, ("hertz", hertz), |of| {
            Ok((&HertzSphere::new(of.pair(), radius, force)?).into())
        })
    }
}

/// The contact of a sphere and a plane that is pressed and then loaded tangentially, by Cattaneo and Mindlin.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct stickslip_cattaneo_mindlin {
    /// The normal contact.
    pub hertz: stickslip_hertz,
    /// Radius of the circle that sticks (a length): c = a (1 - |Q|/(mu W))^(1/3), with the tangential force Q; 0 without
    /// friction.
    pub stick_radius: f64,
    /// Shift (a length), with the sign of the force: 3 mu W/(16 a G*) (1 - c^2/a^2), with G* of
    /// stickslip_pair.
    pub shift: f64,
    /// Energy dissipated as the force grows from zero (a force times a length), zero or positive.
    pub dissipated_energy: f64,
    /// Room for members to come: zero.
    pub reserved: [u64; 8],
}

/// Cattaneo and Mindlin's contact of a sphere under a normal force, with a coefficient of friction, under a tangential force
/// of either sign; STICKSLIP_BEYOND_FRICTION_CAPACITY if friction does not carry it. The coupling of pressure and traction of
/// dissimilar bodies is neglected.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_cattaneo_mindlin_sphere(
    half_space: *const stickslip_half_space,
    radius: f64,
    force: f64,
    friction: f64,
    tangential_force: f64,
    found: *mut stickslip_cattaneo_mindlin,
) -> stickslip_status {
    // SAFETY: the rule for pointers.
    unsafe {
        tell(half_space, ("found", found), |of| {
            let hertz = HertzSphere::new(of.pair(), radius, force)?;
            let own = CattaneoMindlin::new(hertz, friction, tangential_force)?;
            Ok(stickslip_cattaneo_mindlin {
                hertz: (&hertz).into(),
                stick_radius: own.stick_radius(),
                shift: own.shift(),
                dissipated_energy: own.energy_of_first_quarter(),
                reserved: [0; 8],
            })
        })
    }
}

/// A cylinder that rolls steadily on a plane with longitudinal creepage, in plane strain, by Carter.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct stickslip_carter {
    /// Half-width of the contact (a length): a = (4 P R/(pi E*))^(1/2), with the force P per length and the radius R.
    pub half_width: f64,
    /// Pressure at the centre: p0 = 2 P/(pi a).
    pub max_pressure: f64,
    /// The creepage from which on the whole contact slips (dimensionless): 2 mu p0/E*.
    pub sliding_creepage: f64,
    /// Half-width of the strip that sticks, at the leading edge x = a (a length): c = a (1 - |creepage|/sliding_creepage).
    pub stick_half_width: f64,
    /// Tangential force on body 1 (a force per length), with the sign of the creepage: mu P (1 - c^2/a^2).
    pub force: f64,
    /// Room for members to come: zero.
    pub reserved: [u64; 8],
}

/// Carter's contact of a cylinder of this radius under this force per length, with a coefficient of friction, at a creepage
/// of either sign. STICKSLIP_COUPLED_MATERIALS for bodies whose Dundurs' beta is not zero.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_carter_cylinder(
    half_space: *const stickslip_half_space,
    radius: f64,
    force: f64,
    friction: f64,
    creepage: f64,
    found: *mut stickslip_carter,
) -> stickslip_status {
    // SAFETY: the rule for pointers.
    unsafe {
        tell(half_space, ("found", found), |of| {
            let hertz = HertzLine::new(of.pair(), radius, force)?;
            let own = Carter::new(hertz, friction, creepage)?;
            Ok(stickslip_carter {
                half_width: hertz.half_width(),
                max_pressure: hertz.max_pressure(),
                sliding_creepage: own.sliding_creepage(),
                stick_half_width: own.stick_half_width(),
                force: own.force(),
                reserved: [0; 8],
            })
        })
    }
}
