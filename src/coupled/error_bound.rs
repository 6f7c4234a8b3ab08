//! What the halves tell of the whole: a bound where friction is weak, an estimate elsewhere.

use crate::cgm::cone::ConeMeasures;
use crate::coupled::ErrorEstimate;

/// How the halves of a contact depend on one another.
///
/// Let $`P(q)`$ be the pressure that belongs to tractions $`q`$ and $`Q(p)`$ the tractions that belong to a pressure $`p`$ under
/// a given shift. In the energy norms of $`C_{zz}`$ and $`C_{tt}`$, with $`\kappa = |C_{zz}^{-1/2} B\, C_{tt}^{-1/2}|`$ and
/// $`c^2 = \lambda_{max}(C_{tt}) / \lambda_{min}(C_{zz})`$, the variational inequalities of the halves give
///
/// ```math
/// |P(q_1) - P(q_2)| \le \kappa\,|q_1 - q_2|, \qquad |Q(p_1) - Q(p_2)| \le L\,|p_1 - p_2|, \qquad
/// L = \tfrac12 \with_remaining_limits(b + \sqrt{b^2 + 4 \kappa \mu c}\right), \quad b = \kappa + \mu c .
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
    /// Dundurs' beta, without its sign; of coated bodies that of the waves that couple most.
    pub(super) beta: f64,
}

/// Measured slope of the pressure by the tractions, over beta.
const TYPICAL: f64 = 0.7;

impl Contraction {
    /// Bounds of pressure and traction at this friction; `None` where the halves bound nothing.
    pub(super) fn bounds(self, friction: f64, findings: &ConeMeasures) -> Option<[f64; 2]> {
        let Self {
            coupling, spread, ..
        } = self;
        let both = coupling + friction * spread;
        let slope = 0.5 * (both + (both * both + 4.0 * coupling * friction * spread).sqrt());
        whole(findings.bounds, coupling, slope)
    }

    /// The same by slopes that no measured contact had: 0.7 beta for $`P`$, and 0.7 beta + mu for $`Q`$. They do not depend
    /// on the cells, as the bounds of them do.
    pub(super) fn estimate(self, friction: f64, findings: &ConeMeasures) -> Option<ErrorEstimate> {
        let coupling = TYPICAL * self.beta;
        let [pressure, traction] = whole(findings.bounds, coupling, coupling + friction)?;
        Some(ErrorEstimate { pressure, traction })
    }
}

/// Errors of pressure and traction from those of the halves, where these depend on one another by these slopes.
fn whole([normal, tangential]: [f64; 2], coupling: f64, slope: f64) -> Option<[f64; 2]> {
    let rest = 1.0 - coupling * slope;
    let errors = [normal + coupling * tangential, tangential + slope * normal];
    (rest > 0.0).then(|| errors.map(|error| error / rest))
}
