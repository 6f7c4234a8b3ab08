//! Results accumulated over the steps of a cycle.

use crate::bodies::material::ElasticPair;
use crate::cgm::reduce;
#[cfg(feature = "serde")]
use crate::error::positive;
use crate::error::{Error, Result};
use crate::grid::boundary::Boundary;
use crate::grid::field::Field;
use crate::grid::record::checked_struct;
use crate::half_space::HalfSpace;
use crate::history::cycle::hysteresis::{LoopPoint, half_range, part_of};
use crate::history::state::mark::StateMark;
use crate::history::state::motion_range::MotionRange;
use crate::history::step::diagnostics::StepDiagnostics;
use crate::history::{EnergyBalance, History};
use crate::memory::fallible::unwrap_or_abort;
use crate::numerics::cell_vector::norm;
use crate::parallel::{self, Blocks, CHUNK, blocks};
use crate::support::debug::shown;
use crate::tangential::RigidMotion;

pub(super) mod fretting_loop;
pub(super) mod hysteresis;

checked_struct! {
    /// Slip, energy and the loop of force and shift, accumulated over the steps of a cycle.
    ///
    /// A cycle starts at the present state of a history. Call [`add`](Self::add) once after each step, and
    /// [`begin`](Self::begin) before each further cycle. Without `begin`, energies and slip distances are sums over all cycles. A
    /// [`FrettingLoop`](crate::history::FrettingLoop) makes these calls itself.
    ///
    /// The first cycle from rest usually does not close. Its work then contains a change of the elastic energy.
    /// [`cyclic_residual`](Self::cyclic_residual) measures the distance from a closed cycle. A cycle whose loads turn back has the
    /// warning [`OpenCycle`](crate::Warning::OpenCycle) if it is far from closed.
    ///
    /// # Memory
    /// A cycle stores nine numbers per cell. A new cycle allocates memory only if it has more steps than every earlier cycle.
    ///
    /// # Distributed bodies
    /// On [distributed](crate::HalfSpace::distributed) bodies [begin](Self::begin) and [add](Self::add) are collective.
    /// Each rank then has the scalar results of the whole contact and the fields of its local cells. Reading them needs no further
    /// messages.
    ///
    /// # Examples
    ///
    /// ```
    /// use stickslip::history::{Cycle, LoadPath, Regime};
    /// use stickslip::*;
    /// let grid = Grid::square(48, 0.30e-3)?;
    /// let steel = Material::new(213e9, 0.29)?;
    /// let bodies = HalfSpace::new(grid, ElasticPair::new(steel, steel)?)?;
    /// let ball = surface::sphere(grid, 3.5e-3)?;
    /// let mut history = History::builder(&bodies, &ball, Friction::coulomb(0.5)?).build()?;
    /// history.step(&LoadStep::hold().normal(NormalLoad::Force(100.0)))?;
    ///
    /// let path = LoadPath::sine([40.0, 0.0], 16)?;
    /// let mut cycle = Cycle::new(&history);
    /// for _ in 0..2 {
    ///     cycle.begin(&history)?;
    ///     for &force in path.steps() {
    ///         history.step(&LoadStep::force(force))?;
    ///         cycle.add(&history)?;
    ///     }
    /// }
    /// assert_eq!(cycle.regime()?, Regime::PartialSlip);
    /// assert!((cycle.force_amplitude()[0] / 40.0 - 1.0).abs() < 1e-12);
    /// // The second cycle ends as it started, and all its work is dissipated.
    /// assert!(cycle.cyclic_residual()? < 1e-6);
    /// let energy = cycle.energy();
    /// assert!((energy.work / energy.dissipated_energy_midpoint - 1.0).abs() < 1e-6);
    /// # Ok::<(), Error>(())
    /// ```
    #[derive(Clone, PartialEq)]
    pub struct Cycle {
        sums: CycleSums,
        /// Largest magnitude of a traction in the cycle.
        largest_traction: f64,
        /// Largest magnitude of a change of traction since the start of the cycle.
        traction_change: f64,
        energy: EnergyBalance,
        points: Vec<LoopPoint>,
        stick_ratios: [f64; 2],
        regime: Regime,
        pub(super) remarks: StepDiagnostics,
        #[cfg_attr(feature = "serde", serde(default))]
        motion_range: MotionRange,
        /// State after the last step in the cycle, or the state at its start.
        last: StateMark,
        pair: ElasticPair,
        boundary: Boundary,
    }
    #[serde(remote = "Cycle")]
    check(read) {
        let grid = read.sums.slip_distance.grid();
        for field in read.sums.fields() {
            field.check("field of the cycle", grid)?;
        }
        positive("points of the cycle", read.points.len() as f64).map(|_| ())
    }
}

shown!(Cycle: steps(), regime(), stick_ratios(), energy);

/// Sums and ranges in every cell over the steps of a cycle.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
struct CycleSums {
    slip_distance: Field,
    slip_pressure: Field,
    dissipated_energy: Field,
    slip_amplitude: [Field; 2],
    /// Least slip since the start of the history, the lower end of the range of the slip.
    least_slip: [Field; 2],
    first_traction: [Field; 2],
}

#[cfg(feature = "serde")]
impl CycleSums {
    fn fields(&self) -> impl Iterator<Item = &Field> {
        let scalars = [
            &self.slip_distance,
            &self.slip_pressure,
            &self.dissipated_energy,
        ];
        let vectors = [&self.slip_amplitude, &self.least_slip, &self.first_traction];
        scalars.into_iter().chain(vectors.into_iter().flatten())
    }
}

impl Cycle {
    /// Creates a cycle without steps that starts at the present state of the history.
    #[must_use]
    pub fn new(history: &History) -> Self {
        unwrap_or_abort(Self::try_new(history))
    }

    /// Creates a cycle like [`Self::new`], but returns an error if memory runs out.
    ///
    /// # Errors
    /// - [`Error::Memory`] if memory runs out.
    pub fn try_new(history: &History) -> Result<Self> {
        let zeros = || Field::try_zeros(history.grid());
        let mut cycle = Self {
            sums: CycleSums {
                slip_distance: zeros()?,
                slip_pressure: zeros()?,
                dissipated_energy: zeros()?,
                slip_amplitude: [zeros()?, zeros()?],
                least_slip: [zeros()?, zeros()?],
                first_traction: [zeros()?, zeros()?],
            },
            largest_traction: 0.0,
            traction_change: 0.0,
            energy: EnergyBalance::default(),
            points: Vec::new(),
            stick_ratios: [1.0, 0.0],
            regime: Regime::FullStick,
            remarks: StepDiagnostics::default(),
            motion_range: MotionRange::default(),
            last: StateMark::of(history.state()),
            pair: *history.bodies.pair(),
            boundary: history.bodies.boundary(),
        };
        cycle.restart(history);
        Ok(cycle)
    }

    /// Removes all steps and restarts the cycle at the present state of the history.
    ///
    /// # Errors
    /// - [`Error::GridMismatch`] if the grid of the history differs.
    /// - [`Error::BoundaryMismatch`] if its boundary condition differs.
    /// - [`Error::MaterialMismatch`] if its materials differ.
    /// - [`Error::Ranks`] if ranks fail.
    ///
    /// The cycle is unchanged after an error.
    pub fn begin(&mut self, history: &History) -> Result<()> {
        history.bodies.collective_result(self.check(history))?;
        self.restart(history);
        Ok(())
    }

    fn restart(&mut self, history: &History) {
        let sums = [
            &mut self.sums.slip_distance,
            &mut self.sums.slip_pressure,
            &mut self.sums.dissipated_energy,
        ];
        for sum in sums.into_iter().chain(&mut self.sums.slip_amplitude) {
            sum.as_mut_slice().fill(0.0);
        }
        let slips = self.sums.least_slip.iter_mut().zip(history.slip());
        let tractions = self.sums.first_traction.iter_mut().zip(history.traction());
        for (first, of_history) in slips.chain(tractions) {
            first.as_mut_slice().copy_from_slice(of_history.as_slice());
        }
        (self.largest_traction, self.traction_change) = (0.0, 0.0);
        self.energy = EnergyBalance::default();
        self.points.clear();
        self.points.push(LoopPoint::of(history.state()));
        (self.stick_ratios, self.regime) = ([1.0, 0.0], Regime::FullStick);
        self.remarks = StepDiagnostics::default();
        self.motion_range.restart();
        self.last = StateMark::of(history.state());
    }

    /// Adds the last step of the history. Call this method once after each step. Steps that are not added do not count.
    ///
    /// Add a step only after it is accepted. [`History::set_state`] does not remove an added step from the cycle. Copy the
    /// cycle before a step that may be rejected after it is added.
    ///
    /// # Errors
    /// - [`Error::GridMismatch`] if the grid of the history differs.
    /// - [`Error::BoundaryMismatch`] if its boundary condition differs.
    /// - [`Error::MaterialMismatch`] if its materials differ.
    /// - [`Error::NoLastStep`] if the history has taken no step since it was created or since [`History::set_state`].
    /// - [`Error::StepOutOfOrder`] if the last step of the history is not the step after the last added one, or after the start of
    ///   the cycle. A call that takes several steps, such as [`History::press`], adds none of them: use its observer.
    ///   The step must start from the state of that step: the number of steps, approach, shift, twist, forces and moment must
    ///   be equal, and both must belong to histories with the same gap, friction and model when they were built. After
    ///   [`History::from_bytes`], only the former numbers are compared.
    /// - [`Error::Ranks`] if ranks fail.
    ///
    /// The cycle is unchanged after an error.
    pub fn add(&mut self, history: &History) -> Result<()> {
        let (bodies, step) = (&history.bodies, &history.step);
        let continues = |start: StateMark| start.is_same(&self.last);
        let is_next = if step.start.is_some_and(continues) {
            Ok(())
        } else {
            Err(Error::StepOutOfOrder {
                step: history.steps(),
                last: self.last.steps(),
            })
        };
        let has_step = history.last_step().map(|_| ());
        bodies.collective_result(self.check(history).and(has_step).and(is_next))?;
        // The collective reductions come first, so that the cycle is unchanged if a rank fails.
        let [largest_traction, traction_change] = self.compare_traction(history);
        let regime = self.regime_with(history);
        bodies.joint(Ok(()))?;
        self.largest_traction = self.largest_traction.max(largest_traction);
        (self.traction_change, self.regime) = (traction_change, regime);
        self.last = StateMark::of(history.state());
        let sums = &mut self.sums;
        sums.slip_distance.add_scaled(1.0, step.slip_distance())?;
        let dissipated = step.dissipation();
        sums.dissipated_energy.add_scaled(1.0, dissipated)?;
        self.average_pressure(history);
        for (axis, slip) in history.slip().into_iter().enumerate() {
            widen(
                &mut self.sums.least_slip[axis],
                &mut self.sums.slip_amplitude[axis],
                slip,
            );
        }
        if self.steps() == 0 {
            self.energy = *step.energy();
        } else {
            self.energy.extend(step.energy());
        }
        let (ratio, [least, largest]) = (step.stick_ratio(), self.stick_ratios);
        self.stick_ratios = [least.min(ratio), largest.max(ratio)];
        self.remarks = self.remarks.and(step.remarks);
        self.add_motion(history);
        self.points.push(LoopPoint::of(history.state()));
        Ok(())
    }

    /// Adds the motion of the last step to its range.
    fn add_motion(&mut self, history: &History) {
        if history.step.remarks.ends_motion_range() {
            self.motion_range.restart();
            return;
        }
        let motion = |point: &LoopPoint| RigidMotion {
            shift: point.shift,
            twist: point.twist,
        };
        let from = self.points.last().map(motion);
        let to = motion(&LoopPoint::of(history.state()));
        self.motion_range.extend(from.unwrap_or(to), to);
        let [shift, twist] = self.motion_range.tenths(history.grid());
        self.remarks.shift_tenths = self.remarks.shift_tenths.max(shift);
        self.remarks.twist_tenths = self.remarks.twist_tenths.max(twist);
    }

    fn check(&self, history: &History) -> Result<()> {
        let grid = self.sums.slip_distance.grid();
        let quantity = "history of the cycle";
        grid.check_equal(quantity, history.grid())?;
        self.check_bodies(quantity, &history.bodies)
    }

    /// Returns an error if the cycle was computed for another boundary or other materials.
    pub(in crate::history) fn check_bodies(
        &self,
        quantity: &'static str,
        bodies: &HalfSpace,
    ) -> Result<()> {
        if self.boundary != bodies.boundary() {
            return Err(Error::BoundaryMismatch { quantity });
        }
        if self.pair != *bodies.pair() {
            return Err(Error::MaterialMismatch { quantity });
        }
        Ok(())
    }

    /// Returns the regime of the cycle including the last step.
    fn regime_with(&self, history: &History) -> Regime {
        let (step, layout) = (&history.step, history.bodies.grid_layout());
        let slip = step.slip_distance().as_slice();
        if step.is_gross_slip() {
            Regime::GrossSlip
        } else if self.regime == Regime::FullStick && reduce::any(&layout, |i| slip[i] > 0.0) {
            Regime::PartialSlip
        } else {
            self.regime
        }
    }

    /// Adds the step to the mean pressure, weighted by the length of slip.
    fn average_pressure(&mut self, history: &History) {
        let [pressure, slip, path] = [
            history.pressure(),
            history.step.slip_distance(),
            &self.sums.slip_distance,
        ]
        .map(Field::as_slice);
        parallel::update(self.sums.slip_pressure.as_mut_slice(), |first, chunk| {
            for (i, mean) in (first..).zip(chunk) {
                if slip[i] > 0.0 {
                    *mean += slip[i] / path[i] * (pressure[i] - *mean);
                }
            }
        });
    }

    /// Returns the largest traction and its largest change since the start of the cycle. For the first step, the largest
    /// traction includes the tractions at the start.
    fn compare_traction(&self, history: &History) -> [f64; 2] {
        let [x, y] = history.traction().map(Field::as_slice);
        let [first_x, first_y] = self.sums.first_traction.each_ref().map(Field::as_slice);
        let (layout, is_first) = (history.bodies.grid_layout(), self.steps() == 0);
        let traction = reduce::max(&layout, |i| {
            let before = is_first.then(|| norm([first_x[i], first_y[i]]));
            reduce::larger(norm([x[i], y[i]]), before.unwrap_or(0.0))
        });
        let change = reduce::max(&layout, |i| norm([x[i] - first_x[i], y[i] - first_y[i]]));
        [traction, change]
    }

    /// Returns the number of steps added.
    #[must_use]
    pub fn steps(&self) -> usize {
        self.points.len() - 1
    }

    /// Returns the length of the slip path of each cell in the cycle (lengths, non-negative).
    #[must_use]
    pub fn slip_distance(&self) -> &Field {
        &self.sums.slip_distance
    }

    /// Returns the slip pressure of each cell, the mean pressure over its slip path: $`\sum p\,|s| / \sum |s|`$. The slip
    /// pressure is zero in cells without slip.
    ///
    /// With this pressure and [`slip_distance`](Self::slip_distance), [`wear::archard`](crate::history::wear::archard)
    /// adds the sum of the depths over the steps for any variation of the pressure.
    #[must_use]
    pub fn slip_pressure(&self) -> &Field {
        &self.sums.slip_pressure
    }

    /// Returns the slip amplitude, half the range of each component of the slip of each cell (lengths, non-negative).
    #[must_use]
    pub fn slip_amplitude(&self) -> [&Field; 2] {
        self.sums.slip_amplitude.each_ref()
    }

    /// Returns the energy that each cell dissipated in the cycle, computed from its traction at the end of each step
    /// (energies). [`wear::energy`](crate::history::wear::energy) accepts this field.
    #[doc(alias = "dissipated energy")]
    #[must_use]
    pub fn dissipation(&self) -> &Field {
        &self.sums.dissipated_energy
    }

    /// Returns work, elastic energy and dissipation of the cycle. All energies of a cycle without steps are zero.
    #[must_use]
    pub fn energy(&self) -> &EnergyBalance {
        &self.energy
    }

    /// Returns the loop of force and shift: the start, and the end of each step. The loop encloses the [work of the
    /// loads](Self::work_of_loads).
    #[doc(alias = "friction loop")]
    #[doc(alias = "fretting loop")]
    #[doc(alias = "hysteresis")]
    #[must_use]
    pub fn points(&self) -> &[LoopPoint] {
        &self.points
    }

    /// Returns half the range of each component of the force, zero without steps.
    #[must_use]
    pub fn force_amplitude(&self) -> [f64; 2] {
        [0, 1].map(|axis| half_range(&self.points, |point| point.force[axis]))
    }

    /// Returns half the range of each component of the shift (lengths), zero without steps.
    #[must_use]
    pub fn shift_amplitude(&self) -> [f64; 2] {
        [0, 1].map(|axis| half_range(&self.points, |point| point.shift[axis]))
    }

    /// Returns the least and the largest stick ratio at the ends of the steps.
    ///
    /// # Errors
    /// - [`Error::EmptyPath`] if the cycle has no steps.
    pub fn stick_ratios(&self) -> Result<[f64; 2]> {
        self.check_steps()?;
        Ok(self.stick_ratios)
    }

    /// Returns the sliding regime of the cycle: full stick, partial slip or gross slip.
    ///
    /// # Errors
    /// - [`Error::EmptyPath`] if the cycle has no steps.
    #[doc(alias = "fretting map")]
    pub fn regime(&self) -> Result<Regime> {
        self.check_steps()?;
        Ok(self.regime)
    }

    /// Returns an error for a cycle without steps, for which ratios and regime are undefined.
    pub(in crate::history) fn check_steps(&self) -> Result<()> {
        if self.steps() == 0 {
            Err(Error::EmptyPath)
        } else {
            Ok(())
        }
    }

    /// Returns the deviation of the cycle from a closed loop. The deviation is the larger of two ratios. The first ratio is the
    /// largest change of a traction from start to end, divided by the largest traction in the cycle. The second ratio is the
    /// change of the shift, divided by half the range of the shift.
    ///
    /// A closed cycle repeats itself under the same loads.
    ///
    /// # Errors
    /// - [`Error::EmptyPath`] if the cycle has no steps.
    pub fn cyclic_residual(&self) -> Result<f64> {
        self.check_steps()?;
        let (first, last) = (self.points[0], self.points[self.steps()]);
        let moved = (last.shift[0] - first.shift[0]).hypot(last.shift[1] - first.shift[1]);
        let [x, y] = self.shift_amplitude();
        let of_shift = part_of(moved, x.hypot(y));
        Ok(of_shift.max(part_of(self.traction_change, self.largest_traction)))
    }

    /// Reserves memory for the points of a cycle of `steps` steps.
    pub(super) fn reserve(&mut self, steps: usize) {
        self.points.reserve(steps);
    }
}

/// Extends the range of a slip, which is stored as its least value and its amplitude.
fn widen(least: &mut Field, amplitude: &mut Field, slip: &Field) {
    let slip = slip.as_slice();
    let work = |task: usize, (least, amplitude): (Blocks<'_, f64>, Blocks<'_, f64>)| {
        let ranges = least.items.iter_mut().zip(amplitude.items);
        for (slip, (least, amplitude)) in slip[task * CHUNK..].iter().zip(ranges) {
            if slip < least {
                *amplitude += 0.5 * (*least - slip);
                *least = *slip;
            } else {
                *amplitude = amplitude.max(0.5 * (slip - *least));
            }
        }
    };
    let data = (
        blocks(least.as_mut_slice()),
        blocks(amplitude.as_mut_slice()),
    );
    parallel::sweep(0..slip.len().div_ceil(CHUNK), data, &work, &|(), ()| ());
}

/// Sliding regime of a cycle, as in the fretting maps of O. Vingsbo and S. Söderberg, Wear 126 (1988) 131,
/// <https://doi.org/10.1016/0043-1648(88)90134-2>.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub enum Regime {
    /// No cell slipped.
    FullStick,
    /// Some cells slipped, and some cells stuck at the end of each step.
    PartialSlip,
    /// The whole contact was at its friction limit at the end of a step.
    GrossSlip,
}
