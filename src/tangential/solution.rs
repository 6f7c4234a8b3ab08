//! Solution of a tangential contact.

use crate::bodies::material::ElasticPair;
use crate::cgm::reduce;
use crate::contact::map::ContactMap;
use crate::contact::pressure_fingerprint::PressureFingerprint;
use crate::error::{Error, Result};
#[cfg(feature = "serde")]
use crate::error::{all_finite, finite, length};
use crate::grid::Grid;
use crate::grid::boundary::Boundary;
use crate::grid::cell_value::CellValue;
use crate::grid::discretisation::estimate;
use crate::grid::field::Field;
use crate::grid::record::record;
use crate::half_space::HalfSpace;
use crate::memory::fallible::{self, try_each, unwrap_or_abort};
use crate::report::Report;
use crate::support::debug::shown;
use crate::tangential::over_ranks::{ShearSums, TractionSums};
use crate::tangential::rigid_motion::centre;
use crate::tangential::{
    Axis, Friction, FrictionScale, RelativeDisplacement, StepSolution, Zone, displacement,
};
use crate::warning::{Resolution, Warning};

record! {
    /// Traction, slip, zones and shift of a tangential contact.
    ///
    /// Vectors are `[x, y]`. In the scalar model the component across the load is zero. Equality compares the results and
    /// ignores the report.
    pub struct TangentialSolution {
        buffers {
            traction: [Field; 2],
            slip: [Field; 2],
            zones: Vec<Zone>,
        }
        values {
            boundary: Boundary,
            cell_value: CellValue,
            pair: ElasticPair,
            axis: Option<Axis>,
            shift: [f64; 2],
            twist: f64,
            /// Dundurs' beta of the bodies if the solution belongs to a coupled solution.
            coupled: Option<f64>,
            /// Whether a contact of dissimilar bodies with friction was pressed to its size in one step.
            #[cfg_attr(feature = "serde", serde(default))]
            is_pressed_at_once: bool,
            /// Whether no cell slips, but the outermost cells contain a slip zone.
            #[cfg_attr(feature = "serde", serde(default))]
            hides_slip: bool,
            /// Coefficient and cap of the friction, stored for warnings.
            #[cfg_attr(feature = "serde", serde(default))]
            friction_scale: FrictionScale,
            /// Warning about a prescribed pressure far below or above the contact modulus.
            #[cfg_attr(feature = "serde", serde(default))]
            pressure_warning: Option<Warning>,
            /// Dundurs' beta over the mean coefficient of friction in per cent, if the model neglects large tractions.
            #[cfg_attr(feature = "serde", serde(default))]
            coupling_per_cent: Option<usize>,
            /// Largest relative displacement in the contact over the longest side of the grid, in tenths, if it is large.
            #[cfg_attr(feature = "serde", serde(default))]
            displacement_tenths: Option<usize>,
            /// Largest component of the bulk strain in thousandths, if it is large.
            #[cfg_attr(feature = "serde", serde(default))]
            strain_per_mille: Option<usize>,
        }
        ignored {
            /// Sums that identify the pressure of the problem.
            pressed: PressureFingerprint,
            report: Report,
        }
        local {
            /// Counts and sums over all ranks, if the fields are a slab.
            whole: Option<Box<ShearSums>>,
        }
    }
    #[serde(remote = "TangentialSolution")]
    check(read) {
        let grid = read.grid();
        for axis in 0..2 {
            read.traction[axis].check("traction", grid)?;
            read.slip[axis].check("slip", grid)?;
        }
        length("list of zones", grid.cells(), read.zones.len())?;
        all_finite("shift", &read.shift)?;
        finite("twist", read.twist).map(|_| ())
    }
}

shown!(TangentialSolution: grid(), force(), shift(), twist(), stick_ratio(), discretisation_estimate(), report);

impl TangentialSolution {
    /// Creates a solution without contact.
    pub(crate) fn empty(bodies: &HalfSpace) -> Result<Self> {
        let grid = bodies.grid();
        let zeros = || try_each(|_| Field::try_zeros(grid));
        Ok(Self {
            traction: zeros()?,
            slip: zeros()?,
            zones: fallible::filled(Zone::Separated, grid.cells())?,
            boundary: bodies.boundary(),
            cell_value: bodies.cell_value(),
            pair: *bodies.pair(),
            axis: Some(Axis::X),
            shift: [0.0; 2],
            twist: 0.0,
            coupled: None,
            is_pressed_at_once: false,
            hides_slip: false,
            friction_scale: FrictionScale::default(),
            pressure_warning: None,
            coupling_per_cent: None,
            displacement_tenths: None,
            strain_per_mille: None,
            pressed: PressureFingerprint::default(),
            report: Report::with_room(),
            whole: None,
        })
    }

    pub(crate) fn fill(
        &mut self,
        bodies: &HalfSpace,
        (axis, friction, relative): (Option<Axis>, &Friction, Option<&RelativeDisplacement>),
        answer: &StepSolution<'_>,
        report: &Report,
    ) {
        self.zones.fill(Zone::Separated);
        for field in self.traction.iter_mut().chain(&mut self.slip) {
            field.as_mut_slice().fill(0.0);
        }
        (self.axis, self.cell_value) = (axis, bodies.cell_value());
        self.pair = *bodies.pair();
        self.friction_scale = FrictionScale::of(bodies, friction, answer.capacities(friction));
        (self.shift, self.twist) = (answer.motion.shift, answer.motion.twist);
        self.report.clone_from(report);
        answer.with_held(|answer| {
            self.enter(answer);
            self.pressed = answer.pressure_fingerprint(self.grid());
        });
        self.strain_per_mille = relative.and_then(|relative| relative.large_strain(bodies, 1.0));
        self.displacement_tenths = relative.and_then(|relative| {
            let contains = |cell: usize| self.zones[cell] != Zone::Separated;
            let displacement = |axis, cell| relative.at(axis, cell);
            let largest = RelativeDisplacement::largest_in(bodies, contains, displacement);
            Warning::shift_beyond(self.grid(), [largest, 0.0])
        });
        self.whole = ShearSums::of(bodies, &self.traction, &self.slip, &self.zones);
        self.hides_slip = self.friction_scale.is_common()
            && answer.with_held(|answer| answer.hides_slip(|cell| answer.traction(cell)));
    }

    /// Sets Dundurs' beta if the solution belongs to a coupled solution, in which the tractions have changed the
    /// pressure.
    pub(crate) fn set_coupled(&mut self, beta: Option<f64>) {
        self.coupled = beta;
    }

    /// Sets whether a contact of dissimilar bodies with friction was pressed to its size in one step.
    pub(crate) fn set_pressed_at_once(&mut self, is_at_once: bool) {
        self.is_pressed_at_once = is_at_once;
    }

    /// Sets Dundurs' beta over the mean coefficient of friction in per cent, if the model neglects large tractions.
    pub(crate) fn set_neglected_traction(&mut self, per_cent: Option<usize>) {
        self.coupling_per_cent = per_cent;
    }

    /// Sets the warning about the prescribed pressure, or `None` for the pressure of a solved contact.
    pub(crate) fn set_pressure_warning(&mut self, warning: Option<Warning>) {
        self.pressure_warning = warning;
    }

    /// Returns the warning for a contact that was pressed in one step.
    pub(crate) fn pressing_warning(&self) -> Option<Warning> {
        self.is_pressed_at_once.then_some(Warning::SingleLoadStep)
    }

    /// Returns an error if the pressure depends on the tractions.
    pub(crate) fn check_uncoupled(&self) -> Result<()> {
        match self.coupled {
            Some(beta) => Err(Error::CoupledMaterials { beta }),
            None => Ok(()),
        }
    }

    /// Writes the solution in the local contact cells.
    fn enter(&mut self, answer: &StepSolution<'_>) {
        let grid = self.grid();
        for (k, i) in answer.region.held().indices().enumerate() {
            if answer.pressure[k] <= 0.0 {
                continue;
            }
            let slip = answer.slip(k, answer.relative(k, centre(grid, i)));
            let slip = slip.unwrap_or([0.0; 2]);
            let traction = answer.traction(k);
            for axis in 0..2 {
                self.traction[axis].as_mut_slice()[i] = traction[axis];
                self.slip[axis].as_mut_slice()[i] = slip[axis];
            }
            self.zones[i] = answer.zone(k);
        }
    }

    /// Returns an error if the solution does not belong to equal bodies.
    pub(crate) fn check_bodies(&self, bodies: &HalfSpace) -> Result<()> {
        let quantity = "tangential contact";
        bodies.check_host(quantity, self.grid(), self.boundary)?;
        bodies.check_values(quantity, self.cell_value)?;
        bodies.check_pair(quantity, &self.pair)
    }

    /// Returns the materials of the two bodies.
    pub(crate) fn pair(&self) -> &ElasticPair {
        &self.pair
    }

    /// Returns the sums that identify the pressure of the problem.
    pub(crate) fn pressure_fingerprint(&self) -> PressureFingerprint {
        self.pressed
    }

    /// Returns the grid of all fields.
    #[must_use]
    pub fn grid(&self) -> Grid {
        self.traction[0].grid()
    }

    /// Returns the shear traction q on body 1 along x and along y (pressures), positive along the axis. The traction is
    /// exactly zero outside the contact.
    #[doc(alias = "shear stress")]
    #[must_use]
    pub fn traction(&self) -> [&Field; 2] {
        self.traction.each_ref()
    }

    /// Returns the slip `s = u - delta` of the surface of body 1 over the surface of body 2 (lengths). The slip is
    /// opposite to the traction in slip cells, and exactly zero in stick cells and outside the contact.
    #[must_use]
    pub fn slip(&self) -> [&Field; 2] {
        self.slip.each_ref()
    }

    /// Returns the boundary condition at the edge of the grid.
    #[must_use]
    pub fn boundary(&self) -> Boundary {
        self.boundary
    }

    /// Returns the meaning of the value of a cell.
    #[must_use]
    pub fn cell_value(&self) -> CellValue {
        self.cell_value
    }

    /// Returns the zone of every cell, row-major with x fastest.
    #[must_use]
    pub fn zones(&self) -> &[Zone] {
        &self.zones
    }

    /// Returns the axis of the load in the scalar model, or `None` in the vector model.
    #[must_use]
    pub fn axis(&self) -> Option<Axis> {
        self.axis
    }

    /// Returns the shift delta, the rigid motion of body 2 relative to body 1 (lengths, with the sign of the force).
    /// The literature calls it the relative rigid tangential displacement. It is the prescribed shift or the multiplier of
    /// the force. On a periodic grid the shift is measured from the mean plane of the surface.
    ///
    /// Under a force that slides the whole contact, the shift is the value at which the last cell starts to slip. In
    /// the vector model this value is the displacement of the last cell. The slip of the other cells is not yet
    /// parallel to their traction.
    #[must_use]
    pub fn shift(&self) -> [f64; 2] {
        self.shift
    }

    /// Returns the prescribed rotation of body 2 relative to body 1 (radians, positive from x to y). The axis of the
    /// rotation passes through the origin of the grid.
    #[must_use]
    pub fn twist(&self) -> f64 {
        self.twist
    }

    /// Returns the tangential force that body 2 exerts on body 1, the integral of the traction.
    #[must_use]
    pub fn force(&self) -> [f64; 2] {
        match &self.whole {
            Some(whole) => whole.sums.force.map(|sum| sum * self.grid().cell_area()),
            None => self.traction.each_ref().map(Field::integral),
        }
    }

    /// Returns the moment of the tractions on body 1 about the origin of the grid (force times length, positive from x
    /// to y).
    #[must_use]
    pub fn moment(&self) -> f64 {
        self.sums().moment * self.grid().cell_area()
    }

    /// Computes the displacement of the surface of body 1 relative to the surface of body 2 due to the tractions
    /// (lengths). The result covers all cells, inside and outside the contact. The call takes one product with the
    /// operator of the bodies.
    ///
    /// # Errors
    /// - [`Error::GridMismatch`], [`Error::BoundaryMismatch`], [`Error::CellValueMismatch`] or
    ///   [`Error::MaterialMismatch`] if the solution belongs to other bodies.
    /// - Errors of [`HalfSpace::operator`].
    pub fn displacement(&self, bodies: &HalfSpace) -> Result<[Field; 2]> {
        bodies.collective_result(self.check_bodies(bodies))?;
        let axes = self.axis.map_or(Axis::BOTH, Axis::alone);
        displacement(bodies, axes, self.traction())
    }

    /// Computes the elastic energy of shear, $`\tfrac A2 \sum q \cdot u`$ (force times length).
    ///
    /// For dissimilar bodies, this energy excludes the displacement due to the pressure. The energies of both halves of a coupled
    /// solution do not add up to [`CoupledSolution::elastic_energy`](crate::CoupledSolution::elastic_energy). See
    /// [`NormalSolution::elastic_energy`](crate::NormalSolution::elastic_energy).
    ///
    /// # Errors
    /// Errors of [`TangentialSolution::displacement`].
    pub fn elastic_energy(&self, bodies: &HalfSpace) -> Result<f64> {
        let displacement = self.displacement(bodies)?;
        let pairs = self.traction.iter().zip(&displacement);
        let energy = pairs.fold(0.0, |sum, (q, u)| {
            let (q, u) = (q.as_slice(), u.as_slice());
            sum + reduce::sum(&bodies.grid_layout(), |i| q[i] * u[i])
        });
        bodies.joint(Ok(0.5 * self.grid().cell_area() * energy))
    }

    /// Returns whether the whole contact slips.
    #[must_use]
    pub fn is_gross_slip(&self) -> bool {
        self.stick_cells() == 0 && self.slip_cells() > 0
    }

    /// Returns the ratio of stick area to contact area from the number of cells, or zero for an empty solution.
    #[must_use]
    pub fn stick_ratio(&self) -> f64 {
        let (stick, slip) = (self.stick_cells(), self.slip_cells());
        if stick == 0 {
            0.0
        } else {
            stick as f64 / (stick + slip) as f64
        }
    }

    /// Returns the area of the stick zone from the number of cells.
    #[must_use]
    pub fn stick_area(&self) -> f64 {
        self.stick_cells() as f64 * self.grid().cell_area()
    }

    /// Returns the area of the slip zone from the number of cells.
    #[must_use]
    pub fn slip_area(&self) -> f64 {
        self.slip_cells() as f64 * self.grid().cell_area()
    }

    /// Returns the energy dissipated by the step, `-Delta sum q s >= 0`, computed from the tractions at the end of the
    /// step.
    #[doc(alias = "dissipated energy")]
    #[must_use]
    pub fn dissipated_energy(&self) -> f64 {
        // A subtraction from zero gives 0 for full stick, whereas a negation would give -0.
        0.0 - self.sums().work * self.grid().cell_area()
    }

    /// Returns the report of the solve: its status, cost and error bound.
    #[must_use]
    pub fn report(&self) -> &Report {
        &self.report
    }

    /// Returns the warnings about results that may be misleading. See [`Warning`].
    #[must_use]
    pub fn warnings(&self) -> Vec<Warning> {
        unwrap_or_abort(self.try_warnings())
    }

    /// Returns the same warnings as [`Self::warnings`], or an error if memory runs out.
    ///
    /// # Errors
    /// - [`Error::Memory`] if memory runs out.
    pub fn try_warnings(&self) -> Result<Vec<Warning>> {
        let mut warnings = self.contact_map().warnings()?;
        warnings.extend(Warning::of_status(self.report.status));
        warnings.extend(self.zone_warnings().chain(self.pressing_warning()));
        warnings.extend(self.load_warnings());
        let contact = || self.contact_map().mean_spot();
        let estimate = self.discretisation_estimate();
        warnings.extend(Warning::of_discretisation(estimate, contact)?);
        Ok(warnings)
    }

    /// Returns the warnings about the stick and slip zones.
    pub(crate) fn zone_warnings(&self) -> impl Iterator<Item = Warning> {
        let cells = [self.stick_cells(), self.slip_cells()];
        let contact = Resolution::of_contact(self.grid().whole(), cells[0] + cells[1]);
        let zones = contact.with_zones(cells, self.hides_slip, || self.contact_map().switches());
        zones.zone_warnings()
    }

    /// Returns the warnings about values of the load: the shift, the relative displacement and its bulk strain, and the twist. The
    /// warnings about the friction, neglected tractions and a prescribed pressure follow.
    pub(crate) fn load_warnings(&self) -> impl Iterator<Item = Warning> {
        let shift = Warning::shift_beyond(self.grid(), self.shift()).max(self.displacement_tenths);
        let twist = Warning::twist_beyond(self.twist());
        let shift = shift.map(|tenths| Warning::ShiftBeyondGrid { tenths });
        let twist = twist.map(|tenths| Warning::LargeTwist { tenths });
        let strain = Warning::of_strain(self.strain_per_mille);
        let of_shift = shift.into_iter().chain(strain).chain(twist);
        let coupling = Warning::of_coupling(self.coupling_per_cent);
        of_shift
            .chain(self.friction_scale.warnings().into_iter().flatten())
            .chain(coupling)
            .chain(self.pressure_warning)
    }

    fn contact_map(&self) -> ContactMap<'_, impl Fn(usize) -> bool + '_> {
        let counted = self.whole.as_ref().map(|whole| &whole.contact);
        let contains = |i: usize| self.zones[i] != Zone::Separated;
        ContactMap::of(self.grid(), self.boundary, contains, counted)
    }

    fn stick_cells(&self) -> usize {
        self.cells(Zone::Stick, |sums| sums.stick)
    }

    fn slip_cells(&self) -> usize {
        self.cells(Zone::Slip, |sums| sums.slip)
    }

    fn cells(&self, zone: Zone, of: impl Fn(&TractionSums) -> usize) -> usize {
        match &self.whole {
            Some(whole) => of(&whole.sums),
            None => self.zones.iter().filter(|&&z| z == zone).count(),
        }
    }

    /// Returns the sums over all cells.
    fn sums(&self) -> TractionSums {
        let sums = || {
            TractionSums::of(
                &self.grid().layout(),
                &self.traction,
                &self.slip,
                &self.zones,
            )
        };
        self.whole.as_ref().map_or_else(sums, |whole| whole.sums)
    }
}

impl TangentialSolution {
    /// Estimates the discretisation error of the tractions in the same way as the error of the pressure
    /// ([`NormalSolution::discretisation_estimate`](crate::NormalSolution::discretisation_estimate)). The estimate is
    /// the sum of the magnitudes of the errors, divided by the sum of the magnitudes of the tractions. A magnitude
    /// includes both components. Returns `None` without traction and on a slab of a distributed grid.
    ///
    /// The table lists the ratio of the estimate to the error relative to exact means in partial slip. The grid has N x
    /// N cells over three contact radii. The contacts are a sphere, a gap r^4 and an ellipse 2 : 1. Each contact has
    /// six positions relative to the cells and loads of 10 to 90 % of the sliding force.
    ///
    /// | slip ring | N | values at the centres | uniform cells |
    /// |---|---|---|---|
    /// | one cell or more | 48 to 192 | 0.78 to 1.29 | 0.86 to 1.15 |
    /// | one cell or more | 32 | 0.77 to 1.23 | 0.85 to 1.13 |
    /// | one cell or more | 24 | 0.81 to 1.57 | 0.84 to 1.27 |
    /// | half a cell to one cell | 24 to 128 | 0.57 to 1.46 | 0.67 to 1.19 |
    /// | less than half a cell | 24 to 64 | 0.43 to 0.88 | 0.58 to 1.03 |
    ///
    /// The ring of an ellipse is measured at its longer half axis. The ratios for spheres lie between 0.81 and 1.23 for
    /// values at the centres of 48 cells or more. A traction can change sign from cell to cell, for instance after many
    /// reversals. Such a traction has a larger error at its many edges than a smooth traction with the same sum of
    /// magnitudes.
    #[must_use]
    pub fn discretisation_estimate(&self) -> Option<f64> {
        estimate(self.traction(), self.boundary(), self.cell_value())
    }
}
