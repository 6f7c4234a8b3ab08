//! Depth removed by wear, and how many cycles may be jumped.
//!
//! The laws add to a field of the caller, so that they serve a body's own depth, the depth of a cycle, and
//! the gap itself: removal from either body opens it.
//!
//! ```
//! use stickslip::history::wear;
//! use stickslip::*;
//! let grid = Grid::square(32, 8.0)?;
//! let rubber = Material::new(1.0, 0.5)?;
//! let bodies = HalfSpace::new(grid, ElasticPair::new(rubber, Material::rigid())?)?;
//! let mut gap = surface::sphere(grid, 10.0)?;
//! let mut history = History::builder(&bodies, &gap, Friction::coulomb(0.3)?).build()?;
//! history.step(&LoadStep::hold().normal(NormalStep::Force(0.5)))?;
//! for shift in [0.4, 0.0, -0.4, 0.0] {
//!     history.step(&LoadStep::hold().tangential(Axis::X, TangentialStep::Shift(shift)))?;
//!     let slip = history.last_step().slip_length();
//!     wear::archard(1e-2, history.pressure(), slip, &mut gap)?;
//!     history.set_gap(&gap)?;
//! }
//! let before = history.pressure().max();
//! history.step(&LoadStep::hold().normal(NormalStep::Force(0.5)))?;
//! assert!(history.pressure().max() < before);
//! # Ok::<(), Error>(())
//! ```

use crate::error::{Result, all_non_negative, finite, non_negative};
use crate::field::Field;
use crate::grid::Grid;
use crate::half_space::HalfSpace;
use crate::influence::Component;
use crate::operator::Operator;
use crate::parallel;

/// Adds the depth that Archard's law removes, `k p |s|` (lengths).
///
/// `coefficient` is that of the body, or the sum of both: hardness under wear number, the volume removed per
/// work of the normal force (one over a pressure; 1 mm3/(N m) is 1e-9 1/Pa). `slip_length` is that of
/// a [step](crate::history::Step::slip_length) or of a cycle. Archard, J. Appl. Phys. 24 (1953) 981,
/// <https://doi.org/10.1063/1.1721448>.
///
/// # Errors
/// [`Error::Negative`](crate::Error::Negative) for the coefficient, [`Error::Sample`](crate::Error::Sample) for a
/// pressure or length that is negative or not finite, [`Error::GridMismatch`](crate::Error::GridMismatch),
/// [`Error::NotFinite`](crate::Error::NotFinite) if the product of the coefficient and the greatest of both is not;
/// the depth is then as it was.
pub fn archard(
    coefficient: f64,
    pressure: &Field,
    slip_length: &Field,
    depth: &mut Field,
) -> Result<()> {
    non_negative("wear coefficient", coefficient)?;
    check("pressure", pressure, depth.grid())?;
    check("slip length", slip_length, depth.grid())?;
    let deepest = coefficient * pressure.max() * slip_length.max();
    finite("greatest depth of wear", deepest)?;
    let (pressure, slip) = (pressure.as_slice(), slip_length.as_slice());
    parallel::update(depth.as_mut_slice(), |first, chunk| {
        let cells = pressure[first..].iter().zip(&slip[first..]);
        for (depth, (p, s)) in chunk.iter_mut().zip(cells) {
            *depth += coefficient * p * s;
        }
    });
    Ok(())
}

/// Adds the depth that the energy law removes, `alpha E / A` with the area A of a cell (lengths).
///
/// `coefficient` alpha is that of the body, or the sum of both: the volume removed per energy dissipated (one
/// over a pressure); in full slip Archard's over the coefficient of friction. `energy` is what each cell
/// dissipates in a [step](crate::history::Step::dissipation) or a cycle. Fouvry, Kapsa & Vincent, Wear 200
/// (1996) 186, <https://doi.org/10.1016/S0043-1648(96)07306-1>.
///
/// # Errors
/// [`Error::Negative`](crate::Error::Negative) for the coefficient, [`Error::Sample`](crate::Error::Sample) for an
/// energy that is negative or not finite, [`Error::GridMismatch`](crate::Error::GridMismatch),
/// [`Error::NotFinite`](crate::Error::NotFinite) if the greatest depth is not; the depth is then as it was.
pub fn dissipated_energy(coefficient: f64, energy: &Field, depth: &mut Field) -> Result<()> {
    non_negative("wear coefficient", coefficient)?;
    check("dissipated energy", energy, depth.grid())?;
    let factor = coefficient / energy.grid().cell_area();
    finite("wear coefficient over the area of a cell", factor)?;
    finite("greatest depth of wear", factor * energy.max())?;
    let energy = energy.as_slice();
    parallel::update(depth.as_mut_slice(), |first, chunk| {
        for (depth, e) in chunk.iter_mut().zip(&energy[first..]) {
            *depth += factor * e;
        }
    });
    Ok(())
}

fn check(quantity: &'static str, field: &Field, grid: Grid) -> Result<()> {
    grid.expect(quantity, field.grid())?;
    all_non_negative(quantity, field.as_slice())
}

/// Cycles whose wear may be taken off at once without the pressure swinging up: explicit wear by Archard's
/// law is stable below (infinite where nothing slips).
///
/// Taking off $`N k s\,p`$ changes a pattern of pressure of compliance $`\lambda`$, an eigenvalue of
/// $`C_{zz}`$, by the factor $`1 - N k s / \lambda`$. All patterns decay if
///
/// ```math
/// N\,k\,s < 2\,\lambda_{min} \qquad (= 1.16\,h/E^* \text{ on square cells of side } h),
/// ```
///
/// and none changes sign below half of that. `coefficient` is the sum of both bodies, `slip_length`
/// that of one cycle. Of the energy law, pass the coefficient times that of friction.
///
/// # Errors
/// [`Error::Negative`](crate::Error::Negative) for the coefficient,
/// [`Error::GridMismatch`](crate::Error::GridMismatch) or [`Error::Sample`](crate::Error::Sample) for the slip
/// length; as [`HalfSpace::operator`].
///
/// ```
/// use stickslip::history::wear;
/// use stickslip::{ElasticPair, Field, Grid, HalfSpace, Material};
/// // E* = 115 GPa, cells of a micrometre, k = 1e-14 1/Pa and 40 um of slip a cycle.
/// let grid = Grid::square(64, 64e-6)?;
/// let pair = ElasticPair::new(Material::new(115e9, 0.0)?, Material::rigid())?;
/// let bodies = HalfSpace::new(grid, pair)?;
/// let cycles = wear::stable_cycles(&bodies, 1e-14, &Field::constant(grid, 40e-6))?;
/// assert!((cycles - 25.2).abs() < 0.1);
/// # Ok::<(), stickslip::Error>(())
/// ```
pub fn stable_cycles(bodies: &HalfSpace, coefficient: f64, slip_length: &Field) -> Result<f64> {
    non_negative("wear coefficient", coefficient)?;
    check("slip length", slip_length, bodies.grid())?;
    let least_compliance = bodies.operator(Component::ZZ)?.lower_bound();
    Ok(2.0 * least_compliance / (coefficient * slip_length.max()))
}

/// How many cycles to jump over: the least of what stability, the shape of the contact and the cycles left
/// allow.
///
/// ```
/// use stickslip::history::wear::CycleJump;
/// let jump = CycleJump {
///     stable_cycles: 25.2,
///     approach: 5e-6,
///     approach_fraction: 0.01,
///     depth_per_cycle: 4e-9,
///     cycles_left: 1000.0,
/// };
/// assert_eq!(jump.cycles()?, 12.5);
/// # Ok::<(), stickslip::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct CycleJump {
    /// Cycles that are stable, [`stable_cycles`]; half of them to avoid overshoot.
    #[cfg_attr(feature = "serde", serde(with = "crate::serial::number"))]
    pub stable_cycles: f64,
    /// Approach of the bodies (a length).
    pub approach: f64,
    /// Part of the approach that may be worn off at once (dimensionless).
    pub approach_fraction: f64,
    /// Largest depth that one cycle removes, of both bodies together (a length).
    pub depth_per_cycle: f64,
    /// Cycles left to simulate.
    pub cycles_left: f64,
}

impl CycleJump {
    /// The number of cycles, not rounded.
    ///
    /// # Errors
    /// [`Error::Negative`](crate::Error::Negative) for a number that is negative or not finite; only the stable
    /// cycles may be infinite.
    pub fn cycles(&self) -> Result<f64> {
        if self.stable_cycles != f64::INFINITY {
            non_negative("number of stable cycles", self.stable_cycles)?;
        }
        let limit = non_negative("approach", self.approach)?
            * non_negative("fraction of the approach", self.approach_fraction)?;
        let left = non_negative("number of cycles left", self.cycles_left)?;
        let depth = non_negative("depth per cycle", self.depth_per_cycle)?;
        let shapely = if depth > 0.0 { limit / depth } else { left };
        Ok(left.min(self.stable_cycles).min(shapely))
    }
}
