//! Stiffness at fixed sets of cells, from linear solves (GMRES) for the tractions caused by motions of the bodies.
//!
//! Sticking cells are free, slipping cells move along a line, and all other cells are fixed. Let P be the projection onto the
//! admissible directions of the cells, and let $`b_a`$ be the motions of the cells. Let D be the stiffness against rotation of
//! the tractions. D also contains the entry compliance of cells that came into contact in the step. The tractions $`y_a`$ caused
//! by a unit of each motion solve $`A\,y_a = P\,b_a`$ with $`A = P C P + D`$. The stiffness is $`K_{ab} = b_a' P A^{-1} P\,b_b`$.
//! With the residuals $`r_a = P\,b_a - A\,y_a`$ and the errors $`e_a = A^{-1} r_a`$ of the tractions,
//!
//! ```math
//! K_{ab} = y_a' A\,y_b + y_a' r_b + r_a' y_b + e_a' A\,e_b .
//! ```
//!
//! The last term is neglected. Its magnitude is at most $`\epsilon_a \epsilon_b`$ with $`\epsilon_a^2 = e_a' A\,e_a = e_a' r_a`$.
//! No matrix of loads is inverted, so nearly parallel motions do not reduce the accuracy.
//!
//! The bound $`\lambda`$ on the least eigenvalue of C may hold only for tractions with zero mean, as on periodic grids. The sums
//! of the errors follow from the shifts c, whose motions are constant: $`b_c' e_a = y_c' r_a + e_c' A\,e_a`$. With n moving
//! cells,
//!
//! ```math
//! |e_a|^2 \le \frac{\epsilon_a^2}{\lambda} + \frac{1}{n} \sum_c (|y_c' r_a| + \epsilon_c \epsilon_a)^2
//! \le \epsilon_a^2 \Bigl(\frac{1}{\lambda} + \frac{2}{n} \sum_c \epsilon_c^2\Bigr) + \tau_a^2 ,
//! \qquad \tau_a^2 = \frac{2}{n} \sum_c (y_c' r_a)^2 ,
//! ```
//!
//! and $`\epsilon_a^2 \le |e_a| |r_a|`$ gives
//!
//! ```math
//! \epsilon_a^2 \le |r_a|^2 \Bigl(\frac{1}{\lambda} + \frac{2}{n} \sum_c \epsilon_c^2\Bigr) + |r_a| \tau_a .
//! ```
//!
//! Summing over the shifts first gives a bound on $`\sum_c \epsilon_c^2`$.

use crate::cgm::reduce::{self, larger};
use crate::cgm::{CellCompliance, Row};
use crate::contact::{LinearResponse, ResponseColumn, ResponseContext};
use crate::error::{Result, check_converged};
use crate::half_space::{Compliance, ElasticOperator, HalfSpace};
use crate::memory::fallible;
use crate::numerics::cell_vector::{at, dot, plus, slices, slices_mut};
use crate::numerics::small_matrix::Small;
use crate::operator::Operator;
use crate::report::Status;
use crate::stiffness::contact::check_open;
use crate::stiffness::workspace::get_or_create;
use crate::tangential::CouplingDisplacement;

/// Maximum relative bound of an accepted stiffness, unless the tolerance is larger.
const ALLOWED: f64 = 1e-10;

/// A vector of `N` components per cell.
pub(super) type Vector<const N: usize> = [Vec<f64>; N];

/// Operator on a window, admissible motions of its cells, and buffers of the linear problem.
#[derive(Debug)]
pub(crate) struct System<R, const N: usize> {
    pub(crate) compliance: Compliance<N>,
    /// Displacement of a cell under a unit traction on it.
    pub(crate) self_compliance: f64,
    pub(crate) response: LinearResponse<R, N>,
    /// Entry compliance of the cells. Empty if no cell has an entry compliance.
    own: Vec<f64>,
    /// Number of moving cells on all ranks.
    moving: f64,
    restricted: Vec<[f64; N]>,
    /// Tractions imposed on cells, and their displacement. Empty before the first [`Self::hold`].
    pub(crate) forced: Vector<N>,
    pub(crate) displacement: Vector<N>,
    /// Tangential displacement due to the pressure, created on first use.
    drawing: Option<CouplingDisplacement>,
}

/// Derivatives of forces with respect to motions at fixed sets, for cells of unit area.
#[derive(Debug, Clone, Copy)]
pub(super) struct Stiffness {
    pub(super) matrix: [[f64; 3]; 3],
    /// Bound on the errors. No entry has an error larger than this bound times the square root of the product of the two diagonal
    /// entries.
    pub(super) bound: f64,
}

/// Motions of the cells, at most three. The first motions are one shift per component of a cell, and other motions follow.
pub(super) struct CellMotions<F> {
    pub(super) count: usize,
    pub(super) of_cell: F,
}

impl<R: Row<N>, const N: usize> System<R, N> {
    /// Returns the system for a window. Reuses the existing buffers if they belong to this window.
    pub(super) fn get_or_create<'a>(
        slot: &'a mut Option<Self>,
        bodies: &HalfSpace,
        compliance: Compliance<N>,
        self_compliance: impl FnOnce(&ElasticOperator<N>) -> Result<f64>,
    ) -> Result<&'a mut Self> {
        let Compliance { operator, inverse } = compliance.clone();
        operator.check_bounded()?;
        let is_own = |own: &Self| {
            own.compliance.operator.is(&operator) && own.compliance.inverse.is(&inverse)
        };
        get_or_create(slot, is_own, || {
            let layout = operator.layout().alike(bodies.team());
            Ok(Self {
                self_compliance: self_compliance(&operator)?,
                response: LinearResponse::new(&operator, &inverse, layout)?,
                own: Vec::new(),
                moving: 0.0,
                restricted: Vec::new(),
                forced: [const { Vec::new() }; N],
                displacement: [const { Vec::new() }; N],
                drawing: None,
                compliance,
            })
        })
    }

    /// Sets the admissible motions of the cells and their entry compliance. The entry compliance is empty if no cell has one.
    /// Rejects a periodic contact whose cells are all free.
    pub(crate) fn hold(
        &mut self,
        bodies: &HalfSpace,
        row: impl Fn(usize) -> R + Sync,
        own: &[f64],
    ) -> Result<()> {
        let layout = &self.response.layout;
        check_open(bodies, || reduce::any(layout, |cell| !row(cell).is_free()))?;
        self.own.clear();
        fallible::make_room(&mut self.own, own.len())?;
        self.own.extend_from_slice(own);
        for part in self.forced.iter_mut().chain(&mut self.displacement) {
            fallible::resize(part, layout.cells(), 0.0)?;
        }
        let moves = |cell: usize| f64::from(u8::from(row(cell).moves()));
        self.moving = reduce::sum(layout, moves);
        self.response.linear.hold(row)
    }

    /// Returns the tractions that cause the given displacements of the cells.
    ///
    /// # Errors
    /// The errors of [`LinearResponse::tractions`].
    pub(crate) fn tractions(
        &mut self,
        displacement: impl Fn(usize) -> [f64; N] + Sync,
        context: &mut ResponseContext<'_>,
    ) -> Result<[&[f64]; N]> {
        let own = CellCompliance::isotropic(&self.own);
        let elasticity = self.compliance.with_cells(own);
        self.response.tractions(elasticity, displacement, context)
    }

    /// Computes the stiffness against these motions of the cells.
    pub(super) fn stiffness(
        &mut self,
        motions: &CellMotions<impl Fn(usize, usize) -> [f64; N] + Sync>,
        context: &mut ResponseContext<'_>,
    ) -> Result<Stiffness> {
        let own = CellCompliance::isotropic(&self.own);
        let elasticity = self.compliance.with_cells(own);
        for a in 0..motions.count {
            let motion = |cell: usize| (motions.of_cell)(a, cell);
            self.response.respond(a, elasticity, motion, context)?;
        }
        let matrix = self.matrix(motions.count);
        let bound = self.bound(motions.count, &matrix);
        // The bound determines the status, even if round-off keeps the residuals above the tolerance.
        context.require_eigenvalue_bound(self.compliance.operator.eigenvalue_bound());
        context.report.status = if bound <= ALLOWED.max(context.tolerance) {
            Status::Converged
        } else {
            Status::Stalled
        };
        check_converged(context.report)?;
        Ok(Stiffness { matrix, bound })
    }

    /// Computes `y' A y + y' r + r' y`, where `A y + r = P b`. The result is the mean of `y' P b + r' y` and its transpose.
    fn matrix(&self, count: usize) -> [[f64; 3]; 3] {
        let half = self.table(count, |one, two| {
            self.response.linear.product(&one.y, &two.right)
                + self.response.linear.product(&one.left, &two.y)
        });
        [0, 1, 2].map(|a| [0, 1, 2].map(|b| 0.5 * (half[a][b] + half[b][a])))
    }

    /// Bounds the errors of the entries of the matrix, relative to the diagonal.
    fn bound(&self, count: usize, matrix: &[[f64; 3]; 3]) -> f64 {
        let residuals = self.table(count, |one, two| {
            self.response.linear.product(&one.left, &two.left)
        });
        let sums = self.table(count, |one, two| {
            self.response.linear.product(&one.y, &two.left)
        });
        let (least, cells) = (self.compliance.operator.lower_bound(), self.moving.max(1.0));
        // Bound |r|^2 / lambda + |r| tau for one motion.
        let plain = |a: usize| {
            let sums = [0, 1, 2].map(|c| if c < N { sums[c][a] } else { 0.0 });
            let square = residuals[a][a];
            square / least + (square * 2.0 / cells * dot(sums, sums)).sqrt()
        };
        let shifts = || 0..count.min(N);
        let part = 2.0 / cells * shifts().fold(0.0, |sum, c| sum + residuals[c][c]);
        if part >= 1.0 {
            return f64::INFINITY;
        }
        let squares = shifts().fold(0.0, |sum, c| sum + plain(c)) / (1.0 - part);
        let relative = |a: usize| {
            let square = plain(a) + residuals[a][a] * 2.0 / cells * squares;
            if square == 0.0 {
                0.0
            } else {
                square / matrix[a][a].max(0.0)
            }
        };
        (0..count).fold(0.0, |largest, a| larger(largest, relative(a)))
    }

    /// Computes one number for each pair of the first `count` columns, and zero for other pairs.
    fn table(
        &self,
        count: usize,
        entry: impl Fn(&ResponseColumn<N>, &ResponseColumn<N>) -> f64,
    ) -> [[f64; 3]; 3] {
        let entry = |a: usize, b: usize| {
            if a < count && b < count {
                entry(&self.response.columns[a], &self.response.columns[b])
            } else {
                0.0
            }
        };
        [0, 1, 2].map(|a| [0, 1, 2].map(|b| entry(a, b)))
    }

    /// Returns the tractions of all cells per unit of the first motion.
    pub(super) fn unit(&mut self) -> [&[f64]; N] {
        for part in &mut self.forced {
            part.fill(0.0);
        }
        let (unit, forced) = (&self.response.columns[0].y, &mut self.forced);
        self.response.linear.places(|k, cell| {
            for (part, value) in forced.iter_mut().zip(unit[k]) {
                part[cell] = value;
            }
        });
        slices(&self.forced)
    }

    /// Returns a displacement of a cell plus the displacement due to its own compliance under these tractions.
    pub(crate) fn with_own_displacement(
        &self,
        displacement: [f64; N],
        cell: usize,
        tractions: [f64; N],
    ) -> [f64; N] {
        let own = CellCompliance::isotropic(&self.own);
        let displacement = own.added(displacement, 1.0, cell, tractions);
        plus(displacement, 1.0, self.response.linear.lag(cell, tractions))
    }

    /// Computes the displacement caused by the imposed tractions.
    pub(crate) fn displace(&mut self, context: &mut ResponseContext<'_>) -> Result<()> {
        context.notify_observer(&self.response.layout)?;
        let (forced, out) = (slices(&self.forced), slices_mut(&mut self.displacement));
        self.response
            .linear
            .displace(&self.compliance.operator, forced, out);
        Ok(())
    }

    /// Adds the displacement caused by pressures on the window.
    pub(crate) fn draw(
        &mut self,
        make: impl FnOnce() -> Result<CouplingDisplacement>,
        pressures: impl Iterator<Item = f64>,
        context: &mut ResponseContext<'_>,
    ) -> Result<()> {
        for _ in 0..N {
            context.notify_observer(&self.response.layout)?;
        }
        let drawing = get_or_create(&mut self.drawing, |_| true, make)?;
        let mut parts = self.displacement.iter_mut();
        drawing.displace(pressures, |_, drawn| {
            // Both have the same axes in the same order.
            for (u, drawn) in parts.next().into_iter().flatten().zip(drawn) {
                *u += drawn;
            }
        });
        Ok(())
    }

    /// Computes the loads of the first motions caused by the imposed tractions, while all motions are zero.
    pub(super) fn reaction(&mut self, count: usize) -> Result<[f64; 3]> {
        let displacement = slices(&self.displacement);
        let displaced = |cell: usize| at(&displacement, cell);
        self.response
            .linear
            .restrict(displaced, &mut self.restricted)?;
        Ok(std::array::from_fn(|a| {
            if a < count {
                -self
                    .response
                    .linear
                    .product(&self.response.columns[a].y, &self.restricted)
            } else {
                0.0
            }
        }))
    }
}

fn transposed(matrix: &[[f64; 3]; 3]) -> [[f64; 3]; 3] {
    Small(*matrix).transposed().0
}

/// Returns `A B`.
pub(super) fn times(a: &[[f64; 3]; 3], b: &[[f64; 3]; 3]) -> [[f64; 3]; 3] {
    let columns = transposed(b);
    a.map(|row| columns.map(|column| dot(row, column)))
}
