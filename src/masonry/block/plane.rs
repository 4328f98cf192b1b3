//! Planes in space.

use crate::trimesh::polygon::across;
use glam::DVec3;

/// A plane with an outer side. The body lies where `distance` is not positive.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Plane {
    /// Unit vector outwards.
    pub normal: DVec3,
    /// Distance of the plane from the origin along the normal (metres).
    pub offset: f64,
}

impl Plane {
    /// The plane through a point, with its normal along `outwards`, which is not zero.
    pub fn through(point: DVec3, outwards: DVec3) -> Self {
        let normal = outwards.normalize();
        Self {
            normal,
            offset: normal.dot(point),
        }
    }

    /// The mean plane of a ring of points, which is counter-clockwise seen from outside. None without area.
    pub fn of_ring(ring: impl ExactSizeIterator<Item = DVec3> + Clone) -> Option<Self> {
        let normal = Self::normal_of(ring.clone())?;
        let count = ring.len();
        let offsets = ring.map(|p| normal.dot(p));
        Some(Self {
            normal,
            offset: offsets.sum::<f64>() / count as f64,
        })
    }

    /// The unit normal of a ring's mean plane; none without area.
    fn normal_of(ring: impl Iterator<Item = DVec3>) -> Option<DVec3> {
        across(ring).try_normalize()
    }

    /// Whether a ring of points has a mean plane.
    pub(super) fn has_area(ring: impl Iterator<Item = DVec3>) -> bool {
        let square = across(ring).length_squared();
        0.0 < square && square < f64::INFINITY
    }

    /// Signed distance of a point, positive outside (metres).
    pub fn distance(self, p: DVec3) -> f64 {
        self.normal.dot(p) - self.offset
    }

    /// The plane moved inwards by `by` (metres).
    pub fn inset(self, by: f64) -> Self {
        Self {
            offset: self.offset - by,
            ..self
        }
    }
}
