//! The stiffness at fixed sets of cells: tractions that answer motions of the bodies.
//!
//! Cells that stick are free, cells that slip move along a line, all others are fixed. With the projection P onto what
//! cells may do, the turning stiffness D and the motions $`b_a`$ of the cells, the tractions $`y_a`$ that a unit of each
//! motion causes solve $`A\,y_a = P\,b_a`$, $`A = P C P + D`$; to D comes the compliance of cells that entered the contact
//! in the step. Their combinations $`x_a`$ with the loads
//! $`b_b\cdot x_a = \delta_{ab}`$ have the least energy of all tractions with these loads, so that $`S = X'A X`$ is a
//! compliance from above. With the residuals $`R = P B S - A X`$, an error $`e_a`$ of $`x_a`$ has no load, and
//!
//! ```math
//! e_a' A\,e_a = -e_a' R_a \le \frac{|R_a|^2}{\lambda} ,
//! ```
//!
//! $`\lambda`$ the least eigenvalue of C, on grids that repeat among tractions without load.

use crate::boundary::Boundary;
use crate::buffer;
use crate::cgm::small::Small;
use crate::cgm::vector::{at, dot, plus, slices, slices_mut};
use crate::cgm::{Held, LinearWorkspace, Own, Row, reduce};
use crate::error::{Result, finite};
use crate::half_space::{Compliance, HalfSpace};
use crate::layout::Layout;
use crate::operator::Operator;
use crate::report::Status;
use crate::stiffness::course::Course;
use crate::stiffness::workspace::provide;
use crate::tangential::Drawing;

/// Relative bound that a stiffness must have, unless its tolerance is wider.
const ALLOWED: f64 = 1e-10;
/// Part of a motion, by its square, that cells must be able to follow in a way of its own.
const NOTHING: f64 = 1e-14;

/// A vector of `N` components a cell.
pub(super) type Vector<const N: usize> = [Vec<f64>; N];

/// The operator on a window, what its cells may do, and the buffers of the linear problem.
#[derive(Debug)]
pub(super) struct System<R, const N: usize> {
    compliance: Compliance<N>,
    layout: Layout,
    linear: LinearWorkspace<R, N>,
    /// Compliance that cells have of their own beside the operator; of no cells where none has.
    own: Vec<f64>,
    columns: [Column<N>; 3],
    combined: Vec<[f64; N]>,
    /// Tractions that are forced upon cells, and what they displace.
    pub(super) forced: Vector<N>,
    pub(super) displacement: Vector<N>,
    /// How pressure moves the surfaces tangentially, once that is asked for.
    drawing: Option<Drawing>,
}

/// A solution of `A y = P b` of the unknowns of the cells that move.
#[derive(Debug, Default)]
struct Column<const N: usize> {
    right: Vec<[f64; N]>,
    y: Vec<[f64; N]>,
    /// `P b - A y`.
    left: Vec<[f64; N]>,
    /// The tractions under a unit of this load and none of the others.
    unit: Vec<[f64; N]>,
}

/// Forces by motions at fixed sets, each cell with the area one.
#[derive(Debug, Clone, Copy)]
pub(super) struct Stiffness {
    pub(super) matrix: [[f64; 3]; 3],
    /// The same by the independent motions alone.
    own: [[f64; 3]; 3],
    /// No entry is further off than this times the root of the product of the two on the diagonal.
    pub(super) bound: f64,
}

/// Motions of the cells, of which there are three at most: that of a cell, and the sum of the squares over the contact.
pub(super) struct CellMotions<F> {
    pub(super) count: usize,
    pub(super) of_cell: F,
    pub(super) squares: [f64; 3],
}

/// Which motions are independent, and what the others are of them: columns of `parts`.
struct Independent {
    active: [bool; 3],
    parts: [[f64; 3]; 3],
}

impl<R: Row<N>, const N: usize> System<R, N> {
    /// That of a window, in the buffers there are if they are of it.
    pub(super) fn provide<'a>(
        slot: &'a mut Option<Self>,
        bodies: &HalfSpace,
        compliance: Compliance<N>,
    ) -> Result<&'a mut Self> {
        let Compliance { operator, inverse } = compliance.clone();
        operator.check_bounded()?;
        let is_own = |own: &Self| {
            own.compliance.operator.is(&operator) && own.compliance.inverse.is(&inverse)
        };
        provide(slot, is_own, || {
            Ok(Self {
                layout: operator.layout().alike(bodies.team()),
                linear: LinearWorkspace::new(&operator, &inverse)?,
                own: Vec::new(),
                columns: Default::default(),
                combined: Vec::new(),
                forced: buffer::vector(operator.cells())?,
                displacement: buffer::vector(operator.cells())?,
                drawing: None,
                compliance,
            })
        })
    }

    /// Takes what each cell may do, and has of its own; of no cells where none has. Refuses cells that repeat and are all free:
    /// they resist a common motion without limit.
    pub(super) fn hold(
        &mut self,
        boundary: Boundary,
        row: impl Fn(usize) -> R + Sync,
        own: &[f64],
    ) -> Result<()> {
        let is_open = || reduce::any(&self.layout, |cell| !row(cell).is_free());
        if boundary == Boundary::Periodic && !is_open() {
            finite(
                "stiffness of a contact that is closed everywhere",
                f64::INFINITY,
            )?;
        }
        self.own.clear();
        buffer::make_room(&mut self.own, own.len())?;
        self.own.extend_from_slice(own);
        self.linear.hold(row)
    }

    /// The least eigenvalue of the operator, of tractions without load.
    pub(super) fn lower_bound(&self) -> f64 {
        self.compliance.operator.bound_without_mean().0
    }

    /// How far a unit traction displaces its own cell.
    pub(super) fn self_compliance(&self) -> f64 {
        self.compliance.operator.self_compliance()
    }

    /// The stiffness against these motions of the cells.
    ///
    /// Motions that the cells follow alike, as all do that slip in one direction, are combinations `C` of independent
    /// ones, and their stiffness is `C'K C`.
    pub(super) fn stiffness(
        &mut self,
        motions: &CellMotions<impl Fn(usize, usize) -> [f64; N] + Sync>,
        course: &mut Course<'_>,
    ) -> Result<Stiffness> {
        for (a, column) in self.columns.iter_mut().enumerate().take(motions.count) {
            self.linear
                .restrict(|i| (motions.of_cell)(a, i), &mut column.right)?;
        }
        let Independent { active, parts } = self.independent(motions.count, motions.squares);
        let held = Held {
            operator: &self.compliance.operator,
            preconditioner: &self.compliance.inverse,
            layout: &self.layout,
            own: Own::isotropic(&self.own),
        };
        for (column, _) in self.columns.iter_mut().zip(active).filter(|(_, is)| *is) {
            course.respond(&held, &column.right, &mut column.y, &mut self.linear)?;
            column.left.clear();
            buffer::make_room(&mut column.left, column.right.len())?;
            column.left.extend_from_slice(self.linear.left());
        }
        let found = self.combine(active, parts)?;
        // The bound decides, wherever round-off has left the residuals.
        course.rest_on(self.compliance.operator.bound_without_mean().1);
        course.report.status = if found.bound <= ALLOWED.max(course.tolerance) {
            Status::Converged
        } else {
            Status::Stalled
        };
        course.check_solved()?;
        Ok(found)
    }

    /// Which motions the cells follow each in a way of its own, one after the other.
    fn independent(&self, count: usize, squares: [f64; 3]) -> Independent {
        let mut found = Independent {
            active: [false; 3],
            parts: [[0.0; 3]; 3],
        };
        let gram = self.table([true, count > 1, count > 2], |one, two| {
            self.linear.product(&one.right, &two.right)
        });
        for a in 0..count {
            let column = gram.map(|row| row[a]);
            let known = Small(gram).solve(column, found.active);
            let left = gram[a][a] - dot(known, column);
            if left > NOTHING * squares[a] {
                found.active[a] = true;
                found.parts[a][a] = 1.0;
            } else {
                for (row, part) in found.parts.iter_mut().zip(known) {
                    row[a] = part;
                }
            }
        }
        found
    }

    /// A number of every two of these columns.
    fn table(&self, of: [bool; 3], entry: impl Fn(&Column<N>, &Column<N>) -> f64) -> [[f64; 3]; 3] {
        let entry = |a: usize, b: usize| {
            if of[a] && of[b] {
                entry(&self.columns[a], &self.columns[b])
            } else {
                0.0
            }
        };
        [0, 1, 2].map(|a| [0, 1, 2].map(|b| entry(a, b)))
    }

    /// The stiffness by the columns as they are.
    fn combine(&mut self, active: [bool; 3], parts: [[f64; 3]; 3]) -> Result<Stiffness> {
        let product = |a: &[[f64; N]], b: &[[f64; N]]| self.linear.product(a, b);
        let loads = self.table(active, |one, two| product(&one.right, &two.y));
        let energies = self.table(active, |one, two| {
            product(&one.y, &two.right) - product(&one.y, &two.left)
        });
        let weights = inverse(&loads, active);
        let compliance = times(&transposed(&weights), &times(&energies, &weights));
        let mut squares = [0.0; 3];
        for a in (0..3).filter(|&a| active[a]) {
            // P B S - A X, with A y = P b - left.
            self.add_columns(active, |c| {
                let weight = weights[c][a];
                [compliance[c][a] - weight, 0.0, weight]
            })?;
            squares[a] = self.linear.product(&self.combined, &self.combined);
        }
        // Relative to the compliances, so that lengths and angles do not mix.
        let least = self.lower_bound();
        let relative = |a: usize| match compliance[a][a] {
            own if own > 0.0 => squares[a] / (least * own),
            // The datum of a grid that repeats along y is too near for the contact.
            _ => f64::INFINITY,
        };
        let followed = || (0..3).filter(|&a| active[a]);
        let error = followed().fold(0.0, |sum, a| sum + relative(a));
        let matrix = inverse(&compliance, active);
        let trace = followed().fold(0.0, |sum, a| sum + matrix[a][a] * compliance[a][a]);
        let left = 1.0 - trace * error;
        for a in [0, 1, 2] {
            self.add_columns(active, |c| [0.0, weights[c][a], 0.0])?;
            std::mem::swap(&mut self.combined, &mut self.columns[a].unit);
        }
        Ok(Stiffness {
            matrix: times(&transposed(&parts), &times(&matrix, &parts)),
            own: times(&transposed(&parts), &matrix),
            bound: if left > 0.0 {
                trace * trace * error / left
            } else {
                f64::INFINITY
            },
        })
    }

    /// The sum of right sides, solutions and residuals of the active columns, with these factors.
    fn add_columns(
        &mut self,
        active: [bool; 3],
        factors: impl Fn(usize) -> [f64; 3],
    ) -> Result<()> {
        self.combined.clear();
        let cells = self.columns[0].right.len();
        buffer::resize(&mut self.combined, cells, [0.0; N])?;
        for (c, column) in self.columns.iter().enumerate().filter(|(c, _)| active[*c]) {
            let parts = [&column.right, &column.y, &column.left];
            for (part, factor) in parts.into_iter().zip(factors(c)) {
                for (sum, part) in self.combined.iter_mut().zip(part) {
                    *sum = plus(*sum, factor, *part);
                }
            }
        }
        Ok(())
    }

    /// The tractions of all cells under a unit of the first load and none of the others.
    pub(super) fn unit(&mut self) -> [&[f64]; N] {
        for part in &mut self.forced {
            part.fill(0.0);
        }
        let (unit, forced) = (&self.columns[0].unit, &mut self.forced);
        self.linear.places(|k, cell| {
            for (part, value) in forced.iter_mut().zip(unit[k]) {
                part[cell] = value;
            }
        });
        slices(&self.forced)
    }

    /// The displacement that the forced tractions cause.
    pub(super) fn displace(&mut self, course: &mut Course<'_>) -> Result<()> {
        course.ask(&self.layout)?;
        let (forced, out) = (slices(&self.forced), slices_mut(&mut self.displacement));
        self.linear.displace(&self.compliance.operator, forced, out);
        Ok(())
    }

    /// Adds the displacement that pressures of the window cause.
    pub(super) fn draw(
        &mut self,
        make: impl FnOnce() -> Result<Drawing>,
        pressures: impl Iterator<Item = f64>,
        course: &mut Course<'_>,
    ) -> Result<()> {
        for _ in 0..N {
            course.ask(&self.layout)?;
        }
        let drawing = provide(&mut self.drawing, |_| true, make)?;
        let mut parts = self.displacement.iter_mut();
        drawing.displace(pressures, |_, drawn| {
            // The axes of both are the same, in order.
            for (u, drawn) in parts.next().into_iter().flatten().zip(drawn) {
                *u += drawn;
            }
        });
        Ok(())
    }

    /// What the loads become when tractions are forced upon cells and displace them so, the motions held: minus the
    /// stiffness times the motions that would keep the loads.
    pub(super) fn reaction(&mut self, stiffness: &Stiffness) -> Result<[f64; 3]> {
        let displacement = slices(&self.displacement);
        let moved = |cell: usize| at(&displacement, cell);
        self.linear.restrict(moved, &mut self.combined)?;
        let motion = |unit: &[[f64; N]]| self.linear.product(unit, &self.combined);
        let motions = self.columns.each_ref().map(|column| motion(&column.unit));
        Ok(stiffness.own.map(|row| -dot(row, motions)))
    }
}

fn inverse(matrix: &[[f64; 3]; 3], active: [bool; 3]) -> [[f64; 3]; 3] {
    let column = |a: usize| {
        let unit = [0, 1, 2].map(|b| if a == b && active[a] { 1.0 } else { 0.0 });
        Small(*matrix).solve(unit, active)
    };
    transposed(&[column(0), column(1), column(2)])
}

fn transposed(matrix: &[[f64; 3]; 3]) -> [[f64; 3]; 3] {
    Small(*matrix).transposed().0
}

/// `A B`.
pub(super) fn times(a: &[[f64; 3]; 3], b: &[[f64; 3]; 3]) -> [[f64; 3]; 3] {
    let columns = transposed(b);
    a.map(|row| columns.map(|column| dot(row, column)))
}
