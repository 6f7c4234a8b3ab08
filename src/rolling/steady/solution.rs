//! The solution of steady rolling.

use crate::contact::map::ContactMap;
use crate::error::Result;
#[cfg(feature = "serde")]
use crate::error::{all_finite, finite, length};
use crate::grid::Grid;
use crate::grid::boundary::Boundary;
use crate::grid::field::Field;
use crate::grid::record::record;
use crate::memory::fallible::{filled, try_each, unwrap_or_abort};
use crate::normal::Scale;
use crate::parallel::reduce;
use crate::report::Report;
use crate::rolling::RollingProblem;
use crate::support::debug::shown;
use crate::tangential::{Friction, FrictionScale, Zone, centre, is_at_limit};
use crate::warning::Warning;

record! {
    /// Traction, slip, zones, creepage and dissipation of steady rolling. Equality compares the results and ignores the
    /// report.
    pub struct RollingSolution {
        buffers {
            traction: [Field; 2],
            slip: [Field; 2],
            zones: Vec<Zone>,
        }
        values {
            creepage: [f64; 2],
            spin: f64,
            /// Lift due to the tractions that the pressure ignores, in millionths of the normal displacement. `None` if the lift
            /// needs no warning.
            #[cfg_attr(feature = "serde", serde(default))]
            neglected_lift: Option<usize>,
            /// Coefficient and cap of the friction, stored for warnings.
            #[cfg_attr(feature = "serde", serde(default))]
            friction_scale: FrictionScale,
            /// Warning about a prescribed pressure far below or above the contact modulus.
            #[cfg_attr(feature = "serde", serde(default))]
            pressure_warning: Option<Warning>,
            #[cfg_attr(feature = "serde", serde(default))]
            boundary: Boundary,
            /// Vector from the position of a particle after a step to the middle of its path.
            halfway: [f64; 2],
        }
        ignored {
            /// Scales of a normal contact that the solver has computed.
            #[cfg_attr(feature = "serde", serde(default))]
            scale: Scale,
            report: Report,
        }
        local {}
    }
    #[serde(remote = "RollingSolution", deny_unknown_fields)]
    check(read) {
        let grid = read.grid();
        for axis in 0..2 {
            read.traction[axis].check("traction", grid)?;
            read.slip[axis].check("slip", grid)?;
        }
        length("list of zones", grid.cells(), read.zones.len())?;
        all_finite("creepage", &read.creepage)?;
        all_finite("half of a path", &read.halfway)?;
        finite("spin", read.spin).map(|_| ())
    }
}

shown!(RollingSolution: grid(), force(), creepage(), spin(), stick_ratio(), report);

impl RollingSolution {
    pub(in crate::rolling) fn empty(grid: Grid) -> Result<Self> {
        Ok(Self {
            traction: try_each(|_| Field::try_zeros(grid))?,
            slip: try_each(|_| Field::try_zeros(grid))?,
            zones: filled(Zone::Separated, grid.cells())?,
            creepage: [0.0; 2],
            spin: 0.0,
            neglected_lift: None,
            friction_scale: FrictionScale::default(),
            pressure_warning: None,
            boundary: Boundary::default(),
            halfway: [0.0; 2],
            scale: Scale::default(),
            report: Report::with_room(),
        })
    }

    /// Sets the tractions and the slip over a step of the cells of a window.
    pub(in crate::rolling) fn of(
        &mut self,
        problem: &RollingProblem,
        traction: impl Fn(usize) -> [f64; 2],
        slip: impl Fn(usize) -> [f64; 2],
    ) -> &mut Self {
        for field in self.traction.iter_mut().chain(&mut self.slip) {
            field.as_mut_slice().fill(0.0);
        }
        self.zones.fill(Zone::Separated);
        self.boundary = problem.bodies.boundary();
        self.halfway = problem.halfway();
        let pressed = &problem.pressed;
        let friction = problem.friction.within(&pressed.region);
        let capacities = friction.capacities(pressed.region.layout(), &pressed.pressure);
        self.friction_scale = FrictionScale::of(&problem.bodies, &problem.friction, capacities);
        let of_pressure = || pressed.pressure_warning(&problem.bodies);
        self.pressure_warning = problem.is_prescribed.then(of_pressure).flatten();
        self.scale = problem.scale;
        for (cell, index) in pressed.window().indices().enumerate() {
            if pressed.pressure[cell] <= 0.0 {
                continue;
            }
            let (q, moved) = (traction(cell), slip(cell));
            let is_at_limit = is_at_limit(q[0].hypot(q[1]), pressed.limits.cells[cell]);
            // Motion along the traction is part of the residual of the solve.
            let slips = is_at_limit && q[0] * moved[0] + q[1] * moved[1] <= 0.0;
            for axis in 0..2 {
                self.traction[axis].as_mut_slice()[index] = q[axis];
                if slips {
                    self.slip[axis].as_mut_slice()[index] = moved[axis] / problem.length;
                }
            }
            self.zones[index] = if is_at_limit { Zone::Slip } else { Zone::Stick };
        }
        self
    }

    /// Reduces tractions beyond the friction limits of a new pressure to the limits. Cells without pressure become separated.
    pub(in crate::rolling) fn restrict_to(&mut self, friction: &Friction, pressure: &Field) {
        let ([x, y], [slip_x, slip_y]) = (&mut self.traction, &mut self.slip);
        let [x, y, slip_x, slip_y] = [x, y, slip_x, slip_y].map(Field::as_mut_slice);
        for (cell, (zone, &pressure)) in self.zones.iter_mut().zip(pressure.as_slice()).enumerate()
        {
            let (limit, size) = (friction.limit(cell, pressure), x[cell].hypot(y[cell]));
            if pressure <= 0.0 {
                (x[cell], y[cell]) = (0.0, 0.0);
                (slip_x[cell], slip_y[cell]) = (0.0, 0.0);
                *zone = Zone::Separated;
            } else if size > limit {
                x[cell] *= limit / size;
                y[cell] *= limit / size;
                *zone = Zone::Slip;
            } else if *zone == Zone::Separated {
                *zone = Zone::Stick;
            }
        }
    }

    pub(in crate::rolling) fn set_motion(
        &mut self,
        creepage: [f64; 2],
        spin: f64,
        report: &Report,
    ) {
        (self.creepage, self.spin) = (creepage, spin);
        self.report.clone_from(report);
    }

    /// Sets the lift due to the tractions that the pressure ignores, in millionths of the normal displacement.
    pub(in crate::rolling) fn set_neglected_lift(&mut self, lift: Option<usize>) {
        self.neglected_lift = lift;
    }

    pub(in crate::rolling) fn set_report(&mut self, report: &Report) {
        self.report.clone_from(report);
    }

    /// Returns the grid of all fields.
    #[must_use]
    pub fn grid(&self) -> Grid {
        self.traction[0].grid()
    }

    /// Returns the traction q on body 1 along x and y (pressures), which is zero outside the contact.
    #[must_use]
    pub fn traction(&self) -> [&Field; 2] {
        self.traction.each_ref()
    }

    /// Returns the slip of the surface of body 1 over the surface of body 2 per length rolled (dimensionless). The slip belongs
    /// to the step that brought the particles to their current positions. In slip cells the slip is opposite to the traction, up
    /// to the tolerance. The slip is zero in all other cells, and in cells at their limit whose residual motion is along the
    /// traction.
    #[must_use]
    pub fn slip(&self) -> [&Field; 2] {
        self.slip.each_ref()
    }

    /// Returns the zone of every cell, row-major with x fastest.
    #[must_use]
    pub fn zones(&self) -> &[Zone] {
        &self.zones
    }

    /// Returns the creepages $`\xi, \eta`$, prescribed or caused by the force (dimensionless).
    #[must_use]
    pub fn creepage(&self) -> [f64; 2] {
        self.creepage
    }

    /// Returns the spin, prescribed or caused by the moment (one over a length).
    #[must_use]
    pub fn spin(&self) -> f64 {
        self.spin
    }

    /// Returns the tangential force that body 2 exerts on body 1, the integral of the traction.
    #[must_use]
    pub fn force(&self) -> [f64; 2] {
        self.traction.each_ref().map(Field::integral)
    }

    /// Returns the moment of the tractions on body 1 about the origin of the grid (a force times a length, positive from x to
    /// y). Each traction acts at the centre of its cell.
    #[must_use]
    pub fn moment(&self) -> f64 {
        let grid = self.grid();
        let [x, y] = self.traction();
        let (x, y) = (x.as_slice(), y.as_slice());
        let part = |cell| {
            let [px, py] = centre(grid, cell);
            px * y[cell] - py * x[cell]
        };
        reduce::sum(&grid.layout(), part) * grid.cell_area()
    }

    /// Returns the work of creepages and spin per length rolled (a force),
    ///
    /// ```math
    /// \xi F_x + \eta F_y + \varphi \, (M + h_x F_y - h_y F_x) ,
    /// ```
    ///
    /// with the [moment](Self::moment) M and the vector h of half a step towards the leading edge. The spin moves a particle by
    /// the displacement at the middle of its path. The contribution of h decreases with the step.
    ///
    /// Between bodies of the same material all of the work is dissipated, including the work at the trailing edge. The work is
    /// more accurate than the integral of the [dissipation](Self::dissipation_per_area). This integral never exceeds the work.
    /// Between bodies of different materials the pressure also does work, which is not included. Such bodies dissipate energy
    /// even without a creepage force.
    #[must_use]
    pub fn work(&self) -> f64 {
        let ([x, y], [xi, eta]) = (self.force(), self.creepage);
        let [ahead_x, ahead_y] = self.halfway;
        let about_middles = self.moment() + ahead_x * y - ahead_y * x;
        xi * x + eta * y + self.spin * about_middles
    }

    /// Returns the energy that slip dissipates in each cell per area and per length rolled, $`-q \cdot s`$ (a pressure).
    ///
    /// The cells are fixed in the contact, and the particles of both surfaces pass through them. The value of a cell is therefore
    /// not the wear of a particle. A particle loses the following depth in each passage: the wear coefficient times the sum of
    /// the values over the cells of its line along the rolling direction, times their side along this line. The depth is uniform
    /// along the line: add it to whole lines of the gap, not to single cells. A wheel with the circumference U makes L/U passages
    /// over the length L. The guide has an [example](crate::guide::rolling#wear-in-steady-rolling).
    ///
    /// The energy is evaluated with the tractions at the end of a step. Between bodies of the same material the integral of this
    /// energy is therefore less than the [work](Self::work). The difference decreases with the cell size.
    ///
    /// # Errors
    /// - [`Error::Memory`](crate::Error::Memory) if memory runs out.
    pub fn dissipation_per_area(&self) -> Result<Field> {
        let mut dissipation = Field::try_zeros(self.grid())?;
        for (q, s) in self.traction.iter().zip(&self.slip) {
            let products = q.as_slice().iter().zip(s.as_slice());
            for (sum, (q, s)) in dissipation.as_mut_slice().iter_mut().zip(products) {
                *sum -= q * s;
            }
        }
        Ok(dissipation)
    }

    /// Returns the ratio of sticking cells to cells in contact, or zero without contact.
    #[must_use]
    pub fn stick_ratio(&self) -> f64 {
        let count = |zone: Zone| self.zones.iter().filter(|z| **z == zone).count();
        let (stick, slip) = (count(Zone::Stick), count(Zone::Slip));
        stick as f64 / (stick + slip).max(1) as f64
    }

    /// Returns the warnings about the solution (see [`Warning`]). They include [`Warning::NeglectedLift`] if tractions of
    /// dissimilar bodies change the pressure by more than the tolerance, [`Warning::LargeCreepage`],
    /// [`Warning::LargeFriction`], [`Warning::LowShearStress`] or [`Warning::ShearStressBeyondModulus`], and
    /// [`Warning::LowPressure`] or [`Warning::PressureBeyondModulus`] for a prescribed pressure. If the solver has computed the pressure after
    /// [`set_normal_load`](crate::rolling::RollingSolver::set_normal_load), the warnings also concern the gap, the approach and the
    /// size of this pressure. Otherwise the solution that was set as pressure has its own warnings.
    #[must_use]
    pub fn warnings(&self) -> Vec<Warning> {
        let contains = |cell: usize| self.zones[cell] != Zone::Separated;
        let map = ContactMap::of(self.grid(), self.boundary, contains, None);
        let mut warnings = unwrap_or_abort(map.warnings());
        let [lift, of_loads @ ..] = self.load_warnings();
        warnings.extend(lift);
        warnings.extend(Warning::of_status(self.report.status));
        warnings.extend(of_loads.into_iter().flatten());
        warnings.extend(self.scale.warnings());
        warnings
    }

    /// Returns the warnings about a neglected lift, the creepage and the spin, the coefficient of friction, its cap, and a
    /// prescribed pressure.
    pub(in crate::rolling) fn load_warnings(&self) -> [Option<Warning>; 5] {
        let lift = self.neglected_lift;
        let [friction, cap] = self.friction_scale.warnings();
        [
            lift.map(|per_million| Warning::NeglectedLift { per_million }),
            self.creepage_warning(),
            friction,
            cap,
            self.pressure_warning,
        ]
    }

    fn creepage_warning(&self) -> Option<Warning> {
        let columns = self.grid().nx();
        let contact = (0..self.zones.len()).filter(|cell| self.zones[*cell] != Zone::Separated);
        let distance = contact.map(|cell| {
            let [x, y] = self.grid().position(cell % columns, cell / columns);
            x.hypot(y)
        });
        let by_spin = self.spin * distance.fold(0.0, f64::max);
        let per_cent = Warning::creepage_beyond(self.creepage, by_spin)?;
        Some(Warning::LargeCreepage { per_cent })
    }

    /// Returns the report of the solve with its certified error.
    #[must_use]
    pub fn report(&self) -> &Report {
        &self.report
    }
}
