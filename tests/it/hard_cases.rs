//! The result of every row of the catalogue of hard cases is correct. The case is solved within the certified error,
//! rejected with the documented error, or stalls at round-off. Outside the campaign, one scene in five is solved.

use kit::scenes::catalogue;

#[test]
fn catalogue_rows_are_all_correct() {
    let (stride, least) = kit::thorough((5, 100), (1, 300));
    let rows = catalogue::rows(stride).unwrap();
    let wrong: Vec<String> = (rows.iter().filter(|row| !row.is_right()))
        .map(ToString::to_string)
        .collect();
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    assert!(rows.len() > least, "{}", rows.len());
}
