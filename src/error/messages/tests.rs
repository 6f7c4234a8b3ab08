//! Remedies that depend on the content of an error.

use crate::error::Error;
use crate::report::{Report, Status};

#[test]
fn unconverged_solve_has_remedy_for_its_status() {
    let remedy = |status, products, residual| {
        let report = Report {
            status,
            double_precision_products: products,
            residual,
            ..Report::unsolved()
        };
        let text = Error::NotConverged(Box::new(report.clone())).to_string();
        let rest = text.strip_prefix(&format!("the calculation has not converged: {report}"));
        rest.unwrap().to_owned()
    };
    let round_off =
        ": the tolerance is below round-off, so set it above these errors (1e-12 or more)";
    assert_eq!(remedy(Status::Stalled, 9, 1e-15), round_off);
    assert_eq!(remedy(Status::Stalled, 9, 1e-3), "");
    assert_eq!(remedy(Status::Stalled, 9, f64::NAN), "");
    assert_eq!(
        remedy(Status::IterationLimit, 9, 1e-3),
        ": raise the iteration limit"
    );
    assert_eq!(remedy(Status::IterationLimit, 0, 1e-3), "");
    assert_eq!(remedy(Status::TimeLimit, 9, 1e-3), ": raise the time limit");
    assert_eq!(remedy(Status::Unsolved, 0, 1e-3), ": solve first");
    assert_eq!(remedy(Status::Cancelled, 9, 1e-3), "");
}
