//! Stiffness of a solved contact.

use std::ops::ControlFlow;

use crate::contact::ResponseContext;
use crate::error::{Error, Result, check_converged, positive};
use crate::half_space::HalfSpace;
use crate::normal::NormalSolution;
use crate::numerics::agreement::tolerance_of;
use crate::numerics::small_matrix::Small;
use crate::observer::{Observer, unwatched};
use crate::parallel;
use crate::report::Iteration;
use crate::stiffness::contact::{Pressing, SolvedContact};
use crate::stiffness::motions::kinds;
use crate::stiffness::system::times;
use crate::stiffness::workspace::{StiffnessWorkspace, SystemBuffers};
use crate::tangential::{Axis, Friction, TangentialSolution};

/// Normal stiffness of a contact.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub struct NormalStiffness {
    /// Derivative $`dW/d\delta_z`$ (a force over a length), zero without contact. Hertz: $`2 E^* a`$.
    pub value: f64,
    /// Bound on the relative error of the solution of the linear problem at these sets. The bound is infinite if pressure and
    /// traction are coupled. It does not include the round-off of the products, nor the effect of the errors of the contact
    /// solution.
    pub bound: f64,
}

/// Tangential stiffness of a contact. It consists of the derivatives of the forces along x and y and the moment. The derivatives
/// are with respect to the shifts along x and y and the twist.
///
/// Rows are loads, and columns are motions. The entries of the upper left 2 x 2 block are forces over lengths. The last diagonal
/// entry is a moment over radians. The other entries are forces (over radians). Entries are `None` for loads and motions that the
/// model does not have. The scalar model has neither the direction across its axis nor the twist. Periodic grids have no twist.
/// The entries of a reversal that was [left out](crate::stiffness::StiffnessWorkspace::reversal) are also `None`.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub struct TangentialStiffness {
    /// Derivative of the force of the step with respect to the motion at the end of the step, if the motion continues in its
    /// direction. For a ball sheared under a constant normal load, it is the stiffness of [Cattaneo and
    /// Mindlin](crate::analytical::CattaneoMindlin), $`8 G^* a\,(1 - F/\mu W)^{1/3}`$.
    ///
    /// Cells that came into contact in the step follow the motion with their [entry compliance](crate::guide::load_steps). After
    /// a step that presses a ball from zero load, all cells stick. The loading stiffness is nevertheless about two thirds of
    /// Mindlin's stiffness, because of the entry compliance. In the stiffness of the next step, these cells have no entry
    /// compliance ([option](crate::stiffness::StiffnessWorkspace::next_step)).
    pub loading: [[Option<f64>; 3]; 3],
    /// Stiffness if the motion reverses, so that all cells of the contact stick. For a circular contact, this stiffness is
    /// [Mindlin's](crate::analytical::MindlinFullStick) $`8 G^* a`$.
    pub reversal: [[Option<f64>; 3]; 3],
    /// Bound on the errors of the entries. No error exceeds this bound times the square root of the product of the two diagonal
    /// entries. The bound holds for the matrix with the twist about the centre of the contact. The bound is infinite if pressure
    /// and traction are coupled. As with [`NormalStiffness::bound`], round-off and the errors of the contact solution are not
    /// included.
    pub bound: f64,
}

/// Stiffness of a contact in all directions.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub struct ContactStiffness {
    /// Derivative of the normal force with respect to the approach.
    pub normal: NormalStiffness,
    /// Derivatives of the tangential forces and the moment with respect to shift and twist.
    pub tangential: TangentialStiffness,
    /// Derivatives of the tangential forces (over a length) and the moment (a force) with respect to the approach while slip
    /// continues. They follow from the friction limit of the slipping cells and, in a history, from the lag of the cells that
    /// came into contact in the step. They are valid if the shift grows in the same step or if the approach decreases. If the
    /// bodies are pressed further at a constant shift, these cells stick and the derivative is zero.
    ///
    /// The entries have no error bound. They follow from a change of the pressure. The relative error of this change in the
    /// energy norm is at most the square root of the bound of `normal`. For problems with [one-way
    /// coupling](crate::Coupling::OneWay) the entries exclude the tangential displacement caused by the pressure, which steps of
    /// histories include. An entry is `None` for a load that the model does not have.
    pub by_approach: [Option<f64>; 3],
    /// Derivatives of the normal force with respect to the shifts along x and y (a force over a length) and the twist (a force).
    /// The entries are zero unless pressure and shear are coupled. An entry is `None` for a motion that the model does not have.
    pub normal_by_motion: [Option<f64>; 3],
}

impl NormalStiffness {
    /// Stiffness without contact.
    pub(super) const NONE: Self = Self {
        value: 0.0,
        bound: 0.0,
    };
}

impl TangentialStiffness {
    /// Returns the stiffness in series with springs along x and y, $`(K^{-1} + k^{-1})^{-1}`$. It consists of the derivatives of
    /// forces and moment with respect to the motion of the far ends of the springs and the twist. The stiffnesses of the springs
    /// are forces over lengths.
    ///
    /// # Errors
    /// - [`Error::NotPositive`] if the stiffness of a spring is not positive.
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

impl TangentialSolution {
    /// Returns an error unless the solution belongs to the pressure of this normal contact and this friction.
    pub(super) fn check_limits(
        &self,
        bodies: &HalfSpace,
        normal: &NormalSolution,
        friction: &Friction,
    ) -> Result<()> {
        let belongs = parallel::enter_with(bodies.grid().cells(), || {
            let pressure = normal.pressure().as_slice();
            let tolerance = tolerance_of(&[self.report(), normal.report()]);
            self.belongs_to(&bodies.grid_layout(), pressure, friction, tolerance)
        });
        let outdated = Error::OutdatedSolution {
            quantity: "stiffness",
            changed: "the pressure or the friction",
            remedy: "solve the tangential contact with the pressure and the friction of the stiffness",
        };
        bodies.joint(if belongs { Ok(()) } else { Err(outdated) })
    }
}

impl NormalSolution {
    /// Computes the normal stiffness $`dW/d\delta_z`$ with one linear solve on the cells of the contact.
    ///
    /// The set of contact cells is fixed, so the stiffness jumps when a cell comes into contact. The result is the stiffness of a
    /// contact whose edge follows the cell sides. On a periodic grid the approach is the approach of the mean planes.
    ///
    /// # Errors
    /// - [`Error::GridMismatch`], [`Error::BoundaryMismatch`] or [`Error::MaterialMismatch`] if the solution belongs to
    ///   other bodies.
    /// - [`Error::CoupledMaterials`] for the normal half of a coupled solution of dissimilar bodies, whose pressure
    ///   also depends on the shear.
    /// - [`Error::NotFinite`] if a periodic contact is closed everywhere, because its resistance is
    ///   unbounded.
    /// - [`Error::NotPositive`] for a user-defined operator without a lower bound.
    /// - [`Error::NotConverged`] for a solution that has not been solved, or if the linear solve fails or is cancelled.
    /// - [`Error::Ranks`] if ranks fail or pass different input.
    /// - The errors of [`HalfSpace::operator`].
    pub fn stiffness(&self, bodies: &HalfSpace) -> Result<NormalStiffness> {
        self.stiffness_observed(bodies, unwatched)
    }

    /// Computes the [`stiffness`](Self::stiffness) with an observer. The observer is called before every product with the
    /// operator and may cancel. The reported residual is the residual of the current linear problem.
    ///
    /// # Errors
    /// The errors of [`stiffness`](Self::stiffness).
    pub fn stiffness_observed(
        &self,
        bodies: &HalfSpace,
        mut observer: impl FnMut(&Iteration) -> ControlFlow<()> + Send,
    ) -> Result<NormalStiffness> {
        bodies.collective_result(check_converged(self.report()))?;
        let contact = SolvedContact::of(bodies);
        let mut workspace = StiffnessWorkspace::new();
        let (mut context, SystemBuffers { normal, cells, .. }) = workspace.begin(&mut observer);
        bodies.joint(parallel::enter_with(bodies.grid().cells(), || {
            contact.press(self, normal, cells, &mut context)
        }))
    }
}

impl TangentialSolution {
    /// Computes the tangential stiffness with one linear solve for each motion of the model and each of the two sets of cells.
    ///
    /// The loading stiffness is the derivative of the loads with respect to the motions as the load continues. In the vector
    /// model it includes the resistance of the slip of the step to a rotation of the tractions. On grids that are not periodic,
    /// the vector model also has the twist.
    ///
    /// # Errors
    /// - [`Error::GridMismatch`], [`Error::BoundaryMismatch`], [`Error::CellValueMismatch`] or
    ///   [`Error::MaterialMismatch`] if the solution belongs to other bodies.
    /// - [`Error::CoupledMaterials`] for the tangential half of a coupled solution of dissimilar bodies.
    /// - [`Error::NotFinite`] if a periodic contact is closed everywhere.
    /// - [`Error::NotConverged`] for a solution that has not been solved, or if a linear solve fails or is cancelled.
    /// - [`Error::Ranks`] if ranks fail or pass different input.
    /// - The errors of [`HalfSpace::operator`].
    pub fn stiffness(&self, bodies: &HalfSpace) -> Result<TangentialStiffness> {
        self.stiffness_observed(bodies, unwatched)
    }

    /// Computes the [`stiffness`](Self::stiffness) with an observer. The observer is called before every product with the
    /// operator and may cancel. The reported residual is the residual of the current linear problem.
    ///
    /// # Errors
    /// The errors of [`stiffness`](Self::stiffness).
    pub fn stiffness_observed(
        &self,
        bodies: &HalfSpace,
        mut observer: impl FnMut(&Iteration) -> ControlFlow<()> + Send,
    ) -> Result<TangentialStiffness> {
        let checked = self
            .check_bodies(bodies)
            .and_then(|()| self.check_uncoupled())
            .and_then(|()| check_converged(self.report()));
        bodies.collective_result(checked)?;
        let contact = SolvedContact::sheared(bodies, self);
        let mut workspace = StiffnessWorkspace::new();
        let (mut context, buffers) = workspace.begin(&mut observer);
        let found = parallel::enter_with(bodies.grid().cells(), || {
            contact.shear(None, buffers, &mut context)
        });
        bodies.joint(found.map(|found| found.0))
    }
}

impl ContactStiffness {
    /// Computes the stiffness of a contact that was pressed and sheared from rest with this friction. `normal` must be the solution
    /// from which the tangential problem took its pressure.
    ///
    /// # Errors
    /// - [`Error::GridMismatch`] if the friction has a different grid.
    /// - [`Error::OutdatedSolution`] if `shear` was computed for a different pressure or friction. Its contact cells or
    ///   its tractions in slipping cells then do not match `normal` and `friction`.
    /// - The errors of [`NormalSolution::stiffness`] and [`TangentialSolution::stiffness`].
    pub fn new(
        bodies: &HalfSpace,
        normal: &NormalSolution,
        friction: &Friction,
        shear: &TangentialSolution,
    ) -> Result<Self> {
        Self::observed(bodies, normal, friction, shear, unwatched)
    }

    /// Computes the stiffness like [`new`](Self::new), with an observer. The observer is called before every product with an
    /// operator and may cancel. The reported residual is the residual of the current linear problem.
    ///
    /// # Errors
    /// The errors of [`new`](Self::new).
    pub fn observed(
        bodies: &HalfSpace,
        normal: &NormalSolution,
        friction: &Friction,
        shear: &TangentialSolution,
        mut observer: impl FnMut(&Iteration) -> ControlFlow<()> + Send,
    ) -> Result<Self> {
        let checked = shear
            .check_bodies(bodies)
            .and_then(|()| shear.check_uncoupled())
            .and_then(|()| check_converged(normal.report()))
            .and_then(|()| check_converged(shear.report()))
            .and_then(|()| normal.check_bodies(bodies))
            .and_then(|()| normal.check_uncoupled())
            .and_then(|()| friction.check(bodies.grid()));
        bodies.collective_result(checked)?;
        shear.check_limits(bodies, normal, friction)?;
        let contact = SolvedContact::sheared(bodies, shear);
        let workspace = &mut StiffnessWorkspace::new();
        contact.stiffness((normal, friction), workspace, &mut observer)
    }
}

impl SolvedContact<'_> {
    /// Computes the stiffness in all directions of a contact whose pressure does not depend on the shear.
    pub(crate) fn stiffness(
        &self,
        pressing: Pressing<'_>,
        workspace: &mut StiffnessWorkspace,
        observer: Observer<'_>,
    ) -> Result<ContactStiffness> {
        let (bodies, (normal, friction)) = (self.bodies, pressing);
        bodies.collective_result(friction.check(bodies.grid()))?;
        workspace.check_alike(bodies)?;
        let (mut context, buffers) = workspace.begin(observer);
        bodies.joint(parallel::enter_with(bodies.grid().cells(), || {
            let SystemBuffers {
                normal: slot,
                cells,
                ..
            } = &mut *buffers;
            let normal = self.press(normal, slot, cells, &mut context)?;
            let (tangential, by_approach) = self.shear(Some(pressing), buffers, &mut context)?;
            Ok(ContactStiffness {
                normal,
                normal_by_motion: by_approach.map(|load| load.map(|_| 0.0)),
                tangential,
                by_approach,
            })
        }))
    }

    /// Returns zero entries for the loads and motions of a model with tractions along an axis, or along both axes.
    pub(super) fn without_contact(
        &self,
        axis: Option<Axis>,
        has_reversal: bool,
        context: &mut ResponseContext<'_>,
    ) -> (TangentialStiffness, [Option<f64>; 3]) {
        let axes = axis.map_or(Axis::BOTH, Axis::alone);
        let none = kinds(axes, self.bodies.boundary()).map(|has| has.then_some(0.0));
        let matrix = none.map(|of_load| none.map(|of_motion| of_load.and(of_motion)));
        context.finish_at_once();
        let stiffness = TangentialStiffness {
            loading: matrix,
            reversal: if has_reversal { matrix } else { [[None; 3]; 3] },
            bound: 0.0,
        };
        (stiffness, none)
    }
}
