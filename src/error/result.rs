//! Result type.

use crate::error::Error;

/// Result of a call that can fail.
///
/// A second parameter replaces the error, so that a glob import of this crate leaves the two-parameter `Result` of the
/// standard library usable.
///
/// ```
/// use stickslip::*;
/// fn cells(text: &str) -> Result<usize, std::num::ParseIntError> {
///     text.parse()
/// }
/// fn grid(cells: usize) -> Result<Grid> {
///     Grid::square(cells, 1.0)
/// }
/// assert!(cells("many").is_err() && grid(0).is_err());
/// ```
pub type Result<T, E = Error> = std::result::Result<T, E>;
