//! Partial slip of a sphere under a tangential force that comes and goes.

use super::cattaneo_mindlin::CattaneoMindlin;
use super::held_force::HeldForce;
use super::hertz::HertzSphere;
use crate::error::Result;

/// A sphere in partial slip: a constant normal load, and a tangential force along x of any history.
///
/// From zero to $`F_1`$ all is as in [`CattaneoMindlin`]. When the force turns at $`F_1`$, slip the
/// other way spreads from the edge and adds twice what half the change of force would cause alone;
/// and so at every later turn:
///
/// ```math
/// q = q^{CM}(F_1) + 2\,q^{CM}\!\left(\tfrac{F_2-F_1}{2}\right) + \dots +
/// 2\,q^{CM}\!\left(\tfrac{F-F_n}{2}\right), \qquad
/// \delta_x = \delta_x^{CM}(F_1) + \dots + 2\,\delta_x^{CM}\!\left(\tfrac{F-F_n}{2}\right)
/// ```
///
/// with the displacement and the slip likewise. A force that comes back to where it turned before
/// closes a loop, and the contact goes on as though that loop had not been; a force that reaches its
/// greatest magnitude so far goes on along the first loading. The scalar model, with
/// traction along x only, for every $`\nu`$. Mindlin and Deresiewicz (1953); Jaeger (1998);
/// Johnson (1985), 7.52-7.57.
///
/// ```
/// use stickslip::analytical::{CattaneoMindlin, HertzSphere, MindlinDeresiewicz};
/// use stickslip::{ElasticPair, Material};
/// // Table 2 of the paper, in mm, N and MPa: 20 N and back to zero.
/// let steel = Material::new(213e3, 0.29)?;
/// let ball = HertzSphere::new(&ElasticPair::new(steel, steel)?, 3.5, 100.0)?;
/// let unloaded = MindlinDeresiewicz::new(ball, 0.5, &[20.0, 0.0])?;
/// // Shift and traction remain, turned over near the edge.
/// assert!((unloaded.shift() - 3.60263e-5).abs() < 1e-10);
/// assert!(unloaded.traction(0.0) > 0.0 && unloaded.traction(0.13) < 0.0);
/// // Two cycles dissipate twice what one does.
/// let cycled = MindlinDeresiewicz::new(ball, 0.5, &[20.0, -20.0, 20.0, -20.0, 20.0])?;
/// let first = CattaneoMindlin::new(ball, 0.5, 20.0)?.dissipated_energy();
/// let expected = first + 2.0 * cycled.energy_per_cycle();
/// assert!((cycled.dissipated_energy() / expected - 1.0).abs() < 1e-14);
/// # Ok::<(), stickslip::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct MindlinDeresiewicz {
    force: f64,
    /// The first loading, to the force of the greatest magnitude.
    first: CattaneoMindlin,
    /// Of every turn since that still matters, half the change of force.
    turns: Vec<CattaneoMindlin>,
    /// Energy of the loops that have closed.
    closed_energy: f64,
}

impl MindlinDeresiewicz {
    /// The contact `hertz`, with the coefficient of friction `friction`, under a tangential force
    /// on body 1 along x that has gone from zero to each value of `path` in turn (forces, of either
    /// sign); none are no force.
    ///
    /// Between two values the force changes monotonically; how fast, and in how many steps, does not
    /// matter. Where it equals $`\mu W`$ to within rounding it is at the onset of gross sliding. The
    /// coupling between pressure and shear of dissimilar bodies is neglected.
    ///
    /// # Errors
    /// [`Error::Negative`](crate::Error::Negative) for the friction, [`Error::NotFinite`](crate::Error::NotFinite) for a force or a result,
    /// [`Error::BeyondSliding`](crate::Error::BeyondSliding) if a force exceeds $`\mu W`$.
    pub fn new(hertz: HertzSphere, friction: f64, path: &[f64]) -> Result<Self> {
        for &force in path {
            HeldForce::new(hertz.load(), friction, force)?;
        }
        let loading = |force| CattaneoMindlin::new(hertz, friction, force);
        let mut peaks = Vec::new();
        let mut closed_energy = 0.0;
        for &force in path {
            for closed in pass(&mut peaks, force) {
                closed_energy += closed.times * loading(closed.half_range)?.dissipated_energy();
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

    /// The normal contact.
    #[must_use]
    pub fn hertz(&self) -> HertzSphere {
        self.first.hertz()
    }

    /// Tangential force $`F`$ on body 1 at the end of the path, positive along +x.
    #[must_use]
    pub fn force(&self) -> f64 {
        self.force
    }

    /// Largest magnitude $`F_0`$ of the force so far.
    #[must_use]
    pub fn amplitude(&self) -> f64 {
        self.first.force().abs()
    }

    /// Radius of the disc that has not slipped since the force last turned (a length).
    ///
    /// During the first loading $`a(1-|F|/\mu W)^{1/3}`$, after a turn at $`F_n`$
    /// $`a(1-|F-F_n|/2\mu W)^{1/3}`$: the ring around it slips, against the traction.
    /// Johnson (1985), 7.52.
    #[must_use]
    pub fn stick_radius(&self) -> f64 {
        self.turns.last().unwrap_or(&self.first).stick_radius()
    }

    /// Shift $`\delta_x`$ (a length): the rigid motion of body 2 relative to body 1 since before the
    /// first loading. Formula on the [type](Self); Johnson (1985), 7.54.
    #[must_use]
    pub fn shift(&self) -> f64 {
        self.superposed(CattaneoMindlin::shift)
    }

    /// Shift at which the whole contact begins to slide at the first loading, $`\delta_0`$ (a
    /// length, positive).
    #[must_use]
    pub fn sliding_shift(&self) -> f64 {
        self.first.sliding_shift()
    }

    /// Traction $`q`$ on body 1 along x (a pressure) at the distance $`r`$ from the centre; zero
    /// outside the contact. Formula on the [type](Self); Johnson (1985), 7.53.
    #[must_use]
    pub fn traction(&self, r: f64) -> f64 {
        self.superposed(|part| part.traction(r))
    }

    /// Tangential displacement $`u_x = u_{x1}-u_{x2}`$ (a length), anywhere in the plane: a sum as
    /// that of the traction, of [`CattaneoMindlin::displacement`].
    #[must_use]
    pub fn displacement(&self, x: f64, y: f64) -> f64 {
        self.superposed(|part| part.displacement(x, y))
    }

    /// Slip $`s_x = u_x - \delta_x`$ in the contact (a length): where the surface of body 1 has got
    /// to over that of body 2 since before the first loading; zero elsewhere, and where nothing
    /// has ever slipped.
    #[must_use]
    pub fn slip(&self, x: f64, y: f64) -> f64 {
        self.superposed(|part| part.slip(x, y))
    }

    /// Energy dissipated along the whole path (a force times a length), zero or positive.
    ///
    /// Twice [`CattaneoMindlin::dissipated_energy`] of half the change of force for every way from
    /// turn to turn, once that of the first loading.
    #[must_use]
    pub fn dissipated_energy(&self) -> f64 {
        self.closed_energy + self.superposed(CattaneoMindlin::dissipated_energy)
    }

    /// Energy that one full cycle of the force between $`\pm F_0`$ dissipates (a force times a
    /// length), the [`amplitude`](Self::amplitude) being $`F_0`$.
    ///
    /// ```math
    /// \frac45\mu W\delta_0\left(1-\frac ca\right)^3\left(1+3\frac ca+\frac{c^2}{a^2}\right),
    /// \qquad \frac{c^3}{a^3} = 1-\frac{F_0}{\mu W}
    /// ```
    ///
    /// where nothing cancels; $`\frac{4}{27}\mu W\delta_0 (F_0/\mu W)^3`$ for small forces.
    /// Johnson (1985), 7.57.
    #[must_use]
    pub fn energy_per_cycle(&self) -> f64 {
        4.0 * self.first.dissipated_energy()
    }

    /// The first loading, and twice each turn.
    fn superposed(&self, part: impl Fn(&CattaneoMindlin) -> f64) -> f64 {
        let turned: f64 = self.turns.iter().map(&part).sum();
        part(&self.first) + 2.0 * turned
    }
}

/// A loop that the force has closed.
struct Closed {
    /// Half of the range of forces it spans.
    half_range: f64,
    /// Its energy over that of a first loading to the half range.
    times: f64,
}

/// Moves the force on from the last of the `peaks` at which it turned, and drops those it passes.
///
/// The peaks are the first loading's and then ever smaller swings from it.
fn pass(peaks: &mut Vec<f64>, force: f64) -> Vec<Closed> {
    let mut closed = Vec::new();
    while let Some(last) = peaks.pop() {
        // The first loading is the second half of a swing from the other side.
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

/// Half the change from one force to another.
fn half_range(from: f64, to: f64) -> f64 {
    0.5 * to - 0.5 * from
}
