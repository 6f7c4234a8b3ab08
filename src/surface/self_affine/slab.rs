//! The part of a surface that a rank makes of a shared grid.

use std::sync::Arc;

use super::SelfAffine;
use super::cut::Cut;
use super::moments::mean_over;
use crate::error::{Error, RankFailure, Result, all_finite};
use crate::grid::Grid;
use crate::grid::field::Field;
use crate::parallel;
use crate::parallel::layout::Layout;
use crate::parallel::ranks::partition::Share;
use crate::surface::waves::{Waves, shared_columns};

impl SelfAffine {
    /// The heights on the slab that a rank holds of a grid.
    pub(crate) fn generate_slab(&self, grid: Grid, rows: &Arc<Share>) -> Result<Field> {
        let quantity = match (self.moments()?, self.is_cropped) {
            (None, false) => None,
            (Some(_), _) => Some("a surface of given skewness or kurtosis"),
            (None, true) => Some("a cropped surface"),
        };
        if let Some(quantity) = quantity {
            return Err(Error::Ranks(RankFailure::NotShared(quantity)));
        }
        let target = self.target.checked()?;
        let columns = Arc::new(shared_columns(grid, rows.team()));
        let cells = rows.own_rows().len() * grid.nx();
        let mut heights = parallel::enter_with(cells, || -> Result<Field> {
            let waves = Waves::none_on(grid, Some(&columns));
            let waves = self.waves(&Cut::all(grid), waves)?;
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
