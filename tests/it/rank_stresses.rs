//! Planes below the surface that ranks compute are bitwise identical to the planes of one process.

use std::ops::ControlFlow;

use stickslip::ranks::RankFailure;
use stickslip::subsurface::{Body, Plane, Planes, Stress, Tractions, at_points};
use stickslip::*;

use crate::rank_contacts::{Found, assert_shared, boundaries, by_cell, on_ranks};

const DEPTHS: [f64; 2] = [0.0, 0.3];

/// Returns tractions with discontinuous edges. Some ranks have no tractions.
fn loads(grid: Grid) -> [Field; 3] {
    let end = 0.3 * grid.whole().y(0);
    let at = |p: f64| {
        Field::from_fn(grid, move |x, y| {
            let wave = 1.5 + (3.0 * x + p).sin() * (2.0 * y).cos();
            if y < end { 0.0 } else { p * wave }
        })
    };
    [at(1.0), at(0.3), at(-0.2)]
}

/// Interleaves all stresses of a plane, and its displacements if there are any, cell by cell.
fn cells_of(plane: &Plane) -> Vec<f64> {
    let ([xx, yy, zz], [xy, xz, yz]) = (plane.normal_stress(), plane.shear_stress());
    match plane.displacement() {
        Some([x, y, z]) => by_cell([xx, yy, zz, xy, xz, yz, x, y, z]),
        None => by_cell([xx, yy, zz, xy, xz, yz]),
    }
}

/// Computes the stresses of a plane under pressure alone. Then computes them in the same memory with tractions and a
/// uniform stress, for this plane alone and together with the other depths.
fn solved(bodies: &HalfSpace, index: usize, moves: bool) -> Found {
    let [p, qx, qy] = loads(bodies.grid());
    let bulk = Stress {
        xx: 0.5,
        ..Stress::default()
    };
    let sheared = Tractions::new(&p)
        .with_traction([&qx, &qy])
        .with_uniform_stress(bulk);
    let mut planes = Planes::new(bodies, &DEPTHS).unwrap();
    if moves {
        planes = planes.with_displacements();
    }
    let pressed = planes.solve(index, Body::One, Tractions::new(&p)).unwrap();
    let mut plane = pressed.clone();
    planes
        .solve_into(index, Body::One, sheared, &mut plane)
        .unwrap();
    let mut visited = 0;
    let visit = |among: &Plane| {
        assert!(visited != index || *among == plane);
        visited += 1;
        Ok(())
    };
    planes.through(Body::One, sheared, visit).unwrap();
    let both = cells_of(&pressed).into_iter().zip(cells_of(&plane));
    let cells = both.flat_map(|(pressed, sheared)| [pressed, sheared]);
    (cells.collect(), vec![plane.warnings().len() as f64])
}

#[test]
fn planes_on_ranks_match_one_process() {
    // Slabs have several rows, or none.
    for grid in [
        Grid::new(24, kit::thorough(180, 400), 0.5, 0.7).unwrap(),
        Grid::new(40, 1, 0.5, 0.7).unwrap(),
    ] {
        // Kernels of periodic rows are sums over many images. Except in the thorough run they are used only for a
        // single row.
        let count = if grid.ny() > 1 {
            kit::thorough(2, 3)
        } else {
            3
        };
        for (index, boundary) in boundaries(grid).into_iter().take(count).enumerate() {
            assert_shared(grid, boundary, |bodies| {
                solved(bodies, index % 2, index > 0)
            });
        }
    }
}

/// All ranks return an error if inputs differ between ranks, if the observer of the first rank cancels, or if a
/// function does not support ranks.
#[test]
fn ranks_reject_together() {
    let grid = Grid::new(64, 130, 0.5, 0.5).unwrap();
    on_ranks(3, grid, Boundary::NonPeriodic, |bodies, rank| {
        let is_first = rank == 0;
        let [p, qx, qy] = loads(bodies.grid());
        let different = |name| Some(Error::Ranks(RankFailure::InconsistentInput(name)));
        let depths = [if is_first { 0.5 } else { 0.6 }];
        assert_eq!(Planes::new(bodies, &depths).err(), different("depths"));
        let mut planes = Planes::new(bodies, &DEPTHS).unwrap();
        let mut own = Tractions::new(&p);
        if is_first {
            own = own.with_traction([&qx, &qy]);
        }
        let outcome = planes.solve(0, Body::One, own);
        assert_eq!(outcome.err(), different("tractions"));
        kit::assert_refused! {
            planes.through(Body::One, Tractions::new(&p), |_| { if is_first { Err(Error::EmptyPath) } else { Ok(()) } })
                => _,
        }
        for asked in [0, 2] {
            let mut asked_so_far = 0;
            let outcome = planes.solve_observed(1, Body::One, Tractions::new(&p), |_| {
                asked_so_far += 1;
                if is_first && asked_so_far > asked {
                    ControlFlow::Break(())
                } else {
                    ControlFlow::Continue(())
                }
            });
            kit::assert_refused! { outcome => Error::NotConverged(_) }
        }
        planes.solve(1, Body::One, Tractions::new(&p)).unwrap();
        let not_shared = |outcome: Result<()>| {
            let is_reported = matches!(
                outcome,
                Err(Error::Ranks(RankFailure::UnsupportedOnRanks(_)))
            );
            assert!(is_reported, "{outcome:?}");
        };
        not_shared(at_points(bodies, Body::One, Tractions::new(&p), &[[0.0; 3]]).map(drop));
        let path = std::env::temp_dir().join("stickslip_stresses_of_ranks.vti");
        not_shared(planes.write_vti(path, Body::One, Tractions::new(&p)));
    });
}
