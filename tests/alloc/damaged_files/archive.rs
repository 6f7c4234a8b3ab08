//! Damaged X3P files: archives, their XML and their data.

use std::fs;

use proptest::prelude::*;
use stickslip::io;

use super::changes::{changed, changes};
use super::zip::zip;
use super::{assert_format_error, patched, read};

/// Size up to which an entry is expanded, whatever its packed size.
const ENTRY: usize = 4 << 20;
/// Largest ratio of the expanded size to the packed size for larger entries.
const PACKED: usize = 100;
/// Number of copies of the data in memory. The copies arise because expanding doubles a buffer, text becomes numbers,
/// and integers become doubles.
const COPIES: u64 = 8;

fn assert_rejected(bytes: &[u8], expected: &str) {
    assert_format_error(&read_bounded(bytes), expected);
}

fn read_bounded(bytes: &[u8]) -> stickslip::Result<stickslip::Field> {
    let (result, memory) = read(bytes, io::x3p::parse);
    let bound = COPIES * ENTRY.max(PACKED * bytes.len()) as u64;
    assert!(memory <= bound, "{memory} bytes for {}", bytes.len());
    result
}

const MAIN: &str = "<p:ISO5436_2 xmlns:p=\"x\"><Record1><FeatureType>SUR</FeatureType><Axes>\
    <CX><AxisType>I</AxisType><Increment>1e-6</Increment></CX>\
    <CY><AxisType>I</AxisType><Increment>2e-6</Increment></CY>\
    <CZ><AxisType>A</AxisType><DataType>I</DataType><Increment>1e-9</Increment></CZ>\
    </Axes></Record1><Record3><MatrixDimension><SizeX>3</SizeX><SizeY>2</SizeY><SizeZ>1</SizeZ>\
    </MatrixDimension><DataLink><PointDataLink>data.bin</PointDataLink>\
    <ValidPointsLink>valid.bin</ValidPointsLink></DataLink></Record3></p:ISO5436_2>";
const DATA: [u8; 12] = [1, 0, 2, 0, 3, 0, 4, 0, 5, 0, 255, 255];
const VALID: [u8; 1] = [0b10_1111];

fn with_main(main: &str) -> Vec<u8> {
    zip(&[
        ("main.xml", main.as_bytes(), true),
        ("data.bin", &DATA, true),
        ("valid.bin", &VALID, false),
    ])
}

#[test]
fn undamaged_archive_is_read() {
    let field = io::x3p::parse(&with_main(MAIN)).unwrap();
    assert_eq!((field.grid().nx(), field.grid().dy()), (3, 2e-6));
    let samples = field.as_slice();
    assert!(samples[4].is_nan());
    for (index, expected) in [(0, 1e-9), (3, 4e-9), (5, -1e-9)] {
        assert!((samples[index] - expected).abs() < 1e-24);
    }
}

/// Alicona writes missing points as infinities.
#[test]
fn x3p_infinite_heights_are_missing_points() {
    let data = [
        1.5_f64,
        f64::INFINITY,
        f64::NEG_INFINITY,
        f64::NAN,
        2.5,
        3.5,
    ];
    let data: Vec<u8> = data.iter().flat_map(|z| z.to_le_bytes()).collect();
    let main = MAIN.replace("<DataType>I", "<DataType>D");
    let valid = [0b11_1111];
    let files = [
        ("main.xml", main.as_bytes(), true),
        ("data.bin", &data, true),
        ("valid.bin", &valid, false),
    ];
    let listed = "<DataList><Datum>1.5</Datum><Datum>+inf</Datum><Datum>-inf</Datum><Datum/>\
        <Datum>2.5</Datum><Datum>3.5</Datum></DataList>";
    let link = "<DataLink><PointDataLink>data.bin</PointDataLink>\
        <ValidPointsLink>valid.bin</ValidPointsLink></DataLink>";
    let main = main.replace(link, listed);
    let list = zip(&[("main.xml", main.as_bytes(), true)]);
    for file in [zip(&files), list] {
        let field = io::x3p::parse(&file).unwrap();
        // Floating-point data are already heights, so they are not multiplied by the increment of 1e-9.
        assert_eq!(field.as_slice()[0], 1.5);
        assert_eq!(field.as_slice()[4..], [2.5, 3.5]);
        assert!(field.as_slice()[1..4].iter().all(|z| z.is_nan()));
    }
}

#[test]
fn x3p_empty_elements_are_absent() {
    let increment = "<Increment>1e-9</Increment>";
    for (empty, scale) in [
        ("<Increment>1e-9</Increment><Offset/>", 1e-9),
        ("<Increment></Increment><Offset></Offset>", 1.0),
    ] {
        let main = MAIN.replace(increment, empty);
        let field = io::x3p::parse(&with_main(&main)).unwrap();
        assert_eq!(field.as_slice()[3], 4.0 * scale, "{empty}");
    }
    let main = MAIN.replace("1e-6", "");
    let expected = "X3P, in main.xml: the element Record1/Axes/CX/Increment is missing";
    assert_rejected(&with_main(&main), expected);
}

#[test]
fn x3p_in_a_folder_of_the_archive_is_read() {
    let whole = io::x3p::parse(&with_main(MAIN)).unwrap();
    for [main, data, valid] in [
        ["scan/main.xml", "scan/data.bin", "scan/valid.bin"],
        ["a\\b\\main.xml", "a\\b\\data.bin", "a\\b\\valid.bin"],
        ["scan/main.xml", "data.bin", "valid.bin"],
    ] {
        let file = zip(&[
            (main, MAIN.as_bytes(), true),
            (data, &DATA, true),
            (valid, &VALID, false),
        ]);
        let field = io::x3p::parse(&file).unwrap();
        assert_eq!(field.as_slice()[..4], whole.as_slice()[..4], "{main}");
    }
}

#[test]
fn damaged_archives_are_rejected() {
    let whole = with_main(MAIN);
    let end = whole.len() - 22;
    let directory = usize::from(u16::from_le_bytes(
        whole[end + 16..][..2].try_into().unwrap(),
    ));
    let far = [255, 255, 255, 127];
    for length in [0, 1, 21, directory, end, whole.len() - 1] {
        let expected =
            format!("X3P, at byte {length}: the archive is truncated: its end record is missing");
        assert_rejected(&whole[..length], &expected);
    }
    for (start, part, expected) in [
        (
            end + 16,
            &far[..],
            &*format!("X3P, at byte {end}: the end of the archive is damaged"),
        ),
        (
            end + 16,
            &[0, 0],
            "X3P, in main.xml: the file was not found at byte ",
        ),
        (
            end + 10,
            &[0, 0],
            "X3P, in main.xml: the archive has no such file",
        ),
        (
            directory,
            b"XX",
            &format!("X3P, at byte {directory}: the directory of the archive is damaged"),
        ),
        (
            directory + 8,
            &[1],
            "X3P, in main.xml: encryption is not supported",
        ),
        (
            directory + 10,
            &[12],
            "X3P, in main.xml: compression 12 is not supported",
        ),
        (
            directory + 16,
            &far,
            "X3P, in main.xml: the file is damaged: Invalid checksum",
        ),
        (
            directory + 20,
            &far,
            "X3P, in main.xml: the file was not found at byte 0: Unexpected end of file",
        ),
        (
            directory + 24,
            &far,
            "X3P, in main.xml: 228 compressed bytes would expand to 2147483647 bytes, but at most",
        ),
        (
            directory + 24,
            &[0, 0],
            "X3P, in main.xml: the file cannot be decompressed",
        ),
        (
            directory + 24,
            &[255, 255],
            "X3P, in main.xml: the file is damaged: Invalid size: expected 65535, got 503",
        ),
        (
            directory + 28,
            &[255, 255],
            &format!("X3P, at byte {directory}: the directory of the archive is damaged"),
        ),
        (
            directory + 42,
            &far,
            "X3P, in main.xml: the file was not found at byte 2147483647: Unexpected end",
        ),
        (
            directory + 42,
            &[1],
            "X3P, in main.xml: the file was not found at byte 1: Invalid signature",
        ),
        (60, &[0xff; 20], "X3P, in main.xml: "),
    ] {
        assert_rejected(&patched(&whole, start, part), expected);
    }
    let main = ("main.xml", MAIN.as_bytes(), false);
    let data = ("data.bin", &DATA[..], false);
    assert_rejected(&zip(&[]), "X3P, in main.xml: the archive has no such file");
    assert_rejected(
        &zip(&[data]),
        "X3P, in main.xml: the archive has no such file",
    );
    assert_rejected(
        &zip(&[main]),
        "X3P, in data.bin: the archive has no such file",
    );
    assert_rejected(
        &zip(&[main, data]),
        "X3P, in valid.bin: the archive has no such file",
    );
    let short = ("data.bin", &DATA[..11], true);
    assert_rejected(
        &zip(&[main, short]),
        "X3P, in data.bin: the file has 11 bytes, expected 12",
    );
    let long = ("valid.bin", &DATA[..2], false);
    assert_rejected(
        &zip(&[main, data, long]),
        "X3P, in valid.bin: the file has 2 bytes, expected 1",
    );
}

#[test]
fn invalid_headers_are_rejected() {
    for (old, new, expected) in [
        (
            "SUR",
            "PRF",
            "X3P, in main.xml: Record1/FeatureType is \"PRF\", but only SUR is supported",
        ),
        (
            "<CX><AxisType>I",
            "<CX><AxisType>A",
            "X3P, in main.xml: Record1/Axes/CX/AxisType is \"A\"",
        ),
        (
            "1e-6",
            "-1e-6",
            "X3P, in main.xml: cell side dx must be positive and finite, got -1e-6",
        ),
        (
            "1e-6",
            "0",
            "X3P, in main.xml: cell side dx must be positive and finite, got 0",
        ),
        (
            "2e-6",
            "NaN",
            "X3P, in main.xml: Record1/Axes/CY/Increment is \"NaN\", but must be finite",
        ),
        (
            "2e-6",
            "tiny",
            "X3P, in main.xml: Record1/Axes/CY/Increment is \"tiny\", but must be a number",
        ),
        (
            "1e-9",
            "0",
            "X3P, in main.xml: Record1/Axes/CZ/Increment is \"0\", but must be positive",
        ),
        (
            "<DataType>I",
            "<DataType>Q",
            "X3P, in main.xml: Record1/Axes/CZ/DataType is \"Q\", but must be I, L, F or D",
        ),
        (
            "<DataType>I",
            "<DataType>D",
            "X3P, in data.bin: the file has 12 bytes, expected 48",
        ),
        (
            "<DataType>I</DataType>",
            "",
            "X3P, in main.xml: the element Record1/Axes/CZ/DataType is missing",
        ),
        (
            "<SizeX>3</SizeX>",
            "",
            "X3P, in main.xml: the element Record3/MatrixDimension/SizeX is missing",
        ),
        (
            "<SizeX>3",
            "<SizeX>-3",
            "X3P, in main.xml: Record3/MatrixDimension/SizeX is \"-3\", but must be a whole number",
        ),
        (
            "<SizeX>3",
            "<SizeX>&#51;&a;",
            "X3P, in main.xml: Record3/MatrixDimension/SizeX is \"3&a;\", but must be a whole number",
        ),
        (
            "<SizeX>3",
            "<SizeX>3&#48;",
            "X3P, in data.bin: the file has 12 bytes, expected 120",
        ),
        (
            "<SizeX>3",
            "<SizeX>4",
            "X3P, in data.bin: the file has 12 bytes, expected 16",
        ),
        (
            "<SizeX>3",
            "<SizeX>0",
            "X3P, in main.xml: the grid must have at least one cell along each axis, got 0 x 2 cells",
        ),
        (
            "<SizeX>3",
            "<SizeX>9999999999999999999",
            "X3P, in main.xml: cannot allocate 2384185791015.6 GiB for a padded grid",
        ),
        (
            "<SizeX>3",
            "<SizeX>4000000000",
            "X3P, in data.bin: the file has 12 bytes, expected 16000000000",
        ),
        (
            "<SizeZ>1",
            "<SizeZ>2",
            "X3P, in main.xml: Record3/MatrixDimension/SizeZ is \"2\", but only 1",
        ),
        (
            "</Axes>",
            "<Rotation><r12>0.5</r12></Rotation></Axes>",
            "X3P, in main.xml: Record1/Axes/Rotation/r12",
        ),
        ("</Record3>", "</Record4>", "X3P, in main.xml: "),
        (
            "</Record3></p:ISO5436_2>",
            "",
            "X3P, in main.xml: the document ends within an element",
        ),
        ("<p:ISO", "<<p:ISO", "X3P, in main.xml: "),
        (
            "PointDataLink>",
            "Elsewhere>",
            "X3P, in main.xml: the file contains no data, neither linked nor listed",
        ),
        (
            "<DataLink><PointDataLink>data.bin</PointDataLink>",
            "<DataList><Datum>1</Datum></DataList><DataLink>",
            "X3P, in main.xml: the file lists 1 samples, expected 3 x 2 points",
        ),
        (
            "<DataLink>",
            "<DataList><Datum>one</Datum></DataList><DataLink>",
            "X3P, in main.xml: Record3/DataList/Datum is \"one\", but must be a number",
        ),
    ] {
        assert!(MAIN.contains(old), "{old}");
        assert_rejected(&with_main(&MAIN.replace(old, new)), expected);
    }
    for main in [
        "",
        "garbage",
        "\u{0}\u{1}",
        "<!DOCTYPE x [<!ENTITY a \"b\">]>",
        "<x/>",
        "<x>&a;</x>",
    ] {
        assert_rejected(&with_main(main), "X3P, in main.xml: ");
    }
    let deep = "<x>".repeat(100_000);
    assert_rejected(
        &with_main(&deep),
        "X3P, in main.xml: the elements are nested more than 16 levels deep",
    );
    let bytes = zip(&[("main.xml", &[0xff, 0xfe, 0x3c], false)]);
    assert_rejected(&bytes, "X3P, in main.xml: the text is not UTF-8");
}

#[test]
fn archives_that_expand_beyond_limit_are_rejected() {
    // The XML, the samples or a list expands to a thousand times its packed size.
    let zeros = vec![0; 8 << 20];
    let bomb = zip(&[("main.xml", &zeros, true)]);
    assert_rejected(
        &bomb,
        "X3P, in main.xml: 8156 compressed bytes would expand to 8388608",
    );
    let main = MAIN.replace("<SizeX>3", "<SizeX>2097152");
    let bomb = zip(&[
        ("main.xml", main.as_bytes(), false),
        ("data.bin", &zeros, true),
    ]);
    assert_rejected(
        &bomb,
        "X3P, in data.bin: 8156 compressed bytes would expand to 8388608",
    );
    let list = format!(
        "<x><Record3><DataList>{}",
        "<Datum/>".repeat((4 << 20) / 8 - 10)
    );
    assert_rejected(
        &zip(&[("main.xml", list.as_bytes(), true)]),
        "X3P, in main.xml: the document ends",
    );
    // The declared size is small, but the expanded data are large.
    let lying = zip(&[("main.xml", &zeros, true)]);
    let directory = lying.len() - 22 - 46 - 8;
    let lying = patched(&lying, directory + 24, &1000_u32.to_le_bytes());
    assert_rejected(&lying, "X3P, in main.xml: the file cannot be decompressed");
}

/// The cost of an element depends on its own name only, not on the enclosing names. Otherwise, reading this file would
/// take hours.
#[test]
fn long_names_around_many_elements_are_read_quickly() {
    let name = "n".repeat(kit::thorough(1 << 19, 2 << 20));
    let many = "<a/>".repeat(kit::thorough(200_000, 400_000));
    let elements = format!("<{name}>{many}</{name}>");
    assert_rejected(&with_main(&elements), "X3P, in main.xml");
    assert_rejected(
        &with_main(&format!("<r>{elements}</r>")),
        "X3P, in main.xml",
    );
}

/// Returns files written by other programs, which the tests then change at random.
fn files() -> Vec<Vec<u8>> {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../data/files/");
    let names = ["I.x3p", "surfalize.x3p", "list.x3p"];
    let mut files: Vec<_> = names
        .map(|name| fs::read(folder.to_owned() + name).unwrap())
        .into();
    files.push(with_main(MAIN));
    files
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(kit::thorough(700, 2000)))]

    #[test]
    fn changed_archives_are_read_in_bounded_memory(which in 0..4_usize, changes in changes()) {
        let bytes = changed(files()[which].clone(), &changes);
        let _ = read_bounded(&bytes);
    }

    #[test]
    fn changed_headers_are_read_in_bounded_memory(changes in changes()) {
        let main = changed(MAIN.as_bytes().to_vec(), &changes);
        let bytes = zip(&[
            ("main.xml", &main, false),
            ("data.bin", &DATA, true),
            ("valid.bin", &VALID, true),
        ]);
        let _ = read_bounded(&bytes);
    }
}
