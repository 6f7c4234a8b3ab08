//! Derivatives of forces and moment of rolling bodies with respect to creepages and spin, with fixed zones.
//!
//! Let P be the projection onto the admissible changes of the tractions and K the rotational stiffness of slipping
//! cells. Let $`w_a`$ be the motion during a step that is caused by a unit creepage or a unit spin. The additional tractions
//! $`y_a`$ satisfy $`P\,((1 - T)\,C + B)\,y_a + K y_a = P\,w_a`$.

use std::ops::ControlFlow;

use crate::cgm::{Disc, LinearisedSet, Row};
use crate::contact::{Elasticity, LinearResponse, ResponseContext};
use crate::error::{Error, Result};
use crate::numerics::cell_vector::{at, slices};
use crate::numerics::small_matrix::Small;
use crate::observer::{Observer, unwatched};
use crate::operator::Operator;
use crate::report::{Iteration, Report};
use crate::rolling::RollingSolver;
use crate::tangential::centre;

/// Relative residual of the tractions.
pub(in crate::rolling) const TOLERANCE: f64 = 1e-10;

/// Linear problem of a step with fixed zones, and its unknowns.
pub(in crate::rolling) type RollingSensitivity =
    LinearResponse<<Disc as LinearisedSet<2>>::CellMotion, 2>;

/// Returns an error if an input has changed since the last solution.
pub(in crate::rolling) fn check_current(changed: Option<&'static str>) -> Result<()> {
    changed.map_or(Ok(()), |changed| {
        Err(Error::OutdatedSolution {
            quantity: "stiffness",
            changed,
            remedy: "solve again before you compute the stiffness",
        })
    })
}

impl RollingSolver {
    /// Returns the derivatives of forces and moment with respect to creepages and spin at the last solution,
    ///
    /// ```math
    /// \frac{\partial (F_x, F_y, M)}{\partial (\xi, \eta, \varphi)} ,
    /// ```
    ///
    /// with one row per load. The entries in the column of the spin and in the row of the moment have an additional
    /// factor of length. Sticking cells follow the motion. The tractions of slipping cells rotate with their slip and
    /// remain at their limits, whether the motion or the load is prescribed. Before the first solve and after a reset
    /// all cells stick, and the entries are Kalker's coefficients times $`G a b`$ and lengths. The matrix is not
    /// symmetric. If the whole contact slides in one direction, some entries of the matrix are zero. The three
    /// columns take 90 to 140 products in double precision on 64 cells across a sphere. A solve after an increase of the
    /// creepage by one per cent takes a third to half as many products.
    ///
    /// After a change of the loads, the friction or the pressure, the call returns an error until the next solve or reset.
    ///
    /// ```
    /// # use stickslip::{rolling::RollingProblem, *};
    /// # let grid = Grid::square(24, 3.0)?;
    /// # let body = Material::from_shear_modulus(1.0, 0.25)?;
    /// # let bodies = HalfSpace::new(grid, ElasticPair::new(body, body)?)?;
    /// # let (ball, load) = (surface::sphere(grid, 1.0)?, NormalLoad::Force(1.0));
    /// # let normal = NormalProblem::builder(&bodies, &ball, load).build()?.solve()?;
    /// let problem = RollingProblem::builder(&bodies, &normal, Friction::coulomb(0.3)?).build()?;
    /// let stiffness = problem.into_solver()?.stiffness()?;
    /// let a = analytical::HertzSphere::new(bodies.pair(), 1.0, 1.0)?.contact_radius();
    /// // Kalker's C11 and C22. Spin causes a lateral force, and lateral creepage a moment of the other sign.
    /// assert!((stiffness[0][0] / (a * a) / 4.12 - 1.0).abs() < 0.02);
    /// assert!((stiffness[1][1] / (a * a) / 3.67 - 1.0).abs() < 0.02);
    /// assert!(stiffness[1][2] > 0.0 && stiffness[2][1] < 0.0);
    /// # Ok::<(), Error>(())
    /// ```
    ///
    /// # Errors
    /// - [`Error::OutdatedSolution`] if the input has changed since the last solve.
    /// - [`Error::NotConverged`] if the last solve has not converged, or if the tractions do not reach a relative residual of
    ///   1e-10.
    /// - [`Error::Memory`] if memory runs out.
    pub fn stiffness(&mut self) -> Result<[[f64; 3]; 3]> {
        self.stiffness_observed(unwatched)
    }

    /// Computes [`stiffness`](Self::stiffness) with an observer. The observer is called before every product with the
    /// operator and may cancel. It receives the residual of the current linear problem.
    ///
    /// # Errors
    /// The errors of [`stiffness`](Self::stiffness).
    pub fn stiffness_observed(
        &mut self,
        mut observer: impl FnMut(&Iteration) -> ControlFlow<()> + Send,
    ) -> Result<[[f64; 3]; 3]> {
        let engine = &self.engine;
        check_current(engine.changed.filter(|_| engine.is_warm))?;
        if engine.is_warm && !engine.report.is_converged() {
            return Err(Error::NotConverged(Box::new(engine.report.clone())));
        }
        self.slopes(&mut observer)
    }

    /// Returns the stiffness at the last iterate.
    pub(in crate::rolling) fn slopes(&mut self, observer: Observer<'_>) -> Result<[[f64; 3]; 3]> {
        let mut follow = self.take_follow()?;
        let found = self.loads(&mut follow, observer);
        self.engine.follow = Some(follow);
        Ok(Small(found?).transposed().0)
    }

    /// Returns the existing linear problem, or creates it if there is none.
    pub(in crate::rolling) fn take_follow(&mut self) -> Result<RollingSensitivity> {
        self.engine.follow.take().map_or_else(
            || {
                LinearResponse::new(
                    &*self.engine.operator,
                    &*self.engine.inverse,
                    self.engine.operator.layout(),
                )
            },
            Ok,
        )
    }

    /// Returns forces and moment per unit of each creepage and of spin.
    fn loads(
        &self,
        follow: &mut RollingSensitivity,
        observer: Observer<'_>,
    ) -> Result<[[f64; 3]; 3]> {
        self.hold_zones(follow)?;
        let mut context = ResponseContext {
            tolerance: TOLERANCE,
            report: &mut Report::unsolved(),
            observer,
        };
        let problem = &self.problem;
        let window = problem.pressed.window();
        let loads = follow.responses(
            self.elasticity(),
            3,
            |motion, cell| problem.motions(window.index(cell))[motion],
            |cell, traction| self.load_of(cell, traction),
            &mut context,
        )?;
        let area = problem.bodies.grid().cell_area();
        Ok(loads.map(|loads| loads.map(|load| load * area)))
    }

    /// Fixes each cell in its current zone.
    pub(in crate::rolling) fn hold_zones(&self, follow: &mut RollingSensitivity) -> Result<()> {
        let (traction, limits) = (slices(&self.engine.traction), &self.engine.limits);
        let alone = self.engine.operator.self_compliance();
        follow.linear.hold(|cell| {
            let disc = Disc {
                radius: limits[cell],
            };
            let motion = disc.motion(at(&traction, cell));
            let own = self.engine.own().mean(cell);
            disc.measured(motion, self.slip(cell))
                .with_preconditioner_weight(alone, own)
        })
    }

    /// Returns the operators of a step and the entry compliance of the cells.
    pub(in crate::rolling) fn elasticity(&self) -> Elasticity<'_, 2> {
        let engine = &self.engine;
        (&*engine.operator, &*engine.inverse, engine.own())
    }

    /// Returns forces and moment of a cell of the window, for a unit area.
    pub(in crate::rolling) fn load_of(&self, cell: usize, [qx, qy]: [f64; 2]) -> [f64; 3] {
        let index = self.problem.pressed.window().index(cell);
        let [x, y] = centre(self.problem.bodies.grid(), index);
        [qx, qy, x * qy - y * qx]
    }
}
