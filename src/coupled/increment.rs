//! One step of a coupled contact, in a problem from rest or in a history.

use crate::bodies::component::Direction;
use crate::cgm::cone::ConeStart;
use crate::cgm::{Total, reduce};
use crate::contact::{self, PassOutcome, SolveContext, WindowEngine, Windows, multipliers};
use crate::coupled::window_solver::{CoupledEngine, CoupledRequest};
use crate::coupled::{CoupledReport, N};
use crate::error::{Error, Result, SLIDE};
use crate::grid::field::Field;
use crate::grid::window::Window;
use crate::half_space::HalfSpace;
use crate::memory::fallible;
use crate::normal::{GapChange, Hardness, LastGap, NormalLoad, NormalSolution};
use crate::numerics::cell_vector::slices;
use crate::parallel;
use crate::report::Report;
use crate::tangential::{
    Axis, Friction, Offsets, PressureOnWindow, RelativeDisplacement, RigidMotion, StepSolution,
    TangentialTarget, centre, entry_compliance,
};

/// Margin of the window for the growth of the contact in a step, in cells.
const GROWTH: usize = 2;

/// Pressure and traction on the grid, the memory of the cells, and the solver of a step.
///
/// A step finds pressures $`p`$, tractions $`q`$, an approach and a motion $`\delta_t`$ of body 2. The slip of the step
/// is $`s = u_t - S - \delta_t`$. The offset $`S`$ of a cell is its value of $`u_t - \delta_t`$ during stick. It is
/// zero if the step starts from rest. A history sets the offset.
#[derive(Debug, Clone)]
pub(crate) struct CoupledIncrement {
    pub(super) bodies: HalfSpace,
    windows: Windows<CoupledEngine>,
    /// Pressure and tractions of the whole grid, which are the start of the next step and the solution of the last
    /// step.
    pub(super) tractions: [Vec<f64>; N],
    displacement: [Vec<f64>; N],
    pub(crate) pressed: PressureOnWindow,
    /// Offsets of the cells, and the entry compliances $`\kappa g`$ under a unit pressure before the solve. A solve
    /// replaces them by the entry compliances under its pressure.
    pub(crate) offsets: Offsets,
    pub(super) linear: [Vec<f64>; N],
    motion: RigidMotion,
    /// Shift of the state from which the step starts.
    pub(super) last_shift: [f64; 2],
    pub(super) approach: f64,
    /// Gap of the last solve, which only a solver keeps. A history has its own.
    pub(super) last_gap: Option<LastGap>,
    report: CoupledReport,
}

/// Load and input of a coupled step.
#[derive(Debug, Clone, Copy)]
pub(crate) struct CoupledTarget<'a> {
    /// Gap before loading.
    pub(crate) gap: &'a Field,
    pub(crate) friction: &'a Friction,
    /// Limit of the pressure, if any.
    pub(crate) hardness: Option<&'a Hardness>,
    /// Prescribed force or approach.
    pub(crate) normal: NormalLoad,
    pub(crate) tangential: TangentialTarget,
}

/// Returns an error if the bodies lack an operator for a coupled solve.
pub(crate) fn check_joint(bodies: &HalfSpace) -> Result<()> {
    let [x, y, z] = [Direction::X, Direction::Y, Direction::Z];
    bodies.check_directions([z, x, y], false)?;
    bodies.check_directions([z], true)?;
    bodies.check_directions([x, y], true)
}

impl CoupledTarget<'_> {
    /// Returns whether the force might exceed the friction capacity, which depends on the distribution of the pressure.
    fn is_doubtful(&self) -> bool {
        let [x, y] = self.tangential.force();
        let is_known =
            matches!(self.normal, NormalLoad::Force(_)) && self.friction.is_proportional();
        (x != 0.0 || y != 0.0) && !is_known
    }
}

impl CoupledIncrement {
    /// Sets the offsets of a step from rest with a relative displacement of the bodies.
    pub(super) fn set_relative_displacement(&mut self, relative: &RelativeDisplacement) {
        let Self {
            offsets, pressed, ..
        } = self;
        offsets.reset();
        offsets.displace(&pressed.region, |axis, cell| relative.at(axis, cell));
    }

    /// Creates a step without traction.
    pub(crate) fn new(bodies: &HalfSpace) -> Result<Self> {
        let (grid, size) = (bodies.grid(), bodies.grid().whole().size());
        // An error of the coefficients is returned here rather than by the first solve.
        bodies.compliance([Direction::Z, Direction::X, Direction::Y], size)?;
        let zeros_of_all = || fallible::vector(grid.cells());
        Ok(Self {
            windows: Windows::default(),
            tractions: zeros_of_all()?,
            displacement: zeros_of_all()?,
            pressed: PressureOnWindow::new(bodies, Window::whole(grid))?,
            offsets: Offsets::new(Axis::BOTH, grid.cells())?,
            linear: zeros_of_all()?,
            motion: RigidMotion::default(),
            last_shift: [0.0; 2],
            approach: 0.0,
            last_gap: None,
            report: CoupledReport::unsolved(),
            bodies: bodies.clone(),
        })
    }

    /// Returns the report of the last step.
    pub(crate) fn report(&self) -> &Report {
        &self.report.work
    }

    pub(crate) fn report_mut(&mut self) -> &mut Report {
        &mut self.report.work
    }

    /// Returns the report of the last step with the certificates of its halves.
    pub(super) fn full_report(&self) -> &CoupledReport {
        &self.report
    }

    /// Returns the displacements of the last solution along z, x and y.
    pub(super) fn displacement(&self) -> [&[f64]; N] {
        self.displacement.each_ref().map(Vec::as_slice)
    }

    /// Returns the window of the solver, or `None` before the first contact.
    pub(crate) fn window(&self) -> Option<Window> {
        self.windows.window()
    }

    /// Restores the solver after a step that ended on this window.
    pub(crate) fn resume(&mut self, window: Option<Window>) -> Result<()> {
        self.windows.resume(&self.bodies, window)
    }

    /// Sets pressure and tractions as the start of the next step, with their approach and shift.
    pub(crate) fn set_start(
        &mut self,
        pressure: &Field,
        traction: [&Field; 2],
        approach: f64,
        shift: [f64; 2],
    ) {
        (self.approach, self.last_shift) = (approach, shift);
        let fields = [pressure, traction[0], traction[1]];
        for (x, field) in self.tractions.iter_mut().zip(fields) {
            x.copy_from_slice(field.as_slice());
        }
    }

    /// Returns the solution of the last step.
    pub(crate) fn answer(&self) -> StepSolution<'_> {
        let [_, ux, uy] = self.displacement();
        let traction: [&[f64]; 2] = [&self.tractions[1], &self.tractions[2]];
        let found = [traction, [ux, uy]];
        StepSolution::new(&self.pressed, &self.offsets, found, self.motion)
    }

    /// Returns the [wear](LastGap::take_wear) of this gap since the last solve.
    pub(super) fn take_wear(&mut self, gap: &Field) -> GapChange {
        let last = (&self.tractions[0][..], self.approach);
        let last_gap = self.last_gap.as_mut();
        last_gap.map_or_else(GapChange::default, |kept| {
            kept.take_wear(&self.bodies, gap, Some(last))
        })
    }

    /// Writes this wear to the solution of the solve with this gap.
    pub(super) fn finish_gap(
        &mut self,
        gap: &Field,
        wear: GapChange,
        solution: &mut NormalSolution,
    ) {
        if let Some(last_gap) = &mut self.last_gap {
            last_gap.finish((&self.bodies, gap), wear, solution);
        }
    }

    /// Writes the normal solution of the last step for this gap before loading and this hardness.
    pub(crate) fn write(
        &self,
        initial: &Field,
        hardness: Option<&Hardness>,
        normal: &mut NormalSolution,
    ) {
        parallel::copy(&self.tractions[0], normal.pressure_mut());
        normal.fill(
            &self.bodies,
            initial,
            &self.displacement[0],
            self.approach,
            self.report(),
        );
        normal.set_coupled(self.bodies.pair().is_coupled());
        normal.compare_with(&self.bodies, hardness);
    }

    /// Discards the solution, so that the next step starts from scratch.
    pub(super) fn forget(&mut self) {
        for part in &mut self.tractions {
            part.fill(0.0);
        }
        (self.approach, self.last_shift) = (0.0, [0.0; 2]);
    }

    /// Computes pressure, tractions and the motion of body 2 at the end of a step. `before` is the motion at the start
    /// of the step.
    ///
    /// # Errors
    /// - [`Error::NotConverged`] if a limit is reached. The last iterate and its motion remain available.
    /// - Errors of the load, before any work.
    pub(crate) fn solve(
        &mut self,
        demand: CoupledTarget<'_>,
        before: RigidMotion,
        conditions: &mut SolveContext<'_, '_>,
    ) -> Result<()> {
        self.report.clear();
        self.windows.tick();
        let (datum, pressure) = demand.normal.to_datum_and_total(&self.bodies, demand.gap);
        let is_apart = match demand.normal {
            NormalLoad::Force(force) => force <= 0.0,
            NormalLoad::Approach(_) => datum <= self.bodies.least(demand.gap),
        };
        if is_apart {
            self.motion = demand.tangential.without_contact(Axis::BOTH, before)?;
            self.approach = datum;
            for part in self.tractions.iter_mut().chain(&mut self.displacement) {
                part.fill(0.0);
            }
            self.report.apart();
            self.finish(demand.friction);
            return Ok(());
        }
        self.motion = RigidMotion {
            twist: demand.tangential.twist,
            ..before
        };
        let largest_coefficient = demand.friction.largest_coefficient(&self.bodies);
        let [x, y] = self.compute_totals(&demand, largest_coefficient)?;
        let totals = [pressure, x, y];
        let start = if self.contact().is_some() {
            ConeStart::Present
        } else if self.start_from_coarser(demand, before, conditions)? {
            ConeStart::Coarse
        } else {
            ConeStart::Halves
        };
        self.set_linear(demand.gap, datum);
        let RigidMotion { shift: [x, y], .. } = self.motion;
        let [last_x, last_y] = self.last_shift;
        let known = [self.approach - datum, last_x - x, last_y - y];
        let task = CoupledRequest {
            demand,
            datum,
            totals,
            multiplier: multipliers(totals, known),
            largest_coefficient,
            is_doubtful: demand.is_doubtful(),
        };
        let outcome = if task.is_doubtful {
            self.solve_or_slide(task, start, conditions)
        } else {
            self.solve_on_window(task, start, conditions)
        };
        self.report.work.time = conditions.start.elapsed();
        let [approach, x, y] = self
            .windows
            .present
            .as_ref()
            .map_or([0.0; N], CoupledEngine::multiplier);
        self.approach = datum + approach;
        self.motion.shift = [self.motion.shift[0] + x, self.motion.shift[1] + y];
        self.finish(demand.friction);
        outcome
    }

    /// Computes the friction limits, the offsets and the entry compliances under the pressure of the solution.
    fn finish(&mut self, friction: &Friction) {
        let [pressure, qx, qy] = &self.tractions;
        self.pressed.set(pressure, friction);
        let lag = |i: usize, of: &dyn Fn([f64; 2]) -> [f64; 2]| {
            if pressure[i] > 0.0 {
                of([qx[i], qy[i]])
            } else {
                [0.0; 2]
            }
        };
        self.offsets
            .subtract_lag(|i, entry| lag(i, &|q| q.map(|q| entry.mean[i] * q / pressure[i])));
        self.offsets.subtract_lag(|i, entry| {
            let [a, b] = entry.deviator.get(i).copied().unwrap_or_default();
            lag(i, &|q| {
                let [x, y] = q.map(|q| q / pressure[i]);
                [a * x + b * y, b * x - a * y]
            })
        });
        for (mean, pressure) in self.offsets.entry.mean.iter_mut().zip(pressure) {
            *mean = entry_compliance(*mean, *pressure);
        }
    }

    /// Returns the window around the pressure.
    fn contact(&self) -> Option<Window> {
        self.bodies.around(|i| self.tractions[0][i] > 0.0)
    }

    /// Solves on the window of the contact and checks the whole grid. If bodies overlap outside the window, the solve
    /// continues on a larger window.
    pub(super) fn solve_on_window(
        &mut self,
        mut task: CoupledRequest<'_>,
        mut start: ConeStart,
        conditions: &mut SolveContext<'_, '_>,
    ) -> Result<()> {
        let grid = self.bodies.grid();
        let contact = self.contact().unwrap_or(Window::whole(grid));
        // A margin for a small growth of the contact is cheaper than a second solve.
        let grown = contact.with_margins(grid, [GROWTH; 2]);
        let (bodies, total) = (&self.bodies, task.totals[0]);
        let holds = |window: Window| {
            let hardness = task.demand.hardness;
            hardness.is_none_or(|hardness| hardness.holds(bodies, window, total))
        };
        let fits = |window: Window| window.covers(grown) && holds(window);
        if !self.window().is_some_and(fits) {
            let mut window = contact.widened(grid);
            while !holds(window) {
                window = window.widened(grid);
            }
            self.windows.set_window(bodies, window)?;
        }
        let (linear, tractions) = (&self.linear, &mut self.tractions);
        let (displacement, report) = (&mut self.displacement, &mut self.report);
        let entry = &self.offsets.entry;
        let asked = (slices(linear), entry.is_active.then(|| entry.cells()));
        self.windows.solve(bodies, |engine, _| {
            engine.take(tractions);
            let outcome = engine.solve(asked, task, start, conditions, report);
            engine.write(tractions, displacement);
            outcome?;
            (start, task.multiplier) = (ConeStart::Present, engine.multiplier());
            let ([lift, ..], [gap, ..], [delta, ..]) = (&*displacement, linear, task.multiplier);
            let largest = reduce::max(&bodies.grid_layout(), |i| lift[i].abs());
            let overlaps = |i: usize| lift[i] + gap[i] - delta;
            let missed = contact::overlap_outside(bodies, engine.window(), largest, overlaps);
            Ok(missed.map_or(PassOutcome::Accepted, PassOutcome::OverlapOutside))
        })
    }

    /// Converts the load to totals of the tractions and sets the datum of the motion.
    fn compute_totals(
        &mut self,
        demand: &CoupledTarget<'_>,
        largest_coefficient: f64,
    ) -> Result<[Total; 2]> {
        if let NormalLoad::Force(force) = demand.normal {
            check_force(demand, largest_coefficient * force)?;
        }
        let cell_area = self.bodies.grid().cell_area();
        let sums = demand.tangential.force().map(|force| force / cell_area);
        let (tangential, measured) = (demand.tangential, (self.motion.shift, cell_area));
        tangential.compute_totals(Axis::BOTH, Some(sums), measured, &mut self.motion)
    }

    /// Sets the linear term so that every cell closes its gap and follows the motion of body 2 from its offset.
    pub(super) fn set_linear(&mut self, gap: &Field, datum: f64) {
        let grid = self.bodies.grid();
        let [z, x, y] = &mut self.linear;
        for (i, gap) in gap.as_slice().iter().enumerate() {
            let moved = self.motion.at(centre(grid, i));
            z[i] = gap - datum;
            x[i] = 0.0 - (self.offsets.cells[0][i] + moved[0]);
            y[i] = 0.0 - (self.offsets.cells[1][i] + moved[1]);
        }
    }
}

/// Returns an error if friction cannot carry the force for any distribution of the pressure.
fn check_force(demand: &CoupledTarget<'_>, limit: f64) -> Result<()> {
    let [x, y] = demand.tangential.force();
    let force = x.hypot(y);
    if force >= limit && force > 0.0 {
        return Err(Error::BeyondFrictionCapacity {
            force,
            limit,
            remedy: SLIDE,
        });
    }
    Ok(())
}
