//! Tests of the coupled pressure and traction of dissimilar bodies: comparisons with closed forms and with a different
//! code, and error bounds.

use kit::contact::Case;
use kit::{Random, max_difference, rough};
use stickslip::influence::Component;
use stickslip::influence::Direction::{X, Y, Z};
use stickslip::{
    Axis, Boundary, CoupledProblem, CoupledSolution, ElasticPair, Error, Field, Grid, HalfSpace,
    Material, NormalLoad, NormalProblem, Operator, Status, TangentialControl, TangentialLoad, cgm,
};

/// Stick ratios (ratios of the radii) to which the coefficients of [`FRICTION`] lead.
const STICK_RADII: [f64; 6] = [0.1, 0.3, 0.5, 0.7, 0.8, 0.9];
/// Dundurs' beta, and the friction coefficients that give a punch pressed in one step the stick ratios of
/// [`STICK_RADII`]. The coefficients were computed from ring elements with elliptic integrals, to 3e-5. By
/// self-similarity (Spence, Proc. R. Soc. A 305 (1968) 55) they are also valid for a sphere pressed in many steps.
const FRICTION: [(f64, [f64; 6]); 3] = [
    (0.5, [0.15508, 0.22659, 0.29872, 0.40124, 0.48584, 0.64746]),
    (
        2.0 / 7.0,
        [0.08072, 0.11704, 0.15249, 0.20053, 0.23800, 0.30387],
    ),
    (0.1, [0.02728, 0.03946, 0.05122, 0.06694, 0.07899, 0.09970]),
];

const STILL: TangentialControl = TangentialControl::Shift(0.0);

fn zero_shift() -> TangentialLoad {
    TangentialLoad::shift([0.0; 2]).along(Axis::X, STILL)
}

/// Returns an elastic body with Dundurs' constant `beta` on a rigid body, for which `beta = (1 - 2 nu) / (2 - 2 nu)`.
fn against_rigid(beta: f64) -> ElasticPair {
    let poisson_ratio = (1.0 - 2.0 * beta) / (2.0 - 2.0 * beta);
    let pair = ElasticPair::new(
        Material::new(1.0, poisson_ratio).unwrap(),
        Material::rigid(),
    );
    let pair = pair.unwrap();
    assert!((pair.dundurs_beta() - beta).abs() < 1e-12);
    pair
}

fn solve(
    bodies: &HalfSpace,
    gap: &Field,
    coefficient: f64,
    normal: NormalLoad,
    load: TangentialLoad,
    tolerance: f64,
) -> CoupledSolution {
    let problem = CoupledProblem::builder(bodies, gap, kit::coulomb(coefficient), normal, load);
    kit::solve(problem.tolerance(tolerance))
}

/// Returns the gap of a flat punch of radius one.
fn punch_gap(grid: Grid) -> Field {
    Field::from_fn(grid, |x, y| if x.hypot(y) < 1.0 { 0.0 } else { 1e3 })
}

/// The radius of the stick zone agrees to a tenth of a cell. If the radius spans only a few cells, the difference is
/// larger.
#[test]
fn punch_stick_radii_match_spence() {
    let grid = kit::square(65, 2.4);
    let cell = grid.dx();
    for (beta, coefficients) in FRICTION {
        let bodies = HalfSpace::new(grid, against_rigid(beta)).unwrap();
        let values = STICK_RADII.into_iter().zip(coefficients);
        for (radius, coefficient) in values.step_by(kit::thorough(2, 1)) {
            let force = NormalLoad::Force(1.0);
            let contact = solve(
                &bodies,
                &punch_gap(grid),
                coefficient,
                force,
                zero_shift(),
                1e-8,
            );
            let error = (contact.tangential().stick_ratio().sqrt() - radius) / cell;
            let allowed = if radius < 0.2 { 0.8 } else { 0.3 };
            assert!(error.abs() < allowed, "{beta} {radius}: {error} cells");
        }
    }
}

/// The error of the stick radius decreases with the cell size.
#[test]
fn punch_stick_radii_converge_with_the_grid() {
    let error = |cells: usize| {
        let grid = kit::square(cells, 2.4);
        let bodies = HalfSpace::new(grid, against_rigid(0.5)).unwrap();
        let errors = STICK_RADII.into_iter().zip(FRICTION[0].1).skip(1);
        let errors = errors.step_by(kit::thorough(3, 1));
        let errors: Vec<f64> = errors
            .map(|(radius, coefficient)| {
                let force = NormalLoad::Force(1.0);
                let contact = solve(
                    &bodies,
                    &punch_gap(grid),
                    coefficient,
                    force,
                    zero_shift(),
                    1e-6,
                );
                (contact.tangential().stick_ratio().sqrt() - radius).abs()
            })
            .collect();
        errors.iter().sum::<f64>() / errors.len() as f64
    };
    let (coarse, fine) = (error(33), error(129));
    assert!(coarse < 0.02 && fine < 0.4 * coarse, "{coarse} {fine}");
}

/// Compares the stiffness of a punch in full stick with Mossakovskii's factor `(1 - nu) ln(3 - 4 nu) / (1 - 2 nu)`
/// (Borodich & Keer, Proc. R. Soc. A 460 (2004) 507). The singular rim slips for any friction coefficient.
#[test]
fn punch_in_full_stick_matches_mossakovskii() {
    for &poisson_ratio in kit::thorough(&[0.3][..], &[0.0, 0.1, 0.2, 0.3, 0.4]) {
        let nu: f64 = poisson_ratio;
        let exact = (1.0 - nu) * (3.0 - 4.0 * nu).ln() / (1.0 - 2.0 * nu);
        let errors = [33, 129].map(|cells| {
            let grid = kit::square(cells, 2.4);
            let bodies = HalfSpace::new(grid, kit::on_rigid(1.0, nu)).unwrap();
            let (gap, press) = (punch_gap(grid), NormalLoad::Force(1.0));
            let stuck = solve(&bodies, &gap, 20.0, press, zero_shift(), 1e-6);
            let smooth = NormalProblem::builder(&bodies, &gap, press)
                .build()
                .unwrap();
            (smooth.solve().unwrap().approach() / stuck.normal().approach() / exact - 1.0).abs()
        });
        let [coarse, fine] = errors;
        assert!(
            fine < 2e-3 && fine < 0.4 * coarse,
            "{nu}: {coarse:e} {fine:e}"
        );
    }
}

/// Compares every cell and every zone with CONTACT's strongly coupled flat punch in plane strain, modelled by one row
/// of long cells.
#[test]
fn flat_punch_matches_contact_code() {
    let case = Case::read("tb25_tb26_flat_2d_dissimilar", 2);
    let step = &case.steps[0];
    let bodies = HalfSpace::new(case.grid, case.pair).unwrap();
    let press = step.normal_control().unwrap();
    let found = solve(
        &bodies,
        &case.gap(step),
        case.friction,
        press,
        zero_shift(),
        1e-11,
    );
    let shear = found.tangential();
    let fields = (found.normal().pressure(), shear.traction(), shear.zones());
    case.assert_fields_agree(step, fields, 5e-9, false);
    assert!((found.normal().approach() / step.approach - 1.0).abs() < 1e-9);
    let energy = step.elastic_energy.unwrap();
    assert!((found.elastic_energy() / energy - 1.0).abs() < 1e-8);
}

/// If one half is solved again accurately with the other half fixed, the change of this half is within its bound.
#[test]
fn halves_are_within_their_error_bounds() {
    let grid = Grid::new(24, 20, 0.1, 0.12).unwrap();
    for boundary in kit::boundaries(grid) {
        let bodies = HalfSpace::with_boundary(grid, against_rigid(0.45), boundary).unwrap();
        let gap = rough(kit::square(24, 1.0), 5);
        let gap = Field::from_indices(grid, |ix, iy| 0.05 * gap.get(ix, iy).unwrap());
        let force = 0.02 * grid.area();
        let (press, load) = (
            NormalLoad::Force(force),
            TangentialLoad::force([0.2 * force, 0.0]),
        );
        let found = solve(&bodies, &gap, 0.5, press, load, 3e-3);
        let tensor = bodies.tensor_operator([Z, X, Y]).unwrap();
        let product = |x: [&[f64]; 3]| {
            let mut out = [(); 3].map(|()| vec![0.0; grid.cells()]);
            let slices = out.each_mut().map(Vec::as_mut_slice);
            tensor.apply(x, slices, &mut tensor.scratch().unwrap());
            out
        };
        let (p, [x, y]) = (found.normal().pressure(), found.tangential().traction());
        let zeros = vec![0.0; grid.cells()];
        let (p, x, y) = (p.as_slice(), x.as_slice(), y.as_slice());
        let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
        let whole = product([p, x, y]);
        let energy = dot(p, &whole[0]) + dot(x, &whole[1]) + dot(y, &whole[2]);

        let [sheared, ..] = product([&zeros, x, y]);
        let linear: Vec<f64> = gap
            .as_slice()
            .iter()
            .zip(&sheared)
            .map(|(h, u)| h + u)
            .collect();
        let operator = bodies.operator(Component::ZZ).unwrap();
        let problem =
            cgm::Problem::new(operator, [&linear], cgm::NonNegative).total(p.iter().sum());
        let mut pressure = p.to_vec();
        let settings = cgm::Settings::default().tolerance(1e-10);
        cgm::minimise(&problem, &settings, [&mut pressure]).unwrap();
        let change: Vec<f64> = pressure.iter().zip(p).map(|(a, b)| a - b).collect();
        let error = (dot(&change, &product([&change, &zeros, &zeros])[0]) / energy).sqrt();
        let bound = found.report().pressure_error_bound;
        assert!(error <= bound && bound < 3e-3, "{error:e} {bound:e}");

        let [_, along_x, along_y] = product([p, &zeros, &zeros]);
        let limits: Vec<f64> = p.iter().map(|p| 0.5 * p).collect();
        let plane = bodies.tensor_operator([X, Y]).unwrap();
        let totals = [x, y].map(|q| cgm::Total::Sum(q.iter().sum()));
        let set = cgm::AbsBound(&limits);
        let problem = cgm::Problem::new(plane, [&along_x, &along_y], set).totals(totals);
        let (mut qx, mut qy) = (x.to_vec(), y.to_vec());
        cgm::minimise(&problem, &settings, [&mut qx, &mut qy]).unwrap();
        let change = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a - b).collect::<Vec<_>>();
        let (dx, dy) = (change(&qx, x), change(&qy, y));
        let moved = product([&zeros, &dx, &dy]);
        let error = ((dot(&dx, &moved[1]) + dot(&dy, &moved[2])) / energy).sqrt();
        let bound = found.report().traction_error_bound;
        assert!(error <= bound && bound < 3e-3, "{error:e} {bound:e}");
    }
}

/// Returns the errors of the pressure and of the traction of an inaccurate solution. Each error is in its energy norm,
/// relative to the energy norm of the complete solution.
fn energy_errors(bodies: &HalfSpace, loose: &CoupledSolution, exact: &CoupledSolution) -> [f64; 2] {
    let grid = bodies.grid();
    let tensor = bodies.tensor_operator([Z, X, Y]).unwrap();
    let norm = |x: [&[f64]; 3]| {
        let mut out = [(); 3].map(|()| vec![0.0; grid.cells()]);
        let slices = out.each_mut().map(Vec::as_mut_slice);
        tensor.apply(x, slices, &mut tensor.scratch().unwrap());
        let products = x.iter().zip(&out).map(|(x, u)| {
            let pairs = x.iter().zip(u);
            pairs.map(|(x, u)| x * u).sum::<f64>()
        });
        products.sum::<f64>().sqrt()
    };
    let [loose, exact] = [loose, exact].map(|contact| {
        let [x, y] = contact.tangential().traction();
        [contact.normal().pressure(), x, y].map(Field::as_slice)
    });
    let change =
        |c: usize| -> Vec<f64> { loose[c].iter().zip(exact[c]).map(|(a, b)| a - b).collect() };
    let ([p, x, y], zeros) = ([change(0), change(1), change(2)], vec![0.0; grid.cells()]);
    let size = norm(loose);
    [norm([&p, &zeros, &zeros]), norm([&zeros, &x, &y])].map(|error| error / size)
}

/// The errors of inaccurate solutions for couplings of any strength, also under prescribed forces, are within the
/// estimates.
#[test]
fn errors_are_within_their_estimates() {
    let grid = kit::square(20, 2.6);
    let mut random = Random(5);
    for scene in 0..40 {
        let beta = random.uniform(0.02, 0.5);
        let bodies = HalfSpace::new(grid, against_rigid(beta)).unwrap();
        let height = random.decade(-2.5, -1.0);
        let gap = Field::from_fn(grid, |x, y| {
            0.05 * (x * x + y * y) + height * random.uniform(0.0, 1.0)
        });
        let (coefficient, press) = (random.decade(-1.0, 0.0), NormalLoad::Force(0.1));
        let load = if scene % 2 == 0 {
            TangentialLoad::shift([0.2 * coefficient, 0.1 * coefficient])
        } else {
            TangentialLoad::force([0.05 * coefficient, 0.03 * coefficient])
        };
        let exact = solve(&bodies, &gap, coefficient, press, load, 1e-11);
        let loose = solve(
            &bodies,
            &gap,
            coefficient,
            press,
            load,
            random.decade(-4.0, -1.5),
        );
        let estimate = loose.report().error_estimate.unwrap();
        let [p, q] = energy_errors(&bodies, &loose, &exact);
        assert!(p <= estimate.pressure, "{scene}: {p:e} {estimate:?}");
        assert!(q <= estimate.traction, "{scene}: {q:e} {estimate:?}");
    }
}

/// Under weak friction the bounds of the halves imply bounds of the complete solution. The errors of inaccurate
/// solutions are within these bounds.
#[test]
fn weak_friction_errors_are_within_certified_bounds() {
    let grid = kit::square(20, 2.6);
    let bodies = HalfSpace::new(grid, against_rigid(0.12)).unwrap();
    let gap = kit::sphere(grid, 10.0);
    let press = NormalLoad::Force(0.1);
    let load = TangentialLoad::shift([0.02, 0.01]);
    let exact = solve(&bodies, &gap, 0.1, press, load, 1e-13);
    for tolerance in [3e-2, 1e-3, 1e-5] {
        let loose = solve(&bodies, &gap, 0.1, press, load, tolerance);
        let bounds = loose.report().error_bounds.unwrap();
        for (error, bound) in energy_errors(&bodies, &loose, &exact)
            .into_iter()
            .zip(bounds)
        {
            assert!(
                error <= bound && bound < 30.0 * tolerance,
                "{error:e} {bound:e}"
            );
        }
    }
    // If the coupling is too strong for the grid, or under a force, the complete solution has no certified bounds.
    let strong = solve(&bodies, &gap, 1.0, press, load, 1e-6);
    assert!(strong.report().error_bounds.is_none());
    let forced = solve(
        &bodies,
        &gap,
        0.1,
        press,
        TangentialLoad::force([0.002, 0.0]),
        1e-6,
    );
    assert!(forced.report().error_bounds.is_none());
}

#[test]
fn rough_bodies_of_random_pairs_converge() {
    let mut random = Random(7);
    for scene in 0..120 {
        let (nx, ny) = (random.integer(6, 30), random.integer(6, 30));
        let grid = Grid::new(nx, ny, 1.0, random.decade(-0.6, 0.6)).unwrap();
        let body = |random: &mut Random| {
            let nu = random.uniform(0.0, 0.5);
            Material::new(random.decade(-1.0, 1.0), nu).unwrap()
        };
        let hard = Material::rigid();
        let pair = if random.chance(0.4) {
            ElasticPair::new(hard, body(&mut random))
        } else {
            ElasticPair::new(body(&mut random), body(&mut random))
        };
        let boundary = if random.chance(0.3) {
            Boundary::Periodic
        } else {
            Boundary::NonPeriodic
        };
        let bodies = HalfSpace::with_boundary(grid, pair.unwrap(), boundary).unwrap();
        let height = random.decade(-2.0, 0.0);
        let gap = Field::from_fn(grid, |x, y| {
            0.002 * (x * x + y * y) + height * random.uniform(0.0, 1.0)
        });
        let modulus = bodies.pair().contact_modulus();
        let (coefficient, force) = (
            random.decade(-1.3, 0.3),
            random.decade(-4.0, -1.0) * modulus * grid.area(),
        );
        let shear = random.uniform(-0.67, 0.67) * coefficient * force;
        let load = match scene % 3 {
            0 => TangentialLoad::force([shear, 0.8 * shear]),
            1 => TangentialLoad::shift([shear / modulus, -shear / modulus]),
            _ => TangentialLoad::spring([shear / modulus, 0.0], random.decade(-1.0, 1.0) * modulus),
        };
        let found = solve(
            &bodies,
            &gap,
            coefficient,
            NormalLoad::Force(force),
            load,
            1e-10,
        );
        let report = found.report();
        assert!(report.work.history.len() <= 20, "{scene}: {report:?}");
        assert!(
            (found.normal().force() / force - 1.0).abs() < 1e-10,
            "{scene}"
        );
    }
}

#[test]
fn zero_load_and_zero_friction_are_solved() {
    let grid = kit::square(16, 2.0);
    let bodies = HalfSpace::new(grid, against_rigid(0.5)).unwrap();
    let gap = kit::sphere(grid, 5.0);
    let empty = solve(
        &bodies,
        &gap,
        0.3,
        NormalLoad::Force(0.0),
        zero_shift(),
        1e-8,
    );
    assert!(empty.normal().pressure().max() == 0.0 && empty.tangential().stick_ratio() == 0.0);

    let press = NormalLoad::Force(0.05);
    let smooth = solve(&bodies, &gap, 0.0, press, zero_shift(), 1e-10);
    let normal = NormalProblem::builder(&bodies, &gap, press).tolerance(1e-10);
    let normal = kit::solve(normal);
    assert!(
        max_difference(
            smooth.normal().pressure().as_slice(),
            normal.pressure().as_slice()
        ) < 1e-10
    );
    assert!(
        smooth
            .tangential()
            .traction()
            .iter()
            .all(|q| q.max() == 0.0 && q.min() == 0.0)
    );
}

#[test]
fn loads_that_are_invalid_or_beyond_capacity_are_rejected() {
    let grid = kit::square(16, 2.0);
    let bodies = HalfSpace::new(grid, against_rigid(0.5)).unwrap();
    let build = |normal: NormalLoad, load: TangentialLoad| {
        CoupledProblem::builder(
            &bodies,
            kit::sphere(grid, 5.0),
            kit::coulomb(0.3),
            normal,
            load,
        )
    };
    let refused = build(NormalLoad::Force(-1.0), zero_shift()).build();
    assert!(matches!(refused, Err(Error::NegativeOrNotFinite { value, .. }) if value == -1.0));
    let sliding = build(NormalLoad::Force(1.0), TangentialLoad::force([0.3, 0.1])).build();
    kit::assert_refused! { sliding.unwrap().solve() => Error::BeyondFrictionCapacity { limit, .. } if limit == 0.3 }

    let short = build(NormalLoad::Force(1.0), zero_shift())
        .max_iterations(3)
        .build();
    let Err(Error::NotConverged(report)) = short.unwrap().solve() else {
        panic!("the solve converged within three iterations");
    };
    assert!(report.status == Status::IterationLimit && report.duality_gap == f64::INFINITY);
    assert!(report.residual > 1e-8);
}

/// In some of the cases the last solution is a poor start. The pressure and the traction are then solved from scratch.
#[test]
fn tolerances_of_any_size_are_met() {
    let grid = kit::square(24, 3.0);
    let bodies = HalfSpace::new(grid, against_rigid(0.5)).unwrap();
    let friction = kit::coulomb(0.3);
    for tolerance in [0.9, 0.1, 1e-2, 1e-6] {
        let press = NormalLoad::Force(0.01);
        let load = TangentialLoad::force([0.001, 0.0]);
        let problem = CoupledProblem::builder(
            &bodies,
            kit::sphere(grid, 10.0),
            friction.clone(),
            press,
            load,
        );
        let problem = problem.tolerance(tolerance).build().unwrap();
        let mut solver = problem.into_solver().unwrap();
        let mut contact = solver.new_solution();
        for force in [0.01, 0.2, 0.02, 0.3] {
            solver.set_loads(NormalLoad::Force(force), load).unwrap();
            solver.solve_into(&mut contact).unwrap();
            let report = contact.report();
            assert!(report.work.residual <= tolerance && report.work.load_error <= tolerance);
        }
    }
}
