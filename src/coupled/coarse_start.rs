//! Start of a coupled solve from the solution on coarser cells.

use crate::cgm::UNLIMITED;
use crate::contact::{SolveContext, interrupted_status, is_worth_coarsening};
use crate::coupled::increment::{CoupledIncrement, CoupledTarget};
use crate::error::Result;
use crate::memory::fallible::{self, try_each};
use crate::normal::Hardness;
use crate::tangential::{RigidMotion, prolongated_traction, reserve};

impl CoupledIncrement {
    /// Solves recursively on cells of twice the side length and uses the result as the start. Returns whether a coarser
    /// solution is available.
    pub(super) fn start_from_coarser(
        &mut self,
        demand: CoupledTarget<'_>,
        before: RigidMotion,
        conditions: &mut SolveContext<'_, '_>,
    ) -> Result<bool> {
        let size = self.bodies.grid().whole().size();
        if !is_worth_coarsening(&self.bodies, size) {
            return Ok(false);
        }
        let bodies = self.bodies.coarser()?.clone();
        let coarsened = |field: &[f64]| self.bodies.coarsened(&bodies, size, field);
        let gap = self.bodies.coarsened_field(&bodies, demand.gap)?;
        let friction = demand.friction.coarsened(&self.bodies, &bodies)?;
        let hardness = demand.hardness;
        let hardness = hardness.map(|hardness| hardness.coarsened(&self.bodies, &bodies));
        let hardness = hardness.transpose()?;
        let mut coarse = Self::new(&bodies)?;
        coarse.offsets = self.offsets.coarsened(coarsened)?;
        let rough = conditions.coarse_settings(f64::INFINITY);
        let coarse_demand = CoupledTarget {
            gap: &gap,
            friction: &friction,
            hardness: hardness.as_ref(),
            ..demand
        };
        let outcome = coarse.solve(coarse_demand, before, &mut conditions.under(&rough));
        if interrupted_status(outcome)?.is_some() {
            return Ok(false);
        }
        self.refine(&coarse, size, demand)?;
        Ok(true)
    }

    /// Interpolates the coarse solution to the cells of this solver.
    fn refine(&mut self, coarse: &Self, size: [usize; 2], demand: CoupledTarget<'_>) -> Result<()> {
        let answer = coarse.answer();
        (self.approach, self.last_shift) = (coarse.approach, answer.motion.shift);
        let [qx, qy] = answer.traction;
        let cells = answer.limits.len();
        let reserves = (0..cells).map(|cell| reserve([qx[cell], qy[cell]], answer.limits[cell]));
        let reserves = fallible::collected(cells, reserves)?;
        let zone = |field: &[f64]| self.bodies.refined_zone(&coarse.bodies, size, field);
        let (pressure, reserves) = (zone(answer.pressure)?, zone(&reserves)?);
        let [x, y] = try_each(|n| self.bodies.refined(&coarse.bodies, size, [qx, qy][n]))?;
        let limits = demand.hardness.map_or(UNLIMITED, Hardness::limits);
        for (cell, pressure) in pressure.iter().enumerate() {
            let pressure = pressure.min(limits.of(cell));
            let (limit, q) = (demand.friction.limit(cell, pressure), [x[cell], y[cell]]);
            let [x, y] = prolongated_traction(q, limit, reserves[cell] > 0.0, [0.0; 2]);
            for (part, value) in self.tractions.iter_mut().zip([pressure, x, y]) {
                part[cell] = value;
            }
        }
        Ok(())
    }
}
