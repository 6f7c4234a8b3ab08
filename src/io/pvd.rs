//! PVD, a time series of files for ParaView.
//!
//! Source: <https://www.paraview.org/Wiki/ParaView/Data_formats#PVD_File_Format>.

use std::fmt::Write;
use std::path::{Path, PathBuf};

use super::vti::{self, Array, escape};
use crate::error::{Result, finite};
use crate::files::{Format, replace_bytes};

const FORMAT: Format = Format("PVD");

/// Series of [VTI](super::vti) files and the PVD file that lists them with their times.
///
/// The files of the series are in the same folder as the PVD file. Their names consist of the name of the PVD file and
/// a number, for example `run.0000.vti` and `run.0001.vti` for `run.pvd`. The PVD file is replaced after every file.
/// The series can therefore be opened during the run, and it is still readable if the run is aborted.
///
/// ```no_run
/// use stickslip::io::{pvd::PvdWriter, vti::Array};
/// # fn run(history: &stickslip::History) -> stickslip::Result<()> {
/// let mut series = PvdWriter::new("target/run.pvd")?;
/// series.write(
///     0.5,
///     &[("pressure", Array::from(history.pressure())), ("traction", history.traction().into())],
/// )?;
/// # Ok(())
/// # }
/// ```
#[derive(Debug, Clone)]
pub struct PvdWriter {
    path: PathBuf,
    /// Name of the series, without its extension.
    name: String,
    times: Vec<f64>,
}

impl PvdWriter {
    /// Creates an empty series. An existing PVD file is replaced.
    ///
    /// # Errors
    /// - [`Error::Format`](crate::Error::Format) if the path has no name in UTF-8.
    /// - [`Error::File`](crate::Error::File) if the file cannot be written.
    pub fn new(path: impl AsRef<Path>) -> Result<Self> {
        let path = path.as_ref();
        let Some(name) = path.file_stem().and_then(|name| name.to_str()) else {
            let problem = "the path has no file name in UTF-8";
            return Err(FORMAT.in_entry(&path.display().to_string(), problem));
        };
        let series = Self {
            path: path.to_owned(),
            name: name.to_owned(),
            times: Vec::new(),
        };
        replace_bytes(path, series.to_text().as_bytes())?;
        Ok(series)
    }

    /// Writes fields and vectors to the next file and adds this file to the PVD file with the given time. The time
    /// may be a number of cycles.
    ///
    /// # Errors
    /// - [`Error::NotFinite`](crate::Error::NotFinite) if the time is not finite.
    /// - The errors of [`vti::write`].
    pub fn write<'a>(
        &mut self,
        time: f64,
        fields: &[(&str, impl Into<Array<'a>> + Copy)],
    ) -> Result<()> {
        finite("time", time)?;
        let file = self.path.with_file_name(self.file(self.times.len()));
        vti::write(file, fields)?;
        self.times.push(time);
        let listed = replace_bytes(&self.path, self.to_text().as_bytes());
        if listed.is_err() {
            self.times.pop();
        }
        listed
    }

    /// Returns the number of files written so far.
    #[must_use]
    pub fn len(&self) -> usize {
        self.times.len()
    }

    /// Returns whether no file has been written.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.times.is_empty()
    }

    fn file(&self, number: usize) -> String {
        format!("{}.{number:04}.vti", self.name)
    }

    fn to_text(&self) -> String {
        let mut text = String::from(
            r#"<?xml version="1.0"?>
<VTKFile type="Collection" version="1.0" byte_order="LittleEndian">
  <Collection>
"#,
        );
        for (number, time) in self.times.iter().enumerate() {
            let file = escape(&self.file(number));
            writeln!(
                text,
                r#"    <DataSet timestep="{time}" part="0" file="{file}"/>"#
            )
            .expect("writing to a string cannot fail");
        }
        text.push_str("  </Collection>\n</VTKFile>\n");
        text
    }
}
