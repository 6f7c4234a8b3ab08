//! Height, slope and spectral parameters agree with an independent evaluation.
//!
//! The reference values were computed with NumPy 2.4 from the formulas in the docs. They use the whole plane of waves
//! of a complex transform and exactly rounded sums. The developed area was computed with mpmath from triangles in
//! space, to 40 digits.

use std::f64::consts::TAU;

use kit::Random;
use stickslip::surface::{PowerSpectrum, Statistics};
use stickslip::{Error, Field, Grid};

struct Case {
    name: &'static str,
    heights: Field,
    mean_height: f64,
    arithmetic_mean_height: f64,
    rms_height: f64,
    skewness: f64,
    kurtosis: f64,
    highest_peak: f64,
    deepest_valley: f64,
    profile_rms_slope: [f64; 2],
    developed_area_ratio: f64,
    spectral_rms_slope: f64,
    moments: [f64; 3],
    nayak_parameter: f64,
    rms_mean_curvature: f64,
    rings: usize,
    /// Wave number, value and number of modes.
    middle_ring: (f64, f64, usize),
    last_ring: (f64, f64, usize),
}

fn field(nx: usize, ny: usize, dx: f64, dy: f64, f: impl FnMut(f64, f64) -> f64) -> Field {
    Field::from_fn(Grid::new(nx, ny, dx, dy).unwrap(), f)
}

/// Returns heights with even sides and whole periods.
fn waves() -> Field {
    field(16, 12, 0.5, 0.25, |x, y| {
        0.3 + 1.5 * (TAU * (2.0 * x / 8.0) + 0.4).cos()
            + 0.7 * (TAU * (3.0 * x / 8.0 - 2.0 * y / 3.0) + 1.1).cos()
            + 0.2 * (TAU * 5.0 * y / 3.0).cos()
            + 0.1 * (2.0 * TAU * (2.0 * x / 8.0) + 0.3).cos()
    })
}

/// Returns heights with odd sides and all waves.
fn noise() -> Field {
    let mut random = Random(1);
    field(15, 9, 1.0, 1.7, |_, _| {
        let u = random.uniform(-1.0, 1.0);
        u + 0.5 * u * u
    })
}

/// Returns heights in metres, with small numbers, strong skewness and waves of two cells.
fn valleys() -> Field {
    let mut random = Random(2);
    field(32, 8, 0.01, 0.02, |_, _| {
        let u = random.uniform(-1.0, 1.0);
        -1e-6 * (u * u) * (u * u)
    })
}

/// Returns heights of a single column.
fn profile() -> Field {
    let mut random = Random(3);
    field(1, 17, 3.0, 0.5, |_, y| random.uniform(-1.0, 1.0) + 0.1 * y)
}

/// Returns heights far from their datum that are not periodic.
fn far() -> Field {
    let mut random = Random(4);
    field(21, 16, 0.25, 0.5, |x, y| {
        1000.0 + 0.3 * x - 0.2 * y + 0.01 * x * y + 0.05 * random.uniform(-1.0, 1.0)
    })
}

#[expect(clippy::too_many_lines, reason = "a table")]
fn cases() -> [Case; 5] {
    [
        Case {
            name: "waves",
            heights: waves(),
            mean_height: 0.2999999999999999,
            arithmetic_mean_height: 1.020074729832299,
            rms_height: 1.1811011811017718,
            skewness: 0.08988152968808877,
            kurtosis: 1.9778563844390842,
            highest_peak: 2.4815381289760183,
            deepest_valley: 2.206439090352739,
            profile_rms_slope: [2.000162922881283, 2.285350084601412],
            developed_area_ratio: 2.0009953771783824,
            spectral_rms_slope: 3.2676192505907555,
            moments: [1.3950000000000005, 5.338667783415645, 141.9599480945974],
            nayak_parameter: 6.948230975277152,
            rms_mean_curvature: 9.728307427111782,
            rings: 18,
            middle_ring: (7.753137400236095, 1.27601631890936e-34, 6),
            last_ring: (14.049629462081452, 2.0169290202115686e-34, 1),
        },
        Case {
            name: "noise",
            heights: noise(),
            mean_height: 0.19393220381079995,
            arithmetic_mean_height: 0.5001326170293154,
            rms_height: 0.5894703944642357,
            skewness: 0.5727478745945216,
            kurtosis: 2.1586007110268546,
            highest_peak: 1.2970695103118213,
            deepest_valley: 0.6939321777355647,
            profile_rms_slope: [0.7932208609058056, 0.49566163401601854],
            developed_area_ratio: 0.34626083477000835,
            spectral_rms_slope: 1.1526823314142467,
            moments: [0.3474753459498216, 0.6643382785772917, 2.7461962354432927],
            nayak_parameter: 2.162106138543879,
            rms_mean_curvature: 1.3530696546355359,
            rings: 8,
            middle_ring: (2.080920799748935, 0.024572764367008573, 22),
            last_ring: (3.2706969816599605, 0.005029540089786578, 8),
        },
        Case {
            name: "valleys",
            heights: valleys(),
            mean_height: -1.8005127883159594e-07,
            arithmetic_mean_height: 1.9923034668108985e-07,
            rms_height: 2.513782314612711e-07,
            skewness: -1.5511455415507844,
            kurtosis: 4.485596215927082,
            highest_peak: 1.8004907008258165e-07,
            deepest_valley: 8.18516062581853e-07,
            profile_rms_slope: [3.5930969965263975e-05, 1.8384195805847663e-05],
            developed_area_ratio: 8.257544132325011e-10,
            spectral_rms_slope: 5.183931117304071e-05,
            moments: [
                6.319101525259639e-14,
                1.3436570914476715e-09,
                6.213851889483809e-05,
            ],
            nayak_parameter: 2.174900200234135,
            rms_mean_curvature: 0.006436278370551215,
            rings: 18,
            middle_ring: (196.57974512030813, 4.387527682086364e-19, 16),
            last_ring: (351.2407365520363, 3.5195399924153567e-19, 1),
        },
        Case {
            name: "profile",
            heights: profile(),
            mean_height: 0.0358257535387054,
            arithmetic_mean_height: 0.5080727200255092,
            rms_height: 0.6477739922876842,
            skewness: -0.4837880462790353,
            kurtosis: 2.1658658778196216,
            highest_peak: 0.9119547620784727,
            deepest_valley: 1.2089250694243965,
            profile_rms_slope: [0.0, 1.5814630362518145],
            developed_area_ratio: 0.7577997025294986,
            spectral_rms_slope: 2.074860412662962,
            moments: [0.4196111450843247, 2.152522866017959, 36.603937247468245],
            nayak_parameter: 3.3149674598329457,
            rms_mean_curvature: 4.939901297763498,
            rings: 8,
            middle_ring: (3.6959913571644627, 0.02002853228434064, 2),
            last_ring: (5.91358617146314, 0.014077428825161789, 2),
        },
        Case {
            name: "far",
            heights: far(),
            mean_height: 1000.0001721654583,
            arithmetic_mean_height: 0.531879804261977,
            rms_height: 0.6494990432868141,
            skewness: -0.15580877628406067,
            kurtosis: 2.4222987921750065,
            highest_peak: 1.3926820565647822,
            deepest_valley: 1.611572896969191,
            profile_rms_slope: [0.34682479981098324, 0.22019757094483847],
            developed_area_ratio: 0.0800588729911422,
            spectral_rms_slope: 1.8770749663783195,
            moments: [0.4218490072304868, 1.7617052147020846, 74.7569897217157],
            nayak_parameter: 10.161138166776704,
            rms_mean_curvature: 7.0596029029833165,
            rings: 17,
            middle_ring: (7.075743979505475, 0.0001696736179091833, 30),
            last_ring: (13.28591571267071, 1.0345752082287153e-06, 6),
        },
    ]
}

#[track_caller]
fn assert_equal(name: &str, found: f64, expected: f64) {
    let error = (found - expected).abs();
    assert!(
        error <= 1e-12 * expected.abs(),
        "{name}: {found:e} is not {expected:e}"
    );
}

#[test]
fn heights_and_slopes_match_reference() {
    for case in cases() {
        let found = Statistics::of(&case.heights).unwrap();
        let name = case.name;
        assert_equal(name, found.mean_height(), case.mean_height);
        assert_equal(
            name,
            found.arithmetic_mean_height(),
            case.arithmetic_mean_height,
        );
        assert_equal(name, found.rms_height(), case.rms_height);
        assert_equal(name, found.skewness(), case.skewness);
        assert_equal(name, found.kurtosis(), case.kurtosis);
        assert_equal(name, found.highest_peak(), case.highest_peak);
        assert_equal(name, found.deepest_valley(), case.deepest_valley);
        assert_equal(
            name,
            found.height_range(),
            case.highest_peak + case.deepest_valley,
        );
        let [along_x, along_y] = found.profile_rms_slope();
        assert_equal(name, along_x, case.profile_rms_slope[0]);
        assert_equal(name, along_y, case.profile_rms_slope[1]);
        let slope = case.profile_rms_slope[0].hypot(case.profile_rms_slope[1]);
        assert_equal(name, found.finite_difference_rms_slope(), slope);
        assert_equal(name, found.spectral_rms_slope(), case.spectral_rms_slope);
        assert_equal(
            name,
            found.developed_area_ratio(),
            case.developed_area_ratio,
        );
    }
}

#[test]
fn spectra_match_reference() {
    for case in cases() {
        let found = PowerSpectrum::of(&case.heights).unwrap();
        let name = case.name;
        for (moment, expected) in found.moments().into_iter().zip(case.moments) {
            assert_equal(name, moment, expected);
        }
        assert_equal(name, found.nayak_parameter(), case.nayak_parameter);
        assert_equal(name, found.rms_mean_curvature(), case.rms_mean_curvature);
        assert_eq!(found.values().len(), case.rings, "{name}");
        let rings = [
            (case.rings / 2, case.middle_ring),
            (case.rings - 1, case.last_ring),
        ];
        let largest = found.values().iter().copied().fold(0.0, f64::max);
        for (ring, (wave_number, value, modes)) in rings {
            assert_equal(name, found.wave_numbers()[ring], wave_number);
            assert!(
                (found.values()[ring] - value).abs() <= 1e-13 * largest,
                "{name}"
            );
            assert_eq!(found.modes()[ring], modes, "{name}");
        }
    }
}

#[test]
fn spectrum_sums_to_mean_square() {
    for case in cases() {
        let spectrum = PowerSpectrum::of(&case.heights).unwrap();
        let grid = case.heights.grid();
        assert_eq!(spectrum.modes().iter().sum::<usize>(), grid.cells() - 1);
        let rings = spectrum.values().iter().zip(spectrum.modes());
        let sum: f64 = rings.map(|(c, &modes)| c * modes as f64).sum();
        let mean_square = sum * TAU * TAU / grid.area();
        assert_equal(case.name, mean_square, case.rms_height.powi(2));
        assert_equal(case.name, mean_square, case.moments[0]);
    }
}

#[test]
fn finite_differences_underestimate_slope_near_two_cells_per_wave() {
    for (cells, expected) in [(2, 2.0 / std::f64::consts::PI), (8, 0.9744953584)] {
        let period = f64::from(cells);
        let heights = field(32, 32, 1.0, 1.0, |x, _| (TAU * (x + 0.5) / period).cos());
        let found = Statistics::of(&heights).unwrap();
        let periodic = {
            // One more column closes the period, so that all differences are included.
            let closed = field(33, 32, 1.0, 1.0, |x, _| (TAU * x / period).cos());
            Statistics::of(&closed)
                .unwrap()
                .finite_difference_rms_slope()
        };
        let ratio = periodic / found.spectral_rms_slope();
        assert!((ratio - expected).abs() < 1e-9, "{cells} cells: {ratio}");
    }
}

#[test]
fn flat_surface_has_no_skewness_or_kurtosis() {
    for (nx, ny) in [(1, 1), (1, 6), (7, 4)] {
        let flat = field(nx, ny, 0.1, 0.3, |_, _| 0.1);
        let found = Statistics::of(&flat).unwrap();
        assert_equal("mean", found.mean_height(), 0.1);
        for zero in [
            found.arithmetic_mean_height(),
            found.rms_height(),
            found.height_range(),
            found.finite_difference_rms_slope(),
            found.spectral_rms_slope(),
            found.developed_area_ratio(),
        ] {
            assert!(zero.abs() < f64::MIN_POSITIVE, "exactly flat");
        }
        assert!(found.skewness().is_nan() && found.kurtosis().is_nan());
        assert!(PowerSpectrum::of(&flat).unwrap().nayak_parameter().is_nan());
    }
}

#[test]
fn infinite_heights_are_rejected_with_index() {
    let with = |value: f64| {
        let mut heights = noise();
        heights.as_mut_slice()[40] = value;
        heights
    };
    let infinite = with(f64::INFINITY);
    let errors = [
        Statistics::of(&infinite).err(),
        PowerSpectrum::of(&infinite).err(),
        PowerSpectrum::of(&with(f64::NAN)).err(),
    ];
    for error in errors {
        assert!(matches!(error, Some(Error::Sample { index: 40, .. })));
    }
}

#[test]
fn missing_heights_have_no_weight() {
    let grid = Grid::new(7, 5, 0.5, 0.25).unwrap();
    let mut heights = Field::from_fn(grid, |x, y| (3.0 * x + 1.0).sin() + x * y);
    for cell in [0, 9, 16, 34] {
        heights.as_mut_slice()[cell] = f64::NAN;
    }
    let found = Statistics::of(&heights).unwrap();
    assert_eq!(found.measured_points(), 31);
    let measured: Vec<f64> = heights.iter().copied().filter(|z| !z.is_nan()).collect();
    let mean_of = |f: &dyn Fn(f64) -> f64| measured.iter().map(|&z| f(z)).sum::<f64>() / 31.0;
    let mean = mean_of(&|z| z);
    let rms = mean_of(&|z| (z - mean).powi(2)).sqrt();
    assert_equal("mean", found.mean_height(), mean);
    assert_equal(
        "Sa",
        found.arithmetic_mean_height(),
        mean_of(&|z| (z - mean).abs()),
    );
    assert_equal("Sq", found.rms_height(), rms);
    assert_equal(
        "Ssk",
        found.skewness(),
        mean_of(&|z| (z - mean).powi(3)) / rms.powi(3),
    );
    assert_equal(
        "Sku",
        found.kurtosis(),
        mean_of(&|z| (z - mean).powi(4)) / rms.powi(4),
    );
    let highest = measured.iter().copied().fold(f64::MIN, f64::max);
    let deepest = measured.iter().copied().fold(f64::MAX, f64::min);
    assert_equal("Sz", found.height_range(), highest - deepest);
    // Slopes between pairs of measured neighbours.
    let at = |ix: usize, iy: usize| heights.get(ix, iy).unwrap_or(f64::NAN);
    let rms_of = |slopes: Vec<f64>| {
        let known: Vec<f64> = slopes.into_iter().filter(|s| !s.is_nan()).collect();
        (known.iter().map(|s| s * s).sum::<f64>() / known.len() as f64).sqrt()
    };
    let cells = || (0..7).flat_map(|ix| (0..5).map(move |iy| (ix, iy)));
    let along_x = rms_of(
        cells()
            .map(|(ix, iy)| (at(ix + 1, iy) - at(ix, iy)) / 0.5)
            .collect(),
    );
    let along_y = rms_of(
        cells()
            .map(|(ix, iy)| (at(ix, iy + 1) - at(ix, iy)) / 0.25)
            .collect(),
    );
    assert_equal("x", found.profile_rms_slope()[0], along_x);
    assert_equal("y", found.profile_rms_slope()[1], along_y);
    assert!(found.spectral_rms_slope().is_nan());
    // Missing heights do not change the slope and the area of a plane.
    let plane = Field::from_fn(grid, |x, y| 0.3 * x - 0.4 * y);
    let complete = Statistics::of(&plane).unwrap();
    let holed = plane.iter().zip(heights.iter());
    let holed = holed.map(|(z, mask)| if mask.is_nan() { f64::NAN } else { *z });
    let holed = Statistics::of(&Field::from_vec(grid, holed.collect()).unwrap()).unwrap();
    assert_equal("Sdq", holed.finite_difference_rms_slope(), 0.5);
    assert_equal(
        "Sdr",
        holed.developed_area_ratio(),
        complete.developed_area_ratio(),
    );
}

#[test]
fn surface_without_measured_heights_or_pairs_is_undetermined() {
    let grid = Grid::new(4, 3, 1.0, 1.0).unwrap();
    let mut heights = Field::constant(grid, f64::NAN);
    let nothing = Statistics::of(&heights);
    assert!(matches!(nothing, Err(Error::Undetermined { known: 0, .. })));
    heights.as_mut_slice()[5] = 2.0;
    let single = Statistics::of(&heights).unwrap();
    assert_eq!(
        (
            single.measured_points(),
            single.mean_height(),
            single.rms_height()
        ),
        (1, 2.0, 0.0)
    );
    assert!(
        single.finite_difference_rms_slope().is_nan() && single.developed_area_ratio().is_nan()
    );
}
