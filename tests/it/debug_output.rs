//! The `Debug` output of a value has a few lines, on a grid of any size.

use std::fmt::Debug;

use stickslip::history::{AdaptiveSteps, Cycle};
use stickslip::influence::{Component, Table};
use stickslip::subsurface::{Body, Planes};
use stickslip::*;

/// Returns the `Debug` output of values of every type with samples per cell, on `n` x `n` cells.
fn debug_outputs(n: usize) -> Vec<String> {
    let mut all = Vec::new();
    let mut show = |value: &dyn Debug| all.push(format!("{value:?}"));
    let grid = Grid::square(n, 8.0).unwrap();
    let material = |modulus| Material::new(modulus, 0.3).unwrap();
    let on = |other| {
        let pair = ElasticPair::new(material(1.0), material(other)).unwrap();
        HalfSpace::new(grid, pair).unwrap()
    };
    let (bodies, dissimilar) = (on(1.0), on(3.0));
    let ball = surface::sphere(grid, 10.0).unwrap();
    let press = NormalLoad::Force(0.5);
    let load = TangentialLoad::force([0.05, 0.0]);
    let friction = Friction::per_cell(Field::constant(grid, 0.3)).unwrap();

    show(&bodies);
    show(&ball);
    show(&friction);
    show(
        &surface::SelfAffine::with_rms_height(0.1)
            .generate(grid)
            .unwrap(),
    );
    show(&Table::sample(grid, bodies.pair(), Component::ZZ).unwrap());

    let normal = NormalProblem::builder(&bodies, &ball, press)
        .build()
        .unwrap();
    let pressed = normal.solve().unwrap();
    show(&normal);
    show(&pressed);
    show(&pressed.spots().unwrap());
    show(&normal.into_solver().unwrap());

    let shear = TangentialProblem::builder(&bodies, &pressed, friction.clone(), load);
    let shear = shear.build().unwrap();
    let sheared = shear.solve().unwrap();
    show(&shear);
    show(&sheared);
    show(&shear.into_solver().unwrap());
    let mut planes = Planes::new(&bodies, &[0.5]).unwrap();
    show(&planes.solve(0, Body::One, (&pressed, &sheared)).unwrap());
    show(&planes);

    let both = CoupledProblem::builder(&dissimilar, &ball, friction.clone(), press, load);
    let both = both.build().unwrap();
    show(&both.solve().unwrap());
    show(&both);
    show(&both.into_solver().unwrap());

    for bodies in [&bodies, &dissimilar] {
        let history = History::builder(bodies, &ball, friction.clone());
        show(&history);
        let mut history = history.build().unwrap();
        let mut cycle = Cycle::new(&history);
        cycle.begin(&history).unwrap();
        history
            .step(&LoadStep::force([0.05, 0.0]).normal(press))
            .unwrap();
        cycle.add(&history).unwrap();
        show(&history);
        show(history.state());
        show(history.last_step().unwrap());
        show(&cycle);
        show(&AdaptiveSteps::new(&history, 0.1).unwrap());
    }
    all
}

#[test]
fn debug_output_does_not_grow_with_grid() {
    let (coarse, fine) = (debug_outputs(16), debug_outputs(64));
    assert_eq!(coarse.len(), fine.len());
    for (coarse, fine) in coarse.iter().zip(&fine) {
        assert!(fine.len() < 2000, "{fine}");
        assert!(fine.len() < coarse.len() + 200, "{coarse}\n{fine}");
    }
}

#[test]
fn debug_output_has_values_of_whole_field() {
    let grid = Grid::square(32, 8.0).unwrap();
    let field = Field::from_fn(grid, |x, y| x + y);
    let bounds = format!("min: {:?}, max: {:?}", field.min(), field.max());
    assert!(format!("{field:?}").contains(&bounds));
    let rubber = Material::new(1.0, 0.5).unwrap();
    let bodies =
        HalfSpace::new(grid, ElasticPair::new(rubber, Material::rigid()).unwrap()).unwrap();
    let ball = surface::sphere(grid, 10.0).unwrap();
    let problem = NormalProblem::builder(&bodies, &ball, NormalLoad::Force(0.5));
    let solution = kit::solve(problem);
    let output = format!("{solution:?}");
    for number in [
        format!("approach: {:?}", solution.approach()),
        format!("contact_cells: {}", solution.contact_cells()),
        String::from("converged"),
    ] {
        assert!(
            output.contains(&number),
            "{number} is missing from {output}"
        );
    }
}
