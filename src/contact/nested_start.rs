//! Nested iteration: starts from coarser grids, which leave few steps for the finest grid. The method is the cascadic method of
//! Bornemann & Deuflhard, Numer. Math. 75 (1996) 135, <https://doi.org/10.1007/s002110050234>.

use crate::bodies::component::Direction;
use crate::cgm::{Constraint, ConstraintSet, InitialGuess, Settings};
use crate::contact::{ElasticProblem, ElasticSolver, SolveContext, interrupted_status};
use crate::error::Result;
use crate::grid::coarsening::halved;
use crate::half_space::{HalfSpace, Region};
use crate::memory::fallible;
use crate::parallel::layout::Layout;

/// Maximum number of cells of a grid that is solved without a start from coarser cells.
const COARSEST: usize = 40 * 40;
/// Maximum number of cells of a line that is solved without a start from coarser cells.
const COARSEST_LINE: usize = 160;
/// Least number of cells along the shorter side of a grid that is coarsened, unless the grid is a line.
const NARROW: usize = 8;

/// Problem that can be posed on cells twice as large. The solution on these cells is a start for the original problem.
pub(crate) trait MultilevelProblem<const N: usize>: Sized {
    /// Set of a cell.
    type Set: ConstraintSet<N>;
    type Constraint<'a>: Constraint<N, Set = Self::Set>
    where
        Self: 'a;

    /// Returns the directions of the unknowns.
    fn directions(&self) -> [Direction; N];

    /// Returns the minimisation problem.
    fn problem(
        &self,
        solver: &ElasticSolver<Self::Set, N>,
    ) -> ElasticProblem<'_, Self::Constraint<'_>, N>;

    /// Returns the problem on cells twice as large.
    fn coarsened(&self, levels: GridTransfer<'_>) -> Result<Self>;

    /// Returns a small window to which a start confines the solve, and the problem on this window. Returns `None` if the window
    /// would not be small. The solve on the finest grid detects contact outside this window.
    fn restrict_to_window(
        &self,
        _bodies: &HalfSpace,
        _start: &[Vec<f64>; N],
    ) -> Result<Option<(Region, Self)>> {
        Ok(None)
    }

    /// Returns a start that uses no earlier solution.
    fn plain_start(&self, layout: &Layout) -> Result<[Vec<f64>; N]>;

    /// Returns a start prolongated from the solution of the coarser problem.
    fn refined_start(
        &self,
        levels: GridTransfer<'_>,
        coarse: &Self,
        answer: &[Vec<f64>; N],
    ) -> Result<[Vec<f64>; N]>;
}

/// Transfer of fields between a rectangle of `size` cells and the same rectangle with cells twice as large.
#[derive(Debug, Clone, Copy)]
pub(crate) struct GridTransfer<'a> {
    size: [usize; 2],
    bodies: &'a HalfSpace,
    coarser: &'a HalfSpace,
}

impl GridTransfer<'_> {
    /// Restricts a field to the coarser cells.
    pub(crate) fn coarsened(&self, field: &[f64]) -> Result<Vec<f64>> {
        self.bodies.coarsened(self.coarser, self.size, field)
    }

    /// Prolongates a field from the coarser cells to the finer cells.
    pub(crate) fn refined(&self, field: &[f64]) -> Result<Vec<f64>> {
        self.bodies.refined(self.coarser, self.size, field)
    }

    /// Prolongates a field that is positive in a zone. At the edge of the zone the field falls to zero like the square root of
    /// the distance from the edge.
    pub(crate) fn refined_zone(&self, field: &[f64]) -> Result<Vec<f64>> {
        self.bodies.refined_zone(self.coarser, self.size, field)
    }

    /// Returns the area of a finer cell divided by the area of a coarser cell.
    pub(crate) fn part_of_area(&self) -> f64 {
        self.bodies.grid().cell_area() / self.coarser.grid().cell_area()
    }

    /// Returns the layout of the finer cells.
    pub(crate) fn layout(&self) -> Layout {
        self.bodies.layout(self.size)
    }

    /// Returns the layout of the coarser cells.
    pub(crate) fn coarse_layout(&self) -> Layout {
        self.coarser.layout(halved(self.size))
    }
}

/// Computes a start from the solution on cells twice as large. The function computes this solution recursively in the same way.
pub(crate) fn nested_start<S: MultilevelProblem<N>, const N: usize>(
    bodies: &HalfSpace,
    size: [usize; 2],
    scene: &S,
    conditions: &mut SolveContext<'_, '_>,
) -> Result<[Vec<f64>; N]> {
    descend(bodies, size, scene, conditions).map(|(found, _)| found)
}

/// Returns whether a start from cells twice as large saves more time than it costs.
pub(crate) fn is_worth_coarsening(bodies: &HalfSpace, size: [usize; 2]) -> bool {
    let is_line = bodies.lines().contains(&true);
    let is_small = if is_line {
        size[0] * size[1] <= COARSEST_LINE
    } else {
        size[0] * size[1] <= COARSEST || size[0].min(size[1]) < NARROW
    };
    !is_small && bodies.can_be_coarser()
}

/// Returns the prior knowledge about a start on these cells.
pub(crate) fn known_of_start<const N: usize>(
    bodies: &HalfSpace,
    size: [usize; 2],
) -> InitialGuess<N> {
    if is_worth_coarsening(bodies, size) {
        InitialGuess::Interpolated
    } else {
        InitialGuess::Nothing
    }
}

/// Computes the [start](nested_start). Also returns the initial residual of the coarser solve, or infinity if there is no
/// coarser solve. Returns `None` for the residual if the observer or the clock ended the coarser solve. No further level is
/// then solved.
fn descend<S: MultilevelProblem<N>, const N: usize>(
    bodies: &HalfSpace,
    size: [usize; 2],
    scene: &S,
    conditions: &mut SolveContext<'_, '_>,
) -> Result<([Vec<f64>; N], Option<f64>)> {
    if !is_worth_coarsening(bodies, size) {
        return Ok((
            scene.plain_start(&bodies.layout(size))?,
            Some(f64::INFINITY),
        ));
    }
    let (coarser, coarse_size) = (bodies.coarser()?, halved(size));
    let levels = GridTransfer {
        size,
        bodies,
        coarser,
    };
    let coarse = scene.coarsened(levels)?;
    let (mut x, mut residual) = descend(coarser, coarse_size, &coarse, conditions)?;
    if let Some(before) = residual {
        let known = known_of_start(coarser, coarse_size);
        let rough = conditions.coarse_settings(before);
        residual = solve(
            (coarser, coarse_size),
            &coarse,
            (&mut x, known),
            &rough,
            conditions,
        )?;
    }
    Ok((scene.refined_start(levels, &coarse, &x)?, residual))
}

/// Solves a coarse problem with a loose tolerance on its window. Returns the initial residual, or `None` if the observer or the
/// clock ended the solve.
fn solve<S: MultilevelProblem<N>, const N: usize>(
    (bodies, size): (&HalfSpace, [usize; 2]),
    scene: &S,
    (x, known): (&mut [Vec<f64>; N], InitialGuess<N>),
    rough: &Settings,
    conditions: &mut SolveContext<'_, '_>,
) -> Result<Option<f64>> {
    let confined = scene.restrict_to_window(bodies, x)?;
    let inside = confined.as_ref().map(|(region, _)| {
        let mut inside: [_; N] = fallible::vector(region.cells())?;
        for (inside, x) in inside.iter_mut().zip(&*x) {
            region.gather(x, inside);
        }
        Ok(inside)
    });
    let mut inside = inside.transpose()?;
    let (size, scene) = match &confined {
        Some((region, part)) => (region.window().size, part),
        None => (size, scene),
    };
    let mut solver = ElasticSolver::<S::Set, N>::new(bodies, scene.directions(), size)?;
    let problem = scene.problem(&solver).verified_by_caller();
    let unknowns = inside.as_mut().unwrap_or(x).each_mut();
    let from = (unknowns.map(Vec::as_mut_slice), known);
    let outcome = solver.minimise(&problem, from, rough, &mut *conditions.observer);
    if let (Some((region, _)), Some(inside)) = (&confined, &inside) {
        for (x, inside) in x.iter_mut().zip(inside) {
            region.scatter(inside, x);
        }
    }
    let is_over = interrupted_status(outcome)?.is_some();
    let begun = solver.report().history.first();
    Ok((!is_over).then(|| begun.map_or(f64::INFINITY, |step| step.residual)))
}
