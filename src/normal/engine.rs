//! The engine of a normal contact: around the contact, with a look at the rest of the grid.

use std::sync::Arc;

use crate::cgm::{self, Interval, Iterate, NonNegative, Total};
use crate::elastic::{ElasticSolver, Observer};
use crate::error::{Error, Result};
use crate::fft::{Convolution, ConvolutionWorkspace};
use crate::half_space::{Compliance, HalfSpace};
use crate::influence::Direction;
use crate::normal::trend::{Reached, Trend};
use crate::operator::Operator;
use crate::parallel;
use crate::window::Window;

/// The engine, set up where it works: around the contact, if that is much smaller than the grid.
#[derive(Debug, Clone)]
pub(super) struct Engine {
    pub(super) window: Window,
    pub(super) solver: ElasticSolver<Interval, 1>,
    /// The gap of the window from the datum.
    linear: Vec<f64>,
    /// Pressure of the window.
    x: Vec<f64>,
    /// How that changed with the load.
    pub(super) trend: Trend,
    /// What it takes to see the rest of the grid, if there is a rest.
    whole: Option<Whole>,
}

#[derive(Debug, Clone)]
struct Whole {
    operator: Arc<Convolution<1>>,
    workspace: ConvolutionWorkspace<1>,
    displacement: Vec<f64>,
}

impl Engine {
    /// On a window, or on the whole grid if it repeats or the window saves too little.
    pub(super) fn new(bodies: &HalfSpace, window: Window) -> Result<Self> {
        let (window, whole) = (bodies.confined(window), Window::whole(bodies.grid()));
        let is_whole = 5 * window.cells() > 4 * whole.cells();
        let window = if is_whole { whole } else { window };
        let beyond = if is_whole {
            None
        } else {
            let Compliance { operator, .. } = bodies.compliance([Direction::Z], whole.size)?;
            Some(Whole {
                workspace: operator.workspace(),
                displacement: vec![0.0; whole.cells()],
                operator,
            })
        };
        Ok(Self {
            solver: ElasticSolver::new(bodies, [Direction::Z], window.size)?,
            linear: vec![0.0; window.cells()],
            x: vec![0.0; window.cells()],
            trend: Trend::default(),
            window,
            whole: beyond,
        })
    }

    /// Takes note of what the last solve changed.
    pub(super) fn note(&mut self, from: Reached, to: Reached) {
        self.trend.note(&self.x, from, to);
    }

    /// The displacement of the whole grid.
    pub(super) fn displacement(&self) -> &[f64] {
        match &self.whole {
            Some(whole) => &whole.displacement,
            None => self.solver.product()[0],
        }
    }
}

/// The load as the engine takes it.
#[derive(Debug, Clone, Copy)]
pub(super) struct Load {
    /// What the gap is measured from: its least value, or the approach where that is prescribed.
    pub(super) datum: f64,
    /// The sum of the pressures, where the force is prescribed.
    pub(super) total: Total,
}

impl Load {
    /// The multiplier there is, if this is it.
    pub(super) fn of(self, multiplier: f64) -> f64 {
        match self.total {
            Total::Free => 0.0,
            _ => multiplier,
        }
    }
}

impl Engine {
    /// Solves on the window, from the pressure of the whole grid into it.
    pub(super) fn solve(
        &mut self,
        gap: &[f64],
        load: Load,
        pressure: &mut [f64],
        settings: &cgm::Settings,
        observer: Observer<'_>,
    ) -> Result<()> {
        self.window.gather(gap, &mut self.linear);
        parallel::update(&mut self.linear, |_, chunk| {
            for gap in chunk {
                *gap -= load.datum;
            }
        });
        self.window.gather(pressure, &mut self.x);
        let outcome = self.solver.minimise(
            [&self.linear],
            NonNegative,
            [load.total],
            [&mut self.x],
            settings,
            observer,
        );
        if matches!(outcome, Ok(()) | Err(Error::NotConverged(_))) {
            pressure.fill(0.0);
            self.window.scatter(&self.x, pressure);
        }
        outcome
    }

    /// Examines the pressure on the whole grid; `None` if the window is the grid.
    pub(super) fn examine(
        &mut self,
        gap: &[f64],
        load: Load,
        pressure: &[f64],
    ) -> Option<cgm::Certificate> {
        let multiplier = self.solver.multiplier();
        let Whole {
            operator,
            workspace,
            displacement,
        } = self.whole.as_mut()?;
        operator.apply([pressure], [displacement], workspace);
        let iterate = Iterate {
            x: [pressure],
            product: [displacement],
            linear: [gap],
            datum: [load.datum],
            totals: [load.total],
            multiplier,
        };
        Some(cgm::examine(&iterate, &NonNegative, operator.lower_bound()))
    }

    /// The cells beyond the window where bodies overlap by more than round-off.
    pub(super) fn missed(
        &self,
        gap: &[f64],
        load: Load,
        round_off: f64,
        bodies: &HalfSpace,
    ) -> Option<Window> {
        let ([multiplier], displacement) = (self.solver.multiplier(), self.displacement());
        Window::around(bodies.grid(), |i| {
            let overlap = displacement[i] + (gap[i] - load.datum) - multiplier;
            overlap < -round_off && !self.window.contains(i)
        })
    }
}
