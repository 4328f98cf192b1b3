//! The macro that makes lists of rows.

/// Defines lists of rows that belong to no single generator.
macro_rules! lists {
    ($($list:ident: $about:literal {
        $($word:ident $name:ident: $help:literal => $row:expr;)*
    })*) => {
        /// The keys of these rows.
        pub mod keys {
            use crate::recipe::Key;
            $($(#[doc = $help] pub const $name: Key = Key(stringify!($word));)*)*
        }

        $($(#[doc = $help] pub const $name: Parameter = $row.named(keys::$name, $help);)*)*

        // Some lists only keep rows together that generators take one by one.
        $(#[doc = $about] #[allow(dead_code)] pub const $list: &[Parameter] = &[$($name),*];)*
    };
}

pub(super) use lists;
