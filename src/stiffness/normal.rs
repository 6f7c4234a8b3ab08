//! Response of the pressure of a contact to the approach.

use crate::bodies::component::Direction;
use crate::cgm::{Interval, Row};
use crate::error::Result;
use crate::grid::window::Window;
use crate::half_space::{HalfSpace, Region};
use crate::memory::fallible;
use crate::normal::{Hardness, NormalSolution};
use crate::stiffness::contact_stiffness::{NormalStiffness, window_of};
use crate::stiffness::system::{CellMotions, System};
use crate::stiffness::tangential::{ApproachSensitivity, collect};
use crate::stiffness::workspace::LinearSolveContext;
use crate::stiffness::workspace::SystemOf;

/// Computes the normal stiffness, which is zero without contact. If the window of the contact solution is known, the
/// computation uses it. Cells at the hardness carry no additional pressure. Sets `growth` to the derivative of the pressures
/// with respect to the approach.
pub(super) fn press(
    (bodies, found): (&HalfSpace, Option<Window>),
    normal: &NormalSolution,
    hardness: Option<&Hardness>,
    slot: &mut Option<SystemOf<Interval, 1>>,
    course: &mut LinearSolveContext<'_>,
    growth: &mut ApproachSensitivity,
) -> Result<NormalStiffness> {
    let is_elastic = || hardness.map_or_else(|| normal.check_elastic("the stiffness"), |_| Ok(()));
    let checked = normal.check_bodies(bodies);
    let checked = checked.and_then(|()| normal.check_uncoupled());
    bodies.collective_result(checked.and_then(|()| is_elastic()))?;
    let ApproachSensitivity {
        pressure: growth,
        follows,
        ..
    } = growth;
    growth.clear();
    fallible::resize(growth, bodies.grid().cells(), 0.0)?;
    let pressure = normal.pressure().as_slice();
    let Some(window) = bodies.around(|i| pressure[i] > 0.0) else {
        course.finish_at_once();
        return Ok(NormalStiffness {
            value: 0.0,
            bound: 0.0,
        });
    };
    let region = Region::new(bodies, window_of(bodies, found, window));
    let compliance = bodies.compliance([Direction::Z], region.window().size)?;
    let system = System::get_or_create(slot, bodies, compliance)?;
    let is_free = |i: usize| {
        let limits = hardness.map(Hardness::limits);
        let yields = limits.is_some_and(|limits| limits.are_reached(i, pressure[i]));
        f64::from(u8::from(pressure[i] > 0.0 && !yields))
    };
    collect(&region, is_free, follows)?;
    let row = |cell: usize| {
        if follows[cell] > 0.0 {
            Row::FREE
        } else {
            Row::FIXED
        }
    };
    system.hold(bodies.boundary(), row, &[])?;
    let approach = CellMotions {
        count: 1,
        of_cell: |_, _| [1.0],
    };
    let found = system.stiffness(&approach, course)?;
    let per_area = found.matrix[0][0];
    let [unit] = system.unit();
    region.scatter(unit, growth);
    Ok(NormalStiffness {
        value: per_area * bodies.grid().cell_area(),
        bound: found.bound,
    })
}
