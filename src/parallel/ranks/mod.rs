//! Ranks: several processes or threads that solve one contact together.
//!
//! A *rank* is one of these processes or threads. Every rank runs the same program on its local cells. Ranks communicate only
//! through the exchanges of [`Ranks`], and all ranks make the same calls in the same order.
//!
//! [`HalfSpace::distributed`](crate::HalfSpace::distributed) distributes the rows of a grid. Each rank stores a *slab* of rows,
//! with the fields, problems and solutions on this slab. The builders are the same as without ranks. The following calls are
//! collective: every rank must make them.
//!
//! - Building and solving a problem, and changing a problem.
//! - Taking a step of a history, changing a history, and returning to a state.
//! - Displacements, energies, contact spots, statistics and files.
//! - Starting cycles, adding to cycles, and jumps over cycles
//!   ([`CycleJump::new`](crate::history::wear::CycleJump::new),
//!   [`max_stable_cycles`](crate::history::wear::max_stable_cycles)).
//!
//! Other results for the whole contact (force, area, stick ratio, report, ...) are stored on every rank and need no
//! communication. The fields of a solution cover only the slab.
//!
//! # Consistent inputs
//!
//! Ranks with different inputs would not solve any common problem. Inputs that are common to the whole contact are therefore
//! compared at the start of a call. The comparison takes one exchange, with one word for each input. These inputs are:
//!
//! - Grid, pair and boundary of the bodies, and parameters of a rough surface.
//! - Uniform loads, friction and hardness.
//! - Model, coupling and settings of a problem or a history, including later changes.
//! - Load of each step, and the state at which a history starts or to which it returns.
//!
//! If an input differs between ranks, all ranks return an error that names the input ([`RankFailure::InconsistentInput`]) and
//! remain unchanged. Fields cannot be compared, because each rank has different rows. A gap, or a coefficient per cell, must
//! therefore be computed from the same numbers on every rank.
//!
//! Normal, tangential and coupled problems and their histories can be distributed, for all boundaries. Hardness, friction that
//! varies between cells, relative displacements, wear and stiffnesses are supported. Stresses on planes below the surface
//! ([`Planes`](crate::subsurface::Planes)) are also supported, and each rank receives the stresses of its rows. The following
//! features return [`RankFailure::UnsupportedOnRanks`]:
//!
//! - Stresses at single points, because they are sums over the loaded cells of all ranks.
//! - Stresses under values at the centres of cells.
//! - Files of stresses.
//! - Dense matrices.
//!
//! Surfaces are generated ([`SelfAffine::generate_on`](crate::surface::SelfAffine::generate_on)), characterised
//! ([`HalfSpace::statistics`](crate::HalfSpace::statistics)) and levelled slab by slab. Fields are read from and written to files
//! of the whole grid ([`HalfSpace::write_npy`](crate::HalfSpace::write_npy),
//! [`HalfSpace::write_pvti`](crate::HalfSpace::write_pvti)).
//!
//! | type | ranks |
//! |---|---|
//! | [`Threads`] | threads of one process, for developing and testing distributed programs |
//! | `Mpi` (feature `mpi`) | processes of an MPI program |
//! | in Python, in C | a communicator of mpi4py, a function of the program ([guide](crate::guide::distributed)) |
//! | user-defined | any means of exchanging blocks: implement [`Ranks::swap`], and optionally faster collective exchanges |
//!
//! # Bitwise identical results
//!
//! For any number of ranks, results are bitwise identical to the results of one process. The transform of a row or a column is
//! the same call on the same numbers on any rank. Sums follow one tree of chunks of rows, and slabs end at chunk boundaries.
//! Every rank completes the tree from the nodes that other ranks own entirely. All ranks evaluate observer and clock, and the
//! first rank decides. Every rank solves coarse grids of nested starts with at most 65 536 cells on its own.
//!
//! # Histories
//!
//! The state of a history contains the rows of the slab. All ranks save it together in one file
//! ([`History::save`](crate::History::save)). The file replaces the earlier file when every rank has written its rows. Any number
//! of ranks can continue from the file with bitwise identical results ([`History::load`](crate::History::load)). They can also
//! continue from the [bytes](crate::History::to_bytes) of the slabs ([`State::from_slabs`](crate::history::State::from_slabs)).
//! A step sends the tractions and offsets in the window of the contact to the ranks that share the rows of the window. It then
//! sends the solution back. This communication amounts to about ten numbers per cell of the window and component. Gap, friction
//! and settings must be changed by all ranks in the same way. Energies and sums of cycles refer to the whole contact. Slip and
//! wear refer to the slab. An observer of a [`FrettingLoop`](crate::history::FrettingLoop) is called on all ranks, and the first
//! rank decides.
//!
//! # Communication volume
//!
//! A product on $`n \times n`$ cells redistributes the transforms from rows to columns and back. All ranks together send
//!
//! ```math
//! 32\,n^2 \Bigl(1 - \frac1P\Bigr) \text{ bytes}
//! ```
//!
//! on a non-periodic grid, and half of this volume on a periodic grid. Products in single precision send half as many bytes.
//! Bands of 16 rows without traction are not sent in the first direction. A rank sends one block in each direction to every other
//! rank in a single exchange ([`Ranks::all_to_all`]). All threads of the rank pack the blocks. Blocks of more than 4 MB are sent
//! in up to 16 rounds, so they take little memory compared with their source. The rows of a window of the contact are distributed
//! over all ranks again. An iteration reduces seven partial results, each in $`\lceil\log_2 P\rceil`$ messages of a few hundred
//! bytes. [`HalfSpace::traffic`](crate::HalfSpace::traffic) counts exchanges and reductions.
//!
//! Columns of the transform are distributed in groups of sixteen, because both precisions use the same distribution. On a
//! periodic grid of $`n \times n`$ cells, at most $`n/32`$ ranks have columns to transform. On a grid that is not periodic, the
//! limit is $`n/16`$. Rows are distributed in whole chunks of the sums (4096 cells or one row), and in pairs, because they are
//! transformed in pairs. On three ranks, 96 rows of 96 cells are split into 42, 42 and 12 rows. Shorter chunks would balance the
//! rows, but would change the last digits of every sum. Such small grids gain nothing from ranks. For $`8192 P`$ cells or more,
//! no rank has more than twice an even share of the rows. For $`81\,920\, P`$ cells or more, no rank has more than 1.1 times an
//! even share. Ranks without rows or columns only wait during the corresponding stage.
//!
//! A rank stores only counts of the whole contact. Each rank labels the spots of its slab and sends the labels of its last row to
//! the next rank. Each rank counts the spots that no other slab can touch. All ranks then gather the sums of the other spots.
//! [`NormalSolution::spots`](crate::NormalSolution::spots) and similar methods create a list of all spots, for which all ranks
//! gather the sums of all spots. These sums take 104 bytes for each spot, or for each fragment of a spot that the ends of the
//! slabs cut.
//!
//! # Failures
//!
//! If one rank rejects an input, all ranks return an error. This rank returns its own error, and the others return
//! [`RankFailure::RejectedByRank`]. All ranks also return an error if one rank cannot compute a kernel, because memory runs out
//! or the response of the kernel fails. If a rank ends or is silent for too long, the calls of the other ranks return
//! [`RankFailure::Disconnected`] or [`RankFailure::Timeout`]. All later calls on the same bodies return the same error. A block
//! of unexpected length shows that its sender makes different calls. The receiver then returns
//! [`RankFailure::CollectiveMismatch`]. After a failure, a file that the ranks were writing together is the old file, or the new
//! file if it was complete.

pub(crate) mod partition;

#[cfg(any(feature = "mpi", test))]
mod launcher;
#[cfg(feature = "mpi")]
mod mpi;
mod team;
mod threads;
mod wire_format;

use std::fmt::Debug;
use std::ops::Range;

pub use crate::error::RankFailure;
#[cfg(feature = "mpi")]
pub use mpi::Mpi;
pub use team::CommunicationStats;
pub(crate) use team::{Input, RankGroup};
pub use threads::Threads;
pub(crate) use wire_format::WireFormat;

/// Communication of one rank with the others.
///
/// Messages are blocks of 64-bit words. An implementation must keep the order of the blocks between any two ranks. When a rank
/// leaves, the calls of the other ranks must return a [`RankFailure`] instead of waiting forever.
///
/// Only [`Ranks::swap`] is required. The other exchanges use it unless an implementation provides a faster method.
pub trait Ranks: Debug + Send + Sync {
    /// Returns the number of this rank, counted from zero.
    fn rank(&self) -> usize;

    /// Returns the number of ranks.
    fn size(&self) -> usize;

    /// Sends a block to the rank `to` and receives a block from the rank `from`, which calls at the same time. Neither `to`
    /// nor `from` may be this rank itself. The received block may have any length.
    ///
    /// # Errors
    /// - [`RankFailure::Disconnected`] if the other rank has ended.
    /// - [`RankFailure::Timeout`] if the other rank does not answer in time.
    fn swap(&self, block: Vec<u64>, to: usize, from: usize) -> Result<Vec<u64>, RankFailure>;

    /// Sends `blocks[r]` to each rank `r` and returns the received blocks in the order of the ranks. All ranks call at the same
    /// time. If rank `r` sends any words to this rank, `is_expected[r]` must be true on this rank. An expected rank must send at
    /// least one word. Empty blocks need not be sent, and an empty block is returned for them. The block for this rank itself is
    /// dropped, and an empty block is returned instead.
    ///
    /// The default implementation swaps blocks with the other ranks in turn.
    ///
    /// # Errors
    /// The errors of [`Ranks::swap`].
    fn all_to_all(
        &self,
        blocks: Vec<Vec<u64>>,
        is_expected: &[bool],
    ) -> Result<Vec<Vec<u64>>, RankFailure> {
        let (own, size) = (self.rank(), self.size());
        debug_assert_eq!(blocks.len(), is_expected.len());
        let mut blocks = blocks;
        let mut received = vec![Vec::new(); size];
        for step in 1..size {
            let (to, from) = ((own + step) % size, (own + size - step) % size);
            received[from] = self.swap(std::mem::take(&mut blocks[to]), to, from)?;
        }
        Ok(received)
    }

    /// Gathers the words of all ranks in their order. Rank `r` contributes `counts[r]` words, with the same counts on all ranks.
    ///
    /// In the default implementation each step doubles the number of ranks whose words a rank has. The rank sends these words to
    /// the rank that precedes it by this number (Bruck et al., IEEE Trans. Parallel Distrib. Syst. 8 (1997) 1143,
    /// <https://doi.org/10.1109/71.642949>).
    ///
    /// # Errors
    /// - [`RankFailure::CollectiveMismatch`] if a block does not have the length given by the counts.
    /// - The errors of [`Ranks::swap`].
    fn all_gather(&self, own: &[u64], counts: &[usize]) -> Result<Vec<u64>, RankFailure> {
        let (me, ranks) = (self.rank(), self.size());
        let words_of = |of: Range<usize>| -> usize { of.map(|rank| counts[rank % ranks]).sum() };
        let (mut known, mut of) = (own.to_vec(), 1);
        while of < ranks {
            let new = of.min(ranks - of);
            let sent = known[..words_of(me..me + new)].to_vec();
            let from = (me + of) % ranks;
            let received = self.swap(sent, (me + ranks - of) % ranks, from)?;
            if received.len() != words_of(me + of..me + of + new) {
                return Err(RankFailure::CollectiveMismatch { rank: from });
            }
            known.extend(received);
            of += new;
        }
        // The words are in cyclic order from this rank. The rotation moves the words of the first rank to the front.
        known.rotate_right(words_of(0..me));
        Ok(known)
    }
}
