//! Histories over difficult scenes: every step is compared with the friction law, with its own slip and with the dense
//! reference.

use stickslip::cgm::{Bounds, Settings};
use stickslip::influence::Component;
use stickslip::{
    Axis, Boundary, Coupling, ElasticPair, Error, Field, Friction, Grid, HalfSpace, History,
    LoadStep, Material, NormalLoad, Result, TangentialControl, TangentialModel,
};

use super::compliance::Compliance;
use super::judge::{Answer, RIM};
use super::oracle::{ReferenceSolution, limits, matrix};
use super::row::Row;
use super::{Expected, draw, gaps};
use crate::Random;

/// A contact and its load history.
#[derive(Debug)]
pub(crate) struct LoadHistory {
    pub(crate) name: String,
    pub(crate) bodies: HalfSpace,
    pub(crate) gap: Field,
    pub(crate) friction: Friction,
    pub(crate) lateral: TangentialModel,
    pub(crate) settings: Settings,
    /// Normal force of the first step.
    pub(crate) force: f64,
    pub(crate) acts: Vec<StepAction>,
}

/// One step, in fractions of the friction capacity or the displacement of the contact after the first step.
#[derive(Debug, Clone, Copy)]
pub(crate) enum StepAction {
    Force([f64; 2]),
    Shift([f64; 2]),
    Press(f64),
    Hold,
}

const DENSE_LIMIT: usize = 150;

/// State before a step, on which the step depends.
struct Before {
    slip: [Vec<f64>; 2],
    shift: [f64; 2],
}

impl LoadHistory {
    /// Returns a row for every step.
    pub(crate) fn rows(&self) -> Vec<Row> {
        match self.tell() {
            Ok(rows) => rows,
            Err(error) => {
                let mut row = Row::new(&self.name, "history");
                row.fault = Some(error.to_string());
                vec![row]
            }
        }
    }

    fn tell(&self) -> Result<Vec<Row>> {
        let mut builder = History::builder(&self.bodies, &self.gap, self.friction.clone())
            .model(self.lateral)
            .coupling(Coupling::Neglected)
            .tolerance(self.settings.tolerance);
        if let Some(limit) = self.settings.time_limit {
            builder = builder.time_limit(limit);
        }
        let mut history = builder.build()?;
        history.step(&LoadStep::hold().normal(NormalLoad::Force(self.force)))?;
        let first = limits(&self.friction, history.normal());
        let friction_capacity = first.iter().sum::<f64>() * history.grid().cell_area();
        let axis = history.axis().map(Axis::index);
        let compliance = Compliance::shear(&self.bodies, axis)?;
        let reach = largest(&Compliance::shear(&self.bodies, Some(0))?.product(&first));

        let mut rows = Vec::new();
        for (number, act) in self.acts.iter().enumerate() {
            let mut row = Row::new(&self.name, format!("step {}, {act:?}", number + 1));
            let load = match act {
                StepAction::Force(parts) => along(*parts, axis, |part| {
                    TangentialControl::Force(part * friction_capacity)
                }),
                StepAction::Shift(parts) => {
                    along(*parts, axis, |part| TangentialControl::Shift(part * reach))
                }
                StepAction::Press(part) => {
                    LoadStep::hold().normal(NormalLoad::Force(part * self.force))
                }
                StepAction::Hold => LoadStep::hold(),
            };
            let before = Before {
                slip: history.slip().map(|slip| slip.as_slice().to_vec()),
                shift: history.shift(),
            };
            let now = limits(&self.friction, history.normal()).iter().sum::<f64>();
            let expected = match act {
                StepAction::Force(parts) => {
                    let asked = parts[0].hypot(parts[1]) * friction_capacity;
                    let limit = now * history.grid().cell_area();
                    if asked > 0.0 && history.normal().contact_cells() == 0 {
                        Expected::Refused("EmptyContact")
                    } else if asked > (1.0 + 1e-12) * limit {
                        Expected::Refused("BeyondFrictionCapacity")
                    } else if asked > (1.0 - 1e-7) * limit && axis.is_none() {
                        Expected::AnswerOrRoundOff
                    } else {
                        Expected::Answer
                    }
                }
                _ => Expected::Answer,
            };
            match history.step(&load).map(|_| ()) {
                Ok(()) => {
                    if let Some(report) = history.last_step().unwrap().tangential_report() {
                        row.end(&Ok(()), report, expected);
                    }
                    check(&mut row, self, &history, &compliance, &before, act);
                }
                Err(Error::NotConverged(report)) => {
                    let outcome = Err(Error::NotConverged(report.clone()));
                    row.end(&outcome, &report, expected);
                }
                Err(error) => row.refuse(&error, expected),
            }
            rows.push(row);
        }
        Ok(rows)
    }
}

/// Returns a step along the axis of the model, or along both axes.
fn along(
    parts: [f64; 2],
    axis: Option<usize>,
    step: impl Fn(f64) -> TangentialControl,
) -> LoadStep {
    let load = LoadStep::hold().tangential(Axis::X, step(parts[0]));
    match axis {
        Some(_) => load,
        None => load.tangential(Axis::Y, step(parts[1])),
    }
}

fn largest(values: &[f64]) -> f64 {
    values.iter().fold(0.0_f64, |a, u| a.max(u.abs()))
}

/// Checks the history after a step.
fn check(
    row: &mut Row,
    story: &LoadHistory,
    history: &History,
    compliance: &Compliance,
    before: &Before,
    act: &StepAction,
) {
    let step = history.last_step().unwrap();
    let limits = limits(&story.friction, history.normal());
    let cells = limits.len();
    let [x, y] = history.traction().map(Field::as_slice);
    let excess = |i: usize| x[i].hypot(y[i]) - limits[i] * (1.0 + 1e-14);
    let is_beyond = (0..cells).any(|i| excess(i) > 0.0 || excess(i).is_nan());
    row.blame(is_beyond, || "a traction is beyond its limit".to_owned());

    let energy = step.energy();
    let size = energy.work.abs() + energy.elastic_before + energy.elastic_after;
    // On a periodic grid a uniform traction has no energy except for round-off.
    let squares: f64 = limits.iter().map(|limit| limit * limit).sum();
    // An imbalance is also due to round-off if it is small compared with the work of the whole force over the whole
    // shift.
    let shift = largest(&before.shift).max(largest(&history.shift()));
    let travel = history.accumulated_slip().max().max(shift);
    let sum: f64 = limits.iter().sum();
    let noise = 1e-13 * (compliance.lower_bound * squares + sum * travel);
    let noise = noise * history.grid().cell_area();
    row.blame(energy.imbalance().abs() > 1e-9 * size + noise, || {
        format!(
            "the energy balance misses {:e} of {size:e}",
            energy.imbalance()
        )
    });
    let Some(report) = step.tangential_report() else {
        return;
    };
    // A cell that came into contact has its own offset, which this check does not include.
    if matches!(act, StepAction::Press(_))
        || story
            .acts
            .iter()
            .any(|act| matches!(act, StepAction::Press(_)))
    {
        return;
    }
    let q = match history.axis() {
        Some(axis) => [x, y][axis.index()].to_vec(),
        None => [x, y].concat(),
    };
    let product = compliance.product(&q);
    let answer = Answer {
        compliance,
        x: &q,
        product: &product,
        report,
        tolerance: story.settings.tolerance,
        movable: &|i| limits[i] > 0.0,
        has_sums: false,
    };
    let is_all_turned = history.axis().is_none() && step.is_gross_slip();
    let mut violated = 0.0_f64;
    for i in (0..cells).filter(|&i| limits[i] > 0.0) {
        let traction = [x[i], y[i]];
        let slip = [0, 1].map(|b| match (history.axis(), b) {
            (Some(axis), b) if axis.index() != b => 0.0,
            (Some(_), b) => product[i] - before.slip[b][i] - history.shift()[b],
            (None, b) => product[b * cells + i] - before.slip[b][i] - history.shift()[b],
        });
        let size = traction[0].hypot(traction[1]);
        let forbidden = if size >= limits[i] * (1.0 - RIM) {
            let n = traction.map(|q| q / size);
            let against = (-(slip[0] * n[0] + slip[1] * n[1])).max(0.0);
            (slip[0] + against * n[0]).hypot(slip[1] + against * n[1])
        } else {
            slip[0].hypot(slip[1])
        };
        violated = violated.max(forbidden);
    }
    let moved = history.accumulated_slip().max();
    let shifted = largest(&before.shift).max(largest(&history.shift()));
    if !is_all_turned {
        answer.check_residual(row, violated, moved.max(shifted));
    }
    let along = history.axis();
    let truth = along.and_then(|axis| exact(story, history, before, &limits, axis, act));
    if truth.is_some() {
        answer.check_error(row, truth);
    }
}

/// Returns the reference tractions after a step along one axis, computed from the slip before the step.
fn exact(
    story: &LoadHistory,
    history: &History,
    before: &Before,
    limits: &[f64],
    axis: Axis,
    act: &StepAction,
) -> Option<ReferenceSolution> {
    let contact: Vec<usize> = (0..limits.len()).filter(|&i| limits[i] > 0.0).collect();
    let is_periodic = story.bodies.boundary() == Boundary::Periodic;
    if contact.len() > DENSE_LIMIT || limits.len() > 2048 {
        return None;
    }
    let upper: Vec<f64> = contact.iter().map(|&i| limits[i]).collect();
    let lower: Vec<f64> = upper.iter().map(|limit| -limit).collect();
    let by_force = matches!(act, StepAction::Force(_)) || is_periodic;
    let (shift, total) = if by_force {
        let sum: f64 = history.traction()[axis.index()].as_slice().iter().sum();
        (before.shift[axis.index()], Some(sum))
    } else {
        (history.shift()[axis.index()], None)
    };
    let remembered = &before.slip[axis.index()];
    let linear: Vec<f64> = contact.iter().map(|&i| -remembered[i] - shift).collect();
    let component = [Component::XX, Component::YY][axis.index()];
    let bounds = Bounds {
        lower: &lower,
        upper: &upper,
    };
    let minimum = matrix(&story.bodies, component, &contact)
        .and_then(|matrix| matrix.minimise(&linear, &bounds, total))
        .ok()?;
    let mut x = vec![0.0; limits.len()];
    for (&i, value) in contact.iter().zip(minimum.x) {
        x[i] = value;
    }
    // The accumulated slip may be much larger than any displacement in this step.
    let compliance = Compliance::shear(&story.bodies, Some(axis.index())).ok()?;
    let travel = history.accumulated_slip().max().max(largest(&linear));
    let noise = 16.0 * f64::EPSILON * travel * (linear.len() as f64).sqrt();
    let size = compliance.norm(&x);
    let error = noise / (compliance.lower_bound.sqrt() * size);
    (error < 1e-2).then_some(ReferenceSolution {
        x,
        error,
        against: "dense twin",
    })
}

/// Runs histories that move back and forth, and up to sliding and back. Some of the states erase the memory of the
/// contact, and others preserve it.
pub(crate) fn rows() -> Result<Vec<Row>> {
    let to_and_fro = [0.7, -0.7, 0.999999, 0.0, -1.0, 1.0 + 1e-9, 1e-12, 0.5];
    let mut rows = Vec::new();
    for (name, bodies, gap, part) in scenes()? {
        for lateral in [TangentialModel::Scalar, TangentialModel::Vector] {
            let mut acts: Vec<StepAction> = to_and_fro
                .iter()
                .map(|&part| match lateral {
                    TangentialModel::Vector => StepAction::Force([0.8 * part, -0.6 * part]),
                    _ => StepAction::Force([part, 0.0]),
                })
                .collect();
            acts.extend([
                StepAction::Shift([0.0, 0.0]),
                StepAction::Hold,
                StepAction::Shift([2.0, 0.3]),
            ]);
            let model = match lateral {
                TangentialModel::Vector => "plane",
                _ => "shear",
            };
            let story = LoadHistory {
                name: format!("{name}, {model}"),
                bodies: bodies.clone(),
                gap: gap.clone(),
                friction: Friction::coulomb(0.5)?,
                lateral,
                settings: Settings::default(),
                force: part * bodies.pair().contact_modulus() * bodies.grid().area(),
                acts,
            };
            rows.extend(story.rows());
        }
    }
    Ok(rows)
}

/// Returns the name, bodies, gap and mean pressure relative to the contact modulus.
fn scenes() -> Result<Vec<(&'static str, HalfSpace, Field, f64)>> {
    let body = Material::new(2.0, 0.3)?;
    let pair = ElasticPair::new(body, body)?;
    let grid = Grid::square(12, 12.0)?;
    let [free, periodic] = [Boundary::NonPeriodic, Boundary::Periodic]
        .map(|boundary| HalfSpace::with_boundary(grid, pair, boundary));
    let (free, periodic) = (free?, periodic?);
    let noise = gaps::white_noise(grid, 5.0, &mut Random(8));
    Ok(vec![
        (
            "history, five cells",
            free.clone(),
            gaps::nails(grid, 0.5, &[[1, 1], [1, 2], [5, 5], [9, 2], [11, 11]]),
            1e-5,
        ),
        ("history, white noise", free, noise, 0.3),
        (
            "history, wave, periodic",
            periodic,
            gaps::waves(grid, [0.1, 0.1]),
            0.02,
        ),
    ])
}

/// Returns the random load history of an index.
pub(crate) fn story(index: u64) -> Result<LoadHistory> {
    let scene = draw::scene(index)?;
    let mut random = draw::random_of(index ^ 0x5eed);
    let grid = scene.gap.grid();
    let force = match scene.load {
        NormalLoad::Force(force) => force,
        _ => 1e-2 * scene.bodies.pair().contact_modulus() * grid.area(),
    };
    let is_in_plane = random.chance(0.4);
    let with_presses = random.chance(0.3);
    let acts = (0..random.integer(2, 7)).map(|_| {
        let size = random.pick(&[0.0, 1e-9, 0.3, 0.6, 0.9, 0.99, 0.9999, 1.0, 1.1]);
        let size = size * random.pick(&[-1.0, 1.0]);
        let angle = random.uniform(0.0, std::f64::consts::TAU);
        let parts = if is_in_plane {
            [size * angle.cos(), size * angle.sin()]
        } else {
            [size, 0.0]
        };
        match random.integer(0, 9) {
            0..=2 => StepAction::Shift(parts),
            3 => StepAction::Hold,
            4..=5 if with_presses => StepAction::Press(random.decade(-1.0, 1.0)),
            _ => StepAction::Force(parts),
        }
    });
    let acts = acts.collect();
    Ok(LoadHistory {
        name: format!("story {index}"),
        friction: draw::friction(grid, &mut random)?,
        lateral: if is_in_plane {
            TangentialModel::Vector
        } else {
            TangentialModel::Scalar
        },
        settings: scene
            .settings
            .tolerance(scene.settings.tolerance.clamp(1e-10, 1e-2)),
        bodies: scene.bodies,
        gap: scene.gap,
        force,
        acts,
    })
}
