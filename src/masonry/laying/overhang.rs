//! The region that a roof's tiles cover: the roof's face, grown where tiles stand over its border.

use super::site::Site;
use crate::building::{Bend, EdgeId, FaceId};
use crate::masonry::region::Region;
use glam::{DVec2, DVec3};

/// How far tiles stand over eaves, and over verges (metres).
const OVER: [f64; 2] = [0.06, 0.035];
/// Faces whose outward normal has at least this vertical part carry tiles.
const LEAST_UP: f64 = 0.17;
/// Sides whose directions have a smaller cross product than this are parallel.
const PARALLEL: f64 = 1e-6;
/// A side of a ring lies on an edge that is this near to its middle (metres).
const ON: f64 = 1e-3;

impl Site {
    /// Whether a face can carry tiles: it is flat and looks upwards.
    pub fn is_roof(&self, face: FaceId) -> bool {
        let surface = &self.face(face).surface;
        surface.is_flat() && surface.frame(0.0, 0.0).normal.y >= LEAST_UP
    }

    /// The other face of an edge, if it is a roof, too.
    pub fn next_roof(&self, face: FaceId, id: EdgeId) -> Option<FaceId> {
        let others = self.edge(id).faces.into_iter().flatten();
        let mut others = others.filter(|&other| other != face && self.is_roof(other));
        others.next()
    }

    /// The face's region, with each side moved out to where tiles end.
    pub fn tiled_region(&self, face: FaceId) -> Region {
        let rings = &self.face(face).rings;
        let loops = rings.iter().map(|ring| self.grown(face, ring));
        Region {
            loops: loops.collect(),
        }
    }

    fn grown(&self, face: FaceId, ring: &[DVec2]) -> Vec<DVec2> {
        let count = ring.len();
        let ends = |k: usize| [ring[k % count], ring[(k + 1) % count]];
        let offs: Vec<f64> = (0..count).map(|k| self.overhang(face, ends(k))).collect();
        let corner = |k: usize| {
            let before = (k + count - 1) % count;
            let [d, e] = [before, k].map(|k| {
                let [a, b] = ends(k);
                (b - a).normalize_or_zero()
            });
            let [p, q] = [(d, before), (e, k)].map(|(way, k)| ring[k] - way.perp() * offs[k]);
            let cross = d.perp_dot(e);
            if cross.abs() < PARALLEL {
                return ring[k] - e.perp() * offs[k];
            }
            p + d * ((q - p).perp_dot(e) / cross)
        };
        (0..count).map(corner).collect()
    }

    /// How far tiles stand over a side of a roof's ring.
    fn overhang(&self, face: FaceId, [a, b]: [DVec2; 2]) -> f64 {
        let middle = self.at(face, a.midpoint(b), 0.0);
        let walks = self.face(face).loops.iter().flatten();
        let mut edges = walks.map(|walk| walk.edge);
        let Some(id) = edges.find(|&id| self.passes(id, middle, ON)) else {
            return 0.0;
        };
        let is_free = matches!(self.edge(id).bend, Bend::Convex | Bend::Open);
        if !is_free || self.next_roof(face, id).is_some() {
            return 0.0;
        }
        let way = (b - a).normalize_or_zero();
        match way.x {
            // The ring is counter-clockwise, so the lower side runs along +s and the upper one along -s.
            x if x > 0.99 => OVER[0],
            x if x < -0.99 => 0.0,
            _ => OVER[1],
        }
    }

    /// How far a ridge's tiles stand over its end, a point in space: as far as tiles over verges. 0 where another edge
    /// between roofs begins (metres).
    pub fn ridge_overhang(&self, id: EdgeId, end: DVec3) -> f64 {
        let faces = self.edge(id).faces.into_iter().flatten();
        let walks = faces.flat_map(|face| self.face(face).loops.iter().flatten());
        let is_joined = |other: EdgeId| {
            let path = &self.edge(other).path;
            let touches = [0.0, path.length()].map(|at| path.point(at).distance(end) < ON);
            let mut faces = self.edge(other).faces.into_iter().flatten();
            other != id && touches.contains(&true) && faces.all(|face| self.is_roof(face))
        };
        let mut others = walks.map(|walk| walk.edge);
        if others.any(is_joined) { 0.0 } else { OVER[1] }
    }
}
