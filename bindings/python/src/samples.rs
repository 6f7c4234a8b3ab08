//! Arguments that are converted to fields.

use std::sync::Arc;

use numpy::PyUntypedArray;
use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;

use crate::argument::argument;
use crate::array::grid_of_memory;
use crate::conversion::kind_of;
use crate::digits::short;
use crate::error::OrRaise;
use crate::field::{Field, same_grid};
use crate::grid::Grid;
use crate::real::{
    by_axis, check_coordinates, is_no_mask, is_no_truth_value, is_real, misshapen, plane,
    shape_error, wrong_type,
};
use crate::unit::{Unit, known, of_next_gap, one_of};

argument! {
    /// Argument that is converted to a field: a field, an array of shape (ny, nx), one number for all cells, or a
    /// topography object with heights and sizes.
    Samples: Field
}

impl Samples<'_> {
    /// Returns an error for a truth value.
    pub(crate) fn check_no_truth_value(&self, quantity: &str) -> PyResult<()> {
        is_no_truth_value(&self.0, quantity)
    }

    /// Returns the samples as a field on this grid. A field on a different grid is passed on unchanged; the crate then
    /// rejects it and names both grids.
    pub(crate) fn on(
        &self,
        py: Python<'_>,
        quantity: &str,
        grid: stickslip::Grid,
    ) -> PyResult<Arc<stickslip::Field>> {
        if let Some(field) = self.field() {
            return Ok(field);
        }
        if self.is_topography()? {
            return Err(PyTypeError::new_err(format!(
                "{quantity} is a topography, whose heights point out of its body: \
                 convert it to a gap by surface.gap_from_heights(topography)"
            )));
        }
        if self.has_heights() {
            // The heights themselves as a gap would press the valleys together instead of the peaks.
            let remedy = match quantity {
                "gap" => "convert them to a gap by surface.gap_from_heights(rough.heights)",
                _ => "give its .heights",
            };
            return Err(PyTypeError::new_err(format!(
                "{quantity} is a {}, which has heights: {remedy}",
                kind_of(&self.0)
            )));
        }
        is_real(&self.0, quantity)?;
        if let Some(value) = self.number() {
            return Ok(Arc::new(stickslip::Field::constant(grid, value)));
        }
        let samples = plane(&self.0, quantity, grid)?;
        let samples = samples.as_array();
        if samples.dim() != (grid.ny(), grid.nx()) {
            let (rows, columns) = samples.dim();
            return Err(misshapen(py, quantity, grid, &[rows, columns]));
        }
        check_coordinates(&self.0, quantity, Some([grid.dx(), grid.dy()]))?;
        let samples = match samples.as_slice() {
            Some(samples) => samples.to_vec(),
            None => samples.iter().copied().collect(),
        };
        // The crate rejects a grid of the array that differs from the grid of the call.
        let grid = self.grid_of_array().unwrap_or(grid);
        let field = stickslip::Field::from_vec(grid, samples).or_raise(py)?;
        Ok(Arc::new(field))
    }

    /// Returns the samples as a field on this grid, as [`on`](Self::on), but rejects a field on a different grid.
    pub(crate) fn only_on(
        &self,
        py: Python<'_>,
        quantity: &'static str,
        grid: stickslip::Grid,
    ) -> PyResult<Arc<stickslip::Field>> {
        let field = self.on(py, quantity, grid)?;
        same_grid(grid, field.grid(), quantity).or_raise(py)?;
        Ok(field)
    }

    /// Returns the samples as a field on this grid, as [`on`](Self::on), but rejects a single number. For a gap or a pressure, a
    /// number is more likely the next argument, such as a coefficient of friction, than a uniform field.
    pub(crate) fn per_cell(
        &self,
        py: Python<'_>,
        quantity: &str,
        grid: stickslip::Grid,
    ) -> PyResult<Arc<stickslip::Field>> {
        self.per_cell_or(py, quantity, grid, "")
    }

    /// Returns the samples as a gap with its unit, as [`per_cell`](Self::per_cell).
    pub(crate) fn gap(&self, py: Python<'_>, grid: stickslip::Grid) -> PyResult<Field> {
        Ok(Field(self.per_cell(py, "gap", grid)?, self.unit()?))
    }

    /// Returns the samples as a gap, as [`gap`](Self::gap), of a constructor whose next argument is friction.
    pub(crate) fn gap_before_friction(
        &self,
        py: Python<'_>,
        grid: stickslip::Grid,
    ) -> PyResult<Field> {
        let gap = self.per_cell_or(py, "gap", grid, ", and friction after the gap")?;
        Ok(Field(gap, self.unit()?))
    }

    /// Returns the samples as a gap that replaces a gap of this unit, or an error if the units differ.
    pub(crate) fn next_gap(
        &self,
        py: Python<'_>,
        grid: stickslip::Grid,
        last: Option<&Unit>,
    ) -> PyResult<Field> {
        let Field(gap, unit) = self.gap(py, grid)?;
        Ok(Field(gap, of_next_gap(last, unit)?))
    }

    /// Returns the samples as [`per_cell`](Self::per_cell), with an addition to the remedy for a single number.
    fn per_cell_or(
        &self,
        py: Python<'_>,
        quantity: &str,
        grid: stickslip::Grid,
        order: &str,
    ) -> PyResult<Arc<stickslip::Field>> {
        if let Some(number) = self.number() {
            let message = format!(
                "must be a Field or an array of shape (ny, nx), got the number {}: for a uniform {quantity} give Field(grid, {0}){order}",
                short(number)
            );
            return Err(wrong_type(py, quantity, &message));
        }
        is_no_mask(&self.0, quantity)?;
        self.check_no_energies(quantity)?;
        self.on(py, quantity, grid)
    }

    /// Returns an error for an array of the energies of cells where lengths or pressures are expected.
    pub(crate) fn check_no_energies(&self, quantity: &str) -> PyResult<()> {
        match self.own_grid() {
            None => Ok(()),
            Some(_) => Err(PyTypeError::new_err(format!(
                "{quantity} contains energies of cells: convert them to a depth by wear.energy(coefficient, cycle.dissipation), \
                 or divide them by grid.cell_area"
            ))),
        }
    }

    /// Returns an error for an array of energies per area where energies of cells are expected.
    pub(crate) fn check_not_per_area(&self, quantity: &str) -> PyResult<()> {
        let arrays = self.0.py().import("stickslip._arrays")?;
        if self.0.is_instance(&arrays.getattr("EnergiesPerArea")?)? {
            return Err(PyTypeError::new_err(format!(
                "{quantity} contains energies per area, and the law divides by the area of a cell: multiply them by grid.cell_area"
            )));
        }
        Ok(())
    }

    /// Returns the samples as a field on this grid, as [`on`](Self::on), but rejects a single number and an array of one number
    /// on a larger grid. Such a number is more likely the total or the largest value of a quantity that differs between cells.
    pub(crate) fn of_each_cell(
        &self,
        py: Python<'_>,
        quantity: &str,
        grid: stickslip::Grid,
        remedy: &str,
    ) -> PyResult<Arc<stickslip::Field>> {
        // Arrays of NumPy with one entry have this method.
        let entry = || self.0.call_method0("item").ok()?.extract().ok();
        let number: Option<f64> = self.number().or_else(entry);
        match number.filter(|_| grid.cells() > 1) {
            Some(number) => {
                let message = format!(
                    "{quantity} is the number {}, expected an array of shape (ny, nx) = {:?}: {remedy}",
                    short(number),
                    (grid.ny(), grid.nx())
                );
                let shape: Option<Vec<usize>> = self
                    .0
                    .getattr("shape")
                    .and_then(|shape| shape.extract())
                    .ok();
                Err(shape_error(
                    py,
                    quantity,
                    grid,
                    &shape.unwrap_or_default(),
                    &message,
                ))
            }
            None => self.on(py, quantity, grid),
        }
    }

    /// Returns the single number, if the argument is one. An array with one entry gives no value for other cells.
    pub(crate) fn number(&self) -> Option<f64> {
        let dimensions = self.0.getattr("ndim").and_then(|count| count.extract());
        let is_array = dimensions.is_ok_and(|count: usize| count > 0);
        if is_array {
            None
        } else {
            self.0.extract().ok()
        }
    }

    /// Returns the shape of an array.
    pub(crate) fn shape(&self) -> Option<(usize, usize)> {
        by_axis(&self.0).ok()?.getattr("shape").ok()?.extract().ok()
    }

    /// Returns one number or a field on this grid; without a grid, on the field's own grid. A field on a different grid is
    /// rejected.
    pub(crate) fn spread(
        &self,
        py: Python<'_>,
        quantity: &'static str,
        grid: Option<&Grid>,
    ) -> PyResult<Spread> {
        is_real(&self.0, quantity)?;
        is_no_mask(&self.0, quantity)?;
        match self.number() {
            Some(value) => Ok(Spread::Uniform(value)),
            None => self
                .only_on(py, quantity, grid_of(grid, &[self])?)
                .map(Spread::PerCell),
        }
    }

    /// Returns the samples as a field on their own grid.
    pub(crate) fn alone(&self, quantity: &str) -> PyResult<Arc<stickslip::Field>> {
        self.alone_or(quantity, ": create a Field by Field(grid, array)")
    }

    /// Returns the samples as [`alone`](Self::alone), with the remedy for an array.
    pub(crate) fn alone_or(&self, quantity: &str, remedy: &str) -> PyResult<Arc<stickslip::Field>> {
        self.known()?.ok_or_else(|| {
            let instead = if self.has_heights() {
                format!(", got {}: give its .heights", kind_of(&self.0))
            } else if self.0.hasattr("dims").unwrap_or(false) {
                ": convert an array of xarray by io.from_xarray(array)".into()
            } else {
                remedy.into()
            };
            PyTypeError::new_err(format!(
                "{quantity} must be a Field or a topography, which contain their grid{instead}"
            ))
        })
    }

    /// Returns the unit of the lengths of a field, a topography or an array of xarray, if it states one. The unit of another
    /// quantity, such as a pressure, is ignored.
    pub(crate) fn unit(&self) -> PyResult<Option<Unit>> {
        if let Ok(field) = self.0.cast::<Field>() {
            return Ok(field.get().1.clone());
        }
        if self.0.hasattr("dims")? && self.0.hasattr("attrs")? {
            let unit = self.0.getattr("attrs")?.call_method1("get", ("units",))?;
            return Ok(unit
                .extract()
                .ok()
                .and_then(|unit: String| known(&unit).ok()));
        }
        if !self.is_topography()? || !self.0.hasattr("unit")? {
            return Ok(None);
        }
        let unit = self.0.getattr("unit")?;
        if unit.is_none() {
            return Ok(None);
        }
        known(unit.str()?.to_str()?).map(Some)
    }

    /// Returns the grid of an array that contains it, as the array of the energies of cells.
    fn own_grid(&self) -> Option<stickslip::Grid> {
        let array = self.0.cast::<PyUntypedArray>().ok()?;
        let grid = array.getattr("grid").ok()?;
        grid.cast::<Grid>().ok().map(|grid| grid.get().0)
    }

    /// Returns the grid of an array of energies, or of an array that belongs to a solution, a state, a history or a solver.
    pub(crate) fn grid_of_array(&self) -> Option<stickslip::Grid> {
        let of_memory = || grid_of_memory(self.0.cast::<PyUntypedArray>().ok()?);
        self.own_grid().or_else(of_memory)
    }

    fn field(&self) -> Option<Arc<stickslip::Field>> {
        let field = self.0.cast::<Field>().ok()?;
        Some(Arc::clone(&field.get().0))
    }

    /// Returns whether the object is a rough, filled or levelled surface of the package, which has heights.
    fn has_heights(&self) -> bool {
        let heights = self.0.getattr("heights");
        heights.is_ok_and(|heights| heights.is_instance_of::<Field>())
    }

    fn is_topography(&self) -> PyResult<bool> {
        Ok(self.0.hasattr("heights")? && self.0.hasattr("physical_sizes")?)
    }

    fn known(&self) -> PyResult<Option<Arc<stickslip::Field>>> {
        if let Some(field) = self.field() {
            return Ok(Some(field));
        }
        if self.is_topography()? {
            let module = self.0.py().import("stickslip.surface")?;
            let field = module.call_method1("from_topography", (&self.0,))?;
            return Ok(Some(Arc::clone(&field.cast::<Field>()?.get().0)));
        }
        match self.own_grid() {
            Some(grid) => self.on(self.0.py(), "samples", grid).map(Some),
            None => Ok(None),
        }
    }
}

/// Returns the common unit of surfaces, or an error if two units differ. Surfaces without a unit are ignored.
pub(crate) fn one_unit(fields: &[&Samples<'_>]) -> PyResult<Option<Unit>> {
    let units: PyResult<Vec<_>> = fields.iter().map(|field| field.unit()).collect();
    one_of(units?)
}

/// One number for all cells, or one number per cell.
pub(crate) enum Spread {
    Uniform(f64),
    PerCell(Arc<stickslip::Field>),
}

/// Returns the given grid, or the grid of the first field that has one.
pub(crate) fn grid_of(grid: Option<&Grid>, fields: &[&Samples<'_>]) -> PyResult<stickslip::Grid> {
    if let Some(grid) = grid {
        return Ok(grid.0);
    }
    for field in fields {
        if let Some(field) = field.known()? {
            return Ok(field.grid());
        }
    }
    Err(PyTypeError::new_err(
        "an array does not contain the sides of its cells: give grid= (such as history.grid or solution.grid), or a Field",
    ))
}
