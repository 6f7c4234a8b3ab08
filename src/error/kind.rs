//! Groups of errors by the reaction that they require from a program.

use std::fmt;

use crate::error::Error;

/// Group of an error, by the reaction that it requires from a program.
///
/// ```
/// use stickslip::*;
/// use stickslip::history::State;
///
/// /// Returns the reaction of a study to an error.
/// fn reaction(error: &Error) -> &'static str {
///     match error.kind() {
///         ErrorKind::NotConverged => "repeat with half the step",
///         ErrorKind::Load => "skip this load",
///         ErrorKind::Memory => "repeat on a coarser grid",
///         ErrorKind::File | ErrorKind::Ranks => "end the program",
///         // A minor release may add kinds.
///         ErrorKind::Argument | ErrorKind::Unsupported | _ => "correct the input",
///     }
/// }
///
/// let error = Grid::square(0, 1.0).unwrap_err();
/// assert_eq!(error.kind(), ErrorKind::Argument);
/// assert_eq!(format!("{error:?}"), format!("GridSize: {error}"));
/// assert_eq!(reaction(&error), "correct the input");
///
/// let grid = Grid::square(16, 4.0)?;
/// let unlike = ElasticPair::new(Material::new(1.0, 0.2)?, Material::rigid())?;
/// let bodies = HalfSpace::new(grid, unlike)?;
/// let ball = surface::sphere(grid, 10.0)?;
/// let press = |load| NormalProblem::builder(&bodies, &ball, load);
/// let periodic = HalfSpace::with_boundary(grid, unlike, Boundary::Periodic)?;
/// let closed = NormalLoad::Approach(ball.max());
/// let too_near = NormalProblem::builder(&periodic, &ball, closed).build().unwrap_err();
/// assert_eq!(too_near.kind(), ErrorKind::Load);
///
/// let force = NormalLoad::Force(0.1);
/// let cut_short = press(force).max_iterations(1).build()?.solve().unwrap_err();
/// assert_eq!(cut_short.kind(), ErrorKind::NotConverged);
///
/// let hertz = analytical::HertzLine::new(&unlike, 10.0, 0.01)?;
/// let coupled = analytical::CattaneoMindlinLine::new(hertz, 0.5, 1e-3).unwrap_err();
/// assert_eq!(coupled.kind(), ErrorKind::Unsupported);
///
/// let too_large = HalfSpace::new(Grid::square(1 << 26, 1.0)?, unlike).unwrap_err();
/// assert_eq!(too_large.kind(), ErrorKind::Memory);
///
/// let missing_file = History::load(&bodies, "no such file").unwrap_err();
/// assert_eq!(missing_file.kind(), ErrorKind::File);
///
/// let no_slabs = State::from_slabs(&bodies, []).unwrap_err();
/// assert_eq!(no_slabs.kind(), ErrorKind::Ranks);
/// # Ok::<(), Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum ErrorKind {
    /// An argument is out of range, has the wrong length, or does not match another argument. Correct the argument.
    Argument,
    /// The contact cannot carry the load, or the load does not determine the solution. Change the load or the surface.
    Load,
    /// The model does not support the requested quantity for these bodies or loads. Select a different model.
    Unsupported,
    /// An iteration or a search did not reach its tolerance. Use a shorter step or a larger tolerance.
    NotConverged,
    /// Memory cannot be allocated. Use fewer cells.
    Memory,
    /// A file cannot be read or written, or violates its format.
    File,
    /// Ranks that solve together cannot continue.
    Ranks,
}

impl Error {
    /// Returns the group of the error.
    #[must_use]
    pub fn kind(&self) -> ErrorKind {
        match self {
            Self::EmptyContact
            | Self::NoPressureToHold
            | Self::BeyondFrictionCapacity { .. }
            | Self::BeyondFrictionMoment { .. }
            | Self::BeyondHardness { .. }
            | Self::ApproachBeyondMeanGap { .. }
            | Self::Total { .. } => ErrorKind::Load,
            Self::UnsupportedForCoatings { .. }
            | Self::UnsupportedByModel { .. }
            | Self::CoupledMaterials { .. }
            | Self::RigidBody(_)
            | Self::DivergentPeriodicSum(_)
            | Self::ObliqueLoad { .. }
            | Self::Yielded { .. }
            | Self::Method { .. } => ErrorKind::Unsupported,
            Self::NotConverged(_)
            | Self::StepTooLong { .. }
            | Self::CycleNotClosed { .. }
            | Self::HeightMomentsNotReached { .. } => ErrorKind::NotConverged,
            Self::Memory { .. } => ErrorKind::Memory,
            Self::File { .. } | Self::Format { .. } => ErrorKind::File,
            Self::Ranks(_) => ErrorKind::Ranks,
            Self::GridSize { .. }
            | Self::NotPositive { .. }
            | Self::NegativeOrNotFinite { .. }
            | Self::NotFinite { .. }
            | Self::ExtremeNumber { .. }
            | Self::Sample { .. }
            | Self::PoissonRatio(_)
            | Self::BothRigid
            | Self::TooManyLayers { .. }
            | Self::IncompleteKernel(_)
            | Self::NotDefinite { .. }
            | Self::DatumTooNear { .. }
            | Self::CellsTooLong { .. }
            | Self::Length { .. }
            | Self::GridMismatch { .. }
            | Self::BoundaryMismatch { .. }
            | Self::CellValueMismatch { .. }
            | Self::Tolerance(_)
            | Self::IterationLimit
            | Self::Bounds { .. }
            | Self::RepeatedDirection
            | Self::MaterialMismatch { .. }
            | Self::TooManyCells { .. }
            | Self::NotPositiveDefinite { .. }
            | Self::Undetermined { .. }
            | Self::Degree { .. }
            | Self::Range { .. }
            | Self::BeyondSamples { .. }
            | Self::Hurst(_)
            | Self::BelowMinimum { .. }
            | Self::GridTooShort { .. }
            | Self::NoWaveInBand { .. }
            | Self::StepsPerCycle(_)
            | Self::EmptyPath
            | Self::StepOutOfOrder { .. }
            | Self::NoLastStep
            | Self::GapUnderLoad
            | Self::OutdatedSolution { .. } => ErrorKind::Argument,
        }
    }
}

/// Implements `Debug` as the name of the variant, followed by the message. A variant that is not listed fails to compile.
macro_rules! debug_with_names {
    ($($name:ident)+) => {
        impl fmt::Debug for Error {
            fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
                let name = match self {
                    $(Self::$name { .. } => stringify!($name),)+
                };
                write!(formatter, "{name}: {self}")
            }
        }
    };
}

debug_with_names! {
    GridSize Memory NotPositive NegativeOrNotFinite NotFinite ExtremeNumber Sample PoissonRatio BothRigid TooManyLayers
    UnsupportedForCoatings IncompleteKernel NotDefinite DatumTooNear RigidBody DivergentPeriodicSum CoupledMaterials
    CellsTooLong Length GridMismatch BoundaryMismatch CellValueMismatch Tolerance IterationLimit NoPressureToHold Method
    Bounds Total RepeatedDirection EmptyContact BeyondFrictionCapacity BeyondFrictionMoment BeyondHardness Yielded
    ObliqueLoad UnsupportedByModel MaterialMismatch ApproachBeyondMeanGap TooManyCells NotPositiveDefinite Undetermined
    Degree Range BeyondSamples Hurst BelowMinimum GridTooShort NoWaveInBand HeightMomentsNotReached File Format
    StepsPerCycle EmptyPath StepOutOfOrder NoLastStep GapUnderLoad OutdatedSolution CycleNotClosed StepTooLong Ranks NotConverged
}
