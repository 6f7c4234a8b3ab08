//! Contacts with memory of their load.

mod accessors;
mod adaptive;
mod balance;
mod builder;
mod cycle;
mod path;
mod rolling;
mod saving;
mod sensitivity;
mod state;
mod step;
mod stepping;
mod wear;

pub(crate) use adaptive::{AdaptiveSteps, StepErrorEstimate};
pub(crate) use balance::EnergyBalance;
pub(crate) use builder::History;
pub(crate) use cycle::{Cycle, LoopPoint, LoopPoints};
pub(crate) use path::LoadPath;
pub(crate) use rolling::{Rolling, as_keywords};
pub(crate) use state::State;
pub(crate) use step::StepResult;
pub(crate) use wear::{CycleJump, archard, energy, max_stable_cycles, threshold_energy};
