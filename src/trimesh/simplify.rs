//! Simplifies a surface. Cells are packed on the simpler one, and brought to the full one by a [`super::Search`]
//! (Itoh, Miyata, Shimada 2003, section 5).
//!
//! Garland, Heckbert (1997), Surface Simplification Using Quadric Error Metrics: edges collapse to a vertex one after
//! the other, each time the one of least cost. An edge may collapse only where the surface keeps its topology (its
//! ends have no common neighbours but those opposite it: Dey, Edelsbrunner, Guha, Nekhayev 1999) and where no triangle
//! turns over. Borders stay borders and keep their shape. Edges of equal cost go in the order of their vertices'
//! numbers.

mod postponed;

use self::postponed::PostponedEdges;
use super::{MeshBuilding, NONE, TriMesh};
use crate::solid::{Collapse, LENGTH, Quadric};
use glam::DVec3;
use std::sync::Arc;

/// Weight of the planes that stand upright on border edges, in squares of the edge's length.
const BORDER: f64 = 10.0;
/// The pull of a new vertex towards the middle of its edge, as parts of the weights; the second one is tried if the
/// first one fails.
const HOLDS: [f64; 2] = [1e-8, 1e-2];
/// The least cosine of the angle by which a triangle may turn.
const TURN: f64 = 0.3;
/// The least quality of a triangle (1 for an equilateral one), unless it was less before.
const LEAST_QUALITY: f64 = 0.15;
/// In a slice: triangles of the preparation, and triangles to look at while edges collapse.
const SLICE: usize = 1 << 13;
const LOOKED_AT: usize = 1 << 15;
/// The neighbours of a vertex with more triangles than this are found by sorting.
const MANY: u32 = 64;
/// The edges of a vertex with more triangles than this do not collapse: each collapse looks at all these triangles, so
/// a large fan would take time with the square of its size. The fan shrinks by its rim, whose shorter edges collapse.
const MOST_AROUND: u32 = 1 << 10;

/// A surface that is being simplified.
pub struct Simplifying {
    /// Coordinates are relative to the first vertex: sums about a near place lose fewer digits.
    origin: DVec3,
    collapse: Collapse,
    postponed: PostponedEdges,
    is_border: Vec<bool>,
    /// How many triangles each vertex has.
    degrees: Vec<u32>,
    stage: SimplifyingPhase,
    at: usize,
    left: usize,
    most: usize,
    /// The greatest mean square of the distances to the old planes that is allowed.
    limit: f64,
    mesh: Arc<TriMesh>,
    building: Option<MeshBuilding>,
}

#[derive(Clone, Copy, PartialEq)]
enum SimplifyingPhase {
    Copy,
    Weigh,
    Offer,
    Collapse,
    Build,
}

/// A removed triangle.
const GONE: [u32; 3] = [NONE; 3];

impl Simplifying {
    /// Simplifies until at most `most` triangles are left, or until each further collapse would move the surface by
    /// more than about `error`, in its units. `error` may be infinite.
    pub fn new(mesh: impl Into<Arc<TriMesh>>, most: usize, error: f64) -> Self {
        let mesh = mesh.into();
        Self {
            origin: mesh.positions().first().copied().unwrap_or_default(),
            collapse: Collapse::with_room(mesh.positions().len(), mesh.triangles().len()),
            postponed: PostponedEdges::default(),
            is_border: vec![false; mesh.positions().len()],
            degrees: vec![0; mesh.positions().len()],
            stage: SimplifyingPhase::Copy,
            at: 0,
            left: mesh.triangles().len(),
            most,
            limit: error * error,
            mesh,
            building: None,
        }
    }

    /// Does one more slice; returns the new surface when it is done.
    pub fn advance(&mut self) -> Option<TriMesh> {
        let count = self.collapse.triangles.len();
        let range = self.at..count.min(self.at + SLICE);
        match self.stage {
            SimplifyingPhase::Copy => {
                if self.copy() {
                    (self.stage, self.at) = (SimplifyingPhase::Weigh, 0);
                }
            }
            SimplifyingPhase::Weigh => {
                self.at = range.end;
                range.for_each(|t| self.weigh(t));
                if self.at == count {
                    (self.stage, self.at) = (SimplifyingPhase::Offer, 0);
                }
            }
            SimplifyingPhase::Offer => {
                self.at = range.end;
                range.for_each(|t| self.offer_edges(t));
                if self.at == count {
                    self.mesh = Arc::new(TriMesh::none());
                    self.stage = SimplifyingPhase::Collapse;
                }
            }
            SimplifyingPhase::Collapse => {
                let mut left = LOOKED_AT as i64;
                let mut goes_on = true;
                while goes_on && left > 0 {
                    goes_on = self.next(&mut left);
                }
                if !goes_on {
                    self.build();
                    self.stage = SimplifyingPhase::Build;
                }
            }
            // Collapses keep a mesh valid, so there is no fault.
            SimplifyingPhase::Build => return self.building.as_mut()?.advance()?.ok(),
        }
        None
    }

    /// Does all the work at once.
    pub fn finish(mut self) -> TriMesh {
        loop {
            if let Some(mesh) = self.advance() {
                return mesh;
            }
        }
    }

    /// Copies a slice of the vertices and triangles; true after the last one.
    fn copy(&mut self) -> bool {
        let (all, triangles) = (self.mesh.positions(), self.mesh.triangles());
        let end = self.at + SLICE;
        let places = &all[self.at.min(all.len())..end.min(all.len())];
        let places = places.iter().map(|&p| p - self.origin);
        let some = &triangles[self.at.min(triangles.len())..end.min(triangles.len())];
        self.collapse.extend(places, some);
        self.at = end;
        end >= all.len().max(triangles.len())
    }

    /// Adds the plane of a triangle to the quadrics of its corners, and upright planes along the border.
    fn weigh(&mut self, t: usize) {
        let triangle = self.collapse.triangles[t];
        let [a, b, c] = self.corners(triangle);
        let normal = self.mesh.face_normal(t as u32);
        let area = 0.5 * (b - a).cross(c - a).length();
        let quadric = Quadric::of_plane(normal, -normal.dot(a), area);
        self.collapse.weigh(t, &quadric);
        triangle.iter().for_each(|&v| self.degrees[v as usize] += 1);
        for (k, (from, to)) in [(a, b), (b, c), (c, a)].into_iter().enumerate() {
            if self.mesh.across(t as u32, k).is_some() {
                continue;
            }
            let across = (to - from).cross(normal).normalize_or_zero();
            let weight = BORDER * (to - from).length_squared();
            let quadric = Quadric::of_plane(across, -across.dot(from), weight);
            for v in [triangle[k], triangle[(k + 1) % 3]] {
                self.collapse.quadrics[v as usize].add(&quadric);
                self.is_border[v as usize] = true;
            }
        }
    }

    fn offer_edges(&mut self, t: usize) {
        let [a, b, c] = self.collapse.triangles[t];
        for (k, [from, to]) in [[a, b], [b, c], [c, a]].into_iter().enumerate() {
            // Offer an inner edge once, not from both of its triangles.
            if from < to || self.mesh.across(t as u32, k).is_none() {
                self.offer(from, to);
            }
        }
    }

    fn offer(&mut self, a: u32, b: u32) {
        let ends = [a.min(b), a.max(b)];
        let place = self.place(ends);
        let sum = self.sum(ends);
        if sum.at(place) > self.limit * sum.weight() {
            return;
        }
        let [p, q] = self.corners(ends);
        let cost = sum.at(place).max(0.0) + LENGTH * sum.weight() * (p - q).length_squared();
        self.postponed.offer(&mut self.collapse, ends, cost);
    }

    fn corners<const N: usize>(&self, which: [u32; N]) -> [DVec3; N] {
        which.map(|v| self.collapse.places[v as usize])
    }

    fn sum(&self, ends: [u32; 2]) -> Quadric {
        let quadrics = &self.collapse.quadrics;
        let mut sum = quadrics[ends[0] as usize];
        sum.add(&quadrics[ends[1] as usize]);
        sum
    }

    /// The place of the vertex that an edge becomes. If one end lies on the border, it is that end.
    fn place(&self, ends: [u32; 2]) -> DVec3 {
        let [p, q] = self.corners(ends);
        match ends.map(|v| self.is_border[v as usize]) {
            [true, false] => return p,
            [false, true] => return q,
            _ => {}
        }
        let middle = 0.5 * (p + q);
        let sum = self.sum(ends);
        // Nearly parallel planes meet far away: then the pull is made stronger, so that the vertex moves only across
        // them.
        let is_near = |place: &DVec3| (*place - middle).length_squared() < (p - q).length_squared();
        let lowest = HOLDS.map(|hold| sum.lowest(middle, hold));
        lowest.into_iter().find(is_near).unwrap_or(middle)
    }

    /// Collapses the next edge, if it may; false when there is nothing more to do. Subtracts from `left` about the
    /// number of triangles that it looks at.
    fn next(&mut self, left: &mut i64) -> bool {
        if self.left <= self.most.max(4) {
            return false;
        }
        let Some((ends, is_current)) = self.collapse.take() else {
            *left = 0;
            return self.postponed.refill(&mut self.collapse);
        };
        let degrees = ends.map(|v| self.degrees[v as usize]);
        *left -= 24;
        if !is_current || degrees[0] == 0 || degrees[0].max(degrees[1]) > MOST_AROUND {
            return true;
        }
        *left -= i64::from(degrees[0] + degrees[1]);
        let place = self.place(ends);
        if self.keeps_the_surface(ends) && self.keeps_upright(ends, place) {
            self.merge(ends, place);
        }
        true
    }

    /// The neighbours of a vertex.
    fn beside(&self, v: u32) -> Vec<u32> {
        if self.degrees[v as usize] > MANY {
            let corners = self.collapse.living(v).flat_map(|(_, triangle)| triangle);
            let mut all: Vec<u32> = corners.filter(|&w| w != v).collect();
            all.sort_unstable();
            all.dedup();
            return all;
        }
        let mut all: Vec<u32> = Vec::with_capacity(12);
        for (_, triangle) in self.collapse.living(v) {
            for w in triangle {
                if w != v && !all.contains(&w) {
                    all.push(w);
                }
            }
        }
        all
    }

    fn keeps_the_surface(&self, [a, b]: [u32; 2]) -> bool {
        let shared = self
            .collapse
            .living(a)
            .filter(|(_, t)| t.contains(&b))
            .count();
        let is_border = [a, b].map(|v| self.is_border[v as usize]);
        // The edge joins two borders, or two places of one border.
        if shared == 0 || (is_border == [true, true] && shared == 2) {
            return false;
        }
        let beside = self.beside(b);
        let is_sorted = self.degrees[b as usize] > MANY;
        let has = |v: &u32| match is_sorted {
            true => beside.binary_search(v).is_ok(),
            false => beside.contains(v),
        };
        let common: Vec<u32> = self.beside(a).into_iter().filter(has).collect();
        // The collapse takes a triangle from each of these.
        let has_enough =
            |&v: &u32| self.degrees[v as usize] >= if self.is_border[v as usize] { 2 } else { 4 };
        common.len() == shared && common.iter().all(has_enough)
    }

    fn keeps_upright(&self, [a, b]: [u32; 2], place: DVec3) -> bool {
        let fits = |v: u32, other: u32| {
            let mut rest = self.collapse.living(v).filter(|(_, t)| !t.contains(&other));
            rest.all(|(_, triangle)| {
                let (old, mut new) = (self.corners(triangle), self.corners(triangle));
                for (corner, w) in new.iter_mut().zip(triangle) {
                    if w == v {
                        *corner = place;
                    }
                }
                let [before, after] = [old, new].map(|[p, q, r]| (q - p).cross(r - p));
                let upright = before.dot(after) > TURN * before.length() * after.length();
                let quality = quality(new, after);
                upright && (quality > LEAST_QUALITY || quality > quality_of(old, before))
            })
        };
        fits(a, b) && fits(b, a)
    }

    fn merge(&mut self, [a, b]: [u32; 2], place: DVec3) {
        let shared = self.collapse.living(b).map(|(_, t)| t);
        let shared: Vec<[u32; 3]> = shared.filter(|t| t.contains(&a)).collect();
        shared
            .iter()
            .flatten()
            .for_each(|&v| self.degrees[v as usize] -= 1);
        self.degrees[a as usize] += std::mem::take(&mut self.degrees[b as usize]);
        self.left -= self.collapse.merge(b, a, GONE);
        // A large fan drops the removed triangles from its list each time that half of its triangles are gone.
        for &v in shared.iter().flatten().filter(|&&v| v != a && v != b) {
            let degree = self.degrees[v as usize];
            if degree >= MANY && degree.is_power_of_two() {
                self.collapse.tidy(v);
            }
        }
        self.collapse.places[a as usize] = place;
        self.is_border[a as usize] |= self.is_border[b as usize];
        for v in self.beside(a) {
            self.offer(v, a);
        }
    }

    fn build(&mut self) {
        let done = std::mem::replace(&mut self.collapse, Collapse::new(Vec::new(), Vec::new()));
        let (places, mut triangles) = (done.places, done.triangles);
        triangles.retain(|t| *t != GONE);
        let mut number = vec![NONE; places.len()];
        for &v in triangles.iter().flatten() {
            number[v as usize] = 0;
        }
        let mut positions = Vec::new();
        for (place, number) in places.into_iter().zip(&mut number) {
            if *number != NONE {
                *number = positions.len() as u32;
                positions.push(place + self.origin);
            }
        }
        let triangles = triangles.iter().map(|t| t.map(|v| number[v as usize]));
        self.building = Some(MeshBuilding::new(positions, triangles.collect()));
    }
}

/// Area divided by the sum of the squared sides, scaled to 1 for an equilateral triangle.
fn quality([p, q, r]: [DVec3; 3], across: DVec3) -> f64 {
    let sides = (q - p).length_squared() + (r - q).length_squared() + (p - r).length_squared();
    if sides == 0.0 {
        return 0.0;
    }
    2.0 * 3f64.sqrt() * across.length() / sides
}

/// The least quality for a triangle that replaces `old`: it may be a little worse than it was.
fn quality_of(old: [DVec3; 3], across: DVec3) -> f64 {
    0.9 * quality(old, across)
}

#[cfg(test)]
mod tests;
