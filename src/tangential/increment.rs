//! One step of a tangential contact, of a problem from rest or of a history.

use std::borrow::Cow;

use crate::bodies::coupling::Coupling;
use crate::cgm::{CellCompliance, Total, reduce};
use crate::contact::{LoadTrend, SolveContext, multipliers};
use crate::error::{Result, has_squares};
use crate::half_space::HalfSpace;
use crate::memory::fallible;
use crate::numerics::cell_vector::slices;
use crate::parallel;
use crate::report::Report;
use crate::tangential::load::TangentialTarget;
use crate::tangential::one_way::CouplingDisplacement;
use crate::tangential::rigid_motion::{RigidMotion, centre};
use crate::tangential::step_solution::StepSolution;
use crate::tangential::traction_solver::{
    TangentialEngine, TangentialRequest, TangentialVector, at, engine_along, zeros,
};
use crate::tangential::{Axis, PressureOnWindow};

/// The tangential contact on a window: pressure, limits and tractions of its cells, and the engine that solves a step.
///
/// A step finds tractions $`q`$ and a motion $`\delta`$ of body 2 with $`s = C q - S - \delta`$ for the slip of the
/// step. The offset $`S`$ is what $`u - \delta`$ is in a cell while it sticks, zero from rest. A history sets it, and the
/// diagonal $`B`$ of the cells that enter the contact in the step, for which $`s = C q + B q - S - \delta`$.
#[derive(Debug, Clone)]
pub(crate) struct TangentialIncrement {
    pub(super) bodies: HalfSpace,
    pub(super) axes: &'static [Axis],
    pub(crate) pressed: PressureOnWindow,
    pub(super) engine: Box<dyn TangentialEngine>,
    /// The start of the next step, and the answer of the last.
    pub(super) traction: TangentialVector,
    /// Offset of every cell in this step.
    pub(super) offset: TangentialVector,
    /// What a solve asks of each cell; it is written first, and serves before as a buffer.
    pub(super) linear: TangentialVector,
    /// Compliance of their own of the cells that enter the contact in this step; empty where none does.
    pub(super) diagonal: Vec<f64>,
    /// `[a, b]` of what they have beside it in the plane, the rows `[a, b]` and `[b, -a]`; empty where it is the same in
    /// all directions.
    pub(super) deviator: Vec<[f64; 2]>,
    /// Whether a cell does, of any rank.
    pub(super) has_entered: bool,
    /// How pressure moves the surfaces, if it is to.
    pub(super) drawing: Option<CouplingDisplacement>,
    /// Motion of body 2 at the end of the last step.
    motion: RigidMotion,
}

/// How a step begins.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Start {
    /// From the answer on coarser cells.
    Nested,
    /// From the present tractions, which were an answer at this shift.
    Present([f64; 2]),
    /// From the present tractions, which are near the answer.
    Near,
}

impl TangentialIncrement {
    /// Without traction.
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
            axes,
            engine: engine_along(bodies, axes, size)?,
            traction: zeros(axes, cells)?,
            offset: zeros(axes, cells)?,
            linear: zeros(axes, cells)?,
            diagonal: Vec::new(),
            deviator: Vec::new(),
            has_entered: false,
            motion: RigidMotion::default(),
            pressed,
        })
    }

    pub(crate) fn axes(&self) -> &'static [Axis] {
        self.axes
    }

    pub(crate) fn report(&self) -> &Report {
        self.engine.report()
    }

    /// Motion of body 2 at the end of the last step solved, converged or not.
    pub(crate) fn motion(&self) -> RigidMotion {
        self.motion
    }

    /// Takes the tractions of the whole grid as the present ones.
    pub(crate) fn set_traction(&mut self, traction: [&[f64]; 2]) {
        for axis in self.axes.iter().map(|axis| axis.index()) {
            let part = &mut self.traction[axis];
            self.pressed.region.gather(traction[axis], part);
        }
    }

    /// Takes these of the cells of the grid, by axis and cell, as the present ones.
    pub(crate) fn collect_traction(&mut self, traction: impl Fn(usize, usize) -> f64) {
        for axis in self.axes.iter().map(|axis| axis.index()) {
            let part = &mut self.traction[axis];
            self.pressed
                .region
                .collect(|cell| traction(axis, cell), part);
        }
    }

    /// The present tractions, zero beyond the window, for another increment.
    pub(crate) fn hand_over(&self, other: &mut Self) -> Result<()> {
        let mut whole = fallible::zeros(self.bodies.grid().cells())?;
        for axis in self.axes.iter().map(|axis| axis.index()) {
            whole.fill(0.0);
            let (from, to) = (&self.pressed.region, &other.pressed.region);
            from.scatter(&self.traction[axis], &mut whole);
            to.gather(&whole, &mut other.traction[axis]);
        }
        Ok(())
    }

    /// Moves the present tractions on by so many times a trend of the cells held here.
    pub(crate) fn extrapolate(&mut self, trend: &LoadTrend<2>, parts: f64) {
        for axis in self.axes.iter().map(|axis| axis.index()) {
            let change = self.pressed.region.taken(&trend.change[axis]);
            parallel::update(&mut self.traction[axis], |first, chunk| {
                for (traction, change) in chunk.iter_mut().zip(&change[first..]) {
                    *traction += parts * change;
                }
            });
        }
    }

    /// What the last step has found.
    pub(crate) fn answer(&self) -> StepSolution<'_> {
        let (traction, offset) = (slices(&self.traction), slices(&self.offset));
        let found = [traction, self.engine.product(), offset];
        StepSolution::new(&self.pressed, self.axes, found, self.motion)
    }

    /// Gives the buffers of the solve back: the displacements of the answer are gone.
    pub(crate) fn rest(&mut self) {
        self.engine.rest();
    }

    /// The displacement of the cells held here that the present tractions cause, computed anew.
    pub(crate) fn fresh_displacement(&mut self) -> Result<[Cow<'_, [f64]>; 2]> {
        // A solve writes its linear term first.
        self.engine.apply(&self.traction, &mut self.linear)?;
        let mut held = [Cow::Borrowed(&[][..]), Cow::Borrowed(&[][..])];
        for axis in self.axes.iter().map(|axis| axis.index()) {
            held[axis] = self.pressed.region.given(&self.linear[axis]);
        }
        Ok(held)
    }

    /// Finds the tractions at the end of a step, and the motion of body 2 there, which was `before` at its beginning.
    ///
    /// # Errors
    /// [`Error::NotConverged`](crate::Error::NotConverged) with the last feasible tractions and their motion; what is
    /// wrong with the demand before any work.
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
        self.subtract_entry_lag();
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
            own: CellCompliance::new(&self.diagonal, &self.deviator),
            linear: &self.linear,
            totals,
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
                let is_drawn = reduce::any(region.layout(), |i| is_drawn(at(&self.offset, i)));
                let is_moved = !is_at_rest || is_drawn;
                let is_idle = !is_moved && totals.iter().all(|total| total.is_idle());
                self.traction = if is_idle || limits.sum <= 0.0 {
                    zeros(self.axes, region.cells())?
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

    /// What is prescribed of the sums of the tractions; the motion becomes the one they are measured from.
    fn compute_totals(&mut self, demand: &TangentialTarget) -> Result<[Total; 2]> {
        let (cell_area, force) = (self.bodies.grid().cell_area(), demand.force());
        self.pressed.check(force, cell_area)?;
        let limits = &self.pressed.limits;
        let sums = (limits.sum > 0.0).then(|| limits.sums(force, cell_area));
        let measured = (self.datum(), cell_area);
        demand.compute_totals(self.axes, sums, measured, &mut self.motion)
    }

    /// Returns an error if the squares of the tractions or of the displacements that the load causes leave the range of
    /// numbers. Tractions that are measured in a unit are compared with it.
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
        // A force that is not zero may vanish where it is spread over the cells.
        let is_pulled = demand.force().iter().any(|force| *force != 0.0);
        let is_idle = !is_pulled && totals.iter().all(|total| total.is_idle());
        if moved == 0.0 && is_idle {
            return Ok(());
        }
        let traction = pulled.into_iter().fold(moved / own, f64::max);
        let remedy = "choose other units of length or pressure, or a load that is zero";
        if let Some(unit) = limits.unit() {
            let quantity = "the traction that the tangential load causes, over the friction limit,";
            return has_squares(quantity, traction / unit, remedy).map(drop);
        }
        let quantity = "the traction that the tangential load causes";
        has_squares(quantity, traction, remedy)?;
        let quantity = "the displacement that the tangential load causes";
        has_squares(quantity, traction * own, remedy).map(drop)
    }

    /// The shift that, with a twist, would leave the cell of the largest limit without traction: measured from
    /// there, a contact that has nowhere slipped asks for exactly none.
    fn datum(&self) -> [f64; 2] {
        let PressureOnWindow { region, limits, .. } = &self.pressed;
        let (limits, own) = (&limits.cells, region.own());
        let grid = self.bodies.grid().whole();
        let largest = reduce::least(region.layout(), |cell| {
            let centre = centre(grid, own.index(cell));
            Some((-limits[cell], (at(&self.offset, cell), centre)))
        });
        let Some((_, (shift, centre))) = largest else {
            return [0.0; 2];
        };
        let motion = RigidMotion {
            shift,
            ..self.motion
        };
        motion.at(centre).map(|motion| -motion)
    }

    /// Asks every cell to follow the motion, from its offset.
    fn set_linear(&mut self) {
        let (grid, motion) = (self.bodies.grid().whole(), self.motion);
        let own = self.pressed.region.own();
        for axis in self.axes.iter().map(|axis| axis.index()) {
            let offset = &self.offset[axis];
            parallel::update(&mut self.linear[axis], |first, chunk| {
                for (k, linear) in (first..).zip(chunk) {
                    let moved = motion.at(centre(grid, own.index(k)))[axis];
                    *linear = -(offset[k] + moved);
                }
            });
        }
    }
}
