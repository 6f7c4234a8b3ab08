//! Every closed form rejects an invalid parameter. The error contains the name and the value of the parameter. For
//! all accepted parameters the results are finite.

use kit::refusal::Rule::{Finite, NonNegative, Positive};
use kit::refusal::assert_checked;
use kit::unit_pair;
use stickslip::Error;
use stickslip::analytical::{
    BentallJohnson, Carter, CattaneoMindlin, CattaneoMindlinEllipse, CattaneoMindlinLine, Cone,
    ConePartialSlip, FlatPunch, HertzEllipse, HertzLine, HertzSphere, KalkerCoefficients,
    LubkinTorsion, MindlinDeresiewicz, MindlinFullStick, Persson, PopovLimitingShape, RoughSphere,
    RoundedPunch, VermeulenJohnson, Westergaard, WestergaardPartialSlip, linear_stick_ratio,
};

#[test]
fn normal_contacts_reject_invalid_parameters() {
    let pair = unit_pair(0.3);
    let sphere = |radius, load| {
        let hertz = HertzSphere::new(&pair, radius, load)?;
        Ok(hertz.max_pressure() + hertz.approach() + hertz.contact_area())
    };
    assert_checked("radius", Positive, |value| sphere(value, 2.0));
    assert_checked("load", Positive, |value| sphere(2.0, value));
    let ellipse = |[x, y]: [f64; 2], load| {
        let hertz = HertzEllipse::new(&pair, x, y, load)?;
        Ok(hertz.max_pressure() + hertz.approach() + hertz.contact_area())
    };
    kit::assert_all_checked! {
        Positive "radius along x" => |value| ellipse([value, 1.0], 2.0),
        Positive "radius along y" => |value| ellipse([1.0, value], 2.0),
        Positive "load" => |value| ellipse([1.0, 2.0], value),
    }
    let cone = |slope, load| {
        let cone = Cone::new(&pair, slope, load)?;
        Ok(cone.mean_pressure() + cone.approach() + cone.contact_radius())
    };
    assert_checked("slope", Positive, |value| cone(value, 1.0));
    assert_checked("load", Positive, |value| cone(0.1, value));
    let punch = |radius, load| {
        let punch = FlatPunch::new(&pair, radius, load)?;
        Ok(punch.mean_pressure() + punch.approach())
    };
    assert_checked("radius", Positive, |value| punch(value, 1.0));
    assert_checked("load", Positive, |value| punch(1.0, value));
    let wavy = |amplitude, wavelength, pressure| {
        let wavy = Westergaard::new(&pair, amplitude, wavelength, pressure)?;
        Ok(wavy.max_pressure() + wavy.approach() + wavy.contact_fraction())
    };
    assert_checked("amplitude", Positive, |value| wavy(value, 1.0, 0.1));
    assert_checked("wavelength", Positive, |value| wavy(0.1, value, 0.1));
    assert_checked("mean pressure", Positive, |value| wavy(0.1, 1.0, value));
}

#[test]
fn line_contacts_reject_invalid_parameters() {
    let pair = unit_pair(0.3);
    let hertz = |radius, load| {
        let hertz = HertzLine::new(&pair, radius, load)?;
        Ok(hertz.max_pressure() + hertz.approach(10.0) + hertz.half_width())
    };
    assert_checked("radius", Positive, |value| hertz(value, 2.0));
    assert_checked("load per length", Positive, |value| hertz(2.0, value));
    let shear = |friction, force, strain| {
        let hertz = HertzLine::new(&pair, 2.0, 1e-3)?;
        let shear = CattaneoMindlinLine::new(hertz, friction, force)?.with_strain(strain)?;
        Ok(shear.shift(10.0) + shear.traction(1e-3) + shear.energy_per_cycle())
    };
    assert_checked("coefficient of friction", NonNegative, |value| {
        shear(value, 0.0, 0.0)
    });
    assert_checked("tangential force", Finite, |value| shear(0.5, value, 0.0));
    assert_checked("bulk strain", Finite, |value| shear(0.5, 1e-4, value));
    // Without friction there is no traction, so a nonzero bulk strain cannot be balanced.
    let hertz = HertzLine::new(&pair, 2.0, 1e-3).unwrap();
    let smooth = CattaneoMindlinLine::new(hertz, 0.0, 0.0).unwrap();
    assert_eq!(smooth.with_strain(0.0), Ok(smooth));
    kit::assert_refused! { smooth.with_strain(1e-3) => Error::NotPositive { value: 0.0, .. } }
    let rounded = |flat, radius, load| {
        let punch = RoundedPunch::new(&pair, flat, radius, load)?;
        Ok(punch.half_width() + punch.pressure(0.5))
    };
    kit::assert_all_checked! {
        Positive "half-width of the flat" => |value| rounded(value, 1.0, 1.0),
        Positive "radius of the edges" => |value| rounded(1.0, value, 1.0),
        Positive "load per length" => |value| rounded(1.0, 1.0, value),
    }
}

#[test]
fn rolling_contacts_reject_invalid_parameters() {
    let pair = unit_pair(0.3);
    let hertz = HertzLine::new(&pair, 2.0, 1e-3).unwrap();
    let carter = |friction, creepage| Ok(Carter::new(hertz, friction, creepage)?.force());
    assert_checked("coefficient of friction", NonNegative, |value| {
        carter(value, 1e-3)
    });
    assert_checked("creepage", Finite, |value| carter(0.3, value));
    let soft = kit::on_rigid(1.0, 0.1);
    let hertz = HertzLine::new(&soft, 2.0, 1e-3).unwrap();
    assert_checked("coefficient of friction", NonNegative, |value| {
        let free = BentallJohnson::new(hertz, value)?;
        Ok(free.creepage() + free.dissipation() + free.traction(0.0))
    });
    assert_checked("ratio of the semi-axes", Positive, |value| {
        let kalker = KalkerCoefficients::new(value, 0.3)?;
        Ok(kalker.c11() + kalker.c22() + kalker.c23() + kalker.c33())
    });
    let ellipse = HertzEllipse::new(&pair, 2.0, 1.0, 1e-3).unwrap();
    let creep = |friction, creepage| {
        let [x, y] = VermeulenJohnson::new(ellipse, friction, creepage)?.force();
        Ok(x + y)
    };
    assert_checked("coefficient of friction", Positive, |value| {
        creep(value, [1e-3, 0.0])
    });
    assert_checked("creepage", Finite, |value| creep(0.3, [value, 1e-3]));
    assert_checked("creepage", Finite, |value| creep(0.3, [0.0, value]));
    // Neither closed form is valid for bodies that the pressure displaces tangentially.
    kit::assert_refused! { Carter::new(hertz, 0.3, 1e-3) => Error::CoupledMaterials { .. } }
    let ellipse = HertzEllipse::new(&soft, 2.0, 1.0, 1e-3).unwrap();
    kit::assert_refused! { VermeulenJohnson::new(ellipse, 0.3, [1e-3, 0.0]) => Error::CoupledMaterials { .. } }
}

#[test]
fn rough_and_worn_contacts_reject_invalid_parameters() {
    let pair = unit_pair(0.3);
    let persson = |slope, pressure| Ok(Persson::new(&pair, slope, pressure)?.contact_fraction());
    assert_checked("root-mean-square slope", Positive, |value| {
        persson(value, 0.1)
    });
    assert_checked("mean pressure", Positive, |value| persson(0.1, value));
    let persson = Persson::new(&pair, 0.1, 0.02).unwrap();
    kit::assert_all_checked! {
        Positive "area coefficient" => |value| Ok(persson.with_area_coefficient(value)?.contact_fraction()),
        NonNegative "reduced pressure" => |value| Persson::area_law(value, 1.0),
        Positive "area coefficient" => |value| Persson::area_law(0.1, value),
        Positive "load" => |value| linear_stick_ratio(value, 0.5, 0.0),
    }

    let hertz = HertzSphere::new(&pair, 1.0, 1e-3).unwrap();
    let rough = |slope| Ok(RoughSphere::new(hertz, slope)?.contact_area());
    assert_checked("root-mean-square slope", Positive, rough);
    assert_checked("area coefficient", Positive, |value| {
        let rough = RoughSphere::new(hertz, 0.1)?;
        Ok(rough.with_area_coefficient(value)?.contact_area())
    });
    kit::assert_all_checked! {
        NonNegative "reduced pressure" => |value| RoughSphere::area_law(value, 1.0),
        Positive "area coefficient" => |value| RoughSphere::area_law(0.1, value),
    }

    let worn = |radius, approach, stick| {
        let worn = PopovLimitingShape::new(&pair, radius, approach, stick)?;
        Ok(worn.load() + worn.worn_radius())
    };
    assert_checked("radius", Positive, |value| worn(value, 0.01, 0.05));
    assert_checked("approach", Positive, |value| worn(1.0, value, 0.05));
    assert_checked("stick radius", NonNegative, |value| worn(1.0, 0.01, value));
}

/// A function of the coefficient of friction and the force.
type ForceFunction<'a> = &'a dyn Fn(f64, f64) -> Result<f64, Error>;

#[test]
fn tangential_contacts_reject_invalid_parameters() {
    let pair = unit_pair(0.3);
    let hertz = HertzSphere::new(&pair, 2.0, 1.0).unwrap();
    let ellipse = HertzEllipse::new(&pair, 2.0, 1.0, 1.0).unwrap();
    let cone = Cone::new(&pair, 0.1, 1.0).unwrap();
    let punch = FlatPunch::new(&pair, 2.0, 1.0).unwrap();
    let wavy = Westergaard::new(&pair, 0.01, 1.0, 1.0).unwrap();
    let persson = Persson::new(&pair, 0.1, 1.0).unwrap();
    let contacts: [ForceFunction<'_>; 9] = [
        &|mu, force| Ok(CattaneoMindlin::new(hertz, mu, force)?.shift()),
        &|mu, force| Ok(CattaneoMindlinEllipse::new(ellipse, mu, force)?.shift()),
        &|mu, force| Ok(ConePartialSlip::new(cone, mu, force)?.shift()),
        &|mu, force| Ok(punch.full_stick(mu, force)?.shift()),
        &|mu, force| Ok(WestergaardPartialSlip::new(wavy, mu, force)?.traction(0.0)),
        &|mu, force| Ok(MindlinDeresiewicz::new(hertz, mu, &[0.1 * mu, force])?.shift()),
        &|mu, force| Ok(MindlinDeresiewicz::new(hertz, mu, &[force, 0.0])?.shift()),
        &|mu, force| persson.stick_ratio(mu, force),
        &|mu, force| linear_stick_ratio(1.0, mu, force),
    ];
    for contact in contacts {
        assert_checked("coefficient of friction", NonNegative, |value| {
            contact(value, 0.0)
        });
        assert_checked("tangential force", Finite, |value| contact(0.5, value));
        let is = |found: f64, expected: f64| (found - expected).abs() < 1e-12;
        for beyond in [0.5000005, -0.5000005] {
            kit::assert_refused! {
                contact(0.5, beyond) => Error::BeyondFrictionCapacity { force, limit, .. }
                    if is(force, 0.5000005) && is(limit, 0.5),
            }
        }
        kit::assert_refused! { contact(0.0, 1e-300) => Error::BeyondFrictionCapacity { .. } }
        let accepted = [(0.5, 0.5), (0.5, -0.5), (0.0, 0.0)];
        assert!(
            accepted
                .iter()
                .all(|(mu, force)| contact(*mu, *force).is_ok())
        );
    }
    // The product 0.29 * 100 rounds to slightly less than 29. A force that is meant to equal the limit is accepted
    // nevertheless.
    let heavy = HertzSphere::new(&pair, 2.0, 100.0).unwrap();
    assert!(CattaneoMindlin::new(heavy, 0.29, 29.0).is_ok());
    kit::assert_all_checked! {
        Positive "contact radius" => |value| Ok(MindlinFullStick::new(&pair, value, 1.0)?.shift()),
        Finite "tangential force" => |value| Ok(MindlinFullStick::new(&pair, 1.0, value)?.shift()),
        Positive "coefficient of friction" => |value| Ok(LubkinTorsion::new(hertz, value, 0.0)?.moment()),
        Finite "twist" => |value| Ok(LubkinTorsion::new(hertz, 0.5, value)?.moment()),
    }
}

#[test]
fn results_beyond_the_range_of_a_double_are_rejected() {
    let (steel, rubber) = (kit::alike(213e9, 0.29), kit::on_rigid(18.75e6, 0.5));
    let ball = HertzSphere::new(&steel, 3.5e-3, 100.0).unwrap();
    let unit = 0.5 * ball.max_pressure() / steel.equivalent_shear_modulus();
    kit::assert_refused! {
        HertzSphere::new(&steel, 1e300, 1e300) => _,
        HertzSphere::new(&steel, 1e-300, 1e-300) => _,
        HertzEllipse::new(&steel, 1e-200, 1e200, 1.0) => _,
        CattaneoMindlin::new(ball, 1e307, 1.0) => Error::NotFinite { .. },
        Cone::new(&steel, 1e308, 1e-300) => Error::NotPositive { .. },
        Cone::new(&steel, 1e-320, 1e300) => Error::NotPositive { .. },
        FlatPunch::new(&steel, 1e-200, 1.0) => Error::NotPositive { .. },
        FlatPunch::new(&steel, 1e200, 1.0) => Error::NotPositive { .. },
        MindlinFullStick::new(&steel, 1e-300, 1e300) => _,
        Westergaard::new(&rubber, 1e200, 1e-200, 1.0) => Error::NotPositive { .. },
        Westergaard::new(&rubber, 1e-200, 1e200, 1.0) => Error::NotPositive { .. },
        Westergaard::new(&rubber, 1.0, 1.0, 1e308) => Error::NotPositive { .. },
        RoughSphere::new(ball, 1e-320) => Error::NotPositive { .. },
        Persson::new(&rubber, 1e300, 1e-300) => Error::NotPositive { .. },
        // The stick radius is smaller than any double.
        LubkinTorsion::new(ball, 0.5, 400.0 * unit) => Error::NotPositive { .. },
        LubkinTorsion::new(ball, 1e-300, 1e9) => Error::NotPositive { .. },
    }
}
