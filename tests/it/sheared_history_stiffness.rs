//! Histories are sheared in any direction. Their tangential stiffness agrees with differences of their last step.

use std::fmt;
use std::ops::ControlFlow;

use kit::Random;
use rayon::prelude::*;
use stickslip::stiffness::{ContactStiffness, StiffnessWorkspace, TangentialStiffness};
use stickslip::{
    Boundary, ElasticPair, Error, Field, Friction, Grid, HalfSpace, History, LoadStep, Material,
    NormalLoad, TangentialModel, Zone,
};

/// Largest error of an entry.
const TOLERANCE: f64 = 1e-6;

/// History in the vector model: the steps before the last one, and the last step.
struct ShearedHistory {
    bodies: HalfSpace,
    gap: Field,
    friction: f64,
    /// Approach of the first step beyond the first point of contact.
    depth: f64,
    before: Vec<ShearStep>,
    last: ShearStep,
}

/// Normal load of a step, and the shift and the twist at its end.
#[derive(Debug, Clone, Copy)]
struct ShearStep {
    normal: NormalLoad,
    motion: [f64; 3],
}

/// Result of the comparison with differences.
#[derive(Debug)]
enum Outcome {
    /// Largest error of an entry, relative to the largest entry of the same quantity at reversal.
    Compared(f64),
    /// The difference quotients of two increments disagree, because a set of cells changes nearby.
    Kink,
    /// The history or its stiffness ends with an error.
    Refused(Error),
}

impl ShearedHistory {
    /// Draws a random history on a few cells.
    fn random(index: u64) -> Self {
        let mut random = Random(0x5348_4541_5245_4400 + index);
        let cells = [random.integer(1, 8), random.integer(1, 8)];
        let sides = [random.decade(-0.5, 0.5), random.decade(-0.5, 0.5)];
        let grid = Grid::new(cells[0], cells[1], sides[0] / 2.0, sides[1] / 2.0).unwrap();
        let boundary = match random.integer(0, 3) {
            0 => Boundary::Periodic,
            1 => Boundary::PeriodicAlongY {
                datum: 2.0 * grid.nx() as f64 * grid.dx(),
            },
            _ => Boundary::NonPeriodic,
        };
        let poisson_ratio = if random.chance(0.1) {
            0.0
        } else {
            random.uniform(0.0, 0.49)
        };
        let bodies = HalfSpace::with_boundary(
            grid,
            kit::alike(random.decade(-1.0, 1.0), poisson_ratio),
            boundary,
        )
        .unwrap();
        let side = (grid.nx() as f64 * grid.dx()).max(grid.ny() as f64 * grid.dy());
        let gap = if random.chance(0.5) {
            kit::sphere(grid, side * random.uniform(0.5, 3.0))
        } else {
            let height = side * random.decade(-2.0, 0.0);
            let heights = (0..grid.cells()).map(|_| height * random.uniform(0.0, 1.0));
            Field::from_vec(grid, heights.collect()).unwrap()
        };
        let friction = random.uniform(0.05, 1.0);
        // A periodic contact must not close completely.
        let depth = if boundary == Boundary::Periodic {
            let mean = gap.as_slice().iter().sum::<f64>() / grid.cells() as f64;
            (mean - gap.min()) * random.uniform(0.05, 0.9)
        } else {
            side * random.decade(-2.0, 0.0)
        };
        let approach = gap.min() + depth;
        let may_turn = boundary == Boundary::NonPeriodic && random.chance(0.3);
        let angle = random.uniform(0.0, 2.0 * std::f64::consts::PI);
        let mut step = || {
            let length = friction * depth * random.decade(-1.5, 1.5);
            let angle = if random.chance(0.5) {
                angle
            } else {
                random.uniform(0.0, 2.0 * std::f64::consts::PI)
            };
            let twist = if may_turn {
                length / side * random.uniform(-1.0, 1.0)
            } else {
                0.0
            };
            let approach = if random.chance(0.5) {
                approach
            } else {
                gap.min() + depth * random.uniform(0.7, 1.1)
            };
            ShearStep {
                normal: NormalLoad::Approach(approach),
                motion: [length * angle.cos(), length * angle.sin(), twist],
            }
        };
        let mut before = vec![ShearStep {
            normal: NormalLoad::Approach(approach),
            motion: [0.0; 3],
        }];
        let last = step();
        if index % 3 > 0 {
            before.push(step());
        }
        if index % 3 > 1 {
            before.push(step());
        }
        Self {
            bodies,
            gap,
            friction,
            depth,
            before,
            last,
        }
    }

    fn start(&self) -> Result<History, Error> {
        let friction = Friction::coulomb(self.friction)?;
        let builder = History::builder(&self.bodies, &self.gap, friction);
        let builder = builder.model(TangentialModel::Vector);
        let mut history = builder.tolerance(1e-13).build()?;
        for step in &self.before {
            self.take(&mut history, *step)?;
        }
        Ok(history)
    }

    fn take(&self, history: &mut History, step: ShearStep) -> Result<(), Error> {
        let [x, y, twist] = step.motion;
        let mut load = LoadStep::shift([x, y]).normal(step.normal);
        if self.may_turn() {
            load = load.twist(twist);
        }
        history.step(&load).map(|_| ())
    }

    fn may_turn(&self) -> bool {
        self.bodies.boundary() == Boundary::NonPeriodic
    }

    /// Asserts that the error bound of a stiffness with a large tolerance is valid.
    fn check_bound(&self, end: &History, fine: &TangentialStiffness) -> Result<(), Error> {
        let mut workspace = StiffnessWorkspace::new().tolerance(1e-2)?;
        let found = end.stiffness_with(&mut workspace, |_| ControlFlow::Continue(()));
        // A residual of this size may give a bound above the tolerance.
        let rough = match found {
            Err(Error::NotConverged(_)) => return Ok(()),
            other => other?.tangential,
        };
        let largest = numbers(fine.reversal);
        let pairs = [
            (rough.loading, fine.loading),
            (rough.reversal, fine.reversal),
        ];
        for (found, exact) in pairs {
            let [found, exact] = [found, exact].map(|matrix| self.about_centre(end, matrix));
            let kinds = if self.may_turn() { 3 } else { 2 };
            for (a, b) in (0..kinds).flat_map(|a| (0..kinds).map(move |b| (a, b))) {
                let error = (found[a][b] - exact[a][b]).abs();
                let bound = rough.bound * (exact[a][a] * exact[b][b]).max(0.0).sqrt();
                let round_off = 1e-12 * (largest[a][a] * largest[b][b]).sqrt();
                assert!(
                    error <= bound + round_off,
                    "{error:e} for {bound:e}: {self}"
                );
            }
        }
        Ok(())
    }

    /// Returns the matrix for a twist about the centroid of the contact cells.
    fn about_centre(&self, end: &History, matrix: [[Option<f64>; 3]; 3]) -> [[f64; 3]; 3] {
        let grid = self.gap.grid();
        let touching = (0..grid.cells()).filter(|&i| end.zones()[i] != Zone::Separated);
        let (mut centre, mut count) = ([0.0; 2], 0.0);
        for i in touching {
            centre[0] += grid.x(i % grid.nx());
            centre[1] += grid.y(i / grid.nx());
            count += 1.0;
        }
        let [x, y] = centre.map(|sum| sum / count);
        // Transform loads and motions from the origin to the centroid.
        let moved = |row: [f64; 3]| [row[0], row[1], row[2] + y * row[0] - x * row[1]];
        let rows = numbers(matrix).map(moved);
        let columns = [0, 1, 2].map(|b| moved(rows.map(|row| row[b])));
        [0, 1, 2].map(|a| columns.map(|column| column[a]))
    }

    /// Compares the stiffness with central differences of the last step with the same stick and slip zones.
    fn outcome(&self) -> Outcome {
        self.compared().unwrap_or_else(Outcome::Refused)
    }

    fn assert_is_right(&self) {
        match self.outcome() {
            Outcome::Compared(error) => assert!(error < TOLERANCE, "{error:e}"),
            other => panic!("{other:?}"),
        }
    }

    fn compared(&self) -> Result<Outcome, Error> {
        let start = self.start()?;
        let mut end = start.clone();
        self.take(&mut end, self.last)?;
        let ContactStiffness { tangential, .. } = end.stiffness()?;
        assert!(tangential.bound <= 1e-10, "{:e}: {self}", tangential.bound);
        let numbers =
            |matrix: [[Option<f64>; 3]; 3]| matrix.map(|row| row.map(Option::unwrap_or_default));
        self.check_bound(&end, &tangential)?;
        let [loading, reversal] = [tangential.loading, tangential.reversal].map(numbers);
        let scale = |a: usize, b: usize| (reversal[a][a] * reversal[b][b]).sqrt();
        let entry = |load: usize, motion: usize| loading[load][motion];
        let motions = if self.may_turn() { 3 } else { 2 };
        let grid = self.gap.grid();
        let side = (grid.nx() as f64 * grid.dx()).max(grid.ny() as f64 * grid.dy());
        let loads = |history: &History| {
            let [x, y] = history.tangential_force();
            [x, y, history.moment()]
        };
        let mut worst = 0.0_f64;
        for motion in 0..motions {
            let unit = if motion == 2 { 1.0 / side } else { 1.0 };
            let slope = |part: f64| -> Result<Option<[f64; 3]>, Error> {
                let small = part * self.friction * self.depth * unit;
                let mut loads_at = [[0.0; 3]; 2];
                for (found, sign) in loads_at.iter_mut().zip([1.0, -1.0]) {
                    let mut step = self.last;
                    step.motion[motion] += sign * small;
                    let mut moved = start.clone();
                    self.take(&mut moved, step)?;
                    if moved.zones() != end.zones() {
                        return Ok(None);
                    }
                    *found = loads(&moved);
                }
                let slope = |load: usize| (loads_at[0][load] - loads_at[1][load]) / (2.0 * small);
                Ok(Some([0, 1, 2].map(slope)))
            };
            let (Some(fine), Some(coarse)) = (slope(1e-4)?, slope(2e-4)?) else {
                return Ok(Outcome::Kink);
            };
            let slopes = fine.into_iter().zip(coarse).enumerate();
            for (load, (fine, coarse)) in slopes.take(motions) {
                let scale = scale(load, motion);
                // Both increments have an error of second order.
                let better = (4.0 * fine - coarse) / 3.0;
                if (better - fine).abs() > TOLERANCE * scale {
                    return Ok(Outcome::Kink);
                }
                worst = worst.max((entry(load, motion) - better).abs() / scale);
            }
        }
        Ok(Outcome::Compared(worst))
    }
}

impl fmt::Display for ShearedHistory {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self {
            bodies,
            gap,
            friction,
            before,
            last,
            ..
        } = self;
        write!(
            f,
            "{:?}, {:?}, {:?}, gap {:?}, friction {friction}, {before:?}, {last:?}",
            gap.grid(),
            bodies.boundary(),
            bodies.pair(),
            gap.as_slice()
        )
    }
}

/// Replaces entries that the model does not have by zero.
fn numbers(matrix: [[Option<f64>; 3]; 3]) -> [[f64; 3]; 3] {
    matrix.map(|row| row.map(Option::unwrap_or_default))
}

#[test]
fn obliquely_sliding_ball_stiffness_matches_last_step() {
    let grid = kit::square(8, 3.0);
    let body = Material::from_shear_modulus(1.0, 0.3).unwrap();
    let force = |motion| ShearStep {
        normal: NormalLoad::Force(0.5),
        motion,
    };
    let scene = ShearedHistory {
        bodies: HalfSpace::new(grid, ElasticPair::new(body, body).unwrap()).unwrap(),
        gap: kit::sphere(grid, 1.0),
        friction: 0.3,
        depth: 0.5,
        before: vec![force([0.0; 3])],
        last: force([1.2, 1.6, 0.0]),
    };
    scene.assert_is_right();
}

#[test]
fn obliquely_sliding_row_stiffness_matches_last_step() {
    let grid = Grid::new(5, 1, 1.0, 1.0).unwrap();
    let body = Material::new(1.0, 0.48).unwrap();
    let angle: f64 = 4.48;
    let pressed = |motion| ShearStep {
        normal: NormalLoad::Approach(0.1),
        motion,
    };
    let scene = ShearedHistory {
        bodies: HalfSpace::new(grid, ElasticPair::new(body, body).unwrap()).unwrap(),
        gap: Field::from_vec(grid, vec![1.0, 0.3, 0.0, 0.01, 0.5]).unwrap(),
        friction: 0.5,
        depth: 0.1,
        before: vec![pressed([0.0; 3])],
        last: pressed([0.1 * angle.cos(), 0.1 * angle.sin(), 0.0]),
    };
    scene.assert_is_right();
}

/// A history may end with an error only if it closes a periodic contact, which the random draw does not exclude.
#[test]
fn random_sheared_history_stiffness_matches_last_step() {
    let count = kit::thorough(60, 10_000);
    let outcomes: Vec<(u64, Outcome)> = (0..count)
        .into_par_iter()
        .map(|index| (index, ShearedHistory::random(index).outcome()))
        .collect();
    let (mut kinks, mut closed, mut wrong) = (0, 0, Vec::new());
    for (index, outcome) in &outcomes {
        match outcome {
            Outcome::Compared(error) if *error < TOLERANCE => {}
            Outcome::Kink => kinks += 1,
            Outcome::Refused(Error::ApproachBeyondMeanGap { .. }) => closed += 1,
            Outcome::Refused(_) | Outcome::Compared(_) => {
                wrong.push(format!(
                    "{index}: {outcome:?}, {}",
                    ShearedHistory::random(*index)
                ));
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    let (few, some) = (count / 500 + 1, count / 50);
    assert!(
        kinks <= few && closed <= some,
        "{kinks} kinks, {closed} closed"
    );
}
