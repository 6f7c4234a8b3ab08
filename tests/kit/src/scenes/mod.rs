//! Difficult scenes: their definition, their solution, and the verification of the solutions.

pub mod campaign;
pub mod catalogue;
mod closed_forms;
mod compliance;
mod draw;
mod gaps;
mod judge;
pub mod kinds;
mod oracle;
pub mod row;
mod steps;
pub mod targets;

use stickslip::cgm::Method;
use stickslip::cgm::Settings;
use stickslip::{Field, Friction, HalfSpace, NormalLoad, TangentialModel};

/// A normal contact, and the tangential contacts under its pressure.
#[derive(Debug)]
pub(crate) struct RandomScene {
    pub(crate) name: String,
    pub(crate) bodies: HalfSpace,
    pub(crate) gap: Field,
    pub(crate) load: NormalLoad,
    pub(crate) settings: Settings,
    pub(crate) expected: Expected,
    /// Problem that the same solver solves first.
    pub(crate) before: Option<(Field, NormalLoad)>,
    pub(crate) shears: Vec<Shear>,
}

/// A tangential contact.
#[derive(Debug)]
pub(crate) struct Shear {
    pub(crate) name: String,
    pub(crate) friction: Friction,
    pub(crate) demand: Demand,
    pub(crate) lateral: TangentialModel,
    pub(crate) expected: Expected,
}

impl Shear {
    /// Returns the requested method if the model supports it, and the active-set method otherwise.
    pub(crate) fn method(&self, asked: Method) -> Method {
        match self.lateral {
            TangentialModel::Vector => Method::ActiveSet,
            _ => asked,
        }
    }
}

/// A tangential load that fits any pressure.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Demand {
    /// Fractions of the sliding force.
    Force([f64; 2]),
    /// Fractions of the largest displacement caused by tractions at the friction limit.
    Shift([f64; 2]),
}

/// Expected ending of a solve.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Expected {
    /// Converged.
    Answer,
    /// Converged, or stalled at round-off.
    AnswerOrRoundOff,
    /// Rejected with this variant of the error.
    Refused(&'static str),
}

impl RandomScene {
    /// Creates a scene with default settings that must converge, without tangential contacts.
    pub(crate) fn new(
        name: impl Into<String>,
        bodies: &HalfSpace,
        gap: Field,
        load: NormalLoad,
    ) -> Self {
        Self {
            name: name.into(),
            bodies: bodies.clone(),
            gap,
            load,
            settings: Settings::default(),
            expected: Expected::Answer,
            before: None,
            shears: Vec::new(),
        }
    }

    pub(crate) fn tolerance(mut self, tolerance: f64) -> Self {
        self.settings = self.settings.tolerance(tolerance);
        self
    }

    pub(crate) fn expect(mut self, expected: Expected) -> Self {
        self.expected = expected;
        self
    }

    pub(crate) fn after(mut self, gap: Field, load: NormalLoad) -> Self {
        self.before = Some((gap, load));
        self
    }

    pub(crate) fn shear(mut self, shear: Shear) -> Self {
        self.shears.push(shear);
        self
    }

    /// Adds tangential contacts: along x in the scalar model, and oblique in the vector model.
    pub(crate) fn sheared(self, coefficient: f64, part: f64) -> stickslip::Result<Self> {
        let friction = Friction::coulomb(coefficient)?;
        Ok(self
            .shear(Shear::new("", friction.clone(), Demand::Force([part, 0.0])))
            .shear(Shear::new("", friction, Demand::Force([0.8 * part, -0.6 * part])).in_plane()))
    }
}

impl Shear {
    pub(crate) fn new(name: impl Into<String>, friction: Friction, demand: Demand) -> Self {
        Self {
            name: name.into(),
            friction,
            demand,
            lateral: TangentialModel::Scalar,
            expected: Expected::Answer,
        }
    }

    pub(crate) fn in_plane(mut self) -> Self {
        self.lateral = TangentialModel::Vector;
        self
    }

    pub(crate) fn expect(mut self, expected: Expected) -> Self {
        self.expected = expected;
        self
    }
}
