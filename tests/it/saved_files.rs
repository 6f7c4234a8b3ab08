//! Files of saved histories in `tests/data/saved` are read, continued and written again. These tests verify that a minor series
//! reads its older files.
//!
//! `FREEZE=write cargo test --test it saved_files` writes the files and their numbers. A release writes them once. Later
//! versions of the format add files and keep the existing ones.

use std::fmt::Write;
use std::path::PathBuf;
use std::sync::Arc;
use std::time::Duration;

use kit::unit_pair;
use stickslip::history::{Rolling, State};
use stickslip::layers::Layer;
use stickslip::normal::Hardness;
use stickslip::ranks::Threads;
use stickslip::tangential::RelativeDisplacement;
use stickslip::{
    Axis, Boundary, CellValue, ElasticPair, Error, Field, Friction, Grid, HalfSpace, History,
    LoadStep, Material, NormalLoad, Result, TangentialControl, TangentialModel, surface,
};

/// Version of the format of all files in the folder.
const VERSION: u8 = 1;

/// Agreement of numbers on different processors, relative to the largest number of the step. The tolerance of the
/// histories is 1e-10.
const AGREEMENT: f64 = 1e-8;

const PATIENCE: Duration = Duration::from_secs(60);

/// Kind of a saved history: its file, its bodies, and the steps before and after the file.
struct Kind {
    name: &'static str,
    bodies: fn() -> Result<HalfSpace>,
    history: fn(&HalfSpace) -> Result<History>,
    next: fn() -> LoadStep,
}

const KINDS: [Kind; 6] = [
    Kind {
        name: "scalar",
        bodies: || HalfSpace::new(grid()?, unit_pair(0.3)),
        history: |bodies| {
            let friction = Friction::coulomb(0.4)?.max_shear_stress(0.5)?;
            let mut history = History::builder(bodies, ball(bodies)?, friction)
                .tolerance(1e-10)
                .build()?;
            history.step(&press(0.15))?;
            history.step(&press(0.2).tangential(Axis::X, TangentialControl::Force(0.06)))?;
            Ok(history)
        },
        next: || press(0.25).tangential(Axis::X, TangentialControl::Force(0.02)),
    },
    Kind {
        name: "plane",
        bodies: || {
            let grid = Grid::new(12, 1, 0.25, 1.0)?;
            let line = Boundary::PeriodicAlongY { datum: 40.0 };
            HalfSpace::with_boundary(grid, unit_pair(0.3), line)?.with_cell_value(CellValue::Centre)
        },
        history: |bodies| {
            let cylinder = surface::cylinder(bodies.grid(), 10.0)?;
            let friction = Friction::per_cell(Field::constant(bodies.grid(), 0.4))?;
            let mut history = History::builder(bodies, cylinder, friction)
                .axis(Axis::Y)
                .tolerance(1e-10)
                .build()?;
            history.step(&press(0.1))?;
            history.step(&LoadStep::hold().tangential(Axis::Y, TangentialControl::Force(0.02)))?;
            Ok(history)
        },
        next: || LoadStep::hold().tangential(Axis::Y, TangentialControl::Force(-0.01)),
    },
    Kind {
        name: "coupled",
        bodies: || {
            let unlike = ElasticPair::new(Material::new(1.0, 0.2)?, Material::rigid())?;
            HalfSpace::new(grid()?, unlike)
        },
        history: |bodies| {
            let mut history = History::builder(bodies, ball(bodies)?, Friction::coulomb(0.3)?)
                .model(TangentialModel::Vector)
                .tolerance(1e-10)
                .build()?;
            history.step(&press(0.1))?;
            history.step(&LoadStep::force([0.01, 0.005]))?;
            Ok(history)
        },
        next: || LoadStep::force([-0.01, 0.01]),
    },
    Kind {
        name: "rolled",
        bodies: || HalfSpace::new(Grid::new(10, 4, 0.3, 0.5)?, unit_pair(0.3)),
        history: |bodies| {
            let mut history = History::builder(bodies, ball(bodies)?, Friction::coulomb(0.3)?)
                .model(TangentialModel::Vector)
                .tolerance(1e-10)
                .build()?;
            history.step(&press(0.1))?;
            history.step(&roll())?;
            Ok(history)
        },
        next: roll,
    },
    Kind {
        name: "wear",
        bodies: || HalfSpace::with_boundary(grid()?, unit_pair(0.3), Boundary::Periodic),
        history: |bodies| {
            let grid = bodies.grid();
            let ball = ball(bodies)?;
            let mut history = History::builder(bodies, &ball, Friction::coulomb(0.4)?)
                .hardness(Hardness::per_cell(Field::constant(grid, 0.06))?)
                .permanent_set(true)
                .tolerance(1e-10)
                .build()?;
            history.step(&press(0.2))?;
            let sheared = LoadStep::hold().tangential(Axis::X, TangentialControl::Force(0.03));
            history.step(&sheared)?;
            // The file stores the worn gap in addition to the gap of the pressure.
            let depth = 1e-3;
            let worn = Field::from_fn(grid, |x, y| depth * (1.0 - 0.1 * (x * x + y * y)));
            let gap = history.gap_as_set()?;
            let gap = gap.as_slice().iter().zip(worn.as_slice());
            let gap = gap.map(|(gap, depth)| gap + depth).collect();
            history.set_gap(&Field::from_vec(grid, gap)?)?;
            Ok(history)
        },
        next: || press(0.22).tangential(Axis::X, TangentialControl::Force(-0.02)),
    },
    Kind {
        name: "coated",
        bodies: || {
            let coated = Material::new(1.0, 0.3)?.coated(&[Layer::new(4.0, 0.3, 0.5)?])?;
            HalfSpace::new(grid()?, ElasticPair::new(coated, Material::new(1.0, 0.3)?)?)
        },
        history: |bodies| {
            let stretch = [[1e-3, 0.0], [0.0, 0.0]];
            let stretch = RelativeDisplacement::bulk_strain(bodies.grid(), stretch)?;
            let mut history = History::builder(bodies, ball(bodies)?, Friction::coulomb(0.4)?)
                .relative_displacement(stretch)
                .tolerance(1e-10)
                .build()?;
            history.step(&press(0.2))?;
            history.step(&LoadStep::hold().relative_displacement(0.5))?;
            Ok(history)
        },
        next: || LoadStep::hold().relative_displacement(-0.5),
    },
];

fn grid() -> Result<Grid> {
    Grid::new(6, 5, 0.5, 0.5)
}

fn ball(bodies: &HalfSpace) -> Result<Field> {
    surface::sphere(bodies.grid(), 10.0)
}

fn press(force: f64) -> LoadStep {
    LoadStep::hold().normal(NormalLoad::Force(force))
}

fn roll() -> LoadStep {
    LoadStep::hold().roll(Rolling::new(1).creepage([0.04, 0.02]))
}

fn folder() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../data/saved")
}

fn file(name: &str) -> Vec<u8> {
    let path = folder().join(format!("{name}.state"));
    std::fs::read(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

/// Returns the number of steps, and numbers that depend on all fields of the state.
fn numbers(history: &History) -> Vec<f64> {
    let state = history.state();
    let normal = state.normal();
    let sum = |field: &Field| field.as_slice().iter().sum::<f64>();
    let mut numbers = vec![
        history.steps() as f64,
        history.approach(),
        normal.force(),
        normal.pressure().max(),
        normal.gap().max(),
        sum(history.accumulated_slip()),
        sum(history.accumulated_dissipation()),
        sum(history.unloaded_gap()),
    ];
    numbers.extend(history.shift());
    numbers.extend(history.tangential_force());
    numbers.extend(history.traction().map(Field::max));
    numbers.extend(history.slip().map(sum));
    for zone in [stickslip::Zone::Stick, stickslip::Zone::Slip] {
        let found = history.zones().iter().filter(|found| **found == zone);
        numbers.push(found.count() as f64);
    }
    numbers
}

fn row(name: &str, numbers: &[f64]) -> String {
    numbers.iter().fold(name.to_owned(), |mut row, number| {
        write!(row, ",{number:e}").unwrap();
        row
    })
}

/// Compares numbers with a row of `numbers.csv`.
fn assert_recorded(name: &str, found: &[f64]) {
    let table = std::fs::read_to_string(folder().join("numbers.csv")).unwrap();
    let prefix = format!("{name},");
    let recorded = table.lines().find_map(|line| line.strip_prefix(&prefix));
    let recorded: Vec<f64> = recorded
        .unwrap_or_else(|| panic!("{name} has no numbers"))
        .split(',')
        .map(|number| number.parse().unwrap())
        .collect();
    assert_eq!(recorded.len(), found.len());
    let scale = recorded[1..]
        .iter()
        .fold(0.0_f64, |most, number| most.max(number.abs()));
    for (recorded, found) in recorded.iter().zip(found) {
        assert!(
            (recorded - found).abs() <= AGREEMENT * scale,
            "{name}: {found:e} instead of {recorded:e}"
        );
    }
}

fn is_written() -> bool {
    std::env::var("FREEZE").is_ok_and(|value| value == "write")
}

/// Writes a file of each kind, and the numbers of its history.
fn write_files() -> Result<()> {
    let mut table = String::new();
    for kind in &KINDS {
        let bodies = (kind.bodies)()?;
        let mut history = (kind.history)(&bodies)?;
        history.save(folder().join(format!("{}.state", kind.name)))?;
        writeln!(table, "{}", row(kind.name, &numbers(&history))).unwrap();
        history.step(&(kind.next)())?;
        let name = format!("{} continued", kind.name);
        writeln!(table, "{}", row(&name, &numbers(&history))).unwrap();
    }
    let kind = &KINDS[0];
    let path = folder().join("slabs.state");
    for outcome in on_ranks(3, |bodies| (kind.history)(bodies)?.save(&path)) {
        outcome?;
    }
    std::fs::write(folder().join("numbers.csv"), table).unwrap();
    Ok(())
}

/// Makes a call for the bodies of the first kind on each rank.
fn on_ranks<T: Send>(
    ranks: usize,
    call: impl Fn(&HalfSpace) -> Result<T> + Sync,
) -> Vec<Result<T>> {
    Threads::run(ranks, PATIENCE, |rank| {
        let bodies = HalfSpace::distributed(
            grid()?,
            unit_pair(0.3),
            Boundary::NonPeriodic,
            Arc::new(rank),
        )?;
        call(&bodies)
    })
}

#[test]
fn each_kind_is_read_continued_and_written_again() -> Result<()> {
    if is_written() {
        write_files()?;
    }
    for kind in &KINDS {
        let bytes = file(kind.name);
        assert_eq!(bytes[8..12], [VERSION, 0, 0, 0]);
        let state = State::from_bytes(&bytes)?;
        assert!(state.to_bytes() == bytes, "{}", kind.name);

        let bodies = (kind.bodies)()?;
        let mut history = History::from_state(&bodies, state)?;
        assert_recorded(kind.name, &numbers(&history));
        history.step(&(kind.next)())?;
        assert_recorded(&format!("{} continued", kind.name), &numbers(&history));

        // The steps before the file give the same numbers in this version of the crate.
        assert_recorded(kind.name, &numbers(&(kind.history)(&bodies)?));
    }
    Ok(())
}

#[test]
fn compressed_bytes_are_named() {
    for (start, program) in [
        (&b"\x1f\x8b\x08\0\0\0\0\0\0\x03"[..], "gzip"),
        (b"BZh91AY&SY", "bzip2"),
    ] {
        let error = State::from_bytes(start).unwrap_err().to_string();
        let problem = format!("the data are compressed by {program}: decompress them first");
        assert!(error.contains(&problem), "{error}");
    }
}

#[test]
fn slabs_are_read_on_one_two_and_three_ranks() -> Result<()> {
    let path = folder().join("slabs.state");
    let kind = &KINDS[0];
    let mut history = History::load(&(kind.bodies)()?, &path)?;
    assert_recorded(kind.name, &numbers(&history));
    history.step(&(kind.next)())?;
    assert_recorded("scalar continued", &numbers(&history));

    for ranks in [2, 3] {
        let again = std::env::temp_dir().join(format!(
            "stickslip_slabs_{}_{ranks}.state",
            std::process::id()
        ));
        let shifts = on_ranks(ranks, |bodies| {
            let mut history = History::load(bodies, &path)?;
            history.save(&again)?;
            Ok(history.step(&(kind.next)())?.shift())
        });
        for shift in shifts {
            let error = (shift?[0] - history.shift()[0]).abs();
            assert!(error <= AGREEMENT * history.shift()[0].abs(), "{error:e}");
        }
        let bytes = std::fs::read(&again).unwrap();
        std::fs::remove_file(&again).unwrap();
        // The file of as many ranks is the same. A different number of ranks has different slabs.
        assert_eq!(bytes == file("slabs"), ranks == 3);
    }
    Ok(())
}

/// Returns the first bytes of the slabs in a file.
fn starts_of_slabs(bytes: &[u8]) -> Vec<usize> {
    let places = 0..bytes.len();
    let starts = places.filter(|place| bytes[*place..].starts_with(b"\x93STKSLIP"));
    starts.collect()
}

/// Returns the problem of a file with these bytes.
fn problem(bodies: &HalfSpace, bytes: &[u8]) -> String {
    problem_of("file", bodies, bytes)
}

/// Returns the problem of a file with these bytes, which `what` describes.
fn problem_of(what: &str, bodies: &HalfSpace, bytes: &[u8]) -> String {
    let path = std::env::temp_dir().join(format!(
        "stickslip_damaged_{}_{:?}.state",
        std::process::id(),
        std::thread::current().id()
    ));
    std::fs::write(&path, bytes).unwrap();
    let outcome = History::load(bodies, &path);
    std::fs::remove_file(&path).unwrap();
    match outcome {
        Err(Error::Format { problem, .. }) => problem,
        Err(other) => panic!("{what}: {other}"),
        Ok(_) => panic!("{what} is accepted"),
    }
}

#[test]
fn file_of_future_version_is_rejected_with_both_versions() -> Result<()> {
    for kind in &KINDS {
        let mut bytes = file(kind.name);
        bytes[8] = VERSION + 1;
        let text = problem(&(kind.bodies)()?, &bytes);
        assert!(
            text.contains("version 2") && text.contains("version 1"),
            "{text}"
        );
    }
    let bodies = (KINDS[0].bodies)()?;
    let slabs = file("slabs");
    // The version of the table, and the version of the first slab.
    for place in [8, starts_of_slabs(&slabs)[0] + 8] {
        let mut bytes = slabs.clone();
        assert_eq!(bytes[place], VERSION);
        bytes[place] = VERSION + 1;
        let text = problem(&bodies, &bytes);
        assert!(
            text.contains("version 2") && text.contains("version 1"),
            "{text}"
        );
    }
    Ok(())
}

#[test]
fn truncated_and_changed_files_are_rejected() -> Result<()> {
    let slabs = ("slabs", (KINDS[0].bodies)()?);
    let files = KINDS.iter().map(|kind| Ok((kind.name, (kind.bodies)()?)));
    for file_of in files.chain([Ok(slabs)]) {
        let (name, bodies) = file_of?;
        let bytes = file(name);
        for part in 0..24 {
            let length = bytes.len() * part / 24;
            problem_of(
                &format!("{name} of {length} bytes"),
                &bodies,
                &bytes[..length],
            );
        }
        problem(&bodies, &bytes[..bytes.len() - 1]);
        problem(&bodies, &[&bytes[..], &[0]].concat());
        // A small grid is on the last rank. A slab without rows is not read, except for the first.
        let unread = match starts_of_slabs(&bytes)[..] {
            [_, second, third] => second..third,
            _ => 0..0,
        };
        let places = (0..bytes.len()).step_by(bytes.len() / 40);
        for place in places.filter(|place| !unread.contains(place)) {
            let mut changed = bytes.clone();
            changed[place] ^= 0x10;
            let what = format!("{name} with a change of byte {place}");
            problem_of(&what, &bodies, &changed);
        }
    }
    Ok(())
}
