//! From a case to its row: a surface, pressed, then sheared.

use stickslip::surface::{self, RoughSurface, SelfAffine};
use stickslip::{
    Boundary, ElasticPair, Error, Friction, Grid, HalfSpace, Material, NormalControl,
    NormalProblem, NormalSolution, Result, TangentialLoad, TangentialProblem, TangentialSolution,
};

use super::plan::{Plan, Press};
use super::row::{Ending, Row};

/// Young's modulus, rms slope and side of the surface. Between half-spaces pressures are proportional to modulus and
/// slope, lengths to the side: as all results are ratios, these numbers do not show in them.
const UNIT: f64 = 1.0;
/// Identical bodies: their pressure does not depend on the shear.
const POISSON_RATIO: f64 = 0.3;

/// What all cases of a plan share.
#[derive(Debug)]
pub(super) struct Scene<'p> {
    plan: &'p Plan,
    bodies: HalfSpace,
}

impl<'p> Scene<'p> {
    pub(super) fn new(plan: &'p Plan) -> Result<Self> {
        let grid = Grid::square(plan.cells, UNIT)?;
        let material = Material::new(UNIT, POISSON_RATIO)?;
        let pair = ElasticPair::new(material, material)?;
        let bodies = HalfSpace::with_boundary(grid, pair, Boundary::Periodic)?;
        Ok(Self { plan, bodies })
    }

    /// Solves cases of one press; `each` takes their rows as they are finished, and says whether to go on.
    ///
    /// Nothing is carried over from case to case but the pressure, so that the bits of a row do not depend on what
    /// was solved before it.
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
        NormalProblem::builder(&self.bodies, gap, NormalControl::Force(force))
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

/// What belongs to the case is its ending. Any other error ends the study, and leaves no row: it may not be there the
/// next time, as memory.
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
