//! Load histories: stick and slip that depend on all earlier steps.
//!
//! Friction has memory. A surface that has slipped keeps its slip, and an unloaded contact retains locked-in tractions.
//! A [`History`] stores this memory and takes one [`LoadStep`] after another. Normal load, tangential load, gap and
//! friction may change in each step.
//!
//! # A step
//! Let $`u_n`$ be the displacements and $`\delta_n`$ the shift before a step. The step finds tractions q within the
//! friction limit m under its pressure, and the slip s:
//!
//! ```math
//! s = (C q - u_n) - (\delta - \delta_n), \qquad |q| \le m = \min(\mu p, \tau_{max}), \qquad
//! s = 0 \text{ where } |q| < m, \qquad q\,s \le 0 \text{ where } |q| = m .
//! ```
//!
//! This is the problem of [`crate::tangential`] with a linear term. The solution is the minimum over $`|q| \le m`$ of
//! $`\tfrac12 q' C q - S' q`$ under a force, or of $`\tfrac12 q' C q - (S + \delta)' q`$ under a shift. Each cell
//! stores the offset $`S = u - \delta`$ of its last slip. Errors of a step are therefore not passed to the next step.
//!
//! A cell that comes into contact within the step follows the motion from the moment it touches ([`EntryRule`],
//! [growing contacts](crate::guide::load_steps)). A cell that leaves the contact loses its traction. If only the
//! pressure changes, the step solves for the tractions again under the same force or the same shift. It never cuts them
//! off at the new friction limit.
//!
//! A load prescribes the force, the shift, or the far end of a spring
//! ([`TangentialControl`](crate::TangentialControl)). A force beyond the friction capacity is an error
//! ([`Error::BeyondFrictionCapacity`](crate::Error::BeyondFrictionCapacity)). A force at the limit slides the contact,
//! with the least shift at which the whole contact slips.
//!
//! Steps may be long if the load increases in one direction. Under an unchanged pressure, the state after a monotonic
//! load does not depend on the length of the steps. This is the transient shift of CONTACT (Kalker, *Three-Dimensional
//! Elastic Bodies in Rolling Contact*, 1990, <https://doi.org/10.1007/978-94-015-7889-9>). On the sphere the solution
//! agrees with Mindlin & Deresiewicz, J. Appl. Mech. 20 (1953) 327, <https://doi.org/10.1115/1.4010702>.
//!
//! If the load turns in the plane, the error of a step is proportional to its length. An example is a force that moves
//! around a circle at 0.8 of the sliding force. Cycles of 32, 64 and 128 steps dissipate 14, 7 and 3.5 % too little.
//! Extrapolations from the first two and from the last two of these results agree to 0.2 %.
//!
//! By default the tractions act along one axis, and tractions across it are neglected, as in the paper.
//! [`HistoryBuilder::model`] selects both components. The slip of a cell is then opposite to its traction. Each
//! component of the load is prescribed separately, as a force, as a shift or by its own spring. Body 2 may also rotate.
//! With a twist $`\varphi`$ about the origin of the grid, the motion of each cell is $`\delta + \varphi\,(-y, x)`$. The
//! sign convention of the crate applies: traction on body 1, shift and twist of body 2 relative to body 1.
//!
//! # Bodies of different materials
//! If the materials couple pressure and traction, each step solves for both together ([`coupled`](crate::coupled)). The
//! solve includes both components of the traction in the scalar and in the vector model. Then $`u`$ is the displacement
//! due to traction and pressure. A change of the normal load also changes the tangential contact, because pressing
//! draws the surfaces inwards and makes them slip. A step without a normal load keeps the normal force, not the
//! pressure. The [`EntryRule`] also applies to the slip caused by pressing.
//!
//! The error of a growing contact is of first order in the length of its steps if most of the new contact cells slip.
//! An example is a ball with $`\beta = 0.5`$ and $`\mu = 0.299`$, for which the exact ratio of stick radius to contact
//! radius is 0.5. If the ball is pressed in 1, 2, 4, 8, 16 and 32 steps, the ratio is 0.29, 0.37, 0.44, 0.47, 0.49 and
//! 0.497. Steps of equal growth of the contact radius are the most accurate. [`History::press`](crate::History::press)
//! takes as many of these steps as a tolerance requires. Approach and peak pressure hardly depend on the number of
//! steps.
//!
//! In a step with [`LoadStep::roll`] the bodies roll by a length d, a whole number of cells. The particles of both
//! surfaces move through the contact from its [leading edge](LeadingEdge). Let $`T f(x) = f(x + d)`$ be the value at
//! the position of a particle before the step. Let $`u_n`$ be the previous displacement inside and outside the contact.
//! Then
//!
//! ```math
//! s = C q + B q - T u_n - w, \qquad
//! w = d \begin{pmatrix} \xi - \varphi\,y \\ \eta + \varphi\,x \end{pmatrix},
//! ```
//!
//! with the creepages $`\xi, \eta`$ and the spin $`\varphi`$ per length rolled ([`Rolling`]), and x and y at the middle
//! of the path of the particle. Signs and the entry compliance B are the same as in steady [`rolling`](crate::rolling),
//! to which a history converges under constant load. [`EntryRule::WholeStep`] omits the entry compliance, as CONTACT
//! does. Shift and twist of the history grow by $`d\,(\xi, \eta)`$ and $`d\,\varphi`$. If a step prescribes the force
//! along an axis, the creepage along this axis follows ([`StepResult::creepage`]).
//!
//! The fields of the [`State`] that sum over steps move with the particles: slip, accumulated slip and dissipated
//! energy. The sums leave the grid behind the contact, and particles that enter the grid have zero sums. The fields of
//! a [`StepResult`], and the distances and energies of a [`Cycle`], belong to the cells at the end of the step. The
//! slip amplitude and the residual of a cycle compare states of cells, through which other particles have passed. These
//! two results have no meaning after rolled steps, and a [`FrettingLoop`] does not detect a steady state.
//!
//! The gap of a step is given in the frame of the contact. A macroscopic form stays in place, but a texture moves with
//! the particles. A rough surface therefore needs a new gap in every step ([`History::set_gap`]). A cell that enters
//! the contact has closed the gap under load that its particle had in the previous step.
//!
//! In the [`EnergyBalance`] of a rolled step, traction, displacement and elastic energy before the step belong to the
//! particles. The balance closes to round-off. The [stiffness](History::stiffness) of the vector model after a rolled
//! step uses the entry compliance B averaged over all directions.
//!
//! Rolling is not supported in the following cases:
//!
//! - along a periodic axis,
//! - with a shift or twist in the same step,
//! - with a relative displacement, a spring or a permanent set,
//! - in [adaptive steps](AdaptiveSteps),
//! - on distributed bodies.
//!
//! Rolled steps with [full coupling](crate::Coupling::Full) solve for pressure and traction together. Under constant
//! load such a history converges to the solution of [`CoupledRollingProblem`](crate::rolling::CoupledRollingProblem).
//! Rolled steps with [one-way coupling](crate::Coupling::OneWay) have the warning
//! [`StepLift`](crate::Warning::NeglectedLift).
//!
//! The following errors are for Carter's cylinder at 0.8 of the creepage of sliding, on 128 cells after 30 half-widths.
//! The error of the force is within 2.1e-5 of $`\mu P`$, or within 3e-3 of it without the entry compliance. Tractions
//! computed without the entry compliance on the grid of CONTACT agree with the tractions of CONTACT to 2e-10 of the
//! largest friction limit.
//!
//! The next table lists the number of operator products per step for the tractions of a sphere. The three numbers are
//! for 32, 64 and 128 cells over the contact. The numbers are means over steps 11 to 30 after pressing. The creepage is
//! relative to the creepage at which the linear theory reaches the friction limit. The last column shows a step without
//! rolling that changes the shift by the same amount.
//!
//! | creepage | normal load | rolled step | step without rolling |
//! |---|---|---|---|
//! | 1 | constant | 17, 17, 19 | 18, 19, 20 |
//! | 1 | grows by 1 % per step | 19, 19, 20 | 21, 20, 18 |
//! | 0.3 | constant | 17, 17, 19 | 15, 16, 18 |
//! | 0.3 | grows by 1 % per step | 18, 22, 24 | 15, 17, 19 |
//! | 0.3 | grows by 1 % per step, steps 51 to 70 of another run | 19, 21, 21 | 15, 18, 19 |
//!
//! At the creepage 0.3 under the growing load, the first of these steps take the most products.
//!
//! # Failed steps
//! A step that is rejected, is cancelled or does not converge leaves the [`State`] of the history bitwise unchanged.
//! The state includes everything that the next step starts from. [`History::set_state`] undoes a successful step.
//! [`State::to_bytes`] saves a state, and a history created from these bytes continues with bitwise identical results.
//!
//! A history on distributed bodies ([`ranks`](crate::ranks)) copies its state before it commits a step, and allocates
//! in every step.
//!
//! A [`FrettingLoop`] repeats a [`LoadPath`] until the loop is steady or for a given number of cycles. Its observer may
//! apply wear to the gap between steps. A [`Cycle`] accumulates the results of its steps: slip, energy, loop of force
//! and shift, and [`Regime`]. A simulator with its own loop over cycles calls [`FrettingLoop::cycle`]. A simulator with
//! its own loop over steps calls [`History::step`] and [`Cycle::add`].
//!
//! # Wear
//! [`wear`] converts the slip or the energy of steps or cycles to wear depth. [`History::set_gap`] applies the depth
//! and keeps tractions and slip.
//!
//! The example `fretting_loop` plots:
#![cfg_attr(doc, doc = include_str!("../pictures/fretting_loop.html"))]

mod builder;
mod cycle;
mod energy;
mod load;
mod path;
mod saved;
mod state;
mod step;
pub mod wear;

pub use crate::rolling::leading_edge::LeadingEdge;
pub use crate::tangential::entry_rule::EntryRule;
pub use builder::HistoryBuilder;
pub use cycle::Cycle;
pub use cycle::Regime;
pub use cycle::fretting_loop::{FrettingLoop, FrettingResult, StopReason};
pub use cycle::hysteresis::LoopPoint;
pub use energy::EnergyBalance;
pub use load::LoadStep;
pub use path::LoadPath;
pub use state::State;
pub use step::History;
pub use step::adaptive::{AdaptiveSteps, StepErrorEstimate};
pub use step::result::StepResult;
pub use step::rolled::Rolling;
