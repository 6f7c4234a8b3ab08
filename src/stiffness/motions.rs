//! The motions of the bodies, as those of the cells of a window.

use std::array::from_fn;

use crate::cgm::reduce;
use crate::grid::boundary::Boundary;
use crate::numerics::cell_vector::{minus, plus};
use crate::parallel::layout::Layout;
use crate::tangential::Axis;

/// Which of shift along x, shift along y and twist a model of tractions along these axes has.
pub(super) fn kinds(axes: &[Axis], boundary: Boundary) -> [bool; 3] {
    let has = |axis: Axis| axes.contains(&axis);
    let may_turn = axes.len() == 2 && boundary.may_turn();
    [has(Axis::X), has(Axis::Y), may_turn]
}

/// The motions of a model: shifts, and the twist about the centre of the contact.
#[derive(Debug, Clone, Copy)]
pub(super) struct Motions<const N: usize> {
    axes: [Axis; N],
    /// Which of shift along x, shift along y and twist the model has.
    has: [bool; 3],
    centre: [f64; 2],
}

impl<const N: usize> Motions<N> {
    /// Of a contact whose cells have these centres.
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

    /// The kinds of the motions, in their order.
    fn kinds(&self) -> impl Iterator<Item = usize> + use<N> {
        let has = self.has;
        (0..3).filter(move |&kind| has[kind])
    }

    pub(super) fn count(&self) -> usize {
        self.kinds().count()
    }

    /// How a motion moves a point.
    pub(super) fn at(&self, motion: usize, [x, y]: [f64; 2]) -> [f64; N] {
        let moved = match self.kinds().nth(motion) {
            Some(0) => [1.0, 0.0],
            Some(1) => [0.0, 1.0],
            Some(_) => [self.centre[1] - y, x - self.centre[0]],
            None => [0.0; 2],
        };
        self.axes.map(|axis| moved[axis.index()])
    }

    /// Loads by the kinds of motions, about the origin of the grid; `None` of those that the model does not have.
    pub(super) fn loads(&self, loads: [f64; 3]) -> [Option<f64>; 3] {
        let loads = self.all_loads(loads);
        from_fn(|kind| self.has[kind].then_some(loads[kind]))
    }

    /// A matrix by the kinds of motions, about the origin of the grid; `None` of loads and motions that the model does not
    /// have.
    pub(super) fn matrix(&self, matrix: &[[f64; 3]; 3]) -> [[Option<f64>; 3]; 3] {
        let matrix = self.full_matrix(matrix);
        from_fn(|load| {
            from_fn(|motion| (self.has[load] && self.has[motion]).then_some(matrix[load][motion]))
        })
    }

    /// Zero where the model has none.
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
