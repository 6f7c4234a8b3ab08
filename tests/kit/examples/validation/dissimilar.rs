//! Bodies of different materials.

use stickslip::analytical::{FlatPunch, HertzSphere, NoSlipPunch, NoSlipSphere, SpencePressing};
use stickslip::{
    CoupledProblem, CoupledSolution, Coupling, ElasticPair, Field, Friction, Grid, HalfSpace,
    History, LoadStep, NormalLoad, Result, TangentialLoad, TangentialModel, TangentialProblem,
    surface,
};

use crate::Group;
use crate::row::{Row, line, on_rigid, press, relative, rows, with_beta};

/// Dundurs' beta for all rows on stick zones: an elastic body with a Poisson's ratio of zero on a rigid body.
const BETA: f64 = 0.5;
/// Stick radius over contact radius, and the friction coefficient at which it occurs, for a round punch and for a punch
/// in plane strain. The tests state the source.
const ROUND: [f64; 2] = [0.5, 0.29872];
const PLANE: [f64; 2] = [0.3, 0.36868];

pub(crate) fn group() -> Result<Group> {
    let mut rows = one_way_punches()?;
    rows.extend(coupled_punches()?);
    rows.extend(stepwise_sphere()?);
    rows.extend(full_stick_punch()?);
    rows.extend(full_stick_sphere()?);
    Ok(Group {
        heading: "Bodies of different materials",
        caption: "An elastic body is pressed onto a rigid body. Its Poisson's ratio is 0 in the rows on stick radii and 0.3 in the\n\
                  rows on full stick. The friction coefficient is 0.35 with one-way coupling, 0.29872 for round contacts with full\n\
                  coupling, 0.36868 in plane strain with full coupling, and 20 in full stick. The sphere is pressed in 32 steps of\n\
                  equal growth of the contact radius. Its full stick is extrapolated from 16 and 32 steps. Half-widths are multiples of\n\
                  half a cell.",
        rows,
    })
}

fn punch(cells: usize, pair: &ElasticPair) -> Result<(HalfSpace, Field)> {
    let grid = Grid::square(cells, 2.4)?;
    let gap = Field::from_fn(grid, |x, y| if x.hypot(y) < 1.0 { 0.0 } else { 1e3 });
    Ok((HalfSpace::new(grid, *pair)?, gap))
}

/// Returns a punch of half-width one whose edges coincide with the edges of cells.
fn plane_punch(cells: usize, pair: &ElasticPair) -> Result<(HalfSpace, Field)> {
    let all = cells + cells / 8;
    let bodies = line(all, 2.0 * all as f64 / cells as f64, pair)?;
    let gap = Field::from_fn(bodies.grid(), |x, _| if x.abs() < 1.0 { 0.0 } else { 1e3 });
    Ok((bodies, gap))
}

fn one_way(
    (bodies, gap): &(HalfSpace, Field),
    friction: f64,
    model: TangentialModel,
) -> Result<f64> {
    let normal = press(bodies, gap, 1.0);
    let still = TangentialLoad::shift([0.0; 2]);
    let problem = TangentialProblem::builder(bodies, &normal, Friction::coulomb(friction)?, still);
    let problem = problem.model(model).coupling(Coupling::OneWay);
    Ok(problem.build()?.solve()?.stick_ratio())
}

fn coupled((bodies, gap): &(HalfSpace, Field), friction: f64) -> Result<CoupledSolution> {
    let (load, still) = (NormalLoad::Force(1.0), TangentialLoad::shift([0.0; 2]));
    let friction = Friction::coulomb(friction)?;
    let problem = CoupledProblem::builder(bodies, gap, friction, load, still);
    problem.tolerance(1e-8).build()?.solve()
}

fn one_way_punches() -> Result<Vec<Row>> {
    let (pair, friction) = (with_beta(BETA)?, 0.35);
    let round = one_way(&punch(129, &pair)?, friction, TangentialModel::Vector)?.sqrt();
    let plane = one_way(&plane_punch(256, &pair)?, friction, TangentialModel::Scalar)?;
    let error = |found: f64, exact: SpencePressing| relative(found, exact.stick_radius());
    let round = error(round, SpencePressing::round(&pair, friction)?);
    let plane = error(plane, SpencePressing::plane(&pair, friction)?);
    let test = "one_way_coupling::one_way_punch_sticks_as_in_spence";
    let spence = "round punch, Goodman's approximation, Spence (1975)";
    let round = rows(
        spence,
        "129 x 129",
        test,
        [("stick radius, one-way", round)],
    );
    let test = "plane_strain_lines::dissimilar_punches_stick_as_in_spence";
    let spence = "punch in plane strain, Goodman's approximation, Spence (1973)";
    let plane = rows(
        spence,
        "288 x 1",
        test,
        [("stick half-width, one-way", plane)],
    );
    Ok(round.chain(plane).collect())
}

fn coupled_punches() -> Result<Vec<Row>> {
    let pair = with_beta(BETA)?;
    let round = coupled(&punch(129, &pair)?, ROUND[1])?
        .tangential()
        .stick_ratio()
        .sqrt();
    let plane = coupled(&plane_punch(256, &pair)?, PLANE[1])?
        .tangential()
        .stick_ratio();
    let test = "coupled_contact::punch_stick_radii_converge_with_the_grid";
    let quantity = [("stick radius", relative(round, ROUND[0]))];
    let round = rows("round punch, ring elements", "129 x 129", test, quantity);
    let test = "plane_strain_lines::dissimilar_punches_stick_as_in_spence";
    let quantity = [("stick half-width", relative(plane, PLANE[0]))];
    let plane = rows(
        "punch in plane strain, line elements",
        "288 x 1",
        test,
        quantity,
    );
    Ok(round.chain(plane).collect())
}

/// Presses a sphere in steps until the Hertzian contact has a radius of one.
fn pressed_sphere(pair: &ElasticPair, friction: f64, steps: u32) -> Result<(History, f64)> {
    let grid = Grid::square(65, 2.4)?;
    let bodies = HalfSpace::new(grid, *pair)?;
    let whole = 4.0 / 30.0 * pair.contact_modulus();
    let ball = surface::sphere(grid, 10.0)?;
    let builder = History::builder(&bodies, &ball, Friction::coulomb(friction)?);
    let mut history = builder.tolerance(1e-6).build()?;
    for step in 1..=steps {
        let radius = f64::from(step) / f64::from(steps);
        let force = NormalLoad::Force(whole * radius.powi(3));
        history.step(&LoadStep::hold().normal(force))?;
    }
    Ok((history, whole))
}

fn stepwise_sphere() -> Result<Vec<Row>> {
    let (history, _) = pressed_sphere(&with_beta(BETA)?, ROUND[1], 32)?;
    let error = relative(history.last_step()?.stick_ratio().sqrt(), ROUND[0]);
    Ok(rows(
        "sphere, ring elements and the similarity of Spence (1968)",
        "65 x 65",
        "stepwise_pressing::stepwise_pressed_sphere_sticks_as_in_spence",
        [("stick radius", error)],
    )
    .collect())
}

fn full_stick_punch() -> Result<Vec<Row>> {
    let pair = on_rigid(0.3)?;
    let problem = punch(129, &pair)?;
    let stuck = coupled(&problem, 20.0)?.normal().approach();
    let smooth = press(&problem.0, &problem.1, 1.0).approach();
    // The ratio of two approaches on the same cells removes the error of the radius of the punch.
    let exact =
        FlatPunch::new(&pair, 1.0, 1.0)?.approach() / NoSlipPunch::new(&pair, 1.0, 1.0)?.approach();
    let error = relative(smooth / stuck, exact);
    Ok(rows(
        "round punch, Mossakovskii; Borodich and Keer (2004)",
        "129 x 129",
        "coupled_contact::punch_in_full_stick_matches_mossakovskii",
        [("stiffness in full stick", error)],
    )
    .collect())
}

fn full_stick_sphere() -> Result<Vec<Row>> {
    let pair = on_rigid(0.3)?;
    let mut found = [0.0; 2];
    for (found, steps) in found.iter_mut().zip([16, 32]) {
        let (history, whole) = pressed_sphere(&pair, 20.0, steps)?;
        let hertz = HertzSphere::new(&pair, 10.0, whole)?;
        *found = (hertz.approach() / history.approach()).powf(1.5);
    }
    let hertz = HertzSphere::new(&pair, 10.0, 1.0)?;
    let exact = NoSlipSphere::new(&pair, 10.0, 1.0)?;
    let exact = (hertz.approach() / exact.approach()).powf(1.5);
    Ok(rows(
        "sphere, Spence (1968)",
        "65 x 65",
        "stepwise_pressing::sphere_without_slip_is_stiffer",
        [(
            "load at equal approach, full stick",
            relative(2.0 * found[1] - found[0], exact),
        )],
    )
    .collect())
}
