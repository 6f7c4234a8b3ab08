//! The stiffness of a contact that is solved.

use std::ops::ControlFlow;

use crate::error::{Result, positive};
use crate::grid::boundary::Boundary;
use crate::grid::window::Window;
use crate::half_space::HalfSpace;
use crate::normal::{Hardness, NormalSolution};
use crate::numerics::small_matrix::Small;
use crate::observer::{Observer, unwatched};
use crate::parallel;
use crate::report::Iteration;
use crate::stiffness::motions::kinds;
use crate::stiffness::normal::press;
use crate::stiffness::system::times;
use crate::stiffness::tangential::{LastStep, ShearedContact};
use crate::stiffness::workspace::LinearSolveContext;
use crate::stiffness::workspace::{Buffers, StiffnessWorkspace};
use crate::tangential::{Axis, Friction, TangentialSolution};

/// The normal stiffness of a contact.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub struct NormalStiffness {
    /// $`dW/d\delta_z`$ (a force over a length), zero without contact. Hertz: $`2 E^* a`$.
    pub value: f64,
    /// Bound of its relative error as the answer of the linear problem at these sets; infinite where pressure and traction are
    /// found together. The round-off of the products comes on top, and so does what the errors of the solution change.
    pub bound: f64,
}

/// The tangential stiffness of a contact: forces along x and y and the moment, by shifts along x and y and the twist.
///
/// Rows are loads, columns motions: forces over lengths in the upper left two by two, moments over radians in the last
/// place, forces (over radians) between. `None` of loads and motions that the model does not have: in the scalar model
/// what is across its axis and the twist, on grids that repeat the twist; and of a reversal that was
/// [left out](crate::stiffness::StiffnessWorkspace::reversal).
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub struct TangentialStiffness {
    /// Derivative of the force of the step with respect to the motion at the end of the step, if the motion continues in its
    /// direction. For a ball that is sheared under a constant normal load it is
    /// [Cattaneo's and Mindlin's](crate::analytical::CattaneoMindlin) $`8 G^* a\,(1 - F/\mu W)^{1/3}`$.
    ///
    /// Cells that came into contact in the step follow the motion with their [own
    /// compliance](crate::guide::load_steps). After a step that presses a ball from zero load, loading is therefore
    /// about two thirds of Mindlin's stiffness, although all cells stick. The stiffness of the next step is an
    /// [option](crate::stiffness::StiffnessWorkspace::next_step): there these cells resist fully.
    pub loading: [[Option<f64>; 3]; 3],
    /// If the motion reverses: all cells of the contact stick. Of a circle, by
    /// [Mindlin](crate::analytical::MindlinFullStick): $`8 G^* a`$.
    pub reversal: [[Option<f64>; 3]; 3],
    /// Bound of the errors: none is larger than this times the root of the product of the two entries on the diagonal,
    /// of the matrix for a twist about the centre of the contact. Infinite where pressure and traction are found together.
    /// As with [`NormalStiffness::bound`] round-off and the errors of the solution come on top.
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
    pub fn in_series_with(&self, springs: [f64; 2]) -> Result<Self> {
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
    /// resists without limit; [`Error::NotPositive`](crate::Error::NotPositive) for operators of a user without a lower bound;
    /// [`Error::NotConverged`](crate::Error::NotConverged); as [`HalfSpace::operator`];
    /// [`Error::Ranks`](crate::Error::Ranks).
    pub fn stiffness(&self, bodies: &HalfSpace) -> Result<NormalStiffness> {
        self.stiffness_observed(bodies, unwatched)
    }

    /// [`stiffness`](Self::stiffness) with an observer that is asked before every product with the operator and may
    /// cancel; the residual it sees is that of the linear problem under way.
    ///
    /// # Errors
    /// As [`stiffness`](Self::stiffness).
    pub fn stiffness_observed(
        &self,
        bodies: &HalfSpace,
        mut observer: impl FnMut(&Iteration) -> ControlFlow<()> + Send,
    ) -> Result<NormalStiffness> {
        let mut workspace = StiffnessWorkspace::new();
        let (mut course, Buffers { normal, growth, .. }) = workspace.begin(&mut observer);
        let on = (bodies, None);
        bodies.joint(parallel::enter_with(bodies.grid().cells(), || {
            press(on, self, None, normal, &mut course, growth)
        }))
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
    /// cancel; the residual it sees is that of the linear problem under way.
    ///
    /// # Errors
    /// As [`stiffness`](Self::stiffness).
    pub fn stiffness_observed(
        &self,
        bodies: &HalfSpace,
        mut observer: impl FnMut(&Iteration) -> ControlFlow<()> + Send,
    ) -> Result<TangentialStiffness> {
        let checked = self
            .check_bodies(bodies)
            .and_then(|()| self.check_uncoupled());
        bodies.collective_result(checked)?;
        let sheared = ShearedContact {
            zones: self.zones(),
            traction: self.traction(),
            last: LastStep::from_rest(self.grid(), self.slip()),
            window: None,
        };
        let mut workspace = StiffnessWorkspace::new();
        let (mut course, buffers) = workspace.begin(&mut observer);
        let found = parallel::enter_with(bodies.grid().cells(), || {
            sheared.stiffness(bodies, self.axis(), None, buffers, &mut course)
        });
        bodies.joint(found.map(|found| found.0))
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
    /// residual it sees is that of the linear problem under way.
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
        let checked = shear
            .check_bodies(bodies)
            .and_then(|()| shear.check_uncoupled());
        bodies.collective_result(checked)?;
        let sheared = ShearedContact {
            zones: shear.zones(),
            traction: shear.traction(),
            last: LastStep::from_rest(shear.grid(), shear.slip()),
            window: None,
        };
        let (axis, workspace) = (shear.axis(), &mut StiffnessWorkspace::new());
        let pressed = NormalContact::new(normal, friction);
        Self::of(bodies, &pressed, &sheared, axis, workspace, &mut observer)
    }

    pub(crate) fn of(
        bodies: &HalfSpace,
        pressed: &NormalContact<'_>,
        sheared: &ShearedContact<'_>,
        axis: Option<Axis>,
        workspace: &mut StiffnessWorkspace,
        observer: Observer<'_>,
    ) -> Result<Self> {
        bodies.collective_result(pressed.friction.check(bodies.grid()))?;
        workspace.check_alike(bodies)?;
        let (mut course, buffers) = workspace.begin(observer);
        bodies.joint(parallel::enter_with(bodies.grid().cells(), || {
            Self::found(bodies, pressed, sheared, axis, buffers, &mut course)
        }))
    }

    fn found(
        bodies: &HalfSpace,
        pressed: &NormalContact<'_>,
        sheared: &ShearedContact<'_>,
        axis: Option<Axis>,
        buffers: &mut Buffers,
        course: &mut LinearSolveContext<'_>,
    ) -> Result<Self> {
        let (contact, on) = (pressed.normal, (bodies, pressed.window));
        let Buffers { normal, growth, .. } = &mut *buffers;
        let normal = press(on, contact, pressed.hardness, normal, course, growth)?;
        let (tangential, by_approach) =
            sheared.stiffness(bodies, axis, Some(pressed), buffers, course)?;
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
    course: &mut LinearSolveContext<'_>,
) -> (TangentialStiffness, [Option<f64>; 3]) {
    let has = kinds(axis.map_or(Axis::BOTH, Axis::alone), boundary);
    let none = has.map(|has| has.then_some(0.0));
    let matrix = none.map(|of_load| none.map(|of_motion| of_load.and(of_motion)));
    let stiffness = TangentialStiffness {
        loading: matrix,
        reversal: if course.has_reversal {
            matrix
        } else {
            [[None; 3]; 3]
        },
        bound: 0.0,
    };
    course.finish_at_once();
    (stiffness, none)
}

/// What is known of a pressed contact.
#[derive(Clone, Copy)]
pub(crate) struct NormalContact<'a> {
    pub(crate) normal: &'a NormalSolution,
    /// Where it was found, if that is known.
    pub(crate) window: Option<Window>,
    pub(crate) friction: &'a Friction,
    pub(crate) hardness: Option<&'a Hardness>,
    /// Whether pressure moves the surfaces tangentially, and shear does not change it.
    pub(crate) is_drawn: bool,
}

impl<'a> NormalContact<'a> {
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

/// The window in which a contact was found, whose operators are at hand, or the smallest around it.
pub(super) fn window_of(bodies: &HalfSpace, found: Option<Window>, contact: Window) -> Window {
    let found = found.filter(|window| window.covers(contact));
    found.unwrap_or_else(|| bodies.restrict_to_window(contact))
}
