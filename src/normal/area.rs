//! Where a normal contact touches: area, extent, warnings.

use std::sync::Arc;

use crate::contact::map::ContactMap;
use crate::error::Result;
use crate::memory::fallible::unwrap_or_abort;
use crate::normal::NormalSolution;
use crate::parallel::ranks::partition::RowPartition;
use crate::warning::Warning;

impl NormalSolution {
    /// Cells that carry pressure.
    #[must_use]
    pub fn contact_cells(&self) -> usize {
        self.contact_map().cells()
    }

    /// Contact area by counting cells; reads high by about 0.3 cell sides over the contact radius.
    #[must_use]
    pub fn contact_area(&self) -> f64 {
        self.contact_map().area()
    }

    /// Contact area with the perimeter corrected (Yastrebov, Anciaux & Molinari 2017,
    /// <https://doi.org/10.1016/j.triboint.2017.04.023>): nearer to the continuum by a factor of
    /// about four.
    #[must_use]
    pub fn contact_area_corrected(&self) -> f64 {
        self.contact_map().corrected_area()
    }

    /// Width of the whole contact along x and along y (lengths), between the outer edges of its outermost cells; `None`
    /// without contact.
    ///
    /// On a periodic grid it is the least width that holds all of the contact, across the edges too: the side of the
    /// grid less its longest stretch of columns, or rows, without contact.
    ///
    /// ```
    /// use stickslip::*;
    /// let grid = Grid::new(96, 64, 0.1, 0.1)?;
    /// let rubber = Material::new(1.0, 0.5)?;
    /// let bodies = HalfSpace::new(grid, ElasticPair::new(rubber, Material::rigid())?)?;
    /// let (gap, load) = (surface::ellipsoid(grid, 8.0, 2.0)?, NormalControl::Force(0.6));
    /// let contact = NormalProblem::builder(&bodies, &gap, load).build()?.solve()?;
    /// let hertz = analytical::HertzEllipse::new(bodies.pair(), 8.0, 2.0, 0.6)?;
    /// let [a, b] = hertz.semi_axes();
    /// let extent = contact.contact_extent();
    /// assert!(extent.is_some_and(|[x, y]| (x - 2.0 * a).abs() < 0.2 && (y - 2.0 * b).abs() < 0.2));
    /// # Ok::<(), Error>(())
    /// ```
    #[must_use]
    pub fn contact_extent(&self) -> Option<[f64; 2]> {
        let [columns, rows] = self.contact_map().counts().extent?;
        let grid = self.grid();
        Some([columns as f64 * grid.dx(), rows as f64 * grid.dy()])
    }

    /// Mean pressure over the contact by counting; zero without contact.
    #[must_use]
    pub fn mean_pressure(&self) -> f64 {
        let area = self.contact_area();
        if area > 0.0 { self.force() / area } else { 0.0 }
    }

    /// Remarks that a result may mislead; see [`Warning`].
    #[must_use]
    pub fn warnings(&self) -> Vec<Warning> {
        unwrap_or_abort(self.try_warnings())
    }

    /// [`Self::warnings`] where memory may run out.
    ///
    /// # Errors
    /// [`Error::Memory`](crate::Error::Memory).
    pub fn try_warnings(&self) -> Result<Vec<Warning>> {
        let cells = self.overloaded_cells();
        let beyond = (cells > 0).then_some(Warning::BeyondHardness { cells });
        let mut warnings = self.contact_map().warnings();
        warnings.extend(beyond);
        warnings.extend(self.discretisation_warning());
        warnings.extend(self.scale().warnings());
        Ok(warnings)
    }

    /// Cells whose pressure is beyond what the softer body bears, if it states that.
    pub(crate) fn overloaded_cells(&self) -> usize {
        if let Some(whole) = &self.whole {
            return whole.overloaded;
        }
        let hardness = self.pair.hardness();
        let pressure = self.pressure.as_slice().iter();
        if hardness.is_finite() {
            pressure.filter(|p| **p > hardness).count()
        } else {
            0
        }
    }

    /// Contact cells on the edge of a grid that has edges.
    pub(crate) fn cells_on_edge(&self) -> usize {
        self.contact_map().cells_on_edge()
    }

    /// Sides of cells along the edge of the contact.
    pub(crate) fn edge_sides(&self) -> usize {
        self.contact_map().switches()
    }

    pub(crate) fn contact_map(&self) -> ContactMap<'_, impl Fn(usize) -> bool + '_> {
        let (pressure, grid) = (self.pressure.as_slice(), self.grid());
        let counted = self.whole.as_ref().map(|whole| &whole.contact);
        ContactMap::of(grid, self.boundary, move |i| pressure[i] > 0.0, counted)
    }

    /// The map of the cells held here, without what lies around it.
    pub(crate) fn own_map(&self) -> ContactMap<'_, impl Fn(usize) -> bool + '_> {
        let pressure = self.pressure.as_slice();
        ContactMap {
            grid: self.grid(),
            repeats: [false; 2],
            contains: move |i| pressure[i] > 0.0,
            counted: None,
        }
    }

    /// How the cells are dealt out to ranks, if they are.
    pub(crate) fn share(&self) -> Option<&Arc<RowPartition>> {
        self.whole.as_ref().map(|whole| &whole.share)
    }
}
