//! Setters of the input of coupled steady rolling.

use crate::error::Result;
use crate::grid::field::{self, Field};
use crate::memory::fallible::TryClone;
use crate::normal::NormalLoad;
use crate::rolling::coupled::CoupledRollingSolver;
use crate::rolling::{RollingControl, SpinControl};
use crate::tangential::Friction;

impl CoupledRollingSolver {
    /// Sets the loads or creepages along x and y, and the spin or moment, for the next solve.
    ///
    /// # Errors
    /// - [`Error::NotFinite`](crate::Error::NotFinite) or
    ///   [`Error::UnsupportedByModel`](crate::Error::UnsupportedByModel) if a load is not finite or not supported.
    /// - [`Error::BeyondFrictionCapacity`](crate::Error::BeyondFrictionCapacity) if the forces reach or exceed the
    ///   largest coefficient of friction times a prescribed normal force. For a prescribed approach, the solve returns
    ///   this error.
    ///
    /// All loads are unchanged after an error.
    pub fn set_load(&mut self, controls: [RollingControl; 2], spin: SpinControl) -> Result<()> {
        let problem = &self.problem;
        problem.check(&problem.friction, problem.normal, controls, spin)?;
        if self.problem.options.set_load(controls, spin) {
            self.engine.changed = Some("the load");
        }
        Ok(())
    }

    /// Sets the normal load for the next solve.
    ///
    /// # Errors
    /// - [`Error::NegativeOrNotFinite`](crate::Error::NegativeOrNotFinite),
    ///   [`Error::NotFinite`](crate::Error::NotFinite) or
    ///   [`Error::ApproachBeyondMeanGap`](crate::Error::ApproachBeyondMeanGap).
    /// - [`Error::BeyondFrictionCapacity`](crate::Error::BeyondFrictionCapacity) as for [`set_load`](Self::set_load).
    ///   [`set_loads`](Self::set_loads) changes the normal load and the forces together.
    ///
    /// The load is unchanged after an error.
    pub fn set_normal_load(&mut self, normal: NormalLoad) -> Result<()> {
        self.problem
            .check_capacity(&self.problem.friction, normal)?;
        if std::mem::replace(&mut self.problem.normal, normal) != normal {
            self.engine.changed = Some("the normal load");
        }
        Ok(())
    }

    /// Sets the normal load, the loads or creepages along x and y, and the spin or moment together for the next solve. Only the
    /// new forces must be below the friction limit of the new normal load.
    ///
    /// ```
    /// use stickslip::rolling::{CoupledRollingProblem, RollingControl, SpinControl};
    /// use stickslip::*;
    /// let grid = Grid::square(24, 3.0)?;
    /// let bodies = HalfSpace::new(grid, ElasticPair::new(Material::new(1.0, 0.0)?, Material::rigid())?)?;
    /// let (ball, friction) = (surface::sphere(grid, 1.0)?, Friction::coulomb(0.3)?);
    /// let drag = |force| [RollingControl::Force(force), RollingControl::Creepage(0.0)];
    /// let problem = CoupledRollingProblem::builder(&bodies, &ball, friction, NormalLoad::Force(1.0));
    /// let mut solver = problem.control(Axis::X, RollingControl::Force(0.25)).build()?.into_solver()?;
    /// // Friction would not carry the old force under the new normal load.
    /// assert!(solver.set_normal_load(NormalLoad::Force(0.5)).is_err());
    /// solver.set_loads(NormalLoad::Force(0.5), drag(0.1), SpinControl::Spin(0.0))?;
    /// # Ok::<(), Error>(())
    /// ```
    ///
    /// # Errors
    /// - [`Error::NegativeOrNotFinite`](crate::Error::NegativeOrNotFinite),
    ///   [`Error::NotFinite`](crate::Error::NotFinite) or
    ///   [`Error::ApproachBeyondMeanGap`](crate::Error::ApproachBeyondMeanGap) for an invalid normal load.
    /// - The errors of [`set_load`](Self::set_load) under the new normal load.
    ///
    /// All loads are unchanged after an error.
    pub fn set_loads(
        &mut self,
        normal: NormalLoad,
        controls: [RollingControl; 2],
        spin: SpinControl,
    ) -> Result<()> {
        let problem = &mut self.problem;
        problem.check(&problem.friction, normal, controls, spin)?;
        if problem.options.set_load(controls, spin) {
            self.engine.changed = Some("the load");
        }
        if std::mem::replace(&mut problem.normal, normal) != normal {
            self.engine.changed = Some("the normal load");
        }
        Ok(())
    }

    /// Returns the gap before loading of the next solve: the last gap that was given or [set](Self::set_gap). The gap does not
    /// contain the lift due to the tractions.
    #[must_use]
    pub fn gap(&self) -> &Field {
        &self.problem.gap
    }

    /// Sets the gap before loading for the next solve.
    ///
    /// The next solution has the warning [`LargeGapChange`](crate::Warning::LargeGapChange) after wear much deeper than the
    /// displacements.
    ///
    /// # Errors
    /// - [`Error::GridMismatch`](crate::Error::GridMismatch), [`Error::Sample`](crate::Error::Sample) or
    ///   [`Error::Memory`](crate::Error::Memory).
    /// - [`Error::GapUnderLoad`](crate::Error::GapUnderLoad) if the gap is the gap under load of the last solution.
    /// - [`Error::ApproachBeyondMeanGap`](crate::Error::ApproachBeyondMeanGap) if a prescribed approach is too large for the gap.
    ///
    /// The gap is unchanged after an error.
    pub fn set_gap(&mut self, gap: &Field) -> Result<()> {
        let bodies = &self.problem.bodies;
        gap.check("gap", bodies.grid())?;
        self.engine.last_gap.check(gap)?;
        self.problem.normal.check(bodies, gap, None)?;
        self.engine.last_gap.store(&self.problem.gap);
        field::replace(&mut self.problem.gap, gap)?;
        self.engine.changed = Some("the gap");
        Ok(())
    }

    /// Returns the friction of the next solve, with its cap: the last friction that was given or [set](Self::set_friction).
    #[must_use]
    pub fn friction(&self) -> &Friction {
        &self.problem.friction
    }

    /// Sets the friction for the next solve. The new friction replaces the earlier coefficient and the earlier cap.
    ///
    /// # Errors
    /// - [`Error::GridMismatch`](crate::Error::GridMismatch) or [`Error::Memory`](crate::Error::Memory).
    /// - [`Error::BeyondFrictionCapacity`](crate::Error::BeyondFrictionCapacity) as for [`set_load`](Self::set_load).
    ///
    /// The friction is unchanged after an error.
    pub fn set_friction(&mut self, friction: &Friction) -> Result<()> {
        friction.check(self.problem.bodies.grid())?;
        self.problem.check_capacity(friction, self.problem.normal)?;
        self.problem.friction.try_clone_from(friction)?;
        self.engine.changed = Some("the friction");
        Ok(())
    }
}
