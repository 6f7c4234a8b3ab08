//! The stiffness of a contact that is solved.

use std::ops::ControlFlow;

use crate::boundary::Boundary;
use crate::buffer;
use crate::cgm::small::Small;
use crate::error::{Result, positive};
use crate::field::Field;
use crate::half_space::HalfSpace;
use crate::influence::{Component, Direction};
use crate::normal::{Hardness, NormalSolution};
use crate::operator::Operator;
use crate::parallel;
use crate::report::Iteration;
use crate::stiffness::motions::{Motions, kinds};
use crate::stiffness::press::{pressed, stiffness_of};
use crate::stiffness::system::{Freedom, Stiffness, System, Vector, times};
use crate::tangential::{Axis, Friction, TangentialSolution, Zone};
use crate::watch::{Observer, Watch, unwatched};
use crate::window::Window;

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
        let press = parallel::enter_with(bodies.grid().cells(), || {
            pressed(bodies, self, None, &mut Watch::new(&mut observer))
        });
        Ok(stiffness_of(press?.as_ref()))
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
        };
        let found = parallel::enter_with(bodies.grid().cells(), || {
            let watch = &mut Watch::new(&mut observer);
            sheared.stiffness(bodies, self.axis(), None, watch)
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
        };
        let axis = shear.axis();
        let pressed = Pressed::new(normal, friction);
        Self::of(bodies, &pressed, &sheared, axis, &mut observer)
    }

    pub(crate) fn of(
        bodies: &HalfSpace,
        pressed: &Pressed<'_>,
        sheared: &Sheared<'_>,
        axis: Option<Axis>,
        observer: Observer<'_>,
    ) -> Result<Self> {
        pressed.friction.check(bodies.grid())?;
        parallel::enter_with(bodies.grid().cells(), || {
            let watch = &mut Watch::new(observer);
            Self::watched(bodies, pressed, sheared, axis, watch)
        })
    }

    fn watched(
        bodies: &HalfSpace,
        contact: &Pressed<'_>,
        sheared: &Sheared<'_>,
        axis: Option<Axis>,
        watch: &mut Watch<'_>,
    ) -> Result<Self> {
        let Pressed {
            normal,
            friction,
            hardness,
            is_drawn,
        } = *contact;
        let press = pressed(bodies, normal, hardness, watch)?;
        let zeros = || buffer::zeros(bodies.grid().cells());
        let mut changes = ByApproach {
            limits: zeros()?,
            relative: zeros()?,
            pressure: zeros()?,
            is_drawn,
        };
        if let Some(press) = &press {
            let pressure = normal.pressure().as_slice();
            for (i, growth) in press.window.indices().zip(&press.growth) {
                if pressure[i] > 0.0 {
                    changes.limits[i] = friction.slope(i, pressure[i]) * growth;
                    changes.relative[i] = (growth / pressure[i]).clamp(-f64::MAX, f64::MAX);
                    changes.pressure[i] = *growth;
                }
            }
        }
        let (tangential, by_approach) = sheared.stiffness(bodies, axis, Some(&changes), watch)?;
        Ok(Self {
            normal: stiffness_of(press.as_ref()),
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
    let kinds = kinds(axis.map_or(Axis::BOTH, Axis::alone), boundary);
    let none = [0, 1, 2].map(|kind| kinds.contains(&kind).then_some(0.0));
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
            friction,
            hardness: None,
            is_drawn: false,
        }
    }
}

/// Adds the tangential displacement that pressures of the grid cause in the cells of a window.
fn add_drawn<const N: usize>(
    bodies: &HalfSpace,
    axes: [Axis; N],
    window: Window,
    pressure: &[f64],
    displacement: &mut Vector<N>,
) -> Result<()> {
    let mut inside = buffer::zeros(window.cells())?;
    window.gather(pressure, &mut inside);
    let mut drawn = buffer::zeros(window.cells())?;
    for (part, axis) in displacement.iter_mut().zip(axes) {
        let component = Component::of(axis.direction(), Direction::Z);
        let operator = bodies.convolution([[component]], window.size)?;
        let mut workspace = operator.try_workspace()?;
        operator.apply([&inside], [&mut drawn], &mut workspace);
        for (u, drawn) in part.iter_mut().zip(&drawn) {
            *u += drawn;
        }
    }
    Ok(())
}

/// What is known of a sheared contact.
pub(crate) struct Sheared<'a> {
    pub(crate) zones: &'a [Zone],
    pub(crate) traction: [&'a Field; 2],
    /// Slip of the step.
    pub(crate) slip: [&'a Field; 2],
    /// Compliance of their own of the cells that entered the contact in the step; of no cells where none did.
    pub(crate) entered: &'a [f64],
}

/// What the approach changes in the cells of the grid, for each unit.
struct ByApproach {
    /// The friction limits.
    limits: Vec<f64>,
    /// The pressures, each over itself.
    relative: Vec<f64>,
    pressure: Vec<f64>,
    /// Whether pressure moves the surfaces tangentially.
    is_drawn: bool,
}

impl Sheared<'_> {
    /// The stiffness; and the loads by the approach, if what that changes is given.
    fn stiffness(
        &self,
        bodies: &HalfSpace,
        axis: Option<Axis>,
        changes: Option<&ByApproach>,
        watch: &mut Watch<'_>,
    ) -> Result<(TangentialStiffness, [Option<f64>; 3])> {
        let grid = bodies.grid();
        let Some(window) = Window::around(grid, |i| self.zones[i] != Zone::Separated) else {
            return Ok(without_contact(axis, bodies.boundary()));
        };
        let window = bodies.confined(window);
        match axis {
            Some(axis) => self.along(bodies, window, [axis], changes, watch),
            None => self.along(bodies, window, [Axis::X, Axis::Y], changes, watch),
        }
    }

    fn along<const N: usize>(
        &self,
        bodies: &HalfSpace,
        window: Window,
        axes: [Axis; N],
        changes: Option<&ByApproach>,
        watch: &mut Watch<'_>,
    ) -> Result<(TangentialStiffness, [Option<f64>; 3])> {
        let grid = bodies.grid();
        let compliance = bodies.compliance(axes.map(Axis::direction), window.size)?;
        let sticking = |i: usize| match self.zones[i] {
            Zone::Separated => Freedom::Fixed,
            // What carries nothing at its limit never sticks.
            Zone::Slip if self.traction.iter().all(|q| q.as_slice()[i] == 0.0) => Freedom::Fixed,
            Zone::Stick | Zone::Slip => Freedom::Free,
        };
        let slipping = |i: usize| match self.zones[i] {
            Zone::Slip => self.turning(axes, i),
            _ => sticking(i),
        };
        let touches = |i: usize| self.zones[i] != Zone::Separated;
        let motions = Motions::new(grid, window, axes, bodies.boundary(), touches)?;
        let area = grid.cell_area();
        let boundary = bodies.boundary();
        let freedoms = buffer::collected(window.cells(), window.indices().map(sticking))?;
        let reversal = System::new(boundary, &compliance, freedoms, Vec::new())?;
        let reversal = reversal.stiffness(&motions.cells, watch)?;
        let freedoms = buffer::collected(window.cells(), window.indices().map(slipping))?;
        let own = match self.entered {
            [] => Vec::new(),
            entered => buffer::collected(window.cells(), window.indices().map(|i| entered[i]))?,
        };
        let loading = System::new(boundary, &compliance, freedoms, own)?;
        let found = loading.stiffness(&motions.cells, watch)?;
        let mut by_approach = [None; 3];
        if let Some(changes) = changes {
            let forced = self.forced(axes, window, &changes.limits)?;
            let mut displacement = loading.displacement(&forced, watch)?;
            if changes.is_drawn {
                add_drawn(bodies, axes, window, &changes.pressure, &mut displacement)?;
            }
            // A compliance of its own falls as the pressure grows.
            for (k, i) in window.indices().enumerate() {
                let q = Self::at(self.traction, axes, i);
                for ((u, forced), q) in displacement.iter_mut().zip(&forced).zip(q) {
                    let own = loading.own(k);
                    if own > 0.0 {
                        u[k] += own * (forced[k] - q * changes.relative[i]);
                    }
                }
            }
            let own = motions
                .cells
                .iter()
                .map(|motion| loading.product(motion, &forced));
            let mut loads = loading.reaction(&found, &displacement);
            for (load, own) in loads.iter_mut().zip(own) {
                *load += own;
            }
            by_approach = motions
                .loads(loads)
                .map(|load| load.map(|load| load * area));
        }
        let whole = |stiffness: &Stiffness<N>| {
            motions
                .matrix(&stiffness.matrix)
                .map(|row| row.map(|entry| entry.map(|entry| entry * area)))
        };
        let stiffness = TangentialStiffness {
            loading: whole(&found),
            reversal: whole(&reversal),
            bound: found.bound.max(reversal.bound),
        };
        Ok((stiffness, by_approach))
    }

    fn at<const N: usize>(vector: [&Field; 2], axes: [Axis; N], index: usize) -> [f64; N] {
        axes.map(|axis| vector[axis.index()].as_slice()[index])
    }

    /// What a cell that slips may do: nothing along one axis, turn in the plane.
    fn turning<const N: usize>(&self, axes: [Axis; N], index: usize) -> Freedom<N> {
        let [q, slip] = [self.traction, self.slip].map(|vector| Self::at(vector, axes, index));
        let length = |v: [f64; N]| v.iter().fold(0.0_f64, |sum, v| sum.hypot(*v));
        let limit = length(q);
        if N == 1 || limit <= 0.0 {
            return Freedom::Fixed;
        }
        let mut tangent = [0.0; N];
        (tangent[0], tangent[N - 1]) = (-q[N - 1] / limit, q[0] / limit);
        Freedom::Along {
            tangent,
            stiffness: length(slip) / limit,
        }
    }

    /// The tractions of cells that slip, when their limits grow so.
    fn forced<const N: usize>(
        &self,
        axes: [Axis; N],
        window: Window,
        limits: &[f64],
    ) -> Result<Vector<N>> {
        let mut forced: Vector<N> = buffer::vector(window.cells())?;
        for (k, i) in window.indices().enumerate() {
            let q = Self::at(self.traction, axes, i);
            let limit = q.iter().fold(0.0_f64, |sum, q| sum.hypot(*q));
            if self.zones[i] == Zone::Slip && limit > 0.0 {
                for (part, q) in forced.iter_mut().zip(q) {
                    part[k] = limits[i] * q / limit;
                }
            }
        }
        Ok(forced)
    }
}
