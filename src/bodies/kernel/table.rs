//! Influence coefficients as functions of the distance between two cells.

use crate::bodies::component::Component;
use crate::error::{Error, Result, all_finite, length, memory, positive};
use crate::grid::Grid;
use crate::support::checksum;
use crate::support::debug::shown;

/// Influence coefficients $`C_{ij}`$ of two bodies at the cell distances `(i dx, j dy)`, `0 <= i < nx`, `0 <= j < ny`.
/// A coefficient (a length over a pressure) is the displacement at the centre of a cell due to a unit traction on the
/// cell at distance zero. The [`influence`](crate::influence) page defines the coefficients. Coefficients at negative
/// distances follow from the [parity](Component::is_odd) of bodies that are mirror images of themselves along x and y.
///
/// `XX`, `YY` or `ZZ` are required for displacements along these directions. `XY`, `ZX` and `ZY` are zero if they are
/// not given. `YX`, `XZ` and `YZ` follow from these components by reciprocity.
///
/// ```
/// use stickslip::influence::{Component, Table};
/// use stickslip::kernel::CoefficientTable;
/// use stickslip::{ElasticPair, Grid, HalfSpace, Kernel, Material, NormalLoad, NormalProblem, surface};
/// // A half-space in series with a bed of springs: the coefficient of a cell's own pressure includes its spring.
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
///     NormalProblem::builder(&bodies, &ball, NormalLoad::Force(0.05)).build()?.solve()
/// };
/// let [hard, soft] = [pressed(0.0)?, pressed(0.5)?];
/// assert!(soft.approach() > hard.approach() && soft.pressure().max() < hard.pressure().max());
/// # Ok::<(), stickslip::Error>(())
/// ```
#[derive(Clone, PartialEq)]
pub struct CoefficientTable {
    sides: [f64; 2],
    size: [usize; 2],
    /// Values of the six independent components, row by row, or `None` for a component that is not given.
    values: [Option<Vec<f64>>; 6],
}

shown!(CoefficientTable: sides, size);

/// The six independent components, in the order of their values.
const SIX: [Component; 6] = [
    Component::XX,
    Component::YY,
    Component::ZZ,
    Component::XY,
    Component::ZX,
    Component::ZY,
];

/// Size relative to the largest value of a table that counts as round-off.
const ROUND_OFF: f64 = 1e-12;

/// Returns whether the parity of a component makes it zero at a distance.
fn vanishes(component: Component, distance: [usize; 2]) -> bool {
    let odd = component.is_odd();
    (0..2).any(|axis| odd[axis] && distance[axis] == 0)
}

/// Returns the index of a component among the six, and whether its values are the negatives of the stored values.
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
    /// Creates a table without coefficients for `size` distances along x and along y, of cells of the sides `[dx, dy]`
    /// (lengths).
    ///
    /// # Errors
    /// - [`Error::NotPositive`] if a side is not positive.
    /// - [`Error::Length`] if there is no distance along an axis.
    /// - [`Error::Memory`] if memory runs out.
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

    /// Sets the values of a component: `nx` values for each distance along y, for increasing distances along x from
    /// zero.
    ///
    /// # Errors
    /// - [`Error::Length`] if the number of values is not `nx * ny`.
    /// - [`Error::Sample`] if a value is not finite.
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

    /// Returns the sides of a cell (lengths).
    #[must_use]
    pub fn sides(&self) -> [f64; 2] {
        self.sides
    }

    /// Returns the numbers of distances along x and along y.
    #[must_use]
    pub fn size(&self) -> [usize; 2] {
        self.size
    }

    /// Returns the values of a component in the order of [`Self::with`], or `None` if the component is not given.
    #[must_use]
    pub fn get(&self, component: Component) -> Option<Vec<f64>> {
        let (place, is_negative) = place(component);
        let sign = if is_negative { -1.0 } else { 1.0 };
        let values = self.values[place].as_ref()?;
        Some(values.iter().map(|value| sign * value).collect())
    }

    /// Checks that components that are odd along an axis are zero, up to round-off, at distance zero along this axis.
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
                    rule: "an odd coefficient must be zero at distance zero",
                });
            }
        }
        Ok(())
    }

    /// Checks that a displacement can be computed. Displacements across the traction are zero if they are not given.
    pub(crate) fn check_has(&self, component: Component) -> Result<()> {
        let (place, _) = place(component);
        if place < 3 && self.values[place].is_none() {
            return Err(Error::IncompleteKernel(
                "the table lacks the coefficients of a displacement along its own traction (XX, YY or ZZ)",
            ));
        }
        Ok(())
    }

    /// Checks that the table has the cells of the grid and at least as many distances.
    pub(crate) fn check_on(&self, grid: Grid) -> Result<()> {
        let [nx, ny] = self.size;
        let reaches = nx >= grid.nx() && ny >= grid.ny();
        let [nx, ny] = if reaches { grid.size() } else { [nx, ny] };
        let [dx, dy] = self.sides;
        grid.check_equal(QUANTITY, Grid::new(nx, ny, dx, dy)?)
    }

    /// Returns the coefficient at a distance, extrapolated linearly beyond the last distance.
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

    /// Returns the table for cells of twice the sides: the mean displacement of four cells due to a traction on four
    /// cells.
    pub(crate) fn coarser(&self) -> Self {
        let size = self.size.map(|n| n.div_ceil(2));
        let mean = |component: Component, index: usize| {
            let [x, y] = [2 * (index % size[0]), 2 * (index / size[0])];
            let mut sum = 0.0;
            for (b, weight_y) in [(-1, 0.5), (0, 1.0), (1, 0.5)] {
                for (a, weight_x) in [(-1, 0.5), (0, 1.0), (1, 0.5)] {
                    let steps = [x.checked_add_signed(a), y.checked_add_signed(b)];
                    // Only distance zero has a neighbour of the opposite sign.
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

    /// Returns a digest of all values.
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

    /// Returns the largest coefficient of the coupling between normal displacement and traction, divided by the normal
    /// coefficient at distance zero.
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

/// Returns the value of a function of `n` distances at the given distance, or its linear extrapolation beyond the last
/// distance.
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
