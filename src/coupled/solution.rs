//! The answer to a coupled contact.

use crate::buffer::{or_abort, try_clone, try_each};
use crate::cgm::reduce;
use crate::coupled::increment::CoupledIncrement;
use crate::coupled::{CoupledProblem, CoupledReport, N};
use crate::error::Result;
use crate::field::Field;
use crate::half_space::HalfSpace;
use crate::layout::Layout;
use crate::normal::NormalSolution;
#[cfg(feature = "serde")]
use crate::serial::checked;
use crate::shown::shown;
use crate::tangential::TangentialSolution;
use crate::warning::Warning;

/// Both halves of a coupled contact, with the displacements that they cause together. Two are equal if their answers are,
/// however they were found.
#[derive(Clone)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct CoupledSolution {
    normal: NormalSolution,
    tangential: TangentialSolution,
    displacement: [Field; N],
    report: CoupledReport,
    /// Whether friction has held a contact that came to its size in one step.
    is_pressed_at_once: bool,
    /// Of a slab, the elastic energy of the whole grid.
    #[cfg_attr(feature = "serde", serde(skip))]
    whole_energy: Option<f64>,
}

shown!(CoupledSolution: normal, tangential, elastic_energy(), report());

try_clone!(CoupledSolution { normal, tangential, displacement } { report, is_pressed_at_once, whole_energy });

impl PartialEq for CoupledSolution {
    fn eq(&self, other: &Self) -> bool {
        let Self {
            normal,
            tangential,
            displacement,
            report: _,
            is_pressed_at_once,
            whole_energy,
        } = self;
        *normal == other.normal
            && *tangential == other.tangential
            && *displacement == other.displacement
            && *is_pressed_at_once == other.is_pressed_at_once
            && *whole_energy == other.whole_energy
    }
}

/// What is read, before it is checked.
#[cfg(feature = "serde")]
#[derive(serde::Deserialize)]
#[serde(remote = "CoupledSolution")]
struct Unchecked {
    normal: NormalSolution,
    tangential: TangentialSolution,
    displacement: [Field; N],
    report: CoupledReport,
    is_pressed_at_once: bool,
    #[serde(skip)]
    whole_energy: Option<f64>,
}

#[cfg(feature = "serde")]
impl<'de> serde::Deserialize<'de> for CoupledSolution {
    fn deserialize<D: serde::Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        checked(Unchecked::deserialize(deserializer)?, |read| {
            let grid = read.normal.grid();
            grid.expect("tangential half", read.tangential.grid())?;
            let mut fields = read.displacement.iter();
            fields.try_for_each(|field| field.check("displacement", grid))
        })
    }
}

impl CoupledSolution {
    /// No contact yet.
    pub(super) fn empty(bodies: &HalfSpace, gap: &Field) -> Result<Self> {
        let (grid, boundary) = (bodies.grid(), bodies.boundary());
        Ok(Self {
            normal: NormalSolution::empty(gap, (boundary, bodies.cell_value()), bodies.pair())?,
            tangential: TangentialSolution::empty(bodies)?,
            displacement: try_each(|_| Field::try_zeros(grid))?,
            report: CoupledReport::unsolved(),
            is_pressed_at_once: false,
            whole_energy: None,
        })
    }

    pub(super) fn fill(&mut self, of: &CoupledProblem, increment: &CoupledIncrement) {
        let (bodies, gap) = (&of.bodies, &of.gap);
        increment.write(gap, of.hardness.as_ref(), &mut self.normal);
        self.normal.measure_scale(bodies, gap);
        self.tangential
            .fill(bodies, None, &increment.answer(), increment.report());
        let pair = bodies.pair();
        self.tangential
            .set_coupled(pair.is_coupled().then(|| pair.coupling_strength()));
        for (field, values) in self.displacement.iter_mut().zip(increment.displacement()) {
            field.as_mut_slice().copy_from_slice(values);
        }
        self.report.clone_from(increment.full_report());
        let layout = bodies.grid_layout();
        self.is_pressed_at_once = pair.is_coupled() && self.has_grown(&layout, gap);
        self.whole_energy = bodies.is_shared().then(|| self.energy_over(&layout));
    }

    /// Whether friction has held cells that a growing load would have brought into contact one after the other: where the
    /// gap before loading is the same all over the contact, all come at once anyway.
    fn has_grown(&self, layout: &Layout, gap: &Field) -> bool {
        let (pressure, gap) = (self.normal.pressure().as_slice(), gap.as_slice());
        let [qx, qy] = self.tangential.traction().map(Field::as_slice);
        let is_held = reduce::any(layout, |i| qx[i] != 0.0 || qy[i] != 0.0);
        let first = reduce::least(layout, |i| (pressure[i] > 0.0).then_some((gap[i], i)));
        let is_later = |first: f64| reduce::any(layout, |i| pressure[i] > 0.0 && gap[i] > first);
        first.is_some_and(|(first, _)| is_later(first)) && is_held
    }

    /// The normal half: pressure, gap under load, approach, contact area. Its report is that of the whole.
    #[must_use]
    pub fn normal(&self) -> &NormalSolution {
        &self.normal
    }

    /// The tangential half: tractions along both axes, slip, zones, shift. Its report is that of the whole.
    #[must_use]
    pub fn tangential(&self) -> &TangentialSolution {
        &self.tangential
    }

    /// Displacements of all cells along x, y and z by pressure and traction together, body 1 minus body 2 along x and y,
    /// the sum of both bodies along z (lengths). Those that the halves compute are by the pressure or the tractions alone.
    #[must_use]
    pub fn displacement(&self) -> [&Field; 3] {
        let [z, x, y] = &self.displacement;
        [x, y, z]
    }

    /// Elastic energy of both bodies, $`\tfrac A2 \sum (p\,u_z + q \cdot u_t)`$ (force times length).
    #[must_use]
    pub fn elastic_energy(&self) -> f64 {
        let of_own = || self.energy_over(&self.normal.grid().layout());
        self.whole_energy.unwrap_or_else(of_own)
    }

    /// Of cells that lie so.
    fn energy_over(&self, layout: &Layout) -> f64 {
        let [z, x, y] = self.displacement.each_ref().map(Field::as_slice);
        let [qx, qy] = self.tangential.traction().map(Field::as_slice);
        let p = self.normal.pressure().as_slice();
        let sum = reduce::sum(layout, |i| p[i] * z[i] + qx[i] * x[i] + qy[i] * y[i]);
        0.5 * self.normal.grid().cell_area() * sum
    }

    /// How the solve ended, what it cost, and what is certified.
    #[must_use]
    pub fn report(&self) -> &CoupledReport {
        &self.report
    }

    /// Remarks on the contact that a result may mislead; see [`Warning`].
    #[must_use]
    pub fn warnings(&self) -> Vec<Warning> {
        or_abort(self.try_warnings())
    }

    /// [`Self::warnings`] where memory may run out.
    ///
    /// # Errors
    /// [`Error::Memory`](crate::Error::Memory).
    pub fn try_warnings(&self) -> Result<Vec<Warning>> {
        let at_once = self.is_pressed_at_once.then_some(Warning::PressedAtOnce);
        let mut warnings = self.normal.try_warnings()?;
        warnings.extend(self.tangential.zone_warnings().chain(at_once));
        Ok(warnings)
    }
}
