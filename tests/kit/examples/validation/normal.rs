//! Normal contact.

use std::f64::consts::PI;

use kit::measure::distance;
use kit::smooth::Smooth;
use kit::{Table2, l2_difference, unit_bodies, unit_pair};
use stickslip::analytical::{Cone, FlatPunch, HertzLine, HertzSphere, RoundedPunch};
use stickslip::{CellValue, Field, Grid, HalfSpace, Material, Result, surface};

use crate::Group;
use crate::row::{OFFSETS, Row, alike, l1, line, press, radius_about, raise, relative, rows};

pub(crate) fn group() -> Result<Group> {
    let mut rows = sphere()?;
    rows.extend(ellipse()?);
    rows.extend(cylinder()?);
    rows.extend(rounded_punch()?);
    rows.extend(cone()?);
    rows.extend(flat_punch()?);
    rows.extend(stiffness()?);
    Ok(Group {
        heading: "Normal contact",
        caption: "The side of the grid is 3 contact radii for the sphere and the ellipse, and 2.6 radii for the cone and the flat\n\
                  punch. The line of cells is 2.6 half-widths long for the cylinder and 2.4 for the rounded punch. The row on the\n\
                  stiffness is a mean over eight loads.",
        rows,
    })
}

fn sphere() -> Result<Vec<Row>> {
    let hertz = HertzSphere::new(&Table2::pair(), Table2::RADIUS, Table2::FORCE)?;
    let grid = Grid::square(512, 3.0 * hertz.contact_radius())?;
    let bodies = HalfSpace::new(grid, Table2::pair())?;
    let mut errors = [0.0; 5];
    for offset in OFFSETS {
        let r = radius_about(grid, offset);
        let gap = Field::from_fn(grid, |x, y| 0.5 * r(x, y).powi(2) / Table2::RADIUS);
        let found = press(&bodies, &gap, Table2::FORCE);
        let exact = Field::from_fn(grid, |x, y| hertz.pressure(r(x, y)));
        raise(
            &mut errors,
            [
                relative(found.approach(), hertz.approach()),
                relative(found.pressure().max(), hertz.max_pressure()),
                relative(found.contact_area(), hertz.contact_area()),
                relative(found.contact_area_corrected(), hertz.contact_area()),
                l2_difference(found.pressure().as_slice(), exact.as_slice()),
            ],
        );
    }
    let [approach, peak, counted, corrected, field] = errors;
    let hertz = "sphere, Hertz; Johnson (1985), 4.2";
    let table = "hertz_and_cattaneo_mindlin::sphere_on_512_cells_matches_table_2";
    let laws = "hertz_and_cattaneo_mindlin::errors_are_within_convergence_bounds";
    let scalars = [
        ("approach", approach),
        ("largest pressure", peak),
        ("contact area, counted", counted),
        ("contact area, corrected", corrected),
    ];
    let scalars = rows(hertz, "512 x 512", table, scalars);
    let field = rows(hertz, "512 x 512", laws, [("pressure, L2", field)]);
    Ok(scalars.chain(field).collect())
}

/// Uses values at the centres of the cells and edges inside the cells, as the test does.
fn ellipse() -> Result<Vec<Row>> {
    let grid = Grid::square(64, 3.0)?;
    let bodies = unit_bodies(grid, 0.0).with_cell_value(CellValue::Centre)?;
    let shape = Smooth::ellipse();
    let mut errors = [0.0; 2];
    for offset in OFFSETS {
        let edges = press(&bodies, &shape.gap(grid, offset), shape.force).edges()?;
        let exact = shape.pressure(grid, offset);
        let field = distance(edges.centres(), &exact);
        raise(&mut errors, [relative(edges.area(), shape.area), field]);
    }
    let [area, field] = errors;
    let test = "contact_edges::edges_of_closed_form_contacts_match_area_and_pressure";
    let quantities = [
        ("contact area, with edges", area),
        ("pressure, with edges, L1", field),
    ];
    let hertz = "ellipse 2 : 1, Hertz; Johnson (1985), 4.2";
    Ok(rows(hertz, "64 x 64", test, quantities).collect())
}

fn cylinder() -> Result<Vec<Row>> {
    let pair = alike(Material::new(210e3, 0.3)?)?;
    let hertz = HertzLine::new(&pair, 10.0, 100.0)?;
    let bodies = line(512, 2.6 * hertz.half_width(), &pair)?;
    let found = press(&bodies, &surface::cylinder(bodies.grid(), 10.0)?, 100.0);
    let quantities = [(
        "largest pressure",
        relative(found.pressure().max(), hertz.max_pressure()),
    )];
    let test = "plane_strain_lines::cylinders_match_hertz_and_cattaneo";
    Ok(rows(
        "cylinder, Hertz; Johnson (1985), 4.2",
        "512 x 1",
        test,
        quantities,
    )
    .collect())
}

fn rounded_punch() -> Result<Vec<Row>> {
    let (flat, load) = (0.9, 0.4);
    let exact = RoundedPunch::new(&unit_pair(0.3), flat, 20.0, load)?;
    let bodies = line(512, 2.4 * exact.half_width(), &unit_pair(0.3))?;
    let gap = Field::from_fn(bodies.grid(), |x, _| {
        (x.abs() - flat).max(0.0).powi(2) / 40.0
    });
    let found = press(&bodies, &gap, load);
    let error = l1(found.pressure(), |x, _| exact.pressure(x));
    Ok(rows(
        "punch with rounded edges, Ciavarella, Hills and Monno (1998)",
        "512 x 1",
        "plane_strain_lines::rounded_punches_match_ciavarella",
        [("pressure, L1", error)],
    )
    .collect())
}

fn cone() -> Result<Vec<Row>> {
    let pair = unit_pair(0.3);
    // The contact radius is one.
    let cone = Cone::new(&pair, 0.02, 0.01 * PI)?;
    let grid = Grid::square(192, 2.6)?;
    let bodies = HalfSpace::new(grid, pair)?;
    let mut errors = [0.0];
    for offset in OFFSETS {
        let r = radius_about(grid, offset);
        let gap = Field::from_fn(grid, |x, y| cone.slope() * r(x, y));
        let found = press(&bodies, &gap, cone.load());
        raise(&mut errors, [relative(found.approach(), cone.approach())]);
    }
    Ok(rows(
        "cone, Sneddon (1965)",
        "192 x 192",
        "closed_forms_cone_punch_waves::cone_converges_to_closed_form",
        [("approach", errors[0])],
    )
    .collect())
}

fn flat_punch() -> Result<Vec<Row>> {
    let pair = unit_pair(0.3);
    let punch = FlatPunch::new(&pair, 1.0, 2.0)?;
    let grid = Grid::square(182, 2.6)?;
    let bodies = HalfSpace::new(grid, pair)?;
    let mut errors = [0.0];
    for offset in OFFSETS {
        let r = radius_about(grid, offset);
        let gap = Field::from_fn(grid, |x, y| if r(x, y) < 1.0 { 0.0 } else { 1e3 });
        let found = press(&bodies, &gap, punch.load());
        raise(&mut errors, [relative(found.approach(), punch.approach())]);
    }
    Ok(rows(
        "flat punch, Johnson (1985), 3.4",
        "182 x 182",
        "closed_forms_cone_punch_waves::flat_punch_converges_to_closed_form",
        [("approach", errors[0])],
    )
    .collect())
}

fn stiffness() -> Result<Vec<Row>> {
    let bodies = unit_bodies(Grid::square(96, 12.0)?, 0.3);
    let gap = surface::sphere(bodies.grid(), 20.0)?;
    let loads = [5.0, 5.3, 5.6, 5.9, 6.2, 6.5, 6.8, 7.1];
    let mut mean = 0.0;
    for load in loads {
        let hertz = HertzSphere::new(bodies.pair(), 20.0, load)?;
        let exact = 2.0 * bodies.pair().contact_modulus() * hertz.contact_radius();
        let found = press(&bodies, &gap, load).stiffness(&bodies)?;
        mean += relative(found.value, exact) / loads.len() as f64;
    }
    Ok(rows(
        "sphere, 2 E* a; Johnson (1985), 4.2",
        "96 x 96",
        "contact_stiffness::stiffness_converges_to_hertz_and_mindlin",
        [("normal stiffness", mean)],
    )
    .collect())
}
