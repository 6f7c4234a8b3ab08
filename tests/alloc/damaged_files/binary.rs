//! Damaged NPY, SDF and SUR files.

use stickslip::{Error, Field, Grid, Result, io};

use super::{assert_rejected, patched};

pub(crate) fn parse_npy(bytes: &[u8]) -> Result<Field> {
    io::npy::parse(bytes, [1.0, 1.0])
}

fn field() -> Field {
    Field::from_fn(Grid::new(3, 2, 0.5, 0.25).unwrap(), |x, y| x + 10.0 * y)
}

/// Returns a file of version 1 with any header.
fn npy_with(header: &str, data: &[u8]) -> Vec<u8> {
    let mut bytes = b"\x93NUMPY\x01\x00".to_vec();
    bytes.extend_from_slice(&u16::try_from(header.len()).unwrap().to_le_bytes());
    bytes.extend_from_slice(header.as_bytes());
    bytes.extend_from_slice(data);
    bytes
}

fn npy_of_shape(shape: &str, data: &[u8]) -> Vec<u8> {
    let header = format!("{{'descr': '<f8', 'fortran_order': False, 'shape': {shape}, }}\n");
    npy_with(&header, data)
}

#[test]
fn damaged_npy_files_are_rejected() {
    let whole = io::npy::to_bytes(&field());
    for (length, expected) in [
        (
            0,
            "NPY, at byte 0: the file ends within the magic string: expected 6 bytes, found 0",
        ),
        (5, "NPY, at byte 0: the file ends within the magic string"),
        (
            7,
            "NPY, at byte 6: the file ends within the version: expected 2 bytes, found 1",
        ),
        (
            9,
            "NPY, at byte 8: the file ends within the length of the header",
        ),
        (
            127,
            "NPY, at byte 10: the file ends within the header: expected 118 bytes, found 117",
        ),
        (
            128,
            "NPY, at byte 128: an array of shape (2, 3) requires 48 bytes, but the file has 0",
        ),
        (
            175,
            "NPY, at byte 128: an array of shape (2, 3) requires 48 bytes, but the file has 47",
        ),
    ] {
        assert_rejected(&whole[..length], parse_npy, expected);
    }
    let longer = [&whole[..], &[0]].concat();
    assert_rejected(
        &longer,
        parse_npy,
        "NPY, at byte 128: an array of shape (2, 3) requires 48 bytes, but the file has 49",
    );
    assert_rejected(
        &patched(&whole, 1, b"X"),
        parse_npy,
        "NPY, at byte 0: the file does not start with",
    );
    assert_rejected(
        &patched(&whole, 6, &[4]),
        parse_npy,
        "NPY, at byte 6: version 4.0 is not supported, expected version 1, 2 or 3",
    );
    let long_header = patched(&whole, 6, &[2, 0, 255, 255, 255, 255]);
    assert_rejected(
        &long_header,
        parse_npy,
        "NPY, at byte 12: the file ends within the header",
    );

    let eight = [0; 8];
    for (shape, expected) in [
        (
            "(9999999999, 9999999999)",
            "NPY, at byte 10: cannot allocate 11920928952693.9 GiB for a padded grid",
        ),
        (
            "(18446744073709551615, 2)",
            "NPY, at byte 10: cannot allocate 4398046511104.0 GiB for a padded grid",
        ),
        (
            "(99999999999999999999, 2)",
            "NPY, at byte 10: 'shape' \"(99999999999999999999, 2), }\\n\" is not",
        ),
        (
            "(1000000, 1000000)",
            "NPY, at byte 82: an array of shape (1000000, 1000000) requires 8000000000000 bytes",
        ),
        (
            "(-1, 1)",
            "NPY, at byte 10: 'shape' \"(-1, 1), }\\n\" is not supported",
        ),
        (
            "(0, 4)",
            "NPY, at byte 10: the grid must have at least one cell along each axis, got 4 x 0 cells",
        ),
        (
            "(1,)",
            "NPY, at byte 10: the array has the shape (1,), expected (ny, nx): reshape it to two axes before saving it",
        ),
        (
            "(1, 1, 1)",
            "NPY, at byte 10: the array has the shape (1, 1, 1), expected (ny, nx): save one plane, such as array[0] or array[..., 0]",
        ),
        (
            "()",
            "NPY, at byte 10: the array has the shape (), expected (ny, nx): reshape",
        ),
        (
            "(1, x, 1)",
            "NPY, at byte 10: 'shape' \"(1, x, 1), }\\n\" is not supported",
        ),
        ("1, 1", "NPY, at byte 10: 'shape'"),
    ] {
        assert_rejected(&npy_of_shape(shape, &eight), parse_npy, expected);
    }
    let rest = "'fortran_order': False, 'shape': (1, 1), }";
    for descr in [
        "'<c16'",
        "'|O'",
        "'<f2'",
        "'<U8'",
        "'<f8",
        "[('x', '<f8')]",
        "'µ'",
        "''",
    ] {
        let header = format!("{{'descr': {descr}, {rest}");
        assert_rejected(
            &npy_with(&header, &eight),
            parse_npy,
            "NPY, at byte 10: the dtype ",
        );
    }
    for (header, expected) in [
        ("", "NPY, at byte 10: the header has no 'descr'"),
        (
            "{'descr' '<f8'",
            "NPY, at byte 10: the header has no 'descr'",
        ),
        (
            "{'descr': '<f8'}",
            "NPY, at byte 10: the header has no 'fortran_order'",
        ),
        (
            "{'descr': '<f8', 'fortran_order': 7}",
            "NPY, at byte 10: 'fortran_order' \"7}\"",
        ),
        (
            "{'descr': '<f8', 'fortran_order': True}",
            "NPY, at byte 10: the header has no 'shape'",
        ),
    ] {
        assert_rejected(&npy_with(header, &eight), parse_npy, expected);
    }
}

#[test]
fn invalid_cell_sides_of_caller_are_rejected() {
    for side in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        for sides in [[side, 1.0], [1.0, side]] {
            for result in [
                io::npy::parse(b"", sides),
                io::csv::parse(b"", sides),
                io::npy::read("absent", sides),
                io::csv::read("absent", sides),
            ] {
                assert!(matches!(result, Err(Error::NotPositive { .. })));
            }
        }
    }
}

#[test]
fn damaged_sdf_files_are_rejected() {
    let whole = io::sdf::to_bytes(&field()).unwrap();
    for (length, expected) in [
        (
            0,
            "SDF, at byte 0: the file does not start with bISO-1.0 or aISO-1.0",
        ),
        (7, "SDF, at byte 0: the file does not start with bISO-1.0"),
        (
            8,
            "SDF, at byte 8: the file ends within manufacturer and dates",
        ),
        (43, "SDF, at byte 42: the file ends within NumPoints"),
        (45, "SDF, at byte 44: the file ends within NumProfiles"),
        (53, "SDF, at byte 46: the file ends within Xscale"),
        (61, "SDF, at byte 54: the file ends within Yscale"),
        (69, "SDF, at byte 62: the file ends within Zscale"),
        (77, "SDF, at byte 70: the file ends within Zresolution"),
        (80, "SDF, at byte 78: the file ends within the three flags"),
        (
            81,
            "SDF, at byte 81: the file ends within the samples: expected 48 bytes, found 0",
        ),
        (
            128,
            "SDF, at byte 81: the file ends within the samples: expected 48 bytes, found 47",
        ),
    ] {
        assert_rejected(&whole[..length], io::sdf::parse, expected);
    }
    assert_rejected(
        &patched(&whole, 5, b"2.0"),
        io::sdf::parse,
        "SDF, at byte 0: the file starts with",
    );
    let zero = 0_u16.to_le_bytes();
    assert_rejected(
        &patched(&whole, 42, &zero),
        io::sdf::parse,
        "SDF, at byte 42: the grid must have at least one cell along each axis, got 0 x 2",
    );
    assert_rejected(
        &patched(&whole, 44, &zero),
        io::sdf::parse,
        "SDF, at byte 42: the grid must have at least one cell along each axis, got 3 x 0",
    );
    let most = patched(&whole, 42, &[255; 4]);
    assert_rejected(
        &most,
        io::sdf::parse,
        "SDF, at byte 81: the file ends within the samples",
    );
    for (start, place, name) in [
        (46, 42, "cell side dx"),
        (54, 42, "cell side dy"),
        (62, 62, "Zscale"),
    ] {
        for value in [0.0, -1e-6, f64::NAN, f64::INFINITY] {
            let file = patched(&whole, start, &f64::to_le_bytes(value));
            let expected = format!("SDF, at byte {place}: {name} must be positive and finite, got");
            assert_rejected(&file, io::sdf::parse, &expected);
        }
    }
    for (start, value, expected) in [
        (78, 1, "SDF, at byte 78: compression 1 is not supported"),
        (79, 4, "SDF, at byte 79: data type 4 is not supported"),
        (79, 255, "SDF, at byte 79: data type 255 is not supported"),
        (80, 1, "SDF, at byte 80: checksum 1 is not supported"),
    ] {
        assert_rejected(&patched(&whole, start, &[value]), io::sdf::parse, expected);
    }
}

/// Returns a file with two lines of three points, with 16 bits per point.
pub(crate) fn sur() -> Vec<u8> {
    let mut bytes = vec![0; 512];
    for (start, part) in [
        (0, &b"DIGITAL SURF\x00\x00\x01\x00\x01\x00\x02\x00"[..]),
        (98, &[16, 0]),
        (108, &[3, 0, 0, 0, 2, 0, 0, 0, 6, 0, 0, 0]),
        (120, &0.5_f32.to_le_bytes()),
        (124, &0.25_f32.to_le_bytes()),
        (128, &1.0_f32.to_le_bytes()),
        (180, b"mm"),
        (196, b"\xb5m"),
        (212, b"nm"),
    ] {
        bytes[start..start + part.len()].copy_from_slice(part);
    }
    bytes.extend((0..6_i16).flat_map(i16::to_le_bytes));
    bytes
}

#[test]
fn damaged_sur_files_are_rejected() {
    let whole = sur();
    let field = io::sur::parse(&whole).unwrap();
    assert_eq!([field.grid().dx(), field.grid().dy()], [0.5e-3, 0.25e-6]);
    assert_eq!(field.as_slice()[..3], [0.0, 1e-9, 2e-9]);
    for (length, expected) in [
        (0, "SUR, at byte 0: the file ends within the magic string"),
        (13, "SUR, at byte 12: the file ends within byte order"),
        (19, "SUR, at byte 18: the file ends within kind of object"),
        (
            100,
            "SUR, at byte 100: the file ends within the smallest sample",
        ),
        (
            119,
            "SUR, at byte 116: the file ends within the number of points",
        ),
        (
            130,
            "SUR, at byte 128: the file ends within the spacing along z",
        ),
        (200, "SUR, at byte 196: the file ends within a unit"),
        (
            511,
            "SUR, at byte 478: the file ends within the end of the header",
        ),
        (
            523,
            "SUR, at byte 512: the file ends within the samples: expected 12 bytes, found 11",
        ),
    ] {
        assert_rejected(&whole[..length], io::sur::parse, expected);
    }
    let not_a_number = f32::NAN.to_le_bytes();
    for (start, part, expected) in [
        (
            0,
            &b"X"[..],
            "SUR, at byte 0: the file does not start with DIGITAL SURF",
        ),
        (
            0,
            b"DSCOMPRESSED",
            "SUR, at byte 0: compressed files are not supported",
        ),
        (
            12,
            &[1, 1],
            "SUR, at byte 12: byte order 257 is not supported",
        ),
        (
            14,
            &[3],
            "SUR, at byte 14: number of objects 3 is not supported",
        ),
        (16, &[2], "SUR, at byte 16: version 2 is not supported"),
        (
            18,
            &[5],
            "SUR, at byte 18: kind of object 5 is not supported",
        ),
        (
            86,
            &[2],
            "SUR, at byte 86: flag of missing points 2 is not supported",
        ),
        (
            98,
            &[8],
            "SUR, at byte 98: bits per point 8 is not supported",
        ),
        (
            98,
            &[32],
            "SUR, at byte 512: the file ends within the samples: expected 24 bytes, found 12",
        ),
        (
            108,
            &[4],
            "SUR, at byte 108: the header states 4 x 2 points, but a total of 6 points",
        ),
        (
            108,
            &[255; 12],
            "SUR, at byte 108: the header states 4294967295 x 4294967295 points, but a total of",
        ),
        (
            108,
            &[0; 12],
            "SUR, at byte 120: the grid must have at least one cell along each axis, got 0 x 0 cells",
        ),
        (
            120,
            &[0; 4],
            "SUR, at byte 120: cell side dx must be positive and finite, got 0",
        ),
        (
            124,
            &not_a_number,
            "SUR, at byte 120: cell side dy must be positive and finite, got NaN",
        ),
        (
            128,
            &not_a_number,
            "SUR, at byte 128: spacing along z must be positive and finite",
        ),
        (
            131,
            &[0xbf],
            "SUR, at byte 128: spacing along z must be positive and finite, got -",
        ),
        (
            180,
            b"ft",
            "SUR, at byte 180: \"ft\" is not a unit of length from pm to m",
        ),
        (212, &[0], "SUR, at byte 212: \"\" is not a unit of length"),
        (290, &[1], "SUR, at byte 290: inversion 1 is not supported"),
        (
            334,
            &[99],
            "SUR, at byte 512: the file ends within the comment: expected 99 bytes, found 12",
        ),
    ] {
        assert_rejected(&patched(&whole, start, part), io::sur::parse, expected);
    }
}
