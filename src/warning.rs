//! Remarks on a converged solution, and what is resolved.

use crate::grid::Grid;

/// A diagnostic on a converged solution that may mislead.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub enum Warning {
    /// There is no contact: no cell carries pressure.
    NoContact,
    /// Contact reaches the outermost ring of cells: the bodies may also touch beyond the grid.
    ContactAtEdge {
        /// Contact cells in the ring.
        cells: usize,
    },
    /// Contact spots smaller than five cells have a tenth of the contact cells or more: their area is overestimated and
    /// their stick fraction means little. Rough surfaces always have some small spots, which matter only together.
    UnresolvedSpots {
        /// Spots of fewer than five cells.
        unresolved: usize,
        /// Number of all spots.
        spots: usize,
    },
    /// The grid is a line of cells, and does not repeat: a row of rectangles, whose ends bear peaks of pressure. It
    /// is no line contact in plane strain.
    SingleRowOfCells,
    /// A contact spot runs from edge to edge of the grid, as that of a cylinder does: the bodies end there, and the
    /// ends bear peaks of pressure that a longer body does not have.
    ContactSpansGrid {
        /// From the first column to the last.
        along_x: bool,
        /// From the first row to the last.
        along_y: bool,
    },
    /// The pressure of some cells is beyond the hardness that a material states: the contact would flow there. Give the
    /// problem a [`Hardness`](crate::normal::Hardness).
    BeyondHardness {
        /// Cells of such a pressure.
        cells: usize,
    },
    /// A step of a history held the pressure although the gap had changed: the pressure is still that of the old gap.
    StalePressure,
    /// The stress on a [`Plane`](crate::subsurface::Plane) nearer to the surface than a side of a cell, below shear tractions
    /// that end at the edge of a contact: `sxx` and `syy` have a peak with a vertical tangent there, which falls short by the
    /// root of the cells. The [closed forms](crate::analytical::CattaneoMindlinLine::surface_stress) have it; planes a side of
    /// a cell or more below the surface do not suffer from it.
    StressAtEdge,
    /// The contact has few cells: fewer than 100, a contact radius of 5.6 cells, or fewer than 20 on a line of cells. On a sphere
    /// its area is then off by up to 17 % and the stick ratio by as much (by 22 % from 20 cells), from 113 cells on by 7 %,
    /// wherever the centre lies between cells.
    UnderresolvedContact {
        /// Contact cells.
        cells: usize,
    },
    /// Few cells stick: fewer than 50, or fewer than 10 on a line of cells. On a sphere the stick ratio is then off by a tenth
    /// and, from ten cells, by a fifth of itself.
    UnderresolvedStickZone {
        /// Cells that stick.
        cells: usize,
    },
    /// The zone that slips, a ring along the edge of the contact, is narrower than two cells. On a sphere the energy that slip
    /// dissipates is right to 2 % from two cells on and to 12 % from one; below half a cell it is anything from nothing to
    /// several times the right one. Where no cell slips, which a ring narrower than a cell may come to, there is no such
    /// remark, nor where the mean radius of the contact spots is less than four cells: a ring of two cells has no room there.
    ///
    /// A step that rolls has the warning only below one cell. Its slip zone lies along the trailing edge, and the mean is
    /// over the whole edge. Forces and creepages of steady rolling are then right to 0.6 %, for widths from 0.3 cells. On a
    /// sphere `dissipated_energy` is too small by 72 % at 0.3 cells and 28 % at one. It is too small by 15 % at two cells and
    /// 8 % at four. On a cylinder it is too small by 51 % at one cell and 28 % at two. The work of rolling is right to 0.4 %.
    UnderresolvedSlipZone {
        /// Mean width of the zone in tenths of a cell: its cells over the sides of cells along the edge of the contact,
        /// which on a grid of rows and columns are counted as $`\pi/4`$ each.
        tenths: usize,
    },
    /// The cells leave an error of more than 5 % in the pressure, or in the traction, by the estimate of
    /// [`NormalSolution::discretisation_estimate`](crate::NormalSolution::discretisation_estimate) or that of the tangential
    /// solution. For more than ten spots, as on a rough surface, the text names how much smaller cells need to be:
    /// [`surface::resample`](crate::surface::resample) refines the same surface, and
    /// [`surface::GaussianFilter`](crate::surface::GaussianFilter) removes its short waves.
    DiscretisationError {
        /// The estimate, in tenths of a per cent.
        per_mille: usize,
        /// Cells on the radius of a contact spot of mean size that 1 % would need, where the error falls with the power 3/2.
        cells_per_radius: usize,
        /// Number of contact spots.
        spots: usize,
    },
    /// Dissimilar bodies with friction were pressed in too few steps. Under a load that grows, cells come into contact one
    /// after the other, and other cells slip and stick: press a [`History`](crate::History) by
    /// [`press`](crate::History::press).
    ///
    /// A step of a history has the warning if more than a tenth of the contact came in the step. The first step from zero
    /// load thus has the warning however small its load is. Steps that `press` or
    /// [`AdaptiveSteps`](crate::history::AdaptiveSteps) took to a tolerance do not have it. A
    /// [`CoupledProblem`](crate::CoupledProblem) presses in one step. So does a
    /// [`TangentialProblem`](crate::TangentialProblem) with [one-way coupling](crate::Coupling::OneWay). It has a pressure
    /// and no gap. Its solutions therefore have the warning for a flat punch too, where they are exact.
    SingleLoadStep,
    /// The approach from the first touch exceeds the longest side of the grid. A common cause is a unit of gap, grid or
    /// modulus that differs from the others.
    ApproachBeyondGrid {
        /// The approach over the longest side of the grid, in tenths.
        tenths: usize,
    },
    /// The contact radius a exceeds 0.3 of the radius of curvature R of the gap. The theory of half-spaces assumes that
    /// a/R is small.
    ///
    /// Both follow from the slopes of the gap before loading between cells in contact: 1/R is their regression on the
    /// position along x or along y, and a is twice the standard deviation of the position. On a sphere a/R is right to
    /// 10 % for a radius of five cells or more, on a cylinder it is 15 % too large. Roughness, whose slopes do not follow
    /// the position, has no such warning.
    LargeContactRadius {
        /// The larger one of a/R along x and along y, in thousandths.
        per_mille: usize,
    },
    /// The rms slope of the gap before loading within the contact exceeds 0.5. The theory of half-spaces assumes that
    /// slopes are small.
    SteepSurface {
        /// The rms slope between cells in contact, in thousandths.
        per_mille: usize,
    },
    /// A step of a history named no tangential load. It held the shift, and the tangential force fell by more than half: a
    /// lighter pressure or less friction cannot carry it. Steps that roll, turn or change a relative displacement have no
    /// such warning.
    HeldShiftLostForce {
        /// The part of the tangential force that was lost, in per cent.
        per_cent: usize,
    },
    /// Rolling of dissimilar bodies ignores that tractions change the pressure, and the neglected part exceeds the
    /// tolerance. [`CoupledRollingProblem`](crate::rolling::CoupledRollingProblem) and a [`History`](crate::History) of
    /// [full coupling](crate::Coupling::Full) include it.
    ///
    /// The neglected part is half the range of the normal displacement by the tractions within the contact, over the
    /// largest normal displacement by the pressure.
    NeglectedLift {
        /// The neglected part in millionths, rounded up.
        per_million: usize,
    },
}

impl std::fmt::Display for Warning {
    fn fmt(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::NoContact => write!(
                formatter,
                "the normal force is zero, no cell carries pressure: give a normal force above zero, or an approach beyond the least gap"
            ),
            Self::ContactAtEdge { cells } => {
                write!(
                    formatter,
                    "{cells} contact cells lie on the edge of the grid: take a larger one"
                )
            }
            Self::UnresolvedSpots { unresolved, spots } => write!(
                formatter,
                "{unresolved} of {spots} contact spots are smaller than {RESOLVED} cells and have a tenth of the contact cells or more: refine the grid, or filter out the short waves of the surface"
            ),
            Self::SingleRowOfCells => write!(
                formatter,
                "the grid is a line of cells that does not repeat: rectangles in a row, not a line contact in plane strain; for that take a line along x with a boundary that is periodic along y"
            ),
            Self::ContactSpansGrid { along_x, along_y } => {
                let axes = match (along_x, along_y) {
                    (true, false) => "x",
                    (false, true) => "y",
                    _ => "x and y",
                };
                write!(
                    formatter,
                    "a contact spot runs across the whole grid along {axes}: its ends at the edges bear peaks of pressure; let the surface rise before them, or let the grid repeat there: periodic along y, or along both axes"
                )
            }
            Self::BeyondHardness { cells } => write!(
                formatter,
                "{cells} cells are pressed beyond the hardness of the softer body: limit the pressure to it"
            ),
            Self::StalePressure => formatter.write_str(
                "the gap has changed, but the pressure was held: it is that of the old gap; give the normal load again",
            ),
            Self::StressAtEdge => write!(
                formatter,
                "the stress along the surface converges as the root of the cells at the edge of a sheared contact: take a plane a side of a cell or more below it"
            ),
            Self::UnderresolvedContact { cells } => write!(
                formatter,
                "the contact has {cells} cells: its area and its stick ratio are rough; refine the grid"
            ),
            Self::UnderresolvedStickZone { cells } => write!(
                formatter,
                "{cells} cells stick: the size of the stick zone is rough; refine the grid"
            ),
            Self::UnderresolvedSlipZone { tenths } => write!(
                formatter,
                "the zone that slips is {}.{} cells wide on the mean: slip and dissipated energy are rough; refine the grid until it has two",
                tenths / 10,
                tenths % 10
            ),
            Self::DiscretisationError {
                per_mille, spots, ..
            } if *spots > MANY_SPOTS => write!(
                formatter,
                "the cells leave an error of about {}.{} % in the fields of {spots} contact spots, by an estimate: for 1 % resample the surface onto cells {:.1} times smaller, or filter out its short waves",
                per_mille / 10,
                per_mille % 10,
                refinement(1e-3 * *per_mille as f64)
            ),
            Self::DiscretisationError {
                per_mille,
                cells_per_radius,
                ..
            } => write!(
                formatter,
                "the cells leave an error of about {}.{} % in the fields, by an estimate: for 1 % take {cells_per_radius} cells to the radius of a contact spot",
                per_mille / 10,
                per_mille % 10
            ),
            Self::SingleLoadStep => write!(
                formatter,
                "dissimilar bodies were pressed in too few steps: under a load that grows other cells stick and slip; press a history to a tolerance by its function press"
            ),
            Self::ApproachBeyondGrid { tenths } => write!(
                formatter,
                "the approach is {}.{} times the longest side of the grid, expected less than 1: check the units of gap, grid, modulus and load",
                tenths / 10,
                tenths % 10
            ),
            Self::LargeContactRadius { per_mille } => write!(
                formatter,
                "the contact radius is about {:.2} of the radius of curvature, expected at most 0.3: check the units of gap and grid, or lower the load; half-spaces assume small slopes",
                1e-3 * *per_mille as f64
            ),
            Self::SteepSurface { per_mille } => write!(
                formatter,
                "the rms slope of the surface within the contact is {:.2}, expected at most 0.5: check the units of heights and grid, or filter out short waves; half-spaces assume small slopes",
                1e-3 * *per_mille as f64
            ),
            Self::HeldShiftLostForce { per_cent } => write!(
                formatter,
                "the step held the shift and lost {per_cent} % of the tangential force, expected at most 50 %: to keep the force, give it in each step"
            ),
            Self::NeglectedLift { per_million } => write_lift(formatter, *per_million),
        }
    }
}

/// Writes the warning of a lift that the pressure ignores.
fn write_lift(formatter: &mut std::fmt::Formatter<'_>, per_million: usize) -> std::fmt::Result {
    write!(
        formatter,
        "tractions lift dissimilar bodies by {}.{:04} % of the normal displacement, and the pressure ignores the lift: use coupled rolling, or a history with full coupling",
        per_million / 10_000,
        per_million % 10_000
    )
}

/// Discretisation errors that are remarked on, and that are aimed at.
const LARGEST_ERROR: f64 = 0.05;
const SMALL_ERROR: f64 = 0.01;

/// Number of spots above which a contact counts as rough: the radius of its spots cannot be chosen.
const MANY_SPOTS: usize = 10;

/// Returns how much smaller cells need to be for a small discretisation error.
fn refinement(estimate: f64) -> f64 {
    (estimate / SMALL_ERROR).cbrt().powi(2)
}

impl Warning {
    /// Returns the warning of an estimate of the discretisation error; `contact` has the cells on the radius of a contact
    /// spot and the number of spots.
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "both are positive, and what is no number of cells saturates"
    )]
    pub(crate) fn of_discretisation(
        estimate: Option<f64>,
        contact: impl FnOnce() -> (f64, usize),
    ) -> Option<Self> {
        let estimate = estimate.filter(|estimate| *estimate > LARGEST_ERROR)?;
        let (radius, spots) = contact();
        Some(Self::DiscretisationError {
            per_mille: (1e3 * estimate).round() as usize,
            cells_per_radius: (radius * refinement(estimate)).ceil() as usize,
            spots,
        })
    }
}

impl Warning {
    /// Returns a lift by tractions that the pressure ignores, in millionths; `None` up to the tolerance.
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "the lift is not negative, and a large one saturates"
    )]
    pub(crate) fn lift_beyond(lift: f64, tolerance: f64) -> Option<usize> {
        (lift > tolerance).then(|| (1e6 * lift).ceil() as usize)
    }
}

/// Cells that a resolved spot needs.
pub(crate) const RESOLVED: usize = 5;

/// Cells that a resolved contact and a resolved stick zone need: of an area, and of a line, where one cell is a tenth of
/// the stick zone.
const RESOLVED_AREA: [usize; 2] = [100, 50];
const RESOLVED_LINE: [usize; 2] = [20, 10];

/// Tenths of a cell that a resolved slip zone is wide.
const RESOLVED_WIDTH: usize = 20;

/// Tenths of a cell that a resolved slip zone of a step that rolls is wide: forces need less than energies.
const RESOLVED_ROLLING_WIDTH: usize = 10;

/// Least number of cells on the mean radius of contact spots that resolves a slip zone.
const LEAST_RADIUS: usize = 4;

/// What the zones of a contact, or of some steps, tell of its resolution; `None` of what there is not.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub(crate) struct Resolution {
    is_line: bool,
    /// The fewest cells in contact, and the fewest that stick.
    contact: Option<usize>,
    stick: Option<usize>,
    /// The widest slip zone, in tenths of a cell.
    slip_width: Option<usize>,
}

impl Resolution {
    /// Of this many cells in contact; one that fills the whole grid has no edge that cells could miss.
    pub(crate) fn of_contact(grid: Grid, contact: usize) -> Self {
        Self {
            is_line: grid.size().contains(&1),
            contact: (contact > 0 && contact < grid.cells()).then_some(contact),
            ..Self::default()
        }
    }

    /// With this many cells that stick and that slip; `edge` counts the sides of cells along the edge of the contact, if
    /// both are.
    pub(crate) fn with_zones(
        self,
        [stick, slip]: [usize; 2],
        edge: impl FnOnce() -> usize,
    ) -> Self {
        let width = || {
            // The edge of a disc has 4/pi times its length in sides of cells, 452/355 within 1e-7.
            let [sides, length] = if self.is_line { [1, 1] } else { [452, 355] };
            let edge = length * edge();
            // The radius of a disc is twice its area over its edge.
            let has_room = self.is_line || 2 * sides * (stick + slip) >= LEAST_RADIUS * edge;
            (edge > 0 && has_room).then(|| (20 * sides * slip + edge) / (2 * edge))
        };
        Self {
            stick: (stick > 0).then_some(stick),
            slip_width: (stick > 0 && slip > 0).then(width).flatten(),
            ..self
        }
    }

    /// Returns the resolution of a step that rolls, in which narrower slip zones are resolved.
    pub(crate) fn of_rolling(self) -> Self {
        let resolved = |width: usize| {
            if width < RESOLVED_ROLLING_WIDTH {
                width
            } else {
                width.max(RESOLVED_WIDTH)
            }
        };
        Self {
            slip_width: self.slip_width.map(resolved),
            ..self
        }
    }

    /// With those of another step.
    pub(crate) fn and(self, other: Self) -> Self {
        let fewest = |a: Option<usize>, b: Option<usize>| a.into_iter().chain(b).min();
        Self {
            is_line: self.is_line || other.is_line,
            contact: fewest(self.contact, other.contact),
            stick: fewest(self.stick, other.stick),
            slip_width: self.slip_width.max(other.slip_width),
        }
    }

    /// That the contact has too few cells.
    pub(crate) fn contact_warning(self) -> Option<Warning> {
        let coarse = self.contact.filter(|cells| *cells < self.least()[0]);
        coarse.map(|cells| Warning::UnderresolvedContact { cells })
    }

    /// That zones of a contact have too few cells; of the stick zone where the contact itself has not.
    pub(crate) fn zone_warnings(self) -> impl Iterator<Item = Warning> {
        let is_coarse = self.contact_warning().is_some();
        let stick = self
            .stick
            .filter(|cells| *cells < self.least()[1] && !is_coarse);
        let stick = stick.map(|cells| Warning::UnderresolvedStickZone { cells });
        let slip = self.slip_width.filter(|tenths| *tenths < RESOLVED_WIDTH);
        let slip = slip.map(|tenths| Warning::UnderresolvedSlipZone { tenths });
        stick.into_iter().chain(slip)
    }

    /// Cells that a contact and a stick zone need.
    fn least(self) -> [usize; 2] {
        if self.is_line {
            RESOLVED_LINE
        } else {
            RESOLVED_AREA
        }
    }
}
