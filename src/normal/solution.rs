//! Solution of a normal contact.

use crate::bodies::component::Component;
use crate::bodies::material::ElasticPair;
use crate::cgm::reduce;
use crate::contact::pressure_fingerprint::PressureFingerprint;
use crate::error::{Error, Result};
#[cfg(feature = "serde")]
use crate::error::{all_non_negative, finite};
use crate::grid::Grid;
use crate::grid::boundary::Boundary;
use crate::grid::cell_value::CellValue;
use crate::grid::discretisation::estimate;
use crate::grid::field::Field;
use crate::grid::record::record;
use crate::half_space::HalfSpace;
use crate::memory::fallible::TryClone;
use crate::normal::Hardness;
use crate::normal::over_ranks::PressureSums;
use crate::normal::scale::Scale;
use crate::operator::Operator;
use crate::parallel;
use crate::report::Report;
use crate::support::debug::shown;
use crate::warning::Warning;

record! {
    /// Pressure, gap and approach of a normal contact. Equality compares the results and ignores the report.
    pub struct NormalSolution {
        buffers {
            pub(super) pressure: Field,
            gap: Field,
        }
        values {
            pub(super) boundary: Boundary,
            cell_value: CellValue,
            pub(super) pair: ElasticPair,
            approach: f64,
            yielded_cells: usize,
            /// Whether tractions of a coupled solve have changed the pressure.
            is_coupled: bool,
        }
        ignored {
            /// Approach, contact radius and slope, stored for warnings.
            #[cfg_attr(feature = "serde", serde(default))]
            scale: Scale,
            /// Limit of the pressure divided by the plane-strain modulus in thousandths, if the limit exceeds this modulus and no
            /// cell has reached it.
            #[cfg_attr(feature = "serde", serde(default))]
            pub(super) hardness_per_mille: Option<usize>,
            report: Report,
        }
        local {
            /// Counts and sums over all ranks, if the fields are a slab.
            pub(super) whole: Option<Box<PressureSums>>,
        }
    }
    #[serde(remote = "NormalSolution")]
    check(read) {
        all_non_negative("pressure", read.pressure.as_slice())?;
        read.gap.check("gap", read.grid())?;
        finite("approach", read.approach).map(|_| ())
    }
}

shown!(NormalSolution: grid(), approach(), force(), contact_cells(), discretisation_estimate(), report);

impl NormalSolution {
    /// Returns whether two solutions have the same pressure, gap and approach on the same bodies.
    #[cfg(feature = "history")]
    pub(crate) fn eq_contact(&self, other: &Self) -> bool {
        self.pressure == other.pressure
            && self.gap == other.gap
            && self.boundary == other.boundary
            && self.cell_value == other.cell_value
            && self.pair == other.pair
            && self.approach == other.approach
    }
}

/// Returns the gap of a cell from its initial gap, displacement and approach.
fn under_load(initial: f64, displacement: f64, approach: f64) -> f64 {
    displacement + (initial - approach)
}

impl NormalSolution {
    /// Creates a solution without contact.
    pub(crate) fn empty(
        gap: &Field,
        (boundary, cell_value): (Boundary, CellValue),
        pair: &ElasticPair,
    ) -> Result<Self> {
        Ok(Self {
            pressure: Field::try_zeros(gap.grid())?,
            gap: gap.try_clone()?,
            boundary,
            cell_value,
            pair: *pair,
            approach: 0.0,
            yielded_cells: 0,
            is_coupled: false,
            scale: Scale::default(),
            hardness_per_mille: None,
            report: Report::with_room(),
            whole: None,
        })
    }

    /// Returns the solution with zero fields on another part of the grid.
    #[cfg(feature = "history")]
    pub(crate) fn outline_on(&self, grid: Grid) -> Result<Self> {
        Ok(Self {
            pressure: Field::try_zeros(grid)?,
            gap: Field::try_zeros(grid)?,
            report: self.report.clone(),
            whole: self.whole.clone(),
            ..*self
        })
    }

    /// Creates the solution from pressures and displacements of all cells and the initial gap.
    pub(crate) fn of(
        bodies: &HalfSpace,
        initial: &Field,
        [pressure, mut gap]: [Vec<f64>; 2],
        approach: f64,
        report: Report,
    ) -> Result<Self> {
        let initial_gap = initial.as_slice();
        parallel::update(&mut gap, |first, chunk| {
            for (gap, initial) in chunk.iter_mut().zip(&initial_gap[first..]) {
                *gap = under_load(*initial, *gap, approach);
            }
        });
        Ok(Self {
            whole: PressureSums::of(bodies, &pressure),
            scale: Scale::of(bodies, initial_gap, &pressure, approach),
            pressure: Field::from_vec(initial.grid(), pressure)?,
            gap: Field::from_vec(initial.grid(), gap)?,
            boundary: bodies.boundary(),
            cell_value: bodies.cell_value(),
            pair: *bodies.pair(),
            approach,
            yielded_cells: 0,
            is_coupled: false,
            hardness_per_mille: None,
            report,
        })
    }

    /// Computes the counts and sums over all ranks, which the fields of a slab do not contain.
    pub(crate) fn gather_whole(&mut self, bodies: &HalfSpace) {
        self.whole = PressureSums::of(bodies, self.pressure.as_slice());
    }

    /// Computes approach, contact radius and slope from the initial gap.
    pub(crate) fn measure_scale(&mut self, bodies: &HalfSpace, initial: &Field) {
        let pressure = self.pressure.as_slice();
        self.scale = Scale::of(bodies, initial.as_slice(), pressure, self.approach);
    }

    /// Records wear of the gap since the last solve, relative to the displacement.
    pub(crate) fn set_wear(&mut self, ratio: f64) {
        self.scale.gap_change_tenths = Warning::wear_beyond(ratio);
    }

    pub(crate) fn scale(&self) -> Scale {
        self.scale
    }

    /// Sets whether the solution belongs to a coupled solution, in which tractions have changed the pressure.
    pub(crate) fn set_coupled(&mut self, is_coupled: bool) {
        self.is_coupled = is_coupled;
    }

    /// Returns an error if tractions have changed the pressure.
    pub(crate) fn check_uncoupled(&self) -> Result<()> {
        let beta = self.pair.coupling_strength();
        if self.is_coupled {
            return Err(Error::CoupledMaterials { beta });
        }
        Ok(())
    }

    /// Sets the number of cells whose pressure is at the hardness, and the smallest hardness of a contact cell.
    pub(crate) fn set_yielded_cells(&mut self, cells: usize, least_hardness: f64) {
        self.yielded_cells = cells;
        let ratio = self.pair.limit_over_modulus(least_hardness);
        self.hardness_per_mille = ratio.filter(|_| cells == 0).and_then(Warning::limit_beyond);
    }

    /// Compares the pressure with the hardness of the contact, or with none. The function is collective.
    pub(crate) fn compare_with(&mut self, bodies: &HalfSpace, hardness: Option<&Hardness>) {
        let pressure = self.pressure.as_slice();
        let cells = hardness.map_or(0, |of| of.reached_cells(bodies, pressure));
        let least = hardness.map_or(f64::INFINITY, |of| {
            bodies.least_of(of.least_limit(pressure))
        });
        self.set_yielded_cells(cells, least);
    }

    pub(crate) fn pressure_mut(&mut self) -> &mut [f64] {
        self.pressure.as_mut_slice()
    }

    /// Sets the gap under load and the approach from the initial gap and the displacements under the present pressure.
    pub(crate) fn fill(
        &mut self,
        bodies: &HalfSpace,
        initial: &Field,
        displacement: &[f64],
        approach: f64,
        report: &Report,
    ) {
        (self.pair, self.cell_value) = (*bodies.pair(), bodies.cell_value());
        // The solution may have been written by another history before.
        (self.yielded_cells, self.is_coupled) = (0, false);
        self.hardness_per_mille = None;
        self.gather_whole(bodies);
        let initial = initial.as_slice();
        parallel::update(self.gap.as_mut_slice(), |first, chunk| {
            let samples = initial[first..].iter().zip(&displacement[first..]);
            for (gap, (initial, displacement)) in chunk.iter_mut().zip(samples) {
                *gap = under_load(*initial, *displacement, approach);
            }
        });
        self.approach = approach;
        self.report.clone_from(report);
    }

    /// Returns pressure, gap under load, approach and report for restoring a saved state.
    pub(crate) fn parts_mut(&mut self) -> (&mut Field, &mut Field, &mut f64, &mut Report) {
        (
            &mut self.pressure,
            &mut self.gap,
            &mut self.approach,
            &mut self.report,
        )
    }

    /// Returns the pressure and the gap under load, from which the caller subtracts the plastic overlap.
    pub(crate) fn yielding_mut(&mut self) -> (&[f64], &mut [f64]) {
        (self.pressure.as_slice(), self.gap.as_mut_slice())
    }

    /// Returns the grid of all fields.
    #[must_use]
    pub fn grid(&self) -> Grid {
        self.pressure.grid()
    }

    /// Returns the pressure p >= 0, positive if it pushes into the bodies. The pressure is exactly zero outside the
    /// contact. Each value is either the uniform pressure of its cell or the pressure at the centre of the cell
    /// ([`cell_value`](Self::cell_value)).
    #[must_use]
    pub fn pressure(&self) -> &Field {
        &self.pressure
    }

    /// Returns the gap under load `h + u_z - delta` (lengths). The gap is zero in the contact up to the residual, and
    /// positive outside the contact. It is negative in cells that yield under a [`Hardness`].
    #[must_use]
    pub fn gap(&self) -> &Field {
        &self.gap
    }

    /// Returns the approach delta of the bodies from the datum of the initial gap (a length). It is the prescribed
    /// approach or the multiplier of the force. On a periodic grid the approach is the mean initial gap minus the mean
    /// gap under load.
    #[doc(alias = "indentation")]
    #[doc(alias = "penetration")]
    #[must_use]
    pub fn approach(&self) -> f64 {
        self.approach
    }

    /// Returns the normal force W, the integral of the pressure. For any [`CellValue`] the force is the sum of the cell
    /// values times the area of a cell. The `force` of a tangential solution, a step or a history is the tangential
    /// force. The normal force of a step is [`normal_force`](crate::history::StepResult::normal_force).
    #[must_use]
    pub fn force(&self) -> f64 {
        match &self.whole {
            Some(whole) => whole.sums[0] * self.grid().cell_area(),
            None => self.pressure.integral(),
        }
    }

    /// Returns the moments that the pressure exerts on body 1 about the x and y axes through the origin of the grid
    /// (force times length). They are $`(\sum y\,p,\; -\sum x\,p)\,A`$, where A is the area of a cell.
    #[must_use]
    pub fn moments(&self) -> [f64; 2] {
        let [x, y] = self.first_moments();
        [y, 0.0 - x]
    }

    /// Returns the point where the normal force acts (lengths), or `None` without contact.
    #[doc(alias = "eccentricity")]
    #[must_use]
    pub fn centre_of_pressure(&self) -> Option<[f64; 2]> {
        let force = self.force();
        (force > 0.0).then(|| self.first_moments().map(|moment| moment / force))
    }

    /// Returns the sums of x p and of y p times the area of a cell.
    fn first_moments(&self) -> [f64; 2] {
        let (grid, pressure) = (self.grid(), self.pressure.as_slice());
        let sums = match &self.whole {
            Some(whole) => [whole.sums[1], whole.sums[2]],
            None => reduce::sum(&grid.layout(), |i| {
                let (x, y) = (grid.x(i % grid.nx()), grid.y(i / grid.nx()));
                [x * pressure[i], y * pressure[i]]
            }),
        };
        sums.map(|sum| sum * grid.cell_area())
    }

    /// Computes the normal displacement $`u_z`$ of all cells under the pressure, summed over bodies 1 and 2 (lengths,
    /// positive into the bodies). The call takes one product with the operator of the bodies.
    ///
    /// # Errors
    /// - [`Error::GridMismatch`], [`Error::BoundaryMismatch`], [`Error::CellValueMismatch`] or
    ///   [`Error::MaterialMismatch`] if the solution belongs to other bodies.
    /// - Errors of [`HalfSpace::operator`].
    pub fn displacement(&self, bodies: &HalfSpace) -> Result<Field> {
        bodies.collective_result(self.check_bodies(bodies))?;
        let operator = bodies.operator(Component::ZZ)?;
        let mut displacement = Field::try_zeros(self.grid())?;
        operator.apply(
            [self.pressure.as_slice()],
            [displacement.as_mut_slice()],
            &mut operator.scratch()?,
        );
        bodies.joint(Ok(displacement))
    }

    /// Computes the elastic energy of the normal contact, $`\tfrac A2 \sum p\,u_z`$ (force times length). The displacements
    /// apply to the centres of the cells.
    ///
    /// For the half of a coupled solution of dissimilar bodies, this energy excludes the displacement due to the tractions. The
    /// energies of both halves do not add up to [`CoupledSolution::elastic_energy`](crate::CoupledSolution::elastic_energy). The
    /// difference is $`A \sum p\,w`$, with the normal displacement w due to the tractions.
    ///
    /// # Errors
    /// Errors of [`NormalSolution::displacement`].
    pub fn elastic_energy(&self, bodies: &HalfSpace) -> Result<f64> {
        let displacement = self.displacement(bodies)?;
        let (p, u) = (self.pressure.as_slice(), displacement.as_slice());
        let [sum] = reduce::sum(&bodies.grid_layout(), |i| [p[i] * u[i]]);
        bodies.joint(Ok(0.5 * self.grid().cell_area() * sum))
    }

    /// Returns an error if the solution belongs to other bodies.
    pub(crate) fn check_bodies(&self, bodies: &HalfSpace) -> Result<()> {
        let quantity = "normal contact";
        bodies.check_host(quantity, self.grid(), self.boundary)?;
        bodies.check_values(quantity, self.cell_value)?;
        bodies.check_pair(quantity, &self.pair)
    }

    /// Returns the sums that identify the pressure, or `None` for a slab that was read without its sums.
    pub(crate) fn fingerprint(&self) -> Option<PressureFingerprint> {
        let (grid, pressure) = (self.grid(), self.pressure.as_slice());
        match &self.whole {
            Some(whole) => Some(whole.fingerprint),
            None => (grid == grid.whole())
                .then(|| PressureFingerprint::of(grid, &grid.layout(), |i| (i, pressure[i]))),
        }
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

    /// Returns the materials of the two bodies.
    #[must_use]
    pub fn pair(&self) -> &ElasticPair {
        &self.pair
    }

    /// Returns the number of cells whose pressure is at the [`Hardness`] of the problem. The
    /// gap of these cells is negative.
    #[must_use]
    pub fn yielded_cells(&self) -> usize {
        self.yielded_cells
    }

    /// Returns an error if any cell is at its hardness, because the quantity is defined for elastic contacts only.
    pub(crate) fn check_elastic(&self, quantity: &'static str) -> Result<()> {
        match self.yielded_cells {
            0 => Ok(()),
            cells => Err(Error::Yielded { quantity, cells }),
        }
    }

    /// Returns the report of the solve: its status, cost and error bound.
    #[must_use]
    pub fn report(&self) -> &Report {
        &self.report
    }
}

impl NormalSolution {
    /// Estimates the discretisation error of the pressure. The error of a cell is its difference from the mean of the
    /// exact pressure over the cell. The estimate is the sum of the absolute errors, relative to the sum of the
    /// pressure. Returns `None` without contact and on a slab of a distributed grid.
    ///
    /// ```math
    /// \frac{\sum |p - \bar p|}{\sum p} \approx f\,\frac{\sum |\Delta_h p|}{24 \sum p}, \qquad
    /// \Delta_h p = p_{i-1,j} + p_{i+1,j} + p_{i,j-1} + p_{i,j+1} - 4\,p_{i,j}
    /// ```
    ///
    /// with f = 1.4 for [uniform cells](crate::CellValue::Uniform), 1 for [values at the
    /// centres](crate::CellValue::Centre) and 1.25 on grids with [`Boundary::Periodic`]. Inside the contact the second
    /// difference measures the variation that the cells do not resolve. At the edge of the contact, the second
    /// difference and this variation are of the same size.
    ///
    /// The result is an estimate and not a bound. A solver's [certificate](crate::Report) bounds a different error, the
    /// error of the solution on the given cells. The estimate decreases with the power 3/2 of the cell size. The table
    /// gives the ratio of the estimate to the error relative to exact means:
    ///
    /// | contact | estimate over error |
    /// |---|---|
    /// | spheres, ellipses, gaps r^4, partial slip; any position, 16 to 48 cells over three contact radii | 0.8 to 1.35 |
    /// | these contacts on 96 to 192 cells | 0.9 to 1.15 |
    /// | these contacts centred on a cell, where errors cancel, on 16 to 48 cells | 0.7 to 1.7 |
    /// | ellipses of 5 to 1 whose short axis is 3 cells long, along the grid | 0.8 to 1.5 |
    /// | periodic rough surfaces, shortest wave of 5 to 24 cells | 0.9 to 1.25 |
    /// | rough surfaces on free grids, 50 to 700 cells in contact | 0.7 to 1.4 |
    /// | straight edges along the lines of the grid | 0.4 to 4, depending on their position |
    /// | flat punch, whose pressure is infinite at the edge | 0.3 to 0.4 |
    ///
    /// The error at the centres of the cells is 0.5 to 0.9 times the error of the means.
    ///
    /// There is no such estimate for approach, shift and energy. The errors of these quantities are 1e-3 to 1e-6 on 32
    /// to 128 cells over three contact radii. The sign of the errors depends on the position of the contact edge
    /// relative to the cells.
    ///
    /// The difference from a solve with half as many cells per side estimates only the error of the approach of uniform
    /// cells. A third of the difference is 0.4 to 2 times the error on 64 and 128 cells. This ratio was measured for
    /// spheres and for ellipses 2:1 at 16 positions each. The ratio lies anywhere between -100 and 60 for the approach of
    /// centre values, energies, the shift in partial slip and rough surfaces. Other assumed orders of convergence do
    /// not improve this ratio.
    ///
    /// ```
    /// use stickslip::*;
    /// let grid = Grid::square(64, 3.0)?;
    /// let pair = ElasticPair::new(Material::new(1.0, 0.0)?, Material::rigid())?;
    /// let (ball, load) = (surface::sphere(grid, 1.0)?, NormalLoad::Force(4.0 / 3.0));
    /// let bodies = HalfSpace::new(grid, pair)?;
    /// let contact = NormalProblem::builder(&bodies, &ball, load).build()?.solve()?;
    /// let estimate = contact.discretisation_estimate().unwrap_or(0.0);
    /// assert!((estimate - 0.0043).abs() < 0.0005); // the error is 0.0042
    /// # Ok::<(), Error>(())
    /// ```
    #[must_use]
    pub fn discretisation_estimate(&self) -> Option<f64> {
        estimate([&self.pressure], self.boundary, self.cell_value())
    }

    /// Returns a warning if the discretisation estimate is too large.
    pub(super) fn discretisation_warning(&self) -> Result<Option<Warning>> {
        let contact = || self.contact_map().mean_spot();
        Warning::of_discretisation(self.discretisation_estimate(), contact)
    }
}
