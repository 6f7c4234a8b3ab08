//! Long-running calls other than solves call their observer between products. They end with [`Error::NotConverged`]
//! when the observer cancels, and leave everything unchanged.

use std::fmt::Debug;
use std::ops::ControlFlow;

use kit::unit_bodies;
use stickslip::Iteration;
use stickslip::stiffness::ContactStiffness;
use stickslip::subsurface::{self, Body, Planes, Tractions};
use stickslip::surface::SelfAffine;
use stickslip::{
    Axis, Coupling, Error, Field, Friction, HalfSpace, History, LoadStep, NormalLoad,
    NormalProblem, NormalSolution, Status, TangentialLoad, TangentialModel, TangentialProblem,
};

type Observer<'a> = &'a mut (dyn FnMut(&Iteration) -> ControlFlow<()> + Send);

/// Cancels at the first call of the observer, at a call in the middle and at the last call. Checks that a complete run
/// has the same result before and after the cancelled runs.
fn assert_stops_when_cancelled<T: Debug + PartialEq>(
    mut call: impl FnMut(Observer<'_>) -> Result<T, Error>,
) {
    let mut calls = 0;
    let whole = call(&mut |seen| {
        let products = seen.double_precision_products + seen.single_precision_products;
        assert_eq!(products, calls);
        calls += 1;
        ControlFlow::Continue(())
    });
    let whole = whole.unwrap();
    assert!(calls > 2, "observer called {calls} times");
    for last in [0, calls / 2, calls - 1] {
        let mut count = 0;
        let outcome = call(&mut |_| {
            count += 1;
            if count > last {
                return ControlFlow::Break(());
            }
            ControlFlow::Continue(())
        });
        let Err(Error::NotConverged(report)) = outcome else {
            panic!("cancelled at {last} of {calls}: {outcome:?}");
        };
        assert_eq!(report.status, Status::Cancelled);
        assert_eq!(report.products(), last);
        assert_eq!(count, last + 1, "observer called again after it cancelled");
    }
    assert_eq!(call(&mut |_| ControlFlow::Continue(())).unwrap(), whole);
}

fn scene() -> (HalfSpace, Field, NormalSolution, Friction) {
    let bodies = unit_bodies(kit::square(kit::thorough(16, 24), 8.0), 0.3);
    let ball = kit::sphere(bodies.grid(), 10.0);
    let load = NormalLoad::Force(0.5);
    let problem = NormalProblem::builder(&bodies, &ball, load)
        .build()
        .unwrap();
    let pressed = problem.solve().unwrap();
    (bodies, ball, pressed, kit::coulomb(0.3))
}

#[test]
fn stiffness_stops_when_cancelled() {
    let (bodies, ball, pressed, friction) = scene();
    assert_stops_when_cancelled(|observer| pressed.stiffness_observed(&bodies, observer));
    for model in [TangentialModel::Scalar, TangentialModel::Vector] {
        let load = TangentialLoad::force([0.05, 0.0]);
        let problem = TangentialProblem::builder(&bodies, &pressed, friction.clone(), load);
        let problem = problem.model(model).coupling(Coupling::Neglected);
        let shear = kit::solve(problem);
        assert_stops_when_cancelled(|observer| shear.stiffness_observed(&bodies, observer));
        assert_stops_when_cancelled(|observer| {
            ContactStiffness::observed(&bodies, &pressed, &friction, &shear, observer)
        });
    }
    let builder = History::builder(&bodies, &ball, friction).axis(Axis::X);
    let mut history = builder.coupling(Coupling::Neglected).build().unwrap();
    let load = LoadStep::force([0.05, 0.0]).normal(NormalLoad::Force(0.5));
    history.step(&load).unwrap();
    let state = history.to_bytes();
    assert_stops_when_cancelled(|observer| history.stiffness_observed(observer));
    assert_eq!(history.to_bytes(), state);
}

#[test]
fn rough_surface_stops_when_cancelled() {
    let rough = SelfAffine::with_rms_height(0.1).seed(5);
    for surface in [rough, rough.skewness(0.4), rough.kurtosis(3.5).cropped()] {
        assert_stops_when_cancelled(|observer| {
            surface.generate_observed(kit::square(32, 1.0), observer)
        });
    }
}

#[test]
fn subsurface_stress_stops_when_cancelled() {
    let (bodies, _, pressed, _) = scene();
    let depths = [0.0, 0.3, 0.9];
    let planes = Planes::new(&bodies, &depths).unwrap().with_displacements();
    // The kernels are computed each time in the first case, and cached in the second.
    let mut kept = planes.clone();
    kept.solve(1, Body::One, &pressed).unwrap();
    let stress = |plane: &subsurface::Plane| plane.stresses().collect::<Vec<_>>();
    assert_stops_when_cancelled(|observer| {
        let mut planes = Planes::new(&bodies, &depths).unwrap();
        let plane = planes.solve_observed(1, Body::One, &pressed, observer);
        plane.map(|plane| stress(&plane))
    });
    assert_stops_when_cancelled(|observer| {
        let plane = kept.solve_observed(1, Body::One, &pressed, observer);
        plane.map(|plane| stress(&plane))
    });
    let mut whole = planes.clone();
    assert_stops_when_cancelled(|observer| {
        let mut found = Vec::new();
        let visit = |plane: &subsurface::Plane| {
            found.push(stress(plane));
            Ok(())
        };
        let outcome = whole.through_observed(Body::One, &pressed, visit, observer);
        outcome.map(|()| found)
    });
    let points: Vec<_> = (0..1000_u32)
        .map(|i| [0.0, 0.0, 1e-3 * f64::from(i)])
        .collect();
    let tractions = Tractions::new(pressed.pressure());
    assert_stops_when_cancelled(|observer| {
        subsurface::at_points_observed(&bodies, Body::One, tractions, &points, observer)
    });
}

#[test]
fn volume_file_stops_when_cancelled() {
    let (bodies, _, pressed, _) = scene();
    let mut planes = Planes::new(&bodies, &[0.0, 0.3, 0.6]).unwrap();
    let path = std::env::temp_dir().join(format!("stickslip_{}.vti", std::process::id()));
    std::fs::write(&path, b"before").unwrap();
    let outcome = planes.write_vti_observed(&path, Body::One, &pressed, |seen| {
        if seen.double_precision_products > 20 {
            return ControlFlow::Break(());
        }
        ControlFlow::Continue(())
    });
    assert!(matches!(outcome, Err(Error::NotConverged(_))));
    assert_eq!(std::fs::read(&path).unwrap(), b"before");
    assert_stops_when_cancelled(|observer| {
        planes.write_vti_observed(&path, Body::One, &pressed, observer)?;
        Ok(std::fs::read(&path).unwrap())
    });
    std::fs::remove_file(&path).unwrap();
}
