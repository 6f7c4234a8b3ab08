//! The integrals in closed form, for points near the cell.

use super::edge::{Differences, Edge};
use super::integral::{PotentialIntegral, Values};
use super::piece::CellPart;
use std::f64::consts::PI;

/// The four edges of a rectangle, with the differences between their ends.
struct Outline {
    /// Positions of the edges parallel to y.
    xs: [f64; 2],
    ys: [f64; 2],
    along_y: [Differences; 2],
    along_x: [Differences; 2],
}

impl Outline {
    fn new(piece: &CellPart) -> Self {
        let CellPart { x, y, z, unit } = *piece;
        let (xs, ys) = (x.ends, y.ends);
        // The order of this sum keeps the exchange of the axes exact.
        let distances = xs.map(|x| ys.map(|y| ((x * x + y * y) + z * z).sqrt()));
        let along_y = [0, 1].map(|i| Edge {
            offset: xs[i],
            z,
            extent: y,
            distances: distances[i],
            unit,
        });
        let along_x = [0, 1].map(|j| Edge {
            offset: ys[j],
            z,
            extent: x,
            distances: [distances[0][j], distances[1][j]],
            unit,
        });
        Self {
            xs,
            ys,
            along_y: along_y.map(|edge| edge.differences()),
            along_x: along_x.map(|edge| edge.differences()),
        }
    }

    /// Returns the double difference of a function from its differences along the edges parallel to y.
    fn over_x(&self, of: impl Fn(&Differences) -> f64) -> f64 {
        of(&self.along_y[0]) - of(&self.along_y[1])
    }

    fn over_y(&self, of: impl Fn(&Differences) -> f64) -> f64 {
        of(&self.along_x[0]) - of(&self.along_x[1])
    }

    /// Returns the double difference of `X` times a function.
    fn times_x(&self, of: impl Fn(&Differences) -> f64) -> f64 {
        self.xs[0] * of(&self.along_y[0]) - self.xs[1] * of(&self.along_y[1])
    }

    fn times_y(&self, of: impl Fn(&Differences) -> f64) -> f64 {
        self.ys[0] * of(&self.along_x[0]) - self.ys[1] * of(&self.along_x[1])
    }

    /// Returns the solid angle of the piece. Next to the piece the solid angle is of order z. In this case only one of
    /// the two orders of differences is a sum of angles of order z.
    fn solid_angle(&self, z: f64) -> f64 {
        if z == 0.0 {
            let share = |[_, end]: [f64; 2]| match end {
                end if end < 0.0 => 1.0,
                end if end > 0.0 => 0.0,
                _ => 0.5,
            };
            2.0 * PI * share(self.xs) * share(self.ys)
        } else if self.ys[1] < self.xs[1] {
            self.over_y(|edge| edge.solid_angle)
        } else {
            self.over_x(|edge| edge.solid_angle)
        }
    }
}

/// Returns all integrals over a piece whose centre is in the quadrant `x >= 0`, `y >= 0`.
pub(super) fn integrals(piece: &CellPart) -> Values {
    let z = piece.z;
    let outline = Outline::new(piece);
    let lines_x = outline.times_x(|edge| edge.asinh);
    let lines_y = outline.times_y(|edge| edge.asinh);
    let vx = outline.over_x(|edge| edge.asinh);
    let vy = outline.over_y(|edge| edge.asinh);
    let vz = -outline.solid_angle(z);
    let lxx = outline.over_x(|edge| edge.theta);
    let lxy = outline.over_x(|edge| edge.logarithm);
    let logarithms_x = outline.times_x(|edge| edge.logarithm);
    let logarithms_y = outline.times_y(|edge| edge.logarithm);
    // The variables contain z V_xx and the corresponding products.
    let [xxx, zvxx, zvxz] = [0, 1, 2].map(|k| -outline.over_x(|edge| edge.cubes[k]));
    let [yyy, zvyy, zvyz] = [0, 1, 2].map(|k| -outline.over_y(|edge| edge.cubes[k]));

    let mut values = [0.0; PotentialIntegral::COUNT];
    let mut set = |integral: PotentialIntegral, value| values[integral.index()] = value;
    set(PotentialIntegral::V, lines_x + lines_y + z * vz);
    set(
        PotentialIntegral::Lx,
        logarithms_y + outline.times_x(|edge| edge.theta) + z * vx,
    );
    set(
        PotentialIntegral::Ly,
        logarithms_x + outline.times_y(|edge| edge.theta) + z * vy,
    );
    set(PotentialIntegral::Wxx, z * lxx - lines_x);
    set(
        PotentialIntegral::Wxy,
        z * lxy - outline.over_x(|edge| edge.distance),
    );
    set(PotentialIntegral::Lxx, lxx);
    set(PotentialIntegral::Lxy, lxy);
    set(PotentialIntegral::Wxxy, -outline.over_x(|edge| edge.ratio));
    set(PotentialIntegral::Wxyy, -outline.over_y(|edge| edge.ratio));
    set(PotentialIntegral::Txxx, xxx - 2.0 * vx);
    set(
        PotentialIntegral::Txxy,
        outline.over_x(|edge| edge.inverse[0]) - vy,
    );
    set(
        PotentialIntegral::Txyy,
        outline.over_y(|edge| edge.inverse[0]) - vx,
    );
    set(PotentialIntegral::Tyyy, yyy - 2.0 * vy);
    set(PotentialIntegral::Txxz, zvxx - vz);
    set(
        PotentialIntegral::Txyz,
        outline.over_x(|edge| edge.inverse[1]),
    );
    set(PotentialIntegral::Tyyz, zvyy - vz);
    set(PotentialIntegral::Txzz, zvxz);
    set(PotentialIntegral::Tyzz, zvyz);
    set(PotentialIntegral::Tzzz, -(zvxx + zvyy) - vz);
    values
}
