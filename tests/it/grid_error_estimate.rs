//! The discretisation error estimated from second differences of a solution agrees with the true error within two
//! fifths.

use kit::smooth::{Smooth, l1_difference};
use kit::unit_bodies;
use stickslip::*;

const OFFSET: [f64; 2] = [0.31, -0.17];

fn bodies(grid: Grid, cell_value: CellValue) -> HalfSpace {
    unit_bodies(grid, 0.0).with_cell_value(cell_value).unwrap()
}

fn press(bodies: &HalfSpace, gap: &Field, load: NormalLoad) -> NormalSolution {
    let problem = NormalProblem::builder(bodies, gap, load).tolerance(1e-6);
    kit::solve(problem)
}

#[test]
fn estimate_for_pressure_is_close_to_error() {
    for cells in [24, 72] {
        let grid = kit::square(cells, 3.0);
        for cell_value in [CellValue::Uniform, CellValue::Centre] {
            let bodies = bodies(grid, cell_value);
            for shape in Smooth::all() {
                let offsets = [[0.12, 0.43], [0.31, -0.17]];
                for &offset in &offsets[..kit::thorough(1, 2)] {
                    let contact = press(&bodies, &shape.gap(grid, offset), shape.load());
                    let exact = shape.mean_pressure(grid, offset);
                    let error = l1_difference(contact.pressure(), &exact, |_| true);
                    let ratio = contact.discretisation_estimate().unwrap() / error;
                    assert!(
                        (0.6..1.4).contains(&ratio),
                        "{} {cells} {cell_value:?} {ratio}",
                        shape.name
                    );
                }
            }
        }
    }
}

/// As the documentation of the estimate requires, there are at least 32 cells over three contact radii. The slip zone is
/// at least one cell wide.
#[test]
fn estimate_for_traction_is_close_to_error() {
    let (parts, coefficient) = (16, 0.5);
    let part = |k: i32| (f64::from(k) + 0.5) / f64::from(parts) - 0.5;
    let places = kit::thorough(
        &[OFFSET][..],
        &[OFFSET, [0.0, 0.0], [0.5, 0.5], [-0.42, 0.48]],
    );
    for &cells in kit::thorough(&[32, 64][..], &[32, 48, 64, 96, 128, 192]) {
        let grid = kit::square(cells, 3.0);
        for shape in Smooth::all() {
            for &load in kit::thorough(&[0.4][..], &[0.1, 0.2, 0.3, 0.4, 0.6, 0.8, 0.9]) {
                let ring = (1.0 - shape.stick_radius(load)) / grid.dx();
                if ring < 1.0 {
                    continue;
                }
                for &[x0, y0] in places {
                    let means = Field::from_fn(grid, |x, y| {
                        let pairs = (0..parts).flat_map(|i| (0..parts).map(move |j| (i, j)));
                        let sum: f64 = pairs
                            .map(|(i, j)| {
                                let x = x + (part(i) - x0) * grid.dx();
                                let y = y + (part(j) - y0) * grid.dy();
                                coefficient * shape.traction_at(load, x, y)
                            })
                            .sum();
                        sum / f64::from(parts * parts)
                    });
                    for (cell_value, range) in [
                        (CellValue::Uniform, 0.85..1.15),
                        (CellValue::Centre, 0.77..1.3),
                    ] {
                        let bodies = bodies(grid, cell_value);
                        let contact = press(&bodies, &shape.gap(grid, [x0, y0]), shape.load());
                        let force = load * coefficient * shape.force;
                        let force = TangentialLoad::force([force, 0.0]);
                        let problem = TangentialProblem::builder(
                            &bodies,
                            &contact,
                            kit::coulomb(coefficient),
                            force,
                        );
                        let shear = kit::solve(problem.tolerance(1e-6));
                        let error = l1_difference(shear.traction()[0], &means, |_| true);
                        let ratio = shear.discretisation_estimate().unwrap() / error;
                        assert!(
                            range.contains(&ratio),
                            "{} {cells} {load} {cell_value:?} {ratio}",
                            shape.name
                        );
                    }
                }
            }
        }
    }
}

/// Below 5 % there is no warning. Above 5 % the warning names a grid with an error of about 1 %.
#[test]
fn large_error_gives_warning_with_cells_for_small_error() {
    let warning_of = |cells: usize| {
        let grid = kit::square(cells, 3.0);
        let shape = Smooth::sphere();
        let contact = press(
            &bodies(grid, CellValue::Uniform),
            &shape.gap(grid, [0.0; 2]),
            shape.load(),
        );
        let estimate = contact.discretisation_estimate().unwrap();
        let warning = contact
            .warnings()
            .into_iter()
            .find_map(|warning| match warning {
                Warning::DiscretisationError {
                    per_mille,
                    cells_per_radius,
                    ..
                } => Some((per_mille, cells_per_radius)),
                _ => None,
            });
        (estimate, warning)
    };
    let (estimate, none) = warning_of(16);
    assert!(estimate < 0.05 && none.is_none(), "{estimate}");
    let (estimate, some) = warning_of(8);
    let (per_mille, cells_per_radius) = some.unwrap();
    assert!((per_mille as f64 - 1e3 * estimate).abs() <= 0.5);
    let (needed, _) = warning_of(3 * cells_per_radius);
    assert!(
        (0.007..0.012).contains(&needed),
        "{cells_per_radius} {needed}"
    );
}
