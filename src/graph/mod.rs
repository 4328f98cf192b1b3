//! The stages of a generator: nodes, which keep what was made, and their wiring.
//!
//! A [`Node`] keeps one value with the parameters and the revisions of the inputs that it was made of. A
//! [`Wiring`] is a table of tasks. Each [`Task`] names a node, its inputs, and the function that makes its
//! value. Everything else follows from the table: which stage is stale, which one is due, why the work
//! stopped, and how often each stage has run.
//!
//! Inputs are lent to each slice of the work, so work in progress holds no borrows.

mod node;
#[cfg(test)]
mod tests;
mod wiring;

pub use node::{Inputs, Node};
pub(crate) use wiring::task;
pub use wiring::{Task, Wiring, inputs};
