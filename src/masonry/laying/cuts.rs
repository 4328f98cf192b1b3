//! The parts of bricks that fit in the free space of a face, without slivers on walls.
//!
//! Bricks on walls are cut along outlines of arches and along slopes, but not along joints between the stones of an arch. No
//! mason lays a sliver: he leaves it to the mortar.

use super::site::Site;
use crate::building::FaceId;
use crate::masonry::footprint::Footprint;
use crate::masonry::free_space::{LEAST_SHARE, MOST_DEPTH, clip, clip_at_borders, clip_multi};
use crate::masonry::plan::is_wall;
use smallvec::SmallVec;

/// A part of a brick is thin if it is narrower than this, in half bricks, and than [`LOW`] of its row's height.
const THIN: f64 = 1.0 / 3.0;
/// The share of a row's height below which a part may be thin.
const LOW: f64 = 0.6;
/// Thin parts on walls are left to the mortar if they are narrower than this, or their area is less, in half bricks.
const LEFT: [f64; 2] = [0.2, 0.3];

/// Most bricks have one part.
type BrickParts = SmallVec<[Footprint; 1]>;

impl Site {
    /// The free parts of a brick: one on a wall.
    pub(super) fn free_parts(&self, id: FaceId, place: &Footprint) -> BrickParts {
        let obstacles = self.faces[id.index()].obstacles(place);
        let inset = 0.5 * self.plan.module.joint;
        if is_wall(self.face(id)) {
            let part = clip_at_borders(place, &obstacles, inset, LEAST_SHARE);
            part.into_iter().collect()
        } else if self.is_oblique(id) {
            clip_multi(place, &obstacles, inset, (LEAST_SHARE, MOST_DEPTH)).into()
        } else {
            let part = clip(place, &obstacles, inset, LEAST_SHARE);
            part.into_iter().collect()
        }
    }

    /// Whether a part is thin in a row of this height (metres).
    fn is_thin(&self, part: &Footprint, height: f64) -> bool {
        part.least_width() < (THIN * self.plan.module.half).min(LOW * height)
    }

    /// The free parts of a brick that are laid.
    pub(super) fn laid_parts(&self, id: FaceId, place: &Footprint) -> BrickParts {
        let mut parts = self.free_parts(id, place);
        parts.retain(|part| !self.is_mortar(id, part, place));
        parts
    }

    /// Whether a part of a brick on a wall is left to the mortar: it is thin, and very thin or small.
    fn is_mortar(&self, id: FaceId, part: &Footprint, whole: &Footprint) -> bool {
        let ([low, high], module) = (whole.bounds(), self.plan.module);
        let [width, area] = LEFT;
        let is_little = || {
            part.least_width() < width * module.half
                || part.area() < area * module.half * module.course
        };
        is_wall(self.face(id)) && self.is_thin(part, high.y - low.y) && is_little()
    }
}
