//! Closed-form contact solutions for the validation of computed contacts.
//!
//! # Normal contact
//!
//! | contact | type | source |
//! |---|---|---|
//! | sphere, or paraboloid of revolution | [`HertzSphere`] | Hertz; Johnson (1985), section 4.2 |
//! | elliptic paraboloid | [`HertzEllipse`] | Hertz; Johnson (1985), section 4.2 |
//! | cylinder along a line, in plane strain | [`HertzLine`] | Hertz; Johnson (1985), section 4.2 |
//! | rigid flat-ended cylinder | [`FlatPunch`] | Johnson (1985), section 3.4 |
//! | flat punch with rounded edges along a line | [`RoundedPunch`] | Ciavarella, Hills and Monno (1998) |
//! | cone | [`Cone`] | Sneddon (1965) |
//! | waves along x, in partial and in full contact | [`Westergaard`] | Westergaard (1939); Johnson (1985), section 13.2 |
//! | contact area of a rough sphere | [`RoughSphere`] | equation 32 of the paper, after Müser (2016) |
//! | contact area of a nominally flat rough surface | [`Persson`] | Persson (2001) |
//!
//! # Bodies of different materials, pressed together
//!
//! | contact | type | source |
//! |---|---|---|
//! | flat-ended cylinder without slip | [`NoSlipPunch`] | Mossakovskii (1954), Borodich and Keer (2004) |
//! | sphere without slip | [`NoSlipSphere`] | Spence (1968), Borodich and Keer (2004) |
//! | stick zone of a round contact | [`SpencePressing::round`] | Spence (1975) |
//! | stick zone of a plane contact | [`SpencePressing::plane`] | Spence (1973) |
//!
//! # Tangential load
//!
//! | contact | type | source |
//! |---|---|---|
//! | sphere in partial slip | [`CattaneoMindlin`] | Cattaneo (1938), Mindlin (1949) |
//! | sphere in partial slip under a varying tangential force | [`MindlinDeresiewicz`] | Mindlin and Deresiewicz (1953), Jaeger (1998) |
//! | elliptic paraboloid in partial slip | [`CattaneoMindlinEllipse`] | Mindlin (1949), Vermeulen and Johnson (1964) |
//! | cylinder along a line in partial slip, also under bulk strain | [`CattaneoMindlinLine`] | Johnson (1985), section 7.2; Nowell and Hills (1987) |
//! | cone in partial slip | [`ConePartialSlip`] | Ciavarella (1998b), Jaeger (1998) |
//! | waves in partial slip | [`WestergaardPartialSlip`] | Ciavarella (1998a), Jaeger (1998) |
//! | stick ratio of a nominally flat rough surface | [`Persson::stick_ratio`], [`linear_stick_ratio`] | Paggi et al. (2014), Ciavarella (1998b) |
//! | any contact circle in full stick | [`MindlinFullStick`] | Mindlin (1949) |
//! | rigid flat-ended cylinder in full stick | [`FlatPunch::full_stick`] | Johnson (1985), section 3.7 |
//! | sphere in partial slip under a twist | [`LubkinTorsion`] | Lubkin (1951) |
//! | paraboloid of revolution, limiting shape under fretting wear | [`PopovLimitingShape`] | Popov (2014) |
//!
//! # Rolling
//!
//! | contact | type | source |
//! |---|---|---|
//! | cylinder that rolls with creepage | [`Carter`] | Carter (1926), Fromm (1927) |
//! | cylinders of different materials that roll freely | [`BentallJohnson`] | Bentall and Johnson (1967) |
//! | ellipse that rolls with small creepages and spin | [`KalkerCoefficients`] | Kalker (1990) |
//! | ellipse that rolls with creepages | [`VermeulenJohnson`] | Vermeulen and Johnson (1964) |
//!
//! # Conventions
//! - The units can be any consistent set, for example `m, N, Pa` or `mm, N, MPa`.
//! - The contact, or a crest of waves, is centred on the origin of the plane `z = 0`; z points into body 1.
//! - Pressure is positive in compression. Traction acts on body 1 and is positive along +x; body 2 receives the
//!   opposite traction.
//! - Displacements are relative. The normal displacement is the sum over the bodies, each measured into its own body; the
//!   tangential displacement is the difference $`u_{x1}-u_{x2}`$.
//! - The elastic constants are the contact modulus $`E^*`$, the [equivalent shear
//!   modulus](crate::ElasticPair::equivalent_shear_modulus) $`G`$ and the equivalent Poisson's ratio $`\nu`$ of the
//!   [`ElasticPair`](crate::ElasticPair). For two bodies of the same material, $`G`$ is half of the shear modulus of a body.
//!   Formulas of the literature with the modulus of a body therefore differ by a factor of two. [`KalkerCoefficients`] and
//!   [`VermeulenJohnson`] are exceptions: their $`G`$ is the modulus of a body, as in Kalker's tables.
//! - The approach and the shift are the displacements of one body relative to the other, far from the
//!   contact.
//! - Slip is $`s_x = u_x - \delta_x`$, opposite in sign to the traction.
//! - Normal and tangential tractions are uncoupled, except in [`NoSlipPunch`], [`NoSlipSphere`], [`SpencePressing`] and
//!   [`BentallJohnson`]. The solutions are exact if [`dundurs_beta`](crate::ElasticPair::dundurs_beta) is zero, as for bodies of
//!   the same material. Otherwise the error of the pressure under pressing alone is of the order of $`\beta^2`$. The errors of
//!   the tractions and of the pressure under shear are of the order of $`\beta`$
//!   ([`Coupling::Neglected`](crate::Coupling::Neglected)).
//! - The formulas assume small strains, slopes, rotations and creepages. The constructors check signs and finite values only. They
//!   accept a coefficient of friction above 5, a creepage above 0.1 and a pressure above half of the contact modulus, for which
//!   numerical solutions have [warnings](crate::Warning). The units of all arguments must be consistent.
//!
//! # References
//! - R. H. Bentall and K. L. Johnson, Slip in the rolling contact of two dissimilar elastic rollers, *Int. J. Mech. Sci.* 9
//!   (1967) 389-404, [doi:10.1016/0020-7403(67)90043-4](https://doi.org/10.1016/0020-7403(67)90043-4).
//! - F. M. Borodich and L. M. Keer, *Proc. R. Soc. Lond. A* 460 (2004) 507-514.
//! - A. W. Bush, R. D. Gibson, T. R. Thomas, The elastic contact of a rough surface, *Wear* 35 (1975)
//!   87-111, [doi:10.1016/0043-1648(75)90145-3](https://doi.org/10.1016/0043-1648(75)90145-3).
//! - F. W. Carter, *Proc. R. Soc. Lond. A* 112 (1926) 151, [doi:10.1098/rspa.1926.0100](https://doi.org/10.1098/rspa.1926.0100).
//! - C. Cattaneo, Sul contatto di due corpi elastici: distribuzione locale degli sforzi, *Rend. Accad.
//!   Naz. Lincei* 27 (1938) 342-348, 434-436, 474-478.
//! - K. L. Johnson, *Contact Mechanics*, Cambridge University Press, 1985,
//!   [doi:10.1017/CBO9781139171731](https://doi.org/10.1017/CBO9781139171731).
//! - M. Ciavarella, The generalized Cattaneo partial slip plane contact problem, *Int. J. Solids Struct.* 35 (1998a) 2349-2362,
//!   [doi:10.1016/S0020-7683(97)00154-6](https://doi.org/10.1016/S0020-7683(97)00154-6).
//! - M. Ciavarella, Tangential loading of general three-dimensional contacts, *J. Appl. Mech.* 65 (1998b) 998-1003.
//! - M. Ciavarella, D. A. Hills, G. Monno, The influence of rounded edges on indentation by a flat punch,
//!   *Proc. Inst. Mech. Eng. C* 212 (1998) 319-327.
//! - H. Fromm, Berechnung des Schlupfes beim Rollen deformierbarer Scheiben, *Z. Angew. Math. Mech.* 7 (1927) 27-58.
//! - J. A. Greenwood and J. H. Tripp, The elastic contact of rough spheres, *J. Appl. Mech.* 34 (1967) 153-159,
//!   [doi:10.1115/1.3607616](https://doi.org/10.1115/1.3607616).
//! - J. Jaeger, A new principle in contact mechanics, *J. Tribology* 120 (1998) 677-684,
//!   [doi:10.1115/1.2833765](https://doi.org/10.1115/1.2833765).
//! - J. L. Lubkin, The torsion of elastic spheres in contact, *J. Appl. Mech.* 18 (1951) 183-187.
//! - J. J. Kalker, *Three-dimensional elastic bodies in rolling contact*, Kluwer, 1990,
//!   [doi:10.1007/978-94-015-7889-9](https://doi.org/10.1007/978-94-015-7889-9).
//! - R. D. Mindlin, Compliance of elastic bodies in contact, *J. Appl. Mech.* 16 (1949) 259-268,
//!   [doi:10.1115/1.4009973](https://doi.org/10.1115/1.4009973).
//! - R. D. Mindlin and H. Deresiewicz, Elastic spheres in contact under varying oblique forces, *J. Appl. Mech.* 20 (1953)
//!   327-344, [doi:10.1115/1.4010702](https://doi.org/10.1115/1.4010702).
//! - E. M'Ewen, Stresses in elastic cylinders in contact along a generatrix, *Phil. Mag.* 40 (1949) 454-459,
//!   [doi:10.1080/14786444908521733](https://doi.org/10.1080/14786444908521733).
//! - V. I. Mossakovskii, *Prikl. Mat. Mekh.* 18 (1954) 187-196.
//! - M. H. Müser, On the contact area of nominally flat Hertzian contacts, *Tribol. Lett.* 64 (2016) 14,
//!   [doi:10.1007/s11249-016-0750-3](https://doi.org/10.1007/s11249-016-0750-3).
//! - D. Nowell and D. A. Hills, Mechanics of fretting fatigue tests, *Int. J. Mech. Sci.* 29 (1987)
//!   355-365.
//! - M. Paggi, R. Pohrt, V. L. Popov, Partial-slip frictional response of rough surfaces, *Sci. Rep.* 4
//!   (2014) 5178, [doi:10.1038/srep05178](https://doi.org/10.1038/srep05178).
//! - L. Pastewka and M. O. Robbins, Contact area of rough spheres, *Appl. Phys. Lett.* 108 (2016) 221601,
//!   [doi:10.1063/1.4950802](https://doi.org/10.1063/1.4950802).
//! - B. N. J. Persson, Theory of rubber friction and contact mechanics, *J. Chem. Phys.* 115 (2001)
//!   3840-3861, [doi:10.1063/1.1388626](https://doi.org/10.1063/1.1388626).
//! - V. L. Popov, Analytic solution for the limiting shape of profiles due to fretting wear, *Sci. Rep.* 4 (2014) 3749,
//!   [doi:10.1038/srep03749](https://doi.org/10.1038/srep03749).
//! - I. N. Sneddon, The relation between load and penetration in the axisymmetric Boussinesq problem for a punch of arbitrary
//!   profile, *Int. J. Eng. Sci.* 3 (1965) 47-57,
//!   [doi:10.1016/0020-7225(65)90019-4](https://doi.org/10.1016/0020-7225(65)90019-4).
//! - D. A. Spence, *Proc. R. Soc. Lond. A* 305 (1968) 55-80,
//!   [doi:10.1098/rspa.1968.0105](https://doi.org/10.1098/rspa.1968.0105).
//! - D. A. Spence, An eigenvalue problem for elastic contact with finite friction, *Proc. Camb. Phil. Soc.* 73 (1973) 249-268.
//! - D. A. Spence, *J. Elasticity* 5 (1975) 297-319, [doi:10.1007/BF00126993](https://doi.org/10.1007/BF00126993).
//! - P. J. Vermeulen and K. L. Johnson, Contact of nonspherical elastic bodies transmitting tangential
//!   forces, *J. Appl. Mech.* 31 (1964) 338-340, [doi:10.1115/1.3629610](https://doi.org/10.1115/1.3629610).
//! - H. M. Westergaard, Bearing pressures and cracks, *J. Appl. Mech.* 6 (1939) A49-A53,
//!   [doi:10.1115/1.4008919](https://doi.org/10.1115/1.4008919).

mod bentall_johnson;
mod carter;
mod cattaneo_mindlin;
mod cone;
mod elliptic;
mod flat_punch;
mod full_stick;
mod held_force;
mod hertz;
mod kalker_coefficients;
mod kalker_table;
mod line;
mod line_partial_slip;
mod line_stress;
mod lubkin_torsion;
mod mindlin_deresiewicz;
mod no_slip;
mod partial_slip;
mod persson;
mod popov_limiting_shape;
mod quadrature;
mod rough_sphere;
mod rounded_punch;
mod sines;
mod spence_pressing;
mod vermeulen_johnson;
mod westergaard;

pub use bentall_johnson::BentallJohnson;
pub use carter::Carter;
pub use cattaneo_mindlin::{CattaneoMindlin, CattaneoMindlinEllipse};
pub use cone::{Cone, ConePartialSlip};
pub use flat_punch::FlatPunch;
pub use full_stick::MindlinFullStick;
pub use hertz::{HertzEllipse, HertzSphere};
pub use kalker_coefficients::KalkerCoefficients;
pub use line::HertzLine;
pub use line_partial_slip::CattaneoMindlinLine;
pub use lubkin_torsion::LubkinTorsion;
pub use mindlin_deresiewicz::MindlinDeresiewicz;
pub use no_slip::{NoSlipPunch, NoSlipSphere};
pub use persson::{Persson, linear_stick_ratio};
pub use popov_limiting_shape::PopovLimitingShape;
pub use rough_sphere::RoughSphere;
pub use rounded_punch::RoundedPunch;
pub use spence_pressing::SpencePressing;
pub use vermeulen_johnson::VermeulenJohnson;
pub use westergaard::{Westergaard, WestergaardPartialSlip};
