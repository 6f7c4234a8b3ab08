//! Sensitivities of a tangential contact.

use crate::bodies::component::{Component, Direction};
use crate::bodies::coupling::Coupling;
use crate::cgm::{Ball, NormBound, Row, reduce};
use crate::contact::{ResponseContext, Solver};
use crate::error::{Result, check_converged};
use crate::grid::field::Field;
use crate::half_space::HalfSpace;
use crate::memory::fallible;
use crate::numerics::agreement::tolerance_of;
use crate::numerics::cell_vector::{at, dot, minus, slices};
use crate::observer::Observer;
use crate::operator::Operator;
use crate::parallel;
use crate::report::Report;
use crate::sensitivity::adjoint::Adjoint;
use crate::sensitivity::current::{check_current, check_relative_displacement};
use crate::sensitivity::functional::{ContactView, Gradient, ShearView, pair_at};
use crate::sensitivity::loads::ShearLoads;
use crate::sensitivity::poisson::{Loading, UnitDisplacements};
use crate::sensitivity::shear::{by_control, by_twist, on_grid, on_region, total_of};
use crate::sensitivity::solver::{Linearised, check_functionals, with_own_report};
use crate::sensitivity::{Functional, Sensitivity};
use crate::stiffness::{
    BallOf, ContactCells, SolvedContact, StiffnessWorkspace, SystemBuffers, SystemOf,
};
use crate::tangential::{
    Axis, CouplingDisplacement, Friction, PressureOnWindow, RigidMotion, TangentialControl,
    TangentialProblem, TangentialSolution, centre,
};

/// Sheared contact whose sensitivities are computed.
pub(super) struct Sheared<'a> {
    pub(super) bodies: &'a HalfSpace,
    pub(super) pressed: &'a PressureOnWindow,
    pub(super) friction: &'a Friction,
    pub(super) controls: [TangentialControl; 2],
    /// Whether the pressure moves the surfaces tangentially.
    pub(super) is_drawn: bool,
    /// Whether a coupling of the bodies would move the surfaces. `None` if no derivatives with respect to Poisson's ratios are
    /// computed.
    pub(super) poisson_ratio: Option<bool>,
}

impl Linearised for TangentialProblem {
    fn sensitivities(
        solver: &Solver<Self>,
        shear: &TangentialSolution,
        functionals: &[Functional],
        workspace: &mut StiffnessWorkspace,
        observer: Observer<'_>,
    ) -> Result<Vec<Sensitivity>> {
        let (problem, pressed) = (&solver.problem, solver.pressed());
        let (bodies, grid) = (&problem.bodies, problem.bodies.grid());
        let checked = shear.check_bodies(bodies);
        let checked = checked.and_then(|()| shear.check_uncoupled());
        let checked = checked.and_then(|()| check_converged(shear.report()));
        check_functionals(bodies, (false, true), functionals, checked)?;
        workspace.check_alike(bodies)?;
        let has_poisson_ratio = workspace.has_poisson_ratio();
        let (mut context, buffers) = workspace.begin(observer);
        bodies.joint(parallel::enter_with(grid.cells(), || {
            let mut pressure = fallible::zeros(grid.cells())?;
            pressed.region.scatter(&pressed.pressure, &mut pressure);
            let (layout, tolerance) = (bodies.grid_layout(), tolerance_of(&[shear.report()]));
            let is_current = shear.belongs_to(&layout, &pressure, &problem.friction, tolerance);
            check_current(is_current, "the pressure or the friction")?;
            let loads = ShearLoads::of(shear, solver.friction_capacity());
            let is_current = loads.are_prescribed_by(&problem.load.demand(), Some(0.0));
            check_current(is_current, "the tangential load")?;
            if let Some(relative) = &problem.relative {
                let [x, y] = tangential_displacement(problem, shear, &pressure, &mut context)?;
                let moved = [x.as_slice(), y.as_slice()];
                check_relative_displacement(bodies, relative, shear, moved)?;
            }
            let sheared = Sheared {
                bodies,
                pressed,
                friction: &problem.friction,
                controls: [Axis::X, Axis::Y].map(|axis| problem.load.control(axis)),
                is_drawn: problem.coupling.is_one_way(bodies.pair()),
                poisson_ratio: has_poisson_ratio.then_some(problem.coupling == Coupling::OneWay),
            };
            let view = ContactView {
                bodies,
                pressure: &pressure,
                approach: None,
                lift: &[],
                shear: ShearView {
                    traction: shear.traction().map(Field::as_slice),
                    slip: shear.slip().map(Field::as_slice),
                    zones: shear.zones(),
                    shift: shear.shift(),
                    displacement: [&[]; 2],
                },
            };
            let cells = &mut buffers.cells;
            cells.take_zones(&pressed.region, shear.zones())?;
            cells.take(&pressed.region, &SolvedContact::sheared(bodies, shear))?;
            // The displacement due to pressure and tractions follows from the motion and the slip.
            let motion = RigidMotion {
                shift: shear.shift(),
                twist: shear.twist(),
            };
            let moved = |i: usize| {
                let relative = problem.relative.as_ref();
                let relative = [0, 1].map(|axis| relative.map_or(0.0, |of| of.at(axis, i)));
                let slip = minus(pair_at(&view.shear.slip, i), relative);
                let moved = motion.at(centre(grid, i));
                [0, 1].map(|axis| moved[axis] + slip[axis])
            };
            let of = (&view, functionals);
            let mut found = sheared.solve(shear.axis(), of, Some(&moved), buffers, &mut context)?;
            for found in &mut found {
                found.pressed = Some(shear.pressure_fingerprint());
            }
            Ok(found)
        }))
    }
}

/// Computes the tangential displacement of all cells due to tractions and pressure.
fn tangential_displacement(
    problem: &TangentialProblem,
    shear: &TangentialSolution,
    pressure: &[f64],
    context: &mut ResponseContext<'_>,
) -> Result<[Field; 2]> {
    let bodies = &problem.bodies;
    context.notify_observer(&bodies.grid_layout())?;
    let mut moved = shear.displacement(bodies)?;
    if problem.coupling.is_one_way(bodies.pair()) {
        let axes = shear.axis().map_or(Axis::BOTH, Axis::alone);
        let size = bodies.grid().whole().size();
        let mut drawing = CouplingDisplacement::new(bodies, axes, size)?;
        drawing.displace(pressure.iter().copied(), |axis, by_pressure| {
            let moved = moved[axis.index()].as_mut_slice().iter_mut();
            for (moved, by_pressure) in moved.zip(by_pressure) {
                *moved += by_pressure;
            }
        });
    }
    Ok(moved)
}

/// Displacement of a local cell of the grid.
pub(super) type Displacement<'a> = &'a (dyn Fn(usize) -> [f64; 2] + Sync);

impl Sheared<'_> {
    /// Computes the sensitivities of functionals for the states in the buffers, in the scalar model along an axis or in the
    /// vector model. `moved` returns the displacement due to pressure and tractions. Without `moved` there is no derivative with
    /// respect to the modulus.
    pub(super) fn solve(
        &self,
        axis: Option<Axis>,
        of: (&ContactView<'_>, &[Functional]),
        moved: Option<Displacement<'_>>,
        buffers: &mut SystemBuffers,
        context: &mut ResponseContext<'_>,
    ) -> Result<Vec<Sensitivity>> {
        let cells = &buffers.cells;
        if let Some(axis) = axis {
            let with = (cells, &mut buffers.along);
            self.sensitivities([axis], with, of, moved, context)
        } else {
            let with = (cells, &mut buffers.plane);
            self.sensitivities([Axis::X, Axis::Y], with, of, moved, context)
        }
    }

    /// Computes the sensitivities like [`Self::solve`], for tractions along these axes.
    fn sensitivities<const N: usize>(
        &self,
        axes: [Axis; N],
        (cells, slot): (&ContactCells, &mut Option<SystemOf<BallOf<N>, N>>),
        (view, functionals): (&ContactView<'_>, &[Functional]),
        moved: Option<Displacement<'_>>,
        context: &mut ResponseContext<'_>,
    ) -> Result<Vec<Sensitivity>>
    where
        NormBound: Ball<N>,
    {
        let (bodies, region) = (self.bodies, &self.pressed.region);
        let system = cells.slipping_system((bodies, region), axes, slot)?;
        let totals = axes.map(|axis| total_of(bodies, self.controls[axis.index()]));
        let mut adjoint = Adjoint::new(system, totals, context)?;
        let mut stored: [Vec<f64>; 2] = Default::default();
        if functionals.contains(&Functional::ElasticEnergy) {
            let traction = |cell: usize| axes.map(|axis| cells.traction[axis.index()][cell]);
            let displacement = adjoint.displacement(traction, context)?;
            for (axis, part) in axes.iter().zip(&displacement) {
                stored[axis.index()] = on_grid(bodies, region, part)?.into_vec();
            }
        }
        let shear = ShearView {
            displacement: slices(&stored),
            ..view.shear
        };
        let view = &ContactView { shear, ..*view };
        let loading = Loading {
            directions: axes.map(Axis::direction),
            tractions: axes.map(|axis| &*cells.traction[axis.index()]),
            pressure: (self.poisson_ratio == Some(true)).then_some(&*self.pressed.pressure),
        };
        let unit = match self.poisson_ratio {
            Some(_) => UnitDisplacements::new(bodies, region, &loading, context)?,
            None => None,
        };
        let mut all = fallible::with_room(functionals.len())?;
        for functional in functionals {
            let of = functional.gradient(view)?;
            let mut report = Report::unsolved();
            let found = with_own_report(context, &mut report, |context| {
                self.sensitivity(axes, cells, (view, &of), &mut adjoint, moved, context)
            })?;
            let (found, multipliers) = found;
            let poisson_ratio = unit.as_ref().map(|unit| {
                unit.by_poisson_ratio(bodies, region, &loading, &multipliers, of.energy)
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
    fn sensitivity<R: Row<N>, const N: usize>(
        &self,
        axes: [Axis; N],
        cells: &ContactCells,
        (view, of): (&ContactView<'_>, &Gradient),
        adjoint: &mut Adjoint<'_, R, N>,
        moved: Option<Displacement<'_>>,
        context: &mut ResponseContext<'_>,
    ) -> Result<(Sensitivity, [Vec<f64>; N])> {
        let (bodies, region) = (self.bodies, &self.pressed.region);
        let grid = bodies.grid();
        let along = |parts: &[Vec<f64>; 2]| -> Result<[Vec<f64>; N]> {
            fallible::try_each(|n| on_region(region, &parts[axes[n].index()]))
        };
        let (weights, slip) = (along(&of.traction)?, along(&of.slip)?);
        let weight = |cell: usize| at(&slices(&weights), cell);
        // The slip of other cells is constant.
        let slip = |cell: usize| {
            let is_slipping = f64::from(u8::from(cells.slips(cell)));
            at(&slices(&slip), cell).map(|weight| weight * is_slipping)
        };
        let motion = axes.map(|axis| of.shift[axis.index()]);
        let found = adjoint.multipliers(weight, slip, motion, context)?;
        let direction = |cell: usize| cells.slip_direction(axes, cell);
        let by_limit = adjoint.by_limit(&found, weight, direction, context)?;

        let (friction, own) = (&self.friction.within(region), &self.pressed.pressure);
        let mut pressure = on_region(region, &of.pressure)?;
        if self.is_drawn {
            // The operator of the displacement due to pressure is the transpose of the operator of the lift due to
            // tractions.
            let (size, mut lift) = (region.window().size, fallible::zeros(region.cells())?);
            for (axis, part) in axes.iter().zip(&found.cells) {
                context.notify_observer(region.layout())?;
                let component = Component::of(Direction::Z, axis.direction());
                let operator = bodies.operator_of([[component]], size)?;
                operator.apply([part], [&mut lift], &mut operator.scratch()?);
                for (weight, lift) in pressure.iter_mut().zip(&lift) {
                    *weight -= lift;
                }
            }
        }
        let mut by_friction = fallible::zeros(region.cells())?;
        for (cell, by_limit) in by_limit.iter().enumerate() {
            // The entry compliance decreases as the pressure grows.
            let multiplier = at(&slices(&found.cells), cell);
            let lag = dot(multiplier, cells.entry_lag(axes, cell));
            if lag != 0.0 {
                pressure[cell] += lag / own[cell];
            }
            pressure[cell] += friction.slope(cell, own[cell]) * by_limit;
            by_friction[cell] = friction.slope_by_coefficient(cell, own[cell]) * by_limit;
            if own[cell] <= 0.0 {
                // The set of contact cells is fixed.
                pressure[cell] = 0.0;
            }
        }

        let mut multipliers = fallible::try_each(|_| Field::try_zeros(grid))?;
        for (axis, part) in axes.iter().zip(&found.cells) {
            region.scatter(part, multipliers[axis.index()].as_mut_slice());
        }
        let may_turn = N == 2 && bodies.boundary().may_turn();
        let twist = may_turn.then(|| by_twist(bodies, &multipliers));
        let multipliers = multipliers.each_ref().map(Field::as_slice);
        let by_scale = moved.map(|moved| {
            let by_scale = |i: usize| {
                let [q, stored] = [view.shear.traction, view.shear.displacement];
                let stored = dot(pair_at(&q, i), pair_at(&stored, i));
                dot(pair_at(&multipliers, i), moved(i)) - of.energy * stored
            };
            let sum: f64 = reduce::sum(&bodies.grid_layout(), by_scale);
            sum / bodies.pair().contact_modulus()
        });
        let mut tangential_load = [None; 2];
        for (axis, load) in axes.iter().zip(found.loads) {
            let control = self.controls[axis.index()];
            tangential_load[axis.index()] = by_control(bodies, control, load);
        }
        let friction_coefficient = Some(reduce::total(region.layout(), &by_friction));
        let sensitivity = Sensitivity {
            pressure: Some(on_grid(bodies, region, &pressure)?),
            tangential_load,
            twist,
            friction: Some(on_grid(bodies, region, &by_friction)?),
            friction_coefficient,
            contact_modulus: by_scale,
            ..Sensitivity::of(of.value)
        };
        Ok((sensitivity, found.cells))
    }
}
