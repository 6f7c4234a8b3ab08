//! What a user may choose about an iteration.

use std::time::Duration;

use crate::error::{Error, Result};

/// The iteration that finds the constrained minimum.
///
/// Should the sets of either ever cycle, projected gradients lead past that place, or a sequence of better conditioned
/// problems.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub enum Method {
    /// Active sets outside, preconditioned conjugate gradients without clipping inside, a fresh
    /// residual at every outer step, exact once it is small. The default: 2 to 5 times fewer products.
    #[default]
    ActiveSet,
    /// For symmetric operators and one unknown a cell: other problems refuse it with
    /// [`Error::Method`]. One loop that clips at every step: Polonsky & Keer, Wear 231 (1999) 206,
    /// <https://doi.org/10.1016/S0043-1648(99)00113-1>, and eqs 17-26 of Wang et al. (2021) with
    /// their signs mended. Two products a step unless nothing was clipped.
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
    /// Which iteration (default [`Method::ActiveSet`]).
    pub method: Method,
    /// The error accepted (default 1e-8): bounds the certified error in the energy norm, relative
    /// to the norm of the answer, and the largest complementarity residual, relative to the largest
    /// displacement. For an operator without a [`lower_bound`](crate::Operator::lower_bound) the
    /// residual alone. The sum of all traction errors is as small within a factor of three on square cells, of eight on
    /// cells of 1 : 315; single cells at the edge of a smooth contact may be off by ten to a hundred times more.
    pub tolerance: f64,
    /// Conjugate-gradient steps allowed (default 10 000).
    pub max_iterations: usize,
    /// Wall time allowed (default: any).
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
    /// With another method.
    #[must_use]
    pub fn method(mut self, method: Method) -> Self {
        self.method = method;
        self
    }

    /// With another tolerance, strictly between 0 and 1.
    #[must_use]
    pub fn tolerance(mut self, tolerance: f64) -> Self {
        self.tolerance = tolerance;
        self
    }

    /// With another limit of conjugate-gradient steps, at least 1.
    #[must_use]
    pub fn max_iterations(mut self, max_iterations: usize) -> Self {
        self.max_iterations = max_iterations;
        self
    }

    /// With a limit of wall time.
    #[must_use]
    pub fn time_limit(mut self, time_limit: Duration) -> Self {
        self.time_limit = Some(time_limit);
        self
    }

    /// Those that ranks have in common; the clock of the first one decides for all.
    pub(crate) fn common(&self) -> Self {
        Self {
            time_limit: None,
            ..*self
        }
    }

    /// `Ok` if the settings make sense.
    ///
    /// # Errors
    /// [`Error::Tolerance`] outside `(0, 1)`, [`Error::IterationLimit`] at zero.
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

/// The settings a problem's builder offers, word for word the same on each; the builder keeps them in a
/// field `settings`.
macro_rules! settings_methods {
    () => {
        /// All of the following at once, as another solver or a file has them.
        pub fn settings(mut self, settings: crate::cgm::Settings) -> Self {
            self.settings = settings;
            self
        }

        /// Error accepted: certified in the energy norm, and as a residual relative to the largest
        /// displacement (default 1e-8; see [`Settings::tolerance`](crate::cgm::Settings::tolerance)).
        pub fn tolerance(mut self, tolerance: f64) -> Self {
            self.settings.tolerance = tolerance;
            self
        }

        /// The iteration (default [`Method::ActiveSet`](crate::cgm::Method::ActiveSet)).
        pub fn method(mut self, method: crate::cgm::Method) -> Self {
            self.settings.method = method;
            self
        }

        /// Conjugate-gradient steps allowed (default 10 000).
        pub fn max_iterations(mut self, max_iterations: usize) -> Self {
            self.settings.max_iterations = max_iterations;
            self
        }

        /// Wall time allowed per solve (default: any). A step of a history has two, pressure and traction.
        pub fn time_limit(mut self, time_limit: std::time::Duration) -> Self {
            self.settings.time_limit = Some(time_limit);
            self
        }
    };
}

/// Reading and changing the settings of a solver, which keeps them in `$($path).+`, accepts those that pass `$check` and
/// solves on the bodies `$($bodies).+`.
macro_rules! solver_settings {
    ($($path:ident).+, $($bodies:ident).+, $check:expr) => {
        /// The settings of the next solve.
        #[must_use]
        pub fn settings(&self) -> &crate::cgm::Settings {
            &self.$($path).+
        }

        /// Changes tolerance, method and limits of the next solve, which starts from the last answer all the same.
        ///
        /// # Errors
        /// As [`Settings::check`](crate::cgm::Settings::check), and [`Error::Method`](crate::Error::Method) for a
        /// method that the model does not have; [`Error::Ranks`](crate::Error::Ranks); the settings are then as they were.
        pub fn set_settings(&mut self, settings: crate::cgm::Settings) -> Result<()> {
            let check: fn(&Self, &crate::cgm::Settings) -> Result<()> = $check;
            let checked = settings.check().and_then(|()| check(self, &settings));
            self.$($bodies).+.collective_result_checked(checked, &[("settings", &settings.common())])?;
            self.$($path).+ = settings;
            Ok(())
        }
    };
}

pub(crate) use settings_methods;
pub(crate) use solver_settings;
