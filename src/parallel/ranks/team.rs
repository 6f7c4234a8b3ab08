//! Ranks as used inside the crate. Calls return no errors, but record the first failure. The messages are counted.

use std::fmt::Debug;
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Arc, OnceLock};

use crate::error::{Error, Result};
use crate::parallel::ranks::{RankFailure, Ranks, WireFormat};
use crate::support::checksum;

/// Ranks that solve together. After a failed call nothing more is sent and received blocks are empty. Every rank continues to
/// compute alone until [`RankGroup::check`] returns the failure.
#[derive(Debug)]
pub(crate) struct RankGroup {
    ranks: Arc<dyn Ranks>,
    failure: OnceLock<RankFailure>,
    blocks: AtomicU64,
    words: AtomicU64,
    exchanges: AtomicU64,
    gathers: AtomicU64,
    /// Number of collective agreements that some rank has rejected.
    refusals: AtomicU64,
}

/// Name and value of an input that must be equal on all ranks. Values are compared by their `Debug` output.
pub(crate) type Input<'a> = (&'static str, &'a dyn Debug);

/// Numbers of messages and bytes sent by one rank since its bodies were created.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[non_exhaustive]
pub struct CommunicationStats {
    /// Number of blocks sent to other ranks, without empty blocks.
    pub blocks: u64,
    /// Number of bytes in these blocks.
    pub bytes: u64,
    /// Number of collective exchanges of blocks.
    pub exchanges: u64,
    /// Number of reductions over all ranks: sums, maxima, decisions.
    pub gathers: u64,
}

impl RankGroup {
    pub(crate) fn new(ranks: Arc<dyn Ranks>) -> Self {
        Self {
            ranks,
            failure: OnceLock::new(),
            blocks: AtomicU64::new(0),
            words: AtomicU64::new(0),
            exchanges: AtomicU64::new(0),
            gathers: AtomicU64::new(0),
            refusals: AtomicU64::new(0),
        }
    }

    pub(crate) fn rank(&self) -> usize {
        self.ranks.rank()
    }

    pub(crate) fn size(&self) -> usize {
        self.ranks.size()
    }

    pub(crate) fn traffic(&self) -> CommunicationStats {
        CommunicationStats {
            blocks: self.blocks.load(Ordering::Relaxed),
            bytes: 8 * self.words.load(Ordering::Relaxed),
            exchanges: self.exchanges.load(Ordering::Relaxed),
            gathers: self.gathers.load(Ordering::Relaxed),
        }
    }

    /// Sends a block to each rank and returns the received blocks, like [`Ranks::all_to_all`]. The blocks are empty once a call
    /// has failed.
    pub(crate) fn all_to_all(&self, blocks: Vec<Vec<u64>>, is_expected: &[bool]) -> Vec<Vec<u64>> {
        let none = || vec![Vec::new(); self.size()];
        if self.has_failed() {
            return none();
        }
        let sent = blocks.iter().filter(|block| !block.is_empty());
        self.exchanges.fetch_add(1, Ordering::Relaxed);
        self.blocks
            .fetch_add(sent.clone().count() as u64, Ordering::Relaxed);
        let words: usize = sent.map(Vec::len).sum();
        self.words.fetch_add(words as u64, Ordering::Relaxed);
        let received = self.ranks.all_to_all(blocks, is_expected);
        self.kept(received).unwrap_or_else(none)
    }

    /// Records that a rank has sent an unexpected block, unless an earlier failure is recorded.
    pub(crate) fn out_of_step(&self, rank: usize) {
        self.failure
            .get_or_init(|| RankFailure::CollectiveMismatch { rank });
    }

    /// Gathers the words of all ranks in their order, where rank `r` contributes `counts[r]` words. Returns `None` once a call
    /// has failed.
    pub(crate) fn gather(&self, own: &[u64], counts: &[usize]) -> Option<Vec<u64>> {
        if self.has_failed() {
            return None;
        }
        self.gathers.fetch_add(1, Ordering::Relaxed);
        self.kept(self.ranks.all_gather(own, counts))
    }

    /// Gathers the values of all ranks of a team, if there is a team, in the order of the ranks. Also returns the number
    /// of values of each rank.
    pub(crate) fn gathered_of<T: WireFormat>(
        team: Option<&Self>,
        own: Vec<T>,
    ) -> Result<(Vec<T>, Vec<usize>)> {
        let length = own.len();
        let Some(team) = team else {
            return Ok((own, vec![length]));
        };
        let none = || team.check().map(|()| (Vec::new(), Vec::new()));
        let Some(lengths) = team.gather(&[length as u64], &vec![1; team.size()]) else {
            return none();
        };
        let mut lengths = &lengths[..];
        let lengths: Vec<usize> = (0..team.size())
            .map(|_| WireFormat::read(&mut lengths))
            .collect();
        let mut words = Vec::with_capacity(length * T::COUNT);
        for value in own {
            value.write(&mut words);
        }
        let counts: Vec<usize> = lengths.iter().map(|length| length * T::COUNT).collect();
        let Some(all) = team.gather(&words, &counts) else {
            return none();
        };
        let mut all = &all[..];
        let values = (0..lengths.iter().sum()).map(|_| T::read(&mut all));
        Ok((values.collect(), lengths))
    }

    /// Returns a decision of the first rank, for all ranks.
    pub(crate) fn decided(&self, decision: u64) -> Option<u64> {
        let found = self.of_first(decision);
        (!self.has_failed()).then_some(found)
    }

    /// Returns the value of the first rank, for all ranks, or the local value once a call has failed.
    pub(crate) fn of_first<T: WireFormat>(&self, own: T) -> T {
        let mut counts = vec![0; self.size()];
        counts[0] = T::COUNT;
        let mut words = Vec::new();
        if self.rank() == 0 {
            own.write(&mut words);
        }
        let all = self.gather(&words, &counts);
        all.map_or(own, |all| T::read(&mut &all[..]))
    }

    /// Reduces the values of all ranks in their order, or returns the local value once a call has failed.
    pub(crate) fn combined<T: WireFormat>(&self, own: T, combine: impl Fn(T, T) -> T) -> T {
        let mut words = Vec::with_capacity(T::COUNT);
        own.write(&mut words);
        let Some(all) = self.gather(&words, &vec![T::COUNT; self.size()]) else {
            return own;
        };
        let mut all = &all[..];
        let values = (0..self.size()).map(|_| T::read(&mut all));
        values.reduce(combine).unwrap_or(own)
    }

    /// Returns the local result of a step that every rank takes, or an error if the step failed on any rank.
    pub(crate) fn collective_result<T>(&self, result: Result<T>) -> Result<T> {
        self.collective_result_checked(result, &[])
    }

    /// Returns a result like [`RankGroup::collective_result`], and checks that inputs are equal on all ranks. All checks take one
    /// exchange with a digest of each input.
    pub(crate) fn collective_result_checked<T>(
        &self,
        result: Result<T>,
        inputs: &[Input<'_>],
    ) -> Result<T> {
        let mut own = vec![u64::from(result.is_err())];
        own.extend(inputs.iter().map(|(_, value)| checksum::of_shown(*value)));
        let Some(all) = self.gather(&own, &vec![own.len(); self.size()]) else {
            self.check()?;
            return result;
        };
        let mut ranks = all.chunks_exact(own.len());
        let differs = |place: usize| ranks.clone().any(|rank| rank[1 + place] != own[1 + place]);
        let different = (0..inputs.len()).find(|place| differs(*place));
        let failure = match (ranks.position(|rank| rank[0] != 0), different) {
            (Some(rank), _) => RankFailure::RejectedByRank { rank },
            (None, Some(place)) => RankFailure::InconsistentInput(inputs[place].0),
            (None, None) => return result,
        };
        self.refusals.fetch_add(1, Ordering::Relaxed);
        result.and(Err(Error::Ranks(failure)))
    }

    /// Returns the result of [`RankGroup::collective_result`] for a team, or the local result without a team.
    pub(crate) fn agreed_of<T>(team: Option<&Self>, result: Result<T>) -> Result<T> {
        match team {
            Some(team) => team.collective_result(result),
            None => result,
        }
    }

    /// Returns a result like [`RankGroup::collective_result`] for work that may contain collective agreements. All ranks have the
    /// error of such an agreement, so that no further exchange is necessary.
    pub(crate) fn run_collectively<T>(&self, work: impl FnOnce() -> Result<T>) -> Result<T> {
        let before = self.refusals.load(Ordering::Relaxed);
        let result = work();
        if result.is_err() && self.refusals.load(Ordering::Relaxed) > before {
            return result;
        }
        self.collective_result(result)
    }

    /// Reduces the values of a team like [`RankGroup::combined`], or returns the local value without a team.
    pub(crate) fn combined_of<T: WireFormat>(
        team: Option<&Self>,
        own: T,
        combine: impl Fn(T, T) -> T,
    ) -> T {
        match team {
            Some(team) => team.combined(own, combine),
            None => own,
        }
    }

    /// Returns an error with the name `quantity` if there is a team. Features that ranks do not support call this function.
    pub(crate) fn check_alone(team: Option<&Self>, quantity: &'static str) -> Result<()> {
        match team {
            Some(_) => Err(Error::Ranks(RankFailure::UnsupportedOnRanks(quantity))),
            None => Ok(()),
        }
    }

    /// Returns an error if a call has failed.
    pub(crate) fn check(&self) -> Result<()> {
        match self.failure.get() {
            Some(failure) => Err(Error::Ranks(*failure)),
            None => Ok(()),
        }
    }

    pub(crate) fn has_failed(&self) -> bool {
        self.failure.get().is_some()
    }

    /// Returns the value of a call, or records its failure and returns `None`.
    fn kept<T>(&self, result: Result<T, RankFailure>) -> Option<T> {
        result
            .map_err(|failure| self.failure.get_or_init(|| failure))
            .ok()
    }
}
