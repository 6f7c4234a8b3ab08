//! Result of one step of a history.

use crate::error::Result;
#[cfg(feature = "serde")]
use crate::error::{all_finite, at_least, finite};
use crate::grid::Grid;
use crate::grid::field::Field;
use crate::grid::record::checked_struct;
use crate::history::EnergyBalance;
use crate::history::state::mark::StateMark;
use crate::history::state::readers::ratio;
use crate::history::step::diagnostics::StepDiagnostics;
use crate::memory::fallible::try_clone;
use crate::report::{Report, Status};
use crate::support::debug::shown;
use crate::warning::Warning;

checked_struct! {
    /// Slip, energies, forces and reports of one step.
    ///
    /// Vectors are `[x, y]`. In the scalar model the component across the axis of the tractions is zero. The
    /// [`History`](crate::history::History) has the state after the step.
    #[derive(Clone, PartialEq)]
    pub struct StepResult {
        pub(in crate::history) slip: [Field; 2],
        pub(in crate::history) slip_distance: Field,
        pub(in crate::history) dissipated_energy: Field,
        pub(in crate::history) dissipated_energy_midpoint: Field,
        pub(in crate::history) energy: EnergyBalance,
        pub(in crate::history) normal_force: f64,
        pub(in crate::history) approach: f64,
        pub(in crate::history) force: [f64; 2],
        pub(in crate::history) moment: f64,
        pub(in crate::history) shift: [f64; 2],
        pub(in crate::history) twist: f64,
        #[cfg_attr(feature = "serde", serde(default))]
        pub(in crate::history) creepage: Option<[f64; 2]>,
        pub(in crate::history) stick_cells: usize,
        pub(in crate::history) slip_cells: usize,
        pub(in crate::history) remarks: StepDiagnostics,
        /// State before the step, or `None` for a result without a step.
        #[cfg_attr(feature = "serde", serde(default))]
        pub(in crate::history) start: Option<StateMark>,
        pub(in crate::history) normal_report: Report,
        pub(in crate::history) tangential_report: Report,
    }
    #[serde(remote = "StepResult")]
    check(read) {
        let grid = read.slip_distance.grid();
        for slip in &read.slip {
            slip.check("slip", grid)?;
        }
        read.slip_distance.check("slip length", grid)?;
        read.dissipated_energy.check("dissipated energy", grid)?;
        read.dissipated_energy_midpoint
            .check("dissipated energy", grid)?;
        finite("normal force", read.normal_force)?;
        finite("approach", read.approach)?;
        all_finite("tangential force", &read.force)?;
        finite("moment", read.moment)?;
        all_finite("shift", &read.shift)?;
        finite("twist", read.twist)?;
        all_finite("creepage", &read.creepage.unwrap_or_default())?;
        let cells = grid.cells() as f64;
        [read.stick_cells, read.slip_cells]
            .into_iter()
            .try_for_each(|counted| {
                let name = "cells that stick or slip";
                at_least(name, counted as f64, "number of cells", cells).map(|_| ())
            })
    }
}

shown!(StepResult: normal_force, approach, force, shift, twist, stick_ratio(), energy);

try_clone!(StepResult { slip, slip_distance, dissipated_energy, dissipated_energy_midpoint } {
    energy, normal_force, approach, force, moment, shift, twist, creepage, stick_cells, slip_cells, remarks, start,
    normal_report, tangential_report,
});

impl StepResult {
    /// Creates an empty result.
    pub(in crate::history) fn new(grid: Grid) -> Result<Self> {
        let zeros = || Field::try_zeros(grid);
        Ok(Self {
            slip: [zeros()?, zeros()?],
            slip_distance: zeros()?,
            dissipated_energy: zeros()?,
            dissipated_energy_midpoint: zeros()?,
            energy: EnergyBalance::default(),
            normal_force: 0.0,
            approach: 0.0,
            force: [0.0; 2],
            moment: 0.0,
            shift: [0.0; 2],
            twist: 0.0,
            creepage: None,
            stick_cells: 0,
            slip_cells: 0,
            remarks: StepDiagnostics::default(),
            start: None,
            normal_report: Report::with_room(),
            tangential_report: Report::with_room(),
        })
    }

    /// Sets all fields to zero.
    pub(in crate::history) fn clear_fields(&mut self) {
        let fields = [
            &mut self.slip_distance,
            &mut self.dissipated_energy,
            &mut self.dissipated_energy_midpoint,
        ];
        for field in self.slip.iter_mut().chain(fields) {
            field.as_mut_slice().fill(0.0);
        }
    }

    /// Returns the slip of the step, the change of `u - delta` (lengths). The slip is opposite to the traction, and
    /// exactly zero in stick cells and outside the contact.
    #[must_use]
    pub fn slip(&self) -> [&Field; 2] {
        self.slip.each_ref()
    }

    /// Returns the length of the slip of the step (lengths, non-negative).
    #[must_use]
    pub fn slip_distance(&self) -> &Field {
        &self.slip_distance
    }

    /// Returns the energy that each cell dissipates in the step, `-A q s >= 0`. The traction q is the traction of the
    /// cell at the end of the step.
    #[doc(alias = "dissipated energy")]
    #[must_use]
    pub fn dissipation(&self) -> &Field {
        &self.dissipated_energy
    }

    /// Returns the energy that each cell dissipates in the step, `-A (q_n + q_{n+1})/2 s`. It is computed from the mean
    /// of the tractions before and after the step. This energy closes the [`EnergyBalance`].
    #[must_use]
    pub fn dissipation_midpoint(&self) -> &Field {
        &self.dissipated_energy_midpoint
    }

    /// Returns work, elastic energy and dissipation of the step.
    #[must_use]
    pub fn energy(&self) -> &EnergyBalance {
        &self.energy
    }

    /// Returns the normal force W at the end of the step.
    #[must_use]
    pub fn normal_force(&self) -> f64 {
        self.normal_force
    }

    /// Returns the approach at the end of the step (a length).
    #[must_use]
    pub fn approach(&self) -> f64 {
        self.approach
    }

    /// Returns the tangential force that body 2 exerts on body 1 at the end of the step.
    #[must_use]
    pub fn tangential_force(&self) -> [f64; 2] {
        self.force
    }

    /// Returns the moment of the tractions on body 1 at the end of the step (force times length, positive from x to y).
    /// The moment is about the origin of the grid.
    #[must_use]
    pub fn moment(&self) -> f64 {
        self.moment
    }

    /// Returns the shift of body 2 relative to body 1 from the start of the history to the end of the step (lengths).
    #[must_use]
    pub fn shift(&self) -> [f64; 2] {
        self.shift
    }

    /// Returns the rotation of body 2 relative to body 1 from the start of the history to the end of the step
    /// (radians).
    #[must_use]
    pub fn twist(&self) -> f64 {
        self.twist
    }

    /// Returns the creepages $`[\xi, \eta]`$ of a rolled step, the motion of body 2 over body 1 per length rolled
    /// (dimensionless). A creepage is prescribed or follows from the force. Returns `None` if the step did not roll.
    #[must_use]
    pub fn creepage(&self) -> Option<[f64; 2]> {
        self.creepage
    }

    /// Returns the ratio of stick cells to contact cells at the end of the step. The ratio is zero without contact.
    #[must_use]
    pub fn stick_ratio(&self) -> f64 {
        ratio([self.stick_cells, self.slip_cells])
    }

    /// Returns whether the whole contact is at its friction limit at the end of the step.
    #[must_use]
    pub fn is_gross_slip(&self) -> bool {
        self.stick_cells == 0 && self.slip_cells > 0
    }

    /// Returns the report of the normal contact, or `None` if the pressure was held. If load and gap have not changed
    /// since the previous step, the pressure is reused. The report then contains the earlier error bounds and no work.
    #[must_use]
    pub fn normal_report(&self) -> Option<&Report> {
        solved(&self.normal_report)
    }

    /// Returns the report of the tangential contact, or `None` before the first contact.
    #[must_use]
    pub fn tangential_report(&self) -> Option<&Report> {
        solved(&self.tangential_report)
    }

    /// Returns the warnings of the step:
    ///
    /// - [`Warning::StalePressure`] if the step held the pressure although [`set_gap`](crate::History::set_gap) had
    ///   changed the gap,
    /// - [`Warning::ContactAtEdge`],
    /// - the warnings about contacts and zones of too few cells, such as [`Warning::UnderresolvedSlipZone`],
    /// - the warnings about large approaches, slopes, shifts, twists, creepages and coefficients of friction,
    /// - the warnings about low or high values of the hardness and the largest shear stress, as [`Warning::LowHardness`],
    /// - [`Warning::LargeGapChange`], [`Warning::NegativeWear`] and [`Warning::ClosedGap`],
    /// - [`Warning::HeldShiftLostForce`],
    /// - [`Warning::UnusedRelativeDisplacement`],
    /// - [`Warning::NeglectedLift`] for a rolled step with one-way coupling,
    /// - [`Warning::NeglectedTraction`] for one-way coupling in the scalar model.
    ///
    /// Only [`History::normal`](crate::History::normal) returns the other warnings, for example about spots too small
    /// to resolve.
    #[must_use]
    pub fn warnings(&self) -> Vec<Warning> {
        self.remarks.warnings()
    }
}

fn solved(report: &Report) -> Option<&Report> {
    (report.status != Status::Unsolved).then_some(report)
}
