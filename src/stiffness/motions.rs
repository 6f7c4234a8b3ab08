//! The motions of the bodies, as those of the cells of a window.

use std::array::from_fn;

use crate::boundary::Boundary;
use crate::buffer;
use crate::cgm::vector::{minus, plus};
use crate::error::Result;
use crate::grid::Grid;
use crate::stiffness::system::Vector;
use crate::tangential::{Axis, centre};
use crate::window::Window;

/// Which of shift along x, shift along y and twist a model of tractions along these axes has.
pub(super) fn kinds(axes: &[Axis], boundary: Boundary) -> Vec<usize> {
    let twist = (axes.len() == 2 && boundary.may_turn()).then_some(2);
    axes.iter().map(|axis| axis.index()).chain(twist).collect()
}

/// The motions of a model: shifts, and the twist about the centre of the contact.
pub(super) struct Motions<const N: usize> {
    pub(super) cells: Vec<Vector<N>>,
    /// Which of shift along x, shift along y and twist each is.
    kinds: Vec<usize>,
    centre: [f64; 2],
}

impl<const N: usize> Motions<N> {
    pub(super) fn new(
        grid: Grid,
        window: Window,
        axes: [Axis; N],
        boundary: Boundary,
        is_contact: impl Fn(usize) -> bool,
    ) -> Result<Self> {
        let (mut sum, mut count) = ([0.0; 2], 0.0);
        for i in window.indices().filter(|&i| is_contact(i)) {
            let [x, y] = centre(grid, i);
            (sum, count) = ([sum[0] + x, sum[1] + y], count + 1.0);
        }
        let middle = sum.map(|sum| sum / count);
        let motion = |f: &dyn Fn([f64; 2]) -> [f64; 2]| -> Result<Vector<N>> {
            let mut cells: Vector<N> = buffer::vector(window.cells())?;
            for (k, i) in window.indices().enumerate().filter(|&(_, i)| is_contact(i)) {
                let moved = f(centre(grid, i));
                for (part, axis) in cells.iter_mut().zip(axes) {
                    part[k] = moved[axis.index()];
                }
            }
            Ok(cells)
        };
        let mut cells: Vec<_> = axes
            .iter()
            .map(|axis| {
                let mut unit = [0.0; 2];
                unit[axis.index()] = 1.0;
                motion(&|_| unit)
            })
            .collect::<Result<_>>()?;
        let kinds = kinds(&axes, boundary);
        if kinds.contains(&2) {
            cells.push(motion(&|[x, y]| [middle[1] - y, x - middle[0]])?);
        }
        Ok(Self {
            cells,
            kinds,
            centre: middle,
        })
    }

    /// Loads by the kinds of motions, about the origin of the grid; `None` of those that the model does not have.
    pub(super) fn loads(&self, loads: [f64; 3]) -> [Option<f64>; 3] {
        let loads = self.all_loads(loads);
        from_fn(|kind| self.kinds.contains(&kind).then_some(loads[kind]))
    }

    /// A matrix by the kinds of motions, about the origin of the grid; `None` of loads and motions that the model does not
    /// have.
    pub(super) fn matrix(&self, matrix: &[[f64; 3]; 3]) -> [[Option<f64>; 3]; 3] {
        let has = |kind| self.kinds.contains(&kind);
        let matrix = self.full_matrix(matrix);
        from_fn(|load| from_fn(|motion| (has(load) && has(motion)).then_some(matrix[load][motion])))
    }

    /// Zero where the model has none.
    fn all_loads(&self, loads: [f64; 3]) -> [f64; 3] {
        let mut all = [0.0; 3];
        for (&kind, load) in self.kinds.iter().zip(loads) {
            all[kind] = load;
        }
        let [x, y] = self.centre;
        if self.kinds.contains(&2) {
            all[2] += x * all[1] - y * all[0];
        }
        all
    }

    fn full_matrix(&self, matrix: &[[f64; 3]; 3]) -> [[f64; 3]; 3] {
        let mut columns = [[0.0; 3]; 3];
        for (place, &kind) in self.kinds.iter().enumerate() {
            columns[kind] = self.all_loads(matrix.map(|row| row[place]));
        }
        // A twist about the origin shifts the centre.
        let [x, y] = self.centre;
        if self.kinds.contains(&2) {
            let shifted = minus(
                columns[1].map(|load| x * load),
                columns[0].map(|load| y * load),
            );
            columns[2] = plus(columns[2], 1.0, shifted);
        }
        [0, 1, 2].map(|load| columns.map(|column| column[load]))
    }
}
