//! The stages of a generator: nodes, which keep results, and their wiring.
//!
//! A [`Node`] keeps one value, with the parameters and the revisions of the inputs that it was made from. A
//! [`Wiring`] is a table of tasks. Each [`Task`] names a node, its inputs, and the function that makes its value. The
//! table determines everything else: which stage is stale, which one is next, why the work stopped, and how often
//! each stage has run.
//!
//! Inputs are lent to each slice of the work, so work in progress holds no borrows.

mod node;
#[cfg(test)]
mod tests;
mod wiring;

#[cfg(house)]
pub use node::Inputs;
pub use node::Node;
pub(crate) use wiring::task;
pub use wiring::{Task, Wiring, inputs};
