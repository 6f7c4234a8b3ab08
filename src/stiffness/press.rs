//! How the pressure of a contact answers the approach.

use crate::cgm::{Interval, Row};
use crate::error::Result;
use crate::half_space::HalfSpace;
use crate::influence::Direction;
use crate::normal::{Hardness, NormalSolution};
use crate::stiffness::contact::{NormalStiffness, window_of};
use crate::stiffness::course::Course;
use crate::stiffness::system::{CellMotions, Stiffness, System};
use crate::stiffness::workspace::SystemOf;
use crate::window::Window;

/// The stiffness, zero without contact, on the window where the contact was found, if that is known; cells at this hardness carry no more pressure. `grow` is told by how much the
/// pressure of a cell of the grid grows for each growth of the approach.
pub(super) fn press(
    (bodies, found): (&HalfSpace, Option<Window>),
    normal: &NormalSolution,
    hardness: Option<&Hardness>,
    slot: &mut Option<SystemOf<Interval, 1>>,
    course: &mut Course<'_>,
    mut grow: impl FnMut(usize, f64),
) -> Result<NormalStiffness> {
    normal.check_bodies(bodies)?;
    normal.check_uncoupled()?;
    if hardness.is_none() {
        normal.check_elastic("the stiffness")?;
    }
    let pressure = normal.pressure().as_slice();
    let Some(window) = Window::around(bodies.grid(), |i| pressure[i] > 0.0) else {
        return Ok(NormalStiffness {
            value: 0.0,
            bound: 0.0,
        });
    };
    let window = window_of(bodies, found, window);
    let system = System::provide(slot, bodies.compliance([Direction::Z], window.size)?)?;
    let follows = |cell: usize| {
        let i = window.index(cell);
        let limits = hardness.map(Hardness::limits);
        let yields = limits.is_some_and(|limits| limits.are_reached(i, pressure[i]));
        if pressure[i] > 0.0 && !yields {
            Row::FREE
        } else {
            Row::FIXED
        }
    };
    system.hold(bodies.boundary(), follows, None::<fn(usize) -> f64>)?;
    let approach = CellMotions {
        count: 1,
        of_cell: |_, _| [1.0],
        squares: [window.cells() as f64, 0.0, 0.0],
    };
    let Stiffness { matrix, bound, .. } = system.stiffness(&approach, course)?;
    let per_area = matrix[0][0];
    system.unit(0, |cell, [unit]| grow(window.index(cell), unit * per_area));
    let value = per_area * bodies.grid().cell_area();
    Ok(NormalStiffness { value, bound })
}
