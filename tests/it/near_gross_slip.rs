//! The vector model solves for forces that differ from the sliding force only in the last digits.

use kit::{Random, unit_bodies};
use stickslip::influence::Direction::{X, Y};
use stickslip::layers::Layer;
use stickslip::{
    Boundary, Coupling, ElasticPair, Field, Friction, Grid, HalfSpace, Material, NormalLoad,
    NormalProblem, NormalSolution, Operator, TangentialLoad, TangentialModel, TangentialProblem,
    TangentialSolution, Zone,
};

const FRICTION: f64 = 0.5;
const DIRECTION: [f64; 2] = [0.8, 0.6];

fn press_ball(cells: usize, poisson_ratio: f64) -> (HalfSpace, NormalSolution) {
    let bodies = unit_bodies(kit::square(cells, 3.0), poisson_ratio);
    let problem = NormalProblem::builder(
        &bodies,
        kit::sphere(bodies.grid(), 1.0),
        NormalLoad::Force(0.6),
    );
    let normal = kit::solve(problem);
    (bodies, normal)
}

/// Solves for the sliding force reduced by the fraction `missing`.
fn shear(bodies: &HalfSpace, normal: &NormalSolution, missing: f64) -> TangentialSolution {
    let force = (1.0 - missing) * FRICTION * normal.force();
    let load = TangentialLoad::force(DIRECTION.map(|n| n * force));
    kit::solve(
        TangentialProblem::builder(bodies, normal, kit::coulomb(FRICTION), load)
            .model(TangentialModel::Vector),
    )
}

/// All cells slip, each in a direction at an angle of order `theta` to the force. The force is then smaller than the
/// sliding force by the fraction `theta^2 / 2`. Since the displacements turn the slip of each cell, the shift beyond
/// the displacement is proportional to `1 / theta`.
#[test]
fn shift_grows_with_inverse_root_of_remaining_force() {
    for (cells, poisson_ratio) in [(5, 0.3), (9, 0.5), (16, 0.3), (32, 0.5), (64, 0.3)] {
        let (bodies, normal) = press_ball(cells, poisson_ratio);
        let limit = FRICTION * normal.force();
        let mut shifts = Vec::new();
        for missing in [1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10, 1e-11] {
            let solution = shear(&bodies, &normal, missing);
            assert!(solution.is_gross_slip());
            for (found, n) in solution.force().into_iter().zip(DIRECTION) {
                let asked = (1.0 - missing) * limit * n;
                assert!((found - asked).abs() <= 2e-12 * limit);
            }
            let shift = solution.shift();
            shifts.push(shift[0] * DIRECTION[0] + shift[1] * DIRECTION[1]);
        }
        let gains: Vec<f64> = shifts.windows(2).map(|pair| pair[1] - pair[0]).collect();
        for pair in gains.windows(2) {
            let growth = pair[1] / pair[0];
            assert!(
                (growth / 10_f64.sqrt() - 1.0).abs() < 0.02,
                "{cells} cells: {shifts:?}"
            );
        }
    }
}

/// Close to the sliding force some cells stick only if no displacement rotates the direction of slip. This requires
/// a Poisson's ratio of zero.
#[test]
fn zero_poisson_ratio_keeps_a_stick_cell_until_sliding() {
    let (bodies, normal) = press_ball(16, 0.0);
    for missing in [1e-4, 1e-7, 1e-10] {
        let solution = shear(&bodies, &normal, missing);
        assert!(solution.zones().contains(&Zone::Stick));
    }
}

/// The sum of many equal limits depends on the order of summation, so the engine must accept exactly the reported
/// limit.
#[test]
fn reported_friction_capacity_causes_gross_slip() {
    let grid = kit::square(330, 1.0);
    let bodies = unit_bodies(grid, 0.3);
    let pressure = Field::constant(grid, 0.1);
    for lateral in [TangentialModel::Scalar, TangentialModel::Vector] {
        let problem = |force| {
            let load = TangentialLoad::force([force, 0.0]);
            let problem = TangentialProblem::builder(&bodies, &pressure, kit::coulomb(0.7), load);
            problem.model(lateral).build().unwrap()
        };
        let limit = problem(0.0).friction_capacity();
        let solution = problem(limit).solve().unwrap();
        assert!(solution.is_gross_slip());
    }
}

/// The squares of some friction limits underflow compared with the squares of the others.
#[test]
fn negligible_pressures_converge() {
    let grid = kit::square(48, 100.0);
    let bodies = unit_bodies(grid, 0.3);
    let bowl = |x: f64, y: f64| 1.0 - (x * x + y * y) / 900.0;
    let pressure = Field::from_fn(grid, |x, y| bowl(x, y).max(1e-200));
    let load = TangentialLoad::force([0.3 * pressure.integral(), 0.0]);
    let problem = TangentialProblem::builder(&bodies, &pressure, kit::coulomb(0.7), load);
    let solution = problem
        .model(TangentialModel::Vector)
        .build()
        .unwrap()
        .solve();
    assert!(solution.unwrap().report().is_converged());
}

/// A random pressure on bodies with long cells and stiff coatings, sheared by a force that is smaller than the sliding
/// force by the fraction `missing`.
struct LongCellContact {
    bodies: HalfSpace,
    pressure: Field,
    direction: [f64; 2],
    missing: f64,
}

impl LongCellContact {
    fn draw(random: &mut Random) -> stickslip::Result<Self> {
        let aspect = random.decade(-2.0, 2.0);
        let grid = Grid::new(random.integer(2, 9), random.integer(2, 9), 1.0, aspect)?;
        let base = Material::from_shear_modulus(1.0, random.pick(&[0.5, 0.3]))?;
        let thickness = aspect.min(1.0) * random.decade(-1.0, 1.0);
        let coating = Layer::new(random.decade(0.0, 3.0), random.uniform(0.0, 0.5), thickness)?;
        let pair = ElasticPair::new(base.coated(&[coating])?, Material::rigid())?;
        let boundary = random.pick(&[Boundary::Periodic, Boundary::NonPeriodic]);
        let is_loaded = random.uniform(0.1, 1.0);
        let mut pressure = Field::from_fn(grid, |_, _| {
            let size = random.decade(-2.0, 0.0);
            if random.chance(is_loaded) { size } else { 0.0 }
        });
        // Two cells in contact are enough for slip in different directions.
        pressure.as_mut_slice()[..2].fill(1.0);
        let angle = random.uniform(0.0, std::f64::consts::TAU);
        Ok(Self {
            bodies: HalfSpace::with_boundary(grid, pair, boundary)?,
            pressure,
            direction: [angle.cos(), angle.sin()],
            missing: random.decade(-11.9, -6.0),
        })
    }

    /// Solves the contact. Returns a description of the first fault.
    fn fault(&self) -> Option<String> {
        const TOLERANCE: f64 = 1e-9;
        let capacity = FRICTION * self.pressure.integral();
        let force = self.direction.map(|n| (1.0 - self.missing) * capacity * n);
        let (load, friction) = (TangentialLoad::force(force), Friction::coulomb(FRICTION));
        let problem =
            TangentialProblem::builder(&self.bodies, &self.pressure, friction.unwrap(), load);
        // The residual below does not include the displacements due to the pressure.
        let problem = problem
            .model(TangentialModel::Vector)
            .coupling(Coupling::Neglected)
            .tolerance(TOLERANCE);
        let solution = match problem.build().unwrap().solve() {
            Ok(solution) => solution,
            Err(error) => return Some(error.to_string()),
        };
        let found = solution.force();
        let missed = (found[0] - force[0]).hypot(found[1] - force[1]) / capacity;
        if missed > 1e-14 {
            return Some(format!("the force is off by {missed:e}"));
        }
        let residual = self.relative_residual(&solution);
        (residual > 1.01 * TOLERANCE).then(|| format!("the residual is {residual:e}"))
    }

    /// Returns the largest slip that is not opposite to the traction, or the largest slip in stick cells, relative to the
    /// largest displacement or to its bound by the smallest eigenvalue.
    fn relative_residual(&self, solution: &TangentialSolution) -> f64 {
        let operator = self.bodies.tensor_operator([X, Y]).unwrap();
        let [x, y] = solution.traction().map(Field::as_slice);
        let (mut u, mut v) = (vec![0.0; x.len()], vec![0.0; x.len()]);
        let mut scratch = operator.scratch().unwrap();
        operator.apply([x, y], [&mut u, &mut v], &mut scratch);
        let (shift, zones) = (solution.shift(), solution.zones());
        let (mut largest, mut residual) = (0.0_f64, 0.0_f64);
        for (i, zone) in zones
            .iter()
            .enumerate()
            .filter(|(_, zone)| **zone != Zone::Separated)
        {
            let slip = [u[i] - shift[0], v[i] - shift[1]];
            let forbidden = if *zone == Zone::Stick {
                slip[0].hypot(slip[1])
            } else {
                let size = x[i].hypot(y[i]);
                let across = (slip[0] * y[i] - slip[1] * x[i]) / size;
                let along = (slip[0] * x[i] + slip[1] * y[i]) / size;
                across.hypot(along.max(0.0))
            };
            let least = operator.lower_bound() * x[i].hypot(y[i]);
            largest = largest.max(u[i].hypot(v[i])).max(least);
            residual = residual.max(forbidden);
        }
        residual / largest
    }
}

/// The last digits of such forces determine how far the bodies move, but not whether the friction law can be satisfied.
#[test]
fn long_coated_cells_slip_along_their_tractions() {
    let mut random = Random(11);
    for index in 0..kit::thorough(40, 1000) {
        let contact = LongCellContact::draw(&mut random).unwrap();
        let fault = contact.fault();
        assert!(
            fault.is_none(),
            "{index}, {:e} below sliding: {fault:?}",
            contact.missing
        );
    }
}
