//! Failures of ranks that solve together.

#[cfg(test)]
mod tests;

/// Reason why ranks that solve together cannot continue.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum RankFailure {
    /// The quantity is not available on ranks. Bodies that are not [distributed](crate::HalfSpace::distributed) support
    /// it.
    #[error(
        "{0} is not available on a grid that is distributed over ranks: use bodies that are not distributed"
    )]
    UnsupportedOnRanks(&'static str),
    /// A rank has ended or cannot be reached.
    #[error("rank {rank} has ended or cannot be reached: check the error of that rank")]
    Disconnected {
        /// Number of the rank.
        rank: usize,
    },
    /// A rank did not respond within the time limit.
    #[error(
        "rank {rank} did not respond within {seconds} s: check that rank, or raise the time limit"
    )]
    Timeout {
        /// Number of the rank.
        rank: usize,
        /// Waiting time (s).
        seconds: f64,
    },
    /// The slabs to be assembled do not contain all rows.
    #[error("no slab contains row {row}: give the slabs of all ranks")]
    MissingSlab {
        /// First missing row, counted from the bottom of the grid.
        row: usize,
    },
    /// The slabs to be assembled belong to different steps or to different histories.
    #[error(
        "the slab that starts at row {row} belongs to a different state than the other slabs: give slabs of the same step of one history"
    )]
    InconsistentSlabs {
        /// First row of the slab, counted from the bottom of the grid.
        row: usize,
    },
    /// MPI was initialised before. A process can initialise MPI only once.
    #[error(
        "MPI was already initialised in this process, which is possible only once: do all work with MPI ranks in one call"
    )]
    MpiAlreadyInitialised,
    /// Only the thread that initialised the MPI library can call it, because the library provides less than
    /// `MPI_THREAD_SERIALIZED`.
    #[error(
        "the MPI library allows calls from one thread only: use a library that provides at least MPI_THREAD_SERIALIZED"
    )]
    InsufficientThreadLevel,
    /// A launcher has started several processes, but MPI reports a single process to each of them. This happens if the
    /// launcher belongs to a different MPI library. Each process would do all of the work and write the same files.
    #[error(
        "{processes} processes were started ({variable}), but MPI reports a single process to each of them: start them with the launcher of the MPI library with which the program was built"
    )]
    SeparateMpiJobs {
        /// Environment variable that contains the number of processes.
        variable: &'static str,
        /// Number of processes.
        processes: usize,
    },
    /// The ranks make different collective calls.
    #[error(
        "rank {rank} makes different collective calls than this rank: make the same calls in the same order on all ranks"
    )]
    CollectiveMismatch {
        /// Number of a rank whose block of data has an unexpected length.
        rank: usize,
    },
    /// The named value, which must be the same on all ranks, differs between ranks. All ranks return this error.
    #[error("the {0} must be the same on all ranks: compute it on one rank, or from equal input")]
    InconsistentInput(&'static str),
    /// A rank has rejected its part of the work. The error of this rank states the reason.
    #[error("rank {rank} rejected its part of the work: check the error of that rank")]
    RejectedByRank {
        /// Number of the rank.
        rank: usize,
    },
}
