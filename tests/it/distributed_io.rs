//! Files that ranks write slab by slab are identical, byte by byte, to the files of one process. The fields that ranks
//! read are also bitwise identical.

use std::fs;
use std::path::{Path, PathBuf};

use proptest::prelude::*;
use stickslip::io::{npy, vti};
use stickslip::ranks::RankFailure;
use stickslip::*;

/// Numbers of ranks. Some of the ranks have few rows or no rows.
pub(super) fn ranks() -> &'static [usize] {
    kit::thorough(&[3], &[1, 2, 3, 4, 7])
}

/// Numbers of cells along x and y. They cover oblong grids, one row, one column, and rows longer than a chunk of a sum.
pub(super) const SIZES: [[usize; 2]; 7] = [
    [40, 300],
    [300, 40],
    [97, 211],
    [1, 9000],
    [9000, 1],
    [5000, 5],
    [3, 2],
];

pub(super) fn pair() -> ElasticPair {
    kit::on_rigid(1.0, 0.3)
}

/// Runs `work` on the given number of ranks and returns the results of all ranks.
pub(super) fn on_ranks<T: Send>(
    size: usize,
    grid: Grid,
    work: impl Fn(&HalfSpace, usize) -> T + Sync,
) -> Vec<T> {
    crate::rank_contacts::on_ranks(size, grid, Boundary::Periodic, work)
}

/// Creates an empty folder for a test.
pub(super) fn folder(name: &str) -> PathBuf {
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join(name);
    drop(fs::remove_dir_all(&folder));
    fs::create_dir_all(&folder).unwrap();
    folder
}

/// Returns the names in a folder in alphabetical order.
pub(super) fn names_in(folder: &Path) -> Vec<String> {
    let entries = fs::read_dir(folder).unwrap();
    let name = |entry: std::io::Result<fs::DirEntry>| entry.unwrap().file_name();
    let mut names: Vec<String> = entries
        .map(|entry| name(entry).into_string().unwrap())
        .collect();
    names.sort();
    names
}

/// Returns an uneven height with a tilt.
pub(super) fn height(x: f64, y: f64) -> f64 {
    let wave = (1.3 * x + 0.2).sin() * (0.7 * y).cos() + 0.3 * (x * y).sin();
    2.0 + wave + wave.powi(2) + 0.01 * x - 0.02 * y
}

pub(super) fn bits(samples: &[f64]) -> Vec<u64> {
    samples.iter().map(|sample| sample.to_bits()).collect()
}

/// Asserts that ranks write and read the same files as one process.
fn assert_same_npy(grid: Grid, folder: &Path) {
    let field = Field::from_fn(grid, height);
    let path = folder.join("field.npy");
    for &size in ranks() {
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
fn npy_files_are_identical_to_one_process() {
    let folder = folder("npy_of_slabs");
    for [nx, ny] in SIZES {
        assert_same_npy(Grid::new(nx, ny, 0.3, 0.2).unwrap(), &folder);
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(kit::thorough(6, 12)))]

    #[test]
    fn npy_files_of_any_size_are_identical_to_one_process(nx in 1_usize..150, ny in 1_usize..400) {
        let folder = folder("npy_of_slabs_of_any_size");
        assert_same_npy(Grid::new(nx, ny, 0.5, 0.7).unwrap(), &folder);
    }
}

/// Returns an NPY file as NumPy writes it, with numbers of any type.
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
fn npy_files_of_other_number_types_are_read_as_by_one_process() {
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
        ("|i1", all(&|z| (z as i8).to_le_bytes().to_vec())),
    ];
    for (descr, samples) in &kinds {
        for is_fortran in [false, true] {
            fs::write(&path, npy_file(descr, is_fortran, [ny, nx], samples)).unwrap();
            let expected = npy::read(&path, [0.3, 0.2]).unwrap();
            assert_eq!(npy::grid(&path, [0.3, 0.2]).unwrap(), grid);
            for &size in ranks() {
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
fn invalid_files_and_fields_are_rejected_by_all_ranks() {
    let folder = folder("npy_refused");
    let grid = Grid::new(40, 300, 0.3, 0.2).unwrap();
    let (cut, other) = (folder.join("cut.npy"), folder.join("other.npy"));
    let whole = npy::to_bytes(&Field::zeros(grid));
    fs::write(&cut, &whole[..whole.len() - 8]).unwrap();
    npy::write(&other, &Field::zeros(Grid::new(300, 40, 0.3, 0.2).unwrap())).unwrap();
    for &size in ranks() {
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
            // The first rank creates the file for all ranks.
            let refused = Error::Ranks(RankFailure::RejectedByRank { rank: 0 });
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

/// Returns the text between two marks, and the remaining text.
pub(super) fn between<'a>(text: &'a str, before: &str, after: &str) -> (&'a str, &'a str) {
    let (_, rest) = text.split_once(before).unwrap();
    rest.split_once(after).unwrap()
}

/// Parses the numbers of a text.
fn parse_numbers(text: &str) -> Vec<usize> {
    let words = text.split_whitespace();
    words.map(|word| word.parse().unwrap()).collect()
}

#[test]
fn pvti_pieces_cover_the_whole_grid() {
    let folder = folder("pvti");
    let path = folder.join("run.pvti");
    for [nx, ny] in SIZES {
        let grid = Grid::new(nx, ny, 0.3, 0.2).unwrap();
        let whole = vti::to_bytes(&[("z", &Field::zeros(grid))]).unwrap();
        let whole = String::from_utf8(whole).unwrap();
        let (place, _) = between(&whole, " Origin=", ">");
        for &size in ranks() {
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
                assert_eq!(parse_numbers(extent), [0, nx, next_row, rows.end, 0, 0]);
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
