//! The seam between physics and engine: a linear operator that can be applied.

/// A symmetric linear map from tractions to displacements, `u = C x`.
///
/// The operator is immutable and shared; what a product needs to write lives in a workspace that
/// the caller owns, so that one operator serves many threads and a product allocates nothing.
///
/// ```
/// use stickslip::Operator;
///
/// /// Independent springs.
/// struct Winkler(Vec<f64>);
///
/// impl Operator for Winkler {
///     type Workspace = ();
///     fn len(&self) -> usize { self.0.len() }
///     fn workspace(&self) {}
///     fn apply(&self, x: &[f64], out: &mut [f64], (): &mut ()) {
///         for ((out, x), c) in out.iter_mut().zip(x).zip(&self.0) {
///             *out = c * x;
///         }
///     }
///     fn lower_bound(&self) -> f64 { self.0.iter().copied().fold(f64::INFINITY, f64::min) }
/// }
///
/// let bed = Winkler(vec![1.0, 2.0]);
/// let mut u = [0.0; 2];
/// bed.apply(&[3.0, 4.0], &mut u, &mut ());
/// assert_eq!(u, [3.0, 8.0]);
/// ```
#[expect(
    clippy::len_without_is_empty,
    reason = "an operator on nothing is not constructed, and nobody would ask"
)]
pub trait Operator: Sync {
    /// What one product writes to besides its result.
    type Workspace: Send;

    /// Number of unknowns.
    fn len(&self) -> usize;

    /// A workspace for [`Operator::apply`].
    fn workspace(&self) -> Self::Workspace;

    /// Writes `C x` to `out`. Both slices have [`Operator::len`] entries.
    ///
    /// # Panics
    /// The operators of this crate panic on slices of another length and on the workspace of an
    /// operator of another size.
    fn apply(&self, x: &[f64], out: &mut [f64], workspace: &mut Self::Workspace);

    /// Writes about `C x` to `out`, with an error of at most some 1e-6 of the largest result: what
    /// an iteration needs between exact products. The default is [`Operator::apply`].
    fn apply_roughly(&self, x: &[f64], out: &mut [f64], workspace: &mut Self::Workspace) {
        self.apply(x, out, workspace);
    }

    /// A known lower bound of the smallest eigenvalue, `x' C x >= bound * x' x`: for all `x`, or for all
    /// `x` of sum zero if the operator maps constants to zero, as that of a periodic grid does.
    ///
    /// It turns a residual into a certified error: against the minimum or, in the second case, against
    /// the minimum of the total the iterate has. The default, zero, says that nothing is
    /// known beyond positive semi-definiteness, and leaves only the duality gap; so does a negative
    /// number or NaN.
    fn lower_bound(&self) -> f64 {
        0.0
    }
}

/// A pointer to an operator is one.
macro_rules! operator_behind {
    ($pointer:ty, $($bound:tt)+) => {
        impl<T: $($bound)+> Operator for $pointer {
            type Workspace = T::Workspace;

            fn len(&self) -> usize {
                (**self).len()
            }

            fn workspace(&self) -> T::Workspace {
                (**self).workspace()
            }

            fn apply(&self, x: &[f64], out: &mut [f64], workspace: &mut T::Workspace) {
                (**self).apply(x, out, workspace);
            }

            fn apply_roughly(&self, x: &[f64], out: &mut [f64], workspace: &mut T::Workspace) {
                (**self).apply_roughly(x, out, workspace);
            }

            fn lower_bound(&self) -> f64 {
                (**self).lower_bound()
            }
        }
    };
}

operator_behind!(&T, Operator);
operator_behind!(std::sync::Arc<T>, Operator + Send);

/// The identity: as a preconditioner it changes nothing.
#[derive(Debug, Clone, Copy)]
pub struct Identity {
    len: usize,
}

impl Identity {
    /// The identity on `len` unknowns.
    #[must_use]
    pub fn new(len: usize) -> Self {
        Self { len }
    }
}

impl Operator for Identity {
    type Workspace = ();

    fn len(&self) -> usize {
        self.len
    }

    fn workspace(&self) {}

    fn apply(&self, x: &[f64], out: &mut [f64], (): &mut ()) {
        out.copy_from_slice(x);
    }

    fn lower_bound(&self) -> f64 {
        1.0
    }
}
