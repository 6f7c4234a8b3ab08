//! The floating-point environment of a call.

#[cfg(any(target_arch = "x86_64", target_arch = "aarch64"))]
use std::arch::asm;
use std::marker::PhantomData;

/// Control and status of the processor's arithmetic: rounding, traps, what becomes of tiny numbers, and which exceptions have
/// been seen.
type Word = u64;

/// Rounding to nearest, no traps, tiny numbers kept, nothing seen.
#[cfg(target_arch = "x86_64")]
const DEFAULT: Word = 0x1f80;
#[cfg(not(target_arch = "x86_64"))]
const DEFAULT: Word = 0;

/// The environment of the caller, which gets it back when this is dropped.
///
/// Compiled Rust is made for the default environment: it divides ahead of a condition that would not let it, as nobody sees
/// that. A program that traps divisions by zero (`gfortran -ffpe-trap=zero`) would be ended by that, and one that rounds
/// otherwise or drops tiny numbers (`-ffast-math`) would get other bits. The threads of the library begin within a call, and
/// take the environment from there.
#[derive(Debug)]
pub(crate) struct Environment {
    caller: Word,
    /// It belongs to its thread.
    thread: PhantomData<*const ()>,
}

impl Environment {
    /// Keeps the environment of the caller, and takes the default.
    pub(crate) fn enter() -> Self {
        let caller = word();
        set_word(DEFAULT);
        Self {
            caller,
            thread: PhantomData,
        }
    }
}

impl Drop for Environment {
    fn drop(&mut self) {
        set_word(self.caller);
    }
}

#[cfg(target_arch = "x86_64")]
fn word() -> Word {
    let mut word = 0_u32;
    // SAFETY: writes the register to these four bytes.
    unsafe { asm!("stmxcsr [{}]", in(reg) &raw mut word, options(nostack, preserves_flags)) };
    word.into()
}

#[cfg(target_arch = "x86_64")]
fn set_word(word: Word) {
    let word = u32::try_from(word).unwrap_or(0x1f80);
    // SAFETY: reads the register from these four bytes, and these are a word that it has had or its default. Within a call the
    // environment is that which Rust expects, outside that of the caller.
    unsafe { asm!("ldmxcsr [{}]", in(reg) &raw const word, options(nostack, preserves_flags)) };
}

#[cfg(target_arch = "aarch64")]
fn word() -> Word {
    let (control, status): (Word, Word);
    // SAFETY: reads two registers.
    unsafe {
        asm!("mrs {}, fpcr", "mrs {}, fpsr", out(reg) control, out(reg) status, options(nomem, nostack, preserves_flags));
    }
    (control << 32) | (status & 0xffff_ffff)
}

#[cfg(target_arch = "aarch64")]
fn set_word(word: Word) {
    let (control, status) = (word >> 32, word & 0xffff_ffff);
    // SAFETY: writes two registers, what they have had or their default. Within a call the environment is that which Rust
    // expects, outside that of the caller.
    unsafe {
        asm!("msr fpcr, {}", "msr fpsr, {}", in(reg) control, in(reg) status, options(nostack, preserves_flags));
    }
}

#[cfg(not(any(target_arch = "x86_64", target_arch = "aarch64")))]
fn word() -> Word {
    DEFAULT
}

#[cfg(not(any(target_arch = "x86_64", target_arch = "aarch64")))]
fn set_word(_: Word) {}
