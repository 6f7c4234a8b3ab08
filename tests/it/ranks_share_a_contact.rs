//! Contacts shared by ranks have the bits of those of one process.

use std::sync::Arc;
use std::time::Duration;

use proptest::prelude::*;
use stickslip::influence::Component;
use stickslip::ranks::Threads;
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
                    let problem = TangentialProblem::builder(
                        bodies,
                        &normal,
                        slanting(bodies.grid()),
                        load.clone(),
                    );
                    let shear = problem.model(model).build().unwrap().solve().unwrap();
                    Found::normal(&normal).with_shear(&shear)
                };
                assert_same(grid, Boundary::NonPeriodic, &format!("{model:?}"), find);
            }
        }
    }
}
