//! The macro that makes a generator's table of parameters.

/// Defines a constant for each row's key, in a module `keys`, and `ROWS`, the list of all rows. An entry is a row,
/// `word CONSTANT: "Help." => row;` or with the help text of a shared row `word CONSTANT => row;`, or a list of shared
/// rows, `..[list];`. If a list before a row has a row of the same key, the later row replaces it at the list's place.
macro_rules! rows {
    ($($(..[$list:expr])? $($word:ident $name:ident $(: $help:literal)? => $row:expr)?;)*) => {
        /// The keys of the rows.
        pub mod keys {
            #[cfg(house)]
            pub use $crate::generators::rows::shapes::keys::*;
            pub use $crate::generators::rows::shared::keys::*;
            pub use $crate::generators::rows::stones::keys::*;
            use $crate::recipe::Key;
            $($(#[doc = concat!("`", stringify!($word), "`", $(". ", $help)?)]
            pub const $name: Key = Key(stringify!($word));)?)*
        }

        const JOINED: $crate::recipe::schema::Joined = $crate::recipe::schema::Joined::of(
            &[$($($list)? $(&[$row$(.keyed(keys::$name).helped($help))?])?),*],
        );

        /// The rows, in the order in which links are written.
        pub const ROWS: &[$crate::recipe::Parameter] = &JOINED.rows::<{ JOINED.count }>();
    };
}

pub(crate) use rows;
