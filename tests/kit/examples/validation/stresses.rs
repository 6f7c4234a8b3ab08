//! Influence coefficients, stresses below the surface, and coated bodies.

use kit::max_difference;
use stickslip::analytical::{HertzLine, HertzSphere};
use stickslip::influence::{Rectangle, Tensor};
use stickslip::layers::Layer;
use stickslip::subsurface::{Body, Planes, Stress, Tractions, at_points};
use stickslip::{
    CellValue, ElasticPair, Field, Grid, HalfSpace, Material, NormalLoad, Result, surface,
};

use crate::Group;
use crate::row::{Row, alike, data_lines, largest_difference, line, numbers, relative, rows};

const RANDOM_POINTS: &str = include_str!("../../../data/influence/random_points.csv");
const RECTANGLE: &str = include_str!("../../../data/subsurface/one_rectangle.csv");
const SPHERES: &str = include_str!("../../../data/layers/coated_sphere.csv");
const CELLS: &str = include_str!("../../../data/layers/cells.csv");
const BELOW: &str = include_str!("../../../data/layers/below.csv");

pub(crate) fn group() -> Result<Group> {
    let mut rows = influence()?;
    rows.extend(rectangle()?);
    rows.extend(cylinder()?);
    rows.extend(axis_of_ball()?);
    rows.extend(sliding_ball()?);
    rows.extend(coated_cells()?);
    rows.extend(coated_sphere()?);
    rows.extend(bonded_layer()?);
    rows.extend(coated_stresses()?);
    Ok(Group {
        heading: "Influence coefficients, stresses and coatings",
        caption: "The error of a coefficient is relative to the coefficient along z at the same point, and for the coupling to the\n\
                  coupling there. The error of a layered cell is relative to the coefficient at its centre. The errors of stresses are\n\
                  relative to the largest pressure, and for the rectangle to the largest stress at the point. The cylinder is compared\n\
                  at depths of 0.2, 0.786 and 2 half-widths. The friction coefficient of the sliding sphere is 0.5. The rows on the\n\
                  coated sphere list the largest errors of twelve coatings, with 0.25 to 4 times the modulus of the body. The bonded\n\
                  layer is ten times as thick as the square root of radius times approach.",
        rows,
    })
}

fn material(modulus: &str, poisson_ratio: &str) -> Result<Material> {
    let number = |text: &str| text.parse().unwrap_or(f64::NAN);
    match modulus.split_at_checked(1) {
        Some(("E", value)) => Material::new(number(value), number(poisson_ratio)),
        Some(("G", value)) => Material::from_shear_modulus(number(value), number(poisson_ratio)),
        _ => Ok(Material::rigid()),
    }
}

fn coefficients(t: &Tensor) -> [f64; 9] {
    [t.xx, t.xy, t.xz, t.yx, t.yy, t.yz, t.zx, t.zy, t.zz]
}

/// Returns the largest error of the nine coefficients over the points of a table.
fn influence_error(table: &str) -> Result<f64> {
    let mut largest = 0.0_f64;
    for line in data_lines(table) {
        let columns: Vec<&str> = line.split(',').collect();
        let number = |n: usize| columns[n].parse().unwrap_or(f64::NAN);
        let cell = Rectangle::new(number(3), number(4))?;
        let bodies = [
            material(columns[5], columns[6])?,
            material(columns[7], columns[8])?,
        ];
        let tensor = if bodies[1].is_rigid() {
            cell.tensor(&bodies[0], number(1), number(2))
        } else {
            let pair = ElasticPair::new(bodies[0], bodies[1])?;
            cell.pair_tensor(&pair, number(1), number(2))
        };
        let found = coefficients(&tensor);
        let coupling = number(15).hypot(number(16));
        for (n, found) in found.into_iter().enumerate() {
            let is_coupling = [2, 5, 6, 7].contains(&n);
            let scale = if is_coupling { coupling } else { number(17) };
            let error = (found - number(9 + n)).abs();
            if error > 0.0 {
                largest = largest.max(error / scale);
            }
        }
    }
    Ok(largest)
}

fn influence() -> Result<Vec<Row>> {
    Ok(rows(
        "quadrature in 80-digit arithmetic, 120 points",
        "1 x 1",
        "influence_coefficients::coefficients_match_exact_values_at_random_points",
        [(
            "nine influence coefficients",
            influence_error(RANDOM_POINTS)?,
        )],
    )
    .collect())
}

fn components(stress: &Stress) -> [f64; 6] {
    [
        stress.xx, stress.yy, stress.zz, stress.xy, stress.xz, stress.yz,
    ]
}

/// Compares the stresses of a unit pressure and of unit tractions on one cell.
fn rectangle() -> Result<Vec<Row>> {
    let mut largest = 0.0_f64;
    for line in data_lines(RECTANGLE) {
        let row = numbers(line);
        let grid = Grid::new(1, 1, 2.0 * row[0], 2.0 * row[1])?;
        let body = Material::from_shear_modulus(1.0, row[2])?;
        let bodies = HalfSpace::new(grid, ElasticPair::new(body, Material::rigid())?)?;
        for (load, expected) in row[6..].chunks(9).enumerate() {
            let of = |n| Field::constant(grid, if n == load { 1.0 } else { 0.0 });
            let [p, x, y] = [0, 1, 2].map(of);
            let tractions = Tractions::new(&p).with_traction([&x, &y]);
            let point = [row[3], row[4], row[5]];
            let found = at_points(&bodies, Body::One, tractions, &[point])?;
            let error = largest_difference(&components(&found[0].stress), &expected[3..]);
            largest = largest.max(error);
        }
    }
    Ok(rows(
        "potentials in multiple precision, 30 points below a rectangle",
        "1 x 1",
        "subsurface_points::single_rectangle_matches_multiprecision_values",
        [("six stresses", largest)],
    )
    .collect())
}

fn cylinder() -> Result<Vec<Row>> {
    let body = Material::from_shear_modulus(1.0, 0.3)?;
    let pair = alike(body)?;
    // The half-width is one.
    let load = std::f64::consts::PI * pair.contact_modulus() / 4.0;
    let hertz = HertzLine::new(&pair, 1.0, load)?;
    let bodies = line(512, 3.0, &pair)?;
    let pressure = Field::from_fn(bodies.grid(), |x, _| hertz.pressure(x));
    let mut largest = [0.0_f64; 2];
    let mut planes = Planes::new(&bodies, &[0.2, 0.786, 2.0])?;
    planes.through(Body::One, Tractions::new(&pressure), |plane| {
        for (ix, stress) in plane.stresses().enumerate() {
            let expected = hertz.stress(bodies.grid().x(ix), plane.depth());
            let error = max_difference(&[stress.xx, stress.zz, stress.xz], &expected);
            largest[0] = largest[0].max(error / hertz.max_pressure());
        }
        Ok(())
    })?;
    let plane = planes.solve(1, Body::One, Tractions::new(&pressure))?;
    let shear = plane.map(|stress| stress.max_shear()).max();
    let [along, down, _] = hertz.stress(0.0, 0.786);
    largest[1] = relative(shear, 0.5 * (along - down));
    let quantities = [
        ("three stresses", largest[0]),
        ("largest shear stress, 0.300 p0", largest[1]),
    ];
    Ok(rows(
        "cylinder, M'Ewen (1949); Johnson (1985), 4.3",
        "512 x 1",
        "subsurface_planes::cylinder_stresses_match_mcewen",
        quantities,
    )
    .collect())
}

/// Returns a Hertzian pressure of radius and maximum one.
fn ball(cells: usize) -> Result<(HalfSpace, Field)> {
    let grid = Grid::square(cells, 2.2)?;
    let body = Material::from_shear_modulus(1.0, 0.3)?;
    let bodies = HalfSpace::new(grid, alike(body)?)?;
    let pressure = Field::from_fn(grid, |x, y| (1.0 - x * x - y * y).max(0.0).sqrt());
    Ok((bodies, pressure))
}

/// Compares with the largest shear stress on the axis, 0.310 of the largest pressure at the depth 0.48 a for a Poisson's
/// ratio of 0.3.
fn axis_of_ball() -> Result<Vec<Row>> {
    let (bodies, pressure) = ball(96)?;
    let (shear, depth) = (0.5 * 0.620041, 0.480864);
    let points = [-0.04, 0.0, 0.04].map(|shift| [0.0, 0.0, depth + shift]);
    let found = at_points(&bodies, Body::One, Tractions::new(&pressure), &points)?;
    let [before, at, after] = [0, 1, 2].map(|n: usize| found[n].stress.max_shear());
    // The largest value is at the vertex of the parabola through the three values.
    let vertex = 0.02 * (after - before) / (2.0 * at - before - after);
    let quantities = [
        ("largest shear stress on the axis", relative(at, shear)),
        ("its depth", (vertex / depth).abs()),
    ];
    Ok(rows(
        "sphere, nu = 0.3, Huber (1904); Johnson (1985), 3.4",
        "96 x 96",
        "subsurface_planes::ball_has_largest_shear_stress_near_half_the_contact_radius",
        quantities,
    )
    .collect())
}

/// The expected von Mises stresses are values of the test, by quadrature.
fn sliding_ball() -> Result<Vec<Row>> {
    let (bodies, pressure) = ball(128)?;
    let (shear, none) = (pressure.scaled(0.5), Field::zeros(pressure.grid()));
    let tractions = Tractions::new(&pressure).with_traction([&shear, &none]);
    let known = [
        ([0.0, 0.0, 0.48], 0.667317489751),
        ([0.5, 0.0, 0.25], 0.725991837238),
        ([-0.5, 0.0, 0.25], 0.599667497383),
        ([0.46146, 0.0, 0.33127], 0.732064998),
    ];
    let found = at_points(
        &bodies,
        Body::One,
        tractions,
        &known.map(|(point, _)| point),
    )?;
    let found: Vec<f64> = found.iter().map(|point| point.stress.von_mises()).collect();
    let error = max_difference(&found, &known.map(|(_, von_mises)| von_mises));
    Ok(rows(
        "sliding sphere, nu = 0.3, Hamilton and Goodman (1966)",
        "128 x 128",
        "subsurface_planes::sliding_ball_matches_hamilton",
        [("von Mises stress at four points", error)],
    )
    .collect())
}

fn layer(shear_modulus: f64, poisson_ratio: f64, thickness: f64) -> Result<Layer> {
    let youngs_modulus = 2.0 * (1.0 + poisson_ratio) * shear_modulus;
    Layer::new(youngs_modulus, poisson_ratio, thickness)
}

/// Parses a body of layers on a base. Layers are given as shear modulus, Poisson's ratio and thickness.
fn coated_body(layers: &str, base: &str) -> Result<Material> {
    let values = |text: &str| -> Vec<f64> {
        text.split('/')
            .filter_map(|text| text.parse().ok())
            .collect()
    };
    let base = match values(base)[..] {
        [modulus, poisson_ratio] => Material::from_shear_modulus(modulus, poisson_ratio)?,
        _ => Material::rigid(),
    };
    let layers: Result<Vec<Layer>> = layers
        .split(';')
        .map(|text| {
            let of = values(text);
            layer(of[0], of[1], of[2])
        })
        .collect();
    base.coated(&layers?)
}

fn coated_cells() -> Result<Vec<Row>> {
    let mut largest = 0.0_f64;
    for line in CELLS.lines().skip(1) {
        let columns: Vec<&str> = line.split(',').collect();
        let number = |n: usize| columns[n].parse().unwrap_or(f64::NAN);
        let cell = Rectangle::new(number(2), number(3))?;
        let body = coated_body(columns[0], columns[1])?;
        let own = cell.tensor(&body, 0.0, 0.0);
        let unit = own.zz.max(own.xx).max(own.yy);
        let found = cell.tensor(&body, number(4), number(5));
        let found = [found.zz, found.xx, found.yy, found.xy, found.zx, found.zy];
        let expected: Vec<f64> = (6..12).map(number).collect();
        largest = largest.max(max_difference(&found, &expected) / unit);
    }
    Ok(rows(
        "layered half-spaces in 60-digit arithmetic, 40 points",
        "1 x 1",
        "coated_bodies::coefficients_match_independent_evaluation",
        [("six influence coefficients", largest)],
    )
    .collect())
}

fn coated_sphere() -> Result<Vec<Row>> {
    let substrate = Material::from_shear_modulus(1.0, 0.3)?;
    let plain = ElasticPair::new(substrate, Material::rigid())?;
    let hertz = HertzSphere::new(&plain, 10.0, 1.0)?;
    let mut largest = [0.0_f64; 2];
    for line in SPHERES.lines().skip(1) {
        let row = numbers(line);
        let coating = layer(row[0], 0.3, row[1] * hertz.contact_radius())?;
        let pair = ElasticPair::new(substrate.coated(&[coating])?, Material::rigid())?;
        let grid = Grid::square(128, 3.1 * row[2] * hertz.contact_radius())?;
        let bodies = HalfSpace::new(grid, pair)?;
        let gap = surface::sphere(grid, hertz.radius())?;
        let load = NormalLoad::Force(1.0);
        let found = kit::press(&bodies, &gap, load, 1e-8);
        let approach = relative(found.approach(), row[4] * hertz.approach());
        let pressure = relative(found.pressure().max(), row[3] * hertz.max_pressure());
        largest = [largest[0].max(approach), largest[1].max(pressure)];
    }
    let quantities = [("approach", largest[0]), ("largest pressure", largest[1])];
    Ok(rows(
        "coated sphere, axisymmetric Fredholm equation",
        "128 x 128",
        "coated_bodies::sphere_on_coating_matches_axisymmetric_solution",
        quantities,
    )
    .collect())
}

/// The first coefficients of the series are the exact ones that the test derives.
fn bonded_layer() -> Result<Vec<Row>> {
    let (x, thickness) = (0.1_f64, 0.1);
    let approach = (x * thickness).powi(2);
    let body = Material::rigid().coated(&[layer(1.0, 0.5, thickness)?])?;
    let pair = ElasticPair::new(body, Material::rigid())?;
    let grid = Grid::square(192, 2.6 * approach.sqrt())?;
    let bodies = HalfSpace::new(grid, pair)?.with_cell_value(CellValue::Centre)?;
    let gap = Field::from_fn(grid, |x, y| 0.5 * (x * x + y * y));
    let load = NormalLoad::Approach(approach);
    let found = kit::press(&bodies, &gap, load, 1e-9);
    let first = 2.0 / std::f64::consts::PI * 1.770_216_773_4;
    let second = 7.0 / 6.0 * first * first;
    let series = 1.0 + x * (first + x * (second + x * (1.469 + x * 0.755)));
    // E* is 2 G / (1 - nu).
    let hertz = 4.0 / 3.0 * 4.0 * approach.powf(1.5);
    Ok(rows(
        "paraboloid on a bonded layer, Garcia and Garcia (2018)",
        "192 x 192",
        "coated_bodies::paraboloid_on_bonded_layer_matches_published_series",
        [("force", relative(found.force(), series * hertz))],
    )
    .collect())
}

fn coated_stresses() -> Result<Vec<Row>> {
    let grid = Grid::square(65, 2.6)?;
    let coated = coated_body("3/0.35/0.4", "1/0.25")?;
    let pair = ElasticPair::new(coated, Material::rigid())?;
    let bodies = HalfSpace::new(grid, pair)?.with_cell_value(CellValue::Centre)?;
    let pressure = Field::from_fn(grid, |x, y| (1.0 - x * x - y * y).max(0.0).powi(3));
    let mut largest = 0.0_f64;
    for line in BELOW.lines().skip(1) {
        // A plus sign selects the side of the base at the interface.
        let row = numbers(&line.replacen('+', "", 1));
        let is_base = line.contains('+');
        let depth = if is_base {
            row[0] * (1.0 + f64::EPSILON)
        } else {
            row[0]
        };
        let column: usize = line
            .split(',')
            .nth(1)
            .and_then(|text| text.parse().ok())
            .unwrap_or(0);
        let mut planes = Planes::new(&bodies, &[depth])?;
        let plane = planes.solve(0, Body::One, Tractions::new(&pressure))?;
        let stress = plane.get(column, 32).unwrap_or_default();
        let found = [stress.xx, stress.yy, stress.zz, stress.xz];
        largest = largest.max(max_difference(&found, &row[2..6]));
    }
    Ok(rows(
        "coated half-space, Hankel integrals",
        "65 x 65",
        "coated_stresses::coated_stresses_match_independent_quadrature",
        [("four stresses", largest)],
    )
    .collect())
}
