//! Planes below the surface are solved repeatedly without allocation, and a slab uses no more memory for more depths.

use stickslip::subsurface::{Body, Planes, Tractions};
use stickslip::{Boundary, ElasticPair, Field, Grid, HalfSpace, Material};

/// Measures the number of allocations of `work` on one thread, and its peak number of bytes.
fn measured(mut work: impl FnMut() + Send) -> (u64, u64) {
    let pool = rayon::ThreadPoolBuilder::new()
        .num_threads(1)
        .build()
        .unwrap();
    let info = pool.install(|| allocation_counter::measure(&mut work));
    (info.count_total, info.bytes_max)
}

fn bodies(n: usize, boundary: Boundary) -> (HalfSpace, Field) {
    let grid = Grid::square(n, 1.0).unwrap();
    let body = Material::new(1.0, 0.3).unwrap();
    let pair = ElasticPair::new(body, body).unwrap();
    let pressure = Field::from_fn(grid, |x, y| (0.2 - x * x - y * y).max(0.0));
    (
        HalfSpace::with_boundary(grid, pair, boundary).unwrap(),
        pressure,
    )
}

#[test]
fn reused_plane_is_solved_without_allocation() {
    for boundary in [
        Boundary::NonPeriodic,
        Boundary::Periodic,
        Boundary::PeriodicAlongY { datum: 2.0 },
    ] {
        let (bodies, pressure) = bodies(kit::thorough(40, 96), boundary);
        let shear = pressure.scaled(0.1);
        let tractions = Tractions::new(&pressure).with_traction([&shear, &shear]);
        let mut planes = Planes::new(&bodies, &[0.1, 0.2])
            .unwrap()
            .with_displacements();
        let mut plane = planes.solve(0, Body::One, tractions).unwrap();
        let mut cycle = || {
            for body in [Body::One, Body::Two] {
                for index in [0, 1] {
                    planes
                        .solve_into(index, body, tractions, &mut plane)
                        .unwrap();
                }
            }
        };
        cycle();
        assert_eq!(measured(&mut cycle).0, 0, "{boundary:?}");
    }
}

/// The kernels of a depth use 112 bytes per cell, and 170 bytes during their computation. The kernels of a slab use no
/// more.
#[test]
fn slab_memory_is_independent_of_number_of_depths() {
    let (bodies, pressure) = bodies(kit::thorough(128, 256), Boundary::NonPeriodic);
    let cells = bodies.grid().cells() as u64;
    let of = |count: u32| {
        let depths: Vec<f64> = (1..=count).map(|k| 0.1 * f64::from(k)).collect();
        let mut planes = Planes::new(&bodies, &depths).unwrap();
        let slab = measured(|| {
            let visit = |_: &stickslip::subsurface::Plane| Ok(());
            planes
                .through(Body::One, Tractions::new(&pressure), visit)
                .unwrap();
        });
        let kept = measured(|| {
            for index in 0..depths.len() {
                planes
                    .solve(index, Body::One, Tractions::new(&pressure))
                    .unwrap();
            }
        });
        (slab.1 / cells, kept.1 / cells)
    };
    let (slab_of_two, kept_of_two) = of(2);
    let (slab_of_six, kept_of_six) = of(6);
    assert!(
        slab_of_six <= slab_of_two + 1,
        "{slab_of_two} {slab_of_six}"
    );
    // The bound covers the computation of the kernels and the plane.
    assert!(slab_of_two <= 170 + 48 + 10, "{slab_of_two}");
    let per_depth = (kept_of_six - kept_of_two) / 4;
    assert!((110..=116).contains(&per_depth), "{per_depth}");
}
