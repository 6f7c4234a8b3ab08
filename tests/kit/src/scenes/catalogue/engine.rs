//! Direct calls of the engine, with starts and operators that no contact has.

use std::ops::ControlFlow;

use stickslip::cgm::{self, Method, NonNegative, Problem, Settings};
use stickslip::influence::Component;
use stickslip::{Error, NormalLoad, Operator, Result, Scratch};

use super::super::compliance::Compliance;
use super::super::oracle::matrix;
use super::super::row::Row;
use super::super::{Expected, gaps};
use super::{free, press};
use crate::Random;

/// Runs the engine from every kind of start.
pub(crate) fn starts() -> Result<Vec<Row>> {
    let bodies = free(20, 20)?;
    let gap = gaps::bowl(bodies.grid(), 40.0);
    let NormalLoad::Force(force) = press(&bodies, 0.01) else {
        return Ok(Vec::new());
    };
    let cells = bodies.grid().cells();
    let total = force / bodies.grid().cell_area();
    let exact = matrix(&bodies, Component::ZZ, &(0..cells).collect::<Vec<_>>())?.minimise(
        gap.as_slice(),
        &NonNegative,
        Some(total),
    )?;
    let mut random = Random(9);
    let garbage: Vec<f64> = (0..cells)
        .map(|_| random.decade(-20.0, 20.0) * random.uniform(-1.0, 1.0))
        .collect();
    let mut one_cell = vec![0.0; cells];
    one_cell[7] = 1e30;
    let mut rows = Vec::new();
    for (name, start, expected) in [
        ("garbage", garbage, Expected::Answer),
        ("one far cell", one_cell, Expected::Answer),
        ("NaN", vec![f64::NAN; cells], Expected::Refused("Sample")),
        (
            "infinity",
            vec![f64::INFINITY; cells],
            Expected::Refused("Sample"),
        ),
    ] {
        let mut row = Row::new(&format!("start from {name}"), "pressure");
        let mut x = start;
        let problem = Problem::new(
            bodies.operator(Component::ZZ)?,
            [gap.as_slice()],
            NonNegative,
        );
        let problem = problem.total(total);
        let mut workspace = problem.workspace().unwrap();
        let outcome = cgm::minimise_with(
            &problem,
            &Settings::default(),
            [&mut x],
            &mut workspace,
            &mut |_| ControlFlow::Continue(()),
        );
        if row.end(&outcome, workspace.report(), expected) {
            let compliance = Compliance::pressure(&bodies)?;
            row.compare(&compliance, &x, &exact.x, "dense twin");
        }
        rows.push(row);
    }
    Ok(rows)
}

/// Runs the engine with operators that return NaN or are negative definite. The solves must not converge.
pub(crate) fn broken_operators() -> Vec<Row> {
    let mut rows = Vec::new();
    for (name, sign) in [("NaN", f64::NAN), ("a negative definite map", -1.0)] {
        for method in [Method::ActiveSet, Method::PolonskyKeer] {
            let linear: Vec<f64> = (0..20).map(|i| f64::from(i) / 20.0).collect();
            let problem = Problem::new(Diagonal(sign), [&linear], NonNegative).total(1.0);
            let mut row = Row::new(&format!("operator that is {name}"), format!("{method:?}"));
            let mut x = vec![0.05_f64; 20];
            let outcome = cgm::minimise(&problem, &Settings::default().method(method), [&mut x]);
            if let Err(Error::NotConverged(report)) = &outcome {
                row.ending = report.status.to_string();
                row.report = Some((**report).clone());
            }
            row.blame(row.report.is_none(), || format!("{outcome:?}"));
            let is_feasible = x.iter().all(|x| *x >= 0.0 && x.is_finite());
            row.blame(!is_feasible, || "the iterate is not feasible".to_owned());
            rows.push(row);
        }
    }
    rows
}

/// Operator that multiplies every entry by this number.
struct Diagonal(f64);

impl Operator for Diagonal {
    fn cells(&self) -> usize {
        20
    }

    fn apply(&self, [x]: [&[f64]; 1], [out]: [&mut [f64]; 1], _: &mut Scratch) {
        for (out, x) in out.iter_mut().zip(x) {
            *out = self.0 * x;
        }
    }
}
