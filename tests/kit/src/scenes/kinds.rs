//! Random contacts of every type, each determined by its index. They test the outcomes of the solves of problems and
//! then of a history.

use std::panic::{AssertUnwindSafe, catch_unwind};

use stickslip::Report;
use stickslip::cgm::Settings;
use stickslip::normal::Hardness;
use stickslip::{
    Boundary, CoupledProblem, Coupling, ElasticPair, Error, Field, Friction, Grid, HalfSpace,
    History, LoadStep, Material, NormalLoad, NormalProblem, NormalSolution, Result, TangentialLoad,
    TangentialModel, TangentialProblem,
};

use super::draw::{self, PATIENCE};
use super::oracle::limits;
use super::row::Row;
use super::{Expected, gaps};
use crate::Random;

/// Kind of random contact.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Kind {
    OneWay,
    Plane,
    Hardness,
    Punch,
    SingleCell,
    Periodic,
    Line,
    NearSliding,
    Coupled,
}

const KINDS: [(Kind, &str); 9] = [
    (Kind::OneWay, "one-way coupling"),
    (Kind::Plane, "in the plane"),
    (Kind::Hardness, "hardness"),
    (Kind::Punch, "punch"),
    (Kind::SingleCell, "single cell"),
    (Kind::Periodic, "periodic"),
    (Kind::Line, "line"),
    (Kind::NearSliding, "near sliding"),
    (Kind::Coupled, "coupled"),
];

/// Period of the indices that are also histories.
const HISTORIES: u64 = 3;

/// Period of the indices that also have a contact of scattered spots on a larger grid.
pub const SCATTERED: u64 = 101;

/// Relative deficit from the sliding force in the vector model. Below this deficit the solution depends on the last
/// digits of the force, and a solve may stall.
const LAST_DIGITS: f64 = 1e-7;

/// Returns the rows of an index. The scene of each row is the name of its problem.
pub fn rows(index: u64) -> Vec<Row> {
    let (kind, name) = KINDS[(index % KINDS.len() as u64) as usize];
    let mut random = draw::random_of(index ^ 0x6b69_6e64);
    let solved = AssertUnwindSafe(|| {
        let contact = Contact::draw(kind, &mut random)?;
        let mut rows = contact.problems(name)?;
        if index / KINDS.len() as u64 % HISTORIES == 0 {
            rows.extend(contact.history(name, &mut random)?);
        }
        if index % SCATTERED == 0 {
            let mut random = draw::random_of(index ^ 0x7370_6f74);
            let (contact, name) = (Contact::scattered(&mut random)?, "scattered");
            rows.extend(contact.problems(name)?);
            rows.extend(contact.history(name, &mut random)?);
        }
        Ok(rows)
    });
    let fault = match catch_unwind(solved) {
        Ok(Ok(rows)) => return rows,
        Ok(Err::<_, Error>(error)) => error.to_string(),
        Err(_) => "panicked".to_owned(),
    };
    let mut row = Row::new(name, "all");
    row.fault = Some(fault);
    vec![row]
}

/// A contact, and the fraction of the sliding force that shears it.
#[derive(Debug)]
struct Contact {
    bodies: HalfSpace,
    gap: Field,
    force: f64,
    hardness: Option<Hardness>,
    friction: Friction,
    model: TangentialModel,
    coupling: Coupling,
    direction: [f64; 2],
    part: f64,
    settings: Settings,
}

fn grid(kind: Kind, random: &mut Random) -> Result<Grid> {
    let sides = [random.uniform(0.5, 2.0), random.uniform(0.5, 2.0)];
    let [nx, ny] = match kind {
        Kind::Line => return Grid::line(random.integer(1, 60), sides[0]),
        Kind::SingleCell if random.chance(0.5) => [1, 1],
        Kind::SingleCell => [random.integer(1, 7), random.integer(1, 7)],
        Kind::Coupled => [random.integer(3, 13), random.integer(3, 13)],
        _ => [random.integer(1, 20), random.integer(1, 20)],
    };
    Grid::new(
        nx,
        ny,
        sides[0],
        if random.chance(0.5) {
            sides[0]
        } else {
            sides[1]
        },
    )
}

fn boundary(kind: Kind, grid: Grid, random: &mut Random) -> Boundary {
    let along_y = Boundary::PeriodicAlongY {
        datum: grid.dx() * grid.nx() as f64 * random.decade(0.0, 3.0),
    };
    match kind {
        Kind::Line => along_y,
        Kind::Periodic => Boundary::Periodic,
        Kind::Punch => Boundary::NonPeriodic,
        _ => random.pick(&[
            Boundary::NonPeriodic,
            Boundary::NonPeriodic,
            Boundary::Periodic,
            along_y,
        ]),
    }
}

fn pair(kind: Kind, random: &mut Random) -> Result<ElasticPair> {
    let body = |random: &mut Random| {
        let poisson_ratio = random.pick(&[0.0, 0.0, 0.05, 0.3, 0.5]);
        Material::new(random.decade(-1.0, 1.0), poisson_ratio)
    };
    let one = body(random)?;
    match kind {
        Kind::OneWay | Kind::Coupled if random.chance(0.6) => {
            ElasticPair::new(one, Material::rigid())
        }
        Kind::OneWay | Kind::Coupled => ElasticPair::new(one, body(random)?),
        _ => ElasticPair::new(one, one),
    }
}

fn gap(kind: Kind, grid: Grid, random: &mut Random) -> Field {
    let size = (grid.dx() * grid.nx() as f64).max(grid.dy() * grid.ny() as f64);
    match kind {
        Kind::Punch => gaps::punch(
            grid,
            size * random.uniform(0.1, 0.6),
            size * random.decade(-3.0, 1.0),
        ),
        Kind::SingleCell => {
            let cell = [grid.nx(), grid.ny()].map(|n| random.integer(0, n - 1));
            gaps::nails(grid, size * random.decade(-1.0, 1.0), &[cell])
        }
        _ => match random.integer(0, 5) {
            0 => Field::zeros(grid),
            1 => gaps::white_noise(grid, size * random.decade(-4.0, -0.5), random),
            2 => gaps::waves(
                grid,
                [-4.0, -4.0].map(|least| size * random.decade(least, -1.0)),
            ),
            3 => gaps::punch(
                grid,
                size * random.uniform(0.1, 0.6),
                size * random.decade(-3.0, 1.0),
            ),
            _ => gaps::bowl(grid, size * random.decade(-0.5, 1.5)),
        },
    }
}

/// Draws the deficit from the sliding force, as a fraction.
fn missing(kind: Kind, random: &mut Random) -> f64 {
    match kind {
        Kind::NearSliding => random.decade(-9.0, -6.0),
        _ => 1.0 - random.uniform(0.0, 0.99),
    }
}

impl Contact {
    fn draw(kind: Kind, random: &mut Random) -> Result<Self> {
        let grid = grid(kind, random)?;
        let pair = pair(kind, random)?;
        let bodies = HalfSpace::with_boundary(grid, pair, boundary(kind, grid, random))?;
        let gap = gap(kind, grid, random);
        let force = pair.contact_modulus() * grid.area() * random.decade(-5.0, -0.5);
        let has_hardness = match kind {
            Kind::Hardness => true,
            Kind::Punch => random.chance(0.7),
            _ => false,
        };
        // The largest limit is never reached.
        let hardness = has_hardness.then(|| {
            let least = force / grid.area();
            Hardness::uniform(least * random.pick(&[1.05, 1.5, 3.0, 10.0, 100.0, 1e4]))
        });
        let is_in_plane = !matches!(kind, Kind::Hardness | Kind::Line) || random.chance(0.3);
        let (model, angle) = if is_in_plane {
            (
                TangentialModel::Vector,
                random.uniform(0.0, std::f64::consts::TAU),
            )
        } else {
            (
                TangentialModel::Scalar,
                random.pick(&[0.0, std::f64::consts::PI]),
            )
        };
        Ok(Self {
            friction: Friction::coulomb(random.decade(-2.0, 0.3))?,
            hardness: hardness.transpose()?,
            coupling: match kind {
                Kind::Coupled => Coupling::Full,
                _ => Coupling::OneWay,
            },
            direction: if is_in_plane {
                [angle.cos(), angle.sin()]
            } else {
                [angle.cos(), 0.0]
            },
            part: 1.0 - missing(kind, random),
            settings: Settings::default()
                .tolerance(random.pick(&[1e-4, 1e-8, 1e-8, 1e-10]))
                .time_limit(PATIENCE),
            bodies,
            gap,
            force,
            model,
        })
    }

    /// Draws a contact of scattered spots, for which the solver uses its sparse inverse.
    fn scattered(random: &mut Random) -> Result<Self> {
        let kind = random.pick(&[Kind::OneWay, Kind::Plane, Kind::Hardness]);
        let contact = Self::draw(kind, random)?;
        let [nx, ny] = [(); 2].map(|()| random.integer(76, 90));
        let grid = Grid::new(nx, ny, 1.0, random.uniform(0.6, 1.7))?;
        let (pair, slope) = (contact.bodies.pair(), random.decade(-2.0, 0.0));
        // The contact area of rough surfaces is proportional to the load divided by the slope.
        let pressure = 0.5 * pair.contact_modulus() * slope * random.uniform(0.03, 0.25);
        Ok(Self {
            bodies: HalfSpace::new(grid, *pair)?,
            gap: gaps::asperities(grid, slope, random),
            force: pressure * grid.area(),
            hardness: None,
            ..contact
        })
    }

    fn press(&self) -> NormalLoad {
        NormalLoad::Force(self.force)
    }

    /// Solves the pressure and then the tractions, or the coupled problem.
    fn problems(&self, name: &str) -> Result<Vec<Row>> {
        if self.coupling == Coupling::Full && self.bodies.pair().is_coupled() {
            return self.both(name);
        }
        let mut problem = NormalProblem::builder(&self.bodies, &self.gap, self.press())
            .tolerance(self.settings.tolerance)
            .time_limit(PATIENCE);
        if let Some(hardness) = &self.hardness {
            problem = problem.hardness(hardness.clone());
        }
        let mut row = Row::new(name, "pressure");
        let pressed = problem.build()?.solve();
        end(
            &mut row,
            &pressed,
            |normal| Some(normal.report()),
            self.expected(0.0),
        );
        let Ok(normal) = pressed else {
            return Ok(vec![row]);
        };
        let limit = self
            .hardness
            .as_ref()
            .map_or(f64::INFINITY, |hardness| hardness.of_cell(0));
        let pressure = normal.pressure();
        row.blame(!(pressure.min() >= 0.0 && pressure.max() <= limit), || {
            "a pressure is not within its limits".to_owned()
        });
        Ok(vec![row, self.shear(name, &normal)?])
    }

    fn shear(&self, name: &str, normal: &NormalSolution) -> Result<Row> {
        let mut row = Row::new(name, "shear");
        let limits = limits(&self.friction, normal);
        let capacity = limits.iter().sum::<f64>() * normal.grid().cell_area();
        let load = TangentialLoad::force(self.direction.map(|n| n * self.part * capacity));
        let problem = TangentialProblem::builder(&self.bodies, normal, self.friction.clone(), load)
            .model(self.model)
            .coupling(self.coupling)
            .tolerance(self.settings.tolerance)
            .time_limit(PATIENCE);
        let sheared = problem.build()?.solve();
        end(
            &mut row,
            &sheared,
            |shear| Some(shear.report()),
            self.expected(self.part),
        );
        if let Ok(shear) = sheared {
            let [x, y] = shear.traction().map(Field::as_slice);
            let is_held = |i: usize| x[i].hypot(y[i]) <= limits[i] * (1.0 + 1e-14);
            row.blame(!(0..limits.len()).all(is_held), || {
                "a traction is beyond its limit".to_owned()
            });
        }
        Ok(row)
    }

    fn both(&self, name: &str) -> Result<Vec<Row>> {
        let mut row = Row::new(name, "both");
        let capacity = self.friction.limit(0, 1.0) * self.force;
        let load = TangentialLoad::force(self.direction.map(|n| n * self.part * capacity));
        let (bodies, gap, friction) = (&self.bodies, &self.gap, self.friction.clone());
        let problem = CoupledProblem::builder(bodies, gap, friction, self.press(), load)
            .tolerance(self.settings.tolerance)
            .time_limit(PATIENCE);
        let solved = problem.build()?.solve();
        end(
            &mut row,
            &solved,
            |both| Some(&both.report().work),
            Expected::Answer,
        );
        Ok(vec![row])
    }

    /// Returns the displacement due to the force over a contact of the size of the grid.
    fn reach(&self) -> f64 {
        let (modulus, grid) = (self.bodies.pair().contact_modulus(), self.bodies.grid());
        self.force / (modulus * grid.area().sqrt())
    }

    /// Returns the fraction of the displacement `Self::reach` that remains if constants cause no displacement. If a
    /// pressure is between zero and `h` times its mean, its root-mean-square difference from the mean is at most
    /// `sqrt(h - 1)` times the mean.
    fn part_of_reach(&self) -> f64 {
        let mean = self.force / self.bodies.grid().area();
        let limit = self.hardness.as_ref().map(|hardness| hardness.of_cell(0));
        match (self.bodies.boundary(), limit) {
            (Boundary::Periodic, Some(limit)) => (limit / mean - 1.0).sqrt().min(1.0),
            _ => 1.0,
        }
    }

    /// Returns the expected ending for this fraction of the sliding force.
    fn expected(&self, part: f64) -> Expected {
        let is_sliding = self.model == TangentialModel::Vector && 1.0 - part < 1.01 * LAST_DIGITS;
        // The last digit of a height is compared with a displacement of which only the order of magnitude is known.
        let displacement = self.reach() * self.part_of_reach();
        let digit = 10.0 * f64::EPSILON * self.gap.max().max(-self.gap.min()) / displacement;
        if is_sliding || self.settings.tolerance < digit {
            Expected::AnswerOrRoundOff
        } else {
            Expected::Answer
        }
    }

    /// Moves back and forth by force, by shift, and under a different load.
    fn history(&self, name: &str, random: &mut Random) -> Result<Vec<Row>> {
        let mut builder = History::builder(&self.bodies, &self.gap, self.friction.clone())
            .model(self.model)
            .coupling(self.coupling)
            .tolerance(self.settings.tolerance)
            .time_limit(PATIENCE);
        if let Some(hardness) = &self.hardness {
            builder = builder.hardness(hardness.clone());
        }
        let mut history = builder.build()?;
        let capacity = self.friction.limit(0, 1.0) * self.force;
        let reach = self.reach();
        let force = |part: f64| LoadStep::force(self.direction.map(|n| n * part * capacity));
        let shift = |part: f64| LoadStep::shift(self.direction.map(|n| n * part * reach));
        let press = |part: f64| NormalLoad::Force(part * self.force);
        let turn = random.uniform(-0.9, 0.9);
        let steps = [
            ("press", LoadStep::hold().normal(press(1.0)), 0.0),
            ("force", force(self.part), self.part),
            ("back", force(-self.part * turn), turn),
            ("shift", shift(random.decade(-3.0, 0.5)), 0.0),
            (
                "press more",
                LoadStep::hold().normal(press(random.uniform(1.0, 1.04))),
                0.0,
            ),
            (
                "let go",
                force(0.0).normal(press(random.uniform(0.1, 1.0))),
                0.0,
            ),
        ];
        let mut rows = Vec::new();
        for (act, load, part) in steps {
            let mut row = Row::new(name, format!("history, {act}"));
            let stepped = history.step(&load).map(|_| ());
            let step = history.last_step().ok();
            let report = step.and_then(|step| step.tangential_report().or(step.normal_report()));
            end(&mut row, &stepped, |()| report, self.expected(part));
            let is_pressed = history.normal().contact_cells() > 0;
            rows.push(row);
            if !is_pressed {
                break;
            }
        }
        Ok(rows)
    }
}

/// Records how a solve ended.
fn end<'a, T>(
    row: &mut Row,
    outcome: &'a Result<T>,
    report: impl FnOnce(&'a T) -> Option<&'a Report>,
    wanted: Expected,
) {
    match outcome {
        Ok(answer) => match report(answer) {
            Some(report) => {
                row.end(&Ok(()), report, wanted);
            }
            None => "converged".clone_into(&mut row.ending),
        },
        Err(Error::NotConverged(report)) => {
            row.end(&Err(Error::NotConverged(report.clone())), report, wanted);
        }
        Err(error) => row.refuse(error, wanted),
    }
}
