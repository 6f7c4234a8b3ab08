//! The ranks as the crate uses them: calls cannot fail one by one, a failure stays, and traffic is counted.

use std::fmt::Debug;
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Arc, OnceLock};

use crate::error::{Error, Result};
use crate::parallel::ranks::{RankFailure, Ranks, WireFormat};
use crate::support::checksum;

/// Ranks that solve together. Once a call has failed nothing more is sent: what is received is empty, every rank
/// computes alone until it is asked, and [`RankGroup::check`] tells what happened.
#[derive(Debug)]
pub(crate) struct RankGroup {
    ranks: Arc<dyn Ranks>,
    failure: OnceLock<RankFailure>,
    blocks: AtomicU64,
    words: AtomicU64,
    exchanges: AtomicU64,
    gathers: AtomicU64,
    /// Agreements that some rank has refused.
    refusals: AtomicU64,
}

/// What must be the same on all ranks: its name and its value, which is compared as it is shown.
pub(crate) type Input<'a> = (&'static str, &'a dyn Debug);

/// What one rank has sent since its bodies were made.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[non_exhaustive]
pub struct CommunicationStats {
    /// Blocks sent to other ranks, those without content not counted.
    pub blocks: u64,
    /// Their bytes.
    pub bytes: u64,
    /// Exchanges of blocks with all ranks at once.
    pub exchanges: u64,
    /// Partial results gathered from all ranks: sums, maxima, decisions.
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

    /// Sends a block to each rank and returns those of all, as [`Ranks::all_to_all`]; empty ones once a call has failed.
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

    /// Takes note of a rank whose block is not the one that is due; of no other failure than the first.
    pub(crate) fn out_of_step(&self, rank: usize) {
        self.failure
            .get_or_init(|| RankFailure::CollectiveMismatch { rank });
    }

    /// The words of all ranks in their order, of which rank `r` contributes `counts[r]`, if no call has failed.
    pub(crate) fn gather(&self, own: &[u64], counts: &[usize]) -> Option<Vec<u64>> {
        if self.has_failed() {
            return None;
        }
        self.gathers.fetch_add(1, Ordering::Relaxed);
        self.kept(self.ranks.all_gather(own, counts))
    }

    /// The values of all ranks of a team, if there is one, in their order, and how many each has.
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

    /// A decision of the first rank, for all.
    pub(crate) fn decided(&self, decision: u64) -> Option<u64> {
        let found = self.of_first(decision);
        (!self.has_failed()).then_some(found)
    }

    /// The value of the first rank, for all; this rank's own once a call has failed.
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

    /// What the values of all ranks come to, combined in their order; this rank's own once a call has failed.
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

    /// The result of a step that every rank takes by itself; an error if any of them has failed.
    pub(crate) fn collective_result<T>(&self, result: Result<T>) -> Result<T> {
        self.collective_result_checked(result, &[])
    }

    /// The same at the door of a call, of inputs that must be the same on all ranks; an error if any is not. All is found
    /// in one exchange, of a digest of each.
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

    /// The same of a team, if there is one.
    pub(crate) fn agreed_of<T>(team: Option<&Self>, result: Result<T>) -> Result<T> {
        match team {
            Some(team) => team.collective_result(result),
            None => result,
        }
    }

    /// The same of steps that may agree on the way: what they have refused there all ranks know.
    pub(crate) fn run_collectively<T>(&self, work: impl FnOnce() -> Result<T>) -> Result<T> {
        let before = self.refusals.load(Ordering::Relaxed);
        let result = work();
        if result.is_err() && self.refusals.load(Ordering::Relaxed) > before {
            return result;
        }
        self.collective_result(result)
    }

    /// [`RankGroup::combined`] of a team, if there is one.
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

    /// `Ok` without a team, of what ranks cannot do together.
    pub(crate) fn check_alone(team: Option<&Self>, quantity: &'static str) -> Result<()> {
        match team {
            Some(_) => Err(Error::Ranks(RankFailure::UnsupportedOnRanks(quantity))),
            None => Ok(()),
        }
    }

    /// `Ok` as long as every call has succeeded.
    pub(crate) fn check(&self) -> Result<()> {
        match self.failure.get() {
            Some(failure) => Err(Error::Ranks(*failure)),
            None => Ok(()),
        }
    }

    pub(crate) fn has_failed(&self) -> bool {
        self.failure.get().is_some()
    }

    /// The result of a call, if none has failed; takes note of a failure.
    fn kept<T>(&self, result: Result<T, RankFailure>) -> Option<T> {
        result
            .map_err(|failure| self.failure.get_or_init(|| failure))
            .ok()
    }
}
