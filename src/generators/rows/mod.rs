//! Tables of parameters, and the rows that several generators share.

#[cfg(house)]
pub mod buildings;
mod lists;
#[cfg(house)]
mod numbered;
#[cfg(house)]
pub mod shapes;
pub mod shared;
pub mod stones;
mod table;

pub(crate) use table::rows;
