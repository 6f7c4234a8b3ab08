//! Twenty steps of a contact that wears, saved by all ranks after ten.

use std::path::PathBuf;

use stickslip::history::{EntryRule, wear};
use stickslip::ranks::Ranks;
use stickslip::{
    Axis, Field, Friction, HalfSpace, History, LoadStep, NormalControl, TangentialControl,
};

use crate::{FRICTION, Outcome, hash_of_all};

/// Steps, and after how many of them the history is saved.
const STEPS: u64 = 20;
const SAVED: u64 = 10;
/// Depth worn over pressure and slip (one over a pressure).
const WEAR: f64 = 0.05;

/// What is done with a file.
pub(crate) enum Saved {
    /// The history is saved in it on the way.
    To(PathBuf),
    /// The history begins from it, whatever number of ranks saved it.
    From(PathBuf),
}

/// Presses surfaces to and fro and slides them under a force that grows to this, and shifts across it; returns a hash
/// of the bits of the end.
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
            .normal(NormalControl::Force(normal))
            .tangential(Axis::X, TangentialControl::Force(part * normal));
        history.step(&load)?;
        let mut worn = history.gap().clone();
        let slip = history.last_step().slip_distance();
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
        history.gap(),
    ];
    hash_of_all(ranks, &fields)
}

fn begun(bodies: &HalfSpace, gap: &Field) -> Outcome<History> {
    let builder = History::builder(bodies, gap, Friction::coulomb(FRICTION)?);
    let builder = builder.coupling(stickslip::Coupling::OneWay);
    Ok(builder.entry_rule(EntryRule::SinceTouch).build()?)
}
