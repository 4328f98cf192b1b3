//! Tests whether walls leave room for a cell.

use super::BoundaryCondition;
use super::placed::FRONT_GAP;
use super::shape::CellShape;
use super::surroundings::PlaneDomain;
use crate::domain::{Domain, Nearest};
use crate::field::Fields;
use glam::DVec2;

/// The least distance from the boundary at which a cell is placed, in sizes.
pub(crate) const INSIDE_CLEARANCE: f64 = 0.35;

/// The outline is narrow where its centre line is nearer to the walls than this, in sizes. Cells then go onto the
/// centre line.
pub(crate) const NARROW: f64 = 0.4;
/// No cell is placed where the centre line is nearer to the walls than this, in sizes.
pub(crate) const NARROWEST: f64 = 0.25;

/// The point on the centre line at a place too narrow for a cell. `None` if there is room, or so little that
/// a cell would be a sliver.
pub(super) fn middle_of_narrow(p: DVec2, around: PlaneDomain) -> Option<DVec2> {
    let PlaneDomain {
        domain,
        fields,
        walls,
        boundary,
    } = around;
    if boundary == BoundaryCondition::On || !domain.is_in_box(p) || !walls.is_near(p) {
        return None;
    }
    let near = domain.nearest(p);
    let extent = CellShape::metric_at(fields, p).extent(near.inward);
    let depth = domain.medial_depth(near.point, near.inward, NARROW * extent);
    let is_narrow = depth >= NARROWEST * extent && depth < NARROW * extent;
    is_narrow.then(|| near.point + near.inward * depth)
}

/// Whether the walls leave room for a cell at this place.
pub(super) fn has_room(p: DVec2, around: PlaneDomain) -> bool {
    let PlaneDomain {
        domain,
        fields,
        walls,
        boundary,
    } = around;
    if !domain.is_in_box(p) {
        return false;
    }
    if !walls.is_near(p) {
        return domain.contains(p);
    }
    let clearance = match boundary {
        BoundaryCondition::Wall | BoundaryCondition::Open => INSIDE_CLEARANCE,
        // The front's gap already keeps the first row off the cells on the boundary.
        BoundaryCondition::On => FRONT_GAP * 0.8,
    };
    is_clear(p, clearance, fields, domain)
}

/// Whether a place is inside, and at least this share of a cell's extent away from the boundary and from
/// lines.
pub(super) fn is_clear(p: DVec2, clearance: f64, fields: &Fields, domain: &Domain) -> bool {
    let shape = CellShape::metric_at(fields, p);
    let clear = |near: Nearest| near.distance >= clearance * shape.extent(near.inward);
    clear(domain.nearest(p)) && domain.nearest_line(p).is_none_or(clear)
}
