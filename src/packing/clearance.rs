//! Whether walls leave room for a cell.

use super::BoundaryCondition;
use super::placed::FRONT_GAP;
use super::plane::Surroundings;
use super::shape::Shape;
use crate::domain::{Domain, Nearest};
use crate::field::Fields;
use glam::DVec2;

/// The fewest sizes from the boundary at which a cell is placed inside.
const INSIDE_CLEARANCE: f64 = 0.35;

/// Where it is nearer than this from the middle of an outline to its walls, in sizes, cells go into
/// the middle ...
const NARROW: f64 = 0.4;
/// ... but not where it is nearer than this.
const NARROWEST: f64 = 0.25;

/// Where the outline is too narrow for a cell: the middle between its walls there. Nothing where it is
/// wide enough, and where it is so narrow that a cell would be a sliver.
pub(super) fn middle_of_narrow(p: DVec2, around: Surroundings) -> Option<DVec2> {
    let Surroundings {
        domain,
        fields,
        walls,
        boundary,
    } = around;
    if boundary == BoundaryCondition::On || !domain.is_in_box(p) || !walls.is_near(p) {
        return None;
    }
    let near = domain.nearest(p);
    let extent = Shape::metric_at(fields, p).extent(near.inward);
    let depth = domain.medial_depth(near.point, near.inward, NARROW * extent);
    let is_narrow = depth >= NARROWEST * extent && depth < NARROW * extent;
    is_narrow.then(|| near.point + near.inward * depth)
}

/// Is there room for a cell between the walls at this place?
pub(super) fn has_room(p: DVec2, around: Surroundings) -> bool {
    let Surroundings {
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
        BoundaryCondition::Wall => INSIDE_CLEARANCE,
        // The first row inside keeps off the cells on the boundary by itself.
        BoundaryCondition::On => FRONT_GAP * 0.8,
    };
    is_clear(p, clearance, fields, domain)
}

/// Is a place inside, and this share of a cell's extent or more from the boundary and from lines?
pub(super) fn is_clear(p: DVec2, clearance: f64, fields: &Fields, domain: &Domain) -> bool {
    let shape = Shape::metric_at(fields, p);
    let clear = |near: Nearest| near.distance >= clearance * shape.extent(near.inward);
    clear(domain.nearest(p)) && domain.nearest_line(p).is_none_or(clear)
}
