//! Tests of values at the centres of cells. Away from the edge of the contact, they give a more accurate pressure than
//! uniform cells, at the same cost and with the same certificate. Values at the centres and values of uniform cells
//! cannot be mixed.

use kit::smooth::{Smooth, l1_difference};
use kit::{boundaries, max_abs, max_difference, unit_pair};
use stickslip::Scratch;
use stickslip::analytical::{CattaneoMindlin, HertzSphere};
#[cfg(feature = "dense")]
use stickslip::dense::DenseOperator;
use stickslip::influence::{Component, Direction};
use stickslip::subsurface::{Body, Planes, Tractions, at_points};
use stickslip::tangential::JaegerSuperposition;
use stickslip::*;

fn with_values(grid: Grid, boundary: Boundary, cell_value: CellValue) -> HalfSpace {
    let bodies = HalfSpace::with_boundary(grid, coupled_pair(), boundary).unwrap();
    bodies.with_cell_value(cell_value).unwrap()
}

fn coupled_pair() -> ElasticPair {
    kit::on_rigid(1.0, 0.2)
}

fn random_field(grid: Grid, seed: u64) -> Field {
    let mut random = kit::Random(seed);
    Field::from_fn(grid, |_, _| random.uniform(-1.0, 1.0))
}

/// Returns the second difference of a field, which is zero beyond the grid.
fn second_difference(field: &Field, repeats_y: bool) -> Field {
    let ny = field.grid().ny() as i64;
    let at = |i: i64, j: i64| {
        let j = if repeats_y { j.rem_euclid(ny) } else { j };
        let place = [i, j].map(|place| usize::try_from(place).unwrap_or(usize::MAX));
        field.get(place[0], place[1]).unwrap_or(0.0)
    };
    Field::from_indices(field.grid(), |i, j| {
        let (i, j) = (i as i64, j as i64);
        at(i - 1, j) + at(i + 1, j) + at(i, j - 1) + at(i, j + 1) - 4.0 * at(i, j)
    })
}

fn product(bodies: &HalfSpace, component: Component, traction: &Field) -> Vec<f64> {
    let operator = bodies.operator(component).unwrap();
    let mut out = vec![0.0; traction.as_slice().len()];
    operator.apply(
        [traction.as_slice()],
        [&mut out],
        &mut operator.scratch().unwrap(),
    );
    out
}

/// The displacement equals the displacement of uniform cells under the traction minus 1/24 of its second difference.
#[test]
fn centre_products_match_uniform_cells_minus_second_difference() {
    for (nx, ny, dx, dy) in [
        (14, 11, 0.5, 0.7),
        (9, 6, 1.0, 0.2),
        (12, 1, 0.3, 0.4),
        (3, 3, 1.0, 1.0),
    ] {
        let grid = Grid::new(nx, ny, dx, dy).unwrap();
        let boundary = Boundary::PeriodicAlongY { datum: 40.0 };
        for boundary in [Boundary::NonPeriodic, boundary] {
            let repeats_y = boundary != Boundary::NonPeriodic;
            let centres = with_values(grid, boundary, CellValue::Centre);
            let uniform = with_values(grid, boundary, CellValue::Uniform);
            // Part of a traction at a free edge is spread beyond the edge and would be missing on uniform cells. The
            // outermost cells therefore carry no traction.
            let is_inside = |i: usize, n: usize| n > 2 && i > 0 && i + 1 < n;
            let random = random_field(grid, 7);
            let traction = Field::from_indices(grid, |i, j| {
                let is_in = is_inside(i, nx) && (repeats_y || is_inside(j, ny));
                if is_in {
                    random.get(i, j).unwrap()
                } else {
                    0.0
                }
            });
            let mut spread = second_difference(&traction, repeats_y).scaled(-1.0 / 24.0);
            spread.add_scaled(1.0, &traction).unwrap();
            for component in Component::ALL {
                let found = product(&centres, component, &traction);
                let expected = product(&uniform, component, &spread);
                let scale = max_abs(&expected) + 1e-3;
                assert!(
                    max_difference(&found, &expected) < 1e-14 * scale,
                    "{component:?} {grid:?}"
                );
            }
        }
    }
}

/// A periodic grid always uses values at the centres.
#[test]
fn periodic_grid_always_has_centre_values() {
    let grid = Grid::new(12, 9, 0.5, 0.7).unwrap();
    for asked in [CellValue::Uniform, CellValue::Centre] {
        let bodies = with_values(grid, Boundary::Periodic, asked);
        assert_eq!(bodies.cell_value(), CellValue::Centre);
        let plain = HalfSpace::with_boundary(grid, coupled_pair(), Boundary::Periodic).unwrap();
        let traction = random_field(grid, 3);
        let found = product(&bodies, Component::ZZ, &traction);
        assert_eq!(found, product(&plain, Component::ZZ, &traction));
    }
}

#[cfg(feature = "dense")]
#[test]
fn centre_products_match_direct_sums() {
    for (nx, ny) in [(13, 9), (8, 8), (1, 7), (11, 1), (1, 1), (4, 3)] {
        let grid = Grid::new(nx, ny, 0.5, 0.8).unwrap();
        for boundary in boundaries(grid) {
            let bodies = with_values(grid, boundary, CellValue::Centre);
            let traction = random_field(grid, 5);
            for component in Component::ALL {
                let twin = DenseOperator::of_half_space(&bodies, component).unwrap();
                let mut direct = vec![0.0; grid.cells()];
                twin.apply([traction.as_slice()], [&mut direct], &mut Scratch::none());
                let fast = product(&bodies, component, &traction);
                let scale = max_abs(&direct) + 1e-3;
                assert!(
                    max_difference(&fast, &direct) < 1e-13 * scale,
                    "{component:?} {grid:?} {boundary:?}"
                );
            }
        }
    }
}

/// t'Ct <= t'C't <= 4/3 t'Ct, and the lower bound of an operator is below its eigenvalues.
#[cfg(feature = "dense")]
#[test]
fn centre_eigenvalues_are_within_four_thirds_of_uniform_cells() {
    for (nx, ny, dy) in [(9, 7, 0.5), (5, 11, 1.0), (14, 1, 0.5), (6, 6, 0.1)] {
        let grid = Grid::new(nx, ny, 0.5, dy).unwrap();
        let cells = grid.cells();
        for boundary in boundaries(grid)
            .into_iter()
            .filter(|b| *b != Boundary::Periodic)
        {
            let of = |value| with_values(grid, boundary, value);
            for component in [Component::XX, Component::YY, Component::ZZ] {
                let matrix = |value| DenseOperator::of_half_space(&of(value), component).unwrap();
                let (uniform, centres) = (matrix(CellValue::Uniform), matrix(CellValue::Centre));
                let combined = |of_uniform: f64, of_centres: f64| {
                    let entry = |k: usize| {
                        let [a, b] =
                            [&uniform, &centres].map(|m| m.get(k / cells, k % cells).unwrap());
                        of_uniform * a + of_centres * b
                    };
                    DenseOperator::from_rows(cells, (0..cells * cells).map(entry).collect())
                        .unwrap()
                };
                // The difference C' - C is positive definite. For waves as long as the grid, the ratio of C' to C is
                // close to one.
                assert!(
                    combined(-1.0, 1.0).lower_bound() > 0.0,
                    "{component:?} {boundary:?}"
                );
                assert!(combined(4.0 / 3.0, -1.0).lower_bound() > 0.0);
                let least = centres.lower_bound();
                assert!(least >= uniform.lower_bound());
                let bound = of(CellValue::Centre)
                    .operator(component)
                    .unwrap()
                    .lower_bound();
                assert!(
                    bound > 0.5 * least && bound <= least * (1.0 + 1e-9),
                    "{bound} {least}"
                );
            }
        }
    }
}

/// The operator of all three directions is symmetric and positive definite, and its preconditioner is an approximate
/// inverse.
#[test]
fn centre_preconditioner_inverts_operator() {
    let grid = Grid::new(24, 18, 0.5, 0.7).unwrap();
    let bodies = with_values(grid, Boundary::NonPeriodic, CellValue::Centre);
    let directions = [Direction::X, Direction::Y, Direction::Z];
    let operator = bodies.tensor_operator(directions).unwrap();
    let inverse = bodies.tensor_preconditioner(directions).unwrap();
    let fields = [1, 2, 3].map(|seed| random_field(grid, seed));
    let mut images = [(); 3].map(|()| vec![0.0; grid.cells()]);
    let mut found = images.clone();
    let out = images.each_mut().map(|u| &mut u[..]);
    operator.apply(
        fields.each_ref().map(Field::as_slice),
        out,
        &mut operator.scratch().unwrap(),
    );
    let out = found.each_mut().map(|t| &mut t[..]);
    inverse.apply(
        images.each_ref().map(|u| &u[..]),
        out,
        &mut inverse.scratch().unwrap(),
    );
    // The comparison excludes the edges, where the circulant wraps around. The random fields contain short waves, whose
    // inverse the stencil reduces by up to a quarter.
    let mut errors = [0.0; 2];
    for (found, field) in found.iter().zip(&fields) {
        for (i, j) in (6..18).flat_map(|i| (5..13).map(move |j| (i, j))) {
            let (exact, found) = (field.get(i, j).unwrap(), found[j * 24 + i]);
            errors[0] += (found - exact).powi(2);
            errors[1] += exact * exact;
        }
    }
    assert!(errors[0] < 0.01 * errors[1], "{errors:?}");
}

const OFFSETS: [[f64; 2]; 3] = [[0.0, 0.0], [0.31, -0.17], [-0.42, 0.48]];

/// Returns whether the condition holds in all cells of the 7 x 7 square around a cell.
fn holds_around(field: &Field, index: usize, is_so: impl Fn(f64) -> bool) -> bool {
    let (i, j) = (index % field.grid().nx(), index / field.grid().nx());
    let around = |k: usize| (0..7).map(move |step| (k + step).checked_sub(3));
    around(j).all(|row| {
        around(i).all(|column| {
            let value = column
                .zip(row)
                .and_then(|(column, row)| field.get(column, row));
            value.is_some_and(&is_so)
        })
    })
}

/// Away from the edge the error of the pressure is less than a third of the error on uniform cells. Over all cells it
/// is at least 15 % smaller than on uniform cells.
#[test]
fn centre_pressures_are_closer_to_closed_forms() {
    let grid = kit::square(64, 3.0);
    let bodies = HalfSpace::new(grid, unit_pair(0.0)).unwrap();
    let centres = bodies.clone().with_cell_value(CellValue::Centre).unwrap();
    for shape in Smooth::all() {
        let mut errors = [[0.0; 2]; 2];
        for offset in OFFSETS {
            let (gap, exact) = (shape.gap(grid, offset), shape.pressure(grid, offset));
            let is_inside = |i: usize| holds_around(&exact, i, |p| p > 0.0);
            for (bodies, errors) in [&bodies, &centres].into_iter().zip(&mut errors) {
                let problem = NormalProblem::builder(bodies, &gap, shape.load());
                let found = kit::solve(problem.tolerance(1e-7));
                errors[0] += l1_difference(found.pressure(), &exact, is_inside) / 3.0;
                errors[1] += l1_difference(found.pressure(), &exact, |_| true) / 3.0;
            }
        }
        let [[inside, all], [centres_inside, centres_all]] = errors;
        assert!(centres_inside < inside / 3.0, "{} {errors:?}", shape.name);
        assert!(centres_all < 0.85 * all, "{} {errors:?}", shape.name);
    }
}

/// The traction in partial slip is also closer to the closed form than on uniform cells.
#[test]
fn centre_tractions_are_closer_to_closed_forms() {
    let grid = kit::square(64, 3.0);
    let hertz = HertzSphere::new(&unit_pair(0.0), 1.0, 4.0 / 3.0).unwrap();
    let exact = CattaneoMindlin::new(hertz, 0.5, 0.4 * 0.5 * 4.0 / 3.0).unwrap();
    let shape = Smooth::sphere();
    let [mut uniform, mut centres] = [[0.0; 2]; 2];
    for offset in OFFSETS {
        let at = |x: f64, y: f64| (x - offset[0] * grid.dx()).hypot(y - offset[1] * grid.dy());
        let traction = Field::from_fn(grid, |x, y| exact.traction(at(x, y)));
        let radii = Field::from_fn(grid, at);
        for (value, errors) in [
            (CellValue::Uniform, &mut uniform),
            (CellValue::Centre, &mut centres),
        ] {
            let bodies = HalfSpace::new(grid, unit_pair(0.0)).unwrap();
            let bodies = bodies.with_cell_value(value).unwrap();
            let gap = shape.gap(grid, offset);
            let problem = NormalProblem::builder(&bodies, &gap, shape.load());
            let normal = kit::solve(problem.tolerance(1e-7));
            let load = TangentialLoad::force([exact.force(), 0.0]);
            let problem = TangentialProblem::builder(&bodies, &normal, kit::coulomb(0.5), load);
            let shear = kit::solve(problem.tolerance(1e-7));
            assert_eq!(shear.cell_value(), value);
            let is_inside = |i: usize| {
                holds_around(&radii, i, |r| r < exact.stick_radius())
                    || holds_around(&radii, i, |r| r > exact.stick_radius() && r < 1.0)
            };
            errors[0] += l1_difference(shear.traction()[0], &traction, is_inside);
            errors[1] += l1_difference(shear.traction()[0], &traction, |_| true);
        }
    }
    // The stencil does not change the edge of the stick zone, which causes an offset of the tractions inside.
    assert!(centres[0] < 0.8 * uniform[0], "{centres:?} {uniform:?}");
    assert!(centres[1] < 0.85 * uniform[1], "{centres:?} {uniform:?}");
}

/// The stresses equal the stresses of uniform cells with the same surface displacements.
#[test]
fn subsurface_stresses_match_uniform_cells_of_same_displacement() {
    let grid = Grid::new(20, 16, 0.1, 0.12).unwrap();
    for boundary in boundaries(grid) {
        let centres = with_values(grid, boundary, CellValue::Centre);
        let uniform = with_values(grid, boundary, CellValue::Uniform);
        let pressure = Field::from_fn(grid, |x, y| (0.3 - x * x - y * y).max(0.0));
        let repeats_y = boundary != Boundary::NonPeriodic;
        let mut spread = pressure.clone();
        if boundary != Boundary::Periodic {
            let difference = second_difference(&pressure, repeats_y);
            spread.add_scaled(-1.0 / 24.0, &difference).unwrap();
        }
        let below = |bodies: &HalfSpace, field: &Field| {
            let mut planes = Planes::new(bodies, &[0.1]).unwrap();
            planes
                .solve(0, Body::One, Tractions::new(field))
                .unwrap()
                .map(|stress| stress.von_mises())
        };
        let (found, expected) = (below(&centres, &pressure), below(&uniform, &spread));
        assert!(
            max_difference(found.as_slice(), expected.as_slice()) < 1e-15,
            "{boundary:?}"
        );
        if boundary == Boundary::NonPeriodic {
            let at = |bodies: &HalfSpace, field: &Field| {
                at_points(bodies, Body::One, Tractions::new(field), &[[0.1, 0.0, 0.2]]).unwrap()[0]
            };
            let [found, expected] = [at(&centres, &pressure), at(&uniform, &spread)];
            let difference = max_difference(&found.displacement, &expected.displacement);
            assert!(difference < 1e-15 && (found.stress - expected.stress).von_mises() < 1e-15);
        }
    }
}

/// A solution, a history and a saved history require bodies with values of the same type.
#[test]
fn mismatched_cell_values_are_rejected() {
    let grid = kit::square(24, 3.0);
    let of = |value| {
        let bodies = HalfSpace::new(grid, unit_pair(0.3)).unwrap();
        bodies.with_cell_value(value).unwrap()
    };
    let (uniform, centres) = (of(CellValue::Uniform), of(CellValue::Centre));
    let gap = Smooth::sphere().gap(grid, [0.0; 2]);
    let press = |bodies: &HalfSpace| {
        let problem = NormalProblem::builder(bodies, &gap, NormalLoad::Force(0.5));
        kit::solve(problem)
    };
    let contact = press(&centres);
    assert_eq!(contact.cell_value(), CellValue::Centre);
    let friction = || kit::coulomb(0.5);
    let load = || TangentialLoad::force([0.1, 0.0]);
    let shear =
        |bodies, contact| TangentialProblem::builder(bodies, contact, friction(), load()).build();
    let is_refused =
        |error: Error| assert!(matches!(error, Error::CellValueMismatch { .. }), "{error}");
    is_refused(contact.displacement(&uniform).unwrap_err());
    is_refused(contact.stiffness(&uniform).unwrap_err());
    is_refused(shear(&uniform, &contact).unwrap_err());
    let sheared = shear(&centres, &contact).unwrap().solve().unwrap();
    is_refused(sheared.displacement(&uniform).unwrap_err());
    is_refused(
        JaegerSuperposition::new(&press(&uniform), &contact, uniform.pair(), 0.5).unwrap_err(),
    );
    is_refused(
        Planes::new(&uniform, &[0.1])
            .unwrap()
            .solve(0, Body::One, &contact)
            .unwrap_err(),
    );

    let history = |bodies: &HalfSpace| {
        let mut history = History::builder(bodies, &gap, friction()).build().unwrap();
        history
            .step(&LoadStep::hold().normal(NormalLoad::Force(0.5)))
            .unwrap();
        history
    };
    let mut one = history(&centres);
    assert_eq!(one.normal().cell_value(), CellValue::Centre);
    is_refused(History::from_bytes(&uniform, &one.to_bytes()).unwrap_err());
    is_refused(
        one.set_state(&history(&uniform).state().clone())
            .unwrap_err(),
    );
    let mut two = History::from_bytes(&centres, &one.to_bytes()).unwrap();
    let step = LoadStep::hold().tangential(Axis::X, TangentialControl::Force(0.1));
    let [first, second] = [&mut one, &mut two].map(|history| history.step(&step).unwrap().shift());
    assert_eq!(first, second);
    // The two types of values are distinguished even before the first solve.
    let fresh = History::builder(&centres, &gap, friction())
        .build()
        .unwrap();
    is_refused(History::from_bytes(&uniform, &fresh.to_bytes()).unwrap_err());
}
