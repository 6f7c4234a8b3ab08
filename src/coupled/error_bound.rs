//! Error of the whole coupled solution from the errors of its halves. The error is a bound for weak friction and an
//! estimate otherwise.

use crate::cgm::cone::ConeMeasures;
use crate::coupled::ErrorEstimate;

/// Sensitivities of the normal and the tangential half of a coupled problem to each other.
///
/// Let $`P(q)`$ be the pressure for given tractions $`q`$. Let $`Q(p)`$ be the tractions for a given pressure $`p`$
/// under a given shift. Define $`\kappa = |C_{zz}^{-1/2} B\, C_{tt}^{-1/2}|`$ and
/// $`c^2 = \lambda_{max}(C_{tt}) / \lambda_{min}(C_{zz})`$. In the energy norms of $`C_{zz}`$ and $`C_{tt}`$, the
/// variational inequalities of the halves give
///
/// ```math
/// |P(q_1) - P(q_2)| \le \kappa\,|q_1 - q_2|, \qquad |Q(p_1) - Q(p_2)| \le L\,|p_1 - p_2|, \qquad
/// L = \tfrac12 \left(b + \sqrt{b^2 + 4 \kappa \mu c}\right), \quad b = \kappa + \mu c .
/// ```
///
/// If $`\kappa L < 1`$, there is exactly one solution. With the error bounds $`\epsilon_N`$ and $`\epsilon_T`$ of the
/// halves,
///
/// ```math
/// |p - p^*| \le \frac{\epsilon_N + \kappa\,\epsilon_T}{1 - \kappa L}, \qquad
/// |q - q^*| \le \frac{\epsilon_T + L\,\epsilon_N}{1 - \kappa L} .
/// ```
#[derive(Debug, Clone, Copy)]
pub(super) struct Contraction {
    /// Coupling $`\kappa`$.
    pub(super) coupling: f64,
    /// Ratio $`c`$.
    pub(super) spread: f64,
    /// Absolute value of Dundurs' beta. For coated bodies it is the value of the most strongly coupled waves.
    pub(super) beta: f64,
}

/// Measured sensitivity of the pressure to the tractions, divided by beta.
const TYPICAL: f64 = 0.7;

impl Contraction {
    /// Returns bounds on the errors of pressure and traction for this friction, or `None` if $`\kappa L \ge 1`$.
    pub(super) fn bounds(self, friction: f64, findings: &ConeMeasures) -> Option<[f64; 2]> {
        let Self {
            coupling, spread, ..
        } = self;
        let both = coupling + friction * spread;
        let slope = 0.5 * (both + (both * both + 4.0 * coupling * friction * spread).sqrt());
        whole(findings.bounds, coupling, slope)
    }

    /// Estimates the errors with the sensitivities 0.7 beta for $`P`$ and 0.7 beta + mu for $`Q`$. No measured contact
    /// exceeded these sensitivities. Unlike the bounds, these sensitivities do not depend on the cells.
    pub(super) fn estimate(self, friction: f64, findings: &ConeMeasures) -> Option<ErrorEstimate> {
        let coupling = TYPICAL * self.beta;
        let [pressure, traction] = whole(findings.bounds, coupling, coupling + friction)?;
        Some(ErrorEstimate { pressure, traction })
    }
}

/// Computes the errors of pressure and traction from the errors of the halves and their sensitivities to each other.
fn whole([normal, tangential]: [f64; 2], coupling: f64, slope: f64) -> Option<[f64; 2]> {
    let rest = 1.0 - coupling * slope;
    let errors = [normal + coupling * tangential, tangential + slope * normal];
    (rest > 0.0).then(|| errors.map(|error| error / rest))
}
