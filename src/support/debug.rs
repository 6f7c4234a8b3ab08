//! `Debug` of what has a number in every cell: by a few numbers of the whole.

/// `Debug` by some fields and methods of a type; all the numbers in its cells would be no help to who reads them.
macro_rules! shown {
    ($type:ident $(<const $n:ident: usize>)?: $($part:ident $(($($none:tt)?))?),+ $(,)?) => {
        impl $(<const $n: usize>)? std::fmt::Debug for $type $(<$n>)? {
            fn fmt(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
                let mut shown = formatter.debug_struct(stringify!($type));
                $(shown.field(stringify!($part), &self.$part $(($($none)?))?);)+
                shown.finish_non_exhaustive()
            }
        }
    };
}

pub(crate) use shown;
