//! Grids, materials, friction and settings: plain structs that the caller fills in.

use std::time::Duration;

use stickslip_rs::cgm::{Method, Settings};
use stickslip_rs::layers::Layer;
use stickslip_rs::normal::Hardness;
use stickslip_rs::tangential::RelativeDisplacement;
use stickslip_rs::{Boundary, CellValue, Field, Friction, Grid, Material};

use crate::call::Outcome;
use crate::error::Failure;
use crate::pointer::{cells, field};
use crate::reserved::known;
use crate::scratch::Spare;

/// Grid of nx by ny rectangular cells of sides dx and dy (lengths), centred on the origin. An array of samples has nx * ny
/// entries, row by row with x fastest; the sample of cell (ix, iy) is at iy * nx + ix.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct stickslip_grid {
    /// Number of cells along x.
    pub nx: usize,
    /// Number of cells along y.
    pub ny: usize,
    /// Side of a cell along x (a length).
    pub dx: f64,
    /// Side of a cell along y (a length).
    pub dy: f64,
}

impl stickslip_grid {
    pub(crate) fn checked(&self) -> Outcome<Grid> {
        Ok(Grid::new(self.nx, self.ny, self.dx, self.dy)?)
    }
}

impl From<Grid> for stickslip_grid {
    fn from(grid: Grid) -> Self {
        Self {
            nx: grid.nx(),
            ny: grid.ny(),
            dx: grid.dx(),
            dy: grid.dy(),
        }
    }
}

/// Material of a body.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct stickslip_material {
    /// Young's modulus (a pressure); infinite for a rigid body.
    pub youngs_modulus: f64,
    /// Poisson's ratio, in (-1, 1/2]; without meaning for a rigid body.
    pub poisson_ratio: f64,
    /// Indentation hardness (a pressure), used only for warnings; 0 or infinite if unknown.
    pub hardness: f64,
}

impl stickslip_material {
    pub(crate) fn checked(&self) -> Outcome<Material> {
        let material = if self.youngs_modulus == f64::INFINITY {
            Material::rigid()
        } else {
            Material::new(self.youngs_modulus, self.poisson_ratio)?
        };
        Ok(match self.hardness {
            0.0 | f64::INFINITY => material,
            hardness => material.with_hardness(hardness)?,
        })
    }
}

/// Elastic layer bonded to the layer or body below it.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct stickslip_layer {
    /// Young's modulus (a pressure).
    pub youngs_modulus: f64,
    /// Poisson's ratio, in (-1, 1/2].
    pub poisson_ratio: f64,
    /// Thickness (a length).
    pub thickness: f64,
}

impl stickslip_layer {
    pub(crate) fn checked(&self) -> Outcome<Layer> {
        let Self {
            youngs_modulus,
            poisson_ratio,
            thickness,
        } = *self;
        Ok(Layer::new(youngs_modulus, poisson_ratio, thickness)?)
    }
}

/// Boundary of a grid that is a patch on infinite bodies.
pub const STICKSLIP_NON_PERIODIC: i32 = 0;
/// Boundary of a grid that is periodic along x and y.
pub const STICKSLIP_PERIODIC: i32 = 1;
/// Boundary of a grid that is periodic along y only.
pub const STICKSLIP_PERIODIC_ALONG_Y: i32 = 2;

/// Boundary condition at the edge of the grid.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct stickslip_boundary {
    /// Kind of boundary: STICKSLIP_NON_PERIODIC, STICKSLIP_PERIODIC or STICKSLIP_PERIODIC_ALONG_Y.
    pub kind: i32,
    /// Distance along x at which a line load causes no displacement (a length); zero for all kinds except
    /// STICKSLIP_PERIODIC_ALONG_Y.
    pub datum: f64,
}

impl stickslip_boundary {
    pub(crate) fn checked(&self) -> Outcome<Boundary> {
        if matches!(self.kind, STICKSLIP_NON_PERIODIC | STICKSLIP_PERIODIC) {
            Failure::if_given(
                "the datum of the boundary",
                self.datum,
                "its kind is not STICKSLIP_PERIODIC_ALONG_Y: set kind to STICKSLIP_PERIODIC_ALONG_Y, or datum to zero",
            )?;
        }
        match self.kind {
            STICKSLIP_NON_PERIODIC => Ok(Boundary::NonPeriodic),
            STICKSLIP_PERIODIC => Ok(Boundary::Periodic),
            STICKSLIP_PERIODIC_ALONG_Y => Ok(Boundary::PeriodicAlongY { datum: self.datum }),
            other => Err(Failure::option(
                "kind of boundary",
                other,
                "STICKSLIP_NON_PERIODIC, STICKSLIP_PERIODIC or STICKSLIP_PERIODIC_ALONG_Y",
            )),
        }
    }
}

/// Cell value: the traction is uniform over the cell.
pub const STICKSLIP_UNIFORM: i32 = 0;
/// Cell value: the traction at the centre of the cell; the traction is smooth between the centres.
pub const STICKSLIP_CENTRE: i32 = 1;

/// Converts a constant to the meaning of a cell value.
pub(crate) fn cell_value(chosen: i32) -> Outcome<CellValue> {
    match chosen {
        STICKSLIP_UNIFORM => Ok(CellValue::Uniform),
        STICKSLIP_CENTRE => Ok(CellValue::Centre),
        other => Err(Failure::option(
            "cell value",
            other,
            "STICKSLIP_UNIFORM or STICKSLIP_CENTRE",
        )),
    }
}

/// Quantity with one value for all cells or a value for each cell.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct stickslip_per_cell {
    /// Value of all cells; used if cells is NULL.
    pub value: f64,
    /// Value of each cell, copied by the call, or NULL.
    pub cells: *const f64,
    /// Number of cells; zero if cells is NULL.
    pub count: usize,
}

impl stickslip_per_cell {
    /// Returns the values of the cells; `None` if one value applies to all cells.
    ///
    /// # Safety
    /// The caller must follow the rule for pointers in [`crate::pointer`].
    pub(crate) unsafe fn cells(&self, name: &str, grid: Grid) -> Outcome<Option<&[f64]>> {
        if self.cells.is_null() {
            // A count without an array can be the result of a failed allocation.
            return match self.count {
                0 => Ok(None),
                count => Err(Failure::missing_cells(name, count)),
            };
        }
        // SAFETY: the caller follows the safety contract of this function.
        unsafe { cells(name, grid, self.cells, self.count) }.map(Some)
    }

    /// Returns the values of the cells, copied into memory of `spare`; `None` if one value applies to all cells.
    ///
    /// # Safety
    /// The caller must follow the rule for pointers in [`crate::pointer`].
    unsafe fn field(&self, name: &str, grid: Grid, spare: &Spare) -> Outcome<Option<Field>> {
        // SAFETY: the caller follows the safety contract of this function.
        let samples = unsafe { self.cells(name, grid)? };
        samples.map(|samples| spare.copy(grid, samples)).transpose()
    }

    /// Converts the quantity to a hardness, the largest pressure that the cells can carry.
    ///
    /// # Safety
    /// The caller must follow the rule for pointers in [`crate::pointer`].
    pub(crate) unsafe fn hardness(&self, grid: Grid) -> Outcome<Hardness> {
        // SAFETY: the caller follows the safety contract of this function.
        Ok(
            match unsafe { self.field("hardness", grid, &Spare::default())? } {
                None => Hardness::uniform(self.value)?,
                Some(limits) => Hardness::per_cell(limits)?,
            },
        )
    }
}

/// Coulomb friction.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct stickslip_friction {
    /// Coefficient of friction, zero or positive.
    pub coefficient: stickslip_per_cell,
    /// Largest shear traction (a pressure); 0 or infinite if only the coefficient limits the traction.
    pub max_shear_stress: f64,
    /// Reserved for future members: zero.
    pub reserved: [u64; 8],
}

impl stickslip_friction {
    /// Returns the friction after checking it.
    ///
    /// # Safety
    /// The caller must follow the rule for pointers in [`crate::pointer`].
    pub(crate) unsafe fn checked(&self, grid: Grid) -> Outcome<Friction> {
        // SAFETY: the caller follows the safety contract of this function.
        unsafe { self.checked_in(grid, &Spare::default()) }
    }

    /// Runs work with the friction, which is stored in reusable memory.
    ///
    /// # Safety
    /// The caller must follow the rule for pointers in [`crate::pointer`].
    pub(crate) unsafe fn lend<T>(
        &self,
        grid: Grid,
        spare: &Spare,
        work: impl FnOnce(&Friction) -> stickslip_rs::Result<T>,
    ) -> Outcome<T> {
        // SAFETY: the caller follows the safety contract of this function.
        let friction = unsafe { self.checked_in(grid, spare)? };
        let outcome = work(&friction);
        if let Some(coefficients) = friction.into_coefficients() {
            spare.keep(coefficients);
        }
        Ok(outcome?)
    }

    /// Returns the friction after checking it, in memory of `spare`.
    ///
    /// # Safety
    /// The caller must follow the rule for pointers in [`crate::pointer`].
    unsafe fn checked_in(&self, grid: Grid, spare: &Spare) -> Outcome<Friction> {
        known("the friction", &self.reserved)?;
        let name = "coefficient of friction";
        // SAFETY: the caller follows the safety contract of this function.
        let friction = match unsafe { self.coefficient.field(name, grid, spare)? } {
            None => Friction::coulomb(self.coefficient.value)?,
            Some(coefficients) => Friction::per_cell(coefficients)?,
        };
        Ok(match self.max_shear_stress {
            0.0 | f64::INFINITY => friction,
            cap => friction.max_shear_stress(cap)?,
        })
    }
}

/// Tangential displacement of body 1 relative to body 2 that the contact does not cause, for example bulk strain. The
/// call copies the values of the cells.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct stickslip_relative_displacement {
    /// Displacement along x of each cell (lengths).
    pub x: *const f64,
    /// Displacement along y of each cell (lengths).
    pub y: *const f64,
    /// Number of cells.
    pub count: usize,
}

impl stickslip_relative_displacement {
    /// Returns the relative displacement after checking it.
    ///
    /// # Safety
    /// The caller must follow the rule for pointers in [`crate::pointer`].
    pub(crate) unsafe fn checked(&self, grid: Grid) -> Outcome<RelativeDisplacement> {
        // SAFETY: the caller follows the safety contract of this function.
        let fields = unsafe {
            [
                field("relative displacement along x", grid, self.x, self.count)?,
                field("relative displacement along y", grid, self.y, self.count)?,
            ]
        };
        Ok(RelativeDisplacement::new(fields)?)
    }
}

/// Active-set method (default).
pub const STICKSLIP_ACTIVE_SET: i32 = 0;
/// Polonsky-Keer iteration, for the pressure or for one traction.
pub const STICKSLIP_POLONSKY_KEER: i32 = 1;

/// Method, tolerance and limits of a solve; stickslip_settings_default() returns the defaults.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct stickslip_settings {
    /// Method: STICKSLIP_ACTIVE_SET (default) or STICKSLIP_POLONSKY_KEER.
    pub method: i32,
    /// Largest accepted error, in (0, 1) (default 1e-8). It limits the certified error in the energy norm, and the residual
    /// relative to the largest displacement.
    pub tolerance: f64,
    /// Largest number of conjugate-gradient iterations (default 10000).
    pub max_iterations: usize,
    /// Largest wall time of a solve (seconds); infinite (default) for no limit. A step of a history has two solves, one for
    /// the pressure and one for the traction.
    pub time_limit: f64,
    /// Reserved for future members: zero.
    pub reserved: [u64; 8],
}

impl stickslip_settings {
    pub(crate) fn checked(&self) -> Outcome<Settings> {
        known("the settings", &self.reserved)?;
        let method = match self.method {
            STICKSLIP_ACTIVE_SET => Method::ActiveSet,
            STICKSLIP_POLONSKY_KEER => Method::PolonskyKeer,
            other => {
                return Err(Failure::option(
                    "method",
                    other,
                    "STICKSLIP_ACTIVE_SET or STICKSLIP_POLONSKY_KEER",
                ));
            }
        };
        let settings = Settings::default()
            .method(method)
            .tolerance(self.tolerance)
            .max_iterations(self.max_iterations);
        settings.check()?;
        if self.time_limit == f64::INFINITY {
            return Ok(settings);
        }
        let limit = Duration::try_from_secs_f64(self.time_limit)
            .map_err(|_| Failure::time_limit(self.time_limit))?;
        Ok(settings.time_limit(limit))
    }
}

/// Returns the default settings of solvers and histories.
#[unsafe(no_mangle)]
pub extern "C" fn stickslip_settings_default() -> stickslip_settings {
    let settings = Settings::default();
    stickslip_settings {
        method: STICKSLIP_ACTIVE_SET,
        tolerance: settings.tolerance,
        max_iterations: settings.max_iterations,
        time_limit: f64::INFINITY,
        reserved: [0; 8],
    }
}

/// Returns a friction with one coefficient for all cells.
#[unsafe(no_mangle)]
pub extern "C" fn stickslip_coulomb(coefficient: f64) -> stickslip_friction {
    stickslip_friction {
        coefficient: stickslip_per_cell {
            value: coefficient,
            cells: std::ptr::null(),
            count: 0,
        },
        max_shear_stress: f64::INFINITY,
        reserved: [0; 8],
    }
}
