//! Surface shapes touch at zero, have the requested curvature and can be added.

use approx::assert_relative_eq;
use stickslip::surface::{
    bisinusoidal, cone, cylinder, ellipsoid, flat_punch, paraboloid, sinusoidal, sphere, sum,
};
use stickslip::{Error, Field, Grid, Result};

/// Returns a grid with odd numbers of cells, so that the origin is the centre of a cell.
fn grid() -> Grid {
    Grid::new(41, 33, 0.1, 0.15).unwrap()
}

fn all_equal(a: &Field, b: &Field) {
    assert_eq!(a.grid(), b.grid());
    for (a, b) in a.as_slice().iter().zip(b.as_slice()) {
        assert_relative_eq!(a, b, max_relative = 1e-12, epsilon = 1e-14);
    }
}

#[test]
fn shapes_touch_at_origin_without_overlap() {
    let grid = grid();
    for shape in [
        sphere(grid, 3.0),
        ellipsoid(grid, 3.0, 5.0),
        cylinder(grid, 3.0),
        paraboloid(grid, [0.3, 0.1, 0.2]),
        cone(grid, 0.2),
        flat_punch(grid, 1.0, 0.5),
        sinusoidal(grid, 0.1, 1.3),
        bisinusoidal(grid, 0.1, [1.3, 0.7]),
    ] {
        let shape = shape.unwrap();
        assert_eq!(shape.grid(), grid);
        assert_eq!(shape.min(), 0.0);
        assert_eq!(shape.get(20, 16), Some(0.0));
        assert!(shape.max() > 0.0 && shape.max().is_finite());
    }
}

/// A wave of one cell would be a flat gap.
#[test]
fn waves_shorter_than_two_cells_are_rejected() {
    let grid = grid();
    let refused = |shape: Result<Field>, quantity: &'static str, least: f64, value: f64| {
        let error = shape.unwrap_err();
        let expected = Error::BelowMinimum {
            quantity,
            value,
            least_is: "two cells",
            least,
        };
        assert_eq!(error, expected);
    };
    for short in [0.1, 0.15, 0.199] {
        refused(sinusoidal(grid, 1.0, short), "wavelength", 0.2, short);
        let across = bisinusoidal(grid, 1.0, [short, 1.0]);
        refused(across, "wavelength along x", 0.2, short);
        let along = bisinusoidal(grid, 1.0, [1.0, 1.4 * short]);
        refused(along, "wavelength along y", 0.3, 1.4 * short);
    }
    // The wave of two cells is accepted within round-off, and a single row does not resolve a wave across it.
    assert!(sinusoidal(grid, 1.0, 0.2 * (1.0 - 1e-12)).is_ok());
    let line = Grid::line(20, 0.1).unwrap();
    assert!(bisinusoidal(line, 1.0, [1.0, 1e-3]).is_ok());
}

#[test]
fn shapes_match_formulas() {
    let grid = grid();
    let at = |field: &Field, ix, iy| field.get(ix, iy).unwrap();
    // The cell 10 columns to the right of the middle and 4 rows above it is at x = 1, y = 0.6.
    let [x, y] = grid.position(30, 20);
    assert_relative_eq!(x, 1.0, max_relative = 1e-12);
    assert_relative_eq!(y, 0.6, max_relative = 1e-12);
    let value = |field: Result<Field>| at(&field.unwrap(), 30, 20);
    assert_relative_eq!(value(cylinder(grid, 4.0)), 0.125, max_relative = 1e-12);
    assert_relative_eq!(
        value(paraboloid(grid, [0.3, 0.1, 0.2])),
        0.5 * (0.3 + 2.0 * 0.1 * 0.6 + 0.2 * 0.36),
        max_relative = 1e-12
    );
    assert_relative_eq!(
        value(cone(grid, 0.2)),
        0.2 * 1.36_f64.sqrt(),
        max_relative = 1e-12
    );
    // A straight wave has its trough half a period away. A wave in both directions has a trough half a period away
    // along one axis, but not along both.
    assert_relative_eq!(value(sinusoidal(grid, 0.1, 2.0)), 0.2, max_relative = 1e-12);
    let both = bisinusoidal(grid, 0.1, [2.0, 1.2]).unwrap();
    assert!(at(&both, 30, 20).abs() < 1e-15);
    assert_relative_eq!(at(&both, 30, 16), 0.2, max_relative = 1e-12);
    assert_relative_eq!(at(&both, 20, 20), 0.2, max_relative = 1e-12);
    // A quarter of a period away along one axis, the height is the mean.
    assert_relative_eq!(at(&both, 25, 20), 0.1, max_relative = 1e-12);

    let punch = flat_punch(grid, 1.0, 0.5).unwrap();
    for iy in 0..grid.ny() {
        for ix in 0..grid.nx() {
            let [x, y] = grid.position(ix, iy);
            let is_under = x * x + y * y <= 1.0;
            assert_eq!(at(&punch, ix, iy), if is_under { 0.0 } else { 0.5 });
        }
    }
    assert_eq!(at(&punch, 30, 16), 0.0, "the rim must belong to the punch");
}

#[test]
fn curvatures_rotate_and_add() {
    let grid = grid();
    let (one, two) = (0.4, 0.1);
    let turned = |angle: f64| {
        let (s, c) = angle.sin_cos();
        let xx = one * c * c + two * s * s;
        let yy = one * s * s + two * c * c;
        paraboloid(grid, [xx, (one - two) * s * c, yy]).unwrap()
    };
    all_equal(
        &turned(0.0),
        &ellipsoid(grid, 1.0 / one, 1.0 / two).unwrap(),
    );
    // Rotated by 30 degrees, the shape is the original shape in rotated coordinates.
    let (s, c) = 30_f64.to_radians().sin_cos();
    let expected = Field::from_fn(grid, |x, y| {
        let (along, across) = (c * x + s * y, c * y - s * x);
        0.5 * (one * along * along + two * across * across)
    });
    all_equal(&turned(30_f64.to_radians()), &expected);

    // Two crossed cylinders of the same radius form a sphere at any angle.
    for angle in [0.0, 0.3, 1.0, 2.0] {
        let along = |angle: f64| {
            let (s, c) = angle.sin_cos();
            paraboloid(grid, [c * c / 3.0, s * c / 3.0, s * s / 3.0]).unwrap()
        };
        let crossed = [along(angle), along(angle + 0.5 * std::f64::consts::PI)];
        let sum = sum(&[&crossed[0], &crossed[1]]).unwrap();
        all_equal(&sum, &sphere(grid, 3.0).unwrap());
    }
    let alone = cone(grid, 0.2).unwrap();
    assert_eq!(sum(&[&alone]).unwrap(), alone);
}

#[test]
fn invalid_input_is_rejected() {
    let grid = grid();
    for saddle in [[1.0, 0.0, -1e-6], [1.0, 1.01, 1.0], [-1.0, 0.0, -1.0]] {
        kit::assert_refused! { paraboloid(grid, saddle) => Error::NegativeOrNotFinite { value, .. } if value < 0.0 }
    }
    assert_eq!(paraboloid(grid, [0.0; 3]).unwrap(), Field::zeros(grid));

    // A punch between four cell centres may contain no cell centre.
    let even = kit::square(4, 4.0);
    kit::assert_refused! { flat_punch(even, 0.7, 1.0) => Error::NotPositive { value: 0.0, .. } }
    assert!(flat_punch(even, 0.71, 1.0).is_ok());

    let ball = sphere(grid, 1.0).unwrap();
    let other = sphere(even, 1.0).unwrap();
    kit::assert_refused! {
        sum(&[&ball, &other]) => Error::GridMismatch { .. },
        sum(&[]) => Error::Length { expected: 1, found: 0, .. },
    }
}
