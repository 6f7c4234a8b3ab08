//! Histories of every type satisfy the laws of mechanics in every step. Their results are invariant under changes of
//! units, swapped axes, mirroring and exchange of the bodies.

use std::panic::{AssertUnwindSafe, catch_unwind};

use kit::max_abs;
use kit::table::{Around, Measured, Scene, UnitTransform, scenes};
use stickslip::history::{EntryRule, LeadingEdge};
use stickslip::{Coupling, Field, TangentialControl, TangentialModel, Zone};

/// `Ok` if a scene satisfies a law, or a description of the violation.
pub(crate) type LawResult = Result<(), String>;

/// Asserts a law for all scenes, and lists the scenes that violate it.
pub(crate) fn assert_every(scenes: Vec<Scene>, mut law: impl FnMut(&Scene) -> LawResult) {
    let mut broken = Vec::new();
    for scene in scenes {
        let outcome = catch_unwind(AssertUnwindSafe(|| law(&scene)));
        let outcome = outcome.unwrap_or_else(|_| Err("panicked".to_owned()));
        if let Err(by) = outcome {
            broken.push(format!("{}: {by}", scene.name));
        }
    }
    assert!(broken.is_empty(), "violated by {broken:#?}");
}

/// Checks that numbers agree. Differences are relative to the largest number of each quantity.
pub(crate) fn compare_groups(one: &Measured, other: &Measured, tolerance: f64) -> LawResult {
    for ((name, a), (_, b)) in one.groups().into_iter().zip(other.groups()) {
        let scale = max_abs(a);
        for (i, (a, b)) in a.iter().zip(b).enumerate() {
            let difference = (a - b).abs() / scale;
            if a != b && (tolerance == 0.0 || difference.is_nan() || difference > tolerance) {
                return Err(format!("{name} {i}: {a:e}, {b:e} ({difference:e})"));
            }
        }
    }
    Ok(())
}

fn check_transformed(scene: &Scene, poses: &[UnitTransform], tolerance: f64) -> LawResult {
    let one = Measured::run(scene, &UnitTransform::IN_PLACE);
    let mut poses = poses.iter();
    poses.try_for_each(|pose| {
        let found = compare_groups(&one, &Measured::run(scene, pose), tolerance);
        found.map_err(|by| format!("{pose:?}: {by}"))
    })
}

/// Changes of units by powers of two cause no rounding. The campaign also uses other systems of units, which cause
/// rounding.
#[test]
fn scene_in_any_units_is_invariant() {
    assert_every(scenes(), |scene| {
        let exact = [(7, -30), (-10, 20), (-40, 3)];
        let exact = exact.map(|units| <[i32; 2]>::from(units).map(|power| 2_f64.powi(power)));
        let exact = exact.map(|[length, pressure]| UnitTransform::in_units(length, pressure));
        check_transformed(scene, &exact[..kit::thorough(1, 3)], 0.0)?;
        if kit::thorough(true, false) {
            return Ok(());
        }
        let others = [(1e-3, 1e9), (1e3, 1e-6), (1e-6, 1e5)];
        let others = others.map(|(length, pressure)| UnitTransform::in_units(length, pressure));
        check_transformed(scene, &others, round_off(scene))
    });
}

/// Returns the tolerance for solver residuals and round-off.
pub(crate) fn round_off(scene: &Scene) -> f64 {
    1e3 * scene.tolerance
}

#[test]
fn scene_swapped_and_mirrored_is_invariant() {
    assert_every(scenes(), |scene| {
        let pose = |swaps, signs| UnitTransform {
            swaps,
            signs,
            ..UnitTransform::IN_PLACE
        };
        // This reflection exchanges the axes and reverses both.
        let diagonal = pose(true, [-1.0, -1.0]);
        if scene.can_turn() && kit::thorough(true, false) {
            return check_transformed(scene, &[diagonal], round_off(scene));
        }
        let mirrors = [pose(false, [1.0, -1.0]), pose(false, [-1.0, 1.0])];
        let count = kit::thorough(1, 2);
        check_transformed(scene, &mirrors[..count], round_off(scene))?;
        if !scene.can_turn() {
            return Ok(());
        }
        let quarter_turn = pose(true, [-1.0, 1.0]);
        let axes = pose(true, [1.0, 1.0]);
        check_transformed(scene, &[quarter_turn, axes, diagonal], round_off(scene))
    });
}

/// All tangential quantities change their sign. The other quantities remain unchanged.
#[test]
fn scene_with_exchanged_bodies_is_invariant() {
    assert_every(scenes(), |scene| {
        let exchanged = UnitTransform {
            exchanges: true,
            ..UnitTransform::IN_PLACE
        };
        check_transformed(scene, &[exchanged], round_off(scene))
    });
}

/// Returns the text of `what` as an error if the condition is false.
pub(crate) fn check(holds: bool, what: impl FnOnce() -> String) -> LawResult {
    if holds { Ok(()) } else { Err(what()) }
}

/// The work of every step is stored or dissipated, and slip never generates energy.
#[test]
fn scene_work_is_stored_or_dissipated() {
    assert_every(scenes(), |scene| {
        let pose = UnitTransform::IN_PLACE;
        let mut history = scene.history(&scene.half_space(&pose), &pose);
        let (mut total, mut released) = (0.0, 0.0_f64);
        for (number, step) in scene.path.iter().enumerate() {
            scene.take(&mut history, step, &pose);
            let (taken, energy) = (
                history.last_step().unwrap(),
                history.last_step().unwrap().energy(),
            );
            let scale = energy.elastic_before.max(energy.elastic_after) + energy.work.abs();
            let what = || format!("step {number}: {energy:?}");
            check(energy.imbalance().abs() <= 1e-13 * scale, what)?;
            check(taken.dissipation().min() >= 0.0, what)?;
            let sums = [taken.dissipation(), taken.dissipation_midpoint()];
            let sums = sums.map(|field| field.as_slice().iter().sum::<f64>());
            let named = [energy.dissipated_energy, energy.dissipated_energy_midpoint];
            for (sum, named) in sums.into_iter().zip(named) {
                check((sum - named).abs() <= 1e-12 * scale, what)?;
            }
            if step.roll.is_some() {
                let is_rectangle = scene.around == Around::Nothing;
                let midpoint = energy.dissipated_energy_midpoint;
                check(!is_rectangle || midpoint >= -1e-9 * scale, what)?;
                let most = energy.work.abs().max(energy.elastic_after);
                check(energy.residual.abs() <= 1e-7 * most, what)?;
            } else if taken.normal_report().is_none() && scene.wear == 0.0 {
                // At constant pressure no energy is released, and the tolerance leaves only a negligible residual.
                check(taken.dissipation_midpoint().min() >= -1e-9 * scale, what)?;
                check(energy.released.abs() <= 1e-14 * scale, what)?;
                check(energy.residual.abs() <= 1e-6 * scale, what)?;
            }
            total += energy.dissipated_energy;
            released = released.max(energy.released);
        }
        // Cells that leave the contact release their energy.
        check(released > 0.0, || "no energy is released".to_owned())?;
        if scene.rolls() {
            return Ok(());
        }
        let sum: f64 = history.accumulated_dissipation().as_slice().iter().sum();
        check(total > 0.0 && (sum / total - 1.0).abs() < 1e-12, || {
            format!("{sum:e} of {total:e} is accumulated")
        })
    });
}

/// Accumulated slip and energy belong to particles. They move with the particles and leave the contact with them.
#[test]
fn scene_accumulated_slip_and_energy_move_with_particles() {
    assert_every(scenes(), |scene| {
        let pose = UnitTransform::IN_PLACE;
        let mut history = scene.history(&scene.half_space(&pose), &pose);
        let mut sums = [(); 2].map(|()| Field::zeros(history.grid()));
        for (number, step) in scene.path.iter().enumerate() {
            scene.take(&mut history, step, &pose);
            let cells = step.roll.map_or(0, |roll| roll.cells as isize);
            let [x, y] = match step.roll.map(|roll| roll.edge) {
                None | Some(LeadingEdge::PlusX) => [cells, 0],
                Some(LeadingEdge::MinusX) => [-cells, 0],
                Some(LeadingEdge::PlusY) => [0, cells],
                Some(LeadingEdge::MinusY) => [0, -cells],
            };
            let taken = history.last_step().unwrap();
            let steps = [taken.slip_distance(), taken.dissipation()];
            let found = [
                history.accumulated_slip(),
                history.accumulated_dissipation(),
            ];
            for ((sum, now), found) in sums.iter_mut().zip(steps).zip(found) {
                *sum = Field::from_indices(sum.grid(), |ix, iy| {
                    let from = ix.checked_add_signed(x).zip(iy.checked_add_signed(y));
                    let before = from.and_then(|(ix, iy)| sum.get(ix, iy));
                    before.unwrap_or(0.0) + now[(ix, iy)]
                });
                check(found == sum, || format!("step {number}"))?;
            }
        }
        check(sums[0].max() > 0.0, || "no slip".to_owned())
    });
}

/// Checks the pressure and the tractions at the end of a step, and the slip relative to the tractions.
#[test]
fn scene_satisfies_contact_and_friction_laws() {
    assert_every(scenes(), |scene| {
        let pose = UnitTransform::IN_PLACE;
        let mut history = scene.history(&scene.half_space(&pose), &pose);
        let grid = history.grid();
        let mut slipped = 0;
        for (number, step) in scene.path.iter().enumerate() {
            let load = scene.load(step, &pose);
            history.step(&load).map_err(|error| error.to_string())?;
            let (taken, pressed) = (history.last_step().unwrap(), history.normal());
            let largest = taken.slip_distance().max();
            let [sx, sy] = taken.slip();
            let [qx, qy] = history.traction();
            let overlap = 1e-8 * history.approach().abs();
            let forces = history.tangential_force();
            for (found, control) in forces.into_iter().zip(step.shear) {
                let TangentialControl::Force(asked) = control else {
                    continue;
                };
                check((found - asked).abs() <= 1e-8 * asked.abs(), || {
                    format!("step {number}: a force of {found:e} for {asked:e}")
                })?;
            }
            for (i, zone) in history.zones().iter().enumerate() {
                let at = |field: &Field| field.as_slice()[i];
                let (p, g) = (at(history.pressure()), at(pressed.gap()));
                let (q, s) = ([at(qx), at(qy)], [at(sx), at(sy)]);
                let size = q[0].hypot(q[1]);
                let limit = history.friction().limit(i, p);
                let what = |law: &str| {
                    let cell = [i % grid.nx(), i / grid.nx()];
                    format!("step {number}, {cell:?}, {zone:?}: {law}, {p:e} {g:e} {q:?} {s:?}")
                };
                check(p >= 0.0, || what("tensile"))?;
                check(scene.hardness.is_some() || g >= -overlap, || {
                    what("overlap")
                })?;
                let touches = p == 0.0 || g <= overlap;
                check(touches, || what("pressure across an open gap"))?;
                match zone {
                    Zone::Separated => {
                        check(p == 0.0 && size == 0.0, || what("loaded while separated"))?;
                    }
                    Zone::Stick => check(s == [0.0; 2] && size <= limit, || {
                        what("slip or overload in a stick cell")
                    })?,
                    Zone::Slip => {
                        slipped += 1;
                        check((size / limit - 1.0).abs() < 1e-11, || {
                            what("not at the friction limit")
                        })?;
                        let along = q[0] * s[0] + q[1] * s[1];
                        let across = q[0] * s[1] - q[1] * s[0];
                        let small = 1e-6 * largest * size;
                        check(along <= small, || what("slip along the traction"))?;
                        check(across.abs() <= small, || what("slip across the traction"))?;
                    }
                }
            }
            scene.wear(&mut history, &pose);
        }
        check(slipped >= scene.size[0], || format!("{slipped} cells slip"))
    });
}

/// Checks cells that were already in contact or follow the whole step. Their slip is the change of the displacement
/// minus the change of the rigid motion. The displacement is due to all tractions of the grid and to the strain. Half
/// of traction times displacement is the elastic energy.
#[test]
fn scene_slip_matches_relative_displacement() {
    assert_every(scenes(), |scene| {
        let bodies = scene.half_space(&UnitTransform::IN_PLACE);
        // With one-way coupling, the pressure also displaces the surfaces, which the displacement of the history
        // excludes.
        let is_coupled = bodies.pair().is_coupled();
        if is_coupled && scene.coupling == Coupling::OneWay {
            return Ok(());
        }
        let is_joint = is_coupled && scene.coupling == Coupling::Full;
        let pose = UnitTransform::IN_PLACE;
        let mut history = scene.history(&bodies, &pose);
        let grid = history.grid();
        let strain = scene.strain.unwrap_or_default();
        let mut stretched = 0.0;
        for (number, step) in scene.path.iter().enumerate() {
            let (before, shift) = (history.displacement().unwrap(), history.shift());
            let (twist, stretch) = (history.twist(), stretched);
            let touched = history.pressure().as_slice().to_vec();
            scene.take(&mut history, step, &pose);
            stretched = step.strain.unwrap_or(stretch);
            if step.roll.is_some() {
                continue;
            }
            let after = history.displacement().unwrap();
            let scale = after
                .iter()
                .map(|u| max_abs(u.as_slice()))
                .fold(0.0, f64::max);
            let turned = history.twist() - twist;
            let axes = match scene.model {
                TangentialModel::Scalar if !is_joint => 1,
                _ => 2,
            };
            for axis in 0..axes {
                for (i, zone) in history.zones().iter().enumerate() {
                    let is_new = touched[i] == 0.0 && scene.entry_rule == EntryRule::SinceTouch;
                    if *zone == Zone::Separated || is_new {
                        continue;
                    }
                    let [x, y] = [grid.x(i % grid.nx()), grid.y(i / grid.nx())];
                    let rigid = history.shift()[axis] - shift[axis] + turned * [-y, x][axis];
                    let bulk = (stretched - stretch) * (strain[axis][0] * x + strain[axis][1] * y);
                    let moved = after[axis].as_slice()[i] - before[axis].as_slice()[i];
                    let slip = history.last_step().unwrap().slip()[axis].as_slice()[i];
                    let error = (moved + bulk - rigid - slip).abs();
                    check(error <= 1e-6 * scale, || {
                        format!(
                            "step {number}, cell {i}, {zone:?}, axis {axis}: {slip:e} {error:e}"
                        )
                    })?;
                }
            }
            if is_joint {
                continue;
            }
            let pairs = history.traction().into_iter().zip(&after);
            let products = pairs.flat_map(|(q, u)| q.as_slice().iter().zip(u.as_slice()));
            let energy = 0.5 * grid.cell_area() * products.map(|(q, u)| q * u).sum::<f64>();
            let found = history.last_step().unwrap().energy().elastic_after;
            check((energy - found).abs() <= 1e-10 * found, || {
                format!("step {number}: energies of {energy:e} and {found:e}")
            })?;
        }
        Ok(())
    });
}
