//! Runs the shared test cases on ranks that are MPI processes. The local results are bitwise identical to the results
//! of a single process.
//!
//! Run with `mpirun`. Every rank solves each case together with the other ranks and on its own. With `--stop-the-last`
//! the last rank is stopped instead. The other ranks must report the loss and end. With `--lose-the-last` the last rank
//! leaves while the other ranks have large blocks to send to each other. They must also report the loss.

#![allow(
    clippy::unwrap_used,
    clippy::float_cmp,
    clippy::print_stdout,
    clippy::wildcard_imports,
    dead_code,
    unused_imports,
    reason = "a test fails loudly and prints its results; the shared modules also contain tests that only threads run"
)]

mod history_continuation_is_bitwise;
mod rank_contacts;
mod scene_laws;

use std::process::{Command, ExitCode};
use std::sync::Arc;
use std::time::Duration;

use kit::table::{Scene, UnitTransform};
use stickslip::ranks::{Mpi, Ranks};
use stickslip::{Field, HalfSpace};

use history_continuation_is_bitwise::{found, shared_scenes};

/// Timeout that is longer than a rank needs to solve a case on its own.
const PATIENCE: Duration = Duration::from_secs(300);

/// Timeout after which the other ranks report a stopped rank, during a call and again after the call.
const BRIEFLY: Duration = Duration::from_secs(10);

fn main() -> ExitCode {
    if std::env::args().any(|word| word == "--stop-the-last") {
        return stop_the_last();
    }
    if std::env::args().any(|word| word == "--lose-the-last") {
        return lose_the_last();
    }
    let failed = Mpi::run(PATIENCE, |rank| {
        let ranks: Arc<dyn Ranks> = Arc::new(rank);
        let scenes = shared_scenes();
        let failures = scenes.iter().map(|scene| compare(scene, &ranks)).collect();
        (scenes.len(), failures)
    });
    let (scenes, failures): (usize, Vec<Option<String>>) = failed.unwrap();
    let failures: Vec<String> = failures.into_iter().flatten().collect();
    for failure in &failures {
        println!("{failure}");
    }
    println!(
        "{} of {scenes} scenes are bitwise identical to one process",
        scenes - failures.len()
    );
    if failures.is_empty() && scenes > 0 {
        ExitCode::SUCCESS
    } else {
        ExitCode::FAILURE
    }
}

/// Stops the last process, as a debugger or a machine without free memory does. All other ranks print their outcome.
fn stop_the_last() -> ExitCode {
    let ended = Mpi::run(BRIEFLY, |rank| {
        let (number, is_last) = (rank.rank(), rank.rank() + 1 == rank.size());
        let scene = shared_scenes().swap_remove(0);
        let bodies = scene.half_space_on(Arc::new(rank)).unwrap();
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

/// Makes the last process leave while the other ranks send blocks of 1 MB to all ranks.
fn lose_the_last() -> ExitCode {
    Mpi::run(PATIENCE, |rank| {
        let (number, size) = (rank.rank(), rank.size());
        if number + 1 < size {
            let blocks = vec![vec![7; 1 << 17]; size];
            let outcome = rank.all_to_all(blocks, &vec![true; size]).map(drop);
            println!("rank {number} ends with {outcome:?}");
        }
    })
    .unwrap();
    ExitCode::SUCCESS
}

/// Describes the difference between the slab of this rank and its own result, or returns `None` if they are identical.
fn compare(scene: &Scene, ranks: &Arc<dyn Ranks>) -> Option<String> {
    let bodies = scene.half_space_on(Arc::clone(ranks)).unwrap();
    let run = |bodies: &HalfSpace| {
        let mut history = scene.history(bodies, &UnitTransform::IN_PLACE);
        scene.run(&mut history, &UnitTransform::IN_PLACE);
        found(&history)
    };
    let (own, alone) = (
        run(&bodies),
        run(&scene.half_space(&UnitTransform::IN_PLACE)),
    );
    let slab = bodies.grid();
    let first = slab.rows().start * slab.nx();
    let cells = &alone.1[first..first + own.1.len()];
    let is_same = own.0 == alone.0 && own.1 == cells;
    let number = ranks.rank();
    (!is_same).then(|| format!("rank {number}: {} differs", scene.name))
}
