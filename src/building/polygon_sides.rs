//! The sides of the polygons of a file, and why some clash.

use super::fault::PolygonFault;
use glam::DVec3;
use std::collections::{BTreeMap, BTreeSet};

/// A polygon: its welded vertices, its group, and its unit normal.
pub(super) type PlaneRing = (Vec<u32>, u32, DVec3);

/// The directed sides of a polygon.
pub(super) fn sides(ring: &[u32]) -> impl Iterator<Item = (u32, u32)> + '_ {
    ring.iter()
        .copied()
        .zip(ring.iter().copied().cycle().skip(1))
}

/// The polygon to the left of each directed side.
///
/// # Errors
/// The first two polygons that are to the left of the same side, and the side's ends.
pub(super) fn left_of_sides(
    rings: &[PlaneRing],
) -> Result<BTreeMap<(u32, u32), usize>, [usize; 4]> {
    let mut left = BTreeMap::new();
    for (k, (ring, ..)) in rings.iter().enumerate() {
        for (a, b) in sides(ring) {
            if let Some(other) = left.insert((a, b), k) {
                return Err([other, k, a as usize, b as usize]);
            }
        }
    }
    Ok(left)
}

/// Why two polygons run the same way along a side.
pub(super) fn clash(
    rings: &[PlaneRing],
    [first, second]: [usize; 2],
    [a, b]: [u32; 2],
) -> PolygonFault {
    let is_side = |side: &(u32, u32)| *side == (a, b) || *side == (b, a);
    let meeting = rings
        .iter()
        .flat_map(|(ring, ..)| sides(ring))
        .filter(is_side)
        .count();
    let corners = |k: usize| rings[k].0.iter().copied().collect::<BTreeSet<u32>>();
    match first == second {
        true => PolygonFault::Itself,
        false if corners(first) == corners(second) => PolygonFault::Twice,
        false if meeting > 2 => PolygonFault::Many(meeting),
        false => PolygonFault::Turned,
    }
}
