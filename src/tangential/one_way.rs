//! Tangential displacement caused by pressure, for bodies of different materials.

use crate::bodies::component::{Component, Direction};
use crate::error::Result;
use crate::half_space::{ElasticOperator, HalfSpace};
use crate::memory::fallible;
use crate::operator::{Operator, Scratch};
use crate::tangential::Axis;
use crate::tangential::traction_solver::TangentialVector;

/// Operator of the displacement along one direction due to tractions along another direction, on a window.
#[derive(Debug, Clone)]
pub(super) struct CrossOperator {
    operator: ElasticOperator<1>,
    scratch: Scratch,
}

impl CrossOperator {
    /// Creates the operator of a component.
    pub(super) fn new(bodies: &HalfSpace, component: Component, size: [usize; 2]) -> Result<Self> {
        let operator = bodies.operator_of([[component]], size)?;
        Ok(Self {
            scratch: operator.scratch()?,
            operator,
        })
    }

    /// Writes the displacement that tractions cause.
    pub(super) fn apply(&mut self, traction: &[f64], displacement: &mut [f64]) {
        let Self { operator, scratch } = self;
        operator.apply([traction], [displacement], scratch);
    }
}

/// Operator of the tangential displacement due to pressures on a window, along the axes of a model.
#[derive(Debug, Clone)]
pub(crate) struct CouplingDisplacement {
    parts: Vec<(Axis, CrossOperator)>,
    pressure: Vec<f64>,
    displacement: Vec<f64>,
}

impl CouplingDisplacement {
    pub(crate) fn new(bodies: &HalfSpace, axes: &[Axis], size: [usize; 2]) -> Result<Self> {
        let part = |&axis: &Axis| {
            let component = Component::of(axis.direction(), Direction::Z);
            Ok((axis, CrossOperator::new(bodies, component, size)?))
        };
        let cells = bodies.layout(size).cells();
        Ok(Self {
            parts: axes.iter().map(part).collect::<Result<_>>()?,
            pressure: fallible::zeros(cells)?,
            displacement: fallible::zeros(cells)?,
        })
    }

    /// Subtracts the displacement due to these pressures from a field.
    pub(super) fn subtract(
        &mut self,
        pressures: impl Iterator<Item = f64>,
        field: &mut TangentialVector,
    ) {
        self.displace(pressures, |axis, displacement| {
            for (value, displacement) in field[axis.index()].iter_mut().zip(displacement) {
                *value -= displacement;
            }
        });
    }

    /// Passes the displacement due to these pressures along each axis to a callback.
    pub(crate) fn displace(
        &mut self,
        pressures: impl Iterator<Item = f64>,
        mut show: impl FnMut(Axis, &[f64]),
    ) {
        for (own, pressure) in self.pressure.iter_mut().zip(pressures) {
            *own = pressure;
        }
        for (axis, operator) in &mut self.parts {
            operator.apply(&self.pressure, &mut self.displacement);
            show(*axis, &self.displacement);
        }
    }
}
