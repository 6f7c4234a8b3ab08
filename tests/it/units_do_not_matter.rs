//! Two unit systems give the same digits.

use kit::{Random, max_abs, max_difference};
use stickslip::{
    Axis, ElasticPair, Field, Friction, Grid, HalfSpace, History, LoadStep, Material,
    NormalControl, NormalProblem, TangentialControl, TangentialLoad, TangentialModel,
    TangentialProblem,
};

const FRICTION: f64 = 0.6;

/// Numbers without units, and how large they could be.
struct Answer {
    quantity: &'static str,
    values: Vec<f64>,
    scale: f64,
}

impl Answer {
    /// As large as the largest.
    fn new(quantity: &'static str, values: Vec<f64>) -> Self {
        let scale = max_abs(&values);
        Self {
            quantity,
            values,
            scale,
        }
    }

    fn of(self, scale: f64) -> Self {
        Self { scale, ..self }
    }
}

/// One scene in units of length and pressure.
struct Scene {
    bodies: HalfSpace,
    gap: Field,
    length: f64,
    /// What makes a force of a pressure over lengths.
    force: f64,
    pressure: f64,
    normal: f64,
}

impl Scene {
    fn draw(seed: u64, [length, pressure]: [f64; 2]) -> Self {
        let mut random = Random(seed);
        let [nx, ny] = [random.integer(4, 48), random.integer(4, 48)];
        let sides = [1.0, random.uniform(0.5, 2.0)].map(|side| side * length);
        let grid = Grid::new(nx, ny, sides[0], sides[1]).unwrap();
        let body = Material::new(2.0 * pressure, random.uniform(-0.5, 0.5)).unwrap();
        let pair = ElasticPair::new(body, body).unwrap();
        let extent = nx.max(ny) as f64;
        // Of a rougher or lighter contact the rounding of the gap itself is worth more digits.
        let roughness = 10_f64.powf(random.uniform(-4.0, -2.0));
        let gap = Field::from_indices(grid, |ix, iy| {
            let [x, y] = [grid.x(ix), grid.y(iy)].map(|x| x / length);
            let mut noise = Random(seed ^ (iy * nx + ix) as u64);
            let height = 0.05 * (x * x + 0.5 * y * y) / extent;
            length * (height + roughness * extent * noise.uniform(0.0, 1.0))
        });
        let force = pressure * length * length;
        let load = 10_f64.powf(random.uniform(-2.0, -0.5));
        Self {
            bodies: HalfSpace::new(grid, pair).unwrap(),
            gap,
            length,
            force,
            pressure,
            normal: load * pressure * grid.area(),
        }
    }

    /// All answers, without their units.
    fn answers(&self) -> Vec<Answer> {
        let bodies = &self.bodies;
        let problem = NormalProblem::builder(bodies, &self.gap, NormalControl::Force(self.normal));
        let normal = problem
            .tolerance(TOLERANCE)
            .build()
            .unwrap()
            .solve()
            .unwrap();
        let without = |field: &Field, unit: f64| -> Vec<f64> {
            field.as_slice().iter().map(|value| value / unit).collect()
        };
        let pressure = Answer::new("pressure", without(normal.pressure(), self.pressure));
        // Tractions are what is left of the friction limit, slips of the shift, and energies of both.
        let largest_limit = FRICTION * pressure.scale;
        let mut shift = 0.0_f64;
        let approach = Answer::new("approach", vec![normal.approach() / self.length]);
        let mut answers = vec![pressure, approach];
        let limit = FRICTION * self.normal;
        let friction = || Friction::coulomb(FRICTION).unwrap();
        for (load, lateral) in [
            ([0.7 * limit, 0.0], TangentialModel::Scalar),
            ([0.5 * limit, -0.4 * limit], TangentialModel::Vector),
        ] {
            let load = TangentialLoad::force(load);
            let builder = TangentialProblem::builder(bodies, &normal, friction(), load);
            let builder = builder.model(lateral).tolerance(TOLERANCE);
            let shear = builder.build().unwrap().solve().unwrap();
            let tractions = shear.traction().map(|q| without(q, self.pressure));
            answers.push(Answer::new("traction", tractions.concat()).of(largest_limit));
            let shifts = Answer::new("shift", shear.shift().map(|s| s / self.length).to_vec());
            shift = shift.max(shifts.scale);
            answers.push(shifts);
            let work = limit / self.force * shift;
            let energy = shear.dissipated_energy() / self.force / self.length;
            answers.push(Answer::new("energy", vec![energy]).of(work));
        }
        for lateral in [TangentialModel::Scalar, TangentialModel::Vector] {
            let builder = History::builder(bodies, &self.gap, friction()).model(lateral);
            let mut history = builder.tolerance(TOLERANCE).build().unwrap();
            let (mut energies, mut shifts) = (Vec::new(), Vec::new());
            for (load, tangential) in [
                (0.8, TangentialControl::Hold),
                (1.0, TangentialControl::Force(0.6 * limit)),
                (1.0, TangentialControl::Force(-0.3 * limit)),
                (0.9, TangentialControl::Shift(0.0)),
            ] {
                let step = LoadStep::hold().normal(NormalControl::Force(load * self.normal));
                let step = step.tangential(Axis::X, tangential);
                let energy = history.step(&step).unwrap().energy();
                let parts = [energy.work, energy.dissipated_energy];
                energies.extend(parts.map(|part| part / self.force / self.length));
                shifts.extend(history.shift().map(|s| s / self.length));
            }
            let tractions = history.traction().map(|q| without(q, self.pressure));
            let tractions = Answer::new("traction of a history", tractions.concat());
            let accumulated_slip = Answer::new(
                "slip path",
                without(history.accumulated_slip(), self.length),
            );
            answers.extend([
                tractions.of(largest_limit),
                accumulated_slip.of(shift),
                Answer::new("shift of a history", shifts).of(shift),
                Answer::new("energy of a history", energies).of(limit / self.force * shift),
            ]);
        }
        answers
    }
}

const TOLERANCE: f64 = 2e-13;

/// Units that are powers of two round nothing: every bit is the same.
#[test]
fn in_units_of_powers_of_two() {
    for seed in 0..12 {
        let one = Scene::draw(seed, [1.0, 1.0]).answers();
        for (length, pressure) in [(-10, 20), (7, -30), (-40, 3)] {
            let units = [length, pressure].map(|power| 2_f64.powi(power));
            let other = Scene::draw(seed, units).answers();
            for (one, other) in one.iter().zip(&other) {
                let bits = |answer: &Answer| -> Vec<u64> {
                    answer.values.iter().map(|value| value.to_bits()).collect()
                };
                assert!(bits(one) == bits(other), "{} of scene {seed}", one.quantity);
            }
        }
    }
}

/// Metres and pascals, millimetres and megapascals, micrometres and gigapascals.
#[test]
fn in_units_of_powers_of_ten() {
    for seed in 0..24 {
        let one = Scene::draw(seed, [1e-3, 1e9]).answers();
        for units in [[1.0, 1e3], [1e3, 1.0], [1e-6, 1e12]] {
            let other = Scene::draw(seed, units).answers();
            for (one, other) in one.iter().zip(&other) {
                let error = max_difference(&one.values, &other.values) / one.scale;
                assert!(
                    error <= 1e-12,
                    "{} of scene {seed}: {error:e}",
                    one.quantity
                );
            }
        }
    }
}
