//! The scenes that ranks share, on ranks that are processes of MPI: each holds the bits that one process finds.
//!
//! Run by `mpirun`. Every rank solves each scene with the others, and by itself. With `--stop-the-last` the last rank is
//! stopped instead, and the others must say so and end.

#![allow(
    clippy::unwrap_used,
    clippy::float_cmp,
    clippy::print_stdout,
    clippy::wildcard_imports,
    dead_code,
    unused_imports,
    reason = "a test fails loudly and says what it has done; what threads alone are tested for lies beside the scenes"
)]

mod ranks_share_a_contact;
mod ranks_share_a_coupled_contact;
mod ranks_share_a_history;

use std::process::{Command, ExitCode};
use std::sync::Arc;
use std::time::Duration;

use stickslip::ranks::{Mpi, Ranks};
use stickslip::{Field, HalfSpace};

use ranks_share_a_contact::{Scene, pair, same};

/// Longer than a rank solves a scene by itself.
const PATIENCE: Duration = Duration::from_secs(300);

/// So long the others wait for one that is stopped, in a call and again after it.
const BRIEFLY: Duration = Duration::from_secs(10);

fn main() -> ExitCode {
    if std::env::args().any(|word| word == "--stop-the-last") {
        return stop_the_last();
    }
    let failed = Mpi::run(PATIENCE, |rank| {
        let ranks: Arc<dyn Ranks> = Arc::new(rank);
        let groups = [
            ranks_share_a_contact::normal_contacts(),
            ranks_share_a_contact::sheared_contacts(),
            ranks_share_a_contact::sequences(),
            ranks_share_a_history::worn_contacts(),
            ranks_share_a_history::cycles(),
            ranks_share_a_history::yielding_and_strained_contacts(),
            ranks_share_a_coupled_contact::contacts_from_rest(),
            ranks_share_a_coupled_contact::sequences(),
            ranks_share_a_coupled_contact::histories(),
        ];
        assert!(groups.iter().all(|scenes| !scenes.is_empty()));
        let scenes: Vec<Scene> = groups.into_iter().flatten().collect();
        let failures = scenes.iter().map(|scene| compare(scene, &ranks)).collect();
        (scenes.len(), failures)
    });
    let (scenes, failures): (usize, Vec<Option<String>>) = failed.unwrap();
    let failures: Vec<String> = failures.into_iter().flatten().collect();
    for failure in &failures {
        println!("{failure}");
    }
    println!(
        "{} of {scenes} scenes have the bits of one process",
        scenes - failures.len()
    );
    if failures.is_empty() {
        ExitCode::SUCCESS
    } else {
        ExitCode::FAILURE
    }
}

/// Stops the last process as a debugger or a machine without memory does. All others tell what they came to.
fn stop_the_last() -> ExitCode {
    let ended = Mpi::run(BRIEFLY, |rank| {
        let (number, is_last) = (rank.rank(), rank.rank() + 1 == rank.size());
        let scene = ranks_share_a_contact::normal_contacts().swap_remove(0);
        let (grid, boundary) = (scene.grid, scene.boundary);
        let bodies = HalfSpace::distributed(grid, pair(), boundary, Arc::new(rank)).unwrap();
        if is_last {
            let mut stop = Command::new("sh");
            stop.args(["-c", "kill -STOP $PPID"]).status().unwrap();
        }
        let outcome = bodies.max_of(&Field::zeros(bodies.grid()));
        println!("rank {number} ends with {outcome:?}");
    });
    println!("MPI ends with {ended:?}");
    ExitCode::SUCCESS
}

/// What differs between the slab of this rank and what it finds by itself, if anything does.
fn compare(scene: &Scene, ranks: &Arc<dyn Ranks>) -> Option<String> {
    let (own, alone) = (scene.on(Arc::clone(ranks)), scene.alone());
    let bodies = HalfSpace::distributed(scene.grid, pair(), scene.boundary, Arc::clone(ranks));
    let slab = bodies.unwrap().grid();
    let first = slab.rows().start * slab.nx();
    let cells = &alone.cells[first..first + own.cells.len()];
    let known = same(&own.known, &alone.known);
    let differs = known.and_then(|()| same(own.cells.as_flattened(), cells.as_flattened()));
    let number = ranks.rank();
    differs
        .err()
        .map(|error| format!("rank {number}: {}: {error}", scene.what))
}
