//! The tangential contact of the step under way: had for its time alone, from a pool of all histories of the same bodies
//! whose contacts have a window of the same size. The pools of sizes that a contact has left are kept for its return.

use std::sync::Arc;

use crate::bodies::component::Component;
use crate::bodies::coupling::Coupling;
use crate::contact::{HasSize, SizeCache};
use crate::error::{Error, Result};
use crate::grid::window::Window;
use crate::half_space::{HalfSpace, Region};
use crate::memory::pool::Pool;
use crate::tangential::{Axis, PressureOnWindow, TangentialIncrement};

/// Where a history has its increments from.
#[derive(Debug, Clone, Default)]
pub(in crate::history) struct IncrementPool {
    /// What all of them are made for.
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

/// What an increment is made for.
pub(in crate::history) type IncrementKind = (&'static [Axis], Coupling);

impl IncrementPool {
    /// An increment on a window, with the content of its last use.
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

    /// Takes back what [`Self::take`] gave last.
    pub(in crate::history) fn give_back(&self, mut increment: TangentialIncrement) {
        increment.rest();
        if let Some(source) = &self.sources.present {
            source.pool.give(increment);
        }
    }
}

/// The components of the half-space that an increment works with.
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
