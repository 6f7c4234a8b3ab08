//! Edges of a contact in partial slip and of its stick zone.

use crate::edges::search::{LARGEST_MISS, Search};
use crate::edges::{Edges, check_whole, excess};
use crate::error::{Error, Result};
use crate::grid::Grid;
use crate::grid::field::Field;
use crate::grid::neighbours::neighbours;
use crate::grid::record::checked_struct;
use crate::normal::NormalSolution;
use crate::numerics::agreement::tolerance_of;
use crate::support::debug::shown;
use crate::tangential::{Friction, TangentialSolution, Zone};

checked_struct! {
    /// Edges of the contact and of the stick zone inside the cells, and the traction at these edges. The functions
    /// [`TangentialSolution::edges`] and [`History::edges`](crate::History::edges) return this type.
    #[derive(Clone, PartialEq)]
    pub struct TangentialEdges {
        contact: Edges,
        stick: Edges,
        traction: Field,
        mean_traction: Field,
        stick_area: f64,
    }
    #[serde(remote = "TangentialEdges", deny_unknown_fields)]
    check(read) {
        let grid = read.grid();
        grid.check_equal("edge of the contact", read.contact.grid())?;
        grid.check_equal("edge of the stick zone", read.stick.grid())?;
        read.traction.check("traction", grid)?;
        read.mean_traction.check("mean traction", grid)
    }
}

shown!(TangentialEdges: grid(), contact, stick, stick_area());

impl TangentialEdges {
    /// Returns the grid of the cells.
    #[must_use]
    pub fn grid(&self) -> Grid {
        self.traction.grid()
    }

    /// Returns the edge of the contact.
    #[must_use]
    pub fn contact(&self) -> &Edges {
        &self.contact
    }

    /// Returns the edge of the stick zone. Its values are the friction reserve.
    #[must_use]
    pub fn stick(&self) -> &Edges {
        &self.stick
    }

    /// Returns the magnitude of the traction at the centres of the cells (a pressure). The magnitude is the friction
    /// limit at the corrected pressure minus the friction reserve.
    #[must_use]
    pub fn traction(&self) -> &Field {
        &self.traction
    }

    /// Returns the mean of the magnitude of the traction over the cells (a pressure).
    #[must_use]
    pub fn mean_traction(&self) -> &Field {
        &self.mean_traction
    }

    /// Returns the largest traction at the centre of a cell (a pressure). This cell is usually next to the edge of the stick
    /// zone. After a reversal the largest traction might be at the old edge, where the values are the tractions of the raw cells.
    #[must_use]
    pub fn peak_traction(&self) -> f64 {
        self.traction.max()
    }

    /// Returns the area of the stick zone, including the covered fractions of the cells at its edge (a length squared).
    #[must_use]
    pub fn stick_area(&self) -> f64 {
        self.stick_area
    }

    /// Returns the area of the slip zone (a length squared). It is the area of the [contact](Edges::area) minus the area of the
    /// stick zone.
    #[must_use]
    pub fn slip_area(&self) -> f64 {
        (self.contact.area() - self.stick_area).max(0.0)
    }

    /// Returns the ratio of stick area to contact area, or zero without contact.
    #[must_use]
    pub fn stick_ratio(&self) -> f64 {
        if self.contact.area() > 0.0 {
            self.stick_area / self.contact.area()
        } else {
            0.0
        }
    }
}

impl TangentialSolution {
    /// Returns the edges of the contact and of the stick zone inside the cells. `normal` and `friction` must be the contact and
    /// the friction of the problem. The documentation of [`edges`](crate::edges) describes the method. The result is valid for a
    /// contact that is loaded once. After the steps of a history use [`History::edges`](crate::History::edges).
    ///
    /// ```
    /// use stickslip::*;
    /// let grid = Grid::square(64, 3.0)?;
    /// let body = Material::new(2.0, 0.0)?;
    /// let pair = ElasticPair::new(body, body)?;
    /// let bodies = HalfSpace::new(grid, pair)?.with_cell_value(CellValue::Centre)?;
    /// let hertz = analytical::HertzSphere::new(&pair, 1.0, 4.0 / 3.0)?;
    /// let exact = analytical::CattaneoMindlin::new(hertz, 0.5, 0.4 * 0.5 * 4.0 / 3.0)?;
    /// let (ball, load) = (surface::sphere(grid, 1.0)?, NormalLoad::Force(4.0 / 3.0));
    /// let contact = NormalProblem::builder(&bodies, &ball, load).build()?.solve()?;
    /// let (friction, load) = (Friction::coulomb(0.5)?, TangentialLoad::force([exact.force(), 0.0]));
    /// let builder = TangentialProblem::builder(&bodies, &contact, friction.clone(), load);
    /// let shear = builder.build()?.solve()?;
    /// let edges = shear.edges(&contact, &friction)?;
    /// assert!((edges.stick_ratio() - exact.stick_ratio()).abs() < 2e-3 * exact.stick_ratio());
    /// assert!((shear.stick_ratio() - exact.stick_ratio()).abs() > 5e-3 * exact.stick_ratio()); // counted
    /// # Ok::<(), Error>(())
    /// ```
    ///
    /// # Errors
    /// - [`Error::GridMismatch`], [`Error::BoundaryMismatch`], [`Error::CellValueMismatch`] or [`Error::MaterialMismatch`] if
    ///   the normal contact or the friction belongs to different bodies.
    /// - [`Error::OutdatedSolution`] if the solution was computed for a different pressure or a different friction.
    /// - The errors of [`NormalSolution::edges`].
    pub fn edges(&self, normal: &NormalSolution, friction: &Friction) -> Result<TangentialEdges> {
        let (grid, quantity) = (self.grid(), "edge of the stick zone");
        check_whole(grid)?;
        self.check_normal(normal, quantity)?;
        friction.check(grid)?;
        let (pressure, tolerance) = (
            normal.pressure().as_slice(),
            tolerance_of(&[self.report(), normal.report()]),
        );
        if !self.belongs_to(&grid.layout(), pressure, friction, tolerance) {
            return Err(Error::OutdatedSolution {
                quantity,
                changed: "the friction",
                remedy: "pass the friction of the tangential contact",
            });
        }
        let [qx, qy] = self.traction().map(Field::as_slice);
        let [slip_x, slip_y] = self.slip().map(Field::as_slice);
        PartialSlipContact {
            normal,
            friction,
            zones: self.zones(),
            traction: [qx, qy],
            parts: &|i| [qx[i].hypot(qy[i]), 0.0],
            slip: &|i| Some(slip_x[i].hypot(slip_y[i])),
            largest_miss: LARGEST_MISS,
        }
        .edges()
    }
}

/// Contact in partial slip whose edges are computed.
pub(super) struct PartialSlipContact<'a> {
    pub(super) normal: &'a NormalSolution,
    pub(super) friction: &'a Friction,
    pub(super) zones: &'a [Zone],
    pub(super) traction: [&'a [f64]; 2],
    /// Component of the traction in the direction of the next slip of a cell, and magnitude of the remaining component.
    pub(super) parts: &'a (dyn Fn(usize) -> [f64; 2] + Sync),
    /// Slip distance of a slipping cell after it last stuck, or `None` if the distance is unknown.
    pub(super) slip: &'a (dyn Fn(usize) -> Option<f64> + Sync),
    /// Largest residual of a fit of the stick zone, as in [`Search`].
    pub(super) largest_miss: f64,
}

impl PartialSlipContact<'_> {
    pub(super) fn edges(&self) -> Result<TangentialEdges> {
        let grid = self.normal.grid();
        check_whole(grid)?;
        let (contact, stick) = (self.normal.edges()?, self.stick_edges()?);
        let magnitude = |limits: &Field, spare: &Field| -> Result<Field> {
            let mut traction = Field::try_zeros(grid)?;
            let pairs = limits.iter().zip(spare.iter()).enumerate();
            for (out, (i, (pressure, spare))) in traction.as_mut_slice().iter_mut().zip(pairs) {
                let [along, across] = (self.parts)(i);
                let found = self.friction.limit(i, *pressure) - spare;
                // Without traction in this direction, the difference of the two fits is only their error.
                let is_free = along == 0.0 && *spare > 0.0;
                let found = if along < 0.0 { -found } else { found };
                *out = if is_free {
                    across
                } else {
                    found.max(0.0).hypot(across)
                };
            }
            Ok(traction)
        };
        // A stick zone that reaches the edge of the contact ends at that edge.
        let beyond: f64 = stick
            .cells()
            .iter()
            .map(|cell| {
                let found = contact
                    .cells()
                    .binary_search_by_key(&cell.index, |cell| cell.index);
                let most = found.map_or(1.0, |k| contact.cells()[k].covered);
                (cell.covered - most).max(0.0)
            })
            .sum();
        Ok(TangentialEdges {
            traction: magnitude(contact.centres(), stick.centres())?,
            mean_traction: magnitude(contact.means(), stick.means())?,
            stick_area: stick.area() - beyond * grid.cell_area(),
            contact,
            stick,
        })
    }

    fn stick_edges(&self) -> Result<Edges> {
        let (normal, zones, [qx, qy]) = (self.normal, self.zones, self.traction);
        let (grid, repeats) = (normal.grid(), normal.boundary().repeats());
        let pressure = normal.pressure().as_slice();
        let mut spare = Field::try_zeros(grid)?;
        let mut slip = Field::try_zeros(grid)?;
        let fields = spare.as_mut_slice().iter_mut().zip(slip.as_mut_slice());
        for (i, (spare, slip)) in fields.enumerate() {
            match zones[i] {
                Zone::Stick => {
                    let [along, _] = (self.parts)(i);
                    *spare = (self.friction.limit(i, pressure[i]) - along).max(0.0);
                }
                Zone::Slip => *slip = (self.slip)(i).unwrap_or(0.0),
                Zone::Separated => {}
            }
        }
        let is_in_contact = |i: usize| zones[i] != Zone::Separated;
        // Next to the edge of the contact the slip also follows the asymptotics of that edge.
        let is_outside_known = |i: usize| {
            let around = |i: usize| neighbours(i, grid.size(), repeats);
            let touches = |next: Option<usize>| next.is_some_and(is_in_contact);
            let [_, below, _, above] = around(i);
            let has_row = |next: Option<usize>| {
                next.is_some_and(|next| {
                    let [left, _, right, _] = around(next);
                    touches(left) && touches(right)
                })
            };
            is_in_contact(i)
                && (self.slip)(i).is_some()
                && around(i).into_iter().all(touches)
                && has_row(below)
                && has_row(above)
        };
        let compliances = normal.pair().compliances();
        let modulus = |i: usize, [x, y]: [f64; 2]| {
            let size = qx[i].hypot(qy[i]);
            // For cells outside the contact and cells without traction, the traction is assumed normal to the edge.
            let along = if size > 0.0 {
                (qx[i] * x + qy[i] * y) / size
            } else {
                1.0
            };
            2.0 / (compliances.normal + compliances.lateral * (1.0 - along * along))
        };
        Search {
            grid,
            repeats,
            inside: spare.as_slice(),
            outside: slip.as_slice(),
            is_outside_known: &is_outside_known,
            modulus: &modulus,
            excess: excess(normal.boundary(), normal.cell_value()),
            largest_miss: self.largest_miss,
        }
        .edges()
    }
}
