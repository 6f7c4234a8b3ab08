//! Sensitivities of solved problems.

use std::ops::ControlFlow;

use crate::contact::pressure_fingerprint::PressureFingerprint;
use crate::contact::{Contact, ResponseContext, Solver, with_counts_of};
use crate::error::Result;
use crate::grid::field::Field;
use crate::half_space::HalfSpace;
use crate::observer::{Observer, unwatched};
use crate::report::{Iteration, Report};
use crate::sensitivity::Functional;
use crate::stiffness::StiffnessWorkspace;

/// Derivatives of a functional at a solution, at fixed sets of cells.
///
/// A derivative is `None` if the problem does not have this input. Derivatives with respect to fields are per value of a cell,
/// and zero outside the contact.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub struct Sensitivity {
    /// Value J of the functional.
    pub value: f64,
    /// Derivative with respect to the gap of each cell.
    pub gap: Option<Field>,
    /// Derivative with respect to the pressure of each cell, for a tangential contact.
    pub pressure: Option<Field>,
    /// Derivative with respect to the prescribed normal force or approach.
    pub normal_load: Option<f64>,
    /// Derivatives with respect to the prescribed loads along x and y: forces, shifts, or positions of the far ends of springs.
    pub tangential_load: [Option<f64>; 2],
    /// Derivative with respect to the prescribed twist (per radian).
    pub twist: Option<f64>,
    /// Derivative with respect to the coefficient of friction of each cell. It is zero in cells that do not slip, and in cells
    /// at a [cap](crate::Friction::max_shear_stress).
    pub friction: Option<Field>,
    /// Derivative with respect to a uniform coefficient of friction, the sum over all cells.
    pub friction_coefficient: Option<f64>,
    /// Derivative with respect to the contact modulus E*, if all moduli of both bodies change in proportion at constant Poisson's
    /// ratios. `None` for steps of histories.
    pub contact_modulus: Option<f64>,
    /// Derivatives with respect to Poisson's ratio of each body at constant Young's moduli. `None` for coatings and kernels. For
    /// tangential and coupled contacts the field is also `None` on ranks and without the
    /// [option](StiffnessWorkspace::poisson_ratio).
    pub poisson_ratio: Option<[f64; 2]>,
    /// Report of the linear problem of this functional. The report excludes the responses to the prescribed forces, which all
    /// functionals share. [`StiffnessWorkspace::report`] includes them. The time is not measured.
    pub report: Report,
    /// Sums that identify the pressure under which the tractions were computed.
    pub(super) pressed: Option<PressureFingerprint>,
}

impl Sensitivity {
    /// Creates the sensitivity of a functional with this value, without derivatives.
    pub(super) fn of(value: f64) -> Self {
        Self {
            value,
            gap: None,
            pressure: None,
            normal_load: None,
            tangential_load: [None; 2],
            twist: None,
            friction: None,
            friction_coefficient: None,
            contact_modulus: None,
            poisson_ratio: None,
            report: Report::unsolved(),
            pressed: None,
        }
    }
}

/// Problem whose linearisation at fixed sets gives sensitivities.
pub(crate) trait Linearised: Contact {
    /// Computes the sensitivities of several functionals at a solution of the present problem.
    fn sensitivities(
        solver: &Solver<Self>,
        solution: &Self::Solution,
        functionals: &[Functional],
        workspace: &mut StiffnessWorkspace,
        observer: Observer<'_>,
    ) -> Result<Vec<Sensitivity>>;
}

#[expect(
    private_bounds,
    reason = "only problems of the crate have a linearisation"
)]
impl<P: Linearised> Solver<P> {
    /// Computes the derivatives of a functional with respect to the input of the problem (see
    /// [`sensitivity`](crate::sensitivity)). `solution` must be the solution of the present problem. The sets of cells are
    /// constant in the derivative.
    ///
    /// # Errors
    /// - [`Error::GridMismatch`](crate::Error::GridMismatch), [`Error::BoundaryMismatch`](crate::Error::BoundaryMismatch),
    ///   [`Error::CellValueMismatch`](crate::Error::CellValueMismatch) or
    ///   [`Error::MaterialMismatch`](crate::Error::MaterialMismatch) if the solution belongs to other bodies, or if weights have
    ///   a different grid.
    /// - [`Error::OutdatedSolution`](crate::Error::OutdatedSolution) if the solution belongs to an earlier load, gap, pressure,
    ///   friction or hardness of the solver. An earlier relative displacement is detected if any cell slips.
    /// - [`Error::NotConverged`](crate::Error::NotConverged) if the solution has not converged, or if a linear solve fails or is
    ///   cancelled.
    /// - [`Error::UnsupportedByModel`](crate::Error::UnsupportedByModel) if the functional depends on a quantity that the problem
    ///   does not have.
    /// - [`Error::BelowMinimum`](crate::Error::BelowMinimum), [`Error::NotFinite`](crate::Error::NotFinite) or
    ///   [`Error::Sample`](crate::Error::Sample) if a number of the functional is invalid.
    /// - [`Error::NotFinite`](crate::Error::NotFinite) if a periodic contact is closed everywhere, or if the contact cannot
    ///   resist a change of the prescribed force. Examples are sliding contacts and contacts without a cell below its hardness.
    /// - [`Error::EmptyContact`](crate::Error::EmptyContact) if no cell carries pressure under a prescribed force.
    /// - [`Error::Ranks`](crate::Error::Ranks) if ranks fail or pass different input.
    /// - The errors of [`HalfSpace::operator`].
    #[doc(alias = "adjoint")]
    #[doc(alias = "gradient")]
    #[doc(alias = "derivative")]
    pub fn sensitivity(
        &self,
        solution: &P::Solution,
        functional: &Functional,
    ) -> Result<Sensitivity> {
        let workspace = &mut StiffnessWorkspace::new();
        let functionals = std::slice::from_ref(functional);
        let mut found = self.sensitivities_with(solution, functionals, workspace, unwatched)?;
        // One functional has one sensitivity.
        Ok(found.remove(0))
    }

    /// Computes the [`sensitivity`](Self::sensitivity) of several functionals, in their order. The functionals share the
    /// responses to the prescribed forces.
    ///
    /// # Errors
    /// The errors of [`sensitivity`](Self::sensitivity).
    pub fn sensitivities(
        &self,
        solution: &P::Solution,
        functionals: &[Functional],
    ) -> Result<Vec<Sensitivity>> {
        self.sensitivities_with(
            solution,
            functionals,
            &mut StiffnessWorkspace::new(),
            unwatched,
        )
    }

    /// Computes the [`sensitivities`](Self::sensitivities) with the tolerance and the buffers of a workspace, and with an
    /// observer. The observer is called before every product with an operator and may cancel. The report of the workspace
    /// contains the sums over all functionals.
    ///
    /// # Errors
    /// The errors of [`sensitivity`](Self::sensitivity).
    pub fn sensitivities_with(
        &self,
        solution: &P::Solution,
        functionals: &[Functional],
        workspace: &mut StiffnessWorkspace,
        mut observer: impl FnMut(&Iteration) -> ControlFlow<()> + Send,
    ) -> Result<Vec<Sensitivity>> {
        P::sensitivities(self, solution, functionals, workspace, &mut observer)
    }
}

/// Checks functionals together with another check of the input, on all ranks.
pub(super) fn check_functionals(
    bodies: &HalfSpace,
    (has_approach, has_shear): (bool, bool),
    functionals: &[Functional],
    checked: Result<()>,
) -> Result<()> {
    let mut all = functionals.iter();
    let checked =
        checked.and_then(|()| all.try_for_each(|one| one.check(bodies, has_approach, has_shear)));
    let common: Vec<Functional> = functionals.iter().map(Functional::common).collect();
    bodies.collective_result_checked(checked, &[("functionals", &common)])
}

/// Computes the result of one functional with its own report, which is added to the report of the context.
pub(super) fn with_own_report<T>(
    context: &mut ResponseContext<'_>,
    report: &mut Report,
    work: impl FnOnce(&mut ResponseContext<'_>) -> Result<T>,
) -> Result<T> {
    let mut observer = with_counts_of(context.report, &mut *context.observer);
    let mut own = ResponseContext {
        tolerance: context.tolerance,
        report,
        observer: &mut observer,
    };
    let outcome = work(&mut own);
    drop(observer);
    context.report.add_pass(report);
    outcome
}
