//! Steady rolling agrees with closed forms: Kalker's coefficients, the creep curve of Vermeulen and Johnson, and the free
//! rolling of Bentall and Johnson.

use stickslip::analytical::{
    BentallJohnson, HertzEllipse, HertzLine, HertzSphere, KalkerCoefficients, VermeulenJohnson,
};
use stickslip::rolling::{RollingControl, RollingProblem, RollingSolution};
use stickslip::{
    Axis, Boundary, ElasticPair, Error, Field, Friction, Grid, HalfSpace, Material, NormalLoad,
    NormalProblem, NormalSolution, Result, surface,
};

fn pressed(bodies: &HalfSpace, gap: &Field, force: f64) -> Result<NormalSolution> {
    NormalProblem::builder(bodies, gap, NormalLoad::Force(force))
        .tolerance(1e-10)
        .build()?
        .solve()
}

fn alike(shear_modulus: f64, poisson: f64) -> Result<ElasticPair> {
    let body = Material::from_shear_modulus(shear_modulus, poisson)?;
    ElasticPair::new(body, body)
}

/// Table E.3 of Kalker (1990): a/b, Poisson's ratio, C11, C22 and C23. A copy in circulation has 1.15 instead of 1.25
/// for C23 at a/b = 0.8 and a Poisson's ratio of 0.25.
const PRINTED: [[f64; 5]; 12] = [
    [0.2, 0.25, 3.37, 2.63, 0.603],
    [0.4, 0.5, 4.82, 2.98, 0.977],
    [0.5, 0.0, 2.88, 2.88, 0.827],
    [0.5, 0.25, 3.62, 3.01, 0.929],
    [0.8, 0.25, 3.91, 3.41, 1.25],
    [1.0, 0.0, 3.40, 3.40, 1.33],
    [1.0, 0.25, 4.12, 3.67, 1.47],
    [1.0, 0.5, 5.20, 3.98, 1.63],
    [2.0, 0.0, 4.37, 4.37, 2.35],
    [2.0, 0.25, 5.10, 4.90, 2.62],
    [2.0, 0.5, 6.11, 5.56, 2.96],
    [5.0, 0.25, 7.78, 8.14, 6.63],
];

#[test]
fn kalker_coefficients_match_printed_table() -> Result<()> {
    for [ratio, poisson, c11, c22, c23] in PRINTED {
        let found = KalkerCoefficients::new(ratio, poisson)?;
        for (found, printed) in [
            (found.c11(), c11),
            (found.c22(), c22),
            (found.c23(), c23),
            (-found.c32(), c23),
        ] {
            let bar = if ratio == 1.0 || ratio == 0.8 {
                5e-3
            } else {
                1e-2
            };
            assert!(
                (found / printed - 1.0).abs() < bar,
                "{ratio}, {poisson}: {found} for {printed}"
            );
        }
    }
    for (poisson, printed) in [(0.0, 1.21), (0.25, 1.19), (0.5, 1.16)] {
        let found = KalkerCoefficients::new(1.0, poisson)?.c33();
        assert!((found / printed - 1.0).abs() < 5e-3, "{poisson}: {found}");
    }
    Ok(())
}

/// Returns the semi-axes of a contact and its coefficients C11, C22, C23, C32 and C33. The solves have the given number of
/// cells across each axis.
fn solved(radii: [f64; 2], poisson: f64, cells: f64) -> Result<([f64; 2], [f64; 5])> {
    let pair = alike(1.0, poisson)?;
    let hertz = HertzEllipse::new(&pair, radii[0], radii[1], 1.0)?;
    let [a, b] = hertz.semi_axes();
    #[expect(clippy::cast_sign_loss, reason = "a small positive number")]
    let across = cells.ceil() as usize + 6;
    let grid = Grid::new(across, across, 2.0 * a / cells, 2.0 * b / cells)?;
    let bodies = HalfSpace::new(grid, pair)?;
    let normal = pressed(&bodies, &surface::ellipsoid(grid, radii[0], radii[1])?, 1.0)?;
    let of = |creepage: [f64; 2], spin: f64| -> Result<RollingSolution> {
        RollingProblem::builder(&bodies, &normal, Friction::coulomb(1.0)?)
            .creepage(creepage)
            .spin(spin)
            .build()?
            .solve()
    };
    let tiny = 1e-9;
    let (along, across) = (of([tiny, 0.0], 0.0)?, of([0.0, tiny], 0.0)?);
    let spinning = of([0.0; 2], tiny)?;
    let (c, unit) = ((a * b).sqrt(), a * b * tiny);
    let coefficients = [
        along.force()[0] / unit,
        across.force()[1] / unit,
        spinning.force()[1] / (unit * c),
        across.moment() / (unit * c),
        spinning.moment() / (unit * c * c),
    ];
    Ok(([a, b], coefficients))
}

/// A single solve is accurate to only two digits. The table was extrapolated from many solves.
#[test]
fn kalker_coefficients_match_solves_at_small_creepage() -> Result<()> {
    for (radii, poisson) in [([1.0, 1.0], 0.25), ([1.0, 4.0], 0.1), ([5.0, 1.0], 0.4)] {
        let ([a, b], found) = solved(radii, poisson, 63.4)?;
        let expected = KalkerCoefficients::new(a / b, poisson)?;
        let expected = [
            expected.c11(),
            expected.c22(),
            expected.c23(),
            expected.c32(),
            expected.c33(),
        ];
        for (found, expected) in found.into_iter().zip(expected) {
            assert!(
                (found / expected - 1.0).abs() < 1e-2,
                "{}, {poisson}: {found} for {expected}",
                a / b
            );
        }
    }
    Ok(())
}

/// The coupling of spin and lateral creepage is reciprocal, except for an error due to the cells at the edge. This error
/// varies from grid to grid.
#[test]
fn reciprocity_error_falls_with_cell_size() -> Result<()> {
    let defect = |scale: f64| -> Result<f64> {
        let grids = [30.0, 31.7, 33.3, 35.1, 36.8, 38.3].map(|cells| scale * cells);
        let grids = &grids[..kit::thorough(3, 6)];
        let mut sum = 0.0;
        for &cells in grids {
            let (_, [_, _, c23, c32, _]) = solved([1.0; 2], 0.25, cells)?;
            sum += (c32 / c23 + 1.0).powi(2);
        }
        Ok((sum / grids.len() as f64).sqrt())
    };
    let (coarse, fine) = (defect(1.0)?, defect(2.0)?);
    assert!(
        fine < 5e-3 && fine < 0.6 * coarse,
        "{fine} on fine cells, {coarse} on coarse cells"
    );
    Ok(())
}

/// Ellipses that are long across the rolling direction roll like a set of strips. Each strip is a line contact.
#[test]
fn thin_ellipse_matches_strip_theory() -> Result<()> {
    let pi = std::f64::consts::PI;
    for poisson in [0.0, 0.25] {
        let thin = KalkerCoefficients::new(0.0625, poisson)?;
        for (found, strips) in [
            (thin.c11(), pi * pi / (4.0 * (1.0 - poisson))),
            (thin.c22(), pi * pi / 4.0),
            (thin.c33(), pi * pi / (16.0 * (1.0 - poisson) * 0.0625)),
        ] {
            assert!((found / strips - 1.0).abs() < 0.03, "{found} for {strips}");
        }
    }
    Ok(())
}

#[test]
fn ellipse_beyond_table_is_rejected() {
    for ratio in [0.06, 16.7, 1e300] {
        let refused = KalkerCoefficients::new(ratio, 0.3);
        assert!(matches!(refused, Err(Error::BelowMinimum { value, .. }) if value < 0.0625));
    }
    for (ratio, poisson) in [(0.0625, 0.5), (16.0, 0.0)] {
        assert!(KalkerCoefficients::new(ratio, poisson).is_ok());
    }
    let refused = |poisson| KalkerCoefficients::new(1.0, poisson);
    assert!(matches!(refused(-0.1), Err(Error::BelowMinimum { .. })));
    assert!(matches!(refused(f64::NAN), Err(Error::BelowMinimum { .. })));
    assert_eq!(refused(0.51), Err(Error::PoissonRatio(0.51)));
}

#[test]
fn creep_curve_is_near_vermeulen_johnson() -> Result<()> {
    let (friction, load) = (0.3, 1.0);
    let pair = alike(1.0, 0.25)?;
    let hertz = HertzSphere::new(&pair, 1.0, load)?;
    let circle = HertzEllipse::new(&pair, 1.0, 1.0, load)?;
    let a = hertz.contact_radius();
    let grid = Grid::square(44, 2.75 * a)?;
    let bodies = HalfSpace::new(grid, pair)?;
    let normal = pressed(&bodies, &surface::sphere(grid, 1.0)?, load)?;
    let slopes = KalkerCoefficients::new(1.0, 0.25)?;
    for (x, y) in [(0.3, 0.0), (1.0, 0.0), (2.0, 0.0), (0.0, 1.0), (0.8, -0.6)] {
        let unit = friction * load / (a * a);
        let creepage = [x * unit / slopes.c11(), y * unit / slopes.c22()];
        let solved = RollingProblem::builder(&bodies, &normal, Friction::coulomb(friction)?)
            .creepage(creepage)
            .build()?
            .solve()?
            .force();
        let curve = VermeulenJohnson::new(circle, friction, creepage)?;
        let size = x.hypot(y);
        assert!((curve.relative_creepage() - size).abs() < 1e-12);
        let expected = friction * load * (1.0 - (1.0 - size / 3.0).powi(3));
        for (found, direction) in curve.force().into_iter().zip([x, y]) {
            assert!((found - expected * direction / size).abs() < 1e-14);
        }
        for (solved, curve) in solved.into_iter().zip(curve.force()) {
            assert!(
                (solved - curve).abs() < 0.03 * expected,
                "{solved} for {curve}"
            );
        }
    }
    // Every cell slips.
    let slides = VermeulenJohnson::new(circle, friction, [1.0, -1.0])?.force();
    assert!((slides[0].hypot(slides[1]) - friction * load).abs() < 1e-15);
    let none = VermeulenJohnson::new(circle, friction, [0.0; 2])?;
    assert_eq!(none.force(), [0.0; 2]);
    Ok(())
}

#[test]
fn free_rolling_creepage_matches_bentall_johnson() -> Result<()> {
    let (radius, load, friction, cells) = (10.0, 100.0, 1e-4, 256);
    for exchanged in [false, true] {
        let (one, two) = (Material::new(1e3, 0.2)?, Material::new(1e5, 0.3)?);
        let pair = if exchanged {
            ElasticPair::new(two, one)?
        } else {
            ElasticPair::new(one, two)?
        };
        let hertz = HertzLine::new(&pair, radius, load)?;
        let free = BentallJohnson::new(hertz, friction)?;
        assert_eq!(free.creepage() > 0.0, pair.dundurs_beta() > 0.0);

        let grid = Grid::line(cells + 8, 2.0 * hertz.half_width() / cells as f64)?;
        let boundary = Boundary::PeriodicAlongY { datum: 50.0 };
        let bodies = HalfSpace::with_boundary(grid, pair, boundary)?;
        let normal = pressed(&bodies, &surface::cylinder(grid, radius)?, load)?;
        let rolling = RollingProblem::builder(&bodies, &normal, Friction::coulomb(friction)?)
            .control(Axis::X, RollingControl::Force(0.0))
            .build()?
            .solve()?;
        let creepage = rolling.creepage()[0];
        assert!(
            (creepage / free.creepage() - 1.0).abs() < 1e-3,
            "{creepage}"
        );
        let dissipation = rolling.dissipation_per_area()?.integral();
        assert!(
            (dissipation / free.dissipation() - 1.0).abs() < 1e-3,
            "{dissipation}"
        );
        for (i, q) in rolling.traction()[0].as_slice().iter().enumerate() {
            let x = grid.x(i);
            let near = |place: f64| (x.abs() - place).abs() < 3.0 * grid.dx();
            if !near(free.reversal()) && !near(hertz.half_width()) {
                let limit = friction * hertz.max_pressure();
                assert!((q - free.traction(x)).abs() < 1e-2 * limit, "{x}: {q}");
            }
        }
    }
    // Similar bodies roll without slip.
    let hertz = HertzLine::new(&alike(1.0, 0.3)?, radius, 1e-3)?;
    let alike = BentallJohnson::new(hertz, 0.3)?;
    assert_eq!(
        [alike.creepage(), alike.traction(0.0), alike.dissipation()],
        [0.0; 3]
    );
    Ok(())
}
