//! Serialised types are restored bitwise from text and binary formats. Values that the constructor rejects are rejected
//! with the same message.

use std::fmt::Debug;
use std::time::Duration;

use kit::serde_json::{self, Value, json};
use kit::{Table2, postcard, rough, unit_bodies, unit_pair};
use proptest::prelude::*;
use serde::Serialize;
use serde::de::DeserializeOwned;
use stickslip::analytical::{CattaneoMindlin, HertzSphere, MindlinDeresiewicz};
use stickslip::cgm::{Method, Settings};
use stickslip::history::{Cycle, FrettingLoop, LoadPath};
use stickslip::influence::{Component, Rectangle};
use stickslip::layers::Layer;
use stickslip::normal::Hardness;
use stickslip::rolling::{RollingProblem, RollingSolution};
use stickslip::sensitivity::{Functional, Weights};
use stickslip::surface::{self, Amplitudes, GaussianFilter, PowerSpectrum, SelfAffine, Statistics};
use stickslip::tangential::RelativeDisplacement;
use stickslip::{
    Axis, CoupledProblem, ElasticPair, Field, Friction, Grid, HalfSpace, History, LoadStep,
    Material, NormalControl, NormalLoad, NormalProblem, NormalSolution, Result, Status,
    TangentialControl, TangentialLoad, TangentialModel, TangentialProblem, TangentialSolution,
    Warning, Zone,
};

/// Returns the values read from text and from bytes, after checking that writing them again gives the same text and
/// bytes. The sign of a NaN is not compared in text.
fn read_back<T: Serialize + DeserializeOwned>(value: &T) -> [T; 2] {
    let text = serde_json::to_string(value).unwrap();
    let from_text = serde_json::from_str(&text).unwrap();
    assert_eq!(serde_json::to_string(&from_text).unwrap(), text);
    let bytes = postcard::to_stdvec(value).unwrap();
    let from_bytes = postcard::from_bytes(&bytes).unwrap();
    assert_eq!(postcard::to_stdvec(&from_bytes).unwrap(), bytes, "{text}");
    [from_text, from_bytes]
}

fn assert_survives<T: Serialize + DeserializeOwned + PartialEq + Debug>(value: &T) {
    for read in read_back(value) {
        assert_eq!(&read, value);
    }
}

fn grid() -> Grid {
    Grid::new(5, 3, 0.1, 0.7 / 3.0).unwrap()
}

#[test]
fn scenes_survive_serialisation() {
    assert_survives(&grid());
    assert_survives(&Field::from_fn(grid(), |x, y| (x + 0.1 * y).sin()));
    let missing = [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, -0.0, 1e-310];
    let holes = Field::from_vec(Grid::new(5, 1, 1.0, 1.0).unwrap(), missing.to_vec()).unwrap();
    read_back(&holes);

    for boundary in kit::boundaries(grid()) {
        assert_survives(&boundary);
    }
    let odd = Material::from_shear_modulus(200.0 / 3.0, 0.42).unwrap();
    for material in [odd, Material::rigid()] {
        assert_survives(&material);
        assert_survives(&ElasticPair::new(material, odd).unwrap());
    }
    assert_survives(&odd.with_hardness(1.0 / 3.0).unwrap());
    assert_survives(&Table2::pair());
    assert_survives(&Hardness::uniform(1.0 / 3.0).unwrap());
    assert_survives(&Hardness::per_cell(Field::constant(grid(), 1.0 / 3.0)).unwrap());
    for friction in [
        kit::coulomb(0.1),
        Friction::per_cell(Field::constant(grid(), 1.0 / 3.0)).unwrap(),
    ] {
        assert_survives(&friction);
        assert_survives(&friction.max_shear_stress(0.3).unwrap());
    }
}

#[test]
fn loads_and_options_survive_serialisation() {
    for load in [NormalControl::Force(0.1), NormalControl::Approach(-0.1)] {
        assert_survives(&load);
    }
    for load in [
        TangentialLoad::force([0.1, -0.2]),
        TangentialLoad::shift([0.3, 0.0]),
    ] {
        assert_survives(&load);
    }
    for normal in [
        NormalControl::Force(0.1),
        NormalControl::Approach(0.2),
        NormalControl::Hold,
    ] {
        for tangential in [
            TangentialControl::Force(0.1),
            TangentialControl::Shift(0.2),
            TangentialControl::Spring {
                position: 0.3,
                stiffness: 0.7,
            },
            TangentialControl::Hold,
        ] {
            let step = LoadStep::hold().normal(normal);
            let step = step.tangential(Axis::Y, tangential);
            assert_survives(&step);
            assert_survives(&step.twist(0.1));
        }
    }
    assert_survives(&LoadPath::ellipse([0.1, 0.2], 0.3, 12).unwrap());
    let strain = [[1e-3, 2e-3 / 3.0], [2e-3 / 3.0, 0.0]];
    let bulk = RelativeDisplacement::bulk_strain(grid(), strain).unwrap();
    assert_survives(&bulk);
    let written = serde_json::to_value(&bulk).unwrap();
    assert_eq!(written["strain"], json!(strain));
    for axis in [Axis::X, Axis::Y] {
        assert_survives(&axis);
    }
    for lateral in [TangentialModel::Scalar, TangentialModel::Vector] {
        assert_survives(&lateral);
    }
    for method in [Method::ActiveSet, Method::PolonskyKeer] {
        let settings = Settings::default().method(method).tolerance(1e-7 / 3.0);
        assert_survives(&settings);
        assert_survives(&settings.time_limit(Duration::new(3, 141_592_653)));
    }
    for component in Component::ALL {
        assert_survives(&component);
    }
}

#[test]
fn sensitivities_survive_serialisation() {
    let weights = Field::from_fn(grid(), |x, y| x - 0.1 * y);
    let pair = [weights.clone(), weights.clone()];
    let weighted = Weights::new().pressure(weights).traction(pair.clone());
    let weighted = weighted.slip(pair).approach(0.1).shift([0.2, 0.3]);
    for functional in [
        Functional::PressureNorm { exponent: 8.0 },
        Functional::StickForce(Axis::Y),
        Functional::Weighted(weighted),
    ] {
        assert_survives(&functional);
    }
    let ball = surface::sphere(Grid::square(16, 3.0).unwrap(), 10.0);
    let bodies = unit_bodies(Grid::square(16, 3.0).unwrap(), 0.3);
    let problem = NormalProblem::builder(&bodies, ball.unwrap(), NormalLoad::Force(0.1));
    let mut solver = problem.build().unwrap().into_solver().unwrap();
    let mut contact = solver.new_solution();
    solver.solve_into(&mut contact).unwrap();
    let found = solver.sensitivity(&contact, &Functional::Approach);
    assert_survives(&found.unwrap());
}

#[test]
fn surfaces_survive_serialisation() {
    for amplitudes in [Amplitudes::Exact, Amplitudes::Gaussian] {
        let height = SelfAffine::with_rms_height(0.1).amplitudes(amplitudes);
        assert_survives(&height);
        let slope = SelfAffine::with_rms_slope(0.3).hurst(0.7).seed(u64::MAX);
        let band = slope.longest_wavelength(0.9).roll_off_wavelength(0.8);
        let all = band.cut_off_wavelength(0.2).skewness(-0.1).kurtosis(3.1);
        assert_survives(&all.amplitudes(amplitudes).cropped());
    }
    let heights = rough(kit::square(16, 1.0), 3);
    assert_survives(&Statistics::of(&heights).unwrap());
    assert_survives(&PowerSpectrum::of(&heights).unwrap());
    let recipe = SelfAffine::with_rms_height(0.1);
    assert_survives(&recipe.generate(kit::square(16, 1.0)).unwrap());
    assert_survives(&surface::level(&heights, surface::Form::Plane).unwrap());
    assert_survives(&surface::fill_missing(&heights).unwrap());
    assert_survives(&GaussianFilter::sl(0.2, 0.5).apply(&heights).unwrap());
    // A flat surface has no skewness (NaN), so the values are only written and read.
    read_back(&Statistics::of(&Field::zeros(grid())).unwrap());
    for form in [
        surface::Form::Mean,
        surface::Form::Plane,
        surface::Form::Polynomial(3),
    ] {
        assert_survives(&form);
    }
}

/// Returns a contact that is pressed and not yet sheared.
fn pressed() -> (HalfSpace, NormalSolution) {
    let grid = Grid::new(24, 20, 0.5, 0.6).unwrap();
    let bodies = unit_bodies(grid, 0.3);
    let problem = NormalProblem::builder(&bodies, kit::sphere(grid, 10.0), NormalLoad::Force(3.0));
    let normal = kit::solve(problem);
    (bodies, normal)
}

fn sheared(
    bodies: &HalfSpace,
    normal: &NormalSolution,
    lateral: TangentialModel,
) -> Result<TangentialSolution> {
    let friction = Friction::coulomb(0.4)?;
    let load = TangentialLoad::force([0.6, 0.0]);
    let problem = TangentialProblem::builder(bodies, normal, friction, load);
    problem.model(lateral).build()?.solve()
}

#[test]
fn solutions_and_reports_survive_serialisation() {
    let (bodies, normal) = pressed();
    assert_survives(&normal);
    assert_survives(normal.report());
    assert_survives(&normal.report().history[0]);
    assert_survives(&normal.spots().unwrap());
    for zone in [Zone::Separated, Zone::Stick, Zone::Slip] {
        assert_survives(&zone);
    }
    let [read, _] = read_back(&normal);
    for lateral in [TangentialModel::Scalar, TangentialModel::Vector] {
        let shear = sheared(&bodies, &normal, lateral).unwrap();
        assert_survives(&shear);
        assert_survives(&shear.edges(&normal, &kit::coulomb(0.4)).unwrap());
        // A pressure that was read can be used like a computed pressure.
        let again = sheared(&bodies, &read, lateral).unwrap();
        assert_eq!(shear.traction(), again.traction());
    }

    let rolling =
        RollingProblem::builder(&bodies, &normal, kit::coulomb(0.3)).creepage([0.01, 0.02]);
    let mut solver = kit::solver(rolling);
    let mut rolling = solver.new_solution();
    assert_survives(&rolling);
    solver.solve_into(&mut rolling).unwrap();
    assert_survives(&rolling);
    let mut short = serde_json::to_value(&rolling).unwrap();
    short["zones"].as_array_mut().unwrap().pop();
    let refused = serde_json::from_value::<RollingSolution>(short).unwrap_err();
    assert!(refused.to_string().contains("zones"), "{refused}");

    // Residuals are infinite before the first solve.
    let flat = Field::zeros(bodies.grid());
    let problem = NormalProblem::builder(&bodies, &flat, NormalLoad::Force(1.0));
    let solver = kit::solver(problem);
    assert_survives(&solver.new_solution());
    for status in [
        Status::Unsolved,
        Status::Converged,
        Status::IterationLimit,
        Status::TimeLimit,
        Status::Stalled,
        Status::Cancelled,
    ] {
        assert_survives(&status);
    }
    for warning in [
        Warning::NoContact,
        Warning::ContactAtEdge { cells: 3 },
        Warning::UnresolvedSpots {
            unresolved: 1,
            spots: 2,
        },
        Warning::StalePressure,
        Warning::LargeContactRadius { per_mille: 450 },
    ] {
        assert_survives(&warning);
    }
    let rectangle = Rectangle::new(0.5, 0.6).unwrap();
    assert_survives(&rectangle.pair_tensor(&unit_pair(0.3), 0.1, 0.2));
}

#[test]
fn closed_forms_survive_serialisation() {
    let hertz = HertzSphere::new(&unit_pair(0.3), 10.0, 0.1).unwrap();
    assert_survives(&hertz);
    assert_survives(&CattaneoMindlin::new(hertz, 0.3, 0.01).unwrap());
    assert_survives(&MindlinDeresiewicz::new(hertz, 0.3, &[0.01, -0.01, 0.005]).unwrap());
}

#[test]
fn solutions_with_different_times_are_equal() {
    let (_, normal) = pressed();
    let (_, again) = pressed();
    assert_ne!(normal.report(), again.report());
    assert_eq!(normal, again);
}

#[test]
fn coupled_solutions_survive_serialisation() {
    let grid = kit::square(16, 2.6);
    let bodies = HalfSpace::new(grid, kit::on_rigid(1.0, 0.1)).unwrap();
    let (press, load) = (NormalLoad::Force(0.1), TangentialLoad::force([0.01, 0.0]));
    let problem = CoupledProblem::builder(
        &bodies,
        kit::sphere(grid, 10.0),
        kit::coulomb(0.3),
        press,
        load,
    );
    assert_survives(&kit::solve(problem));
}

#[test]
fn history_steps_and_states_survive_serialisation() {
    let (bodies, _) = pressed();
    let builder = History::builder(&bodies, kit::sphere(bodies.grid(), 10.0), kit::coulomb(0.4));
    let mut history = builder.build().unwrap();
    let press = LoadStep::hold().normal(NormalControl::Force(3.0));
    assert_survives(history.step(&press).unwrap());
    let shear = LoadStep::hold().tangential(Axis::X, TangentialControl::Force(0.6));
    let step = history.step(&shear).unwrap();
    assert_survives(step);
    assert_survives(step.energy());

    // The restored bodies are accepted for a history that was saved from the original bodies.
    let [pair, _] = read_back(bodies.pair());
    let [grid, _] = read_back(&bodies.grid());
    let again = HalfSpace::new(grid, pair).unwrap();
    for state in read_back(history.state()) {
        assert_eq!(state.to_bytes(), history.to_bytes());
        let restored = History::from_state(&again, state).unwrap();
        assert_eq!(restored.traction(), history.traction());
    }

    let path = LoadPath::sine([0.5, 0.0], 4).unwrap();
    let outcome = FrettingLoop::new(path, LoadStep::force)
        .run(&mut history, 1)
        .unwrap();
    assert_survives(&outcome);
    assert_survives(&outcome.last.regime().unwrap());
    let mut written = serde_json::to_value(&outcome.last).unwrap();
    written["points"] = json!([]);
    let refused = serde_json::from_value::<Cycle>(written).unwrap_err();
    assert!(refused.to_string().contains("points"), "{refused}");
}

#[test]
fn engine_minima_survive_serialisation() {
    use stickslip::cgm::{NonNegative, Problem, minimise};
    let (bodies, _) = pressed();
    let operator = bodies.operator(Component::ZZ).unwrap();
    let linear = kit::sphere(bodies.grid(), 10.0);
    let problem = Problem::new(operator, [linear.as_slice()], NonNegative).total(10.0);
    let mut x = vec![10.0 / bodies.grid().cells() as f64; bodies.grid().cells()];
    let minimum = minimise(&problem, &Settings::default(), [&mut x]).unwrap();
    assert_survives(&minimum);
    #[cfg(feature = "dense")]
    {
        use stickslip::dense::DenseOperator;
        let matrix = DenseOperator::of_half_space(&bodies, Component::ZZ).unwrap();
        let minimum = matrix.minimise(linear.as_slice(), &NonNegative, Some(10.0));
        assert_survives(&minimum.unwrap());
    }
}

fn assert_written<T: Serialize + DeserializeOwned + PartialEq + Debug>(value: &T, as_json: &Value) {
    assert_eq!(&serde_json::to_value(value).unwrap(), as_json);
    assert_eq!(&read::<T>(as_json).unwrap(), value);
}

/// Returns the value that was read, or the message of the error.
fn read<T: DeserializeOwned>(value: &Value) -> std::result::Result<T, String> {
    T::deserialize(value).map_err(|error| error.to_string())
}

#[test]
fn fields_are_named_as_constructor_arguments() {
    let grid = Grid::new(2, 1, 0.5, 0.25).unwrap();
    let as_json = json!({"nx": 2, "ny": 1, "dx": 0.5, "dy": 0.25});
    assert_written(&grid, &as_json);
    let field = Field::from_vec(grid, vec![1.5, f64::INFINITY]).unwrap();
    assert_written(
        &field,
        &json!({"grid": as_json, "samples": [1.5, "Infinity"]}),
    );
    let steel = json!({"youngs_modulus": 213e9, "poisson_ratio": 0.29, "hardness": "Infinity", "layers": []});
    let rigid = json!({"youngs_modulus": "Infinity", "poisson_ratio": 0.0, "hardness": "Infinity", "layers": []});
    let pair = ElasticPair::new(Table2::pair().bodies()[0], Material::rigid()).unwrap();
    assert_written(&pair, &json!({"bodies": [steel, rigid], "kernel": null}));
    assert_written(
        &Friction::coulomb(0.5)
            .unwrap()
            .max_shear_stress(300e6)
            .unwrap(),
        &json!({"coefficient": {"Uniform": 0.5}, "max_shear_stress": 300e6}),
    );
    assert_written(
        &LoadPath::table(vec![[1.0, 0.0], [0.5, -1.0]]).unwrap(),
        &json!({"steps": [[1.0, 0.0], [0.5, -1.0]]}),
    );
}

/// People and other programs write whole numbers without a decimal point.
#[test]
fn whole_numbers_are_accepted() {
    let grid = json!({"nx": 2, "ny": 1, "dx": 1, "dy": 2});
    let field: Field = read(&json!({"grid": grid, "samples": [7, -3]})).unwrap();
    assert_eq!(field.as_slice(), [7.0, -3.0]);
    let steel: Material = read(&json!({"youngs_modulus": 213, "poisson_ratio": 0})).unwrap();
    assert_eq!(steel, Material::new(213.0, 0.0).unwrap());
}

#[test]
fn omitted_options_have_defaults() {
    let friction: Friction = read(&json!({"coefficient": {"Uniform": 0.5}})).unwrap();
    assert_eq!(friction, kit::coulomb(0.5));
    let settings: Settings = read(&json!({"tolerance": 1e-6})).unwrap();
    assert_eq!(settings, Settings::default().tolerance(1e-6));
    let step: LoadStep = read(&json!({"normal": {"Force": 100}})).unwrap();
    assert_eq!(step, LoadStep::hold().normal(NormalControl::Force(100.0)));
    let rough: SelfAffine = read(&json!({"target": {"rms_height": 0.5}})).unwrap();
    assert_eq!(rough, SelfAffine::with_rms_height(0.5));

    // A misspelt option must not count as an omitted option.
    for problem in [
        read::<Friction>(&json!({"coefficient": {"Uniform": 0.5}, "cap": 1.0})).unwrap_err(),
        read::<Settings>(&json!({"tolerence": 1e-6})).unwrap_err(),
        read::<LoadStep>(&json!({"twists": 1.0})).unwrap_err(),
        read::<SelfAffine>(&json!({"target": {"rms_height": 0.5}, "sead": 1})).unwrap_err(),
    ] {
        assert!(problem.contains("unknown field"), "{problem}");
    }
}

/// Changes one entry of the serialised value and returns the message of the error of its deserialisation.
fn error_after_change<T: Serialize + DeserializeOwned + Debug>(
    value: &T,
    place: &str,
    to: Value,
) -> String {
    let mut written = serde_json::to_value(value).unwrap();
    *written.pointer_mut(place).unwrap() = to;
    read::<T>(&written).unwrap_err()
}

#[test]
fn inconsistent_solutions_are_rejected() {
    let (bodies, normal) = pressed();
    let is = |problem: String, words: &str| assert!(problem.contains(words), "{problem}");
    let dx = "/gap/grid/dx";
    is(
        error_after_change(&normal, dx, json!(0.4)),
        "gap is on a grid of [24, 20] cells of sides [0.4, 0.6], expected [24, 20] cells of sides [0.5, 0.6]",
    );
    let first = "/pressure/samples/0";
    is(
        error_after_change(&normal, first, json!(-2.5)),
        "pressure at index 0 is -2.5",
    );
    let gap = error_after_change(&normal, "/gap/samples/3", json!("NaN"));
    is(gap, "gap at index 3 is NaN");

    let shear = sheared(&bodies, &normal, TangentialModel::Scalar).unwrap();
    let spots = error_after_change(&normal.spots().unwrap(), "/grid/ny", json!(19));
    is(spots, "labels has 480 entries, expected 456");
    let spots = error_after_change(&normal.spots().unwrap(), "/labels/7", json!(99));
    is(
        spots,
        "number of contact spots must be at least 99.0 (the largest label of a cell)",
    );
    let slip = error_after_change(&shear, "/slip/1/grid/ny", json!(19));
    is(slip, "field has 480 entries, expected 456");
    let zones = error_after_change(&shear, "/zones", json!(["Stick", "Slip"]));
    is(zones, "zones has 2 entries, expected 480");
    let slip = error_after_change(&shear, "/slip/1/samples/7", json!("Infinity"));
    is(slip, "slip at index 7 is inf");

    let ball = kit::sphere(bodies.grid(), 10.0);
    let builder = History::builder(&bodies, &ball, kit::coulomb(0.4));
    let mut history = builder.build().unwrap();
    let press = LoadStep::hold().normal(NormalControl::Force(3.0));
    history.step(&press).unwrap();
    let length = error_after_change(
        history.last_step().unwrap(),
        "/slip_distance/samples/2",
        json!("NaN"),
    );
    is(length, "slip length at index 2 is NaN");
    let grid = error_after_change(
        history.last_step().unwrap(),
        "/dissipated_energy/grid/dy",
        json!(1.0),
    );
    is(
        grid,
        "dissipated energy is on a grid of [24, 20] cells of sides [0.5, 1.0], expected [24, 20]",
    );

    for count in ["/stick_cells", "/slip_cells"] {
        let counted = error_after_change(history.last_step().unwrap(), count, json!(u64::MAX));
        is(
            counted,
            "number of cells must be at least 1.8446744073709552e19 (cells that stick or slip)",
        );
    }

    let bulk = RelativeDisplacement::bulk_strain(bodies.grid(), [[1e-3, 0.0], [0.0, 0.0]]).unwrap();
    let skewed = error_after_change(&bulk, "/strain/0/1", json!(1e-3));
    assert!(skewed.contains("yx must equal xy"), "{skewed}");
    let strain = error_after_change(&bulk, "/strain/0/1", json!("NaN"));
    is(strain, "expected f64");
    let sample = error_after_change(&bulk, "/fields/0/samples/2", json!("NaN"));
    is(sample, "relative displacement along x at index 2 is NaN");

    let spectrum = PowerSpectrum::of(&ball).unwrap();
    let modes = error_after_change(&spectrum, "/modes", json!([]));
    is(modes, "modes has 0 entries");
    let levelled = surface::level(&ball, surface::Form::Mean).unwrap();
    let form = error_after_change(&levelled, "/form/grid/dx", json!(0.4));
    is(
        form,
        "form is on a grid of [24, 20] cells of sides [0.4, 0.6]",
    );
    let edges = normal.edges().unwrap();
    let cell = error_after_change(&edges, "/cells/0/index", json!(1_000_000));
    is(cell, "1000000..1000001 of cells");
    let word = error_after_change(&ball, "/samples/0", json!("nothing"));
    is(word, "\"NaN\", \"Infinity\" or \"-Infinity\"");
}

/// Generates numbers of all magnitudes that JSON can represent.
fn number() -> impl Strategy<Value = f64> {
    prop_oneof![
        -2.0..2.0,
        (-300..300_i32).prop_map(|power| 10_f64.powi(power)),
        Just(0.0),
        Just(-1.0),
    ]
}

/// Generates numbers, including numbers that JSON cannot represent.
fn any_number() -> impl Strategy<Value = f64> {
    prop_oneof![
        4 => number(),
        1 => Just(f64::NAN),
        1 => Just(f64::INFINITY),
        1 => Just(f64::NEG_INFINITY),
    ]
}

/// Asserts that reading from text and from bytes has the same outcome as the constructor.
fn assert_agrees_with_constructor<T>(constructed: Result<T>, text: &Value, parts: &impl Serialize)
where
    T: DeserializeOwned + PartialEq + Debug,
{
    // Values that are not finite have become null in the text.
    let has_null = text.to_string().contains("null");
    let constructed = constructed.map_err(|error| error.to_string());
    if !has_null {
        assert_eq!(read::<T>(text), constructed);
    }
    let bytes = postcard::to_stdvec(parts).unwrap();
    assert_eq!(postcard::from_bytes(&bytes).ok(), constructed.ok());
}

proptest! {
    #[test]
    fn grid_is_read_as_by_constructor(
        nx in prop_oneof![0..5_usize, Just(usize::MAX)], ny in 0..5_usize,
        dx in any_number(), dy in any_number(),
    ) {
        let text = json!({"nx": nx, "ny": ny, "dx": dx, "dy": dy});
        assert_agrees_with_constructor(Grid::new(nx, ny, dx, dy), &text, &(nx, ny, dx, dy));
    }

    #[test]
    fn field_is_read_as_by_constructor(samples in prop::collection::vec(number(), 0..6)) {
        let grid = Grid::new(2, 2, 1.0, 1.0).unwrap();
        let text = json!({"grid": grid, "samples": samples});
        assert_agrees_with_constructor(Field::from_vec(grid, samples.clone()), &text, &(grid, samples));
    }

    #[test]
    fn material_is_read_as_by_constructor(
        modulus in any_number(), nu in prop_oneof![any_number(), -1.0..0.5],
    ) {
        let text = json!({"youngs_modulus": modulus, "poisson_ratio": nu});
        // An infinite modulus denotes a rigid body.
        let constructed = match Material::new(1.0, nu) {
            Ok(_) if modulus == f64::INFINITY => Ok(Material::rigid()),
            _ => Material::new(modulus, nu),
        };
        assert_agrees_with_constructor(constructed, &text, &(modulus, nu, f64::INFINITY, [0_u8; 0].as_slice()));
    }

    #[test]
    fn material_survives_bitwise(modulus in 1e-3..1e12, nu in -0.99..0.5) {
        for material in [Material::new(modulus, nu), Material::from_shear_modulus(modulus, nu)] {
            let material = material.unwrap();
            assert_survives(&material);
            assert_survives(&ElasticPair::new(material, Material::rigid()).unwrap());
            let coated = material.coated(&[Layer::new(2.0 * modulus, nu, 0.1).unwrap()]).unwrap();
            assert_survives(&ElasticPair::new(coated, Material::rigid()).unwrap());
        }
    }

    #[test]
    fn friction_is_read_as_by_constructor(mu in any_number(), cap in any_number()) {
        let constructed = Friction::coulomb(mu).and_then(|friction| friction.max_shear_stress(cap));
        let text = json!({"coefficient": {"Uniform": mu}, "max_shear_stress": cap});
        assert_agrees_with_constructor(constructed, &text, &(0_u32, mu, Some(cap)));
        let field = Field::from_vec(Grid::new(2, 1, 1.0, 1.0).unwrap(), vec![0.5, mu]).unwrap();
        let text = json!({"coefficient": {"PerCell": field}});
        assert_agrees_with_constructor(Friction::per_cell(field.clone()), &text, &(1_u32, field, None::<f64>));
    }

    #[test]
    fn load_path_is_read_as_by_constructor(
        steps in prop::collection::vec([any_number(), any_number()], 0..4),
    ) {
        assert_agrees_with_constructor(LoadPath::table(steps.clone()), &json!({"steps": steps}), &steps);
    }
}
