//! Waves and rough surfaces.

use std::f64::consts::PI;

use kit::{l2_difference, max_abs, unit_pair};
use stickslip::analytical::{
    HertzSphere, RoughSphere, Westergaard, WestergaardPartialSlip, linear_stick_ratio,
};
use stickslip::surface::{self, SelfAffine};
use stickslip::{
    Boundary, ElasticPair, Field, Grid, HalfSpace, Material, NormalLoad, NormalSolution, Result,
};

use crate::Group;
use crate::row::{Row, largest_difference, press, relative, rows, shear};

/// Amplitude of a wave along x with a wavelength of one.
const DEPTH: f64 = 1e-3;
/// Contact modulus of the rubber, in MPa. Lengths are in micrometres.
const MODULUS: f64 = 25.0;

pub(crate) fn group() -> Result<Group> {
    let mut rows = partial_contact()?;
    rows.extend(full_contact()?);
    rows.extend(rough_ball()?);
    rows.extend(area_law()?);
    rows.extend(linear_stick()?);
    Ok(Group {
        heading: "Waves and rough surfaces",
        caption: "The partial contact of the wave carries 0.3 of the pressure that flattens it, and the full contact 1.25 times this\n\
                  pressure. The tangential force is half of the sliding force. The rough ball has an rms slope of 0.75, a roll-off at\n\
                  64 cells and a cut-off at 6.4 cells. The theories of rough surfaces are approximate, so their rows are differences\n\
                  between a theory and one surface. The difference of the stick ratio is absolute.",
        rows,
    })
}

fn wavy_gap(grid: Grid) -> Field {
    Field::from_fn(grid, |x, _| DEPTH * (1.0 - (2.0 * PI * x).cos()))
}

fn partial_contact() -> Result<Vec<Row>> {
    let (pair, friction) = (unit_pair(0.3), 0.4);
    let grid = Grid::new(512, 4, 1.0 / 512.0, 0.25)?;
    let bodies = HalfSpace::with_boundary(grid, pair, Boundary::Periodic)?;
    let exact = Westergaard::new(&pair, DEPTH, 1.0, 0.3 * PI * DEPTH)?;
    let found = press(&bodies, &wavy_gap(grid), exact.mean_pressure());
    let gap = Field::from_fn(grid, |x, _| exact.gap(x));
    let (found_gap, exact_gap) = (found.gap().as_slice(), gap.as_slice());
    let traction = 0.5 * friction * exact.mean_pressure();
    let slip = WestergaardPartialSlip::new(exact, friction, traction)?;
    let sheared = shear(&bodies, &found, friction, traction)?;
    let tractions = Field::from_fn(grid, |x, _| slip.traction(x));
    let westergaard = "wave, Westergaard (1939)";
    let convergence = "closed_forms_cone_punch_waves::wavy_surface_converges_to_closed_form";
    let normal = [
        ("approach", relative(found.approach(), exact.approach())),
        (
            "gap, largest difference over the amplitude",
            kit::max_difference(found_gap, exact_gap) / DEPTH,
        ),
    ];
    let normal = rows(westergaard, "512 x 4", convergence, normal);
    let widths = [
        (
            "largest pressure",
            relative(found.pressure().max(), exact.max_pressure()),
        ),
        (
            "contact area, counted",
            relative(found.contact_area(), exact.contact_fraction()),
        ),
    ];
    let widths = rows(
        westergaard,
        "512 x 4",
        "periodic_contact::partial_contact_matches_westergaard",
        widths,
    );
    let tangential = [
        (
            "stick ratio",
            relative(sheared.stick_ratio(), slip.stick_ratio()),
        ),
        (
            "traction, L2",
            l2_difference(sheared.traction()[0].as_slice(), tractions.as_slice()),
        ),
    ];
    let jaeger = "wave in partial slip, Ciavarella (1998), Jaeger (1998)";
    let tangential = rows(jaeger, "512 x 4", convergence, tangential);
    Ok(normal.chain(widths).chain(tangential).collect())
}

fn full_contact() -> Result<Vec<Row>> {
    let pair = unit_pair(0.3);
    let grid = Grid::square(32, 1.0)?;
    let bodies = HalfSpace::with_boundary(grid, pair, Boundary::Periodic)?;
    let exact = Westergaard::new(&pair, DEPTH, 1.0, 1.25 * PI * DEPTH)?;
    let found = press(&bodies, &wavy_gap(grid), exact.mean_pressure());
    let pressure = Field::from_fn(grid, |x, _| exact.pressure(x));
    let error = largest_difference(found.pressure().as_slice(), pressure.as_slice());
    let quantities = [
        ("approach, full contact", relative(found.approach(), DEPTH)),
        ("pressure, full contact, largest", error),
    ];
    Ok(rows(
        "wave, Westergaard (1939)",
        "32 x 32",
        "periodic_contact::full_contact_matches_westergaard",
        quantities,
    )
    .collect())
}

fn rubber() -> Result<ElasticPair> {
    ElasticPair::new(Material::new(18.75, 0.5)?, Material::rigid())
}

/// Presses a rough surface to a tolerance that is far below the discretisation error.
fn press_rough(bodies: &HalfSpace, gap: &Field, force: f64) -> NormalSolution {
    let method = stickslip::cgm::Method::ActiveSet;
    kit::press_by(bodies, gap, NormalLoad::Force(force), 1e-5, method)
}

fn rough_ball() -> Result<Vec<Row>> {
    let (slope, force) = (0.7518, 15e3);
    let bodies = HalfSpace::new(Grid::square(640, 640.0)?, rubber()?)?;
    let grid = bodies.grid();
    let rough = SelfAffine::with_rms_slope(slope)
        .roll_off_wavelength(64.0)
        .cut_off_wavelength(6.4)
        .seed(0)
        .generate(grid)?;
    let ball = surface::sphere(grid, 3500.0)?;
    let gap = surface::sum(&[&ball, &surface::inverted(rough.heights())])?;
    let found = press_rough(&bodies, &gap, force);
    let hertz = HertzSphere::new(bodies.pair(), 3500.0, force)?;
    let theory = RoughSphere::new(hertz, slope)?.contact_area();
    let quantities = [(
        "contact area, corrected",
        relative(found.contact_area_corrected(), theory),
    )];
    Ok(rows(
        "rough ball, Müser (2016)",
        "640 x 640",
        "rough_contacts::rough_ball_area_matches_mueser_for_any_rms_height",
        quantities,
    )
    .collect())
}

/// Returns a nominally flat rough surface on a periodic grid, and its gap.
fn flat(slope: f64, roll_off: f64, seed: u64) -> Result<(HalfSpace, Field)> {
    let grid = Grid::square(256, 100.0)?;
    let bodies = HalfSpace::with_boundary(grid, rubber()?, Boundary::Periodic)?;
    let rough = SelfAffine::with_rms_slope(slope)
        .roll_off_wavelength(roll_off)
        .seed(seed)
        .generate(grid)?;
    let gap = surface::gap_from_heights(rough.heights())?;
    Ok((bodies, gap))
}

/// Compares the ends of the range of loads, over which the area is proportional to the load.
fn area_law() -> Result<Vec<Row>> {
    let (bodies, gap) = flat(0.3, 25.0, 4)?;
    let areas = [2e-3, 32e-3].map(|pressure| {
        let force = pressure * MODULUS * bodies.grid().area();
        press_rough(&bodies, &gap, force).contact_area_corrected()
    });
    let exponent = (areas[1] / areas[0]).ln() / 16.0_f64.ln();
    Ok(rows(
        "area proportional to the load, Persson (2001), Bush et al. (1975)",
        "256 x 256",
        "rough_contacts::area_is_proportional_to_load",
        [("exponent", relative(exponent, 1.0))],
    )
    .collect())
}

fn linear_stick() -> Result<Vec<Row>> {
    let (bodies, gap) = flat(0.4, 12.5, 2)?;
    let force = 20e-3 * MODULUS * bodies.grid().area();
    let normal = press_rough(&bodies, &gap, force);
    let mut differences = Vec::new();
    for part in [0.2, 0.4, 0.6, 0.8] {
        let sheared = shear(&bodies, &normal, 0.5, part * 0.5 * force)?;
        let theory = linear_stick_ratio(force, 0.5, part * 0.5 * force)?;
        differences.push(sheared.stick_ratio() - theory);
    }
    Ok(rows(
        "linear stick ratio, Paggi et al. (2014)",
        "256 x 256",
        "rough_contacts::stick_ratio_falls_linearly_with_tangential_load",
        [("stick ratio, largest difference", max_abs(&differences))],
    )
    .collect())
}
