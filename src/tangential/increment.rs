//! One step of a tangential contact, in a problem from rest or in a history.

use std::borrow::Cow;

use crate::bodies::coupling::Coupling;
use crate::cgm::{Total, reduce};
use crate::contact::{LoadTrend, SolveContext, multipliers};
use crate::error::{Result, has_squares};
use crate::half_space::HalfSpace;
use crate::memory::fallible;
use crate::numerics::cell_vector::slices;
use crate::parallel;
use crate::report::Report;
use crate::tangential::load::TangentialTarget;
use crate::tangential::offset::Offsets;
use crate::tangential::one_way::CouplingDisplacement;
use crate::tangential::rigid_motion::{RigidMotion, centre};
use crate::tangential::step_solution::StepSolution;
use crate::tangential::traction_solver::{
    TangentialEngine, TangentialRequest, TangentialVector, at, engine_along, zeros,
};
use crate::tangential::{Axis, PressureOnWindow, RelativeDisplacement};

/// Tangential contact on a window: pressure, limits and tractions of its cells, and the solver of a step.
///
/// A step finds tractions $`q`$ and a motion $`\delta`$ of body 2. The slip of the step is $`s = C q - S - \delta`$.
/// The offset $`S`$ of a cell is its value of $`u - \delta`$ during stick. It is zero if the step starts from rest. A
/// history sets the offset and the diagonal $`B`$ of entry compliances. With entry compliances the slip is
/// $`s = C q + B q - S - \delta`$.
#[derive(Debug, Clone)]
pub(crate) struct TangentialIncrement {
    bodies: HalfSpace,
    pub(crate) pressed: PressureOnWindow,
    engine: Box<dyn TangentialEngine>,
    /// Start of the next step and solution of the last step.
    traction: TangentialVector,
    /// Offsets and entry compliances of the cells in this step.
    pub(crate) offsets: Offsets,
    /// Linear term of the solve. A solve first overwrites the term. Between solves the vector is a scratch buffer.
    linear: TangentialVector,
    /// Operator of the tangential displacement due to pressure, if the model includes this displacement.
    drawing: Option<CouplingDisplacement>,
    /// Motion of body 2 at the end of the last step.
    motion: RigidMotion,
}

/// Start of a step.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Start {
    /// Starts from the solution on coarser cells.
    Nested,
    /// Starts from the present tractions, which were a solution at this shift.
    Present([f64; 2]),
    /// Starts from the present tractions, which are near the solution.
    Near,
}

impl TangentialIncrement {
    /// Creates a step without traction.
    pub(crate) fn new(
        bodies: &HalfSpace,
        axes: &'static [Axis],
        pressed: PressureOnWindow,
        coupling: Coupling,
    ) -> Result<Self> {
        let (size, cells) = (pressed.window().size, pressed.region.cells());
        let is_drawn = coupling.is_one_way(bodies.pair());
        let drawing = is_drawn.then(|| CouplingDisplacement::new(bodies, axes, size));
        Ok(Self {
            drawing: drawing.transpose()?,
            bodies: bodies.clone(),
            engine: engine_along(bodies, axes, size)?,
            traction: zeros(axes, cells)?,
            offsets: Offsets::new(axes, cells)?,
            linear: zeros(axes, cells)?,
            motion: RigidMotion::default(),
            pressed,
        })
    }

    pub(crate) fn axes(&self) -> &'static [Axis] {
        self.offsets.axes()
    }

    pub(crate) fn report(&self) -> &Report {
        self.engine.report()
    }

    /// Returns the motion of body 2 at the end of the last solved step, whether or not the step converged.
    pub(crate) fn motion(&self) -> RigidMotion {
        self.motion
    }

    /// Sets the present tractions from a function of axis and cell of the grid.
    pub(crate) fn set_traction(&mut self, traction: impl Fn(usize, usize) -> f64) {
        for axis in self.axes().iter().map(|axis| axis.index()) {
            let part = &mut self.traction[axis];
            self.pressed
                .region
                .collect(|cell| traction(axis, cell), part);
        }
    }

    /// Writes the present tractions, zero outside the window, to another increment.
    pub(crate) fn hand_over(&self, other: &mut Self) -> Result<()> {
        let mut whole = fallible::zeros(self.bodies.grid().cells())?;
        for axis in self.axes().iter().map(|axis| axis.index()) {
            whole.fill(0.0);
            let (from, to) = (&self.pressed.region, &other.pressed.region);
            from.scatter(&self.traction[axis], &mut whole);
            to.gather(&whole, &mut other.traction[axis]);
        }
        Ok(())
    }

    /// Extrapolates the present tractions by `parts` times a trend of the local cells.
    pub(crate) fn extrapolate(&mut self, trend: &LoadTrend<2>, parts: f64) {
        for axis in self.axes().iter().map(|axis| axis.index()) {
            let change = self.pressed.region.taken(&trend.change[axis]);
            parallel::update(&mut self.traction[axis], |first, chunk| {
                for (traction, change) in chunk.iter_mut().zip(&change[first..]) {
                    *traction += parts * change;
                }
            });
        }
    }

    /// Returns the solution of the last step.
    pub(crate) fn answer(&self) -> StepSolution<'_> {
        let found = [slices(&self.traction), self.engine.product()];
        StepSolution::new(&self.pressed, &self.offsets, found, self.motion)
    }

    /// Subtracts the surface displacement due to the growth of the pressure from the offsets, if pressure moves the
    /// surfaces. The traction of a sticking cell opposes this displacement. `before` returns the previous pressure of a
    /// cell of the grid.
    pub(crate) fn draw_from(&mut self, before: impl Fn(usize) -> f64) {
        if let Some(drawing) = &mut self.drawing {
            let buffer = &mut self.linear[self.offsets.axes()[0].index()];
            self.pressed.region.collect(before, buffer);
            let cells = self.pressed.pressure.iter().zip(buffer);
            let grown = cells.map(|(now, before)| now - *before);
            drawing.subtract(grown, &mut self.offsets.cells);
        }
    }

    /// Sets the offsets of bodies that were apart before the step. The offset is the negated sum of the displacement
    /// due to the pressure and the displacement `relative`.
    pub(crate) fn draw(&mut self, relative: Option<&RelativeDisplacement>) {
        self.offsets.reset();
        if let Some(drawing) = &mut self.drawing {
            let pressure = self.pressed.pressure.iter().copied();
            drawing.subtract(pressure, &mut self.offsets.cells);
        }
        if let Some(relative) = relative {
            let of = |axis: usize, cell: usize| relative.at(axis, cell);
            self.offsets.displace(&self.pressed.region, of);
        }
    }

    /// Returns the buffers of the solve to their pools. The displacements of the solution are lost.
    pub(crate) fn rest(&mut self) {
        self.engine.rest();
    }

    /// Recomputes the displacement under the present tractions and returns its values in the local cells of the grid.
    pub(crate) fn fresh_displacement(&mut self) -> Result<[Cow<'_, [f64]>; 2]> {
        // The linear term can serve as a buffer, because a solve first overwrites it.
        self.engine.apply(&self.traction, &mut self.linear)?;
        let mut held = [Cow::Borrowed(&[][..]), Cow::Borrowed(&[][..])];
        for axis in self.axes().iter().map(|axis| axis.index()) {
            held[axis] = self.pressed.region.given(&self.linear[axis]);
        }
        Ok(held)
    }

    /// Computes the tractions and the motion of body 2 at the end of a step. `before` is the motion at the start of the
    /// step.
    ///
    /// # Errors
    /// - [`Error::NotConverged`](crate::Error::NotConverged) if a limit is reached. The last feasible tractions and
    ///   their motion remain available.
    /// - Errors of the load, before any work.
    pub(crate) fn solve(
        &mut self,
        demand: &TangentialTarget,
        before: RigidMotion,
        start: Start,
        conditions: &mut SolveContext<'_, '_>,
    ) -> Result<()> {
        self.motion = RigidMotion {
            twist: demand.twist,
            ..before
        };
        let totals = self.compute_totals(demand)?;
        self.set_linear();
        self.check_size(demand, totals)?;
        let outcome = self.minimise(totals, start, conditions);
        let beyond = self.engine.multiplier();
        self.motion.shift = [0, 1].map(|axis| self.motion.shift[axis] + beyond[axis]);
        let traction = &self.traction;
        self.offsets.subtract_lag(|cell, entry| {
            entry.cells().added([0.0; 2], 1.0, cell, at(traction, cell))
        });
        outcome
    }

    fn minimise(
        &mut self,
        totals: [Total; 2],
        start: Start,
        conditions: &mut SolveContext<'_, '_>,
    ) -> Result<()> {
        let PressureOnWindow { region, limits, .. } = &self.pressed;
        let mut task = TangentialRequest {
            limits: &limits.cells,
            own: self.offsets.entry.cells(),
            linear: &self.linear,
            totals,
            is_frictionless: limits.sum <= 0.0,
            known: None,
            unit: limits.unit(),
        };
        match start {
            Start::Near => {}
            Start::Present(shift) => {
                let beyond = |axis: usize| shift[axis] - self.motion.shift[axis];
                task.known = Some(multipliers(totals, [0, 1].map(beyond)));
            }
            Start::Nested => {
                let is_at_rest = self.motion == RigidMotion::default();
                let is_drawn = |offset: [f64; 2]| offset.iter().any(|part| *part != 0.0);
                let offset = &self.offsets.cells;
                let is_drawn = reduce::any(region.layout(), |i| is_drawn(at(offset, i)));
                let is_moved = !is_at_rest || is_drawn;
                let is_idle = !is_moved && totals.iter().all(|total| total.is_idle());
                self.traction = if is_idle || limits.sum <= 0.0 {
                    zeros(self.offsets.axes(), region.cells())?
                } else {
                    let [x, y] = totals.map(|total| total.sum().unwrap_or(0.0));
                    let is_sliding = x.hypot(y) >= limits.sum;
                    self.engine.start(
                        &self.bodies,
                        region.window().size,
                        task,
                        is_sliding,
                        conditions,
                    )?
                };
            }
        }
        let settings = conditions.with_remaining_time();
        let observer = &mut *conditions.observer;
        self.engine
            .minimise(task, &mut self.traction, &settings, observer)
    }

    /// Converts the load to totals of the tractions and sets the datum of the motion.
    fn compute_totals(&mut self, demand: &TangentialTarget) -> Result<[Total; 2]> {
        let (cell_area, force) = (self.bodies.grid().cell_area(), demand.force());
        self.pressed.check(force, cell_area)?;
        let limits = &self.pressed.limits;
        let sums = (limits.sum > 0.0).then(|| limits.sums(force, cell_area));
        let measured = (self.datum(), cell_area);
        demand.compute_totals(self.axes(), sums, measured, &mut self.motion)
    }

    /// Returns an error if the squares of the tractions or displacements that the load causes overflow or underflow. If
    /// the tractions are measured in a unit, the test applies to their values in that unit.
    fn check_size(&self, demand: &TangentialTarget, totals: [Total; 2]) -> Result<()> {
        let PressureOnWindow { region, limits, .. } = &self.pressed;
        if limits.sum <= 0.0 {
            return Ok(());
        }
        let (layout, own) = (region.layout(), self.bodies.cell_compliance());
        let moved = reduce::max(layout, |i| {
            let [x, y] = at(&self.linear, i).map(f64::abs);
            if limits.cells[i] > 0.0 { x.max(y) } else { 0.0 }
        });
        let cells = layout.of_all_ranks() as f64;
        let pulled = totals.map(|total| match total {
            Total::Free => 0.0,
            Total::Sum(sum) => (sum / cells).abs(),
            Total::Spring {
                far_end,
                compliance,
            } => (far_end / (own + cells * compliance)).abs(),
        });
        // A force that is not zero may underflow when it is distributed over the cells.
        let is_pulled = demand.force().iter().any(|force| *force != 0.0);
        let is_idle = !is_pulled && totals.iter().all(|total| total.is_idle());
        if moved == 0.0 && is_idle {
            return Ok(());
        }
        let traction = pulled.into_iter().fold(moved / own, f64::max);
        let remedy = "choose different units of length or pressure, or a zero load";
        if let Some(unit) = limits.unit() {
            let quantity =
                "the ratio of the traction due to the tangential load to the friction limit";
            return has_squares(quantity, traction / unit, remedy).map(drop);
        }
        let quantity = "the traction due to the tangential load";
        has_squares(quantity, traction, remedy)?;
        let quantity = "the displacement due to the tangential load";
        has_squares(quantity, traction * own, remedy).map(drop)
    }

    /// Returns the shift at which the cell of the largest limit would have no traction, given the twist. Relative to
    /// this datum, a contact without any slip has exactly zero motion.
    fn datum(&self) -> [f64; 2] {
        let PressureOnWindow { region, limits, .. } = &self.pressed;
        let (limits, own) = (&limits.cells, region.own());
        let grid = self.bodies.grid().whole();
        let largest = reduce::least(region.layout(), |cell| {
            let offset = at(&self.offsets.cells, cell);
            Some((-limits[cell], (offset, own.index(cell))))
        });
        let Some((_, (shift, cell))) = largest else {
            return [0.0; 2];
        };
        let motion = RigidMotion {
            shift,
            ..self.motion
        };
        motion.at(centre(grid, cell)).map(|motion| -motion)
    }

    /// Sets the linear term so that every cell follows the motion from its offset.
    fn set_linear(&mut self) {
        let (grid, motion) = (self.bodies.grid().whole(), self.motion);
        let own = self.pressed.region.own();
        for axis in self.axes().iter().map(|axis| axis.index()) {
            let offset = &self.offsets.cells[axis];
            parallel::update(&mut self.linear[axis], |first, chunk| {
                for (k, linear) in (first..).zip(chunk) {
                    // Without rotation, the position of the cell does not matter.
                    let moved = if motion.twist == 0.0 {
                        motion.shift[axis]
                    } else {
                        motion.at(centre(grid, own.index(k)))[axis]
                    };
                    *linear = -(offset[k] + moved);
                }
            });
        }
    }
}
