//! Contacts distributed over ranks are bitwise identical to contacts solved by one process.

use std::ops::ControlFlow;
use std::sync::{Arc, Barrier};
use std::time::Duration;

use proptest::prelude::*;
use stickslip::cgm::Settings;
use stickslip::influence::Component;
use stickslip::ranks::{RankFailure, Ranks, Threads};
use stickslip::surface::SelfAffine;
use stickslip::*;

/// Timeout that is longer than any step takes, even if many tests run simultaneously.
pub(crate) const PATIENCE: Duration = Duration::from_secs(120);

/// Returns the numbers of ranks, some of which leave ranks with little or no work.
pub(crate) fn ranks() -> &'static [usize] {
    kit::thorough(&[3], &[2, 3, 4, 7])
}

pub(crate) fn pair() -> ElasticPair {
    kit::on_rigid(1.0, 0.3)
}

/// Calls a function on all ranks, with their local bodies and their numbers.
pub(crate) fn on_ranks<T: Send>(
    size: usize,
    grid: Grid,
    boundary: Boundary,
    work: impl Fn(&HalfSpace, usize) -> T + Sync,
) -> Vec<T> {
    Threads::run(size, PATIENCE, |rank| {
        let number = rank.rank();
        work(
            &HalfSpace::distributed(grid, pair(), boundary, Arc::new(rank)).unwrap(),
            number,
        )
    })
}

/// Asserts that one rank rejects its own input with this error, and that all other ranks report this rank.
pub(crate) fn assert_rejected_by(
    rank: usize,
    outcomes: &[Result<()>],
    is_own: impl Fn(&Error) -> bool,
) {
    for (number, outcome) in outcomes.iter().enumerate() {
        let told = Err(Error::Ranks(RankFailure::RejectedByRank { rank }));
        let is_reported = match outcome {
            Err(error) if number == rank => is_own(error),
            other => *other == told,
        };
        assert!(is_reported, "rank {number}: {outcome:?}");
    }
}

/// Returns `Ok` if both slices are bitwise identical.
pub(crate) fn same(found: &[f64], expected: &[f64]) -> Result<(), TestCaseError> {
    prop_assert_eq!(found.len(), expected.len());
    for (i, (a, b)) in found.iter().zip(expected).enumerate() {
        prop_assert!(
            a.to_bits() == b.to_bits(),
            "values at index {} differ: {} and {}",
            i,
            a,
            b
        );
    }
    Ok(())
}

pub(crate) fn boundaries(grid: Grid) -> [Boundary; 3] {
    let datum = 4.0 * grid.dx() * grid.nx() as f64;
    [
        Boundary::NonPeriodic,
        Boundary::Periodic,
        Boundary::PeriodicAlongY { datum },
    ]
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(kit::thorough(3, 12)))]

    /// Transforms of rows and columns do not depend on the rank that computes them. Sizes are arbitrary, and some rows
    /// have no traction.
    #[test]
    fn products_on_ranks_match_one_process(
        nx in 1_usize..130,
        ny in 1_usize..kit::thorough(200, 330),
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
            let mut workspace = operator.scratch().unwrap();
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
        let parts = on_ranks(size, grid, boundary, |bodies, _| products(bodies)).concat();
        same(&parts, &products(&bodies))?;
    }
}

/// Local results of a rank, and results that every rank has.
pub(crate) type Found = (Vec<f64>, Vec<f64>);

/// Asserts that ranks have the results of one process.
pub(crate) fn assert_shared(
    grid: Grid,
    boundary: Boundary,
    find: impl Fn(&HalfSpace) -> Found + Sync,
) {
    let (cells, known) = find(&HalfSpace::with_boundary(grid, pair(), boundary).unwrap());
    for &size in ranks() {
        let parts = on_ranks(size, grid, boundary, |bodies, _| find(bodies));
        for (_, part) in &parts {
            same(part, &known).unwrap();
        }
        let parts: Vec<f64> = parts.into_iter().flat_map(|(cells, _)| cells).collect();
        same(&parts, &cells).unwrap();
    }
}

/// Interleaves the samples of fields, cell by cell.
pub(crate) fn by_cell<const N: usize>(fields: [&Field; N]) -> Vec<f64> {
    let cell = |i: usize| fields.map(|field| field.as_slice()[i]);
    (0..fields[0].grid().cells()).flat_map(cell).collect()
}

/// Solvers continue from the last solution, along the trend of the solutions and in windows that are replaced by
/// larger windows. In small windows some ranks have no cells.
#[test]
fn continued_solves_on_ranks_match_one_process() {
    let grid = Grid::new(96, 130, 0.3, 0.2).unwrap();
    assert_shared(grid, Boundary::NonPeriodic, |bodies| {
        let beside = |x: f64, y: f64| 0.05 * ((x - 5.0).powi(2) + (y + 20.0).powi(2));
        let gap = Field::from_fn(bodies.grid(), beside);
        let force = NormalLoad::Force(0.5);
        let problem = NormalProblem::builder(bodies, gap, force).build().unwrap();
        let mut press = problem.into_solver().unwrap();
        let mut normal = kit::solved(&mut press);
        let load = TangentialLoad::force([0.03, 0.0]);
        let problem = TangentialProblem::builder(bodies, &normal, kit::coulomb(0.3), load);
        let mut slide = kit::solver(problem);
        let mut shear = slide.new_solution();
        for force in [0.52, 0.54, 8.0, 0.5] {
            press.set_load(NormalLoad::Force(force)).unwrap();
            press.solve_into(&mut normal).unwrap();
            slide.set_load(TangentialLoad::force([0.0; 2])).unwrap();
            slide.set_pressure(&normal).unwrap();
            let load = TangentialLoad::force([0.1 * force, 0.0]);
            slide.set_load(load).unwrap();
            slide.solve_into(&mut shear).unwrap();
        }
        let cells = by_cell([
            normal.pressure(),
            normal.gap(),
            shear.traction()[0],
            shear.slip()[0],
        ]);
        let known = vec![
            normal.approach(),
            normal.force(),
            shear.shift()[0],
            shear.report().residual,
        ];
        (cells, known)
    });
}

/// The preconditioner of scattered contacts needs the adjacent rows of other ranks.
#[test]
fn scattered_contacts_on_ranks_match_one_process() {
    let rough = SelfAffine::with_rms_slope(0.3).seed(5);
    let grid = Grid::new(60, 130, 0.5, 0.5).unwrap();
    assert_shared(grid, Boundary::NonPeriodic, |bodies| {
        let gap = rough.generate_on(bodies).unwrap().map(|z| -z);
        let force = 0.01 * bodies.grid().whole().area();
        let problem = NormalProblem::builder(bodies, gap, NormalLoad::Force(force));
        let normal = problem.build().unwrap().solve().unwrap();
        let [scalar, plane] = [TangentialModel::Scalar, TangentialModel::Vector].map(|model| {
            let load = TangentialLoad::force([0.1 * force, 0.0]);
            let problem = TangentialProblem::builder(bodies, &normal, kit::coulomb(0.3), load);
            problem.model(model).build().unwrap().solve().unwrap()
        });
        let cells = by_cell([
            normal.pressure(),
            scalar.traction()[0],
            plane.traction()[0],
            plane.traction()[1],
        ]);
        let share = normal.contact_area() / bodies.grid().whole().area();
        assert!(
            (0.02..0.2).contains(&share),
            "the contact is scattered: {share}"
        );
        (
            cells,
            vec![normal.approach(), scalar.shift()[0], plane.shift()[0]],
        )
    });
}

#[test]
fn rough_surfaces_on_ranks_match_one_process() {
    let rough = SelfAffine::with_rms_slope(0.2).seed(3).hurst(0.7);
    for [nx, ny] in [[64, 96], [75, 130]] {
        let grid = Grid::new(nx, ny, 0.5, 0.5).unwrap();
        let heights = |bodies: &HalfSpace| rough.generate_on(bodies).unwrap().into_vec();
        let alone = heights(&HalfSpace::new(grid, pair()).unwrap());
        for &size in ranks() {
            let parts = on_ranks(size, grid, Boundary::Periodic, |bodies, _| heights(bodies));
            same(&parts.concat(), &alone).unwrap();
        }
    }
}

/// Counts refer to the whole contact, including spots that extend over several slabs or across the edges of the grid.
#[test]
fn every_rank_reports_whole_contact() {
    let rough = SelfAffine::with_rms_slope(0.3).seed(5);
    let boundaries = boundaries(Grid::new(60, 130, 0.5, 0.5).unwrap());
    for &boundary in &boundaries[..kit::thorough(2, 3)] {
        let count = |bodies: &HalfSpace| {
            let gap = rough.generate_on(bodies).unwrap().map(|z| -z);
            let force = NormalLoad::Force(0.03 * bodies.grid().whole().area());
            let problem = NormalProblem::builder(bodies, gap, force).build().unwrap();
            let contact = problem.solve().unwrap();
            let area = (contact.contact_area(), contact.contact_area_corrected());
            let extent = contact.contact_extent();
            (contact.contact_cells(), area, extent, contact.warnings())
        };
        let grid = Grid::new(60, 130, 0.5, 0.5).unwrap();
        let alone = count(&HalfSpace::with_boundary(grid, pair(), boundary).unwrap());
        for &size in ranks() {
            for found in on_ranks(size, grid, boundary, |bodies, _| count(bodies)) {
                assert_eq!(found, alone, "{size} ranks, {boundary:?}");
            }
        }
    }
}

/// Presses a ball with an observer that cancels the solve at its `last` call.
fn press_observed(
    bodies: &HalfSpace,
    settings: Settings,
    last: usize,
) -> Result<NormalSolution, Error> {
    let gap = Field::from_fn(bodies.grid(), |x, y| 0.05 * (x * x + y * y));
    let problem = NormalProblem::builder(bodies, gap, NormalLoad::Force(0.5));
    let mut solver = problem.settings(settings).build()?.into_solver()?;
    let mut contact = solver.new_solution();
    let mut left = last;
    let ended = solver.solve_observed(&mut contact, |_| {
        left -= 1;
        if left == 0 {
            ControlFlow::Break(())
        } else {
            ControlFlow::Continue(())
        }
    });
    ended.map(|()| contact)
}

/// If a rank leaves before the solve, the other ranks end with an error.
#[test]
fn lost_rank_ends_solve_of_all() {
    let outcomes = Threads::run(3, PATIENCE, |rank| {
        let is_last = rank.rank() == 2;
        let bodies = HalfSpace::distributed(
            kit::square(128, 8.0),
            pair(),
            Boundary::NonPeriodic,
            Arc::new(rank),
        )?;
        if is_last {
            Err(Error::EmptyPath)
        } else {
            press_observed(&bodies, Settings::default(), usize::MAX)
        }
    });
    for outcome in &outcomes[..2] {
        let lost = RankFailure::Disconnected { rank: 2 };
        kit::assert_refused! { outcome => Error::Ranks(failure) if *failure == lost }
    }
}

/// Only the observer and the clock of the first rank end the solve of all ranks. Observers and clocks of other ranks
/// have no effect, not even on coarse grids that every rank solves on its own.
#[test]
fn first_rank_decides_for_all() {
    let in_time = Settings::default();
    let late = in_time.time_limit(Duration::ZERO);
    for cells in [128, kit::thorough(520, 600)] {
        let grid = kit::square(cells, 8.0);
        let alone = HalfSpace::new(grid, pair()).unwrap();
        let expected = press_observed(&alone, in_time, usize::MAX).unwrap();
        let on_three = |first: (Settings, usize), others: (Settings, usize)| {
            Threads::run(3, PATIENCE, |rank| {
                let (settings, last) = if rank.rank() == 0 { first } else { others };
                let boundary = Boundary::NonPeriodic;
                let bodies = HalfSpace::distributed(grid, pair(), boundary, Arc::new(rank))?;
                press_observed(&bodies, settings, last)
            })
        };
        for others in [(in_time, 3), (late, usize::MAX)] {
            let found = on_three((in_time, usize::MAX), others);
            let found = found
                .into_iter()
                .map(|part| part.unwrap().pressure().as_slice().to_vec());
            let found: Vec<f64> = found.flatten().collect();
            same(&found, expected.pressure().as_slice()).unwrap();
        }
        for (first, status) in [
            ((in_time, 3), Status::Cancelled),
            ((late, usize::MAX), Status::TimeLimit),
        ] {
            for outcome in on_three(first, (in_time, usize::MAX)) {
                let Err(Error::NotConverged(report)) = outcome else {
                    panic!("{outcome:?}")
                };
                assert_eq!(report.status, status);
            }
        }
    }
}

#[test]
fn invalid_datum_is_rejected_as_on_one_process() {
    let grid = kit::square(64, 8.0);
    for datum in [f64::NAN, 1e-9] {
        let boundary = Boundary::PeriodicAlongY { datum };
        let alone = HalfSpace::with_boundary(grid, pair(), boundary)
            .map(drop)
            .unwrap_err();
        let refused = Threads::run(2, PATIENCE, |rank| {
            HalfSpace::distributed(grid, pair(), boundary, Arc::new(rank)).map(drop)
        });
        for refused in refused {
            assert_eq!(refused.unwrap_err().to_string(), alone.to_string());
        }
    }
}

#[test]
fn input_rejected_by_one_rank_is_rejected_by_all() {
    let outcomes = on_ranks(
        3,
        kit::square(128, 8.0),
        Boundary::NonPeriodic,
        |bodies, rank| {
            let is_broken = rank == 1;
            let gap = Field::from_fn(bodies.grid(), |x, y| {
                if is_broken { f64::NAN } else { x * x + y * y }
            });
            NormalProblem::builder(bodies, gap, NormalLoad::Force(0.5))
                .build()
                .map(drop)
        },
    );
    assert_rejected_by(1, &outcomes, |error| matches!(error, Error::Sample { .. }));
}

/// A rank that does not respond in time is reported.
#[test]
fn silent_rank_is_reported() {
    // The second rank sends nothing before the first rank has reported it, however slow the machine is.
    let has_given_up = Barrier::new(2);
    let outcomes = Threads::run(2, Duration::from_millis(20), |rank| {
        let swap = || rank.swap(vec![1], 1 - rank.rank(), 1 - rank.rank());
        if rank.rank() == 1 {
            has_given_up.wait();
            return swap();
        }
        let outcome = swap();
        has_given_up.wait();
        outcome
    });
    assert!(
        matches!(outcomes[0], Err(RankFailure::Timeout { rank: 1, .. })),
        "{outcomes:?}"
    );
}

/// The number of bytes follows the formula. Each wave has 16 bytes, for half of the columns of the torus plus one, in
/// whole tiles. The forward exchange contains the rows with tractions and one bit for each band of rows. The backward
/// exchange contains all rows. The total is 32 bytes per cell of a free grid and 16 bytes per cell of a periodic grid,
/// minus the local part.
#[test]
fn traffic_matches_formula() {
    let n = 256;
    let grid = kit::square(n, 8.0);
    for (boundary, torus) in [(Boundary::NonPeriodic, 2 * n), (Boundary::Periodic, n)] {
        for (ranks, is_single, rows) in [
            (2, false, n),
            (3, false, n),
            (4, false, n),
            (4, true, n),
            (4, false, 64),
            (4, true, 64),
        ] {
            let sent = on_ranks(ranks, grid, boundary, |bodies, _| {
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
                    operator.apply_f32(x, u, &mut operator.scratch().unwrap());
                } else {
                    operator.apply(x, u, &mut operator.scratch().unwrap());
                }
                (slab.rows(), bodies.traffic().bytes - before)
            });
            // Columns are distributed in groups of 16. A tile has 16 rows and 8 columns in double precision, or 16
            // columns in single precision.
            let (bytes, tile_columns) = if is_single { (8, 16) } else { (16, 8) };
            let width = torus / 2 + 1;
            let first = |rank: usize| (width.div_ceil(16) * rank / ranks * 16).min(width);
            let columns =
                |rank: usize| (first(rank + 1) - first(rank)).next_multiple_of(tile_columns);
            let held = |rows: &std::ops::Range<usize>| rows.len().next_multiple_of(16);
            let mut expected = 0;
            for (rank, (own, _)) in sent.iter().enumerate() {
                let full = own.start.min(rows)..own.end.min(rows);
                let bands = (held(own) / 16).div_ceil(64);
                for other in (0..ranks).filter(|other| *other != rank) {
                    let waves = columns(other) * (held(&full) + held(own));
                    expected += bytes * waves + 8 * bands;
                }
            }
            let sent: u64 = sent.into_iter().map(|(_, bytes)| bytes).sum();
            assert_eq!(
                sent, expected as u64,
                "{ranks} ranks, {boundary:?}, {is_single}"
            );
        }
    }
}

/// The error bound counts the cells of all ranks.
#[test]
fn error_bound_with_spring_matches_one_process() {
    let grid = Grid::new(10, 12, 0.25, 0.25).unwrap();
    let find = |bodies: &HalfSpace| -> Found {
        let ball = Field::from_fn(bodies.grid(), |x, y| 0.25 * (x * x + y * y));
        let force = NormalLoad::Force(0.4);
        let problem = NormalProblem::builder(bodies, &ball, force);
        let normal = kit::solve(problem);
        let mut common = Vec::new();
        for (stiffness, tolerance) in [(1e-3, 0.5), (0.3, 0.5), (30.0, 0.1)] {
            let load = TangentialLoad::spring([0.05 + 0.01 / stiffness, 0.0], stiffness);
            let problem = TangentialProblem::builder(bodies, &normal, kit::coulomb(0.3), load);
            let problem = problem
                .model(TangentialModel::Vector)
                .tolerance(tolerance)
                .build();
            let found = problem.unwrap().solve().unwrap();
            common.extend([found.report().duality_gap, found.report().residual]);
        }
        (Vec::new(), common)
    };
    assert_shared(grid, Boundary::Periodic, find);
}
