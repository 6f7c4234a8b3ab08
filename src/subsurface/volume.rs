//! Files with the stress of a volume.

use std::ops::ControlFlow;
use std::path::Path;

use crate::error::{Error, Result, length};
use crate::io::volume::{self, Array, VolumeShape};
use crate::observer::unwatched;
use crate::report::Iteration;
use crate::subsurface::body::Body;
use crate::subsurface::plane::Plane;
use crate::subsurface::planes::Planes;
use crate::subsurface::tractions::Tractions;

/// Arrays of the file. The components are in the order of a symmetric tensor in VTK.
const STRESS: Array = ("stress", &["XX", "YY", "ZZ", "XY", "YZ", "XZ"]);
const VON_MISES: Array = ("von_mises", &[]);
const DISPLACEMENT: Array = ("displacement", &["X", "Y", "Z"]);

/// Relative difference below which the steps between depths count as equal.
const EQUAL: f64 = 1e-9;

impl Planes {
    /// Writes the stress of all depths in a body to a VTI file, a volume for ParaView. The file contains the tensor `stress` (xx,
    /// yy, zz, xy, yz, xz) and the scalar `von_mises`, both including the [uniform stress](Tractions::with_uniform_stress). It
    /// also contains the vector `displacement` if it was [requested](Self::with_displacements). All values are written as
    /// doubles, without loss of precision. The z axis is common to both bodies, so body 2 is at `z <= 0`.
    ///
    /// The values are point data at the cell centres, at which they are computed. The origin of the image is the first cell
    /// centre. In a [flat image](crate::io::vti) of the surface these points are the centres of the cells. Depths are computed
    /// and written sequentially, so the memory does not grow with the number of depths.
    ///
    /// ```
    /// use stickslip::subsurface::{Body, Planes, Tractions};
    /// use stickslip::*;
    /// let grid = Grid::square(16, 1.0)?;
    /// let rubber = Material::new(1.0, 0.5)?;
    /// let bodies = HalfSpace::new(grid, ElasticPair::new(rubber, Material::rigid())?)?;
    /// let pressure = Field::constant(grid, 0.1);
    /// let path = std::env::temp_dir().join("stickslip_slab.vti");
    /// let mut planes = Planes::new(&bodies, &[0.0, 0.1, 0.2])?;
    /// planes.write_vti(&path, Body::One, Tractions::new(&pressure))?;
    /// // Each point has seven doubles.
    /// let size = std::fs::metadata(&path).unwrap().len();
    /// assert!(size > 3 * 16 * 16 * 7 * 8);
    /// # std::fs::remove_file(&path).unwrap();
    /// # Ok::<(), Error>(())
    /// ```
    ///
    /// # Errors
    /// - [`Error::Sample`] for the first depth that is not in equal downward steps.
    /// - [`Error::Length`] if there is no depth.
    /// - [`Error::File`] if the file cannot be written.
    /// - The errors of [`Planes::solve`].
    ///
    /// An existing file is unchanged after an error.
    #[doc(alias = "ParaView")]
    pub fn write_vti<'a>(
        &mut self,
        path: impl AsRef<Path>,
        body: Body,
        tractions: impl Into<Tractions<'a>>,
    ) -> Result<()> {
        self.write_vti_observed(path, body, tractions, unwatched)
    }

    /// Calls [`write_vti`](Self::write_vti) with an observer, which is called as in [`solve_observed`](Self::solve_observed).
    ///
    /// # Errors
    /// - The errors of [`write_vti`](Self::write_vti).
    /// - [`Error::NotConverged`] if the observer cancels.
    pub fn write_vti_observed<'a>(
        &mut self,
        path: impl AsRef<Path>,
        body: Body,
        tractions: impl Into<Tractions<'a>>,
        observer: impl FnMut(&Iteration) -> ControlFlow<()> + Send,
    ) -> Result<()> {
        self.check_alone("a file of stresses")?;
        let tractions = tractions.into();
        let depths = self.depths();
        let (first, step) = equal_steps(depths)?;
        let count = depths.len();
        let lowest = match body {
            Body::One => first,
            Body::Two => -depths[count - 1],
        };
        let shape = VolumeShape {
            grid: self.grid(),
            first: lowest,
            step,
            planes: count,
        };
        let arrays = [STRESS, VON_MISES, DISPLACEMENT];
        let arrays = &arrays[..if self.has_displacements() { 3 } else { 2 }];
        volume::write(path.as_ref(), &shape, arrays, |file| {
            let mut visited = 0;
            let visit = |plane: &Plane| {
                let index = match body {
                    Body::One => visited,
                    Body::Two => count - 1 - visited,
                };
                visited += 1;
                let tensors = plane
                    .stresses()
                    .map(|s| [s.xx, s.yy, s.zz, s.xy, s.yz, s.xz]);
                file.write(index, 0, tensors.flatten())?;
                file.write(index, 1, plane.stresses().map(|stress| stress.von_mises()))?;
                if let Some(fields) = plane.displacement() {
                    let [x, y, z] = fields.map(|field| field.as_slice().iter());
                    let vectors = x.zip(y).zip(z).flat_map(|((x, y), z)| [*x, *y, *z]);
                    file.write(index, 2, vectors)?;
                }
                Ok(())
            };
            self.through_observed(body, tractions, visit, observer)
        })
    }
}

/// Returns the first depth and the step between depths.
fn equal_steps(depths: &[f64]) -> Result<(f64, f64)> {
    let (first, last) = match depths {
        [] => return length("list of depths", 1, 0).map(|()| (0.0, 1.0)),
        [only] => return Ok((*only, 1.0)),
        [first, .., last] => (*first, *last),
    };
    let step = (last - first) / (depths.len() - 1) as f64;
    for (index, &value) in depths.iter().enumerate() {
        let is_next = (value - (first + index as f64 * step)).abs() <= EQUAL * step;
        if !is_next || step <= 0.0 {
            let (quantity, rule) = ("depth", "the depths must increase in equal steps");
            return Err(Error::Sample {
                quantity,
                index,
                value,
                rule,
            });
        }
    }
    Ok((first, step))
}
