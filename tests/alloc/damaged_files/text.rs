//! Damaged CSV, XYZ and text SDF files.

use stickslip::{Field, Result, io};

use super::{Parse, assert_rejected};

pub(crate) fn parse_csv(bytes: &[u8]) -> Result<Field> {
    io::csv::parse(bytes, [1.0, 1.0])
}

#[test]
fn damaged_csv_files_are_rejected() {
    for (file, expected) in [
        ("", "CSV, on line 1: the file contains no numbers"),
        (
            "\n# nothing\n\n",
            "CSV, on line 1: the file contains no numbers",
        ),
        (
            "1,2\n3,4,5\n",
            "CSV, on line 2: the line must have 2 cells, as the previous lines, but it has 3",
        ),
        (
            "# x\n1,2,3\n\n4,5\n",
            "CSV, on line 4: the line must have 3 cells, as the previous lines, but it has 2",
        ),
        (
            "1 2\n3\n",
            "CSV, on line 2: the line must have 2 cells, as the previous lines, but it has 1",
        ),
        (
            "x,y\n1,2\n",
            "CSV, on line 1: \"x\" in column 1 is not a number",
        ),
        (
            "1;2\n3;4,5,6\n",
            "CSV, on line 2: \"4,5,6\" in column 2 is not a number",
        ),
        (
            "1;1.234,5\n",
            "CSV, on line 1: \"1.234,5\" in column 2 is not a number",
        ),
        (
            "1,2\n3,1e999\n",
            "CSV, on line 2: \"1e999\" in column 2 exceeds the range of double precision",
        ),
        (
            "1 2\n3 0x10\n",
            "CSV, on line 2: \"0x10\" in column 2 is not a number",
        ),
        (
            "1 2\n3 4*\n",
            "CSV, on line 2: \"4*\" in column 2 is not a number",
        ),
        (
            "1,2 3,4,5\n",
            "CSV, on line 1: \"2 3\" in column 2 is not a number",
        ),
    ] {
        assert_rejected(file.as_bytes(), parse_csv, expected);
    }
    let binary: Vec<u8> = (0..=255).rev().collect();
    assert_rejected(&binary, parse_csv, "CSV, on line 1: \"");
    let endless = vec![b'7'; 100_000];
    kit::assert_refused! {
        // A number of 100000 digits overflows.
        parse_csv(&endless) => _,
    }
    assert_rejected(
        &endless,
        parse_csv,
        "CSV, on line 1: \"77777777777777777777777777777777\" in column 1 exceeds the range",
    );
    let wide = b"1,".repeat(50_000);
    assert_eq!(parse_csv(&wide).unwrap().grid().nx(), 50_000);
    let mut ragged = wide.clone();
    ragged.extend_from_slice(b"\n1");
    assert_rejected(
        &ragged,
        parse_csv,
        "CSV, on line 2: the line must have 50001 cells, as the previous lines, but it has 1",
    );
}

#[test]
fn valid_text_matrices_are_read() {
    let nan = f64::NAN;
    for (file, width, samples) in [
        ("1;2;\n3;4;\n", 2, vec![1.0, 2.0, 3.0, 4.0]),
        ("1;2;\n3;4;5\n", 3, vec![1.0, 2.0, nan, 3.0, 4.0, 5.0]),
        ("\u{feff}% c\r\n1,5 -2,5\r\n", 2, vec![1.5, -2.5]),
        ("1, 2, 3\n", 3, vec![1.0, 2.0, 3.0]),
        ("1,5\n", 2, vec![1.0, 5.0]),
        ("1\t\t3\n\t\t\n", 3, vec![1.0, nan, 3.0, nan, nan, nan]),
        ("  1   +2e0 \n  BAD .5\n", 2, vec![1.0, 2.0, nan, 0.5]),
        ("***,NaN,,bad\n", 4, vec![nan; 4]),
        ("-inf infinity", 2, vec![f64::NEG_INFINITY, f64::INFINITY]),
    ] {
        let field = parse_csv(file.as_bytes()).unwrap();
        assert_eq!(field.grid().nx(), width, "{file:?}");
        assert_eq!(field.as_slice().len(), samples.len(), "{file:?}");
        for (a, b) in field.as_slice().iter().zip(samples) {
            assert!(
                a.to_bits() == b.to_bits() || a.is_nan() && b.is_nan(),
                "{file:?}"
            );
        }
    }
}

#[test]
fn damaged_xyz_files_are_rejected() {
    let sparse = "XYZ, in all points: the points are too few for a regular grid: ";
    for (file, expected) in [
        ("", "XYZ, on line 1: the file contains no points"),
        ("0 0\n", "XYZ, on line 1: a point requires three cells"),
        (
            "0 0 1\n0 1 2 3\n",
            "XYZ, on line 2: the line must have 3 cells, as the previous lines, but it has 4",
        ),
        ("0 0 1\n0 x 2\n", "XYZ, on line 2: \"x\" is not a number"),
        (
            "0 0 1\n0 nan 2\n",
            "XYZ, on line 2: the position of a point must be finite",
        ),
        (
            "0 0 1\n-inf 0 2\n",
            "XYZ, on line 2: the position of a point must be finite",
        ),
        (
            "5 5 1\n",
            "XYZ, in all points: the number of positions must be at least 2 to define a spacing, got 1",
        ),
        (
            "5 5 1\n5 5 1\n",
            "XYZ, in all points: the number of positions must be at least 2 to define a spacing, got 1",
        ),
        (
            "0 0 1\n1 0 2\n# again\n0 0 3\n",
            "XYZ, on line 4: the position (0, 0) is already the position of an earlier point",
        ),
        (
            "0 0 1\n1 0 2\n0 0 nan\n",
            "XYZ, on line 3: the position (0, 0) is already the position of an earlier point",
        ),
        (
            "0 0 1\n1 0 2\n2.3 0 3\n3.3 0 3\n",
            "XYZ, on line 2: the position (1, 0) deviates by more than 5 % from the regular grid",
        ),
        ("0 0 1\n1 0 2\n900 0 3\n", sparse),
        (
            "0 0 1\n1 0 2\n1e12 0 3\n",
            "XYZ, on line 2: the position (1, 0) is already the position of an earlier point",
        ),
        ("-1e308 0 1\n1e308 1 2\n", sparse),
        ("0 0 1\n1 1 2\n2 50 3\n", sparse),
        ("-1e308 0 1\n1e308 0 2\n", sparse),
        (
            "0 0 1\n5e-324 0 2\n",
            "XYZ, in all points: cell area must be positive and finite",
        ),
        (
            "0 0 1\n1e200 0 2\n",
            "XYZ, in all points: cell area must be positive and finite",
        ),
    ] {
        assert_rejected(file.as_bytes(), io::xyz::parse, expected);
    }
    // A diagonal of n points spans a grid of n x n positions.
    let diagonal: String = (0..2000).map(|i| format!("{i} {i} 0\n")).collect();
    assert_rejected(
        diagonal.as_bytes(),
        io::xyz::parse,
        "XYZ, in all points: the points are too few for a regular grid: 2000 points for 2000 x 2000 positions",
    );
}

#[test]
fn valid_lists_of_points_are_read() {
    // The points are unordered, and their spacing is a third of a unit rounded to two decimals. Two columns are empty
    // and one height is missing.
    let file = "0.33,2,1\n0,2,2\n1.67,0,3\n0,0,\n";
    let field = io::xyz::parse(file.as_bytes()).unwrap();
    let grid = field.grid();
    assert_eq!([grid.nx(), grid.ny()], [6, 2]);
    assert!((grid.dx() - 0.334).abs() < 1e-12 && (grid.dy() - 2.0).abs() < 1e-12);
    let measured = [(5, 0, 3.0), (1, 1, 1.0), (0, 1, 2.0)];
    for (ix, iy, height) in measured {
        assert!((field.get(ix, iy).unwrap() - height).abs() < 1e-15);
    }
    let missing = field.as_slice().iter().filter(|z| z.is_nan()).count();
    assert_eq!(missing, 12 - measured.len());

    let row = io::xyz::parse(b"7 3 1\n7 5 2\n").unwrap();
    let grid = row.grid();
    assert_eq!([grid.nx(), grid.ny()], [1, 2]);
    assert!(
        (grid.dx() - 2.0).abs() < 1e-15,
        "the spacing of the other axis"
    );
}

#[test]
fn damaged_text_sdf_files_are_rejected() {
    let header = "aISO-1.0\nNumPoints = 2\nNumProfiles = 2\nXscale = 1\nYscale = 1\nZscale = 1\n";
    let without = |name: &str| {
        let lines = header.lines().filter(|line| !line.starts_with(name));
        lines
            .chain(["*", "1 2 3 4", "*"])
            .collect::<Vec<_>>()
            .join("\n")
    };
    let with = |line: &str| format!("{header}{line}\n*\n1 2 3 4\n*\n");
    assert!(io::sdf::parse(with("").as_bytes()).is_ok());
    for (file, expected) in [
        (
            "aISO-1.0".into(),
            "SDF, on line 1: the header does not end with a line `*`",
        ),
        (
            header.into(),
            "SDF, on line 1: the header does not end with a line `*`",
        ),
        (
            with("nonsense"),
            "SDF, on line 7: a header line must have the form Name = Value",
        ),
        (
            with("NumPoints = -2"),
            "SDF, on line 7: NumPoints = \"-2\" is not a valid number",
        ),
        (
            with("NumPoints = 2.5"),
            "SDF, on line 7: NumPoints = \"2.5\" is not a valid number",
        ),
        (
            with("NumPoints = 0"),
            "SDF, on line 8: the grid must have at least one cell along each axis, got 0 x 2 cells",
        ),
        (
            with("NumPoints = 9999999999999999999"),
            "SDF, on line 8: cannot allocate 2384185791015.6 GiB for a padded grid",
        ),
        (
            with("NumProfiles = 1000000000"),
            "SDF, on line 10: the file contains 4 samples, expected 1000000000 profiles",
        ),
        (
            with("Xscale = none"),
            "SDF, on line 7: Xscale = \"none\" is not a valid number",
        ),
        (
            with("Xscale = nan"),
            "SDF, on line 8: cell side dx must be positive and finite",
        ),
        (
            with("Yscale = 0"),
            "SDF, on line 8: cell side dy must be positive and finite, got 0",
        ),
        (
            with("Zscale = -1"),
            "SDF, on line 8: Zscale must be positive and finite, got -1",
        ),
        (
            with("Compression = 1"),
            "SDF, on line 7: Compression \"1\" is not supported",
        ),
        (
            with("CheckType = 7"),
            "SDF, on line 7: CheckType \"7\" is not supported",
        ),
        (
            without("NumPoints"),
            "SDF, on line 6: the header has no NumPoints",
        ),
        (
            without("NumProfiles"),
            "SDF, on line 6: the header has no NumProfiles",
        ),
        (
            without("Xscale"),
            "SDF, on line 6: the header has no Xscale",
        ),
        (
            without("Yscale"),
            "SDF, on line 6: the header has no Yscale",
        ),
        (
            without("Zscale"),
            "SDF, on line 6: the header has no Zscale",
        ),
        (
            format!("{header}*\n1 2 3\n"),
            "SDF, on line 8: the file contains 3 samples, expected 2 profiles of 2 points",
        ),
        (
            format!("{header}*\n1 2 3 4 5 *\n"),
            "SDF, on line 8: the file contains 5 samples, expected 2 profiles",
        ),
        (
            format!("{header}*\n1 2 3 GOOD\n"),
            "SDF, on line 8: \"GOOD\" is not a number",
        ),
    ] {
        assert_rejected(file.as_bytes(), io::sdf::parse, expected);
    }
}

#[test]
fn compressed_files_are_rejected_with_the_program() {
    let gzip = b"\x1f\x8b\x08\x08\x00\x00\x00\x00\x00\x03heights.csv\x00".as_slice();
    let programs = [
        (gzip, "gzip"),
        (b"PK\x03\x04\x14\x00\x00\x00\x08\x00heights.csv", "zip"),
        (b"BZh91AY&SY\x01\x02\x03\x04", "bzip2"),
        (b"\xfd7zXZ\x00\x00\x04\xe6\xd6\xb4\x46", "xz"),
        (b"\x28\xb5\x2f\xfd\x04\x00\x41\x00\x00", "zstd"),
    ];
    let parsers: [(Parse, &str); 5] = [
        (parse_csv, "CSV"),
        (io::xyz::parse, "XYZ"),
        (io::asc::parse, "ASC"),
        (io::sdf::parse, "SDF"),
        (io::sur::parse, "SUR"),
    ];
    for (bytes, program) in programs {
        for (parse, format) in parsers {
            let expected = format!(
                "{format}, at byte 0: the data are compressed by {program}: decompress them first"
            );
            assert_rejected(bytes, parse, &expected);
        }
    }
    let parse_npy: Parse = |bytes| io::npy::parse(bytes, [1.0, 1.0]);
    assert_rejected(
        gzip,
        parse_npy,
        "NPY, at byte 0: the data are compressed by gzip",
    );
    assert_rejected(
        programs[1].0,
        parse_npy,
        "NPY, at byte 0: the file is a zip archive, as an NPZ file: save one array by numpy.save",
    );
    #[cfg(feature = "x3p")]
    assert_rejected(
        gzip,
        io::x3p::parse,
        "X3P, at byte 0: the data are compressed by gzip",
    );
}

#[test]
fn commas_that_may_be_decimal_commas_are_rejected() {
    for (file, expected) in [
        (
            "0,05,1,5\n0,7,-1,25\n",
            "CSV, on line 1: \"05\" in column 2 begins with a zero, and all cells are whole numbers: if the commas are decimal \
             commas, separate the cells by semicolons or tabs",
        ),
        (
            "1,5,2,25,\n1,0,2,007,\n",
            "CSV, on line 2: \"007\" in column 4 begins with a zero",
        ),
        (
            "1,5,2,25\n1,2,25\n",
            "CSV, on line 2: the line must have 4 cells, as the previous lines, but it has 3: if the commas are decimal commas",
        ),
    ] {
        assert_rejected(file.as_bytes(), parse_csv, expected);
    }
    // These cells cannot be digits after a comma, or no digits show that they are.
    for file in [
        "1,5,2,5\n3,7,4,5\n",
        "01,05\n07,08\n",
        "0.5,05\n1.5,07\n",
        "1,05\n3,-7\n",
        "1;05\n2;07\n",
        "1,05,9\n2,07,9\n",
    ] {
        assert!(parse_csv(file.as_bytes()).is_ok(), "{file}");
    }
}
