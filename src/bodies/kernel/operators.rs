//! User-defined operators with the directions that they couple.

use std::fmt;

use crate::bodies::component::{Component, Direction};
use crate::bodies::kernel::user_operator::{SubOperator, UserOperator};
use crate::bodies::material::ElasticPair;
use crate::error::{Error, Result, at_least, finite, length, positive};
use crate::grid::Grid;
use crate::memory::fallible::zeros;
use crate::operator::Operator;

/// Compliance of two bodies as operators on the cells of one grid: the argument of
/// [`Kernel::operators`](crate::Kernel::operators).
///
/// An operator has a component for each of its directions, in the order of the directions. A problem uses the first
/// operator that has all required directions and the fewest others. [`NormalProblem`](crate::NormalProblem) requires Z
/// and [`TangentialProblem`](crate::TangentialProblem) requires X, Y or both. Coupled problems require all three
/// directions if `near` is [coupled](crate::ElasticPair::is_coupled). If a problem requires fewer directions than the operator
/// has, each product still computes all of them. If several operators have the same direction, they must agree for this
/// direction. This agreement is not checked.
///
/// ```
/// use stickslip::influence::Direction::{X, Y, Z};
/// use stickslip::kernel::Operators;
/// use stickslip::*;
/// /// A bed of springs: each cell sinks by the given compliance under a unit of pressure or traction.
/// struct Bed(usize, f64);
/// impl<const N: usize> Operator<N> for Bed {
///     fn cells(&self) -> usize { self.0 }
///     fn apply(&self, x: [&[f64]; N], out: [&mut [f64]; N], _: &mut Scratch) {
///         for (out, x) in out.into_iter().zip(x) {
///             out.iter_mut().zip(x).for_each(|(out, x)| *out = self.1 * x);
///         }
///     }
///     fn lower_bound(&self) -> f64 { self.1 }
///     fn self_compliance(&self) -> f64 { self.1 }
/// }
/// let grid = Grid::square(32, 1.0)?;
/// let near = ElasticPair::new(Material::new(1.0, 0.5)?, Material::rigid())?;
/// let operators = Operators::new().with([Z], Bed(1024, 0.5)).with([X, Y], Bed(1024, 0.5));
/// let bodies = HalfSpace::new(grid, Kernel::operators(near, operators)?)?;
///
/// // A paraboloid of radius R = 1: p = (d - r^2 / 2 R) / c carries pi R d^2 / c.
/// let (ball, depth) = (surface::sphere(grid, 1.0)?, 0.06);
/// let contact = NormalProblem::builder(&bodies, &ball, NormalLoad::Approach(depth)).build()?.solve()?;
/// assert!((contact.force() / (std::f64::consts::PI * depth * depth / 0.5) - 1.0).abs() < 0.02);
///
/// // Under this shift the springs in the middle stick, and the springs at the edge slip.
/// let (friction, shift) = (Friction::coulomb(0.5)?, TangentialLoad::shift([0.01, 0.0]));
/// let shear = TangentialProblem::builder(&bodies, &contact, friction, shift).build()?.solve()?;
/// // Springs stick if mu p > s / c, which holds within r^2 < 2 R (d - s / mu).
/// let stick = 2.0 * (depth - 0.01 / 0.5) / (2.0 * depth);
/// assert!((shear.stick_ratio() - stick).abs() < 0.03);
/// # Ok::<(), Error>(())
/// ```
#[derive(Clone, Default)]
pub struct Operators {
    given: Vec<UserOperator>,
    grid: Option<Grid>,
}

/// Largest asymmetry of two products, and largest coupling, that count as round-off.
const ROUNDED: f64 = 1e-9;

impl Operators {
    /// Creates an empty set of operators.
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// Creates an empty set of operators on the cells of a grid. Bodies with these operators then require this grid. Otherwise they
    /// only require its number of cells.
    #[must_use]
    pub fn on(grid: Grid) -> Self {
        Self {
            given: Vec::new(),
            grid: Some(grid),
        }
    }

    /// Adds a symmetric operator for these directions. It maps the tractions (pressures) along these directions to the
    /// displacements (lengths) along them. The [`influence`](crate::influence) page defines the signs. The operator is applied on
    /// many threads.
    #[must_use]
    pub fn with<T, const N: usize>(mut self, directions: [Direction; N], operator: T) -> Self
    where
        T: Operator<N> + Send + 'static,
    {
        const { assert!(N > 0, "an operator has a direction") }
        self.given.push(UserOperator::new(directions, operator));
        self
    }

    /// Checks the operators and returns numbers that identify them, in the units of `near`. The operators must have
    /// equal numbers of cells, be symmetric and positive, and satisfy their stated bounds. They may couple pressure and
    /// traction only if `near` does.
    pub(super) fn examined(&self, near: &ElasticPair) -> Result<Vec<f64>> {
        let unit = near.compliances().normal;
        let [first, ..] = &self.given[..] else {
            return Err(Error::IncompleteKernel("give at least one operator"));
        };
        positive("number of cells of an operator", first.cells() as f64)?;
        let mut shown = Vec::new();
        for given in &self.given {
            let directions = given.directions();
            if (1..directions.len()).any(|n| directions[..n].contains(&directions[n])) {
                return Err(Error::RepeatedDirection);
            }
            length("operator", first.cells(), given.cells())?;
            shown.extend(
                directions
                    .iter()
                    .map(|&direction| unit * f64::from(direction as u8)),
            );
            let [one, other, both] = examined(given)?;
            shown.extend([one, other, unit * both]);
            if !near.is_coupled() {
                check_uncoupled(given)?;
            }
        }
        Ok(shown)
    }

    /// Checks the operators for a grid. The grid is periodic along both axes if `repeats` is set.
    pub(super) fn check_on(&self, grid: Grid, repeats: bool) -> Result<()> {
        if let Some(own) = self.grid {
            grid.check_equal("kernel of user-defined operators", own)?;
        }
        let cells = grid.cells();
        let mut given = self.given.iter();
        given.try_for_each(|given| {
            length("operator", cells, given.cells())?;
            if repeats { check_means(given) } else { Ok(()) }
        })
    }

    /// Returns the operator of these components (displacement, then traction) on `size` cells.
    pub(crate) fn part<const N: usize>(
        &self,
        components: [[Component; N]; N],
        size: [usize; 2],
    ) -> Result<SubOperator<N>> {
        let having = |directions| {
            let given = self.given.iter();
            let mut those = given.filter(|given| given.directions().len() == directions);
            those.find_map(|given| given.part(components, size))
        };
        (1..=3).find_map(having).ok_or(Error::IncompleteKernel(
            "no operator has all required directions (Z for pressure; X, Y or both for traction; all three if the materials of `near` are coupled)",
        ))
    }
}

/// Name of the conditions for operators in error messages.
const MODEL: &str = "a kernel of user-defined operators";

/// Checks the products of two fields with zero mean and returns numbers that identify the operator. The first two numbers are
/// the energies. The third number is the work of one field on the displacements of the other, divided by the geometric mean of
/// the energies.
fn examined(given: &UserOperator) -> Result<[f64; 3]> {
    let directions = given.directions();
    if !given.is_symmetric() {
        return Err(Error::UnsupportedByModel {
            model: MODEL,
            quantity: "a non-symmetric operator (value: the number of its directions)",
            value: directions.len() as f64,
            remedy: "give an operator that obeys reciprocity and declare it symmetric",
        });
    }
    let (x, y) = (probe(given, STEPS[0])?, probe(given, STEPS[1])?);
    let (u, v) = (given.product(&x)?, given.product(&y)?);
    let [xx, xy, yx, yy] = [(&x, &u), (&x, &v), (&y, &u), (&y, &v)].map(|(x, u)| dot(x, u));
    for energy in [xx, yy] {
        positive("energy of tractions under an operator", energy)?;
    }
    check_overwrites(given, &x, &u)?;
    let mean = xx.sqrt() * yy.sqrt();
    let asymmetry = finite("product of an operator", (xy - yx).abs() / mean)?;
    if asymmetry > ROUNDED {
        return Err(Error::UnsupportedByModel {
            model: MODEL,
            quantity: "a violation of reciprocity (difference of the mutual works relative to the energies)",
            value: asymmetry,
            remedy: "give an operator with a difference of at most 1e-9, such as the mean of a matrix and its transpose",
        });
    }
    let bound = finite("lower bound of an operator", given.lower_bound())?;
    let quantity = "energy of tractions under an operator";
    at_least(
        "the energy according to the lower bound of the operator",
        bound * dot(&x, &x),
        quantity,
        xx,
    )?;
    Ok([xx, yy, xy / mean])
}

/// Checks that the product `u` of `x` does not depend on the content of the buffer to which it is written.
fn check_overwrites(given: &UserOperator, x: &[f64], u: &[f64]) -> Result<()> {
    let mut again = zeros(u.len())?;
    again.copy_from_slice(u);
    given.product_into(x, &mut again)?;
    for (again, u) in again.iter_mut().zip(u) {
        *again -= u;
    }
    let change = finite(
        "product of an operator",
        (dot(&again, &again) / dot(u, u)).sqrt(),
    )?;
    if change > ROUNDED {
        return Err(Error::UnsupportedByModel {
            model: MODEL,
            quantity: "a product that changes if it is repeated (change relative to the product)",
            value: change,
            remedy: "overwrite the output by a product that depends on the tractions only",
        });
    }
    Ok(())
}

/// Checks that pressure causes no tangential displacement.
fn check_uncoupled(given: &UserOperator) -> Result<()> {
    let Some(normal) = given.component(Direction::Z) else {
        return Ok(());
    };
    let own = normal * given.cells()..(normal + 1) * given.cells();
    let mut pressure = probe(given, STEPS[0])?;
    pressure[..own.start].fill(0.0);
    pressure[own.end..].fill(0.0);
    let u = given.product(&pressure)?;
    let square = |part: &[f64]| dot(part, part);
    let others = square(&u[..own.start]) + square(&u[own.end..]);
    let coupled = finite("product of an operator", (others / square(&u[own])).sqrt())?;
    if coupled > ROUNDED {
        return Err(Error::UnsupportedByModel {
            model: MODEL,
            quantity: "a tangential displacement due to pressure (relative to the normal displacement)",
            value: coupled,
            remedy: "give a pair `near` of coupled materials",
        });
    }
    Ok(())
}

/// Checks that a uniform traction along each direction causes no displacement. No other datum is possible on a grid
/// that is periodic along both axes.
fn check_means(given: &UserOperator) -> Result<()> {
    let (x, mut uniform) = (probe(given, STEPS[0])?, zeros(given.unknowns()?)?);
    let (u, cells) = (given.product(&x)?, given.cells());
    for part in 0..given.directions().len() {
        uniform.fill(0.0);
        uniform[part * cells..(part + 1) * cells].fill(1.0);
        let found = given.product(&uniform)?;
        let ratio = (dot(&found, &found) / dot(&uniform, &uniform)).sqrt()
            / (dot(&u, &u) / dot(&x, &x)).sqrt();
        if cells > 1 && finite("product of an operator", ratio)? > ROUNDED {
            return Err(Error::UnsupportedByModel {
                model: MODEL,
                quantity: "a displacement due to a uniform traction on a periodic grid (relative to the displacement due to other tractions)",
                value: ratio,
                remedy: "give an operator whose displacements have zero mean, or use a grid that is not periodic",
            });
        }
    }
    Ok(())
}

/// Steps of two sequences that never repeat a value.
const STEPS: [f64; 2] = [0.618_033_988_749_895, 0.414_213_562_373_095];

/// Creates a field of test tractions. Each component has mean zero.
fn probe(given: &UserOperator, step: f64) -> Result<Vec<f64>> {
    let (cells, mut x) = (given.cells(), zeros(given.unknowns()?)?);
    for (i, x) in x.iter_mut().enumerate() {
        *x = ((i + 1) as f64 * step).fract() - 0.5;
    }
    for part in x.chunks_mut(cells) {
        let mean = part.iter().sum::<f64>() / cells as f64;
        // On a single cell, a field with zero mean would be zero everywhere.
        if cells > 1 {
            for x in part {
                *x -= mean;
            }
        }
    }
    Ok(x)
}

fn dot(x: &[f64], y: &[f64]) -> f64 {
    x.iter().zip(y).map(|(x, y)| x * y).sum()
}

impl fmt::Debug for Operators {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let directions = self.given.iter().map(UserOperator::directions);
        f.debug_list().entries(directions).finish()
    }
}
