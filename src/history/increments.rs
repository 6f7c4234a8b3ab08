//! The tangential contact of the step under way: had for its time alone, from a pool of all histories of the same bodies
//! whose contacts have a window of the same size. The pools of sizes that a contact has left are kept for its return.

use std::sync::Arc;

use crate::coupling::Coupling;
use crate::error::Result;
use crate::half_space::{HalfSpace, Region};
use crate::influence::Component;
use crate::kept::Kept;
use crate::pool::Pool;
use crate::tangential::{Axis, Increment, Pressed};
use crate::window::Window;

/// Where a history has its increments from.
#[derive(Debug, Clone, Default)]
pub(super) struct Increments {
    source: Option<Source>,
    /// Those of other sizes.
    kept: Kept<Source>,
}

#[derive(Debug, Clone)]
struct Source {
    kind: Kind,
    size: [usize; 2],
    pool: Arc<Pool<Increment>>,
}

/// What an increment is made for.
pub(super) type Kind = (&'static [Axis], Coupling);

impl Increments {
    /// An increment on a window, with the content of its last use.
    pub(super) fn take(
        &mut self,
        bodies: &HalfSpace,
        kind: Kind,
        window: Window,
    ) -> Result<Increment> {
        self.kept.age();
        let fits = |source: &Source| (source.kind, source.size) == (kind, window.size);
        let source = match self.source.take() {
            Some(source) if fits(&source) => source,
            left => {
                let source = match self.kept.take(window.size).filter(fits) {
                    Some(source) => source,
                    None => Source {
                        kind,
                        size: window.size,
                        pool: bodies.pool(components(bodies, kind), window.size)?,
                    },
                };
                if let Some(left) = left {
                    self.kept.leave(left.size, left, window.size);
                }
                source
            }
        };
        let pool = &self.source.insert(source).pool;
        match pool.take() {
            Some(mut increment) => {
                increment.pressed.region = Region::new(bodies, window);
                Ok(increment)
            }
            None => Increment::new(bodies, kind.0, Pressed::new(bodies, window), kind.1),
        }
    }

    /// Takes back what [`Self::take`] gave last.
    pub(super) fn give_back(&self, mut increment: Increment) {
        increment.rest();
        if let Some(source) = &self.source {
            source.pool.give(increment);
        }
    }
}

/// The components of the half-space that an increment works with.
fn components(bodies: &HalfSpace, (axes, coupling): Kind) -> &'static [Component] {
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
