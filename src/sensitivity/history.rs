//! Sensitivities of the last step of a history, with the past fixed.

use std::ops::ControlFlow;

use crate::contact::ResponseContext;
use crate::error::{Error, Result};
use crate::grid::field::Field;
use crate::history::{History, LoadStep};
use crate::memory::fallible;
use crate::observer::{Observer, unwatched};
use crate::parallel;
use crate::report::Iteration;
use crate::sensitivity::current::{check_current, check_normal_load};
use crate::sensitivity::functional::{ContactView, Gradient, ShearView};
use crate::sensitivity::loads::ShearLoads;
use crate::sensitivity::normal::Pressed;
use crate::sensitivity::solver::check_functionals;
use crate::sensitivity::tangential::Sheared;
use crate::sensitivity::{Functional, Sensitivity};
use crate::stiffness::{StiffnessWorkspace, SystemBuffers};
use crate::tangential::PressureOnWindow;

const MODEL: &str = "the sensitivity of a step of a history";

fn unsupported<T>(quantity: &'static str, remedy: &'static str) -> Result<T> {
    Err(Error::UnsupportedByModel {
        model: MODEL,
        quantity,
        value: 0.0,
        remedy,
    })
}

impl History {
    /// Computes the derivatives of a functional of the last step with respect to the input of this step: its load, its friction
    /// and its gap (see [`sensitivity`](crate::sensitivity)). `load` must be the load of this step.
    ///
    /// The state before the step is fixed. It includes the offsets of the cells, and the gaps that cells close when they come into
    /// contact. A program that differentiates several steps adds the effects of earlier steps itself. The derivative with respect
    /// to the modulus is `None`, because the past also depends on the modulus. The elastic energy is the energy of shear.
    ///
    /// ```
    /// use stickslip::sensitivity::Functional;
    /// use stickslip::*;
    /// let grid = Grid::square(32, 0.30e-3)?;
    /// let steel = Material::new(213e9, 0.29)?;
    /// let bodies = HalfSpace::new(grid, ElasticPair::new(steel, steel)?)?;
    /// let ball = surface::sphere(grid, 3.5e-3)?;
    /// let mut history = History::builder(&bodies, &ball, Friction::coulomb(0.5)?).build()?;
    /// history.step(&LoadStep::hold().normal(NormalControl::Force(100.0)))?;
    /// let drag = LoadStep::force([30.0, 0.0]);
    /// history.step(&drag)?;
    /// let found = history.sensitivity(&drag, &Functional::Shift(Axis::X))?;
    /// // The shift per force is the reciprocal of the stiffness, and the shift decreases with more friction.
    /// let stiffness = history.stiffness()?.tangential.loading[0][0].unwrap_or(0.0);
    /// assert!((found.tangential_load[0].unwrap_or(0.0) * stiffness - 1.0).abs() < 1e-8);
    /// assert!(found.friction_coefficient < Some(0.0));
    /// # Ok::<(), Error>(())
    /// ```
    ///
    /// # Errors
    /// - [`Error::EmptyContact`] if the bodies do not touch.
    /// - [`Error::UnsupportedByModel`] for a step that rolls, or for full coupling of dissimilar bodies.
    /// - [`Error::NoLastStep`] if the history has taken no step since it was created or since [`History::set_state`].
    /// - [`Error::OutdatedSolution`] if the friction, the gap or the relative displacement has changed since the last step, or if
    ///   the last step did not reach `load`.
    /// - The errors of [`Solver::sensitivity`](crate::Solver::sensitivity).
    pub fn sensitivity(&self, load: &LoadStep, functional: &Functional) -> Result<Sensitivity> {
        let workspace = &mut StiffnessWorkspace::new();
        let functionals = std::slice::from_ref(functional);
        let mut found = self.sensitivities_with(load, functionals, workspace, unwatched)?;
        // One functional has one sensitivity.
        Ok(found.remove(0))
    }

    /// Computes the [`sensitivity`](Self::sensitivity) of several functionals with the tolerance and the buffers of a workspace,
    /// and with an observer, like [`Solver::sensitivities_with`](crate::Solver::sensitivities_with).
    ///
    /// # Errors
    /// The errors of [`sensitivity`](Self::sensitivity).
    pub fn sensitivities_with(
        &self,
        load: &LoadStep,
        functionals: &[Functional],
        workspace: &mut StiffnessWorkspace,
        mut observer: impl FnMut(&Iteration) -> ControlFlow<()> + Send,
    ) -> Result<Vec<Sensitivity>> {
        let bodies = &self.bodies;
        let checked = self.check_step(load);
        check_functionals(bodies, (true, true), functionals, checked)?;
        workspace.check_alike(bodies)?;
        let observer: Observer<'_> = &mut observer;
        let (mut context, buffers) = workspace.begin(observer);
        bodies.joint(parallel::enter_with(bodies.grid().cells(), || {
            self.step_sensitivities(load, functionals, (buffers, &mut context))
        }))
    }

    /// Returns an error unless the step has sensitivities.
    fn check_step(&self, load: &LoadStep) -> Result<()> {
        if load.rolling().is_some() {
            return unsupported("rolling", "step without rolling");
        }
        if self.state.is_joint() {
            return unsupported(
                "full coupling of dissimilar bodies",
                "use a coupled problem, or one-way coupling",
            );
        }
        self.last_step()?;
        self.state.check_current("sensitivity")?;
        if let Some(press) = load.normal_control().load() {
            check_normal_load(press, self.normal())?;
        }
        let loads = ShearLoads {
            force: self.tangential_force(),
            shift: self.shift(),
            twist: self.twist(),
            capacity: self.friction_capacity(),
        };
        let is_current = loads.are_prescribed_by(&load.demand(self.twist()), None);
        check_current(is_current, "the tangential load")
    }

    /// Computes the sensitivities of a step that has passed [`Self::check_step`].
    fn step_sensitivities(
        &self,
        load: &LoadStep,
        functionals: &[Functional],
        (buffers, context): (&mut SystemBuffers, &mut ResponseContext<'_>),
    ) -> Result<Vec<Sensitivity>> {
        let (bodies, normal) = (&self.bodies, self.normal());
        let Some(window) = self.state.contact.as_ref().map(|memory| memory.window) else {
            return Err(Error::EmptyContact);
        };
        let mut pressed = PressureOnWindow::new(bodies, window)?;
        pressed.set(normal.pressure().as_slice(), self.friction());
        let solved = self.solved_contact(false);
        buffers.cells.take_zones(&pressed.region, self.zones())?;
        buffers.cells.take(&pressed.region, &solved)?;
        let sheared = Sheared {
            bodies,
            pressed: &pressed,
            friction: self.friction(),
            controls: load.demand(self.twist()).controls,
            is_drawn: solved.is_drawn,
            poisson_ratio: None,
        };
        let view = ContactView {
            bodies,
            pressure: normal.pressure().as_slice(),
            approach: Some(normal.approach()),
            lift: &[],
            shear: ShearView {
                traction: self.traction().map(Field::as_slice),
                slip: self.last_step()?.slip().map(Field::as_slice),
                zones: self.zones(),
                shift: self.shift(),
                displacement: [&[]; 2],
            },
        };
        let of = (&view, functionals);
        let mut found = sheared.solve(self.axis(), of, None, buffers, context)?;
        let fingerprint = normal.fingerprint();
        for found in &mut found {
            found.pressed = fingerprint;
            if !load.names_twist() {
                found.twist = None;
            }
        }
        let Some(press) = load.normal_control().load() else {
            return Ok(found);
        };
        let pressed = Pressed {
            bodies,
            hardness: solved.hardness,
            load: press,
            window: solved.windows[0],
        };
        let mut gradients = fallible::with_room(found.len())?;
        for (found, functional) in found.iter().zip(functionals) {
            let pressure = found.pressure.as_ref().map_or(&[][..], Field::as_slice);
            gradients.push(Gradient {
                pressure: fallible::copied(pressure)?,
                approach: functional.by_approach(),
                ..Gradient::default()
            });
        }
        let pressing = pressed.propagate(normal, &[], gradients, buffers, context)?;
        let chained = found.into_iter().zip(pressing);
        Ok(chained
            .map(|(shear, press)| Sensitivity {
                contact_modulus: None,
                poisson_ratio: None,
                ..shear.after(press)
            })
            .collect())
    }
}
