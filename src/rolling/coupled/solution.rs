//! The solution of coupled steady rolling.

use crate::error::Result;
use crate::memory::fallible::{try_clone, unwrap_or_abort};
use crate::normal::NormalSolution;
use crate::rolling::RollingSolution;
use crate::rolling::coupled::CoupledRollingReport;
use crate::support::debug::shown;
#[cfg(feature = "serde")]
use crate::support::serialise::checked;
use crate::warning::Warning;

/// Normal and rolling solutions of coupled steady rolling. Two solutions are equal if both halves are equal, even if their
/// solves took different numbers of iterations.
#[derive(Clone)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct CoupledRollingSolution {
    pub(super) normal: NormalSolution,
    pub(super) rolling: RollingSolution,
    pub(super) report: CoupledRollingReport,
}

shown!(CoupledRollingSolution: normal, rolling, report());

try_clone!(CoupledRollingSolution { normal, rolling } { report });

impl PartialEq for CoupledRollingSolution {
    fn eq(&self, other: &Self) -> bool {
        let Self {
            normal,
            rolling,
            report: _,
        } = self;
        *normal == other.normal && *rolling == other.rolling
    }
}

#[cfg(feature = "serde")]
#[derive(serde::Deserialize)]
#[serde(remote = "CoupledRollingSolution", deny_unknown_fields)]
struct RawCoupledRollingSolution {
    normal: NormalSolution,
    rolling: RollingSolution,
    report: CoupledRollingReport,
}

#[cfg(feature = "serde")]
impl<'de> serde::Deserialize<'de> for CoupledRollingSolution {
    fn deserialize<D: serde::Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        checked(
            RawCoupledRollingSolution::deserialize(deserializer)?,
            |read| {
                let grid = read.normal.grid();
                grid.check_equal("rolling solution", read.rolling.grid())
            },
        )
    }
}

impl CoupledRollingSolution {
    /// Returns the normal half: pressure, gap under load, approach and contact area. The gap includes the lift by the
    /// tractions. For coupled bodies the report of this half is the report of the coupled solve.
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

    /// Returns the warnings about the normal half. See [`Warning`].
    #[must_use]
    pub fn warnings(&self) -> Vec<Warning> {
        unwrap_or_abort(self.try_warnings())
    }

    /// Returns [`Self::warnings`], or an error if memory runs out.
    ///
    /// # Errors
    /// - [`Error::Memory`](crate::Error::Memory) if memory runs out.
    pub fn try_warnings(&self) -> Result<Vec<Warning>> {
        self.normal.try_warnings()
    }
}
