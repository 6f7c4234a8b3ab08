//! The engine of a history: one traction along an axis, or both in the plane.

use std::sync::Arc;

use crate::cgm::plane::{self, Disc, both, norm};
use crate::cgm::{self, Certificate, Magnitude, Settings};
use crate::clock::Instant;
use crate::error::{Error, Result};
use crate::fft::Convolution;
use crate::half_space::HalfSpace;
use crate::history::layout::Layout;
use crate::history::spring::Sprung;
use crate::operator::Operator;
use crate::report::Report;
use crate::stage::{Observer, PlaneStage, Stage, may_go_on, with_counts_of, with_limits_left};
use crate::tangential::{Axis, direction};

/// Set up on the window of the contact, with the tractions of the step under way.
#[derive(Debug, Clone)]
#[expect(
    clippy::large_enum_variant,
    reason = "there is one per history, beside megabytes of fields"
)]
pub(super) enum Engine {
    /// The scalar model.
    Along(Axis, Stage<Sprung<Arc<Convolution>, 1>>),
    /// The plane model.
    InPlane(Box<PlaneStage<Sprung<Arc<Convolution<2>>, 2>>>),
}

impl Engine {
    pub(super) fn new(bodies: &HalfSpace, axis: Option<Axis>, size: [usize; 2]) -> Result<Self> {
        Ok(match axis {
            Some(axis) => {
                let stage = Stage::with(bodies, direction(axis), size, Sprung::rigidly)?;
                Self::Along(axis, stage)
            }
            None => Self::InPlane(Box::new(PlaneStage::with(bodies, size, Sprung::rigidly)?)),
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
            Self::Along(_, stage) => product(&stage.operator.bodies, [&stage.x]),
            Self::InPlane(stage) => product(&stage.operator.bodies, both(&stage.q)),
        }
    }

    /// Whether friction holds no more than the traction of a cell.
    pub(super) fn is_at_limit(&self, traction: [f64; 2], limit: f64) -> bool {
        match self {
            Self::Along(axis, _) => traction[axis.index()].abs() >= limit,
            Self::InPlane(_) => Disc(limit).is_at_limit(traction),
        }
    }

    /// Drags body 2 by springs of these compliances along the axes, cell area over stiffness; zero for none.
    pub(super) fn set_compliance(&mut self, compliance: [f64; 2]) {
        match self {
            Self::Along(axis, stage) => stage.operator.compliance = [compliance[axis.index()]],
            Self::InPlane(stage) => stage.operator.compliance = compliance,
        }
    }

    /// What the springs stretch under the tractions.
    fn stretch(&self) -> [f64; 2] {
        match self {
            Self::Along(axis, stage) => {
                let [along] = stage.operator.stretch([&stage.x]);
                component_of(*axis, along)
            }
            Self::InPlane(stage) => stage.operator.stretch(both(&stage.q)),
        }
    }

    /// The motion that forces and springs cause beyond what is prescribed.
    pub(super) fn multiplier(&self) -> [f64; 2] {
        let stretch = self.stretch();
        let multiplier = match self {
            Self::Along(axis, stage) => component_of(*axis, stage.multiplier()),
            Self::InPlane(stage) => stage.multiplier(),
        };
        [0, 1].map(|axis| multiplier[axis] - stretch[axis])
    }

    /// Solves from the present tractions, and writes the displacement of the bodies they cause: again and more
    /// closely while errors measured by that alone are too large, as the engine's measure holds the stretch of
    /// springs too, which may be far more.
    pub(super) fn minimise(
        &mut self,
        limits: &[f64],
        totals: [Option<f64>; 2],
        settings: &Settings,
        observer: Observer<'_>,
        displacement: &mut [f64],
        report: &mut Report,
    ) -> Result<()> {
        let start = Instant::now();
        let mut aim = settings.tolerance;
        report.clone_from(&Report::unsolved());
        loop {
            let left = with_limits_left(settings, start, report).tolerance(aim);
            let outcome =
                self.minimise_once(limits, totals, &left, &mut with_counts_of(report, observer));
            if !matches!(outcome, Ok(()) | Err(Error::NotConverged(_))) {
                return outcome;
            }
            report.go_on(self.report());
            report.time = start.elapsed();
            if outcome.is_err() {
                return Err(Error::NotConverged(Box::new(report.clone())));
            }
            let stretch = self.stretch();
            displacement.copy_from_slice(self.product());
            if stretch.iter().all(|stretch| *stretch == 0.0) {
                // Then the two measures are the same.
                return Ok(());
            }
            for (axis, part) in self.layout().parts_mut(displacement) {
                for value in part {
                    *value -= stretch[axis.index()];
                }
            }
            let findings = self.examine(displacement, limits, totals);
            findings.write_to(report);
            // A mean traction moves nothing on a grid that repeats: of its force the springs alone tell.
            report.residual = findings.residual_over(self.reach(displacement, limits));
            if report.is_within(settings.tolerance) {
                return Ok(());
            }
            may_go_on(settings, report)?;
            aim *= 0.1;
        }
    }

    /// The largest displacement of the bodies where they can carry traction, or what the stiffest spring would stretch
    /// if all tractions pulled one way, if that is more.
    fn reach(&self, displacement: &[f64], limits: &[f64]) -> f64 {
        let layout = self.layout();
        let loaded = (0..layout.cells).filter(|&cell| limits[cell] > 0.0);
        let [moved, pulled] = loaded.fold([0.0_f64; 2], |[moved, pulled], cell| {
            let (u, q) = (
                layout.at(displacement, cell),
                layout.at(self.traction(), cell),
            );
            [moved.max(norm(u)), pulled + norm(q)]
        });
        let compliance = match self {
            Self::Along(_, stage) => &stage.operator.compliance[..],
            Self::InPlane(stage) => &stage.operator.compliance,
        };
        let springs = compliance.iter().filter(|compliance| **compliance > 0.0);
        moved.max(springs.copied().fold(f64::INFINITY, f64::min) * pulled)
    }

    /// Solves once, to a tolerance measured by bodies and springs together.
    fn minimise_once(
        &mut self,
        limits: &[f64],
        totals: [Option<f64>; 2],
        settings: &Settings,
        observer: Observer<'_>,
    ) -> Result<()> {
        match self {
            Self::Along(axis, stage) => {
                stage.minimise(Magnitude(limits), totals[axis.index()], settings, observer)
            }
            Self::InPlane(stage) => stage.minimise(limits, totals, settings, observer),
        }
    }

    fn report(&self) -> &Report {
        match self {
            Self::Along(_, stage) => stage.report(),
            Self::InPlane(stage) => stage.report(),
        }
    }

    fn product(&self) -> &[f64] {
        match self {
            Self::Along(_, stage) => stage.product(),
            Self::InPlane(stage) => stage.product(),
        }
    }

    /// Errors measured by the displacement of the bodies alone.
    fn examine(
        &self,
        displacement: &[f64],
        limits: &[f64],
        totals: [Option<f64>; 2],
    ) -> Certificate {
        let beyond = self.multiplier();
        match self {
            Self::Along(axis, stage) => cgm::examine(
                &stage.x,
                displacement,
                &stage.linear,
                &Magnitude(limits),
                totals[axis.index()],
                beyond[axis.index()],
                stage.operator.lower_bound(),
            ),
            Self::InPlane(stage) => {
                let layout = self.layout();
                let slip = |cell: usize| {
                    let (u, asked) = (
                        layout.at(displacement, cell),
                        layout.at(&stage.linear, cell),
                    );
                    [0, 1].map(|axis| u[axis] + asked[axis] - beyond[axis])
                };
                plane::examine(
                    &stage.q,
                    displacement,
                    slip,
                    limits,
                    totals,
                    stage.operator.lower_bound(),
                )
            }
        }
    }
}

/// `[x, y]` of what is along an axis.
fn component_of(axis: Axis, value: f64) -> [f64; 2] {
    Layout::new(Some(axis), 1).at(&[value], 0)
}

/// The product, its components one behind the other.
fn product<const N: usize>(operator: &impl Operator<N>, traction: [&[f64]; N]) -> Vec<f64> {
    let mut product = traction.map(|part| vec![0.0; part.len()]);
    let out = product.each_mut().map(|part| &mut part[..]);
    operator.apply(traction, out, &mut operator.workspace());
    product.concat()
}
