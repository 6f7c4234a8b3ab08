//! Computation of the row of a case: a surface is generated, pressed and sheared.

use stickslip::surface::{self, RoughSurface, SelfAffine};
use stickslip::{
    Boundary, ElasticPair, Error, Friction, Grid, HalfSpace, Material, NormalLoad, NormalProblem,
    NormalSolution, Result, TangentialLoad, TangentialProblem, TangentialSolution,
};

use super::plan::{Plan, Press};
use super::row::{Ending, Row};

/// Young's modulus, rms slope and side of the surface. For half-spaces, pressures are proportional to the modulus and
/// the slope, and lengths to the side. All results are ratios, so they do not depend on these numbers.
const UNIT: f64 = 1.0;
/// Poisson's ratio of both bodies. Because the bodies are identical, the pressure does not depend on the shear.
const POISSON_RATIO: f64 = 0.3;

/// Data common to all cases of a plan.
#[derive(Debug)]
pub(super) struct StudyCase<'p> {
    plan: &'p Plan,
    bodies: HalfSpace,
}

impl<'p> StudyCase<'p> {
    pub(super) fn new(plan: &'p Plan) -> Result<Self> {
        let grid = Grid::square(plan.cells, UNIT)?;
        let material = Material::new(UNIT, POISSON_RATIO)?;
        let pair = ElasticPair::new(material, material)?;
        let bodies = HalfSpace::with_boundary(grid, pair, Boundary::Periodic)?;
        Ok(Self { plan, bodies })
    }

    /// Solves cases of one press. `each` receives each row when it is finished and returns whether to continue.
    ///
    /// Cases share only the pressure, so that a row is bitwise independent of the previously solved cases.
    pub(super) fn press(
        &self,
        press: usize,
        cases: &[usize],
        mut each: impl FnMut(Row) -> bool,
    ) -> Result<()> {
        let press = self.plan.press(press);
        let rough = self.surface(press)?;
        let force = press.pressure * self.bodies.pair().contact_modulus() * UNIT;
        let normal = ending(self.normal(&rough, force))?;
        for &case in cases {
            let tangential = match normal.solution() {
                Some(normal) => ending(self.tangential(normal, self.plan.friction(case), force))?,
                None => Ending::Refused("not solved"),
            };
            let key = self.plan.key(case);
            if !each(Row::new(key, rough.rms_height(), &normal, &tangential)) {
                break;
            }
        }
        Ok(())
    }

    fn surface(&self, press: Press) -> Result<RoughSurface> {
        let grid = self.bodies.grid();
        SelfAffine::with_rms_slope(UNIT)
            .hurst(press.hurst)
            .roll_off_wavelength(self.plan.roll_off * UNIT)
            .cut_off_wavelength(self.plan.cut_off * grid.dx())
            .seed(press.seed)
            .generate(grid)
    }

    fn normal(&self, rough: &RoughSurface, force: f64) -> Result<NormalSolution> {
        let gap = surface::gap_from_heights(rough.heights())?;
        NormalProblem::builder(&self.bodies, gap, NormalLoad::Force(force))
            .tolerance(self.plan.tolerance)
            .max_iterations(self.plan.iterations)
            .build()?
            .solve()
    }

    fn tangential(
        &self,
        normal: &NormalSolution,
        friction: f64,
        force: f64,
    ) -> Result<TangentialSolution> {
        let load = TangentialLoad::force([self.plan.pull * force, 0.0]);
        let friction = Friction::coulomb(friction)?;
        TangentialProblem::builder(&self.bodies, normal, friction, load)
            .tolerance(self.plan.tolerance)
            .max_iterations(self.plan.iterations)
            .build()?
            .solve()
    }
}

/// Converts the result of a solve to its outcome. Any other error, for example lack of memory, ends the study without a
/// row, because it might not occur in the next run.
fn ending<T>(solved: Result<T>) -> Result<Ending<T>> {
    match solved {
        Ok(solution) => Ok(Ending::Solved(solution)),
        Err(Error::NotConverged(report)) => Ok(Ending::Failed(report)),
        Err(Error::BeyondFrictionCapacity { .. }) => {
            Ok(Ending::Refused("beyond the friction capacity"))
        }
        Err(error) => Err(error),
    }
}
