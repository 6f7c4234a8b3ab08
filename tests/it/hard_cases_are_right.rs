//! Every row of the catalogue of hard cases is right: answered within its certified error, refused with the error
//! that is documented, or stalled at round-off.

use kit::scenes::catalogue;

#[test]
fn every_row_is_right() {
    let rows = catalogue::rows().unwrap();
    let wrong: Vec<String> = (rows.iter().filter(|row| !row.is_right()))
        .map(ToString::to_string)
        .collect();
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    assert!(rows.len() > 300);
}
