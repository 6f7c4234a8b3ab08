//! Files of distributed fields.

use std::path::Path;

use crate::error::Result;
use crate::grid::field::Field;
use crate::half_space::HalfSpace;
use crate::io::vti::{self, Array};
use crate::io::{npy, pvti};

impl HalfSpace {
    /// Reads the local rows of a field from an NPY file of the shape of the whole grid, `(ny, nx)`. The call is collective, and
    /// each rank reads only its own rows. The function supports the same files as [`io::npy::read`](npy::read). To read the grid
    /// of a file, use [`io::npy::grid`](npy::grid). Numbers that may mark missing points are read as samples.
    ///
    /// # Errors
    /// - [`Error::File`](crate::Error::File) if the file cannot be read.
    /// - [`Error::Format`](crate::Error::Format) for the reasons given at [`io::npy::parse`](npy::parse), or if the array has a
    ///   different shape.
    /// - [`Error::Ranks`](crate::Error::Ranks) if another rank has failed.
    pub fn read_npy(&self, path: impl AsRef<Path>) -> Result<Field> {
        self.collective_result(npy::read_slab(path.as_ref(), self.grid()))
    }

    /// Writes a field to a single NPY file of the whole grid. The call is collective, and each rank writes only its own rows.
    /// The file is identical to the file of [`io::npy::write`](npy::write) for any number of ranks.
    ///
    /// The rows are first written to `NAME.PID.NUMBER.part` in the same folder. When every rank has written its rows to the disk,
    /// this temporary file replaces the target. The target is therefore replaced completely or not at all. A failed call removes
    /// the temporary file. It remains only if the process is killed. A rank that loses the connection to the other ranks after
    /// the replacement returns an error although the file is complete.
    ///
    /// ```
    /// use std::sync::Arc;
    /// use std::time::Duration;
    /// use stickslip::ranks::Threads;
    /// use stickslip::{Boundary, ElasticPair, Field, Grid, HalfSpace, Material, io::npy};
    /// # let path = std::env::temp_dir().join(format!("stickslip_slabs_{}.npy", std::process::id()));
    /// let pair = ElasticPair::new(Material::new(1.0, 0.3)?, Material::rigid())?;
    /// let grid = Grid::new(40, 300, 0.5, 0.5)?;
    /// let outcomes = Threads::run(3, Duration::from_secs(60), |rank| -> stickslip::Result<()> {
    ///     let bodies = HalfSpace::distributed(grid, pair, Boundary::Periodic, Arc::new(rank))?;
    ///     let slab = Field::from_fn(bodies.grid(), |x, y| x * y);
    ///     bodies.write_npy(&path, &slab)?;
    ///     assert_eq!(bodies.read_npy(&path)?, slab);
    ///     Ok(())
    /// });
    /// outcomes.into_iter().collect::<stickslip::Result<()>>()?;
    /// assert_eq!(npy::read(&path, [0.5, 0.5])?, Field::from_fn(grid, |x, y| x * y));
    /// # std::fs::remove_file(path).ok();
    /// # Ok::<(), stickslip::Error>(())
    /// ```
    ///
    /// # Errors
    /// - [`Error::GridMismatch`](crate::Error::GridMismatch) if the field is on a different grid.
    /// - [`Error::File`](crate::Error::File) if the file cannot be written.
    /// - [`Error::Ranks`](crate::Error::Ranks) if another rank has failed.
    pub fn write_npy(&self, path: impl AsRef<Path>, field: &Field) -> Result<()> {
        self.collective_result(
            self.grid()
                .check_equal("the field to be written", field.grid()),
        )?;
        npy::write_slab(path.as_ref(), field, self.sharing().map(|team| &**team))
    }

    /// Writes named fields and vectors for ParaView. The call is collective. Each rank writes the image of its own rows. The
    /// first rank writes the list of the images, which represents the whole grid.
    ///
    /// The list has the given path, for example `run.pvti`. The images `run_0.vti`, `run_1.vti` and so on are in the
    /// same folder, in the form of [`io::vti::write`](vti::write). A rank without rows writes no image. Without ranks
    /// there is a single image.
    ///
    /// A failure before all images are on the disk leaves existing files unchanged. Once all images are on the disk, an earlier
    /// list is removed, the images are renamed, and the new list is written. A list therefore never refers to both old and new
    /// images.
    ///
    /// ```no_run
    /// # fn show(bodies: &stickslip::HalfSpace, contact: &stickslip::NormalSolution) -> stickslip::Result<()> {
    /// bodies.write_pvti("run.pvti", &[("pressure", contact.pressure()), ("gap", contact.gap())])?;
    /// # Ok(())
    /// # }
    /// ```
    ///
    /// # Errors
    /// - The errors of [`io::vti::to_bytes`](vti::to_bytes).
    /// - [`Error::GridMismatch`](crate::Error::GridMismatch) if a field is on a different grid.
    /// - [`Error::Format`](crate::Error::Format) if the path has no name in UTF-8.
    /// - [`Error::File`](crate::Error::File) if a file cannot be written.
    /// - [`Error::Ranks`](crate::Error::Ranks) if another rank has failed.
    #[doc(alias = "ParaView")]
    pub fn write_pvti<'a>(
        &self,
        path: impl AsRef<Path>,
        fields: &[(&str, impl Into<Array<'a>> + Copy)],
    ) -> Result<()> {
        let share = self.share(self.size());
        pvti::write(
            path.as_ref(),
            self.grid(),
            &vti::named(fields),
            share.as_deref(),
        )
    }
}
