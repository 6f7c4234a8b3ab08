//! Computes the table of Kalker's coefficients of the library. The creepages of the solves of steady rolling are so
//! small that only the edge slips. `kalker_table [HALVES]` prints the rows of ellipse ratios a/b = 2^(k/2) with |k| up
//! to HALVES (default 8).
//!
//! On a single grid the forces have an error of about 0.3 %, because the cells of the contact cover slightly more or
//! less than the ellipse. This error appears as a lack of reciprocity, C32 + C23, although C23 itself is hardly
//! affected. Each coefficient is therefore extrapolated from several grids to reciprocity and to a cell size of zero.
//! The fit is linear in the lack of reciprocity and in the cell size.

#![allow(clippy::print_stdout, reason = "an example shows its numbers")]

use std::error::Error;

use stickslip::analytical::HertzEllipse;
use stickslip::rolling::{RollingControl, RollingProblem, SpinControl};
use stickslip::{
    ElasticPair, Field, Friction, Grid, HalfSpace, Material, NormalLoad, NormalProblem, Result,
};

/// Numbers of cells across each axis of the ellipse on the coarsest and the finest grid, and the number of grids.
const CELLS: [f64; 2] = [32.0, 128.0];
const GRIDS: u32 = 24;
/// Creepage for a friction coefficient of 1, at which hardly any cell slips.
const TINY: f64 = 1e-9;

fn main() -> std::result::Result<(), Box<dyn Error>> {
    let halves = std::env::args().nth(1).map_or(Ok(8), |k| k.parse())?;
    println!("a/b, nu: C11, C22, C23, C33; root mean square of what the fits leave");
    for k in -halves..=halves {
        let ratio = 2.0_f64.powf(0.5 * f64::from(k));
        for poisson in [0.0, 0.125, 0.25, 0.375, 0.5] {
            let (found, left) = extrapolated(ratio, poisson)?;
            println!("{ratio:.4}, {poisson:.3}: {found:.5?}; {left:.0e}");
        }
    }
    Ok(())
}

/// Returns C11, C22, C23 and C33, and the largest relative root-mean-square residual of the fits.
fn extrapolated(ratio: f64, poisson: f64) -> Result<([f64; 4], f64)> {
    let mut rows = Vec::new();
    for grid in 0..GRIDS {
        let part = f64::from(grid) / f64::from(GRIDS - 1);
        let cells = CELLS[0] * (CELLS[1] / CELLS[0]).powf(part);
        let [c11, c22, c23, c32, c33] = coefficients(ratio, poisson, cells)?;
        // A finer grid has a larger weight.
        rows.push((
            [1.0, (c32 + c23) / c23, 1.0 / cells].map(|term| cells * term),
            [c11, c22, c23, c33].map(|value| cells * value),
        ));
    }
    let mut found = [0.0; 4];
    let mut left = 0.0_f64;
    for (which, found) in found.iter_mut().enumerate() {
        let rows = || rows.iter().map(|(terms, values)| (*terms, values[which]));
        let fit = least_squares(rows());
        *found = fit[0];
        let miss = |(terms, value): ([f64; 3], f64)| {
            (0..3).map(|i| fit[i] * terms[i]).sum::<f64>() - value
        };
        let squares: f64 = rows().map(|row| miss(row).powi(2)).sum();
        left = left.max((squares / f64::from(GRIDS)).sqrt() / CELLS[1] / fit[0]);
    }
    Ok((found, left))
}

/// Returns C11, C22, C23, C32 and C33 for the given number of cells across each axis of the ellipse.
fn coefficients(ratio: f64, poisson: f64, cells: f64) -> Result<[f64; 5]> {
    let body = Material::from_shear_modulus(1.0, poisson)?;
    let pair = ElasticPair::new(body, body)?;
    let hertz = ellipse(&pair, ratio)?;
    let ([a, b], [rx, ry]) = (hertz.semi_axes(), hertz.radii());
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "a small number"
    )]
    let across = cells.ceil() as usize + 5;
    let grid = Grid::new(across, across, 2.0 * a / cells, 2.0 * b / cells)?;
    let bodies = HalfSpace::new(grid, pair)?;
    let gap = Field::from_fn(grid, |x, y| 0.5 * (x * x / rx + y * y / ry));
    let normal = NormalProblem::builder(&bodies, &gap, NormalLoad::Force(hertz.load()))
        .build()?
        .solve()?;
    let mut solver = RollingProblem::builder(&bodies, &normal, Friction::coulomb(1.0)?)
        .build()?
        .into_solver()?;
    let mut rolling = solver.new_solution();
    let mut of = |creepage: [f64; 2], spin: f64| -> Result<([f64; 2], f64)> {
        solver.set_load(
            creepage.map(RollingControl::Creepage),
            SpinControl::Spin(spin),
        )?;
        solver.solve_into(&mut rolling)?;
        Ok((rolling.force(), rolling.moment()))
    };
    let ([along, _], _) = of([TINY, 0.0], 0.0)?;
    let ([_, across], turning) = of([0.0, TINY], 0.0)?;
    let ([_, pushing], moment) = of([0.0, 0.0], TINY)?;
    let c = (a * b).sqrt();
    let unit = TINY * c * c;
    Ok([
        along / unit,
        across / unit,
        pushing / unit / c,
        turning / unit / c,
        moment / unit / c / c,
    ])
}

/// Returns the contact whose ellipse has this ratio of the semi-axes, by bisection for the ratio of the radii.
fn ellipse(pair: &ElasticPair, ratio: f64) -> Result<HertzEllipse> {
    let of = |exponent: f64| HertzEllipse::new(pair, exponent.exp(), 1.0, 1.0);
    let (mut low, mut high) = (-20.0, 20.0);
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        let [a, b] = of(middle)?.semi_axes();
        if a < ratio * b {
            low = middle;
        } else {
            high = middle;
        }
    }
    of(low)
}

/// Returns the factors of three terms that best fit the values, by their normal equations.
fn least_squares(rows: impl Iterator<Item = ([f64; 3], f64)>) -> [f64; 3] {
    let mut equations = [[0.0; 4]; 3];
    for (terms, value) in rows {
        for (equation, factor) in equations.iter_mut().zip(terms) {
            for (sum, term) in equation.iter_mut().zip(terms.into_iter().chain([value])) {
                *sum += factor * term;
            }
        }
    }
    for pivot in 0..3 {
        let row = equations[pivot].map(|entry| entry / equations[pivot][pivot]);
        for (other, equation) in equations.iter_mut().enumerate() {
            let factor = equation[pivot];
            if other == pivot {
                *equation = row;
            } else {
                for (entry, row) in equation.iter_mut().zip(row) {
                    *entry -= factor * row;
                }
            }
        }
    }
    equations.map(|equation| equation[3])
}
