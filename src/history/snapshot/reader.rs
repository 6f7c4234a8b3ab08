//! The parts of a history, read and checked.

use std::time::Duration;

use crate::boundary::Boundary;
use crate::cgm::{Method, Settings};
use crate::error::{Error, Result, finite, samples_obey};
use crate::field::Field;
use crate::grid::Grid;
use crate::half_space::HalfSpace;
use crate::history::snapshot::{FORMAT, elasticity};
use crate::io::Cursor;
use crate::report::{Report, Status};
use crate::tangential::{Axis, Friction, Zone};
use crate::window::Window;

/// A rule for samples, in words and in code.
type Rule = (&'static str, fn(f64) -> bool);

pub(super) const FINITE: Rule = ("must be finite", f64::is_finite);
pub(super) const NOT_NEGATIVE: Rule = ("must be non-negative and finite", |value| {
    value >= 0.0 && value.is_finite()
});

const QUANTITY: &str = "saved history";

/// Bytes, read in order.
pub(super) struct Reader<'a>(Cursor<'a>);

impl<'a> Reader<'a> {
    pub(super) fn new(bytes: Cursor<'a>) -> Self {
        Self(bytes)
    }

    /// `Ok` if the history was saved from such bodies.
    pub(super) fn expect(&mut self, bodies: &HalfSpace) -> Result<()> {
        let grid = bodies.grid();
        let cells = [self.count("cells along x")?, self.count("cells along y")?];
        let sides = [self.0.f64("the cell side")?, self.0.f64("the cell side")?];
        grid.expect(QUANTITY, Grid::new(cells[0], cells[1], sides[0], sides[1])?)?;
        let is_periodic = self.kind("boundary", 2)? == 1;
        if is_periodic != (bodies.boundary() == Boundary::Periodic) {
            return Err(Error::BoundaryMismatch { quantity: QUANTITY });
        }
        for expected in elasticity(bodies) {
            if self.0.f64("an elastic constant")?.to_bits() != expected.to_bits() {
                return Err(Error::MaterialMismatch { quantity: QUANTITY });
            }
        }
        Ok(())
    }

    pub(super) fn options(&mut self) -> Result<(Option<Axis>, Settings)> {
        let axes = [Some(Axis::X), Some(Axis::Y), None];
        let axis = axes[usize::from(self.kind("axis", 3)?)];
        let methods = [Method::ActiveSet, Method::PolonskyKeer];
        let settings = Settings {
            method: methods[usize::from(self.kind("method", 2)?)],
            tolerance: self.0.f64("the tolerance")?,
            max_iterations: self.count("the limit of iterations")?,
            time_limit: None,
        };
        let has_limit = self.kind("time limit", 2)? == 1;
        let seconds = self.0.f64("the time limit")?;
        let limit = Duration::try_from_secs_f64(seconds);
        let problem = |_| FORMAT.at_byte(self.0.position() - 8, "the time limit is no time");
        let time_limit = has_limit.then_some(limit.map_err(problem)?);
        Ok((
            axis,
            Settings {
                time_limit,
                ..settings
            },
        ))
    }

    pub(super) fn friction(&mut self, grid: Grid) -> Result<Friction> {
        let cap = self.0.f64("the shear cap")?;
        let friction = if self.kind("kind of friction", 2)? == 0 {
            Friction::coulomb(self.0.f64("the coefficient of friction")?)?
        } else {
            Friction::per_cell(self.field("coefficient of friction", grid, NOT_NEGATIVE)?)?
        };
        if cap == f64::INFINITY {
            Ok(friction)
        } else {
            friction.shear_cap(cap)
        }
    }

    pub(super) fn steps(&mut self) -> Result<u64> {
        self.0.u64("the number of steps")
    }

    pub(super) fn finite(&mut self, what: &'static str) -> Result<f64> {
        finite(what, self.0.f64(what)?)
    }

    pub(super) fn report(&mut self) -> Result<Report> {
        let statuses = [Status::Unsolved, Status::Converged];
        Ok(Report {
            status: statuses[usize::from(self.kind("status", 2)?)],
            iterations: self.count("iterations")?,
            convolutions: self.count("convolutions")?,
            rough_convolutions: self.count("convolutions")?,
            residual: self.0.f64("the residual")?,
            certified_gap: self.0.f64("the certified gap")?,
            load_error: self.0.f64("the load error")?,
            ..Report::unsolved()
        })
    }

    pub(super) fn window(&mut self, grid: Grid) -> Result<Option<Window>> {
        if self.kind("window", 2)? == 0 {
            return Ok(None);
        }
        let start = self.0.position();
        let mut counts = [0; 4];
        for count in &mut counts {
            *count = self.count("a side of a window")?;
        }
        let [x, y, width, height] = counts;
        let window = Window::at(grid, [x, y], [width, height]);
        let problem = || FORMAT.at_byte(start, "a window is empty or leaves the grid");
        window.map(Some).ok_or_else(problem)
    }

    pub(super) fn field(&mut self, what: &'static str, grid: Grid, rule: Rule) -> Result<Field> {
        Field::from_vec(grid, self.numbers(what, grid.cells(), rule)?)
    }

    pub(super) fn numbers(
        &mut self,
        what: &'static str,
        count: usize,
        rule: Rule,
    ) -> Result<Vec<f64>> {
        let mut stored = Cursor::new(FORMAT, self.0.take(what, 8 * count)?);
        let values: Result<Vec<f64>> = (0..count).map(|_| stored.f64(what)).collect();
        let values = values?;
        samples_obey(what, &values, rule.0, rule.1)?;
        Ok(values)
    }

    pub(super) fn zones(&mut self, count: usize) -> Result<Vec<Zone>> {
        let kinds = [Zone::Separate, Zone::Stick, Zone::Slip];
        (0..count)
            .map(|_| Ok(kinds[usize::from(self.kind("zone", 3)?)]))
            .collect()
    }

    /// `Ok` if nothing is left.
    pub(super) fn end(&self) -> Result<()> {
        if self.0.rest().is_empty() {
            return Ok(());
        }
        let problem = "more bytes follow than a history has";
        Err(FORMAT.at_byte(self.0.position(), problem))
    }

    /// A number less than `kinds`.
    fn kind(&mut self, what: &str, kinds: u8) -> Result<u8> {
        let [kind] = self.0.array(what)?;
        if kind < kinds {
            Ok(kind)
        } else {
            let problem = format!("{what} {kind} is unknown");
            Err(FORMAT.at_byte(self.0.position() - 1, problem))
        }
    }

    fn count(&mut self, what: &str) -> Result<usize> {
        let value = self.0.u64(what)?;
        let problem = |_| FORMAT.at_byte(self.0.position() - 8, format!("{value} {what}"));
        usize::try_from(value).map_err(problem)
    }
}
