//! The values of a report equal the formulas documented on its fields. The formulas are not only bounds.

use std::ops::ControlFlow;

use approx::assert_relative_eq;
use kit::{Random, max_abs};
use stickslip::Report;
use stickslip::cgm::{self, Bounds, Method, NonNegative, Problem, Settings};
use stickslip::{Error, Operator, Scratch};

/// Ring of springs, each coupled to its neighbours. The entries are 2 on the diagonal and `coupling` next to the
/// diagonal. A coupling of -1 maps constants to zero.
struct Chain {
    len: usize,
    coupling: f64,
    lower_bound: f64,
}

impl Operator for Chain {
    fn cells(&self) -> usize {
        self.len
    }

    fn apply(&self, [x]: [&[f64]; 1], [out]: [&mut [f64]; 1], _: &mut Scratch) {
        for (i, out) in out.iter_mut().enumerate() {
            let beside = x[(i + self.len - 1) % self.len] + x[(i + 1) % self.len];
            *out = 2.0 * x[i] + self.coupling * beside;
        }
    }

    fn lower_bound(&self) -> f64 {
        self.lower_bound
    }
}

/// Examines an iterate and cancels before it changes.
fn examined(chain: &Chain, linear: &[f64], interval: &Bounds<'_>, x: &mut [f64]) -> Report {
    let problem = Problem::new(chain, [linear], interval.clone());
    let mut workspace = problem.workspace().unwrap();
    let (start, mut calls) = (x.to_vec(), 0);
    let cancel = &mut |_: &_| {
        calls += 1;
        if calls < 2 {
            ControlFlow::Continue(())
        } else {
            ControlFlow::Break(())
        }
    };
    let outcome = cgm::minimise_with(
        &problem,
        &Settings::default(),
        [&mut *x],
        &mut workspace,
        cancel,
    );
    assert!(matches!(outcome, Ok(()) | Err(Error::NotConverged(_))));
    assert_eq!(x, start);
    workspace.report().clone()
}

/// Entries are at either bound, between the bounds or fixed, with gradients of either sign. Some lengths are shorter
/// than a SIMD vector.
#[test]
fn report_of_unchanged_iterate_matches_formulas() {
    let mut random = Random(7);
    for len in [1, 2, 7, 29, 5003] {
        for (coupling, lower_bound) in [(-0.5, 0.0), (-0.5, 0.3), (-0.5, 1.0), (-1.0, 0.3)] {
            let chain = Chain {
                len,
                coupling,
                lower_bound,
            };
            let mut x: Vec<f64> = (0..len).map(|_| random.uniform(-1.0, 3.0)).collect();
            if coupling <= -1.0 {
                // All entries are equal, so the displacement is zero, and its scale follows from the eigenvalue bound.
                x.fill(0.75);
            }
            let linear: Vec<f64> = (0..len).map(|_| random.uniform(-4.0, 4.0)).collect();
            let bounds: Vec<[f64; 2]> = x
                .iter()
                .map(|&x| match random.integer(0, 3) {
                    0 => [x, x + random.uniform(0.5, 2.0)],
                    1 => [x - random.uniform(0.5, 2.0), x],
                    2 => [x, x],
                    _ => [x - random.uniform(0.1, 2.0), x + random.uniform(0.1, 2.0)],
                })
                .collect();
            let [lower, upper] = [0, 1]
                .map(|side| -> Vec<f64> { bounds.iter().map(|bounds| bounds[side]).collect() });
            let interval = Bounds {
                lower: &lower,
                upper: &upper,
            };
            let report = examined(&chain, &linear, &interval, &mut x);

            let mut product = vec![0.0; len];
            chain.apply([&x], [&mut product], &mut Scratch::none());
            let (mut moving, mut forbidden) = (vec![0.0], vec![0.0]);
            let (mut dual, mut square, mut largest) = (0.0, 0.0, 0.0_f64);
            for i in (0..len).filter(|&i| lower[i] < upper[i]) {
                let g = product[i] + linear[i];
                let is_allowed = (x[i] <= lower[i] && g > 0.0) || (x[i] >= upper[i] && g < 0.0);
                let r = if is_allowed { 0.0 } else { g };
                // The difference is the largest decrease of g x within the bounds.
                let least = (g * lower[i]).min(g * upper[i]);
                let [by_gap, by_eigenvalue] = [g * x[i] - least, r * r / lower_bound];
                if r != 0.0 && by_gap <= by_eigenvalue {
                    dual += by_gap;
                } else if r != 0.0 {
                    square += by_eigenvalue;
                }
                largest = largest.max(x[i].abs());
                moving.push(product[i]);
                forbidden.push(r);
            }
            let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
            let bound = 0.5 * f64::sqrt(square) + f64::sqrt(0.25 * square + dual);
            let displacement = max_abs(&moving).max(lower_bound * largest);
            let energy = dot(&x, &product).max(lower_bound * dot(&x, &x));
            let (residual, gap) = if max_abs(&forbidden) > 0.0 {
                (max_abs(&forbidden) / displacement, bound * bound / energy)
            } else {
                (0.0, 0.0)
            };
            assert_relative_eq!(report.residual, residual, max_relative = 1e-13);
            let is_between = |i: &usize| lower[*i] < x[*i] && x[*i] < upper[*i];
            assert_eq!(report.history[0].free, (0..len).filter(is_between).count());
            assert_relative_eq!(report.duality_gap, gap, max_relative = 1e-12);
        }
    }
}

/// If all entries use the eigenvalue bound, `E = |r| / sqrt(lambda)`. If all entries use the gap, `E^2` is the sum of
/// the gaps.
#[test]
fn report_of_single_entry_matches_formulas() {
    let interval = Bounds {
        lower: &[1.0],
        upper: &[11.0],
    };
    for (x, b, lower_bound, square) in [
        // g = 1, far from either bound: g^2 / lambda = 1/2 is less than g (x - 1) = 4.
        (5.0, -9.0, 2.0, 0.5),
        // g = 1, an eighth from the bound: g (x - 1) = 1/8 is less than 1/2.
        (1.125, -1.25, 2.0, 0.125),
        // This is the first case without an eigenvalue bound.
        (5.0, -9.0, 0.0, 4.0),
        // g = -1, a quarter from the other bound: g (x - 11) = 1/4.
        (10.75, -22.5, 2.0, 0.25),
    ] {
        let chain = Chain {
            len: 1,
            coupling: 0.0,
            lower_bound,
        };
        let report = examined(&chain, &[b], &interval, &mut [x]);
        let energy = 2.0 * x * x;
        assert_relative_eq!(report.duality_gap, square / energy, max_relative = 1e-14);
        assert_relative_eq!(report.residual, 0.5 / x, max_relative = 1e-14);
    }
}

/// For an operator without an eigenvalue bound only the residual ends the solve. The gap is infinite if an entry
/// without an upper bound would increase.
#[test]
fn residual_ends_solve_without_eigenvalue_bound() {
    let chain = Chain {
        len: 40,
        coupling: -0.5,
        lower_bound: 0.0,
    };
    let mut random = Random(11);
    let linear: Vec<f64> = (0..40).map(|_| random.uniform(-4.0, 4.0)).collect();
    for method in [Method::ActiveSet, Method::PolonskyKeer] {
        let settings = Settings::default().tolerance(1e-6).method(method);
        let mut x = vec![1.0; 40];
        let problem = Problem::new(&chain, [&linear], NonNegative);
        let report = cgm::minimise(&problem, &settings, [&mut x]).unwrap().report;
        assert!(report.residual > 0.0 && report.residual <= 1e-6, "{report}");
        assert!(report.duality_gap.is_infinite(), "{report}");
    }
}

/// A negative energy of an operator that is not positive definite gives no bound.
#[test]
fn duality_gap_is_not_negative() {
    let chain = Chain {
        len: 3,
        coupling: -2.0,
        lower_bound: 0.0,
    };
    let interval = Bounds {
        lower: &[1.0; 3],
        upper: &[3.0; 3],
    };
    let report = examined(&chain, &[0.0; 3], &interval, &mut [2.0; 3]);
    assert_eq!(report.duality_gap, f64::INFINITY);
    assert!(report.energy_error_bound().is_infinite());
}

/// If the operator maps constants to zero, a spring stiffer than the operator stores only the energy of the mean.
#[cfg(feature = "dense")]
#[test]
fn certificate_with_stiff_spring_bounds_error() {
    use stickslip::Status;
    use stickslip::cgm::Total;
    use stickslip::dense::DenseOperator;

    let mut random = Random(9);
    for (coupling, lower_bound) in [(-1.0, 0.26), (-0.5, 1.0)] {
        for _ in 0..kit::thorough(40, 4000) {
            let len = 12;
            let chain = Chain {
                len,
                coupling,
                lower_bound,
            };
            let (far_end, compliance) = (random.uniform(-2.0, 2.0), random.decade(-7.0, 1.0));
            let linear: Vec<f64> = (0..len).map(|_| random.uniform(-1.0, 1.0)).collect();
            let stiffened = (0..len * len).map(|n| {
                let distance = (n / len).abs_diff(n % len);
                let own = match distance {
                    0 => 2.0,
                    1 | 11 => coupling,
                    _ => 0.0,
                };
                own + compliance
            });
            let stiffened = DenseOperator::from_rows(len, stiffened.collect()).unwrap();
            let pulled: Vec<f64> = linear.iter().map(|b| b - far_end).collect();
            let exact = stiffened.minimise(&pulled, &NonNegative, None).unwrap().x;

            let spring = Total::Spring {
                far_end,
                compliance,
            };
            let problem = Problem::new(&chain, [&linear[..]], NonNegative).totals([spring]);
            let mut workspace = problem.workspace().unwrap();
            // The iterate is near the minimum, up to a constant common to all unknowns.
            let (mean, others) = (random.decade(-6.0, 0.0), random.decade(-6.0, -1.0));
            let mut x: Vec<f64> = exact
                .iter()
                .map(|x| (x + mean * (1.0 + random.uniform(-others, others))).max(0.0))
                .collect();
            let settings = Settings::default();
            let outcome =
                cgm::minimise_with(&problem, &settings, [&mut x], &mut workspace, &mut |_| {
                    ControlFlow::Break(())
                });
            let report = workspace.report();
            assert!(outcome.is_ok() || report.status == Status::Cancelled);

            let energy = |of: &dyn Operator, x: &[f64]| {
                let mut product = vec![0.0; len];
                of.apply([x], [&mut product], &mut Scratch::none());
                x.iter().zip(&product).map(|(x, u)| x * u).sum::<f64>()
            };
            let difference: Vec<f64> = x.iter().zip(&exact).map(|(a, b)| a - b).collect();
            let squares: f64 = x.iter().map(|x| x * x).sum();
            let unit = energy(&chain, &x).max(lower_bound * squares);
            let error = energy(&stiffened, &difference).max(0.0).sqrt();
            let bound = (report.duality_gap * unit).sqrt();
            // The dense minimum contains the round-off of the factorisation, which a stiff spring amplifies.
            let round_off = 1e-15 * max_abs(&exact) / compliance.sqrt() + 1e-13;
            assert!(
                error <= bound + round_off,
                "{coupling} {compliance:e}: error {error:e} exceeds bound {bound:e}"
            );
        }
    }
}
