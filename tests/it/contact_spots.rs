//! Areas, loads and positions of contact spots agree with the contact that they partition.

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::Arc;
use std::sync::atomic::Ordering::Relaxed;

use stickslip::analytical::HertzSphere;
use stickslip::ranks::{Ranks, Threads};
use stickslip::surface::SelfAffine;
use stickslip::{
    Boundary, CellValue, Error, Field, Grid, HalfSpace, History, LoadStep, NormalLoad,
    NormalProblem, NormalSolution, TangentialLoad, TangentialProblem, Zone,
};

use crate::distributed_io_is_atomic::LostRank;
use crate::rank_contacts::{PATIENCE, ranks};

fn press(bodies: &HalfSpace, gap: &Field, force: f64) -> NormalSolution {
    let problem = NormalProblem::builder(bodies, gap, NormalLoad::Force(force));
    kit::solve(problem)
}

/// Two balls are so far apart that each ball displaces the surface under the other ball nearly uniformly. Under the
/// load of its spot, each ball has the contact area of Hertz. The area from counting cells has an error of several
/// per cent.
#[test]
fn spot_areas_from_fitted_edges_match_hertz() {
    let grid = Grid::new(128, 40, 0.1, 0.1).unwrap();
    let pair = kit::unit_pair(0.0);
    let bodies = HalfSpace::new(grid, pair).unwrap();
    let bodies = bodies.with_cell_value(CellValue::Centre).unwrap();
    let radii = [1.0, 1.5];
    let ball = |x: f64, y: f64, radius: f64| (x * x + y * y) / (2.0 * radius);
    let gap = Field::from_fn(grid, |x, y| {
        ball(x + 3.93, y - 0.02, radii[0]).min(ball(x - 3.96, y + 0.03, radii[1]) + 0.1)
    });
    let contact = press(&bodies, &gap, 2.0);
    let (spots, edges) = (contact.spots().unwrap(), contact.edges().unwrap());
    let areas = edges.areas_of(&spots).unwrap();
    assert_eq!(areas.len(), 2);
    for (spot, area) in spots.as_slice().iter().zip(&areas) {
        let radius = radii[usize::from(spot.centroid[0] > 0.0)];
        let hertz = HertzSphere::new(&pair, radius, spot.load).unwrap();
        let [counted, found] = [spot.area, *area].map(|area| area / hertz.contact_area() - 1.0);
        assert!(
            found.abs() < 2e-3 && counted.abs() > 5e-3,
            "{counted} {found}"
        );
    }
    assert!((areas.iter().sum::<f64>() / edges.area() - 1.0).abs() < 1e-12);

    let other = HalfSpace::new(kit::square(40, 4.0), pair).unwrap();
    let gap = kit::sphere(other.grid(), 1.0);
    kit::assert_refused! { edges.areas_of(&press(&other, &gap, 0.5).spots().unwrap()) => Error::GridMismatch { .. } }
}

#[test]
fn spots_of_rough_contact_partition_area_and_load() {
    for boundary in [Boundary::NonPeriodic, Boundary::Periodic] {
        let grid = kit::square(64, 64.0);
        let bodies = HalfSpace::with_boundary(grid, kit::unit_pair(0.3), boundary).unwrap();
        let contact = press(&bodies, &kit::rough(grid, 5), 60.0);
        let friction = kit::coulomb(0.4);
        let load = TangentialLoad::force([12.0, 0.0]);
        let shear = TangentialProblem::builder(&bodies, &contact, friction.clone(), load);
        let shear = kit::solve(shear);
        let spots = shear.spots(&contact).unwrap();
        let all = spots.as_slice();
        assert!(all.len() > 5);
        let sum = |f: &dyn Fn(&stickslip::Spot) -> f64| all.iter().map(f).sum::<f64>();
        assert!((sum(&|spot| spot.load) / contact.force() - 1.0).abs() < 1e-12);
        assert!((sum(&|spot| spot.area) / contact.contact_area() - 1.0).abs() < 1e-12);
        let stick = sum(&|spot| spot.stick_ratio.unwrap() * spot.area);
        assert!((stick / shear.stick_area() - 1.0).abs() < 1e-12);
        let edges = shear.edges(&contact, &friction).unwrap();
        for (edges, area) in [
            (edges.contact(), edges.contact().area()),
            (edges.stick(), edges.stick().area()),
        ] {
            let areas = edges.areas_of(&spots).unwrap();
            assert_eq!(areas.len(), all.len());
            assert!((areas.iter().sum::<f64>() / area - 1.0).abs() < 1e-12);
        }
        let largest = all.iter().map(|spot| spot.max_pressure).fold(0.0, f64::max);
        assert_eq!(largest, contact.pressure().max());
        for spot in all {
            assert!((spot.mean_pressure - spot.load / spot.area).abs() <= 1e-12 * spot.load);
            assert!(spot.mean_pressure <= spot.max_pressure * (1.0 + 1e-12));
            // No perimeter is shorter than the perimeter of a circle of the same area.
            assert!(spot.perimeter >= (4.0 * std::f64::consts::PI * spot.area).sqrt());
        }
        // Each label is the number of a spot, and adjacent contact cells have the same label.
        for (cell, zone) in shear.zones().iter().enumerate() {
            assert_eq!(spots.label(cell).is_some(), *zone != Zone::Separated);
        }
        for (number, spot) in all.iter().enumerate() {
            let cells = spots
                .labels()
                .iter()
                .filter(|label| **label as usize == number + 1);
            assert_eq!(cells.count(), spot.cells);
        }
        for cell in 0..grid.cells() - 1 {
            if cell % 64 < 63 {
                if let (Some(one), Some(two)) = (spots.label(cell), spots.label(cell + 1)) {
                    assert_eq!(one, two);
                }
            }
        }
        assert_eq!(contact.spots().unwrap().as_slice()[0].stick_ratio, None);
        assert_eq!(spots.label(grid.cells()), None);
    }
}

/// The contact of a ball at the corner of a periodic grid is a single spot.
#[test]
fn spot_across_periodic_edges_is_single() {
    let grid = Grid::new(40, 32, 0.5, 0.5).unwrap();
    let bodies = HalfSpace::with_boundary(grid, kit::unit_pair(0.3), Boundary::Periodic).unwrap();
    // The period is 20 by 16. The ball is pressed at (9, -7), near a corner.
    let gap = Field::from_fn(grid, |x, y| {
        let near = |x: f64, centre: f64, period: f64| {
            (x - centre - period * ((x - centre) / period).round()).powi(2)
        };
        (near(x, 9.0, 20.0) + near(y, -7.0, 16.0)) / 20.0
    });
    let contact = press(&bodies, &gap, 2.0);
    let spots = contact.spots().unwrap();
    let [spot] = spots.as_slice() else {
        panic!("{} spots", spots.as_slice().len());
    };
    let [x, y] = spot.centroid;
    assert!((x - 9.0).abs() < 0.1 && (y + 7.0).abs() < 0.1, "{x} {y}");
    // The perimeter, measured by the sides of the cells of a disc, equals the perimeter of the circumscribed square.
    let width = contact.contact_extent().unwrap();
    assert!((spot.perimeter - 2.0 * (width[0] + width[1])).abs() < 1e-9);
}

/// Covers spots of pressures, tractions and histories that extend across the boundaries of slabs. Every rank obtains
/// all spots, bitwise identical to the result of one process, and the labels of its local cells.
#[test]
fn spots_on_ranks_are_bitwise_identical() {
    let grid = Grid::new(96, 350, 0.5, 0.5).unwrap();
    for boundary in [Boundary::NonPeriodic, Boundary::Periodic] {
        let made = |bodies: &HalfSpace| {
            let heights = SelfAffine::with_rms_height(3.0).generate_on(bodies);
            let heights = heights.unwrap();
            let highest = bodies.max_of(&heights).unwrap();
            let gap = heights.map(|z| highest - z);
            let contact = press(bodies, &gap, 60.0);
            let problem = NormalProblem::builder(bodies, &gap, NormalLoad::Force(60.0));
            let unsolved = kit::solver(problem).new_solution();
            assert_eq!(
                (
                    unsolved.contact_cells(),
                    unsolved.spots().unwrap().largest()
                ),
                (0, None)
            );
            let friction = kit::coulomb(0.4);
            let load = TangentialLoad::force([12.0, 0.0]);
            let shear = TangentialProblem::builder(bodies, &contact, friction.clone(), load);
            let shear = kit::solve(shear);
            let mut history = History::builder(bodies, &gap, friction).build().unwrap();
            let step = LoadStep::force([8.0, 0.0]).normal(NormalLoad::Force(40.0));
            history.step(&step).unwrap();
            let sheared = shear.spots(&contact).unwrap();
            [contact.spots().unwrap(), sheared, history.spots().unwrap()]
        };
        let alone = HalfSpace::with_boundary(grid, kit::unit_pair(0.3), boundary).unwrap();
        let expected = made(&alone);
        for &size in ranks() {
            let slabs = Threads::run(size, PATIENCE, |rank| {
                let (pair, rank) = (kit::unit_pair(0.3), Arc::new(rank) as Arc<dyn Ranks>);
                made(&HalfSpace::distributed(grid, pair, boundary, rank).unwrap())
            });
            for (place, whole) in expected.iter().enumerate() {
                let slabs = slabs.iter().map(|slabs| &slabs[place]);
                assert!(
                    slabs
                        .clone()
                        .all(|slab| slab.as_slice() == whole.as_slice())
                );
                let labels: Vec<u32> = slabs.flat_map(|slab| slab.labels().to_vec()).collect();
                assert_eq!(labels, whole.labels());
                let count = whole.as_slice().len();
                assert!(count > 20, "{count} spots");
            }
        }
    }
}

/// If a rank is lost at any time during the search for spots, the other ranks return an error.
#[test]
fn spots_with_a_lost_rank_return_an_error() {
    let grid = Grid::new(64, 200, 0.5, 0.5).unwrap();
    let found_until = |calls: usize| {
        Threads::run(3, PATIENCE, |rank| {
            let is_lost = rank.rank() == 1;
            let ranks = Arc::new(LostRank {
                rank,
                calls_left: usize::MAX.into(),
            });
            let (pair, shared) = (kit::unit_pair(0.3), Arc::clone(&ranks) as Arc<dyn Ranks>);
            let bodies = HalfSpace::distributed(grid, pair, Boundary::Periodic, shared).unwrap();
            let ball = kit::sphere(bodies.grid(), 40.0);
            let contact = press(&bodies, &ball, 20.0);
            let calls = if is_lost { calls } else { usize::MAX };
            ranks.calls_left.store(calls, Relaxed);
            let spots = catch_unwind(AssertUnwindSafe(|| contact.spots()));
            (spots.ok(), calls - ranks.calls_left.load(Relaxed))
        })
    };
    let whole = found_until(usize::MAX);
    for calls in (0..whole[1].1).step_by(kit::thorough(3, 1)) {
        let found = found_until(calls);
        assert_eq!(found[1].0, None);
        for rank in [0, 2] {
            match &found[rank].0 {
                Some(Err(Error::Ranks(_))) => {}
                // The other rank may only have needed the last messages of the lost rank.
                spots => assert!(*spots == whole[rank].0 && calls + 2 > whole[1].1),
            }
        }
    }
}

#[test]
fn spots_of_history_include_stick_ratio() {
    let grid = kit::square(32, 12.0);
    let bodies = kit::unit_bodies(grid, 0.3);
    let mut history = History::builder(&bodies, kit::sphere(grid, 20.0), kit::coulomb(0.4))
        .build()
        .unwrap();
    assert_eq!(history.spots().unwrap().largest(), None);
    history
        .step(&LoadStep::hold().normal(NormalLoad::Force(4.0)))
        .unwrap();
    history.step(&LoadStep::force([1.0, 0.0])).unwrap();
    let spots = history.spots().unwrap();
    let spot = spots.largest().unwrap();
    assert_eq!(
        spot.stick_ratio,
        Some(history.last_step().unwrap().stick_ratio())
    );
    assert!(spot.centroid[0].abs() < 1e-9 && spot.centroid[1].abs() < 1e-9);
}
