//! Starts from coarser cells.

use crate::buffer::try_each;
use crate::cascade::{Conditions, is_worth_coarsening};
use crate::cgm::{Admissible, Disc, UNLIMITED};
use crate::coupled::increment::{CoupledDemand, CoupledIncrement};
use crate::error::Result;
use crate::field::Field;
use crate::normal::Hardness;
use crate::passes::ended_from_outside;
use crate::tangential::Motion;

impl CoupledIncrement {
    /// Takes the answer on cells twice as large, itself found so, as the start; says whether there is one.
    pub(super) fn start_from_coarser(
        &mut self,
        demand: CoupledDemand<'_>,
        before: Motion,
        conditions: &mut Conditions<'_, '_>,
    ) -> Result<bool> {
        let size = self.bodies.grid().whole().size();
        if !is_worth_coarsening(&self.bodies, size) {
            return Ok(false);
        }
        let bodies = self.bodies.coarser()?.clone();
        let coarsened = |field: &[f64]| self.bodies.coarsened(&bodies, size, field);
        let gap = Field::from_vec(bodies.grid(), coarsened(demand.gap.as_slice())?)?;
        let friction = demand.friction.coarsened(&self.bodies, &bodies)?;
        let hardness = demand.hardness;
        let hardness = hardness.map(|hardness| hardness.coarsened(&self.bodies, &bodies));
        let hardness = hardness.transpose()?;
        let mut coarse = Self::new(&bodies)?;
        coarse.set_offset(&try_each(|axis| coarsened(self.offset()[axis]))?);
        if self.enters {
            (coarse.closing, coarse.enters) = (coarsened(&self.closing)?, true);
        }
        let mut rough = Conditions {
            settings: &conditions.rough_settings(),
            start: conditions.start,
            observer: &mut *conditions.observer,
        };
        let coarse_demand = CoupledDemand {
            gap: &gap,
            friction: &friction,
            hardness: hardness.as_ref(),
            ..demand
        };
        if ended_from_outside(coarse.solve(coarse_demand, before, &mut rough))?.is_some() {
            return Ok(false);
        }
        self.refine(&coarse, size, demand)?;
        Ok(true)
    }

    /// Interpolates the coarse answer; where the coarse cell slips, at the limit.
    fn refine(&mut self, coarse: &Self, size: [usize; 2], demand: CoupledDemand<'_>) -> Result<()> {
        let answer = coarse.answer();
        self.set_known(coarse.approach(), answer.motion.shift);
        let [qx, qy] = answer.traction;
        let parts = [answer.pressure, qx, qy];
        let [p, x, y] = try_each(|n| self.bodies.refined(&coarse.bodies, size, parts[n]))?;
        let at_limit = (0..answer.limits.len()).map(|cell| answer.is_at_limit(cell));
        let slips = self.bodies.inherited(&coarse.bodies, size, at_limit)?;
        let limits = demand.hardness.map_or(UNLIMITED, Hardness::limits);
        for (cell, pressure) in p.iter().enumerate() {
            let pressure = pressure.min(limits.of(cell));
            let disc = Disc {
                radius: demand.friction.limit(cell, pressure),
            };
            let q = [x[cell], y[cell]];
            let q = if slips[cell] && q[0].hypot(q[1]) > 0.0 {
                disc.rim_along(q)
            } else {
                disc.project(q)
            };
            self.set_cell(cell, [pressure, q[0], q[1]]);
        }
        Ok(())
    }
}
