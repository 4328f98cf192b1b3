//! Tables of parameters, and the rows that several generators share, with the parameters of stages that they make.

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
