//! Tangential contact under a constant normal force.

use std::f64::consts::PI;

use kit::{Table2, l2_difference, rough, unit_bodies, unit_pair};
use stickslip::analytical::{
    CattaneoMindlin, CattaneoMindlinLine, Cone, ConePartialSlip, FlatPunch, HertzLine, HertzSphere,
};
use stickslip::tangential::{JaegerSuperposition, RelativeDisplacement};
use stickslip::{
    Field, Friction, Grid, HalfSpace, Material, Result, TangentialLoad, TangentialProblem, Zone,
    surface,
};

use crate::Group;
use crate::row::{
    DATUM, OFFSETS, Row, alike, l1, largest_difference, line, press, radius_about, raise, relative,
    rows, shear,
};

pub(crate) fn group() -> Result<Group> {
    let mut rows = sphere()?;
    rows.extend(cone()?);
    rows.extend(flat_punch()?);
    rows.extend(cylinder()?);
    rows.extend(bulk_stress()?);
    rows.extend(stiffness()?);
    rows.extend(superposition()?);
    Ok(Group {
        heading: "Tangential contact",
        caption: "The tangential force is 0.4 of the sliding force for the sphere and the cone, 0.5 for the punch, 0.6 for the\n\
                  cylinders and 0.5 for the rough surface. The bulk stress is 150 MPa at a largest pressure of 606 MPa and a friction\n\
                  coefficient of 0.5. The row on the stiffness is a mean over eight loads.",
        rows,
    })
}

fn sphere() -> Result<Vec<Row>> {
    let hertz = HertzSphere::new(&Table2::pair(), Table2::RADIUS, Table2::FORCE)?;
    let exact = CattaneoMindlin::new(hertz, Table2::FRICTION, 20.0)?;
    let grid = Grid::square(512, 3.0 * hertz.contact_radius())?;
    let bodies = HalfSpace::new(grid, Table2::pair())?;
    let mut errors = [0.0; 4];
    for offset in OFFSETS {
        let r = radius_about(grid, offset);
        let gap = Field::from_fn(grid, |x, y| 0.5 * r(x, y).powi(2) / Table2::RADIUS);
        let normal = press(&bodies, &gap, Table2::FORCE);
        let found = shear(&bodies, &normal, Table2::FRICTION, exact.force())?;
        let traction = Field::from_fn(grid, |x, y| exact.traction(r(x, y)));
        raise(
            &mut errors,
            [
                relative(found.shift()[0], exact.shift()),
                relative(found.stick_ratio(), exact.stick_ratio()),
                relative(found.dissipated_energy(), exact.energy_of_first_quarter()),
                l2_difference(found.traction()[0].as_slice(), traction.as_slice()),
            ],
        );
    }
    let [shift, stick, energy, field] = errors;
    let mindlin = "sphere, Cattaneo (1938), Mindlin (1949)";
    let table = "hertz_and_cattaneo_mindlin::sphere_on_512_cells_matches_table_2";
    let laws = "hertz_and_cattaneo_mindlin::errors_are_within_convergence_bounds";
    let scalars = [
        ("shift", shift),
        ("stick ratio", stick),
        ("dissipated energy", energy),
    ];
    let scalars = rows(mindlin, "512 x 512", table, scalars);
    let field = rows(mindlin, "512 x 512", laws, [("traction, L2", field)]);
    Ok(scalars.chain(field).collect())
}

fn cone() -> Result<Vec<Row>> {
    let (pair, friction) = (unit_pair(0.3), 0.4);
    // The contact radius is one.
    let cone = Cone::new(&pair, 0.02, 0.01 * PI)?;
    let exact = ConePartialSlip::new(cone, friction, 0.4 * friction * cone.load())?;
    let grid = Grid::square(192, 2.6)?;
    let bodies = HalfSpace::new(grid, pair)?;
    let mut errors = [0.0];
    for offset in OFFSETS {
        let r = radius_about(grid, offset);
        let gap = Field::from_fn(grid, |x, y| cone.slope() * r(x, y));
        let normal = press(&bodies, &gap, cone.load());
        let found = shear(&bodies, &normal, friction, exact.force())?;
        raise(&mut errors, [relative(found.shift()[0], exact.shift())]);
    }
    Ok(rows(
        "cone, Ciavarella (1998), Jaeger (1998)",
        "192 x 192",
        "closed_forms_cone_punch_waves::cone_converges_to_closed_form",
        [("shift", errors[0])],
    )
    .collect())
}

fn flat_punch() -> Result<Vec<Row>> {
    let (pair, friction) = (unit_pair(0.3), 0.4);
    let punch = FlatPunch::new(&pair, 1.0, 2.0)?;
    let exact = punch.full_stick(friction, 0.5 * friction * punch.load())?;
    let grid = Grid::square(182, 2.6)?;
    let bodies = HalfSpace::new(grid, pair)?;
    let mut errors = [0.0];
    for offset in OFFSETS {
        let r = radius_about(grid, offset);
        let gap = Field::from_fn(grid, |x, y| if r(x, y) < 1.0 { 0.0 } else { 1e3 });
        let normal = press(&bodies, &gap, punch.load());
        let found = shear(&bodies, &normal, friction, exact.force())?;
        raise(&mut errors, [relative(found.shift()[0], exact.shift())]);
    }
    Ok(rows(
        "flat punch in full stick, Johnson (1985), 3.7",
        "182 x 182",
        "closed_forms_cone_punch_waves::flat_punch_converges_to_closed_form",
        [("shift", errors[0])],
    )
    .collect())
}

fn cylinder() -> Result<Vec<Row>> {
    let pair = alike(Material::new(210e3, 0.3)?)?;
    let hertz = HertzLine::new(&pair, 10.0, 100.0)?;
    let exact = CattaneoMindlinLine::new(hertz, 0.5, 0.6 * 0.5 * 100.0)?;
    let bodies = line(512, 2.6 * hertz.half_width(), &pair)?;
    let normal = press(&bodies, &surface::cylinder(bodies.grid(), 10.0)?, 100.0);
    let found = shear(&bodies, &normal, 0.5, exact.force())?;
    let quantities = [
        ("shift", relative(found.shift()[0], exact.shift(DATUM))),
        (
            "traction, L1",
            l1(found.traction()[0], |x, _| exact.traction(x)),
        ),
    ];
    Ok(rows(
        "cylinder, Cattaneo (1938); Johnson (1985), 7.2",
        "512 x 1",
        "plane_strain_lines::cylinders_match_hertz_and_cattaneo",
        quantities,
    )
    .collect())
}

fn bulk_stress() -> Result<Vec<Row>> {
    let steel = Material::new(210e3, 0.3)?;
    let pair = alike(steel)?;
    let hertz = HertzLine::new(&pair, 10.0, 100.0)?;
    let strain = steel.plane_strain_under(150.0);
    let exact = CattaneoMindlinLine::new(hertz, 0.5, 0.6 * 0.5 * 100.0)?.with_strain(strain)?;
    let bodies = line(1024, 2.4 * hertz.half_width(), &pair)?;
    let grid = bodies.grid();
    let normal = press(&bodies, &surface::cylinder(grid, 10.0)?, 100.0);
    let load = TangentialLoad::force([exact.force(), 0.0]);
    let bulk = RelativeDisplacement::bulk_strain(grid, [[strain, 0.0], [0.0; 2]])?;
    let found = TangentialProblem::builder(&bodies, &normal, Friction::coulomb(0.5)?, load)
        .relative_displacement(bulk)
        .tolerance(1e-11)
        .build()?
        .solve()?;
    let sticks = |i: &usize| found.zones()[*i] == Zone::Stick;
    let ends = [
        (0..grid.nx()).find(sticks).unwrap_or(0),
        (0..grid.nx()).rfind(sticks).unwrap_or(0),
    ];
    let centre = 0.5 * (grid.x(ends[0]) + grid.x(ends[1]));
    let quantities = [
        (
            "centre of the stick zone",
            relative(centre, exact.stick_centre()),
        ),
        (
            "traction, L1",
            l1(found.traction()[0], |x, _| exact.traction(x)),
        ),
    ];
    Ok(rows(
        "cylinder under bulk stress, Nowell and Hills (1987)",
        "1024 x 1",
        "bulk_strain::moderate_strain_shifts_the_stick_zone",
        quantities,
    )
    .collect())
}

fn stiffness() -> Result<Vec<Row>> {
    let nu = 0.3;
    let bodies = unit_bodies(Grid::square(96, 12.0)?, nu);
    let gap = surface::sphere(bodies.grid(), 20.0)?;
    let loads = [5.0, 5.3, 5.6, 5.9, 6.2, 6.5, 6.8, 7.1];
    let mut mean = 0.0;
    for load in loads {
        let hertz = HertzSphere::new(bodies.pair(), 20.0, load)?;
        let normal = 2.0 * bodies.pair().contact_modulus() * hertz.contact_radius();
        let exact = normal * 2.0 * (1.0 - nu) / (2.0 - nu);
        let contact = press(&bodies, &gap, load);
        let found = shear(&bodies, &contact, 0.4, 0.1)?.stiffness(&bodies)?;
        let found = found.reversal[0][0].unwrap_or(f64::NAN);
        mean += relative(found, exact) / loads.len() as f64;
    }
    Ok(rows(
        "sphere, Mindlin (1949)",
        "96 x 96",
        "contact_stiffness::stiffness_converges_to_hertz_and_mindlin",
        [("tangential stiffness at reversal", mean)],
    )
    .collect())
}

/// The superposition is exact on the grid, so the error is the tolerance of the solves.
fn superposition() -> Result<Vec<Row>> {
    let grid = Grid::square(128, 100.0)?;
    let (gap, bodies) = (rough(grid, 11), unit_bodies(grid, 0.0));
    let (load, friction) = (20.0, 0.4);
    let full = press(&bodies, &gap, load);
    let stick = press(&bodies, &gap, 0.5 * load);
    let exact = JaegerSuperposition::new(&full, &stick, bodies.pair(), friction)?;
    let found = shear(&bodies, &full, friction, 0.5 * friction * load)?;
    let error = largest_difference(found.traction()[0].as_slice(), exact.traction().as_slice());
    Ok(rows(
        "rough surface with nu = 0, superposition of Jaeger (1998)",
        "128 x 128",
        "jaeger_superposition::superposition_is_exact_for_zero_poisson_ratio",
        [("traction, largest", error)],
    )
    .collect())
}
