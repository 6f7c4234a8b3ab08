//! Order of the parts of a saved state, defined once for reading and writing.

use std::ops::Range;
use std::time::Duration;

use super::FORMAT;
use super::codec::{
    Codec, FINITE, NOT_NEGATIVE, NOT_NEGATIVE_OR_INFINITE, NumberRule, POSITIVE,
    POSITIVE_OR_INFINITE, TOLERANCE,
};
use crate::bodies::coupling::Coupling;
use crate::bodies::layers::{LIMIT, Layer};
use crate::bodies::material::{ElasticPair, KernelMark, Material};
use crate::cgm::{Method, Settings};
use crate::contact::LoadTrend;
use crate::error::Result;
use crate::grid::Grid;
use crate::grid::boundary::Boundary;
use crate::grid::cell_value::CellValue;
use crate::grid::field::Field;
use crate::grid::per_cell::PerCell;
use crate::grid::window::Window;
use crate::history::state::State;
use crate::history::state::memory::Memory;
use crate::history::state::relative_displacement::RelativeDisplacementState;
use crate::normal::{Hardness, NormalControl, NormalSolution};
use crate::report::{EigenvalueBound, Status};
use crate::tangential::EntryRule;
use crate::tangential::{Axis, Friction, RelativeDisplacement};

/// Largest valid count of steps or products. No run reaches this count. A larger count means that the bytes are
/// damaged, and an increment cannot overflow.
const LARGEST_COUNT: u64 = 1 << 53;

/// Properties that identify the bodies of a state.
#[derive(Default)]
pub(super) struct SnapshotHeader {
    /// Size of the whole grid.
    cells: [usize; 2],
    /// First local row and number of local rows.
    rows: [usize; 2],
    sides: [f64; 2],
    boundary: Boundary,
    cell_value: CellValue,
    /// Young's modulus, Poisson's ratio and hardness of each body.
    materials: [[f64; 3]; 2],
    /// Young's modulus, Poisson's ratio and thickness of each layer of each body, the outermost first.
    layers: [Vec<[f64; 3]>; 2],
    /// Mark of the kernel for bodies with a user-defined kernel.
    kernel: Option<KernelMark>,
}

impl SnapshotHeader {
    pub(super) fn of(state: &State) -> Self {
        let grid = state.grid();
        let constants =
            |body: Material| [body.youngs_modulus(), body.poisson_ratio(), body.hardness()];
        Self {
            cells: grid.whole().size(),
            rows: [grid.rows().start, grid.ny()],
            sides: [grid.dx(), grid.dy()],
            boundary: state.boundary(),
            cell_value: state.normal().cell_value(),
            materials: state.pair().bodies().map(constants),
            layers: state.pair().bodies().map(|body| {
                let constants =
                    |of: &Layer| [of.youngs_modulus(), of.poisson_ratio(), of.thickness()];
                body.layers().iter().map(constants).collect()
            }),
            kernel: state.pair().kernel(),
        }
    }

    pub(super) fn visit<C: Codec>(&mut self, codec: &mut C) -> Result<()> {
        for cells in &mut self.cells {
            codec.count("number of cells along an axis", cells, 1..)?;
        }
        let ([_, all], [first, rows]) = (self.cells, &mut self.rows);
        codec.count("first row", first, ..=all as u64)?;
        codec.count("number of rows", rows, ..=(all - *first) as u64)?;
        for side in &mut self.sides {
            codec.number("cell side", side, POSITIVE)?;
        }
        visit_boundary(codec, &mut self.boundary)?;
        let values = [CellValue::Uniform, CellValue::Centre];
        codec.kind("meaning of the cell values", &mut self.cell_value, &values)?;
        for [modulus, ratio, hardness] in &mut self.materials {
            codec.number("Young's modulus", modulus, POSITIVE_OR_INFINITE)?;
            codec.number("Poisson's ratio", ratio, FINITE)?;
            codec.number("hardness of a body", hardness, POSITIVE_OR_INFINITE)?;
        }
        for layers in &mut self.layers {
            let mut count = layers.len();
            codec.count("number of layers", &mut count, ..=LIMIT as u64)?;
            layers.resize(count, [0.0; 3]);
            for [modulus, ratio, thickness] in layers {
                codec.number("Young's modulus of a layer", modulus, POSITIVE)?;
                codec.number("Poisson's ratio of a layer", ratio, FINITE)?;
                codec.number("thickness of a layer", thickness, POSITIVE)?;
            }
        }
        codec.option("kernel", &mut self.kernel, || Ok(KernelMark::default()))?;
        if let Some(KernelMark { digest, coupling }) = &mut self.kernel {
            codec.integer("digest of the kernel", digest, ..)?;
            codec.number("coupling of the kernel", coupling, FINITE)?;
        }
        Ok(())
    }

    /// Creates a state without cells to read into, in which only the bodies are set.
    pub(super) fn blank(&self, grid: Grid) -> Result<State> {
        let body = |n: usize| {
            let [modulus, ratio, hardness] = self.materials[n];
            let layers = self.layers[n].iter();
            let layers =
                layers.map(|&[modulus, ratio, thickness]| Layer::new(modulus, ratio, thickness));
            let base = if modulus.is_infinite() {
                Material::rigid()
            } else {
                Material::new(modulus, ratio)?
            };
            base.coated(&layers.collect::<Result<Vec<_>>>()?)?
                .stating(hardness)
        };
        let pair = body(0).and_then(|one| ElasticPair::new(one, body(1)?));
        let mark = |pair: ElasticPair| self.kernel.map_or(pair, |mark| pair.standing_for(mark));
        let pair = pair
            .map(mark)
            .map_err(|error| FORMAT.at_byte(super::HEADER, error.to_string()))?;
        let (friction, settings) = (Friction::coulomb(0.0)?, Settings::default());
        let gap = Field::try_zeros(grid.whole().slab(0..0))?;
        State::new(
            gap,
            (self.boundary, self.cell_value),
            &pair,
            friction,
            Axis::X.alone(),
            settings,
            EntryRule::default(),
        )
    }

    pub(super) fn grid(&self) -> Result<Grid> {
        let ([nx, ny], [dx, dy]) = (self.cells, self.sides);
        let grid = Grid::new(nx, ny, dx, dy);
        let grid = grid.map_err(|error| FORMAT.at_byte(super::HEADER, error.to_string()))?;
        Ok(grid.slab(self.rows()))
    }

    /// Returns the range of local rows.
    pub(super) fn rows(&self) -> Range<usize> {
        let [first, rows] = self.rows;
        first..first + rows
    }
}

impl State {
    /// Visits all parts of the state after the bodies, except for the values of its cells.
    pub(super) fn visit<C: Codec>(
        &mut self,
        codec: &mut C,
        is_gap_changed: &mut bool,
    ) -> Result<()> {
        let grid = self.grid();
        let models = [Axis::X.alone(), Axis::Y.alone(), Axis::BOTH];
        codec.kind("axis", &mut self.axes, &models)?;
        visit_settings(codec, &mut self.settings)?;
        visit_friction(codec, &mut self.friction, grid)?;

        codec.integer("number of steps", &mut self.steps, ..=LARGEST_COUNT)?;
        codec.numbers("shift", &mut self.motion.shift, FINITE)?;
        codec.number("twist", &mut self.motion.twist, FINITE)?;
        codec.numbers("tangential force", &mut self.force, FINITE)?;
        codec.number("moment", &mut self.moment, FINITE)?;

        let rules = [EntryRule::SinceTouch, EntryRule::WholeStep];
        codec.kind("entry rule", &mut self.entry_rule, &rules)?;
        let choices = [Coupling::Full, Coupling::OneWay, Coupling::Neglected];
        codec.kind("coupling", &mut self.coupling, &choices)?;
        let mark = "mark of a changed gap";
        codec.kind(mark, is_gap_changed, &[false, true])?;
        visit_normal(codec, &mut self.normal)?;
        self.visit_hardness(codec)?;
        self.visit_relative(codec)?;
        // A force that was lost under a held shift is stored only if it differs from the present force.
        let bits = |force: [f64; 2]| force.map(f64::to_bits);
        let has_lost = bits(self.held_force) != bits(self.force);
        let mut marks = [self.is_pressure_stale, self.is_friction_new, has_lost];
        let kinds: [[bool; 3]; 8] =
            std::array::from_fn(|code| [1, 2, 4].map(|bit| code & bit != 0));
        codec.kind(
            "mark of a stale pressure, a new friction and a lost force",
            &mut marks,
            &kinds,
        )?;
        let [is_pressure_stale, is_friction_new, has_lost] = marks;
        (self.is_pressure_stale, self.is_friction_new) = (is_pressure_stale, is_friction_new);
        if has_lost {
            codec.numbers("force before a held shift", &mut self.held_force, FINITE)?;
        } else {
            self.held_force = self.force;
        }
        visit_control(codec, &mut self.pressed_by)?;
        let whole = || Ok(Window::whole(grid));
        codec.option("window of the pressure", &mut self.press_window, whole)?;
        if let Some(window) = &mut self.press_window {
            visit_window(codec, window, grid)?;
        }
        self.visit_trend(codec)?;
        self.visit_contact(codec)
    }

    fn visit_hardness<C: Codec>(&mut self, codec: &mut C) -> Result<()> {
        let grid = self.grid();
        codec.option("hardness", &mut self.hardness, || Ok(Hardness::blank()))?;
        if let Some(hardness) = &mut self.hardness {
            visit_per_cell(codec, "hardness", hardness.limit_mut(), POSITIVE, grid)?;
        }
        codec.option("permanent set", &mut self.yielded, || {
            Field::try_zeros(grid)
        })
    }

    /// Counts the cells at their hardness, after the pressure has been read.
    pub(super) fn count_yielded_cells(&mut self) {
        let Some(hardness) = &self.hardness else {
            return;
        };
        let pressure = self.normal.pressure().as_slice();
        let limits = hardness.limits();
        let least = hardness.least_limit(pressure);
        let is_reached = |i: &usize| limits.are_reached(*i, pressure[*i]);
        let yielded = (0..pressure.len()).filter(is_reached).count();
        self.normal.set_yielded_cells(yielded, least);
    }

    fn visit_relative<C: Codec>(&mut self, codec: &mut C) -> Result<()> {
        let (grid, what) = (self.grid(), "relative displacement");
        let none = || RelativeDisplacementState::new(RelativeDisplacement::zeros(grid)?);
        codec.option(what, &mut self.relative, none)?;
        if let Some(relative) = &mut self.relative {
            codec.number(
                "amount of the relative displacement",
                &mut relative.amount,
                FINITE,
            )?;
        }
        Ok(())
    }

    fn visit_trend<C: Codec>(&mut self, codec: &mut C) -> Result<()> {
        let mut is_known = self.trend.is_known();
        codec.kind("mark of a trend", &mut is_known, &[false, true])?;
        if self.press_window.is_none() || !is_known {
            self.trend.forget();
            return Ok(());
        }
        let [by] = &mut self.trend.by;
        codec.numbers("change of the normal load", by, FINITE)
    }

    fn visit_contact<C: Codec>(&mut self, codec: &mut C) -> Result<()> {
        let (grid, axes, is_joint) = (self.grid(), self.axes, self.is_joint());
        let mut window = self.contact.as_ref().map(|memory| memory.window);
        let whole = || Ok(Window::whole(grid));
        codec.option("window of the contact", &mut window, whole)?;
        let Some(window) = &mut window else {
            return Ok(());
        };
        visit_window(codec, window, grid)?;
        let memory = match &mut self.contact {
            Some(memory) => memory,
            none => none.insert(Memory::first(grid, axes, *window, self.motion)?),
        };
        if is_joint {
            memory.trend = LoadTrend::default();
        }
        for by in &mut memory.trend.by {
            codec.numbers("change of the tangential load", by, FINITE)?;
        }
        let mark = "mark of cells that came into contact";
        codec.kind(mark, &mut memory.has_entered, &[false, true])
    }
}

fn visit_settings<C: Codec>(codec: &mut C, settings: &mut Settings) -> Result<()> {
    let methods = [Method::ActiveSet, Method::PolonskyKeer];
    codec.kind("method", &mut settings.method, &methods)?;
    codec.number("tolerance", &mut settings.tolerance, TOLERANCE)?;
    let limit = &mut settings.max_iterations;
    codec.count("limit of iterations", limit, 1..)?;
    let limit = &mut settings.time_limit;
    codec.option("time limit", limit, || Ok(Duration::default()))?;
    if let Some(limit) = limit {
        let (mut seconds, mut rest) = (limit.as_secs(), limit.subsec_nanos().into());
        codec.integer("seconds of the time limit", &mut seconds, ..)?;
        codec.integer("nanoseconds of the time limit", &mut rest, ..1_000_000_000)?;
        *limit = Duration::from_secs(seconds).saturating_add(Duration::from_nanos(rest));
    }
    Ok(())
}

fn visit_friction<C: Codec>(codec: &mut C, friction: &mut Friction, grid: Grid) -> Result<()> {
    let (coefficient, cap) = friction.parts_mut();
    codec.option("shear cap", cap, || Ok(f64::INFINITY))?;
    if let Some(cap) = cap {
        codec.number("shear cap", cap, POSITIVE)?;
    }
    visit_per_cell(
        codec,
        "coefficient of friction",
        coefficient,
        NOT_NEGATIVE,
        grid,
    )
}

fn visit_boundary<C: Codec>(codec: &mut C, boundary: &mut Boundary) -> Result<()> {
    let mut repeats = boundary.repeats();
    codec.kind(
        "boundary",
        &mut repeats,
        &[[false, false], [true, true], [false, true]],
    )?;
    let mut datum = match boundary {
        Boundary::PeriodicAlongY { datum } => *datum,
        _ => 0.0,
    };
    *boundary = match repeats {
        [_, false] => Boundary::NonPeriodic,
        [true, true] => Boundary::Periodic,
        [false, true] => {
            codec.number("distance of the datum", &mut datum, POSITIVE)?;
            Boundary::PeriodicAlongY { datum }
        }
    };
    Ok(())
}

/// Visits a number that satisfies the rule `uniform`, or the mark of a quantity that varies from cell to cell.
fn visit_per_cell<C: Codec>(
    codec: &mut C,
    what: &'static str,
    quantity: &mut PerCell<Field>,
    uniform: NumberRule,
    grid: Grid,
) -> Result<()> {
    let mut is_per_cell = matches!(quantity, PerCell::Cells(_));
    codec.kind(what, &mut is_per_cell, &[false, true])?;
    if is_per_cell && matches!(quantity, PerCell::Uniform(_)) {
        *quantity = PerCell::Cells(Field::try_zeros(grid)?);
    }
    match quantity {
        PerCell::Uniform(value) => codec.number(what, value, uniform),
        PerCell::Cells(_) => Ok(()),
    }
}

fn visit_normal<C: Codec>(codec: &mut C, normal: &mut NormalSolution) -> Result<()> {
    let (.., approach, report) = normal.parts_mut();
    codec.number("approach", approach, FINITE)?;
    // A state contains only reports with these statuses, because a step that ends with a different status does not
    // change the state.
    let statuses = [Status::Unsolved, Status::Converged];
    codec.kind("status", &mut report.status, &statuses)?;
    for count in [
        &mut report.iterations,
        &mut report.double_precision_products,
        &mut report.single_precision_products,
    ] {
        codec.count("number in the report", count, ..=LARGEST_COUNT)?;
    }
    for error in [
        &mut report.residual,
        &mut report.duality_gap,
        &mut report.load_error,
    ] {
        codec.number("error of the report", error, NOT_NEGATIVE_OR_INFINITE)?;
    }
    let bounds = [
        EigenvalueBound::Unknown,
        EigenvalueBound::Estimated,
        EigenvalueBound::Proven,
        EigenvalueBound::Stated,
    ];
    codec.kind("eigenvalue bound", &mut report.eigenvalue_bound, &bounds)?;
    Ok(())
}

fn visit_control<C: Codec>(codec: &mut C, control: &mut NormalControl) -> Result<()> {
    let mut kind = match control {
        NormalControl::Hold => 0,
        NormalControl::Force(_) => 1,
        NormalControl::Approach(_) => 2,
    };
    codec.kind("kind of normal load", &mut kind, &[0, 1, 2])?;
    let mut value = match *control {
        NormalControl::Hold => 0.0,
        NormalControl::Force(value) | NormalControl::Approach(value) => value,
    };
    codec.number("normal load", &mut value, FINITE)?;
    *control = match kind {
        0 => NormalControl::Hold,
        1 => NormalControl::Force(value),
        _ => NormalControl::Approach(value),
    };
    Ok(())
}

fn visit_window<C: Codec>(codec: &mut C, window: &mut Window, grid: Grid) -> Result<()> {
    let (mut corner, mut size) = (window.corner(), window.size);
    for (axis, cells) in grid.whole().size().into_iter().enumerate() {
        let cells = cells as u64;
        codec.count("first cell of a window", &mut corner[axis], ..cells)?;
        let left = cells - corner[axis] as u64;
        codec.count("side of a window", &mut size[axis], 1..=left)?;
    }
    // A window within these ranges lies in the grid.
    *window = Window::at(grid, corner, size).unwrap_or(*window);
    Ok(())
}
