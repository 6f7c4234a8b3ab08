//! Twenty steps of a contact with wear. All ranks save the history after ten steps.

use std::path::PathBuf;

use stickslip::history::{EntryRule, wear};
use stickslip::ranks::Ranks;
use stickslip::{
    Axis, Field, Friction, HalfSpace, History, LoadStep, NormalLoad, TangentialControl,
};

use crate::{FRICTION, Outcome, hash_of_all};

/// Number of steps.
const STEPS: u64 = 20;
/// Number of steps after which the history is saved.
const SAVED: u64 = 10;
/// Worn depth divided by pressure and slip (one over a pressure).
const WEAR: f64 = 0.05;

/// Use of a file by the history.
pub(crate) enum Saved {
    /// The history is saved to this file after half of its steps.
    To(PathBuf),
    /// The history starts from this file, which may have been saved by any number of ranks.
    From(PathBuf),
}

/// Presses the surfaces with an oscillating normal force of at most `force`. Shears them along x with an oscillating
/// force of at most half of the friction limit. Returns a hash of the bits of the final state.
pub(crate) fn fret(
    bodies: &HalfSpace,
    gap: &Field,
    force: f64,
    saved: &Saved,
    ranks: &dyn Ranks,
) -> Outcome<u64> {
    let mut history = match saved {
        Saved::To(_) => begun(bodies, gap)?,
        Saved::From(file) => History::load(bodies, file)?,
    };
    for step in history.steps()..STEPS {
        let k = step as f64;
        let normal = force * (0.6 + 0.4 * (0.9 * k).sin());
        let part = 0.5 * FRICTION * (1.3 * k).cos();
        let load = LoadStep::hold()
            .normal(NormalLoad::Force(normal))
            .tangential(Axis::X, TangentialControl::Force(part * normal));
        history.step(&load)?;
        let mut worn = history.unloaded_gap().clone();
        let slip = history.last_step()?.slip_distance();
        wear::archard(WEAR, history.pressure(), slip, &mut worn)?;
        history.set_gap(&worn)?;
        if let (Saved::To(file), SAVED) = (saved, history.steps()) {
            history.save(file)?;
        }
    }
    let [x, y] = history.traction();
    let fields = [
        history.pressure(),
        x,
        y,
        history.accumulated_slip(),
        history.unloaded_gap(),
    ];
    hash_of_all(ranks, &fields)
}

fn begun(bodies: &HalfSpace, gap: &Field) -> Outcome<History> {
    let builder = History::builder(bodies, gap, Friction::coulomb(FRICTION)?);
    let builder = builder.coupling(stickslip::Coupling::OneWay);
    Ok(builder.entry_rule(EntryRule::SinceTouch).build()?)
}
