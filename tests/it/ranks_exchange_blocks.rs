//! Exchanges between ranks bring each block where it belongs, with those that an implementation adds and without.

use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering::Relaxed};

use stickslip::influence::Component;
use stickslip::ranks::{RankFailure, Ranks, Threads};
use stickslip::*;

use crate::ranks_share_a_contact::{PATIENCE, pair, same};

/// Ranks that can do no more than they must.
#[derive(Debug)]
struct Swaps(Threads);

impl Ranks for Swaps {
    fn rank(&self) -> usize {
        self.0.rank()
    }

    fn size(&self) -> usize {
        self.0.size()
    }

    fn swap(&self, block: Vec<u64>, to: usize, from: usize) -> Result<Vec<u64>, RankFailure> {
        self.0.swap(block, to, from)
    }
}

/// The work on ranks of both kinds.
fn on_both<T: Send>(size: usize, work: impl Fn(Arc<dyn Ranks>) -> T + Sync) -> [Vec<T>; 2] {
    [
        Threads::run(size, PATIENCE, |rank| work(Arc::new(rank))),
        Threads::run(size, PATIENCE, |rank| work(Arc::new(Swaps(rank)))),
    ]
}

/// The words that one rank sends another: none to some.
fn words(from: usize, to: usize) -> Vec<u64> {
    let count = if from == to { 0 } else { 3 * from * to % 4 };
    vec![(100 * from + to) as u64; count]
}

#[test]
fn every_block_arrives() {
    for size in [2, 3, 5, 8] {
        for outcomes in on_both(size, |ranks| {
            let own = ranks.rank();
            // Twice, so that a rank may be ahead of another.
            for _ in 0..2 {
                let blocks = (0..size).map(|to| words(own, to)).collect();
                let expected: Vec<_> = (0..size).map(|from| words(from, own)).collect();
                let comes: Vec<bool> = expected.iter().map(|block| !block.is_empty()).collect();
                assert_eq!(ranks.all_to_all(blocks, &comes)?, expected);
                let counts: Vec<usize> = (0..size).map(|rank| words(rank, 1).len()).collect();
                let all: Vec<_> = (0..size).flat_map(|rank| words(rank, 1)).collect();
                assert_eq!(ranks.all_gather(&words(own, 1), &counts)?, all);
            }
            Ok::<(), RankFailure>(())
        }) {
            assert!(outcomes.iter().all(Result::is_ok), "{outcomes:?}");
        }
    }
}

#[test]
fn who_gathers_other_counts_is_told() {
    for outcomes in on_both(2, |ranks| {
        let counts = [1, 1 + ranks.rank()];
        ranks.all_gather(&vec![7; counts[ranks.rank()]], &counts)
    }) {
        let told = Err(RankFailure::CollectiveMismatch { rank: 1 });
        assert_eq!(outcomes[0], told);
        assert_eq!(outcomes[1], Ok(vec![7; 3]));
    }
}

/// A rank that leaves while others hold large blocks for each other is lost to both: none waits for the other.
#[test]
fn who_leaves_among_large_blocks_is_told() {
    for outcomes in on_both(3, |ranks| {
        if ranks.rank() == 2 {
            return Ok(());
        }
        let block = vec![7; 1 << 17];
        ranks.all_to_all(vec![block; 3], &[true; 3]).map(drop)
    }) {
        let lost = Err(RankFailure::Disconnected { rank: 2 });
        assert_eq!(outcomes, [lost, lost, Ok(())]);
    }
}

/// Ranks of which the first gets a block of the second a word short, after so many others.
#[derive(Debug)]
struct Short {
    rank: Threads,
    after: usize,
    blocks: AtomicUsize,
}

impl Ranks for Short {
    fn rank(&self) -> usize {
        self.rank.rank()
    }

    fn size(&self) -> usize {
        self.rank.size()
    }

    fn swap(&self, block: Vec<u64>, to: usize, from: usize) -> Result<Vec<u64>, RankFailure> {
        let mut block = self.rank.swap(block, to, from)?;
        if self.rank() == 0 && from == 1 && !block.is_empty() {
            let blocks = self.blocks.fetch_add(1, Relaxed);
            if blocks == self.after {
                block.pop();
            }
        }
        Ok(block)
    }
}

/// Whatever is exchanged, a block that is not of its length is no answer.
#[test]
fn a_block_of_another_length_is_told() {
    let grid = Grid::new(96, 300, 0.1, 0.05).unwrap();
    let solve = |after: usize| {
        Threads::run(3, PATIENCE, |rank| {
            let ranks = Arc::new(Short {
                rank,
                after,
                blocks: 0.into(),
            });
            let shared: Arc<dyn Ranks> = Arc::clone(&ranks) as _;
            let outcome = HalfSpace::distributed(grid, pair(), Boundary::NonPeriodic, shared);
            let outcome = outcome.and_then(|bodies| {
                let ball = surface::sphere(bodies.grid(), 10.0)?;
                let load = NormalControl::Force(0.5);
                let problem = NormalProblem::builder(&bodies, &ball, load).tolerance(1e-3);
                problem.build()?.solve()
            });
            (outcome.map(drop), ranks.blocks.load(Relaxed))
        })
    };
    let whole = solve(usize::MAX);
    assert!(
        whole.iter().all(|(outcome, _)| outcome.is_ok()),
        "{whole:?}"
    );
    let all = whole[0].1;
    let [parts, stride] = kit::thorough([4, 2], [12, 1]);
    let moments = (0..all).step_by(all / parts);
    for after in moments.chain((all - 6..all).step_by(stride)) {
        let outcomes = solve(after);
        let told = Error::Ranks(RankFailure::CollectiveMismatch { rank: 1 });
        assert_eq!(outcomes[0].0, Err(told), "{after} of {all}");
    }
}

/// A product waits for others twice: for what its columns need, and for what its rows do. Each rank sends a block to each
/// other one there.
#[test]
fn a_product_takes_two_exchanges() {
    let (size, grid) = (4, Grid::square(256, 8.0).unwrap());
    let product = |bodies: &HalfSpace| {
        let operator = bodies.operator(Component::ZZ).unwrap();
        let traction = Field::from_fn(bodies.grid(), |x, y| (3.0 * x).sin() + (5.0 * y).cos());
        let mut out = Field::zeros(bodies.grid());
        let (x, u) = ([traction.as_slice()], [out.as_mut_slice()]);
        operator.apply(x, u, &mut operator.scratch().unwrap());
        out.into_vec()
    };
    let alone = product(&HalfSpace::new(grid, pair()).unwrap());
    for outcomes in on_both(size, |ranks| {
        let bodies = HalfSpace::distributed(grid, pair(), Boundary::NonPeriodic, ranks).unwrap();
        // The symbol is sampled by the first one.
        let mut sent = bodies.traffic();
        let mut slab = Vec::new();
        for _ in 0..2 {
            sent = bodies.traffic();
            slab = product(&bodies);
        }
        let now = bodies.traffic();
        assert_eq!(now.exchanges - sent.exchanges, 2);
        assert_eq!(now.blocks - sent.blocks, 2 * (size as u64 - 1));
        slab
    }) {
        same(&outcomes.concat(), &alone).unwrap();
    }
}
