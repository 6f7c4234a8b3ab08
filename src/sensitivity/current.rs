//! Checks that a solution belongs to the present input of its solver.

use crate::bodies::component::Component;
use crate::cgm::reduce;
use crate::contact::ResponseContext;
use crate::error::{Error, Result};
use crate::grid::field::Field;
use crate::half_space::HalfSpace;
use crate::memory::fallible;
use crate::normal::{Hardness, NormalLoad, NormalSolution};
use crate::numerics::agreement::agree;
use crate::operator::Operator;
use crate::tangential::{Axis, RelativeDisplacement, RigidMotion, TangentialSolution, centre};

/// Returns an error that names the changed input unless the solution belongs to the present input.
pub(super) fn check_current(is_current: bool, changed: &'static str) -> Result<()> {
    if is_current {
        return Ok(());
    }
    Err(Error::OutdatedSolution {
        quantity: "sensitivity",
        changed,
        remedy: "solve again, and pass the new solution",
    })
}

/// Checks the force or the approach of a solution.
pub(super) fn check_normal_load(load: NormalLoad, contact: &NormalSolution) -> Result<()> {
    let is_current = match load {
        NormalLoad::Force(force) => agree(contact.force(), force, 0.0),
        NormalLoad::Approach(approach) => agree(contact.approach(), approach, 0.0),
    };
    check_current(is_current, "the normal load")
}

/// Checks that the solution has the same cells at the hardness. Contacts without hardness are checked by the linear problem.
pub(super) fn check_hardness(
    bodies: &HalfSpace,
    hardness: Option<&Hardness>,
    contact: &NormalSolution,
) -> Result<()> {
    let pressure = contact.pressure().as_slice();
    let is_current = hardness.is_none_or(|hardness| {
        hardness.reached_cells(bodies, pressure) == contact.yielded_cells()
            && !hardness.is_exceeded(bodies, pressure)
    });
    check_current(is_current, "the hardness")
}

/// Checks that the gap under load follows from the present gap and the normal displacement of all cells.
pub(super) fn check_gap(
    bodies: &HalfSpace,
    gap: &Field,
    contact: &NormalSolution,
    displacement: &[f64],
) -> Result<()> {
    let (layout, approach) = (bodies.grid_layout(), contact.approach());
    let (initial, opened) = (gap.as_slice(), contact.gap().as_slice());
    let largest = reduce::max(&layout, |i| displacement[i].abs());
    let is_changed = |i: usize| {
        let scale = largest + initial[i].abs() + approach.abs();
        !agree(opened[i], displacement[i] + (initial[i] - approach), scale)
    };
    check_current(!reduce::any(&layout, is_changed), "the gap")
}

/// Checks that the slip of a solution follows from the present relative displacement and the tangential displacement of all cells
/// due to pressure and tractions. Only slipping cells are checked, whose slip is exact. The slip of sticking cells is zero within
/// the residual of the solve.
pub(super) fn check_relative_displacement(
    bodies: &HalfSpace,
    relative: &RelativeDisplacement,
    shear: &TangentialSolution,
    displacement: [&[f64]; 2],
) -> Result<()> {
    let (grid, layout) = (bodies.grid(), bodies.grid_layout());
    let motion = RigidMotion {
        shift: shear.shift(),
        twist: shear.twist(),
    };
    let slip = shear.slip().map(Field::as_slice);
    let axes = shear.axis().map_or(Axis::BOTH, Axis::alone);
    // Slip due to the motion, the displacement and the relative displacement.
    let parts = |axis: &Axis, i: usize| {
        let axis = axis.index();
        let moved = motion.at(centre(grid, i))[axis];
        [-moved, displacement[axis][i], relative.at(axis, i)]
    };
    let size = |i: usize| {
        let parts = axes.iter().flat_map(|axis| parts(axis, i));
        parts.fold(0.0_f64, |most, part| most.max(part.abs()))
    };
    let scale = reduce::max(&layout, size);
    let is_changed = |i: usize| {
        let slips = slip.iter().any(|slip| slip[i] != 0.0);
        let differs = |axis: &Axis| {
            let expected: f64 = parts(axis, i).iter().sum();
            !agree(slip[axis.index()][i], expected, scale)
        };
        slips && axes.iter().any(differs)
    };
    let is_current = !reduce::any(&layout, is_changed);
    check_current(is_current, "the relative displacement")
}

/// Computes the normal displacement of all cells with one product.
pub(super) fn normal_displacement(
    bodies: &HalfSpace,
    contact: &NormalSolution,
    context: &mut ResponseContext<'_>,
) -> Result<Vec<f64>> {
    let grid = bodies.grid();
    context.notify_observer(&bodies.grid_layout())?;
    let operator = bodies.operator_of([[Component::ZZ]], grid.whole().size())?;
    let mut displacement = fallible::zeros(grid.cells())?;
    let pressure = contact.pressure().as_slice();
    operator.apply([pressure], [&mut displacement], &mut operator.scratch()?);
    Ok(displacement)
}
