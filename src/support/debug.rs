//! `Debug` output, limited to a few global numbers, for types with a number in every cell.

/// Implements `Debug` with selected fields and methods of a type. The numbers of all cells would make the output
/// unreadable.
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
