//! The answer to a normal contact.

use crate::bodies::component::Component;
use crate::bodies::material::ElasticPair;
use crate::cgm::reduce;
use crate::error::{Error, Result};
#[cfg(feature = "serde")]
use crate::error::{all_non_negative, finite};
use crate::grid::Grid;
use crate::grid::boundary::Boundary;
use crate::grid::cell_value::CellValue;
use crate::grid::discretisation::estimate;
use crate::grid::field::{Field, clone_in_place};
use crate::half_space::HalfSpace;
use crate::memory::fallible::{TryClone, try_clone};
use crate::normal::over_ranks::PressureSums;
use crate::normal::scale::Scale;
use crate::operator::Operator;
use crate::parallel;
use crate::report::Report;
use crate::support::debug::shown;
#[cfg(feature = "serde")]
use crate::support::serialise::checked;
use crate::warning::Warning;

/// Pressure, gap and approach of a normal contact. Two are equal if their answers are, however they were found.
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct NormalSolution {
    pub(super) pressure: Field,
    gap: Field,
    pub(super) boundary: Boundary,
    cell_value: CellValue,
    pub(super) pair: ElasticPair,
    approach: f64,
    yielded_cells: usize,
    /// Whether tractions that were found together with the pressure have changed it.
    is_coupled: bool,
    /// Its approach, radius and slopes, for warnings.
    scale: Scale,
    report: Report,
    /// Of a slab, what all ranks together have found.
    #[cfg_attr(feature = "serde", serde(skip))]
    pub(super) whole: Option<Box<PressureSums>>,
}

shown!(NormalSolution: grid(), approach(), force(), contact_cells(), discretisation_estimate(), report);

clone_in_place!(NormalSolution {
    pressure,
    gap,
    boundary,
    cell_value,
    pair,
    approach,
    yielded_cells,
    is_coupled,
    scale,
    report,
    whole,
});

try_clone!(NormalSolution { pressure, gap } { boundary, cell_value, pair, approach, yielded_cells, is_coupled, scale, report, whole });

impl PartialEq for NormalSolution {
    fn eq(&self, other: &Self) -> bool {
        let Self {
            pressure,
            gap,
            boundary,
            cell_value,
            pair,
            approach,
            yielded_cells,
            is_coupled,
            scale: _,
            report: _,
            whole,
        } = self;
        *pressure == other.pressure
            && *gap == other.gap
            && *boundary == other.boundary
            && *cell_value == other.cell_value
            && *pair == other.pair
            && *approach == other.approach
            && *yielded_cells == other.yielded_cells
            && *is_coupled == other.is_coupled
            && *whole == other.whole
    }
}

/// What is read, before it is checked.
#[cfg(feature = "serde")]
#[derive(serde::Deserialize)]
#[serde(remote = "NormalSolution")]
struct RawNormalSolution {
    pressure: Field,
    gap: Field,
    boundary: Boundary,
    cell_value: CellValue,
    pair: ElasticPair,
    approach: f64,
    yielded_cells: usize,
    is_coupled: bool,
    #[serde(default)]
    scale: Scale,
    report: Report,
    #[serde(skip)]
    whole: Option<Box<PressureSums>>,
}

#[cfg(feature = "serde")]
impl<'de> serde::Deserialize<'de> for NormalSolution {
    fn deserialize<D: serde::Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        checked(RawNormalSolution::deserialize(deserializer)?, |read| {
            all_non_negative("pressure", read.pressure.as_slice())?;
            read.gap.check("gap", read.grid())?;
            finite("approach", read.approach).map(|_| ())
        })
    }
}

/// The gap of a cell whose surfaces are displaced and approached.
fn under_load(initial: f64, displacement: f64, approach: f64) -> f64 {
    displacement + (initial - approach)
}

impl NormalSolution {
    /// No contact yet.
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
            report: Report::with_room(),
            whole: None,
        })
    }

    /// Of pressures and displacements of all cells, over the gap before loading.
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
            report,
        })
    }

    /// With what all ranks have found, which is not among the fields of a slab.
    pub(crate) fn gather_whole(&mut self, bodies: &HalfSpace) {
        self.whole = PressureSums::of(bodies, self.pressure.as_slice());
    }

    /// Measures approach, radius and slopes over the gap before loading.
    pub(crate) fn measure_scale(&mut self, bodies: &HalfSpace, initial: &Field) {
        let pressure = self.pressure.as_slice();
        self.scale = Scale::of(bodies, initial.as_slice(), pressure, self.approach);
    }

    pub(crate) fn scale(&self) -> Scale {
        self.scale
    }

    /// As the half of a solution in which tractions have changed the pressure.
    pub(crate) fn set_coupled(&mut self, is_coupled: bool) {
        self.is_coupled = is_coupled;
    }

    /// `Ok` if the pressure is that of the gap and the approach alone.
    pub(crate) fn check_uncoupled(&self) -> Result<()> {
        let beta = self.pair.coupling_strength();
        if self.is_coupled {
            return Err(Error::CoupledMaterials { beta });
        }
        Ok(())
    }

    /// With so many cells at their hardness.
    pub(crate) fn set_yielded_cells(&mut self, cells: usize) {
        self.yielded_cells = cells;
    }

    pub(crate) fn pressure_mut(&mut self) -> &mut [f64] {
        self.pressure.as_mut_slice()
    }

    /// With the displacements of all cells by the pressure that it has, over the gap before loading.
    pub(crate) fn fill(
        &mut self,
        bodies: &HalfSpace,
        initial: &Field,
        displacement: &[f64],
        approach: f64,
        report: &Report,
    ) {
        (self.pair, self.cell_value) = (*bodies.pair(), bodies.cell_value());
        // Of another history, whose solution this has been.
        (self.yielded_cells, self.is_coupled) = (0, false);
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

    /// Pressure, gap under load, approach and report, to be read from what was saved.
    pub(crate) fn parts_mut(&mut self) -> (&mut Field, &mut Field, &mut f64, &mut Report) {
        (
            &mut self.pressure,
            &mut self.gap,
            &mut self.approach,
            &mut self.report,
        )
    }

    /// Pressure, and gap under load, from which what has yielded is to be taken.
    pub(crate) fn yielding_mut(&mut self) -> (&[f64], &mut [f64]) {
        (self.pressure.as_slice(), self.gap.as_mut_slice())
    }

    /// The grid of all its fields.
    #[must_use]
    pub fn grid(&self) -> Grid {
        self.pressure.grid()
    }

    /// Pressure p >= 0, positive pushing into the bodies; exactly zero outside the contact. A cell has that of all of it or
    /// of its centre: its [`cell_value`](Self::cell_value).
    #[must_use]
    pub fn pressure(&self) -> &Field {
        &self.pressure
    }

    /// Gap under load `h + u_z - delta` (lengths): zero in the contact up to the residual,
    /// positive outside, and negative where cells yield under a [`Hardness`](crate::normal::Hardness).
    #[must_use]
    pub fn gap(&self) -> &Field {
        &self.gap
    }

    /// Approach delta of the bodies from the datum of the initial gap (a length): prescribed, or the
    /// multiplier of the force. On a periodic grid it is the mean of the initial gap less that of the gap
    /// under load.
    #[doc(alias = "indentation")]
    #[doc(alias = "penetration")]
    #[must_use]
    pub fn approach(&self) -> f64 {
        self.approach
    }

    /// Normal force W, the integral of the pressure: the sum of the cells times their area, whatever their
    /// [`CellValue`]. The `force` of a tangential solution, a step or a history is the
    /// tangential one; a step has this as [`normal_force`](crate::history::StepResult::normal_force).
    #[must_use]
    pub fn force(&self) -> f64 {
        match &self.whole {
            Some(whole) => whole.sums[0] * self.grid().cell_area(),
            None => self.pressure.integral(),
        }
    }

    /// Moments about x and about y, at the origin of the grid, that the pressure exerts on body 1 (force times length):
    /// $`(\sum y\,p,\; -\sum x\,p)\,A`$, A the area of a cell.
    #[must_use]
    pub fn moments(&self) -> [f64; 2] {
        let [x, y] = self.first_moments();
        [y, 0.0 - x]
    }

    /// Where the normal force acts (lengths); `None` without contact.
    #[doc(alias = "eccentricity")]
    #[must_use]
    pub fn centre_of_pressure(&self) -> Option<[f64; 2]> {
        let force = self.force();
        (force > 0.0).then(|| self.first_moments().map(|moment| moment / force))
    }

    /// Sums of x p and of y p, times the area of a cell.
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

    /// Normal displacement $`u_z`$ by the pressure, of all cells, that of body 1 plus that of body 2 (lengths, positive
    /// where the surfaces give way): one product with the operator of the bodies.
    ///
    /// # Errors
    /// [`Error::GridMismatch`], [`Error::BoundaryMismatch`], [`Error::CellValueMismatch`] or
    /// [`Error::MaterialMismatch`] for bodies that the solution is not of; as [`HalfSpace::operator`].
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

    /// Elastic energy of the normal contact, $`\tfrac A2 \sum p\,u_z`$ (force times length), with the displacements at the
    /// centres of the cells.
    ///
    /// # Errors
    /// As [`NormalSolution::displacement`].
    pub fn elastic_energy(&self, bodies: &HalfSpace) -> Result<f64> {
        let displacement = self.displacement(bodies)?;
        let (p, u) = (self.pressure.as_slice(), displacement.as_slice());
        let [sum] = reduce::sum(&bodies.grid_layout(), |i| [p[i] * u[i]]);
        bodies.joint(Ok(0.5 * self.grid().cell_area() * sum))
    }

    /// `Ok` if the solution is one of these bodies.
    pub(crate) fn check_bodies(&self, bodies: &HalfSpace) -> Result<()> {
        let quantity = "normal contact";
        bodies.check_host(quantity, self.grid(), self.boundary)?;
        bodies.check_values(quantity, self.cell_value)?;
        if self.pair == *bodies.pair() {
            Ok(())
        } else {
            Err(Error::MaterialMismatch { quantity })
        }
    }

    /// What lies beyond the edge of the grid.
    #[must_use]
    pub fn boundary(&self) -> Boundary {
        self.boundary
    }

    /// The meaning of the value of a cell.
    #[must_use]
    pub fn cell_value(&self) -> CellValue {
        self.cell_value
    }

    /// The two bodies.
    #[must_use]
    pub fn pair(&self) -> &ElasticPair {
        &self.pair
    }

    /// Cells whose pressure is at the [`Hardness`](crate::normal::Hardness) of the problem: there the gap is negative.
    #[must_use]
    pub fn yielded_cells(&self) -> usize {
        self.yielded_cells
    }

    /// `Ok` if no cell is at its hardness, for what holds of elastic contacts alone.
    pub(crate) fn check_elastic(&self, quantity: &'static str) -> Result<()> {
        match self.yielded_cells {
            0 => Ok(()),
            cells => Err(Error::Yielded { quantity, cells }),
        }
    }

    /// How the solve ended, what it cost, how large its error can be.
    #[must_use]
    pub fn report(&self) -> &Report {
        &self.report
    }
}

impl NormalSolution {
    /// An estimate of the discretisation error of the pressure: the sum of its differences from the means of the exact pressure
    /// over the cells, relative to the sum of the pressure. `None` without contact, and on a slab of a grid that ranks share.
    ///
    /// ```math
    /// \frac{\sum |p - \bar p|}{\sum p} \approx f\,\frac{\sum |\Delta_h p|}{24 \sum p}, \qquad
    /// \Delta_h p = p_{i-1,j} + p_{i+1,j} + p_{i,j-1} + p_{i,j+1} - 4\,p_{i,j}
    /// ```
    ///
    /// with f = 1.4 for [uniform cells](crate::CellValue::Uniform), 1 for [values at the centres](crate::CellValue::Centre) and
    /// 1.25 on grids with [`Boundary::Periodic`]: inside the second difference is what the cells
    /// miss, and at the edge of the contact it is as large as it. It is an estimate, no bound; a solver's
    /// [certificate](crate::Report) is a bound of another error, that of the solution on the given cells. It falls with the
    /// power 3/2 of the cells. Compared with exact means:
    ///
    /// | contact | estimate over error |
    /// |---|---|
    /// | spheres, ellipses, gaps r^4, partial slip; anywhere between 16 to 48 cells over three contact radii | 0.8 to 1.35 |
    /// | the same on 96 to 192 cells | 0.9 to 1.15 |
    /// | the same in the middle of a cell, where errors cancel, on 16 to 48 cells | 0.7 to 1.7 |
    /// | ellipses of 5 to 1 whose short axis is 3 cells long, along the grid | 0.8 to 1.5 |
    /// | rough surfaces, shortest wave of 5 to 24 cells, that repeat | 0.9 to 1.25 |
    /// | the same on free grids, 50 to 700 cells in contact | 0.7 to 1.4 |
    /// | straight edges along the lines of the grid | 0.4 to 4, by where they fall |
    /// | flat punch, whose pressure is infinite at the edge | 0.3 to 0.4 |
    ///
    /// The error at the centres of the cells is half to nine tenths of that of the means.
    ///
    /// Approach, shift and energy have no such estimate. Their errors are 1e-3 to 1e-6 on 32 to 128 cells over three contact
    /// radii, and of either sign, by where the edge falls between the cells. The difference from a solve on half the cells
    /// tells that of the approach of uniform cells only: a third of it is 0.4 to 1.2 times the error on 64 and 128 cells
    /// (a sphere and an ellipse 2:1 at 8 places each). Of the approach of centre values, of energies, of the shift in
    /// partial slip and of rough surfaces the quotient lies anywhere between -100 and 60, also for other orders.
    ///
    /// ```
    /// use stickslip::*;
    /// let grid = Grid::square(64, 3.0)?;
    /// let pair = ElasticPair::new(Material::new(1.0, 0.0)?, Material::rigid())?;
    /// let (ball, load) = (surface::sphere(grid, 1.0)?, NormalControl::Force(4.0 / 3.0));
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

    /// What the estimate has to be remarked on.
    pub(super) fn discretisation_warning(&self) -> Option<Warning> {
        let contact = || self.contact_map().mean_spot();
        Warning::of_discretisation(self.discretisation_estimate(), contact)
    }
}
