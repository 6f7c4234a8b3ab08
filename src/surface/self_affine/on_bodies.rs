//! Rough surfaces on bodies that ranks share.

use crate::error::Result;
use crate::grid::field::Field;
use crate::half_space::HalfSpace;
use crate::surface::SelfAffine;

impl SelfAffine {
    /// The heights of the surface on the grid of some bodies (lengths, out of the body): of
    /// [distributed](HalfSpace::distributed) ones each rank makes the rows that it holds, to the bits of
    /// [`SelfAffine::generate`].
    ///
    /// # Errors
    /// As [`SelfAffine::generate`]; [`Error::Ranks`](crate::Error::Ranks) for a cropped surface or a given skewness or kurtosis on bodies that
    /// ranks share, or for surfaces that are not the same on all.
    pub fn generate_on(&self, bodies: &HalfSpace) -> Result<Field> {
        let grid = bodies.grid().whole();
        bodies.agreed_alike(Ok(()), &[("rough surface", self)])?;
        match bodies.share(grid.size()) {
            Some(rows) => bodies.agreed(self.generate_slab(grid, &rows)),
            None => Ok(self.generate(grid)?.into_heights()),
        }
    }
}
