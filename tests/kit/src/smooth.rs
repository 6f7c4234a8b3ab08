//! Smooth contacts of closed form, at any offset from the cells.

use stickslip::analytical::HertzEllipse;
use stickslip::{Field, Grid, NormalLoad};

use crate::unit_pair;

/// A contact of the [unit pair](unit_pair) with a Poisson's ratio of zero, centred on the origin. Its longer semi-axis
/// is one.
#[expect(missing_debug_implementations, reason = "it holds functions")]
pub struct Smooth {
    pub name: &'static str,
    height: Box<dyn Fn(f64, f64) -> f64>,
    pressure: Box<dyn Fn(f64, f64) -> f64>,
    pub force: f64,
    pub area: f64,
    pub approach: f64,
    pub max_pressure: f64,
}

impl Smooth {
    /// Returns a Hertzian contact of a sphere.
    pub fn sphere() -> Self {
        let peak = 2.0 / std::f64::consts::PI;
        Self {
            name: "sphere",
            height: Box::new(|x, y| 0.5 * (x * x + y * y)),
            pressure: Box::new(move |x, y| peak * (1.0 - x * x - y * y).max(0.0).sqrt()),
            force: 4.0 / 3.0,
            area: std::f64::consts::PI,
            approach: 1.0,
            max_pressure: peak,
        }
    }

    /// Returns the contact of the gap `r^4`.
    pub fn quartic() -> Self {
        let peak = 32.0 / (9.0 * std::f64::consts::PI);
        let pressure = move |x: f64, y: f64| {
            let square = x * x + y * y;
            peak * (1.0 - square).max(0.0).sqrt() * (1.0 + 2.0 * square)
        };
        Self {
            name: "quartic",
            height: Box::new(|x, y| (x * x + y * y).powi(2)),
            pressure: Box::new(pressure),
            force: 64.0 / 15.0,
            area: std::f64::consts::PI,
            approach: 8.0 / 3.0,
            // The maximum is at 2 r^2 = 1.
            max_pressure: peak * 2.0 * 0.5_f64.sqrt(),
        }
    }

    /// Returns a Hertzian contact with a semi-axis ratio of about 2 to 1, rotated by 45 degrees.
    pub fn ellipse() -> Self {
        let of = |scale: f64, load| HertzEllipse::new(&unit_pair(0.0), scale, 0.309 * scale, load);
        // Lengths scale with the radii if the load scales with their square.
        let first = of(1.0, 1.0).unwrap();
        let scale = 1.0 / first.semi_axes()[0];
        let hertz = of(scale, scale * scale).unwrap();
        let [rx, ry] = hertz.radii();
        let turned = |x: f64, y: f64| [(x + y) * 0.5_f64.sqrt(), (y - x) * 0.5_f64.sqrt()];
        Self {
            name: "ellipse",
            height: Box::new(move |x, y| {
                let [x, y] = turned(x, y);
                0.5 * (x * x / rx + y * y / ry)
            }),
            pressure: Box::new(move |x, y| {
                let [x, y] = turned(x, y);
                hertz.pressure(x, y)
            }),
            force: hertz.load(),
            area: hertz.contact_area(),
            approach: hertz.approach(),
            max_pressure: hertz.max_pressure(),
        }
    }

    pub fn all() -> [Self; 3] {
        [Self::sphere(), Self::quartic(), Self::ellipse()]
    }

    /// Returns the gap about a point that is the given number of cells from the middle of the grid.
    pub fn gap(&self, grid: Grid, [x0, y0]: [f64; 2]) -> Field {
        Field::from_fn(grid, |x, y| {
            (self.height)(x - x0 * grid.dx(), y - y0 * grid.dy())
        })
    }

    /// Returns the pressure at the centres of the cells.
    pub fn pressure(&self, grid: Grid, [x0, y0]: [f64; 2]) -> Field {
        Field::from_fn(grid, |x, y| {
            (self.pressure)(x - x0 * grid.dx(), y - y0 * grid.dy())
        })
    }

    /// Returns the mean pressure of each cell, computed from 24 x 24 points.
    pub fn mean_pressure(&self, grid: Grid, [x0, y0]: [f64; 2]) -> Field {
        let parts = 24;
        let part = |k: i32| (f64::from(k) + 0.5) / f64::from(parts) - 0.5;
        Field::from_fn(grid, |x, y| {
            let mut sum = 0.0;
            for (i, j) in (0..parts).flat_map(|i| (0..parts).map(move |j| (i, j))) {
                let (x, y) = (
                    x + (part(i) - x0) * grid.dx(),
                    y + (part(j) - y0) * grid.dy(),
                );
                sum += (self.pressure)(x, y);
            }
            sum / f64::from(parts * parts)
        })
    }

    /// Returns the ratio of stick radius to contact radius, for a force that is this fraction of the sliding force.
    pub fn stick_radius(&self, part: f64) -> f64 {
        // The forces of similar contacts are proportional to the third and fifth power of their radii.
        let power = if self.name == "quartic" { 5.0 } else { 3.0 };
        (1.0 - part).powf(1.0 / power)
    }

    /// Returns the traction of the contact centred on the origin, divided by the friction coefficient. The force is this
    /// fraction of the sliding force. The result is the pressure minus the pressure of a contact that is as large as the
    /// stick zone.
    ///
    /// Sources: J. Jaeger, Arch. Appl. Mech. 65 (1995) 478, <https://doi.org/10.1007/BF00835661>; M. Ciavarella, J. Appl.
    /// Mech. 65 (1998) 998.
    pub fn traction_at(&self, part: f64, x: f64, y: f64) -> f64 {
        let radius = self.stick_radius(part);
        let power = if self.name == "quartic" { 3 } else { 1 };
        let stuck = radius.powi(power) * (self.pressure)(x / radius, y / radius);
        (self.pressure)(x, y) - stuck
    }

    /// Returns the gap about the origin.
    pub fn height(&self, x: f64, y: f64) -> f64 {
        (self.height)(x, y)
    }

    /// Returns the pressure about the origin.
    pub fn pressure_at(&self, x: f64, y: f64) -> f64 {
        (self.pressure)(x, y)
    }

    pub fn load(&self) -> NormalLoad {
        NormalLoad::Force(self.force)
    }
}

/// Returns `sum |a - b|` divided by the sum of `b`, over the cells selected by their index.
pub fn l1_difference(a: &Field, b: &Field, counts: impl Fn(usize) -> bool) -> f64 {
    let pairs = a.iter().zip(b.iter()).enumerate();
    let sum: f64 = pairs
        .filter(|(i, _)| counts(*i))
        .map(|(_, (a, b))| (a - b).abs())
        .sum();
    sum / b.iter().sum::<f64>()
}
