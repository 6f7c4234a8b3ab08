//! Files that ranks write slab by slab are those of one process, byte by byte; what they read and what they say of a
//! surface are the same to the last bit. If a rank is lost nothing is written half.

use std::fs;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering::Relaxed};
use std::time::{Duration, Instant};

use proptest::prelude::*;
use stickslip::io::{npy, vti};
use stickslip::ranks::{RankFailure, Ranks, Threads};
use stickslip::surface::{self, Form, PowerSpectrum, Statistics};
use stickslip::*;

/// Longer than any step takes, even where many tests run at once.
const PATIENCE: Duration = Duration::from_secs(120);

/// Ranks of which some have few rows or none.
const RANKS: [usize; 5] = [1, 2, 3, 4, 7];

/// Cells along x and y: oblong, one row, one column, rows longer than a chunk of a sum.
const SIZES: [[usize; 2]; 7] = [
    [40, 300],
    [300, 40],
    [97, 211],
    [1, 9000],
    [9000, 1],
    [5000, 5],
    [3, 2],
];

fn pair() -> ElasticPair {
    ElasticPair::new(Material::new(1.0, 0.3).unwrap(), Material::rigid()).unwrap()
}

/// What every rank comes to.
fn on_ranks<T: Send>(
    size: usize,
    grid: Grid,
    work: impl Fn(&HalfSpace, usize) -> T + Sync,
) -> Vec<T> {
    Threads::run(size, PATIENCE, |rank| {
        let number = rank.rank();
        let bodies =
            HalfSpace::distributed(grid, pair(), Boundary::Periodic, Arc::new(rank)).unwrap();
        work(&bodies, number)
    })
}

/// An empty folder of a test.
fn folder(name: &str) -> PathBuf {
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join(name);
    drop(fs::remove_dir_all(&folder));
    fs::create_dir_all(&folder).unwrap();
    folder
}

/// The names in a folder, in their order.
fn names_in(folder: &Path) -> Vec<String> {
    let entries = fs::read_dir(folder).unwrap();
    let name = |entry: std::io::Result<fs::DirEntry>| entry.unwrap().file_name();
    let mut names: Vec<String> = entries
        .map(|entry| name(entry).into_string().unwrap())
        .collect();
    names.sort();
    names
}

/// Uneven heights with a tilt.
fn height(x: f64, y: f64) -> f64 {
    let wave = (1.3 * x + 0.2).sin() * (0.7 * y).cos() + 0.3 * (x * y).sin();
    2.0 + wave + wave.powi(2) + 0.01 * x - 0.02 * y
}

fn bits(samples: &[f64]) -> Vec<u64> {
    samples.iter().map(|sample| sample.to_bits()).collect()
}

/// Asserts that ranks write and read the files of one process.
fn assert_same_npy(grid: Grid, folder: &Path) {
    let field = Field::from_fn(grid, height);
    let path = folder.join("field.npy");
    for size in RANKS {
        drop(fs::remove_file(&path));
        let read = on_ranks(size, grid, |bodies, _| {
            let slab = Field::from_fn(bodies.grid(), height);
            bodies.write_npy(&path, &slab).unwrap();
            bodies.read_npy(&path).unwrap()
        });
        assert!(
            fs::read(&path).unwrap() == npy::to_bytes(&field),
            "{size} ranks, {grid:?}"
        );
        let read: Vec<f64> = read.into_iter().flat_map(Field::into_vec).collect();
        assert_eq!(
            bits(&read),
            bits(field.as_slice()),
            "{size} ranks, {grid:?}"
        );
        assert_eq!(names_in(folder), ["field.npy"]);
    }
}

#[test]
fn npy_files_have_the_same_bytes() {
    let folder = folder("npy_of_slabs");
    for [nx, ny] in SIZES {
        assert_same_npy(Grid::new(nx, ny, 0.3, 0.2).unwrap(), &folder);
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(12))]

    #[test]
    fn npy_files_of_any_size_have_the_same_bytes(nx in 1_usize..150, ny in 1_usize..400) {
        let folder = folder("npy_of_slabs_of_any_size");
        assert_same_npy(Grid::new(nx, ny, 0.5, 0.7).unwrap(), &folder);
    }
}

/// A file as NumPy writes it, of any kind of number.
fn npy_file(descr: &str, is_fortran: bool, [ny, nx]: [usize; 2], samples: &[u8]) -> Vec<u8> {
    let order = if is_fortran { "True" } else { "False" };
    let text =
        format!("{{'descr': '{descr}', 'fortran_order': {order}, 'shape': ({ny}, {nx}), }}\n");
    let mut file = b"\x93NUMPY\x02\x00".to_vec();
    file.extend((text.len() as u32).to_le_bytes());
    file.extend(text.as_bytes());
    file.extend(samples);
    file
}

#[test]
fn npy_files_of_other_kinds_are_read_as_by_one_process() {
    let folder = folder("npy_of_other_kinds");
    let path = folder.join("field.npy");
    let (nx, ny) = (37, 400);
    let grid = Grid::new(nx, ny, 0.3, 0.2).unwrap();
    let numbers: Vec<f64> = (0..nx * ny)
        .map(|i| ((i * i) % 251) as f64 - 120.0)
        .collect();
    let all = |bytes: &dyn Fn(f64) -> Vec<u8>| -> Vec<u8> {
        numbers.iter().flat_map(|number| bytes(*number)).collect()
    };
    let kinds = [
        ("<f8", all(&|z| z.to_le_bytes().to_vec())),
        (">f8", all(&|z| z.to_be_bytes().to_vec())),
        ("<f4", all(&|z| (z as f32).to_le_bytes().to_vec())),
        (">i2", all(&|z| (z as i16).to_be_bytes().to_vec())),
        ("|u1", all(&|z| vec![(z + 120.0) as u8])),
    ];
    for (descr, samples) in &kinds {
        for is_fortran in [false, true] {
            fs::write(&path, npy_file(descr, is_fortran, [ny, nx], samples)).unwrap();
            let expected = npy::read(&path, [0.3, 0.2]).unwrap();
            assert_eq!(npy::grid(&path, [0.3, 0.2]).unwrap(), grid);
            for size in RANKS {
                let read = on_ranks(size, grid, |bodies, _| bodies.read_npy(&path).unwrap());
                let read: Vec<f64> = read.into_iter().flat_map(Field::into_vec).collect();
                assert_eq!(
                    read,
                    expected.as_slice(),
                    "{descr}, {is_fortran}, {size} ranks"
                );
            }
        }
    }
}

#[test]
fn what_cannot_be_read_or_written_is_refused_by_all() {
    let folder = folder("npy_refused");
    let grid = Grid::new(40, 300, 0.3, 0.2).unwrap();
    let (cut, other) = (folder.join("cut.npy"), folder.join("other.npy"));
    let whole = npy::to_bytes(&Field::zeros(grid));
    fs::write(&cut, &whole[..whole.len() - 8]).unwrap();
    npy::write(&other, &Field::zeros(Grid::new(300, 40, 0.3, 0.2).unwrap())).unwrap();
    for size in RANKS {
        let outcomes = on_ranks(size, grid, |bodies, _| {
            let slab = Field::zeros(bodies.grid());
            let elsewhere = Field::zeros(Grid::new(2, 2, 0.3, 0.2).unwrap());
            [
                bodies.read_npy(folder.join("none.npy")).map(drop),
                bodies.read_npy(&cut).map(drop),
                bodies.read_npy(&other).map(drop),
                bodies.write_npy(folder.join("no_folder/field.npy"), &slab),
                bodies.write_pvti(folder.join("no_folder/field.pvti"), &[("z", &slab)]),
                bodies.write_npy(folder.join("field.npy"), &elsewhere),
                bodies.write_pvti(folder.join("field.pvti"), &[("z", &elsewhere)]),
                bodies.write_pvti(folder.join("field.pvti"), &[("z", &slab), ("z", &slab)]),
                bodies.max_of(&elsewhere).map(drop),
                bodies.statistics(&elsewhere).map(drop),
            ]
        });
        for (
            rank,
            [
                none,
                cut,
                other,
                write,
                list,
                cells,
                fields,
                names,
                max,
                statistics,
            ],
        ) in outcomes.iter().enumerate()
        {
            let is_format = |outcome: &Result<()>| matches!(outcome, Err(Error::Format { .. }));
            let is_grid = |outcome: &Result<()>| matches!(outcome, Err(Error::GridMismatch { .. }));
            assert!(matches!(none, Err(Error::File { .. })), "{none:?}");
            assert!(is_format(cut) && is_format(other), "{cut:?}, {other:?}");
            assert!(is_grid(cells) && is_grid(fields), "{cells:?}, {fields:?}");
            assert!(is_format(names), "{names:?}");
            assert!(
                is_grid(max) && is_grid(statistics),
                "{max:?}, {statistics:?}"
            );
            // The first rank makes the file for all.
            let refused = Error::Ranks(RankFailure::Refused { rank: 0 });
            let is_told = rank > 0 && *write == Err(refused);
            assert!(
                is_told || matches!(write, Err(Error::File { .. })),
                "{write:?}"
            );
            assert!(list.is_err(), "{list:?}");
        }
        assert_eq!(names_in(&folder), ["cut.npy", "other.npy"]);
    }
}

/// One rank alone that cannot do its part.
#[test]
fn what_one_rank_refuses_is_not_written() {
    let folder = folder("one_refuses");
    let grid = Grid::new(40, 300, 0.3, 0.2).unwrap();
    let (npy, pvti) = (folder.join("field.npy"), folder.join("field.pvti"));
    fs::write(&npy, "old").unwrap();
    fs::write(&pvti, "old").unwrap();
    // Its piece has the name of a folder.
    fs::create_dir(folder.join("field_1.vti")).unwrap();
    let outcomes = on_ranks(3, grid, |bodies, rank| {
        let slab = Field::zeros(bodies.grid());
        let elsewhere = Field::zeros(Grid::new(2, 2, 0.3, 0.2).unwrap());
        let given = if rank == 1 { &elsewhere } else { &slab };
        [
            bodies.write_npy(&npy, given),
            bodies.write_pvti(&pvti, &[("z", given)]),
        ]
    });
    for (rank, outcomes) in outcomes.iter().enumerate() {
        for outcome in outcomes {
            let refused = Error::Ranks(RankFailure::Refused { rank: 1 });
            let is_told = rank != 1 && *outcome == Err(refused);
            let is_own = matches!(outcome, Err(Error::GridMismatch { .. }));
            assert!(is_told || rank == 1 && is_own, "{outcome:?}");
        }
    }
    assert_eq!(fs::read(&npy).unwrap(), b"old");
    assert_eq!(fs::read(&pvti).unwrap(), b"old");
    assert_eq!(
        names_in(&folder),
        ["field.npy", "field.pvti", "field_1.vti"]
    );

    let outcomes = on_ranks(3, grid, |bodies, _| {
        bodies.write_pvti(&pvti, &[("z", &Field::zeros(bodies.grid()))])
    });
    assert!(outcomes.iter().all(Result::is_err), "{outcomes:?}");
    // No list of a mixture.
    assert!(!pvti.exists());
    assert!(!names_in(&folder).iter().any(|name| name.ends_with(".part")));
}

/// A rank that leaves after so many calls of the others.
#[derive(Debug)]
struct Leaving {
    rank: Threads,
    calls_left: AtomicUsize,
}

impl Ranks for Leaving {
    fn rank(&self) -> usize {
        self.rank.rank()
    }

    fn size(&self) -> usize {
        self.rank.size()
    }

    fn swap(&self, block: Vec<u64>, to: usize, from: usize) -> Result<Vec<u64>, RankFailure> {
        let left = &self.calls_left;
        let one_less = |left: usize| left.checked_sub(1);
        // What a killed process does next: nothing.
        assert!(
            left.fetch_update(Relaxed, Relaxed, one_less).is_ok(),
            "killed"
        );
        self.rank.swap(block, to, from)
    }
}

/// Loses each rank in turn before each of its calls, and asks what is left in the folder.
fn assert_nothing_half(
    folder: &Path,
    write: impl Fn(&HalfSpace) -> Result<()> + Sync,
    is_old_or_new: impl Fn(&Path) -> bool,
) {
    let grid = Grid::new(40, 300, 0.3, 0.2).unwrap();
    for lost in 0..3 {
        let mut calls = 0;
        loop {
            drop(fs::remove_dir_all(folder));
            fs::create_dir_all(folder).unwrap();
            let write_on = |rank: Threads| {
                let calls_left = if rank.rank() == lost {
                    calls
                } else {
                    usize::MAX
                };
                let ranks = Arc::new(Leaving {
                    rank,
                    calls_left: calls_left.into(),
                });
                let bodies = HalfSpace::distributed(grid, pair(), Boundary::Periodic, ranks)?;
                write(&bodies)
            };
            let old = HalfSpace::with_boundary(grid, pair(), Boundary::Periodic).unwrap();
            write(&old).unwrap();
            let start = Instant::now();
            let outcomes = Threads::run(3, Duration::from_secs(5), |rank| {
                catch_unwind(AssertUnwindSafe(|| write_on(rank)))
            });
            assert!(start.elapsed() < Duration::from_secs(4));
            let is_over = outcomes.iter().all(|outcome| matches!(outcome, Ok(Ok(()))));
            for (rank, outcome) in outcomes.into_iter().enumerate() {
                match outcome {
                    Err(_) => assert_eq!(rank, lost),
                    Ok(Ok(())) => {}
                    Ok(Err(error)) => assert!(
                        // The lost rank has taken the new file with it.
                        matches!(
                            error,
                            Error::Ranks(RankFailure::Lost { .. }) | Error::File { .. }
                        ),
                        "{error:?}"
                    ),
                }
            }
            assert!(is_old_or_new(folder), "rank {lost}, call {calls}");
            let is_part = |name: &String| name.ends_with(".part");
            assert!(!names_in(folder).iter().any(is_part));
            if is_over {
                break;
            }
            calls += 1;
        }
        assert!(calls >= 5, "{calls} calls");
    }
}

/// Whatever the moment at which a rank is lost, the file is the old one or the new one.
#[test]
fn a_rank_killed_in_the_middle_leaves_nothing_half() {
    let folder = folder("killed");
    let path = folder.join("field.npy");
    let grid = Grid::new(40, 300, 0.3, 0.2).unwrap();
    let [old, new] =
        [1.0, 2.0].map(|factor| npy::to_bytes(&Field::from_fn(grid, height).scaled(factor)));
    let write = |bodies: &HalfSpace| {
        let factor = if bodies.grid() == grid { 1.0 } else { 2.0 };
        bodies.write_npy(&path, &Field::from_fn(bodies.grid(), height).scaled(factor))
    };
    assert_nothing_half(&folder, write, |_| {
        let found = fs::read(&path).unwrap();
        found == old || found == new
    });
}

/// And a list is that of the old images or of the new ones, if there is any.
#[test]
fn a_rank_killed_in_the_middle_leaves_no_mixture() {
    let folder = folder("killed_images");
    let path = folder.join("field.pvti");
    let write = |bodies: &HalfSpace| {
        let name = if bodies.grid().rows() == (0..300) {
            "old"
        } else {
            "new"
        };
        bodies.write_pvti(&path, &[(name, &Field::from_fn(bodies.grid(), height))])
    };
    assert_nothing_half(&folder, write, |_| {
        let Ok(list) = fs::read_to_string(&path) else {
            return true;
        };
        let name = between(&list, "Name=\"", "\"").0;
        let mut pieces = 0;
        let mut rest = &list[..];
        while rest.contains("Source=") {
            let (file, after) = between(rest, "Source=\"", "\"");
            let piece = fs::read_to_string(folder.join(file)).unwrap();
            assert!(piece.contains(&format!("Name=\"{name}\"")) && piece.ends_with("</VTKFile>\n"));
            pieces += 1;
            rest = after;
        }
        pieces == if name == "old" { 1 } else { 3 }
    });
}

/// The text between two marks, and what follows.
fn between<'a>(text: &'a str, before: &str, after: &str) -> (&'a str, &'a str) {
    let (_, rest) = text.split_once(before).unwrap();
    rest.split_once(after).unwrap()
}

/// The numbers of a text.
fn numbers(text: &str) -> Vec<usize> {
    let words = text.split_whitespace();
    words.map(|word| word.parse().unwrap()).collect()
}

#[test]
fn images_in_pieces_show_the_whole() {
    let folder = folder("pvti");
    let path = folder.join("run.pvti");
    for [nx, ny] in SIZES {
        let grid = Grid::new(nx, ny, 0.3, 0.2).unwrap();
        let whole = vti::to_bytes(&[("z", &Field::zeros(grid))]).unwrap();
        let whole = String::from_utf8(whole).unwrap();
        let (place, _) = between(&whole, " Origin=", ">");
        for size in RANKS {
            for name in names_in(&folder) {
                fs::remove_file(folder.join(name)).unwrap();
            }
            let pieces = on_ranks(size, grid, |bodies, _| {
                let z = Field::from_fn(bodies.grid(), height);
                let traction = z.scaled(2.0);
                let fields = [("<z>", vti::Array::from(&z)), ("t", [&z, &traction].into())];
                bodies.write_pvti(&path, &fields).unwrap();
                (z.grid().rows(), vti::to_bytes(&fields).unwrap())
            });
            let list = fs::read_to_string(&path).unwrap();
            let extent = format!("WholeExtent=\"0 {nx} 0 {ny} 0 0\" GhostLevel=\"0\"");
            assert!(list.contains(&extent), "{list}");
            assert!(list.contains(&format!("Origin={place}>")), "{list}");
            assert!(list.contains(r#"Name="&lt;z&gt;"/>"#), "{list}");
            assert!(
                list.contains(r#"Name="t" NumberOfComponents="3"/>"#),
                "{list}"
            );
            let (mut rest, mut next_row, mut files) = (&list[..], 0, vec!["run.pvti".to_owned()]);
            while rest.contains("<Piece ") {
                let (extent, after) = between(rest, "<Piece Extent=\"", "\"");
                let (file, after) = between(after, "Source=\"", "\"");
                let text = fs::read_to_string(folder.join(file)).unwrap();
                let number = between(file, "run_", ".vti").0.parse::<usize>().unwrap();
                let (rows, piece) = &pieces[number];
                assert_eq!(numbers(extent), [0, nx, next_row, rows.end, 0, 0]);
                assert!(text.as_bytes() == piece && !rows.is_empty());
                assert!(text.contains(&format!("WholeExtent=\"{extent}\" Origin={place}>")));
                assert!(text.contains(&format!("<Piece Extent=\"{extent}\">")));
                next_row = rows.end;
                files.push(file.to_owned());
                rest = after;
            }
            assert_eq!(next_row, ny);
            files.sort();
            assert_eq!(names_in(&folder), files);
            if size == 1 {
                assert_eq!(pieces[0].0, 0..ny);
            }
        }
    }
}

/// Everything that is said of a surface, in numbers, and the levelled heights held here.
fn told(bodies: &HalfSpace, z: impl Fn(f64, f64) -> f64) -> (Vec<f64>, Vec<f64>) {
    let heights = Field::from_fn(bodies.grid(), z);
    let statistics = bodies.statistics(&heights).unwrap();
    let spectrum = bodies.power_spectrum(&heights).unwrap();
    let mut known = vec![
        bodies.max_of(&heights).unwrap(),
        bodies.min_of(&heights).unwrap(),
        bodies.integral_of(&heights).unwrap(),
        bodies.mean_of(&heights).unwrap(),
    ];
    known.extend(numbers_of(&statistics, &spectrum));
    let mut missing = heights;
    let nx = missing.grid().nx();
    for (iy, row) in missing.grid().rows().zip(0..) {
        let left_out = (7 * iy) % (2 * nx);
        if left_out < nx && iy > 0 {
            missing.as_mut_slice()[row * nx + left_out] = f64::NAN;
        }
    }
    let mut cells = Vec::new();
    for form in [Form::Mean, Form::Plane] {
        let levelled = bodies.level(&missing, form).unwrap();
        cells.extend_from_slice(levelled.heights().as_slice());
        cells.extend_from_slice(levelled.form().as_slice());
    }
    (known, cells)
}

fn numbers_of(statistics: &Statistics, spectrum: &PowerSpectrum) -> Vec<f64> {
    let [along_x, along_y] = statistics.profile_rms_slope();
    let mut numbers = vec![
        statistics.mean_height(),
        statistics.arithmetic_mean_height(),
        statistics.rms_height(),
        statistics.skewness(),
        statistics.kurtosis(),
        statistics.highest_peak(),
        statistics.deepest_valley(),
        along_x,
        along_y,
        statistics.developed_area_ratio(),
        statistics.spectral_rms_slope(),
    ];
    numbers.extend(spectrum.moments());
    numbers.extend(spectrum.values());
    numbers.extend(spectrum.wave_numbers());
    numbers.extend(spectrum.modes().iter().map(|modes| *modes as f64));
    numbers
}

/// What ranks hold of four fields, field by field.
fn joined(parts: &[Vec<f64>]) -> Vec<f64> {
    let field = |index: usize| {
        parts.iter().flat_map(move |part| {
            let cells = part.len() / 4;
            part[index * cells..(index + 1) * cells].iter().copied()
        })
    };
    (0..4).flat_map(field).collect()
}

#[test]
fn surfaces_are_characterised_with_the_same_bits() {
    for [nx, ny] in SIZES {
        let grid = Grid::new(nx, ny, 0.3, 0.2).unwrap();
        let alone = HalfSpace::with_boundary(grid, pair(), Boundary::Periodic).unwrap();
        let (known, cells) = told(&alone, height);
        let heights = Field::from_fn(grid, height);
        assert_eq!(
            bits(&known[..3]),
            bits(&[heights.max(), heights.min(), heights.integral()])
        );
        let (statistics, spectrum) = (
            Statistics::of(&heights).unwrap(),
            PowerSpectrum::of(&heights).unwrap(),
        );
        assert_eq!(bits(&known[4..]), bits(&numbers_of(&statistics, &spectrum)));
        for size in RANKS {
            let parts = on_ranks(size, grid, |bodies, _| told(bodies, height));
            let (others, parts): (Vec<_>, Vec<_>) = parts.into_iter().unzip();
            for other in others {
                assert_eq!(bits(&other), bits(&known), "{nx} x {ny}, {size} ranks");
            }
            assert_eq!(
                bits(&joined(&parts)),
                bits(&cells),
                "{nx} x {ny}, {size} ranks"
            );
        }
    }
}

#[test]
fn surfaces_of_slabs_are_refused_alike() {
    let grid = Grid::new(40, 300, 0.3, 0.2).unwrap();
    let outcomes = on_ranks(3, grid, |bodies, rank| {
        let mut heights = Field::from_fn(bodies.grid(), height);
        let nothing = heights.map(|_| f64::NAN);
        let few = bodies.level(&nothing, Form::Mean).map(drop);
        #[cfg(feature = "dense")]
        let polynomial = bodies.level(&heights, Form::Polynomial(2)).map(drop);
        #[cfg(feature = "dense")]
        assert!(matches!(
            polynomial,
            Err(Error::Ranks(RankFailure::NotShared(_)))
        ));
        assert!(matches!(few, Err(Error::Undetermined { known: 0, .. })));
        if rank == 2 {
            heights.as_mut_slice()[5] = f64::INFINITY;
        }
        [
            bodies.statistics(&heights).map(drop),
            bodies.power_spectrum(&heights).map(drop),
            bodies.level(&heights, Form::Plane).map(drop),
        ]
    });
    for (rank, outcomes) in outcomes.iter().enumerate() {
        for outcome in outcomes {
            let refused = Error::Ranks(RankFailure::Refused { rank: 2 });
            let is_own = matches!(outcome, Err(Error::Sample { index: 5, .. }));
            assert!(if rank == 2 {
                is_own
            } else {
                *outcome == Err(refused)
            });
        }
    }
    // A slab without rows is no surface by itself.
    let empty = on_ranks(7, Grid::new(3, 2, 0.3, 0.2).unwrap(), |bodies, _| {
        let slab = Field::zeros(bodies.grid());
        let outcome = Statistics::of(&slab).map(drop);
        let level = surface::level(&slab, Form::Mean).map(drop);
        if bodies.grid().cells() > 0 {
            return false;
        }
        assert!(matches!(outcome, Err(Error::GridSize { .. })));
        assert!(matches!(level, Err(Error::GridSize { .. })));
        true
    });
    assert!(empty.contains(&true));
}
