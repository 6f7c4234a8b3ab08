//! Creep curves and creep surfaces.

use std::ops::ControlFlow;

use crate::error::Result;
use crate::memory::fallible;
use crate::observer::unwatched;
use crate::report::Iteration;
use crate::rolling::{RollingControl, RollingSolver};

/// A point of a creep curve or a creep surface: creepages and spin, and the loads that they cause.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct CreepForce {
    /// The creepages $`\xi, \eta`$ (dimensionless).
    pub creepage: [f64; 2],
    /// The spin (one over a length).
    pub spin: f64,
    /// Tangential force on body 1 along x and y.
    pub force: [f64; 2],
    /// Moment on body 1 about the origin of the grid (a force times a length).
    pub moment: f64,
    /// Cells that stick over cells in contact.
    pub stick_ratio: f64,
}

impl RollingSolver {
    /// The loads at each of these $`[\xi, \eta, \varphi]`$, each solved from the answer of the one before: a creep curve,
    /// or the points of a creep surface, row by row. Neighbours in the order should be neighbours in the plane. The point
    /// that was solved last stays prescribed.
    ///
    /// ```
    /// # use stickslip::{rolling::RollingProblem, *};
    /// # let grid = Grid::square(24, 3.0)?;
    /// # let body = Material::from_shear_modulus(1.0, 0.25)?;
    /// # let bodies = HalfSpace::new(grid, ElasticPair::new(body, body)?)?;
    /// # let (ball, load) = (surface::sphere(grid, 1.0)?, NormalControl::Force(1.0));
    /// # let normal = NormalProblem::builder(&bodies, &ball, load).build()?.solve()?;
    /// let problem = RollingProblem::builder(&bodies, &normal, Friction::coulomb(0.3)?).build()?;
    /// let curve = (0..=10).map(|step| [0.03 * f64::from(step), 0.0, 0.0]);
    /// let curve = problem.into_solver()?.creep_forces(curve)?;
    /// // From nothing to sliding, each time by less.
    /// let forces: Vec<f64> = curve.iter().map(|point| point.force[0]).collect();
    /// assert!(forces[0] == 0.0 && (forces[10] / 0.3 - 1.0).abs() < 1e-3);
    /// assert!(forces.windows(3).all(|f| f[2] - f[1] <= f[1] - f[0] + 1e-9));
    /// # Ok::<(), Error>(())
    /// ```
    ///
    /// # Errors
    /// As [`set_control`](Self::set_control), for any of the points before the first is solved; as
    /// [`solve_into`](Self::solve_into), at the first that fails; [`Error::Memory`](crate::Error::Memory).
    pub fn creep_forces(
        &mut self,
        points: impl IntoIterator<Item = [f64; 3]>,
    ) -> Result<Vec<CreepForce>> {
        self.creep_forces_observed(points, unwatched)
    }

    /// [`creep_forces`](Self::creep_forces) with an observer that sees every step of each solve and may cancel.
    ///
    /// # Errors
    /// As [`creep_forces`](Self::creep_forces).
    pub fn creep_forces_observed(
        &mut self,
        points: impl IntoIterator<Item = [f64; 3]>,
        mut observer: impl FnMut(&Iteration) -> ControlFlow<()> + Send,
    ) -> Result<Vec<CreepForce>> {
        let mut checked = Vec::new();
        let creepages = |xi: f64, eta: f64| [xi, eta].map(RollingControl::Creepage);
        for point in points {
            let [xi, eta, spin] = point;
            self.problem.check(creepages(xi, eta), spin.into())?;
            fallible::push(&mut checked, point)?;
        }
        let mut solution = self.try_new_solution()?;
        let mut found = Vec::new();
        for [xi, eta, spin] in checked {
            self.set_control(creepages(xi, eta), spin)?;
            self.solve_observed(&mut solution, &mut observer)?;
            let force = CreepForce {
                creepage: [xi, eta],
                spin,
                force: solution.force(),
                moment: solution.moment(),
                stick_ratio: solution.stick_ratio(),
            };
            fallible::push(&mut found, force)?;
        }
        Ok(found)
    }
}
