//! Closed-form contacts: the numbers a computed contact is held against.
//!
//! | contact | type | source |
//! |---|---|---|
//! | sphere, or paraboloid of revolution, under a normal load | [`HertzSphere`] | Hertz; Johnson (1985), section 4.2 |
//! | elliptic paraboloid under a normal load | [`HertzEllipse`] | Hertz; Johnson (1985), section 4.2 |
//! | sphere in partial slip under a tangential load | [`CattaneoMindlin`] | Cattaneo (1938), Mindlin (1949) |
//! | elliptic paraboloid in partial slip under a tangential load | [`CattaneoMindlinEllipse`] | Mindlin (1949), Vermeulen and Johnson (1964) |
//!
//! # Conventions
//! - Units are any consistent set: `m, N, Pa` or `mm, N, MPa`.
//! - The contact is centred on the origin of the plane `z = 0`; z points into body 1.
//! - Pressure is positive where the bodies push on each other. Traction is what acts on body 1,
//!   positive along +x; body 2 receives the opposite.
//! - Displacements are relative: the sum over the bodies of the normal displacement, each into its
//!   own body, and the difference $`u_{x1}-u_{x2}`$ of the tangential one. The two bodies enter by
//!   the contact modulus $`E^*`$, the shear modulus $`G`$ and Poisson's ratio $`\nu`$ of the
//!   [`ElasticPair`](crate::ElasticPair).
//! - The approach and the shift are the displacements, far from the contact, of one body relative
//!   to the other.
//! - Slip is $`s_x = u_x - \delta_x`$, opposite in sign to the traction.
//! - Normal and tangential tractions are uncoupled: exact when
//!   [`dundurs_beta`](crate::ElasticPair::dundurs_beta) vanishes, as for identical bodies, else in
//!   error by the order of it.
//!
//! # References
//! - K. L. Johnson, *Contact Mechanics*, Cambridge University Press, 1985,
//!   [doi:10.1017/CBO9781139171731](https://doi.org/10.1017/CBO9781139171731).
//! - R. D. Mindlin, Compliance of elastic bodies in contact, *J. Appl. Mech.* 16 (1949) 259-268,
//!   [doi:10.1115/1.4009973](https://doi.org/10.1115/1.4009973).

mod cattaneo_mindlin;
mod elliptic;
mod hertz;
mod partial_slip;
mod sines;

pub use cattaneo_mindlin::{CattaneoMindlin, CattaneoMindlinEllipse};
pub use hertz::{HertzEllipse, HertzSphere};
