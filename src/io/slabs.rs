//! Files of fields that ranks hold slab by slab.

use std::path::Path;

use crate::error::Result;
use crate::grid::field::Field;
use crate::half_space::HalfSpace;
use crate::io::vti::{self, Array};
use crate::io::{npy, pvti};

impl HalfSpace {
    /// The field in an NPY file of the shape of the whole grid, `(ny, nx)`, on the cells held here: all ranks call this
    /// alike, and each reads its own rows only. As [`io::npy::read`](npy::read), and the grid of the file is told by
    /// [`io::npy::grid`](npy::grid).
    ///
    /// # Errors
    /// [`Error::File`](crate::Error::File) if the file cannot be read; [`Error::Format`](crate::Error::Format) as
    /// [`io::npy::parse`](npy::parse), and for an array of another shape; [`Error::Ranks`](crate::Error::Ranks) if
    /// another rank has failed.
    pub fn read_npy(&self, path: impl AsRef<Path>) -> Result<Field> {
        self.collective_result(npy::read_slab(path.as_ref(), self.grid()))
    }

    /// Writes a field to one NPY file of the whole grid: all ranks call this alike, and each writes its own rows only. The
    /// file is that of [`io::npy::write`](npy::write), byte by byte, on any number of ranks.
    ///
    /// The file is replaced as a whole when every rank has written its rows to the disk, or not at all: until then all is
    /// written to `NAME.PID.NUMBER.part` beside it, which is removed after a failure and is left only by a process that is
    /// killed. A rank that loses the others at the very end returns an error of a file that is complete.
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
    /// [`Error::GridMismatch`](crate::Error::GridMismatch); [`Error::File`](crate::Error::File) if the file cannot be
    /// written; [`Error::Ranks`](crate::Error::Ranks) if another rank has failed.
    pub fn write_npy(&self, path: impl AsRef<Path>, field: &Field) -> Result<()> {
        self.collective_result(self.grid().expect("the field to be written", field.grid()))?;
        npy::write_slab(path.as_ref(), field, self.sharing().map(|team| &**team))
    }

    /// Writes named fields and vectors for ParaView: all ranks call this alike, each writes the image of its own rows, and
    /// the first the list of these images, which shows the whole grid.
    ///
    /// The list has the path given, `run.pvti`, and the images lie beside it, `run_0.vti`, `run_1.vti`, ..., as
    /// [`io::vti::write`](vti::write) writes them; a rank without rows has none. Without ranks there is one image.
    ///
    /// As long as not all images are on the disk a failure leaves everything as it was. Then an earlier list is removed,
    /// the images take their names, and at last the new list its own: there is never one of old and new images.
    ///
    /// ```no_run
    /// # fn show(bodies: &stickslip::HalfSpace, contact: &stickslip::NormalSolution) -> stickslip::Result<()> {
    /// bodies.write_pvti("run.pvti", &[("pressure", contact.pressure()), ("gap", contact.gap())])?;
    /// # Ok(())
    /// # }
    /// ```
    ///
    /// # Errors
    /// As [`io::vti::to_bytes`](vti::to_bytes); [`Error::GridMismatch`](crate::Error::GridMismatch);
    /// [`Error::Format`](crate::Error::Format) for a path without a name in UTF-8; [`Error::File`](crate::Error::File) if a
    /// file cannot be written; [`Error::Ranks`](crate::Error::Ranks) if another rank has failed.
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
