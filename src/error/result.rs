//! Result type.

use crate::error::Error;

/// Result of a call that can fail.
///
/// An optional second parameter replaces the error type. After a glob import of this crate, the two-parameter `Result`
/// of the standard library therefore remains usable.
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
