//! Refinement of the grid until the estimates reach their targets.

use std::ops::ControlFlow;

use super::gap::evaluate;
use super::measures::{FrictionMeasures, Measures, Quantity, Unresolved};
use super::problem::{AdaptiveProblem, Shear, ShearLoad};
use super::region::Extent;
use super::search::{ContactBox, bumps_inside_cells, gap_inside_cells, locate, overlap_outside};
use super::solution::{AdaptiveSolution, AdaptiveStatus, Estimate, GridRecord, SolvedContact};
use crate::error::Result;
use crate::grid::cell_value::CellValue;
use crate::grid::field::Field;
use crate::half_space::HalfSpace;
#[cfg(feature = "history")]
use crate::history::History;
use crate::normal::{NormalProblem, NormalSolution};
use crate::support::clock::Instant;
use crate::tangential::TangentialProblem;

/// Number of cells along a side of the first grid.
const FIRST_CELLS: f64 = 24.0;
/// Number of cells of the first grid of a line.
const FIRST_LINE_CELLS: f64 = 48.0;
/// Limits of the ratio of the numbers of cells along a side of two successive grids.
const GROWTH: [f64; 2] = [1.5, 4.0];
/// Least ratio of the numbers of cells along a side for which a grid reduced to a limit is solved.
const LEAST_GROWTH: f64 = 1.2;
/// Order of convergence that predicts the next grid.
const ORDER: f64 = 1.7;
/// Tolerance of a solve divided by the smallest target.
const SOLVER_SHARE: f64 = 0.02;
/// Limits of the tolerance of a solve.
const TOLERANCES: [f64; 2] = [1e-9, 1e-3];
/// Factor of the difference of a number (not a field) in its estimated error if only two grids were solved.
const FEW_GRIDS: f64 = 3.0;
/// Number of extents after which the next extent is the whole region.
const MOST_EXTENTS: usize = 12;

/// Solves a problem on successively finer grids.
pub(super) fn solve(
    problem: &AdaptiveProblem<'_>,
    observer: &mut dyn FnMut(&GridRecord) -> ControlFlow<()>,
) -> Result<AdaptiveSolution> {
    let start = Instant::now();
    let mut extent = locate(problem, problem.region.whole)?;
    let mut records = Vec::new();
    let mut sizes = first_cells(problem);
    let mut extents = 0;
    let mut previous: Option<(Measures, Vec<Estimate>)> = None;
    loop {
        let cells = whole_cells(sizes);
        let grid = OneGrid::solve(problem, extent, cells)?;
        let normal = grid.contact.normal();
        if let Some(wider) = wider_extent(problem, extent, normal)? {
            extents += 1;
            extent = match extents {
                ..MOST_EXTENTS => wider,
                _ => problem.region.whole,
            };
            previous = None;
            continue;
        }
        let estimates = previous
            .as_ref()
            .map(|(coarse, errors)| grid.estimates(problem, coarse, errors));
        let estimates = estimates.transpose()?.unwrap_or_default();
        let record = GridRecord {
            grid: grid.gap.grid(),
            centre: extent.centre(),
            estimates: estimates.clone(),
        };
        let is_cancelled = observer(&record).is_break();
        records.push(record);
        let worst = worst_ratio(&estimates);
        let mut next = match worst {
            Some(ratio) => grown(sizes, ratio),
            None => grown(balanced(problem, sizes, normal), grid.first_ratio(problem)),
        };
        let status = if worst.is_some_and(|ratio| ratio <= 1.0) {
            Some(AdaptiveStatus::Reached)
        } else if is_cancelled {
            Some(AdaptiveStatus::Cancelled)
        } else {
            limited(problem, extent, sizes, &mut next, start)
        };
        if let Some(status) = status {
            return Ok(AdaptiveSolution {
                bodies: grid.bodies,
                gap: grid.gap,
                extent,
                contact: grid.contact,
                measures: grid.measures,
                estimates,
                status,
                grids: records,
            });
        }
        previous = Some((grid.measures, estimates));
        sizes = next;
    }
}

/// Reduces the numbers of cells of the next grid to the limits. Returns the reason why no further grid is permitted, if any.
fn limited(
    problem: &AdaptiveProblem<'_>,
    extent: Extent,
    sizes: [f64; 2],
    next: &mut [f64; 2],
    start: Instant,
) -> Option<AdaptiveStatus> {
    let is_late = |limit| start.elapsed() >= limit;
    if problem.time_limit.is_some_and(is_late) {
        return Some(AdaptiveStatus::TimeLimit);
    }
    let mut status = None;
    let count = |sizes: [f64; 2]| {
        let [nx, ny] = whole_cells(sizes);
        nx.saturating_mul(ny)
    };
    while count(*next) > problem.cell_limit {
        *next = scaled(*next, [0.99; 2]);
        status = Some(AdaptiveStatus::CellLimit);
    }
    if let Some(spacing) = problem.gap.sample_spacing() {
        let sides = extent.sides();
        let most = [0, 1].map(|axis| 2.0 * (0.5 * sides[axis] / spacing[axis]).floor());
        let factors = [0, 1].map(|axis| (most[axis] / next[axis]).min(1.0));
        if factors.iter().any(|factor| *factor < 1.0) {
            *next = scaled(*next, factors);
            status = Some(AdaptiveStatus::SampleSpacing);
        }
    }
    let is_finer = (0..2).any(|axis| next[axis] > LEAST_GROWTH * sizes[axis]);
    status.filter(|_| !is_finer)
}

/// Multiplies the numbers of cells along the refined axes by the factors.
fn scaled(sizes: [f64; 2], factors: [f64; 2]) -> [f64; 2] {
    let scaled = |axis: usize| match sizes[axis] {
        size if size > 1.0 => (factors[axis] * size).max(2.0),
        size => size,
    };
    [scaled(0), scaled(1)]
}

fn first_cells(problem: &AdaptiveProblem<'_>) -> [f64; 2] {
    if problem.region.is_line {
        [FIRST_LINE_CELLS, 1.0]
    } else {
        [FIRST_CELLS; 2]
    }
}

/// Returns the numbers of cells as integers. Numbers above one are even.
#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "positive numbers of cells, which saturate"
)]
fn whole_cells(sizes: [f64; 2]) -> [usize; 2] {
    sizes.map(|size| {
        if size > 1.0 {
            2 * (0.5 * size).ceil() as usize
        } else {
            1
        }
    })
}

/// Returns the numbers of cells of the next grid, for the largest ratio of an error to its target.
fn grown(sizes: [f64; 2], ratio: f64) -> [f64; 2] {
    let factor = (1.2 * ratio).powf(1.0 / ORDER).clamp(GROWTH[0], GROWTH[1]);
    scaled(sizes, [factor; 2])
}

/// Returns numbers of cells for which the errors due to both sides of the cells are similar. The second differences of the
/// pressure along each axis measure these errors.
fn balanced(problem: &AdaptiveProblem<'_>, sizes: [f64; 2], normal: &NormalSolution) -> [f64; 2] {
    if problem.region.is_line {
        return sizes;
    }
    let (pressure, grid) = (normal.pressure().as_slice(), normal.grid());
    let [nx, ny] = grid.size();
    let value = |ix: usize, iy: usize| pressure[iy * nx + ix];
    let mut sums = [0.0_f64; 2];
    for iy in 1..ny - 1 {
        for ix in 1..nx - 1 {
            let twice = 2.0 * value(ix, iy);
            sums[0] += (value(ix - 1, iy) + value(ix + 1, iy) - twice).abs();
            sums[1] += (value(ix, iy - 1) + value(ix, iy + 1) - twice).abs();
        }
    }
    let ratio = (sums[0] / sums[1]).powf(0.5 / ORDER);
    let ratio = if ratio.is_finite() {
        ratio.clamp(0.5, 2.0)
    } else {
        1.0
    };
    [sizes[0] * ratio, sizes[1] / ratio]
}

/// Returns a wider extent if the contact reaches an end of the extent inside the region, or if the bodies overlap outside the
/// extent.
fn wider_extent(
    problem: &AdaptiveProblem<'_>,
    extent: Extent,
    normal: &NormalSolution,
) -> Result<Option<Extent>> {
    let Some(contact) = ContactBox::of(normal) else {
        return Ok(None);
    };
    let touched = contact.widened(problem, extent, normal.grid());
    if touched.is_some() {
        return Ok(touched);
    }
    match overlap_outside(problem, extent, normal)? {
        Some(wider) => locate(problem, wider).map(Some),
        None => Ok(None),
    }
}

/// Contact on one grid with its quantities.
struct OneGrid {
    bodies: HalfSpace,
    gap: Field,
    contact: SolvedContact,
    measures: Measures,
}

impl OneGrid {
    fn solve(problem: &AdaptiveProblem<'_>, extent: Extent, cells: [usize; 2]) -> Result<Self> {
        let grid = extent.grid(cells)?;
        let bodies = bodies(problem, extent, cells)?;
        let gap = evaluate(problem.gap, &extent.positions(cells, [1, 1])?)?;
        let gap = Field::from_vec(grid, gap)?;
        let (contact, friction) = solve_contact(problem, &bodies, &gap)?;
        let measures = Measures::new(extent, contact.normal(), gap.min(), friction)?;
        Ok(Self {
            bodies,
            gap,
            contact,
            measures,
        })
    }

    /// Estimates the errors of this solution from its differences from a coarser solution.
    fn estimates(
        &self,
        problem: &AdaptiveProblem<'_>,
        coarse: &Measures,
        previous: &[Estimate],
    ) -> Result<Vec<Estimate>> {
        let cells = |measures: &Measures| {
            let [width, height] = measures.extent.sides();
            let grid = measures.pressure.grid();
            let axes = if problem.region.is_line { 1.0 } else { 2.0 };
            (width * height / grid.cell_area()).powf(1.0 / axes)
        };
        let growth = cells(&self.measures) / cells(coarse);
        let unresolved = self.unresolved(problem)?;
        let from_difference = |quantity: Quantity| {
            let difference = self.measures.difference(coarse, quantity)?;
            Ok(difference / (growth.powf(quantity.order()) - 1.0))
        };
        let estimate = |quantity: Quantity| {
            let mut error = from_difference(quantity)?;
            let earlier = previous.iter().find(|earlier| earlier.quantity == quantity);
            if let Some(earlier) = earlier {
                error = error.max(earlier.error / growth.powf(ORDER));
            } else if let Some((field, part)) = quantity.field_of_number() {
                // A number can agree on two grids by chance. Fields of resolved spots cannot.
                error = (FEW_GRIDS * error).max(part * from_difference(field)?);
            }
            let least = match quantity {
                Quantity::Pressure => unresolved.pressure.max(unresolved.spots),
                // Tractions that are zero everywhere have no error.
                Quantity::Traction | Quantity::StickRatio if self.measures.is_sheared() => {
                    unresolved.spots
                }
                Quantity::Area => unresolved.area,
                _ => 0.0,
            };
            error = error.max(least);
            let mut targets = problem.targets.iter();
            Ok(Estimate {
                quantity,
                error,
                target: targets
                    .find(|(target, _)| *target == quantity)
                    .map(|(_, target)| *target),
            })
        };
        let has_friction = problem.friction.is_some();
        let all = Quantity::ALL.into_iter();
        let known = all.filter(|quantity| has_friction || !quantity.is_tangential());
        known.map(estimate).collect()
    }

    /// Returns the least errors due to structures that the cells do not resolve.
    fn unresolved(&self, problem: &AdaptiveProblem<'_>) -> Result<Unresolved> {
        let differences = gap_inside_cells(problem, self.measures.extent, &self.gap)?;
        let normal = self.contact.normal();
        let bumps = bumps_inside_cells(problem, self.measures.extent, &self.gap, normal)?;
        let compliance = self.bodies.cell_compliance();
        Ok(Unresolved::new(normal, [&differences, &bumps], compliance))
    }

    /// Returns the ratio of error to target that the second differences of the first solution predict.
    fn first_ratio(&self, problem: &AdaptiveProblem<'_>) -> f64 {
        let estimate = self.contact.normal().discretisation_estimate();
        let targets = problem.targets.iter().map(|(_, target)| *target);
        0.4 * estimate.unwrap_or(1.0) / targets.fold(1.0, f64::min)
    }
}

/// Creates the bodies on a grid that covers an extent.
pub(super) fn bodies(
    problem: &AdaptiveProblem<'_>,
    extent: Extent,
    cells: [usize; 2],
) -> Result<HalfSpace> {
    let bodies = problem.bodies.clone();
    let bodies = HalfSpace::with_boundary(extent.grid(cells)?, bodies, problem.region.boundary)?;
    bodies.with_cell_value(CellValue::Centre)
}

/// Solves the contact on one grid.
fn solve_contact(
    problem: &AdaptiveProblem<'_>,
    bodies: &HalfSpace,
    gap: &Field,
) -> Result<(SolvedContact, Option<FrictionMeasures>)> {
    let tolerance = tolerance(problem);
    let Some(Shear { friction, load }) = &problem.friction else {
        let normal = press(problem, bodies, gap, tolerance)?;
        return Ok((SolvedContact::Normal(Box::new(normal)), None));
    };
    match load {
        ShearLoad::AfterPressing(load) => {
            let normal = press(problem, bodies, gap, tolerance)?;
            let builder = TangentialProblem::builder(bodies, &normal, friction.clone(), *load);
            let builder = builder.model(problem.model).tolerance(tolerance);
            let builder = match problem.coupling {
                Some(coupling) => builder.coupling(coupling),
                None => builder,
            };
            let shear = builder.build()?.solve()?;
            let measures = FrictionMeasures::of_solution(&shear, &normal, friction)?;
            let both = Box::new((normal, shear, friction.clone()));
            Ok((SolvedContact::Sheared(both), Some(measures)))
        }
        #[cfg(feature = "history")]
        ShearLoad::Step(step) => {
            let builder = History::builder(bodies, gap, friction.clone());
            let builder = builder.model(problem.model).tolerance(tolerance);
            let builder = match problem.coupling {
                Some(coupling) => builder.coupling(coupling),
                None => builder,
            };
            let mut history = builder.build()?;
            history.step(&step.normal(problem.load))?;
            let raw = (history.traction(), history.last_step()?.stick_ratio());
            let measures = FrictionMeasures::new(history.edges(), raw, history.shift())?;
            Ok((SolvedContact::Step(Box::new(history)), Some(measures)))
        }
    }
}

fn press(
    problem: &AdaptiveProblem<'_>,
    bodies: &HalfSpace,
    gap: &Field,
    tolerance: f64,
) -> Result<NormalSolution> {
    let builder = NormalProblem::builder(bodies, gap, problem.load).tolerance(tolerance);
    builder.build()?.solve()
}

/// Returns the tolerance of the solves.
fn tolerance(problem: &AdaptiveProblem<'_>) -> f64 {
    let targets = problem.targets.iter().map(|(_, target)| *target);
    let [least, most] = TOLERANCES;
    (SOLVER_SHARE * targets.fold(1.0, f64::min)).clamp(least, most)
}

/// Returns the largest ratio of an estimate to its target, or `None` without estimates.
fn worst_ratio(estimates: &[Estimate]) -> Option<f64> {
    estimates
        .iter()
        .filter_map(Estimate::ratio)
        .reduce(f64::max)
}
