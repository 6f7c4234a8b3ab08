//! Contacts for measurements: the ball of the paper, and a rough surface under three loads.

use stickslip::analytical::{CattaneoMindlin, HertzSphere};
use stickslip::cgm::Method;
use stickslip::surface::SelfAffine;
use stickslip::{
    ElasticPair, Field, Friction, Grid, HalfSpace, Material, NormalLoad, NormalProblem,
    NormalSolution, Result, TangentialLoad, TangentialProblem, surface,
};

pub const FRICTION: f64 = 0.5;
/// Tangential force relative to the force at which the contact slides.
pub const LOADING: f64 = 0.4;

/// Mean pressures divided by the contact modulus. They were adjusted on 256 x 256 cells until about 2, 10 and 40 % of
/// the cells were in contact. The surface has the same slope on every grid, so the fractions are nearly the same on
/// all grids.
const ROUGH_LOADS: [(&str, f64); 3] = [
    ("rough-2%", 0.0009),
    ("rough-10%", 0.0044),
    ("rough-40%", 0.024),
];

/// Two bodies that are pressed and then sheared along x.
#[derive(Debug)]
pub struct BenchmarkCase {
    pub name: &'static str,
    pub bodies: HalfSpace,
    pub gap: Field,
    pub force: f64,
    exact: Option<CattaneoMindlin>,
}

/// Returns the ball of Table 2 of the paper, in SI units, on a square with a side of three contact radii.
pub fn ball(cells: u16) -> Result<BenchmarkCase> {
    let steel = Material::new(213e9, 0.29)?;
    let pair = ElasticPair::new(steel, steel)?;
    let hertz = HertzSphere::new(&pair, 3.5e-3, 100.0)?;
    let grid = Grid::square(usize::from(cells), 3.0 * hertz.contact_radius())?;
    let shear_force = LOADING * FRICTION * hertz.load();
    Ok(BenchmarkCase {
        name: "sphere",
        bodies: HalfSpace::new(grid, pair)?,
        gap: surface::sphere(grid, hertz.radius())?,
        force: hertz.load(),
        exact: Some(CattaneoMindlin::new(hertz, FRICTION, shear_force)?),
    })
}

/// Returns one rough surface on two equal bodies under three loads. The contact modulus `E / 2(1 - nu^2)` is the unit
/// of pressure, and the cells are the unit of length.
pub fn rough(cells: u16) -> Result<[BenchmarkCase; 3]> {
    let body = Material::new(2.0 * (1.0 - 0.3 * 0.3), 0.3)?;
    let side = f64::from(cells);
    let grid = Grid::square(usize::from(cells), side)?;
    let rough = SelfAffine::with_rms_slope(0.1)
        .longest_wavelength(side / 4.0)
        .roll_off_wavelength(side / 4.0)
        .seed(1)
        .generate(grid)?;
    let gap = surface::gap_from_heights(rough.heights())?;
    let bodies = HalfSpace::new(grid, ElasticPair::new(body, body)?)?;
    Ok(ROUGH_LOADS.map(|(name, pressure)| BenchmarkCase {
        name,
        bodies: bodies.clone(),
        gap: gap.clone(),
        force: pressure * gap.grid().area(),
        exact: None,
    }))
}

impl BenchmarkCase {
    pub fn normal(&self, method: Method, tolerance: f64) -> Result<NormalProblem> {
        let load = NormalLoad::Force(self.force);
        NormalProblem::builder(&self.bodies, &self.gap, load)
            .method(method)
            .tolerance(tolerance)
            .build()
    }

    pub fn tangential(
        &self,
        normal: &NormalSolution,
        method: Method,
        tolerance: f64,
    ) -> Result<TangentialProblem> {
        let friction = Friction::coulomb(FRICTION)?;
        let load = TangentialLoad::force([LOADING * FRICTION * self.force, 0.0]);
        TangentialProblem::builder(&self.bodies, normal, friction, load)
            .method(method)
            .tolerance(tolerance)
            .build()
    }

    /// Returns the pressure and the traction at the centres of the cells, if they have a closed form.
    pub fn closed_form(&self) -> Option<[Field; 2]> {
        let exact = self.exact?;
        let pressure = |x: f64, y: f64| exact.hertz().pressure(x.hypot(y));
        let traction = |x: f64, y: f64| exact.traction(x.hypot(y));
        let grid = self.bodies.grid();
        Some([
            Field::from_fn(grid, pressure),
            Field::from_fn(grid, traction),
        ])
    }
}
