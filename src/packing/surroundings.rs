//! The plane domain of a packing.

use super::BoundaryCondition;
use crate::domain::{Domain, Walls};
use crate::field::Fields;

/// An outline, with the fields and the walls in it.
#[derive(Clone, Copy)]
pub(super) struct PlaneDomain<'a> {
    pub domain: &'a Domain,
    pub fields: &'a Fields,
    pub walls: &'a Walls,
    pub boundary: BoundaryCondition,
}
