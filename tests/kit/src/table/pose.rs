//! Scenes in different units, rotated, mirrored, and with their bodies exchanged.

use stickslip::history::LeadingEdge;
use stickslip::{Axis, Field, Grid};

/// Units and orientation of a scene: x and y may be swapped first, and then each axis may be reversed.
#[derive(Debug, Clone, Copy)]
pub struct UnitTransform {
    pub length: f64,
    pub pressure: f64,
    pub swaps: bool,
    pub signs: [f64; 2],
    /// Whether body 1 and body 2 are exchanged, which reverses the sign of all tangential quantities.
    pub exchanges: bool,
}

impl UnitTransform {
    pub const IN_PLACE: Self = Self {
        length: 1.0,
        pressure: 1.0,
        swaps: false,
        signs: [1.0; 2],
        exchanges: false,
    };

    pub fn in_units(length: f64, pressure: f64) -> Self {
        Self {
            length,
            pressure,
            ..Self::IN_PLACE
        }
    }

    pub(super) fn swapped<T: Copy>(&self, [x, y]: [T; 2]) -> [T; 2] {
        if self.swaps { [y, x] } else { [x, y] }
    }

    /// Returns the sign of the action of body 2 on body 1.
    pub(super) fn side(&self) -> f64 {
        if self.exchanges { -1.0 } else { 1.0 }
    }

    /// Returns the sign of rotations and moments.
    pub(super) fn turn(&self) -> f64 {
        let swaps = if self.swaps { -1.0 } else { 1.0 };
        swaps * self.signs[0] * self.signs[1] * self.side()
    }

    /// Transforms the side at which particles enter.
    pub(super) fn edge(&self, edge: LeadingEdge) -> LeadingEdge {
        let axis = usize::from((edge.axis() == Axis::Y) != self.swaps);
        let is_positive = matches!(edge, LeadingEdge::PlusX | LeadingEdge::PlusY);
        match (axis, is_positive == (self.signs[axis] > 0.0)) {
            (0, true) => LeadingEdge::PlusX,
            (0, false) => LeadingEdge::MinusX,
            (_, true) => LeadingEdge::PlusY,
            (_, false) => LeadingEdge::MinusY,
        }
    }

    /// Transforms the strain of body 1 minus the strain of body 2.
    pub(super) fn tensor(&self, strain: [[f64; 2]; 2]) -> [[f64; 2]; 2] {
        let [from_x, from_y] = self.swapped([0, 1]);
        let part = |i: usize, j: usize| {
            let [from_i, from_j] = [i, j].map(|k| [from_x, from_y][k]);
            self.side() * self.signs[i] * self.signs[j] * strain[from_i][from_j]
        };
        [[part(0, 0), part(0, 1)], [part(1, 0), part(1, 1)]]
    }

    /// Returns a function of the position in the scene as a field on the transformed grid.
    pub(super) fn field(&self, grid: Grid, value: impl Fn(f64, f64) -> f64) -> Field {
        Field::from_fn(grid, |x, y| {
            let [x, y] = self.back([x, y]).map(|place| place / self.length);
            value(x, y)
        })
    }

    /// Transforms a vector back, except for its units.
    pub(super) fn back(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        self.swapped([self.signs[0] * x, self.signs[1] * y])
    }

    /// Returns the samples of a transformed field in the order of the cells of the scene.
    pub(super) fn cells_back(&self, field: &Field) -> Vec<f64> {
        let (grid, mut samples) = (field.grid(), Vec::new());
        let [nx, ny] = self.swapped([grid.nx(), grid.ny()]);
        let turned = |axis: usize, at: usize, count: usize| {
            if self.signs[axis] < 0.0 {
                count - 1 - at
            } else {
                at
            }
        };
        for iy in 0..ny {
            for ix in 0..nx {
                let [x, y] = self.swapped([ix, iy]);
                let (x, y) = (turned(0, x, grid.nx()), turned(1, y, grid.ny()));
                samples.push(field.as_slice()[y * grid.nx() + x]);
            }
        }
        samples
    }
}
