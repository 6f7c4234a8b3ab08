//! Where the halves bound the whole: weak friction.

use crate::cgm::cone::ConeFindings;

/// How the halves of a contact depend on one another.
///
/// Let $`P(q)`$ be the pressure that belongs to tractions $`q`$ and $`Q(p)`$ the tractions that belong to a pressure $`p`$ under
/// a given shift. In the energy norms of $`C_{zz}`$ and $`C_{tt}`$, with $`\kappa = |C_{zz}^{-1/2} B\, C_{tt}^{-1/2}|`$ and
/// $`c^2 = \lambda_{max}(C_{tt}) / \lambda_{min}(C_{zz})`$, the variational inequalities of the halves give
///
/// ```math
/// |P(q_1) - P(q_2)| \le \kappa\,|q_1 - q_2|, \qquad |Q(p_1) - Q(p_2)| \le L\,|p_1 - p_2|, \qquad
/// L = \tfrac12 \left(b + \sqrt{b^2 + 4 \kappa \mu c}\right), \quad b = \kappa + \mu c .
/// ```
///
/// If $`\kappa L < 1`$ there is one solution, and with the bounds $`\epsilon_N`$ and $`\epsilon_T`$ of the halves
///
/// ```math
/// |p - p^*| \le \frac{\epsilon_N + \kappa\,\epsilon_T}{1 - \kappa L}, \qquad
/// |q - q^*| \le \frac{\epsilon_T + L\,\epsilon_N}{1 - \kappa L} .
/// ```
#[derive(Debug, Clone, Copy)]
pub(super) struct Contraction {
    /// $`\kappa`$.
    pub(super) coupling: f64,
    /// $`c`$.
    pub(super) spread: f64,
}

impl Contraction {
    /// Bounds of pressure and traction at this friction; `None` where the halves bound nothing.
    pub(super) fn bounds(self, friction: f64, findings: &ConeFindings) -> Option<[f64; 2]> {
        let Self { coupling, spread } = self;
        let both = coupling + friction * spread;
        let slope = 0.5 * (both + (both * both + 4.0 * coupling * friction * spread).sqrt());
        let rest = 1.0 - coupling * slope;
        let [normal, tangential] = findings.bounds;
        let bounds = [normal + coupling * tangential, tangential + slope * normal];
        (rest > 0.0).then(|| bounds.map(|bound| bound / rest))
    }
}
