//! What is plain comes back from any format to the last bit, and what its constructor would refuse is
//! refused, by the same words.

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
use stickslip::surface::{self, Amplitudes, PowerSpectrum, SelfAffine, Statistics};
use stickslip::tangential::RelativeDisplacement;
use stickslip::{
    Axis, CoupledProblem, ElasticPair, Field, Friction, Grid, HalfSpace, History, LoadStep,
    Material, NormalControl, NormalProblem, NormalSolution, Result, Status, TangentialControl,
    TangentialLoad, TangentialModel, TangentialProblem, TangentialSolution, Warning, Zone,
};

/// What is read from text and from bytes, to the last bit but for the sign of what is no number.
fn read_back<T: Serialize + DeserializeOwned>(value: &T) -> [T; 2] {
    let text = serde_json::to_string(value).unwrap();
    let from_text = serde_json::from_str(&text).unwrap();
    assert_eq!(serde_json::to_string(&from_text).unwrap(), text);
    let bytes = postcard::to_stdvec(value).unwrap();
    let from_bytes = postcard::from_bytes(&bytes).unwrap();
    assert_eq!(postcard::to_stdvec(&from_bytes).unwrap(), bytes, "{text}");
    [from_text, from_bytes]
}

fn survives<T: Serialize + DeserializeOwned + PartialEq + Debug>(value: &T) {
    for read in read_back(value) {
        assert_eq!(&read, value);
    }
}

fn grid() -> Grid {
    Grid::new(5, 3, 0.1, 0.7 / 3.0).unwrap()
}

#[test]
fn scenes() {
    survives(&grid());
    survives(&Field::from_fn(grid(), |x, y| (x + 0.1 * y).sin()));
    let missing = [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, -0.0, 1e-310];
    let holes = Field::from_vec(Grid::new(5, 1, 1.0, 1.0).unwrap(), missing.to_vec()).unwrap();
    read_back(&holes);

    for boundary in kit::boundaries(grid()) {
        survives(&boundary);
    }
    let odd = Material::from_shear_modulus(200.0 / 3.0, 0.42).unwrap();
    for material in [odd, Material::rigid()] {
        survives(&material);
        survives(&ElasticPair::new(material, odd).unwrap());
    }
    survives(&odd.with_hardness(1.0 / 3.0).unwrap());
    survives(&Table2::pair());
    survives(&Hardness::uniform(1.0 / 3.0).unwrap());
    survives(&Hardness::per_cell(Field::constant(grid(), 1.0 / 3.0)).unwrap());
    for friction in [
        Friction::coulomb(0.1).unwrap(),
        Friction::per_cell(Field::constant(grid(), 1.0 / 3.0)).unwrap(),
    ] {
        survives(&friction);
        survives(&friction.max_shear_stress(0.3).unwrap());
    }
}

#[test]
fn loads_and_options() {
    for load in [NormalControl::Force(0.1), NormalControl::Approach(-0.1)] {
        survives(&load);
    }
    for load in [
        TangentialLoad::force([0.1, -0.2]),
        TangentialLoad::shift([0.3, 0.0]),
    ] {
        survives(&load);
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
            survives(&step);
            survives(&step.twist(0.1));
        }
    }
    survives(&LoadPath::ellipse([0.1, 0.2], 0.3, 12).unwrap());
    let strain = [[1e-3, 0.0], [2e-3 / 3.0, 0.0]];
    let bulk = RelativeDisplacement::bulk_strain(grid(), strain).unwrap();
    survives(&bulk);
    let written = serde_json::to_value(&bulk).unwrap();
    assert_eq!(written["strain"], json!(strain));
    for axis in [Axis::X, Axis::Y] {
        survives(&axis);
    }
    for lateral in [TangentialModel::Scalar, TangentialModel::Vector] {
        survives(&lateral);
    }
    for method in [Method::ActiveSet, Method::PolonskyKeer] {
        let settings = Settings::default().method(method).tolerance(1e-7 / 3.0);
        survives(&settings);
        survives(&settings.time_limit(Duration::new(3, 141_592_653)));
    }
    for component in Component::ALL {
        survives(&component);
    }
}

#[test]
fn surfaces() {
    for amplitudes in [Amplitudes::Exact, Amplitudes::Gaussian] {
        let height = SelfAffine::with_rms_height(0.1).amplitudes(amplitudes);
        survives(&height);
        let slope = SelfAffine::with_rms_slope(0.3).hurst(0.7).seed(u64::MAX);
        let band = slope.longest_wavelength(0.9).roll_off_wavelength(0.8);
        let all = band.cut_off_wavelength(0.2).skewness(-0.1).kurtosis(3.1);
        survives(&all.amplitudes(amplitudes).cropped());
    }
    let heights = rough(Grid::square(16, 1.0).unwrap(), 3);
    survives(&Statistics::of(&heights).unwrap());
    survives(&PowerSpectrum::of(&heights).unwrap());
    // A flat surface has no skewness.
    read_back(&Statistics::of(&Field::zeros(grid())).unwrap());
    for form in [
        surface::Form::Mean,
        surface::Form::Plane,
        surface::Form::Polynomial(3),
    ] {
        survives(&form);
    }
}

/// A contact, pressed and not yet sheared.
fn pressed() -> (HalfSpace, NormalSolution) {
    let grid = Grid::new(24, 20, 0.5, 0.6).unwrap();
    let bodies = unit_bodies(grid, 0.3);
    let ball = surface::sphere(grid, 10.0).unwrap();
    let problem = NormalProblem::builder(&bodies, &ball, NormalControl::Force(3.0));
    let normal = problem.build().unwrap().solve().unwrap();
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
fn answers_and_what_is_said_about_them() {
    let (bodies, normal) = pressed();
    survives(&normal);
    survives(normal.report());
    survives(&normal.report().history[0]);
    survives(&normal.spots());
    for zone in [Zone::Separated, Zone::Stick, Zone::Slip] {
        survives(&zone);
    }
    let [read, _] = read_back(&normal);
    for lateral in [TangentialModel::Scalar, TangentialModel::Vector] {
        let shear = sheared(&bodies, &normal, lateral).unwrap();
        survives(&shear);
        // A pressure that was read is as good as one that was solved for.
        let again = sheared(&bodies, &read, lateral).unwrap();
        assert_eq!(shear.traction(), again.traction());
    }

    let friction = Friction::coulomb(0.3).unwrap();
    let rolling = RollingProblem::builder(&bodies, &normal, friction).creepage([0.01, 0.02]);
    let mut solver = rolling.build().unwrap().into_solver().unwrap();
    let mut rolling = solver.new_solution();
    survives(&rolling);
    solver.solve_into(&mut rolling).unwrap();
    survives(&rolling);
    let mut short = serde_json::to_value(&rolling).unwrap();
    short["zones"].as_array_mut().unwrap().pop();
    let refused = serde_json::from_value::<RollingSolution>(short).unwrap_err();
    assert!(refused.to_string().contains("zones"), "{refused}");

    // Before any solve residuals are infinite.
    let flat = Field::zeros(bodies.grid());
    let problem = NormalProblem::builder(&bodies, &flat, NormalControl::Force(1.0));
    let solver = problem.build().unwrap().into_solver().unwrap();
    survives(&solver.new_solution());
    for status in [
        Status::Unsolved,
        Status::Converged,
        Status::IterationLimit,
        Status::TimeLimit,
        Status::Stalled,
        Status::Cancelled,
    ] {
        survives(&status);
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
        survives(&warning);
    }
    let rectangle = Rectangle::new(0.5, 0.6).unwrap();
    survives(&rectangle.pair_tensor(&unit_pair(0.3), 0.1, 0.2));
}

#[test]
fn closed_forms() {
    let hertz = HertzSphere::new(&unit_pair(0.3), 10.0, 0.1).unwrap();
    survives(&hertz);
    survives(&CattaneoMindlin::new(hertz, 0.3, 0.01).unwrap());
    survives(&MindlinDeresiewicz::new(hertz, 0.3, &[0.01, -0.01, 0.005]).unwrap());
}

#[test]
fn answers_are_equal_whatever_their_time() {
    let (_, normal) = pressed();
    let (_, again) = pressed();
    assert_ne!(normal.report(), again.report());
    assert_eq!(normal, again);
}

#[test]
fn answers_of_dissimilar_bodies() {
    let grid = Grid::square(16, 2.6).unwrap();
    let pair = ElasticPair::new(Material::new(1.0, 0.1).unwrap(), Material::rigid()).unwrap();
    let bodies = HalfSpace::new(grid, pair).unwrap();
    let gap = surface::sphere(grid, 10.0).unwrap();
    let friction = Friction::coulomb(0.3).unwrap();
    let (press, load) = (
        NormalControl::Force(0.1),
        TangentialLoad::force([0.01, 0.0]),
    );
    let problem = CoupledProblem::builder(&bodies, &gap, friction, press, load);
    survives(&problem.build().unwrap().solve().unwrap());
}

#[test]
fn steps_of_a_history_and_what_it_goes_on_from() {
    let (bodies, _) = pressed();
    let ball = surface::sphere(bodies.grid(), 10.0).unwrap();
    let friction = Friction::coulomb(0.4).unwrap();
    let builder = History::builder(&bodies, &ball, friction);
    let mut history = builder.build().unwrap();
    survives(history.last_step());
    let press = LoadStep::hold().normal(NormalControl::Force(3.0));
    history.step(&press).unwrap();
    let shear = LoadStep::hold().tangential(Axis::X, TangentialControl::Force(0.6));
    let step = history.step(&shear).unwrap();
    survives(step);
    survives(step.energy());

    // Bodies that were read are those a history was saved from.
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
    survives(&outcome);
    survives(&outcome.last.regime());
    let mut written = serde_json::to_value(&outcome.last).unwrap();
    written["points"] = json!([]);
    let refused = serde_json::from_value::<Cycle>(written).unwrap_err();
    assert!(refused.to_string().contains("points"), "{refused}");
}

#[test]
fn minima_of_the_engines() {
    use stickslip::cgm::{NonNegative, Problem, minimise};
    let (bodies, _) = pressed();
    let operator = bodies.operator(Component::ZZ).unwrap();
    let linear = surface::sphere(bodies.grid(), 10.0).unwrap();
    let problem = Problem::new(operator, [linear.as_slice()], NonNegative).total(10.0);
    let mut x = vec![10.0 / bodies.grid().cells() as f64; bodies.grid().cells()];
    let minimum = minimise(&problem, &Settings::default(), [&mut x]).unwrap();
    survives(&minimum);
    #[cfg(feature = "dense")]
    {
        use stickslip::dense::DenseOperator;
        let matrix = DenseOperator::of_half_space(&bodies, Component::ZZ).unwrap();
        let minimum = matrix.minimise(linear.as_slice(), &NonNegative, Some(10.0));
        survives(&minimum.unwrap());
    }
}

fn is_written<T: Serialize + DeserializeOwned + PartialEq + Debug>(value: &T, as_json: &Value) {
    assert_eq!(&serde_json::to_value(value).unwrap(), as_json);
    assert_eq!(&read::<T>(as_json).unwrap(), value);
}

/// What is read, or why not.
fn read<T: DeserializeOwned>(value: &Value) -> std::result::Result<T, String> {
    T::deserialize(value).map_err(|error| error.to_string())
}

#[test]
fn by_the_words_of_their_constructors() {
    let grid = Grid::new(2, 1, 0.5, 0.25).unwrap();
    let as_json = json!({"nx": 2, "ny": 1, "dx": 0.5, "dy": 0.25});
    is_written(&grid, &as_json);
    let field = Field::from_vec(grid, vec![1.5, f64::INFINITY]).unwrap();
    is_written(
        &field,
        &json!({"grid": as_json, "samples": [1.5, "Infinity"]}),
    );
    let steel = json!({"youngs_modulus": 213e9, "poisson_ratio": 0.29, "hardness": "Infinity", "layers": []});
    let rigid = json!({"youngs_modulus": "Infinity", "poisson_ratio": 0.0, "hardness": "Infinity", "layers": []});
    let pair = ElasticPair::new(Table2::pair().bodies()[0], Material::rigid()).unwrap();
    is_written(&pair, &json!({"bodies": [steel, rigid], "kernel": null}));
    is_written(
        &Friction::coulomb(0.5)
            .unwrap()
            .max_shear_stress(300e6)
            .unwrap(),
        &json!({"coefficient": {"Uniform": 0.5}, "max_shear_stress": 300e6}),
    );
    is_written(
        &LoadPath::table(vec![[1.0, 0.0], [0.5, -1.0]]).unwrap(),
        &json!({"steps": [[1.0, 0.0], [0.5, -1.0]]}),
    );
}

/// People and other programs write a whole number without a point.
#[test]
fn whole_numbers_are_numbers() {
    let grid = json!({"nx": 2, "ny": 1, "dx": 1, "dy": 2});
    let field: Field = read(&json!({"grid": grid, "samples": [7, -3]})).unwrap();
    assert_eq!(field.as_slice(), [7.0, -3.0]);
    let steel: Material = read(&json!({"youngs_modulus": 213, "poisson_ratio": 0})).unwrap();
    assert_eq!(steel, Material::new(213.0, 0.0).unwrap());
}

#[test]
fn what_is_left_out_has_its_default() {
    let friction: Friction = read(&json!({"coefficient": {"Uniform": 0.5}})).unwrap();
    assert_eq!(friction, Friction::coulomb(0.5).unwrap());
    let settings: Settings = read(&json!({"tolerance": 1e-6})).unwrap();
    assert_eq!(settings, Settings::default().tolerance(1e-6));
    let step: LoadStep = read(&json!({"normal": {"Force": 100}})).unwrap();
    assert_eq!(step, LoadStep::hold().normal(NormalControl::Force(100.0)));
    let rough: SelfAffine = read(&json!({"target": {"rms_height": 0.5}})).unwrap();
    assert_eq!(rough, SelfAffine::with_rms_height(0.5));

    // So a misspelt option is no option left out.
    for problem in [
        read::<Friction>(&json!({"coefficient": {"Uniform": 0.5}, "cap": 1.0})).unwrap_err(),
        read::<Settings>(&json!({"tolerence": 1e-6})).unwrap_err(),
        read::<LoadStep>(&json!({"twists": 1.0})).unwrap_err(),
        read::<SelfAffine>(&json!({"target": {"rms_height": 0.5}, "sead": 1})).unwrap_err(),
    ] {
        assert!(problem.contains("unknown field"), "{problem}");
    }
}

/// Changes one place of what was written, and returns why it is then refused.
fn spoilt<T: Serialize + DeserializeOwned + Debug>(value: &T, place: &str, to: Value) -> String {
    let mut written = serde_json::to_value(value).unwrap();
    *written.pointer_mut(place).unwrap() = to;
    read::<T>(&written).unwrap_err()
}

#[test]
fn answers_that_contradict_themselves_are_refused() {
    let (bodies, normal) = pressed();
    let is = |problem: String, words: &str| assert!(problem.contains(words), "{problem}");
    let dx = "/gap/grid/dx";
    is(
        spoilt(&normal, dx, json!(0.4)),
        "gap lives on [24, 20] cells of sides [0.4, 0.6], expected [24, 20] of [0.5, 0.6]",
    );
    let first = "/pressure/samples/0";
    is(
        spoilt(&normal, first, json!(-2.5)),
        "pressure at index 0 is -2.5",
    );
    let gap = spoilt(&normal, "/gap/samples/3", json!("NaN"));
    is(gap, "gap at index 3 is NaN");

    let shear = sheared(&bodies, &normal, TangentialModel::Scalar).unwrap();
    let spots = spoilt(&normal.spots(), "/grid/ny", json!(19));
    is(spots, "labels has 480 entries, expected 456");
    let spots = spoilt(&normal.spots(), "/labels/7", json!(99));
    is(
        spots,
        "number of contact spots must be at least 99.0 (the largest label)",
    );
    let slip = spoilt(&shear, "/slip/1/grid/ny", json!(19));
    is(slip, "field has 480 entries, expected 456");
    let zones = spoilt(&shear, "/zones", json!(["Stick", "Slip"]));
    is(zones, "zones has 2 entries, expected 480");
    let slip = spoilt(&shear, "/slip/1/samples/7", json!("Infinity"));
    is(slip, "slip at index 7 is inf");

    let ball = surface::sphere(bodies.grid(), 10.0).unwrap();
    let friction = Friction::coulomb(0.4).unwrap();
    let history = History::builder(&bodies, &ball, friction).build().unwrap();
    let length = spoilt(
        history.last_step(),
        "/slip_distance/samples/2",
        json!("NaN"),
    );
    is(length, "slip length at index 2 is NaN");
    let grid = spoilt(
        history.last_step(),
        "/dissipated_energy/grid/dy",
        json!(1.0),
    );
    is(
        grid,
        "dissipated energy lives on [24, 20] cells of sides [0.5, 1.0], expected [24, 20]",
    );

    for count in ["/stick_cells", "/slip_cells"] {
        let counted = spoilt(history.last_step(), count, json!(u64::MAX));
        is(
            counted,
            "number of cells must be at least 1.8446744073709552e19 (cells that stick or slip)",
        );
    }

    let bulk = RelativeDisplacement::bulk_strain(bodies.grid(), [[1e-3, 0.0], [0.0, 0.0]]).unwrap();
    let strain = spoilt(&bulk, "/strain/0/1", json!("NaN"));
    is(strain, "expected f64");
    let sample = spoilt(&bulk, "/fields/0/samples/2", json!("NaN"));
    is(sample, "relative displacement along x at index 2 is NaN");

    let spectrum = PowerSpectrum::of(&ball).unwrap();
    let modes = spoilt(&spectrum, "/modes", json!([]));
    is(modes, "modes has 0 entries");
    let word = spoilt(&ball, "/samples/0", json!("nothing"));
    is(word, "\"NaN\", \"Infinity\" or \"-Infinity\"");
}

/// Numbers of all kinds that JSON has.
fn number() -> impl Strategy<Value = f64> {
    prop_oneof![
        -2.0..2.0,
        (-300..300_i32).prop_map(|power| 10_f64.powi(power)),
        Just(0.0),
        Just(-1.0),
    ]
}

/// Numbers that it has not, too.
fn any_number() -> impl Strategy<Value = f64> {
    prop_oneof![
        4 => number(),
        1 => Just(f64::NAN),
        1 => Just(f64::INFINITY),
        1 => Just(f64::NEG_INFINITY),
    ]
}

/// As the constructor, in text and in bytes.
fn agrees<T>(constructed: Result<T>, text: &Value, parts: &impl Serialize)
where
    T: DeserializeOwned + PartialEq + Debug,
{
    // What was not finite has become null in the text.
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
    fn grids_as_by_their_constructor(
        nx in prop_oneof![0..5_usize, Just(usize::MAX)], ny in 0..5_usize,
        dx in any_number(), dy in any_number(),
    ) {
        let text = json!({"nx": nx, "ny": ny, "dx": dx, "dy": dy});
        agrees(Grid::new(nx, ny, dx, dy), &text, &(nx, ny, dx, dy));
    }

    #[test]
    fn fields_as_by_their_constructor(samples in prop::collection::vec(number(), 0..6)) {
        let grid = Grid::new(2, 2, 1.0, 1.0).unwrap();
        let text = json!({"grid": grid, "samples": samples});
        agrees(Field::from_vec(grid, samples.clone()), &text, &(grid, samples));
    }

    #[test]
    fn materials_as_by_their_constructor(
        modulus in any_number(), nu in prop_oneof![any_number(), -1.0..0.5],
    ) {
        let text = json!({"youngs_modulus": modulus, "poisson_ratio": nu});
        // An infinite modulus is that of a rigid body.
        let constructed = match Material::new(1.0, nu) {
            Ok(_) if modulus == f64::INFINITY => Ok(Material::rigid()),
            _ => Material::new(modulus, nu),
        };
        agrees(constructed, &text, &(modulus, nu, f64::INFINITY, [0_u8; 0].as_slice()));
    }

    #[test]
    fn materials_to_the_last_bit(modulus in 1e-3..1e12, nu in -0.99..0.5) {
        for material in [Material::new(modulus, nu), Material::from_shear_modulus(modulus, nu)] {
            let material = material.unwrap();
            survives(&material);
            survives(&ElasticPair::new(material, Material::rigid()).unwrap());
            let coated = material.coated(&[Layer::new(2.0 * modulus, nu, 0.1).unwrap()]).unwrap();
            survives(&ElasticPair::new(coated, Material::rigid()).unwrap());
        }
    }

    #[test]
    fn frictions_as_by_their_constructor(mu in any_number(), cap in any_number()) {
        let constructed = Friction::coulomb(mu).and_then(|friction| friction.max_shear_stress(cap));
        let text = json!({"coefficient": {"Uniform": mu}, "max_shear_stress": cap});
        agrees(constructed, &text, &(0_u32, mu, Some(cap)));
        let field = Field::from_vec(Grid::new(2, 1, 1.0, 1.0).unwrap(), vec![0.5, mu]).unwrap();
        let text = json!({"coefficient": {"PerCell": field}});
        agrees(Friction::per_cell(field.clone()), &text, &(1_u32, field, None::<f64>));
    }

    #[test]
    fn load_paths_as_by_their_constructor(
        steps in prop::collection::vec([any_number(), any_number()], 0..4),
    ) {
        agrees(LoadPath::table(steps.clone()), &json!({"steps": steps}), &steps);
    }
}
