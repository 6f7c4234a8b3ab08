//! Contact area, extent and warnings of a normal contact.

use std::sync::Arc;

use crate::contact::map::ContactMap;
use crate::error::Result;
use crate::memory::fallible::unwrap_or_abort;
use crate::normal::NormalSolution;
use crate::parallel::ranks::partition::RowPartition;
use crate::warning::{LOWEST_HARDNESS, THICKEST_LAYER, Warning};

/// Smallest effective layer: the thickness over the side of a cell, times the contrast of the shear moduli. A layer changes the
/// response to the shortest waves by a few times this relative amount, and a contact radius of five cells by less than a fifth.
/// Such an effect is smaller than the discretisation error.
const THINNEST_LAYER: f64 = 1e-2;

impl NormalSolution {
    /// Returns the number of cells that carry pressure.
    #[must_use]
    pub fn contact_cells(&self) -> usize {
        self.contact_map().cells()
    }

    /// Returns the contact area from the number of contact cells. This area is too large. On a sphere its mean relative
    /// error is 0.23 times the ratio of the cell side to the contact radius, and at most 0.5 times this ratio.
    #[must_use]
    pub fn contact_area(&self) -> f64 {
        self.contact_map().area()
    }

    /// Returns the contact area with a correction of the perimeter (Yastrebov, Anciaux & Molinari 2017,
    /// <https://doi.org/10.1016/j.triboint.2017.04.023>). Its error is about a third of the error of
    /// [`Self::contact_area`].
    #[must_use]
    pub fn contact_area_corrected(&self) -> f64 {
        self.contact_map().corrected_area()
    }

    /// Returns the width of the whole contact along x and along y (lengths). It is measured between the outer edges of
    /// the outermost cells. Returns `None` without contact.
    ///
    /// On a periodic grid the width along an axis is the least width that contains the whole contact. The contact may
    /// continue across the edges of the grid. The width equals the side of the grid minus the longest stretch of
    /// columns or rows without contact.
    ///
    /// ```
    /// use stickslip::*;
    /// let grid = Grid::new(96, 64, 0.1, 0.1)?;
    /// let rubber = Material::new(1.0, 0.5)?;
    /// let bodies = HalfSpace::new(grid, ElasticPair::new(rubber, Material::rigid())?)?;
    /// let (gap, load) = (surface::ellipsoid(grid, 8.0, 2.0)?, NormalLoad::Force(0.6));
    /// let contact = NormalProblem::builder(&bodies, &gap, load).build()?.solve()?;
    /// let hertz = analytical::HertzEllipse::new(bodies.pair(), 8.0, 2.0, 0.6)?;
    /// let [a, b] = hertz.semi_axes();
    /// let extent = contact.contact_extent();
    /// assert!(extent.is_some_and(|[x, y]| (x - 2.0 * a).abs() < 0.2 && (y - 2.0 * b).abs() < 0.2));
    /// # Ok::<(), Error>(())
    /// ```
    #[must_use]
    pub fn contact_extent(&self) -> Option<[f64; 2]> {
        let [columns, rows] = unwrap_or_abort(self.contact_map().counts()).extent?;
        let grid = self.grid();
        Some([columns as f64 * grid.dx(), rows as f64 * grid.dy()])
    }

    /// Returns the mean pressure over the [contact area](Self::contact_area), or zero without contact.
    #[must_use]
    pub fn mean_pressure(&self) -> f64 {
        let area = self.contact_area();
        if area > 0.0 { self.force() / area } else { 0.0 }
    }

    /// Returns the warnings about results that may be misleading. See [`Warning`].
    #[must_use]
    pub fn warnings(&self) -> Vec<Warning> {
        unwrap_or_abort(self.try_warnings())
    }

    /// Returns the same warnings as [`Self::warnings`], or an error if memory runs out.
    ///
    /// # Errors
    /// - [`Error::Memory`](crate::Error::Memory) if memory runs out.
    pub fn try_warnings(&self) -> Result<Vec<Warning>> {
        let cells = self.overloaded_cells();
        let beyond = (cells > 0).then_some(Warning::BeyondHardness { cells });
        let mut warnings = self.contact_map().warnings()?;
        warnings.extend(Warning::of_status(self.report().status));
        warnings.extend(beyond);
        let [low, high] = [self.low_hardness(), self.high_hardness()];
        warnings.extend(Warning::of_hardness(low, high));
        warnings.extend(self.discretisation_warning()?);
        warnings.extend(self.scale().warnings());
        warnings.extend(self.coating_warnings().into_iter().flatten());
        Ok(warnings)
    }

    /// Returns the warnings about layers above [`THICKEST_LAYER`] or below [`THINNEST_LAYER`].
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "both ratios are positive, and a large one saturates"
    )]
    fn coating_warnings(&self) -> [Option<Warning>; 2] {
        let (grid, bodies) = (self.grid(), self.pair.bodies());
        let (longest, cell) = (grid.whole().reference_side(), grid.dx().min(grid.dy()));
        let layers = || {
            bodies.iter().flat_map(|body| {
                let base = body.shear_modulus();
                body.layers().iter().map(move |layer| (layer, base))
            })
        };
        let thickest = layers().map(|(layer, _)| layer.thickness());
        let sides = thickest.fold(0.0, f64::max) / longest;
        let thick = (sides > THICKEST_LAYER as f64).then(|| Warning::CoatingBeyondGrid {
            sides: sides.round() as usize,
        });
        let without_effect = layers().filter(|(layer, base)| {
            let contrast = layer.shear_modulus() / base;
            layer.thickness() * contrast.max(contrast.recip()) < THINNEST_LAYER * cell
        });
        let thinnest = without_effect
            .map(|(layer, _)| layer.thickness())
            .reduce(f64::min);
        let thin = thinnest.map(|thickness| Warning::CoatingBelowCell {
            parts: (cell / thickness).round() as usize,
        });
        [thick, thin]
    }

    /// Returns the number of cells whose pressure exceeds the hardness of the softer body, or zero if its material has
    /// no hardness.
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

    /// Returns the contact modulus divided by the largest pressure if almost all contact cells are at a hardness far below
    /// this modulus.
    pub(crate) fn low_hardness(&self) -> Option<usize> {
        let parts = self.scale().modulus_parts();
        // The edge of the contact may contain a few elastic cells.
        let is_yielded = || 10 * self.yielded_cells() >= 9 * self.contact_cells();
        (parts > LOWEST_HARDNESS && is_yielded()).then_some(parts)
    }

    /// Returns the hardness divided by the plane-strain modulus in thousandths, if the hardness exceeds this modulus and no cell has
    /// reached it. The larger one of two such values counts: the hardness of a material and the limit of the pressure.
    pub(crate) fn high_hardness(&self) -> Option<usize> {
        let of_material = self.pair.hardness_over_modulus();
        let of_material = of_material
            .and_then(Warning::limit_beyond)
            .filter(|_| self.overloaded_cells() == 0);
        of_material.max(self.hardness_per_mille)
    }

    /// Returns the number of contact cells on the edges across which the grid is not periodic.
    pub(crate) fn cells_on_edge(&self) -> usize {
        self.contact_map().cells_on_edge()
    }

    /// Returns the number of cell sides along the edge of the contact.
    pub(crate) fn edge_sides(&self) -> usize {
        self.contact_map().switches()
    }

    pub(crate) fn contact_map(&self) -> ContactMap<'_, impl Fn(usize) -> bool + '_> {
        let (pressure, grid) = (self.pressure.as_slice(), self.grid());
        let counted = self.whole.as_ref().map(|whole| &whole.contact);
        ContactMap::of(grid, self.boundary, move |i| pressure[i] > 0.0, counted)
    }

    /// Returns the partition of the cells over ranks, or `None` if the grid is not distributed.
    pub(crate) fn share(&self) -> Option<&Arc<RowPartition>> {
        self.whole.as_ref().map(|whole| &whole.share)
    }
}
