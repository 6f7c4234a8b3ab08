//! User settings of an iteration.

use std::time::Duration;

use crate::error::{Error, Result};

/// Iteration method that computes the constrained minimum.
///
/// If the active sets start to cycle, projected-gradient steps follow. If the sets still cycle, a sequence of better-conditioned
/// problems completes the solve.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub enum Method {
    /// Active sets in the outer loop and preconditioned conjugate gradients without clipping in the inner loop. The residual is
    /// recomputed at every outer step. The product is in double precision once the residual is small. This method is the default.
    /// The pressure of a sphere or of a rough contact on up to a tenth of the area needs 2 to 8 times fewer products than with
    /// [`Self::PolonskyKeer`], on 64 to 512 cells along a side. For a rough contact on 40 % of 256 x 256 cells the factor is 11.
    #[default]
    ActiveSet,
    /// A single loop that clips the unknowns to their bounds at every step. Its sources are Polonsky & Keer, Wear 231 (1999) 206,
    /// <https://doi.org/10.1016/S0043-1648(99)00113-1>, and eqs 17-26 of Wang et al. (2021) with corrected signs. The method
    /// needs two products per step unless no entry was clipped. It requires a symmetric operator and one unknown per cell. Other
    /// problems return [`Error::Method`].
    PolonskyKeer,
}

/// Method, tolerance and limits of an iteration.
///
/// ```
/// use stickslip::cgm::{Method, Settings};
/// let settings = Settings::default().tolerance(1e-6).method(Method::PolonskyKeer);
/// assert_eq!(settings.max_iterations, 10_000);
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(default, deny_unknown_fields)
)]
#[non_exhaustive]
pub struct Settings {
    /// Iteration method (default [`Method::ActiveSet`]).
    pub method: Method,
    /// Accepted error (default 1e-8). It bounds the certified error in the energy norm, relative to the norm of the solution. It
    /// also bounds the largest complementarity residual, relative to the largest displacement. For an operator without a
    /// [`lower_bound`](crate::Operator::lower_bound) it bounds only the residual. The relative sum of all traction errors exceeds
    /// this error by a factor of at most three on square cells. On cells with an aspect ratio of 1 : 315 the factor is at most
    /// eight. The error of single cells at the edge of a smooth contact may be ten to a hundred times larger. A tolerance of
    /// 0.1 therefore permits errors of forces, areas and stick ratios of tens of per cent, without a warning.
    pub tolerance: f64,
    /// Maximum number of conjugate-gradient steps (default 10 000).
    pub max_iterations: usize,
    /// Maximum wall time (default: no limit).
    pub time_limit: Option<Duration>,
}

impl Default for Settings {
    fn default() -> Self {
        Self {
            method: Method::default(),
            tolerance: 1e-8,
            max_iterations: 10_000,
            time_limit: None,
        }
    }
}

impl Settings {
    /// Sets the method.
    #[must_use]
    pub fn method(mut self, method: Method) -> Self {
        self.method = method;
        self
    }

    /// Sets the tolerance, strictly between 0 and 1.
    #[must_use]
    pub fn tolerance(mut self, tolerance: f64) -> Self {
        self.tolerance = tolerance;
        self
    }

    /// Sets the maximum number of conjugate-gradient steps (at least 1).
    #[must_use]
    pub fn max_iterations(mut self, max_iterations: usize) -> Self {
        self.max_iterations = max_iterations;
        self
    }

    /// Sets the maximum wall time.
    #[must_use]
    pub fn time_limit(mut self, time_limit: Duration) -> Self {
        self.time_limit = Some(time_limit);
        self
    }

    /// Returns the settings that all ranks must have in common. The time limit is excluded, because the clock of the first rank
    /// decides for all ranks.
    pub(crate) fn common(&self) -> Self {
        Self {
            time_limit: None,
            ..*self
        }
    }

    /// Checks that the settings are valid.
    ///
    /// # Errors
    /// - [`Error::Tolerance`] if the tolerance is outside `(0, 1)`.
    /// - [`Error::IterationLimit`] if the maximum number of steps is zero.
    pub fn check(&self) -> Result<()> {
        if !(self.tolerance > 0.0 && self.tolerance < 1.0) {
            return Err(Error::Tolerance(self.tolerance));
        }
        if self.max_iterations == 0 {
            return Err(Error::IterationLimit);
        }
        Ok(())
    }
}

/// Setters of the solver settings, which are identical for each builder. The builder stores the settings in `$($path).+`.
macro_rules! settings_methods {
    ($($path:ident).+) => {
        /// Sets all solver settings, for example the settings of a different solver or of a file.
        pub fn settings(mut self, settings: crate::cgm::Settings) -> Self {
            self.$($path).+ = settings;
            self
        }

        /// Sets the accepted error (default 1e-8). [`Settings::tolerance`](crate::cgm::Settings::tolerance) states the errors
        /// that it bounds.
        pub fn tolerance(mut self, tolerance: f64) -> Self {
            self.$($path).+.tolerance = tolerance;
            self
        }

        /// Sets the iteration method (default [`Method::ActiveSet`](crate::cgm::Method::ActiveSet)).
        pub fn method(mut self, method: crate::cgm::Method) -> Self {
            self.$($path).+.method = method;
            self
        }

        /// Sets the maximum number of conjugate-gradient steps (default 10 000).
        pub fn max_iterations(mut self, max_iterations: usize) -> Self {
            self.$($path).+.max_iterations = max_iterations;
            self
        }

        /// Sets the maximum wall time per solve (default: no limit). A step of a history has two solves, pressure and traction.
        pub fn time_limit(mut self, time_limit: std::time::Duration) -> Self {
            self.$($path).+.time_limit = Some(time_limit);
            self
        }
    };
}

pub(crate) use settings_methods;
