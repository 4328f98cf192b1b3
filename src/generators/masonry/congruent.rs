//! Blocks of any shape, each in its own frame. Congruent blocks share a body, however they are turned.

use crate::masonry::block::Polyhedron;
use glam::DVec3;

/// Coordinates of vertices are rounded to steps of this length (metres).
const STEP: f64 = 5e-5;

/// A block in its own frame.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Congruent {
    /// The mean of its vertices.
    pub middle: DVec3,
    /// Its axes: unit vectors, right-handed, the third one outwards.
    pub axes: [DVec3; 3],
    /// Its vertices in this frame, in steps of 0.05 mm. Blocks with equal steps are congruent.
    pub steps: Vec<[i32; 3]>,
}

impl Congruent {
    /// The frame of a block whose front looks towards `outwards` (unit vector).
    pub fn of(body: &Polyhedron, outwards: DVec3) -> Self {
        let across = |way: DVec3| (way - outwards * way.dot(outwards)).normalize_or_zero();
        let y = if outwards.y.abs() < 0.999 {
            across(DVec3::Y)
        } else {
            across(DVec3::X)
        };
        let axes = [y.cross(outwards), y, outwards];
        let middle = body.centre();
        let steps = |p: &DVec3| {
            let own = along(axes, *p - middle);
            own.to_array().map(|v| (v / STEP).round() as i32)
        };
        Self {
            steps: body.vertices().iter().map(steps).collect(),
            middle,
            axes,
        }
    }

    /// The block moved to the origin and turned so that its axes are x, y and z.
    pub fn plain(&self, body: &Polyhedron) -> Polyhedron {
        body.clone().mapped(|p| along(self.axes, p - self.middle))
    }
}

/// The coordinates of a vector along these axes.
fn along(axes: [DVec3; 3], v: DVec3) -> DVec3 {
    DVec3::from(axes.map(|axis| axis.dot(v)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::masonry::footprint::Footprint;
    use glam::{DQuat, DVec2};

    #[test]
    fn turned_and_moved_blocks_are_congruent() {
        let corners = [(0.0, 0.0), (0.2, 0.0), (0.25, 0.08), (0.0, 0.08)].map(DVec2::from);
        let base = Footprint::new(&corners).expect("a polygon");
        let body = Polyhedron::prism(&base, [-0.1, 0.0], [0.0; 2], |p, z| p.extend(z));
        let first = Congruent::of(&body, DVec3::Z);
        let turn = DQuat::from_rotation_y(0.7);
        let moved = body
            .clone()
            .mapped(|p| turn * p + DVec3::new(3.0, 1.0, -2.0));
        let second = Congruent::of(&moved, turn * DVec3::Z);
        assert_eq!(first.steps, second.steps);
        let [a, b] = [first.plain(&body), second.plain(&moved)];
        for (p, q) in a.vertices().iter().zip(b.vertices()) {
            assert!(p.distance(*q) < 1e-9, "{p} {q}");
        }
        let longer = body.mapped(|p| p * DVec3::new(1.01, 1.0, 1.0));
        assert_ne!(first.steps, Congruent::of(&longer, DVec3::Z).steps);
    }
}
