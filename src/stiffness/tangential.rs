//! Tangential stiffness of a contact, and derivatives of its loads with respect to the approach.

use crate::cgm::{Ball, LinearisedSet, NormBound, Row, reduce};
use crate::contact::ResponseContext;
use crate::error::Result;
use crate::half_space::{ElasticOperator, HalfSpace, Region};
use crate::numerics::cell_vector::{dot, norm};
use crate::operator::Operator;
use crate::stiffness::TangentialStiffness;
use crate::stiffness::contact::{ContactCells, Pressing, SolvedContact, collect};
use crate::stiffness::motions::Motions;
use crate::stiffness::system::{CellMotions, Stiffness, System};
use crate::stiffness::workspace::{SystemBuffers, SystemOf};
use crate::tangential::{Axis, CouplingDisplacement, Zone, centre};

/// Friction set of `N` traction components.
pub(crate) type BallOf<const N: usize> = <NormBound as Ball<N>>::Set;

/// Tangential stiffness, and derivatives of the loads with respect to the approach.
type FoundStiffness = (TangentialStiffness, [Option<f64>; 3]);

impl ContactCells {
    /// Copies the zones to the cells of the region.
    pub(crate) fn take_zones(&mut self, region: &Region, zones: &[Zone]) -> Result<()> {
        let zone = |i: usize| match zones[i] {
            Zone::Separated => 0.0,
            Zone::Stick => 1.0,
            Zone::Slip => 2.0,
        };
        collect(region, zone, &mut self.zone)
    }

    /// Sets the changes of the cells of the region per unit of approach.
    fn take_growth(&mut self, region: &Region, (normal, friction): Pressing<'_>) -> Result<()> {
        let (pressure, growth) = (normal.pressure().as_slice(), &self.growth_on_grid);
        let limit = |i: usize| friction.slope(i, pressure[i]) * growth[i];
        let relative = |i: usize| (growth[i] / pressure[i]).clamp(-f64::MAX, f64::MAX);
        let if_touching = |i: usize, value: f64| if pressure[i] > 0.0 { value } else { 0.0 };
        collect(region, |i| if_touching(i, limit(i)), &mut self.limit)?;
        collect(region, |i| if_touching(i, relative(i)), &mut self.relative)?;
        collect(region, |i| growth[i], &mut self.growth)
    }

    fn touches(&self, cell: usize) -> bool {
        self.zone[cell] > 0.0
    }

    pub(crate) fn slips(&self, cell: usize) -> bool {
        self.zone[cell] > 1.0
    }

    fn traction<const N: usize>(&self, axes: [Axis; N], cell: usize) -> [f64; N] {
        axes.map(|axis| self.traction[axis.index()][cell])
    }

    /// Returns the displacement of a cell due to its entry compliance.
    pub(crate) fn entry_lag<const N: usize>(&self, axes: [Axis; N], cell: usize) -> [f64; N] {
        let q = self.traction(axes, cell);
        q.map(|q| self.entered[cell] * q)
    }

    /// Returns the unit direction of the traction that the friction limit of a slipping cell imposes, or zero in other cells.
    pub(crate) fn slip_direction<const N: usize>(&self, axes: [Axis; N], cell: usize) -> [f64; N] {
        let q = self.traction(axes, cell);
        let opposite = if norm(q) > 0.0 {
            q
        } else {
            // A limit of zero would impose a traction opposite to the slip.
            axes.map(|axis| -self.slip[axis.index()][cell])
        };
        let size = norm(opposite);
        if self.slips(cell) && size > 0.0 {
            opposite.map(|part| part / size)
        } else {
            [0.0; N]
        }
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

    /// Returns the system of tractions along these axes.
    fn system<'s, const N: usize>(
        bodies: &HalfSpace,
        region: &Region,
        axes: [Axis; N],
        slot: &'s mut Option<SystemOf<BallOf<N>, N>>,
    ) -> Result<&'s mut SystemOf<BallOf<N>, N>>
    where
        NormBound: Ball<N>,
    {
        let compliance = bodies.compliance(axes.map(Axis::direction), region.window().size)?;
        let alone = |operator: &ElasticOperator<N>| Ok(operator.self_compliance());
        System::get_or_create(slot, bodies, compliance, alone)
    }

    /// Sets the motions of the cells while slip continues.
    fn hold_slip<const N: usize>(
        &self,
        (bodies, region): (&HalfSpace, &Region),
        axes: [Axis; N],
        system: &mut SystemOf<BallOf<N>, N>,
    ) -> Result<()>
    where
        NormBound: Ball<N>,
    {
        let alone = system.self_compliance;
        // If no rank has cells that came into contact, no cell has an entry compliance.
        let has_own = reduce::any(region.layout(), |cell| self.entered[cell] > 0.0);
        let own = if has_own { &*self.entered } else { &[] };
        system.hold(bodies, |cell| self.slipping(axes, cell, alone), own)
    }

    /// Creates the system of tractions along these axes while slip continues.
    pub(crate) fn slipping_system<'s, const N: usize>(
        &self,
        (bodies, region): (&HalfSpace, &Region),
        axes: [Axis; N],
        slot: &'s mut Option<SystemOf<BallOf<N>, N>>,
    ) -> Result<&'s mut SystemOf<BallOf<N>, N>>
    where
        NormBound: Ball<N>,
    {
        let system = Self::system(bodies, region, axes, slot)?;
        self.hold_slip((bodies, region), axes, system)?;
        Ok(system)
    }

    /// Computes the stiffness for tractions along these axes.
    fn along<const N: usize>(
        &self,
        (contact, region, has_reversal): (&SolvedContact<'_>, &Region, bool),
        axes: [Axis; N],
        pressing: Option<Pressing<'_>>,
        slot: &mut Option<SystemOf<BallOf<N>, N>>,
        context: &mut ResponseContext<'_>,
    ) -> Result<FoundStiffness>
    where
        NormBound: Ball<N>,
    {
        let (bodies, size) = (contact.bodies, region.window().size);
        let (grid, boundary) = (bodies.grid(), bodies.boundary());
        let system = Self::system(bodies, region, axes, slot)?;
        let place = |cell: usize| centre(grid.whole(), region.own().index(cell));
        let motions = Motions::new(axes, boundary, region.layout(), |cell| {
            self.touches(cell).then(|| place(cell))
        });
        let of_cells = CellMotions {
            count: motions.count(),
            of_cell: |motion: usize, cell: usize| motions.at(motion, place(cell)),
        };
        let mut reversal = None;
        if has_reversal {
            system.hold(bodies, |cell| self.sticking(cell), &[])?;
            reversal = Some(system.stiffness(&of_cells, context)?);
        }
        self.hold_slip((bodies, region), axes, system)?;
        let found = system.stiffness(&of_cells, context)?;
        let area = grid.cell_area();
        let mut by_approach = [None; 3];
        if pressing.is_some() {
            self.force(axes, system);
            system.displace(context)?;
            if contact.is_drawn {
                let make = || CouplingDisplacement::new(bodies, &axes, size);
                system.draw(make, self.growth.iter().copied(), context)?;
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

impl SolvedContact<'_> {
    /// Computes the tangential stiffness. If the pressing is given, the function also computes the derivatives of the loads with
    /// respect to the approach. These follow from the change of the pressures in the buffers.
    pub(super) fn shear(
        &self,
        pressing: Option<Pressing<'_>>,
        buffers: &mut SystemBuffers,
        context: &mut ResponseContext<'_>,
    ) -> Result<FoundStiffness> {
        let has_reversal = buffers.has_reversal;
        let Some(region) = self.region(self.windows[1], |i| self.zones[i] != Zone::Separated)
        else {
            return Ok(self.without_contact(self.axis, has_reversal, context));
        };
        let cells = &mut buffers.cells;
        cells.take_zones(&region, self.zones)?;
        cells.take(&region, self)?;
        if let Some(pressing) = pressing {
            cells.take_growth(&region, pressing)?;
        }
        let (cells, on) = (&*cells, (self, &region, has_reversal));
        match self.axis {
            Some(axis) => cells.along(on, [axis], pressing, &mut buffers.along, context),
            None => cells.along(
                on,
                [Axis::X, Axis::Y],
                pressing,
                &mut buffers.plane,
                context,
            ),
        }
    }
}
