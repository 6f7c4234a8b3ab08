//! Steps of histories, with the past fixed.

use std::ops::ControlFlow;

use stickslip::history::Rolling;
use stickslip::sensitivity::{Functional, Sensitivity};
use stickslip::stiffness::StiffnessWorkspace;
use stickslip::{
    Axis, CellValue, Coupling, Error, Friction, History, Iteration, LoadStep, NormalControl,
    TangentialControl, TangentialLoad, TangentialModel,
};

use super::tangential::{Sets, ShearCase, Shown};
use super::{Bodies, Surface};

const SOLVE: f64 = 1e-12;

impl ShearCase {
    fn load(&self) -> LoadStep {
        let step = LoadStep::hold().normal(NormalControl::Force(self.force));
        let both = [Axis::X, Axis::Y].into_iter();
        let step = both.fold(step, |step, axis| {
            step.tangential(axis, self.load.control(axis))
        });
        match self.model {
            TangentialModel::Vector => step.twist(self.twist),
            _ => step,
        }
    }

    /// Returns a history after the steps of the past and one step of this case.
    fn history(&self, past: &[Self], coupling: Coupling) -> History {
        let (first, bodies) = (&past[0], past[0].surface.bodies());
        let builder = History::builder(&bodies, &first.surface.gap, first.friction());
        let builder = builder.model(self.model).coupling(coupling);
        let mut history = builder.tolerance(SOLVE).build().unwrap();
        for past in past {
            history.step(&past.load()).unwrap();
        }
        history.set_gap(&self.surface.gap).unwrap();
        history.set_friction(&self.friction()).unwrap();
        history.step(&self.load()).unwrap();
        history
    }

    fn assert_step_differences(
        &self,
        name: &str,
        past: &[Self],
        (coupling, has_gap): (Coupling, bool),
    ) {
        let values = |case: &Self| -> (Vec<f64>, Sets) {
            let history = case.history(past, coupling);
            let step = history.last_step().unwrap();
            let shown = Shown {
                energies: [step.energy().elastic_after, step.energy().dissipated_energy],
                traction: history.traction(),
                slip: step.slip(),
                zones: history.zones(),
                shift: history.shift(),
                force: history.tangential_force()[0],
            };
            case.values_from(history.normal(), &shown)
        };
        let history = self.history(past, coupling);
        let workspace = &mut StiffnessWorkspace::new();
        let go_on = |_: &Iteration| ControlFlow::Continue(());
        let found: Vec<Sensitivity> = history
            .sensitivities_with(&self.load(), &self.functionals(), workspace, go_on)
            .unwrap();
        let depth = if has_gap {
            history.normal().approach()
        } else {
            0.0
        };
        self.compare(name, &found, depth, &values);
    }
}

fn case(bodies: Bodies, force: f64, load: TangentialLoad, model: TangentialModel) -> ShearCase {
    let mut case = ShearCase::of(Surface::sphere(bodies, CellValue::Uniform), force, load);
    case.model = model;
    case
}

/// The contact shrinks in the last step, so that no cell comes into contact.
#[test]
fn derivatives_of_steps_match_differences() {
    for model in [TangentialModel::Scalar, TangentialModel::Vector] {
        for (bodies, coupling) in [
            (Bodies::Equal, Coupling::Neglected),
            (Bodies::Homogeneous, Coupling::OneWay),
        ] {
            let (y, twist) = match model {
                TangentialModel::Vector => (1.0, 1.0),
                _ => (0.0, 0.0),
            };
            let of = |force: f64, load: [f64; 2]| {
                case(bodies, force, TangentialLoad::force(load), model)
            };
            let past = [of(4.0, [0.0, 0.0]), of(4.0, [0.7, 0.2 * y])];
            let mut now = of(3.9, [0.2, 0.4 * y]);
            let name = format!("step, {model:?}, {bodies:?}");
            now.assert_step_differences(&name, &past, (coupling, true));
            let shift = now.history(&past, coupling).shift();
            now.load = TangentialLoad::shift(shift);
            now.twist = 0.0031 * twist;
            let name = format!("step under shift, {model:?}, {bodies:?}");
            now.assert_step_differences(&name, &past, (coupling, true));
        }
    }
}

/// Cells that come into contact follow the motion with their entry compliance.
#[test]
fn derivatives_of_growing_contacts_match_differences() {
    for model in [TangentialModel::Scalar, TangentialModel::Vector] {
        let of = |force: f64, load: [f64; 2]| {
            case(Bodies::Equal, force, TangentialLoad::force(load), model)
        };
        let past = [of(2.0, [0.0, 0.0])];
        let now = of(4.0, [0.9, 0.0]);
        let name = format!("growing, {model:?}");
        now.assert_step_differences(&name, &past, (Coupling::Neglected, false));
    }
}

#[test]
fn held_pressure_has_no_derivative_by_normal_load() {
    let load = TangentialLoad::force([0.5, 0.0]);
    let now = case(Bodies::Equal, 4.0, load, TangentialModel::Scalar);
    let past = [case(
        Bodies::Equal,
        4.0,
        TangentialLoad::force([0.0; 2]),
        TangentialModel::Scalar,
    )];
    let mut history = now.history(&past, Coupling::Neglected);
    let drag = LoadStep::hold().tangential(Axis::X, TangentialControl::Force(0.6));
    history.step(&drag).unwrap();
    let found = history
        .sensitivity(&drag, &Functional::Shift(Axis::X))
        .unwrap();
    assert!(found.normal_load.is_none() && found.gap.is_none() && found.pressure.is_some());
    let stiffness = history.stiffness().unwrap().tangential.loading[0][0].unwrap();
    assert!((found.tangential_load[0].unwrap() * stiffness - 1.0).abs() < 1e-9);
}

#[test]
fn steps_without_derivatives_return_errors() {
    let load = TangentialLoad::force([0.5, 0.0]);
    let now = case(Bodies::Equal, 4.0, load, TangentialModel::Vector);
    let past = [case(
        Bodies::Equal,
        4.0,
        TangentialLoad::force([0.0; 2]),
        TangentialModel::Vector,
    )];
    let history = now.history(&past, Coupling::Neglected);
    let functional = Functional::DissipatedEnergy;
    let rolled = now.load().roll(Rolling::new(1));
    let unsupported = |found: Result<Sensitivity, Error>| {
        assert!(matches!(found, Err(Error::UnsupportedByModel { .. })));
    };
    unsupported(history.sensitivity(&rolled, &functional));
    let bodies = now.surface.bodies();
    let restored = History::from_state(&bodies, history.state().clone()).unwrap();
    let found = restored.sensitivity(&now.load(), &functional);
    assert!(matches!(found, Err(Error::NoLastStep)));
    let mut changed = history.clone();
    changed
        .set_friction(&Friction::coulomb(0.7).unwrap())
        .unwrap();
    let found = changed.sensitivity(&now.load(), &functional);
    assert!(matches!(found, Err(Error::OutdatedSolution { .. })));
    let full = case(Bodies::Homogeneous, 4.0, load, TangentialModel::Vector);
    let full = full.history(std::slice::from_ref(&full), Coupling::Full);
    unsupported(full.sensitivity(&now.load(), &functional));
}
