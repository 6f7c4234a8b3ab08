//! The problem of steady rolling and the checks of its input.

use crate::error::{Error, RankFailure, Result, finite, with_remedy};
use crate::half_space::HalfSpace;
use crate::memory::fallible::{filled, try_clone, try_each, zeros};
use crate::normal::{NormalSolution, Scale};
use crate::rolling::entry::entering;
use crate::rolling::steady::options::{RollingOptions, rolling_methods};
use crate::rolling::{LeadingEdge, RollingControl, RollingSolution, RollingSolver, SpinControl};
use crate::rolling::{RollingShift, WindowShift};
use crate::support::debug::shown;
use crate::tangential::EntryRule;
use crate::tangential::{
    Axis, CouplingDisplacement, EntryCompliance, Friction, PressureOnWindow, PressureSource,
    TangentialModel, centre, contact_window, is_at_limit,
};

/// Bodies, normal contact, friction, and prescribed motion of a steady rolling contact.
#[derive(Clone)]
pub struct RollingProblem {
    pub(in crate::rolling) bodies: HalfSpace,
    pub(in crate::rolling) pressed: PressureOnWindow,
    /// Whether the pressure is a field instead of a solved contact.
    pub(in crate::rolling) is_prescribed: bool,
    /// Scales of a normal contact that the solver has computed.
    pub(in crate::rolling) scale: Scale,
    pub(in crate::rolling) friction: Friction,
    pub(in crate::rolling) options: RollingOptions,
    pub(in crate::rolling) step: WindowShift,
    /// Length rolled per step.
    pub(in crate::rolling) length: f64,
    /// Entry compliance of each cell of the window.
    pub(in crate::rolling) own: Vec<EntryCompliance>,
    /// Length of the longest chain of contact cells that are one step apart.
    pub(in crate::rolling) chain: usize,
    /// Contribution of the pressure to the slip of each cell.
    pub(in crate::rolling) drawn: [Vec<f64>; 2],
}

try_clone!(RollingProblem { pressed, friction, own, drawn } { bodies, is_prescribed, scale, options, step, length, chain });

shown!(RollingProblem: bodies, options, step);

/// Options of a [`RollingProblem`], all with defaults.
#[derive(Debug, Clone)]
#[must_use = "a builder does nothing until build() is called"]
pub struct RollingProblemBuilder<'a> {
    bodies: &'a HalfSpace,
    normal: &'a NormalSolution,
    friction: Friction,
    options: RollingOptions,
}

impl RollingProblem {
    /// Creates a builder from the required inputs: bodies, a solved normal contact on them, and friction. Without options
    /// both creepages and the spin are zero.
    pub fn builder<'a>(
        bodies: &'a HalfSpace,
        normal: &'a NormalSolution,
        friction: Friction,
    ) -> RollingProblemBuilder<'a> {
        RollingProblemBuilder {
            bodies,
            normal,
            friction,
            options: RollingOptions::default(),
        }
    }

    /// Solves the problem once. Each call allocates its own buffers.
    ///
    /// # Errors
    /// - [`Error::NotConverged`] with the report if the solve does not converge.
    /// - The errors of [`HalfSpace::operator`].
    /// - [`Error::Memory`] if memory runs out.
    pub fn solve(&self) -> Result<RollingSolution> {
        RollingSolver::solve_once(self)
    }

    /// Returns the reusable solver. Creepages, forces and spin can change between its solves, and each solve starts from
    /// the last solution.
    ///
    /// # Errors
    /// - The errors of [`HalfSpace::operator`].
    /// - [`Error::Memory`] if memory runs out.
    pub fn into_solver(self) -> Result<RollingSolver> {
        RollingSolver::new(self)
    }

    /// Returns an error if these controls cannot be prescribed.
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
        let remedy = self.friction.rolling_remedy();
        let checked = self.pressed.limits.check(force, area);
        checked.map_err(|error| with_remedy(error, remedy))?;
        check_forces(controls, self.pressed.limits.sum * area, remedy)?;
        if let SpinControl::Moment(moment) = spin {
            self.check_moment(controls, moment)?;
        }
        Ok(())
    }

    /// Returns the displacements of a grid cell over a step, at the middle of its path. They are caused by unit creepages
    /// along x and y and by a unit spin.
    pub(in crate::rolling) fn motions(&self, index: usize) -> [[f64; 2]; 3] {
        let ([x, y], [ahead_x, ahead_y]) = (centre(self.bodies.grid(), index), self.halfway());
        let middle = [x + ahead_x, y + ahead_y];
        let directions = [[1.0, 0.0], [0.0, 1.0], [-middle[1], middle[0]]];
        directions.map(|direction| direction.map(|part| self.length * part))
    }

    /// Returns half the diagonal of the window. At this distance a spin moves the particles by about as much as a
    /// creepage.
    pub(in crate::rolling) fn lever(&self) -> f64 {
        let (grid, [columns, rows]) = (self.bodies.grid(), self.pressed.window().size);
        0.5 * (columns as f64 * grid.dx()).hypot(rows as f64 * grid.dy())
    }

    /// Returns the vector from a particle to the middle of its path.
    pub(in crate::rolling) fn halfway(&self) -> [f64; 2] {
        let (edge, mut way) = (self.step.edge, [0.0; 2]);
        way[edge.axis().index()] = if edge.is_positive() { 0.5 } else { -0.5 } * self.length;
        way
    }
}

impl RollingProblemBuilder<'_> {
    rolling_methods!(options);

    /// Sets all options.
    pub(in crate::rolling) fn with_options(mut self, options: RollingOptions) -> Self {
        self.options = options;
        self
    }

    /// Checks all inputs and restricts the problem to the window of the contact.
    ///
    /// # Errors
    /// - [`Error::NotConverged`] if the normal contact has not converged.
    /// - [`Error::GridMismatch`], [`Error::BoundaryMismatch`], [`Error::CellValueMismatch`] or [`Error::MaterialMismatch`]
    ///   if the normal contact belongs to different bodies.
    /// - [`Error::EmptyContact`] if no cell carries pressure.
    /// - [`Error::NotFinite`] if a creepage, a force, the spin or the moment is not finite.
    /// - [`Error::NotPositive`] for a step of zero cells.
    /// - [`Error::UnsupportedByModel`] for rolling along an axis on which the grid is periodic, or for spin on such a grid.
    /// - [`Error::UnsupportedForCoatings`] for user-defined operators.
    /// - [`Error::GridTooShort`] if the grid ends less than a step ahead of the contact.
    /// - [`Error::BeyondFrictionCapacity`] if the forces reach or exceed the friction capacity, so that the contact slides.
    /// - [`Error::BeyondFrictionMoment`] if the moment is outside the range that friction can carry under the prescribed
    ///   forces.
    /// - [`Error::Tolerance`], [`Error::IterationLimit`] or [`Error::Method`] for invalid settings.
    /// - [`Error::Memory`] if memory runs out.
    /// - [`Error::Ranks`] if the bodies are distributed over ranks.
    pub fn build(self) -> Result<RollingProblem> {
        let Self {
            bodies,
            normal,
            friction,
            options,
        } = self;
        let grid = bodies.grid();
        if bodies.is_shared() {
            return Err(Error::Ranks(RankFailure::UnsupportedOnRanks(
                "steady rolling",
            )));
        }
        friction.check(grid)?;
        options.settings.check()?;
        TangentialModel::Vector.check(&options.settings)?;
        let travel = RollingShift::new(grid, options.edge, options.cells);
        travel.check(bodies)?;
        let samples = PressureSource::from(normal).checked(bodies)?;
        let contact = contact_window(bodies, samples)?;
        let window = contact.union(travel.shifted_upstream(contact)?);
        let step = travel.through(window.size);
        let mut pressed = PressureOnWindow::new(bodies, window)?;
        pressed.set(samples, &friction);
        let mut own = filled(EntryCompliance::NONE, pressed.region.cells())?;
        if options.entry_rule == EntryRule::SinceTouch {
            entering(normal, &pressed, step, &mut own);
        }
        let problem = RollingProblem {
            own,
            drawn: coupling_slip(bodies, &pressed, step)?,
            chain: step.chain(contact.size[options.edge.axis().index()]),
            bodies: bodies.clone(),
            pressed,
            is_prescribed: false,
            scale: Scale::default(),
            friction,
            options,
            step,
            length: travel.length,
        };
        problem.check(options.controls, options.spin)?;
        Ok(problem)
    }
}

/// Returns an error if prescribed forces reach the largest force that friction can carry. The creepage would be undetermined
/// because the whole contact slides.
pub(in crate::rolling) fn check_forces(
    controls: [RollingControl; 2],
    limit: f64,
    remedy: &'static str,
) -> Result<()> {
    let force = controls.map(|control| match control {
        RollingControl::Force(force) => force,
        RollingControl::Creepage(_) => 0.0,
    });
    let size = force[0].hypot(force[1]);
    let is_force = |control: &RollingControl| matches!(control, RollingControl::Force(_));
    if controls.iter().any(is_force) && is_at_limit(size, limit) {
        return Err(Error::BeyondFrictionCapacity {
            force: size,
            limit,
            remedy,
        });
    }
    Ok(())
}

/// Checks that the prescribed motion is valid for steps of this length, independently of the pressure.
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
            remedy: "a periodic grid does not allow rotation in any model",
        });
    }
    let (grid, area) = (bodies.grid(), bodies.grid().cell_area());
    if let SpinControl::Spin(spin) = spin {
        let extent = (grid.dx() * grid.nx() as f64).hypot(grid.dy() * grid.ny() as f64);
        finite("rotation of a step due to the spin", spin * extent * length)?;
    }
    for control in controls {
        match control {
            RollingControl::Creepage(creepage) => {
                finite("creepage of a step", creepage * length)?;
            }
            RollingControl::Force(force) => {
                finite("tangential force divided by the cell area", force / area)?;
            }
        }
    }
    Ok(())
}

/// Returns the contribution of the pressure to the slip of each cell. The contribution is zero for bodies of the same
/// material.
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

/// Writes the contribution of the pressure to the slip with the existing coupling operator of the window.
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
