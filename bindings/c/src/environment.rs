//! Floating-point environment of a call.

#[cfg(any(target_arch = "x86_64", target_arch = "aarch64"))]
use std::arch::asm;
use std::marker::PhantomData;

/// Control and status of the floating-point unit: rounding mode, traps, treatment of subnormal numbers, and exception
/// flags.
type Word = u64;

/// Default environment: rounding to nearest, no traps, subnormal numbers kept, no exception flags set.
#[cfg(target_arch = "x86_64")]
const DEFAULT: Word = 0x1f80;
#[cfg(not(target_arch = "x86_64"))]
const DEFAULT: Word = 0;

/// Saved environment of the caller, which is restored on drop.
///
/// Compiled Rust assumes the default environment. It may execute a division before the condition that guards it, because
/// the result is not observable. Such a division would end a program that traps divisions by zero (`gfortran
/// -ffpe-trap=zero`). A program with a different rounding mode, or one that flushes subnormal numbers to zero
/// (`-ffast-math`), would get different results. The threads of the library start within a call and inherit the environment
/// of the call.
#[derive(Debug)]
pub(crate) struct Environment {
    caller: Word,
    /// Marker that keeps the environment on its thread.
    thread: PhantomData<*const ()>,
}

impl Environment {
    /// Saves the environment of the caller and sets the default.
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
    // SAFETY: the instruction writes the register to these four bytes.
    unsafe { asm!("stmxcsr [{}]", in(reg) &raw mut word, options(nostack, preserves_flags)) };
    word.into()
}

#[cfg(target_arch = "x86_64")]
fn set_word(word: Word) {
    let word = u32::try_from(word).unwrap_or(0x1f80);
    // SAFETY: the instruction reads the register from these four bytes, which are a former value of the register or its
    // default. Rust runs in the default environment within a call; outside the call the environment is that of the caller.
    unsafe { asm!("ldmxcsr [{}]", in(reg) &raw const word, options(nostack, preserves_flags)) };
}

#[cfg(target_arch = "aarch64")]
fn word() -> Word {
    let (control, status): (Word, Word);
    // SAFETY: the instructions read two registers.
    unsafe {
        asm!("mrs {}, fpcr", "mrs {}, fpsr", out(reg) control, out(reg) status, options(nomem, nostack, preserves_flags));
    }
    (control << 32) | (status & 0xffff_ffff)
}

#[cfg(target_arch = "aarch64")]
fn set_word(word: Word) {
    let (control, status) = (word >> 32, word & 0xffff_ffff);
    // SAFETY: the instructions write former values of two registers or their defaults. Rust runs in the default environment
    // within a call; outside the call the environment is that of the caller.
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
