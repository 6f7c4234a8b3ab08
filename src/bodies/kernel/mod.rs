//! Bodies of a user: linear, described by their response to waves, by influence coefficients, or by operators.
//!
//! A [`Kernel`] takes the place of an [`ElasticPair`] where a [`HalfSpace`](crate::HalfSpace) is made: pressure, traction,
//! both at once, histories, wear, stiffness and, but for operators, rolling then work with it. It describes the relative
//! displacement $`u_1 - u_2`$ of both bodies together, with the signs of the [`influence`](crate::influence) page, in one of
//! four ways.
//!
//! | | given | grids |
//! |---|---|---|
//! | [`Kernel::isotropic`] | four functions of the wave number k: a [`Response`] | all that take coated bodies |
//! | [`Kernel::orthotropic`] | a Hermitian 3 x 3 of $`(k_x, k_y)`$: a [`ResponseTensor`] | that repeat along both axes |
//! | [`Kernel::tabulated`] | a [`CoefficientTable`]: of a finite-element code, measured | that do not repeat |
//! | [`Kernel::operators`] | [`Operators`] that compute displacements | all of as many cells |
//!
//! ```
//! use stickslip::layers::Response;
//! use stickslip::*;
//! // An incompressible half-space whose modulus of shear grows in proportion to the depth, G = m z, responds to pressure
//! // as independent springs do: u_z = p / 2 m (Gibson 1967, https://doi.org/10.1680/geot.1967.17.1.58).
//! let (m, grid) = (3.0, Grid::square(32, 1.0)?);
//! let near = ElasticPair::new(Material::new(1.0, 0.5)?, Material::rigid())?;
//! let soil = Kernel::isotropic(near, 1.0, move |k| Response {
//!     normal: 0.5 / m,
//!     along: 1.0 / (m * k), // of no effect on pressures
//!     across: 1.0 / (m * k),
//!     coupling: 0.0,
//! })?;
//! let bodies = HalfSpace::with_boundary(grid, &soil, Boundary::Periodic)?;
//! let ball = surface::sphere(grid, 1.0)?;
//! let contact = NormalProblem::builder(&bodies, &ball, NormalControl::Force(0.02)).build()?.solve()?;
//! // p = 2 m (d - r^2 / 2 R) carries the force 2 pi m R d^2.
//! let largest = (2.0 * m * 0.02 / std::f64::consts::PI).sqrt();
//! assert!((contact.pressure().max() / largest - 1.0).abs() < 0.02);
//! # Ok::<(), Error>(())
//! ```
//!
//! # How a free grid is computed
//!
//! Isotropic kernels go the way of [coatings](crate::layers#from-waves-to-cells). With A of the half-space `near`,
//! $`B = \lim k\,C(k)`$ for $`k \to 0`$ and H twice the `thickness`,
//!
//! ```math
//! k\,C(k) = A + (B - A)\,e^{-kH} + k R(k) .
//! ```
//!
//! The rest R must be gone at $`kH = 40`$: it is looked at when bodies are made, and refused ([`Error::BelowMinimum`]) if
//! $`k R`$ is more than 1e-10 of $`A_n`$ there. That of a layer is, if `thickness` is its thickness. A body that changes
//! gradually from the surface on approaches A like $`1/k`$ only, and one that has no half-space as its limit, such as
//! springs, not at all: take a grid that repeats along both axes, or a table.
//!
//! A table is used as it is. On windows and coarser grids its coefficients are cut and averaged; beyond its last
//! distance, where only the periodic continuation of the transform reaches, it is continued linearly.
//!
//! # Certificate
//!
//! The least eigenvalue of a response or a table on the grid is found when an operator is planned. Where it is positive
//! errors are certified as of any bodies. Where it is not, an estimate on the infinite lattice of the cells takes its place for
//! isotropic kernels on free grids and on those that repeat along y, as for coated bodies ([`layers`](crate::layers#limits-of-the-model)). If that is not
//! positive either, and for tables, a solve is refused ([`Error::NotDefinite`]). Where pressure and traction are found
//! together, the eigenvalues of each alone decide this. Operators state their own bound; without one pressure and traction
//! are found one after the other only, and stiffness is refused. [`Report::eigenvalue_bound`](crate::Report::eigenvalue_bound)
//! tells which of these a certificate rests on.
//!
//! # Moduli and identity
//!
//! The pair `near` lends what is one number: its hardness, the ratio of tangential to normal compliance in the law of
//! entering cells, and its moduli. Closed forms, edges inside the cells and stresses below the surface
//! [refuse](Error::UnsupportedForCoatings) kernels. Two kernels count as the same bodies if `near` and a digest of their values are the
//! same: of a closure those of 41 wave numbers in single precision, of a table all, of operators their directions and the
//! works of two fields of tractions, in single precision too. States of histories keep it, so that a history continues with
//! the same kernel only.

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
use check::{AS_ALLOWED, check_mirrored, checked, checked_far, checked_tensor, ratio, stronger};

/// Two bodies by their response, or a pair of materials as it is; the page of [`kernel`](crate::kernel) tells more.
///
/// ```
/// use stickslip::{Boundary, ElasticPair, Grid, HalfSpace, Kernel, Material, layers::Layer};
/// // A closure that is a coating, on cells of any size beside the layer.
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

/// What a user gives of two bodies.
#[derive(Clone)]
pub(crate) enum KernelSource {
    Isotropic(Isotropic),
    Orthotropic(Arc<dyn Fn([f64; 2]) -> ResponseTensor + Send + Sync>),
    Table(Arc<CoefficientTable>),
    Operators(Arc<Operators>),
}

/// A response that tends to that of a half-space for short waves.
#[derive(Clone)]
pub(crate) struct Isotropic {
    response: Arc<dyn Fn(f64) -> Response + Send + Sync>,
    pub(crate) thickness: f64,
    /// k times the response for k to zero.
    pub(crate) far: Response,
}

/// The displacements by a wave of traction of one wave vector, in lengths over pressures, of bodies that are mirror images of
/// themselves along x and along y.
///
/// The Hermitian matrix of a wave has these real parts and imaginary ones; the other entries follow, such as
/// $`\hat C_{xz} = -\mathrm{i}\,C_{zx}`$. Even in $`k_x`$ and $`k_y`$ but for `xy`, which is odd in both, `zx`, odd in
/// $`k_x`$, and `zy`, odd in $`k_y`$. Of isotropic bodies they are those of the page of [`layers`](crate::layers).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ResponseTensor {
    /// Displacement along x by traction along x.
    pub xx: f64,
    /// Displacement along y by traction along y.
    pub yy: f64,
    /// Normal displacement by pressure.
    pub zz: f64,
    /// Displacement along x by traction along y.
    pub xy: f64,
    /// Normal displacement by traction along x, over i.
    pub zx: f64,
    /// Normal displacement by traction along y, over i.
    pub zy: f64,
}

impl ResponseTensor {
    /// One of the nine, or its imaginary part.
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

/// The longest wave that is looked at, in thicknesses.
const LONGEST: f64 = 1e9;
/// k times the thickness where a response must be that of its half-space, and how closely.
const NEAR: f64 = 20.0;
const CLOSE: f64 = 1e-10;
/// Most difference of the limit of long waves from that found.
const ALIKE: f64 = 1e-3;

impl Kernel {
    /// Bodies without a direction in their plane, by their response to waves of the wave number k > 0: that of
    /// [`ElasticPair::response`] (not times k), of the relative displacement. It is called on many threads, which it must not
    /// wait for, at any k from 5e-10 to 64 over the thickness, and on grids that repeat along both axes at those of their
    /// waves; it must be finite and store energy there.
    ///
    /// `near` is the pair of homogeneous half-spaces that waves much shorter than `thickness` (a length) see, to 1e-10 at
    /// $`k = 20/\text{thickness}`$, beyond which it takes the place of the response: of a coating its outermost layer. Grids that repeat along both axes take the response
    /// as it is.
    ///
    /// # Errors
    /// [`Error::UnsupportedForCoatings`] if `near` is not homogeneous; [`Error::NotPositive`] for the thickness, and for a response that is
    /// not positive, or whose coupling is too strong, at one of 41 wave numbers from $`2^{-14}`$ to $`2^6`$ over the
    /// thickness; [`Error::NotFinite`].
    pub fn isotropic(
        near: ElasticPair,
        thickness: f64,
        response: impl Fn(f64) -> Response + Send + Sync + 'static,
    ) -> Result<Self> {
        near.check_homogeneous(NEAR_IS, NEAR_REMEDY)?;
        positive("thickness of the kernel", thickness)?;
        // Extrapolated from two long waves.
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

    /// The same with `base` as k times the response for k to zero (one over a pressure): zero on a rigid base, of elastic
    /// bodies the constants of the half-space [below](crate::layers). By default it is extrapolated from the response at k of
    /// 1e-9 over the thickness and at half of it, from which it may differ by 1e-3 of that of `near`. Of other kernels
    /// without effect.
    ///
    /// # Errors
    /// [`Error::NotFinite`]; [`Error::BelowMinimum`] for a base that is not that of the response.
    pub fn with_long_wave_limit(mut self, base: Response) -> Result<Self> {
        if let Some(KernelSource::Isotropic(isotropic)) = &mut self.given {
            let base = checked_far(base)?;
            let beside = base.with(isotropic.far, |base, far| (base - far).abs());
            let most = beside.normal.max(beside.along).max(beside.across);
            let found = most.max(beside.coupling) / self.pair.compliances().normal;
            let quantity = "allowed over found difference of the long waves from the response";
            at_least(AS_ALLOWED, 1.0, quantity, ALIKE / found.max(ALIKE))?;
            isotropic.far = base;
        }
        Ok(self)
    }

    /// Bodies whose elastic axes lie along the grid, by their response to waves of the wave vector $`(k_x, k_y)`$, not zero:
    /// for grids that repeat along both axes. `near` lends hardness and moduli, `length` is about that on which the response
    /// changes.
    ///
    /// ```
    /// use stickslip::{Boundary, ElasticPair, Grid, HalfSpace, Kernel, Material, NormalControl, NormalProblem};
    /// use stickslip::{Field, kernel::ResponseTensor};
    /// // A pressure sinks waves along x four times as far as waves along y.
    /// let near = ElasticPair::new(Material::new(1.0, 0.5)?, Material::rigid())?;
    /// let fibres = Kernel::orthotropic(near, 1.0, |[x, y]| {
    ///     let c = 1.0 / (x * x / 16.0 + y * y).sqrt();
    ///     ResponseTensor { xx: c, yy: c, zz: c, xy: 0.0, zx: 0.0, zy: 0.0 }
    /// })?;
    /// let grid = Grid::square(48, 1.0)?;
    /// let bodies = HalfSpace::with_boundary(grid, &fibres, Boundary::Periodic)?;
    /// let ball = stickslip::surface::sphere(grid, 1.0)?;
    /// let contact = NormalProblem::builder(&bodies, &ball, NormalControl::Force(0.01)).build()?.solve()?;
    /// // The contact is an ellipse, the longer axis along the softer direction of its waves.
    /// let pressed = |i, j| contact.pressure().get(i, j).unwrap_or(0.0) > 0.0;
    /// let along = |x: bool| (0..48).filter(|&n| if x { pressed(n, 24) } else { pressed(24, n) }).count();
    /// assert!(along(true) != along(false));
    /// # Ok::<(), stickslip::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::UnsupportedForCoatings`] if `near` is not homogeneous; [`Error::NotPositive`] for the length, and for a compliance of an axis
    /// that is not positive at one of 41 wave numbers in three directions; [`Error::NotFinite`]; [`Error::BelowMinimum`] for a
    /// tensor that is not its mirror image to 1e-10.
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

    /// Bodies by their influence coefficients, for free grids of the cells of the table, as large as it or smaller. `near` lends
    /// hardness and moduli.
    ///
    /// # Errors
    /// [`Error::UnsupportedForCoatings`] if `near` is not homogeneous; [`Error::Sample`] for a coefficient that is odd along an axis and not
    /// zero at distance zero along it, to 1e-12 of the largest.
    pub fn tabulated(near: ElasticPair, table: CoefficientTable) -> Result<Self> {
        near.check_homogeneous(NEAR_IS, NEAR_REMEDY)?;
        table.check_odd()?;
        let mark = (table.digest(), table.coupling());
        Ok(Self::new(&near, mark, KernelSource::Table(Arc::new(table))))
    }

    /// Bodies by [operators](Operators) on the cells of a grid, of any boundary: whatever displacements they compute from
    /// tractions. `near` is the pair of homogeneous half-spaces that they resemble for waves of a few cells: its inverse
    /// preconditions the solves, which converge the faster the better it fits, to the same answer. It lends hardness and
    /// moduli, whether pressure and traction are [coupled](ElasticPair::is_coupled), and how strongly: what
    /// [`CoupledReport::error_estimate`](crate::coupled::CoupledReport::error_estimate) reckons with.
    ///
    /// A contact is solved on all cells of the grid: no window, no coarser grids. A [lower bound](crate::Operator::lower_bound)
    /// of an operator makes its certificate; without one [`Report::duality_gap`](crate::Report::duality_gap) is the duality
    /// gap, and does not decide when a solve ends; pressure and traction are then not found together, nor stiffness, nor cycles
    /// of wear that a step may jump. Rolling, ranks, dense matrices, edges inside the cells and stresses refuse such bodies. On
    /// a grid that repeats along both axes an operator must map constants to zero. A
    /// [cell value](crate::HalfSpace::with_cell_value) changes nothing of an operator: it says which values it takes.
    ///
    /// # Errors
    /// [`Error::UnsupportedForCoatings`] if `near` is not homogeneous; [`Error::IncompleteKernel`] without an operator;
    /// [`Error::RepeatedDirection`]; [`Error::Length`] for operators of different numbers of cells; and, of two fields without
    /// mean, [`Error::NotPositive`] for an energy, [`Error::NotFinite`], [`Error::UnsupportedByModel`] for works that differ by more
    /// than 1e-9 of the energies or for a coupling that `near` has not, [`Error::BelowMinimum`] for an energy less than the lower
    /// bound states; [`Error::Memory`].
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

    /// The pair that lends hardness and moduli, marked as that of this kernel: [`HalfSpace::pair`](crate::HalfSpace::pair). By
    /// itself it makes no bodies ([`Error::IncompleteKernel`]).
    #[must_use]
    pub fn pair(&self) -> &ElasticPair {
        &self.pair
    }

    /// What a user gives; nothing of a pair of materials.
    pub(crate) fn given(&self) -> Option<&KernelSource> {
        self.given.as_ref()
    }

    /// Operators of a user, if they are all there is.
    pub(crate) fn user_operators(&self) -> Option<&Operators> {
        match &self.given {
            Some(KernelSource::Operators(operators)) => Some(operators),
            _ => None,
        }
    }

    /// `Ok` where it is known how bodies respond at any place.
    pub(crate) fn check_no_operators(&self, quantity: &'static str) -> Result<()> {
        match self.user_operators() {
            None => Ok(()),
            Some(_) => Err(Error::UnsupportedForCoatings {
                quantity,
                bodies: "user-defined operators",
                remedy: "describe the bodies by materials, layers or a response, which are known beyond the cells of one grid",
            }),
        }
    }

    /// The wave number k > 0 times the response to waves of it, of bodies without a direction.
    pub(crate) fn times_k(&self, k: f64) -> Response {
        match &self.given {
            Some(KernelSource::Isotropic(of)) => (of.response)(k).map(|value| k * value),
            _ => self.pair.times_k(k),
        }
    }

    /// The same with the half-space that short waves see in place of the response to them.
    pub(crate) fn short_times_k(&self, k: f64) -> Response {
        match &self.given {
            Some(KernelSource::Isotropic(of)) if k * of.thickness > NEAR => self.pair.times_k(k),
            _ => self.times_k(k),
        }
    }

    /// The limit of the wave number times the response for long waves.
    pub(crate) fn long_times_k(&self) -> Response {
        match &self.given {
            Some(KernelSource::Isotropic(of)) => of.far,
            _ => self.pair.times_k(0.0),
        }
    }

    /// Whether it is a response to waves that is not that of homogeneous half-spaces.
    pub(crate) fn has_response(&self) -> bool {
        match &self.given {
            None => self.pair.is_coated(),
            Some(given) => matches!(given, KernelSource::Isotropic(_)),
        }
    }

    /// `Ok` if bodies on the grid can be made of it.
    pub(crate) fn check_on(&self, grid: Grid, boundary: Boundary) -> Result<()> {
        const REPEATING: &str =
            "take a grid that repeats along both axes, or a table of coefficients";
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
                quantity: "a grid that does not repeat along both axes",
                bodies: "an orthotropic response",
                remedy: REPEATING,
            }),
            Some(KernelSource::Operators(operators)) => {
                operators.check_on(grid.cells(), boundary == Boundary::Periodic)
            }
            Some(KernelSource::Table(table)) if boundary == Boundary::NonPeriodic => {
                table.check_on(grid)
            }
            Some(KernelSource::Table(_)) => Err(Error::UnsupportedForCoatings {
                quantity: "a grid that repeats",
                bodies: "a table of coefficients",
                remedy: "take a grid that does not repeat, or a response to waves",
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
        let quantity = "allowed over found difference of the response from the half-space near, at 20 over the thickness,";
        let found = most.max(beside.coupling) / near.normal;
        at_least(AS_ALLOWED, 1.0, quantity, CLOSE / found.max(CLOSE))?;
        Ok(())
    }
}

const NEAR_IS: &str = "the half-space near of a kernel";
const NEAR_REMEDY: &str = "give a pair of homogeneous bodies";

/// The wave numbers at which a kernel is looked at.
fn wave_numbers(thickness: f64) -> impl Iterator<Item = f64> {
    (-28..=12).map(move |n| (0.5 * f64::from(n)).exp2() / thickness)
}

/// Half octaves from the longest wave of a grid to the shortest.
fn waves_of(grid: Grid) -> impl Iterator<Item = f64> {
    let pi = std::f64::consts::PI;
    let longest = (grid.nx() as f64 * grid.dx()).max(grid.ny() as f64 * grid.dy());
    let shortest = pi * (1.0 / grid.dx()).hypot(1.0 / grid.dy());
    let next =
        move |k: &f64| (*k < shortest).then_some((std::f64::consts::SQRT_2 * k).min(shortest));
    std::iter::successors(Some(2.0 * pi / longest), next)
}

/// Of a length and of values times k, in single precision: what differs between machines by the last digits is the same. In
/// the units of the pair, so that no unit is too small or too large.
fn digest_of(near: &ElasticPair, length: f64, values: &[f64]) -> u64 {
    let unit = near.compliances().normal;
    let numbers = values.iter().map(|value| value / unit);
    let bytes = numbers
        .chain([length.log2()])
        .flat_map(|number| rounded(number).to_le_bytes());
    checksum::of_bytes(&bytes.collect::<Vec<_>>())
}

/// To single precision.
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
