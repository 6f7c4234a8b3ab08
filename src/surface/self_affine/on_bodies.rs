//! Rough surfaces on distributed bodies.

use std::sync::Arc;

use crate::error::{Error, RankFailure, Result, all_finite};
use crate::grid::Grid;
use crate::grid::field::Field;
use crate::half_space::HalfSpace;
use crate::parallel;
use crate::parallel::layout::Layout;
use crate::parallel::ranks::partition::RowPartition;
use crate::surface::self_affine::SelfAffine;
use crate::surface::self_affine::crop_window::CropWindow;
use crate::surface::self_affine::moments::mean_over;
use crate::surface::waves::{Waves, shared_columns};

impl SelfAffine {
    /// Generates the heights of the surface on the grid of the bodies (lengths, out of the body). If the bodies are
    /// [distributed](HalfSpace::distributed), each rank generates its local rows. The heights are bitwise identical to
    /// those of [`SelfAffine::generate`].
    ///
    /// # Errors
    /// - The errors of [`SelfAffine::generate`].
    /// - [`Error::Ranks`] if the bodies are distributed and the surface is cropped, has a given skewness or kurtosis,
    ///   or differs between ranks.
    pub fn generate_on(&self, bodies: &HalfSpace) -> Result<Field> {
        let grid = bodies.grid().whole();
        bodies.collective_result_checked(Ok(()), &[("rough surface", self)])?;
        match bodies.share(grid.size()) {
            Some(rows) => bodies.collective_result(self.generate_slab(grid, &rows)),
            None => Ok(self.generate(grid)?.into_heights()),
        }
    }
}

impl SelfAffine {
    /// Generates the heights on the local slab of a grid.
    pub(crate) fn generate_slab(&self, grid: Grid, rows: &Arc<RowPartition>) -> Result<Field> {
        let quantity = match (self.moments()?, self.is_cropped) {
            (None, false) => None,
            (Some(_), _) => Some("a surface of given skewness or kurtosis"),
            (None, true) => Some("a cropped surface"),
        };
        if let Some(quantity) = quantity {
            return Err(Error::Ranks(RankFailure::UnsupportedOnRanks(quantity)));
        }
        let target = self.target.checked()?;
        let columns = Arc::new(shared_columns(grid, rows.team()));
        let cells = rows.local_rows().len() * grid.nx();
        let mut heights = parallel::enter_with(cells, || -> Result<Field> {
            let waves = Waves::none_on(grid, Some(&columns));
            let waves = self.waves(&CropWindow::all(grid), waves)?;
            Ok(waves.into_slab(&columns, rows))
        })?;
        let layout = Layout::shared(Arc::clone(rows));
        let mean = mean_over(&layout, heights.as_slice(), |z| z);
        for height in heights.as_mut_slice() {
            *height = (*height - mean) * target;
        }
        all_finite("height of the rough surface", heights.as_slice())?;
        Ok(heights)
    }
}
