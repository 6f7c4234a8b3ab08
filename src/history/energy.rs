//! The energy of a tangential step, or of the steps of a cycle.

use crate::cgm::reduce;
use crate::grid::field::Field;
use crate::normal::NormalSolution;
use crate::parallel::layout::Layout;
use crate::parallel::ranks::WireFormat;

/// Where the work of the tangential load in a step went (energies: force times length), or in the steps of a
/// [`Cycle`](crate::history::Cycle).
///
/// With q and u the tractions and displacements before (n) and after (n+1) the step, $`\bar q`$ their
/// mean, $`\Delta u`$ and $`\Delta\delta`$ the changes of displacement and shift, and A the area of a
/// cell,
///
/// ```math
/// \underbrace{\tfrac12 (F_n + F_{n+1})\,\Delta\delta}_{\text{work}}
/// = \underbrace{\tfrac A2 \textstyle\sum q_{n+1} u_{n+1} - \tfrac A2 \sum q_n u_n}_{\text{change of the elastic energy}}
/// \; \underbrace{- \; A \textstyle\sum \bar q\,(\Delta u - \Delta\delta)}_{\text{the rest}}
/// ```
///
/// holds for any two states, because the operator is symmetric. In the plane, products are those of vectors, and
/// to the work comes that of the moment, $`\tfrac12 (M_n + M_{n+1})\,\Delta\varphi`$, as the motion of a cell is
/// $`\delta + \varphi\,(-y, x)`$. A cell that comes into contact within the step follows a part of the motion
/// ([`EntryRule`](crate::history::EntryRule)), which then stands for $`\Delta\delta`$ on both sides; where a
/// [relative displacement](crate::tangential::RelativeDisplacement) w changes, $`\Delta\delta - \Delta w`$ does. The rest
/// is what slip dissipates ([`dissipated_energy_midpoint`](Self::dissipated_energy_midpoint)), what cells that leave the contact let go
/// ([`released`](Self::released)) and what the tolerance of the solve leaves where there should be no slip
/// ([`residual`](Self::residual)). What a spring stores, $`F^2 / 2k`$, is not among these: work is what it does to
/// body 2.
///
/// In a step that [rolls](crate::history#rolling) $`q_n`$ and $`u_n`$ are those that a particle brings along, and
/// $`\Delta\delta`$ is what body 2 moves along its way.
///
/// Bodies alike, and a history that neglects the coupling or takes it one way: pressing is left out, all energies are those
/// of shear. Dissimilar bodies whose pressure and traction are found together: work, `elastic_before` and `elastic_after` are
/// those of pressure and traction together, with $`A \sum \bar p\,\Delta u_z`$ and $`\tfrac A2 \sum p\,u_z`$ in addition;
/// what is dissipated is that of slip in both.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub struct EnergyBalance {
    /// Work of the tangential load (of dissimilar bodies also of the normal load, of a relative displacement also its own),
    /// mean force times change of the shift, and mean moment times that of the twist; of
    /// cells that come into contact, by the part of the motion that they follow.
    pub work: f64,
    /// Elastic energy of shear before the step; of dissimilar bodies that of pressure and traction.
    pub elastic_before: f64,
    /// Elastic energy of shear after the step; of dissimilar bodies that of pressure and traction.
    pub elastic_after: f64,
    /// Energy dissipated, by the tractions at the end of the step: $`-A \sum q_{n+1} s \ge 0`$. Under an
    /// unchanged pressure and a load that does not turn within the step, slip happens at the friction
    /// limit alone, and this is what it dissipates, however long the step.
    pub dissipated_energy: f64,
    /// Energy dissipated, by the mean tractions: $`-A \sum \bar q s`$, which closes the balance.
    /// Non-negative under an unchanged pressure and friction (in the plane but for the tolerance).
    pub dissipated_energy_midpoint: f64,
    /// Energy of the tractions that cells drop as they leave the contact, by mean tractions.
    pub released: f64,
    /// Work on the motion that the tolerance leaves in stick cells.
    pub residual: f64,
}

impl EnergyBalance {
    /// What the pressure does in a step, from before to after, each with its gap before loading; of cells that lie so.
    /// `place` is where the particle of a cell was before the step: particles from beyond the grid had no pressure.
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

    /// With that of other cells.
    pub(super) fn plus(&self, other: &Self) -> Self {
        Self {
            work: self.work + other.work,
            elastic_before: self.elastic_before + other.elastic_before,
            elastic_after: self.elastic_after + other.elastic_after,
            dissipated_energy: self.dissipated_energy + other.dissipated_energy,
            dissipated_energy_midpoint: self.dissipated_energy_midpoint
                + other.dissipated_energy_midpoint,
            released: self.released + other.released,
            residual: self.residual + other.residual,
        }
    }

    /// Goes on by the step that followed.
    pub(super) fn extend(&mut self, next: &Self) {
        self.work += next.work;
        self.elastic_after = next.elastic_after;
        self.dissipated_energy += next.dissipated_energy;
        self.dissipated_energy_midpoint += next.dissipated_energy_midpoint;
        self.released += next.released;
        self.residual += next.residual;
    }

    /// What is missing in the balance: round-off.
    #[must_use]
    pub fn imbalance(&self) -> f64 {
        let lost = self.dissipated_energy_midpoint + self.released + self.residual;
        self.work - (self.elastic_after - self.elastic_before) - lost
    }
}

impl WireFormat for EnergyBalance {
    const COUNT: usize = <[f64; 7]>::COUNT;
    const ZERO: Self = Self {
        work: 0.0,
        elastic_before: 0.0,
        elastic_after: 0.0,
        dissipated_energy: 0.0,
        dissipated_energy_midpoint: 0.0,
        released: 0.0,
        residual: 0.0,
    };

    fn write(self, words: &mut Vec<u64>) {
        let energies = [
            self.work,
            self.elastic_before,
            self.elastic_after,
            self.dissipated_energy,
            self.dissipated_energy_midpoint,
            self.released,
            self.residual,
        ];
        energies.write(words);
    }

    fn read(words: &mut &[u64]) -> Self {
        let [
            work,
            elastic_before,
            elastic_after,
            dissipated_energy,
            dissipated_energy_midpoint,
            released,
            residual,
        ] = WireFormat::read(words);
        Self {
            work,
            elastic_before,
            elastic_after,
            dissipated_energy,
            dissipated_energy_midpoint,
            released,
            residual,
        }
    }
}
