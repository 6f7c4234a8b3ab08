//! Files written or verified by other programs are read as these programs read them. The file tests/data/README.md
//! lists the program behind each file.

use std::path::PathBuf;

use stickslip::{Error, Field, Grid, Result, io};

/// Points and spacings (micrometres) of the surface that all files contain.
const SIZE: [usize; 2] = [5, 4];
const SPACING: [f64; 2] = [0.5, 0.25];
const MISSING: [usize; 2] = [3, 1];

fn data_path(name: &str) -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR"))
        .join("../data/files")
        .join(name)
}

/// Returns the height of a point in micrometres.
fn height(ix: usize, iy: usize) -> f64 {
    ix as f64 / 4.0 - iy as f64 / 2.0 + (ix * iy) as f64 / 8.0
}

/// Checks that a field is the surface in the given unit (micrometres), up to a constant if `is_shifted`.
fn assert_is_surface(
    name: &str,
    field: &Result<Field>,
    unit: f64,
    tolerance: f64,
    is_shifted: bool,
) {
    let field = field.as_ref().unwrap_or_else(|e| panic!("{name}: {e}"));
    let grid = field.grid();
    assert_eq!([grid.nx(), grid.ny()], SIZE, "{name}");
    for (found, expected) in [grid.dx(), grid.dy()].iter().zip(SPACING) {
        assert!((found * unit - expected).abs() < 1e-7 * expected, "{name}");
    }
    let scale = if name.contains("eighths") { 8.0 } else { 1.0 };
    let shift = if is_shifted {
        field.as_slice()[0] * unit - scale * height(0, 0)
    } else {
        0.0
    };
    for iy in 0..SIZE[1] {
        for ix in 0..SIZE[0] {
            let found = field.get(ix, iy).unwrap() * unit;
            if [ix, iy] == MISSING && !name.contains("whole") {
                assert!(found.is_nan(), "{name}: {found} at ({ix}, {iy})");
            } else {
                let error = found - shift - scale * height(ix, iy);
                assert!(error.abs() <= tolerance, "{name}: {error} at ({ix}, {iy})");
            }
        }
    }
}

#[test]
fn npy_of_numpy_is_read() {
    for name in [
        "f8.npy",
        "f4_big_fortran.npy",
        "i2_eighths_whole.npy",
        "i1_eighths_whole.npy",
    ] {
        assert_is_surface(
            name,
            &io::npy::read(data_path(name), SPACING),
            1.0,
            0.0,
            false,
        );
    }
    // The numbers are unsigned, so one hundred is added in the file.
    let name = "u8_big_whole.npy";
    let field = io::npy::read(data_path(name), SPACING).unwrap();
    let eighths = |z: &f64| (z - 100.0) / 8.0;
    let samples = field.as_slice().iter().map(eighths).collect();
    let field = Field::from_vec(field.grid(), samples);
    assert_is_surface(name, &field, 1.0, 0.0, false);
}

/// Parses an NPY file of two numbers of the given type, with the header required by the format.
fn parse_npy_of(kind: &str, numbers: &[u8]) -> Result<Field> {
    let header = format!("{{'descr': '{kind}', 'fortran_order': False, 'shape': (1, 2), }}\n");
    let length = u16::try_from(header.len()).unwrap().to_le_bytes();
    let parts: [&[u8]; 4] = [b"\x93NUMPY\x01\x00", &length, header.as_bytes(), numbers];
    // The limits of integers may mark missing points.
    let options = io::npy::Options::default().missing(f64::NAN);
    options.parse(&parts.concat(), [1.0, 1.0])
}

/// Covers the smallest and the largest value of every integer type, in both byte orders.
#[test]
fn npy_of_every_integer_type_is_read() {
    macro_rules! check {
        ($($number:ty: $kind:literal),*) => {$(
            let ends = [<$number>::MIN, <$number>::MAX];
            let expected = ends.map(|end| i128::from(end) as f64);
            for (order, bytes) in [
                ("<", ends.map(<$number>::to_le_bytes)),
                (">", ends.map(<$number>::to_be_bytes)),
            ] {
                let kind = format!("{order}{}", $kind);
                let field = parse_npy_of(&kind, bytes.as_flattened()).unwrap();
                assert_eq!(field.as_slice(), expected, "{kind}");
            }
        )*};
    }
    check!(i8: "i1", i16: "i2", i32: "i4", i64: "i8", u8: "u1", u16: "u2", u32: "u4", u64: "u8");
}

#[test]
fn text_matrices_are_read() {
    for name in ["spaces.asc", "commas.csv", "tabs_decimal_commas.txt"] {
        assert_is_surface(
            name,
            &io::csv::read(data_path(name), SPACING),
            1.0,
            0.0,
            false,
        );
    }
}

#[test]
fn xyz_points_in_any_order_and_with_a_gap_are_read() {
    for name in ["shuffled_whole.xyz", "gap.xyz"] {
        assert_is_surface(name, &io::xyz::read(data_path(name)), 1.0, 1e-15, false);
        assert_is_surface(name, &io::read(data_path(name)), 1.0, 1e-15, false);
    }
}

#[test]
fn sdf_of_both_forms_and_all_number_types_is_read() {
    for (name, tolerance) in [
        ("f8.sdf", 1e-15),
        ("text.sdf", 1e-9),
        ("i2.sdf", 1e-15),
        ("i4.sdf", 1e-15),
        ("f4.sdf", 1e-15),
    ] {
        assert_is_surface(name, &io::sdf::read(data_path(name)), 1e6, tolerance, false);
        assert_is_surface(name, &io::read(data_path(name)), 1e6, tolerance, false);
    }
}

#[test]
fn sur_of_16_and_32_bits_is_read() {
    for (name, tolerance) in [("i4.sur", 1e-7), ("i2_eighths_whole.sur", 1e-12)] {
        assert_is_surface(name, &io::sur::read(data_path(name)), 1e6, tolerance, true);
        assert_is_surface(name, &io::read(data_path(name)), 1e6, tolerance, true);
    }
}

#[cfg(feature = "x3p")]
#[test]
fn x3p_of_every_number_type_is_read() {
    for (name, tolerance) in [
        // The tolerance is half a step if the range of 2.875 micrometres is divided into 65535 steps.
        ("I.x3p", 2.3e-5),
        ("L.x3p", 1e-9),
        ("F.x3p", 1e-7),
        ("D.x3p", 1e-15),
        ("surfalize.x3p", 1e-15),
        ("list.x3p", 1e-15),
    ] {
        assert_is_surface(name, &io::x3p::read(data_path(name)), 1e6, tolerance, false);
        assert_is_surface(name, &io::read(data_path(name)), 1e6, tolerance, false);
    }
}

#[cfg(not(feature = "x3p"))]
#[test]
fn x3p_without_its_feature_is_an_error() {
    let error = io::read(data_path("I.x3p")).unwrap_err().to_string();
    let message = "I.x3p: X3P, at byte 0: reading X3P files requires the cargo feature `x3p`";
    assert!(error.ends_with(message), "{error}");
}

#[test]
fn unrecognised_file_is_rejected_with_its_remedy() {
    for (name, remedy) in [
        ("f8.npy", "read it as NPY"),
        ("commas.csv", "read it as CSV"),
    ] {
        let error = io::read(data_path(name)).unwrap_err();
        assert!(matches!(error, Error::Format { .. }), "{error}");
        // The output of `fn main() -> Result<()>` names the file and the remedy.
        for said in [error.to_string(), format!("{error:?}")] {
            assert!(said.contains(name) && said.contains(remedy), "{said}");
        }
    }
    let damaged = io::npy::read(data_path("commas.csv"), [1.0; 2]).unwrap_err();
    assert!(
        damaged.to_string().contains("commas.csv: NPY, at byte 0"),
        "{damaged}"
    );
    let error = io::read(data_path("absent.sdf")).err();
    assert!(matches!(error, Some(Error::File { path, .. }) if path.ends_with("absent.sdf")));
}

/// The header of a SPIP file gives the sides, the unit and the missing points of the surface. The parser does not guess
/// these data.
#[test]
fn asc_header_determines_sides_unit_and_missing_points() {
    let header = |more: &str| {
        format!(
            "# File Format = ASCII\r\n# Created by SPIP\r\n# x-pixels = 3\r\n# y-pixels = 2\r\n\
             # x-length = 600\r\n# y-length = 300\r\n{more}# Start of Data:\r\n"
        )
    };
    let heights = "1\t2\t-32768\r\n4\t5\t6\r\n";
    let file = header("# z-unit = um\r\n# voidpixels = -32768\r\n") + heights;
    let by_value = io::asc::parse(file.as_bytes()).unwrap();
    let sides = [by_value.grid().dx(), by_value.grid().dy()];
    assert!((sides[0] / 200e-9 - 1.0).abs() < 1e-12 && (sides[1] / 150e-9 - 1.0).abs() < 1e-12);
    assert!((by_value.as_slice()[5] / 6e-6 - 1.0).abs() < 1e-12);
    assert!(by_value.as_slice()[2].is_nan() && !by_value.as_slice()[1].is_nan());
    let file = header("# z-unit = um\r\n# missing value = -32768\r\n") + heights;
    let by_comment = io::asc::parse(file.as_bytes()).unwrap();
    assert!(by_comment.as_slice()[2].is_nan() && !by_comment.as_slice()[1].is_nan());
    // A mask after the heights marks the missing points. A repeated value alone does not mark them.
    let mask = "0 1 0\n0 0 0\n";
    let file = header("# Bit2nm = 1000\r\n# voidpixels = 1\r\n") + heights + mask;
    let by_mask = io::asc::parse(file.as_bytes()).unwrap();
    let missing: Vec<bool> = by_mask.as_slice().iter().map(|z| z.is_nan()).collect();
    assert_eq!(missing, [false, true, false, false, false, false]);
    assert!((by_mask.as_slice()[5] / by_value.as_slice()[5] - 1.0).abs() < 1e-12);

    let problem = |file: &str| io::asc::parse(file.as_bytes()).unwrap_err().to_string();
    // Without a mask, the number of missing points does not determine their positions.
    let which = problem(&(header("# z-unit = nm\n# voidpixels = 2\n") + heights));
    assert!(which.contains("no mask"), "{which}");
    let mut latin = (header("# z-unit = @m\n") + heights).into_bytes();
    let place = latin.iter().position(|&byte| byte == b'@').unwrap();
    latin[place] = 0xb5;
    let micro = io::asc::parse(&latin).unwrap();
    assert!((micro.as_slice()[5] / 6e-6 - 1.0).abs() < 1e-12);

    let none = problem(&(header("") + heights));
    assert!(
        none.contains("Bit2nm") && none.contains("does not contain"),
        "{none}"
    );
    let unknown = problem(&(header("# z-unit = furlong\n") + heights));
    assert!(unknown.contains("furlong"), "{unknown}");
    let short = problem(&(header("# z-unit = nm\n") + "1 2 3\n"));
    assert!(
        short.contains("3 numbers, expected 3 x 2 heights"),
        "{short}"
    );
    let huge = header("# z-unit = nm\n").replace("x-pixels = 3", "x-pixels = 4000000000");
    assert!(problem(&huge).contains("do not fit"));
    let half = header("# z-unit = nm\n").replace("x-pixels = 3", "x-pixels = 2.5");
    assert!(problem(&half).contains("2.5"));

    // Reading the file as a plain matrix would lose the header. The parser rejects the file and states the remedy,
    // unless options request a matrix.
    let file = header("# z-unit = nm\n") + heights;
    let refused = io::csv::parse(file.as_bytes(), [1.0, 1.0])
        .unwrap_err()
        .to_string();
    assert!(refused.contains("read the file as ASC"), "{refused}");
    let options = io::csv::Options::default().missing(-32768.0);
    let plain = options.parse(file.as_bytes(), [1.0, 1.0]).unwrap();
    assert!(plain.as_slice()[2].is_nan() && plain.as_slice()[0] == 1.0);
}

/// A single largest or smallest height is a spike, the levels of a pattern are equal in many cells, and pressures are zero outside a
/// contact.
#[test]
fn repeated_extreme_heights_are_rejected_as_marks() {
    let csv = |text: &str| io::csv::parse(text.as_bytes(), [1.0, 1.0]);
    for (text, count) in [
        ("1000 1000 1.5 2\n3 2.5 1000 1000\n", 4),
        ("1.5 2 2.5\n3 -1000000 4\n", 1),
    ] {
        let refused = csv(text).unwrap_err().to_string();
        let expected = format!("{count} number");
        assert!(
            refused.contains(&expected) && refused.contains("may mark missing points"),
            "{refused}"
        );
    }
    for text in [
        "1000 1.5 2\n3 2.5 1\n",
        "2 2 2 2\n2 2 2 1\n1 1 1 1\n",
        "0.1 0.1 0.1 0.1\n0.3 0.3 0.31 0.31\n",
        "0 0 0 0\n7 7.5 7.2 8\n",
        "5 5 5 5\n1 2 3 4\n",
    ] {
        assert!(csv(text).is_ok());
    }
}

#[test]
fn unstated_marks_of_missing_points_are_rejected() {
    let csv = |missing: Option<f64>, text: &str| {
        let options = io::csv::Options::default();
        let options = missing.map_or(options, |mark| options.missing(mark));
        options.parse(text.as_bytes(), [1.0, 1.0])
    };
    for mark in [
        "-9999",
        "-99999.0",
        "32767",
        "-32768",
        "1.70141E+38",
        "-1e30",
        "-3.4028235e38",
        "-3.4028234663852886e+38",
        "-2147483648",
        "-10000",
        "65535",
        "100000",
        "2147483647",
        "4294967295",
        "1e20",
        "1.00000002004087734e+20",
        "-3.40282306073709653e+38",
        "-3.40282346600000016e+38",
        "3.40282e38",
        "-3.4028e38",
        "-1.797e308",
        "-1.79769313486231571e+308",
        "-1.70141183460469232e+38",
        "9.96921e36",
    ] {
        let text = format!("1.5 2.5\n{mark} 4\n{mark} 5\n");
        let refused = csv(None, &text).unwrap_err().to_string();
        let number: f64 = mark.parse().unwrap();
        let expected = format!("2 numbers with the value {number:?} may mark missing points");
        assert!(refused.contains(&expected), "{refused}");
        let heights = csv(Some(number), &text).unwrap();
        assert!(heights.as_slice()[2].is_nan() && heights.as_slice()[4].is_nan());
        // NaN states that all numbers are heights.
        assert_eq!(csv(Some(f64::NAN), &text).unwrap().as_slice()[2], number);

        let points = format!("0 0 1.5\n1 0 2.5\n0 1 {mark}\n1 1 {mark}\n");
        let refused = io::xyz::parse(points.as_bytes()).unwrap_err().to_string();
        assert!(refused.contains(&expected), "{refused}");
        let options = io::xyz::Options::default().missing(number);
        assert!(options.parse(points.as_bytes()).unwrap().as_slice()[2].is_nan());

        let grid = Grid::new(2, 3, 1.0, 1.0).unwrap();
        let samples = vec![1.5, 2.5, number, 4.0, number, 5.0];
        let array = io::npy::to_bytes(&Field::from_vec(grid, samples).unwrap());
        let refused = io::npy::parse(&array, [1.0, 1.0]).unwrap_err().to_string();
        assert!(refused.contains(&expected), "{refused}");
        let npy = |mark| {
            io::npy::Options::default()
                .missing(mark)
                .parse(&array, [1.0, 1.0])
        };
        assert!(npy(number).unwrap().as_slice()[4].is_nan());
        assert_eq!(npy(f64::NAN).unwrap().as_slice()[4], number);
    }
    // One mark with different numbers of digits.
    let lowest = "1.5 2\n-3.4028235e38 -3.40282306073709653e+38\n";
    let heights = csv(Some(f64::from(f32::MIN)), lowest).unwrap();
    assert!(heights.as_slice()[2..].iter().all(|z| z.is_nan()));
    // The file contains another mark than the given one.
    for (mark, text) in [
        (Some(-999.0), "1.5 2.5\n-9999 4\n"),
        (None, "# missing = -999\n1.5 2.5\n-9999 -999\n"),
    ] {
        let refused = csv(mark, text).unwrap_err().to_string();
        let expected = "1 number with the value -9999.0 may mark missing points, besides the mark -999.0: set the option missing to \
                        -9999.0, or to NaN to read all numbers as heights";
        assert!(refused.contains(expected), "{refused}");
    }
    // Spikes do not hide a mark.
    let spiked = "1.5 2 3 1\n2 3.5 4 1\n-9999 4 3 -1e5\n3 2.5 1 1e5\n";
    let refused = csv(None, spiked).unwrap_err().to_string();
    assert!(refused.contains("value -9999.0"), "{refused}");
    // Heights of this magnitude are valid, and so are rare numbers far from the others.
    for text in [
        "-9999 -9100\n-8200.5 -7000\n",
        "1 2\n-9998 3\n",
        "-10000 -9100\n-8200.5 -7000\n",
        "65535 60000\n52000 64000\n",
        "100000 91000\n85000 99000\n",
        "2147483647 2000000000\n1500000000 1900000000\n",
        "4294967295 4200000000\n3500000000 3900000000\n",
        "999 999\n",
        "1e30 2e30\n",
        "1e29 -4e29\n1.1e30 8e29\n",
    ] {
        assert!(csv(None, text).is_ok(), "{text}");
    }
}

#[test]
fn quoted_numbers_are_read() {
    for text in [
        "\"1.5\",\"2\"\n\"\",\" -4 \"\n",
        "\"1,5\";\"2\"\n\"NaN\";\"-4\"\n",
        "\"1,5\" \"2,0\"\n\"NaN\" -4\n",
    ] {
        let heights = io::csv::parse(text.as_bytes(), [1.0, 1.0]).unwrap();
        assert_eq!(heights.as_slice()[..2], [1.5, 2.0], "{text}");
        assert!(heights.as_slice()[2].is_nan() && heights.as_slice()[3] == -4.0);
    }
    let points = b"\"0\",\"0\",\"1.5\"\n\"1\",\"0\",\"2.5\"\n";
    assert_eq!(io::xyz::parse(points).unwrap().as_slice(), [1.5, 2.5]);
    // Commas in quotes would separate cells.
    let refused = io::csv::parse(b"\"1,5\",\"2,5\"\n", [1.0, 1.0]).unwrap_err();
    let expected = "is not a number: write the quoted numbers with decimal points, or separate them by semicolons";
    assert!(refused.to_string().contains(expected), "{refused}");
}

#[test]
fn esri_grids_are_rejected_with_the_options_that_read_them() {
    let header = "ncols 3\r\nnrows 2\r\nxllcorner 0.0\r\nyllcorner 0.0\r\nCELLSIZE 0.5\r\nNODATA_value  -9999\r\n";
    let file = format!("{header}1.5 2 3\r\n4 -9999 6\r\n");
    let expected = "the file is an ESRI ASCII grid: read it as CSV by the options skip_rows = 6 and missing = -9999, and give the \
                    cell side 0.5; its first line has the largest y";
    let path = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("esri.asc");
    std::fs::write(&path, &file).unwrap();
    for refused in [
        io::csv::parse(file.as_bytes(), [0.5, 0.5]),
        io::asc::parse(file.as_bytes()),
        io::xyz::parse(file.as_bytes()),
        io::read(path),
    ] {
        let refused = refused.unwrap_err().to_string();
        assert!(refused.contains(expected), "{refused}");
    }
    let options = io::csv::Options::default().skip_rows(6).missing(-9999.0);
    let heights = options.parse(file.as_bytes(), [0.5, 0.5]).unwrap();
    assert!(heights.as_slice()[4].is_nan() && heights.as_slice()[5] == 6.0);
    // The header may lack the mark.
    let file = "NCOLS 2\nNROWS 1\nXLLCENTER 0\nYLLCENTER 0\nDX 2\nDY 1\n1 2\n";
    let refused = io::csv::parse(file.as_bytes(), [2.0, 1.0]).unwrap_err();
    let expected = "by the option skip_rows = 6, and give the cell sides; its";
    assert!(refused.to_string().contains(expected), "{refused}");
}

#[test]
fn csv_comments_of_missing_values_and_column_names_are_handled() {
    for comment in [
        "# NODATA_value: -9999",
        "# NODATA_value -9999",
        "# nodata: -9999",
        "#nodata=-9999",
        "% No Data Value -9999",
        "# missing -9999",
        "# Missing: -9999",
        "# void = -9999",
        "% missing value = -9999",
        "\u{feff}#bad value=-9999.0",
    ] {
        let text = format!("{comment}\n1 2\n-9999 4\n");
        let heights = io::csv::parse(text.as_bytes(), [1.0, 1.0]).unwrap();
        assert!(heights.as_slice()[2].is_nan(), "{comment}");
        assert_eq!(heights.as_slice()[3], 4.0);
    }
    // Values in other comments are ignored.
    let text = b"# min: -90\n1 2\n-90 4\n";
    assert_eq!(
        io::csv::parse(text, [1.0, 1.0]).unwrap().as_slice()[2],
        -90.0
    );

    let named = b"# profile\nheight,height\n1,2\n3,4\n";
    let refused = io::csv::parse(named, [1.0, 1.0]).unwrap_err().to_string();
    assert!(refused.contains("skip_rows = 2"), "{refused}");
    let heights = io::csv::Options::default()
        .skip_rows(2)
        .parse(named, [1.0, 1.0]);
    assert_eq!(heights.unwrap().as_slice(), [1.0, 2.0, 3.0, 4.0]);
}

#[test]
fn text_in_utf16_is_rejected_with_its_encoding() {
    let text = "1,2,3\n4,5,7\n";
    let little: Vec<u8> = text.encode_utf16().flat_map(u16::to_le_bytes).collect();
    let big: Vec<u8> = text.encode_utf16().flat_map(u16::to_be_bytes).collect();
    let marked = |mark: [u8; 2], bytes: &[u8]| [&mark[..], bytes].concat();
    for bytes in [
        marked([0xff, 0xfe], &little),
        marked([0xfe, 0xff], &big),
        little,
        big,
    ] {
        for result in [io::csv::parse(&bytes, [1.0, 1.0]), io::xyz::parse(&bytes)] {
            let error = result.unwrap_err().to_string();
            assert!(
                error.contains("UTF-16") && error.contains("UTF-8"),
                "{error}"
            );
        }
    }
}

#[test]
fn text_with_words_for_missing_heights_is_read_as_nan() {
    for word in ["No Data", "nodata", "N/A", "null", "BAD", "***"] {
        let text = format!("1 {word}\n3 4\n");
        let heights = io::csv::parse(text.as_bytes(), [1.0, 1.0]).unwrap();
        assert!(
            heights.as_slice()[1].is_nan() && heights.as_slice()[3] == 4.0,
            "{word}"
        );
        let text = format!("0\t0\t1,5\n1\t0\t{word}\n");
        let heights = io::xyz::parse(text.as_bytes()).unwrap();
        assert!(
            heights.as_slice()[0] == 1.5 && heights.as_slice()[1].is_nan(),
            "{word}"
        );
    }
}

#[test]
fn text_of_points_is_recognised_and_xyz_advised() {
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR"));
    for name in ["points.csv", "points.txt"] {
        let path = folder.join(name);
        std::fs::write(&path, "0 0.1 3\n1.3 0.2 3\n0.2 1.7 4\n5 5 5\n").unwrap();
        let error = io::read(&path).unwrap_err().to_string();
        assert!(error.contains("read the file as XYZ"), "{error}");
    }
}

/// Returns 12 by 10 points with spacings of one and two, displaced randomly by up to the given fraction of the spacing.
fn displaced_points(part: f64) -> String {
    let mut state = 1_u32;
    let mut miss = || {
        state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        part * (f64::from(state >> 8) / f64::from(1 << 23) - 1.0)
    };
    let places = (0..120).map(|cell| (cell % 12, cell / 12));
    let point = |(ix, iy): (i32, i32)| {
        let (x, y) = (f64::from(ix) + miss(), 2.0 * (f64::from(iy) + miss()));
        format!("{x} {y} {}\n", 100 * iy + ix)
    };
    places.map(point).collect()
}

#[test]
fn xyz_places_within_their_tolerance_are_on_the_grid() {
    for part in [1e-6, 0.0004, 0.002, 0.01, 0.045] {
        let field = io::xyz::parse(displaced_points(part).as_bytes())
            .unwrap_or_else(|error| panic!("{part}: {error}"));
        let grid = field.grid();
        assert_eq!([grid.nx(), grid.ny()], [12, 10], "{part}");
        assert!((grid.dx() - 1.0).abs() < 0.2 * part && (grid.dy() - 2.0).abs() < 0.4 * part);
        for (cell, height) in field.as_slice().iter().enumerate() {
            assert_eq!(*height, (100 * (cell / 12) + cell % 12) as f64, "{part}");
        }
    }
    let error = io::xyz::parse(displaced_points(0.1).as_bytes()).unwrap_err();
    assert!(
        error.to_string().contains("from the regular grid"),
        "{error}"
    );
}

#[test]
fn xyz_headers_further_columns_and_decimal_commas_are_read() {
    for text in [
        "X [um];Y [um];Z [um]\n0;0;1,5\n1;0;2,5\n",
        "x y z intensity kind\n0 0 1.5 255 a\n1 0 2.5 255 b\n",
        "\"x\",\"y\",\"z\",\"w\"\n0.0,0,1.5,7\n1.0,0,2.5,8\n",
        "0,0 0,0 1,5\n1,0 0,0 2,5\n",
    ] {
        let field = io::xyz::parse(text.as_bytes()).unwrap_or_else(|e| panic!("{text:?}: {e}"));
        assert_eq!(field.as_slice(), [1.5, 2.5], "{text:?}");
    }
    let numbered = b"Width 640\n2\n0 0 1.5\n1 0 -9999\n";
    let error = io::xyz::parse(numbered).unwrap_err().to_string();
    assert!(error.contains("skip_rows = 1"), "{error}");
    let field = io::xyz::Options::default().skip_rows(2).missing(-9999.0);
    let field = field.parse(numbered).unwrap();
    assert!(field.as_slice()[0] == 1.5 && field.as_slice()[1].is_nan());
    let commented = io::xyz::parse(b"# no data = -1\n0 0 2\n1 0 -1\n").unwrap();
    assert!(commented.as_slice()[1].is_nan());
    // In this text commas can be separators or decimal commas.
    let error = io::xyz::parse(b"0,0,0,0,1,5\n1,0,0,0,2,5\n")
        .unwrap_err()
        .to_string();
    assert!(error.contains("decimal commas"), "{error}");
}

#[test]
fn asc_export_of_gwyddion_takes_sides_and_unit_of_its_comments() {
    let file = "# Channel: Height\n# Width: 10.0 \u{b5}m\n# Height: 4,0 um\n# Value units: nm\n0 1\n3.5 nan\n";
    let field = io::asc::parse(file.as_bytes()).unwrap();
    let grid = field.grid();
    assert_eq!([grid.nx(), grid.ny()], [2, 2]);
    assert!((grid.dx() / 5e-6 - 1.0).abs() < 1e-12 && (grid.dy() / 2e-6 - 1.0).abs() < 1e-12);
    assert!((field.as_slice()[2] / 3.5e-9 - 1.0).abs() < 1e-12 && field.as_slice()[3].is_nan());
    let path = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("gwyddion.txt");
    std::fs::write(&path, file).unwrap();
    assert_eq!(
        io::read(&path).unwrap().as_slice()[..3],
        field.as_slice()[..3]
    );
    for (old, new, expected) in [
        (
            "# Value units: nm\n",
            "",
            "ASC, in Value units: the header does not contain this entry",
        ),
        (
            "units: nm",
            "units: V",
            "ASC, in Value units: \"V\" is not a known unit of length",
        ),
        ("10.0", "wide", "ASC, in Width: \"wide\" is not a number"),
        (
            "10.0",
            "-1",
            "ASC, in Width: the value must be positive and finite",
        ),
        (
            "3.5",
            "3.5 4",
            "ASC, on line 6: the line must have 2 cells, as the previous lines, but it has 3",
        ),
    ] {
        let error = io::asc::parse(file.replace(old, new).as_bytes()).unwrap_err();
        assert!(error.to_string().starts_with(expected), "{error}");
    }
}

#[test]
fn sdf_dialects_are_read_or_named() {
    let file = |magic: &str| {
        format!(
            "{magic}\nNumPoints = 2\nNumProfiles = 1\nXscale = 1e-6\nYscale = 1e-6\nZscale = 1e-9\n*\n5 BAD\n*\n"
        )
    };
    for magic in ["aISO-1.0", "aISO-2.0", "aBCR-1.0"] {
        let field = io::sdf::parse(file(magic).as_bytes()).unwrap();
        assert_eq!(field.as_slice()[0], 5e-9, "{magic}");
        assert!(field.as_slice()[1].is_nan(), "{magic}");
    }
    let mut bytes = std::fs::read(data_path("i2.sdf")).unwrap();
    bytes[..8].copy_from_slice(b"bBCR-1.0");
    assert_is_surface("i2.sdf", &io::sdf::parse(&bytes), 1e6, 1e-15, false);
    for magic in ["bISO-2.0", "aISO-3.0"] {
        let error = io::sdf::parse(file(magic).as_bytes())
            .unwrap_err()
            .to_string();
        assert!(error.contains(magic), "{error}");
    }
}

#[test]
fn npy_of_an_unsupported_dtype_is_rejected_with_its_name() {
    for (kind, name) in [
        ("<c16", "complex128"),
        ("|b1", "bool"),
        ("|O", "object"),
        ("<f2", "float16"),
        ("<U5", "text"),
    ] {
        let error = parse_npy_of(kind, &[0; 32]).unwrap_err().to_string();
        assert!(error.contains(name) && error.contains(kind), "{error}");
        assert!(
            error.contains("astype") && !error.contains("fortran"),
            "{error}"
        );
    }
}
