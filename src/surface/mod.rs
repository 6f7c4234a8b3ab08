//! Initial gaps and surfaces of the bodies before they deform.
//!
//! A gap is the distance `h(x, y)` (a length) between the two undeformed surfaces when they first touch. The datum of
//! the gap is arbitrary, because it only shifts the approach.
//!
//! # Shapes and generated surfaces
//! Shapes such as [`sphere`] are gaps. [`SelfAffine`] generates heights of a rough surface. [`gap_from_heights`] converts heights
//! into a gap, and [`sum`](sum()) adds gaps. All functions can return two errors in addition to the errors listed for each
//! function. They return [`Error::Memory`](crate::Error::Memory) if a field on the grid cannot be allocated, and
//! [`Error::Sample`](crate::Error::Sample) if a height of the shape overflows.
//!
//! # Measured surfaces
//! Heights `z(x, y)` point out of the body. NaN marks a missing height. To obtain a gap from a measurement:
//!
//! 1. Level the surface with [`level`](level()).
//! 2. Remove spikes with an [`OutlierFilter`].
//! 3. Remove the noise of the instrument with a [`GaussianFilter`].
//! 4. Fill the holes with [`fill_missing`].
//! 5. Select a part with [`crop()`] or [`resample()`].
//! 6. Compute the gap to a plane with [`gap_from_heights`], or to a second surface with [`gap_between`].
//!
//! [`Statistics`], [`MaterialRatio`], [`Autocorrelation`] and [`PowerSpectrum`] characterise the surface. The first three
//! contain the parameters of ISO 25178-2 and skip missing heights.

#[cfg(feature = "roughness")]
mod slabs;

#[cfg(feature = "roughness")]
mod autocorrelation;
#[cfg(feature = "roughness")]
mod crop;
#[cfg(feature = "roughness")]
mod differences;
#[cfg(feature = "roughness")]
mod fill;
#[cfg(feature = "roughness")]
mod filter;
mod gap;
mod heights;
#[cfg(feature = "roughness")]
mod level;
#[cfg(feature = "roughness")]
mod material_ratio;
#[cfg(feature = "roughness")]
mod outliers;
#[cfg(feature = "roughness")]
mod power_spectrum;
#[cfg(feature = "roughness")]
mod resample;
#[cfg(feature = "roughness")]
mod self_affine;
mod shape;
#[cfg(feature = "roughness")]
mod slab;
#[cfg(feature = "roughness")]
mod statistics;
#[cfg(feature = "roughness")]
mod waves;

#[cfg(feature = "roughness")]
#[cfg_attr(docsrs, doc(cfg(feature = "roughness")))]
pub use autocorrelation::Autocorrelation;
#[cfg(feature = "roughness")]
#[cfg_attr(docsrs, doc(cfg(feature = "roughness")))]
pub use crop::crop;
#[cfg(feature = "roughness")]
#[cfg_attr(docsrs, doc(cfg(feature = "roughness")))]
pub use fill::{Filled, fill_missing};
#[cfg(feature = "roughness")]
#[cfg_attr(docsrs, doc(cfg(feature = "roughness")))]
pub use filter::{Filtered, GaussianFilter};
pub use gap::{gap_between, gap_from_heights, inverted, mirror_x};
#[cfg(feature = "roughness")]
pub(crate) use level::level_slab;
#[cfg(feature = "roughness")]
#[cfg_attr(docsrs, doc(cfg(feature = "roughness")))]
pub use level::{Form, Levelled, level};
#[cfg(feature = "roughness")]
#[cfg_attr(docsrs, doc(cfg(feature = "roughness")))]
pub use material_ratio::MaterialRatio;
#[cfg(feature = "roughness")]
#[cfg_attr(docsrs, doc(cfg(feature = "roughness")))]
pub use outliers::{OutlierFilter, WithoutOutliers};
#[cfg(feature = "roughness")]
#[cfg_attr(docsrs, doc(cfg(feature = "roughness")))]
pub use power_spectrum::PowerSpectrum;
#[cfg(feature = "roughness")]
pub(crate) use resample::interpolate;
#[cfg(feature = "roughness")]
#[cfg_attr(docsrs, doc(cfg(feature = "roughness")))]
pub use resample::{Interpolation, resample};
#[cfg(feature = "roughness")]
#[cfg_attr(docsrs, doc(cfg(feature = "roughness")))]
pub use self_affine::{Amplitudes, RoughSurface, SelfAffine};
pub use shape::sum;
pub use shape::{
    bisinusoidal, cone, cylinder, ellipsoid, flat_punch, paraboloid, sinusoidal, sphere,
};
#[cfg(feature = "roughness")]
pub(crate) use slab::Slab;
#[cfg(feature = "roughness")]
#[cfg_attr(docsrs, doc(cfg(feature = "roughness")))]
pub use statistics::Statistics;
