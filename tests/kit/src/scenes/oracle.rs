//! Reference solutions of a scene: from the dense reference, or from a second solve with a smaller tolerance.

use std::time::Duration;

use stickslip::cgm::{Bounds, Method, NonNegative};
use stickslip::dense::DenseOperator;
use stickslip::influence::Component;
use stickslip::{
    Axis, Boundary, Coupling, Friction, HalfSpace, NormalLoad, NormalProblem, NormalSolution,
    Result, TangentialControl, TangentialLoad, TangentialProblem, TangentialSolution,
};

use super::{RandomScene, Shear};

/// A reference solution on the whole grid.
#[derive(Debug)]
pub(crate) struct ReferenceSolution {
    pub(crate) x: Vec<f64>,
    /// Bound of the error of the reference, relative in the energy norm.
    pub(crate) error: f64,
    pub(crate) against: &'static str,
}

impl ReferenceSolution {
    fn exact(x: Vec<f64>) -> Self {
        Self {
            x,
            error: 0.0,
            against: "dense twin",
        }
    }
}

/// Time limit of a reference solve.
const PATIENCE: Duration = Duration::from_secs(20);

/// Relative deficit within which a force counts as the friction limit.
const SLIDING: f64 = 1.1e-12;

/// Returns the tolerance of a reference solve.
fn finer(tolerance: f64) -> f64 {
    (1e-3 * tolerance).max(1e-12)
}

/// Returns the reference pressure for the force or the approach that was found.
pub(crate) fn pressure(
    scene: &RandomScene,
    found: &NormalSolution,
    method: Method,
    dense_limit: usize,
) -> Option<ReferenceSolution> {
    let grid = scene.gap.grid();
    let is_periodic = scene.bodies.boundary() == Boundary::Periodic;
    let (datum, total) = match scene.load {
        NormalLoad::Force(force) => (scene.gap.min(), Some(force / grid.cell_area())),
        // The certified error is relative to the contact under the force found.
        NormalLoad::Approach(_) if is_periodic => {
            let total = found.pressure().as_slice().iter().sum();
            (scene.gap.min(), Some(total))
        }
        NormalLoad::Approach(approach) => (approach, None),
        _ => return None,
    };
    if grid.cells() <= dense_limit {
        let linear: Vec<f64> = scene.gap.as_slice().iter().map(|h| h - datum).collect();
        let all: Vec<usize> = (0..grid.cells()).collect();
        let answer = matrix(&scene.bodies, Component::ZZ, &all)
            .and_then(|matrix| matrix.minimise(&linear, &NonNegative, total));
        if let Ok(minimum) = answer {
            return Some(ReferenceSolution::exact(minimum.x));
        }
    }
    let load = match (scene.load, total) {
        (NormalLoad::Approach(_), Some(total)) => NormalLoad::Force(total * grid.cell_area()),
        (load, _) => load,
    };
    let solver = NormalProblem::builder(&scene.bodies, &scene.gap, load)
        .tolerance(finer(scene.settings.tolerance))
        .method(other(method))
        .time_limit(PATIENCE)
        .build()
        .and_then(NormalProblem::into_solver);
    let mut solver = solver.ok()?;
    let mut solution = solver.new_solution();
    // A reference that stalls at round-off is sufficient, because it reports its own error.
    let _ = solver.solve_into(&mut solution);
    Some(ReferenceSolution {
        error: solution.report().energy_error_bound(),
        x: solution.pressure().as_slice().to_vec(),
        against: "finer solve",
    })
}

/// Returns the reference tractions for the load, or for the force found if a periodic grid was shifted.
pub(crate) fn tractions(
    scene: &RandomScene,
    shear: &Shear,
    normal: &NormalSolution,
    load: TangentialLoad,
    found: &TangentialSolution,
    method: Method,
    dense_limit: usize,
) -> Option<ReferenceSolution> {
    let limits = limits(&shear.friction, normal);
    let cell_area = normal.grid().cell_area();
    let is_periodic = scene.bodies.boundary() == Boundary::Periodic;
    // Near sliding the tractions under the prescribed force differ from the tractions under the reached force. The
    // difference is the square root of the difference of the forces.
    let is_missed = prescribed_force(load).is_some_and(|[x, y]| {
        let limit = limits.iter().sum::<f64>() * cell_area;
        found.axis().is_none() && found.report().load_error > 1.0 - x.hypot(y) / limit
    });
    let is_found = is_periodic && prescribed_shift(load).is_some() || is_missed;
    let load = if is_found {
        TangentialLoad::force(found.force())
    } else {
        load
    };
    let slides = sliding(&limits, load, (cell_area, is_periodic), found);
    // If the limits hardly vary, this comparison has no accuracy.
    if let Some(truth) = slides.filter(|truth| truth.error < 1.0) {
        return Some(truth);
    }
    let blur = if is_found && found.axis().is_none() {
        blur(&limits, found.force(), cell_area)
    } else {
        0.0
    };
    let contact: Vec<usize> = (0..limits.len()).filter(|&i| limits[i] > 0.0).collect();
    let is_small = contact.len() <= dense_limit && limits.len() <= 8 * dense_limit.min(512);
    let along = found.axis().filter(|_| is_small);
    let exact = along
        .and_then(|axis| exact_traction(scene, &limits, &contact, load, axis.index(), cell_area));
    if let Some(x) = exact {
        return Some(ReferenceSolution::exact(x));
    }
    let solver = TangentialProblem::builder(&scene.bodies, normal, shear.friction.clone(), load)
        .model(shear.lateral)
        .coupling(Coupling::Neglected)
        .tolerance(finer(scene.settings.tolerance))
        .method(shear.method(other(method)))
        .time_limit(PATIENCE)
        .build()
        .and_then(TangentialProblem::into_solver);
    let mut solver = solver.ok()?;
    let mut solution = solver.new_solution();
    let _ = solver.solve_into(&mut solution);
    Some(ReferenceSolution {
        error: solution.report().energy_error_bound() + blur,
        x: gathered(&solution),
        against: "finer solve",
    })
}

/// Returns the force of a load that prescribes a force along both axes.
pub(crate) fn prescribed_force(load: TangentialLoad) -> Option<[f64; 2]> {
    match [load.control(Axis::X), load.control(Axis::Y)] {
        [TangentialControl::Force(x), TangentialControl::Force(y)] => Some([x, y]),
        _ => None,
    }
}

/// Returns the shift of a load that prescribes a shift along both axes.
fn prescribed_shift(load: TangentialLoad) -> Option<[f64; 2]> {
    match [load.control(Axis::X), load.control(Axis::Y)] {
        [TangentialControl::Shift(x), TangentialControl::Shift(y)] => Some([x, y]),
        _ => None,
    }
}

/// Returns the uncertainty of the tractions in the plane due to the rounding of the force. Near sliding they rotate by
/// the square root of the deficit from the limit.
fn blur(limits: &[f64], [x, y]: [f64; 2], cell_area: f64) -> f64 {
    let missing = 1.0 - x.hypot(y) / (limits.iter().sum::<f64>() * cell_area);
    2.0 * f64::EPSILON / missing.max(f64::EPSILON).sqrt()
}

/// Returns the tractions with all cells at their limits along the force, if the force equals the limit to round-off.
fn sliding(
    limits: &[f64],
    load: TangentialLoad,
    (cell_area, is_periodic): (f64, bool),
    found: &TangentialSolution,
) -> Option<ReferenceSolution> {
    let limit = limits.iter().sum::<f64>() * cell_area;
    let [x, y] = prescribed_force(load)?;
    let size = x.hypot(y);
    let missing = (1.0 - size / limit).max(0.0);
    let along = |n: f64| limits.iter().map(move |limit| n / size * limit);
    // In the vector model tractions rotate by the square root of the deficit.
    let (x, error): (Vec<f64>, f64) = if let Some(axis) = found.axis() {
        (along([x, y][axis.index()]).collect(), 1e-10)
    } else {
        let part = if is_periodic { varying(limits) } else { 1.0 };
        (along(x).chain(along(y)).collect(), 5e-6 / part)
    };
    (limit > 0.0 && missing <= SLIDING).then_some(ReferenceSolution {
        x,
        error,
        against: "all slips",
    })
}

/// Returns the root-mean-square fraction of a field that is not its mean. On a grid that is periodic along both axes only
/// this part has an energy.
fn varying(field: &[f64]) -> f64 {
    let mean = field.iter().sum::<f64>() / field.len() as f64;
    let square = |of: f64| field.iter().map(|value| (value - of).powi(2)).sum::<f64>();
    (square(mean) / square(0.0)).sqrt()
}

fn exact_traction(
    scene: &RandomScene,
    limits: &[f64],
    contact: &[usize],
    load: TangentialLoad,
    axis: usize,
    cell_area: f64,
) -> Option<Vec<f64>> {
    let (shift, total) = match (prescribed_force(load), prescribed_shift(load)) {
        (Some(force), _) => (0.0, Some(force[axis] / cell_area)),
        (None, Some(shift)) => (shift[axis], None),
        (None, None) => return None,
    };
    let component = [Component::XX, Component::YY][axis];
    let upper: Vec<f64> = contact.iter().map(|&i| limits[i]).collect();
    let lower: Vec<f64> = upper.iter().map(|limit| -limit).collect();
    let bounds = Bounds {
        lower: &lower,
        upper: &upper,
    };
    let minimum = matrix(&scene.bodies, component, contact)
        .and_then(|matrix| matrix.minimise(&vec![-shift; contact.len()], &bounds, total))
        .ok()?;
    let mut whole = vec![0.0; limits.len()];
    for (&i, x) in contact.iter().zip(minimum.x) {
        whole[i] = x;
    }
    Some(whole)
}

/// Returns the influence of some cells on each other. For a periodic grid a constant is added, which changes no
/// solution with a prescribed total.
pub(crate) fn matrix(
    bodies: &HalfSpace,
    component: Component,
    cells: &[usize],
) -> Result<DenseOperator> {
    let whole = DenseOperator::of_half_space(bodies, component)?;
    let at = |i: usize, j: usize| whole.get(i, j).unwrap_or(f64::NAN);
    let constant = match bodies.boundary() {
        Boundary::Periodic => at(0, 0),
        _ => 0.0,
    };
    let entries = cells
        .iter()
        .flat_map(|&i| cells.iter().map(move |&j| at(i, j) + constant));
    DenseOperator::from_rows(cells.len(), entries.collect())
}

/// Returns the friction limit of every cell.
pub(crate) fn limits(friction: &Friction, normal: &NormalSolution) -> Vec<f64> {
    let pressures = normal.pressure().as_slice().iter().enumerate();
    pressures
        .map(|(i, &pressure)| {
            if pressure > 0.0 {
                friction.limit(i, pressure)
            } else {
                0.0
            }
        })
        .collect()
}

/// Returns the tractions of the model, one component or two.
pub(crate) fn gathered(solution: &TangentialSolution) -> Vec<f64> {
    let traction = solution.traction();
    match solution.axis() {
        Some(axis) => traction[axis.index()].as_slice().to_vec(),
        None => [traction[0].as_slice(), traction[1].as_slice()].concat(),
    }
}

pub(crate) fn other(method: Method) -> Method {
    match method {
        Method::ActiveSet => Method::PolonskyKeer,
        _ => Method::ActiveSet,
    }
}
