//! One row of the table: a solve, its ending, and whether this ending is correct.

use std::fmt;
use std::time::Duration;

use stickslip::{Error, Result};
use stickslip::{Report, Status};

use super::Expected;
use super::compliance::Compliance;

/// Result of one solve.
#[derive(Debug, Clone)]
pub struct Row {
    pub scene: String,
    /// Part of the problem, or the model.
    pub half: String,
    /// Ending of the solve, in a word.
    pub ending: String,
    /// Report of the solve, or `None` if the problem was rejected.
    pub report: Option<Report>,
    pub error: Option<Measured>,
    pub time: Duration,
    /// Description of the fault, or `None` without a fault.
    pub fault: Option<String>,
}

/// An error and the reference it was measured against.
#[derive(Debug, Clone, Copy)]
pub struct Measured {
    /// Relative error in the energy norm.
    pub value: f64,
    /// Amount that round-off and the error of the reference may add.
    pub slack: f64,
    pub against: &'static str,
}

impl Row {
    pub(crate) fn new(scene: &str, half: impl Into<String>) -> Self {
        Self {
            scene: scene.to_owned(),
            half: half.into(),
            ending: String::new(),
            report: None,
            error: None,
            time: Duration::ZERO,
            fault: None,
        }
    }

    /// Compares the certified error with the distance from an exact solution.
    pub(crate) fn compare(
        &mut self,
        compliance: &Compliance,
        x: &[f64],
        exact: &[f64],
        against: &'static str,
    ) {
        let difference: Vec<f64> = x.iter().zip(exact).map(|(a, b)| a - b).collect();
        let value = compliance.norm(&difference) / compliance.norm(x);
        let certified = self.report.as_ref().map_or(0.0, Report::energy_error_bound);
        let slack = 1e-12;
        self.blame(value.is_nan() || value > certified + slack, || {
            format!("the error {value:.2e} is beyond the certified {certified:.2e}")
        });
        self.error = Some(Measured {
            value,
            slack,
            against,
        });
    }

    /// Records a fault if the condition holds. The first fault is kept.
    pub(crate) fn blame(&mut self, condition: bool, fault: impl FnOnce() -> String) {
        if condition && self.fault.is_none() {
            self.fault = Some(fault());
        }
    }

    pub fn is_right(&self) -> bool {
        self.fault.is_none()
    }

    /// Records the outcome of a solve. Returns whether there is an iterate to check.
    pub(crate) fn end(&mut self, outcome: &Result<()>, report: &Report, wanted: Expected) -> bool {
        match outcome {
            Ok(()) | Err(Error::NotConverged(_)) => {
                self.ending = report.status.to_string();
                self.report = Some(report.clone());
                self.time = report.time;
                let stalls = wanted == Expected::AnswerOrRoundOff;
                let is_fine = match (report.status, wanted) {
                    (_, Expected::Refused(_)) => false,
                    (Status::Converged, _) => outcome.is_ok(),
                    (Status::Stalled, _) => stalls && report.energy_error_bound() < 1e-2,
                    _ => false,
                };
                self.blame(!is_fine, || format!("{report}, expected {wanted:?}"));
                true
            }
            Err(error) => {
                self.refuse(error, wanted);
                false
            }
        }
    }

    /// Records a rejection.
    pub(crate) fn refuse(&mut self, error: &Error, wanted: Expected) {
        let variant = variant(error);
        self.blame(!is_refusal(variant, wanted), || {
            format!("refused ({error}), expected {wanted:?}")
        });
        self.ending = format!("refused: {variant}");
    }
}

fn is_refusal(variant: &str, wanted: Expected) -> bool {
    matches!(wanted, Expected::Refused(name) if name == variant)
}

/// Returns the name of the error variant, for the variants that scenes expect.
fn variant(error: &Error) -> &'static str {
    match error {
        Error::ApproachBeyondMeanGap { .. } => "ApproachBeyondMeanGap",
        Error::BeyondFrictionCapacity { .. } => "BeyondFrictionCapacity",
        Error::BeyondHardness { .. } => "BeyondHardness",
        Error::EmptyContact => "EmptyContact",
        Error::NotConverged(_) => "NotConverged",
        Error::Sample { .. } => "Sample",
        Error::Tolerance(_) => "Tolerance",
        _ => "another error",
    }
}

/// Header line above the rows.
pub const HEADER: &str = "| scene | half | ending | steps | products, double + single | certified error | error | against | ms | |\n\
     |---|---|---|--:|--:|--:|--:|---|--:|---|";

impl fmt::Display for Row {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let dash = || "-".to_owned();
        let report = self.report.as_ref();
        let steps = report.map_or_else(dash, |report| report.iterations.to_string());
        let products = report.map_or_else(dash, |report| {
            format!(
                "{} + {}",
                report.double_precision_products, report.single_precision_products
            )
        });
        let certified = report.map_or_else(dash, |report| {
            format!("{:.1e}", report.energy_error_bound())
        });
        let error = self
            .error
            .map_or_else(dash, |error| format!("{:.1e}", error.value));
        let against = self.error.map_or("-", |error| error.against);
        let verdict = self.fault.as_deref().unwrap_or("");
        write!(
            formatter,
            "| {} | {} | {} | {steps} | {products} | {certified} | {error} | {against} | {:.1} | {verdict} |",
            self.scene,
            self.half,
            self.ending,
            1e3 * self.time.as_secs_f64(),
        )
    }
}
