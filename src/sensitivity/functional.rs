//! Functionals of a solution, and their derivatives with respect to its unknowns.

use crate::cgm::reduce;
use crate::error::{Error, Result, at_least, finite};
use crate::grid::field::Field;
use crate::half_space::HalfSpace;
use crate::memory::fallible;
use crate::numerics::cell_vector::dot;
use crate::tangential::{Axis, Zone};

/// Number J that depends on the solution of a contact.
///
/// A functional of tractions, slip or shift requires the solver of a tangential or coupled contact. The approach requires the
/// solver of a normal or coupled contact.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
#[expect(
    clippy::large_enum_variant,
    reason = "a program creates few functionals"
)]
pub enum Functional {
    /// Generalised mean of the pressure, weighted by the load: $`(\sum p^{k+1} / \sum p)^{1/k}`$ with the exponent k >= 1. The
    /// mean tends to the largest pressure for large k. Cells that come into contact at pressure zero do not change the mean.
    PressureNorm {
        /// Exponent k, at least 1.
        exponent: f64,
    },
    /// Elastic energy: of the pressure in a normal contact, of the tractions in a tangential contact, and of both in a coupled
    /// contact (force times length).
    ElasticEnergy,
    /// Normal force.
    NormalForce,
    /// Approach of the bodies.
    Approach,
    /// Tangential force along an axis.
    TangentialForce(Axis),
    /// Shift along an axis.
    Shift(Axis),
    /// Part of the tangential force along an axis that the sticking cells carry.
    StickForce(Axis),
    /// Energy dissipated by the step, computed from the tractions at its end (force times length).
    DissipatedEnergy,
    /// Weighted sum of the unknowns.
    Weighted(Weights),
}

impl Functional {
    /// Root mean square of the pressure, weighted by the load.
    pub const RMS_PRESSURE: Self = Self::PressureNorm { exponent: 2.0 };
}

/// Weights of a user-defined functional
/// $`\sum_i (w_i p_i + \mathbf{w}_i \cdot \mathbf{q}_i + \mathbf{v}_i \cdot \mathbf{s}_i) + a\,\delta_z + \mathbf{b} \cdot
/// \boldsymbol\delta`$.
///
/// The sum covers the pressures p, the tractions q and the slips s of all cells. The other terms are multiples of the approach
/// and the shifts. All weights are zero by default. For a smooth nonlinear functional, pass its derivatives at the solution as
/// weights.
///
/// ```
/// use stickslip::sensitivity::{Functional, Weights};
/// use stickslip::{Field, Grid};
/// // The moment of the pressure about the y axis, per area of a cell, plus twice the approach.
/// let arms = Field::from_fn(Grid::square(32, 8.0)?, |x, _| -x);
/// let functional = Functional::Weighted(Weights::new().pressure(arms).approach(2.0));
/// assert!(matches!(functional, Functional::Weighted(_)));
/// # Ok::<(), stickslip::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[must_use]
pub struct Weights {
    pressure: Option<Field>,
    traction: Option<[Field; 2]>,
    slip: Option<[Field; 2]>,
    approach: f64,
    shift: [f64; 2],
}

impl Weights {
    /// Creates zero weights.
    pub fn new() -> Self {
        Self::default()
    }

    /// Sets the weights of the pressures.
    pub fn pressure(mut self, weights: Field) -> Self {
        self.pressure = Some(weights);
        self
    }

    /// Sets the weights of the tractions along x and y.
    pub fn traction(mut self, weights: [Field; 2]) -> Self {
        self.traction = Some(weights);
        self
    }

    /// Sets the weights of the slips along x and y.
    pub fn slip(mut self, weights: [Field; 2]) -> Self {
        self.slip = Some(weights);
        self
    }

    /// Sets the weight of the approach.
    pub fn approach(mut self, weight: f64) -> Self {
        self.approach = weight;
        self
    }

    /// Sets the weights of the shifts along x and y.
    pub fn shift(mut self, weights: [f64; 2]) -> Self {
        self.shift = weights;
        self
    }

    fn check(&self, bodies: &HalfSpace) -> Result<()> {
        let fields = |name, fields: &Option<[Field; 2]>| -> Result<()> {
            let mut fields = fields.iter().flatten();
            fields.try_for_each(|field| field.check(name, bodies.grid()))
        };
        if let Some(field) = &self.pressure {
            field.check("field of weights of the pressures", bodies.grid())?;
        }
        fields("field of weights of the tractions", &self.traction)?;
        fields("field of weights of the slips", &self.slip)?;
        finite("weight of the approach", self.approach)?;
        for weight in self.shift {
            finite("weight of the shift", weight)?;
        }
        Ok(())
    }
}

/// Solution at which a functional is evaluated, in the local cells of the grid.
#[derive(Clone, Copy)]
pub(super) struct ContactView<'a> {
    pub(super) bodies: &'a HalfSpace,
    pub(super) pressure: &'a [f64],
    /// Approach, if the contact has one.
    pub(super) approach: Option<f64>,
    /// Displacement of each cell along z, whose product with the pressure is part of the elastic energy. It may be
    /// empty.
    pub(super) lift: &'a [f64],
    pub(super) shear: ShearView<'a>,
}

/// Tractions and slips at which a functional is evaluated. The slices of a contact without shear are empty.
#[derive(Clone, Copy, Default)]
pub(super) struct ShearView<'a> {
    pub(super) traction: [&'a [f64]; 2],
    pub(super) slip: [&'a [f64]; 2],
    pub(super) zones: &'a [Zone],
    pub(super) shift: [f64; 2],
    /// Displacements whose products with the tractions are part of the elastic energy.
    pub(super) displacement: [&'a [f64]; 2],
}

/// Value of a functional and its derivatives with respect to the unknowns. An empty vector contains zeros.
#[derive(Debug, Default)]
pub(super) struct Gradient {
    pub(super) value: f64,
    pub(super) pressure: Vec<f64>,
    pub(super) traction: [Vec<f64>; 2],
    pub(super) slip: [Vec<f64>; 2],
    pub(super) approach: f64,
    pub(super) shift: [f64; 2],
    /// The functional contains this factor times $`x' C x`$.
    pub(super) energy: f64,
}

/// Returns an entry of a vector, or zero if the vector is empty.
pub(super) fn entry(part: &[f64], cell: usize) -> f64 {
    part.get(cell).copied().unwrap_or(0.0)
}

/// Returns the entries of two vectors, or zeros if they are empty.
pub(super) fn pair_at<P: AsRef<[f64]>>(parts: &[P; 2], cell: usize) -> [f64; 2] {
    [0, 1].map(|axis| entry(parts[axis].as_ref(), cell))
}

impl Functional {
    /// Returns an error if the functional is invalid or depends on quantities that the contact does not have.
    pub(super) fn check(
        &self,
        bodies: &HalfSpace,
        has_approach: bool,
        has_shear: bool,
    ) -> Result<()> {
        let (needs_approach, needs_shear) = match self {
            Self::PressureNorm { exponent } => {
                at_least("one", 1.0, "exponent of the mean pressure", *exponent)?;
                finite("exponent of the mean pressure", *exponent)?;
                (false, false)
            }
            Self::ElasticEnergy | Self::NormalForce => (false, false),
            Self::Approach => (true, false),
            Self::TangentialForce(_)
            | Self::Shift(_)
            | Self::StickForce(_)
            | Self::DissipatedEnergy => (false, true),
            Self::Weighted(weights) => {
                weights.check(bodies)?;
                let moves = weights.shift.into_iter().any(|weight| weight != 0.0);
                let has_fields = weights.traction.is_some() || weights.slip.is_some();
                (weights.approach != 0.0, moves || has_fields)
            }
        };
        let unsupported = |model, quantity, remedy| {
            Err(Error::UnsupportedByModel {
                model,
                quantity,
                value: 0.0,
                remedy,
            })
        };
        if needs_shear && !has_shear {
            return unsupported(
                "a normal contact",
                "a functional of tractions",
                "use the solver of a tangential or coupled contact",
            );
        }
        if needs_approach && !has_approach {
            return unsupported(
                "a tangential contact",
                "a functional of the approach",
                "use the solver of a normal or coupled contact",
            );
        }
        Ok(())
    }

    /// Returns the derivative with respect to the approach.
    #[cfg(feature = "history")]
    pub(super) fn by_approach(&self) -> f64 {
        match self {
            Self::Approach => 1.0,
            Self::Weighted(weights) => weights.approach,
            _ => 0.0,
        }
    }

    /// Returns the properties that must agree on all ranks: all except the fields of weights.
    pub(super) fn common(&self) -> Self {
        match self {
            Self::Weighted(weights) => Self::Weighted(Weights {
                approach: weights.approach,
                shift: weights.shift,
                ..Weights::default()
            }),
            other => other.clone(),
        }
    }

    /// Evaluates the functional and its derivatives at a solution that has passed [`Self::check`].
    pub(super) fn gradient(&self, view: &ContactView<'_>) -> Result<Gradient> {
        let layout = &view.bodies.grid_layout();
        let area = view.bodies.grid().cell_area();
        let cells = view.bodies.grid().cells();
        let filled = |of: &dyn Fn(usize) -> f64| fallible::collected(cells, (0..cells).map(of));
        let mut found = Gradient::default();
        let shear = &view.shear;
        let along = |axis: Axis| axis.index();
        match self {
            Self::ElasticEnergy => {
                let [x, y] = shear.displacement;
                let of = |u: &[f64]| fallible::collected(u.len(), u.iter().map(|u| area * u));
                found.pressure = of(view.lift)?;
                found.traction = [of(x)?, of(y)?];
                found.energy = 0.5 * area;
                let products = |i: usize| {
                    let shear = dot(pair_at(&found.traction, i), pair_at(&shear.traction, i));
                    entry(&found.pressure, i) * view.pressure[i] + shear
                };
                found.value = 0.5 * reduce::sum(layout, products);
            }
            Self::TangentialForce(axis) => {
                found.traction[along(*axis)] = filled(&|_| area)?;
                found.value = reduce::sum(layout, |i| area * shear.traction[along(*axis)][i]);
            }
            Self::StickForce(axis) => {
                let sticks = |i: usize| {
                    if shear.zones[i] == Zone::Stick {
                        area
                    } else {
                        0.0
                    }
                };
                found.traction[along(*axis)] = filled(&sticks)?;
                found.value = reduce::sum(layout, |i| sticks(i) * shear.traction[along(*axis)][i]);
            }
            Self::Shift(axis) => {
                found.shift[along(*axis)] = 1.0;
                found.value = shear.shift[along(*axis)];
            }
            Self::DissipatedEnergy => {
                found.traction =
                    fallible::try_each(|axis| filled(&|i| -area * shear.slip[axis][i]))?;
                found.slip = fallible::try_each(|axis| {
                    let slips = |i: usize| shear.zones[i] == Zone::Slip;
                    filled(&|i| {
                        if slips(i) {
                            -area * shear.traction[axis][i]
                        } else {
                            0.0
                        }
                    })
                })?;
                let work = |i: usize| dot(pair_at(&shear.slip, i), pair_at(&shear.traction, i));
                found.value = reduce::sum(layout, |i| -area * work(i));
            }
            Self::PressureNorm { exponent } => {
                let pressure = view.pressure;
                let largest = reduce::max(layout, |i| pressure[i]);
                if largest <= 0.0 {
                    return Ok(found);
                }
                let ratio = |i: usize| (pressure[i] / largest).max(0.0);
                let (powers, total): (f64, f64) =
                    reduce::sum(layout, |i| (ratio(i).powf(exponent + 1.0), ratio(i)));
                found.value = largest * (powers / total).powf(exponent.recip());
                let factor = found.value / (exponent * largest);
                found.pressure = filled(&|i| {
                    let power = (exponent + 1.0) * ratio(i).powf(*exponent) / powers;
                    factor * (power - total.recip())
                })?;
            }
            Self::NormalForce => {
                found.pressure = filled(&|_| area)?;
                found.value = area * reduce::total(layout, view.pressure);
            }
            Self::Approach => {
                found.approach = 1.0;
                found.value = view.approach.unwrap_or(0.0);
            }
            Self::Weighted(weights) => weights.gradient(view, &mut found)?,
        }
        Ok(found)
    }
}

impl Weights {
    fn gradient(&self, view: &ContactView<'_>, found: &mut Gradient) -> Result<()> {
        let layout = view.bodies.grid_layout();
        let mut add = |weights: &Field, values: &[f64], part: &mut Vec<f64>| -> Result<()> {
            let weights = weights.as_slice();
            found.value += reduce::sum(&layout, |i| weights[i] * values[i]);
            *part = fallible::copied(weights)?;
            Ok(())
        };
        if let Some(weights) = &self.pressure {
            add(weights, view.pressure, &mut found.pressure)?;
        }
        for axis in [0, 1] {
            if let Some(weights) = &self.traction {
                add(
                    &weights[axis],
                    view.shear.traction[axis],
                    &mut found.traction[axis],
                )?;
            }
            if let Some(weights) = &self.slip {
                add(&weights[axis], view.shear.slip[axis], &mut found.slip[axis])?;
            }
        }
        found.value += dot(self.shift, view.shear.shift);
        found.value += self.approach * view.approach.unwrap_or(0.0);
        (found.approach, found.shift) = (self.approach, self.shift);
        Ok(())
    }
}
