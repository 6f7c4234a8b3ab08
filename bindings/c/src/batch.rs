//! Steps of many histories in one call.

use rayon::iter::{IndexedParallelIterator, IntoParallelIterator, ParallelIterator};
use stickslip_rs::{History, LoadStep};

use crate::call::{Outcome, call, caught};
use crate::error::Failure;
use crate::handle::{Changing, changing};
use crate::history::stickslip_history;
use crate::loads::stickslip_load_step;
use crate::pointer::{entries, entries_mut};
use crate::status::{STICKSLIP_BUSY, STICKSLIP_OK, stickslip_status};
use crate::threads::enter_always;

/// Takes a step of each of count histories on the threads of stickslip_set_num_threads; the i-th load belongs to the i-th
/// history. A contact of at most 4096 cells is solved on one thread. Results are bitwise identical to separate steps.
///
/// codes (may be NULL) receives the code that stickslip_history_step would return for each history. The call returns
/// STICKSLIP_SOME_FAILED if any step failed. The last error belongs to the first history whose step failed. Histories whose
/// step failed are unchanged, and all other histories have taken their step. If a history occurs twice, the second
/// occurrence fails with STICKSLIP_BUSY, and the message names both positions.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_history_step_all(
    histories: *const *mut stickslip_history,
    loads: *const stickslip_load_step,
    count: usize,
    codes: *mut stickslip_status,
) -> stickslip_status {
    call(|| {
        // SAFETY: the caller follows the rule for pointers.
        let (histories, loads, mut codes) = unsafe {
            let codes = if codes.is_null() {
                None
            } else {
                Some(entries_mut("codes", codes, count)?)
            };
            (
                entries("histories", histories, count)?,
                entries("loads", loads, count)?,
                codes,
            )
        };
        let contacts = histories.iter().zip(loads).enumerate();
        let contacts = contacts.map(|(place, (history, load))| {
            // SAFETY: the caller follows the rule for pointers.
            match unsafe { changing(history.cast_const()) } {
                Ok(history) => Ok((history, load.checked()?)),
                Err(failure) => {
                    let first = histories[..place].iter().position(|other| other == history);
                    Err(match first.filter(|_| failure.code == STICKSLIP_BUSY) {
                        Some(first) => Failure::repeated([first, place]),
                        None => failure,
                    })
                }
            }
        });
        let contacts: Vec<Outcome<(Changing<'_, History>, LoadStep)>> = contacts.collect();
        let taken = |contact| caught(|| step(contact));
        let outcomes: Vec<Outcome> = enter_always(|are_several| {
            if are_several {
                let contacts = contacts.into_par_iter().with_max_len(1);
                contacts.map(taken).collect()
            } else {
                contacts.into_iter().map(taken).collect()
            }
        });
        let mut first = None;
        for (i, outcome) in outcomes.into_iter().enumerate() {
            let code = outcome
                .as_ref()
                .map_or_else(|failure| failure.code, |()| STICKSLIP_OK);
            if let Some(codes) = &mut codes {
                codes[i] = code;
            }
            if let Err(failure) = outcome {
                first.get_or_insert_with(|| failure.at(i));
            }
        }
        first.map_or(Ok(()), Err)
    })
}

fn step(contact: Outcome<(Changing<'_, History>, LoadStep)>) -> Outcome {
    let (mut history, load) = contact?;
    history.step(&load)?;
    Ok(())
}
