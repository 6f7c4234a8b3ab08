//! How a cycle slides.

/// The sliding regime of a cycle.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub enum Regime {
    /// No cell slipped.
    FullStick,
    /// Some cells slipped, but some stuck at the end of each step.
    PartialSlip,
    /// The whole contact was at its friction limit at the end of a step.
    GrossSlip,
}
