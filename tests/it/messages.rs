//! Messages of errors and warnings name the subject, the value and a remedy that applies to the subject.

use std::sync::Arc;
use std::time::Duration;

use kit::first_of;
use stickslip::analytical::{CattaneoMindlin, HertzSphere};
use stickslip::history::{AdaptiveSteps, Cycle, Rolling};
use stickslip::influence::Direction::Z;
use stickslip::kernel::Operators;
use stickslip::normal::Hardness;
use stickslip::ranks::Threads;
use stickslip::rolling::{
    CoupledRollingProblem, EntryRule, RollingControl, RollingProblem, SpinControl,
};
use stickslip::subsurface::Planes;
use stickslip::surface::SelfAffine;
use stickslip::tangential::RelativeDisplacement;
use stickslip::{
    Axis, Boundary, CoupledProblem, ElasticPair, Error, Field, Friction, Grid, HalfSpace, History,
    Kernel, LoadStep, Material, NormalLoad, NormalProblem, NormalSolution, Operator, Result,
    Scratch, TangentialControl, TangentialLoad, TangentialModel, TangentialProblem, Warning,
    surface,
};

/// Radius of the ball on a grid of side 2.8. The contact radius is 1 under [`load`].
const RADIUS: f64 = 20.0;

fn bodies(cells: usize) -> HalfSpace {
    let grid = Grid::square(cells, 2.8).unwrap();
    HalfSpace::new(grid, kit::unit_pair(0.3)).unwrap()
}

fn load() -> f64 {
    4.0 / 3.0 * kit::unit_pair(0.3).contact_modulus() / RADIUS
}

fn ball(bodies: &HalfSpace) -> Field {
    surface::sphere(bodies.grid(), RADIUS).unwrap()
}

fn friction() -> Friction {
    Friction::coulomb(0.5).unwrap()
}

fn pressed(bodies: &HalfSpace, gap: &Field, force: f64) -> NormalSolution {
    let problem = NormalProblem::builder(bodies, gap, NormalLoad::Force(force));
    kit::solve(problem)
}

fn history(bodies: &HalfSpace) -> History {
    History::builder(bodies, ball(bodies), friction())
        .build()
        .unwrap()
}

fn press(part: f64) -> LoadStep {
    LoadStep::hold().normal(NormalLoad::Force(part * load()))
}

fn message<T>(outcome: Result<T>) -> String {
    match outcome {
        Ok(_) => panic!("no error was returned"),
        Err(error) => error.to_string(),
    }
}

#[test]
fn force_beyond_friction_names_remedy_for_its_subject() {
    let bodies = bodies(12);
    let normal = pressed(&bodies, &ball(&bodies), load());
    let too_much = load();
    let slide = "prescribe a shift or a spring to let the body slide";
    let roll = "prescribe the creepage, or lower the force";

    let still = TangentialProblem::builder(
        &bodies,
        &normal,
        friction(),
        TangentialLoad::force([too_much, 0.0]),
    );
    let text = message(still.build());
    let numbers = format!("the tangential force {too_much:?} exceeds the friction limit ");
    assert!(
        text.starts_with(&numbers) && text.ends_with(slide),
        "{text}"
    );

    let rolling = || RollingProblem::builder(&bodies, &normal, friction());
    let control = [
        RollingControl::Force(too_much),
        RollingControl::Creepage(0.0),
    ];
    let text = message(rolling().control(Axis::X, control[0]).build());
    assert!(text.starts_with(&numbers) && text.ends_with(roll), "{text}");
    let mut solver = kit::solver(rolling());
    let text = message(solver.set_load(control, SpinControl::Spin(0.0)));
    assert!(text.ends_with(roll), "{text}");

    let mut history = history(&bodies);
    history.step(&press(1.0)).unwrap();
    let drag = LoadStep::force([too_much, 0.0]);
    let text = message(history.step(&drag));
    assert!(text.ends_with(slide), "{text}");
    let text = message(history.step(&drag.roll(Rolling::new(1))));
    assert!(text.ends_with(roll), "{text}");

    // A cap in the wrong unit is a likely cause of a small limit.
    let capped = || friction().max_shear_stress(1e-9).unwrap();
    let unit = "check the unit of the largest shear stress, or ";
    let cause = TangentialLoad::force([too_much, 0.0]);
    let text = message(TangentialProblem::builder(&bodies, &normal, capped(), cause).build());
    assert!(text.ends_with(&format!("{unit}{slide}")), "{text}");
    let capped = RollingProblem::builder(&bodies, &normal, capped());
    let text = message(capped.control(Axis::X, control[0]).build());
    assert!(text.ends_with(&format!("{unit}{roll}")), "{text}");

    let hertz = HertzSphere::new(bodies.pair(), RADIUS, load()).unwrap();
    let text = message(CattaneoMindlin::new(hertz, 0.5, too_much));
    assert!(
        text.ends_with("lower the force, or raise the friction or the load"),
        "{text}"
    );
    let none = Friction::coulomb(0.0).unwrap();
    let load = TangentialLoad::force([too_much, 0.0]);
    let text = message(TangentialProblem::builder(&bodies, &normal, none, load).build());
    assert!(
        text.ends_with("exceeds the friction limit 0.0: give a positive coefficient of friction"),
        "{text}"
    );
}

/// Covers contacts in which no cell carries pressure. They were never pressed, were pressed by a zero force, or were
/// pressed and then separated. One contact has dissimilar bodies.
#[test]
fn force_on_empty_contact_reports_empty_contact() {
    let bodies = bodies(12);
    let drag = LoadStep::force([0.01, 0.0]);
    let is_empty = |history: &mut History, load: &LoadStep| {
        assert_eq!(history.step(load).unwrap_err(), Error::EmptyContact);
    };
    let mut never = history(&bodies);
    is_empty(&mut never, &drag);
    is_empty(&mut never, &drag.normal(NormalLoad::Force(0.0)));
    let mut separated = history(&bodies);
    separated.step(&press(1.0)).unwrap();
    separated.step(&press(0.0)).unwrap();
    is_empty(&mut separated, &drag);
    let mut pulled = history(&bodies);
    pulled.step(&press(1.0)).unwrap();
    is_empty(&mut pulled, &drag.normal(NormalLoad::Force(0.0)));

    let rubber = ElasticPair::new(Material::new(1.0, 0.3).unwrap(), Material::rigid()).unwrap();
    let dissimilar = HalfSpace::new(bodies.grid(), rubber).unwrap();
    let mut coupled = history(&dissimilar);
    is_empty(&mut coupled, &drag);
    let load = TangentialLoad::force([0.01, 0.0]);
    let press = NormalLoad::Force(0.0);
    let problem =
        CoupledProblem::builder(&dissimilar, ball(&dissimilar), friction(), press, load).build();
    kit::assert_refused! { problem.and_then(|problem| problem.solve()) => Error::EmptyContact }
}

#[test]
fn unsupported_load_names_its_model() {
    let bodies = bodies(12);
    let normal = pressed(&bodies, &ball(&bodies), load());
    let turn = TangentialLoad::force([0.0; 2]).twist(0.25);
    let text = message(TangentialProblem::builder(&bodies, &normal, friction(), turn).build());
    assert_eq!(
        text,
        "the model of this contact does not support twist, got 0.25: use the vector model"
    );

    let mut history = history(&bodies);
    history.step(&press(1.0)).unwrap();
    let text = message(history.step(&LoadStep::hold().relative_displacement(2.0)));
    assert!(
        text.starts_with(
            "the model of this history does not support a relative displacement, got 2.0: "
        ),
        "{text}"
    );
    let one = Rolling::new(1);
    let text = message(history.step(&LoadStep::hold().twist(0.5).roll(one)));
    assert_eq!(
        text,
        "the model of rolling does not support a twist, got 0.5: prescribe the spin of the rolling step instead"
    );
    let mut adaptive = AdaptiveSteps::new(&history, 1e-3).unwrap();
    let text = message(adaptive.step(&mut history, &press(1.0).roll(one)));
    assert_eq!(
        text,
        "the method of adaptive steps does not support rolling steps (value: the number of cells of the step), got 1.0: take rolling steps one cell at a time"
    );

    let grid = Grid::square(16, 1.0).unwrap();
    let waves = HalfSpace::with_boundary(grid, kit::unit_pair(0.3), Boundary::Periodic).unwrap();
    let gap = surface::bisinusoidal(grid, 0.01, [1.0, 1.0]).unwrap();
    let pressed = pressed(&waves, &gap, 1e-3);
    let text = message(RollingProblem::builder(&waves, &pressed, friction()).build());
    assert_eq!(
        text,
        "the model of rolling does not support a step along a periodic axis (value: the length of the step), got 0.0625: roll along the other axis, or use a grid that is not periodic"
    );
}

/// Operator of bodies whose first displacement violates reciprocity.
struct SkewOperator {
    of: stickslip::ElasticOperator<1>,
    factor: f64,
}

impl Operator for SkewOperator {
    fn cells(&self) -> usize {
        self.of.cells()
    }

    fn scratch(&self) -> Result<Scratch> {
        self.of.scratch()
    }

    fn apply(&self, x: [&[f64]; 1], [out]: [&mut [f64]; 1], scratch: &mut Scratch) {
        self.of.apply(x, [&mut *out], scratch);
        out[0] *= self.factor;
    }

    fn lower_bound(&self) -> f64 {
        self.of.lower_bound()
    }
}

#[test]
fn errors_of_operators_name_operators() {
    let bodies = bodies(12);
    let skew = |factor| {
        let of = bodies
            .operator(stickslip::influence::Component::ZZ)
            .unwrap();
        Operators::new().with([Z], SkewOperator { of, factor })
    };
    let text = message(Kernel::operators(*bodies.pair(), skew(2.0)));
    assert!(
        text.starts_with("a kernel of user-defined operators does not support a violation of reciprocity (difference of the mutual works relative to the energies), got 0.")
            && text.ends_with(": give an operator with a difference of at most 1e-9, such as the mean of a matrix and its transpose"),
        "{text}"
    );
    let kernel = Kernel::operators(*bodies.pair(), skew(1.0)).unwrap();
    let of_operators = HalfSpace::new(bodies.grid(), &kernel).unwrap();
    let normal = pressed(&of_operators, &ball(&of_operators), load());
    let remedy = ": describe the bodies by materials, layers or a response to waves, which are defined beyond the cells of one grid";
    for (text, quantity) in [
        (
            message(RollingProblem::builder(&of_operators, &normal, friction()).build()),
            "rolling",
        ),
        (
            message(Planes::new(&of_operators, &[0.1])),
            "the stress below the surface",
        ),
    ] {
        let expected = format!("{quantity} is not available for user-defined operators{remedy}");
        assert_eq!(text, expected);
    }
    let grid = bodies.grid();
    let refusals = Threads::run(2, Duration::from_secs(60), |rank| {
        HalfSpace::distributed(grid, &kernel, Boundary::NonPeriodic, Arc::new(rank)).map(|_| ())
    });
    let of_itself =
        |refused: &Result<()>| matches!(refused, Err(Error::UnsupportedForCoatings { .. }));
    let text = message(refusals.into_iter().find(of_itself).unwrap());
    assert!(
        text.starts_with(
            "a grid that is distributed over ranks is not available for user-defined operators: "
        ),
        "{text}"
    );

    let layer = stickslip::layers::Layer::new(2.0, 0.3, 0.1).unwrap();
    let coated = Material::new(1.0, 0.3).unwrap().coated(&[layer]).unwrap();
    let pair = ElasticPair::new(coated, Material::rigid()).unwrap();
    let text = message(HertzSphere::new(&pair, 1.0, 1.0));
    assert_eq!(
        text,
        "a closed form with one modulus is not available for coated bodies: solve the contact on a grid"
    );
}

#[test]
fn rolling_off_grid_names_cells_to_add() {
    let bodies = bodies(12);
    let flat = pressed(&bodies, &Field::zeros(bodies.grid()), 0.1);
    let outcome = RollingProblem::builder(&bodies, &flat, friction())
        .step(3)
        .build();
    let Err(error) = outcome else {
        panic!("no room was needed")
    };
    assert!(matches!(
        error,
        Error::GridTooShort {
            side: "ahead of",
            needed: 3,
            found: 0
        }
    ));
    assert_eq!(
        error.to_string(),
        "a rolling step requires 3 cells ahead of the contact, but the grid has 0: extend the grid there by at least 3 cells"
    );
    let mut history = history(&bodies);
    history.step(&press(1.0)).unwrap();
    let text = message(history.step(&press(1.0).roll(Rolling::new(5))));
    assert!(
        text.contains("a rolling step requires 5 cells behind the contact")
            && text.contains(": extend the grid there by at least "),
        "{text}"
    );
}

#[test]
fn numbers_in_messages_are_plain() {
    let grid = Grid::square(16, 1.0).unwrap();
    let filter = surface::GaussianFilter::s(0.1);
    let text = message(filter.apply(&Field::zeros(grid)));
    assert_eq!(
        text,
        "nesting index of the S filter must be at least 0.125 (two cells), got 0.1"
    );
    for (error, text) in [
        (
            Error::BelowMinimum {
                quantity: "kurtosis",
                value: 0.5,
                least_is: "the squared skewness plus one",
                least: 1.0,
            },
            "kurtosis must be at least 1.0 (the squared skewness plus one), got 0.5",
        ),
        (
            Error::NotPositive {
                quantity: "side",
                value: 0.0,
            },
            "side must be positive and finite, got 0.0",
        ),
    ] {
        assert_eq!(error.to_string(), text);
    }
}

#[test]
fn memory_is_in_units_of_1024() {
    for (bytes, size) in [
        (3_000, "0.002861 MiB"),
        (1 << 20, "1.000 MiB"),
        (700 << 20, "700.0 MiB"),
        (1 << 30, "1.000 GiB"),
        (128_000_000_000, "119.2 GiB"),
    ] {
        let error = Error::Memory {
            quantity: "a padded grid",
            bytes,
        };
        let expected = format!("cannot allocate {size} for a padded grid");
        assert_eq!(error.to_string(), expected);
    }
}

fn texts(warnings: &[Warning]) -> Vec<String> {
    warnings.iter().map(ToString::to_string).collect()
}

#[test]
fn contact_without_force_reports_zero_force() {
    let bodies = bodies(12);
    let apart = pressed(&bodies, &ball(&bodies), 0.0);
    assert_eq!(
        texts(&apart.warnings()),
        [
            "no cell carries pressure because the normal force is zero or nothing has been solved yet: prescribe a positive normal force, or an approach above the smallest gap, and solve"
        ]
    );
}

/// A rough surface always has some small spots. The warning is issued only if they make up a tenth of the contact.
#[test]
fn small_spots_of_rough_surface_are_judged_together() {
    let press = |cells: usize, cut_off: f64| {
        let grid = Grid::square(cells, 1.0).unwrap();
        let rough = SelfAffine::with_rms_slope(0.1)
            .longest_wavelength(0.5)
            .roll_off_wavelength(0.5)
            .cut_off_wavelength(cut_off)
            .seed(3)
            .generate(grid)
            .unwrap();
        let gap = surface::gap_from_heights(rough.heights()).unwrap();
        let bodies =
            HalfSpace::with_boundary(grid, kit::unit_pair(0.3), Boundary::Periodic).unwrap();
        pressed(&bodies, &gap, 0.004)
    };
    let coarse = press(64, 2.0 / 64.0);
    let share = |contact: &NormalSolution| {
        let spots = contact.spots().unwrap();
        let small = || spots.as_slice().iter().filter(|spot| spot.cells < 5);
        let cells: usize = small().map(|spot| spot.cells).sum();
        (
            small().count(),
            cells as f64 / contact.contact_cells() as f64,
        )
    };
    let (unresolved, part) = share(&coarse);
    assert!(part > 0.1, "{part}");
    let spots = coarse.spots().unwrap().as_slice().iter().count();
    let text = texts(&coarse.warnings()).join("\n");
    let expected = format!(
        "contact spots of fewer than 5 cells ({unresolved} of {spots} spots) contain at least a tenth of the contact cells: refine the grid, or filter out the short waves of the surface"
    );
    assert!(text.contains(&expected), "{text}");
    let expected =
        format!("the estimated discretisation error of the fields of {spots} contact spots is ");
    assert!(
        text.contains(&expected)
            && text.contains(" %: for an error of 1 %, resample the surface onto cells "),
        "{text}"
    );

    let fine = press(128, 16.0 / 128.0);
    let (unresolved, part) = share(&fine);
    assert!(part < 0.1, "{unresolved} {part}");
    let is_unresolved = |warning: &Warning| matches!(warning, Warning::UnresolvedSpots { .. });
    assert!(!fine.warnings().iter().any(is_unresolved));
}

/// A slip zone of two cells does not fit into spots of three cells. The warning would name a remedy that does not apply
/// to these spots.
#[test]
fn narrow_slip_in_small_spots_gives_no_warning() {
    let grid = Grid::square(64, 64.0).unwrap();
    // The gap describes four balls of a periodic array.
    let wave = |x: f64| (std::f64::consts::TAU * x / 32.0).cos();
    let gap = Field::from_fn(grid, |x, y| 0.4 * (2.0 - wave(x) - wave(y)));
    let bodies = HalfSpace::with_boundary(grid, kit::unit_pair(0.3), Boundary::Periodic).unwrap();
    let is_narrow = |warning: &Warning| matches!(warning, Warning::UnderresolvedSlipZone { .. });
    for (force, part, radius, is_remarked) in [(2.2, 0.35, 3.0, false), (45.0, 0.15, 9.0, true)] {
        let mut history = History::builder(&bodies, &gap, friction()).build().unwrap();
        let press = LoadStep::hold().normal(NormalLoad::Force(force));
        history.step(&press).unwrap();
        let drag = LoadStep::force([part * force, 0.0]);
        let ratio = history.step(&drag).unwrap().stick_ratio();
        let area = history.normal().contact_area() / 4.0;
        let found = (area / std::f64::consts::PI).sqrt();
        assert_eq!(history.spots().unwrap().as_slice().len(), 4);
        assert!((found / radius - 1.0).abs() < 0.1, "{found} {radius}");
        assert!(ratio > 0.0 && ratio < 1.0 && found * (1.0 - ratio.sqrt()) < 2.0);
        assert_eq!(step_warns(&history, is_narrow), is_remarked, "{found}");
    }
}

fn step_warns(history: &History, is_meant: impl Fn(&Warning) -> bool) -> bool {
    history.last_step().unwrap().warnings().iter().any(is_meant)
}

/// Returns the warnings of a point of a creep curve.
fn point_warnings(problem: RollingProblem) -> Vec<Warning> {
    let mut solver = problem.into_solver().unwrap();
    let points = solver.creep_forces([[1e-3, 0.0, 0.0]]).unwrap();
    points[0].warnings()
}

/// Returns the ratio of contact radius to radius of curvature that a warning states.
fn stated_radius(warnings: &[Warning]) -> Option<f64> {
    warnings.iter().find_map(|warning| match warning {
        Warning::LargeContactRadius { per_mille } => Some(1e-3 * *per_mille as f64),
        _ => None,
    })
}

#[test]
fn contact_radius_above_a_third_of_curvature_gives_warning() {
    let pair = kit::unit_pair(0.3);
    for (ratio, is_large) in [(0.1, false), (0.25, false), (0.35, true), (0.8, true)] {
        let radius = 1.0 / ratio;
        let grid = Grid::square(30, 2.8).unwrap();
        let force = 4.0 / 3.0 * pair.contact_modulus() / radius;
        let bodies = HalfSpace::new(grid, pair).unwrap();
        // The position on the grid does not matter.
        let gap = Field::from_fn(grid, |x, y| {
            ((x - 0.2).powi(2) + (y + 0.1).powi(2)) / (2.0 * radius)
        });
        let contact = pressed(&bodies, &gap, force);
        let found = stated_radius(&contact.warnings());
        assert_eq!(found.is_some(), is_large, "{ratio} {found:?}");
        if let Some(found) = found {
            assert!((found / ratio - 1.0).abs() < 0.1, "{found} {ratio}");
            let text = format!(
                "the contact radius is about {found:.2} of the radius of curvature, expected at most 0.3: "
            );
            let all = texts(&contact.warnings()).join("\n");
            assert!(
                all.contains(&text) && all.contains("units of gap and grid"),
                "{all}"
            );
        }
        let mut history = History::builder(&bodies, &gap, friction()).build().unwrap();
        let press = LoadStep::hold().normal(NormalLoad::Force(force));
        let mut cycle = Cycle::new(&history);
        assert_eq!(
            stated_radius(&history.step(&press).unwrap().warnings()),
            found
        );
        cycle.add(&history).unwrap();
        assert_eq!(stated_radius(&cycle.warnings()), found);
        // A step that holds the pressure and a restored history report the same value.
        assert_eq!(
            stated_radius(&history.step(&LoadStep::hold()).unwrap().warnings()),
            found
        );
        let restored = History::from_bytes(&bodies, &history.to_bytes()).unwrap();
        assert_eq!(stated_radius(&restored.normal().warnings()), found);
    }
    // A punch has steps at its edge and no curvature within the contact. A hollow has a negative curvature.
    let bodies = bodies(24);
    let punch = Field::from_fn(
        bodies.grid(),
        |x, y| if x.hypot(y) < 1.0 { 0.0 } else { 9.0 },
    );
    let wave = Field::from_fn(
        bodies.grid(),
        |x, y| if x.hypot(y) < 1.0 { -x * x } else { 9.0 },
    );
    for gap in [punch, wave] {
        let contact = pressed(&bodies, &gap, 0.5);
        assert_eq!(stated_radius(&contact.warnings()), None);
    }
    // The next case is a cylinder on a line of cells.
    let line = Grid::line(60, 2.8 / 60.0).unwrap();
    let boundary = Boundary::PeriodicAlongY { datum: 20.0 };
    let bodies = HalfSpace::with_boundary(line, pair, boundary).unwrap();
    let gap = Field::from_fn(line, |x, _| x * x / 4.0);
    let force = std::f64::consts::PI / 4.0 * pair.contact_modulus() / 2.0 * line.dy();
    let contact = pressed(&bodies, &gap, force);
    let found = stated_radius(&contact.warnings()).unwrap();
    assert!((found / 0.5 - 1.0).abs() < 0.1, "{found}");
}

#[test]
fn steep_surface_in_contact_gives_warning() {
    let grid = Grid::square(64, 1.0).unwrap();
    let bodies = HalfSpace::with_boundary(grid, kit::unit_pair(0.3), Boundary::Periodic).unwrap();
    let slope = |rms: f64| {
        let rough = SelfAffine::with_rms_slope(rms)
            .cut_off_wavelength(8.0 / 64.0)
            .seed(5)
            .generate(grid)
            .unwrap();
        let gap = surface::gap_from_heights(rough.heights()).unwrap();
        let contact = pressed(&bodies, &gap, 0.3 * rms);
        assert!(contact.contact_cells() > 1000);
        let found = contact
            .warnings()
            .into_iter()
            .find_map(|warning| match warning {
                Warning::SteepSurface { per_mille } => Some((1e-3 * per_mille as f64, warning)),
                _ => None,
            });
        assert_eq!(stated_radius(&contact.warnings()), None);
        found
    };
    assert_eq!(slope(0.3), None);
    let (found, warning) = slope(1.0).unwrap();
    assert!((0.6..1.1).contains(&found), "{found}");
    let text = format!(
        "the rms slope of the surface at the contact is {found:.2}, expected at most 0.5: "
    );
    let words = warning.to_string();
    assert!(
        words.starts_with(&text) && words.contains("units of heights and grid"),
        "{words}"
    );
}

#[test]
fn steep_surface_on_single_cell_gives_warning() {
    let grid = Grid::square(16, 1.6).unwrap();
    let bodies = HalfSpace::new(grid, kit::unit_pair(0.3)).unwrap();
    let stated = |radius: f64| {
        let contact = pressed(&bodies, &surface::sphere(grid, radius).unwrap(), 1e-6);
        assert!(contact.contact_cells() <= 4);
        let warnings = contact.warnings().into_iter();
        warnings
            .filter(|w| matches!(w, Warning::SteepSurface { .. }))
            .collect::<Vec<_>>()
    };
    assert_eq!(stated(1.0), []);
    // Heights in a unit that is a thousand times too small. Four cells touch around the middle, with slopes of 200 along both
    // axes.
    assert_eq!(
        stated(1e-3 / 2.0),
        [Warning::SteepSurface { per_mille: 282_843 }]
    );
    // After a shift by half a cell, one cell touches.
    let off_centre = |factor: f64| {
        let gap = Field::from_fn(grid, |x, y| {
            factor * ((x - 0.05).powi(2) + (y - 0.05).powi(2))
        });
        let contact = pressed(&bodies, &gap, 1e-6);
        assert_eq!(contact.contact_cells(), 1);
        let warnings = contact.warnings().into_iter();
        warnings
            .filter(|w| matches!(w, Warning::SteepSurface { .. }))
            .collect::<Vec<_>>()
    };
    assert_eq!(off_centre(1.0), []);
    // The slope to each neighbour is 100, so that the rms slope of both axes is 141.42.
    assert_eq!(
        off_centre(1e3),
        [Warning::SteepSurface { per_mille: 141_421 }]
    );
}

#[test]
fn shift_larger_than_grid_gives_warning() {
    let bodies = bodies(16);
    let grid = bodies.grid();
    let side = grid.dx() * grid.nx() as f64;
    let ball = ball(&bodies);
    let normal = pressed(&bodies, &ball, load());
    let stated = |warnings: Vec<Warning>| {
        first_of(warnings, |w| matches!(w, Warning::ShiftBeyondGrid { .. }))
    };
    for (shift, tenths) in [(0.9 * side, None), (2.5 * side, Some(25))] {
        let expected = tenths.map(|tenths| Warning::ShiftBeyondGrid { tenths });
        let dragged = TangentialLoad::shift([0.0, shift]);
        let problem = TangentialProblem::builder(&bodies, &normal, friction(), dragged).build();
        assert_eq!(
            stated(problem.unwrap().solve().unwrap().warnings()),
            expected
        );
        let mut history = History::builder(&bodies, &ball, friction())
            .axis(Axis::Y)
            .build()
            .unwrap();
        let press = LoadStep::hold().normal(NormalLoad::Force(load()));
        history.step(&press).unwrap();
        // Each step counts, and the first step whose range exceeds the grid.
        for step in 1..=3 {
            let load = LoadStep::shift([0.0, f64::from(step) * shift]);
            let of_range = (step == 2).then_some(Warning::ShiftBeyondGrid { tenths: 18 });
            let found = stated(history.step(&load).unwrap().warnings());
            assert_eq!(found, expected.or(of_range));
        }
    }
}

#[test]
fn relative_displacement_larger_than_grid_gives_warning() {
    let bodies = bodies(16);
    let grid = bodies.grid();
    let side = grid.dx() * grid.nx() as f64;
    let ball = ball(&bodies);
    let normal = pressed(&bodies, &ball, load());
    let stated = |warnings: Vec<Warning>| {
        first_of(warnings, |w| matches!(w, Warning::ShiftBeyondGrid { .. }))
    };
    for (part, tenths) in [(0.9, None), (2.5, Some(25))] {
        let expected = tenths.map(|tenths| Warning::ShiftBeyondGrid { tenths });
        let along_x = Field::from_fn(grid, |_, _| part * side);
        let moved = RelativeDisplacement::new([along_x, Field::zeros(grid)]).unwrap();
        let held = TangentialLoad::shift([0.0; 2]);
        let problem = TangentialProblem::builder(&bodies, &normal, friction(), held)
            .relative_displacement(moved.clone())
            .build();
        assert_eq!(
            stated(problem.unwrap().solve().unwrap().warnings()),
            expected
        );
        let coupled =
            CoupledProblem::builder(&bodies, &ball, friction(), NormalLoad::Force(load()), held);
        let coupled = kit::solve(coupled.relative_displacement(moved.clone()));
        assert_eq!(stated(coupled.warnings()), expected);
        let mut history = History::builder(&bodies, &ball, friction())
            .relative_displacement(moved)
            .build()
            .unwrap();
        let press = LoadStep::hold().normal(NormalLoad::Force(load()));
        assert_eq!(stated(history.step(&press).unwrap().warnings()), None);
        for step in 1..=2 {
            let load = LoadStep::shift([0.0; 2]).relative_displacement(f64::from(step));
            assert_eq!(stated(history.step(&load).unwrap().warnings()), expected);
        }
        assert_eq!(
            stated(history.step(&LoadStep::hold()).unwrap().warnings()),
            None
        );
    }
}

#[test]
fn creepage_of_a_tenth_gives_warning() {
    let bodies = bodies(16);
    let ball = ball(&bodies);
    let normal = pressed(&bodies, &ball, load());
    let stated =
        |warnings: Vec<Warning>| first_of(warnings, |w| matches!(w, Warning::LargeCreepage { .. }));
    // 0.12 is the magnitude of 0.072 and 0.096. Creepages of 0.1, 0.2 and 0.5 may be meant in per cent. The farthest contact cell has
    // a distance of about 1 from the origin.
    for (creepage, spin, per_cent) in [
        ([0.057, 0.076], 0.0, None),
        ([0.06, 0.08], 0.0, Some(10)),
        ([0.1, 0.0], 0.0, Some(10)),
        ([-0.072, 0.096], 0.0, Some(12)),
        ([0.2, 0.0], 0.0, Some(20)),
        ([0.0, 0.5], 0.0, Some(50)),
        ([0.01, 0.0], -0.05, None),
        ([0.01, 0.0], -0.2, Some(20)),
    ] {
        let problem = RollingProblem::builder(&bodies, &normal, friction());
        let problem = problem.creepage(creepage).spin(spin).build().unwrap();
        let rolling = problem.solve().unwrap();
        let point = [creepage[0], creepage[1], spin];
        let mut solver = problem.into_solver().unwrap();
        let points = solver.creep_forces([point]).unwrap();
        let mut history = History::builder(&bodies, &ball, friction())
            .model(TangentialModel::Vector)
            .build()
            .unwrap();
        let press = LoadStep::hold().normal(NormalLoad::Force(load()));
        let rolled = press.roll(Rolling::new(1).creepage(creepage).spin(spin));
        let step = history.step(&rolled).unwrap();
        for warnings in [rolling.warnings(), points[0].warnings(), step.warnings()] {
            match (stated(warnings), per_cent) {
                (None, None) => {}
                (Some(Warning::LargeCreepage { per_cent: found }), Some(expected)) => {
                    assert!(found.abs_diff(expected) <= usize::from(spin != 0.0));
                }
                (found, _) => panic!("{creepage:?} {spin}: {found:?}"),
            }
        }
    }
}

/// A mean pressure given as a force passes all limits that follow from the approach, which cannot exceed the mean gap.
#[test]
fn pressure_above_half_of_contact_modulus_gives_warning() {
    let grid = Grid::square(16, 4.0).unwrap();
    let bodies = HalfSpace::with_boundary(grid, kit::unit_pair(0.3), Boundary::Periodic).unwrap();
    let modulus = bodies.pair().contact_modulus();
    let wave = std::f64::consts::TAU / 4.0;
    let gap = Field::from_fn(grid, |x, y| {
        1e-3 * (2.0 - (wave * x).cos() - (wave * y).cos())
    });
    for part in [0.4, 0.6] {
        let force = NormalLoad::Force(part * modulus * grid.area());
        let problem = NormalProblem::builder(&bodies, &gap, force)
            .build()
            .unwrap();
        let warnings = problem.solve().unwrap().warnings();
        let mut ratios = warnings.iter().filter_map(|warning| match warning {
            Warning::PressureBeyondModulus { per_mille } => Some(*per_mille),
            _ => None,
        });
        // The wave adds a thousandth of the modulus to the mean pressure.
        assert_eq!(ratios.next().is_some_and(|ratio| ratio > 600), part > 0.5);
    }
}

#[test]
fn solution_of_unconverged_solve_gives_warning() {
    let bodies = bodies(16);
    let ball = ball(&bodies);
    let problem = NormalProblem::builder(&bodies, &ball, NormalLoad::Force(load()));
    let mut solver = problem
        .max_iterations(1)
        .build()
        .unwrap()
        .into_solver()
        .unwrap();
    let mut normal = solver.new_solution();
    assert!(!normal.warnings().contains(&Warning::NotConverged));
    assert!(solver.solve_into(&mut normal).is_err());
    assert!(normal.warnings().contains(&Warning::NotConverged));

    let normal = pressed(&bodies, &ball, load());
    assert!(!normal.warnings().contains(&Warning::NotConverged));
    let shift = TangentialLoad::force([0.3 * load(), 0.0]);
    let problem = TangentialProblem::builder(&bodies, &normal, friction(), shift);
    let mut solver = problem
        .max_iterations(1)
        .build()
        .unwrap()
        .into_solver()
        .unwrap();
    let mut tangential = solver.new_solution();
    assert!(solver.solve_into(&mut tangential).is_err());
    assert!(tangential.warnings().contains(&Warning::NotConverged));
}

#[test]
fn twist_above_a_fifth_of_a_radian_gives_warning() {
    let bodies = bodies(16);
    let ball = ball(&bodies);
    let normal = pressed(&bodies, &ball, load());
    let stated =
        |warnings: Vec<Warning>| first_of(warnings, |w| matches!(w, Warning::LargeTwist { .. }));
    for (twist, tenths) in [(0.2, None), (0.3, Some(3)), (-2.0, Some(20))] {
        let expected = tenths.map(|tenths| Warning::LargeTwist { tenths });
        let turned = TangentialLoad::force([0.0; 2]).twist(twist);
        let problem = TangentialProblem::builder(&bodies, &normal, friction(), turned)
            .model(TangentialModel::Vector)
            .build();
        let found = problem.unwrap().solve().unwrap().warnings();
        assert_eq!(stated(found), expected);
        let mut history = History::builder(&bodies, &ball, friction())
            .model(TangentialModel::Vector)
            .build()
            .unwrap();
        let press = LoadStep::hold().normal(NormalLoad::Force(load()));
        history.step(&press).unwrap();
        // Each step counts, and the first step whose range exceeds the limit.
        for step in 1..=3 {
            let load = LoadStep::hold().twist(f64::from(step) * twist);
            let of_range = (step == 2).then_some(Warning::LargeTwist { tenths: 4 });
            let found = stated(history.step(&load).unwrap().warnings());
            assert_eq!(found, expected.or(of_range));
        }
    }
}

#[test]
fn approach_larger_than_grid_gives_warning() {
    let bodies = bodies(16);
    let stated = |datum: f64, approach: f64| {
        let gap = Field::from_fn(bodies.grid(), |x, y| datum + (x * x + y * y) / 40.0);
        let control = NormalLoad::Approach(datum + approach);
        let contact = NormalProblem::builder(&bodies, &gap, control).build();
        let contact = contact.unwrap().solve().unwrap();
        contact
            .warnings()
            .into_iter()
            .find_map(|warning| match warning {
                Warning::ApproachBeyondGrid { tenths } => Some((tenths, warning.to_string())),
                _ => None,
            })
    };
    // The datum of the heights does not matter.
    assert_eq!(stated(1000.0, 0.05), None);
    assert_eq!(stated(0.0, 2.7), None);
    let (tenths, text) = stated(-50.0, 2.8 * 1.5).unwrap();
    assert_eq!(tenths, 15);
    assert_eq!(
        text,
        "the approach is 1.5 times the side of the grid, expected less than 1: check the units of gap, grid, modulus and load"
    );
}

#[test]
fn held_shift_that_loses_force_gives_warning() {
    let bodies = bodies(20);
    for model in [TangentialModel::Scalar, TangentialModel::Vector] {
        let start = || {
            let builder = History::builder(&bodies, ball(&bodies), friction()).model(model);
            let mut history = builder.build().unwrap();
            history.step(&press(1.0)).unwrap();
            history.step(&LoadStep::force([0.2 * load(), 0.0])).unwrap();
            history
        };
        let lost = |history: &History| {
            let warnings = history.last_step().unwrap().warnings();
            warnings.into_iter().find_map(|warning| match warning {
                Warning::HeldShiftLostForce { per_cent } => Some((per_cent, warning.to_string())),
                _ => None,
            })
        };
        let before = start().tangential_force()[0];
        for (part, is_lost) in [(0.9, false), (0.5, false), (0.15, true), (0.0, false)] {
            let mut history = start();
            let mut cycle = Cycle::new(&history);
            history.step(&press(part)).unwrap();
            cycle.add(&history).unwrap();
            let found = lost(&history);
            assert_eq!(found.is_some(), is_lost, "{part} {found:?}");
            if let Some((per_cent, text)) = found {
                let exact = 100.0 * (1.0 - history.tangential_force()[0] / before);
                assert!((per_cent as f64 - exact).abs() <= 0.5, "{per_cent} {exact}");
                assert!(exact > 50.0);
                assert_eq!(
                    text,
                    format!(
                        "the tangential force decreased by {per_cent} % under a held shift, expected at most 50 %: to keep the force, prescribe it in each step"
                    )
                );
                assert!(
                    cycle
                        .warnings()
                        .contains(&Warning::HeldShiftLostForce { per_cent })
                );
            }
        }
        // Reducing the friction has the same effect.
        let mut history = start();
        history
            .set_friction(&Friction::coulomb(0.05).unwrap())
            .unwrap();
        history.step(&LoadStep::hold()).unwrap();
        assert!(lost(&history).is_some());
        // If the caller prescribes a force or a shift, the loss of force is intended.
        let mut history = start();
        history
            .step(&press(0.15).tangential(Axis::X, TangentialControl::Force(0.0)))
            .unwrap();
        assert_eq!(lost(&history), None);
        let mut history = start();
        history
            .step(&press(0.15).tangential(Axis::X, TangentialControl::Shift(0.0)))
            .unwrap();
        assert_eq!(lost(&history), None);
        // The round-off of a zero force does not count as a loss.
        let mut history = start();
        history.step(&LoadStep::force([0.0; 2])).unwrap();
        history.step(&press(0.3)).unwrap();
        assert_eq!(lost(&history), None);
    }
}

/// Each step loses less than half of the force. The warning compares with the last prescribed force.
#[test]
fn held_shift_that_loses_force_in_several_steps_gives_warning() {
    let bodies = bodies(20);
    let lost = |history: &History| {
        let warnings = history.last_step().unwrap().warnings();
        warnings.into_iter().find_map(|warning| match warning {
            Warning::HeldShiftLostForce { per_cent } => Some(per_cent),
            _ => None,
        })
    };
    let builder = History::builder(&bodies, ball(&bodies), friction());
    let mut history = builder.model(TangentialModel::Vector).build().unwrap();
    history.step(&press(1.0)).unwrap();
    let prescribed = 0.29 * load();
    history.step(&LoadStep::force([prescribed, 0.0])).unwrap();
    for part in [0.65, 0.42] {
        history.step(&press(part)).unwrap();
        assert_eq!(lost(&history), None);
    }
    let before = history.tangential_force()[0];
    let kept = history.state().clone();
    let bytes = history.to_bytes();
    history.step(&press(0.22)).unwrap();
    let ratio = history.tangential_force()[0] / prescribed;
    assert!(ratio < 0.45 && history.tangential_force()[0] > 0.55 * before);
    let found = lost(&history).unwrap();
    assert!(
        (found as f64 - 100.0 * (1.0 - ratio)).abs() <= 0.5,
        "{found} {ratio}"
    );
    // A restored state and a saved history still contain the prescribed force.
    let after = history.state().clone();
    for mut restored in [
        History::from_state(&bodies, kept).unwrap(),
        History::from_bytes(&bodies, &bytes).unwrap(),
    ] {
        restored.step(&press(0.22)).unwrap();
        assert_eq!(lost(&restored), Some(found));
        assert!(restored.state() == &after);
    }
    // After the warning, the comparison starts from the remaining force.
    history.step(&press(0.2)).unwrap();
    assert_eq!(lost(&history), None);

    // A load along y does not prescribe the load along x.
    let mut history = History::from_bytes(&bodies, &bytes).unwrap();
    let across = press(0.22).tangential(Axis::Y, TangentialControl::Force(0.0));
    history.step(&across).unwrap();
    assert!(lost(&history).is_some());
    let along = press(0.2).tangential(Axis::X, TangentialControl::Shift(0.0));
    history.step(&along).unwrap();
    assert_eq!(lost(&history), None);
}

/// The limited pressure of a hardness changes the gap. A restored history still reports the same warnings.
#[test]
fn warnings_of_yielded_history_survive_saving() {
    let bodies = bodies(20);
    let gap = surface::sphere(bodies.grid(), 2.0).unwrap();
    let hardness = Hardness::uniform(0.2).unwrap();
    let builder = History::builder(&bodies, &gap, friction()).hardness(hardness);
    let mut history = builder.permanent_set(true).build().unwrap();
    history
        .step(&LoadStep::hold().normal(NormalLoad::Force(0.6)))
        .unwrap();
    assert!(stated_radius(&history.normal().warnings()).is_some());
    let restored = History::from_bytes(&bodies, &history.to_bytes()).unwrap();
    assert_eq!(restored.normal().warnings(), history.normal().warnings());
}

#[test]
fn friction_above_five_gives_warning_in_every_solution() {
    let bodies = bodies(16);
    let (grid, ball) = (bodies.grid(), ball(&bodies));
    let normal = pressed(&bodies, &ball, load());
    let stated =
        |warnings: Vec<Warning>| first_of(warnings, |w| matches!(w, Warning::LargeFriction { .. }));
    let mut rough = Field::constant(grid, 0.3);
    rough.as_mut_slice()[3] = 8.0;
    let frictions = [
        (Friction::coulomb(0.3).unwrap(), None),
        (Friction::coulomb(5.0).unwrap(), None),
        (Friction::coulomb(30.0).unwrap(), Some(300)),
        (Friction::per_cell(rough).unwrap(), Some(80)),
    ];
    for (friction, tenths) in frictions {
        let expected = tenths.map(|tenths| Warning::LargeFriction { tenths });
        let force = TangentialLoad::force([0.01 * load(), 0.0]);
        let tangential = TangentialProblem::builder(&bodies, &normal, friction.clone(), force);
        let tangential = tangential.build().unwrap().solve().unwrap();
        assert_eq!(stated(tangential.warnings()), expected);
        let coupled = CoupledProblem::builder(
            &bodies,
            &ball,
            friction.clone(),
            NormalLoad::Force(load()),
            force,
        );
        let coupled = coupled.build().unwrap().solve().unwrap();
        assert_eq!(stated(coupled.warnings()), expected);
        let rolling = RollingProblem::builder(&bodies, &normal, friction.clone());
        let rolling = rolling.creepage([1e-3, 0.0]).build().unwrap();
        assert_eq!(stated(rolling.solve().unwrap().warnings()), expected);
        assert_eq!(stated(point_warnings(rolling)), expected);
        let rolling = CoupledRollingProblem::builder(
            &bodies,
            &ball,
            friction.clone(),
            NormalLoad::Force(load()),
        );
        let rolling = rolling.creepage([1e-3, 0.0]).build().unwrap();
        assert_eq!(stated(rolling.solve().unwrap().warnings()), expected);

        let mut history = History::builder(&bodies, &ball, friction).build().unwrap();
        let mut cycle = Cycle::new(&history);
        let press = LoadStep::hold().normal(NormalLoad::Force(load()));
        assert_eq!(stated(history.step(&press).unwrap().warnings()), expected);
        cycle.add(&history).unwrap();
        // The cycle keeps the warning after the friction has changed.
        history.set_friction(&self::friction()).unwrap();
        assert_eq!(stated(history.step(&press).unwrap().warnings()), None);
        cycle.add(&history).unwrap();
        assert_eq!(stated(cycle.warnings()), expected);
    }
}

#[test]
fn gap_change_beyond_displacement_gives_warning() {
    let bodies = bodies(16);
    let ball = ball(&bodies);
    let stated = |warnings: Vec<Warning>| {
        first_of(warnings, |w| matches!(w, Warning::LargeGapChange { .. }))
    };
    let press = LoadStep::hold().normal(NormalLoad::Force(load()));
    let wear = |part: f64| {
        let mut history = History::builder(&bodies, &ball, friction())
            .build()
            .unwrap();
        history.step(&press).unwrap();
        // The largest displacement is the approach minus the gap of 0.01 of the four innermost cells.
        let displacement = history.approach() - ball.min();
        let cells = history.pressure().as_slice().iter().zip(ball.as_slice());
        let worn = cells.map(|(p, gap)| gap + if *p > 0.0 { part * displacement } else { 0.0 });
        let worn = Field::from_vec(ball.grid(), worn.collect()).unwrap();
        history.set_gap(&worn).unwrap();
        history
    };
    for (part, tenths) in [(0.9, None), (2.5, Some(25)), (1e9, Some(10_000_000_000))] {
        let expected = tenths.map(|tenths| Warning::LargeGapChange { tenths });
        let mut history = wear(part);
        // A step that holds the pressure keeps the old contact.
        let held = history.step(&LoadStep::hold()).unwrap();
        assert_eq!(stated(held.warnings()), None);
        // The change survives a restart.
        let mut restarted = History::from_bytes(&bodies, &history.to_bytes()).unwrap();
        for history in [&mut history, &mut restarted] {
            assert_eq!(stated(history.step(&press).unwrap().warnings()), expected);
            assert_eq!(stated(history.step(&press).unwrap().warnings()), None);
        }
    }
    // A moving texture changes the gap of contact cells in the same way.
    let mut history = wear(2.5);
    let rolled = history.step(&press.roll(Rolling::new(1))).unwrap();
    assert_eq!(stated(rolled.warnings()), None);
    // Cells without contact do not count.
    let mut history = wear(0.0);
    let mut raised = ball.clone();
    raised.as_mut_slice()[0] += 1e3;
    history.set_gap(&raised).unwrap();
    assert_eq!(stated(history.step(&press).unwrap().warnings()), None);
}

#[test]
fn hardness_far_below_modulus_gives_warning() {
    let bodies = bodies(16);
    let ball = ball(&bodies);
    let stated =
        |warnings: Vec<Warning>| first_of(warnings, |w| matches!(w, Warning::LowHardness { .. }));
    let modulus = kit::unit_pair(0.3).contact_modulus();
    let press = NormalLoad::Approach(1.0 / RADIUS);
    for (parts, is_low) in [
        (100, false),
        (8_000, false),
        (12_000, true),
        (100_000_000, true),
    ] {
        let expected = is_low.then_some(Warning::LowHardness { parts });
        let hardness = Hardness::uniform(modulus / parts as f64).unwrap();
        let normal = NormalProblem::builder(&bodies, &ball, press).hardness(hardness.clone());
        assert_eq!(stated(kit::solve(normal).warnings()), expected, "{parts}");
        let coupled = CoupledProblem::builder(
            &bodies,
            &ball,
            friction(),
            press,
            TangentialLoad::shift([0.0; 2]),
        );
        let coupled = kit::solve(coupled.hardness(hardness.clone()));
        assert_eq!(stated(coupled.warnings()), expected, "{parts}");
        let builder = History::builder(&bodies, &ball, friction()).hardness(hardness);
        let mut history = builder.build().unwrap();
        let mut cycle = Cycle::new(&history);
        for (step, expected) in [
            (LoadStep::hold().normal(press), expected),
            (LoadStep::hold().normal(NormalLoad::Force(0.0)), None),
        ] {
            assert_eq!(stated(history.step(&step).unwrap().warnings()), expected);
            assert_eq!(stated(history.normal().warnings()), expected);
            cycle.add(&history).unwrap();
        }
        assert_eq!(stated(cycle.warnings()), expected);
    }
    // An elastic contact of a low pressure has no warning.
    let light = pressed(&bodies, &ball, 1e-9 * load());
    assert!(light.pressure().max() < modulus / 20_000.0);
    assert_eq!(stated(light.warnings()), None);
}

#[test]
fn low_cap_of_friction_gives_warning_in_every_solution() {
    let bodies = bodies(16);
    let ball = ball(&bodies);
    let normal = pressed(&bodies, &ball, load());
    let stated = |warnings: Vec<Warning>| {
        first_of(warnings, |w| matches!(w, Warning::LowShearStress { .. }))
    };
    // The whole contact is capped, so that the ratio is that of the limit of the mean pressure to the cap.
    let mean = 0.5 * normal.mean_pressure();
    for (parts, coefficient, is_low) in [
        (10, 0.5, false),
        (90, 0.5, false),
        (110, 0.5, true),
        (1_000_000, 0.5, true),
        // A constant limit of the traction.
        (1_000_000, 50.0, false),
    ] {
        let expected = is_low.then_some(Warning::LowShearStress { parts });
        let friction = Friction::coulomb(coefficient).unwrap();
        let friction = friction.max_shear_stress(mean / parts as f64).unwrap();
        let shift = TangentialLoad::shift([1e-3, 0.0]);
        let tangential = TangentialProblem::builder(&bodies, &normal, friction.clone(), shift);
        assert_eq!(stated(kit::solve(tangential).warnings()), expected);
        let press = NormalLoad::Force(load());
        let coupled = CoupledProblem::builder(&bodies, &ball, friction.clone(), press, shift);
        assert_eq!(stated(kit::solve(coupled).warnings()), expected);
        let rolling = RollingProblem::builder(&bodies, &normal, friction.clone());
        let rolling = rolling.creepage([1e-3, 0.0]).build().unwrap();
        assert_eq!(stated(rolling.solve().unwrap().warnings()), expected);
        assert_eq!(stated(point_warnings(rolling)), expected);
        let mut history = History::builder(&bodies, &ball, friction).build().unwrap();
        let mut cycle = Cycle::new(&history);
        let slide = LoadStep::shift([1e-3, 0.0]).normal(press);
        assert_eq!(stated(history.step(&slide).unwrap().warnings()), expected);
        cycle.add(&history).unwrap();
        history.set_friction(&self::friction()).unwrap();
        assert_eq!(stated(history.step(&slide).unwrap().warnings()), None);
        cycle.add(&history).unwrap();
        assert_eq!(stated(cycle.warnings()), expected);
    }
}

/// A pressure in Pa with moduli in MPa has the warning in tangential problems and in rolling. A solved pressure then removes it.
#[test]
fn high_prescribed_pressure_gives_warning() {
    let bodies = bodies(16);
    let normal = pressed(&bodies, &ball(&bodies), load());
    let modulus = bodies.pair().contact_modulus();
    let creepage = [1e-3, 0.0];
    for (part, per_mille) in [(0.49, None), (0.6, Some(600)), (1e6, Some(1_000_000_000))] {
        let expected = per_mille.map(|per_mille| Warning::PressureBeyondModulus { per_mille });
        let stated = |warnings: Vec<Warning>| {
            first_of(warnings, |w| {
                matches!(w, Warning::PressureBeyondModulus { .. })
            })
        };
        let factor = part * modulus / normal.pressure().max();
        let mut field = normal.pressure().clone();
        for p in field.as_mut_slice() {
            *p *= factor;
        }
        let shift = TangentialLoad::shift([1e-3, 0.0]);
        let problem = TangentialProblem::builder(&bodies, &field, friction(), shift);
        let mut solver = problem.build().unwrap().into_solver().unwrap();
        assert_eq!(stated(kit::solved(&mut solver).warnings()), expected);
        solver.set_pressure(&normal).unwrap();
        assert_eq!(stated(kit::solved(&mut solver).warnings()), None);
        solver.set_pressure(&field).unwrap();
        assert_eq!(stated(kit::solved(&mut solver).warnings()), expected);

        let problem = RollingProblem::builder(&bodies, &normal, friction()).creepage(creepage);
        let problem = problem.entry_rule(EntryRule::WholeStep).build().unwrap();
        let mut solver = problem.into_solver().unwrap();
        assert_eq!(stated(kit::solved(&mut solver).warnings()), None);
        solver.set_pressure(&field).unwrap();
        assert_eq!(stated(kit::solved(&mut solver).warnings()), expected);
        let points = solver.creep_forces([[1e-3, 0.0, 0.0]]).unwrap();
        assert_eq!(stated(points[0].warnings()), expected);
        solver.set_pressure(&normal).unwrap();
        assert_eq!(stated(kit::solved(&mut solver).warnings()), None);
    }
    // A low pressure in rolling has its warning, too.
    let mut field = normal.pressure().clone();
    for p in field.as_mut_slice() {
        *p *= 1e-9 * modulus / normal.pressure().max();
    }
    let problem = RollingProblem::builder(&bodies, &normal, friction()).creepage(creepage);
    let problem = problem.entry_rule(EntryRule::WholeStep).build().unwrap();
    let mut solver = problem.into_solver().unwrap();
    solver.set_pressure(&field).unwrap();
    let warnings = kit::solved(&mut solver).warnings();
    assert!(
        warnings
            .iter()
            .any(|w| matches!(w, Warning::LowPressure { .. }))
    );
}

/// A prescribed pressure in MPa with moduli in Pa has the warning. A low pressure of a solved contact does not have it.
#[test]
fn low_prescribed_pressure_gives_warning() {
    let bodies = bodies(16);
    let ball = ball(&bodies);
    let normal = pressed(&bodies, &ball, load());
    let stated =
        |warnings: Vec<Warning>| first_of(warnings, |w| matches!(w, Warning::LowPressure { .. }));
    let modulus = bodies.pair().contact_modulus();
    let scaled = |parts: f64| {
        let factor = modulus / parts / normal.pressure().max();
        let mut pressure = normal.pressure().clone();
        for p in pressure.as_mut_slice() {
            *p *= factor;
        }
        pressure
    };
    let shift = TangentialLoad::shift([1e-12, 0.0]);
    let start = |pressure: &Field| {
        let problem = TangentialProblem::builder(&bodies, pressure, friction(), shift);
        problem.build().unwrap().into_solver().unwrap()
    };
    for (parts, is_low) in [(0.9e7, false), (1.2e7, true), (2e8, true)] {
        let mut solver = start(&scaled(parts));
        let found = stated(kit::solved(&mut solver).warnings());
        assert_eq!(found.is_some(), is_low);
        if let Some(Warning::LowPressure { parts: found }) = found {
            assert!((found as f64 / parts - 1.0).abs() < 1e-6);
        }
        // The source of the last pressure counts.
        let light = pressed(&bodies, &ball, 1e-24 * load());
        assert!(light.pressure().max() < 1e-7 * modulus);
        solver.set_pressure(&light).unwrap();
        assert_eq!(stated(kit::solved(&mut solver).warnings()), None);
        solver.set_pressure(&scaled(parts)).unwrap();
        assert_eq!(
            stated(kit::solved(&mut solver).warnings()).is_some(),
            is_low
        );
    }
}
