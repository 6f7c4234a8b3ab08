//! Several processes, or threads, that solve one contact together.
//!
//! A *rank* is one of them. Every rank runs the same program on its own part of the cells, and meets the others in the
//! exchanges of [`Ranks`] alone: all ranks make the same calls in the same order. Nothing else of this crate communicates.
//!
//! [`HalfSpace::distributed`](crate::HalfSpace::distributed) deals out the rows of a grid: each rank holds a *slab* of
//! them, with fields, problems and solutions of its own. Builders are those of any bodies. Whatever ranks do together
//! every rank must do: build, solve and step, change what is solved, return to a state, displacements, energies, cycles
//! (begin, add) and jumps over them ([`CycleJump::new`](crate::history::wear::CycleJump::new),
//! [`max_stable_cycles`](crate::history::wear::max_stable_cycles)), contact spots, statistics, files. What else a solution says
//! of the whole contact (force, area, stick ratio, report, ...) every rank knows without asking; its fields are those of the
//! slab.
//!
//! # The same inputs
//!
//! Ranks that came with different inputs would find the answer to no problem at all. What is one for the whole contact is
//! therefore compared where a call begins, in one exchange of a word for each input: grid, pair and boundary of the bodies,
//! parameters of a rough surface, loads, friction and hardness that are uniform, model, coupling and settings of a problem
//! or a history, also where they are changed later, the load of each step, and the state that a history starts from or
//! returns to. All ranks refuse what differs on any of them, by its name ([`RankFailure::InconsistentInput`]), and stay as they were. Fields
//! cannot be compared, since each rank has other rows of them: a gap, or a coefficient for each cell, must be made of the
//! same numbers everywhere.
//!
//! Normal, tangential and coupled problems and histories of them can be shared, on all boundaries, with hardness, friction
//! that differs from cell to cell, relative displacements, wear and stiffnesses, and stresses on planes below the surface
//! ([`Planes`](crate::subsurface::Planes)), of which each rank gets its rows. Refused ([`RankFailure::UnsupportedOnRanks`]) are
//! stresses at single points, since a sum over the loaded cells of all ranks is not made in slabs, stresses under values
//! at the centres of cells, files of stresses, and dense matrices.
//!
//! Surfaces are made ([`SelfAffine::generate_on`](crate::surface::SelfAffine::generate_on)), characterised
//! ([`HalfSpace::statistics`](crate::HalfSpace::statistics)) and levelled slab by slab, and fields are read from and written
//! to files of the whole grid ([`HalfSpace::write_npy`](crate::HalfSpace::write_npy),
//! [`HalfSpace::write_pvti`](crate::HalfSpace::write_pvti)).
//!
//! | ranks | are |
//! |---|---|
//! | [`Threads`] | threads of one process, to try and test distributed programs |
//! | `Mpi` (feature `mpi`) | processes of an MPI program |
//! | in Python, in C | a communicator of mpi4py, a function of the program ([guide](crate::guide::distributed)) |
//! | your own | anything that swaps blocks: implement [`Ranks::swap`], and what can be done faster than by swaps |
//!
//! # The same bits
//!
//! An answer has the bits that one process finds, on any number of ranks. A transform of a row or a column is the same
//! call on the same numbers wherever it is made; sums follow one tree of chunks of rows, slabs end where chunks end, and
//! every rank finishes the tree from the nodes that others hold wholly. Observer and clock are asked on all ranks, and
//! the first decides, on every level. Coarse grids of nested starts of at most 65 536 cells every rank solves by itself.
//!
//! # Histories
//!
//! The state of a history is that of the rows of the slab. All ranks save it together, in one
//! file that replaces the earlier one when every rank has written its rows ([`History::save`](crate::History::save)). Any
//! number of ranks continues from it to the same bits ([`History::load`](crate::History::load)), or from the
//! [bytes](crate::History::to_bytes) of the slabs ([`State::from_slabs`](crate::history::State::from_slabs)). A step
//! brings tractions and offsets of the contact's window to the ranks that share its rows, and the answer back: about ten
//! numbers per cell of the window and component. Gap, friction and settings are changed by all ranks alike; energies and
//! sums of cycles are those of the whole contact, slip and wear those of the slab. An observer of a
//! [`FrettingLoop`](crate::history::FrettingLoop) is asked on all ranks, and the first decides.
//!
//! # What is sent
//!
//! A product on $`n \times n`$ cells swaps the transforms of its rows for those of its columns and back. All ranks
//! together send
//!
//! ```math
//! 32\,n^2 \Bigl(1 - \frac1P\Bigr) \text{ bytes}
//! ```
//!
//! on a free grid, half of it on a periodic one, and half of either in single precision; bands of 16 rows without
//! traction are not sent on the way there. In either direction a rank sends a block to each other one, all at once
//! ([`Ranks::all_to_all`]), packed on all threads; of more than 4 MB in up to 16 rounds, so that blocks take little
//! memory beside what they are made of. A window of the contact has its rows dealt out to all ranks anew. An
//! iteration adds up seven partial results, of some hundred bytes in $`\lceil\log_2 P\rceil`$ messages each.
//! [`HalfSpace::traffic`](crate::HalfSpace::traffic) counts both.
//!
//! Columns of the transform are dealt out in sixteens, two cache lines of each row, since both precisions share them:
//! of $`n \times n`$ cells on a grid that repeats at most $`n/32`$ ranks have columns to transform (a free grid has
//! twice as many). Rows are dealt out in whole chunks of the sums, 4096 cells or one row, and in pairs, as they are
//! transformed: 96 rows of 96 cells lie as 42, 42 and 12 on three ranks. Shorter chunks would share them evenly, but would
//! change the last digits of every sum, and such grids gain nothing from ranks: from $`8192 P`$ cells on no rank has more
//! than twice its even part, from $`81\,920\, P`$ cells on at most a tenth more than it. Ranks beyond these numbers have nothing to do in that part, and only
//! wait.
//!
//! Of the whole contact a rank keeps counts alone: each counts its slab, and joins the spots at its ends with those of
//! the next in $`\lceil\log_2 P\rceil`$ exchanges of two rows. Where it is asked for the spots one by one
//! ([`NormalSolution::spots`](crate::NormalSolution::spots) and its like), each labels its slab, sends the labels of its last
//! row to the next rank, and all gather the sums of all spots, 72 bytes for each and for each part of one that a slab cuts.
//!
//! # Failure
//!
//! Input that one rank refuses all refuse: its own error there, [`RankFailure::RejectedByRank`] on the others; so do kernels that one
//! rank cannot make, for want of memory or as its response fails. If a rank ends
//! or is silent for too long, the calls of the others return [`RankFailure::Disconnected`] or [`RankFailure::Timeout`], and so do
//! all that follow on the same bodies; a block of another length than is due is that of a rank that makes other calls
//! ([`RankFailure::CollectiveMismatch`]). A file that they were writing together is then the old one, or the new one if all
//! of it was there.

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

/// How one rank reaches the others.
///
/// What travels is blocks of 64-bit words. An implementation keeps the order of the blocks between any two ranks. When
/// a rank leaves, the calls of the others return a [`RankFailure`]: they do not wait without end.
///
/// [`Ranks::swap`] is enough: the other exchanges are made of it unless an implementation has a faster way.
pub trait Ranks: Debug + Send + Sync {
    /// The number of this rank, from zero.
    fn rank(&self) -> usize;

    /// How many ranks there are.
    fn size(&self) -> usize;

    /// Sends a block to the rank `to` and receives one from the rank `from`, which calls at the same time. Neither is
    /// this rank itself. The block received may be of any length.
    ///
    /// # Errors
    /// [`RankFailure::Disconnected`], [`RankFailure::Timeout`].
    fn swap(&self, block: Vec<u64>, to: usize, from: usize) -> Result<Vec<u64>, RankFailure>;

    /// Sends `blocks[r]` to each rank `r` and returns the block of each rank at its place. All ranks call at the same time;
    /// a rank that sends this one any words is one of those with `is_expected[r]`, and sends at least one. A block without
    /// words need not travel: an empty one is returned for it. What stands at the place of this rank itself is dropped,
    /// and an empty block returned.
    ///
    /// The default swaps blocks with one rank after the other.
    ///
    /// # Errors
    /// Those of [`Ranks::swap`].
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

    /// The words of all ranks in their order, of which rank `r` contributes `counts[r]`, the same numbers on all ranks.
    ///
    /// In the default each step doubles the ranks that a rank has heard of: it sends all it knows back by that many ranks
    /// (Bruck et al., IEEE Trans. Parallel Distrib. Syst. 8 (1997) 1143, <https://doi.org/10.1109/71.642949>).
    ///
    /// # Errors
    /// Those of [`Ranks::swap`]; [`RankFailure::CollectiveMismatch`] if a block is of another length than the counts say.
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
        // From this rank on, around; begun with the first.
        known.rotate_right(words_of(0..me));
        Ok(known)
    }
}
