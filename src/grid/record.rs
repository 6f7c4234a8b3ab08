//! Structs of results on a grid, with their fields listed once.

/// Declares a struct of results with its fields in four groups, which are serialised in this order:
/// - `buffers` own memory that grows with the grid. A copy into a value reuses this memory.
/// - `values` have a fixed size.
/// - `ignored` values describe the solve, and equality ignores them.
/// - `local` values belong to a slab of the grid, and are not serialised.
///
/// The macro implements `Clone`, [`TryClone`](crate::TryClone), `PartialEq` and the serialisation. A deserialised value must
/// pass the given check. The attribute at the end contains the options of its deserialisation.
macro_rules! record {
    (
        $(#[$of_type:meta])*
        pub struct $Type:ident {
            buffers { $($(#[$of_buffer:meta])* $buffer_vis:vis $buffer:ident: $Buffer:ty,)* }
            values { $($(#[$of_value:meta])* $value_vis:vis $value:ident: $Value:ty,)* }
            ignored { $($(#[$of_ignored:meta])* $ignored_vis:vis $ignored:ident: $Ignored:ty,)* }
            local { $($(#[$of_local:meta])* $local_vis:vis $local:ident: $Local:ty,)* }
        }
        #[$options:meta]
        check($read:ident) $check:block
    ) => {
        $crate::grid::record::checked_struct! {
            $(#[$of_type])*
            pub struct $Type {
                $($(#[$of_buffer])* $buffer_vis $buffer: $Buffer,)*
                $($(#[$of_value])* $value_vis $value: $Value,)*
                $($(#[$of_ignored])* $ignored_vis $ignored: $Ignored,)*
                $($(#[$of_local])* #[cfg_attr(feature = "serde", serde(skip))] $local_vis $local: $Local,)*
            }
            #[$options]
            check($read) $check
        }

        $crate::grid::field::clone_in_place!($Type {
            $($buffer,)* $($value,)* $($ignored,)* $($local,)*
        });

        $crate::memory::fallible::try_clone!($Type { $($buffer),* } {
            $($value,)* $($ignored,)* $($local,)*
        });

        impl PartialEq for $Type {
            fn eq(&self, other: &Self) -> bool {
                true $(&& self.$buffer == other.$buffer)*
                    $(&& self.$value == other.$value)*
                    $(&& self.$local == other.$local)*
            }
        }
    };
}

/// Declares a struct whose deserialised value must pass the given check. The macro implements the serialisation. The
/// attribute at the end contains the options of its deserialisation.
macro_rules! checked_struct {
    (
        $(#[$of_type:meta])*
        pub struct $Type:ident {
            $($(#[$of_field:meta])* $vis:vis $field:ident: $Field:ty,)*
        }
        #[$options:meta]
        check($read:ident) $check:block
    ) => {
        $(#[$of_type])*
        #[cfg_attr(feature = "serde", derive(serde::Serialize))]
        pub struct $Type {
            $($(#[$of_field])* $vis $field: $Field,)*
        }

        #[cfg(feature = "serde")]
        const _: () = {
            #[derive(serde::Deserialize)]
            #[$options]
            struct Raw {
                $($(#[$of_field])* $field: $Field,)*
            }

            impl<'de> serde::Deserialize<'de> for $Type {
                fn deserialize<D: serde::Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
                    $crate::support::serialise::checked(Raw::deserialize(deserializer)?, |$read| $check)
                }
            }
        };
    };
}

pub(crate) use {checked_struct, record};
