//! Moves a building to the origin. Maps give places in metres from a far point, such as one on the equator.

use super::fault::FARTHEST;
use glam::DVec3;

/// The longest building that is moved (metres). A longer one is more likely given in another unit.
const LONGEST: f64 = 1000.0;
/// Moved places are rounded to multiples of this part of a metre: a move changes their last digits, and a length in
/// whole millimetres is to stay the nearest number to its metres.
const PARTS: f64 = 1e6;

/// Moves places that lie farther away than [`FARTHEST`], and returns the move in whole metres: afterwards the middle of
/// their bounding box is above the origin, and its lowest side on the ground. Other places stay, and so do those of a
/// building longer than 1,000 m.
pub(super) fn to_origin(places: &mut [DVec3]) -> Option<DVec3> {
    let low = places.iter().copied().reduce(DVec3::min)?;
    let high = places.iter().copied().reduce(DVec3::max)?;
    let is_far = low.abs().max(high.abs()).max_element() > FARTHEST;
    // An infinite place makes this false. Those that are no numbers may be lost in the box; the vertices are tested later.
    let is_short = (high - low).max_element() <= LONGEST;
    if !is_far || !is_short {
        return None;
    }
    let middle = (low + (high - low) * 0.5).round();
    let by = -DVec3::new(middle.x, low.y.floor(), middle.z);
    for place in places {
        *place = ((*place + by) * PARTS).round() / PARTS;
    }
    Some(by)
}
