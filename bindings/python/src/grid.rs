//! Grids, materials, pairs and boundaries.

use pyo3::exceptions::{PyTypeError, PyValueError};
use pyo3::prelude::*;
#[cfg(feature = "stubs")]
use pyo3::{PyTypeInfo, inspect::PyStaticExpr, type_hint_identifier, type_hint_union};

use crate::array::Array;
use crate::error::OrRaise;
use crate::pickle::picklable;
use numpy::IntoPyArray;

/// A rectangular grid of equal cells, centred on the origin.
///
/// Parameters
/// ----------
/// nx, ny : int
///     Cells along x and y.
/// dx, dy : float
///     Sides of a cell (lengths).
///
/// Raises
/// ------
/// GridSize, NotPositive
///
/// Examples
/// --------
/// >>> import stickslip
/// >>> grid = stickslip.Grid.square(128, 0.4e-3)
/// >>> grid.shape, grid.dx
/// ((128, 128), 3.125e-06)
#[pyclass(frozen, eq, module = "stickslip", from_py_object)]
#[derive(Clone, Copy, PartialEq)]
pub(crate) struct Grid(pub(crate) stickslip::Grid);

#[pymethods]
impl Grid {
    #[new]
    fn new(py: Python<'_>, nx: usize, ny: usize, dx: f64, dy: f64) -> PyResult<Self> {
        stickslip::Grid::new(nx, ny, dx, dy).or_raise(py).map(Self)
    }

    /// ``n`` x ``n`` square cells on a square of this side (a length).
    #[staticmethod]
    fn square(py: Python<'_>, n: usize, side: f64) -> PyResult<Self> {
        stickslip::Grid::square(n, side).or_raise(py).map(Self)
    }

    /// A line of ``n`` cells along x, each ``dx`` long and one unit of length wide: forces are per length.
    #[staticmethod]
    fn line(py: Python<'_>, n: usize, dx: f64) -> PyResult<Self> {
        stickslip::Grid::line(n, dx).or_raise(py).map(Self)
    }

    /// Cells along x.
    #[getter]
    fn nx(&self) -> usize {
        self.0.nx()
    }

    /// Cells along y.
    #[getter]
    fn ny(&self) -> usize {
        self.0.ny()
    }

    /// Side of a cell along x (a length).
    #[getter]
    fn dx(&self) -> f64 {
        self.0.dx()
    }

    /// Side of a cell along y (a length).
    #[getter]
    fn dy(&self) -> f64 {
        self.0.dy()
    }

    /// Shape of the arrays on it, (ny, nx).
    #[getter]
    fn shape(&self) -> (usize, usize) {
        (self.0.ny(), self.0.nx())
    }

    /// Number of cells.
    #[getter]
    fn cells(&self) -> usize {
        self.0.cells()
    }

    /// Area of a cell.
    #[getter]
    fn cell_area(&self) -> f64 {
        self.0.cell_area()
    }

    /// Area of all cells.
    #[getter]
    fn area(&self) -> f64 {
        self.0.area()
    }

    /// Coordinates of the cell centres along x (lengths).
    #[getter]
    fn x<'py>(&self, py: Python<'py>) -> Array<'py> {
        let centres: Vec<_> = (0..self.0.nx()).map(|ix| self.0.x(ix)).collect();
        Array(centres.into_pyarray(py).into_any())
    }

    /// Coordinates of the cell centres along y (lengths).
    #[getter]
    fn y<'py>(&self, py: Python<'py>) -> Array<'py> {
        let centres: Vec<_> = (0..self.0.ny()).map(|iy| self.0.y(iy)).collect();
        Array(centres.into_pyarray(py).into_any())
    }

    /// Edges of the grid ``(left, right, bottom, top)`` (lengths), as matplotlib's ``imshow`` takes them.
    #[getter]
    fn extent(&self) -> (f64, f64, f64, f64) {
        let x = 0.5 * self.0.dx() * self.0.nx() as f64;
        let y = 0.5 * self.0.dy() * self.0.ny() as f64;
        (-x, x, -y, y)
    }

    fn __repr__(&self) -> String {
        let grid = self.0;
        format!(
            "Grid(nx={}, ny={}, dx={}, dy={})",
            grid.nx(),
            grid.ny(),
            grid.dx(),
            grid.dy()
        )
    }
}

picklable!(Grid: stickslip::Grid);

/// A linear elastic, isotropic, homogeneous half-space.
///
/// Parameters
/// ----------
/// youngs_modulus : float
///     A pressure.
/// poisson_ratio : float
///     In (-1, 0.5].
/// hardness : float, optional
///     The pressure beyond which it flows: contacts warn beyond it. None by default.
///
/// Raises
/// ------
/// NotPositive, PoissonRatio
///
/// Examples
/// --------
/// >>> import stickslip
/// >>> steel = stickslip.Material(210e9, 0.3)
/// >>> round(steel.shear_modulus / 1e9, 1)
/// 80.8
#[pyclass(frozen, eq, module = "stickslip", from_py_object)]
#[derive(Clone, Copy, PartialEq)]
pub(crate) struct Material(pub(crate) stickslip::Material);

#[pymethods]
impl Material {
    #[new]
    #[pyo3(signature = (youngs_modulus, poisson_ratio, *, hardness=None))]
    fn new(
        py: Python<'_>,
        youngs_modulus: f64,
        poisson_ratio: f64,
        hardness: Option<f64>,
    ) -> PyResult<Self> {
        let body = stickslip::Material::new(youngs_modulus, poisson_ratio).or_raise(py)?;
        match hardness {
            None => Ok(Self(body)),
            Some(hardness) => body.with_hardness(hardness).or_raise(py).map(Self),
        }
    }

    /// From the shear modulus (a pressure) instead of Young's.
    #[staticmethod]
    fn from_shear_modulus(
        py: Python<'_>,
        shear_modulus: f64,
        poisson_ratio: f64,
    ) -> PyResult<Self> {
        let body = stickslip::Material::from_shear_modulus(shear_modulus, poisson_ratio);
        body.or_raise(py).map(Self)
    }

    /// A body that does not deform.
    #[staticmethod]
    fn rigid() -> Self {
        Self(stickslip::Material::rigid())
    }

    /// Young's modulus; infinite of a rigid body.
    #[getter]
    fn youngs_modulus(&self) -> f64 {
        self.0.youngs_modulus()
    }

    /// Shear modulus.
    #[getter]
    fn shear_modulus(&self) -> f64 {
        self.0.shear_modulus()
    }

    /// Poisson's ratio.
    #[getter]
    fn poisson_ratio(&self) -> f64 {
        self.0.poisson_ratio()
    }

    /// The hardness stated; infinite if none is.
    #[getter]
    fn hardness(&self) -> f64 {
        self.0.hardness()
    }

    /// Whether it is rigid.
    #[getter]
    fn is_rigid(&self) -> bool {
        self.0.is_rigid()
    }

    /// The strain along x under a stress along x (a pressure) that cannot contract along y.
    fn plane_strain_under(&self, stress: f64) -> f64 {
        self.0.plane_strain_under(stress)
    }

    fn __repr__(&self) -> String {
        if self.0.is_rigid() {
            return "Material.rigid()".into();
        }
        let hardness = match self.0.hardness() {
            hardness if hardness.is_finite() => format!(", hardness={hardness}"),
            _ => String::new(),
        };
        format!(
            "Material(youngs_modulus={}, poisson_ratio={}{hardness})",
            self.0.youngs_modulus(),
            self.0.poisson_ratio()
        )
    }
}

picklable!(Material: stickslip::Material);

/// Two bodies, at most one of them rigid.
///
/// Parameters
/// ----------
/// body_1, body_2 : Material
///     z points into body 1.
///
/// Raises
/// ------
/// BothRigid
#[pyclass(frozen, eq, module = "stickslip", from_py_object)]
#[derive(Clone, Copy, PartialEq)]
pub(crate) struct ElasticPair(pub(crate) stickslip::ElasticPair);

#[pymethods]
impl ElasticPair {
    #[new]
    fn new(py: Python<'_>, body_1: Material, body_2: Material) -> PyResult<Self> {
        stickslip::ElasticPair::new(body_1.0, body_2.0)
            .or_raise(py)
            .map(Self)
    }

    /// The two bodies.
    #[getter]
    fn bodies(&self) -> (Material, Material) {
        self.0.bodies().map(Material).into()
    }

    /// The hardness of the softer body; infinite if none is stated.
    #[getter]
    fn hardness(&self) -> f64 {
        self.0.hardness()
    }

    /// Contact modulus E*.
    #[getter]
    fn contact_modulus(&self) -> f64 {
        self.0.contact_modulus()
    }

    /// Tangential modulus.
    #[getter]
    fn tangential_modulus(&self) -> f64 {
        self.0.tangential_modulus()
    }

    /// Shear modulus of the equivalent body.
    #[getter]
    fn equivalent_shear_modulus(&self) -> f64 {
        self.0.equivalent_shear_modulus()
    }

    /// Poisson's ratio of the equivalent body.
    #[getter]
    fn equivalent_poisson_ratio(&self) -> f64 {
        self.0.equivalent_poisson_ratio()
    }

    /// Dundurs' second parameter: whether and how strongly pressure and shear are coupled.
    #[getter]
    fn dundurs_beta(&self) -> f64 {
        self.0.dundurs_beta()
    }

    /// Whether pressure and shear are coupled.
    #[getter]
    fn is_coupled(&self) -> bool {
        self.0.is_coupled()
    }

    fn __repr__(&self) -> String {
        let [body_1, body_2] = self.0.bodies().map(|body| Material(body).__repr__());
        format!("ElasticPair({body_1}, {body_2})")
    }
}

picklable!(ElasticPair: stickslip::ElasticPair);

/// What is taken for a pair: a pair, or two materials.
pub(crate) struct Bodies(pub(crate) stickslip::ElasticPair);

impl FromPyObject<'_, '_> for Bodies {
    type Error = PyErr;

    #[cfg(feature = "stubs")]
    const INPUT_TYPE: PyStaticExpr = type_hint_union!(
        ElasticPair::TYPE_HINT,
        <(Material, Material) as FromPyObject>::INPUT_TYPE
    );

    fn extract(object: Borrowed<'_, '_, PyAny>) -> PyResult<Self> {
        if let Ok(pair) = object.cast::<ElasticPair>() {
            return Ok(Self(pair.get().0));
        }
        let (body_1, body_2): (Material, Material) = object
            .extract()
            .map_err(|_| PyTypeError::new_err("pair must be an ElasticPair or two Materials"))?;
        ElasticPair::new(object.py(), body_1, body_2).map(|pair| Self(pair.0))
    }
}

/// What lies beyond the edge of the grid.
///
/// Wherever one is taken, ``"non_periodic"``, ``"periodic"`` and ``("periodic_along_y", datum)`` are too.
#[pyclass(frozen, eq, module = "stickslip")]
#[derive(Clone, Copy, PartialEq)]
pub(crate) struct Boundary(pub(crate) stickslip::Boundary);

#[pymethods]
impl Boundary {
    /// Unloaded half-space.
    #[classattr]
    const NON_PERIODIC: Self = Self(stickslip::Boundary::NonPeriodic);

    /// The grid repeats along x and y.
    #[classattr]
    const PERIODIC: Self = Self(stickslip::Boundary::Periodic);

    /// The grid repeats along y alone: cylinders, rollers, line contacts. The datum is the distance along x at which a
    /// line load moves nothing (a length).
    #[staticmethod]
    fn periodic_along_y(datum: f64) -> Self {
        Self(stickslip::Boundary::PeriodicAlongY { datum })
    }

    /// Its name.
    #[getter]
    fn name(&self) -> &'static str {
        match self.0 {
            stickslip::Boundary::NonPeriodic => "non_periodic",
            stickslip::Boundary::Periodic => "periodic",
            stickslip::Boundary::PeriodicAlongY { .. } => "periodic_along_y",
        }
    }

    /// The datum, of a grid that repeats along y alone.
    #[getter]
    fn datum(&self) -> Option<f64> {
        match self.0 {
            stickslip::Boundary::PeriodicAlongY { datum } => Some(datum),
            _ => None,
        }
    }

    fn __repr__(&self) -> String {
        match self.0 {
            stickslip::Boundary::NonPeriodic => "Boundary.NON_PERIODIC".into(),
            stickslip::Boundary::Periodic => "Boundary.PERIODIC".into(),
            stickslip::Boundary::PeriodicAlongY { datum } => {
                format!("Boundary.periodic_along_y({datum})")
            }
        }
    }
}

picklable!(Boundary: stickslip::Boundary);

/// What is taken for a boundary.
pub(crate) struct Surroundings(pub(crate) stickslip::Boundary);

impl FromPyObject<'_, '_> for Surroundings {
    type Error = PyErr;

    #[cfg(feature = "stubs")]
    const INPUT_TYPE: PyStaticExpr = type_hint_union!(
        Boundary::TYPE_HINT,
        type_hint_identifier!("builtins", "str"),
        <(String, f64) as FromPyObject>::INPUT_TYPE
    );

    fn extract(object: Borrowed<'_, '_, PyAny>) -> PyResult<Self> {
        if let Ok(boundary) = object.cast::<Boundary>() {
            return Ok(Self(boundary.get().0));
        }
        let named = object.extract::<(String, f64)>().ok();
        if let Some((_, datum)) = named.filter(|(name, _)| name == "periodic_along_y") {
            return Ok(Self(stickslip::Boundary::PeriodicAlongY { datum }));
        }
        match object.extract::<String>().as_deref() {
            Ok("non_periodic") => Ok(Self(stickslip::Boundary::NonPeriodic)),
            Ok("periodic") => Ok(Self(stickslip::Boundary::Periodic)),
            _ => Err(PyValueError::new_err(
                "boundary must be 'non_periodic', 'periodic', ('periodic_along_y', datum) or a Boundary",
            )),
        }
    }
}
