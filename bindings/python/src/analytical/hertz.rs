//! Smooth bodies pressed together without friction.

use pyo3::prelude::*;

use crate::analytical::closed_form::closed_form;
use crate::analytical::coordinates::{Coordinates, PlaneStrain};
use crate::material::{ElasticPair, Pair};

closed_form! {
    /// A sphere or a paraboloid of revolution pressed on a half-space.
    ///
    /// The gap is r^2 / 2R. The solution is exact for a paraboloid; for a sphere it is valid if the contact is small
    /// compared with R. Johnson (1985), 4.22-4.24.
    ///
    /// Parameters
    /// ----------
    /// pair : ElasticPair or two Materials
    ///     The bodies.
    /// radius : float
    ///     Radius R of the sphere (a length), positive; for two spheres 1/R = 1/R_1 + 1/R_2.
    /// load : float
    ///     Normal load W (a force), positive.
    ///
    /// Raises
    /// ------
    /// NotPositive
    HertzSphere(pair: Pair => &pair.0, radius, load)
    objects {
        /// The bodies.
        pair: ElasticPair,
    }
    numbers {
        /// Radius R of the sphere (a length).
        radius,
        /// Normal load W (a force), positive in compression.
        load,
        /// Radius of the contact circle, a = (3 W R / (4 E*))^(1/3) (a length).
        contact_radius,
        /// Area of the contact circle, pi a^2 (a length squared).
        contact_area,
        /// Pressure at the centre, p_0 = 3 W / (2 pi a^2).
        max_pressure,
        /// Mean pressure over the contact circle, W / (pi a^2) = (2/3) p_0.
        mean_pressure,
        /// Approach of the bodies, delta = a^2 / R (a length), positive.
        approach,
    }
    along {
        /// Returns the pressure p_0 sqrt(1 - r^2/a^2) at the distance r from the centre, or zero outside the contact.
        /// Johnson (1985), 3.39.
        pressure(r),
        /// Returns the normal displacement u_z of the surfaces (a length), summed over the bodies and positive into each,
        /// at the distance r from the centre, inside and outside the contact. Johnson (1985), 3.41a and 3.42a.
        displacement(r),
        /// Returns the gap u_z + r^2 / 2R - delta between the surfaces (a length) at the distance r from the centre; zero
        /// in the contact, positive outside.
        gap(r),
    }
}

closed_form! {
    /// A paraboloid with two different curvatures pressed on a half-space.
    ///
    /// The gap is x^2 / 2R_x + y^2 / 2R_y. Johnson (1985), 4.26-4.32.
    ///
    /// Parameters
    /// ----------
    /// pair : ElasticPair or two Materials
    ///     The bodies.
    /// radius_x, radius_y : float
    ///     Radii of curvature R_x and R_y along x and y (lengths), positive.
    /// load : float
    ///     Normal load W (a force), positive.
    ///
    /// Raises
    /// ------
    /// NotPositive
    HertzEllipse(pair: Pair => &pair.0, radius_x, radius_y, load)
    objects {
        /// The bodies.
        pair: ElasticPair,
    }
    numbers {
        /// Normal load W (a force), positive in compression.
        load,
        /// Area of the contact ellipse, pi a b with the semi-axes a and b (a length squared).
        contact_area,
        /// Pressure at the centre, p_0 = 3 W / (2 pi a b). Johnson (1985), 4.27.
        max_pressure,
        /// Approach of the bodies, delta = p_0 b K / E* (a length, positive), with the shorter semi-axis b and the
        /// complete elliptic integral K of the parameter 1 - b^2/a^2. Johnson (1985), 4.26c.
        approach,
    }
    pairs {
        /// Radii of curvature (R_x, R_y) (lengths).
        radii,
        /// Semi-axes a_x and a_y of the contact ellipse along x and y (lengths). Johnson (1985), 4.28-4.31.
        semi_axes,
    }
    across {
        /// Returns the pressure p_0 sqrt(1 - x^2/a_x^2 - y^2/a_y^2), or zero outside the contact. Johnson (1985), 3.58.
        pressure,
    }
}

closed_form! {
    /// A cylinder pressed on a half-space along a line, in plane strain.
    ///
    /// The gap is x^2 / 2R. The solution is exact for a parabola. Johnson (1985), 4.43-4.45.
    ///
    /// Parameters
    /// ----------
    /// pair : ElasticPair or two Materials
    ///     The bodies.
    /// radius : float
    ///     Radius R of the cylinder (a length), positive; for two cylinders 1/R = 1/R_1 + 1/R_2.
    /// load : float
    ///     Normal load P (a force per length), positive.
    ///
    /// Raises
    /// ------
    /// NotPositive
    HertzLine(pair: Pair => &pair.0, radius, load)
    objects {
        /// The bodies.
        pair: ElasticPair,
    }
    numbers {
        /// Radius R of the cylinder (a length).
        radius,
        /// Normal load P (a force per length), positive in compression.
        load,
        /// Half-width of the contact, a = sqrt(4 P R / (pi E*)) (a length).
        half_width,
        /// Pressure at the middle, p_0 = 2 P / (pi a).
        max_pressure,
    }
    along {
        /// Returns the pressure p_0 sqrt(1 - x^2/a^2) at the distance x from the middle, or zero outside the contact.
        pressure(x),
        /// Returns the approach of the bodies, P / (pi E*) (2 ln(2d/a) + 1) (a length), relative to the datum d (a
        /// length) of :meth:`Boundary.periodic_along_y`. The datum must be large compared with a; the approach is then
        /// positive. It is NaN if the datum is zero or negative.
        approach(datum),
        /// Stress xx of the surface of either body at x (a pressure, positive in tension): minus the pressure in the
        /// contact, zero outside.
        surface_stress(x),
    }
    also {
        /// Returns the stresses xx, zz and xz of body 1 at x and at a depth (a length, zero or more) below its surface
        /// (pressures, positive in tension). In body 2 at the same depth, xz has the opposite sign. M'Ewen (1949);
        /// Johnson (1985), 4.49.
        ///
        /// Raises
        /// ------
        /// ArgumentRange
        ///     If a depth is negative.
        fn stress(&self, py: Python<'_>, x: Coordinates, depth: Coordinates) -> PyResult<PlaneStrain> {
            let depth = depth.check_depth(py)?;
            let stress = x.all_across(depth, |x, depth| self.0.stress(x, depth))?;
            Ok(stress.into())
        }
    }
}
