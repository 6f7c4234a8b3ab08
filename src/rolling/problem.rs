//! The scene of steady rolling, checked once.

use crate::buffer::{TryClone, filled, try_clone, try_each, zeros};
use crate::cgm::{Settings, settings_methods};
use crate::error::{Error, RankFailure, Result, at_least, finite, positive};
use crate::half_space::HalfSpace;
use crate::history::Passage;
use crate::history::TouchRule;
use crate::history::rolling_entry::entering;
use crate::normal::NormalSolution;
use crate::rolling::{LeadingEdge, RollingControl, RollingSolution, RollingSolver, SpinControl};
use crate::shown::shown;
use crate::tangential::{
    Axis, Drawing, Friction, OwnCompliance, Pressed, PressureSource, TangentialModel, centre,
    contact_window, is_at_limit,
};
use crate::window::Window;

/// Bodies, normal contact, friction, and what is prescribed of their rolling.
#[derive(Clone)]
pub struct RollingProblem {
    pub(super) bodies: HalfSpace,
    pub(super) pressed: Pressed,
    pub(super) step: Passage,
    /// Length of a step.
    pub(super) length: f64,
    /// Compliance of its own of each cell of the window.
    pub(super) own: Vec<OwnCompliance>,
    /// The most cells of the contact that lie one behind the other, a step apart.
    pub(super) chain: usize,
    /// What the pressure adds to the slip of each cell.
    pub(super) drawn: [Vec<f64>; 2],
    pub(super) controls: [RollingControl; 2],
    pub(super) spin: SpinControl,
    pub(super) settings: Settings,
}

try_clone!(RollingProblem { pressed, own, drawn } { bodies, step, length, chain, controls, spin, settings });

shown!(RollingProblem: bodies, step, controls, spin, settings);

/// Options of a [`RollingProblem`]; each has a default.
#[derive(Debug, Clone)]
#[must_use = "a builder does nothing until build() is called"]
pub struct RollingProblemBuilder<'a> {
    bodies: &'a HalfSpace,
    normal: &'a NormalSolution,
    friction: Friction,
    edge: LeadingEdge,
    cells: usize,
    controls: [RollingControl; 2],
    spin: SpinControl,
    touch_rule: TouchRule,
    settings: Settings,
}

impl RollingProblem {
    /// Starts from what is required: bodies, a solved normal contact on them, friction. Without
    /// options both creepages and the spin are zero.
    pub fn builder<'a>(
        bodies: &'a HalfSpace,
        normal: &'a NormalSolution,
        friction: Friction,
    ) -> RollingProblemBuilder<'a> {
        RollingProblemBuilder {
            bodies,
            normal,
            friction,
            edge: LeadingEdge::default(),
            cells: 1,
            controls: [RollingControl::Creepage(0.0); 2],
            spin: SpinControl::Spin(0.0),
            touch_rule: TouchRule::default(),
            settings: Settings::default(),
        }
    }

    /// Solves once, with buffers of its own.
    ///
    /// # Errors
    /// [`Error::NotConverged`] with the report; as [`HalfSpace::operator`]; [`Error::Memory`].
    pub fn solve(&self) -> Result<RollingSolution> {
        let mut solver = RollingSolver::new(self.try_clone()?)?;
        let mut solution = solver.try_new_solution()?;
        solver.solve_into(&mut solution)?;
        Ok(solution)
    }

    /// The reusable form: creepages, forces and spin may change between solves, each of which starts from the last answer.
    ///
    /// # Errors
    /// As [`HalfSpace::operator`]; [`Error::Memory`].
    pub fn into_solver(self) -> Result<RollingSolver> {
        RollingSolver::new(self)
    }

    /// `Ok` if these can be prescribed.
    pub(super) fn check(&self, controls: [RollingControl; 2], spin: SpinControl) -> Result<()> {
        controls.into_iter().try_for_each(RollingControl::check)?;
        let (name, turn) = match spin {
            SpinControl::Spin(spin) => ("spin", spin),
            SpinControl::Moment(moment) => ("moment", moment),
        };
        finite(name, turn)?;
        if spin != SpinControl::Spin(0.0) && !self.bodies.boundary().may_turn() {
            return Err(Error::NotModelled {
                quantity: name,
                value: turn,
                remedy: "a grid that repeats cannot turn, with any option",
            });
        }
        let force = controls.map(|control| match control {
            RollingControl::Force(force) => force,
            RollingControl::Creepage(_) => 0.0,
        });
        let (grid, area) = (self.bodies.grid(), self.bodies.grid().cell_area());
        if let SpinControl::Spin(spin) = spin {
            let extent = (grid.dx() * grid.nx() as f64).hypot(grid.dy() * grid.ny() as f64);
            finite("turn of a step by the spin", spin * extent * self.length)?;
        }
        for control in controls {
            match control {
                RollingControl::Creepage(creepage) => {
                    finite("creepage of a step", creepage * self.length)?;
                }
                RollingControl::Force(force) => {
                    finite("tangential force over the cell area", force / area)?;
                }
            }
        }
        self.pressed.limits.check(force, area)?;
        let (size, limit) = (force[0].hypot(force[1]), self.pressed.limits.sum * area);
        let is_force = |control: &RollingControl| matches!(control, RollingControl::Force(_));
        // A force that slides the whole contact leaves its creepage open.
        if controls.iter().any(is_force) && is_at_limit(size, limit) {
            return Err(Error::BeyondFrictionCapacity { force: size, limit });
        }
        if let SpinControl::Moment(moment) = spin {
            let capacity = finite("moment that friction holds", self.moment_capacity())?;
            if is_at_limit(moment.abs(), capacity) {
                return Err(Error::Below {
                    quantity: "moment that friction holds",
                    value: capacity,
                    least_is: "the moment asked for",
                    least: moment.abs(),
                });
            }
        }
        Ok(())
    }

    /// How a cell of the grid moves over a step by a unit of creepage along x, along y and of spin, halfway.
    pub(super) fn motions(&self, index: usize) -> [[f64; 2]; 3] {
        let edge = self.step.edge;
        let mut middle = centre(self.bodies.grid(), index);
        middle[edge.axis().index()] += if edge.is_positive() { 0.5 } else { -0.5 } * self.length;
        let directions = [[1.0, 0.0], [0.0, 1.0], [-middle[1], middle[0]]];
        directions.map(|direction| direction.map(|part| self.length * part))
    }

    /// The moment about the origin of the grid that a large spin causes: tractions at their limits along its motion.
    pub(super) fn moment_capacity(&self) -> f64 {
        let (grid, limits) = (self.bodies.grid(), &self.pressed.limits.cells);
        let levers = self.pressed.window().indices().map(|index| {
            let ([x, y], [_, _, turned]) = (centre(grid, index), self.motions(index));
            let size = turned[0].hypot(turned[1]);
            let lever = (x * turned[1] - y * turned[0]) / size;
            if size > 0.0 { lever } else { 0.0 }
        });
        let parts = limits
            .iter()
            .zip(levers)
            .map(|(limit, lever)| limit * lever);
        parts.fold(0.0, |sum, part| sum + part) * grid.cell_area()
    }
}

impl RollingProblemBuilder<'_> {
    settings_methods!();

    /// Where particles enter the contact (default [`LeadingEdge::PlusX`]).
    pub fn leading_edge(mut self, edge: LeadingEdge) -> Self {
        self.edge = edge;
        self
    }

    /// Cells that a particle passes in a step (default 1). Longer steps cost less and are less accurate.
    pub fn step(mut self, cells: usize) -> Self {
        self.cells = cells;
        self
    }

    /// Both creepages `[x, y]` (dimensionless, default zero).
    pub fn creepage(mut self, creepage: [f64; 2]) -> Self {
        self.controls = creepage.map(RollingControl::Creepage);
        self
    }

    /// What is prescribed along an axis (default: no creepage).
    pub fn control(mut self, axis: Axis, control: RollingControl) -> Self {
        self.controls[axis.index()] = control;
        self
    }

    /// The [spin](SpinControl::Spin) (one over a length, default zero), or what is prescribed in its place.
    pub fn spin(mut self, spin: impl Into<SpinControl>) -> Self {
        self.spin = spin.into();
        self
    }

    /// How cells that enter the contact follow the motion (default [`TouchRule::Growth`]).
    pub fn touch_rule(mut self, touch_rule: TouchRule) -> Self {
        self.touch_rule = touch_rule;
        self
    }

    /// Checks everything and cuts out the contact.
    ///
    /// # Errors
    /// [`Error::NotConverged`] if the normal contact is not; [`Error::GridMismatch`], [`Error::BoundaryMismatch`],
    /// [`Error::CellValueMismatch`] or [`Error::MaterialMismatch`] for one of other bodies; [`Error::EmptyContact`];
    /// [`Error::NotFinite`] for creepages, forces, spin or moment, [`Error::NotPositive`] for a step of no cells,
    /// [`Error::NotModelled`] for rolling along an axis on which the grid repeats, or spin on such a grid;
    /// [`Error::Below`] if the grid ends less than a step ahead of the contact, or for a moment beyond what friction holds;
    /// [`Error::BeyondFrictionCapacity`] for forces that friction does not hold, or holds only by sliding;
    /// [`Error::Tolerance`], [`Error::IterationLimit`], [`Error::Method`]; [`Error::Memory`]; [`Error::Ranks`] on bodies
    /// that ranks share.
    pub fn build(self) -> Result<RollingProblem> {
        let (bodies, grid) = (self.bodies, self.bodies.grid());
        if bodies.is_shared() {
            return Err(Error::Ranks(RankFailure::NotShared("steady rolling")));
        }
        self.friction.check(grid)?;
        self.settings.check()?;
        TangentialModel::Vector.check(&self.settings)?;
        positive("cells of a step", self.cells as f64)?;
        let axis = self.edge.axis();
        let side = [grid.dx(), grid.dy()][axis.index()];
        let length = finite("length of a step", side * self.cells as f64)?;
        if bodies.boundary().repeats()[axis.index()] {
            return Err(Error::NotModelled {
                quantity: "rolling by a step along an axis on which the grid repeats",
                value: length,
                remedy: "roll along the other axis, or on a grid that does not repeat",
            });
        }
        let samples = PressureSource::from(self.normal).checked(bodies)?;
        let contact = contact_window(bodies, samples)?;
        let window = self.reach_ahead(contact)?;
        let step = Passage {
            size: window.size,
            edge: self.edge,
            cells: self.cells,
        };
        let mut pressed = Pressed::new(bodies, window)?;
        pressed.set(samples, &self.friction);
        let own = match self.touch_rule {
            TouchRule::Growth => entering(self.normal, &pressed, step)?,
            TouchRule::WholeStep => filled(OwnCompliance::NONE, pressed.region.cells())?,
        };
        let problem = RollingProblem {
            own,
            drawn: drawn(bodies, &pressed, step)?,
            chain: step.chain(contact.size[axis.index()]),
            bodies: bodies.clone(),
            pressed,
            step,
            length,
            controls: self.controls,
            spin: self.spin,
            settings: self.settings,
        };
        problem.check(self.controls, self.spin)?;
        Ok(problem)
    }

    /// The window of the contact and of where its particles were a step before.
    fn reach_ahead(&self, contact: Window) -> Result<Window> {
        let grid = self.bodies.grid();
        let axis = self.edge.axis().index();
        let (mut corner, mut size) = (contact.corner(), contact.size);
        let room = if self.edge.is_positive() {
            grid.whole().size()[axis] - corner[axis] - size[axis]
        } else {
            corner[axis]
        };
        let (needed, room) = (self.cells as f64, room as f64);
        at_least(
            "those of a step",
            needed,
            "cells ahead of the contact",
            room,
        )?;
        size[axis] += self.cells;
        if !self.edge.is_positive() {
            corner[axis] -= self.cells;
        }
        Window::at(grid, corner, size).ok_or(Error::EmptyContact)
    }
}

/// What the pressure of bodies of different materials adds to the slip of each cell.
fn drawn(bodies: &HalfSpace, pressed: &Pressed, step: Passage) -> Result<[Vec<f64>; 2]> {
    let mut drawn = try_each(|_| zeros(pressed.region.cells()))?;
    if bodies.pair().is_coupled() {
        let mut drawing = Drawing::new(bodies, Axis::BOTH, step.size)?;
        drawing.displace(pressed.pressure.iter().copied(), |axis, displacement| {
            let part: &mut Vec<f64> = &mut drawn[axis.index()];
            part.copy_from_slice(displacement);
            step.difference(part);
        });
    }
    Ok(drawn)
}
