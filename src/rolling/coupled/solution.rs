//! The solution of coupled steady rolling.

use crate::error::Result;
use crate::grid::record::record;
use crate::memory::fallible::unwrap_or_abort;
use crate::normal::NormalSolution;
use crate::rolling::RollingSolution;
use crate::rolling::coupled::CoupledRollingReport;
use crate::support::debug::shown;
use crate::warning::Warning;

record! {
    /// Normal and rolling solutions of coupled steady rolling. Two solutions are equal if both halves are equal, even if their
    /// solves took different numbers of iterations.
    pub struct CoupledRollingSolution {
        buffers {
            pub(super) normal: NormalSolution,
            pub(super) rolling: RollingSolution,
        }
        values {}
        ignored {
            pub(super) report: CoupledRollingReport,
        }
        local {}
    }
    #[serde(remote = "CoupledRollingSolution", deny_unknown_fields)]
    check(read) {
        let grid = read.normal.grid();
        grid.check_equal("rolling solution", read.rolling.grid())
    }
}

shown!(CoupledRollingSolution: normal, rolling, report());

impl CoupledRollingSolution {
    /// Returns the normal half: pressure, gap under load, approach and contact area. The gap includes the lift due to
    /// the tractions. For coupled bodies the report of this half is the report of the coupled solve.
    #[must_use]
    pub fn normal(&self) -> &NormalSolution {
        &self.normal
    }

    /// Returns the rolling half: tractions, slip, zones, creepages, force and moment. For coupled bodies the report of
    /// this half is the report of the coupled solve.
    #[must_use]
    pub fn rolling(&self) -> &RollingSolution {
        &self.rolling
    }

    /// Returns the status, the cost, the passes and the certified errors of the solve.
    #[must_use]
    pub fn report(&self) -> &CoupledRollingReport {
        &self.report
    }

    /// Returns the warnings about the normal half, and about a [large creepage](Warning::LargeCreepage).
    #[must_use]
    pub fn warnings(&self) -> Vec<Warning> {
        unwrap_or_abort(self.try_warnings())
    }

    /// Returns [`Self::warnings`], or an error if memory runs out.
    ///
    /// # Errors
    /// - [`Error::Memory`](crate::Error::Memory) if memory runs out.
    pub fn try_warnings(&self) -> Result<Vec<Warning>> {
        let mut warnings = self.normal.try_warnings()?;
        warnings.extend(self.rolling.load_warnings().into_iter().flatten());
        Ok(warnings)
    }
}
