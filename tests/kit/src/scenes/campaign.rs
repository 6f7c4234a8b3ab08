//! Random scenes, solved by index.

use stickslip::cgm::Method;
use stickslip::influence::Direction::{X, Y, Z};
use stickslip::{Error, Operator};

use super::judge::Verifier;
use super::row::Row;
use super::{RandomScene, draw, steps};

/// Number of cells up to which a scene is compared with the dense reference and solved by both methods.
const SMALL: usize = 150;
/// Period of the indices that are histories.
const HISTORIES: u64 = 8;

/// Returns the rows of an index.
pub fn rows(index: u64) -> Vec<Row> {
    let outcome = if index % HISTORIES == HISTORIES - 1 {
        steps::story(index).map(|story| story.rows())
    } else {
        draw::scene(index).map(|scene| contacts(&scene))
    };
    settled(index, outcome)
}

/// Returns the rows of the contacts with coated bodies for an index. If no error can be certified, returns a single
/// row with the reason.
pub fn coated_rows(index: u64) -> Vec<Row> {
    let outcome = draw::coated_scene(index).and_then(|scene| {
        let plane = scene.bodies.tensor_preconditioner([X, Y]).map(|_| ());
        let bound = scene.bodies.tensor_preconditioner([Z]).and(plane);
        let pressure = scene.bodies.tensor_operator([Z])?.lower_bound();
        let traction = scene.bodies.tensor_operator([X, Y])?.lower_bound();
        match bound {
            // If the datum is too close, the operator is not definite and has no energy norm. Tests of lines of coated
            // bodies compare other quantities.
            Ok(()) if pressure.min(traction) <= 0.0 && scene.gap.grid().cells() > 1 => {
                let mut row = Row::new(&scene.name, "all");
                "refused: datum too near".clone_into(&mut row.ending);
                Ok(vec![row])
            }
            Err(error @ (Error::NotDefinite { .. } | Error::CellsTooLong { .. })) => {
                let mut row = Row::new(&scene.name, "all");
                row.ending = format!("refused: {}", kind_of(&error));
                Ok(vec![row])
            }
            bound => bound.map(|()| contacts(&scene)),
        }
    });
    settled(index, outcome)
}

fn kind_of(error: &Error) -> &'static str {
    match error {
        Error::CellsTooLong { .. } => "cells too long",
        _ => "not definite",
    }
}

fn settled(index: u64, outcome: stickslip::Result<Vec<Row>>) -> Vec<Row> {
    outcome.unwrap_or_else(|error| {
        let mut row = Row::new(&format!("scene {index}"), "all");
        row.fault = Some(error.to_string());
        vec![row]
    })
}

fn contacts(scene: &RandomScene) -> Vec<Row> {
    let judge = Verifier { dense_limit: SMALL };
    let mut rows = judge.rows(scene, Method::ActiveSet);
    if scene.gap.grid().cells() <= SMALL {
        rows.extend(judge.rows(scene, Method::PolonskyKeer));
    }
    rows
}
