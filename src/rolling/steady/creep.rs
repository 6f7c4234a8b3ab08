//! Creep curves and creep surfaces.

use std::ops::ControlFlow;

use crate::error::Result;
use crate::memory::fallible;
use crate::observer::unwatched;
use crate::report::Iteration;
use crate::rolling::{RollingControl, RollingSolver, SpinControl};
use crate::warning::Warning;

/// Point of a creep curve or a creep surface: creepages and spin, and the loads that they cause.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub struct CreepForce {
    /// Creepages $`\xi, \eta`$ (dimensionless).
    pub creepage: [f64; 2],
    /// Spin (one over a length).
    pub spin: f64,
    /// Tangential force on body 1 along x and y.
    pub force: [f64; 2],
    /// Moment on body 1 about the origin of the grid (a force times a length).
    pub moment: f64,
    /// Ratio of sticking cells to cells in contact.
    pub stick_ratio: f64,
    #[cfg_attr(feature = "serde", serde(default))]
    remarks: [Option<Warning>; 5],
}

impl CreepForce {
    /// Returns the warnings about the loads of the point: [`Warning::LargeCreepage`], [`Warning::LargeFriction`],
    /// [`Warning::LowShearStress`], [`Warning::ShearStressBeyondModulus`] and [`Warning::NeglectedLift`]. For a prescribed
    /// pressure they include [`Warning::LowPressure`] or [`Warning::PressureBeyondModulus`].
    /// [`RollingSolution::warnings`](crate::rolling::RollingSolution::warnings) also contains those about the contact, which is the
    /// same at all points.
    #[must_use]
    pub fn warnings(&self) -> Vec<Warning> {
        self.remarks.into_iter().flatten().collect()
    }
}

impl RollingSolver {
    /// Returns the loads at each of the given points $`[\xi, \eta, \varphi]`$. Each solve starts from the solution of
    /// the previous point. The points form a creep curve or, row by row, a creep surface. Consecutive points should be
    /// close to each other. After the call, the last solved point remains prescribed.
    ///
    /// ```
    /// # use stickslip::{rolling::RollingProblem, *};
    /// # let grid = Grid::square(24, 3.0)?;
    /// # let body = Material::from_shear_modulus(1.0, 0.25)?;
    /// # let bodies = HalfSpace::new(grid, ElasticPair::new(body, body)?)?;
    /// # let (ball, load) = (surface::sphere(grid, 1.0)?, NormalLoad::Force(1.0));
    /// # let normal = NormalProblem::builder(&bodies, &ball, load).build()?.solve()?;
    /// let problem = RollingProblem::builder(&bodies, &normal, Friction::coulomb(0.3)?).build()?;
    /// let curve = (0..=10).map(|step| [0.03 * f64::from(step), 0.0, 0.0]);
    /// let curve = problem.into_solver()?.creep_forces(curve)?;
    /// // The force rises from zero to sliding with decreasing increments.
    /// let forces: Vec<f64> = curve.iter().map(|point| point.force[0]).collect();
    /// assert!(forces[0] == 0.0 && (forces[10] / 0.3 - 1.0).abs() < 1e-3);
    /// assert!(forces.windows(3).all(|f| f[2] - f[1] <= f[1] - f[0] + 1e-9));
    /// # Ok::<(), Error>(())
    /// ```
    ///
    /// # Errors
    /// - The errors of [`set_load`](Self::set_load) for any of the points. All points are checked before the first
    ///   solve.
    /// - The errors of [`solve_into`](Self::solve_into) for the first point that fails.
    /// - [`Error::Memory`](crate::Error::Memory) if memory runs out.
    pub fn creep_forces(
        &mut self,
        points: impl IntoIterator<Item = [f64; 3]>,
    ) -> Result<Vec<CreepForce>> {
        self.creep_forces_observed(points, unwatched)
    }

    /// Computes [`creep_forces`](Self::creep_forces) with an observer, which receives every iteration of each solve and
    /// may cancel. [`creep_forces_into`](Self::creep_forces_into) keeps the points that were solved before an error.
    ///
    /// # Errors
    /// The errors of [`creep_forces`](Self::creep_forces).
    pub fn creep_forces_observed(
        &mut self,
        points: impl IntoIterator<Item = [f64; 3]>,
        mut observer: impl FnMut(&Iteration) -> ControlFlow<()> + Send,
    ) -> Result<Vec<CreepForce>> {
        let mut found = Vec::new();
        self.creep_forces_into(points, &mut found, |iteration, _| observer(iteration))?;
        Ok(found)
    }

    /// Appends each point of [`creep_forces`](Self::creep_forces) to `found` after its solve. After an error or a cancellation,
    /// `found` contains the points solved before. The observer receives every iteration and the points that this call has solved.
    ///
    /// ```
    /// # use std::ops::ControlFlow;
    /// # use stickslip::{rolling::RollingProblem, *};
    /// # let grid = Grid::square(24, 3.0)?;
    /// # let body = Material::from_shear_modulus(1.0, 0.25)?;
    /// # let bodies = HalfSpace::new(grid, ElasticPair::new(body, body)?)?;
    /// # let (ball, load) = (surface::sphere(grid, 1.0)?, NormalLoad::Force(1.0));
    /// # let normal = NormalProblem::builder(&bodies, &ball, load).build()?.solve()?;
    /// let problem = RollingProblem::builder(&bodies, &normal, Friction::coulomb(0.3)?).build()?;
    /// let curve = (1..=10).map(|step| [0.03 * f64::from(step), 0.0, 0.0]);
    /// let mut found = Vec::new();
    /// let outcome = problem.into_solver()?.creep_forces_into(curve, &mut found, |_, solved| {
    ///     if solved.len() < 4 { ControlFlow::Continue(()) } else { ControlFlow::Break(()) }
    /// });
    /// assert!(matches!(outcome, Err(Error::NotConverged(_))));
    /// assert_eq!(found.len(), 4);
    /// # Ok::<(), Error>(())
    /// ```
    ///
    /// # Errors
    /// The errors of [`creep_forces`](Self::creep_forces).
    pub fn creep_forces_into(
        &mut self,
        points: impl IntoIterator<Item = [f64; 3]>,
        found: &mut Vec<CreepForce>,
        mut observer: impl FnMut(&Iteration, &[CreepForce]) -> ControlFlow<()> + Send,
    ) -> Result<()> {
        let mut checked = Vec::new();
        let creepages = |xi: f64, eta: f64| [xi, eta].map(RollingControl::Creepage);
        for point in points {
            let [xi, eta, spin] = point;
            self.problem
                .check(creepages(xi, eta), SpinControl::Spin(spin))?;
            fallible::push(&mut checked, point)?;
        }
        let mut solution = self.try_new_solution()?;
        let first = found.len();
        for [xi, eta, spin] in checked {
            self.set_load(creepages(xi, eta), SpinControl::Spin(spin))?;
            self.solve_observed(&mut solution, |iteration| {
                observer(iteration, &found[first..])
            })?;
            let force = CreepForce {
                creepage: [xi, eta],
                spin,
                force: solution.force(),
                moment: solution.moment(),
                stick_ratio: solution.stick_ratio(),
                remarks: solution.load_warnings(),
            };
            fallible::push(found, force)?;
        }
        Ok(())
    }
}
