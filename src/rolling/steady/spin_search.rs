//! The search for the spin of a moment.

/// Position of the search for a spin, and the deficit of the moment at this spin.
#[derive(Debug, Clone, Copy)]
struct SearchPoint {
    at: f64,
    missing: f64,
}

/// Search by inverse quadratic interpolation between bounds, or by bisection if interpolation is not safe (T. R. Chandrupatla,
/// Advances in Engineering Software 28 (1997) 145, <https://doi.org/10.1016/S0965-9978(96)00051-8>).
///
/// The moment does not always increase with the spin. The limits of the moment for spins of plus and minus infinity are known.
/// The search starts with one of these limits as a bound, and the moment always crosses its target between the bounds. The
/// positions are $`v = \varphi/(s + |\varphi|)`$, from minus one to one. Here s is a spin at which most of the contact slides.
#[derive(Debug)]
pub(in crate::rolling) struct SpinSearch {
    scale: f64,
    /// Deficits of the moments at the two ends.
    ends: [f64; 2],
    latest: Option<SearchPoint>,
    /// Last point at which the deficit has the opposite sign.
    opposite: SearchPoint,
    before: Option<SearchPoint>,
}

impl SpinSearch {
    /// Creates a search from the deficits of the moment at both ends, which have different signs.
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

    /// Returns the next spin after a spin with the deficit `missing`. Returns `None` if the spins between the bounds differ
    /// only by round-off.
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

    /// Returns the fraction of the interval to the opposite bound.
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
