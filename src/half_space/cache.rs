//! Cache of shared operators and preconditioners of many sizes and types.

use std::any::{Any, TypeId};
use std::collections::HashMap;
use std::sync::{Arc, Mutex, PoisonError, Weak};

use crate::bodies::component::Component;
use crate::error::Result;

/// Shared values, indexed by their type, their components and their size in cells.
#[derive(Debug, Default)]
pub(super) struct Cache {
    entries: Mutex<Entries>,
}

#[derive(Debug, PartialEq, Eq, Hash)]
struct Key {
    kind: TypeId,
    /// Components of at most three by three directions. Unused entries are `None`.
    components: [Option<Component>; 9],
    size: [usize; 2],
}

type Entries = HashMap<Key, CacheEntry>;
type Value = dyn Any + Send + Sync;

#[derive(Debug)]
enum CacheEntry {
    /// Value that is kept for the lifetime of the cache.
    Kept(Arc<Value>),
    /// Value that is shared as long as it has an owner.
    Lent(Weak<Value>),
}

impl CacheEntry {
    fn value<T: Any + Send + Sync>(&self) -> Option<Arc<T>> {
        let value = match self {
            Self::Kept(value) => Arc::clone(value),
            Self::Lent(value) => value.upgrade()?,
        };
        value.downcast().ok()
    }

    fn is_alive(&self) -> bool {
        match self {
            Self::Kept(_) => true,
            Self::Lent(value) => value.strong_count() > 0,
        }
    }
}

impl Cache {
    /// Returns the value for these components and this size, which the first call creates. If `is_kept` is set, the
    /// value is kept for the lifetime of the cache. Otherwise it is kept only while it has an owner.
    ///
    /// Values are created outside the lock, for the reason stated in [`get_or_make`](crate::parallel::get_or_make).
    pub(super) fn get_or_make<T: Any + Send + Sync>(
        &self,
        components: &[Component],
        size: [usize; 2],
        is_kept: bool,
        make: impl FnOnce() -> Result<T>,
    ) -> Result<Arc<T>> {
        let key = Key {
            kind: TypeId::of::<T>(),
            components: std::array::from_fn(|n| components.get(n).copied()),
            size,
        };
        if let Some(found) = self.with_lock(|entries| find(entries, &key)) {
            return Ok(found);
        }
        let made = Arc::new(make()?);
        Ok(self.with_lock(|entries| {
            if let Some(found) = find(entries, &key) {
                return found;
            }
            let value: Arc<Value> = Arc::clone(&made) as _;
            let entry = if is_kept {
                CacheEntry::Kept(value)
            } else {
                CacheEntry::Lent(Arc::downgrade(&value))
            };
            entries.retain(|_, entry| entry.is_alive());
            entries.insert(key, entry);
            Arc::clone(&made)
        }))
    }

    fn with_lock<R>(&self, work: impl FnOnce(&mut Entries) -> R) -> R {
        // A panic under the lock leaves the map unchanged or with one more entry, so the poisoned lock can be used.
        let mut entries = self.entries.lock().unwrap_or_else(PoisonError::into_inner);
        work(&mut entries)
    }
}

fn find<T: Any + Send + Sync>(entries: &Entries, key: &Key) -> Option<Arc<T>> {
    entries.get(key).and_then(CacheEntry::value)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A long simulation of wear requests many windows, one after another.
    #[test]
    fn what_nobody_uses_is_forgotten() {
        let cache = Cache::default();
        let make = |n: usize, is_kept| cache.get_or_make(&[], [n, n], is_kept, || Ok(n)).unwrap();
        make(0, true);
        let held = make(1, false);
        for n in 2..100 {
            assert_eq!(*make(n, false), n);
        }
        assert!(Arc::ptr_eq(&held, &make(1, false)));
        assert_eq!(
            cache.with_lock(|entries| entries.len()),
            3,
            "kept, held and the last"
        );
    }
}
