//! What was made for rectangles of other sizes than the present one, for a while.

/// Uses after which a size that none of them asked for is given up.
const PATIENCE: u64 = 256;

/// Things made for sizes that were left for smaller ones, and those of smaller sizes that were left since: what goes to
/// and fro between sizes finds them again. When a size comes that is larger than all before, the others are dropped.
///
/// A clone has none of them.
#[derive(Debug)]
pub(crate) struct Kept<T> {
    /// The one that was left last comes last.
    things: Vec<Thing<T>>,
    /// Cells of the largest size since there was last none here.
    largest: usize,
    uses: u64,
}

#[derive(Debug)]
struct Thing<T> {
    size: [usize; 2],
    made: T,
    /// Count of uses when it was left.
    left: u64,
}

impl<T> Thing<T> {
    fn cells(&self) -> usize {
        cells(self.size)
    }
}

impl<T> Default for Kept<T> {
    fn default() -> Self {
        Self {
            things: Vec::new(),
            largest: 0,
            uses: 0,
        }
    }
}

impl<T> Clone for Kept<T> {
    fn clone(&self) -> Self {
        Self::default()
    }
}

impl<T> Kept<T> {
    /// Counts a use of the present size, and gives up what was not asked for in a long time.
    pub(crate) fn age(&mut self) {
        self.uses += 1;
        let uses = self.uses;
        self.things.retain(|thing| uses - thing.left <= PATIENCE);
        if self.things.is_empty() {
            self.largest = 0;
        }
    }

    /// What was made for a size, if it is here.
    pub(crate) fn take(&mut self, size: [usize; 2]) -> Option<T> {
        let place = self.things.iter().position(|thing| thing.size == size)?;
        Some(self.things.remove(place).made)
    }

    /// Keeps what was made for a size that is left for another.
    pub(crate) fn leave(&mut self, size: [usize; 2], made: T, next: [usize; 2]) {
        let left = self.uses;
        self.things.push(Thing { size, made, left });
        self.largest = self.largest.max(cells(size));
        if cells(next) > self.largest {
            self.largest = cells(next);
            self.things.clear();
        }
        // What waits is to take no more than twice the largest.
        let mut waiting: usize = self.things.iter().map(Thing::cells).sum();
        while waiting > 2 * self.largest {
            waiting -= self.things.remove(0).cells();
        }
    }
}

fn cells([nx, ny]: [usize; 2]) -> usize {
    nx * ny
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Leaves the first of the sizes for the next, and so on; tells which were found.
    fn found(kept: &mut Kept<usize>, sides: &[usize]) -> Vec<bool> {
        let step = |step: &[usize]| {
            let found = kept.take([step[1]; 2]);
            kept.leave([step[0]; 2], step[0], [step[1]; 2]);
            found.is_some()
        };
        sides.windows(2).map(step).collect()
    }

    #[test]
    fn sizes_to_and_fro_are_found_again() {
        let mut kept = Kept::default();
        assert_eq!(
            found(&mut kept, &[9, 4, 9, 4, 9]),
            [false, true, true, true]
        );
    }

    #[test]
    fn a_size_larger_than_all_before_outgrows_them() {
        let mut kept = Kept::default();
        assert_eq!(
            found(&mut kept, &[4, 5, 6, 5, 6, 7, 6]),
            [false, false, false, true, false, false]
        );
        assert_eq!(kept.things.len(), 1);
    }

    #[test]
    fn what_waits_takes_no_more_than_twice_the_largest() {
        let mut kept = Kept::default();
        found(&mut kept, &[20, 19, 18, 17, 16, 15]);
        let sides: Vec<_> = kept.things.iter().map(|thing| thing.made).collect();
        assert_eq!(sides, [17, 16]);
    }

    #[test]
    fn what_nobody_asks_for_is_given_up() {
        let mut kept = Kept::default();
        found(&mut kept, &[9, 4]);
        for _ in 0..PATIENCE {
            kept.age();
            assert_eq!(kept.things.len(), 1);
        }
        kept.age();
        assert!(kept.things.is_empty());
    }
}
