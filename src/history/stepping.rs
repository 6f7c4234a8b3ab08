//! A history: its state, and how it takes a step.

use std::ops::ControlFlow;

use crate::boundary::Boundary;
use crate::cgm::{Iteration, Settings};
use crate::error::Result;
use crate::field::Field;
use crate::grid::Grid;
use crate::half_space::HalfSpace;
use crate::history::builder::HistoryBuilder;
use crate::history::layout::axes_of;
use crate::history::shear::Shear;
use crate::history::state::State;
use crate::history::{LoadStep, Step};
use crate::influence::Component;
use crate::normal::{NormalLoad, NormalProblem, NormalSolution, NormalSolver};
use crate::operator::Operator;
use crate::parallel;
use crate::report::{Report, Status};
use crate::stage::{Observer, with_memory};
use crate::tangential::{Axis, Friction, Zone, direction};

/// Two bodies in contact that remember their load: pressure, traction, slip and energy, step by step.
///
/// Vectors are `[x, y]`; the scalar model leaves the component across its axis at zero.
///
/// Beside its bodies it takes 180 bytes per cell of the grid and 350 per cell of the contact's bounding box,
/// in the plane model ([`HistoryBuilder::lateral`]) 580 there, operators included, and one or two megabytes
/// whatever the size. A contact that outgrows the box takes a wider one for good, and in that step a quarter more in
/// all, in the plane two fifths. After the first steps, a step within it allocates nothing.
///
/// It is saved by [`to_bytes`](Self::to_bytes) and goes on by [`restore`](Self::restore), on bodies made anew. A
/// clone keeps it in memory, buffers and all: to go back by, or to try what comes of another load.
/// Many histories may share one [`HalfSpace`] on many threads: each comes to the bits it has alone.
///
/// ```
/// use stickslip::*;
/// let grid = Grid::square(48, 0.30e-3)?;
/// let steel = Material::new(213e9, 0.29)?;
/// let bodies = HalfSpace::new(grid, ElasticPair::new(steel, steel)?)?;
/// let ball = surface::sphere(grid, 3.5e-3)?;
/// let mut history = History::builder(&bodies, &ball, Friction::coulomb(0.5)?).build()?;
///
/// // Press, then shear to and fro.
/// history.step(&LoadStep::hold().normal(NormalStep::Force(100.0)))?;
/// let shear = |force| LoadStep::hold().tangential(Axis::X, TangentialStep::Force(force));
/// history.step(&shear(30.0))?;
/// let mut cycle = 0.0;
/// for force in [-30.0, 30.0] {
///     cycle += history.step(&shear(force))?.energy().dissipated;
/// }
/// // A full cycle dissipates four times what the first quarter did.
/// let hertz = analytical::HertzSphere::new(bodies.pair(), 3.5e-3, 100.0)?;
/// let quarter = analytical::CattaneoMindlin::new(hertz, 0.5, 30.0)?.dissipated_energy();
/// assert!((cycle / (4.0 * quarter) - 1.0).abs() < 0.01);
///
/// // Without force the contact is not without shear.
/// history.step(&shear(0.0))?;
/// assert!(history.shift()[0] > 0.0 && history.traction()[0].max() > 0.0);
/// # Ok::<(), Error>(())
/// ```
#[derive(Debug, Clone)]
pub struct History {
    pub(super) bodies: HalfSpace,
    pub(super) friction: Friction,
    pub(super) settings: Settings,
    pub(super) press: NormalSolver,
    /// The normal contact after the last step.
    pub(super) normal: NormalSolution,
    /// Whether the gap has changed since.
    is_pressure_stale: bool,
    /// That of the step under way.
    candidate: NormalSolution,
    pub(super) shear: Shear,
    pub(super) state: State,
    step: Step,
}

const _: () = {
    const fn assert_send<T: Send>() {}
    assert_send::<History>();
};

impl History {
    /// Starts from what is required: bodies, gap before loading (lengths, on the grid of the bodies) and
    /// friction. Nothing touches and nothing is sheared before the first step.
    pub fn builder<'a>(
        bodies: &'a HalfSpace,
        gap: &'a Field,
        friction: Friction,
    ) -> HistoryBuilder<'a> {
        HistoryBuilder::new(bodies, gap, friction)
    }

    pub(super) fn new(
        bodies: &HalfSpace,
        gap: &Field,
        friction: Friction,
        axis: Option<Axis>,
        settings: Settings,
    ) -> Result<Self> {
        let grid = bodies.grid();
        friction.check(grid)?;
        let press = NormalProblem::builder(bodies, gap, NormalLoad::Force(0.0))
            .settings(settings)
            .build()?
            .into_solver()?;
        Ok(Self {
            bodies: bodies.clone(),
            friction,
            settings,
            normal: press.new_solution(),
            is_pressure_stale: false,
            candidate: press.new_solution(),
            press,
            shear: Shear::new(bodies, axis),
            state: State::new(grid),
            step: Step::new(grid),
        })
    }

    /// Takes a step, and returns what it did; also [`History::last_step`] afterwards.
    ///
    /// # Errors
    /// [`Error::NotFinite`](crate::Error::NotFinite), [`Error::Negative`](crate::Error::Negative),
    /// [`Error::NotPositive`](crate::Error::NotPositive),
    /// [`Error::ApproachBeyondMeanGap`](crate::Error::ApproachBeyondMeanGap) or
    /// [`Error::NotModelled`](crate::Error::NotModelled) for the load;
    /// [`Error::BeyondSliding`](crate::Error::BeyondSliding) if friction does not hold the force;
    /// [`Error::NotConverged`](crate::Error::NotConverged). The history is then as it was, bit for bit.
    pub fn step(&mut self, load: &LoadStep) -> Result<&Step> {
        self.step_observed(load, |_| ControlFlow::Continue(()))
    }

    /// [`History::step`] with an observer that sees every iteration and may cancel.
    ///
    /// # Errors
    /// As [`History::step`].
    pub fn step_observed(
        &mut self,
        load: &LoadStep,
        mut observer: impl FnMut(&Iteration) -> ControlFlow<()> + Send,
    ) -> Result<&Step> {
        load.check(self.axis(), self.boundary())?;
        let window = self.press.window();
        if let Err(error) = self.attempt(load, &mut with_memory(&mut observer)) {
            self.press
                .resume(self.normal.pressure().as_slice(), window)?;
            self.shear.abandon();
            return Err(error);
        }
        if load.normal_load().is_some() {
            std::mem::swap(&mut self.normal, &mut self.candidate);
            self.is_pressure_stale = false;
            self.step.normal_report.clone_from(self.normal.report());
        } else {
            self.step.normal_report.clone_from(&Report::unsolved());
        }
        self.step.is_pressure_stale = self.is_pressure_stale;
        self.step.normal_force = self.normal.force();
        self.step.approach = self.normal.approach();
        self.shear.commit(&mut self.state, &mut self.step);
        Ok(&self.step)
    }

    /// Solves both halves of a step without a trace in the state.
    fn attempt(&mut self, load: &LoadStep, observer: Observer<'_>) -> Result<()> {
        let pressed = if let Some(load) = load.normal_load() {
            self.press.set_load(load)?;
            self.press
                .solve_observed(&mut self.candidate, &mut *observer)?;
            &self.candidate
        } else {
            &self.normal
        };
        let Self { shear, state, .. } = self;
        shear.prepare(pressed.pressure(), &self.friction, state)?;
        shear.solve(load, state, &self.settings, observer)
    }

    /// Changes the gap before loading, as wear does; all else stays, the pressure too until a step that does not
    /// hold it: give the normal load in the next step again. One that holds it carries
    /// [`Warning::StalePressure`](crate::Warning::StalePressure). Copies without allocating.
    ///
    /// # Errors
    /// [`Error::GridMismatch`](crate::Error::GridMismatch) or [`Error::Sample`](crate::Error::Sample); the gap
    /// is then as it was.
    pub fn set_gap(&mut self, gap: &Field) -> Result<()> {
        // The load of the last step has no say: the next brings its own.
        self.press.set_load(NormalLoad::Force(0.0))?;
        let is_pressed = self.normal.report().status != Status::Unsolved;
        let changes = self.gap().as_slice().iter().ne(gap.as_slice());
        self.press.set_gap(gap)?;
        self.is_pressure_stale |= is_pressed && changes;
        Ok(())
    }

    /// Changes the friction from the next step on; all else stays.
    ///
    /// # Errors
    /// [`Error::GridMismatch`](crate::Error::GridMismatch); the friction is then as it was.
    pub fn set_friction(&mut self, friction: &Friction) -> Result<()> {
        friction.check(self.grid())?;
        self.friction.copy_from(friction);
        Ok(())
    }

    /// The settings of the next step.
    #[must_use]
    pub fn settings(&self) -> &Settings {
        &self.settings
    }

    /// Changes tolerance, method and limits from the next step on, as after a restart; the state stays. A tolerance
    /// that is tightened bounds what is still to come, not the errors of steps done.
    ///
    /// # Errors
    /// As [`Settings::check`]; the settings are then as they were.
    pub fn set_settings(&mut self, settings: Settings) -> Result<()> {
        self.press.set_settings(settings)?;
        self.settings = settings;
        Ok(())
    }

    /// What the last step did; all zero before the first.
    #[must_use]
    pub fn last_step(&self) -> &Step {
        &self.step
    }

    /// Steps taken since the start.
    #[must_use]
    pub fn steps(&self) -> u64 {
        self.state.steps
    }

    /// The grid of all fields.
    #[must_use]
    pub fn grid(&self) -> Grid {
        self.bodies.grid()
    }

    /// What lies beyond the edge of the grid.
    #[must_use]
    pub fn boundary(&self) -> Boundary {
        self.bodies.boundary()
    }

    /// The axis of tangential load and tractions in the scalar model, `None` in that of the plane.
    #[must_use]
    pub fn axis(&self) -> Option<Axis> {
        self.shear.axis()
    }

    /// The gap before loading (lengths), as last set.
    #[must_use]
    pub fn gap(&self) -> &Field {
        self.press.gap()
    }

    /// The friction, as last set.
    #[must_use]
    pub fn friction(&self) -> &Friction {
        &self.friction
    }

    /// The normal contact: pressure, approach, gap under load, contact area, warnings.
    #[must_use]
    pub fn normal(&self) -> &NormalSolution {
        &self.normal
    }

    /// Pressure p >= 0; exactly zero outside the contact.
    #[must_use]
    pub fn pressure(&self) -> &Field {
        self.normal.pressure()
    }

    /// Approach of the bodies from the datum of the gap (a length).
    #[must_use]
    pub fn approach(&self) -> f64 {
        self.normal.approach()
    }

    /// Shear traction q on body 1 (pressures), positive along the axes; exactly zero outside the contact.
    #[must_use]
    pub fn traction(&self) -> [&Field; 2] {
        self.state.traction.each_ref()
    }

    /// Displacement of the surface of body 1 relative to that of body 2 by the tractions (lengths), of all
    /// cells, in contact or not: computed when asked for, by the operators that the bodies then keep.
    ///
    /// # Errors
    /// As [`HalfSpace::operator`].
    pub fn displacement(&self) -> Result<[Field; 2]> {
        let zeros = || Field::zeros(self.grid());
        let (mut displacement, mut part) = ([zeros(), zeros()], zeros());
        let axes = axes_of(self.axis());
        for (moved, pulled) in axes.iter().flat_map(|a| axes.iter().map(move |b| (*a, *b))) {
            let component = Component::of(direction(moved), direction(pulled));
            let operator = self.bodies.operator(component)?;
            let traction = self.state.traction[pulled.index()].as_slice();
            let out = [part.as_mut_slice()];
            operator.apply([traction], out, &mut operator.workspace());
            displacement[moved.index()].add_scaled(1.0, &part)?;
        }
        Ok(displacement)
    }

    /// Sum of the slips of all steps, with their signs (lengths).
    #[must_use]
    pub fn slip(&self) -> [&Field; 2] {
        self.state.slip.each_ref()
    }

    /// Length of the path slipped in all steps (lengths, non-negative).
    #[must_use]
    pub fn slip_path(&self) -> &Field {
        &self.state.slip_path
    }

    /// Energy each cell has dissipated in all steps, the sum of [`Step::dissipation`] (energies, force
    /// times length, non-negative).
    #[must_use]
    pub fn dissipated_energy(&self) -> &Field {
        &self.state.dissipated
    }

    /// The zone of every cell after the last step, row-major with x fastest.
    #[must_use]
    pub fn zones(&self) -> &[Zone] {
        &self.state.zones
    }

    /// Shift of body 2 relative to body 1 since the start (lengths).
    #[must_use]
    pub fn shift(&self) -> [f64; 2] {
        self.state.motion.shift
    }

    /// Rotation of body 2 relative to body 1 since the start (radians).
    #[must_use]
    pub fn twist(&self) -> f64 {
        self.state.motion.twist
    }

    /// Tangential force that body 2 exerts on body 1.
    #[must_use]
    pub fn force(&self) -> [f64; 2] {
        self.state.force
    }

    /// Largest tangential force friction holds at the present pressure (a force): the integral of the friction limit.
    #[must_use]
    pub fn sliding_force(&self) -> f64 {
        let pressure = self.pressure().as_slice();
        let [sum] = parallel::sums(pressure.len(), |i| [self.friction.limit(i, pressure[i])]);
        sum * self.grid().cell_area()
    }

    /// Moment about z, at the origin of the grid, that the tractions of body 2 exert on body 1.
    #[must_use]
    pub fn moment(&self) -> f64 {
        self.state.moment
    }
}
