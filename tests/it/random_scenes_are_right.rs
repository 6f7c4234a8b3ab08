//! Random hard scenes are right, and so are those in which a campaign over many thousands has once found a fault.

use kit::scenes::row::Row;
use kit::scenes::{campaign, kinds};
use rayon::prelude::*;

/// All faults of these indices, of both methods where the scene is small.
fn faults(indices: &[u64], rows: fn(u64) -> Vec<Row>) -> Vec<String> {
    let found = indices
        .par_iter()
        .flat_map_iter(|&index| faults_of(index, &rows(index)));
    found.collect()
}

fn faults_of(index: u64, rows: &[Row]) -> Vec<String> {
    let wrong = rows.iter().filter(|row| !row.is_right());
    wrong.map(|row| format!("{index}: {row}")).collect()
}

#[test]
fn some_hundreds_are_right() {
    let indices: Vec<u64> = (0..kit::thorough(30, 400)).collect();
    let found = faults(&indices, campaign::rows);
    assert!(found.is_empty(), "{}", found.join("\n"));
}

#[test]
fn some_tens_of_coated_bodies_are_right() {
    let indices = 0..kit::thorough(8_u64, 60);
    let rows: Vec<Vec<Row>> = (indices.clone().into_par_iter())
        .map(campaign::coated_rows)
        .collect();
    let found = indices.zip(&rows);
    let found: Vec<String> = found
        .flat_map(|(index, rows)| faults_of(index, rows))
        .collect();
    assert!(found.is_empty(), "{}", found.join("\n"));
    let is_certified = |row: &Row| row.error.is_some();
    let certified = rows.iter().filter(|rows| rows.iter().any(is_certified));
    // Others are refused, or do not touch.
    let certified = certified.count();
    assert!(
        4 * certified > 3 * rows.len(),
        "{certified} of {}",
        rows.len()
    );
}

#[test]
fn those_found_wrong_before_are_right() {
    let indices = [
        // In the plane, under a force close to sliding.
        107, 114, 164, 247, 254, 506, 520, 762, 863, 953, 997, 1050, 1117, 1438,
        // A single cell that repeats, in the plane.
        543, 1091, 1787, 4020,
        // A window around a tip that is not the lowest, under next to no load.
        10225, // Round-off of slip far larger than what is displaced.
        191, 575, 615, 17791,
    ];
    let found = faults(&indices, campaign::rows);
    assert!(found.is_empty(), "{}", found.join("\n"));
}

#[test]
fn those_that_stalled_before_converge() {
    // A small shift of a grid that repeats and touches everywhere, to the last digit: all of it slides.
    let small_shifts = [13459, 16149].into_iter().map(|i| (i, campaign::rows(i)));
    let of_kinds = [
        // Slipping cells that point along one line, oblique to the axes.
        3483, 5238, 6156, 7587, 8208, 8586,
        // Projected gradients end beside the minimum; pressure and tractions that lead one another away.
        1665, 3248,
    ];
    let of_kinds = of_kinds.into_iter().map(|i| (i, kinds::rows(i)));
    for (index, rows) in small_shifts.chain(of_kinds) {
        for row in rows {
            assert!(
                row.is_right() && row.ending == "converged",
                "{index}: {row}"
            );
        }
    }
}
