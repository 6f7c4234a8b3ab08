//! Input of a history, checked when it is built.

use std::iter;
use std::sync::Arc;

use crate::bodies::coupling::Coupling;
use crate::cgm::{Settings, settings_methods};
use crate::error::{Error, Result};
use crate::grid::field::Field;
use crate::grid::per_cell::PerCell;
use crate::half_space::HalfSpace;
use crate::history::History;
use crate::history::state::State;
use crate::history::state::relative_displacement::RelativeDisplacementState;
use crate::memory::fallible::TryClone;
use crate::normal::Hardness;
use crate::support::checksum;
use crate::tangential::EntryRule;
use crate::tangential::{Axis, Friction, RelativeDisplacement, TangentialModel};

/// Options of a [`History`], all with defaults.
#[derive(Debug, Clone)]
#[must_use = "a builder does nothing until build() is called"]
pub struct HistoryBuilder<'a> {
    bodies: &'a HalfSpace,
    gap: Arc<Field>,
    friction: Friction,
    axis: Axis,
    model: TangentialModel,
    settings: Settings,
    coupling: Coupling,
    entry_rule: EntryRule,
    hardness: Option<Hardness>,
    relative: Option<RelativeDisplacement>,
    is_set_permanent: bool,
}

impl<'a> HistoryBuilder<'a> {
    pub(super) fn new(bodies: &'a HalfSpace, gap: Arc<Field>, friction: Friction) -> Self {
        Self {
            bodies,
            gap,
            friction,
            axis: Axis::X,
            model: TangentialModel::default(),
            settings: Settings::default(),
            coupling: Coupling::default(),
            entry_rule: EntryRule::default(),
            hardness: None,
            relative: None,
            is_set_permanent: false,
        }
    }
}

impl HistoryBuilder<'_> {
    settings_methods!(settings);

    /// Sets the axis of tangential load and tractions in the scalar model (default [`Axis::X`]). The vector model
    /// ignores the axis.
    pub fn axis(mut self, axis: Axis) -> Self {
        self.axis = axis;
        self
    }

    /// Sets the model of the tractions (default [`TangentialModel::Scalar`]). A history with
    /// [`TangentialModel::Vector`] accepts twists and loads in any direction.
    ///
    /// ```
    /// use stickslip::*;
    /// let grid = Grid::square(32, 0.30e-3)?;
    /// let steel = Material::new(213e9, 0.29)?;
    /// let bodies = HalfSpace::new(grid, ElasticPair::new(steel, steel)?)?;
    /// let ball = surface::sphere(grid, 3.5e-3)?;
    /// let friction = Friction::coulomb(0.5)?;
    /// let builder = History::builder(&bodies, &ball, friction).model(TangentialModel::Vector);
    /// let mut history = builder.build()?;
    /// history.step(&LoadStep::hold().normal(NormalLoad::Force(100.0)))?;
    ///
    /// // A force along x, then a shift along y, then a twist under both.
    /// let shear = LoadStep::hold()
    ///     .tangential(Axis::X, TangentialControl::Force(20.0))
    ///     .tangential(Axis::Y, TangentialControl::Shift(0.4e-6));
    /// history.step(&shear)?;
    /// assert!(history.tangential_force()[1] > 0.0 && history.moment().abs() < 1e-9);
    /// let twist = history.step(&shear.twist(2e-3))?;
    /// assert!(twist.moment() > 0.0 && twist.energy().dissipated_energy > 0.0);
    /// # Ok::<(), Error>(())
    /// ```
    pub fn model(mut self, model: TangentialModel) -> Self {
        self.model = model;
        self
    }

    /// Sets the model of the coupling between pressure and traction for bodies of different materials. The default,
    /// [`Coupling::Full`], is a coupled solve with both components of the traction, in the scalar and in the vector
    /// model. In the scalar model, one-way coupling acts along the axis of the tractions, and the stick
    /// radius of a pressed ball is too large ([`press`](crate::History::press)). Use the vector model.
    pub fn coupling(mut self, coupling: Coupling) -> Self {
        self.coupling = coupling;
        self
    }

    /// Sets the rule for the motion of cells that come into contact within a step (default [`EntryRule::SinceTouch`]).
    pub fn entry_rule(mut self, entry_rule: EntryRule) -> Self {
        self.entry_rule = entry_rule;
        self
    }

    /// Sets a displacement of body 1 relative to body 2 that the contact does not cause (default: none). Each step
    /// prescribes or holds [an amount](crate::LoadStep::relative_displacement) of this displacement. The amount is zero until a
    /// step prescribes it. Without such a step, the displacement has no effect on the contact, and steps with a tangential load have
    /// the warning [`UnusedRelativeDisplacement`](crate::Warning::UnusedRelativeDisplacement).
    ///
    /// The work of a change of the displacement is part of the [balance](crate::history::EnergyBalance). A cell that
    /// comes into contact within a step follows the whole change of the displacement.
    ///
    /// ```
    /// use stickslip::{*, tangential::RelativeDisplacement};
    /// // A roller on a flat specimen (body 1), under a bulk stress that then rises to 100 MPa.
    /// let titanium = Material::new(115e3, 0.32)?;
    /// let pair = ElasticPair::new(titanium, titanium)?;
    /// let grid = Grid::line(128, 0.01)?;
    /// let bodies = HalfSpace::with_boundary(grid, pair, Boundary::PeriodicAlongY { datum: 50.0 })?;
    /// let roller = surface::cylinder(grid, 20.0)?;
    /// let strain = [[titanium.plane_strain_under(1.0), 0.0], [0.0, 0.0]];
    /// let bulk = RelativeDisplacement::bulk_strain(grid, strain)?;
    /// let builder = History::builder(&bodies, &roller, Friction::coulomb(0.5)?);
    /// let mut history = builder.relative_displacement(bulk).build()?;
    /// history.step(&LoadStep::hold().normal(NormalLoad::Force(200.0)))?;
    /// let stretched = LoadStep::force([0.0, 0.0]).relative_displacement(100.0);
    /// history.step(&stretched)?;
    /// // The roller resists the stretch of the specimen: the traction points inwards on both sides, and both ends
    /// // slip.
    /// let traction = history.traction()[0];
    /// assert!(traction.get(70, 0) < Some(-1.0) && traction.get(57, 0) > Some(1.0));
    /// assert!(history.last_step()?.stick_ratio() < 1.0);
    /// # Ok::<(), Error>(())
    /// ```
    pub fn relative_displacement(mut self, relative: RelativeDisplacement) -> Self {
        self.relative = Some(relative);
        self
    }

    /// Sets the largest pressure that the cells can carry in every step (default: no limit).
    pub fn hardness(mut self, hardness: Hardness) -> Self {
        self.hardness = Some(hardness);
        self
    }

    /// Sets whether the plastic overlap under the [hardness](Self::hardness) is permanent (default: not permanent). The
    /// permanent overlap of a step is added to the gap of all following steps and to [`State::yielded`]. The next contact
    /// is elastic under the same or a smaller load. This option requires a hardness.
    ///
    /// ```
    /// use stickslip::{*, normal::Hardness};
    /// let grid = Grid::square(32, 0.30e-3)?;
    /// let steel = Material::new(213e9, 0.29)?;
    /// let bodies = HalfSpace::new(grid, ElasticPair::new(steel, steel)?)?;
    /// let ball = surface::sphere(grid, 3.5e-3)?;
    /// let builder = History::builder(&bodies, &ball, Friction::coulomb(0.5)?);
    /// let mut history = builder.hardness(Hardness::uniform(1.5e9)?).permanent_set(true).build()?;
    /// let press = |force| LoadStep::hold().normal(NormalLoad::Force(force));
    /// history.step(&press(100.0))?;
    /// let depth = history.state().yielded().map_or(0.0, Field::max);
    /// assert!(depth > 0.0 && history.pressure().max() == 1.5e9);
    /// // The first loading has caused all of the overlap.
    /// history.step(&press(20.0))?;
    /// history.step(&press(99.0))?;
    /// assert_eq!(history.state().yielded().map_or(0.0, Field::max), depth);
    /// # Ok::<(), Error>(())
    /// ```
    pub fn permanent_set(mut self, stays: bool) -> Self {
        self.is_set_permanent = stays;
        self
    }

    /// Checks the input and creates the history without solving. The gap is copied if it is shared with other owners.
    ///
    /// # Errors
    /// - [`Error::GridMismatch`] if the grid of the gap, friction, hardness or relative displacement differs.
    /// - [`Error::Sample`] if the gap is not finite, or for a bulk strain along a periodic axis.
    /// - [`Error::UnsupportedByModel`] for a relative displacement along an axis without tractions, or a permanent set without
    ///   hardness.
    /// - [`Error::Method`] if the model does not support the method.
    /// - [`Error::Tolerance`] or [`Error::IterationLimit`] if a setting is out of range.
    /// - [`Error::Ranks`] if ranks fail or pass different input.
    pub fn build(self) -> Result<History> {
        let bodies = self.bodies;
        let axes = bodies.collective_result_checked(
            self.checked(),
            &[
                ("friction", &self.friction.common()),
                ("axis", &self.axis),
                ("model", &self.model),
                ("coupling", &self.coupling),
                ("entry rule", &self.entry_rule),
                ("hardness", &self.hardness.as_ref().map(Hardness::common)),
                ("permanent set", &self.is_set_permanent),
                ("relative displacement", &self.relative.is_some()),
                ("settings", &self.settings.common()),
            ],
        )?;
        let origin = self.digest();
        let gap = Arc::try_unwrap(self.gap).or_else(|shared| shared.try_clone())?;
        let surface = (bodies.boundary(), bodies.cell_value());
        let (pair, settings) = (bodies.pair(), self.settings);
        let rule = self.entry_rule;
        let mut state = State::new(gap, surface, pair, self.friction, axes, settings, rule)?;
        state.origin = Some(origin);
        if self.is_set_permanent {
            state.yielded = Some(Field::try_zeros(bodies.grid())?);
        }
        let relative = self.relative.map(RelativeDisplacementState::new);
        (state.hardness, state.relative) = (self.hardness, relative.transpose()?);
        History::from_state(bodies, state.coupled(self.coupling)?)
    }

    /// Returns a digest of the input, which distinguishes histories whose states have equal forces and motions.
    fn digest(&self) -> u64 {
        let numbers = |values: PerCell<&[f64]>| match values {
            PerCell::Uniform(value) => checksum::of_numbers(iter::once(value)),
            PerCell::Cells(cells) => checksum::of_numbers(cells.iter().copied()),
        };
        let hardness = self.hardness.as_ref().map(Hardness::limits);
        checksum::of_shown(&(
            checksum::of_numbers(self.gap.as_slice().iter().copied()),
            numbers(self.friction.coefficients()),
            self.friction.common(),
            (hardness.map(numbers), self.is_set_permanent),
            (self.model, self.axis, self.coupling, self.entry_rule),
            self.bodies.cell_value(),
        ))
    }

    /// Checks the input and returns the axes of the tractions.
    fn checked(&self) -> Result<&'static [Axis]> {
        self.settings.check()?;
        self.model.check(&self.settings)?;
        if self.is_set_permanent && self.hardness.is_none() {
            return Err(Error::UnsupportedByModel {
                model: "a history without hardness",
                quantity: "a permanent set",
                value: 0.0,
                remedy: "set the hardness, above which cells yield",
            });
        }
        let axes = match self.model {
            TangentialModel::Scalar => self.axis.alone(),
            TangentialModel::Vector => Axis::BOTH,
        };
        let is_joint = self.coupling.is_joint(self.bodies.pair());
        if is_joint {
            TangentialModel::Vector.check(&self.settings)?;
        }
        if let Some(relative) = &self.relative {
            let found = if is_joint { Axis::BOTH } else { axes };
            relative.check(self.bodies, found)?;
        }
        if let Some(hardness) = &self.hardness {
            hardness.check(self.bodies.grid())?;
        }
        self.gap.check("gap", self.bodies.grid())?;
        self.friction.check(self.bodies.grid())?;
        Ok(axes)
    }
}
