//! Influence coefficients by the distance of two cells.

use crate::bodies::component::Component;
use crate::error::{Error, Result, all_finite, length, memory, positive};
use crate::grid::Grid;
use crate::support::checksum;
use crate::support::debug::shown;

/// Influence coefficients $`C_{ij}`$ of two bodies at the cell distances `(i dx, j dy)`, `0 <= i < nx`, `0 <= j < ny`: the
/// displacement at the centre of a cell by a unit traction on the one at distance zero, as the
/// [`influence`](crate::influence) page has them (lengths over pressures). Distances of the other sign follow from the
/// [parity](Component::is_odd) of bodies that are mirror images of themselves along x and y.
///
/// Of the nine, `XX`, `YY` or `ZZ` are needed for what displaces along them; `XY`, `ZX` and `ZY` are zero where they are
/// not given, and `YX`, `XZ` and `YZ` are theirs, by reciprocity.
///
/// ```
/// use stickslip::influence::{Component, Table};
/// use stickslip::kernel::CoefficientTable;
/// use stickslip::{ElasticPair, Grid, HalfSpace, Kernel, Material, NormalControl, NormalProblem, surface};
/// // A bed of springs beside the half-space: what each cell sinks by its own pressure is added to its coefficient.
/// let pair = ElasticPair::new(Material::new(1.0, 0.3)?, Material::rigid())?;
/// let grid = Grid::square(32, 3.0)?;
/// let half_space = Table::sample(grid, &pair, Component::ZZ)?;
/// let ball = surface::sphere(grid, 10.0)?;
/// let pressed = |spring: f64| {
///     let at = |index: isize| half_space.get(index % 32, index / 32).unwrap_or(0.0);
///     let mut values: Vec<f64> = (0..32 * 32).map(at).collect();
///     values[0] += spring;
///     let table = CoefficientTable::new([grid.dx(), grid.dy()], [32; 2])?.with(Component::ZZ, values)?;
///     let bodies = HalfSpace::new(grid, &Kernel::tabulated(pair, table)?)?;
///     NormalProblem::builder(&bodies, &ball, NormalControl::Force(0.05)).build()?.solve()
/// };
/// let [hard, soft] = [pressed(0.0)?, pressed(0.5)?];
/// assert!(soft.approach() > hard.approach() && soft.pressure().max() < hard.pressure().max());
/// # Ok::<(), stickslip::Error>(())
/// ```
#[derive(Clone, PartialEq)]
pub struct CoefficientTable {
    sides: [f64; 2],
    size: [usize; 2],
    /// Of the six that are independent, those given, row by row.
    values: [Option<Vec<f64>>; 6],
}

shown!(CoefficientTable: sides, size);

/// The six, in the order of their values.
const SIX: [Component; 6] = [
    Component::XX,
    Component::YY,
    Component::ZZ,
    Component::XY,
    Component::ZX,
    Component::ZY,
];

/// Size beside the largest value of a table that is nothing.
const ROUND_OFF: f64 = 1e-12;

/// Whether a component is zero at a distance for its parity.
fn vanishes(component: Component, distance: [usize; 2]) -> bool {
    let odd = component.is_odd();
    (0..2).any(|axis| odd[axis] && distance[axis] == 0)
}

/// The place of a component among the six, and whether its values are the others' negatives.
fn place(component: Component) -> (usize, bool) {
    match component {
        Component::XX => (0, false),
        Component::YY => (1, false),
        Component::ZZ => (2, false),
        Component::XY | Component::YX => (3, false),
        Component::ZX => (4, false),
        Component::XZ => (4, true),
        Component::ZY => (5, false),
        Component::YZ => (5, true),
    }
}

const QUANTITY: &str = "table of coefficients";

impl CoefficientTable {
    /// A table of `size` distances along x and along y, of cells of the sides `[dx, dy]` (lengths), without coefficients.
    ///
    /// # Errors
    /// [`Error::NotPositive`]; [`Error::Length`] without a distance; [`Error::Memory`].
    pub fn new(sides: [f64; 2], size: [usize; 2]) -> Result<Self> {
        for side in sides {
            positive("side of a cell of the table", side)?;
        }
        if let Some(&found) = size.iter().find(|n| **n == 0) {
            length(QUANTITY, 1, found)?;
        }
        memory(QUANTITY, size, size_of::<f64>())?;
        Ok(Self {
            sides,
            size,
            values: Default::default(),
        })
    }

    /// The same with a component: `nx` values for each distance along y, of distances along x from zero on.
    ///
    /// # Errors
    /// [`Error::Length`]; [`Error::Sample`] for values that are not finite.
    pub fn with(mut self, component: Component, mut values: Vec<f64>) -> Result<Self> {
        let [nx, ny] = self.size;
        length(QUANTITY, nx * ny, values.len())?;
        all_finite(QUANTITY, &values)?;
        let (place, is_negative) = place(component);
        if is_negative {
            for value in &mut values {
                *value = -*value;
            }
        }
        self.values[place] = Some(values);
        Ok(self)
    }

    /// Sides of a cell (lengths).
    #[must_use]
    pub fn sides(&self) -> [f64; 2] {
        self.sides
    }

    /// Distances along x and along y.
    #[must_use]
    pub fn size(&self) -> [usize; 2] {
        self.size
    }

    /// The values of a component as [`Self::with`] takes them, if they are given.
    #[must_use]
    pub fn get(&self, component: Component) -> Option<Vec<f64>> {
        let (place, is_negative) = place(component);
        let sign = if is_negative { -1.0 } else { 1.0 };
        let values = self.values[place].as_ref()?;
        Some(values.iter().map(|value| sign * value).collect())
    }

    /// `Ok` if what is odd along an axis is zero at distance zero along it, to round-off.
    pub(super) fn check_odd(&self) -> Result<()> {
        let [nx, ny] = self.size;
        let values = self.values.iter().flatten().flatten();
        let unit = values.fold(0.0, |a: f64, b| a.max(b.abs()));
        for component in SIX {
            let Some(values) = &self.values[place(component).0] else {
                continue;
            };
            let mut on_axis = (0..nx * ny).filter(|n| vanishes(component, [n % nx, n / nx]));
            if let Some(index) = on_axis.find(|n| values[*n].abs() > ROUND_OFF * unit) {
                return Err(Error::Sample {
                    quantity: QUANTITY,
                    index,
                    value: values[index],
                    rule: "an odd coefficient is zero at distance zero",
                });
            }
        }
        Ok(())
    }

    /// `Ok` if a displacement can be had; those across the traction are zero if they are not given.
    pub(crate) fn check_has(&self, component: Component) -> Result<()> {
        let (place, _) = place(component);
        if place < 3 && self.values[place].is_none() {
            return Err(Error::IncompleteKernel(
                "its table has no coefficients of a displacement by its own traction, XX, YY or ZZ",
            ));
        }
        Ok(())
    }

    /// `Ok` if the table is that of a grid, or of a larger one of its cells.
    pub(crate) fn check_on(&self, grid: Grid) -> Result<()> {
        let [nx, ny] = self.size;
        let reaches = nx >= grid.nx() && ny >= grid.ny();
        let [nx, ny] = if reaches { grid.size() } else { [nx, ny] };
        let [dx, dy] = self.sides;
        grid.expect(QUANTITY, Grid::new(nx, ny, dx, dy)?)
    }

    /// The coefficient at a distance, continued linearly beyond the last one.
    pub(crate) fn at(&self, component: Component, distance: [usize; 2]) -> f64 {
        let (place, is_negative) = place(component);
        let Some(values) = &self.values[place] else {
            return 0.0;
        };
        if vanishes(component, distance) {
            return 0.0;
        }
        let [nx, ny] = self.size;
        let along_x = |row: usize| continued(distance[0], nx, |column| values[row * nx + column]);
        let value = continued(distance[1], ny, along_x);
        if is_negative { -value } else { value }
    }

    /// That of cells of twice the sides: the mean displacement of four cells by a traction on four.
    pub(crate) fn coarser(&self) -> Self {
        let size = self.size.map(|n| n.div_ceil(2));
        let mean = |component: Component, index: usize| {
            let [x, y] = [2 * (index % size[0]), 2 * (index / size[0])];
            let mut sum = 0.0;
            for (b, weight_y) in [(-1, 0.5), (0, 1.0), (1, 0.5)] {
                for (a, weight_x) in [(-1, 0.5), (0, 1.0), (1, 0.5)] {
                    let steps = [x.checked_add_signed(a), y.checked_add_signed(b)];
                    // Only distance zero has another sign before it.
                    let odd = component.is_odd();
                    let is_negative = (0..2).filter(|&axis| odd[axis] && steps[axis].is_none());
                    let sign = if is_negative.count() == 1 { -1.0 } else { 1.0 };
                    let value = self.at(component, steps.map(|step| step.unwrap_or(1)));
                    sum += weight_x * weight_y * sign * value;
                }
            }
            sum
        };
        let values = std::array::from_fn(|place| {
            let component = SIX[place];
            let count = size[0] * size[1];
            self.values[place].as_ref()?;
            Some((0..count).map(|index| mean(component, index)).collect())
        });
        Self {
            sides: self.sides.map(|side| 2.0 * side),
            size,
            values,
        }
    }

    /// Of all values.
    pub(super) fn digest(&self) -> u64 {
        let size = self.size.map(|n| n as f64);
        let given = self
            .values
            .each_ref()
            .map(|values| f64::from(u8::from(values.is_some())));
        let values = self.values.iter().flatten().flatten();
        let numbers = self.sides.iter().chain(&size).chain(&given).chain(values);
        let bytes: Vec<u8> = numbers.flat_map(|value| value.to_le_bytes()).collect();
        checksum::of_bytes(&bytes)
    }

    /// The largest coefficient of a normal displacement by a traction over that by the cell's own pressure.
    pub(super) fn coupling(&self) -> f64 {
        let own = self.at(Component::ZZ, [0, 0]);
        let coupled = self.values[4..].iter().flatten().flatten();
        let most = coupled.fold(0.0, |a: f64, b| if b.abs() > a.abs() { *b } else { a });
        if own > 0.0 {
            most / own
        } else {
            most.signum() * f64::from(u8::from(most != 0.0))
        }
    }
}

/// A function of `n` distances at one of them, or linearly beyond the last.
fn continued(distance: usize, n: usize, at: impl Fn(usize) -> f64) -> f64 {
    let last = n - 1;
    if distance <= last {
        return at(distance);
    }
    let step = if last > 0 {
        at(last) - at(last - 1)
    } else {
        0.0
    };
    at(last) + (distance - last) as f64 * step
}
