//! Sensitivities of a normal contact.

use std::ops::ControlFlow;

use crate::cgm::{Total, reduce};
use crate::contact::{ResponseContext, Solver};
use crate::error::{Error, Result, check_converged};
use crate::grid::field::Field;
use crate::grid::window::Window;
use crate::half_space::HalfSpace;
use crate::memory::fallible;
use crate::normal::{Hardness, NormalLoad, NormalProblem, NormalSolution, NormalSolver};
use crate::numerics::agreement::tolerance_of;
use crate::observer::{Observer, unwatched};
use crate::parallel;
use crate::report::{Iteration, Report};
use crate::sensitivity::adjoint::Adjoint;
use crate::sensitivity::current::{
    check_gap, check_hardness, check_normal_load, normal_displacement,
};
use crate::sensitivity::functional::{ContactView, Gradient, ShearView, entry};
use crate::sensitivity::shear::on_region;
use crate::sensitivity::solver::{Linearised, check_functionals, with_own_report};
use crate::sensitivity::{Functional, Sensitivity};
use crate::stiffness::{SolvedContact, StiffnessWorkspace, SystemBuffers};

impl Linearised for NormalProblem {
    fn sensitivities(
        solver: &Solver<Self>,
        contact: &NormalSolution,
        functionals: &[Functional],
        workspace: &mut StiffnessWorkspace,
        observer: Observer<'_>,
    ) -> Result<Vec<Sensitivity>> {
        let bodies = &solver.problem.bodies;
        let converged = check_converged(contact.report());
        let checked = contact.check_bodies(bodies).and(converged);
        check_functionals(bodies, (true, false), functionals, checked)?;
        workspace.check_alike(bodies)?;
        let (mut context, buffers) = workspace.begin(observer);
        bodies.joint(parallel::enter_with(bodies.grid().cells(), || {
            let lift = &checked_displacement(&solver.problem, contact, &mut context)?;
            let view = ContactView {
                bodies,
                pressure: contact.pressure().as_slice(),
                approach: Some(contact.approach()),
                lift,
                shear: ShearView::default(),
            };
            let gradients = functionals.iter().map(|one| one.gradient(&view));
            let gradients = gradients.collect::<Result<Vec<_>>>()?;
            let pressed = Pressed::of(solver);
            pressed.propagate(contact, lift, gradients, buffers, &mut context)
        }))
    }
}

/// Normal contact whose sensitivities are computed.
pub(super) struct Pressed<'a> {
    pub(super) bodies: &'a HalfSpace,
    pub(super) hardness: Option<&'a Hardness>,
    pub(super) load: NormalLoad,
    /// Window of the solution, if known.
    pub(super) window: Option<Window>,
}

impl<'a> Pressed<'a> {
    fn of(solver: &'a NormalSolver) -> Self {
        let problem = &solver.problem;
        Self {
            bodies: &problem.bodies,
            hardness: problem.hardness.as_ref(),
            load: problem.load,
            window: solver.window(),
        }
    }

    /// Computes the sensitivities of functionals with these derivatives with respect to pressures and approach. `lift` is the
    /// displacement along z under the pressure, or empty if the derivative with respect to the modulus is not used.
    pub(super) fn propagate(
        &self,
        contact: &NormalSolution,
        lift: &[f64],
        gradients: Vec<Gradient>,
        buffers: &mut SystemBuffers,
        context: &mut ResponseContext<'_>,
    ) -> Result<Vec<Sensitivity>> {
        let (bodies, load) = (self.bodies, self.load);
        let solved = SolvedContact {
            hardness: self.hardness,
            windows: [self.window, None],
            ..SolvedContact::of(bodies)
        };
        let SystemBuffers { normal, cells, .. } = buffers;
        let held = solved.hold_pressure(contact, "a sensitivity", normal, cells)?;
        // The prescribed values have no effect on the linear problem.
        let (total, per_load) = match load {
            NormalLoad::Force(_) => (Total::Sum(0.0), bodies.grid().cell_area().recip()),
            NormalLoad::Approach(_) => (Total::Free, 1.0),
        };
        let mut adjoint = match (held, load) {
            (Some((region, system)), _) => Some((region, Adjoint::new(system, [total], context)?)),
            (None, NormalLoad::Approach(_)) => None,
            (None, NormalLoad::Force(_)) => return Err(Error::EmptyContact),
        };
        let pressure = contact.pressure().as_slice();
        let mut all = fallible::with_room(gradients.len())?;
        for of in gradients {
            let mut report = Report::unsolved();
            let mut by_gap = Field::try_zeros(bodies.grid())?;
            let mut by_load = of.approach;
            if let Some((region, adjoint)) = &mut adjoint {
                let weights = on_region(region, &of.pressure)?;
                let found = with_own_report(context, &mut report, |context| {
                    adjoint.multipliers(|i| [weights[i]], |_| [0.0], [of.approach], context)
                })?;
                [by_load] = found.loads;
                region.scatter(&found.cells[0], by_gap.as_mut_slice());
            }
            // At constant pressure, a relative change e of the modulus changes the displacement u by -e u.
            let multipliers = by_gap.as_slice();
            let by_scale = reduce::sum(&bodies.grid_layout(), |i| {
                (multipliers[i] - of.energy * pressure[i]) * entry(lift, i)
            });
            let by_gap = by_gap.scaled(-1.0);
            all.push(Sensitivity {
                gap: Some(by_gap),
                normal_load: Some(by_load * per_load),
                contact_modulus: Some(by_scale / bodies.pair().contact_modulus()),
                poisson_ratio: poisson_ratio(bodies, by_scale),
                report,
                ..Sensitivity::of(of.value)
            });
        }
        Ok(all)
    }
}

impl NormalSolver {
    /// Continues sensitivities of a tangential contact through the normal contact that supplies its pressure. The results also
    /// contain the derivatives with respect to the gap and the normal load. The derivatives with respect to the modulus include
    /// the change of the pressure. `contact` must be the solution of the present problem. The tangential contact must have been
    /// solved under its pressure.
    ///
    /// # Errors
    /// - [`Error::OutdatedSolution`] if the tangential contact was solved under a different pressure, for instance before a change
    ///   of the normal load or the gap.
    /// - [`Error::UnsupportedByModel`] if a sensitivity has no derivative with respect to the pressure. A sensitivity that was
    ///   chained before, or that has a derivative with respect to the gap or the normal load, also has this error.
    /// - The errors of [`sensitivity`](Self::sensitivity).
    pub fn chain(
        &self,
        contact: &NormalSolution,
        sensitivities: Vec<Sensitivity>,
    ) -> Result<Vec<Sensitivity>> {
        let workspace = &mut StiffnessWorkspace::new();
        self.chain_with(contact, sensitivities, workspace, unwatched)
    }

    /// Continues sensitivities like [`chain`](Self::chain), with the tolerance and the buffers of a workspace, and with an
    /// observer.
    ///
    /// # Errors
    /// The errors of [`chain`](Self::chain).
    pub fn chain_with(
        &self,
        contact: &NormalSolution,
        sensitivities: Vec<Sensitivity>,
        workspace: &mut StiffnessWorkspace,
        mut observer: impl FnMut(&Iteration) -> ControlFlow<()> + Send,
    ) -> Result<Vec<Sensitivity>> {
        let bodies = &self.problem.bodies;
        let converged = check_converged(contact.report());
        let mut checked = contact.check_bodies(bodies).and(converged);
        let mut gradients = fallible::with_room(sensitivities.len())?;
        let (given, tolerance) = (contact.fingerprint(), tolerance_of(&[contact.report()]));
        for found in &sensitivities {
            let mut of = Gradient::default();
            if found.gap.is_some() || found.normal_load.is_some() {
                checked = checked.and(Err(Error::UnsupportedByModel {
                    model: "the chain to the gap",
                    quantity: "a sensitivity that already contains the derivatives of the normal contact",
                    value: 0.0,
                    remedy: "chain each sensitivity of a tangential contact once",
                }));
            }
            match &found.pressure {
                Some(pressure) => {
                    let is_same = found
                        .pressed
                        .zip(given)
                        .is_none_or(|(own, given)| own.agrees_with(&given, tolerance));
                    checked = checked
                        .and_then(|()| pressure.check("pressure", bodies.grid()))
                        .and_then(|()| check_pressure(is_same));
                    of.pressure = fallible::copied(pressure.as_slice())?;
                }
                None => {
                    checked = checked.and(Err(Error::UnsupportedByModel {
                        model: "the chain to the gap",
                        quantity: "a sensitivity without a derivative with respect to the pressure",
                        value: found.value,
                        remedy: "chain the sensitivities of a tangential contact",
                    }));
                }
            }
            gradients.push(of);
        }
        bodies.collective_result_checked(
            checked,
            &[("number of sensitivities", &sensitivities.len())],
        )?;
        workspace.check_alike(bodies)?;
        let (mut context, buffers) = workspace.begin(&mut observer);
        let pressing = bodies.joint(parallel::enter_with(bodies.grid().cells(), || {
            let lift = checked_displacement(&self.problem, contact, &mut context)?;
            Pressed::of(self).propagate(contact, &lift, gradients, buffers, &mut context)
        }))?;
        let chained = sensitivities.into_iter().zip(pressing);
        Ok(chained.map(|(shear, press)| shear.after(press)).collect())
    }
}

impl Sensitivity {
    /// Adds the derivatives of the normal contact that supplies the pressure.
    pub(super) fn after(self, press: Self) -> Self {
        let both = |a: Option<f64>, b: Option<f64>| Some(a? + b?);
        let ratios = self.poisson_ratio.zip(press.poisson_ratio);
        let poisson_ratio = ratios.map(|([a, b], [c, d])| [a + c, b + d]);
        let mut report = self.report;
        report.add_pass(&press.report);
        Self {
            gap: press.gap,
            normal_load: press.normal_load,
            contact_modulus: both(self.contact_modulus, press.contact_modulus),
            poisson_ratio,
            report,
            ..self
        }
    }
}

/// Returns an error unless the sensitivities of a tangential contact belong to the pressure of the normal contact.
fn check_pressure(is_same: bool) -> Result<()> {
    if is_same {
        return Ok(());
    }
    Err(Error::OutdatedSolution {
        quantity: "sensitivity of the tangential contact",
        changed: "the pressure",
        remedy: "solve the tangential contact under the new pressure, and chain its new sensitivities",
    })
}

/// Returns the normal displacement of all cells, or an error if the solution does not belong to the present input.
fn checked_displacement(
    problem: &NormalProblem,
    contact: &NormalSolution,
    context: &mut ResponseContext<'_>,
) -> Result<Vec<f64>> {
    let NormalProblem { bodies, gap, .. } = problem;
    check_normal_load(problem.load, contact)?;
    check_hardness(bodies, problem.hardness.as_ref(), contact)?;
    let current = normal_displacement(bodies, contact, context)?;
    check_gap(bodies, gap, contact, &current)?;
    displacement(gap, contact)
}

/// Returns the normal displacement of all cells.
fn displacement(gap: &Field, contact: &NormalSolution) -> Result<Vec<f64>> {
    let opened = contact.gap().as_slice().iter().zip(gap.as_slice());
    let lift = opened.map(|(opened, gap)| opened - gap + contact.approach());
    fallible::collected(gap.as_slice().len(), lift)
}

/// Returns the derivatives with respect to Poisson's ratios of a functional that depends on them only through the contact modulus.
/// `by_scale` is the derivative with respect to the logarithm of the modulus.
fn poisson_ratio(bodies: &HalfSpace, by_scale: f64) -> Option<[f64; 2]> {
    let pair = bodies.pair();
    pair.is_homogeneous().then(|| {
        pair.bodies().map(|body| {
            2.0 * body.poisson_ratio() / body.youngs_modulus() * pair.contact_modulus() * by_scale
        })
    })
}
