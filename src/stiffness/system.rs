//! The linear problem behind a stiffness: tractions that answer motions of the bodies, at fixed sets of cells.
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
//! $`\lambda`$ the least eigenvalue of C, on periodic grids among tractions without load.

use crate::boundary::Boundary;
use crate::buffer::{self, TryClone};
use crate::cgm::small::Small;
use crate::cgm::vector::{at, dot, minus, plus, slices, slices_mut, update_cells};
use crate::cgm::{Weight, reduce};
use crate::error::{Result, finite, not_converged};
use crate::fft::ConvolutionWorkspace;
use crate::half_space::Compliance;
use crate::layout::Layout;
use crate::operator::Operator;
use crate::watch::Watch;

/// Products of one motion after which a stiffness counts as not found.
const LIMIT: usize = 2000;
/// Steps between two looks at the bound.
const ROUND: usize = 20;
/// Relative bound at which there is nothing left to improve.
const ENOUGH: f64 = 1e-18;
/// Relative bound that a stiffness must have.
const ALLOWED: f64 = 1e-10;
/// Part of a motion, by its square, that cells must be able to follow in a way of its own.
const NOTHING: f64 = 1e-14;

/// Which motions are independent, and what the others are of them: columns of `parts`.
struct Independent {
    active: [bool; 3],
    parts: [[f64; 3]; 3],
}

/// A vector of `N` components a cell.
pub(super) type Vector<const N: usize> = [Vec<f64>; N];

/// What the traction of a cell may do.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Freedom<const N: usize> {
    /// Nothing.
    Fixed,
    /// Anything.
    Free,
    /// Turn along its friction circle, against a stiffness of its own.
    Along { tangent: [f64; N], stiffness: f64 },
}

impl<const N: usize> Freedom<N> {
    /// The part of a vector that the cell may have.
    fn project(self, q: [f64; N]) -> [f64; N] {
        match self {
            Self::Fixed => [0.0; N],
            Self::Free => q,
            Self::Along { tangent, .. } => tangent.map(|t| t * dot(tangent, q)),
        }
    }

    fn stiffness(self) -> f64 {
        match self {
            Self::Along { stiffness, .. } => stiffness,
            _ => 0.0,
        }
    }
}

/// The operator on a window, and what its cells may do.
pub(super) struct System<'a, const N: usize> {
    compliance: &'a Compliance<N>,
    freedoms: Vec<Freedom<N>>,
    /// What cells have of their own beside the operator; of no cells where none has.
    own: Vec<f64>,
}

/// A solution of `A y = P b`, and `A y` computed anew.
struct Column<const N: usize> {
    right: Vector<N>,
    y: Vector<N>,
    image: Vector<N>,
}

impl<'a, const N: usize> System<'a, N> {
    /// Refuses cells that repeat and are all free: they resist a common motion without limit.
    pub(super) fn new(
        boundary: Boundary,
        compliance: &'a Compliance<N>,
        freedoms: Vec<Freedom<N>>,
        own: Vec<f64>,
    ) -> Result<Self> {
        let is_closed = freedoms.iter().all(|freedom| *freedom == Freedom::Free);
        if is_closed && boundary == Boundary::Periodic {
            finite(
                "stiffness of a contact that is closed everywhere",
                f64::INFINITY,
            )?;
        }
        Ok(Self {
            compliance,
            freedoms,
            own,
        })
    }

    /// What a cell has of its own beside the operator.
    pub(super) fn own(&self, cell: usize) -> f64 {
        self.own.get(cell).copied().unwrap_or(0.0)
    }

    /// What is added to the operator in a cell.
    fn diagonal(&self, cell: usize) -> f64 {
        self.freedoms[cell].stiffness() + self.own(cell)
    }

    pub(super) fn zeros(&self) -> Result<Vector<N>> {
        buffer::vector(self.freedoms.len())
    }

    pub(super) fn product(&self, a: &Vector<N>, b: &Vector<N>) -> f64 {
        let (a, b) = (slices(a), slices(b));
        reduce::sum(&Layout::flat(self.freedoms.len()), |i| {
            dot(at(&a, i), at(&b, i))
        })
    }

    /// `A x`.
    fn apply(
        &self,
        x: &Vector<N>,
        out: &mut Vector<N>,
        workspace: &mut ConvolutionWorkspace<N>,
        watch: &mut Watch<'_>,
    ) -> Result<()> {
        watch.ask()?;
        let operator = &self.compliance.operator;
        operator.apply(slices(x), slices_mut(out), workspace);
        let x = slices(x);
        update_cells(out, |i, u| {
            plus(self.freedoms[i].project(u), self.diagonal(i), at(&x, i))
        });
        Ok(())
    }

    /// `C x`, of any traction.
    pub(super) fn displacement(&self, x: &Vector<N>, watch: &mut Watch<'_>) -> Result<Vector<N>> {
        watch.ask()?;
        let (operator, mut out) = (&self.compliance.operator, self.zeros()?);
        let mut workspace = operator.try_workspace()?;
        operator.apply(slices(x), slices_mut(&mut out), &mut workspace);
        Ok(out)
    }

    /// Begins to solve `A y = P b`.
    fn column(&self, motion: &Vector<N>) -> Result<Column<N>> {
        let mut right = motion.try_clone()?;
        update_cells(&mut right, |i, b| self.freedoms[i].project(b));
        Ok(Column {
            right,
            y: self.zeros()?,
            image: self.zeros()?,
        })
    }

    /// Some steps of preconditioned conjugate gradients, from where the column is.
    fn improve(&self, column: &mut Column<N>, watch: &mut Watch<'_>) -> Result<()> {
        let Compliance { operator, inverse } = self.compliance;
        let (mut products, mut inverses) = (operator.try_workspace()?, inverse.try_workspace()?);
        let (right, image) = (slices(&column.right), slices(&column.image));
        let mut residual = self.zeros()?;
        update_cells(&mut residual, |i, _| minus(at(&right, i), at(&image, i)));
        let (mut direction, mut image) = (self.zeros()?, self.zeros()?);
        let (mut corrected, mut last) = (self.zeros()?, self.zeros()?);
        let least = operator.lower_bound();
        let weight = |i: usize| Weight::new(self.diagonal(i), least);
        let mut before = 0.0;
        for step in 0..ROUND {
            let residuals = slices(&residual);
            update_cells(&mut image, |i, _| {
                at(&residuals, i).map(|r| weight(i).weighted(r))
            });
            inverse.apply(slices(&image), slices_mut(&mut corrected), &mut inverses);
            update_cells(&mut corrected, |i, z| {
                let (weight, r) = (weight(i), at(&residuals, i));
                let z = std::array::from_fn(|c| weight.preconditioned(z[c], r[c]));
                self.freedoms[i].project(z)
            });
            let along = self.product(&residual, &corrected);
            if along.is_nan() || along <= 0.0 {
                break;
            }
            // Polak-Ribiere forgives the rounding of the preconditioner, which is of single precision.
            let overlap = self.product(&last, &corrected);
            let turn = if step > 0 {
                ((along - overlap) / before).max(0.0)
            } else {
                0.0
            };
            before = along;
            let corrected = slices(&corrected);
            update_cells(&mut direction, |i, d| plus(at(&corrected, i), turn, d));
            self.apply(&direction, &mut image, &mut products, watch)?;
            watch.shown().iteration += 1;
            let curvature = self.product(&direction, &image);
            if curvature.is_nan() || curvature <= 0.0 {
                break;
            }
            let length = along / curvature;
            let (directions, images) = (slices(&direction), slices(&image));
            update_cells(&mut column.y, |i, y| plus(y, length, at(&directions, i)));
            for (last, residual) in last.iter_mut().zip(&residual) {
                last.copy_from_slice(residual);
            }
            update_cells(&mut residual, |i, r| plus(r, -length, at(&images, i)));
        }
        self.apply(&column.y, &mut column.image, &mut products, watch)
    }

    /// The stiffness against these motions of the cells, of which there are three at most.
    ///
    /// Motions that the cells follow alike, as all do that slip in one direction, are combinations `C` of independent
    /// ones, and their stiffness is `C'K C`.
    pub(super) fn stiffness(
        &self,
        motions: &[Vector<N>],
        watch: &mut Watch<'_>,
    ) -> Result<Stiffness<N>> {
        let is_free = |freedom: &&Freedom<N>| **freedom == Freedom::Free;
        watch.shown().free = self.freedoms.iter().filter(is_free).count();
        let columns = motions.iter().map(|b| self.column(b));
        let mut columns = columns.collect::<Result<Vec<_>>>()?;
        let Independent { active, parts } = self.independent(&columns, motions);
        let mut bound = f64::INFINITY;
        for _ in 0..LIMIT / ROUND {
            for (column, _) in columns.iter_mut().zip(active).filter(|(_, active)| *active) {
                self.improve(column, watch)?;
            }
            let found = self.combine(&columns, active, parts)?;
            let is_best = found.bound <= ENOUGH || found.bound >= 0.5 * bound;
            bound = found.bound;
            watch.shown().residual = bound.sqrt();
            if active == [false; 3] || (is_best && (0.0..=ALLOWED).contains(&bound)) {
                return Ok(found);
            }
        }
        Err(not_converged(LIMIT, bound))
    }

    /// Which motions the cells follow each in a way of its own, one after the other.
    fn independent(&self, columns: &[Column<N>], motions: &[Vector<N>]) -> Independent {
        let mut found = Independent {
            active: [false; 3],
            parts: [[0.0; 3]; 3],
        };
        let at = |a: usize, b: usize| match (columns.get(a), columns.get(b)) {
            (Some(one), Some(two)) => self.product(&one.right, &two.right),
            _ => 0.0,
        };
        let gram = [0, 1, 2].map(|a| [0, 1, 2].map(|b| at(a, b)));
        for (a, motion) in motions.iter().enumerate() {
            let column = gram.map(|row| row[a]);
            let known = Small(gram).solve(column, found.active);
            let left = gram[a][a] - dot(known, column);
            if left > NOTHING * self.product(motion, motion) {
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

    /// The stiffness by the columns as they are.
    fn combine(
        &self,
        columns: &[Column<N>],
        active: [bool; 3],
        parts: [[f64; 3]; 3],
    ) -> Result<Stiffness<N>> {
        let table = |f: &dyn Fn(&Column<N>, &Column<N>) -> f64| {
            let entry = |a: usize, b: usize| match (columns.get(a), columns.get(b)) {
                (Some(one), Some(two)) if active[a] && active[b] => f(one, two),
                _ => 0.0,
            };
            [0, 1, 2].map(|a| [0, 1, 2].map(|b| entry(a, b)))
        };
        let loads = table(&|one, two| self.product(&one.right, &two.y));
        let energies = table(&|one, two| self.product(&one.y, &two.image));
        let weights = inverse(&loads, active);
        let compliance = times(&transposed(&weights), &times(&energies, &weights));
        let mut squares = [0.0; 3];
        for a in (0..3).filter(|&a| active[a]) {
            let residual =
                self.combination(columns, |c| [compliance[c][a], 0.0, -weights[c][a]])?;
            squares[a] = self.product(&residual, &residual);
        }
        // Relative to the compliances, so that lengths and angles do not mix.
        let least = self.compliance.operator.lower_bound();
        let relative = |a: usize| squares[a] / (least * compliance[a][a]);
        let followed = || (0..3).filter(|&a| active[a]);
        let error = followed().fold(0.0, |sum, a| sum + relative(a));
        let matrix = inverse(&compliance, active);
        let trace = followed().fold(0.0, |sum, a| sum + matrix[a][a] * compliance[a][a]);
        let left = 1.0 - trace * error;
        let x = |a: usize| self.combination(columns, |c| [0.0, weights[c][a], 0.0]);
        Ok(Stiffness {
            matrix: times(&transposed(&parts), &times(&matrix, &parts)),
            own: times(&transposed(&parts), &matrix),
            bound: if left > 0.0 {
                trace * trace * error / left
            } else {
                f64::INFINITY
            },
            tractions: (0..columns.len()).map(x).collect::<Result<_>>()?,
        })
    }

    /// The sum of right sides, solutions and images of the columns, with these factors.
    fn combination(
        &self,
        columns: &[Column<N>],
        factors: impl Fn(usize) -> [f64; 3],
    ) -> Result<Vector<N>> {
        let mut sum = self.zeros()?;
        for (c, column) in columns.iter().enumerate() {
            let parts = [&column.right, &column.y, &column.image].map(slices);
            let factors = factors(c);
            update_cells(&mut sum, |i, sum| {
                (0..3).fold(sum, |sum, part| {
                    plus(sum, factors[part], at(&parts[part], i))
                })
            });
        }
        Ok(sum)
    }

    /// What the loads become when tractions are forced upon cells and displace them so, the motions held: minus the
    /// stiffness times the motions that would keep the loads.
    pub(super) fn reaction(&self, stiffness: &Stiffness<N>, displacement: &Vector<N>) -> [f64; 3] {
        let mut motions = [0.0; 3];
        for (motion, unit) in motions.iter_mut().zip(&stiffness.tractions) {
            *motion = self.product(unit, displacement);
        }
        stiffness.own.map(|row| -dot(row, motions))
    }
}

/// Forces by motions at fixed sets, each cell with the area one.
pub(super) struct Stiffness<const N: usize> {
    pub(super) matrix: [[f64; 3]; 3],
    /// The same by the independent motions alone.
    own: [[f64; 3]; 3],
    /// No entry is further off than this times the root of the product of the two on the diagonal.
    pub(super) bound: f64,
    /// The tractions under a unit of each load and none of the others.
    pub(super) tractions: Vec<Vector<N>>,
}

fn inverse(matrix: &[[f64; 3]; 3], active: [bool; 3]) -> [[f64; 3]; 3] {
    let column = |a: usize| {
        let unit = [0, 1, 2].map(|b| if a == b && active[a] { 1.0 } else { 0.0 });
        Small(*matrix).solve(unit, active)
    };
    transposed(&[column(0), column(1), column(2)])
}

fn transposed(matrix: &[[f64; 3]; 3]) -> [[f64; 3]; 3] {
    [0, 1, 2].map(|a| [0, 1, 2].map(|b| matrix[b][a]))
}

/// `A B`.
pub(super) fn times(a: &[[f64; 3]; 3], b: &[[f64; 3]; 3]) -> [[f64; 3]; 3] {
    let columns = transposed(b);
    a.map(|row| columns.map(|column| dot(row, column)))
}
