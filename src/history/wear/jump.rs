//! Number of cycles that a wear simulation may jump over.

use crate::bodies::component::Component;
use crate::cgm::reduce;
use crate::error::{Error, Result, non_negative};
use crate::grid::field::Field;
use crate::half_space::HalfSpace;
use crate::history::Cycle;
use crate::history::wear::{Coefficient, check};
use crate::operator::Operator;

/// Returns the largest number of cycles whose wear can be applied at once with a stable pressure. Explicit wear by
/// Archard's law is stable below this number. The number is infinite if no cell slips.
///
/// Consider a pressure mode with the compliance $`\lambda`$, an eigenvalue of $`C_{zz}`$. Removing the depth $`N k s\,p`$ changes
/// this mode by the factor $`1 - N k s / \lambda`$. All modes decay if
///
/// ```math
/// N\,k\,s < 2\,\lambda_{min} \qquad (= 1.16\,h/E^* \text{ on square cells of side } h;\ 0.90\,h/E^* \text{ on a periodic grid}),
/// ```
///
/// and no mode changes sign below half of this number, which is the limit of [`CycleJump`]. `coefficient` is the sum of the
/// coefficients of both bodies. `slip_distance` is the slip distance of one cycle. For the energy law, pass the product of its
/// coefficient and the coefficient of friction. For [distributed](HalfSpace::distributed) bodies the call is collective.
///
/// # Errors
/// - [`Error::NegativeOrNotFinite`] if the uniform coefficient is negative or not finite.
/// - [`Error::GridMismatch`] or [`Error::Sample`] for the coefficients or the slip distance.
/// - [`Error::NotPositive`] for user-defined operators without a lower bound.
/// - Errors of [`HalfSpace::operator`].
/// - [`Error::Ranks`] if ranks fail or pass different input.
///
/// ```
/// use stickslip::history::wear;
/// use stickslip::{ElasticPair, Field, Grid, HalfSpace, Material};
/// // E* = 115 GPa, cells of one micrometre, k = 1e-14 1/Pa and a slip distance of 40 um per cycle.
/// let grid = Grid::square(64, 64e-6)?;
/// let pair = ElasticPair::new(Material::new(115e9, 0.0)?, Material::rigid())?;
/// let bodies = HalfSpace::new(grid, pair)?;
/// let cycles = wear::max_stable_cycles(&bodies, 1e-14, &Field::constant(grid, 40e-6))?;
/// assert!((cycles - 25.2).abs() < 0.1);
/// # Ok::<(), stickslip::Error>(())
/// ```
pub fn max_stable_cycles<'a>(
    bodies: &HalfSpace,
    coefficient: impl Into<Coefficient<'a>>,
    slip_distance: &Field,
) -> Result<f64> {
    let coefficient = coefficient.into();
    let checked = coefficient.check(bodies.grid());
    bodies.collective_result_checked(
        checked.and_then(|()| check("slip length", slip_distance, bodies.grid())),
        &[("wear coefficient", &coefficient.common())],
    )?;
    let slip = slip_distance.as_slice();
    let rate = reduce::max(&bodies.grid_layout(), |i| coefficient.at(i) * slip[i]);
    Ok(2.0 * cycles_without_overshoot(bodies, rate)?)
}

/// Number of cycles to jump over. The wear of these cycles can be applied at once without an oscillation of the
/// pressure.
///
/// Let $`h`$ be the depth that a cycle removes by any law that is proportional to the slip pressure $`p`$. This depth
/// changes by $`h/p`$ per unit of pressure. If $`N h / p < \lambda_{min}`$ in every cell, no pressure mode changes sign. This
/// limit is half of the [stable](max_stable_cycles) number of cycles. The shape of the contact and the number of remaining cycles
/// set further limits.
///
/// ```
/// use stickslip::history::wear::{self, CycleJump};
/// use stickslip::history::{Cycle, FrettingLoop, LoadPath};
/// use stickslip::*;
/// let grid = Grid::square(32, 8.0)?;
/// let rubber = Material::new(1.0, 0.5)?;
/// let bodies = HalfSpace::new(grid, ElasticPair::new(rubber, Material::rigid())?)?;
/// let mut gap = surface::sphere(grid, 10.0)?;
/// let mut history = History::builder(&bodies, &gap, Friction::coulomb(0.3)?).build()?;
/// let fretting = FrettingLoop::new(LoadPath::triangle([0.1, 0.0], 4)?, |shift| {
///     LoadStep::shift(shift).normal(NormalLoad::Force(0.5))
/// });
///
/// // The first cycle, from rest, is not representative of the following cycles.
/// let (mut cycle, mut done) = (Cycle::new(&history), 0.0);
/// fretting.cycle(&mut history, &mut cycle)?;
/// while done < 1000.0 {
///     fretting.cycle(&mut history, &mut cycle)?;
///     let mut depth = Field::zeros(grid);
///     wear::energy(1e-2, cycle.dissipation(), &mut depth)?;
///     let jump = CycleJump::new(&bodies, &cycle, &depth)?
///         .largest_depth(0.05 * history.approach())
///         .cycles_left(1000.0 - done)
///         .cycles()?;
///     gap.add_scaled(jump, &depth)?;
///     history.set_gap(&gap)?;
///     done += jump;
/// }
/// assert_eq!(done, 1000.0);
/// # Ok::<(), Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
#[must_use = "call cycles() to obtain the number of cycles"]
pub struct CycleJump {
    without_overshoot: f64,
    depth_per_cycle: f64,
    residual: f64,
    max_residual: f64,
    largest_depth: Option<f64>,
    cycles_left: Option<f64>,
}

/// Default residual up to which a cycle is representative of the following cycles. The residuals that wear and jumps
/// cause in a steady cycle are smaller.
const CLOSED: f64 = 0.25;

impl CycleJump {
    /// Creates a jump over cycles like `cycle`. `depth` is the depth removed from both bodies together in this cycle (lengths). A
    /// cell that did not slip under pressure sets no limit. Next to the contact, such a cell can have a depth if the depth was
    /// smoothed. A cycle of [rolled](crate::LoadStep::roll) steps has no jump, because its slip belongs to moving particles.
    ///
    /// # Errors
    /// - [`Error::GridMismatch`], [`Error::BoundaryMismatch`] or [`Error::MaterialMismatch`] if the cycle was computed for other
    ///   bodies.
    /// - [`Error::Sample`] at a depth that is negative or not finite.
    /// - [`Error::EmptyPath`] if the cycle has no steps.
    /// - [`Error::NotPositive`] for user-defined operators without a lower bound.
    /// - Errors of [`HalfSpace::operator`].
    /// - [`Error::Ranks`] if ranks fail.
    pub fn new(bodies: &HalfSpace, cycle: &Cycle, depth: &Field) -> Result<Self> {
        let (grid, slip_pressure) = (bodies.grid(), cycle.slip_pressure());
        let checked = check("pressure of the cycle", slip_pressure, grid)
            .and_then(|()| check("depth of the cycle", depth, grid))
            .and_then(|()| cycle.check_bodies("bodies of the jump", bodies))
            .and_then(|()| cycle.cyclic_residual());
        let residual = bodies.collective_result(checked)?;
        let (pressure, removed) = (slip_pressure.as_slice(), depth.as_slice());
        let layout = bodies.grid_layout();
        let rate = reduce::max(&layout, |i| {
            if pressure[i] > 0.0 {
                removed[i] / pressure[i]
            } else {
                0.0
            }
        });
        let depth_per_cycle = reduce::max(&layout, |i| removed[i]);
        Ok(Self {
            without_overshoot: cycles_without_overshoot(bodies, rate)?,
            depth_per_cycle,
            residual,
            max_residual: CLOSED,
            largest_depth: None,
            cycles_left: None,
        })
    }

    /// Sets the largest depth that may be removed at once (a length, no limit by default). A hundredth of the approach preserves
    /// the shape of a ball.
    pub fn largest_depth(mut self, depth: f64) -> Self {
        self.largest_depth = Some(depth);
        self
    }

    /// Sets the largest [residual](Cycle::cyclic_residual) of an acceptable cycle (relative to its amplitude, default 0.25). The
    /// first cycle from rest does not close, and it is not representative of the following cycles. The same holds for the first
    /// cycle after a change of the gap.
    pub fn max_residual(mut self, residual: f64) -> Self {
        self.max_residual = residual;
        self
    }

    /// Sets the remaining number of cycles of the simulation, which is an upper limit of the jump (no limit by default).
    pub fn cycles_left(mut self, cycles: f64) -> Self {
        self.cycles_left = Some(cycles);
        self
    }

    /// Returns the number of cycles without rounding. It is the smallest of the limits, or infinity without a limit.
    ///
    /// A number below one means that the wear of a single cycle is too large for one update. A number far below one usually
    /// results from a wear coefficient in an inconsistent unit (1 mm3/(N m) is 1e-9 1/Pa).
    ///
    /// An infinite number is not a factor for a depth: [`Field::add_scaled`](crate::Field::add_scaled) rejects it. It results if
    /// no cell slips and no other limit is set. Set [`Self::cycles_left`] or [`Self::largest_depth`] before using the number.
    ///
    /// # Errors
    /// - [`Error::NegativeOrNotFinite`] if a limit is negative or not finite.
    /// - [`Error::CycleNotClosed`] if the residual of the cycle exceeds the allowed value.
    pub fn cycles(&self) -> Result<f64> {
        let limit = non_negative("residual of a closed cycle", self.max_residual)?;
        if self.residual.is_nan() || self.residual > limit {
            return Err(Error::CycleNotClosed {
                residual: self.residual,
                limit,
            });
        }
        let mut cycles = self.without_overshoot;
        if let Some(depth) = self.largest_depth {
            let depth = non_negative("largest depth", depth)?;
            if self.depth_per_cycle > 0.0 {
                cycles = cycles.min(depth / self.depth_per_cycle);
            }
        }
        if let Some(left) = self.cycles_left {
            cycles = cycles.min(non_negative("number of cycles left", left)?);
        }
        Ok(cycles)
    }
}

/// Returns $`\lambda_{min}`$ divided by the largest depth per pressure that a cycle removes.
fn cycles_without_overshoot(bodies: &HalfSpace, rate: f64) -> Result<f64> {
    let compliance = bodies.operator(Component::ZZ)?;
    compliance.check_bounded()?;
    // If a datum makes the compliance indefinite, the force is prescribed. Changes of the pressure then have zero mean.
    let least = match compliance.lower_bound() {
        least if least > 0.0 => least,
        _ => compliance.bound_without_mean().0,
    };
    bodies.joint(Ok(if rate > 0.0 {
        least / rate
    } else {
        f64::INFINITY
    }))
}
