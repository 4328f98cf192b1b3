//! Faults of pattern trees.

/// A fault of a tree.
#[derive(Clone, Debug, PartialEq)]
pub enum TreeFault {
    /// The text is no JSON: its line and column, from 1.
    NotJson {
        /// The line.
        line: usize,
        /// The column.
        column: usize,
    },
    /// A value of another sort stands where one of this sort is needed: "object", "array", "number", "text", "whole
    /// number", "true or false".
    NotA {
        /// The sort that is needed.
        wanted: &'static str,
    },
    /// A node has no `type`.
    NoType,
    /// No node has this word.
    UnknownNode {
        /// The word.
        word: String,
    },
    /// The node has no such parameter or child.
    UnknownParameter {
        /// The key.
        key: String,
    },
    /// A word that is not among those allowed.
    UnknownWord {
        /// The word.
        word: String,
        /// The words allowed.
        allowed: &'static [&'static str],
    },
    /// A label without letters.
    EmptyLabel,
    /// A number, or a count of rows, beyond its range.
    OutOfRange {
        /// The least value allowed.
        least: f64,
        /// The greatest value allowed.
        most: f64,
    },
    /// The tree is deeper than 32 nodes here.
    TooDeep,
    /// The tree has more than 200 nodes; the path is that of the first one too many.
    TooMany,
}

/// A fault of a tree, and where it is.
#[derive(Clone, Debug, PartialEq)]
pub struct TreeError {
    /// The path of the node or the parameter: keys and numbers from the root, with dots between them; empty at the
    /// root.
    pub path: String,
    /// The fault.
    pub fault: TreeFault,
}
