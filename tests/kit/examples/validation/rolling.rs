//! Steady rolling.

use kit::measure::distance;
use stickslip::analytical::{
    BentallJohnson, Carter, HertzEllipse, HertzLine, KalkerCoefficients, VermeulenJohnson,
};
use stickslip::rolling::{CoupledRollingProblem, RollingControl, RollingProblem};
use stickslip::{
    Axis, ElasticPair, Field, Friction, Grid, HalfSpace, Material, NormalLoad, Result, surface,
};

use crate::Group;
use crate::row::{Row, alike, line, press, relative, rows};

pub(crate) fn group() -> Result<Group> {
    let mut rows = carter()?;
    rows.extend(kalker()?);
    rows.extend(strips()?);
    rows.extend(vermeulen_johnson()?);
    rows.extend(bentall_johnson()?);
    Ok(Group {
        heading: "Rolling",
        caption: "The errors of force and traction of Carter's cylinder are means over three positions. The creepage is 0.4 of the creepage at\n\
                  sliding in these rows, and the force is half of the sliding force in the row on the creepage. Kalker's\n\
                  coefficients are printed with three digits. The creep curve of Vermeulen and Johnson is approximate and is compared\n\
                  at a third of the creepage at sliding. The free rollers have moduli of 1e3 and 1e5 MPa.",
        rows,
    })
}

fn carter() -> Result<Vec<Row>> {
    let (pair, friction) = (alike(Material::new(1.0, 0.0)?)?, 0.3);
    // The half-width is one.
    let load = std::f64::consts::PI * pair.contact_modulus() / 4.0;
    let hertz = HertzLine::new(&pair, 1.0, load)?;
    let creepage = 0.4 * Carter::new(hertz, friction, 0.0)?.sliding_creepage();
    let exact = Carter::new(hertz, friction, creepage)?;
    let dx = 2.0 / 128.0;
    let bodies = line(136, 136.0 * dx, &pair)?;
    let mut mean = [0.0; 2];
    for offset in [0.1, 0.37, 0.77] {
        let gap = Field::from_fn(bodies.grid(), |x, _| 0.5 * (x + offset * dx).powi(2));
        let normal = press(&bodies, &gap, load);
        let rolling = RollingProblem::builder(&bodies, &normal, Friction::coulomb(friction)?)
            .creepage([creepage, 0.0])
            .build()?
            .solve()?;
        let traction = Field::from_fn(bodies.grid(), |x, _| exact.traction(x + offset * dx));
        mean[0] += relative(rolling.force()[0], exact.force()) / 3.0;
        mean[1] += distance(rolling.traction()[0], &traction) / 3.0;
    }
    let normal = press(&bodies, &surface::cylinder(bodies.grid(), 1.0)?, load);
    let rolling = RollingProblem::builder(&bodies, &normal, Friction::coulomb(friction)?)
        .control(Axis::X, RollingControl::Force(0.5 * friction * load))
        .build()?
        .solve()?;
    let creepage = exact.sliding_creepage() * (1.0 - 0.5_f64.sqrt());
    let carter = "cylinder, Carter (1926)";
    let test = "steady_rolling::carter_force_converges_with_second_order";
    let forces = [("force", mean[0]), ("traction, L1", mean[1])];
    let forces = rows(carter, "136 x 1", test, forces);
    let test = "rolling_lines::cylinder_under_force_has_creepage_of_carter_for_any_datum";
    let error = relative(rolling.creepage()[0], creepage);
    let creepage = rows(carter, "136 x 1", test, [("creepage", error)]);
    Ok(forces.chain(creepage).collect())
}

/// Solves at small creepages and large friction, so that all cells except for a few at the edge stick.
fn kalker() -> Result<Vec<Row>> {
    let grid = Grid::square(48, 2.25)?;
    let pair = alike(Material::from_shear_modulus(1.0, 0.25)?)?;
    let bodies = HalfSpace::new(grid, pair)?;
    // The contact radius is one.
    let load = 4.0 / 3.0 * pair.contact_modulus();
    let normal = press(&bodies, &surface::sphere(grid, 1.0)?, load);
    let tiny = 1e-3;
    let force = |creepage: [f64; 2], spin: f64| -> Result<[f64; 2]> {
        let problem = RollingProblem::builder(&bodies, &normal, Friction::coulomb(1e4)?);
        let rolling = problem.creepage(creepage).spin(spin).build()?.solve()?;
        Ok(rolling.force().map(|force| force / tiny))
    };
    let quantities = [
        ("C11", relative(force([tiny, 0.0], 0.0)?[0], 4.12)),
        ("C22", relative(force([0.0, tiny], 0.0)?[1], 3.67)),
        ("C23", relative(force([0.0, 0.0], tiny)?[1], 1.47)),
    ];
    Ok(rows(
        "circle, nu = 0.25, Kalker (1990), table E.3",
        "48 x 48",
        "steady_rolling::small_creepages_match_kalker_coefficients",
        quantities,
    )
    .collect())
}

fn strips() -> Result<Vec<Row>> {
    let thin = KalkerCoefficients::new(0.0625, 0.25)?;
    let strip = std::f64::consts::PI.powi(2) / 4.0;
    let quantities = [
        (
            "C11 of the crate's table",
            relative(thin.c11(), strip / 0.75),
        ),
        ("C22 of the crate's table", relative(thin.c22(), strip)),
    ];
    Ok(rows(
        "strip theory, ellipse 1 : 16, nu = 0.25, Kalker (1990), 4.2",
        "table",
        "rolling_closed_forms::thin_ellipse_matches_strip_theory",
        quantities,
    )
    .collect())
}

fn vermeulen_johnson() -> Result<Vec<Row>> {
    let (friction, load) = (0.3, 1.0);
    let pair = alike(Material::from_shear_modulus(1.0, 0.25)?)?;
    let circle = HertzEllipse::new(&pair, 1.0, 1.0, load)?;
    let a = circle.semi_axes()[0];
    let grid = Grid::square(44, 2.75 * a)?;
    let bodies = HalfSpace::new(grid, pair)?;
    let normal = press(&bodies, &surface::sphere(grid, 1.0)?, load);
    let slope = KalkerCoefficients::new(1.0, 0.25)?.c11();
    let creepage = [friction * load / (a * a) / slope, 0.0];
    let rolling = RollingProblem::builder(&bodies, &normal, Friction::coulomb(friction)?)
        .creepage(creepage)
        .build()?
        .solve()?;
    let curve = VermeulenJohnson::new(circle, friction, creepage)?;
    let error = relative(rolling.force()[0], curve.force()[0]);
    Ok(rows(
        "circle, Vermeulen and Johnson (1964)",
        "44 x 44",
        "rolling_closed_forms::creep_curve_is_near_vermeulen_johnson",
        [("force", error)],
    )
    .collect())
}

fn bentall_johnson() -> Result<Vec<Row>> {
    let (radius, load, friction) = (10.0, 100.0, 1e-4);
    let pair = ElasticPair::new(Material::new(1e3, 0.2)?, Material::new(1e5, 0.3)?)?;
    let hertz = HertzLine::new(&pair, radius, load)?;
    let free = BentallJohnson::new(hertz, friction)?;
    let on = |cells: usize| {
        let width = 2.0 * hertz.half_width() * (cells + 8) as f64 / cells as f64;
        line(cells + 8, width, &pair)
    };
    let still = RollingControl::Force(0.0);
    let bodies = on(256)?;
    let gap = surface::cylinder(bodies.grid(), radius)?;
    let normal = press(&bodies, &gap, load);
    let rolling = RollingProblem::builder(&bodies, &normal, Friction::coulomb(friction)?)
        .control(Axis::X, still)
        .build()?
        .solve()?;
    let quantities = [
        ("creepage", relative(rolling.creepage()[0], free.creepage())),
        (
            "dissipation",
            relative(
                rolling.dissipation_per_area()?.integral(),
                free.dissipation(),
            ),
        ),
    ];
    let free_rollers = "free rollers, Bentall and Johnson (1967)";
    let test = "rolling_closed_forms::free_rolling_creepage_matches_bentall_johnson";
    let one_way = rows(free_rollers, "264 x 1", test, quantities);
    let bodies = on(128)?;
    let gap = surface::cylinder(bodies.grid(), radius)?;
    let force = NormalLoad::Force(load);
    let coupled =
        CoupledRollingProblem::builder(&bodies, &gap, Friction::coulomb(friction)?, force)
            .control(Axis::X, still)
            .build()?
            .solve()?;
    let error = relative(coupled.rolling().creepage()[0], free.creepage());
    let test = "coupled_rolling::coupled_free_rollers_match_bentall_johnson";
    let coupled = rows(
        free_rollers,
        "136 x 1",
        test,
        [("creepage, full coupling", error)],
    );
    Ok(one_way.chain(coupled).collect())
}
