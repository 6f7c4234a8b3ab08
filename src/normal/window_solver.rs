//! Solver of a normal contact on the window around the contact. The solver also examines the rest of the grid.

use crate::bodies::component::Direction;
use crate::cgm::{self, InitialGuess, Interval, Iterate};
use crate::contact::{
    self, ElasticSolver, LoadIncrement, LoadPoint, LoadTrend, WindowEngine, has_iterate,
};
use crate::error::Result;
use crate::grid::window::Window;
use crate::half_space::{Compliance, ElasticOperator, HalfSpace, Region};
use crate::memory::fallible::{self, TryClone};
use crate::memory::pool::PooledBuffer;
use crate::normal::pressure_problem::PressureProblem;
use crate::observer::Observer;
use crate::operator::{Operator, Scratch};
use crate::parallel::{self, Blocks};
use crate::report::EigenvalueBound;
use std::borrow::Cow;

/// Active-set solver on a window around the contact, or on the whole grid if the contact is not much smaller than the
/// grid.
#[derive(Debug, Clone)]
pub(super) struct NormalEngine {
    region: Region,
    pub(super) solver: ElasticSolver<Interval, 1>,
    /// Change of the pressure of the window with the load.
    trend: LoadTrend<1>,
    /// Whether the trend contains the pressure before the extrapolation. [`Self::note`] replaces this pressure by the
    /// change.
    is_extrapolated: bool,
    /// Operator and fields for a window that is smaller than the grid, or `None` if the window is the whole grid.
    part: Option<NormalPart>,
}

#[derive(Debug, Clone)]
struct NormalPart {
    /// Operator of the whole grid.
    operator: ElasticOperator<1>,
    fields: PooledBuffer<NormalPartFields>,
}

#[derive(Debug)]
struct NormalPartFields {
    /// Gap of the window.
    gap: Vec<f64>,
    pressure: Vec<f64>,
    /// Pressure limits of the window. Empty if the limit is uniform.
    limits: Vec<f64>,
    /// Displacement of the whole grid.
    displacement: Vec<f64>,
    scratch: Scratch,
}

impl NormalPart {
    /// Returns the fields for a window of `cells` cells.
    fn fields(&mut self, cells: usize) -> Result<&mut NormalPartFields> {
        let operator = &self.operator;
        self.fields.take(|| {
            Ok(NormalPartFields {
                gap: fallible::zeros(cells)?,
                pressure: fallible::zeros(cells)?,
                limits: Vec::new(),
                displacement: fallible::zeros(operator.cells())?,
                scratch: operator.scratch()?,
            })
        })
    }
}

impl WindowEngine for NormalEngine {
    fn new(bodies: &HalfSpace, window: Window) -> Result<Self> {
        let (window, whole) = (bodies.place(window), Window::whole(bodies.grid()));
        let part = if window == whole {
            None
        } else {
            let Compliance { operator, .. } = bodies.compliance([Direction::Z], whole.size)?;
            Some(NormalPart {
                operator,
                fields: PooledBuffer::new(bodies.pool(&[], window.size)?),
            })
        };
        Ok(Self {
            solver: ElasticSolver::new(bodies, [Direction::Z], window.size)?,
            trend: LoadTrend::default(),
            is_extrapolated: false,
            region: Region::new(bodies, window),
            part,
        })
    }

    fn window(&self) -> Window {
        self.region.window()
    }

    /// Moves the solver to a window of the same size and discards the trend.
    fn move_to(&mut self, bodies: &HalfSpace, window: Window) {
        self.region = Region::new(bodies, window);
        self.is_extrapolated = false;
        self.trend.forget();
    }

    /// Returns the buffers to their pools. The displacement is lost.
    fn rest(&mut self) {
        self.solver.rest();
        if let Some(part) = &mut self.part {
            part.fields.give_back();
        }
    }
}

impl NormalEngine {
    /// Sets the trend from the local cells of `trend`.
    ///
    /// # Errors
    /// - [`Error::Memory`](crate::Error::Memory) if memory runs out.
    pub(super) fn set_trend(&mut self, trend: &LoadTrend<1>) -> Result<()> {
        if self.region.is_shared() && !trend.is_known() {
            self.trend.forget();
            return Ok(());
        }
        self.trend.try_clone_from(trend)?;
        if let Cow::Owned(change) = self.region.taken(&trend.change[0]) {
            self.trend.change = [change];
        }
        Ok(())
    }

    /// Returns the number of local cells of the trend.
    pub(super) fn trend_cells(&self) -> usize {
        self.region.held().cells().max(self.trend.change[0].len())
    }

    /// Writes the trend of the local cells.
    pub(super) fn write_trend(&self, trend: &mut LoadTrend<1>) {
        trend.clone_from(&self.trend);
        if self.region.is_shared() && !trend.is_known() {
            return trend.forget();
        }
        if let Cow::Owned(change) = self.region.given(&self.trend.change[0]) {
            trend.change = [change];
        }
    }

    /// Returns the ratio of the remaining change of the load to its last change.
    pub(super) fn parts(&self, ahead: LoadIncrement) -> Option<f64> {
        self.trend.parts([ahead])
    }

    /// Returns the displacement of the whole grid. The slice is empty before the first solve.
    pub(super) fn displacement(&self) -> &[f64] {
        match &self.part {
            Some(part) => part
                .fields
                .held()
                .map_or(&[], |fields| &fields.displacement),
            None => self.solver.product()[0],
        }
    }

    /// Returns the displacement of the whole grid and drops all other buffers.
    pub(super) fn into_displacement(self) -> Vec<f64> {
        if let Some(part) = self.part {
            let fields = part.fields.into_piece();
            return fields.map(|fields| fields.displacement).unwrap_or_default();
        }
        let [displacement] = self.solver.into_product();
        displacement
    }

    /// Solves on the window. The pressure of the whole grid is the start and receives the result.
    pub(super) fn solve(
        &mut self,
        scene: PressureProblem<&[f64]>,
        (pressure, known): (&mut [f64], InitialGuess<1>),
        settings: &cgm::Settings,
        observer: Observer<'_>,
    ) -> Result<()> {
        let (region, solver) = (&self.region, &mut self.solver);
        let Some(part) = &mut self.part else {
            let problem = scene.problem(solver);
            return solver.minimise(&problem, ([pressure], known), settings, observer);
        };
        let cells = region.cells();
        let fields = part.fields(cells)?;
        region.gather(scene.gap, &mut fields.gap);
        region.gather(pressure, &mut fields.pressure);
        let own_limits = &mut fields.limits;
        let inside = PressureProblem {
            gap: &*fields.gap,
            limits: scene.limits.try_map(|limits| {
                fallible::resize(own_limits, cells, 0.0)?;
                region.gather(limits, own_limits);
                Ok(own_limits.as_slice())
            })?,
            ..scene
        };
        let problem = inside.problem(solver).verified_by_caller();
        let from = ([&mut *fields.pressure], known);
        let outcome = solver.minimise(&problem, from, settings, observer);
        if has_iterate(&outcome) {
            pressure.fill(0.0);
            region.scatter(&fields.pressure, pressure);
        }
        outcome
    }

    /// Examines the pressure on the whole grid. Returns the certificate and the origin of the bound on the least
    /// eigenvalue, or `None` if the window is the whole grid.
    pub(super) fn examine(
        &mut self,
        scene: PressureProblem<&[f64]>,
        pressure: &[f64],
    ) -> Result<Option<(cgm::Certificate, EigenvalueBound)>> {
        let multiplier = self.solver.multiplier();
        let Some(part) = &mut self.part else {
            return Ok(None);
        };
        let operator = part.operator.clone();
        let NormalPartFields {
            displacement,
            scratch,
            ..
        } = part.fields(self.region.cells())?;
        operator.apply([pressure], [displacement], scratch);
        let layout = operator.layout();
        let iterate = Iterate {
            layout: &layout,
            x: [pressure],
            product: [displacement],
            linear: [scene.gap],
            datum: [scene.datum],
            totals: [scene.total],
            multiplier,
        };
        let cells = layout.of_all_ranks();
        let bound = operator.lower_bound_of([scene.total.uniform_compliance(cells)])?;
        let findings = cgm::examine(&iterate, &scene.constraint(), bound);
        Ok(Some((findings, bound.known)))
    }

    /// Returns the window around the overlapping cells outside the present window. In these cells the bodies overlap by
    /// more than the round-off of the largest displacement.
    pub(super) fn overlap_outside(
        &self,
        scene: PressureProblem<&[f64]>,
        largest: f64,
        bodies: &HalfSpace,
    ) -> Option<Window> {
        let ([multiplier], displacement) = (self.solver.multiplier(), self.displacement());
        contact::overlap_outside(bodies, self.window(), largest, |i| {
            displacement[i] + (scene.gap[i] - scene.datum) - multiplier
        })
    }

    /// Extrapolates the pressure of the whole grid by `parts` times the trend. The trend then contains the previous
    /// pressure.
    pub(super) fn extrapolate(&mut self, parts: f64, pressure: &mut [f64]) -> Result<()> {
        let (region, cells) = (&self.region, self.region.cells());
        let [change] = &mut self.trend.change;
        fallible::resize(change, cells, 0.0)?;
        self.trend.by = [[0.0; 2]];
        self.is_extrapolated = true;
        let Some(part) = &mut self.part else {
            go_on(parts, pressure, change);
            return Ok(());
        };
        let inside = &mut part.fields(cells)?.pressure;
        region.gather(pressure, inside);
        go_on(parts, inside, change);
        region.scatter(inside, pressure);
        Ok(())
    }

    /// Stores the change from the pressure before [`Self::extrapolate`] to the solution as the trend.
    pub(super) fn note(&mut self, pressure: &[f64], from: LoadPoint, to: LoadPoint) -> Result<()> {
        let (region, cells) = (&self.region, self.region.cells());
        let [change] = &mut self.trend.change;
        // A solver that was set up on a wider window after the extrapolation has no earlier pressure to compare with.
        if !std::mem::take(&mut self.is_extrapolated) {
            return Ok(());
        }
        match &mut self.part {
            Some(part) => {
                let inside = &mut part.fields(cells)?.pressure;
                region.gather(pressure, inside);
                subtract_from(inside, change);
            }
            None => subtract_from(pressure, change),
        }
        self.trend.by = [[to[0] - from[0], to[1] - from[1]]];
        Ok(())
    }
}

/// Extrapolates pressures by `parts` times their changes. `change` then contains the previous pressures.
fn go_on(parts: f64, pressure: &mut [f64], change: &mut [f64]) {
    let data = (parallel::blocks(pressure), parallel::blocks(change));
    let tasks = data.0.items.len().div_ceil(parallel::CHUNK);
    let work = |_: usize, (pressure, change): (Blocks<'_, f64>, Blocks<'_, f64>)| {
        for (p, change) in pressure.items.iter_mut().zip(change.items) {
            let before = *p;
            *p = (before + parts * *change).max(0.0);
            *change = before;
        }
    };
    parallel::sweep(0..tasks, data, &work, &|(), ()| ());
}

/// Replaces each earlier pressure in `change` by the difference of the new and the earlier pressure.
fn subtract_from(pressure: &[f64], change: &mut [f64]) {
    parallel::update(change, |first, chunk| {
        for (change, p) in chunk.iter_mut().zip(&pressure[first..]) {
            *change = p - *change;
        }
    });
}
