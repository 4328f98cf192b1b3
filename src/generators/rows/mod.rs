//! Tables of parameters, the rows that several generators share, and the parameters of stages made from these rows.

#[cfg(house)]
pub mod buildings;
mod lists;
#[cfg(house)]
pub mod numbered;
#[cfg(house)]
pub mod shapes;
pub mod shared;
pub mod stones;
mod table;

pub(crate) use table::rows;
