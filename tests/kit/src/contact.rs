//! Contacts solved by CONTACT, an independent code, with the signs of this crate.
//!
//! `tests/data/contact/README.md` states the source, the format and the signs of the files.

use std::fmt::Debug;
use std::path::Path;

use stickslip::{
    Axis, ElasticPair, Field, Grid, LoadStep, Material, NormalLoad, TangentialControl,
    TangentialLoad, Zone,
};

use crate::max_difference;

/// Tolerance of a comparison, relative to the largest pressure for fields and relative to the value for each scalar.
pub const AGREED: f64 = 1e-6;

/// A contact and the steps of its loading, in mm, N and MPa.
#[derive(Debug)]
pub struct Case {
    pub grid: Grid,
    /// Centre of the first cell. The centre of the grid need not be the origin.
    first: [f64; 2],
    pub pair: ElasticPair,
    pub friction: f64,
    pub steps: Vec<ReferenceStep>,
}

/// Quantity prescribed along z.
#[derive(Debug, Clone, Copy)]
pub enum Normal {
    Force(f64),
    Approach(f64),
    /// The pressure of every cell is given by [`ReferenceStep::cells`].
    Pressure,
}

/// Quantity prescribed along x or along y.
#[derive(Debug, Clone, Copy)]
pub enum Tangential {
    /// Force on body 1.
    Force(f64),
    /// Increment of the shift in the step.
    Shift(f64),
}

/// One step, with the prescribed quantities and the results of CONTACT at the end of the step.
#[derive(Debug)]
pub struct ReferenceStep {
    /// Whether the step continues from the previous step, or starts from unloaded bodies.
    pub continues: bool,
    /// Factors of x^2, x y, y^2, x, y and 1 in the gap, or zero if the pressure is prescribed.
    gap: [f64; 6],
    pub normal: Normal,
    pub tangential: [Tangential; 2],
    /// Normal force, and tangential force on body 1.
    pub load: f64,
    pub force: [f64; 2],
    pub approach: f64,
    /// Increment of the shift in the step.
    pub shift: [f64; 2],
    /// Elastic energy at the end of the step, or `None` if the normal problem was not solved.
    pub elastic_energy: Option<f64>,
    /// Energy dissipated during the step.
    pub dissipated_energy: f64,
    /// Cells in contact.
    pub cells: Vec<Cell>,
}

/// A cell in contact. Column and row are counted from 0.
#[derive(Debug, Clone, Copy)]
pub struct Cell {
    pub ix: usize,
    pub iy: usize,
    pub sticks: bool,
    pub pressure: f64,
    /// Traction on body 1.
    pub traction: [f64; 2],
}

impl Case {
    /// Reads the case of a file, which must have this number of steps.
    pub fn read(name: &str, steps: usize) -> Self {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../data/contact");
        let case =
            Self::parse(&std::fs::read_to_string(folder.join(format!("{name}.txt"))).unwrap());
        assert_eq!(case.steps.len(), steps, "{name}");
        case
    }

    /// Parses the case of a file, which must be complete.
    fn parse(text: &str) -> Self {
        let mut lines = text
            .lines()
            .filter(|line| !line.starts_with('#'))
            .peekable();
        let [g1, nu1, g2, nu2] = numbers(after(lines.next(), "bodies"));
        let body = |g, nu| Material::from_shear_modulus(g, nu).unwrap();
        let grid = after(lines.next(), "grid");
        let (size, [dx, dy, x, y]) = (counts::<2>(grid), numbers(skip(grid, 2)));
        let [friction] = numbers(after(lines.next(), "friction"));
        let mut steps = Vec::new();
        while lines.peek().is_some() {
            steps.push(ReferenceStep::parse(&mut lines));
        }
        Self {
            grid: Grid::new(size[0], size[1], dx, dy).unwrap(),
            first: [x, y],
            pair: ElasticPair::new(body(g1, nu1), body(g2, nu2)).unwrap(),
            friction,
            steps,
        }
    }

    /// Returns the undeformed gap of a step.
    pub fn gap(&self, step: &ReferenceStep) -> Field {
        let [xx, xy, yy, along_x, along_y, constant] = step.gap;
        Field::from_indices(self.grid, |ix, iy| {
            let x = self.first[0] + ix as f64 * self.grid.dx();
            let y = self.first[1] + iy as f64 * self.grid.dy();
            xx * x * x + xy * x * y + yy * y * y + along_x * x + along_y * y + constant
        })
    }

    /// Returns a quantity of the cells in contact, and zero elsewhere.
    pub fn field(&self, step: &ReferenceStep, quantity: impl Fn(&Cell) -> f64) -> Field {
        let mut field = Field::zeros(self.grid);
        for cell in &step.cells {
            field.as_mut_slice()[cell.iy * self.grid.nx() + cell.ix] = quantity(cell);
        }
        field
    }

    /// Asserts that pressure, tractions and zones agree with a step. Tolerances are relative to the largest pressure.
    /// Near the friction limit the zone of a cell that sticks may differ, if `tolerates_zones` is set.
    #[track_caller]
    pub fn assert_fields_agree(
        &self,
        step: &ReferenceStep,
        (pressure, traction, zones): (&Field, [&Field; 2], &[Zone]),
        tolerance: f64,
        tolerates_zones: bool,
    ) {
        let largest = pressure.max();
        let expected = [
            self.field(step, |cell| cell.pressure),
            self.field(step, |cell| cell.traction[0]),
            self.field(step, |cell| cell.traction[1]),
        ];
        for (found, expected) in [pressure, traction[0], traction[1]]
            .into_iter()
            .zip(&expected)
        {
            let error = max_difference(found.as_slice(), expected.as_slice());
            assert!(error < tolerance * largest, "{:e}", error / largest);
        }
        for cell in &step.cells {
            let zone = zones[cell.iy * self.grid.nx() + cell.ix];
            let size = cell.traction[0].hypot(cell.traction[1]);
            let is_close = (size / (self.friction * cell.pressure) - 1.0).abs() < tolerance;
            let expected = if cell.sticks { Zone::Stick } else { Zone::Slip };
            let may_differ = tolerates_zones && cell.sticks && is_close;
            assert!(zone == expected || may_differ, "{cell:?} {zone:?}");
        }
    }
}

impl ReferenceStep {
    /// Returns the prescribed force or approach.
    pub fn normal_control(&self) -> Option<NormalLoad> {
        match self.normal {
            Normal::Force(force) => Some(NormalLoad::Force(force)),
            Normal::Approach(approach) => Some(NormalLoad::Approach(approach)),
            Normal::Pressure => None,
        }
    }

    /// Returns the loads of a step that starts at a shift.
    pub fn load_step(&self, shift: [f64; 2]) -> LoadStep {
        let mut load = LoadStep::hold().normal(self.normal_control().unwrap());
        for axis in [Axis::X, Axis::Y] {
            let component = axis.index();
            let tangential = match self.tangential[component] {
                Tangential::Force(force) => TangentialControl::Force(force),
                Tangential::Shift(gain) => TangentialControl::Shift(shift[component] + gain),
            };
            load = load.tangential(axis, tangential);
        }
        load
    }

    /// Returns the tangential load of a first step. All cases are symmetric about the x axis, so zero shift along y implies
    /// zero force along y.
    pub fn tangential_load(&self) -> TangentialLoad {
        match self.tangential {
            [Tangential::Force(x), Tangential::Force(y)] => TangentialLoad::force([x, y]),
            [Tangential::Shift(x), Tangential::Shift(y)] => TangentialLoad::shift([x, y]),
            [Tangential::Force(x), Tangential::Shift(0.0)] => TangentialLoad::force([x, 0.0]),
            other => panic!("{other:?}"),
        }
    }

    fn parse<'a>(lines: &mut impl Iterator<Item = &'a str>) -> Self {
        let continues = after(lines.next(), "step").ends_with("continue");
        let mut line = lines.next();
        let gap = line.filter(|line| line.starts_with("gap"));
        if gap.is_some() {
            line = lines.next();
        }
        let normal = match after(line, "normal").split_once(' ') {
            Some(("force", value)) => Normal::Force(number(value)),
            Some(("approach", value)) => Normal::Approach(number(value)),
            _ => Normal::Pressure,
        };
        let tangential = ["along_x", "along_y"].map(|axis| {
            match after(lines.next(), axis).split_once(' ').unwrap() {
                ("force", value) => Tangential::Force(number(value)),
                // The shift of CONTACT moves body 1 over body 2.
                (_, value) => Tangential::Shift(-number(value)),
            }
        });
        let [load, force_x, force_y] = numbers(after(lines.next(), "forces"));
        let [approach, shift_x, shift_y] = numbers(after(lines.next(), "motion"));
        let [elastic, friction] = numbers(after(lines.next(), "work"));
        let heading = after(lines.next(), "cells");
        let ([unit], [count, sticking]) = (numbers(heading), counts(skip(heading, 1)));
        let cells = parse_cells(lines, unit, count);
        assert_eq!(cells.iter().filter(|cell| cell.sticks).count(), sticking);
        Self {
            continues,
            gap: gap.map_or([0.0; 6], |line| numbers(after(Some(line), "gap"))),
            normal,
            tangential,
            load,
            force: [force_x, force_y],
            approach,
            shift: [-shift_x, -shift_y],
            elastic_energy: (elastic > 0.0).then_some(elastic),
            dissipated_energy: -friction,
            cells,
        }
    }
}

fn parse_cells<'a>(
    lines: &mut impl Iterator<Item = &'a str>,
    unit: f64,
    count: usize,
) -> Vec<Cell> {
    let mut cells = Vec::with_capacity(count);
    let mut place = [0, 0];
    while cells.len() < count {
        let line = lines.next().unwrap();
        if let Some(at) = line.strip_prefix("at ") {
            place = counts(at).map(|from_one| from_one - 1);
            continue;
        }
        let [pressure, x, y] = numbers(skip(line, 1)).map(|units| units * unit);
        cells.push(Cell {
            ix: place[0],
            iy: place[1],
            sticks: counts(line) == [1],
            pressure,
            traction: [x, y],
        });
        place[0] += 1;
    }
    cells
}

/// Returns the rest of a line that starts with a word.
fn after<'a>(line: Option<&'a str>, word: &str) -> &'a str {
    let rest = line.and_then(|line| line.strip_prefix(word)?.strip_prefix(' '));
    rest.unwrap_or_else(|| panic!("{word} expected, found {line:?}"))
}

/// Returns a line without its first words.
fn skip(line: &str, words: usize) -> &str {
    line.splitn(words + 1, ' ').last().unwrap()
}

fn number(word: &str) -> f64 {
    word.parse().unwrap()
}

/// Returns the numbers at the start of a line.
fn numbers<const N: usize>(line: &str) -> [f64; N] {
    first_words(line, number)
}

/// Returns the whole numbers at the start of a line.
fn counts<const N: usize>(line: &str) -> [usize; N] {
    first_words(line, |word| word.parse().unwrap())
}

fn first_words<T: Debug, const N: usize>(line: &str, parse: impl Fn(&str) -> T) -> [T; N] {
    let found: Vec<T> = line.split(' ').take(N).map(parse).collect();
    found.try_into().unwrap()
}
