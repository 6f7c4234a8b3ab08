//! Pressing in as many steps as a tolerance requires.

use std::ops::ControlFlow;

use crate::bodies::coupling::Coupling;
use crate::cgm::reduce;
use crate::coupled::SensitivityInput;
use crate::error::{Error, Result};
use crate::grid::field::Field;
use crate::history::step::adaptive::traction_distance;
use crate::history::step::diagnostics::GapDiagnostics;
use crate::history::{History, LoadStep, State};
use crate::memory::fallible::{TryClone, try_each};
use crate::normal::NormalControl;
use crate::parallel::layout::Layout;
use crate::report::Iteration;

/// Largest number of steps of a load.
const MOST_STEPS: usize = 1024;

impl History {
    /// Takes a load in as many steps as a tolerance requires and returns their number. The contact grows by equal amounts in
    /// these steps.
    ///
    /// Use this method to press dissimilar bodies, because their stick and slip zones depend on how the contact grows
    /// ([dissimilar bodies](crate::guide::load_steps#load-steps-of-dissimilar-bodies)). The history takes the load in 1, 2, 4, 8,
    /// ... steps, always from its present state. After each attempt it compares the tractions with the tractions of the previous
    /// attempt. It stops when they differ by at most the tolerance.
    /// [`StepErrorEstimate::traction`](crate::history::StepErrorEstimate::traction) defines this difference. The tolerance lies
    /// in `(0, 1)`, and 0.01 is a good choice.
    ///
    /// The error of the tractions decreases with an order between 1 and 1.5. The error of the steps taken was at most 0.9
    /// of the tolerance with two steps, and at most 0.75 of the tolerance with four or more
    /// ([measurements](crate::guide::load_steps#load-steps-of-dissimilar-bodies)). These ratios are estimates, not bounds.
    /// The stick ratio has a first-order error
    /// ([table](crate::guide::load_steps#load-steps-of-dissimilar-bodies)).
    ///
    /// Between its initial and final values, a normal force grows as the cube of a length that increases in equal
    /// steps. An approach beyond the first touch grows as the square of such a length. On a sphere this length is the
    /// contact radius. All other prescribed quantities change in proportion to the normal load, as in
    /// [`AdaptiveSteps`](crate::history::AdaptiveSteps).
    ///
    /// For a load of n steps the history solves 2n - 1 steps. One step is exact for bodies without coupling, for a contact that
    /// does not grow (a flat punch) and for a contact without friction. The call then ends at two steps.
    ///
    /// A tolerance below about a hundred times the tolerance of the [settings](History::settings) cannot be met. The
    /// call allocates the memory of one state.
    ///
    /// ```
    /// use stickslip::{analytical::SpencePressing, *};
    /// let grid = Grid::square(32, 0.30e-3)?;
    /// let (aluminium, steel) = (Material::new(70e9, 0.33)?, Material::new(210e9, 0.3)?);
    /// let bodies = HalfSpace::new(grid, ElasticPair::new(aluminium, steel)?)?;
    /// let ball = surface::sphere(grid, 3.5e-3)?;
    /// let mut history = History::builder(&bodies, &ball, Friction::coulomb(0.1)?).build()?;
    ///
    /// let load = LoadStep::hold().normal(NormalControl::Force(60.0));
    /// let steps = history.press(&load, 0.03)?;
    /// let exact = SpencePressing::round(bodies.pair(), 0.1)?.stick_radius();
    /// assert!(steps <= 16 && (history.last_step()?.stick_ratio().sqrt() - exact).abs() < 0.05);
    /// assert!(!history.last_step()?.warnings().contains(&Warning::SingleLoadStep));
    /// # Ok::<(), Error>(())
    /// ```
    ///
    /// # Errors
    /// - [`Error::Tolerance`] for a tolerance outside `(0, 1)`.
    /// - [`Error::UnsupportedByModel`] for a load that rolls.
    /// - [`Error::StepTooLong`] if 1024 steps are too few.
    /// - [`Error::Memory`] if memory runs out.
    /// - Errors of [`History::step`] for the load or one of the steps.
    ///
    /// After an error the state is bitwise unchanged. If the call has undone steps, the history has no [last
    /// step](History::last_step), as after [`History::set_state`].
    ///
    /// # Model
    /// The scalar model with one-way coupling omits the tractions across its axis. The stick radius of a pressed ball is then
    /// too large, in the following cases by factors of 1.1 to 11:
    ///
    /// | $`\beta`$ | $`\mu`$ | stick radius over contact radius | exact ([`SpencePressing`](crate::analytical::SpencePressing)) |
    /// |---|---|---|---|
    /// | 0.5 | 0.3 | 0.833 | 0.627 |
    /// | 0.5 | 0.1 | 0.295 | 0.027 |
    /// | 0.115 | 0.1 | 0.950 | 0.850 |
    /// | 0.115 | 0.05 | 0.718 | 0.375 |
    /// | 0.155 | 0.05 | 0.591 | 0.177 |
    ///
    /// Use the vector model.
    ///
    /// # Slip and energy
    /// The [last step](History::last_step) is the last of the steps taken, with the slip and energy of this step alone.
    /// [`History::press_steps_observed`] calls an observer after each step taken. [`History::accumulated_slip`] and
    /// [`History::accumulated_dissipation`] include all steps: subtract their values before the call for the wear of the load.
    /// The error of the energy can be many times the tolerance ([measured](crate::guide::accuracy#energies-of-adaptive-steps)).
    pub fn press(&mut self, load: &LoadStep, tolerance: f64) -> Result<usize> {
        self.press_observed(load, tolerance, |_| ControlFlow::Continue(()))
    }

    /// Takes a load as [`History::press`] does, with an observer that receives every iteration of every step and may cancel
    /// the call.
    ///
    /// # Errors
    /// - Errors of [`History::press`].
    /// - [`Error::NotConverged`] with the status [`Status::Cancelled`](crate::Status::Cancelled) if the observer
    ///   cancels. The state is then bitwise unchanged.
    pub fn press_observed(
        &mut self,
        load: &LoadStep,
        tolerance: f64,
        mut observer: impl FnMut(&Iteration) -> ControlFlow<()> + Send,
    ) -> Result<usize> {
        self.press_with(load, tolerance, &mut observer, |_, _, _, _| Ok(()))
    }

    /// Takes a load as [`History::press`] does, with two observers. The first observer receives every iteration of every step, as
    /// that of [`History::press_observed`]. The second receives the history after each step of the accepted attempt, and can, for
    /// example, [add](crate::history::Cycle::add) the step to a cycle. If the call returns an error, all observed steps have been
    /// undone.
    ///
    /// The number of steps is known only after they have been taken. The history therefore takes the accepted steps a second time
    /// for the second observer, with bitwise identical results. For a load of n steps it solves 3n - 1 steps.
    ///
    /// ```
    /// use std::ops::ControlFlow;
    /// use stickslip::{history::Cycle, *};
    /// # let grid = Grid::square(16, 0.30e-3)?;
    /// # let (aluminium, steel) = (Material::new(70e9, 0.33)?, Material::new(210e9, 0.3)?);
    /// # let bodies = HalfSpace::new(grid, ElasticPair::new(aluminium, steel)?)?;
    /// # let ball = surface::sphere(grid, 3.5e-3)?;
    /// let mut history = History::builder(&bodies, &ball, Friction::coulomb(0.1)?).build()?;
    /// let load = LoadStep::hold().normal(NormalLoad::Force(60.0));
    /// let mut cycle = Cycle::new(&history);
    /// let unobserved = |_: &Iteration| ControlFlow::Continue(());
    /// let steps = history.press_steps_observed(&load, 0.05, unobserved, |history| cycle.add(history))?;
    /// assert_eq!(cycle.steps(), steps);
    /// assert!(cycle.energy().dissipated_energy > history.last_step()?.energy().dissipated_energy);
    /// # Ok::<(), Error>(())
    /// ```
    ///
    /// # Errors
    /// - Errors of [`History::press_observed`].
    /// - Errors of the second observer.
    pub fn press_steps_observed(
        &mut self,
        load: &LoadStep,
        tolerance: f64,
        mut observer: impl FnMut(&Iteration) -> ControlFlow<()> + Send,
        mut after_step: impl FnMut(&History) -> Result<()>,
    ) -> Result<usize> {
        self.press_with(
            load,
            tolerance,
            &mut observer,
            |ramp, history, steps, observer| ramp.show(history, steps, observer, &mut after_step),
        )
    }

    /// Takes a load as [`History::press`] does, then calls `show` with the accepted number of steps.
    fn press_with<O: FnMut(&Iteration) -> ControlFlow<()> + Send>(
        &mut self,
        load: &LoadStep,
        tolerance: f64,
        observer: &mut O,
        show: impl FnOnce(&LoadRamp<'_>, &mut Self, usize, &mut O) -> Result<()>,
    ) -> Result<usize> {
        let checked = load.check_still().and_then(|()| {
            let is_valid = tolerance > 0.0 && tolerance < 1.0;
            is_valid.then_some(()).ok_or(Error::Tolerance(tolerance))
        });
        self.bodies.collective_result_checked(
            checked,
            &[("load", load), ("tolerance of pressing", &tolerance)],
        )?;
        let mut pressing = LoadRamp {
            load,
            course: NormalLoadRange::of(load, self),
            start: self.state().try_clone()?,
            coarse: try_each(|axis| self.traction()[axis].try_clone())?,
        };
        let outcome = pressing.refine(self, tolerance, observer);
        let outcome = outcome.and_then(|steps| {
            show(&pressing, self, steps, observer)?;
            Ok(steps)
        });
        if outcome.is_err() {
            self.go_back(&mut pressing.start)?;
        }
        outcome
    }
}

/// Load that is taken in an increasing number of steps.
struct LoadRamp<'a> {
    load: &'a LoadStep,
    course: NormalLoadRange,
    start: State,
    /// Tractions after the load in half as many steps.
    coarse: [Field; 2],
}

impl LoadRamp<'_> {
    /// Doubles the number of steps of the load until the tractions of two attempts differ by at most the tolerance.
    fn refine(
        &mut self,
        history: &mut History,
        tolerance: f64,
        observer: &mut (impl FnMut(&Iteration) -> ControlFlow<()> + Send),
    ) -> Result<usize> {
        let mut steps = 1;
        self.take(history, steps, observer)?;
        loop {
            for (coarse, traction) in self.coarse.iter_mut().zip(history.traction()) {
                coarse.clone_from(traction);
            }
            steps *= 2;
            history.set_state(&self.start)?;
            self.take(history, steps, observer)?;
            let error = traction_distance(history, self.coarse.each_ref());
            if error <= tolerance {
                // The difference replaces the criterion for the growth of the contact.
                history.step.remarks.is_pressed_at_once = false;
                return Ok(steps);
            }
            if steps >= MOST_STEPS {
                return Err(Error::StepTooLong {
                    part: 1.0 / steps as f64,
                    error,
                    tolerance,
                });
            }
        }
    }

    /// Takes the load in `steps` steps again, and calls a function after each step.
    fn show(
        &self,
        history: &mut History,
        steps: usize,
        observer: &mut (impl FnMut(&Iteration) -> ControlFlow<()> + Send),
        after_step: &mut impl FnMut(&History) -> Result<()>,
    ) -> Result<()> {
        history.set_state(&self.start)?;
        let mut change = GapDiagnostics::default();
        for step in 1..=steps {
            let part = self.course.part(step as f64 / steps as f64);
            history.step_observed(&self.load.part(&self.start, part), &mut *observer)?;
            history.step.remarks.is_pressed_at_once = false;
            change = change.max(history.step.remarks.gap_change);
            history.bodies.run_collectively(|| after_step(history))?;
        }
        history.step.remarks.gap_change = change;
        Ok(())
    }

    /// Takes the load in `steps` steps. The diagnostics of the last step then contain a change of the gap before the first step.
    fn take(
        &self,
        history: &mut History,
        steps: usize,
        observer: &mut (impl FnMut(&Iteration) -> ControlFlow<()> + Send),
    ) -> Result<()> {
        let mut change = GapDiagnostics::default();
        for step in 1..=steps {
            let part = self.course.part(step as f64 / steps as f64);
            history.step_observed(&self.load.part(&self.start, part), &mut *observer)?;
            change = change.max(history.step.remarks.gap_change);
        }
        history.step.remarks.gap_change = change;
        Ok(())
    }
}

/// Variation of the normal load between its initial and final values.
#[derive(Debug, Clone, Copy)]
enum NormalLoadRange {
    /// Load proportional to the number of the step.
    Linear,
    /// Power of a length that grows in equal steps.
    Power {
        exponent: i32,
        /// Normal load at length zero.
        origin: f64,
        /// Normal loads at both ends.
        ends: [f64; 2],
        /// Lengths at both ends.
        lengths: [f64; 2],
    },
}

impl NormalLoadRange {
    fn of(load: &LoadStep, history: &History) -> Self {
        let (state, layout) = (history.state(), history.bodies.grid_layout());
        let (exponent, origin, ends) = match load.normal_control() {
            NormalControl::Hold => return Self::Linear,
            NormalControl::Force(end) => (3, 0.0, [state.normal().force(), end]),
            NormalControl::Approach(end) => {
                let gap = state.unloaded_gap().as_slice();
                let touch = reduce::least(&layout, |i| Some((gap[i], i)));
                let touch = touch.map_or(0.0, |(touch, _)| touch);
                (2, touch, [state.approach(), end])
            }
        };
        let lengths = ends.map(|end| (end - origin).max(0.0).powf(1.0 / f64::from(exponent)));
        if ends[1] - ends[0] == 0.0 || lengths[1] - lengths[0] == 0.0 {
            return Self::Linear;
        }
        Self::Power {
            exponent,
            origin,
            ends,
            lengths,
        }
    }

    /// Returns the fraction of the load that is reached after a fraction of the steps.
    fn part(self, steps: f64) -> f64 {
        match self {
            Self::Power {
                exponent,
                origin,
                ends: [start, end],
                lengths: [first, last],
            } if steps < 1.0 => {
                let length = first + steps * (last - first);
                (origin + length.powi(exponent) - start) / (end - start)
            }
            _ => steps,
        }
    }
}

impl State {
    /// Returns whether the contact of dissimilar bodies grew too much in a step that started with this pressure.
    pub(in crate::history) fn has_grown_at_once(&self, before: &Field, layout: &Layout) -> bool {
        let growth = SensitivityInput {
            gap: self.pressed_gap.as_slice(),
            before: Some(before.as_slice()),
            pressure: self.pressure().as_slice(),
            traction: self.traction().map(Field::as_slice),
        };
        let is_drawn = self.pair().is_coupled() && self.coupling != Coupling::Neglected;
        is_drawn && growth.is_at_once(layout)
    }
}
