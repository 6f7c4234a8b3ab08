//! Energy balance of a tangential step or of the steps of a cycle.

use crate::cgm::reduce::{self, Reduction};
use crate::grid::field::Field;
use crate::normal::NormalSolution;
use crate::parallel::layout::Layout;
use crate::parallel::ranks::WireFormat;

/// Balance of the work of the tangential load in a step or in the steps of a [`Cycle`](crate::history::Cycle)
/// (energies: force times length).
///
/// The indices n and n+1 denote the tractions q and displacements u before and after the step. The mean of the two
/// tractions is $`\bar q`$. $`\Delta u`$ and $`\Delta\delta`$ are the changes of displacement and shift, and A is the
/// area of a cell. Then
///
/// ```math
/// \underbrace{\tfrac12 (F_n + F_{n+1})\,\Delta\delta}_{\text{work}}
/// = \underbrace{\tfrac A2 \textstyle\sum q_{n+1} u_{n+1} - \tfrac A2 \sum q_n u_n}_{\text{change of the elastic energy}}
/// \; \underbrace{- \; A \textstyle\sum \bar q\,(\Delta u - \Delta\delta)}_{\text{the rest}}
/// ```
///
/// holds for any two states, because the operator is symmetric. A closed balance therefore verifies the energy accounting of the
/// step, but neither the laws of contact nor the accuracy of the tractions. In the vector model the products are scalar products.
/// If body 2 turns, the motion of a cell is $`\delta + \varphi\,(-y, x)`$. The moment then adds the work
/// $`\tfrac12 (M_n + M_{n+1})\,\Delta\varphi`$.
///
/// A cell that comes into contact within the step follows only a part of the motion
/// ([`EntryRule`](crate::history::EntryRule)). This part replaces $`\Delta\delta`$ on both sides. If a [relative
/// displacement](crate::tangential::RelativeDisplacement) w changes, $`\Delta\delta - \Delta w`$ replaces
/// $`\Delta\delta`$.
///
/// The work that is not stored consists of three parts:
///
/// - [`dissipated_energy_midpoint`](Self::dissipated_energy_midpoint), the dissipation by slip,
/// - [`released`](Self::released), the energy that cells release when they leave the contact,
/// - [`residual`](Self::residual), the work on the residual motion of stick cells, which the tolerance of the solve
///   allows.
///
/// The energy $`F^2 / 2k`$ of a spring is not included. The work in the balance is the work of the spring on body 2.
///
/// In a step that [rolls](crate::history#rolling), $`q_n`$ and $`u_n`$ belong to the particle that is in the cell after
/// the step. $`\Delta\delta`$ is the motion of body 2 along the path of the particle.
///
/// For bodies of the same material, and for neglected or one-way coupling, all energies are energies of shear. The
/// balance then excludes the work of the pressure. For dissimilar bodies with full coupling, the work has the additional
/// term $`A \sum \bar p\,\Delta u_z`$. `elastic_before` and `elastic_after` then have the additional term
/// $`\tfrac A2 \sum p\,u_z`$. The dissipated energy is the dissipation by slip in all cases.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub struct EnergyBalance {
    /// Work of the tangential load: mean force times change of the shift, plus mean moment times change of the twist. For
    /// cells that come into contact, the work includes only the part of the motion that they follow. The work of a
    /// changing relative displacement is included. For coupled bodies the work of the normal load is included too.
    pub work: f64,
    /// Elastic energy of shear before the step, or elastic energy of pressure and traction for coupled bodies.
    pub elastic_before: f64,
    /// Elastic energy of shear after the step, or elastic energy of pressure and traction for coupled bodies.
    pub elastic_after: f64,
    /// Dissipated energy, computed from the tractions at the end of the step: $`-A \sum q_{n+1} s \ge 0`$. Under an
    /// unchanged pressure and a load that does not turn within the step, cells slip only at the friction limit. The
    /// energy is then exact for any length of the step. Summed over a cycle, it equals the loop area of the closed form of
    /// Mindlin and Deresiewicz.
    pub dissipated_energy: f64,
    /// Dissipated energy, computed from the mean tractions: $`-A \sum \bar q s`$. This energy closes the balance. It is
    /// non-negative under an unchanged pressure and friction (in the vector model up to the tolerance).
    pub dissipated_energy_midpoint: f64,
    /// Energy of the tractions that cells lose when they leave the contact, computed from the mean tractions.
    pub released: f64,
    /// Work on the residual motion of stick cells, which the tolerance of the solve allows.
    pub residual: f64,
}

impl EnergyBalance {
    /// Computes the work and the elastic energies of the pressure in a step over the cells of a layout. `before` and
    /// `after` are the contacts with their gaps before loading. `place` returns the cell of a particle before the step,
    /// or `None` for a particle from outside the grid, which had no pressure.
    pub(super) fn of_pressing(
        layout: &Layout,
        before: (&NormalSolution, &Field),
        after: (&NormalSolution, &Field),
        place: impl Fn(usize) -> Option<usize> + Sync,
    ) -> Self {
        let at = |(contact, gap): (&NormalSolution, &Field), i: usize| {
            let displacement =
                contact.gap().as_slice()[i] + (contact.approach() - gap.as_slice()[i]);
            (contact.pressure().as_slice()[i], displacement)
        };
        let [work, elastic_before, elastic_after] = reduce::sum(layout, |i| {
            let (p_next, u_next) = at(after, i);
            let (p, u) = place(i).map_or((0.0, u_next), |place| at(before, place));
            [
                0.5 * (p + p_next) * (u_next - u),
                0.5 * p * u,
                0.5 * p_next * u_next,
            ]
        });
        let cell_area = before.1.grid().cell_area();
        Self {
            work: cell_area * work,
            elastic_before: cell_area * elastic_before,
            elastic_after: cell_area * elastic_after,
            ..Self::default()
        }
    }

    /// Returns the energies in the order of [`Self::from_parts`].
    #[inline]
    fn parts(self) -> [f64; 7] {
        let [before, after] = [self.elastic_before, self.elastic_after];
        let [end, middle] = [self.dissipated_energy, self.dissipated_energy_midpoint];
        let rest = [self.released, self.residual];
        [self.work, before, after, end, middle, rest[0], rest[1]]
    }

    #[inline]
    const fn from_parts(parts: [f64; 7]) -> Self {
        let [work, before, after, end, middle, released, residual] = parts;
        Self {
            work,
            elastic_before: before,
            elastic_after: after,
            dissipated_energy: end,
            dissipated_energy_midpoint: middle,
            released,
            residual,
        }
    }

    /// Extends the balance by the following step.
    pub(super) fn extend(&mut self, next: &Self) {
        self.work += next.work;
        self.elastic_after = next.elastic_after;
        self.dissipated_energy += next.dissipated_energy;
        self.dissipated_energy_midpoint += next.dissipated_energy_midpoint;
        self.released += next.released;
        self.residual += next.residual;
    }

    /// Returns the imbalance, which is due to round-off only if the balance contains every step of its interval.
    #[must_use]
    pub fn imbalance(&self) -> f64 {
        let lost = self.dissipated_energy_midpoint + self.released + self.residual;
        self.work - (self.elastic_after - self.elastic_before) - lost
    }
}

impl Reduction for EnergyBalance {
    /// Returns the sum of this balance and the balance of other cells.
    #[inline]
    fn plus(self, other: Self) -> Self {
        Self::from_parts(self.parts().plus(other.parts()))
    }
}

impl WireFormat for EnergyBalance {
    const COUNT: usize = <[f64; 7]>::COUNT;
    const ZERO: Self = Self::from_parts([0.0; 7]);

    fn write(self, words: &mut Vec<u64>) {
        self.parts().write(words);
    }

    fn read(words: &mut &[u64]) -> Self {
        Self::from_parts(WireFormat::read(words))
    }
}
