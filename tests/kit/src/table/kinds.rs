//! Table of scenes.

use stickslip::NormalControl::{Approach, Force};
use stickslip::history::{EntryRule, LeadingEdge};
use stickslip::{CellValue, Coupling, NormalControl, TangentialControl, TangentialModel};

use super::{Around, Coating, Roll, Scene, Step};

const HOLD: TangentialControl = TangentialControl::Hold;

/// Equal bodies of unit contact modulus.
const ALIKE: [(f64, f64); 2] = [(1.82, 0.3), (1.82, 0.3)];
/// Dissimilar bodies, the first of which is softer.
const UNLIKE: [(f64, f64); 2] = [(1.0, 0.1), (6.0, 0.35)];
const ON_RIGID: [(f64, f64); 2] = [(1.0, 0.0), (f64::INFINITY, 0.0)];

/// Returns the gap of a ball off the centre, without symmetry.
fn ball(x: f64, y: f64) -> f64 {
    0.05 * ((x - 0.1).powi(2) + 0.8 * (y + 0.07).powi(2) + 0.1 * x * y)
}

/// Returns the gap of the ball with bumps.
fn bumpy(x: f64, y: f64) -> f64 {
    ball(x, y) + 0.004 * (7.0 * x + 3.0 * y).sin() + 0.003 * (2.0 * x - 8.0 * y).cos()
}

/// Returns the gap of many asperities, of which a light load brings few into contact.
fn asperities(x: f64, y: f64) -> f64 {
    let [one, two] = [19.0 * x + 5.0 * y, 17.0 * y - 8.0 * x];
    0.012 * (2.0 + one.sin() + two.cos() + 0.4 * (13.0 * x - 14.0 * y).sin())
}

fn waves(x: f64, y: f64) -> f64 {
    0.02 * (2.0 + (3.1 * x).sin() * (2.3 * y).cos() + (4.1 * x + 2.7 * y).sin())
}

fn roller(x: f64, y: f64) -> f64 {
    0.05 * x * x + 0.003 * (3.0 * y).sin() * x
}

fn patches(x: f64, y: f64) -> f64 {
    0.1 * (2.0 * x + y).sin()
}

fn hard(x: f64, y: f64) -> f64 {
    0.04 + 0.003 * x - 0.002 * y
}

fn step(normal: NormalControl, x: TangentialControl, y: TangentialControl) -> Step {
    Step {
        normal,
        shear: [x, y],
        twist: None,
        strain: None,
        roll: None,
    }
}

fn spring(position: f64, stiffness: f64) -> TangentialControl {
    TangentialControl::Spring {
        position,
        stiffness,
    }
}

/// Returns a path along x with pressing, shear, reversal, further pressing, a spring and unloading.
fn to_and_fro(load: f64) -> Vec<Step> {
    use TangentialControl::{Force as Pull, Shift};
    vec![
        step(Force(0.5 * load), HOLD, HOLD),
        step(Force(load), Pull(0.17 * load), HOLD),
        step(NormalControl::Hold, Pull(-0.15 * load), HOLD),
        step(Force(0.7 * load), Shift(0.01), HOLD),
        step(Force(1.3 * load), spring(-0.04, 0.8), HOLD),
        step(Force(0.4 * load), HOLD, HOLD),
    ]
}

/// Returns a path in all directions with a separation in between.
fn around(load: f64) -> Vec<Step> {
    use TangentialControl::{Force as Pull, Shift};
    vec![
        step(Force(0.5 * load), HOLD, HOLD),
        step(Force(load), Pull(0.15 * load), Pull(-0.1 * load)),
        step(NormalControl::Hold, Shift(-0.008), Pull(0.12 * load)),
        step(Force(1.2 * load), spring(0.03, 0.8), spring(-0.02, 0.5)),
        step(Force(0.5 * load), Pull(-0.05 * load), HOLD),
        step(Force(0.0), HOLD, HOLD),
        step(Force(0.8 * load), Shift(0.006), Shift(0.004)),
    ]
}

/// Returns a path that rolls one or two cells at prescribed creepages or forces, with one step at rest.
fn rolling(load: f64, edge: LeadingEdge, creepage: [f64; 2], spin: f64) -> Vec<Step> {
    use TangentialControl::Force as Pull;
    let rolled = |cells: usize, creepage: [f64; 2], step: Step| {
        let roll = Some(Roll {
            cells,
            edge,
            creepage,
            spin,
        });
        Step { roll, ..step }
    };
    // A step prescribes the force or the creepage along an axis.
    let [pull, push] = [0.09, -0.07].map(|part| {
        let axis = |across: bool| {
            if across {
                creepage[0] == 0.0
            } else {
                creepage[0] != 0.0
            }
        };
        [false, true].map(|y| if axis(y) { Pull(part * load) } else { HOLD })
    });
    let other = if creepage[0] == 0.0 {
        [0.0; 2]
    } else {
        [0.0, creepage[1]]
    };
    vec![
        step(Force(0.8 * load), HOLD, HOLD),
        rolled(1, creepage, step(Force(load), HOLD, HOLD)),
        rolled(2, creepage, step(NormalControl::Hold, HOLD, HOLD)),
        rolled(1, other, step(Force(1.1 * load), pull[0], pull[1])),
        step(Force(0.9 * load), push[0], push[1]),
        rolled(1, creepage, step(Force(0.5 * load), HOLD, HOLD)),
    ]
}

/// Adds these amounts of twist to the steps.
fn twisted(mut path: Vec<Step>, twists: &[f64]) -> Vec<Step> {
    for (step, twist) in path.iter_mut().zip(twists) {
        step.twist = Some(*twist);
    }
    path
}

/// Adds these amounts of strain to the steps.
fn strained(mut path: Vec<Step>, amounts: &[f64]) -> Vec<Step> {
    for (step, amount) in path.iter_mut().zip(amounts) {
        step.strain = Some(*amount);
    }
    path
}

const TWISTS: [f64; 6] = [0.0, 0.01, 0.02, -0.015, 0.0, 0.0];
const STRAINS: [f64; 6] = [0.0, 0.004, 0.01, -0.006, 0.002, 0.0];

/// Returns the basic scene, which the other scenes modify: a bumpy ball between equal bodies, sheared along x.
fn scalar(name: &'static str) -> Scene {
    Scene {
        name,
        size: [18, 15],
        sides: [0.13, 0.15],
        around: Around::Nothing,
        bodies: ALIKE,
        coatings: [None; 2],
        is_kernel: false,
        cell_value: CellValue::Uniform,
        gap: bumpy,
        friction: 0.4,
        slippery: None,
        shear_strength: f64::INFINITY,
        model: TangentialModel::Scalar,
        coupling: Coupling::Full,
        entry_rule: EntryRule::SinceTouch,
        hardness: None,
        is_set_permanent: false,
        strain: None,
        wear: 0.0,
        tolerance: 1e-10,
        path: to_and_fro(0.06),
    }
}

/// Returns a scene in the vector model with twist.
fn plane(name: &'static str) -> Scene {
    Scene {
        model: TangentialModel::Vector,
        path: twisted(around(0.06), &TWISTS),
        ..scalar(name)
    }
}

/// Returns a fully coupled scene of dissimilar bodies with twist.
fn coupled(name: &'static str) -> Scene {
    Scene {
        bodies: UNLIKE,
        ..plane(name)
    }
}

/// Returns waves on a periodic grid, without twist.
fn repeating(scene: &Scene, load: f64) -> Scene {
    Scene {
        around: Around::Everywhere,
        gap: waves,
        path: match scene.model {
            TangentialModel::Vector => around(load),
            _ => to_and_fro(load),
        },
        ..*scene
    }
}

/// Returns scattered spots on a grid that is large enough for the sparse inverse.
fn scattered(scene: &Scene, load: f64) -> Scene {
    Scene {
        size: [76, 70],
        sides: [0.04, 0.042],
        gap: asperities,
        path: match scene.model {
            TangentialModel::Vector => around(load),
            _ => to_and_fro(load),
        },
        ..*scene
    }
}

/// Returns a contact that is large, then small, and large again.
fn shrinking(scene: &Scene) -> Scene {
    let press = |approach, shift| step(Approach(approach), TangentialControl::Shift(shift), HOLD);
    let steps = [
        (0.07, 0.005),
        (0.004, -0.001),
        (0.004, 0.0008),
        (0.005, -0.0004),
        (0.07, 0.01),
        (0.006, 0.009),
    ];
    Scene {
        size: [44, 40],
        sides: [0.055, 0.06],
        gap: ball,
        entry_rule: EntryRule::WholeStep,
        path: steps.map(|(approach, shift)| press(approach, shift)).into(),
        ..*scene
    }
}

/// Returns a scene that rolls, with a smaller tolerance.
fn rolled(scene: &Scene, edge: LeadingEdge, creepage: [f64; 2], spin: f64) -> Scene {
    Scene {
        tolerance: 1e-12,
        path: rolling(0.02, edge, creepage, spin),
        ..*scene
    }
}

/// Stiff and compliant coatings.
const STIFF: Option<Coating> = Some((4.0, 0.2, 0.3));
const COMPLIANT: Option<Coating> = Some((0.5, 0.45, 0.2));

/// Returns histories of every kind.
#[rustfmt::skip] // one scene per line
pub fn scenes() -> Vec<Scene> {
    use LeadingEdge::{MinusX, MinusY, PlusX, PlusY};
    let [one_way, neglected] = [Coupling::OneWay, Coupling::Neglected];
    let strain = Some([[1.0, 0.2], [0.1, -0.3]]);
    let stretch = Some([[1.0, 0.0], [0.0, 0.0]]);
    let line = |scene: Scene| Scene {
        size: [24, 1],
        sides: [0.09, 1.0],
        around: Around::Line,
        gap: roller,
        ..scene
    };
    let rows = |scene: Scene| Scene {
        around: Around::AlongY,
        gap: roller,
        ..scene
    };
    vec![
        scalar("scalar"),
        Scene { slippery: Some(patches), ..scalar("friction of each cell") },
        Scene { shear_strength: 0.01, ..scalar("shear strength") },
        Scene { wear: 1.0, ..scalar("wear") },
        Scene { hardness: Some(hard), ..scalar("hardness") },
        Scene { hardness: Some(hard), is_set_permanent: true, ..scalar("permanent set") },
        Scene { size: [9, 40], sides: [0.26, 0.055], ..scalar("slender cells") },
        shrinking(&scalar("shrinking")),
        repeating(&scalar("repeating"), 0.1),
        scattered(&scalar("scattered"), 0.1),
        rows(Scene { path: to_and_fro(0.09), ..scalar("rows") }),
        line(Scene { path: to_and_fro(0.04), ..scalar("line") }),
        line(Scene { strain: stretch, path: strained(to_and_fro(0.04), &STRAINS), ..scalar("strained line") }),
        Scene { bodies: UNLIKE, coupling: one_way, ..scalar("one way") },
        Scene { bodies: UNLIKE, coupling: neglected, ..scalar("coupling neglected") },
        plane("plane"),
        Scene { slippery: Some(patches), shear_strength: 0.012, ..plane("plane, friction of each cell") },
        Scene { hardness: Some(hard), is_set_permanent: true, ..plane("plane, permanent set") },
        Scene { wear: 1.0, ..plane("plane, wear") },
        Scene { strain, path: strained(around(0.06), &STRAINS), ..plane("plane, strained") },
        Scene { bodies: UNLIKE, coupling: one_way, ..plane("plane, one way") },
        shrinking(&plane("plane, shrinking")),
        repeating(&plane("plane, repeating"), 0.1),
        scattered(&plane("plane, scattered"), 0.1),
        rows(Scene { path: around(0.09), ..plane("plane, rows") }),
        coupled("coupled"),
        Scene { bodies: ON_RIGID, gap: ball, entry_rule: EntryRule::WholeStep, ..coupled("on a rigid body") },
        Scene { wear: 1.0, slippery: Some(patches), ..coupled("coupled, wear") },
        Scene { hardness: Some(hard), ..coupled("coupled, hardness") },
        Scene { hardness: Some(hard), is_set_permanent: true, ..coupled("coupled, permanent set") },
        Scene { strain, path: strained(around(0.06), &STRAINS), ..coupled("coupled, strained") },
        shrinking(&coupled("coupled, shrinking")),
        repeating(&coupled("coupled, repeating"), 0.1),
        rows(Scene { path: around(0.09), ..coupled("coupled, rows") }),
        line(Scene { path: around(0.04), ..coupled("coupled, line") }),
        rolled(&scalar("rolled"), PlusX, [0.02, 0.0], 0.0),
        rolled(&scalar("rolled along y"), MinusY, [0.03, 0.0], 0.0),
        rolled(&rows(scalar("rows, rolled")), MinusX, [-0.02, 0.0], 0.0),
        rolled(&line(scalar("line, rolled")), PlusX, [0.15, 0.0], 0.0),
        rolled(&plane("plane, rolled"), MinusX, [0.03, -0.02], 0.03),
        rolled(&Scene { entry_rule: EntryRule::WholeStep, ..plane("plane, rolled whole steps") }, PlusY, [0.02, 0.02], -0.02),
        rolled(&Scene { bodies: UNLIKE, coupling: one_way, ..plane("plane, rolled one way") }, PlusX, [0.02, 0.01], 0.02),
        rolled(&coupled("coupled, rolled"), MinusY, [0.02, -0.02], 0.02),
        Scene { coatings: [STIFF; 2], ..scalar("coated") },
        Scene { coatings: [STIFF; 2], wear: 1.0, ..plane("plane, coated") },
        Scene { coatings: [STIFF, COMPLIANT], ..coupled("coupled, coated") },
        Scene { coatings: [STIFF; 2], is_kernel: true, ..scalar("kernel") },
        Scene { bodies: ON_RIGID, coatings: [STIFF, None], is_kernel: true, ..coupled("coupled, kernel") },
        Scene { cell_value: CellValue::Centre, ..plane("plane, centre values") },
        Scene { cell_value: CellValue::Centre, ..coupled("coupled, centre values") },
    ]
}
