//! Contacts shared by ranks have the bits of those of one process.

use std::ops::ControlFlow;
use std::sync::Arc;
use std::time::Duration;

use proptest::prelude::*;
use stickslip::cgm::Settings;
use stickslip::influence::Component;
use stickslip::ranks::{RankFailure, Ranks, Threads};
use stickslip::surface::SelfAffine;
use stickslip::*;

/// Longer than any step takes, even where many tests run at once.
pub(crate) const PATIENCE: Duration = Duration::from_secs(120);

/// Ranks of which some have little or nothing to do.
pub(crate) const RANKS: [usize; 4] = [2, 3, 4, 7];

pub(crate) fn pair() -> ElasticPair {
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
pub(crate) fn same(found: &[f64], expected: &[f64]) -> Result<(), TestCaseError> {
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

pub(crate) fn boundaries(grid: Grid) -> [Boundary; 3] {
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
pub(crate) struct Found {
    pub(crate) cells: Vec<[f64; 7]>,
    pub(crate) known: Vec<f64>,
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

/// What is found on bodies, alone or shared by ranks.
pub(crate) struct Scene {
    pub(crate) what: String,
    pub(crate) grid: Grid,
    pub(crate) boundary: Boundary,
    pub(crate) find: Box<dyn Fn(&HalfSpace) -> Found + Sync>,
}

impl Scene {
    pub(crate) fn new(
        what: impl Into<String>,
        grid: Grid,
        boundary: Boundary,
        find: impl Fn(&HalfSpace) -> Found + Sync + 'static,
    ) -> Self {
        Self {
            what: what.into(),
            grid,
            boundary,
            find: Box::new(find),
        }
    }

    /// What one process finds.
    pub(crate) fn alone(&self) -> Found {
        (self.find)(&HalfSpace::with_boundary(self.grid, pair(), self.boundary).unwrap())
    }

    /// What a rank finds.
    pub(crate) fn on(&self, rank: Arc<dyn Ranks>) -> Found {
        (self.find)(&HalfSpace::distributed(self.grid, pair(), self.boundary, rank).unwrap())
    }
}

/// Asserts that ranks find what one process finds.
pub(crate) fn assert_same(scenes: Vec<Scene>) {
    for scene in scenes {
        let alone = scene.alone();
        for size in RANKS {
            let parts = Threads::run(size, PATIENCE, |rank| scene.on(Arc::new(rank)));
            let Scene {
                what,
                grid,
                boundary,
                ..
            } = &scene;
            let cells = [grid.nx(), grid.ny()];
            let what = format!("{what}, {cells:?}, {boundary:?}, {size} ranks");
            for part in &parts {
                let same = same(&part.known, &alone.known);
                same.unwrap_or_else(|error| panic!("{what}: known {error}"));
            }
            let cells: Vec<[f64; 7]> = parts.into_iter().flat_map(|part| part.cells).collect();
            let (cells, alone) = (cells.as_flattened(), alone.cells.as_flattened());
            same(cells, alone).unwrap_or_else(|error| panic!("{what}: {error}"));
        }
    }
}

pub(crate) fn normal_contacts() -> Vec<Scene> {
    let mut scenes = Vec::new();
    for [nx, ny] in [[96, 130], [33, 320]] {
        let grid = Grid::new(nx, ny, 0.3, 0.2).unwrap();
        for boundary in boundaries(grid) {
            scenes.extend(GAPS.map(|gap| {
                Scene::new("a force", grid, boundary, move |bodies| {
                    Found::normal(&press(bodies, &gap, NormalControl::Force(20.0)))
                })
            }));
        }
        let free = Boundary::NonPeriodic;
        scenes.push(Scene::new("an approach", grid, free, |bodies| {
            Found::normal(&press(bodies, &GAPS[0], NormalControl::Approach(0.3)))
        }));
    }
    scenes
}

#[test]
fn normal_contacts_have_the_same_bits() {
    assert_same(normal_contacts());
}

pub(crate) fn sheared_contacts() -> Vec<Scene> {
    let slanting =
        |grid| Friction::per_cell(Field::from_fn(grid, |x, y| 0.3 + 0.01 * (x + y).sin())).unwrap();
    let grid = Grid::new(96, 130, 0.3, 0.2).unwrap();
    let mut scenes = Vec::new();
    for gap in GAPS {
        for (model, load) in [
            (TangentialModel::Scalar, TangentialLoad::force([3.0, 0.0])),
            (TangentialModel::Vector, TangentialLoad::force([2.0, 2.5])),
        ] {
            let find = move |bodies: &HalfSpace| {
                let normal = press(bodies, &gap, NormalControl::Force(20.0));
                let problem =
                    TangentialProblem::builder(bodies, &normal, slanting(bodies.grid()), load);
                let shear = problem.model(model).build().unwrap().solve().unwrap();
                Found::normal(&normal).with_shear(&shear)
            };
            let what = format!("{model:?}");
            scenes.push(Scene::new(what, grid, Boundary::NonPeriodic, find));
        }
    }
    scenes
}

#[test]
fn sheared_contacts_have_the_same_bits() {
    assert_same(sheared_contacts());
}

/// From the last answer, along its trend, in boxes that are left for wider ones; on small boxes some ranks have no cells.
pub(crate) fn sequences() -> Vec<Scene> {
    let grid = Grid::new(96, 130, 0.3, 0.2).unwrap();
    let sequence = Scene::new("a sequence", grid, Boundary::NonPeriodic, |bodies| {
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
    vec![sequence]
}

#[test]
fn solvers_continue_with_the_same_bits() {
    assert_same(sequences());
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

/// Presses a ball, with an observer that ends the solve at this iteration.
fn watched(bodies: &HalfSpace, settings: Settings, last: usize) -> Result<NormalSolution, Error> {
    let gap = Field::from_fn(bodies.grid(), |x, y| 0.05 * (x * x + y * y));
    let problem = NormalProblem::builder(bodies, gap, NormalControl::Force(0.5));
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

/// A rank that leaves before the solve ends the others.
#[test]
fn a_rank_that_is_lost_ends_all() {
    let grid = Grid::square(128, 8.0).unwrap();
    let outcomes = Threads::run(3, PATIENCE, |rank| {
        let is_last = rank.rank() == 2;
        let bodies = HalfSpace::distributed(grid, pair(), Boundary::NonPeriodic, Arc::new(rank))?;
        if is_last {
            Err(Error::EmptyPath)
        } else {
            watched(&bodies, Settings::default(), usize::MAX)
        }
    });
    for outcome in &outcomes[..2] {
        let lost = RankFailure::Lost { rank: 2 };
        assert!(
            matches!(outcome, Err(Error::Ranks(failure)) if *failure == lost),
            "{outcome:?}"
        );
    }
}

/// Observers and clocks of other ranks than the first have no say, on coarse grids that every rank solves by itself
/// neither; those of the first end the solve of all.
#[test]
fn the_first_rank_decides_for_all() {
    let in_time = Settings::default();
    let late = in_time.time_limit(Duration::ZERO);
    for cells in [128, 600] {
        let grid = Grid::square(cells, 8.0).unwrap();
        let alone = HalfSpace::new(grid, pair()).unwrap();
        let expected = watched(&alone, in_time, usize::MAX).unwrap();
        let on_three = |first: (Settings, usize), others: (Settings, usize)| {
            Threads::run(3, PATIENCE, |rank| {
                let (settings, last) = if rank.rank() == 0 { first } else { others };
                let boundary = Boundary::NonPeriodic;
                let bodies = HalfSpace::distributed(grid, pair(), boundary, Arc::new(rank))?;
                watched(&bodies, settings, last)
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
fn a_datum_is_refused_as_on_one_process() {
    let grid = Grid::square(64, 8.0).unwrap();
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

/// What is sent is what the formula says: 16 bytes a wave, of half the columns of the torus and one more, in whole tiles;
/// there of the rows that hold anything, and a bit for each band of rows, and back of all. That comes to 32 bytes a cell
/// of a free grid and 16 of a periodic one, less what stays where it is.
#[test]
fn bytes_are_those_of_the_formula() {
    let n = 256;
    let grid = Grid::square(n, 8.0).unwrap();
    for (boundary, torus) in [(Boundary::NonPeriodic, 2 * n), (Boundary::Periodic, n)] {
        for (ranks, is_single, rows) in [
            (2, false, n),
            (3, false, n),
            (4, false, n),
            (4, true, n),
            (4, false, 64),
            (4, true, 64),
        ] {
            let sent = Threads::run(ranks, PATIENCE, |rank| {
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
                (slab.rows(), bodies.traffic().bytes - before)
            });
            // Columns are dealt out in sixteens; a tile is eight of doubles, or sixteen of singles, by sixteen rows.
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
