//! Response of the pressure of a contact to the approach.

use crate::bodies::component::Direction;
use crate::cgm::{Interval, Row};
use crate::contact::ResponseContext;
use crate::error::Result;
use crate::half_space::Region;
use crate::memory::fallible;
use crate::normal::NormalSolution;
use crate::operator::Operator;
use crate::stiffness::NormalStiffness;
use crate::stiffness::contact::{ContactCells, SolvedContact, collect};
use crate::stiffness::system::{CellMotions, System};
use crate::stiffness::workspace::SystemOf;

impl SolvedContact<'_> {
    /// Creates the system of the cells whose pressure follows the approach, or returns `None` without contact. Cells at the
    /// hardness carry no additional pressure. `quantity` is the result for which the system is solved.
    pub(crate) fn hold_pressure<'s>(
        &self,
        normal: &NormalSolution,
        quantity: &'static str,
        slot: &'s mut Option<SystemOf<Interval, 1>>,
        cells: &mut ContactCells,
    ) -> Result<Option<(Region, &'s mut SystemOf<Interval, 1>)>> {
        let (bodies, pressure) = (self.bodies, normal.pressure().as_slice());
        let checked = normal.check_bodies(bodies);
        let checked = checked.and_then(|()| normal.check_uncoupled());
        let checked = checked.and_then(|()| match self.hardness {
            Some(_) => Ok(()),
            None => normal.check_elastic(quantity),
        });
        bodies.collective_result(checked)?;
        let Some(region) = self.region(self.windows[0], |i| pressure[i] > 0.0) else {
            return Ok(None);
        };
        let compliance = bodies.compliance([Direction::Z], region.window().size)?;
        let system = System::get_or_create(slot, bodies, compliance, |system| {
            Ok(system.self_compliance())
        })?;
        let limits = self.hardness.map(|hardness| hardness.limits());
        let is_free = |i: usize| {
            let yields = limits.is_some_and(|limits| limits.are_reached(i, pressure[i]));
            f64::from(u8::from(pressure[i] > 0.0 && !yields))
        };
        collect(&region, is_free, &mut cells.follows)?;
        let row = |cell: usize| {
            if cells.follows[cell] > 0.0 {
                Row::FREE
            } else {
                Row::FIXED
            }
        };
        system.hold(bodies, row, &[])?;
        Ok(Some((region, system)))
    }

    /// Computes the normal stiffness, which is zero without contact. Sets the derivative of the pressures with respect to the
    /// approach in the cells.
    pub(super) fn press(
        &self,
        normal: &NormalSolution,
        slot: &mut Option<SystemOf<Interval, 1>>,
        cells: &mut ContactCells,
        context: &mut ResponseContext<'_>,
    ) -> Result<NormalStiffness> {
        cells.growth_on_grid.clear();
        fallible::resize(&mut cells.growth_on_grid, self.bodies.grid().cells(), 0.0)?;
        let Some((region, system)) = self.hold_pressure(normal, "the stiffness", slot, cells)?
        else {
            context.finish_at_once();
            return Ok(NormalStiffness::NONE);
        };
        let approach = CellMotions {
            count: 1,
            of_cell: |_, _| [1.0],
        };
        let found = system.stiffness(&approach, context)?;
        let [unit] = system.unit();
        region.scatter(unit, &mut cells.growth_on_grid);
        Ok(NormalStiffness {
            value: found.matrix[0][0] * self.bodies.grid().cell_area(),
            bound: found.bound,
        })
    }
}
