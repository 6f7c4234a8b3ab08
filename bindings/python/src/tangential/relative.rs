//! Relative displacements that are not caused by the contact.

use std::sync::Arc;

use pyo3::prelude::*;
use stickslip::tangential::RelativeDisplacement as Relative;

use crate::argument::{Object, by_value};
use crate::array::{Array, view};
use crate::conversion;
use crate::error::OrRaise;
use crate::field::same_grid;
use crate::grid::{Grid, size};
use crate::pickle::{Reduced, Stored, reduced};
use crate::samples::{Samples, grid_of};
use crate::unit::{Unit, agree, one_of};

/// A displacement of body 1 relative to body 2 that is not caused by the contact, such as bulk strain or thermal
/// expansion. Fields with a unit raise an error where the gap has another unit.
///
/// Parameters
/// ----------
/// along_x, along_y : Field or array_like of shape (ny, nx)
///     Displacements of body 1 relative to body 2 along x and y (lengths, of either sign). A single number is rejected; for a
///     strain use :meth:`bulk_strain`.
/// grid : Grid, optional
///     Grid of the arrays; required for arrays, because only Fields have their own grid.
///
/// Raises
/// ------
/// GridMismatch, Sample, ArgumentType
/// ValueError
///     If the fields have different units.
#[pyclass(frozen, eq, module = "stickslip.tangential")]
#[derive(Clone)]
pub(crate) struct RelativeDisplacement(pub(crate) Relative, pub(crate) Option<Unit>);

impl PartialEq for RelativeDisplacement {
    fn eq(&self, other: &Self) -> bool {
        self.0 == other.0 && agree(self.1.as_ref(), other.1.as_ref())
    }
}

by_value!(RelativeDisplacement);

#[pymethods]
impl RelativeDisplacement {
    #[new]
    #[pyo3(signature = (along_x, along_y, *, grid=None))]
    fn new(
        py: Python<'_>,
        along_x: Samples<'_>,
        along_y: Samples<'_>,
        grid: Option<Object<Grid>>,
    ) -> PyResult<Self> {
        let unit = one_of([along_x.unit()?, along_y.unit()?])?;
        let grid = grid_of(grid.as_deref(), &[&along_x, &along_y])?;
        let fields = [
            along_x.per_cell(py, "along_x", grid)?,
            along_y.per_cell(py, "along_y", grid)?,
        ];
        for (field, name) in fields.iter().zip(["along_x", "along_y"]) {
            same_grid(grid, field.grid(), name).or_raise(py)?;
        }
        let relative = Relative::new(fields.map(Arc::unwrap_or_clone));
        Ok(Self(relative.or_raise_on(py, grid)?, unit))
    }

    /// Returns the displacement due to a uniform strain ``[[xx, xy], [yx, yy]]``, the strain of body 1 minus the strain
    /// of body 2 (dimensionless, positive in tension). It is zero at the origin of the grid.
    /// The components xy and yx must be equal, each half of the engineering shear strain; a rotation is a twist.
    /// The rows and columns of a table of pandas or an array of xarray are recognised by the labels x and y.
    #[staticmethod]
    fn bulk_strain(
        py: Python<'_>,
        grid: Object<Grid>,
        strain: conversion::Strain,
    ) -> PyResult<Self> {
        Relative::bulk_strain(grid.0, strain.0)
            .or_raise(py)
            .map(|relative| Self(relative, None))
    }

    /// Unit of the fields; ``None`` if it is not known.
    #[getter]
    fn unit(&self) -> Option<&str> {
        self.1.as_deref()
    }

    /// Components along x and y (lengths).
    #[getter]
    fn fields<'py>(slf: &Bound<'py, Self>) -> (Array<'py>, Array<'py>) {
        (
            view(slf, |relative| relative.0.fields()[0]),
            view(slf, |relative| relative.0.fields()[1]),
        )
    }

    fn __reduce__<'py>(&self, py: Python<'py>) -> PyResult<Reduced<'py>> {
        reduced::<Self>(py, &(self.0.clone(), self.1.as_deref().map(String::from)))
    }

    fn __repr__(&self) -> String {
        format!("RelativeDisplacement({})", size(self.0.fields()[0].grid()))
    }
}

impl Stored for RelativeDisplacement {
    type Content = (Relative, Option<String>);

    const KIND: &'static str = "RelativeDisplacement";

    fn of_content((relative, unit): Self::Content) -> Self {
        Self(relative, unit.map(Unit::from))
    }
}
