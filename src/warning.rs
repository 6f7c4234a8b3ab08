//! Warnings about a converged solution.

mod limits;
mod resolution;
#[cfg(test)]
mod tests;
mod text;

pub(crate) use limits::{LARGEST_SEAM, LOWEST_HARDNESS, THICKEST_LAYER};
pub(crate) use resolution::{RESOLVED, Resolution};

/// Warning that a converged solution may be misleading.
///
/// The longest side of a grid with a single row or column of cells is the side along the row or column.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub enum Warning {
    /// No cell carries pressure. A new solution also has this warning until a solver writes to it.
    NoContact,
    /// The contact reaches the outermost ring of cells, so the bodies may also touch beyond the grid.
    ContactAtEdge {
        /// Number of contact cells in the ring.
        cells: usize,
    },
    /// Contact spots of fewer than five cells contain a tenth of the contact cells or more. The area of such spots is
    /// overestimated, and their stick fraction has little meaning. Rough surfaces always have some small spots, and a
    /// few small spots do not matter.
    UnresolvedSpots {
        /// Number of spots of fewer than five cells.
        unresolved: usize,
        /// Number of all spots.
        spots: usize,
    },
    /// The grid is a line of cells and not periodic. Such a row of rectangles has pressure peaks at its ends and is not
    /// a line contact in plane strain.
    SingleRowOfCells,
    /// A contact spot extends from edge to edge of the grid, like the contact of a cylinder. The bodies end at these
    /// edges. The pressure has peaks at the ends, which a longer body does not have.
    ContactSpansGrid {
        /// Whether a spot extends from the first column to the last.
        along_x: bool,
        /// Whether a spot extends from the first row to the last.
        along_y: bool,
    },
    /// The pressure of some cells exceeds the hardness of a material, which would deform plastically in these cells. A
    /// [`Hardness`](crate::normal::Hardness) in the problem limits the pressure.
    BeyondHardness {
        /// Number of cells above the hardness.
        cells: usize,
    },
    /// A step of a history kept the pressure although the gap had changed. The pressure still belongs to the old gap.
    StalePressure,
    /// The stress was computed on a [`Plane`](crate::subsurface::Plane) nearer to the surface than a cell side. The
    /// shear tractions above this plane end at the edge of a contact. Below this edge, `sxx` and `syy` have a peak with
    /// a vertical tangent. The computed peak is too low by an error that decreases with the square root of the cell
    /// size. The [closed forms](crate::analytical::CattaneoMindlinLine::surface_stress) contain the peak. Planes at a
    /// depth of a cell side or more are not affected.
    StressAtEdge,
    /// The contact has fewer than 100 cells (a contact radius of 5.6 cells), or fewer than 20 on a line of cells. The
    /// following errors were measured on a sphere at 700 positions, under 0.2 to 0.8 of the sliding force. For 50 to 99 cells
    /// the error of the area is up to 13 %, and the relative error of the stick ratio is up to 17 %. For 16 to 49 cells these
    /// errors are up to 22 % and 41 %. For 113 to 220 cells they are at most 8 % and 14 %.
    UnderresolvedContact {
        /// Number of contact cells.
        cells: usize,
    },
    /// Fewer than 50 cells stick, or fewer than 10 on a line of cells. On a sphere the error of the stick ratio is then
    /// a tenth of the ratio. For ten cells it is a fifth of the ratio.
    UnderresolvedStickZone {
        /// Number of sticking cells.
        cells: usize,
    },
    /// The slip zone, a ring along the edge of the contact, is narrower than two cells. On a sphere the error of the
    /// energy dissipated by slip is at most 2 % for a width of two cells or more. It is at most 12 % for one cell or
    /// more. Below half a cell the energy ranges from zero to several times the correct value. No warning is given if the mean radius
    /// of the contact spots is less than four cells. A ring of two cells does not fit into such spots.
    ///
    /// If the ring is narrower than a cell, no cell might slip, and the energy is then zero. The width in the warning is also zero.
    /// A step without slipping cells has the warning if a cell at the edge has both of two properties. Its pressure is below half
    /// the mean pressure. The change of its traction uses more than twice as much of its limit as the mean of all cells. Flat punches,
    /// complete contacts, rolling steps and coefficients of friction above 5 do not have it. Steps that change the tractions by
    /// less than a millionth of the friction capacity do not have it either.
    ///
    /// A rolling step has the warning only if the slip zone is narrower than one cell. The slip zone of rolling lies
    /// along the trailing edge, but its mean width is the mean over the whole edge. The error of forces and creepages of
    /// steady rolling is at most 0.6 % for widths of 0.3 cells or more. On a sphere `dissipated_energy` is too small by
    /// 72 % at a width of 0.3 cells and 28 % at one cell. It is too small by 15 % at two cells and 8 % at four cells. On
    /// a cylinder this energy is too small by 51 % at one cell and 28 % at two cells. The work of rolling is accurate to
    /// 0.4 %.
    UnderresolvedSlipZone {
        /// Mean width of the zone in tenths of a cell. It is the number of cells of the zone divided by the number of
        /// cell sides along the edge of the contact. On a grid of rows and columns each side counts as $`\pi/4`$. It is zero
        /// if no cell slips.
        tenths: usize,
    },
    /// The estimated discretisation error of the pressure or of the traction exceeds 5 %. The error is estimated by
    /// [`NormalSolution::discretisation_estimate`](crate::NormalSolution::discretisation_estimate) or by the same
    /// function of the tangential solution. For more than ten spots, as on a rough surface, the text states the
    /// necessary reduction of the cell size. [`surface::resample`](crate::surface::resample) refines the same surface,
    /// and [`surface::GaussianFilter`](crate::surface::GaussianFilter) removes its short waves.
    DiscretisationError {
        /// Estimated error in tenths of a per cent.
        per_mille: usize,
        /// Number of cells on the radius of a mean contact spot for an error of 1 %. This number assumes that the error
        /// decreases with the power 3/2 of the cell size.
        cells_per_radius: usize,
        /// Number of contact spots.
        spots: usize,
    },
    /// Bodies that couple pressure and traction ([`ElasticPair::is_coupled`](crate::ElasticPair::is_coupled)) were pressed with
    /// friction in too few steps. They are bodies of different materials, or coated bodies. Under a growing load, cells come into contact one
    /// after the other while other cells slip and stick. [`History::press`](crate::History::press) applies the load in
    /// the necessary number of steps.
    ///
    /// A step of a history has the warning if more than a tenth of the contact came into contact in the step. The first
    /// step from zero load therefore has the warning for any load. Steps that `press` or
    /// [`AdaptiveSteps`](crate::history::AdaptiveSteps) took to a tolerance do not have the warning. In a
    /// [`CoupledProblem`](crate::CoupledProblem), and in a [`TangentialProblem`](crate::TangentialProblem) with [one-way
    /// coupling](crate::Coupling::OneWay), the bodies are pressed in one step. A tangential problem has a pressure but
    /// no gap. Its solutions therefore have the warning also for a flat punch, for which they are exact.
    SingleLoadStep,
    /// The approach from the first touch exceeds the longest side of the grid. A common cause is an inconsistent unit
    /// of gap, grid or modulus.
    ApproachBeyondGrid {
        /// The approach divided by the longest side of the grid, in tenths.
        tenths: usize,
    },
    /// The shift of a step exceeds the longest side of the grid, or the change of a
    /// [relative displacement](crate::tangential::RelativeDisplacement) in a contact cell does. A common cause is an inconsistent
    /// unit.
    ///
    /// A [`Cycle`](crate::history::Cycle) has the warning if the range of the shift over consecutive steps exceeds this side. A history
    /// has it in the first step beyond this range. Steps that roll and steps without contact do not have the warning, and end the
    /// range. A large range is valid if the counterbody is flat, because the shift does not move the gap.
    ShiftBeyondGrid {
        /// The largest of shift, relative displacement and range of the shift, divided by the longest side of the grid, in tenths.
        tenths: usize,
    },
    /// A component of a [bulk strain](crate::tangential::RelativeDisplacement::bulk_strain) times its amount exceeds 0.02 in magnitude,
    /// whereas the model assumes small strains. Common causes are a strain in per cent and an amount in an inconsistent unit.
    /// For relative displacements that were created from fields, the strain is the mean strain over the grid.
    LargeBulkStrain {
        /// The largest magnitude of a component at the end of the step, in thousandths.
        per_mille: usize,
    },
    /// The twist of a step exceeds 0.2 rad, whereas the model assumes small rotations. A common cause is a twist in degrees. The range
    /// of the twist over consecutive steps counts like that of a shift ([`ShiftBeyondGrid`](Self::ShiftBeyondGrid)). A large range is
    /// valid for bodies of revolution.
    LargeTwist {
        /// The magnitude of the twist of the step, or the range of the twist, in tenths of a radian.
        tenths: usize,
    },
    /// The creepage of rolling bodies is 0.1 or more, whereas the model assumes small creepages. Common causes are a creepage in per
    /// cent and an inconsistent unit of the spin. The magnitude of the spin times the largest distance of a contact cell from the
    /// origin of the grid is added to the creepage. For a step of a history the prescribed creepage counts.
    LargeCreepage {
        /// The magnitude of the creepage including the spin, in per cent.
        per_cent: usize,
    },
    /// The largest coefficient of friction exceeds 5. A common cause is a coefficient in per cent. A larger coefficient is also
    /// used for bodies that stick everywhere.
    LargeFriction {
        /// The largest coefficient of all cells, in tenths.
        tenths: usize,
    },
    /// Nine tenths of the contact cells or more are at their [`Hardness`](crate::normal::Hardness), and the largest pressure is less
    /// than 1/10000 of the contact modulus
    /// ([`ElasticPair::contact_modulus`](crate::ElasticPair::contact_modulus)). The hardness of a metal is about 1/100 of
    /// this modulus. A common cause is a hardness in an inconsistent unit. Under a prescribed approach the force is then too small by
    /// the same factor.
    LowHardness {
        /// The contact modulus divided by the largest pressure.
        parts: usize,
    },
    /// A hardness exceeds the plane-strain modulus $`E/(1 - \nu^2)`$, and no cell has reached it. The hardness of a
    /// [material](crate::Material::hardness) is compared with the modulus of its body. A limit of the pressure
    /// ([`Hardness`](crate::normal::Hardness), its smallest value in the contact) is compared with the stiffer deformable body. The
    /// hardness of a metal is about 1/100 of this modulus, so that such a hardness has no effect on any contact of small strains. A
    /// common cause is an inconsistent unit. Coated bodies and user kernels do not have this warning.
    HardnessBeyondModulus {
        /// The hardness divided by the modulus, in thousandths.
        per_mille: usize,
    },
    /// The [largest shear stress](crate::Friction::max_shear_stress) lowers the friction capacity to less than 1 % of the capacity
    /// without it. A common cause is a stress in an inconsistent unit. Under a prescribed shift the force is then too small
    /// by the same factor. A coefficient of friction above 5 has the warning [`LargeFriction`](Self::LargeFriction) instead, because
    /// such a coefficient with a largest shear stress also models a constant friction limit.
    LowShearStress {
        /// The friction capacity without the largest shear stress divided by the capacity.
        parts: usize,
    },
    /// The [largest shear stress](crate::Friction::max_shear_stress) exceeds the plane-strain modulus $`E/(1 - \nu^2)`$ of the stiffer
    /// deformable body. It caps the friction of no cell, or the coefficient of friction exceeds 5. The shear strength of a metal is
    /// below 1/100 of this modulus. A common cause is an inconsistent unit. Coated bodies and user kernels do not have this warning.
    ShearStressBeyondModulus {
        /// The largest shear stress divided by the modulus, in thousandths.
        per_mille: usize,
    },
    /// The largest pressure of a [prescribed field](crate::PressureSource::Prescribed) is less than 1e-7 of the contact modulus
    /// ([`ElasticPair::contact_modulus`](crate::ElasticPair::contact_modulus)). A common cause is a pressure in an inconsistent unit,
    /// as a pressure in MPa with a modulus in Pa. Displacements and friction limits are then too small by the same factor.
    LowPressure {
        /// The contact modulus divided by the largest pressure.
        parts: usize,
    },
    /// The gap of contact cells changed between two pressures by more than the largest normal displacement due to either
    /// pressure. The contact after the change is then unrelated to the contact before it. Common causes are a wear
    /// coefficient in an inconsistent unit (1 mm3/(N m) is 1e-9 1/Pa) and too many cycles of wear in one update. A uniform change
    /// of all cells does not count, because it only shifts the datum of the gap.
    ///
    /// On a grid that is periodic along y, the displacement depends on the datum. The force per length divided by the contact
    /// modulus then replaces it.
    ///
    /// A step of a history has the warning if it solves for the pressure after [`set_gap`](crate::History::set_gap). Steps that
    /// roll do not have it, because the texture of their gap moves.
    ///
    /// The next solution of a solver has the warning after [`set_gap`](crate::NormalSolver::set_gap) if the change exceeds ten
    /// times the displacement and resembles wear. It then has one sign and leaves a tenth of the cells outside the last contact
    /// unchanged. The gap of a solver can also change to another surface, which rarely causes the warning. An example is a smaller
    /// flat punch over a deep gap. A new problem has no last contact, and no such warning.
    LargeGapChange {
        /// The largest change of the gap in a contact cell divided by the largest displacement of both contacts, in tenths.
        tenths: usize,
    },
    /// The gap before loading resembles the [gap under load](crate::NormalSolution::gap) of an earlier solution. A solve on this gap
    /// deforms the bodies twice. At least a fifth of the contact cells are closed: their gap is above round-off, below 1e-5 of the
    /// displacement, and varies like the residuals of a solve. The gap of most neighbours that are not closed is more than 100 times
    /// larger, and less than a tenth of the displacement. On grids that are periodic along both axes, all cells can be closed.
    ///
    /// The gap under load after wear, a shift of its datum, clipping at zero, or a solve with a tolerance above about 1e-5 is not
    /// recognised.
    ClosedGap {
        /// Number of these cells.
        cells: usize,
    },
    /// The gap of a [`History`](crate::History) decreased in cells that have slipped, and increased in no cell. Wear increases the
    /// gap, so the depth was probably subtracted from the gap instead of added to it. A layer of debris or a thermal expansion that
    /// is confined to slipped cells also has this warning. The return to an earlier gap by
    /// [`set_gap`](crate::History::set_gap) has it too; [`set_state`](crate::History::set_state) does not.
    NegativeWear {
        /// Number of cells with a smaller gap.
        cells: usize,
    },
    /// The contact radius a exceeds 0.3 of the radius of curvature R of the gap. Half-space theory assumes that a/R is
    /// small.
    ///
    /// Both values follow from the slopes of the gap before loading between cells in contact. The curvature 1/R is the
    /// regression coefficient of the slopes on the position along x or along y. The radius a is twice the standard
    /// deviation of the position. On a sphere a/R is accurate to 10 % for a radius of five cells or more. On a cylinder
    /// a/R is 15 % too large on several rows of cells, and accurate to 7 % on a line with 16 contact cells or more.
    /// Roughness does not cause this warning, because its slopes are not correlated with the position.
    LargeContactRadius {
        /// The larger of a/R along x and a/R along y, in thousandths.
        per_mille: usize,
    },
    /// The largest pressure exceeds half of the contact modulus
    /// ([`ElasticPair::contact_modulus`](crate::ElasticPair::contact_modulus), for coated bodies the modulus of the outermost
    /// layers). Half-space theory assumes that strains are small. Common causes are an inconsistent unit of the modulus, the
    /// load or a [prescribed pressure](crate::PressureSource::Prescribed), and a mean pressure given as a force on a periodic grid.
    PressureBeyondModulus {
        /// The largest pressure divided by the contact modulus, in thousandths.
        per_mille: usize,
    },
    /// The mean jump of the gap across the border of a periodic grid exceeds five times the largest mean step between neighbouring
    /// columns or rows. A periodic surface has no border. A common cause is a tilt of the surface, which the grid repeats as a
    /// sawtooth. [`surface::level`](crate::surface::level) removes a tilt.
    ///
    /// The warning requires contact within a sixteenth of the grid from the border, and a mean jump above five times the standard
    /// deviation of the jumps along the border. Rough surfaces without a tilt therefore do not have it, periodic or not. Solutions
    /// on distributed grids do not have it.
    PeriodicSeam {
        /// Whether the gap jumps between the last and the first column.
        along_x: bool,
        /// Whether the gap jumps between the last and the first row.
        along_y: bool,
        /// The larger of the mean jumps along x and along y divided by the largest mean step.
        times: usize,
    },
    /// The solve ended before it converged, so that the solution is its last feasible iterate.
    NotConverged,
    /// The rms slope of the gap before loading within the contact exceeds 0.5. Half-space theory assumes that slopes
    /// are small. If all contact spots are at most two cells wide, the slopes between cells in contact and their other
    /// neighbours are used.
    SteepSurface {
        /// The rms slope, in thousandths.
        per_mille: usize,
    },
    /// Steps of a history specified no tangential load along an axis and kept the shift. The tangential force decreased
    /// by more than half, because the friction under a smaller pressure or a smaller coefficient cannot carry it. The
    /// loss is relative to the largest force since the last step that prescribed this load, or since the last warning.
    /// Steps that roll, twist or change a relative displacement do not have this warning.
    HeldShiftLostForce {
        /// The lost fraction of the tangential force, in per cent.
        per_cent: usize,
    },
    /// A history has a [relative displacement](crate::history::HistoryBuilder::relative_displacement). Its amount is zero, and a
    /// step prescribed a tangential load without an amount. The displacement, for instance by a bulk strain, then has no effect.
    /// A step that prescribes the amount zero does not have this warning.
    UnusedRelativeDisplacement,
    /// A cycle contains a closed loop of force and shift, and further steps that repeat it. Energies and slip distances of the
    /// cycle are then sums over several loops. [`Cycle::begin`](crate::history::Cycle::begin) starts a new cycle.
    ///
    /// A minor loop within a cycle, after which the path continues as before it, can also have this warning. Minor loops occur under
    /// variable amplitudes or higher harmonics.
    RepeatedLoop,
    /// The loads of a cycle turn back towards their start, but its
    /// [residual](crate::history::Cycle::cyclic_residual) exceeds 0.1. Its energies and slip distances then differ from those of a
    /// steady cycle. The first cycle from rest usually has such a residual. A path in one direction does not have this warning.
    OpenCycle {
        /// The residual, in per cent.
        per_cent: usize,
    },
    /// The rolling of bodies that couple pressure and traction neglects the effect of tractions on the pressure, and the neglected lift exceeds
    /// the tolerance. [`CoupledRollingProblem`](crate::rolling::CoupledRollingProblem) and a [`History`](crate::History)
    /// with [full coupling](crate::Coupling::Full) include this effect.
    ///
    /// The lift is the normal displacement due to the tractions. Its measure is half its range within the contact,
    /// divided by the largest normal displacement due to the pressure.
    NeglectedLift {
        /// The measure of the neglected lift in millionths, rounded up.
        per_million: usize,
    },
    /// The scalar model with [one-way coupling](crate::Coupling::OneWay) neglects tractions across its axis, and
    /// [Dundurs' beta](crate::ElasticPair::dundurs_beta) exceeds half of the mean coefficient of friction. For coated bodies the
    /// ratio of their [response](crate::ElasticPair::response) replaces beta. Pressure draws the surfaces inwards in all
    /// directions, so that the neglected tractions reduce the stick zone. The
    /// [vector model](crate::TangentialModel::Vector) and [full coupling](crate::Coupling::Full) include these tractions.
    ///
    /// On a sphere that is pressed in 16 steps, under tangential forces of 0.3 and 0.7 of the friction capacity, the stick ratio is
    /// 5 and 10 % too large at a ratio of 0.5. At a ratio of 1 it is 25 and 40 % too large. For a
    /// [`TangentialProblem`](crate::TangentialProblem), which presses in one step, it is 22 to 28 % too large at a ratio of 0.5, and
    /// about 100 % too large at a ratio of 1. Contacts that do not vary across the axis do not have this warning.
    NeglectedTraction {
        /// Dundurs' beta divided by the mean coefficient of friction, in per cent.
        per_cent: usize,
    },
    /// A layer of a [coated](crate::Material::coated) body is more than ten times as thick as the longest side of the grid.
    /// The solution is then almost that of a contact without the material below this layer. A common cause is an inconsistent
    /// unit of the thickness.
    CoatingBeyondGrid {
        /// The thickness divided by the longest side of the grid.
        sides: usize,
    },
    /// A layer of a [coated](crate::Material::coated) body is so thin that its effect is smaller than the discretisation error.
    /// The thickness times the ratio of the shear moduli of layer and body (or its reciprocal, if larger) is less than a
    /// hundredth of a cell side. The solution then differs by a few thousandths at most from a contact without this layer. A
    /// common cause is an inconsistent unit of the thickness.
    CoatingBelowCell {
        /// The shorter side of a cell divided by the thickness.
        parts: usize,
    },
    /// The refinement of an adaptive contact ended at a limit before all estimated errors reached their targets. The
    /// [status](crate::adaptive::AdaptiveSolution::status) states the limit.
    AccuracyNotReached {
        /// The largest ratio of an estimated error to its target, in tenths. It is zero if no error was estimated.
        tenths: usize,
    },
}
