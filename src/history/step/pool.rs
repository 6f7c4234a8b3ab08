//! Pool of the tangential contacts of steps.
//!
//! A step borrows a tangential contact from a pool for the duration of the step. A pool serves all histories of the
//! same bodies with windows of the same size. Pools for earlier window sizes are kept in case a contact returns to
//! them.

use std::sync::Arc;

use crate::bodies::component::Component;
use crate::bodies::coupling::Coupling;
use crate::contact::{HasSize, SizeCache};
use crate::error::{Error, Result};
use crate::grid::window::Window;
use crate::half_space::{HalfSpace, Region};
use crate::memory::pool::Pool;
use crate::tangential::{Axis, PressureOnWindow, TangentialIncrement};

/// Source of the increments of a history.
#[derive(Debug, Clone, Default)]
pub(in crate::history) struct IncrementPool {
    /// Axes and coupling of the increments.
    kind: Option<IncrementKind>,
    sources: SizeCache<Source>,
}

#[derive(Debug, Clone)]
struct Source {
    size: [usize; 2],
    pool: Arc<Pool<TangentialIncrement>>,
}

impl HasSize for Source {
    fn size(&self) -> [usize; 2] {
        self.size
    }
}

/// Axes and coupling for which an increment is created.
pub(in crate::history) type IncrementKind = (&'static [Axis], Coupling);

impl IncrementPool {
    /// Takes an increment on a window, with arbitrary content from its last use.
    pub(in crate::history) fn take(
        &mut self,
        bodies: &HalfSpace,
        kind: IncrementKind,
        window: Window,
    ) -> Result<TangentialIncrement> {
        if self.kind != Some(kind) {
            *self = Self {
                kind: Some(kind),
                ..Self::default()
            };
        }
        self.sources.tick();
        let size = window.size;
        let make = || {
            let pool = bodies.pool(components(bodies, kind), size)?;
            Ok::<_, Error>(Source { size, pool })
        };
        let pool = &self.sources.get_or_create(size, make)?.pool;
        match pool.take() {
            Some(mut increment) => {
                increment.pressed.region = Region::new(bodies, window);
                Ok(increment)
            }
            None => TangentialIncrement::new(
                bodies,
                kind.0,
                PressureOnWindow::new(bodies, window)?,
                kind.1,
            ),
        }
    }

    /// Returns the increment last taken from [`Self::take`] to its pool.
    pub(in crate::history) fn give_back(&self, mut increment: TangentialIncrement) {
        increment.rest();
        if let Some(source) = &self.sources.present {
            source.pool.give(increment);
        }
    }
}

/// Returns the components of the half-space that an increment uses.
fn components(bodies: &HalfSpace, (axes, coupling): IncrementKind) -> &'static [Component] {
    use Component::{XX, XY, XZ, YY, YZ};
    match (axes, coupling.is_one_way(bodies.pair())) {
        ([Axis::X], false) => &[XX],
        ([Axis::X], true) => &[XX, XZ],
        ([Axis::Y], false) => &[YY],
        ([Axis::Y], true) => &[YY, YZ],
        (_, false) => &[XX, XY, YY],
        (_, true) => &[XX, XY, YY, XZ, YZ],
    }
}
