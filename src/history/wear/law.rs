//! Wear laws.

use crate::error::{Error, Result, finite, non_negative};
use crate::grid::field::Field;
use crate::history::wear::coefficient::greatest;
use crate::history::wear::{Coefficient, check};
use crate::parallel;
use crate::parallel::reduce;

/// Adds the depth that Archard's law removes, `k p |s|` (lengths).
///
/// `coefficient` is k = K/H, Archard's dimensionless coefficient divided by the hardness, for one body or the sum for both
/// bodies. It is the volume removed per normal force and sliding distance. Its unit is one over a pressure, and 1 mm3/(N m) is
/// 1e-9 1/Pa. `slip_distance` is the slip distance of a [step](crate::history::StepResult::slip_distance), or of a
/// [cycle](crate::history::Cycle::slip_distance) together with its [slip pressure](crate::history::Cycle::slip_pressure). See
/// Archard, J. Appl. Phys. 24 (1953) 981, <https://doi.org/10.1063/1.1721448>.
///
/// A failed step leaves [`History::last_step`](crate::history::History::last_step) at the earlier step. A program must not
/// add the wear of this step again.
///
/// # Errors
/// - [`Error::NegativeOrNotFinite`] if the uniform coefficient is negative or not finite.
/// - [`Error::Sample`] at a coefficient, pressure or length that is negative or not finite.
/// - [`Error::GridMismatch`] if the grids differ.
/// - [`Error::NotFinite`] if the greatest depth overflows.
///
/// The depth is unchanged after an error.
pub fn archard<'a>(
    coefficient: impl Into<Coefficient<'a>>,
    pressure: &Field,
    slip_distance: &Field,
    depth: &mut Field,
) -> Result<()> {
    let coefficient = coefficient.into();
    let grid = depth.grid();
    coefficient.check(grid)?;
    check("pressure", pressure, grid)?;
    check("slip length", slip_distance, grid)?;
    let deepest = coefficient.largest() * greatest(pressure) * greatest(slip_distance);
    finite("greatest depth of wear", deepest)?;
    let (pressure, slip) = (pressure.as_slice(), slip_distance.as_slice());
    remove(depth, |i| coefficient.at(i) * pressure[i] * slip[i]);
    Ok(())
}

/// Adds the depth that the energy law removes, `alpha E / A` with the area A of a cell (lengths).
///
/// `coefficient` is alpha for one body, or the sum for both bodies. It is the volume removed per dissipated energy (one
/// over a pressure). In gross slip alpha equals Archard's k divided by the coefficient of friction. `energy` is the
/// energy that each cell dissipates in a [step](crate::history::StepResult::dissipation) or a
/// [cycle](crate::history::Cycle::dissipation). It is neither the accumulated dissipation of the history nor an energy per area. See
/// Fouvry, Kapsa & Vincent, Wear 200 (1996) 186, <https://doi.org/10.1016/S0043-1648(96)07306-1>.
///
/// A failed step leaves [`History::last_step`](crate::history::History::last_step) at the earlier step. A program must not
/// add the wear of this step again.
///
/// # Errors
/// - [`Error::NegativeOrNotFinite`] if the uniform coefficient is negative or not finite.
/// - [`Error::Sample`] at a coefficient or energy that is negative or not finite.
/// - [`Error::GridMismatch`] if the grids differ.
/// - [`Error::NotFinite`] if the greatest depth overflows.
///
/// The depth is unchanged after an error.
pub fn energy<'a>(
    coefficient: impl Into<Coefficient<'a>>,
    energy: &Field,
    depth: &mut Field,
) -> Result<()> {
    let coefficient = coefficient.into();
    let grid = depth.grid();
    coefficient.check(grid)?;
    check("dissipated energy", energy, grid)?;
    let area = grid.cell_area();
    finite(
        "greatest depth of wear",
        coefficient.largest() / area * greatest(energy),
    )?;
    let energy = energy.as_slice();
    remove(depth, |i| coefficient.at(i) / area * energy[i]);
    Ok(())
}

/// Adds the depth that the energy law removes beyond a threshold (lengths). The depth is the increase of `alpha max(0, E/A - e)`
/// in a step or cycle. The depths of the steps therefore sum to the law for the total energy.
///
/// `threshold` e is the energy per area below which nothing wears. `accumulated` is the energy E that each cell has
/// dissipated since the start, including the present step.
/// [`History::accumulated_dissipation`](crate::history::History::accumulated_dissipation) returns this energy after the
/// step. `energy` is the energy of the step or cycle. Fouvry, Liskiewicz, Kapsa, Hannel & Sauger, Wear 255 (2003) 287,
/// <https://doi.org/10.1016/S0043-1648(03)00117-0>, use the energy of the whole contact. In contrast, this function
/// uses the energy of each cell.
///
/// ```
/// use stickslip::history::wear;
/// use stickslip::{Field, Grid};
/// let grid = Grid::new(4, 4, 1.0, 1.0)?;
/// let (step, mut total, mut depth) = (Field::constant(grid, 2.0), Field::zeros(grid), Field::zeros(grid));
/// for _ in 0..4 {
///     total.add_scaled(1.0, &step)?;
///     wear::threshold_energy(0.5, 3.0, &total, &step, &mut depth)?;
/// }
/// // The total energy of 8 exceeds the threshold of 3 by 5.
/// assert_eq!(depth, Field::constant(grid, 2.5));
/// # Ok::<(), stickslip::Error>(())
/// ```
///
/// # Errors
/// - [`Error::NegativeOrNotFinite`] if the uniform coefficient or the threshold is negative or
///   not finite.
/// - [`Error::Sample`] at a coefficient or energy that is negative or not finite.
/// - [`Error::GridMismatch`] if the grids differ.
/// - [`Error::BelowMinimum`] if the sum of the accumulated energy is less than the sum of the energy, as
///   for arguments in the wrong order.
/// - [`Error::NotFinite`] if the greatest depth overflows.
///
/// The depth is unchanged after an error.
pub fn threshold_energy<'a>(
    coefficient: impl Into<Coefficient<'a>>,
    threshold: f64,
    accumulated: &Field,
    energy: &Field,
    depth: &mut Field,
) -> Result<()> {
    let coefficient = coefficient.into();
    let grid = depth.grid();
    coefficient.check(grid)?;
    non_negative("threshold of dissipated energy", threshold)?;
    check("accumulated energy", accumulated, grid)?;
    check("dissipated energy", energy, grid)?;
    let most = greatest(energy);
    let (total, energy) = (accumulated.as_slice(), energy.as_slice());
    let [whole, part] = reduce::sum(&grid.layout(), |i| [total[i], energy[i]]);
    if part * (1.0 - 1e-9) > whole {
        return Err(Error::BelowMinimum {
            quantity: "sum of the accumulated energy",
            value: whole,
            least: part,
            least_is: "the sum of the energy of the step, which it includes",
        });
    }
    let area = grid.cell_area();
    finite(
        "greatest depth of wear",
        coefficient.largest() / area * most,
    )?;
    remove(depth, |i| {
        // Only the energy of the step above the threshold counts.
        let beyond = (total[i] - threshold * area).clamp(0.0, energy[i]);
        coefficient.at(i) / area * beyond
    });
    Ok(())
}

/// Adds the value of `of` to the depth of each cell.
fn remove(depth: &mut Field, of: impl Fn(usize) -> f64 + Sync) {
    parallel::update(depth.as_mut_slice(), |first, chunk| {
        for (i, depth) in (first..).zip(chunk) {
            *depth += of(i);
        }
    });
}
