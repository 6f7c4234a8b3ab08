//! Shapes, generated and measured surfaces, load paths and wear laws reject invalid parameters by name and value.

use kit::refusal::Rule::{Finite, NonNegative};
use kit::refusal::{assert_checked, extreme, mismatch};
use kit::unit_bodies;
use stickslip::history::wear::{self, CycleJump};
use stickslip::history::{Cycle, LoadPath};
use stickslip::io::{csv, npy};
use stickslip::surface::{self, PowerSpectrum, SelfAffine, Statistics};
use stickslip::{Error, Field, Grid, History, LoadStep};

fn grid() -> Grid {
    Grid::new(12, 9, 0.5, 0.7).unwrap()
}

#[test]
fn shapes_with_invalid_parameters_are_rejected() {
    let grid = grid();
    let size = |shape: Result<Field, Error>| shape.map(|field| extreme(&field));
    kit::assert_all_checked! {
        Positive "radius must" => |value| size(surface::sphere(grid, value)),
        Positive "radius along x" => |value| size(surface::ellipsoid(grid, value, 1.0)),
        Positive "radius along y" => |value| size(surface::ellipsoid(grid, 1.0, value)),
        Positive "radius" => |value| size(surface::cylinder(grid, value)),
        Positive "slope" => |value| size(surface::cone(grid, value)),
        Positive "radius" => |value| size(surface::flat_punch(grid, value, 1.0)),
        Positive "recess" => |value| size(surface::flat_punch(grid, 1.0, value)),
        Positive "amplitude" => |value| size(surface::sinusoidal(grid, value, 1.0)),
        Positive "wavelength" => |value| size(surface::sinusoidal(grid, 1.0, value)),
    }
    let both = |amplitude, wavelengths| size(surface::bisinusoidal(grid, amplitude, wavelengths));
    kit::assert_all_checked! {
        Positive "amplitude" => |value| both(value, [2.0; 2]),
        Positive "wavelength along x" => |value| both(1.0, [value, 2.0]),
        Positive "wavelength along y" => |value| both(1.0, [2.0, value]),
    }
    let curved = |curvatures| size(surface::paraboloid(grid, curvatures));
    assert_checked("curvature xx", Finite, |value| curved([value, 0.0, 1.0]));
    assert_checked("curvature xy", Finite, |value| curved([1.0, value, 1.0]));
    assert_checked("curvature yy", Finite, |value| curved([1.0, 0.0, value]));
}

#[test]
fn generated_surfaces_with_invalid_parameters_are_rejected() {
    let grid = grid();
    let size = |surface: SelfAffine| surface.generate(grid).map(|rough| extreme(rough.heights()));
    let one = || SelfAffine::with_rms_height(1.0);
    kit::assert_all_checked! {
        Positive "height" => |value| size(SelfAffine::with_rms_height(value)),
        Positive "slope" => |value| size(SelfAffine::with_rms_slope(value)),
        NonNegative "Hurst" => |value| size(one().hurst(value)),
        Positive "wavelength" => |value| size(one().longest_wavelength(value)),
        Positive "wavelength" => |value| size(one().roll_off_wavelength(value)),
        Positive "wavelength" => |value| size(one().cut_off_wavelength(value)),
        Finite "skewness" => |value| size(one().skewness(value)),
        Finite "kurtosis" => |value| size(one().kurtosis(value)),
    }
}

/// Computes quantities of a surface. Each result is a finite number or an error.
fn measure(heights: &Field) -> Vec<Result<f64, Error>> {
    let field = |made: Result<Field, Error>| made.map(|field| extreme(&field));
    vec![
        Statistics::of(heights).map(|s| s.rms_height() + s.spectral_rms_slope()),
        PowerSpectrum::of(heights).map(|spectrum| spectrum.moments().iter().sum()),
        field(surface::gap_from_heights(heights)),
        field(surface::gap_between(heights, &Field::zeros(heights.grid()))),
        field(surface::resample(heights, kit::square(3, 1.0))),
    ]
}

#[test]
fn measured_surfaces_that_are_not_finite_are_rejected() {
    for value in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        let mut heights = Field::from_fn(grid(), |x, y| x * y);
        heights.as_mut_slice()[17] = value;
        let mut outcomes = measure(&heights);
        if value.is_nan() {
            // Statistics skip missing heights; the spectral slope in the sum is then unknown.
            assert!(outcomes.remove(0).is_ok_and(f64::is_nan));
        }
        for outcome in outcomes {
            let Err(Error::Sample {
                index, value: v, ..
            }) = outcome
            else {
                panic!("{value} gives {outcome:?}");
            };
            assert!(index == 17 && v.to_bits() == value.to_bits());
        }
    }
    // Quantities that overflow are rejected or left out of the result.
    for height in [1e300, 1e308, 5e-324] {
        let heights = Field::from_fn(grid(), |x, _| height * x.signum());
        for (k, outcome) in measure(&heights).into_iter().enumerate() {
            assert!(
                outcome.as_ref().map_or(true, |z| z.is_finite()),
                "{k} {height:e} {outcome:?}"
            );
        }
    }
    let other = Field::zeros(Grid::new(9, 12, 0.5, 0.7).unwrap());
    let heights = Field::zeros(grid());
    let refused = [
        surface::gap_between(&other, &heights),
        surface::sum(&[&heights, &other]),
    ];
    let [upper, summand] = refused.map(Result::unwrap_err);
    assert_eq!(upper, mismatch("upper surface", grid(), other.grid()));
    assert_eq!(summand, mismatch("a summand", grid(), other.grid()));
}

#[test]
fn files_with_invalid_cell_sides_are_rejected() {
    let text = b"1,2\n3,4\n";
    let binary = npy::to_bytes(&Field::zeros(grid()));
    let size = |field: Field| extreme(&field);
    kit::assert_all_checked! {
        Positive "cell side dx" => |side| csv::parse(text, [side, 1.0]).map(size),
        Positive "cell side dy" => |side| csv::parse(text, [1.0, side]).map(size),
        Positive "cell side dx" => |side| npy::parse(&binary, [side, 1.0]).map(size),
        Positive "cell side dy" => |side| npy::parse(&binary, [1.0, side]).map(size),
    }
    // The sides are checked before the file is opened.
    let refused = npy::read("no_such_file.npy", [0.0, 1.0]);
    assert!(matches!(refused, Err(Error::NotPositive { .. })));
    let refused = csv::read("no_such_file.csv", [1.0, f64::NAN]);
    assert!(matches!(refused, Err(Error::NotPositive { .. })));
}

#[test]
fn load_paths_with_invalid_amplitudes_are_rejected() {
    let last = |path: LoadPath| {
        path.steps()
            .iter()
            .flatten()
            .fold(0.0_f64, |a, b| a.max(b.abs()))
    };
    kit::assert_all_checked! {
        Finite "amplitude along x" => |value| LoadPath::sine([value, 1.0], 8).map(last),
        Finite "amplitude along y" => |value| LoadPath::sine([1.0, value], 8).map(last),
        Finite "amplitude along x" => |value| LoadPath::triangle([value, 1.0], 8).map(last),
        Finite "phase" => |value| { LoadPath::ellipse([1.0; 2], value, 8).map(last) },
        Finite "load path" => |value| LoadPath::table(vec![[0.0, value]]).map(last),
    }
}

/// The depth is a field that belongs to the caller.
#[test]
fn wear_law_rejected_input_leaves_depth_unchanged() {
    let bodies = unit_bodies(grid(), 0.3);
    let ones = Field::constant(grid(), 1.0);
    let depth = Field::from_fn(grid(), |x, y| x + 2.0 * y);
    let kept = |wear: &dyn Fn(&mut Field) -> Result<(), Error>| {
        let mut worn = depth.clone();
        let outcome = wear(&mut worn);
        assert!(outcome.is_ok() || worn == depth);
        outcome.map(|()| extreme(&worn))
    };
    kit::assert_all_checked! {
        NonNegative "wear coefficient" => |k| kept(&|d| wear::archard(k, &ones, &ones, d)),
        NonNegative "wear coefficient" => |k| kept(&|d| wear::energy(k, &ones, d)),
    }
    let with = |value| {
        let mut field = ones.clone();
        field.as_mut_slice()[40] = value;
        field
    };
    kit::assert_all_checked! {
        NonNegative "pressure" => |p| kept(&|d| wear::archard(1.0, &with(p), &ones, d)),
        NonNegative "slip length" => |s| kept(&|d| wear::archard(1.0, &ones, &with(s), d)),
        NonNegative "dissipated energy" => |e| kept(&|d| wear::energy(1.0, &with(e), d)),
        NonNegative "threshold of dissipated energy" => |e| kept(&|d| wear::threshold_energy(1.0, e, &ones, &ones, d)),
        NonNegative "accumulated energy" => |e| kept(&|d| wear::threshold_energy(1.0, 0.5, &with(e), &ones, d)),
    }
    kit::assert_refused! { kept(&|d| wear::archard(1e200, &with(1e200), &ones, d)) => Error::NotFinite { .. } }
    let small = Grid::new(12, 9, 1e-160, 1e-140).unwrap();
    let energy = wear::energy(1e20, &Field::zeros(small), &mut Field::zeros(small));
    assert!(matches!(energy, Err(Error::NotFinite { .. })));
    let other = Field::zeros(small);
    let refused = kept(&|d| wear::archard(1.0, &ones, &other, d)).unwrap_err();
    assert_eq!(refused, mismatch("slip length", grid(), small));

    assert_checked("wear coefficient", NonNegative, |k| {
        Ok(1.0 / wear::max_stable_cycles(&bodies, k, &ones)?)
    });
    let refused = wear::max_stable_cycles(&bodies, 1.0, &other).unwrap_err();
    assert_eq!(refused, mismatch("slip length", grid(), small));
}

#[test]
fn cycle_jumps_with_invalid_limits_are_rejected() {
    let bodies = unit_bodies(grid(), 0.3);
    let (gap, friction) = (Field::zeros(grid()), kit::coulomb(0.5));
    let mut history = History::builder(&bodies, &gap, friction).build().unwrap();
    let mut cycle = Cycle::new(&history);
    history.step(&LoadStep::hold()).unwrap();
    cycle.add(&history).unwrap();
    let jump = CycleJump::new(&bodies, &cycle, &Field::constant(grid(), 4e-9)).unwrap();
    kit::assert_all_checked! {
        NonNegative "largest depth" => |depth| jump.largest_depth(depth).cycles_left(1000.0).cycles(),
        NonNegative "number of cycles left" => |left| jump.cycles_left(left).cycles(),
    }
    assert_checked("depth of the cycle", NonNegative, |depth| {
        let jump = CycleJump::new(&bodies, &cycle, &Field::constant(grid(), depth))?;
        jump.largest_depth(1.0).cycles_left(1000.0).cycles()
    });
}
