//! Derivatives of forces and moment of rolling bodies with respect to creepages and spin, with fixed zones.
//!
//! Let P be the projection onto the admissible changes of the tractions and K the rotational stiffness of slipping
//! cells. Let $`w_a`$ be the motion during a step that is caused by a unit creepage or a unit spin. The additional tractions
//! $`y_a`$ satisfy $`P\,((1 - T)\,C + B)\,y_a + K y_a = P\,w_a`$.

use std::ops::ControlFlow;

use crate::cgm::{CellMotion, Disc, FixedSetSystem, LinearWorkspace, LinearisedSet};
use crate::contact::with_counts_of;
use crate::error::{Error, Result};
use crate::numerics::cell_vector::{at, slices};
use crate::numerics::small_matrix::Small;
use crate::observer::{Observer, unwatched};
use crate::operator::Operator;
use crate::parallel::layout::Layout;
use crate::parallel::reduce;
use crate::report::{Iteration, Report};
use crate::rolling::RollingSolver;
use crate::tangential::centre;

/// Relative residual of the tractions.
const TOLERANCE: f64 = 1e-10;

/// Linear problem of a step with fixed zones, and its unknowns.
#[derive(Clone)]
pub(in crate::rolling) struct RollingSensitivity {
    pub(in crate::rolling) linear: LinearWorkspace<<Disc as LinearisedSet<2>>::CellMotion, 2>,
    layout: Layout,
    right: Vec<[f64; 2]>,
    unknowns: Vec<[f64; 2]>,
}

impl RollingSolver {
    /// Returns the derivatives of forces and moment with respect to creepages and spin at the last solution,
    ///
    /// ```math
    /// \frac{\partial (F_x, F_y, M)}{\partial (\xi, \eta, \varphi)} ,
    /// ```
    ///
    /// with one row per load. The entries in the column of the spin and in the row of the moment have an additional factor
    /// of length. Sticking cells follow the motion. The tractions of slipping cells rotate with their slip and remain at
    /// their limits, whether the motion or the load is prescribed. Before the first solve all cells stick, and the entries
    /// are Kalker's coefficients times $`G a b`$ and lengths. The matrix is not symmetric. If the whole contact slides in
    /// one direction, some entries of the matrix are zero. On 64 cells across a sphere the three columns take 90 to 140
    /// products in double precision. A solve after an increase of the creepage by one per cent takes a third to half as
    /// many products.
    ///
    /// ```
    /// # use stickslip::{rolling::RollingProblem, *};
    /// # let grid = Grid::square(24, 3.0)?;
    /// # let body = Material::from_shear_modulus(1.0, 0.25)?;
    /// # let bodies = HalfSpace::new(grid, ElasticPair::new(body, body)?)?;
    /// # let (ball, load) = (surface::sphere(grid, 1.0)?, NormalControl::Force(1.0));
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
    /// - [`Error::NotConverged`] if the tractions do not reach a relative residual of 1e-10.
    /// - [`Error::Memory`] if memory runs out.
    pub fn stiffness(&mut self) -> Result<[[f64; 3]; 3]> {
        self.stiffness_observed(unwatched)
    }

    /// Returns [`stiffness`](Self::stiffness) with an observer. The observer is called before every product with the
    /// operator and may cancel. The observer receives the residual of the current linear problem.
    ///
    /// # Errors
    /// The errors of [`stiffness`](Self::stiffness).
    pub fn stiffness_observed(
        &mut self,
        mut observer: impl FnMut(&Iteration) -> ControlFlow<()> + Send,
    ) -> Result<[[f64; 3]; 3]> {
        let mut follow = self.take_follow()?;
        let found = self.loads(&mut follow, &mut observer);
        self.engine.follow = Some(follow);
        Ok(Small(found?).transposed().0)
    }

    /// Returns the existing linear problem, or creates it if there is none.
    pub(in crate::rolling) fn take_follow(&mut self) -> Result<RollingSensitivity> {
        Ok(match self.engine.follow.take() {
            Some(follow) => follow,
            None => RollingSensitivity {
                linear: LinearWorkspace::new(&*self.engine.operator, &*self.engine.inverse)?,
                layout: self.engine.operator.layout(),
                right: Vec::new(),
                unknowns: Vec::new(),
            },
        })
    }

    /// Returns forces and moment per unit of each creepage and of spin.
    fn loads(
        &self,
        follow: &mut RollingSensitivity,
        observer: Observer<'_>,
    ) -> Result<[[f64; 3]; 3]> {
        self.hold_zones(follow)?;
        let (mut loads, mut work) = ([[0.0; 3]; 3], Report::unsolved());
        for (motion, loads) in loads.iter_mut().enumerate() {
            let mut observer = with_counts_of(&work, &mut *observer);
            *loads = self.loads_by(motion, follow, &mut observer)?;
            drop(observer);
            work.add_pass(follow.linear.report());
        }
        Ok(loads)
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

    fn loads_by(
        &self,
        motion: usize,
        follow: &mut RollingSensitivity,
        observer: Observer<'_>,
    ) -> Result<[f64; 3]> {
        let problem = &self.problem;
        let index = |cell: usize| problem.pressed.window().index(cell);
        self.respond(
            |cell| problem.motions(index(cell))[motion],
            follow,
            observer,
        )?;
        Ok(self.loads_of(follow.linear.tractions()))
    }

    /// Solves for the tractions that cause the given displacements of the cells over a step, with fixed zones.
    pub(in crate::rolling) fn respond(
        &self,
        moved: impl Fn(usize) -> [f64; 2] + Sync,
        follow: &mut RollingSensitivity,
        observer: Observer<'_>,
    ) -> Result<()> {
        let RollingSensitivity {
            linear,
            layout,
            right,
            unknowns,
        } = follow;
        linear.restrict(moved, right)?;
        let held = FixedSetSystem {
            operator: &*self.engine.operator,
            preconditioner: &*self.engine.inverse,
            layout,
            own: self.engine.own(),
        };
        held.respond(right, unknowns, linear, TOLERANCE, observer)?;
        if !linear.report().is_converged() {
            return Err(Error::NotConverged(Box::new(linear.report().clone())));
        }
        Ok(())
    }

    /// Returns forces and moment of tractions of the cells of the window.
    pub(in crate::rolling) fn loads_of(&self, tractions: [&[f64]; 2]) -> [f64; 3] {
        let (grid, window) = (self.problem.bodies.grid(), self.problem.pressed.window());
        let loads: [f64; 3] = reduce::sum(&self.engine.operator.layout(), |cell| {
            let (q, [x, y]) = (at(&tractions, cell), centre(grid, window.index(cell)));
            [q[0], q[1], x * q[1] - y * q[0]]
        });
        loads.map(|load| load * grid.cell_area())
    }
}
