//! Solution of a step in the cells of a window.

use crate::bodies::coupling::Coupling;
use crate::cgm::reduce;
use crate::contact::pressure_fingerprint::PressureFingerprint;
use crate::grid::Grid;
use crate::half_space::{HalfSpace, Region};
use crate::numerics::cell_vector::{dot, length, minus, slices};
use crate::tangential::friction_limits::is_at_limit;
use crate::tangential::traction_solver::at;
use crate::tangential::{Axis, Friction, Offsets, PressureOnWindow, RigidMotion, Zone};
use crate::warning::Warning;

/// Largest pressure of a cell at an edge at which the pressure falls to zero, over the mean pressure. At the centre of a flat punch
/// the pressure is half of the mean pressure, without any slip.
const LOW_PRESSURE: f64 = 0.5;
/// Least use of the limit of such a cell, over the mean use. On a sphere, a cell with half of the mean pressure has a use of
/// three.
const STEEPER_USE: f64 = 2.0;
/// Mean use of the limits below which the tractions may be round-off.
const LEAST_USE: f64 = 1e-6;

/// Relative difference of the pressures of neighbouring cells above which the pressure varies. It exceeds usual tolerances.
const LEAST_VARIATION: f64 = 1e-2;

/// Pressure, limits, tractions and displacements at the end of a step, on the window of a contact. A component that the
/// model omits is an empty slice.
#[derive(Debug, Clone, Copy)]
pub(crate) struct StepSolution<'a> {
    pub(crate) region: &'a Region,
    pub(crate) axes: &'static [Axis],
    pub(crate) pressure: &'a [f64],
    pub(crate) limits: &'a [f64],
    pub(crate) traction: [&'a [f64]; 2],
    pub(crate) displacement: [&'a [f64]; 2],
    /// Displacement minus motion of each cell while it sticks.
    pub(crate) offset: [&'a [f64]; 2],
    /// Mean entry compliance of the cells. Empty if no cell came into contact.
    pub(crate) entered: &'a [f64],
    /// Whether a cell of any rank may have come into contact.
    pub(crate) has_entered: bool,
    /// Motion of body 2 at the end of the step.
    pub(crate) motion: RigidMotion,
}

impl<'a> StepSolution<'a> {
    /// Creates the solution from traction and displacement of the cells under this pressure, with these offsets.
    pub(crate) fn new(
        pressed: &'a PressureOnWindow,
        offsets: &'a Offsets,
        [traction, displacement]: [[&'a [f64]; 2]; 2],
        motion: RigidMotion,
    ) -> Self {
        Self {
            region: &pressed.region,
            axes: offsets.axes(),
            pressure: &pressed.pressure,
            limits: &pressed.limits.cells,
            traction,
            displacement,
            offset: offsets.slices(),
            entered: &offsets.entry.mean,
            has_entered: offsets.entry.is_active,
            motion,
        }
    }

    /// Returns the number of local cells for which [`Self::entered`] needs memory.
    pub(crate) fn entered_cells(&self) -> usize {
        if self.has_entered {
            self.region.held().cells()
        } else {
            0
        }
    }

    /// Calls `work` with the solution in the local cells of the grid.
    pub(crate) fn with_held<T>(&self, work: impl FnOnce(&StepSolution<'_>) -> T) -> T {
        let region = self.region;
        let give = |parts: [&[f64]; 2]| {
            let mut held = [Vec::new(), Vec::new()];
            for axis in self.axes.iter().map(|axis| axis.index()) {
                held[axis] = region.given(parts[axis]).into_owned();
            }
            held
        };
        if !region.is_moved() {
            return work(self);
        }
        let cells = [self.pressure, self.limits];
        let [pressure, limits] = cells.map(|part| region.given(part));
        let entered = if self.has_entered {
            region.given(self.entered)
        } else {
            self.entered.into()
        };
        let [traction, displacement, offset] =
            [self.traction, self.displacement, self.offset].map(give);
        work(&StepSolution {
            pressure: &pressure,
            limits: &limits,
            traction: slices(&traction),
            displacement: slices(&displacement),
            offset: slices(&offset),
            entered: &entered,
            ..*self
        })
    }

    /// Returns the sums that identify the pressure. The solution must be in the local cells of this grid.
    pub(crate) fn pressure_fingerprint(&self, grid: Grid) -> PressureFingerprint {
        let held = self.region.held();
        PressureFingerprint::of(grid, &self.region.held_layout(), |k| {
            (held.index(k), self.pressure[k])
        })
    }

    /// Returns the friction capacities without and with the cap of this friction, or `None` without a cap.
    pub(crate) fn capacities(&self, friction: &Friction) -> Option<[f64; 2]> {
        friction
            .within(self.region)
            .capacities(self.region.layout(), self.pressure)
    }

    /// Returns Dundurs' beta over the mean coefficient of friction in per cent, if one-way coupling acts along one axis only and
    /// the tractions across this axis are not small. The function is collective.
    pub(crate) fn neglected_traction(
        &self,
        bodies: &HalfSpace,
        coupling: Coupling,
    ) -> Option<usize> {
        let &[axis] = self.axes else {
            return None;
        };
        if !coupling.is_one_way(bodies.pair()) {
            return None;
        }
        let (limits, pressure) = (self.limits, self.pressure);
        let [capacity, force] =
            reduce::sum(self.region.layout(), |cell| [limits[cell], pressure[cell]]);
        if capacity <= 0.0 {
            return None;
        }
        let ratio = bodies.pair().coupling_strength().abs() * force / capacity;
        let across = 1 - axis.index();
        Warning::coupling_beyond(ratio).filter(|_| self.varies_along(across, bodies))
    }

    /// Returns whether the pressure varies along an axis. A pressure on one line of cells does not vary. The function is
    /// collective.
    fn varies_along(&self, axis: usize, bodies: &HalfSpace) -> bool {
        let is_line = self.region.window().size[axis] == 1;
        if is_line || !bodies.boundary().repeats()[axis] {
            return !is_line;
        }
        let columns = self.region.own().size[0];
        reduce::any(self.region.layout(), |cell| {
            let (place, step) = [(cell % columns, 1), (cell / columns, columns)][axis];
            let pressure = self.pressure[cell];
            place > 0 && (pressure - self.pressure[cell - step]).abs() > LEAST_VARIATION * pressure
        })
    }

    /// Returns whether no cell slips although the step has a slip zone inside its outermost cells. `change` returns the change of
    /// the traction of a cell in the step. The pressure falls to zero at such an edge, whereas the tractions of full stick grow.
    /// The solution must be in the local cells of the grid. The function is collective.
    pub(crate) fn hides_slip(&self, change: impl Fn(usize) -> [f64; 2] + Sync) -> bool {
        let layout = self.region.held_layout();
        if reduce::any(&layout, |cell| self.zone(cell) == Zone::Slip) {
            return false;
        }
        let size = |cell: usize| length(change(cell));
        let (traction, (capacity, pressure), cells) = reduce::sum(&layout, |cell| {
            let (limit, pressure) = (self.limits[cell], self.pressure[cell]);
            (size(cell), (limit, pressure), usize::from(pressure > 0.0))
        });
        let mean_use = traction / capacity;
        let low_pressure = LOW_PRESSURE * pressure / cells as f64;
        mean_use > LEAST_USE
            && reduce::any(&layout, |cell| {
                let limit = self.limits[cell];
                let is_low = limit > 0.0 && self.pressure[cell] < low_pressure;
                is_low && size(cell) > STEEPER_USE * mean_use * limit
            })
    }

    /// Returns the traction of a cell.
    #[inline]
    pub(crate) fn traction(&self, cell: usize) -> [f64; 2] {
        at(&self.traction, cell)
    }

    /// Returns the displacement of a cell.
    #[inline]
    pub(crate) fn displacement(&self, cell: usize) -> [f64; 2] {
        at(&self.displacement, cell)
    }

    /// Returns the offset of a cell.
    #[inline]
    pub(crate) fn offset(&self, cell: usize) -> [f64; 2] {
        at(&self.offset, cell)
    }

    /// Returns the displacement of a cell with this centre relative to the other body.
    #[inline]
    pub(crate) fn relative(&self, cell: usize, centre: [f64; 2]) -> [f64; 2] {
        minus(self.displacement(cell), self.motion.at(centre))
    }

    /// Returns the slip in the step of a cell with this displacement relative to the other body, or `None` if it does
    /// not slip. A cell slips if it is at its friction limit and has moved opposite to its traction. A motion along the
    /// traction is a residual of the solve.
    #[inline]
    pub(crate) fn slip(&self, cell: usize, relative: [f64; 2]) -> Option<[f64; 2]> {
        let moved = minus(relative, self.offset(cell));
        let slips = self.is_at_limit(cell) && dot(self.traction(cell), moved) <= 0.0;
        slips.then_some(moved)
    }

    /// Returns the zone of a cell.
    #[inline]
    pub(crate) fn zone(&self, cell: usize) -> Zone {
        match (self.pressure[cell] > 0.0, self.is_at_limit(cell)) {
            (false, _) => Zone::Separated,
            (true, false) => Zone::Stick,
            (true, true) => Zone::Slip,
        }
    }

    /// Returns whether a cell is at its friction limit.
    #[inline]
    pub(crate) fn is_at_limit(&self, cell: usize) -> bool {
        is_at_limit(length(self.traction(cell)), self.limits[cell])
    }
}
