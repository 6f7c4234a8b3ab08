//! Normal displacement caused by tractions, for bodies of different materials.

use crate::bodies::component::{Component, Direction};
use crate::cgm::reduce;
use crate::error::Result;
use crate::half_space::HalfSpace;
use crate::memory::fallible;
use crate::parallel::layout::Layout;
use crate::tangential::Axis;
use crate::tangential::one_way::CrossOperator;

/// Operator of the normal displacement that tractions on a window cause.
#[derive(Debug, Clone)]
pub(crate) struct Lifting {
    /// Operators for the tractions along each axis.
    parts: [CrossOperator; 2],
    displacement: Vec<f64>,
}

impl Lifting {
    pub(crate) fn new(bodies: &HalfSpace, size: [usize; 2]) -> Result<Self> {
        let parts = fallible::try_each(|axis| {
            let component = Component::of(Direction::Z, Axis::BOTH[axis].direction());
            CrossOperator::new(bodies, component, size)
        })?;
        Ok(Self {
            parts,
            displacement: fallible::zeros(bodies.layout(size).cells())?,
        })
    }

    /// Writes the normal displacement that tractions along x and y cause. A component that the model omits is `None`. The products
    /// are collective, so a rank without cells also takes part.
    pub(crate) fn lift(&mut self, traction: [Option<&[f64]>; 2], lift: &mut [f64]) {
        lift.fill(0.0);
        let added = &mut self.displacement;
        for (part, traction) in self.parts.iter_mut().zip(traction) {
            if let Some(traction) = traction {
                part.apply(traction, added);
                for (lift, added) in lift.iter_mut().zip(&*added) {
                    *lift += *added;
                }
            }
        }
    }
}

/// Returns the residual of the normal law due to the lift (the normal displacement due to tractions). The residual is
/// half the range of the lift within the contact, relative to the largest normal displacement. It uses the range
/// because a uniform lift changes only the approach. Under a prescribed approach (`is_fixed`) the residual uses the
/// largest lift instead of half the range.
pub(crate) fn lift_residual(
    layout: &Layout,
    is_contact: impl Fn(usize) -> bool + Sync,
    lift: impl Fn(usize) -> f64 + Sync,
    normal_displacement: impl Fn(usize) -> f64 + Sync,
    is_fixed: bool,
) -> f64 {
    let largest = reduce::max(layout, |i| {
        if is_contact(i) {
            normal_displacement(i).abs()
        } else {
            0.0
        }
    });
    let extreme = |sign: f64| {
        let found = reduce::least(layout, |i| is_contact(i).then(|| (sign * lift(i), ())));
        found.map_or(0.0, |(least, ())| least)
    };
    let (least, negated_most) = (extreme(1.0), extreme(-1.0));
    let size = if is_fixed {
        (-least).max(-negated_most)
    } else {
        -0.5 * (least + negated_most)
    };
    if size > 0.0 { size / largest } else { 0.0 }
}
