//! Largest pressure that cells can carry.

use crate::cgm::{Total, reduce};
use crate::error::{Error, Result, all_non_negative, positive};
use crate::grid::Grid;
use crate::grid::field::{Field, clone_in_place};
use crate::grid::per_cell::PerCell;
use crate::grid::window::Window;
use crate::half_space::HalfSpace;
use crate::memory::fallible::{self, try_clone};
use crate::normal::{NormalLoad, NormalSolution};

/// Least ratio of the capacity of a window to the prescribed total. A smaller capacity would leave the pressure no
/// freedom.
const ROOM: f64 = 1.01;

/// Largest pressure H that the softer body can carry, uniform or per cell: $`0 \le p \le H`$.
///
/// Cells at the limit yield. The elastically deformed surfaces overlap in these cells. All other cells are in elastic
/// contact or separated,
///
/// ```math
/// p = 0:\ g \ge 0, \qquad 0 < p < H:\ g = 0, \qquad p = H:\ g \le 0 .
/// ```
///
/// This is the elastic, perfectly plastic contact of Almqvist, Sahlin, Larsson & Glavatskih, Tribology International 40
/// (2007) 574 (<https://doi.org/10.1016/j.triboint.2005.11.008>). H is the indentation hardness. The certified error
/// refers to the pressure of this model.
///
/// A contact without yielded cells is first solved without the limit. If no cell reaches the hardness, the solution is
/// therefore bitwise identical to the solution without a hardness.
///
/// ```
/// use stickslip::*;
/// let grid = Grid::square(64, 0.5)?;
/// let steel = Material::new(210e3, 0.3)?;
/// let bodies = HalfSpace::new(grid, ElasticPair::new(steel, steel)?)?;
/// let ball = surface::sphere(grid, 10.0)?;
/// let hertz = analytical::HertzSphere::new(bodies.pair(), 10.0, 100.0)?;
/// let hardness = normal::Hardness::uniform(0.7 * hertz.max_pressure())?;
/// let problem = NormalProblem::builder(&bodies, &ball, NormalLoad::Force(100.0));
/// let contact = problem.hardness(hardness.clone()).build()?.solve()?;
/// assert_eq!(contact.pressure().max(), hardness.of_cell(0));
/// // Yielding spreads the load: the contact is wider and deeper, and the surfaces overlap in the middle.
/// assert!(contact.contact_area() > hertz.contact_area() && contact.approach() > hertz.approach());
/// assert!(hardness.overlap(&contact)?.get(32, 32) > Some(0.0));
/// # Ok::<(), Error>(())
/// ```
#[derive(Debug, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(try_from = "RawHardness")
)]
pub struct Hardness {
    limit: PerCell<Field>,
}

clone_in_place!(Hardness { limit });

try_clone!(Hardness { limit });

/// Deserialised value before validation.
#[cfg(feature = "serde")]
#[derive(serde::Deserialize)]
#[serde(deny_unknown_fields)]
struct RawHardness {
    limit: PerCell<Field>,
}

#[cfg(feature = "serde")]
impl TryFrom<RawHardness> for Hardness {
    type Error = Error;

    fn try_from(read: RawHardness) -> Result<Self> {
        match read.limit {
            PerCell::Uniform(limit) => Self::uniform(limit),
            PerCell::Cells(limits) => Self::per_cell(limits),
        }
    }
}

impl Hardness {
    /// Creates a uniform limit H > 0.
    ///
    /// # Errors
    /// - [`Error::NotPositive`] if `limit` is not positive and finite.
    pub fn uniform(limit: f64) -> Result<Self> {
        let limit = PerCell::Uniform(positive("hardness", limit)?);
        Ok(Self { limit })
    }

    /// Creates a limit H >= 0 for each cell. A cell whose limit is zero cannot carry pressure.
    ///
    /// # Errors
    /// - [`Error::Sample`] at the first limit that is negative or not finite.
    pub fn per_cell(limits: Field) -> Result<Self> {
        all_non_negative("hardness", limits.as_slice())?;
        let limit = PerCell::Cells(limits);
        Ok(Self { limit })
    }

    /// Returns the largest pressure of cell `index` (row-major), or NaN for a cell outside the field of limits.
    #[must_use]
    pub fn of_cell(&self, index: usize) -> f64 {
        self.limits().of(index)
    }

    /// Returns the largest normal force that the cells of a grid can carry, the integral of the limit.
    #[must_use]
    pub fn capacity(&self, grid: Grid) -> f64 {
        match &self.limit {
            PerCell::Uniform(limit) => limit * grid.area(),
            PerCell::Cells(limits) => limits.integral(),
        }
    }

    /// Returns the overlap of the surfaces of a solved contact (lengths, non-negative). The overlap is zero in cells
    /// below the limit. To account for the plastic deformation, add the overlap to the gap of the next contact of the
    /// same surfaces.
    ///
    /// # Errors
    /// - [`Error::GridMismatch`] if the limits and the contact have different grids.
    /// - [`Error::OutdatedSolution`] if the contact was solved with a different hardness, so that a pressure exceeds these limits or
    ///   other cells yielded.
    /// - [`Error::Memory`] if memory runs out.
    pub fn overlap(&self, contact: &NormalSolution) -> Result<Field> {
        self.check(contact.grid())?;
        let (limits, pressure) = (self.limits(), contact.pressure().as_slice());
        let cells = || pressure.iter().enumerate();
        let reached = cells().filter(|(cell, pressure)| limits.are_reached(*cell, **pressure));
        // On distributed bodies the yielded cells of all ranks are counted.
        let is_whole = contact.share().is_none();
        if (is_whole && reached.count() != contact.yielded_cells())
            || cells().any(|(cell, pressure)| *pressure > limits.of(cell))
        {
            return Err(Error::OutdatedSolution {
                quantity: "overlap",
                changed: "the hardness",
                remedy: "pass the hardness with which the contact was solved",
            });
        }
        let cells = contact.gap().as_slice().iter().zip(pressure).enumerate();
        let overlap = |(cell, (gap, pressure)): (usize, (&f64, &f64))| {
            if limits.are_reached(cell, *pressure) {
                (-gap).max(0.0)
            } else {
                0.0
            }
        };
        let overlaps = fallible::collected(pressure.len(), cells.map(overlap))?;
        Field::from_vec(contact.grid(), overlaps)
    }

    /// Creates a placeholder for deserialisation.
    pub(crate) fn blank() -> Self {
        let limit = PerCell::Uniform(f64::INFINITY);
        Self { limit }
    }

    /// Returns mutable access to the limit, used to restore a saved state. A change must satisfy the conditions of the
    /// constructors.
    pub(crate) fn limit_mut(&mut self) -> &mut PerCell<Field> {
        &mut self.limit
    }

    /// Returns the number of cells of the whole grid that are at the limit.
    pub(crate) fn reached_cells(&self, bodies: &HalfSpace, pressure: &[f64]) -> usize {
        let limits = self.limits();
        let is_reached = |i: usize| limits.are_reached(i, pressure[i]);
        reduce::sum(&bodies.grid_layout(), |i| usize::from(is_reached(i)))
    }

    /// Returns the uniform limit, or the smallest limit of the local cells in contact. Returns infinity if no local cell is in contact.
    pub(crate) fn least_limit(&self, pressure: &[f64]) -> f64 {
        match self.limits() {
            PerCell::Uniform(limit) => limit,
            PerCell::Cells(limits) => {
                let cells = limits.iter().zip(pressure);
                let limits = cells.filter(|(_, pressure)| **pressure > 0.0);
                let limits = limits.map(|(limit, _)| *limit);
                limits.fold(f64::INFINITY, f64::min)
            }
        }
    }

    /// Returns whether the pressure of any cell of the whole grid exceeds the limit.
    pub(crate) fn is_exceeded(&self, bodies: &HalfSpace, pressure: &[f64]) -> bool {
        let limits = self.limits();
        reduce::any(&bodies.grid_layout(), |i| pressure[i] > limits.of(i))
    }

    pub(crate) fn limits(&self) -> PerCell<&[f64]> {
        self.limit.map(Field::as_slice)
    }

    /// Restricts the limits to cells with twice the side length. Each coarse cell receives the mean of its fine cells.
    pub(crate) fn coarsened(&self, bodies: &HalfSpace, coarser: &HalfSpace) -> Result<Self> {
        let coarsened = |cells: &Field| bodies.coarsened_field(coarser, cells);
        let limit = self.limit.try_map(coarsened)?;
        Ok(Self { limit })
    }

    /// Returns an error on all ranks if the limits do not fit the bodies or cannot carry the load.
    pub(crate) fn check_on(&self, bodies: &HalfSpace, load: NormalLoad) -> Result<()> {
        let checked = self.check(bodies.grid());
        bodies.collective_result_checked(checked, &[("hardness", &self.common())])?;
        self.check_load(bodies, load)
    }

    /// Returns an error if the limits do not fit the grid.
    pub(crate) fn check(&self, grid: Grid) -> Result<()> {
        self.limit.check("hardness", grid)
    }

    /// Returns whether a window can carry this total of the pressures. The window must be the whole grid, or its
    /// capacity must exceed [`ROOM`] times the total.
    pub(crate) fn holds(&self, bodies: &HalfSpace, window: Window, total: Total) -> bool {
        let Some(total) = total
            .sum()
            .filter(|_| window != Window::whole(bodies.grid()))
        else {
            return true;
        };
        let (limits, first) = (self.limits(), bodies.first_cell());
        let capacity = reduce::sum(&bodies.grid_layout(), |i| {
            if window.contains(first + i) {
                limits.of(i)
            } else {
                0.0
            }
        });
        capacity > ROOM * total
    }

    /// Returns the properties that must agree on all ranks.
    pub(crate) fn common(&self) -> PerCell<()> {
        self.limit.map(|_| ())
    }

    /// Returns an error if the limits cannot carry the load. The limits must have been checked.
    pub(crate) fn check_load(&self, bodies: &HalfSpace, load: NormalLoad) -> Result<()> {
        if let NormalLoad::Force(force) = load {
            let capacity = match &self.limit {
                PerCell::Uniform(_) => self.capacity(bodies.grid().whole()),
                PerCell::Cells(limits) => bodies.integral(limits),
            };
            if force > capacity {
                return Err(Error::BeyondHardness { force, capacity });
            }
        }
        Ok(())
    }
}
