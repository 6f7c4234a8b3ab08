//! Linear problem at fixed sets, as solved by a semismooth Newton step and for the stiffness of a contact.
//!
//! Each moving cell has unknowns and the same number of equations. The [row](Row) of a cell relates them to tractions and
//! displacements. Let $`E`$ extend the unknowns to tractions, $`R`$ restrict displacements to equations, and $`B`$ be the
//! local terms of the cells. Together with the multipliers of the totals, the system is
//!
//! ```math
//! \begin{pmatrix} R\,C E + B & -R\,e \\ e' E & D \end{pmatrix} \begin{pmatrix} v \\ \eta \end{pmatrix}
//! = \begin{pmatrix} r \\ \varrho \end{pmatrix} .
//! ```
//!
//! Conjugate gradients solve the system of a symmetric problem. GMRES solves the systems of other problems and of stiffnesses.
//! The preconditioner is the product of $`R`$, an approximate inverse of the operator and the transpose of $`R`$. In cells whose
//! local terms are large, [weights](Weight) combine this product with the inverse for the single cell. If few cells move and
//! these cells are scattered, a [sparse inverse](SparseInverse) replaces the approximate inverse.

mod cg;
mod gmres;
mod response;
mod sparse_inverse;
mod updated_iterate;

use crate::cgm::active_set_solve::Precision;
use crate::cgm::diagonal::CellCompliance;
use crate::cgm::free_cells::FreeCells;
use crate::cgm::law::disc_motion::Weight;
use crate::cgm::law::state::Row;
use crate::cgm::monitor::Monitor;
use crate::cgm::{Total, reduce};
use crate::error::Result;
use crate::memory::fallible;
use crate::numerics::cell_vector::{
    at, chunks, held, plus, put, slices, slices_mut, update_cells, within,
};
use crate::numerics::small_matrix::Small;
use crate::operator::{Operator, Scratch};
use crate::parallel::layout::Layout;
use crate::report::Report;

use gmres::RESTART;
pub(crate) use response::FixedSetSystem;
use sparse_inverse::SparseScratch;
pub(crate) use sparse_inverse::{SparseFactors, SparseInverse};
pub(in crate::cgm) use updated_iterate::UpdatedIterate;

/// Maximum number of GMRES bases before the sets are updated again.
pub(in crate::cgm) const BASES: usize = 2;

/// Buffers of the linear problem.
#[derive(Debug, Clone)]
pub(crate) struct LinearWorkspace<R, const N: usize> {
    /// Scratch of the operator and of the preconditioner.
    pub(in crate::cgm) operator: Scratch,
    pub(in crate::cgm) preconditioner: Scratch,
    pub(in crate::cgm) direction: [Vec<f64>; N],
    pub(in crate::cgm) image: [Vec<f64>; N],
    /// Rows of all cells. If the motion is [steady](Row::IS_STEADY), the vector contains only the rows of the moving cells, in
    /// the order of their list.
    pub(in crate::cgm) rows: Vec<R>,
    /// List of the moving cells. The following vectors store only these cells.
    pub(in crate::cgm) moving: FreeCells,
    pub(in crate::cgm) residual: Vec<[f64; N]>,
    /// Correction of GMRES. The vector is empty before its first use.
    pub(in crate::cgm) correction: Vec<[f64; N]>,
    /// Change of the unknowns per change of each multiplier, `w_a = M e_a`.
    pub(in crate::cgm) spread: Vec<[[f64; N]; N]>,
    /// Basis of GMRES. Its vectors are empty before their first use.
    basis: [Vec<[f64; N]>; RESTART + 1],
    sparse: SparseScratch,
    pub(in crate::cgm) report: Report,
}

impl<R: Row<N>, const N: usize> LinearWorkspace<R, N> {
    /// Creates buffers for an operator and its preconditioner. The vectors of the moving cells are empty.
    pub(crate) fn new(
        operator: &dyn Operator<N>,
        preconditioner: &dyn Operator<N>,
    ) -> Result<Self> {
        let cells = operator.cells();
        Ok(Self {
            operator: operator.scratch()?,
            preconditioner: preconditioner.scratch()?,
            direction: fallible::vector(cells)?,
            image: fallible::vector(cells)?,
            rows: fallible::filled(R::FIXED, cells)?,
            moving: FreeCells::new(operator.layout())?,
            residual: Vec::new(),
            correction: Vec::new(),
            spread: Vec::new(),
            basis: std::array::from_fn(|_| Vec::new()),
            sparse: SparseScratch::default(),
            report: Report::with_room(),
        })
    }

    /// Allocates the unknowns of the moving cells and sets the direction to zero. The linear problem writes only the moving cells
    /// of full vectors.
    pub(in crate::cgm) fn list(&mut self) -> Result<()> {
        for part in &mut self.direction {
            part.fill(0.0);
        }
        self.make_room_for_gmres()
    }

    /// Prepares the sparse inverse for the moving cells. Returns false if the moving cells are not scattered. The direction must
    /// be zero.
    pub(in crate::cgm) fn prepare(&mut self, sparse: &SparseInverse<N>) -> bool {
        if !sparse_inverse::has_few(&self.moving) {
            return false;
        }
        self.mark_moving(1.0);
        let moves = &self.direction[0];
        let is_scattered = sparse.prepare(&self.moving, moves, &mut self.sparse);
        self.mark_moving(0.0);
        is_scattered
    }

    /// Sets the first component of the direction on the moving cells.
    fn mark_moving(&mut self, value: f64) {
        let marks = self.moving.layout().blocks(&mut self.direction[0]);
        self.moving.sweep(marks, |entries, marks| {
            for place in entries.places() {
                marks.items[place] = value;
            }
        });
    }

    /// Allocates correction, residual and spread of the moving cells.
    pub(in crate::cgm) fn make_room_for_gmres(&mut self) -> Result<()> {
        let moving = self.moving.len();
        fallible::resize_with_zeros(&mut self.correction, moving)?;
        self.make_room(moving)
    }

    /// Returns the mobility: the sum of the motions that the cells can follow if all cells are moved by one along each component.
    pub(in crate::cgm) fn mobility(&self) -> Small<N> {
        if !R::IS_CURVED {
            let count = self.moving.of_all_ranks() as f64;
            return Small(std::array::from_fn(|a| unit(a).map(|one| one * count)));
        }
        Small(self.moving.sweep((), |entries, ()| {
            entries.sums(|k, place| {
                let row = entries.row(&self.rows, k, place);
                std::array::from_fn(|a| row.extend(row.restrict(unit(a))))
            })
        }))
    }

    /// Calls `update(cell, row)` for each cell whose row is stored.
    pub(in crate::cgm) fn update_rows(&mut self, update: impl Fn(usize, &mut R) + Sync) {
        let rows = self.moving.motions(&mut self.rows);
        self.moving.sweep(rows, |entries, rows| {
            entries.visit::<R, N>(|kept, place| {
                update(entries.chunk.start + place, &mut rows.items[kept]);
            });
        });
    }

    /// Lists the moving cells. The rows of all cells must be stored.
    pub(in crate::cgm) fn list_moving(&mut self) {
        self.moving.update(|i| self.rows[i].moves());
    }

    /// Replaces row and unknowns of each cell whose row is stored by `next(cell, row, unknowns)`. Returns the number of cells that
    /// [move differently](Row::is_like) and the sums of all unknowns.
    pub(in crate::cgm) fn replace(
        &mut self,
        layout: &Layout,
        x: &mut [&mut [f64]; N],
        next: impl Fn(usize, R, [f64; N]) -> (R, [f64; N]) + Sync,
    ) -> (usize, [f64; N]) {
        let data = (chunks(layout, x), self.moving.motions(&mut self.rows));
        self.moving.sweep(data, |entries, (mut x, rows)| {
            let mut changed = 0_usize;
            entries.visit::<R, N>(|kept, place| {
                let was = rows.items[kept];
                let (row, value) = next(entries.chunk.start + place, was, held(&x, place));
                changed += usize::from(!row.is_like(was));
                rows.items[kept] = row;
                put(&mut x, place, value);
            });
            (changed, x.map(|x| reduce::in_lanes(x.items)))
        })
    }

    /// Allocates residual and spread for this number of cells.
    pub(in crate::cgm) fn make_room(&mut self, cells: usize) -> Result<()> {
        fallible::resize_with_zeros(&mut self.residual, cells)?;
        fallible::resize_with_zeros(&mut self.spread, cells)
    }
}

/// Returns the unit vector along a component.
fn unit<const N: usize>(a: usize) -> [f64; N] {
    std::array::from_fn(|c| if a == c { 1.0 } else { 0.0 })
}

/// Border of the linear problem: the totals for the current motion of the cells.
#[derive(Debug, Clone, Copy)]
pub(in crate::cgm) struct Border<const N: usize> {
    /// Whether the cells can change each total.
    pub(in crate::cgm) active: [bool; N],
    /// Change of the sum of each component due to the spread of each multiplier. The diagonal also contains the reciprocal
    /// of the compliance of a spring.
    pub(in crate::cgm) matrix: Small<N>,
}

impl<const N: usize> Border<N> {
    /// Border of a problem with prescribed motions, in which no total is active.
    pub(in crate::cgm) const NONE: Self = Self {
        active: [false; N],
        matrix: Small([[0.0; N]; N]),
    };

    /// Creates the border of these totals. The matrix contains the changes of the sums without the springs.
    pub(in crate::cgm) fn new(totals: &[Total; N], mut matrix: Small<N>) -> Self {
        for (a, total) in totals.iter().enumerate() {
            if let Some(compliance) = total.compliance() {
                matrix.0[a][a] += 1.0 / compliance;
            }
        }
        Self {
            active: totals.map(|total| total != Total::Free),
            matrix,
        }
    }

    /// Returns the changes of the multipliers that leave the deficit `missing` after the sums have grown by `added`.
    pub(in crate::cgm) fn balance(&self, missing: [f64; N], added: [f64; N]) -> [f64; N] {
        let right = std::array::from_fn(|c| missing[c] - added[c]);
        self.matrix.solve(right, self.active)
    }
}

/// Linear problem for the current motion of the cells.
pub(crate) struct Linear<'a, 'm, R, const N: usize> {
    pub(in crate::cgm) operator: &'a dyn Operator<N>,
    pub(in crate::cgm) preconditioner: &'a dyn Operator<N>,
    /// Replacement of the preconditioner that is prepared for the moving cells, if they are scattered.
    pub(in crate::cgm) sparse: Option<&'a SparseInverse<N>>,
    pub(in crate::cgm) layout: &'a Layout,
    /// Additional compliance of the cells.
    pub(in crate::cgm) own: CellCompliance<'a>,
    /// Displacement of a cell under a unit traction on this cell, or zero if unknown.
    pub(in crate::cgm) self_compliance: f64,
    /// Stiffness added to the operator, or zero outside proximal-point stages.
    pub(in crate::cgm) restraint: f64,
    /// Restraint above which the inverse of the operator alone is useless as a preconditioner.
    pub(in crate::cgm) stiff: f64,
    pub(in crate::cgm) monitor: &'a mut Monitor<'m>,
    pub(in crate::cgm) workspace: &'a mut LinearWorkspace<R, N>,
}

impl<R: Row<N>, const N: usize> Linear<'_, '_, R, N> {
    /// Computes `image = C direction`, including the local terms of the cells.
    pub(in crate::cgm) fn apply(&mut self, precision: Precision) {
        let w = &mut *self.workspace;
        let (direction, image) = (slices(&w.direction), slices_mut(&mut w.image));
        let report = &mut self.monitor.report;
        precision.apply(self.operator, direction, image, &mut w.operator, report);
        let (restraint, own) = (self.restraint, self.own);
        if restraint > 0.0 || !own.is_none() {
            update_cells(&mut w.image, |i, u| {
                let d = at(&direction, i);
                own.added(plus(u, restraint, d), 1.0, i, d)
            });
        }
        if R::HAS_LAG {
            let rows = &w.rows;
            let image = chunks(self.layout, &mut w.image);
            w.moving.sweep(image, |entries, mut image| {
                let direction = within(&direction, &entries.chunk);
                for (k, place) in entries.places().enumerate() {
                    let lag = entries.row(rows, k, place).lag(at(&direction, place));
                    let moved = plus(held(&image, place), 1.0, lag);
                    put(&mut image, place, moved);
                }
            });
        }
    }

    /// Computes `image = M direction`.
    pub(in crate::cgm) fn precondition(&mut self) {
        let w = &mut *self.workspace;
        if self.restraint > self.stiff {
            let direction = slices(&w.direction);
            update_cells(&mut w.image, |i, _| {
                at(&direction, i).map(|r| r / self.restraint)
            });
            return;
        }
        self.weigh_free(|weight, r, answer| (r.map(|r| weight.weighted(r)), answer));
        let w = &mut *self.workspace;
        let direction = slices(&w.direction);
        let is_computed = self
            .sparse
            .is_some_and(|sparse| sparse.apply(&w.moving, direction, &mut w.image, &w.sparse));
        if !is_computed {
            let image = slices_mut(&mut w.image);
            self.preconditioner
                .apply_f32(direction, image, &mut w.preconditioner);
        }
        self.weigh_free(|weight, r, answer| {
            let z = |c: usize| weight.preconditioned_from(answer[c], r[c]);
            (r, std::array::from_fn(z))
        });
    }

    /// Weights the input and the output of the inverse operator on cells that move freely and have an additional compliance.
    fn weigh_free(
        &mut self,
        weigh: impl Fn(Weight, [f64; N], [f64; N]) -> ([f64; N], [f64; N]) + Sync,
    ) {
        let (own, self_compliance) = (self.own, self.self_compliance);
        if own.is_none() {
            return;
        }
        let w = &mut *self.workspace;
        let rows = &w.rows;
        let data = (
            chunks(self.layout, &mut w.direction),
            chunks(self.layout, &mut w.image),
        );
        w.moving.sweep(data, |entries, (mut direction, mut image)| {
            for (k, place) in entries.places().enumerate() {
                if !entries.row(rows, k, place).is_free() {
                    continue;
                }
                let own = own.mean(entries.chunk.start + place);
                let weight = Weight::new(own, self_compliance);
                let (r, z) = weigh(weight, held(&direction, place), held(&image, place));
                put(&mut direction, place, r);
                put(&mut image, place, z);
            }
        });
    }

    /// Computes the spread of the multiplier of each total over the cells. Returns the changes of all sums per unit of each
    /// multiplier, one row per multiplier.
    pub(in crate::cgm) fn spread(&mut self, totals: &[Total; N]) -> Small<N> {
        Small(std::array::from_fn(|a| match totals[a] {
            Total::Free => [0.0; N],
            Total::Sum(_) | Total::Spring { .. } => self.spread_of(a),
        }))
    }

    fn spread_of(&mut self, a: usize) -> [f64; N] {
        let unit = unit(a);
        let w = &mut *self.workspace;
        let weighted = |_, row: R| row.weighted(row.restrict(unit));
        w.moving.set_full(&w.rows, &mut w.direction, weighted);
        self.precondition();
        let w = &mut *self.workspace;
        let (rows, image) = (&w.rows, slices(&w.image));
        let data = w.moving.compressed(&mut w.spread);
        w.moving.sweep(data, |entries, spread| {
            let image = within(&image, &entries.chunk);
            entries.sums_of(spread.items.iter_mut(), |spread, k, place| {
                let row = entries.row(rows, k, place);
                let z = row.preconditioned(at(&image, place), row.restrict(unit));
                spread[a] = z;
                row.extend(z)
            })
        })
    }
}
