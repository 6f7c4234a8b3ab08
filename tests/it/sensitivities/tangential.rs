//! Tangential contacts, chained to the normal contacts that supply their pressure.

use std::ops::ControlFlow;

use stickslip::sensitivity::{Functional, Sensitivity, Weights};
use stickslip::stiffness::StiffnessWorkspace;
use stickslip::tangential::RelativeDisplacement;
use stickslip::{
    Axis, CellValue, Error, Field, Friction, Grid, HalfSpace, Iteration, NormalLoad, NormalProblem,
    NormalSolution, NormalSolver, TangentialControl, TangentialLoad, TangentialModel,
    TangentialProblem, TangentialSolution, TangentialSolver, Zone,
};

use super::{Bodies, Change, Surface, along, assert_differences, random_field};

const SOLVE: f64 = 1e-12;

/// Contact that is pressed and sheared.
#[derive(Debug, Clone)]
pub(super) struct ShearCase {
    pub(super) surface: Surface,
    pub(super) force: f64,
    pub(super) coefficients: Field,
    pub(super) cap: Option<f64>,
    pub(super) load: TangentialLoad,
    pub(super) twist: f64,
    pub(super) model: TangentialModel,
    pub(super) strain: f64,
}

/// Zone of each cell, and whether its friction limit is at the cap.
pub(super) type Sets = Vec<(Zone, bool)>;

/// Results from which values are computed.
pub(super) struct Shown<'a> {
    /// Elastic and dissipated energy.
    pub(super) energies: [f64; 2],
    pub(super) traction: [&'a Field; 2],
    pub(super) slip: [&'a Field; 2],
    pub(super) zones: &'a [Zone],
    pub(super) shift: [f64; 2],
    /// Force along x.
    pub(super) force: f64,
}

/// Input that a test changes.
#[derive(Debug, Clone, Copy)]
enum Input<'a> {
    Gap(&'a Field),
    NormalLoad,
    Load(Axis),
    Twist,
    Friction(&'a Field),
    Coefficient,
    Scale,
    PoissonRatio(usize),
}

impl ShearCase {
    pub(super) fn of(surface: Surface, force: f64, load: TangentialLoad) -> Self {
        let grid = surface.gap.grid();
        Self {
            surface,
            force,
            coefficients: Field::constant(grid, 0.3),
            cap: None,
            load,
            twist: 0.0,
            model: TangentialModel::Vector,
            strain: 0.0,
        }
    }

    pub(super) fn friction(&self) -> Friction {
        let friction = Friction::per_cell(self.coefficients.clone()).unwrap();
        match self.cap {
            Some(cap) => friction.max_shear_stress(cap).unwrap(),
            None => friction,
        }
    }

    pub(super) fn relative(&self) -> RelativeDisplacement {
        let strain = [[self.strain, 0.0], [0.0, 0.0]];
        RelativeDisplacement::bulk_strain(self.surface.gap.grid(), strain).unwrap()
    }

    pub(super) fn tangential_load(&self) -> TangentialLoad {
        self.load.twist(self.twist)
    }

    fn pressed(&self, bodies: &HalfSpace) -> (NormalSolver, NormalSolution) {
        let load = NormalLoad::Force(self.force);
        let problem = NormalProblem::builder(bodies, &self.surface.gap, load);
        let mut solver = kit::solver(problem.tolerance(super::SOLVE));
        let mut contact = solver.new_solution();
        solver.solve_into(&mut contact).unwrap();
        (solver, contact)
    }

    fn sheared(
        &self,
        bodies: &HalfSpace,
        contact: &NormalSolution,
    ) -> (TangentialSolver, TangentialSolution) {
        let (friction, load) = (self.friction(), self.tangential_load());
        let mut problem = TangentialProblem::builder(bodies, contact, friction, load)
            .model(self.model)
            .tolerance(SOLVE);
        if self.strain != 0.0 {
            problem = problem.relative_displacement(self.relative());
        }
        let mut solver = kit::solver(problem);
        let mut shear = solver.new_solution();
        solver.solve_into(&mut shear).unwrap();
        (solver, shear)
    }

    fn moved(&self, inputs: &[(Input<'_>, f64)]) -> Self {
        let mut moved = self.clone();
        for &(input, by) in inputs {
            match input {
                Input::Gap(direction) => moved.surface.gap.add_scaled(by, direction).unwrap(),
                Input::NormalLoad => moved.force += by,
                Input::Load(axis) => {
                    let mut control = moved.load.control(axis);
                    match &mut control {
                        TangentialControl::Force(value)
                        | TangentialControl::Shift(value)
                        | TangentialControl::Spring {
                            position: value, ..
                        } => *value += by,
                        _ => unreachable!(),
                    }
                    moved.load = moved.load.along(axis, control);
                }
                Input::Twist => moved.twist += by,
                Input::Friction(direction) => {
                    moved.coefficients.add_scaled(by, direction).unwrap();
                }
                Input::Coefficient => {
                    for value in moved.coefficients.as_mut_slice() {
                        *value += by;
                    }
                }
                Input::Scale => moved.surface.scale *= 1.0 + by,
                Input::PoissonRatio(body) => moved.surface.poisson_ratios[body] += by,
            }
        }
        moved
    }

    fn value(&self, axis: Axis) -> f64 {
        match self.load.control(axis) {
            TangentialControl::Force(value)
            | TangentialControl::Shift(value)
            | TangentialControl::Spring {
                position: value, ..
            } => value,
            _ => 0.0,
        }
    }

    pub(super) fn weights(&self) -> Weights {
        let fields = |seed: u64| [seed, seed + 1].map(|n| random_field(self.surface.gap.grid(), n));
        let [along_x, along_y] = fields(20);
        let traction = match self.model {
            TangentialModel::Vector => [along_x, along_y],
            _ => [along_x, Field::zeros(self.surface.gap.grid())],
        };
        Weights::new()
            .pressure(random_field(self.surface.gap.grid(), 9))
            .traction(traction)
            .slip(fields(30))
            .shift([0.7, -0.4])
    }

    pub(super) fn functionals(&self) -> Vec<Functional> {
        vec![
            Functional::ElasticEnergy,
            Functional::StickForce(Axis::X),
            Functional::DissipatedEnergy,
            Functional::Weighted(self.weights()),
            Functional::PressureNorm { exponent: 4.0 },
            match self.load.control(Axis::X) {
                TangentialControl::Force(_) => Functional::Shift(Axis::X),
                _ => Functional::TangentialForce(Axis::X),
            },
        ]
    }

    /// Computes the values of [`Self::functionals`] and the sets from solutions.
    pub(super) fn values_of(
        &self,
        energy: f64,
        normal: &NormalSolution,
        shear: &TangentialSolution,
    ) -> (Vec<f64>, Sets) {
        let shown = Shown {
            energies: [energy, shear.dissipated_energy()],
            traction: shear.traction(),
            slip: shear.slip(),
            zones: shear.zones(),
            shift: shear.shift(),
            force: shear.force()[0],
        };
        self.values_from(normal, &shown)
    }

    pub(super) fn values_from(
        &self,
        normal: &NormalSolution,
        shear: &Shown<'_>,
    ) -> (Vec<f64>, Sets) {
        let grid = normal.grid();
        let sum = |seed: u64, field: &Field| along(Some(&random_field(grid, seed)), field);
        let [qx, qy] = shear.traction;
        let [sx, sy] = shear.slip;
        let [dx, dy] = shear.shift;
        let weighted = sum(9, normal.pressure()) + sum(20, qx) + sum(21, qy) + sum(30, sx);
        let weighted = weighted + sum(31, sy) + 0.7 * dx - 0.4 * dy;
        let zones = shear.zones.iter().zip(qx.as_slice());
        let sticking = zones.filter(|(zone, _)| **zone == Zone::Stick);
        let pressure = normal.pressure().as_slice();
        let powers = |k: i32| pressure.iter().map(|p| p.powi(k)).sum::<f64>();
        let values = vec![
            shear.energies[0],
            sticking.map(|(_, q)| q * grid.cell_area()).sum(),
            shear.energies[1],
            weighted,
            (powers(5) / powers(1)).powf(0.25),
            match self.load.control(Axis::X) {
                TangentialControl::Force(_) => dx,
                _ => shear.force,
            },
        ];
        let cap = self.cap.unwrap_or(f64::INFINITY);
        let cells = self.coefficients.iter().zip(normal.pressure());
        let capped = cells.map(|(coefficient, pressure)| coefficient * pressure >= cap);
        (values, shear.zones.iter().copied().zip(capped).collect())
    }

    fn values(&self) -> (Vec<f64>, Sets) {
        let bodies = self.surface.bodies();
        let (_, contact) = self.pressed(&bodies);
        let (_, shear) = self.sheared(&bodies, &contact);
        self.values_of(shear.elastic_energy(&bodies).unwrap(), &contact, &shear)
    }

    /// Compares all derivatives with differences of the values that `solved` returns. The gap is changed by a small part of
    /// `depth`, or not at all if `depth` is zero.
    pub(super) fn compare(
        &self,
        name: &str,
        found: &[Sensitivity],
        depth: f64,
        solved: &dyn Fn(&Self) -> (Vec<f64>, Sets),
    ) {
        let (values, zones) = solved(self);
        for expected in [Zone::Stick, Zone::Slip] {
            let is_found = zones.iter().any(|(zone, _)| *zone == expected);
            assert!(is_found, "{name}: no {expected:?}");
        }
        for (n, (found, value)) in found.iter().zip(values).enumerate() {
            let error = (found.value / value - 1.0).abs();
            assert!(error < 1e-9, "{name} {n}: {} {value}", found.value);
            assert!(found.report.is_converged());
        }
        let grid = self.surface.gap.grid();
        let (direction, friction) = (random_field(grid, 5), random_field(grid, 6));
        let modulus = self.surface.bodies().pair().contact_modulus();
        let mut changes = Vec::new();
        if depth > 0.0 {
            let gap = |found: &Sensitivity| along(found.gap.as_ref(), &direction);
            changes.push(Change::new("gap", Input::Gap(&direction), depth, gap));
        }
        let by_load = |found: &Sensitivity| found.normal_load.unwrap();
        changes.push(Change::new(
            "normal load",
            Input::NormalLoad,
            self.force,
            by_load,
        ));
        for axis in [Axis::X, Axis::Y] {
            if self.value(axis) != 0.0 {
                let size = self.value(axis).abs();
                changes.push(Change::new("load", Input::Load(axis), size, move |found| {
                    found.tangential_load[axis.index()].unwrap()
                }));
            }
        }
        if self.twist != 0.0 {
            let by_twist = |found: &Sensitivity| found.twist.unwrap();
            changes.push(Change::new("twist", Input::Twist, self.twist, by_twist));
        }
        changes.push(Change::new(
            "friction",
            Input::Friction(&friction),
            0.3,
            |found| along(found.friction.as_ref(), &friction),
        ));
        changes.push(Change::new(
            "coefficient",
            Input::Coefficient,
            0.3,
            |found| found.friction_coefficient.unwrap(),
        ));
        if found[0].contact_modulus.is_some() {
            changes.push(Change::new("modulus", Input::Scale, 1.0, move |found| {
                modulus * found.contact_modulus.unwrap()
            }));
            let is_homogeneous = self.surface.bodies != Bodies::Coated;
            assert_eq!(found[0].poisson_ratio.is_some(), is_homogeneous);
            for body in [0, 1].into_iter().filter(|_| is_homogeneous) {
                let input = Input::PoissonRatio(body);
                changes.push(Change::new("Poisson's ratio", input, 1.0, move |found| {
                    found.poisson_ratio.unwrap()[body]
                }));
            }
        }
        let solved = |inputs: &[(Input<'_>, f64)]| solved(&self.moved(inputs));
        assert_differences(name, 5e-6, found, &changes, solved);
    }

    fn assert_differences(&self, name: &str) {
        let bodies = self.surface.bodies();
        let (press, contact) = self.pressed(&bodies);
        let (solver, shear) = self.sheared(&bodies, &contact);
        let workspace = &mut StiffnessWorkspace::new().poisson_ratio(true);
        let go_on = |_: &Iteration| ControlFlow::Continue(());
        let found = solver.sensitivities_with(&shear, &self.functionals(), workspace, go_on);
        let found = press.chain(&contact, found.unwrap()).unwrap();
        self.compare(name, &found, contact.approach(), &Self::values);
    }
}

fn sphere(bodies: Bodies) -> Surface {
    Surface::sphere(bodies, CellValue::Uniform)
}

fn spring(position: f64, stiffness: f64) -> TangentialControl {
    TangentialControl::Spring {
        position,
        stiffness,
    }
}

#[test]
fn derivatives_of_scalar_model_match_differences() {
    let force = TangentialLoad::force([0.6, 0.0]);
    let shift = TangentialLoad::shift([0.06, 0.0]);
    let pulled = force.along(Axis::X, spring(0.21, 8.0));
    for (name, load) in [("force", force), ("shift", shift), ("spring", pulled)] {
        let mut case = ShearCase::of(sphere(Bodies::Equal), 4.0, load);
        case.model = TangentialModel::Scalar;
        case.assert_differences(&format!("scalar, {name}"));
    }
}

#[test]
fn derivatives_of_vector_model_match_differences() {
    let force = TangentialLoad::force([0.6, 0.3]);
    let shift = TangentialLoad::shift([0.06, 0.02]);
    let mixed = shift.along(Axis::Y, spring(0.21, 8.0));
    for (name, load) in [("force", force), ("shift", shift), ("mixed", mixed)] {
        let mut case = ShearCase::of(sphere(Bodies::Equal), 4.0, load);
        case.assert_differences(&format!("vector, {name}"));
        case.twist = 0.01;
        case.strain = 0.005;
        case.cap = Some(0.02);
        case.assert_differences(&format!("vector with twist, strain and cap, {name}"));
    }
}

/// Covers contacts without friction in some cells, and grids with other boundaries.
#[test]
fn derivatives_of_rough_contacts_match_differences() {
    for boundary in kit::boundaries(Grid::square(32, 64.0).unwrap()) {
        let surface = Surface::rough(Bodies::Equal, boundary);
        let load = TangentialLoad::force([20.0, 8.0]);
        let case = ShearCase::of(surface, 150.0, load);
        case.assert_differences(&format!("rough, {boundary:?}"));
    }
}

/// The pressure also moves the surfaces tangentially.
#[test]
fn derivatives_with_one_way_coupling_match_differences() {
    for bodies in [Bodies::Homogeneous, Bodies::Coated] {
        let load = TangentialLoad::force([0.4, 0.2]);
        let mut case = ShearCase::of(sphere(bodies), 4.0, load);
        case.assert_differences(&format!("one-way, vector, {bodies:?}"));
        case.model = TangentialModel::Scalar;
        case.load = TangentialLoad::shift([0.05, 0.0]);
        case.assert_differences(&format!("one-way, scalar, {bodies:?}"));
    }
}

/// A force at the friction capacity slides the contact, so that the shift has no derivative.
#[test]
fn sliding_contact_has_no_derivative() {
    let mut case = ShearCase::of(
        sphere(Bodies::Equal),
        4.0,
        TangentialLoad::force([1.2, 0.0]),
    );
    case.model = TangentialModel::Scalar;
    let bodies = case.surface.bodies();
    let (_, contact) = case.pressed(&bodies);
    let (solver, shear) = case.sheared(&bodies, &contact);
    assert!(shear.is_gross_slip());
    let found = solver.sensitivity(&shear, &Functional::DissipatedEnergy);
    assert!(matches!(found, Err(Error::NotFinite { .. })));
}

/// The derivative of the force with respect to the shift is the stiffness. Springs and forces are consistent with it.
#[test]
fn derivative_of_force_is_loading_stiffness() {
    let load = TangentialLoad::shift([0.06, 0.02]);
    let case = ShearCase::of(sphere(Bodies::Equal), 4.0, load);
    let bodies = case.surface.bodies();
    let (press, contact) = case.pressed(&bodies);
    let (solver, shear) = case.sheared(&bodies, &contact);
    let stiffness = shear.stiffness(&bodies).unwrap().loading;
    let functionals = [Axis::X, Axis::Y].map(Functional::TangentialForce);
    let found = solver.sensitivities(&shear, &functionals).unwrap();
    for (row, found) in found.iter().enumerate() {
        for column in [0, 1] {
            let expected = stiffness[row][column].unwrap();
            let error = found.tangential_load[column].unwrap() - expected;
            assert!(error.abs() < 1e-9 * stiffness[0][0].unwrap(), "{error:e}");
        }
    }
    let unsupported = press.chain(
        &contact,
        press
            .sensitivities(&contact, &[Functional::Approach])
            .unwrap(),
    );
    assert!(matches!(unsupported, Err(Error::UnsupportedByModel { .. })));
    let unsupported = solver.sensitivity(&shear, &Functional::Approach);
    assert!(matches!(unsupported, Err(Error::UnsupportedByModel { .. })));
}

/// The set of contact cells is fixed, so a pressure in other cells is not an input.
#[test]
fn derivative_by_pressure_is_zero_outside_the_contact() {
    let grid = kit::square(24, 3.0);
    let bodies = kit::unit_bodies(grid, 0.3);
    let gap = kit::sphere(grid, 2.0);
    let normal = kit::solve(NormalProblem::builder(
        &bodies,
        &gap,
        NormalLoad::Force(0.5),
    ));
    let load = TangentialLoad::force([0.1, 0.0]);
    let builder = TangentialProblem::builder(&bodies, &normal, kit::coulomb(0.4), load);
    let mut solver = builder.build().unwrap().into_solver().unwrap();
    let mut shear = solver.new_solution();
    solver.solve_into(&mut shear).unwrap();
    let found = solver
        .sensitivity(&shear, &Functional::NormalForce)
        .unwrap();
    let derivative = found.pressure.unwrap();
    for (derivative, pressure) in derivative.iter().zip(normal.pressure().iter()) {
        let expected = if *pressure > 0.0 {
            grid.cell_area()
        } else {
            0.0
        };
        assert_eq!(*derivative, expected);
    }
    assert!(derivative.iter().any(|derivative| *derivative == 0.0));
}
