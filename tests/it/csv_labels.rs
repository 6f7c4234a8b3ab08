//! Numbers in text files that are labels of rows and columns instead of heights.

use stickslip::{Error, io};

/// The default output of pandas contains row and column numbers, which are not heights.
#[test]
fn csv_labels_of_pandas_are_rejected_with_the_option() {
    let parse = |text: &str| io::csv::parse(text.as_bytes(), [1.0, 1.0]);
    for (text, remedy) in [
        (
            ",0,1,2\n0,1.5,2.5,3.5\n1,4.5,5.5,6.5\n",
            "skip_rows = 1 and skip_columns = 1",
        ),
        (
            "# heights\n,0,1\n0,7,5\n1,4,9\n",
            "skip_rows = 2 and skip_columns = 1",
        ),
        (
            ";0,0;0,1;0,2\n0,0;1;2;4\n0,5;1;2;4\n1,0;1;2;4\n",
            "skip_rows = 1 and skip_columns = 1",
        ),
        // Coordinates after an empty first cell, after a number and after a missing number.
        (
            ",0,0.5\n0,1,7\n0.5,3,4\n",
            "skip_rows = 1 and skip_columns = 1",
        ),
        (
            "0,0,0.33,0.67,1\n0,7,5,6,6\n0.5,4,9,5,5\n1,2,2,2,2\n",
            "skip_rows = 1 and skip_columns = 1",
        ),
        (
            "nan -1 0 1\n5 7 5 6\n10 4 9 5\n15 2 2 2\n",
            "skip_rows = 1 and skip_columns = 1",
        ),
        // Either the row numbers or the column numbers are absent.
        ("0,1,2\n1.5,2.5,3.5\n4.5,5.5,6.5\n", "skip_rows = 1,"),
        ("0,1.5,2.5\n1,4.5,5.5\n2,6.5,7.5\n", "skip_columns = 1,"),
        // The numbers of the columns or rows are written with decimals.
        ("0.0,1.0,2.0\n.1,.2,.15\n.3,.1,.2\n", "skip_rows = 1,"),
        ("0.,1.,2.,3.\n1.5,2.5,2,2\n", "skip_rows = 1,"),
        ("0,0;1,0;2,0\n1,5;2,5;3,5\n", "skip_rows = 1,"),
        (
            "0.0,1.5,2.5\n1.0,4.5,5.5\n2.0,6.5,7.5\n",
            "skip_columns = 1,",
        ),
        (
            ",0.0,1.0,2.0\n0,1.5,2.5,3.5\n1,4.5,5.5,6.5\n",
            "skip_rows = 1 and skip_columns = 1",
        ),
        // Coordinates of the columns or rows alone, also next to a first cell that does not continue them.
        (
            "0,.5,1,1.5,2,2.5,3,3.5,4\n1,7,5,6,6,3,2,2,5\n3,4,9,5,5,1,1,6,1\n",
            "skip_rows = 1,",
        ),
        (
            "9 -.4 -.3 -.2 -.1 0 .1 .2 .3\n3 4 9 5 5 1 1 6 1\n",
            "skip_rows = 1,",
        ),
        (
            "0 7\n.5 5\n1 6\n1.5 6\n2 3\n2.5 2\n3 2\n3.5 5\n4 1\n",
            "skip_columns = 1,",
        ),
        // The labels are names.
        (",c0,c1\nr0,1.5,2.5\n", "skip_rows = 1"),
        ("r0,1.5,2.5\nr1,1,2\n", "skip_columns = 1"),
        ("0,1.5\n1,4.5\n", "skip_columns = 1,"),
        ("1,1.5,2.5\nr1,1,2\n", "skip_columns = 1"),
    ] {
        let error = parse(text).unwrap_err();
        assert!(matches!(error, Error::Format { .. }), "{error}");
        assert!(error.to_string().contains(remedy), "{text:?}: {error}");
    }
}

#[test]
fn csv_labels_are_skipped_by_options() {
    let options = io::csv::Options::default;
    let pandas = b",0,1,2\n0,1.5,2.5,3.5\n1,4.5,5.5,6.5\n";
    let heights = options().skip_rows(1).skip_columns(1);
    let heights = heights.parse(pandas, [1.0, 1.0]).unwrap();
    assert_eq!([heights.grid().nx(), heights.grid().ny()], [3, 2]);
    assert_eq!(heights.as_slice(), [1.5, 2.5, 3.5, 4.5, 5.5, 6.5]);
    let heights = options().without_labels().parse(pandas, [1.0, 1.0]);
    assert_eq!(heights.unwrap().as_slice()[1..5], [0.0, 1.0, 2.0, 0.0]);
}

#[test]
fn csv_ramps_and_floats_that_count_are_heights() {
    for text in [
        "0,1,2\n1,2,3\n2,3,4\n",
        "0,0\n1,1\n2,2\n",
        "0.0,1.0,2.0\n3.0,1.0,5.0\n",
        "0.0,1.0\n1.5,2.5\n",
        "1.0,2.0,3.0\n1.5,2.5,3.5\n",
        "0.0,1.0,2.5\n1.5,2.5,3.5\n",
        ",5,7\n3,4,9\n",
        "1 2 3\n",
        // Few even numbers, inclined surfaces with a pit, and a single line.
        "0,.5,1,1.5,2,2.5,3,3.5\n1,7,5,6,6,3,2,2\n",
        "0 .5 1 1.5 2 2.5 3 3.5 4\n1.2 1.7 0 2.7 3.2 3.7 4.2 4.7 5.2\n2.4 2.9 3.4 3.9 4.4 4.9 5.4 5.9 6.4\n",
        "0 1 2.5\n.5 1.5 3\n1 2 3.5\n1.5 0 4\n2 3 4.5\n2.5 3.5 5\n3 4 5.5\n3.5 4.5 6\n4 5 6.5\n",
        "0 .5 1 1.5 2 2.5 3 3.5 4\n",
        // A plane with a spike in its corner, and an edge that continues through the corner.
        "9,1.5,2,2.5\n3,3.5,4,4.5\n5,5.5,6,6.5\n7,7.5,8,8.5\n",
        "1,1.5,2,2.5\n3,3.5,4,9\n5,5.5,6,6.5\n7,7.5,8,8.5\n",
    ] {
        assert!(
            io::csv::parse(text.as_bytes(), [1.0, 1.0]).is_ok(),
            "{text:?}"
        );
    }
}

#[test]
fn csv_points_of_a_grid_are_rejected() {
    let point = |x: usize, y: usize| format!("{} {} {}\n", x, 0.5 * y as f64, (7 * x * y) % 5);
    let by_row: String = (0..9).map(|i| point(i % 3, i / 3)).collect();
    let by_column: String = (0..10).map(|i| point(i / 5, i % 5)).collect();
    for text in [&by_row, &by_column] {
        let error = io::csv::parse(text.as_bytes(), [1.0, 1.0]).unwrap_err();
        assert!(
            error.to_string().contains("read the file as XYZ"),
            "{error}"
        );
        let heights = io::csv::Options::default().without_labels();
        assert!(heights.parse(text.as_bytes(), [1.0, 1.0]).is_ok());
        assert!(io::xyz::parse(text.as_bytes()).is_ok());
    }
    let unordered = by_row.replacen("1 0 ", "2 0 ", 1);
    assert!(io::csv::parse(unordered.as_bytes(), [1.0, 1.0]).is_ok());
}
