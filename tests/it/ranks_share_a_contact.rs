//! Contacts shared by ranks have the bits of those of one process.

use std::ops::ControlFlow;
use std::sync::Arc;
use std::time::Duration;

use proptest::prelude::*;
use stickslip::influence::Component;
use stickslip::ranks::{RankFailure, Ranks, Threads};
use stickslip::surface::SelfAffine;
use stickslip::*;

/// Longer than any step takes, even where many tests run at once.
const PATIENCE: Duration = Duration::from_secs(120);

/// Ranks of which some have little or nothing to do.
const RANKS: [usize; 4] = [2, 3, 4, 7];

fn pair() -> ElasticPair {
    ElasticPair::new(Material::new(1.0, 0.3).unwrap(), Material::rigid()).unwrap()
}

/// What every rank finds on its slab, one behind the other.
fn on_ranks(
    size: usize,
    grid: Grid,
    boundary: Boundary,
    find: impl Fn(&HalfSpace) -> Vec<f64> + Sync,
) -> Vec<f64> {
    let parts = Threads::run(size, PATIENCE, |rank| {
        let bodies = HalfSpace::distributed(grid, pair(), boundary, Arc::new(rank)).unwrap();
        find(&bodies)
    });
    parts.concat()
}

/// `Ok` if both have the same bits.
fn same(found: &[f64], expected: &[f64]) -> Result<(), TestCaseError> {
    prop_assert_eq!(found.len(), expected.len());
    for (i, (a, b)) in found.iter().zip(expected).enumerate() {
        prop_assert!(
            a.to_bits() == b.to_bits(),
            "number {} is {} and {}",
            i,
            a,
            b
        );
    }
    Ok(())
}

fn boundaries(grid: Grid) -> [Boundary; 3] {
    let datum = 4.0 * grid.dx() * grid.nx() as f64;
    [
        Boundary::NonPeriodic,
        Boundary::Periodic,
        Boundary::PeriodicAlongY { datum },
    ]
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    /// Transforms of rows and columns are the same wherever they are done, of any size, with rows without traction too.
    #[test]
    fn products_have_the_same_bits(
        nx in 1_usize..130,
        ny in 1_usize..330,
        of in 0_usize..3,
        size in 2_usize..8,
        last in 0.0_f64..1.0,
    ) {
        let grid = Grid::new(nx, ny, 0.5, 0.7).unwrap();
        let boundary = boundaries(grid)[of];
        let products = |bodies: &HalfSpace| {
            let grid = bodies.grid();
            let end = grid.y(0) - grid.y(grid.whole().ny()).abs() * last;
            let traction = Field::from_fn(grid, |x, y| {
                if y < end { 0.0 } else { (3.0 * x).sin() + (5.0 * y).cos() }
            });
            let operator = bodies.operator(Component::ZZ).unwrap();
            let mut workspace = operator.workspace();
            let mut found = Vec::new();
            for _ in 0..2 {
                let mut exact = Field::zeros(grid);
                let mut rough = Field::zeros(grid);
                operator.apply([traction.as_slice()], [exact.as_mut_slice()], &mut workspace);
                operator.apply_f32([traction.as_slice()], [rough.as_mut_slice()], &mut workspace);
                for (exact, rough) in exact.rows().zip(rough.rows()) {
                    found.extend_from_slice(exact);
                    found.extend_from_slice(rough);
                }
            }
            found.truncate(2 * grid.cells());
            found
        };
        let bodies = HalfSpace::with_boundary(grid, pair(), boundary).unwrap();
        same(&on_ranks(size, grid, boundary, products), &products(&bodies))?;
    }
}

/// Heights of a body over the plane, as a function of the place.
type Gap<'a> = &'a (dyn Fn(f64, f64) -> f64 + Sync);

/// A ball, one beside the middle that touches few rows, and waves that touch everywhere.
const GAPS: [fn(f64, f64) -> f64; 3] = [
    |x, y| 0.05 * (x * x + y * y),
    |x, y| 0.05 * ((x - 5.0).powi(2) + (y + 20.0).powi(2)),
    |x, y| 0.3 * (2.0 + (0.9 * x).sin() * (1.3 * y).cos() + (0.31 * x + 0.17 * y).sin()),
];

fn press(bodies: &HalfSpace, gap: Gap<'_>, load: NormalControl) -> NormalSolution {
    let gap = Field::from_fn(bodies.grid(), gap);
    let problem = NormalProblem::builder(bodies, gap, load).build().unwrap();
    problem.solve().unwrap()
}

/// Samples of the fields in every cell, and numbers that every rank knows.
struct Found {
    cells: Vec<[f64; 7]>,
    known: Vec<f64>,
}

impl Found {
    /// Of a pressed contact.
    fn normal(contact: &NormalSolution) -> Self {
        let pairs = contact
            .pressure()
            .as_slice()
            .iter()
            .zip(contact.gap().as_slice());
        let [mx, my] = contact.moments();
        let report = contact.report();
        let extent = contact.contact_extent().unwrap_or_default();
        Self {
            cells: pairs
                .map(|(p, g)| [*p, *g, 0.0, 0.0, 0.0, 0.0, 0.0])
                .collect(),
            known: vec![
                contact.approach(),
                contact.force(),
                mx,
                my,
                contact.contact_cells() as f64,
                contact.contact_area_corrected(),
                extent[0],
                extent[1],
                contact.warnings().len() as f64,
                report.residual,
                report.energy_error_bound(),
                report.iterations as f64,
                report.double_precision_products as f64,
                report.single_precision_products as f64,
            ],
        }
    }

    /// And of the shear under it.
    fn with_shear(mut self, shear: &TangentialSolution) -> Self {
        let [[qx, qy], [sx, sy]] =
            [shear.traction(), shear.slip()].map(|both| both.map(Field::as_slice));
        for (i, cell) in self.cells.iter_mut().enumerate() {
            let zone = f64::from(shear.zones()[i] as u8);
            cell[2..].copy_from_slice(&[qx[i], qy[i], sx[i], sy[i], zone]);
        }
        let report = shear.report();
        let [[fx, fy], [dx, dy]] = [shear.force(), shear.shift()];
        self.known.extend([
            fx,
            fy,
            dx,
            dy,
            shear.moment(),
            shear.stick_ratio(),
            shear.slip_area(),
            shear.dissipated_energy(),
            report.residual,
            report.energy_error_bound(),
            report.iterations as f64,
        ]);
        self
    }
}

/// Asserts that ranks find what one process finds.
fn assert_same(
    grid: Grid,
    boundary: Boundary,
    what: &str,
    find: impl Fn(&HalfSpace) -> Found + Sync,
) {
    let alone = find(&HalfSpace::with_boundary(grid, pair(), boundary).unwrap());
    for size in RANKS {
        let parts = Threads::run(size, PATIENCE, |rank| {
            find(&HalfSpace::distributed(grid, pair(), boundary, Arc::new(rank)).unwrap())
        });
        let what = format!(
            "{what}, {:?}, {boundary:?}, {size} ranks",
            [grid.nx(), grid.ny()]
        );
        for part in &parts {
            same(&part.known, &alone.known).unwrap_or_else(|error| panic!("{what}: known {error}"));
        }
        let cells: Vec<[f64; 7]> = parts.into_iter().flat_map(|part| part.cells).collect();
        let (cells, alone) = (cells.as_flattened(), alone.cells.as_flattened());
        same(cells, alone).unwrap_or_else(|error| panic!("{what}: {error}"));
    }
}

#[test]
fn normal_contacts_have_the_same_bits() {
    for [nx, ny] in [[96, 130], [33, 320]] {
        let grid = Grid::new(nx, ny, 0.3, 0.2).unwrap();
        for boundary in boundaries(grid) {
            for gap in GAPS {
                assert_same(grid, boundary, "a force", |bodies| {
                    Found::normal(&press(bodies, &gap, NormalControl::Force(20.0)))
                });
            }
        }
        assert_same(grid, Boundary::NonPeriodic, "an approach", |bodies| {
            Found::normal(&press(bodies, &GAPS[0], NormalControl::Approach(0.3)))
        });
    }
}

#[test]
fn sheared_contacts_have_the_same_bits() {
    let slanting =
        |grid| Friction::per_cell(Field::from_fn(grid, |x, y| 0.3 + 0.01 * (x + y).sin())).unwrap();
    for [nx, ny] in [[96, 130]] {
        let grid = Grid::new(nx, ny, 0.3, 0.2).unwrap();
        for gap in GAPS {
            for (model, load) in [
                (TangentialModel::Scalar, TangentialLoad::force([3.0, 0.0])),
                (TangentialModel::Vector, TangentialLoad::force([2.0, 2.5])),
            ] {
                let find = |bodies: &HalfSpace| {
                    let normal = press(bodies, &gap, NormalControl::Force(20.0));
                    let problem =
                        TangentialProblem::builder(bodies, &normal, slanting(bodies.grid()), load);
                    let shear = problem.model(model).build().unwrap().solve().unwrap();
                    Found::normal(&normal).with_shear(&shear)
                };
                assert_same(grid, Boundary::NonPeriodic, &format!("{model:?}"), find);
            }
        }
    }
}

/// From the last answer, along its trend, in boxes that are left for wider ones; on small boxes some ranks have no cells.
#[test]
fn solvers_go_on_with_the_same_bits() {
    let grid = Grid::new(96, 130, 0.3, 0.2).unwrap();
    assert_same(grid, Boundary::NonPeriodic, "a sequence", |bodies| {
        let gap = Field::from_fn(bodies.grid(), GAPS[1]);
        let force = NormalControl::Force(0.5);
        let problem = NormalProblem::builder(bodies, gap, force).build().unwrap();
        let mut press = problem.into_solver().unwrap();
        let mut normal = press.new_solution();
        press.solve_into(&mut normal).unwrap();
        let load = TangentialLoad::force([0.03, 0.0]);
        let problem =
            TangentialProblem::builder(bodies, &normal, Friction::coulomb(0.3).unwrap(), load);
        let mut slide = problem.build().unwrap().into_solver().unwrap();
        let mut shear = slide.new_solution();
        for force in [0.52, 0.54, 8.0, 0.5] {
            press.set_load(NormalControl::Force(force)).unwrap();
            press.solve_into(&mut normal).unwrap();
            slide.set_load(TangentialLoad::force([0.0; 2])).unwrap();
            slide.set_pressure(&normal).unwrap();
            slide
                .set_load(TangentialLoad::force([0.1 * force, 0.0]))
                .unwrap();
            slide.solve_into(&mut shear).unwrap();
        }
        Found::normal(&normal).with_shear(&shear)
    });
}

#[test]
fn rough_surfaces_have_the_same_bits() {
    let rough = SelfAffine::with_rms_slope(0.2).seed(3).hurst(0.7);
    for [nx, ny] in [[64, 96], [75, 130]] {
        let grid = Grid::new(nx, ny, 0.5, 0.5).unwrap();
        let heights = |bodies: &HalfSpace| rough.generate_on(bodies).unwrap().into_vec();
        let alone = heights(&HalfSpace::new(grid, pair()).unwrap());
        for size in RANKS {
            same(&on_ranks(size, grid, Boundary::Periodic, heights), &alone).unwrap();
        }
    }
}

/// A rank of which the observer panics, or that comes with another load, or none at all, ends the solve of all.
#[test]
fn a_rank_that_is_lost_ends_all() {
    let grid = Grid::square(128, 8.0).unwrap();
    let solve = |bodies: &HalfSpace, steps: usize| {
        let gap = Field::from_fn(bodies.grid(), |x, y| 0.05 * (x * x + y * y));
        let problem = NormalProblem::builder(bodies, gap, NormalControl::Force(0.5)).build()?;
        let mut solver = problem.into_solver()?;
        let mut contact = solver.new_solution();
        let mut left = steps;
        let ended = solver.solve_observed(&mut contact, |_| {
            left -= 1;
            if left == 0 {
                ControlFlow::Break(())
            } else {
                ControlFlow::Continue(())
            }
        });
        ended.map(|()| contact)
    };
    let outcomes = Threads::run(3, PATIENCE, |rank| {
        let is_last = rank.rank() == 2;
        let bodies = HalfSpace::distributed(grid, pair(), Boundary::NonPeriodic, Arc::new(rank))?;
        // The last rank leaves before the solve.
        if is_last {
            Err(Error::EmptyPath)
        } else {
            solve(&bodies, usize::MAX)
        }
    });
    for outcome in &outcomes[..2] {
        let lost = RankFailure::Lost { rank: 2 };
        assert!(
            matches!(outcome, Err(Error::Ranks(failure)) if *failure == lost),
            "{outcome:?}"
        );
    }

    // Observers of other ranks than the first have no say; that of the first ends the solve of all.
    let limits = |first: usize, others: usize| {
        Threads::run(3, PATIENCE, |rank| {
            let steps = if rank.rank() == 0 { first } else { others };
            let bodies =
                HalfSpace::distributed(grid, pair(), Boundary::NonPeriodic, Arc::new(rank))?;
            solve(&bodies, steps)
        })
    };
    assert!(limits(usize::MAX, 3).iter().all(Result::is_ok));
    for outcome in limits(3, usize::MAX) {
        let Err(Error::NotConverged(report)) = outcome else {
            panic!("{outcome:?}")
        };
        assert_eq!(report.status, Status::Cancelled);
    }
}

#[test]
fn what_one_rank_refuses_all_refuse() {
    let grid = Grid::square(128, 8.0).unwrap();
    let outcomes = Threads::run(3, PATIENCE, |rank| {
        let is_broken = rank.rank() == 1;
        let bodies =
            HalfSpace::distributed(grid, pair(), Boundary::NonPeriodic, Arc::new(rank)).unwrap();
        let gap = Field::from_fn(bodies.grid(), |x, y| {
            if is_broken { f64::NAN } else { x * x + y * y }
        });
        NormalProblem::builder(&bodies, gap, NormalControl::Force(0.5))
            .build()
            .map(drop)
    });
    assert!(
        matches!(outcomes[1], Err(Error::Sample { .. })),
        "{outcomes:?}"
    );
    for rank in [0, 2] {
        let refused = RankFailure::Refused { rank: 1 };
        assert!(
            matches!(outcomes[rank], Err(Error::Ranks(failure)) if failure == refused),
            "{outcomes:?}"
        );
    }
}

/// Ranks that answer too late are given up.
#[test]
fn a_silent_rank_is_given_up() {
    let outcomes = Threads::run(2, Duration::from_millis(50), |rank| {
        if rank.rank() == 1 {
            std::thread::sleep(Duration::from_millis(400));
        }
        rank.swap(vec![1], 1 - rank.rank(), 1 - rank.rank())
    });
    assert!(
        matches!(outcomes[0], Err(RankFailure::Silent { rank: 1, .. })),
        "{outcomes:?}"
    );
}

/// What is sent is what the formula says, and the bits that tell which bands hold anything.
#[test]
fn bytes_are_those_of_the_formula() {
    let n = 256_u64;
    let grid = Grid::square(256, 8.0).unwrap();
    for (boundary, per_cell) in [(Boundary::NonPeriodic, 32), (Boundary::Periodic, 16)] {
        for (size, is_single, rows) in [
            (2, false, 256),
            (4, false, 256),
            (4, true, 256),
            (4, false, 64),
        ] {
            let sent = Threads::run(size, PATIENCE, |rank| {
                let bodies =
                    HalfSpace::distributed(grid, pair(), boundary, Arc::new(rank)).unwrap();
                let operator = bodies.operator(Component::ZZ).unwrap();
                let slab = bodies.grid();
                let traction = Field::from_indices(slab, |_, iy| {
                    if slab.rows().start + iy < rows {
                        1.0
                    } else {
                        0.0
                    }
                });
                let mut out = Field::zeros(slab);
                let before = bodies.traffic().bytes;
                let (x, u) = ([traction.as_slice()], [out.as_mut_slice()]);
                if is_single {
                    operator.apply_f32(x, u, &mut operator.workspace());
                } else {
                    operator.apply(x, u, &mut operator.workspace());
                }
                bodies.traffic().bytes - before
            });
            let sent: u64 = sent.into_iter().sum();
            let ranks = size as u64;
            let all = per_cell * n * n * (ranks - 1) / ranks / if is_single { 2 } else { 1 };
            // Half is sent on the way there, of the rows that hold anything.
            let expected = all / 2 + all / 2 * rows as u64 / n;
            // Columns come in sixteens, one more than half the padded cells, and each rank tells its bands in a word.
            let whole = (sent as f64 / expected as f64 - 1.0).abs();
            assert!(
                whole < 0.13,
                "{size} ranks, {boundary:?}: {sent} for {expected}"
            );
        }
    }
}
