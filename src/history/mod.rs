//! Histories of load: stick and slip that remember the steps before.
//!
//! Friction remembers: what slipped stays where it slipped to, and an unloaded contact keeps tractions
//! locked in. A [`History`] holds all that and takes one [`LoadStep`] after another, in each of which
//! normal load, tangential load, gap and friction may change.
//!
//! # A step
//! With the displacements $`u_n`$ and the shift $`\delta_n`$ before it, a step finds tractions q within the
//! friction limit m of its own pressure, and the slip of the step s:
//!
//! ```math
//! s = (C q - u_n) - (\delta - \delta_n), \qquad |q| \le m = \min(\mu p, \tau_{max}), \qquad
//! s = 0 \text{ where } |q| < m, \qquad q\,s \le 0 \text{ where } |q| = m .
//! ```
//!
//! This is the problem of [`crate::tangential`] with a linear term: the minimum over $`|q| \le m`$ of
//! $`\tfrac12 q' C q - S' q`$ under a force, or of $`\tfrac12 q' C q - (S + \delta)' q`$ under a shift, in which a
//! cell remembers the offset $`S = u - \delta`$ it slipped to last, so that errors of one step are not handed to the
//! next. A cell
//! that comes into contact within the step follows the motion from the moment it touches
//! ([`EntryRule`], [growing contacts](crate::guide::load_steps)). A cell that leaves
//! drops its traction. If the pressure alone changes, tractions are found anew under the
//! same force or the same shift, never cut.
//!
//! Prescribed is the force, the shift, or the far end of a spring ([`TangentialControl`](crate::TangentialControl)). A
//! force that friction no longer holds is [`Error::BeyondFrictionCapacity`](crate::Error::BeyondFrictionCapacity); one
//! at the limit slides the contact, with the least shift that makes all of it slip.
//!
//! Steps may be as long as the load goes one way: under an unchanged pressure the state after a monotonic
//! load does not depend on the steps that led there. This is the transient shift of
//! CONTACT (Kalker, *Three-Dimensional Elastic Bodies in Rolling Contact*, 1990,
//! <https://doi.org/10.1007/978-94-015-7889-9>); on the sphere it follows Mindlin & Deresiewicz, J. Appl. Mech. 20
//! (1953) 327, <https://doi.org/10.1115/1.4010702>. Where the load turns in the plane, the error of a step is in
//! proportion to its length: round a circle of force, four fifths of the sliding one, cycles of 32, 64 and 128
//! steps dissipate 14, 7 and 3.5 % too little; extrapolated from the first two or the last two, they agree to 0.2 %.
//!
//! Tractions are along one axis, those across neglected, as in the paper, unless
//! [`HistoryBuilder::model`] asks for both. Then each component of the load is prescribed on its own, as force, as
//! shift or by a spring of its own, slip opposes traction in direction, and body 2 may turn: a twist
//! $`\varphi`$ about the origin of the grid makes of the shift the motion $`\delta + \varphi\,(-y, x)`$ of each
//! cell. Signs are those of the crate: traction on body 1, shift and twist of body 2 relative to body 1.
//!
//! # Bodies of different materials
//! Where materials couple pressure and traction, each step finds both together ([`coupled`](crate::coupled)), with both
//! components of the traction whatever the model. $`u`$ is then the displacement by traction and pressure, and a change of
//! the normal load is a step of the tangential contact too: pressing draws the surfaces inwards and makes them slip. A
//! step that names no normal load holds the normal force, not the pressure. The [`EntryRule`] serves the slip that pressing
//! causes as it serves the prescribed motion. Where most of what enters slips, the error of a growing contact is of first
//! order in its steps: the stick
//! radius of a ball pressed in 1, 2, 4, 8, 16, 32 steps is 0.29, 0.37, 0.44, 0.47, 0.49, 0.497 of the contact's, where 0.5
//! is exact ($`\beta = 0.5`$, $`\mu = 0.299`$); equal growth of the contact radius spreads the steps best.
//! [`History::press`](crate::History::press) takes such steps, as many as a tolerance needs. Approach and
//! peak pressure hardly depend on them.
//!
//! # Rolling
//! In a step with [`LoadStep::roll`] the bodies roll by a length d, a number of whole cells, and the particles of both
//! surfaces move through the contact from its [leading edge](LeadingEdge) on. With $`T f(x) = f(x + d)`$, the value where a
//! particle was before the step, and the displacement $`u_n`$ of before, inside and outside the contact,
//!
//! ```math
//! s = C q + B q - T u_n - w, \qquad
//! w = d \begin{pmatrix} \xi - \varphi\,y \\ \eta + \varphi\,x \end{pmatrix},
//! ```
//!
//! with the creepages $`\xi, \eta`$ and the spin $`\varphi`$ per length rolled ([`Rolling`]), and x and y in the middle
//! of the way of the particle. Signs and the law B of cells that enter are those of steady [`rolling`](crate::rolling),
//! in which a history ends that rolls on under one load; [`EntryRule::WholeStep`] leaves the law out, as CONTACT does.
//! Shift and twist of the history grow by $`d\,(\xi, \eta)`$ and $`d\,\varphi`$. Along an axis of which a step names the
//! force, the creepage follows ([`StepResult::creepage`]).
//!
//! With the particles move their sums: slip, accumulated slip and dissipated energy of the [`State`]. They leave the grid
//! behind the contact, and come without any ahead of it. The fields of a [`StepResult`] are those of the cells, at the
//! end of the step, and so are distances and energies of a [`Cycle`]. Its slip amplitude and its residual compare states
//! of cells, through which other particles have passed: after rolled steps they say nothing, nor is a [`FrettingLoop`]
//! found steady.
//!
//! The gap is that of the step, in the frame of the contact: a form stays, and a texture moves with the particles, so
//! that a rough surface is given anew for every step, by [`History::set_gap`]. A cell that enters has closed the gap
//! under load that its particle had in the step before.
//!
//! In the [`EnergyBalance`] traction, displacement and elastic energy before the step are those of the particles; it closes
//! to round-off. The [stiffness](History::stiffness) of the vector model after such a step takes the compliance B of a
//! cell as the mean of its directions.
//!
//! A step that rolls is not modelled along an axis on which the grid repeats, with a shift or a twist of its own, with a
//! relative displacement, a spring or a permanent set, in [adaptive steps](AdaptiveSteps), or on bodies that ranks share.
//!
//! Rolled steps of [full coupling](crate::Coupling::Full) solve pressure and traction together. A history that rolls on
//! under one load ends in the solution of [`CoupledRollingProblem`](crate::rolling::CoupledRollingProblem). Rolled steps of
//! [one-way coupling](crate::Coupling::OneWay) have the warning
//! [`NeglectedLift`](crate::Warning::NeglectedLift).
//!
//! Of Carter's cylinder at 0.8 of the creepage at which it slides the force is within 2.1e-5 of $`\mu P`$ on 128 cells
//! after 30 half-widths, without the law within 3e-3. On the cells of CONTACT and without the law, tractions agree to
//! 2e-10 of the largest limit. On 32, 64 and 128 cells over the contact of a sphere, at the creepage at which the linear
//! theory reaches the friction limit, a rolled step takes 17, 17 and 19 products for the tractions (mean of the steps 11
//! to 30 after pressing), where one of a shift that grows as much takes 18, 19 and 20; under a load that grows by 1 % a
//! step 19, 19 and 20 for 21, 20 and 18. At 0.3 of this creepage it takes 17, 17 and 19 for 15, 16 and 18, and under the
//! growing load 18, 22 and 24 for 15, 17 and 19: most in the first steps, and in the steps 51 to 70 of another such run
//! 19, 21 and 21 for 15, 18 and 19.
//!
//! # All or nothing
//! A step that is refused, cancelled or does not converge leaves the history bit for bit as it was, with all
//! that the next step starts from: its [`State`]. A step that succeeded is taken back by [`History::set_state`].
//! [`State::to_bytes`] saves a state, and a history that is made from it continues to the same bits.
//!
//! A history that ranks share ([`ranks`](crate::ranks)) keeps a copy of its state while a step enters it, and allocates in
//! every step.
//!
//! # Cycles
//! A [`FrettingLoop`] takes a [`LoadPath`] again and again, until the loop is steady or as often as asked, and
//! lets an observer wear the gap on the way. A [`Cycle`] is what its steps add up to: slip, energy, loop of force
//! and shift, [`Regime`]. A simulator with a loop of its own over cycles calls [`FrettingLoop::cycle`]; one
//! with a loop over steps calls [`History::step`] and [`Cycle::add`].
//!
//! # Wear
//! [`wear`] turns the slip or the energy of steps or cycles into depth removed; [`History::set_gap`] gives it back,
//! with tractions and slip kept.
//!
//! The example `fretting_loop` draws:
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
