//! A converged solution that may mislead says so, and how.

use stickslip::{
    Boundary, Field, Friction, Grid, HalfSpace, NormalControl, NormalProblem, NormalSolution,
    TangentialLoad, TangentialProblem, Warning, surface,
};

fn press(grid: Grid, boundary: Boundary, gap: &Field) -> (HalfSpace, NormalSolution) {
    let bodies = HalfSpace::with_boundary(grid, kit::unit_pair(0.3), boundary).unwrap();
    let problem = NormalProblem::builder(&bodies, gap, NormalControl::Force(2.0));
    let contact = problem.build().unwrap().solve().unwrap();
    (bodies, contact)
}

fn across(contact: &NormalSolution) -> Option<[bool; 2]> {
    contact.warnings().iter().find_map(|warning| match warning {
        Warning::ContactAcross { along_x, along_y } => Some([*along_x, *along_y]),
        _ => None,
    })
}

/// A cylinder that ends where the grid does has peaks at its ends, here three times the pressure of mid-length.
#[test]
fn a_cylinder_that_ends_with_the_grid() {
    let grid = Grid::new(32, 48, 0.25, 0.25).unwrap();
    let cylinder = surface::cylinder(grid, 20.0).unwrap();
    let (bodies, contact) = press(grid, Boundary::NonPeriodic, &cylinder);
    assert_eq!(across(&contact), Some([false, true]));
    let at = |iy: usize| contact.pressure().get(16, iy).unwrap();
    assert!(at(0) > 1.5 * at(24));
    let friction = Friction::coulomb(0.4).unwrap();
    let load = TangentialLoad::force([0.2, 0.0]);
    let shear = TangentialProblem::builder(&bodies, &contact, friction, load);
    let shear = shear.build().unwrap().solve().unwrap();
    assert_eq!(shear.warnings(), contact.warnings());
    let words = contact
        .warnings()
        .iter()
        .map(ToString::to_string)
        .collect::<String>();
    assert!(words.contains("across the whole grid along y"), "{words}");

    // One that ends before the grid, or goes on for ever, has nothing to be warned of.
    let rising = Field::from_fn(grid, |x, y| {
        x * x / 40.0 + y * y / 2000.0 + (y.abs() - 4.0).max(0.0).powi(2)
    });
    assert_eq!(across(&press(grid, Boundary::NonPeriodic, &rising).1), None);
    assert_eq!(across(&press(grid, Boundary::Periodic, &cylinder).1), None);
    // A rough surface that touches at all edges does so in spots.
    let rough = kit::rough(Grid::square(48, 48.0).unwrap(), 3);
    let (_, contact) = press(rough.grid(), Boundary::NonPeriodic, &rough);
    assert_eq!(across(&contact), None);
}

#[test]
fn a_line_of_cells() {
    for [nx, ny] in [[40, 1], [1, 40]] {
        let grid = Grid::new(nx, ny, 0.25, 0.25).unwrap();
        let gap = Field::from_fn(grid, |x, y| (x * x + y * y) / 40.0);
        let (_, contact) = press(grid, Boundary::NonPeriodic, &gap);
        assert!(contact.warnings().contains(&Warning::LineOfCells));
        let (_, contact) = press(grid, Boundary::Periodic, &gap);
        assert!(!contact.warnings().contains(&Warning::LineOfCells));
    }
    let grid = Grid::square(1, 1.0).unwrap();
    let (_, contact) = press(grid, Boundary::NonPeriodic, &Field::zeros(grid));
    assert!(!contact.warnings().contains(&Warning::LineOfCells));
}
