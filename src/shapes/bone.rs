//! Bones: the skeleton curves of a shape, from head to tail.

use glam::DVec3;

/// A skeleton curve through a part of a shape, with its thickness. Scales run along it from the first point to the
/// last.
#[derive(Clone, Debug, PartialEq)]
pub struct Bone {
    /// Its points, at least two.
    pub points: Vec<DVec3>,
    /// The approximate distance of the surface from each point.
    pub radii: Vec<f64>,
    /// Whether it goes on from the last point to the first.
    pub closed: bool,
}

/// A point on a bone.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OnBone {
    /// Position of the point.
    pub at: DVec3,
    /// Its distance from the point of the query.
    pub distance: f64,
    /// The radius of the bone there.
    pub radius: f64,
    /// Unit vector along the bone, from head to tail.
    pub along: DVec3,
}

impl Bone {
    /// A straight bone from one end to the other.
    pub(super) fn straight(from: DVec3, to: DVec3, radius: f64) -> Self {
        Self {
            points: vec![from, to],
            radii: vec![radius; 2],
            closed: false,
        }
    }

    /// The point of the bone for which the distance less the radius is least.
    pub fn nearest(&self, p: DVec3) -> OnBone {
        let n = self.points.len();
        let count = if self.closed { n } else { n - 1 };
        let mut best: Option<(f64, OnBone)> = None;
        for i in 0..count {
            let j = (i + 1) % n;
            let (a, b) = (self.points[i], self.points[j]);
            let way = b - a;
            let t =
                ((p - a).dot(way) / way.length_squared().max(f64::MIN_POSITIVE)).clamp(0.0, 1.0);
            let at = a + way * t;
            let radius = self.radii[i] + (self.radii[j] - self.radii[i]) * t;
            let distance = (p - at).length();
            if best.is_none_or(|(least, _)| distance - radius < least) {
                let along = way.normalize_or(DVec3::Y);
                let on = OnBone {
                    at,
                    distance,
                    radius,
                    along,
                };
                best = Some((distance - radius, on));
            }
        }
        best.map_or(
            OnBone {
                at: DVec3::ZERO,
                distance: p.length(),
                radius: 0.0,
                along: DVec3::Y,
            },
            |(_, on)| on,
        )
    }
}
