//! How ranks fail each other.

/// Why ranks that solve together cannot go on.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum RankFailure {
    /// Ranks cannot share this; bodies that are not [distributed](crate::HalfSpace::distributed) have it.
    #[error("{0} cannot be shared by ranks")]
    UnsupportedOnRanks(&'static str),
    /// A rank has ended, or cannot be reached.
    #[error("rank {rank} has left the others")]
    Disconnected {
        /// Its number.
        rank: usize,
    },
    /// A rank did not answer for so long.
    #[error("rank {rank} has been silent for {seconds} s")]
    Timeout {
        /// Its number.
        rank: usize,
        /// The time that was waited (s).
        seconds: f64,
    },
    /// Slabs that are put together leave out a row.
    #[error("no slab has row {row}")]
    MissingSlab {
        /// The first one that is missing, from the bottom of the grid.
        row: usize,
    },
    /// Slabs that are put together are not of one state: of other steps, or of another history.
    #[error("the slab that begins with row {row} is of another state than the others")]
    InconsistentSlabs {
        /// Its first row, from the bottom of the grid.
        row: usize,
    },
    /// MPI was initialised before: it can be once in a process.
    #[error("MPI was initialised before in this process")]
    MpiAlreadyInitialised,
    /// The MPI library serves the thread alone that has initialised it: it grants less than `MPI_THREAD_SERIALIZED`.
    #[error(
        "this MPI library can be called by one thread only (it grants less than MPI_THREAD_SERIALIZED)"
    )]
    InsufficientThreadLevel,
    /// A launcher has started several processes of which MPI knows one only, as that of another MPI does: each would do all
    /// of the work, and write the same files.
    #[error(
        "{processes} processes were started ({variable}), but MPI knows of one only: start them with the launcher of the MPI that the program was built with"
    )]
    SeparateMpiJobs {
        /// The environment variable that tells of them.
        variable: &'static str,
        /// Their number.
        processes: usize,
    },
    /// Ranks make different calls.
    #[error("rank {rank} makes other calls than this one")]
    CollectiveMismatch {
        /// One whose block was of another length than expected.
        rank: usize,
    },
    /// Ranks come with different values of what must be the same on all, which is named: all ranks refuse it.
    #[error("the ranks do not have the same {0}")]
    InconsistentInput(&'static str),
    /// A rank has refused its part of the work; its own error says why.
    #[error("rank {rank} has refused its part of the work")]
    RejectedByRank {
        /// Its number.
        rank: usize,
    },
}
