//! Tests of spots against walks from cell to cell, on one process and on ranks.

use std::collections::HashMap;
use std::sync::Arc;
use std::time::Duration;

use crate::bodies::material::{ElasticPair, Material};
use crate::grid::Grid;
use crate::grid::boundary::Boundary;
use crate::grid::field::Field;
use crate::grid::neighbours::neighbours;
use crate::half_space::HalfSpace;
use crate::normal::NormalSolution;
use crate::numerics::cell_vector::plus;
use crate::parallel::ranks::Threads;
use crate::report::Report;
use crate::spots::{ContactSpots, Spot};
use crate::tangential::Zone;

fn pair() -> ElasticPair {
    ElasticPair::new(Material::new(1.0, 0.3).unwrap(), Material::rigid()).unwrap()
}

/// Returns the spots of a slab with these pressures, in which every third cell sticks.
fn spots(bodies: &HalfSpace, pressure: &[f64]) -> ContactSpots {
    let (grid, gap) = (bodies.grid(), Field::zeros(bodies.grid()));
    let first = grid.rows().start * grid.nx();
    let own = pressure[first..][..grid.cells()].to_vec();
    let zone = |cell| match (first + cell) % 3 {
        0 => Zone::Stick,
        _ => Zone::Slip,
    };
    let zones: Vec<Zone> = (0..grid.cells()).map(zone).collect();
    let fields = [own, vec![0.0; grid.cells()]];
    let normal = NormalSolution::of(bodies, &gap, fields, 0.0, Report::with_room()).unwrap();
    ContactSpots::new(&normal, Some(&zones)).unwrap()
}

/// A spot found by a walk from cell to cell: its cells, with the positions at which the walk reached them.
type Walked = Vec<(usize, [f64; 2])>;

/// Finds the spots by walks, and determines whether each spot closes around the grid.
fn walked(grid: Grid, repeats: [bool; 2], pressure: &[f64]) -> Vec<(Walked, bool)> {
    let mut places: HashMap<usize, [f64; 2]> = HashMap::new();
    let mut found = Vec::new();
    for seed in 0..grid.cells() {
        if pressure[seed] == 0.0 || places.contains_key(&seed) {
            continue;
        }
        let place = [(seed % grid.nx()) as f64, (seed / grid.nx()) as f64];
        places.insert(seed, place);
        let (mut cells, mut done, mut closes) = (vec![(seed, place)], 0, false);
        while let Some(&(cell, place)) = cells.get(done) {
            done += 1;
            let steps = [[-1.0, 0.0], [0.0, -1.0], [1.0, 0.0], [0.0, 1.0]];
            for (next, step) in neighbours(cell, grid.size(), repeats)
                .into_iter()
                .zip(steps)
            {
                let Some(next) = next.filter(|next| pressure[*next] > 0.0) else {
                    continue;
                };
                let reached = plus(place, 1.0, step);
                match places.insert(next, reached) {
                    Some(known) if known.map(f64::to_bits) != reached.map(f64::to_bits) => {
                        closes = true;
                    }
                    Some(_) => {}
                    None => cells.push((next, reached)),
                }
            }
        }
        found.push((cells, closes));
    }
    found
}

fn assert_is_walked(grid: Grid, repeats: [bool; 2], pressure: &[f64], spots: &ContactSpots) {
    let walked = walked(grid, repeats, pressure);
    assert_eq!(spots.as_slice().len(), walked.len());
    for (number, (spot, (cells, closes))) in spots.as_slice().iter().zip(&walked).enumerate() {
        let count = cells.len() as f64;
        let load: f64 = cells.iter().map(|(cell, _)| pressure[*cell]).sum();
        let load = load * grid.cell_area();
        let stick = cells.iter().filter(|(cell, _)| cell % 3 == 0).count();
        let mut sides = 0.0;
        for (cell, _) in cells {
            assert_eq!(spots.label(*cell), Some(number));
            let around = neighbours(*cell, grid.size(), repeats);
            for (next, side) in around.into_iter().zip([grid.dy(), grid.dx()].repeat(2)) {
                let is_open = next.is_none_or(|next| pressure[next] == 0.0);
                sides += if is_open { side } else { 0.0 };
            }
        }
        let Spot {
            load: found,
            perimeter,
            centroid,
            ..
        } = *spot;
        assert_eq!(spot.cells, cells.len());
        assert_eq!(spot.stick_ratio, Some(stick as f64 / count));
        // The rounding error of a sequential sum.
        let rounding = f64::EPSILON * (1.0 + 0.5 * count);
        assert!((found / load - 1.0).abs() < rounding, "{found} {load}");
        assert!((perimeter - sides).abs() <= 1e-12 * sides);
        let periods = [grid.nx() as f64 * grid.dx(), grid.ny() as f64 * grid.dy()];
        for axis in (0..2).filter(|_| !closes) {
            let mean = cells.iter().map(|(_, place)| place[axis]).sum::<f64>() / count;
            let side = [grid.dx(), grid.dy()][axis];
            let middle = 0.5 * (grid.size()[axis] as f64 - 1.0);
            let off = (mean - middle) * side - centroid[axis];
            let off = off - periods[axis] * (off / periods[axis]).round();
            assert!(off.abs() < 1e-12 * periods[axis], "{off}");
        }
    }
}

/// Tests contacts of random cells under random pressures. One process finds the same spots as the walks, also across edges
/// and for spots that close around the grid. Ranks, some of which have few rows or none, find bitwise identical results.
#[test]
fn slabs_have_the_spots_of_the_whole() {
    let mut random = 1_u64;
    let mut next = || {
        random = random
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        (random >> 33) as f64 / (1_u64 << 31) as f64
    };
    // With 1400 columns a rank has at least two rows.
    for (nx, ny) in [
        (1400, 12),
        (2100, 7),
        (70, 300),
        (9, 9),
        (4100, 1),
        (1, 9000),
    ] {
        for share in [0.02, 0.4, 0.62, 0.95] {
            let grid = Grid::new(nx, ny, 0.5, 0.7).unwrap();
            let pressure: Vec<f64> = (0..grid.cells())
                .map(|_| if next() < share { next() + 1e-9 } else { 0.0 })
                .collect();
            let datum = nx as f64;
            for boundary in [
                Boundary::NonPeriodic,
                Boundary::Periodic,
                Boundary::PeriodicAlongY { datum },
            ] {
                let alone = HalfSpace::with_boundary(grid, pair(), boundary).unwrap();
                let whole = spots(&alone, &pressure);
                assert_is_walked(grid, boundary.repeats(), &pressure, &whole);
                for ranks in [1, 2, 3, 4, 7] {
                    let slabs = Threads::run(ranks, Duration::from_secs(60), |rank| {
                        let rank = Arc::new(rank);
                        let bodies = HalfSpace::distributed(grid, pair(), boundary, rank);
                        spots(&bodies.unwrap(), &pressure)
                    });
                    let labels: Vec<u32> = slabs
                        .iter()
                        .flat_map(|slab| slab.labels().to_vec())
                        .collect();
                    assert_eq!(labels, whole.labels());
                    for slab in slabs {
                        assert_eq!(slab.as_slice(), whole.as_slice());
                    }
                }
            }
        }
    }
}
