//! Normal contacts.

use stickslip::normal::Hardness;
use stickslip::sensitivity::{Functional, Weights};
use stickslip::stiffness::StiffnessWorkspace;
use stickslip::{
    Axis, Boundary, CellValue, Error, Field, Grid, HalfSpace, NormalLoad, NormalProblem,
    NormalSolution, NormalSolver, surface,
};

use super::{Bodies, Change, SOLVE, Surface, along, assert_differences, random_field};

#[derive(Debug, Clone)]
struct NormalCase {
    surface: Surface,
    load: NormalLoad,
    hardness: Option<f64>,
}

impl NormalCase {
    fn of(surface: Surface, force: f64) -> Self {
        Self {
            surface,
            load: NormalLoad::Force(force),
            hardness: None,
        }
    }

    /// Returns the case under the prescribed approach that the force causes.
    fn under_approach(&self) -> Self {
        let (_, contact) = self.solved();
        Self {
            load: NormalLoad::Approach(contact.approach()),
            ..self.clone()
        }
    }

    fn solver(&self) -> NormalSolver {
        let (bodies, gap) = (self.surface.bodies(), &self.surface.gap);
        let mut builder = NormalProblem::builder(&bodies, gap, self.load).tolerance(SOLVE);
        if let Some(hardness) = self.hardness {
            builder = builder.hardness(Hardness::uniform(hardness).unwrap());
        }
        kit::solver(builder)
    }

    /// Returns the solver and the solution. The tolerance may be below round-off.
    fn solved(&self) -> (NormalSolver, NormalSolution) {
        let mut solver = self.solver();
        let mut contact = solver.new_solution();
        solver.solve_into(&mut contact).unwrap();
        (solver, contact)
    }

    fn value(&self) -> f64 {
        match self.load {
            NormalLoad::Force(value) | NormalLoad::Approach(value) => value,
            _ => unreachable!(),
        }
    }

    fn moved(&self, inputs: &[(Input<'_>, f64)]) -> Self {
        let mut moved = self.clone();
        let surface = &mut moved.surface;
        for &(input, by) in inputs {
            match input {
                Input::Gap(direction) => surface.gap.add_scaled(by, direction).unwrap(),
                Input::Load => match &mut moved.load {
                    NormalLoad::Force(value) | NormalLoad::Approach(value) => *value += by,
                    _ => unreachable!(),
                },
                Input::Scale => surface.scale *= 1.0 + by,
                Input::PoissonRatio(body) => surface.poisson_ratios[body] += by,
            }
        }
        moved
    }

    fn functionals(&self) -> Vec<Functional> {
        let weights = Weights::new().pressure(random_field(self.surface.gap.grid(), 9));
        vec![
            Functional::PressureNorm { exponent: 8.0 },
            Functional::RMS_PRESSURE,
            Functional::ElasticEnergy,
            Functional::Weighted(weights.approach(0.3)),
            match self.load {
                NormalLoad::Force(_) => Functional::Approach,
                _ => Functional::NormalForce,
            },
        ]
    }

    /// Computes the values of [`Self::functionals`] from a solution.
    fn values(&self) -> (Vec<f64>, Vec<u8>) {
        let (_, contact) = self.solved();
        let pressure = contact.pressure().as_slice();
        let powers = |k: i32| pressure.iter().map(|p| p.powi(k)).sum::<f64>();
        let mean = |k: i32| (powers(k + 1) / powers(1)).powf(1.0 / f64::from(k));
        let weights = random_field(contact.grid(), 9);
        let values = vec![
            mean(8),
            mean(2),
            contact.elastic_energy(&self.surface.bodies()).unwrap(),
            along(Some(&weights), contact.pressure()) + 0.3 * contact.approach(),
            match self.load {
                NormalLoad::Force(_) => contact.approach(),
                _ => contact.force(),
            },
        ];
        let limit = self.hardness.unwrap_or(f64::INFINITY);
        let sets = pressure
            .iter()
            .map(|&p| u8::from(p > 0.0) + u8::from(p >= limit));
        (values, sets.collect())
    }

    fn assert_differences(&self, name: &str) {
        let (solver, contact) = self.solved();
        let found = solver.sensitivities(&contact, &self.functionals()).unwrap();
        let (values, _) = self.values();
        for (found, value) in found.iter().zip(values) {
            assert!(
                (found.value / value - 1.0).abs() < 1e-12,
                "{name}: {} {value}",
                found.value
            );
            assert!(found.report.is_converged());
        }
        let direction = random_field(contact.grid(), 5);
        let modulus = self.surface.bodies().pair().contact_modulus();
        let depth = contact.approach().abs();
        let mut changes = vec![
            Change::new("gap", Input::Gap(&direction), depth, |found| {
                along(found.gap.as_ref(), &direction)
            }),
            Change::new("load", Input::Load, self.value(), |found| {
                found.normal_load.unwrap()
            }),
            Change::new("modulus", Input::Scale, 1.0, |found| {
                modulus * found.contact_modulus.unwrap()
            }),
        ];
        if matches!(self.surface.bodies, Bodies::Homogeneous | Bodies::Equal) {
            changes.extend([0, 1].map(|body| {
                let input = Input::PoissonRatio(body);
                Change::new("Poisson's ratio", input, 1.0, move |found| {
                    found.poisson_ratio.unwrap()[body]
                })
            }));
        } else {
            assert!(found.iter().all(|found| found.poisson_ratio.is_none()));
        }
        let solved = |inputs: &[(Input<'_>, f64)]| self.moved(inputs).values();
        assert_differences(name, 2e-6, &found, &changes, solved);
    }
}

/// Input of a normal contact.
#[derive(Clone, Copy)]
enum Input<'a> {
    Gap(&'a Field),
    Load,
    Scale,
    PoissonRatio(usize),
}

#[test]
fn derivatives_of_smooth_contacts_match_differences() {
    for bodies in [Bodies::Homogeneous, Bodies::Coated, Bodies::Kernel] {
        for cell_value in [CellValue::Uniform, CellValue::Centre] {
            let case = NormalCase::of(Surface::sphere(bodies, cell_value), 4.0);
            case.assert_differences(&format!("{bodies:?} {cell_value:?}, force"));
            let case = case.under_approach();
            case.assert_differences(&format!("{bodies:?} {cell_value:?}, approach"));
        }
    }
}

#[test]
fn derivatives_of_rough_contacts_match_differences() {
    let grid = Grid::square(32, 64.0).unwrap();
    for boundary in kit::boundaries(grid) {
        for bodies in [Bodies::Homogeneous, Bodies::Coated] {
            if bodies == Bodies::Coated && boundary != Boundary::Periodic {
                continue;
            }
            let case = NormalCase::of(Surface::rough(bodies, boundary), 150.0);
            case.assert_differences(&format!("{bodies:?} {boundary:?}, force"));
            let case = case.under_approach();
            case.assert_differences(&format!("{bodies:?} {boundary:?}, approach"));
        }
    }
}

/// Cells at the hardness carry a constant pressure, but they move their surroundings.
#[test]
fn derivatives_of_yielding_contacts_match_differences() {
    let mut case = NormalCase::of(Surface::sphere(Bodies::Equal, CellValue::Uniform), 4.0);
    let (_, elastic) = case.solved();
    case.hardness = Some(0.7 * elastic.pressure().max());
    let (_, contact) = case.solved();
    assert!(contact.yielded_cells() > 10);
    case.assert_differences("hardness, force");
    case.under_approach()
        .assert_differences("hardness, approach");
}

fn ball_solver(load: NormalLoad) -> (NormalSolver, NormalSolution) {
    NormalCase {
        load,
        ..NormalCase::of(Surface::sphere(Bodies::Equal, CellValue::Uniform), 1.0)
    }
    .solved()
}

/// The derivative of the force with respect to the approach is the stiffness, and the derivative of the approach with respect to
/// the force is its reciprocal.
#[test]
fn derivative_of_force_is_stiffness() {
    let (solver, contact) = ball_solver(NormalLoad::Force(4.0));
    let bodies = Surface::sphere(Bodies::Equal, CellValue::Uniform).bodies();
    let stiffness = contact.stiffness(&bodies).unwrap().value;
    let found = solver.sensitivity(&contact, &Functional::Approach).unwrap();
    assert!((found.normal_load.unwrap() * stiffness - 1.0).abs() < 1e-9);
    let (solver, contact) = ball_solver(NormalLoad::Approach(contact.approach()));
    let found = solver
        .sensitivity(&contact, &Functional::NormalForce)
        .unwrap();
    assert!((found.normal_load.unwrap() / stiffness - 1.0).abs() < 1e-9);
}

/// Under a force, a uniform change of the gap shifts only the approach. Under an approach, it acts like the opposite change of
/// the approach.
#[test]
fn uniform_gap_acts_like_approach() {
    let (solver, contact) = ball_solver(NormalLoad::Force(4.0));
    let functionals = [Functional::Approach, Functional::RMS_PRESSURE];
    let found = solver.sensitivities(&contact, &functionals).unwrap();
    let sums = [0, 1].map(|n| {
        found[n]
            .gap
            .as_ref()
            .unwrap()
            .as_slice()
            .iter()
            .sum::<f64>()
    });
    assert!((sums[0] - 1.0).abs() < 1e-10 && sums[1].abs() < 1e-10 * found[1].value);
    let (solver, contact) = ball_solver(NormalLoad::Approach(contact.approach()));
    let found = solver
        .sensitivity(&contact, &Functional::RMS_PRESSURE)
        .unwrap();
    let sum: f64 = found.gap.as_ref().unwrap().as_slice().iter().sum();
    assert!((sum / found.normal_load.unwrap() + 1.0).abs() < 1e-10);
}

#[test]
fn bodies_apart_have_zero_derivatives_under_approach() {
    let (solver, contact) = ball_solver(NormalLoad::Approach(-0.1));
    let functionals = [Functional::RMS_PRESSURE, Functional::Approach];
    let found = solver.sensitivities(&contact, &functionals).unwrap();
    assert_eq!(kit::max_abs(found[0].gap.as_ref().unwrap().as_slice()), 0.0);
    assert_eq!(
        [found[0].normal_load, found[1].normal_load],
        [Some(0.0), Some(1.0)]
    );
    let (solver, contact) = ball_solver(NormalLoad::Force(0.0));
    let found = solver.sensitivity(&contact, &Functional::Approach);
    assert_eq!(found, Err(Error::EmptyContact));
}

#[test]
fn invalid_functionals_return_errors() {
    let (solver, contact) = ball_solver(NormalLoad::Force(4.0));
    let error = |functional: Functional| solver.sensitivity(&contact, &functional).unwrap_err();
    let other = Field::zeros(Grid::square(8, 1.0).unwrap());
    let mut infinite = Field::zeros(contact.grid());
    infinite.as_mut_slice()[7] = f64::INFINITY;
    let weighted = |field: &Field| Functional::Weighted(Weights::new().pressure(field.clone()));
    assert!(matches!(
        error(weighted(&other)),
        Error::GridMismatch { .. }
    ));
    assert!(matches!(
        error(weighted(&infinite)),
        Error::Sample { index: 7, .. }
    ));
    let mean = |exponent: f64| error(Functional::PressureNorm { exponent });
    assert!(matches!(mean(0.5), Error::BelowMinimum { .. }));
    assert!(matches!(mean(f64::INFINITY), Error::NotFinite { .. }));
    let unsupported = error(Functional::Shift(Axis::X));
    assert!(matches!(unsupported, Error::UnsupportedByModel { .. }));
}

#[test]
fn unfinished_or_foreign_solutions_return_errors() {
    let (mut solver, contact) = ball_solver(NormalLoad::Force(4.0));
    let functional = Functional::RMS_PRESSURE;
    let coated = Surface::sphere(Bodies::Coated, CellValue::Uniform);
    let foreign = NormalCase::of(coated, 4.0).solver();
    let found = foreign.sensitivity(&contact, &functional);
    assert!(matches!(found, Err(Error::MaterialMismatch { .. })));
    let settings = solver.settings().max_iterations(1);
    solver.set_settings(settings).unwrap();
    solver.reset();
    let mut unfinished = solver.new_solution();
    solver.solve_into(&mut unfinished).unwrap_err();
    let found = solver.sensitivity(&unfinished, &functional);
    assert!(matches!(found, Err(Error::NotConverged(_))));
    let mut calls = 0;
    let cancelled = solver.sensitivities_with(
        &contact,
        &[functional],
        &mut StiffnessWorkspace::new(),
        |_| {
            calls += 1;
            std::ops::ControlFlow::Break(())
        },
    );
    assert!(matches!(cancelled, Err(Error::NotConverged(_))) && calls == 1);
}

/// A contact with all cells at the hardness cannot resist a larger force.
#[test]
fn contact_at_capacity_has_no_derivative() {
    let grid = Grid::square(16, 4.0).unwrap();
    let bodies: HalfSpace = kit::unit_bodies(grid, 0.3);
    let gap = surface::sphere(grid, 20.0).unwrap();
    let force = NormalLoad::Force(0.01 * grid.area());
    let builder = NormalProblem::builder(&bodies, &gap, force);
    let mut solver = kit::solver(builder.hardness(Hardness::uniform(0.01).unwrap()));
    let mut contact = solver.new_solution();
    solver.solve_into(&mut contact).unwrap();
    assert_eq!(contact.yielded_cells(), grid.cells());
    let found = solver.sensitivity(&contact, &Functional::Approach);
    assert!(matches!(found, Err(Error::NotFinite { .. })));
}
