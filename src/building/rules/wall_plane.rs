//! The plane of a wall, in which its openings are drawn.

use glam::{DVec2, DVec3};

/// The plane of a wall seen from outside: u to the right, y upwards. u is 0 at a line of the grid: half a joint to the
/// left of the wall's left end, or to the right of it where the wall begins in an inner corner.
#[derive(Clone, Copy, Debug)]
pub(super) struct WallPlane {
    pub origin: DVec3,
    pub along: DVec3,
    pub normal: DVec3,
}

impl WallPlane {
    /// The wall from its left end to its right one, seen from outside. `lead` is u at its left end.
    pub fn new(left: DVec3, right: DVec3, lead: f64) -> Self {
        let along = (right - left).normalize();
        Self {
            origin: left - along * lead,
            along,
            normal: along.cross(DVec3::Y),
        }
    }

    /// The place at u and y, `behind` metres behind the face.
    pub fn at(&self, p: DVec2, behind: f64) -> DVec3 {
        self.origin + self.along * p.x + DVec3::Y * p.y - self.normal * behind
    }
}
