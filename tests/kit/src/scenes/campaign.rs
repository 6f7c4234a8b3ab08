//! What the index of a random scene stands for, solved.

use stickslip::cgm::Method;

use super::judge::Judge;
use super::row::Row;
use super::{draw, steps};

/// Cells up to which a scene is compared with the dense twin, and solved by both methods.
const SMALL: usize = 150;
/// One index in so many is a history.
const HISTORIES: u64 = 8;

/// The rows of an index.
pub fn rows(index: u64) -> Vec<Row> {
    let outcome = if index % HISTORIES == HISTORIES - 1 {
        steps::story(index).map(|story| story.rows())
    } else {
        contacts(index)
    };
    outcome.unwrap_or_else(|error| {
        let mut row = Row::new(&format!("scene {index}"), "all");
        row.fault = Some(error.to_string());
        vec![row]
    })
}

fn contacts(index: u64) -> stickslip::Result<Vec<Row>> {
    let judge = Judge { dense_limit: SMALL };
    let scene = draw::scene(index)?;
    let mut rows = judge.rows(&scene, Method::ActiveSet);
    if scene.gap.grid().cells() <= SMALL {
        rows.extend(judge.rows(&scene, Method::PolonskyKeer));
    }
    Ok(rows)
}
