//! Tests of dissimilar bodies pressed together, in full stick and with slip under Goodman's assumption.

use approx::assert_relative_eq;
use stickslip::analytical::{FlatPunch, HertzSphere, NoSlipPunch, NoSlipSphere, SpencePressing};
use stickslip::{ElasticPair, Error, Material, Result};

fn against_rigid(poisson_ratio: f64) -> Result<ElasticPair> {
    ElasticPair::new(Material::new(1.0, poisson_ratio)?, Material::rigid())
}

/// Columns: Poisson's ratio, the stiffness of the punch relative to the frictionless stiffness, 1/I, and two loads of
/// the sphere. The value 1/I is the approach relative to `a^2 / 2R`. The loads are relative to the Hertzian loads at
/// equal approach and at equal radius. The integral I was evaluated independently of this crate, and also by ring
/// elements to 2e-5.
const NO_SLIP: [[f64; 5]; 5] = [
    [0.0, 1.09861, 2.17747, 1.05289, 1.19609],
    [0.1, 1.07495, 2.13274, 1.04096, 1.14629],
    [0.2, 1.05128, 2.08939, 1.02854, 1.09826],
    [0.3, 1.02863, 2.04916, 1.01621, 1.05391],
    [0.4, 1.00942, 2.01597, 1.00541, 1.01747],
];

#[test]
fn full_stick_stiffens_punch_and_sphere() -> Result<()> {
    for [poisson_ratio, punch, approach, at_approach, at_radius] in NO_SLIP {
        let pair = against_rigid(poisson_ratio)?;
        let (stuck, smooth) = (
            NoSlipPunch::new(&pair, 0.7, 2.0)?,
            FlatPunch::new(&pair, 0.7, 2.0)?,
        );
        assert_relative_eq!(
            smooth.approach() / stuck.approach(),
            punch,
            max_relative = 1e-5
        );
        assert_relative_eq!(
            stuck.contact_radius() * stuck.load(),
            1.4,
            max_relative = 1e-15
        );

        let stuck = NoSlipSphere::new(&pair, 5.0, 1e-3)?;
        let reach = stuck.contact_radius().powi(2) / (2.0 * stuck.radius());
        assert_relative_eq!(stuck.approach() / reach, approach, max_relative = 5e-6);
        // The reference loads are the Hertzian loads for the same approach and for the same radius.
        let stiffness = 4.0 / 3.0 * pair.contact_modulus();
        let same_approach = stiffness * stuck.approach().powf(1.5) * stuck.radius().sqrt();
        assert_relative_eq!(
            stuck.load() / same_approach,
            at_approach,
            max_relative = 1e-5
        );
        let same_radius = stiffness * stuck.contact_radius().powi(3) / stuck.radius();
        assert_relative_eq!(stuck.load() / same_radius, at_radius, max_relative = 1e-5);
    }
    Ok(())
}

#[test]
fn full_stick_without_coupling_does_not_stiffen() -> Result<()> {
    let pair = against_rigid(0.5)?;
    let (stuck, smooth) = (
        NoSlipSphere::new(&pair, 5.0, 1e-3)?,
        HertzSphere::new(&pair, 5.0, 1e-3)?,
    );
    assert_relative_eq!(
        stuck.contact_radius(),
        smooth.contact_radius(),
        max_relative = 1e-14
    );
    assert_relative_eq!(stuck.approach(), smooth.approach(), max_relative = 1e-14);
    assert_relative_eq!(
        NoSlipPunch::new(&pair, 5.0, 1.0)?.approach(),
        FlatPunch::new(&pair, 5.0, 1.0)?.approach(),
        max_relative = 1e-15
    );
    for bad in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        for refused in [
            NoSlipPunch::new(&pair, bad, 1.0).map(|_| ()),
            NoSlipPunch::new(&pair, 1.0, bad).map(|_| ()),
            NoSlipSphere::new(&pair, bad, 1.0).map(|_| ()),
            NoSlipSphere::new(&pair, 1.0, bad).map(|_| ()),
        ] {
            assert!(matches!(refused, Err(Error::NotPositive { .. })), "{bad}");
        }
    }
    Ok(())
}

/// Columns: the stick ratio k, and the friction coefficient divided by beta for round and for plane contacts. These
/// quotients are (1/2k) ln((1+k)/(1-k)) / K'(k) and K(k) / K'(k), from tables of elliptic integrals.
const SPENCE: [[f64; 3]; 4] = [
    [0.1, 0.27150, 0.42610],
    [0.3, 0.39262, 0.61194],
    [0.5, 0.50944, 0.78170],
    [0.9, 0.98862, 1.37830],
];

#[test]
fn stick_zone_under_pressing_matches_spence() -> Result<()> {
    for beta in [0.5, 2.0 / 7.0, 0.05] {
        let pair = against_rigid((1.0 - 2.0 * beta) / (2.0 - 2.0 * beta))?;
        for [stick, round, plane] in SPENCE {
            let found = SpencePressing::round(&pair, round * beta)?;
            assert_relative_eq!(found.stick_radius(), stick, max_relative = 2e-4);
            let found = SpencePressing::plane(&pair, plane * beta)?;
            assert_relative_eq!(found.stick_radius(), stick, max_relative = 2e-4);
        }
        // Exchanging the bodies does not change the result.
        let turned = ElasticPair::new(Material::rigid(), pair.bodies()[0])?;
        assert_eq!(
            SpencePressing::round(&turned, 0.1)?,
            SpencePressing::round(&pair, 0.1)?
        );
        assert_eq!(SpencePressing::round(&pair, 0.0)?.stick_radius(), 0.0);
        assert_relative_eq!(SpencePressing::round(&pair, 1e3)?.stick_radius(), 1.0);
        assert!(SpencePressing::round(&pair, 1e-4)?.stick_radius() >= 0.0);
    }
    assert_eq!(
        SpencePressing::plane(&against_rigid(0.5)?, 0.0)?.stick_radius(),
        1.0
    );
    kit::assert_refused! { SpencePressing::plane(&against_rigid(0.0)?, -0.1) => Error::NegativeOrNotFinite { .. } }
    Ok(())
}
