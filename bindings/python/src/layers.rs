//! Layers of coated bodies and the response of coated bodies to waves.

use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;
use pyo3::types::PyTuple;
use stickslip::layers;

use crate::argument::by_value;
use crate::digits::short;
use crate::error::OrRaise;
use crate::pickle::picklable;
use crate::readers::readers;
use crate::real::Real;

/// An elastic, isotropic layer bonded to the layer or body below it.
///
/// Parameters
/// ----------
/// youngs_modulus : float
///     Young's modulus (a pressure), positive.
/// poisson_ratio : float
///     Poisson's ratio, in (-1, 0.5].
/// thickness : float
///     Thickness (a length), positive, in the same unit as the sides of the grid and the gap. Numbers have no unit: on a grid
///     in millimetres, a coating of 5 micrometres has the thickness 5e-3. It is given by keyword only, because a thickness
///     exchanged with Poisson's ratio would be another valid layer.
///
/// Raises
/// ------
/// NotPositive, PoissonRatio
///
/// Examples
/// --------
/// >>> import stickslip as ss
/// >>> oxide = ss.layers.Layer(380e9, 0.22, thickness=5e-6)
/// >>> anodised = ss.Material(70e9, 0.33).coated([oxide])
/// >>> anodised.layers[0].thickness
/// 5e-06
#[pyclass(frozen, eq, module = "stickslip.layers")]
#[derive(Clone, Copy, PartialEq)]
pub(crate) struct Layer(pub(crate) layers::Layer);

readers! { Layer.0:
    /// Young's modulus (a pressure).
    youngs_modulus(): f64,
    /// Poisson's ratio.
    poisson_ratio(): f64,
    /// Thickness (a length).
    thickness(): f64,
    /// Shear modulus (a pressure).
    shear_modulus(): f64,
}

by_value!(Layer);

#[pymethods]
impl Layer {
    #[new]
    #[pyo3(signature = (youngs_modulus, poisson_ratio, *positional, thickness),
        text_signature = "(youngs_modulus, poisson_ratio, *, thickness)")]
    fn new(
        py: Python<'_>,
        youngs_modulus: Real,
        poisson_ratio: Real,
        positional: &Bound<'_, PyTuple>,
        thickness: Real,
    ) -> PyResult<Self> {
        if !positional.is_empty() {
            let message = "Layer takes youngs_modulus and poisson_ratio by position, and thickness= by keyword";
            return Err(PyTypeError::new_err(message));
        }
        layers::Layer::new(youngs_modulus.0, poisson_ratio.0, thickness.0)
            .or_raise(py)
            .map(Self)
    }

    /// Equal layers have equal hashes.
    fn __hash__(&self) -> u64 {
        crate::material::hash_of(&numbers(&self.0))
    }

    pub(crate) fn __repr__(&self) -> String {
        let [modulus, ratio, thickness] = numbers(&self.0).map(short);
        format!("Layer(youngs_modulus={modulus}, poisson_ratio={ratio}, thickness={thickness})")
    }
}

picklable!(Layer: layers::Layer);

/// Returns the numbers that define a layer.
pub(crate) fn numbers(layer: &layers::Layer) -> [f64; 3] {
    [
        layer.youngs_modulus(),
        layer.poisson_ratio(),
        layer.thickness(),
    ]
}

/// Displacements of the surface of two bodies under a wave of traction (lengths over pressures), returned by
/// :meth:`ElasticPair.response <stickslip.ElasticPair.response>`.
#[pyclass(frozen, eq, module = "stickslip.layers", name = "WaveResponse")]
#[derive(Clone, Copy, PartialEq)]
pub(crate) struct WaveResponse(pub(crate) layers::Response);

readers! { WaveResponse.0:
    /// Normal displacement due to pressure.
    normal: f64,
    /// Tangential displacement along the wave vector due to traction along it.
    along: f64,
    /// Tangential displacement across the wave vector due to traction across it.
    across: f64,
    /// Normal displacement due to traction along the wave vector, and displacement along the wave vector due to pressure,
    /// up to a factor i.
    coupling: f64,
}

#[pymethods]
impl WaveResponse {
    fn __repr__(&self) -> String {
        let of = self.0;
        let [normal, along, across, coupling] =
            [of.normal, of.along, of.across, of.coupling].map(short);
        format!(
            "WaveResponse(normal={normal}, along={along}, across={across}, coupling={coupling})"
        )
    }
}
