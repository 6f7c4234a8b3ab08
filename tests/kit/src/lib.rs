//! Scenes, reference solutions and measures shared by tests, benches and unpackaged examples.

#![allow(
    missing_docs,
    clippy::missing_errors_doc,
    clippy::missing_panics_doc,
    clippy::must_use_candidate,
    clippy::return_self_not_must_use,
    reason = "it is no public interface"
)]
#![allow(
    clippy::unwrap_used,
    clippy::cast_possible_truncation,
    clippy::cast_possible_wrap,
    reason = "a test fails loudly, and counts small things"
)]

pub mod benchmark;
pub mod contact;
pub mod measure;
mod random;
pub mod refusal;
#[cfg(feature = "dense")]
pub mod scenes;
pub mod smooth;
pub mod table;
pub mod waves;

pub use random::Random;
use stickslip::cgm::Method;
use stickslip::coupled::{CoupledProblemBuilder, CoupledSolution, CoupledSolver};
use stickslip::influence::Component;
use stickslip::normal::{NormalProblemBuilder, NormalSolver};
use stickslip::rolling::{
    CoupledRollingProblemBuilder, CoupledRollingSolution, CoupledRollingSolver,
    RollingProblemBuilder, RollingSolution, RollingSolver,
};
use stickslip::tangential::{TangentialProblemBuilder, TangentialSolver};
use stickslip::{
    Boundary, Contact, ElasticPair, Field, Friction, Grid, HalfSpace, Material, NormalLoad,
    NormalProblem, NormalSolution, Operator, Result, Solver, TangentialControl, TangentialLoad,
    TangentialProblem, TangentialSolution, Warning, surface,
};
#[cfg(feature = "serde")]
pub use {postcard, serde_json};

/// Returns the first argument in an everyday run of the tests, and the second argument in the campaign before a
/// release. The campaign sets the environment variable `STICKSLIP_CAMPAIGN`.
///
/// Both arguments must test the same law to the same tolerance. The first argument is a small instance, because it runs
/// for every change.
pub fn thorough<T>(everyday: T, campaign: T) -> T {
    if std::env::var_os("STICKSLIP_CAMPAIGN").is_some() {
        campaign
    } else {
        everyday
    }
}

/// Returns a rough gap with a root-mean-square height of one and a minimum of zero. The gap contains waves of all
/// directions down to eight cells, with amplitudes that decrease as for a Hurst exponent of 0.8.
pub fn rough(grid: Grid, seed: u64) -> Field {
    let mut random = Random(seed);
    let side = grid.dx() * grid.nx() as f64;
    let shortest = grid.nx() / 8;
    let mut heights = Field::zeros(grid);
    for kx in 0..=shortest {
        for ky in -(shortest as i64)..=shortest as i64 {
            let k = (kx as f64).hypot(ky as f64);
            let is_half_plane = kx > 0 || ky > 0;
            if !is_half_plane || k > shortest as f64 {
                continue;
            }
            let amplitude = k.max(2.0).powf(-1.8);
            let phase = random.uniform(0.0, std::f64::consts::TAU);
            add_wave(
                &mut heights,
                [kx as f64, ky as f64].map(|k| k * std::f64::consts::TAU / side),
                amplitude,
                phase,
            );
        }
    }
    let n = grid.cells() as f64;
    let square: f64 = heights.as_slice().iter().map(|h| h * h).sum();
    let rms = (square / n).sqrt();
    let least = heights.min();
    for height in heights.as_mut_slice() {
        *height = (*height - least) / rms;
    }
    heights
}

/// Adds `amplitude cos(k . r + phase)`, with one cosine and sine per row and column.
fn add_wave(heights: &mut Field, [kx, ky]: [f64; 2], amplitude: f64, phase: f64) {
    let grid = heights.grid();
    let columns: Vec<(f64, f64)> = (0..grid.nx())
        .map(|ix| (kx * grid.x(ix)).sin_cos())
        .collect();
    for (iy, row) in heights
        .as_mut_slice()
        .chunks_exact_mut(grid.nx())
        .enumerate()
    {
        let (sin_y, cos_y) = (ky * grid.y(iy) + phase).sin_cos();
        for (height, (sin_x, cos_x)) in row.iter_mut().zip(&columns) {
            *height += amplitude * (cos_x * cos_y - sin_x * sin_y);
        }
    }
}

/// Returns two equal bodies of unit contact modulus, for which pressure and traction are uncoupled.
pub fn unit_pair(poisson_ratio: f64) -> ElasticPair {
    alike(2.0 * (1.0 - poisson_ratio * poisson_ratio), poisson_ratio)
}

/// Returns two equal bodies with this Young's modulus and Poisson's ratio.
pub fn alike(modulus: f64, poisson_ratio: f64) -> ElasticPair {
    let body = Material::new(modulus, poisson_ratio).unwrap();
    ElasticPair::new(body, body).unwrap()
}

/// Returns two equal bodies with this shear modulus and Poisson's ratio.
pub fn alike_in_shear(shear_modulus: f64, poisson_ratio: f64) -> ElasticPair {
    let body = Material::from_shear_modulus(shear_modulus, poisson_ratio).unwrap();
    ElasticPair::new(body, body).unwrap()
}

/// Returns a body with this Young's modulus and Poisson's ratio on a rigid body.
pub fn on_rigid(modulus: f64, poisson_ratio: f64) -> ElasticPair {
    let body = Material::new(modulus, poisson_ratio).unwrap();
    ElasticPair::new(body, Material::rigid()).unwrap()
}

/// Returns a square grid with this number of cells along a side of this length.
pub fn square(cells: usize, side: f64) -> Grid {
    Grid::square(cells, side).unwrap()
}

/// Returns the gap of a sphere.
pub fn sphere(grid: Grid, radius: f64) -> Field {
    surface::sphere(grid, radius).unwrap()
}

/// Returns Coulomb friction.
pub fn coulomb(coefficient: f64) -> Friction {
    Friction::coulomb(coefficient).unwrap()
}

/// Returns a spring with its far end at this position.
pub fn spring(position: f64, stiffness: f64) -> TangentialControl {
    TangentialControl::Spring {
        position,
        stiffness,
    }
}

/// Returns all boundaries that a grid may have. For periodic rows the datum is at twice the length of the grid.
pub fn boundaries(grid: Grid) -> [Boundary; 3] {
    let datum = 2.0 * grid.dx() * grid.nx() as f64;
    [
        Boundary::NonPeriodic,
        Boundary::Periodic,
        Boundary::PeriodicAlongY { datum },
    ]
}

pub fn unit_bodies(grid: Grid, poisson_ratio: f64) -> HalfSpace {
    HalfSpace::new(grid, unit_pair(poisson_ratio)).unwrap()
}

/// Case of Table 2 of the paper: a steel sphere on steel, in metres, newtons and pascals.
#[derive(Debug)]
pub struct Table2;

impl Table2 {
    pub const RADIUS: f64 = 3.5e-3;
    pub const FORCE: f64 = 100.0;
    pub const FRICTION: f64 = 0.5;
    pub const CONTACT_RADIUS: f64 = 1.311825049793251e-4;
    pub const MAX_PRESSURE: f64 = 2.774530779353722e9;
    pub const APPROACH: f64 = 4.916814175043042e-6;

    pub fn pair() -> ElasticPair {
        let steel = Material::new(213e9, 0.29).unwrap();
        ElasticPair::new(steel, steel).unwrap()
    }
}

/// Builder of a problem that a test expects to be valid.
pub trait SolvableBuilder {
    type Solver;
    type Solution;

    fn build_solver(self) -> Result<Self::Solver>;
    fn build_and_solve(self) -> Result<Self::Solution>;
}

macro_rules! solvable {
    ($($builder:ty => $solver:ty, $solution:ty;)+) => {$(
        impl SolvableBuilder for $builder {
            type Solver = $solver;
            type Solution = $solution;

            fn build_solver(self) -> Result<$solver> {
                self.build()?.into_solver()
            }

            fn build_and_solve(self) -> Result<$solution> {
                self.build()?.solve()
            }
        }
    )+};
}

solvable! {
    NormalProblemBuilder => NormalSolver, NormalSolution;
    TangentialProblemBuilder<'_, '_> => TangentialSolver, TangentialSolution;
    CoupledProblemBuilder => CoupledSolver, CoupledSolution;
    RollingProblemBuilder<'_> => RollingSolver, RollingSolution;
    CoupledRollingProblemBuilder => CoupledRollingSolver, CoupledRollingSolution;
}

/// Returns the solution of a problem, which must be valid.
#[track_caller]
pub fn solve<B: SolvableBuilder>(builder: B) -> B::Solution {
    builder.build_and_solve().unwrap()
}

/// Returns the solver of a problem, which must be valid.
#[track_caller]
pub fn solver<B: SolvableBuilder>(builder: B) -> B::Solver {
    builder.build_solver().unwrap()
}

/// Returns the first warning of a kind.
pub fn first_of(warnings: Vec<Warning>, is_of_kind: impl Fn(&Warning) -> bool) -> Option<Warning> {
    warnings.into_iter().find(is_of_kind)
}

/// Returns the next solution of a solver.
#[track_caller]
pub fn solved<P: Contact>(solver: &mut Solver<P>) -> P::Solution {
    let mut solution = solver.new_solution();
    solver.solve_into(&mut solution).unwrap();
    solution
}

pub fn press(bodies: &HalfSpace, gap: &Field, load: NormalLoad, tolerance: f64) -> NormalSolution {
    solve(NormalProblem::builder(bodies, gap, load).tolerance(tolerance))
}

pub fn press_by(
    bodies: &HalfSpace,
    gap: &Field,
    load: NormalLoad,
    tolerance: f64,
    method: Method,
) -> NormalSolution {
    let builder = NormalProblem::builder(bodies, gap, load).tolerance(tolerance);
    solve(builder.method(method))
}

pub fn shear(
    bodies: &HalfSpace,
    normal: &NormalSolution,
    friction: &Friction,
    load: TangentialLoad,
    tolerance: f64,
) -> TangentialSolution {
    shear_by(bodies, normal, friction, load, tolerance, Method::default())
}

pub fn shear_by(
    bodies: &HalfSpace,
    normal: &NormalSolution,
    friction: &Friction,
    load: TangentialLoad,
    tolerance: f64,
    method: Method,
) -> TangentialSolution {
    let builder = TangentialProblem::builder(bodies, normal, friction.clone(), load);
    solve(builder.tolerance(tolerance).method(method))
}

pub fn max_abs(values: &[f64]) -> f64 {
    values.iter().fold(0.0, |a, b| a.max(b.abs()))
}

/// Returns `max |a - b|`.
pub fn max_difference(a: &[f64], b: &[f64]) -> f64 {
    assert_eq!(a.len(), b.len());
    a.iter().zip(b).fold(0.0, |m, (a, b)| m.max((a - b).abs()))
}

/// Returns `|a - b|_2 / |b|_2`.
pub fn l2_difference(a: &[f64], b: &[f64]) -> f64 {
    assert_eq!(a.len(), b.len());
    let square: f64 = a.iter().zip(b).map(|(a, b)| (a - b).powi(2)).sum();
    let norm: f64 = b.iter().map(|b| b * b).sum();
    (square / norm).sqrt()
}

/// Returns `|a - b|_C / |b|_C` with the operator C of a component.
pub fn energy_difference(bodies: &HalfSpace, component: Component, a: &Field, b: &Field) -> f64 {
    let operator = bodies.operator(component).unwrap();
    let mut workspace = operator.scratch().unwrap();
    let mut norm = |v: &[f64]| {
        let mut product = vec![0.0; v.len()];
        operator.apply([v], [&mut product], &mut workspace);
        v.iter()
            .zip(&product)
            .map(|(v, u)| v * u)
            .sum::<f64>()
            // Round-off may make the energy of a tiny difference negative.
            .max(0.0)
            .sqrt()
    };
    let difference: Vec<f64> = a
        .as_slice()
        .iter()
        .zip(b.as_slice())
        .map(|(a, b)| a - b)
        .collect();
    norm(&difference) / norm(b.as_slice())
}
