//! Server that processes one request per line: the words of [`answer`], separated by blanks.

use std::io::BufRead;
use std::time::Instant;

use stickslip::influence::Component;
use stickslip::{
    ElasticPair, Error, Field, Friction, Grid, HalfSpace, Material, NormalLoad, NormalProblem,
    NormalSolution, Report, TangentialLoad, TangentialProblem, TangentialSolution,
};

use crate::judge::judge;
use crate::{Result, read_floats, write_field};

pub(crate) fn serve() -> Result<()> {
    println!(r#"{{"ready": true}}"#);
    for line in std::io::stdin().lock().lines() {
        let line = line?;
        let words: Vec<&str> = line.split_whitespace().collect();
        match answer(&words) {
            Ok(text) => println!("{text}"),
            Err(error) => println!(r#"{{"status": "failed: {error}"}}"#),
        }
    }
    Ok(())
}

fn answer(words: &[&str]) -> Result<String> {
    match *words {
        ["press", gap, cells, pressure, tolerance, output] => {
            let press = Press::read(gap, cells, pressure)?;
            press.answer(tolerance.parse()?, output)
        }
        [
            "shear",
            gap,
            cells,
            pressure,
            friction,
            loading,
            tolerance,
            output,
        ] => Shear {
            press: Press::read(gap, cells, pressure)?,
            friction: Friction::coulomb(friction.parse()?)?,
            loading: friction.parse::<f64>()? * loading.parse::<f64>()?,
        }
        .answer(tolerance.parse()?, output),
        ["judge", component, found, truth, cells, total] => {
            let component = match component {
                "zz" => Component::ZZ,
                "xx" => Component::XX,
                other => return Err(format!("unknown component {other}").into()),
            };
            let bodies = bodies(cells.parse()?)?;
            judge(
                &bodies,
                component,
                [&read_floats(found)?, &read_floats(truth)?],
                total.parse()?,
            )
        }
        _ => Err(format!("unknown request {words:?}").into()),
    }
}

/// Creates half-spaces of contact modulus 1 on a square of side 1. Poisson's ratio is zero, the only value at which the
/// peer with friction converges. The pressure does not depend on Poisson's ratio.
fn bodies(cells: usize) -> Result<HalfSpace> {
    let body = Material::new(2.0, 0.0)?;
    Ok(HalfSpace::new(
        Grid::square(cells, 1.0)?,
        ElasticPair::new(body, body)?,
    )?)
}

/// Normal contact on an area of 1, so that the mean pressure equals the force.
struct Press {
    cells: usize,
    gap: Field,
    pressure: f64,
}

impl Press {
    fn read(gap: &str, cells: &str, pressure: &str) -> Result<Self> {
        let cells = cells.parse()?;
        let grid = Grid::square(cells, 1.0)?;
        Ok(Self {
            cells,
            gap: Field::from_vec(grid, read_floats(gap)?)?,
            pressure: pressure.parse()?,
        })
    }

    /// Solves from a cold start, including the allocation of the memory of the solver.
    fn solve(&self, bodies: &HalfSpace, tolerance: f64) -> Result<NormalSolution> {
        let load = NormalLoad::Force(self.pressure);
        let problem = NormalProblem::builder(bodies, &self.gap, load).tolerance(tolerance);
        let mut solver = problem.build()?.into_solver()?;
        let mut solution = solver.new_solution();
        match solver.solve_into(&mut solution) {
            Ok(()) | Err(Error::NotConverged(_)) => Ok(solution),
            Err(error) => Err(error.into()),
        }
    }

    /// Solves twice: first including the setup of the operators, then with the existing operators.
    fn answer(&self, tolerance: f64, output: &str) -> Result<String> {
        let start = Instant::now();
        let bodies = bodies(self.cells)?;
        self.solve(&bodies, tolerance)?;
        let whole = start.elapsed().as_secs_f64();
        let start = Instant::now();
        let solution = self.solve(&bodies, tolerance)?;
        let solve = start.elapsed().as_secs_f64();
        write_field(output, solution.pressure())?;
        let contact = solution.contact_cells() as f64 / self.gap.grid().cells() as f64;
        Ok(line(whole, solve, contact, solution.report()))
    }
}

/// Normal contact with a tangential load.
struct Shear {
    press: Press,
    friction: Friction,
    /// Ratio of the tangential to the normal force.
    loading: f64,
}

impl Shear {
    fn solve(
        &self,
        bodies: &HalfSpace,
        normal: &NormalSolution,
        tolerance: f64,
    ) -> Result<TangentialSolution> {
        let load = TangentialLoad::force([self.loading * self.press.pressure, 0.0]);
        let problem = TangentialProblem::builder(bodies, normal, self.friction.clone(), load)
            .tolerance(tolerance)
            .build()?;
        let mut solver = problem.into_solver()?;
        let mut solution = solver.new_solution();
        match solver.solve_into(&mut solution) {
            Ok(()) | Err(Error::NotConverged(_)) => Ok(solution),
            Err(error) => Err(error.into()),
        }
    }

    /// Measures first the setup of the operators and the solves for pressure and traction, then the solve for the
    /// traction alone. The tolerance of the pressure is a tenth of the tolerance of the traction, because the pressure
    /// bounds the traction.
    fn answer(&self, tolerance: f64, output: &str) -> Result<String> {
        let start = Instant::now();
        let bodies = bodies(self.press.cells)?;
        let normal = self.press.solve(&bodies, (0.1 * tolerance).max(1e-11))?;
        self.solve(&bodies, &normal, tolerance)?;
        let whole = start.elapsed().as_secs_f64();
        let start = Instant::now();
        let solution = self.solve(&bodies, &normal, tolerance)?;
        let solve = start.elapsed().as_secs_f64();
        let [traction, _] = solution.traction();
        write_field(output, traction)?;
        Ok(line(
            whole,
            solve,
            solution.stick_ratio(),
            solution.report(),
        ))
    }
}

fn line(whole: f64, solve: f64, part: f64, report: &Report) -> String {
    format!(
        r#"{{"whole": {whole}, "solve": {solve}, "status": "{}", "part": {part}, "bound": {:e}, "double": {}, "single": {}}}"#,
        report.status,
        report.energy_error_bound(),
        report.double_precision_products,
        report.single_precision_products,
    )
}
