//! Reports, iterations and warnings as objects with a readable `repr`.

use std::hash::{DefaultHasher, Hash, Hasher};
use std::time::Duration;

use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::types::PyString;

use crate::choice::Choice;
use crate::digits::{counted, in_python, rough};
use crate::pickle::picklable;
use crate::readers::{readers, record};

/// One step of an iteration, as passed to a progress callback.
///
/// The residual and the number of free entries are the most recently measured values.
#[pyclass(frozen, eq, module = "stickslip")]
#[derive(Clone, Copy, PartialEq)]
pub(crate) struct Iteration(pub(crate) stickslip::Iteration);

readers! { Iteration.0:
    /// Number of conjugate-gradient steps so far.
    iteration: usize,
    /// Number of products with the operator in double precision so far.
    double_precision_products: usize,
    /// Number of products in single precision so far.
    single_precision_products: usize,
    /// Largest complementarity residual, relative to the largest displacement.
    residual: f64,
    /// Number of entries strictly between their bounds: contact cells, or cells that stick.
    free: usize,
}

#[pymethods]
impl Iteration {
    fn __repr__(&self) -> String {
        format!(
            "Iteration(iteration={}, residual={}, free={})",
            self.0.iteration,
            rough(self.0.residual),
            self.0.free
        )
    }
}

picklable!(Iteration: stickslip::Iteration);

/// Termination, cost and error bound of a solve.
///
/// All error measures are recomputed from a fresh product with the returned iterate, whatever the status.
#[pyclass(frozen, eq, module = "stickslip")]
#[derive(Clone, PartialEq)]
pub(crate) struct Report(pub(crate) stickslip::Report);

impl Report {
    pub(crate) fn of(report: &stickslip::Report) -> Self {
        Self(report.clone())
    }
}

readers! { Report.0:
    /// Reason for the end of the iteration.
    status: Choice<stickslip::Status> => Choice,
    /// Number of conjugate-gradient steps.
    iterations: usize,
    /// Number of products with the operator in double precision, including the final check.
    double_precision_products: usize,
    /// Number of products in single precision.
    single_precision_products: usize,
    /// Number of products in both precisions.
    products(): usize,
    /// Largest complementarity residual, relative to the largest displacement.
    residual: f64,
    /// Certified bound on the squared relative error in the energy norm.
    duality_gap: f64,
    /// Certified bound on the relative error in the energy norm, the square root of the duality gap.
    /// On a periodic grid under a prescribed approach or shift, the bound is relative to the contact under the computed
    /// force and excludes the error of this force.
    energy_error_bound(): f64,
    /// Origin of the bound on the smallest eigenvalue, on which :attr:`duality_gap` depends.
    ///
    /// "proven" is a computed bound. "stated" is given by the caller with a user-defined operator. "estimated" is an estimate
    /// on the safe side, for stiff coatings on long grids. With "unknown", no bound is available, and the error bound
    /// decreases only with the square root of the residual.
    eigenvalue_bound: Choice<stickslip::EigenvalueBound> => Choice,
    /// Relative error of the prescribed total; zero if no total is prescribed.
    load_error: f64,
    /// Whether the tolerance was reached.
    is_converged(): bool,
}

#[pymethods]
impl Report {
    /// Wall time of the solve (s).
    #[getter]
    fn time(&self) -> f64 {
        Duration::as_secs_f64(&self.0.time)
    }

    /// All iterates whose residual was measured, in order.
    #[getter]
    fn history(&self) -> Vec<Iteration> {
        self.0.history.iter().copied().map(Iteration).collect()
    }

    fn __repr__(&self, py: Python<'_>) -> PyResult<String> {
        Ok(format!("Report({})", in_python(py, &self.0.to_string())?))
    }
}

picklable!(Report: stickslip::Report);

record!(Report: status, iterations, double_precision_products, single_precision_products, products, residual,
    duality_gap, energy_error_bound, eigenvalue_bound, load_error, time, is_converged);

/// A warning about a converged solution that might mislead.
///
/// The attribute ``kind`` is the name of the warning: ``no_contact``, ``contact_at_edge``, ``unresolved_spots``,
/// ``single_row_of_cells``, ``contact_spans_grid``, ``beyond_hardness``, ``stale_pressure``, ``underresolved_contact``,
/// ``underresolved_stick_zone``, ``underresolved_slip_zone``, ``single_load_step``, ``stress_at_edge``,
/// ``discretisation_error``, ``approach_beyond_grid``, ``shift_beyond_grid``,
/// ``large_bulk_strain``, ``large_twist``, ``large_creepage``, ``large_friction``, ``low_hardness``,
/// ``hardness_beyond_modulus``, ``low_shear_stress``, ``shear_stress_beyond_modulus``, ``low_pressure``,
/// ``large_gap_change``, ``closed_gap``, ``negative_wear``, ``large_contact_radius``, ``pressure_beyond_modulus``, ``periodic_seam``,
/// ``not_converged``, ``steep_surface``, ``held_shift_lost_force``, ``unused_relative_displacement``,
/// ``repeated_loop``, ``open_cycle``, ``neglected_lift``, ``neglected_traction``, ``coating_beyond_grid``,
/// ``coating_below_cell`` or ``accuracy_not_reached``. The names of the warnings of a solution are ``[warning.kind
/// for warning in solution.warnings]``. A comparison of a warning with a string raises a ``ValueError``.
#[pyclass(frozen, module = "stickslip")]
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) struct Warning(pub(crate) stickslip::Warning);

impl Warning {
    pub(crate) fn all(warnings: Vec<stickslip::Warning>) -> Vec<Self> {
        warnings.into_iter().map(Self).collect()
    }
}

#[pymethods]
impl Warning {
    /// Name of the warning.
    #[getter]
    fn kind(&self) -> &'static str {
        use stickslip::Warning as W;
        match self.0 {
            W::NoContact => "no_contact",
            W::ContactAtEdge { .. } => "contact_at_edge",
            W::UnresolvedSpots { .. } => "unresolved_spots",
            W::SingleRowOfCells => "single_row_of_cells",
            W::ContactSpansGrid { .. } => "contact_spans_grid",
            W::BeyondHardness { .. } => "beyond_hardness",
            W::StalePressure => "stale_pressure",
            W::UnderresolvedContact { .. } => "underresolved_contact",
            W::UnderresolvedStickZone { .. } => "underresolved_stick_zone",
            W::UnderresolvedSlipZone { .. } => "underresolved_slip_zone",
            W::SingleLoadStep => "single_load_step",
            W::StressAtEdge => "stress_at_edge",
            W::DiscretisationError { .. } => "discretisation_error",
            W::ApproachBeyondGrid { .. } => "approach_beyond_grid",
            W::ShiftBeyondGrid { .. } => "shift_beyond_grid",
            W::LargeBulkStrain { .. } => "large_bulk_strain",
            W::LargeTwist { .. } => "large_twist",
            W::LargeCreepage { .. } => "large_creepage",
            W::LargeFriction { .. } => "large_friction",
            W::LowHardness { .. } => "low_hardness",
            W::HardnessBeyondModulus { .. } => "hardness_beyond_modulus",
            W::ShearStressBeyondModulus { .. } => "shear_stress_beyond_modulus",
            W::LowShearStress { .. } => "low_shear_stress",
            W::LowPressure { .. } => "low_pressure",
            W::LargeGapChange { .. } => "large_gap_change",
            W::ClosedGap { .. } => "closed_gap",
            W::NegativeWear { .. } => "negative_wear",
            W::LargeContactRadius { .. } => "large_contact_radius",
            W::PressureBeyondModulus { .. } => "pressure_beyond_modulus",
            W::PeriodicSeam { .. } => "periodic_seam",
            W::NotConverged => "not_converged",
            W::SteepSurface { .. } => "steep_surface",
            W::HeldShiftLostForce { .. } => "held_shift_lost_force",
            W::UnusedRelativeDisplacement => "unused_relative_displacement",
            W::RepeatedLoop => "repeated_loop",
            W::OpenCycle { .. } => "open_cycle",
            W::NeglectedTraction { .. } => "neglected_traction",
            W::NeglectedLift { .. } => "neglected_lift",
            W::CoatingBeyondGrid { .. } => "coating_beyond_grid",
            W::CoatingBelowCell { .. } => "coating_below_cell",
            W::AccuracyNotReached { .. } => "accuracy_not_reached",
            _ => "other",
        }
    }

    /// Number of affected cells; ``None`` if the warning does not count cells.
    #[getter]
    fn cells(&self) -> Option<usize> {
        use stickslip::Warning as W;
        match self.0 {
            W::ContactAtEdge { cells }
            | W::BeyondHardness { cells }
            | W::ClosedGap { cells }
            | W::NegativeWear { cells }
            | W::UnderresolvedContact { cells }
            | W::UnderresolvedStickZone { cells } => Some(cells),
            _ => None,
        }
    }

    /// Text of the warning, with a remedy.
    #[getter]
    fn message(&self) -> String {
        self.0.to_string()
    }

    fn __eq__(&self, other: &Bound<'_, PyAny>) -> PyResult<bool> {
        if other.is_instance_of::<PyString>() {
            return Err(PyValueError::new_err(
                "a warning is not a string: compare its name, as in \
                 'contact_at_edge' in [warning.kind for warning in solution.warnings]",
            ));
        }
        Ok(other.cast::<Self>().is_ok_and(|other| self == other.get()))
    }

    /// Equal warnings have equal hashes.
    fn __hash__(&self) -> u64 {
        let mut hasher = DefaultHasher::new();
        self.0.hash(&mut hasher);
        hasher.finish()
    }

    fn __str__(&self) -> String {
        self.message()
    }

    fn __repr__(&self) -> String {
        format!("Warning('{}: {}')", self.kind(), self.0)
    }
}

picklable!(Warning: stickslip::Warning);

/// Passes the warnings to Python's ``warnings`` if requested; they are computed only in this case.
pub(crate) fn warn(
    py: Python<'_>,
    is_wanted: bool,
    warnings: impl FnOnce() -> Vec<stickslip::Warning>,
) -> PyResult<()> {
    if !is_wanted {
        return Ok(());
    }
    let remarks: Vec<_> = Warning::all(warnings())
        .iter()
        .map(|warning| (warning.kind(), warning.message()))
        .collect();
    if !remarks.is_empty() {
        let module = py.import("stickslip._remarks")?;
        module.call_method1("warn", (remarks,))?;
    }
    Ok(())
}

/// Describes the status of a solve and its warnings, for the ``repr`` of a solution.
pub(crate) fn ending(report: &stickslip::Report, warnings: &[stickslip::Warning]) -> String {
    format!("{}{}", report.status, remarks(warnings))
}

/// Returns the end of a ``repr``: that there is no contact, or the number of warnings, if any.
pub(crate) fn remarks(warnings: &[stickslip::Warning]) -> String {
    if warnings.contains(&stickslip::Warning::NoContact) {
        return ", no contact".into();
    }
    match warnings.len() {
        0 => String::new(),
        count => format!(", {}", counted(count, "warning")),
    }
}
