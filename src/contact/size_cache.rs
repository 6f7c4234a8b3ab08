//! Cache of objects for rectangles of different sizes.

/// Number of uses after which an object whose size was not requested is dropped.
const PATIENCE: u64 = 256;

/// An object for rectangles of one size.
pub(crate) trait HasSize {
    /// Returns the number of cells along x and along y.
    fn size(&self) -> [usize; 2];

    fn cells(&self) -> usize {
        self.size().iter().product()
    }
}

/// Cache of the object for the current size and of the objects for recently used sizes. A contact that alternates between
/// sizes reuses their objects. If a new size is larger than all earlier sizes, the other objects are dropped.
///
/// A clone contains only the current object.
#[derive(Debug)]
pub(crate) struct SizeCache<T> {
    /// Current object, or `None` before the first use.
    pub(crate) present: Option<T>,
    /// Retired objects in the order of their retirement.
    left: Vec<RetiredEntry<T>>,
    /// Number of cells of the largest size since the list of retired objects was last empty.
    largest: usize,
    uses: u64,
}

#[derive(Debug)]
struct RetiredEntry<T> {
    made: T,
    /// Count of uses when the object was retired.
    at: u64,
}

impl<T> Default for SizeCache<T> {
    fn default() -> Self {
        Self::of(None)
    }
}

impl<T: Clone> Clone for SizeCache<T> {
    fn clone(&self) -> Self {
        Self::of(self.present.clone())
    }
}

impl<T> SizeCache<T> {
    fn of(present: Option<T>) -> Self {
        Self {
            present,
            left: Vec::new(),
            largest: 0,
            uses: 0,
        }
    }
}

impl<T: HasSize> SizeCache<T> {
    /// Counts a use of the current size, and drops objects whose last use is more than [`PATIENCE`] uses ago.
    pub(crate) fn tick(&mut self) {
        self.uses += 1;
        let uses = self.uses;
        self.left.retain(|left| uses - left.at <= PATIENCE);
        if self.left.is_empty() {
            self.largest = 0;
        }
    }

    /// Makes the object for a size the current object. If the current object has a different size, it is retired to the
    /// cache. The new current object then comes from the cache or is created.
    ///
    /// # Errors
    /// The errors of `make`. The cache is then unchanged.
    pub(crate) fn get_or_create<E>(
        &mut self,
        size: [usize; 2],
        make: impl FnOnce() -> Result<T, E>,
    ) -> Result<&mut T, E> {
        let fits = |present: &mut T| present.size() == size;
        let next = if let Some(present) = self.present.take_if(fits) {
            present
        } else {
            let place = self.left.iter().position(|left| left.made.size() == size);
            let found = place.map(|place| self.left.remove(place).made);
            let next = found.map_or_else(make, Ok)?;
            if let Some(present) = self.present.take() {
                self.retire(present, size);
            }
            next
        };
        Ok(self.present.insert(next))
    }

    /// Retires an object when the size changes.
    fn retire(&mut self, made: T, next: [usize; 2]) {
        let at = self.uses;
        self.largest = self.largest.max(made.cells());
        self.left.push(RetiredEntry { made, at });
        let next = next.iter().product();
        if next > self.largest {
            self.largest = next;
            self.left.clear();
        }
        // Together, the retired objects may have at most twice as many cells as the largest size.
        let mut waiting: usize = self.left.iter().map(|left| left.made.cells()).sum();
        while waiting > 2 * self.largest {
            waiting -= self.left.remove(0).made.cells();
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A square with this number of cells along a side.
    #[derive(Debug)]
    struct WindowSide(usize);

    impl HasSize for WindowSide {
        fn size(&self) -> [usize; 2] {
            [self.0; 2]
        }
    }

    /// Switches through the sizes in turn and returns which of them were found in the cache.
    fn found(squares: &mut SizeCache<WindowSide>, sides: &[usize]) -> Vec<bool> {
        let mut found = Vec::new();
        for &side in sides {
            let mut is_found = true;
            let make = || {
                is_found = false;
                Ok::<_, ()>(WindowSide(side))
            };
            let fitting = squares.get_or_create([side; 2], make);
            assert_eq!(fitting.unwrap().size(), [side; 2]);
            found.push(is_found);
        }
        found
    }

    #[test]
    fn sizes_to_and_fro_are_found_again() {
        let mut squares = SizeCache::default();
        assert_eq!(
            found(&mut squares, &[9, 4, 9, 4, 4, 9]),
            [false, false, true, true, true, true]
        );
    }

    #[test]
    fn a_size_larger_than_all_before_outgrows_them() {
        let mut squares = SizeCache::default();
        assert_eq!(
            found(&mut squares, &[4, 5, 6, 5, 6, 7, 6]),
            [false, false, false, false, true, false, false]
        );
        assert_eq!(squares.left.len(), 1);
    }

    #[test]
    fn what_waits_takes_no_more_than_twice_the_largest() {
        let mut squares = SizeCache::default();
        found(&mut squares, &[20, 19, 18, 17, 16, 15]);
        let sides: Vec<_> = squares.left.iter().map(|left| left.made.0).collect();
        assert_eq!(sides, [17, 16]);
    }

    #[test]
    fn what_nobody_asks_for_is_given_up() {
        let mut squares = SizeCache::default();
        found(&mut squares, &[9, 4]);
        for _ in 0..PATIENCE {
            squares.tick();
            assert_eq!(squares.left.len(), 1);
        }
        squares.tick();
        assert!(squares.left.is_empty());
    }

    #[test]
    fn what_cannot_be_made_changes_nothing() {
        let mut squares = SizeCache::of(Some(WindowSide(4)));
        let refused = squares.get_or_create([5; 2], || Err("no memory"));
        assert!(refused.is_err() && squares.left.is_empty());
        assert_eq!(squares.present.map(|square| square.0), Some(4));
    }
}
