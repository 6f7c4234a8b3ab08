//! Displacements and stresses below cells on a coated body.

mod radial;

use crate::bodies::layers::{Base, LayerWaves, SubsurfaceResponse};
use crate::bodies::material::Material;
use crate::error::Result;
use crate::fft::Torus;
use crate::grid::Grid;
use crate::grid::boundary::Boundary;
use crate::memory::fallible;
use crate::parallel::{self, Blocks};
use crate::subsurface::kernel::{
    FieldComponent, Load, LoadedRectangle, PotentialIntegral, Weights,
};
use crate::subsurface::strip::Strips;
use radial::Radial;

/// Component of the response to one traction.
#[derive(Debug, Clone, Copy)]
pub(super) struct StressEntry {
    pub(super) load: Load,
    pub(super) component: FieldComponent,
}

impl StressEntry {
    pub(super) const COUNT: usize = 3 * FieldComponent::COUNT;

    pub(super) fn of(index: usize) -> Self {
        Self {
            load: Load::ALL[index / FieldComponent::COUNT],
            component: FieldComponent::ALL[index % FieldComponent::COUNT],
        }
    }

    pub(super) fn index(self) -> usize {
        FieldComponent::COUNT * self.load as usize + self.component as usize
    }

    /// Returns whether the component is odd in x and odd in y.
    pub(super) fn is_odd(self) -> [bool; 2] {
        let (odd, turns) = (self.component.is_odd(), self.load.turns());
        [odd[0] != turns[0], odd[1] != turns[1]]
    }
}

/// Values of all components under each traction.
type Entries = [f64; StressEntry::COUNT];
/// Values of all components under one traction.
type TractionColumn = [f64; FieldComponent::COUNT];

/// Kernels at a depth below the surface of a coated body.
///
/// In the outermost layer the effect of a cell is the sum of two terms. The first term is the closed form for a
/// half-space with the constants of the layer. The second term is a correction for the material below the layer. It is
/// smooth on the scale of 2h - z. Below the outermost layer the entire effect is smooth on the scale of the depth. The
/// smooth terms are Hankel integrals of the [responses at the depth](SubsurfaceResponse). They are tabulated as
/// functions of the distance and integrated over the cell by Gauss rules, as for the surface.
pub(super) struct Layered<'a> {
    waves: LayerWaves<'a>,
    depth: f64,
    /// Shear modulus and Poisson's ratio of the outermost layer, if the depth is in this layer.
    near: Option<[f64; 2]>,
    radial: Radial,
}

impl<'a> Layered<'a> {
    pub(super) fn new(body: &'a Material, depth: f64) -> Self {
        let waves = body.waves();
        let outermost = match (waves.place(depth).0, body.layers()) {
            (Some(0), [outermost, ..]) => Some(outermost),
            _ => None,
        };
        let scale = outermost.map_or(depth, |layer| 2.0 * layer.thickness() - depth);
        let near = outermost.map(|layer| [layer.shear_modulus(), layer.poisson_ratio()]);
        let of_base = match waves.base {
            Base::Rigid => [0.0; 3],
            Base::Elastic(constants) => of_half_space(constants),
        };
        let less = near.map_or([0.0; 3], of_half_space);
        let pole = std::array::from_fn(|n| of_base[n] - less[n]);
        Self {
            waves,
            depth,
            near,
            radial: Radial::new(body, scale, pole),
        }
    }

    pub(super) fn poisson_ratio(&self) -> f64 {
        self.waves.poisson_ratio_at(self.depth)
    }

    /// Returns the symbols of the components, or their imaginary parts, for a nonzero wave vector.
    pub(super) fn symbols(&self, [x, y]: [f64; 2]) -> Entries {
        let k = x.hypot(y);
        let below = self.waves.at_depth(k, self.depth);
        let [x, y] = [x / k, y / k];
        joined(
            pressed(&below, k, [x, y]),
            sheared(&below, k, [x, y]),
            exchanged(sheared(&below, k, [y, x])),
        )
    }

    /// Returns the coefficients at the local distances of a quarter of the torus, row by row.
    pub(super) fn samples(
        &self,
        grid: Grid,
        boundary: Boundary,
        torus: &Torus,
    ) -> Result<[Vec<f64>; StressEntry::COUNT]> {
        let ([width, _], own) = (torus.quarter(), torus.own_distances());
        let sides = [0.5 * grid.dx(), 0.5 * grid.dy()];
        let cell = LoadedRectangle::new(sides[0], sides[1]);
        let xs = fallible::collected(width, (0..width).map(|i| i as f64 * grid.dx()))?;
        let mut values = fallible::vector(width * own.len())?;
        let data = values.each_mut().map(|values| Blocks {
            items: values,
            width,
        });
        let strips = Strips::new(grid, boundary);
        let period = grid.dy() * grid.ny() as f64;
        let rest = |k: f64| self.rest(k);
        let work = |row: usize, rows: [Blocks<'_, f64>; StressEntry::COUNT]| {
            let y = (own.start + row) as f64 * grid.dy();
            let mut out = rows.map(|row| row.items);
            for (ix, &x) in xs.iter().enumerate() {
                let entries = match boundary {
                    Boundary::PeriodicAlongY { datum } => {
                        self.radial.over_rows(&rest, sides, [x, y], [period, datum])
                    }
                    _ => self.radial.over_cell(&rest, sides, [x, y]),
                };
                for (out, value) in out.iter_mut().zip(entries) {
                    out[ix] = value;
                }
            }
            if let Some([modulus, nu]) = self.near {
                let mut integrals = vec![0.0; PotentialIntegral::COUNT * width];
                let mut lines = integrals.chunks_exact_mut(width);
                let mut lines: [_; PotentialIntegral::COUNT] =
                    std::array::from_fn(|_| lines.next().unwrap_or_default());
                match &strips {
                    None => cell.integrals_along_row(&xs, y, self.depth, &mut lines),
                    Some(strips) => {
                        strips.integrals_along_row(&cell, &xs, [y, self.depth], &mut lines);
                    }
                }
                add_homogeneous(&Weights::new(nu, self.depth), modulus, &lines, &mut out);
            }
        };
        if !own.is_empty() {
            parallel::sweep(0..own.len(), data, &work, &|(), ()| ());
        }
        Ok(values)
    }

    /// Returns the smooth part of the response to waves with wave number k.
    fn rest(&self, k: f64) -> SubsurfaceResponse {
        let whole = self.waves.at_depth(k, self.depth);
        match self.near {
            Some(constants) => {
                let (layers, base) = (&[][..], Base::Elastic(constants));
                whole.less(&LayerWaves { layers, base }.at_depth(k, self.depth))
            }
            None => whole,
        }
    }
}

/// Returns k times the normal displacement of a half-space and its displacements parallel and perpendicular to the wave
/// vector.
fn of_half_space([modulus, nu]: [f64; 2]) -> [f64; 3] {
    [1.0 - nu, 1.0 - nu, 1.0].map(|factor| factor / modulus)
}

/// Adds the components in a homogeneous half-space, which are sums of the integrals.
fn add_homogeneous(
    weights: &Weights,
    modulus: f64,
    integrals: &[&mut [f64]; PotentialIntegral::COUNT],
    out: &mut [&mut [f64]; StressEntry::COUNT],
) {
    for (n, out) in out.iter_mut().enumerate() {
        let StressEntry { load, component } = StressEntry::of(n);
        let unit = if component.is_displacement() {
            modulus
        } else {
            1.0
        };
        for (weight, integral) in weights.of(load, component).iter().zip(integrals) {
            if *weight != 0.0 {
                for (out, value) in out.iter_mut().zip(&**integral) {
                    *out += weight / unit * value;
                }
            }
        }
    }
}

/// Returns the components under a wave of pressure in the direction of a unit vector.
fn pressed(below: &SubsurfaceResponse, k: f64, [x, y]: [f64; 2]) -> TractionColumn {
    let [normal, along, p, q, stress_along, stress_across] = below.by_pressure;
    let (xx, yy, xy) = (x * x, y * y, x * y);
    [
        along * x / k,
        along * y / k,
        normal / k,
        stress_along * xx + stress_across * yy,
        stress_along * yy + stress_across * xx,
        -p,
        (stress_along - stress_across) * xy,
        -q * x,
        -q * y,
    ]
}

/// Returns the components under a wave of traction along x.
fn sheared(below: &SubsurfaceResponse, k: f64, [x, y]: [f64; 2]) -> TractionColumn {
    let [normal, along, p, q, stress_along, stress_across] = below.by_traction;
    let [across, passed, shear] = below.across;
    let (xx, yy, xy) = (x * x, y * y, x * y);
    [
        (along * xx + across * yy) / k,
        (along - across) * xy / k,
        -normal * x / k,
        -x * (stress_along * xx + (stress_across - 2.0 * shear) * yy),
        -x * (stress_along * yy + stress_across * xx + 2.0 * shear * yy),
        p * x,
        -y * ((stress_along - stress_across) * xx + shear * (xx - yy)),
        -(q * xx + passed * yy),
        -(q - passed) * xy,
    ]
}

/// Returns the components with x and y exchanged.
fn exchanged([ux, uy, uz, xx, yy, zz, xy, xz, yz]: TractionColumn) -> TractionColumn {
    [uy, ux, uz, yy, xx, zz, xy, yz, xz]
}

fn joined(pressure: TractionColumn, along_x: TractionColumn, along_y: TractionColumn) -> Entries {
    let loads = [pressure, along_x, along_y];
    std::array::from_fn(|n| loads[n / FieldComponent::COUNT][n % FieldComponent::COUNT])
}
