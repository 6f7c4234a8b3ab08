//! Relative displacements of the bodies that the contact does not cause.

use crate::error::{Error, Result, all_finite};
use crate::grid::Grid;
use crate::grid::field::{Field, clone_in_place};
use crate::half_space::HalfSpace;
use crate::memory::fallible::{try_clone, try_each};
use crate::parallel::reduce;
use crate::tangential::{Axis, TangentialModel, centre};
use crate::warning::Warning;

/// Tangential displacement w of body 1 relative to body 2 in each cell, which the contact does not cause (lengths,
/// `[x, y]`). Examples are bulk strain, thermal expansion and the deformation due to a nearby contact.
///
/// The slip is then $`s = u + w - \delta`$. In stick zones, the tractions compensate w. A uniform w acts like a shift of the
/// opposite sign. See Nowell & Hills, Int. J. Mech. Sci. 29 (1987) 355.
///
/// ```
/// use stickslip::tangential::RelativeDisplacement;
/// use stickslip::{Grid, Material};
/// // A flat specimen (body 1), too wide to contract along y, under a bulk stress of 100 MPa along x.
/// let titanium = Material::new(115e3, 0.32)?;
/// let grid = Grid::line(64, 0.01)?;
/// let strain = titanium.plane_strain_under(100.0);
/// let bulk = RelativeDisplacement::bulk_strain(grid, [[strain, 0.0], [0.0, 0.0]])?;
/// let [along_x, _] = bulk.fields();
/// let stretch = along_x.get(63, 0).unwrap() - along_x.get(0, 0).unwrap();
/// assert!((stretch - 0.63 * strain).abs() < 1e-15);
/// # Ok::<(), stickslip::Error>(())
/// ```
#[derive(Debug)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(try_from = "RawRelativeDisplacement")
)]
pub struct RelativeDisplacement {
    fields: [Field; 2],
    /// Uniform strain from which the displacements were created. Zero if the displacements were created from fields.
    strain: [[f64; 2]; 2],
}

/// Deserialised value before validation.
#[cfg(feature = "serde")]
#[derive(serde::Deserialize)]
#[serde(deny_unknown_fields)]
struct RawRelativeDisplacement {
    fields: [Field; 2],
    strain: [[f64; 2]; 2],
}

#[cfg(feature = "serde")]
impl TryFrom<RawRelativeDisplacement> for RelativeDisplacement {
    type Error = Error;

    fn try_from(read: RawRelativeDisplacement) -> Result<Self> {
        check_strain(read.strain)?;
        Ok(Self {
            strain: read.strain,
            ..Self::new(read.fields)?
        })
    }
}

/// Relative difference of the shear components that counts as round-off.
const ROUND_OFF: f64 = 1e-12;

/// Returns an error unless a strain is finite and symmetric.
fn check_strain(strain: [[f64; 2]; 2]) -> Result<()> {
    all_finite("bulk strain", strain.as_flattened())?;
    let [[_, xy], [yx, _]] = strain;
    if (xy - yx).abs() > ROUND_OFF * largest_component(strain) {
        return Err(Error::Sample {
            quantity: "bulk strain",
            index: 2,
            value: yx,
            rule: "yx must equal xy (index 1): give half of the engineering shear strain as both, and a rotation as a twist",
        });
    }
    Ok(())
}

/// Returns the largest magnitude of a component.
fn largest_component(strain: [[f64; 2]; 2]) -> f64 {
    let parts = strain.as_flattened().iter();
    parts.fold(0.0, |largest, part| part.abs().max(largest))
}

clone_in_place!(RelativeDisplacement { fields, strain });

impl PartialEq for RelativeDisplacement {
    fn eq(&self, other: &Self) -> bool {
        self.fields == other.fields
    }
}

try_clone!(RelativeDisplacement { fields } { strain });

impl RelativeDisplacement {
    /// Creates the displacements from their values in the cells along x and along y.
    ///
    /// # Errors
    /// - [`Error::GridMismatch`] if the grids of the two fields differ.
    /// - [`Error::Sample`] at the first value that is not finite.
    pub fn new(fields: [Field; 2]) -> Result<Self> {
        let [x, y] = &fields;
        x.check("relative displacement along x", y.grid())?;
        y.check("relative displacement along y", y.grid())?;
        let strain = [[0.0; 2]; 2];
        Ok(Self { fields, strain })
    }

    /// Creates the displacements $`w_i = \sum_j \varepsilon_{ij} x_j`$ of a uniform strain, zero at the origin of the
    /// grid. `strain` is the strain of body 1 minus the strain of body 2, with the components `[[xx, xy], [yx, yy]]`.
    /// It is positive if body 1 is stretched. The components xy and yx are equal, each half of the engineering shear strain. A
    /// rotation is a twist. A component that exceeds 0.02 with its amount has the warning
    /// [`LargeBulkStrain`](crate::Warning::LargeBulkStrain).
    ///
    /// If the grid is periodic along an axis of the strain, the displacement would jump from one period to the next.
    /// Problems and histories then return [`Error::Sample`]. For an antiplane strain on a grid that is periodic along y, create the
    /// displacement along y with [`new`](Self::new).
    ///
    /// # Errors
    /// - [`Error::Sample`] if a component is not finite, or if xy and yx differ.
    /// - [`Error::Memory`] if memory runs out.
    #[doc(alias = "bulk stress")]
    pub fn bulk_strain(grid: Grid, strain: [[f64; 2]; 2]) -> Result<Self> {
        check_strain(strain)?;
        let along = |axis: usize| {
            let [x_part, y_part] = strain[axis];
            Field::try_from_fn(grid, |x, y| x_part * x + y_part * y)
        };
        let fields = try_each(along)?;
        Ok(Self { fields, strain })
    }

    /// Creates zero displacements for all cells.
    pub(crate) fn zeros(grid: Grid) -> Result<Self> {
        let fields = [Field::try_zeros(grid)?, Field::try_zeros(grid)?];
        let strain = [[0.0; 2]; 2];
        Ok(Self { fields, strain })
    }

    /// Returns the displacements along x and along y (lengths).
    #[must_use]
    pub fn fields(&self) -> [&Field; 2] {
        self.fields.each_ref()
    }

    /// Returns the largest component of the mean strain times an amount, in thousandths, or `None` if it is small. The function is
    /// collective.
    pub(crate) fn large_strain(&self, bodies: &HalfSpace, amount: f64) -> Option<usize> {
        Warning::strain_beyond(amount.abs() * largest_component(self.mean_strain(bodies)))
    }

    /// Returns the mean strain over the grid, the symmetric part of the regression coefficients of the displacements on the
    /// position. The function is collective.
    fn mean_strain(&self, bodies: &HalfSpace) -> [[f64; 2]; 2] {
        let grid = bodies.grid();
        let [squares @ .., xx, xy, yx, yy] = reduce::sum(&bodies.grid_layout(), |cell| {
            let ([x, y], [u, v]) = (centre(grid, cell), [0, 1].map(|axis| self.at(axis, cell)));
            [x * x, y * y, u * x, u * y, v * x, v * y]
        });
        // A grid of one line of cells has no extent across it.
        let [by_x, by_y] = squares.map(|square| if square > 0.0 { 1.0 / square } else { 0.0 });
        let shear = 0.5 * (xy * by_y + yx * by_x);
        [[xx * by_x, shear], [shear, yy * by_y]]
    }

    /// Returns the largest magnitude along an axis (a length).
    pub(crate) fn largest(&self) -> f64 {
        let fields = self.fields.iter();
        let magnitudes = fields.map(|field| field.max().max(-field.min()));
        magnitudes.fold(0.0, f64::max)
    }

    /// Returns the largest magnitude of a displacement (`[x, y]` in a cell) among the cells of a contact.
    pub(crate) fn largest_in(
        bodies: &HalfSpace,
        contains: impl Fn(usize) -> bool + Sync,
        displacement: impl Fn(usize, usize) -> f64 + Sync,
    ) -> f64 {
        reduce::max(&bodies.grid_layout(), |cell| {
            if contains(cell) {
                displacement(0, cell).hypot(displacement(1, cell))
            } else {
                0.0
            }
        })
    }

    /// Returns the displacement along an axis in a cell of the grid.
    pub(crate) fn at(&self, axis: usize, cell: usize) -> f64 {
        self.fields[axis].as_slice()[cell]
    }

    /// Returns the fields for restoring a saved state. The values must remain finite.
    pub(crate) fn fields_mut(&mut self) -> [&mut Field; 2] {
        self.fields.each_mut()
    }

    /// Returns an error if the displacement is on a different grid or has a strain along a periodic axis. Also returns
    /// an error for a non-zero component along an axis without tractions.
    pub(crate) fn check(&self, bodies: &HalfSpace, axes: &[Axis]) -> Result<()> {
        let grid = bodies.grid();
        grid.check_equal("relative displacement", self.fields[0].grid())?;
        let repeats = bodies.boundary().repeats();
        for (index, &value) in self.strain.as_flattened().iter().enumerate() {
            if value != 0.0 && repeats[index % 2] {
                return Err(Error::Sample {
                    quantity: "bulk strain",
                    index,
                    value,
                    rule: "must be zero along a periodic axis, because its displacement would jump there",
                });
            }
        }
        for &axis in Axis::BOTH {
            let values = self.fields[axis.index()].as_slice();
            let first = values.iter().find(|w| **w != 0.0);
            if let (Some(&value), false) = (first, axes.contains(&axis)) {
                return Err(Error::UnsupportedByModel {
                    model: "the model of this contact",
                    quantity: match axis {
                        Axis::X => "relative displacement along x",
                        Axis::Y => "relative displacement along y",
                    },
                    value,
                    remedy: TangentialModel::VECTOR_REMEDY,
                });
            }
        }
        Ok(())
    }
}
