//! Comparison with the discrete solution of CONTACT, an independent code with the same elements.

use stickslip::{Field, Grid, HalfSpace, NormalLoad, NormalProblem};

/// The header of the file states the case and its source.
const HERTZ: &str = include_str!("../data/hertz_contact.csv");

#[test]
fn hertz_contact_on_nineteen_cells_matches() {
    let side = 0.133_333_684_210_526_3;
    let grid = Grid::new(19, 19, side, side).unwrap();
    let bodies = HalfSpace::new(grid, kit::alike_in_shear(200.0, 0.42)).unwrap();
    let gap = Field::from_fn(grid, |x, y| 0.01 * x * x + 0.01 * y * y);
    let problem = NormalProblem::builder(&bodies, &gap, NormalLoad::Force(9.1954)).tolerance(1e-12);
    let solution = kit::solve(problem);

    let mut expected = Field::zeros(grid);
    for line in HERTZ.lines().filter(|line| !line.starts_with('#')).skip(1) {
        let columns: Vec<&str> = line.split(',').collect();
        let index = |k: usize| columns[k].parse::<usize>().unwrap() - 1;
        expected.as_mut_slice()[index(1) * 19 + index(0)] = columns[2].parse().unwrap();
    }
    let (found, expected) = (solution.pressure(), expected);
    for (found, expected) in found.as_slice().iter().zip(expected.as_slice()) {
        assert_eq!(*found > 0.0, *expected > 0.0, "contact cells differ");
    }
    let error = kit::max_difference(found.as_slice(), expected.as_slice()) / expected.max();
    assert!(error < 1e-6, "{error:e}");
    assert_eq!(solution.contact_cells(), 177);
    assert!((solution.approach() / 0.01998091354 - 1.0).abs() < 1e-6);
    assert!((found.max() / 4.393028603 - 1.0).abs() < 1e-6);
}
