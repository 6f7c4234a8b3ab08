//! Closed-form solutions for comparison.

mod closed_form;
pub(crate) mod coordinates;
mod hertz;
mod no_slip;
mod partial_slip;
mod punches;
mod rolling;
mod rough;
mod shear;
mod wavy;
mod worn;

pub(crate) use hertz::{HertzEllipse, HertzLine, HertzSphere};
pub(crate) use no_slip::{NoSlipPunch, NoSlipSphere, SpencePressing};
pub(crate) use partial_slip::{
    CattaneoMindlin, CattaneoMindlinEllipse, CattaneoMindlinLine, ConePartialSlip,
};
pub(crate) use punches::{Cone, FlatPunch, RoundedPunch};
pub(crate) use rolling::{BentallJohnson, Carter, KalkerCoefficients, VermeulenJohnson};
pub(crate) use rough::{Persson, RoughSphere, linear_stick_ratio};
pub(crate) use shear::{LubkinTorsion, MindlinDeresiewicz, MindlinFullStick};
pub(crate) use wavy::{Westergaard, WestergaardPartialSlip};
pub(crate) use worn::PopovLimitingShape;
