//! New loads and new pressures of rolling bodies.

use std::sync::Arc;

use crate::error::{Error, Result};
use crate::grid::field::Field;
use crate::grid::window::Window;
use crate::memory::fallible::{filled, try_each, zeros};
use crate::normal::{NormalLoad, NormalSolution, NormalSolver, Scale};
use crate::numerics::cell_vector::slices;
use crate::rolling::RollingShift;
use crate::rolling::entry::entering;
use crate::rolling::steady::problem::draw;
use crate::rolling::{RollingProblem, RollingSolver};
use crate::tangential::EntryRule;
use crate::tangential::{
    Axis, CouplingDisplacement, EntryCompliance, PressureOnWindow, PressureSource, check_bodies,
    contact_window,
};

/// Additional cells on each side of a widened window, reserved for later loads.
const ROOM: [usize; 2] = [2; 2];

/// Normal solver with its accepted and candidate solutions.
#[derive(Clone)]
pub(in crate::rolling) struct Press {
    solver: NormalSolver,
    normal: NormalSolution,
    /// Solution that the rolling problem has not accepted yet.
    candidate: NormalSolution,
    /// Whether the pressure of the rolling problem is the pressure of `normal`.
    is_present: bool,
}

impl RollingSolver {
    /// Sets the pressure of the next solve, from a normal contact on the same bodies or from a field. The entry rule requires the
    /// gap ahead of the contact. A field does not include a gap and therefore requires [`EntryRule::WholeStep`].
    ///
    /// The next solve starts from the last tractions, scaled with the friction limit of each cell. Until that solve,
    /// [`stiffness`](Self::stiffness) returns an error. If the contact is within the largest window so far, no memory is
    /// allocated.
    ///
    /// This call does not change the gap of the [normal solver](Self::set_normal_solver), from which
    /// [`set_normal_load`](Self::set_normal_load) computes the pressure. After wear, set the normal solver again.
    ///
    /// # Errors
    /// - [`Error::UnsupportedByModel`] for a field if the entry rule is active.
    /// - [`Error::GridMismatch`], [`Error::BoundaryMismatch`], [`Error::CellValueMismatch`] or [`Error::MaterialMismatch`]
    ///   if the solution belongs to different bodies.
    /// - [`Error::NotConverged`] if the normal contact has not converged.
    /// - [`Error::Sample`] if a pressure is negative or not finite.
    /// - [`Error::EmptyContact`] if no cell carries pressure, for example after a wheel has lifted off.
    /// - [`Error::GridTooShort`] if the grid ends less than a step ahead of the contact.
    /// - [`Error::NotFinite`] if the friction limits overflow.
    /// - [`Error::BeyondFrictionCapacity`] or [`Error::BeyondFrictionMoment`] if the prescribed forces or moment exceed
    ///   the new capacity of friction. Set smaller loads first.
    /// - [`Error::Memory`] if a wider window does not fit into memory.
    /// - Other errors of [`HalfSpace::operator`].
    ///
    /// The solver is unchanged after an error.
    ///
    /// [`HalfSpace::operator`]: crate::HalfSpace::operator
    pub fn set_pressure<'a>(&mut self, pressure: impl Into<PressureSource<'a>>) -> Result<()> {
        let (source, problem) = (pressure.into(), &self.problem);
        let bodies = &problem.bodies;
        let samples = source.checked(bodies)?;
        let normal = match source {
            PressureSource::Solved(normal) => Some(normal),
            PressureSource::Prescribed(field) => {
                problem.check_needs_no_gap(field)?;
                None
            }
        };
        let contact = contact_window(bodies, samples)?;
        let reach = contact.union(problem.travel().shifted_upstream(contact)?);
        if problem.pressed.window().covers(reach) {
            self.press(samples, normal, contact)?;
        } else {
            let mut wider = self.widened(reach)?;
            wider.press(samples, normal, contact)?;
            wider.engine.press = self.engine.press.take();
            *self = wider;
        }
        self.problem.is_prescribed = source.is_prescribed();
        self.problem.scale = Scale::default();
        self.engine.changed = Some("the pressure");
        if let Some(press) = &mut self.engine.press {
            press.is_present = false;
        }
        Ok(())
    }

    /// Sets the solver that computes the pressure of a new load with its own gap, hardness and settings.
    ///
    /// This call does not change the pressure. [`set_normal_load`](Self::set_normal_load) solves for the pressure over the gap of
    /// `solver` and uses this pressure, until another normal solver is set. `solver` need not have solved before. Its gap may differ
    /// from the gap of the present pressure, for example after wear. The grid, the boundary, the cell values and the materials must
    /// be equal, but the solver may use another [`HalfSpace`](crate::HalfSpace) with these properties.
    ///
    /// # Errors
    /// - [`Error::GridMismatch`], [`Error::BoundaryMismatch`], [`Error::CellValueMismatch`] or [`Error::MaterialMismatch`]
    ///   if the solver belongs to different bodies.
    /// - [`Error::Memory`] if its solutions do not fit into memory.
    pub fn set_normal_solver(&mut self, solver: NormalSolver) -> Result<()> {
        let [normal, candidate] = try_each(|_| solver.try_new_solution())?;
        check_bodies(&normal, &self.problem.bodies)?;
        self.engine.press = Some(Box::new(Press {
            solver,
            normal,
            candidate,
            is_present: false,
        }));
        Ok(())
    }

    /// Sets the normal load of the next solve and computes the pressure under this load, starting from the last
    /// pressure. This function requires a [normal solver](Self::set_normal_solver). It uses the gap of this solver, not that of the
    /// last [`set_pressure`](Self::set_pressure). After wear, set the normal solver again. Once the window covers the largest
    /// contact, no memory is allocated.
    ///
    /// # Errors
    /// - [`Error::UnsupportedByModel`] without a normal solver.
    /// - The errors of [`NormalSolver::set_load`], [`NormalSolver::solve_into`] and [`set_pressure`](Self::set_pressure).
    ///
    /// The solver is unchanged after an error, but the next normal solve may start from a different pressure.
    pub fn set_normal_load(&mut self, load: NormalLoad) -> Result<()> {
        let Some(mut press) = self.engine.press.take() else {
            return Err(Error::UnsupportedByModel {
                model: "a rolling solver without a normal solver",
                quantity: "a new normal load",
                value: match load {
                    NormalLoad::Force(load) | NormalLoad::Approach(load) => load,
                },
                remedy: "set a normal solver first, or set a solved pressure",
            });
        };
        let before = press.solver.load();
        let outcome = press
            .solve(load)
            .and_then(|()| self.set_pressure(&press.candidate));
        match &outcome {
            Ok(()) => {
                std::mem::swap(&mut press.normal, &mut press.candidate);
                press.is_present = true;
                self.problem.scale = press.normal.scale();
            }
            Err(_) => press.solver.restore_load(before),
        }
        self.engine.press = Some(press);
        outcome
    }

    /// Returns the normal contact computed by [`set_normal_load`](Self::set_normal_load), whose pressure the next solve uses.
    /// Returns `None` before the first load, and after [`set_pressure`](Self::set_pressure) has replaced the pressure.
    #[must_use]
    pub fn normal(&self) -> Option<&NormalSolution> {
        let press = self.engine.press.as_deref()?;
        press.is_present.then_some(&press.normal)
    }

    /// Returns the largest tangential force that friction can carry, the integral of the friction limit.
    #[must_use]
    pub fn friction_capacity(&self) -> f64 {
        self.problem.pressed.limits.sum * self.problem.bodies.grid().cell_area()
    }

    /// Sets a pressure on the whole grid whose contact is inside the window.
    fn press(
        &mut self,
        samples: &[f64],
        normal: Option<&NormalSolution>,
        contact: Window,
    ) -> Result<()> {
        let problem = &self.problem;
        let (bodies, size) = (&problem.bodies, problem.step.size);
        if bodies.pair().is_coupled() && self.engine.drawing.is_none() {
            self.engine.drawing = Some(CouplingDisplacement::new(bodies, Axis::BOTH, size)?);
        }
        self.engine.candidate.set(samples, &problem.friction);
        let mut drawing = self.engine.drawing.take();
        let taken = self.take_candidate(|problem| {
            problem.follow_pressure(normal, contact, drawing.as_mut());
            Ok(())
        });
        self.engine.drawing = drawing;
        taken?;
        if let Some(lift) = &mut self.engine.lifting {
            lift.press(&self.problem.pressed);
        }
        Arc::make_mut(&mut self.engine.operator).set_chain(self.problem.chain);
        self.engine.has_new_pressure = self.engine.is_warm;
        Ok(())
    }

    /// Returns a solver on a window that contains the current window and the part of the grid that a new contact reaches. The new
    /// solver contains the last solution and no pressure.
    fn widened(&self, reach: Window) -> Result<Self> {
        let problem = &self.problem;
        let (bodies, inner) = (&problem.bodies, problem.pressed.window());
        let window = inner.union(reach.with_margins(bodies.grid(), ROOM));
        let window = bodies.restrict_to_window(window);
        let pressed = PressureOnWindow::new(bodies, window)?;
        let cells = pressed.region.cells();
        let mut wider = Self::new(RollingProblem {
            bodies: bodies.clone(),
            step: problem.travel().through(window.size),
            own: filled(EntryCompliance::NONE, cells)?,
            drawn: try_each(|_| zeros(cells))?,
            friction: problem.friction.clone(),
            pressed,
            ..*problem
        })?;
        let places = || inner.indices().filter_map(|index| window.place(index));
        for (cell, place) in places().enumerate() {
            wider.engine.limits[place] = self.engine.limits[cell];
            wider.engine.own_mean[place] = self.engine.own_mean[cell];
            wider.engine.own_deviator[place] = self.engine.own_deviator[cell];
            for axis in 0..2 {
                wider.engine.traction[axis][place] = self.engine.traction[axis][cell];
                wider.engine.linear[axis][place] = self.engine.linear[axis][cell];
            }
        }
        let multiplier = self.engine.workspace.multiplier();
        let traction = slices(&wider.engine.traction);
        (wider.engine.workspace).set_solution(&*wider.engine.operator, traction, multiplier);
        wider.engine.report.clone_from(&self.engine.report);
        (wider.engine.unit, wider.engine.spin, wider.engine.is_warm) =
            (self.engine.unit, self.engine.spin, self.engine.is_warm);
        Ok(wider)
    }
}

impl Press {
    /// Solves for the pressure under a load.
    fn solve(&mut self, load: NormalLoad) -> Result<()> {
        self.solver.set_load(load)?;
        self.solver.solve_into(&mut self.candidate)
    }
}

impl RollingProblem {
    /// Returns the direction and distance of rolling in a step.
    fn travel(&self) -> RollingShift {
        RollingShift::new(self.bodies.grid(), self.step.edge, self.step.cells)
    }

    /// Returns an error if the entry rule is active, because the rule requires a gap.
    fn check_needs_no_gap(&self, pressure: &Field) -> Result<()> {
        if self.options.entry_rule == EntryRule::WholeStep {
            return Ok(());
        }
        Err(Error::UnsupportedByModel {
            model: "the entry rule",
            quantity: "a pressure without a gap (value: the largest pressure)",
            value: pressure.max(),
            remedy: "give a solved normal contact, or create the contact with the entry rule of the whole step",
        })
    }

    /// Updates the quantities that depend on the pressure.
    fn follow_pressure(
        &mut self,
        normal: Option<&NormalSolution>,
        contact: Window,
        drawing: Option<&mut CouplingDisplacement>,
    ) {
        let (pressed, step) = (&self.pressed, self.step);
        if let Some(normal) = normal.filter(|_| self.options.entry_rule == EntryRule::SinceTouch) {
            entering(normal, pressed, step, &mut self.own);
        }
        if let Some(drawing) = drawing {
            draw(drawing, pressed, step, &mut self.drawn);
        }
        self.chain = step.chain(contact.size[step.edge.axis().index()]);
    }
}
