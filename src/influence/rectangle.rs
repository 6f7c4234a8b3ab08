//! The nine influence coefficients of one rectangular cell, near and far.

use std::f64::consts::TAU;

use crate::bodies::component::Component;
use crate::bodies::material::{Compliances, ElasticPair, Material};
use crate::error::{Error, Result, positive};
use crate::influence::LayerCorrection;
use crate::influence::integrals::Cell;

/// Cell of half sides `a` along x and `b` along y, centred on the origin.
///
/// ```
/// use stickslip::{Material, influence::Rectangle};
/// let steel = Material::new(210e9, 0.3)?;
/// let cell = Rectangle::new(1e-6, 1e-6)?;
/// let own = cell.tensor(&steel, 0.0, 0.0);
/// // Under the centre of a square of side h: u_z = 1.122200 h p (1 - nu^2)/E.
/// let plane_modulus = 210e9 / (1.0 - 0.09);
/// assert!((own.zz * plane_modulus / 2e-6 - 1.122200).abs() < 1e-6);
/// assert_eq!(own.zx, 0.0);
/// # Ok::<(), stickslip::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Rectangle {
    /// Cell in units of its size, so that no power of a length overflows.
    pub(super) cell: Cell,
    /// Largest power of two that does not exceed the longer side. Division by this unit is exact, so a point very close to
    /// an edge keeps its distance to the edge.
    pub(super) unit: f64,
}

/// The nine influence coefficients at one point (lengths over pressures). The first index denotes the displacement
/// component, the second index the traction component.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[expect(missing_docs, reason = "the type says what the two letters mean")]
pub struct Tensor {
    pub xx: f64,
    pub xy: f64,
    pub xz: f64,
    pub yx: f64,
    pub yy: f64,
    pub yz: f64,
    pub zx: f64,
    pub zy: f64,
    pub zz: f64,
}

/// Ratio of the shorter to the longer side below which powers of the ratio underflow.
const SLENDEREST: f64 = 1e-100;

impl Rectangle {
    /// Creates a cell of half sides `a` and `b` (lengths).
    ///
    /// # Errors
    /// - [`Error::NotPositive`] if a half side is not positive and finite.
    /// - [`Error::CellsTooLong`] for a ratio of more than 1e100, whose powers can overflow or underflow.
    pub fn new(a: f64, b: f64) -> Result<Self> {
        positive("half side a of the cell", a)?;
        positive("half side b of the cell", b)?;
        if a.min(b) < SLENDEREST * a.max(b) {
            let sides = [2.0 * a, 2.0 * b];
            return Err(Error::CellsTooLong { sides });
        }
        let longer = positive("longer side of the cell", 2.0 * a.max(b))?;
        // Clearing the mantissa bits leaves a power of two. A subnormal number becomes zero and is rejected as a unit.
        let unit = f64::from_bits(longer.to_bits() & f64::INFINITY.to_bits());
        positive("unit of the longer side of the cell", unit)?;
        Ok(Self {
            cell: Cell {
                a: positive("half side a over the longer side", a / unit)?,
                b: positive("half side b over the longer side", b / unit)?,
            },
            unit,
        })
    }

    /// Returns the coefficients of one body at `(x, y)` from the centre of the loaded cell (lengths).
    ///
    /// The error is about 1e-15 of `C_zz` at any distance. For coated bodies the error is below 1e-12 of `C_zz` of the loaded
    /// cell, and each call evaluates the integrals again. Use a [`Table`](crate::influence::Table) for many points.
    #[must_use]
    pub fn tensor(&self, material: &Material, x: f64, y: f64) -> Tensor {
        match ElasticPair::new(*material, Material::rigid()) {
            Ok(pair) if pair.is_coated() => self.pair_tensor(&pair, x, y),
            _ => self.assemble(material.compliances(), None, x, y),
        }
    }

    /// Returns the coefficients of the relative displacement `u_1 - u_2` of two bodies.
    ///
    /// The tractions act on body 1 and the opposite tractions on body 2. The coefficients `xx`, `yy`, `zz`, `xy` and `yx` of both
    /// bodies are added. The coefficients `xz`, `yz`, `zx` and `zy` between normal and tangential components are subtracted. For
    /// a pair that [represents a kernel](ElasticPair::stands_for_kernel) the result applies to its half-spaces, not to the
    /// kernel.
    #[must_use]
    pub fn pair_tensor(&self, pair: &ElasticPair, x: f64, y: f64) -> Tensor {
        self.assemble(pair.compliances(), LayerCorrection::of(pair).as_ref(), x, y)
    }

    fn assemble(
        &self,
        compliances: Compliances,
        rest: Option<&LayerCorrection>,
        x: f64,
        y: f64,
    ) -> Tensor {
        let of = |component| {
            let near = self.coefficient(component, compliances, x, y);
            match rest {
                Some(rest) => near + rest.over_cell(component, self.half_sides(), x, y) / TAU,
                None => near,
            }
        };
        let (xy, zx, zy) = (of(Component::XY), of(Component::ZX), of(Component::ZY));
        Tensor {
            xx: of(Component::XX),
            xy,
            xz: -zx,
            yx: xy,
            yy: of(Component::YY),
            yz: -zy,
            zx,
            zy,
            zz: of(Component::ZZ),
        }
    }

    /// Returns one coefficient at `(x, y)`. Only the required integrals are evaluated.
    fn coefficient(&self, component: Component, compliances: Compliances, x: f64, y: f64) -> f64 {
        let (x, y) = (x / self.unit, y / self.unit);
        let parts = component.parts(compliances);
        let sum: f64 = parts
            .map(|(weight, integral)| weight * self.cell.at(integral, x, y))
            .sum();
        sum * self.scale()
    }

    /// Returns the half sides along x and y (lengths).
    pub(super) fn half_sides(&self) -> [f64; 2] {
        [self.cell.a * self.unit, self.cell.b * self.unit]
    }

    /// Returns the factor that converts an integral in units of the cell to a coefficient.
    pub(super) fn scale(&self) -> f64 {
        self.unit / TAU
    }
}
