//! The engine of a history: one traction along an axis, or both in the plane.

use std::time::Instant;

use crate::cgm::plane::Disc;
use crate::cgm::{self, Magnitude, Settings};
use crate::error::{Error, Result};
use crate::half_space::HalfSpace;
use crate::history::layout::Layout;
use crate::history::spring::Sprung;
use crate::operator::Operator;
use crate::report::Report;
use crate::stage::{Observer, PlaneStage, Stage, with_time_left};
use crate::tangential::{Axis, component};

/// Set up on the window of the contact, with the tractions of the step under way.
#[derive(Debug)]
#[expect(
    clippy::large_enum_variant,
    reason = "there is one per history, beside megabytes of fields"
)]
pub(super) enum Engine {
    /// The scalar model, perhaps dragged by a spring.
    Along(Axis, Stage<Sprung>),
    /// The plane model.
    InPlane(Box<PlaneStage>),
}

impl Engine {
    pub(super) fn new(bodies: &HalfSpace, axis: Option<Axis>, size: [usize; 2]) -> Result<Self> {
        Ok(match axis {
            Some(axis) => {
                let stage = Stage::with(bodies, component(axis), size, Sprung::rigidly)?;
                Self::Along(axis, stage)
            }
            None => Self::InPlane(Box::new(PlaneStage::new(bodies, size)?)),
        })
    }

    pub(super) fn layout(&self) -> Layout {
        match self {
            Self::Along(axis, stage) => Layout::new(Some(*axis), stage.x.len()),
            Self::InPlane(stage) => Layout::new(None, stage.q.len() / 2),
        }
    }

    pub(super) fn traction(&self) -> &[f64] {
        match self {
            Self::Along(_, stage) => &stage.x,
            Self::InPlane(stage) => &stage.q,
        }
    }

    pub(super) fn traction_mut(&mut self) -> &mut [f64] {
        match self {
            Self::Along(_, stage) => &mut stage.x,
            Self::InPlane(stage) => &mut stage.q,
        }
    }

    pub(super) fn linear_mut(&mut self) -> &mut [f64] {
        match self {
            Self::Along(_, stage) => &mut stage.linear,
            Self::InPlane(stage) => &mut stage.linear,
        }
    }

    /// The displacement of the bodies by the tractions, computed anew.
    pub(super) fn displacement(&self) -> Vec<f64> {
        match self {
            Self::Along(_, stage) => product(&stage.operator, &stage.x),
            Self::InPlane(stage) => product(stage.operator(), &stage.q),
        }
    }

    /// Whether friction holds no more than the traction of a cell.
    pub(super) fn is_at_limit(&self, traction: [f64; 2], limit: f64) -> bool {
        match self {
            Self::Along(axis, _) => traction[axis.index()].abs() >= limit,
            Self::InPlane(_) => Disc(limit).is_at_limit(traction),
        }
    }

    /// Drags body 2 by a spring of this compliance, cell area over stiffness; zero for none.
    pub(super) fn set_compliance(&mut self, compliance: f64) {
        if let Self::Along(_, stage) = self {
            stage.operator.compliance = compliance;
        }
    }

    /// The motion that the forces cause beyond what is prescribed.
    pub(super) fn multiplier(&self) -> [f64; 2] {
        let mut multiplier = [0.0; 2];
        match self {
            Self::Along(axis, stage) => {
                multiplier[axis.index()] = stage.multiplier() - stage.operator.stretch(&stage.x);
            }
            Self::InPlane(stage) => multiplier = stage.multiplier(),
        }
        multiplier
    }

    /// Solves from the present tractions, and writes the displacement they cause.
    pub(super) fn minimise(
        &mut self,
        limits: &[f64],
        totals: [Option<f64>; 2],
        settings: &Settings,
        observer: Observer<'_>,
        displacement: &mut [f64],
        report: &mut Report,
    ) -> Result<()> {
        match self {
            Self::Along(axis, stage) => {
                let (limits, total) = (Magnitude(limits), totals[axis.index()]);
                minimise_sprung(
                    stage,
                    &limits,
                    total,
                    settings,
                    observer,
                    displacement,
                    report,
                )
            }
            Self::InPlane(stage) => {
                let outcome = stage.minimise(limits, totals, settings, observer);
                report.clone_from(stage.report());
                displacement.copy_from_slice(stage.product());
                outcome
            }
        }
    }
}

fn product(operator: &impl Operator, traction: &[f64]) -> Vec<f64> {
    let mut product = vec![0.0; traction.len()];
    operator.apply(traction, &mut product, &mut operator.workspace());
    product
}

/// Solves, and again more closely while errors measured by the displacement of the bodies alone are too
/// large: the engine's measure holds the stretch of a spring too, which may be far more.
fn minimise_sprung(
    stage: &mut Stage<Sprung>,
    limits: &Magnitude<'_>,
    total: Option<f64>,
    settings: &Settings,
    observer: Observer<'_>,
    displacement: &mut [f64],
    report: &mut Report,
) -> Result<()> {
    let start = Instant::now();
    let (mut aim, mut earlier) = (settings.tolerance, [0; 3]);
    loop {
        let left = with_time_left(settings, start).tolerance(aim);
        let outcome = stage.minimise(Magnitude(limits.0), total, &left, observer);
        if !matches!(outcome, Ok(()) | Err(Error::NotConverged(_))) {
            return outcome;
        }
        report.clone_from(stage.report());
        report.iterations += earlier[0];
        report.convolutions += earlier[1];
        report.rough_convolutions += earlier[2];
        report.time = start.elapsed();
        if outcome.is_err() {
            return Err(Error::NotConverged(Box::new(report.clone())));
        }
        let stretch = stage.operator.stretch(&stage.x);
        for (displacement, product) in displacement.iter_mut().zip(stage.product()) {
            *displacement = product - stretch;
        }
        if stage.operator.compliance == 0.0 {
            return Ok(());
        }
        let findings = cgm::examine(
            &stage.x,
            displacement,
            &stage.linear,
            limits,
            None,
            -stretch,
            stage.operator.lower_bound(),
        );
        findings.write_to(report);
        if report.is_within(settings.tolerance) {
            return Ok(());
        }
        aim *= 0.1;
        earlier = [
            report.iterations,
            report.convolutions,
            report.rough_convolutions,
        ];
    }
}
