//! Faces on which people walk: treads of steps, and thresholds of doors.

use crate::building::labels::{DOOR, SILL, STEP};
use crate::building::{Building, Face};
use crate::order::{greater, lesser};
use glam::{DVec3, Vec3};

/// Faces whose normals have at least this upright part can be walked on.
const LEVEL: f64 = 0.9;
/// Surfaces count as part of a face if the cosine between the normals is greater: its front edges and joints are.
const ALIKE: f32 = 0.5;
/// How far blocks stand out of their face, and mortar lies behind it (metres).
const NEAR: f32 = 0.06;
/// People keep this far from the ends of a tread (metres).
const ENDS: f32 = 0.3;

/// A face on which people walk.
pub(super) struct Trodden {
    middle: Vec3,
    normal: Vec3,
    /// Unit vectors along its two sides with half of its extent along each (metres); the longer side comes first.
    sides: [(Vec3, f32); 2],
}

/// The faces of a building on which people walk. `place` maps points of the building to the axes of the scene, in
/// metres.
pub(super) fn trodden(building: &Building, place: impl Fn(DVec3) -> Vec3) -> Vec<Trodden> {
    let faces = building.faces().iter();
    let faces = faces.filter(|face| is_walked_on(face));
    faces
        .map(|face| {
            let polygons = face.polygons.iter().map(|&id| building.polygon(id));
            let corners = polygons.flat_map(|polygon| &polygon.vertices);
            let corners: Vec<DVec3> = corners.map(|&v| building.vertex(v).position).collect();
            Trodden::new(face, &corners, &place)
        })
        .collect()
}

fn is_walked_on(face: &Face) -> bool {
    let is_threshold = face.has_label(DOOR) && face.has_label(SILL);
    let place = face.bounds()[0];
    let up = face.surface.frame(place.x, place.y).normal.y;
    (is_threshold || face.has_label(STEP)) && face.surface.is_flat() && up > LEVEL
}

impl Trodden {
    fn new(face: &Face, corners: &[DVec3], place: impl Fn(DVec3) -> Vec3) -> Self {
        let [low, high] = face.bounds();
        let at = low.midpoint(high);
        let frame = face.surface.frame(at.x, at.y);
        let along = |axis: DVec3| {
            let all = corners.iter().map(|corner| corner.dot(axis));
            all.fold([f64::MAX, f64::MIN], |[low, high], v| {
                [low.min(v), high.max(v)]
            })
        };
        let axes = [frame.s, frame.t, frame.normal];
        let spans = axes.map(along);
        let middle = axes.iter().zip(spans);
        let middle: DVec3 = middle
            .map(|(axis, [low, high])| *axis * (0.5 * (low + high)))
            .sum();
        let to = |axis: DVec3| place(middle + axis) - place(middle);
        let side = |k: usize| (to(axes[k]), (0.5 * (spans[k][1] - spans[k][0])) as f32);
        let mut sides = [side(0), side(1)];
        sides.sort_by(|a, b| b.1.total_cmp(&a.1));
        Self {
            middle: place(middle),
            normal: to(axes[2]),
            sides,
        }
    }

    /// How much people walk at a place of a surface with this normal, 0..1: less near the ends. `None` if the place is
    /// not on the face.
    pub fn share(&self, at: Vec3, normal: Vec3) -> Option<f32> {
        let from = at - self.middle;
        let inside = self.sides.map(|(way, half)| half - from.dot(way).abs());
        let is_on = from.dot(self.normal).abs() < NEAR
            && normal.dot(self.normal) > ALIKE
            && inside.iter().all(|&inside| inside > -NEAR);
        is_on.then(|| greater(lesser(inside[0] / ENDS, 1.0), 0.0))
    }
}
