//! Type-erased user-defined operators.

use std::fmt;
use std::sync::Arc;

use crate::bodies::component::{Component, Direction};
use crate::error::{Result, memory};
use crate::memory::fallible::zeros;
use crate::operator::{Operator, Scratch, usable_bound};
use crate::parallel::layout::Layout;
use crate::report::EigenvalueBound;

/// Type-erased operator, whose products take a slice of component fields.
trait DynOperator: Send + Sync {
    fn cells(&self) -> usize;
    fn scratch(&self) -> Result<Scratch>;
    fn apply(&self, is_single: bool, x: &[&[f64]], out: &mut [&mut [f64]], scratch: &mut Scratch);
    fn lower_bound(&self) -> f64;
    fn eigenvalue_bound(&self) -> EigenvalueBound;
    fn self_compliance(&self) -> f64;
    fn is_symmetric(&self) -> bool;
}

struct DynOperatorImpl<T, const N: usize>(T);

impl<T: Operator<N> + Send, const N: usize> DynOperator for DynOperatorImpl<T, N> {
    fn cells(&self) -> usize {
        self.0.cells()
    }

    fn scratch(&self) -> Result<Scratch> {
        self.0.scratch()
    }

    fn apply(&self, is_single: bool, x: &[&[f64]], out: &mut [&mut [f64]], scratch: &mut Scratch) {
        let mut out = out.iter_mut();
        let x = std::array::from_fn(|n| x[n]);
        let out = std::array::from_fn(|_| out.next().map_or(&mut [][..], |out| &mut **out));
        if is_single {
            self.0.apply_f32(x, out, scratch);
        } else {
            self.0.apply(x, out, scratch);
        }
    }

    fn lower_bound(&self) -> f64 {
        usable_bound(self.0.lower_bound())
    }

    fn eigenvalue_bound(&self) -> EigenvalueBound {
        self.0.eigenvalue_bound()
    }

    fn self_compliance(&self) -> f64 {
        self.0.self_compliance()
    }

    fn is_symmetric(&self) -> bool {
        self.0.is_symmetric()
    }
}

/// User-defined operator and the directions of its components.
#[derive(Clone)]
pub(crate) struct UserOperator {
    directions: Arc<[Direction]>,
    operator: Arc<dyn DynOperator>,
}

impl UserOperator {
    pub(super) fn new<T, const N: usize>(directions: [Direction; N], operator: T) -> Self
    where
        T: Operator<N> + Send + 'static,
    {
        Self {
            directions: Arc::new(directions),
            operator: Arc::new(DynOperatorImpl(operator)),
        }
    }

    pub(super) fn cells(&self) -> usize {
        self.operator.cells()
    }

    pub(super) fn directions(&self) -> &[Direction] {
        &self.directions
    }

    pub(super) fn lower_bound(&self) -> f64 {
        self.operator.lower_bound()
    }

    pub(super) fn is_symmetric(&self) -> bool {
        self.operator.is_symmetric()
    }

    /// Returns the product of all components, stored consecutively.
    pub(super) fn product(&self, x: &[f64]) -> Result<Vec<f64>> {
        let mut out = zeros(x.len())?;
        self.product_into(x, &mut out)?;
        Ok(out)
    }

    /// Computes the product of all components in a buffer with any content.
    pub(super) fn product_into(&self, x: &[f64], out: &mut [f64]) -> Result<()> {
        let cells = self.cells();
        let mut scratch = self.operator.scratch()?;
        let x: Vec<&[f64]> = x.chunks(cells).collect();
        let mut parts: Vec<&mut [f64]> = out.chunks_mut(cells).collect();
        self.operator.apply(false, &x, &mut parts, &mut scratch);
        Ok(())
    }

    /// Returns the number of unknowns of all components.
    pub(super) fn unknowns(&self) -> Result<usize> {
        let (cells, directions) = (self.cells(), self.directions.len());
        memory(
            "a field of an operator",
            [cells, directions],
            size_of::<f64>(),
        )?;
        Ok(cells * directions)
    }

    /// Returns the index of the component of a direction.
    pub(super) fn component(&self, direction: Direction) -> Option<usize> {
        self.directions.iter().position(|own| *own == direction)
    }

    /// Returns the operator of these components (displacement, then traction) on `size` cells, or `None` if one of
    /// their directions is missing.
    pub(super) fn part<const N: usize>(
        &self,
        components: [[Component; N]; N],
        size: [usize; 2],
    ) -> Option<SubOperator<N>> {
        let (mut rows, mut columns) = ([0; N], [0; N]);
        for n in 0..N {
            rows[n] = self.component(components[n][0].directions()[0])?;
            columns[n] = self.component(components[0][n].directions()[1])?;
        }
        Some(SubOperator {
            given: self.clone(),
            rows,
            columns,
            size,
        })
    }
}

impl fmt::Debug for UserOperator {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_tuple("UserOperator")
            .field(&self.directions)
            .finish()
    }
}

/// Selected rows and columns of a user-defined operator.
#[derive(Debug, Clone)]
pub(crate) struct SubOperator<const N: usize> {
    given: UserOperator,
    rows: [usize; N],
    columns: [usize; N],
    size: [usize; 2],
}

impl<const N: usize> SubOperator<N> {
    /// Returns whether both are the same part of the same operator.
    pub(crate) fn is(&self, other: &Self) -> bool {
        let is_of_one = Arc::ptr_eq(&self.given.operator, &other.given.operator);
        is_of_one && (self.rows, self.columns) == (other.rows, other.columns)
    }

    fn product(
        &self,
        is_single: bool,
        x: [&[f64]; N],
        out: [&mut [f64]; N],
        scratch: &mut Scratch,
    ) {
        let PartScratch { own, zeros, rest } = scratch.buffers();
        let all = self.given.directions.len();
        let mut columns = [&zeros[..]; DIRECTIONS];
        for (x, column) in x.into_iter().zip(self.columns) {
            columns[column] = x;
        }
        let mut rows = [const { None }; DIRECTIONS];
        for (out, row) in out.into_iter().zip(self.rows) {
            rows[row] = Some(out);
        }
        let mut rest = rest.chunks_mut(self.given.cells());
        let mut rows = rows.map(|row| row.or_else(|| rest.next()).unwrap_or_default());
        let operator = &self.given.operator;
        operator.apply(is_single, &columns[..all], &mut rows[..all], own);
    }
}

/// Largest number of directions of an operator.
const DIRECTIONS: usize = 3;

/// Buffers of products: the scratch of the user-defined operator, and fields for the components that the part does not
/// contain.
#[derive(Clone)]
struct PartScratch {
    own: Scratch,
    zeros: Vec<f64>,
    rest: Vec<f64>,
}

impl<const N: usize> Operator<N> for SubOperator<N> {
    fn cells(&self) -> usize {
        self.given.cells()
    }

    fn layout(&self) -> Layout {
        Layout::of(self.size)
    }

    fn scratch(&self) -> Result<Scratch> {
        let (cells, others) = (self.cells(), self.given.directions.len() - N);
        Ok(Scratch::new(PartScratch {
            own: self.given.operator.scratch()?,
            zeros: zeros(if others > 0 { cells } else { 0 })?,
            rest: zeros(others * cells)?,
        }))
    }

    fn apply(&self, x: [&[f64]; N], out: [&mut [f64]; N], scratch: &mut Scratch) {
        self.product(false, x, out, scratch);
    }

    fn apply_f32(&self, x: [&[f64]; N], out: [&mut [f64]; N], scratch: &mut Scratch) {
        self.product(true, x, out, scratch);
    }

    /// Returns the bound of the whole operator, which is also a bound for a part with the same rows and columns.
    fn lower_bound(&self) -> f64 {
        if self.rows == self.columns {
            self.given.lower_bound()
        } else {
            0.0
        }
    }

    fn eigenvalue_bound(&self) -> EigenvalueBound {
        if Operator::<N>::lower_bound(self) > 0.0 {
            self.given.operator.eigenvalue_bound()
        } else {
            EigenvalueBound::Unknown
        }
    }

    fn self_compliance(&self) -> f64 {
        self.given.operator.self_compliance()
    }
}
