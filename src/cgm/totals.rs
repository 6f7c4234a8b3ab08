//! Prescribed totals: forces and springs, their distribution over the cells and their multipliers.
//!
//! A step of the linear problem changes the unknowns by `d` and the multipliers by `eta` such that
//!
//! ```math
//! \begin{pmatrix} C & -e \\ e' & D \end{pmatrix} \begin{pmatrix} d \\ \eta \end{pmatrix}
//! = \begin{pmatrix} r \\ \varrho \end{pmatrix}, \qquad r = e\,\delta - (C x + b),
//! ```
//!
//! where $`\varrho`$ is the deficit of the totals. Each column of $`e`$ is one in one component and zero in the other components.
//! The diagonal $`D`$ is zero for a prescribed sum. A spring of compliance `c` from the far end `X` carries
//! $`\sum x = (X - \delta)/c`$, so $`D = 1/c`$. Let the preconditioner $`M`$ approximate $`C^{-1}`$. The patterns $`w_a = M e_a`$
//! are the changes of the unknowns per change of each multiplier. They resemble the pressure under a flat punch. Eliminating
//! $`d`$ with $`M`$ leaves a small system for the multipliers,
//!
//! ```math
//! (e_b' w_a + D_{ab})\,\eta_a = \varrho_b - e_b' M r .
//! ```
//!
//! This system is symmetric and positive definite. It tends to the system of a prescribed sum for a soft spring, and to a
//! prescribed multiplier for a stiff spring. The directions `z = M r + w eta` of the conjugate gradients then keep the totals
//! exactly. Such a preconditioner is called a constraint preconditioner (Keller, Gould & Wathen, SIAM J. Matrix Anal. Appl.
//! 21 (2000) 1300, <https://doi.org/10.1137/S0895479899351805>).
//!
//! # Near the sliding force
//!
//! In the plane, let the prescribed force be smaller than the sliding force by the fraction $`m`$. The angles between tractions
//! and force are then of order $`\theta = \sqrt{2m}`$, and the slip is of order $`1/\theta`$. Along the force the patterns have
//! the size $`\theta^2`$. Two rounding errors would therefore exceed the residual:
//!
//! - The round-off of the entries $`e_b' w_a`$ changes the multiplier along the force by a fraction of order
//!   $`\varepsilon / \theta^2`$. Iterative refinement removes this error. The refinement uses the part of the residual that a
//!   cell can follow, because the slip across the traction is much larger than this part.
//! - If the round-off of the sums were distributed over the cells, it would change the angles by the fraction
//!   $`\varepsilon / \theta^2`$. The patterns follow the exact change only approximately, and the error remains as a residual.

use crate::cgm::active_set_solve::ActiveSetSolve;
use crate::cgm::law::state::Row;
use crate::cgm::linear::Border;
use crate::cgm::reduce;
use crate::cgm::{Constraint, MotionOf};
use crate::numerics::cell_vector::{at, chunks, dot, held, minus, norm, plus, put, slices, within};
use crate::numerics::small_matrix::Small;
use crate::parallel::layout::Layout;

/// Mobility along the weakest direction, relative to the whole mobility, below which slipping cells cannot change a total. Close
/// to the friction limit, the tractions of slipping cells are rotated only slightly away from the total. This small rotation
/// carries the total.
const LEAST_TURN: f64 = 1e-13;
/// Mobility along the weakest direction, relative to the whole mobility, below which all cells are near sliding.
const NEAR_SLIDING: f64 = 1e-6;
/// Number of refinements of the multipliers. Each refinement reduces the error to 1e-3 of its value or less.
const REFINEMENTS: usize = 2;
/// Relative deficit of the sums that counts as round-off near sliding.
const ROUND_OFF_OF_SUMS: f64 = 4.0 * f64::EPSILON;

/// Condition on the sum of one component over all cells.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub enum Total {
    /// No condition: the multiplier is zero.
    Free,
    /// A prescribed sum, whose multiplier is an unknown.
    Sum(f64),
    /// A spring: the multiplier is `far_end - compliance * sum`.
    Spring {
        /// Multiplier at which the spring carries no force.
        far_end: f64,
        /// Change of the multiplier per unit of the sum, positive and finite.
        compliance: f64,
    },
}

impl Total {
    /// Returns the sum if it is prescribed.
    pub(crate) fn sum(self) -> Option<f64> {
        match self {
            Self::Sum(sum) => Some(sum),
            Self::Free | Self::Spring { .. } => None,
        }
    }

    /// Returns the compliance that the total adds to uniform unknowns of `cells` cells, or `None` if the sum is prescribed.
    pub(crate) fn uniform_compliance(self, cells: usize) -> Option<f64> {
        match self {
            Self::Free => Some(0.0),
            Self::Sum(_) => None,
            Self::Spring { compliance, .. } => Some(cells as f64 * compliance),
        }
    }

    /// Returns whether the total imposes no load, because it is free or because its sum or far end is zero.
    pub(crate) fn is_idle(self) -> bool {
        match self {
            Self::Free => true,
            Self::Sum(value) | Self::Spring { far_end: value, .. } => value == 0.0,
        }
    }

    /// Returns the equivalent total for a fraction of the unknowns.
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

    /// Returns the equivalent total for unknowns and displacements measured in a unit.
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

    /// Returns the deficit of the sum at this multiplier.
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

    /// Returns the compliance of a spring, or `None` for other totals.
    pub(super) fn compliance(self) -> Option<f64> {
        match self {
            Self::Spring { compliance, .. } => Some(compliance),
            Self::Free | Self::Sum(_) => None,
        }
    }

    pub(super) fn is_spring(self) -> bool {
        self.compliance().is_some()
    }

    /// Returns the admissible multiplier nearest to the given multiplier. For a spring the result is within round-off of the
    /// value of the spring for this sum. The result is zero for a free component, and the given multiplier for a prescribed sum.
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
                // `clamp` would panic for a bound of NaN and would keep a NaN multiplier.
                if (multiplier - exact).abs() <= noise {
                    multiplier
                } else {
                    exact + noise.copysign(multiplier - exact)
                }
            }
        }
    }
}

/// Returns the sum of each component over all cells, and the sum of the magnitudes of the component.
pub(super) fn sums_of<const N: usize>(layout: &Layout, x: &[&[f64]; N]) -> [[f64; 2]; N] {
    reduce::sum(layout, |i| at(x, i).map(|x| [x, x.abs()]))
}

/// Updates the multipliers of the springs to the current sums of the unknowns.
pub(super) fn hold_springs<const N: usize>(
    totals: &[Total; N],
    layout: &Layout,
    x: &[&[f64]; N],
    multiplier: &mut [f64; N],
) {
    if totals.iter().any(|total| total.is_spring()) {
        let sums = sums_of(layout, x);
        *multiplier = std::array::from_fn(|c| totals[c].held(multiplier[c], sums[c]));
    }
}

/// Returns whether cells with this mobility can change the sums of the given components.
pub(super) fn can_turn<const N: usize>(mobility: &Small<N>, has_sum: [bool; N]) -> bool {
    mobility.least(has_sum) > LEAST_TURN * mobility.trace()
}

/// System of the totals for the current motion of the cells.
#[derive(Debug, Clone, Copy)]
pub(super) struct TotalsSystem<const N: usize> {
    totals: [Total; N],
    /// `e_b' w_a` in row a.
    patterns: Small<N>,
    /// Matrix of all components that are prescribed or tied to a spring.
    pub(super) border: Border<N>,
    /// Mobility: the sum of the motions that the cells can follow if all cells are moved by one along a component.
    pub(super) mobility: Small<N>,
}

impl<const N: usize> TotalsSystem<N> {
    /// System before the moving cells have been determined, as an initial value.
    pub(super) const NONE: Self = Self {
        totals: [Total::Free; N],
        patterns: Small([[0.0; N]; N]),
        border: Border::NONE,
        mobility: Small([[0.0; N]; N]),
    };

    /// Returns the components whose sum is prescribed or tied to a spring.
    fn prescribed(&self) -> [bool; N] {
        self.border.active
    }

    /// Returns the components whose sum is prescribed: their multipliers are independent unknowns.
    pub(super) fn has_sum(&self) -> [bool; N] {
        std::array::from_fn(|a| self.totals[a].sum().is_some())
    }

    /// Returns the components tied to a spring: their multipliers change with the sums.
    pub(super) fn has_spring(&self) -> [bool; N] {
        self.totals.map(Total::is_spring)
    }

    /// Returns the change of all multipliers that compensates the change of the sums by a preconditioned residual.
    pub(super) fn balance(&self, added: [f64; N]) -> [f64; N] {
        self.border.balance([0.0; N], added)
    }

    /// Returns the change of the multipliers of prescribed sums that removes the mean residual, weighted with the patterns.
    pub(super) fn remove_mean(&self, products: [f64; N]) -> [f64; N] {
        let matrix = &self.border.matrix;
        matrix.solve(products.map(|product| -product), self.has_sum())
    }

    /// Returns the quadratic form of a uniform motion with the mobility.
    pub(super) fn square(&self, motion: [f64; N]) -> f64 {
        self.mobility.square(motion)
    }

    /// Returns the curvature that the springs add along a direction with this change of the multipliers.
    pub(super) fn curvature(&self, change: [f64; N]) -> f64 {
        let springs = self.totals.iter().zip(change);
        springs.fold(0.0, |sum, (total, change)| {
            let added = |compliance| sum + change * change / compliance;
            total.compliance().map_or(sum, added)
        })
    }

    /// Returns whether the cells can follow only a small part of a uniform motion along the weakest direction.
    fn is_near_sliding(&self) -> bool {
        let has_sum = [true; N];
        let mobility = &self.mobility;
        let is_near = || mobility.least(has_sum) < NEAR_SLIDING * mobility.trace();
        N > 1 && self.has_sum() == has_sum && is_near()
    }

    /// Returns whether the patterns are usable. If a diagonal entry is not positive and finite, a change of a total would make
    /// the iterate NaN or infinite.
    pub(super) fn is_well_posed(&self) -> bool {
        let prescribed = self.prescribed();
        let moves = (0..N).any(|a| self.mobility.0[a][a] > 0.0);
        let entry = |a: usize| self.border.matrix.0[a][a];
        let is_sound = |a: usize| entry(a) > 0.0 && entry(a).is_finite();
        !moves || (0..N).all(|a| !prescribed[a] || is_sound(a))
    }
}

impl<K: Constraint<N>, const N: usize> ActiveSetSolve<'_, '_, K, N> {
    /// Determines how changes of the multipliers are distributed over the moving cells.
    pub(super) fn set_totals(&mut self) {
        let mut system = TotalsSystem {
            totals: self.problem.totals,
            patterns: Small([[0.0; N]; N]),
            border: Border::new(&self.problem.totals, Small([[0.0; N]; N])),
            mobility: self.workspace.linear.mobility(),
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
        system.patterns = self.linear().spread(&system.totals);
        // For a symmetric problem, the columns equal the rows up to rounding.
        let matrix = if self.problem.operator.is_symmetric() {
            system.patterns
        } else {
            system.patterns.transposed()
        };
        system.border = Border::new(&system.totals, matrix);
        self.totals = system;
    }

    pub(super) fn has_free_cell(&self) -> bool {
        let w = &*self.workspace;
        w.linear.moving.any(&w.linear.rows, Row::is_free)
    }

    /// Distributes the deficit of the totals over the moving cells, given the current sums of the components.
    pub(super) fn spread_missing(&mut self, sums: [f64; N]) {
        let system = self.totals;
        let prescribed = system.prescribed();
        if prescribed == [false; N] {
            return;
        }
        let w = &mut *self.workspace;
        let missing = |a: usize| system.totals[a].missing(sums[a], w.multiplier[a]);
        let missing = std::array::from_fn(missing);
        if system.is_near_sliding() && norm(missing) <= ROUND_OFF_OF_SUMS * norm(sums) {
            return;
        }
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

    /// Refines the multipliers of two prescribed sums: adds the mean of the residual, weighted with the patterns.
    fn refine_multiplier(&mut self) {
        let system = self.totals;
        let w = &mut *self.workspace;
        let (motions, gradient) = (&w.linear.rows, slices(&w.gradient));
        for _ in 0..REFINEMENTS {
            let multiplier = w.multiplier;
            let products: [f64; N] = w.linear.moving.sweep((), |entries, ()| {
                let spread = &w.linear.spread[entries.range.clone()];
                let gradient = within(&gradient, &entries.chunk);
                entries.sums(|k, place| {
                    let residual = minus(at(&gradient, place), multiplier);
                    let followed = entries.row(motions, k, place).restrict(residual);
                    spread[k].map(|w| dot(w, followed))
                })
            });
            let mean = system.patterns.solve(products, system.has_sum());
            w.multiplier = plus(multiplier, 1.0, mean);
        }
    }

    /// Sets the multipliers such that the mean of the residual, weighted with the patterns, vanishes. Multipliers of springs
    /// stay within round-off of the values of the springs for the current sums.
    pub(super) fn set_multiplier(&mut self) {
        let system = self.totals;
        let prescribed = system.prescribed();
        if prescribed == [false; N] {
            return;
        }
        let w = &mut *self.workspace;
        if w.linear.moving.of_all_ranks() == 0 {
            // All cells are at their bounds: `multiplier_at_bounds` has set the multiplier.
            return;
        }
        let gradient = slices(&w.gradient);
        let products: [f64; N] = w.linear.moving.sweep((), |entries, ()| {
            let spread = &w.linear.spread[entries.range.clone()];
            let gradient = within(&gradient, &entries.chunk);
            entries.sums_of(spread.iter(), |spread, _, place| {
                spread.map(|w| dot(w, at(&gradient, place)))
            })
        });
        let mean = system.patterns.solve(products, prescribed);
        if system.has_spring() == [false; N] {
            w.multiplier = mean;
            if system.is_near_sliding() {
                self.refine_multiplier();
            }
            return;
        }
        let sums = sums_of(self.problem.layout, &slices(&self.x));
        for a in (0..N).filter(|&a| system.totals[a].is_spring()) {
            w.multiplier[a] = system.totals[a].held(mean[a], sums[a]);
        }
        // The multipliers of the prescribed sums, given the multipliers of the springs.
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
