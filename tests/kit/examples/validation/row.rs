//! Rows of the tables, and the measures and solves that several groups share.

use std::fs;
use std::io;

use stickslip::cgm::Method;
use stickslip::{
    Boundary, ElasticPair, Field, Friction, Grid, HalfSpace, Material, NormalLoad, NormalSolution,
    Result, TangentialLoad, TangentialSolution,
};

/// Offsets of a contact relative to the cells, in cells.
pub(crate) const OFFSETS: [[f64; 2]; 4] = [[0.0, 0.0], [0.31, -0.17], [-0.42, 0.48], [0.12, 0.43]];

/// Distance at which the displacement of a line contact is zero.
pub(crate) const DATUM: f64 = 50.0;

/// Tolerance of the solves, far below the discretisation error.
const TOLERANCE: f64 = 1e-10;

/// One comparison.
pub(crate) struct Row {
    /// Closed form or code, with its citation.
    pub(crate) reference: &'static str,
    pub(crate) quantity: &'static str,
    pub(crate) cells: String,
    pub(crate) error: f64,
    /// Module and name of the test that asserts the quantity.
    pub(crate) test: &'static str,
}

/// Returns one row for each pair of a quantity and its error.
pub(crate) fn rows<const N: usize>(
    reference: &'static str,
    cells: &str,
    test: &'static str,
    quantities: [(&'static str, f64); N],
) -> impl Iterator<Item = Row> {
    let cells = cells.to_owned();
    quantities.into_iter().map(move |(quantity, error)| Row {
        reference,
        quantity,
        cells: cells.clone(),
        error,
        test,
    })
}

/// Returns whether a module of `tests/it` contains a function, given as `module::function`.
pub(crate) fn has_test(test: &str) -> io::Result<bool> {
    let Some((module, function)) = test.rsplit_once("::") else {
        return Ok(false);
    };
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../it");
    let source = fs::read_to_string(format!("{folder}/{}.rs", module.replace("::", "/")))?;
    Ok(source.contains(&format!("#[test]\nfn {function}(")))
}

pub(crate) fn relative(found: f64, expected: f64) -> f64 {
    (found / expected - 1.0).abs()
}

/// Updates the largest errors so far with the errors at one position.
pub(crate) fn raise<const N: usize>(largest: &mut [f64; N], errors: [f64; N]) {
    for (largest, error) in largest.iter_mut().zip(errors) {
        *largest = largest.max(error);
    }
}

/// Returns the distances from a point that is the given number of cells from the middle of the grid.
pub(crate) fn radius_about(grid: Grid, [x0, y0]: [f64; 2]) -> impl Fn(f64, f64) -> f64 + Copy {
    move |x, y| (x - x0 * grid.dx()).hypot(y - y0 * grid.dy())
}

/// Returns `sum |a - b| / sum |b|` for a field and its closed form.
pub(crate) fn l1(found: &Field, exact: impl Fn(f64, f64) -> f64) -> f64 {
    kit::measure::distance(found, &Field::from_fn(found.grid(), exact))
}

/// Returns the largest difference relative to the largest expected value.
pub(crate) fn largest_difference(found: &[f64], expected: &[f64]) -> f64 {
    kit::max_difference(found, expected) / kit::max_abs(expected)
}

pub(crate) fn alike(body: Material) -> Result<ElasticPair> {
    ElasticPair::new(body, body)
}

pub(crate) fn on_rigid(poisson_ratio: f64) -> Result<ElasticPair> {
    ElasticPair::new(Material::new(1.0, poisson_ratio)?, Material::rigid())
}

/// Returns a body on a rigid one with the given Dundurs' beta.
pub(crate) fn with_beta(beta: f64) -> Result<ElasticPair> {
    on_rigid((1.0 - 2.0 * beta) / (2.0 - 2.0 * beta))
}

/// Returns bodies on a line of cells in plane strain.
pub(crate) fn line(cells: usize, width: f64, pair: &ElasticPair) -> Result<HalfSpace> {
    let grid = Grid::line(cells, width / cells as f64)?;
    HalfSpace::with_boundary(grid, *pair, Boundary::PeriodicAlongY { datum: DATUM })
}

pub(crate) fn press(bodies: &HalfSpace, gap: &Field, force: f64) -> NormalSolution {
    let load = NormalLoad::Force(force);
    kit::press(bodies, gap, load, TOLERANCE)
}

/// Shears a pressed contact along x.
pub(crate) fn shear(
    bodies: &HalfSpace,
    normal: &NormalSolution,
    coefficient: f64,
    force: f64,
) -> Result<TangentialSolution> {
    let friction = Friction::coulomb(coefficient)?;
    let load = TangentialLoad::force([force, 0.0]);
    let method = Method::ActiveSet;
    Ok(kit::shear_by(
        bodies, normal, &friction, load, TOLERANCE, method,
    ))
}

/// Returns the numbers at the commas of a line of a data file.
pub(crate) fn numbers(line: &str) -> Vec<f64> {
    let entries = line.trim_start_matches("# ").split(',');
    entries.filter_map(|text| text.parse().ok()).collect()
}

/// Returns the lines of a data file without comments and without the line of column names.
pub(crate) fn data_lines(table: &str) -> impl Iterator<Item = &str> {
    table.lines().filter(|line| !line.starts_with('#')).skip(1)
}
