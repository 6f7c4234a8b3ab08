//! Steps of many contacts in one call.

use std::ops::Deref;

use crate::error::{Error, Result, length};
use crate::history::{History, LoadStep};
use crate::parallel::{self, Blocks};

/// Indices and errors of the contacts whose step failed in [`History::step_all`], in the order of the contacts. This type
/// dereferences to a slice.
#[derive(Debug, Clone, PartialEq)]
#[must_use = "contacts whose step failed are unchanged"]
pub struct StepFailures(Vec<(usize, Error)>);

impl Deref for StepFailures {
    type Target = [(usize, Error)];

    fn deref(&self) -> &Self::Target {
        &self.0
    }
}

impl IntoIterator for StepFailures {
    type Item = (usize, Error);
    type IntoIter = std::vec::IntoIter<Self::Item>;

    fn into_iter(self) -> Self::IntoIter {
        self.0.into_iter()
    }
}

impl<'a> IntoIterator for &'a StepFailures {
    type Item = &'a (usize, Error);
    type IntoIter = std::slice::Iter<'a, (usize, Error)>;

    fn into_iter(self) -> Self::IntoIter {
        self.0.iter()
    }
}

impl History {
    /// Takes one step of each contact, `loads[i]` for `histories[i]`, on the threads of the caller's pool. Returns the
    /// indices and errors of the contacts whose step failed. The compiler warns if a program ignores them.
    ///
    /// The result of each contact is bitwise identical to its result alone. A contact whose step fails is unchanged,
    /// and the other contacts take their steps. Each contact of at most [`SERIAL_CELL_LIMIT`](crate::SERIAL_CELL_LIMIT)
    /// cells is solved on one thread. Larger contacts share the threads. The time limit of a larger contact may
    /// therefore run while its thread works on another contact. Distributed contacts are solved one after the other. A
    /// call allocates the memory for its steps. If steps fail, it also allocates the memory for the list of failures.
    ///
    /// # Errors
    /// - [`Error::Length`] before any step if the number of loads differs from the number of contacts.
    ///
    /// ```
    /// use stickslip::*;
    /// let grid = Grid::square(32, 0.30e-3)?;
    /// let steel = Material::new(213e9, 0.29)?;
    /// let bodies = HalfSpace::new(grid, ElasticPair::new(steel, steel)?)?;
    /// let balls = [2e-3, 3e-3, 4e-3].map(|radius| surface::sphere(grid, radius));
    /// let mut contacts = Vec::new();
    /// for ball in balls {
    ///     contacts.push(History::builder(&bodies, &ball?, Friction::coulomb(0.5)?).build()?);
    /// }
    /// let press = LoadStep::hold().normal(NormalLoad::Force(50.0));
    /// assert!(History::step_all(&mut contacts, &[press; 3])?.is_empty());
    /// // Hertz: the approach is proportional to the inverse cube root of the radius.
    /// let ratio = contacts[0].approach() / contacts[2].approach();
    /// assert!((ratio / 2_f64.cbrt() - 1.0).abs() < 2e-3);
    ///
    /// // Friction carries 25 newtons in each contact.
    /// let drag = |force| LoadStep::hold().tangential(Axis::X, TangentialControl::Force(force));
    /// let failed = History::step_all(&mut contacts, &[drag(10.0), drag(30.0), drag(20.0)])?;
    /// assert!(matches!(failed[..], [(1, Error::BeyondFrictionCapacity { .. })]));
    /// assert_eq!(contacts[1].tangential_force(), [0.0, 0.0]);
    /// # Ok::<(), Error>(())
    /// ```
    pub fn step_all(histories: &mut [Self], loads: &[LoadStep]) -> Result<StepFailures> {
        let count = histories.len();
        length("list of loads", count, loads.len())?;
        if count == 0 {
            return Ok(StepFailures(Vec::new()));
        }
        let is_shared = histories.iter().any(|history| history.bodies.is_shared());
        let contacts = Blocks {
            items: histories,
            width: 1,
        };
        let step = |i: usize, contact: Blocks<'_, Self>| {
            let outcome = contact.items[0].step(&loads[i]);
            Vec::from_iter(outcome.err().map(|error| (i, error)))
        };
        let both = |mut one: Vec<_>, other: Vec<_>| {
            one.extend(other);
            one
        };
        // All ranks must solve distributed contacts in the same order.
        Ok(StepFailures(if is_shared {
            parallel::in_turn(0..count, contacts, &step, &both)
        } else {
            parallel::enter(|| parallel::sweep(0..count, contacts, &step, &both))
        }))
    }
}
