//! The integrals over a cell and all its images along y.

use std::f64::consts::FRAC_PI_2;

use crate::grid::Grid;
use crate::grid::boundary::Boundary;
use crate::influence::periodic_images::{FAR, pieces};
use crate::subsurface::kernel::{LoadedRectangle, PotentialIntegral};

/// Rows of cells that are periodic along y. The cells near the point are summed individually. A uniform strip
/// represents the other cells (see [`periodic_images`](crate::influence::periodic_images)).
#[derive(Debug, Clone, Copy)]
pub(super) struct Strips {
    /// Half sides of a cell.
    a: f64,
    b: f64,
    period: f64,
    datum: f64,
    /// Length that replaces a zero distance inside a logarithm. The pieces that correct the strip use the same length.
    edge: f64,
}

impl Strips {
    /// Creates the strips for a grid that is periodic along y only. Returns `None` for other grids.
    pub(super) fn new(grid: Grid, boundary: Boundary) -> Option<Self> {
        let Boundary::PeriodicAlongY { datum } = boundary else {
            return None;
        };
        let (a, b) = (0.5 * grid.dx(), 0.5 * grid.dy());
        let period = grid.dy() * grid.ny() as f64;
        let longest = pieces(b, period).map(|piece| piece.half).fold(b, f64::max);
        let edge = a.max(if grid.ny() == 1 { b } else { longest });
        Some(Self {
            a,
            b,
            period,
            datum,
            edge,
        })
    }

    /// Returns the integrals at `[x, y, z]` with `|y| <= period/2`.
    pub(super) fn integrals(
        &self,
        cell: &LoadedRectangle,
        [x, y, z]: [f64; 3],
    ) -> [f64; PotentialIntegral::COUNT] {
        let mut values = [0.0; PotentialIntegral::COUNT];
        let mut out = values.each_mut().map(std::slice::from_mut);
        self.integrals_along_row(cell, &[x.abs()], [y.abs(), z], &mut out);
        for (value, integral) in values.iter_mut().zip(PotentialIntegral::ALL) {
            let [is_odd_x, is_odd_y] = integral.is_odd();
            if (is_odd_x && x < 0.0) != (is_odd_y && y < 0.0) {
                *value = -*value;
            }
        }
        values
    }

    /// Computes the integrals at the points `(x, y, z)` of a row with ascending `x >= 0` and with `0 <= y <= period/2`.
    pub(super) fn integrals_along_row(
        &self,
        cell: &LoadedRectangle,
        xs: &[f64],
        [y, z]: [f64; 2],
        out: &mut [&mut [f64]; PotentialIntegral::COUNT],
    ) {
        let share = 2.0 * self.b / self.period;
        for (k, &x) in xs.iter().enumerate() {
            for (out, value) in out.iter_mut().zip(self.of_strip(x, z)) {
                out[k] = share * value;
            }
        }
        // A cell as long as the period is a strip.
        if share >= 1.0 {
            return;
        }
        let near = xs.partition_point(|x| (x - self.a).max(0.0).hypot(z) < FAR * self.period);
        let mut values = vec![0.0; PotentialIntegral::COUNT * near];
        for piece in pieces(self.b, self.period) {
            if near == 0 {
                break;
            }
            let mut lines = values.chunks_exact_mut(near);
            let mut part = std::array::from_fn(|_| lines.next().unwrap_or_default());
            let long;
            let rectangle = if piece.is_strip {
                long = LoadedRectangle::new(self.a, piece.half);
                &long
            } else {
                cell
            };
            rectangle.integrals_along_row(&xs[..near], y + piece.offset, z, &mut part);
            for (out, part) in out.iter_mut().zip(&part) {
                for (out, part) in out.iter_mut().zip(&**part) {
                    *out += piece.weight * part;
                }
            }
        }
        // At these y the images on both sides are symmetric, so odd integrals vanish.
        if y == 0.0 || 2.0 * y >= self.period {
            for (out, integral) in out.iter_mut().zip(PotentialIntegral::ALL) {
                if integral.is_odd()[1] {
                    out.fill(0.0);
                }
            }
        }
    }

    /// Returns the integrals over an infinitely long strip of half width `a` along y. They are the limits of
    /// the closed forms. `V` is relative to the datum, and a constant is omitted from `W_xx = -V`, as on the
    /// surface.
    fn of_strip(&self, x: f64, z: f64) -> [f64; PotentialIntegral::COUNT] {
        // Lengths are in units of the half width.
        let [x, z, datum] = [x, z, self.datum].map(|length| length / self.a);
        let (right, left) = (x + 1.0, x - 1.0);
        let mut squares = [right, left].map(|x| x * x + z * z);
        let [arc_right, arc_left] = [right, left].map(|x| x.atan2(z));
        // These are differences between the edges at x + a and x - a.
        let (arcs, logarithms, zz, zx);
        if squares[1] == 0.0 {
            // On an edge of the loaded strip the value is the mean of both sides. A length replaces the zero distance
            // in the logarithm.
            squares[1] = (self.edge / self.a).powi(2);
            logarithms = (squares[0] / squares[1]).ln();
            (arcs, zz, zx) = (FRAC_PI_2, 0.0, 0.0);
        } else {
            logarithms = (4.0 * x / squares[1]).ln_1p();
            arcs = (2.0 * z).atan2(z * z + right * left);
            let product = squares[0] * squares[1];
            zz = 4.0 * x * z * z / product;
            zx = 2.0 * z * (z * z - right * left) / product;
        }
        let [log_right, log_left] = squares.map(|square| (square / (datum * datum)).ln());
        let v = 4.0 - x * logarithms - (log_right + log_left) - 2.0 * z * arcs;
        let of = |integral: PotentialIntegral| match integral {
            PotentialIntegral::V => self.a * v,
            PotentialIntegral::Wxx => -self.a * v,
            PotentialIntegral::Lx => {
                self.a * (2.0 * (x * arcs + arc_right + arc_left) - z * logarithms)
            }
            PotentialIntegral::Lxx | PotentialIntegral::Tyyz => 2.0 * arcs,
            PotentialIntegral::Txxx => 2.0 * (logarithms - zz),
            PotentialIntegral::Txyy => logarithms,
            PotentialIntegral::Txzz => 2.0 * zz,
            PotentialIntegral::Txxz => 2.0 * (arcs - zx),
            PotentialIntegral::Tzzz => 2.0 * (arcs + zx),
            PotentialIntegral::Ly
            | PotentialIntegral::Wxy
            | PotentialIntegral::Lxy
            | PotentialIntegral::Wxxy
            | PotentialIntegral::Wxyy
            | PotentialIntegral::Txxy
            | PotentialIntegral::Tyyy
            | PotentialIntegral::Txyz
            | PotentialIntegral::Tyzz => 0.0,
        };
        PotentialIntegral::ALL.map(of)
    }
}
