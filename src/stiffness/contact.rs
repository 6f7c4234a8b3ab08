//! The stiffness of a contact that is solved.

use std::ops::ControlFlow;

use crate::boundary::Boundary;
use crate::buffer;
use crate::cgm::small::Small;
use crate::cgm::vector::{dot, norm};
use crate::cgm::{Ball, Linearised, Motion, Row, Within};
use crate::error::{Result, positive};
use crate::field::Field;
use crate::half_space::HalfSpace;
use crate::normal::{Hardness, NormalSolution};
use crate::parallel;
use crate::report::Iteration;
use crate::stiffness::course::Course;
use crate::stiffness::motions::{Motions, kinds};
use crate::stiffness::press::press;
use crate::stiffness::system::{CellMotions, Stiffness, System, times};
use crate::stiffness::workspace::{Buffers, StiffnessWorkspace, SystemOf};
use crate::tangential::{Axis, Drawing, Friction, TangentialSolution, Zone, centre};
use crate::watch::{Observer, unwatched};
use crate::window::Window;

/// The set of what friction holds of `N` tractions.
type BallOf<const N: usize> = <Within as Ball<N>>::Set;

/// The normal stiffness of a contact.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub struct NormalStiffness {
    /// $`dW/d\delta_z`$ (a force over a length), zero without contact. Hertz: $`2 E^* a`$.
    pub value: f64,
    /// Bound of its relative error; infinite where pressure and shear are found together.
    pub bound: f64,
}

/// The tangential stiffness of a contact: forces along x and y and the moment, by shifts along x and y and the twist.
///
/// Rows are loads, columns motions: forces over lengths in the upper left two by two, moments over radians in the last
/// place, forces (over radians) between. `None` of loads and motions that the model does not have: in the scalar model
/// what is across its axis and the twist, on grids that repeat the twist.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub struct TangentialStiffness {
    /// If the motion continues in its direction. Of a ball, by
    /// [Cattaneo and Mindlin](crate::analytical::CattaneoMindlin): $`8 G^* a\,(1 - F/\mu W)^{1/3}`$.
    pub loading: [[Option<f64>; 3]; 3],
    /// If the motion reverses: all cells of the contact stick. Of a circle, by
    /// [Mindlin](crate::analytical::MindlinFullStick): $`8 G^* a`$.
    pub reversal: [[Option<f64>; 3]; 3],
    /// Bound of the errors: none is larger than this times the root of the product of the two entries on the diagonal,
    /// of the matrix for a twist about the centre of the contact. Infinite where pressure and shear are found together.
    pub bound: f64,
}

/// The stiffness of a contact in all directions.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub struct ContactStiffness {
    /// Normal force by approach.
    pub normal: NormalStiffness,
    /// Tangential forces and moment by shift and twist.
    pub tangential: TangentialStiffness,
    /// Tangential forces (over a length) and moment (a force) by the approach while slip continues, through the friction
    /// limit of the cells that slip and the lag of those that entered the contact in the step of a history: if the shift
    /// grows in the same step, or the approach decreases. Pressed further at a held shift these cells stick, and the slope
    /// is zero. Without a bound of its own; the change of pressure behind it has a relative error, in the energy norm, of
    /// the root of the bound of `normal`. Of problems with [one-way coupling](crate::Coupling::OneWay) without what the
    /// pressure moves the surfaces, which steps of histories have. `None` of loads that the model does not have.
    pub by_approach: [Option<f64>; 3],
    /// Normal force (over a length, for the twist a force) by shifts along x and y and the twist: zero but where pressure and
    /// shear are found together. `None` of motions that the model does not have.
    pub normal_by_motion: [Option<f64>; 3],
}

impl TangentialStiffness {
    /// The stiffness behind springs: forces and moment by the motion of the far ends of springs along x and y (a force
    /// over a length each), and by the twist, $`(K^{-1} + k^{-1})^{-1}`$.
    ///
    /// # Errors
    /// [`Error::NotPositive`](crate::Error::NotPositive) for a spring.
    pub fn through_springs(&self, springs: [f64; 2]) -> Result<Self> {
        for stiffness in springs {
            positive("stiffness of the spring", stiffness)?;
        }
        let [x, y] = springs.map(f64::recip);
        // (1 + K / k) dF = K dX.
        let in_series = |found: [[Option<f64>; 3]; 3]| {
            let matrix = found.map(|row| row.map(Option::unwrap_or_default));
            let mut system = times(&matrix, &[[x, 0.0, 0.0], [0.0, y, 0.0], [0.0; 3]]);
            for (a, row) in system.iter_mut().enumerate() {
                row[a] += 1.0;
            }
            let column = |a: usize| Small(system).solve(matrix.map(|row| row[a]), [true; 3]);
            let columns = [column(0), column(1), column(2)];
            let place = |a: usize, b: usize| found[a][b].map(|_| columns[b][a]);
            [0, 1, 2].map(|a| [0, 1, 2].map(|b| place(a, b)))
        };
        Ok(Self {
            loading: in_series(self.loading),
            reversal: in_series(self.reversal),
            bound: self.bound,
        })
    }
}

impl NormalSolution {
    /// The normal stiffness $`dW/d\delta_z`$, by one solve on the cells of the contact.
    ///
    /// The set of cells is held, so that the stiffness jumps where a cell comes into contact; it is that of a contact
    /// whose edge runs along sides of cells. On a periodic grid the approach is that of the mean planes.
    ///
    /// # Errors
    /// [`Error::GridMismatch`](crate::Error::GridMismatch),
    /// [`Error::BoundaryMismatch`](crate::Error::BoundaryMismatch) or
    /// [`Error::MaterialMismatch`](crate::Error::MaterialMismatch) for bodies that the solution is
    /// not of; [`Error::CoupledMaterials`](crate::Error::CoupledMaterials) for the half of a coupled solution of dissimilar
    /// bodies, whose pressure follows from the shear too; [`Error::NotFinite`](crate::Error::NotFinite) where a periodic contact is closed everywhere and
    /// resists without limit; [`Error::NotConverged`](crate::Error::NotConverged); as [`HalfSpace::operator`];
    /// [`Error::Ranks`](crate::Error::Ranks).
    pub fn stiffness(&self, bodies: &HalfSpace) -> Result<NormalStiffness> {
        self.stiffness_observed(bodies, unwatched)
    }

    /// [`stiffness`](Self::stiffness) with an observer that is asked before every product with the operator and may
    /// cancel; the residual it sees is the root of the last bound.
    ///
    /// # Errors
    /// As [`stiffness`](Self::stiffness).
    pub fn stiffness_observed(
        &self,
        bodies: &HalfSpace,
        mut observer: impl FnMut(&Iteration) -> ControlFlow<()> + Send,
    ) -> Result<NormalStiffness> {
        bodies.check_alone("a stiffness")?;
        let mut workspace = StiffnessWorkspace::new();
        let (mut course, Buffers { normal, .. }) = workspace.begin(&mut observer);
        parallel::enter_with(bodies.grid().cells(), || {
            press((bodies, None), self, None, normal, &mut course, |_, _| {})
        })
    }
}

impl TangentialSolution {
    /// The tangential stiffness, by a solve for each motion of the model and each of the two sets of cells.
    ///
    /// Loading is the derivative of this solution by its load. In the vector model that includes how the slip of the
    /// step resists turning; on grids that do not repeat the vector model has the twist.
    ///
    /// # Errors
    /// [`Error::GridMismatch`](crate::Error::GridMismatch) or
    /// [`Error::BoundaryMismatch`](crate::Error::BoundaryMismatch) for bodies that the solution is not of;
    /// [`Error::CoupledMaterials`](crate::Error::CoupledMaterials) for the half of a coupled solution of dissimilar bodies;
    /// [`Error::NotFinite`](crate::Error::NotFinite) where a periodic contact is closed everywhere;
    /// [`Error::NotConverged`](crate::Error::NotConverged); as [`HalfSpace::operator`];
    /// [`Error::Ranks`](crate::Error::Ranks).
    pub fn stiffness(&self, bodies: &HalfSpace) -> Result<TangentialStiffness> {
        self.stiffness_observed(bodies, unwatched)
    }

    /// [`stiffness`](Self::stiffness) with an observer that is asked before every product with the operator and may
    /// cancel; the residual it sees is the root of the last bound.
    ///
    /// # Errors
    /// As [`stiffness`](Self::stiffness).
    pub fn stiffness_observed(
        &self,
        bodies: &HalfSpace,
        mut observer: impl FnMut(&Iteration) -> ControlFlow<()> + Send,
    ) -> Result<TangentialStiffness> {
        bodies.check_alone("a stiffness")?;
        self.check_bodies(bodies)?;
        self.check_uncoupled()?;
        let sheared = Sheared {
            zones: self.zones(),
            traction: self.traction(),
            slip: self.slip(),
            entered: &[],
            window: None,
        };
        let mut workspace = StiffnessWorkspace::new();
        let (mut course, buffers) = workspace.begin(&mut observer);
        let found = parallel::enter_with(bodies.grid().cells(), || {
            sheared.stiffness(bodies, self.axis(), None, buffers, &mut course)
        });
        found.map(|found| found.0)
    }
}

impl ContactStiffness {
    /// Of a contact under a load from rest: pressed, and sheared with this friction.
    ///
    /// # Errors
    /// As [`NormalSolution::stiffness`] and [`TangentialSolution::stiffness`];
    /// [`Error::GridMismatch`](crate::Error::GridMismatch) for the friction.
    pub fn new(
        bodies: &HalfSpace,
        normal: &NormalSolution,
        friction: &Friction,
        shear: &TangentialSolution,
    ) -> Result<Self> {
        Self::observed(bodies, normal, friction, shear, unwatched)
    }

    /// [`new`](Self::new) with an observer that is asked before every product with an operator and may cancel; the
    /// residual it sees is the root of the last bound.
    ///
    /// # Errors
    /// As [`new`](Self::new).
    pub fn observed(
        bodies: &HalfSpace,
        normal: &NormalSolution,
        friction: &Friction,
        shear: &TangentialSolution,
        mut observer: impl FnMut(&Iteration) -> ControlFlow<()> + Send,
    ) -> Result<Self> {
        shear.check_bodies(bodies)?;
        shear.check_uncoupled()?;
        let sheared = Sheared {
            zones: shear.zones(),
            traction: shear.traction(),
            slip: shear.slip(),
            entered: &[],
            window: None,
        };
        let (axis, workspace) = (shear.axis(), &mut StiffnessWorkspace::new());
        let pressed = Pressed::new(normal, friction);
        Self::of(bodies, &pressed, &sheared, axis, workspace, &mut observer)
    }

    pub(crate) fn of(
        bodies: &HalfSpace,
        pressed: &Pressed<'_>,
        sheared: &Sheared<'_>,
        axis: Option<Axis>,
        workspace: &mut StiffnessWorkspace,
        observer: Observer<'_>,
    ) -> Result<Self> {
        pressed.friction.check(bodies.grid())?;
        let (mut course, buffers) = workspace.begin(observer);
        parallel::enter_with(bodies.grid().cells(), || {
            Self::found(bodies, pressed, sheared, axis, buffers, &mut course)
        })
    }

    fn found(
        bodies: &HalfSpace,
        contact: &Pressed<'_>,
        sheared: &Sheared<'_>,
        axis: Option<Axis>,
        buffers: &mut Buffers,
        course: &mut Course<'_>,
    ) -> Result<Self> {
        let Pressed {
            normal,
            window,
            friction,
            hardness,
            is_drawn,
        } = *contact;
        let mut changes = std::mem::take(&mut buffers.by_approach);
        changes.clear(bodies.grid().cells(), is_drawn)?;
        let pressure = normal.pressure().as_slice();
        let grow = |i: usize, growth: f64| {
            changes.limits[i] = friction.slope(i, pressure[i]) * growth;
            changes.relative[i] = (growth / pressure[i]).clamp(-f64::MAX, f64::MAX);
            changes.pressure[i] = growth;
        };
        let (on, slot) = ((bodies, window), &mut buffers.normal);
        let normal = press(on, normal, hardness, slot, course, grow)?;
        let found = sheared.stiffness(bodies, axis, Some(&changes), buffers, course);
        buffers.by_approach = changes;
        let (tangential, by_approach) = found?;
        Ok(Self {
            normal,
            normal_by_motion: by_approach.map(|load| load.map(|_| 0.0)),
            tangential,
            by_approach,
        })
    }
}

/// Zero of what the model has.
pub(super) fn without_contact(
    axis: Option<Axis>,
    boundary: Boundary,
) -> (TangentialStiffness, [Option<f64>; 3]) {
    let has = kinds(axis.map_or(Axis::BOTH, Axis::alone), boundary);
    let none = has.map(|has| has.then_some(0.0));
    let matrix = none.map(|of_load| none.map(|of_motion| of_load.and(of_motion)));
    let stiffness = TangentialStiffness {
        loading: matrix,
        reversal: matrix,
        bound: 0.0,
    };
    (stiffness, none)
}

/// What is known of a pressed contact.
#[derive(Clone, Copy)]
pub(crate) struct Pressed<'a> {
    pub(crate) normal: &'a NormalSolution,
    /// Where it was found, if that is known.
    pub(crate) window: Option<Window>,
    pub(crate) friction: &'a Friction,
    pub(crate) hardness: Option<&'a Hardness>,
    /// Whether pressure moves the surfaces tangentially, and shear does not change it.
    pub(crate) is_drawn: bool,
}

impl<'a> Pressed<'a> {
    /// Of elastic bodies whose pressure moves the surfaces normally alone.
    fn new(normal: &'a NormalSolution, friction: &'a Friction) -> Self {
        Self {
            normal,
            window: None,
            friction,
            hardness: None,
            is_drawn: false,
        }
    }
}

/// What is known of a sheared contact.
pub(crate) struct Sheared<'a> {
    pub(crate) zones: &'a [Zone],
    pub(crate) traction: [&'a Field; 2],
    /// Slip of the step.
    pub(crate) slip: [&'a Field; 2],
    /// Compliance of their own of the cells that entered the contact in the step; of no cells where none did.
    pub(crate) entered: &'a [f64],
    /// Where it was found, if that is known.
    pub(crate) window: Option<Window>,
}

/// The window in which a contact was found, whose operators are at hand, or the smallest around it.
pub(super) fn window_of(bodies: &HalfSpace, found: Option<Window>, contact: Window) -> Window {
    let found = found.filter(|window| window.covers(contact));
    found.unwrap_or_else(|| bodies.confined(contact))
}

/// What the approach changes in the cells of the grid, for each unit.
#[derive(Debug, Default)]
pub(super) struct ByApproach {
    /// The friction limits.
    limits: Vec<f64>,
    /// The pressures, each over itself.
    relative: Vec<f64>,
    pressure: Vec<f64>,
    /// Whether pressure moves the surfaces tangentially.
    is_drawn: bool,
}

impl ByApproach {
    /// Nothing, of so many cells.
    fn clear(&mut self, cells: usize, is_drawn: bool) -> Result<()> {
        self.is_drawn = is_drawn;
        for part in [&mut self.limits, &mut self.relative, &mut self.pressure] {
            part.clear();
            buffer::resize(part, cells, 0.0)?;
        }
        Ok(())
    }
}

impl Sheared<'_> {
    /// The stiffness; and the loads by the approach, if what that changes is given.
    fn stiffness(
        &self,
        bodies: &HalfSpace,
        axis: Option<Axis>,
        changes: Option<&ByApproach>,
        buffers: &mut Buffers,
        course: &mut Course<'_>,
    ) -> Result<(TangentialStiffness, [Option<f64>; 3])> {
        let grid = bodies.grid();
        let Some(window) = Window::around(grid, |i| self.zones[i] != Zone::Separated) else {
            return Ok(without_contact(axis, bodies.boundary()));
        };
        let on = (bodies, window_of(bodies, self.window, window));
        match axis {
            Some(axis) => self.along(on, [axis], changes, &mut buffers.along, course),
            None => self.along(on, [Axis::X, Axis::Y], changes, &mut buffers.plane, course),
        }
    }

    fn along<const N: usize>(
        &self,
        (bodies, window): (&HalfSpace, Window),
        axes: [Axis; N],
        changes: Option<&ByApproach>,
        slot: &mut Option<SystemOf<BallOf<N>, N>>,
        course: &mut Course<'_>,
    ) -> Result<(TangentialStiffness, [Option<f64>; 3])>
    where
        Within: Ball<N>,
    {
        let (grid, boundary) = (bodies.grid(), bodies.boundary());
        let compliance = bodies.compliance(axes.map(Axis::direction), window.size)?;
        let system = System::provide(slot, compliance)?;
        let touches = |i: usize| self.zones[i] != Zone::Separated;
        let motions = Motions::new(grid, window, axes, boundary, touches);
        let contact = window.indices().filter(|&i| touches(i));
        let of_cells = CellMotions {
            count: motions.count(),
            of_cell: |motion: usize, cell: usize| {
                motions.at(motion, centre(grid, window.index(cell)))
            },
            squares: motions.squares(contact.map(|i| centre(grid, i))),
        };
        let sticking = |cell: usize| self.sticking(window.index(cell));
        let mut reversal = None;
        if course.has_reversal {
            system.hold(boundary, sticking, None::<fn(usize) -> f64>)?;
            reversal = Some(system.stiffness(&of_cells, course)?);
        }
        let entered = |cell: usize| self.entered[window.index(cell)];
        let has_own = !self.entered.is_empty();
        let lower_bound = system.lower_bound();
        let slipping = |cell: usize| {
            let i = window.index(cell);
            match self.zones[i] {
                Zone::Slip => {
                    let own = if has_own { self.entered[i] } else { 0.0 };
                    self.turning(axes, i).weighed(lower_bound, own)
                }
                _ => sticking(cell),
            }
        };
        system.hold(boundary, slipping, has_own.then_some(entered))?;
        let found = system.stiffness(&of_cells, course)?;
        let mut by_approach = [None; 3];
        if let Some(changes) = changes {
            self.force(axes, window, changes, system);
            system.displace(course)?;
            if changes.is_drawn {
                let make = || Drawing::new(bodies, &axes, window.size);
                let pressures = window.indices().map(|i| changes.pressure[i]);
                system.draw(make, pressures, course)?;
            }
            self.add_own(axes, window, changes, system);
            let mut loads = system.reaction(&found);
            for (motion, load) in loads.iter_mut().enumerate().take(of_cells.count) {
                for (cell, i) in window.indices().enumerate() {
                    let forced = system.forced.each_ref().map(|part| part[cell]);
                    *load += dot(motions.at(motion, centre(grid, i)), forced);
                }
            }
            let area = grid.cell_area();
            by_approach = motions
                .loads(loads)
                .map(|load| load.map(|load| load * area));
        }
        let whole = |stiffness: &Stiffness| {
            let area = grid.cell_area();
            motions
                .matrix(&stiffness.matrix)
                .map(|row| row.map(|entry| entry.map(|entry| entry * area)))
        };
        let bound_of = |stiffness: Stiffness| stiffness.bound;
        let stiffness = TangentialStiffness {
            loading: whole(&found),
            reversal: reversal.as_ref().map_or([[None; 3]; 3], whole),
            bound: found.bound.max(reversal.map_or(0.0, bound_of)),
        };
        Ok((stiffness, by_approach))
    }

    fn at<const N: usize>(vector: [&Field; 2], axes: [Axis; N], index: usize) -> [f64; N] {
        axes.map(|axis| vector[axis.index()].as_slice()[index])
    }

    /// How a cell of the contact moves while it sticks.
    fn sticking<R: Row<N>, const N: usize>(&self, index: usize) -> R {
        match self.zones[index] {
            Zone::Separated => R::FIXED,
            // What carries nothing at its limit never sticks.
            Zone::Slip if self.traction.iter().all(|q| q.as_slice()[index] == 0.0) => R::FIXED,
            Zone::Stick | Zone::Slip => R::FREE,
        }
    }

    /// How a cell moves that slips: not at all along one axis, in the plane it turns.
    fn turning<const N: usize>(
        &self,
        axes: [Axis; N],
        index: usize,
    ) -> <BallOf<N> as Linearised<N>>::Motion
    where
        Within: Ball<N>,
    {
        let [q, slip] = [self.traction, self.slip].map(|vector| Self::at(vector, axes, index));
        let limit = Within::of_radius(norm(q));
        limit.measured(limit.motion(q), slip)
    }

    /// Forces upon cells that slip the tractions by which their limits grow.
    fn force<R, const N: usize>(
        &self,
        axes: [Axis; N],
        window: Window,
        changes: &ByApproach,
        system: &mut System<R, N>,
    ) {
        for (cell, i) in window.indices().enumerate() {
            let q = Self::at(self.traction, axes, i);
            let limit = norm(q);
            let slips = self.zones[i] == Zone::Slip && limit > 0.0;
            for (part, q) in system.forced.iter_mut().zip(q) {
                part[cell] = if slips {
                    changes.limits[i] * q / limit
                } else {
                    0.0
                };
            }
        }
    }

    /// Adds what cells displace themselves: a compliance of its own falls as the pressure grows.
    fn add_own<R: Row<N>, const N: usize>(
        &self,
        axes: [Axis; N],
        window: Window,
        changes: &ByApproach,
        system: &mut System<R, N>,
    ) {
        for (cell, i) in window.indices().enumerate() {
            let own = system.own(cell);
            if own > 0.0 {
                let q = Self::at(self.traction, axes, i);
                for (c, q) in q.into_iter().enumerate() {
                    let growth = system.forced[c][cell] - q * changes.relative[i];
                    system.displacement[c][cell] += own * growth;
                }
            }
        }
    }
}
