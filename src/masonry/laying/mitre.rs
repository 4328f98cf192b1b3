//! Mitres: where a convex edge has no cells of its own, the cells of its two faces meet at the plane that halves its
//! angle.

use super::cell::Feature;
use super::site::Site;
use crate::building::{EdgeId, FaceId};
use crate::masonry::block::{Plane, Polyhedron};

/// A cell is cut if its bounding sphere is nearer to an edge than this many depths of the cell: twice the depth, for
/// the sake of acute edges.
const NEAR: f64 = 2.0;

impl Site {
    /// The part of a face's cell before the mitres of convex edges without cells; none if nothing is left. `depth` is
    /// the cell's depth (metres).
    pub fn mitred(&self, face: FaceId, body: Polyhedron, depth: f64) -> Option<Polyhedron> {
        let [low, high] = body.bounds();
        let (middle, reach) = (low.midpoint(high), low.distance(high) + NEAR * depth);
        let edges = self.convex[face.index()].iter();
        let near = edges.filter(|(_, [from, to])| {
            // Most are farther away along one axis already.
            let is_far = |k: usize| from[k] - middle[k] > reach || middle[k] - to[k] > reach;
            !(is_far(0) || is_far(1) || is_far(2))
                && middle.clamp(*from, *to).distance(middle) < reach
        });
        near.into_iter().try_fold(body, |body, &(id, _)| {
            match self.mitre(face, id, &body, depth) {
                Some(plane) => body.cut(plane, 0.0),
                None => Some(body),
            }
        })
    }

    /// The plane that halves the angle of an edge beside a body, if the edge has no cells there.
    fn mitre(&self, face: FaceId, id: EdgeId, body: &Polyhedron, depth: f64) -> Option<Plane> {
        let edge = self.edge(id);
        let middle = body.centre();
        let along = edge.path.project(middle);
        let along = if edge.is_closed() {
            along
        } else {
            along.clamp(0.0, edge.length())
        };
        let point = edge.path.point(along);
        let reach = body
            .vertices()
            .iter()
            .map(|p| p.distance(middle))
            .fold(0.0, f64::max);
        if point.distance(middle) > reach + NEAR * depth || self.has_cells(id, along) {
            return None;
        }
        let frame = self.building.edge_frame(id, along);
        let [Some(a), Some(b)] = frame.normals else {
            return None;
        };
        let side = edge.side(face)?;
        let inward = frame.inward[side]?;
        let outwards = frame.tangent.cross((a + b).try_normalize()?);
        let outwards = if outwards.dot(inward) > 0.0 {
            -outwards
        } else {
            outwards
        };
        let plane = Plane::through(point, outwards);
        // Beside an arc the front is cut along a chord already, so the plane is moved out beyond the front.
        let surface = &self.face(face).surface;
        let front = body
            .vertices()
            .iter()
            .filter(|&&p| surface.project(p).z.abs() < 1e-6);
        let beyond = front.map(|&p| plane.distance(p)).fold(0.0, f64::max);
        Some(plane.inset(-beyond))
    }

    /// Whether cells of the edge itself, or of its corners, lie at a place along it.
    fn has_cells(&self, id: EdgeId, along: f64) -> bool {
        let claims = self.edges[id.index()].claims().iter();
        let mut there = claims.filter(|([from, to], _)| (*from..=*to).contains(&along));
        there.any(|&(_, cell)| !matches!(self.cells[cell as usize].feature, Feature::Face(_)))
    }
}
