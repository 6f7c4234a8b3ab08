//! Each kind of work on a contact of few cells, with its name.

use stickslip::analytical::HertzSphere;
use stickslip::cgm::{self, NonNegative, Problem, Settings};
use stickslip::fft::Convolution;
use stickslip::history::wear::{self, CycleJump};
use stickslip::history::{AdaptiveSteps, Cycle, FrettingLoop, LoadPath};
use stickslip::influence::{Component, Direction, Table};
use stickslip::stiffness::ContactStiffness;
use stickslip::subsurface::{self, Body, Planes, Tractions};
use stickslip::surface::{Form, PowerSpectrum, SelfAffine, Statistics};
use stickslip::*;

/// Observer that runs a piece of work and checks its effects.
pub(crate) type Watch<'a> = &'a mut dyn FnMut(&str, &mut dyn FnMut() -> Result<()>);

fn pair(poisson_ratio: f64) -> ElasticPair {
    ElasticPair::new(
        Material::new(1.0, poisson_ratio).unwrap(),
        Material::rigid(),
    )
    .unwrap()
}

/// Creates fields, shapes and rough surfaces.
pub(crate) fn surfaces(grid: Grid, watch: Watch<'_>) {
    let ball = surface::sphere(grid, 10.0).unwrap();
    watch("field", &mut || {
        let mut sum = ball.scaled(2.0);
        sum.add_scaled(-1.0, &ball)?;
        let difference = sum.minus(&ball)?;
        assert!(difference.max() <= 0.0 && difference.min() <= 0.0);
        assert!(ball.integral() > 0.0);
        Ok(())
    });
    watch("statistics", &mut || Statistics::of(&ball).map(drop));
    watch("power spectrum", &mut || PowerSpectrum::of(&ball).map(drop));
    watch("level", &mut || {
        surface::level(&ball, Form::Plane)?;
        surface::level(&ball, Form::Polynomial(3)).map(drop)
    });
    watch("resample", &mut || surface::resample(&ball, grid).map(drop));
    watch("gap", &mut || surface::gap_between(&ball, &ball).map(drop));
    watch("fill", &mut || {
        let mut holed = ball.clone();
        holed.as_mut_slice()[17] = f64::NAN;
        surface::fill_missing(&holed).map(drop)
    });
    let rough = SelfAffine::with_rms_height(0.1).seed(3);
    watch("rough", &mut || rough.generate(grid).map(drop));
    let part = rough.cropped().skewness(0.3);
    watch("cropped", &mut || part.generate(grid).map(drop));
}

/// Applies operators, and solves with them.
pub(crate) fn operators(grid: Grid, watch: Watch<'_>) {
    let cells = grid.cells();
    let product = |operator: &dyn Fn(&[f64], &mut [f64])| {
        let mut displacement = vec![0.0; cells];
        operator(&vec![1.0; cells], &mut displacement);
        assert!(displacement.iter().all(|u| u.is_finite()));
    };
    watch("table", &mut || {
        Table::sample(grid, &pair(0.3), Component::ZX).map(drop)
    });
    watch("convolution", &mut || {
        let normal = Convolution::new(grid, &pair(0.3), Component::ZZ)?;
        product(&|x, u| normal.apply([x], [u], &mut normal.scratch().unwrap()));
        let periodic = Convolution::periodic(grid, &pair(0.3), Component::ZZ);
        product(&|x, u| periodic.apply([x], [u], &mut periodic.scratch().unwrap()));
        Ok(())
    });
    let datum = 10.0 * grid.dx() * grid.nx() as f64;
    for boundary in [
        Boundary::NonPeriodic,
        Boundary::Periodic,
        Boundary::PeriodicAlongY { datum },
    ] {
        let bodies = HalfSpace::with_boundary(grid, pair(0.3), boundary).unwrap();
        watch("operators", &mut || {
            let normal = bodies.operator(Component::ZZ)?;
            product(&|x, u| normal.apply([x], [u], &mut normal.scratch().unwrap()));
            if let Some(inverse) = bodies.preconditioner(Component::ZZ)? {
                product(&|x, u| inverse.apply([x], [u], &mut inverse.scratch().unwrap()));
            }
            let directions = [Direction::X, Direction::Y, Direction::Z];
            let all = bodies.tensor_operator(directions)?;
            let (x, mut u) = (vec![1.0; cells], [(); 3].map(|()| vec![0.0; cells]));
            let out = u.each_mut().map(|u| &mut u[..]);
            all.apply([&x, &x, &x], out, &mut all.scratch().unwrap());
            bodies
                .tensor_preconditioner([Direction::X, Direction::Y])
                .map(drop)
        });
    }
    let bodies = HalfSpace::new(grid, pair(0.3)).unwrap();
    watch("minimise", &mut || {
        let ball = surface::sphere(grid, 10.0)?;
        let linear: Vec<f64> = ball.as_slice().iter().map(|gap| gap - 0.1).collect();
        let problem = Problem::new(bodies.operator(Component::ZZ)?, [&linear], NonNegative);
        let mut pressure = vec![0.0; cells];
        cgm::minimise(&problem, &Settings::default(), [&mut pressure]).map(drop)
    });
}

/// Solves problems, evaluates their solutions, and computes stiffness and stress.
pub(crate) fn solutions(grid: Grid, watch: Watch<'_>) {
    let bodies = HalfSpace::new(grid, pair(0.3)).unwrap();
    let ball = surface::sphere(grid, 10.0).unwrap();
    let friction = Friction::coulomb(0.3).unwrap();
    let mut pressed = None;
    watch("normal", &mut || {
        let load = NormalLoad::Force(0.5);
        pressed = Some(
            NormalProblem::builder(&bodies, &ball, load)
                .build()?
                .solve()?,
        );
        Ok(())
    });
    let normal = pressed.unwrap();
    watch("normal solution", &mut || {
        let hertz = HertzSphere::new(bodies.pair(), 10.0, normal.force())?;
        assert!((normal.mean_pressure() / hertz.mean_pressure() - 1.0).abs() < 0.2);
        normal.elastic_energy(&bodies)?;
        normal.displacement(&bodies)?;
        let _ = (
            normal.moments(),
            normal.centre_of_pressure(),
            normal.warnings(),
        );
        let _ = (normal.contact_area_corrected(), normal.spots().unwrap());
        normal.stiffness(&bodies).map(drop)
    });
    for model in [TangentialModel::Scalar, TangentialModel::Vector] {
        let mut sheared = None;
        watch("tangential", &mut || {
            let load = TangentialLoad::force([0.05, 0.0]);
            let builder = TangentialProblem::builder(&bodies, &normal, friction.clone(), load);
            let builder = builder.model(model).coupling(Coupling::Neglected);
            sheared = Some(builder.build()?.solve()?);
            Ok(())
        });
        let shear = sheared.unwrap();
        watch("tangential solution", &mut || {
            let _ = (shear.force(), shear.moment(), shear.dissipated_energy());
            let _ = (shear.stick_area(), shear.warnings());
            shear.elastic_energy(&bodies)?;
            shear.displacement(&bodies)?;
            shear.stiffness(&bodies)?;
            ContactStiffness::new(&bodies, &normal, &friction, &shear).map(drop)
        });
    }
    watch("coupled", &mut || {
        let load = TangentialLoad::force([0.05, 0.0]);
        let press = NormalLoad::Force(0.5);
        let problem = CoupledProblem::builder(&bodies, &ball, friction.clone(), press, load);
        let contact = problem.build()?.solve()?;
        assert!(contact.elastic_energy() > 0.0);
        Ok(())
    });
    watch("stresses", &mut || {
        let points: Vec<_> = (1..50).map(|i| [0.0, 0.0, 0.1 * f64::from(i)]).collect();
        subsurface::at_points(
            &bodies,
            Body::One,
            Tractions::new(normal.pressure()),
            &points,
        )?;
        let mut planes = Planes::new(&bodies, &[0.0, 0.5])?.with_displacements();
        let plane = planes.solve(1, Body::One, &normal)?;
        assert!(plane.map(|stress| stress.von_mises()).max() > 0.0);
        planes.through(Body::One, &normal, |_| Ok(()))
    });
}

/// Takes steps of histories, cycles and wear.
pub(crate) fn histories(grid: Grid, watch: Watch<'_>) {
    let bodies = HalfSpace::new(grid, pair(0.3)).unwrap();
    let ball = surface::sphere(grid, 10.0).unwrap();
    let builder = || {
        let friction = Friction::coulomb(0.3)?;
        let builder = History::builder(&bodies, &ball, friction).coupling(Coupling::Neglected);
        builder.model(TangentialModel::Vector).build()
    };
    watch("history", &mut || {
        let mut history = builder()?;
        history.step(&LoadStep::hold().normal(NormalLoad::Force(0.5)))?;
        let mut steps = AdaptiveSteps::new(&history, 0.05)?;
        steps.step(&mut history, &LoadStep::force([0.05, 0.0]))?;
        let _ = (
            history.friction_capacity(),
            history.moment(),
            history.tangential_force(),
        );
        let _ = (
            history.spots().unwrap(),
            history.last_step().unwrap().warnings(),
            history.displacement()?,
        );
        history.stiffness()?;
        let state = history.state().clone();
        history.set_state(&state)?;
        history.set_gap(&ball)?;
        History::from_state(&bodies, state).map(drop)
    });
    watch("cycle and wear", &mut || {
        let mut history = builder()?;
        let load = |force| LoadStep::force(force).normal(NormalLoad::Force(0.5));
        history.step(&load([0.0, 0.0]))?;
        let path = LoadPath::sine([0.05, 0.0], 4)?;
        let mut cycle = Cycle::new(&history);
        FrettingLoop::new(path, load).cycle(&mut history, &mut cycle)?;
        let mut depth = Field::zeros(grid);
        wear::archard(
            1e-3,
            cycle.slip_pressure(),
            cycle.slip_distance(),
            &mut depth,
        )?;
        CycleJump::new(&bodies, &cycle, &depth)?
            .max_residual(0.9)
            .cycles()?;
        let mut worn = ball.clone();
        worn.add_scaled(1.0, &depth)?;
        history.set_gap(&worn)
    });
}
