//! Stress and displacement on whole planes by fast convolution.

use std::array::from_fn;
use std::borrow::Cow;
use std::ops::ControlFlow;
use std::sync::{Arc, OnceLock};

use crate::error::{Result, length, samples_obey};
use crate::fft::{Superposition, Torus};
use crate::grid::Grid;
use crate::half_space::HalfSpace;
use crate::observer::{Observer, WorkObserver, unwatched};
use crate::parallel;
use crate::parallel::ranks::Input;
use crate::report::Iteration;
use crate::subsurface::body::{Body, Constants, check_described};
use crate::subsurface::distances::{TOO_FAR, reach};
use crate::subsurface::kernel::Load;
use crate::subsurface::plane::{DISPLACEMENTS, Plane, STRESSES};
use crate::subsurface::spectra::Spectra;
use crate::subsurface::stress::Stress;
use crate::subsurface::tractions::Tractions;
use crate::support::debug::shown;

/// Solver for the stress, and the displacement if requested, at the cell centres of planes at chosen depths below each body. The
/// values are the sums over all cells of [`at_points`](crate::subsurface::at_points), computed by fast transforms. The solver can
/// be reused for any tractions on the same bodies.
///
/// # Memory
///
/// The kernels of a depth are computed at the first solve of this depth and kept. They take 112 bytes per cell and depth, or 152
/// bytes with displacements (170 bytes during the computation). They take a tenth more if the padded length is not twice the
/// number of cells. If the grid is periodic along both axes, the kernels take a quarter of this memory. The kernels of
/// homogeneous bodies do not depend on the materials and are used for both bodies. Clones share the kernels.
/// [`through`](Self::through) keeps no kernels, so its memory does not grow with the number of depths. The transforms take 96
/// bytes per cell. A [`Plane`] takes 48 bytes per cell, or 72 bytes with displacements.
///
/// In [coated](crate::layers) bodies the kernels depend on the body. The kernels of each coated body that is computed take 144
/// bytes per cell and depth, or 216 bytes with displacements.
///
/// # Cost
///
/// One depth takes three transforms of the tractions and one inverse transform per component. The six stresses of 512 x 512 cells
/// take as much time as nine products of [`HalfSpace::operator`]. The kernels are computed only once, which takes as much time as
/// fifty products.
///
/// # Boundaries
///
/// - Free surroundings: the result is exact, equal to the sum over cells.
/// - [`Periodic`](crate::Boundary::Periodic): the effect of every wave of traction decays as `exp(-kz)` times a linear function
///   of z. The surface displacements equal the displacements of the operators. The tractions consist of the waves that fit the
///   grid. The mean traction causes `szz = -p`, `sxz = -qx`, `syz = -qy` and `sxx = syy = -p nu/(1 - nu)` at every depth (no
///   lateral strain). It causes no displacement, so displacements have zero mean at every depth.
/// - [`PeriodicAlongY`](crate::Boundary::PeriodicAlongY): the result is the sum over all images along y. Displacements
///   are relative to the datum, a point of the surface. One row of cells is in plane strain.
///
/// # Coated bodies
///
/// The waves are propagated downwards through the layers with decaying factors only. The computation is therefore stable for any
/// contrast of stiffness and any depth. On free grids and lines, the closed form of the outermost layer represents the singular
/// effect of a cell. The correction for the other layers consists of Hankel integrals with errors of about 1e-11 of the largest
/// component. A depth equal to the sum of the layer thicknesses, added from the surface, is on the outer side of the interface.
/// The next larger floating-point number is on the inner side. At an interface `szz`, `sxz`, `syz` and the displacements are
/// continuous, whereas `sxx`, `syy` and `sxy` jump. The mean of a periodic grid uses Poisson's ratio of the layer.
///
/// ```
/// use stickslip::layers::Layer;
/// use stickslip::subsurface::{Body, Planes, Tractions};
/// use stickslip::*;
/// // A stiff layer on a soft body bends under a ball: its lower side is in tension, and the body below is not.
/// let coated = Material::new(1.0, 0.3)?.coated(&[Layer::new(50.0, 0.3, 0.1)?])?;
/// let bodies = HalfSpace::new(Grid::square(31, 1.0)?, ElasticPair::new(coated, Material::rigid())?)?;
/// let pressure = Field::from_fn(bodies.grid(), |x, y| (0.05 - x * x - y * y).max(0.0));
/// let below = 0.1 * (1.0 + f64::EPSILON);
/// let mut planes = Planes::new(&bodies, &[0.1, below])?;
/// let mut in_the_middle = |n| -> Result<_> {
///     Ok(planes.solve(n, Body::One, Tractions::new(&pressure))?.get(15, 15).unwrap_or_default())
/// };
/// let (layer, base) = (in_the_middle(0)?, in_the_middle(1)?);
/// assert!(layer.xx > 0.0 && layer.xx > 10.0 * base.xx);
/// assert!((layer.zz - base.zz).abs() < 1e-9 * pressure.max());
/// # Ok::<(), Error>(())
/// ```
///
/// # Ranks
///
/// For [distributed](HalfSpace::distributed) bodies every rank creates planes at the same depths. Each rank stores the kernels,
/// transforms and planes of its own rows and columns. The values are bitwise identical to the values of a single process. Solves
/// are collective calls, and the observer of the first rank decides whether they continue. Values at the centres of cells
/// ([`CellValue::Centre`](crate::CellValue::Centre)) are rejected with an error on a grid that is not periodic along both axes.
/// Calls of [`write_vti`](Self::write_vti) are rejected as well.
///
/// # Examples
///
/// ```
/// use stickslip::subsurface::{Body, Planes};
/// use stickslip::*;
/// // A steel ball on steel: the largest shear stress is 0.310 p0, at the depth 0.481 a (nu = 0.3).
/// let grid = Grid::square(64, 0.4)?;
/// let steel = Material::new(210e3, 0.3)?;
/// let bodies = HalfSpace::new(grid, ElasticPair::new(steel, steel)?)?;
/// let load = NormalLoad::Force(100.0);
/// let ball = surface::sphere(grid, 5.0)?;
/// let contact = NormalProblem::builder(&bodies, &ball, load).build()?.solve()?;
/// let hertz = analytical::HertzSphere::new(bodies.pair(), 5.0, 100.0)?;
///
/// let depths = [0.2, 0.481, 1.0].map(|depth| depth * hertz.contact_radius());
/// let mut planes = Planes::new(&bodies, &depths)?;
/// let mut shear = Vec::new();
/// planes.through(Body::One, &contact, |plane| {
///     shear.push(plane.map(|stress| stress.max_shear()).max() / hertz.max_pressure());
///     Ok(())
/// })?;
/// assert!(shear[0] < shear[1] && shear[2] < shear[1]);
/// assert!((shear[1] - 0.310).abs() < 1e-3);
/// # Ok::<(), Error>(())
/// ```
#[derive(Clone)]
pub struct Planes {
    bodies: HalfSpace,
    depths: Arc<[f64]>,
    kernels: Arc<[Kept]>,
    with_displacements: bool,
    torus: Torus,
    transforms: Superposition,
}

shown!(Planes: bodies, depths);

/// Kernels of a depth: for homogeneous bodies, for a coated body 1 and for a coated body 2.
type Kept = [OnceLock<Spectra>; 3];

impl Planes {
    /// Creates planes at the given depths (lengths, zero or positive) below the surface of either body.
    ///
    /// # Errors
    /// - [`Error::Sample`](crate::Error::Sample) for a depth that is negative or not finite, or that exceeds 1e60 times the
    ///   shorter side of a cell.
    /// - [`Error::UnsupportedForCoatings`](crate::Error::UnsupportedForCoatings) for bodies defined by a
    ///   [`Kernel`](crate::Kernel).
    /// - [`Error::Memory`](crate::Error::Memory) if memory runs out.
    /// - [`Error::Ranks`](crate::Error::Ranks) if a rank fails or the ranks disagree.
    pub fn new(bodies: &HalfSpace, depths: &[f64]) -> Result<Self> {
        let rule = "must be non-negative and finite";
        let is_depth = |depth: f64| depth >= 0.0 && depth.is_finite();
        let checked = bodies
            .kernel()
            .check_no_operators("the stress below the surface")
            .and_then(|()| check_described(bodies.pair()))
            .and_then(|()| samples_obey("depth", depths, rule, is_depth))
            .and_then(|()| {
                samples_obey("depth", depths, TOO_FAR, |depth| {
                    reach(bodies.grid(), depth)
                })
            });
        bodies.collective_result_checked(checked, &[("depths", &depths)])?;
        let size = bodies.grid().whole().size();
        let torus = Torus::new(size, bodies.boundary().repeats(), bodies.share(size));
        Ok(Self {
            bodies: bodies.clone(),
            depths: depths.into(),
            kernels: no_kernels(depths),
            with_displacements: false,
            transforms: bodies.collective_result(Superposition::new(&torus))?,
            torus,
        })
    }

    /// Adds the displacements, at an additional cost of half the cost of the stresses.
    #[must_use]
    pub fn with_displacements(self) -> Self {
        Self {
            with_displacements: true,
            kernels: no_kernels(&self.depths),
            ..self
        }
    }

    /// Returns the depths (lengths).
    #[must_use]
    pub fn depths(&self) -> &[f64] {
        &self.depths
    }

    /// Returns the plane at the depth with this index in a body.
    ///
    /// # Errors
    /// - [`Error::Length`](crate::Error::Length) if there is no such depth.
    /// - [`Error::RigidBody`](crate::Error::RigidBody) for a rigid body, and for a depth in the rigid base of a coated body.
    /// - [`Error::Memory`](crate::Error::Memory) if memory runs out for the kernels.
    /// - [`Error::GridMismatch`](crate::Error::GridMismatch), [`Error::BoundaryMismatch`](crate::Error::BoundaryMismatch),
    ///   [`Error::CellValueMismatch`](crate::Error::CellValueMismatch) or
    ///   [`Error::MaterialMismatch`](crate::Error::MaterialMismatch) if the tractions belong to different bodies.
    /// - [`Error::NotConverged`](crate::Error::NotConverged) for a solution that no solve has filled.
    /// - [`Error::OutdatedSolution`](crate::Error::OutdatedSolution) for a tangential solution that was computed for a different
    ///   pressure than the normal solution.
    /// - [`Error::Sample`](crate::Error::Sample) if a traction or the uniform stress is not finite.
    /// - [`Error::Ranks`](crate::Error::Ranks) if a rank fails or the ranks disagree.
    pub fn solve<'a>(
        &mut self,
        index: usize,
        body: Body,
        tractions: impl Into<Tractions<'a>>,
    ) -> Result<Plane> {
        self.solve_observed(index, body, tractions, unwatched)
    }

    /// Solves like [`solve`](Self::solve), with an observer that may cancel. The observer is called before the kernels are
    /// sampled, and before each transform of a kernel and of three components. These calls count as products.
    ///
    /// # Errors
    /// - The errors of [`solve`](Self::solve).
    /// - [`Error::NotConverged`](crate::Error::NotConverged) if the observer cancels.
    pub fn solve_observed<'a>(
        &mut self,
        index: usize,
        body: Body,
        tractions: impl Into<Tractions<'a>>,
        mut observer: impl FnMut(&Iteration) -> ControlFlow<()> + Send,
    ) -> Result<Plane> {
        let mut plane = self.bodies.collective_result(self.plane(body))?;
        self.solve_watched(index, body, tractions.into(), &mut plane, &mut observer)?;
        Ok(plane)
    }

    /// Solves into an existing plane. Once the kernels exist, nothing is allocated, except for fields of
    /// [`CellValue::Centre`](crate::CellValue::Centre).
    ///
    /// # Errors
    /// - The errors of [`Planes::solve`].
    /// - [`Error::GridMismatch`](crate::Error::GridMismatch) if the plane has a different grid.
    ///
    /// The plane is unchanged after an error, unless the connection between ranks was lost during the solve.
    pub fn solve_into<'a>(
        &mut self,
        index: usize,
        body: Body,
        tractions: impl Into<Tractions<'a>>,
        plane: &mut Plane,
    ) -> Result<()> {
        self.solve_watched(index, body, tractions.into(), plane, &mut unwatched)
    }

    fn solve_watched(
        &mut self,
        index: usize,
        body: Body,
        tractions: Tractions<'_>,
        plane: &mut Plane,
        observer: Observer<'_>,
    ) -> Result<()> {
        let loads = self.begin(Some(index), body, &tractions, plane.grid())?;
        let watch = &mut WorkObserver::new(observer).shared(self.bodies.team());
        let kernels = Arc::clone(&self.kernels);
        let kept = &kernels[index][loads.constants.place()];
        let made = || self.spectra(index, &loads.constants, watch);
        let solved = parallel::get_or_make(kept, made).and_then(|spectra| {
            self.bodies
                .collective_result(plane.prepare(body, self.with_displacements))?;
            self.load(&loads, watch)?;
            self.fill(plane, spectra, &loads, watch)
        });
        self.bodies.joint(solved)
    }

    /// Passes the planes of a body at all depths to `visit`, in the given order. The plane is passed by reference and
    /// overwritten, so `visit` must copy the values that it needs later. Kernels that did not exist before the call are discarded
    /// after each depth. The memory therefore does not grow with the number of depths.
    ///
    /// # Errors
    /// - The errors of [`Planes::solve`].
    /// - The first error of `visit`, which ends the traversal.
    pub fn through<'a>(
        &mut self,
        body: Body,
        tractions: impl Into<Tractions<'a>>,
        visit: impl FnMut(&Plane) -> Result<()>,
    ) -> Result<()> {
        self.through_observed(body, tractions, visit, unwatched)
    }

    /// Calls [`through`](Self::through) with an observer, which is called as in [`solve_observed`](Self::solve_observed).
    ///
    /// # Errors
    /// - The errors of [`through`](Self::through).
    /// - [`Error::NotConverged`](crate::Error::NotConverged) if the observer cancels.
    pub fn through_observed<'a>(
        &mut self,
        body: Body,
        tractions: impl Into<Tractions<'a>>,
        mut visit: impl FnMut(&Plane) -> Result<()>,
        mut observer: impl FnMut(&Iteration) -> ControlFlow<()> + Send,
    ) -> Result<()> {
        let tractions = tractions.into();
        let loads = self.begin(None, body, &tractions, self.bodies.grid())?;
        let mut plane = self.bodies.collective_result(self.plane(body))?;
        let watch = &mut WorkObserver::new(&mut observer).shared(self.bodies.team());
        let kernels = Arc::clone(&self.kernels);
        let mut visited = || {
            self.load(&loads, watch)?;
            for (index, kept) in kernels.iter().enumerate() {
                let made;
                let spectra = if let Some(spectra) = kept[loads.constants.place()].get() {
                    spectra
                } else {
                    made = self.spectra(index, &loads.constants, watch)?;
                    &made
                };
                self.fill(&mut plane, spectra, &loads, watch)?;
                self.bodies.run_collectively(|| visit(&plane))?;
            }
            Ok(())
        };
        let visited = visited();
        self.bodies.joint(visited)
    }

    pub(super) fn check_alone(&self, quantity: &'static str) -> Result<()> {
        self.bodies.check_alone(quantity)
    }

    pub(super) fn grid(&self) -> Grid {
        self.bodies.grid()
    }

    pub(super) fn has_displacements(&self) -> bool {
        self.with_displacements
    }

    fn plane(&self, body: Body) -> Result<Plane> {
        Plane::new(self.bodies.grid(), body, self.with_displacements)
    }

    /// Returns the tractions of a body. All ranks check that the plane with this index, or every plane, exists on this grid.
    fn begin<'a>(
        &self,
        index: Option<usize>,
        body: Body,
        tractions: &Tractions<'a>,
        grid: Grid,
    ) -> Result<BodyLoads<'a>> {
        let bodies = &self.bodies;
        let check = || {
            let constants = body.constants(bodies.pair())?;
            if let Some(index) = index.filter(|index| *index >= self.depths.len()) {
                length("list of depths", index.saturating_add(1), self.depths.len())?;
            }
            bodies.grid().check_equal("plane", grid)?;
            let fields = tractions.checked(bodies)?;
            let uniform = tractions.checked_uniform()?;
            let depths = index.map_or(&*self.depths, |index| &self.depths[index..=index]);
            constants.check_depths(depths)?;
            Ok((constants, fields, uniform))
        };
        let plane = (index, body, self.with_displacements);
        let inputs: [Input<'_>; 2] = [("plane", &plane), ("tractions", &tractions.shown())];
        let (constants, fields, uniform) = bodies.collective_result_checked(check(), &inputs)?;
        let edge = edge(fields.each_ref().map(Option::as_deref));
        let edge = bodies
            .grid_layout()
            .combined(edge, |one, other| from_fn(|k| one[k] || other[k]));
        Ok(BodyLoads {
            constants,
            fields,
            uniform,
            has_edge: edge == [true; 2],
            is_unconverged: tractions.is_unconverged(),
        })
    }

    /// Computes the kernels of a depth.
    fn spectra(
        &self,
        index: usize,
        constants: &Constants,
        watch: &mut WorkObserver<'_>,
    ) -> Result<Spectra> {
        let (depth, with_displacements) = (self.depths[index], self.with_displacements);
        let (bodies, torus) = (&self.bodies, &self.torus);
        parallel::enter_with(bodies.grid().cells(), || match constants.coated() {
            None => Spectra::new(bodies, torus, depth, with_displacements, watch),
            Some(body) => Spectra::layered(bodies, body, torus, depth, with_displacements, watch),
        })
    }

    /// Loads the tractions of a body into the transforms.
    fn load(&mut self, loads: &BodyLoads<'_>, watch: &mut WorkObserver<'_>) -> Result<()> {
        watch.notify_observer()?;
        let factors = Load::ALL.map(|load| loads.constants.factor_in(load));
        let fields = loads.fields.each_ref().map(Option::as_deref);
        self.transforms
            .enter(|transforms| transforms.load(fields, factors));
        Ok(())
    }

    /// Computes the fields of a plane from the transformed tractions.
    fn fill(
        &mut self,
        plane: &mut Plane,
        spectra: &Spectra,
        loads: &BodyLoads<'_>,
        watch: &mut WorkObserver<'_>,
    ) -> Result<()> {
        let constants = &loads.constants;
        self.transforms.enter(|transforms| {
            let mut convolve = |components, fields: [&mut [f64]; 3]| {
                watch.notify_observer()?;
                let kernels = spectra.compose(components, constants.poisson_ratio);
                let factors = components.map(|component| constants.factor_out(component));
                transforms.convolve(&kernels, fields, factors);
                Ok(())
            };
            let (normal, shear) = plane.stress_mut();
            convolve(STRESSES[0], normal)?;
            convolve(STRESSES[1], shear)?;
            match plane.displacement_mut() {
                Some(displacement) => convolve(DISPLACEMENTS, displacement),
                None => Ok(()),
            }
        })?;
        plane.place(spectra.depth(), loads.has_edge, loads.is_unconverged);
        plane.add(&loads.uniform);
        Ok(())
    }
}

/// Tractions on a body, and whether shear tractions end at an edge.
struct BodyLoads<'a> {
    constants: Constants,
    fields: [Option<Cow<'a, [f64]>>; 3],
    uniform: Stress,
    has_edge: bool,
    is_unconverged: bool,
}

/// Returns whether these cells include a cell without pressure, and whether there are shear tractions.
fn edge(fields: [Option<&[f64]>; 3]) -> [bool; 2] {
    let [pressure, shear @ ..] = fields;
    let is_sheared = |field: &[f64]| field.iter().any(|q| *q != 0.0);
    [
        pressure.is_some_and(|field| field.contains(&0.0)),
        shear.into_iter().flatten().any(is_sheared),
    ]
}

fn no_kernels(depths: &[f64]) -> Arc<[Kept]> {
    depths.iter().map(|_| Kept::default()).collect()
}
