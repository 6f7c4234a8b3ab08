//! Row of the table: the key of a case, its results, and the reports of both solves.

use stickslip::{NormalSolution, Report, Status, TangentialSolution};

/// Columns of the key that identifies a case.
pub(super) const KEY: [&str; 7] = [
    "case", "cells", "hurst", "pressure", "seed", "friction", "pull",
];
/// Columns of results, empty if the solve failed. Lengths are divided by the rms height of the surface, areas by the
/// area of the square.
const NORMAL: [&str; 5] = [
    "contact_cells",
    "unresolved_spots",
    "contact_area",
    "contact_area_corrected",
    "mean_gap",
];
const TANGENTIAL: [&str; 2] = ["stick_ratio", "shift"];
/// Columns of the report of each solve. They contain no times, so that a row is reproducible.
const REPORT: [&str; 6] = [
    "status",
    "iterations",
    "double_products",
    "single_products",
    "residual",
    "energy_error",
];

/// Returns the names of all columns, the second line of a table.
pub(super) fn columns() -> String {
    let of = |solve: &str| REPORT.map(|column| format!("{solve}_{column}"));
    let results = KEY.iter().chain(&NORMAL).chain(&TANGENTIAL);
    let names: Vec<String> = results
        .map(ToString::to_string)
        .chain(of("normal"))
        .chain(of("tangential"))
        .collect();
    names.join(",")
}

/// Number of columns.
pub(super) const WIDTH: usize = KEY.len() + NORMAL.len() + TANGENTIAL.len() + 2 * REPORT.len();

/// Outcome of a solve.
#[derive(Debug)]
pub(super) enum Ending<T> {
    Solved(T),
    /// The solve did not converge.
    Failed(Box<Report>),
    /// No solve was possible: the pressure is missing, or friction cannot carry the force.
    Refused(&'static str),
}

impl<T> Ending<T> {
    pub(super) fn solution(&self) -> Option<&T> {
        match self {
            Self::Solved(solution) => Some(solution),
            Self::Failed(_) | Self::Refused(_) => None,
        }
    }

    fn report(&self, of: impl Fn(&T) -> &Report) -> [String; REPORT.len()] {
        let report = match self {
            Self::Solved(solution) => of(solution),
            Self::Failed(report) => report,
            Self::Refused(reason) => {
                let mut row = [const { String::new() }; REPORT.len()];
                (*reason).clone_into(&mut row[0]);
                return row;
            }
        };
        [
            report.status.to_string(),
            report.iterations.to_string(),
            report.double_precision_products.to_string(),
            report.single_precision_products.to_string(),
            number(report.residual),
            number(report.energy_error_bound()),
        ]
    }
}

/// Result of a finished case.
#[derive(Debug)]
pub(super) struct Row {
    /// Line of the table without the line break.
    pub(super) text: String,
    /// Whether both solves have converged.
    pub(super) is_solved: bool,
}

impl Row {
    /// Creates the row of a case on a surface of the given rms height from its key and both outcomes.
    pub(super) fn new(
        key: String,
        rms_height: f64,
        normal: &Ending<NormalSolution>,
        tangential: &Ending<TangentialSolution>,
    ) -> Self {
        let results = normal.solution().map(|normal| {
            let area = normal.grid().area();
            [
                normal.contact_cells().to_string(),
                unresolved(normal).map_or(String::new(), |spots| spots.to_string()),
                number(normal.contact_area() / area),
                number(normal.contact_area_corrected() / area),
                number(normal.gap().integral() / area / rms_height),
            ]
        });
        let shear = tangential.solution().map(|tangential| {
            [
                number(tangential.stick_ratio()),
                number(tangential.shift()[0] / rms_height),
            ]
        });
        let reports = [
            normal.report(NormalSolution::report),
            tangential.report(TangentialSolution::report),
        ];
        let converged = Status::Converged.to_string();
        let is_solved = reports.iter().all(|report| report[0] == converged);
        let mut fields = vec![key];
        fields.extend(results.unwrap_or_default());
        fields.extend(shear.unwrap_or_default());
        fields.extend(reports.into_iter().flatten());
        Self {
            text: fields.join(","),
            is_solved,
        }
    }
}

/// Formats a number with the fewest digits that are parsed to the same number.
fn number(value: f64) -> String {
    format!("{value:?}")
}

/// Returns the number of contact spots that are too small to be resolved.
fn unresolved(normal: &NormalSolution) -> stickslip::Result<usize> {
    let spots = normal.spots()?;
    let small = spots.as_slice().iter().filter(|spot| spot.cells < 5);
    Ok(small.count())
}
