//! The scene of steady rolling, checked once.

use crate::cgm::{Settings, settings_methods};
use crate::error::{Error, RankFailure, Result, SLIDE, finite, of_rolling};
use crate::half_space::HalfSpace;
use crate::memory::fallible::{TryClone, filled, try_clone, try_each, zeros};
use crate::normal::NormalSolution;
use crate::rolling::entry::entering;
use crate::rolling::{LeadingEdge, RollingControl, RollingSolution, RollingSolver, SpinControl};
use crate::rolling::{RollingShift, WindowShift};
use crate::support::debug::shown;
use crate::tangential::EntryRule;
use crate::tangential::{
    Axis, CouplingDisplacement, EntryCompliance, Friction, PressureOnWindow, PressureSource,
    TangentialModel, centre, contact_window, is_at_limit,
};

/// Bodies, normal contact, friction, and what is prescribed of their rolling.
#[derive(Clone)]
pub struct RollingProblem {
    pub(in crate::rolling) bodies: HalfSpace,
    pub(in crate::rolling) pressed: PressureOnWindow,
    pub(in crate::rolling) friction: Friction,
    pub(in crate::rolling) entry_rule: EntryRule,
    /// Solves that correct the direction of slip.
    pub(in crate::rolling) slip_corrections: usize,
    pub(in crate::rolling) step: WindowShift,
    /// Length of a step.
    pub(in crate::rolling) length: f64,
    /// Compliance of its own of each cell of the window.
    pub(in crate::rolling) own: Vec<EntryCompliance>,
    /// The most cells of the contact that lie one behind the other, a step apart.
    pub(in crate::rolling) chain: usize,
    /// What the pressure adds to the slip of each cell.
    pub(in crate::rolling) drawn: [Vec<f64>; 2],
    pub(in crate::rolling) controls: [RollingControl; 2],
    pub(in crate::rolling) spin: SpinControl,
    pub(in crate::rolling) settings: Settings,
}

try_clone!(RollingProblem { pressed, friction, own, drawn } {
    bodies, entry_rule, slip_corrections, step, length, chain, controls, spin, settings,
});

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
    entry_rule: EntryRule,
    slip_corrections: usize,
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
            entry_rule: EntryRule::default(),
            slip_corrections: 0,
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
    pub(in crate::rolling) fn check(
        &self,
        controls: [RollingControl; 2],
        spin: SpinControl,
    ) -> Result<()> {
        check_motion(&self.bodies, self.length, controls, spin)?;
        let force = controls.map(|control| match control {
            RollingControl::Force(force) => force,
            RollingControl::Creepage(_) => 0.0,
        });
        let area = self.bodies.grid().cell_area();
        self.pressed.limits.check(force, area).map_err(of_rolling)?;
        let (size, limit) = (force[0].hypot(force[1]), self.pressed.limits.sum * area);
        let is_force = |control: &RollingControl| matches!(control, RollingControl::Force(_));
        // A force that slides the whole contact leaves its creepage open.
        if controls.iter().any(is_force) && is_at_limit(size, limit) {
            return Err(of_rolling(Error::BeyondFrictionCapacity {
                force: size,
                limit,
                remedy: SLIDE,
            }));
        }
        if let SpinControl::Moment(moment) = spin {
            self.check_moment(controls, moment)?;
        }
        Ok(())
    }

    /// How a cell of the grid moves over a step by a unit of creepage along x, along y and of spin, halfway.
    pub(in crate::rolling) fn motions(&self, index: usize) -> [[f64; 2]; 3] {
        let ([x, y], [ahead_x, ahead_y]) = (centre(self.bodies.grid(), index), self.halfway());
        let middle = [x + ahead_x, y + ahead_y];
        let directions = [[1.0, 0.0], [0.0, 1.0], [-middle[1], middle[0]]];
        directions.map(|direction| direction.map(|part| self.length * part))
    }

    /// Half the diagonal of the window, at which a spin moves the particles by about as much as a creepage.
    pub(in crate::rolling) fn lever(&self) -> f64 {
        let (grid, [columns, rows]) = (self.bodies.grid(), self.pressed.window().size);
        0.5 * (columns as f64 * grid.dx()).hypot(rows as f64 * grid.dy())
    }

    /// From where a particle is to the middle of its way.
    pub(in crate::rolling) fn halfway(&self) -> [f64; 2] {
        let (edge, mut way) = (self.step.edge, [0.0; 2]);
        way[edge.axis().index()] = if edge.is_positive() { 0.5 } else { -0.5 } * self.length;
        way
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

    /// Sets the number of corrections of the direction of slip (default 0).
    ///
    /// If the slip turns within the contact, as under spin or oblique creepage, the forces converge with first
    /// order in the step. Two corrections give an order of 1.5 to 2, as measured on the page of the
    /// [module](crate::rolling#slip-that-turns), at the cost of two more solves from the last tractions.
    /// The slip of the solution remains the mean over the step, which corrected tractions do not oppose exactly.
    pub fn slip_corrections(mut self, corrections: usize) -> Self {
        self.slip_corrections = corrections;
        self
    }

    /// How cells that enter the contact follow the motion (default [`EntryRule::SinceTouch`]).
    pub fn entry_rule(mut self, entry_rule: EntryRule) -> Self {
        self.entry_rule = entry_rule;
        self
    }

    /// Checks everything and cuts out the contact.
    ///
    /// # Errors
    /// [`Error::NotConverged`] if the normal contact is not; [`Error::GridMismatch`], [`Error::BoundaryMismatch`],
    /// [`Error::CellValueMismatch`] or [`Error::MaterialMismatch`] for one of other bodies; [`Error::EmptyContact`];
    /// [`Error::NotFinite`] for creepages, forces, spin or moment, [`Error::NotPositive`] for a step of no cells,
    /// [`Error::UnsupportedByModel`] for rolling along an axis on which the grid repeats, or spin on such a grid;
    /// [`Error::UnsupportedForCoatings`] for operators of a user;
    /// [`Error::GridTooShort`] if the grid ends less than a step ahead of the contact;
    /// [`Error::BeyondFrictionCapacity`] for forces that friction does not hold, or holds only by sliding, and
    /// [`Error::BeyondFrictionMoment`] for such a moment, beside the forces prescribed;
    /// [`Error::Tolerance`], [`Error::IterationLimit`], [`Error::Method`]; [`Error::Memory`]; [`Error::Ranks`] on bodies
    /// that ranks share.
    pub fn build(self) -> Result<RollingProblem> {
        let (bodies, grid) = (self.bodies, self.bodies.grid());
        if bodies.is_shared() {
            return Err(Error::Ranks(RankFailure::UnsupportedOnRanks(
                "steady rolling",
            )));
        }
        self.friction.check(grid)?;
        self.settings.check()?;
        TangentialModel::Vector.check(&self.settings)?;
        let travel = RollingShift::new(grid, self.edge, self.cells);
        travel.check(bodies)?;
        let samples = PressureSource::from(self.normal).checked(bodies)?;
        let contact = contact_window(bodies, samples)?;
        let window = contact.union(travel.shifted_upstream(contact)?);
        let step = travel.through(window.size);
        let mut pressed = PressureOnWindow::new(bodies, window)?;
        pressed.set(samples, &self.friction);
        let mut own = filled(EntryCompliance::NONE, pressed.region.cells())?;
        if self.entry_rule == EntryRule::SinceTouch {
            entering(self.normal, &pressed, step, &mut own);
        }
        let problem = RollingProblem {
            own,
            drawn: coupling_slip(bodies, &pressed, step)?,
            chain: step.chain(contact.size[self.edge.axis().index()]),
            bodies: bodies.clone(),
            pressed,
            friction: self.friction,
            entry_rule: self.entry_rule,
            slip_corrections: self.slip_corrections,
            step,
            length: travel.length,
            controls: self.controls,
            spin: self.spin,
            settings: self.settings,
        };
        problem.check(self.controls, self.spin)?;
        Ok(problem)
    }
}

/// `Ok` if bodies can roll so by steps of this length, whatever the pressure.
pub(in crate::rolling) fn check_motion(
    bodies: &HalfSpace,
    length: f64,
    controls: [RollingControl; 2],
    spin: SpinControl,
) -> Result<()> {
    controls.into_iter().try_for_each(RollingControl::check)?;
    let (name, turn) = match spin {
        SpinControl::Spin(spin) => ("spin", spin),
        SpinControl::Moment(moment) => ("moment", moment),
    };
    finite(name, turn)?;
    if spin != SpinControl::Spin(0.0) && !bodies.boundary().may_turn() {
        return Err(Error::UnsupportedByModel {
            model: "the model of rolling",
            quantity: name,
            value: turn,
            remedy: "a grid that repeats cannot turn, with any option",
        });
    }
    let (grid, area) = (bodies.grid(), bodies.grid().cell_area());
    if let SpinControl::Spin(spin) = spin {
        let extent = (grid.dx() * grid.nx() as f64).hypot(grid.dy() * grid.ny() as f64);
        finite("turn of a step by the spin", spin * extent * length)?;
    }
    for control in controls {
        match control {
            RollingControl::Creepage(creepage) => {
                finite("creepage of a step", creepage * length)?;
            }
            RollingControl::Force(force) => {
                finite("tangential force over the cell area", force / area)?;
            }
        }
    }
    Ok(())
}

/// What the pressure of bodies of different materials adds to the slip of each cell.
fn coupling_slip(
    bodies: &HalfSpace,
    pressed: &PressureOnWindow,
    step: WindowShift,
) -> Result<[Vec<f64>; 2]> {
    let mut drawn = try_each(|_| zeros(pressed.region.cells()))?;
    if bodies.pair().is_coupled() {
        let mut drawing = CouplingDisplacement::new(bodies, Axis::BOTH, step.size)?;
        draw(&mut drawing, pressed, step, &mut drawn);
    }
    Ok(drawn)
}

/// Writes the same with a drawing of the window.
pub(in crate::rolling) fn draw(
    drawing: &mut CouplingDisplacement,
    pressed: &PressureOnWindow,
    step: WindowShift,
    drawn: &mut [Vec<f64>; 2],
) {
    drawing.displace(pressed.pressure.iter().copied(), |axis, displacement| {
        let part = &mut drawn[axis.index()];
        part.copy_from_slice(displacement);
        step.difference(part);
    });
}
