//! How many cycles may be jumped.

use crate::bodies::component::Component;
use crate::cgm::reduce;
use crate::error::{Error, Result, non_negative};
use crate::grid::field::Field;
use crate::half_space::HalfSpace;
use crate::history::Cycle;
use crate::history::wear::{Coefficient, check};
use crate::operator::Operator;

/// Cycles whose wear may be taken off at once without the pressure swinging up: explicit wear by Archard's
/// law is stable below (infinite where nothing slips).
///
/// Taking off $`N k s\,p`$ changes a pattern of pressure of compliance $`\lambda`$, an eigenvalue of
/// $`C_{zz}`$, by the factor $`1 - N k s / \lambda`$. All patterns decay if
///
/// ```math
/// N\,k\,s < 2\,\lambda_{min} \qquad (= 1.16\,h/E^* \text{ on square cells of side } h;\ 0.90\,h/E^* \text{ on a periodic grid}),
/// ```
///
/// and none changes sign below half of that, where a [`CycleJump`] stays. `coefficient` is the sum of both
/// bodies, `slip_distance` that of one cycle. For the energy law, pass its coefficient times that of
/// friction. Of [distributed](HalfSpace::distributed) bodies all ranks ask for it together.
///
/// # Errors
/// [`Error::NegativeOrNotFinite`] for the coefficient,
/// [`Error::GridMismatch`] or [`Error::Sample`] for
/// coefficients and slip length; [`Error::NotPositive`] for operators of a user without a lower bound; as
/// [`HalfSpace::operator`]; [`Error::Ranks`].
///
/// ```
/// use stickslip::history::wear;
/// use stickslip::{ElasticPair, Field, Grid, HalfSpace, Material};
/// // E* = 115 GPa, cells of a micrometre, k = 1e-14 1/Pa and 40 um of slip a cycle.
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

/// How many cycles to jump over: as many as a cycle's wear may be taken off at once, without the pressure
/// swinging.
///
/// The depth $`h`$ that a cycle removes, by any law that is proportional to the pressure $`p`$ it slipped
/// under, changes with it by $`h/p`$, and $`N h / p < \lambda_{min}`$ in every cell lets no pattern of
/// pressure change sign: half of what is [stable](max_stable_cycles). The shape of the contact and the cycles
/// left set other limits.
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
///     LoadStep::shift(shift).normal(NormalControl::Force(0.5))
/// });
///
/// // The first cycle, from rest, does not stand for those that follow.
/// let (mut cycle, mut done) = (Cycle::new(&history), 0.0);
/// fretting.cycle(&mut history, &mut cycle)?;
/// while done < 1000.0 {
///     fretting.cycle(&mut history, &mut cycle)?;
///     let mut depth = Field::zeros(grid);
///     wear::energy(1e-2, cycle.dissipated_energy(), &mut depth)?;
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
#[must_use = "a jump is a number only by cycles()"]
pub struct CycleJump {
    without_overshoot: f64,
    depth_per_cycle: f64,
    residual: f64,
    max_residual: f64,
    largest_depth: Option<f64>,
    cycles_left: Option<f64>,
}

/// Residual of a cycle that still stands for those that follow: wear and jumps change a steady one by less.
const CLOSED: f64 = 0.25;

impl CycleJump {
    /// A jump over cycles like this one, which removed this depth (lengths), of both bodies together. Where nothing
    /// slipped under pressure, as beside the contact after smoothing the depth, it sets no limit.
    ///
    /// # Errors
    /// [`Error::GridMismatch`], [`Error::Sample`] for a
    /// depth that is negative or not finite; [`Error::NotPositive`] for operators of a user without a lower bound; as
    /// [`HalfSpace::operator`]; [`Error::Ranks`].
    pub fn new(bodies: &HalfSpace, cycle: &Cycle, depth: &Field) -> Result<Self> {
        let (grid, slip_pressure) = (bodies.grid(), cycle.slip_pressure());
        let checked = check("pressure of the cycle", slip_pressure, grid);
        bodies
            .collective_result(checked.and_then(|()| check("depth of the cycle", depth, grid)))?;
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
            residual: cycle.cyclic_residual(),
            max_residual: CLOSED,
            largest_depth: None,
            cycles_left: None,
        })
    }

    /// With no more than this depth worn off at once (a length; default: without limit). A hundredth of the
    /// approach keeps a ball's shape.
    pub fn largest_depth(mut self, depth: f64) -> Self {
        self.largest_depth = Some(depth);
        self
    }

    /// Accepts a cycle whose [residual](Cycle::cyclic_residual) is no more than this (a part of its amplitude; default:
    /// 0.25). A first cycle from rest, or after a change of the gap, does not close, and would stand for others than
    /// those that follow.
    pub fn max_residual(mut self, residual: f64) -> Self {
        self.max_residual = residual;
        self
    }

    /// Limits the jump to the cycles left to simulate (default: no limit).
    pub fn cycles_left(mut self, cycles: f64) -> Self {
        self.cycles_left = Some(cycles);
        self
    }

    /// The number of cycles, not rounded: the least that a limit allows, infinite without a limit.
    ///
    /// # Errors
    /// [`Error::NegativeOrNotFinite`] for a limit that is negative or not finite,
    /// [`Error::CycleNotClosed`] for a cycle that does not close within what is allowed.
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

/// $`\lambda_{min}`$ over the depth per pressure that a cycle removes at most.
fn cycles_without_overshoot(bodies: &HalfSpace, rate: f64) -> Result<f64> {
    let compliance = bodies.operator(Component::ZZ)?;
    compliance.check_bounded()?;
    // If a datum makes the compliance indefinite, the force is prescribed, and pressures change without a mean.
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
