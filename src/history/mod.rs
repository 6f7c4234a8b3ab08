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
//! The problem of a step is the problem of [`crate::tangential`] with an additional linear term. The solution is the
//! minimum over $`|q| \le m`$ of $`\tfrac12 q' C q - S' q`$ under a force, or of $`\tfrac12 q' C q - (S + \delta)' q`$
//! under a shift. Each cell stores the offset $`S = u - \delta`$ of its last slip. Errors of a step are therefore not
//! passed to the next step.
//!
//! A cell that comes into contact within the step follows the motion from the moment it touches ([entry rule](#entry-rule)). A
//! cell that leaves the contact loses its traction. If only the pressure changes, the step solves for the tractions again under
//! the same force or the same shift. It never truncates the tractions at the new friction limit.
//!
//! A load prescribes the force, the shift, or the far end of a spring
//! ([`TangentialControl`](crate::TangentialControl)). A force beyond the friction capacity causes an error
//! ([`Error::BeyondFrictionCapacity`](crate::Error::BeyondFrictionCapacity)). A force at the limit slides the contact,
//! with the least shift at which the whole contact slips.
//!
//! Steps may be long if the load increases in one direction. Under an unchanged pressure and with tractions along one
//! axis, the state after a monotonic load does not depend on the steps. The page on [load
//! steps](crate::guide::load_steps#number-of-steps) lists errors for other cases. A step corresponds to a transient
//! shift of CONTACT (Kalker, *Three-Dimensional Elastic Bodies in Rolling Contact*, 1990,
//! <https://doi.org/10.1007/978-94-015-7889-9>). On the sphere the solution agrees with Mindlin & Deresiewicz, J. Appl.
//! Mech. 20 (1953) 327, <https://doi.org/10.1115/1.4010702>.
//!
//! The [assumptions](crate::tangential#assumptions) of a tangential problem apply in every step. Between steps the gap stays in
//! place: neither shift nor twist moves it. [`History::set_gap`] moves it for sliding distances that are not small.
//!
//! If the load turns in the plane, the error of a step is proportional to its length. An example is a force that moves
//! around a circle at 0.8 of the sliding force. Cycles of 32, 64 and 128 steps dissipate 14, 7 and 3.5 % too little.
//! Extrapolations from the first two and from the last two of these results agree to 0.2 %.
//!
//! By default the tractions act along one axis, and tractions across it are neglected, as in Wang et al. (2021).
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
//! If most of the cells that come into contact slip, the error of a growing contact is of first order in the length of
//! its steps. [`History::press`](crate::History::press) takes steps of equal growth of the contact radius, as many as a
//! tolerance requires. The page on [load steps](crate::guide::load_steps#number-of-steps) lists the number of steps for
//! a given accuracy.
//!
//! # Rolling
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
//! [`NeglectedLift`](crate::Warning::NeglectedLift).
//!
//! For Carter's cylinder at 0.8 of the creepage of sliding, on 128 cells after 30 half-widths, the error of the force is at most
//! 2.1e-5 of $`\mu P`$. Without the entry compliance it is at most 3e-3 of $`\mu P`$. On the cells of CONTACT, without the entry
//! compliance and with a tolerance of 1e-11, the forces agree with the forces of CONTACT to 1e-10 of $`\mu P`$.
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
//! # Entry rule
//! A step computes the state at its end from the state at its beginning. A sticking cell follows the motion of body 2
//! in the step, $`u_{n+1} - u_n = \Delta`$. This is correct for a cell that was in contact during the whole step. An
//! entering cell comes into contact during the step. At the beginning its surfaces are separated. They move past each
//! other without friction until they touch. If the cell follows all of $`\Delta`$ ([`EntryRule::WholeStep`], the rule
//! of codes such as CONTACT), its traction is too large. This error is of first order in the length of the step.
//!
//! [`EntryRule::SinceTouch`], the default, gives each entering cell an additional compliance $`B`$, the entry
//! compliance, in the step in which it enters. With the offset $`S`$ stored for the cell, its slip is
//!
//! ```math
//! s = C q + B q - S - \delta, \qquad B = \kappa\,\frac{g}{p}, \qquad
//! \kappa = 1 + \frac{c_l}{2 c_n}, \qquad c_n = \sum_{1, 2} \frac{1 - \nu}{G}, \qquad c_l = \sum_{1, 2} \frac{\nu}{G} ,
//! ```
//!
//! with the gap g of the cell at the beginning of the step and its pressure p at the end. For bodies of the same
//! material $`\kappa`$ is $`(1 - \nu/2)/(1 - \nu)`$. This is the ratio of tangential to normal displacement of a square
//! cell under equal traction and pressure. A round punch has the same ratio.
//!
//! During the step the pressure grows by $`\Delta p`$ and the bodies approach by $`\Delta\delta_z`$. If the whole
//! growing contact sticks, the traction grows as $`\Delta q = c\,\Delta p`$, with one vector c for all cells (J.
//! Jaeger, J. Tribology 120 (1998) 677, <https://doi.org/10.1115/1.2833765>). This traction displaces cells that were
//! already in contact by $`c\,\kappa\,\Delta\delta_z`$, and an entering cell by $`c\,\kappa\,(\Delta\delta_z - g)`$.
//! The difference $`\kappa\,g\,c`$ equals $`\kappa\,(g/p)\,q`$, because pressure and traction of an entering cell were
//! zero before the step. A cell that follows the motion from the moment of touching therefore lags behind it by
//! $`B q`$. This result depends neither on the direction of c nor on the kind of load: force, shift, spring and twist
//! are treated in the same way. A cell that slips from the moment of touching has $`q = -\mu p\,s/|s|`$. In such a
//! cell $`B q`$ is parallel to the slip and changes only its magnitude, so the traction is the same as with the
//! whole-step rule.
//!
//! For a prescribed force, the gap is measured from the position in which the approaching bodies first touch, because
//! no cell carries load before that. After wear between two steps, the gap of the worn bodies is used. The friction
//! limits, the slip directions and the data stored for the next step are the same as in any other step. $`B`$ is a
//! non-negative diagonal matrix that does not depend on the tractions. For a given pressure, the problem therefore
//! remains the minimisation of a convex function, with the same certificate.
//!
//! | load | error with whole steps | error with the entry rule |
//! |---|---|---|
//! | pressure unchanged or decreasing | zero from entering cells | zero from entering cells |
//! | straight leg with $`\lvert c\rvert < \mu`$, $`\nu = 0`$, any surface, uniform friction | first order | zero |
//! | straight leg with $`\lvert c\rvert < \mu`$, $`\nu = 0.3`$ | first order | 10 to 17 times smaller in one step |
//! | bent path, $`\nu = 0`$ | first order | second order |
//! | bent path, $`\nu = 0.3`$ | first order | order 1.7, measured |
//! | twist | first order | 5 to 19 times smaller in one step, order 1.6, measured |
//! | leg with $`\lvert c\rvert > \mu`$ | first order | equal to the error with whole steps |
//!
//! A leg is straight if approach and shift, or normal and tangential force, remain proportional. For whole steps under
//! a proportional force, the error of the shift is proportional to the square root of the length of the step. With
//! eight steps it is about 10 %.
//!
//! The next table lists the error of the traction field, $`\sum|q - q_{ref}| / \sum|q_{ref}|`$. The columns are for one
//! step and eight steps per leg, with whole steps and with the entry rule. The command
//! `cargo run --release -p stickslip-examples --example growing_contact` computes these values and the values for four
//! steps. The contacts are smooth and rough balls on 64 x 64 cells, with the vector model and $`\mu = 0.5`$. The
//! reference has 64 steps per leg.
//!
//! | path | bodies | whole, 1 step | rule, 1 step | whole, 8 steps | rule, 8 steps |
//! |---|---|---|---|---|---|
//! | shift, proportional, oblique | $`\nu = 0`$, rough | 5.1e-1 | 9e-12 | 1.2e-1 | 1e-11 |
//! | shift, with a slip zone | $`\nu = 0`$, rough | 1.7e-1 | 1e-11 | 2.7e-2 | 1e-11 |
//! | force, proportional | $`\nu = 0`$, rough | 4.5e-1 | 1e-11 | 1.2e-1 | 1e-11 |
//! | force, turning | $`\nu = 0`$, rough | 1.1e-1 | 1e-11 | 1.4e-2 | 1e-11 |
//! | shift, proportional, oblique | $`\nu = 0.3`$, ball | 5.6e-1 | 3.6e-2 | 1.6e-1 | 1.1e-2 |
//! | shift, turning | $`\nu = 0.3`$, ball | 8.6e-2 | 2.1e-2 | 1.2e-2 | 1.4e-3 |
//! | shift, $`\lvert c\rvert > \mu`$ | $`\nu = 0.3`$, ball | 5.0e-3 | 5.0e-3 | 8.8e-4 | 8.8e-4 |
//! | force, with a slip zone | $`\nu = 0.3`$, ball | 1.4e-1 | 1.4e-2 | 2.3e-2 | 1.3e-3 |
//! | shift, proportional, oblique | $`\nu = 0.3`$, rough | 6.0e-1 | 3.6e-2 | 1.4e-1 | 8.1e-3 |
//! | shift, turning | $`\nu = 0.3`$, rough | 8.4e-2 | 1.9e-2 | 1.1e-2 | 1.2e-3 |
//! | force, with a slip zone | $`\nu = 0.3`$, rough | 1.4e-1 | 1.3e-2 | 2.0e-2 | 1.4e-3 |
//!
//! The largest error remains for a ball with $`\nu = 0.3`$. The tangential displacement of its entering cells depends
//! on their direction from the centre, and $`\kappa`$ averages over this direction. One long step from zero load has an
//! error of 3.6 % of the tractions. A rule can be derived for a ball whose contact sticks everywhere while it grows. It
//! is exact for this case, because the traction under a circular punch has the same profile as the pressure. On rough
//! contacts, however, the error of such a rule in a few steps is up to four times the error of the entry rule. If a
//! tensor that depends on the normal of the gap replaces $`\kappa`$, the error of a ball is halved. The error of rough
//! contacts grows by a third (measured on 24 x 24 cells with explicit matrices). A twist from zero load has these
//! errors:
//!
//! | $`\nu`$ | whole steps, 1 step | entry rule, 1 step | entry rule, 4 steps |
//! |---|---|---|---|
//! | 0 | 61 % | 11 % | 1.4 % |
//! | 0.3 | 78 % | 5 % | 1.8 % |
//!
//! If the materials couple pressure and traction, the same solve determines the pressure on which $`B`$ depends. The
//! entry rule then applies to slip caused by pressing and to slip caused by the prescribed motion. The table lists the
//! error of the shift, in per cent, for a sphere. Its normal load increases to six times the initial value while a
//! force $`F = 0.6\,\mu\,\Delta W`$ shears it:
//!
//! | $`\beta`$ | $`\mu`$ | rule, 1 step | rule, 4 steps | whole, 1 step | whole, 4 steps |
//! |---|---|---|---|---|---|
//! | 0.09 | 0.2 | 0.7 | 0.3 | 7.4 | 1.3 |
//! | 0.09 | 0.6 | 0.2 | 0.05 | 11 | 2.9 |
//! | 0.29 | 0.2 | 0.1 | 0.6 | 1.4 | 0.7 |
//! | 0.29 | 0.6 | 1.3 | 0.3 | 5.9 | 0.9 |
//! | 0.5 | 0.2 | 9.1 | 2.7 | 9.1 | 2.7 |
//! | 0.5 | 0.6 | 0.6 | 0.1 | 0.3 | 0.6 |
//!
//! With the entry rule, a contact that sticks everywhere while it is pressed does so for any number of steps. For
//! example, a sphere pressed on a rigid plane in one step with $`\beta = 0.09`$ and $`\mu = 0.3`$ does not slip. With
//! the whole-step rule, it slips beyond 0.87 of the contact radius. If most of the contact slips ($`\beta = 0.5`$,
//! $`\mu = 0.3`$), the two rules agree to first order for two steps or more.
//!
//! If pressure and traction are solved sequentially, the entry rule needs no additional products. The preconditioner
//! includes $`B`$ in the same way as the stiffness of slipping cells. A solve takes as many products with the rule as
//! without it (within 3 %, over the paths of the example on smooth and rough balls). If pressure and traction are
//! coupled, long steps take 5 to 85 % more products with the entry rule than with the whole-step rule.
//!
//! # Energy of a growing contact
//! The traction of an entering cell acts over the part of the motion that the cell follows, and
//! [`EnergyBalance::work`] counts only this part. The energies of a step balance to round-off with and without the
//! entry rule. Growth without slip dissipates no energy.
//!
//! If all slip happens before or after the growth, the [`dissipated_energy`](EnergyBalance::dissipated_energy) of one
//! step per leg equals the energy of many steps. If cells slip while the contact grows, the energies differ. Slip that
//! started under a small pressure is then multiplied by the friction limit at the end of the step. The error of the
//! energy is then of first order, even if tractions and force are exact.
//!
//! The table lists ratios to the dissipated energy of many steps, for a steel ball on 64 x 64 cells. Its load grows
//! from 100 to 200 N while a shift proportional to the load (2e-6 m) shears it into slip:
//!
//! | steps | rule | energy of final tractions | [energy of mean tractions](EnergyBalance::dissipated_energy_midpoint) |
//! |---|---|---|---|
//! | 1 | entry rule | 1.9 | 0.94 |
//! | 10 | entry rule | 1.1 | 0.999 |
//! | 1 | whole step | 5.3 | |
//!
//! # Failed steps
//! A step that is rejected, is cancelled or does not converge leaves the [`State`] of the history bitwise unchanged.
//! The state includes everything that the next step starts from. [`History::set_state`] undoes a successful step.
//! [`State::to_bytes`] saves a state, and a history created from these bytes continues with bitwise identical results
//! ([limits on other machines](crate::guide::embedding#restart)).
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
pub use step::batch::StepFailures;
pub use step::result::StepResult;
pub use step::rolled::Rolling;
