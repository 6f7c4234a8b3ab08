//! Sensitivities of a coupled contact.

use crate::bodies::component::Direction;
use crate::cgm::cone::TransposedState;
use crate::cgm::{Total, reduce};
use crate::contact::{ResponseContext, Solver};
use crate::coupled::{CoupledProblem, CoupledSolution};
use crate::error::{Error, Result, check_converged};
use crate::grid::field::Field;
use crate::half_space::Region;
use crate::memory::fallible;
use crate::normal::NormalLoad;
use crate::numerics::agreement::ROUND_OFF;
use crate::numerics::cell_vector::{at, slices};
use crate::observer::Observer;
use crate::parallel;
use crate::report::Report;
use crate::sensitivity::adjoint::{Adjoint, is_zero};
use crate::sensitivity::current::{
    check_current, check_gap, check_hardness, check_normal_load, check_relative_displacement,
};
use crate::sensitivity::functional::{ContactView, Gradient, ShearView};
use crate::sensitivity::loads::ShearLoads;
use crate::sensitivity::poisson::{Loading, UnitDisplacements};
use crate::sensitivity::shear::{by_control, by_twist, on_grid, on_region, total_of};
use crate::sensitivity::solver::{Linearised, check_functionals, with_own_report};
use crate::sensitivity::{Functional, Sensitivity};
use crate::stiffness::{
    ContactCells, SolvedContact, StiffnessWorkspace, SystemBuffers, check_open, joint_system,
};
use crate::tangential::Axis;

/// Number of components of a vector (z, x and y).
const N: usize = 3;

impl Linearised for CoupledProblem {
    fn sensitivities(
        solver: &Solver<Self>,
        contact: &CoupledSolution,
        functionals: &[Functional],
        workspace: &mut StiffnessWorkspace,
        observer: Observer<'_>,
    ) -> Result<Vec<Sensitivity>> {
        let problem = &solver.problem;
        let (bodies, hardness) = (&problem.bodies, problem.hardness.as_ref());
        let (normal, shear) = (contact.normal(), contact.tangential());
        let checked = normal.check_bodies(bodies);
        let checked = checked.and_then(|()| check_converged(normal.report()));
        let checked = checked.and_then(|()| match hardness {
            Some(_) => Ok(()),
            None => normal.check_elastic("a sensitivity"),
        });
        check_functionals(bodies, (true, true), functionals, checked)?;
        workspace.check_alike(bodies)?;
        let has_poisson_ratio = workspace.has_poisson_ratio();
        let (mut context, buffers) = workspace.begin(observer);
        bodies.joint(parallel::enter_with(bodies.grid().cells(), || {
            let [x, y, z] = contact.displacement().map(Field::as_slice);
            problem.check_current(contact)?;
            let view = ContactView {
                bodies,
                pressure: normal.pressure().as_slice(),
                approach: Some(normal.approach()),
                lift: z,
                shear: ShearView {
                    traction: shear.traction().map(Field::as_slice),
                    slip: shear.slip().map(Field::as_slice),
                    zones: shear.zones(),
                    shift: shear.shift(),
                    displacement: [x, y],
                },
            };
            let solved = SolvedContact {
                hardness,
                windows: [solver.engine.window(), None],
                ..SolvedContact::sheared(bodies, shear)
            };
            let of = (functionals, has_poisson_ratio);
            problem.linearised(&solved, &view, of, buffers, &mut context)
        }))
    }
}

impl CoupledProblem {
    /// Returns an error if the solution does not belong to the present input.
    fn check_current(&self, contact: &CoupledSolution) -> Result<()> {
        let (bodies, normal, shear) = (&self.bodies, contact.normal(), contact.tangential());
        check_normal_load(self.normal, normal)?;
        check_hardness(bodies, self.hardness.as_ref(), normal)?;
        let [x, y, z] = contact.displacement().map(Field::as_slice);
        check_gap(bodies, &self.gap, normal, z)?;
        if let Some(relative) = &self.relative {
            check_relative_displacement(bodies, relative, shear, [x, y])?;
        }
        let pressure = normal.pressure().as_slice();
        let is_current =
            shear.belongs_to(&bodies.grid_layout(), pressure, &self.friction, ROUND_OFF);
        check_current(is_current, "the friction")?;
        let capacity = reduce::sum(&bodies.grid_layout(), |i| {
            self.friction.limit(i, pressure[i])
        });
        let loads = ShearLoads::of(shear, capacity * bodies.grid().cell_area());
        let is_current = loads.are_prescribed_by(&self.tangential.demand(), Some(0.0));
        check_current(is_current, "the tangential load")
    }

    fn linearised(
        &self,
        solved: &SolvedContact<'_>,
        view: &ContactView<'_>,
        (functionals, has_poisson_ratio): (&[Functional], bool),
        buffers: &mut SystemBuffers,
        context: &mut ResponseContext<'_>,
    ) -> Result<Vec<Sensitivity>> {
        let (bodies, pressure) = (&self.bodies, view.pressure);
        let SystemBuffers {
            transposed, cells, ..
        } = buffers;
        let Some(region) = solved.region(solved.windows[0], |i| pressure[i] > 0.0) else {
            return Err(Error::EmptyContact);
        };
        check_open(bodies, || {
            reduce::any(&bodies.grid_layout(), |i| pressure[i] <= 0.0)
        })?;
        let system = joint_system(bodies, &region, transposed)?;
        solved.take_coupled(&region, pressure, cells)?;
        cells.take_zones(&region, view.shear.zones)?;
        let within = &self.friction.within(&region);
        let layout = system.response.layout.clone();
        let rows = solved.frozen(cells, true);
        let rows = rows.rows(&layout, &within, system.self_compliance);
        system.hold(bodies, |cell| TransposedState(rows(cell)), &[])?;
        let controls = [Axis::X, Axis::Y].map(|axis| self.tangential.control(axis));
        let [x, y] = controls.map(|control| total_of(bodies, control));
        let z = match self.normal {
            NormalLoad::Force(_) => Total::Sum(0.0),
            NormalLoad::Approach(_) => Total::Free,
        };
        let mut adjoint = Adjoint::new(system, [z, x, y], context)?;
        let [qx, qy] = slices(&cells.traction);
        let loading = Loading {
            directions: [Direction::Z, Direction::X, Direction::Y],
            tractions: [&*cells.pressure, qx, qy],
            pressure: None,
        };
        let unit = if has_poisson_ratio {
            UnitDisplacements::new(bodies, &region, &loading, context)?
        } else {
            None
        };
        let mut all = fallible::with_room(functionals.len())?;
        for functional in functionals {
            let of = functional.gradient(view)?;
            let mut report = Report::unsolved();
            let found = with_own_report(context, &mut report, |context| {
                self.sensitivity((&region, cells), (view, &of), &mut adjoint, context)
            })?;
            let (found, multipliers) = found;
            let poisson_ratio = unit.as_ref().map(|unit| {
                unit.by_poisson_ratio(bodies, &region, &loading, &multipliers, of.energy)
            });
            all.push(Sensitivity {
                poisson_ratio,
                report,
                ..found
            });
        }
        Ok(all)
    }

    /// Computes the sensitivity of one functional with these derivatives, and the multipliers of the displacements.
    fn sensitivity(
        &self,
        (region, cells): (&Region, &ContactCells),
        (view, of): (&ContactView<'_>, &Gradient),
        adjoint: &mut Adjoint<'_, TransposedState, N>,
        context: &mut ResponseContext<'_>,
    ) -> Result<(Sensitivity, [Vec<f64>; N])> {
        let bodies = &self.bodies;
        let [x, y] = &of.traction;
        let weights = fallible::try_each(|c| on_region(region, [&of.pressure, x, y][c]))?;
        let weight = |cell: usize| at(&slices(&weights), cell);
        let [x, y] = &of.slip;
        let slip: [Vec<f64>; N] = fallible::try_each(|c| on_region(region, [&[], &**x, y][c]))?;
        let direction = |cell: usize| {
            let [x, y] = cells.slip_direction([Axis::X, Axis::Y], cell);
            [0.0, x, y]
        };
        // The slip of other cells is constant.
        let slip = |cell: usize| {
            if is_zero(direction(cell)) {
                [0.0; N]
            } else {
                at(&slices(&slip), cell)
            }
        };
        let motion = [of.approach, of.shift[0], of.shift[1]];
        let found = adjoint.multipliers(weight, slip, motion, context)?;
        let mut by_friction = adjoint.by_limit(&found, weight, direction, context)?;
        let friction = self.friction.within(region);
        for (cell, by_limit) in by_friction.iter_mut().enumerate() {
            *by_limit *= friction.slope_by_coefficient(cell, cells.pressure[cell]);
        }
        let friction_coefficient = Some(reduce::total(region.layout(), &by_friction));

        let multipliers = fallible::try_each(|c| on_grid(bodies, region, &found.cells[c]))?;
        let [z, x, y] = multipliers.each_ref().map(Field::as_slice);
        let ([ux, uy], [qx, qy]) = (view.shear.displacement, view.shear.traction);
        let by_scale = reduce::sum(&bodies.grid_layout(), |i| {
            let e = of.energy;
            (z[i] - e * view.pressure[i]) * view.lift[i]
                + (x[i] - e * qx[i]) * ux[i]
                + (y[i] - e * qy[i]) * uy[i]
        });
        let [by_gap, x, y] = multipliers;
        let tangential = [x, y];
        let may_turn = bodies.boundary().may_turn();
        let [press, shear @ ..] = found.loads;
        let normal_load = match self.normal {
            NormalLoad::Force(_) => press / bodies.grid().cell_area(),
            NormalLoad::Approach(_) => press,
        };
        let sensitivity = Sensitivity {
            gap: Some(by_gap.scaled(-1.0)),
            normal_load: Some(normal_load),
            tangential_load: [Axis::X, Axis::Y]
                .map(|axis| by_control(bodies, self.tangential.control(axis), shear[axis.index()])),
            twist: may_turn.then(|| by_twist(bodies, &tangential)),
            friction: Some(on_grid(bodies, region, &by_friction)?),
            friction_coefficient,
            contact_modulus: Some(by_scale / bodies.pair().contact_modulus()),
            ..Sensitivity::of(of.value)
        };
        Ok((sensitivity, found.cells))
    }
}
