//! Several processes, or threads, that solve one contact together.
//!
//! A *rank* is one of them. Every rank runs the same program on its own part of the cells, and meets the others in
//! [`Ranks::swap`] alone: all ranks make the same calls in the same order. Nothing else of this crate communicates.

#[cfg(feature = "mpi")]
mod mpi;
mod team;
mod threads;
mod words;

use std::fmt::Debug;

pub use crate::error::RankFailure;
#[cfg(feature = "mpi")]
pub use mpi::Mpi;
pub(crate) use team::Team;
pub use team::Traffic;
pub use threads::Threads;
pub(crate) use words::Words;

/// How one rank reaches the others.
///
/// What travels is blocks of 64-bit words. An implementation keeps the order of the blocks between any two ranks. When
/// a rank leaves, the calls of the others return a [`RankFailure`]: they do not wait without end.
pub trait Ranks: Debug + Send + Sync {
    /// The number of this rank, from zero.
    fn rank(&self) -> usize;

    /// How many ranks there are.
    fn size(&self) -> usize;

    /// Sends a block to the rank `to` and receives one from the rank `from`, which calls at the same time. Neither is
    /// this rank itself. The block received may be of any length.
    ///
    /// # Errors
    /// [`RankFailure::Lost`], [`RankFailure::Silent`].
    fn swap(&self, block: Vec<u64>, to: usize, from: usize) -> Result<Vec<u64>, RankFailure>;
}
