//! What was made for rectangles of other sizes than the present one, for a while.

/// Uses after which a size that none of them asked for is given up.
const PATIENCE: u64 = 256;

/// What is made for rectangles of one size.
pub(crate) trait OfSize {
    /// Cells along x and along y.
    fn size(&self) -> [usize; 2];

    fn cells(&self) -> usize {
        self.size().iter().product()
    }
}

/// Things made for sizes that were left for smaller ones, and those of smaller sizes that were left since: what goes to
/// and fro between sizes finds them again. When a size comes that is larger than all before, the others are dropped.
///
/// A clone has none of them.
#[derive(Debug)]
pub(crate) struct LeftBehind<T> {
    /// The one that was left last comes last.
    entries: Vec<Entry<T>>,
    /// Cells of the largest size since there was last none here.
    largest: usize,
    uses: u64,
}

#[derive(Debug)]
struct Entry<T> {
    made: T,
    /// Count of uses when it was left.
    left: u64,
}

impl<T> Default for LeftBehind<T> {
    fn default() -> Self {
        Self {
            entries: Vec::new(),
            largest: 0,
            uses: 0,
        }
    }
}

impl<T> Clone for LeftBehind<T> {
    fn clone(&self) -> Self {
        Self::default()
    }
}

impl<T: OfSize> LeftBehind<T> {
    /// Counts a use of the present size, and gives up what was not asked for in a long time.
    pub(crate) fn age(&mut self) {
        self.uses += 1;
        let uses = self.uses;
        self.entries.retain(|entry| uses - entry.left <= PATIENCE);
        if self.entries.is_empty() {
            self.largest = 0;
        }
    }

    /// Makes the present one fit a size, or puts one in its place that does, found here or made; the old one then stays
    /// here.
    ///
    /// # Errors
    /// Those of `make`; nothing has changed then.
    pub(crate) fn replace<E>(
        &mut self,
        present: &mut T,
        size: [usize; 2],
        make: impl FnOnce() -> Result<T, E>,
    ) -> Result<(), E> {
        if present.size() != size {
            let next = self.find_or(size, make)?;
            self.leave(std::mem::replace(present, next), size);
        }
        Ok(())
    }

    /// The same where there may be none at present.
    ///
    /// # Errors
    /// As [`Self::replace`].
    pub(crate) fn provide<'a, E>(
        &mut self,
        present: &'a mut Option<T>,
        size: [usize; 2],
        make: impl FnOnce() -> Result<T, E>,
    ) -> Result<&'a mut T, E> {
        match present {
            Some(present) => self.replace(present, size, make).map(|()| present),
            none => Ok(none.insert(self.find_or(size, make)?)),
        }
    }

    fn find_or<E>(
        &mut self,
        size: [usize; 2],
        make: impl FnOnce() -> Result<T, E>,
    ) -> Result<T, E> {
        let place = self
            .entries
            .iter()
            .position(|entry| entry.made.size() == size);
        place.map_or_else(make, |place| Ok(self.entries.remove(place).made))
    }

    /// Keeps what is left for another size.
    fn leave(&mut self, made: T, next: [usize; 2]) {
        let left = self.uses;
        self.largest = self.largest.max(made.cells());
        self.entries.push(Entry { made, left });
        let next = next.iter().product();
        if next > self.largest {
            self.largest = next;
            self.entries.clear();
        }
        // What waits is to take no more than twice the largest.
        let mut waiting: usize = self.entries.iter().map(|entry| entry.made.cells()).sum();
        while waiting > 2 * self.largest {
            waiting -= self.entries.remove(0).made.cells();
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A square of so many cells along a side.
    #[derive(Debug)]
    struct Square(usize);

    impl OfSize for Square {
        fn size(&self) -> [usize; 2] {
            [self.0; 2]
        }
    }

    /// Goes from the first of the sizes to the next, and so on; tells which were found.
    fn found(left_behind: &mut LeftBehind<Square>, sides: &[usize]) -> Vec<bool> {
        let (mut present, mut found) = (None, Vec::new());
        for &side in sides {
            let mut is_found = true;
            let make = || {
                is_found = false;
                Ok::<_, ()>(Square(side))
            };
            let fitting = left_behind.provide(&mut present, [side; 2], make);
            assert_eq!(fitting.unwrap().size(), [side; 2]);
            found.push(is_found);
        }
        found
    }

    #[test]
    fn sizes_to_and_fro_are_found_again() {
        let mut left_behind = LeftBehind::default();
        assert_eq!(
            found(&mut left_behind, &[9, 4, 9, 4, 4, 9]),
            [false, false, true, true, true, true]
        );
    }

    #[test]
    fn a_size_larger_than_all_before_outgrows_them() {
        let mut left_behind = LeftBehind::default();
        assert_eq!(
            found(&mut left_behind, &[4, 5, 6, 5, 6, 7, 6]),
            [false, false, false, false, true, false, false]
        );
        assert_eq!(left_behind.entries.len(), 1);
    }

    #[test]
    fn what_waits_takes_no_more_than_twice_the_largest() {
        let mut left_behind = LeftBehind::default();
        found(&mut left_behind, &[20, 19, 18, 17, 16, 15]);
        let sides: Vec<_> = left_behind
            .entries
            .iter()
            .map(|entry| entry.made.0)
            .collect();
        assert_eq!(sides, [17, 16]);
    }

    #[test]
    fn what_nobody_asks_for_is_given_up() {
        let mut left_behind = LeftBehind::default();
        found(&mut left_behind, &[9, 4]);
        for _ in 0..PATIENCE {
            left_behind.age();
            assert_eq!(left_behind.entries.len(), 1);
        }
        left_behind.age();
        assert!(left_behind.entries.is_empty());
    }

    #[test]
    fn what_cannot_be_made_changes_nothing() {
        let (mut left_behind, mut present) = (LeftBehind::default(), Some(Square(4)));
        let refused = left_behind.provide(&mut present, [5; 2], || Err("no memory"));
        assert!(refused.is_err() && left_behind.entries.is_empty());
        assert_eq!(present.map(|square| square.0), Some(4));
    }
}
