//! Memory that a product writes to besides its result.

use std::any::Any;
use std::fmt;

/// Memory that a product of an [`Operator`](crate::Operator) writes to besides its result.
///
/// [`Operator::scratch`](crate::Operator::scratch) creates it, and the caller owns it. An operator stores buffers of
/// any type in it and gets them back in [`apply`](crate::Operator::apply).
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
pub struct Scratch(Option<Box<dyn Buffers>>);

impl Scratch {
    /// Returns a scratch without buffers.
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
        let buffers: &mut dyn Buffers = &mut **self.0.as_mut()?;
        buffers.as_any_mut().downcast_mut()
    }

    /// Returns the buffers of an operator of this crate.
    ///
    /// # Panics
    /// If they are those of a different kind of operator.
    pub(crate) fn expect<T: 'static>(&mut self) -> &mut T {
        self.get_mut()
            .expect("the scratch must be that of the operator")
    }
}

impl fmt::Debug for Scratch {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.debug_struct("Scratch").finish_non_exhaustive()
    }
}

/// Buffers of any type that can be cloned.
trait Buffers: Any + Send + Sync {
    fn boxed_clone(&self) -> Box<dyn Buffers>;
    fn as_any_mut(&mut self) -> &mut dyn Any;
}

impl<T: Any + Clone + Send + Sync> Buffers for T {
    fn boxed_clone(&self) -> Box<dyn Buffers> {
        Box::new(self.clone())
    }

    fn as_any_mut(&mut self) -> &mut dyn Any {
        self
    }
}

impl Clone for Box<dyn Buffers> {
    fn clone(&self) -> Self {
        (**self).boxed_clone()
    }
}
