//! A JSON parser for the heads of GLB files.
//!
//! It works in slices, because a head may be as large as a file, and it keeps only values under the names that the
//! reader of scenes knows. So names that no reader needs cost no memory, and lists of numbers stay short.

mod parser;
mod value;

pub(super) use parser::Parser;
pub(super) use value::Json;
