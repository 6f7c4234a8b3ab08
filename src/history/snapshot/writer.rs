//! The parts of a history, written.

use crate::boundary::Boundary;
use crate::cgm::{Method, Settings};
use crate::half_space::HalfSpace;
use crate::history::snapshot::elasticity;
use crate::report::{Report, Status};
use crate::tangential::{Axis, Coefficient, Friction, Zone};
use crate::window::Window;

/// Bytes that grow.
#[derive(Default)]
pub(super) struct Writer(Vec<u8>);

impl Writer {
    pub(super) fn into_bytes(self) -> Vec<u8> {
        self.0
    }

    pub(super) fn raw(&mut self, bytes: &[u8]) {
        self.0.extend_from_slice(bytes);
    }

    fn byte(&mut self, value: u8) {
        self.0.push(value);
    }

    pub(super) fn count(&mut self, value: usize) {
        self.0.extend((value as u64).to_le_bytes());
    }

    fn number(&mut self, value: f64) {
        self.0.extend(value.to_le_bytes());
    }

    pub(super) fn numbers(&mut self, values: &[f64]) {
        self.0.extend(values.iter().flat_map(|v| v.to_le_bytes()));
    }

    pub(super) fn bodies(&mut self, bodies: &HalfSpace) {
        let grid = bodies.grid();
        self.count(grid.nx());
        self.count(grid.ny());
        self.numbers(&[grid.dx(), grid.dy()]);
        self.byte(match bodies.boundary() {
            Boundary::Free => 0,
            Boundary::Periodic => 1,
        });
        self.numbers(&elasticity(bodies));
    }

    pub(super) fn options(&mut self, axis: Option<Axis>, settings: &Settings) {
        self.byte(match axis {
            Some(Axis::X) => 0,
            Some(Axis::Y) => 1,
            None => 2,
        });
        self.byte(match settings.method {
            Method::ActiveSet => 0,
            Method::PolonskyKeer => 1,
        });
        self.number(settings.tolerance);
        self.count(settings.max_iterations);
        self.byte(u8::from(settings.time_limit.is_some()));
        self.number(settings.time_limit.unwrap_or_default().as_secs_f64());
    }

    pub(super) fn friction(&mut self, friction: &Friction) {
        let (coefficient, cap) = friction.parts();
        self.number(cap);
        match coefficient {
            Coefficient::Uniform(coefficient) => {
                self.byte(0);
                self.number(*coefficient);
            }
            Coefficient::PerCell(field) => {
                self.byte(1);
                self.numbers(field.as_slice());
            }
        }
    }

    pub(super) fn report(&mut self, report: &Report) {
        self.byte(match report.status {
            Status::Converged => 1,
            // A step that ends otherwise leaves no trace.
            Status::Unsolved
            | Status::IterationLimit
            | Status::TimeLimit
            | Status::Stalled
            | Status::Cancelled => 0,
        });
        self.count(report.iterations);
        self.count(report.convolutions);
        self.count(report.rough_convolutions);
        self.numbers(&[report.residual, report.certified_gap, report.load_error]);
    }

    pub(super) fn zones(&mut self, zones: &[Zone]) {
        self.0.extend(zones.iter().map(|zone| match zone {
            Zone::Separate => 0,
            Zone::Stick => 1,
            Zone::Slip => 2,
        }));
    }

    pub(super) fn window(&mut self, window: Option<Window>) {
        self.byte(u8::from(window.is_some()));
        if let Some(window) = window {
            for count in window.corner().into_iter().chain(window.size) {
                self.count(count);
            }
        }
    }
}
