//! Exchanges between ranks deliver each block to its destination, with the default collective methods and with the
//! collective methods of an implementation.

use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering::Relaxed};

use stickslip::influence::Component;
use stickslip::ranks::{RankFailure, Ranks, Threads};
use stickslip::*;

use crate::rank_contacts::{PATIENCE, pair, same};

/// Ranks that implement only the required methods.
#[derive(Debug)]
struct SwapOnly(Threads);

impl Ranks for SwapOnly {
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

/// Runs the work on ranks of both kinds.
fn on_both<T: Send>(size: usize, work: impl Fn(Arc<dyn Ranks>) -> T + Sync) -> [Vec<T>; 2] {
    [
        Threads::run(size, PATIENCE, |rank| work(Arc::new(rank))),
        Threads::run(size, PATIENCE, |rank| work(Arc::new(SwapOnly(rank)))),
    ]
}

/// Returns the words that `from` sends to `to`. Some blocks are empty.
fn words(from: usize, to: usize) -> Vec<u64> {
    let count = if from == to { 0 } else { 3 * from * to % 4 };
    vec![(100 * from + to) as u64; count]
}

#[test]
fn exchange_delivers_every_block() {
    for size in [2, 3, 5, 8] {
        for outcomes in on_both(size, |ranks| {
            let own = ranks.rank();
            // The exchange is repeated, so that a rank may run ahead of the others.
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
fn mismatched_gather_counts_are_reported() {
    for outcomes in on_both(2, |ranks| {
        let counts = [1, 1 + ranks.rank()];
        ranks.all_gather(&vec![7; counts[ranks.rank()]], &counts)
    }) {
        let out_of_step = Err(RankFailure::CollectiveMismatch { rank: 1 });
        assert_eq!(outcomes[0], out_of_step);
        assert_eq!(outcomes[1], Ok(vec![7; 3]));
    }
}

/// A rank leaves while two other ranks have large blocks to send to each other. Both report the lost rank, and neither
/// waits for the other.
#[test]
fn rank_leaving_among_large_blocks_is_reported() {
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

/// Ranks that corrupt one block. After the given number of blocks, the first rank receives a block that is one word too
/// short from the second rank.
#[derive(Debug)]
struct ShortBlock {
    rank: Threads,
    after: usize,
    blocks: AtomicUsize,
}

impl Ranks for ShortBlock {
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

/// A block of the wrong length is reported, whichever exchange it belongs to.
#[test]
fn block_of_wrong_length_is_reported() {
    let grid = Grid::new(96, 300, 0.1, 0.05).unwrap();
    let solve = |after: usize| {
        Threads::run(3, PATIENCE, |rank| {
            let ranks = Arc::new(ShortBlock {
                rank,
                after,
                blocks: 0.into(),
            });
            let shared: Arc<dyn Ranks> = Arc::clone(&ranks) as _;
            let outcome = HalfSpace::distributed(grid, pair(), Boundary::NonPeriodic, shared);
            let outcome = outcome.and_then(|bodies| {
                let ball = surface::sphere(bodies.grid(), 10.0)?;
                let load = NormalLoad::Force(0.5);
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
        let out_of_step = Error::Ranks(RankFailure::CollectiveMismatch { rank: 1 });
        assert_eq!(outcomes[0].0, Err(out_of_step), "{after} of {all}");
    }
}

/// A product has two exchanges, one for the columns and one for the rows. In each exchange, each rank sends a block to
/// every other rank.
#[test]
fn product_has_two_exchanges() {
    let (size, grid) = (4, kit::square(256, 8.0));
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
        // The symbol is sampled by the first product.
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
