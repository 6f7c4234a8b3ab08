//! Coupled contacts.

use std::ops::ControlFlow;

use stickslip::normal::Hardness;
use stickslip::sensitivity::Functional;
use stickslip::stiffness::StiffnessWorkspace;
use stickslip::{
    CellValue, CoupledProblem, CoupledSolution, Grid, Iteration, NormalLoad, TangentialLoad, Zone,
};

use super::tangential::ShearCase;
use super::{Bodies, Surface};

const SOLVE: f64 = 1e-12;

impl ShearCase {
    fn coupled(&self, hardness: Option<f64>) -> (stickslip::CoupledSolver, CoupledSolution) {
        let (bodies, gap) = (self.surface.bodies(), &self.surface.gap);
        let (load, shear) = (NormalLoad::Force(self.force), self.tangential_load());
        let mut problem = CoupledProblem::builder(&bodies, gap, self.friction(), load, shear);
        if self.strain != 0.0 {
            problem = problem.relative_displacement(self.relative());
        }
        if let Some(hardness) = hardness {
            problem = problem.hardness(Hardness::uniform(hardness).unwrap());
        }
        let mut solver = kit::solver(problem.tolerance(SOLVE));
        let mut contact = solver.new_solution();
        solver.solve_into(&mut contact).unwrap();
        (solver, contact)
    }

    fn assert_coupled_differences(&self, name: &str, hardness: Option<f64>) {
        let values = |case: &Self| -> (Vec<f64>, Vec<Zone>) {
            let (_, contact) = case.coupled(hardness);
            let (normal, shear) = (contact.normal(), contact.tangential());
            case.values_of(contact.elastic_energy(), normal, shear)
        };
        let (solver, contact) = self.coupled(hardness);
        assert_eq!(contact.normal().yielded_cells() > 0, hardness.is_some());
        let workspace = &mut StiffnessWorkspace::new().poisson_ratio(true);
        let go_on = |_: &Iteration| ControlFlow::Continue(());
        let found = solver.sensitivities_with(&contact, &self.functionals(), workspace, go_on);
        let found = found.unwrap();
        self.compare(name, &found, contact.normal().approach(), &values);
    }
}

#[test]
fn derivatives_of_coupled_contacts_match_differences() {
    let force = TangentialLoad::force([0.4, 0.2]);
    let shift = TangentialLoad::shift([0.05, 0.02]);
    for (name, load) in [("force", force), ("shift", shift)] {
        let surface = Surface::sphere(Bodies::Homogeneous, CellValue::Uniform);
        let mut case = ShearCase::of(surface, 4.0, load);
        case.assert_coupled_differences(&format!("coupled, {name}"), None);
        case.twist = 0.01;
        case.strain = 0.005;
        case.cap = Some(0.02);
        let name = format!("coupled with twist, strain and cap, {name}");
        case.assert_coupled_differences(&name, None);
    }
}

#[test]
fn derivatives_of_coupled_coatings_match_differences() {
    let surface = Surface::sphere(Bodies::Coated, CellValue::Centre);
    let case = ShearCase::of(surface, 4.0, TangentialLoad::force([0.4, 0.2]));
    case.assert_coupled_differences("coupled coating", None);
}

#[test]
fn derivatives_of_coupled_rough_contacts_match_differences() {
    for boundary in kit::boundaries(Grid::square(32, 64.0).unwrap()) {
        let surface = Surface::rough(Bodies::Homogeneous, boundary);
        let case = ShearCase::of(surface, 150.0, TangentialLoad::force([20.0, 8.0]));
        case.assert_coupled_differences(&format!("coupled rough, {boundary:?}"), None);
    }
}

#[test]
fn derivatives_of_yielding_coupled_contacts_match_differences() {
    let surface = Surface::sphere(Bodies::Homogeneous, CellValue::Uniform);
    let case = ShearCase::of(surface, 4.0, TangentialLoad::force([0.4, 0.2]));
    let (_, elastic) = case.coupled(None);
    let hardness = 0.7 * elastic.normal().pressure().max();
    case.assert_coupled_differences("coupled at hardness", Some(hardness));
}

/// The derivatives of the forces with respect to the motions are the stiffness.
#[test]
fn derivatives_of_forces_are_coupled_stiffness() {
    let surface = Surface::sphere(Bodies::Homogeneous, CellValue::Uniform);
    let case = ShearCase::of(surface, 4.0, TangentialLoad::shift([0.05, 0.02]));
    let (solver, contact) = case.coupled(None);
    let stiffness = contact.stiffness(&case.surface.bodies(), &case.friction());
    let stiffness = stiffness.unwrap();
    let found = solver.sensitivity(&contact, &Functional::Approach).unwrap();
    // The approach under a constant force follows from the stiffness against the approach.
    assert!((found.normal_load.unwrap() * stiffness.normal.value - 1.0).abs() < 1e-8);
    let by_shift = -stiffness.normal_by_motion[0].unwrap() / stiffness.normal.value;
    assert!((found.tangential_load[0].unwrap() - by_shift).abs() < 1e-8);
}
