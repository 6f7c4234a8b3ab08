//! What a history starts from, checked once.

use std::sync::Arc;

use crate::bodies::coupling::Coupling;
use crate::cgm::{Settings, settings_methods};
use crate::error::Result;
use crate::grid::field::Field;
use crate::half_space::HalfSpace;
use crate::history::History;
use crate::history::state::State;
use crate::history::state::relative_displacement::RelativeDisplacementState;
use crate::memory::fallible::TryClone;
use crate::normal::Hardness;
use crate::tangential::EntryRule;
use crate::tangential::{Axis, Friction, RelativeDisplacement, TangentialModel};

/// Options of a [`History`]; each has a default.
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
    settings_methods!();

    /// The axis of tangential load and tractions (default [`Axis::X`]); the vector model has none.
    pub fn axis(mut self, axis: Axis) -> Self {
        self.axis = axis;
        self
    }

    /// Which tractions are found (default [`TangentialModel::Scalar`]). With [`TangentialModel::Vector`] a history
    /// takes loads of any direction and twist.
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
    /// history.step(&LoadStep::hold().normal(NormalControl::Force(100.0)))?;
    ///
    /// // A force along x, a shift along y, then a turn under both.
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

    /// How much is modelled of the coupling between pressure and traction in bodies of different materials (default
    /// [`Coupling::Full`]: they are found together, with both tractions whatever the model). One-way coupling in the scalar
    /// model is that along its axis.
    pub fn coupling(mut self, coupling: Coupling) -> Self {
        self.coupling = coupling;
        self
    }

    /// How far a cell that comes into contact within a step follows its motion (default
    /// [`EntryRule::SinceTouch`]).
    pub fn entry_rule(mut self, entry_rule: EntryRule) -> Self {
        self.entry_rule = entry_rule;
        self
    }

    /// A displacement of body 1 relative to body 2 that the contact does not cause, which steps reach to
    /// [an amount](crate::LoadStep::relative_displacement) (default: none).
    ///
    /// Its work on the tractions is part of the [balance](crate::history::EnergyBalance). A cell that comes into contact
    /// within a step follows all of its change.
    ///
    /// ```
    /// use stickslip::{*, tangential::RelativeDisplacement};
    /// // A roller on a flat specimen, body 1, whose bulk stress then rises to 100 MPa.
    /// let titanium = Material::new(115e3, 0.32)?;
    /// let pair = ElasticPair::new(titanium, titanium)?;
    /// let grid = Grid::line(128, 0.01)?;
    /// let bodies = HalfSpace::with_boundary(grid, pair, Boundary::PeriodicAlongY { datum: 50.0 })?;
    /// let roller = surface::cylinder(grid, 20.0)?;
    /// let strain = [[titanium.plane_strain_under(1.0), 0.0], [0.0, 0.0]];
    /// let bulk = RelativeDisplacement::bulk_strain(grid, strain)?;
    /// let builder = History::builder(&bodies, &roller, Friction::coulomb(0.5)?);
    /// let mut history = builder.relative_displacement(bulk).build()?;
    /// history.step(&LoadStep::hold().normal(NormalControl::Force(200.0)))?;
    /// let stretched = LoadStep::force([0.0, 0.0]).relative_displacement(100.0);
    /// history.step(&stretched)?;
    /// // The roller holds the specimen back: traction inwards on both sides, slip at both ends.
    /// let traction = history.traction()[0];
    /// assert!(traction.get(70, 0) < Some(-1.0) && traction.get(57, 0) > Some(1.0));
    /// assert!(history.last_step().stick_ratio() < 1.0);
    /// # Ok::<(), Error>(())
    /// ```
    pub fn relative_displacement(mut self, relative: RelativeDisplacement) -> Self {
        self.relative = Some(relative);
        self
    }

    /// The largest pressure the cells carry in every step (default: no limit).
    pub fn hardness(mut self, hardness: Hardness) -> Self {
        self.hardness = Some(hardness);
        self
    }

    /// Whether what yields under the [hardness](Self::hardness) stays (default: it does not): the overlap of a step is then
    /// added to the gap of all that follow and to [`State::yielded`], and the same load, or less, is elastic the next time.
    /// Without a hardness nothing yields.
    ///
    /// ```
    /// use stickslip::{*, normal::Hardness};
    /// let grid = Grid::square(32, 0.30e-3)?;
    /// let steel = Material::new(213e9, 0.29)?;
    /// let bodies = HalfSpace::new(grid, ElasticPair::new(steel, steel)?)?;
    /// let ball = surface::sphere(grid, 3.5e-3)?;
    /// let builder = History::builder(&bodies, &ball, Friction::coulomb(0.5)?);
    /// let mut history = builder.hardness(Hardness::uniform(1.5e9)?).permanent_set(true).build()?;
    /// let press = |force| LoadStep::hold().normal(NormalControl::Force(force));
    /// history.step(&press(100.0))?;
    /// let depth = history.state().yielded().map_or(0.0, Field::max);
    /// assert!(depth > 0.0 && history.pressure().max() == 1.5e9);
    /// // The first loading has done it all.
    /// history.step(&press(20.0))?;
    /// history.step(&press(99.0))?;
    /// assert_eq!(history.state().yielded().map_or(0.0, Field::max), depth);
    /// # Ok::<(), Error>(())
    /// ```
    pub fn permanent_set(mut self, stays: bool) -> Self {
        self.is_set_permanent = stays;
        self
    }

    /// Checks everything, and copies the gap if others hold it; nothing is solved yet.
    ///
    /// # Errors
    /// [`Error::GridMismatch`](crate::Error::GridMismatch) for gap, friction, hardness or relative displacement,
    /// [`Error::Sample`](crate::Error::Sample) for the gap and for a bulk strain along an axis on which the grid repeats, [`Error::UnsupportedByModel`](crate::Error::UnsupportedByModel) for
    /// a relative displacement along an axis of which no traction is found,
    /// [`Error::Method`](crate::Error::Method) for a method that the model does not have,
    /// [`Error::Tolerance`](crate::Error::Tolerance), [`Error::IterationLimit`](crate::Error::IterationLimit); [`Error::Ranks`](crate::Error::Ranks).
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
        let gap = Arc::try_unwrap(self.gap).or_else(|shared| shared.try_clone())?;
        let surface = (bodies.boundary(), bodies.cell_value());
        let (pair, settings) = (bodies.pair(), self.settings);
        let rule = self.entry_rule;
        let state = State::new(gap, surface, pair, self.friction, axes, settings, rule)?;
        let mut state = state.limited(self.hardness, self.is_set_permanent)?;
        state.relative = self
            .relative
            .map(RelativeDisplacementState::new)
            .transpose()?;
        History::from_state(bodies, state.coupled(self.coupling)?)
    }

    /// The axes of the tractions, if everything is right.
    fn checked(&self) -> Result<&'static [Axis]> {
        self.settings.check()?;
        self.model.check(&self.settings)?;
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
