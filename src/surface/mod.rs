//! Initial gaps: the shape of the bodies before they deform.
//!
//! A gap is the distance `h(x, y)` between the two undeformed surfaces at first touch of the
//! highest point, a length; its datum is free, since it only shifts the approach.

mod fourier;
mod self_affine;
mod shape;
mod sum;

pub use self_affine::{Amplitudes, RoughSurface, SelfAffine};
pub use shape::{bisinusoidal, cone, cylinder, ellipsoid, flat_punch, paraboloid, sphere, wavy};
pub use sum::sum;
