//! Ranks that C reaches: a function that swaps blocks with others.

use std::ffi::c_void;
use std::ptr::null_mut;

use stickslip_rs::ranks::{RankFailure, Ranks};

use crate::call::Outcome;
use crate::error::Failure;
use crate::status::STICKSLIP_LENGTH;

/// A block on its way to this rank.
#[derive(Debug, Default)]
pub struct stickslip_block(Vec<u64>);

/// Sends a block of words to the rank `to` and receives one from the rank `from`, neither of which is this one: it asks
/// stickslip_block_room for the memory, and fills it. Blocks between two ranks keep their order, and are of any length, also
/// none. Returns 0, or any other number if a rank is lost: nothing more is then asked. It is called by one thread at a time, on
/// more than 4096 cells possibly another than that which made the call. It must not unwind or jump out, nor call other
/// functions of this library.
pub type stickslip_swap = Option<
    unsafe extern "C" fn(
        block: *const u64,
        words: usize,
        to: usize,
        from: usize,
        received: *mut stickslip_block,
        user: *mut c_void,
    ) -> i32,
>;

/// One of several processes that solve together; stickslip_mpi.h makes it of an MPI communicator. Function and data are
/// needed until all that was made of the bodies is freed.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct stickslip_ranks {
    /// The number of this one, from zero.
    pub rank: usize,
    /// How many there are.
    pub size: usize,
    /// Swaps blocks with others; not called where there are none.
    pub swap: stickslip_swap,
    /// Passed to the function as it is.
    pub user: *mut c_void,
}

// SAFETY: the header says that the function may be called by another thread, by one at a time, and the caller has agreed.
unsafe impl Send for stickslip_ranks {}
// SAFETY: as above.
unsafe impl Sync for stickslip_ranks {}

impl stickslip_ranks {
    pub(crate) fn checked(&self) -> Outcome<Self> {
        if self.rank >= self.size {
            let sizes = [self.rank.saturating_add(1), self.size];
            return Err(Failure::length(STICKSLIP_LENGTH, "ranks", sizes));
        }
        if self.size > 1 && self.swap.is_none() {
            return Err(Failure::pointer("swap"));
        }
        Ok(*self)
    }
}

impl Ranks for stickslip_ranks {
    fn rank(&self) -> usize {
        self.rank
    }

    fn size(&self) -> usize {
        self.size
    }

    fn swap(&self, block: Vec<u64>, to: usize, from: usize) -> Result<Vec<u64>, RankFailure> {
        let mut received = stickslip_block::default();
        let place = &raw mut received;
        // SAFETY: the caller's function, called as its type says.
        let outcome = self
            .swap
            .map(|swap| unsafe { swap(block.as_ptr(), block.len(), to, from, place, self.user) });
        match outcome {
            Some(0) => Ok(received.0),
            _ => Err(RankFailure::Disconnected { rank: from }),
        }
    }
}

/// Room for so many words of a block that is received, to be filled before the swap returns; NULL if there is no memory.
/// Called by a stickslip_swap alone, on the block that it was given.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_block_room(
    block: *mut stickslip_block,
    words: usize,
) -> *mut u64 {
    // SAFETY: NULL or valid by the rule for pointers.
    let Some(stickslip_block(room)) = (unsafe { block.as_mut() }) else {
        return null_mut();
    };
    room.clear();
    if room.try_reserve_exact(words).is_err() {
        return null_mut();
    }
    room.resize(words, 0);
    room.as_mut_ptr()
}
