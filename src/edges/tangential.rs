//! The edges of a contact in partial slip: of the contact, and of its stick zone.

use crate::edges::search::Search;
use crate::edges::{Edges, check_whole, excess};
use crate::error::{Error, Result};
use crate::field::Field;
use crate::grid::Grid;
use crate::neighbours::neighbours;
use crate::normal::NormalSolution;
use crate::shown::shown;
use crate::tangential::{Friction, TangentialSolution, Zone};

/// The edges of the contact and of the stick zone inside the cells, and the traction there. Obtained from
/// [`TangentialSolution::edges`].
#[derive(Clone, PartialEq)]
pub struct TangentialEdges {
    contact: Edges,
    stick: Edges,
    traction: Field,
    mean_traction: Field,
    stick_area: f64,
}

shown!(TangentialEdges: grid(), contact, stick, stick_area());

impl TangentialEdges {
    /// The grid of the cells.
    #[must_use]
    pub fn grid(&self) -> Grid {
        self.traction.grid()
    }

    /// The edge of the contact.
    #[must_use]
    pub fn contact(&self) -> &Edges {
        &self.contact
    }

    /// The edge of the stick zone; its values are what friction could still bear.
    #[must_use]
    pub fn stick(&self) -> &Edges {
        &self.stick
    }

    /// Magnitude of the traction at the centres of the cells (a pressure): the friction limit at the pressure there, less
    /// what friction could still bear.
    #[must_use]
    pub fn traction(&self) -> &Field {
        &self.traction
    }

    /// Mean of the magnitude of the traction over the cells (a pressure).
    #[must_use]
    pub fn mean_traction(&self) -> &Field {
        &self.mean_traction
    }

    /// The largest traction at the centre of a cell (a pressure), usually of one beside the edge of the stick zone.
    #[must_use]
    pub fn peak_traction(&self) -> f64 {
        self.traction.max()
    }

    /// Area of the stick zone, with the parts of the cells at its edge (a length squared).
    #[must_use]
    pub fn stick_area(&self) -> f64 {
        self.stick_area
    }

    /// Area of the slip zone: that of the [contact](Edges::area) less that of the stick zone.
    #[must_use]
    pub fn slip_area(&self) -> f64 {
        (self.contact.area() - self.stick_area).max(0.0)
    }

    /// Stick area over contact area; zero without contact.
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
    /// The edges of the contact and of the stick zone inside the cells, under the pressure and the friction of the problem;
    /// the page of [`edges`](crate::edges) tells how. They are those of a contact loaded once: the slip of a step of a
    /// history, which begins with tractions, opens differently.
    ///
    /// ```
    /// use stickslip::*;
    /// let grid = Grid::square(64, 3.0)?;
    /// let pair = ElasticPair::new(Material::new(1.0, 0.0)?, Material::rigid())?;
    /// let bodies = HalfSpace::new(grid, pair)?.with_cell_value(CellValue::Centre)?;
    /// let hertz = analytical::HertzSphere::new(&pair, 1.0, 4.0 / 3.0)?;
    /// let exact = analytical::CattaneoMindlin::new(hertz, 0.5, 0.4 * 0.5 * 4.0 / 3.0)?;
    /// let (ball, load) = (surface::sphere(grid, 1.0)?, NormalControl::Force(4.0 / 3.0));
    /// let contact = NormalProblem::builder(&bodies, &ball, load).build()?.solve()?;
    /// let (friction, load) = (Friction::coulomb(0.5)?, TangentialLoad::force([exact.force(), 0.0]));
    /// let builder = TangentialProblem::builder(&bodies, &contact, friction.clone(), load);
    /// let shear = builder.build()?.solve()?;
    /// let edges = shear.edges(&contact, &friction)?;
    /// assert!((edges.stick_ratio() - exact.stick_ratio()).abs() < 5e-4 * exact.stick_ratio());
    /// assert!((shear.stick_ratio() - exact.stick_ratio()).abs() > 1e-3 * exact.stick_ratio()); // counted
    /// # Ok::<(), Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::GridMismatch`], [`Error::BoundaryMismatch`] or [`Error::CellValueMismatch`] for a normal contact or a
    /// friction on other bodies; as [`NormalSolution::edges`].
    pub fn edges(&self, normal: &NormalSolution, friction: &Friction) -> Result<TangentialEdges> {
        let (grid, quantity) = (self.grid(), "normal contact");
        grid.expect(quantity, normal.grid())?;
        if self.boundary() != normal.boundary() {
            return Err(Error::BoundaryMismatch { quantity });
        }
        if self.cell_value() != normal.cell_value() {
            return Err(Error::CellValueMismatch { quantity });
        }
        friction.check(grid)?;
        check_whole(grid)?;
        let contact = normal.edges()?;
        let stick = self.stick_edges(normal, friction)?;
        let rest = |limits: &Field, spare: &Field| -> Result<Field> {
            let mut traction = Field::try_zeros(grid)?;
            let pairs = limits.iter().zip(spare.iter()).enumerate();
            for (out, (i, (pressure, spare))) in traction.as_mut_slice().iter_mut().zip(pairs) {
                *out = (friction.limit(i, *pressure) - spare).max(0.0);
            }
            Ok(traction)
        };
        // The edge of a stick zone that reaches the edge of the contact is that of the contact.
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
            traction: rest(contact.centres(), stick.centres())?,
            mean_traction: rest(contact.means(), stick.means())?,
            stick_area: stick.area() - beyond * grid.cell_area(),
            contact,
            stick,
        })
    }

    fn stick_edges(&self, normal: &NormalSolution, friction: &Friction) -> Result<Edges> {
        let (grid, repeats) = (self.grid(), self.boundary().repeats());
        let [qx, qy] = self.traction().map(Field::as_slice);
        let [slip_x, slip_y] = self.slip().map(Field::as_slice);
        let (zones, pressure) = (self.zones(), normal.pressure().as_slice());
        let mut spare = Field::try_zeros(grid)?;
        let mut slip = Field::try_zeros(grid)?;
        let fields = spare.as_mut_slice().iter_mut().zip(slip.as_mut_slice());
        for (i, (spare, slip)) in fields.enumerate() {
            match zones[i] {
                Zone::Stick => {
                    let limit = friction.limit(i, pressure[i]);
                    *spare = (limit - qx[i].hypot(qy[i])).max(0.0);
                }
                Zone::Slip => *slip = slip_x[i].hypot(slip_y[i]),
                Zone::Separated => {}
            }
        }
        let is_in_contact = |i: usize| zones[i] != Zone::Separated;
        // Beside the edge of the contact slip obeys that edge too.
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
                && around(i).into_iter().all(touches)
                && has_row(below)
                && has_row(above)
        };
        let compliances = normal.pair().compliances();
        let modulus = |i: usize, [x, y]: [f64; 2]| {
            let size = qx[i].hypot(qy[i]);
            // Cells outside the contact, and those without traction, have that across the edge.
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
            excess: excess(self.boundary(), self.cell_value()),
        }
        .edges()
    }
}
