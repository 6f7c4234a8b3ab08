//! Failures of ranks that solve together.

/// Reason why ranks that solve together cannot continue.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum RankFailure {
    /// The quantity is not available on ranks; bodies that are not [distributed](crate::HalfSpace::distributed) support
    /// it.
    #[error("{0} cannot be shared by ranks")]
    UnsupportedOnRanks(&'static str),
    /// A rank has ended or cannot be reached.
    #[error("rank {rank} has left the others")]
    Disconnected {
        /// Number of the rank.
        rank: usize,
    },
    /// A rank did not respond within the time limit.
    #[error("rank {rank} has been silent for {seconds} s")]
    Timeout {
        /// Number of the rank.
        rank: usize,
        /// Waiting time (s).
        seconds: f64,
    },
    /// The slabs to be assembled do not contain all rows.
    #[error("no slab has row {row}")]
    MissingSlab {
        /// First missing row, counted from the bottom of the grid.
        row: usize,
    },
    /// The slabs to be assembled do not belong to the same state: they belong to different steps or to different
    /// histories.
    #[error("the slab that begins with row {row} is of another state than the others")]
    InconsistentSlabs {
        /// First row of the slab, counted from the bottom of the grid.
        row: usize,
    },
    /// MPI was initialised before; a process can initialise it only once.
    #[error("MPI was initialised before in this process")]
    MpiAlreadyInitialised,
    /// The MPI library can be called only by the thread that initialised it: it provides less than
    /// `MPI_THREAD_SERIALIZED`.
    #[error(
        "this MPI library can be called by one thread only (it grants less than MPI_THREAD_SERIALIZED)"
    )]
    InsufficientThreadLevel,
    /// A launcher has started several processes, but MPI reports a single process to each of them. This happens if the
    /// launcher belongs to a different MPI library. Each process would do all of the work and write the same files.
    #[error(
        "{processes} processes were started ({variable}), but MPI knows of one only: start them with the launcher of the MPI that the program was built with"
    )]
    SeparateMpiJobs {
        /// Environment variable that contains the number of processes.
        variable: &'static str,
        /// Number of processes.
        processes: usize,
    },
    /// The ranks make different collective calls.
    #[error("rank {rank} makes other calls than this one")]
    CollectiveMismatch {
        /// Number of a rank whose block of data has an unexpected length.
        rank: usize,
    },
    /// The named value, which must be the same on all ranks, differs between ranks. All ranks return this error.
    #[error("the ranks do not have the same {0}")]
    InconsistentInput(&'static str),
    /// A rank has rejected its part of the work; the error of that rank states the reason.
    #[error("rank {rank} has refused its part of the work")]
    RejectedByRank {
        /// Number of the rank.
        rank: usize,
    },
}
