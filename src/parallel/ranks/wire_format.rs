//! Wire format of partial results that ranks exchange.

/// A value that is sent as a fixed number of 64-bit words.
pub(crate) trait WireFormat: Copy + Send {
    /// Number of words.
    const COUNT: usize;

    /// Neutral value: zero, false or none.
    const ZERO: Self;

    /// Appends the words.
    fn write(self, words: &mut Vec<u64>);

    /// Reads the words from the front. The caller must provide enough words.
    fn read(words: &mut &[u64]) -> Self;
}

/// Returns the next word, or zero at the end of the words. The end is reached only after a failure.
fn next(words: &mut &[u64]) -> u64 {
    let Some((first, rest)) = words.split_first() else {
        return 0;
    };
    *words = rest;
    *first
}

impl WireFormat for () {
    const COUNT: usize = 0;
    const ZERO: Self = ();

    fn write(self, _: &mut Vec<u64>) {}

    fn read(_: &mut &[u64]) -> Self {}
}

impl WireFormat for u64 {
    const COUNT: usize = 1;
    const ZERO: Self = 0;

    fn write(self, words: &mut Vec<u64>) {
        words.push(self);
    }

    fn read(words: &mut &[u64]) -> Self {
        next(words)
    }
}

impl WireFormat for f64 {
    const COUNT: usize = 1;
    const ZERO: Self = 0.0;

    fn write(self, words: &mut Vec<u64>) {
        words.push(self.to_bits());
    }

    fn read(words: &mut &[u64]) -> Self {
        Self::from_bits(next(words))
    }
}

impl WireFormat for usize {
    const COUNT: usize = 1;
    const ZERO: Self = 0;

    fn write(self, words: &mut Vec<u64>) {
        words.push(self as u64);
    }

    #[expect(
        clippy::cast_possible_truncation,
        reason = "it was a usize of the same program"
    )]
    fn read(words: &mut &[u64]) -> Self {
        next(words) as Self
    }
}

impl WireFormat for bool {
    const COUNT: usize = 1;
    const ZERO: Self = false;

    fn write(self, words: &mut Vec<u64>) {
        words.push(self.into());
    }

    fn read(words: &mut &[u64]) -> Self {
        next(words) != 0
    }
}

impl<T: WireFormat> WireFormat for Option<T> {
    const COUNT: usize = 1 + T::COUNT;
    const ZERO: Self = None;

    fn write(self, words: &mut Vec<u64>) {
        self.is_some().write(words);
        self.unwrap_or(T::ZERO).write(words);
    }

    fn read(words: &mut &[u64]) -> Self {
        let (is_some, value) = (bool::read(words), T::read(words));
        is_some.then_some(value)
    }
}

impl<T: WireFormat, const K: usize> WireFormat for [T; K] {
    const COUNT: usize = K * T::COUNT;
    const ZERO: Self = [T::ZERO; K];

    fn write(self, words: &mut Vec<u64>) {
        for value in self {
            value.write(words);
        }
    }

    fn read(words: &mut &[u64]) -> Self {
        std::array::from_fn(|_| T::read(words))
    }
}

/// Implements [`WireFormat`] for a tuple, component by component.
macro_rules! words_of_tuple {
    ($($part:ident $place:tt),+) => {
        impl<$($part: WireFormat),+> WireFormat for ($($part,)+) {
            const COUNT: usize = 0 $(+ $part::COUNT)+;
            const ZERO: Self = ($($part::ZERO,)+);

            fn write(self, words: &mut Vec<u64>) {
                $(self.$place.write(words);)+
            }

            fn read(words: &mut &[u64]) -> Self {
                ($($part::read(words),)+)
            }
        }
    };
}

words_of_tuple!(A 0, B 1);
words_of_tuple!(A 0, B 1, C 2);
words_of_tuple!(A 0, B 1, C 2, D 3);
