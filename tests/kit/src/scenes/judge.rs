//! Solves a scene and checks the solution for faults.
//!
//! A correct solution satisfies three conditions. It is feasible. It satisfies complementarity to the tolerance,
//! computed with an independent product. Its distance from the reference solution is within the certified error.

use std::panic::{AssertUnwindSafe, catch_unwind};

use stickslip::Report;
use stickslip::cgm::Method;
use stickslip::{
    Axis, Coupling, Field, NormalLoad, NormalProblem, NormalSolution, NormalSolver, Result,
    TangentialLoad, TangentialModel, TangentialProblem, TangentialSolution,
};

use super::compliance::{Compliance, dot};
use super::oracle::{self, ReferenceSolution, gathered, limits};
use super::row::{Measured, Row};
use super::{Demand, Expected, RandomScene, Shear};

/// Verifier with the number of cells up to which the dense reference is used.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Verifier {
    pub(crate) dense_limit: usize,
}

impl Verifier {
    /// Returns the rows of all problems of a scene. A panic counts as a fault.
    pub(crate) fn rows(self, scene: &RandomScene, method: Method) -> Vec<Row> {
        let halves = AssertUnwindSafe(|| self.halves(scene, method));
        match catch_unwind(halves) {
            Ok(rows) => rows,
            Err(_) => vec![broken(scene, "panicked".to_owned())],
        }
    }

    fn halves(self, scene: &RandomScene, method: Method) -> Vec<Row> {
        let (row, normal) = match self.press(scene, method) {
            Ok(pressed) => pressed,
            Err(error) => return vec![broken(scene, error.to_string())],
        };
        let mut rows = vec![row];
        if let Some(normal) = normal.filter(|normal| normal.report().is_converged()) {
            for shear in &scene.shears {
                let row = self.shear(scene, shear, &normal, method);
                rows.push(row.unwrap_or_else(|error| broken(scene, error.to_string())));
            }
        }
        rows
    }

    fn press(self, scene: &RandomScene, method: Method) -> Result<(Row, Option<NormalSolution>)> {
        let mut row = Row::new(&scene.name, "pressure");
        let mut builder = NormalProblem::builder(&scene.bodies, &scene.gap, scene.load)
            .tolerance(scene.settings.tolerance)
            .method(method)
            .max_iterations(scene.settings.max_iterations);
        if let Some(limit) = scene.settings.time_limit {
            builder = builder.time_limit(limit);
        }
        let mut solver = match builder.build().and_then(NormalProblem::into_solver) {
            Ok(solver) => solver,
            Err(error) => {
                row.refuse(&error, scene.expected);
                return Ok((row, None));
            }
        };
        let mut solution = solver.new_solution();
        if let Some(before) = &scene.before {
            // The outcome of the first scene must not affect the next solve.
            pose(&mut solver, before)?;
            let _ = solver.solve_into(&mut solution);
            pose(&mut solver, &(scene.gap.clone(), scene.load))?;
        }
        let outcome = solver.solve_into(&mut solution);
        if !row.end(&outcome, solution.report(), scene.expected) {
            return Ok((row, None));
        }

        let pressure = solution.pressure().as_slice();
        row.blame(!pressure.iter().all(|p| *p >= 0.0 && p.is_finite()), || {
            "a pressure is negative or not finite".to_owned()
        });
        if let NormalLoad::Force(force) = scene.load {
            let missing = (solution.force() - force).abs();
            row.blame(missing > 1e-11 * force, || {
                format!("the force is off by {missing:e} of {force:e}")
            });
        }
        let compliance = Compliance::pressure(&scene.bodies)?;
        let product = compliance.product(pressure);
        let approach = solution.approach();
        let sizes = (scene.gap.as_slice().iter()).map(|h| h.abs().max(approach.abs()));
        let mut violated = 0.0_f64;
        let mut noise = 0.0_f64;
        let cells = pressure.iter().zip(&product).zip(scene.gap.as_slice());
        for (((p, u), h), size) in cells.zip(sizes) {
            let gap = u + (h - approach);
            let forbidden = if *p > 0.0 { gap.abs() } else { (-gap).max(0.0) };
            violated = violated.max(forbidden);
            // The gap of cells far from the contact does not matter.
            if forbidden > 0.0 {
                noise = noise.max(size);
            }
        }
        let answer = Answer {
            compliance: &compliance,
            x: pressure,
            product: &product,
            report: solution.report(),
            tolerance: scene.settings.tolerance,
            movable: &|_| true,
            has_sums: matches!(scene.load, NormalLoad::Force(_)),
        };
        answer.check_residual(&mut row, violated, noise);
        if solution.force() > 0.0 {
            let truth = oracle::pressure(scene, &solution, method, self.dense_limit);
            answer.check_error(&mut row, truth);
        }
        Ok((row, Some(solution)))
    }

    fn shear(
        self,
        scene: &RandomScene,
        shear: &Shear,
        normal: &NormalSolution,
        method: Method,
    ) -> Result<Row> {
        let model = match shear.lateral {
            TangentialModel::Vector => "plane",
            _ => "shear",
        };
        let separator = if shear.name.is_empty() { "" } else { ", " };
        let half = format!("{model}{separator}{}", shear.name);
        let mut row = Row::new(&scene.name, half);
        let limits = limits(&shear.friction, normal);
        let sum: f64 = limits.iter().sum();
        let load = match shear.demand {
            Demand::Force(parts) => {
                let limit = sum * normal.grid().cell_area();
                TangentialLoad::force(parts.map(|part| part * limit))
            }
            Demand::Shift(parts) => {
                let along_x = Compliance::shear(&scene.bodies, Some(0))?;
                let displacements = along_x.product(&limits);
                let largest = displacements.iter().fold(0.0_f64, |a, u| a.max(u.abs()));
                TangentialLoad::shift(parts.map(|part| part * largest))
            }
        };
        let mut builder =
            TangentialProblem::builder(&scene.bodies, normal, shear.friction.clone(), load)
                .model(shear.lateral)
                .coupling(Coupling::Neglected)
                .tolerance(scene.settings.tolerance)
                .method(shear.method(method))
                .max_iterations(scene.settings.max_iterations);
        if let Some(limit) = scene.settings.time_limit {
            builder = builder.time_limit(limit);
        }
        let expected = if normal.contact_cells() == 0 {
            Expected::Refused("EmptyContact")
        } else if sum <= 0.0 {
            // Any fraction of a zero limit can be carried.
            Expected::Answer
        } else {
            shear.expected
        };
        let mut solver = match builder.build().and_then(TangentialProblem::into_solver) {
            Ok(solver) => solver,
            Err(error) => {
                row.refuse(&error, expected);
                return Ok(row);
            }
        };
        let mut solution = solver.new_solution();
        let outcome = solver.solve_into(&mut solution);
        if row.end(&outcome, solution.report(), expected) {
            self.examine_shear(&mut row, scene, shear, normal, load, &solution, method)?;
        }
        Ok(row)
    }

    #[expect(
        clippy::too_many_arguments,
        reason = "all that a tangential contact is"
    )]
    fn examine_shear(
        self,
        row: &mut Row,
        scene: &RandomScene,
        shear: &Shear,
        normal: &NormalSolution,
        load: TangentialLoad,
        solution: &TangentialSolution,
        method: Method,
    ) -> Result<()> {
        let limits = limits(&shear.friction, normal);
        let sum: f64 = limits.iter().sum();
        let [x, y] = solution.traction().map(Field::as_slice);
        let excess = |i: usize| x[i].hypot(y[i]) - limits[i] * (1.0 + 1e-14);
        row.blame(
            (0..limits.len()).any(|i| excess(i) > 0.0 || excess(i).is_nan()),
            || "a traction is beyond its limit".to_owned(),
        );
        let cell_area = normal.grid().cell_area();
        if let Some(force) = oracle::prescribed_force(load) {
            let missing = (0..2).map(|b| (solution.force()[b] - force[b]).abs());
            let magnitude: f64 = (0..limits.len()).map(|i| x[i].hypot(y[i])).sum();
            let missing = missing.fold(0.0, f64::max);
            let reported = 1.01 * solution.report().load_error + 2e-12;
            row.blame(missing > reported * magnitude * cell_area, || {
                format!("the force is off by {missing:e} of {force:?}")
            });
        }
        if sum <= 0.0 {
            return Ok(());
        }
        let compliance = Compliance::shear(&scene.bodies, solution.axis().map(Axis::index))?;
        let q = gathered(solution);
        let product = compliance.product(&q);
        let answer = Answer {
            compliance: &compliance,
            x: &q,
            product: &product,
            report: solution.report(),
            tolerance: scene.settings.tolerance,
            movable: &|i| limits[i] > 0.0,
            has_sums: oracle::prescribed_force(load).is_some(),
        };
        if !solution.is_gross_slip() || solution.axis().is_some() {
            let shift = solution.shift();
            let violated = forbidden_slip(solution, &limits, &product);
            answer.check_residual(row, violated, shift[0].abs().max(shift[1].abs()));
        }
        if q.iter().any(|q| *q != 0.0) {
            let truth = oracle::tractions(
                scene,
                shear,
                normal,
                load,
                solution,
                method,
                self.dense_limit,
            );
            let truth = truth.filter(|truth| truth.error < 1.0);
            // If the load is a shift near the limit, a reference under the computed force is not accurate to the
            // last digits.
            if truth.is_some() || !solution.is_gross_slip() {
                answer.check_error(row, truth);
            }
        }
        Ok(())
    }
}

/// Changes the gap and the load. The load is zero in between, so that it cannot conflict with the gap.
fn pose(solver: &mut NormalSolver, (gap, load): &(Field, NormalLoad)) -> Result<()> {
    solver.set_load(NormalLoad::Force(0.0))?;
    solver.set_gap(gap)?;
    solver.set_load(*load)
}

/// Returns a row with a fault.
fn broken(scene: &RandomScene, fault: String) -> Row {
    let mut row = Row::new(&scene.name, "all");
    row.fault = Some(fault);
    row
}

/// Relative distance from the limit within which a traction counts as at the limit.
pub(crate) const RIM: f64 = 1.1e-12;

/// Returns the largest slip that violates the friction law.
fn forbidden_slip(solution: &TangentialSolution, limits: &[f64], product: &[f64]) -> f64 {
    let cells = limits.len();
    let components: Vec<usize> = match solution.axis() {
        Some(axis) => vec![axis.index()],
        None => vec![0, 1],
    };
    let traction = solution.traction();
    let mut most = 0.0_f64;
    for (i, &limit) in limits.iter().enumerate().filter(|(_, limit)| **limit > 0.0) {
        let (mut q, mut slip) = ([0.0; 2], [0.0; 2]);
        for (block, &b) in components.iter().enumerate() {
            q[b] = traction[b].as_slice()[i];
            slip[b] = product[block * cells + i] - solution.shift()[b];
        }
        let size = q[0].hypot(q[1]);
        let forbidden = if size >= limit * (1.0 - RIM) {
            // Slip against the traction is unrestricted.
            let n = q.map(|q| q / size);
            let against = (-(slip[0] * n[0] + slip[1] * n[1])).max(0.0);
            (slip[0] + against * n[0]).hypot(slip[1] + against * n[1])
        } else {
            slip[0].hypot(slip[1])
        };
        most = most.max(forbidden);
    }
    most
}

/// A solution with an independent product.
pub(crate) struct Answer<'a> {
    pub(crate) compliance: &'a Compliance,
    pub(crate) x: &'a [f64],
    pub(crate) product: &'a [f64],
    pub(crate) report: &'a Report,
    pub(crate) tolerance: f64,
    pub(crate) movable: &'a dyn Fn(usize) -> bool,
    /// Whether the sums of the unknowns are prescribed.
    pub(crate) has_sums: bool,
}

/// Number of cells up to which the smallest eigenvalue for prescribed sums is computed.
const EIGENVALUES: usize = 400;

impl Answer<'_> {
    /// Returns the largest displacement, or its bound by an eigenvalue and the largest unknown.
    fn displacement(&self, eigenvalue: f64) -> f64 {
        let cells = self.compliance.cells();
        let size = |v: &[f64], i: usize| match v.get(i + cells) {
            Some(y) => v[i].hypot(*y),
            None => v[i].abs(),
        };
        let movable = (0..cells).filter(|i| (self.movable)(*i));
        let largest = movable.fold([0.0_f64; 2], |[u, x], i| {
            [u.max(size(self.product, i)), x.max(size(self.x, i))]
        });
        largest[0].max(eigenvalue * largest[1])
    }

    /// Returns `x' C x`, or its bound by the smallest eigenvalue.
    fn energy(&self) -> f64 {
        dot(self.x, self.product).max(self.compliance.lower_bound * dot(self.x, self.x))
    }

    /// Returns the relative error in the energy norm that the round-off of a product may hide.
    fn round_off(&self) -> f64 {
        // On a periodic grid a product is a difference of terms as large as the self-displacement of a cell.
        let mut one_cell = vec![0.0; self.x.len()];
        one_cell[0] = 1.0;
        let own = self.compliance.norm(&one_cell).powi(2);
        let size = dot(self.product, self.product).sqrt() + own * dot(self.x, self.x).sqrt();
        let noise = self.compliance.round_off * size;
        1e-12 + 2.0 * noise / (self.compliance.lower_bound * self.energy()).sqrt()
    }

    /// Returns the change of the energy norm due to the round-off of the total if a single cell compensates for the
    /// round-off.
    fn missing_load(&self) -> f64 {
        let magnitude: f64 = self.x.iter().map(|x| x.abs()).sum();
        let mut one_cell = vec![0.0; self.x.len()];
        one_cell[0] = self.report.load_error * magnitude;
        self.compliance.norm(&one_cell) / self.energy().sqrt()
    }

    /// Compares the reported residual, and the tolerance, with the violation found.
    pub(crate) fn check_residual(&self, row: &mut Row, violated: f64, size: f64) {
        let reported = self.report.residual;
        let mut displacement = self.displacement(self.compliance.lower_bound);
        let is_beyond = |displacement: f64| {
            let slack = 1e-13 * displacement + 8.0 * f64::EPSILON * size;
            violated > 1.001 * reported * displacement + slack
        };
        // If the sums are prescribed, the solver may use the larger eigenvalue for unknowns without sums.
        if is_beyond(displacement) && self.has_sums && self.compliance.cells() <= EIGENVALUES {
            displacement = self.displacement(self.compliance.bound_without_sums());
        }
        row.blame(is_beyond(displacement), || {
            format!(
                "complementarity is violated by {:.2e}, reported {reported:.2e}",
                violated / displacement
            )
        });
        let is_fine = self.report.is_converged();
        let within = self.report.energy_error_bound().max(reported) <= self.tolerance;
        row.blame(is_fine && !within, || {
            format!("converged beyond its tolerance: {}", self.report)
        });
    }

    /// Compares the certified error with the true error.
    pub(crate) fn check_error(&self, row: &mut Row, truth: Option<ReferenceSolution>) {
        let Some(truth) = truth.filter(|truth| truth.error < 1.0) else {
            row.blame(true, || "there is nothing to compare with".to_owned());
            return;
        };
        let difference: Vec<f64> = self.x.iter().zip(&truth.x).map(|(a, b)| a - b).collect();
        let size = self.energy().sqrt();
        let distance = self.compliance.norm(&difference);
        // A uniform traction on a periodic grid causes no deformation.
        let error = if distance > 0.0 { distance / size } else { 0.0 };
        let slack = self.round_off() + self.missing_load() + 1.001 * truth.error;
        let certified = self.report.energy_error_bound();
        row.blame(error.is_nan() || error > 1.001 * certified + slack, || {
            format!("the error {error:.2e} is beyond the certified {certified:.2e}")
        });
        row.error = Some(Measured {
            value: error,
            slack,
            against: truth.against,
        });
    }
}
