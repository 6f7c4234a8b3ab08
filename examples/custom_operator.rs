//! Use of the solver with a user-defined matrix: a rounded stamp on nine coupled springs.

#![allow(clippy::print_stdout, reason = "an example shows its numbers")]

use std::error::Error;
use std::ops::ControlFlow;

use stickslip::cgm::{self, Method, NonNegative, Problem, Settings};
use stickslip::{Operator, Scratch, Status};

const SPRINGS: usize = 9;

/// Row of springs. Under a unit force on one spring, this spring deflects by `own` and each adjacent spring deflects by
/// `neighbour`. The matrix is therefore tridiagonal.
#[derive(Debug, Clone, Copy)]
struct SpringRow {
    own: f64,
    neighbour: f64,
}

impl Operator for SpringRow {
    fn cells(&self) -> usize {
        SPRINGS
    }

    fn apply(&self, [force]: [&[f64]; 1], [yielding]: [&mut [f64]; 1], _: &mut Scratch) {
        for i in 0..SPRINGS {
            let left = if i > 0 { force[i - 1] } else { 0.0 };
            let right = force.get(i + 1).copied().unwrap_or(0.0);
            yielding[i] = self.own * force[i] + self.neighbour * (left + right);
        }
    }

    /// Returns the lower bound on the eigenvalues by Gershgorin's theorem. Every eigenvalue differs from one of the diagonal
    /// entries by at most the sum of the magnitudes of the other entries in its row. The solver uses this bound to certify the
    /// error from the residual.
    fn lower_bound(&self) -> f64 {
        self.own - 2.0 * self.neighbour.abs()
    }
}

fn main() -> Result<(), Box<dyn Error>> {
    let springs = SpringRow {
        own: 1.0,
        neighbour: 0.3,
    };
    // The initial gap below the stamp is a parabola around the middle spring.
    let gap: Vec<f64> = (0..SPRINGS)
        .map(|i| 0.25 * (i as f64 - 4.0).powi(2))
        .collect();
    let load = 5.0;
    let problem = Problem::new(springs, [&gap], NonNegative).total(load);

    for method in [Method::ActiveSet, Method::PolonskyKeer] {
        let settings = Settings::default().tolerance(1e-12).method(method);
        let mut force = [load / SPRINGS as f64; SPRINGS];
        let minimum = cgm::minimise(&problem, &settings, [&mut force])?;
        println!("{method:?}: {}", minimum.report);
        println!("  approach of the stamp {:.9}", minimum.multiplier[0]);
        println!("  spring   force        gap under load");

        // Check the contact conditions: no tension, no overlap, and a closed gap wherever the force is positive.
        let mut yielding = [0.0; SPRINGS];
        springs.apply([&force], [&mut yielding], &mut Scratch::none());
        for i in 0..SPRINGS {
            let open = yielding[i] + gap[i] - minimum.multiplier[0];
            println!("  {i:>6}   {:.9}  {open:>12.2e}", force[i]);
            assert!(force[i] >= 0.0 && open > -1e-11 && (force[i] * open).abs() < 1e-11);
        }
        assert!((force.iter().sum::<f64>() - load).abs() < 1e-12);
    }

    // The solver calls the observer at the start and at every step. This observer stops the solve at the third step.
    let mut force = [load / SPRINGS as f64; SPRINGS];
    let mut workspace = problem.workspace()?;
    let settings = Settings::default().method(Method::PolonskyKeer);
    let mut watch = |step: &stickslip::Iteration| {
        println!(
            "step {}: residual {:.1e}, {} springs with force",
            step.iteration, step.residual, step.free
        );
        if step.iteration < 3 {
            ControlFlow::Continue(())
        } else {
            ControlFlow::Break(())
        }
    };
    let outcome = cgm::minimise_with(
        &problem,
        &settings,
        [&mut force],
        &mut workspace,
        &mut watch,
    );
    match outcome {
        Err(stickslip::Error::NotConverged(report)) if report.status == Status::Cancelled => {
            println!("{report}");
            println!("forces at this step, whose sum is the load: {force:.3?}");
        }
        other => other?,
    }
    Ok(())
}
