//! The search for the spin of a moment.

/// A position of the search, and the moment that its spin lacks.
#[derive(Debug, Clone, Copy)]
struct SearchPoint {
    at: f64,
    missing: f64,
}

/// Inverse quadratic interpolation between bounds, or bisection where it is not safe (T. R. Chandrupatla, Advances in
/// Engineering Software 28 (1997) 145, <https://doi.org/10.1016/S0965-9978(96)00051-8>).
///
/// The moment need not rise with the spin. It is known for spins without limit: the search begins with one end of all
/// spins, and the moment always crosses its target between two points. The positions are $`v = \varphi/(s + |\varphi|)`$, from
/// minus one to one, with a spin s at which the contact slides in large part.
#[derive(Debug)]
pub(in crate::rolling) struct SpinSearch {
    scale: f64,
    /// The deficits of the moments at the two ends.
    ends: [f64; 2],
    latest: Option<SearchPoint>,
    /// The last point on the other side of the moment.
    opposite: SearchPoint,
    before: Option<SearchPoint>,
}

impl SpinSearch {
    /// A search of which the spins at the ends lack so much of the moment, with different signs.
    pub(in crate::rolling) fn new(scale: f64, ends: [f64; 2]) -> Self {
        let [low, _] = ends;
        Self {
            scale,
            ends,
            latest: None,
            opposite: SearchPoint {
                at: -1.0,
                missing: low,
            },
            before: None,
        }
    }

    /// Returns the spin to try after one that lacks so much of the moment; `None` if spins between the bounds differ by
    /// round-off alone.
    pub(in crate::rolling) fn next(&mut self, spin: f64, missing: f64) -> Option<f64> {
        let point = SearchPoint {
            at: spin / (self.scale + spin.abs()),
            missing,
        };
        let is_like = |other: f64| (other > 0.0) == (missing > 0.0);
        match self.latest {
            None => {
                let [low, high] = self.ends;
                self.opposite = if is_like(low) {
                    SearchPoint {
                        at: 1.0,
                        missing: high,
                    }
                } else {
                    SearchPoint {
                        at: -1.0,
                        missing: low,
                    }
                };
            }
            Some(latest) if is_like(latest.missing) => self.before = Some(latest),
            Some(latest) => {
                self.before = Some(self.opposite);
                self.opposite = latest;
            }
        }
        self.latest = Some(point);
        let at = point.at + self.part(point) * (self.opposite.at - point.at);
        let next = self.scale * at / (1.0 - at.abs());
        let [low, high] = [
            point.at.min(self.opposite.at),
            point.at.max(self.opposite.at),
        ];
        (low < at && at < high && next.is_finite()).then_some(next)
    }

    /// Returns the part of the way to the opposite bound.
    fn part(&self, latest: SearchPoint) -> f64 {
        let [a, b] = [latest.at, self.opposite.at];
        let [fa, fb] = [latest.missing, self.opposite.missing];
        match self.before {
            None => fa / (fa - fb),
            Some(SearchPoint { at: c, missing: fc }) => {
                let (place, value) = ((a - b) / (c - b), (fa - fb) / (fc - fb));
                if value * value < place && (1.0 - value).powi(2) < 1.0 - place {
                    fa / (fb - fa) * fc / (fb - fc)
                        + (c - a) / (b - a) * fa / (fc - fa) * fb / (fc - fb)
                } else {
                    0.5
                }
            }
        }
    }
}
