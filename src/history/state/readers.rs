//! Read access to the state of a history.

use crate::bodies::coupling::Coupling;
use crate::bodies::material::ElasticPair;
use crate::cgm::Settings;
use crate::error::{Error, Result};
use crate::grid::Grid;
use crate::grid::boundary::Boundary;
use crate::grid::field::Field;
use crate::history::{History, State, StepResult};
use crate::memory::fallible::TryClone;
use crate::normal::{Hardness, NormalSolution};
use crate::tangential::{self, Axis, EntryRule, Friction, Zone};

/// Defines methods of a state that return a value, and the same methods of a history.
macro_rules! readers {
    ($state:ident; $($(#[$attribute:meta])* $name:ident: $value:ty = $read:expr;)+) => {
        impl State {
            $(
                $(#[$attribute])*
                #[must_use]
                pub fn $name(&self) -> $value {
                    let $state = self;
                    $read
                }
            )+
        }

        impl History {
            $(
                $(#[$attribute])*
                #[must_use]
                pub fn $name(&self) -> $value {
                    self.state.$name()
                }
            )+
        }
    };
}

readers! { state;
    /// Returns the boundary condition at the edge of the grid.
    boundary: Boundary = state.normal.boundary();

    /// Returns the grid of all fields.
    grid: Grid = state.gap.grid();

    /// Returns the axis of tangential load and tractions in the scalar model, or `None` in the vector model.
    axis: Option<Axis> = Axis::only(state.axes);

    /// Returns the settings of the next step.
    settings: &Settings = &state.settings;

    /// Returns the friction of the next step.
    friction: &Friction = &state.friction;

    /// Returns the gap before loading (lengths), which is the last gap set plus the [plastic depth](State::yielded). A program
    /// that changes this gap and sets it again would add the plastic depth twice. Such a program reads
    /// [`gap_as_set`](State::gap_as_set). The gap of the [normal contact](Self::normal) is the gap under load.
    unloaded_gap: &Field = &state.gap;

    /// Returns the normal contact: pressure, approach, gap under load, contact area and warnings.
    normal: &NormalSolution = &state.normal;

    /// Returns the pressure p >= 0, which is exactly zero outside the contact.
    pressure: &Field = state.normal.pressure();

    /// Returns the approach of the bodies from the datum of the gap (a length).
    approach: f64 = state.normal.approach();

    /// Returns the shear traction q on body 1 (pressures), positive along the axes. The traction is exactly zero
    /// outside the contact.
    #[doc(alias = "shear stress")]
    traction: [&Field; 2] = state.traction.each_ref();

    /// Returns the sum of the signed slips of all steps (lengths). After rolling, the sums belong to the particles.
    slip: [&Field; 2] = state.slip.each_ref();

    /// Returns the accumulated slip, the length of the slip path in all steps (lengths, non-negative). After rolling,
    /// this length belongs to the particles.
    accumulated_slip: &Field = &state.accumulated_slip;

    /// Returns the energy that each cell has dissipated in all steps (energies, force times length, non-negative). It is the sum
    /// of [`StepResult::dissipation`](crate::history::StepResult::dissipation), from which the wear of a step is computed.
    #[doc(alias = "dissipated energy")]
    accumulated_dissipation: &Field = &state.dissipated_energy;

    /// Returns the zone of every cell after the last step, row-major with x fastest.
    zones: &[Zone] = &state.zones;

    /// Returns the ratio of stick cells to contact cells after the last step. The ratio is zero without contact and before
    /// the first step.
    stick_ratio: f64 = ratio(state.zone_cells);

    /// Returns the shift of body 2 relative to body 1 since the start (lengths).
    shift: [f64; 2] = state.motion.shift;

    /// Returns the rotation of body 2 relative to body 1 since the start (radians, positive from x to y).
    twist: f64 = state.motion.twist;

    /// Returns the tangential force that body 2 exerts on body 1.
    tangential_force: [f64; 2] = state.force;

    /// Returns the moment of the tractions on body 1 about the origin of the grid (force times length, positive from x
    /// to y).
    moment: f64 = state.moment;

    /// Returns the number of steps taken since the start.
    steps: u64 = state.steps;
}

/// Returns the ratio of stick cells to all cells of both zones, or zero without cells.
pub(in crate::history) fn ratio([stick, slip]: [usize; 2]) -> f64 {
    stick as f64 / (stick + slip).max(1) as f64
}

impl State {
    /// Returns the materials of the two bodies.
    #[must_use]
    pub fn pair(&self) -> &ElasticPair {
        self.normal.pair()
    }

    /// Returns the hardness, which limits the pressure of every step. Returns `None` if the history has no hardness.
    #[must_use]
    pub fn hardness(&self) -> Option<&Hardness> {
        self.hardness.as_ref()
    }

    /// Returns the [relative displacement](crate::history::HistoryBuilder::relative_displacement) of body 1 after the
    /// last step (lengths, `[x, y]`). The contact does not cause this displacement. Returns `None` if the history has
    /// no relative displacement.
    #[must_use]
    pub fn relative_displacement(&self) -> Option<[&Field; 2]> {
        let relative = self.relative.as_ref();
        relative.map(|relative| relative.reached.fields())
    }

    /// Returns the accumulated plastic depth since the start (lengths, non-negative). Returns `None` unless the depth
    /// is [permanent](crate::history::HistoryBuilder::permanent_set).
    #[must_use]
    pub fn yielded(&self) -> Option<&Field> {
        self.yielded.as_ref()
    }

    /// Computes the gap before loading without the [plastic depth](Self::yielded) (lengths): the gap that was given to the
    /// builder or last set by [`History::set_gap`]. The result is accurate to round-off with a permanent set, and exact
    /// otherwise.
    ///
    /// ```
    /// use stickslip::normal::Hardness;
    /// use stickslip::*;
    /// let grid = Grid::square(32, 3.0)?;
    /// let bodies = HalfSpace::new(grid, ElasticPair::new(Material::new(1.0, 0.3)?, Material::rigid())?)?;
    /// let (ball, hardness) = (surface::sphere(grid, 10.0)?, Hardness::uniform(0.05)?);
    /// let builder = History::builder(&bodies, &ball, Friction::coulomb(0.3)?);
    /// let mut history = builder.hardness(hardness).permanent_set(true).build()?;
    /// history.step(&LoadStep::hold().normal(NormalLoad::Force(0.1)))?;
    /// let depth = history.state().yielded().map_or(0.0, Field::max);
    /// assert!(depth > 0.0 && history.unloaded_gap().min() > 0.9 * depth);
    ///
    /// // Wear changes the gap as it was set. The history adds the plastic depth.
    /// let mut gap = history.gap_as_set()?;
    /// assert!((gap.min() - ball.min()).abs() < 1e-12);
    /// gap.add_scaled(1e-3, &Field::constant(grid, 1.0))?;
    /// history.set_gap(&gap)?;
    /// # Ok::<(), Error>(())
    /// ```
    ///
    /// # Errors
    /// - [`Error::Memory`] if memory runs out.
    pub fn gap_as_set(&self) -> Result<Field> {
        let mut gap = self.gap.try_clone()?;
        if let Some(yielded) = &self.yielded {
            gap.add_scaled(-1.0, yielded)?;
        }
        Ok(gap)
    }

    /// Returns the rule for the motion of cells that come into contact within a step.
    #[must_use]
    pub fn entry_rule(&self) -> EntryRule {
        self.entry_rule
    }

    /// Returns the model of the coupling between pressure and traction. The model has an effect only if the bodies are
    /// coupled ([`ElasticPair::is_coupled`]).
    #[must_use]
    pub fn coupling(&self) -> Coupling {
        self.coupling
    }

    /// Returns whether the gap has changed since the last pressure solve. A step that holds the pressure then has the
    /// warning [`Warning::StalePressure`](crate::Warning::StalePressure).
    #[must_use]
    pub fn is_pressure_stale(&self) -> bool {
        self.is_pressure_stale
    }

    /// Returns whether [`set_friction`](crate::History::set_friction) has changed the friction limits in the contact since the
    /// last step. The tractions then belong to the previous friction.
    #[must_use]
    pub fn is_friction_new(&self) -> bool {
        self.is_friction_new
    }
}

impl History {
    /// Computes the last gap that was set, without the plastic depth ([`State::gap_as_set`]).
    ///
    /// # Errors
    /// - [`Error::Memory`] if memory runs out.
    pub fn gap_as_set(&self) -> Result<Field> {
        self.state.gap_as_set()
    }

    /// Returns the result of the last step, which led to the present state.
    ///
    /// # Errors
    /// - [`Error::NoLastStep`] before the first step, and after [`History::set_state`], [`History::from_state`] and
    ///   [`History::from_bytes`]. A state does not contain the result of its last step.
    pub fn last_step(&self) -> Result<&StepResult> {
        if self.has_last_step {
            Ok(&self.step)
        } else {
            Err(Error::NoLastStep)
        }
    }

    /// Computes the displacement of the surface of body 1 relative to the surface of body 2 due to the tractions
    /// (lengths). The result covers all cells, inside and outside the contact. The bodies cache the operators that this
    /// call creates. The displacement due to the pressure is part of the result under [`Coupling::Full`].
    ///
    /// # Errors
    /// - Errors of [`HalfSpace::operator`](crate::HalfSpace::operator).
    /// - [`Error::Ranks`] if ranks fail.
    pub fn displacement(&self) -> Result<[Field; 2]> {
        if let Some(memory) = self
            .state
            .contact
            .as_ref()
            .filter(|_| self.state.is_joint())
        {
            return memory.fields(self.grid());
        }
        tangential::displacement(&self.bodies, self.state.axes, self.traction())
    }

    /// Returns the largest tangential force that friction can carry at the present pressure (a force), the integral of
    /// the friction limit.
    #[must_use]
    pub fn friction_capacity(&self) -> f64 {
        let alone = || self.state.capacity_with(&self.bodies, self.friction());
        self.state.capacity.unwrap_or_else(alone)
    }
}
