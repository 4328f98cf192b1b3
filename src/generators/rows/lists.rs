//! The macro that makes lists of rows.

/// Defines lists of rows that belong to no single generator. An entry is a row, `word CONSTANT: "Help." => row;`, or
/// `word CONSTANT => row;` for a row that has its help text already.
macro_rules! lists {
    ($($list:ident: $about:literal {
        $($word:ident $name:ident $(: $help:literal)? => $row:expr;)*
    })*) => {
        /// The keys of these rows.
        pub mod keys {
            use crate::recipe::Key;
            $($(#[doc = concat!("`", stringify!($word), "`", $(". ", $help)?)]
            pub const $name: Key = Key(stringify!($word));)*)*
        }

        $($(#[doc = concat!("`", stringify!($word), "`", $(". ", $help)?)]
        pub const $name: Parameter = $row.keyed(keys::$name)$(.helped($help))?;)*)*

        // Some lists only keep rows together that generators take one by one.
        $(#[doc = $about] #[allow(dead_code)] pub const $list: &[Parameter] = &[$($name),*];)*
    };
}

pub(super) use lists;
