//! Valid files with random bytes changed, removed or inserted are read or rejected, in bounded memory and without a
//! panic.

use proptest::collection::vec;
use proptest::prelude::*;
use proptest::sample::Index;
use stickslip::{Field, Grid, io};

use super::binary::{parse_npy, sur};
use super::text::parse_csv;
use super::{Parse, read_bounded};

fn field() -> Field {
    Field::from_fn(Grid::new(6, 5, 0.5, 0.25).unwrap(), |x, y| x - 3.0 * y)
}

/// Returns a valid file of each format.
fn valid() -> Vec<(Parse, Vec<u8>)> {
    let field = field();
    let grid = field.grid();
    let text = |separator: &str| -> String {
        let places = (0..grid.cells()).map(|cell| (cell % grid.nx(), cell / grid.nx()));
        let point = |(ix, iy)| {
            let z = field.get(ix, iy).unwrap();
            format!("{}{separator}{}{separator}{z}\n", grid.x(ix), grid.y(iy))
        };
        places.map(point).collect()
    };
    let header =
        "aISO-1.0\nNumPoints = 6\nNumProfiles = 5\nXscale = 1\nYscale = 1\nZscale = 1\n*\n";
    let asc = "# File Format = ASCII\n# x-pixels = 6\n# y-pixels = 5\n# x-length = 1\n# y-length = 1\n# z-unit = nm\n# voidpixels = -3\n";
    let samples = "1 2 BAD 4.5 5 6\n".repeat(5);
    let files: Vec<(Parse, Vec<u8>)> = vec![
        (parse_npy, io::npy::to_bytes(&field)),
        (parse_csv, io::csv::to_bytes(&field)),
        (io::sdf::parse, io::sdf::to_bytes(&field).unwrap()),
        (io::sdf::parse, format!("{header}{samples}*\n").into_bytes()),
        (
            io::asc::parse,
            format!("{asc}{}", "1 2 3 4.5 5 6\n".repeat(5)).into_bytes(),
        ),
        (
            io::asc::parse,
            format!("# Width: 6 um\n# Height: 5 um\n# Value units: nm\n{samples}").into_bytes(),
        ),
        (io::sur::parse, sur()),
        (io::xyz::parse, text(" ").into_bytes()),
        (io::xyz::parse, text(";").into_bytes()),
        (
            io::xyz::parse,
            format!("x;y;z\n{}", text(";"))
                .replace("-0.25;", "-0.26;")
                .into_bytes(),
        ),
    ];
    for (parse, bytes) in &files {
        parse(bytes).unwrap();
    }
    files
}

/// A change to a file.
#[derive(Debug, Clone)]
pub(crate) enum Change {
    Set(Index, u8),
    Flip(Index, u8),
    Insert(Index, u8),
    Remove(Index),
    Cut(Index),
}

pub(crate) fn changes() -> impl Strategy<Value = Vec<Change>> {
    let place = any::<Index>;
    let byte = prop_oneof![
        any::<u8>(),
        proptest::sample::select(b"\0\x01\x7f\x80\xff ,;\n-e9*.(".to_vec()),
    ];
    let change = prop_oneof![
        4 => (place(), byte.clone()).prop_map(|(at, byte)| Change::Set(at, byte)),
        4 => (place(), 0..8_u8).prop_map(|(at, bit)| Change::Flip(at, bit)),
        2 => (place(), byte).prop_map(|(at, byte)| Change::Insert(at, byte)),
        2 => place().prop_map(Change::Remove),
        1 => place().prop_map(Change::Cut),
    ];
    vec(change, 1..6)
}

pub(crate) fn changed(mut bytes: Vec<u8>, changes: &[Change]) -> Vec<u8> {
    for change in changes {
        // The index may equal the number of bytes, so that a change after the last byte is possible.
        let at = |index: &Index| index.index(bytes.len() + 1);
        match change {
            Change::Set(index, byte) => {
                let at = at(index);
                bytes.splice(at..bytes.len().min(at + 1), [*byte]);
            }
            Change::Flip(index, bit) => {
                let at = at(index);
                if let Some(byte) = bytes.get_mut(at) {
                    *byte ^= 1 << bit;
                }
            }
            Change::Insert(index, byte) => bytes.insert(at(index), *byte),
            Change::Remove(index) => {
                let at = at(index);
                bytes.drain(at..bytes.len().min(at + 1));
            }
            Change::Cut(index) => bytes.truncate(at(index)),
        }
    }
    bytes
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(kit::thorough(1000, 3000)))]

    #[test]
    fn changed_files_are_read_in_bounded_memory(which in any::<Index>(), changes in changes()) {
        let files = valid();
        let (parse, bytes) = which.get(&files);
        let bytes = changed(bytes.clone(), &changes);
        if let Ok(field) = read_bounded(&bytes, *parse) {
            prop_assert_eq!(field.as_slice().len(), field.grid().cells());
        }
    }

    #[test]
    fn random_bytes_are_read_or_rejected(bytes in vec(any::<u8>(), 0..300)) {
        for (parse, _) in valid() {
            let _ = read_bounded(&bytes, parse);
        }
    }
}
