//! Lengths with fast transforms.

/// Returns the number of cells of the torus. Along a free axis, no periodic image overlaps the cells.
pub(super) fn torus(size: [usize; 2], repeats: [bool; 2]) -> [usize; 2] {
    std::array::from_fn(|axis| match (size[axis], repeats[axis]) {
        (cells, true) => cells,
        (cells, false) => smooth_length(2 * cells - 1),
    })
}

/// Returns the even length `2^a 3^b 5^c >= least` with the cheapest transform (1 for `least <= 1`).
///
/// The result never decreases when `least` increases. The cheapest length for a smaller `least` remains the cheapest while
/// it is sufficient.
pub(crate) fn smooth_length(least: usize) -> usize {
    if least <= 1 {
        return 1;
    }
    let most = 2 * least;
    // Every octave contains a power of two.
    let mut cheapest = (f64::INFINITY, most);
    let mut fives = 1_usize;
    while fives <= most {
        let mut odd = fives;
        while odd <= most {
            let mut even = odd;
            while even <= most / 2 {
                even *= 2;
                if even >= least && (cost(even), even) < cheapest {
                    cheapest = (cost(even), even);
                }
            }
            odd = odd.saturating_mul(3);
        }
        fives = fives.saturating_mul(5);
    }
    cheapest.1
}

/// Returns `n log n`, multiplied by measured penalties for factors of five and for a lack of factors of two. The length
/// must have no prime factors except 2, 3, 5.
fn cost(n: usize) -> f64 {
    let (mut fives, mut rest) = (0, n);
    while rest % 5 == 0 {
        (fives, rest) = (fives + 1, rest / 5);
    }
    let for_twos = match n.trailing_zeros() {
        1 => 1.25,
        2 => 1.1,
        _ => 1.0,
    };
    let for_fives = [1.0, 1.05, 1.15].get(fives).unwrap_or(&1.7);
    let n = n as f64;
    n * n.log2() * for_twos * for_fives
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Checks that the length never decreases. Coarser grids and windows use the samples of the whole grid, so the torus
    /// of a smaller grid must not be longer than the torus of a larger grid.
    #[test]
    fn lengths_suffice_and_grow_with_what_is_asked() {
        let mut last = 1;
        for least in 1..5000 {
            let length = smooth_length(least);
            assert!(
                length >= least && length >= last,
                "{least}: {length} after {last}"
            );
            last = length;
        }
        assert_eq!(
            smooth_length(747),
            768,
            "not 750, which costs as much as 1024"
        );
    }

    #[test]
    fn smooth_length_is_the_cheapest_of_all_even_smooth_lengths() {
        let is_smooth = |n: &usize| {
            let strip = |n: usize, prime: usize| {
                std::iter::successors(Some(n), |n| (n % prime == 0).then(|| n / prime)).last()
            };
            let rest = [2, 3, 5].into_iter().try_fold(*n, strip);
            n % 2 == 0 && rest == Some(1)
        };
        for least in 2..1000 {
            let all = (least..=2 * least).filter(is_smooth);
            let cheapest = all.min_by(|a, b| cost(*a).total_cmp(&cost(*b)));
            assert_eq!(Some(smooth_length(least)), cheapest);
        }
    }

    #[test]
    fn smooth_length_of_two_to_the_forty_is_itself() {
        assert_eq!(smooth_length(1 << 40), 1 << 40);
    }
}
