//! Ball under prescribed approach and shift: resulting forces up to gross sliding.

#![allow(clippy::print_stdout, reason = "an example shows its numbers")]

mod support;

use std::error::Error;

use plotters::prelude::SeriesLabelPosition;
use stickslip::analytical::{CattaneoMindlin, HertzSphere};
use stickslip::{
    ElasticPair, Friction, Grid, HalfSpace, Material, NormalLoad, NormalProblem, TangentialLoad,
    TangentialProblem, surface,
};

// SI units: metres, newtons, pascals.
const BALL_RADIUS: f64 = 3.5e-3;
const NORMAL_FORCE: f64 = 100.0;
const TANGENTIAL_FORCE: f64 = 20.0;
const FRICTION: f64 = 0.5;

fn main() -> Result<(), Box<dyn Error>> {
    let steel = Material::new(213e9, 0.29)?;
    let pair = ElasticPair::new(steel, steel)?;
    let hertz = HertzSphere::new(&pair, BALL_RADIUS, NORMAL_FORCE)?;
    let friction_capacity = FRICTION * NORMAL_FORCE;
    let sliding_shift = CattaneoMindlin::new(hertz, FRICTION, friction_capacity)?.sliding_shift();

    // Press to the approach of Hertz's solution for 100 N.
    let grid = Grid::square(256, 3.0 * hertz.contact_radius())?;
    let bodies = HalfSpace::new(grid, pair)?;
    let ball = surface::sphere(grid, BALL_RADIUS)?;
    let load = NormalLoad::Approach(hertz.approach());
    let normal = NormalProblem::builder(&bodies, &ball, load)
        .build()?
        .solve()?;
    println!(
        "approach {:.4} µm: normal force {:.4} N, closed form {NORMAL_FORCE} N\n",
        normal.approach() * 1e6,
        normal.force(),
    );

    // The solver keeps its buffers and its last solution, which is the initial guess of the next solve.
    let friction = Friction::coulomb(FRICTION)?;
    let load = TangentialLoad::shift([0.0, 0.0]);
    let mut solver = TangentialProblem::builder(&bodies, &normal, friction, load)
        .build()?
        .into_solver()?;
    let mut tangential = solver.new_solution();

    // Until the whole contact slides, the closed forms are F = 1 - (1 - shift)^(3/2) and stick ratio = 1 - shift. Force and
    // shift are divided by their values at which the whole contact starts to slide.
    let exact_force = |shift: f64| 1.0 - (1.0 - shift).max(0.0).powf(1.5);
    let exact_stick = |shift: f64| (1.0 - shift).max(0.0);
    println!("shift /       |         force / (mu W)  |            stick ratio");
    println!("sliding shift |  computed | closed form |  computed | closed form | iterations");
    let mut forces = Vec::new();
    let mut stick_ratios = Vec::new();
    for step in 0..=13 {
        let fraction = f64::from(step) / 10.0;
        solver.set_load(TangentialLoad::shift([fraction * sliding_shift, 0.0]))?;
        solver.solve_into(&mut tangential)?;
        let force = tangential.force()[0] / friction_capacity;
        println!(
            "{fraction:>13.1} | {force:>9.6} | {:>11.6} | {:>9.5} | {:>11.5} | {:>10}{}",
            exact_force(fraction),
            tangential.stick_ratio(),
            exact_stick(fraction),
            tangential.report().iterations,
            if tangential.is_gross_slip() {
                "  gross sliding"
            } else {
                ""
            },
        );
        forces.push((fraction, force));
        stick_ratios.push((fraction, tangential.stick_ratio()));
    }

    // Return to the shift of the Cattaneo-Mindlin solution for 20 N. Each solve is a first loading.
    let exact = CattaneoMindlin::new(hertz, FRICTION, TANGENTIAL_FORCE)?;
    solver.set_load(TangentialLoad::shift([exact.shift(), 0.0]))?;
    solver.solve_into(&mut tangential)?;
    println!(
        "\nshift {:.4} µm: tangential force {:.4} N, closed form {TANGENTIAL_FORCE} N",
        tangential.shift()[0] * 1e6,
        tangential.force()[0],
    );

    let path = support::gallery("shift_control.svg")?;
    let title = "Steel ball on steel under a prescribed shift";
    let figure = support::figure(&path, (2 * support::PANEL, 1400), title)?;
    let area = support::heading(&figure, support::COMPARED)?;
    let mut chart = support::axes(
        &area,
        (0.0..1.35, "shift / sliding shift"),
        (0.0..1.1, "F / µW and stick ratio"),
    )?;
    let line = |f: &dyn Fn(f64) -> f64| -> Vec<(f64, f64)> {
        (0..=54)
            .map(|i| f64::from(i) / 40.0)
            .map(|shift| (shift, f(shift)))
            .collect()
    };
    let (blue, orange) = (support::BLUE, support::ORANGE);
    support::compare(&mut chart, "force", blue, line(&exact_force), forces)?;
    support::compare(
        &mut chart,
        "stick ratio",
        orange,
        line(&exact_stick),
        stick_ratios,
    )?;
    support::legend(&mut chart, SeriesLabelPosition::MiddleRight)?;
    figure.present()?;
    println!("\nfigure: {}", path.display());
    Ok(())
}
