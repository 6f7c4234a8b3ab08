//! Surfaces: shapes, roughness, statistics and preparation.

mod autocorrelation;
mod filter;
mod material_ratio;
mod outliers;
mod power_spectrum;
mod preparation;
mod processed;
mod roughness;
mod shapes;
mod statistics;

pub(crate) use autocorrelation::Autocorrelation;
pub(crate) use filter::{Filtered, gaussian_filter};
pub(crate) use material_ratio::MaterialRatio;
pub(crate) use outliers::{WithoutOutliers, remove_outliers};
pub(crate) use power_spectrum::PowerSpectrum;
pub(crate) use preparation::{
    Filled, Levelled, crop, fill_missing, gap_between, gap_from_heights, inverted, level, mirror_x,
    resample, sum,
};
pub(crate) use roughness::{RoughSurface, SelfAffine};
pub(crate) use shapes::{
    bisinusoidal, cone, cylinder, ellipsoid, flat_punch, paraboloid, sinusoidal, sphere,
};
pub(crate) use statistics::Statistics;

/// Declares numbers with getters of the same name.
macro_rules! numbers {
    ($class:ident: $($(#[$doc:meta])* $number:ident),+ $(,)?) => {
        crate::readers::readers! { $class.0: $($(#[$doc])* $number(): f64),+ }
    };
}

use numbers;
