//! Closed-form solutions for checking results.

use stickslip_rs::analytical::{
    BentallJohnson, Carter, CattaneoMindlin, HertzEllipse, HertzLine, HertzSphere,
    KalkerCoefficients, VermeulenJohnson,
};

use crate::call::call;
use crate::half_space::stickslip_half_space;
use crate::pointer::Place;
use crate::status::stickslip_status;
use crate::text_fields::tell;

/// Hertz solution for the frictionless contact of a sphere and a plane.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct stickslip_hertz {
    /// Radius of the contact (a length): a = (3 W R/(4 E*))^(1/3), with the force W and the radius R of the sphere.
    pub contact_radius: f64,
    /// Pressure at the centre: p0 = 3 W/(2 pi a^2). At the distance r from the centre, the pressure is p0 (1 -
    /// r^2/a^2)^(1/2).
    pub max_pressure: f64,
    /// Approach of the bodies (a length): a^2/R.
    pub approach: f64,
    /// Reserved for future members: zero.
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

/// Computes the Hertz contact of a sphere with the given radius (a length) under a normal force, for the materials of the
/// bodies. Returns STICKSLIP_NOT_POSITIVE if the radius, the force or a result is not positive and finite.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_hertz_sphere(
    half_space: *const stickslip_half_space,
    radius: f64,
    force: f64,
    hertz: *mut stickslip_hertz,
) -> stickslip_status {
    // SAFETY: the caller follows the rule for pointers.
    unsafe {
        tell(half_space, ("hertz", hertz), |of| {
            Ok((&HertzSphere::new(of.pair(), radius, force)?).into())
        })
    }
}

/// Cattaneo-Mindlin solution for a sphere and a plane that are pressed together and then loaded tangentially.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct stickslip_cattaneo_mindlin {
    /// Normal contact.
    pub hertz: stickslip_hertz,
    /// Radius of the circular stick zone (a length): c = a (1 - |Q|/(mu W))^(1/3), with the tangential force Q; 0 without
    /// friction.
    pub stick_radius: f64,
    /// Shift (a length), with the sign of the force: 3 mu W/(16 a G*) (1 - c^2/a^2), with G* of
    /// stickslip_pair.
    pub shift: f64,
    /// Energy dissipated while the force grows from zero (a force times a length), zero or positive.
    pub dissipated_energy: f64,
    /// Reserved for future members: zero.
    pub reserved: [u64; 8],
}

/// Computes the Cattaneo-Mindlin contact of a sphere under a normal force and a tangential force of either sign, with a
/// coefficient of friction. Returns STICKSLIP_BEYOND_FRICTION_CAPACITY if friction cannot carry the tangential force. The
/// coupling of pressure and traction between dissimilar bodies is neglected.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_cattaneo_mindlin_sphere(
    half_space: *const stickslip_half_space,
    radius: f64,
    force: f64,
    friction: f64,
    tangential_force: f64,
    found: *mut stickslip_cattaneo_mindlin,
) -> stickslip_status {
    // SAFETY: the caller follows the rule for pointers.
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

/// Carter solution for a cylinder that rolls steadily on a plane with longitudinal creepage, in plane strain.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct stickslip_carter {
    /// Half-width of the contact (a length): a = (4 P R/(pi E*))^(1/2), with the force P per length and the radius R.
    pub half_width: f64,
    /// Pressure at the centre: p0 = 2 P/(pi a).
    pub max_pressure: f64,
    /// Smallest creepage at which the whole contact slips (dimensionless): 2 mu p0/E*.
    pub sliding_creepage: f64,
    /// Half-width of the stick strip at the leading edge x = a (a length): c = a (1 - |creepage|/sliding_creepage).
    pub stick_half_width: f64,
    /// Tangential force on body 1 (a force per length), with the sign of the creepage: mu P (1 - c^2/a^2).
    pub force: f64,
    /// Reserved for future members: zero.
    pub reserved: [u64; 8],
}

/// Computes the Carter contact of a cylinder with the given radius under a force per length, with a coefficient of friction
/// and a creepage of either sign. Returns STICKSLIP_COUPLED_MATERIALS if Dundurs' beta of the bodies is not zero.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_carter_cylinder(
    half_space: *const stickslip_half_space,
    radius: f64,
    force: f64,
    friction: f64,
    creepage: f64,
    found: *mut stickslip_carter,
) -> stickslip_status {
    // SAFETY: the caller follows the rule for pointers.
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

/// Bentall-Johnson solution for cylinders of different materials that roll freely, in plane strain. The solution is the
/// limit for a friction coefficient much smaller than the magnitude of Dundurs' beta. The leading edge is at the largest x;
/// with the leading edge at the smallest x, the creepage has the opposite sign.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct stickslip_bentall_johnson {
    /// Half-width of the contact (a length): a = (4 P R/(pi E*))^(1/2), with the force P per length and the radius R.
    pub half_width: f64,
    /// Pressure at the centre: p0 = 2 P/(pi a).
    pub max_pressure: f64,
    /// Creepage without a tangential force (dimensionless): 0.9148 beta a/R.
    pub creepage: f64,
    /// Half-width of the middle strip (a length): 0.4040 a. The slip changes its sign at the ends of this strip.
    pub reversal: f64,
    /// Energy dissipated by slip per unit length rolled (a force per length): 0.1239 mu |beta| P a/R.
    pub dissipation: f64,
    /// Reserved for future members: zero.
    pub reserved: [u64; 8],
}

/// Computes the Bentall-Johnson contact of a cylinder with the given radius that rolls freely under a force per length,
/// with a coefficient of friction. Bodies whose Dundurs' beta is zero do not slip.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_bentall_johnson_cylinder(
    half_space: *const stickslip_half_space,
    radius: f64,
    force: f64,
    friction: f64,
    found: *mut stickslip_bentall_johnson,
) -> stickslip_status {
    // SAFETY: the caller follows the rule for pointers.
    unsafe {
        tell(half_space, ("found", found), |of| {
            let hertz = HertzLine::new(of.pair(), radius, force)?;
            let own = BentallJohnson::new(hertz, friction)?;
            Ok(stickslip_bentall_johnson {
                half_width: hertz.half_width(),
                max_pressure: hertz.max_pressure(),
                creepage: own.creepage(),
                reversal: own.reversal(),
                dissipation: own.dissipation(),
                reserved: [0; 8],
            })
        })
    }
}

/// Kalker's coefficients, which determine the forces and the moment of an elliptic contact that rolls along x. The
/// creepages are so small that the contact sticks except at its trailing edge. Here a and b are the semi-axes along x
/// and y, c = (a b)^(1/2), and G is the shear modulus of both bodies. The creepages xi along x and eta along y and the
/// spin phi cause F_x = G c^2 c11 xi, F_y = G c^2 (c22 eta + c c23 phi) and the moment G c^3 (-c23 eta + c c33 phi) on
/// body 1.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct stickslip_kalker {
    /// Coefficient of the force along x due to the creepage along x.
    pub c11: f64,
    /// Coefficient of the force along y due to the creepage along y.
    pub c22: f64,
    /// Coefficient of the force along y due to the spin, and of the negated moment due to the creepage along y.
    pub c23: f64,
    /// Coefficient of the moment due to the spin.
    pub c33: f64,
    /// Reserved for future members: zero.
    pub reserved: [u64; 8],
}

impl From<&KalkerCoefficients> for stickslip_kalker {
    fn from(coefficients: &KalkerCoefficients) -> Self {
        Self {
            c11: coefficients.c11(),
            c22: coefficients.c22(),
            c23: coefficients.c23(),
            c33: coefficients.c33(),
            reserved: [0; 8],
        }
    }
}

/// Computes Kalker's coefficients for an ellipse with the ratio a/b of the semi-axes along and across the rolling
/// direction, from 1/16 to 16, and a Poisson's ratio from 0 to 1/2. Returns STICKSLIP_NOT_POSITIVE if the ratio a/b is not
/// positive and finite. Returns STICKSLIP_BELOW_MINIMUM for another ratio outside this range or a negative Poisson's ratio, and
/// STICKSLIP_POISSON_RATIO for a Poisson's ratio above 1/2.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_kalker_coefficients(
    ratio: f64,
    poisson_ratio: f64,
    found: *mut stickslip_kalker,
) -> stickslip_status {
    // SAFETY: the caller follows the rule for pointers.
    call(|| unsafe {
        let place = Place::new("found", found)?;
        place.put((&KalkerCoefficients::new(ratio, poisson_ratio)?).into());
        Ok(())
    })
}

/// Vermeulen-Johnson solution for an elliptic contact that rolls along x with creepages and without spin. The solution
/// has the initial slope of Kalker's theory, and its forces are a few per cent smaller than those of numerical
/// solutions.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct stickslip_vermeulen_johnson {
    /// Semi-axes of the contact along x and y (lengths).
    pub semi_axes: [f64; 2],
    /// Pressure at the centre.
    pub max_pressure: f64,
    /// Kalker's coefficients of the contact.
    pub coefficients: stickslip_kalker,
    /// Force that the creepages would cause without slip, divided by the friction limit (dimensionless). The whole
    /// contact slips if this ratio x is 3 or more.
    pub relative_creepage: f64,
    /// Tangential force on body 1 along x and y: mu W (1 - (1 - x/3)^3) in the direction of the force without slip, with
    /// the normal force W.
    pub force: [f64; 2],
    /// Reserved for future members: zero.
    pub reserved: [u64; 8],
}

/// Computes the Vermeulen-Johnson contact of a body with the radii of curvature radius_x and radius_y (lengths) under a
/// normal force, with a coefficient of friction and creepages of either sign. Returns STICKSLIP_COUPLED_MATERIALS if
/// Dundurs' beta of the bodies is not zero. Returns STICKSLIP_BELOW_MINIMUM if one semi-axis of the contact exceeds 16 times the
/// other.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_vermeulen_johnson_ellipse(
    half_space: *const stickslip_half_space,
    radius_x: f64,
    radius_y: f64,
    force: f64,
    friction: f64,
    creepage_x: f64,
    creepage_y: f64,
    found: *mut stickslip_vermeulen_johnson,
) -> stickslip_status {
    // SAFETY: the caller follows the rule for pointers.
    unsafe {
        tell(half_space, ("found", found), |of| {
            let hertz = HertzEllipse::new(of.pair(), radius_x, radius_y, force)?;
            let own = VermeulenJohnson::new(hertz, friction, [creepage_x, creepage_y])?;
            Ok(stickslip_vermeulen_johnson {
                semi_axes: hertz.semi_axes(),
                max_pressure: hertz.max_pressure(),
                coefficients: (&own.coefficients()).into(),
                relative_creepage: own.relative_creepage(),
                force: own.force(),
                reserved: [0; 8],
            })
        })
    }
}
