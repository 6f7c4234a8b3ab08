//! Motions of the bodies, expressed as displacements of the cells of a window.

use std::array::from_fn;

use crate::cgm::reduce;
use crate::grid::boundary::Boundary;
use crate::numerics::cell_vector::{minus, plus};
use crate::parallel::layout::Layout;
use crate::tangential::Axis;

/// Returns whether a model with tractions along these axes has the shift along x, the shift along y and the twist.
pub(super) fn kinds(axes: &[Axis], boundary: Boundary) -> [bool; 3] {
    let has = |axis: Axis| axes.contains(&axis);
    let may_turn = axes.len() == 2 && boundary.may_turn();
    [has(Axis::X), has(Axis::Y), may_turn]
}

/// Motions of a model: shifts, and the twist about the centre of the contact.
#[derive(Debug, Clone, Copy)]
pub(super) struct Motions<const N: usize> {
    axes: [Axis; N],
    /// Whether the model has the shift along x, the shift along y and the twist.
    has: [bool; 3],
    centre: [f64; 2],
}

impl<const N: usize> Motions<N> {
    /// Creates the motions of a contact whose cells have these centres.
    pub(super) fn new(
        axes: [Axis; N],
        boundary: Boundary,
        layout: &Layout,
        place: impl Fn(usize) -> Option<[f64; 2]> + Sync,
    ) -> Self {
        let (sum, count): ([f64; 2], f64) = reduce::sum(layout, |cell| {
            place(cell).map_or(([0.0; 2], 0.0), |place| (place, 1.0))
        });
        Self {
            axes,
            has: kinds(&axes, boundary),
            centre: sum.map(|sum| sum / count),
        }
    }

    /// Returns the indices of the motions that the model has, in order.
    fn kinds(&self) -> impl Iterator<Item = usize> + use<N> {
        let has = self.has;
        (0..3).filter(move |&kind| has[kind])
    }

    pub(super) fn count(&self) -> usize {
        self.kinds().count()
    }

    /// Returns the displacement of a point for a unit of a motion.
    pub(super) fn at(&self, motion: usize, [x, y]: [f64; 2]) -> [f64; N] {
        let moved = match self.kinds().nth(motion) {
            Some(0) => [1.0, 0.0],
            Some(1) => [0.0, 1.0],
            Some(_) => [self.centre[1] - y, x - self.centre[0]],
            None => [0.0; 2],
        };
        self.axes.map(|axis| moved[axis.index()])
    }

    /// Returns the loads in the order of all motions, or `None` for loads that the model does not have. The moment is about the
    /// origin of the grid.
    pub(super) fn loads(&self, loads: [f64; 3]) -> [Option<f64>; 3] {
        let loads = self.all_loads(loads);
        from_fn(|kind| self.has[kind].then_some(loads[kind]))
    }

    /// Returns the matrix in the order of all motions, with `None` for loads and motions that the model does not have. Moment
    /// and twist are about the origin of the grid.
    pub(super) fn matrix(&self, matrix: &[[f64; 3]; 3]) -> [[Option<f64>; 3]; 3] {
        let matrix = self.full_matrix(matrix);
        from_fn(|load| {
            from_fn(|motion| (self.has[load] && self.has[motion]).then_some(matrix[load][motion]))
        })
    }

    /// Returns the loads in the order of all motions, with zero for loads that the model does not have.
    fn all_loads(&self, loads: [f64; 3]) -> [f64; 3] {
        let mut all = [0.0; 3];
        for (kind, load) in self.kinds().zip(loads) {
            all[kind] = load;
        }
        let [x, y] = self.centre;
        if self.has[2] {
            all[2] += x * all[1] - y * all[0];
        }
        all
    }

    fn full_matrix(&self, matrix: &[[f64; 3]; 3]) -> [[f64; 3]; 3] {
        let mut columns = [[0.0; 3]; 3];
        for (place, kind) in self.kinds().enumerate() {
            columns[kind] = self.all_loads(matrix.map(|row| row[place]));
        }
        // A twist about the origin shifts the centre.
        let [x, y] = self.centre;
        if self.has[2] {
            let shifted = minus(
                columns[1].map(|load| x * load),
                columns[0].map(|load| y * load),
            );
            columns[2] = plus(columns[2], 1.0, shifted);
        }
        [0, 1, 2].map(|load| columns.map(|column| column[load]))
    }
}
