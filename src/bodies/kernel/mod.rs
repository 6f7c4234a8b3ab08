//! User-defined linear bodies, described by their response to waves, by influence coefficients, or by operators.
//!
//! A [`HalfSpace`](crate::HalfSpace) can be created from a [`Kernel`] instead of an [`ElasticPair`]. Pressure, traction, coupled
//! problems, histories, wear and stiffness then work with the kernel. Rolling works with all kernels except operators. A kernel
//! describes the relative displacement $`u_1 - u_2`$ of both bodies in one of four ways. The [`influence`](crate::influence) page
//! defines the signs.
//!
//! | constructor | input | grids |
//! |---|---|---|
//! | [`Kernel::isotropic`] | four functions of the wave number k: a [`Response`] | all grids that support coated bodies |
//! | [`Kernel::orthotropic`] | a Hermitian 3 x 3 matrix as a function of $`(k_x, k_y)`$: a [`ResponseTensor`] | periodic along both axes |
//! | [`Kernel::tabulated`] | a [`CoefficientTable`], measured or from a finite-element code | not periodic |
//! | [`Kernel::operators`] | [`Operators`] that compute displacements | all grids with the same number of cells, or the grid of [`Operators::on`] |
//!
//! ```
//! use stickslip::layers::Response;
//! use stickslip::*;
//! // An incompressible half-space whose shear modulus increases in proportion to the depth, G = m z, responds to pressure
//! // like independent springs: u_z = p / 2 m (Gibson 1967, https://doi.org/10.1680/geot.1967.17.1.58).
//! let (m, grid) = (3.0, Grid::square(32, 1.0)?);
//! let near = ElasticPair::new(Material::new(1.0, 0.5)?, Material::rigid())?;
//! let soil = Kernel::isotropic(near, 1.0, move |k| Response {
//!     normal: 0.5 / m,
//!     along: 1.0 / (m * k), // without effect on pressures
//!     across: 1.0 / (m * k),
//!     coupling: 0.0,
//! })?;
//! let bodies = HalfSpace::with_boundary(grid, &soil, Boundary::Periodic)?;
//! let ball = surface::sphere(grid, 1.0)?;
//! let contact = NormalProblem::builder(&bodies, &ball, NormalLoad::Force(0.02)).build()?.solve()?;
//! // p = 2 m (d - r^2 / 2 R) carries the force 2 pi m R d^2.
//! let largest = (2.0 * m * 0.02 / std::f64::consts::PI).sqrt();
//! assert!((contact.pressure().max() / largest - 1.0).abs() < 0.02);
//! # Ok::<(), Error>(())
//! ```
//!
//! Operators describe bodies whose properties vary along the surface, or whose displacements a different code computes.
//! [`Kernel::operators`] accepts any operator that converts tractions on the cells into displacements. In Python,
//! `Kernel.isotropic` takes a callable of the wave number and `Kernel.tabulated` takes arrays.
//!
//! This example presses an elastic sheet on springs:
//!
//! ```
//! use stickslip::layers::Response;
//! use stickslip::{
//!     Boundary, ElasticPair, Field, Grid, HalfSpace, Kernel, Material, NormalLoad, NormalProblem,
//! };
//!
//! // An elastic sheet of bending stiffness D on springs of stiffness s: a wave with deflection w needs p = (D k^4 + s) w.
//! let (bending, springs) = (2e-4, 1.0);
//! let stiffness = move |k: f64| bending * k.powi(4) + springs;
//! let near = ElasticPair::new(Material::new(1.0, 0.5)?, Material::rigid())?;
//! let sheet = Kernel::isotropic(near, 0.1, move |k| Response {
//!     normal: 1.0 / stiffness(k),
//!     along: 1.0 / k, // no effect on the pressure
//!     across: 1.0 / k,
//!     coupling: 0.0,
//! })?;
//! let grid = Grid::new(64, 1, 1.0 / 64.0, 1.0)?;
//! let bodies = HalfSpace::with_boundary(grid, &sheet, Boundary::Periodic)?;
//! // A wave-shaped gap that closes everywhere under the load.
//! let k = std::f64::consts::TAU;
//! let gap = Field::from_fn(grid, |x, _| 0.01 * (1.0 - (k * x).cos()));
//! let load = NormalLoad::Force(1.5 * 0.01 * stiffness(k));
//! let contact = NormalProblem::builder(&bodies, &gap, load).build()?.solve()?;
//! assert_eq!(contact.contact_cells(), 64);
//! let half = 0.5 * (contact.pressure().max() - contact.pressure().min());
//! assert!((half / (0.01 * stiffness(k)) - 1.0).abs() < 2e-3); // the crest is between two cells
//! # Ok::<(), stickslip::Error>(())
//! ```
//!
//! # How a free grid is computed
//!
//! Isotropic kernels are treated like [coatings](crate::layers#from-waves-to-cells). Let A be the constant value of $`k\,C(k)`$
//! for the half-space `near`. Let B be the limit of $`k\,C(k)`$ for $`k \to 0`$, and H twice the `thickness`. Then
//!
//! ```math
//! k\,C(k) = A + (B - A)\,e^{-kH} + k R(k) .
//! ```
//!
//! The remainder R must be negligible at $`kH = 40`$. The constructors of `HalfSpace` return [`Error::BelowMinimum`] if $`k R`$
//! exceeds 1e-10 of $`A_n`$ at this wave number. The remainder of a layer satisfies this if `thickness` is the thickness of the
//! layer. The response of a body whose moduli vary gradually from the surface approaches A only as $`1/k`$. The response of a
//! body without a half-space as its limit, such as springs, does not approach A at all. Such bodies require a grid that is
//! periodic along both axes, or a table.
//!
//! The coefficients of a table are used without change. For windows and coarser grids they are cropped and averaged.
//! Beyond the last distance, which only the periodic continuation of the transform reaches, the coefficients are
//! extrapolated linearly.
//!
//! # Certificate
//!
//! The smallest eigenvalue of a response or a table on the grid is computed when an operator is planned. If it is positive,
//! errors are certified as for other bodies. If it is not positive, isotropic kernels on free grids and on grids periodic along y
//! use an estimate. As for coated bodies ([`layers`](crate::layers#limits-of-the-model)), the estimate is computed on the
//! infinite lattice of the cells. A solve returns [`Error::NotDefinite`] if this estimate is not positive either. It also returns
//! this error for all tables whose smallest eigenvalue is not positive. For coupled problems, the separate eigenvalues of
//! pressure and traction must be positive. User-defined operators report their own [bound](crate::Operator::lower_bound). Without
//! a bound, pressure and traction cannot be solved together, and stiffnesses are rejected.
//! [`Report::eigenvalue_bound`](crate::Report::eigenvalue_bound) reports the origin of the bound behind a certificate.
//!
//! # Moduli and identity
//!
//! The pair `near` supplies the scalar constants: its hardness, its moduli, and its ratio of tangential to normal compliance. The
//! law for cells that come into contact in a step uses this ratio. Closed forms, edges inside the cells and stresses below the
//! surface [reject](Error::UnsupportedForCoatings) kernels. Two kernels count as the same bodies if `near` and a digest of their
//! values are the same. The digest of a closure contains its values at 41 wave numbers in single precision. The digest of a table
//! contains all values. The digest of operators contains their directions and the work of two fields of tractions, also in single
//! precision. States of histories store the digest. A history can therefore continue only with the same kernel.

mod check;
mod operators;
mod table;
mod user_operator;

pub use operators::Operators;
pub use table::CoefficientTable;
pub(crate) use user_operator::SubOperator;

use std::fmt;
use std::sync::Arc;

use crate::bodies::component::Component;
use crate::bodies::layers::Response;
use crate::bodies::material::{ElasticPair, KernelMark};
use crate::error::{Error, Result, at_least, finite, positive};
use crate::grid::Grid;
use crate::grid::boundary::Boundary;
use crate::support::checksum;

pub(crate) use check::check_thickness;
use check::{
    AS_ALLOWED, check_mirrored, checked, checked_far, checked_tensor, ratio, stronger,
    wave_numbers, waves_of,
};

/// Two bodies defined by their response, or an unmodified pair of materials (see the documentation of
/// [`kernel`](crate::kernel)).
///
/// ```
/// use stickslip::{Boundary, ElasticPair, Grid, HalfSpace, Kernel, Material, layers::Layer};
/// // A closure that describes a coating, on cells much wider than the layer.
/// let rigid = Material::rigid();
/// let coating = Material::new(1.0, 0.3)?.coated(&[Layer::new(4.0, 0.2, 0.5)?])?;
/// let coated = ElasticPair::new(coating, rigid)?;
/// let outermost = ElasticPair::new(Material::new(4.0, 0.2)?, rigid)?;
/// let kernel = Kernel::isotropic(outermost, 0.5, move |k| coated.response(k).expect("k is positive"))?;
///
/// use stickslip::{Operator, influence::Component::ZZ};
/// let grid = Grid::square(16, 4.0)?;
/// let [built_in, given] = [HalfSpace::new(grid, coated)?, HalfSpace::new(grid, &kernel)?];
/// let sag = |bodies: &HalfSpace| -> stickslip::Result<f64> {
///     let (operator, mut u) = (bodies.operator(ZZ)?, vec![0.0; grid.cells()]);
///     operator.apply([&vec![1.0; grid.cells()]], [&mut u], &mut operator.scratch()?);
///     Ok(u[8 * 16 + 8])
/// };
/// assert!((sag(&given)? / sag(&built_in)? - 1.0).abs() < 1e-12);
/// # Ok::<(), stickslip::Error>(())
/// ```
#[derive(Clone)]
pub struct Kernel {
    pair: ElasticPair,
    given: Option<KernelSource>,
}

/// Two kernels are equal if `near` and the digest of their values are the same. The documentation of
/// [`kernel`](crate::kernel) lists the values in the digest. All values are finite, so a kernel equals itself.
impl PartialEq for Kernel {
    fn eq(&self, other: &Self) -> bool {
        self.pair == other.pair && self.given.is_some() == other.given.is_some()
    }
}

/// Description of two bodies by the user.
#[derive(Clone)]
pub(crate) enum KernelSource {
    Isotropic(Isotropic),
    Orthotropic(Arc<dyn Fn([f64; 2]) -> ResponseTensor + Send + Sync>),
    Table(Arc<CoefficientTable>),
    Operators(Arc<Operators>),
}

/// Response that tends to the response of a half-space for short waves.
#[derive(Clone)]
pub(crate) struct Isotropic {
    response: Arc<dyn Fn(f64) -> Response + Send + Sync>,
    pub(crate) thickness: f64,
    /// Limit of k times the response for k to zero.
    pub(crate) far: Response,
}

/// Displacements due to a wave of traction with one wave vector, in lengths over pressures. The bodies must be mirror images of
/// themselves along x and along y.
///
/// The fields are the real or imaginary parts of entries of the Hermitian matrix of a wave. The other entries follow
/// from them, such as $`\hat C_{xz} = -\mathrm{i}\,C_{zx}`$. The entries are even in $`k_x`$ and $`k_y`$, with three exceptions:
/// `xy` is odd in both, `zx` is odd in $`k_x`$, and `zy` is odd in $`k_y`$. For isotropic bodies, the documentation of
/// [`layers`](crate::layers) lists the entries.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ResponseTensor {
    /// Displacement along x due to traction along x.
    pub xx: f64,
    /// Displacement along y due to traction along y.
    pub yy: f64,
    /// Normal displacement due to pressure.
    pub zz: f64,
    /// Displacement along x due to traction along y.
    pub xy: f64,
    /// Normal displacement due to traction along x, divided by i.
    pub zx: f64,
    /// Normal displacement due to traction along y, divided by i.
    pub zy: f64,
}

impl ResponseTensor {
    /// Returns one of the nine entries, or its imaginary part.
    pub(crate) fn component(&self, component: Component) -> f64 {
        match component {
            Component::XX => self.xx,
            Component::YY => self.yy,
            Component::ZZ => self.zz,
            Component::XY | Component::YX => self.xy,
            Component::ZX => self.zx,
            Component::ZY => self.zy,
            Component::XZ => -self.zx,
            Component::YZ => -self.zy,
        }
    }

    fn values(&self) -> [f64; 6] {
        [self.xx, self.yy, self.zz, self.xy, self.zx, self.zy]
    }
}

/// Length of the longest wave that is evaluated, divided by the thickness.
const LONGEST: f64 = 1e9;
/// Value of k times the thickness at which a response must agree with its half-space.
const NEAR: f64 = 20.0;
/// Required agreement of the response with its half-space, relative to the normal response of the half-space.
const CLOSE: f64 = 1e-10;
/// Largest permitted deviation of a stated long-wave limit from the extrapolated limit.
const ALIKE: f64 = 1e-3;

impl Kernel {
    /// Creates a kernel for bodies that are isotropic in their plane, from their response to waves of the positive wave
    /// number k. The response is defined as in [`ElasticPair::response`] (not multiplied by k), for the relative
    /// displacement. The closure is called on many threads and must not wait for them. It is called for k from 5e-10 to
    /// 64 divided by the thickness, and for the wave numbers of grids that are periodic along both axes. The response must be
    /// finite and positive definite at all of these wave numbers.
    ///
    /// `near` is the pair of homogeneous half-spaces that determines the response to waves much shorter than `thickness` (a
    /// length). For a coating it is the outermost layer. The two responses must agree to 1e-10 at $`k = 20/\text{thickness}`$,
    /// and `near` replaces the response beyond this wave number. Grids periodic along both axes use the response without this
    /// replacement.
    ///
    /// # Errors
    /// - [`Error::UnsupportedForCoatings`] if `near` is not homogeneous.
    /// - [`Error::NotPositive`] if the thickness is not positive. The error is also returned if the response is not positive or
    ///   its coupling is too strong. Both are tested at 41 wave numbers, $`2^{-14}`$ to $`2^6`$ over the thickness.
    /// - [`Error::NotFinite`] if a value is not finite.
    pub fn isotropic(
        near: ElasticPair,
        thickness: f64,
        response: impl Fn(f64) -> Response + Send + Sync + 'static,
    ) -> Result<Self> {
        near.check_homogeneous(NEAR_IS, NEAR_REMEDY)?;
        positive("thickness of the kernel", thickness)?;
        // The limit is extrapolated from two long waves.
        let times_k = |k: f64| response(k).map(|value| k * value);
        let k = 1.0 / (LONGEST * thickness);
        let far = times_k(0.5 * k).with(times_k(k), |longer, shorter| 2.0 * longer - shorter);
        let mut digested = Vec::new();
        let mut coupling: f64 = 0.0;
        for k in wave_numbers(thickness) {
            let found = checked(response(k))?;
            let values = [found.normal, found.along, found.across, found.coupling];
            digested.extend(values.map(|value| k * value));
            coupling = stronger(coupling, ratio(found.coupling, found.normal, found.along));
        }
        let response = Arc::new(response);
        Ok(Self::new(
            &near,
            (digest_of(&near, thickness, &digested), coupling),
            KernelSource::Isotropic(Isotropic {
                response,
                thickness,
                far: checked_far(far)?,
            }),
        ))
    }

    /// Sets `base` (one over a pressure) as the limit of k times the response for k to zero. The limit is zero on a rigid base.
    /// For elastic bodies it contains the constants of the half-space [below](crate::layers). By default the limit is
    /// extrapolated from the response at k = 1e-9 over the thickness and at half this k. `base` may differ from the extrapolated
    /// limit by 1e-3 of the value for `near`. The method has no effect on other kernels.
    ///
    /// # Errors
    /// - [`Error::NotFinite`] if `base` is not finite.
    /// - [`Error::BelowMinimum`] if `base` is not the limit of the response.
    pub fn with_long_wave_limit(mut self, base: Response) -> Result<Self> {
        if let Some(KernelSource::Isotropic(isotropic)) = &mut self.given {
            let base = checked_far(base)?;
            let beside = base.with(isotropic.far, |base, far| (base - far).abs());
            let most = beside.normal.max(beside.along).max(beside.across);
            let found = most.max(beside.coupling) / self.pair.compliances().normal;
            let quantity = "ratio of the permitted to the actual difference between the long-wave limit and the response";
            at_least(AS_ALLOWED, 1.0, quantity, ALIKE / found.max(ALIKE))?;
            isotropic.far = base;
        }
        Ok(self)
    }

    /// Creates a kernel for bodies whose elastic axes lie along the grid, from their response to waves of the nonzero wave vector
    /// $`(k_x, k_y)`$. The kernel is available on grids that are periodic along both axes. `near` supplies hardness and moduli.
    /// `length` is the approximate length scale on which the response changes.
    ///
    /// ```
    /// use stickslip::{Boundary, ElasticPair, Grid, HalfSpace, Kernel, Material, NormalLoad, NormalProblem};
    /// use stickslip::{Field, kernel::ResponseTensor};
    /// // Under a pressure, waves along x sink four times as far as waves along y.
    /// let near = ElasticPair::new(Material::new(1.0, 0.5)?, Material::rigid())?;
    /// let fibres = Kernel::orthotropic(near, 1.0, |[x, y]| {
    ///     let c = 1.0 / (x * x / 16.0 + y * y).sqrt();
    ///     ResponseTensor { xx: c, yy: c, zz: c, xy: 0.0, zx: 0.0, zy: 0.0 }
    /// })?;
    /// let grid = Grid::square(48, 1.0)?;
    /// let bodies = HalfSpace::with_boundary(grid, &fibres, Boundary::Periodic)?;
    /// let ball = stickslip::surface::sphere(grid, 1.0)?;
    /// let contact = NormalProblem::builder(&bodies, &ball, NormalLoad::Force(0.01)).build()?.solve()?;
    /// // The contact is an ellipse, the longer axis along the softer direction of its waves.
    /// let pressed = |i, j| contact.pressure().get(i, j).unwrap_or(0.0) > 0.0;
    /// let along = |x: bool| (0..48).filter(|&n| if x { pressed(n, 24) } else { pressed(24, n) }).count();
    /// assert!(along(true) != along(false));
    /// # Ok::<(), stickslip::Error>(())
    /// ```
    ///
    /// # Errors
    /// - [`Error::UnsupportedForCoatings`] if `near` is not homogeneous.
    /// - [`Error::NotPositive`] if the length is not positive, or if a compliance along an axis is not positive at one
    ///   of 41 wave numbers in three directions.
    /// - [`Error::NotFinite`] if a value is not finite.
    /// - [`Error::BelowMinimum`] if a tensor differs from its mirror image by more than 1e-10.
    pub fn orthotropic(
        near: ElasticPair,
        length: f64,
        response: impl Fn([f64; 2]) -> ResponseTensor + Send + Sync + 'static,
    ) -> Result<Self> {
        near.check_homogeneous(NEAR_IS, NEAR_REMEDY)?;
        positive("length of the kernel", length)?;
        let mut digested = Vec::new();
        let mut coupling: f64 = 0.0;
        for k in wave_numbers(length) {
            for [x, y] in [[0.8 * k, 0.6 * k], [k, 0.0], [0.0, k]] {
                let found = checked_tensor(response([x, y]))?;
                check_mirrored(&found, &response([-x, y]), [true, false])?;
                check_mirrored(&found, &response([x, -y]), [false, true])?;
                digested.extend(found.values().map(|value| k * value));
                coupling = stronger(coupling, ratio(found.zx, found.zz, found.xx));
                coupling = stronger(coupling, ratio(found.zy, found.zz, found.yy));
            }
        }
        let mark = (digest_of(&near, length, &digested), coupling);
        Ok(Self::new(
            &near,
            mark,
            KernelSource::Orthotropic(Arc::new(response)),
        ))
    }

    /// Creates a kernel from influence coefficients. The kernel is available on free grids that have the cell sides of the table
    /// and are at most as large as the table. `near` supplies hardness and moduli.
    ///
    /// # Errors
    /// - [`Error::UnsupportedForCoatings`] if `near` is not homogeneous.
    /// - [`Error::Sample`] if a coefficient that is odd along an axis is not zero at distance zero along this axis. The tolerance
    ///   is 1e-12 of the largest coefficient.
    pub fn tabulated(near: ElasticPair, table: CoefficientTable) -> Result<Self> {
        near.check_homogeneous(NEAR_IS, NEAR_REMEDY)?;
        table.check_odd()?;
        let mark = (table.digest(), table.coupling());
        Ok(Self::new(&near, mark, KernelSource::Table(Arc::new(table))))
    }

    /// Creates a kernel from [operators](Operators) on the cells of a grid with any boundary. The operators may compute any
    /// linear displacements from tractions. `near` is the pair of homogeneous half-spaces that approximates the operators for
    /// waves a few cells long. The inverse of the operator of this pair preconditions the solves. A better approximation gives
    /// faster convergence to the same solution. `near` also supplies hardness and moduli. It determines whether pressure and
    /// traction are [coupled](ElasticPair::is_coupled), and the strength of the coupling for
    /// [`CoupledReport::error_estimate`](crate::coupled::CoupledReport::error_estimate).
    ///
    /// A contact is solved on all cells of the grid, without windows and coarser grids. The certificate requires a [lower
    /// bound](crate::Operator::lower_bound) of the operator. Without a bound, [`Report::duality_gap`](crate::Report::duality_gap)
    /// is the duality gap of the problem, and the convergence test ignores it. Coupled problems, stiffnesses and jumps over
    /// cycles of wear are then not available. Rolling, ranks, dense matrices, edges inside the cells and stresses reject such
    /// bodies. On a grid that is periodic along both axes an operator must map constants to zero. A [cell
    /// value](crate::HalfSpace::with_cell_value) does not change an operator. It states the interpretation of the values that the
    /// operator uses.
    ///
    /// # Errors
    /// - [`Error::UnsupportedForCoatings`] if `near` is not homogeneous.
    /// - [`Error::IncompleteKernel`] if there is no operator.
    /// - [`Error::RepeatedDirection`] if an operator has the same direction twice.
    /// - [`Error::Length`] if operators have different numbers of cells.
    /// - [`Error::NotPositive`] if the energy of one of two test fields with zero mean is not positive.
    /// - [`Error::NotFinite`] if a product or a lower bound is not finite.
    /// - [`Error::UnsupportedByModel`] if an operator adds its product to the output instead of writing it, is not symmetric, or
    ///   has a coupling that `near` does not have. The works of two test fields on the displacements of the other field may
    ///   differ by at most 1e-9 of the energies.
    /// - [`Error::BelowMinimum`] if the energy of a test field is smaller than the lower bound allows.
    /// - [`Error::Memory`] if memory runs out.
    pub fn operators(near: ElasticPair, operators: Operators) -> Result<Self> {
        near.check_homogeneous(NEAR_IS, NEAR_REMEDY)?;
        let shown = operators.examined(&near)?;
        let mark = (digest_of(&near, 1.0, &shown), near.coupling_strength());
        Ok(Self::new(
            &near,
            mark,
            KernelSource::Operators(Arc::new(operators)),
        ))
    }

    fn new(near: &ElasticPair, (digest, coupling): (u64, f64), given: KernelSource) -> Self {
        let coupling = rounded(coupling);
        Self {
            pair: near.standing_for(KernelMark { digest, coupling }),
            given: Some(given),
        }
    }

    /// Returns the pair that supplies hardness and moduli, marked as the pair of this kernel:
    /// [`HalfSpace::pair`](crate::HalfSpace::pair). The pair alone does not define bodies ([`Error::IncompleteKernel`]).
    #[must_use]
    pub fn pair(&self) -> &ElasticPair {
        &self.pair
    }

    /// Returns the description by the user, or `None` for a pair of materials.
    pub(crate) fn given(&self) -> Option<&KernelSource> {
        self.given.as_ref()
    }

    /// Returns the user-defined operators, or `None` if the kernel is described in a different way.
    pub(crate) fn user_operators(&self) -> Option<&Operators> {
        match &self.given {
            Some(KernelSource::Operators(operators)) => Some(operators),
            _ => None,
        }
    }

    /// Checks that the response of the bodies is available at any position, which is not the case for operators.
    pub(crate) fn check_no_operators(&self, quantity: &'static str) -> Result<()> {
        match self.user_operators() {
            None => Ok(()),
            Some(_) => Err(Error::UnsupportedForCoatings {
                quantity,
                bodies: "user-defined operators",
                remedy: "describe the bodies by materials, layers or a response to waves, which are defined beyond the cells of one grid",
            }),
        }
    }

    /// Returns the wave number k > 0 times the response to waves of this wave number, for isotropic bodies.
    pub(crate) fn times_k(&self, k: f64) -> Response {
        match &self.given {
            Some(KernelSource::Isotropic(of)) => (of.response)(k).map(|value| k * value),
            _ => self.pair.times_k(k),
        }
    }

    /// Returns a product like [`Self::times_k`], but with the response of the half-space `near` for short waves.
    pub(crate) fn short_times_k(&self, k: f64) -> Response {
        match &self.given {
            Some(KernelSource::Isotropic(of)) if k * of.thickness > NEAR => self.pair.times_k(k),
            _ => self.times_k(k),
        }
    }

    /// Returns the limit of the wave number times the response for long waves.
    pub(crate) fn long_times_k(&self) -> Response {
        match &self.given {
            Some(KernelSource::Isotropic(of)) => of.far,
            _ => self.pair.times_k(0.0),
        }
    }

    /// Returns whether the kernel is an isotropic response to waves that differs from homogeneous half-spaces.
    pub(crate) fn has_response(&self) -> bool {
        match &self.given {
            None => self.pair.is_coated(),
            Some(given) => matches!(given, KernelSource::Isotropic(_)),
        }
    }

    /// Checks that bodies on the grid can be created from the kernel.
    pub(crate) fn check_on(&self, grid: Grid, boundary: Boundary) -> Result<()> {
        const REPEATING: &str =
            "use a grid that is periodic along both axes, or a table of coefficients";
        match &self.given {
            None => self.pair.check_no_kernel(),
            Some(KernelSource::Isotropic(of)) if boundary == Boundary::Periodic => {
                let check = |k: f64| checked((of.response)(k)).map(drop);
                waves_of(grid).try_for_each(check)
            }
            Some(KernelSource::Isotropic(of)) => {
                check_thickness(of.thickness, grid)?;
                of.check_near(&self.pair)
            }
            Some(KernelSource::Orthotropic(of)) if boundary == Boundary::Periodic => {
                let check = |k: f64| checked_tensor(of([0.8 * k, 0.6 * k])).map(drop);
                waves_of(grid).try_for_each(check)
            }
            Some(KernelSource::Orthotropic(_)) => Err(Error::UnsupportedForCoatings {
                quantity: "a grid that is not periodic along both axes",
                bodies: "an orthotropic response",
                remedy: REPEATING,
            }),
            Some(KernelSource::Operators(operators)) => {
                operators.check_on(grid, boundary == Boundary::Periodic)
            }
            Some(KernelSource::Table(table)) if boundary == Boundary::NonPeriodic => {
                table.check_on(grid)
            }
            Some(KernelSource::Table(_)) => Err(Error::UnsupportedForCoatings {
                quantity: "a periodic grid",
                bodies: "a table of coefficients",
                remedy: "use a grid that is not periodic, or a response to waves",
            }),
        }
    }
}

impl Isotropic {
    fn check_near(&self, near: &ElasticPair) -> Result<()> {
        let k = NEAR / self.thickness;
        let (found, near) = ((self.response)(k).map(|value| k * value), near.times_k(k));
        let beside = found.with(near, |found, near| (found - near).abs());
        for value in [beside.normal, beside.along, beside.across, beside.coupling] {
            finite("response of the kernel", value)?;
        }
        let most = beside.normal.max(beside.along).max(beside.across);
        let quantity = "ratio of the permitted to the actual difference between the response and the pair `near` at the wave number 20/thickness";
        let found = most.max(beside.coupling) / near.normal;
        at_least(AS_ALLOWED, 1.0, quantity, CLOSE / found.max(CLOSE))?;
        Ok(())
    }
}

const NEAR_IS: &str = "the pair `near` of a kernel";
const NEAR_REMEDY: &str = "give a pair of homogeneous bodies";

/// Returns a digest of a length and of values times k. Numbers are rounded to single precision, so that round-off differences
/// between machines do not change the digest. Numbers in units of the pair do not overflow or underflow in any system of units.
fn digest_of(near: &ElasticPair, length: f64, values: &[f64]) -> u64 {
    let unit = near.compliances().normal;
    let numbers = values.iter().map(|value| value / unit);
    let bytes = numbers
        .chain([length.log2()])
        .flat_map(|number| rounded(number).to_le_bytes());
    checksum::of_bytes(&bytes.collect::<Vec<_>>())
}

/// Rounds a value to single precision.
fn rounded(value: f64) -> f64 {
    #[expect(clippy::cast_possible_truncation, reason = "to be rounded")]
    let single = value as f32;
    f64::from(single)
}

impl From<ElasticPair> for Kernel {
    fn from(pair: ElasticPair) -> Self {
        Self { pair, given: None }
    }
}

impl From<&Kernel> for Kernel {
    fn from(kernel: &Kernel) -> Self {
        kernel.clone()
    }
}

impl fmt::Debug for Kernel {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let kind = match self.given {
            None => "pair",
            Some(KernelSource::Isotropic(_)) => "isotropic",
            Some(KernelSource::Orthotropic(_)) => "orthotropic",
            Some(KernelSource::Table(_)) => "table",
            Some(KernelSource::Operators(_)) => "operators",
        };
        let mut shown = f.debug_struct("Kernel");
        shown
            .field("kind", &kind)
            .field("pair", &self.pair)
            .finish()
    }
}
