//! The least-squares method finds and removes a form exactly, with and without missing heights.

use kit::Random;
use proptest::prelude::*;
use stickslip::surface::{Form, Levelled, level};
use stickslip::{Error, Field, Grid};

/// Returns a polynomial of the given total degree on the grid, with random coefficients of order one.
fn polynomial(grid: Grid, degree: usize, seed: u64) -> Field {
    let mut random = Random(seed);
    let half = [grid.nx() as f64 * grid.dx(), grid.ny() as f64 * grid.dy()].map(|side| 0.5 * side);
    let terms: Vec<_> = (0..=degree)
        .flat_map(|i| (0..=degree - i).map(move |j| (i, j)))
        .map(|(i, j)| (i32::try_from(i).unwrap(), i32::try_from(j).unwrap()))
        .map(|(i, j)| (i, j, random.uniform(-1.0, 1.0)))
        .collect();
    Field::from_fn(grid, |x, y| {
        let (x, y) = (x / half[0], y / half[1]);
        terms
            .iter()
            .map(|(i, j, c)| c * x.powi(*i) * y.powi(*j))
            .sum()
    })
}

fn add_noise(field: &mut Field, seed: u64, size: f64) {
    let mut random = Random(seed);
    for z in field.as_mut_slice() {
        *z += random.uniform(-size, size);
    }
}

fn remove_samples(field: &mut Field, seed: u64, share: f64) {
    let mut random = Random(seed);
    for z in field.as_mut_slice() {
        if random.uniform(0.0, 1.0) < share {
            *z = f64::NAN;
        }
    }
}

/// Returns the form of a degree, as a named variant if the form has a name.
fn form(degree: usize) -> Form {
    match degree {
        0 => Form::Mean,
        1 => Form::Plane,
        _ => Form::Polynomial(degree),
    }
}

/// Returns the largest deviation of two fields over the cells where both are known.
fn difference(a: &Field, b: &Field) -> f64 {
    let pairs = a.as_slice().iter().zip(b.as_slice());
    // A missing height gives NaN, which `max` ignores.
    pairs.map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
}

/// Covers a plane with a distant datum. The heights are known only in a corner of the grid, with and without missing
/// heights.
#[test]
fn plane_is_found_exactly() {
    for (nx, ny, share, datum) in [
        (301, 207, 0.0, 0.0),
        (64, 48, 0.3, 1e6),
        (5, 7, 0.5, -3.0),
        (2, 2, 0.0, 1.0),
        (1, 9, 0.2, 1.0),
    ] {
        let grid = Grid::new(nx, ny, 1e-6, 2e-6).unwrap();
        let exact = Field::from_fn(grid, |x, y| datum + 2e4 * x - 3e4 * y);
        let mut measured = exact.clone();
        remove_samples(&mut measured, 3, share);
        let is_corner = |ix, iy| nx < 60 || (ix > nx / 2 && iy < ny / 3);
        for (cell, z) in measured.as_mut_slice().iter_mut().enumerate() {
            if !is_corner(cell % nx, cell / nx) {
                *z = f64::NAN;
            }
        }
        let found = level(&measured, Form::Plane).unwrap();
        let error = difference(found.form(), &exact);
        assert!(
            error < 1e-14 * datum.abs().max(10.0),
            "{nx} x {ny}: {error:e}"
        );
        for (before, after) in measured.as_slice().iter().zip(found.heights().as_slice()) {
            assert_eq!(before.is_nan(), after.is_nan());
        }
    }
}

#[test]
fn mean_is_taken_over_known_heights() {
    let grid = Grid::new(50, 40, 1.0, 0.3).unwrap();
    let mut measured = Field::zeros(grid);
    add_noise(&mut measured, 4, 1.0);
    remove_samples(&mut measured, 5, 0.3);
    let known = measured.as_slice().iter().filter(|z| !z.is_nan());
    let mean = known.clone().sum::<f64>() / known.count() as f64;
    let found = level(&measured, Form::Mean).unwrap();
    assert!(difference(found.form(), &Field::constant(grid, mean)) < 1e-15);
}

#[test]
fn polynomial_is_found_exactly() {
    for (degree, nx, ny, share) in [
        (0, 5, 7, 0.0),
        (1, 64, 48, 0.3),
        (2, 301, 207, 0.0),
        (3, 100, 90, 0.6),
        (8, 150, 150, 0.2),
        (20, 128, 160, 0.1),
    ] {
        let grid = Grid::new(nx, ny, 1e-6, 2e-6).unwrap();
        let exact = polynomial(grid, degree, 5);
        let mut measured = exact.clone();
        remove_samples(&mut measured, 3, share);
        let found = level(&measured, Form::Polynomial(degree)).unwrap();
        let error = difference(found.form(), &exact);
        assert!(error < 1e-12, "degree {degree}: {error:e}");
        assert!(difference(found.heights(), &Field::zeros(grid)) < 1e-12);
        for (before, after) in measured.as_slice().iter().zip(found.heights().as_slice()) {
            assert_eq!(before.is_nan(), after.is_nan());
        }
    }
}

#[test]
fn distant_datum_and_corner_cost_no_accuracy() {
    let grid = Grid::new(200, 100, 1.0, 1.0).unwrap();
    let exact = polynomial(grid, 4, 8);
    let mut measured = exact.clone();
    for (cell, z) in measured.as_mut_slice().iter_mut().enumerate() {
        let (ix, iy) = (cell % 200, cell / 200);
        *z = if ix > 160 && iy < 30 {
            *z + 1e6
        } else {
            f64::NAN
        };
    }
    let found = level(&measured, Form::Polynomial(4)).unwrap();
    // Round-off of the datum is about 1e6 * 1e-16.
    assert!(difference(found.heights(), &Field::zeros(grid)) < 1e-9);
}

/// The two results come from different factorisations and agree to round-off.
#[test]
fn named_forms_match_polynomials() {
    for (nx, ny, share, seed) in [(20, 30, 0.2, 1), (130, 90, 0.9, 2), (1, 40, 0.3, 3)] {
        let grid = Grid::new(nx, ny, 1.0, 0.5).unwrap();
        let mut measured = polynomial(grid, 2, seed);
        add_noise(&mut measured, seed, 0.1);
        remove_samples(&mut measured, 2, share);
        let level = |form| level(&measured, form).unwrap();
        for (named, degree) in [(Form::Mean, 0), (Form::Plane, 1)] {
            let (named, twin) = (level(named), level(Form::Polynomial(degree)));
            assert!(difference(named.form(), twin.form()) < 1e-14);
        }
    }
}

#[test]
fn profiles_are_levelled_along_their_axis() {
    let line = Grid::new(1, 40, 1.0, 0.1).unwrap();
    let measured = Field::from_fn(line, |_, y| 3.0 - 2.0 * y + y * y);
    let found = level(&measured, Form::Polynomial(2)).unwrap();
    assert!(difference(found.form(), &measured) < 1e-13);
    let point = Field::constant(Grid::new(1, 1, 1.0, 1.0).unwrap(), 7.0);
    assert!(difference(level(&point, Form::Plane).unwrap().form(), &point) < 1e-15);
}

#[test]
fn underdetermined_form_is_rejected() {
    let grid = Grid::new(12, 9, 1.0, 1.0).unwrap();
    let only = |is_known: &dyn Fn(usize, usize) -> bool| {
        let mut field = Field::constant(grid, f64::NAN);
        for (cell, z) in field.as_mut_slice().iter_mut().enumerate() {
            if is_known(cell % 12, cell / 12) {
                *z = 1.0;
            }
        }
        field
    };
    let refused = |field: &Field, form| match level(field, form) {
        Err(Error::Undetermined {
            unknowns, known, ..
        }) => (unknowns, known),
        other => panic!("must be rejected: {other:?}"),
    };
    assert_eq!(refused(&only(&|_, _| false), Form::Mean), (1, 0));
    assert_eq!(
        refused(&only(&|ix, iy| ix == 3 && iy < 2), Form::Plane),
        (3, 2)
    );
    // All known heights are on a diagonal, on a column, in a square of four cells, or on a circle.
    assert_eq!(refused(&only(&|ix, iy| ix == iy), Form::Plane), (3, 9));
    assert_eq!(refused(&only(&|ix, _| ix == 4), Form::Plane), (3, 9));
    let corners = only(&|ix, iy| (3..5).contains(&ix) && (3..5).contains(&iy));
    assert_eq!(refused(&corners, Form::Polynomial(2)), (6, 4));
    let ring = only(&|ix, iy| {
        let squared = [ix.abs_diff(5), iy.abs_diff(4)].map(|side| side * side);
        squared.iter().sum::<usize>() == 10
    });
    assert_eq!(refused(&ring, Form::Polynomial(2)), (6, 8));
    assert!(
        level(
            &only(&|ix, iy| ix + iy == 1 || ix == 7 && iy == 7),
            Form::Plane
        )
        .is_ok()
    );
}

#[test]
fn invalid_input_is_rejected() {
    let grid = Grid::new(6, 6, 1.0, 1.0).unwrap();
    let error = level(&Field::zeros(grid), Form::Polynomial(21)).err();
    let limit = 20;
    assert_eq!(error, Some(Error::Degree { degree: 21, limit }));
    let mut infinite = Field::zeros(grid);
    infinite.as_mut_slice()[8] = f64::INFINITY;
    kit::assert_refused! { level(&infinite, Form::Mean) => Error::Sample { index: 8, .. } }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(kit::thorough(22, 64)))]

    /// The levelled heights are orthogonal to the form, levelling them again changes nothing, and a form added before
    /// is removed completely.
    #[test]
    fn levelling_is_orthogonal_idempotent_and_complete(
        nx in 8..40_usize,
        ny in 8..40_usize,
        degree in 0..5_usize,
        share in 0.0..0.4_f64,
        seed: u64,
    ) {
        let grid = Grid::new(nx, ny, 1.0, 0.3).unwrap();
        let form = form(degree);
        let mut measured = Field::zeros(grid);
        add_noise(&mut measured, seed, 1.0);
        remove_samples(&mut measured, seed ^ 1, share);
        let levelled: Levelled = level(&measured, form).unwrap();

        let test = polynomial(grid, degree, seed ^ 2);
        let pairs = levelled.heights().as_slice().iter().zip(test.as_slice());
        let overlap: f64 = pairs.filter(|(z, _)| !z.is_nan()).map(|(z, p)| z * p).sum();
        prop_assert!(overlap.abs() < 1e-13 * grid.cells() as f64, "{overlap:e}");

        let again = level(levelled.heights(), form).unwrap();
        prop_assert!(difference(again.heights(), levelled.heights()) < 1e-13);

        let mut bent = measured.clone();
        for (z, p) in bent.as_mut_slice().iter_mut().zip(test.as_slice()) {
            *z += 10.0 * p;
        }
        let straight = level(&bent, form).unwrap();
        prop_assert!(difference(straight.heights(), levelled.heights()) < 1e-12);
    }
}
