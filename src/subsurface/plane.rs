//! The stresses and displacements at one depth.

use crate::error::Result;
use crate::grid::Grid;
use crate::grid::field::{Field, clone_in_place};
use crate::memory::fallible::{try_clone, try_each};
use crate::subsurface::body::Body;
use crate::subsurface::kernel::FieldComponent;
use crate::subsurface::stress::Stress;
use crate::support::debug::shown;
use crate::warning::Warning;

/// Stress, and displacement if requested, at the cell centres of a plane in one body.
///
/// ```
/// use stickslip::subsurface::{Body, Planes, Tractions};
/// use stickslip::*;
/// let grid = Grid::square(16, 1.0)?;
/// let steel = Material::new(210e3, 0.3)?;
/// let pair = ElasticPair::new(steel, steel)?;
/// let bodies = HalfSpace::with_boundary(grid, pair, Boundary::Periodic)?;
/// let pressure = Field::from_fn(grid, |x, y| 200.0 * (-10.0 * (x * x + y * y)).exp());
/// let plane = Planes::new(&bodies, &[0.2])?.solve(0, Body::Two, Tractions::new(&pressure))?;
/// assert_eq!((plane.depth(), plane.z()), (0.2, -0.2));
/// // Every plane carries the load. The stress is more uniform at larger depths.
/// let [_, _, zz] = plane.normal_stress();
/// assert!((zz.integral() / pressure.integral() + 1.0).abs() < 1e-12);
/// assert!(-zz.min() < 0.8 * pressure.max());
/// # Ok::<(), Error>(())
/// ```
#[derive(PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Plane {
    body: Body,
    depth: f64,
    normal: [Field; 3],
    shear: [Field; 3],
    displacement: Option<[Field; 3]>,
    /// Whether the depth is less than a cell side and the tractions above the plane end at an edge.
    is_at_edge: bool,
    /// Whether the tractions belong to a solve that ended before it converged.
    is_unconverged: bool,
}

shown!(Plane: body, depth);

clone_in_place!(Plane {
    body,
    depth,
    normal,
    shear,
    displacement,
    is_at_edge,
    is_unconverged
});

try_clone!(Plane { normal, shear, displacement } { body, depth, is_at_edge, is_unconverged });

/// Components in the order of the fields.
pub(super) const STRESSES: [[FieldComponent; 3]; 2] = [
    [
        FieldComponent::Sxx,
        FieldComponent::Syy,
        FieldComponent::Szz,
    ],
    [
        FieldComponent::Sxy,
        FieldComponent::Sxz,
        FieldComponent::Syz,
    ],
];
pub(super) const DISPLACEMENTS: [FieldComponent; 3] =
    [FieldComponent::Ux, FieldComponent::Uy, FieldComponent::Uz];

impl Plane {
    pub(super) fn new(grid: Grid, body: Body, with_displacements: bool) -> Result<Self> {
        let zeros = || try_each(|_| Field::try_zeros(grid));
        Ok(Self {
            body,
            depth: 0.0,
            normal: zeros()?,
            shear: zeros()?,
            displacement: with_displacements.then(zeros).transpose()?,
            is_at_edge: false,
            is_unconverged: false,
        })
    }

    /// Prepares the plane for a solution of this body.
    ///
    /// # Errors
    /// - [`Error::Memory`](crate::Error::Memory) if memory runs out. The plane is then unchanged.
    pub(super) fn prepare(&mut self, body: Body, with_displacements: bool) -> Result<()> {
        if !with_displacements {
            self.displacement = None;
        } else if self.displacement.is_none() {
            let grid = self.grid();
            self.displacement = Some(try_each(|_| Field::try_zeros(grid))?);
        }
        self.body = body;
        Ok(())
    }

    /// Sets the depth, whether tractions above the plane end at an edge, and whether they belong to a solve that has not converged.
    pub(super) fn place(&mut self, depth: f64, has_edge: bool, is_unconverged: bool) {
        let grid = self.grid();
        self.depth = depth;
        self.is_unconverged = is_unconverged;
        self.is_at_edge = has_edge && depth < grid.dx().max(grid.dy());
    }

    /// Returns the normal stresses and the shear stresses as mutable slices.
    pub(super) fn stress_mut(&mut self) -> ([&mut [f64]; 3], [&mut [f64]; 3]) {
        let [normal, shear] = [&mut self.normal, &mut self.shear];
        (
            normal.each_mut().map(Field::as_mut_slice),
            shear.each_mut().map(Field::as_mut_slice),
        )
    }

    /// Adds a stress to the stress of all cells.
    pub(super) fn add(&mut self, stress: &Stress) {
        let fields = self.normal.iter_mut().chain(&mut self.shear);
        for (field, part) in fields.zip(stress.components()) {
            if part != 0.0 {
                field
                    .as_mut_slice()
                    .iter_mut()
                    .for_each(|value| *value += part);
            }
        }
    }

    pub(super) fn displacement_mut(&mut self) -> Option<[&mut [f64]; 3]> {
        let fields = self.displacement.as_mut()?;
        Some(fields.each_mut().map(Field::as_mut_slice))
    }

    /// Returns the grid of all fields.
    #[must_use]
    pub fn grid(&self) -> Grid {
        self.normal[0].grid()
    }

    /// Returns the body that contains the plane.
    #[must_use]
    pub fn body(&self) -> Body {
        self.body
    }

    /// Returns the depth below the surface (a length, zero or positive).
    #[must_use]
    pub fn depth(&self) -> f64 {
        self.depth
    }

    /// Returns the z coordinate on the common axis of both bodies (a length). It is the depth in body 1, and minus the depth in
    /// body 2.
    #[must_use]
    pub fn z(&self) -> f64 {
        match self.body {
            Body::One => self.depth,
            Body::Two => -self.depth,
        }
    }

    /// Returns the normal stresses xx, yy and zz (pressures, tensile positive).
    #[must_use]
    pub fn normal_stress(&self) -> [&Field; 3] {
        self.normal.each_ref()
    }

    /// Returns the shear stresses xy, xz and yz (pressures).
    #[must_use]
    pub fn shear_stress(&self) -> [&Field; 3] {
        self.shear.each_ref()
    }

    /// Returns the displacements of the body along x, y and z (lengths), or `None` if they were not
    /// [requested](crate::subsurface::Planes::with_displacements).
    #[must_use]
    pub fn displacement(&self) -> Option<[&Field; 3]> {
        self.displacement.as_ref().map(<[Field; 3]>::each_ref)
    }

    /// Returns the warnings about the plane. They include [`Warning::StressAtEdge`] if the depth is less than a side of a cell
    /// and shear tractions end at the edge of a contact. They include [`Warning::NotConverged`] if the tractions belong to a solution
    /// that has not converged.
    #[must_use]
    pub fn warnings(&self) -> Vec<Warning> {
        let at_edge = self.is_at_edge.then_some(Warning::StressAtEdge);
        let unconverged = self.is_unconverged.then_some(Warning::NotConverged);
        at_edge.into_iter().chain(unconverged).collect()
    }

    /// Returns the stress in cell `(ix, iy)`, or `None` outside the grid.
    #[must_use]
    pub fn get(&self, ix: usize, iy: usize) -> Option<Stress> {
        let grid = self.grid();
        (ix < grid.nx() && iy < grid.ny()).then(|| self.at(iy * grid.nx() + ix))
    }

    /// Returns the stresses of all cells, row by row with x fastest.
    #[must_use]
    pub fn stresses(&self) -> impl ExactSizeIterator<Item = Stress> + '_ {
        (0..self.grid().cells()).map(|cell| self.at(cell))
    }

    /// Returns the field of a function of the stress, such as [`Stress::von_mises`].
    #[must_use]
    pub fn map(&self, mut f: impl FnMut(Stress) -> f64) -> Field {
        let mut field = Field::zeros(self.grid());
        for (value, stress) in field.as_mut_slice().iter_mut().zip(self.stresses()) {
            *value = f(stress);
        }
        field
    }

    fn at(&self, cell: usize) -> Stress {
        let [[xx, yy, zz], [xy, xz, yz]] =
            [&self.normal, &self.shear].map(|fields| fields.each_ref().map(|f| f.as_slice()[cell]));
        Stress {
            xx,
            yy,
            zz,
            xy,
            xz,
            yz,
        }
    }
}
