//! Texts of all rank failures.

use crate::error::RankFailure;
use crate::error::tests::{Variants, check_texts, variants};

variants! { RankFailure:
    UnsupportedOnRanks Disconnected Timeout MissingSlab InconsistentSlabs MpiAlreadyInitialised InsufficientThreadLevel
    SeparateMpiJobs CollectiveMismatch InconsistentInput RejectedByRank
}

#[test]
fn every_rank_failure_has_its_text() {
    check_texts(&[
        (
            RankFailure::UnsupportedOnRanks("steady rolling"),
            "steady rolling is not available on a grid that is distributed over ranks: use bodies that are not distributed",
        ),
        (
            RankFailure::Disconnected { rank: 2 },
            "rank 2 has ended or cannot be reached: check the error of that rank",
        ),
        (
            RankFailure::Timeout {
                rank: 2,
                seconds: 60.0,
            },
            "rank 2 did not respond within 60 s: check that rank, or raise the time limit",
        ),
        (
            RankFailure::MissingSlab { row: 3 },
            "no slab contains row 3: give the slabs of all ranks",
        ),
        (
            RankFailure::InconsistentSlabs { row: 8 },
            "the slab that starts at row 8 belongs to a different state than the other slabs: give slabs of the same step of one history",
        ),
        (
            RankFailure::MpiAlreadyInitialised,
            "MPI was already initialised in this process, which is possible only once: do all work with MPI ranks in one call",
        ),
        (
            RankFailure::InsufficientThreadLevel,
            "the MPI library allows calls from one thread only: use a library that provides at least MPI_THREAD_SERIALIZED",
        ),
        (
            RankFailure::SeparateMpiJobs {
                variable: "OMPI_COMM_WORLD_SIZE",
                processes: 4,
            },
            "4 processes were started (OMPI_COMM_WORLD_SIZE), but MPI reports a single process to each of them: start them with the launcher of the MPI library with which the program was built",
        ),
        (
            RankFailure::CollectiveMismatch { rank: 1 },
            "rank 1 makes different collective calls than this rank: make the same calls in the same order on all ranks",
        ),
        (
            RankFailure::InconsistentInput("normal load"),
            "the normal load must be the same on all ranks: compute it on one rank, or from equal input",
        ),
        (
            RankFailure::RejectedByRank { rank: 1 },
            "rank 1 rejected its part of the work: check the error of that rank",
        ),
    ]);
}
