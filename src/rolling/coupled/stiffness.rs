//! Derivatives of forces and moment with respect to creepages and spin, including the effect of the tractions on the pressure.
//!
//! With fixed zones the equations of both halves are linear. The first solve of a pass computes the change of the pressure
//! for a given change of the tractions. The second solve computes the change of the tractions for this change of the
//! pressure. The passes end when the tractions no longer change.

use std::ops::ControlFlow;

use crate::bodies::component::{Component, Direction};
use crate::cgm::{CellCompliance, Interval, LinearisedSet, Row};
use crate::contact::{LinearResponse, ResponseContext};
use crate::error::{Error, Result};
use crate::half_space::{Compliance, ElasticOperator};
use crate::memory::fallible::{self, TryClone};
use crate::normal::{NormalLoad, NormalSolution};
use crate::numerics::cell_vector::{at, slices, slices_mut};
use crate::numerics::small_matrix::Small;
use crate::observer::{Observer, unwatched};
use crate::operator::{Operator, Scratch};
use crate::parallel::reduce;
use crate::report::{Iteration, Report, Status};
use crate::rolling::RollingSolver;
use crate::rolling::coupled::CoupledRollingSolver;
use crate::rolling::entry::entering;
use crate::rolling::steady::stiffness::{RollingSensitivity, TOLERANCE, check_current};
use crate::tangential::{
    Axis, CouplingDisplacement, EntryCompliance, Friction, Lifting, is_at_limit,
};

/// Relative change of the tractions that ends the iteration.
const CHANGE: f64 = 1e-9;
/// Maximum number of passes per column.
const MOST_PASSES: usize = 200;
/// Largest relative change of gap or pressure in the central difference of an entry compliance.
const DIFFERENCE: f64 = 1e-4;

type IntervalMotion = <Interval as LinearisedSet<1>>::CellMotion;

/// Normal half with a fixed contact area.
struct NormalHalf {
    response: LinearResponse<IntervalMotion, 1>,
    compliance: Compliance<1>,
    /// Derivative of the pressure with respect to the approach, if a force is prescribed.
    by_approach: Option<Vec<f64>>,
    /// Operator on the whole grid.
    whole: ElasticOperator<1>,
    scratch: Scratch,
}

/// Changes caused by a unit creepage or a unit spin.
struct Change {
    /// Changes of the tractions and of the pressure, on the window.
    traction: [Vec<f64>; 2],
    pressure: Vec<f64>,
    /// Changes on the whole grid: the tractions, their lift, the pressure, and the gap under load.
    whole: [Vec<f64>; 2],
    lift: Vec<f64>,
    pressed: Vec<f64>,
    gap: Vec<f64>,
    /// Displacements of the cells over a step, caused by the changes.
    moved: [Vec<f64>; 2],
}

impl CoupledRollingSolver {
    /// Returns the derivatives of forces and moment with respect to creepages and spin at the last solution,
    ///
    /// ```math
    /// \frac{\partial (F_x, F_y, M)}{\partial (\xi, \eta, \varphi)} ,
    /// ```
    ///
    /// with the rows and units of [`RollingSolver::stiffness`]. The normal load is constant. The pressure follows the tractions,
    /// and the friction limits and the entry compliance follow the pressure. The zones and the contact area are fixed. Each
    /// column takes as many passes as a solve. After a change of the loads, the gap or the friction, the call returns an error
    /// until the next solve.
    ///
    /// # Errors
    /// - [`Error::OutdatedSolution`] if the input has changed since the last solve.
    /// - [`Error::NotConverged`] if there is no converged solution, or if the iteration for a column does not converge.
    /// - [`Error::Memory`] if memory runs out.
    pub fn stiffness(&mut self) -> Result<[[f64; 3]; 3]> {
        self.stiffness_observed(unwatched)
    }

    /// Computes [`stiffness`](Self::stiffness) with an observer that is called before every product and may cancel.
    ///
    /// # Errors
    /// The errors of [`stiffness`](Self::stiffness).
    pub fn stiffness_observed(
        &mut self,
        mut observer: impl FnMut(&Iteration) -> ControlFlow<()> + Send,
    ) -> Result<[[f64; 3]; 3]> {
        let unsolved = || Error::NotConverged(Box::new(Report::unsolved()));
        if self.engine.rolling.is_none() {
            return Err(unsolved());
        }
        check_current(self.engine.changed)?;
        let report = &self.engine.report.work;
        if !report.is_converged() {
            return Err(Error::NotConverged(Box::new(report.clone())));
        }
        let mut rolling = self.engine.rolling.take().ok_or_else(unsolved)?;
        let found = match (&mut self.engine.lifting, &self.engine.last) {
            (Some(lifting), Some(normal)) => {
                let friction = &self.problem.friction;
                let is_force = matches!(self.problem.normal, NormalLoad::Force(_));
                rolling.coupled_stiffness(lifting, (normal, friction, is_force), &mut observer)
            }
            (Some(_), None) => Err(unsolved()),
            (None, _) => rolling.slopes(&mut observer),
        };
        self.engine.rolling = Some(rolling);
        found
    }
}

impl RollingSolver {
    fn coupled_stiffness(
        &mut self,
        lifting: &mut Lifting,
        (normal, friction, is_force): (&NormalSolution, &Friction, bool),
        observer: Observer<'_>,
    ) -> Result<[[f64; 3]; 3]> {
        let mut follow = self.take_follow()?;
        let mut context = ResponseContext {
            tolerance: TOLERANCE,
            report: &mut Report::unsolved(),
            observer,
        };
        let found = self.hold_zones(&mut follow).and_then(|()| {
            let mut half = NormalHalf::new(self, is_force, &mut context)?;
            let mut loads = [[0.0; 3]; 3];
            for (motion, loads) in loads.iter_mut().enumerate() {
                let tools = (&mut *lifting, &mut half, &mut follow);
                *loads = self.column(motion, (normal, friction), tools, &mut context)?;
            }
            Ok(Small(loads).transposed().0)
        });
        self.engine.follow = Some(follow);
        found
    }

    /// Returns the changes of forces and moment for a unit creepage or a unit spin.
    fn column(
        &self,
        motion: usize,
        (normal, friction): (&NormalSolution, &Friction),
        (lifting, half, follow): (&mut Lifting, &mut NormalHalf, &mut RollingSensitivity),
        context: &mut ResponseContext<'_>,
    ) -> Result<[f64; 3]> {
        let problem = &self.problem;
        let window = problem.pressed.window();
        let (cells, grid) = (self.engine.limits.len(), problem.bodies.grid());
        let mut drawing =
            CouplingDisplacement::new(&problem.bodies, Axis::BOTH, problem.step.size)?;
        let mut scratch = self.engine.operator.scratch()?;
        let mut change = Change {
            traction: fallible::vector(cells)?,
            pressure: fallible::zeros(cells)?,
            whole: fallible::vector(grid.cells())?,
            lift: fallible::zeros(grid.cells())?,
            pressed: fallible::zeros(grid.cells())?,
            gap: fallible::zeros(grid.cells())?,
            moved: fallible::vector(cells)?,
        };
        for _ in 0..MOST_PASSES {
            for (whole, part) in change.whole.iter_mut().zip(&change.traction) {
                problem.pressed.region.scatter(part, whole);
            }
            lifting.lift(slices(&change.whole).map(Some), &mut change.lift);
            half.follow(self, &mut change, context)?;
            let turned = self.entry_change(normal, &change)?;
            // Tractions of slipping cells follow their friction limits.
            let mut known: [Vec<f64>; 2] = fallible::vector(cells)?;
            for (cell, index) in window.indices().enumerate() {
                let q = at(&slices(&self.engine.traction), cell);
                let size = q[0].hypot(q[1]);
                let pressure = problem.pressed.pressure[cell];
                if pressure > 0.0 && size > 0.0 && is_at_limit(size, self.engine.limits[cell]) {
                    let part = friction.slope(index, pressure) * change.pressure[cell] / size;
                    (known[0][cell], known[1][cell]) = (part * q[0], part * q[1]);
                }
            }
            self.engine
                .operator
                .apply(slices(&known), slices_mut(&mut change.moved), &mut scratch);
            let moved = &mut change.moved;
            drawing.displace(change.pressure.iter().copied(), |axis, displacement| {
                let mut drawn = displacement.to_vec();
                problem.step.difference(&mut drawn);
                for (moved, drawn) in moved[axis.index()].iter_mut().zip(&drawn) {
                    *moved += drawn;
                }
            });
            for (cell, turned) in turned.iter().enumerate() {
                let own = self
                    .engine
                    .own()
                    .added(*turned, 1.0, cell, at(&slices(&known), cell));
                for axis in 0..2 {
                    moved[axis][cell] += own[axis];
                }
            }
            let moved = slices(moved);
            let asked = |cell: usize| {
                let [x, y] = problem.motions(window.index(cell))[motion];
                let [known_x, known_y] = at(&moved, cell);
                [x - known_x, y - known_y]
            };
            let found = follow.tractions(self.elasticity(), asked, context)?;
            let (layout, before) = (self.engine.operator.layout(), slices(&change.traction));
            let [difference, size] = reduce::sum(&layout, |cell| {
                let (free, known) = (at(&found, cell), at(&slices(&known), cell));
                let next = [free[0] + known[0], free[1] + known[1]];
                let [x, y] = at(&before, cell);
                [
                    (next[0] - x).powi(2) + (next[1] - y).powi(2),
                    next[0] * next[0] + next[1] * next[1],
                ]
            });
            for axis in 0..2 {
                for (cell, own) in change.traction[axis].iter_mut().enumerate() {
                    *own = found[axis][cell] + known[axis][cell];
                }
            }
            if difference.sqrt() <= CHANGE * size.sqrt() {
                let traction = slices(&change.traction);
                let load = |cell: usize| self.load_of(cell, at(&traction, cell));
                return Ok(reduce::sum(&layout, load).map(|load| load * grid.cell_area()));
            }
        }
        context.report.status = Status::Stalled;
        Err(Error::NotConverged(Box::new(context.report.clone())))
    }

    /// Returns the displacements that the change of the entry compliance causes under the current tractions. The
    /// derivative is computed as a central difference.
    fn entry_change(&self, normal: &NormalSolution, change: &Change) -> Result<Vec<[f64; 2]>> {
        let problem = &self.problem;
        let (pressed, window) = (&problem.pressed, problem.pressed.window());
        let mut turned = fallible::filled([0.0; 2], change.pressure.len())?;
        let gap = normal.gap().as_slice();
        let relative = |cell: usize| {
            if self.engine.own().mean(cell) <= 0.0 {
                return 0.0;
            }
            let before = problem.step.before(cell).map(|before| window.index(before));
            let of_gap = before.map_or(0.0, |before| (change.gap[before] / gap[before]).abs());
            of_gap.max((change.pressure[cell] / pressed.pressure[cell]).abs())
        };
        let largest = reduce::max(&self.engine.operator.layout(), relative);
        if largest <= 0.0 {
            return Ok(turned);
        }
        let part = DIFFERENCE / largest;
        let entry = |part: f64| -> Result<Vec<EntryCompliance>> {
            let (mut normal, mut pressed) = (normal.try_clone()?, pressed.try_clone()?);
            let (_, gap, ..) = normal.parts_mut();
            for (gap, change) in gap.as_mut_slice().iter_mut().zip(&change.gap) {
                *gap += part * change;
            }
            for (pressure, change) in pressed.pressure.iter_mut().zip(&change.pressure) {
                *pressure += part * change;
            }
            let mut own = fallible::filled(EntryCompliance::NONE, change.pressure.len())?;
            entering(&normal, &pressed, problem.step, &mut own);
            Ok(own)
        };
        let (more, less) = (entry(part)?, entry(-part)?);
        for (cell, (more, less)) in more.iter().zip(&less).enumerate() {
            if self.engine.own().mean(cell) > 0.0 {
                let [x, y] = at(&slices(&self.engine.traction), cell).map(|q| self.engine.unit * q);
                let slope = |more: f64, less: f64| (more - less) / (2.0 * part);
                let [xx, xy, yy] = [
                    slope(more.xx, less.xx),
                    slope(more.xy, less.xy),
                    slope(more.yy, less.yy),
                ];
                turned[cell] = [xx * x + xy * y, xy * x + yy * y];
            }
        }
        Ok(turned)
    }
}

impl NormalHalf {
    fn new(of: &RollingSolver, is_force: bool, context: &mut ResponseContext<'_>) -> Result<Self> {
        let problem = &of.problem;
        let compliance = problem
            .bodies
            .compliance([Direction::Z], problem.step.size)?;
        let whole = problem
            .bodies
            .operator_of([[Component::ZZ]], problem.bodies.grid().size())?;
        let Compliance { operator, inverse } = &compliance;
        let mut half = Self {
            response: LinearResponse::new(operator, inverse, operator.layout())?,
            scratch: whole.scratch()?,
            whole,
            compliance,
            by_approach: None,
        };
        let pressure = &problem.pressed.pressure;
        half.response.linear.hold(|cell| {
            if pressure[cell] > 0.0 {
                IntervalMotion::FREE
            } else {
                IntervalMotion::FIXED
            }
        })?;
        if is_force {
            let elasticity = half.compliance.with_cells(CellCompliance::default());
            let [unit] = half.response.tractions(elasticity, |_| [1.0], context)?;
            half.by_approach = Some(fallible::copied(unit)?);
        }
        Ok(half)
    }

    /// Computes the change of the pressure that keeps the contact closed under a lift, and the change of the gap.
    fn follow(
        &mut self,
        of: &RollingSolver,
        change: &mut Change,
        context: &mut ResponseContext<'_>,
    ) -> Result<()> {
        let pressed = &of.problem.pressed;
        let window = pressed.window();
        let lift = &change.lift;
        if reduce::max(&self.response.layout, |cell| lift[window.index(cell)].abs()) > 0.0 {
            let elasticity = self.compliance.with_cells(CellCompliance::default());
            let lift = |cell: usize| [-lift[window.index(cell)]];
            let [found] = self.response.tractions(elasticity, lift, context)?;
            change.pressure.copy_from_slice(found);
        } else {
            change.pressure.fill(0.0);
        }
        let mut approach = 0.0;
        if let Some(by_approach) = &self.by_approach {
            let missing = reduce::total(&self.response.layout, &change.pressure);
            approach = -missing / reduce::total(&self.response.layout, by_approach);
            for (pressure, unit) in change.pressure.iter_mut().zip(by_approach) {
                *pressure += approach * unit;
            }
        }
        pressed
            .region
            .scatter(&change.pressure, &mut change.pressed);
        self.whole
            .apply([&change.pressed], [&mut change.gap], &mut self.scratch);
        for (gap, lift) in change.gap.iter_mut().zip(lift) {
            *gap += lift - approach;
        }
        Ok(())
    }
}
