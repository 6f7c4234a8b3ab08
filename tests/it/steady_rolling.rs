//! The force of steady rolling converges to Carter's closed form with second order. Steady rolling also agrees with the
//! numbers of CONTACT without the entry rule. Its errors are within the certificate.

use proptest::prelude::*;
use stickslip::analytical::{Carter, HertzLine};
use stickslip::history::EntryRule;
use stickslip::influence::Direction;
use stickslip::rolling::{
    LeadingEdge, RollingControl, RollingProblem, RollingSolution, SpinControl,
};
use stickslip::{
    Axis, Boundary, ElasticPair, Error, Field, Friction, Grid, HalfSpace, Material, NormalLoad,
    NormalProblem, NormalSolution, Operator, Zone,
};

fn pressed(bodies: &HalfSpace, gap: &Field, force: f64) -> NormalSolution {
    kit::solve(NormalProblem::builder(bodies, gap, NormalLoad::Force(force)).tolerance(1e-11))
}

fn similar_bodies(grid: Grid, shear_modulus: f64, poisson: f64) -> HalfSpace {
    HalfSpace::new(grid, kit::alike_in_shear(shear_modulus, poisson)).unwrap()
}

/// Returns the forces along x and y, the moment, and the number of sticking cells.
fn results(rolling: &RollingSolution) -> ([f64; 3], usize) {
    let [x, y] = rolling.force();
    let stick = rolling.zones().iter().filter(|z| **z == Zone::Stick);
    ([x, y, rolling.moment()], stick.count())
}

/// The reference is CONTACT (E. A. H. Vollebregt, revision 2707, Apache-2.0) on the same cells, for a sphere and an
/// ellipse of steel. CONTACT gives the forces on the other body.
#[test]
fn steady_rolling_without_entry_law_matches_contact() {
    let grid = Grid::new(41, 37, 0.0116, 0.0116).unwrap();
    let bodies = similar_bodies(grid, 80_000.0, 0.25);
    let gap = Field::from_fn(grid, |x, y| 0.05 * (x * x + y * y));
    let normal = pressed(&bodies, &gap, 100.0);
    let of = |creepage: [f64; 2], spin: f64| {
        kit::solve(
            RollingProblem::builder(&bodies, &normal, kit::coulomb(0.3))
                .creepage(creepage)
                .spin(spin)
                .entry_rule(EntryRule::WholeStep)
                .tolerance(1e-10),
        )
    };
    #[rustfmt::skip] // one row per line
    let cases = [
        ([0.00064, -0.0004, 0.0048], [6.818489413493, 0.1625701062456, 0.7462370484893], 724),
        ([0.0016, -0.001, 0.012], [13.68673121789, 0.837369325419, 1.331743198635], 529),
        ([0.004, -0.0025, 0.03], [20.58314449537, 1.388160232716, 1.796806729575], 205),
        ([0.0, 0.0012, 0.02], [0.0, 22.90472755433, 1.293394779133], 228),
    ];
    for ([xi, eta, spin], expected, stick) in cases {
        let rolling = of([xi, eta], spin);
        let (found, sticking) = results(&rolling);
        for (found, expected) in found.into_iter().zip(expected) {
            assert!((found - expected).abs() < 1e-9, "{found} for {expected}");
        }
        assert_eq!(sticking, stick);
    }
    // The reference is the dissipation of a step of 0.0116 with the tractions at its end.
    let lost = of([0.00064, -0.0004], 0.0048)
        .dissipation_per_area()
        .unwrap()
        .integral()
        * 0.0116;
    assert!((lost / 7.420710888059e-5 - 1.0).abs() < 1e-9);

    let grid = Grid::new(48, 44, 0.28891487356106, 0.63035972476398).unwrap();
    let bodies = similar_bodies(grid, 82_000.0, 0.28);
    let gap = Field::from_fn(grid, |x, y| 0.0008 * x * x + 0.00028141731461784 * y * y);
    let normal = pressed(&bodies, &gap, 106_700.0);
    let rolling = kit::solve(
        RollingProblem::builder(&bodies, &normal, kit::coulomb(0.33))
            .creepage([0.0012, 0.0])
            .entry_rule(EntryRule::WholeStep)
            .tolerance(1e-9),
    );
    let (found, stick) = results(&rolling);
    assert!((found[0] / 22_823.62310136 - 1.0).abs() < 1e-9 && stick == 782);
}

/// Returns the error of the force relative to the friction limit and the error of the traction (L1). They are means
/// over three positions, for the given number of cells across the contact.
fn errors_of_carter(cells: usize, ratio: f64, entry_rule: EntryRule) -> [f64; 2] {
    let pair = kit::alike(1.0, 0.0);
    let mut errors = [0.0; 2];
    for offset in [0.1, 0.37, 0.77] {
        let modulus = pair.contact_modulus();
        // The half-width is one.
        let hertz = HertzLine::new(&pair, 1.0, std::f64::consts::PI * modulus / 4.0).unwrap();
        let dx = 2.0 / cells as f64;
        let grid = Grid::line(cells + 8, dx).unwrap();
        let boundary = Boundary::PeriodicAlongY { datum: 4.0 };
        let bodies = HalfSpace::with_boundary(grid, pair, boundary).unwrap();
        let gap = Field::from_fn(grid, |x, _| 0.5 * (x + offset * dx).powi(2));
        let normal = pressed(&bodies, &gap, hertz.load());
        let slides_at = Carter::new(hertz, 0.3, 0.0).unwrap().sliding_creepage();
        let creepage = (1.0 - ratio) * slides_at;
        let carter = Carter::new(hertz, 0.3, creepage).unwrap();
        let rolling = kit::solve(
            RollingProblem::builder(&bodies, &normal, kit::coulomb(0.3))
                .creepage([creepage, 0.0])
                .entry_rule(entry_rule),
        );
        let force = rolling.force()[0];
        errors[0] += (force - carter.force()).abs() / (0.3 * hertz.load()) / 3.0;
        let (mut missed, mut sum) = (0.0, 0.0);
        for (i, q) in rolling.traction()[0].as_slice().iter().enumerate() {
            let exact = carter.traction(grid.x(i) + offset * dx);
            missed += (q - exact).abs();
            sum += exact;
        }
        errors[1] += missed / sum / 3.0;
    }
    errors
}

#[test]
fn carter_force_converges_with_second_order() {
    for ratio in [0.6, 0.2] {
        let law = [32, 128, 512].map(|cells| errors_of_carter(cells, ratio, EntryRule::SinceTouch));
        let order = |part: usize| (law[0][part] / law[2][part]).ln() / 16.0_f64.ln();
        assert!(
            order(0) > 1.8 && order(1) > 1.3,
            "{} {}",
            order(0),
            order(1)
        );
        assert!(law[1][0] < 2e-5, "{:e}", law[1][0]);
        let whole = errors_of_carter(128, ratio, EntryRule::WholeStep);
        assert!(whole[0] > 60.0 * law[1][0] && whole[1] > 5.0 * law[1][1]);
    }
}

/// Kalker's coefficients of a circular contact (table E.3 of Kalker 1990) are reached at creepages with slip at the
/// edge only. They are reciprocal to about one per cent on 42 cells across the contact.
#[test]
fn small_creepages_match_kalker_coefficients() {
    for (poisson, longitudinal, lateral, spin) in [
        (0.0, 3.40, 3.40, 1.33),
        (0.25, 4.12, 3.67, 1.47),
        (0.5, 5.20, 3.98, 1.63),
    ] {
        let grid = kit::square(48, 2.25);
        let bodies = similar_bodies(grid, 1.0, poisson);
        let modulus = bodies.pair().contact_modulus();
        let ball = kit::sphere(grid, 1.0);
        let normal = pressed(&bodies, &ball, 4.0 / 3.0 * modulus);
        // The friction is so large that hardly any cell slips.
        let of = |creepage: [f64; 2], spin: f64| {
            let problem = RollingProblem::builder(&bodies, &normal, kit::coulomb(1e4));
            let rolling = kit::solve(problem.creepage(creepage).spin(spin));
            (rolling.force(), rolling.moment())
        };
        let ([x, _], _) = of([1e-3, 0.0], 0.0);
        let ([_, y], turned) = of([0.0, 1e-3], 0.0);
        let ([_, pushed], _) = of([0.0, 0.0], 1e-3);
        for (found, expected) in [(x, longitudinal), (y, lateral), (pushed, spin)] {
            let coefficient = found / 1e-3;
            assert!(
                (coefficient / expected - 1.0).abs() < 6e-3,
                "{coefficient} for {expected}"
            );
        }
        assert!(
            (pushed + turned).abs() < 1.5e-2 * pushed,
            "{pushed} {turned}"
        );
    }
}

/// Returns $`x' ((1 - T)\,C + B)\,x`$ for the tractions of the first solution, and for their difference from the second
/// solution.
fn energies(
    bodies: &HalfSpace,
    [answer, other]: [&RollingSolution; 2],
    own: impl Fn(usize) -> f64,
) -> (f64, f64) {
    let grid = bodies.grid();
    let operator = bodies
        .tensor_operator([Direction::X, Direction::Y])
        .unwrap();
    let product = |q: &[Vec<f64>; 2]| {
        let mut moved = [(); 2].map(|()| vec![0.0; grid.cells()]);
        operator.apply(
            q.each_ref().map(|part| &part[..]),
            moved.each_mut().map(|part| &mut part[..]),
            &mut operator.scratch().unwrap(),
        );
        let before = |u: &[f64], i: usize| {
            if (i + 1) % grid.nx() == 0 {
                0.0
            } else {
                u[i + 1]
            }
        };
        let parts = q.iter().zip(&moved).flat_map(|(q, u)| {
            let cells = q.iter().enumerate();
            cells.map(|(i, q)| q * (u[i] - before(u, i) + own(i) * q))
        });
        parts.sum::<f64>()
    };
    let of = |answer: &RollingSolution| answer.traction().map(|part| part.as_slice().to_vec());
    let (mut error, other) = (of(answer), of(other));
    for (error, other) in error.iter_mut().flatten().zip(other.iter().flatten()) {
        *error -= other;
    }
    (product(&of(answer)), product(&error))
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(kit::thorough(12, 48)))]
    /// Covers rough gaps, friction per cell, creepages or forces, spin and dissimilar bodies. The certificate is above
    /// the error relative to a solve with a smaller tolerance. Without lateral contraction the compliance of an entering
    /// cell is the gap ahead divided by its pressure, in all directions.
    #[test]
    fn certificate_bounds_error(
        poisson in 0.0..0.5_f64, other in 0.0..0.45_f64, is_dissimilar: bool, roughness in 0.0..0.02_f64,
        creepage in prop::array::uniform2(-0.3..0.3_f64), spin in -0.3..0.3_f64, enters: bool, digits in 1..6_i32,
        fraction in prop::option::of(-0.99..0.99_f64), friction in prop::array::uniform2(0.05..0.6_f64),
    ) {
        let (entry_rule, [poisson, other]) = if enters {
            (EntryRule::SinceTouch, [0.0; 2])
        } else {
            (EntryRule::WholeStep, [poisson, other])
        };
        let grid = Grid::new(22, 18, 0.14, 0.16).unwrap();
        let one = Material::from_shear_modulus(1.0, poisson).unwrap();
        let two = if is_dissimilar { Material::from_shear_modulus(3.0, other).unwrap() } else { one };
        let bodies = HalfSpace::new(grid, ElasticPair::new(one, two).unwrap()).unwrap();
        let gap = Field::from_fn(grid, |x, y| {
            0.5 * (x * x + y * y) + roughness * (9.0 * x).cos() * (7.0 * y + 1.0).cos()
        });
        let normal = pressed(&bodies, &gap, 1.0);
        let coefficients = Field::from_fn(grid, |x, _| if x > 0.1 { friction[0] } else { friction[1] });
        let by_cell = Friction::per_cell(coefficients).unwrap();
        let (pressure, apart) = (normal.pressure().as_slice(), normal.gap().as_slice());
        let solve = |tolerance: f64| {
            let builder = RollingProblem::builder(&bodies, &normal, by_cell.clone())
                .creepage(creepage)
                .spin(spin)
                .entry_rule(entry_rule)
                .tolerance(tolerance);
            let held: f64 = (0..grid.cells()).map(|i| by_cell.limit(i, pressure[i])).sum();
            kit::solve(match fraction {
                Some(fraction) => builder.control(Axis::X, RollingControl::Force(fraction * held * grid.cell_area())),
                None => builder,
            })
        };
        let own = |i: usize| {
            let is_first = enters && pressure[i] > 0.0 && pressure[i + 1] == 0.0;
            if is_first { apart[i + 1].max(0.0) / pressure[i] } else { 0.0 }
        };
        let (rough, tight) = (solve(0.1_f64.powi(digits)), solve(1e-11));
        let (energy, error) = energies(&bodies, [&rough, &tight], own);
        let bound = (rough.report().duality_gap * energy).sqrt();
        // The solution with the smaller tolerance has an error as well.
        prop_assert!(error.max(0.0).sqrt() <= bound + 1e-10 * energy.sqrt());
        prop_assert!(rough.work() >= -1e-9 || is_dissimilar);
    }
}

/// The position of the edge of the grid does not change the result if the edge is three cells or more from the contact.
#[test]
fn result_is_independent_of_margin() {
    let [narrow, wide] = [22, 30].map(|cells| {
        let bodies = similar_bodies(Grid::new(cells, cells, 0.1, 0.1).unwrap(), 1.0, 0.3);
        let ball = kit::sphere(bodies.grid(), 1.0);
        let normal = pressed(&bodies, &ball, 1.0);
        let problem = RollingProblem::builder(&bodies, &normal, kit::coulomb(0.3));
        results(&kit::solve(
            problem.creepage([0.1, 0.05]).spin(0.08).tolerance(1e-11),
        ))
        .0
    });
    assert!(
        kit::max_difference(&narrow, &wide) < 1e-8,
        "{narrow:?} {wide:?}"
    );
}

#[test]
fn invalid_rolling_is_rejected() {
    let grid = kit::square(20, 2.4);
    let bodies = similar_bodies(grid, 1.0, 0.25);
    let ball = kit::sphere(grid, 1.0);
    let normal = pressed(&bodies, &ball, 1.0);
    let builder = || RollingProblem::builder(&bodies, &normal, kit::coulomb(0.3));
    kit::assert_refused! {
        builder().creepage([f64::NAN, 0.0]).build() => Error::NotFinite { .. },
        builder().spin(f64::INFINITY).build() => Error::NotFinite { .. },
        builder().step(0).build() => Error::NotPositive { .. },
        builder().step(9).build() => Error::GridTooShort { .. },
        builder().step(usize::MAX).build() => Error::GridTooShort { .. },
        builder().leading_edge(LeadingEdge::MinusY).step(9).build() => Error::GridTooShort { .. },
        builder().creepage([f64::MAX, 0.0]).step(1).spin(f64::MAX).build() => Error::NotFinite { .. },
        // A force that slides the contact does not determine the creepage.
        builder().control(Axis::X, RollingControl::Force(0.3)).build() => Error::BeyondFrictionCapacity { .. },
        builder().control(Axis::X, RollingControl::Force(0.31)).build() => Error::BeyondFrictionCapacity { .. },
        builder().control(Axis::X, RollingControl::Force(f64::NAN)).build() => Error::NotFinite { .. },
    }
    let mut solver = kit::solver(builder());
    let elsewhere = HalfSpace::new(kit::square(8, 2.4), *bodies.pair()).unwrap();
    let small = kit::sphere(elsewhere.grid(), 1.0);
    let other = pressed(&elsewhere, &small, 1.0);
    let refused = RollingProblem::builder(&bodies, &other, kit::coulomb(0.3)).build();
    assert!(matches!(refused, Err(Error::GridMismatch { .. })));
    let force = RollingControl::Force(1.0);
    kit::assert_refused! { solver.set_load([force; 2], SpinControl::Spin(0.0)) => Error::BeyondFrictionCapacity { .. } }
    let rolling = kit::solved(&mut solver);
    assert_eq!(rolling.force(), [0.0; 2]);

    let boundary = Boundary::Periodic;
    let waves = HalfSpace::with_boundary(grid, *bodies.pair(), boundary).unwrap();
    let gap = Field::from_fn(grid, |x, y| 0.01 * (x.cos() + y.cos()));
    let flat = pressed(&waves, &gap, 0.01);
    let refused = RollingProblem::builder(&waves, &flat, kit::coulomb(0.3)).build();
    assert!(matches!(refused, Err(Error::UnsupportedByModel { .. })));
}

/// The dissipation is less than the work for any creepages, spin and step, with and without the entry rule.
#[test]
fn dissipation_never_exceeds_work() {
    let mut random = kit::Random(3);
    for _ in 0..kit::thorough(60, 2000) {
        let size = [random.integer(8, 16), random.integer(8, 16)];
        let grid = Grid::new(size[0], size[1], 0.2, random.pick(&[0.2, 0.15])).unwrap();
        let bodies = similar_bodies(grid, 1.0, random.uniform(0.0, 0.5));
        let [x0, y0] = [0, 1].map(|_| random.uniform(-0.2, 0.2));
        let gap = Field::from_fn(grid, |x, y| {
            let rough = 0.01 * (9.0 * x).cos() * (7.0 * y).cos();
            0.5 * ((x - x0).powi(2) + (y - y0).powi(2)) + rough
        });
        let normal = pressed(&bodies, &gap, random.uniform(0.1, 0.4));
        let edge = random.pick(&[
            LeadingEdge::PlusX,
            LeadingEdge::MinusX,
            LeadingEdge::PlusY,
            LeadingEdge::MinusY,
        ]);
        let entry_rule = random.pick(&[EntryRule::SinceTouch, EntryRule::WholeStep]);
        let creepage = [0, 1].map(|_| random.uniform(-0.3, 0.3));
        let problem = RollingProblem::builder(&bodies, &normal, kit::coulomb(0.3))
            .leading_edge(edge)
            .step(random.integer(1, 3))
            .creepage(creepage)
            .spin(random.uniform(-3.0, 3.0))
            .entry_rule(entry_rule);
        // The problem is rejected if the grid ends within a step of the contact.
        let Ok(problem) = problem.build() else {
            continue;
        };
        let rolling = problem.solve().unwrap();
        let (work, lost) = (
            rolling.work(),
            rolling.dissipation_per_area().unwrap().integral(),
        );
        assert!(0.0 < lost && lost < work, "{lost} of {work}");
    }
}

/// For a spinning sphere on 12 cells across the grid, the difference is a sixteenth of the work. It halves if the
/// number of cells doubles.
#[test]
fn work_and_dissipation_agree_as_cells_shrink() {
    let deficits = [12, 24, 48].map(|cells| {
        let grid = kit::square(cells, 2.4);
        let bodies = similar_bodies(grid, 1.0, 0.25);
        let ball = kit::sphere(grid, 1.0);
        let normal = pressed(&bodies, &ball, 1.0);
        let problem = RollingProblem::builder(&bodies, &normal, kit::coulomb(0.3));
        let rolling = kit::solve(problem.spin(2.0));
        let lost = rolling.dissipation_per_area().unwrap().integral();
        1.0 - lost / rolling.work()
    });
    for (deficit, finer) in deficits.iter().zip(&deficits[1..]) {
        let ratio = deficit / finer;
        assert!(*finer > 0.0 && (1.7..2.3).contains(&ratio), "{deficits:?}");
    }
    assert!(deficits[0] < 0.065, "{deficits:?}");
}
