//! Wear depth, and the number of cycles that a simulation may jump over.
//!
//! The laws add to a field of the caller. The field may be the depth of one body or the depth of a cycle. It may also
//! be the gap itself, because removal from either body opens the gap. The [`Coefficient`] of a law is a number or a
//! field. A user-defined law needs only slip, pressure or energy of a [step](crate::history::StepResult) or a
//! [cycle](crate::history::Cycle). The depth of a user-defined law may extend a few cells beyond the contact, as in models of
//! debris. [`History::set_gap`](crate::History::set_gap) accepts any depth, also in cells without contact. Such cells have no
//! effect until the bodies touch there. [`CycleJump`] computes the number of cycles whose wear may be applied at once.
//!
//! In this example wear is applied to the gap after every step:
//!
//! ```
//! use std::ops::ControlFlow;
//! use stickslip::history::{FrettingLoop, LoadPath, wear};
//! use stickslip::*;
//! let grid = Grid::square(32, 8.0)?;
//! let rubber = Material::new(1.0, 0.5)?;
//! let bodies = HalfSpace::new(grid, ElasticPair::new(rubber, Material::rigid())?)?;
//! let mut gap = surface::sphere(grid, 10.0)?;
//! let mut history = History::builder(&bodies, &gap, Friction::coulomb(0.3)?).build()?;
//! history.step(&LoadStep::hold().normal(NormalLoad::Force(0.5)))?;
//! let before = history.pressure().max();
//!
//! let path = LoadPath::sine([0.4, 0.0], 8)?;
//! let fretting = FrettingLoop::new(path, |shift| LoadStep::shift(shift).normal(NormalLoad::Force(0.5)));
//! fretting.run_observed(&mut history, 2, |history, _| {
//!     let slip = history.last_step()?.slip_distance();
//!     wear::archard(1e-2, history.pressure(), slip, &mut gap)?;
//!     history.set_gap(&gap)?;
//!     Ok(ControlFlow::Continue(()))
//! })?;
//! assert!(history.pressure().max() < before);
//! # Ok::<(), Error>(())
//! ```
//!
//! The example `wear_loop` plots:
#![cfg_attr(doc, doc = include_str!("../../pictures/wear_loop.html"))]

mod coefficient;
mod jump;
mod law;

pub use coefficient::Coefficient;
pub use jump::{CycleJump, max_stable_cycles};
pub use law::{archard, energy, threshold_energy};

use crate::error::{Result, all_non_negative};
use crate::grid::Grid;
use crate::grid::field::Field;

/// Returns an error if a field belongs to a different grid, or a value is negative or not finite.
fn check(quantity: &'static str, field: &Field, grid: Grid) -> Result<()> {
    grid.check_equal(quantity, field.grid())?;
    all_non_negative(quantity, field.as_slice())
}
