//! The touch rule: how far cells that come into contact within a step follow its motion.

use crate::cgm::reduce;
use crate::history::LoadStep;
use crate::history::state::State;
use crate::normal::{NormalControl, NormalSolution};
use crate::tangential::{Axis, Demand, Increment, Motion, TangentialControl, centre};

/// How far a cell that comes into contact within a step follows the motion of the step.
///
/// The whole page on it is that of [`crate::history`].
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum TouchRule {
    /// As far as it would if all that grew within the step stuck, where friction allows that.
    #[default]
    Growth,
    /// All of it, also the part before it touched: the rule of codes that know the start of the step only, such as
    /// CONTACT. The error is of first order in the length of steps in which the contact grows.
    WholeStep,
}

/// Growth of the force, relative to the force, below which it is round-off.
const NO_GROWTH: f64 = 1e-9;

/// Sets the offsets of the cells that come into contact back by what they do not follow of the motion.
///
/// Traction grows as $`c\,\Delta p`$ if all sticks. Its mean displacement over the contact is $`K c\,\Delta u_z`$, so
/// the shift that belongs to it is $`D_p = K c\,\Delta\delta_z`$, and a new cell follows $`C_{tt}(c\,\Delta p)`$ of it.
pub(super) fn follow_growth(
    increment: &mut Increment,
    state: &State,
    pressed: &NormalSolution,
    load: &LoadStep,
    demand: &Demand,
) {
    let before = state.pressure().as_slice();
    let touches = |(k, i): (usize, usize)| increment.pressed.pressure[k] > 0.0 && before[i] <= 0.0;
    let mut cells = increment.pressed.window.indices().enumerate();
    if state.touch_rule == TouchRule::WholeStep || !cells.any(touches) {
        return;
    }
    let Some(press) = Press::new(state, pressed, load) else {
        return;
    };
    increment.find_growth(before);
    let compliance = press.mean_compliance(increment);
    let Some(slope) = press.slope(state, demand, &compliance, increment.axes()) else {
        return;
    };
    let shift = times(&compliance, slope).map(|shift| shift * press.approach);
    let turn = Motion {
        shift: [0.0; 2],
        twist: demand.twist - state.motion.twist,
    };
    let grid = state.grid();
    for (k, i) in increment.pressed.window.indices().enumerate() {
        let pressure = increment.pressed.pressure[k];
        if pressure <= 0.0 || before[i] > 0.0 {
            continue;
        }
        let turned = turn.at(centre(grid, i));
        let turning = solve(&compliance, turned, increment.axes());
        let whole = [0, 1].map(|axis| slope[axis] + turning[axis] / press.approach);
        if whole[0].hypot(whole[1]) * pressure >= increment.pressed.limits.cells[k] {
            continue;
        }
        let missed = press.gap(i).clamp(0.0, press.approach) / press.approach;
        let columns = [Axis::X, Axis::Y].map(|axis| increment.growth(axis, k));
        let lag = [0, 1].map(|axis| {
            let followed = slope[0] * columns[0][axis] + slope[1] * columns[1][axis];
            shift[axis] - followed + missed * turned[axis]
        });
        increment.lag(k, lag);
    }
}

/// What the normal half of a step did.
struct Press<'a> {
    state: &'a State,
    pressed: &'a NormalSolution,
    /// Approach at the beginning of the step: that of first touch, if the load is a force and nothing touched yet.
    start: f64,
    /// Growth of the approach, positive.
    approach: f64,
    /// Growth of the normal force.
    force: f64,
}

impl<'a> Press<'a> {
    /// `None` if the bodies did not approach each other.
    fn new(state: &'a State, pressed: &'a NormalSolution, load: &LoadStep) -> Option<Self> {
        let force = pressed.force() - state.normal.force();
        let mut press = Self {
            state,
            pressed,
            start: state.approach(),
            approach: 0.0,
            force: if force.abs() > NO_GROWTH * pressed.force() {
                force
            } else {
                0.0
            },
        };
        let is_first = state.pressure().max() <= 0.0;
        if is_first && matches!(load.normal_control(), NormalControl::Force(_)) {
            let least = reduce::least(state.grid().cells(), |i| Some(press.gap(i)));
            press.start += least.map_or(0.0, |(_, gap)| gap);
        }
        press.approach = pressed.approach() - press.start;
        (press.approach > 0.0 && press.force >= 0.0).then_some(press)
    }

    /// Gap of a cell at the beginning of the step, after wear.
    fn gap(&self, index: usize) -> f64 {
        let worn = self.state.gap.as_slice()[index] - self.state.pressed_gap.as_slice()[index];
        let moved = self.start - self.state.approach();
        self.state.normal.gap().as_slice()[index] + worn - moved
    }

    /// Growth of the normal displacement of a cell.
    fn displacement(&self, index: usize) -> f64 {
        self.pressed.gap().as_slice()[index] - self.gap(index) + self.approach
    }

    /// K: the mean tangential displacement over the contact by the growth of the pressure as a traction, for each
    /// normal displacement. Rows are components of the displacement, columns those of the traction.
    fn mean_compliance(&self, increment: &Increment) -> [[f64; 2]; 2] {
        let pressed = &increment.pressed;
        let sums = pressed
            .window
            .indices()
            .enumerate()
            .fold([0.0; 5], |sums, (k, i)| {
                let normal = self.displacement(i);
                let weight = pressed.pressure[k] * normal;
                let [x, y] = [Axis::X, Axis::Y].map(|axis| increment.growth(axis, k));
                let parts = [normal, x[0], y[0], x[1], y[1]];
                std::array::from_fn(|at| sums[at] + weight * parts[at])
            });
        let [square, rest @ ..] = sums;
        let [xx, xy, yx, yy] = rest.map(|sum| sum / square);
        [[xx, xy], [yx, yy]]
    }

    /// c: the traction, for each pressure, with which the contact would grow under this load if all of it stuck.
    fn slope(
        &self,
        state: &State,
        demand: &Demand,
        compliance: &[[f64; 2]; 2],
        axes: &[Axis],
    ) -> Option<[f64; 2]> {
        let (mut rows, mut right) = ([[0.0; 2]; 2], [0.0; 2]);
        for &axis in axes {
            let a = axis.index();
            let (shift, force) = (state.shift()[a], state.force()[a]);
            let along = compliance[a].map(|part| part * self.approach);
            let unit = [0, 1].map(|b| if a == b { self.force } else { 0.0 });
            (rows[a], right[a]) = match demand.control(axis) {
                TangentialControl::Hold => (along, 0.0),
                TangentialControl::Shift(end) => (along, end - shift),
                TangentialControl::Force(end) if self.force > 0.0 => (unit, end - force),
                TangentialControl::Force(end) if end == force => {
                    ([0, 1].map(|b| f64::from(u8::from(a == b))), 0.0)
                }
                TangentialControl::Force(_) => return None,
                TangentialControl::Spring {
                    position,
                    stiffness,
                } => (
                    [0, 1].map(|b| unit[b] + stiffness * along[b]),
                    stiffness * (position - shift) - force,
                ),
            };
        }
        let slope = solve(&rows, right, axes);
        slope.iter().all(|part| part.is_finite()).then_some(slope)
    }
}

/// `A x`.
fn times(matrix: &[[f64; 2]; 2], x: [f64; 2]) -> [f64; 2] {
    matrix.map(|row| row[0] * x[0] + row[1] * x[1])
}

/// Solves for the unknowns along these axes; the others are zero.
fn solve(matrix: &[[f64; 2]; 2], right: [f64; 2], axes: &[Axis]) -> [f64; 2] {
    let mut x = [0.0; 2];
    if let [axis] = axes {
        let a = axis.index();
        x[a] = right[a] / matrix[a][a];
        return x;
    }
    let [[xx, xy], [yx, yy]] = *matrix;
    let determinant = xx * yy - xy * yx;
    [
        (yy * right[0] - xy * right[1]) / determinant,
        (xx * right[1] - yx * right[0]) / determinant,
    ]
}
