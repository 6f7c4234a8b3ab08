//! Loop of force and shift in a cycle, and tables of cycles.

use std::collections::HashMap;
use std::fmt::Write;

use crate::error::Result;
use crate::history::{Cycle, State};
use crate::numerics::cell_vector::norm;
use crate::warning::Warning;

/// Point of the loop of force and shift, at the start of a cycle or the end of a step.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub struct LoopPoint {
    /// Tangential force that body 2 exerts on body 1.
    pub force: [f64; 2],
    /// Shift of body 2 relative to body 1 since the start of the history (lengths).
    pub shift: [f64; 2],
    /// Moment of the tractions on body 1 about the origin of the grid (force times length).
    pub moment: f64,
    /// Rotation of body 2 relative to body 1 since the start of the history (radians).
    pub twist: f64,
}

impl LoopPoint {
    /// Returns the point of a state.
    pub(in crate::history) fn of(state: &State) -> Self {
        Self {
            force: state.tangential_force(),
            shift: state.shift(),
            moment: state.moment(),
            twist: state.twist(),
        }
    }
}

impl Cycle {
    /// Returns the work of the tangential force and the moment (a force times a length):
    /// $`\sum \tfrac12 (F_n + F_{n+1})\,\Delta\delta + \tfrac12 (M_n + M_{n+1})\,\Delta\varphi`$. For a closed loop
    /// this work is the area that the [points](Cycle::points) enclose.
    ///
    /// Around a closed loop, slip dissipates the [`work`](crate::history::EnergyBalance::work) of the balance. This
    /// work also includes the work of a changing [relative displacement](crate::tangential::RelativeDisplacement), such
    /// as the displacement due to a bulk stress. For coupled bodies it includes the work of the pressure. If the
    /// contact grows, the work excludes the motion that new cells have not followed.
    ///
    /// ```
    /// use stickslip::history::{Cycle, FrettingLoop, LoadPath};
    /// # use stickslip::*;
    /// # let grid = Grid::square(16, 8.0)?;
    /// # let rubber = Material::new(1.0, 0.5)?;
    /// # let bodies = HalfSpace::new(grid, ElasticPair::new(rubber, Material::rigid())?)?;
    /// # let ball = surface::sphere(grid, 10.0)?;
    /// # let mut history = History::builder(&bodies, &ball, Friction::coulomb(0.3)?).build()?;
    /// history.step(&LoadStep::hold().normal(NormalLoad::Force(0.5)))?;
    /// let mut cycle = Cycle::new(&history);
    /// let fretting = FrettingLoop::new(LoadPath::triangle([0.1, 0.0], 8)?, LoadStep::shift);
    /// fretting.cycle(&mut history, &mut cycle)?;
    /// // Only a force acts, so the loop encloses all work.
    /// assert!((cycle.work_of_loads() / cycle.energy().work - 1.0).abs() < 1e-9);
    /// # Ok::<(), Error>(())
    /// ```
    #[must_use]
    pub fn work_of_loads(&self) -> f64 {
        let steps = self.points().windows(2);
        let work = |ends: &[LoopPoint]| {
            let [from, to] = [ends[0], ends[1]];
            let along = |axis: usize| {
                0.5 * (from.force[axis] + to.force[axis]) * (to.shift[axis] - from.shift[axis])
            };
            let turn = 0.5 * (from.moment + to.moment) * (to.twist - from.twist);
            along(0) + along(1) + turn
        };
        steps.map(work).sum()
    }

    /// Returns the energy ratio $`E_d / (4\,Q^*\delta^*)`$. The ratio compares the dissipated energy with the energy of
    /// a rectangle around the loop. The dissipated energy $`E_d`$ is computed from the tractions at the end of each
    /// step. The ratio is zero without dissipation. It is infinite if energy was dissipated while the force or the
    /// shift was constant.
    ///
    /// $`Q^*`$ is half the length of the longest chord of the path of the force in the plane. $`\delta^*`$ is half the
    /// range of the shift along this chord. If body 2 turns, the product of the half ranges of moment and twist is
    /// added to $`Q^*\delta^*`$. On a sphere under a constant normal force the ratio grows to 1/5 at the limit of
    /// sliding (Mindlin & Deresiewicz). When the contact slides, the ratio approaches one. Fouvry, Kapsa & Vincent,
    /// Wear 185 (1995) 35, <https://doi.org/10.1016/0043-1648(94)06582-9>, use 1/5 for the transition from partial to
    /// gross slip. The ratio may exceed one if the load follows an elliptical path, or if the cycle contains
    /// several loops ([`Warning::RepeatedLoop`]). It has no meaning for [rolled](crate::LoadStep::roll) steps, nor for a path
    /// that does not return to its start.
    ///
    /// # Errors
    /// - [`Error::EmptyPath`](crate::Error::EmptyPath) if the cycle has no steps.
    pub fn energy_ratio(&self) -> Result<f64> {
        self.check_steps()?;
        let dissipated = self.energy().dissipated_energy;
        Ok(part_of(dissipated, total_energy(self.points())))
    }

    /// Returns the [loop](Cycle::points) of force and shift as CSV: a line of names, then one line for each point.
    ///
    /// ```
    /// use stickslip::history::Cycle;
    /// # use stickslip::*;
    /// # let grid = Grid::square(16, 8.0)?;
    /// # let rubber = Material::new(1.0, 0.5)?;
    /// # let bodies = HalfSpace::new(grid, ElasticPair::new(rubber, Material::rigid())?)?;
    /// # let ball = surface::sphere(grid, 10.0)?;
    /// # let mut history = History::builder(&bodies, &ball, Friction::coulomb(0.3)?).build()?;
    /// let mut cycle = Cycle::new(&history);
    /// history.step(&LoadStep::shift([0.1, 0.0]).normal(NormalLoad::Force(0.5)))?;
    /// cycle.add(&history)?;
    /// let text = cycle.points_as_csv();
    /// let names = "shift_x,shift_y,twist,force_x,force_y,moment";
    /// assert_eq!(text.lines().next(), Some(names));
    /// assert_eq!(text.lines().count(), 3);
    /// # Ok::<(), Error>(())
    /// ```
    #[must_use]
    pub fn points_as_csv(&self) -> String {
        let mut text = String::from("shift_x,shift_y,twist,force_x,force_y,moment\n");
        for point in self.points() {
            let ([dx, dy], [fx, fy]) = (point.shift, point.force);
            let (twist, moment) = (point.twist, point.moment);
            writeln!(text, "{dx:?},{dy:?},{twist:?},{fx:?},{fy:?},{moment:?}")
                .expect("writing to a string cannot fail");
        }
        text
    }

    /// Returns the warning about a cycle whose loads turn back but that does not close.
    pub(in crate::history) fn open_warning(&self) -> Option<Warning> {
        let is_loop = || {
            let ratio = self.energy_ratio().unwrap_or(f64::INFINITY);
            // The loads of steps that only press are round-off, in contrast to the energy.
            ratio < LARGEST_RATIO && turns_back(self.points())
        };
        let open = Warning::open_beyond(self.cyclic_residual().ok()?)?;
        is_loop().then_some(open)
    }

    /// Names of the columns of [`Cycle::summary_as_csv`], without a line ending.
    pub const SUMMARY_NAMES: &str = "steps,force_amplitude_x,force_amplitude_y,shift_amplitude_x,shift_amplitude_y,\
         dissipated_energy,energy_ratio,cyclic_residual,least_stick_ratio,largest_stick_ratio";

    /// Returns the cycle as a line of CSV without a line ending, for a table of cycles. The first columns are the
    /// number of steps, half the ranges of force and shift, and the dissipated energy. This energy is computed from the
    /// tractions at the ends of the steps. The last columns are the [energy ratio](Cycle::energy_ratio), the
    /// [residual](Cycle::cyclic_residual) and the [stick ratios](Cycle::stick_ratios).
    ///
    /// ```
    /// use stickslip::history::{Cycle, FrettingLoop, LoadPath};
    /// # use stickslip::*;
    /// # let grid = Grid::square(16, 8.0)?;
    /// # let rubber = Material::new(1.0, 0.5)?;
    /// # let bodies = HalfSpace::new(grid, ElasticPair::new(rubber, Material::rigid())?)?;
    /// # let ball = surface::sphere(grid, 10.0)?;
    /// # let mut history = History::builder(&bodies, &ball, Friction::coulomb(0.3)?).build()?;
    /// let fretting = FrettingLoop::new(LoadPath::triangle([0.1, 0.0], 4)?, |shift| {
    ///     LoadStep::shift(shift).normal(NormalLoad::Force(0.5))
    /// });
    /// let mut table = format!("{}\n", Cycle::SUMMARY_NAMES);
    /// let mut cycle = Cycle::new(&history);
    /// for _ in 0..3 {
    ///     fretting.cycle(&mut history, &mut cycle)?;
    ///     table += &(cycle.summary_as_csv()? + "\n");
    /// }
    /// assert!(table.lines().all(|line| line.split(',').count() == 10));
    /// assert!(table.lines().nth(3).is_some_and(|line| line.starts_with("4,")));
    /// # Ok::<(), Error>(())
    /// ```
    ///
    /// # Errors
    /// - [`Error::EmptyPath`](crate::Error::EmptyPath) if the cycle has no steps.
    pub fn summary_as_csv(&self) -> Result<String> {
        let ([fx, fy], [dx, dy]) = (self.force_amplitude(), self.shift_amplitude());
        let [least, largest] = self.stick_ratios()?;
        let (energy, ratio) = (self.energy().dissipated_energy, self.energy_ratio()?);
        let (steps, residual) = (self.steps(), self.cyclic_residual()?);
        Ok(format!(
            "{steps},{fx:?},{fy:?},{dx:?},{dy:?},{energy:?},{ratio:?},{residual:?},{least:?},{largest:?}"
        ))
    }
}

/// Returns half the difference between the largest and the least value over the loop.
pub(in crate::history) fn half_range(
    points: &[LoopPoint],
    value: impl Fn(&LoopPoint) -> f64,
) -> f64 {
    let values = points.iter().map(value);
    let ends = values.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], value| {
        [low.min(value), high.max(value)]
    });
    0.5 * (ends[1] - ends[0])
}

/// Largest distance of two points that count as equal, in half the ranges of the loop.
const EQUAL: f64 = 1e-2;

/// Energy ratio above which force and shift of a loop are round-off.
const LARGEST_RATIO: f64 = 100.0;

/// Smallest distance from the start that a loop reaches, in half the ranges of the loop.
const LEAST_EXTENT: f64 = 0.5;

/// Least excess of the length of a path over the distance of its ends for a path that turns back, in half the ranges of the path. The
/// excess is 0.3 for a quarter of a circle, 4 for a straight loop, and zero for a straight path in one direction.
const LEAST_DETOUR: f64 = 0.5;

/// Smallest part of shift or twist in the product of half ranges of loads and motions. A smaller part may be round-off.
const LEAST_PART: f64 = 1e-6;

/// Largest distance of two starts of which the later one is omitted if both steps have the same direction.
const SAME_START: f64 = EQUAL / 2.0;

/// Number of components by which starts are sorted into cells.
const SORTED: usize = 3;

/// Forces, shifts, moment and twist of a point, each scaled by half its range.
type Scaled = [f64; 6];

/// Returns whether the points contain a closed loop and a further step in the direction of its first step. A path that returns
/// through a point in another direction does not repeat a loop.
///
/// The starts are sorted into cells of side [`EQUAL`], so that a point is compared only with the starts near it. The cost is thus
/// proportional to the number of points.
pub(in crate::history) fn repeats_loop(points: &[LoopPoint]) -> bool {
    let (scaled, axes) = scaled_points(points);
    let change = |from: usize, to: usize| -> Scaled {
        std::array::from_fn(|i| scaled[to][i] - scaled[from][i])
    };
    let distance = |from: usize, to: usize| {
        let parts = change(from, to).into_iter();
        parts.fold(0.0, |size: f64, part| size.max(part.abs()))
    };
    let is_along = |one: usize, other: usize| {
        let products = change(one, one + 1)
            .into_iter()
            .zip(change(other, other + 1));
        products.fold(0.0, |sum, (a, b)| sum + a * b) > 0.0
    };
    let mut starts = HashMap::<[i64; SORTED], Vec<usize>>::new();
    // Starts whose loop has not yet reached its least extent.
    let mut waiting = Vec::new();
    let mut has_left = vec![false; points.len()];
    let before_last = points.len().saturating_sub(1);
    for (end, at) in scaled.iter().enumerate().take(before_last) {
        waiting.retain(|start| {
            has_left[*start] = distance(*start, end) >= LEAST_EXTENT;
            !has_left[*start]
        });
        let closes = |start: &usize| {
            let reached = distance(*start, end);
            has_left[*start]
                && reached <= EQUAL
                // Fine steps may be this close to the start before the loop closes.
                && distance(*start, end + 1) > reached
                && is_along(*start, end)
        };
        let place = axes.map(|axis| cell_of(axis.map_or(0.0, |axis| at[axis])));
        let mut near = neighbours(place, axes).filter_map(|cell| starts.get(&cell));
        if near.any(|starts| starts.iter().any(closes)) {
            return true;
        }
        let own = starts.entry(place).or_default();
        // A step without motion has no direction, so that it starts no loop.
        let is_new = is_along(end, end)
            && !own
                .iter()
                .any(|start| distance(*start, end) <= SAME_START && is_along(*start, end));
        if is_new {
            own.push(end);
            waiting.push(end);
        }
    }
    false
}

/// Returns whether the path of forces and moment, or the path of shift and twist, turns back towards its start. The path may also end
/// elsewhere, as the first loop between two turning points does.
fn turns_back(points: &[LoopPoint]) -> bool {
    let (scaled, _) = scaled_points(points);
    let [Some(first), Some(last)] = [scaled.first(), scaled.last()] else {
        return false;
    };
    [[0, 1, 4], [2, 3, 5]].into_iter().any(|parts| {
        let distance =
            |from: &Scaled, to: &Scaled| norm(parts.map(|part: usize| to[part] - from[part]));
        let steps = scaled.windows(2).map(|ends| distance(&ends[0], &ends[1]));
        let length: f64 = steps.sum();
        length >= distance(first, last) + LEAST_DETOUR
    })
}

/// Scales the points, and returns the components by which they are sorted into cells.
fn scaled_points(points: &[LoopPoint]) -> (Vec<Scaled>, [Option<usize>; SORTED]) {
    let values = |point: &LoopPoint| {
        let ([fx, fy], [x, y]) = (point.force, point.shift);
        [fx, fy, x, y, point.moment, point.twist]
    };
    let ranges: Scaled = std::array::from_fn(|i| half_range(points, |point| values(point)[i]));
    let [force, shift] = [ranges[0].max(ranges[1]), ranges[2].max(ranges[3])];
    let [of_shift, of_twist] = [force * shift, ranges[4] * ranges[5]];
    let is_large = |part: f64| part > LEAST_PART * (of_shift + of_twist);
    let weight = |part: f64, scale: f64| if is_large(part) { scale.recip() } else { 0.0 };
    let [force, shift] = [force, shift].map(|scale| weight(of_shift, scale));
    let [moment, twist] = [ranges[4], ranges[5]].map(|scale| weight(of_twist, scale));
    let weights = [force, force, shift, shift, moment, twist];
    let origin = points.first().map_or([0.0; 6], values);
    let scaled = points.iter().map(|point| {
        let values = values(point);
        std::array::from_fn(|i| weights[i] * (values[i] - origin[i]))
    });
    let mut varying = (0..6).filter(|i| weights[*i] * ranges[*i] > EQUAL);
    (scaled.collect(), std::array::from_fn(|_| varying.next()))
}

/// Returns the index of the cell of a coordinate.
#[expect(
    clippy::cast_possible_truncation,
    reason = "coordinates are at most two, except those that saturate"
)]
fn cell_of(coordinate: f64) -> i64 {
    (coordinate / EQUAL).floor() as i64
}

/// Returns a cell and its neighbours along the sorted components.
fn neighbours(
    place: [i64; SORTED],
    axes: [Option<usize>; SORTED],
) -> impl Iterator<Item = [i64; SORTED]> {
    (0..27).filter_map(move |code: i64| {
        let offsets = [code % 3 - 1, code / 3 % 3 - 1, code / 9 - 1];
        let is_used = |i: usize| offsets[i] == 0 || axes[i].is_some();
        let cell = std::array::from_fn(|i| place[i].saturating_add(offsets[i]));
        (0..SORTED).all(is_used).then_some(cell)
    })
}

/// Returns $`4 (Q^* \delta^* + M^* \varphi^*)`$, the energy that the loop would dissipate if it filled the rectangles
/// around it.
///
/// Force and shift are measured along the longest chord of the path of the force.
fn total_energy(points: &[LoopPoint]) -> f64 {
    let chord = longest_chord(points);
    let length = chord[0].hypot(chord[1]);
    let along = chord.map(|component| component / length.max(f64::MIN_POSITIVE));
    let shift = half_range(points, |point| {
        along[0] * point.shift[0] + along[1] * point.shift[1]
    });
    let moment = half_range(points, |point| point.moment);
    let twist = half_range(points, |point| point.twist);
    4.0 * (0.5 * length * shift + moment * twist)
}

/// Returns the vector between the two most distant points on the path of the force.
fn longest_chord(points: &[LoopPoint]) -> [f64; 2] {
    let mut longest = [0.0_f64; 2];
    for (later, to) in points.iter().enumerate() {
        for from in &points[..later] {
            let chord = [0, 1].map(|axis| to.force[axis] - from.force[axis]);
            if chord[0].hypot(chord[1]) > longest[0].hypot(longest[1]) {
                longest = chord;
            }
        }
    }
    longest
}

/// Returns the ratio of a part to the whole. The ratio is zero if the part is zero, and infinite if only the whole is
/// zero.
pub(in crate::history) fn part_of(part: f64, whole: f64) -> f64 {
    if part > 0.0 { part / whole } else { 0.0 }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::TAU;

    use super::*;

    fn point(force: [f64; 2], shift: [f64; 2]) -> LoopPoint {
        LoopPoint {
            force,
            shift,
            moment: 0.0,
            twist: 0.0,
        }
    }

    /// Compares each point with all starts, as the definition of a repeated loop states.
    fn repeats_by_definition(points: &[LoopPoint]) -> bool {
        let (scaled, _) = scaled_points(points);
        let change =
            |a: usize, b: usize| -> Scaled { std::array::from_fn(|i| scaled[b][i] - scaled[a][i]) };
        let distance = |a, b| {
            change(a, b)
                .into_iter()
                .fold(0.0, |m: f64, x| m.max(x.abs()))
        };
        let product = |a: Scaled, b: Scaled| (0..6).fold(0.0, |sum, i| sum + a[i] * b[i]);
        let last = points.len() - 1;
        (0..last).any(|start| {
            let mut has_left = false;
            (start + 1..last).any(|end| {
                has_left |= distance(start, end) >= LEAST_EXTENT;
                has_left
                    && distance(start, end) <= EQUAL
                    && distance(start, end + 1) > distance(start, end)
                    && product(change(start, start + 1), change(end, end + 1)) > 0.0
            })
        })
    }

    #[test]
    fn repeated_loop_is_found_like_by_comparison_of_all_points() {
        for steps in [8, 40, 200] {
            // Angle over one loop in steps, ratio of the axes, and growth of the loop per step.
            for (lag, growth) in [(0.3, 0.0), (0.3, 2e-3), (1.5, 0.0), (0.0, 0.0)] {
                for per_cent in [90, 100, 105, 130, 210] {
                    let angle = |step: usize| TAU * step as f64 / steps as f64;
                    let count = per_cent * steps / 100;
                    let path: Vec<_> = (0..=count)
                        .map(|step| {
                            let size = 3.0 + growth * step as f64;
                            let (x, y) = (angle(step), angle(step) - lag);
                            point(
                                [size * x.sin(), 0.1 * y.cos()],
                                [1e-3 * size * y.sin(), 0.0],
                            )
                        })
                        .collect();
                    let expected = repeats_by_definition(&path);
                    assert_eq!(
                        repeats_loop(&path),
                        expected,
                        "{steps} {lag} {growth} {per_cent}"
                    );
                    assert!(
                        growth > 0.0 || expected == (count > steps),
                        "{steps} {lag} {per_cent}"
                    );
                }
            }
        }
    }

    /// A comparison of all pairs of points would take a hundred times as long.
    #[test]
    fn cost_of_long_loop_is_proportional_to_its_points() {
        let steps = 10_000;
        let angle = |step: usize| TAU * step as f64 / steps as f64;
        let at = |step: usize| point([angle(step).sin(), 0.0], [(angle(step) - 0.3).sin(), 0.0]);
        let mut path: Vec<_> = (0..steps).map(at).collect();
        assert!(!repeats_loop(&path));
        path.extend((0..steps / 100).map(at));
        assert!(repeats_loop(&path));
    }
}
