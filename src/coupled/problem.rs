//! The scene of a coupled contact, checked once.

use crate::cascade::Conditions;
use crate::cgm::{Settings, Total, settings_methods};
use crate::clock::Instant;
use crate::coupled::engine::{Engine, N, Task};
use crate::coupled::{CoupledReport, CoupledSolution};
use crate::error::{Error, Result, finite};
use crate::field::Field;
use crate::half_space::HalfSpace;
use crate::normal::NormalControl;
use crate::passes::with_memory;
use crate::tangential::{
    Axis, Demand, Friction, Motion, TangentialControl, TangentialLoad, TangentialModel, centre,
};
use std::ops::ControlFlow;

/// Bodies, gap, friction and load of a contact whose pressure and shear are found together, in one step from rest.
///
/// ```
/// use stickslip::*;
/// // A compressible rubber pad (nu = 0) on a rigid ball: beta = 1/2.
/// let grid = Grid::square(32, 3.0)?;
/// let bodies = HalfSpace::new(grid, ElasticPair::new(Material::new(1.0, 0.0)?, Material::rigid())?)?;
/// let (ball, friction) = (surface::sphere(grid, 10.0)?, Friction::coulomb(0.3)?);
/// let press = NormalControl::Force(0.1);
/// let still = TangentialLoad::shift([0.0, 0.0]);
/// let contact = CoupledProblem::builder(&bodies, &ball, friction, press, still).build()?.solve()?;
///
/// // Shear held inwards by friction makes the contact stiffer than without.
/// let smooth = NormalProblem::builder(&bodies, &ball, press).build()?.solve()?;
/// assert!(contact.approach() < smooth.approach() && contact.pressure().max() > smooth.pressure().max());
/// # Ok::<(), Error>(())
/// ```
#[doc(alias = "dissimilar")]
#[derive(Debug, Clone)]
pub struct CoupledProblem {
    bodies: HalfSpace,
    gap: Field,
    friction: Friction,
    normal: NormalControl,
    load: TangentialLoad,
    settings: Settings,
}

/// Options of a [`CoupledProblem`]; each has a default.
#[derive(Debug, Clone)]
#[must_use = "a builder does nothing until build() is called"]
pub struct CoupledProblemBuilder<'a> {
    bodies: &'a HalfSpace,
    gap: &'a Field,
    friction: Friction,
    normal: NormalControl,
    load: TangentialLoad,
    settings: Settings,
}

impl CoupledProblem {
    /// Starts from what is required: bodies, initial gap (lengths, on the grid of the bodies), friction, normal and
    /// tangential load.
    ///
    /// A tangential load of no force and one of no shift differ: the tractions of pressing alone add up to zero by
    /// symmetry only.
    pub fn builder<'a>(
        bodies: &'a HalfSpace,
        gap: &'a Field,
        friction: Friction,
        normal: NormalControl,
        load: TangentialLoad,
    ) -> CoupledProblemBuilder<'a> {
        CoupledProblemBuilder {
            bodies,
            gap,
            friction,
            normal,
            load,
            settings: Settings::default(),
        }
    }

    /// Solves from rest, in one step.
    ///
    /// # Errors
    /// [`Error::NotConverged`] with the report; [`Error::BeyondFrictionCapacity`] for a force that slides the contact;
    /// as [`HalfSpace::operator`].
    pub fn solve(&self) -> Result<CoupledSolution> {
        let (totals, linear, motion) = self.demand()?;
        let mut engine = Engine::new(&self.bodies)?;
        let mut observer = |_: &_| ControlFlow::Continue(());
        let mut observer = with_memory(&mut observer);
        let mut conditions = Conditions {
            settings: &self.settings,
            start: Instant::now(),
            observer: &mut observer,
        };
        let mut report = CoupledReport::unsolved();
        let task = Task {
            linear: linear.each_ref().map(Vec::as_slice),
            totals,
            friction: &self.friction,
        };
        let outcome = engine.solve(task, &mut conditions, &mut report);
        report.work.time = conditions.start.elapsed();
        outcome?;
        let [approach, x, y] = engine.multiplier();
        let moved = Motion {
            shift: [motion.shift[0] + x, motion.shift[1] + y],
            ..motion
        };
        let datum = self.datum();
        Ok(CoupledSolution::new(
            &self.bodies,
            &self.gap,
            &self.friction,
            engine.x.each_ref().map(Vec::as_slice),
            engine.product(),
            (datum + approach, moved),
            report,
        ))
    }

    /// What the gap is measured from: without a datum far from the contact the sums keep their last digits.
    fn datum(&self) -> f64 {
        match self.normal {
            NormalControl::Approach(approach) => approach,
            _ => self.gap.min(),
        }
    }

    /// What is prescribed of the sums, what every cell is asked to follow, and the prescribed motion.
    fn demand(&self) -> Result<([Total; N], [Vec<f64>; N], Motion)> {
        let grid = self.bodies.grid();
        let demand = self.load.demand();
        let (mut totals, mut motion) = ([Total::Free; N], Motion::default());
        motion.twist = demand.twist;
        let mut pressed = None;
        if let NormalControl::Force(force) = self.normal {
            totals[0] = Total::Sum(force / grid.cell_area());
            pressed = Some(force);
        }
        self.check_force(&demand, pressed)?;
        for &axis in Axis::BOTH {
            let total = &mut totals[1 + axis.index()];
            match demand.control(axis) {
                TangentialControl::Shift(shift) => motion.shift[axis.index()] = shift,
                TangentialControl::Hold => {}
                TangentialControl::Force(force) => *total = Total::Sum(force / grid.cell_area()),
                TangentialControl::Spring {
                    position,
                    stiffness,
                } => {
                    let quantity = "cell area over the stiffness of the spring";
                    *total = Total::Spring {
                        far_end: position,
                        compliance: finite(quantity, grid.cell_area() / stiffness)?,
                    };
                }
            }
        }
        let datum = self.datum();
        let gap = self.gap.as_slice().iter().map(|gap| gap - datum).collect();
        let follows = |axis: usize| {
            let cells = 0..grid.cells();
            cells
                .map(|i| 0.0 - motion.at(centre(grid, i))[axis])
                .collect()
        };
        Ok((totals, [gap, follows(0), follows(1)], motion))
    }

    /// Refuses a force that friction cannot hold whatever the pressure becomes.
    fn check_force(&self, demand: &Demand, pressed: Option<f64>) -> Result<()> {
        let Some(pressed) = pressed else {
            return Ok(());
        };
        let [x, y] = demand.force();
        let (force, limit) = (x.hypot(y), self.friction.largest_coefficient() * pressed);
        if force >= limit && force > 0.0 {
            return Err(Error::BeyondFrictionCapacity { force, limit });
        }
        Ok(())
    }
}

impl CoupledProblemBuilder<'_> {
    settings_methods!();

    /// Checks everything and copies the gap.
    ///
    /// # Errors
    /// [`Error::GridMismatch`] if gap or friction live on another grid, [`Error::Sample`] if the gap is not finite;
    /// [`Error::Negative`], [`Error::NotFinite`], [`Error::NotPositive`], [`Error::NothingToHold`] or
    /// [`Error::NotModelled`] for the loads; [`Error::ApproachBeyondMeanGap`] on a periodic grid; [`Error::Method`] for
    /// [`Method::PolonskyKeer`](crate::cgm::Method::PolonskyKeer); [`Error::Tolerance`], [`Error::IterationLimit`].
    pub fn build(self) -> Result<CoupledProblem> {
        self.gap.check("gap", self.bodies.grid())?;
        self.normal.check(self.bodies, self.gap)?;
        self.friction.check(self.bodies.grid())?;
        let demand = self.load.demand();
        demand.check(Axis::BOTH, self.bodies.boundary())?;
        self.settings.check()?;
        TangentialModel::Vector.check(&self.settings)?;
        Ok(CoupledProblem {
            bodies: self.bodies.clone(),
            gap: self.gap.clone(),
            friction: self.friction,
            normal: self.normal,
            load: self.load,
            settings: self.settings,
        })
    }
}
