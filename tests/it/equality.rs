//! Bodies, kernels and states are equal if their physics is equal, regardless of the contents of their caches.

use kit::{unit_bodies, unit_pair};
use stickslip::history::State;
use stickslip::layers::Layer;
use stickslip::{
    Boundary, CellValue, ElasticPair, Friction, Grid, HalfSpace, History, Kernel, LoadStep,
    Material, NormalLoad, NormalProblem, Result, TangentialModel, surface,
};

fn grid() -> Grid {
    Grid::new(16, 12, 0.5, 0.5).unwrap()
}

fn coated(thickness: f64) -> Result<ElasticPair> {
    let layer = Layer::new(4.0, 0.3, thickness)?;
    let coated = Material::new(1.0, 0.3)?.coated(&[layer])?;
    ElasticPair::new(coated, Material::new(1.0, 0.3)?)
}

fn kernel(thickness: f64) -> Result<Kernel> {
    let coated = coated(thickness)?;
    let near = ElasticPair::new(Material::new(4.0, 0.3)?, Material::new(1.0, 0.3)?)?;
    Kernel::isotropic(near, thickness, move |k| {
        coated.response(k).expect("k is positive")
    })
}

#[test]
fn bodies_are_equal_if_their_physics_is_equal() -> Result<()> {
    let grid = grid();
    let bodies = HalfSpace::new(grid, unit_pair(0.3))?;
    let used = HalfSpace::new(grid, unit_pair(0.3))?;
    let ball = surface::sphere(grid, 20.0)?;
    let press = NormalLoad::Force(1.0);
    NormalProblem::builder(&used, &ball, press)
        .build()?
        .solve()?;
    // The operators in the cache of `used` are not compared.
    assert!(bodies == used && bodies == bodies.clone());

    let other_grid = Grid::new(12, 16, 0.5, 0.5)?;
    for other in [
        HalfSpace::new(other_grid, unit_pair(0.3))?,
        HalfSpace::new(grid, unit_pair(0.31))?,
        HalfSpace::new(grid, coated(0.5)?)?,
        HalfSpace::new(grid, kernel(0.5)?)?,
        HalfSpace::with_boundary(grid, unit_pair(0.3), Boundary::Periodic)?,
        HalfSpace::new(grid, unit_pair(0.3))?.with_cell_value(CellValue::Centre)?,
    ] {
        assert_ne!(bodies, other);
        assert_eq!(other, other.clone());
    }
    assert_eq!(
        HalfSpace::new(grid, kernel(0.5)?)?,
        HalfSpace::new(grid, kernel(0.5)?)?
    );
    Ok(())
}

#[test]
fn kernels_are_equal_if_their_values_are_equal() -> Result<()> {
    assert_eq!(kernel(0.5)?, kernel(0.5)?);
    assert_ne!(kernel(0.5)?, kernel(0.6)?);
    let [one, same, other] = [0.3, 0.3, 0.31].map(|ratio| Kernel::from(unit_pair(ratio)));
    assert!(one == same && one != other);
    // The pair that represents a kernel is not the kernel.
    let kernel = kernel(0.5)?;
    assert_ne!(Kernel::from(*kernel.pair()), kernel);
    Ok(())
}

#[test]
fn states_are_equal_until_a_step_differs() -> Result<()> {
    let bodies = unit_bodies(grid(), 0.3);
    let ball = surface::sphere(grid(), 20.0)?;
    for model in [TangentialModel::Scalar, TangentialModel::Vector] {
        let start = || {
            History::builder(&bodies, &ball, Friction::coulomb(0.4)?)
                .model(model)
                .build()
        };
        let (mut one, mut same) = (start()?, start()?);
        assert_eq!(one.state(), same.state());
        let steps = [
            LoadStep::hold().normal(NormalLoad::Force(1.0)),
            LoadStep::force([0.2, 0.0]).normal(NormalLoad::Force(1.5)),
            LoadStep::force([-0.2, 0.0]),
        ];
        for step in &steps {
            one.step(step)?;
            assert_ne!(one.state(), same.state());
            same.step(step)?;
            assert_eq!(one.state(), same.state());
            // The bytes do not contain the time and the residuals of the report.
            assert_eq!(*one.state(), State::from_bytes(&one.to_bytes())?);
        }
        let kept = one.state().clone();
        let mut worn = ball.clone();
        worn.as_mut_slice()[0] += 1e-3;
        one.set_gap(&worn)?;
        assert_ne!(*one.state(), kept);
        one.set_state(&kept)?;
        assert_eq!(*one.state(), kept);
    }
    Ok(())
}
