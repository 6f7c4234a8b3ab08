//! The prescribed totals: forces and springs, how they spread, and the multipliers that keep them.
//!
//! A step of the linear problem changes the unknowns by `d` and the multipliers by `eta`, so that
//!
//! ```math
//! \begin{pmatrix} C & -e \\ e' & D \end{pmatrix} \begin{pmatrix} d \\ \eta \end{pmatrix}
//! = \begin{pmatrix} r \\ \varrho \end{pmatrix}, \qquad r = e\,\delta - (C x + b),
//! ```
//!
//! where the columns of $`e`$ are ones in one component each, $`\varrho`$ is what is missing of the totals, and the
//! diagonal $`D`$ is zero for a prescribed sum. A spring of compliance `c` from the far end `X` carries
//! $`\sum x = (X - \delta)/c`$: there $`D = 1/c`$. Eliminating $`d`$ with the preconditioner $`M`$ for $`C^{-1}`$
//! leaves, with the patterns $`w_a = M e_a`$, by which a change of each multiplier moves the unknowns as a flat punch
//! would, one small system for the multipliers,
//!
//! ```math
//! (e_b' w_a + D_{ab})\,\eta_a = \varrho_b - e_b' M r .
//! ```
//!
//! It is symmetric and positive definite, and tends to that of a prescribed sum for a soft spring, to a prescribed
//! multiplier for a stiff one. Directions `z = M r + w eta` of the conjugate gradients then keep the totals exactly.
//! (A constraint preconditioner: Keller, Gould & Wathen, SIAM J. Matrix Anal. Appl. 21 (2000) 1300,
//! <https://doi.org/10.1137/S0895479899351805>.)

use crate::cgm::active_set_solve::ActiveSetSolve;
use crate::cgm::law::state::Row;
use crate::cgm::linear::Border;
use crate::cgm::reduce;
use crate::cgm::{Constraint, MotionOf};
use crate::numerics::cell_vector::{at, chunks, dot, held, norm, plus, put, slices, within};
use crate::numerics::small_matrix::Small;
use crate::parallel::layout::Layout;

/// What is prescribed of the sum of one component over all cells.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub enum Total {
    /// Nothing: the multiplier is zero.
    Free,
    /// The sum; the multiplier follows.
    Sum(f64),
    /// A spring: the multiplier is `far_end - compliance * sum`.
    Spring {
        /// The multiplier at which the spring is slack.
        far_end: f64,
        /// Change of the multiplier per sum, positive and finite.
        compliance: f64,
    },
}

impl Total {
    /// The sum, where that is prescribed.
    pub(crate) fn sum(self) -> Option<f64> {
        match self {
            Self::Sum(sum) => Some(sum),
            Self::Free | Self::Spring { .. } => None,
        }
    }

    /// Returns the compliance that it adds to uniform unknowns of `cells` cells, or `None` if the sum is prescribed.
    pub(crate) fn uniform_compliance(self, cells: usize) -> Option<f64> {
        match self {
            Self::Free => Some(0.0),
            Self::Sum(_) => None,
            Self::Spring { compliance, .. } => Some(cells as f64 * compliance),
        }
    }

    /// Whether it asks for nothing.
    pub(crate) fn is_idle(self) -> bool {
        match self {
            Self::Free => true,
            Self::Sum(value) | Self::Spring { far_end: value, .. } => value == 0.0,
        }
    }

    /// What asks the same of this part of the unknowns.
    pub(crate) fn scaled(self, part: f64) -> Self {
        match self {
            Self::Free => Self::Free,
            Self::Sum(sum) => Self::Sum(part * sum),
            Self::Spring {
                far_end,
                compliance,
            } => Self::Spring {
                far_end,
                compliance: compliance / part,
            },
        }
    }

    /// What asks the same of unknowns and displacements measured in a unit.
    pub(crate) fn in_unit(self, unit: f64) -> Self {
        match self {
            Self::Free => Self::Free,
            Self::Sum(sum) => Self::Sum(sum / unit),
            Self::Spring {
                far_end,
                compliance,
            } => Self::Spring {
                far_end: far_end / unit,
                compliance,
            },
        }
    }

    /// What is missing of the sum at this multiplier.
    pub(super) fn missing(self, sum: f64, multiplier: f64) -> f64 {
        match self {
            Self::Free => 0.0,
            Self::Sum(total) => total - sum,
            Self::Spring {
                far_end,
                compliance,
            } => (far_end - multiplier) / compliance - sum,
        }
    }

    pub(super) fn is_spring(self) -> bool {
        matches!(self, Self::Spring { .. })
    }

    /// What a multiplier may be beside a sum: that of the spring, and round-off; anything else where there is no
    /// spring.
    pub(super) fn held(self, multiplier: f64, [sum, magnitude]: [f64; 2]) -> f64 {
        match self {
            Self::Free => 0.0,
            Self::Sum(_) => multiplier,
            Self::Spring {
                far_end,
                compliance,
            } => {
                let exact = far_end - compliance * sum;
                let noise = 4.0 * f64::EPSILON * (far_end.abs() + compliance * magnitude);
                // A bound of NaN would panic, and NaN would stay.
                if (multiplier - exact).abs() <= noise {
                    multiplier
                } else {
                    exact + noise.copysign(multiplier - exact)
                }
            }
        }
    }
}

/// The sum of each component over all cells, and the sum of its magnitudes.
pub(super) fn sums_of<const N: usize>(layout: &Layout, x: &[&[f64]; N]) -> [[f64; 2]; N] {
    reduce::sum(layout, |i| at(x, i).map(|x| [x, x.abs()]))
}

/// The totals beside the cells as they may move at present.
#[derive(Debug, Clone, Copy)]
pub(super) struct TotalsSystem<const N: usize> {
    totals: [Total; N],
    /// `e_b' w_a` in row a.
    patterns: Small<N>,
    /// Of all components that are prescribed or held by a spring.
    pub(super) border: Border<N>,
    /// How a uniform motion is followed: the sum of what cells can do of it.
    pub(super) mobility: Small<N>,
}

impl<const N: usize> TotalsSystem<N> {
    /// Before the cells are known that move.
    pub(super) const NONE: Self = Self {
        totals: [Total::Free; N],
        patterns: Small([[0.0; N]; N]),
        border: Border::NONE,
        mobility: Small([[0.0; N]; N]),
    };

    /// Components whose sum is prescribed or held by a spring.
    fn prescribed(&self) -> [bool; N] {
        self.border.active
    }

    /// Components whose sum is prescribed: their multipliers are unknowns of their own.
    pub(super) fn has_sum(&self) -> [bool; N] {
        std::array::from_fn(|a| self.totals[a].sum().is_some())
    }

    /// Components held by a spring: their multipliers change with the sums.
    pub(super) fn has_spring(&self) -> [bool; N] {
        self.totals.map(Total::is_spring)
    }

    /// The change of all multipliers that makes up for what a preconditioned residual adds to the sums.
    pub(super) fn balance(&self, added: [f64; N]) -> [f64; N] {
        self.border.balance([0.0; N], added)
    }

    /// The change of the multipliers of the sums that leaves no mean residual, weighted as they spread.
    pub(super) fn remove_mean(&self, products: [f64; N]) -> [f64; N] {
        let matrix = &self.border.matrix;
        matrix.solve(products.map(|product| -product), self.has_sum())
    }

    /// The square of what all cells can do of a uniform motion.
    pub(super) fn square(&self, motion: [f64; N]) -> f64 {
        self.mobility.square(motion)
    }

    /// What the springs add to the curvature along a direction that changes their multipliers so.
    pub(super) fn curvature(&self, change: [f64; N]) -> f64 {
        let springs = self.totals.iter().zip(change);
        springs.fold(0.0, |sum, (total, change)| match total {
            Total::Spring { compliance, .. } => sum + change * change / compliance,
            Total::Free | Total::Sum(_) => sum,
        })
    }

    /// Whether the patterns are those of a preconditioner: a change of a total that nothing follows, or that is no number,
    /// would leave no number of the iterate.
    pub(super) fn is_well_posed(&self) -> bool {
        let prescribed = self.prescribed();
        let moves = (0..N).any(|a| self.mobility.0[a][a] > 0.0);
        let entry = |a: usize| self.border.matrix.0[a][a];
        let is_sound = |a: usize| entry(a) > 0.0 && entry(a).is_finite();
        !moves || (0..N).all(|a| !prescribed[a] || is_sound(a))
    }
}

impl<K: Constraint<N>, const N: usize> ActiveSetSolve<'_, '_, K, N> {
    /// Finds how changes of the multipliers spread over the cells that move.
    pub(super) fn set_totals(&mut self) {
        let mut system = TotalsSystem {
            totals: self.problem.totals,
            patterns: Small([[0.0; N]; N]),
            border: Border {
                active: self.problem.totals.map(|total| total != Total::Free),
                ..Border::NONE
            },
            mobility: self.mobility(),
        };
        if system.prescribed() == [false; N] {
            self.totals = system;
            return;
        }
        if MotionOf::<K, N>::IS_CURVED && !self.has_free_cell() {
            if let Some(normal) = self.uncontrollable_direction(&system) {
                self.release_bound_cells(&mut system, normal);
            }
        }
        let prescribed = system.prescribed();
        for a in (0..N).filter(|&a| prescribed[a]) {
            system.patterns.0[a] = self.linear().spread(a);
        }
        let matrix = &mut system.border.matrix;
        // The columns of a symmetric problem are its rows but for rounding.
        *matrix = if self.problem.operator.is_symmetric() {
            system.patterns
        } else {
            system.patterns.transposed()
        };
        for (a, total) in system.totals.iter().enumerate() {
            if let Total::Spring { compliance, .. } = total {
                matrix.0[a][a] += 1.0 / compliance;
            }
        }
        self.totals = system;
    }

    fn has_free_cell(&self) -> bool {
        let w = &*self.workspace;
        w.linear.moving.any(&w.linear.rows, Row::is_free)
    }

    /// The sum of what cells can do of a uniform motion along each component.
    pub(super) fn mobility(&self) -> Small<N> {
        let w = &*self.workspace;
        let unit = |a: usize| std::array::from_fn(|c| if a == c { 1.0 } else { 0.0 });
        if !MotionOf::<K, N>::IS_CURVED {
            let count = w.linear.moving.of_all_ranks() as f64;
            return Small(std::array::from_fn(|a| unit(a).map(|one: f64| one * count)));
        }
        let motions = &w.linear.rows;
        Small(w.linear.moving.sweep((), |entries, ()| {
            entries.sums(|k, place| {
                let motion = entries.row(motions, k, place);
                std::array::from_fn(|a| motion.restrict(unit(a)))
            })
        }))
    }

    /// Spreads what is missing of the totals, with the present sums of the components.
    pub(super) fn spread_missing(&mut self, sums: [f64; N]) {
        let system = self.totals;
        let prescribed = system.prescribed();
        if prescribed == [false; N] {
            return;
        }
        let w = &mut *self.workspace;
        let missing = |a: usize| system.totals[a].missing(sums[a], w.multiplier[a]);
        let missing = std::array::from_fn(missing);
        let change = system.border.balance(missing, [0.0; N]);
        if norm(change) == 0.0 || !system.is_well_posed() {
            return;
        }
        let spread = &w.linear.spread;
        w.linear.moving.sweep(
            chunks(self.problem.layout, &mut self.x),
            |entries, mut x| {
                for (place, w) in entries.places().zip(&spread[entries.range.clone()]) {
                    let moved = (0..N).fold(held(&x, place), |x, a| plus(x, change[a], w[a]));
                    put(&mut x, place, moved);
                }
            },
        );
        for a in (0..N).filter(|&a| system.totals[a].is_spring()) {
            w.multiplier[a] += change[a];
        }
        self.product_error = f64::INFINITY;
    }

    /// The multipliers that leave no mean residual, weighted as the totals spread; those of springs within the
    /// round-off of what the springs make of the sums.
    pub(super) fn set_multiplier(&mut self) {
        let system = self.totals;
        let prescribed = system.prescribed();
        if prescribed == [false; N] {
            return;
        }
        let w = &mut *self.workspace;
        if w.linear.moving.of_all_ranks() == 0 {
            // All stand at their bounds: the multiplier is that of `multiplier_at_bounds`.
            return;
        }
        let gradient = slices(&w.gradient);
        let products: [f64; N] = w.linear.moving.sweep((), |entries, ()| {
            let spread = &w.linear.spread[entries.range.clone()];
            let gradient = within(&gradient, &entries.chunk);
            entries.sums(|k, place| spread[k].map(|w| dot(w, at(&gradient, place))))
        });
        let mean = system.patterns.solve(products, prescribed);
        if system.has_spring() == [false; N] {
            w.multiplier = mean;
            return;
        }
        let sums = sums_of(self.problem.layout, &slices(&self.x));
        for a in (0..N).filter(|&a| system.totals[a].is_spring()) {
            w.multiplier[a] = system.totals[a].held(mean[a], sums[a]);
        }
        // The sums' multipliers beside those.
        let right = std::array::from_fn(|b| {
            let springs = (0..N).filter(|&a| system.totals[a].is_spring());
            springs.fold(products[b], |sum, a| {
                sum - system.patterns.0[b][a] * w.multiplier[a]
            })
        });
        let free = system.patterns.solve(right, system.has_sum());
        for a in (0..N).filter(|&a| system.has_sum()[a]) {
            w.multiplier[a] = free[a];
        }
    }
}
