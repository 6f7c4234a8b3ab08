//! Inputs that exceed any memory are rejected before any allocation, with the number of bytes that they would need.

use kit::unit_pair;
use stickslip::cgm::{self, NonNegative, Problem, Settings};
use stickslip::fft::Convolution;
use stickslip::history::LoadPath;
use stickslip::influence::{Component, Table};
use stickslip::surface::{self, SelfAffine};
use stickslip::{Boundary, Error, Field, Grid, HalfSpace, Identity, Result};

/// Returns the number of bytes in the error.
fn bytes<T>(outcome: Result<T>) -> u128 {
    match outcome.map(|_| ()) {
        Err(error @ Error::Memory { bytes, .. }) => {
            let gib = bytes as f64 / f64::from(1 << 30);
            assert!(error.to_string().contains(&format!(" {gib:.1} GiB ")));
            bytes
        }
        other => panic!("{other:?}"),
    }
}

#[test]
fn grid_beyond_index_range_is_rejected() {
    const BILLION: usize = 1_000_000_000;
    let padded = 128 * 1_000_000_000_000_000_000;
    assert_eq!(bytes(Grid::new(BILLION, BILLION, 1.0, 1.0)), padded);
    assert_eq!(bytes(Grid::square(BILLION, 1.0)), padded);
    assert_eq!(
        bytes(Grid::new(usize::MAX, 1, 1.0, 1.0)),
        128 * usize::MAX as u128
    );
    // The grid itself is within the range of an index, but the grid doubled along each axis is not.
    let grid = Grid::new(1 << 28, 1 << 27, 1.0, 1.0).unwrap();
    let cropped = SelfAffine::with_rms_height(1.0).cropped();
    assert_eq!(bytes(cropped.generate(grid)), 128 << 57);
}

/// The grids exceed the memory of any machine, although an index could address them.
#[test]
fn grid_beyond_any_memory_is_rejected() {
    // The time of the search for a fast transform size is proportional to the longer side.
    let [nx, ny] = kit::thorough([1 << 25, 1 << 25], [1 << 28, 1 << 27]);
    let cells = (nx * ny) as u128;
    let grid = Grid::new(nx, ny, 1.0, 1.0).unwrap();
    let pair = unit_pair(0.3);
    for boundary in [Boundary::NonPeriodic, Boundary::Periodic] {
        assert!(bytes(HalfSpace::with_boundary(grid, pair, boundary)) >= 90 * cells);
    }
    assert!(bytes(Convolution::new(grid, &pair, Component::ZZ)) >= 8 * cells);
    assert!(bytes(Table::sample(grid, &pair, Component::XY)) >= 8 * cells);
    assert!(bytes(SelfAffine::with_rms_slope(0.1).generate(grid)) >= 16 * cells);
    for shape in [
        surface::sphere(grid, 1.0),
        surface::ellipsoid(grid, 1.0, 2.0),
        surface::cylinder(grid, 1.0),
        surface::paraboloid(grid, [1.0, 0.0, 1.0]),
        surface::cone(grid, 0.1),
        surface::flat_punch(grid, 1.0, 1.0),
        surface::sinusoidal(grid, 1.0, 4.0),
        surface::bisinusoidal(grid, 1.0, [4.0, 4.0]),
    ] {
        assert_eq!(bytes(shape), 8 * cells);
    }
    let small = Field::zeros(kit::square(4, 1.0));
    let fine = Grid::new(nx, ny, 1e-10, 1e-10).unwrap();
    assert_eq!(bytes(surface::resample(&small, fine)), 8 * cells);
}

#[test]
fn unbounded_paths_and_problems_are_rejected() {
    let steps = usize::MAX - 3;
    let expected = 16 * steps as u128;
    assert_eq!(bytes(LoadPath::sine([1.0, 0.0], steps)), expected);
    assert_eq!(bytes(LoadPath::triangle([1.0, 0.0], steps)), expected);
    assert_eq!(bytes(LoadPath::ellipse([1.0, 2.0], 0.3, steps)), expected);

    // The operator may report any size. The length of the start is also checked.
    let problem = Problem::new(Identity::new(usize::MAX), [&[]], NonNegative);
    kit::assert_refused! { cgm::minimise(&problem, &Settings::default(), [&mut []]) => Error::Length { .. } }
}
