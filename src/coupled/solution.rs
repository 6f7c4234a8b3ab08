//! The answer to a coupled contact.

use crate::boundary::Boundary;
use crate::cgm::reduce;
use crate::contact_map::{ContactMap, Warning};
use crate::coupled::CoupledReport;
use crate::coupled::engine::N;
use crate::coupled::increment::CoupledIncrement;
#[cfg(feature = "serde")]
use crate::error::{all_finite, all_non_negative, finite, length};
use crate::field::Field;
use crate::grid::Grid;
use crate::half_space::HalfSpace;
#[cfg(feature = "serde")]
use crate::serial::checked;
use crate::tangential::{Zone, centre};

/// Pressure, traction, slip, zones, approach and shift of a coupled contact. Vectors are `[x, y]`.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct CoupledSolution {
    pressure: Field,
    gap: Field,
    traction: [Field; 2],
    slip: [Field; 2],
    displacement: [Field; N],
    zones: Vec<Zone>,
    boundary: Boundary,
    approach: f64,
    shift: [f64; 2],
    twist: f64,
    report: CoupledReport,
}

/// What is read, before it is checked.
#[cfg(feature = "serde")]
#[derive(serde::Deserialize)]
#[serde(remote = "CoupledSolution")]
struct Unchecked {
    pressure: Field,
    gap: Field,
    traction: [Field; 2],
    slip: [Field; 2],
    displacement: [Field; N],
    zones: Vec<Zone>,
    boundary: Boundary,
    approach: f64,
    shift: [f64; 2],
    twist: f64,
    report: CoupledReport,
}

#[cfg(feature = "serde")]
impl<'de> serde::Deserialize<'de> for CoupledSolution {
    fn deserialize<D: serde::Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        checked(Unchecked::deserialize(deserializer)?, |read| {
            let grid = read.grid();
            all_non_negative("pressure", read.pressure.as_slice())?;
            read.gap.check("gap", grid)?;
            let fields = read.traction.iter().chain(&read.slip);
            for field in fields.chain(&read.displacement) {
                field.check("field of a coupled contact", grid)?;
            }
            length("zones", grid.cells(), read.zones.len())?;
            finite("approach", read.approach)?;
            all_finite("shift", &read.shift)?;
            finite("twist", read.twist).map(|_| ())
        })
    }
}

impl CoupledSolution {
    pub(super) fn new(bodies: &HalfSpace, initial: &Field, increment: &CoupledIncrement) -> Self {
        let (grid, answer) = (bodies.grid(), increment.answer());
        let zeros = || Field::zeros(grid);
        let field = |values: &[f64]| {
            let mut field = Field::zeros(grid);
            field.as_mut_slice().copy_from_slice(values);
            field
        };
        let mut solution = Self {
            pressure: zeros(),
            gap: zeros(),
            traction: answer.traction.map(field),
            slip: [zeros(), zeros()],
            displacement: increment.displacement().map(field),
            zones: vec![Zone::Separated; grid.cells()],
            boundary: bodies.boundary(),
            approach: increment.approach(),
            shift: answer.motion.shift,
            twist: answer.motion.twist,
            report: increment.full_report().clone(),
        };
        increment.write(initial, &mut solution.pressure, &mut solution.gap);
        let touches = |&i: &usize| answer.pressed.pressure[i] > 0.0;
        for i in (0..grid.cells()).filter(touches) {
            let is_at_limit = answer.is_at_limit(i);
            solution.zones[i] = if is_at_limit { Zone::Slip } else { Zone::Stick };
            let slip = answer.slip(i, centre(grid, i)).unwrap_or([0.0; 2]);
            for (field, slip) in solution.slip.iter_mut().zip(slip) {
                field.as_mut_slice()[i] = slip;
            }
        }
        solution
    }

    /// The grid of all its fields.
    #[must_use]
    pub fn grid(&self) -> Grid {
        self.pressure.grid()
    }

    /// What lies beyond the edge of the grid.
    #[must_use]
    pub fn boundary(&self) -> Boundary {
        self.boundary
    }

    /// Pressure p >= 0; exactly zero outside the contact.
    #[must_use]
    pub fn pressure(&self) -> &Field {
        &self.pressure
    }

    /// Gap under load `h + u_z - delta` (lengths): zero in the contact up to the residual, positive outside.
    #[must_use]
    pub fn gap(&self) -> &Field {
        &self.gap
    }

    /// Shear traction q on body 1 (pressures), positive along the axes; exactly zero outside the contact.
    #[must_use]
    pub fn traction(&self) -> [&Field; 2] {
        self.traction.each_ref()
    }

    /// Slip `s = u_t - delta_t` (lengths): against the traction in slip cells, exactly zero elsewhere.
    #[must_use]
    pub fn slip(&self) -> [&Field; 2] {
        self.slip.each_ref()
    }

    /// Displacements of all cells along x, y and z by pressure and traction, body 1 minus body 2 along x and y, the sum
    /// of both bodies along z (lengths).
    #[must_use]
    pub fn displacement(&self) -> [&Field; 3] {
        let [z, x, y] = &self.displacement;
        [x, y, z]
    }

    /// The zone of every cell, row-major with x fastest.
    #[must_use]
    pub fn zones(&self) -> &[Zone] {
        &self.zones
    }

    /// Approach of the bodies from the datum of the initial gap (a length).
    #[must_use]
    pub fn approach(&self) -> f64 {
        self.approach
    }

    /// Shift of body 2 relative to body 1 (lengths): prescribed, or what the forces and springs cause.
    #[must_use]
    pub fn shift(&self) -> [f64; 2] {
        self.shift
    }

    /// Rotation of body 2 relative to body 1 about the origin of the grid (radians, positive from x to y).
    #[must_use]
    pub fn twist(&self) -> f64 {
        self.twist
    }

    /// Normal force, the integral of the pressure.
    #[must_use]
    pub fn normal_force(&self) -> f64 {
        self.pressure.integral()
    }

    /// Tangential force that body 2 exerts on body 1.
    #[must_use]
    pub fn force(&self) -> [f64; 2] {
        self.traction.each_ref().map(Field::integral)
    }

    /// Stick area over contact area, by counting cells; zero without contact.
    #[must_use]
    pub fn stick_ratio(&self) -> f64 {
        let count = |zone: Zone| self.zones.iter().filter(|&&z| z == zone).count() as f64;
        let (stick, slip) = (count(Zone::Stick), count(Zone::Slip));
        if stick == 0.0 {
            0.0
        } else {
            stick / (stick + slip)
        }
    }

    /// Elastic energy of both bodies, $`\tfrac A2 \sum (p\,u_z + q \cdot u_t)`$ (force times length).
    #[must_use]
    pub fn elastic_energy(&self) -> f64 {
        let [z, x, y] = self.displacement.each_ref().map(Field::as_slice);
        let [qx, qy] = self.traction.each_ref().map(Field::as_slice);
        let p = self.pressure.as_slice();
        let sum = reduce::sum(p.len(), |i| p[i] * z[i] + qx[i] * x[i] + qy[i] * y[i]);
        0.5 * self.grid().cell_area() * sum
    }

    /// How the solve ended, what it cost, and what is certified.
    #[must_use]
    pub fn report(&self) -> &CoupledReport {
        &self.report
    }

    /// Remarks on the contact that a result may mislead; see [`Warning`].
    #[must_use]
    pub fn warnings(&self) -> Vec<Warning> {
        let contact = ContactMap {
            grid: self.grid(),
            boundary: self.boundary,
            contains: |i: usize| self.zones[i] != Zone::Separated,
        };
        contact.warnings()
    }
}
