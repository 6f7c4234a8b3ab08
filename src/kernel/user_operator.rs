//! An operator of a user, of whatever type, with whatever workspace.

use std::any::Any;
use std::fmt;
use std::sync::{Arc, Mutex, PoisonError};

use crate::buffer::{or_abort, zeros};
use crate::error::{Result, memory};
use crate::influence::{Component, Direction};
use crate::layout::Layout;
use crate::operator::Operator;
use crate::report::EigenvalueBound;
use crate::shown::shown;

/// An operator without its type: as many slices as it has components.
trait Erased: Send + Sync {
    fn cells(&self) -> usize;
    fn try_workspace(&self) -> Result<Box<dyn Any + Send>>;
    fn apply(
        &self,
        is_single: bool,
        x: &[&[f64]],
        out: &mut [&mut [f64]],
        workspace: &mut (dyn Any + Send),
    );
    fn lower_bound(&self) -> f64;
    fn eigenvalue_bound(&self) -> EigenvalueBound;
    fn self_compliance(&self) -> f64;
    fn is_symmetric(&self) -> bool;
}

struct Typed<T, const N: usize>(T);

impl<T, const N: usize> Erased for Typed<T, N>
where
    T: Operator<N> + Send,
    T::Workspace: 'static,
{
    fn cells(&self) -> usize {
        self.0.cells()
    }

    fn try_workspace(&self) -> Result<Box<dyn Any + Send>> {
        Ok(Box::new(self.0.try_workspace()?))
    }

    fn apply(
        &self,
        is_single: bool,
        x: &[&[f64]],
        out: &mut [&mut [f64]],
        workspace: &mut (dyn Any + Send),
    ) {
        let Some(workspace) = workspace.downcast_mut() else {
            panic!("the workspace is that of another operator")
        };
        let mut out = out.iter_mut();
        let x = std::array::from_fn(|n| x[n]);
        let out = std::array::from_fn(|_| out.next().map_or(&mut [][..], |out| &mut **out));
        if is_single {
            self.0.apply_f32(x, out, workspace);
        } else {
            self.0.apply(x, out, workspace);
        }
    }

    fn lower_bound(&self) -> f64 {
        self.0.lower_bound().max(0.0)
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

/// An operator of a user, and the directions of its components.
#[derive(Clone)]
pub(crate) struct UserOperator {
    directions: Arc<[Direction]>,
    operator: Arc<dyn Erased>,
}

impl UserOperator {
    pub(super) fn new<T, const N: usize>(directions: [Direction; N], operator: T) -> Self
    where
        T: Operator<N> + Send + 'static,
        T::Workspace: 'static,
    {
        Self {
            directions: Arc::new(directions),
            operator: Arc::new(Typed(operator)),
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

    /// A product of all components, one behind the other.
    pub(super) fn product(&self, x: &[f64]) -> Result<Vec<f64>> {
        let (cells, mut out) = (self.cells(), zeros(x.len())?);
        let mut workspace = self.operator.try_workspace()?;
        let x: Vec<&[f64]> = x.chunks(cells).collect();
        let mut parts: Vec<&mut [f64]> = out.chunks_mut(cells).collect();
        self.operator.apply(false, &x, &mut parts, &mut *workspace);
        Ok(out)
    }

    /// Of all components together.
    pub(super) fn unknowns(&self) -> Result<usize> {
        let (cells, directions) = (self.cells(), self.directions.len());
        memory(
            "field of an operator",
            [cells, directions],
            size_of::<f64>(),
        )?;
        Ok(cells * directions)
    }

    /// The component of a direction.
    pub(super) fn component(&self, direction: Direction) -> Option<usize> {
        self.directions.iter().position(|own| *own == direction)
    }

    /// These components (displacement, then traction) on `size` cells; `None` if one of their directions is missing.
    pub(super) fn part<const N: usize>(
        &self,
        components: [[Component; N]; N],
        size: [usize; 2],
    ) -> Option<Part<N>> {
        let (mut rows, mut columns) = ([0; N], [0; N]);
        for n in 0..N {
            rows[n] = self.component(components[n][0].directions()[0])?;
            columns[n] = self.component(components[0][n].directions()[1])?;
        }
        Some(Part {
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

/// Rows and columns of an operator of a user.
#[derive(Debug, Clone)]
pub(crate) struct Part<const N: usize> {
    given: UserOperator,
    rows: [usize; N],
    columns: [usize; N],
    size: [usize; 2],
}

impl<const N: usize> Part<N> {
    /// Whether both are the same part of the same operator.
    pub(crate) fn is(&self, other: &Self) -> bool {
        let is_of_one = Arc::ptr_eq(&self.given.operator, &other.given.operator);
        is_of_one && (self.rows, self.columns) == (other.rows, other.columns)
    }

    fn product(
        &self,
        is_single: bool,
        x: [&[f64]; N],
        out: [&mut [f64]; N],
        buffers: &mut PartWorkspace,
    ) {
        let PartWorkspace {
            own, zeros, rest, ..
        } = buffers;
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
        let own = own.get_mut().unwrap_or_else(PoisonError::into_inner);
        operator.apply(is_single, &columns[..all], &mut rows[..all], &mut **own);
    }
}

/// Directions that an operator has at most.
const DIRECTIONS: usize = 3;

/// Buffers of products: those of the user, and those of the components that are not asked for.
pub(crate) struct PartWorkspace {
    of: Arc<dyn Erased>,
    /// Never locked: it makes of what can be sent what can be shared.
    own: Mutex<Box<dyn Any + Send>>,
    zeros: Vec<f64>,
    rest: Vec<f64>,
}

impl PartWorkspace {
    fn new(of: &Arc<dyn Erased>, lengths: [usize; 2]) -> Result<Self> {
        let [nothing, rest] = lengths;
        Ok(Self {
            own: Mutex::new(of.try_workspace()?),
            of: Arc::clone(of),
            zeros: zeros(nothing)?,
            rest: zeros(rest)?,
        })
    }
}

shown!(PartWorkspace: own);

/// Buffers hold nothing between products: others are as good.
impl Clone for PartWorkspace {
    fn clone(&self) -> Self {
        or_abort(Self::new(&self.of, [self.zeros.len(), self.rest.len()]))
    }
}

impl<const N: usize> Operator<N> for Part<N> {
    type Workspace = PartWorkspace;

    fn cells(&self) -> usize {
        self.given.cells()
    }

    fn layout(&self) -> Layout {
        Layout::of(self.size)
    }

    fn workspace(&self) -> PartWorkspace {
        or_abort(self.try_workspace())
    }

    fn try_workspace(&self) -> Result<PartWorkspace> {
        let (cells, others) = (self.cells(), self.given.directions.len() - N);
        PartWorkspace::new(
            &self.given.operator,
            [if others > 0 { cells } else { 0 }, others * cells],
        )
    }

    fn apply(&self, x: [&[f64]; N], out: [&mut [f64]; N], workspace: &mut PartWorkspace) {
        self.product(false, x, out, workspace);
    }

    fn apply_f32(&self, x: [&[f64]; N], out: [&mut [f64]; N], workspace: &mut PartWorkspace) {
        self.product(true, x, out, workspace);
    }

    /// That of all directions bounds those of some.
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
