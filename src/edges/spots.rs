//! The areas of contact spots, including the covered fractions of the cells at their edges.

use crate::edges::Edges;
use crate::error::Result;
use crate::grid::neighbours::neighbours;
use crate::memory::fallible;
use crate::spots::ContactSpots;

impl Edges {
    /// Returns the areas of the spots of this contact (lengths squared), in the order of the spots. For a stick zone it returns
    /// the stick area in each spot. The areas include the covered fractions of the cells at the edges, whereas
    /// [`Spot::area`](crate::Spot::area) counts cells. The sum of the areas is the [area](Self::area). A cell between several
    /// spots is divided among these spots in proportion to the number of their cells that touch it. If the spots belong to a
    /// different contact, cells without an adjacent spot are omitted.
    ///
    /// ```
    /// use stickslip::*;
    /// let grid = Grid::new(128, 48, 0.1, 0.1)?;
    /// let pair = ElasticPair::new(Material::new(1.0, 0.0)?, Material::rigid())?;
    /// let bodies = HalfSpace::new(grid, pair)?.with_cell_value(CellValue::Centre)?;
    /// // Two balls of radius 1, the second lower by 0.2.
    /// let ball = |x: f64, y: f64| 0.5 * (x * x + y * y);
    /// let gap = Field::from_fn(grid, |x, y| ball(x + 3.2, y).min(ball(x - 3.2, y) + 0.2));
    /// let load = NormalLoad::Force(2.0);
    /// let contact = NormalProblem::builder(&bodies, &gap, load).build()?.solve()?;
    /// let (spots, edges) = (contact.spots()?, contact.edges()?);
    /// let areas = edges.areas_of(&spots)?;
    /// for (spot, area) in spots.as_slice().iter().zip(&areas) {
    ///     // Hertz under the load of the spot; the other spot is so far away that its displacement is nearly uniform here.
    ///     let hertz = analytical::HertzSphere::new(&pair, 1.0, spot.load)?.contact_area();
    ///     assert!((area / hertz - 1.0).abs() < 5e-3, "{area} {hertz}");
    /// }
    /// assert!((areas.iter().sum::<f64>() - edges.area()).abs() < 1e-12);
    /// # Ok::<(), Error>(())
    /// ```
    ///
    /// # Errors
    /// - [`Error::GridMismatch`](crate::Error::GridMismatch) if the spots have a different grid.
    /// - [`Error::Memory`](crate::Error::Memory) if memory runs out.
    pub fn areas_of(&self, spots: &ContactSpots) -> Result<Vec<f64>> {
        let grid = self.grid();
        grid.check_equal("contact spots", spots.grid())?;
        let mut areas = fallible::zeros(spots.as_slice().len())?;
        let has_value = |centre: f64| if centre > 0.0 { 1.0 } else { 0.0 };
        for (cell, centre) in self.centres.iter().enumerate() {
            if let Some(spot) = spots.label(cell) {
                areas[spot] += has_value(*centre);
            }
        }
        for cell in &self.cells {
            if let Some(spot) = spots.label(cell.index) {
                areas[spot] += cell.covered - has_value(cell.centre);
                continue;
            }
            let around = self
                .around(cell.index)
                .map(|next| next.and_then(|next| spots.label(next)));
            let count = around.iter().flatten().count();
            for spot in around.into_iter().flatten() {
                areas[spot] += cell.covered / count as f64;
            }
        }
        for area in &mut areas {
            *area *= grid.cell_area();
        }
        Ok(areas)
    }

    /// Returns the eight cells around a cell.
    fn around(&self, cell: usize) -> [Option<usize>; 8] {
        let beside = |cell| neighbours(cell, self.grid().size(), self.repeats);
        let [left, below, right, above] = beside(cell);
        let [below_left, _, below_right, _] = below.map_or([None; 4], beside);
        let [above_left, _, above_right, _] = above.map_or([None; 4], beside);
        [
            left,
            below,
            right,
            above,
            below_left,
            below_right,
            above_left,
            above_right,
        ]
    }
}
