//! Lengths whose transform is fast.

/// Cells of the torus: along an axis that does not repeat, no image of `n` cells reaches back into them.
pub(super) fn torus(size: [usize; 2], repeats: [bool; 2]) -> [usize; 2] {
    std::array::from_fn(|axis| match (size[axis], repeats[axis]) {
        (cells, true) => cells,
        (cells, false) => smooth_length(2 * cells - 1),
    })
}

/// The even length `2^a 3^b 5^c >= least` whose transform costs least (1 for `least <= 1`).
///
/// It grows with `least`: a candidate that is best for less and long enough is best for more.
pub(crate) fn smooth_length(least: usize) -> usize {
    if least <= 1 {
        return 1;
    }
    // A power of two lies in every octave.
    let candidates = (least..=2 * least).filter_map(|n| cost(n).map(|cost| (n, cost)));
    let cheaper = |best: (usize, f64), other: (usize, f64)| {
        if other.1 < best.1 { other } else { best }
    };
    candidates.reduce(cheaper).map_or(2 * least, |(n, _)| n)
}

/// `n log n`, and what fives and a lack of twos add (measured); `None` for lengths not considered.
fn cost(n: usize) -> Option<f64> {
    let mut rest = n;
    let mut power = |prime: usize| {
        let mut power = 0;
        while rest % prime == 0 {
            rest /= prime;
            power += 1;
        }
        power
    };
    let (twos, _, fives) = (power(2), power(3), power(5));
    if rest > 1 || twos == 0 {
        return None;
    }
    let for_twos = [1.25, 1.1].get(twos - 1).unwrap_or(&1.0);
    let for_fives = [1.0, 1.05, 1.15].get(fives).unwrap_or(&1.7);
    let n = n as f64;
    Some(n * n.log2() * for_twos * for_fives)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Coarser grids and windows read the samples of the whole grid: a shorter torus must not reach
    /// further than a longer one.
    #[test]
    fn lengths_suffice_and_grow_with_what_is_asked() {
        let mut last = 1;
        for least in 1..5000 {
            let length = smooth_length(least);
            assert!(
                length >= least && length >= last,
                "{least}: {length} after {last}"
            );
            assert!(length == 1 || cost(length).is_some());
            last = length;
        }
        assert_eq!(
            smooth_length(747),
            768,
            "not 750, which costs as much as 1024"
        );
    }
}
