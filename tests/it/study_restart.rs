//! A study that was killed resumes and produces the same table, even if its table was truncated, damaged or enlarged.
//! Only one process writes at a time, and tables of other studies are rejected.

#[path = "../../examples/study/command/mod.rs"]
mod command;

use std::fs;
use std::path::{Path, PathBuf};

use command::{Failure, complain, run};
use stickslip::surface::{self, SelfAffine};
use stickslip::{
    Boundary, ElasticPair, Friction, Grid, HalfSpace, Material, NormalLoad, NormalProblem,
    TangentialLoad, TangentialProblem,
};

/// Arguments of a small study with six normal solves and twelve cases.
const SMALL: &str = "--cells 16 --cut-off 4 --seeds 1-3 --pressures 0.02,0.1";

fn run_study(line: &str) -> Result<(), Failure> {
    let words: Vec<String> = line.split_whitespace().map(str::to_owned).collect();
    run(&words)
}

/// Creates an empty folder for the tables of a test.
fn new_folder(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR"))
        .join("studies")
        .join(name);
    if folder.exists() {
        fs::remove_dir_all(&folder).unwrap();
    }
    fs::create_dir_all(&folder).unwrap();
    folder
}

/// Returns the paths of files in a folder, as arguments of a command line.
fn paths<const N: usize>(folder: &Path, names: [&str; N]) -> [String; N] {
    names.map(|name| folder.join(name).into_os_string().into_string().unwrap())
}

/// Returns the table of the small study, solved and merged without interruption.
fn whole_table(folder: &Path) -> Vec<u8> {
    let [whole, merged] = paths(folder, ["whole.csv", "merged.csv"]);
    run_study(&format!("{SMALL} --threads 1 --out {whole}")).unwrap();
    run_study(&format!("--merge {merged} {whole}")).unwrap();
    fs::read(merged).unwrap()
}

/// Returns the entry of a merged table for a case and a column.
fn entry<'t>(table: &'t str, case: usize, name: &str) -> &'t str {
    let mut lines = table.lines().skip(1);
    let column = lines
        .next()
        .unwrap()
        .split(',')
        .position(|other| other == name);
    let mut words = lines.nth(case - 1).unwrap().split(',');
    words.nth(column.unwrap()).unwrap()
}

#[test]
fn study_cut_anywhere_resumes_to_the_same_table() {
    let folder = new_folder("cut");
    let expected = whole_table(&folder);
    let [first, second, merged] = paths(&folder, ["first.csv", "second.csv", "merged.csv"]);
    run_study(&format!("{SMALL} --shard 2/2 --threads 2 --out {second}")).unwrap();
    run_study(&format!("{SMALL} --shard 1/2 --threads 2 --out {first}")).unwrap();
    let table = fs::read(&first).unwrap();
    let last_line = table[..table.len() - 1]
        .iter()
        .rposition(|&byte| byte == b'\n');
    // The table is cut within the header, within the rows, and on both sides of the end of a line.
    let ends = [
        last_line.unwrap(),
        last_line.unwrap() + 1,
        table.len() - 1,
        table.len(),
    ];
    for end in (0..table.len()).step_by(101).chain(ends) {
        fs::write(&first, &table[..end]).unwrap();
        run_study(&format!("{SMALL} --shard 1/2 --threads 3 --out {first}")).unwrap();
        let _ = fs::remove_file(&merged);
        run_study(&format!("--merge {merged} {second} {first}")).unwrap();
        assert!(
            fs::read(&merged).unwrap() == expected,
            "cut after {end} bytes"
        );
    }
}

#[test]
fn study_shards_contain_each_case_once() {
    let folder = new_folder("shards");
    let expected = whole_table(&folder);
    for parts in 1..=8 {
        let [merged] = paths(&folder, ["parts.csv"]);
        let mut words = vec![format!("--merge {merged}")];
        let mut lines = 0;
        for part in 1..=parts {
            let [out] = paths(&folder, [&format!("part-{part}-of-{parts}.csv")]);
            run_study(&format!("{SMALL} --shard {part}/{parts} --out {out}")).unwrap();
            lines += fs::read_to_string(&out).unwrap().lines().count() - 2;
            words.push(out);
        }
        assert_eq!(lines, 12);
        run_study(&words.join(" ")).unwrap();
        assert!(fs::read(merged).unwrap() == expected);
    }
}

#[test]
fn study_with_damaged_lines_is_repaired() {
    let folder = new_folder("damaged");
    let expected = whole_table(&folder);
    let [whole, merged] = paths(&folder, ["whole.csv", "merged.csv"]);
    let table = fs::read(&whole).unwrap();
    let ends: Vec<usize> = (0..table.len()).filter(|&at| table[at] == b'\n').collect();
    // Each line after the two header lines is damaged in three ways: half of the line is lost, the line is
    // overwritten with invalid text, or the line is joined with the next line.
    for line in ends[1..].windows(2) {
        let (start, end) = (line[0] + 1, line[1]);
        let half = start + (end - start) / 2;
        let zeros = vec![0xff; end - start];
        let next = end + usize::from(end + 1 < table.len());
        for damaged in [
            [&table[..half], &table[end..]].concat(),
            [&table[..start], &zeros, &table[end..]].concat(),
            [&table[..half], &table[next..]].concat(),
        ] {
            fs::write(&whole, &damaged).unwrap();
            let refused = run_study(&format!("--merge {merged} {whole}")).unwrap_err();
            assert!(matches!(refused, Failure::Missing { .. }), "{refused}");
            run_study(&format!("{SMALL} --out {whole}")).unwrap();
            let repaired = fs::read(&whole).unwrap();
            assert!(repaired.starts_with(&damaged), "no byte is removed");
            run_study(&format!("--merge {merged} {whole}")).unwrap();
            assert!(fs::read(&merged).unwrap() == expected);
        }
    }
}

#[test]
fn study_with_more_seeds_extends_its_table() {
    let folder = new_folder("grown");
    let [small, large, at_once, merged] = paths(
        &folder,
        ["small.csv", "large.csv", "at_once.csv", "merged.csv"],
    );
    let plan = |seeds: &str| format!("--cells 16 --cut-off 4 --pressures 0.02,0.1 --seeds {seeds}");
    run_study(&format!("{} --out {at_once}", plan("1-3,9"))).unwrap();
    run_study(&format!("--merge {merged} {at_once}")).unwrap();
    let expected = fs::read(&merged).unwrap();
    let rows = |path: &str| fs::read_to_string(path).unwrap().lines().count();

    // Each shard keeps its own rows, and no case is solved twice.
    for (shard, table) in [("1/2", &small), ("2/2", &large)] {
        for seeds in ["1-2", "1-3", "1-3,9", "1-2"] {
            run_study(&format!("{} --shard {shard} --out {table}", plan(seeds))).unwrap();
        }
    }
    assert_eq!(rows(&small) + rows(&large), 16 + 2 * (2 + 2));
    run_study(&format!("--merge {merged} {small} {large}")).unwrap();
    assert!(fs::read(&merged).unwrap() == expected);

    // A shard of the smaller plan lacks cases of the larger plan until the shard is also enlarged.
    let [old] = paths(&folder, ["old.csv"]);
    run_study(&format!("{} --shard 2/2 --out {old}", plan("1-2"))).unwrap();
    let refused = run_study(&format!("--merge {merged} {small} {old}")).unwrap_err();
    assert!(
        matches!(
            refused,
            Failure::Missing {
                missing: 4,
                total: 16,
                ..
            }
        ),
        "{refused}"
    );

    // A plan in which other seeds replace the old ones is a different study.
    let refused = run_study(&format!("{} --out {old}", plan("1,3"))).unwrap_err();
    assert!(matches!(refused, Failure::OtherStudy { .. }), "{refused}");
}

#[test]
fn study_has_one_writer_at_a_time() {
    use fs2::FileExt;

    let folder = new_folder("busy");
    let expected = whole_table(&folder);
    let [table, merged] = paths(&folder, ["table.csv", "merged.csv"]);
    let other = fs::File::create(&table).unwrap();
    other.lock_exclusive().unwrap();
    let refused = run_study(&format!("{SMALL} --out {table}")).unwrap_err();
    assert!(matches!(refused, Failure::Busy(_)), "{refused}");
    assert_eq!(fs::metadata(&table).unwrap().len(), 0);
    drop(other);

    // Several threads compete. Only one thread writes at any time, and no case is solved twice.
    std::thread::scope(|scope| {
        for _ in 0..4 {
            scope.spawn(|| {
                loop {
                    match run_study(&format!("{SMALL} --threads 1 --out {table}")) {
                        Err(Failure::Busy(_)) => std::thread::yield_now(),
                        outcome => break outcome.unwrap(),
                    }
                }
            });
        }
    });
    assert_eq!(fs::read_to_string(&table).unwrap().lines().count(), 2 + 12);
    run_study(&format!("--merge {merged} {table}")).unwrap();
    assert!(fs::read(&merged).unwrap() == expected);
}

/// The numbers read from the table are bitwise identical to the numbers of the solutions.
#[test]
fn study_table_matches_library_bitwise() {
    let folder = new_folder("numbers");
    let table = String::from_utf8(whole_table(&folder)).unwrap();
    // The case has pressure 0.1, seed 2 and friction 0.4.
    let number = |name: &str| entry(&table, 8, name).parse::<f64>().unwrap();
    let key = ["case", "pressure", "seed", "friction"].map(number);
    assert_eq!(key, [8.0, 0.1, 2.0, 0.4]);

    let grid = Grid::square(16, 1.0).unwrap();
    let material = Material::new(1.0, 0.3).unwrap();
    let pair = ElasticPair::new(material, material).unwrap();
    let bodies = HalfSpace::with_boundary(grid, pair, Boundary::Periodic).unwrap();
    let rough = SelfAffine::with_rms_slope(1.0).roll_off_wavelength(0.25);
    let rough = rough
        .cut_off_wavelength(0.25)
        .seed(2)
        .generate(grid)
        .unwrap();
    let gap = surface::gap_from_heights(rough.heights()).unwrap();
    let force = 0.1 * pair.contact_modulus();
    let normal = NormalProblem::builder(&bodies, &gap, NormalLoad::Force(force)).tolerance(1e-6);
    let normal = kit::solve(normal);
    let load = TangentialLoad::force([0.1 * force, 0.0]);
    let friction = Friction::coulomb(0.4).unwrap();
    let shear = TangentialProblem::builder(&bodies, &normal, friction, load).tolerance(1e-6);
    let shear = kit::solve(shear);
    assert_eq!(number("contact_area"), normal.contact_area());
    assert_eq!(
        number("contact_area_corrected"),
        normal.contact_area_corrected()
    );
    assert_eq!(
        number("mean_gap"),
        normal.gap().integral() / rough.rms_height()
    );
    assert_eq!(number("stick_ratio"), shear.stick_ratio());
    assert_eq!(number("shift"), shear.shift()[0] / rough.rms_height());
    for (solve, report) in [("normal", normal.report()), ("tangential", shear.report())] {
        let status = entry(&table, 8, &format!("{solve}_status"));
        assert_eq!(status, "converged");
        assert_eq!(number(&format!("{solve}_residual")), report.residual);
        assert_eq!(
            number(&format!("{solve}_energy_error")),
            report.energy_error_bound()
        );
        let products = ["double", "single"].map(|kind| number(&format!("{solve}_{kind}_products")));
        assert_eq!(products[0] + products[1], report.products() as f64);
    }
}

#[test]
fn study_unsolved_cases_have_a_row_with_status() {
    let folder = new_folder("unsolved");
    let [table, merged] = paths(&folder, ["table.csv", "merged.csv"]);
    for (options, expected) in [
        (
            "--iterations 1",
            ["", "stopped at the iteration limit", "not solved"],
        ),
        (
            "--pull 0.3 --frictions 0.2",
            ["", "converged", "beyond the friction capacity"],
        ),
    ] {
        let _ = fs::remove_file(&table);
        run_study(&format!("{SMALL} {options} --out {table}")).unwrap();
        run_study(&format!("--merge {merged} {table}")).unwrap();
        let text = fs::read_to_string(&merged).unwrap();
        for case in 1..=text.lines().count() - 2 {
            let names = ["stick_ratio", "normal_status", "tangential_status"];
            assert_eq!(names.map(|name| entry(&text, case, name)), expected);
            let is_empty = entry(&text, case, "contact_area").is_empty();
            assert_eq!(is_empty, expected[1] != "converged");
        }
    }
}

#[test]
fn study_table_of_another_study_is_rejected() {
    let folder = new_folder("refused");
    let expected = whole_table(&folder);
    let [whole, other, merged] = paths(&folder, ["whole.csv", "other.csv", "merged.csv"]);
    let table = fs::read(&whole).unwrap();

    // A different setting is rejected in a study and in a merge, and a file of a different type is also rejected. No
    // file is changed.
    let refused = run_study(&format!("{SMALL} --tolerance 1e-5 --out {whole}")).unwrap_err();
    assert!(matches!(&refused, Failure::OtherStudy { .. }), "{refused}");
    complain(&refused);
    run_study(&format!("{SMALL} --tolerance 1e-5 --out {other}")).unwrap();
    let refused = run_study(&format!("--merge {merged} {whole} {other}")).unwrap_err();
    assert!(matches!(refused, Failure::OtherStudy { .. }), "{refused}");
    fs::write(&other, "some notes").unwrap();
    let refused = run_study(&format!("{SMALL} --out {other}")).unwrap_err();
    assert!(matches!(refused, Failure::OtherStudy { .. }), "{refused}");
    let refused = run_study(&format!("--merge {merged} {other}")).unwrap_err();
    assert!(
        matches!(refused, Failure::Damaged { line: 1, .. }),
        "{refused}"
    );
    assert!(fs::read(&whole).unwrap() == table && fs::read(&other).unwrap() == b"some notes");

    let text = String::from_utf8(table.clone()).unwrap();
    let lines: Vec<_> = text.lines().collect();
    // Tables whose rows are missing or contradict each other are rejected, and the merged table remains unchanged.
    fs::write(&whole, format!("{}\n", lines[..12].join("\n"))).unwrap();
    let refused = run_study(&format!("--merge {merged} {whole}")).unwrap_err();
    assert!(
        matches!(
            refused,
            Failure::Missing {
                missing: 2,
                total: 12,
                ..
            }
        ),
        "{refused}"
    );
    let words: Vec<_> = lines[4].split(',').collect();
    fs::write(&whole, text.replace(words[11], "1.5")).unwrap();
    fs::write(&other, &table).unwrap();
    let refused = run_study(&format!("--merge {merged} {whole} {other}")).unwrap_err();
    assert!(matches!(refused, Failure::Disagreement { .. }), "{refused}");
    assert!(fs::read(&merged).unwrap() == expected);
    // Duplicate rows are accepted.
    run_study(&format!("--merge {merged} {other} {other} {merged}")).unwrap();
    assert!(fs::read(&merged).unwrap() == expected);
}

#[test]
fn study_invalid_arguments_are_rejected() {
    for line in [
        "--case 3",
        "--out",
        "--cells 0",
        "--cells many",
        "--seeds 3-1",
        "--seeds 1-2,2",
        "--seeds 1-99999999999",
        "--pressures 0.1,-0.1",
        "--pressures 0.1,0.1",
        "--frictions 0",
        "--hursts 1.5",
        "--pull nan",
        "--cut-off 1",
        "--cut-off 30",
        "--roll-off 2",
        "--tolerance 1",
        "--iterations 0",
        "--threads 0",
        "--shard 0/2",
        "--shard 3/2",
        "--shard 1",
        "--merge",
        "--merge all.csv",
    ] {
        let refused = run_study(line).unwrap_err();
        assert!(
            matches!(refused, Failure::Arguments(_)),
            "{line}: {refused}"
        );
    }
}
