//! Warnings of converged solutions that may mislead.

use stickslip::analytical::{CattaneoMindlin, HertzSphere};
use stickslip::history::{Cycle, Rolling};
use stickslip::layers::Layer;
use stickslip::subsurface::{Body, Planes, Tractions, at_points};
use stickslip::{
    Boundary, CoupledProblem, Coupling, ElasticPair, Error, Field, Grid, HalfSpace, History,
    LoadStep, Material, NormalLoad, NormalProblem, NormalSolution, Status, TangentialLoad,
    TangentialModel, TangentialProblem, TangentialSolution, Warning, Zone, surface,
};

fn press(grid: Grid, boundary: Boundary, gap: &Field) -> (HalfSpace, NormalSolution) {
    let bodies = HalfSpace::with_boundary(grid, kit::unit_pair(0.3), boundary).unwrap();
    let problem = NormalProblem::builder(&bodies, gap, NormalLoad::Force(2.0));
    let contact = kit::solve(problem);
    (bodies, contact)
}

fn across(contact: &NormalSolution) -> Option<[bool; 2]> {
    contact.warnings().iter().find_map(|warning| match warning {
        Warning::ContactSpansGrid { along_x, along_y } => Some([*along_x, *along_y]),
        _ => None,
    })
}

/// A cylinder that ends at the edge of the grid has pressure peaks at its ends. In this test they are three times the
/// pressure in the middle.
#[test]
fn cylinder_ending_with_grid_gives_warning() {
    let grid = Grid::new(32, 48, 0.25, 0.25).unwrap();
    let cylinder = surface::cylinder(grid, 20.0).unwrap();
    let (bodies, contact) = press(grid, Boundary::NonPeriodic, &cylinder);
    assert_eq!(across(&contact), Some([false, true]));
    let at = |iy: usize| contact.pressure().get(16, iy).unwrap();
    assert!(at(0) > 1.5 * at(24));
    let load = TangentialLoad::force([0.6, 0.0]);
    let shear = TangentialProblem::builder(&bodies, &contact, kit::coulomb(0.4), load);
    let shear = kit::solve(shear);
    assert_eq!(shear.warnings(), contact.warnings());
    let words = contact
        .warnings()
        .iter()
        .map(ToString::to_string)
        .collect::<String>();
    assert!(words.contains("across the whole grid along y"), "{words}");

    // A cylinder that ends before the grid, or that is infinitely long, gives no warning.
    let rising = Field::from_fn(grid, |x, y| {
        x * x / 40.0 + y * y / 2000.0 + (y.abs() - 4.0).max(0.0).powi(2)
    });
    assert_eq!(across(&press(grid, Boundary::NonPeriodic, &rising).1), None);
    assert_eq!(across(&press(grid, Boundary::Periodic, &cylinder).1), None);
    // A rough surface in contact at all edges of the grid touches in spots only.
    let rough = kit::rough(kit::square(48, 48.0), 3);
    let (_, contact) = press(rough.grid(), Boundary::NonPeriodic, &rough);
    assert_eq!(across(&contact), None);
}

#[test]
fn line_of_cells_gives_warning() {
    for [nx, ny] in [[40, 1], [1, 40]] {
        let grid = Grid::new(nx, ny, 0.25, 0.25).unwrap();
        let gap = Field::from_fn(grid, |x, y| (x * x + y * y) / 40.0);
        let (_, contact) = press(grid, Boundary::NonPeriodic, &gap);
        assert!(contact.warnings().contains(&Warning::SingleRowOfCells));
        let (_, contact) = press(grid, Boundary::Periodic, &gap);
        assert!(!contact.warnings().contains(&Warning::SingleRowOfCells));
    }
    let grid = kit::square(1, 1.0);
    let (_, contact) = press(grid, Boundary::NonPeriodic, &Field::zeros(grid));
    assert!(!contact.warnings().contains(&Warning::SingleRowOfCells));
}

/// Returns a ball that is pressed and then sheared by this fraction of the friction limit. The contact radius has the
/// given number of cells.
fn ball(cells_per_radius: usize, part: f64) -> (HertzSphere, NormalSolution, TangentialSolution) {
    let n = (14 * cells_per_radius).div_ceil(5) + 2;
    let grid = kit::square(n, n as f64 / cells_per_radius as f64);
    let pair = kit::unit_pair(0.3);
    let load = 4.0 / 3.0 * pair.contact_modulus() / 20.0;
    let bodies = HalfSpace::new(grid, pair).unwrap();
    let press = NormalProblem::builder(&bodies, kit::sphere(grid, 20.0), NormalLoad::Force(load));
    let normal = kit::solve(press);
    let drag = TangentialLoad::force([part * 0.5 * load, 0.0]);
    let shear = TangentialProblem::builder(&bodies, &normal, kit::coulomb(0.5), drag);
    let shear = kit::solve(shear);
    let hertz = HertzSphere::new(&pair, 20.0, load).unwrap();
    (hertz, normal, shear)
}

/// If the slip zone is narrower than two cells, the dissipated energy is unreliable and the warning states the width. If
/// it is wider, the energy is accurate.
#[test]
fn narrow_slip_ring_gives_warning() {
    for (cells, part, is_narrow) in [
        (12, 0.02, true),
        (16, 0.02, true),
        (10, 0.1, true),
        (6, 0.1, true),
        (16, 0.4, false),
        (10, 0.8, false),
    ] {
        let (hertz, _, shear) = ball(cells, part);
        let exact = CattaneoMindlin::new(hertz, 0.5, shear.force()[0]).unwrap();
        let energy = shear.dissipated_energy() / exact.energy_of_first_quarter();
        let width = (1.0 - exact.stick_radius()) * cells as f64;
        assert_eq!(width < 2.0, is_narrow);
        let found = shear
            .warnings()
            .into_iter()
            .find_map(|warning| match warning {
                Warning::UnderresolvedSlipZone { tenths } => Some((tenths, warning.to_string())),
                _ => None,
            });
        assert_eq!(found.is_some(), is_narrow, "{cells} {part}: {energy}");
        match found {
            Some((tenths, words)) => {
                let tenths = tenths as f64 / 10.0;
                assert!((tenths - width).abs() < 0.2, "{tenths} {width}");
                assert!(
                    words.contains(&format!("{tenths:.1} cells wide")),
                    "{words}"
                );
                assert!((energy - 1.0).abs() > 0.1, "{energy}");
            }
            None => assert!((energy - 1.0).abs() < 0.02, "{energy}"),
        }
    }
}

/// A step of a history has the same warning. A cycle has the warning if none of its steps had a wider slip zone.
#[test]
fn narrow_slip_ring_in_history_gives_warning() {
    let grid = kit::square(32, 2.8);
    let pair = kit::unit_pair(0.3);
    let load = 4.0 / 3.0 * pair.contact_modulus() / 20.0;
    let bodies = HalfSpace::new(grid, pair).unwrap();
    let mut history = History::builder(&bodies, kit::sphere(grid, 20.0), kit::coulomb(0.5))
        .build()
        .unwrap();
    let press = LoadStep::hold().normal(NormalLoad::Force(load));
    assert!(history.step(&press).unwrap().warnings().is_empty());
    let mut cycle = Cycle::new(&history);
    let is_narrow = |warnings: Vec<Warning>| {
        let mut found = warnings.iter();
        found.any(|warning| matches!(warning, Warning::UnderresolvedSlipZone { .. }))
    };
    for (part, narrow, narrow_so_far) in
        [(0.1, true, true), (0.7, false, false), (0.6, true, false)]
    {
        let drag = LoadStep::force([part * 0.5 * load, 0.0]);
        let step = history.step(&drag).unwrap().warnings();
        // Just after a reversal of the load, the new slip zone is narrower than a cell or does not exist yet.
        if part < 0.6 || !narrow {
            assert_eq!(is_narrow(step), narrow, "{part}");
        }
        cycle.add(&history).unwrap();
        assert_eq!(is_narrow(cycle.warnings()), narrow_so_far, "{part}");
    }
}

/// Contacts and stick zones of a few cells are inaccurate.
#[test]
fn contact_and_stick_zone_of_few_cells_give_warning() {
    let (_, normal, shear) = ball(3, 0.5);
    let coarse = Warning::UnderresolvedContact {
        cells: normal.contact_cells(),
    };
    assert!(normal.warnings().contains(&coarse) && shear.warnings().contains(&coarse));
    let (hertz, normal, shear) = ball(12, 0.98);
    assert!(normal.warnings().is_empty());
    let zones = shear.zones().iter();
    let cells = zones.filter(|zone| **zone == Zone::Stick).count();
    assert_eq!(
        shear.warnings(),
        [Warning::UnderresolvedStickZone { cells }]
    );
    let exact = CattaneoMindlin::new(hertz, 0.5, shear.force()[0]).unwrap();
    assert!(exact.stick_radius() * 12.0 < 4.0);
    let (_, normal, shear) = ball(12, 0.6);
    assert!(normal.warnings().is_empty() && shear.warnings().is_empty());
}

/// Pressing dissimilar bodies in a single step gives a smaller stick zone than gradual pressing, unless the contact does
/// not grow.
#[test]
fn pressing_dissimilar_bodies_in_one_step_gives_warning() {
    let grid = kit::square(24, 2.8);
    let unlike = kit::on_rigid(1.0, 0.0);
    let (ball, punch) = (
        kit::sphere(grid, 20.0),
        Field::from_fn(grid, |x, y| if x.hypot(y) < 1.0 { 0.0 } else { 9.0 }),
    );
    let solve = |pair: ElasticPair, gap: &Field, friction: f64| {
        let bodies = HalfSpace::new(grid, pair).unwrap();
        let press = NormalLoad::Force(0.06);
        let still = TangentialLoad::shift([0.0; 2]);
        let problem = CoupledProblem::builder(&bodies, gap, kit::coulomb(friction), press, still);
        kit::solve(problem)
    };
    let is_remarked = |pair, gap, friction| {
        let contact = solve(pair, gap, friction);
        contact.warnings().contains(&Warning::SingleLoadStep)
    };
    assert!(is_remarked(unlike, &ball, 0.3));
    assert!(!is_remarked(unlike, &punch, 0.3));
    assert!(!is_remarked(unlike, &ball, 0.0));
    assert!(!is_remarked(kit::unit_pair(0.3), &ball, 0.3));

    let bodies = HalfSpace::new(grid, unlike).unwrap();
    let builder = History::builder(&bodies, &ball, kit::coulomb(0.3));
    let mut history = builder.build().unwrap();
    for step in 1..=8 {
        let force = 0.06 * (f64::from(step) / 8.0).powi(3);
        let press = LoadStep::hold().normal(NormalLoad::Force(force));
        history.step(&press).unwrap();
    }
    // More than a tenth of the contact is new in each of these steps.
    let is_coarse = |history: &History| {
        let warnings = history.last_step().unwrap().warnings();
        warnings.contains(&Warning::SingleLoadStep)
    };
    assert!(is_coarse(&history));
    let at_once = solve(unlike, &ball, 0.3);
    assert!(
        at_once
            .tangential()
            .warnings()
            .contains(&Warning::SingleLoadStep)
    );
    let (few, many) = (
        at_once.tangential().stick_ratio(),
        history.last_step().unwrap().stick_ratio(),
    );
    assert!(few < 0.6 * many, "{few} {many}");

    // Steps that hold the load, short steps and adaptive steps do not have the warning.
    history.step(&LoadStep::hold()).unwrap();
    assert!(!is_coarse(&history));
    let press = |force: f64| LoadStep::hold().normal(NormalLoad::Force(force));
    history.step(&press(0.066)).unwrap();
    assert!(!is_coarse(&history));
    history.press(&press(0.1), 0.05).unwrap();
    assert!(!is_coarse(&history));
}

/// If dissimilar bodies come into contact in one step, histories and tangential problems have the same warning as
/// coupled problems, for any coupling. A cycle has the warning of its steps.
#[test]
fn pressing_dissimilar_history_in_one_step_gives_warning() {
    let grid = kit::square(20, 2.8);
    let unlike = kit::on_rigid(1.0, 0.0);
    let (ball, punch) = (
        kit::sphere(grid, 20.0),
        Field::from_fn(grid, |x, y| if x.hypot(y) < 1.0 { 0.0 } else { 9.0 }),
    );
    let press = |force| LoadStep::hold().normal(NormalLoad::Force(force));
    let is_remarked = |pair: ElasticPair, gap: &Field, coefficient: f64, coupling| {
        let bodies = HalfSpace::new(grid, pair).unwrap();
        let builder = History::builder(&bodies, gap, kit::coulomb(coefficient)).coupling(coupling);
        let mut history = builder.build().unwrap();
        let mut cycle = Cycle::new(&history);
        let step = history.step(&press(0.06)).unwrap().warnings();
        cycle.add(&history).unwrap();
        history.step(&press(0.05)).unwrap();
        cycle.add(&history).unwrap();
        let found = step.contains(&Warning::SingleLoadStep);
        assert_eq!(cycle.warnings().contains(&Warning::SingleLoadStep), found);
        found
    };
    for coupling in [Coupling::Full, Coupling::OneWay] {
        assert!(is_remarked(unlike, &ball, 0.3, coupling));
        assert!(!is_remarked(unlike, &punch, 0.3, coupling));
        assert!(!is_remarked(unlike, &ball, 0.0, coupling));
        assert!(!is_remarked(kit::unit_pair(0.3), &ball, 0.3, coupling));
    }
    assert!(!is_remarked(unlike, &ball, 0.3, Coupling::Neglected));

    let sheared = |pair: ElasticPair, coefficient: f64, coupling| {
        let bodies = HalfSpace::new(grid, pair).unwrap();
        let normal = NormalProblem::builder(&bodies, &ball, NormalLoad::Force(0.06));
        let normal = kit::solve(normal);
        let still = TangentialLoad::force([0.0; 2]);
        let problem =
            TangentialProblem::builder(&bodies, &normal, kit::coulomb(coefficient), still);
        let solution = kit::solve(problem.coupling(coupling));
        solution.warnings().contains(&Warning::SingleLoadStep)
    };
    assert!(sheared(unlike, 0.3, Coupling::OneWay));
    assert!(!sheared(unlike, 0.3, Coupling::Neglected));
    assert!(!sheared(unlike, 0.0, Coupling::OneWay));
    assert!(!sheared(kit::unit_pair(0.3), 0.3, Coupling::OneWay));
}

/// On the surface the tension at the edge of a sheared contact is smaller than in the closed form. The plane therefore
/// has a warning. At a depth of one cell side the tension is accurate.
#[test]
fn surface_stress_at_edge_gives_warning() {
    let (hertz, normal, shear) = ball(12, 0.5);
    let bodies = HalfSpace::new(normal.grid(), *hertz.pair()).unwrap();
    let dx = normal.grid().dx();
    let mut planes = Planes::new(&bodies, &[0.0, 0.9 * dx, dx]).unwrap();
    for (index, is_remarked) in [(0, true), (1, true), (2, false)] {
        let sheared = planes.solve(index, Body::One, (&normal, &shear)).unwrap();
        assert_eq!(
            sheared.warnings().contains(&Warning::StressAtEdge),
            is_remarked
        );
        let pressed = planes.solve(index, Body::One, &normal).unwrap();
        assert!(pressed.warnings().is_empty());
    }
}

/// Stresses of a solution that no solve has filled would be zero.
#[test]
fn stresses_of_solution_without_converged_solve_are_rejected_or_have_warning() {
    let (hertz, normal, shear) = ball(12, 0.5);
    let bodies = HalfSpace::new(normal.grid(), *hertz.pair()).unwrap();
    let gap = kit::sphere(normal.grid(), 20.0);
    let load = NormalLoad::Force(normal.force());
    let problem = NormalProblem::builder(&bodies, &gap, load).max_iterations(1);
    let mut solver = problem.build().unwrap().into_solver().unwrap();
    let mut pressed = solver.new_solution();
    let mut planes = Planes::new(&bodies, &[0.1]).unwrap();
    let is_unsolved = |outcome: Result<(), Error>| match outcome {
        Err(Error::NotConverged(report)) => report.status == Status::Unsolved,
        _ => false,
    };
    let points = at_points(&bodies, Body::One, &pressed, &[[0.0; 3]]);
    assert!(is_unsolved(points.map(|_| ())));
    assert!(is_unsolved(
        planes.solve(0, Body::One, &pressed).map(|_| ())
    ));
    let pair = (&pressed, &shear);
    assert!(is_unsolved(planes.solve(0, Body::One, pair).map(|_| ())));
    let drag = TangentialLoad::force([0.0; 2]);
    let sheared = TangentialProblem::builder(&bodies, &normal, kit::coulomb(0.5), drag);
    let sheared = sheared
        .build()
        .unwrap()
        .into_solver()
        .unwrap()
        .new_solution();
    assert!(solver.solve_into(&mut pressed).is_err());
    let plane = planes.solve(0, Body::One, &pressed).unwrap();
    assert_eq!(plane.warnings(), [Warning::NotConverged]);
    for one in [&normal, &pressed] {
        let pair = (one, &sheared);
        assert!(is_unsolved(planes.solve(0, Body::One, pair).map(|_| ())));
    }
    let (mut plane, loads) = (plane, Tractions::new(pressed.pressure()));
    planes.solve_into(0, Body::One, loads, &mut plane).unwrap();
    assert!(plane.warnings().is_empty());
    // A history before its first step has no load.
    let history = History::builder(&bodies, &gap, kit::coulomb(0.3))
        .build()
        .unwrap();
    let plane = planes.solve(0, Body::One, &history).unwrap();
    assert!(plane.normal_stress()[2].max() == 0.0);
}

/// The slip zone of a rolling step is narrower than one cell. The energy from the tractions at the end of the step is
/// then half of the work.
#[test]
fn narrow_slip_of_rolling_step_is_below_one_cell() {
    let grid = kit::square(20, 2.6);
    let pair = kit::unit_pair(0.3);
    let bodies = HalfSpace::new(grid, pair).unwrap();
    let load = 4.0 / 3.0 * pair.contact_modulus() / 20.0;
    for (part, is_narrow) in [(0.1, true), (0.6, false), (0.9, false)] {
        let builder = History::builder(&bodies, kit::sphere(grid, 20.0), kit::coulomb(0.5));
        let mut history = builder.model(TangentialModel::Vector).build().unwrap();
        let press = LoadStep::hold().normal(NormalLoad::Force(load));
        history.step(&press).unwrap();
        let force = LoadStep::force([part * 0.5 * load, 0.0]);
        let rolled = force.roll(Rolling::new(1));
        for _ in 0..24 {
            history.step(&rolled).unwrap();
        }
        let step = history.step(&rolled).unwrap();
        let mut warnings = step.warnings().into_iter();
        let found =
            warnings.any(|warning| matches!(warning, Warning::UnderresolvedSlipZone { .. }));
        assert_eq!(found, is_narrow, "{part}");
        let energy = step.energy();
        let deficit = 1.0 - energy.dissipated_energy / energy.work;
        assert_eq!(deficit > 0.4, is_narrow, "{part}: {deficit}");
    }
}

/// A layer whose thickness has a wrong unit has a warning. The solution is then the limit without the body below the layer, or
/// without the layer.
#[test]
fn layer_far_from_the_scale_of_the_grid_has_a_warning() {
    let grid = kit::square(32, 3.0);
    let ball = kit::sphere(grid, 1.0);
    let steel = Material::new(2.0, 0.3).unwrap();
    let found = |material: Material| {
        let pair = ElasticPair::new(material, Material::rigid()).unwrap();
        let bodies = HalfSpace::new(grid, pair).unwrap();
        let contact = kit::press(&bodies, &ball, NormalLoad::Force(0.3), 1e-8);
        let warnings = contact.warnings().into_iter();
        let of_coating = warnings.filter(|warning| {
            matches!(
                warning,
                Warning::CoatingBeyondGrid { .. } | Warning::CoatingBelowCell { .. }
            )
        });
        (of_coating.collect::<Vec<_>>(), contact.approach())
    };
    let coated = |body: Material, modulus: f64, thickness: f64| {
        let layer = Layer::new(modulus, 0.3, thickness).unwrap();
        found(body.coated(&[layer]).unwrap())
    };
    let (none, substrate) = found(steel);
    let (_, coating) = found(Material::new(0.5, 0.3).unwrap());
    assert!(none.is_empty());
    for thickness in [3e-4, 0.01, 1.0, 29.0] {
        assert!(coated(steel, 0.5, thickness).0.is_empty(), "{thickness}");
    }
    let (thick, approach) = coated(steel, 0.5, 3e3);
    assert_eq!(thick, [Warning::CoatingBeyondGrid { sides: 1000 }]);
    assert!((approach / coating - 1.0).abs() < 2e-3);
    let (thick, approach) = coated(steel, 0.5, 37.0);
    assert_eq!(thick, [Warning::CoatingBeyondGrid { sides: 12 }]);
    assert!((approach / coating - 1.0).abs() < 5e-2);
    let cell = 3.0 / 32.0;
    let (thin, approach) = coated(steel, 0.5, 1e-6 * cell);
    assert_eq!(thin, [Warning::CoatingBelowCell { parts: 1_000_000 }]);
    assert!((approach / substrate - 1.0).abs() < 1e-4);
    // The contrast of the shear moduli is four.
    for (part, is_warned) in [(0.24e-2, true), (0.26e-2, false)] {
        let (thin, approach) = coated(steel, 0.5, part * cell);
        assert_eq!(thin.len(), usize::from(is_warned));
        assert!((approach / substrate - 1.0).abs() < 3e-3, "{approach}");
    }
    // A thin layer that is much stiffer than the body can have an effect, and so has a layer on a rigid base.
    assert!(coated(steel, 2e3, 1e-6 * cell * 101.0).0.is_empty());
    assert!(coated(Material::rigid(), 0.5, 1e-6).0.is_empty());
}

/// Returns the widths of slip zones in these warnings, in tenths of a cell.
fn slip_widths(warnings: &[Warning]) -> Vec<usize> {
    let width = |warning: &Warning| match warning {
        Warning::UnderresolvedSlipZone { tenths } => Some(*tenths),
        _ => None,
    };
    warnings.iter().filter_map(width).collect()
}

/// A small force on a ball causes a slip ring inside the outermost cells. No cell slips, and the solution has a warning.
#[test]
fn hidden_slip_ring_gives_warning() {
    for cells in [6, 10, 16, 24] {
        for part in [1e-5, 1e-3] {
            let (_, _, shear) = ball(cells, part);
            assert_eq!(shear.stick_ratio(), 1.0);
            assert_eq!(shear.dissipated_energy(), 0.0);
            assert_eq!(slip_widths(&shear.warnings()), [0], "{cells} {part}");
        }
        let (_, _, shear) = ball(cells, 0.0);
        assert!(slip_widths(&shear.warnings()).is_empty());
    }
}

/// Steps that change the tractions have the warning too. Steps that hold or press do not.
#[test]
fn hidden_slip_ring_in_history_gives_warning() {
    let grid = kit::square(32, 2.8);
    let pair = kit::unit_pair(0.3);
    let load = 4.0 / 3.0 * pair.contact_modulus() / 20.0;
    let bodies = HalfSpace::new(grid, pair).unwrap();
    let gap = kit::sphere(grid, 20.0);
    for model in [TangentialModel::Scalar, TangentialModel::Vector] {
        let builder = History::builder(&bodies, &gap, kit::coulomb(0.5));
        let mut history = builder.model(model).build().unwrap();
        let press = LoadStep::hold().normal(NormalLoad::Force(load));
        let drag = |part: f64| LoadStep::force([part * 0.5 * load, 0.0]);
        let mut cycle = Cycle::new(&history);
        for (step, widths) in [
            (press, &[][..]),
            (drag(1e-3), &[0]),
            (drag(1e-3), &[]),
            (drag(1e-3).normal(NormalLoad::Force(1.1 * load)), &[]),
            (drag(-1e-3), &[0]),
            (drag(0.7), &[]),
            (drag(0.699), &[0]),
        ] {
            let result = history.step(&step).unwrap();
            assert_eq!(
                slip_widths(&result.warnings()),
                widths,
                "{model:?} {step:?}"
            );
            cycle.add(&history).unwrap();
        }
        assert!(slip_widths(&cycle.warnings()).is_empty());
    }
}

/// Dissimilar bodies that are pressed together have the warning for either coupling. A step that holds the load does not.
#[test]
fn hidden_slip_ring_of_dissimilar_bodies_gives_warning() {
    let grid = kit::square(32, 2.8);
    let aluminium = Material::new(0.64, 0.33).unwrap();
    let steel = Material::new(1.92, 0.3).unwrap();
    let pair = ElasticPair::new(aluminium, steel).unwrap();
    let load = 4.0 / 3.0 * pair.contact_modulus() / 20.0;
    let bodies = HalfSpace::new(grid, pair).unwrap();
    for coupling in [Coupling::OneWay, Coupling::Full] {
        let builder = History::builder(&bodies, kit::sphere(grid, 20.0), kit::coulomb(0.35));
        let builder = builder.model(TangentialModel::Vector).coupling(coupling);
        let mut history = builder.build().unwrap();
        let press = LoadStep::hold().normal(NormalLoad::Force(load));
        history.press(&press, 0.02).unwrap();
        for (step, widths) in [
            (None, &[0][..]),
            (Some(LoadStep::hold()), &[]),
            (Some(LoadStep::force([1e-3 * load, 0.0])), &[0]),
        ] {
            if let Some(step) = step {
                history.step(&step).unwrap();
            }
            let result = history.last_step().unwrap();
            assert_eq!(result.stick_ratio(), 1.0);
            assert_eq!(
                slip_widths(&result.warnings()),
                widths,
                "{coupling:?} {step:?}"
            );
        }
    }
}

/// A cycle has the warning until one of its steps has a wide slip zone. The slip zone of a sliding contact is wide.
#[test]
fn hidden_slip_ring_in_cycle_gives_warning_until_contact_slides() {
    let grid = kit::square(32, 2.8);
    let pair = kit::unit_pair(0.3);
    let load = 4.0 / 3.0 * pair.contact_modulus() / 20.0;
    let bodies = HalfSpace::new(grid, pair).unwrap();
    let builder = History::builder(&bodies, kit::sphere(grid, 20.0), kit::coulomb(0.5));
    let mut history = builder.build().unwrap();
    let mut cycle = Cycle::new(&history);
    let press = LoadStep::hold().normal(NormalLoad::Force(load));
    let drag = LoadStep::force([1e-3 * 0.5 * load, 0.0]);
    let slide = LoadStep::shift([1.0, 0.0]);
    for (step, widths) in [(press, &[][..]), (drag, &[0]), (slide, &[])] {
        history.step(&step).unwrap();
        cycle.add(&history).unwrap();
        assert_eq!(slip_widths(&cycle.warnings()), widths, "{step:?}");
    }
}

/// The pressure of a flat punch does not fall to zero at its edge, so that a small force causes no slip.
#[test]
fn stuck_contact_without_slip_ring_gives_no_warning() {
    let grid = kit::square(32, 2.8);
    let bodies = HalfSpace::new(grid, kit::unit_pair(0.3)).unwrap();
    let inside = |x: f64, y: f64| x.hypot(y) < 1.0;
    let flat = Field::from_fn(grid, |x, y| if inside(x, y) { 0.0 } else { 1.0 });
    let punch = NormalProblem::builder(&bodies, flat, NormalLoad::Force(1e-3));
    let punch = kit::solve(punch).pressure().clone();
    let uniform = Field::from_fn(grid, |x, y| f64::from(u8::from(inside(x, y))));
    for pressure in [punch, uniform] {
        let force = TangentialLoad::force([0.01 * pressure.integral(), 0.0]);
        let shear = TangentialProblem::builder(&bodies, &pressure, kit::coulomb(0.5), force);
        let shear = kit::solve(shear);
        assert_eq!(shear.stick_ratio(), 1.0);
        assert!(slip_widths(&shear.warnings()).is_empty());
    }
    // Bodies that must stick everywhere have a large coefficient of friction.
    let (_, normal, _) = ball(10, 0.1);
    let bodies = HalfSpace::new(normal.grid(), kit::unit_pair(0.3)).unwrap();
    let force = TangentialLoad::force([0.001 * normal.force(), 0.0]);
    let stuck = TangentialProblem::builder(&bodies, &normal, kit::coulomb(6.0), force);
    assert!(slip_widths(&kit::solve(stuck).warnings()).is_empty());
}
