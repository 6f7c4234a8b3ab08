//! Laws of wear.

use crate::error::{Result, finite, non_negative};
use crate::grid::field::Field;
use crate::history::wear::coefficient::greatest;
use crate::history::wear::{Coefficient, check};
use crate::parallel;

/// Adds the depth that Archard's law removes, `k p |s|` (lengths).
///
/// `coefficient` is k = K/H, Archard's dimensionless coefficient over the hardness, of the body or the sum of both: the
/// volume removed per normal force and sliding distance (one over a pressure; 1 mm3/(N m) is 1e-9 1/Pa).
/// `slip_distance` is that of a [step](crate::history::StepResult::slip_distance), or that of a
/// [cycle](crate::history::Cycle::slip_distance) with the [pressure](crate::history::Cycle::slip_pressure) it slipped
/// under. Archard, J. Appl. Phys. 24 (1953) 981, <https://doi.org/10.1063/1.1721448>.
///
/// # Errors
/// [`Error::NegativeOrNotFinite`](crate::Error::NegativeOrNotFinite) for the coefficient, [`Error::Sample`](crate::Error::Sample)
/// for a coefficient, pressure or length that is negative or not finite,
/// [`Error::GridMismatch`](crate::Error::GridMismatch), [`Error::NotFinite`](crate::Error::NotFinite) for the
/// greatest depth; the depth is then as it was.
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
/// `coefficient` alpha is that of the body, or the sum of both: the volume removed per energy dissipated (one
/// over a pressure); in gross slip it is Archard's k over the coefficient of friction. `energy` is what each cell
/// dissipates in a [step](crate::history::StepResult::dissipated_energy) or a
/// [cycle](crate::history::Cycle::dissipated_energy). Fouvry, Kapsa & Vincent, Wear 200 (1996) 186,
/// <https://doi.org/10.1016/S0043-1648(96)07306-1>.
///
/// # Errors
/// [`Error::NegativeOrNotFinite`](crate::Error::NegativeOrNotFinite) for the coefficient, [`Error::Sample`](crate::Error::Sample)
/// for a coefficient or energy that is negative or not finite,
/// [`Error::GridMismatch`](crate::Error::GridMismatch), [`Error::NotFinite`](crate::Error::NotFinite) for the
/// greatest depth; the depth is then as it was.
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

/// Adds the depth that the energy law removes beyond a threshold: what a step or a cycle adds to
/// `alpha max(0, E/A - e)` (lengths), so that steps sum to the law of the total.
///
/// `threshold` e is the energy per area that wears nothing. `accumulated` is the energy E that each cell has
/// dissipated since the start, that of the step included, as
/// [`History::dissipated_energy`](crate::history::History::dissipated_energy) has it after the step, and
/// `energy` the part of the step or of the cycle. Fouvry, Liskiewicz, Kapsa, Hannel & Sauger, Wear 255 (2003)
/// 287, <https://doi.org/10.1016/S0043-1648(03)00117-0>, for the energy of the whole contact; here it is that
/// of each cell.
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
/// // Of 8 in all, 5 are beyond the threshold of 3.
/// assert_eq!(depth, Field::constant(grid, 2.5));
/// # Ok::<(), stickslip::Error>(())
/// ```
///
/// # Errors
/// [`Error::NegativeOrNotFinite`](crate::Error::NegativeOrNotFinite) for coefficient or threshold,
/// [`Error::Sample`](crate::Error::Sample) for a coefficient or energy that is negative or not finite,
/// [`Error::GridMismatch`](crate::Error::GridMismatch), [`Error::NotFinite`](crate::Error::NotFinite) for the
/// greatest depth; the depth is then as it was.
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
    let area = grid.cell_area();
    finite(
        "greatest depth of wear",
        coefficient.largest() / area * greatest(energy),
    )?;
    let (total, energy) = (accumulated.as_slice(), energy.as_slice());
    remove(depth, |i| {
        // Of the energy of the step, what lies beyond the threshold.
        let beyond = (total[i] - threshold * area).clamp(0.0, energy[i]);
        coefficient.at(i) / area * beyond
    });
    Ok(())
}

/// Adds to the depth of every cell.
fn remove(depth: &mut Field, of: impl Fn(usize) -> f64 + Sync) {
    parallel::update(depth.as_mut_slice(), |first, chunk| {
        for (i, depth) in (first..).zip(chunk) {
            *depth += of(i);
        }
    });
}
