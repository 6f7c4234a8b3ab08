//! The integrals of a depth in Fourier space, shared by both bodies, and the components composed of them.

use std::f64::consts::TAU;

use crate::boundary::Boundary;
use crate::buffer;
use crate::error::{Result, memory};
use crate::fft::{Kernels, Torus};
use crate::grid::Grid;
use crate::half_space::HalfSpace;
use crate::parallel::{self, Blocks};
use crate::subsurface::distances::depth_in;
use crate::subsurface::kernel::{Component, Integral, Load, LoadedRectangle, Weights};
use crate::subsurface::strip::Strips;
use crate::watch::Watch;

/// The spectra of the integrals at one depth: they depend on the cells, not on the materials, so both bodies have
/// them in common.
#[derive(Debug)]
pub(super) struct Spectra {
    depth: f64,
    /// Where the integrals are taken.
    z: f64,
    /// Those of the displacements only where they are asked for; otherwise they are empty.
    values: [Vec<f64>; Integral::COUNT],
    /// The first wave along x here, and waves along y.
    first: usize,
    height: usize,
    repeats: bool,
}

/// What the integrals take while they are made, per sampled distance: all of them, the rows of one and the spectrum of
/// one.
const BYTES: usize = (Integral::COUNT + 2) * size_of::<f64>();

impl Spectra {
    pub(super) fn new(
        bodies: &HalfSpace,
        torus: &Torus,
        depth: f64,
        with_displacements: bool,
        watch: &mut Watch<'_>,
    ) -> Result<Self> {
        let ([width, height], waves_here) = (torus.quarter(), torus.own_waves());
        memory("kernels of a depth", [waves_here.len(), height], BYTES)?;
        let (grid, boundary) = (bodies.grid().whole(), bodies.boundary());
        let z = depth_in(grid, depth);
        watch.ask()?;
        let mut values = match boundary {
            Boundary::Periodic => waves(grid, torus, z)?,
            _ => samples(grid, boundary, torus, z)?,
        };
        let first = torus.own_distances().start;
        for (integral, values) in Integral::ALL.into_iter().zip(&mut values) {
            if integral.is_length() && !with_displacements {
                *values = Vec::new();
            } else if boundary != Boundary::Periodic {
                watch.ask()?;
                *values =
                    torus.spectrum(integral.is_odd(), |i, j| values[(j - first) * width + i])?;
            }
        }
        Ok(Self {
            depth,
            z,
            values,
            first: waves_here.start,
            height,
            repeats: boundary == Boundary::Periodic,
        })
    }

    pub(super) fn depth(&self) -> f64 {
        self.depth
    }

    /// The kernels of three components.
    pub(super) fn compose(&self, components: [Component; 3], poisson_ratio: f64) -> Composed<'_> {
        let weights = Weights::new(poisson_ratio, self.z);
        Composed {
            spectra: self,
            weights,
            components,
            poisson_ratio,
        }
    }
}

/// The integrals at the distances of a quarter of the torus that are sampled here, row by row.
fn samples(
    grid: Grid,
    boundary: Boundary,
    torus: &Torus,
    depth: f64,
) -> Result<[Vec<f64>; Integral::COUNT]> {
    let ([width, _], own) = (torus.quarter(), torus.own_distances());
    let (dx, dy) = (grid.dx(), grid.dy());
    let cell = LoadedRectangle::new(0.5 * dx, 0.5 * dy);
    let xs = buffer::collected(width, (0..width).map(|i| i as f64 * dx))?;
    let mut values = buffer::vector(width * own.len())?;
    let data = values.each_mut().map(|values| Blocks {
        items: values,
        width,
    });
    let strips = Strips::new(grid, boundary);
    let work = |row: usize, rows: [Blocks<'_, f64>; Integral::COUNT]| {
        let mut out = rows.map(|row| row.items);
        let y = (own.start + row) as f64 * dy;
        match &strips {
            None => cell.integrals_along_row(&xs, y, depth, &mut out),
            Some(strips) => strips.integrals_along_row(&cell, &xs, [y, depth], &mut out),
        }
    };
    if !own.is_empty() {
        parallel::sweep(0..own.len(), data, &work, &|(), ()| ());
    }
    Ok(values)
}

/// The symbols of the integrals, or their imaginary parts, for the waves of a quarter that are multiplied here.
fn waves(grid: Grid, torus: &Torus, depth: f64) -> Result<[Vec<f64>; Integral::COUNT]> {
    let ([_, height], own) = (torus.quarter(), torus.own_waves());
    let sides = [grid.nx() as f64 * grid.dx(), grid.ny() as f64 * grid.dy()];
    let size = [grid.nx(), grid.ny()];
    let mut values = buffer::vector(own.len() * height)?;
    let data = values.each_mut().map(|values| Blocks {
        items: values,
        width: height,
    });
    let work = |column: usize, lines: [Blocks<'_, f64>; Integral::COUNT]| {
        let mut lines = lines.map(|line| line.items);
        for row in 0..height {
            let periods = [own.start + column, row];
            if periods == [0, 0] {
                continue;
            }
            let [x, y] = [0, 1].map(|axis| TAU / sides[axis] * periods[axis] as f64);
            let symbols = symbols([x, y], depth);
            for ((line, symbol), integral) in lines.iter_mut().zip(symbols).zip(Integral::ALL) {
                // A wave of two cells per period has no direction, so what is odd vanishes there.
                let odd = integral.is_odd();
                let is_lost = (0..2).any(|axis| odd[axis] && 2 * periods[axis] == size[axis]);
                line[row] = if is_lost { 0.0 } else { symbol };
            }
        }
    };
    if !own.is_empty() {
        parallel::sweep(0..own.len(), data, &work, &|(), ()| ());
    }
    Ok(values)
}

/// The Fourier transforms of the functions under the integrals, or their imaginary parts, for the wave vector `[x, y]`,
/// not zero.
///
/// The harmonic potentials have `V = 2 pi exp(-kz)/k`, `L = -V/k` and `W = V/k^2`, as each is the derivative of the
/// next along z. `T` follows from the stresses of an incompressible body: `T_ijz = z V_ij - V_z` on the diagonal,
/// `T_xyz = z V_xy`, `T_xzz = z V_xz`, `T_xxy = z L_xxy - W_xxy - V_y`, and `T_iik = -3 V_k`.
fn symbols([x, y]: [f64; 2], z: f64) -> [f64; Integral::COUNT] {
    let k = x.hypot(y);
    let (x, y, kz) = (x / k, y / k, k * z);
    let decay = TAU * (-kz).exp();
    let of = |integral: Integral| match integral {
        Integral::V => 1.0 / k,
        Integral::Lx => -x / k,
        Integral::Ly => -y / k,
        Integral::Wxx => -x * x / k,
        Integral::Wxy => -x * y / k,
        Integral::Lxx => x * x,
        Integral::Lxy => x * y,
        Integral::Wxxy => -x * x * y,
        Integral::Wxyy => -x * y * y,
        Integral::Txxx => x * (x * x * (1.0 + kz) - 3.0),
        Integral::Txxy => y * (x * x * (1.0 + kz) - 1.0),
        Integral::Txyy => x * (y * y * (1.0 + kz) - 1.0),
        Integral::Tyyy => y * (y * y * (1.0 + kz) - 3.0),
        Integral::Txxz => 1.0 - kz * x * x,
        Integral::Txyz => -kz * x * y,
        Integral::Tyyz => 1.0 - kz * y * y,
        Integral::Txzz => -kz * x,
        Integral::Tyzz => -kz * y,
        Integral::Tzzz => 1.0 + kz,
    };
    Integral::ALL.map(|integral| decay * of(integral))
}

/// Three components under each traction, as sums of the integrals.
#[derive(Debug)]
pub(super) struct Composed<'a> {
    spectra: &'a Spectra,
    weights: Weights,
    components: [Component; 3],
    poisson_ratio: f64,
}

impl Composed<'_> {
    /// What a unit mean traction causes on a grid that repeats along both axes: the stresses of a body whose sides do
    /// not move, and no displacement.
    fn mean(&self, component: Component, load: Load) -> f64 {
        let nu = self.poisson_ratio;
        match (component, load) {
            (Component::Szz, Load::P) | (Component::Sxz, Load::Qx) | (Component::Syz, Load::Qy) => {
                -1.0
            }
            (Component::Sxx | Component::Syy, Load::P) => -nu / (1.0 - nu),
            _ => 0.0,
        }
    }
}

impl Kernels for Composed<'_> {
    fn is_odd(&self) -> [[[bool; 2]; 3]; 3] {
        self.components.map(|component| {
            Load::ALL.map(|load| {
                let (odd, turns) = (component.is_odd(), load.turns());
                [odd[0] != turns[0], odd[1] != turns[1]]
            })
        })
    }

    fn add(&self, out: &mut [f64], [i, j]: [usize; 2], factor: f64, kx: usize) {
        let (component, load) = (self.components[i], Load::ALL[j]);
        let (height, column) = (self.spectra.height, kx - self.spectra.first);
        for (weight, values) in self
            .weights
            .of(load, component)
            .iter()
            .zip(&self.spectra.values)
        {
            if *weight != 0.0 {
                let weight = factor * weight;
                for (out, value) in out.iter_mut().zip(&values[column * height..][..height]) {
                    *out += weight * value;
                }
            }
        }
        if kx == 0 && self.spectra.repeats {
            out[0] = factor * self.mean(component, load);
        }
    }
}
