//! Tests of growing, rolling and worn contacts of coated bodies, and of their stiffness.

use kit::{max_difference, press};
use stickslip::history::{Rolling, wear};
use stickslip::layers::Layer;
use stickslip::{
    ElasticPair, Field, Grid, HalfSpace, History, LoadStep, Material, NormalLoad, TangentialModel,
};

const FRICTION: f64 = 0.5;

/// Creates bodies coated with a layer of `ratio` times the modulus of the substrate. The thickness is half the radius
/// of a contact of radius two.
fn coated_bodies(grid: Grid, ratio: f64, nu: f64) -> HalfSpace {
    let base = Material::new(1.0, nu).unwrap();
    let body = base.coated(&[Layer::new(ratio, nu, 1.0).unwrap()]).unwrap();
    HalfSpace::new(grid, ElasticPair::new(body, body).unwrap()).unwrap()
}

fn new_history(bodies: &HalfSpace, gap: &Field, model: TangentialModel) -> History {
    let builder = History::builder(bodies, gap, kit::coulomb(FRICTION)).model(model);
    builder.tolerance(1e-10).build().unwrap()
}

fn take_step(history: &mut History, load: LoadStep) {
    history.step(&load).unwrap();
    let energy = history.last_step().unwrap().energy();
    let size = energy.work.abs() + energy.elastic_before + energy.elastic_after;
    assert!(energy.imbalance().abs() <= 1e-10 * size, "{energy:?}");
}

/// Shear under an increasing load gives the same tractions in one step as in many, also on cells wider than a layer.
/// The entry rule uses the ratio of compliances for waves as short as the cells.
#[test]
fn coated_contact_grows_equally_in_any_steps() {
    for (ratio, thickness) in [(4.0, 0.3), (0.25, 0.3), (4.0, 4.0)] {
        let grid = kit::square(32, 32.0);
        let base = Material::new(1.0, 0.3).unwrap();
        let body = base
            .coated(&[Layer::new(ratio, 0.3, thickness).unwrap()])
            .unwrap();
        let bodies = HalfSpace::new(grid, ElasticPair::new(body, body).unwrap()).unwrap();
        let gap = kit::sphere(grid, 144.0);
        let tractions = |steps: usize| {
            let mut history = new_history(&bodies, &gap, TangentialModel::Scalar);
            take_step(
                &mut history,
                LoadStep::hold().normal(NormalLoad::Approach(0.4)),
            );
            for n in 1..=steps {
                let part = n as f64 / steps as f64;
                let load = NormalLoad::Approach(0.4 + 0.6 * part);
                take_step(
                    &mut history,
                    LoadStep::shift([0.15 * part, 0.0]).normal(load),
                );
            }
            history.traction()[0].clone()
        };
        let [one, four, many] = [1, 4, 32].map(tractions);
        let error = |found: &Field| {
            let both = found.as_slice().iter().zip(many.as_slice());
            both.map(|(a, b)| (a - b).abs()).sum::<f64>() / many.as_slice().iter().sum::<f64>()
        };
        assert!(error(&one) < 0.06 && error(&four) < 0.01);
    }
}

/// A layer of the substrate material has no effect on rolling and wear.
#[test]
fn layer_of_substrate_material_does_not_affect_rolling_and_wear() {
    let grid = kit::square(24, 6.0);
    let plain = Material::new(1.0, 0.3).unwrap();
    let plain = HalfSpace::new(grid, ElasticPair::new(plain, plain).unwrap()).unwrap();
    let results = [plain, coated_bodies(grid, 1.0, 0.3)].map(|bodies| {
        let mut gap = kit::sphere(grid, 10.0);
        let mut history = new_history(&bodies, &gap, TangentialModel::Vector);
        let load = || LoadStep::hold().normal(NormalLoad::Force(0.4));
        take_step(&mut history, load());
        for n in 0..3 {
            let load = LoadStep::hold().normal(NormalLoad::Force(0.4 + 0.1 * f64::from(n)));
            take_step(
                &mut history,
                load.roll(Rolling::new(1).creepage([0.02, 0.01])),
            );
        }
        let slip = history.last_step().unwrap().slip_distance().clone();
        wear::archard(0.5, history.pressure(), &slip, &mut gap).unwrap();
        history.set_gap(&gap).unwrap();
        take_step(&mut history, load());
        let [x, y] = history.traction();
        [history.pressure(), x, y].map(Clone::clone)
    });
    for (one, other) in results[0].iter().zip(&results[1]) {
        assert!(max_difference(one.as_slice(), other.as_slice()) < 1e-8);
    }
}

/// Wear of a coating follows Archard's law, and the pressure decreases.
#[test]
fn coating_wear_is_load_times_path() {
    let grid = kit::square(24, 6.0);
    let bodies = coated_bodies(grid, 4.0, 0.3);
    let gap = kit::sphere(grid, 10.0);
    let mut history = new_history(&bodies, &gap, TangentialModel::Scalar);
    take_step(
        &mut history,
        LoadStep::hold().normal(NormalLoad::Force(0.4)),
    );
    take_step(&mut history, LoadStep::shift([0.5, 0.0]));
    let before = history.pressure().max();
    take_step(&mut history, LoadStep::shift([0.7, 0.0]));
    let mut depth = Field::zeros(grid);
    let slip = history.last_step().unwrap().slip_distance();
    wear::archard(0.5, history.pressure(), slip, &mut depth).unwrap();
    assert!((depth.integral() / (0.5 * 0.4 * 0.2) - 1.0).abs() < 1e-9);
    let mut worn = gap.clone();
    worn.add_scaled(1.0, &depth).unwrap();
    history.set_gap(&worn).unwrap();
    let load = NormalLoad::Force(0.4);
    take_step(&mut history, LoadStep::shift([0.8, 0.0]).normal(load));
    assert!(history.pressure().max() < before);
}

/// The stiffness of a coated contact equals the finite difference of two solves, and a stiffer coating increases it.
#[test]
fn coated_stiffness_matches_finite_difference() {
    let grid = kit::square(32, 8.0);
    let gap = kit::sphere(grid, 12.0);
    let stiffness = [1.0, 4.0].map(|ratio| {
        let bodies = coated_bodies(grid, ratio, 0.3);
        let solve = |control| press(&bodies, &gap, control, 1e-12);
        let contact = solve(NormalLoad::Force(0.8));
        let stiffness = contact.stiffness(&bodies).unwrap();
        let step = 1e-6 * contact.approach();
        let [more, less] = [step, -step].map(|step| {
            let solution = solve(NormalLoad::Approach(contact.approach() + step));
            assert_eq!(solution.contact_cells(), contact.contact_cells());
            solution.force()
        });
        let slope = (more - less) / (2.0 * step);
        assert!((slope / stiffness.value - 1.0).abs() < 1e-6, "{slope:e}");
        stiffness.value
    });
    assert!(stiffness[1] > stiffness[0]);
}
