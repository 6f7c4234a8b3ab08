//! The touch rule: how far cells that come into contact within a step follow its motion.

use crate::cgm::reduce;
use crate::cgm::vector::{minus, plus};
use crate::error::Result;
use crate::field::Field;
use crate::half_space::HalfSpace;
use crate::history::LoadStep;
use crate::history::state::State;
use crate::normal::{NormalControl, NormalSolution};
use crate::tangential::{Axis, Demand, Growth, Increment, TangentialControl};

/// How far a cell that comes into contact within a step follows the motion of the step.
///
/// [`crate::guide::growing_contacts`] derives the first and compares the two.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum TouchRule {
    /// As far as it would if all that grows within the step stuck, where friction allows that.
    #[default]
    Growth,
    /// All of it, also the part before it touched: the rule of codes that use the start of the step only, such as
    /// CONTACT. The error is of first order in the length of steps in which the contact grows.
    WholeStep,
}

/// Growth of a force, as part of the largest there is, below which it is round-off.
const NO_GROWTH: f64 = 1e-9;

/// Relative spread below which the slope of a regression is undetermined.
const NO_SPREAD: f64 = 1e-12;

/// Sets the offsets of the cells that come into contact back by what they do not follow of the motion.
///
/// If all sticks, the tractions grow by $`(c + w\,e_z \times r)\,\Delta p`$, with r from the centre of $`\Delta p`$. A
/// new cell follows what that displaces it, instead of the motion of the step; where friction does not hold the
/// growth, it follows all of the motion. Returns whether there are such cells and such a growth.
pub(super) fn follow_growth(
    increment: &mut Increment,
    bodies: &HalfSpace,
    state: &State,
    pressed: &NormalSolution,
    load: &LoadStep,
    demand: &Demand,
) -> Result<bool> {
    let limits = increment.pressed.limits.sum;
    if !is_asked(bodies, state, pressed, demand, limits) {
        return Ok(false);
    }
    let Some(press) = Press::new(bodies, state, pressed, load) else {
        return Ok(false);
    };
    let (before, repeats) = (state.pressure().as_slice(), state.boundary().repeats());
    increment.set_pressing(repeats, before, |i| press.displacement(i))?;
    let turn = demand.twist - state.motion.twist;
    let Some(stuck) = Stuck::new(&press, increment, demand, turn)? else {
        return Ok(false);
    };
    increment.find_excess(|increment, k, point| {
        let was_contact = increment.before(k) > 0.0;
        was_contact.then(|| minus(stuck.displacement(increment, k), stuck.motion(point)))
    });
    for (k, point) in increment.points() {
        let pressure = increment.pressed.pressure[k];
        if pressure <= 0.0 || increment.before(k) > 0.0 {
            continue;
        }
        let [x, y] = stuck.traction(point);
        if x.hypot(y) * pressure < increment.pressed.limits.cells[k] {
            let excess = increment.growth.excess(k);
            let followed = minus(stuck.displacement(increment, k), excess);
            increment.lag(k, minus(stuck.motion(point), followed));
        }
    }
    Ok(true)
}

/// What the normal half of a step did.
struct Press<'a> {
    state: &'a State,
    pressed: &'a NormalSolution,
    /// Growth of the normal displacement of the cells that were in contact before: that of the approach but for wear.
    /// Positive.
    approach: f64,
    /// Growth of the normal force, not negative.
    force: f64,
}

impl<'a> Press<'a> {
    /// `None` if the bodies were not pressed further together.
    fn new(
        bodies: &HalfSpace,
        state: &'a State,
        pressed: &'a NormalSolution,
        load: &LoadStep,
    ) -> Option<Self> {
        let (before, after) = (state.normal.force(), pressed.force());
        let is_growth = !is_same(after, before, after);
        let mut press = Self {
            state,
            pressed,
            approach: 0.0,
            force: if is_growth { after - before } else { 0.0 },
        };
        press.approach = press.mean_displacement(bodies).unwrap_or_else(|| {
            pressed.approach() - press.first_approach(bodies, load.normal_control())
        });
        (press.approach > 0.0 && press.force >= 0.0).then_some(press)
    }

    /// Growth of the normal displacement of a cell.
    fn displacement(&self, index: usize) -> f64 {
        let displacement = |contact: &NormalSolution, gap: &Field| {
            contact.gap().as_slice()[index] + (contact.approach() - gap.as_slice()[index])
        };
        let state = self.state;
        displacement(self.pressed, &state.gap) - displacement(&state.normal, &state.pressed_gap)
    }

    /// Mean growth of the normal displacement where there was contact before, and is; `None` if that is nowhere.
    fn mean_displacement(&self, bodies: &HalfSpace) -> Option<f64> {
        let (before, after) = (
            self.state.pressure().as_slice(),
            self.pressed.pressure().as_slice(),
        );
        let [sum, weights] = reduce::sum(&bodies.grid_layout(), |i| {
            let weight = before[i].min(after[i]);
            if weight > 0.0 {
                [weight * self.displacement(i), weight]
            } else {
                [0.0; 2]
            }
        });
        (weights > 0.0).then(|| sum / weights)
    }

    /// Approach at the beginning of a step without contact before: that of first touch, if the load is a force.
    fn first_approach(&self, bodies: &HalfSpace, control: NormalControl) -> f64 {
        let state = self.state;
        match control {
            NormalControl::Force(_) => bodies.least(&state.gap),
            _ => state.approach(),
        }
    }

    /// The centre of the growth of the pressure; the origin if that has none.
    fn centre(&self, increment: &Increment) -> [f64; 2] {
        let pressed = &increment.pressed;
        let (sum, first) = reduce::sum(pressed.region.layout(), |k| {
            let grown = pressed.pressure[k] - increment.before(k);
            (grown, increment.point(k).map(|part| grown * part))
        });
        if self.force > 0.0 {
            first.map(|first| first / sum)
        } else {
            [0.0; 2]
        }
    }
}

/// How the contact would grow in the step if all of it stuck.
struct Stuck {
    /// The point the tractions turn about.
    centre: [f64; 2],
    /// Traction for each growth of pressure.
    slope: [f64; 2],
    /// The same for each distance from the centre.
    turning: f64,
    /// The shift at the centre that belongs to it.
    shift: [f64; 2],
    /// The rotation in the step.
    turn: f64,
}

impl Stuck {
    fn new(
        press: &Press<'_>,
        increment: &mut Increment,
        demand: &Demand,
        turn: f64,
    ) -> Result<Option<Self>> {
        for &axis in increment.axes() {
            let (growth, direction) = match axis {
                Axis::X => (Growth::AlongX, [1.0, 0.0]),
                Axis::Y => (Growth::AlongY, [0.0, 1.0]),
            };
            increment.find_growth(growth, |_| direction)?;
        }
        let mut stuck = Self {
            centre: press.centre(increment),
            slope: [0.0; 2],
            turning: 0.0,
            shift: [0.0; 2],
            turn,
        };
        if turn != 0.0 {
            increment.find_growth(Growth::About, |point| stuck.around(point))?;
            let Some(rotation) = stuck.rotation(press, increment) else {
                return Ok(None);
            };
            stuck.turning = turn / rotation;
        }
        let compliance = mean_compliance(increment);
        let [x, y] = stuck.centre;
        let turned = [-turn * y, turn * x];
        let Some(slope) = slope(press, demand, &compliance, turned, increment) else {
            return Ok(None);
        };
        stuck.slope = slope;
        let [x, y] = compliance.map(|row| row[0] * stuck.slope[0] + row[1] * stuck.slope[1]);
        stuck.shift = [x, y].map(|shift| shift * press.approach);
        let is_number = stuck.shift.iter().all(|shift| shift.is_finite());
        Ok(is_number.then_some(stuck))
    }

    /// Displacement of a point by a unit rotation about the centre.
    fn around(&self, point: [f64; 2]) -> [f64; 2] {
        let [x, y] = minus(point, self.centre);
        [-y, x]
    }

    /// The traction in a point for each growth of pressure.
    fn traction(&self, point: [f64; 2]) -> [f64; 2] {
        plus(self.slope, self.turning, self.around(point))
    }

    /// The motion of a point in the step.
    fn motion(&self, point: [f64; 2]) -> [f64; 2] {
        plus(self.shift, self.turn, self.around(point))
    }

    /// Displacement of a cell caused by the growth.
    fn displacement(&self, increment: &Increment, cell: usize) -> [f64; 2] {
        let part = |growth| increment.growth.displacement(growth, cell);
        let [x, y] = self.slope;
        let along_x = part(Growth::AlongX).map(|u| x * u);
        let along = plus(along_x, y, part(Growth::AlongY));
        plus(along, self.turning, part(Growth::About))
    }

    /// The rotation of the cells that were in contact at the beginning of the step, for each unit of `turning`: the
    /// regression of the rotation over the part of the step that a cell was apart, evaluated where that part is zero. On
    /// a sphere the rotation is linear in it.
    fn rotation(&self, press: &Press<'_>, increment: &Increment) -> Option<f64> {
        let pressed = &increment.pressed;
        let sums = reduce::sum(pressed.region.layout(), |k| {
            let [x, y] = self.around(increment.point(k));
            let [u, v] = increment.growth.displacement(Growth::About, k);
            let part = 1.0 - increment.growth.normal(k) / press.approach;
            let (weight, moment) = (
                pressed.pressure[k] * (x * x + y * y),
                pressed.pressure[k] * (x * u + y * v),
            );
            [
                weight,
                weight * part,
                weight * part * part,
                moment,
                moment * part,
            ]
        });
        let [ones, parts, squares, rotations, products] = sums;
        let determinant = ones * squares - parts * parts;
        let at_start = if determinant > NO_SPREAD * ones * ones {
            (squares * rotations - parts * products) / determinant
        } else {
            rotations / ones
        };
        (at_start.is_finite() && at_start > 0.0).then_some(at_start)
    }
}

/// K: the mean tangential displacement over the contact by the growth of the pressure as a traction, for each normal
/// displacement. Rows are components of the displacement, columns those of the traction.
fn mean_compliance(increment: &Increment) -> [[f64; 2]; 2] {
    let pressed = &increment.pressed;
    let (square, sums) = reduce::sum(pressed.region.layout(), |k| {
        let normal = increment.growth.normal(k);
        let weight = pressed.pressure[k] * normal;
        let [[xx, yx], [xy, yy]] = [Growth::AlongX, Growth::AlongY].map(|growth| {
            let displacement = increment.growth.displacement(growth, k);
            displacement.map(|part| weight * part)
        });
        (weight * normal, [[xx, xy], [yx, yy]])
    });
    sums.map(|row| row.map(|sum| sum / square))
}

/// c: the traction, for each growth of pressure, with which the contact would grow under this load if all of it stuck,
/// of a contact whose centre the twist moves by `turned`. `None` if a force is to grow that pressure does not.
fn slope(
    press: &Press<'_>,
    demand: &Demand,
    compliance: &[[f64; 2]; 2],
    turned: [f64; 2],
    increment: &Increment,
) -> Option<[f64; 2]> {
    let limit = increment.pressed.limits.sum * press.state.grid().cell_area();
    // One row per axis. That of an axis which the scalar model leaves out sets its component to zero.
    let (mut rows, mut right) = ([[1.0, 0.0], [0.0, 1.0]], [0.0; 2]);
    for a in increment.axes().iter().map(|axis| axis.index()) {
        let (shift, force) = (press.state.shift()[a], press.state.tangential_force()[a]);
        let by_shift = compliance[a].map(|part| part * press.approach);
        let by_force = rows[a].map(|part| part * press.force);
        (rows[a], right[a]) = match demand.controls[a] {
            TangentialControl::Hold => (by_shift, turned[a]),
            TangentialControl::Shift(end) => (by_shift, end - shift + turned[a]),
            TangentialControl::Force(end) if press.force > 0.0 => (by_force, end - force),
            TangentialControl::Force(end) if is_same(end, force, limit) => continue,
            TangentialControl::Force(_) => return None,
            TangentialControl::Spring {
                position,
                stiffness,
            } => (
                plus(by_force, stiffness, by_shift),
                stiffness * (position - shift + turned[a]) - force,
            ),
        };
    }
    let [[xx, xy], [yx, yy]] = rows;
    let determinant = xx * yy - xy * yx;
    let slope = [
        (yy * right[0] - xy * right[1]) / determinant,
        (xx * right[1] - yx * right[0]) / determinant,
    ];
    slope.iter().all(|part| part.is_finite()).then_some(slope)
}

/// Whether the rule has something to do in a step to this pressure, whose friction limits have this sum.
pub(super) fn is_asked(
    bodies: &HalfSpace,
    state: &State,
    pressed: &NormalSolution,
    demand: &Demand,
    limits: f64,
) -> bool {
    let limit = limits * state.grid().cell_area();
    let (before, after) = (state.pressure().as_slice(), pressed.pressure().as_slice());
    let touches = |i: usize| after[i] > 0.0 && before[i] <= 0.0;
    state.touch_rule == TouchRule::Growth
        && is_driven(state, demand, limit)
        && reduce::any(&bodies.grid_layout(), touches)
}

/// Whether the step asks for shear that the state does not have, as part of what friction holds.
fn is_driven(state: &State, demand: &Demand, limit: f64) -> bool {
    let asks = |a: usize| match demand.controls[a] {
        TangentialControl::Hold => false,
        TangentialControl::Shift(end) => end.to_bits() != state.shift()[a].to_bits(),
        TangentialControl::Force(end) => !is_same(end, state.tangential_force()[a], limit),
        TangentialControl::Spring {
            position,
            stiffness,
        } => {
            let force = stiffness * (position - state.shift()[a]);
            !is_same(force, state.tangential_force()[a], limit)
        }
    };
    asks(0) || asks(1) || demand.twist.to_bits() != state.motion.twist.to_bits()
}

/// Whether two forces differ by no more than round-off of a third.
fn is_same(one: f64, two: f64, scale: f64) -> bool {
    (one - two).abs() <= NO_GROWTH * scale.abs()
}
