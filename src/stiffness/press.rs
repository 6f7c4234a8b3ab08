//! How the pressure of a contact answers the approach.

use crate::buffer;
use crate::error::Result;
use crate::half_space::HalfSpace;
use crate::influence::Direction;
use crate::normal::{Hardness, NormalSolution};
use crate::stiffness::contact::NormalStiffness;
use crate::stiffness::system::{Freedom, Stiffness, System};
use crate::watch::Watch;
use crate::window::Window;

/// How the pressure answers the approach.
pub(super) struct Press {
    pub(super) window: Window,
    pub(super) stiffness: NormalStiffness,
    /// Growth of the pressure of the cells of the window, for each growth of the approach.
    pub(super) growth: Vec<f64>,
}

/// `None` without contact. Cells at this hardness carry no more pressure.
pub(super) fn pressed(
    bodies: &HalfSpace,
    normal: &NormalSolution,
    hardness: Option<&Hardness>,
    watch: &mut Watch<'_>,
) -> Result<Option<Press>> {
    normal.check_bodies(bodies)?;
    normal.check_uncoupled()?;
    if hardness.is_none() {
        normal.check_elastic("the stiffness")?;
    }
    let pressure = normal.pressure().as_slice();
    let Some(window) = Window::around(bodies.grid(), |i| pressure[i] > 0.0) else {
        return Ok(None);
    };
    let window = bodies.confined(window);
    let freedom = |i: usize| {
        let limits = hardness.map(Hardness::limits);
        let yields = limits.is_some_and(|limits| limits.are_reached(i, pressure[i]));
        if pressure[i] > 0.0 && !yields {
            Freedom::Free
        } else {
            Freedom::Fixed
        }
    };
    let compliance = bodies.compliance([Direction::Z], window.size)?;
    let freedoms = buffer::collected(window.cells(), window.indices().map(freedom))?;
    let system = System::new(bodies.boundary(), &compliance, freedoms, Vec::new())?;
    let Stiffness {
        matrix,
        bound,
        tractions,
        ..
    } = system.stiffness(&[[buffer::filled(1.0, window.cells())?]], watch)?;
    let cell_area = bodies.grid().cell_area();
    let per_area = matrix[0][0];
    let value = per_area * cell_area;
    let unit = tractions.into_iter().flatten().flatten();
    Ok(Some(Press {
        window,
        stiffness: NormalStiffness { value, bound },
        growth: buffer::collected(window.cells(), unit.map(|traction| traction * per_area))?,
    }))
}

/// Zero without contact.
pub(super) fn stiffness_of(press: Option<&Press>) -> NormalStiffness {
    let none = NormalStiffness {
        value: 0.0,
        bound: 0.0,
    };
    press.map_or(none, |press| press.stiffness)
}
