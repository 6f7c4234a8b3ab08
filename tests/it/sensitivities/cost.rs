//! Products of sensitivities, and sensitivities on ranks.

use std::ops::ControlFlow;

use stickslip::coupled::CoupledProblemBuilder;
use stickslip::sensitivity::{Functional, Sensitivity, Weights};
use stickslip::stiffness::StiffnessWorkspace;
use stickslip::{
    Axis, Boundary, CellValue, CoupledProblem, Error, Field, Grid, HalfSpace, Iteration,
    NormalLoad, NormalProblem, TangentialLoad, TangentialModel, TangentialProblem,
};

use super::{Bodies, Surface, random_field};
use crate::rank_contacts::{assert_shared, by_cell};
use crate::rank_histories::{ball, friction};

/// Largest ratio of the products of a functional to the products of one column of the stiffness.
const ALLOWED: f64 = 1.5;

/// Returns an observer that counts its calls, one before each product.
fn counting(count: &mut f64) -> impl FnMut(&Iteration) -> ControlFlow<()> + Send {
    |_| {
        *count += 1.0;
        ControlFlow::Continue(())
    }
}

fn assert_cost(name: &str, column: f64, total: usize, found: &[Sensitivity]) {
    let most = ALLOWED * column;
    let own: Vec<usize> = found.iter().map(|found| found.report.products()).collect();
    assert!(
        own.iter().all(|&own| own as f64 <= most),
        "{name}: {own:?}, column {column}"
    );
    // The rest are the responses to the prescribed forces and the products that all functionals share.
    let shared = total - own.iter().sum::<usize>();
    let sums = match name {
        "coupled" => 3.0,
        "tangential" => 2.0,
        _ => 1.0,
    };
    assert!(
        shared as f64 <= sums * most,
        "{name}: {shared}, column {column}"
    );
}

#[test]
fn functional_costs_at_most_one_and_a_half_columns_of_stiffness() {
    let surface = Surface::sphere(Bodies::Equal, CellValue::Uniform);
    let (bodies, gap, load) = (surface.bodies(), &surface.gap, NormalLoad::Force(4.0));
    let workspace = &mut StiffnessWorkspace::new();
    let mut solver = kit::solver(NormalProblem::builder(&bodies, gap, load));
    let mut normal = solver.new_solution();
    solver.solve_into(&mut normal).unwrap();
    let mut column = 0.0;
    normal
        .stiffness_observed(&bodies, counting(&mut column))
        .unwrap();
    let weights = Weights::new().pressure(random_field(gap.grid(), 3));
    let functionals = [
        Functional::RMS_PRESSURE,
        Functional::ElasticEnergy,
        Functional::Weighted(weights),
    ];
    let go_on = |_: &Iteration| ControlFlow::Continue(());
    let found = solver.sensitivities_with(&normal, &functionals, workspace, go_on);
    assert_cost(
        "normal",
        column,
        workspace.report().products(),
        &found.unwrap(),
    );

    let friction = stickslip::Friction::coulomb(0.3).unwrap();
    let force = TangentialLoad::force([0.6, 0.3]);
    let problem = TangentialProblem::builder(&bodies, &normal, friction.clone(), force);
    let mut solver = kit::solver(problem.model(TangentialModel::Vector));
    let mut shear = solver.new_solution();
    solver.solve_into(&mut shear).unwrap();
    let mut columns = 0.0;
    shear
        .stiffness_observed(&bodies, counting(&mut columns))
        .unwrap();
    let functionals = [
        Functional::StickForce(Axis::X),
        Functional::ElasticEnergy,
        Functional::DissipatedEnergy,
        Functional::Shift(Axis::Y),
    ];
    let found = solver.sensitivities_with(&shear, &functionals, workspace, go_on);
    let total = workspace.report().products();
    assert_cost("tangential", columns / 6.0, total, &found.unwrap());

    let surface = Surface::sphere(Bodies::Homogeneous, CellValue::Uniform);
    let bodies = surface.bodies();
    let problem = CoupledProblem::builder(&bodies, gap, friction.clone(), load, force);
    let mut solver = kit::solver(problem);
    let mut contact = solver.new_solution();
    solver.solve_into(&mut contact).unwrap();
    let mut columns = 0.0;
    contact
        .stiffness_observed(&bodies, &friction, counting(&mut columns))
        .unwrap();
    let found = solver.sensitivities_with(&contact, &functionals, workspace, go_on);
    let total = workspace.report().products();
    assert_cost("coupled", columns / 8.0, total, &found.unwrap());
}

/// Returns the derivatives by cell and all other numbers.
fn parts(found: &[Sensitivity]) -> (Vec<f64>, Vec<f64>) {
    let fields = |found: &Sensitivity| {
        let fields = [&found.gap, &found.pressure, &found.friction];
        by_cell(fields.map(|field| field.as_ref().unwrap()))
    };
    let numbers = |found: &Sensitivity| {
        let options = [found.normal_load, found.twist, found.friction_coefficient];
        let options = options.into_iter().chain(found.tangential_load);
        let options = options.chain([found.contact_modulus]);
        let numbers: Vec<f64> = options.map(|number| number.unwrap_or(-1.0)).collect();
        [numbers, vec![found.value, found.report.products() as f64]].concat()
    };
    let cells = found.iter().map(fields).reduce(|sums, next| {
        // Fields of several functionals are combined, because the first list has a fixed number of values per cell.
        sums.iter().zip(&next).map(|(a, b)| a + 3.0 * b).collect()
    });
    (cells.unwrap(), found.iter().flat_map(numbers).collect())
}

#[test]
fn sensitivities_on_ranks_match_one_process() {
    let grid = Grid::new(128, 80, 0.2, 0.16).unwrap();
    let functionals = [
        Functional::DissipatedEnergy,
        Functional::PressureNorm { exponent: 6.0 },
    ];
    for model in [TangentialModel::Scalar, TangentialModel::Vector] {
        assert_shared(grid, Boundary::NonPeriodic, |bodies| {
            let (gap, load) = (ball(bodies), NormalLoad::Force(2.0));
            let mut press = kit::solver(NormalProblem::builder(bodies, &gap, load));
            let mut normal = press.new_solution();
            press.solve_into(&mut normal).unwrap();
            let force = TangentialLoad::force([0.3, 0.0]);
            let problem = TangentialProblem::builder(bodies, &normal, friction(bodies), force);
            let mut solver = kit::solver(problem.model(model));
            let mut shear = solver.new_solution();
            solver.solve_into(&mut shear).unwrap();
            let found = solver.sensitivities(&shear, &functionals).unwrap();
            parts(&press.chain(&normal, found).unwrap())
        });
    }
    assert_shared(grid, Boundary::NonPeriodic, |bodies: &HalfSpace| {
        let (gap, load) = (ball(bodies), NormalLoad::Force(2.0));
        let force = TangentialLoad::force([0.3, 0.0]);
        let problem: CoupledProblemBuilder =
            CoupledProblem::builder(bodies, &gap, friction(bodies), load, force);
        let mut solver = kit::solver(problem);
        let mut contact = solver.new_solution();
        solver.solve_into(&mut contact).unwrap();
        let mut found = solver.sensitivities(&contact, &functionals).unwrap();
        for found in &mut found {
            found.pressure = Some(Field::zeros(bodies.grid()));
        }
        parts(&found)
    });
}

/// Ranks that request different functionals receive an error.
#[test]
fn different_functionals_on_ranks_return_errors() {
    let grid = Grid::square(32, 6.0).unwrap();
    let outcomes =
        crate::rank_contacts::on_ranks(2, grid, Boundary::NonPeriodic, |bodies, rank| {
            let load = NormalLoad::Force(0.5);
            let mut press = kit::solver(NormalProblem::builder(bodies, ball(bodies), load));
            let mut normal = press.new_solution();
            press.solve_into(&mut normal).unwrap();
            let exponent = 2.0 + rank as f64;
            press.sensitivity(&normal, &Functional::PressureNorm { exponent })
        });
    assert!(
        outcomes
            .iter()
            .all(|found| matches!(found, Err(Error::Ranks(_))))
    );
}
