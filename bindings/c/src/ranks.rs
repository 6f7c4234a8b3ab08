//! Ranks that communicate through a function of the caller.

use std::ffi::c_void;
use std::ptr::null_mut;

use stickslip_rs::ranks::{RankFailure, Ranks};

use crate::call::Outcome;
use crate::error::Failure;
use crate::status::STICKSLIP_LENGTH;

/// Block that this rank receives.
#[derive(Debug, Default)]
pub struct stickslip_block(Vec<u64>);

/// Function that sends a block of words to the rank `to` and receives a block from the rank `from`; neither is the
/// calling rank. It requests memory for the received block with stickslip_block_room and fills it. Blocks between two
/// ranks keep their order and may have any length, including zero. The function returns 0 on success and any non-zero
/// value if a rank is lost; in that case it is not called again. Only one thread calls it at a time; on more than 4096
/// cells this thread may differ from the thread that made the call. The function must not unwind or jump out, and must
/// not call other functions of this library.
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

/// Rank: one of several processes that solve together. stickslip_mpi.h creates this struct from an MPI communicator.
/// The function and the data must remain valid until all objects created from the bodies are freed.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct stickslip_ranks {
    /// Number of this rank, counted from zero.
    pub rank: usize,
    /// Number of ranks.
    pub size: usize,
    /// Function that exchanges blocks with other ranks; not called if there is only one rank.
    pub swap: stickslip_swap,
    /// Data passed unchanged to the function.
    pub user: *mut c_void,
}

// SAFETY: the header states that another thread may call the function, one thread at a time, and the caller accepts this.
unsafe impl Send for stickslip_ranks {}
// SAFETY: see the implementation of `Send` above.
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
        // SAFETY: the function of the caller is called according to its type.
        let outcome = self
            .swap
            .map(|swap| unsafe { swap(block.as_ptr(), block.len(), to, from, place, self.user) });
        match outcome {
            Some(0) => Ok(received.0),
            _ => Err(RankFailure::Disconnected { rank: from }),
        }
    }
}

/// Returns memory for a given number of words of a received block, or NULL if memory is exhausted. The swap function
/// must fill this memory before it returns. Only a stickslip_swap may call this function, with the block that it was
/// given.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_block_room(
    block: *mut stickslip_block,
    words: usize,
) -> *mut u64 {
    // SAFETY: the pointer is NULL or valid by the rule for pointers.
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
