//! Reference values of the closed forms.
//!
//! The constants are the closed forms evaluated to 20 digits in extended precision, independently of this crate, and
//! rounded to double.

use std::f64::consts::{FRAC_PI_2, FRAC_PI_4};

use approx::assert_relative_eq;
use stickslip::Result;
use stickslip::analytical::{CattaneoMindlinEllipse, HertzEllipse};

use super::{LIMIT, assert_close, ball, pair, sheared_ball};

/// Columns: distance divided by the contact radius, pressure, displacement and gap.
const SPHERE: [[f64; 4]; 13] = [
    [0.0, 2774530779.353722, 4.916814175043042e-06, 0.0],
    [0.1, 2760623269.3225927, 4.892230104167827e-06, 0.0],
    [0.25, 2686427875.4942126, 4.763163732072947e-06, 0.0],
    [0.5, 2402814138.5021605, 4.302212403162662e-06, 0.0],
    [0.75, 1835179611.7660427, 3.5339601883121867e-06, 0.0],
    [0.9, 1209389928.2946022, 2.92550443415061e-06, 0.0],
    [0.95, 866346958.1779372, 2.6981017785548696e-06, 0.0],
    [0.99, 391395731.71799576, 2.5073293885631994e-06, 0.0],
    [1.0, 0.0, 2.458407087521521e-06, 0.0],
    [1.05, 0.0, 2.272263893230208e-06, 6.584353217964289e-08],
    [1.25, 0.0, 1.8087389906929095e-06, 7.33185889902244e-07],
    [2.0, 0.0, 1.0718436697730094e-06, 5.988657844816052e-06],
    [5.0, 0.0, 4.190434284324938e-07, 5.696240644142748e-05],
];

/// Columns: force divided by the friction limit, stick radius divided by contact radius, stick ratio and shift.
#[rustfmt::skip] // one row per line
const PARTIAL_SLIP: [[f64; 4]; 6] = [
    [0.1, 0.9654893846056297, 0.9321697517861577, 2.008098314485242e-07],
    [0.2, 0.9283177667225557, 0.8617738760127535, 4.092151420728147e-07],
    [0.4, 0.8434326653017492, 0.7113786608980126, 8.544565880814477e-07],
    [0.6, 0.7368062997280773, 0.5428835233189813, 1.3532824226924471e-06],
    [0.8, 0.5848035476425733, 0.3419951893353394, 1.94800754237729e-06],
    [0.95, 0.36840314986403866, 0.13572088082974532, 2.5586777111282885e-06],
];

/// Columns: distance divided by the contact radius, traction, and slip at 0, 45 and 90 degrees from the force. The
/// force is 0.4 of the limit.
#[rustfmt::skip] // one row per line
const FIELDS_AT_0_4: [[f64; 5]; 9] = [
    [0.0, 217200444.58083636, 0.0, 0.0, 0.0],
    [0.1, 218499720.82644063, 0.0, 0.0, 0.0],
    [0.25, 225729979.51533046, 0.0, 0.0, 0.0],
    [0.5, 259108995.18229598, 0.0, 0.0, 0.0],
    [0.75, 382316262.53559333, 0.0, 0.0, 0.0],
    [0.9, 604694964.1473011, -3.6727376279270637e-08, -4.378615774049012e-08, -5.084493920170961e-08],
    [0.95, 433173479.0889686, -9.552327056931087e-08, -1.1302443895990359e-07, -1.305256073504963e-07],
    [0.99, 195697865.85899788, -1.5475239551643131e-07, -1.8213311529364427e-07, -2.0951383507085723e-07],
    [1.0, 0.0, -1.710398235956556e-07, -2.0105239702975042e-07, -2.310649704638452e-07],
];

/// Values as in [`FIELDS_AT_0_4`], for a force of 0.95 of the limit.
#[rustfmt::skip] // one row per line
const FIELDS_AT_0_95: [[f64; 5]; 9] = [
    [0.0, 876192450.4225425, 0.0, 0.0, 0.0],
    [0.1, 888426997.1454501, 0.0, 0.0, 0.0],
    [0.25, 967828841.6113611, 0.0, 0.0, 0.0],
    [0.5, 1201407069.2510803, -8.837923836449408e-08, -1.0235765719955974e-07, -1.1633607603462538e-07],
    [0.75, 917589805.8830214, -4.5932279099869406e-07, -5.167979327578824e-07, -5.742730745170707e-07],
    [0.9, 604694964.1473011, -7.777909369253899e-07, -8.682360180594498e-07, -9.586810991935097e-07],
    [0.95, 433173479.0889686, -8.987076210360811e-07, -1.0012923784206005e-06, -1.1038771358051197e-06],
    [0.99, 195697865.85899788, -1.0006449200476694e-06, -1.1133613110992517e-06, -1.2260777021508341e-06],
    [1.0, 0.0, -1.0268473267670332e-06, -1.142155264881486e-06, -1.2574632029959388e-06],
];

/// Reference values of an elliptic contact of two equal bodies.
struct Ellipse {
    /// Young's modulus and Poisson's ratio.
    material: [f64; 2],
    radii: [f64; 2],
    load: f64,
    friction: f64,
    semi_axes: [f64; 2],
    max_pressure: f64,
    approach: f64,
    area: f64,
    gross_shift: f64,
    full_stick_compliance: f64,
    /// Columns: force divided by the friction limit, axis of the stick ellipse divided by axis of the contact, and
    /// shift.
    partial_slip: [[f64; 3]; 6],
}

/// Ellipses with the force along the longer axis, and along the shorter axis.
const ELLIPSES: [Ellipse; 2] = [
    Ellipse {
        material: [210e9, 0.3],
        radii: [0.02, 0.01],
        load: 50.0,
        friction: 0.3,
        semi_axes: [0.00020800017971092544, 0.00013116401922198183],
        max_pressure: 875050191.8195873,
        approach: 1.9418018659176527e-06,
        area: 8.570936924663067e-08,
        gross_shift: 7.21603657217437e-07,
        full_stick_compliance: 3.207127365410831e-08,
        partial_slip: [
            [0.1, 0.9654893846056297, 4.894655518107516e-08],
            [0.2, 0.9283177667225557, 9.974447659218799e-08],
            [0.4, 0.8434326653017492, 2.082702138469882e-07],
            [0.6, 0.7368062997280773, 3.2985692134737236e-07],
            [0.8, 0.5848035476425733, 4.748186778422863e-07],
            [0.95, 0.36840314986403866, 6.236669732499209e-07],
        ],
    },
    Ellipse {
        material: [70e9, 0.33],
        radii: [0.005, 0.03],
        load: 20.0,
        friction: 0.5,
        semi_axes: [8.902078576511753e-05, 0.00028935827454251023],
        max_pressure: 370718323.64254856,
        approach: 2.187940213927541e-06,
        area: 8.092397404377128e-08,
        gross_shift: 1.2891306366965205e-06,
        full_stick_compliance: 8.594204244643471e-08,
        partial_slip: [
            [0.1, 0.9654893846056297, 8.744205106719361e-08],
            [0.2, 0.9283177667225557, 1.7819153122377129e-07],
            [0.4, 0.8434326653017492, 3.7207061064074745e-07],
            [0.6, 0.7368062997280773, 5.892828546282718e-07],
            [0.8, 0.5848035476425733, 8.482541605215074e-07],
            [0.95, 0.36840314986403866, 1.1141686911794584e-06],
        ],
    },
];

#[test]
fn sphere_matches_reference_values() -> Result<()> {
    let ball = ball()?;
    let a = ball.contact_radius();
    assert_close(a, 0.00013118250497932507);
    assert_close(ball.max_pressure(), 2774530779.353722);
    assert_close(ball.mean_pressure(), 1849687186.2358148);
    assert_close(ball.approach(), 4.916814175043042e-06);
    for [ratio, pressure, displacement, gap] in SPHERE {
        assert_close(ball.pressure(ratio * a), pressure);
        assert_close(ball.displacement(ratio * a), displacement);
        assert_close(ball.gap(ratio * a), gap);
    }
    Ok(())
}

#[test]
fn ellipses_match_reference_values() -> Result<()> {
    for case in &ELLIPSES {
        let pair = pair(case.material[0], case.material[1])?;
        let hertz = HertzEllipse::new(&pair, case.radii[0], case.radii[1], case.load)?;
        assert_close(hertz.semi_axes()[0], case.semi_axes[0]);
        assert_close(hertz.semi_axes()[1], case.semi_axes[1]);
        assert_close(hertz.max_pressure(), case.max_pressure);
        assert_close(hertz.approach(), case.approach);
        assert_close(hertz.contact_area(), case.area);
        let limit = case.friction * case.load;
        let shear = |force| CattaneoMindlinEllipse::new(hertz, case.friction, force);
        for [fraction, axis, shift] in case.partial_slip {
            let shear = shear(fraction * limit)?;
            assert_close(shear.shift(), shift);
            assert_close(shear.stick_ratio(), axis * axis);
            for (stick, whole) in shear.stick_semi_axes().iter().zip(case.semi_axes) {
                assert_close(*stick, axis * whole);
            }
        }
        assert_close(shear(limit)?.shift(), case.gross_shift);
        // A small force causes hardly any slip. The compliance follows from 1 - (1 - f)^(2/3) = (2/3) f + f^2/9 + ...
        let small = 1e-10 * limit;
        assert_relative_eq!(
            shear(small)?.shift() / small,
            case.full_stick_compliance,
            max_relative = 1e-10,
            epsilon = 0.0
        );
    }
    Ok(())
}

#[test]
fn sheared_sphere_matches_reference_values() -> Result<()> {
    let a = ball()?.contact_radius();
    for [fraction, radius, ratio, shift] in PARTIAL_SLIP {
        let shear = sheared_ball(fraction * LIMIT)?;
        assert_close(shear.stick_radius(), radius * a);
        assert_close(shear.stick_ratio(), ratio);
        assert_close(shear.shift(), shift);
    }
    for (fraction, fields) in [(0.4, FIELDS_AT_0_4), (0.95, FIELDS_AT_0_95)] {
        let shear = sheared_ball(fraction * LIMIT)?;
        for [ratio, traction, slips @ ..] in fields {
            let r = ratio * a;
            assert_close(shear.traction(r), traction);
            for (slip, theta) in slips.into_iter().zip([0.0, FRAC_PI_4, FRAC_PI_2]) {
                // Rounding may move a point at the edge just outside the contact.
                let inside = r * (1.0 - 1e-15);
                let found = shear.slip(inside * f64::cos(theta), inside * f64::sin(theta));
                assert_close(found, slip);
            }
        }
    }
    Ok(())
}

/// A full cycle dissipates four times the energy of the first loading.
#[test]
fn dissipated_energy_matches_reference_values() -> Result<()> {
    let cycles = [
        (0.4, 1.9278027314025586e-06),
        (0.8, 2.62446228167928e-05),
        (1.0, 0.00011841904562427609),
    ];
    for (fraction, per_cycle) in cycles {
        let energy = sheared_ball(fraction * LIMIT)?.energy_of_first_quarter();
        assert_close(4.0 * energy, per_cycle);
    }
    Ok(())
}
