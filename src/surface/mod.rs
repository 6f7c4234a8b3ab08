//! Initial gaps: the shape of the bodies before they deform.
//!
//! A gap is the distance `h(x, y)` between the two undeformed surfaces at first touch of the
//! highest point, a length; its datum is free, since it only shifts the approach.
//!
//! # Shapes and generated surfaces
//! Shapes such as [`sphere`] are gaps. [`SelfAffine`] generates heights of a rough surface, which
//! [`gap_of`] turns into a gap; gaps add up by [`sum`](sum()). Besides what each says, all refuse a grid whose
//! field memory cannot hold ([`Error::Memory`](crate::Error::Memory)), and a shape one of whose heights overflows
//! ([`Error::Sample`](crate::Error::Sample)).
//!
//! # Measured surfaces
//! Heights `z(x, y)` point out of the body they bound; NaN stands for a height that is missing. On the
//! way to a gap a measurement is levelled ([`level`](level())), its holes are closed
//! by [`fill_missing`], the part wanted is taken by [`crop()`] or [`resample()`], and [`gap_of`] sets it on a
//! plane or [`gap_between`] on another surface. [`Statistics`] and [`PowerSpectrum`] measure it.

mod crop;
mod differences;
mod fill;
mod fourier;
mod gap;
mod heights;
mod level;
mod power_spectrum;
mod resample;
mod self_affine;
mod shape;
mod statistics;
mod sum;

pub use crop::crop;
pub use fill::{Filled, fill_missing};
pub use gap::{gap_between, gap_of, inverted, mirrored_along_x};
pub use level::{Form, Levelled, level};
pub use power_spectrum::PowerSpectrum;
pub use resample::resample;
pub use self_affine::{Amplitudes, RoughSurface, SelfAffine};
pub use shape::{bisinusoidal, cone, cylinder, ellipsoid, flat_punch, paraboloid, sphere, wavy};
pub use statistics::Statistics;
pub use sum::sum;
