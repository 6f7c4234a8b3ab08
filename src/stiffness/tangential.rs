//! Tangential stiffness of a contact, and derivatives of its loads with respect to the approach.

use crate::cgm::{Ball, LinearisedSet, NormBound, Row, reduce};
use crate::error::Result;
use crate::grid::Grid;
use crate::grid::field::Field;
use crate::grid::window::Window;
use crate::half_space::{HalfSpace, Region};
use crate::memory::fallible;
use crate::numerics::cell_vector::{dot, norm};
use crate::stiffness::contact_stiffness::{
    NormalContact, TangentialStiffness, window_of, without_contact,
};
use crate::stiffness::motions::Motions;
use crate::stiffness::system::{CellMotions, Stiffness, System};
use crate::stiffness::workspace::LinearSolveContext;
use crate::stiffness::workspace::{SystemBuffers, SystemOf};
use crate::tangential::{Axis, CouplingDisplacement, Zone, centre};

/// Friction set of `N` traction components.
type BallOf<const N: usize> = <NormBound as Ball<N>>::Set;

/// Tangential stiffness, and derivatives of the loads with respect to the approach.
type FoundStiffness = (TangentialStiffness, [Option<f64>; 3]);

/// Sheared contact, as input of a stiffness.
pub(crate) struct ShearedContact<'a> {
    pub(crate) zones: &'a [Zone],
    pub(crate) traction: [&'a Field; 2],
    pub(crate) last: LastStep<'a>,
    /// Window in which the contact was solved, if known.
    pub(crate) window: Option<Window>,
}

/// Slip and entry compliance of the last step, on the local cells of a window.
#[derive(Clone, Copy)]
pub(crate) struct LastStep<'a> {
    pub(crate) window: Window,
    /// Slip of the step. A component is empty if it has no influence.
    pub(crate) slip: [&'a [f64]; 2],
    /// Entry compliance of the cells that came into contact in the step. Empty if no cell came into contact.
    pub(crate) entered: &'a [f64],
}

impl<'a> LastStep<'a> {
    /// Creates the slip of a step from rest on the whole grid, without entry compliance.
    pub(crate) fn from_rest(grid: Grid, slip: [&'a Field; 2]) -> Self {
        Self {
            window: Window::whole(grid).held(grid),
            slip: slip.map(Field::as_slice),
            entered: &[],
        }
    }

    /// Returns the value of a vector in a cell of the grid, or zero if the vector has no such cell.
    fn of(&self, part: &[f64], cell: usize) -> f64 {
        let value = self.window.place(cell).and_then(|place| part.get(place));
        value.copied().unwrap_or(0.0)
    }
}

/// Sensitivity to the approach: changes of the cell values per unit of approach, and zones, tractions and slips of the local
/// cells of a window.
#[derive(Debug, Default)]
pub(super) struct ApproachSensitivity {
    /// Change of the pressures of the local cells of the grid.
    pub(super) pressure: Vec<f64>,
    /// One in cells whose pressure follows the approach, else zero.
    pub(super) follows: Vec<f64>,
    cells: Cells,
}

#[derive(Debug, Default)]
struct Cells {
    /// Zone of each cell: zero for separated cells, one for sticking cells, two for slipping cells.
    zone: Vec<f64>,
    traction: [Vec<f64>; 2],
    slip: [Vec<f64>; 2],
    entered: Vec<f64>,
    /// Change of the friction limit, relative change of the pressure, and change of the pressure.
    limit: Vec<f64>,
    relative: Vec<f64>,
    pressure: Vec<f64>,
}

/// Copies the values of `of` for the local cells of the grid to the cells of the region.
pub(super) fn collect(
    region: &Region,
    of: impl Fn(usize) -> f64,
    part: &mut Vec<f64>,
) -> Result<()> {
    fallible::resize(part, region.cells(), 0.0)?;
    region.collect(of, part);
    Ok(())
}

impl Cells {
    fn take(&mut self, region: &Region, sheared: &ShearedContact<'_>) -> Result<()> {
        let zone = |i: usize| match sheared.zones[i] {
            Zone::Separated => 0.0,
            Zone::Stick => 1.0,
            Zone::Slip => 2.0,
        };
        collect(region, zone, &mut self.zone)?;
        let last = &sheared.last;
        for axis in [0, 1] {
            let q = sheared.traction[axis].as_slice();
            collect(region, |i| q[i], &mut self.traction[axis])?;
            let slip = |i: usize| last.of(last.slip[axis], i);
            collect(region, slip, &mut self.slip[axis])?;
        }
        collect(region, |i| last.of(last.entered, i), &mut self.entered)
    }

    fn set_approach_sensitivity(
        &mut self,
        region: &Region,
        pressed: &NormalContact<'_>,
        growth: &[f64],
    ) -> Result<()> {
        let pressure = pressed.normal.pressure().as_slice();
        let (friction, touches) = (pressed.friction, |i: usize| pressure[i] > 0.0);
        let limit = |i: usize| friction.slope(i, pressure[i]) * growth[i];
        let relative = |i: usize| (growth[i] / pressure[i]).clamp(-f64::MAX, f64::MAX);
        let if_touching = |i: usize, value: f64| if touches(i) { value } else { 0.0 };
        collect(region, |i| if_touching(i, limit(i)), &mut self.limit)?;
        collect(region, |i| if_touching(i, relative(i)), &mut self.relative)?;
        collect(region, |i| growth[i], &mut self.pressure)
    }

    fn touches(&self, cell: usize) -> bool {
        self.zone[cell] > 0.0
    }

    fn slips(&self, cell: usize) -> bool {
        self.zone[cell] > 1.0
    }

    fn traction<const N: usize>(&self, axes: [Axis; N], cell: usize) -> [f64; N] {
        axes.map(|axis| self.traction[axis.index()][cell])
    }

    /// Returns the motion of a cell while the contact sticks. A cell at a zero limit never sticks.
    fn sticking<R: Row<N>, const N: usize>(&self, cell: usize) -> R {
        let is_idle = self.traction.iter().all(|part| part[cell] == 0.0);
        if !self.touches(cell) || self.slips(cell) && is_idle {
            R::FIXED
        } else {
            R::FREE
        }
    }

    /// Returns the motion of a cell while slip continues. A slipping cell is fixed in the scalar model and turns in the vector
    /// model.
    fn slipping<const N: usize>(
        &self,
        axes: [Axis; N],
        cell: usize,
        self_compliance: f64,
    ) -> <BallOf<N> as LinearisedSet<N>>::CellMotion
    where
        NormBound: Ball<N>,
    {
        if !self.slips(cell) {
            return self.sticking(cell);
        }
        let (q, slip) = (
            self.traction(axes, cell),
            axes.map(|axis| self.slip[axis.index()][cell]),
        );
        let limit = NormBound::of_radius(norm(q));
        let turning = limit.measured(limit.motion(q), slip);
        turning.with_preconditioner_weight(self_compliance, self.entered[cell])
    }

    /// Imposes on slipping cells the change of traction caused by the change of their limits.
    fn force<R, const N: usize>(&self, axes: [Axis; N], system: &mut System<R, N>) {
        for cell in 0..self.zone.len() {
            let q = self.traction(axes, cell);
            let limit = norm(q);
            let part = if self.slips(cell) && limit > 0.0 {
                self.limit[cell] / limit
            } else {
                0.0
            };
            for (forced, q) in system.forced.iter_mut().zip(q) {
                forced[cell] = part * q;
            }
        }
    }

    /// Adds the displacement of cells due to their entry compliance, which decreases as the pressure grows.
    fn add_own<R, const N: usize>(&self, axes: [Axis; N], system: &mut System<R, N>) {
        for (cell, &own) in self
            .entered
            .iter()
            .enumerate()
            .filter(|(_, own)| **own > 0.0)
        {
            for (c, q) in self.traction(axes, cell).into_iter().enumerate() {
                let growth = system.forced[c][cell] - q * self.relative[cell];
                system.displacement[c][cell] += own * growth;
            }
        }
    }

    /// Computes the stiffness for tractions along these axes.
    fn along<const N: usize>(
        &self,
        (bodies, region): (&HalfSpace, &Region),
        axes: [Axis; N],
        pressed: Option<&NormalContact<'_>>,
        slot: &mut Option<SystemOf<BallOf<N>, N>>,
        course: &mut LinearSolveContext<'_>,
    ) -> Result<FoundStiffness>
    where
        NormBound: Ball<N>,
    {
        let (grid, boundary, size) = (bodies.grid(), bodies.boundary(), region.window().size);
        let compliance = bodies.compliance(axes.map(Axis::direction), size)?;
        let system = System::get_or_create(slot, bodies, compliance)?;
        let place = |cell: usize| centre(grid.whole(), region.own().index(cell));
        let motions = Motions::new(axes, boundary, region.layout(), |cell| {
            self.touches(cell).then(|| place(cell))
        });
        let of_cells = CellMotions {
            count: motions.count(),
            of_cell: |motion: usize, cell: usize| motions.at(motion, place(cell)),
        };
        let mut reversal = None;
        if course.has_reversal {
            system.hold(boundary, |cell| self.sticking(cell), &[])?;
            reversal = Some(system.stiffness(&of_cells, course)?);
        }
        let self_compliance = system.self_compliance();
        // If no rank has cells that came into contact, no cell has an entry compliance.
        let has_own = reduce::any(region.layout(), |cell| self.entered[cell] > 0.0);
        let own = if has_own { &*self.entered } else { &[] };
        system.hold(
            boundary,
            |cell| self.slipping(axes, cell, self_compliance),
            own,
        )?;
        let found = system.stiffness(&of_cells, course)?;
        let area = grid.cell_area();
        let mut by_approach = [None; 3];
        if let Some(pressed) = pressed {
            self.force(axes, system);
            system.displace(course)?;
            if pressed.is_drawn {
                let make = || CouplingDisplacement::new(bodies, &axes, size);
                system.draw(make, self.pressure.iter().copied(), course)?;
            }
            self.add_own(axes, system);
            let reaction = system.reaction(of_cells.count)?;
            let forced = reduce::sum(region.layout(), |cell| {
                let forced = system.forced.each_ref().map(|part| part[cell]);
                [0, 1, 2].map(|motion| dot(motions.at(motion, place(cell)), forced))
            });
            let loads = [0, 1, 2].map(|motion| area * (reaction[motion] + forced[motion]));
            by_approach = motions.loads(loads);
        }
        let whole = |stiffness: &Stiffness| {
            let matrix = motions.matrix(&stiffness.matrix);
            matrix.map(|row| row.map(|entry| entry.map(|entry| entry * area)))
        };
        let bound_of = |stiffness: Stiffness| stiffness.bound;
        let stiffness = TangentialStiffness {
            loading: whole(&found),
            reversal: reversal.as_ref().map_or([[None; 3]; 3], whole),
            bound: found.bound.max(reversal.map_or(0.0, bound_of)),
        };
        Ok((stiffness, by_approach))
    }
}

impl ShearedContact<'_> {
    /// Computes the stiffness. If the pressed contact is given, the function also computes the derivatives of the loads with
    /// respect to the approach. These follow from the change of the pressures in the buffers.
    pub(super) fn stiffness(
        &self,
        bodies: &HalfSpace,
        axis: Option<Axis>,
        pressed: Option<&NormalContact<'_>>,
        buffers: &mut SystemBuffers,
        course: &mut LinearSolveContext<'_>,
    ) -> Result<FoundStiffness> {
        let Some(window) = bodies.around(|i| self.zones[i] != Zone::Separated) else {
            return Ok(without_contact(axis, bodies.boundary(), course));
        };
        let region = Region::new(bodies, window_of(bodies, self.window, window));
        let SystemBuffers {
            growth,
            along,
            plane,
            ..
        } = buffers;
        growth.cells.take(&region, self)?;
        if let Some(pressed) = pressed {
            growth
                .cells
                .set_approach_sensitivity(&region, pressed, &growth.pressure)?;
        }
        let (cells, on) = (&growth.cells, (bodies, &region));
        match axis {
            Some(axis) => cells.along(on, [axis], pressed, along, course),
            None => cells.along(on, [Axis::X, Axis::Y], pressed, plane, course),
        }
    }
}
