//! Tables of numbers as files.

use std::fmt::Write;
use std::path::PathBuf;

use super::gallery;

/// Writes rows of numbers under a header to `target/gallery`, comma separated.
pub(crate) fn csv<const N: usize>(
    name: &str,
    header: [&str; N],
    rows: impl IntoIterator<Item = [f64; N]>,
) -> Result<PathBuf, std::io::Error> {
    let mut text = header.join(",");
    text.push('\n');
    for row in rows {
        let row = row.map(|value| value.to_string()).join(",");
        let _ = writeln!(text, "{row}");
    }
    let path = gallery(name)?;
    std::fs::write(&path, text)?;
    Ok(path)
}
