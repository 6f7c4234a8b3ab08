//! Partial slip of a sphere under a varying tangential force.

use super::cattaneo_mindlin::CattaneoMindlin;
use super::held_force::HeldForce;
use super::hertz::HertzSphere;
use crate::error::Result;

/// A sphere in partial slip under a constant normal load and a tangential force along x with any history.
///
/// From zero to $`F_1`$ the solution is [`CattaneoMindlin`]. When the force reverses at $`F_1`$, reverse slip spreads from
/// the edge. It adds twice the solution for half the change of force. Every later reversal adds a further term of this form:
///
/// ```math
/// q = q^{CM}(F_1) + 2\,q^{CM}\!\left(\tfrac{F_2-F_1}{2}\right) + \dots +
/// 2\,q^{CM}\!\left(\tfrac{F-F_n}{2}\right), \qquad
/// \delta_x = \delta_x^{CM}(F_1) + \dots + 2\,\delta_x^{CM}\!\left(\tfrac{F-F_n}{2}\right)
/// ```
///
/// Displacement and slip are superposed in the same way. When the force returns to an earlier reversal, it closes a loop. The
/// contact then continues as if that loop had not occurred. When the force reaches its greatest magnitude so far, the contact
/// continues along the first loading. The solution belongs to the scalar model, with traction along x only. It is valid for every
/// $`\nu`$. Mindlin and Deresiewicz (1953); Jaeger (1998); Johnson (1985), 7.52-7.57.
///
/// ```
/// use stickslip::analytical::{CattaneoMindlin, HertzSphere, MindlinDeresiewicz};
/// use stickslip::{ElasticPair, Material};
/// // Table 2 of the paper, in mm, N and MPa: 20 N and back to zero.
/// let steel = Material::new(213e3, 0.29)?;
/// let ball = HertzSphere::new(&ElasticPair::new(steel, steel)?, 3.5, 100.0)?;
/// let unloaded = MindlinDeresiewicz::new(ball, 0.5, &[20.0, 0.0])?;
/// // A shift and a traction remain; the traction is reversed near the edge.
/// assert!((unloaded.shift() - 3.60263e-5).abs() < 1e-10);
/// assert!(unloaded.traction(0.0) > 0.0 && unloaded.traction(0.13) < 0.0);
/// // Two cycles dissipate twice the energy of one.
/// let cycled = MindlinDeresiewicz::new(ball, 0.5, &[20.0, -20.0, 20.0, -20.0, 20.0])?;
/// let first = CattaneoMindlin::new(ball, 0.5, 20.0)?.energy_of_first_quarter();
/// let expected = first + 2.0 * cycled.energy_per_cycle();
/// assert!((cycled.dissipated_energy() / expected - 1.0).abs() < 1e-14);
/// # Ok::<(), stickslip::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct MindlinDeresiewicz {
    force: f64,
    /// First loading, up to the force of the greatest magnitude.
    first: CattaneoMindlin,
    /// Solutions for half the change of force, one for each later reversal that no closed loop has erased.
    turns: Vec<CattaneoMindlin>,
    /// Energy dissipated in the closed loops.
    closed_energy: f64,
}

impl MindlinDeresiewicz {
    /// Creates the contact `hertz` with the coefficient of friction `friction`, under a tangential force on body 1 along x.
    /// The force starts at zero and passes through the values of `path` in sequence (forces, of either sign). An empty path
    /// means zero force.
    ///
    /// Between two values the force changes monotonically. The solution does not depend on the rate or the number of steps.
    /// A force equal to $`\mu W`$ to within rounding counts as the onset of gross sliding. The coupling between pressure and
    /// traction of dissimilar bodies is neglected.
    ///
    /// # Errors
    /// - [`Error::NegativeOrNotFinite`](crate::Error::NegativeOrNotFinite) if the coefficient of friction is negative or not
    ///   finite.
    /// - [`Error::NotFinite`](crate::Error::NotFinite) if a force or a result is not finite.
    /// - [`Error::BeyondFrictionCapacity`](crate::Error::BeyondFrictionCapacity) if a force exceeds $`\mu W`$.
    pub fn new(hertz: HertzSphere, friction: f64, path: &[f64]) -> Result<Self> {
        for &force in path {
            HeldForce::new(hertz.load(), friction, force)?;
        }
        let loading = |force| CattaneoMindlin::new(hertz, friction, force);
        let mut peaks = Vec::new();
        let mut closed_energy = 0.0;
        for &force in path {
            for closed in pass(&mut peaks, force) {
                closed_energy +=
                    closed.times * loading(closed.half_range)?.energy_of_first_quarter();
            }
        }
        let changes = peaks.windows(2).map(|ends| half_range(ends[0], ends[1]));
        Ok(Self {
            force: peaks.last().copied().unwrap_or(0.0),
            first: loading(peaks.first().copied().unwrap_or(0.0))?,
            turns: changes.map(loading).collect::<Result<_>>()?,
            closed_energy,
        })
    }

    /// Returns the normal contact.
    #[must_use]
    pub fn hertz(&self) -> HertzSphere {
        self.first.hertz()
    }

    /// Returns the tangential force $`F`$ on body 1 at the end of the path, positive along +x.
    #[must_use]
    pub fn force(&self) -> f64 {
        self.force
    }

    /// Returns the largest magnitude $`F_0`$ of the force so far.
    #[must_use]
    pub fn amplitude(&self) -> f64 {
        self.first.force().abs()
    }

    /// Returns the radius of the disc that has not slipped since the last reversal of the force (a length).
    ///
    /// The radius is $`a(1-|F|/\mu W)^{1/3}`$ during the first loading and $`a(1-|F-F_n|/2\mu W)^{1/3}`$ after a
    /// reversal at $`F_n`$. The ring around it slips, opposite to the traction. Johnson (1985), 7.52.
    #[must_use]
    pub fn stick_radius(&self) -> f64 {
        self.turns.last().unwrap_or(&self.first).stick_radius()
    }

    /// Returns the shift $`\delta_x`$ (a length): the rigid motion of body 2 relative to body 1, measured from the
    /// state before the first loading. The formula is given on the [type](Self); Johnson (1985), 7.54.
    #[must_use]
    pub fn shift(&self) -> f64 {
        self.superposed(CattaneoMindlin::shift)
    }

    /// Returns the shift $`\delta_0`$ at which the whole contact starts to slide in the first loading (a length,
    /// positive).
    #[must_use]
    pub fn sliding_shift(&self) -> f64 {
        self.first.sliding_shift()
    }

    /// Returns the traction $`q`$ on body 1 along x (a pressure) at the distance $`r`$ from the centre. It is zero outside the
    /// contact. The formula is given on the [type](Self); Johnson (1985), 7.53.
    #[must_use]
    pub fn traction(&self, r: f64) -> f64 {
        self.superposed(|part| part.traction(r))
    }

    /// Returns the tangential displacement $`u_x = u_{x1}-u_{x2}`$ (a length), anywhere in the plane: the same
    /// superposition of [`CattaneoMindlin::displacement`] as for the traction.
    #[must_use]
    pub fn displacement(&self, x: f64, y: f64) -> f64 {
        self.superposed(|part| part.displacement(x, y))
    }

    /// Returns the slip $`s_x = u_x - \delta_x`$ in the contact (a length), measured from the state before the first loading. It
    /// is the motion of the surface of body 1 over the surface of body 2. The slip is zero elsewhere, and where the surfaces have
    /// never slipped.
    #[must_use]
    pub fn slip(&self, x: f64, y: f64) -> f64 {
        self.superposed(|part| part.slip(x, y))
    }

    /// Returns the energy dissipated along the whole path (a force times a length), zero or positive.
    ///
    /// The first loading contributes [`CattaneoMindlin::energy_of_first_quarter`]. Every later path between two reversals
    /// contributes twice this energy for half the change of force.
    #[must_use]
    pub fn dissipated_energy(&self) -> f64 {
        self.closed_energy + self.superposed(CattaneoMindlin::energy_of_first_quarter)
    }

    /// Returns the energy dissipated in a full cycle of the force between $`\pm F_0`$ (a force times a length). $`F_0`$ is the
    /// [`amplitude`](Self::amplitude).
    ///
    /// ```math
    /// \frac45\mu W\delta_0\left(1-\frac ca\right)^3\left(1+3\frac ca+\frac{c^2}{a^2}\right),
    /// \qquad \frac{c^3}{a^3} = 1-\frac{F_0}{\mu W}
    /// ```
    ///
    /// The formula is free of cancellation. For small forces the energy is $`\frac{4}{27}\mu W\delta_0 (F_0/\mu W)^3`$.
    /// Johnson (1985), 7.57.
    #[must_use]
    pub fn energy_per_cycle(&self) -> f64 {
        self.first.energy_per_cycle()
    }

    /// Returns the term of the first loading plus twice the term of each reversal.
    fn superposed(&self, part: impl Fn(&CattaneoMindlin) -> f64) -> f64 {
        let turned: f64 = self.turns.iter().map(&part).sum();
        part(&self.first) + 2.0 * turned
    }
}

/// A closed loop of the force.
struct Closed {
    /// Half the range of forces of the loop.
    half_range: f64,
    /// Ratio of the energy of the loop to the energy of a first loading to half the range.
    times: f64,
}

/// Advances the force from the last of its reversals, `peaks`. Removes the peaks that the force passes, and returns the
/// loops that it closes.
///
/// The first peak is the peak of the first loading. The later peaks are the ends of successively smaller swings.
fn pass(peaks: &mut Vec<f64>, force: f64) -> Vec<Closed> {
    let mut closed = Vec::new();
    while let Some(last) = peaks.pop() {
        // The first loading counts as the second half of a swing from the opposite force.
        let (from, times) = peaks.last().map_or((-last, 2.0), |&peak| (peak, 4.0));
        let goes_on = (force >= last && last >= from) || (force <= last && last <= from);
        let closes = (force - last).abs() >= (from - last).abs();
        if goes_on {
            continue;
        }
        if !closes {
            peaks.push(last);
            break;
        }
        closed.push(Closed {
            half_range: half_range(from, last),
            times,
        });
    }
    peaks.push(force);
    closed
}

/// Returns half the change from one force to another.
fn half_range(from: f64, to: f64) -> f64 {
    0.5 * to - 0.5 * from
}
