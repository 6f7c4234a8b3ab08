//! The integrals at a depth in Fourier space, which both bodies share, and the components of displacement and stress.

use std::f64::consts::TAU;

use crate::bodies::material::Material;
use crate::error::{Result, memory};
use crate::fft::{Kernels, Torus};
use crate::grid::Grid;
use crate::grid::boundary::Boundary;
use crate::half_space::HalfSpace;
use crate::memory::fallible;
use crate::observer::WorkObserver;
use crate::parallel::{self, Blocks};
use crate::subsurface::distances::depth_in;
use crate::subsurface::kernel::{
    FieldComponent, Load, LoadedRectangle, PotentialIntegral, Weights,
};
use crate::subsurface::layered::{Layered, StressEntry};
use crate::subsurface::strip::Strips;

/// Spectra of the kernels at one depth.
#[derive(Debug)]
pub(super) struct Spectra {
    depth: f64,
    /// Depth at which the integrals are evaluated.
    z: f64,
    values: SpectrumValues,
    /// First local wave along x, and number of waves along y.
    first: usize,
    height: usize,
    repeats: bool,
}

/// Values of the kernels. The arrays for displacements are empty if displacements are not requested.
#[derive(Debug)]
enum SpectrumValues {
    /// Integrals. They depend on the cells but not on the materials, so homogeneous bodies share them.
    Integrals([Vec<f64>; PotentialIntegral::COUNT]),
    /// Components in a coated body under each traction, and Poisson's ratio at the depth.
    Layered([Vec<f64>; StressEntry::COUNT], f64),
}

/// Memory of the integrals during their computation, in bytes per sampled distance. It contains all integrals, and the
/// rows and the spectrum of one integral.
const BYTES: usize = (PotentialIntegral::COUNT + 2) * size_of::<f64>();
/// Memory of the components of a coated body during their computation, in bytes per sampled distance.
const LAYERED_BYTES: usize = (StressEntry::COUNT + 2) * size_of::<f64>();

impl Spectra {
    pub(super) fn new(
        bodies: &HalfSpace,
        torus: &Torus,
        depth: f64,
        with_displacements: bool,
        watch: &mut WorkObserver<'_>,
    ) -> Result<Self> {
        let ([_, height], waves_here) = (torus.quarter(), torus.own_waves());
        let room = memory("the kernels of a depth", [waves_here.len(), height], BYTES);
        bodies.collective_result(room)?;
        let (grid, boundary) = (bodies.grid().whole(), bodies.boundary());
        let z = depth_in(grid, depth);
        watch.notify_observer()?;
        let mut values = bodies.collective_result(match boundary {
            Boundary::Periodic => waves(
                grid,
                torus,
                |k| symbols(k, z),
                |n| PotentialIntegral::ALL[n].is_odd(),
            ),
            _ => samples(grid, boundary, torus, z),
        })?;
        let keeps = |n: usize| with_displacements || !PotentialIntegral::ALL[n].is_length();
        transform(
            &mut values,
            boundary,
            torus,
            keeps,
            |n| PotentialIntegral::ALL[n].is_odd(),
            watch,
        )?;
        Ok(Self::of(
            depth,
            z,
            SpectrumValues::Integrals(values),
            torus,
            boundary,
        ))
    }

    /// Computes the spectra of a coated body.
    pub(super) fn layered(
        bodies: &HalfSpace,
        body: &Material,
        torus: &Torus,
        depth: f64,
        with_displacements: bool,
        watch: &mut WorkObserver<'_>,
    ) -> Result<Self> {
        let ([_, height], waves_here) = (torus.quarter(), torus.own_waves());
        let size = [waves_here.len(), height];
        bodies.collective_result(memory("the kernels of a depth", size, LAYERED_BYTES))?;
        let (grid, boundary) = (bodies.grid().whole(), bodies.boundary());
        watch.notify_observer()?;
        let layered = Layered::new(body, depth_in(grid, depth));
        let is_odd = |n: usize| StressEntry::of(n).is_odd();
        let mut values = bodies.collective_result(match boundary {
            Boundary::Periodic => waves(grid, torus, |k| layered.symbols(k), is_odd),
            _ => layered.samples(grid, boundary, torus),
        })?;
        let keeps =
            |n: usize| with_displacements || !StressEntry::of(n).component.is_displacement();
        transform(&mut values, boundary, torus, keeps, is_odd, watch)?;
        let values = SpectrumValues::Layered(values, layered.poisson_ratio());
        Ok(Self::of(depth, 0.0, values, torus, boundary))
    }

    fn of(depth: f64, z: f64, values: SpectrumValues, torus: &Torus, boundary: Boundary) -> Self {
        let [_, height] = torus.quarter();
        Self {
            depth,
            z,
            values,
            first: torus.own_waves().start,
            height,
            repeats: boundary == Boundary::Periodic,
        }
    }

    pub(super) fn depth(&self) -> f64 {
        self.depth
    }

    /// Returns the kernels of three components.
    pub(super) fn compose(
        &self,
        components: [FieldComponent; 3],
        poisson_ratio: f64,
    ) -> ComposedSpectra<'_> {
        let weights = Weights::new(poisson_ratio, self.z);
        ComposedSpectra {
            spectra: self,
            weights,
            components,
            poisson_ratio,
        }
    }
}

/// Transforms the samples of all kernels that are kept. On a periodic grid the values are already transforms.
fn transform<const N: usize>(
    values: &mut [Vec<f64>; N],
    boundary: Boundary,
    torus: &Torus,
    keeps: impl Fn(usize) -> bool,
    is_odd: impl Fn(usize) -> [bool; 2],
    watch: &mut WorkObserver<'_>,
) -> Result<()> {
    let ([width, _], first) = (torus.quarter(), torus.own_distances().start);
    for (n, values) in values.iter_mut().enumerate() {
        if !keeps(n) {
            *values = Vec::new();
        } else if boundary != Boundary::Periodic {
            watch.notify_observer()?;
            *values = torus.spectrum(is_odd(n), |i, j| values[(j - first) * width + i])?;
        }
    }
    Ok(())
}

/// Returns the integrals at the local distances of a quarter of the torus, row by row.
fn samples(
    grid: Grid,
    boundary: Boundary,
    torus: &Torus,
    depth: f64,
) -> Result<[Vec<f64>; PotentialIntegral::COUNT]> {
    let ([width, _], own) = (torus.quarter(), torus.own_distances());
    let (dx, dy) = (grid.dx(), grid.dy());
    let cell = LoadedRectangle::new(0.5 * dx, 0.5 * dy);
    let xs = fallible::collected(width, (0..width).map(|i| i as f64 * dx))?;
    let mut values = fallible::vector(width * own.len())?;
    let data = values.each_mut().map(|values| Blocks {
        items: values,
        width,
    });
    let strips = Strips::new(grid, boundary);
    let work = |row: usize, rows: [Blocks<'_, f64>; PotentialIntegral::COUNT]| {
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

/// Returns symbols of kernels, or their imaginary parts, for the local waves of a quarter.
fn waves<const N: usize>(
    grid: Grid,
    torus: &Torus,
    symbols: impl Fn([f64; 2]) -> [f64; N] + Sync,
    is_odd: impl Fn(usize) -> [bool; 2] + Sync,
) -> Result<[Vec<f64>; N]> {
    let ([_, height], own) = (torus.quarter(), torus.own_waves());
    let sides = [grid.nx() as f64 * grid.dx(), grid.ny() as f64 * grid.dy()];
    let size = [grid.nx(), grid.ny()];
    let mut values = fallible::vector(own.len() * height)?;
    let data = values.each_mut().map(|values| Blocks {
        items: values,
        width: height,
    });
    let work = |column: usize, lines: [Blocks<'_, f64>; N]| {
        let mut lines = lines.map(|line| line.items);
        for row in 0..height {
            let periods = [own.start + column, row];
            if periods == [0, 0] {
                continue;
            }
            let [x, y] = [0, 1].map(|axis| TAU / sides[axis] * periods[axis] as f64);
            for (n, (line, symbol)) in lines.iter_mut().zip(symbols([x, y])).enumerate() {
                // The direction of a wave of two cells per period is undetermined, so its odd symbols vanish.
                let odd = is_odd(n);
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

/// Returns the Fourier transforms of the functions under the integrals, or their imaginary parts, for a nonzero wave
/// vector `[x, y]`.
///
/// The harmonic potentials are `V = 2 pi exp(-kz)/k`, `L = -V/k` and `W = V/k^2`, because each potential is the z
/// derivative of the next potential. `T` follows from the stresses of an incompressible body: `T_ijz = z V_ij - V_z` on
/// the diagonal, `T_xyz = z V_xy`, `T_xzz = z V_xz`, `T_xxy = z L_xxy - W_xxy - V_y`, and `T_iik = -3 V_k`.
fn symbols([x, y]: [f64; 2], z: f64) -> [f64; PotentialIntegral::COUNT] {
    let k = x.hypot(y);
    let (x, y, kz) = (x / k, y / k, k * z);
    let decay = TAU * (-kz).exp();
    let of = |integral: PotentialIntegral| match integral {
        PotentialIntegral::V => 1.0 / k,
        PotentialIntegral::Lx => -x / k,
        PotentialIntegral::Ly => -y / k,
        PotentialIntegral::Wxx => -x * x / k,
        PotentialIntegral::Wxy => -x * y / k,
        PotentialIntegral::Lxx => x * x,
        PotentialIntegral::Lxy => x * y,
        PotentialIntegral::Wxxy => -x * x * y,
        PotentialIntegral::Wxyy => -x * y * y,
        PotentialIntegral::Txxx => x * (x * x * (1.0 + kz) - 3.0),
        PotentialIntegral::Txxy => y * (x * x * (1.0 + kz) - 1.0),
        PotentialIntegral::Txyy => x * (y * y * (1.0 + kz) - 1.0),
        PotentialIntegral::Tyyy => y * (y * y * (1.0 + kz) - 3.0),
        PotentialIntegral::Txxz => 1.0 - kz * x * x,
        PotentialIntegral::Txyz => -kz * x * y,
        PotentialIntegral::Tyyz => 1.0 - kz * y * y,
        PotentialIntegral::Txzz => -kz * x,
        PotentialIntegral::Tyzz => -kz * y,
        PotentialIntegral::Tzzz => 1.0 + kz,
    };
    PotentialIntegral::ALL.map(|integral| decay * of(integral))
}

/// Kernels of three components under each traction. For a homogeneous body the kernels are sums of the integrals.
#[derive(Debug)]
pub(super) struct ComposedSpectra<'a> {
    spectra: &'a Spectra,
    weights: Weights,
    components: [FieldComponent; 3],
    poisson_ratio: f64,
}

impl ComposedSpectra<'_> {
    /// Returns the response to a unit mean traction on a grid that is periodic along both axes. The response consists
    /// of the stresses of a body without lateral strain. The displacement is zero.
    fn mean(&self, component: FieldComponent, load: Load) -> f64 {
        let nu = match self.spectra.values {
            SpectrumValues::Integrals(_) => self.poisson_ratio,
            SpectrumValues::Layered(_, nu) => nu,
        };
        match (component, load) {
            (FieldComponent::Szz, Load::P)
            | (FieldComponent::Sxz, Load::Qx)
            | (FieldComponent::Syz, Load::Qy) => -1.0,
            (FieldComponent::Sxx | FieldComponent::Syy, Load::P) => -nu / (1.0 - nu),
            _ => 0.0,
        }
    }
}

impl Kernels for ComposedSpectra<'_> {
    fn is_odd(&self) -> [[[bool; 2]; 3]; 3] {
        self.components
            .map(|component| Load::ALL.map(|load| StressEntry { load, component }.is_odd()))
    }

    fn add(&self, out: &mut [f64], [i, j]: [usize; 2], factor: f64, kx: usize) {
        let (component, load) = (self.components[i], Load::ALL[j]);
        let (height, column) = (self.spectra.height, kx - self.spectra.first);
        let mut add = |weight: f64, values: &[f64]| {
            for (out, value) in out.iter_mut().zip(&values[column * height..][..height]) {
                *out += weight * value;
            }
        };
        match &self.spectra.values {
            SpectrumValues::Integrals(values) => {
                for (weight, values) in self.weights.of(load, component).iter().zip(values) {
                    if *weight != 0.0 {
                        add(factor * weight, values);
                    }
                }
            }
            SpectrumValues::Layered(values, _) => {
                add(factor, &values[StressEntry { load, component }.index()]);
            }
        }
        if kx == 0 && self.spectra.repeats {
            out[0] = factor * self.mean(component, load);
        }
    }
}
