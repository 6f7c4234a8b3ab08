//! Interface between the contact models and the engine: a linear operator and the scratch memory of its products.

use std::any::Any;
use std::fmt;

use crate::error::Result;
use crate::parallel::layout::Layout;
use crate::report::EigenvalueBound;

/// Displacement of a half-space cell under a unit traction on this cell, in multiples of the smallest eigenvalue.
pub(crate) const SELF_COMPLIANCE: f64 = 5.0;

/// Lower bound on the eigenvalues of an operator for the vectors that a problem allows.
#[derive(Debug, Clone, Copy)]
pub(crate) struct LowerBound {
    /// Value of the bound, or zero if no bound is available.
    pub(crate) value: f64,
    /// Value for all vectors without springs, which is not above `value`. It is equal to `value` if the compliance of all vectors
    /// is not positive definite.
    pub(crate) of_all: f64,
    pub(crate) known: EigenvalueBound,
    pub(crate) mean: MeanBound,
}

/// Meaning of the bound for the energy of a uniform vector.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum MeanBound {
    /// The operator stores this energy, and springs add to it.
    Operator,
    /// The operator and the springs store this energy together.
    OperatorWithSprings,
    /// The operator maps constants to zero: only springs store energy.
    Springs,
}

/// Linear map from tractions to displacements, `u = C x`, with `N` components per cell. The map is symmetric unless
/// [`Self::is_symmetric`] returns false.
///
/// A vector is passed as `N` slices, one per component, each with an entry per cell. The operator is immutable and
/// shared. A product writes to a [`Scratch`] that the caller owns. A product therefore does not allocate, and several
/// threads can use the same operator. The trait is object-safe: a program may store a `Box<dyn Operator>`.
///
/// ```
/// use stickslip::{Operator, Scratch};
///
/// /// Independent springs.
/// struct Winkler(Vec<f64>);
///
/// impl Operator for Winkler {
///     fn cells(&self) -> usize { self.0.len() }
///     fn apply(&self, [x]: [&[f64]; 1], [out]: [&mut [f64]; 1], _: &mut Scratch) {
///         for ((out, x), c) in out.iter_mut().zip(x).zip(&self.0) {
///             *out = c * x;
///         }
///     }
///     fn lower_bound(&self) -> f64 { self.0.iter().copied().fold(f64::INFINITY, f64::min) }
/// }
///
/// let bed: Box<dyn Operator> = Box::new(Winkler(vec![1.0, 2.0]));
/// let mut u = [0.0; 2];
/// bed.apply([&[3.0, 4.0]], [&mut u], &mut bed.scratch()?);
/// assert_eq!(u, [3.0, 8.0]);
/// # Ok::<(), stickslip::Error>(())
/// ```
pub trait Operator<const N: usize = 1>: Sync {
    /// Returns the number of cells, which is the number of unknowns of each component.
    fn cells(&self) -> usize;

    /// Returns the layout of the cells, which determines the order of sums over them (default: a flat sequence of local
    /// cells).
    fn layout(&self) -> Layout {
        Layout::flat(self.cells())
    }

    /// Creates the memory that a product writes to in addition to its result (default: none).
    ///
    /// # Errors
    /// - [`Error::Memory`](crate::Error::Memory) if memory runs out.
    fn scratch(&self) -> Result<Scratch> {
        Ok(Scratch::none())
    }

    /// Writes `C x` to `out`. Every slice has [`Operator::cells`] entries.
    ///
    /// # Panics
    /// The operators of this crate panic if a slice has a different length, or if the scratch belongs to an operator of
    /// a different size or type.
    fn apply(&self, x: [&[f64]; N], out: [&mut [f64]; N], scratch: &mut Scratch);

    /// Writes `C x` to `out` in single precision, with an error of at most about 1e-6 of the largest result. Single
    /// precision is accurate enough for an iteration, but not for a convergence test. The default is
    /// [`Operator::apply`].
    fn apply_f32(&self, x: [&[f64]; N], out: [&mut [f64]; N], scratch: &mut Scratch) {
        self.apply(x, out, scratch);
    }

    /// Returns a lower bound on the smallest eigenvalue, `x' C x >= bound * x' x`. The bound is valid for all `x`. If
    /// the operator maps constants to zero, as on a periodic grid, the bound is valid for all `x` in which each
    /// component sums to zero.
    ///
    /// The bound converts a residual to a certified error. The error is relative to the minimum or, in the second case,
    /// to the minimum under the totals of the iterate. The default, zero, states only that the operator is positive
    /// semi-definite. The certificate is then the duality gap. A bound that is negative, infinite or NaN counts as zero.
    fn lower_bound(&self) -> f64 {
        0.0
    }

    /// Returns the origin of [`Self::lower_bound`]. The default is [stated](EigenvalueBound::Stated) for a positive
    /// bound. An operator that returns the bound of a different operator should also return the origin of that bound.
    fn eigenvalue_bound(&self) -> EigenvalueBound {
        if usable_bound(self.lower_bound()) > 0.0 {
            EigenvalueBound::Stated
        } else {
            EigenvalueBound::Unknown
        }
    }

    /// Returns the approximate displacement of a cell under a unit traction on this cell. Preconditioners use it as the
    /// scale for the local compliances of cells. The default is five times the [lower bound](Self::lower_bound), as for
    /// elastic half-spaces.
    fn self_compliance(&self) -> f64 {
        SELF_COMPLIANCE * usable_bound(self.lower_bound())
    }

    /// Returns whether `x' C y = y' C x` (default: true). The engine also accepts operators that are not symmetric if
    /// they satisfy `x' C x > 0`. It then uses GMRES instead of conjugate gradients, with the same certificate. The
    /// solution is not a minimum in this case, but it satisfies the same conditions (a variational inequality).
    fn is_symmetric(&self) -> bool {
        true
    }
}

/// Defines all methods of [`Operator`] by the same methods of another operator. The first argument is `self`.
macro_rules! operator_methods {
    ($self:ident, $operator:expr) => {
        fn cells(&$self) -> usize {
            $operator.cells()
        }

        fn layout(&$self) -> Layout {
            $operator.layout()
        }

        fn scratch(&$self) -> Result<Scratch> {
            $operator.scratch()
        }

        fn apply(&$self, x: [&[f64]; N], out: [&mut [f64]; N], scratch: &mut Scratch) {
            $operator.apply(x, out, scratch);
        }

        fn apply_f32(&$self, x: [&[f64]; N], out: [&mut [f64]; N], scratch: &mut Scratch) {
            $operator.apply_f32(x, out, scratch);
        }

        fn lower_bound(&$self) -> f64 {
            $operator.lower_bound()
        }

        fn eigenvalue_bound(&$self) -> EigenvalueBound {
            $operator.eigenvalue_bound()
        }

        fn self_compliance(&$self) -> f64 {
            $operator.self_compliance()
        }

        fn is_symmetric(&$self) -> bool {
            $operator.is_symmetric()
        }
    };
}

pub(crate) use operator_methods;

/// Implements [`Operator`] for a pointer to an operator.
macro_rules! operator_behind {
    ($pointer:ty, $($bound:tt)+) => {
        impl<T: $($bound)+ + ?Sized, const N: usize> Operator<N> for $pointer {
            operator_methods!(self, (**self));
        }
    };
}

operator_behind!(&T, Operator<N>);
operator_behind!(Box<T>, Operator<N>);
operator_behind!(std::sync::Arc<T>, Operator<N> + Send);

/// The identity, which has no effect as a preconditioner.
#[derive(Debug, Clone, Copy)]
pub struct Identity {
    cells: usize,
}

impl Identity {
    /// Creates the identity on `cells` cells, for any number of components.
    #[must_use]
    pub fn new(cells: usize) -> Self {
        Self { cells }
    }
}

impl<const N: usize> Operator<N> for Identity {
    fn cells(&self) -> usize {
        self.cells
    }

    fn apply(&self, x: [&[f64]; N], out: [&mut [f64]; N], _: &mut Scratch) {
        for (out, x) in out.into_iter().zip(x) {
            out.copy_from_slice(x);
        }
    }

    fn lower_bound(&self) -> f64 {
        1.0
    }

    fn eigenvalue_bound(&self) -> EigenvalueBound {
        EigenvalueBound::Proven
    }
}

/// Returns a bound on the smallest eigenvalue, or zero for a bound without information: NaN, negative or infinite.
pub(crate) fn usable_bound(bound: f64) -> f64 {
    if bound.is_finite() {
        bound.max(0.0)
    } else {
        0.0
    }
}

/// Memory that a product of an [`Operator`] writes to in addition to its result.
///
/// [`Operator::scratch`] creates the scratch, and the caller owns it. An operator stores buffers of any type in its
/// scratch and accesses them in [`Operator::apply`].
///
/// ```
/// use stickslip::{Operator, Result, Scratch};
///
/// /// A second difference with both ends fixed: `u = D (D x)`.
/// struct Beam(usize);
///
/// fn difference(x: &[f64], out: &mut [f64]) {
///     let at = |i: usize| x.get(i).copied().unwrap_or(0.0);
///     for (i, out) in out.iter_mut().enumerate() {
///         *out = 2.0 * at(i) - at(i.wrapping_sub(1)) - at(i + 1);
///     }
/// }
///
/// impl Operator for Beam {
///     fn cells(&self) -> usize { self.0 }
///     fn scratch(&self) -> Result<Scratch> { Ok(Scratch::new(vec![0.0; self.0])) }
///     fn apply(&self, [x]: [&[f64]; 1], [out]: [&mut [f64]; 1], scratch: &mut Scratch) {
///         let slope: &mut Vec<f64> = scratch.get_mut().expect("the scratch of a beam");
///         difference(x, slope);
///         difference(slope, out);
///     }
/// }
///
/// let (beam, mut u) = (Beam(3), [0.0; 3]);
/// beam.apply([&[0.0, 1.0, 0.0]], [&mut u], &mut beam.scratch()?);
/// assert_eq!(u, [-4.0, 6.0, -4.0]);
/// # Ok::<(), stickslip::Error>(())
/// ```
#[derive(Clone, Default)]
pub struct Scratch(Option<Box<dyn AnyBuffers>>);

impl Scratch {
    /// Returns a `Scratch` without buffers.
    #[must_use]
    pub fn none() -> Self {
        Self(None)
    }

    /// Returns a scratch with these buffers.
    #[must_use]
    pub fn new<T: Clone + Send + Sync + 'static>(buffers: T) -> Self {
        Self(Some(Box::new(buffers)))
    }

    /// Returns the buffers, or `None` if they have a different type.
    #[must_use]
    pub fn get_mut<T: 'static>(&mut self) -> Option<&mut T> {
        // Without the explicit type, the blanket implementation would apply to the box.
        let buffers: &mut dyn AnyBuffers = &mut **self.0.as_mut()?;
        buffers.as_any_mut().downcast_mut()
    }

    /// Returns the buffers of an operator of this crate.
    ///
    /// # Panics
    /// Panics if the buffers belong to an operator of a different type.
    pub(crate) fn buffers<T: 'static>(&mut self) -> &mut T {
        // The crate passes each scratch to the operator that created it, and `Operator::apply` requires the same of
        // other callers.
        let buffers = self.get_mut();
        buffers.expect("the scratch must have been created by this operator")
    }
}

impl fmt::Debug for Scratch {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.debug_struct("Scratch").finish_non_exhaustive()
    }
}

/// Buffers of any type that can be cloned.
trait AnyBuffers: Any + Send + Sync {
    fn boxed_clone(&self) -> Box<dyn AnyBuffers>;
    fn as_any_mut(&mut self) -> &mut dyn Any;
}

impl<T: Any + Clone + Send + Sync> AnyBuffers for T {
    fn boxed_clone(&self) -> Box<dyn AnyBuffers> {
        Box::new(self.clone())
    }

    fn as_any_mut(&mut self) -> &mut dyn Any {
        self
    }
}

impl Clone for Box<dyn AnyBuffers> {
    fn clone(&self) -> Self {
        (**self).boxed_clone()
    }
}
