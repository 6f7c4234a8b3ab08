//! Contact areas and stick areas of rough surfaces: reference values and properties.

use std::f64::consts::PI;

use approx::assert_relative_eq;
use proptest::prelude::*;
use stickslip::Result;
use stickslip::analytical::{HertzSphere, Persson, RoughSphere, linear_stick_ratio};

use super::{FRICTION, assert_close, ball, rubber, singular_integral};

/// Coefficient, reduced pressure and relative area. The values are the closed form evaluated in extended precision and
/// rounded.
const ROUGH_SPHERE: [[f64; 3]; 18] = [
    [1.5957691216057308, 1e-06, 1.5957691216042946e-06],
    [1.5957691216057308, 0.001, 0.0015957676854149064],
    [1.5957691216057308, 0.00404, 0.006446812551320355],
    [1.5957691216057308, 0.0404, 0.06437451990077739],
    [1.5957691216057308, 0.3, 0.4430818487031201],
    [1.5957691216057308, 2.0, 0.9722222223291517],
    [2.0, 1e-06, 1.9999999999971725e-06],
    [2.0, 0.001, 0.0019999971725708945],
    [2.0, 0.00404, 0.008079813565732464],
    [2.0, 0.0404, 0.0806140210596444],
    [2.0, 0.3, 0.5329541763660276],
    [2.0, 2.0, 0.9823161174342357],
    [2.2, 1e-06, 2.1999999999962367e-06],
    [2.2, 0.001, 0.0021999962366930576],
    [2.2, 0.00404, 0.008887751857278164],
    [2.2, 0.0404, 0.08863259025547224],
    [2.2, 0.3, 0.5730259546030855],
    [2.2, 2.0, 0.985385221020028],
];

/// Coefficient, reduced pressure, area fraction, and stick ratio at each of [`FRACTIONS`], computed as in
/// [`ROUGH_SPHERE`].
#[rustfmt::skip] // one row per line
const ROUGH_PLANE: [[f64; 9]; 16] = [
    [1.5957691216057308, 0.001, 0.0015957680577602879, 0.9000001139999522, 0.8000001919999391,
        0.6000002559999618, 0.4000002239999934, 0.20000012800000547, 0.050000033250002164],
    [1.5957691216057308, 0.01, 0.015956627433803963, 0.9000113995219629, 0.800019199390715,
        0.6000255996176878, 0.40002239993427524, 0.20001280005460387, 0.05000332502166559],
    [1.5957691216057308, 0.1, 0.15851941887820606, 0.9011352225026403, 0.8019139022994649,
        0.6025561582114769, 0.4022393248676055, 0.20128053667782037, 0.05033271434961181],
    [1.5957691216057308, 0.5, 0.6826894921370859, 0.9255741542592806, 0.8441454123296894,
        0.6613457065034065, 0.45532190959551216, 0.23219841626971302, 0.058412517163421336],
    [2.0, 0.001, 0.0019999979056068715, 0.9000001790706633, 0.8000003015927444,
        0.6000004021237654, 0.40000035185836097, 0.2000002010619433, 0.05000005222898321],
    [2.0, 0.01, 0.01999790580227493, 0.9000179058986201, 0.800030157786117,
        0.6000402114426215, 0.4000351856755254, 0.2000201063276993, 0.050005222951241],
    [2.0, 0.1, 0.19792519735479225, 0.9017789240031263, 0.8030008767557214,
        0.6040117329796479, 0.4035168925869935, 0.20201193020495498, 0.050522815388964776],
    [2.0, 0.5, 0.7899085945560628, 0.9376689779729006, 0.8658860970308282,
        0.6936777477826152, 0.485952488560325, 0.25056721590176945, 0.06325705871344524],
    [2.2, 0.001, 0.002199997212363298, 0.9000002166754726, 0.8000003649271825,
        0.600000486569732, 0.40000042574861266, 0.20000024328495483, 0.050000063197071044],
    [2.2, 0.01, 0.021997212677991877, 0.9000216658376214, 0.8000364905391926,
        0.6000486556058457, 0.4000425746261504, 0.20002432869073627, 0.050006319784581595],
    [2.2, 0.1, 0.21724386469943477, 0.902149507375984, 0.8036272305163378,
        0.604851759287924, 0.4042549888800194, 0.20243475741409117, 0.050632737408568426],
    [2.2, 0.5, 0.8319959351192759, 0.9438908333247079, 0.8773318659164594,
        0.7113846156680655, 0.5032240938761997, 0.2611116900087864, 0.06605377722973312],
    [2.5066282746310007, 0.001, 0.002506624151398863, 0.9000002812834343, 0.8000004737406403,
        0.600000631654449, 0.40000055269780643, 0.20000031582737407, 0.05000008204109978],
    [2.5066282746310007, 0.01, 0.02506216011841738, 0.9000281254622459, 0.8000473703917123,
        0.6000631631404547, 0.40005526938434754, 0.20003158306643098, 0.05000820424053914],
    [2.5066282746310007, 0.1, 0.24659992092762825, 0.902783778497267, 0.8047002449387786,
        0.6062929910125031, 0.40552270762844916, 0.2031614565102879, 0.050821695077217476],
    [2.5066282746310007, 0.5, 0.883770034433181, 0.9533644109422, 0.895159239464772,
        0.7400702679448065, 0.532044182265441, 0.27903177446584143, 0.07083442343241288],
];

/// Forces divided by the friction limit.
const FRACTIONS: [f64; 6] = [0.1, 0.2, 0.4, 0.6, 0.8, 0.95];

/// Load, reduced pressure and relative area of table 3 of the paper, for E* = 25 MPa.
const TABLE_3: [[f64; 3]; 4] = [
    [0.00015, 0.0040431, 0.0080860],
    [0.0015, 0.0087105, 0.0174192],
    [0.015, 0.0187663, 0.0375139],
    [0.15, 0.0404308, 0.0806751],
];

fn assert_equal_to_14_digits(found: f64, expected: f64) {
    assert_relative_eq!(found, expected, max_relative = 1e-14, epsilon = 0.0);
}

/// Returns a surface of unit slope at the given reduced pressure.
fn rough_plane(reduced_pressure: f64, area_coefficient: f64) -> Result<Persson> {
    Persson::new(&rubber()?, 1.0, 25e6 * reduced_pressure)?.with_area_coefficient(area_coefficient)
}

#[test]
fn rough_spheres_match_reference_values() -> Result<()> {
    for [coefficient, reduced_pressure, area] in ROUGH_SPHERE {
        assert_equal_to_14_digits(RoughSphere::area_law(reduced_pressure, coefficient)?, area);
        // The slope is chosen such that the ball has the reduced pressure.
        let ball = ball()?;
        let slope = ball.mean_pressure() / ball.pair().contact_modulus() / reduced_pressure;
        let rough = RoughSphere::new(ball, slope)?.with_area_coefficient(coefficient)?;
        assert_equal_to_14_digits(rough.reduced_pressure(), reduced_pressure);
        assert_equal_to_14_digits(rough.relative_contact_area(), area);
        assert_equal_to_14_digits(rough.contact_area(), area * ball.contact_area());
    }
    for [load, reduced_pressure, area] in TABLE_3 {
        let smooth = HertzSphere::new(&rubber()?, 3.5e-3, load)?;
        let rough = RoughSphere::new(smooth, 0.7518)?;
        assert_relative_eq!(
            rough.reduced_pressure(),
            reduced_pressure,
            max_relative = 2e-5
        );
        assert_relative_eq!(rough.relative_contact_area(), area, max_relative = 2e-5);
    }
    Ok(())
}

#[test]
fn rough_planes_match_reference_values() -> Result<()> {
    for [coefficient, reduced_pressure, area, ratios @ ..] in ROUGH_PLANE {
        assert_equal_to_14_digits(Persson::area_law(reduced_pressure, coefficient)?, area);
        let plane = rough_plane(reduced_pressure, coefficient)?;
        assert_equal_to_14_digits(plane.contact_fraction(), area);
        for (fraction, ratio) in FRACTIONS.into_iter().zip(ratios) {
            let traction = fraction * FRICTION * plane.mean_pressure();
            assert_equal_to_14_digits(plane.stick_ratio(FRICTION, traction)?, ratio);
            assert_equal_to_14_digits(plane.stick_ratio(FRICTION, -traction)?, ratio);
        }
    }
    assert_close(Persson::AREA_COEFFICIENT, (8.0 / PI).sqrt());
    Ok(())
}

/// The area of the rough sphere is the area of the rough plane, averaged over the Hertz pressure.
#[test]
fn rough_sphere_averages_the_rough_plane() -> Result<()> {
    let ball = ball()?;
    let a = ball.contact_radius();
    for slope in [1e-6, 1e-3, 0.02, 0.3, 10.0] {
        let rough = RoughSphere::new(ball, slope)?;
        let scale = ball.pair().contact_modulus() * slope;
        let area = singular_integral(0.0, a, |r| {
            let local = Persson::area_law(ball.pressure(r) / scale, rough.area_coefficient());
            2.0 * PI * r * local.unwrap_or(f64::NAN)
        });
        assert_relative_eq!(
            area,
            rough.contact_area(),
            max_relative = 1e-11,
            epsilon = 0.0
        );
    }
    Ok(())
}

#[test]
fn area_is_linear_for_light_loads_and_full_for_heavy_loads() -> Result<()> {
    for coefficient in [
        Persson::AREA_COEFFICIENT,
        RoughSphere::AREA_COEFFICIENT,
        2.5,
    ] {
        for light in [1e-300, 1e-100, 1e-10] {
            assert_equal_to_14_digits(
                RoughSphere::area_law(light, coefficient)?,
                coefficient * light,
            );
            assert_equal_to_14_digits(Persson::area_law(light, coefficient)?, coefficient * light);
            // No digits are lost, and no division by zero occurs.
            let plane = rough_plane(light, coefficient)?;
            let traction = 0.4 * FRICTION * plane.mean_pressure();
            assert_equal_to_14_digits(plane.stick_ratio(FRICTION, traction)?, 0.6);
        }
        for heavy in [1e9, 1e200, f64::MAX] {
            assert_equal_to_14_digits(RoughSphere::area_law(heavy, coefficient)?, 1.0);
            assert_equal_to_14_digits(Persson::area_law(heavy, coefficient)?, 1.0);
        }
        assert_close(RoughSphere::area_law(0.0, coefficient)?, 0.0);
        assert_close(Persson::area_law(0.0, coefficient)?, 0.0);
    }
    Ok(())
}

#[test]
fn stick_ratio_is_one_at_zero_force_and_zero_when_sliding() -> Result<()> {
    let plane = rough_plane(0.3, 2.0)?;
    let limit = FRICTION * plane.mean_pressure();
    assert_close(plane.stick_ratio(FRICTION, 0.0)?, 1.0);
    assert_close(plane.stick_ratio(FRICTION, limit)?, 0.0);
    assert_close(plane.stick_ratio(0.0, 0.0)?, 0.0);
    let closed = Persson::new(&rubber()?, 1e-300, 25e6)?.with_area_coefficient(1e10)?;
    assert_close(closed.stick_ratio(FRICTION, FRICTION * 25e6)?, 0.0);
    assert_close(linear_stick_ratio(100.0, FRICTION, 0.0)?, 1.0);
    assert_close(linear_stick_ratio(100.0, FRICTION, -10.0)?, 0.8);
    assert_close(linear_stick_ratio(100.0, FRICTION, -50.0)?, 0.0);
    assert_close(linear_stick_ratio(100.0, 0.0, 0.0)?, 0.0);
    // The product 0.29 * 100 rounds to slightly less than 29. A force that is meant to equal the limit is accepted
    // nevertheless.
    assert_close(linear_stick_ratio(100.0, 0.29, 29.0)?, 0.0);
    Ok(())
}

proptest! {
    #[test]
    fn area_grows_with_load_and_stick_ratio_falls_with_force(
        exponent in -9.0..3.0_f64,
        more in 1.0..10.0_f64,
        coefficient in 1.5..2.6_f64,
        fraction in -1.0..1.0_f64,
        part in 0.0..1.0_f64,
    ) {
        let solve = || -> Result<_> {
            let (light, heavy) = (10f64.powf(exponent), more * 10f64.powf(exponent));
            let spheres = [light, heavy].map(|p| RoughSphere::area_law(p, coefficient));
            let planes = [light, heavy].map(|p| Persson::area_law(p, coefficient));
            let plane = rough_plane(light, coefficient)?;
            let limit = FRICTION * plane.mean_pressure();
            let ratios = [fraction, part * fraction]
                .map(|fraction| plane.stick_ratio(FRICTION, fraction * limit));
            Ok((spheres, planes, ratios))
        };
        let (spheres, planes, [less, greater]) =
            solve().map_err(|e| TestCaseError::fail(e.to_string()))?;
        for [light, heavy] in [spheres, planes] {
            let area = |law: Result<f64>| law.map_err(|e| TestCaseError::fail(e.to_string()));
            let (light, heavy) = (area(light)?, area(heavy)?);
            prop_assert!(0.0 < light && heavy <= 1.0 + 1e-15);
            prop_assert!(light <= heavy * (1.0 + 1e-15));
            // The area is a concave function of the load.
            prop_assert!(heavy / more <= light * (1.0 + 1e-14));
        }
        let (less, greater) = (less.unwrap_or(f64::NAN), greater.unwrap_or(f64::NAN));
        prop_assert!((0.0..=1.0).contains(&less) && less <= greater);
        let linear = linear_stick_ratio(1.0, FRICTION, FRICTION * fraction);
        prop_assert!(less >= linear.unwrap_or(f64::NAN) - 1e-14);
    }
}
